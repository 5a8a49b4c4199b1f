//! One paragraph per page: what it shows and why it matters.

use std::collections::BTreeMap;
use std::sync::LazyLock;

static TEXTS: LazyLock<BTreeMap<&str, &str>> =
    LazyLock::new(|| parse(include_str!("texts.md")).collect());

/// The paragraph of a page.
#[must_use]
pub(crate) fn text(id: &str) -> Option<&'static str> {
    TEXTS.get(id).copied()
}

/// Headings `## id` with their paragraphs.
fn parse(file: &str) -> impl Iterator<Item = (&str, &str)> {
    let parts = file.split("\n## ").skip(1);
    parts.filter_map(|part| part.split_once('\n')).map(|(id, text)| (id.trim(), text.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::catalogue;
    use crate::report::markup::prose;

    #[test]
    fn every_page_has_a_text_and_every_text_a_page() {
        let ids: Vec<_> = catalogue().iter().map(|entry| entry.id).collect();
        let without: Vec<_> = ids.iter().filter(|id| text(id).is_none()).collect();
        assert!(without.is_empty(), "no text in report/texts.md: {without:?}");
        let strange: Vec<_> = TEXTS.keys().filter(|id| !ids.contains(id)).collect();
        assert!(strange.is_empty(), "no page: {strange:?}");
        let headings = include_str!("texts.md").matches("\n## ").count();
        assert_eq!(headings, TEXTS.len(), "a page has two texts");
    }

    #[test]
    fn a_text_is_one_paragraph_of_some_length() {
        for (id, text) in TEXTS.iter() {
            let words = text.split_whitespace().count();
            assert!((20..=150).contains(&words), "{id}: {words} words");
            assert!(!text.contains("\n\n"), "{id}: two paragraphs");
            let html = prose(text);
            assert!(!html.contains("merror") && !html.contains("class=\"fail\""), "{id}: {html}");
        }
    }

    #[test]
    fn no_two_pages_share_a_text() {
        let mut texts: Vec<_> = TEXTS.values().collect();
        let count = texts.len();
        texts.sort_unstable();
        texts.dedup();
        assert_eq!(texts.len(), count);
    }
}
