//! The contact of two grains of any materials, with shift, twist and their coupling.

use carom_special::RangeError;

use super::contact::Heats;
use super::dashpots::Dashpots;
use super::drag_heat::{DragHeat, check_heat};
use super::load::{GrainLoad, compressed, elastic, load_in};
use super::meeting::Meeting;
use super::step::{Before, Ending, Step, first_step, leaves, on_the_way, one_step_before};
use super::vector::{Vector, dot, times};
use crate::damping::HertzDamping;
use crate::law::{ContactLoad, Shift};
use crate::rings::{RingMemory, Rings};

/// The contact of two grains with the load history of the law of rings ([`crate::rings`]), in axes that move
/// with the grains like those of [`super::GrainContact`].
///
/// Approach, shift and twist act together: the coupling of dissimilar materials and the torque about the
/// normal are included. Numerov's correction, the averaging of friction before the gap opens, and damping are
/// those of [`super::GrainContact`]; the twist leads as the shift does. Only friction that is f times the normal force
/// counts as sliding of the whole, so that a contact that spins as it slides does not. Exchanging the grains gives the
/// same bits.
///
/// The constants ([`Rings`]) are passed to each call and must be those with which the contact began.
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_laws::grains::{Grain, GrainRings, Meeting};
/// use carom_laws::rings::{RingMatrices, Tolerance};
/// let matrices = RingMatrices::<6, 8>::new(1.2, 0.25, Friction::new(0.3)?)?;
/// let rings = matrices.contact(1.0, 0.7, Tolerance::PARTICLES)?;
/// let mut contact = GrainRings::new(&rings, 0.0)?;
/// let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
/// let above = Grain { place: [0.0, 0.0, 1.99], velocity: [0.1, 0.0, 0.0], spin: [0.0, 0.0, 1.0], ..below };
/// let load = contact.advance(&rings, &Meeting::of_spheres(&above, &below, [0.5; 2])?, 1e-3)?;
/// // Friction acts against the velocity and against the spin.
/// assert!(load.force[0] < 0.0 && load.torques[0][2] < 0.0 && load.torques[1][2] > 0.0);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct GrainRings<const N: usize = 6, const M: usize = 8> {
    pub(super) memory: RingMemory<N, M>,
    /// The axis x of the contact; zero while the grains are separated.
    pub(super) tangent: Vector,
    pub(super) normal: Vector,
    /// The tangential force of the last step, along x and y.
    pub(super) friction: [f64; 2],
    /// The torque of the last step about the normal, on body 1.
    pub(super) torque: f64,
    /// The damping force of the last step.
    pub(super) drag: f64,
    pub(super) drag_heat: DragHeat,
    /// The velocity of the shift in the last step.
    pub(super) velocity: [f64; 2],
    /// Difference between the shift given to the law and the true shift.
    pub(super) lead: [f64; 2],
    /// The approach after the last step of a damped contact, whose law has the effective one.
    pub(super) approach: f64,
    /// Of a damped contact, the rate of the twist in the last step.
    pub(super) twisting: f64,
    /// Difference between the twist given to the law and the true twist.
    pub(super) twist_lead: f64,
    pub(super) dashpots: Dashpots,
}

/// The load that the law gives at the end of a step.
pub(super) struct Given {
    pub(super) load: ContactLoad,
    pub(super) heat: f64,
}

impl<const N: usize, const M: usize> GrainRings<N, M> {
    /// A contact without history, with a viscous relaxation time A of the materials, s.
    ///
    /// # Errors
    /// [`RangeError`] unless the time is finite and not negative, and the damping force is finite.
    pub fn new(rings: &Rings<'_, N, M>, relaxation: f64) -> Result<Self, RangeError> {
        let dashpots = Dashpots::of_relaxation(relaxation, rings.c_z())?;
        Ok(Self {
            memory: RingMemory::default(),
            tangent: [0.0; 3],
            normal: [0.0; 3],
            friction: [0.0; 2],
            torque: 0.0,
            drag: 0.0,
            drag_heat: DragHeat::default(),
            velocity: [0.0; 2],
            lead: [0.0; 2],
            approach: 0.0,
            twisting: 0.0,
            twist_lead: 0.0,
            dashpots,
        })
    }

