//! The contact of two grains, advanced with their motion.

use std::mem::offset_of;

use carom_special::RangeError;

use super::account::{Accounted, Unaccounted};
use super::dashpots::Dashpots;
use super::drag_heat::check_heat;
use super::frame::GrainFrame;
use super::heats::Heats;
use super::law::GrainLaw;
use super::load::{GrainLoad, compressed, elastic, load_in};
use super::meeting::Meeting;
use super::step::{Before, Step};
use super::twisted::{TwistState, Twisted};
use super::vector::times;
use crate::damping::HertzDamping;
use crate::law::{ContactLoad, Shift};
use crate::memory::Fixed;
use crate::shift_law::ShiftLaw;

/// The contact of two grains with its load history: a law in axes that move with the grains.
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
///
/// With [`crate::rings::RingLaw`] the coupling of dissimilar materials and the torque about the normal are included, and
/// the twist leads as the shift does. Only friction that is f times the normal force then counts as sliding of the
/// whole, so that a contact that spins as it slides does not. Exchanging the grains gives the same bits.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::grains::{Grain, GrainContact, Meeting};
/// use carom_laws::rings::{RingConstants, RingLaw, Tolerance};
/// let constants = RingConstants { c_z: 1.0, radius: 0.7, kappa: 1.2, gamma: 0.25 };
/// let law = RingLaw::<6, 8>::from_constants(constants, Friction::new(0.3)?, Tolerance::GRAINS)?;
/// let mut contact = GrainContact::new(law, 0.0)?;
/// let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
/// let above = Grain { place: [0.0, 0.0, 1.99], velocity: [0.1, 0.0, 0.0], spin: [0.0, 0.0, 1.0], ..below };
/// let load = contact.advance(&Meeting::of_spheres(&above, &below, [0.5; 2])?, 1e-3)?;
/// // Friction acts against the velocity and against the spin.
/// assert!(load.force[0] < 0.0 && load.torques[0][2] < 0.0 && load.torques[1][2] > 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[repr(C)]
pub struct GrainContact<L: GrainLaw = ShiftLaw<[f64; 2]>> {
    pub(super) law: L,
    pub(super) frame: GrainFrame<L::Twist>,
}

impl<L: GrainLaw + Copy> Copy for GrainContact<L> {}

impl<L: GrainLaw> GrainContact<L> {
    /// A contact without history, from a law in its initial state and a viscous relaxation time A
    /// of the materials, s.
    ///
    /// # Errors
    /// [`RangeError`] unless the time is finite and not negative, and the damping force is finite.
    pub fn new(law: L, relaxation: f64) -> Result<Self, RangeError> {
        let dashpots = Dashpots::of_relaxation(relaxation, law.hertz_stiffness())?;
        Ok(Self { law, frame: GrainFrame::apart(dashpots) })
    }

    /// The same contact with damping of a given restitution.
    ///
    /// # Errors
    /// [`RangeError`] of `relaxation` if it is above 0 and the restitution below 1: both would count the same loss.
    pub fn with_restitution(mut self, damping: HertzDamping) -> Result<Self, RangeError> {
        self.frame.dashpots = self.frame.dashpots.with_restitution(damping)?;
        Ok(self)
    }

    /// The contact of a law and the rest of its state, as [`GrainContact::frame`] gave it.
    #[must_use]
    pub const fn of_parts(law: L, frame: GrainFrame<L::Twist>) -> Self {
        Self { law, frame }
    }

    /// The law, in the axes of the contact.
    #[must_use]
    pub const fn law(&self) -> &L {
        &self.law
    }

    /// The state beside the law.
    #[must_use]
    pub const fn frame(&self) -> &GrainFrame<L::Twist> {
        &self.frame
    }

    /// The axis x of the contact; zero while the grains are separated.
    #[must_use]
    pub const fn tangent(&self) -> [f64; 3] {
        self.frame.tangent
    }

    /// The elastic energy of the contact: of compression by the approach, and of the tangential load.
    #[must_use]
    pub fn stored_energy(&self) -> f64 {
        let stored = self.law.stored_energy();
        if !self.frame.dashpots.resist() {
            return stored;
        }
        let c_z = self.law.hertz_stiffness();
        let [true_one, its] =
            [self.frame.approach, self.law.shift().zeta].map(|z| compressed(c_z, z));
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
    /// use carom_laws::shift_law::ShiftLaw;
    /// use carom_laws::stiffness::ContactStiffness;
    /// let law = ShiftLaw::<[f64; 2]>::new(ContactStiffness::new(1.0, 1.0, 1.2)?, Friction::new(0.3)?);
    /// let mut contact = GrainContact::new(law, 0.0)?;
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
        if L::Twist::COUNTS {
            *load = self.advance_accounted(meeting, dt, &mut Heats::default())?;
            return Ok(());
        }
        if self.frame.dashpots.resist() {
            return self.advance_damped(meeting, dt, load);
        }
        self.go_undamped(meeting, dt, load, &mut Unaccounted)
    }

