//! Axisymmetric indenters: their normal force, which the memory law needs, and their pressure.
//!
//! By the theorem of Ciavarella and Jaeger the tangential problem of any axisymmetric contact is a
//! difference of normal ones. The memory of chapter 6 therefore holds with F_z(zeta) in place of
//! zeta^(3/2).

use carom_special::RangeError;
use carom_special::quadrature::FixedRule;

/// Gauss nodes and weights on (0, 1), eight points: exact to rounding for F' over a tenth of the
/// depth.
pub(crate) const GAUSS: [(f64, f64); 8] = FixedRule::parts();

/// A dimensionless normal law: `force(zeta)` is F_z divided by a constant of the contact.
///
/// The second derivative of the force is the density of springs of the equivalent one-dimensional
/// foundation; it is not negative.
pub trait NormalProfile: Copy {
    /// F_z at an approach zeta >= 0; zero at zero.
    fn force(&self, zeta: f64) -> f64;

    /// dF_z/dzeta.
    fn stiffness(&self, zeta: f64) -> f64;

    /// F_z(from + by) - F_z(from), without cancellation; by >= 0, and not both are zero.
    fn growth(&self, from: f64, by: f64) -> f64 {
        self.force(from + by) - self.force(from)
    }

    /// The integral of F_z from 0 to zeta.
    fn energy(&self, zeta: f64) -> f64;

    /// The integrals over the springs from `stick` to `zeta` of (zeta - s) and of (zeta - s)^2.
    fn slip_moments(&self, zeta: f64, stick: f64) -> [f64; 2] {
        let ring = [zeta - stick, 0.0];
        let first = self.spring_product(stick, zeta, ring, [1.0, 1.0]);
        let second = self.spring_product(stick, zeta, ring, ring);
        [first.max(0.0), second.max(0.0)]
    }

    /// The integral over the springs from `lower` to `upper` of the product of two functions
    /// that are linear in s, given by their values at both ends.
    fn spring_product(&self, lower: f64, upper: f64, u: [f64; 2], v: [f64; 2]) -> f64 {
        let length = upper - lower;
        if length <= 0.0 {
            return 0.0;
        }
        let (slope_u, slope_v) = ((u[1] - u[0]) / length, (v[1] - v[0]) / length);
        let slope_of_product = |i: usize| slope_u * v[i] + slope_v * u[i];
        if length < 0.1 * upper {
            // Integrated once by parts, against F' - F'(lower), to avoid dividing twice by a small
            // length.
            let growth = |s: f64| self.stiffness(s) - self.stiffness(lower);
            let [low, high] = [slope_of_product(0), slope_of_product(1)];
            let rest = GAUSS.iter().fold(0.0, |sum, &(part, weight)| {
                sum + weight * growth(lower + part * length) * (low + part * (high - low))
            });
            return growth(upper) * u[1] * v[1] - rest * length;
        }
        // Twice by parts, with F'' the density.
        self.stiffness(upper) * u[1] * v[1]
            - self.stiffness(lower) * u[0] * v[0]
            - self.force(upper) * slope_of_product(1)
            + self.force(lower) * slope_of_product(0)
            + 2.0 * slope_u * slope_v * (self.energy(upper) - self.energy(lower))
    }
}

/// Bodies of curved (quadratic) surfaces: `zeta^(3/2)`.
///
/// F_z of a Hertz contact is (2/3) c_z times this.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Hertzian;

impl NormalProfile for Hertzian {
    #[inline]
    fn force(&self, zeta: f64) -> f64 {
        zeta * zeta.sqrt()
    }

    #[inline]
    fn stiffness(&self, zeta: f64) -> f64 {
        1.5 * zeta.sqrt()
    }

    #[inline]
    fn growth(&self, from: f64, by: f64) -> f64 {
        // a^3 - b^3 = (a^2 - b^2) (a + b - a b/(a + b)) is accurate for small steps.
        let (a, b) = ((from + by).sqrt(), from.sqrt());
        let sum = a + b;
        by * (sum - a * b / sum)
    }

    fn energy(&self, zeta: f64) -> f64 {
        0.4 * zeta * self.force(zeta)
    }

