//! The states of a torsional impact at chosen instants.

use carom_special::RangeError;

use super::adhesion::Adhesion;
use super::error::TorsionalError;
use super::groups::TorsionalGroups;
use super::impact::TorsionalImpact;
use super::stepped::{Step, SteppedTrajectory};
use super::trajectory::{Trajectory, TrajectoryError};
use crate::normal;

/// What the contact area does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TorsionalPhase {
    /// The whole contact area sticks.
    Adhesion,
    /// A ring at the rim slips.
    PartialSlip,
    /// Nothing sticks, or less than a double resolves.
    Sliding,
}

/// One instant of a torsional impact.
///
/// Units: time by zeta_max/zeta'_A, radii by a_max, the spin by its initial value beta'_A, the twist
/// by `beta'_A zeta_max/zeta'_A`; the torque such that `spin' = -eps torque`, that is
/// mu/Omega in the units of [`carom_laws::torsion::history::TwistHistory`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionalPoint {
    /// Time since touch.
    pub time: f64,
    /// Normal velocity, from 1 to -1.
    pub normal_velocity: f64,
    /// Contact radius.
    pub radius: f64,
    /// Radius of the stick area.
    pub stick_radius: f64,
    /// Relative spin.
    pub spin: f64,
    /// Relative twist since touch.
    pub twist: f64,
    /// Torque against the spin.
    pub torque: f64,
    /// Phase.
    pub phase: TorsionalPhase,
}

impl TorsionalImpact {
    /// The states at the normal velocities `w`, which must fall from 1 to -1; values outside are
    /// taken as the nearer end, one above its predecessor as the predecessor.
    ///
    /// Omega = 0 is shown by its nearly equal neighbour 1e-6.
    ///
    /// # Errors
    /// As [`TorsionalImpact::new`].
    pub fn trace(
        groups: TorsionalGroups,
        w: &[f64],
    ) -> Result<Vec<TorsionalPoint>, TorsionalError> {
        let groups = groups.away_from_zero();
        match Self::trace_one_ring(groups, w) {
            Ok(points) => Ok(points),
            Err(TrajectoryError::TurnsBack) => Ok(Self::trace_in_steps(groups, w)?),
            Err(TrajectoryError::Failed(error)) => Err(error),
        }
    }

    fn trace_in_steps(
        groups: TorsionalGroups,
        w: &[f64],
    ) -> Result<Vec<TorsionalPoint>, RangeError> {
        const STEPS: usize = 4000;
        let mut trajectory = SteppedTrajectory::new(groups, STEPS);
        let mut last = 1.0;
        let mut points = Vec::with_capacity(w.len());
        for &target in w {
            last = target.clamp(-1.0, last);
            let Step { radius, stick, spin, twist, torque } = trajectory.advance_to(last)?;
            let phase = if stick >= radius * (1.0 - 1e-12) {
                TorsionalPhase::Adhesion
            } else if stick > 0.0 {
                TorsionalPhase::PartialSlip
            } else {
                TorsionalPhase::Sliding
            };
            points.push(TorsionalPoint {
                time: normal::time(last),
                normal_velocity: last,
                radius,
                stick_radius: stick,
                spin,
                twist,
                torque,
                phase,
            });
        }
        Ok(points)
    }

    fn trace_one_ring(
        groups: TorsionalGroups,
        w: &[f64],
    ) -> Result<Vec<TorsionalPoint>, TrajectoryError> {
        let history = Adhesion::new(groups.epsilon(), groups.omega())?;
        let onset_velocity = history.onset_velocity();
        let mut trajectory = Trajectory::new(groups, &history);
        let mut last = 1.0;
        let mut points = Vec::with_capacity(w.len());
        for &target in w {
            let w = target.clamp(-1.0, last);
            last = w;
            let instant = trajectory.advance_to(w)?;
            let phase = if w >= onset_velocity {
                TorsionalPhase::Adhesion
            } else if instant.stick > 0.0 {
                TorsionalPhase::PartialSlip
            } else {
                TorsionalPhase::Sliding
            };
            points.push(TorsionalPoint {
                time: normal::time(w),
                normal_velocity: w,
                radius: instant.radius,
                stick_radius: instant.stick,
                spin: instant.turn.spin(groups.epsilon()),
                twist: instant.turn.twist,
                torque: instant.turn.torque,
                phase,
            });
        }
        Ok(points)
    }
}
