//! Impacts of bodies of any smooth shape: results of the command.

use crate::common::pebble::{CASE, all_close, changed, numbers, solved};
use crate::common::{case, example, json, refusal, stdout};
use std::path::Path;

#[test]
fn energy_and_momentum_balance() {
    let text = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/crossed_capsules.toml"),
    );
    let record = solved("balance", &text.unwrap());
    let number = |name: &str| record[name].as_f64().unwrap();
    let lost = number("energy_before") - number("energy_after") - number("energy_dissipated");
    assert!(lost.abs() < 1e-12 * number("energy_before"), "{lost}");
    let velocity = |of: &serde_json::Value, body: &str| numbers(&of[format!("{body}_velocity")]);
    for axis in 0..3 {
        let sum = |of| velocity(of, "body_1")[axis] + velocity(of, "body_2")[axis];
        assert!((sum(&record["before"]) - sum(&record)).abs() < 1e-12);
    }
    assert_eq!(record["method"], "spatial");
    assert!(number("error_estimate") > 1e-5 && number("error_estimate") < 1e-2);
    assert!(record["events"].as_array().unwrap().len() > 1);
}

#[test]
fn laws_differ_where_the_direction_turns() {
    let text = CASE
        .replace("quaternion = [1, 0, 0, 0]", "angles = [10, 20, 30]")
        .replace("position = [0, 0, 0.015]", "position = [0, 0, 0.1]")
        + "search = \"approach\"\n";
    let coulomb = solved("coulomb", &(text.clone() + "law = \"coulomb\"\n"));
    let fixed = solved("fixed", &(text + "law = \"fixed-direction\"\n"));
    assert_eq!(fixed["contact"]["law"], "fixed-direction");
    let of = |record: &serde_json::Value| numbers(&record["body_1_velocity"]);
    let off = (of(&coulomb)[0] - of(&fixed)[0]).abs();
    assert!(off > 1e-7 && off < 0.05, "{off}");
}

#[test]
fn the_course_begins_and_ends_with_the_outcome() {
    let file = case("course.toml", &changed("quaternion = [1, 0, 0, 0]", "angles = [0, 0, 40]"));
    let arguments = ["impact", &file, "--history", "201", "--format"];
    let record: serde_json::Value =
        serde_json::from_str(&stdout(&[&arguments[..], &["json"]].concat())).unwrap();
    let samples = record["history"].as_array().unwrap();
    assert_eq!(samples.len(), 201);
    let axes = ["x_axis", "y_axis", "z_axis"].map(|axis| numbers(&record["contact"][axis]));
    let space = |sample: &serde_json::Value| -> Vec<f64> {
        let parts = numbers(&sample["v"]);
        (0..3).map(|i| (0..3).map(|j| axes[j][i] * parts[j]).sum()).collect()
    };
    all_close(&space(&samples[0]), &numbers(&record["contact_velocity_before"]), 1e-12);
    all_close(&space(&samples[200]), &numbers(&record["contact_velocity_after"]), 1e-5);
    let peak = samples.iter().map(|s| s["F"][2].as_f64().unwrap()).fold(0.0, f64::max);
    assert!((peak / record["maximal_force"].as_f64().unwrap() - 1.0).abs() < 1e-3);
    let rows = stdout(&[&arguments[..], &["csv"]].concat());
    assert_eq!(rows.lines().count(), 202);
    assert!(rows.starts_with("time,xi,eta,zeta,v_x"));
    let csv = stdout(&["impact", &file, "--format", "csv"]);
    assert!(csv.lines().next().unwrap().ends_with("normal_x,normal_y,normal_z"));
    assert!(stdout(&["impact", &file]).contains("method"));
}

#[test]
fn simple_cases_take_law_and_torsion_too() {
    let simple = CASE
        .replace("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", "shape = \"sphere\"\nradius = 0.02")
        .replace("inertia = [1.2e-5, 2.2e-5, 2.6e-5]\nquaternion = [1, 0, 0, 0]\nposition = [0, 0, 0.015]\n", "")
        .replace("70e9, poisson = 0.22", "20e6, poisson = 0.5");
    let left = solved("left", &(simple.clone() + "torsion = false\n"));
    let with = solved("with", &(simple.clone() + "torsion = true\nlaw = \"fixed-direction\"\n"));
    let spin = |record: &serde_json::Value| numbers(&record["body_1_spin"])[2];
    assert_eq!(spin(&left), 20.0);
    assert!(left["warnings"].to_string().contains("torsion is not computed"));
    assert!(spin(&with) < 19.5 && spin(&with) > 10.0);
    assert!(!with["warnings"].to_string().contains("torsion is not computed"));
    let number = |name: &str| with[name].as_f64().unwrap();
    let lost = number("energy_before") - number("energy_after") - number("energy_dissipated");
    assert!(lost.abs() < 1e-13 * number("energy_before"), "{lost}");
    let on_grid = solved("on-grid", &(simple.clone() + "law = \"numerical\"\n"));
    let restitution = |record: &serde_json::Value| record["R_x"].as_f64().unwrap();
    assert_eq!(on_grid["contact"]["law"], "numerical");
    assert!((restitution(&on_grid) - restitution(&left)).abs() < 0.02, "{}", on_grid["R_x"]);
    // So soft that the ball would be pressed flat: the slip turns back.
    let soft = simple.replace("20e6, poisson = 0.5", "2e4, poisson = 0").replace("20]", "60]")
        + "torsion = true\n";
    let torsion = solved("soft", &soft)["torsion"].clone();
    assert!(torsion["error_estimate"].as_f64().unwrap() > 1e-10, "{torsion}");
    assert!(torsion["spin_ratio"].as_f64().unwrap().abs() < 1.0, "{torsion}");
}

