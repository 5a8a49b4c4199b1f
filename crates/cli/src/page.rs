//! The page on which tables are printed: tables fit the width of the terminal.
//!
//! Columns with the same value in every row are named below the table instead. A table that is still
//! too wide is turned upright if it has few rows; otherwise its columns follow in blocks, each
//! beginning with the first column. Without a terminal tables are as wide as their content.

use comfy_table::{
    CellAlignment, ColumnConstraint, ContentArrangement, Table, Width, presets::UTF8_FULL_CONDENSED,
};

/// Rows up to which a table that is too wide is turned upright.
const FEW: usize = 6;
/// Columns of texts beyond which a table that is too wide becomes paragraphs.
const MANY: usize = 4;
/// Characters beyond which a text wraps where columns follow in blocks.
const LONGEST_TEXT: usize = 32;
/// Characters of the border and padding of a column.
const FRAME: usize = 3;
/// Narrowest page; narrower terminals wrap lines.
const NARROWEST: usize = 40;

/// A space at which no line ends.
const TIED: &str = "\u{a0}";

/// How tables are laid out.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Page {
    /// Characters of a line; `None` for any number.
    width: Option<usize>,
    columns: Shown,
}

/// Which columns a table shows.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
enum Shown {
    /// Those whose values differ between rows.
    #[default]
    Varying,
    All,
}

impl Page {
    /// As wide as the terminal of standard output; if that is no terminal, of the width in the
    /// environment variable `COLUMNS`, or of any width without it.
    #[must_use]
    pub fn of_terminal() -> Self {
        let named =
            || std::env::var("COLUMNS").ok()?.parse().ok().map(|width: usize| width.max(NARROWEST));
        Self { width: width(&console::Term::stdout()).or_else(named), ..Self::default() }
    }

    /// The same page, with all columns shown.
    #[must_use]
    pub const fn whole(self) -> Self {
        Self { columns: Shown::All, ..self }
    }

    /// Records as a table, without the columns that are the same in every row; nothing without columns.
    #[must_use]
    pub fn records(self, labels: &[impl AsRef<str>], rows: &[Vec<String>]) -> String {
        let labels: Vec<&str> = labels.iter().map(AsRef::as_ref).collect();
        if labels.is_empty() {
            return String::new();
        }
        let varies = |place: &usize| rows.iter().any(|row| row[*place] != rows[0][*place]);
        let kept: Vec<usize> = (0..labels.len()).filter(varies).collect();
        if self.columns == Shown::All || rows.len() < 2 || kept.is_empty() {
            return self.fitted(&labels, rows);
        }
        let pick = |row: &Vec<String>| kept.iter().map(|place| row[*place].clone()).collect();
        let heads: Vec<&str> = kept.iter().map(|place| labels[*place]).collect();
        let left_out = (0..labels.len()).filter(|place| !varies(place));
        self.fitted(&heads, &rows.iter().map(pick).collect::<Vec<_>>())
            + &self.fold(&constants(left_out.map(|place| (labels[place], &*rows[0][place]))))
    }

    /// A table of texts without empty columns. Where the page is too narrow the texts wrap; of many
    /// columns a paragraph for each row is made.
    #[must_use]
    pub fn texts(self, heads: &[impl AsRef<str>], rows: &[Vec<String>]) -> String {
        let is_empty = |place: &usize| rows.iter().all(|row| row[*place].is_empty());
        let kept: Vec<usize> = (0..heads.len()).filter(|place| !is_empty(place)).collect();
        let heads: Vec<&str> = kept.iter().map(|place| heads[*place].as_ref()).collect();
        let pick = |row: &Vec<String>| kept.iter().map(|place| row[*place].clone()).collect();
        let rows: Vec<Vec<String>> = rows.iter().map(pick).collect();
        match self.width {
            Some(width) if heads.len() > MANY && natural(&heads, &rows) > width => {
                rows.iter().map(|row| paragraph(&heads, row, width)).collect()
            }
            _ => self.draw(&heads, &rows),
        }
    }

    /// A text whose lines end before the page does.
    #[must_use]
    pub fn fold(self, text: &str) -> String {
        fold(text, self.width)
    }

