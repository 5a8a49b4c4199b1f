//! The gallery of the book: every example with its picture, its question, what one sees, and a number to check. The words
//! are those at the head of the example, and the number is compared with what the command computes.

use super::{agrees, blocks, chapters, root, sources};
use crate::common::folder;
use carom_cases::case::CaseKind;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

/// Units of the numbers to check, those of two words first.
const UNITS: &[(&str, f64)] = &[
    ("N mm", 1e-3),
    ("N m", 1.0),
    ("N/m", 1.0),
    ("m/s", 1.0),
    ("rad/s", 1.0),
    ("rad/m", 1.0),
    ("mrad", 1e-3),
    ("mm2", 1e-6),
    ("m2", 1.0),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("kN", 1e3),
    ("N", 1.0),
    ("GPa", 1e9),
    ("MPa", 1e6),
    ("kPa", 1e3),
    ("mJ", 1e-3),
    ("J", 1.0),
];
/// All pictures of the gallery together, bytes.
const MOST: u64 = 3 << 20;

/// An example and the words at its head.
struct Example {
    name: String,
    kind: CaseKind,
    question: String,
    seen: String,
    check: String,
}

fn examples() -> Vec<Example> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(root().join("examples")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|end| end == "toml") {
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            found.push(told(name, &std::fs::read_to_string(&path).unwrap()));
        }
    }
    found.sort_by(|one, other| one.name.cmp(&other.name));
    found
}

/// Question, what one sees and what to check, from the comment at the head; conventions come after them.
fn told(name: String, source: &str) -> Example {
    let lines = source.lines().map_while(|line| line.strip_prefix("# "));
    let head: Vec<&str> = lines.take_while(|line| !line.starts_with("SI units")).collect();
    let head = head.join(" ");
    let (question, rest) = head.split_once("? ").unwrap_or_else(|| panic!("{name}: no question"));
    let (seen, check) =
        rest.split_once(" Check: ").unwrap_or_else(|| panic!("{name}: no number to check"));
    let kind = CaseKind::of(source).unwrap();
    let [seen, check] = [seen, check].map(str::to_owned);
    Example { name, kind, question: format!("{question}?"), seen, check }
}

/// The commands of the other chapters that draw a picture of an example, by example.
fn drawn() -> BTreeMap<String, (String, String)> {
    let mut found = BTreeMap::new();
    for (path, text) in chapters(&sources()) {
        if path.ends_with("gallery.md") {
            continue;
        }
        for line in blocks(&text, "sh").into_iter().flat_map(str::lines) {
            let name = line.split_once("examples/").and_then(|(_, rest)| rest.split_once(".toml"));
            let picture = line.split_once("--plot pictures/").map(|(_, name)| name.trim());
            if let (Some((name, _)), Some(picture)) = (name, picture) {
                let place = (format!("pictures/{picture}"), line.trim().to_owned());
                found.entry(name.to_owned()).or_insert(place);
            }
        }
    }
    found
}

/// Computes the example, into a picture too if there is a place for it.
fn computed(example: &Example, picture: Option<&Path>) -> Value {
    let case = root().join(format!("examples/{}.toml", example.name));
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.arg(example.kind.name).arg(case).args([
        "--quiet",
        "--threads",
        "1",
        "--format",
        "json",
    ]);
    if let Some(picture) = picture {
        command.arg("--plot").arg(picture);
    }
    let output = command.output().unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {stderr}", example.name);
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The value with this path; of rows that with this index, which a single row need not have.
fn value<'a>(results: &'a Value, path: &str, row: Option<usize>) -> Option<&'a Value> {
    let row_of = |place: &'a Value| match (place.as_array(), row) {
        (Some(rows), Some(row)) => rows.get(row.min(rows.len() - 1)),
        (Some(rows), None) if rows.len() == 1 => rows.first(),
        (Some(_), None) => None,
        (None, _) => Some(place),
    };
    let mut place = results;
    for part in path.split('.') {
        let named = place.as_array().and_then(|all| all.iter().find(|one| one["name"] == part));
        if let Some(named) = named {
            place = named;
            continue;
        }
        place = row_of(place)?;
        place = match (place.get(part), part.rsplit_once('_')) {
            (Some(found), _) => found,
            (None, Some((vector, axis))) => {
                place.get(vector)?.get(["x", "y", "z"].iter().position(|name| *name == axis)?)?
            }
            (None, None) => return None,
        };
    }
    Some(place)
}

