//! A step of two grains: rotation of their axes, and the shift at its end.

use super::meeting::{Meeting, slip};
use super::number::Number;
use super::vector::{Vector, cross, dot, minus, plus, times};
use crate::law::Shift;

/// The part of the state before a step that the step needs.
pub(super) struct Before<T> {
    pub(super) tangent: Vector<T>,
    pub(super) normal: Vector<T>,
    pub(super) velocity: [T; 2],
    pub(super) lead: [T; 2],
    pub(super) zeta: T,
    /// The shift that was given to the law.
    pub(super) shift: [T; 2],
}

/// The end of a step.
pub(super) struct Step<T = f64> {
    pub(super) tangent: Vector<T>,
    pub(super) zeta: T,
    /// The shift to give to the law.
    pub(super) shift: [T; 2],
    pub(super) velocity: [T; 2],
    /// The rate of the approach.
    pub(super) speed: T,
    pub(super) lead: [T; 2],
}

impl Step {
    #[inline(always)]
    pub(super) fn to(&self) -> Shift {
        let [xi, eta] = self.shift;
        Shift { zeta: self.zeta, xi, eta, omega: 0.0 }
    }
}

/// Friction is averaged if the gap opens within this number of steps.
const STEPS_TO_OPENING: f64 = 4.0;

impl<T: Number> Before<T> {
    /// The end of a step of duration `dt`.
    #[inline(always)]
    pub(super) fn step<M>(&self, meeting: &Meeting<T, M>, dt: f64) -> Step<T> {
        let half = T::of(0.5);
        let middle = times(plus(self.normal, meeting.normal), half);
        let [one, two] = meeting.spins;
        let tangent = self.carried(meeting, dot(plus(one, two), middle) * T::of(0.5 * dt));
        let x = times(plus(self.tangent, tangent), half);
        let slip = slip(meeting, meeting.zeta - self.zeta, middle);
        let velocity = [dot(slip, x), dot(slip, cross(middle, x))];
        let lead = match dt > 0.0 {
            true => {
                let by = T::of(dt * (1.0 / 12.0));
                both(|k| (velocity[k] - self.velocity[k]) * by)
            }
            false => self.lead,
        };
        let dt = T::of(dt);
        let shift = both(|k| self.shift[k] + (velocity[k] * dt + (lead[k] - self.lead[k])));
        let speed = dot(meeting.velocity, middle);
        Step { tangent, zeta: meeting.zeta, shift, velocity, speed, lead }
    }

    /// The lead at the end of a step of a damped contact, and the growth of the shift of its law, of which this part of
    /// the step is in contact. The shift leads by theta times its rate at the end of the step; to it Numerov's correction
    /// is added.
    #[inline(always)]
    pub(super) fn led(&self, velocity: [T; 2], theta: T, part: T, dt: f64) -> [[T; 2]; 2] {
        let lead = match dt > 0.0 {
            true => both(|k| {
                let change = velocity[k] - self.velocity[k];
                change * T::of(dt * (1.0 / 12.0)) + theta * (velocity[k] + T::of(0.5) * change)
            }),
            false => self.lead,
        };
        let by = both(|k| velocity[k] * (T::of(dt) * part) + (lead[k] - self.lead[k]));
        [lead, by]
    }

    /// The tangent, rotated with the normal and by an angle about it, unless the bodies determine it.
    #[inline(always)]
    fn carried<M>(&self, meeting: &Meeting<T, M>, angle: T) -> Vector<T> {
        if let Some(axis) = meeting.axis {
            return axis;
        }
        let (old, new) = (self.normal, meeting.normal);
        let [over_lean, sine, cosine] = rotation(T::of(1.0) - dot(old, new), angle);
        let tilt = dot(self.tangent, new) * over_lean;
        let tangent = minus(self.tangent, times(plus(old, new), tilt));
        let turned = plus(times(tangent, cosine), times(cross(new, tangent), sine));
        // Rounding must not accumulate: the correction removes any component along the normal, and
        // one Newton step restores unit length.
        times(turned, T::of(1.5) - T::of(0.5) * dot(turned, turned))
    }
}

/// What a function gives for either of the two directions.
#[inline(always)]
fn both<T>(of: impl Fn(usize) -> T) -> [T; 2] {
    [of(0), of(1)]
}

/// Whether the gap opens within a few steps.
#[inline]
pub(super) fn leaves(meeting: &Meeting, dt: f64) -> bool {
    parting(meeting, dt) < -meeting.zeta
}

/// The growth of the approach in this number of steps.
#[inline(always)]
pub(super) fn parting<T: Number, M>(meeting: &Meeting<T, M>, dt: f64) -> T {
    T::of(STEPS_TO_OPENING * dt) * dot(meeting.velocity, meeting.normal)
}

