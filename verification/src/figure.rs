//! A figure as data: inputs, panels of series, tables, claims and deviations from the thesis.
//!
//! An input is stated by the thesis, derived from what it states, or assumed where it states nothing. A figure is
//! checked by its claims, not by its picture.
//!
//! `carom_plot` defines the appearance; the catalogue ([`crate::catalogue::Entry`]) gives number
//! and title.

use crate::claim::{Claim, Pair, Tolerance};
pub use carom_plot::{Aspect, Axis, Limits, Panel, Scale};

/// A computed table or figure of the thesis: data and the claims that check them.
///
/// ```
/// use carom_verification::{Claim, Figure, Panel, Series, Tolerance};
///
/// let mut figure = Figure::new();
/// figure.assumed("x", "0 to 1");
/// let mut panel = Panel::new("x", "x²");
/// panel.add(Series::line("parabola", [0.0, 0.5, 1.0].map(|x| (x, x * x))));
/// figure.panel(panel);
/// figure.close("the end is 1", 1.0, 1.0, Tolerance::Absolute(1e-12)).source("closed form");
/// assert!(figure.claims.iter().all(Claim::passes));
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Figure {
    /// Number in the thesis; set by the catalogue.
    pub id: String,
    /// Title; set by the catalogue.
    pub title: String,
    /// The inputs, each with its origin.
    pub inputs: Vec<Input>,
    /// The panels, in reading order.
    pub panels: Vec<Panel>,
    /// The tables.
    pub tables: Vec<Table>,
    /// The claims.
    pub claims: Vec<Claim>,
    /// Deviations from what the thesis prints.
    pub deviations: Vec<Deviation>,
    /// Precision of the snapshot.
    pub precision: Precision,
}

impl Figure {
    /// An empty figure.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds an input that the thesis states.
    pub fn stated(&mut self, name: impl Into<String>, value: impl Into<String>) {
        self.input(name, value, Origin::Stated);
    }

    /// Adds an input that follows from what the thesis states.
    pub fn derived(&mut self, name: impl Into<String>, value: impl Into<String>) {
        self.input(name, value, Origin::Derived);
    }

    /// Adds an input that the thesis does not give and that was chosen here.
    pub fn assumed(&mut self, name: impl Into<String>, value: impl Into<String>) {
        self.input(name, value, Origin::Assumed);
    }

    fn input(&mut self, name: impl Into<String>, value: impl Into<String>, origin: Origin) {
        self.inputs.push(Input { name: name.into(), value: value.into(), origin });
    }

    /// Adds a panel.
    pub fn panel(&mut self, panel: Panel) {
        self.panels.push(panel);
    }

    /// Adds a table.
    pub fn table(&mut self, table: Table) {
        self.tables.push(table);
    }

    /// Adds a claim.
    pub fn claim(&mut self, claim: Claim) {
        self.claims.push(claim);
    }

