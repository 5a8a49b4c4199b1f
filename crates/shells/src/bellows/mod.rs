//! Expansion bellows: corrugated shells of revolution with large rotation (proposition 5).
//!
//! An infinite row of equal corrugations is loaded by pressure and stretched or compressed along
//! its axis. The meridian r0(xi), z0(xi) of one corrugation runs upward with the outside at its
//! right, from a crest at xi = 0 over a root at xi = pi to the next crest; its angle phi0 has
//! r0' = cos phi0, z0' = sin phi0 by arc length. Reissner's equations (small strain, finite rotation
//! beta, u outward, h = r0 H with the radial resultant H) are
//!
//! - resultants: r0 V = p r^2/2 + F/(2 pi), N_s = (h cos phi + r0 V sin phi)/r0, phi = phi0 + beta,
//! - strains: eps_s = N_s/C - nu u/r0, eps_t = u/r0, kappa_s = beta', kappa_t = (sin phi - sin phi0)/r0,
//! - loads: N_t = nu N_s + E t eps_t, M_s = D(kappa_s + nu kappa_t), M_t = D(kappa_t + nu kappa_s),
//! - moments: (r0 M_s)' - M_t cos phi - (1 + eps_s)(h sin phi - r0 V cos phi) = 0,
//! - radial forces: h' - N_t + p r (1 + eps_s) sin phi = 0,
//! - fit: u' - (1 + eps_s) cos phi + cos phi0 = 0.
//!
//! Pressure follows the surface. beta and h are sine series, u is a cosine series: planes of
//! symmetry at crest and root are built in. Newton's method solves for their coefficients; its
//! matrix is made of product matrices ([`crate::fourier`]), in the units E = t = 1.
//!
//! F > 0 is tension on closed ends, beside the pressure on them. The dilatation is the growth in
//! length of one corrugation. Contact of neighbouring folds is not followed: each state tells their
//! least distance ([`BellowsState::least_gap`]).

mod axial;
mod equations;
mod fields;
mod grid;
mod linear;
mod meridian;
mod newton;
mod path;
mod profile;
mod state;
mod system;

pub use axial::{Axial, BellowsLoad};
pub use linear::LinearResponse;
pub use meridian::{Meridian, MeridianPoint};
pub use newton::NotConverged;
pub use path::{LimitKind, LoadPath, PathEnd};
pub use profile::WallPoint;
pub use state::{BellowsState, Convergence};
pub use system::{Bellows, BellowsError};
