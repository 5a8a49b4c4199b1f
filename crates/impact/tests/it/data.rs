//! Reads the reference values.

use nalgebra::{Matrix3, Vector3};
use serde_json::Value;

/// The table of this name, or whose name begins so.
pub(crate) fn public(start: &str) -> Value {
    let data: Value = serde_json::from_str(include_str!("../data/impact.json")).unwrap();
    let tables = data["public"].as_object().unwrap();
    let begins = || tables.iter().find(|(name, _)| name.starts_with(start)).unwrap().1;
    tables.get(start).unwrap_or_else(begins).clone()
}

pub(crate) fn rows(start: &str) -> Vec<Value> {
    public(start).as_array().unwrap().clone()
}

/// A number, also as a string of more digits or as a fraction.
pub(crate) fn number(row: &Value, key: &str) -> f64 {
    row[key].as_f64().unwrap_or_else(|| match row[key].as_str().unwrap().split_once('/') {
        Some((p, q)) => p.parse::<f64>().unwrap() / q.parse::<f64>().unwrap(),
        None => row[key].as_str().unwrap().parse().unwrap(),
    })
}

pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

pub(crate) fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_row_slice(&numbers(value))
}

pub(crate) fn matrix(value: &Value) -> Matrix3<f64> {
    let rows: Vec<f64> = value.as_array().unwrap().iter().flat_map(numbers).collect();
    Matrix3::from_row_slice(&rows)
}
