//! The lines of a snapshot: heads in words, and rows of words and rounded numbers.

use crate::claim::{Check, Claim, Order, Side, Tolerance, number};
use crate::figure::{Cell, Figure, Table};
use carom_plot::Series;

/// Largest number of points of a series in a snapshot; the others count in its means.
const MAX_POINTS_OF_SERIES: usize = 20;

/// Allowed difference in rounding steps: half a step, and a tenth for differences between machines.
const ALLOWED_ROUNDING_STEPS: f64 = 0.6;

/// Digits of a tolerance.
const TOLERANCE_DIGITS: u8 = 3;

/// A line of a snapshot: a head, or the cells of a row.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Line {
    Head(String),
    Row(Vec<SnapshotCell>),
}

/// A cell of a row.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum SnapshotCell {
    Number(Rounded),
    Word(String),
}

/// A number, its rounding step, and the largest value of its curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rounded {
    value: f64,
    step: Step,
    /// The largest value of its curve; `None` for a single number.
    largest: Option<f64>,
    form: Form,
}

/// Format of a rounded number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    /// With all digits of its step, as in a column.
    Column,
    /// Without trailing zeros.
    Short,
}

impl Rounded {
    fn alone(value: f64, digits: u8) -> Self {
        let step = Step::of(std::iter::once(value), digits);
        Self { value, step, largest: None, form: Form::Column }
    }

    fn short(value: f64, digits: u8) -> Self {
        Self { form: Form::Short, ..Self::alone(value, digits) }
    }

    fn written(self) -> String {
        let text = self.step.rounded(self.value);
        match (self.form, text.parse()) {
            (Form::Short, Ok(value)) => number(value),
            _ => text,
        }
    }

    fn agrees(self, stored: f64) -> bool {
        (stored - self.value).abs() <= ALLOWED_ROUNDING_STEPS * self.step.size()
    }

    /// The change from a stored value: over the largest of its curve, or over the stored value.
    pub(super) fn relative(self, stored: f64) -> f64 {
        (self.value - stored).abs() / self.largest.unwrap_or(stored.abs())
    }
}

/// A power of ten to which numbers are rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Step(i32);

impl Step {
    /// The step that keeps `digits` digits of the largest of `values`.
    fn of(values: impl Iterator<Item = f64>, digits: u8) -> Self {
        let largest = values.map(f64::abs).fold(0.0, f64::max);
        Self::leading(largest)
            .map_or(Self(-i32::from(digits)), |Self(power)| Self(power + 1 - i32::from(digits)))
    }

    /// The power of ten of the first digit after rounding to three digits: it is then the same on
    /// both sides of a power of ten, where many curves end.
    fn leading(value: f64) -> Option<Self> {
        if value == 0.0 || !value.is_finite() {
            return None;
        }
        format!("{value:.2e}").split_once('e')?.1.parse().ok().map(Self)
    }

    fn size(self) -> f64 {
        format!("1e{}", self.0).parse().unwrap_or(f64::MIN_POSITIVE)
    }

    fn rounded(self, value: f64) -> String {
        if (-12..=0).contains(&self.0) {
            let text = format!("{value:.*}", self.0.unsigned_abs() as usize);
            let is_zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
            return if is_zero { text.replace('-', "") } else { text };
        }
        let count = (value / self.size()).round();
        if count == 0.0 { "0".to_owned() } else { format!("{count:.0}e{}", self.0) }
    }
}

impl SnapshotCell {
    fn word(word: impl Into<String>) -> Self {
        Self::Word(word.into().replace(['\t', '\n', '\r'], " "))
    }

    /// The number as written in the snapshot.
    pub(super) fn written(&self) -> String {
        match self {
            Self::Number(number) => number.written(),
            Self::Word(word) => word.clone(),
        }
    }

    pub(super) fn agrees(&self, stored: &str) -> bool {
        match self {
            Self::Word(word) => stored == word,
            Self::Number(now) => stored.parse().is_ok_and(|stored| now.agrees(stored)),
        }
    }
}

impl Line {
    /// The cell as written in the snapshot.
    pub(super) fn written(&self) -> String {
        match self {
            Self::Head(words) => words.clone(),
            Self::Row(cells) => {
                cells.iter().map(SnapshotCell::written).collect::<Vec<_>>().join("\t")
            }
        }
    }
}

impl PartialEq<&str> for Line {
    fn eq(&self, stored: &&str) -> bool {
        match self {
            Self::Head(words) => stored == words,
            Self::Row(cells) => {
                stored.split('\t').count() == cells.len()
                    && stored.split('\t').zip(cells).all(|(stored, cell)| cell.agrees(stored))
            }
        }
    }
}

/// The text of these lines.
pub(super) fn text(lines: &[Line]) -> String {
    lines.iter().map(|line| line.written() + "\n").collect()
}

