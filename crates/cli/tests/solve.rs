//! `carom solve` as a user meets it.

mod common;

use common::{carom, case, close, example, json, stdout};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A folder in that for temporary files of this build, gone before the test.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    path
}

#[test]
fn a_ball_is_pressed_as_hertz_says() {
    let steps = json(&["solve", &example("solve_hertz.toml")]);
    // E* = 2 G/(1 - nu), F_z = (4/3) E* sqrt(R zeta^3), p_max = 3 F_z/(2 pi R zeta).
    let (radius, modulus) = (0.01, 4e6);
    for (i, force) in [1.0, 2.0, 3.0, 4.0].into_iter().enumerate() {
        let zeta = (0.75 * force / modulus / f64::sqrt(radius)).powf(2.0 / 3.0);
        let pressure = 1.5 * force / (std::f64::consts::PI * radius * zeta);
        close(&steps[i]["F_z"], force, 1e-8);
        close(&steps[i]["zeta"], zeta, 2e-3 * zeta);
        close(&steps[i]["p_max"], pressure, 5e-3 * pressure);
        close(&steps[i]["stored_energy"], 0.4 * force * zeta, 4e-3 * force * zeta);
    }
}

#[test]
fn stresses_below_a_ball_are_those_of_huber() {
    let both = json(&["solve", &example("solve_hertz.toml"), "--depths", "101"]);
    let rows = both["depths"].as_array().unwrap();
    // The rigid body has none.
    assert_eq!(rows.len(), 101);
    let last = &both["steps"][3];
    let (pressure, zeta) = (last["p_max"].as_f64().unwrap(), last["zeta"].as_f64().unwrap());
    let radius = f64::sqrt(0.01 * zeta);
    // s_zz = -p_max/(1 + z^2/a^2) on the axis; the greatest pressure is in a cell beside it.
    for row in rows.iter().skip(5) {
        let depth = row["depth"].as_f64().unwrap() / radius;
        close(&row["s_zz"], -pressure / (1.0 + depth * depth), 0.01 * pressure);
    }
}

#[test]
fn a_loop_closes_and_heats() {
    let steps = json(&["solve", &example("solve_cattaneo_loop.toml")]);
    let number = |step: usize, name: &str| steps[step - 1][name].as_f64().unwrap();
    assert_eq!(steps.as_array().unwrap().len(), 26);
    // Exactly where nu = 0; else slip turns a little across the shift.
    assert!((number(26, "F_x") / number(6, "F_x") - 1.0).abs() < 2e-3);
    assert!((number(16, "F_x") / number(6, "F_x") + 1.0).abs() < 2e-3);
    assert!(number(26, "dissipated") > number(16, "dissipated"));
    assert_eq!(number(1, "stick_area"), number(1, "contact_area"));
    assert!(number(6, "stick_area") < 0.6 * number(6, "contact_area"));
}

#[test]
fn unlike_bodies_stick_as_far_as_spence_says() {
    let steps = json(&["solve", &example("solve_spence.toml")]);
    let last = &steps[15];
    let part = last["stick_area"].as_f64().unwrap() / last["contact_area"].as_f64().unwrap();
    // An independent half-space program: 0.682 at f/gamma = 0.7.
    assert!((part.sqrt() - 0.682).abs() < 0.03, "{}", part.sqrt());
}

#[test]
fn a_run_that_was_stopped_goes_on_bit_for_bit() {
    let case = example("solve_torsion_with_shift.toml");
    let (whole, stopped) = (folder("solve_whole"), folder("solve_stopped"));
    let keep = |folder: &Path, more: &[&str]| {
        let arguments = ["solve", &case, "--format", "csv", "--keep", folder.to_str().unwrap()];
        stdout(&[&arguments, more].concat())
    };
    let text = keep(&whole, &[]);
    let bytes = |folder: &Path, name: &str| std::fs::read(folder.join(name)).unwrap();
    assert_eq!(text.as_bytes(), bytes(&whole, "loads.csv"));
    // Killed at whatever moments.
    let arguments = ["solve", &case, "--keep", stopped.to_str().unwrap(), "--resume"];
    for i in 0..6 {
        let mut run = Command::new(env!("CARGO_BIN_EXE_carom"))
            .args(arguments)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(std::time::Duration::from_millis(3 + 17 * i));
        let _ = run.kill();
        run.wait().unwrap();
    }
    assert_eq!(keep(&stopped, &["--resume"]), text);
    for step in 1..=9 {
        let name = format!("step-{step:06}.npz");
        assert!(bytes(&whole, &name) == bytes(&stopped, &name), "{name}");
    }
    // And once more, with nothing left to do.
    assert_eq!(keep(&stopped, &["--resume"]), text);
}

