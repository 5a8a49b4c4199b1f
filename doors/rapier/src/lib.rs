//! Impacts of elastic balls with friction for the physics engine Rapier.
//!
//! Rapier takes a coefficient of restitution for the normal velocity. Along the surface it knows friction only: a
//! contact that sticks ends without tangential velocity. An elastic ball stores energy there while it sticks, and turns
//! back. [`ElasticImpacts`] is a hook of Rapier that gives each new contact of a ball the tangential velocity after the
//! impact by R_x of `carom`, a function of three numbers: chi, for inertia and Poisson's ratio, psi, slip speed over
//! friction times approach speed, and the coefficient of restitution, which below 1 is that of a viscous material.
//! Coefficients of friction and restitution stay those of Rapier's colliders.
//!
//! ```
//! use carom_rapier::ElasticImpacts;
//! use rapier3d::prelude::*;
//!
//! let mut world = PhysicsWorld::new();
//! let surface = |shape: ColliderBuilder| shape.restitution(0.9).friction(0.6);
//! let ground = RigidBodyBuilder::fixed().translation(-Vector::Y);
//! world.insert(ground, surface(ColliderBuilder::cuboid(50.0, 1.0, 50.0)));
//! let thrown = RigidBodyBuilder::dynamic()
//!     .translation(0.5 * Vector::Y)
//!     .angvel(AngVector::new(0.0, 0.0, 10.0));
//! let ball = surface(ColliderBuilder::ball(0.2));
//! let (thrown, _) = world.insert(thrown, ball.active_hooks(ActiveHooks::MODIFY_SOLVER_CONTACTS));
//! let impacts = ElasticImpacts::new(0.5)?; // Poisson's ratio of rubber
//! for _ in 0..20 {
//!     world.step_with_events(&impacts, &());
//! }
//! // The point of the ball that touched turns back. That of a rigid ball would stop.
//! let ball = &world.bodies[thrown];
//! assert!(ball.linvel().x + 0.2 * ball.angvel().z < -0.1);
//! # Ok::<(), carom_special::RangeError>(())
//! ```
#![forbid(unsafe_code)]

mod impact;
mod side;

pub use impact::Impact;

use carom_special::RangeError;
use rapier3d::glamx::DVec3;
use rapier3d::prelude::*;

use side::Side;

/// Over the limit of the whole impact. The tangential velocity that is asked for keeps Coulomb's limit by itself. Rapier's
/// own limit must leave it room: it follows a point of the ball that turns away from the floor within the step, so that
/// part of the normal impulse comes too late, and it is up to 0.6 % too low for slip between its two tangents.
const ROOM: f32 = 10.0;

/// A hook that makes the impacts of balls elastic along the surface as well: of two balls, and of a ball and a body
/// that does not move, of any shape.
///
/// It acts on a contact that bears its first load. A contact that persists, such as that of a ball that rolls or rests,
/// stays Rapier's, as do other shapes, balls with locked axes, and bodies of several colliders.
///
/// Switch it on for the colliders with [`ActiveHooks::MODIFY_SOLVER_CONTACTS`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticImpacts {
    kappa: f64,
}

impl ElasticImpacts {
    /// For bodies of like material with this Poisson's ratio; 0.5, rubber, is exact for a rigid floor too.
    ///
    /// # Errors
    /// [`RangeError`] unless it is in (-1, 0.5].
    pub fn new(poisson: f64) -> Result<Self, RangeError> {
        let holds = poisson > -1.0 && poisson <= 0.5;
        RangeError::check("poisson", poisson, holds, "in (-1, 0.5]")?;
        // Normal over tangential stiffness of the contact.
        Ok(Self { kappa: (2.0 - poisson) / (2.0 * (1.0 - poisson)) })
    }

    fn modify(&self, context: &mut ContactModificationContext<'_>) -> Option<()> {
        let (bodies, colliders) = (context.bodies, context.colliders);
        let handles = [context.rigid_body1, context.rigid_body2];
        let shapes = [&colliders[context.collider1], &colliders[context.collider2]];
        let contact = context.rigid_mut()?;
        let [touch] = contact.solver_contacts.as_mut_slice() else { return None };
        let is_new = contact.manifold.points.iter().all(|point| point.data.impulse == 0.0);
        // Rapier lets a contact bounce in the step of its first load only.
        if !(is_new || *contact.restitution >= 1.0) {
            return None;
        }
        // From body 1 into body 2.
        let normal = contact.normal.as_dvec3();
        let dominance = contact.manifold.data.relative_dominance;
        let moves = [dominance <= 0, dominance >= 0];
        let body = |i: usize| handles[i].and_then(|handle| bodies.get(handle));
        let one = Side::new(body(0), shapes[0], moves[0], normal, touch.anchor1)?;
        let two = Side::new(body(1), shapes[1], moves[1], -normal, touch.anchor2)?;
        let impact = Impact {
            normal,
            velocity: one.at_contact() - two.at_contact(),
            normal_mobility: one.inverse_mass + two.inverse_mass,
            tangential_mobility: one.tangential_mobility(one.radius)
                + two.tangential_mobility(two.radius),
            kappa: self.kappa,
            friction: f64::from(*contact.friction),
            restitution: f64::from(*contact.restitution),
        };
        let drag = impact.tangential_impulse()?;
        // Rapier applies the impulse midway in the gap, and turns the bodies by arms to that point. With these the
        // impulse is reached at another velocity than that of the surfaces.
        let middle = middle(touch, normal);
        let shift = one.to_surface(&two, middle);
        touch.anchor1 += shift.as_vec3();
        touch.anchor2 += shift.as_vec3();
        let point = middle + shift;
        let arms = [one.arm_to(point), two.arm_to(point)];
        let slip = impact.across(one.at_arm(arms[0]) - two.at_arm(arms[1]));
        let mobility = one.tangential_mobility(arms[0]) + two.tangential_mobility(arms[1]);
        touch.tangent_velocity = -(slip + mobility * drag).as_vec3();
        // The impulse of the rebound counts for Coulomb's limit too; Rapier knows that which stops the approach.
        *contact.friction *= ROOM * (1.0 + *contact.restitution);
        Some(())
    }
}

impl PhysicsHooks for ElasticImpacts {
    fn modify_solver_contacts(&self, context: &mut ContactModificationContext<'_>) {
        // A contact of another kind stays as it is.
        let _ = self.modify(context);
    }
}

/// Where Rapier will apply the impulse: it moves point 1 until the points are as far apart as `dist` says, and takes
/// the middle.
fn middle(touch: &SolverContact, normal: DVec3) -> DVec3 {
    let between = (touch.anchor2 - touch.anchor1).as_dvec3().dot(normal);
    let gap = f64::from(touch.dist);
    0.5 * (touch.anchor1 + touch.anchor2).as_dvec3() + 0.5 * (between - gap) * normal
}
