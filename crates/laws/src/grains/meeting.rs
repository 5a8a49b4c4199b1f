//! Relative position and motion of two grains, or of a grain and a wall.

use std::array::from_fn;

use carom_halfspace::MaterialPair;
use carom_special::RangeError;

use super::number::{LANES, Lanes, Number, hold, lanes};
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
pub struct Meeting<T = f64, M = [f64; 2]> {
    /// The unit normal, from body 2 into body 1.
    pub normal: [T; 3],
    /// The approach zeta; negative if there is a gap.
    pub zeta: T,
    /// Distances from the centres to the contact along the normal; zero for a wall.
    pub arms: [T; 2],
    /// The fractions of the approach by which the bodies are compressed: their arms shorten by these.
    pub shares: [T; 2],
    /// Velocity of the centre of body 2 relative to that of body 1; of a wall, of its place nearest to body 1.
    pub velocity: [T; 3],
    /// The angular velocities of both bodies, rad/s.
    pub spins: [[T; 3]; 2],
    /// The masses of both bodies, kg; infinite for a wall.
    pub masses: M,
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

/// What else than its place is known of one sphere, or of several at once.
#[derive(Clone, Copy)]
struct Moving<T, M = f64> {
    velocity: Vector<T>,
    spin: Vector<T>,
    radius: T,
    mass: M,
}

impl Moving<f64> {
    #[inline(always)]
    fn of(&Grain { velocity, spin, radius, mass, .. }: &Grain) -> Self {
        Self { velocity, spin, radius, mass }
    }
}

impl Moving<Lanes, ()> {
    #[inline(always)]
    fn of(grains: [&Grain; LANES]) -> Self {
        Self {
            velocity: from_fn(|k| lanes(|i| grains[i].velocity[k])),
            spin: from_fn(|k| lanes(|i| grains[i].spin[k])),
            radius: lanes(|i| grains[i].radius),
            mass: (),
        }
    }
}

/// The position of the centre of one sphere relative to that of another one: neither zero nor infinite, so that
/// they have a normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apart<T = f64> {
    way: Vector<T>,
    square: T,
}

/// Squares of distances that are surely neither zero nor infinite.
const USUAL: [f64; 2] = [1e-300, 1e300];

impl Apart {
    /// The position of the first sphere relative to the second.
    ///
    /// # Errors
    /// [`RangeError`] if the distance of the centres is zero, infinite or NaN.
    #[inline(always)]
    pub fn of(one: &Grain, two: &Grain) -> Result<Self, RangeError> {
        let apart = between(one.place, two.place);
        Self::check(apart.square)?;
        Ok(apart)
    }

    #[inline(always)]
    fn check(square: f64) -> Result<(), RangeError> {
        // Narrower than the check itself, which would be compiled to a classification of the number.
        if square > USUAL[0] && square < USUAL[1] { Ok(()) } else { Self::check_unusual(square) }
    }

    #[cold]
    fn check_unusual(square: f64) -> Result<(), RangeError> {
        let holds = square > 0.0 && square < f64::INFINITY;
        RangeError::check("distance", square.sqrt(), holds, "positive and finite").map(|_| ())
    }
}

#[inline(always)]
fn between<T: Number>(one: Vector<T>, two: Vector<T>) -> Apart<T> {
    let way = minus(one, two);
    Apart { way, square: dot(way, way) }
}

#[inline(always)]
fn met<T: Number, M>(
    Apart { way, square }: Apart<T>,
    [one, two]: [Moving<T, M>; 2],
    shares: [T; 2],
) -> Meeting<T, [M; 2]> {
    let distance = square.sqrt();
    let normal = times(way, T::of(1.0) / distance);
    let zeta = one.radius + two.radius - distance;
    let arms = [one.radius - shares[0] * zeta, two.radius - shares[1] * zeta];
    let velocity = minus(two.velocity, one.velocity);
    let (spins, masses) = ([one.spin, two.spin], [one.mass, two.mass]);
    Meeting { normal, zeta, arms, shares, velocity, spins, masses, axis: None }
}

