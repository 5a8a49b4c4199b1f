//! `carom roll` as a user meets it.

use crate::common::{carom, case, close, example, json, refusal, stdout};

/// A circular contact of radius 1 mm.
const CASE: &str = r#"
[body_1]
material = { shear_modulus = "80 GPa", poisson = 0.25 }
[body_2]
material = { shear_modulus = "80 GPa", poisson = 0.25 }
[contact]
semi_axes = ["1 mm", "1 mm"]
F_z = "1 kN"
friction = 0.3
[rolling]
speed = 2
CREEP
[grid]
elements = 16
"#;

fn with(name: &str, creep: &str) -> String {
    case(name, &CASE.replace("CREEP", creep))
}

#[test]
fn small_creepage_gives_the_creep_coefficients() {
    let name = "roll_small.toml";
    let creep = "creepage = [1e-6, 0, 0]\ncreepage_across = [0, 1e-6, 0]\nspin = [0, 0, 1e-3]";
    let both = json(&["roll", &with(name, creep), "--coefficients"]);
    let (rows, c) = (&both["rows"], &both["coefficients"]);
    // Kalker 1990, table E.3.
    for (name, printed) in [("C11", 4.12), ("C22", 3.67), ("C23", 1.47), ("C32", 1.47)] {
        close(&c[name], printed, 5e-3 * printed);
    }
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let unit = 80e9 * 1e-6 * 1e-6;
    // First order in the mesh, the area of whose cells is 3.5 % larger than the ellipse.
    close(&rows[0]["F_x"], unit * number(&c["C11"]), 0.07 * unit * number(&c["C11"]));
    close(&rows[1]["F_y"], unit * number(&c["C22"]), 0.07 * unit * number(&c["C22"]));
    close(&rows[2]["F_y"], -unit * number(&c["C23"]), 0.12 * unit * number(&c["C23"]));
    close(&rows[1]["F_z"], 1000.0, 1e-5);
    close(&rows[0]["power"], 2.0 * 1e-6 * number(&rows[0]["F_x"]), 1e-12);
}

#[test]
fn full_sliding_is_said_and_brings_no_more_force() {
    let file = with("roll_slides.toml", "creepage = [0.02, 0.05]");
    let output = carom(&["roll", &file, "--format", "csv"]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("full sliding in 2 of 2 rows"));
    // A table to read leaves the residuals out.
    assert!(String::from_utf8_lossy(&output.stdout).contains(",residual_normal,"));
    assert!(!stdout(&["roll", &file]).contains("residual_normal"));
    let rows = json(&["roll", &file]);
    for row in rows.as_array().unwrap() {
        assert_eq!(row["slides"], "yes");
        close(&row["used"], 1.0, 1e-3);
        close(&row["stick_area"], 0.0, 0.0);
    }
}

#[test]
fn rolling_from_rest_ends_in_the_steady_state() {
    let creep = "creepage = 1e-3\nspin = 0.1";
    let steady = json(&["roll", &with("roll_steady.toml", creep)]);
    let way = format!("{creep}\ndistance = \"16 mm\"");
    let rows = json(&["roll", &with("roll_way.toml", &way)]);
    let rows = rows.as_array().unwrap();
    assert_eq!(rows.len(), 129);
    close(&rows[0]["F_x"], 0.0, 1e-9);
    let last = &rows[128];
    close(&last["distance"], 0.016, 1e-12);
    close(&last["time"], 0.008, 1e-12);
    close(&last["creepage"], 1e-3, 1e-12);
    close(&last["spin"], 0.1, 1e-9);
    let limit = 0.3 * 1000.0;
    for load in ["F_x", "F_y"] {
        close(&last[load], steady[0][load].as_f64().unwrap(), 1e-6 * limit);
    }
}

