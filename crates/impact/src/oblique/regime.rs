//! Regimes, the events between them, and errors of an oblique impact.

use carom_special::ode::OdeError;

/// Why an oblique impact could not be solved to separation.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ObliqueError {
    /// The integration of a slip phase failed.
    #[error("partial slip at normal velocity w = {w}: {source}")]
    Integration {
        /// Normal velocity w where it failed.
        w: f64,
        /// The integrator's reason.
        source: OdeError,
    },
    /// The regimes changed too often.
    #[error("more than {phases} changes of regime, the last at normal velocity w = {w}")]
    TooManyPhases {
        /// Number of phases.
        phases: usize,
        /// Normal velocity w there.
        w: f64,
    },
}

/// Regime of a contact: which part sticks, and the sign of the traction on body 1.
///
/// The sign is relative to the initial tangential velocity of body 2 against body 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Regime {
    /// The whole contact sticks.
    Adhesion,
    /// An annulus at the edge slips, with traction along +x on body 1.
    SlipForward,
    /// An annulus at the edge slips, with traction along -x.
    SlipBackward,
    /// The whole contact slides, with traction along +x.
    SlideForward,
    /// The whole contact slides, with traction along -x.
    SlideBackward,
}

impl Regime {
    pub(super) fn slip(sign: f64) -> Self {
        if sign > 0.0 { Self::SlipForward } else { Self::SlipBackward }
    }

    pub(super) fn slide(sign: f64) -> Self {
        if sign > 0.0 { Self::SlideForward } else { Self::SlideBackward }
    }

    /// Short name: `adhesion`, `slip+`, `slip-`, `slide+`, `slide-`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Adhesion => "adhesion",
            Self::SlipForward => "slip+",
            Self::SlipBackward => "slip-",
            Self::SlideForward => "slide+",
            Self::SlideBackward => "slide-",
        }
    }
}

/// What ended the previous phase.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Event {
    /// First contact.
    Touch,
    /// The edge reached the friction limit: a slip annulus opens.
    SlipStart,
    /// The slip annulus stopped: its stresses are frozen (E1).
    SlipStop,
    /// The receding edge has overtaken the slip annulus, which reopens with the opposite sign (E2).
    RingClosed,
    /// The stick area vanished (E3).
    StickEnd,
    /// Sliding stopped.
    SlideStop,
}

/// A stretch of time in one regime.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// The regime.
    pub regime: Regime,
    /// The event at its beginning.
    pub began_by: Event,
    /// Normal velocity w = zeta'/zeta'_A at its start, from 1 (first contact) to -1 (separation).
    pub start: f64,
}
