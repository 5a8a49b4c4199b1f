//! Impacts of bodies of any smooth shape: what the command gives, and what it refuses.

mod common;

use common::{carom, case, example, fresh, json, stdout};
use std::path::Path;

const CASE: &str = r#"[body_1]
shape = "ellipsoid"
semi_axes = [0.03, 0.02, 0.015]
material = { young_modulus = 70e9, poisson = 0.22 }
mass = 0.1
inertia = [1.2e-5, 2.2e-5, 2.6e-5]
quaternion = [1, 0, 0, 0]
position = [0, 0, 0.015]
velocity = [0.6, 0.4, -2]
spin = [0, 0, 20]

[body_2]
shape = "plane"
material = { young_modulus = 70e9, poisson = 0.22 }
fixed = true

[contact]
friction = 0.2
"#;

fn solved(name: &str, text: &str) -> serde_json::Value {
    let file = case(&format!("{name}.toml"), text);
    serde_json::from_str(&stdout(&["impact", &file, "--format", "json"])).unwrap()
}

/// What the command says of a bad case; it must end with code 2 and give nothing else.
fn refused(name: &str, text: &str) -> String {
    let file = case(&format!("{name}.toml"), text);
    let plot = fresh(&format!("{name}.svg"));
    let output = carom(&["impact", &file, "--plot", plot.to_str().unwrap()]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{text}\n{stderr}");
    assert!(output.stdout.is_empty() && !plot.exists(), "{stderr}");
    stderr.replace(&file, "CASE")
}

fn changed(old: &str, new: &str) -> String {
    assert!(CASE.contains(old), "{old}");
    CASE.replacen(old, new, 1)
}

fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|part| part.as_f64().unwrap()).collect()
}

fn close(one: &[f64], other: &[f64], tolerance: f64) {
    assert_eq!(one.len(), other.len());
    let off = one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= tolerance, "{one:?} {other:?}");
}

/// The same fields, words and numbers, but for places.
fn alike(one: &serde_json::Value, other: &serde_json::Value) {
    use serde_json::Value;
    match (one, other) {
        (Value::Object(one), Value::Object(other)) => {
            let keys = |object: &serde_json::Map<String, Value>| -> Vec<String> {
                object.keys().cloned().collect()
            };
            assert_eq!(keys(one), keys(other));
            let places = ["point", "centre_1", "centre_2"];
            for (key, value) in one.iter().filter(|(key, _)| !places.contains(&key.as_str())) {
                alike(value, &other[key]);
            }
        }
        (Value::Array(one), Value::Array(other)) => {
            assert_eq!(one.len(), other.len());
            let size = |list: &[Value]| {
                list.iter().filter_map(Value::as_f64).map(f64::abs).fold(0.0, f64::max)
            };
            let numbers =
                one.iter().zip(other).filter_map(|(a, b)| Some((a.as_f64()?, b.as_f64()?)));
            for (a, b) in numbers {
                assert!((a - b).abs() <= 1e-13 * size(one), "{one:?} {other:?}");
            }
            one.iter().zip(other).filter(|(a, _)| !a.is_number()).for_each(|(a, b)| alike(a, b));
        }
        (Value::Number(one), Value::Number(other)) => {
            let (a, b) = (one.as_f64().unwrap(), other.as_f64().unwrap());
            assert!((a - b).abs() <= 1e-13 * a.abs(), "{a} {b}");
        }
        (one, other) => assert_eq!(one, other),
    }
}

/// The examples of impacts whose bodies have no place, with one that changes nothing.
const PLACED: [(&str, &str, &str); 4] = [
    ("alumina_on_plane", "radius = 2.5e-3", "radius = 2.5e-3\nposition = [0.1, -0.2, 2.5e-3]"),
    ("steel_balls", "radius = 0.01", "radius = 0.01\nposition = [0, 0, 0.01]"),
    ("rubber_on_table", "radius = 0.022", "radius = 0.022\nposition = [0, 0, 0.022]"),
    ("rubber_under_book", "radius = 0.022", "radius = 0.022\nposition = [1, 2, -0.022]"),
];

