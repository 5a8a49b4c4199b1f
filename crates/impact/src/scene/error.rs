//! Errors of a scene.

use carom_special::ode::OdeError;
use carom_special::{RangeError, Readable};

use crate::collision::CollisionError;

/// Why a scene cannot be built or computed; `E` is the error of its
/// [`CollisionSolver`](crate::CollisionSolver). Walls are numbered from 0 in the order they were added.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SceneError<E = CollisionError> {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The motion of the ball on a wall cannot be followed.
    #[error(transparent)]
    OnWall(#[from] OdeError),
    /// The body is not a sphere.
    #[error(
        "the ball must be a sphere, not a {shape}: a scene computes the flight of spheres only"
    )]
    NotASphere {
        /// Its shape.
        shape: &'static str,
    },
    /// The ball overlaps a wall at the start.
    #[error("the ball starts inside wall {wall}: the gap between them is {} and must be >= 0", Readable(*gap))]
    Inside {
        /// The wall.
        wall: usize,
        /// Distance of the ball's surface from the wall; negative.
        gap: f64,
    },
    /// The ball and a wall cannot collide.
    #[error("wall {wall}: {source}")]
    Collision {
        /// The wall.
        wall: usize,
        /// The reason.
        source: E,
    },
}

impl SceneError {
    /// The same error for a scene with another solver.
    pub(super) fn of_solver<E: From<CollisionError>>(self) -> SceneError<E> {
        match self {
            Self::Range(error) => SceneError::Range(error),
            Self::OnWall(error) => SceneError::OnWall(error),
            Self::NotASphere { shape } => SceneError::NotASphere { shape },
            Self::Inside { wall, gap } => SceneError::Inside { wall, gap },
            Self::Collision { wall, source } => {
                SceneError::Collision { wall, source: source.into() }
            }
        }
    }
}
