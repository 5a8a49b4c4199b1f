//! `carom impact` with uncertain inputs, as a user meets it.

use crate::common::{carom, case, fresh, refusal};
use std::path::Path;
use std::process::{Command, Output};

fn glass() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/glass_scatter.toml");
    std::fs::read_to_string(path).unwrap()
}

fn run(name: &str, text: &str, more: &[&str]) -> Output {
    let case = fresh(name);
    std::fs::write(&case, text).unwrap();
    carom(&[&["impact", case.to_str().unwrap()], more].concat())
}

fn report(name: &str, text: &str) -> serde_json::Value {
    let output = run(name, text, &["--format", "json"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn outcome<'a>(report: &'a serde_json::Value, name: &str) -> &'a serde_json::Value {
    report["outcome"].as_array().unwrap().iter().find(|spread| spread["name"] == name).unwrap()
}

/// A ball that slides throughout: R_x = -1 + 7 f/tan(angle).
const SLIDING: &str = "\
[body_1]
shape = \"sphere\"
radius = 0.01
material = { young_modulus = 2e9, poisson = 0.5 }
mass = 0.03
velocity = [1, 0, -1]
spin = [0, 0, 0]

[body_2]
shape = \"plane\"
material = { rigid = true }
fixed = true

[contact]
friction = { uniform = { low = 0.05, high = 0.15 } }

[uncertainty]
samples = 10000
seed = 4
";

#[test]
fn sliding_follows_the_closed_form() {
    let report = report("sliding.toml", SLIDING);
    let restitution = outcome(&report, "R_x");
    let friction = &report["inputs"][0];
    assert_eq!(friction["name"], "contact.friction");
    let (r, f) = (restitution["mean"].as_f64().unwrap(), friction["mean"].as_f64().unwrap());
    assert!((r - (7.0 * f - 1.0)).abs() < 1e-12);
    let sd = |spread: &serde_json::Value| spread["sd"].as_f64().unwrap();
    assert!((sd(restitution) / sd(friction) - 7.0).abs() < 1e-10);
    let [restitutions, frictions] =
        [restitution, friction].map(|spread| spread["quantiles"].clone());
    for (i, part) in [0.05, 0.25, 0.5, 0.75, 0.95].into_iter().enumerate() {
        let value = |all: &serde_json::Value| all[i]["value"].as_f64().unwrap();
        assert!((value(&restitutions) - (7.0 * value(&frictions) - 1.0)).abs() < 1e-12);
        assert!((value(&frictions) - (0.05 + 0.1 * part)).abs() < 2e-3, "{frictions}");
    }
    assert!((sd(friction) - 0.1 / 12f64.sqrt()).abs() < 4.0 * 0.45 * 0.0289 / 100.0);
    // The error of the mean of 10000.
    for spread in [restitution, friction] {
        let ratio = spread["standard_error"].as_f64().unwrap() / sd(spread);
        assert!((ratio - 0.01).abs() < 1e-12, "{ratio}");
    }
    let counts: u64 = restitution["histogram"]
        .as_array()
        .unwrap()
        .iter()
        .map(|bin| bin["count"].as_u64().unwrap())
        .sum();
    assert_eq!(counts, 10_000);
}

#[test]
fn components_of_a_velocity_may_scatter() {
    let normal = "[1, 0, { normal = { mean = -1, sd = 0.5 } }]";
    let text = SLIDING
        .replace("[1, 0, -1]", normal)
        .replace("{ uniform = { low = 0.05, high = 0.15 } }", "0.1");
    let report = report("component.toml", &text);
    assert_eq!(report["inputs"][0]["name"], "body_1.velocity.z");
    // P(v_z >= 0) = 2.275 %: the ball flies away.
    let none = report["no_impact"].as_f64().unwrap();
    assert!((none - 227.5).abs() < 4.0 * 15.0, "{none}");
}

#[test]
fn samples_out_of_range_are_told() {
    let text = SLIDING.replace(
        "{ uniform = { low = 0.05, high = 0.15 } }",
        "{ normal = { mean = 0.1, sd = 0.1 } }",
    );
    let output = run("negative.toml", &text, &[]);
    assert!(output.status.success());
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(stderr.contains("of 10000 samples are left out: contact.friction must be"), "{stderr}");
}

#[test]
fn the_same_seed_gives_the_same_bytes_on_any_threads() {
    let text = glass().replace("samples = 10000", "samples = 500");
    let case = fresh("threads.toml");
    std::fs::write(&case, &text).unwrap();
    let bytes = ["1", "2", "5"].map(|threads| {
        Command::new(env!("CARGO_BIN_EXE_carom"))
            .args(["impact", case.to_str().unwrap(), "--format", "json"])
            .env("RAYON_NUM_THREADS", threads)
            .output()
            .unwrap()
            .stdout
    });
    assert!(!bytes[0].is_empty() && bytes[0] == bytes[1] && bytes[1] == bytes[2]);
    let other = run("seed.toml", &text.replace("seed = 1", "seed = 2"), &["--format", "json"]);
    assert_ne!(other.stdout, bytes[0]);
}

#[test]
fn bad_uncertainty_ends_with_code_2_and_writes_nothing() {
    let text = glass();
    for (old, new, expected) in [
        ("sd = 0.006", "sd = -1", "`contact.friction.normal.sd` = -1 is out of range"),
        ("normal = { mean = 0.092", "nrmal = { mean = 0.092", "did you mean `normal`?"),
        ("mean = 0.092, ", "", "`contact.friction.normal.mean` is missing"),
        ("mean = 0.092", "mean = -0.092", "`contact.friction` = -0.092 is out of range"),
        ("low = 1.1", "low = 1.3", "`approach.speed.triangular.mode` = 1.2 is out of range"),
        ("low = 25", "low = nan", "`approach.angle.uniform.low` = NaN is out of range"),
        ("samples = 10000", "samples = 1", "line 27: `uncertainty.samples` = 1 is out of range"),
        ("samples = 10000", "", "`uncertainty.samples` is missing"),
        ("seed = 1", "seed = 0.5", "`uncertainty.seed` = 0.5 is out of range"),
        ("0.975]", "1.5]", "`uncertainty.quantiles` = 1.5 is out of range"),
        ("bins", "bin", "did you mean `bins`?"),
        ("density = 2500", "densty = 2500", "did you mean `density`?"),
        ("{ uniform = { low = 25, high = 27 } }", "[25, 26]", "excludes"),
        ("density = 2500", "density = { normal = 3 }", "`body_1.density.normal`"),
        ("fixed = true", "fixed = { normal = { mean = 1, sd = 1 } }", "true or false"),
    ] {
        assert!(text.contains(old), "{old}");
        let plot = fresh("bad-uncertainty.svg");
        let changed = case("bad.toml", &text.replacen(old, new, 1));
        let stderr = refusal(&["impact", &changed, "--plot", plot.to_str().unwrap()]);
        assert!(stderr.contains(expected), "{stderr}");
        assert!(!plot.exists());
    }
    let certain = text.replace("[uncertainty]", "[uncertanty]");
    refusal(&["impact", &case("typo.toml", &certain)]);
    refusal(&["impact", &case("history.toml", &text), "--history", "5"]);
}

/// A ball of an uncertain radius that is placed where most of the drawn ones do not touch.
#[test]
fn a_study_whose_bodies_do_not_touch_is_bad_input() {
    let text = SLIDING
        .replace("radius = 0.01", "radius = { uniform = { low = 0.0099, high = 0.0101 } }")
        .replace("mass = 0.03", "mass = 0.03\nposition = [0, 0, 0.01]")
        .replace("friction = { uniform = { low = 0.05, high = 0.15 } }", "friction = 0.1");
    let told = refusal(&["impact", &case("apart.toml", &text)]);
    assert!(told.contains("sample") && told.contains("touch"), "{told}");
}