#[test]
fn a_place_changes_nothing_but_the_place() {
    for (name, old, new) in PLACED {
        let path =
            Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../examples/{name}.toml"));
        let text = std::fs::read_to_string(path).unwrap();
        assert!(text.contains(old), "{name}");
        let placed = text.replacen(old, new, 1);
        alike(&solved(&format!("{name}-here"), &text), &solved(&format!("{name}-there"), &placed));
        let csv = |text: &str, more: &[&str]| {
            let file = case(&format!("{name}-columns.toml"), text);
            stdout(&[&["impact", &file, "--format", "csv"], more].concat())
        };
        let head = |rows: String| rows.lines().next().map(str::to_owned);
        assert_eq!(head(csv(&text, &[])), head(csv(&placed, &[])), "{name}");
        if !text.contains("count =") {
            let history = |text: &str| {
                let file = case(&format!("{name}-history.toml"), text);
                let more = ["--history", "21", "--format", "json"];
                let record = stdout(&[&["impact", &file][..], &more].concat());
                serde_json::from_str::<serde_json::Value>(&record).unwrap()
            };
            alike(&history(&text)["history"], &history(&placed)["history"]);
        }
    }
}

#[test]
fn a_sphere_with_a_place_is_the_sphere_of_a_simple_case() {
    let simple = r#"[body_1]
shape = "sphere"
radius = 0.01
material = { shear_modulus = 80e9, poisson = 0.3 }
density = 7850
velocity = [0.7, 0.3, -2]
spin = [0, 50, 10]
[body_2]
shape = "sphere"
radius = 0.02
material = { shear_modulus = 80e9, poisson = 0.3 }
density = 7850
velocity = [0, 0, 0]
spin = [0, 0, -5]
[contact]
friction = 0.15
torsion = true
"#;
    let placed = simple
        .replace("radius = 0.01\n", "radius = 0.01\nposition = [0, 0, 0.01]\n")
        .replace("radius = 0.02\n", "radius = 0.02\nposition = [0, 0, -0.02]\n");
    let (one, other) = (solved("simple", simple), solved("placed", &placed));
    assert_eq!(one["contact"]["passage"], "uncoupled");
    assert_eq!(one["contact"]["error_estimate"], 0.0);
    alike(&one, &other);
    let ratio = one["torsion"]["spin_ratio"].as_f64().unwrap();
    assert!(ratio < 1.0);
    // Turned as a whole: upright capsule ends are spheres too, and a plane may face anywhere.
    let turned = placed
        .replace("position = [0, 0, 0.01]", "position = [0.01, 0, 0]")
        .replace("position = [0, 0, -0.02]", "position = [-0.02, 0, 0]")
        .replace("velocity = [0.7, 0.3, -2]", "velocity = [-2, 0.7, 0.3]")
        .replace("spin = [0, 50, 10]", "spin = [10, 0, 50]")
        .replace("spin = [0, 0, -5]", "spin = [-5, 0, 0]");
    let turned = solved("turned", &turned);
    let before = numbers(&other["after"]["body_1"]["velocity"]);
    let after = numbers(&turned["after"]["body_1"]["velocity"]);
    close(&after, &[before[2], before[0], before[1]], 1e-12);
}

#[test]
fn energy_and_momentum_balance() {
    let text = std::fs::read_to_string(
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/crossed_capsules.toml"),
    );
    let record = solved("balance", &text.unwrap());
    let number = |name: &str| record[name].as_f64().unwrap();
    let lost = number("energy_before") - number("energy_after") - number("energy_dissipated");
    assert!(lost.abs() < 1e-12 * number("energy_before"), "{lost}");
    let velocity = |when: &str, body: &str| numbers(&record[when][body]["velocity"]);
    for axis in 0..3 {
        let sum = |when| velocity(when, "body_1")[axis] + velocity(when, "body_2")[axis];
        assert!((sum("before") - sum("after")).abs() < 1e-12);
    }
    assert_eq!(record["contact"]["passage"], "spatial");
    assert!(record["contact"]["error_estimate"].as_f64().unwrap() < 5e-6);
    assert!(record["events"].as_array().unwrap().len() > 1);
}

