//! Selects entries of the catalogue by number, chapter or text.

use crate::catalogue::Entry;
use regex_lite::{Regex, RegexBuilder};
use std::collections::BTreeSet;

/// The entries to verify; all of them if no id and no chapter is given.
#[derive(Debug, Clone, Default)]
pub struct Selection {
    /// Numbers, as `5.3`, `table-13.1` or `Fig. 5.3`.
    pub ids: Vec<String>,
    /// Chapters, as `5`.
    pub chapters: Vec<String>,
    /// Selects only entries whose name or title matches this filter.
    pub filter: Option<Filter>,
    /// Whether slow entries are computed.
    pub slow: Slow,
}

/// What to do with slow entries.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Slow {
    /// Compute them.
    #[default]
    Keep,
    /// Skip them unless requested by number.
    Skip,
}

/// A text or regular expression that is searched in names and titles; lower-case letters match
/// upper case.
#[derive(Debug, Clone)]
pub struct Filter(Regex);

impl Filter {
    /// The filter with this pattern.
    ///
    /// # Errors
    /// If it is not a regular expression.
    pub fn new(pattern: &str) -> Result<Self, regex_lite::Error> {
        RegexBuilder::new(pattern).case_insensitive(true).build().map(Self)
    }

    fn finds(&self, entry: &Entry) -> bool {
        [entry.id, &entry.name(), entry.title].iter().any(|text| self.0.is_match(text))
    }
}

/// A requested id or chapter that is not in the catalogue.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("no {what} `{asked}`; there are: {valid}")]
pub struct UnknownEntry {
    /// `figure or table`, `chapter`, or `name or title`.
    pub what: &'static str,
    /// The requested text.
    pub asked: String,
    /// The valid values.
    pub valid: String,
}

impl Selection {
    /// The selected entries of `catalogue`, in its order.
    ///
    /// # Errors
    /// If an id or chapter is not in it, or the filter matches none of them.
    pub fn of(&self, catalogue: &[Entry]) -> Result<Vec<Entry>, UnknownEntry> {
        for asked in &self.ids {
            if !catalogue.iter().any(|entry| is_named(entry, asked)) {
                return Err(unknown("figure or table", asked, catalogue.iter().map(|e| e.id)));
            }
        }
        for asked in &self.chapters {
            if !catalogue.iter().any(|entry| entry.chapter() == asked) {
                let mut seen = BTreeSet::new();
                let chapters = catalogue.iter().map(Entry::chapter);
                return Err(unknown("chapter", asked, chapters.filter(|c| seen.insert(*c))));
            }
        }
        let taken: Vec<Entry> =
            catalogue.iter().copied().filter(|entry| self.takes(entry)).collect();
        let Some(filter) = &self.filter else { return Ok(taken) };
        let found: Vec<Entry> = taken.iter().copied().filter(|entry| filter.finds(entry)).collect();
        if found.is_empty() {
            return Err(unknown("name or title", filter.0.as_str(), taken.iter().map(|e| e.id)));
        }
        Ok(found)
    }

    fn takes(&self, entry: &Entry) -> bool {
        let is_asked = self.ids.iter().any(|asked| is_named(entry, asked));
        let takes_all = self.ids.is_empty() && self.chapters.is_empty();
        let in_chapter = self.chapters.iter().any(|chapter| chapter == entry.chapter());
        let is_skipped = self.slow == Slow::Skip && entry.is_slow();
        is_asked || ((takes_all || in_chapter) && !is_skipped)
    }
}

/// Whether `asked` is the id, number or name of the entry.
fn is_named(entry: &Entry, asked: &str) -> bool {
    let number = entry.id.strip_prefix("table-").unwrap_or(entry.id);
    asked == entry.id || asked == number || asked.eq_ignore_ascii_case(&entry.name())
}

fn unknown<'a>(
    what: &'static str,
    asked: &str,
    valid: impl Iterator<Item = &'a str>,
) -> UnknownEntry {
    let valid = valid.collect::<Vec<_>>().join(", ");
    UnknownEntry { what, asked: asked.to_owned(), valid }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FigureResult;

    fn draw() -> FigureResult {
        Err("not drawn".into())
    }

    fn chosen(selection: &Selection) -> Result<String, String> {
        let catalogue = [
            Entry::figure("3.1", "Stress of a shift").by(draw),
            Entry::figure("12.1", "Shift and twist").slowly_by(draw),
            Entry::table("table-12.1", ""),
            Entry::figure("12.2", "").by(draw),
        ];
        let entries = selection.of(&catalogue).map_err(|error| error.to_string())?;
        Ok(entries.iter().map(|entry| entry.id).collect::<Vec<_>>().join(" "))
    }

    fn ids(ids: &[&str]) -> Selection {
        Selection { ids: ids.iter().map(|id| (*id).to_owned()).collect(), ..Selection::default() }
    }

    #[test]
    fn all_by_number_and_by_chapter() {
        assert_eq!(chosen(&Selection::default()).unwrap(), "3.1 12.1 table-12.1 12.2");
        assert_eq!(chosen(&ids(&["12.2", "fig. 3.1"])).unwrap(), "3.1 12.2");
        assert_eq!(chosen(&ids(&["table-12.1"])).unwrap(), "table-12.1");
        let chapter = Selection { chapters: vec!["12".to_owned()], ..Selection::default() };
        assert_eq!(chosen(&chapter).unwrap(), "12.1 table-12.1 12.2");
    }

    #[test]
    fn by_words_or_pattern_within_what_is_chosen() {
        let filtered = |filter: &str, selection: Selection| {
            chosen(&Selection { filter: Some(Filter::new(filter).unwrap()), ..selection })
        };
        assert_eq!(filtered("shift", Selection::default()).unwrap(), "3.1 12.1");
        assert_eq!(filtered("^shift|TABLE", Selection::default()).unwrap(), "12.1 table-12.1");
        assert_eq!(filtered("shift", ids(&["12.1", "12.2"])).unwrap(), "12.1");
        insta::assert_snapshot!(filtered("twist", ids(&["3.1"])).unwrap_err(), @"no name or title `twist`; there are: 3.1");
        assert!(Filter::new("(").is_err());
    }

    #[test]
    fn slow_ones_are_left_out_unless_asked_for() {
        let quick = Selection { slow: Slow::Skip, ..Selection::default() };
        assert_eq!(chosen(&quick).unwrap(), "3.1 table-12.1 12.2");
        let asked = Selection { slow: Slow::Skip, ..ids(&["12.1"]) };
        assert_eq!(chosen(&asked).unwrap(), "12.1 table-12.1");
    }

    #[test]
    fn unknown_ones_are_answered_with_what_there_is() {
        insta::assert_snapshot!(chosen(&ids(&["5.3"])).unwrap_err(), @"no figure or table `5.3`; there are: 3.1, 12.1, table-12.1, 12.2");
        let chapter = Selection { chapters: vec!["5".to_owned()], ..Selection::default() };
        insta::assert_snapshot!(chosen(&chapter).unwrap_err(), @"no chapter `5`; there are: 3, 12");
    }
}
