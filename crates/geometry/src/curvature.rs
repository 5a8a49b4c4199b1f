//! Relative curvature of two bodies at their contact point (5.1)-(5.5).

use carom_special::{RangeError, Readable};

/// If B/A is below this, two cylinders are parallel: rounding of the angle alone gives up to 1e-31.
const LINE_CONTACT: f64 = 1e-30;

/// The two principal radii of curvature of a surface at the contact point, in any order.
///
/// A radius is positive where the surface is convex, negative where it is concave and infinite
/// where it is straight. Angles are measured from the direction of the first radius.
///
/// ```
/// use carom_geometry::curvature::PrincipalRadii;
/// let barrel = PrincipalRadii::new(0.02, 0.5)?;
/// let cylinder = PrincipalRadii::cylinder(0.02)?;
/// let socket = PrincipalRadii::sphere(-0.03)?;
/// assert_eq!(barrel.curvatures(), [50.0, 2.0]);
/// assert_eq!(cylinder.curvatures(), [50.0, 0.0]);
/// assert!(socket.curvatures()[0] < 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalRadii {
    curvatures: [f64; 2],
}

impl PrincipalRadii {
    /// A plane: both radii infinite.
    pub const PLANE: Self = Self { curvatures: [0.0, 0.0] };

    /// The radius in the first principal direction and the one perpendicular to it (5.1).
    ///
    /// # Errors
    /// [`RangeError`] if a radius is zero, not a number, or so small that 1/R overflows.
    pub fn new(radius: f64, radius_across: f64) -> Result<Self, RangeError> {
        Ok(Self {
            curvatures: [
                curvature_of("radius", radius)?,
                curvature_of("radius_across", radius_across)?,
            ],
        })
    }

    /// A sphere or, with a negative radius, a spherical socket.
    ///
    /// # Errors
    /// As [`PrincipalRadii::new`].
    pub fn sphere(radius: f64) -> Result<Self, RangeError> {
        Self::new(radius, radius)
    }

    /// A circular cylinder, curved in the first principal direction and straight across it.
    ///
    /// # Errors
    /// As [`PrincipalRadii::new`].
    pub fn cylinder(radius: f64) -> Result<Self, RangeError> {
        Self::new(radius, f64::INFINITY)
    }

    /// The principal curvatures 1/R and 1/R'.
    #[must_use]
    pub const fn curvatures(&self) -> [f64; 2] {
        self.curvatures
    }

    /// The principal radii R and R'; infinite where the surface is straight.
    #[must_use]
    pub fn radii(&self) -> [f64; 2] {
        self.curvatures.map(|c| if c == 0.0 { f64::INFINITY } else { 1.0 / c })
    }

    /// The smallest radius of curvature of two surfaces, convex or concave; infinite for two planes.
    ///
    /// ```
    /// use carom_geometry::curvature::PrincipalRadii;
    /// let (ball, groove) = (PrincipalRadii::sphere(0.02)?, PrincipalRadii::new(-0.025, f64::INFINITY)?);
    /// assert_eq!(PrincipalRadii::smallest([ball, groove]), 0.02);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    #[must_use]
    pub fn smallest(both: [Self; 2]) -> f64 {
        let all = both.map(|radii| radii.curvatures).concat();
        all.into_iter().fold(0.0, |most: f64, one| most.max(one.abs())).recip()
    }
}

fn curvature_of(field: &'static str, radius: f64) -> Result<f64, RangeError> {
    let curvature = 1.0 / radius;
    RangeError::check(field, radius, curvature.is_finite(), "nonzero and not NaN (inf: straight)")?;
    // 1/-inf = -0: a straight line has no sign of curvature.
    Ok(if curvature == 0.0 { 0.0 } else { curvature })
}

/// Why two surfaces have no elliptical contact.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum CurvatureError {
    /// An angle or coefficient is out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The smaller coefficient B is zero: parallel cylinders (or two planes) touch along a line (or
    /// over an area), and the Hertz ellipse degenerates.
    #[error(
        "the surfaces touch along a line or an area, not at a point: A = {}, B = {}, \
         and B must exceed 1e-30 A for an elliptical contact",
        Readable(*a),
        Readable(*b)
    )]
    LineContact {
        /// The larger coefficient A.
        a: f64,
        /// The smaller coefficient B.
        b: f64,
    },
    /// A concave surface is curved more strongly than the convex one that faces it.
    #[error(
        "the surfaces conform or intersect: A = {}, B = {}, and both must be positive for a \
         contact that begins at a point",
        Readable(*a),
        Readable(*b)
    )]
    Conforming {
        /// The larger coefficient A.
        a: f64,
        /// The smaller coefficient B.
        b: f64,
    },
}

