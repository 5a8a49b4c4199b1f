//! The schemas in `docs/schema`, which `cargo xtask generate` writes. That they take every example and every new case and
//! refuse mistakes is tested by a validator of others, in `crates/python/tests/test_schema.py`.

use crate::book::{agrees, root};
use crate::common::{examples, folder, stdout};
use carom_cases::case::{CaseKind, Form, Need, entries};
use serde_json::Value;
use std::process::Command;

const MISTAKES: &str = include_str!("mistakes.toml");

fn schema(kind: CaseKind) -> Value {
    serde_json::from_str(&kind.json_schema()).unwrap()
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

/// Mistakes that the schemas must refuse.
#[test]
fn the_reader_refuses_the_mistakes() {
    let examples: Vec<_> = CaseKind::ALL.into_iter().flat_map(examples).collect();
    let mistakes: toml::Table = MISTAKES.parse().unwrap();
    let mistakes = mistakes["mistake"].as_array().unwrap();
    assert!(mistakes.len() >= 40);
    for mistake in mistakes {
        let [what, example, old, new] =
            ["what", "example", "old", "new"].map(|name| mistake[name].as_str().unwrap());
        let (_, source) = examples.iter().find(|(name, _)| name == example).unwrap();
        let wrong = source.replacen(old, new, 1);
        assert_ne!(&wrong, source, "{what}: {example} has no `{old}`");
        assert!(
            CaseKind::of(source).unwrap().check(&wrong).is_err(),
            "{what}: the reader takes it"
        );
    }
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
