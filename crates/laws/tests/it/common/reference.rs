//! Reading of reference tables.

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
    let path = format!("{}/../laws/tests/data/{file}.json", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}
