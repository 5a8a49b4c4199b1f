//! Polynomials of degree up to 8 and the roots of a quartic.

use carom_dense::c64;

/// Coefficients of 1, p, ..., p^8.
pub(super) type Polynomial = [f64; 9];

/// The product; terms beyond p^8 do not occur.
pub(super) fn product(one: &Polynomial, other: &Polynomial) -> Polynomial {
    let mut product = [0.0; 9];
    for (i, a) in one.iter().enumerate() {
        for (j, b) in other.iter().enumerate().take(9 - i) {
            product[i + j] += a * b;
        }
    }
    product
}

/// one + factor * other.
pub(super) fn sum(one: &Polynomial, factor: f64, other: &Polynomial) -> Polynomial {
    std::array::from_fn(|i| one[i] + factor * other[i])
}

/// The polynomial of -p.
pub(super) fn reflected(one: &Polynomial) -> Polynomial {
    std::array::from_fn(|i| if i % 2 == 0 { one[i] } else { -one[i] })
}

/// The roots of c_0 + c_1 q + ... + c_4 q^4 near distinct guesses, by the iteration of Aberth.
pub(super) fn quartic_roots(coefficients: [f64; 5], mut roots: [c64; 4]) -> [c64; 4] {
    for _ in 0..100 {
        let mut greatest: f64 = 0.0;
        for i in 0..4 {
            let root = roots[i];
            let (mut value, mut slope) = (c64::new(0.0, 0.0), c64::new(0.0, 0.0));
            for c in coefficients.iter().rev() {
                slope = slope * root + value;
                value = value * root + *c;
            }
            if value.norm_sqr() == 0.0 {
                continue;
            }
            let apart: c64 =
                (0..4).filter(|&j| j != i).map(|j| c64::new(1.0, 0.0) / (root - roots[j])).sum();
            let step = value / (slope - value * apart);
            if step.re.is_finite() && step.im.is_finite() {
                roots[i] -= step;
                greatest = greatest.max((step.norm_sqr() / roots[i].norm_sqr()).sqrt());
            }
        }
        if greatest < 1e-15 {
            break;
        }
    }
    roots
}

/// The square root with positive real part.
pub(super) fn square_root(z: c64) -> c64 {
    let size = libm::hypot(z.re, z.im);
    let large = (0.5 * (size + z.re.abs())).sqrt();
    if large == 0.0 {
        return c64::new(0.0, 0.0);
    }
    let small = 0.5 * z.im.abs() / large;
    let (real, imaginary) = if z.re >= 0.0 { (large, small) } else { (small, large) };
    c64::new(real, if z.im < 0.0 { -imaginary } else { imaginary })
}
