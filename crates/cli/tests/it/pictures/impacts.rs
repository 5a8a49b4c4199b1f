//! The pictures of impacts, scenes and restitution.

use super::{both, number, shows};
use crate::common;
use crate::common::{case, example};
use serde_json::Value;

#[test]
fn the_picture_of_an_impact_shows_its_course() {
    let text = r#"
[body_1]
shape = "sphere"
radius = 0.01
material = { young_modulus = 70e9, poisson = 0.22 }
mass = 0.01
velocity = [0.6, 0.35, -2]
spin = [30, -20, 0]
[body_2]
shape = "plane"
material = { young_modulus = 70e9, poisson = 0.22 }
fixed = true
[contact]
friction = 0.15
"#;
    let file = case("picture_impact.toml", text);
    let (results, drawn) = both(&["impact", &file, "--history", "17"], "picture_impact.svg");
    let mut rows = results["history"].as_array().unwrap().clone();
    for row in &mut rows {
        row["limit"] = Value::from(0.15 * number(row, "F.2"));
    }
    let rows = &rows;
    let over = |curves: &[[&'static str; 2]]| {
        curves.iter().map(|[name, column]| (*name, ["time", *column])).collect::<Vec<_>>()
    };
    shows(
        &drawn,
        rows,
        &[
            ("normal force on body 1", ["time / s", "force / N"], over(&[["", "F.2"]])),
            (
                "friction on body 1",
                ["time / s", "force / N"],
                over(&[["F_x", "F.0"], ["F_y", "F.1"], ["± f F_z", "limit"]]),
            ),
            (
                "displacements of body 2 against body 1",
                ["time / s", "displacement / m"],
                over(&[["ξ", "xi"], ["η", "eta"], ["ζ", "zeta"]]),
            ),
            (
                "velocities of body 2 against body 1",
                ["time / s", "velocity / m/s"],
                over(&[["v_x", "v.0"], ["v_y", "v.1"], ["v_z", "v.2"]]),
            ),
            (
                "contact",
                ["time / s", "radius / m"],
                over(&[["contact", "semi_axis_a"], ["stick", "stick_radius"]]),
            ),
        ],
    );
}

#[test]
fn the_picture_of_an_elliptic_impact_shows_both_axes() {
    let file = case("picture_ellipsoid.toml", common::pebble::CASE);
    let (results, drawn) = both(&["impact", &file, "--history", "9"], "picture_ellipsoid.svg");
    let rows = results["history"].as_array().unwrap();
    let curves =
        vec![("a, along x", ["time", "semi_axis_a"]), ("b, along y", ["time", "semi_axis_b"])];
    // Between the instants of the history both are straight, those of the picture closer together.
    let largest = rows.iter().map(|row| number(row, "semi_axis_b")).fold(0.0, f64::max);
    let rows: Vec<Value> =
        rows.iter().filter(|row| number(row, "semi_axis_b") > 0.5 * largest).cloned().collect();
    assert!(rows.len() > 3);
    shows(&drawn, &rows, &[("contact", ["time / s", "semi-axis / m"], curves)]);
}

#[test]
fn the_picture_of_a_sweep_shows_body_1() {
    let text = r#"
[body_1]
shape = "sphere"
radius = 0.01
material = { young_modulus = 70e9, poisson = 0.22 }
mass = 0.01
spin = [30, -25, 10]
[body_2]
shape = "plane"
material = { young_modulus = 70e9, poisson = 0.22 }
fixed = true
[contact]
friction = 0.2
[approach]
speed = 2
angle = [10, 25, 40, 60, 80]
"#;
    let file = case("picture_sweep.toml", text);
    let (results, drawn) = both(&["impact", &file], "picture_sweep.svg");
    let rows = results.as_array().unwrap();
    let label = "angle from the normal / °";
    let named = |column| vec![("", ["angle", column])];
    shows(
        &drawn,
        rows,
        &[
            ("", [label, "R_x"], named("R_x")),
            ("", [label, "v_x of body 1 afterwards / m/s"], named("body_1_velocity.0")),
            ("", [label, "spin_y of body 1 afterwards / rad/s"], named("body_1_spin.1")),
        ],
    );
}

/// Of a head-on impact, in which nothing moves across, the velocity along the normal and the energy.
#[test]
fn the_picture_of_a_sweep_shows_what_varies() {
    let picture = common::fresh("picture_head_on.svg");
    let plot = ["impact", &example("ice_balls.toml"), "--plot", picture.to_str().unwrap()];
    let panels = |more: &[&str]| -> Vec<String> {
        common::stdout(&[&plot[..], more].concat());
        let drawn = common::picture::panels(&std::fs::read_to_string(&picture).unwrap());
        drawn.into_iter().map(|panel| panel.y.label).collect()
    };
    let main = panels(&[]);
    let expected =
        ["normal restitution", "v_z of body 1 afterwards / m/s", "energy lost in the material / J"];
    let without_prefix = |label: &String| label.replace("/ mJ", "/ J").replace("mm/s", "m/s");
    assert_eq!(main.iter().map(without_prefix).collect::<Vec<_>>(), expected);
    let all = panels(&["--panels", "all"]);
    assert!(all.len() == 12 && all[..3] == main[..] && all.contains(&"R_x".to_owned()), "{all:?}");
}

#[test]
fn the_picture_of_a_scene_shows_the_way_of_the_ball() {
    let name = example("scene_book.toml");
    let (results, drawn) = both(&["scene", &name, "--points", "9"], "picture_scene.svg");
    let path = results["path"].as_array().unwrap();
    let way = vec![("centre of the ball", ["position.0", "position.2"])];
    shows(&drawn, path, &[("", ["x / m", "z / m"], way)]);
}

/// Walls and bounces: a bounce is marked where the ball touches the wall, a radius below its centre.
#[test]
fn the_picture_of_a_scene_shows_walls_and_bounces() {
    let text = r#"
[ball]
shape = "sphere"
radius = 0.02
material = { young_modulus = 20e6, poisson = 0.5 }
mass = 0.03
velocity = [0.3, 0, 0]
spin = [0, 0, 0]
[scene]
start = [0, 0, 0.4]
gravity = [0, 0, -9.81]
time = 1.5
bounces = 3
[[wall]]
name = "slope"
point = [0.1, 0, 0.05]
normal = [-0.28, 0, 0.96]
material = { rigid = true }
friction = 0.3
"#;
    let file = case("picture_slope.toml", text);
    let (results, drawn) = both(&["scene", &file], "picture_slope.svg");
    let panel = &drawn[0];
    let [n_x, n_z] = [-0.28, 0.96];
    let height =
        |at: &[f64; 2]| n_x * (panel.x.value(at[0]) - 0.1) + n_z * (panel.y.value(at[1]) - 0.05);
    let slope = panel.curves("slope");
    let (x, y) = (slope[0][0], slope[0][slope[0].len() - 1]);
    assert!(height(&x).abs() < 2e-3 && height(&y).abs() < 2e-3, "{} {}", height(&x), height(&y));
    assert!((panel.x.value(x[0]) - panel.x.value(y[0])).abs() > 0.1);
    let bounces = results["bounces"].as_array().unwrap();
    assert!(!bounces.is_empty());
    let colour = &panel.legend["bounces"];
    let marks: Vec<_> = panel.marks.iter().filter(|(own, _)| own == colour).collect();
    for bounce in bounces {
        let [x, z] =
            [number(bounce, "position.0") - 0.02 * n_x, number(bounce, "position.2") - 0.02 * n_z];
        let near = marks.iter().any(|(_, at)| {
            (at[0] - panel.x.pixel(x)).abs() < 0.3 && (at[1] - panel.y.pixel(z)).abs() < 0.3
        });
        assert!(near, "{x} {z} in {marks:?}");
        assert!(
            (number(bounce, "position.0") - 0.1) * n_x
                + (number(bounce, "position.2") - 0.05) * n_z
                > 0.019
        );
    }
}

#[test]
fn the_picture_of_restitution_shows_a_line_for_each_number() {
    let over = ["--kappa", "1,1.4", "--lambda", "0.5:9:12"];
    let (rows, drawn) = both(&[&["restitution"][..], &over].concat(), "picture_restitution.svg");
    let rows = rows.as_array().unwrap();
    for kappa in [1.0, 1.4] {
        let own: Vec<Value> =
            rows.iter().filter(|row| number(row, "kappa") == kappa).cloned().collect();
        assert_eq!(own.len(), 12);
        let panel = &drawn[0];
        let name = panel.legend.keys().find(|name| name.ends_with(&format!("= {kappa}")));
        let name = name.unwrap_or_else(|| panic!("{:?}", panel.legend)).clone();
        for row in &own {
            let off = panel.distance(&name, [number(row, "lambda"), number(row, "R_x")]);
            assert!(off < 0.8, "{row}: {off}");
        }
    }
}

/// Over the first number, where there is one second number only.
#[test]
fn the_picture_of_restitution_over_the_first_number_has_its_axis() {
    let over = ["--kappa", "0.9:1.45:12", "--lambda", "2"];
    let (rows, drawn) = both(&[&["restitution"][..], &over].concat(), "picture_over_kappa.svg");
    for row in rows.as_array().unwrap() {
        let name = drawn[0].legend.keys().find(|name| name.ends_with("= 2")).unwrap().clone();
        let off = drawn[0].distance(&name, [number(row, "kappa"), number(row, "R_x")]);
        assert!(off < 0.8, "{row}: {off}");
    }
}
