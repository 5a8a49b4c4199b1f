//! The format of the results: the words of the command line and what they mean for a command.

use crate::page::Page;

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
    /// No results: only the picture and the warnings.
    None,
}

impl Format {
    /// Whether this is a table to read.
    #[must_use]
    pub const fn is_table(self) -> bool {
        matches!(self, Self::Table(_))
    }
}

/// Options of every command that prints results.
#[derive(Debug, Clone, Copy, Default, clap::Args)]
pub struct Printing {
    /// Format of the results [default: table, or none if a picture is drawn]
    #[arg(long, value_enum)]
    format: Option<FormatWord>,
    /// Show all columns of a table, also those that are the same in every row.
    #[arg(long)]
    all: bool,
}

impl Printing {
    /// The format for a command without a picture.
    #[must_use]
    pub fn format(self) -> Format {
        self.or(FormatWord::Table)
    }

    /// The format for a command that draws a picture: only the picture, unless a format is given.
    #[must_use]
    pub fn format_beside_picture(self) -> Format {
        self.or(FormatWord::None)
    }

    fn or(self, default: FormatWord) -> Format {
        match self.format.unwrap_or(default) {
            FormatWord::Table if self.all => Format::Table(Page::of_terminal().whole()),
            FormatWord::Table => Format::Table(Page::of_terminal()),
            FormatWord::Json => Format::Json,
            FormatWord::Csv => Format::Csv,
            FormatWord::None => Format::None,
        }
    }
}
