//! Exact oblique impact with uncoupled normal and tangential motion (sections 8.3 to 8.5 and 9.2 to
//! 9.4).
//!
//! The solution passes through adhesion, partial slip and sliding, in any order.
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
