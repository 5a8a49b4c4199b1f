//! The command from the outside: results on standard output, exit codes, files.

use crate::common::{self, carom, case, close, example, fresh, json, refusal, stdout, stdout_at};
use carom_cases::case::CaseKind;

#[test]
fn a_sweep_gives_an_impact_an_angle() {
    let text = std::fs::read_to_string(example("alumina_on_plane.toml")).unwrap();
    let analytic = text.replace("friction = 0.092", "friction = 0.092\nlaw = \"coulomb\"");
    let records = json(&["impact", &case("alumina_analytic.toml", &analytic)]);
    let records = records.as_array().unwrap();
    assert_eq!(records.len(), 17);
    // Independent values of the spin for 5, 20 and 80 degrees.
    for (index, angle, spin) in [(0, 5.0, 87.84), (3, 20.0, 542.06), (15, 80.0, 124.61)] {
        close(&records[index]["angle"], angle, 1e-12);
        close(&records[index]["body_1_spin"][1], spin, 0.01);
    }
    assert!(records[0]["warnings"][0].as_str().unwrap().contains("dissimilar materials"));
}

#[test]
fn coupling_counts_unless_a_case_neglects_it() {
    let records = json(&["impact", &example("alumina_on_plane.toml")]);
    let first = &records[0];
    // R_x at 5 degrees on a grid of 64 cells; -0.095 if coupling is neglected.
    assert!((first["R_x"].as_f64().unwrap() - 0.368).abs() < 0.005, "{first}");
    assert_eq!(first["method"], "rings");
    let warnings = first["warnings"].as_array().unwrap();
    assert!(
        !warnings.iter().any(|warning| warning.as_str().unwrap().contains("dissimilar materials"))
    );
}

const FORMATS: [&str; 3] = ["json", "table", "csv"];

/// The cases in `examples/`, sorted by name, each with its command.
fn examples() -> Vec<(String, &'static str)> {
    let of =
        |kind: CaseKind| common::examples(kind).into_iter().map(move |(file, _)| (file, kind.name));
    let mut cases: Vec<_> = CaseKind::ALL.into_iter().flat_map(of).collect();
    cases.sort();
    assert!(cases.len() >= 50);
    cases
}

