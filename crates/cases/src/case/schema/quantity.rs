//! The schema of a number: its range, and the texts with a unit that may replace it.

use super::json::{Json, map, texts};
use crate::case::range::{End, Range};
use crate::case::unit::{Dimension, Measure};

/// A whole or decimal number with an exponent.
const ANY: &str = "(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)";
/// The same with a digit that is not 0.
const NOT_ZERO: &str = "(?:[0-9]*[1-9][0-9]*\\.?[0-9]*|[0-9]*\\.[0-9]*[1-9][0-9]*)";
const EXPONENT: &str = "(?:[eE][-+]?[0-9]+)?";

/// The name of the schema of these numbers.
pub(super) fn name(Measure { range, dimension }: Measure) -> String {
    match dimension {
        Dimension::None => format!("{range:?}"),
        dimension => format!("{range:?}{dimension:?}"),
    }
}

/// A plain number in its range, or a text with a unit; values of the `other` types are not restricted. The range of a
/// text is checked as to sign and zero.
///
/// JSON has no infinity: taplo, which checks cases in editors, takes it for null, which TOML does not have.
pub(super) fn plain(measure: Measure, other: &[&str]) -> Json {
    let pattern = pattern(measure);
    let mut kinds = vec!["number"];
    kinds.extend(pattern.as_ref().map(|_| "string"));
    kinds.extend(may_be_infinite(measure.range).then_some("null"));
    kinds.extend(other);
    let kinds = if kinds.len() == 1 { "number".into() } else { texts(kinds) };
    let schema = bounded(map([("type", kinds)]), measure.range);
    match pattern {
        Some(pattern) => schema.with("pattern", pattern),
        None => schema,
    }
}

fn may_be_infinite(range: Range) -> bool {
    range.ends()[1] == End::In(f64::INFINITY)
}

/// Adds the ends of a range.
fn bounded(mut schema: Json, range: Range) -> Json {
    let names = [("minimum", "exclusiveMinimum"), ("maximum", "exclusiveMaximum")];
    for (end, (name, exclusive)) in range.ends().into_iter().zip(names) {
        schema = match end {
            End::In(end) if end.is_infinite() => schema,
            // Infinity lies beyond the largest number.
            End::Out(end) if end.is_infinite() => schema.with(name, f64::MAX.copysign(end)),
            End::In(end) => schema.with(name, end),
            End::Out(end) => schema.with(name, end).with(exclusive, true),
        };
    }
    if range.is_whole() {
        schema = schema.with("multipleOf", 1.0);
    }
    if range == Range::Radius {
        schema = schema.with("not", map([("enum", vec![0.0.into()].into())]));
    }
    schema
}

/// The texts that stand for a number of this measure; none if there are none.
fn pattern(Measure { range, dimension }: Measure) -> Option<String> {
    let units = dimension.unit_names().map(spelt).collect::<Vec<_>>().join("|");
    let [low, _] = range.ends();
    let sign = if low.number() >= 0.0 { "[+]?" } else { "[-+]?" };
    let digits = match range {
        Range::Radius => NOT_ZERO,
        _ if low == End::Out(0.0) => NOT_ZERO,
        _ => ANY,
    };
    let mut ways = Vec::new();
    if !units.is_empty() {
        ways.push(format!("{sign}{digits}{EXPONENT}\\s*(?:{units})"));
    }
    if may_be_infinite(range) {
        let unit = if units.is_empty() { String::new() } else { format!("(?:\\s*(?:{units}))?") };
        ways.push(format!("{sign}inf{unit}"));
    }
    match ways.is_empty() {
        true => None,
        false => Some(format!("^\\s*(?:{})\\s*$", ways.join("|"))),
    }
}

/// A unit in all the spellings that the reader takes.
fn spelt(unit: &str) -> String {
    let mut pattern = String::new();
    for letter in unit.replace("deg", "°").chars() {
        match letter {
            '°' => pattern.push_str("(?:deg|°)"),
            'u' => pattern.push_str("[uµμ]"),
            '2' => pattern.push_str("\\^?[2²]"),
            '3' => pattern.push_str("\\^?[3³]"),
            ' ' => pattern.push_str("[ ·*]"),
            plain => pattern.push(plain),
        }
    }
    pattern
}
