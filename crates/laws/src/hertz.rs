//! The Hertz contact (5.7)-(5.17): force, approach, ellipse and pressure.

use std::f64::consts::PI;

use carom_halfspace::{Material, MaterialPair};
use carom_special::elliptic::complete;
use carom_special::{AxisRatio, RangeError};
use carom_table::Column;

use crate::curvature::{CurvatureError, RelativeCurvature};
use crate::ellipse::ContactEllipse;
use crate::stiffness::ContactStiffness;

/// Greatest number of Newton steps for any A/B to rounding; at most six occur, for slender
/// ellipses.
const NEWTON_STEPS: usize = 40;

/// The dimensionless parameters of (5.12) and (5.25a), functions of the axis ratio alone.
///
/// ```
/// use carom_laws::hertz::HertzParameters;
/// use carom_special::AxisRatio;
/// let circle = HertzParameters::of(AxisRatio::CIRCLE);
/// assert_eq!((circle.beta, circle.gamma, circle.delta), (1.0, 0.5, 0.5));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzParameters {
    /// `alpha = (3/(2 pi)) k' E(k) = a^3 (A + B)/(F_z (1 - nu)/(2 G))`.
    pub alpha: f64,
    /// `beta = E/K = a^2 (A + B)/zeta` (5.14).
    pub beta: f64,
    /// `gamma = (K - D)/E = A/(A + B)`.
    pub gamma: f64,
    /// `delta = D/K`, the parameter of Cattaneo's solution.
    pub delta: f64,
}

impl HertzParameters {
    /// The parameters for the axis ratio a/b; a > b is allowed.
    #[must_use]
    pub fn of(ratio: AxisRatio) -> Self {
        let (k, e) = (complete::k(ratio), complete::e(ratio));
        Self {
            alpha: 1.5 / PI * ratio.get() * e,
            beta: e / k,
            gamma: complete::b(ratio) / e,
            delta: complete::d(ratio) / k,
        }
    }
}

/// A Hertz contact between two bodies: everything that does not depend on the load.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
/// use carom_laws::hertz::Hertz;
/// let steel = Material::from_young(208e9, 0.3)?;
/// let ball = PrincipalRadii::sphere(0.01)?;
/// let gap = RelativeCurvature::new(ball, PrincipalRadii::PLANE, 0.0)?;
/// let hertz = Hertz::new(gap, MaterialPair::new(steel, steel)?)?;
/// let state = hertz.at_force(100.0)?;
/// // Sphere on plane: a^2 = R zeta.
/// let a = state.ellipse.semi_axis_a();
/// assert!((a * a / (0.01 * state.approach) - 1.0).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz {
    curvature: RelativeCurvature,
    materials: MaterialPair,
    ratio: AxisRatio,
    stiffness: ContactStiffness,
    /// `a^2/zeta` and `b^2/zeta`.
    squares: [f64; 2],
}

/// A Hertz contact under load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzState {
    /// The approach zeta of points far from the contact.
    pub approach: f64,
    /// The normal force F_z.
    pub force: f64,
    /// The contact ellipse.
    pub ellipse: ContactEllipse,
    /// The greatest pressure `sigma_z0 = 3 F_z/(2 pi a b)` (5.11).
    pub peak_pressure: f64,
    /// The tangent `dF_z/dzeta = c_z sqrt(zeta)`.
    pub normal_stiffness: f64,
}

impl HertzState {
    /// The quantities of a loaded contact, in SI units.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("force", "N", "normal force F_z", |state| state.force.into()),
        Column::new("approach", "m", "of distant points, zeta", |state| state.approach.into()),
        Column::new("semi_axis_a", "m", "of the contact ellipse along x", |state| {
            state.ellipse.semi_axis_a().into()
        }),
        Column::new("semi_axis_b", "m", "of the contact ellipse along y", |state| {
            state.ellipse.semi_axis_b().into()
        }),
        Column::new("peak_pressure", "Pa", "in the middle of the contact", |state| {
            state.peak_pressure.into()
        }),
        Column::new("normal_stiffness", "N/m", "tangent dF_z/dzeta", |state| {
            state.normal_stiffness.into()
        }),
    ];

    /// The pressure p_z at a point of the contact plane; zero outside the ellipse (5.10).
    #[must_use]
    pub fn pressure(&self, x: f64, y: f64) -> f64 {
        self.peak_pressure * (1.0 - self.ellipse.radius_squared(x, y)).max(0.0).sqrt()
    }
}