/// The gap `z = A x^2 + B y^2` between two undeformed surfaces (5.2).
///
/// [`RelativeCurvature::new`] orients the axes so that A >= B > 0. Then x points along the larger
/// relative curvature, which is the direction of the smaller semi-axis a of the contact ellipse.
///
/// ```
/// use carom_geometry::curvature::{PrincipalRadii, RelativeCurvature};
/// // Equal crossed cylinders touch like a sphere on a plane.
/// let cylinder = PrincipalRadii::cylinder(2.0)?;
/// let gap = RelativeCurvature::new(cylinder, cylinder, std::f64::consts::FRAC_PI_2)?;
/// assert!((gap.a() - 0.25).abs() < 1e-15 && (gap.b() - 0.25).abs() < 1e-15);
/// # Ok::<(), carom_geometry::curvature::CurvatureError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RelativeCurvature {
    a: f64,
    b: f64,
    angle: f64,
}

impl RelativeCurvature {
    /// The relative curvature of two bodies. `omega` (radians) is the angle from the first
    /// principal direction of body 1 to that of body 2.
    ///
    /// A and B are the eigenvalues of the sum of both quadratic forms (5.3), corrected. B is
    /// computed as (AB)/A, which is accurate for nearly parallel cylinders.
    ///
    /// # Errors
    /// [`CurvatureError::LineContact`] for parallel cylinders and for two planes,
    /// [`CurvatureError::Conforming`] if a concave surface is curved too strongly, and
    /// [`CurvatureError::Range`] for an angle that is not finite.
    pub fn new(
        body_1: PrincipalRadii,
        body_2: PrincipalRadii,
        omega: f64,
    ) -> Result<Self, CurvatureError> {
        RangeError::finite("omega", omega)?;
        let [c1, c1_across] = body_1.curvatures;
        let [c2, c2_across] = body_2.curvatures;
        let (sin, cos) = libm::sincos(omega);
        let (sin_2, cos_2) = (2.0 * sin * cos, (cos - sin) * (cos + sin));
        let (d1, d2) = (c1 - c1_across, c2 - c2_across);
        // 2(A + B), 2(A - B) and 4AB of (5.3).
        let sum = (c1 + c1_across) + (c2 + c2_across);
        let (along, across) = (d1 + d2 * cos_2, d2 * sin_2);
        let difference = libm::hypot(along, across);
        let product = c1 * c1_across
            + c2 * c2_across
            + (c1 * c2 + c1_across * c2_across) * (sin * sin)
            + (c1 * c2_across + c1_across * c2) * (cos * cos);
        let a = 0.25 * (sum + difference);
        let b = if a > 0.0 { 0.25 * product / a } else { 0.25 * (sum - difference) };
        let angle = if difference == 0.0 { 0.0 } else { 0.5 * libm::atan2(across, along) };
        Self::checked(a, b.min(a), angle)
    }

    /// From coefficients A along x and B along y; either may be the larger one.
    ///
    /// # Errors
    /// As [`RelativeCurvature::new`].
    pub fn from_coefficients(a: f64, b: f64) -> Result<Self, CurvatureError> {
        Self::checked(a, b, 0.0)
    }

    fn checked(a: f64, b: f64, angle: f64) -> Result<Self, CurvatureError> {
        RangeError::finite("coefficient A", a)?;
        RangeError::finite("coefficient B", b)?;
        let (small, large) = if a < b { (a, b) } else { (b, a) };
        if small.abs() <= LINE_CONTACT * large.abs() {
            Err(CurvatureError::LineContact { a, b })
        } else if small < 0.0 {
            Err(CurvatureError::Conforming { a, b })
        } else {
            Ok(Self { a, b, angle })
        }
    }

    /// The coefficient A of x^2, 1/length.
    #[must_use]
    pub const fn a(&self) -> f64 {
        self.a
    }

    /// The coefficient B of y^2, 1/length.
    #[must_use]
    pub const fn b(&self) -> f64 {
        self.b
    }

    /// The angle alpha (radians, in (-pi/2, pi/2]) from the first principal direction of body 1 to
    /// the x-axis, measured in the same sense as omega; zero if every direction is principal.
    #[must_use]
    pub const fn angle(&self) -> f64 {
        self.angle
    }

