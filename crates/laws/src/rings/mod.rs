//! The law of rings: a circular contact of dissimilar bodies with memory, in which shift in two directions,
//! twist and coupling act together.
//!
//! The contact is divided into rings, and each ring into angles. The rings scale with the contact radius, so
//! that one matrix serves every radius. With tractions divided by f, the approach a^2 and Gamma = gamma/f,
//!
//! ```text
//! slip s = w - u,   w = xi + Omega x r + Gamma g(r; a),   u = kappa K q + (kappa - 1) L conj(q)
//!                                                              - gamma^2 G K0^-1 G^T q
//! |q| <= p,         p = Hertz + gamma f K0^-1 G^T q
//! ```
//!
//! K, L, K0 and G are surface displacements by tractions and pressures (Cerruti, Boussinesq), by harmonics
//! about the normal; g is the radial displacement by Hertz's pressure (15.2), outwards for gamma > 0. A point
//! sticks where |q| < p and slips along q where |q| = p. The terms quadratic in gamma are the pressure that
//! tractions add, since the bodies cannot overlap. Tractions along x also move the centre of the contact, by some
//! gamma f a/3 in sliding, and the rings move with it (`centre`). The law neglects that the contact area is no circle: against a
//! grid of 72 cells the normal force was .0003 off at gamma f = .2, and the friction force .001 f F_z while approach and
//! shift grew in proportion (.02 about a fixed centre).
//!
//! A place that enters the contact at the rim has the slip of the rim. Slip inside is transported by
//! interpolation. The history outside a receding rim is dropped. Each step is one convex problem, which is
//! solved to the tolerance of [`RingLaw`]. The step is of second order: slip that continues is extrapolated.

mod carry;
mod centre;
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
mod without_slip;

pub use constants::{RingConstants, Tolerance};
pub use law::RingLaw;
pub use matrices::{RingMatrices, Rings};
pub use memory::RingMemory;
pub use pack::packed_numbers;
pub use symmetry::{AlikePlane, Plane, Symmetry, Whole};