#[test]
fn the_contact_point_may_be_given_in_every_way() {
    let found = solved("found", CASE);
    let ways = [
        CASE.to_owned() + "point = [0, 0, 0]\n",
        CASE.to_owned() + "search = \"touch\"\n",
        changed("position = [0, 0, 0.015]\n", "") + "point_1 = [0, 0, -0.015]\n",
        changed("[0, 0, 0.015]", "[-0.6, -0.4, 2.015]") + "search = \"approach\"\n",
        changed("quaternion = [1, 0, 0, 0]", "angles = [0, 0, 0]"),
        changed("shape = \"plane\"", "shape = \"half-space\"\nnormal = [0, 0, 7]"),
    ];
    for (i, way) in ways.iter().enumerate() {
        let record = solved(&format!("way-{i}"), way);
        close(&numbers(&record["contact"]["point"]), &[0.0; 3], 1e-12);
        let of = |record: &serde_json::Value| numbers(&record["after"]["body_1"]["velocity"]);
        close(&of(&record), &of(&found), 1e-10);
    }
    // Without a place it lies on the plane, and a search for places asks for them.
    let unplaced = changed("position = [0, 0, 0.015]\n", "");
    let of = |record: &serde_json::Value| numbers(&record["after"]["body_1"]["velocity"]);
    close(&of(&solved("unplaced", &unplaced)), &of(&found), 1e-12);
    let searched = refused("searched", &(unplaced + "search = \"touch\"\n"));
    assert!(searched.contains("`body_1.position` is missing"), "{searched}");
    // The same body by its curvatures alone: r = A^2/C, B^2/C at the end of axis c.
    let given = CASE
        .replace("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", GIVEN)
        .replace("position = [0, 0, 0.015]\n", "");
    let record = solved("given", &given);
    let of = |record: &serde_json::Value| numbers(&record["after"]["body_1"]["velocity"]);
    close(&of(&record), &of(&found), 1e-10);
}

const GIVEN: &str = "shape = \"given\"\nradii = [0.06, 0.02666666666666667]\n\
                     point = [0, 0, -0.015]\nnormal = [0, 0, -1]\ndirection = [1, 0, 0]";

#[test]
fn laws_differ_where_the_direction_turns() {
    let text = CASE
        .replace("quaternion = [1, 0, 0, 0]", "angles = [10, 20, 30]")
        .replace("position = [0, 0, 0.015]", "position = [0, 0, 0.1]")
        + "search = \"approach\"\n";
    let coulomb = solved("coulomb", &(text.clone() + "law = \"coulomb\"\n"));
    let fixed = solved("fixed", &(text + "law = \"fixed-direction\"\n"));
    assert_eq!(fixed["contact"]["law"], "fixed-direction");
    let of = |record: &serde_json::Value| numbers(&record["after"]["body_1"]["velocity"]);
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
    close(&space(&samples[0]), &numbers(&record["contact_velocity_before"]), 1e-12);
    close(&space(&samples[200]), &numbers(&record["contact_velocity_after"]), 1e-5);
    let peak = samples.iter().map(|s| s["F"][2].as_f64().unwrap()).fold(0.0, f64::max);
    assert!((peak / record["maximal_force"].as_f64().unwrap() - 1.0).abs() < 1e-3);
    let rows = stdout(&[&arguments[..], &["csv"]].concat());
    assert_eq!(rows.lines().count(), 202);
    assert!(rows.starts_with("time,xi,eta,zeta,v_x"));
    let csv = stdout(&["impact", &file, "--format", "csv"]);
    assert!(csv.lines().next().unwrap().ends_with("normal_x,normal_y,normal_z"));
    assert!(stdout(&["impact", &file]).contains("passage"));
}

