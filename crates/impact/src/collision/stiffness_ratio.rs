//! A measured ratio of normal to tangential stiffness in the place of that of the materials.

use carom_laws::stiffness::ContactStiffness;
use carom_special::RangeError;

use super::Collision;

impl Collision {
    /// The same collision with this ratio kappa of normal to tangential stiffness, c_z/c_x, in both tangential directions,
    /// instead of that of the materials (15.1): for surfaces of which it was measured. The analytic laws have it.
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// use carom_impact::{Body, Collision, Motion};
    /// use carom_impact::restitution::of_spheres;
    /// use carom_laws::friction::Friction;
    /// let glass = Material::from_young(70e9, 0.22)?;
    /// let ball = Body::sphere(1.5e-3, glass, 3.5e-5)?.moving(Motion::new([0.3, 0.0, -1.0], [0.0; 3])?);
    /// let collision = Collision::new(ball, Body::plane(glass), Friction::new(0.1)?)?;
    /// let outcome = collision.with_stiffness_ratio(1.3)?.solve()?;
    /// let r_x = outcome.rebound().and_then(|rebound| rebound.r_x).ok_or("they meet")?;
    /// assert!((r_x - of_spheres(1.3, 3.0)?).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] unless it is from 1e-3 to 1e3.
    pub fn with_stiffness_ratio(self, ratio: f64) -> Result<Self, RangeError> {
        let holds = (1e-3..=1e3).contains(&ratio);
        let field = "normal_over_tangential_stiffness";
        RangeError::check(field, ratio, holds, "from 1e-3 to 1e3")?;
        Ok(Self { stiffness_ratio: Some(ratio), ..self })
    }

    /// The stiffness of the contact: that of the bodies, with the ratio that was given.
    pub(crate) fn stiffness(&self) -> ContactStiffness {
        let own = self.hertz.stiffness();
        let across = self.stiffness_ratio.map(|ratio| own.c_z / ratio);
        let [c_x, c_y] = [own.c_x, own.c_y].map(|c| across.unwrap_or(c));
        ContactStiffness { c_x, c_y, c_z: own.c_z }
    }

    /// Checks that the stiffness is that of the materials, for laws that have no other.
    ///
    /// # Errors
    /// [`RangeError`] if its ratio was given.
    pub fn refuse_stiffness_ratio(&self) -> Result<(), RangeError> {
        let field = "normal_over_tangential_stiffness";
        let allowed = "that of the materials with this law";
        self.stiffness_ratio.map_or(Ok(()), |ratio| Err(RangeError::new(field, ratio, allowed)))
    }
}
