//! An argument in the unit interval, stored with its complement.

use crate::RangeError;

/// A number x from 0 to 1 together with 1 - x, both to full relative accuracy.
///
/// ```
/// use carom_special::hypergeometric::UnitArgument;
/// let x = UnitArgument::from_complement(1e-20)?;
/// assert_eq!((x.value(), x.complement()), (1.0, 1e-20));
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitArgument {
    value: f64,
    complement: f64,
}

impl UnitArgument {
    /// x = 0.
    pub const ZERO: Self = Self { value: 0.0, complement: 1.0 };

    /// x = 1.
    pub const ONE: Self = Self { value: 1.0, complement: 0.0 };

    /// The argument `x`.
    ///
    /// # Errors
    /// [`RangeError`] unless `x` is from 0 to 1.
    pub fn new(x: f64) -> Result<Self, RangeError> {
        RangeError::check("x", x, (0.0..=1.0).contains(&x), "from 0 to 1")?;
        Ok(Self { value: x, complement: 1.0 - x })
    }

    /// The argument `1 - y`, exact also for y below 1e-16.
    ///
    /// # Errors
    /// [`RangeError`] unless `y` is from 0 to 1.
    pub fn from_complement(y: f64) -> Result<Self, RangeError> {
        RangeError::check("1 - x", y, (0.0..=1.0).contains(&y), "from 0 to 1")?;
        Ok(Self { value: 1.0 - y, complement: y })
    }

    /// x.
    #[must_use]
    pub const fn value(self) -> f64 {
        self.value
    }

    /// 1 - x.
    #[must_use]
    pub const fn complement(self) -> f64 {
        self.complement
    }
}