    fn slip_moments(&self, zeta: f64, stick: f64) -> [f64; 2] {
        // With a = sqrt(zeta) and b = sqrt(stick), the differences in closed form.
        let (a, b) = (zeta.sqrt(), stick.sqrt());
        let ring = (zeta - stick) / (a + b);
        [
            ring * ring * (a + 0.5 * b),
            ring * ring * ring * (0.8 * a * a + 0.9 * a * b + 0.3 * b * b),
        ]
    }

    fn spring_product(&self, lower: f64, upper: f64, u: [f64; 2], v: [f64; 2]) -> f64 {
        let length = upper - lower;
        if length <= 0.0 {
            return 0.0;
        }
        // In t = sqrt(s) the density is constant, 3/2, and the product a quartic: three Gauss
        // points are exact and, for u = v, add positive terms only.
        let (a, b) = (lower.sqrt(), upper.sqrt());
        let (half, middle) = (0.5 * length / (a + b), 0.5 * (a + b));
        let at = |ends: [f64; 2], part: f64| ends[0] + (ends[1] - ends[0]) * part;
        [
            (-0.774_596_669_241_483_4, 5.0 / 9.0),
            (0.0, 8.0 / 9.0),
            (0.774_596_669_241_483_4, 5.0 / 9.0),
        ]
        .into_iter()
        .map(|(node, weight)| {
            let t = middle + half * node;
            let part = (t - a) * (t + a) / length;
            weight * at(u, part) * at(v, part)
        })
        .sum::<f64>()
            * (1.5 * half)
    }
}

/// A power of the approach: `zeta^n`, n = 1 + 1/p for the indenter `z ~ rho^p`.
///
/// n = 2 is a cone, n = 3/2 a paraboloid; n tends to 1 for a flat punch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerLaw {
    exponent: f64,
}

impl PowerLaw {
    /// A cone.
    pub const CONE: Self = Self { exponent: 2.0 };

    /// The law of an indenter of the shape `z ~ rho^shape`.
    ///
    /// # Errors
    /// [`RangeError`] unless the shape exponent is finite and positive.
    pub fn of_shape(shape: f64) -> Result<Self, RangeError> {
        RangeError::positive("shape", shape)?;
        Ok(Self { exponent: 1.0 + 1.0 / shape })
    }
}

impl NormalProfile for PowerLaw {
    fn force(&self, zeta: f64) -> f64 {
        libm::pow(zeta, self.exponent)
    }

    fn stiffness(&self, zeta: f64) -> f64 {
        self.exponent * libm::pow(zeta, self.exponent - 1.0)
    }

    fn energy(&self, zeta: f64) -> f64 {
        libm::pow(zeta, self.exponent + 1.0) / (self.exponent + 1.0)
    }
}

/// A punch with a flat end of radius `flat` and parabolic flanks: for a contact of radius a, `zeta
/// = a sqrt(a^2 - flat^2)/R`.
///
/// The force is scaled such that for R = 1 and a vanishing flat end it equals that of [`Hertzian`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoundedFlat {
    flat: f64,
}

impl RoundedFlat {
    /// A punch of unit flank radius with a flat end of the given radius.
    ///
    /// # Errors
    /// [`RangeError`] unless the radius is finite and positive.
    pub fn new(flat_radius: f64) -> Result<Self, RangeError> {
        RangeError::positive("flat_radius", flat_radius).map(|flat| Self { flat })
    }

    /// The square of the contact radius: `a^2 = (flat^2 + sqrt(flat^4 + 4 zeta^2))/2`.
    #[must_use]
    pub fn radius_squared(&self, zeta: f64) -> f64 {
        let square = self.flat * self.flat;
        0.5 * (square + libm::hypot(square, 2.0 * zeta))
    }

    /// `sqrt(a^2 - flat^2)` without cancellation.
    fn flank(&self, zeta: f64) -> f64 {
        zeta / self.radius_squared(zeta).sqrt()
    }
}

impl NormalProfile for RoundedFlat {
    fn force(&self, zeta: f64) -> f64 {
        // F = (3/2) int a dzeta, with w = sqrt(a^2 - b^2): zeta = w sqrt(w^2 + b^2), and
        // int a dzeta = a zeta - int zeta da, zeta da = w^2 dw: a zeta - w^3/3.
        let w = self.flank(zeta);
        let a = self.radius_squared(zeta).sqrt();
        1.5 * (a * zeta - w * w * w / 3.0)
    }

