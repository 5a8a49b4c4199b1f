//! Fields of the analytic solutions: displacements of the surface and stresses inside the bodies.
//!
//! - At the surface: [`normal_displacement`], [`ellipsoidal_shear`], [`circular_shear`].
//! - Inside a body: [`EllipsoidalLoad`] for any ellipse, [`circular_stress`] in cylindrical
//!   components, [`partial_slip_stress`] for a contact in partial slip.
//! - Due to the tractions of a load history: [`elliptic_memory_displacement`], [`memory_stress`],
//!   and for a circle [`memory_displacement`].

use std::f64::consts::PI;

use carom_halfspace::MaterialPair;
use carom_special::RangeError;
use carom_special::elliptic::{Amplitude, complete, incomplete};

use crate::ellipse::ContactEllipse;
use crate::hertz::HertzState;

mod circle;
mod confocal;
mod interior;
mod memory;
mod potentials;

pub use circle::{CircularStress, circular_stress};
pub use interior::{EllipsoidalLoad, partial_slip_stress};
pub use memory::{elliptic_memory_displacement, memory_displacement, memory_stress};

/// The normal displacement w_1 + w_2 of the two surfaces under Hertz's pressure, inside and outside
/// the contact ellipse; inside it is `zeta - A x^2 - B y^2`.
///
/// `(a b sigma_z0 (1-nu)/(4G)) int_lambda^inf [1 - x^2/(a^2+s) - y^2/(b^2+s)]
/// ds/sqrt((a^2+s)(b^2+s)s)`, lambda zero inside and the ellipsoidal coordinate outside.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::curvature::RelativeCurvature;
/// use carom_laws::field::normal_displacement;
/// use carom_laws::hertz::Hertz;
/// let body = Material::from_shear(2.0, 0.3)?;
/// let gap = RelativeCurvature::from_coefficients(2.0, 1.0)?;
/// let hertz = Hertz::new(gap, MaterialPair::new(body, body)?)?;
/// let state = hertz.at_approach(0.01)?;
/// let w = normal_displacement(&state, &hertz.materials(), 0.01, 0.02)?;
/// assert!((w - (0.01 - gap.gap(0.01, 0.02))).abs() < 1e-16);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`RangeError`] for a point that is not finite.
pub fn normal_displacement(
    state: &HertzState,
    materials: &MaterialPair,
    x: f64,
    y: f64,
) -> Result<f64, RangeError> {
    RangeError::finite("x", x)?;
    RangeError::finite("y", y)?;
    let ellipse = state.ellipse;
    let (a, b) = (ellipse.semi_axis_a(), ellipse.semi_axis_b());
    let lambda = confocal::surface_coordinate(&ellipse, x, y);
    let ratio = ellipse.axis_ratio();
    // int ds/(sqrt(...)) = (2/b) F, int ds/((b^2+s) sqrt(...)) = (2/b^3) D, and likewise for a.
    let root = lambda.sqrt();
    let (at_b, at_a) = (Amplitude::from_legs(b, root)?, Amplitude::from_legs(a, root)?);
    let (u, v) = (x / a, y / b);
    let sum = incomplete::f(ratio, at_b) / b
        - u * u * incomplete::d(ratio.inverse(), at_a) / a
        - v * v * incomplete::d(ratio, at_b) / b;
    let compliance = (1.0 - materials.poisson()) / materials.shear_modulus();
    Ok(0.5 * compliance * state.peak_pressure * a * b * sum)
}

/// The surface displacement (u, v) due to the traction `sigma_zx = sigma sqrt(1 - x^2/a^2 -
/// y^2/b^2)`; for a pair, the relative displacement. Inside the ellipse it is (7.10)-(7.15),
/// outside the same integrals start at the ellipsoidal coordinate. Either semi-axis may be the
/// larger one.
///
/// # Errors
/// [`RangeError`] for a point that is not finite.
pub fn ellipsoidal_shear(
    ellipse: &ContactEllipse,
    sigma: f64,
    materials: &MaterialPair,
    x: f64,
    y: f64,
) -> Result<[f64; 2], RangeError> {
    RangeError::finite("x", x)?;
    RangeError::finite("y", y)?;
    if !ellipse.contains(x, y) {
        let p = potentials::Potentials::new(ellipse, x, y, 0.0)?;
        let (scale, nu) = (sigma / (2.0 * PI * materials.shear_modulus()), materials.poisson());
        return Ok([scale * (p.v + nu * p.l_xx), scale * nu * p.l_xy]);
    }
    let (a, b) = (ellipse.semi_axis_a(), ellipse.semi_axis_b());
    let ratio = ellipse.axis_ratio();
    let [k, d, c] = [complete::k, complete::d, complete::c].map(|integral| integral(ratio));
    let bell = complete::b(ratio);
    let nu = materials.poisson();
    let (s, t) = (x / a, y / b);
    // u_0 times k' is sigma a/(2G) in both cases of (7.10).
    let scale = sigma * a / (2.0 * materials.shear_modulus());
    let gamma = k - nu * d;
    let phi = bell - nu * (d - c);
    let psi = d - nu * c;
    let theta = 2.0 * nu * ratio.get() * c;
    Ok([scale * (gamma - phi * s * s - psi * t * t), scale * theta * s * t])
}