/// The lines of a figure.
pub(super) fn of(figure: &Figure) -> Vec<Line> {
    let digits = figure.precision.digits;
    let mut lines = vec![Line::Head(format!("{} ({digits} digits)", figure.id))];
    for input in &figure.inputs {
        let origin = format!("{}:", input.origin.word());
        lines.push(Line::Row([&*origin, &input.name, &input.value].map(SnapshotCell::word).into()));
    }
    lines.extend(figure.claims.iter().map(|claim| claim_row(claim, digits)));
    for panel in &figure.panels {
        let words = format!("panel: {} | {} | {}", panel.title, panel.x.label, panel.y.label);
        lines.push(Line::Head(words));
        for series in &panel.series {
            push_series(&mut lines, series, digits);
        }
    }
    for table in &figure.tables {
        push_table(&mut lines, table, digits);
    }
    lines
}

/// Statement, expectation and source of a claim. The measurement is omitted: it is among the
/// numbers below, or close to the expectation.
fn claim_row(claim: &Claim, digits: u8) -> Line {
    let mut cells = vec![SnapshotCell::word("claim:"), SnapshotCell::word(&*claim.statement)];
    match &claim.check {
        Check::Close { expected, tolerance, .. } => {
            cells.extend([SnapshotCell::Number(expectation(*expected, *tolerance, digits))]);
            cells.extend(tolerance_cells(*tolerance));
        }
        Check::AllClose { pairs, tolerance } => {
            cells.push(SnapshotCell::word(format!("{} values", pairs.len())));
            cells.extend(tolerance_cells(*tolerance));
        }
        Check::Bound { bound, side, .. } => {
            cells.push(SnapshotCell::word(if *side == Side::Below {
                "at most"
            } else {
                "at least"
            }));
            cells.push(SnapshotCell::Number(Rounded::short(*bound, digits)));
        }
        Check::Ordered { values, order } => {
            let order = if *order == Order::Increasing { "increasing" } else { "decreasing" };
            cells.push(SnapshotCell::word(format!("{} values {order}", values.len())));
        }
        Check::Holds { .. } => cells.push(SnapshotCell::word("holds")),
    }
    cells.push(SnapshotCell::word(&*claim.source));
    Line::Row(cells)
}

/// An expected value, rounded no finer than its tolerance.
fn expectation(expected: f64, tolerance: Tolerance, digits: u8) -> Rounded {
    let rounded = Rounded::short(expected, digits);
    let allowed = match tolerance {
        Tolerance::Absolute(allowed) => allowed,
        Tolerance::Relative(allowed) => allowed * expected.abs(),
    };
    let step = Step::leading(allowed).map_or(rounded.step, |step| step.max(rounded.step));
    Rounded { step, ..rounded }
}

fn tolerance_cells(tolerance: Tolerance) -> [SnapshotCell; 2] {
    let (value, word) = match tolerance {
        Tolerance::Absolute(value) => (value, "absolute"),
        Tolerance::Relative(value) => (value, "relative"),
    };
    [SnapshotCell::Number(Rounded::short(value, TOLERANCE_DIGITS)), SnapshotCell::word(word)]
}

/// Some points of a series, x in one row and y in the next, and means over all of them: of x, of y, and the root of
/// that of y squared.
fn push_series(lines: &mut Vec<Line>, series: &Series, digits: u8) {
    let count = series.points.len();
    lines.push(Line::Head(format!("series: {} | {count} points", series.label)));
    let (xs, ys): (Vec<f64>, Vec<f64>) = series.points.iter().map(|p| (p.x, p.y)).unzip();
    if count == 0 {
        return;
    }
    let [of_x, of_y] = [&xs, &ys].map(|values| Curve::of(values, digits));
    lines.push(of_x.row("x", thinned(&xs)));
    lines.push(of_y.row("y", thinned(&ys)));
    let (x, y, squares) = (mean(&xs, |x| x), mean(&ys, |y| y), mean(&ys, |y| y * y).sqrt());
    let means = [of_x.cell(x), of_y.cell(y), of_y.cell(squares)];
    lines.push(Line::Row([&[SnapshotCell::word("means")], &means[..]].concat()));
}

/// Evenly spaced values, the first and the last among them.
fn thinned(values: &[f64]) -> impl Iterator<Item = f64> + '_ {
    let (count, kept) = (values.len(), values.len().min(MAX_POINTS_OF_SERIES));
    (0..kept).map(move |i| values[if kept > 1 { i * (count - 1) / (kept - 1) } else { 0 }])
}

/// The mean of a function of the values that are finite.
fn mean(values: &[f64], of: impl Fn(f64) -> f64) -> f64 {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    finite().map(of).sum::<f64>() / finite().count().max(1) as f64
}

/// How the values of one coordinate of a curve are rounded.
#[derive(Debug, Clone, Copy)]
struct Curve {
    step: Step,
    largest: f64,
}