fn runs_and_draws((file, command): &(String, &'static str), format: &str) {
    let plot = fresh(&format!("{file}_{format}.svg"));
    let (case, picture) = (example(file), plot.to_str().unwrap());
    let width = [80, 100, 160][case.len() % 3];
    let told = stdout_at(width, &[command, &case, "--format", format, "--plot", picture]);
    match format {
        "json" => assert!(serde_json::from_str::<serde_json::Value>(&told).is_ok(), "{case}"),
        "csv" => assert!(told.lines().next().unwrap().contains(','), "{case}"),
        _ => {
            assert!(told.contains('│'), "{case}");
            let longest = told.lines().map(|line| line.chars().count()).max();
            assert!(longest <= Some(width), "{case} at {width}: {longest:?}");
        }
    }
    assert!(std::fs::read_to_string(&plot).unwrap().starts_with("<svg"));
}

/// The first example of each command as a table and as CSV, the others in one of these or not at all: as JSON and with
/// pictures the gallery runs each, and compares numbers.
#[test]
fn examples_run_and_draw_and_every_command_in_every_format() {
    let mut whole = Vec::new();
    for (i, example) in examples().iter().enumerate() {
        if whole.contains(&example.1) {
            FORMATS[1..].get(i % 3).into_iter().for_each(|format| runs_and_draws(example, format));
        } else {
            FORMATS[1..].iter().for_each(|format| runs_and_draws(example, format));
            whole.push(example.1);
        }
    }
}

#[test]
#[ignore = "every example in every format takes a minute"]
fn every_example_runs_in_every_format() {
    for example in examples() {
        FORMATS.iter().for_each(|format| runs_and_draws(&example, format));
    }
}

#[test]
fn a_history_runs_from_touch_to_separation() {
    let case = example("rubber_on_table.toml");
    let text = stdout(&["impact", &case, "--history", "101", "--format", "csv"]);
    let rows: Vec<Vec<&str>> = text.lines().skip(1).map(|row| row.split(',').collect()).collect();
    assert_eq!(rows.len(), 101);
    let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
    let heads: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let at = |name: &str| heads.iter().position(|head| *head == name).unwrap();
    let (along, normal) = (at("F_x"), at("F_z"));
    assert_eq!(number(0, normal), 0.0);
    assert!(number(100, normal).abs() < 1e-6 * number(50, normal));
    // Coulomb's bound at every instant.
    let bound = |i: usize| 0.3 * number(i, normal) * (1.0 + 1e-9);
    assert!((0..101).all(|i| number(i, along).abs() <= bound(i)));
    refusal(&["impact", &example("alumina_on_plane.toml"), "--history", "5"]);
}

const DROP: &str = "\
[body_1]
shape = \"sphere\"
radius = 0.01
material = { young_modulus = 2e11, poisson = 0.3 }
mass = 0.03
velocity = [0.5, 0, -1]
spin = [0, 0, 0]

[body_2]
shape = \"plane\"
material = { young_modulus = 2e11, poisson = 0.3 }
fixed = true

[contact]
friction = 0.2
";

#[test]
fn bad_cases_end_with_code_2_and_write_nothing() {
    for (old, new, expected) in [
        ("radius = 0.01", "radius = -1", "`body_1.radius` = -1 is out of range: must be"),
        ("radius = 0.01", "", "`body_1.radius` is missing"),
        ("radius", "radiuss", "did you mean `radius`?"),
        ("0.2", "nan", "`contact.friction` = NaN is out of range: must be"),
        ("fixed = true", "fixed = true\nmass = 1", "excludes"),
        ("mass = 0.03", "mass = inf", "a finite mass for at least one of the two bodies"),
    ] {
        let case = case("bad-case.toml", &DROP.replacen(old, new, 1));
        let plot = fresh("bad-case.svg");
        let stderr = refusal(&["impact", &case, "--plot", plot.to_str().unwrap()]);
        assert!(stderr.contains(expected), "{stderr}");
        assert!(!plot.exists());
    }
}

#[test]
fn limits_of_friction_and_approach_are_valid() {
    let impact = |name: &str, old: &str, new: &str| {
        json(&["impact", &case(name, &DROP.replacen(old, new, 1))])
    };
    close(&impact("frictionless.toml", "0.2", "0")["R_x"], -1.0, 0.0);
    let gripping = impact("gripping.toml", "0.2", "inf");
    assert!(gripping["R_x"].as_f64().unwrap().is_finite());
    let away = impact("away.toml", "-1]", "1]");
    assert_eq!(away["outcome"], "no_impact");
    for (name, before) in away["before"].as_object().unwrap() {
        assert_eq!(&away[name], before, "{name}");
    }
    assert_eq!(away["before"].as_object().unwrap().len(), 4);
    let grazing = impact("grazing.toml", "-1]", "-1e-9]");
    assert_eq!(grazing["outcome"], "rebound");
}

#[test]
fn without_an_impact_there_is_nothing_to_draw() {
    let case = case("resting.toml", &DROP.replacen("-1]", "0]", 1));
    let plot = fresh("resting.svg");
    let output = carom(&["impact", &case, "--plot", plot.to_str().unwrap()]);
    assert!(output.status.success() && !plot.exists());
    assert!(String::from_utf8_lossy(&output.stderr).contains("nothing to draw"));
}

#[test]
fn files_that_cannot_be_read_or_written_end_with_code_1() {
    let output = carom(&["impact", "no/such/case.toml"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("cannot read no/such/case.toml"));
    let arguments = ["impact", &example("steel_balls.toml"), "--plot", "no/such/folder/a.svg"];
    let output = carom(&arguments);
    assert_eq!(output.status.code(), Some(1));
    assert!(output.stdout.is_empty());
}

#[test]
fn the_last_regime_of_a_history_is_that_of_the_log() {
    let record = json(&["impact", &example("rubber_on_table.toml"), "--history", "3"]);
    let last = |list: &str| record[list].as_array().unwrap().last().unwrap()["regime"].clone();
    assert_eq!((last("history"), last("events")), ("slide-".into(), "slide-".into()));
}
