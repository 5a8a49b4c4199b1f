//! `carom roll` driven by forces, in any direction, on any gap.

use crate::common::{carom, case, close, example, json, number, refusal};
use serde_json::Value;

/// A circular contact between bodies of unlike material.
const CASE: &str = r#"
[body_1]
material = { shear_modulus = "80 GPa", poisson = 0.3 }
[body_2]
material = { shear_modulus = "30 GPa", poisson = 0.2 }
[contact]
radii = ["20 mm", "40 mm"]
F_z = "1 kN"
friction = 0.3
[rolling]
speed = 2
DRIVE
[grid]
elements = 24
"#;

fn first(name: &str, text: &str) -> Value {
    json(&["roll", &case(name, text)])[0].clone()
}

fn driven(name: &str, drive: &str) -> Value {
    first(name, &CASE.replace("DRIVE", drive))
}

/// Every printed digit, and every count of cells that stick.
#[test]
fn the_cylinders_agree_with_contact() {
    let rows = json(&["roll", &example("roll_cylinders.toml")]);
    // CONTACT's creepage is that of body 1 against body 2.
    for (row, (creepage, p_max, stick)) in rows.as_array().unwrap().iter().zip([
        (-4.294e-4, 103.6e6, 125.0),
        (-2.108e-4, 103.2e6, 36.0),
        (-5.392e-4, 103.3e6, 106.0),
    ]) {
        close(&row["creepage"], creepage, 0.5e-7);
        close(&row["peak_pressure"], p_max, 0.05e6);
        close(&row["stick_area"], 1e-6 * stick, 1e-12);
        // A cell of half the width: the error is its estimate, not that of the whole grid.
        assert!(number(row, "creepage_error") < 2e-5, "{row}");
        assert!(number(row, "wear_number") > 0.0);
    }
}

/// Carter's force of a line near the creepage at which all slides: cells that slide on all grids do not prove it.
#[test]
fn an_area_too_small_to_stick_on_the_grid_is_part_of_the_error() {
    let (friction, radius, force) = (0.3, 0.02, 1e6);
    // a^2 = 4 F R/(pi E*) per length, E* = G/(1 - nu) of like bodies.
    let a = (4.0 * force * radius / std::f64::consts::PI / (80e9 / 0.7)).sqrt();
    for (elements, part) in [(12, 0.847), (16, 0.9), (20, 0.933), (32, 0.942), (80, 0.979)] {
        let text = CASE
            .replace("30 GPa\", poisson = 0.2", "80 GPa\", poisson = 0.3")
            .replace(
                "radii = [\"20 mm\", \"40 mm\"]\nF_z = \"1 kN\"",
                "radius = 0.02\nlength = 0.01\nF_z = 1e4",
            )
            .replace("DRIVE", &format!("creepage = {}", part * friction * a / radius))
            .replace("elements = 24", &format!("elements = {elements}"));
        let row = first(&format!("carter_{elements}.toml"), &text);
        let carter = friction * 1e4 * (1.0 - (1.0 - part).powi(2));
        let (off, error) = (number(&row, "F_x") - carter, number(&row, "F_x_error"));
        assert!(off.abs() < error && error < 0.04 * carter, "{elements}: {off} {error}");
    }
}

#[test]
fn by_force_is_as_by_creepage() {
    let given = "creepage = 0.0008\ncreepage_across = -0.0005\nspin = \"2 rad/m\"";
    let by = driven("drives_creepage.toml", given);
    let [x, y, m] = ["F_x", "F_y", "M_z"].map(|name| number(&by, name));
    for (i, drive) in [
        format!("F_x = {x}\ncreepage_across = -0.0005\nspin = 2"),
        format!("creepage = 0.0008\nF_y = {y}\nspin = 2"),
        format!("creepage = 0.0008\ncreepage_across = -0.0005\nM_z = {m}"),
        format!("F_x = {x}\nF_y = {y}\nM_z = {m}"),
    ]
    .iter()
    .enumerate()
    {
        let row = driven(&format!("drives_{i}.toml"), drive);
        for (name, scale) in
            [("creepage", 8e-4), ("creepage_across", 5e-4), ("spin", 2.0), ("F_x", x), ("F_y", y)]
        {
            close(&row[name], number(&by, name), 1e-7 * f64::abs(scale));
        }
    }
}

