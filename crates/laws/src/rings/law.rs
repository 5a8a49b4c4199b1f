//! The law of rings in the user's units.

use std::sync::Arc;

use carom_special::RangeError;

use super::constants::{RingConstants, Tolerance};
use super::matrices::{RingMatrices, Rings};
use super::memory::RingMemory;
use super::symmetry::{AlikePlane, Plane, Symmetry, Whole};
use super::units::Units;
use crate::friction::Friction;
use crate::hertz::Hertz;
use crate::law::{Checked, ContactLaw, ContactLoad, Dissipative, ImpactLaw, Shift};
use crate::slip_lag::SlipLag;

/// The contact law of spheres and planes of dissimilar materials, with memory: approach, shift in two
/// directions and twist act together with their coupling.
///
/// The contact is divided into N rings of M angles (4 to 24; 8, 16 or 32). 6 x 8, the default, is for
/// particles; 8 x 8 to 16 x 16 are for single contacts. On smooth paths that turn all the time the mean error of the
/// forces of 6 x 8 against a grid of 52 x 52 cells was .003 to .018 of f F_z, the largest .039 (8 drawn paths); that of
/// the torque of a pure twist was up to .025 of f F_z a.
///
/// A step allocates nothing. Laws of the same two materials are best cloned from one another: they then share
/// the matrices of the pair.
///
/// A step goes straight from one shift to the next. In a step that closes the gap only the part in contact
/// counts. An approach that is not positive separates the bodies: the history is lost, and the energy stored
/// by the tangential tractions becomes heat.
///
/// Of dissimilar bodies the one whose surface is drawn inwards more by pressure (gamma > 0) is taken as body
/// 1, so that exchanging the bodies gives the same bits.
///
/// Where f gamma exceeds 1 and shifts exceed the approach the law is rough: the bodies part on one side, which it
/// cannot show (F_z up to 15 times that of Hertz was found at shifts of 100 approaches).
///
/// With infinite friction the contact sticks, and only the load at a receding rim is lost. Without friction
/// only the force of Hertz remains. F_z is that of Hertz if gamma = 0.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::curvature::RelativeCurvature;
/// use carom_laws::friction::Friction;
/// use carom_laws::hertz::Hertz;
/// use carom_laws::law::{ContactLaw, Shift};
/// use carom_laws::rings::{RingLaw, Tolerance};
/// let ball = Material::from_young(380e9, 0.23)?;
/// let plate = Material::from_young(70e9, 0.25)?;
/// let gap = RelativeCurvature::from_coefficients(100.0, 100.0)?;
/// let hertz = Hertz::new(gap, MaterialPair::new(ball, plate)?)?;
/// let mut law = RingLaw::<6, 8>::new(&hertz, Friction::new(0.1)?, Tolerance::PARTICLES)?;
/// law.advance(Shift { zeta: 1e-6, ..Shift::default() })?;
/// let load = law.advance(Shift { zeta: 1e-6, xi: 3e-8, omega: 5e-4, ..Shift::default() })?;
/// // Twist and coupling together give a force along y.
/// assert!(load.f_x > 0.0 && load.m_z > 0.0 && load.f_y.abs() > 5e-4 * load.f_x);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct RingLaw<const N: usize = 6, const M: usize = 8, S: Symmetry<M> = Whole> {
    matrices: Arc<RingMatrices<N, M, S>>,
    units: Units,
    tolerance: f64,
    memory: RingMemory<N, M>,
    iterations: usize,
}

impl<const N: usize, const M: usize> RingLaw<N, M> {
    /// A law in its initial state, the bodies just touching.
    ///
    /// # Errors
    /// [`RangeError`] unless the contact is a circle, and for gamma beyond -1/2 to 1/2 (which asks for a negative
    /// Poisson's ratio) under friction above 2, where tractions would not stay bounded.
    pub fn new(
        hertz: &Hertz,
        friction: Friction,
        tolerance: Tolerance,
    ) -> Result<Self, RangeError> {
        Self::from_constants(RingConstants::of(hertz)?, friction, tolerance)
    }

