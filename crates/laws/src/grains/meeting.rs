//! Relative position and motion of two grains, or of a grain and a wall.

use std::array::from_fn;

use carom_halfspace::MaterialPair;
use carom_special::RangeError;

use super::number::{LANES, Lanes, Number, lanes};
use super::vector::{Vector, cross, dot, minus, plus, times};

/// A sphere with its motion, as a particle code stores it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Grain {
    /// Position of its centre, m.
    pub place: [f64; 3],
    /// The velocity of its centre, m/s.
    pub velocity: [f64; 3],
    /// Angular velocity, rad/s.
    pub spin: [f64; 3],
    /// Its radius, m.
    pub radius: f64,
    /// Its mass, kg; infinite for one that does not move. It counts for damping by a restitution only.
    pub mass: f64,
}

/// A flat wall, which may move.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Wall {
    /// Position of any of its points, m.
    pub place: [f64; 3],
    /// Unit normal, pointing towards the grains.
    pub normal: [f64; 3],
    /// Its velocity, m/s.
    pub velocity: [f64; 3],
}

/// The place where a wall of any shape, at rest or moving, is nearest to a grain: its tangent plane there and its
/// motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Surface {
    /// The nearest point of the wall, m.
    pub place: [f64; 3],
    /// Unit normal at that point, pointing towards the grain.
    pub normal: [f64; 3],
    /// The velocity of the wall at that point, m/s.
    pub velocity: [f64; 3],
    /// The angular velocity of the wall, rad/s.
    pub spin: [f64; 3],
    /// The direction of the axis x of the contact, a unit vector across the normal, for an ellipse whose axes are
    /// given by the wall. Zero for a circle, whose axes turn with the mean of the two spins.
    pub axis: [f64; 3],
}

/// Relative position and motion of two bodies at one instant: the input of their contact. The
/// normal points into body 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting<T = f64> {
    /// The unit normal, from body 2 into body 1.
    pub normal: [T; 3],
    /// The approach zeta; negative if there is a gap.
    pub zeta: T,
    /// Distances from the centres to the contact along the normal; zero for a wall.
    pub arms: [T; 2],
    /// Velocity of the centre of body 2 relative to that of body 1.
    pub velocity: [T; 3],
    /// The sum of the angular velocities, each times its arm. Its cross product with the normal is
    /// the part of the relative velocity at the contact that is due to rotation.
    pub rolling: [T; 3],
    /// The decrease of `rolling` per approach, by which the arms become shorter: the sum of the
    /// angular velocities, each times the fraction of the approach by which its body is compressed.
    pub rolling_decrease: [T; 3],
    /// The mean of the angular velocities, rad/s.
    pub turning: [T; 3],
    /// Angular velocity of body 2 relative to body 1, rad/s; its component along the normal twists
    /// the contact.
    pub twisting: [T; 3],
    /// The masses of both bodies, kg; infinite for a wall.
    pub masses: [T; 2],
    /// The axis x of the contact, if the bodies determine it ([`Surface::axis`]).
    pub axis: Option<[T; 3]>,
}

/// The fraction of the approach by which each body is compressed: its (1 - nu)/G divided by the sum
/// of both. It determines the distance of the contact from the undeformed surface of each body.
///
/// ```
/// use carom_halfspace::{Material, MaterialPair};
/// use carom_laws::grains::compliance_shares;
/// let steel = Material::from_young(208e9, 0.3)?;
/// assert_eq!(compliance_shares(&MaterialPair::new(steel, steel)?), [0.5, 0.5]);
/// assert_eq!(compliance_shares(&MaterialPair::new(steel, Material::RIGID)?), [1.0, 0.0]);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[must_use]
pub fn compliance_shares(materials: &MaterialPair) -> [f64; 2] {
    let [one, two] = [materials.body_1(), materials.body_2()]
        .map(|body| (1.0 - body.poisson()) / body.shear_modulus());
    [one / (one + two), two / (one + two)]
}

/// The motion of one sphere, or of several at once.
#[derive(Clone, Copy)]
struct Moving<T> {
    place: Vector<T>,
    velocity: Vector<T>,
    spin: Vector<T>,
    radius: T,
    mass: T,
}

impl Moving<f64> {
    #[inline(always)]
    fn of(&Grain { place, velocity, spin, radius, mass }: &Grain) -> Self {
        Self { place, velocity, spin, radius, mass }
    }
}

impl Moving<Lanes> {
    #[inline(always)]
    fn of(grains: [&Grain; LANES]) -> Self {
        Self {
            place: from_fn(|k| lanes(|i| grains[i].place[k])),
            velocity: from_fn(|k| lanes(|i| grains[i].velocity[k])),
            spin: from_fn(|k| lanes(|i| grains[i].spin[k])),
            radius: lanes(|i| grains[i].radius),
            mass: lanes(|i| grains[i].mass),
        }
    }
}

/// The position of the centre of body 1 relative to that of body 2.
struct Apart<T> {
    way: Vector<T>,
    square: T,
}

impl<T: Number> Moving<T> {
    #[inline(always)]
    fn apart(&self, two: &Self) -> Apart<T> {
        let way = minus(self.place, two.place);
        Apart { way, square: dot(way, way) }
    }

