//! A ball that flies under gravity and bounces between planes held fast.
//!
//! Between two bounces the centre moves on a parabola (no drag) and the spin stays as it is; the
//! next plane is the one that the ball touches first, found from the roots of the distance as a
//! polynomial of time. Each bounce is a [`Collision`](crate::Collision) along the plane's normal,
//! short against the flight: its duration does not count and gravity does nothing during it.

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
