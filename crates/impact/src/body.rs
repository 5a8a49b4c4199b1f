//! Bodies: shape at the contact, material, inertia and motion.

use carom_geometry::Inertia;
use carom_halfspace::Material;
use carom_laws::curvature::PrincipalRadii;
use carom_special::RangeError;
use nalgebra::Vector3;

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
