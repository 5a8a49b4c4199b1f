//! The measured values of a fit.

/// A measured value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Measurement {
    /// The row of the data, from 0.
    pub(crate) row: usize,
    /// Which of the measured quantities it is.
    pub(crate) quantity: usize,
    /// The value.
    pub(crate) value: f64,
    /// Its standard error, if it is known.
    pub(crate) error: Option<f64>,
}

/// A measured quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Its name.
    pub name: String,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Its meaning.
    pub meaning: &'static str,
}
