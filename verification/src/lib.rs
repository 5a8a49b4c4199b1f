#![forbid(unsafe_code)]
#![cfg_attr(
    test,
    allow(dead_code, unused_imports, reason = "only the figures, which are left out, use it")
)]
//! All tables and figures of the thesis, computed by carom, with claims that can fail.
//!
//! How to add a page is in `docs/book/src/extend/figure.md`: a function that fills a [`Figure`], its
//! line in the [`catalogue()`], claims with a [`source`](NewClaim::source), a snapshot.
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
//! # Pages beside the thesis
//!
//! An [`Entry::check`] has a name instead of a number and is otherwise a figure like the others:
//! `rebound.regimes` and `rebound.angles` show the oblique impact as a whole, `particles.*` run
//! published tests of particle codes, `propositions` and `proposition-3`, `-4`, `-5`, `-6` and `-8` check propositions of it,
//! `accuracy.*` list the errors of a layer against high-precision references. Inputs marked as
//! stated are those of the page's source. Published points are shown as read from their figures.
//! Claims about them allow for reading errors; there is no claim if they answer another question.

/// The example of the book, run as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../../docs/book/src/extend/figure.md")]
struct BookPage;

pub mod book;
pub mod catalogue;
pub mod ci;
pub mod claim;
pub mod data;
mod error_table;
pub mod figure;
// Unit tests concern the frame; `tests/` holds those of the figures. With the figures they would take as long to
// build as the whole crate.
#[cfg(not(test))]
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
mod spheres;
mod spring_impact;
pub mod statistics;
pub mod tally;
pub mod terminal;

pub use carom_plot::{Arrow, Marker, Point, Series};
pub use carom_special::{linspace, logspace};
#[cfg(not(test))]
pub use catalogue::catalogue;
pub use catalogue::{Entry, Failure, FigureResult, State};
pub use claim::Tolerance::{Absolute, Relative};
pub use claim::{Check, Claim, Pair, Tolerance};
pub use figure::{Axis, Cell, Figure, NewClaim, Panel, Table};
