//! The format of the results: the words of the command line and what they mean for a command.

use crate::error::CliError;
use crate::page::Page;
use carom_cases::case::likely;
use carom_table::renamed;
use std::sync::OnceLock;

/// Format of the results, as written on the command line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum FormatWord {
    /// A table to read, as wide as the terminal.
    Table,
    /// JSON with full precision.
    Json,
    /// Comma-separated values with full precision.
    Csv,
    /// No results: only the picture and the warnings.
    None,
}

/// Format of the results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// A table to read, laid out on a page.
    Table(Page),
    /// JSON with full precision.
    Json,
    /// Comma-separated values with full precision.
    Csv,
    /// The columns asked for, in that order.
    Chosen(Chosen),
    /// No results: only the picture and the warnings.
    None,
}

/// The columns of `--columns`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Chosen {
    /// Their heads. They live as long as the command.
    pub names: &'static [String],
    /// The page of a table to read; none for comma-separated values.
    pub page: Option<Page>,
}

impl Format {
    /// Whether this is a table to read.
    #[must_use]
    pub const fn is_table(self) -> bool {
        matches!(self, Self::Table(_))
    }
}

/// Options of every command that prints results.
#[derive(Debug, Clone, Default, clap::Args)]
pub struct Printing {
    /// Format of the results [default: table, or none if a picture is drawn]
    #[arg(long, value_enum)]
    format: Option<FormatWord>,
    /// Show all columns of a table, also those that are the same in every row.
    #[arg(long)]
    all: bool,
    /// Only these columns of the rows, in this order, as a table or with --format csv; --help lists all.
    #[arg(long, value_name = "NAME,..", value_delimiter = ',', conflicts_with = "all")]
    columns: Vec<String>,
    #[arg(skip)]
    kept: OnceLock<&'static [String]>,
}

impl Printing {
    /// The format for a command without a picture.
    #[must_use]
    pub fn format(&self) -> Format {
        self.or(FormatWord::Table)
    }

    /// The format for a command that draws a picture: only the picture, unless a format is given.
    #[must_use]
    pub fn format_beside_picture(&self) -> Format {
        self.or(if self.columns.is_empty() { FormatWord::None } else { FormatWord::Table })
    }

    /// Checks that the options fit each other.
    ///
    /// # Errors
    /// [`CliError::Options`] if columns are chosen of what has none.
    pub fn check(&self) -> Result<(), CliError> {
        match self.format {
            Some(FormatWord::Json | FormatWord::None) if !self.columns.is_empty() => {
                Err(CliError::Options("--columns chooses columns of a table or of --format csv"))
            }
            _ => Ok(()),
        }
    }

    fn or(&self, default: FormatWord) -> Format {
        let word = self.format.unwrap_or(default);
        let page = Page::of_terminal().whole();
        if !self.columns.is_empty() {
            let names = self.kept.get_or_init(|| self.columns.clone().leak());
            return Format::Chosen(Chosen {
                names,
                page: (word == FormatWord::Table).then_some(page),
            });
        }
        match word {
            FormatWord::Table if self.all => Format::Table(page),
            FormatWord::Table => Format::Table(Page::of_terminal()),
            FormatWord::Json => Format::Json,
            FormatWord::Csv => Format::Csv,
            FormatWord::None => Format::None,
        }
    }
}

impl Chosen {
    /// The places of the columns among these heads.
    ///
    /// # Errors
    /// [`CliError::Column`] if one is not there.
    pub fn places(&self, heads: &[String]) -> Result<Vec<usize>, CliError> {
        let mut places = Vec::new();
        for name in self.names {
            let name = name.trim();
            // A vector stands for its components.
            let is_of = |head: &String| {
                head == name
                    || head.strip_prefix(name).is_some_and(|end| ["_x", "_y", "_z"].contains(&end))
            };
            let found = places.len();
            places.extend((0..heads.len()).filter(|place| is_of(&heads[*place])));
            if found == places.len() {
                let valid: Vec<&str> = heads.iter().map(String::as_str).collect();
                let meant = match renamed(name).filter(|new| valid.contains(new)) {
                    Some(new) => format!(", which is now called `{new}`"),
                    None => likely(name, &valid),
                };
                let columns = heads.join(", ");
                return Err(CliError::Column { name: name.to_owned(), meant, columns });
            }
        }
        Ok(places)
    }
}
