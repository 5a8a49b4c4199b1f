//! The law of rings in the user's units.

use carom_special::RangeError;

use super::constants::{RingConstants, Tolerance};
use super::contact::{Contact, Done, Step, Sums};
use super::pair::Pair;
use super::symmetry::{AlikePlane, Plane, Symmetry, Whole};
use crate::bounds::in_contact;
use crate::friction::Friction;
use crate::hertz::Hertz;
use crate::law::{Checked, ContactLaw, ContactLoad, Dissipative, ImpactLaw, Shift};

/// Units of the normalised contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Units {
    c_z: f64,
    /// Normalised shift over shift: 1/f.
    shift: f64,
    /// Normalised twist over twist, counter-clockwise.
    twist: f64,
    force: f64,
    torque: f64,
    energy: f64,
    traction: f64,
}

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
    /// None without friction.
    pub(super) pair: Option<Pair<N, M, S>>,
    units: Units,
    pub(super) tolerance: f64,
    pub(super) contact: Contact<N, M>,
    pub(super) sums: Sums,
    pub(super) shift: Shift,
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
        let f = friction.coefficient().unwrap_or(1.0);
        let over = |value: f64| if f > 0.0 { value / f } else { 0.0 };
        let force = 0.25 * c_z * f;
        let units = Units {
            c_z,
            shift: over(1.0),
            twist: -over(radius),
            force,
            torque: -force * radius,
            energy: force * f,
            traction: force / (radius * radius),
        };
        let pair = (f > 0.0).then(|| Pair::new(kappa, gamma, friction.get()));
        Ok(Self {
            pair,
            units,
            tolerance: tolerance.get(),
            contact: Contact::default(),
            sums: Sums::default(),
            shift: Shift::default(),
            iterations: 0,
        })
    }

    /// Iterations of the last step, 0 where there was nothing to solve.
    #[must_use]
    pub const fn iterations(&self) -> usize {
        self.iterations
    }

    /// Edges and state of the rings, from the middle: the outer edge over the contact radius (the last
    /// lies outside), and the share of its angles that slipped in the last step.
    pub fn slipping(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let slips =
            move |j: usize, i: usize| self.contact.tractions.y[j].iter().any(|part| part[i] != 0.0);
        self.pair.iter().flat_map(|pair| &pair.layout.edges[1..]).enumerate().map(
            move |(i, &edge)| {
                let count = (0..M).filter(|&j| slips(j, i)).count();
                (edge, count as f64 / M as f64)
            },
        )
    }

    /// The traction on body 1, radial (outwards) and circumferential (counter-clockwise): its mean over a
    /// ring, from the middle, at an angle in parts of a turn over M. None beyond the rings and without
    /// friction.
    #[must_use]
    pub fn traction(&self, ring: usize, angle: usize) -> Option<[f64; 2]> {
        self.pair.as_ref()?;
        let [radial, around] = self.contact.tractions.z.get(angle)?;
        let scale = self.units.traction * self.contact.radius;
        Some([scale * radial.get(ring)?, scale * around.get(ring)?])
    }

    /// Goes to a shift that was checked; the heat over the unit of energy.
    fn go(&mut self, to: Shift) -> f64 {
        let from = std::mem::replace(&mut self.shift, to);
        self.iterations = 0;
        let Some(pair) = &self.pair else { return 0.0 };
        if to.zeta <= 0.0 {
            self.contact = Contact::default();
            return std::mem::take(&mut self.sums).stored;
        }
        if to == from {
            return 0.0;
        }
        // The part of the way on which they touch.
        let part = if from.zeta < 0.0 { to.zeta / (to.zeta - from.zeta) } else { 1.0 };
        let Units { shift, twist, .. } = self.units;
        let step = Step {
            approach: to.zeta,
            approached: part * (to.zeta - from.zeta),
            shifted: [(to.xi - from.xi) * part * shift, (to.eta - from.eta) * part * shift],
            twisted: (to.omega - from.omega) * part * twist,
        };
        let Done { iterations, heat } = self.contact.advance(pair, self.tolerance, &step);
        self.iterations = iterations;
        self.sums = self.contact.sums(pair);
        heat
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> ContactLaw for RingLaw<N, M, S> {
    type Error = RangeError;

    fn advance(&mut self, shift: Shift) -> Result<ContactLoad, RangeError> {
        self.check(shift)?;
        self.go(shift);
        Ok(self.load())
    }

    fn shift(&self) -> Shift {
        self.shift
    }

    fn load(&self) -> ContactLoad {
        let Units { c_z, force, torque, .. } = self.units;
        let [x, y] = self.sums.force;
        let f_z = match &self.pair {
            Some(pair) if pair.lift != 0.0 => 0.25 * c_z * self.sums.normal,
            _ => {
                let zeta = self.shift.zeta.max(0.0);
                2.0 / 3.0 * c_z * (zeta * zeta.sqrt())
            }
        };
        ContactLoad { f_x: force * x, f_y: force * y, f_z, m_z: torque * self.sums.torque }
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> Checked for RingLaw<N, M, S> {
    fn check(&self, to: Shift) -> Result<(), RangeError> {
        to.check_finite()?;
        if S::MIRRORED {
            RangeError::check("eta", to.eta, to.eta == 0.0, "0: the law of a plane")?;
            RangeError::check("omega", to.omega, to.omega == 0.0, "0: the law of a plane")?;
        }
        let Units { shift, twist, .. } = self.units;
        in_contact("shift over friction", (to.xi - self.shift.xi) * shift)?;
        in_contact("shift over friction", (to.eta - self.shift.eta) * shift)?;
        in_contact("twist over friction", (to.omega - self.shift.omega) * twist)?;
        Ok(())
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> Dissipative for RingLaw<N, M, S> {
    /// Compression by Hertz's law, and what tangential tractions have stored, with the pressures they add.
    fn stored_energy(&self) -> f64 {
        let zeta = self.shift.zeta.max(0.0);
        let normal = 4.0 / 15.0 * self.units.c_z * (zeta * zeta * zeta.sqrt());
        normal + self.units.energy * self.sums.stored
    }

    /// Traction times slip, both of the end of the step: never negative. Work, by the mean of the loads at
    /// both ends, is heat and stored energy but for what the rings and steps leave out.
    fn dissipation(&self, to: Shift) -> f64 {
        match self.check(to) {
            Ok(()) => self.clone().go(to) * self.units.energy,
            Err(_) => 0.0,
        }
    }
}

impl<const N: usize, const M: usize, S: Symmetry<M>> ImpactLaw for RingLaw<N, M, S> {}
