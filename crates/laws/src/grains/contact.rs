//! The contact of two grains, advanced with their motion.

use std::mem::offset_of;

use carom_special::RangeError;

use super::dashpots::Dashpots;
use super::drag_heat::{DragHeat, check_heat};
use super::load::{GrainLoad, check_beside, compressed, elastic, load_in};
use super::meeting::Meeting;
use super::step::{Before, Ending, Step, first_step, leaves, on_the_way, one_step_before};
use super::vector::{Vector, times};
use crate::damping::HertzDamping;
use crate::law::{Checked, ContactLaw, ContactLoad, Dissipative, Shift};
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
/// Second, if the gap opens within four steps and nothing is damped, friction is averaged over the neighbouring half
/// steps, because it then decreases with the power 3/2 of the time. What is left for the step in
/// which the gap opens acts one step before, because bodies that are apart exert no force.
///
/// Damping is that of viscous materials ([`crate::viscous`]), with a relaxation time A or with a [given
/// restitution](GrainContact::with_restitution) at any speed ([`HertzDamping`]), which needs the masses. The law is then
/// driven by the effective approach, at which the elastic contact bears the whole normal force, and by a shift that leads
/// by theta times its rate. The limit of friction is f times the whole normal force, and friction ends with it.
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
    /// Of the last step of a damped contact.
    pub(super) drag_heat: DragHeat,
    /// The velocity of the shift in the last step.
    pub(super) velocity: [f64; 2],
    /// Difference between the shift given to the law and the true shift.
    pub(super) lead: [f64; 2],
    /// The approach after the last step of a damped contact, whose law has the effective one.
    pub(super) approach: f64,
    pub(super) dashpots: Dashpots,
}

/// Dissipated energy, by cause, J. Steps add to it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[repr(C)]
pub struct Heats {
    /// Friction heat, including the energy released at a receding edge, and what a contact loses
    /// where it simplifies its memory; a step may lower it a little.
    pub friction: f64,
    /// Energy dissipated by the viscous material: the rest of the work. While a contact slides, the heat of friction is
    /// ahead by the force times the lead of the shift, and this one behind by as much, which may make it negative; where
    /// the motion has ended it is not.
    pub damping: f64,
}

impl<S: VertexStack<[f64; 2]> + Copy> Copy for GrainContact<S> where S::Curve: Copy {}

impl<S: VertexStack<[f64; 2]>> GrainContact<S> {
    /// A contact without history, from a law in its initial state and a viscous relaxation time A
    /// of the materials, s.
    ///
    /// # Errors
    /// [`RangeError`] unless the time is finite and not negative, and the damping force is finite.
    pub fn new(law: ShiftLaw<[f64; 2], S>, relaxation: f64) -> Result<Self, RangeError> {
        let dashpots = Dashpots::of_relaxation(relaxation, law.stiffness().c_z)?;
        let (none, drag) = ([0.0; 2], 0.0);
        let (tangent, normal) = ([0.0; 3], [0.0; 3]);
        Ok(Self {
            law,
            tangent,
            normal,
            friction: none,
            drag,
            drag_heat: DragHeat::default(),
            velocity: none,
            lead: none,
            approach: 0.0,
            dashpots,
        })
    }

    /// The same contact with damping of a given restitution.
    ///
    /// # Errors
    /// [`RangeError`] of `relaxation` if it is above 0 and the restitution below 1: both would count the same loss.
    pub fn with_restitution(mut self, damping: HertzDamping) -> Result<Self, RangeError> {
        self.dashpots = self.dashpots.with_restitution(damping)?;
        Ok(self)
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

    /// The elastic energy of the contact: of compression by the approach, and of the tangential load.
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        let stored = self.law.stored_energy();
        if !self.dashpots.resist() {
            return stored;
        }
        let c_z = self.law.stiffness().c_z;
        let [true_one, its] = [self.approach, self.law.shift().zeta].map(|z| compressed(c_z, z));
        stored + (true_one - its)
    }

