//! Every input of every command with every output, by every way to write a path: none is overwritten.
#![cfg(unix)]

use crate::common;

use crate::common::{contents, example, folder};
use std::fs::File;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

/// An input that an output is aimed at.
struct Target {
    /// What a user would call it.
    what: &'static str,
    command: &'static str,
    /// The case, as it is called on the command line.
    case: &'static str,
    /// The input that is aimed at.
    input: &'static str,
    option: &'static str,
}

const fn target(what: &'static str, [command, case, input, option]: [&'static str; 4]) -> Target {
    Target { what, command, case, input, option }
}

const TARGETS: [Target; 16] = [
    target("impact", ["impact", "impact.svg", "impact.svg", "--plot"]),
    target("impact as pixels", ["impact", "impact.PNG", "impact.PNG", "--plot"]),
    target("impact that moves", ["impact", "impact.svg", "impact.svg", "--animate"]),
    target("pressed contact", ["hertz", "hertz.svg", "hertz.svg", "--plot"]),
    target("history", ["history", "history.svg", "history.svg", "--plot"]),
    target("steps of a history", ["history", "history.svg", "steps.svg", "--plot"]),
    target("scene", ["scene", "scene.svg", "scene.svg", "--plot"]),
    target("contact on a grid", ["solve", "solve.svg", "solve.svg", "--plot"]),
    target("heights as a table", ["solve", "solve.svg", "heights.svg", "--plot"]),
    target("heights as a picture", ["solve", "greys.toml", "heights.png", "--plot"]),
    target("rolling contact", ["roll", "roll.svg", "roll.svg", "--plot"]),
    target("stresses", ["stress", "stress.svg", "stress.svg", "--plot"]),
    target("stresses as arrays", ["stress", "stress.npz", "stress.npz", "--field"]),
    target("stresses as a grid", ["stress", "stress.vtk", "stress.vtk", "--field"]),
    target("heights of a case in a folder", ["solve", "sub/case.toml", "sub/h.svg", "--plot"]),
    target("steps of a case in a folder", ["history", "sub/steps.toml", "sub/s.svg", "--plot"]),
];

/// All inputs in a folder.
fn write_inputs(folder: &Path) {
    let text = |name: &str| std::fs::read_to_string(example(name)).unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    std::fs::create_dir(folder.join("sub")).unwrap();
    write("impact.svg", &text("steel_balls.toml"));
    write("impact.PNG", &text("steel_balls.toml"));
    write("hertz.svg", &text("hertz_crossed_cylinders.toml"));
    write("scene.svg", &text("scene_superball.toml"));
    write("roll.svg", &text("roll_from_rest.toml"));
    for ending in ["svg", "npz", "vtk"] {
        write(&format!("stress.{ending}"), &text("stress_ball.toml"));
    }
    let history = text("history_twist.toml");
    write("history.svg", &history.replace("history_twist.csv", "steps.svg"));
    write("sub/steps.toml", &history.replace("history_twist.csv", "s.svg"));
    for steps in ["steps.svg", "sub/s.svg"] {
        write(steps, &text("history_twist.csv"));
    }
    for (case, heights) in [
        ("solve.svg", "heights.svg"),
        ("greys.toml", "heights.png"),
        ("kept.toml", "heights.csv"),
        ("sub/case.toml", "h.svg"),
    ] {
        write(case, &common::rough(heights));
    }
    for heights in ["heights.svg", "heights.csv", "sub/h.svg"] {
        write(heights, &common::heights());
    }
    std::fs::write(folder.join("heights.png"), common::grey_heights()).unwrap();
}

