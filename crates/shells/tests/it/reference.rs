//! Reference values as JSON.

use serde_json::Value;

pub(crate) fn flange() -> Value {
    serde_json::from_str(include_str!("../data/flange.json")).unwrap()
}

pub(crate) fn bellows() -> Value {
    serde_json::from_str(include_str!("../data/bellows.json")).unwrap()
}

pub(crate) fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("no number {key} in {value}"))
}

pub(crate) fn list<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value[key].as_array().unwrap()
}

/// Asserts that two numbers differ by at most `relative` times the reference.
#[track_caller]
pub(crate) fn close(name: &str, found: f64, expected: f64, relative: f64) {
    let error = (found / expected - 1.0).abs();
    assert!(error <= relative, "{name}: {found} instead of {expected}, off by {error:e}");
}
