//! The motion of a torsional impact: adhesion, then one slip annulus until separation.

use carom_special::ode::{Stepper, Tolerance};

use super::adhesion::{Adhesion, SWITCH_RADIUS, SWITCH_VELOCITY, Turn, radius_at, velocity_at};
use super::error::TorsionalError;
use super::groups::TorsionalGroups;
use super::slip::{Answer, SlippingContact};

/// The tolerance in partial slip. The adhesion before it is more accurate, since its derivatives
/// are used.
const TOLERANCE: Tolerance = Tolerance { absolute: 1e-13, relative: 2e-13 };

/// Why a trajectory with one slip annulus ends early.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum TrajectoryError {
    /// The spin reverses so fast that the slip annulus does not keep its direction, and the law
    /// (10.25) no longer holds. This requires epsilon > 0.826, far outside Hertz's theory for
    /// spheres.
    TurnsBack,
    Failed(TorsionalError),
}

impl<E: Into<TorsionalError>> From<E> for TrajectoryError {
    fn from(error: E) -> Self {
        Self::Failed(error.into())
    }
}

/// One instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Instant {
    pub(super) turn: Turn,
    pub(super) radius: f64,
    pub(super) stick: f64,
}

/// The motion with one slip annulus, over decreasing normal velocity.
#[derive(Debug, Clone)]
pub(super) struct Trajectory<'a> {
    groups: TorsionalGroups,
    history: &'a Adhesion,
    contact: SlippingContact<'a>,
    w: f64,
    /// Impulse of the torque (in units of that of sliding if it is small) and twist.
    state: [f64; 2],
    /// One over the unit of the impulse, so that the small loss of fast spins keeps its digits.
    unit: f64,
    trial: f64,
    innermost: f64,
}

impl<'a> Trajectory<'a> {
    pub(super) fn new(groups: TorsionalGroups, history: &'a Adhesion) -> Self {
        let at_onset = history.at_onset();
        let unit = groups.omega().max(1.0);
        Self {
            groups,
            history,
            contact: SlippingContact::new(groups.omega(), history),
            w: history.onset_velocity(),
            state: [at_onset.impulse * unit, at_onset.twist],
            unit,
            trial: 0.05,
            innermost: history.onset(),
        }
    }

    /// Continues to the normal velocity `w` in [-1, 1], below the last one requested.
    pub(super) fn advance_to(&mut self, w: f64) -> Result<Instant, TrajectoryError> {
        let radius = radius_at(w);
        if w >= self.history.onset_velocity() {
            let turn = self.history.at(radius, w);
            return Ok(Instant { turn, radius, stick: radius });
        }
        if self.w > SWITCH_VELOCITY {
            let to = if w > SWITCH_VELOCITY { radius } else { SWITCH_RADIUS };
            self.along_radius(radius_at(self.w), to, 1.0)?;
            self.w = w.max(SWITCH_VELOCITY);
        }
        if self.w > -SWITCH_VELOCITY && w < self.w {
            self.along_velocity(w.max(-SWITCH_VELOCITY))?;
        }
        if w < self.w {
            let from = if self.w == -SWITCH_VELOCITY { SWITCH_RADIUS } else { radius_at(self.w) };
            self.along_radius(from, radius, -1.0)?;
            self.w = w;
        }
        let [impulse, twist] = [self.state[0] / self.unit, self.state[1]];
        let Answer { torque, stick } = self.contact.answer(radius, w, twist);
        Ok(Instant { turn: Turn { impulse, twist, torque }, radius, stick })
    }

    fn spin(&self) -> f64 {
        1.0 - self.groups.epsilon() * (self.state[0] / self.unit)
    }

    /// Integrates over the contact radius: `dt = 2 al dal/w`, in compression (`direction` 1) or
    /// restitution (-1).
    fn along_radius(&mut self, from: f64, to: f64, direction: f64) -> Result<(), TrajectoryError> {
        let (epsilon, unit) = (self.groups.epsilon() / self.unit, self.unit);
        let mut contact = self.contact.clone();
        let slope = |al: f64, y: &[f64; 2]| {
            let w = velocity_at(al);
            let dt = direction * 2.0 * al / w;
            [contact.answer(al, w, y[1]).torque * unit * dt, (1.0 - epsilon * y[0]) * dt]
        };
        let mut stepper = Stepper::new(from, self.state, self.trial, TOLERANCE, slope)?;
        while stepper.x() != to {
            stepper.step(to)?;
            self.state = *stepper.y();
            self.check(direction * velocity_at(stepper.x()), stepper.x())?;
        }
        self.trial = stepper.trial_step().abs();
        Ok(())
    }

    /// Integrates over the normal velocity: `dt = -(4/5) zeta^(-3/2) dw`.
    fn along_velocity(&mut self, to: f64) -> Result<(), TrajectoryError> {
        let (epsilon, unit) = (self.groups.epsilon() / self.unit, self.unit);
        let mut contact = self.contact.clone();
        let slope = |w: f64, y: &[f64; 2]| {
            let al = radius_at(w);
            let dt = -0.8 / (al * al * al);
            [contact.answer(al, w, y[1]).torque * unit * dt, (1.0 - epsilon * y[0]) * dt]
        };
        let mut stepper = Stepper::new(self.w, self.state, self.trial, TOLERANCE, slope)?;
        while stepper.x() != to {
            stepper.step(to)?;
            self.state = *stepper.y();
            self.w = stepper.x();
            self.check(stepper.x(), radius_at(stepper.x()))?;
        }
        self.trial = stepper.trial_step().abs();
        Ok(())
    }

    /// The law holds while the slip annulus grows and, in restitution, the twist reverses no faster
    /// than the edge recedes.
    fn check(&mut self, w: f64, al: f64) -> Result<(), TrajectoryError> {
        let stick = self.contact.answer(al, w, self.state[1]).stick;
        let grows = stick <= self.innermost * (1.0 + 1e-7);
        let onward = self.contact.sign() * self.groups.omega() * self.spin();
        let keeps = if w >= 0.0 { onward >= 0.0 } else { onward * 2.0 * al >= w };
        if grows && keeps {
            self.innermost = self.innermost.min(stick);
            return Ok(());
        }
        Err(TrajectoryError::TurnsBack)
    }
}
