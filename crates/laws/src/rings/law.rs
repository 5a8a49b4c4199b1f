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

/// The contact law of spheres and planes of unlike materials: shift in two directions, twist and their
/// coupling with the approach, with memory.
///
/// N rings of M angles (4 to 24; 8, 16 or 32). 6 x 8, the default, is for particles: on random paths of alike
/// and unlike bodies forces were off those of a grid of 32 cells by .003 to .006 of f F_z in the mean and .023 at
/// most, torques by up to .003 of f F_z a in the mean and .012 at most; 8 x 8 to 16 x 16 are for single contacts.
/// A step allocates nothing; laws of one pair of materials are best cloned from one, as they then share the
/// matrices of the pair.
///
/// A step goes straight from one shift to the next. In a step that closes the gap only the part in contact
/// counts. An approach that is not positive separates the bodies: the memory is lost, and what was stored
/// in the tangential tractions is heat.
///
/// Of dissimilar bodies the one whose surface pressure draws inwards more (gamma > 0) is taken as body 1, so that an
/// exchange of the bodies gives the same bits.
///
/// Infinite friction sticks, but to what has been lost at a receding rim; without friction only Hertz's
/// force is left, and F_z is Hertz's where gamma = 0.
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
/// // Twist and coupling together push the bodies sideways.
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
    /// A law at rest, the bodies just touching.
    ///
    /// # Errors
    /// [`RangeError`] unless the contact is a circle.
    pub fn new(
        hertz: &Hertz,
        friction: Friction,
        tolerance: Tolerance,
    ) -> Result<Self, RangeError> {
        Self::from_constants(RingConstants::of(hertz)?, friction, tolerance)
    }

    /// The law of a contact of which only the constants are known, at rest.
    ///
    /// The first law of a size takes some 0.01 s, a further pair of materials 0.1 ms (6 x 8) to 2 ms; the pairs
    /// asked for last are kept.
    ///
    /// # Errors
    /// [`RangeError`] for a constant that is out of range.
    pub fn from_constants(
        constants: RingConstants,
        friction: Friction,
        tolerance: Tolerance,
    ) -> Result<Self, RangeError> {
        Self::at_rest(constants, friction, tolerance)
    }
}

impl<const N: usize, const M: usize> RingLaw<N, M, Plane> {
    /// The law of shifts along x without twist, at rest, for half of the cost: as the mirror images, angles
    /// beyond half a turn are left out. M is 5 for 8 angles a turn, 9 for 16.
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
    /// The law of shifts along x without twist, coupling left out, at rest, for a quarter of the cost: angles
    /// beyond a quarter of a turn follow from the others. M is 3 for 8 angles a turn, 5 for 16.
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

    fn rings(&self) -> Rings<'_, N, M, S> {
        self.matrices.rings(self.units, self.tolerance)
    }

    /// Iterations of the last step, 0 where there was nothing to solve.
    #[must_use]
    pub const fn iterations(&self) -> usize {
        self.iterations
    }

    /// Edges and state of the rings, from the middle: the outer edge over the contact radius (the last
    /// lies outside), and the share of its angles that slipped in the last step.
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

    /// The traction on body 1, radial (outwards) and circumferential (counter-clockwise): its mean over a
    /// ring, from the middle, at an angle in parts of a turn over M. None beyond the rings and without
    /// friction.
    #[must_use]
    pub fn traction(&self, ring: usize, angle: usize) -> Option<[f64; 2]> {
        let Rings { pair: Some(_), side, .. } = self.rings() else { return None };
        let contact = &self.memory.contact;
        // With the bodies exchanged y is reversed, and the traction is that on the other body.
        // In a plane that is the mirror image.
        let (place, turn) = match side < 0.0 {
            true if S::MIRRORED => (angle, -1.0),
            true => (M.checked_sub(angle)? % M, 1.0),
            false => (angle, 1.0),
        };
        let [radial, around] = contact.tractions.z.get(place)?;
        let scale = self.units.traction * contact.radius;
        Some([side * scale * radial.get(ring)?, turn * scale * around.get(ring)?])
    }

    /// The share of the contact area on which nothing slipped in the last step.
    #[must_use]
    pub fn sticking(&self) -> f64 {
        self.memory.sticking(&self.matrices)
    }

    /// Writes what the law remembers into numbers, [`super::packed_numbers`] of them. All zeros are two bodies
    /// that just touch. The constants of the contact are not among them.
    ///
    /// # Errors
    /// [`RangeError`] for too few numbers; nothing is then written.
    pub fn pack(&self, numbers: &mut [f64]) -> Result<(), RangeError> {
        self.memory.pack(numbers)
    }

    /// Takes up what [`RingLaw::pack`] of a law of the same constants wrote, to the same bits.
    ///
    /// # Errors
    /// [`RangeError`] for numbers that are no state of this law; the law is then unchanged.
    pub fn unpack(&mut self, numbers: &[f64]) -> Result<(), RangeError> {
        self.memory.unpack(&self.matrices.rings(self.units, self.tolerance), numbers)
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> ContactLaw for RingLaw<N, M, S> {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        self.check(shift)?;
        let rings = self.matrices.rings(self.units, self.tolerance);
        self.iterations = self.memory.go(&rings, shift).iterations;
        Ok(self.load())
    }

    fn shift(&self) -> Shift {
        self.memory.shift()
    }

    fn load(&self) -> ContactLoad {
        self.memory.load(&self.rings())
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

    /// Traction times slip, both of the end of the step: never negative. Work, by the mean of the loads at
    /// both ends, is heat and stored energy but for what the rings and steps leave out.
    fn dissipation(&self, to: Shift) -> f64 {
        let mut memory = self.memory;
        memory.advance(&self.rings(), to).unwrap_or(0.0)
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> ImpactLaw for RingLaw<N, M, S> {}
