//! The line contact of two cylinders with parallel axes: width, pressure, approach, stresses, rolling.

use carom_halfspace::{Material, MaterialPair, Stress, Traction};
use carom_special::RangeError;
use carom_table::Column;
use std::f64::consts::PI;

use crate::bounds::constant;

/// Two cylinders with parallel axes, or a cylinder and a plane, that touch along a length.
///
/// Per length the contact is plane: with the force per length q = F_z/L and the relative radius R, 1/R = 1/R_1 + 1/R_2,
/// the half width is a = 2 sqrt(q R/(pi E*)) and the greatest pressure 2 q/(pi a). The approach has no plane solution: it
/// grows with the logarithm of the length. Here both bodies are half-spaces loaded along L, and
/// zeta = 2 q/(pi E*) (ln(2 L/a) + 1/2) in the middle of the length, for a far below L (Lundberg 1939: 1.193 + ln(L/a)).
/// The shape of the bodies beyond the contact counts as much, and the ends of the length carry more: real rollers are
/// measured, or solved as whole bodies.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::line::LineContact;
/// let steel = Material::from_young(208e9, 0.3)?;
/// let roller = LineContact::new(5e-3, 20e-3, MaterialPair::new(steel, steel)?)?;
/// let state = roller.at_force(1e3)?;
/// // Force and pressure: F_z = (pi/2) a p_0 L.
/// let force = std::f64::consts::FRAC_PI_2 * state.half_width * state.peak_pressure * 20e-3;
/// assert!((force / 1e3 - 1.0).abs() < 1e-14);
/// // The greatest shear is .300 of the pressure, .786 half widths deep.
/// assert!((state.greatest_shear() / state.peak_pressure - 0.30028).abs() < 1e-5);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineContact {
    radius: f64,
    length: f64,
    materials: MaterialPair,
}

/// Half width over length up to which a contact is a line.
const SLENDER: f64 = 0.5;
/// Depth of the greatest shear over the half width: sqrt((sqrt 5 - 1)/2), where the derivative of
/// z - z^2/sqrt(1 + z^2) vanishes.
const DEEPEST: f64 = 0.786_151_377_757_423_3;
/// Greatest steps to the half width of an approach; Newton takes six.
const MOST_STEPS: usize = 60;

/// A line contact under load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineState {
    /// The normal force F_z.
    pub force: f64,
    /// The length.
    pub length: f64,
    /// Half of the width of the contact.
    pub half_width: f64,
    /// The approach of points far from the contact, of half-spaces loaded along the length.
    pub approach: f64,
    /// The greatest pressure 2 F_z/(pi a L).
    pub peak_pressure: f64,
    /// The tangent dF_z/dzeta = pi E* L/(2 ln(2 L/a)).
    pub normal_stiffness: f64,
}