/// Ways to write the name of the file `input` of the folder, made where they must be: what each is
/// called, and the name.
fn ways(folder: &Path, input: &str) -> Vec<(&'static str, String)> {
    let own = folder.file_name().unwrap().to_str().unwrap();
    let (path, ways) = (folder.join(input), folder.join("ways"));
    let _ = std::fs::remove_dir_all(&ways);
    std::fs::create_dir(&ways).unwrap();
    let ending = path.extension().unwrap().to_str().unwrap();
    let name = |way: &str| format!("ways/{way}.{ending}");
    let at = |way: &str| folder.join(name(way));
    symlink(&path, at("link")).unwrap();
    symlink(format!("../{input}"), at("relative")).unwrap();
    symlink(at("link"), at("chain")).unwrap();
    std::fs::hard_link(&path, at("hard")).unwrap();
    symlink(at("hard"), at("hard-link")).unwrap();
    symlink(folder, ways.join("folder")).unwrap();
    let absolute = path.to_str().unwrap();
    vec![
        ("plain", input.to_owned()),
        ("dot", format!("./{input}")),
        ("dots", format!("././/{input}")),
        ("up and down", format!("../{own}/{input}")),
        ("down and up", format!("sub/../{input}")),
        ("absolute", absolute.to_owned()),
        ("two slashes", format!("/{absolute}")),
        ("through the system", format!("/proc/self/cwd/{input}")),
        ("link", name("link")),
        ("relative link", name("relative")),
        ("chain of links", name("chain")),
        ("hard link", name("hard")),
        ("link to a hard link", name("hard-link")),
        ("linked folder", format!("ways/folder/{input}")),
    ]
}

/// A run that must be refused, and leave all files as they are.
fn attempt(folder: &Path, mut command: Command, what: &str) {
    let before = contents(folder);
    let output = command.current_dir(folder).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{what}: {said}");
    let is_clear = ["input of the same run", "goes to this input", "goes to the same file"];
    assert!(is_clear.iter().any(|words| said.contains(words)) || said.is_empty(), "{what}: {said}");
    assert!(contents(folder) == before, "{what}: a file changed");
}

fn carom(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(arguments);
    command
}

#[test]
fn no_picture_or_field_replaces_an_input_by_any_name() {
    let folder = folder();
    write_inputs(&folder);
    let mut count = 0;
    for Target { what, command, case, input, option } in TARGETS {
        // The runs would succeed but for the output.
        let output = carom(&[command, case, "--format", "none"]).current_dir(&folder).output();
        let output = output.unwrap();
        assert!(output.status.success(), "{what}: {}", String::from_utf8_lossy(&output.stderr));
        for (way, name) in ways(&folder, input) {
            let run = carom(&[command, case, option, &name]);
            attempt(&folder, run, &format!("{what} by {way}"));
            count += 1;
        }
        // The case by another name, or on standard input.
        if case == input {
            for (way, name) in ways(&folder, input) {
                let run = carom(&[command, &name, option, input]);
                attempt(&folder, run, &format!("{what} read by {way}"));
                count += 1;
            }
            let mut run = carom(&[command, "-", option, input]);
            run.stdin(File::open(folder.join(input)).unwrap());
            attempt(&folder, run, &format!("{what} from standard input"));
            count += 1;
        }
    }
    assert!(count >= 300, "{count}");
}

#[test]
fn no_stream_is_appended_to_an_input() {
    let folder = folder();
    write_inputs(&folder);
    let inputs = TARGETS.iter().map(|target| (target.command, target.case, target.input));
    let others = [
        ("compare", "solve.svg", "solve.svg"),
        ("compare", "solve.svg", "heights.svg"),
        ("check", "solve.svg", "heights.svg"),
        ("check", "history.svg", "steps.svg"),
        ("check", "scene.svg", "scene.svg"),
    ];
    let mut count = 0;
    for (command, case, input) in inputs.chain(others) {
        let append = || File::options().append(true).open(folder.join(input)).unwrap();
        for is_output in [true, false] {
            let mut run = carom(&[command, case]);
            let run_to = if is_output { run.stdout(append()) } else { run.stderr(append()) };
            let before = contents(&folder);
            let output = run_to.current_dir(&*folder).output().unwrap();
            assert_eq!(output.status.code(), Some(2), "{command} {case} appended to {input}");
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            let words = "standard output goes to this input";
            assert!(!is_output || said.contains(words), "{command} {case}: {said}");
            assert!(contents(&folder) == before, "{command} {case} appended to {input}");
            count += 1;
        }
    }
    assert!(count >= 40, "{count}");
}

