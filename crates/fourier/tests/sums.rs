//! Each plan against the sum that defines it.

use approx::assert_abs_diff_eq;
use carom_fourier::{Complex, Complex64, Transformed};
use std::f64::consts::TAU;

/// Numbers without symmetry.
fn value(index: usize) -> f64 {
    let index = index as f64;
    (1.3 * index + 0.2).sin() + 0.1 * index
}

/// Sum of x_j exp(sign 2 pi i j k / n).
fn sum(values: &[Complex64], k: usize, sign: f64) -> Complex64 {
    let turn = sign * TAU / values.len() as f64;
    let terms = values.iter().enumerate();
    terms.map(|(j, x)| x * Complex64::from_polar(1.0, turn * (j * k) as f64)).sum()
}

/// A length of small factors, an even and an odd prime, and one without any.
const LENGTHS: [usize; 4] = [12, 2, 7, 1];

#[test]
fn complex_transforms_are_the_sums() {
    for length in LENGTHS {
        let values: Vec<_> = (0..length).map(|j| Complex64::new(value(j), value(j + 50))).collect();
        let plan = f64::complex_plan(length);
        for (transform, sign) in [(&plan.forward, -1.0), (&plan.inverse, 1.0)] {
            let mut found = values.clone();
            transform.process(&mut found);
            for (k, found) in found.iter().enumerate() {
                assert_abs_diff_eq!((found - sum(&values, k, sign)).norm(), 0.0, epsilon = 1e-12);
            }
        }
    }
}

/// Transforms of one precision, compared with the sums and with what they began with.
fn real_transforms<T: Transformed>(of: fn(f64) -> T, to: fn(T) -> f64, epsilon: f64) {
    for length in LENGTHS {
        let values: Vec<T> = (0..length).map(|j| of(value(j))).collect();
        let exact: Vec<_> = values.iter().map(|x| Complex64::new(to(*x), 0.0)).collect();
        let plan = T::real_plan(length);
        let mut spectrum = vec![Complex::new(T::zero(), T::zero()); length / 2 + 1];
        plan.forward.process(&mut values.clone(), &mut spectrum).unwrap();
        for (k, found) in spectrum.iter().enumerate() {
            let found = Complex64::new(to(found.re), to(found.im));
            assert_abs_diff_eq!((found - sum(&exact, k, -1.0)).norm(), 0.0, epsilon = epsilon);
        }
        let mut back = vec![T::zero(); length];
        plan.inverse.process(&mut spectrum, &mut back).unwrap();
        for (back, value) in back.iter().zip(&exact) {
            assert_abs_diff_eq!(to(*back), length as f64 * value.re, epsilon = epsilon);
        }
    }
}

#[test]
fn real_transforms_are_the_sums_and_their_inverse() {
    real_transforms(|x| x, |x: f64| x, 1e-12);
    real_transforms(|x| x as f32, f64::from, 1e-4);
}
