//! The folder of `--keep` belongs to one case and one run at a time, whatever it contains.
#![cfg(unix)]

use crate::common;

use crate::common::{carom, case, contents, example, folder, limited, refusal, stdout};
use std::fs::File;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};

/// Of the processor: enough for what is refused, too few for what begins.
const FEW_SECONDS: &str = "ulimit -t 5";
/// A number that no process has: beyond the greatest of the system.
const DEAD: u32 = 4_194_999;

fn solve(case: &str, kept: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(["solve", case, "--format", "csv", "--keep"]).arg(kept).args(more);
    command
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn refused(case: &str, kept: &Path, words: &str) {
    let before = contents(kept);
    for more in [&[][..], &["--resume"]] {
        let output = solve(case, kept, more).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        if more == ["--resume"] {
            assert!(said(&output).contains(words), "{}", said(&output));
        }
        assert!(output.stdout.is_empty() && contents(kept) == before);
    }
}

fn step(number: usize) -> String {
    format!("step-{number:06}.npz")
}

/// The number of the case that a step belongs to.
fn stamp(path: &Path) -> [u8; 8] {
    let bytes = std::fs::read(path).unwrap();
    let at = bytes.windows(8).position(|word| word == b"case.npy").unwrap();
    let head = bytes[at..].iter().position(|byte| *byte == b'\n').unwrap();
    bytes[at + head + 1..at + head + 9].try_into().unwrap()
}

#[test]
fn of_two_cases_at_once_in_one_folder_one_is_refused_and_none_is_lost() {
    let cases = [example("solve_torsion_with_shift.toml"), example("solve_cattaneo_loop.toml")];
    for _ in 0..3 {
        let kept = folder();
        let start = |case: &String| -> Child {
            let mut command = solve(case, &kept, &[]);
            command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
        };
        let runs = cases.each_ref().map(start);
        let outputs = runs.map(|run| run.wait_with_output().unwrap());
        let winners = [0, 1].map(|i| outputs[i].status.success());
        assert!(winners[0] != winners[1], "{} {}", said(&outputs[0]), said(&outputs[1]));
        let winner = usize::from(winners[1]);
        let loser = &outputs[1 - winner];
        assert_eq!(loser.status.code(), Some(2), "{}", said(loser));
        // All steps are of one case, and the run can be taken up.
        let steps = contents(&kept).into_iter().filter(|(name, _)| name.ends_with(".npz"));
        let stamps: Vec<_> = steps.map(|(name, _)| stamp(&kept.join(name))).collect();
        assert!(stamps.len() >= 9 && stamps.iter().all(|stamp| *stamp == stamps[0]));
        let resumed = solve(&cases[winner], &kept, &["--resume"]).output().unwrap();
        assert!(resumed.status.success() && resumed.stdout == outputs[winner].stdout);
    }
}

#[test]
fn a_folder_in_which_a_run_is_at_work_is_refused() {
    let kept = folder();
    let case = example("solve_torsion_with_shift.toml");
    stdout(&["solve", &case, "--format", "none", "--keep", kept.to_str().unwrap()]);
    // A run at work holds the lock.
    let lock = File::options().write(true).open(kept.join("carom-kept.lock")).unwrap();
    lock.lock().unwrap();
    let output = solve(&case, &kept, &["--resume"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("another run is using this folder"), "{}", said(&output));
    drop(lock);
    assert!(solve(&case, &kept, &["--resume"]).output().unwrap().status.success());
}

#[test]
fn a_folder_without_a_manifest_is_refused_unless_it_is_empty() {
    let case = example("solve_hertz.toml");
    for name in [&step(1), "loads.csv", "notes.txt", ".hidden", "step-000099.npz"] {
        let kept = folder();
        std::fs::write(kept.join(name), "a stranger's").unwrap();
        refused(&case, &kept, "no manifest of carom");
    }
    // The folder of an earlier version: steps, but no manifest.
    let kept = folder();
    let name = kept.to_str().unwrap();
    stdout(&["solve", &case, "--keep", name]);
    std::fs::remove_file(kept.join("carom-kept.txt")).unwrap();
    refused(&case, &kept, "no manifest of carom");
    let kept = folder();
    assert!(solve(&case, &kept, &["--resume"]).output().unwrap().status.success());
}

#[test]
fn what_a_stranger_puts_into_a_kept_folder_is_not_replaced() {
    let case = example("solve_hertz.toml");
    let kept = folder();
    let whole = stdout(&["solve", &case, "--format", "csv", "--keep", kept.to_str().unwrap()]);
    // The last two of four steps are lost, and something else has their names.
    let remove = |name: &str| std::fs::remove_file(kept.join(name)).unwrap();
    remove(&step(3));
    refused(&case, &kept, "step 3 is missing before this one");
    remove(&step(4));
    let loads = std::fs::read(kept.join("loads.csv")).unwrap();
    std::fs::write(kept.join("loads.csv"), "a,b\n1,2\n").unwrap();
    refused(&case, &kept, "not the table of loads of this run");
    std::fs::write(kept.join("loads.csv"), loads).unwrap();
    std::fs::write(kept.join(step(3)), "a stranger's").unwrap();
    refused(&case, &kept, "not a step of carom, or it is damaged");
    remove(&step(3));
    std::fs::write(kept.join("carom-kept.txt"), "a stranger's").unwrap();
    refused(&case, &kept, "not a manifest of carom");
    remove("carom-kept.txt");
    // Other files there are left alone.
    let kept = folder();
    let first = solve(&case, &kept, &[]).output().unwrap();
    assert!(first.status.success());
    std::fs::write(kept.join("notes.txt"), "mine").unwrap();
    std::fs::remove_file(kept.join(step(4))).unwrap();
    let resumed = solve(&case, &kept, &["--resume"]).output().unwrap();
    assert_eq!(String::from_utf8(resumed.stdout).unwrap(), whole);
    assert_eq!(std::fs::read(kept.join("notes.txt")).unwrap(), b"mine");
}

#[test]
fn a_step_that_cannot_be_read_is_an_error_and_not_the_end_of_the_steps() {
    let case = example("solve_hertz.toml");
    let whole = folder();
    stdout(&["solve", &case, "--keep", whole.to_str().unwrap()]);
    let spoilt = |spoil: &dyn Fn(&Path)| {
        let kept = folder();
        for (name, bytes) in contents(&whole) {
            std::fs::write(kept.join(name), bytes).unwrap();
        }
        std::fs::remove_file(kept.join(step(3))).unwrap();
        spoil(&kept.join(step(3)));
        kept
    };
    let refused = |kept: &Path, words: &str| {
        let kept = kept.to_str().unwrap();
        let output = limited(FEW_SECONDS, &["solve", &case, "--keep", kept, "--resume"]);
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains(words), "{}", said(&output));
    };
    let pipe = |path: &Path| {
        assert!(Command::new("mkfifo").arg(path).status().unwrap().success());
    };
    refused(&spoilt(&pipe), "this is not a file of carom");
    refused(&spoilt(&|path| symlink("/dev/zero", path).unwrap()), "this is not a file of carom");
    refused(&spoilt(&|path| symlink(path, path).unwrap()), "this is not a file of carom");
    refused(&spoilt(&|path| std::fs::create_dir(path).unwrap()), "this is not a file of carom");
    // A hole of a terabyte is read no further than a step may be long.
    let hole = |path: &Path| File::create(path).unwrap().set_len(1 << 40).unwrap();
    refused(&spoilt(&hole), "the file is larger");
    refused(
        &spoilt(&|path| std::fs::write(path, "").unwrap()),
        "not a step of carom, or it is damaged",
    );
}

#[test]
fn a_file_that_gives_a_read_error_is_an_error() {
    let heights = case("mem.toml", &common::rough("/proc/self/mem"));
    let output = carom(&["solve", &heights]);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert!(said(&output).contains("cannot read /proc/self/mem"), "{}", said(&output));
}

#[test]
fn pipes_and_devices_are_refused_before_they_are_opened() {
    let own = folder();
    let pipe = own.join("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let pipe = pipe.to_str().unwrap();
    for (path, words) in [(pipe, "this is a pipe"), ("/dev/zero", "this is a device")] {
        let text = std::fs::read_to_string(example("history_twist.toml")).unwrap();
        let steps = case("pipe-steps.toml", &text.replace("history_twist.csv", path));
        let heights = case("pipe-heights.toml", &common::rough(path));
        for arguments in [
            ["impact", path],
            ["solve", path],
            ["compare", path],
            ["check", path],
            ["history", &steps],
            ["check", &steps],
            ["solve", &heights],
            ["check", &heights],
        ] {
            let said = refusal(&arguments);
            assert!(said.contains(words), "{arguments:?}: {said}");
        }
    }
}

#[test]
fn what_killed_runs_left_half_written_is_removed_and_nothing_else() {
    let own = std::process::id();
    let case = example("solve_hertz.toml");
    let kept = folder();
    let put = |folder: &Path, name: &str| std::fs::write(folder.join(name), "half").unwrap();
    stdout(&["solve", &case, "--keep", kept.to_str().unwrap()]);
    let dead = [format!(".step-000003.npz.{DEAD}.carom"), format!(".loads.csv.{DEAD}.carom")];
    let live = [
        format!(".step-000003.npz.{own}.carom"),
        format!(".notes.{DEAD}.carom"),
        format!(".step-000003.npz.{DEAD}"),
        format!(".step-000003.npz.{DEAD}.carom.carom"),
    ];
    dead.iter().chain(&live).for_each(|name| put(&kept, name));
    assert!(solve(&case, &kept, &["--resume"]).output().unwrap().status.success());
    let is_there = |folder: &Path, name: &str| folder.join(name).exists();
    assert!(dead.iter().all(|name| !is_there(&kept, name)));
    assert!(live.iter().all(|name| is_there(&kept, name)));
    // Beside a picture as well; one that is locked is being written.
    let plain = folder();
    let (left, locked) = (format!(".u.png.{DEAD}.carom"), format!(".u.png.{}.carom", DEAD + 1));
    [&left, &locked].iter().for_each(|name| put(&plain, name));
    let lock = File::open(plain.join(&locked)).unwrap();
    lock.lock().unwrap();
    let picture = plain.join("u.png");
    // So is one of a process that has ended, but that nobody has waited for.
    let mut ended = Command::new("true").spawn().unwrap();
    let state = || std::fs::read_to_string(format!("/proc/{}/stat", ended.id())).unwrap();
    while !state().contains(") Z ") {
        std::thread::yield_now();
    }
    let unawaited = format!(".u.png.{}.carom", ended.id());
    put(&plain, &unawaited);
    stdout(&["impact", &example("steel_balls.toml"), "--plot", picture.to_str().unwrap()]);
    assert!(!is_there(&plain, &unawaited));
    ended.wait().unwrap();
    assert!(!is_there(&plain, &left) && is_there(&plain, &locked) && picture.exists());
}

#[test]
fn an_input_with_the_name_of_a_half_written_picture_is_not_removed() {
    let own = folder();
    let name = format!(".x.svg.{DEAD}.carom");
    std::fs::write(own.join(&name), common::heights()).unwrap();
    symlink(&name, own.join("link.csv")).unwrap();
    for heights in [&name, "link.csv"] {
        std::fs::write(own.join("case.toml"), common::rough(heights)).unwrap();
        let before = contents(&own);
        let mut run = Command::new(env!("CARGO_BIN_EXE_carom"));
        run.args(["solve", "case.toml", "--plot", "x.svg"]).current_dir(&own);
        let output = run.output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        assert!(said(&output).contains("rename it"), "{}", said(&output));
        assert!(contents(&own) == before);
    }
}

#[test]
fn a_run_that_ends_while_it_writes_leaves_nothing_that_stays() {
    let case = example("solve_torsion_with_shift.toml");
    let kept = folder();
    let text = stdout(&["solve", &case, "--format", "csv"]);
    let halves = || contents(&kept).iter().filter(|(name, _)| name.starts_with('.')).count();
    // No file may be larger than 20 blocks.
    let output = limited("ulimit -f 20", &["solve", &case, "--keep", kept.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert!(said(&output).contains("cannot write"), "{}", said(&output));
    assert_eq!(halves(), 0);
    // A process that was killed, whose number no other has, left half a file.
    std::fs::write(kept.join(".step-000001.npz.4194304.carom"), "half").unwrap();
    assert_eq!(halves(), 1);
    let resumed = solve(&case, &kept, &["--resume"]).output().unwrap();
    assert_eq!(String::from_utf8(resumed.stdout).unwrap(), text);
    assert_eq!(halves(), 0);
}

#[test]
fn a_folder_that_is_refused_is_refused_before_anything_is_computed() {
    // Minutes of work, if it began.
    let text = common::rough("heights.csv").replace("cells = [8, 8]", "cells = [700, 700]");
    let text = text.replace("shape = \"heights\"", "shape = \"sphere\"");
    let text = text.lines().filter(|line| !line.starts_with("file") && !line.starts_with("scale"));
    let long = case("long.toml", &text.collect::<Vec<_>>().join("\n"));
    let kept = folder();
    std::fs::write(kept.join("loads.csv"), "a stranger's").unwrap();
    let output = limited(FEW_SECONDS, &["solve", &long, "--keep", kept.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
}

/// What a saved step is told apart by: its place in the history and every number that it holds.
#[test]
fn steps_that_were_exchanged_changed_or_added_are_refused() {
    let (case, kept) = (example("solve_torsion_with_shift.toml"), folder());
    let kept = kept.to_str().unwrap();
    let resumed = ["solve", &case, "--keep", kept, "--resume"];
    assert!(carom(&resumed).status.success());
    let step = |number: usize| Path::new(kept).join(format!("step-{number:06}.npz"));
    let whole: Vec<_> = (1..=9).map(|number| std::fs::read(step(number)).unwrap()).collect();
    let refused = |number: usize, bytes: &[u8], text: &str| {
        std::fs::write(step(number), bytes).unwrap();
        let said = refusal(&resumed);
        assert!(said.contains(text), "{said}");
        match whole.get(number - 1) {
            Some(bytes) => std::fs::write(step(number), bytes).unwrap(),
            None => std::fs::remove_file(step(number)).unwrap(),
        }
    };
    refused(3, &whole[4], "another step");
    refused(10, &whole[8], "no step 10");
    // A traction of the last step, doubled, and the same numbers in another order of bytes.
    let mut changed = zip::ZipArchive::new(std::io::Cursor::new(whole[8].clone())).unwrap();
    let mut again = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    for i in 0..changed.len() {
        let mut file = changed.by_index(i).unwrap();
        let name = file.name().unwrap().to_string();
        let mut bytes = Vec::new();
        std::io::Read::read_to_end(&mut file, &mut bytes).unwrap();
        if name == "traction_x.npy" {
            let at = bytes.len() - 8 * (bytes.len() / 16) + 7;
            bytes[at] ^= 0x80;
        }
        again.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        std::io::Write::write_all(&mut again, &bytes).unwrap();
    }
    refused(9, &again.finish().unwrap().into_inner(), "were changed");
    assert!(carom(&resumed).status.success());
}
