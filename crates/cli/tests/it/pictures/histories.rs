//! The pictures of histories and of tractions.

use super::{both, over_steps, shows};
use crate::common::picture::Panel;
use crate::common::{case, example};

const HISTORY: &str = r#"
[body_1]
radii = [0.03, 0.012]
material = { shear_modulus = 1e6, poisson = 0.5 }
[body_2]
radii = inf
material = { rigid = true }
[contact]
angle = 0
friction = 0.4
[history]
steps = [
    [1.0e-4, 0.0, 0.0, 0.0],
    [1.2e-4, 1.0e-5, 2.0e-5, 0.01],
    [1.3e-4, 3.0e-5, 2.5e-5, 0.015],
    [1.1e-4, 1.0e-5, 4.0e-5, -0.02],
    [0.9e-4, -2.0e-5, 1.0e-5, 0.01],
]
"#;

#[test]
fn the_picture_of_a_history_shows_its_steps() {
    let file = case("picture_history.toml", HISTORY);
    let (rows, drawn) = both(&["history", &file, "--tractions", "9"], "picture_history.svg");
    let rows = rows.as_array().unwrap();
    let forces = [["F_x", "F_x"], ["F_y", "F_y"], ["F_z", "F_z"]];
    let axes = [
        ["a", "semi_axis_a"],
        ["b", "semi_axis_b"],
        ["a, stick", "stick_semi_axis_a"],
        ["b, stick", "stick_semi_axis_b"],
    ];
    shows(
        &drawn,
        rows,
        &[
            over_steps("forces on body 1", "force / N", &forces),
            (
                "loops",
                ["shift / m", "force / N"],
                vec![("F_x against ξ", ["xi", "F_x"]), ("F_y against η", ["eta", "F_y"])],
            ),
            over_steps("contact and stick ellipse", "semi-axis / m", &axes),
            over_steps(
                "energy",
                "energy / J",
                &[["stored", "stored_energy"], ["dissipated", "dissipated"]],
            ),
            (
                "torsion",
                ["twist Ω / rad", "torque M_z on body 1 / N m"],
                vec![("", ["omega", "M_z"])],
            ),
            over_steps(
                "stick area of the twist",
                "larger semi-axis / m",
                &[["", "twist_stick_semi_axis_b"]],
            ),
        ],
    );
    let tractions = rows[4]["tractions"].as_array().unwrap();
    let curves = [("t_x", "t_x"), ("t_y", "t_y"), ("friction limit", "limit")];
    let labels = ["radius, from the centre (0) to the edge (1)", "traction on body 1 / Pa"];
    shows(
        &drawn,
        tractions,
        &[(
            "tractions after step 5",
            labels,
            curves.map(|(name, column)| (name, ["radius", column])).to_vec(),
        )],
    );
}

/// A ball that slides under 30 degrees: the tractions are friction times Hertz's pressure, all along the shift.
#[test]
fn the_picture_of_tractions_shows_their_size_and_direction() {
    let text = r#"
[body_1]
material = { shear_modulus = "1 MPa", poisson = 0 }
[body_2]
material = { shear_modulus = "1 MPa", poisson = 0 }
[gap]
shape = "paraboloid"
radii = ["20 mm", "20 mm"]
[grid]
cells = [36, 30]
size = ["6 mm", "5 mm"]
[contact]
friction = 0.2
[[step]]
zeta = "0.2 mm"
[[step]]
xi = 0.00017320508
eta = 0.0001
"#;
    let file = case("picture_slides.toml", text);
    let (_, drawn) = both(&["solve", &file], "picture_slides.svg");
    let of = |title: &str| drawn.iter().find(|panel| panel.title == title).unwrap();
    let slip = |panel: &Panel| -> Vec<[f64; 2]> {
        let places = panel.marks.iter().map(|(_, at)| *at).collect::<Vec<_>>();
        assert!(places.len() > 20, "{}", places.len());
        places.iter().map(|[x, y]| [panel.x.value(*x), panel.y.value(*y)]).collect()
    };
    let angles = slip(of("direction of the tractions"));
    assert!(angles.iter().all(|[_, angle]| (angle - 30.0).abs() < 1.0), "{angles:?}");
    // a^2 = R zeta
    for [r, size] in slip(of("size of the tractions")) {
        let expected = (1.0 - r * r / (0.02 * 2e-4)).max(0.0).sqrt();
        assert!((size - expected).abs() < 0.06 || size < 0.3, "{r} {size} {expected}");
    }
}

/// Of forces that symmetry makes zero the title tells.
#[test]
fn what_is_zero_beside_the_others_is_left_out_and_named() {
    let name = example("solve_cattaneo_loop.toml");
    let (_, drawn) = both(&["solve", &name], "picture_zero.svg");
    let forces = drawn.iter().find(|panel| panel.title.starts_with("forces")).unwrap();
    assert_eq!(forces.title, "forces on body 1, F_y = 0");
    assert!(forces.legend.contains_key("F_x") && !forces.legend.contains_key("F_y"));
}
