//! The catalogue of tables and figures of the thesis, with the function that computes each.

use crate::figure::Figure;
use std::panic::Location;

/// What a figure's function returns; any error type converts with `?`.
pub type FigureResult = Result<Figure, Failure>;

/// The error of a figure or of a part of it.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// A table or figure of the thesis and the function that computes it, if there is one.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// Number in the thesis, as `5.3` or `table-13.1`.
    pub id: &'static str,
    /// Short title.
    pub title: &'static str,
    /// Figure or table.
    pub kind: Kind,
    /// The function that computes it, if there is one.
    pub source: Source,
    /// What is missing if only a part is computed.
    pub lacks: Option<&'static str>,
    /// Source location of its line in the catalogue.
    pub place: &'static Location<'static>,
}

/// How much of an entry is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// All of it.
    Done,
    /// A part; the entry says what is missing.
    Partial,
    /// None of it.
    Missing,
}

impl State {
    /// The state as a word.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Partial => "partial",
            Self::Missing => "missing",
        }
    }
}

/// Figure or table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A figure.
    Figure,
    /// A table.
    Table,
    /// Not in the thesis: a check of carom itself.
    Check,
}

/// How an entry is computed.
#[derive(Debug, Clone, Copy)]
pub enum Source {
    /// It is not computed yet.
    Missing,
    /// A function that takes well under a second.
    Fast(fn() -> FigureResult),
    /// A function that takes longer; skipped in quick runs.
    Slow(fn() -> FigureResult),
}

impl Entry {
    /// A figure that is not computed yet.
    #[must_use]
    #[track_caller]
    pub const fn figure(id: &'static str, title: &'static str) -> Self {
        Self::new(id, title, Kind::Figure)
    }

    /// A table that is not computed yet.
    #[must_use]
    #[track_caller]
    pub const fn table(id: &'static str, title: &'static str) -> Self {
        Self::new(id, title, Kind::Table)
    }

    /// A check of carom itself, which the thesis does not contain.
    #[must_use]
    #[track_caller]
    pub const fn check(id: &'static str, title: &'static str) -> Self {
        Self::new(id, title, Kind::Check)
    }

    #[track_caller]
    const fn new(id: &'static str, title: &'static str, kind: Kind) -> Self {
        Self { id, title, kind, source: Source::Missing, lacks: None, place: Location::caller() }
    }

    /// Whether it is a table or figure of the thesis.
    #[must_use]
    pub const fn is_in_thesis(&self) -> bool {
        !matches!(self.kind, Kind::Check)
    }

    /// Computed by `function` in well under a second.
    #[must_use]
    pub const fn by(mut self, function: fn() -> FigureResult) -> Self {
        self.source = Source::Fast(function);
        self
    }

    /// Computed by `function`, which takes longer; skipped in quick runs.
    #[must_use]
    pub const fn slowly_by(mut self, function: fn() -> FigureResult) -> Self {
        self.source = Source::Slow(function);
        self
    }

    /// Marks it as computed in part; `lacks` says what is missing. Partial entries are counted
    /// separately.
    #[must_use]
    pub const fn partial(mut self, lacks: &'static str) -> Self {
        self.lacks = Some(lacks);
        self
    }

    /// How much of it is computed.
    #[must_use]
    pub const fn state(&self) -> State {
        match (self.source, self.lacks) {
            (Source::Missing, _) => State::Missing,
            (_, Some(_)) => State::Partial,
            (_, None) => State::Done,
        }
    }

    /// The chapter of its number.
    #[must_use]
    pub fn chapter(&self) -> &'static str {
        let number = self.id.strip_prefix("table-").unwrap_or(self.id);
        number.split_once('.').map_or(number, |(chapter, _)| chapter)
    }

    /// Whether a function computes it, or a part of it.
    #[must_use]
    pub const fn is_computed(&self) -> bool {
        !matches!(self.source, Source::Missing)
    }

    /// Whether it is skipped in quick runs.
    #[must_use]
    pub const fn is_slow(&self) -> bool {
        matches!(self.source, Source::Slow(_))
    }

    /// `fig-5.3` or `table-13.1`: the base name of its files.
    #[must_use]
    pub fn stem(&self) -> String {
        let is_named = self.id.starts_with("table-");
        if is_named { self.id.to_owned() } else { format!("fig-{}", self.id) }
    }

    /// `Fig. 5.3`, `Table 13.1` or `Check accuracy.special`.
    #[must_use]
    pub fn name(&self) -> String {
        match self.kind {
            Kind::Figure => format!("Fig. {}", self.id),
            Kind::Check => format!("Check {}", self.id),
            Kind::Table => {
                format!("Table {}", self.id.strip_prefix("table-").unwrap_or(self.id))
            }
        }
    }

    /// Computes the figure, with id and title set; `None` if no function computes it.
    #[must_use]
    pub fn draw(&self) -> Option<FigureResult> {
        let function = match self.source {
            Source::Missing => return None,
            Source::Fast(function) | Source::Slow(function) => function,
        };
        Some(function().map(|figure| Figure {
            id: self.id.to_owned(),
            title: self.title.to_owned(),
            ..figure
        }))
    }
}

/// All tables and figures of the thesis in order, and the checks of carom itself.
#[cfg(not(test))]
#[must_use]
pub fn catalogue() -> Vec<Entry> {
    crate::figures::CHAPTERS.concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_chapters() {
        let entry = Entry::table("table-13.1", "");
        assert_eq!((entry.name().as_str(), entry.chapter()), ("Table 13.1", "13"));
        let entry = Entry::figure("5.3", "");
        assert_eq!((entry.name().as_str(), entry.chapter()), ("Fig. 5.3", "5"));
        assert!(!entry.is_computed() && entry.draw().is_none());
    }

    #[test]
    fn what_lacks_something_is_partial() {
        let entry = Entry::figure("5.3", "");
        assert_eq!(entry.partial("markers").state(), State::Missing);
        let entry = entry.by(|| Ok(Figure::new()));
        assert_eq!(entry.state(), State::Done);
        assert_eq!(entry.partial("markers").state(), State::Partial);
        assert_eq!(entry.place.line(), line!() - 5);
    }
}
