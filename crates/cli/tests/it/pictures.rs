//! Pictures agree with the results: every curve of every panel is compared with the rows.

use crate::common;

use crate::common::picture::{Panel, panels};
use crate::common::{case, example, fresh, stdout};
use serde_json::Value;

/// A panel: its title, the labels of its axes, and its curves by name with what they show of a row.
type Wanted<'a> = (&'a str, [&'a str; 2], Vec<(&'a str, [&'a str; 2])>);

/// Results of a command in JSON, with its picture.
fn both(arguments: &[&str], name: &str) -> (Value, Vec<Panel>) {
    let file = fresh(name);
    let all: &[&str] = if arguments[0] == "restitution" { &[] } else { &["--panels", "all"] };
    let file_name = file.to_str().unwrap();
    let plotted = [arguments, all, &["--format", "json", "--plot", file_name]].concat();
    let results = serde_json::from_str(&stdout(&plotted)).unwrap();
    (results, panels(&std::fs::read_to_string(&file).unwrap()))
}

/// A number of a row by its path: `F_z`, `force.2`, or `-depth` for the opposite.
fn number(row: &Value, path: &str) -> f64 {
    let (sign, path) = path.strip_prefix('-').map_or((1.0, path), |path| (-1.0, path));
    let found = path.split('.').fold(row, |at, part| match part.parse::<usize>() {
        Ok(index) => &at[index],
        Err(_) => &at[part],
    });
    sign * found.as_f64().unwrap_or_else(|| panic!("{path} of {row}"))
}

/// Every row lies on its curves, and no two curves of a panel show the same.
fn shows(panels: &[Panel], rows: &[Value], wanted: &[Wanted<'_>]) {
    for (title, labels, curves) in wanted {
        let of = |panel: &&Panel| {
            panel.title == *title && [panel.x.label.as_str(), &panel.y.label] == *labels
        };
        let mut found = panels.iter().filter(of);
        let told = || panels.iter().map(|p| (&p.title, &p.x.label, &p.y.label)).collect::<Vec<_>>();
        let panel = found.next().unwrap_or_else(|| panic!("{title} {labels:?} in {:?}", told()));
        for (name, [x, y]) in curves {
            for row in rows {
                let at = [number(row, x), number(row, y)];
                let off = panel.distance(name, at);
                assert!(off < 0.8, "{title}, {name}: {x} {y} {at:?} is {off} pixels off");
            }
        }
        let ways = |name: &str| panel.curves(name).concat();
        for (i, (one, _)) in curves.iter().enumerate() {
            for (other, _) in &curves[..i] {
                assert_ne!(ways(one), ways(other), "{title}: {one} and {other} tell nothing apart");
            }
        }
    }
}

/// A panel of loads over the steps.
fn over_steps<'a>(title: &'a str, label: &'a str, curves: &[[&'a str; 2]]) -> Wanted<'a> {
    let curves = curves.iter().map(|[name, column]| (*name, ["step", *column])).collect();
    (title, ["step", label], curves)
}

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
                ["time / s", "radius, semi-axis / m"],
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
    shows(&drawn, &rows, &[("contact", ["time / s", "radius, semi-axis / m"], curves)]);
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

#[test]
fn the_picture_of_a_scene_shows_the_way_of_the_ball() {
    let name = example("scene_book.toml");
    let (results, drawn) = both(&["scene", &name, "--points", "9"], "picture_scene.svg");
    let path = results["path"].as_array().unwrap();
    let way = vec![("centre of the ball", ["position.0", "position.2"])];
    shows(&drawn, path, &[("", ["x / m", "z / m"], way)]);
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

/// Rows in which two creepages vary are points over their number, not a line that jumps.
#[test]
fn rows_without_order_are_points() {
    let (rows, drawn) = both(&["roll", &example("roll_spinning.toml")], "picture_spinning.svg");
    let forces = drawn.iter().find(|panel| panel.title == "forces on body 1").unwrap();
    assert_eq!(forces.x.label, "number of the row");
    assert!(forces.lines.is_empty() && forces.marks.len() >= rows.as_array().unwrap().len());
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