#[test]
fn what_makes_no_contact_is_refused_with_its_line() {
    for (name, text, line) in [
        ("apart", changed("0.015]\nvel", "0.016]\nvel"), "line 8: `body_1.position`: the bodies do not touch: gap = 1"),
        ("overlap", changed("0.015]\nvel", "0.01]\nvel"), "line 8: `body_1.position`: the bodies do not touch: gap = -4.99"),
        (
            "passing",
            changed("-2]", "2]").replace("0.015]\nvel", "1]\nvel") + "search = \"approach\"\n",
            "line 19: `contact.search`: the bodies do not touch: gap = 9",
        ),
        (
            "off",
            CASE.to_owned() + "point = [0.01, 0, 0]\n",
            "line 19: `contact.point`: body 1: the point (0.01, 0, -0.015) lies",
        ),
        (
            "own-off",
            changed("position = [0, 0, 0.015]\n", "") + "point_1 = [0, 0, -0.014]\n",
            "line 18: `contact.point_1`: body 1: the point (0, 0, -0.014) lies",
        ),
        (
            "other-side",
            changed("position = [0, 0, 0.015]\n", "") + "point_1 = [0, 0, 0.015]\n",
            "line 16: `contact`: the outward normals are 3.14",
        ),
        (
            "conforming",
            CASE.replace("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", GIVEN)
                .replace("radii = [0.06,", "radii = [-0.06,")
                .replace("position = [0, 0, 0.015]\n", ""),
            "line 3: `body_1.radii`: the surfaces conform or intersect",
        ),
        (
            "line",
            CASE.replace("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", GIVEN)
                .replace("radii = [0.06,", "radii = [inf,")
                .replace("position = [0, 0, 0.015]\n", ""),
            "line 3: `body_1.radii`: the surfaces touch along a line",
        ),
        (
            "edge",
            changed("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", "shape = \"box\"\nedges = [0.03, 0.03, 0.03]")
                .replace("shape = \"plane\"", "shape = \"sphere\"\nradius = 0.1\nposition = [-0.08571067811865476, 0, -0.07071067811865476]"),
            "line 2: `body_1.shape`: body 1: the point lies on the edge of a box",
        ),
        (
            "torsion",
            changed("quaternion = [1, 0, 0, 0]", "angles = [10, 20, 30]").replace("0.015]\nvel", "0.1]\nvel")
                + "search = \"approach\"\ntorsion = true\n",
            "line 20: `contact.torsion`: torsion: normal and tangential motion are coupled",
        ),
    ] {
        let message = refused(name, &text);
        assert!(message.starts_with(&format!("error: CASE: {line}")), "{name}: {message}");
    }
    assert!(
        refused("hint", &changed("0.015]\nvel", "0.016]\nvel")).contains("search = \"approach\"")
    );
}

