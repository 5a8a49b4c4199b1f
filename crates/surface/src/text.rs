//! Texts: rows of numbers with any separator, heads and comments, or lists of points x, y, z.

use crate::bytes::metres;
use crate::error::SurfaceError;
use crate::format::{Format, Measured, Reading};
use crate::points;
use crate::topography::Topography;
use std::borrow::Cow;

/// Words for a missing point.
const MISSING: &[&str] = &[
    "nan", "-nan", "na", "n/a", "#n/a", "bad", "null", "none", "masked", "-", "--", "---", "***",
    "*", "1.#qnan", "-1.#ind",
];
/// First letters of a line that is a comment.
const COMMENTS: &[char] = &['#', '%', '!', '"'];
/// Letters of a text that an error quotes.
const QUOTED: usize = 30;

/// A text of a file, short enough to be quoted.
pub(crate) fn shortened(text: &str) -> String {
    match text.char_indices().nth(QUOTED) {
        None => text.to_owned(),
        Some((end, _)) => format!("{}...", &text[..end]),
    }
}

/// How the numbers of a text are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Dialect {
    /// None: blanks.
    separator: Option<char>,
    has_comma: bool,
}

impl Dialect {
    /// The dialect of a line of numbers.
    fn of(line: &str) -> Self {
        let separator = ['\t', ';'].into_iter().find(|letter| line.contains(*letter));
        if separator.is_some() {
            return Self { separator, has_comma: line.contains(',') && !line.contains('.') };
        }
        // A comma between digits is decimal if blanks separate the numbers and no point is there.
        let letters: Vec<char> = line.trim().chars().collect();
        let is_digit =
            |at: Option<usize>| at.and_then(|at| letters.get(at)).is_some_and(char::is_ascii_digit);
        let commas: Vec<usize> = (0..letters.len()).filter(|at| letters[*at] == ',').collect();
        let is_inside = |at: &usize| is_digit(at.checked_sub(1)) && is_digit(Some(at + 1));
        let has_blank = letters.iter().any(|letter| letter.is_whitespace());
        match () {
            () if commas.is_empty() => Self { separator: None, has_comma: false },
            () if has_blank && commas.iter().all(is_inside) && !line.contains('.') => {
                Self { separator: None, has_comma: true }
            }
            () => Self { separator: Some(','), has_comma: false },
        }
    }

    /// The values of a line.
    fn values(self, line: &str) -> impl Iterator<Item = &str> {
        let line = line.trim();
        let (blanks, others) = match self.separator {
            None => (Some(line.split_whitespace()), None),
            Some(separator) => (None, Some(line.split(separator).map(str::trim))),
        };
        blanks.into_iter().flatten().chain(others.into_iter().flatten())
    }

    /// The number that a value is; NaN where a point is missing.
    fn number(self, found: &str) -> Option<f64> {
        if found.is_empty() || MISSING.iter().any(|word| found.eq_ignore_ascii_case(word)) {
            return Some(f64::NAN);
        }
        let text: Cow<'_, str> =
            if self.has_comma { found.replace(',', ".").into() } else { found.into() };
        text.parse().ok().filter(|number: &f64| number.is_finite())
    }

    /// Whether all values of a line are numbers, and one is there.
    fn fits(self, line: &str) -> bool {
        let mut is_measured = false;
        let all = self.values(line).all(|value| {
            let number = self.number(value);
            is_measured |= number.is_some_and(|number| !number.is_nan());
            number.is_some()
        });
        all && is_measured
    }

