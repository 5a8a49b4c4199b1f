//! The contact of two grains, carried along.

use std::mem::offset_of;

use carom_special::RangeError;

use super::meeting::Meeting;
use super::number::Number;
use super::vector::{Vector, cross, dot, minus, plus, times};
use crate::law::{ContactLaw, ContactLoad, Dissipative, Shift};
use crate::memory::{Fixed, Growing, VertexStack};
use crate::shift_law::ShiftLaw;

/// The memory of the contact of two grains: the law of the shift in axes that go along.
///
/// From step to step the normal turns by the least rotation and the axes about it with the mean of the
/// two spins, so that what is remembered keeps its components; a step is measured in the axes of its
/// middle, so that a pair that turns as a whole does not slip, to second order. The first step of a
/// contact begins where the two were one step before, so that it finds the touch.
///
/// Two things take away most of what a leapfrog misses in the tangential motion. The law is told the
/// shift `xi + dt^2 xi''/12` in the place of xi (Numerov's, the acceleration being that of the last two
/// velocities), so that what is of second order in the step cancels; no force changes where nothing is
/// accelerated. An oscillation without slip loses `(omega dt)^4/24` of its amplitude a step and is stable to
/// `omega dt = sqrt 3`, that of the leapfrog being 2. Where two grains come apart so fast that four steps do it, friction is its mean over the
/// half steps to and fro, since it then falls to nothing as the power 3/2 of the time.
///
/// The damping is that of a viscoelastic material in the quasi-static limit, which adds
/// `(2/3) c_z (3/2) A sqrt(zeta) dzeta/dt` to Hertz's force, with a time A of the material. Its sum with
/// Hertz's force does not pull. Friction knows Hertz's force alone.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct GrainContact<S = Growing<[f64; 2]>> {
    pub(super) law: ShiftLaw<[f64; 2], S>,
    /// The axis x of the contact; zero while there is none.
    pub(super) tangent: Vector,
    pub(super) normal: Vector,
    /// The tangential force of the last step, along x and y.
    pub(super) friction: [f64; 2],
    /// The damping force of the last step.
    pub(super) drag: f64,
    /// The velocity of the shift in the last step.
    pub(super) velocity: [f64; 2],
    /// How far the law is ahead of the shift.
    pub(super) lead: [f64; 2],
    /// The damping force over `sqrt(zeta) dzeta/dt`.
    pub(super) viscosity: f64,
}

/// What body 2 exerts on body 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct GrainLoad {
    /// The force on body 1, N; that on body 2 is the opposite one.
    pub force: [f64; 3],
    /// The torque on each body about its centre, `-arm normal x force`, N m; that on a wall is zero.
    pub torques: [[f64; 3]; 2],
}

/// What became of mechanical energy, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Heats {
    /// The heat of friction, with what a receding edge releases.
    pub friction: f64,
    /// The heat of the viscoelastic material.
    pub damping: f64,
}

/// What a step sees of what was before it.
pub(super) struct Before<T> {
    pub(super) tangent: Vector<T>,
    pub(super) normal: Vector<T>,
    pub(super) velocity: [T; 2],
    pub(super) lead: [T; 2],
    /// The shift, as the law knows it.
    pub(super) shift: [T; 2],
}

/// Where a step leads.
pub(super) struct Step<T = f64> {
    pub(super) tangent: Vector<T>,
    pub(super) zeta: T,
    /// The shift that the law is told.
    pub(super) shift: [T; 2],
    pub(super) velocity: [T; 2],
    pub(super) lead: [T; 2],
}

impl Step {
    #[inline(always)]
    fn to(&self) -> Shift {
        let [xi, eta] = self.shift;
        Shift { zeta: self.zeta, xi, eta, omega: 0.0 }
    }
}

/// Steps in which two grains come apart, from which on friction is a mean.
const LEAVES_IN: f64 = 4.0;

