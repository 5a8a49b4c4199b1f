//! The torsional impact of a circular contact, from touch to separation.

use carom_special::RangeError;
use carom_special::ode::{OdeError, Stepper, Tolerance};
use carom_special::roots::RootError;

use super::adhesion::{Adhesion, SWITCH_RADIUS, SWITCH_VELOCITY, Turn, radius_at, velocity_at};
use super::groups::{SMALL_OMEGA, TorsionalGroups};
use super::limits;
use super::slip::{Answer, SlippingContact};
use super::stepped::{self, Settled};

/// Why a torsional impact cannot be given.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum TorsionalError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The equation of motion could not be integrated.
    #[error(transparent)]
    Ode(#[from] OdeError),
    /// The onset of slip could not be found.
    #[error(transparent)]
    Root(#[from] RootError),
}

/// Why a walk with one slip ring ends early.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum WalkError {
    /// The spin turns back so fast that the slip ring does not keep its direction; the law used
    /// here (10.25) then ends. This takes epsilon > 0.826, far outside Hertz's theory for spheres.
    TurnsBack,
    Failed(TorsionalError),
}

impl<E: Into<TorsionalError>> From<E> for WalkError {
    fn from(error: E) -> Self {
        Self::Failed(error.into())
    }
}

/// A torsional impact, solved: complete adhesion first, then a slip ring that grows from the rim
/// until separation (chapter 10, with (10.7), (10.25)-(10.29) corrected).
///
/// Accurate to about 1e-12 for epsilon <= 0.826, and beyond as long as the slip keeps its direction.
/// Where the spin turns back so fast that a second ring slips, the general history of a twisted
/// contact is stepped instead; [`TorsionalImpact::error_estimate`] tells.
///
/// ```
/// use carom_impact::torsional::{TorsionalGroups, TorsionalImpact};
/// let impact = TorsionalImpact::new(TorsionalGroups::new(0.0625, 0.5)?)?;
/// assert!((impact.spin_ratio() - 0.954_152_209_372_2).abs() < 1e-11);
/// assert!((impact.onset_radius() - 0.809_405_359_750).abs() < 1e-11);
/// # Ok::<(), carom_impact::torsional::TorsionalError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TorsionalImpact {
    groups: TorsionalGroups,
    onset_radius: f64,
    spin_ratio: f64,
    error_estimate: f64,
}

/// The tolerance while a ring slips: the adhesion before it is more exact, as its slopes count.
const TOLERANCE: Tolerance = Tolerance { absolute: 1e-13, relative: 2e-13 };
/// The error of the solution with one slip ring.
const EXACT: f64 = 1e-12;

impl TorsionalImpact {
    /// Follows the impact to separation.
    ///
    /// # Errors
    /// [`TorsionalError`] if an integration fails; not seen.
    pub fn new(groups: TorsionalGroups) -> Result<Self, TorsionalError> {
        let history = Adhesion::new(groups.epsilon(), groups.omega())?;
        let onset_radius = history.onset();
        if groups.omega() >= SMALL_OMEGA {
            return match Walk::new(groups, &history).advance_to(-1.0) {
                Ok(end) => {
                    let spin_ratio = end.turn.spin(groups.epsilon());
                    Ok(Self { groups, onset_radius, spin_ratio, error_estimate: EXACT })
                }
                Err(WalkError::TurnsBack) => {
                    let Settled { spin_ratio, change } = stepped::settle(groups)?;
                    let error_estimate = change.max(EXACT);
                    Ok(Self { groups, onset_radius, spin_ratio, error_estimate })
                }
                Err(WalkError::Failed(error)) => Err(error),
            };
        }
        let limit = limits::no_slip(groups.epsilon())?;
        let nearby = Self::new(TorsionalGroups::new(groups.epsilon(), SMALL_OMEGA)?)?;
        let share = groups.omega() / SMALL_OMEGA;
        let spin_ratio = limit + share * (nearby.spin_ratio - limit);
        let error_estimate = EXACT.max(share * nearby.error_estimate);
        Ok(Self { groups, onset_radius, spin_ratio, error_estimate })
    }

    /// The groups it was solved for.
    #[must_use]
    pub const fn groups(&self) -> TorsionalGroups {
        self.groups
    }

    /// The torsional restitution `beta'(T)/beta'(0)`: the relative spin after over that before.
    #[must_use]
    pub const fn spin_ratio(&self) -> f64 {
        self.spin_ratio
    }

    /// What the spin ratio may be off by: about 1e-12, or in steps what the last doubling of their
    /// number changed.
    #[must_use]
    pub const fn error_estimate(&self) -> f64 {
        self.error_estimate
    }