    /// Whether a line before the first row is one too, of as many values, some of which are wrong numbers and no words.
    fn is_damaged_row(self, line: &str, first: &str) -> bool {
        let resembles_number = |value: &str| {
            let bare = value.trim_start_matches(['+', '-', '.']);
            bare.starts_with(|letter: char| letter.is_ascii_digit())
                || ["inf", "infinity"].iter().any(|word| bare.eq_ignore_ascii_case(word))
        };
        let is_measured = |value| self.number(value).is_some_and(|number| !number.is_nan());
        let is_grouped = |value: &str| value.contains(|sign: char| ['.', ','].contains(&sign));
        let is_of_digits =
            |value: &str| value.chars().all(|sign| sign.is_ascii_digit() || "+-.,".contains(sign));
        let is_row = self.values(line).any(is_measured)
            && self.values(line).all(|one| self.number(one).is_some() || resembles_number(one));
        // All with separators of thousands.
        let is_of_thousands = self.values(line).any(is_grouped)
            && self.values(line).all(|one| resembles_number(one) && is_of_digits(one));
        self.values(line).count() == self.values(first).count() && (is_row || is_of_thousands)
    }

    /// What a value that is no number may be.
    fn hint(self, found: &str) -> &'static str {
        match () {
            () if found.contains(',') && found.contains('.') => {
                "; numbers have no separators of thousands"
            }
            () if found.contains(',') => {
                "; a decimal comma is read where `;`, a tab or blanks separate the numbers"
            }
            () if found.to_ascii_lowercase().contains("inf") => "; a missing point is nan",
            () => "",
        }
    }
}

/// What the head of a text says.
#[derive(Debug, Default)]
struct Head {
    /// Lengths of the map along x and y in m.
    size: [Option<f64>; 2],
    /// Metres of a unit of heights.
    unit: Option<f64>,
    /// Metres of a unit of x and of y, of a list of points.
    units: [Option<f64>; 2],
    /// The value of a missing point.
    missing: Option<f64>,
    /// The step of a grid of ESRI, of which the first row has the greatest y.
    cell: Option<f64>,
    is_grid: bool,
    /// What it says of lengths that is none.
    notes: Vec<String>,
    /// Whether its three columns are named x, y and z.
    names_points: bool,
    /// The numbers of its columns and rows.
    counts: [Option<usize>; 2],
    /// A line of two whole numbers before the heights, and the numbers.
    lonely: Option<(usize, [usize; 2])>,
}

impl Head {
    /// Takes what a line of the head says.
    fn take(&mut self, line: &str) {
        let line = line.trim_start_matches(COMMENTS).trim();
        let (name, value) = match line.split_once([':', '=']) {
            Some(parts) => parts,
            None => line.split_once(char::is_whitespace).unwrap_or((line, "")),
        };
        let (name, value) = (name.trim().to_ascii_lowercase(), value.trim());
        // "Height of a sample" is a title.
        let is_title = !line.contains([':', '=']);
        let is_understood = match name.as_str() {
            "width" | "height" => is_title || length(value).is_some(),
            "value units" | "z unit" | "unit" | "units" => is_title || metres(value).is_some(),
            "cellsize" => value.parse().is_ok_and(|cell: f64| cell > 0.0 && cell.is_finite()),
            _ => true,
        };
        if !is_understood {
            self.notes.push(format!("its `{line}` is no length and counts for nothing"));
        }
        match name.as_str() {
            "width" => self.size[0] = length(value),
            "height" => self.size[1] = length(value),
            "value units" | "z unit" | "unit" | "units" => self.unit = metres(value),
            "cellsize" => self.cell = value.parse().ok(),
            "ncols" | "nrows" => {
                self.is_grid = true;
                self.counts[usize::from(name == "nrows")] = value.parse().ok();
            }
            "nodata_value" => self.missing = value.parse().ok(),
            _ => self.take_heads(line),
        }
    }