    fn fitted(self, labels: &[&str], rows: &[Vec<String>]) -> String {
        let Some(width) = self.width else { return self.draw(labels, rows) };
        let labels: Vec<String> = labels.iter().map(|&label| label.to_owned()).collect();
        if natural(&labels, rows) <= width {
            return self.draw(&labels, rows);
        }
        let stacked: Vec<String> =
            labels.iter().map(|label| label.replacen(" / ", "\n/ ", 1)).collect();
        if natural(&stacked, rows) <= width {
            return self.draw(&stacked, rows);
        }
        if rows.len() <= FEW {
            let (heads, lines) = upright(&labels, rows);
            if natural(&heads, &lines) <= width {
                return self.draw(&heads, &lines);
            }
        }
        self.blocks(&stacked, rows, width)
    }

    /// The columns in blocks below each other, each beginning with the first column.
    fn blocks(self, heads: &[String], rows: &[Vec<String>], width: usize) -> String {
        let wide = |place| widest(heads, rows, place).min(LONGEST_TEXT) + FRAME;
        let mut blocks = vec![vec![0]];
        let mut filled = wide(0) + 1;
        for place in 1..heads.len() {
            if filled + wide(place) > width && blocks.last().is_some_and(|block| block.len() > 1) {
                blocks.push(vec![0]);
                filled = wide(0) + 1;
            }
            filled += wide(place);
            blocks.last_mut().into_iter().for_each(|block| block.push(place));
        }
        let pick = |block: &[usize], row: &[String]| -> Vec<String> {
            block.iter().map(|place| row[*place].clone()).collect()
        };
        let block = |block: &Vec<usize>| {
            let rows: Vec<_> = rows.iter().map(|row| pick(block, row)).collect();
            self.draw(&pick(block, heads), &rows)
        };
        blocks.iter().map(block).collect()
    }

    /// The table with numbers aligned to the right; texts wrap where the page is too narrow.
    fn draw(self, heads: &[impl AsRef<str>], rows: &[Vec<String>]) -> String {
        let mut table = Table::new();
        table.load_style(UTF8_FULL_CONDENSED);
        table.set_header(heads.iter().map(AsRef::as_ref));
        table.add_rows(rows);
        let narrow = self.width.filter(|width| natural(heads, rows) > *width);
        if let Some(width) = narrow {
            table.set_content_arrangement(ContentArrangement::Dynamic);
            table.set_width(u16::try_from(width).unwrap_or(u16::MAX));
        }
        for index in 0..heads.len() {
            let Some(column) = table.column_mut(index) else { continue };
            let is_numeric =
                rows.iter().all(|row| row.get(index).is_some_and(|cell| is_numeric(cell)));
            if is_numeric {
                column.set_cell_alignment(CellAlignment::Right);
            }
            let content = widest::<&str>(&[], rows, index) + 2;
            let is_name = |width: usize| index == 0 && 2 * content < width;
            if narrow.is_some_and(|width| is_numeric || is_name(width)) {
                let content = Width::Fixed(u16::try_from(content).unwrap_or(u16::MAX));
                column.set_constraint(ColumnConstraint::LowerBoundary(content));
            }
        }
        format!("{table}\n")
    }
}

/// Heads and lines of the table turned upright: a line for each column, the rows numbered.
fn upright(labels: &[String], rows: &[Vec<String>]) -> (Vec<String>, Vec<Vec<String>>) {
    let numbers = (1..=rows.len()).map(|number| number.to_string());
    let line = |(place, label): (usize, &String)| {
        std::iter::once(label.clone()).chain(rows.iter().map(|row| row[place].clone())).collect()
    };
    let heads = std::iter::once(String::new()).chain(numbers).collect();
    (heads, labels.iter().enumerate().map(line).collect())
}

/// The first text of a row, and the others with their heads in an indented paragraph.
fn paragraph(heads: &[&str], row: &[String], width: usize) -> String {
    let others = heads.iter().zip(row).skip(1).filter(|(_, text)| !text.is_empty());
    let others: Vec<String> = others.map(|(head, text)| format!("{head}: {text}")).collect();
    let folded = fold(&others.join("; "), Some(width - INDENT.len()));
    let lines: String = folded.lines().map(|line| format!("{INDENT}{line}\n")).collect();
    format!("{}\n{lines}", row.first().map_or("", String::as_str))
}

