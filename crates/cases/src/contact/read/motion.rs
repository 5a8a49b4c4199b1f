//! Shift or rolling.

use super::super::case::{Motion, Rolling};
use super::super::fault::Fault;
use super::super::potential::Potential;
use super::Reader;

/// Steps that CONTACT takes for longer than a cell, in DX.
const LONG_STEP: f64 = 1.0001;
/// How close CHI must be to a direction of the solvers of steady rolling.
const SAME_ANGLE: f64 = 0.01;

impl Reader<'_> {
    /// What happens along the surface, with notes of what the digits do not say.
    pub(super) fn motion(&self, area: Potential, notes: &mut Vec<String>) -> Result<Motion, Fault> {
        let motion = match (self.tang(), self.rolling) {
            (0, _) => Motion::None,
            (1, _) => Motion::Shift,
            (tang, None) => {
                return Err(self.digit("T (TANG)", tang, "0 or 1 before CHI and DQ are given"));
            }
            (2, Some(rolling)) => Motion::Step(rolling),
            (_, Some(rolling)) => Motion::Steady(self.steadily(rolling, area, notes)),
        };
        let dx = area.size[0];
        if motion.rolling().is_some_and(|rolling| rolling.dq > LONG_STEP * dx) {
            notes.push(format!(
                "CONTACT corrects steps at the leading edge if DQ > DX = {dx}, carom does not"
            ));
        }
        Ok(motion)
    }

    /// CONTACT's solvers of steady rolling, but ConvexGS, roll along x in steps of a cell, as FASTSIM does.
    fn steadily(&self, given: Rolling, area: Potential, notes: &mut Vec<String>) -> Rolling {
        let (mut rolling, dx) = (given, area.size[0]);
        if self.solver == 2 && self.fastsim.is_none() {
            return rolling;
        }
        let back = std::f64::consts::PI;
        if given.chi.abs() > SAME_ANGLE && (given.chi - back).abs() > SAME_ANGLE {
            rolling.chi = 0.0;
            notes.push(format!("CHI = 0 instead of {}, as CONTACT does", given.chi));
        }
        if (given.dq - dx).abs() > 1e-9 * dx {
            rolling.dq = dx;
            if (given.dq - dx).abs() > 0.01 * dx {
                notes.push(format!("DQ = DX = {dx} instead of {}, as CONTACT does", given.dq));
            }
        }
        rolling
    }
}
