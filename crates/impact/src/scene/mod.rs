//! A ball that flies under gravity and bounces between walls, of which infinite ones may move.
//!
//! Between two bounces the centre moves on a parabola (no drag) and the spin is constant. The next wall is
//! the one that the ball touches first, found from the roots of the distance, a polynomial in time. Each
//! bounce is a [`Collision`](crate::Collision) along the normal of the wall. It is short compared with the
//! flight: its duration and gravity during it are neglected. A ball that no longer rises from a wall slides and rolls on it
//! until it rests, comes to the edge or meets another wall.

mod ball;
mod chatter;
mod error;
mod flight;
mod glide;
mod on_wall;
mod path;
mod roots;
mod run;
mod turned;
mod wall;
mod wall_motion;

pub use ball::Ball;
pub use error::SceneError;
pub use path::{Bounce, Ending, Event, EventKind, Leg, Limits, Manner, Path, PathPoint};
pub use run::{Legs, Scene};
pub use wall::{Extent, Wall};
pub use wall_motion::WallMotion;
