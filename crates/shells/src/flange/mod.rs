//! A flange at the end of a tube, under forces around it, by Fourier matrices (proposition 4).
//!
//! The flange is a ring of centroid radius R. The coordinate x runs along the tube, which occupies
//! x >= 0; phi runs around. A section of the ring is displaced by w outward, v along phi and u
//! along x, and turns by beta = dw/dx of a wall fixed to it. With ' = d/dphi
//!
//! | strain | load |
//! |---|---|
//! | stretching (v' + w)/R | N = EA times it |
//! | curvature in the plane (v' - w'')/R^2 | M = EI times it |
//! | curvature out of the plane beta/R - u''/R^2 | M_o = EJ times it |
//! | twist beta'/R + u'/R^2 | T = GJ times it |
//!
//! Displacements are series of e^(ik phi) up to |k| = n. The energy of the ring,
//! pi R sum of B^H T(.) B, and that of the tube, whose edge has a 4 by 4 stiffness for each
//! harmonic ([`EdgeStiffness`]), give a Hermitian system of 4(2n + 1) equations. Stiffness that
//! jumps around the ring follows the rule of the jump: T(1/EI)^-1 ([`crate::fourier`]).
//!
//! Two readings of "singular forces, acting symmetrically" are ready: [`RingForce::pinch`], radial
//! forces at 0 and pi, and [`RingForce::pry`], axial forces there.
//!
//! ```
//! use carom_shells::Wall;
//! use carom_shells::flange::{Flange, Ring, RingForce, RingStiffness, Tube, TubeEdge};
//! let section = RingStiffness::rectangle(2e11, 0.3, 0.02, 0.03)?; // 20 mm along x, 30 mm outward
//! let ring = Ring::new(0.3, section)?;
//! let tube = Tube::half_momentless(0.3, Wall::new(2e11, 0.3, 4e-3)?)?;
//! let pinch = RingForce::pinch(1e4)?;
//! let bare = Flange::bare(ring.clone()).solve(&pinch, 32)?;
//! let held = Flange::on_tube(ring, tube, TubeEdge::at_centroid())?.solve(&pinch, 32)?;
//! // The tube stiffens the flange: half of the opening is left.
//! let ratio = held.displacement(0.0).radial / bare.displacement(0.0).radial;
//! assert!(0.3 < ratio && ratio < 0.9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod edge;
mod force;
mod half_momentless;
mod kink;
mod polynomial;
mod ring;
mod section;
mod solution;
mod system;
mod tube;
mod whole_shell;

pub use edge::{EdgeMotion, EdgeStiffness, TubeEdge};
pub use force::RingForce;
pub use ring::Ring;
pub use section::{RingStiffness, StiffnessKind};
pub use solution::{FlangeSolution, RingDisplacement, RingLoads, Shallowness};
pub use system::{Flange, FlangeError};
pub use tube::Tube;
