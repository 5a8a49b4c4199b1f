//! Global options: threads, colours, quiet, standard input; completions and manual pages.

use crate::common::{carom, case, example, refusal, stdout, without_progress};
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// A command with this text on its standard input.
fn fed(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(input).unwrap();
    child.wait_with_output().unwrap()
}

/// What was told, but for lines of progress, which come on a slow machine.
fn stderr(output: &Output) -> String {
    without_progress(&String::from_utf8_lossy(&output.stderr))
}

#[test]
fn quiet_tells_errors_only() {
    let sweep = example("alumina_on_plane.toml");
    let told = carom(&["impact", &sweep, "--format", "csv"]);
    assert!(stderr(&told).starts_with("warning: "));
    for arguments in [["--quiet", "impact", &sweep], ["impact", "-q", &sweep]] {
        let quiet = carom(&[&arguments[..], &["--format", "csv"]].concat());
        assert!(quiet.status.success() && quiet.stderr.is_empty());
        assert_eq!(quiet.stdout, told.stdout);
    }
    let failed = carom(&["-q", "impact", "no/such.toml"]);
    assert_eq!(failed.status.code(), Some(1));
    assert!(stderr(&failed).starts_with("error: cannot read no/such.toml"));
}

#[test]
fn colours_come_when_asked_for() {
    let escape = "\u{1b}[";
    let sweep = example("alumina_on_plane.toml");
    // Not a terminal here.
    for choice in ["auto", "never"] {
        let output = carom(&["impact", &sweep, "--color", choice]);
        assert!(output.status.success() && !stderr(&output).contains(escape));
        assert!(!stdout(&["--color", choice, "impact", "--help"]).contains(escape));
    }
    let warned = carom(&["impact", &sweep, "--color", "always", "--format", "csv"]);
    let words = stderr(&warned);
    assert!(words.starts_with("\u{1b}[1m\u{1b}[33mwarning:\u{1b}[0m "));
    assert!(!String::from_utf8_lossy(&warned.stdout).contains(escape));
    assert!(stdout(&["--color=always", "impact", "--help"]).contains(escape));
    let failed = carom(&["--color", "always", "impact", "no/such.toml"]);
    assert!(stderr(&failed).starts_with("\u{1b}[1m\u{1b}[31merror:\u{1b}[0m "));
    let unknown = carom(&["impact", "--color", "always", "--nonsense"]);
    assert!(unknown.status.code() == Some(2) && stderr(&unknown).contains(escape));
    refusal(&["--color", "mauve", "impact", &sweep]);
}

#[test]
fn lines_of_progress_are_left_out_with_colours_and_without() {
    let coloured = "\u{1b}[1m\u{1b}[36mprogress:\u{1b}[0m computing impacts for 2 s\n";
    let told = format!("progress: computing impacts for 2 s\nwarning: far\n{coloured}note\n");
    assert_eq!(without_progress(&told), "warning: far\nnote\n");
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let map = ["restitution", "--kappa", "1:1.5:20", "--lambda", "0.1:8:40", "--format", "csv"];
    let all = stdout(&map);
    for threads in ["1", "2", "7"] {
        assert_eq!(stdout(&[&map[..], &["--threads", threads]].concat()), all);
    }
    let sweep = example("alumina_on_plane.toml");
    let impacts = stdout(&["impact", &sweep, "--format", "json"]);
    assert_eq!(stdout(&["--threads", "3", "impact", &sweep, "--format", "json"]), impacts);
    for count in ["0", "-1", "1025", "many"] {
        refusal(&["impact", &sweep, "--threads", count]);
    }
}

