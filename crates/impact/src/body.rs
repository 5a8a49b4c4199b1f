//! Bodies: shape at the contact, material, inertia and motion.

use carom_halfspace::Material;
use carom_laws::curvature::PrincipalRadii;
use carom_special::RangeError;
use nalgebra::Vector3;

/// Mass and principal moments of inertia; infinite ones hold the body fast.
///
/// ```
/// use carom_impact::Inertia;
/// let ball = Inertia::solid_sphere(0.2, 0.05)?;
/// assert!((ball.moments()[0] - 0.4 * 0.2 * 0.05 * 0.05).abs() < 1e-18);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inertia {
    mass: f64,
    moments: [f64; 3],
}

impl Inertia {
    /// A body that nothing moves.
    pub const FIXED: Self = Self { mass: f64::INFINITY, moments: [f64::INFINITY; 3] };

    /// From mass and principal moments; infinite values are allowed.
    ///
    /// # Errors
    /// [`RangeError`] unless the mass and all moments are positive and the moments satisfy the
    /// triangle inequality that every mass distribution obeys.
    pub fn new(mass: f64, moments: [f64; 3]) -> Result<Self, RangeError> {
        RangeError::check("mass", mass, mass > 0.0, "> 0 (inf: held fast)")?;
        for moment in moments {
            RangeError::check("moment of inertia", moment, moment > 0.0, "> 0 (inf: held fast)")?;
        }
        let [a, b, c] = moments;
        let slack = 1.0 + 1e-12;
        for (one, sum) in [(a, b + c), (b, c + a), (c, a + b)] {
            let holds = one <= slack * sum;
            RangeError::check("moment of inertia", one, holds, "<= the sum of the other two")?;
        }
        Ok(Self { mass, moments })
    }

    /// A homogeneous solid sphere, theta = (2/5) m R^2.
    ///
    /// # Errors
    /// [`RangeError`] unless mass > 0 (infinity allowed) and radius is finite and positive.
    pub fn solid_sphere(mass: f64, radius: f64) -> Result<Self, RangeError> {
        Self::of_gyration(mass, radius, 0.4)
    }

    /// A thin spherical shell, theta = (2/3) m R^2.
    ///
    /// # Errors
    /// As [`Inertia::solid_sphere`].
    pub fn spherical_shell(mass: f64, radius: f64) -> Result<Self, RangeError> {
        Self::of_gyration(mass, radius, 2.0 / 3.0)
    }

    fn of_gyration(mass: f64, radius: f64, share: f64) -> Result<Self, RangeError> {
        RangeError::positive("radius", radius)?;
        Self::new(mass, [share * mass * radius * radius; 3])
    }

    /// The mass; infinite if nothing moves the body's centre.
    #[must_use]
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// The principal moments of inertia.
    #[must_use]
    pub const fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// Whether the moments are the same about all axes.
    pub(crate) fn is_isotropic(&self) -> bool {
        let [a, b, c] = self.moments;
        a == b && b == c
    }

    /// 1/m, zero for an infinite mass.
    #[must_use]
    pub fn inverse_mass(&self) -> f64 {
        1.0 / self.mass
    }

    /// theta^-1 in principal axes, zeros for infinite moments.
    #[must_use]
    pub fn inverse_moments(&self) -> Vector3<f64> {
        Vector3::from(self.moments).map(|moment| 1.0 / moment)
    }
}

/// Largest component of a velocity or spin: beyond it energies overflow.
const FASTEST: f64 = 1e100;

/// Velocity of the centre of mass and spin, in the frame of the impact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    /// Velocity of the centre of mass.
    pub velocity: Vector3<f64>,
    /// Angular velocity, radians per time.
    pub spin: Vector3<f64>,
}

impl Motion {
    /// From velocity and spin.
    ///
    /// # Errors
    /// [`RangeError`] that names the first component not within +-1e100.
    pub fn new(velocity: [f64; 3], spin: [f64; 3]) -> Result<Self, RangeError> {
        let check = |field, value: f64| {
            RangeError::check(field, value, value.abs() <= FASTEST, "within +-1e100")
        };
        for value in velocity {
            check("velocity", value)?;
        }
        for value in spin {
            check("spin", value)?;
        }
        Ok(Self { velocity: velocity.into(), spin: spin.into() })
    }
}

/// The shape of a body at the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// A sphere of this radius.
    Sphere(f64),
    /// A plane; its motion is given at the contact point.
    Plane,
}

impl Shape {
    /// The principal radii of curvature at the contact.
    ///
    /// # Errors
    /// [`RangeError`] unless a sphere's radius is finite and positive.
    pub fn radii(self) -> Result<PrincipalRadii, RangeError> {
        match self {
            Self::Sphere(radius) => PrincipalRadii::sphere(radius),
            Self::Plane => Ok(PrincipalRadii::PLANE),
        }
    }

    /// Distance from the centre of mass to the contact point.
    #[must_use]
    pub fn arm(self) -> f64 {
        match self {
            Self::Sphere(radius) => radius,
            Self::Plane => 0.0,
        }
    }
}

/// A body about to collide.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{Body, Motion};
/// let steel = Material::from_young(208e9, 0.3)?;
/// let ball = Body::sphere(0.01, steel, 0.0329)?
///     .moving(Motion::new([0.7, 0.0, -2.0], [0.0, 50.0, 0.0])?);
/// assert_eq!(ball.motion().velocity.z, -2.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    shape: Shape,
    material: Material,
    inertia: Inertia,
    motion: Motion,
}

impl Body {
    /// A solid sphere at rest.
    ///
    /// # Errors
    /// [`RangeError`] for a radius that is not finite and positive or a mass that is not positive.
    pub fn sphere(radius: f64, material: Material, mass: f64) -> Result<Self, RangeError> {
        let inertia = Inertia::solid_sphere(mass, radius)?;
        Ok(Self { shape: Shape::Sphere(radius), material, inertia, motion: Motion::default() })
    }

    /// A plane held fast.
    #[must_use]
    pub fn plane(material: Material) -> Self {
        Self { shape: Shape::Plane, material, inertia: Inertia::FIXED, motion: Motion::default() }
    }

    /// The same body with this inertia.
    #[must_use]
    pub fn with_inertia(self, inertia: Inertia) -> Self {
        Self { inertia, ..self }
    }

    /// The same body with this motion.
    #[must_use]
    pub fn moving(self, motion: Motion) -> Self {
        Self { motion, ..self }
    }

    /// Its shape.
    #[must_use]
    pub const fn shape(&self) -> Shape {
        self.shape
    }

    /// Its material.
    #[must_use]
    pub const fn material(&self) -> Material {
        self.material
    }

    /// Its inertia.
    #[must_use]
    pub const fn inertia(&self) -> Inertia {
        self.inertia
    }

    /// Its motion.
    #[must_use]
    pub const fn motion(&self) -> Motion {
        self.motion
    }
}

/// The kinetic energy of a motion, translation and rotation; infinite parts count as zero, since
/// a body held fast does not change its energy.
#[must_use]
pub fn kinetic_energy(inertia: &Inertia, motion: &Motion) -> f64 {
    let part = |inertia: f64, squared: f64| {
        if inertia.is_finite() { 0.5 * inertia * squared } else { 0.0 }
    };
    let [a, b, c] = inertia.moments();
    let spin = motion.spin;
    part(inertia.mass(), motion.velocity.norm_squared())
        + part(a, spin.x * spin.x)
        + part(b, spin.y * spin.y)
        + part(c, spin.z * spin.z)
}
