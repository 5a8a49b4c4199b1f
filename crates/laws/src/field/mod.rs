//! Fields of the closed solutions: displacements of the surface and stresses inside.

use std::f64::consts::PI;

use carom_halfspace::{Material, MaterialPair};
use carom_special::RangeError;
use carom_special::elliptic::{Amplitude, complete, incomplete};

use crate::ellipse::ContactEllipse;
use crate::hertz::HertzState;
use crate::memory::{ScalarMemory, VectorMemory};

mod confocal;
mod interior;
mod potentials;

pub use interior::{EllipsoidalLoad, partial_slip_stress};

/// The normal displacement w_1 + w_2 of both surfaces under Hertz's pressure, inside and outside
/// the contact ellipse: `zeta - A x^2 - B y^2` inside.
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

/// The displacement (u, v) of the surface under the traction
/// `sigma_zx = sigma sqrt(1 - x^2/a^2 - y^2/b^2)`, relative for a pair: inside the ellipse
/// (7.10)-(7.15), outside the same integrals from the ellipsoidal coordinate. Either semi-axis may
/// be the larger one.
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

/// The displacement (u, v) of the surface under the traction
/// `sigma_zx = sigma sqrt(1 - rho^2/a^2)` on a circle, inside and outside (6.6), corrected.
/// Relative for a pair.
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
    let arc = libm::asin(a / rho);
    let root = ((rho - a) * (rho + a)).sqrt();
    let even = (2.0 * a * a - square) * arc + a * root;
    let odd = square * arc + (2.0 * a * a - square) * a * root / square;
    let scale = sigma / (8.0 * g * a);
    [scale * ((2.0 - nu) * even + 0.5 * nu * odd * cos_2), scale * 0.5 * nu * odd * sin_2]
}

/// The displacement of the surface of a circular contact under the tractions of a memory in one
/// direction, along x; the traction's scale is `f sigma_z0` of the present contact, its radius
/// `radius`. Relative for a pair.
#[must_use]
pub fn memory_displacement(
    memory: &ScalarMemory,
    radius: f64,
    friction_peak: f64,
    materials: &MaterialPair,
    point: [f64; 2],
) -> [f64; 2] {
    let field = |component: usize| {
        memory.superpose(|z| {
            part(z / memory.zeta(), radius, friction_peak, materials, point)[component]
        })
    };
    if memory.is_touching() { [field(0), field(1)] } else { [0.0; 2] }
}

/// As [`memory_displacement`], in two directions.
#[must_use]
pub fn memory_displacement_2d(
    memory: &VectorMemory,
    radius: f64,
    friction_peak: f64,
    materials: &MaterialPair,
    [x, y]: [f64; 2],
) -> [f64; 2] {
    if !memory.is_touching() {
        return [0.0; 2];
    }
    // Tractions along y displace as those along x with the axes exchanged.
    let along = |component: usize, point: [f64; 2]| {
        memory.superpose(|z| {
            part(z / memory.zeta(), radius, friction_peak, materials, point)[component]
        })
    };
    let (u_x, v_x) = (along(0, [x, y])[0], along(1, [x, y])[0]);
    let (v_y, u_y) = (along(0, [y, x])[1], along(1, [y, x])[1]);
    [u_x + u_y, v_x + v_y]
}

/// The displacement by the traction of full sliding on the sub-contact of relative depth `q`.
fn part(
    q: f64,
    radius: f64,
    friction_peak: f64,
    materials: &MaterialPair,
    [x, y]: [f64; 2],
) -> [f64; 2] {
    if q <= 0.0 {
        return [0.0; 2];
    }
    let root = q.sqrt();
    circular_shear(radius * root, friction_peak * root, materials, x, y)
}

/// Stresses inside one body under Hertz's pressure on a circle, in cylindrical components;
/// tension is positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircularStress {
    /// Radial stress.
    pub radial: f64,
    /// Hoop stress.
    pub hoop: f64,
    /// Axial stress.
    pub axial: f64,
    /// Shear stress sigma_rz, z into the body.
    pub shear: f64,
}