/// Held up by a full pipe, it has its threads and the one it began with.
#[test]
#[cfg(target_os = "linux")]
fn it_has_as_many_threads_as_were_asked_for() {
    use std::io::Read as _;
    for threads in [1, 3] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
            .args(["restitution", "--kappa", "1:1.5:600", "--lambda", "0.1:8:600"])
            // Quiet: without the sleeping thread that tells of progress.
            .args(["--quiet", "--format", "csv", "--threads", &threads.to_string()])
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut out = child.stdout.take().unwrap();
        // The first rows are there, and there are more of them than are held: all threads are.
        out.read_exact(&mut [0; 100]).unwrap();
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
        let count = status.lines().find_map(|line| line.strip_prefix("Threads:")).unwrap();
        assert_eq!(count.trim(), (threads + 1).to_string());
        drop(out);
        assert!(child.wait().unwrap().success());
    }
}

#[test]
fn a_case_may_come_on_standard_input() {
    for (command, name) in [
        ("impact", "steel_balls.toml"),
        ("hertz", "hertz_lens.toml"),
        ("scene", "scene_book.toml"),
        ("solve", "solve_hertz.toml"),
        ("stress", "stress_ball.toml"),
    ] {
        let path = example(name);
        let text = std::fs::read(&path).unwrap();
        let output = fed(&[command, "-", "--format", "json"], &text);
        assert!(output.status.success(), "{name}: {}", stderr(&output));
        assert_eq!(
            String::from_utf8(output.stdout).unwrap(),
            stdout(&[command, &path, "--format", "json"])
        );
    }
    let begun = stdout(&["new", "history"]);
    let checked = fed(&["check", "-"], begun.as_bytes());
    assert!(String::from_utf8_lossy(&checked.stdout).starts_with("a case for `carom history`"));
    let bad = fed(&["impact", "-"], b"[body_1]\nradius = -1\n");
    assert!(
        bad.status.code() == Some(2) && stderr(&bad).starts_with("error: -: "),
        "{}",
        stderr(&bad)
    );
    let no_text = fed(&["impact", "-"], b"\xff\xfe");
    assert!(stderr(&no_text).contains("-: byte 1 is not UTF-8 text"));
    let long = fed(&["check", "-"], &vec![b'#'; (1 << 20) + 1]);
    assert!(stderr(&long).contains("the file is larger"), "{}", stderr(&long));
}

#[test]
fn a_picture_may_go_on_from_a_case_that_came() {
    let text = std::fs::read(example("steel_balls.toml")).unwrap();
    let output = fed(&["impact", "-", "--format", "none", "--plot", "-"], &text);
    assert!(output.status.success() && output.stdout.starts_with(b"<svg"));
}

#[test]
#[cfg(unix)]
fn what_standard_input_comes_from_is_no_place_for_a_picture() {
    let text = std::fs::read_to_string(example("steel_balls.toml")).unwrap();
    let path = case("from_input.svg", &text);
    let output = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["impact", "-", "--plot", &path])
        .stdin(std::fs::File::open(&path).unwrap())
        .output()
        .unwrap();
    assert!(stderr(&output).contains("this is an input of the same run"), "{}", stderr(&output));
    assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
}

#[test]
fn files_of_a_case_on_standard_input_lie_in_the_present_folder() {
    let path = example("history_twist.toml");
    let text = std::fs::read(&path).unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["history", "-", "--format", "csv"])
        .current_dir(Path::new(&path).parent().unwrap())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(&text).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(
        String::from_utf8(output.stdout).unwrap(),
        stdout(&["history", &path, "--format", "csv"])
    );
}

const SHELLS: [&str; 5] = ["bash", "elvish", "fish", "powershell", "zsh"];

