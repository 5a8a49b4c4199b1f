//! Floor 4 of carom: the numerical contact problem (chapters 11 to 14).
//!
//! A [`ContactProblem`] is a [`Gap`], an operator (that of the half-space or the user's own) and
//! [`SurfaceFriction`], all on one grid. A [`Method`] takes a [`ContactState`] through the steps of
//! a history, each given by a [`Drive`], and says with a [`Convergence`] how it went.
#![forbid(unsafe_code)]

mod anderson;
mod chart;
mod contour;
mod convergence;
mod coupled;
mod direct;
mod doubt;
mod drive;
mod estimate;
mod fit;
mod friction;
mod frictional;
mod frictionless;
mod gap;
pub mod jaeger;
pub mod kalker;
pub mod known;
mod law;
mod limits;
mod method;
mod nested;
mod nested_history;
mod normal;
mod problem;
mod result;
pub mod rolling;
mod span;
mod state;
mod substeps;
mod tangential;
pub mod theory;
mod window;

pub use chart::{Block, Entry, Step, Trace};
pub use contour::{Contour, contours};
pub use convergence::{Convergence, Observer, Products, Progress, Residuals, Stop};
pub use direct::DirectError;
pub use doubt::{Doubt, Side};
pub use drive::{Drive, Driven};
pub use estimate::{Estimated, Estimates};
pub use fit::{Accuracy, Fit, FitError};
pub use friction::{CellFriction, SurfaceFriction};
pub use frictional::{Frictional, FrictionalError, FrictionalScratch};
pub use frictionless::{Frictionless, NormalError, NormalScratch};
pub use gap::{Gap, HeightMap, HeightMapError, Outline, SelfAffine, Shape};
pub use law::{NumericalLaw, NumericalLawError};
pub use method::Method;
pub use nested_history::{NestedError, NestedHistory};
pub use problem::{ContactProblem, PeriodError, ProblemError};
pub use result::{StepSummary, StoredEnergy, Subsurface, dissipated, violations};
pub use state::{CellState, ContactState};
pub use substeps::{SubstepError, Substepped};
pub use window::Window;
