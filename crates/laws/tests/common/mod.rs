//! Reading of reference tables and comparison with them.
#![allow(dead_code)]

use serde_json::Value;

/// A number given as a JSON number, or as a string of more digits than a double holds.
pub(crate) fn num(value: &Value) -> f64 {
    match value {
        Value::Number(n) => n.as_f64().unwrap(),
        Value::String(s) => s.parse().unwrap(),
        other => panic!("not a number: {other}"),
    }
}

/// The tables of one file.
pub(crate) fn tables(file: &str) -> Value {
    let path = format!("{}/tests/data/{file}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// The rows (inputs, outputs) of a table.
pub(crate) fn cases(file: &str, table: &str) -> Vec<(Value, Value)> {
    let rows = tables(file)[table].as_array().unwrap().clone();
    assert!(!rows.is_empty());
    rows.into_iter().map(|row| (row["inp"].clone(), row["out"].clone())).collect()
}

/// Asserts `got = want` within a relative tolerance.
#[track_caller]
pub(crate) fn close(name: &str, got: f64, want: f64, tolerance: f64) {
    let error = (got - want).abs() / want.abs().max(f64::MIN_POSITIVE);
    assert!(error <= tolerance, "{name}: {got:e} for {want:e}, relative error {error:e}");
}