    /// The same contact with damping of a given restitution, as [`super::GrainContact::with_restitution`].
    ///
    /// # Errors
    /// As there.
    pub fn with_restitution(mut self, damping: HertzDamping) -> Result<Self, RangeError> {
        self.dashpots = self.dashpots.with_restitution(damping)?;
        Ok(self)
    }

    /// The load history in the axes of the contact.
    #[must_use]
    pub const fn memory(&self) -> &RingMemory<N, M> {
        &self.memory
    }

    /// The axis x of the contact; zero while the grains are separated.
    #[must_use]
    pub const fn tangent(&self) -> [f64; 3] {
        self.tangent
    }

    /// The elastic energy of the contact, as [`super::GrainContact::stored_energy`].
    #[must_use]
    pub fn stored_energy(&self, rings: &Rings<'_, N, M>) -> f64 {
        let stored = self.memory.stored_energy(rings);
        if !self.dashpots.resist() {
            return stored;
        }
        let approaches = [self.approach, self.memory.shift().zeta];
        let [true_one, its] = approaches.map(|zeta| compressed(rings.c_z(), zeta));
        stored + (true_one - its)
    }

    /// Advances by a step of duration `dt`, as [`super::GrainContact::advance`].
    ///
    /// # Errors
    /// [`RangeError`] for a shift that the law does not allow; the contact is then unchanged.
    pub fn advance(
        &mut self,
        rings: &Rings<'_, N, M>,
        meeting: &Meeting,
        dt: f64,
    ) -> Result<GrainLoad, RangeError> {
        self.advance_accounted(rings, meeting, dt, &mut Heats::default())
    }

    /// As [`GrainRings::advance`], and adds the dissipated energy to `heats`, at no further cost.
    ///
    /// # Errors
    /// As [`GrainRings::advance`].
    pub fn advance_accounted(
        &mut self,
        rings: &Rings<'_, N, M>,
        meeting: &Meeting,
        dt: f64,
        heats: &mut Heats,
    ) -> Result<GrainLoad, RangeError> {
        let mut next = *self;
        let (load, friction, damping) = next.moved(rings, meeting, dt)?;
        let parts = [load.force, load.torques[0], load.torques[1]];
        for part in parts.into_iter().flatten() {
            RangeError::finite("load", part)?;
        }
        check_heat(friction + damping)?;
        if self.is_new() && meeting.is_apart() {
            return Ok(GrainLoad::default());
        }
        *self = next;
        heats.friction += friction;
        heats.damping += damping;
        Ok(load)
    }

    /// Advances, and returns the load with the heats of friction and damping.
    fn moved(
        &mut self,
        rings: &Rings<'_, N, M>,
        meeting: &Meeting,
        dt: f64,
    ) -> Result<(GrainLoad, f64, f64), RangeError> {
        if self.dashpots.resist() {
            return self.moved_damped(rings, meeting, dt);
        }
        let (step, given) = match self.is_new() {
            true => self.begin(rings, meeting, dt)?,
            false => self.go_on(rings, meeting, dt)?,
        };
        Ok((self.keep(meeting, &step, given.load), given.heat, 0.0))
    }

    /// The load at the end of the last step, for the bodies as given. A contact without a step has
    /// Hertz's force only.
    #[must_use]
    pub fn load(&self, rings: &Rings<'_, N, M>, meeting: &Meeting) -> GrainLoad {
        if meeting.is_apart() {
            return GrainLoad::default();
        }
        if self.is_new() {
            let force = times(meeting.normal, elastic(rings.c_z(), meeting.zeta));
            return GrainLoad { force, ..GrainLoad::default() };
        }
        self.exerted(meeting, self.memory.load(rings).f_z)
    }

    /// Whether the bodies have not touched yet; the contact then has no history.
    #[must_use]
    pub fn is_new(&self) -> bool {
        self.tangent == [0.0; 3]
    }