    #[inline(always)]
    fn meeting(&self, two: &Self, apart: &Apart<T>, shares: [T; 2]) -> Meeting<T> {
        let one = self;
        let distance = apart.square.sqrt();
        let normal = times(apart.way, T::of(1.0) / distance);
        let zeta = one.radius + two.radius - distance;
        let arms = [one.radius - shares[0] * zeta, two.radius - shares[1] * zeta];
        let rolling = plus(times(one.spin, arms[0]), times(two.spin, arms[1]));
        let rolling_decrease = plus(times(one.spin, shares[0]), times(two.spin, shares[1]));
        let velocity = minus(two.velocity, one.velocity);
        let turning = times(plus(one.spin, two.spin), T::of(0.5));
        let twisting = minus(two.spin, one.spin);
        let masses = [one.mass, two.mass];
        let axis = None;
        Meeting {
            normal,
            zeta,
            arms,
            velocity,
            rolling,
            rolling_decrease,
            turning,
            twisting,
            masses,
            axis,
        }
    }
}

impl Meeting<Lanes> {
    /// Several pairs of spheres at once.
    #[inline(always)]
    pub(super) fn of_pairs(
        bodies: [[&Grain; LANES]; 2],
        shares: [Lanes; 2],
    ) -> Result<Self, RangeError> {
        let [one, two] = bodies.map(Moving::<Lanes>::of);
        let apart = one.apart(&two);
        // Narrower than the check itself, which would be compiled to a classification of each number.
        let within = apart.square.simd_gt(Lanes::splat(1e-300));
        if !(within & apart.square.simd_lt(Lanes::splat(1e300))).all() {
            apart.square.to_array().into_iter().try_for_each(Meeting::<f64>::check)?;
        }
        Ok(one.meeting(&two, &apart, shares))
    }
}

impl Meeting {
    /// Two spheres, each compressed by its fraction of the approach ([`compliance_shares`]).
    ///
    /// # Errors
    /// [`RangeError`] if the distance of the centres is zero or NaN.
    #[inline]
    pub fn of_spheres(one: &Grain, two: &Grain, shares: [f64; 2]) -> Result<Self, RangeError> {
        let [one, two] = [one, two].map(Moving::<f64>::of);
        let apart = one.apart(&two);
        Self::check(apart.square)?;
        Ok(one.meeting(&two, &apart, shares))
    }

    fn check(square: f64) -> Result<(), RangeError> {
        if square > 0.0 && square < f64::INFINITY {
            return Ok(());
        }
        Err(RangeError::new("distance", square.sqrt(), "positive and finite"))
    }

    /// A sphere (body 1) on a flat wall (body 2); the sphere is compressed by its fraction of the
    /// approach.
    #[inline]
    #[must_use]
    pub fn on_wall(one: &Grain, wall: &Wall, share: f64) -> Self {
        let zeta = one.radius - dot(minus(one.place, wall.place), wall.normal);
        let arm = one.radius - share * zeta;
        let velocity = minus(wall.velocity, one.velocity);
        let (rolling, turning) = (times(one.spin, arm), times(one.spin, 0.5));
        let (normal, arms, twisting) = (wall.normal, [arm, 0.0], times(one.spin, -1.0));
        let (masses, axis) = ([one.mass, f64::INFINITY], None);
        let rolling_decrease = times(one.spin, share);
        Self {
            normal,
            zeta,
            arms,
            velocity,
            rolling,
            rolling_decrease,
            turning,
            twisting,
            masses,
            axis,
        }
    }

    /// A sphere (body 1) on a wall of any shape (body 2), which may turn; the sphere is compressed by its fraction
    /// of the approach.
    #[must_use]
    pub fn on_surface(one: &Grain, wall: &Surface, share: f64) -> Self {
        let Surface { place, normal, velocity, spin, axis } = *wall;
        let flat = Self::on_wall(one, &Wall { place, normal, velocity }, share);
        // The contact lies below the surface of the wall by what the wall is compressed.
        let below = times(normal, (share - 1.0) * flat.zeta);
        Self {
            velocity: plus(flat.velocity, cross(spin, below)),
            rolling_decrease: plus(flat.rolling_decrease, times(spin, 1.0 - share)),
            turning: times(plus(one.spin, spin), 0.5),
            twisting: minus(spin, one.spin),
            axis: (axis != [0.0; 3]).then_some(axis),
            ..flat
        }
    }

    /// The speed at which the bodies slide on each other at the contact, m/s: the tangential part of the
    /// relative velocity there, rotation included.
    ///
    /// ```
    /// use carom_laws::grains::{Grain, Meeting};
    /// let below = Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: 1.0, mass: 1.0 };
    /// let above = Grain { place: [0.0, 0.0, 2.0], velocity: [3.0, 0.0, -5.0], ..below };
    /// let speed = |spin| {
    ///     Meeting::of_spheres(&Grain { spin, ..above }, &below, [0.5; 2]).map(|met| met.slip_speed())
    /// };
    /// assert_eq!(speed([0.0; 3])?, 3.0);
    /// assert_eq!(speed([0.0, 3.0, 7.0])?, 0.0);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    #[must_use]
    pub fn slip_speed(&self) -> f64 {
        let slip = plus(self.velocity, cross(self.rolling, self.normal));
        let slip = minus(slip, times(self.normal, dot(slip, self.normal)));
        dot(slip, slip).sqrt()
    }

    /// Checks that the masses are > 0 and not both infinite, as damping by a restitution needs them.
    ///
    /// # Errors
    /// [`RangeError`] of `mass`.
    #[inline]
    pub fn check_masses(&self) -> Result<(), RangeError> {
        for mass in self.masses {
            RangeError::check("mass", mass, mass > 0.0, "> 0")?;
        }
        let [one, two] = self.masses;
        let moves = one.is_finite() || two.is_finite();
        RangeError::check("mass", one, moves, "finite for one of both bodies").map(|_| ())
    }
}