/// The relative velocity at the contact, with the arms at the middle of a step in which the approach grew, to which the
/// velocities belong. With the arms of its end, the work of the force on the bodies would differ from that on the shift by
/// a share of the step.
#[inline(always)]
pub(super) fn slip<T: Number, M>(
    meeting: &Meeting<T, M>,
    growth: T,
    normal: Vector<T>,
) -> Vector<T> {
    let half = growth * T::of(0.5);
    let Meeting { arms, shares, spins: [one, two], .. } = meeting;
    let [arm_1, arm_2] = [arms[0] + shares[0] * half, arms[1] + shares[1] * half];
    plus(meeting.velocity, cross(plus(times(*one, arm_1), times(*two, arm_2)), normal))
}

/// Several pairs of spheres; their masses are read where they are needed.
pub(super) type Meetings = Meeting<Lanes, [(); 2]>;

impl Meetings {
    /// Several pairs of spheres at once.
    #[inline(always)]
    pub(super) fn of_pairs(
        bodies: [[&Grain; LANES]; 2],
        shares: [Lanes; 2],
    ) -> Result<Self, RangeError> {
        let [one, two] = bodies.map(|all| from_fn(|k| lanes(|i| all[i].place[k])));
        let apart = between(one, two);
        let above = apart.square.simd_gt(Lanes::splat(USUAL[0]));
        if !hold(above & apart.square.simd_lt(Lanes::splat(USUAL[1]))) {
            apart.square.to_array().into_iter().try_for_each(Apart::check_unusual)?;
        }
        Ok(met(apart, bodies.map(Moving::<Lanes, ()>::of), shares))
    }
}

impl Meeting {
    /// Two spheres, each compressed by its fraction of the approach ([`compliance_shares`]).
    ///
    /// # Errors
    /// As [`Apart::of`].
    #[inline]
    pub fn of_spheres(one: &Grain, two: &Grain, shares: [f64; 2]) -> Result<Self, RangeError> {
        Ok(Self::of_apart([one, two], &Apart::of(one, two)?, shares))
    }

    /// The same for two spheres whose relative position `apart` has been checked. It cannot fail, so that the compiler
    /// can keep it in registers.
    #[inline(always)]
    #[must_use]
    pub fn of_apart(bodies: [&Grain; 2], apart: &Apart, shares: [f64; 2]) -> Self {
        met(*apart, bodies.map(Moving::<f64>::of), shares)
    }

    /// A sphere (body 1) on a flat wall (body 2); the sphere is compressed by its fraction of the
    /// approach.
    #[inline]
    #[must_use]
    pub fn on_wall(one: &Grain, wall: &Wall, share: f64) -> Self {
        let zeta = one.radius - dot(minus(one.place, wall.place), wall.normal);
        let (arms, shares) = ([one.radius - share * zeta, 0.0], [share, 1.0 - share]);
        let velocity = minus(wall.velocity, one.velocity);
        let (spins, masses) = ([one.spin, [0.0; 3]], [one.mass, f64::INFINITY]);
        Self { normal: wall.normal, zeta, arms, shares, velocity, spins, masses, axis: None }
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
            spins: [one.spin, spin],
            axis: (axis != [0.0; 3]).then_some(axis),
            ..flat
        }
    }

    /// The mean of the angular velocities, rad/s.
    #[must_use]
    pub fn turning(&self) -> [f64; 3] {
        let [one, two] = self.spins;
        times(plus(one, two), 0.5)
    }

    /// Angular velocity of body 2 relative to body 1, rad/s; its component along the normal twists the contact.
    #[must_use]
    pub fn twisting(&self) -> [f64; 3] {
        let [one, two] = self.spins;
        minus(two, one)
    }

    /// Whether the bodies do not overlap, so that they exert no force on each other.
    #[inline(always)]
    #[must_use]
    pub fn is_apart(&self) -> bool {
        self.zeta <= 0.0
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
        let slip = slip(self, 0.0, self.normal);
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
