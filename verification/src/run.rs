//! Computes one page. A figure that fails or panics gives an outcome with the error.

use crate::catalogue::{Entry, Failure, FigureResult};
use crate::claim::Claim;
use crate::figure::Figure;
use crate::snapshot::{self, Comparison};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

/// The outcome of an entry of the catalogue.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The entry.
    pub entry: Entry,
    /// The figure with its picture, or the error.
    pub result: Result<Drawn, String>,
    /// Duration of the computation.
    pub time: Duration,
}

/// A computed figure.
#[derive(Debug, Clone)]
pub struct Drawn {
    /// The data.
    pub figure: Figure,
    /// The picture; `None` for a table without panels.
    pub svg: Option<String>,
    /// Each panel as a picture of its own, for the report.
    pub panels: Vec<String>,
    /// Comparison with its snapshot.
    pub snapshot: Comparison,
}

impl Outcome {
    /// Its claims; none if it failed.
    #[must_use]
    pub fn claims(&self) -> &[Claim] {
        self.result.as_ref().map_or(&[], |drawn| &drawn.figure.claims)
    }
}

/// Computes an entry and compares it with its snapshot in the folder `snapshots`.
#[must_use]
pub fn compute(entry: Entry, snapshots: &Path) -> Outcome {
    let start = Instant::now();
    let result = catch_unwind(AssertUnwindSafe(|| entry.draw()))
        .unwrap_or_else(|panic| Some(Err(panic_message(panic.as_ref()).into())))
        .unwrap_or_else(|| Err("nobody computes it".into()));
    let result = finish(result, snapshots).map_err(|error| error.to_string());
    Outcome { entry, result, time: start.elapsed() }
}

/// Checks the form of a figure, draws it and compares it with its snapshot.
fn finish(result: FigureResult, snapshots: &Path) -> Result<Drawn, Failure> {
    let figure = result?;
    if figure.claims.is_empty() {
        return Err("the figure claims nothing".into());
    }
    if figure.panels.is_empty() && figure.tables.is_empty() {
        return Err("the figure has neither panel nor table".into());
    }
    for table in &figure.tables {
        crate::data::table_csv(table)?;
    }
    let (svg, panels) = match figure.panels.as_slice() {
        [] => (None, Vec::new()),
        panels => {
            let whole = carom_plot::render(&figure.title, panels)?;
            (Some(whole), carom_plot::render_each(&figure.id, panels)?)
        }
    };
    let snapshot = snapshot::compare(snapshots, &figure)?;
    Ok(Drawn { figure, svg, panels, snapshot })
}

fn panic_message(panic: &(dyn Any + Send)) -> String {
    let message = panic
        .downcast_ref::<&str>()
        .map(|text| (*text).to_owned())
        .or_else(|| panic.downcast_ref::<String>().cloned());
    format!("panicked: {}", message.as_deref().unwrap_or("no message"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Table;

    fn good() -> FigureResult {
        let mut figure = Figure::new();
        let mut table = Table::new("", ["x"]);
        table.row([1.0]);
        figure.table(table);
        figure.claim(Claim::at_most("small", 1.0, 2.0));
        Ok(figure)
    }

    fn claimless() -> FigureResult {
        let mut figure = good()?;
        figure.claims.clear();
        Ok(figure)
    }

    fn empty() -> FigureResult {
        let mut figure = good()?;
        figure.tables.clear();
        Ok(figure)
    }

    fn failing() -> FigureResult {
        Err("no convergence".into())
    }

    fn panicking() -> FigureResult {
        Ok(std::iter::empty::<Figure>().next().expect("a figure"))
    }

    #[test]
    fn what_does_not_make_a_page_says_why() {
        let folder = Path::new("no such folder");
        let fails = |function: fn() -> FigureResult| {
            compute(Entry::figure("1", "").by(function), folder).result.unwrap_err()
        };
        assert_eq!(fails(panicking), "panicked: a figure");
        assert_eq!(fails(failing), "no convergence");
        assert_eq!(fails(claimless), "the figure claims nothing");
        assert_eq!(fails(empty), "the figure has neither panel nor table");
        let outcome = compute(Entry::figure("5.3", "").by(good), folder);
        assert_eq!(outcome.claims().len(), 1);
        assert_eq!(outcome.result.unwrap().snapshot, Comparison::Missing);
        assert!(compute(Entry::figure("1", ""), folder).result.is_err());
    }
}