    /// Advances by a step of duration `dt`, at the end of which the bodies are as given. The
    /// velocities are those that moved them there; for a leapfrog those at the middle of the step.
    /// Bodies that are apart at the end exert no force; a new contact then remains new.
    ///
    /// # Errors
    /// [`RangeError`] for a shift that the law does not allow, or an arm or a damping force beyond all range; the
    /// contact is then unchanged.
    #[inline(always)]
    pub fn advance(&mut self, meeting: &Meeting, dt: f64) -> Result<GrainLoad, RangeError> {
        let mut load = GrainLoad::default();
        self.advance_into(meeting, dt, &mut load)?;
        Ok(load)
    }

    /// As [`GrainContact::advance`], and writes the load to its place instead of returning it, which takes less time.
    /// It is not written if the step fails.
    ///
    /// ```
    /// use carom_laws::friction::Friction;
    /// use carom_laws::grains::{Grain, GrainContact, GrainLoad, Meeting};
    /// use carom_laws::memory::Fixed;
    /// use carom_laws::shift_law::ShiftLaw;
    /// use carom_laws::stiffness::ContactStiffness;
    /// let law = ShiftLaw::new(ContactStiffness::new(1.0, 1.0, 1.2)?, Friction::new(0.3)?);
    /// let mut contact = GrainContact::<Fixed<_, 12>>::new(law, 0.0)?;
    /// let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
    /// let above = Grain { place: [0.0, 0.0, 1.99], ..below };
    /// let mut load = GrainLoad::default();
    /// contact.advance_into(&Meeting::of_spheres(&above, &below, [0.5; 2])?, 1e-3, &mut load)?;
    /// assert!((load.force[2] - 1.2 * 2.0 / 3.0 * 0.01_f64.powf(1.5)).abs() < 1e-15);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// As [`GrainContact::advance`].
    #[inline(always)]
    pub fn advance_into(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
    ) -> Result<(), RangeError> {
        if self.dashpots.resist() {
            return self.advance_damped(meeting, dt, load);
        }
        // A call that is not inlined gets a copy, so that the meeting itself stays in registers in all other steps.
        if self.is_new() {
            return self.begin(&{ *meeting }, dt, load);
        }
        if leaves(meeting, dt) {
            return self.leave(&{ *meeting }, dt, load);
        }
        let step = self.before().step(meeting, dt);
        self.check_beside(meeting, step.to())?;
        let end = self.law.advance(step.to())?;
        *load = self.keep(meeting, &step, end, [end.f_x, end.f_y]);
        Ok(())
    }

