//! A circular contact of dissimilar bodies with memory: shift in two directions, twist and coupling act
//! together.
//!
//! The contact is cut into rings, each ring into angles; the rings move with the contact radius, so that
//! one matrix serves every radius. With tractions over f, the approach a^2 and Gamma = gamma/f,
//!
//! ```text
//! slip s = w - u,   w = xi + Omega x r + Gamma g(r; a),   u = kappa K q + (kappa - 1) L conj(q)
//!                                                              - gamma^2 G K0^-1 G^T q
//! |q| <= p,         p = Hertz + gamma f K0^-1 G^T q
//! ```
//!
//! K, L, K0 and G are displacements of the surface by tractions and pressures (Cerruti, Boussinesq), by
//! harmonics about the normal; g is the radial displacement that Hertz's pressure brings about by (15.2),
//! positive outwards for gamma > 0. A point sticks where |q| < p and slips along q where |q| = p. The
//! quadratic terms in gamma are the pressure that tractions add, since the bodies do not overlap. What is
//! left out is that the contact area then differs from Hertz's, of second order in gamma.
//!
//! Slip of what enters at the rim is that of the rim; slip inside is carried along by interpolation. What
//! the receding rim leaves is forgotten. A step is one convex problem ([`RingLaw`]'s tolerance is that of
//! its solution), of second order in the step: slip that goes on is taken on ahead.

mod carry;
mod constants;
mod contact;
mod dense;
mod influence;
mod kernel;
mod law;
mod layout;
mod matrices;
mod memory;
mod pack;
mod pair;
mod recent;
mod solve;
mod symmetry;
mod transform;
mod units;

pub use constants::{RingConstants, Tolerance};
pub use law::RingLaw;
pub use matrices::{RingMatrices, Rings};
pub use memory::RingMemory;
pub use pack::packed_numbers;
pub use symmetry::{AlikePlane, Plane, Symmetry, Whole};
