//! Examples in another system of units: every number of a result changes as its unit says.

use crate::common::{case, example, json, stdout};
use carom_cases::case::{CaseKind, Field, Form, Measure};
use serde_json::Value as Json;
use std::collections::BTreeMap;
use toml::Value;

/// A metre, a kilogram and a second in the units of the other system: powers of two, which keep all digits.
const OTHER: [f64; 3] = [4.0, 0.125, 2.0];

const EXAMPLES: [(CaseKind, &str); 17] = [
    (CaseKind::Hertz, "hertz_ball_in_race.toml"),
    (CaseKind::Hertz, "hertz_roller.toml"),
    (CaseKind::History, "history_loop.toml"),
    (CaseKind::History, "history_static_friction.toml"),
    (CaseKind::Impact, "ball_standard_solid.toml"),
    (CaseKind::Impact, "crossed_capsules.toml"),
    (CaseKind::Impact, "steel_ball_waves.toml"),
    (CaseKind::Scene, "scene_static_friction.toml"),
    (CaseKind::Scene, "scene_superball.toml"),
    (CaseKind::Solve, "solve_plate_mindlin.toml"),
    (CaseKind::Solve, "solve_roller.toml"),
    (CaseKind::Solve, "solve_torsion_with_shift.toml"),
    (CaseKind::Roll, "roll_cylinders.toml"),
    (CaseKind::Roll, "roll_spinning.toml"),
    (CaseKind::Stress, "stress_ball.toml"),
    (CaseKind::Shell, "shell_flange_pried.toml"),
    (CaseKind::Shell, "shell_omega.toml"),
];

/// What one unit becomes, such as `N/m^1.5`; none for other words.
fn factor(unit: &str) -> Option<f64> {
    let part = |text: &str| text.split(' ').map(power).product::<Option<f64>>();
    match unit.split_once('/') {
        Some((above, below)) => Some(part(above)? / part(below)?),
        None => part(unit),
    }
}

/// That of a power of a unit, such as `m2`.
fn power(text: &str) -> Option<f64> {
    let end = text.find(['^', '2', '3']).unwrap_or(text.len());
    let exponent = text[end..].trim_start_matches('^').parse().unwrap_or(1.0);
    let [length, mass, time]: [i32; 3] = match &text[..end] {
        "" | "1" | "rad" | "deg" => [0, 0, 0],
        "m" => [1, 0, 0],
        "kg" => [0, 1, 0],
        "s" => [0, 0, 1],
        "N" => [1, 1, -2],
        "Pa" => [-1, 1, -2],
        "J" => [2, 1, -2],
        "W" => [2, 1, -3],
        _ => return None,
    };
    let [m, kg, s] = OTHER;
    Some((m.powi(length) * kg.powi(mass) * s.powi(time)).powf(exponent))
}

/// The value of a field in the other system.
fn scale(value: &mut Value, path: &str, fields: &BTreeMap<String, Field>) {
    let form = fields.get(path).map(|field| (field.form, field.measure()));
    match (value, form) {
        (Value::Table(table), None | Some((Form::Table(_) | Form::Tables(_), _))) => {
            for (name, inner) in table.iter_mut() {
                scale(inner, format!("{path}.{name}").trim_start_matches('.'), fields);
            }
        }
        (Value::Table(range), Some(_)) => {
            let ends = range.iter_mut().filter(|(name, _)| *name != "count");
            ends.for_each(|(_, end)| scale(end, path, fields));
        }
        (Value::Array(all), Some((Form::Rows(rows), _))) => {
            for row in all.iter_mut().filter_map(Value::as_array_mut) {
                for (item, measure) in row.iter_mut().zip(rows.measures) {
                    rescale(item, *measure);
                }
            }
        }
        (Value::Array(all), form) => {
            let tables = format!("{path}[]");
            let path = if form.is_none() { &tables } else { path };
            all.iter_mut().for_each(|item| scale(item, path, fields));
        }
        (value, Some((_, Some(measure)))) => rescale(value, measure),
        _ => {}
    }
}

fn rescale(value: &mut Value, Measure { range, dimension }: Measure) {
    let number = match value {
        Value::Integer(number) => Some(*number as f64),
        Value::Float(number) => Some(*number),
        Value::String(text) => dimension.read(text),
        _ => None,
    };
    if let Some(number) = number.filter(|_| !range.is_whole()) {
        *value = Value::Float(number * factor(dimension.unit()).unwrap());
    }
}

/// The units of the quantities that the help of a command explains.
fn units(kind: &str) -> BTreeMap<String, String> {
    let help = stdout(&[kind, "--help"]);
    let lines = help.lines().filter_map(|line| line.strip_prefix("  "));
    let parts = lines.filter(|line| line.starts_with(|first: char| first.is_alphabetic()));
    let unit = |line: &str| {
        let mut parts = line.split("  ").map(str::trim).filter(|part| !part.is_empty());
        let (name, unit) = (parts.next()?.split("_x,_").next()?, parts.next()?);
        Some((name.to_owned(), if factor(unit).is_some() { unit } else { "" }.to_owned()))
    };
    parts.filter_map(unit).collect()
}

/// All numbers below the names of a result.
fn numbers(value: &Json, name: &str, found: &mut BTreeMap<String, Vec<f64>>) {
    match value {
        Json::Object(all) => all.iter().for_each(|(name, value)| numbers(value, name, found)),
        Json::Array(all) => all.iter().for_each(|value| numbers(value, name, found)),
        Json::Number(number) => {
            found.entry(name.to_owned()).or_default().push(number.as_f64().unwrap());
        }
        _ => {}
    }
}

#[test]
fn results_in_other_units_are_the_same() {
    for (kind, name) in EXAMPLES {
        let text = std::fs::read_to_string(example(name)).unwrap();
        let fields = kind.entries().into_iter().map(|entry| (entry.path, entry.field)).collect();
        let mut table = Value::Table(text.parse().unwrap());
        scale(&mut table, "", &fields);
        let other = case(name, &table.as_table().unwrap().to_string());
        let units = units(kind.name);
        let [one, other] = [example(name), other].map(|file| {
            let mut found = BTreeMap::new();
            numbers(&json(&[kind.name, &file]), "", &mut found);
            found.retain(|name, _| units.contains_key(name));
            found
        });
        // What should vanish is round-off of the greatest number of its unit.
        let mut size: BTreeMap<&str, f64> = BTreeMap::new();
        for (quantity, values) in &one {
            let size = size.entry(&units[quantity]).or_default();
            *size = values.iter().fold(*size, |size, value| size.max(value.abs()));
        }
        assert!(one.len() > 5, "{name}: {one:?}");
        for (quantity, values) in &one {
            let unit = units[quantity].as_str();
            for (value, scaled) in values.iter().zip(&other[quantity]) {
                let back = scaled / factor(unit).unwrap();
                let is_same = (back - value).abs() <= 1e-7 * size[unit];
                assert!(is_same, "{name}: {quantity} in {unit} is {value}, then {back}");
            }
        }
    }
}
