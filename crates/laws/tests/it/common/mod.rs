//! Reading of reference tables and comparison with them.
use serde_json::Value;

pub(crate) mod balance;
pub(crate) mod load;
pub(crate) mod rings;
pub(crate) mod turning;

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

/// A small reproducible generator (splitmix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Uniform in [low, high).
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// One of `n` numbers from 0.
    pub(crate) fn pick(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
}

/// A random step of approach and shift: small and large, along and across, with pure changes of
/// one or the other, separations and gross slides among them.
pub(crate) fn next(random: &mut Random, zeta: f64, x: [f64; 2]) -> (f64, [f64; 2]) {
    let size = 10_f64.powf(random.between(-4.0, 0.3));
    let angle = random.between(0.0, std::f64::consts::TAU);
    let by = [size * angle.cos(), size * angle.sin()];
    let to = [0.6 * x[0] + by[0], 0.6 * x[1] + by[1]];
    let depth = (zeta + random.between(-1.0, 1.0) * size).min(2.0);
    match random.pick(20) {
        0..=6 => (zeta, to),
        7 => (depth.max(1e-3), x),
        8 => (depth - 0.3, to),
        9..=12 => ((zeta.max(0.0) + 1.5 * size).min(2.0), [x[0] + by[0], x[1] + by[1]]),
        _ => (depth.max(1e-3), to),
    }
}