/// Compares the number of `NAME = NUMBER UNIT, in row N` with the results, to its last digit.
fn compare(example: &Example, results: &Value) {
    let Example { name, check, .. } = example;
    let fault = |what: &str| -> ! { panic!("{name}: {what}: {check}") };
    let Some((path, rest)) = check.split_once(" = ") else { fault("no number") };
    let (number, rest) = rest.split_once(' ').unwrap_or((rest, ""));
    let number = number.trim_end_matches(['.', ',', ';']);
    let Ok(given) = number.parse::<f64>() else { fault("no number") };
    let is_word = |rest: &str| !rest.starts_with(|letter: char| letter.is_alphanumeric());
    let unit = UNITS.iter().find(|(unit, _)| rest.strip_prefix(unit).is_some_and(is_word));
    let scale = unit.map_or(1.0, |(_, scale)| *scale);
    let (mantissa, exponent) = number.split_once('e').unwrap_or((number, "0"));
    let digits = mantissa.split_once('.').map_or(0, |(_, digits)| digits.len());
    let step = scale * 10_f64.powi(exponent.parse::<i32>().unwrap() - digits as i32);
    let row = match rest.split_once(" row") {
        Some((before, _)) if before.ends_with("last") => Some(usize::MAX),
        Some((_, after)) => {
            let after = after.trim_start().split(|letter: char| !letter.is_ascii_digit()).next();
            after.and_then(|row| row.parse::<usize>().ok()).map(|row| row - 1)
        }
        None => None,
    };
    let Some(found) = value(results, path, row).and_then(Value::as_f64) else { fault("no value") };
    if (found - given * scale).abs() > 0.5001 * step {
        fault(&format!("the command gives {found}"));
    }
}

#[test]
fn the_gallery_shows_every_example() {
    let (folder, drawn) = (folder(), drawn());
    let pictures = sources().join("gallery");
    let mut page = String::from(
        "# Gallery\n\nAll examples of the folder `examples`: what each asks, what its picture shows, and a number of its \
         results that you can check. `NAME` is that of a column, or of a value in the JSON of `--format json`.\n\n\
         <!-- Made from the heads of the examples by `cargo xtask generate`. -->\n",
    );
    let examples = examples();
    let mut shown = 0;
    for kind in CaseKind::ALL {
        let _ = write!(page, "\n## {}\n\n{}\n", kind.name, kind.meaning);
        for example in examples.iter().filter(|example| example.kind == kind) {
            let Example { name, question, seen, check, .. } = example;
            let own = folder.join(format!("{name}.svg"));
            let is_drawn = drawn.contains_key(name);
            compare(example, &computed(example, (!is_drawn).then_some(own.as_path())));
            let (picture, command) = drawn.get(name).cloned().unwrap_or_else(|| {
                agrees(&pictures.join(format!("{name}.svg")), &std::fs::read(&own).unwrap());
                let command = format!("carom {} examples/{name}.toml --plot {name}.svg", kind.name);
                (format!("gallery/{name}.svg"), command)
            });
            let _ = write!(
                page,
                "\n### {name}\n\n**{question}**\n\n![{question}]({picture})\n\n{seen}\n\n*Check:* {check}\n\n\
                 `{command}`\n"
            );
            shown += usize::from(!is_drawn);
        }
    }
    agrees(&sources().join("gallery.md"), page.as_bytes());
    let kept =
        std::fs::read_dir(pictures).unwrap().map(|entry| entry.unwrap().metadata().unwrap().len());
    let kept: Vec<u64> = kept.collect();
    assert_eq!(kept.len(), shown, "a picture of no example");
    assert!(kept.iter().sum::<u64>() < MOST, "{kept:?}");
}

#[test]
fn a_wrong_number_is_found() {
    let results = serde_json::json!({
        "loads": [{ "force": 1.5 }, { "force": 2.25e3 }],
        "end": { "velocity": [0.0, 0.0, -1.25] },
        "outcome": [{ "name": "R_x", "mean": 0.281 }],
    });
    let compared = |check: &str| {
        let mut example = told("name".to_owned(), "# Why? So. Check: none\n");
        example.check = check.to_owned();
        std::panic::catch_unwind(|| compare(&example, &results)).is_ok()
    };
    for right in [
        "loads.force = 2.25 kN in the last row.",
        "loads.force = 1.5 N in row 1, by Hertz.",
        "end.velocity_z = -1.25 m/s.",
        "end.velocity_z = -1.3 m/s",
        "outcome.R_x.mean = 0.281, with",
    ] {
        assert!(compared(right), "{right}");
    }
    for wrong in [
        "loads.force = 2.26 kN in the last row.",
        "loads.force = 2.25 N in the last row.",
        "loads.force = 1.5 N.",
        "end.velocity_x = -1.25 m/s.",
        "outcome.R_y.mean = 0.281, with",
        "it is 3",
    ] {
        assert!(!compared(wrong), "{wrong}");
    }
}