    /// Claims that `measured` is `expected` within `tolerance`.
    #[track_caller]
    pub fn close(
        &mut self,
        statement: impl Into<String>,
        measured: f64,
        expected: f64,
        tolerance: Tolerance,
    ) -> NewClaim<'_> {
        self.new_claim(Claim::close(statement, measured, expected, tolerance))
    }

    /// Claims that every (measured, expected) pair agrees within `tolerance`.
    #[track_caller]
    pub fn all_close<P: Into<Pair>>(
        &mut self,
        statement: impl Into<String>,
        pairs: impl IntoIterator<Item = P>,
        tolerance: Tolerance,
    ) -> NewClaim<'_> {
        self.new_claim(Claim::all_close(statement, pairs, tolerance))
    }

    /// Claims that `measured` is at most `bound`.
    #[track_caller]
    pub fn at_most(
        &mut self,
        statement: impl Into<String>,
        measured: f64,
        bound: f64,
    ) -> NewClaim<'_> {
        self.new_claim(Claim::at_most(statement, measured, bound))
    }

    /// Claims that `measured` is at least `bound`.
    #[track_caller]
    pub fn at_least(
        &mut self,
        statement: impl Into<String>,
        measured: f64,
        bound: f64,
    ) -> NewClaim<'_> {
        self.new_claim(Claim::at_least(statement, measured, bound))
    }

    /// Claims that each value is larger than the one before.
    #[track_caller]
    pub fn increasing(
        &mut self,
        statement: impl Into<String>,
        values: impl IntoIterator<Item = f64>,
    ) -> NewClaim<'_> {
        self.new_claim(Claim::increasing(statement, values))
    }

    /// Claims that each value is smaller than the one before.
    #[track_caller]
    pub fn decreasing(
        &mut self,
        statement: impl Into<String>,
        values: impl IntoIterator<Item = f64>,
    ) -> NewClaim<'_> {
        self.new_claim(Claim::decreasing(statement, values))
    }

    /// Claims that a condition holds; `measured` is the number that shows it.
    #[track_caller]
    pub fn holds(
        &mut self,
        statement: impl Into<String>,
        holds: bool,
        measured: f64,
    ) -> NewClaim<'_> {
        self.new_claim(Claim::holds(statement, holds, measured))
    }

    fn new_claim(&mut self, claim: Claim) -> NewClaim<'_> {
        NewClaim { claims: &mut self.claims, claim }
    }

    /// Records that the thesis prints a different value, and the cause.
    pub fn deviation(
        &mut self,
        printed: impl Into<String>,
        corrected: impl Into<String>,
        cause: impl Into<String>,
    ) {
        self.deviations.push(Deviation {
            printed: printed.into(),
            corrected: corrected.into(),
            cause: cause.into(),
        });
    }

    /// Sets the number of significant digits of the snapshot (default 6). Results of iterations
    /// need fewer digits than their accuracy.
    pub fn snapshot_digits(&mut self, digits: u8) {
        self.precision = Precision { digits };
    }
}

/// A claim that still needs the source of its expected value.
#[must_use = "a claim counts only with its source"]
#[derive(Debug)]
pub struct NewClaim<'f> {
    claims: &'f mut Vec<Claim>,
    claim: Claim,
}

impl NewClaim<'_> {
    /// Adds the claim with this source of its expected value.
    pub fn source(self, source: impl Into<String>) {
        self.claims.push(self.claim.source(source));
    }
}

/// A named input of a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Symbol or name as in the thesis.
    pub name: String,
    /// The value with its unit, or the range.
    pub value: String,
    /// Its origin.
    pub origin: Origin,
}

/// Origin of an input.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// Given in the text or caption.
    Stated,
    /// Follows from what is stated.
    Derived,
    /// Chosen here: the thesis does not give it.
    Assumed,
}

impl Origin {
    /// The origin as a word.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Stated => "stated",
            Self::Derived => "derived",
            Self::Assumed => "assumed",
        }
    }
}

/// A table of numbers and words.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Title above the table.
    pub title: String,
    /// Heads of the columns.
    pub columns: Vec<String>,
    /// The rows, each as long as `columns`.
    pub rows: Vec<Vec<Cell>>,
    /// Significant digits of its numbers in the report.
    pub digits: usize,
}

impl Table {
    /// An empty table with these columns.
    #[must_use]
    pub fn new<S: Into<String>>(
        title: impl Into<String>,
        columns: impl IntoIterator<Item = S>,
    ) -> Self {
        Self {
            title: title.into(),
            columns: columns.into_iter().map(Into::into).collect(),
            rows: Vec::new(),
            digits: 6,
        }
    }

    /// Sets the number of significant digits in the report (default 6), which should not be finer
    /// than the errors beside them. Snapshot and CSV keep theirs.
    #[must_use]
    pub const fn shown_to(mut self, digits: usize) -> Self {
        self.digits = digits;
        self
    }

    /// Adds a row of cells or numbers.
    pub fn row<C: Into<Cell>>(&mut self, cells: impl IntoIterator<Item = C>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }
}

/// A cell of a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A number; goes into the snapshot.
    Number(f64),
    /// Words, compared in the snapshot.
    Text(String),
    /// Words that are not in the snapshot, such as round-off errors or times, which differ between
    /// machines.
    Remark(String),
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

/// A deviation: what the thesis prints, the correct value and the cause.
#[derive(Debug, Clone, PartialEq)]
pub struct Deviation {
    /// What the thesis prints or says.
    pub printed: String,
    /// The correct value.
    pub corrected: String,
    /// The cause of the difference.
    pub cause: String,
}

/// Number of digits in the snapshot of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Precision {
    /// Significant digits, relative to the largest value of each series or column.
    pub digits: u8,
}

impl Default for Precision {
    fn default() -> Self {
        Self { digits: 6 }
    }
}
