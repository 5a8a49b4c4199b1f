#![forbid(unsafe_code)]
//! Friction, stiffness, restitution and moduli from measured rebounds and forces.
//!
//! A case of [`carom_cases`] in which numbers are unknown, as `{ fit = [low, high] }` or `{ prior = { mean, sd } }`, and
//! [`Data`] with named columns: fields of the case, which each row replaces, and quantities of its outcome with their
//! standard errors. [`fit()`] finds the unknowns by weighted least squares from several starts. Its [`Fit`] has their intervals
//! by Student's t and by the profile of the sum of squares, their correlations, the leverage of each value, and in sentences
//! what the data leave open: directions whose singular values tell that nothing within the bounds is excluded.
//!
//! Open `run.rs` ([`fit()`]), then `estimate.rs` (the statistics) and `impact.rs` (the model).

mod columns;
mod data;
mod error;
mod estimate;
mod fitted;
mod hertz;
mod history;
mod impact;
mod interval;
mod kind;
mod loss;
mod measured;
mod model;
mod observable;
mod run;
mod settled;
mod squares;
mod starts;
mod told;

pub use columns::GivenError;
pub use data::{Data, DataColumn};
pub use error::FitError;
pub use fitted::{Correlation, Curve, Determined, Fit, Knowledge, Point, Prediction, Quality};
pub use loss::Loss;
pub use measured::Quantity;
pub use observable::Bounce;
pub use run::{Options, fit};