/// Columns along x, those along y, and the sign of those along x after a quarter turn.
const TURNED: [(&str, &str, f64); 4] = [
    ("creepage", "creepage_across", -1.0),
    ("F_x", "F_y", -1.0),
    ("creepage_error", "creepage_across_error", 1.0),
    ("F_x_error", "F_y_error", 1.0),
];

/// Turned by a quarter with its ellipse and creepages, a contact has the same columns, those along x and y exchanged.
#[test]
fn a_quarter_turn_exchanges_the_columns_along_x_and_y() {
    let given = "creepage = 0.0004\ncreepage_across = -0.0007\nspin = 2";
    let turned = "direction = 90\ncreepage = 0.0007\ncreepage_across = 0.0004\nspin = 2";
    let found = "creepage = 0.0004\nF_y = -60\nspin = 2";
    let turned_found = "direction = 90\nF_x = 60\ncreepage_across = 0.0004\nspin = 2";
    for (name, drive, turned) in [("given", given, turned), ("found", found, turned_found)] {
        let own = driven(&format!("drives_{name}.toml"), drive);
        let case = CASE.replace("[\"20 mm\", \"40 mm\"]", "[\"40 mm\", \"20 mm\"]");
        let up = first(&format!("drives_{name}_up.toml"), &case.replace("DRIVE", turned));
        for (column, value) in own.as_object().unwrap() {
            let Some(value) = value.as_f64() else {
                assert_eq!(up[column], own[column], "{column}");
                continue;
            };
            let place = TURNED.iter().find_map(|(x, y, sign)| match column.as_str() {
                column if column == *x => Some((*y, 1.0)),
                column if column == *y => Some((*x, *sign)),
                _ => None,
            });
            let (at, sign) = place.unwrap_or((column, 1.0));
            // What is given has an error of rounding alone; residuals are that as a whole.
            let size = match at.split('_').next() {
                Some("residual") => continue,
                Some("F" | "M") if at.ends_with("error") => 1e-3 * number(&own, "F_z"),
                _ => value.abs(),
            };
            let off = (number(&up, at) - sign * value).abs();
            assert!(off <= 1e-9 * size, "{name}, {column}: {value}, {at}: {}", up[at]);
        }
    }
}

/// FASTSIM's error is told of the whole force, not of one component.
#[test]
fn the_error_of_springs_is_that_of_both_components() {
    let drive = "creepage = 0.0004\ncreepage_across = -0.0007\nspin = 2";
    let file = case("drives_springs.toml", &CASE.replace("DRIVE", drive));
    let row = json(&["roll", &file, "--fastsim"])[0].clone();
    let off =
        ["F_x", "F_y"].map(|name| number(&row, &format!("{name}_springs")) - number(&row, name));
    let expected = off[0].hypot(off[1]) / (0.3 * number(&row, "F_z"));
    assert!(off.iter().all(|off| off.abs() > 10.0), "{off:?}");
    close(&row["springs_error"], expected, 1e-12);
}

const GAP: &str = r#"
[body_1]
material = { shear_modulus = "80 GPa", poisson = 0.3 }
[body_2]
material = { shear_modulus = "30 GPa", poisson = 0.2 }
[gap]
shape = "paraboloid"
radii = ["20 mm", "40 mm"]
[contact]
friction = 0.3
MAP
[rolling]
speed = 2
NORMAL
creepage = 0.0008
spin = 2
[grid]
cells = [48, 48]
size = ["1.6 mm", "2.2 mm"]
"#;

fn gap(name: &str, normal: &str, map: &str) -> Value {
    first(name, &GAP.replace("NORMAL", normal).replace("MAP", map))
}