impl Hertz {
    /// The quantities that do not depend on the load.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("axis_ratio", "", "a/b of the contact ellipse", |h| {
            h.axis_ratio().get().into()
        }),
        Column::new("angle", "deg", "from the first direction of body 1 to the x axis", |hertz| {
            hertz.curvature().angle().to_degrees().into()
        }),
        Column::new("c_x", "N/m^1.5", "dF_x = c_x sqrt(zeta) dxi", |h| h.stiffness().c_x.into()),
        Column::new("c_y", "N/m^1.5", "the same along y", |h| h.stiffness().c_y.into()),
        Column::new("c_z", "N/m^1.5", "F_z = (2/3) c_z zeta^1.5", |h| h.stiffness().c_z.into()),
    ];

    /// The contact of two bodies with given relative curvature and materials.
    ///
    /// # Errors
    /// [`RangeError`] if a stiffness coefficient over- or underflows.
    pub fn new(curvature: RelativeCurvature, materials: MaterialPair) -> Result<Self, RangeError> {
        let ratio = axis_ratio_of(curvature.a(), curvature.b())?;
        Self::of_ratio(curvature, ratio, materials)
    }

    /// The contact with a given ellipse at a given approach; the curvatures follow from (5.14).
    /// Either semi-axis may be the larger one.
    ///
    /// # Errors
    /// [`CurvatureError`] for an approach that is not positive or curvatures out of range.
    pub fn from_ellipse(
        ellipse: ContactEllipse,
        approach: f64,
        materials: MaterialPair,
    ) -> Result<Self, CurvatureError> {
        RangeError::positive("approach", approach)?;
        let ratio = ellipse.axis_ratio();
        let (a, b) = (ellipse.semi_axis_a(), ellipse.semi_axis_b());
        let per_k = approach / complete::k(ratio);
        let curvature = RelativeCurvature::from_coefficients(
            per_k * complete::b(ratio) / (a * a),
            per_k * complete::d(ratio) / (b * b),
        )?;
        Ok(Self::of_ratio(curvature, ratio, materials)?)
    }

    /// The contact with a given ellipse under a given force.
    ///
    /// # Errors
    /// As [`Hertz::from_ellipse`], with the force.
    pub fn from_ellipse_and_force(
        ellipse: ContactEllipse,
        force: f64,
        materials: MaterialPair,
    ) -> Result<Self, CurvatureError> {
        RangeError::positive("force", force)?;
        // F_z = (4 pi/3) b zeta G/((1 - nu) K), from (5.11), (5.14) and (5.25b).
        let b = ellipse.semi_axis_b();
        let modulus = materials.shear_modulus() / (1.0 - materials.poisson());
        let k = complete::k(ellipse.axis_ratio());
        Self::from_ellipse(ellipse, 0.75 * force * k / (PI * b * modulus), materials)
    }

    fn of_ratio(
        curvature: RelativeCurvature,
        ratio: AxisRatio,
        materials: MaterialPair,
    ) -> Result<Self, RangeError> {
        let stiffness = ContactStiffness::from_curvature(curvature, ratio, &materials)?;
        let k = complete::k(ratio);
        let squares = [
            complete::b(ratio) / (curvature.a() * k), // zeta = A a^2 K/(K - D)
            complete::d(ratio) / (curvature.b() * k), // zeta = B b^2 K/D
        ];
        RangeError::positive("a^2/zeta", squares[0])?;
        RangeError::positive("b^2/zeta", squares[1])?;
        Ok(Self { curvature, materials, ratio, stiffness, squares })
    }

    /// The relative curvature.
    #[must_use]
    pub const fn curvature(&self) -> RelativeCurvature {
        self.curvature
    }

    /// The materials of both bodies.
    #[must_use]
    pub const fn materials(&self) -> MaterialPair {
        self.materials
    }

    /// The axis ratio a/b, the same under any load.
    #[must_use]
    pub const fn axis_ratio(&self) -> AxisRatio {
        self.ratio
    }

    /// The stiffness coefficients (5.25).
    #[must_use]
    pub const fn stiffness(&self) -> ContactStiffness {
        self.stiffness
    }

    /// The parameters alpha, beta, gamma and delta.
    #[must_use]
    pub fn parameters(&self) -> HertzParameters {
        HertzParameters::of(self.ratio)
    }

    /// The normal force `(2/3) c_z zeta^(3/2)` (5.27); zero for separated bodies.
    #[must_use]
    pub fn force(&self, approach: f64) -> f64 {
        if approach > 0.0 {
            2.0 / 3.0 * self.stiffness.c_z * (approach * approach.sqrt())
        } else {
            0.0
        }
    }

    /// The tangent dF_z/dzeta = c_z sqrt(zeta); zero for separated bodies.
    #[must_use]
    pub fn normal_stiffness(&self, approach: f64) -> f64 {
        if approach > 0.0 { self.stiffness.c_z * approach.sqrt() } else { 0.0 }
    }

    /// The elastic energy of compression, the integral of F_z over the approach.
    #[must_use]
    pub fn normal_energy(&self, approach: f64) -> f64 {
        0.4 * self.force(approach) * approach.max(0.0)
    }

    /// The approach under a compressive force; zero without force.
    #[must_use]
    pub fn approach(&self, force: f64) -> f64 {
        let root = libm::cbrt(1.5 * force.max(0.0) / self.stiffness.c_z);
        root * root
    }

    /// The loaded contact at a given approach.
    ///
    /// # Errors
    /// [`RangeError`] unless the approach is finite and positive.
    pub fn at_approach(&self, approach: f64) -> Result<HertzState, RangeError> {
        RangeError::positive("approach", approach)?;
        self.state(approach, self.force(approach))
    }

    /// The loaded contact under a given force.
    ///
    /// # Errors
    /// [`RangeError`] unless the force is finite and positive.
    pub fn at_force(&self, force: f64) -> Result<HertzState, RangeError> {
        RangeError::positive("force", force)?;
        self.state(self.approach(force), force)
    }

    /// The loaded contact with a given semi-axis along x.
    ///
    /// # Errors
    /// [`RangeError`] unless the semi-axis is finite and positive.
    pub fn at_semi_axis_a(&self, semi_axis_a: f64) -> Result<HertzState, RangeError> {
        let a = RangeError::positive("semi_axis_a", semi_axis_a)?;
        self.at_approach(a * a / self.squares[0])
    }

    /// The loaded contact with a given semi-axis along y.
    ///
    /// # Errors
    /// [`RangeError`] unless the semi-axis is finite and positive.
    pub fn at_semi_axis_b(&self, semi_axis_b: f64) -> Result<HertzState, RangeError> {
        let b = RangeError::positive("semi_axis_b", semi_axis_b)?;
        self.at_approach(b * b / self.squares[1])
    }

    /// The loaded contact with a given greatest pressure, which grows with the root of the approach.
    ///
    /// # Errors
    /// [`RangeError`] unless the pressure is finite and positive.
    pub fn at_peak_pressure(&self, peak_pressure: f64) -> Result<HertzState, RangeError> {
        let peak = RangeError::positive("peak_pressure", peak_pressure)?;
        // 3 F_z/(2 pi a b) = c_z sqrt(zeta)/(pi sqrt((a^2/zeta)(b^2/zeta))).
        let [a, b] = self.squares.map(f64::sqrt);
        let root = PI * (a * b) * peak / self.stiffness.c_z;
        self.at_approach(root * root)
    }

    /// The contact ellipse at a given approach.
    ///
    /// # Errors
    /// [`RangeError`] unless the approach is finite and positive.
    pub fn ellipse(&self, approach: f64) -> Result<ContactEllipse, RangeError> {
        RangeError::positive("approach", approach)?;
        let [a, b] = self.squares.map(|square| (square * approach).sqrt());
        ContactEllipse::new(a, b)
    }

    fn state(&self, approach: f64, force: f64) -> Result<HertzState, RangeError> {
        let ellipse = self.ellipse(approach)?;
        Ok(HertzState {
            approach,
            force,
            ellipse,
            peak_pressure: ellipse.peak_pressure(force),
            normal_stiffness: self.normal_stiffness(approach),
        })
    }

    /// The height z of the deformed contact surface inside the ellipse. The undeformed surfaces are
    /// at `z_1` and `z_2` from the tangent plane, each measured along its own normal: `(theta_1 +
    /// theta_2) z = theta_2 z_1 - theta_1 z_2 + theta_1 zeta` (5.17), corrected.
    ///
    /// The surface follows that of the harder body, and is plane for two equal bodies.
    #[must_use]
    pub fn contact_surface(&self, approach: f64, z_1: f64, z_2: f64) -> f64 {
        let compliance = |body: Material| (1.0 - body.poisson()) / body.shear_modulus();
        let one = compliance(self.materials.body_1());
        let two = compliance(self.materials.body_2());
        (two * z_1 + one * (approach - z_2)) / (one + two)
    }
}

/// The axis ratio k' = a/b of the ellipse for given curvatures: the root of `A/B = (K - D)/(k'^2
/// D)`, from (5.12) and (5.14).
fn axis_ratio_of(a: f64, b: f64) -> Result<AxisRatio, RangeError> {
    if a < b {
        return Ok(axis_ratio_of(b, a)?.inverse());
    }
    let target = a / b;
    // On a log-log scale the slope is monotone, from -3/2 at the circle to -2 for a line, so that
    // Newton steps from the asymptote of the circle stay on one side of the root.
    let mut ratio = AxisRatio::new(libm::pow(target, -2.0 / 3.0))?;
    let mut best = (f64::INFINITY, ratio);
    for _ in 0..NEWTON_STEPS {
        let (kc, b, d) = (ratio.get(), complete::b(ratio), complete::d(ratio));
        let excess = libm::log((b / d) / (kc * kc) / target);
        if excess.abs() >= best.0 {
            break;
        }
        best = (excess.abs(), ratio);
        let c = complete::c(ratio);
        let slope = 1.0 + c * (kc * kc / b + 1.0 / d);
        ratio = AxisRatio::new((kc * libm::exp(excess / slope)).min(1.0))?;
    }
    Ok(best.1)
}
