//! What a contact tells beside its load.

use carom_laws::memory::MemoryRegime;

/// The regime of the last step of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u32)]
pub enum CaromRegime {
    /// The bodies are separated.
    Separated = 0,
    /// The whole contact sticks: its edge grew faster than the slip would.
    Adhesion = 1,
    /// The edge receded, and the rest of the contact did not slip.
    Release = 2,
    /// An annulus at the edge slipped.
    Slip = 3,
    /// Slip began anew at the edge, in the opposite direction.
    Reversal = 4,
    /// The slip annulus grew past older ones and erased them.
    Overlay = 5,
    /// The whole contact slid.
    Sliding = 6,
}

/// The state of a contact beside its load.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct CaromReport {
    /// The share of the contact area that sticks.
    pub sticking: f64,
    /// The regime of the last step.
    pub regime: CaromRegime,
}

impl CaromReport {
    /// The report of separated bodies.
    pub(crate) const APART: Self = Self { sticking: 0.0, regime: CaromRegime::Separated };
}

impl From<MemoryRegime> for CaromRegime {
    fn from(regime: MemoryRegime) -> Self {
        match regime {
            MemoryRegime::Separated => Self::Separated,
            MemoryRegime::Adhesion => Self::Adhesion,
            MemoryRegime::Release => Self::Release,
            MemoryRegime::Slip => Self::Slip,
            MemoryRegime::Reversal => Self::Reversal,
            MemoryRegime::Overlay => Self::Overlay,
            MemoryRegime::Sliding => Self::Sliding,
        }
    }
}
