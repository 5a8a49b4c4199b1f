//! The tables of fields: the reader, its errors, the examples and new cases agree with them.

use crate::common::{carom, case, examples, examples_in, refusal, stdout};
use carom_cases::case::{CaseKind, Entry, Form, Need};
use carom_drawn::{Congruential, Draw as _};
use std::collections::BTreeSet;
use toml::{Table, Value};

/// Paths of the fields of a case as the tables have them, and the words that stand there.
fn paths(prefix: &str, value: &Value, found: &mut BTreeSet<String>) {
    found.insert(prefix.to_owned());
    match value {
        Value::Table(table) => {
            for (name, value) in table {
                paths(&format!("{prefix}.{name}"), value, found);
            }
        }
        Value::Array(items) if items.iter().all(Value::is_table) => {
            found.insert(format!("{prefix}[]"));
            items.iter().for_each(|item| paths(&format!("{prefix}[]"), item, found));
        }
        Value::Array(items) => {
            items.iter().filter(|item| item.is_table()).for_each(|item| paths(prefix, item, found));
        }
        Value::String(word) => {
            found.insert(format!("{prefix} = {word}"));
        }
        _ => {}
    }
}

/// Bodies and their materials alike, and what stands for a number under `*`.
fn merged(path: &str, entries: &[Entry]) -> String {
    let path = path.trim_start_matches('.').replace("body_2", "body_1");
    // A part of a table that shares its name with a number.
    if entries.iter().any(|entry| entry.path == path) && !path.contains(".material.") {
        return path;
    }
    let number = |entry: &&Entry| matches!(entry.field.form, Form::Number(_) | Form::Vector(..));
    let varied = entries
        .iter()
        .filter(number)
        .find_map(|entry| path.strip_prefix(&entry.path).and_then(|rest| rest.strip_prefix('.')));
    match (varied, path.split_once(".material.")) {
        (Some(varied), _) => format!("*.{varied}"),
        (None, Some((_, field))) => format!("material.{field}"),
        (None, None) => path,
    }
}

#[test]
fn every_field_and_every_word_stands_in_an_example() {
    let mut lacking = Vec::new();
    let mut common = BTreeSet::new();
    for kind in CaseKind::ALL {
        let entries = kind.entries();
        let mut found = BTreeSet::new();
        for (_, text) in [examples(kind), examples_in("fit", kind)].concat() {
            paths("", &Value::Table(text.parse().unwrap()), &mut found);
        }
        let mut found: BTreeSet<String> = found.iter().map(|path| merged(path, &entries)).collect();
        // Examples of one kind have all materials, those of another all gaps.
        let is_common = |path: &&String| path.starts_with("material.") || path.starts_with("gap.");
        common.extend(found.iter().filter(is_common).cloned());
        found.extend(common.iter().cloned());
        for entry in &entries {
            let path = merged(&entry.path, &[]);
            let words = match entry.field.form {
                Form::Word(words) | Form::WordOrVector(words, ..) => words,
                _ => &[],
            };
            let default = entry.field.default_text().unwrap_or_default();
            let words = words.iter().filter(|(word, _)| format!("{word:?}") != default);
            let words = words.map(|(word, _)| format!("{path} = {word}"));
            let wanted = std::iter::once(path.clone()).chain(words);
            lacking.extend(wanted.filter(|path| !found.contains(path)).map(|p| (kind.name, p)));
        }
    }
    assert!(lacking.is_empty(), "no example has {lacking:#?}");
}

#[test]
fn a_new_case_of_every_kind_passes_and_runs() {
    for kind in CaseKind::ALL {
        let text = stdout(&["new", kind.name]);
        assert_eq!(text, kind.template());
        let file = case(&format!("new_{}.toml", kind.name), &text);
        let checked = stdout(&["check", &file]);
        assert!(checked.starts_with(&format!("a case for `carom {}`\n", kind.name)), "{checked}");
        assert!(!stdout(&[kind.name, &file, "--format", "csv"]).is_empty());
        // Every field is there, in force or behind #, with its meaning.
        for entry in kind.entries().iter().filter(|entry| !entry.path.starts_with('*')) {
            let name = entry.field.name;
            let is_there = text.lines().any(|line| {
                let line = line.trim_start_matches('#').trim_matches(['[', ']']);
                line.starts_with(&format!("{name} = ")) || line == entry.path.replace("[]", "")
            });
            assert!(is_there, "{}: {}", kind.name, entry.path);
            let flat = |text: &str| {
                let words = text.split(|c: char| c.is_whitespace() || c == '#');
                words.filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
            };
            assert!(flat(&text).contains(&flat(&entry.field.meaning[1..])), "{}", entry.path);
        }
    }
}

