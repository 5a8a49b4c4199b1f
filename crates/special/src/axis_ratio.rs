//! The axis ratio a/b of an ellipse, the argument of all elliptic integrals of carom.

use crate::RangeError;

/// The ratio `k' = a/b` of the semi-axes of an ellipse, any finite positive number.
///
/// Using `k'` instead of the modulus `k = sqrt(1 - k'^2)` keeps full accuracy for nearly circular
/// and for very slender ellipses. `k' > 1` (parameter `m < 0`) is valid everywhere.
///
/// ```
/// use carom_special::AxisRatio;
/// let ratio = AxisRatio::new(0.5)?;
/// assert_eq!(ratio.parameter(), 0.75);
/// assert_eq!(ratio.inverse().get(), 2.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct AxisRatio(f64);

impl AxisRatio {
    /// The circle, a = b.
    pub const CIRCLE: Self = Self(1.0);

    /// From the ratio a/b.
    ///
    /// # Errors
    /// [`RangeError`] unless `ratio` is finite and positive.
    pub fn new(ratio: f64) -> Result<Self, RangeError> {
        RangeError::positive("axis_ratio", ratio).map(Self)
    }

    /// The axis ratio for a modulus `k = sqrt(1 - (a/b)^2)`.
    ///
    /// # Errors
    /// [`RangeError`] unless `modulus` is at least 0 and below 1.
    ///
    /// ```
    /// use carom_special::AxisRatio;
    /// assert_eq!(AxisRatio::from_modulus(0.6)?.get(), 0.8);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    pub fn from_modulus(modulus: f64) -> Result<Self, RangeError> {
        let holds = (0.0..1.0).contains(&modulus);
        RangeError::check("modulus", modulus, holds, "from 0 to below 1")?;
        Ok(Self(((1.0 - modulus) * (1.0 + modulus)).sqrt()))
    }

    /// The axis ratio for a parameter `m = 1 - (a/b)^2`, which is negative for a > b.
    ///
    /// # Errors
    /// [`RangeError`] unless `parameter` is finite and below 1.
    ///
    /// ```
    /// use carom_special::AxisRatio;
    /// assert_eq!(AxisRatio::from_parameter(-3.0)?.get(), 2.0);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    pub fn from_parameter(parameter: f64) -> Result<Self, RangeError> {
        let holds = parameter.is_finite() && parameter < 1.0;
        RangeError::check("parameter", parameter, holds, "finite and below 1")?;
        Ok(Self((1.0 - parameter).sqrt()))
    }

    /// The ratio k' = a/b.
    #[must_use]
    pub const fn get(self) -> f64 {
        self.0
    }

    /// The ratio b/a of the same ellipse with its axes exchanged.
    #[must_use]
    pub fn inverse(self) -> Self {
        // The reciprocal of a subnormal number overflows; the largest finite number is used
        // instead.
        Self((1.0 / self.0).min(f64::MAX))
    }

    /// The parameter m = k^2 = (1 - k')(1 + k'); negative for a > b.
    #[must_use]
    pub fn parameter(self) -> f64 {
        (1.0 - self.0) * (1.0 + self.0)
    }
}