/// Indentation of a paragraph.
const INDENT: &str = "    ";

/// The characters of a line of the terminal; `None` if it is none.
#[must_use]
pub fn width(terminal: &console::Term) -> Option<usize> {
    let size = terminal.is_term().then(|| terminal.size_checked()).flatten();
    size.map(|(_, columns)| usize::from(columns).max(NARROWEST))
}

/// A text whose lines have at most `width` characters, broken between words.
#[must_use]
pub fn fold(text: &str, width: Option<usize>) -> String {
    let Some(width) = width else { return text.replace(TIED, " ") };
    let mut folded = String::new();
    for line in text.split_inclusive('\n') {
        let mut filled = 0;
        for word in line.split_inclusive(' ') {
            let length = word.trim_end().chars().count();
            if filled > 0 && filled + length > width {
                folded.truncate(folded.trim_end_matches(' ').len());
                folded.push('\n');
                filled = 0;
            }
            folded.push_str(word);
            filled += word.chars().count();
        }
    }
    folded.replace(TIED, " ")
}

/// A text of which a line that is too long goes on below its own beginning: below the words of a
/// paragraph, or below the meaning beside a name, two spaces or more from it. Letters may be coloured.
#[must_use]
pub fn hang(text: &str, width: usize) -> String {
    let mut hung = String::new();
    for line in text.split_inclusive('\n') {
        let indent = " ".repeat(beginning(&console::strip_ansi_codes(line), width));
        let mut filled = 0;
        for word in line.split_inclusive(' ') {
            let is_begun = filled > indent.len();
            if is_begun && filled + console::measure_text_width(word.trim_end()) > width {
                hung.truncate(hung.trim_end_matches(' ').len());
                hung += &format!("\n{indent}");
                filled = indent.len();
            }
            hung.push_str(word);
            filled += console::measure_text_width(word);
        }
    }
    hung
}

/// Where the words of a line begin, beside a name if there is one on the left.
fn beginning(line: &str, width: usize) -> usize {
    let lead = line.len() - line.trim_start().len();
    let Some((name, words)) = line[lead..].split_once("  ") else { return lead };
    let beside = lead + name.chars().count() + 2 + (words.len() - words.trim_start().len());
    if 2 * beside < width { beside } else { lead }
}

fn is_numeric(cell: &str) -> bool {
    matches!(cell, "" | "-") || cell.parse::<f64>().is_ok()
}

/// The longest line of a column.
fn widest<T: AsRef<str>>(heads: &[T], rows: &[Vec<String>], place: usize) -> usize {
    let cells = rows.iter().filter_map(|row| row.get(place).map(String::as_str));
    let lines = heads.get(place).map(AsRef::as_ref).into_iter().chain(cells).flat_map(str::lines);
    lines.map(|line| line.chars().count()).max().unwrap_or(0)
}

/// The characters of a line of the table, if no text wraps.
fn natural<T: AsRef<str>>(heads: &[T], rows: &[Vec<String>]) -> usize {
    (0..heads.len()).map(|place| widest(heads, rows, place) + FRAME).sum::<usize>() + 1
}

