//! Snapshots: the numbers of a figure, rounded, kept as text beside the code.
//!
//! A stored number stands for the interval that rounds to it. A new value is held against that
//! interval, widened by a tenth, so that a last-bit difference between machines never shows,
//! however close a value lies to the edge between two roundings.

use crate::figure::{Cell, Figure, Table};
use carom_plot::Series;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Points of a series that a snapshot keeps.
const KEPT: usize = 33;

/// Half a rounding step, and a tenth of a step for the machine.
const ALLOWED: f64 = 0.6;

/// How a figure compares with its snapshot.
#[derive(Debug, Clone, PartialEq)]
pub enum Comparison {
    /// The same to the digits kept.
    Same,
    /// There was none, or another one: the new one has been written.
    Written,
    /// There is none.
    Missing,
    /// They differ, first at this line.
    Differs(Difference),
}

/// The first difference between a snapshot and a figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Line of the snapshot, from 1.
    pub line: usize,
    /// What it says.
    pub stored: String,
    /// What the figure says now.
    pub now: String,
}

/// What to do with a snapshot that is missing or differs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Policy {
    /// Report it.
    Check,
    /// Write the new one.
    Update,
}

/// Holds `figure` against its snapshot in `folder`, or writes it, as `policy` says.
///
/// # Errors
/// If the snapshot cannot be read or written.
pub fn compare(folder: &Path, figure: &Figure, policy: Policy) -> std::io::Result<Comparison> {
    let path = path(folder, &figure.id);
    let now = lines(figure);
    let found = match std::fs::read_to_string(&path) {
        Ok(stored) => match difference(&stored, &now) {
            None => return Ok(Comparison::Same),
            Some(difference) => Comparison::Differs(difference),
        },
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Comparison::Missing,
        Err(error) => return Err(error),
    };
    if policy == Policy::Update {
        std::fs::create_dir_all(folder)?;
        std::fs::write(&path, text(&now))?;
        return Ok(Comparison::Written);
    }
    Ok(found)
}

/// The file of the snapshot of figure `id`.
#[must_use]
pub fn path(folder: &Path, id: &str) -> PathBuf {
    folder.join(format!("{id}.txt"))
}

/// A line of a snapshot: words, or numbers with their rounding steps.
#[derive(Debug, Clone, PartialEq)]
enum Line {
    Words(String),
    Numbers(Vec<Kept>),
}

/// A cell of a line.
#[derive(Debug, Clone, PartialEq)]
enum Kept {
    Number { value: f64, step: Step },
    Word(String),
}

/// A power of ten to which numbers are rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Step(i32);

