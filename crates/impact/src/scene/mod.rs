//! A ball that flies under gravity and bounces between fixed walls.
//!
//! Between two bounces the centre moves on a parabola (no drag) and the spin is constant. The next wall is
//! the one that the ball touches first, found from the roots of the distance, a polynomial in time. Each
//! bounce is a [`Collision`](crate::Collision) along the normal of the wall. It is short compared with the
//! flight: its duration and gravity during it are neglected.

mod ball;
mod error;
mod flight;
mod path;
mod roots;
mod run;
mod wall;

pub use ball::Ball;
pub use error::SceneError;
pub use path::{Bounce, Ending, Leg, Limits, Path, PathPoint};
pub use run::{Legs, Scene};
pub use wall::{Extent, Wall};
