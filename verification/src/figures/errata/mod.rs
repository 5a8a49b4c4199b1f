//! Equations that the thesis misprints, with the correction and the function that implements it, compared
//! with another way to the same number: not in the thesis.

use crate::catalogue::Entry;
use crate::{Cell, Claim, Figure, FigureResult, Relative, Table};

mod half_space;
mod laws;
mod motion;

/// The page.
pub(super) const ENTRIES: &[Entry] =
    &[Entry::check("errata", "Corrections of the print, each checked in another way").by(draw)];

/// A corrected equation.
#[derive(Clone)]
struct Correction {
    equation: &'static str,
    /// The printed and the correct formula.
    printed: &'static str,
    corrected: &'static str,
    /// The quantity that is compared.
    check: &'static str,
    /// The value of the function, the value by another way, and the value of the printed formula.
    value: f64,
    expected: f64,
    as_printed: Option<f64>,
    tolerance: f64,
    /// The other way.
    source: &'static str,
}

impl Correction {
    /// Chapter and place in it.
    fn place(&self) -> [u32; 2] {
        let part = |part: Option<&str>| part.and_then(|digits| digits.parse().ok()).unwrap_or(0);
        let mut parts = self.equation.split('.');
        [part(parts.next()), part(parts.next())]
    }

    #[track_caller]
    fn claim(&self) -> Claim {
        let statement = format!("({}): {}", self.equation, self.check);
        Claim::close(statement, self.value, self.expected, Relative(self.tolerance))
            .source(self.source)
    }
}

fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("printed", "as the scan of the thesis reads; a slip may be the scan's");
    figure.assumed("cases", "one each, with no symmetry that would hide the fault");
    let mut corrections =
        [half_space::corrections()?, laws::corrections()?, motion::corrections()?].concat();
    corrections.sort_by_key(Correction::place);
    let mut table = Table::new(
        "Equation, print, correction, and a number by the code and by another way",
        ["equation", "printed", "corrected", "number", "code", "other way", "as printed"],
    );
    let mut missed = Vec::new();
    for one in &corrections {
        table.row([
            Cell::from(format!("({})", one.equation)),
            one.printed.into(),
            one.corrected.into(),
            one.check.into(),
            one.value.into(),
            one.expected.into(),
            one.as_printed.map_or_else(|| Cell::from("terms of unequal dimension"), Cell::from),
        ]);
        if let Some(printed) = one.as_printed {
            let size = one.expected.abs().max(1e-300);
            missed.push((printed - one.expected).abs() / (one.tolerance * size));
        }
        figure.claim(one.claim());
    }
    figure
        .at_least(
            "the printed formula would fail everywhere: its least deviation over the tolerance",
            missed.into_iter().fold(f64::INFINITY, f64::min),
            3.0,
        )
        .source("the column as printed");
    figure.table(table);
    Ok(figure)
}