#[test]
fn the_wheel_on_the_rail_comes_near_to_fastsim() {
    let rows = json(&["roll", &example("roll_wheel_on_rail.toml"), "--fastsim"]);
    for row in rows.as_array().unwrap() {
        let limit = 0.3 * row["F_z"].as_f64().unwrap();
        for (own, springs) in [("F_x", "F_x_springs"), ("F_y", "F_y_springs")] {
            close(&row[own], row[springs].as_f64().unwrap(), 0.1 * limit);
        }
    }
}

/// Two methods: the solver, with the error of its mesh, and the stored solutions of the continuum.
#[test]
fn the_wheel_on_the_rail_is_in_the_table_of_creep_forces() {
    let rows = json(&["roll", &example("roll_wheel_on_rail.toml"), "--table"]);
    for row in rows.as_array().unwrap() {
        let value = |name: &str| row[name].as_f64().unwrap();
        for force in ["F_x", "F_y"] {
            // The grid is coarse, and its error estimated from coarser ones.
            let allowed = 2.0 * value(&format!("{force}_error")) + value("table_error");
            close(&row[force], value(&format!("{force}_table")), allowed);
        }
        assert!(value("table_error") < 0.01 * 0.3 * value("F_z"));
    }
    let unlike = CASE.replacen("poisson = 0.25", "poisson = 0.4", 1).replace("CREEP", "");
    for (file, part) in [
        (with("roll_way_table.toml", "creepage = 1e-3\ndistance = 0.001"), "steady state"),
        (case("roll_unlike_table.toml", &unlike), "like materials"),
    ] {
        let said = refusal(&["roll", &file, "--table"]);
        assert!(said.contains(part), "{said}");
    }
}

/// Friction of each cell by its own slip speed: at rest as with the number a + b, at high speed with a.
#[test]
fn friction_may_fall_with_the_slip_speed() {
    let friction = |text: &str, creep: &str| {
        let text = CASE.replace("friction = 0.3", text).replace("CREEP", creep);
        json(&["roll", &case("roll_by_slip.toml", &text)])
    };
    let by_slip = "friction = { a = 0.1, b = 0.2, c = \"50 s/m\" }";
    for (creep, number) in
        [("creepage = 1e-6", "friction = 0.3"), ("creepage = 0.2", "friction = 0.1")]
    {
        let [own, constant] = [by_slip, number].map(|text| friction(text, creep));
        close(&own[0]["F_x"], constant[0]["F_x"].as_f64().unwrap(), 0.002 * 300.0);
    }
    let [own, constant] = [by_slip, "friction = 0.3"].map(|text| friction(text, "creepage = 2e-3"));
    let [own, constant] = [own, constant].map(|rows| rows[0]["F_x"].as_f64().unwrap());
    assert!(own < 0.98 * constant && own > 0.3 * constant, "{own} {constant}");
    for (text, part) in [
        (CASE.replace("friction = 0.3", by_slip).replace("CREEP", "distance = 0.001"), "from rest"),
        (
            CASE.replace("friction = 0.3", "friction = { a = 0, b = 0.2, c = 1 }")
                .replace("CREEP", ""),
            "positive",
        ),
    ] {
        let said = refusal(&["roll", &case("roll_by_slip_bad.toml", &text)]);
        assert!(said.contains(part), "{said}");
    }
}