impl<S: VertexStack<[f64; 2]>> GrainContact<S> {
    /// A contact to be, of a law at rest and of a viscous relaxation time A of the materials, s.
    ///
    /// # Errors
    /// [`RangeError`] unless the time is finite and not negative, and the force finite.
    pub fn new(law: ShiftLaw<[f64; 2], S>, relaxation: f64) -> Result<Self, RangeError> {
        RangeError::non_negative("relaxation", relaxation)?;
        let viscosity = relaxation * law.stiffness().c_z;
        RangeError::finite("relaxation", viscosity)?;
        let (none, drag) = ([0.0; 2], 0.0);
        let (tangent, normal) = ([0.0; 3], [0.0; 3]);
        Ok(Self {
            law,
            tangent,
            normal,
            friction: none,
            drag,
            velocity: none,
            lead: none,
            viscosity,
        })
    }

    /// The law, in the axes of the contact.
    #[must_use]
    pub fn law(&self) -> &ShiftLaw<[f64; 2], S> {
        &self.law
    }

    /// The axis x of the contact; zero while there is none.
    #[must_use]
    pub fn tangent(&self) -> [f64; 3] {
        self.tangent
    }

    /// The elastic energy of the contact, compression included.
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        self.law.stored_energy()
    }

    /// One step of the duration `dt`, at whose end the bodies are as told; the velocities are those
    /// that brought them there (of a leapfrog: those between).
    ///
    /// # Errors
    /// [`RangeError`] for what the law cannot take; the contact is then unchanged.
    #[inline(always)]
    pub fn advance(&mut self, meeting: &Meeting, dt: f64) -> Result<GrainLoad, RangeError> {
        if self.is_new() {
            return self.begin(meeting, dt);
        }
        let step = self.step(meeting, dt);
        if leaves(meeting, dt) {
            return self.leave(meeting, &step);
        }
        let load = self.law.advance(step.to())?;
        Ok(self.keep(meeting, &step, load, [load.f_x, load.f_y]))
    }

    /// The same, and adds up where energy went. The heat of damping is by the rule of trapezoids.
    ///
    /// # Errors
    /// As [`GrainContact::advance`].
    #[inline(never)]
    pub fn advance_accounted(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        heats: &mut Heats,
    ) -> Result<GrainLoad, RangeError> {
        let friction = if self.is_new() {
            let (mut law, before) = (self.law.clone(), one_step_before(meeting, dt));
            law.advance(before)?;
            law.dissipation(first_step(meeting, dt).to())
        } else {
            self.law.dissipation(self.step(meeting, dt).to())
        };
        let old = self.drag;
        let load = self.advance(meeting, dt)?;
        heats.friction += friction;
        heats.damping += 0.5 * (old + self.drag) * dot(meeting.velocity, meeting.normal) * dt;
        Ok(load)
    }

    /// The load at the end of the last step, the bodies where they are told to be. A contact that has
    /// made no step yet carries Hertz's force alone.
    #[inline]
    #[must_use]
    pub fn load(&self, meeting: &Meeting) -> GrainLoad {
        let normal_force = self.elastic(meeting.zeta) + self.drag;
        if self.is_new() {
            let force = times(meeting.normal, self.elastic(meeting.zeta));
            return GrainLoad { force, ..GrainLoad::default() };
        }
        load_in([self.tangent, meeting.normal], meeting.arms, normal_force, self.friction)
    }

    pub(super) fn is_new(&self) -> bool {
        self.tangent == [0.0; 3]
    }

    #[inline]
    fn elastic(&self, zeta: f64) -> f64 {
        elastic(self.law.stiffness().c_z, zeta)
    }

    #[inline(always)]
    fn step(&self, meeting: &Meeting, dt: f64) -> Step {
        let Shift { xi, eta, .. } = self.law.shift();
        let (tangent, normal, velocity, lead) =
            (self.tangent, self.normal, self.velocity, self.lead);
        Before { tangent, normal, velocity, lead, shift: [xi, eta] }.step(meeting, dt)
    }

    #[inline(never)]
    fn begin(&mut self, meeting: &Meeting, dt: f64) -> Result<GrainLoad, RangeError> {
        let (before, step) = (one_step_before(meeting, dt), first_step(meeting, dt));
        before.check_finite()?;
        step.to().check_finite()?;
        let mut law = self.law.clone();
        law.advance(before)?;
        let load = law.advance(step.to())?;
        self.law = law;
        Ok(self.keep(meeting, &step, load, [load.f_x, load.f_y]))
    }

    /// A step with the mean of friction over half a step before its end and half a step beyond.
    #[inline(never)]
    fn leave(&mut self, meeting: &Meeting, step: &Step) -> Result<GrainLoad, RangeError> {
        let (from, to) = (self.law.shift(), step.to());
        let between = |part: f64| Shift {
            zeta: from.zeta + part * (to.zeta - from.zeta),
            xi: from.xi + part * (to.xi - from.xi),
            eta: from.eta + part * (to.eta - from.eta),
            omega: 0.0,
        };
        let (mut law, mut past) = (self.law.clone(), self.law.clone());
        let past = past.advance(between(0.5))?;
        let load = law.advance(to)?;
        let mut ahead = law.clone();
        let ahead = ahead.advance(between(1.5))?;
        self.law = law;
        let mean = |past: f64, now: f64, ahead: f64| 0.5 * now + 0.25 * (past + ahead);
        let friction = [mean(past.f_x, load.f_x, ahead.f_x), mean(past.f_y, load.f_y, ahead.f_y)];
        Ok(self.keep(meeting, step, load, friction))
    }

    #[inline(always)]
    fn keep(
        &mut self,
        meeting: &Meeting,
        step: &Step,
        load: ContactLoad,
        friction: [f64; 2],
    ) -> GrainLoad {
        self.drag = drag(self.viscosity, meeting, load.f_z);
        (self.tangent, self.normal) = (step.tangent, meeting.normal);
        (self.friction, self.velocity, self.lead) = (friction, step.velocity, step.lead);
        load_in([step.tangent, meeting.normal], meeting.arms, load.f_z + self.drag, friction)
    }
}

