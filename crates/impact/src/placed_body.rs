//! A body of any smooth shape: surface, material, inertia, place, attitude and motion.

use carom_geometry::{Attitude, Inertia, Placed, Surface};
use carom_halfspace::Material;
use carom_special::RangeError;
use nalgebra::Vector3;

use crate::body::{Motion, kinetic_energy};
use crate::mobility::Lever;

/// A body with its surface, place, attitude and motion.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{Attitude, Motion, PlacedBody, Surface};
/// let steel = Material::from_shear(80e9, 0.3)?;
/// let egg = Surface::ellipsoid([0.03, 0.02, 0.015])?;
/// let inertia = egg.solid(0.296)?;
/// let body = PlacedBody::new(egg, steel, inertia)
///     .at([0.0, 0.0, 0.015])?
///     .turned(Attitude::from_angles(0.0, 0.0, 0.5)?)
///     .moving(Motion::new([0.6, 0.4, -2.0], [0.0; 3])?);
/// assert_eq!(body.centre().z, 0.015);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct PlacedBody {
    pub(crate) placed: Placed,
    pub(crate) material: Material,
    pub(crate) inertia: Inertia,
    pub(crate) motion: Motion,
}

impl PlacedBody {
    /// A body at rest at the origin, its axes along those of space.
    #[must_use]
    pub fn new(surface: Surface, material: Material, inertia: Inertia) -> Self {
        Self { placed: Placed::new(surface), material, inertia, motion: Motion::default() }
    }

    /// A plane through the origin, held fast, with the half-space z < 0 behind it.
    #[must_use]
    pub fn plane(material: Material) -> Self {
        Self::new(Surface::plane(), material, Inertia::FIXED)
    }

    /// The same body with its centre of mass there; for a plane, any of its points.
    ///
    /// # Errors
    /// [`RangeError`] unless the components are finite.
    pub fn at(self, centre: [f64; 3]) -> Result<Self, RangeError> {
        Ok(Self { placed: self.placed.at(centre)?, ..self })
    }

    /// The same body in this attitude.
    #[must_use]
    pub fn turned(self, attitude: Attitude) -> Self {
        Self { placed: self.placed.turned(attitude), ..self }
    }

    /// The same body with this motion, in space axes.
    #[must_use]
    pub fn moving(self, motion: Motion) -> Self {
        Self { motion, ..self }
    }

    /// Its surface, in its own axes.
    #[must_use]
    pub const fn surface(&self) -> &Surface {
        self.placed.surface()
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

    /// Its centre of mass.
    #[must_use]
    pub const fn centre(&self) -> Vector3<f64> {
        self.placed.centre()
    }

    /// Its attitude.
    #[must_use]
    pub const fn attitude(&self) -> Attitude {
        *self.placed.attitude()
    }

    /// Its motion.
    #[must_use]
    pub const fn motion(&self) -> Motion {
        self.motion
    }

    /// What resists an impulse at the contact point, `arm` from the centre, on this side of it
    /// (-1 or 1) along the contact normal.
    pub(crate) fn lever(
        &self,
        arm: Vector3<f64>,
        normal: &Vector3<f64>,
        side: f64,
    ) -> Result<Lever, RangeError> {
        let attitude = self.placed.attitude();
        // The motion of a plane is given at the contact point.
        let flat = self.surface().is_plane().then_some(0.0);
        match flat.or(self.surface().radius()) {
            Some(height) => Ok(Lever::upright(self.inertia, attitude, normal, side * height)),
            None => Lever::new(self.inertia, attitude, arm),
        }
    }

    pub(crate) fn kinetic_energy(&self, motion: &Motion) -> f64 {
        // The moments belong to the body's axes.
        let spin = self.placed.attitude().to_body(&motion.spin);
        kinetic_energy(&self.inertia, &Motion { velocity: motion.velocity, spin })
    }
}
