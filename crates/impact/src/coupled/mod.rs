//! Oblique impact with normal and tangential motion coupled: a full mobility matrix D, unlike
//! c_x and c_y, a turning direction (sections 8.2 to 8.5).
//!
//! The motion dv/dt = -D F is followed with any contact law. Two are at hand: Coulomb's friction ring
//! by ring, the true vector law, and the thesis's memory with one direction per slip ring
//! ([`TurningLaw`]). Motion in one plane through the normal needs no choice: the memory is exact there.
//!
//! Coulomb's anchors lie on a curve ([`carom_laws::coulomb`]) where c_x = c_y and the impact passes much
//! like a free one, else on a line ([`carom_laws::sliders::SlipLines`]); in 60 random impacts of the former
//! kind the curve took 0.7 of the time at 1e-3, 0.4 from 1e-4 to 1e-6 and 0.25 at 1e-7. Fixed directions
//! are ten times cheaper. How far they leave Coulomb's law, as a part of |v_A|, in 1000 random impacts or
//! more each (f from 0.05 to 1, slip up to 6 f times the speed of approach): half of them below, one in ten
//! above, the most seen. Steel ellipsoids upright on a plane 0.2 %, 1.4 %, 6 %; tilted and spinning ones
//! and crossed cylinders 0.8 %, 4 %, 13 %; random mobilities with couplings up to 0.6 sqrt(D_ii D_jj),
//! c_x/c_y from 2/3 to 3/2 and f up to 1.5: 1.7 %, 6 %, 37 %. Where sliding drives the normal motion and
//! c_x and c_y differ much they may create energy (1.7 % in one of 60 000 extreme impacts): such an impact
//! has no outcome and is refused as not settled.
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

pub use carom_laws::law::ImpactLaw;
pub use carom_laws::turning_law::TurningLaw;
pub use error::CoupledError;
pub(crate) use exact::Traced;
pub use impact::CoupledImpact;
pub(crate) use impact::Unsettled;
pub(crate) use log::Log;
pub use method::ImpactMethod;
pub(crate) use method::is_coupled;
pub use outcome::{CoupledOutcome, Sample};
pub use stage::{Stage, Staged};
pub use trajectory::{LawFailure, Point, Trajectory};
