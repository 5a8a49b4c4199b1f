//! A sphere with an explicit position gives the same results as without: columns, signs, regimes, numbers.

use crate::common;

use crate::common::examples;
use crate::common::pebble::{all_close, numbers, refused, solved};
use crate::common::stdout;
use carom_cases::case::CaseKind;
use toml::{Table, Value};

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

/// The bodies of an impact, where the command puts them.
fn centres(record: &serde_json::Value) -> [Vec<f64>; 2] {
    let record = record.get(0).unwrap_or(record);
    ["centre_1", "centre_2"].map(|name| numbers(&record["contact"][name]))
}

/// The case with both bodies in these places, and no contact point of its own.
fn placed(case: &Table, centres: &[Vec<f64>; 2]) -> Table {
    let mut case = case.clone();
    for (body, centre) in ["body_1", "body_2"].into_iter().zip(centres) {
        let centre = centre.iter().map(|part| Value::Float(*part)).collect();
        set(&mut case, body, "position", Value::Array(centre));
    }
    for point in ["point", "point_1", "point_2"] {
        take(&mut case, "contact", point);
    }
    case
}

/// The case with no places.
fn unplaced(case: &Table) -> Table {
    let mut case = case.clone();
    for body in ["body_1", "body_2"] {
        take(&mut case, body, "position");
    }
    case
}

fn set(case: &mut Table, table: &str, name: &str, value: Value) {
    case[table].as_table_mut().unwrap().insert(name.to_owned(), value);
}

fn take(case: &mut Table, table: &str, name: &str) -> Option<Value> {
    case[table].as_table_mut().unwrap().remove(name)
}

fn shape<'a>(case: &'a Table, body: &str) -> &'a str {
    case[body]["shape"].as_str().unwrap()
}

#[test]
fn a_place_changes_nothing_but_the_place() {
    let mut count = 0;
    for (name, text) in examples(CaseKind::Impact) {
        let case_as_it_is: Table = text.parse().unwrap();
        let shapes = ["body_1", "body_2"].map(|body| shape(&case_as_it_is, body));
        // Of other bodies the place is part of the case; a scatter may change the radius.
        if shapes.iter().any(|shape| !matches!(*shape, "sphere" | "plane" | "half-space"))
            || case_as_it_is.contains_key("uncertainty")
        {
            continue;
        }
        let nowhere = unplaced(&case_as_it_is);
        let stem = name.trim_end_matches(".toml");
        let solve = |case: &Table, which: &str| {
            solved(&format!("{stem}-{which}"), &toml::to_string(case).unwrap())
        };
        let here = solve(&nowhere, "here");
        let there = centres(&here);
        // Along the contact as well.
        let aside = there.clone().map(|centre| vec![centre[0] + 0.1, centre[1] - 0.2, centre[2]]);
        for (which, centres) in [("there", &there), ("aside", &aside)] {
            let with = placed(&nowhere, centres);
            alike(&here, &solve(&with, which));
            // Columns and courses of one place are those of the other; on a grid they take seconds.
            if which == "there" || text.contains("\"numerical\"") {
                continue;
            }
            let csv = |case: &Table, more: &[&str]| {
                let text = toml::to_string(case).unwrap();
                let file = common::case(&format!("{stem}-columns.toml"), &text);
                stdout(&[&["impact", &file], more].concat())
            };
            let head =
                |case: &Table| csv(case, &["--format", "csv"]).lines().next().map(str::to_owned);
            assert_eq!(head(&nowhere), head(&with), "{name}");
            if !here.is_array() {
                let history = |case: &Table| -> serde_json::Value {
                    let more = ["--history", "21", "--format", "json"];
                    serde_json::from_str(&csv(case, &more)).unwrap()
                };
                alike(&history(&nowhere)["history"], &history(&with)["history"]);
            }
        }
        count += 1;
    }
    assert!(count >= 6, "{count}");
}

