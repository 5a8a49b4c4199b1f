//! The states of a torsional impact at chosen instants.

use carom_special::RangeError;

use super::adhesion::Adhesion;
use super::error::TorsionalError;
use super::groups::TorsionalGroups;
use super::impact::TorsionalImpact;
use super::stepped::{Step, SteppedTrajectory};
use super::trajectory::{Instant, Trajectory, TrajectoryError};
use crate::normal;

/// State of the contact area.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TorsionalPhase {
    /// The whole contact area sticks.
    Adhesion,
    /// An annulus at the edge slips.
    PartialSlip,
    /// The whole contact slips; a stick area below round-off counts as none.
    Sliding,
}

/// One instant of a torsional impact.
///
/// Units: time by zeta_max/zeta'_A, radii by a_max, the spin by its initial value beta'_A, the twist
/// by `beta'_A zeta_max/zeta'_A`; the torque such that `spin' = -eps torque`, that is
/// mu/Omega in the units of [`carom_laws::torsion::history::TwistHistory`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionalPoint {
    /// Time since first contact.
    pub time: f64,
    /// Normal velocity, from 1 to -1.
    pub normal_velocity: f64,
    /// Contact radius.
    pub radius: f64,
    /// Radius of the stick area.
    pub stick_radius: f64,
    /// Relative spin.
    pub spin: f64,
    /// Relative twist since first contact.
    pub twist: f64,
    /// Torque against the spin.
    pub torque: f64,
    /// Phase.
    pub phase: TorsionalPhase,
}

impl TorsionalImpact {
    /// The states at the normal velocities `w`, which must decrease from 1 to -1. A value outside
    /// this range is replaced by the nearer end, and one above its predecessor by the predecessor.
    ///
    /// Omega = 0 is replaced by 1e-6, whose result is nearly equal.
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
        falling(w, |w| {
            let Step { radius, stick, spin, twist, torque } = trajectory.advance_to(w)?;
            let adheres = stick >= radius * (1.0 - 1e-12);
            Ok(point(w, [radius, stick], [spin, twist, torque], adheres))
        })
    }

    fn trace_one_ring(
        groups: TorsionalGroups,
        w: &[f64],
    ) -> Result<Vec<TorsionalPoint>, TrajectoryError> {
        let history = Adhesion::new(groups.epsilon(), groups.omega())?;
        let mut trajectory = Trajectory::new(groups, &history);
        falling(w, |w| {
            let Instant { turn, radius, stick } = trajectory.advance_to(w)?;
            let state = [turn.spin(groups.epsilon()), turn.twist, turn.torque];
            Ok(point(w, [radius, stick], state, w >= history.onset_velocity()))
        })
    }
}

/// The states at velocities that are first made to decrease from 1 to -1.
fn falling<E>(
    w: &[f64],
    mut point: impl FnMut(f64) -> Result<TorsionalPoint, E>,
) -> Result<Vec<TorsionalPoint>, E> {
    let mut last = 1.0;
    let next = |target: &f64| {
        last = target.clamp(-1.0, last);
        point(last)
    };
    w.iter().map(next).collect()
}

fn point(
    w: f64,
    [radius, stick]: [f64; 2],
    [spin, twist, torque]: [f64; 3],
    adheres: bool,
) -> TorsionalPoint {
    let phase = match stick {
        _ if adheres => TorsionalPhase::Adhesion,
        0.0 => TorsionalPhase::Sliding,
        _ => TorsionalPhase::PartialSlip,
    };
    TorsionalPoint {
        time: normal::time(w),
        normal_velocity: w,
        radius,
        stick_radius: stick,
        spin,
        twist,
        torque,
        phase,
    }
}
