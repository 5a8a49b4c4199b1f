//! Oblique impact with normal and tangential motion coupled: a full mobility matrix D, unlike
//! c_x and c_y, a turning direction (sections 8.2 to 8.5).
//!
//! The motion dv/dt = -D F is followed with any contact law. Two are at hand: rings in parallel
//! with Coulomb's friction, the true vector law, and the thesis's memory with one direction per
//! slip ring. Motion in one plane through the normal needs no choice: the memory is exact there.

mod bare_law;
mod course;
mod impact;
mod passage;
mod refine;
mod rings;
mod stage;

pub use course::{Course, Point};
pub use impact::{CoupledError, CoupledImpact, CoupledOutcome, Sample, VectorLaw};
pub use passage::Passage;
pub(crate) use passage::is_coupled;
pub use rings::{CoulombRings, sliding_direction};
pub use stage::{Stage, Staged};