impl Curve {
    fn of(values: &[f64], digits: u8) -> Self {
        let largest = values.iter().copied().map(f64::abs).fold(0.0, f64::max);
        Self { step: Step::of(values.iter().copied(), digits), largest }
    }

    fn cell(self, value: f64) -> SnapshotCell {
        let Self { step, largest } = self;
        SnapshotCell::Number(Rounded { value, step, largest: Some(largest), form: Form::Column })
    }

    fn row(self, name: &str, values: impl Iterator<Item = f64>) -> Line {
        let cells = values.map(|value| self.cell(value));
        Line::Row(std::iter::once(SnapshotCell::word(name)).chain(cells).collect())
    }
}

fn push_table(lines: &mut Vec<Line>, table: &Table, digits: u8) {
    lines.push(Line::Head(format!("table: {} | {}", table.title, table.columns.join(" | "))));
    for row in &table.rows {
        let cells = row.iter().map(|cell| match cell {
            Cell::Number(value) => SnapshotCell::Number(Rounded::alone(*value, digits)),
            Cell::Text(text) => SnapshotCell::word(&**text),
            Cell::Remark(_) => SnapshotCell::word("-"),
        });
        lines.push(Line::Row(cells.collect()));
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use carom_plot::Panel;

    /// A figure with a curve of this scale, a table, an input and some claims.
    pub(in crate::snapshot) fn figure(scale: f64) -> Figure {
        let mut figure = Figure { id: "0.1".to_owned(), ..Figure::new() };
        figure.assumed("ν", "0.3");
        let third = Claim::close("a third", 1.0 / 3.0, 1.0 / 3.0, Tolerance::Absolute(1e-4));
        figure.claim(third.source("(5.3)"));
        figure.at_most("small", 0.0, 1.0).source("Coulomb");
        let mut panel = Panel::new("x", "y");
        let points = (0..100).map(|i| (f64::from(i), scale * f64::from(i * i) / 7.0));
        panel.add(Series::line("curve", points));
        figure.panel(panel);
        let mut table = Table::new("numbers", ["name", "value"]);
        table.row([Cell::from("a"), Cell::from(-1e-9 / 3.0)]);
        figure.table(table);
        figure
    }

    #[test]
    fn text_is_rounded_and_thinned() {
        let text = text(&of(&figure(1.0)));
        insta::assert_snapshot!(text.lines().take(6).collect::<Vec<_>>().join("\n"), @r"
        0.1 (6 digits)
        assumed:	ν	0.3
        claim:	a third	0.3333	0.0001	absolute	(5.3)
        claim:	small	at most	1	Coulomb
        panel:  | x | y
        series: curve | 100 points
        ");
        let rest: Vec<_> = text.lines().skip(6).collect();
        assert_eq!(rest.len(), 5);
        assert!(rest[0].starts_with("x\t0.0000\t5.0000\t10.0000\t"), "{}", rest[0]);
        assert!(rest[1].starts_with("y\t0.00\t3.57\t") && rest[1].ends_with("\t1400.14"));
        assert!(rest[..2].iter().all(|row| row.split('\t').count() == 1 + MAX_POINTS_OF_SERIES));
        // 99/2; (99 199)/(6 7); the root of the mean of i^4/49, by Faulhaber's sum.
        assert_eq!(rest[2], "means\t49.5000\t469.07\t630.89");
        assert_eq!(rest[3..], ["table: numbers | name | value", "a\t-333333e-15"]);
    }

    #[test]
    fn a_value_on_the_edge_of_rounding_is_stable() {
        // 0.5 rounds to 0 or 1 by a last bit; both texts accept both values.
        for text in ["0", "1"] {
            for value in [0.5 - 1e-15, 0.5 + 1e-15] {
                let step = Step(0);
                let now = Rounded { step, ..Rounded::alone(value, 6) };
                assert!(now.agrees(text.parse().unwrap()));
            }
        }
    }

    #[test]
    fn a_curve_that_ends_at_a_power_of_ten_keeps_its_digits() {
        for size in [1e-7, 1e-4, 1.0, 10.0, 1e5] {
            let steps = [1.0 - 1e-7, 1.0 - 1e-15, 1.0, 1.0 + 1e-7]
                .map(|part| Step::of([0.5 * size, -part * size].into_iter(), 6));
            assert_eq!(steps, [steps[2]; 4], "{size}");
            assert!((steps[2].size() / (1e-5 * size) - 1.0).abs() < 1e-12, "{size}");
        }
    }

    #[test]
    fn an_expectation_is_no_finer_than_its_tolerance() {
        let step = |tolerance| expectation(2.0 / 3.0, tolerance, 6).step;
        assert_eq!(step(Tolerance::Absolute(2e-3)), Step(-3));
        assert_eq!(step(Tolerance::Relative(0.9)), Step(-1));
        assert_eq!(step(Tolerance::Absolute(1e-15)), Step(-6));
        assert_eq!(step(Tolerance::Absolute(0.0)), Step(-6));
    }
}
