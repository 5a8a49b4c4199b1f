//! Bodies: surface, material, inertia, position, attitude and motion.

use carom_geometry::{Attitude, Inertia, Placed, Surface};
use carom_halfspace::Material;
use carom_special::RangeError;
use nalgebra::Vector3;

use crate::mobility::Lever;
use crate::motion::Motion;

/// A body of a collision.
///
/// ```
/// use carom_geometry::{Attitude, Surface};
/// use carom_halfspace::Material;
/// use carom_impact::{Body, Motion};
/// let steel = Material::from_young(208e9, 0.3)?;
/// let ball = Body::sphere(0.01, steel, 0.0329)?
///     .moving(Motion::new([0.7, 0.0, -2.0], [0.0, 50.0, 0.0])?);
/// assert_eq!(ball.motion().velocity.z, -2.0);
/// let egg = Surface::ellipsoid([0.03, 0.02, 0.015])?;
/// let inertia = egg.solid(0.296)?;
/// let egg = Body::new(egg, steel, inertia)
///     .at([0.0, 0.0, 0.015])?
///     .turned(Attitude::from_angles(0.0, 0.0, 0.5)?);
/// assert_eq!(egg.placed().centre().z, 0.015);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Body {
    placed: Placed,
    material: Material,
    inertia: Inertia,
    motion: Motion,
}

impl Body {
    /// A body at rest at the origin, with its axes parallel to those of space.
    #[must_use]
    pub fn new(surface: Surface, material: Material, inertia: Inertia) -> Self {
        Self { placed: Placed::new(surface), material, inertia, motion: Motion::default() }
    }

    /// A solid sphere at rest.
    ///
    /// # Errors
    /// [`RangeError`] for a radius that is not finite and positive or a mass that is not positive.
    pub fn sphere(radius: f64, material: Material, mass: f64) -> Result<Self, RangeError> {
        let inertia = Inertia::solid_sphere(mass, radius)?;
        Ok(Self::new(Surface::sphere(radius)?, material, inertia))
    }

    /// A thin spherical shell at rest.
    ///
    /// # Errors
    /// As [`Body::sphere`].
    pub fn spherical_shell(radius: f64, material: Material, mass: f64) -> Result<Self, RangeError> {
        let inertia = Inertia::spherical_shell(mass, radius)?;
        Ok(Self::new(Surface::sphere(radius)?, material, inertia))
    }

    /// A plane that an impact does not move, with the half-space behind it. Its motion is given at
    /// the contact point.
    #[must_use]
    pub fn plane(material: Material) -> Self {
        Self::new(Surface::plane(), material, Inertia::FIXED)
    }

    /// The same body with its centre of mass at this point; for a plane, any of its points.
    ///
    /// # Errors
    /// [`RangeError`] if a component is not finite.
    pub fn at(self, centre: [f64; 3]) -> Result<Self, RangeError> {
        Ok(Self { placed: self.placed.at(centre)?, ..self })
    }

    /// The same body in this attitude.
    #[must_use]
    pub fn turned(self, attitude: Attitude) -> Self {
        Self { placed: self.placed.turned(attitude), ..self }
    }

    /// The same body with this inertia.
    #[must_use]
    pub fn with_inertia(self, inertia: Inertia) -> Self {
        Self { inertia, ..self }
    }

    /// The same body of this material.
    #[must_use]
    pub fn with_material(self, material: Material) -> Self {
        Self { material, ..self }
    }

    /// The same body with this motion.
    #[must_use]
    pub fn moving(self, motion: Motion) -> Self {
        Self { motion, ..self }
    }

    pub(crate) fn with_place(self, placed: Placed) -> Self {
        Self { placed, ..self }
    }

    /// Its surface with position and attitude.
    #[must_use]
    pub const fn placed(&self) -> &Placed {
        &self.placed
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

    /// Height of the contact point above the centre of mass along the normal, if the shape puts it
    /// on the normal through the centre: the radius of a sphere; 0 for a plane, whose motion is
    /// given at that point.
    pub(crate) fn height(&self) -> Option<f64> {
        let surface = self.placed.surface();
        surface.radius().or_else(|| surface.is_plane().then_some(0.0))
    }

    /// The resistance of the body to an impulse at the contact point, which lies `arm` from the centre, for
    /// the body on this side (-1 or 1) of the contact normal.
    pub(crate) fn lever(
        &self,
        arm: Vector3<f64>,
        normal: &Vector3<f64>,
        side: f64,
    ) -> Result<Lever, RangeError> {
        let attitude = self.placed.attitude();
        match self.height() {
            Some(height) => Ok(Lever::upright(self.inertia, attitude, normal, side * height)),
            None => Lever::new(self.inertia, attitude, arm),
        }
    }

    /// The kinetic energy of a motion of this body, translation and rotation. Infinite mass or
    /// moments count as zero, since an impact does not change the motion of such a body.
    #[must_use]
    pub fn kinetic_energy(&self, motion: &Motion) -> f64 {
        let part = |inertia: f64, squared: f64| {
            if inertia.is_finite() { 0.5 * inertia * squared } else { 0.0 }
        };
        let [a, b, c] = self.inertia.moments();
        // The moments refer to the body's axes; equal moments to all axes.
        let spin = match self.inertia.is_isotropic() {
            true => motion.spin,
            false => self.placed.attitude().to_body(&motion.spin),
        };
        part(self.inertia.mass(), motion.velocity.norm_squared())
            + part(a, spin.x * spin.x)
            + part(b, spin.y * spin.y)
            + part(c, spin.z * spin.z)
    }
}