impl<const N: usize> GrainContact<Fixed<[f64; 2], N>> {
    /// Whether bytes that may have been changed outside are still a contact, as [`ShiftLaw::is_in`].
    #[inline(always)]
    #[must_use]
    pub fn is_in(byte: impl Fn(usize) -> u8) -> bool {
        ShiftLaw::<[f64; 2], Fixed<[f64; 2], N>>::is_in(|at| byte(offset_of!(Self, law) + at))
    }
}

impl<T: Number> Before<T> {
    /// Where a step of the duration `dt` leads.
    #[inline(always)]
    pub(super) fn step(&self, meeting: &Meeting<T>, dt: f64) -> Step<T> {
        let half = T::of(0.5);
        let middle = times(plus(self.normal, meeting.normal), half);
        let tangent = self.carried(meeting, dot(meeting.turning, middle) * T::of(dt));
        let x = times(plus(self.tangent, tangent), half);
        let slip = plus(meeting.velocity, cross(meeting.rolling, middle));
        let velocity = [dot(slip, x), dot(slip, cross(middle, x))];
        let lead = match dt > 0.0 {
            true => {
                let by = T::of(dt * (1.0 / 12.0));
                [0, 1].map(|k| (velocity[k] - self.velocity[k]) * by)
            }
            false => self.lead,
        };
        let by = velocity.map(|v| v * T::of(dt));
        let shift = [0, 1].map(|k| self.shift[k] + (by[k] + (lead[k] - self.lead[k])));
        Step { tangent, zeta: meeting.zeta, shift, velocity, lead }
    }

    /// The tangent, turned as the normal was and by an angle about it.
    #[inline(always)]
    fn carried(&self, meeting: &Meeting<T>, angle: T) -> Vector<T> {
        let (old, new) = (self.normal, meeting.normal);
        let tilt = dot(self.tangent, new) * over_lean(T::of(1.0) - dot(old, new));
        let tangent = minus(self.tangent, times(plus(old, new), tilt));
        let (sine, cosine) = turn(angle);
        let turned = plus(times(tangent, cosine), times(cross(new, tangent), sine));
        // Round-off must not add up: the tilt leaves nothing along the normal, whatever was there, and
        // one step of Newton's leads towards length 1.
        times(turned, T::of(1.5) - T::of(0.5) * dot(turned, turned))
    }
}

