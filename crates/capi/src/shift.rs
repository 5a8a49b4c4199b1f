//! Input and output of a contact with given shifts.

use carom_laws::law::{ContactLoad, Shift};
use carom_laws::memory::Fixed;
use carom_laws::shift_law::ShiftLaw;
use carom_special::RangeError;

use crate::error::Failure;

/// Rigid displacement of body 2 relative to body 1 in contact axes; z points into body 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromShift {
    /// The approach, positive in contact, m.
    pub zeta: f64,
    /// The shift along x, m.
    pub xi: f64,
    /// The shift along y, m.
    pub eta: f64,
}

/// The load that body 2 exerts on body 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct CaromLoad {
    /// Tangential force along x, N.
    pub f_x: f64,
    /// Tangential force along y, N.
    pub f_y: f64,
    /// Normal force, positive in compression, N.
    pub f_z: f64,
}

/// Capacity of the history of a contact, the same as that of a `carom_state`, so that stored and unstored
/// contacts agree.
pub(crate) const VERTICES: usize = 12;
/// The history of a contact, of fixed capacity.
pub(crate) type Stack = Fixed<[f64; 2], VERTICES>;
/// The law of a contact, with a history of fixed capacity.
pub(crate) type Law = ShiftLaw<[f64; 2], Stack>;

impl From<CaromShift> for Shift {
    #[inline]
    fn from(CaromShift { zeta, xi, eta }: CaromShift) -> Self {
        Self { zeta, xi, eta, omega: 0.0 }
    }
}

impl From<ContactLoad> for CaromLoad {
    #[inline]
    fn from(ContactLoad { f_x, f_y, f_z, .. }: ContactLoad) -> Self {
        Self { f_x, f_y, f_z }
    }
}

impl CaromLoad {
    /// The load, unless the bytes of the contact were damaged such that a part of it is infinite or no number.
    pub(crate) fn checked(self) -> Result<Self, Failure> {
        for part in [self.f_x, self.f_y, self.f_z] {
            RangeError::finite("load", part)?;
        }
        Ok(self)
    }
}
