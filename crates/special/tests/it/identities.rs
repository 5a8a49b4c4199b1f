//! Identities between the special functions, on random arguments.

use carom_special::elliptic::{Amplitude, complete, incomplete};
use carom_special::gamma::{gamma, ln_gamma, reciprocal};
use carom_special::hypergeometric::{Gauss, HypergeometricError, UnitArgument, gauss, three_f_two};
use carom_special::quadrature::{GaussLegendre, Tolerance, adaptive, tanh_sinh};
use carom_special::roots::{Bracket, brent};
use carom_special::{AxisRatio, RangeError};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

fn ratio(value: f64) -> AxisRatio {
    AxisRatio::new(value).expect("positive")
}

fn argument(x: f64) -> UnitArgument {
    UnitArgument::new(x).expect("in the unit interval")
}

/// Asserts that both differ by at most `tolerance` times the size of what they are made of.
macro_rules! assert_near {
    ($left:expr, $right:expr, $size:expr, $tolerance:expr) => {{
        let (left, right, size): (f64, f64, f64) = ($left, $right, $size);
        prop_assert!((left - right).abs() <= $tolerance * size, "{left} is not {right}");
    }};
}

/// Axis ratios over the whole range, evenly in the exponent.
fn any_ratio() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-300.0..300.0).prop_map(|e| libm::pow(10.0, e)),
        (-8.0..8.0).prop_map(|e| libm::pow(10.0, e)),
        0.01..10.0,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// E(k) K(k') + E(k') K(k) - K(k) K(k') = pi/2, DLMF 19.7.1.
    #[test]
    fn legendre_relation(angle in 1e-8..FRAC_PI_2) {
        let (one, other) = (ratio(libm::sin(angle)), ratio(libm::cos(angle)));
        let products = [
            complete::e(one) * complete::k(other),
            complete::e(other) * complete::k(one),
            complete::k(one) * complete::k(other),
        ];
        assert_near!(products[0] + products[1] - products[2], FRAC_PI_2, products[2], 2e-15);
    }

    #[test]
    fn complete_integrals_fit_together(kc in any_ratio()) {
        let at = ratio(kc);
        let [k, e, d, b] = [complete::k(at), complete::e(at), complete::d(at), complete::b(at)];
        assert_near!(b + d, k, k, 1e-15);
        assert_near!(b + kc * (kc * d), e, e, 1e-15);
        let c = complete::c(at);
        if kc < 1e100 {
            assert_near!((1.0 - kc) * (1.0 + kc) * c, d - b, d + b, 2e-15);
            // dK = dB + dD, and E' = B' + 2 k' D + k'^2 D' = k' D
            assert_near!(complete::db(at) + complete::dd(at), complete::dk(at),
                complete::dk(at).abs(), 2e-15);
            let sum = complete::db(at) + 2.0 * kc * d + kc * (kc * complete::dd(at));
            assert_near!(sum, complete::de(at), 2.0 * kc * d + kc * (kc * complete::dd(at)).abs(), 2e-15);
        }
    }

    /// Landen: K(k') = 2/(1 + k') K(2 sqrt(k')/(1 + k')), DLMF 19.8.12.
    #[test]
    fn landen_step(e in -200.0..200.0) {
        let kc = libm::pow(10.0, e);
        let next = ratio(2.0 * kc.sqrt() / (1.0 + kc));
        let k = complete::k(ratio(kc));
        assert_near!(2.0 / (1.0 + kc) * complete::k(next), k, k, 2e-15);
    }

    #[test]
    fn derivatives_are_those_of_the_functions(kc in 0.05..5.0) {
        type Function = fn(AxisRatio) -> f64;
        let pairs: [(Function, Function); 4] = [
            (complete::k, complete::dk),
            (complete::e, complete::de),
            (complete::d, complete::dd),
            (complete::b, complete::db),
        ];
        for (function, derivative) in pairs {
            // Five points: the error is of the fourth order in h.
            let h = 2e-3 * kc;
            let f = |steps: f64| function(ratio(kc + steps * h));
            let slope = (8.0 * (f(1.0) - f(-1.0)) - (f(2.0) - f(-2.0))) / (12.0 * h);
            assert_near!(slope, derivative(ratio(kc)), slope.abs(), 1e-9);
        }
    }

    #[test]
    fn incomplete_integrals_end_in_the_complete(kc in any_ratio()) {
        let at = ratio(kc);
        let [k, e, d] = [complete::k(at), complete::e(at), complete::d(at)];
        assert_near!(incomplete::f(at, Amplitude::RIGHT), k, k, 2e-15);
        assert_near!(incomplete::e(at, Amplitude::RIGHT), e, e, 2e-15);
        assert_near!(incomplete::d(at, Amplitude::RIGHT), d, d, 2e-15);
    }

    /// tan(phi) tan(psi) = 1/k' makes F(phi) + F(psi) = K, DLMF 19.11.8.
    #[test]
    fn two_amplitudes_make_a_complete_integral(
        kc in any_ratio(), e in -12.0..12.0, side in prop::bool::ANY,
    ) {
        let tangent = libm::pow(10.0, e);
        prop_assume!((tangent * kc).is_finite() && tangent * kc > 0.0);
        let amplitude = |opposite, adjacent| Amplitude::from_legs(opposite, adjacent).expect("legs");
        let (phi, psi) = (amplitude(tangent, 1.0), amplitude(1.0, tangent * kc));
        let (phi, psi) = if side { (phi, psi) } else { (psi, phi) };
        let k = complete::k(ratio(kc));
        assert_near!(incomplete::f(ratio(kc), phi) + incomplete::f(ratio(kc), psi), k, k, 2e-15);
    }

    #[test]
    fn incomplete_integrals_fit_together(kc in 1e-6..1e3, cosine in 0.0..1.0) {
        let (at, phi) = (ratio(kc), Amplitude::from_cosine(cosine).expect("cosine"));
        let [f, e, d] = [incomplete::f(at, phi), incomplete::e(at, phi), incomplete::d(at, phi)];
        let m = (1.0 - kc) * (1.0 + kc);
        assert_near!(f - m * d, e, f + m.abs() * d, 3e-15);
        prop_assert!(d <= f * phi.sine() * phi.sine() * (1.0 + 1e-14));
    }

    /// K = (pi/2) F(1/2, 1/2; 1; m), E = (pi/2) F(-1/2, 1/2; 1; m): the logarithmic case.
    #[test]
    fn elliptic_integrals_are_hypergeometric(e in -12.0..0.0) {
        let kc = libm::pow(10.0, e);
        let m = UnitArgument::from_complement(kc * kc).expect("in range");
        let (k, elliptic_e) = (complete::k(ratio(kc)), complete::e(ratio(kc)));
        assert_near!(FRAC_PI_2 * gauss(0.5, 0.5, 1.0, m).expect("finite"), k, k, 1e-14);
        assert_near!(FRAC_PI_2 * gauss(-0.5, 0.5, 1.0, m).expect("finite"), elliptic_e, 1.0, 1e-14);
    }

    /// (c - a) F(a-1) + (2a - c + (b - a) x) F + a (x - 1) F(a+1) = 0, DLMF 15.5.11.
    #[test]
    fn contiguous_functions(phi in 1.0..30.0, c in 0.4..3.0, x in 0.0..1.0) {
        let (a, b) = ((9.0 - phi) / 20.0, (9.0 + phi) / 20.0);
        let f = |a: f64| gauss(a, b, c, argument(x));
        let values = [f(a - 1.0), f(a), f(a + 1.0)];
        // Next to c = 1 - a - b and for large phi the value may drown in its terms, and says so.
        prop_assume!(!values.iter().any(|v| matches!(v, Err(HypergeometricError::Cancellation { bound, .. }) if *bound < 1e-13)));
        let [Ok(below), Ok(here), Ok(above)] = values else {
            return Err(TestCaseError::fail(format!("{values:?}")));
        };
        let terms =
            [(c - a) * below, (2.0 * a - c + (b - a) * x) * here, a * (x - 1.0) * above];
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        assert_near!(terms.iter().sum::<f64>(), 0.0, size.max(0.1), 1e-13);
    }

    /// Euler: F(a, b; c; x) = (1 - x)^(c - a - b) F(c - a, c - b; c; x), DLMF 15.8.1.
    #[test]
    fn euler_transformation(a in -1.5..2.0, b in -1.5..2.0, c in 0.2..3.0, x in 0.0..0.999_999) {
        let (one, other) = (gauss(a, b, c, argument(x)), gauss(c - a, c - b, c, argument(x)));
        // One in 100 000 pairs lies at a zero of the function, where its terms cancel.
        let cancels = |value: &Result<f64, _>| matches!(value, Err(HypergeometricError::Cancellation { .. }));
        prop_assume!(!cancels(&one) && !cancels(&other));
        let (one, other) = (one.expect("finite"), other.expect("finite"));
        let turned = libm::pow(1.0 - x, c - a - b) * other;
        assert_near!(one, turned, one.abs().max(0.1), 2e-13);
        prop_assert_eq!(one, gauss(b, a, c, argument(x)).expect("finite"));
    }

    /// z^s 3F2 = s int_0^z t^(s-1) 2F1 dt by tanh-sinh.
    #[test]
    fn three_f_two_is_an_integral(s in 0.2..2.0, phi in 1.0..27.0, c in 0.5..2.0, e in -6.0..0.0) {
        let (a, b, y) = ((11.0 - phi) / 20.0, (11.0 + phi) / 20.0, libm::pow(10.0, e));
        let z = UnitArgument::from_complement(y).expect("in range");
        prop_assume!(z.value() > 0.01);
        let function = Gauss::new(a, b, c).expect("in range");
        let integral = tanh_sinh(0.0, z.value(), Tolerance::new(1e-14, 1e-13).expect("positive"), |at| {
            let t = UnitArgument::from_complement(y + at.to_upper).or(UnitArgument::new(at.position));
            libm::pow(at.from_lower, s - 1.0) * t.map_or(f64::NAN, |t| function.at(t).unwrap_or(f64::NAN))
        });
        let integral = integral.expect("converged").value;
        let expected = three_f_two(s, a, b, c, z).expect("finite") * libm::pow(z.value(), s) / s;
        assert_near!(integral, expected, expected.abs().max(0.1), 1e-11);
    }

    /// gamma(x) gamma(1 - x) = pi/sin(pi x) and gamma(x + 1) = x gamma(x).
    #[test]
    fn gamma_reflects_and_steps(part in 1..1023, n in 0..20) {
        let x = f64::from(part) / 1024.0; // so that x + n + 1 is exact
        assert_near!(gamma(x) * gamma(1.0 - x), PI / libm::sin(PI * x.min(1.0 - x)), gamma(x) * gamma(1.0 - x), 2e-15);
        let x = x + f64::from(n);
        assert_near!(gamma(x + 1.0), x * gamma(x), gamma(x + 1.0), 3e-15);
        assert_near!(gamma(x) * reciprocal(x), 1.0, 1.0, 1e-15);
        assert_near!(ln_gamma(x), libm::log(gamma(x)), 1.0 + ln_gamma(x).abs(), 2e-15);
    }

    #[test]
    fn a_root_lies_between_opposite_signs(roots in prop::array::uniform3(-10.0..10.0_f64)) {
        let cubic = |x: f64| (x - roots[0]) * (x - roots[1]) * (x - roots[2]);
        let root = brent(cubic, Bracket::new(-11.0, 12.0).expect("bracket"), 0.0).expect("root");
        let nearest = roots.iter().map(|r| (r - root.position).abs()).fold(f64::INFINITY, f64::min);
        // The polynomial's own rounding moves a triple root by its cube root.
        prop_assert!(nearest < 1e-4, "{root:?}");
        prop_assert!(cubic(root.position) * cubic(root.opposite) <= 0.0);
        prop_assert!(root.evaluations < 120);
    }

    #[test]
    fn three_rules_agree(a in 0.1..3.0_f64, b in -3.0..3.0_f64, width in 0.1..4.0_f64) {
        let function = |x: f64| libm::exp(-a * x) * libm::cos(b * x);
        let tolerance = Tolerance::new(1e-12, 1e-12).expect("positive");
        let one = GaussLegendre::new(24).expect("order").integrate(0.0, width, function);
        let two = adaptive(0.0, width, tolerance, function).expect("converged");
        let three = tanh_sinh(0.0, width, tolerance, |at| function(at.position)).expect("converged");
        // int e^(-a x) cos(b x) dx
        let exact = (a + libm::exp(-a * width) * (b * libm::sin(b * width) - a * libm::cos(b * width)))
            / (a * a + b * b);
        for value in [one, two.value, three.value] {
            assert_near!(value, exact, 1.0, 1e-12);
        }
        prop_assert!((two.value - exact).abs() <= two.error);
    }
}