    /// As [`GrainContact::advance`], and adds the dissipated energy to `heats`. The energy of
    /// damping is integrated to the fourth order of the step; in the steps in which contact begins and
    /// ends, to the order 2.5.
    /// Friction gets the work of its force less the increase of the stored energy; in a step in which the force has a
    /// kink, to 1e-4 of that work. With rings, whose heat is traction times slip, it costs nothing.
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
        let mut next = self.clone();
        let load = next.go(meeting, dt, heats)?;
        if !(self.is_new() && meeting.is_apart()) {
            *self = next;
        }
        Ok(load)
    }

    /// As [`GrainContact::advance_into`], and adds the heat to sums if they are given.
    ///
    /// # Errors
    /// As [`GrainContact::advance`].
    #[inline(always)]
    pub fn advance_with(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        load: &mut GrainLoad,
        heats: Option<&mut Heats>,
    ) -> Result<(), RangeError> {
        match heats {
            None => self.advance_into(meeting, dt, load),
            // A copy, so that the meeting itself stays in registers where no heat is asked for.
            Some(sums) => {
                *load = self.advance_accounted(&{ *meeting }, dt, sums)?;
                Ok(())
            }
        }
    }

    /// A step with its heats, of a contact that is not kept if it fails, or is new and stays apart.
    fn go(
        &mut self,
        meeting: &Meeting,
        dt: f64,
        heats: &mut Heats,
    ) -> Result<GrainLoad, RangeError> {
        let (mut load, mut account) = (GrainLoad::default(), Accounted::default());
        let (mut damping, stays_apart) = (0.0, self.is_new() && meeting.is_apart());
        if self.frame.dashpots.resist() {
            damping = self.go_damped_accounted(meeting, dt, &mut load, &mut account)?;
        } else {
            self.go_undamped(meeting, dt, &mut load, &mut account)?;
        }
        if stays_apart {
            return Ok(GrainLoad::default());
        }
        check_heat(account.loss + damping)?;
        for part in load.torques.iter().chain([&load.force]).flatten() {
            RangeError::finite("load", *part)?;
        }
        heats.friction += account.loss;
        heats.damping += damping;
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
            let force = elastic(self.law.hertz_stiffness(), meeting.zeta);
            return GrainLoad { force: times(meeting.normal, force), ..GrainLoad::default() };
        }
        let is_damped = self.frame.dashpots.resist();
        let bearing = if is_damped { self.law.shift().zeta } else { meeting.zeta };
        self.exerted(meeting, self.law.bears(bearing))
    }

    /// Whether the bodies have not touched yet; the contact then has no history.
    #[must_use]
    pub fn is_new(&self) -> bool {
        self.frame.tangent == [0.0; 3]
    }

    /// Whether the bodies overlapped at the end of the last step; a damped contact may then bear nothing all the same.
    #[inline]
    #[must_use]
    pub fn overlaps(&self) -> bool {
        self.approach() > 0.0
    }

    /// The approach at the end of the last step.
    #[inline(always)]
    fn approach(&self) -> f64 {
        if self.frame.dashpots.resist() { self.frame.approach } else { self.law.shift().zeta }
    }

    #[inline(always)]
    pub(super) fn before(&self) -> Before<f64> {
        let Shift { xi, eta, .. } = self.law.shift();
        let GrainFrame { tangent, normal, velocity, lead, .. } = self.frame;
        Before { tangent, normal, velocity, lead, zeta: self.approach(), shift: [xi, eta] }
    }

    #[inline(always)]
    pub(super) fn keep(&mut self, meeting: &Meeting, step: &Step, end: ContactLoad) -> GrainLoad {
        let frame = &mut self.frame;
        (frame.tangent, frame.normal) = (step.tangent, meeting.normal);
        (frame.velocity, frame.lead) = (step.velocity, step.lead);
        frame.friction = [end.f_x, end.f_y];
        // The law counts twist and torque clockwise.
        frame.twist = TwistState::of(Twisted { torque: -end.m_z, ..frame.twist.get() });
        self.exerted(meeting, end.f_z)
    }

    #[inline(always)]
    fn exerted(&self, meeting: &Meeting, normal_force: f64) -> GrainLoad {
        let axes = [self.frame.tangent, meeting.normal];
        let mut load = load_in(axes, meeting.arms, normal_force, self.frame.friction);
        if L::Twist::COUNTS {
            load.couple(meeting, times(meeting.normal, self.frame.twist.get().torque));
        }
        load
    }
}

impl<const N: usize> GrainContact<ShiftLaw<[f64; 2], Fixed<[f64; 2], N>>> {
    /// Whether bytes that may have been changed elsewhere are a valid contact, as
    /// [`ShiftLaw::is_in`].
    #[inline(always)]
    #[must_use]
    pub fn is_in(byte: impl Fn(usize) -> u8) -> bool {
        ShiftLaw::<[f64; 2], Fixed<[f64; 2], N>>::is_in(|at| byte(offset_of!(Self, law) + at))
    }
}