impl Step {
    /// The step that keeps `digits` digits of the largest of `values`.
    fn of(values: impl Iterator<Item = f64>, digits: u8) -> Self {
        let largest = values.map(f64::abs).fold(0.0, f64::max);
        if largest == 0.0 {
            return Self(-i32::from(digits));
        }
        let exponent = format!("{largest:e}").split_once('e').and_then(|(_, e)| e.parse().ok());
        Self(exponent.unwrap_or(0) + 1 - i32::from(digits))
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

/// The content of a figure's snapshot.
fn lines(figure: &Figure) -> Vec<Line> {
    let digits = figure.precision.digits;
    let mut lines = vec![Line::Words(format!("{} ({digits} digits)", figure.id))];
    for panel in &figure.panels {
        let words = format!("panel: {} | {} | {}", panel.title, panel.x.label, panel.y.label);
        lines.push(Line::Words(words));
        for series in &panel.series {
            push_series(&mut lines, series, digits);
        }
    }
    for table in &figure.tables {
        push_table(&mut lines, table, digits);
    }
    lines
}

fn push_series(lines: &mut Vec<Line>, series: &Series, digits: u8) {
    let count = series.points.len();
    let x = Step::of(series.points.iter().map(|point| point.x), digits);
    let y = Step::of(series.points.iter().map(|point| point.y), digits);
    lines.push(Line::Words(format!("series: {} | {count} points", series.label)));
    let kept = count.min(KEPT);
    let indices = (0..kept).map(|i| if kept > 1 { i * (count - 1) / (kept - 1) } else { 0 });
    lines.extend(indices.map(|i| {
        let point = series.points[i];
        Line::Numbers(vec![
            Kept::Number { value: point.x, step: x },
            Kept::Number { value: point.y, step: y },
        ])
    }));
}

fn push_table(lines: &mut Vec<Line>, table: &Table, digits: u8) {
    lines.push(Line::Words(format!("table: {} | {}", table.title, table.columns.join(" | "))));
    for row in &table.rows {
        let cells = row.iter().map(|cell| match cell {
            Cell::Number(value) => {
                Kept::Number { value: *value, step: Step::of(std::iter::once(*value), digits) }
            }
            Cell::Text(text) => Kept::Word(text.clone()),
            Cell::Remark(_) => Kept::Word("-".to_owned()),
        });
        lines.push(Line::Numbers(cells.collect()));
    }
}

fn text(lines: &[Line]) -> String {
    let mut text = String::new();
    for line in lines {
        let _ = writeln!(text, "{}", written(line));
    }
    text
}

fn written(line: &Line) -> String {
    match line {
        Line::Words(words) => words.clone(),
        Line::Numbers(cells) => {
            let cells = cells.iter().map(|cell| match cell {
                Kept::Number { value, step } => step.rounded(*value),
                Kept::Word(word) => word.clone(),
            });
            cells.collect::<Vec<_>>().join("\t")
        }
    }
}

/// The first difference between the stored text and the lines of now.
fn difference(stored: &str, now: &[Line]) -> Option<Difference> {
    let stored: Vec<&str> = stored.lines().collect();
    for (i, line) in now.iter().enumerate() {
        let stored = stored.get(i).copied();
        if !stored.is_some_and(|stored| agrees(stored, line)) {
            let stored = stored.unwrap_or("(end)").to_owned();
            return Some(Difference { line: i + 1, stored, now: written(line) });
        }
    }
    let extra = stored.get(now.len())?;
    Some(Difference { line: now.len() + 1, stored: (*extra).to_owned(), now: "(end)".to_owned() })
}

fn agrees(stored: &str, now: &Line) -> bool {
    match now {
        Line::Words(words) => stored == words,
        Line::Numbers(cells) => {
            let stored: Vec<&str> = stored.split('\t').collect();
            stored.len() == cells.len()
                && stored.iter().zip(cells).all(|(stored, cell)| match cell {
                    Kept::Word(word) => stored == word,
                    Kept::Number { value, step } => stored
                        .parse::<f64>()
                        .is_ok_and(|stored| (stored - value).abs() <= ALLOWED * step.size()),
                })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_plot::{Axis, Panel};

    fn figure(scale: f64) -> Figure {
        let mut figure = Figure { id: "0.1".to_owned(), ..Figure::new() };
        let mut panel = Panel::new(Axis::linear("x"), Axis::linear("y"));
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
        let text = text(&lines(&figure(1.0)));
        insta::assert_snapshot!(text.lines().take(5).collect::<Vec<_>>().join("\n"), @r"
        0.1 (6 digits)
        panel:  | x | y
        series: curve | 100 points
        0.0000	0.00
        3.0000	1.29
        ");
        assert_eq!(text.lines().count(), 3 + KEPT + 2);
        assert!(
            text.ends_with("99.0000\t1400.14\ntable: numbers | name | value\na\t-333333e-15\n")
        );
    }

    #[test]
    fn last_bits_never_show_and_changes_do() {
        let stored = text(&lines(&figure(1.0)));
        assert_eq!(difference(&stored, &lines(&figure(1.0 + 1e-12))), None);
        let changed = difference(&stored, &lines(&figure(1.0 + 1e-4))).unwrap();
        assert_eq!(changed.stored, stored.lines().nth(changed.line - 1).unwrap());
        let mut longer = figure(1.0);
        longer.tables[0].row([Cell::from("b"), Cell::from(0.0)]);
        assert!(difference(&stored, &lines(&longer)).is_some());
        let mut shorter = figure(1.0);
        shorter.tables.clear();
        assert_eq!(difference(&stored, &lines(&shorter)).unwrap().now, "(end)");
    }

    #[test]
    fn a_value_on_the_edge_of_rounding_is_stable() {
        // 0.5 rounds to 0 or 1 by a last bit; both texts accept both values.
        for text in ["0", "1"] {
            for value in [0.5 - 1e-15, 0.5 + 1e-15] {
                assert!(agrees(text, &Line::Numbers(vec![Kept::Number { value, step: Step(0) }])));
            }
        }
    }

    #[test]
    fn updating_writes_once() {
        let folder = std::env::temp_dir().join(format!("carom-snapshot-{}", std::process::id()));
        let figure = figure(1.0);
        assert_eq!(compare(&folder, &figure, Policy::Check).unwrap(), Comparison::Missing);
        assert_eq!(compare(&folder, &figure, Policy::Update).unwrap(), Comparison::Written);
        assert_eq!(compare(&folder, &figure, Policy::Update).unwrap(), Comparison::Same);
        std::fs::remove_dir_all(folder).unwrap();
    }
}