    /// The undeformed gap A x^2 + B y^2 (5.2).
    #[must_use]
    pub fn gap(&self, x: f64, y: f64) -> f64 {
        self.a * x * x + self.b * y * y
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn radii(a: f64, b: f64) -> PrincipalRadii {
        PrincipalRadii::new(a, b).unwrap()
    }

    #[test]
    fn eigenvalues_of_the_summed_forms() {
        let (r1, r2, omega) = (radii(1.0, 2.0), radii(3.0, -9.0), 0.6_f64);
        let gap = RelativeCurvature::new(r1, r2, omega).unwrap();
        // Independent: the sum of both shape operators has trace 2(A + B), determinant 4AB.
        let (s, c) = omega.sin_cos();
        let (p, q) = (1.0 / 3.0, -1.0 / 9.0);
        let m =
            [[1.0 + p * c * c + q * s * s, (p - q) * s * c], [0.0, 0.5 + p * s * s + q * c * c]];
        assert_relative_eq!(2.0 * (gap.a() + gap.b()), m[0][0] + m[1][1], max_relative = 1e-15);
        let det = m[0][0] * m[1][1] - m[0][1] * m[0][1];
        assert_relative_eq!(4.0 * gap.a() * gap.b(), det, max_relative = 1e-14);
        // The x-axis is the eigenvector of A.
        let (sa, ca) = gap.angle().sin_cos();
        let image = [m[0][0] * ca + m[0][1] * sa, m[0][1] * ca + m[1][1] * sa];
        assert_relative_eq!(image[0], 2.0 * gap.a() * ca, max_relative = 1e-14);
        assert_relative_eq!(image[1], 2.0 * gap.a() * sa, max_relative = 1e-14);
    }

    #[test]
    fn nearly_parallel_cylinders_keep_their_digits() {
        let cylinder = PrincipalRadii::cylinder(1.0).unwrap();
        let gap = RelativeCurvature::new(cylinder, cylinder, 1e-9).unwrap();
        assert_relative_eq!(gap.b(), 2.5e-19, max_relative = 1e-14);
    }

    #[test]
    fn degenerate_pairs_are_named() {
        let cylinder = PrincipalRadii::cylinder(1.0).unwrap();
        let sphere = PrincipalRadii::sphere(1.0).unwrap();
        let tight = PrincipalRadii::sphere(-0.9).unwrap();
        for omega in [0.0, std::f64::consts::PI] {
            let error = RelativeCurvature::new(cylinder, cylinder, omega).unwrap_err();
            assert!(matches!(error, CurvatureError::LineContact { .. }), "{error}");
        }
        let plane = PrincipalRadii::PLANE;
        let error = RelativeCurvature::new(plane, plane, 0.0).unwrap_err();
        assert!(matches!(error, CurvatureError::LineContact { .. }));
        let error = RelativeCurvature::new(sphere, tight, 0.3).unwrap_err();
        assert!(matches!(error, CurvatureError::Conforming { .. }));
        let error = RelativeCurvature::new(sphere, radii(-0.9, 5.0), 0.3).unwrap_err();
        assert!(matches!(error, CurvatureError::Conforming { .. }));
        let error = RelativeCurvature::new(sphere, sphere, f64::NAN).unwrap_err();
        assert!(matches!(error, CurvatureError::Range(RangeError { field: "omega", .. })));
        assert_eq!(PrincipalRadii::sphere(0.0).unwrap_err().field, "radius");
        assert_eq!(PrincipalRadii::new(1.0, f64::NAN).unwrap_err().field, "radius_across");
    }

    /// Two cylinders that cross at a small angle touch at a point: B/A is half the angle, squared.
    #[test]
    fn cylinders_touch_along_a_line_only_within_round_off_of_parallel() {
        let cylinder = PrincipalRadii::cylinder(1.0).unwrap();
        let crossed = |omega| RelativeCurvature::new(cylinder, cylinder, omega);
        for omega in [1e-6, 1e-9, 1e-12, 2.1e-15] {
            let gap = crossed(omega).unwrap();
            assert_relative_eq!(gap.b() / gap.a(), 0.25 * omega * omega, max_relative = 1e-10);
        }
        assert!(matches!(crossed(1.9e-15), Err(CurvatureError::LineContact { .. })));
    }
}