/// Hertz's force (5.27).
#[inline(always)]
pub(super) fn elastic<T: Number>(c_z: T, zeta: T) -> T {
    let zeta = zeta.larger(T::of(0.0));
    T::of(2.0 / 3.0) * c_z * (zeta * zeta.sqrt())
}

/// The damping force; its sum with Hertz's does not pull.
#[inline(always)]
pub(super) fn drag<T: Number>(viscosity: T, meeting: &Meeting<T>, elastic: T) -> T {
    let speed = dot(meeting.velocity, meeting.normal);
    let root = meeting.zeta.larger(T::of(0.0)).sqrt();
    (viscosity * root * speed).larger(T::of(0.0) - elastic)
}

/// The force on body 1 and the torques on both, of tangent and normal.
#[inline(always)]
pub(super) fn forces<T: Number>(
    [tangent, normal]: [Vector<T>; 2],
    arms: [T; 2],
    normal_force: T,
    [x, y]: [T; 2],
) -> [Vector<T>; 3] {
    let along = cross(normal, tangent);
    let friction = plus(times(tangent, x), times(along, y));
    // normal x tangent is along, normal x along is minus the tangent: of body 1 - arm normal x force.
    let couple = minus(times(tangent, y), times(along, x));
    let [torque_1, torque_2] = arms.map(|arm| times(couple, arm));
    [plus(times(normal, normal_force), friction), torque_1, torque_2]
}

#[inline]
fn load_in(axes: [Vector; 2], arms: [f64; 2], normal_force: f64, friction: [f64; 2]) -> GrainLoad {
    let [force, torque_1, torque_2] = forces(axes, arms, normal_force, friction);
    GrainLoad { force, torques: [torque_1, torque_2] }
}

/// Whether the two come apart within some steps.
#[inline]
fn leaves(meeting: &Meeting, dt: f64) -> bool {
    parting(meeting, dt) < -meeting.zeta
}

/// By how much the approach grows in so many steps.
#[inline(always)]
pub(super) fn parting<T: Number>(meeting: &Meeting<T>, dt: f64) -> T {
    T::of(LEAVES_IN * dt) * dot(meeting.velocity, meeting.normal)
}

/// Where the two were one step before, to find the touch.
fn one_step_before(meeting: &Meeting, dt: f64) -> Shift {
    let by = dot(meeting.velocity, meeting.normal) * dt;
    Shift { zeta: meeting.zeta - by, ..Shift::default() }
}

fn first_step(meeting: &Meeting, dt: f64) -> Step {
    let tangent = across(meeting.normal);
    let slip = plus(meeting.velocity, cross(meeting.rolling, meeting.normal));
    let velocity = [dot(slip, tangent), dot(slip, cross(meeting.normal, tangent))];
    let (zeta, shift, lead) = (meeting.zeta, velocity.map(|v| v * dt), [0.0; 2]);
    Step { tangent, zeta, shift, velocity, lead }
}

/// 1 over (2 - e), where 1 - e is the cosine of the turn of the normal; of small turns by its series. A
/// normal that turns right round does so about the tangent.
#[inline(always)]
fn over_lean<T: Number>(e: T) -> T {
    let near = |e: T| T::of(0.5) + e * (T::of(0.25) + T::of(0.125) * e);
    let each = |e: f64| if e < 2.0 - 1e-12 { 1.0 / (2.0 - e) } else { 0.0 };
    e.where_small(1e-4, near, each)
}

/// A unit vector across another: which one does not matter, but it is always the same.
fn across(normal: Vector) -> Vector {
    let any = if normal[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let across = minus(any, times(normal, dot(normal, any)));
    times(across, 1.0 / dot(across, across).sqrt())
}

/// Sine and cosine of the turn of one step; small ones by their series.
#[inline(always)]
fn turn<T: Number>(angle: T) -> (T, T) {
    let (one, sixth) = (T::of(1.0), T::of(1.0 / 6.0));
    let sine = |angle: T| angle * (one - (angle * angle) * sixth);
    let cosine = |angle: T| {
        let square = angle * angle;
        one - square * (T::of(0.5) - square * T::of(1.0 / 24.0))
    };
    (angle.where_small(1e-3, sine, libm::sin), angle.where_small(1e-3, cosine, libm::cos))
}