#[test]
fn bad_fields_are_refused_with_line_value_and_range() {
    for (old, new, expected) in [
        (
            "\"ellipsoid\"",
            "\"egg\"",
            "line 2: `body_1.shape` = \"egg\" is out of range: must be \"sphere\", \"ellipsoid\"",
        ),
        (
            "semi_axes = [0.03, 0.02, 0.015]",
            "semi_axes = [0.03, -0.02, 0.015]",
            "line 3: `body_1.semi_axes.y` = -0.02 is out of range: must be finite and > 0",
        ),
        (
            "semi_axes = [0.03, 0.02, 0.015]",
            "semi_axes = [0.03, 0.02]",
            "line 3: `body_1.semi_axes` = [0.03, 0.02] is out of range: must be three numbers",
        ),
        (
            "semi_axes = [0.03, 0.02, 0.015]",
            "",
            "`body_1.semi_axes` is missing: must be three numbers",
        ),
        (
            "semi_axes",
            "radius",
            "line 3: unknown field `body_1.radius`; `body_1` of shape \"ellipsoid\" takes `shape`",
        ),
        (
            "semi_axes",
            "semi_axis",
            "line 3: unknown field `body_1.semi_axis`, did you mean `semi_axes`?",
        ),
        (
            "quaternion = [1, 0, 0, 0]",
            "quaternion = [1, 0, 0.1, 0]",
            "line 7: `body_1.quaternion` = 1.00498756211",
        ),
        (
            "quaternion = [1, 0, 0, 0]",
            "quaternion = [1, 0, nan, 0]",
            "line 7: `body_1.quaternion.j` = NaN is out of range: must be finite",
        ),
        (
            "quaternion = [1, 0, 0, 0]",
            "angles = [1, inf, 0]",
            "line 7: `body_1.angles.beta` = inf is out of range: must be finite",
        ),
        (
            "quaternion",
            "angles = [0, 0, 0]\nquaternion",
            "line 7: `body_1.angles` cannot stand beside `body_1.quaternion`: give one of them",
        ),
        ("quaternion", "normal = [0, 0, 1]\nquaternion", "line 7: unknown field `body_1.normal`"),
        (
            "[1.2e-5, 2.2e-5, 2.6e-5]",
            "[1.2e-5, 2.2e-5, 3.6e-5]",
            "line 6: `body_1.inertia` = 0.000036 is out of range: must be <= the sum of the other two",
        ),
        (
            "[1.2e-5, 2.2e-5, 2.6e-5]",
            "[1.2e-5, -2.2e-5, 2.6e-5]",
            "line 6: `body_1.inertia.y` = -0.000022 is out of range: must be > 0",
        ),
        (
            "[1.2e-5, 2.2e-5, 2.6e-5]",
            "\"hollow\"",
            "line 6: `body_1.inertia` = \"hollow\" is out of range: must be \"solid\", \"shell\" or three moments",
        ),
        ("mass = 0.1", "mass = -0.1", "line 5: `body_1.mass` = -0.1 is out of range: must be > 0"),
        (
            "mass = 0.1",
            "mass = inf",
            "line 15: `body_2.fixed` = inf is out of range: must be a finite mass",
        ),
        (
            "mass = 0.1",
            "density = 2500\nmass = 0.1",
            "line 5: `body_1.density` cannot stand beside `body_1.mass`: give one of them",
        ),
        ("mass = 0.1\n", "", "`body_1.mass` is missing"),
        (
            "mass = 0.1\ninertia = [1.2e-5, 2.2e-5, 2.6e-5]",
            "density = 2500\ninertia = \"shell\"",
            "line 5: `body_1.density` cannot stand beside `body_1.inertia`: a thin shell",
        ),
        (
            "[0, 0, 0.015]",
            "[0, nan, 0.015]",
            "line 8: `body_1.position.y` = NaN is out of range: must be finite",
        ),
        (
            "[contact]",
            "[approach]\nspeed = 1\nangle = 3\n[contact]",
            "line 9: `body_1.velocity` cannot stand beside `approach`",
        ),
        ("[0.6, 0.4, -2]", "[0.6, 0.4, inf]", "line 9: `body_1.velocity.z` = inf is out of range"),
        (
            "spin = [0, 0, 20]",
            "spinn = [0, 0, 20]",
            "line 10: unknown field `body_1.spinn`, did you mean `spin`?",
        ),
        ("spin = [0, 0, 20]\n", "", "`body_1.spin` is missing"),
        (
            "fixed = true",
            "fixed = true\nvelocity = [0, 0, 0]",
            "line 16: `body_2.velocity` cannot stand beside `body_2.fixed`",
        ),
        (
            "fixed = true",
            "fixed = true\ninertia = [1, 1, 1]",
            "line 16: `body_2.inertia` cannot stand beside `body_2.fixed`",
        ),
        (
            "fixed = true",
            "density = 1\nvelocity = [0, 0, 0]\nspin = [0, 0, 0]",
            "line 15: `body_2.density` cannot stand beside `body_2.shape`: it has no volume",
        ),
        (
            "fixed = true",
            "fixed = true\nnormal = [0, 0, 0]",
            "line 16: `body_2.normal` = 0 is out of range: must be a vector of finite length > 0",
        ),
        (
            "friction = 0.2",
            "friction = -0.2",
            "line 18: `contact.friction` = -0.2 is out of range: must be >= 0",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\nlaw = \"elastic\"",
            "line 19: `contact.law` = \"elastic\" is out of range: must be \"coulomb\", \"fixed-direction\" or \"numerical\"",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\ntorsion = 1",
            "line 19: `contact.torsion` = 1 is out of range: must be true or false",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\nsearch = \"near\"",
            "line 19: `contact.search` = \"near\" is out of range: must be \"touch\"",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\npoint = [0, 0, 0]\nsearch = \"touch\"",
            "line 20: `contact.search` cannot stand beside `contact.point`",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\npoint_1 = [0, 0, -0.015]",
            "line 8: `body_1.position` cannot stand beside `contact.point_1`",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\n[uncertainty]\nsamples = 10\nseed = 1",
            "line 19: `uncertainty` cannot stand beside `contact.friction`: no field is uncertain",
        ),
        (
            "shape = \"plane\"",
            "shape = \"torus\"\nradius = 1\ntube_radius = 1",
            "line 15: `body_2.tube_radius` = 1 is out of range: must be < `radius`",
        ),
        (
            "{ young_modulus = 70e9, poisson = 0.22 }\nmass",
            "{ young_modulus = 70e9, poisson = 0.6 }\nmass",
            "line 4: `body_1.material.poisson` = 0.6 is out of range",
        ),
    ] {
        let message = refused("bad-field", &changed(old, new));
        assert!(message.starts_with(&format!("error: CASE: {expected}")), "{new}: {message}");
    }
    let planes =
        changed("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", "shape = \"plane\"");
    assert!(refused("planes", &planes).contains("two planes do not meet in a point"));
}