#[test]
fn bad_input_names_field_value_and_range() {
    let message = |error: RangeError| error.to_string();
    assert_eq!(
        message(UnitArgument::new(-0.5).unwrap_err()),
        "x = -0.5 is out of range: must be from 0 to 1"
    );
    assert_eq!(Amplitude::from_cosine(f64::NAN).unwrap_err().field, "cosine");
    assert_eq!(Amplitude::from_angle(2.0).unwrap_err().field, "phi");
    assert_eq!(Amplitude::from_legs(0.0, 0.0).unwrap_err().field, "adjacent");
    let error = |result: Result<f64, HypergeometricError>| result.unwrap_err().to_string();
    let half = argument(0.5);
    assert_eq!(
        error(gauss(0.5, 0.5, -2.0, half)),
        "c = -2 is out of range: must be no pole: not 0, -1, -2, ..."
    );
    assert_eq!(
        error(gauss(f64::NAN, 0.5, 1.0, half)),
        "a = NaN is out of range: must be from -5 to 5"
    );
    assert_eq!(error(gauss(0.5, 6.0, 1.0, half)), "b = 6 is out of range: must be from -5 to 5");
    assert_eq!(
        error(gauss(0.5, 0.5, 1.0, UnitArgument::ONE)),
        "the function is infinite at 1: the parametric excess 0 is not positive"
    );
    assert_eq!(
        error(three_f_two(0.0, 0.5, 0.5, 1.0, half)),
        "s = 0 is out of range: must be above 0, to 5"
    );
    assert!(three_f_two(1.0, 2.0, 2.0, 1.5, UnitArgument::ONE).is_err());
}

#[test]
fn polynomials_end_also_at_one() {
    // F(-2, b; c; 1) = (c - b)_2/(c)_2, Chu-Vandermonde.
    let value = gauss(-2.0, 3.5, 1.25, UnitArgument::ONE).expect("finite");
    assert!((value - (-2.25 * -1.25) / (1.25 * 2.25)).abs() < 1e-15);
}

#[test]
fn values_at_one_beyond_the_largest_number_are_errors_not_infinite() {
    let at_one = |a, b, c| gauss(a, b, c, UnitArgument::ONE);
    // gamma(c) and gamma(c - a - b) are infinite.
    assert_eq!(at_one(-0.5, -0.5, 1e-310), Err(HypergeometricError::Overflow));
    // The function is (1 - x)^(-b), 0 at 1 for any b < 0.
    assert_eq!(at_one(1e-300, -1e-310, 1e-300), Ok(0.0));
}
