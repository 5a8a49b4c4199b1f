//! The pictures of contacts on a grid, and of rolling.

use super::{both, number, over_steps, shows};
use crate::common::picture::panels;
use crate::common::{case, example, fresh, stdout};
use serde_json::Value;

const SOLVE: &str = r#"
[body_1]
material = { shear_modulus = "1 MPa", poisson = 0.4 }
[body_2]
material = { shear_modulus = "3 MPa", poisson = 0.4 }
[gap]
shape = "paraboloid"
radii = ["20 mm", "12 mm"]
[grid]
cells = [24, 20]
size = ["6 mm", "5 mm"]
[contact]
friction = 0.3
[[step]]
F_z = 1
[[step]]
F_z = 1.5
F_x = 0.2
F_y = -0.1
M_z = 1e-4
count = 3
[[step]]
F_x = -0.1
F_y = 0.15
M_z = -5e-5
count = 2
"#;

#[test]
fn the_picture_of_a_contact_on_a_grid_shows_its_steps() {
    let file = case("picture_solve.toml", SOLVE);
    let (rows, drawn) = both(&["solve", &file], "picture_solve.svg");
    let rows = rows.as_array().unwrap();
    let forces = [["F_x", "F_x"], ["F_y", "F_y"], ["F_z", "F_z"]];
    shows(
        &drawn,
        rows,
        &[
            over_steps("forces on body 1", "force / N", &forces),
            (
                "load curves",
                ["shift / m", "force / N"],
                vec![("F_x against ξ", ["xi", "F_x"]), ("F_y against η", ["eta", "F_y"])],
            ),
            ("approach", ["ζ / m", "force / N"], vec![("F_z against ζ", ["zeta", "F_z"])]),
            ("torque", ["ω / rad", "torque / N m"], vec![("M_z against ω", ["omega", "M_z"])]),
            over_steps(
                "energy",
                "energy / J",
                &[["stored", "stored_energy"], ["dissipated", "dissipated"]],
            ),
            over_steps(
                "areas",
                "area / m²",
                &[["contact", "contact_area"], ["stick", "stick_area"]],
            ),
        ],
    );
    // The contact is longer along x, where the radius is larger; a unit is as long on both axes.
    let outlines = drawn.iter().find(|panel| panel.title.starts_with("tractions")).unwrap();
    let contact = outlines.curves("contact").concat();
    let span = |axis: usize| {
        let at = contact.iter().map(|point| point[axis]);
        at.clone().fold(f64::MIN, f64::max) - at.fold(f64::MAX, f64::min)
    };
    assert!(span(0) > 1.2 * span(1), "{} {}", span(0), span(1));
}

