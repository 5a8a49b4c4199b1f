//! The stage of a contact: adhesion, slip at the edge, or sliding.

use carom_laws::law::ContactLaw;
use carom_laws::memory::{Lateral, MemoryRegime, VertexStack};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::sliders::SlipLines;
use carom_laws::viscous::ViscousLaw;

use crate::oblique::{Event, Regime};

/// How much of the contact slips.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stage {
    /// None of it.
    Adhesion,
    /// A part of it.
    Slip,
    /// All of it.
    Slide,
}

/// A contact law that reports what its last step did.
pub trait Staged {
    /// What slipped in the last step.
    fn stage(&self) -> Stage;
}

impl Staged for SlipLines {
    fn stage(&self) -> Stage {
        self.regime().into()
    }
}

impl<V: Lateral, S: VertexStack<V>> Staged for ShiftLaw<V, S> {
    fn stage(&self) -> Stage {
        self.regime().into()
    }
}

impl<L: Staged + ContactLaw> Staged for ViscousLaw<L> {
    fn stage(&self) -> Stage {
        self.elastic().stage()
    }
}

impl Stage {
    /// The stage of a regime.
    pub(super) const fn of(regime: Regime) -> Self {
        match regime {
            Regime::Adhesion => Self::Adhesion,
            Regime::SlipForward | Regime::SlipBackward => Self::Slip,
            Regime::SlideForward | Regime::SlideBackward => Self::Slide,
        }
    }

    /// The regime of this stage whose traction on body 1 points along the initial slip direction
    /// (`forward`) or against it.
    pub(crate) const fn regime(self, forward: bool) -> Regime {
        match (self, forward) {
            (Self::Adhesion, _) => Regime::Adhesion,
            (Self::Slip, true) => Regime::SlipForward,
            (Self::Slip, false) => Regime::SlipBackward,
            (Self::Slide, true) => Regime::SlideForward,
            (Self::Slide, false) => Regime::SlideBackward,
        }
    }

    /// The event that leads from one stage to another.
    pub(super) const fn event(from: Self, to: Self) -> Event {
        match (from, to) {
            (Self::Slide, _) => Event::SlideStop,
            (_, Self::Slide) => Event::StickEnd,
            (Self::Slip, Self::Adhesion) => Event::SlipStop,
            (Self::Slip, Self::Slip) => Event::RingClosed,
            (Self::Adhesion, _) => Event::SlipStart,
        }
    }
}

impl From<MemoryRegime> for Stage {
    fn from(regime: MemoryRegime) -> Self {
        match regime {
            MemoryRegime::Separated | MemoryRegime::Adhesion | MemoryRegime::Release => {
                Self::Adhesion
            }
            MemoryRegime::Slip | MemoryRegime::Reversal | MemoryRegime::Overlay => Self::Slip,
            MemoryRegime::Sliding => Self::Slide,
        }
    }
}
