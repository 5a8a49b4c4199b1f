//! Layer 4 of carom: the numerical contact problem (chapters 11 to 14).
//!
//! A [`ContactProblem`] consists of a [`Gap`], an operator (that of the half-space or the user's
//! own) and [`SurfaceFriction`], all on one grid. A [`Method`] advances a [`ContactState`] through
//! the steps of a load history. Each step is given by a [`Drive`] and reported by a
//! [`Convergence`].
//!
//! | item | what |
//! |---|---|
//! | [`Frictional`], [`Frictionless`] | the methods: with friction and without |
//! | [`NestedHistory`], [`Accuracy`] | discretisation errors, and the grid for a required accuracy |
//! | [`NumericalLaw`] | the contact on a grid as a contact law, for impacts |
//! | [`violations`] | how well a state satisfies the contact conditions |
//!
//! ```
//! use carom_halfspace::{Grid, Material, MaterialPair};
//! use carom_laws::friction::Friction;
//! use carom_solver::{ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method};
//! let grid = Grid::new(24, 24, 0.07, 0.07)?;
//! let ball = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
//! let pair = MaterialPair::new(Material::from_shear(1.0, 0.5)?, Material::RIGID)?;
//! let problem = ContactProblem::of_half_spaces(ball, pair, Friction::new(0.4)?)?;
//! let (method, apart) = (Frictional::default(), ContactState::apart(grid));
//! let (mut scratch, mut state) = (method.scratch(&problem)?, apart.clone());
//! // Pressed by an approach of 0.5 and pulled along x by a force.
//! let drive = Drive { normal: Driven::Shift(0.5), x: Driven::Load(0.3), ..Drive::default() };
//! method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
//! assert!((state.load().f_x - 0.3).abs() < 1e-7 && state.load().f_z > 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod accuracy;
mod awake;
mod convergence;
mod drive;
mod friction;
mod frictional;
mod frictionless;
mod gap;
mod krylov;
mod lanes;
mod law;
mod method;
mod nested;
mod normal;
mod parts;
mod problem;
mod result;
mod rough;
mod rows;
mod state;
mod tangential;

pub use accuracy::{
    Accuracy, Contour, Estimated, Estimates, Fit, FitError, GridWarning, MeshOrder, NestedError,
    NestedHistory, Side, Trial, Window, contours,
};
pub use convergence::{Convergence, Observer, Products, Progress, Residuals, Stop};
pub use drive::{Drive, Driven};
pub use friction::{CellFriction, SurfaceFriction};
pub use frictional::{Frictional, FrictionalError, FrictionalScratch};
pub use frictionless::{Frictionless, NormalError, NormalScratch};
pub use gap::{Gap, HeightMap, HeightMapError, Outline, SelfAffine, Shape};
pub use law::{NumericalLaw, NumericalLawError};
pub use method::Method;
pub use problem::{ContactProblem, PeriodError, ProblemError};
pub use result::{StepSummary, StoredEnergy, Subsurface, dissipated, gap_left, violations};
pub use state::{CellState, ContactState};
