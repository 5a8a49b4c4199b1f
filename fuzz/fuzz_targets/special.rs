//! Special functions for arguments of any bits: no number that their types accept gives NaN.
#![no_main]

use carom_fuzz::Bytes;
use carom_special::AxisRatio;
use carom_special::elliptic::{Amplitude, complete, incomplete};
use carom_special::gamma::{gamma, ln_gamma, reciprocal};
use carom_special::hypergeometric::{UnitArgument, gauss, three_f_two};
use carom_special::roots::{ALL_DIGITS, Bracket, bisect, brent};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let mut bytes = Bytes::new(bytes);
    match bytes.pick(6) {
        0 => complete_integrals(&mut bytes),
        1 => incomplete_integrals(&mut bytes),
        2 => gammas(&mut bytes),
        3 => series_of_gauss(&mut bytes),
        4 => series_of_three(&mut bytes),
        _ => roots(&mut bytes),
    }
});

/// A number of usual size or of any bits.
fn number(bytes: &mut Bytes<'_>, size: f64) -> f64 {
    if bytes.pick(2) == 0 { bytes.number(size) } else { bytes.raw() }
}

fn ratio(bytes: &mut Bytes<'_>) -> Option<AxisRatio> {
    let (kind, x) = (bytes.pick(3), number(bytes, 1.0));
    let ratio = match kind {
        0 => AxisRatio::new(x),
        1 => AxisRatio::from_modulus(x),
        _ => AxisRatio::from_parameter(x),
    };
    ratio.ok()
}

fn complete_integrals(bytes: &mut Bytes<'_>) {
    let Some(ratio) = ratio(bytes) else { return };
    use complete::{b, c, d, db, dd, de, dk, e, k};
    for (i, integral) in [k, e, d, b, c, dk, de, db, dd].into_iter().enumerate() {
        assert!(!integral(ratio).is_nan(), "{i} of {ratio:?}");
    }
}

fn incomplete_integrals(bytes: &mut Bytes<'_>) {
    let (kind, x, y) = (bytes.pick(4), number(bytes, 1.0), number(bytes, 1.0));
    let amplitude = match kind {
        0 => Amplitude::from_angle(x),
        1 => Amplitude::from_cosine(x),
        2 => Amplitude::from_sine(x),
        _ => Amplitude::from_legs(x, y),
    };
    let (Ok(amplitude), Some(ratio)) = (amplitude, ratio(bytes)) else { return };
    use incomplete::{d, e, f};
    for (i, integral) in [f, e, d].into_iter().enumerate() {
        assert!(!integral(ratio, amplitude).is_nan(), "{i} of {ratio:?}, {amplitude:?}");
    }
}

fn gammas(bytes: &mut Bytes<'_>) {
    let x = number(bytes, 20.0);
    if x.is_nan() {
        return;
    }
    // Its poles of changing sign, and minus infinity, have no value.
    let is_pole = x < 0.0 && (x == x.floor());
    assert!(is_pole || !gamma(x).is_nan(), "{x:e}");
    assert!(x <= -170.0 || !reciprocal(x).is_nan(), "{x:e}");
    assert!(x == f64::NEG_INFINITY || !ln_gamma(x).is_nan(), "{x:e}");
}

fn argument(bytes: &mut Bytes<'_>) -> Option<UnitArgument> {
    let (from, x) = (bytes.pick(2), number(bytes, 0.5));
    if from == 0 { UnitArgument::new(x).ok() } else { UnitArgument::from_complement(x).ok() }
}

fn series_of_gauss(bytes: &mut Bytes<'_>) {
    let [a, b, c] = std::array::from_fn(|_| number(bytes, 2.5));
    let Some(x) = argument(bytes) else { return };
    if let Ok(value) = gauss(a, b, c, x) {
        assert!(value.is_finite(), "{a:e} {b:e} {c:e} {x:?}: {value}");
    }
}

fn series_of_three(bytes: &mut Bytes<'_>) {
    let [s, a, b, c] = std::array::from_fn(|_| number(bytes, 2.5));
    let Some(x) = argument(bytes) else { return };
    if let Ok(value) = three_f_two(s, a, b, c, x) {
        assert!(value.is_finite(), "{s:e} {a:e} {b:e} {c:e} {x:?}: {value}");
    }
}

/// Roots of a cubic with a jump, in any interval.
fn roots(bytes: &mut Bytes<'_>) {
    let [lower, upper, jump, tolerance] = std::array::from_fn(|_| number(bytes, 1.0));
    let c: [f64; 4] = std::array::from_fn(|_| number(bytes, 1.0));
    let function = |x: f64| {
        let smooth = c[0] + x * (c[1] + x * (c[2] + x * c[3]));
        if x > jump { -smooth } else { smooth }
    };
    if lower.is_finite() && upper.is_finite() {
        let within = lower.min(upper)..=lower.max(upper);
        let ends = bisect([lower, upper], ALL_DIGITS, |x| function(x) < 0.0);
        assert!(ends.iter().all(|end| within.contains(end)), "{ends:?} of {within:?}");
    }
    let Ok(bracket) = Bracket::new(lower, upper) else { return };
    let Ok(root) = brent(function, bracket, tolerance) else { return };
    for place in [root.position, root.opposite] {
        assert!((lower..=upper).contains(&place), "{root:?} in {bracket:?}");
    }
    assert_eq!(root.residual.to_bits(), function(root.position).to_bits(), "{root:?}");
}