    pub(super) fn before(&self) -> Before<f64> {
        let Shift { zeta, xi, eta, .. } = self.memory.shift();
        let zeta = if self.dashpots.resist() { self.approach } else { zeta };
        let (tangent, normal, velocity, lead) =
            (self.tangent, self.normal, self.velocity, self.lead);
        Before { tangent, normal, velocity, lead, zeta, shift: [xi, eta] }
    }

    fn begin(
        &mut self,
        rings: &Rings<'_, N, M>,
        meeting: &Meeting,
        dt: f64,
    ) -> Result<(Step, Given), RangeError> {
        let step = first_step(meeting, dt);
        let mut memory = self.memory;
        memory.advance(rings, one_step_before(meeting, dt))?;
        let heat = memory.advance(rings, Shift { omega: turned(meeting, dt), ..step.to() })?;
        self.memory = memory;
        Ok((step, Given { load: memory.load(rings), heat }))
    }

    fn go_on(
        &mut self,
        rings: &Rings<'_, N, M>,
        meeting: &Meeting,
        dt: f64,
    ) -> Result<(Step, Given), RangeError> {
        let from = self.memory.shift();
        let step = self.before().step(meeting, dt);
        let to = Shift { omega: from.omega + turned(meeting, dt), ..step.to() };
        if leaves(meeting, dt) {
            return Ok((step, self.leave(rings, to, Ending::of(meeting, dt))?));
        }
        let heat = self.memory.advance(rings, to)?;
        Ok((step, Given { load: self.memory.load(rings), heat }))
    }

    /// A step in which friction is averaged over half a step before its end and half a step after it.
    #[inline(never)]
    fn leave(
        &mut self,
        rings: &Rings<'_, N, M>,
        to: Shift,
        ending: Ending,
    ) -> Result<Given, RangeError> {
        let from = self.memory.shift();
        let loaded = |mut memory: RingMemory<N, M>, part: f64| {
            let heat = memory.advance(rings, on_the_way(from, to, part))?;
            Ok((memory, Given { load: memory.load(rings), heat }))
        };
        let (_, Given { load: past, .. }) = loaded(self.memory, 0.5)?;
        let (memory, Given { load: now, heat }) = loaded(self.memory, 1.0)?;
        let (_, Given { load: ahead, .. }) = loaded(memory, 1.5)?;
        self.memory = memory;
        let mean = |of: fn(&ContactLoad) -> f64| ending.mean(of(&past), of(&now), of(&ahead));
        let load = ContactLoad {
            f_x: mean(|load| load.f_x),
            f_y: mean(|load| load.f_y),
            m_z: mean(|load| load.m_z),
            ..now
        };
        Ok(Given { load, heat })
    }

    pub(super) fn keep(&mut self, meeting: &Meeting, step: &Step, load: ContactLoad) -> GrainLoad {
        (self.tangent, self.normal) = (step.tangent, meeting.normal);
        (self.velocity, self.lead) = (step.velocity, step.lead);
        self.friction = [load.f_x, load.f_y];
        // The law counts twist and torque clockwise.
        self.torque = -load.m_z;
        self.exerted(meeting, load.f_z)
    }

    fn exerted(&self, meeting: &Meeting, normal_force: f64) -> GrainLoad {
        let axes = [self.tangent, meeting.normal];
        let mut load = load_in(axes, meeting.arms, normal_force, self.friction);
        for ((torque, arm), sign) in load.torques.iter_mut().zip(meeting.arms).zip([1.0, -1.0]) {
            // A wall has no arm and no torque.
            if arm != 0.0 {
                for (torque, normal) in torque.iter_mut().zip(meeting.normal) {
                    *torque += sign * self.torque * normal;
                }
            }
        }
        load
    }
}

/// The twist during a step, clockwise as in the law.
pub(super) fn turned(meeting: &Meeting, dt: f64) -> f64 {
    -dot(meeting.twisting(), meeting.normal) * dt
}
