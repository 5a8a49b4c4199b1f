//! Why a scene cannot be run.

use carom_special::{RangeError, Readable};

use crate::collision::CollisionError;

/// Why a scene cannot be built or run; `E` is the error of its [`CollisionSolver`](crate::CollisionSolver). Walls
/// count from 0 in the order they were added.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum SceneError<E = CollisionError> {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The body that should fly is no sphere.
    #[error(
        "the ball must be a sphere, not a {shape}: the turning of other bodies in flight is not followed"
    )]
    NotASphere {
        /// What it is.
        shape: &'static str,
    },
    /// The ball reaches into a wall at the start.
    #[error("the ball starts inside wall {wall}: the gap between them is {} and must be >= 0", Readable(*gap))]
    Inside {
        /// Which wall.
        wall: usize,
        /// Distance of the ball's surface from the wall; negative.
        gap: f64,
    },
    /// The ball and a wall cannot collide.
    #[error("wall {wall}: {source}")]
    Collision {
        /// Which wall.
        wall: usize,
        /// Why.
        source: E,
    },
}

impl SceneError {
    /// As the error of a scene that another solver follows.
    pub(super) fn of_solver<E: From<CollisionError>>(self) -> SceneError<E> {
        match self {
            Self::Range(error) => SceneError::Range(error),
            Self::NotASphere { shape } => SceneError::NotASphere { shape },
            Self::Inside { wall, gap } => SceneError::Inside { wall, gap },
            Self::Collision { wall, source } => {
                SceneError::Collision { wall, source: source.into() }
            }
        }
    }
}
