//! Oblique impact with normal and tangential motion coupled: a full mobility matrix D, unlike
//! c_x and c_y, a turning direction (sections 8.2 to 8.5).
//!
//! The motion dv/dt = -D F is followed with any contact law. Two are at hand: Coulomb's friction ring
//! by ring, the true vector law, and the thesis's memory with one direction per slip ring. Motion in
//! one plane through the normal needs no choice: the memory is exact there.
//!
//! Where f |D_tz| exceeds D_zz, sliding one way drives the bodies together (Painleve's wedging):
//! the force grows by its own work until the sliding stops, and the impact may grow a thousandfold
//! within a small part of the time of a free one; often the bodies are pressed together again.
//! Sliding the other way drives them apart. With elastic contacts each of these has one solution:
//! the normal impulse grows while they touch, and a positive definite D lets them part. Steps are
//! chosen from the state, so that such an impact is resolved like any other.

mod adams;
mod any_law;
mod error;
mod exact;
mod extrapolation;
mod impact;
mod limits;
mod log;
mod method;
mod outcome;
mod pace;
mod refine;
mod scaled;
mod schedule;
mod stage;
mod trajectory;

pub use any_law::VectorLaw;
pub use carom_laws::law::ImpactLaw;
pub use error::CoupledError;
pub(crate) use exact::Traced;
pub use impact::CoupledImpact;
pub(crate) use impact::Unsettled;
pub use method::ImpactMethod;
pub(crate) use method::is_coupled;
pub use outcome::{CoupledOutcome, Sample};
pub use stage::{Stage, Staged};
pub use trajectory::{LawFailure, Point, Trajectory};
