//! How accurate a solution on a grid is, and which grid a wanted accuracy needs.

mod contour;
mod doubt;
mod estimate;
mod fit;
mod history;
mod span;
mod window;

pub use contour::{Contour, contours};
pub use doubt::{Doubt, Side};
pub use estimate::{Estimated, Estimates};
pub use fit::{Accuracy, Fit, FitError};
pub use history::{NestedError, NestedHistory};
pub use window::Window;
