//! Product matrices against quadrature, and the rule of the jump.

use std::f64::consts::{PI, TAU};

use carom_shells::fourier::{
    Complex, ComplexSeries, EvenSeries, OddSeries, PiecewiseConstant, Sector,
};
use proptest::prelude::*;

/// Mean over the circle by the trapezoidal rule, exact for the orders here.
fn mean(f: impl Fn(f64) -> f64) -> f64 {
    (0..64).map(|i| f(TAU * f64::from(i) / 64.0)).sum::<f64>() / 64.0
}

proptest! {
    #[test]
    fn real_products_are_those_of_quadrature(f in proptest::collection::vec(-1.0..1.0, 9)) {
        let (even, odd) = (EvenSeries::new(&f).unwrap(), OddSeries::new(&f).unwrap());
        for k in 0..6_usize {
            for j in 0..6_usize {
                let (kf, jf) = (k as f64, j as f64);
                let norm = if k == 0 { 1.0 } else { 2.0 };
                let expected = [
                    mean(|x| even.at(x) * (jf * x).cos() * (kf * x).cos()) * norm,
                    mean(|x| even.at(x) * (jf * x).sin() * (kf * x).sin()) * norm,
                    mean(|x| odd.at(x) * (jf * x).sin() * (kf * x).cos()) * norm,
                    mean(|x| odd.at(x) * (jf * x).cos() * (kf * x).sin()) * norm,
                ];
                let found = [
                    even.cos_to_cos(k, j), even.sin_to_sin(k, j),
                    odd.sin_to_cos(k, j), odd.cos_to_sin(k, j),
                ];
                for (found, expected) in found.into_iter().zip(expected) {
                    prop_assert!((found - expected).abs() < 1e-13, "{k} {j}: {found} {expected}");
                }
            }
        }
    }

    #[test]
    fn division_undoes_a_product(
        parts in proptest::collection::vec((-1.0..1.0, -1.0..1.0), 9),
        base in 15.0..30.0_f64,
    ) {
        let complex = |&(re, im): &(f64, f64)| Complex::new(re, im);
        let g = ComplexSeries::new(&parts.iter().map(complex).collect::<Vec<_>>()).unwrap();
        let mut f: Vec<_> = parts.iter().rev().map(complex).collect();
        f[4] += base; // no zero
        let f = ComplexSeries::new(&f).unwrap();
        let back = f.divide(&f.times(&g, 4)).unwrap();
        for k in -4..=4 {
            prop_assert!((back.coefficient(k) - g.coefficient(k)).norm() < 1e-13);
        }
    }

    #[test]
    fn coefficients_of_sectors_are_those_of_quadrature(
        middle in -4.0..4.0_f64, half in 0.05..1.5_f64, factor in 0.1..10.0_f64, k in -20..20_i32,
    ) {
        let function = PiecewiseConstant::new(2.0, &[Sector::new(middle, half, factor).unwrap()]).unwrap();
        let series = function.series(20);
        // Integrate the step apart from the constant, by the midpoint rule within the sector.
        let count = 20_000;
        let step = 2.0 * half / f64::from(count);
        let mut expected = Complex::new(if k == 0 { 2.0 } else { 0.0 }, 0.0);
        for i in 0..count {
            let angle = middle - half + (f64::from(i) + 0.5) * step;
            let wave = Complex::new((f64::from(k) * angle).cos(), -(f64::from(k) * angle).sin());
            expected += wave * (2.0 * (factor - 1.0) * step / TAU);
        }
        let found = series.coefficient(i64::from(k));
        prop_assert!((found - expected).norm() < 1e-5, "{found} {expected}");
    }
}

#[test]
fn derivative_of_a_series() {
    let half = Complex::new(0.5, 0.0);
    let cosine = ComplexSeries::new(&[half, Complex::default(), half]).unwrap();
    for angle in [0.0, 0.7, 2.0] {
        assert!((cosine.derivative().at(angle).re + angle.sin()).abs() < 1e-15);
    }
}

/// The opening of a stepped ring without stretching by either rule of the product: the inverse rule
/// converges as n^-3, the other as 1/n (measured for a step by 5).
#[test]
fn inverse_rule_converges_across_a_jump() {
    let sectors = [0.0, PI].map(|middle| Sector::new(middle, 0.4, 5.0).unwrap());
    let stiffness = PiecewiseConstant::new(1.0, &sectors).unwrap();
    // kappa = M/EI with M = |sin| - X jumps where EI does. Give kappa, ask for M = EI kappa.
    let order = 512;
    let moment = |n: usize, use_inverse: bool| {
        let reciprocal = stiffness.reciprocal_series(2 * order);
        let smooth = |k: i64| {
            let even = k % 2 == 0;
            Complex::new(if even { -2.0 / (PI * (k * k - 1) as f64) } else { 0.0 }, 0.0)
        };
        let exact: Vec<_> = (-(order as i64)..=order as i64).map(smooth).collect();
        let exact = ComplexSeries::new(&exact).unwrap(); // of |sin phi|
        let curvature = reciprocal.times(&exact, n);
        let found = if use_inverse {
            ComplexSeries::times_across_jump(&stiffness.reciprocal_series(2 * n), &curvature)
                .unwrap()
        } else {
            stiffness.series(2 * n).times(&curvature, n)
        };
        let error = |k: i64| (found.coefficient(k) - smooth(k)).norm_sqr();
        (-(n as i64)..=n as i64).map(error).sum::<f64>().sqrt()
    };
    let (inverse, direct) = (moment(64, true), moment(64, false));
    assert!(inverse < 2e-3 && direct > 10.0 * inverse, "{inverse:e} {direct:e}");
    assert!(moment(64, true) < moment(16, true) / 6.0);
}

#[test]
fn bad_series_are_refused() {
    assert!(Sector::new(0.0, 0.0, 2.0).is_err());
    assert!(Sector::new(0.0, PI, 2.0).is_err());
    assert!(Sector::new(f64::NAN, 1.0, 2.0).is_err());
    assert!(Sector::new(0.0, 1.0, 0.0).is_err());
    let wide = Sector::new(0.0, 1.0, 2.0).unwrap();
    let near = Sector::new(TAU - 1.5, 0.6, 2.0).unwrap();
    let apart = Sector::new(TAU - 2.0, 0.9, 2.0).unwrap();
    for (sectors, fits) in [([wide, near], false), ([wide, apart], true)] {
        let [one, other] = sectors;
        for sectors in [[one, other], [other, one]] {
            let made = PiecewiseConstant::new(1.0, &sectors).map(drop);
            assert_eq!(
                made.map_err(|error| error.field),
                if fits { Ok(()) } else { Err("middle") }
            );
        }
    }
    assert!(PiecewiseConstant::uniform(-1.0).is_err());
    assert!(EvenSeries::new(&[f64::INFINITY]).is_err());
    assert!(OddSeries::new(&[f64::NAN]).is_err());
    assert!(ComplexSeries::new(&[Complex::default(); 2]).is_err());
    let zero = ComplexSeries::new(&[Complex::default()]).unwrap();
    assert!(zero.divide(&zero).is_err());
}
