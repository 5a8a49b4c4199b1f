//! Oblique impact with coupled normal and tangential motion: a full mobility matrix D, different
//! c_x and c_y, turning directions (sections 8.2 to 8.5).
//!
//! The motion dv/dt = -D F is integrated with any contact law. Two laws are built in
//! ([`TurningLaw`]): Coulomb's law for each annulus, and the law of the thesis with one direction
//! per slip annulus. If the motion stays in one plane through the normal, both agree and the memory
//! is exact.
//!
//! Coulomb's law uses a curve ([`carom_laws::coulomb`]) if c_x = c_y and the impact resembles a
//! free one, otherwise line segments ([`carom_laws::sliders::SlipLines`]). In 60 random impacts of
//! the former kind the curve took 0.7 of the time of the segments at 1e-3, 0.4 from 1e-4 to 1e-6
//! and 0.25 at 1e-7.
//!
//! Fixed directions are ten times cheaper. Their differences from Coulomb's law, over |v_A|, were
//! measured in at least 1000 random impacts of each kind (f from 0.05 to 1, slip up to 6 f times
//! the approach velocity). Median, upper decile and maximum are: steel ellipsoids upright on a
//! plane 0.2 %, 1.4 %, 6 %; tilted and spinning ellipsoids and crossed cylinders 0.8 %, 4 %, 13 %;
//! random mobilities with couplings up to 0.6 sqrt(D_ii D_jj), c_x/c_y from 2/3 to 3/2 and f up to
//! 1.5: 1.7 %, 6 %, 37 %. If sliding drives the normal motion and c_x and c_y differ much, fixed
//! directions may create energy (1.7 % in one of 60 000 extreme impacts). Such an impact is
//! reported as not converged.
//!
//! If f |D_tz| exceeds D_zz, sliding in one direction drives the bodies together (Painleve's
//! wedging). The force then grows by its own work until sliding stops. The impact may become a
//! thousand times as strong within a small part of the time of a free one, and often the bodies are
//! compressed several times. Sliding in the other direction drives them apart. Elastic contacts
//! have one solution in each case: the normal impulse grows during contact, and a positive definite
//! D lets the bodies separate. Steps are chosen from the state, so that such an impact is resolved
//! like any other.

mod adams;
mod any_law;
mod direction;
mod error;
mod exact;
mod extrapolation;
mod impact;
mod jump;
mod limits;
mod log;
mod method;
mod outcome;
mod pace;
mod point;
mod refine;
mod run;
mod scaled;
mod schedule;
mod solve;
mod springs;
mod stage;
mod trajectory;
mod turning;
mod viscous;

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
pub use point::Point;
pub use stage::{Stage, Staged};
pub use trajectory::{LawFailure, Trajectory};
pub use viscous::{StepError, left_by_loss};