    /// The law of a contact with known constants, in its initial state.
    ///
    /// The first law of a size takes some 0.01 s, each further pair of materials 0.1 ms (6 x 8) to 2 ms;
    /// matrices of the most recent pairs are cached.
    ///
    /// # Errors
    /// [`RangeError`] for a constant that is out of range, and for gamma beyond -1/2 to 1/2 under friction above 2.
    pub fn from_constants(
        constants: RingConstants,
        friction: Friction,
        tolerance: Tolerance,
    ) -> Result<Self, RangeError> {
        Self::at_rest(constants, friction, tolerance)
    }
}

impl<const N: usize, const M: usize> RingLaw<N, M, Plane> {
    /// The law of shifts along x without twist, in its initial state, at half the cost: angles beyond half a
    /// turn are mirror images. M is 5 for 8 angles per turn, 9 for 16.
    ///
    /// # Errors
    /// [`RangeError`] for a constant that is out of range.
    pub fn in_plane(
        constants: RingConstants,
        friction: Friction,
        tolerance: Tolerance,
    ) -> Result<Self, RangeError> {
        Self::at_rest(constants, friction, tolerance)
    }
}

impl<const N: usize, const M: usize> RingLaw<N, M, AlikePlane> {
    /// The law of shifts along x without twist and without coupling, in its initial state, at a quarter of
    /// the cost: angles beyond a quarter of a turn follow by symmetry. M is 3 for 8 angles per turn, 5 for
    /// 16.
    ///
    /// # Errors
    /// [`RangeError`] for a constant that is out of range.
    pub fn alike_in_plane(
        constants: RingConstants,
        friction: Friction,
        tolerance: Tolerance,
    ) -> Result<Self, RangeError> {
        Self::at_rest(RingConstants { gamma: 0.0, ..constants }, friction, tolerance)
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> RingLaw<N, M, S> {
    fn at_rest(
        constants: RingConstants,
        friction: Friction,
        tolerance: Tolerance,
    ) -> Result<Self, RangeError> {
        let RingConstants { c_z, radius, kappa, gamma } = constants.checked()?;
        let matrices = RingMatrices::at(kappa, gamma, friction)?;
        Ok(Self {
            matrices: Arc::new(matrices),
            units: Units::new(c_z, radius, friction),
            tolerance: tolerance.get(),
            memory: RingMemory::default(),
            iterations: 0,
        })
    }

    /// The law of a contact of known materials, with this history: `F_z = (2/3) c_z zeta^(3/2)`, of the radius
    /// `radius zeta^(1/2)`. It takes no time, since the matrices are shared.
    ///
    /// # Errors
    /// [`RangeError`] unless both are from 1e-60 to 1e60.
    #[inline]
    pub fn of(
        matrices: Arc<RingMatrices<N, M, S>>,
        [c_z, radius]: [f64; 2],
        tolerance: Tolerance,
        memory: RingMemory<N, M>,
    ) -> Result<Self, RangeError> {
        let units = matrices.contact(c_z, radius, tolerance)?.units;
        Ok(Self { matrices, units, tolerance: tolerance.get(), memory, iterations: 0 })
    }

    /// The history.
    #[must_use]
    pub const fn memory(&self) -> &RingMemory<N, M> {
        &self.memory
    }

    /// The constants of the contact.
    #[must_use]
    #[inline]
    pub fn constants(&self) -> Rings<'_, N, M, S> {
        self.matrices.rings(self.units, self.tolerance)
    }

    fn rings(&self) -> Rings<'_, N, M, S> {
        self.constants()
    }

    /// Advances, and returns the heat of the step, J, at no further cost ([`Dissipative::dissipation`]).
    ///
    /// # Errors
    /// As [`ContactLaw::advance`].
    pub fn advance_with_heat(&mut self, to: Shift) -> Result<f64, RangeError> {
        self.lagging_with_heat(to, SlipLag::NONE)
    }

