//! Oblique impact whose normal and tangential motions are uncoupled, solved exactly through
//! adhesion, partial slip, sliding and their re-entry (sections 8.3 to 8.5 and 9.2 to 9.4).
//!
//! Two numbers govern it: `chi = D_xx c_x / (D_zz c_z)` and `psi = c_x |xi'| / (f c_z zeta')`.
//! Spheres: chi = 7/(2 kappa), psi = lambda/kappa.

mod adhesion;
mod groups;
mod impact;
mod limit;
mod memory;
mod onset;
mod place;
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
