//! `carom solve` as a user meets it.

use crate::common;

use crate::common::{carom, case, close, example, folder, json, limited, refusal, stdout};
use carom_drawn::{Draw as _, Xorshift};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

#[test]
fn a_ball_is_pressed_as_hertz_says() {
    let steps = json(&["solve", &example("solve_hertz.toml")]);
    // E* = 2 G/(1 - nu), F_z = (4/3) E* sqrt(R zeta^3), p_max = 3 F_z/(2 pi R zeta).
    let (radius, modulus) = (0.01, 4e7);
    for (i, force) in [1.0, 2.0, 3.0, 4.0].into_iter().enumerate() {
        let zeta = (0.75 * force / modulus / f64::sqrt(radius)).powf(2.0 / 3.0);
        let pressure = 1.5 * force / (std::f64::consts::PI * radius * zeta);
        close(&steps[i]["F_z"], force, 1e-8);
        close(&steps[i]["zeta"], zeta, 2e-3 * zeta);
        close(&steps[i]["peak_pressure"], pressure, 5e-3 * pressure);
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
    let (pressure, zeta) =
        (last["peak_pressure"].as_f64().unwrap(), last["zeta"].as_f64().unwrap());
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

/// Goes on with a run and kills it after so many milliseconds.
fn killed_after(case: &str, folder: &Path, milliseconds: u64) {
    let mut run = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["solve", case, "--keep", folder.to_str().unwrap(), "--resume"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(milliseconds));
    let _ = run.kill();
    run.wait().unwrap();
}

#[test]
fn a_run_that_was_stopped_goes_on_bit_for_bit() {
    let case = example("solve_torsion_with_shift.toml");
    let (whole, stopped) = (folder(), folder());
    let keep = |folder: &Path, more: &[&str]| {
        let arguments = ["solve", &case, "--format", "csv", "--keep", folder.to_str().unwrap()];
        stdout(&[&arguments, more].concat())
    };
    let text = keep(&whole, &[]);
    let bytes = |folder: &Path, name: &str| std::fs::read(folder.join(name)).unwrap();
    assert_eq!(text.as_bytes(), bytes(&whole, "loads.csv"));
    for i in 0..6 {
        killed_after(&case, &stopped, 3 + 17 * i);
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
    let (case, kept) = (example("solve_hertz.toml"), folder());
    let kept = kept.to_str().unwrap();
    stdout(&["solve", &case, "--keep", kept]);
    let text = refusal(&["solve", &case, "--keep", kept]);
    assert!(text.contains("add --resume"), "{text}");
    let other = example("solve_spence.toml");
    let text = refusal(&["solve", &other, "--keep", kept, "--resume"]);
    assert!(text.contains("another case"), "{text}");
    let step = Path::new(kept).join("step-000002.npz");
    let mut bytes = std::fs::read(&step).unwrap();
    bytes.truncate(100);
    std::fs::write(&step, bytes).unwrap();
    let text = refusal(&["solve", &case, "--keep", kept, "--resume"]);
    assert!(text.contains("damaged"), "{text}");
    refusal(&["solve", &case, "--resume"]);
}

const BODIES: &str = "[body_1]\nmaterial = { shear_modulus = 1, poisson = 0.5 }\n\
                      [body_2]\nmaterial = { rigid = true }\n";

fn refused(name: &str, text: &str) -> String {
    refusal(&["solve", &case(name, &format!("{BODIES}{text}"))])
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
        ("1,2,3\n1,2\n", "line 2 has 2 values, line 1 has 3"),
        ("1,2,3\n1,nan,2\n", "are missing (1), the first in row 2, column 2"),
        ("1,2,3\n1,x,2\n", "line 2, column 2: `x` is not a finite number"),
        ("1,2,3\n", "has 3 x 1 values, the grid 3 x 2 cells"),
        ("", "there is no height in this file"),
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

/// All files of a folder, hidden ones too.
fn files(folder: &Path) -> Vec<String> {
    let names = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<_> =
        names.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
#[ignore = "a minute: fifty kills"]
fn runs_killed_fifty_times_end_in_the_same_bits() {
    let mut draw = Xorshift(88_172_645_463_325_252);
    for name in ["solve_torsion_with_shift.toml", "solve_to_accuracy.toml"] {
        let (case, kept) = (example(name), folder());
        let started = std::time::Instant::now();
        let whole = stdout(&["solve", &case, "--format", "csv"]);
        let most = 2 * started.elapsed().as_millis() as u64;
        for _ in 0..25 {
            let random = draw.bits();
            // Some runs begin afresh, so that kills meet all of them.
            if random.is_multiple_of(3) {
                let _ = std::fs::remove_dir_all(&kept);
            }
            killed_after(&case, &kept, random / 16 % most);
        }
        let kept = kept.to_str().unwrap();
        let resumed = stdout(&["solve", &case, "--format", "csv", "--keep", kept, "--resume"]);
        assert_eq!(resumed, whole, "{name}");
    }
}

/// A disk that is full: no file may be as large as a step.
#[test]
#[cfg(unix)]
fn a_full_disk_loses_no_earlier_step() {
    let (case, kept) = (example("solve_torsion_with_shift.toml"), folder());
    let name = kept.to_str().unwrap();
    let text = stdout(&["solve", &case, "--format", "csv", "--keep", name]);
    let read = |step: usize| std::fs::read(kept.join(format!("step-{step:06}.npz"))).unwrap();
    let all: Vec<_> = (1..=9).map(read).collect();
    for step in 4..=9 {
        std::fs::remove_file(kept.join(format!("step-{step:06}.npz"))).unwrap();
    }
    let before = files(&kept);
    let resumed = ["solve", &case, "--keep", name, "--resume"];
    let output = limited("trap '' XFSZ; ulimit -f 20", &resumed);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("cannot write") && said.contains("step-000004.npz"), "{said}");
    assert_eq!(files(&kept), before);
    assert!((1..=3).all(|step| read(step) == all[step - 1]));
    let arguments = ["solve", &case, "--format", "csv", "--keep", name, "--resume"];
    assert_eq!(stdout(&arguments), text);
    assert!((1..=9).all(|step| read(step) == all[step - 1]));
}

#[test]
fn an_accuracy_chooses_window_and_cells() {
    let case = example("solve_to_accuracy.toml");
    let force =
        |steps: &serde_json::Value, step: usize, name: &str| steps[step][name].as_f64().unwrap();
    // Cattaneo and Mindlin: xi = (3 f F_z/(16 G a))(2 - nu)(1 - (1 - F_x/(f F_z))^(2/3)), nearly,
    // as nu = 0.3; and exactly Hertz's approach.
    let zeta = (9.0 / 16.0 * 1e4_f64 / (0.01 * (208e9_f64 / 1.82).powi(2))).cbrt();
    for accuracy in [None, Some("1e-2"), Some("2e-4")] {
        let given = accuracy.map_or(vec![], |accuracy| vec!["--accuracy", accuracy]);
        let steps = json(&[vec!["solve", &case], given].concat());
        let accuracy: f64 = accuracy.map_or(1e-3, |text| text.parse().unwrap());
        let error = force(&steps, 0, "zeta") / zeta - 1.0;
        assert!(error.abs() < accuracy, "{error}");
        let estimate = force(&steps, 0, "zeta_error") / zeta;
        assert!(estimate <= accuracy && estimate > 0.2 * error.abs(), "{estimate} {error}");
        assert!(force(&steps, 2, "xi_error") <= accuracy * force(&steps, 2, "xi"));
        assert!(force(&steps, 5, "stick_area_error") > 0.0);
    }
    let modulus = 208e9 / 2.6;
    let radius = (0.01 * zeta).sqrt();
    let steps = json(&["solve", &case, "--accuracy", "1e-3"]);
    let part = 1.0 - f64::powf(1.0 - 20.0 / 30.0, 2.0 / 3.0);
    let xi = 2.0 * 3.0 * 30.0 * 1.7 / (16.0 * modulus * radius) * part;
    close(&steps[2]["xi"], xi, 0.01 * xi);
    // A case needs no grid for it.
    let text = std::fs::read_to_string(&case).unwrap();
    let bare = text.replace("[grid]", "");
    let bare: Vec<_> = bare.lines().filter(|line| !line.starts_with("accuracy")).collect();
    let bare = common::case("solve_without_grid.toml", &bare.join("\n"));
    assert_eq!(json(&["solve", &bare, "--accuracy", "1e-3"]), steps);
}

#[test]
fn an_accuracy_that_makes_no_sense_is_refused() {
    let rest = "[contact]\nfriction = 0.3\n[[step]]\nF_z = 0.1\n";
    let ball = "[gap]\nshape = \"sphere\"\nradius = 10\n";
    let wedge = "[gap]\nshape = \"wedge\"\nslope = 0.1\n";
    let map = "[gap]\nshape = \"heights\"\nfile = \"solve_map.csv\"\n";
    let accuracy = "[grid]\naccuracy = 1e-2\n";
    for (text, parts) in [
        (format!("{ball}[grid]\naccuracy = 0.5\n{rest}"), vec!["grid.accuracy", "1e-6 to 0.1"]),
        (format!("{ball}[grid]\n{rest}"), vec!["grid.cells", "`accuracy`"]),
        (format!("{ball}{accuracy}cells = [3, 3]\n{rest}"), vec!["grid.accuracy", "grid.cells"]),
        (format!("{wedge}{accuracy}{rest}"), vec!["border of every window", "grid.size"]),
        (format!("{map}{accuracy}{rest}"), vec!["heights from a file", "grid.cells"]),
        (format!("{ball}{accuracy}{rest}[[step]]\nF_x = 0.04\n"), vec!["the bodies slide"]),
        (
            format!(
                "{ball}{accuracy}[contact]\nfriction = 0.3\nstatic_friction = 0.2\n[[step]]\nzeta = 1\n"
            ),
            vec!["contact.static_friction", "at least `friction`"],
        ),
    ] {
        let said = refused("solve_accuracy_bad.toml", &text);
        for part in parts {
            assert!(said.contains(part), "{said} lacks {part}");
        }
    }
    let said = refusal(&["solve", &example("solve_hertz.toml"), "--accuracy", "7"]);
    assert!(said.contains("--accuracy = 7"), "{said}");
}

#[test]
fn heights_are_the_same_from_every_kind_of_file() {
    let rows = [[0_u16, 100, 200, 50], [1000, 65_535, 300, 40], [7, 8, 60_000, 10]];
    let text: Vec<String> = rows.iter().map(|row| row.map(|h| h.to_string()).join(",")).collect();
    case("solve_kinds.csv", &text.join("\n"));
    let folder = PathBuf::from(case("solve_kinds.csv", &text.join("\n")));
    let numbers = rows.iter().flatten().flat_map(|h| h.to_le_bytes());
    let npy = carom_surface::npy("<u2", &[3, 4], numbers);
    std::fs::write(folder.with_file_name("solve_kinds.npy"), npy).unwrap();
    let file = std::fs::File::create(folder.with_file_name("solve_kinds.png")).unwrap();
    let mut encoder = png::Encoder::new(file, 4, 3);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Sixteen);
    // A picture begins at the top.
    let pixels: Vec<u8> = rows.iter().rev().flatten().flat_map(|h| h.to_be_bytes()).collect();
    encoder.write_header().unwrap().write_image_data(&pixels).unwrap();
    let solved = |ending: &str| {
        let text = format!(
            "{BODIES}[gap]\nshape = \"heights\"\nfile = \"solve_kinds.{ending}\"\nscale = 1e-5\n\
             [grid]\ncells = [4, 3]\nsize = [4, 3]\ncut = true\n[contact]\nfriction = 0.3\n\
             [[step]]\nzeta = 0.2\n[[step]]\nxi = 0.01\n"
        );
        stdout(&["solve", &case(&format!("solve_{ending}.toml"), &text), "--format", "csv"])
    };
    let csv = solved("csv");
    assert_eq!(solved("npy"), csv);
    assert_eq!(solved("png"), csv);
    std::fs::write(folder.with_file_name("solve_kinds.png"), b"no picture").unwrap();
    let text = "[gap]\nshape = \"heights\"\nfile = \"solve_kinds.png\"\n[grid]\ncells = [4, 3]\n\
                size = [4, 3]\n[contact]\nfriction = 0\n[[step]]\nzeta = 0.1\n";
    let said = refused("solve_no_png.toml", text);
    assert!(said.contains("not a PNG file"), "{said}");
}

#[test]
fn a_history_through_separation_forgets() {
    let ball = "[gap]\nshape = \"sphere\"\nradius = 10\n[grid]\ncells = [24, 24]\nsize = [5, 5]\n\
                [contact]\nfriction = 0.3\n";
    let pressed = "[[step]]\nzeta = 0.3\nxi = 0\n[[step]]\nxi = 0.05\n";
    let solved =
        |name: &str, steps: &str| json(&["solve", &case(name, &format!("{BODIES}{ball}{steps}"))]);
    let once = solved("solve_once.toml", pressed);
    for apart in ["zeta = -0.1\nxi = 0.2\n", "F_z = 0\nxi = 0.2\n"] {
        let again = solved(
            "solve_again.toml",
            &format!("{pressed}[[step]]\n{apart}[[step]]\nxi = 0\n{pressed}"),
        );
        assert_eq!(again[2]["F_z"].as_f64(), Some(0.0));
        assert_eq!(again[2]["contact_area"].as_f64(), Some(0.0));
        for name in ["F_x", "F_z", "stick_area"] {
            let want = once[1][name].as_f64().unwrap();
            close(&again[5][name], want, 1e-8 * want.abs());
        }
    }
    // Nothing holds a force there.
    let text = format!("{ball}[[step]]\nF_z = 1\n[[step]]\nF_x = 0.1\n[[step]]\nF_z = 0\n");
    let said = refused("solve_held_by_nothing.toml", &text);
    assert!(said.contains("step 3") && said.contains("the bodies slide"), "{said}");
}

#[test]
fn few_cells_give_a_warning_with_the_error() {
    let text = "[gap]\nshape = \"sphere\"\nradius = 10\n[grid]\ncells = [12, 12]\nsize = [5, 5]\n\
                [contact]\nfriction = 0.3\n[[step]]\nzeta = 0.2\n";
    let output = carom(&["solve", &case("solve_few.toml", &format!("{BODIES}{text}"))]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    assert!(said.contains("cells wide: the estimated error of loads and shifts is"), "{said}");
}