#[test]
fn a_place_changes_no_scatter() {
    let (_, text) = examples(CaseKind::Impact)
        .into_iter()
        .find(|(_, text)| text.contains("[uncertainty]"))
        .unwrap();
    // In the text: the order of the fields is that of the draws.
    let with = |text: &str, table: &str, line: &str| {
        assert!(text.contains(table));
        text.replacen(table, &format!("{table}\n{line}"), 1)
    };
    let few = text.replace("samples = 10000", "samples = 300");
    let here = solved("scatter-here", &few);
    // The radius is uncertain: from afar the ball comes until it touches.
    let stuck = with(&few, "[body_1]", "position = [0, 0, 0.1]");
    let there = solved("scatter-there", &with(&stuck, "[contact]", "search = \"approach\""));
    let [here, there] = [&here, &there].map(|report| report["outcome"].as_array().unwrap());
    assert_eq!(here.len(), there.len());
    for (one, other) in here.iter().zip(there) {
        assert_eq!((&one["name"], &one["count"]), (&other["name"], &other["count"]));
        let number = |spread: &serde_json::Value, name: &str| spread[name].as_f64().unwrap();
        let size = number(one, "maximum").abs().max(number(one, "minimum").abs());
        for name in ["mean", "sd", "standard_error", "minimum", "maximum"] {
            let off = (number(one, name) - number(other, name)).abs();
            // What is nothing but round-off has no size.
            assert!(off <= 1e-12 * size.max(1e-3), "{}, {name}: {off} of {size}", one["name"]);
        }
    }
    // Where it stands it does not.
    let said = refused("scatter-stuck", &stuck);
    assert!(said.contains("body_1.position") && said.contains("do not touch"), "{said}");
}

#[test]
fn a_place_changes_no_scene() {
    for (name, text) in examples(CaseKind::Scene) {
        let mut case: Table = text.parse().unwrap();
        match take(&mut case, "scene", "start") {
            Some(start) => set(&mut case, "ball", "position", start),
            None => {
                let position = take(&mut case, "ball", "position").unwrap();
                set(&mut case, "scene", "start", position);
            }
        }
        let run = |which: &str, text: &str| {
            let file = common::case(&format!("{which}-{name}"), text);
            stdout(&["scene", &file, "--format", "json", "--points", "11"])
        };
        assert_eq!(run("old", &text), run("new", &toml::to_string(&case).unwrap()), "{name}");
    }
}

/// Two spheres that spin.
fn spheres() -> String {
    r#"[body_1]
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
law = "coulomb"
torsion = true
"#
    .to_owned()
}

/// Body 2 lies below body 1 wherever that is.
#[test]
fn a_place_of_body_1_alone_takes_body_2_along() {
    let here = spheres();
    let place = [0.04, -0.07, 0.02];
    let there = here.replace("radius = 0.01\n", &format!("radius = 0.01\nposition = {place:?}\n"));
    let (here, there) = (solved("below-here", &here), solved("below-there", &there));
    alike(&here, &there);
    let [first, second] = centres(&there);
    for axis in 0..3 {
        let below = [0.0, 0.0, 0.03][axis];
        assert!((first[axis] - place[axis]).abs() < 1e-15, "{first:?}");
        assert!((first[axis] - second[axis] - below).abs() < 1e-15, "{first:?} {second:?}");
    }
}

#[test]
fn a_sphere_with_a_place_is_the_sphere_of_a_simple_case() {
    let simple = spheres();
    let placed = simple
        .replace("radius = 0.01\n", "radius = 0.01\nposition = [0, 0, 0.01]\n")
        .replace("radius = 0.02\n", "radius = 0.02\nposition = [0, 0, -0.02]\n");
    let (one, other) = (solved("simple", &simple), solved("placed", &placed));
    assert_eq!(one["method"], "uncoupled");
    // The spin acts on the shift, which only rings count: the bound of it is in the estimate.
    assert!((0.0..0.02).contains(&one["error_estimate"].as_f64().unwrap()));
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
    let before = numbers(&other["body_1_velocity"]);
    let after = numbers(&turned["body_1_velocity"]);
    all_close(&after, &[before[2], before[0], before[1]], 1e-12);
}
