//! The contact of two grains, advanced with their motion.

use std::mem::offset_of;

use carom_special::RangeError;

use super::meeting::Meeting;
use super::number::Number;
use super::vector::{Vector, cross, dot, minus, plus, times};
use crate::law::{ContactLaw, ContactLoad, Dissipative, Shift};
use crate::memory::{Fixed, Growing, VertexStack};
use crate::shift_law::ShiftLaw;

/// The contact of two grains with its load history: a shift law in axes that move with the grains.
///
/// From step to step the axes follow the normal by the smallest rotation, and rotate about the
/// normal with the mean of the two spins, so that stored vectors keep their components. A step is
/// measured in the axes at its middle: a pair that rotates as a whole does not slip, to second
/// order in the step. The first step of a contact starts from the positions one step before, so
/// that first contact is found.
///
/// Two corrections remove most of the error of a leapfrog integrator in the tangential motion.
/// First, the law is given the shift `xi + dt^2 xi''/12` instead of xi (Numerov), where the
/// acceleration is taken from the last two velocities; errors of second order then cancel, and
/// without acceleration no force changes. An oscillation without slip loses `(omega dt)^4/24` of
/// its amplitude per step and is stable up to `omega dt = sqrt 3`; the limit of the leapfrog is 2.
/// Second, if the gap opens within four steps, friction is averaged over the neighbouring half
/// steps, because it then decreases with the power 3/2 of the time.
///
/// Damping is that of a viscoelastic material in the quasi-static limit: it adds `(2/3) c_z (3/2) A
/// sqrt(zeta) dzeta/dt` to Hertz's force, with a relaxation time A of the material. The sum with
/// Hertz's force is never tensile. The friction limit depends on Hertz's force only.
#[derive(Debug, Clone, PartialEq)]
#[repr(C)]
pub struct GrainContact<S: VertexStack<[f64; 2]> = Growing<[f64; 2]>> {
    pub(super) law: ShiftLaw<[f64; 2], S>,
    /// The axis x of the contact; zero while the grains are separated.
    pub(super) tangent: Vector,
    pub(super) normal: Vector,
    /// The tangential force of the last step, along x and y.
    pub(super) friction: [f64; 2],
    /// The damping force of the last step.
    pub(super) drag: f64,
    /// The velocity of the shift in the last step.
    pub(super) velocity: [f64; 2],
    /// Difference between the shift given to the law and the true shift.
    pub(super) lead: [f64; 2],
    /// The damping force divided by `sqrt(zeta) dzeta/dt`.
    pub(super) viscosity: f64,
}

/// The load that body 2 exerts on body 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct GrainLoad {
    /// The force on body 1, N; the force on body 2 is the opposite.
    pub force: [f64; 3],
    /// The torque on each body about its centre, `-arm normal x force`, N m; zero for a wall.
    pub torques: [[f64; 3]; 2],
}

/// Dissipated energy, by cause, J.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Heats {
    /// Friction heat, including the energy released at a receding edge.
    pub friction: f64,
    /// Energy dissipated by the viscoelastic material.
    pub damping: f64,
}

/// The state of a contact before a step, as far as the step needs it.
pub(super) struct Before<T> {
    pub(super) tangent: Vector<T>,
    pub(super) normal: Vector<T>,
    pub(super) velocity: [T; 2],
    pub(super) lead: [T; 2],
    /// The shift that the law was given.
    pub(super) shift: [T; 2],
}

/// The end of a step.
pub(super) struct Step<T = f64> {
    pub(super) tangent: Vector<T>,
    pub(super) zeta: T,
    /// The shift that the law is given.
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

/// Friction is averaged if the gap opens within this number of steps.
const STEPS_TO_OPENING: f64 = 4.0;

impl<S: VertexStack<[f64; 2]> + Copy> Copy for GrainContact<S> where S::Curve: Copy {}

impl<S: VertexStack<[f64; 2]>> GrainContact<S> {
    /// A contact without history, from a law in its initial state and a viscous relaxation time A
    /// of the materials, s.
    ///
    /// # Errors
    /// [`RangeError`] unless the time is finite and not negative, and the damping force is finite.
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

    /// The shift law, in the axes of the contact.
    #[must_use]
    pub fn law(&self) -> &ShiftLaw<[f64; 2], S> {
        &self.law
    }

    /// The axis x of the contact; zero while the grains are separated.
    #[must_use]
    pub fn tangent(&self) -> [f64; 3] {
        self.tangent
    }

    /// The elastic energy of the contact, including compression.
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        self.law.stored_energy()
    }

    /// Advances by a step of duration `dt`, at the end of which the bodies are as given. The
    /// velocities are those that moved them there; for a leapfrog those at the middle of the step.
    ///
    /// [`RangeError`] for a shift that the law does not allow; the contact is then unchanged.
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

