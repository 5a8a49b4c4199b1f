//! The error for a value out of range, used in all layers: field, value and allowed range.

/// A value outside the range that its formula or constructor allows.
///
/// ```
/// use carom_special::RangeError;
/// let error = RangeError::positive("radius", -1.0).unwrap_err();
/// assert_eq!(error.to_string(), "radius = -1 is out of range: must be finite and > 0");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{field} = {} is out of range: must be {allowed}", Readable(*value))]
pub struct RangeError {
    /// Name of the field or argument.
    pub field: &'static str,
    /// The given value.
    pub value: f64,
    /// The allowed range, in words.
    pub allowed: &'static str,
}

/// Formats a number for reading: very large and very small ones with an exponent.
///
/// ```
/// use carom_special::Readable;
/// assert_eq!(format!("{} {} {}", Readable(-1.0), Readable(1e300), Readable(f64::NAN)), "-1 1e300 NaN");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Readable(pub f64);

impl std::fmt::Display for Readable {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let plain = !self.0.is_finite() || self.0 == 0.0 || (1e-5..1e16).contains(&self.0.abs());
        if plain { write!(f, "{}", self.0) } else { write!(f, "{:e}", self.0) }
    }
}

impl RangeError {
    /// The error for `field` with `value`; `allowed` describes the allowed range.
    #[must_use]
    pub const fn new(field: &'static str, value: f64, allowed: &'static str) -> Self {
        Self { field, value, allowed }
    }

    /// Returns `value` if it is finite and positive.
    ///
    /// # Errors
    /// Otherwise the error that names `field`.
    pub fn positive(field: &'static str, value: f64) -> Result<f64, Self> {
        Self::check(field, value, value.is_finite() && value > 0.0, "finite and > 0")
    }

    /// Returns `value` if it is finite and not negative.
    ///
    /// # Errors
    /// Otherwise the error that names `field`.
    pub fn non_negative(field: &'static str, value: f64) -> Result<f64, Self> {
        Self::check(field, value, value.is_finite() && value >= 0.0, "finite and >= 0")
    }

    /// Returns `value` if it is finite.
    ///
    /// # Errors
    /// Otherwise the error that names `field`.
    pub fn finite(field: &'static str, value: f64) -> Result<f64, Self> {
        Self::check(field, value, value.is_finite(), "finite")
    }

    /// Returns `value` if `holds`; otherwise the error that `field` must be `allowed`.
    ///
    /// # Errors
    /// The error that names `field` when `holds` is false.
    pub fn check(
        field: &'static str,
        value: f64,
        holds: bool,
        allowed: &'static str,
    ) -> Result<f64, Self> {
        if holds { Ok(value) } else { Err(Self::new(field, value, allowed)) }
    }
}
