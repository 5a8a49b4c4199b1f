//! One paragraph per page: what it shows and why it matters.

use std::collections::BTreeMap;
use std::sync::LazyLock;

static TEXTS: LazyLock<BTreeMap<&str, &str>> =
    LazyLock::new(|| parse(include_str!("texts.md")).collect());

/// The paragraph of a page.
#[must_use]
pub fn text(id: &str) -> Option<&'static str> {
    TEXTS.get(id).copied()
}

/// The pages that have a paragraph, in the order of their names.
pub fn pages() -> impl Iterator<Item = &'static str> {
    TEXTS.keys().copied()
}

/// Headings `## id` with their paragraphs.
fn parse(file: &str) -> impl Iterator<Item = (&str, &str)> {
    let parts = file.split("\n## ").skip(1);
    parts.filter_map(|part| part.split_once('\n')).map(|(id, text)| (id.trim(), text.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::markup::prose;

    #[test]
    fn no_page_has_two_texts() {
        let headings = include_str!("texts.md").matches("\n## ").count();
        assert_eq!(headings, TEXTS.len());
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