    /// As [`GrainContact::advance`], and adds the dissipated energy to `heats`. The energy of
    /// damping is integrated by the trapezoidal rule.
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

    /// The load at the end of the last step, for the bodies as given. A contact without a step has
    /// Hertz's force only.
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

    /// A step in which friction is averaged over half a step before its end and half a step after
    /// it.
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
    /// Whether bytes that may have been changed elsewhere are a valid contact, as
    /// [`ShiftLaw::is_in`].
    #[inline(always)]
    #[must_use]
    pub fn is_in(byte: impl Fn(usize) -> u8) -> bool {
        ShiftLaw::<[f64; 2], Fixed<[f64; 2], N>>::is_in(|at| byte(offset_of!(Self, law) + at))
    }
}

impl<T: Number> Before<T> {
    /// The end of a step of duration `dt`.
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

    /// The tangent, rotated with the normal and by an angle about it.
    #[inline(always)]
    fn carried(&self, meeting: &Meeting<T>, angle: T) -> Vector<T> {
        let (old, new) = (self.normal, meeting.normal);
        let tilt = dot(self.tangent, new) * over_lean(T::of(1.0) - dot(old, new));
        let tangent = minus(self.tangent, times(plus(old, new), tilt));
        let (sine, cosine) = turn(angle);
        let turned = plus(times(tangent, cosine), times(cross(new, tangent), sine));
        // Rounding must not accumulate: the correction removes any component along the normal, and
        // one Newton step restores unit length.
        times(turned, T::of(1.5) - T::of(0.5) * dot(turned, turned))
    }
}

/// Hertz's force (5.27).
#[inline(always)]
pub(super) fn elastic<T: Number>(c_z: T, zeta: T) -> T {
    let zeta = zeta.larger(T::of(0.0));
    T::of(2.0 / 3.0) * c_z * (zeta * zeta.sqrt())
}

/// The damping force; its sum with Hertz's force is never tensile.
#[inline(always)]
pub(super) fn drag<T: Number>(viscosity: T, meeting: &Meeting<T>, elastic: T) -> T {
    let speed = dot(meeting.velocity, meeting.normal);
    let root = meeting.zeta.larger(T::of(0.0)).sqrt();
    (viscosity * root * speed).larger(T::of(0.0) - elastic)
}

/// The force on body 1 and the torques on both bodies, in the axes of tangent and normal.
#[inline(always)]
pub(super) fn forces<T: Number>(
    [tangent, normal]: [Vector<T>; 2],
    arms: [T; 2],
    normal_force: T,
    [x, y]: [T; 2],
) -> [Vector<T>; 3] {
    let along = cross(normal, tangent);
    let friction = plus(times(tangent, x), times(along, y));
    // normal x tangent is the second axis, normal x second axis is minus the tangent; the torque on
    // body 1 is - arm normal x force.
    let couple = minus(times(tangent, y), times(along, x));
    let [torque_1, torque_2] = arms.map(|arm| times(couple, arm));
    [plus(times(normal, normal_force), friction), torque_1, torque_2]
}

#[inline]
fn load_in(axes: [Vector; 2], arms: [f64; 2], normal_force: f64, friction: [f64; 2]) -> GrainLoad {
    let [force, torque_1, torque_2] = forces(axes, arms, normal_force, friction);
    GrainLoad { force, torques: [torque_1, torque_2] }
}

/// Whether the gap opens within a few steps.
#[inline]
fn leaves(meeting: &Meeting, dt: f64) -> bool {
    parting(meeting, dt) < -meeting.zeta
}

/// The growth of the approach in this number of steps.
#[inline(always)]
pub(super) fn parting<T: Number>(meeting: &Meeting<T>, dt: f64) -> T {
    T::of(STEPS_TO_OPENING * dt) * dot(meeting.velocity, meeting.normal)
}

/// The positions one step before, where first contact is searched from.
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

/// 1/(2 - e), where 1 - e is the cosine of the rotation of the normal; by its series for small
/// rotations. A normal that is reversed is rotated about the tangent.
#[inline(always)]
fn over_lean<T: Number>(e: T) -> T {
    let near = |e: T| T::of(0.5) + e * (T::of(0.25) + T::of(0.125) * e);
    let each = |e: f64| if e < 2.0 - 1e-12 { 1.0 / (2.0 - e) } else { 0.0 };
    e.where_small(1e-4, near, each)
}

/// A unit vector perpendicular to another one; arbitrary but always the same.
fn across(normal: Vector) -> Vector {
    let any = if normal[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let across = minus(any, times(normal, dot(normal, any)));
    times(across, 1.0 / dot(across, across).sqrt())
}

/// Sine and cosine of the rotation of one step; by series for small angles.
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