#[test]
fn steps_of_other_runs_are_left_alone() {
    let (case, kept) = (example("solve_hertz.toml"), folder("solve_kept"));
    let kept = kept.to_str().unwrap();
    let said = |arguments: &[&str]| {
        let output = carom(arguments);
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    assert_eq!(said(&["solve", &case, "--keep", kept]).0, Some(0));
    let (code, text) = said(&["solve", &case, "--keep", kept]);
    assert!(code == Some(2) && text.contains("add --resume"), "{text}");
    let other = example("solve_spence.toml");
    let (code, text) = said(&["solve", &other, "--keep", kept, "--resume"]);
    assert!(code == Some(2) && text.contains("another case"), "{text}");
    let step = Path::new(kept).join("step-000002.npz");
    let mut bytes = std::fs::read(&step).unwrap();
    bytes.truncate(100);
    std::fs::write(&step, bytes).unwrap();
    let (code, text) = said(&["solve", &case, "--keep", kept, "--resume"]);
    assert!(code == Some(2) && text.contains("damaged"), "{text}");
    assert_eq!(said(&["solve", &case, "--resume"]).0, Some(2));
}

const BODIES: &str = "[body_1]\nmaterial = { shear_modulus = 1, poisson = 0.5 }\n\
                      [body_2]\nmaterial = { rigid = true }\n";

fn refused(name: &str, text: &str) -> String {
    let output = carom(&["solve", &case(name, &format!("{BODIES}{text}"))]);
    assert_eq!(output.status.code(), Some(2), "{text}");
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let ball = "[gap]\nshape = \"sphere\"\nradius = 10\n";
    let grid = "[grid]\ncells = [12, 12]\nsize = [3, 3]\n";
    let rest = "[contact]\nfriction = 0.3\n[[step]]\nzeta = 0.1\n";
    for (text, parts) in [
        (format!("{ball}{grid}{rest}zeta2 = 1\n"), vec!["step[0].zeta2", "line 15", "`F_z`"]),
        (format!("{ball}{grid}{rest}F_z = 1\n"), vec!["step[0].F_z", "zeta"]),
        (
            format!("{ball}{grid}[contact]\nfriction = -1\n[[step]]\nzeta = 1\n"),
            vec!["contact.friction", "-1"],
        ),
        (format!("{ball}{grid}[contact]\nfriction = 0\n[[step]]\nxi = 1\n"), vec!["step[0].zeta"]),
        (format!("{ball}[grid]\ncells = [0, 3]\nsize = [1, 1]\n{rest}"), vec!["grid.cells.x", "0"]),
        (
            format!("{ball}slope = 1\n{grid}{rest}"),
            vec!["gap.slope", "`gap` of shape \"sphere\" takes `shape`, `radius`"],
        ),
        (
            format!("[gap]\nshape = \"ball\"\n{grid}{rest}"),
            vec!["gap.shape", "\"ball\"", "paraboloid"],
        ),
        (
            format!("{ball}{grid}[contact]\nfriction = 0.3\n[[step]]\nzeta = 2\n"),
            vec!["step 1", "left border", "grid.size"],
        ),
        (
            format!("{ball}{grid}{rest}[[step]]\nF_x = 100\n"),
            vec!["step 2", "100", "the bodies slide"],
        ),
        (
            format!("[gap]\nshape = \"polygon\"\ncorners = [[9, 9], [9, 8], [8, 9]]\n{grid}{rest}"),
            vec!["gap.shape", "cell"],
        ),
    ] {
        let said = refused("solve_bad.toml", &text);
        for part in parts {
            assert!(said.contains(part), "{said} lacks {part}");
        }
    }
}

#[test]
fn bad_height_maps_are_refused_by_line() {
    let map = "[gap]\nshape = \"heights\"\nfile = \"solve_map.csv\"\n[grid]\ncells = [3, 2]\n\
               size = [3, 2]\ncut = true\n[contact]\nfriction = 0\n[[step]]\nzeta = 0.1\n";
    for (heights, part) in [
        ("1,2,3\n1,2\n", "row 2 of the height map has 2 values, the first 3"),
        ("1,2,3\n1,nan,2\n", "line 2: `value 2` = nan"),
        ("1,2,3\n1,x,2\n", "`value 2` = x is out of range: must be a finite number"),
        ("1,2,3\n", "has 3 x 1 values, the grid 3 x 2 cells"),
        ("", "the height map is empty"),
    ] {
        case("solve_map.csv", heights);
        let said = refused("solve_heights_bad.toml", map);
        assert!(said.contains(part), "{said}");
    }
    case("solve_map.csv", "1,2,3\n1,2,2.95\n");
    let text = format!("{BODIES}{map}");
    let steps = json(&["solve", &case("solve_heights_good.toml", &text)]);
    assert!(steps[0]["F_z"].as_f64().unwrap() > 0.0);
    assert_eq!(steps[0]["contact_area"].as_f64().unwrap(), 2.0);
}