#[test]
fn simple_cases_take_law_and_torsion_too() {
    let simple = CASE
        .replace("shape = \"ellipsoid\"\nsemi_axes = [0.03, 0.02, 0.015]", "shape = \"sphere\"\nradius = 0.02")
        .replace("inertia = [1.2e-5, 2.2e-5, 2.6e-5]\nquaternion = [1, 0, 0, 0]\nposition = [0, 0, 0.015]\n", "")
        .replace("70e9, poisson = 0.22", "20e6, poisson = 0.5");
    let left = solved("left", &simple);
    let with = solved("with", &(simple.clone() + "torsion = true\nlaw = \"fixed-direction\"\n"));
    let spin = |record: &serde_json::Value| numbers(&record["after"]["body_1"]["spin"])[2];
    assert_eq!(spin(&left), 20.0);
    assert!(left["warnings"].to_string().contains("torsion is left out"));
    assert!(spin(&with) < 19.5 && spin(&with) > 10.0);
    assert!(!with["warnings"].to_string().contains("torsion is left out"));
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
fn numbers_too_large_together_are_refused() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/rubber_on_table.toml");
    let text = std::fs::read_to_string(example).unwrap();
    let message = refused("stiff", &text.replace("20e6", "1e300"));
    assert!(message.contains("c_x = 2.6") && message.contains("at most 1e150"), "{message}");
    let huge = text.replace("density = 1000 ", "density = 1e250 ");
    let message = refused("huge", &huge.replace("speed = 1.414213562373095 ", "speed = 1e99 "));
    assert!(
        message.contains("no finite number: some values of the case are too large"),
        "{message}"
    );
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
        let before = numbers(&record["before"]["body_1"]["velocity"]);
        close(&before, &[2.0 * sin, 0.0, -2.0 * cos], 1e-15);
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
            .replace("friction = 0.2", "friction = 0.02");
        solved(inertia, &text)["after"]["body_1"]["spin"].clone()
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
    assert!(number(&record["contact"]["error_estimate"]) < 1e-3);
    let said = |text: String| {
        let path = case("numerical_bad.toml", &text);
        let output = carom(&["impact", &path]);
        assert_eq!(output.status.code(), Some(2));
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let text = std::fs::read_to_string(example("dissimilar_balls.toml")).unwrap();
    let infinite = said(text.replace("friction = 0.1", "friction = inf"));
    assert!(infinite.contains("contact.friction"), "{infinite}");
    let twisted = said(format!("{text}torsion = true\n"));
    assert!(twisted.contains("contact.torsion"), "{twisted}");
}
