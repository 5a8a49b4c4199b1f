//! Observers of a trajectory while it is computed.

use carom_special::ode::Stepper;

use super::adhesion::Segment;
use super::onset::Opening;
use super::regime::Regime;
use super::slip::{Clock, Pair, Slip, Unknowns};
use super::state::State;

/// Observes an impact while it is computed.
pub(super) trait Recorder {
    /// Adhesion from `state` to the velocity `w` on `segment`; keeps `state.shift` up to date.
    fn adhesion(&mut self, chi: f64, psi: f64, segment: &Segment, state: &mut State, w: f64);
    /// The release from maximum compression retraces the adhesive loading on `segment`.
    fn retrace(&mut self, chi: f64, segment: &Segment, state: &State);
    /// The first moments of partial slip.
    fn onset(&mut self, slip: &Slip<'_>, opening: &Opening);
    /// An accepted step of partial slip.
    fn slip<F: FnMut(f64, &Unknowns) -> Unknowns>(
        &mut self,
        slip: &Slip<'_>,
        clock: Clock,
        stepper: &mut Stepper<2, F>,
    );
    /// The shift in partial slip.
    fn shift(&self, slip: &Slip<'_>, pair: &Pair) -> f64;
    /// Separation in `state` at the end of `regime`.
    fn separation(&mut self, state: &State, regime: Regime);
    /// Sliding from `state` to the velocity `w`; keeps `state.shift` up to date.
    fn slide(&mut self, chi: f64, psi: f64, sign: f64, state: &mut State, w: f64);
}

/// Records nothing.
pub(super) struct Silent;

impl Recorder for Silent {
    fn adhesion(&mut self, _: f64, _: f64, _: &Segment, _: &mut State, _: f64) {}
    fn retrace(&mut self, _: f64, _: &Segment, _: &State) {}
    fn onset(&mut self, _: &Slip<'_>, _: &Opening) {}
    fn slip<F: FnMut(f64, &Unknowns) -> Unknowns>(
        &mut self,
        _: &Slip<'_>,
        _: Clock,
        _: &mut Stepper<2, F>,
    ) {
    }
    fn shift(&self, _: &Slip<'_>, _: &Pair) -> f64 {
        0.0
    }
    fn separation(&mut self, _: &State, _: Regime) {}
    fn slide(&mut self, _: f64, _: f64, _: f64, _: &mut State, _: f64) {}
}
