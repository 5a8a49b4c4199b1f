//! Errors of a torsional impact.

use carom_special::RangeError;
use carom_special::ode::OdeError;
use carom_special::roots::RootError;

/// Why a torsional impact cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum TorsionalError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The equation of motion could not be integrated.
    #[error(transparent)]
    Ode(#[from] OdeError),
    /// The onset of slip could not be found.
    #[error(transparent)]
    Root(#[from] RootError),
}
