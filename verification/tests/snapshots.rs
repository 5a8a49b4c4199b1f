//! The catalogue is complete: numbers, titles, texts and snapshots belong together; the README counts its entries.

use carom_verification::catalogue::Kind;
use carom_verification::report::{contents, texts};
use carom_verification::{Entry, State, catalogue};
use std::collections::BTreeSet;
use std::path::Path;

#[test]
fn figures_and_snapshots_belong_together() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    let stem = |path: &Path| path.file_stem().unwrap().to_str().unwrap().to_owned();
    let stored: BTreeSet<String> =
        std::fs::read_dir(folder).unwrap().map(|entry| stem(&entry.unwrap().path())).collect();
    let entries = catalogue();
    let done = entries.iter().filter(|entry| entry.is_computed()).map(|entry| entry.id.to_owned());
    assert_eq!(stored, done.collect());
}

#[test]
fn entries_of_a_chapter_stand_together() {
    let entries = catalogue();
    let mut seen = BTreeSet::new();
    let mut last = "";
    for chapter in entries.iter().map(Entry::chapter) {
        assert!(chapter == last || seen.insert(chapter), "chapter {chapter} stands apart");
        last = chapter;
    }
}

#[test]
fn the_readme_counts_as_the_catalogue_does() {
    let entries = catalogue();
    let count = |is: fn(&Entry) -> bool| {
        entries.iter().filter(|entry| entry.is_in_thesis() && is(entry)).count()
    };
    let (all, computed) = (count(|_| true), count(Entry::is_computed));
    let partial = count(|entry| entry.state() == State::Partial);
    let words = match partial {
        0 => format!("{computed} of {all} stand."),
        _ => format!("{computed} of {all} stand, {partial} of them in part"),
    };
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("../README.md");
    assert!(std::fs::read_to_string(readme).unwrap().contains(&words), "{words}");
}

#[test]
fn the_catalogue_is_complete_and_named_once() {
    let entries = catalogue();
    let ids: BTreeSet<_> = entries.iter().map(|entry| entry.id).collect();
    assert_eq!(ids.len(), entries.len());
    let count = |kind| entries.iter().filter(|entry| entry.kind == kind).count();
    assert_eq!((count(Kind::Figure), count(Kind::Table)), (101, 2));
}

#[test]
fn figures_are_numbered_without_gaps() {
    let entries = catalogue();
    let figures = entries.iter().filter(|entry| entry.kind == Kind::Figure);
    let mut last = ("", 0);
    for entry in figures {
        let (chapter, number) = entry.id.split_once('.').unwrap();
        let expected = if chapter == last.0 { last.1 + 1 } else { 1 };
        assert_eq!(number.parse::<u32>().unwrap(), expected, "{}", entry.id);
        last = (chapter, expected);
    }
}

#[test]
fn partial_entries_say_what_is_missing() {
    for entry in catalogue() {
        assert!(entry.lacks.is_none_or(|lacks| !lacks.trim().is_empty()), "{}", entry.id);
        assert!(entry.lacks.is_none() || entry.is_computed(), "{}", entry.id);
    }
}

#[test]
fn every_page_has_a_text_and_every_text_a_page() {
    let ids: Vec<_> = catalogue().iter().map(|entry| entry.id).collect();
    let without: Vec<_> = ids.iter().filter(|id| texts::text(id).is_none()).collect();
    assert!(without.is_empty(), "no text in report/texts.md: {without:?}");
    let strange: Vec<_> = texts::pages().filter(|id| !ids.contains(id)).collect();
    assert!(strange.is_empty(), "no page: {strange:?}");
}

#[test]
fn titles_begin_with_a_capital_and_do_not_repeat_their_group() {
    for entry in catalogue() {
        let (_, group) = contents::group(&entry);
        for text in [entry.title, &group] {
            assert!(!text.starts_with(char::is_lowercase), "{}: {text}", entry.id);
        }
        let before_colon = entry.title.split_once(": ").map_or("", |(before, _)| before);
        let name = entry.chapter().to_lowercase();
        assert_ne!(before_colon.to_lowercase(), name, "{}", entry.id);
    }
}