    /// Takes the units in the heads of three columns x, y, z, such as `x [mm]`.
    fn take_heads(&mut self, line: &str) {
        let dialect = Dialect::of(line);
        let heads: Vec<&str> = match dialect.separator {
            Some(_) => dialect.values(line).collect(),
            // Blanks also stand before the units.
            None => line.split_inclusive([']', ')']).map(str::trim).collect(),
        };
        let unit = |head: &str| {
            let (_, rest) = head.split_once(['[', '(', '/'])?;
            metres(rest.trim_end_matches([']', ')']))
        };
        let names = |head: &[&str]| {
            head.len() == 3
                && (0..3).all(|k| {
                    head[k].trim_matches('"').to_ascii_lowercase().starts_with(["x", "y", "z"][k])
                })
        };
        let words: Vec<&str> = line.split_whitespace().collect();
        self.names_points |= names(&heads) || names(&words);
        if let [x, y, z] = heads[..]
            && x.to_ascii_lowercase().starts_with('x')
        {
            self.units = [unit(x), unit(y)];
            self.unit = unit(z).or(self.unit);
        }
    }
}

/// A length with its unit, such as `10.5 um`.
fn length(text: &str) -> Option<f64> {
    let (number, unit) = text.split_once(char::is_whitespace)?;
    let number: f64 = number.replace(',', ".").parse().ok()?;
    Some(number * metres(unit)?).filter(|length| *length > 0.0 && length.is_finite())
}

/// The rows of a text.
struct Rows {
    head: Head,
    /// Line of each row, from 1.
    lines: Vec<usize>,
    columns: usize,
    values: Vec<f64>,
    /// Whether each row ends with a separator.
    has_tails: bool,
}

pub(crate) fn read(text: &str, reading: &Reading) -> Result<Measured, SurfaceError> {
    let rows = rows(text, reading)?;
    let head = &rows.head;
    let unit = reading.unit.or(head.unit);
    let mut notes = head.notes.clone();
    if let (Some(given), Some(own)) = (reading.unit, head.unit)
        && (given / own - 1.0).abs() > 1e-9
    {
        notes.push(format!(
            "its head states heights in units of {own:?} m: those given, {given:?} m, count"
        ));
    }
    if let Some(listed) = listed(&rows, reading.most_points) {
        let map = listed?;
        reading.check(map.columns(), map.rows())?;
        let [x, y] = head.units.map(|own| reading.unit.or(own).or(unit).unwrap_or(1.0));
        let spacing = map.spacing().map(|[dx, dy]| [x * dx, y * dy]);
        let map = map.scaled(unit.unwrap_or(1.0))?.spaced(spacing);
        return Ok(Measured {
            topography: map,
            format: Format::Points,
            has_unit: unit.is_some(),
            notes,
        });
    }
    let (columns, count) = (rows.columns, rows.lines.len());
    if head.names_points && columns == 3 {
        let reason = "the places x, y of this list lie on no regular grid".to_owned();
        return Err(SurfaceError::Points { line: rows.lines[0], reason });
    }
    reading.check(columns, count)?;
    let mut values = rows.values;
    if head.is_grid {
        values = values.chunks_exact(columns).rev().flatten().copied().collect();
    }
    let spacing = match (head.size, head.cell) {
        ([Some(x), Some(y)], _) => Some([x / columns as f64, y / count as f64]),
        (_, Some(cell)) if cell > 0.0 => {
            if unit.is_none() {
                notes.push(format!("its cellsize of {cell} has no unit: give unit"));
            }
            unit.map(|unit| [cell * unit; 2])
        }
        _ => None,
    };
    let map = Topography::new(columns, values).map_err(|_| empty(text))?;
    let topography = map.scaled(unit.unwrap_or(1.0))?.spaced(spacing);
    Ok(Measured { topography, format: Format::Text, has_unit: unit.is_some(), notes })
}

fn empty(text: &str) -> SurfaceError {
    let hint = if text.trim().is_empty() { ": it is empty" } else { ": no line has numbers alone" };
    SurfaceError::Empty { hint }
}