/// The surface displacement (u, v) due to the traction `sigma_zx = sigma sqrt(1 - rho^2/a^2)` on a
/// circle, inside and outside (6.6), corrected. For a pair, the relative displacement.
#[must_use]
pub fn circular_shear(
    radius: f64,
    sigma: f64,
    materials: &MaterialPair,
    x: f64,
    y: f64,
) -> [f64; 2] {
    let (g, nu) = (materials.shear_modulus(), materials.poisson());
    let (a, square) = (radius, x * x + y * y);
    if square <= a * a {
        let scale = PI * sigma / (32.0 * g * a);
        return [
            scale * (4.0 * (2.0 - nu) * a * a - (4.0 - 3.0 * nu) * x * x - (4.0 - nu) * y * y),
            scale * 2.0 * nu * x * y,
        ];
    }
    let rho = square.sqrt();
    let (cos_2, sin_2) = ((x - y) * (x + y) / square, 2.0 * x * y / square);
    // Written with phi = 2 arcsin(a/rho) to avoid cancellation far away.
    let phi = 2.0 * libm::asin(a / rho);
    let even = 0.5 * square * sine_rest(phi);
    let odd = 0.25 * square * turn_rest(2.0 * phi);
    let scale = sigma / (8.0 * g * a);
    [scale * ((2.0 - nu) * even + 0.5 * nu * odd * cos_2), scale * 0.5 * nu * odd * sin_2]
}

/// `sin(x) - x cos(x)`, which is about `x^3/3` for small x.
fn sine_rest(x: f64) -> f64 {
    if x > 1.0 {
        return libm::sin(x) - x * libm::cos(x);
    }
    let mut sum = 0.0;
    for n in (0..10).rev() {
        let n = f64::from(n);
        // The coefficient (2 n + 2)/(2 n + 3)!, from its ratio to the previous one.
        sum = 1.0 - sum * x * x / ((2.0 * n + 2.0) * (2.0 * n + 5.0));
    }
    x * x * x / 3.0 * sum
}

/// `x - sin(x)`.
fn turn_rest(x: f64) -> f64 {
    if x > 1.0 {
        return x - libm::sin(x);
    }
    let mut sum = 0.0;
    for n in (0..10).rev() {
        let n = f64::from(n);
        sum = 1.0 - sum * x * x / ((2.0 * n + 4.0) * (2.0 * n + 5.0));
    }
    x * x * x / 6.0 * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curvature::RelativeCurvature;
    use crate::hertz::Hertz;
    use approx::assert_relative_eq;
    use carom_halfspace::Material;

    fn pair(nu: f64) -> MaterialPair {
        MaterialPair::new(Material::from_shear(1.0, nu).unwrap(), Material::RIGID).unwrap()
    }

    #[test]
    fn normal_displacement_is_smooth_and_falls_like_a_point_force() {
        for (a, b) in [(2.0, 1.0), (1.0, 5.0), (1.0, 1.0)] {
            let gap = RelativeCurvature::from_coefficients(a, b).unwrap();
            let hertz = Hertz::new(gap, pair(0.3)).unwrap();
            let state = hertz.at_approach(0.01).unwrap();
            let w = |x: f64, y: f64| normal_displacement(&state, &hertz.materials(), x, y).unwrap();
            let (sa, sb) = (state.ellipse.semi_axis_a(), state.ellipse.semi_axis_b());
            for (u, v) in [(0.0, 0.0), (0.3, 0.4), (0.9, 0.1), (0.0, 1.0)] {
                let (x, y) = (u * sa, v * sb);
                assert_relative_eq!(w(x, y), 0.01 - gap.gap(x, y), max_relative = 1e-13);
            }
            assert_relative_eq!(w(sa * 1.000_001, 0.0), w(sa, 0.0), max_relative = 1e-5);
            // Boussinesq: w = (1 - nu) F/(2 pi G r).
            let far = 1e4 * (sa + sb);
            let point = 0.7 * state.force / (2.0 * PI * far);
            assert_relative_eq!(w(0.6 * far, 0.8 * far), point, max_relative = 1e-7);
        }
    }

    #[test]
    fn shear_of_the_circle_is_that_of_the_ellipse_and_continuous() {
        let circle = ContactEllipse::circle(2.0).unwrap();
        for (x, y) in [(0.0, 0.0), (1.0, 0.5), (-0.3, 1.9)] {
            let one = ellipsoidal_shear(&circle, 3.0, &pair(0.4), x, y).unwrap();
            let two = circular_shear(2.0, 3.0, &pair(0.4), x, y);
            assert_relative_eq!(one[0], two[0], max_relative = 1e-14);
            assert_relative_eq!(one[1], two[1], max_relative = 1e-14);
        }
        let (inside, outside) = (
            circular_shear(1.0, 1.0, &pair(0.4), 0.6 * (1.0 - 1e-9), 0.8 * (1.0 - 1e-9)),
            circular_shear(1.0, 1.0, &pair(0.4), 0.6 * (1.0 + 1e-9), 0.8 * (1.0 + 1e-9)),
        );
        assert_relative_eq!(inside[0], outside[0], max_relative = 1e-7);
        assert_relative_eq!(inside[1], outside[1], max_relative = 1e-7);
        // Cerruti far away: u = F (1 - nu + nu cos^2)/(2 pi G r).
        for far in [1e3, 1e7, 1e12] {
            let [u, _] = circular_shear(1.0, 1.0, &pair(0.4), far, 0.0);
            assert_relative_eq!(u, 2.0 * PI / 3.0 / (2.0 * PI * far), max_relative = 1e-5);
            let (one, unit) = ([0.6 * far, 0.8 * far], ContactEllipse::circle(1.0).unwrap());
            let [u, v] = circular_shear(1.0, 1.0, &pair(0.4), one[0], one[1]);
            let want = ellipsoidal_shear(&unit, 1.0, &pair(0.4), one[0], one[1]).unwrap();
            assert_relative_eq!(u, want[0], max_relative = 1e-13);
            assert_relative_eq!(v, want[1], max_relative = 1e-13);
        }
        assert_eq!(
            ellipsoidal_shear(&circle, 1.0, &pair(0.3), f64::NAN, 0.0).unwrap_err().field,
            "x"
        );
    }
}