#[test]
fn the_picture_of_rolling_shows_its_rows() {
    let text = r#"
[body_1]
material = { shear_modulus = "80 GPa", poisson = 0.25 }
[body_2]
material = { shear_modulus = "80 GPa", poisson = 0.25 }
[contact]
semi_axes = ["3 mm", "6 mm"]
F_z = "60 kN"
friction = 0.25
[rolling]
speed = "10 m/s"
spin = "0.4 rad/m"
creepage = [-0.001, 0.0005, 0.001, 0.003]
creepage_across = 0.0008
[grid]
elements = 8
"#;
    let file = case("picture_roll.toml", text);
    let (rows, drawn) = both(&["roll", &file], "picture_roll.svg");
    let mut rows = rows.as_array().unwrap().clone();
    for row in &mut rows {
        for name in ["F_x", "F_y"] {
            row[format!("{name}_over")] = Value::from(number(row, name) / (0.25 * 60e3));
        }
    }
    let over = |curves: &[[&'static str; 2]]| {
        curves.iter().map(|[name, column]| (*name, ["creepage", *column])).collect::<Vec<_>>()
    };
    shows(
        &drawn,
        &rows,
        &[
            (
                "forces on body 1",
                ["creepage", "force/(f F_z)"],
                over(&[["F_x", "F_x_over"], ["F_y", "F_y_over"]]),
            ),
            ("torque on body 1", ["creepage", "M_z / N m"], over(&[["", "M_z"]])),
            (
                "areas",
                ["creepage", "area / m²"],
                over(&[["contact", "contact_area"], ["stick", "stick_area"]]),
            ),
        ],
    );
}

/// Rows in which two creepages vary are points over their number, not a line that jumps.
#[test]
fn rows_without_order_are_points() {
    let (rows, drawn) = both(&["roll", &example("roll_spinning.toml")], "picture_spinning.svg");
    let forces = drawn.iter().find(|panel| panel.title.starts_with("forces")).unwrap();
    assert_eq!(forces.x.label, "number of the row");
    assert!(forces.lines.is_empty() && forces.marks.len() >= rows.as_array().unwrap().len());
}

/// What slips everywhere has no name for cells that stick; a force or torque that is zero is no curve.
#[test]
fn the_picture_of_rolling_leaves_out_what_is_not_there() {
    let drawn = |name: &str| {
        let picture = fresh("picture_left_out.svg");
        stdout(&["roll", &example(name), "--plot", picture.to_str().unwrap()]);
        std::fs::read_to_string(&picture).unwrap()
    };
    let slides = drawn("roll_wet_rail.toml");
    assert!(slides.contains(">slip<") && !slides.contains(">stick<"));
    let turns = panels(&drawn("roll_free_to_turn.toml"));
    let titles: Vec<_> = turns.iter().map(|panel| panel.title.as_str()).collect();
    assert!(titles.contains(&"forces on body 1, F_x = 0"), "{titles:?}");
    assert!(titles.contains(&"spin without a torque"), "{titles:?}");
    assert!(turns.iter().any(|panel| panel.legend.contains_key("leading edge")));
}

/// A punch beside the origin is drawn where it is: outlines and arrows.
#[test]
fn the_picture_of_a_punch_beside_the_origin_shows_it_there() {
    let text = r#"
[body_1]
material = { shear_modulus = "1 MPa", poisson = 0.5 }
[body_2]
material = { rigid = true }
[gap]
shape = "polygon"
corners = [[1e-3, 2.4e-3], [3e-3, 2.4e-3], [3e-3, 3.4e-3], [1e-3, 3.4e-3]]
[grid]
accuracy = 0.1
[contact]
friction = 0.5
[[step]]
zeta = "50 um"
[[step]]
F_x = 0.03
F_y = -0.02
"#;
    let file = case("picture_beside.toml", text);
    let (_, drawn) = both(&["solve", &file], "picture_beside.svg");
    let panel = drawn.iter().find(|panel| panel.title.starts_with("tractions")).unwrap();
    let ends = |places: &[[f64; 2]]| -> [f64; 4] {
        let x: Vec<f64> = places.iter().map(|at| panel.x.value(at[0])).collect();
        let y: Vec<f64> = places.iter().map(|at| panel.y.value(at[1])).collect();
        let of = |all: &[f64], pick: fn(f64, f64) -> f64| all.iter().copied().reduce(pick).unwrap();
        [of(&x, f64::min), of(&x, f64::max), of(&y, f64::min), of(&y, f64::max)]
    };
    let corners = [1e-3, 3e-3, 2.4e-3, 3.4e-3];
    // Arrows begin in the middles of cells and are some cells long.
    for (what, found, within) in [
        ("contact", ends(&panel.curves("contact").concat()), 1.5e-4),
        ("arrows", ends(&panel.arrows), 4e-4),
    ] {
        for (found, expected) in found.iter().zip(corners) {
            assert!((found - expected).abs() < within, "{what}: {found} {expected}");
        }
    }
}

#[test]
fn a_contact_that_is_only_pressed_has_no_panels_of_tractions() {
    let text = std::fs::read_to_string(example("solve_hertz.toml")).unwrap();
    let (frictionless, rough) = ("friction = 0", "friction = 0.3");
    assert!(text.contains(frictionless));
    let pressed = case("pressed.toml", &text.replace(frictionless, rough));
    let (rows, panels) = both(&["solve", &pressed], "pressed.svg");
    assert!(number(&rows[0], "F_z") > 0.0);
    let titles: Vec<_> = panels.iter().map(|panel| panel.title.as_str()).collect();
    assert!(titles.contains(&"pressure, last step"), "{titles:?}");
    assert!(!titles.iter().any(|title| title.ends_with("of the tractions")), "{titles:?}");
}

/// What says most is shown, the rest on request.
#[test]
fn the_main_panels_come_first_and_all_on_request() {
    let file = case("picture_panels.toml", SOLVE);
    let titles = |arguments: &[&str]| -> Vec<String> {
        let picture = fresh("picture_panels.svg");
        stdout(&[arguments, &["--plot", picture.to_str().unwrap()]].concat());
        let drawn = panels(&std::fs::read_to_string(&picture).unwrap());
        drawn.into_iter().map(|panel| panel.title).collect()
    };
    let main = titles(&["solve", &file]);
    let all = titles(&["solve", &file, "--panels", "all"]);
    assert_eq!(all[..main.len()], main);
    assert!(main.contains(&"load curves".to_owned()) && !main.contains(&"energy".to_owned()));
    assert!(all.contains(&"energy".to_owned()) && all.len() > main.len());
}
