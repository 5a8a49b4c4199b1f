//! The discretisation error of a solution, and the grid that a required accuracy needs.

mod border;
mod contour;
mod estimate;
mod fit;
mod fit_cells;
mod grid_warning;
mod history;
mod reach;
mod span;
mod window;

pub use contour::{Contour, contours};
pub use estimate::{Estimated, Estimates, MeshOrder};
pub use fit::{Accuracy, Fit, FitError};
pub use grid_warning::{GridWarning, Side};
pub use history::{NestedError, NestedHistory, Trial};
pub use window::Window;
