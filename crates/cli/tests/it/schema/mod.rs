//! The schemas in `docs/schema`: they take every example and every new case, and refuse mistakes that the reader
//! refuses. `cargo xtask generate` writes them.

mod draft_4;

use crate::book::{agrees, root};
use crate::common::{self, folder, stdout};
use carom_cases::case::{CaseKind, Form, Need, entries};
use serde_json::Value;
use std::process::Command;

const MISTAKES: &str = include_str!("mistakes.toml");

fn schema(kind: CaseKind) -> Value {
    serde_json::from_str(&kind.json_schema()).unwrap()
}

/// The text as JSON. It has no infinity: as in editors, null stands for it.
fn json(source: &str) -> Value {
    fn of(value: toml::Value) -> Value {
        match value {
            toml::Value::Table(table) => {
                table.into_iter().map(|(name, value)| (name, of(value))).collect()
            }
            toml::Value::Array(items) => items.into_iter().map(of).collect(),
            toml::Value::Float(number) => number.into(),
            toml::Value::Integer(number) => number.into(),
            toml::Value::Boolean(is_on) => is_on.into(),
            toml::Value::String(text) => text.into(),
            toml::Value::Datetime(_) => Value::Null,
        }
    }
    of(toml::Value::Table(source.parse().unwrap()))
}

fn examples() -> Vec<(String, String)> {
    let of = |kind| [common::examples(kind), common::examples_in("fit", kind)].concat();
    CaseKind::ALL.into_iter().flat_map(of).collect()
}

#[test]
fn the_files_of_the_schemas_are_what_the_tables_say() {
    let folder = root().join("docs/schema");
    for kind in CaseKind::ALL {
        let printed = stdout(&["schema", kind.name, "--json-schema"]);
        assert_eq!(printed, kind.json_schema());
        agrees(&folder.join(format!("{}.json", kind.name)), printed.as_bytes());
    }
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), CaseKind::ALL.len());
}

#[test]
fn a_schema_takes_all_cases_that_are_right() {
    let examples = examples();
    assert!(examples.len() > 70);
    for (name, source) in examples {
        let kind = CaseKind::of(&source).unwrap();
        assert_eq!(draft_4::faults(&schema(kind), &json(&source)), [""; 0], "{name}");
    }
    for kind in CaseKind::ALL {
        for source in [kind.template(), kind.short_template()] {
            assert_eq!(draft_4::faults(&schema(kind), &json(&source)), [""; 0], "{source}");
        }
    }
}

#[test]
fn a_schema_refuses_mistakes_that_the_reader_refuses() {
    let examples = examples();
    let mistakes: toml::Table = MISTAKES.parse().unwrap();
    let mistakes = mistakes["mistake"].as_array().unwrap();
    assert!(mistakes.len() >= 40);
    for mistake in mistakes {
        let [what, example, old, new] =
            ["what", "example", "old", "new"].map(|name| mistake[name].as_str().unwrap());
        let (_, source) = examples.iter().find(|(name, _)| name == example).unwrap();
        let kind = CaseKind::of(source).unwrap();
        let wrong = source.replacen(old, new, 1);
        assert_ne!(&wrong, source, "{what}: {example} has no `{old}`");
        assert!(kind.check(&wrong).is_err(), "{what}: the reader takes it");
        assert_ne!(draft_4::faults(&schema(kind), &json(&wrong)), [""; 0], "{what}");
    }
}