#[test]
fn a_gap_rolls_as_the_ellipse_that_it_is() {
    let by_force = gap("drives_gap.toml", "F_z = \"1 kN\"", "");
    let ellipse = driven("drives_ellipse.toml", "creepage = 0.0008\nspin = 2");
    // The grids differ: within the estimates of both.
    for name in ["F_x", "F_y", "M_z", "zeta", "peak_pressure"] {
        let error = format!("{name}_error");
        let most = number(&by_force, &error) + number(&ellipse, &error);
        close(&by_force[name], number(&ellipse, name), most);
        let size = if name == "M_z" { 1.0 } else { 0.2 * number(&ellipse, name).abs() };
        assert!(most < size, "{name}: {most}");
    }
    let approach = format!("zeta = {}", number(&by_force, "zeta"));
    let by_approach = gap("drives_approach.toml", &approach, "");
    for name in ["F_x", "F_y", "F_z", "M_z"] {
        close(&by_approach[name], number(&by_force, name), 1e-7 * number(&by_force, name).abs());
    }
}

/// Half of the coefficient everywhere is half of the coefficient; half of it for y < 0 turns the
/// bodies.
#[test]
fn friction_may_differ_from_cell_to_cell() {
    let uniform = vec![vec!["0.5"; 48].join(","); 48].join("\n");
    let map = format!("friction_map = {:?}", case("drives_map.csv", &uniform));
    let mapped = gap("drives_map.toml", "F_z = 1000", &map);
    let half = first(
        "drives_half.toml",
        &GAP.replace("NORMAL", "F_z = 1000").replace("MAP", "").replace("0.3\n\n", "0.15\n\n"),
    );
    for name in ["F_x", "F_y", "M_z", "used"] {
        close(&mapped[name], number(&half, name), 1e-9 * number(&half, name).abs());
    }
    let rows = json(&["roll", &example("roll_wet_rail.toml")]);
    let last = rows.as_array().unwrap().last().unwrap();
    // The greater force acts at y > 0, along +x; the torque has the sign of y F_x.
    let (f_x, m_z) = (number(last, "F_x"), number(last, "M_z"));
    assert!(f_x > 0.0 && m_z > 1e-4 * f_x, "{last}");
    close(&last["used"], 1.0, 0.01);
    close(&last["adhesion"], 0.5 * (0.3 + 0.15), 0.003);
}

#[test]
fn an_accuracy_chooses_the_grid() {
    let text =
        CASE.replace("elements = 24", "accuracy = 0.03").replace("DRIVE", "creepage = 0.0006");
    let row = first("drives_accuracy.toml", &text);
    let fine = first("drives_fine.toml", &text.replace("accuracy = 0.03", "elements = 160"));
    let f_x = number(&fine, "F_x");
    assert!(number(&row, "F_x_error") < 0.03 * f_x, "{row}");
    close(&row["F_x"], f_x, 0.03 * f_x);
}