    /// The contact radius a/a_max at which slip begins, always in compression; 1 without slip.
    #[must_use]
    pub const fn onset_radius(&self) -> f64 {
        self.onset_radius
    }

    /// The part of the energy of the relative spin that friction takes, `1 - ratio^2`.
    #[must_use]
    pub fn energy_loss(&self) -> f64 {
        (1.0 - self.spin_ratio) * (1.0 + self.spin_ratio)
    }
}

/// One instant of the walk.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Station {
    pub(super) turn: Turn,
    pub(super) radius: f64,
    pub(super) stick: f64,
}

/// The course of an impact, by falling normal velocity.
#[derive(Debug, Clone)]
pub(super) struct Walk<'a> {
    groups: TorsionalGroups,
    history: &'a Adhesion,
    contact: SlippingContact<'a>,
    w: f64,
    state: [f64; 2],
    trial: f64,
    innermost: f64,
}

impl<'a> Walk<'a> {
    pub(super) fn new(groups: TorsionalGroups, history: &'a Adhesion) -> Self {
        let at_onset = history.at_onset();
        Self {
            groups,
            history,
            contact: SlippingContact::new(groups.omega(), history),
            w: history.onset_velocity(),
            state: [at_onset.impulse, at_onset.twist],
            trial: 0.05,
            innermost: history.onset(),
        }
    }

    /// Goes on to the normal velocity `w` in [-1, 1], below the last one asked for.
    pub(super) fn advance_to(&mut self, w: f64) -> Result<Station, WalkError> {
        let radius = radius_at(w);
        if w >= self.history.onset_velocity() {
            let turn = self.history.at(radius, w);
            return Ok(Station { turn, radius, stick: radius });
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
        let [impulse, twist] = self.state;
        let Answer { torque, stick } = self.contact.answer(radius, w, twist);
        Ok(Station { turn: Turn { impulse, twist, torque }, radius, stick })
    }

    fn spin(&self) -> f64 {
        1.0 - self.groups.epsilon() * self.state[0]
    }

    /// The contact radius is the argument: `dt = 2 al dal/w`, in compression (`way` 1) or
    /// restitution (-1).
    fn along_radius(&mut self, from: f64, to: f64, way: f64) -> Result<(), WalkError> {
        let epsilon = self.groups.epsilon();
        let mut contact = self.contact.clone();
        let slope = |al: f64, y: &[f64; 2]| {
            let w = velocity_at(al);
            let dt = way * 2.0 * al / w;
            [contact.answer(al, w, y[1]).torque * dt, (1.0 - epsilon * y[0]) * dt]
        };
        let mut walk = Stepper::new(from, self.state, self.trial, TOLERANCE, slope)?;
        while walk.x() != to {
            walk.step(to)?;
            self.state = *walk.y();
            self.check(way * velocity_at(walk.x()), walk.x())?;
        }
        self.trial = walk.trial_step().abs();
        Ok(())
    }

    /// The normal velocity is the argument: `dt = -(4/5) zeta^(-3/2) dw`.
    fn along_velocity(&mut self, to: f64) -> Result<(), WalkError> {
        let epsilon = self.groups.epsilon();
        let mut contact = self.contact.clone();
        let slope = |w: f64, y: &[f64; 2]| {
            let al = radius_at(w);
            let dt = -0.8 / (al * al * al);
            [contact.answer(al, w, y[1]).torque * dt, (1.0 - epsilon * y[0]) * dt]
        };
        let mut walk = Stepper::new(self.w, self.state, self.trial, TOLERANCE, slope)?;
        while walk.x() != to {
            walk.step(to)?;
            self.state = *walk.y();
            self.w = walk.x();
            self.check(walk.x(), radius_at(walk.x()))?;
        }
        self.trial = walk.trial_step().abs();
        Ok(())
    }

    /// The law holds while the slip ring grows, and while in restitution the twist turns back no
    /// faster than the edge recedes.
    fn check(&mut self, w: f64, al: f64) -> Result<(), WalkError> {
        let stick = self.contact.answer(al, w, self.state[1]).stick;
        let grows = stick <= self.innermost * (1.0 + 1e-7);
        let onward = self.contact.sign() * self.groups.omega() * self.spin();
        let keeps = if w >= 0.0 { onward >= 0.0 } else { onward * 2.0 * al >= w };
        if grows && keeps {
            self.innermost = self.innermost.min(stick);
            return Ok(());
        }
        Err(WalkError::TurnsBack)
    }
}
