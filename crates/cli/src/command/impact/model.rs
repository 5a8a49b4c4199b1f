//! From a case to the collisions of the library.

use crate::case::{BodyCase, ImpactCase, Mass, Shape};
use carom_geometry::Inertia;
use carom_impact::{Body, Collision, CollisionError, Motion};
use carom_laws::friction::Friction;
use carom_special::RangeError;

/// A collision to compute.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shot {
    /// Angle of incidence, degrees, if the case gives it.
    pub(super) angle: Option<f64>,
    /// The motions before, of body 1 and body 2.
    pub(super) before: [Motion; 2],
    /// The collision.
    pub(super) collision: Collision,
}

/// The collisions of a case: one, or one for each angle of a sweep.
pub(super) fn shots(case: &ImpactCase) -> Result<Vec<Shot>, CollisionError> {
    let friction = Friction::new(case.contact.friction)?;
    let body_2 = body(&case.body_2)?.moving(motion(&case.body_2, None)?);
    let shot = |angle: Option<f64>| {
        let velocity = match (&case.approach, angle) {
            (Some(approach), Some(angle)) => Some(approach.velocity(angle)),
            _ => None,
        };
        let body_1 = body(&case.body_1)?.moving(motion(&case.body_1, velocity)?);
        let collision = Collision::new(body_1, body_2, friction)?;
        let collision = match case.contact.torsion {
            Some(_) => collision.with_torsion(),
            None => collision,
        };
        Ok(Shot { angle, before: [body_1.motion(), body_2.motion()], collision })
    };
    match &case.approach {
        None => Ok(vec![shot(None)?]),
        Some(approach) => {
            approach.angles.as_slice().iter().map(|angle| shot(Some(*angle))).collect()
        }
    }
}

/// The one collision of a case that is no sweep: the first of a sweep.
pub(super) fn collision(case: &ImpactCase) -> Result<Collision, CollisionError> {
    let shot = shots(case)?.into_iter().next().map(|shot| shot.collision);
    // Every case has at least one angle.
    shot.ok_or_else(|| RangeError::new("angle", f64::NAN, "given").into())
}

fn body(case: &BodyCase) -> Result<Body, RangeError> {
    let mass = match case.mass {
        Mass::Given(mass) => mass,
        Mass::Fixed => f64::INFINITY,
    };
    match case.shape {
        Shape::Sphere { radius } => Body::sphere(radius, case.material, mass),
        // A plane is guided: it gives way, but does not turn.
        Shape::Plane => {
            Ok(Body::plane(case.material).with_inertia(Inertia::new(mass, [f64::INFINITY; 3])?))
        }
    }
}

fn motion(case: &BodyCase, approach: Option<[f64; 3]>) -> Result<Motion, RangeError> {
    Motion::new(approach.or(case.velocity).unwrap_or_default(), case.spin)
}