#[test]
fn no_kept_step_replaces_an_input_by_any_name_of_the_folder() {
    let folder = folder();
    write_inputs(&folder);
    let own = folder.file_name().unwrap().to_str().unwrap().to_owned();
    let links = folder.join("links");
    std::fs::create_dir(&links).unwrap();
    symlink(&*folder, links.join("all")).unwrap();
    let mut count = 0;
    // The names that a kept folder has, and one that it has not.
    let names = ["loads.csv", "step-000001.npz", "step-000002.npz", "carom-kept.txt", "other"];
    for name in names {
        for is_case in [true, false] {
            let (case, heights) = if is_case { (name, "heights.csv") } else { ("k.toml", name) };
            let put = |name: &str, text: String| std::fs::write(folder.join(name), text).unwrap();
            put(case, common::rough(heights));
            put(heights, common::heights());
            let absolute = folder.to_str().unwrap();
            for kept in [".", "./", absolute, &format!("../{own}"), "links/all", "sub/.."] {
                for more in [&[][..], &["--resume"]] {
                    let run = carom(&[&["solve", case, "--keep", kept][..], more].concat());
                    attempt(&folder, run, &format!("{case} with {heights} kept in {kept}"));
                    count += 1;
                }
            }
            // The input lies elsewhere and has another name in the folder.
            let kept = folder.join("kept");
            for is_hard in [true, false] {
                let _ = std::fs::remove_dir_all(&kept);
                std::fs::create_dir(&kept).unwrap();
                match is_hard {
                    true => std::fs::hard_link(folder.join(name), kept.join(name)).unwrap(),
                    false => symlink(folder.join(name), kept.join(name)).unwrap(),
                }
                let run = carom(&["solve", case, "--keep", "kept"]);
                attempt(&folder, run, &format!("{case} with {heights}, hard: {is_hard}"));
                count += 1;
            }
            let _ = std::fs::remove_dir_all(&kept);
            for name in [name, "k.toml"] {
                let _ = std::fs::remove_file(folder.join(name));
            }
        }
    }
    assert!(count >= 100, "{count}");
}

#[test]
fn two_outputs_of_a_run_on_one_file_are_refused_before_it() {
    let folder = folder();
    write_inputs(&folder);
    std::fs::create_dir(folder.join("out")).unwrap();
    let out = |name: &str| -> PathBuf { folder.join("out").join(name) };
    std::fs::write(out("x.svg"), "what was there").unwrap();
    symlink("x.svg", out("y.npz")).unwrap();
    symlink("new.svg", out("z.npz")).unwrap();
    std::fs::hard_link(out("x.svg"), out("w.npz")).unwrap();
    symlink("../out", out("again")).unwrap();
    for (field, plot) in [
        ("out/y.npz", "out/x.svg"),
        ("out/w.npz", "out/x.svg"),
        // One that is not there yet.
        ("out/z.npz", "out/new.svg"),
        ("out/z.npz", "out/again/new.svg"),
        ("out/again/z.npz", "./out/../out/new.svg"),
    ] {
        let run = carom(&["stress", "stress.svg", "--field", field, "--plot", plot]);
        attempt(&folder, run, &format!("{field} and {plot}"));
    }
    for stream in ["output", "error"] {
        let file = File::options().append(true).open(out("x.svg")).unwrap();
        let mut run = carom(&["stress", "stress.svg", "--plot", "out/x.svg"]);
        if stream == "output" {
            run.stdout(file)
        } else {
            run.stderr(file)
        };
        let output = run.current_dir(&*folder).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "standard {stream}");
    }
}
