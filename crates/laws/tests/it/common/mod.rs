//! Reading of reference tables and comparison with them.
use carom_drawn::{Draw as _, Splitmix};
use serde_json::Value;

pub(crate) use reference::{num, tables};

pub(crate) mod balance;
pub(crate) mod load;
pub(crate) mod reference;
pub(crate) mod rings;
pub(crate) mod turning;

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

/// A random step of approach and shift: small and large, along and across, with pure changes of
/// one or the other, separations and gross slides among them.
pub(crate) fn next(random: &mut Splitmix, zeta: f64, x: [f64; 2]) -> (f64, [f64; 2]) {
    let size = 10_f64.powf(random.between(-4.0, 0.3));
    let angle = random.between(0.0, std::f64::consts::TAU);
    let by = [size * angle.cos(), size * angle.sin()];
    let to = [0.6 * x[0] + by[0], 0.6 * x[1] + by[1]];
    let depth = (zeta + random.between(-1.0, 1.0) * size).min(2.0);
    match random.below(20) {
        0..=6 => (zeta, to),
        7 => (depth.max(1e-3), x),
        8 => (depth - 0.3, to),
        9..=12 => ((zeta.max(0.0) + 1.5 * size).min(2.0), [x[0] + by[0], x[1] + by[1]]),
        _ => (depth.max(1e-3), to),
    }
}