/// The map of rows of three numbers that are points on a grid.
fn listed(rows: &Rows, most: usize) -> Option<Result<Topography, SurfaceError>> {
    if rows.columns != 3 || rows.lines.len() < 4 {
        return None;
    }
    let points: Vec<[f64; 3]> =
        rows.values.chunks_exact(3).map(|row| [row[0], row[1], row[2]]).collect();
    if points.iter().any(|[x, y, _]| x.is_nan() || y.is_nan()) {
        return None;
    }
    points::map(&points, most, |number| rows.lines[number])
}

/// Lines of a text with their numbers, without empty lines and comments.
fn content(text: &str) -> impl Iterator<Item = (usize, &str)> + Clone {
    let lines = text.split('\n').flat_map(|line| line.trim_end_matches('\r').split('\r'));
    lines.enumerate().map(|(at, line)| (at + 1, line)).filter(|(_, line)| !line.trim().is_empty())
}

fn rows(text: &str, reading: &Reading) -> Result<Rows, SurfaceError> {
    let mut head = Head::default();
    let is_comment = |line: &str| line.trim_start().starts_with(COMMENTS);
    let mut lines = content(text).peekable();
    let (mut dialect, mut before) = (None, None);
    // The head ends at the first line that has numbers alone.
    while let Some((_, line)) = lines.peek().copied() {
        let own = Dialect::of(line);
        if !is_comment(line) && (own.fits(line) || is_unmeasured_row(lines.clone(), own)) {
            let Some(size) = lonely(lines.clone(), own) else {
                dialect = Some(own);
                break;
            };
            head.lonely = Some(size);
        }
        head.take(line);
        before = lines.next().filter(|_| !is_comment(line));
    }
    let Some(mut dialect) = dialect else { return Err(no_numbers(text)) };
    if let (Some(last), Some((_, first))) = (before, lines.peek())
        && dialect.is_damaged_row(last.1, first)
    {
        return Err(not_numbers(last, dialect));
    }
    let mut rows =
        Rows { head, lines: Vec::new(), columns: 0, values: Vec::new(), has_tails: true };
    for (at, line) in lines.filter(|(_, line)| !is_comment(line)) {
        // Whole numbers alone do not tell a decimal comma.
        if !dialect.has_comma && dialect.separator != Some(',') && line.contains(',') {
            let own = Dialect::of(line);
            dialect.has_comma = own.has_comma && own.separator == dialect.separator;
        }
        rows.take(at, line, dialect)?;
        reading.check_count(rows.columns, rows.lines.len())?;
    }
    if rows.has_tails && rows.columns > 1 {
        rows.cut_tails();
    }
    if rows.has_labels() {
        rows.cut_labels();
    }
    rows.check_size()?;
    if let Some(missing) = rows.head.missing {
        rows.values
            .iter_mut()
            .filter(|value| **value == missing)
            .for_each(|value| *value = f64::NAN);
    }
    Ok(rows)
}

/// Whether no point of the line is measured, but the next line has as many numbers.
fn is_unmeasured_row<'a>(
    mut lines: impl Iterator<Item = (usize, &'a str)>,
    dialect: Dialect,
) -> bool {
    let (Some((_, first)), Some((_, second))) = (lines.next(), lines.next()) else { return false };
    let missing = |value: &str| dialect.number(value).is_some_and(f64::is_nan);
    let own = Dialect::of(second);
    let is_row = own.values(second).all(|value| own.number(value).is_some());
    dialect.values(first).all(missing)
        && is_row
        && dialect.values(first).count() == own.values(second).count()
}

/// The line and its two whole numbers, if the next line has more: the size of the map that follows.
fn lonely<'a>(
    mut lines: impl Iterator<Item = (usize, &'a str)>,
    dialect: Dialect,
) -> Option<(usize, [usize; 2])> {
    let ((line, first), (_, second)) = (lines.next()?, lines.next()?);
    let size: Vec<usize> = dialect.values(first).map_while(|value| value.parse().ok()).collect();
    let size: [usize; 2] = size.try_into().ok()?;
    let next = Dialect::of(second);
    let is_size =
        dialect.values(first).count() == 2 && next.fits(second) && next.values(second).count() > 2;
    is_size.then_some((line, size))
}

