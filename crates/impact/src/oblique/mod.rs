//! Exact oblique impact with uncoupled normal and tangential motion (sections 8.3 to 8.5 and 9.2 to
//! 9.4).
//!
//! The solution passes through adhesion, partial slip and sliding, in any order. It takes no time steps: the
//! normal motion is known in advance, so that its velocity w, which runs from 1 to -1, takes the place of time.
//!
//! - Adhesion obeys Gegenbauer's equation `(1 - w^2) u'' - (6/5) w u' + (6/5) chi u = 0`, solved by power series.
//! - Partial slip has a first integral in the memory, up to a remainder that is integrated.
//! - In sliding the tangential velocity is linear in w.
//!
//! Positions are measured by a coordinate in which the motion is analytic at first contact and at separation.
//! Differences are formed without cancellation, so that grazing impact and infinite friction keep their digits.
//!
//! Two dimensionless groups govern it: `chi = D_xx c_x / (D_zz c_z)` and
//! `psi = c_x |xi'| / (f c_z zeta')`. For spheres chi = 7/(2 kappa) and psi = lambda/kappa.

mod adhesion;
mod extremes;
mod groups;
mod impact;
mod limit;
mod memory;
mod onset;
mod position;
mod recorder;
mod regime;
mod slip;
mod slip_integration;
mod state;
mod trace;
mod trajectory;

pub use groups::Groups;
pub use impact::ObliqueImpact;
pub use regime::{Event, ObliqueError, Phase, Regime};
pub use trace::TracePoint;