/// The positions one step before, where first contact is searched from.
pub(super) fn one_step_before(meeting: &Meeting, dt: f64) -> Shift {
    let by = dot(meeting.velocity, meeting.normal) * dt;
    Shift { zeta: meeting.zeta - by, ..Shift::default() }
}

pub(super) fn first_step(meeting: &Meeting, dt: f64) -> Step {
    let tangent = meeting.axis.unwrap_or_else(|| across(meeting.normal));
    let growth = dot(meeting.velocity, meeting.normal) * dt;
    let slip = slip(meeting, growth, meeting.normal);
    let velocity = [dot(slip, tangent), dot(slip, cross(meeting.normal, tangent))];
    let (zeta, shift, lead) = (meeting.zeta, velocity.map(|v| v * dt), [0.0; 2]);
    let speed = dot(meeting.velocity, meeting.normal);
    Step { tangent, zeta, shift, velocity, speed, lead }
}

/// A unit vector perpendicular to another one; arbitrary but always the same.
fn across(normal: Vector) -> Vector {
    let any = if normal[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let across = minus(any, times(normal, dot(normal, any)));
    times(across, 1.0 / dot(across, across).sqrt())
}

/// Below these 1/(2 - e), and sine and cosine, are computed by series.
const NEAR: [f64; 2] = [1e-4, 1e-3];

/// 1/(2 - e), where 1 - e is the cosine of the rotation of the normal in a step, and sine and cosine of the rotation about
/// it. A normal that is reversed is rotated about the tangent.
#[inline(always)]
fn rotation<T: Number>(e: T, angle: T) -> [T; 3] {
    let near = |[e, angle]: [T; 2]| {
        let [sine, cosine] = turn_near(angle);
        [over_lean_near(e), sine, cosine]
    };
    T::near_or_each([e, angle], NEAR, near, rotation_of_one)
}

/// The same of one contact that rotates far.
#[cold]
#[inline(never)]
fn rotation_of_one([e, angle]: [f64; 2]) -> [f64; 3] {
    let over_lean = match e {
        e if e.abs() <= NEAR[0] => over_lean_near(e),
        e if e < 2.0 - 1e-12 => 1.0 / (2.0 - e),
        _ => 0.0,
    };
    let is_near = angle.abs() <= NEAR[1];
    let [sine, cosine] =
        if is_near { turn_near(angle) } else { [libm::sin(angle), libm::cos(angle)] };
    [over_lean, sine, cosine]
}

#[inline(always)]
fn over_lean_near<T: Number>(e: T) -> T {
    T::of(0.5) + e * (T::of(0.25) + T::of(0.125) * e)
}

#[inline(always)]
fn turn_near<T: Number>(angle: T) -> [T; 2] {
    let (one, square) = (T::of(1.0), angle * angle);
    let sine = angle * (one - square * T::of(1.0 / 6.0));
    let cosine = one - square * (T::of(0.5) - square * T::of(1.0 / 24.0));
    [sine, cosine]
}

/// A point on a straight path, or beyond its end if `part` is above 1.
pub(super) fn on_the_way(from: Shift, to: Shift, part: f64) -> Shift {
    let between = |from: f64, to: f64| from + part * (to - from);
    Shift {
        zeta: between(from.zeta, to.zeta),
        xi: between(from.xi, to.xi),
        eta: between(from.eta, to.eta),
        omega: between(from.omega, to.omega),
    }
}

/// What a force that ends with the contact is in each of its last steps.
#[derive(Clone, Copy)]
pub(super) enum Ending {
    /// More steps in contact follow.
    Later,
    /// The gap opens in the next step.
    Next,
    /// The bodies are apart.
    Over,
}

impl Ending {
    pub(super) fn of(meeting: &Meeting, dt: f64) -> Self {
        let next = meeting.zeta + dt * dot(meeting.velocity, meeting.normal);
        match (meeting.is_apart(), next <= 0.0) {
            (true, _) => Self::Over,
            (false, true) => Self::Next,
            (false, false) => Self::Later,
        }
    }

    /// The mean over the half step before now and the half step after it, by trapezoids. Bodies that are apart exert no
    /// force: what is left for the step in which the gap opens acts one step before.
    pub(super) fn mean(self, past: f64, now: f64, ahead: f64) -> f64 {
        match self {
            Self::Later => 0.5 * now + 0.25 * (past + ahead),
            Self::Next => 0.5 * (now + ahead) + 0.25 * past,
            Self::Over => 0.0,
        }
    }
}