    /// As [`GrainContact::advance`], and adds the dissipated energy to `heats`. The energy of
    /// damping is integrated to the fourth order of the step; in the steps in which contact begins and
    /// ends, to the order 2.5.
    /// Friction gets the work of its force less the increase of the stored energy; in a step in which the force has a
    /// kink, to 1e-4 of that work.
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
        if self.is_new() && meeting.is_apart() {
            return self.advance(meeting, dt);
        }
        if self.dashpots.resist() {
            return self.advance_damped_accounted(meeting, dt, heats);
        }
        let friction = if self.is_new() {
            let (mut law, before) = (self.law.clone(), one_step_before(meeting, dt));
            law.advance(before)?;
            law.loss(first_step(meeting, dt).to())
        } else {
            self.law.loss(self.before().step(meeting, dt).to())
        };
        check_heat(friction)?;
        let load = self.advance(meeting, dt)?;
        heats.friction += friction;
        Ok(load)
    }

    /// The load at the end of the last step, for the bodies as given. A contact without a step has
    /// Hertz's force only.
    #[inline]
    #[must_use]
    pub fn load(&self, meeting: &Meeting) -> GrainLoad {
        if meeting.is_apart() {
            return GrainLoad::default();
        }
        if self.is_new() {
            let force = times(meeting.normal, self.elastic(meeting.zeta));
            return GrainLoad { force, ..GrainLoad::default() };
        }
        let bearing = if self.dashpots.resist() { self.law.shift().zeta } else { meeting.zeta };
        let normal_force = self.elastic(bearing);
        load_in([self.tangent, meeting.normal], meeting.arms, normal_force, self.friction)
    }

    /// Whether the bodies have not touched yet; the contact then has no history.
    #[must_use]
    pub fn is_new(&self) -> bool {
        self.tangent == [0.0; 3]
    }

    /// Whether the bodies overlapped at the end of the last step; a damped contact may then bear nothing all the same.
    #[inline]
    #[must_use]
    pub fn overlaps(&self) -> bool {
        let approach = if self.dashpots.resist() { self.approach } else { self.law.shift().zeta };
        approach > 0.0
    }

    #[inline]
    fn elastic(&self, zeta: f64) -> f64 {
        elastic(self.law.stiffness().c_z, zeta)
    }

    /// Checks that no part of the load of a step overflows, whose shift is this.
    #[inline(always)]
    fn check_beside(&self, meeting: &Meeting, to: Shift) -> Result<(), RangeError> {
        check_beside(meeting.arms, 0.0).map_err(|error| self.first_one(to, error))
    }

    /// The error of the law if it does not allow the step, which comes first.
    #[cold]
    fn first_one(&self, to: Shift, error: RangeError) -> RangeError {
        self.law.check(to).err().unwrap_or(error)
    }

    #[inline(always)]
    pub(super) fn before(&self) -> Before<f64> {
        let Shift { zeta, xi, eta, .. } = self.law.shift();
        let zeta = if self.dashpots.resist() { self.approach } else { zeta };
        let (tangent, normal, velocity, lead) =
            (self.tangent, self.normal, self.velocity, self.lead);
        Before { tangent, normal, velocity, lead, zeta, shift: [xi, eta] }
    }

    #[inline(never)]
    fn begin(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
    ) -> Result<(), RangeError> {
        let (before, step) = (one_step_before(meeting, dt), first_step(meeting, dt));
        before.check_finite()?;
        step.to().check_finite()?;
        let mut law = self.law.clone();
        law.advance(before)?;
        let end = law.advance(step.to())?;
        check_beside(meeting.arms, 0.0)?;
        if meeting.is_apart() {
            *load = GrainLoad::default();
            return Ok(());
        }
        self.law = law;
        *load = self.keep(meeting, &step, end, [end.f_x, end.f_y]);
        Ok(())
    }

    /// A step in which friction is averaged over half a step before its end and half a step after
    /// it.
    #[inline(never)]
    fn leave(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
    ) -> Result<(), RangeError> {
        let step = self.before().step(meeting, dt);
        let (from, to) = (self.law.shift(), step.to());
        let between = |part: f64| on_the_way(from, to, part);
        self.check_beside(meeting, to)?;
        let (mut law, mut past) = (self.law.clone(), self.law.clone());
        let past = past.advance(between(0.5))?;
        let end = law.advance(to)?;
        let mut ahead = law.clone();
        let ahead = ahead.advance(between(1.5))?;
        self.law = law;
        let ending = Ending::of(meeting, dt);
        let friction =
            [ending.mean(past.f_x, end.f_x, ahead.f_x), ending.mean(past.f_y, end.f_y, ahead.f_y)];
        *load = self.keep(meeting, &step, end, friction);
        Ok(())
    }

    #[inline(always)]
    fn keep(
        &mut self,
        meeting: &Meeting,
        step: &Step,
        end: ContactLoad,
        friction: [f64; 2],
    ) -> GrainLoad {
        (self.tangent, self.normal) = (step.tangent, meeting.normal);
        (self.friction, self.velocity, self.lead) = (friction, step.velocity, step.lead);
        load_in([step.tangent, meeting.normal], meeting.arms, end.f_z, friction)
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
