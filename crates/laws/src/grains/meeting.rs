//! Where two grains, or a grain and a wall, touch, and how they move there.

use carom_halfspace::MaterialPair;
use carom_special::RangeError;

use super::vector::{dot, minus, plus, times};

/// A sphere as a particle code moves it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Grain {
    /// Its centre, m.
    pub place: [f64; 3],
    /// The velocity of its centre, m/s.
    pub velocity: [f64; 3],
    /// Its angular velocity, rad/s.
    pub spin: [f64; 3],
    /// Its radius, m.
    pub radius: f64,
}

/// A flat wall that may move along.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C)]
pub struct Wall {
    /// Any place on it, m.
    pub place: [f64; 3],
    /// The unit normal, towards the grains.
    pub normal: [f64; 3],
    /// Its velocity, m/s.
    pub velocity: [f64; 3],
}

/// Two bodies at one instant: what their contact has to know. Body 1 is the one into which the normal
/// points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// The unit normal, out of body 2 into body 1.
    pub normal: [f64; 3],
    /// The approach zeta; negative where a gap is left.
    pub zeta: f64,
    /// From the centres to the contact along the normal; that of a wall is zero.
    pub arms: [f64; 2],
    /// The velocity of the centre of body 2 against that of body 1.
    pub velocity: [f64; 3],
    /// The sum of the spins, each times its arm: its product with the normal is what they add to the
    /// velocity where the two touch.
    pub rolling: [f64; 3],
    /// The mean of the spins, rad/s.
    pub turning: [f64; 3],
    /// The spin of body 2 against body 1, rad/s; what of it is along the normal twists the contact.
    pub twisting: [f64; 3],
}

/// What share of the approach each body gives way: its (1 - nu)/G over that of both. Thus far from its
/// own surface lies the contact.
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

impl Meeting {
    /// Two spheres, of which each gives way by its share of the approach ([`compliance_shares`]).
    ///
    /// # Errors
    /// [`RangeError`] if the distance of the centres is zero or not a number.
    #[inline]
    pub fn of_spheres(one: &Grain, two: &Grain, shares: [f64; 2]) -> Result<Self, RangeError> {
        let apart = minus(one.place, two.place);
        let square = dot(apart, apart);
        if !(square > 0.0 && square < f64::INFINITY) {
            return Err(RangeError::new("distance", square.sqrt(), "positive and finite"));
        }
        let distance = square.sqrt();
        let normal = times(apart, 1.0 / distance);
        let zeta = one.radius + two.radius - distance;
        let arms = [one.radius - shares[0] * zeta, two.radius - shares[1] * zeta];
        let rolling = plus(times(one.spin, arms[0]), times(two.spin, arms[1]));
        let velocity = minus(two.velocity, one.velocity);
        let turning = times(plus(one.spin, two.spin), 0.5);
        let twisting = minus(two.spin, one.spin);
        Ok(Self { normal, zeta, arms, velocity, rolling, turning, twisting })
    }

    /// A sphere, body 1, on a flat wall, body 2; the sphere gives way by its share of the approach.
    #[inline]
    #[must_use]
    pub fn on_wall(one: &Grain, wall: &Wall, share: f64) -> Self {
        let zeta = one.radius - dot(minus(one.place, wall.place), wall.normal);
        let arm = one.radius - share * zeta;
        let velocity = minus(wall.velocity, one.velocity);
        let (rolling, turning) = (times(one.spin, arm), times(one.spin, 0.5));
        let (normal, arms, twisting) = (wall.normal, [arm, 0.0], times(one.spin, -1.0));
        Self { normal, zeta, arms, velocity, rolling, turning, twisting }
    }
}