fn no_numbers(text: &str) -> SurfaceError {
    let first = content(text).find(|(_, line)| !line.trim_start().starts_with(COMMENTS));
    first.map_or_else(|| empty(text), |line| not_numbers(line, Dialect::of(line.1)))
}

/// What of a line is no number.
fn not_numbers((line, found): (usize, &str), dialect: Dialect) -> SurfaceError {
    let wrong =
        dialect.values(found).enumerate().find(|(_, value)| dialect.number(value).is_none());
    match wrong {
        Some((place, value)) => SurfaceError::Value {
            line,
            column: place + 1,
            found: shortened(value),
            hint: dialect.hint(value),
        },
        None => empty(found),
    }
}

impl Rows {
    /// Takes a row of numbers.
    fn take(&mut self, line: usize, text: &str, dialect: Dialect) -> Result<(), SurfaceError> {
        let before = self.values.len();
        let mut is_open = false;
        for (place, found) in dialect.values(text).enumerate() {
            is_open = found.is_empty();
            let wrong = || SurfaceError::Value {
                line,
                column: place + 1,
                found: shortened(found),
                hint: dialect.hint(found),
            };
            self.values.push(dialect.number(found).ok_or_else(wrong)?);
        }
        self.has_tails &= is_open;
        let found = self.values.len() - before;
        self.lines.push(line);
        if self.columns == 0 {
            self.columns = found;
        }
        match found == self.columns {
            true => Ok(()),
            false => {
                let (first, expected) = (self.lines[0], self.columns);
                Err(SurfaceError::Ragged { line, found, first, expected })
            }
        }
    }

    /// Checks that two numbers before the heights are their size, in either order, and what a grid of ESRI says.
    fn check_size(&self) -> Result<(), SurfaceError> {
        let found = [self.columns, self.lines.len()];
        for (i, name) in ["ncols", "nrows"].into_iter().enumerate() {
            if let Some(count) = self.head.counts[i].filter(|count| *count != found[i]) {
                let reason = format!("{name} is {count}, but there are {}", found[i]);
                return Err(SurfaceError::damaged("text", reason));
            }
        }
        let Some((first, [one, other])) = self.head.lonely else { return Ok(()) };
        let (columns, count) = (self.columns, self.lines.len());
        match [one, other] == [columns, count] || [other, one] == [columns, count] {
            true => Ok(()),
            false => {
                let line = self.lines[0];
                Err(SurfaceError::Ragged { line, found: columns, first, expected: 2 })
            }
        }
    }

    /// Takes the empty values after the separators at the ends of all rows away.
    fn cut_tails(&mut self) {
        let columns = self.columns;
        let mut place = 0;
        self.values.retain(|_| {
            place += 1;
            place % columns != 0
        });
        self.columns -= 1;
    }

    /// Whether the first row and column number the others from 0 and their corner is empty, as tables are written.
    fn has_labels(&self) -> bool {
        let (columns, values) = (self.columns, &self.values);
        let counts = |step: usize, end: usize| {
            let labels = values[..end].iter().step_by(step).skip(1);
            labels.zip(0..).all(|(label, i)| *label == f64::from(i))
        };
        columns > 2
            && self.lines.len() > 2
            && values[0].is_nan()
            && counts(1, columns)
            && counts(columns, values.len())
    }

    /// Leaves them out.
    fn cut_labels(&mut self) {
        let rows = self.values.chunks_exact(self.columns).skip(1);
        self.values = rows.flat_map(|row| &row[1..]).copied().collect();
        self.lines.remove(0);
        self.columns -= 1;
        let note = "its first row and column number the others: they are left out";
        self.head.notes.push(note.to_owned());
    }
}
