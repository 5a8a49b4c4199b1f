#![forbid(unsafe_code)]
//! All tables and figures of the thesis, computed by carom, with claims that can fail.
//!
//! # How to add a figure
//!
//! 1. Write a function `fn figure_5_3() -> FigureResult` in `src/figures/ch05/mod.rs` (or a
//!    file of its own beside it). It fills a [`Figure`]: its inputs, each
//!    [`stated`](Figure::stated), [`derived`](Figure::derived) or [`assumed`](Figure::assumed);
//!    one or more [`Panel`]s of [`Series`]; [`Table`]s; [`Claim`]s; and the
//!    [`deviation`](Figure::deviation)s from what the thesis prints. Any error leaves with `?`.
//! 2. Add it to its line in the same file: `Entry::figure("5.3", "…").by(figure_5_3)`, or
//!    `slowly_by` if it takes more than about a second, so that quick runs skip it. If it lacks
//!    something that the thesis shows, add `.partial("what is missing")`: partial entries are
//!    counted separately.
//! 3. `cargo xtask verify --figure 5.3 --update` computes it, checks the claims, writes SVG,
//!    CSV and report under `target/verification/` and its snapshot under
//!    `verification/snapshots/`. Look at the picture and at the snapshot, then commit both.
//!
//! A claim must be able to fail, and must rest on something other than the code that it checks: a
//! closed form, quadrature, reference values, the text of the thesis. It names this
//! [`source`](NewClaim::source); without one it fails. The snapshot guards against change, the
//! claims against error. `--update` lists what it changes and never updates the snapshot of a page
//! with a failing claim. `cargo xtask verify --update` updates all snapshots that differ.
//!
//! # A run
//!
//! Each page is computed in a [process of its own](launch) with a time limit and leaves a
//! [record](page) in `target/verification/pages/`. Report, terminal output, JSON and JUnit XML are
//! made from the records, so that the report of a partial run contains the other pages with their
//! date.
//! A test harness would give processes and time limits, but no records, and a user would have to
//! install it.
//!
//! ```
//! use carom_verification::{Absolute, Figure, FigureResult, Panel, Series};
//! use carom_verification::linspace;
//!
//! fn figure_0_1() -> FigureResult {
//!     let mut figure = Figure::new();
//!     figure.stated("x", "0 to 2");
//!     let curve: Vec<(f64, f64)> =
//!         linspace(0.0, 2.0, 101).into_iter().map(|x| (x, x * x)).collect();
//!     figure.close("y(2) is 4", curve[100].1, 4.0, Absolute(1e-12)).source("closed form");
//!     let mut panel = Panel::new("x", "y");
//!     panel.add(Series::line("y = x²", curve));
//!     figure.panel(panel);
//!     Ok(figure)
//! }
//! # figure_0_1().unwrap();
//! ```
//!
//! # Pages beside the thesis
//!
//! An [`Entry::check`] has a name instead of a number and is otherwise a figure like the others:
//! `rebound.regimes` and `rebound.angles` show the oblique impact as a whole, `particles.*` run
//! published tests of particle codes, `propositions` and `proposition-3`, `-4`, `-5`, `-6` and `-8` check propositions of it,
//! `accuracy.*` list the errors of a layer against high-precision references. Inputs marked as
//! stated are those of the page's source. Published points are shown as read from their figures.
//! Claims about them allow for reading errors; there is no claim if they answer another question.

pub mod book;
pub mod catalogue;
pub mod ci;
pub mod claim;
pub mod data;
pub mod figure;
mod figures;
pub mod files;
pub mod launch;
pub mod page;
mod play;
mod reference;
pub mod report;
pub mod run;
pub mod section;
pub mod selection;
pub mod snapshot;
pub mod statistics;
pub mod tally;
pub mod terminal;

pub use carom_plot::{Arrow, Marker, Point, Series};
pub use carom_special::{linspace, logspace};
pub use catalogue::{Entry, Failure, FigureResult, State, catalogue};
pub use claim::Tolerance::{Absolute, Relative};
pub use claim::{Check, Claim, Pair, Tolerance};
pub use figure::{Axis, Cell, Figure, NewClaim, Panel, Table};
