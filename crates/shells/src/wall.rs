//! The wall of a thin shell.

use carom_special::RangeError;

/// The wall of a thin isotropic shell: Young's modulus E, Poisson's ratio nu, thickness t.
///
/// ```
/// use carom_shells::Wall;
/// let wall = Wall::new(2e11, 0.3, 1e-3)?;
/// assert!((wall.stretching_stiffness() - 2e8 / 0.91).abs() < 1.0);
/// assert!(Wall::new(2e11, 0.3, 0.0).is_err());
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wall {
    young_modulus: f64,
    poisson: f64,
    thickness: f64,
}

impl Wall {
    /// A wall of Young's modulus `young_modulus` > 0, Poisson's ratio `poisson` in [0, 0.5] and
    /// `thickness` > 0.
    ///
    /// # Errors
    /// [`RangeError`] for a value out of range.
    pub fn new(young_modulus: f64, poisson: f64, thickness: f64) -> Result<Self, RangeError> {
        let young_modulus = RangeError::positive("young_modulus", young_modulus)?;
        let fits = (0.0..=0.5).contains(&poisson);
        let poisson = RangeError::check("poisson", poisson, fits, "from 0 to 0.5")?;
        let thickness = RangeError::positive("thickness", thickness)?;
        let wall = Self { young_modulus, poisson, thickness };
        for (field, value) in
            [("E t", young_modulus * thickness), ("E t^3", wall.bending_stiffness())]
        {
            RangeError::check(field, value, value.is_normal(), "representable as a number")?;
        }
        Ok(wall)
    }

    /// Young's modulus E.
    #[must_use]
    pub const fn young_modulus(&self) -> f64 {
        self.young_modulus
    }

    /// Poisson's ratio nu.
    #[must_use]
    pub const fn poisson(&self) -> f64 {
        self.poisson
    }

    /// Thickness t.
    #[must_use]
    pub const fn thickness(&self) -> f64 {
        self.thickness
    }

    /// Shear modulus G = E/(2(1 + nu)).
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        0.5 * self.young_modulus / (1.0 + self.poisson)
    }

    /// Stretching stiffness C = E t/(1 - nu^2), force per length.
    #[must_use]
    pub fn stretching_stiffness(&self) -> f64 {
        self.young_modulus * self.thickness / (1.0 - self.poisson * self.poisson)
    }

    /// Bending stiffness D = E t^3/(12(1 - nu^2)), moment per length and curvature.
    #[must_use]
    pub fn bending_stiffness(&self) -> f64 {
        self.stretching_stiffness() * self.thickness * self.thickness / 12.0
    }
}
