//! Forces on a ring.

use std::f64::consts::PI;

use carom_special::RangeError;

/// A force at one place of the ring. Components not set are zero.
///
/// ```
/// use carom_shells::flange::RingForce;
/// // A bolt pulls the flange with 20 kN along x, 40 mm outside its centroid line.
/// let bolt = RingForce::at(0.25)?.axial_at(2e4, 0.04)?;
/// assert_eq!(bolt.couple(), -800.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingForce {
    angle: f64,
    /// Conjugate to w, v, u, beta.
    components: [f64; 4],
}

impl RingForce {
    /// No force yet, at an angle in radians.
    ///
    /// # Errors
    /// [`RangeError`] unless the angle is from -1000 to 1000.
    pub fn at(angle: f64) -> Result<Self, RangeError> {
        let fits = angle.abs() <= 1000.0;
        RangeError::check("angle", angle, fits, "from -1000 to 1000")?;
        Ok(Self { angle, components: [0.0; 4] })
    }

    /// With a force outward.
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite.
    pub fn radial(self, force: f64) -> Result<Self, RangeError> {
        self.with("radial", 0, force)
    }

    /// With a force along phi.
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite.
    pub fn tangential(self, force: f64) -> Result<Self, RangeError> {
        self.with("tangential", 1, force)
    }

    /// With a force along x, on the centroid line.
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite.
    pub fn axial(self, force: f64) -> Result<Self, RangeError> {
        self.with("axial", 2, force)
    }

    /// With a force along x on the circle `arm` outside the centroid line: the force, and its couple
    /// - force * arm on beta.
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite.
    pub fn axial_at(self, force: f64, arm: f64) -> Result<Self, RangeError> {
        RangeError::finite("arm", arm)?;
        self.axial(force)?.with("couple", 3, -force * arm)
    }

    fn with(
        mut self,
        field: &'static str,
        component: usize,
        force: f64,
    ) -> Result<Self, RangeError> {
        self.components[component] = RangeError::finite(field, force)?;
        Ok(self)
    }

    /// Two forces outward at the angles 0 and pi.
    ///
    /// # Errors
    /// [`RangeError`] unless the force is finite.
    pub fn pinch(force: f64) -> Result<[Self; 2], RangeError> {
        Ok([Self::at(0.0)?.radial(force)?, Self::at(PI)?.radial(force)?])
    }

    /// Two forces along x at the angles 0 and pi.
    ///
    /// # Errors
    /// [`RangeError`] unless the force is finite.
    pub fn pry(force: f64) -> Result<[Self; 2], RangeError> {
        Ok([Self::at(0.0)?.axial(force)?, Self::at(PI)?.axial(force)?])
    }

    /// Where it acts.
    #[must_use]
    pub const fn angle(&self) -> f64 {
        self.angle
    }

    /// The couple on beta.
    #[must_use]
    pub const fn couple(&self) -> f64 {
        self.components[3]
    }

    /// The force outward.
    #[must_use]
    pub const fn outward(&self) -> f64 {
        self.components[0]
    }

    /// The force along phi.
    #[must_use]
    pub const fn along_ring(&self) -> f64 {
        self.components[1]
    }

    /// The force along x.
    #[must_use]
    pub const fn along_tube(&self) -> f64 {
        self.components[2]
    }

    /// Components on (w, v, u, beta).
    pub(super) const fn components(&self) -> [f64; 4] {
        self.components
    }
}
