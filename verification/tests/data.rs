//! Reference data say where they come from, how exact they are and when they were made.

use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The files with this ending in the folders below `folder`.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|found| found == ending) {
            found.push(path);
        }
    }
    found
}

/// Whether a head says so much, and names no generator that is not there.
fn is_stated([generator, accuracy, date]: [&str; 3]) -> bool {
    let script = |word: &&str| Path::new(word).extension().is_some_and(|end| end == "py");
    let folder = root().join("verification/reference");
    let is_there = |word: &str| {
        let name = Path::new(word).file_name().unwrap();
        folder.join(name).is_file()
    };
    let words = generator.split([' ', ';', ':', ',']);
    let is_date = date.len() == 10 && date.split('-').all(|part| part.parse::<u32>().is_ok());
    generator.len() > 20 && accuracy.len() > 5 && is_date && words.filter(script).all(is_there)
}

#[test]
fn tables_say_generator_accuracy_and_date() {
    let tables = files(&root().join("verification/data"), "csv");
    assert!(tables.len() > 30);
    for path in tables {
        let text = std::fs::read_to_string(&path).unwrap();
        let mut lines = text.lines();
        let head = ["generator", "accuracy", "date"].map(|name| {
            let line = lines.next().unwrap_or_default();
            line.strip_prefix(&format!("# {name}: ")).unwrap_or_default()
        });
        assert!(is_stated(head), "{}: {head:?}", path.display());
    }
}

#[test]
fn data_of_the_floors_say_generator_accuracy_and_date() {
    let crates = std::fs::read_dir(root().join("crates")).unwrap();
    let folders = crates.map(|entry| entry.unwrap().path().join("tests/data"));
    let tables: Vec<_> = folders
        .filter(|folder| folder.is_dir())
        .flat_map(|folder| files(&folder, "json"))
        .collect();
    assert!(tables.len() > 8);
    for path in tables {
        let text = std::fs::read_to_string(&path).unwrap();
        let value: serde_json::Value = serde_json::from_str(&text).unwrap();
        let head = ["generator", "accuracy", "date"].map(|name| value[name].as_str().unwrap_or(""));
        assert!(is_stated(head), "{}: {head:?}", path.display());
    }
}
