//! The command as a user meets it: results on standard output, exit codes, files.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn carom(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).args(arguments).output().unwrap()
}

fn stdout(arguments: &[&str]) -> String {
    let output = carom(arguments);
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {stderr}");
    String::from_utf8(output.stdout).unwrap()
}

fn json(arguments: &[&str]) -> serde_json::Value {
    let arguments = [arguments, &["--format", "json"]].concat();
    serde_json::from_str(&stdout(&arguments)).unwrap()
}

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    path.to_str().unwrap().to_owned()
}

/// A file in the folder for temporary files of this build, gone before the test.
fn fresh(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_file(&path);
    path
}

/// A case file with this text.
fn case(name: &str, text: &str) -> String {
    let path = fresh(name);
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

fn close(value: &serde_json::Value, expected: f64, tolerance: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected}");
}

#[test]
fn restitution_gives_an_array_of_objects() {
    let rows = json(&["restitution", "--kappa", "1.5,1", "--lambda", "3:8:2"]);
    let rows = rows.as_array().unwrap();
    assert_eq!(rows.len(), 4);
    close(&rows[0]["kappa"], 1.5, 0.0);
    close(&rows[0]["lambda"], 3.0, 0.0);
    close(&rows[0]["R_x"], 0.595052, 5e-7);
    assert_eq!(rows[0]["regimes"].as_array().unwrap()[0], "slide+");
    // Sliding throughout: R_x = -1 + 7/lambda.
    close(&rows[3]["R_x"], -0.125, 1e-15);
    assert_eq!(rows[3]["regimes"], serde_json::json!(["slide+"]));
}

#[test]
fn restitution_as_csv_has_full_precision() {
    let text = stdout(&["restitution", "--kappa", "1", "--lambda", "9", "--format", "csv"]);
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("kappa,lambda,R_x,regimes"));
    let row: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert!((row[2].parse::<f64>().unwrap() + 2.0 / 9.0).abs() < 1e-15);
}

#[test]
fn frictionless_spheres_slide_unhindered() {
    let rows = json(&["restitution", "--kappa", "1.2", "--lambda", "inf"]);
    close(&rows[0]["R_x"], -1.0, 0.0);
    assert_eq!(rows[0]["lambda"], "inf");
}

#[test]
fn bad_options_name_the_option_and_what_is_allowed() {
    for (arguments, expected) in [
        (["--kappa", "a", "--lambda", "1"], "'--kappa <VALUES>': `a` is not a number"),
        (["--kappa", "1", "--lambda", "0:1"], "'--lambda <VALUES>': `0:1` has 1 colons"),
        (["--kappa", "nan", "--lambda", "1"], "--kappa = NaN is out of range: must be"),
        (["--kappa", "2", "--lambda", "1"], "--kappa = 2 is out of range: must be"),
        (["--kappa", "1", "--lambda", "-1"], "--lambda = -1 is out of range: must be"),
    ] {
        let plot = fresh("bad-option.svg");
        let arguments = [&["restitution", "--plot", plot.to_str().unwrap()][..], &arguments];
        let output = carom(&arguments.concat());
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{stderr}");
        assert!(stderr.contains(expected), "{stderr}");
        assert!(output.stdout.is_empty() && !plot.exists());
    }
}

#[test]
fn a_ball_thrown_under_a_book_comes_back() {
    let table = json(&["impact", &example("rubber_on_table.toml")]);
    close(&table["R_x"], 0.580998, 5e-7);
    close(&table["after"]["body_1"]["velocity"][0], 0.548286, 5e-7);
    let book = json(&["impact", &example("rubber_under_book.toml")]);
    close(&book["after"]["body_2"]["velocity"][0], -0.05171, 1e-5);
}

#[test]
fn a_sweep_gives_an_impact_an_angle() {
    let records = json(&["impact", &example("alumina_on_plane.toml")]);
    let records = records.as_array().unwrap();
    assert_eq!(records.len(), 17);
    // Independent values of the spin for 5, 20 and 80 degrees.
    for (index, angle, spin) in [(0, 5.0, 87.84), (3, 20.0, 542.06), (15, 80.0, 124.61)] {
        close(&records[index]["angle"], angle, 1e-12);
        close(&records[index]["after"]["body_1"]["spin"][1], spin, 0.01);
    }
    assert!(records[0]["warnings"][0].as_str().unwrap().contains("gamma"));
}