#[test]
fn a_short_new_case_has_what_is_necessary_and_runs() {
    for kind in CaseKind::ALL {
        let text = stdout(&["new", kind.name, "--short"]);
        let file = case(&format!("short_{}.toml", kind.name), &text);
        let output = carom(&[kind.name, &file, "--format", "csv"]);
        assert!(output.status.success() && !output.stdout.is_empty(), "{}", kind.name);
        let told = String::from_utf8(output.stderr).unwrap();
        assert!(!told.contains("warning"), "{}: {told}", kind.name);
        assert!(text.lines().count() < 45, "{}: {}", kind.name, text.lines().count());
        // The same values as in the long one.
        let given = |text: &str| -> Vec<_> {
            let told = kind.understood(text).unwrap().into_iter().filter(|told| told.is_given);
            told.map(|told| (told.field, told.value)).collect()
        };
        assert_eq!(given(&text), given(&kind.template()));
    }
}

#[test]
fn what_stands_behind_a_sign_in_a_new_case_is_well_formed() {
    for kind in CaseKind::ALL {
        for line in kind.template().lines().filter(|line| !line.starts_with("# ")) {
            let line = line.trim_start_matches('#');
            assert!(line.parse::<Table>().is_ok(), "{line}");
            assert!(!line.ends_with("= "), "{line}");
        }
    }
}

#[test]
fn every_example_passes_check() {
    for kind in CaseKind::ALL {
        for (name, text) in examples(kind) {
            assert_eq!(CaseKind::of(&text), Ok(kind), "{name}");
            assert_eq!(kind.check(&text), Ok(()), "{name}");
            let told = kind.understood(&text).unwrap();
            let given = told.iter().filter(|told| told.is_given).count();
            assert!(given > 4 && told.iter().all(|told| !told.value.is_empty()), "{name}");
        }
    }
}

/// Each field of a table and those below it, by the way there.
fn fields(table: &Table, way: &[String], visit: &mut dyn FnMut(&[String])) {
    for (name, value) in table {
        let way = [way, std::slice::from_ref(name)].concat();
        visit(&way);
        match value {
            Value::Table(table) => fields(table, &way, visit),
            Value::Array(items) => {
                if let Some(Value::Table(table)) = items.first() {
                    fields(table, &way, visit);
                }
            }
            _ => {}
        }
    }
}

/// The table that holds the last of the names.
fn holder<'a>(table: &'a mut Table, way: &[String]) -> &'a mut Table {
    way[..way.len() - 1].iter().fold(table, |table, name| match &mut table[name] {
        Value::Table(table) => table,
        Value::Array(items) => items[0].as_table_mut().unwrap(),
        other => panic!("{other}"),
    })
}

fn changed(text: &str, way: &[String], change: impl Fn(&mut Table, &str)) -> String {
    let mut table: Table = text.parse().unwrap();
    change(holder(&mut table, way), way.last().unwrap());
    toml::to_string(&table).unwrap()
}

#[test]
fn every_mistyped_field_names_the_right_one() {
    let mut count = 0;
    for kind in CaseKind::ALL {
        for (example, text) in examples(kind) {
            fields(&text.parse().unwrap(), &[], &mut |way| {
                let name = way.last().unwrap();
                let mistyped = format!("{name}x");
                let bad = changed(&text, way, |table, name| {
                    let value = table.remove(name).unwrap();
                    table.insert(mistyped.clone(), value);
                });
                let message = kind.check(&bad).unwrap_err().to_string();
                let said = format!("{mistyped}`, did you mean `{name}`?");
                assert!(message.contains(&said), "{example}, {way:?}: {message}");
                let here = |line: &str| line.trim_start_matches('[').starts_with(&mistyped);
                let line = bad.lines().position(here).map_or(0, |line| line + 1);
                let said = format!("line {line}: unknown field");
                assert!(line == 0 || message.contains(&said), "{example}, {way:?}: {message}");
                count += 1;
            });
        }
    }
    assert!(count > 300, "{count}");
}

#[test]
fn every_bad_value_is_refused_with_the_words_of_the_table() {
    let mut count = 0;
    for kind in CaseKind::ALL {
        let entries = kind.entries();
        for (example, text) in examples(kind) {
            fields(&text.parse().unwrap(), &[], &mut |way| {
                let path = way.join(".").replace("wall.", "wall[].").replace("step.", "step[].");
                let same = |entry: &&Entry| entry.path == path;
                let all: Vec<&Entry> = entries.iter().filter(same).collect();
                let Some(entry) = all.first().filter(|_| all.len() == 1) else { return };
                let set = |value: Value| {
                    changed(&text, way, |table, name| {
                        table.insert(name.to_owned(), value.clone());
                    })
                };
                let message = |value: Value| kind.check(&set(value)).unwrap_err().to_string();
                // A date is a value of no field.
                let said = message(Value::Datetime("2026-01-01".parse().unwrap()));
                assert!(said.contains("2026-01-01 is not allowed: must be"), "{said}");
                assert!(said.contains(entry.field.name), "{example}, {path}: {said}");
                if let Form::Number(measure) | Form::Numbers(measure) = entry.field.form {
                    let said = message(Value::Float(f64::NAN));
                    let path = path.replace("[]", "[0]");
                    let want = format!(
                        "`{path}` = NaN is out of range: must be {}",
                        measure.range.allowed()
                    );
                    assert!(said.ends_with(&want), "{example}: {said}, not {want}");
                }
                count += 1;
            });
        }
    }
    assert!(count > 300, "{count}");
}