/// Bodies of one material: what the loads do is heat. Of unlike materials the pressures work too:
/// where the whole contact slides, heat is friction times force times the mean slip, which is the
/// creepage less what the pressures stretch the surfaces.
#[test]
fn the_wear_number_is_the_heat() {
    let alike = CASE
        .replace("30 GPa\", poisson = 0.2", "80 GPa\", poisson = 0.3")
        .replace("DRIVE", "creepage = 0.0012\ncreepage_across = 0.0003\nspin = 2");
    let row = first("drives_heat.toml", &alike);
    let (heat, power) = (number(&row, "heating"), number(&row, "power"));
    close(&row["heating"], power, 1e-9 * power);
    close(&row["wear_number"], heat / 2.0, 1e-12 * heat);
    // Freely rolling cylinders of unlike materials: some slip, no power.
    let rows = json(&["roll", &example("roll_cylinders.toml")]);
    let free = &rows[0];
    assert!(number(free, "power").abs() < 1e-9);
    let stretch = 4.3e-4 * 0.05 * 16201.9;
    assert!((1e-3..0.1).contains(&(number(free, "wear_number") / stretch)), "{free}");
    for row in rows.as_array().unwrap() {
        assert!(number(row, "wear_number") > 0.0, "{row}");
    }
    // Where all cells slide: pressures p stretch the surface of a body by (1 - 2 nu) p/(2 G), so that
    // heat is f (F_z |xi| -+ D), D the integral of p times the difference of both stretches.
    let text = std::fs::read_to_string(example("roll_cylinders.toml")).unwrap();
    let sliding = text.replace("F_x = [0, \"607.6 N\", \"-607.6 N\"]", "creepage = [-0.02, 0.02]");
    let rows = json(&["roll", &case("drives_slide.toml", &sliding)]);
    let [one, other] = [0, 1].map(|row| number(&rows[row], "wear_number"));
    let stretch = 0.38 / (2.0 * 23e9) - 0.44 / (2.0 * 82e9);
    let peak = number(&rows[0], "peak_pressure");
    let half_width: f64 = 2.0 * 16201.9 / (std::f64::consts::PI * peak);
    let work = stretch * 4.0 / 3.0 * peak * peak * half_width;
    assert!(rows[0]["slides"] == "yes" && rows[1]["slides"] == "yes");
    let (mean, half) = (0.5 * (one + other), 0.5 * (one - other).abs());
    assert!((mean / (0.05 * 16201.9 * 0.02) - 1.0).abs() < 1e-6, "{mean}");
    assert!((half / (0.05 * work) - 1.0).abs() < 0.01, "{half} {}", 0.05 * work);
}

#[test]
fn what_cannot_be_driven_is_refused_by_name() {
    for (base, old, new, parts) in [
        (
            CASE,
            "DRIVE",
            "F_x = 301",
            vec!["`rolling.F_x` = 301", "below friction times F_z, 300 N"],
        ),
        (CASE, "DRIVE", "F_x = 200\nF_y = -250", vec!["`rolling.F_y` = -250", "together"]),
        (CASE, "DRIVE", "F_x = 1\ncreepage = 0", vec!["rolling.F_x", "rolling.creepage", "one of"]),
        (CASE, "DRIVE", "F_z = 10", vec!["rolling.F_z", "contact.F_z"]),
        (CASE, "DRIVE", "spin_offset = 2", vec!["`rolling.spin_offset` = 2", "[-1, 1]"]),
        (CASE, "DRIVE", "direction = \"west\"", vec!["rolling.direction", "deg"]),
        (CASE, "DRIVE", "distance = 0.01\nstep = 1e-12", vec!["`rolling.step` = ", "steps"]),
        (CASE, "elements = 24", "cells = [10, 10]", vec!["grid.cells", "elements"]),
        (GAP, "NORMAL", "", vec!["rolling.F_z", "is missing", "`zeta`"]),
        (GAP, "cells = [48, 48]", "elements = 12", vec!["grid.elements", "`cells`"]),
        (GAP, "spin = 2", "distance = 0.23", vec!["`rolling.distance` = 0.23", "of the grid"]),
        (GAP, "MAP", "F_z = 3", vec!["contact.F_z", "rolling.F_z"]),
        (GAP, "NORMAL", "F_z = \"1000 MN\"", vec!["reaches", "border"]),
    ] {
        let text = base.replace(old, new).replace("NORMAL", "F_z = 1000").replace("MAP", "");
        let said = refusal(&["roll", &case("drives_bad.toml", &text.replace("DRIVE", ""))]);
        assert!(parts.iter().all(|part| said.contains(part)), "{said} lacks one of {parts:?}");
    }
}

/// A hundred times the longer side of the grid may be rolled, whichever it is.
#[test]
fn the_longer_side_of_a_grid_limits_the_distance() {
    let far = GAP.replace("spin = 2", "distance = 0.21").replace("NORMAL", "F_z = 1000");
    let turned = far.replace("[\"1.6 mm\", \"2.2 mm\"]", "[\"2.2 mm\", \"1.6 mm\"]");
    for (name, text) in [("far.toml", &far), ("far_turned.toml", &turned)] {
        let output = carom(&["check", &case(name, &text.replace("MAP", ""))]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
}
