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
//! # Layer by layer
//!
//! From the top down. Each layer has a one-page program in the folder `examples` of this crate as well, such as
//! `cargo run --release -p carom --example motion`.
//!
//! **Motion.** A collision is made of two bodies, with their materials and motions, and a coefficient of friction.
//!
//! ```
//! use carom::prelude::*;
//!
//! let steel = Material::from_young(208e9, 0.3)?;
//! let ball = Body::sphere(0.01, steel, 0.033)?.moving(Motion::new([0.5, 0.0, -1.0], [0.0; 3])?);
//! let outcome = Collision::new(ball, Body::plane(steel), Friction::new(0.15)?)?.solve()?;
//! let rebound = outcome.rebound().ok_or("they meet")?;
//! let regimes: Vec<_> = rebound.log.iter().map(|entry| entry.regime.name()).collect();
//! assert_eq!(regimes, ["slide+", "adhesion", "slip-", "slide-"]);
//! assert!(rebound.energy.after < rebound.energy.before && rebound.warnings.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Laws.** A contact law turns a history of relative displacements into forces. `zeta` is the approach along the
//! normal, `xi` the tangential shift. The law remembers the history.
//!
//! ```
//! use carom::laws::shift_law::ShiftLaw;
//! use carom::prelude::*;
//!
//! let stiffness = ContactStiffness::new(0.8, 0.8, 1.0)?;
//! let mut law = ShiftLaw::<[f64; 2]>::new(stiffness, Friction::new(0.3)?);
//! law.advance(Shift { zeta: 1.0, ..Shift::default() })?;
//! law.advance(Shift { zeta: 1.0, xi: 0.2, ..Shift::default() })?;
//! let back = law.advance(Shift { zeta: 1.0, xi: 0.0, ..Shift::default() })?;
//! assert!(back.f_x < 0.0); // hysteresis: after the way back a force remains
//! # Ok::<(), RangeError>(())
//! ```
//!
//! **Numerical contact.** The solver takes any gap and any load history on a grid. Each motion is prescribed by its
//! displacement or by its load.
//!
//! ```
//! use carom::halfspace::{Grid, Material, MaterialPair};
//! use carom::laws::friction::Friction;
//! use carom::solver::{CellState, ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method};
//!
//! let grid = Grid::new(40, 40, 0.055, 0.055)?;
//! let ball = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
//! let (rubber, steel) = (Material::from_shear(1.0, 0.5)?, Material::RIGID);
//! let problem = ContactProblem::of_half_spaces(ball, MaterialPair::new(rubber, steel)?, Friction::new(0.4)?)?;
//! let (method, apart) = (Frictional::default(), ContactState::apart(grid));
//! let (mut scratch, mut state) = (method.scratch(&problem)?, apart.clone());
//! let pulled = Drive { normal: Driven::Load(4.0), x: Driven::Load(0.8), ..Drive::default() };
//! let report = method.step(&problem, &apart, &pulled, &mut state, &mut scratch, &mut ())?;
//! assert!((state.load().f_x - 0.8).abs() < 1e-7 && state.count(CellState::Slip) > 0);
//! assert!(report.residuals.tangential < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Half-space.** The elastic half-space gives displacements and stresses under loads on its surface, here under a point
//! force.
//!
//! ```
//! use carom::halfspace::{Force, Material, Point, PointLoad};
//!
//! let load = PointLoad::new(Material::from_shear(1.0, 0.5)?, Force { z: 1.0, ..Force::default() })?;
//! let surface = load.displacement(Point::on_surface(0.5, 0.0))?;
//! assert!((surface.w - 0.5 / std::f64::consts::PI).abs() < 1e-15);
//! # Ok::<(), carom::prelude::RangeError>(())
//! ```
//!
//! **Special functions.** Elliptic integrals take the axis ratio of the contact instead of the modulus. Slender contacts
//! then lose no digits.
//!
//! ```
//! use carom::special::{AxisRatio, elliptic::complete};
//!
//! let slender = AxisRatio::new(1e-200)?;
//! assert!((complete::k(slender) - (4e200_f64).ln()).abs() < 1e-12);
//! # Ok::<(), carom::prelude::RangeError>(())
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
