//! Solvers of collisions, for scenes and studies.

use carom_special::RangeError;

use super::{Collision, CollisionError, NeededLaw};
use crate::outcome::Outcome;
use crate::rings::{RingImpact, RingImpactError};

/// Computes collisions, with one contact law or with a law chosen for each collision.
///
/// Scenes and studies of uncertain inputs compute all their impacts with one solver, by default
/// [`AnalyticOrRings`].
pub trait CollisionSolver {
    /// Why a collision could not be computed.
    type Error: From<CollisionError>;

    /// Computes a collision up to separation.
    ///
    /// # Errors
    /// If it cannot be computed.
    fn solve(&self, collision: &Collision) -> Result<Outcome, Self::Error>;

    /// The value that was out of range, if that was the error.
    fn out_of_range(error: &Self::Error) -> Option<RangeError>;
}

/// The analytic law, or the law of rings where [`Collision::needed_law`] requires it.
///
/// For dissimilar bodies other than spheres and planes it uses the analytic law, with
/// [`carom_laws::validity::Limit::Coupling`].
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{AnalyticOrRings, Body, Collision, CollisionSolver, Motion};
/// use carom_laws::friction::Friction;
/// let alumina = Material::from_young(380e9, 0.23)?;
/// let ball = Body::sphere(2.5e-3, alumina, 2.6e-4)?
///     .moving(Motion::new([0.1, 0.0, -2.0], [0.0; 3])?);
/// let plate = Body::plane(Material::from_young(70e9, 0.22)?);
/// let outcome = AnalyticOrRings.solve(&Collision::new(ball, plate, Friction::new(0.092)?)?)?;
/// let rebound = outcome.rebound().ok_or("they meet")?;
/// assert_eq!(rebound.method.name(), "rings");
/// assert!(rebound.r_x.unwrap_or(0.0) > 0.19); // on a grid 0.20, without coupling -0.21
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct AnalyticOrRings;

impl CollisionSolver for AnalyticOrRings {
    type Error = CollisionError;

    fn solve(&self, collision: &Collision) -> Result<Outcome, CollisionError> {
        match collision.default_law() {
            NeededLaw::Analytic => collision.solve_with_needed_torsion(),
            NeededLaw::Rings => Ok(RingImpact::new(collision).solve()?),
            NeededLaw::Grid => collision.solve(),
        }
    }

    fn out_of_range(error: &CollisionError) -> Option<RangeError> {
        match error {
            CollisionError::Range(error) => Some(*error),
            _ => None,
        }
    }
}

impl From<RingImpactError> for CollisionError {
    fn from(error: RingImpactError) -> Self {
        match error {
            RingImpactError::Range(error) => Self::Range(error),
            RingImpactError::Collision(error) => error,
            RingImpactError::NoSeparation => Self::NoSeparation,
        }
    }
}