impl CircularStress {
    /// The greatest shear stress, half the difference of the extreme principal stresses.
    #[must_use]
    pub fn greatest_shear(&self) -> f64 {
        let middle = 0.5 * (self.radial + self.axial);
        let half = libm::hypot(0.5 * (self.radial - self.axial), self.shear);
        let high = (middle + half).max(self.hoop);
        let low = (middle - half).min(self.hoop);
        0.5 * (high - low)
    }
}

/// The stresses at the radius rho and depth z of a body under the pressure
/// `peak sqrt(1 - rho^2/a^2)` on a circle (Huber).
///
/// ```
/// use carom_halfspace::Material;
/// use carom_laws::field::circular_stress;
/// let steel = Material::from_shear(80e9, 0.3)?;
/// let stress = circular_stress(1.0, 1.0, &steel, 0.0, 0.481)?;
/// assert!((stress.greatest_shear() - 0.310).abs() < 5e-4); // 0.31 p_0 at 0.48 a
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] for a contact radius that is not positive, a negative or not finite coordinate,
/// or a rigid body, in which stresses are not determined.
pub fn circular_stress(
    radius: f64,
    peak: f64,
    body: &Material,
    rho: f64,
    depth: f64,
) -> Result<CircularStress, RangeError> {
    RangeError::positive("radius", radius)?;
    RangeError::finite("peak", peak)?;
    RangeError::non_negative("rho", rho)?;
    RangeError::non_negative("depth", depth)?;
    RangeError::positive("shear_modulus", body.shear_modulus())?;
    let nu = body.poisson();
    let (r, z) = (rho / radius, depth / radius);
    let excess = r * r + z * z - 1.0;
    let root = libm::hypot(excess, 2.0 * z);
    // The ellipsoidal coordinate u, without cancellation.
    let u = if excess > 0.0 { 0.5 * (excess + root) } else { 2.0 * z * z / (root - excess) };
    // z/sqrt(u) is the cosine-like coordinate of the confocal ellipsoid: on the surface inside the
    // circle its limit is sqrt(1 - r^2).
    let w = if excess > 0.0 { z / u.sqrt() } else { (0.5 * (root - excess)).sqrt() };
    let sqrt_u = u.sqrt();
    let arc = if sqrt_u > 0.0 { sqrt_u * libm::atan(1.0 / sqrt_u) } else { 0.0 };
    // (1 - w^3)/r^2 with 1 - w^2 = r^2/(1 + u).
    let share = (1.0 + w + w * w) / ((1.0 + w) * (1.0 + u));
    // w^3 u/(u^2 + z^2) with z = w sqrt(u): w^3/(u + w^2).
    let spread = u + w * w;
    let axial = if spread > 0.0 { -w * w * w / spread } else { 0.0 };
    let third = (1.0 - 2.0 * nu) / 3.0 * share;
    let radial = third - axial + w * (u * (1.0 - nu) / (1.0 + u) + (1.0 + nu) * arc - 2.0);
    let hoop = -third - w * (2.0 * nu + u * (1.0 - nu) / (1.0 + u) - (1.0 + nu) * arc);
    let shear = if spread > 0.0 { -r * w * w * sqrt_u / (spread * (1.0 + u)) } else { 0.0 };
    Ok(CircularStress {
        radial: peak * radial,
        hoop: peak * hoop,
        axial: peak * axial,
        shear: peak * shear,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curvature::RelativeCurvature;
    use crate::hertz::Hertz;
    use approx::assert_relative_eq;

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
        let far = circular_shear(1.0, 1.0, &pair(0.4), 1e3, 0.0);
        assert_relative_eq!(far[0], 2.0 * PI / 3.0 / (2.0 * PI * 1e3), max_relative = 1e-5);
        assert_eq!(
            ellipsoidal_shear(&circle, 1.0, &pair(0.3), f64::NAN, 0.0).unwrap_err().field,
            "x"
        );
    }

    #[test]
    fn the_stick_area_moves_rigidly_by_the_shift() {
        // nu = 0: Cattaneo's theory is exact. F_z, sigma_z0 and X of a unit circle, G = 1.
        let materials = pair(0.0);
        let mut memory = ScalarMemory::new();
        memory.advance(1.0, 0.0).unwrap();
        memory.advance(1.0, 0.7).unwrap();
        memory.advance(1.0, 0.2).unwrap();
        // u = pi sigma a/(4 G) times X in the stick area of slip depth X.
        let stick = memory.stick_radius();
        for rho in [0.0, 0.5 * stick, 0.99 * stick] {
            let kept = memory_displacement(&memory, 1.0, 1.0, &materials, [rho, 0.0]);
            let mut before = ScalarMemory::new();
            before.advance(1.0, 0.0).unwrap();
            before.advance(1.0, 0.7).unwrap();
            let was = memory_displacement(&before, 1.0, 1.0, &materials, [rho, 0.0]);
            assert_relative_eq!(kept[0] - was[0], -0.5 * PI / 4.0, max_relative = 1e-13);
        }
        let mut plane = VectorMemory::new();
        plane.advance(1.0, [0.0, 0.0]).unwrap();
        plane.advance(1.0, [0.0, 0.7]).unwrap();
        plane.advance(1.0, [0.0, 0.2]).unwrap();
        let line = memory_displacement(&memory, 1.0, 1.0, &pair(0.3), [0.4, 1.2]);
        let turned = memory_displacement_2d(&plane, 1.0, 1.0, &pair(0.3), [-1.2, 0.4]);
        assert_relative_eq!(turned[1], line[0], max_relative = 1e-13);
        assert_relative_eq!(turned[0], -line[1], max_relative = 1e-13);
    }

    #[test]
    fn stresses_are_in_equilibrium_and_carry_the_pressure() {
        let body = Material::from_shear(1.0, 0.3).unwrap();
        let at = |r: f64, z: f64| circular_stress(1.0, 1.0, &body, r, z).unwrap();
        for r in [0.0, 0.3, 0.9] {
            assert_relative_eq!(at(r, 0.0).axial, -(1.0_f64 - r * r).sqrt(), max_relative = 1e-14);
        }
        assert_eq!(at(1.5, 0.0).axial, 0.0);
        // On the surface outside: pure shear, radial = -hoop = (1 - 2 nu)/(3 r^2).
        assert_relative_eq!(at(1.5, 0.0).radial, 0.4 / (3.0 * 2.25), max_relative = 1e-14);
        assert_relative_eq!(at(1.5, 0.0).hoop, -0.4 / (3.0 * 2.25), max_relative = 1e-14);
        let h = 1e-5;
        for (r, z) in [(0.4, 0.3), (1.2, 0.2), (0.7, 1.5)] {
            let dr =
                |f: fn(&CircularStress) -> f64| (f(&at(r + h, z)) - f(&at(r - h, z))) / (2.0 * h);
            let dz =
                |f: fn(&CircularStress) -> f64| (f(&at(r, z + h)) - f(&at(r, z - h))) / (2.0 * h);
            let s = at(r, z);
            let radial = dr(|s| s.radial) + dz(|s| s.shear) + (s.radial - s.hoop) / r;
            let axial = dr(|s| s.shear) + dz(|s| s.axial) + s.shear / r;
            assert!(radial.abs() < 1e-8 && axial.abs() < 1e-8, "{radial:e} {axial:e}");
        }
        assert_eq!(
            circular_stress(1.0, 1.0, &Material::RIGID, 0.0, 1.0).unwrap_err().field,
            "shear_modulus"
        );
    }
}
