//! Every computed figure has a snapshot, and every snapshot a figure.

use carom_verification::{Entry, catalogue};
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