impl LineContact {
    /// The quantities that do not depend on the load.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("relative_radius", "m", "1/R = 1/R_1 + 1/R_2", |line| line.radius.into()),
        Column::new("length", "m", "of the line", |line| line.length.into()),
    ];

    /// The contact of a relative radius and a length.
    ///
    /// # Errors
    /// [`RangeError`] unless both are positive, from 1e-60 to 1e60.
    pub fn new(radius: f64, length: f64, materials: MaterialPair) -> Result<Self, RangeError> {
        let checked = |field, value| constant(field, RangeError::positive(field, value)?);
        let (radius, length) = (checked("radius", radius)?, checked("length", length)?);
        Ok(Self { radius, length, materials })
    }

    /// The relative radius R.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// The length L.
    #[must_use]
    pub const fn length(&self) -> f64 {
        self.length
    }

    /// The materials of both bodies.
    #[must_use]
    pub const fn materials(&self) -> MaterialPair {
        self.materials
    }

    /// The contact under a given force.
    ///
    /// # Errors
    /// [`RangeError`] unless the force is finite and positive, and the half width at most half of the length.
    pub fn at_force(&self, force: f64) -> Result<LineState, RangeError> {
        let force = RangeError::positive("force", force)?;
        let modulus = self.materials.contact_modulus();
        self.state(2.0 * libm::sqrt(force / self.length * self.radius / (PI * modulus)))
    }

    /// The contact with a given half width.
    ///
    /// # Errors
    /// As [`LineContact::at_force`].
    pub fn at_half_width(&self, half_width: f64) -> Result<LineState, RangeError> {
        self.state(RangeError::positive("half_width", half_width)?)
    }

    /// The contact with a given greatest pressure, E* a/(2 R).
    ///
    /// # Errors
    /// As [`LineContact::at_force`].
    pub fn at_peak_pressure(&self, peak_pressure: f64) -> Result<LineState, RangeError> {
        let peak = RangeError::positive("peak_pressure", peak_pressure)?;
        self.state(2.0 * self.radius * peak / self.materials.contact_modulus())
    }

    /// The contact at a given approach.
    ///
    /// # Errors
    /// As [`LineContact::at_force`].
    pub fn at_approach(&self, approach: f64) -> Result<LineState, RangeError> {
        let approach = RangeError::positive("approach", approach)?;
        let most = self.approach(SLENDER * self.length);
        RangeError::check("approach", approach, approach <= most, ALLOWED)?;
        // The approach is convex in ln a, so that Newton's steps in ln a stay on one side after the first.
        let mut width = SLENDER * self.length;
        for _ in 0..MOST_STEPS {
            let slope = width * width / self.radius * libm::log(2.0 * self.length / width);
            let step = (self.approach(width) - approach) / slope;
            width *= libm::exp(-step.min(2.0));
            if step.abs() < 1e-15 {
                break;
            }
        }
        self.state(width.min(SLENDER * self.length))
    }

    /// The approach with a half width a: a^2/(2 R) (ln(2 L/a) + 1/2).
    fn approach(&self, width: f64) -> f64 {
        0.5 * width * width / self.radius * (libm::log(2.0 * self.length / width) + 0.5)
    }

    fn state(&self, half_width: f64) -> Result<LineState, RangeError> {
        let fits = half_width <= SLENDER * self.length;
        RangeError::check("half_width", half_width, fits, ALLOWED)?;
        let Self { radius, length, materials } = *self;
        let modulus = materials.contact_modulus();
        let peak_pressure = 0.5 * modulus * half_width / radius;
        let force = 0.5 * PI * half_width * peak_pressure * length;
        let normal_stiffness = 0.5 * PI * modulus * length / libm::log(2.0 * length / half_width);
        RangeError::positive("force", force)?;
        RangeError::finite("force", force)?;
        let approach = self.approach(half_width);
        Ok(LineState { force, length, half_width, approach, peak_pressure, normal_stiffness })
    }

    /// The tangential force of steady rolling over f F_z at a creepage along the direction of rolling (Carter 1926), for
    /// bodies of equal elastic constants: 1 - (1 - |c| R/(f a))^2, with the sign of the creepage; 1 from
    /// |c| = f a/R on.
    ///
    /// ```
    /// # use carom_halfspace::{Material, MaterialPair};
    /// # use carom_laws::line::LineContact;
    /// # let steel = Material::from_young(208e9, 0.3)?;
    /// let roller = LineContact::new(5e-3, 20e-3, MaterialPair::new(steel, steel)?)?;
    /// let state = roller.at_force(1e3)?;
    /// let whole = 0.3 * state.half_width / 5e-3;
    /// assert_eq!(roller.carter(&state, 0.3, whole)?, 1.0);
    /// assert!((roller.carter(&state, 0.3, -0.5 * whole)? + 0.75).abs() < 1e-15);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] unless friction is finite and positive and the creepage finite.
    pub fn carter(
        &self,
        state: &LineState,
        friction: f64,
        creepage: f64,
    ) -> Result<f64, RangeError> {
        let friction = RangeError::positive("friction", friction)?;
        let creepage = RangeError::finite("creepage", creepage)?;
        let part = (creepage.abs() * self.radius / (friction * state.half_width)).min(1.0);
        Ok((part * (2.0 - part)).copysign(creepage))
    }
}

const ALLOWED: &str =
    "such that the contact is at most as wide as long; give a grid to `carom solve`";

impl LineState {
    /// The quantities of a loaded contact, in SI units.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("force", "N", "normal force F_z", |state| state.force.into()),
        Column::new("force_per_length", "N/m", "F_z over the length", |state| {
            (state.force / state.length).into()
        }),
        Column::new("approach", "m", "of half-spaces loaded along the length, zeta", |state| {
            state.approach.into()
        }),
        Column::new("half_width", "m", "of the contact", |state| state.half_width.into()),
        Column::new("peak_pressure", "Pa", "in the middle of the contact", |state| {
            state.peak_pressure.into()
        }),
        Column::new("normal_stiffness", "N/m", "tangent dF_z/dzeta", |state| {
            state.normal_stiffness.into()
        }),
        Column::new(
            "greatest_shear",
            "Pa",
            "below the middle, in the plane across the axes",
            |state| state.greatest_shear().into(),
        ),
        Column::new("greatest_shear_depth", "m", "where it is", |state| {
            state.greatest_shear_depth().into()
        }),
    ];

    /// The pressure at a distance x from the middle line.
    #[must_use]
    pub fn pressure(&self, x: f64) -> f64 {
        let part = x / self.half_width;
        self.peak_pressure * libm::sqrt((1.0 - part * part).max(0.0))
    }

    /// The greatest shear stress in the plane across the axes, .30028 of the greatest pressure.
    #[must_use]
    pub fn greatest_shear(&self) -> f64 {
        self.peak_pressure * (DEEPEST - DEEPEST * DEEPEST / libm::sqrt(1.0 + DEEPEST * DEEPEST))
    }

    /// Its depth, .78615 half widths.
    #[must_use]
    pub fn greatest_shear_depth(&self) -> f64 {
        DEEPEST * self.half_width
    }
}

