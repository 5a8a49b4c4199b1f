//! Many rows are written as they are computed: memory does not grow with them.
#![cfg(target_os = "linux")]

use crate::common::{carom, case, example, fresh, refusal, stdout};
use std::fs::File;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Duration;

/// Kilobytes that a run may have at once: 22 to 37 thousand were measured, with the text of some thousand rows.
const MOST: u64 = 50_000;

/// Runs the command and gives its results, in a file, and the most kilobytes it had at once.
fn run(name: &str, arguments: &[&str]) -> (PathBuf, u64) {
    let results = fresh(name);
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(arguments)
        .arg("--quiet")
        .stdout(File::create(&results).unwrap())
        .stderr(Stdio::inherit())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut most = 0;
    while child.try_wait().unwrap().is_none() {
        // The greatest so far: what is read last counts.
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let peak = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let peak = peak.and_then(|peak| peak.split_whitespace().next()?.parse().ok());
        most = peak.unwrap_or(most);
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(child.wait().unwrap().success(), "{arguments:?}");
    assert!(most > 0);
    (results, most)
}

/// The rows of results in these formats, each of which takes little memory.
fn rows_in_little_memory(name: &str, arguments: &[&str], formats: &[&str], rows: usize) {
    for format in formats {
        let (results, most) =
            run(&format!("{name}.{format}"), &[arguments, &["--format", format]].concat());
        assert!(most < MOST, "{format}: {most} kB");
        let text = std::fs::read_to_string(results).unwrap();
        let found = match *format {
            "csv" => text.lines().count() - 1,
            _ => {
                assert!(text.ends_with("]\n") || text.ends_with("}\n"));
                text.matches("\"outside_theory\": ").count()
            }
        };
        assert_eq!(found, rows, "{format}");
    }
}

/// Alumina on a plane at so many angles.
fn sweep(name: &str, count: usize) -> String {
    let text = std::fs::read_to_string(example("alumina_on_plane.toml")).unwrap();
    // The analytic law: these tests are about many rows, not about coupling.
    let text = text.replace("friction = 0.092", "friction = 0.092\nlaw = \"coulomb\"");
    case(name, &text.replace("count = 17", &format!("count = {count}")))
}

/// A ball of rubber that hops between a floor and two walls without losing height.
fn scene(name: &str, bounces: usize) -> String {
    let wall = |place: f64, normal: f64| {
        format!(
            "[[wall]]\npoint = [{place}, 0, 0]\nnormal = [{normal}, 0, 0]\n\
             material = {{ rigid = true }}\nfriction = 0.4\n"
        )
    };
    let text = format!(
        "[ball]\nshape = \"sphere\"\nradius = 0.02\ndensity = 1000\nvelocity = [0.3, 0, 0]\n\
         spin = [0, 3, 0]\nmaterial = {{ shear_modulus = 1e6, poisson = 0.5 }}\n\
         [[wall]]\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\nmaterial = {{ rigid = true }}\n\
         friction = 0.4\n{}{}[scene]\nstart = [0, 0, 0.5]\ngravity = [0, 0, -9.81]\ntime = 1e9\n\
         bounces = {bounces}\n",
        wall(-1.0, 1.0),
        wall(1.0, -1.0)
    );
    case(name, &text)
}

/// A contact that is shifted to and fro while it is pressed more and less.
fn history(name: &str, steps: usize) -> String {
    let mut text = "zeta,xi,eta\n".to_owned();
    for i in 0..steps {
        let at = i as f64 / 50.0;
        let zeta = 1e-4 * (1.0 + 0.3 * (0.7 * at).sin());
        let (xi, eta) = (4e-5 * at.sin(), 3e-5 * (1.3 * at).cos());
        text.push_str(&format!("{zeta:e},{xi:e},{eta:e}\n"));
    }
    case(&format!("{name}.csv"), &text);
    case(
        name,
        &format!(
            "[body_1]\nradii = 0.02\nmaterial = {{ shear_modulus = 1e6, poisson = 0.5 }}\n[body_2]\n\
             radii = inf\nmaterial = {{ rigid = true }}\n[contact]\nangle = 0\nfriction = 0.5\n\
             law = \"fixed-direction\"\n[history]\nfile = \"{name}.csv\"\n"
        ),
    )
}

#[test]
fn a_sweep_of_many_impacts_is_written_as_it_comes() {
    let case = sweep("room_sweep.toml", 30_000);
    rows_in_little_memory("room_sweep", &["impact", &case], &["csv", "json"], 30_000);
}

#[test]
fn a_scene_of_many_bounces_is_written_as_it_comes() {
    let case = scene("room_scene.toml", 60_000);
    rows_in_little_memory("room_scene", &["scene", &case], &["csv", "json"], 60_000);
}

#[test]
fn a_history_of_many_steps_is_written_as_it_comes() {
    let case = history("room_history.toml", 120_000);
    rows_in_little_memory("room_history", &["history", &case], &["csv", "json"], 120_000);
}

#[test]
fn a_picture_of_many_rows_is_thinned() {
    let sweep = sweep("room_drawn_sweep.toml", 50_000);
    let history = history("room_drawn_history.toml", 100_000);
    let scene = scene("room_drawn_scene.toml", 20_000);
    for (command, case) in [("impact", &sweep), ("history", &history), ("scene", &scene)] {
        let picture = fresh(&format!("room_{command}.svg"));
        let drawn = ["--format", "none", "--plot", picture.to_str().unwrap()];
        let (_, most) = run(command, &[&[command, case][..], &drawn].concat());
        assert!(most < MOST, "{command}: {most} kB");
        let size = std::fs::metadata(picture).unwrap().len();
        assert!((10_000..8_000_000).contains(&size), "{command}: {size} bytes");
    }
}

#[test]
fn a_table_of_more_than_10000_rows_is_refused_with_the_formats_to_use() {
    let sweep = sweep("room_table_sweep.toml", 10_001);
    let history = history("room_table_history.toml", 10_001);
    let scene = scene("room_table_scene.toml", 10_001);
    for (command, case) in [("impact", &sweep), ("history", &history), ("scene", &scene)] {
        let said = refusal(&[command, case]);
        assert!(said.contains("choose --format csv, json or none"), "{command}: {said}");
    }
}

#[test]
fn blocks_of_a_sweep_are_the_same_on_any_number_of_threads() {
    let case = sweep("room_threads.toml", 3000);
    for format in ["csv", "json"] {
        let results = ["1", "2", "5"]
            .map(|threads| stdout(&["impact", &case, "--format", format, "--threads", threads]));
        assert!(results[0] == results[1] && results[1] == results[2], "{format}");
    }
    // Rows are those that each impact has by itself.
    let few = stdout(&["impact", &sweep("room_few.toml", 17), "--format", "csv"]);
    let many = stdout(&["impact", &sweep("room_many.toml", 16 * 100 + 1), "--format", "csv"]);
    let every: Vec<&str> = many.lines().skip(1).step_by(100).collect();
    assert_eq!(few.lines().skip(1).collect::<Vec<_>>(), every);
}

#[test]
fn a_sweep_that_fails_late_writes_nothing() {
    let text = std::fs::read_to_string(example("alumina_on_plane.toml")).unwrap();
    // At the last speeds the energy overflows, long after the first block.
    let speeds = "{ start = 1, stop = 1e100, count = 3000 }";
    let text = text.replace("speed = 3.9", &format!("speed = {speeds}"));
    let text = text.replace("angle = { start = 5, stop = 85, count = 17 }", "angle = 5");
    let text = text.replace("radius = 2.5e-3", "radius = 1e35");
    let text = text.replace("friction = 0.092", "friction = 0.092\nlaw = \"coulomb\"");
    let output = carom(&["impact", &case("room_late.toml", &text), "--format", "csv"]);
    assert!(!output.status.success());
    assert!(output.stdout.is_empty());
}