#[test]
fn energy_and_momentum_balance_in_the_output() {
    let record = json(&["impact", &example("steel_balls.toml")]);
    let number = |name: &str| record[name].as_f64().unwrap();
    let before = number("energy_before");
    let balance = before - number("energy_after") - number("energy_dissipated");
    assert!(balance.abs() < 1e-14 * before, "{balance}");
    let velocity = |when: &str, body: &str, axis: usize| {
        record[when][body]["velocity"][axis].as_f64().unwrap()
    };
    for axis in 0..3 {
        let sum = |when| velocity(when, "body_1", axis) + velocity(when, "body_2", axis);
        assert!((sum("before") - sum("after")).abs() < 1e-15);
    }
}

#[test]
fn every_example_runs_in_every_format_and_draws() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "toml") {
            continue; // steps of a history
        }
        let plot = fresh(&format!("{}.svg", path.file_stem().unwrap().to_str().unwrap()));
        let case = path.to_str().unwrap();
        let name = path.file_name().unwrap().to_str().unwrap();
        let command = match name.split_once('_') {
            Some((command @ ("hertz" | "history" | "scene"), _)) => command,
            _ => "impact",
        };
        for format in ["table", "json", "csv"] {
            let arguments = [command, case, "--format", format, "--plot", plot.to_str().unwrap()];
            assert!(!stdout(&arguments).is_empty());
        }
        assert!(std::fs::read_to_string(&plot).unwrap().starts_with("<svg"));
        count += 1;
    }
    assert!(count >= 14);
}

#[test]
fn a_history_runs_from_touch_to_separation() {
    let case = example("rubber_on_table.toml");
    let text = stdout(&["impact", &case, "--history", "101", "--format", "csv"]);
    let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|row| row.split(',').collect()).collect();
    assert_eq!(rows.len(), 101);
    let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
    assert_eq!(number(0, 3), 0.0);
    assert!(number(100, 3).abs() < 1e-6 * number(50, 3));
    // Coulomb's bound at every instant.
    assert!((0..101).all(|i| number(i, 4).abs() <= 0.3 * number(i, 3) * (1.0 + 1e-9)));
    let sweep = carom(&["impact", &example("alumina_on_plane.toml"), "--history", "5"]);
    assert_eq!(sweep.status.code(), Some(2));
}

const DROP: &str = "\
[body_1]
shape = \"sphere\"
radius = 0.01
material = { young_modulus = 2e11, poisson = 0.3 }
mass = 0.03
velocity = [0.5, 0, -1]
spin = [0, 0, 0]

[body_2]
shape = \"plane\"
material = { young_modulus = 2e11, poisson = 0.3 }
fixed = true

[contact]
friction = 0.2
";

#[test]
fn bad_cases_end_with_code_2_and_write_nothing() {
    for (old, new, expected) in [
        ("radius = 0.01", "radius = -1", "`body_1.radius` = -1 is out of range: must be"),
        ("radius = 0.01", "", "`body_1.radius` is missing"),
        ("radius", "radiuss", "did you mean `radius`?"),
        ("0.2", "nan", "`contact.friction` = NaN is out of range: must be"),
        ("fixed = true", "fixed = true\nmass = 1", "cannot stand beside"),
        ("mass = 0.03", "mass = inf", "a finite mass for at least one of the two bodies"),
    ] {
        let case = case("bad-case.toml", &DROP.replacen(old, new, 1));
        let plot = fresh("bad-case.svg");
        let output = carom(&["impact", &case, "--plot", plot.to_str().unwrap()]);
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{stderr}");
        assert!(stderr.contains(expected), "{stderr}");
        assert!(output.stdout.is_empty() && !plot.exists());
    }
}