/// Carter's force of two cylinders, with q = F_z/L: a^2 = 4 q R/(pi E*), F_x/(f F_z) = 1 - (1 - c R/(f a))^2.
#[test]
fn a_line_rolls_as_carter_says() {
    let line = "radius = \"5 mm\"\nlength = \"20 mm\"";
    let text = CASE.replace("semi_axes = [\"1 mm\", \"1 mm\"]", line).replace("elements = 16", "");
    let with = |name: &str, creep: &str| case(name, &text.replace("CREEP", creep));
    let creepages = [-2e-3_f64, -5e-4, 0.0, 1e-4, 2e-3, 1e-2];
    let rows =
        json(&["roll", &with("roll_line.toml", &format!("creepage = {creepages:?}")), "--table"]);
    // E* = G/(1 - nu) of two like bodies.
    let a = (4.0 * 1000.0 / 0.02 * 0.005 / (std::f64::consts::PI * 80e9 / 0.75)).sqrt();
    for (row, creepage) in rows.as_array().unwrap().iter().zip(creepages) {
        let part = (creepage.abs() * 0.005 / (0.3 * a)).min(1.0);
        let wanted = 300.0 * (1.0 - (1.0 - part).powi(2)).copysign(creepage);
        close(&row["F_x_table"], wanted, 1e-12 * 300.0);
        close(&row["F_x"], wanted, (row["F_x_error"].as_f64().unwrap()).max(1e-9));
        assert!(row["error"].as_f64().unwrap() < 0.01);
        // The pressure of a row of cells is that in the middle of half-spaces pressed along the length.
        close(&row["peak_pressure"], 2.0 * 1000.0 / (std::f64::consts::PI * a * 0.02), 2e6);
    }
    for (name, creep, option, part) in [
        ("roll_line_spin.toml", "spin = 1", "--table", "creepage along x"),
        ("roll_line_springs.toml", "creepage = 1e-3", "--fastsim", "Carter"),
        ("roll_line_coefficients.toml", "creepage = 1e-3", "--coefficients", "Carter"),
    ] {
        let said = refusal(&["roll", &with(name, creep), option]);
        assert!(said.contains(part), "{said}");
    }
}

#[test]
fn what_cannot_roll_is_refused_by_name() {
    for (old, new, parts) in [
        ("speed = 2", "speed = 0", vec!["`rolling.speed` = 0", "> 0"]),
        ("F_z = \"1 kN\"", "F_z = 0", vec!["`contact.F_z` = 0"]),
        ("friction = 0.3", "friction = 0", vec!["`contact.friction` = 0"]),
        ("CREEP", "spin = nan", vec!["`rolling.spin` = NaN"]),
        (
            "CREEP",
            "spin = [1, 2]\ncreepage = [0, 1, 2]",
            vec!["rolling.spin", "same number of values"],
        ),
        (
            "CREEP",
            "creepage = [0, 1]\ndistance = 0.01",
            vec!["rolling.distance", "rolling.creepage", "a single value"],
        ),
        ("CREEP", "distance = 1", vec!["`rolling.distance` = 1", "100 lengths"]),
        ("elements = 16", "elements = 600", vec!["grid.elements", "6 to 512"]),
        (
            "friction = 0.3",
            "friction = 0.3\nradii = [1, 1]",
            vec!["contact.radii", "contact.semi_axes", "give one of"],
        ),
        ("semi_axes = [\"1 mm\", \"1 mm\"]", "", vec!["contact.semi_axes", "`radii`"]),
        ("semi_axes = [\"1 mm\", \"1 mm\"]", "radius = 0.01", vec!["contact.length", "missing"]),
        ("friction = 0.3", "friction = 0.3\nlength = 1", vec!["contact.length", "give one of"]),
        (
            "semi_axes = [\"1 mm\", \"1 mm\"]",
            "radius = 1\nlength = 1e-4",
            vec!["contact.F_z", "as wide as long"],
        ),
    ] {
        let file = case("roll_bad.toml", &CASE.replace(old, new).replace("CREEP", ""));
        let said = refusal(&["roll", &file]);
        assert!(parts.iter().all(|part| said.contains(part)), "{said} lacks one of {parts:?}");
    }
    let file = with("roll_way_springs.toml", "creepage = 1e-3\ndistance = 0.001");
    refusal(&["roll", &file, "--fastsim"]);
    // Slender beyond what creep coefficients are found for.
    let text = CASE.replace("[\"1 mm\", \"1 mm\"]", "[\"1 mm\", \"30 mm\"]").replace("CREEP", "");
    let said = refusal(&["roll", &case("roll_slender.toml", &text), "--coefficients"]);
    assert!(said.contains("a/b"), "{said}");
}
