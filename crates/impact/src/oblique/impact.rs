//! The solved oblique impact: its restitution and its phases.

use super::groups::Groups;
use super::recorder::{Recorder, Silent};
use super::regime::{Event, ObliqueError, Phase, Regime};
use super::trajectory::Trajectory;
use crate::closed_form;

/// Below this psi the impact does not differ from one without slip.
pub(super) const PSI_MIN: f64 = 1e-14;

/// An uncoupled oblique impact, solved from first contact to separation.
///
/// ```
/// use carom_impact::oblique::{Groups, ObliqueImpact};
/// // Solid spheres, nu = 1/2 (kappa = 3/2), lambda = 3: the ball under a book, figure 3.7.
/// let impact = ObliqueImpact::new(Groups::of_spheres(1.5, 3.0)?)?;
/// assert!((impact.restitution() - 0.595_052).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct ObliqueImpact {
    groups: Groups,
    restitution: f64,
    phases: Vec<Phase>,
}

impl ObliqueImpact {
    /// Solves the impact with these groups.
    ///
    /// # Errors
    /// [`ObliqueError`] if separation is not reached. This did not occur in two million random
    /// cases with chi in [0.01, 100] and psi in [1e-6, 1000].
    pub fn new(groups: Groups) -> Result<Self, ObliqueError> {
        if groups.psi() < PSI_MIN {
            let restitution = closed_form::restitution_without_slip(groups.chi()).clamp(-1.0, 1.0);
            let phase = Phase { regime: Regime::Adhesion, began_by: Event::Touch, start: 1.0 };
            return Ok(Self { groups, restitution, phases: vec![phase] });
        }
        Self::record(groups, &mut Silent)
    }

    pub(super) fn record<R: Recorder>(
        groups: Groups,
        recorder: &mut R,
    ) -> Result<Self, ObliqueError> {
        let mut trajectory = Trajectory::new(groups, recorder);
        // Energy never grows: the bound holds exactly, whatever the round-off of the integration.
        let restitution = (0.0 - trajectory.run()?).clamp(-1.0, 1.0);
        Ok(Self { groups, restitution, phases: trajectory.phases })
    }

    /// The groups chi and psi.
    #[must_use]
    pub fn groups(&self) -> Groups {
        self.groups
    }

    /// R_x = -(tangential velocity after)/(before), at the contact point.
    ///
    /// -1 without friction, +1 for a full reversal. For psi = 0 the limit (9.46).
    #[must_use]
    pub fn restitution(&self) -> f64 {
        self.restitution
    }

    /// The tangential impulse for a slip velocity and the mobility along it.
    ///
    /// `limit` is Coulomb's limit of the impulse, reached by an impact that slides throughout. It
    /// is not computed from 1 + R_x, which loses its digits in grazing impacts.
    pub(crate) fn drag(&self, slip: f64, mobility: f64, limit: f64) -> f64 {
        match self.phases[..] {
            [Phase { regime: Regime::SlideForward, .. }] => limit,
            _ => ((1.0 + self.restitution) * slip / mobility).min(limit),
        }
    }

    /// The phases in order; the last ends with separation.
    #[must_use]
    pub fn phases(&self) -> &[Phase] {
        &self.phases
    }

    /// The regimes in order, without repeats.
    pub fn regimes(&self) -> impl Iterator<Item = Regime> + '_ {
        let phases = &self.phases;
        phases
            .iter()
            .enumerate()
            .filter(|(i, phase)| *i == 0 || phases[i - 1].regime != phase.regime)
            .map(|(_, phase)| phase.regime)
    }
}
