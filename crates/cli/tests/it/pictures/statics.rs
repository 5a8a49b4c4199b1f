//! The pictures of Hertz contacts and of stresses.

use super::{both, shows};
use crate::common::{case, example};

#[test]
fn the_picture_of_stresses_shows_its_points() {
    let text = |inside: &str, places: &str| {
        format!(
            r#"
[body_1]
radii = [0.01, 0.02]
material = {{ young_modulus = 208e9, poisson = 0.3 }}
[body_2]
radii = inf
material = {{ young_modulus = 208e9, poisson = 0.25 }}
[contact]
angle = 0
friction = 0.3
[load]
force = 100
force_x = 12
force_y = -9
[points]
inside = "{inside}"
{places}
"#
        )
    };
    let names = ["s_xx", "s_yy", "s_zz", "s_xy", "s_yz", "s_zx", "von_mises"];
    let many = "{ start = -2e-4, stop = 3e-4, count = 41 }";
    let down = "{ start = 0, stop = 4e-4, count = 41 }";
    for (inside, places, label, along) in [
        ("body 1", format!("x = {many}\ny = 5e-5\ndepth = 4e-5"), "x / m", "x"),
        ("body 1", format!("x = 3e-5\ny = {many}\ndepth = 4e-5"), "y / m", "y"),
        ("body 1", format!("x = 3e-5\ny = 4e-5\ndepth = {down}"), "z / m", "depth"),
        ("body 2", format!("x = 3e-5\ny = 4e-5\ndepth = {down}"), "z / m", "-depth"),
    ] {
        let file = case("picture_stress.toml", &text(inside, &places));
        let (results, drawn) = both(&["stress", &file], "picture_stress.svg");
        let curves = names.map(|name| match name {
            "von_mises" => ("von Mises", [along, name]),
            _ => (name, [along, name]),
        });
        let curves = curves.to_vec();
        let rows = results["points"].as_array().unwrap();
        let title = "";
        shows(&drawn, rows, &[(title, [label, "stress / Pa"], curves)]);
    }
}

#[test]
fn the_picture_of_hertz_shows_ellipse_and_pressure() {
    let name = example("hertz_crossed_cylinders.toml");
    let (results, drawn) = both(&["hertz", &name], "picture_hertz.svg");
    let rows = results["loads"].as_array().unwrap();
    let label = "approach / m";
    shows(
        &drawn,
        rows,
        &[
            ("", [label, "force / N"], vec![("", ["approach", "force"])]),
            ("", [label, "peak pressure / Pa"], vec![("", ["approach", "peak_pressure"])]),
        ],
    );
}
