//! **carom**: elastic impact with friction.
//!
//! What happens when two elastic bodies touch, slip, stick, twist and rebound, after
//! J. Jaeger, *Elastic Impact with Friction* (TU Delft, 1992). This crate re-exports the layers,
//! each of which uses only those below it:
//!
//! | floor | module | thesis |
//! |---|---|---|
//! | impact on a grid | [`numerical`] | 15.2 |
//! | motion | [`impact`] | ch. 8, 9, 10, 15 |
//! | rolling | [`rolling`] | 16.2 |
//! | programs of 1992 | [`classic`] | ch. 11, 12 |
//! | numerical contact | [`solver`] | ch. 11-14 |
//! | laws | [`laws`] | ch. 5-7, 10.5, 14.4 |
//! | geometry | [`geometry`] | 5.1, 8.1 |
//! | half-space | [`halfspace`] | ch. 4 |
//! | rings and shells | [`shells`] | propositions 4, 5 |
//! | special functions | [`special`] | |
//!
//! ```
//! use carom::prelude::*;
//!
//! // An alumina ball of 5 mm meets a plate of the same material at 45 degrees with 3.9 m/s.
//! let alumina = Material::from_young(380e9, 0.23)?;
//! let ball = Body::sphere(2.5e-3, alumina, 2.618e-4)?
//!     .moving(Motion::new([2.758, 0.0, -2.758], [0.0; 3])?);
//! let collision = Collision::new(ball, Body::plane(alumina), Friction::new(0.092)?)?;
//! let outcome = collision.solve()?;
//! let rebound = outcome.rebound().ok_or("the bodies approach each other")?;
//! // Friction slows the ball and spins it up; here it slides throughout.
//! assert!(rebound.motions[0].velocity.x < 2.758 && rebound.motions[0].spin.y > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

pub use carom_classic as classic;
pub use carom_geometry as geometry;
pub use carom_geometry::nalgebra;
pub use carom_halfspace as halfspace;
pub use carom_impact as impact;
pub use carom_laws as laws;
pub use carom_numerical as numerical;
pub use carom_rolling as rolling;
pub use carom_shells as shells;
pub use carom_solver as solver;
pub use carom_special as special;
pub use carom_table as table;

/// The names most programs need.
pub mod prelude {
    pub use carom_geometry::{Attitude, Inertia, Surface};
    pub use carom_halfspace::{Force, Grid, Material, MaterialPair, Point, PointLoad};
    pub use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
    pub use carom_impact::{Body, Collision, Motion, Outcome, Rebound};
    pub use carom_laws::accounted::Accounted;
    pub use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
    pub use carom_laws::ellipse::ContactEllipse;
    pub use carom_laws::friction::Friction;
    pub use carom_laws::hertz::Hertz;
    pub use carom_laws::law::{ContactLaw, ContactLoad, Energies, Shift};
    pub use carom_laws::shift_law::ShiftLaw;
    pub use carom_laws::stiffness::ContactStiffness;
    pub use carom_solver::{
        CellState, ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method,
    };
    pub use carom_special::elliptic::complete;
    pub use carom_special::{AxisRatio, RangeError};
}