    fn stiffness(&self, zeta: f64) -> f64 {
        1.5 * self.radius_squared(zeta).sqrt()
    }

    fn energy(&self, zeta: f64) -> f64 {
        // int F dzeta with dzeta = (2 w^2 + b^2)/a dw and F = a^2 w - w^3/3 = b^2 w + (2/3) w^3:
        // by parts F zeta - int zeta dF, dF = (b^2 + 2 w^2) dw, zeta = w a.
        let (b, w) = (self.flat, self.flank(zeta));
        let a = self.radius_squared(zeta).sqrt();
        // int w a (b^2 + 2 w^2) dw with a da = w dw: int a^2 (2 a^2 - b^2) da from b to a, which has
        // the factor a - b = w^2/(a + b).
        let fifths = (a + b) * (a * a * a + a * b * b) + b * b * b * b;
        let thirds = a * a + a * b + b * b;
        let moment = (0.4 * fifths - b * b / 3.0 * thirds) / (a + b);
        1.5 * w * w * ((b * b + 2.0 / 3.0 * w * w) * a - moment)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn integrate(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
        let n = 4000;
        let h = (to - from) / f64::from(n);
        (0..n).map(|i| f(from + (f64::from(i) + 0.5) * h)).sum::<f64>() * h
    }

    fn check<P: NormalProfile>(profile: &P) {
        let (lower, upper) = (0.3, 0.9);
        let force = integrate(|z| profile.stiffness(z), lower, upper);
        let difference = profile.force(upper) - profile.force(lower);
        assert_relative_eq!(force, difference, max_relative = 1e-7);
        assert_relative_eq!(profile.growth(lower, upper - lower), difference, max_relative = 1e-14);
        let energy = integrate(|z| profile.force(z), lower, upper);
        let difference = profile.energy(upper) - profile.energy(lower);
        assert_relative_eq!(energy, difference, max_relative = 1e-7);
        // First moment by parts once: int F'' (upper - s) ds = int (F' - F'(lower)) ds.
        let first = integrate(|z| profile.stiffness(z) - profile.stiffness(lower), lower, upper);
        let second = 2.0
            * integrate(
                |z| (profile.stiffness(z) - profile.stiffness(lower)) * (upper - z),
                lower,
                upper,
            );
        let moments = profile.slip_moments(upper, lower);
        assert_relative_eq!(moments[0], first, max_relative = 1e-6);
        assert_relative_eq!(moments[1], second, max_relative = 1e-6);
        let ring = upper - lower;
        let product = profile.spring_product(lower, upper, [ring, 0.0], [ring, 0.0]);
        assert_relative_eq!(product, second, max_relative = 1e-6);
        let product = profile.spring_product(lower, upper, [ring, 0.0], [1.0, 1.0]);
        assert_relative_eq!(product, first, max_relative = 1e-6);
        assert_eq!(profile.force(0.0), 0.0);
    }

    #[test]
    fn force_stiffness_energy_and_moments_agree() {
        check(&Hertzian);
        check(&PowerLaw::CONE);
        check(&PowerLaw::of_shape(2.0).unwrap());
        check(&PowerLaw::of_shape(4.0).unwrap());
        check(&RoundedFlat::new(0.5).unwrap());
        assert_relative_eq!(
            RoundedFlat::new(1e-6).unwrap().force(0.7),
            Hertzian.force(0.7),
            max_relative = 1e-10
        );
    }

    #[test]
    fn force_of_a_power_indenter_is_that_of_its_springs() {
        // One-dimensional foundation: the spring at x touches at the approach x^shape, so that
        // F is proportional to int (zeta - x^shape) dx.
        for shape in [0.5, 1.0, 2.0, 3.0, 6.0] {
            let law = PowerLaw::of_shape(shape).unwrap();
            let springs = |zeta: f64| {
                integrate(|x| zeta - libm::pow(x, shape), 0.0, libm::pow(zeta, 1.0 / shape))
            };
            let want = springs(0.7) / springs(0.2);
            assert_relative_eq!(law.force(0.7) / law.force(0.2), want, max_relative = 1e-5);
        }
        assert_eq!(PowerLaw::of_shape(1.0).unwrap(), PowerLaw::CONE);
    }
}
