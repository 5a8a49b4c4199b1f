//! Every computed figure has a snapshot, and every snapshot a figure; the README counts them.

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
