//! What is prescribed along the axis.

use carom_special::RangeError;

/// What is prescribed along the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axial {
    /// The force F on closed ends beside the pressure on them; tension is positive.
    Force(f64),
    /// The growth in length of one corrugation.
    Dilatation(f64),
}

impl Axial {
    /// The prescribed value.
    #[must_use]
    pub const fn value(self) -> f64 {
        match self {
            Self::Force(value) | Self::Dilatation(value) => value,
        }
    }

    /// The same kind with another value.
    #[must_use]
    pub(super) const fn with(self, value: f64) -> Self {
        match self {
            Self::Force(_) => Self::Force(value),
            Self::Dilatation(_) => Self::Dilatation(value),
        }
    }
}

/// Internal pressure, and force or dilatation along the axis.
///
/// ```
/// use carom_shells::bellows::{Axial, BellowsLoad};
/// let load = BellowsLoad::new(1e5, Axial::Dilatation(2e-3))?;
/// assert_eq!(load.pressure(), 1e5);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BellowsLoad {
    pressure: f64,
    axial: Axial,
}

impl BellowsLoad {
    /// Internal pressure (negative from outside) with force or dilatation.
    ///
    /// # Errors
    /// [`RangeError`] unless both are finite.
    pub fn new(pressure: f64, axial: Axial) -> Result<Self, RangeError> {
        let pressure = RangeError::finite("pressure", pressure)?;
        let field = match axial {
            Axial::Force(_) => "force",
            Axial::Dilatation(_) => "dilatation",
        };
        RangeError::finite(field, axial.value())?;
        Ok(Self { pressure, axial })
    }

    /// Internal pressure.
    #[must_use]
    pub const fn pressure(&self) -> f64 {
        self.pressure
    }

    /// Force or dilatation.
    #[must_use]
    pub const fn axial(&self) -> Axial {
        self.axial
    }
}
