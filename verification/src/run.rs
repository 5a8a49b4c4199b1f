//! Computing figures side by side; one that fails or panics does not stop the others.

use crate::catalogue::{Entry, FigureResult};
use crate::claim::Claim;
use crate::figure::Figure;
use crate::snapshot::{self, Comparison, Policy};
use rayon::prelude::*;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

/// What became of an entry of the catalogue.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The entry.
    pub entry: Entry,
    /// The figure with its picture, or why there is none.
    pub result: Result<Drawn, String>,
    /// How long it took.
    pub time: Duration,
}

/// A computed figure.
#[derive(Debug, Clone)]
pub struct Drawn {
    /// The data.
    pub figure: Figure,
    /// The picture; none for a table without panels.
    pub svg: Option<String>,
    /// How it compares with its snapshot.
    pub snapshot: Comparison,
}

impl Outcome {
    /// Whether it was computed, every claim holds and the snapshot agrees.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.result.as_ref().is_ok_and(|drawn| {
            drawn.figure.claims.iter().all(Claim::passes)
                && matches!(drawn.snapshot, Comparison::Same | Comparison::Written)
        })
    }

    /// How many claims hold, of how many.
    #[must_use]
    pub fn score(&self) -> Score {
        let claims = self.result.as_ref().map_or(&[][..], |drawn| &drawn.figure.claims);
        let passed = claims.iter().filter(|claim| claim.passes()).count();
        Score { passed, total: claims.len() }
    }

    /// The worst deviation of its claims, over tolerance; none if it failed.
    #[must_use]
    pub fn worst_ratio(&self) -> Option<f64> {
        let drawn = self.result.as_ref().ok()?;
        drawn.figure.claims.iter().map(Claim::ratio).reduce(f64::max)
    }
}

/// Claims that hold, of how many.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Score {
    /// Claims that hold.
    pub passed: usize,
    /// All claims.
    pub total: usize,
}

/// Computes the entries in parallel and returns their outcomes in the order given; calls
/// `done` after each, from any thread. Entries that nobody computes are left out.
pub fn run(
    entries: &[Entry],
    snapshots: &Path,
    policy: Policy,
    done: impl Fn(&Outcome) + Sync,
) -> Vec<Outcome> {
    let mut order: Vec<usize> = (0..entries.len()).filter(|i| entries[*i].is_done()).collect();
    order.sort_by_key(|i| (!entries[*i].is_slow(), *i)); // the slow ones first
    let mut outcomes: Vec<(usize, Outcome)> = order
        .into_par_iter()
        .with_max_len(1)
        .map(|i| {
            let outcome = compute(entries[i], snapshots, policy);
            done(&outcome);
            (i, outcome)
        })
        .collect();
    outcomes.sort_by_key(|(i, _)| *i);
    outcomes.into_iter().map(|(_, outcome)| outcome).collect()
}

fn compute(entry: Entry, snapshots: &Path, policy: Policy) -> Outcome {
    let start = Instant::now();
    let result = catch_unwind(AssertUnwindSafe(|| entry.draw()))
        .unwrap_or_else(|panic| Some(Err(panic_message(panic.as_ref()).into())))
        .unwrap_or_else(|| Err("nobody computes it".into()));
    let result = finish(result, snapshots, policy).map_err(|error| error.to_string());
    Outcome { entry, result, time: start.elapsed() }
}

/// Checks a figure's form, draws it and holds it against its snapshot.
fn finish(
    result: FigureResult,
    snapshots: &Path,
    policy: Policy,
) -> Result<Drawn, Box<dyn std::error::Error + Send + Sync>> {
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
    let svg = match figure.panels.as_slice() {
        [] => None,
        panels => Some(carom_plot::render(&heading(&figure), panels)?),
    };
    let snapshot = snapshot::compare(snapshots, &figure, policy)?;
    Ok(Drawn { figure, svg, snapshot })
}

fn heading(figure: &Figure) -> String {
    format!("{}  {}", figure.id, figure.title)
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

    fn refuted() -> FigureResult {
        let mut figure = good()?;
        figure.claim(Claim::at_most("small", 3.0, 2.0));
        Ok(figure)
    }

    fn claimless() -> FigureResult {
        let mut figure = good()?;
        figure.claims.clear();
        Ok(figure)
    }

    fn failing() -> FigureResult {
        Err("no convergence".into())
    }

    fn panicking() -> FigureResult {
        Ok(std::iter::empty::<Figure>().next().expect("a figure"))
    }

    #[test]
    fn a_failed_figure_does_not_stop_the_others() {
        let entries = [
            Entry::figure("1", "").by(panicking),
            Entry::figure("2", "").by(failing),
            Entry::figure("3", "").by(claimless),
            Entry::figure("4", "").by(refuted),
            Entry::figure("5", ""),
            Entry::figure("6", "").slowly_by(good),
        ];
        let folder = std::env::temp_dir().join(format!("carom-run-{}", std::process::id()));
        let count = std::sync::atomic::AtomicUsize::new(0);
        let outcomes = run(&entries, &folder, Policy::Update, |_| {
            count.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        });
        std::fs::remove_dir_all(folder).unwrap();
        assert_eq!(count.into_inner(), 5);
        let ids: Vec<_> = outcomes.iter().map(|outcome| outcome.entry.id).collect();
        assert_eq!(ids, ["1", "2", "3", "4", "6"]);
        let passes: Vec<_> = outcomes.iter().map(Outcome::passes).collect();
        assert_eq!(passes, [false, false, false, false, true]);
        assert_eq!(outcomes[0].result.as_ref().unwrap_err(), "panicked: a figure");
        assert_eq!(outcomes[1].result.as_ref().unwrap_err(), "no convergence");
        assert_eq!(outcomes[2].result.as_ref().unwrap_err(), "the figure claims nothing");
        assert_eq!(outcomes[3].score(), Score { passed: 1, total: 2 });
        assert_eq!(outcomes[3].worst_ratio(), Some(1.5));
    }
}
