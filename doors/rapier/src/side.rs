//! A body of a contact: a ball that moves, or anything that does not.

use rapier3d::glamx::DVec3;
use rapier3d::prelude::*;

/// Relative differences of lengths and moments below this count as none: Rapier stores single precision.
const EVEN: f32 = 1e-4;

/// What an impact needs of one body.
pub(crate) struct Side {
    centre: DVec3,
    velocity: DVec3,
    spin: DVec3,
    /// From this body into the other.
    outward: DVec3,
    /// Radius of a ball that moves; 0 for a body that does not, whose velocity is that at the contact.
    pub(crate) radius: f64,
    pub(crate) inverse_mass: f64,
    inverse_inertia: f64,
}

impl Side {
    /// None for a moving body that is no ball about its centre of mass, or that is not free.
    pub(crate) fn new(
        body: Option<&RigidBody>,
        collider: &Collider,
        moves: bool,
        outward: DVec3,
        touch: Vector,
    ) -> Option<Self> {
        if !moves {
            let velocity = body.map_or(Vector::ZERO, |body| body.velocity_at_point(touch));
            return Some(Self::held(touch, velocity, outward));
        }
        let (body, ball) = (body?, collider.shape().as_ball()?);
        let mass = body.mass_properties();
        let inertia = mass.local_mprops.inv_principal_inertia;
        let is_even = (inertia - inertia.x).abs().max_element() <= EVEN * inertia.x;
        let is_centred =
            collider.translation().distance(body.center_of_mass()) <= EVEN * ball.radius;
        let is_free = body.locked_axes().is_empty() && body.colliders().len() == 1;
        (is_even && is_centred && is_free).then(|| Self {
            centre: body.center_of_mass().as_dvec3(),
            velocity: body.linvel().as_dvec3(),
            spin: body.angvel().as_dvec3(),
            outward,
            radius: f64::from(ball.radius),
            inverse_mass: f64::from(mass.local_mprops.inv_mass),
            inverse_inertia: f64::from(inertia.x),
        })
    }

    fn held(touch: Vector, velocity: Vector, outward: DVec3) -> Self {
        let (centre, velocity, spin) = (touch.as_dvec3(), velocity.as_dvec3(), DVec3::ZERO);
        Self {
            centre,
            velocity,
            spin,
            outward,
            radius: 0.0,
            inverse_mass: 0.0,
            inverse_inertia: 0.0,
        }
    }

    fn moves(&self) -> bool {
        self.inverse_mass > 0.0
    }

    /// The velocity of its point where it touches.
    pub(crate) fn at_contact(&self) -> DVec3 {
        self.at_arm(self.radius)
    }

    /// The velocity of its point at this distance from the centre along the normal.
    pub(crate) fn at_arm(&self, arm: f64) -> DVec3 {
        self.velocity + self.spin.cross(arm * self.outward)
    }

    /// The distance of a point from the centre along the normal; 0 if the body does not move.
    pub(crate) fn arm_to(&self, point: DVec3) -> f64 {
        if self.moves() { (point - self.centre).dot(self.outward) } else { 0.0 }
    }

    /// Change of the tangential velocity at this arm per impulse there.
    pub(crate) fn tangential_mobility(&self, arm: f64) -> f64 {
        self.inverse_mass + arm * arm * self.inverse_inertia
    }

    /// The way from a point on the normal to the surface of the ball that moves; none if both do, whose surfaces are
    /// two points.
    pub(crate) fn to_surface(&self, other: &Self, point: DVec3) -> DVec3 {
        let way = |side: &Self| (side.radius - side.arm_to(point)) * side.outward;
        match (self.moves(), other.moves()) {
            (true, false) => way(self),
            (false, true) => way(other),
            _ => DVec3::ZERO,
        }
    }
}