/// Sentences that name the columns left out of a table, with their values.
fn constants<'a>(columns: impl Iterator<Item = (&'a str, &'a str)>) -> String {
    let (zero, same): (Vec<_>, Vec<_>) =
        columns.filter(|(_, value)| !value.is_empty()).partition(|(_, value)| *value == "0");
    let name = |label: &'a str| label.split_once(" / ").unwrap_or((label, ""));
    let equation = |(label, value): &(&'a str, &'a str)| {
        let (name, unit) = name(label);
        format!("{name} = {value} {unit}").trim_end().replace(' ', TIED)
    };
    let zero: Vec<String> = zero.iter().map(|(label, _)| name(label).0.to_owned()).collect();
    let same: Vec<String> = same.iter().map(equation).collect();
    let mut text = String::new();
    for (title, names) in [("In every row", same), ("Zero in every row", zero)] {
        if !names.is_empty() {
            text += &format!("{title}: {}\n", names.join(", "));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(width: usize) -> Page {
        Page { width: Some(width), ..Page::default() }
    }

    fn rows(count: usize) -> Vec<Vec<String>> {
        let row = |i: usize| {
            [i.to_string(), format!("{}.5", i * i), "7".into(), "0".into(), "stick slip".into()]
        };
        (0..count).map(|i| row(i).to_vec()).collect()
    }

    const LABELS: [&str; 5] = ["step", "F_x / N", "zeta / m", "F_y / N", "regimes"];

    #[test]
    fn numbers_are_aligned_to_the_right() {
        let rows = [vec!["1".to_owned(), "a, b".to_owned()]];
        insta::assert_snapshot!(Page::default().records(&["value", "name"], &rows), @r"
        ┌───────┬──────┐
        │ value ┆ name │
        ╞═══════╪══════╡
        │     1 ┆ a, b │
        └───────┴──────┘
        ");
    }

    #[test]
    fn what_is_the_same_in_every_row_is_named_below() {
        insta::assert_snapshot!(Page::default().records(&LABELS, &rows(3)), @r"
        ┌──────┬─────────┐
        │ step ┆ F_x / N │
        ╞══════╪═════════╡
        │    0 ┆     0.5 │
        │    1 ┆     1.5 │
        │    2 ┆     4.5 │
        └──────┴─────────┘
        In every row: zeta = 7 m, regimes = stick slip
        Zero in every row: F_y
        ");
        let whole = Page::default().whole().records(&LABELS, &rows(3));
        assert!(LABELS.iter().all(|label| whole.contains(label)), "{whole}");
        // A single record, and records that are all the same, are shown in full.
        assert!(Page::default().records(&LABELS, &rows(1)).contains("zeta"));
        assert_eq!(Page::default().records(&[""; 0], &[]), "");
        assert!(Page::default().records(&LABELS, &vec![rows(1).remove(0); 3]).contains("zeta"));
    }

    #[test]
    fn no_line_is_longer_than_the_page_and_nothing_is_lost() {
        let labels: Vec<String> = (0..20).map(|i| format!("quantity_{i} / kg m2")).collect();
        for (count, width) in [(2, 60), (5, 100), (40, 60), (40, 80), (40, 139), (1, 50)] {
            let row = |j: usize| (0..20).map(|i| format!("{i}{}", 1000 + j)).collect();
            let rows: Vec<Vec<String>> = (0..count).map(row).collect();
            let text = page(width).records(&labels, &rows);
            let longest = text.lines().map(|line| line.chars().count()).max();
            assert!(longest <= Some(width), "{width}: {longest:?}\n{text}");
            assert!(rows.iter().flatten().all(|cell| text.contains(cell.as_str())), "{text}");
        }
    }

    #[test]
    fn a_meaning_goes_on_below_itself() {
        assert_eq!(hang("  -q  print errors only\n", 18), "  -q  print errors\n      only\n");
        assert_eq!(hang("    print errors only", 18), "    print errors\n    only");
        assert_eq!(hang("print errors only", 18), "print errors only");
        assert_eq!(
            hang("--a-long-name-of-one  word and word", 24),
            "--a-long-name-of-one\nword and word"
        );
        assert_eq!(
            hang("\u{1b}[1mprint\u{1b}[0m errors only", 17),
            "\u{1b}[1mprint\u{1b}[0m errors only"
        );
    }

    #[test]
    fn texts_wrap_between_words() {
        assert_eq!(fold("a bc def\n  gh", Some(5)), "a bc\ndef\n  gh");
        assert_eq!(fold("a bc def", None), "a bc def");
        assert_eq!(fold("x y = 1 m, z", Some(6)).replace('\n', "|"), "x y =|1 m, z");
        assert_eq!(fold(&format!("x, y{TIED}={TIED}1"), Some(6)), "x,\ny = 1");
        assert_eq!(fold("longerthanthepage a", Some(6)), "longerthanthepage\na");
    }
}