#[test]
fn shells_are_told_every_command_and_option() {
    for shell in SHELLS {
        let script = stdout(&["completions", shell]);
        for word in ["impact", "restitution", "completions", "tractions", "threads"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    refusal(&["completions", "csh"]);
}

/// Where there is a bash, it completes.
#[test]
#[cfg(unix)]
fn bash_completes_commands_options_and_values() {
    if Command::new("bash").arg("--version").output().is_err() {
        return;
    }
    let script = stdout(&["completions", "bash"]);
    let completed = |words: &[&str]| {
        let line = words.iter().map(|word| format!("'{word}'")).collect::<Vec<_>>().join(" ");
        let (last, before) = (words[words.len() - 1], words[words.len() - 2]);
        let ask = format!(
            "{script}\nCOMP_WORDS=({line}); COMP_CWORD={}\n_carom carom '{last}' '{before}'\n\
             printf '%s\\n' \"${{COMPREPLY[@]}}\"",
            words.len() - 1
        );
        let output = Command::new("bash").args(["--norc", "-c", &ask]).output().unwrap();
        assert!(output.status.success(), "{}", stderr(&output));
        let text = String::from_utf8(output.stdout).unwrap();
        text.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(completed(&["carom", "rest"]), ["restitution"]);
    assert_eq!(completed(&["carom", "history", "--tr"]), ["--tractions"]);
    assert_eq!(completed(&["carom", "impact", "--format", "js"]), ["json"]);
    assert_eq!(completed(&["carom", "schema", "so"]), ["solve"]);
    assert_eq!(completed(&["carom", "--color", "al"]), ["always"]);
}

#[test]
fn every_command_has_a_manual_page() {
    let page = stdout(&["man"]);
    assert!(page.contains(".TH carom 1") && page.contains("Elastic impact with friction"));
    for command in ["impact", "solve", "completions", "man"] {
        let page = stdout(&["man", command]);
        assert!(page.contains(&format!("carom\\-{command}")), "{page}");
        assert!(page.contains("\\-\\-threads"), "{page}");
    }
    assert!(stdout(&["man", "history"]).contains("\\-\\-tractions"));
    refusal(&["man", "nothing"]);
    // Where there is a groff, it has nothing to say against them.
    for command in ["impact", "restitution", "solve"] {
        let page = stdout(&["man", command]);
        let path = case(&format!("{command}.1"), &page);
        if let Ok(output) =
            Command::new("groff").args(["-man", "-Tutf8", "-ww", "-z", &path]).output()
        {
            assert!(output.stderr.is_empty(), "{command}: {}", stderr(&output));
        }
    }
}

#[test]
fn the_course_of_an_impact_with_loss_says_that_it_is_elastic() {
    let rubber = std::fs::read_to_string(example("rubber_on_table.toml")).unwrap();
    let losing = rubber.replacen("friction = 0.3", "friction = 0.3\nnormal_restitution = 0.5", 1);
    assert_ne!(rubber, losing);
    for (name, text, is_told) in [("losing.toml", losing, true), ("elastic.toml", rubber, false)] {
        let case = case(name, &text);
        for asked in [&["--history", "5"][..], &["--plot", "-", "--format", "none"]] {
            let output = carom(&[&["impact", &case], asked].concat());
            let told = stderr(&output);
            assert_eq!(told.contains("are those of elastic bodies"), is_told, "{told}");
        }
        let output = carom(&["impact", &case]);
        assert!(!stderr(&output).contains("elastic bodies"));
    }
}

/// A case that comes slowly keeps the command at work.
#[test]
fn what_takes_longer_than_two_seconds_tells_so_in_a_log() {
    let input = std::fs::read(example("steel_balls.toml")).unwrap();
    let slowly = |quiet: &[&str]| {
        let is_told = quiet.is_empty();
        let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
            .args([quiet, &["impact", "-"]].concat())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut told = String::new();
        let mut stderr = BufReader::new(child.stderr.take().unwrap());
        if is_told {
            // Waits for the line, however long it takes.
            stderr.read_line(&mut told).unwrap();
        } else {
            std::thread::sleep(std::time::Duration::from_secs(3));
        }
        child.stdin.take().unwrap().write_all(&input).unwrap();
        stderr.read_to_string(&mut told).unwrap();
        assert!(child.wait_with_output().unwrap().status.success());
        told
    };
    let told = slowly(&[]);
    let seconds = told
        .strip_prefix("progress: computing impacts for ")
        .and_then(|rest| rest.split_once(" s\n"));
    assert!(seconds.unwrap().0.parse::<u32>().unwrap() >= 2, "{told}");
    assert_eq!(slowly(&["--quiet"]), "");
}