#[test]
fn the_greatest_contact_of_an_ellipsoid_has_two_semi_axes() {
    let record = solved("semi_axes", CASE);
    let [a, b] =
        ["maximal_semi_axis_a", "maximal_semi_axis_b"].map(|n| record[n].as_f64().unwrap());
    let ratio = record["contact"]["axis_ratio"].as_f64().unwrap();
    assert!(ratio < 0.9 && (a / b / ratio - 1.0).abs() < 1e-14, "{a} {b} {ratio}");
}

#[test]
fn a_restitution_without_a_direction_is_left_out() {
    let text = changed("velocity = [0.6, 0.4, -2]", "velocity = [0, 0, -2]");
    assert!(solved("straight", &text)["R_x"].is_null());
    let file = case("straight_csv.toml", &text);
    let csv = stdout(&["impact", &file, "--format", "csv"]);
    let [heads, cells] = [0, 1].map(|i| csv.lines().nth(i).unwrap().split(',').collect::<Vec<_>>());
    assert_eq!(cells[heads.iter().position(|head| *head == "R_x").unwrap()], "");
    // A ball has the limit of small tangential velocities, (9.46) with chi = 7 (1 - nu)/(2 - nu).
    let ball = text
        .replace("semi_axes = [0.03, 0.02, 0.015]", "semi_axes = [0.015, 0.015, 0.015]")
        .replace("[1.2e-5, 2.2e-5, 2.6e-5]", "\"solid\"");
    let limit = solved("straight_ball", &ball)["R_x"].as_f64().unwrap();
    let expected = carom_impact::closed_form::restitution_without_slip(7.0 * 0.78 / 1.78);
    assert!((limit - expected).abs() < 1e-12, "{limit} {expected}");
}

#[test]
fn any_body_may_come_at_an_angle_be_swept_and_scatter() {
    let approach = "[approach]\nspeed = 2\nangle = [0, 30, 60]\n[contact]";
    let coming = CASE.replace("velocity = [0.6, 0.4, -2]\n", "").replace("[contact]", approach);
    let records = solved("coming", &coming);
    assert_eq!(records.as_array().unwrap().len(), 3);
    for (record, angle) in records.as_array().unwrap().iter().zip([0.0, 30.0, 60.0_f64]) {
        assert_eq!(record["angle"], angle);
        let (sin, cos) = angle.to_radians().sin_cos();
        let before = numbers(&record["before"]["body_1_velocity"]);
        all_close(&before, &[2.0 * sin, 0.0, -2.0 * cos], 1e-15);
    }
    // Over sizes, without a place of its own: (5.4), a larger ellipsoid is flatter below.
    let sizes = changed("position = [0, 0, 0.015]\n", "")
        .replace("0.03, 0.02, 0.015]", "{ start = 0.02, stop = 0.03, count = 3 }, 0.02, 0.015]");
    let records = solved("sizes", &sizes);
    for (record, a) in records.as_array().unwrap().iter().zip([0.02_f64, 0.025, 0.03]) {
        assert_eq!(record["body_1.semi_axes.x"], a);
        let flat = record["contact"]["curvature_b"].as_f64().unwrap();
        assert!((flat / (0.5 * 0.015 / (a * a)) - 1.0).abs() < 1e-12, "{flat}");
    }
    // Without slip at the end.
    let gripping = solved("gripping", &changed("friction = 0.2", "friction = [0.2, inf]"));
    assert_eq!(gripping[1]["contact.friction"], "inf");
    assert_eq!(gripping[1]["regimes"], serde_json::json!(["adhesion"]));
    let scatter = changed("friction = 0.2", "friction = { uniform = { low = 0, high = 0.2 } }")
        + "[uncertainty]\nsamples = 20\nseed = 3\n";
    let report = solved("scatter", &scatter);
    assert_eq!(report["inputs"][0]["name"], "contact.friction");
    assert_eq!(report["samples"], 20);
    // A shell is slowed down less by its spin: D_xx = 5/2 of 1/m against 7/2.
    let ball = |inertia: &str| {
        let ball = format!("shape = \"sphere\"\nradius = 0.015\ninertia = \"{inertia}\"");
        let text = CASE
            .replace("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", &ball)
            .replace("inertia = [1.2e-5, 2.2e-5, 2.6e-5]\n", "")
            .replace("friction = 0.2", "friction = 0.02\nlaw = \"coulomb\"\ntorsion = false");
        solved(inertia, &text)["body_1_spin"].clone()
    };
    let (solid, shell) = (numbers(&ball("solid")), numbers(&ball("shell")));
    assert!(shell[1] > 0.0 && (shell[1] / solid[1] - 0.6).abs() < 1e-9, "{shell:?} {solid:?}");
}

#[test]
fn dissimilar_balls_are_thrown_back_by_the_numerical_law() {
    let record = json(&["impact", &example("dissimilar_balls.toml")]);
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    // An independent half-space program: 0.314 within 0.006.
    assert!((number(&record["R_x"]) - 0.314).abs() < 0.006, "{}", record["R_x"]);
    assert_eq!(record["contact"]["law"], "numerical");
    assert!(number(&record["error_estimate"]) < 1e-3);
    let said = |text: String| refusal(&["impact", &case("numerical_bad.toml", &text)]);
    let text = std::fs::read_to_string(example("dissimilar_balls.toml")).unwrap();
    let infinite = said(text.replace("friction = 0.1", "friction = inf"));
    assert!(infinite.contains("contact.friction"), "{infinite}");
    let twisted = said(format!("{text}torsion = true\n"));
    assert!(twisted.contains("contact.torsion"), "{twisted}");
}