/// The stress in a body under a line contact in partial slip (McEwen; Cattaneo's strip): Hertz's pressure, and the
/// traction of complete sliding minus that of the stick strip. Strain along the axes is zero.
///
/// `peak` holds the greatest pressure and f times it in the direction of slip, `stick_width` is the width of the strip that
/// sticks over that of the contact, sqrt(1 - F_t/(f F_z)); x is across the axes, z the depth.
///
/// ```
/// use carom_halfspace::{Material, Traction};
/// use carom_laws::line::line_stress;
/// let steel = Material::from_young(208e3, 0.3)?;
/// let peak = Traction { x: 0.3, y: 0.0, normal: 1.0 };
/// let stress = line_stress(2.0, steel, peak, 0.5, [0.0, 0.0])?;
/// // On the surface the stress is the traction, and xx the pressure.
/// assert!((stress.zx + 0.3 * 0.5).abs() < 1e-15 && (stress.xx + 1.0).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] for a half width that is not positive, a stick width outside 0 to 1, a depth below 0, or a value that
/// is not finite.
pub fn line_stress(
    half_width: f64,
    body: Material,
    peak: Traction,
    stick_width: f64,
    [x, z]: [f64; 2],
) -> Result<Stress, RangeError> {
    let width = RangeError::positive("half_width", half_width)?;
    let holds = (0.0..=1.0).contains(&stick_width);
    RangeError::check("stick_width", stick_width, holds, "from 0 to 1")?;
    RangeError::finite("x", x)?;
    RangeError::non_negative("z", z)?;
    for (name, value) in [("traction x", peak.x), ("traction y", peak.y), ("pressure", peak.normal)]
    {
        RangeError::finite(name, value)?;
    }
    let place = |width: f64| Place::new(x / width, z / width);
    let own = place(width);
    let mut stress =
        own.pressed() * peak.normal + own.pulled() * peak.x + own.pulled_across() * peak.y;
    if stick_width > 0.0 {
        let kept = place(stick_width * width);
        stress = stress
            + kept.pulled() * (-stick_width * peak.x)
            + kept.pulled_across() * (-stick_width * peak.y);
    }
    stress.yy = body.poisson() * (stress.xx + stress.zz);
    Ok(stress)
}

/// A place below a strip of half width 1, by m - i n = sqrt(1 - (x + i z)^2).
#[derive(Debug, Clone, Copy)]
struct Place {
    x: f64,
    z: f64,
    m: f64,
    n: f64,
}

impl Place {
    fn new(x: f64, z: f64) -> Self {
        // (1 - x^2 + z^2) and its modulus; of the two roots the larger one directly, the other by m n = x z.
        let real = (1.0 - x) * (1.0 + x) + z * z;
        let modulus = libm::hypot(real, 2.0 * x * z);
        let [m, n] = match real >= 0.0 {
            true => {
                let m = libm::sqrt(0.5 * (modulus + real));
                [m, if m > 0.0 { x * z / m } else { 0.0 }]
            }
            false => {
                let n = libm::sqrt(0.5 * (modulus - real)).copysign(x);
                [x * z / n, n]
            }
        };
        Self { x, z, m, n }
    }

    /// Under the pressure sqrt(1 - x^2).
    fn pressed(self) -> Stress {
        let Self { z, m, n, .. } = self;
        let square = m * m + n * n;
        // The edge of the strip.
        if square == 0.0 {
            return Stress::default();
        }
        let part = (z * z + n * n) / square;
        Stress {
            xx: -(m * (1.0 + part) - 2.0 * z),
            zz: -m * (1.0 - part),
            zx: -n * (m * m - z * z) / square,
            ..Stress::default()
        }
    }

    /// Under a traction along x of the same form.
    fn pulled(self) -> Stress {
        let Self { x, z, m, n } = self;
        let square = m * m + n * n;
        let pressed = self.pressed();
        let xx = match square == 0.0 {
            true => -2.0 * x,
            false => n * (2.0 - (z * z - m * m) / square) - 2.0 * x,
        };
        Stress { xx, zz: pressed.zx, zx: pressed.xx, ..Stress::default() }
    }

    /// Under a traction along the axes of the same form.
    fn pulled_across(self) -> Stress {
        let Self { x, z, m, n } = self;
        Stress { xy: n - x, yz: z - m, ..Stress::default() }
    }
}