/// Units are spelt as the reader takes them.
#[test]
fn texts_with_units_are_those_of_the_reader() {
    let schema = schema(CaseKind::Impact);
    let right = [
        ("PositiveLength", &["10 mm", "1e3m", ".5 m", "5. µm", "5 μm", " 2E-3 km ", "+1 nm"][..]),
        ("PositiveDensity", &["7.85 g/cm^3", "7.85 g/cm³", "7850 kg/m3"]),
        ("SpeedSpin", &["3000 rpm", "-180 deg/s", "180 °/s", "2 1/min"]),
        ("PositiveOrInfiniteInertia", &["12 g·cm²", "12 g cm^2", "12 g*cm2", "inf", "inf kg m2"]),
        ("IncidenceDegrees", &["30°", "0 rad"]),
        ("Friction", &["inf", "+inf"]),
        ("RadiusLength", &["-inf", "-3 mm"]),
    ];
    let wrong = [
        (
            "PositiveLength",
            &["10", "10 mm2", "mm", "1e m", "10 MM", "- 1 m", "0 m", "inf", "1 m m"][..],
        ),
        ("SpeedSpin", &["3 rad", "inf rad/s"]),
        ("IncidenceDegrees", &["-30°", "30 °C"]),
        ("Friction", &["0.3", "-inf", "nan"]),
        ("RadiusLength", &["0 mm"]),
    ];
    let definitions = schemas_of_numbers();
    for (is_right, all) in [(true, &right[..]), (false, &wrong[..])] {
        for (name, texts) in all {
            let definition = definitions.get(*name).unwrap_or_else(|| panic!("{name}: {schema}"));
            for text in *texts {
                let faults = draft_4::faults(definition, &Value::from(*text));
                assert_eq!(faults.is_empty(), is_right, "{name}: {text}");
            }
        }
    }
}

/// The definitions of all kinds of cases.
fn schemas_of_numbers() -> serde_json::Map<String, Value> {
    let all = CaseKind::ALL.map(schema);
    all.iter().flat_map(|schema| schema["definitions"].as_object().unwrap().clone()).collect()
}

/// The schema takes its alternatives from the words of the table.
#[test]
fn what_replaces_a_field_is_a_field() {
    for kind in CaseKind::ALL {
        let all = kind.entries();
        let known = |path: &str| all.iter().any(|entry| entry.path == path);
        for entry in entries(kind.fields) {
            let Need::Or(words) = entry.field.need else { continue };
            let names: Vec<&str> = words.split('`').skip(1).step_by(2).collect();
            assert!(!names.is_empty(), "{}: {words}", entry.path);
            let table =
                entry.path.rsplit_once('.').map_or(String::new(), |(table, _)| format!("{table}."));
            for name in names {
                let name = name.strip_suffix(" = true").unwrap_or(name);
                assert!(known(&format!("{table}{name}")) || known(name), "{}: {name}", entry.path);
            }
        }
    }
}

/// Of a number or a table, the table.
fn of_table(place: &Value) -> &Value {
    let ways = place["anyOf"].as_array();
    let mut ways = ways.into_iter().flatten();
    let table = ways.find(|way| way["type"] == "object");
    table.filter(|_| place.get("properties").is_none()).unwrap_or(place)
}

#[test]
fn every_field_is_described_in_the_schema() {
    for kind in CaseKind::ALL {
        let schema = schema(kind);
        for entry in entries(kind.fields) {
            let names = entry.path.replace("[]", "");
            let mut place = &schema;
            for name in names.split('.') {
                let table =
                    if place["type"] == "array" { &place["items"] } else { of_table(place) };
                place = &table["properties"][name];
            }
            let is_table = matches!(entry.field.form, Form::Table(_));
            let place = if is_table { of_table(place) } else { place };
            let is_described = place.get("description").is_some() || place.get("anyOf").is_some();
            assert!(is_described, "{}: {place}", entry.path);
            if is_table {
                assert_eq!(place["additionalProperties"], false, "{}", entry.path);
            }
        }
    }
}

#[test]
fn a_new_case_names_its_schema_where_it_is_written() {
    let folder = folder();
    std::fs::create_dir(folder.join("cases")).unwrap();
    let new = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
        let output = command.arg("new").args(arguments).current_dir(&folder).output().unwrap();
        (output.status.success(), String::from_utf8(output.stdout).unwrap())
    };
    let (is_made, case) = new(&["hertz", "--schema"]);
    assert!(is_made && case.starts_with("#:schema ./hertz.schema.json\n# Two surfaces"), "{case}");
    let written = std::fs::read_to_string(folder.join("hertz.schema.json")).unwrap();
    assert_eq!(written, CaseKind::Hertz.json_schema());
    CaseKind::Hertz.check(&case).unwrap();
    let (_, case) = new(&["roll", "--short", "--schema=cases/rail.json"]);
    assert!(case.starts_with("#:schema ./rail.json\n#"), "{case}");
    assert!(folder.join("cases/rail.json").exists());
    assert!(!new(&["roll", "--schema=nowhere/rail.json"]).0);
    assert!(!new(&["roll"]).1.contains("#:schema"));
}
