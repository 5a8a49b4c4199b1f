//! The contact ellipse (5.9): semi-axis a along x, b along y; either may be the larger.

use carom_special::{AxisRatio, RangeError};

/// An ellipse `(x/a)^2 + (y/b)^2 <= 1`.
///
/// ```
/// use carom_laws::ellipse::ContactEllipse;
/// let ellipse = ContactEllipse::new(1.0, 2.0)?;
/// assert!(ellipse.contains(0.5, 1.5));
/// assert_eq!(ellipse.axis_ratio().get(), 0.5);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactEllipse {
    a: f64,
    b: f64,
    ratio: AxisRatio,
}

impl ContactEllipse {
    /// The ellipse with semi-axes a along x and b along y.
    ///
    /// # Errors
    /// [`RangeError`] unless both and their ratio are finite and positive.
    pub fn new(semi_axis_a: f64, semi_axis_b: f64) -> Result<Self, RangeError> {
        let a = RangeError::positive("semi_axis_a", semi_axis_a)?;
        let b = RangeError::positive("semi_axis_b", semi_axis_b)?;
        Ok(Self { a, b, ratio: AxisRatio::new(a / b)? })
    }

    /// The circle of the given radius.
    ///
    /// # Errors
    /// [`RangeError`] unless the radius is finite and positive.
    pub fn circle(radius: f64) -> Result<Self, RangeError> {
        Self::new(radius, radius)
    }

    /// The semi-axis a along x.
    #[must_use]
    pub const fn semi_axis_a(&self) -> f64 {
        self.a
    }

    /// The semi-axis b along y.
    #[must_use]
    pub const fn semi_axis_b(&self) -> f64 {
        self.b
    }

    /// The axis ratio k' = a/b.
    #[must_use]
    pub const fn axis_ratio(&self) -> AxisRatio {
        self.ratio
    }

    /// The area pi a b.
    #[must_use]
    pub fn area(&self) -> f64 {
        std::f64::consts::PI * self.a * self.b
    }

    /// The greatest pressure 3 F_z/(2 pi a b) (5.11) under this normal force; 0 where bodies only graze.
    #[must_use]
    pub fn peak_pressure(&self, force: f64) -> f64 {
        let area = self.area();
        if area > 0.0 { 1.5 * force / area } else { 0.0 }
    }

    /// `(x/a)^2 + (y/b)^2`, the square of the elliptical radius: 1 on the edge.
    #[must_use]
    pub fn radius_squared(&self, x: f64, y: f64) -> f64 {
        let (u, v) = (x / self.a, y / self.b);
        u * u + v * v
    }

    /// Whether the point lies inside or on the edge.
    #[must_use]
    pub fn contains(&self, x: f64, y: f64) -> bool {
        self.radius_squared(x, y) <= 1.0
    }

    /// The ellipse with both semi-axes multiplied by `factor`; the stick area is such an ellipse.
    ///
    /// # Errors
    /// [`RangeError`] unless the scaled semi-axes are finite and positive.
    pub fn scaled(&self, factor: f64) -> Result<Self, RangeError> {
        Self::new(self.a * factor, self.b * factor)
    }

    /// The same ellipse with x and y exchanged.
    #[must_use]
    pub fn exchanged(&self) -> Self {
        Self { a: self.b, b: self.a, ratio: self.ratio.inverse() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn either_order_of_the_axes_is_kept() {
        let ellipse = ContactEllipse::new(3.0, 1.0).unwrap();
        assert_eq!(ellipse.axis_ratio().get(), 3.0);
        assert!(ellipse.axis_ratio().parameter() < 0.0);
        assert_eq!(ellipse.exchanged(), ContactEllipse::new(1.0, 3.0).unwrap());
        assert!(ellipse.contains(2.9, 0.0) && !ellipse.contains(0.0, 1.1));
        assert_eq!(ContactEllipse::new(0.0, 1.0).unwrap_err().field, "semi_axis_a");
        assert_eq!(ContactEllipse::new(1.0, f64::NAN).unwrap_err().field, "semi_axis_b");
    }
}