#[test]
fn limits_of_friction_and_approach_are_valid() {
    let impact = |name: &str, old: &str, new: &str| {
        json(&["impact", &case(name, &DROP.replacen(old, new, 1))])
    };
    close(&impact("frictionless.toml", "0.2", "0")["R_x"], -1.0, 0.0);
    let gripping = impact("gripping.toml", "0.2", "inf");
    assert!(gripping["R_x"].as_f64().unwrap().is_finite());
    let away = impact("away.toml", "-1]", "1]");
    assert_eq!(away["outcome"], "no_impact");
    assert_eq!(away["after"], away["before"]);
    let grazing = impact("grazing.toml", "-1]", "-1e-9]");
    assert_eq!(grazing["outcome"], "rebound");
}

#[test]
fn without_an_impact_there_is_nothing_to_draw() {
    let case = case("resting.toml", &DROP.replacen("-1]", "0]", 1));
    let plot = fresh("resting.svg");
    let output = carom(&["impact", &case, "--plot", plot.to_str().unwrap()]);
    assert!(output.status.success() && !plot.exists());
    assert!(String::from_utf8_lossy(&output.stderr).contains("nothing to draw"));
}

#[test]
fn files_that_cannot_be_read_or_written_end_with_code_1() {
    let output = carom(&["impact", "no/such/case.toml"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("cannot read no/such/case.toml"));
    let arguments = ["impact", &example("steel_balls.toml"), "--plot", "no/such/folder/a.svg"];
    let output = carom(&arguments);
    assert_eq!(output.status.code(), Some(1));
    assert!(output.stdout.is_empty());
}

const SPHERE: &str = "\
[body_1]
radii = 0.01
material = { shear_modulus = 80e9, poisson = 0.25 }

[body_2]
radii = [inf, inf]
material = { shear_modulus = 80e9, poisson = 0.25 }

[contact]
angle = 0
";

#[test]
fn hertz_gives_the_circle_of_a_sphere() {
    let text = SPHERE.to_owned() + "[load]\nforce = { start = 1, stop = 100, count = 3 }\n";
    let report = json(&["hertz", &case("sphere.toml", &text)]);
    close(&report["axis_ratio"], 1.0, 1e-15);
    for load in report["loads"].as_array().unwrap() {
        let number = |name: &str| load[name].as_f64().unwrap();
        // a^3 = 3 F R (1 - nu)/(8 G) with the combined G = 40 GPa, a^2 = R zeta.
        let (force, a) = (number("force"), number("semi_axis_a"));
        let cube = 3.0 * force * 0.01 * 0.75 / (8.0 * 40e9);
        assert!((a.powi(3) / cube - 1.0).abs() < 1e-13);
        assert!((a * a / (0.01 * number("approach")) - 1.0).abs() < 1e-13);
        let peak = 1.5 * force / (std::f64::consts::PI * a * a);
        assert!((number("peak_pressure") / peak - 1.0).abs() < 1e-13);
    }
}

fn history(name: &str, friction: &str, steps: &str) -> String {
    let contact = format!("angle = 0\nfriction = {friction}\n[history]\n{steps}\n");
    case(name, &SPHERE.replace("angle = 0\n", &contact))
}

#[test]
fn a_history_slides_at_the_friction_limit_and_remembers() {
    let steps = "steps = [[1e-6, 0, 0], [1e-6, 1e-5, 0], [1e-6, 9.9e-6, 0], [-1e-6, 0, 0]]";
    let case = history("slide.toml", "0.3", steps);
    let rows = json(&["history", &case, "--tractions", "11"]);
    let number = |row: usize, name: &str| rows[row][name].as_f64().unwrap();
    assert_eq!(rows[1]["regime"], "sliding");
    assert!((number(1, "F_x") / (0.3 * number(1, "F_z")) - 1.0).abs() < 1e-14);
    assert!(number(2, "F_x") < number(1, "F_x") && number(2, "stick_semi_axis_a") > 0.0);
    assert_eq!(rows[3]["regime"], "separated");
    assert_eq!(number(3, "F_x"), 0.0);
    // In gross sliding the traction is f times the pressure.
    let a = number(1, "semi_axis_a");
    let peak = 1.5 * number(1, "F_z") / (std::f64::consts::PI * a * a);
    let centre = rows[1]["tractions"][0]["t_x"].as_f64().unwrap();
    assert!((centre / (0.3 * peak) - 1.0).abs() < 1e-13);
}

#[test]
fn steps_inline_and_in_a_file_are_the_same() {
    let inline = history("inline.toml", "0.3", "steps = [[1e-6, 0, 0], [2e-6, 1e-7, 3e-7, 1e-3]]");
    case("steps.csv", "eta,xi,zeta,omega\n0,0,1e-6,0\n3e-7,1e-7,2e-6,1e-3\n");
    let file = history("file.toml", "0.3", "file = \"steps.csv\"");
    assert_eq!(json(&["history", &inline]), json(&["history", &file]));
}

#[test]
fn bad_contacts_end_with_code_2() {
    for (command, text, expected) in [
        ("hertz", SPHERE.to_owned(), "`load` is missing"),
        (
            "hertz",
            SPHERE.to_owned() + "[load]\nforce = -1\n",
            "`load.force` = -1 is out of range: must be finite and > 0",
        ),
        (
            "hertz",
            SPHERE.to_owned() + "[load]\nforce = 1\napproach = 1e-6\n",
            "`load.approach` cannot stand beside `load.force`",
        ),
        (
            "hertz",
            SPHERE.replace("0.01", "0") + "[load]\nforce = 1\n",
            "`body_1.radii` = 0 is out of range: must be nonzero",
        ),
        (
            "hertz",
            SPHERE.replace("0.01", "[0.01, inf]") + "[load]\nforce = 1\n",
            "touch along a line",
        ),
        (
            "history",
            SPHERE.to_owned() + "friction = 0.3\n[history]\nsteps = [[1, nan, 0]]\n",
            "`history.steps[0]` = NaN is out of range: must be finite",
        ),
        (
            "history",
            SPHERE.to_owned() + "friction = 0.3\n[history]\nsteps = [[1, 0]]\n",
            "`history.steps[0]` = [1, 0] is out of range: must be a list of rows [zeta, xi, eta] or",
        ),
        (
            "history",
            SPHERE.to_owned() + "friction = 0.3\n[history]\nsteps = [[1, 0, 0], [1, 0, 0, inf]]\n",
            "line 13: `history.steps[1]` = inf is out of range: must be finite",
        ),
        (
            "history",
            SPHERE.to_owned() + "friction = 0.3\n[history]\nsteps = [[1, 0, 0, 0, 0]]\n",
            "`history.steps[0]` = [1, 0, 0, 0, 0] is out of range: must be a list of rows",
        ),
        ("history", SPHERE.to_owned() + "friction = 0.3\n[history]\n", "`history.file` is missing"),
    ] {
        let case = case("bad-contact.toml", &text);
        let plot = fresh("bad-contact.svg");
        let output = carom(&[command, &case, "--plot", plot.to_str().unwrap()]);
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{stderr}");
        assert!(stderr.contains(expected), "{stderr}");
        assert!(output.stdout.is_empty() && !plot.exists());
    }
}

#[test]
fn restitution_by_groups_of_any_bodies() {
    // Sliding throughout: R_x = -1 + 2 chi/psi; spheres are chi = 7/(2 kappa), psi = lambda/kappa.
    let rows = json(&["restitution", "--chi", "2,3", "--psi", "8"]);
    assert_eq!(rows[0]["R_x"], -0.5);
    assert_eq!((&rows[1]["chi"], &rows[1]["psi"]), (&3.0.into(), &8.0.into()));
    let spheres = json(&["restitution", "--kappa", "1.25", "--lambda", "2"]);
    let groups = json(&["restitution", "--chi", "2.8", "--psi", "1.6"]);
    assert_eq!(spheres[0]["regimes"], groups[0]["regimes"]);
    assert_eq!(spheres[0]["R_x"], groups[0]["R_x"]);
}

#[test]
fn two_ranges_are_drawn_as_a_map() {
    for (names, title) in [
        (["--kappa", "--lambda"], "Tangential restitution of spheres"),
        (["--chi", "--psi"], "Tangential restitution"),
    ] {
        let map = fresh(&format!("map{}.svg", names[0]));
        let path = map.to_str().unwrap();
        let text = stdout(&[
            "restitution",
            names[0],
            "1:1.5:41",
            names[1],
            "0.1:9:61",
            "--map",
            path,
            "--format",
            "csv",
        ]);
        assert_eq!(text.lines().count(), 1 + 41 * 61);
        let svg = std::fs::read_to_string(&map).unwrap();
        assert!(svg.contains(title) && svg.contains("R<tspan") && !svg.contains("NaN"));
        // The line of R_x = 0 is there, and bold.
        assert!(svg.contains("stroke-width=\"1.6\" d=\"M"));
    }
}

#[test]
fn maps_need_ranges_and_tangents_a_velocity() {
    for (arguments, expected) in [
        (&["--kappa", "1", "--lambda", "1:2:3"][..], "--map takes two or more finite, increasing"),
        (
            &["--kappa", "1:1.5:3", "--lambda", "1,inf"],
            "--map takes two or more finite, increasing",
        ),
        (
            &["--kappa", "1.5:1:3", "--lambda", "1:2:3"],
            "--map takes two or more finite, increasing",
        ),
        (&["--chi", "1:2:3", "--psi", "1:2:3", "--plot", "b.svg"], "cannot be used with"),
        (&["--chi", "1:2:3", "--psi", "1:2:3", "--tensor", "tangent"], "--velocity-ratio <VALUE>"),
        (
            &["--chi", "1:2:3", "--psi", "1:2:3", "--tensor", "tangent", "--velocity-ratio", "nan"],
            "--velocity-ratio = NaN is out of range: must be finite and >= 0",
        ),
        (
            &["--chi", "1:2:3", "--psi", "1:2:3", "--tensor", "mean"],
            "possible values: secant, tangent",
        ),
    ] {
        let map = fresh("bad-map.svg");
        let output =
            carom(&[&["restitution", "--map", map.to_str().unwrap()][..], arguments].concat());
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{stderr}");
        assert!(stderr.contains(expected), "{stderr}");
        assert!(output.stdout.is_empty() && !map.exists());
    }
}

#[test]
fn tensors_are_given_by_name() {
    // Sliding throughout, R_x = -1 + 2 chi/psi: v_xE = v_x - 2 (chi/psi) v_x, and psi v_z/v_x is
    // constant, so dv_xE/dv_x = 1 and dv_xE/dv_z = -2 (chi/psi) v_x/v_z.
    let sliding = ["restitution", "--chi", "2", "--psi", "8", "--velocity-ratio", "0.25"];
    let tangent = json(&[&sliding[..], &["--tensor", "tangent"]].concat());
    assert_eq!(tangent[0]["tensor"]["name"], "tangent");
    let rows = &tangent[0]["tensor"]["rows"];
    close(&rows[0][0], -1.0, 1e-15);
    close(&rows[0][2], 0.5 * 0.25, 1e-15);
    close(&rows[1][1], -0.5, 1e-15);
    close(&rows[2][0], 0.0, 0.0);
    let secant = json(&[&sliding[..], &["--tensor", "secant"]].concat());
    close(&secant[0]["tensor"]["rows"][0][0], -0.5, 0.0);
    close(&secant[0]["tensor"]["rows"][0][2], 0.0, 0.0);
    let csv = stdout(&[&sliding[..], &["--tensor", "secant", "--format", "csv"]].concat());
    assert!(csv.starts_with("chi,psi,R_x,regimes,tensor,R_xx,R_xy,R_xz,R_yx"));
    assert!(csv.ends_with("secant,-0.5,0,0,0,-0.5,0,0,0,1\n"), "{csv}");
}

/// Torque of the traction around the normal over the contact, by the trapezoidal rule.
fn torque_of_tractions(step: &serde_json::Value) -> f64 {
    let a = step["semi_axis_a"].as_f64().unwrap();
    let tractions = step["tractions"].as_array().unwrap();
    let length = a / (tractions.len() - 1) as f64;
    let part = |traction: &serde_json::Value| {
        let rho = a * traction["radius"].as_f64().unwrap();
        2.0 * std::f64::consts::PI * rho * rho * traction["t_twist"].as_f64().unwrap() * length
    };
    tractions.iter().map(part).sum()
}

#[test]
fn a_twist_turns_back_with_memory_and_slides_at_the_limit() {
    let steps = "steps = [[1e-6, 0, 0], [1e-6, 0, 0, 2e-3], [1e-6, 0, 0, -1e-3], \
                 [0.8e-6, 0, 0, -1e-3], [0.8e-6, 1e-8, 0, 1], [-1e-6, 0, 0, 1]]";
    let case = history("twist.toml", "0.3", steps);
    let rows = json(&["history", &case, "--tractions", "2001"]);
    let number = |row: usize, name: &str| rows[row][name].as_f64().unwrap();
    assert_eq!(number(0, "M_z"), 0.0);
    assert!(number(1, "M_z") > 0.0 && number(2, "M_z") < 0.0);
    for row in 1..5 {
        let (own, by_tractions) = (number(row, "M_z"), torque_of_tractions(&rows[row]));
        let limit = 3.0 * std::f64::consts::PI / 16.0
            * (0.3 * number(row, "F_z") * number(row, "semi_axis_a"));
        assert!((own - by_tractions).abs() < 1e-4 * limit, "{row}: {own} {by_tractions}");
        assert!(own.abs() <= limit * (1.0 + 1e-12));
        // Coulomb's bound at every radius.
        for traction in rows[row]["tractions"].as_array().unwrap() {
            let of = |name: &str| traction[name].as_f64().unwrap();
            let most = of("limit") + 1e-5 * rows[row]["tractions"][0]["limit"].as_f64().unwrap();
            assert!(of("t_twist").abs() <= most, "{traction}");
        }
    }
    let stick = number(1, "twist_stick_semi_axis_a") / number(1, "semi_axis_a");
    assert!(stick > 0.1 && stick < 0.99 && rows[1]["twist_regime"] == "slip");
    assert_eq!(rows[0]["twist_regime"], "adhesion");
    let slid =
        3.0 * std::f64::consts::PI / 16.0 * 0.3 * number(4, "F_z") * number(4, "semi_axis_a");
    assert!((number(4, "M_z") / slid - 1.0).abs() < 1e-12);
    assert_eq!(rows[4]["twist_regime"], "sliding");
    assert_eq!((&rows[5]["twist_regime"], number(5, "M_z")), (&"separated".into(), 0.0));
    let text = stdout(&["history", &case]);
    assert!(text.contains("twist_stick_semi_axis_b"));
    // Without a twist there is no torsion in the output.
    let plain = history("plain.toml", "0.3", "steps = [[1e-6, 0, 0, 0]]");
    assert!(!stdout(&["history", &plain]).contains("M_z"));
}

#[test]
fn twists_of_ellipses_and_with_shifts_carry_warnings() {
    let steps = "steps = [[1e-6, 0, 0], [1e-6, 2e-7, 1e-7, 2e-3]]";
    let file = history("both.toml", "0.3", steps);
    let text = std::fs::read_to_string(&file).unwrap();
    let stderr = |file: &str| {
        let output = carom(&["history", file, "--tractions", "5"]);
        assert!(output.status.success());
        String::from_utf8(output.stderr).unwrap()
    };
    assert!(
        stderr(&file).contains("shift and twist are computed each as if the other were absent")
    );
    let ellipse = case("ellipse.toml", &text.replacen("radii = 0.01", "radii = [0.01, 0.03]", 1));
    assert!(stderr(&ellipse).contains("the contact is no circle"));
    let rows = json(&["history", &ellipse, "--tractions", "5"]);
    assert!(rows[1]["M_z"].as_f64().unwrap() > 0.0);
    assert!(rows[1]["tractions"][2].get("t_twist").is_none());
    // Infinite friction sticks, none lets go.
    for (friction, regime) in [("inf", "adhesion"), ("0", "sliding")] {
        let case = history("limit.toml", friction, steps);
        let rows = json(&["history", &case]);
        assert_eq!(rows[1]["twist_regime"], regime);
        assert_eq!(rows[1]["M_z"].as_f64().unwrap() > 0.0, friction == "inf");
    }
}
