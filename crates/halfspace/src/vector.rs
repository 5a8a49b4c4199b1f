//! Points, loads and displacements in the axes of the half-space (z into the body).

use std::ops::{Add, Mul};

use carom_special::RangeError;

/// A point of the half-space; `z >= 0` is the depth below the surface.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Point {
    /// Coordinate along the surface.
    pub x: f64,
    /// Coordinate along the surface.
    pub y: f64,
    /// Depth below the surface, >= 0.
    pub z: f64,
}

impl Point {
    /// A point of the surface z = 0.
    #[must_use]
    pub const fn on_surface(x: f64, y: f64) -> Self {
        Self { x, y, z: 0.0 }
    }

    /// The point, if it lies in the half-space.
    pub(crate) fn checked(self) -> Result<Self, RangeError> {
        RangeError::finite("x", self.x)?;
        RangeError::finite("y", self.y)?;
        RangeError::non_negative("z", self.z)?;
        Ok(self)
    }
}

/// A force on the surface of the body; a positive `z` presses into it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Force {
    /// Tangential component F_x.
    pub x: f64,
    /// Tangential component F_y.
    pub y: f64,
    /// Normal component F_z, positive into the body.
    pub z: f64,
}

impl Force {
    pub(crate) fn checked(self) -> Result<Self, RangeError> {
        RangeError::finite("F_x", self.x)?;
        RangeError::finite("F_y", self.y)?;
        RangeError::finite("F_z", self.z)?;
        Ok(self)
    }
}

/// A traction (force/area) that acts on the surface of the body.
///
/// `x` and `y` are components along the axes, `normal` is the pressure p_z, positive in
/// compression. As components of the stress tensor at z = 0 these are -sigma_zx, -sigma_zy and
/// -sigma_zz.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Traction {
    /// Tangential traction along x.
    pub x: f64,
    /// Tangential traction along y.
    pub y: f64,
    /// Pressure p_z.
    pub normal: f64,
}

impl Traction {
    pub(crate) fn checked(self) -> Result<Self, RangeError> {
        RangeError::finite("traction x", self.x)?;
        RangeError::finite("traction y", self.y)?;
        RangeError::finite("pressure", self.normal)?;
        Ok(self)
    }
}

/// A displacement; `w` is positive into the body.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Displacement {
    /// Component along x.
    pub u: f64,
    /// Component along y.
    pub v: f64,
    /// Component along z, into the body.
    pub w: f64,
}

impl Displacement {
    /// The displacement, if it is finite; otherwise the point is too close to a singularity.
    pub(crate) fn finite_at(self, field: &'static str, at: f64) -> Result<Self, RangeError> {
        let finite = self.u.is_finite() && self.v.is_finite() && self.w.is_finite();
        RangeError::check(field, at, finite, "where the displacement is finite").map(|_| self)
    }
}

impl Add for Displacement {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { u: self.u + other.u, v: self.v + other.v, w: self.w + other.w }
    }
}

impl Mul<f64> for Displacement {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self { u: self.u * factor, v: self.v * factor, w: self.w * factor }
    }
}