    /// The same in a viscous material.
    pub(crate) fn lagging_with_heat(&mut self, to: Shift, lag: SlipLag) -> Result<f64, RangeError> {
        self.check(to)?;
        let rings = self.matrices.rings(self.units, self.tolerance);
        let done = self.memory.go(&rings, to, lag);
        self.iterations = done.iterations;
        Ok(rings.units.energy * done.heat)
    }

    /// Number of iterations of the last step; 0 if there was nothing to solve.
    #[must_use]
    pub const fn iterations(&self) -> usize {
        self.iterations
    }

    /// For each ring from the centre: its outer edge over the contact radius (the last lies outside), and the
    /// fraction of its angles that slipped in the last step.
    pub fn slipping(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let slips = move |j: usize, i: usize| {
            self.memory.contact.tractions.y[j].iter().any(|part| part[i] != 0.0)
        };
        let edges = self.rings().pair.into_iter().flat_map(|pair| &pair.layout.edges[1..]);
        edges.enumerate().map(move |(i, &edge)| {
            let count = (0..M).filter(|&j| slips(j, i)).count();
            (edge, count as f64 / M as f64)
        })
    }

    /// The mean traction of a ring on body 1 at an angle: radial (outwards) and circumferential
    /// (counter-clockwise). Rings are counted from the centre; `angle` counts in 1/M of a turn. None for
    /// other rings and without friction.
    #[must_use]
    pub fn traction(&self, ring: usize, angle: usize) -> Option<[f64; 2]> {
        let Rings { pair: Some(_), side, .. } = self.rings() else { return None };
        let contact = &self.memory.contact;
        // If the bodies are exchanged, y is reversed and the traction is that on the other body; in the plane
        // this is the mirror image.
        let (place, turn) = match side < 0.0 {
            true if S::MIRRORED => (angle, -1.0),
            true => (M.checked_sub(angle)? % M, 1.0),
            false => (angle, 1.0),
        };
        let [radial, around] = contact.tractions.z.get(place)?;
        let scale = self.units.traction * contact.radius;
        Some([side * scale * radial.get(ring)?, turn * scale * around.get(ring)?])
    }

    /// The share of the contact area that did not slip in the last step.
    #[must_use]
    pub fn sticking(&self) -> f64 {
        self.memory.sticking(&self.matrices)
    }

    /// Writes the state of the law as [`super::packed_numbers`] numbers. All zeros stand for two bodies that
    /// just touch. The constants of the contact are not stored.
    ///
    /// # Errors
    /// [`RangeError`] for too few numbers; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        self.memory.pack(numbers)
    }

    /// Restores what [`RingLaw::pack`] of a law with the same constants wrote, to the same bits.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are not a state of this law; the law is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        self.memory.unpack(&self.matrices.rings(self.units, self.tolerance), numbers)
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> ContactLaw for RingLaw<N, M, S> {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        self.advance_with_heat(shift)?;
        Ok(self.load())
    }

    fn shift(&self) -> Shift {
        self.memory.shift()
    }

    fn load(&self) -> ContactLoad {
        self.memory.load(&self.rings())
    }

    fn advance_lagging(&mut self, shift: Shift, lag: SlipLag) -> Result<ContactLoad, RangeError> {
        self.lagging_with_heat(shift, lag)?;
        Ok(self.load())
    }

    fn keeps_slip(&self) -> bool {
        true
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> Checked for RingLaw<N, M, S> {
    fn check(&self, to: Shift) -> Result<(), RangeError> {
        self.memory.check(&self.rings(), to)
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> Dissipative for RingLaw<N, M, S> {
    fn stored_energy(&self) -> f64 {
        self.memory.stored_energy(&self.rings())
    }

    /// Traction times slip at the end of the step; never negative. Work, by the mean of the loads at both
    /// ends, equals heat plus change of stored energy up to the discretisation error of rings and steps.
    fn dissipation(&self, to: Shift) -> f64 {
        let mut memory = self.memory;
        memory.advance(&self.rings(), to).unwrap_or(0.0)
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> ImpactLaw for RingLaw<N, M, S> {}