#[test]
fn what_must_be_there_is_missed() {
    for kind in CaseKind::ALL {
        let entries = kind.entries();
        for (example, text) in examples(kind) {
            fields(&text.parse().unwrap(), &[], &mut |way| {
                let path = way.join(".").replace("wall.", "wall[].").replace("step.", "step[].");
                let path = if way.len() == 1 && ["wall", "step"].contains(&way[0].as_str()) {
                    format!("{path}[]")
                } else {
                    path
                };
                let must =
                    |entry: &Entry| entry.path == path && matches!(entry.field.need, Need::Must);
                let alike = entries.iter().filter(|entry| entry.path == path).count();
                if alike != 1 || !entries.iter().any(must) {
                    return;
                }
                let bad = changed(&text, way, |table, name| {
                    table.remove(name);
                });
                let said = kind.check(&bad).unwrap_err().to_string();
                let name = way.last().unwrap();
                assert!(
                    said.contains(&format!("{name}` is missing: must be")),
                    "{example}: {said}"
                );
            });
        }
    }
}

#[test]
fn a_schema_has_every_field_in_every_format() {
    for kind in CaseKind::ALL {
        let [table, json, csv] = ["table", "json", "csv"]
            .map(|format| stdout(&["schema", kind.name, "--format", format]));
        let json: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(json.as_array().unwrap().len(), kind.entries().len());
        assert_eq!(csv.lines().count(), kind.entries().len() + 1);
        for entry in kind.entries() {
            assert!(table.contains(&entry.path), "{}", entry.path);
        }
    }
    let impact: serde_json::Value =
        serde_json::from_str(&stdout(&["schema", "impact", "--format", "json"])).unwrap();
    let poisson = |field: &&serde_json::Value| field["field"] == "body_1.material.poisson";
    let poisson = impact.as_array().unwrap().iter().find(poisson).unwrap();
    assert_eq!((&poisson["low"], &poisson["high"]), (&(-1.0).into(), &0.5.into()));
    assert_eq!((&poisson["low_is_in"], &poisson["high_is_in"]), (&"no".into(), &"yes".into()));
}

#[test]
fn check_says_what_is_wrong_and_reads_the_files_of_a_case() {
    let heights = "[body_1]\nmaterial = { rigid = true }\n[body_2]\nmaterial = { shear_modulus = 1, \
                   poisson = 0.5 }\n[gap]\nshape = \"heights\"\nfile = \"no_such.csv\"\n[grid]\n\
                   cells = [3, 2]\nsize = [3, 2]\n[contact]\nfriction = 0\n[[step]]\nzeta = 0.1\n";
    let output = carom(&["check", &case("check_heights.toml", heights)]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("no_such.csv"));
    // A mistyped table does not change the kind.
    for (kind, old, new) in [
        (CaseKind::Hertz, "[load]", "[laod]"),
        (CaseKind::Scene, "[scene]", "[scen]"),
        (CaseKind::Impact, "[contact]", "[contacts]"),
    ] {
        let (_, text) = examples(kind).remove(0);
        let said = refusal(&["check", &case("check_kind.toml", &text.replace(old, new))]);
        assert!(
            said.contains(&format!("did you mean `{}`", old.trim_matches(['[', ']']))),
            "{said}"
        );
    }
}

/// A whole number below `end`.
fn next(draw: &mut Congruential, end: usize) -> usize {
    (draw.bits() >> 33) as usize % end.max(1)
}

#[test]
fn no_slip_of_the_hand_is_more_than_an_error() {
    const SLIPS: [&str; 12] =
        ["", "0", "-", "e9", "\"", "[", "]", "= ", "inf", " mm", "\n[x]\n", "{ mean = 1, sd = 1 }"];
    let mut draw = Congruential(9);
    let mut refused = 0;
    for kind in CaseKind::ALL {
        for (example, text) in examples(kind) {
            // Comments are as wrong as right.
            let text: String = text
                .lines()
                .map(|line| {
                    line.split(" #").next().unwrap_or_default().trim_end().to_owned() + "\n"
                })
                .filter(|line| !line.starts_with('#'))
                .collect();
            // Grids of a million cells are valid, and slow.
            let letters: Vec<char> = text.replace("count = 1", "count = 2").chars().collect();
            for _ in 0..40 {
                let place = next(&mut draw, letters.len());
                let end = (place + next(&mut draw, 4)).min(letters.len());
                let (before, after) = (&letters[..place], &letters[end..]);
                let slip = SLIPS[next(&mut draw, SLIPS.len())];
                let bad =
                    before.iter().collect::<String>() + slip + &after.iter().collect::<String>();
                let kind = CaseKind::of(&bad).unwrap_or(kind);
                if let Err(error) = kind.check(&bad) {
                    let said = error.to_string();
                    assert!(!said.is_empty() && said.len() < 3000, "{example}: {said}");
                    assert!(!said.contains("NaN is out of range") || bad.contains("nan"), "{said}");
                    refused += 1;
                } else {
                    kind.understood(&bad).unwrap();
                }
            }
        }
    }
    assert!(refused > 500, "{refused}");
}
