//! The book: its commands run and draw its pictures, and its case reference agrees with the tables of fields.
//! `cargo xtask generate` writes both.

mod contact_digits;
mod gallery;
#[cfg(unix)]
mod outputs;

use crate::common::{Folder, folder, stdout};
use carom_cases::case::{CaseKind, Entry, Need};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

fn sources() -> PathBuf {
    root().join("docs/book/src")
}

fn is_update() -> bool {
    std::env::var_os("CAROM_GENERATE").is_some()
}

/// The file is this, or is written so when asked for.
pub(crate) fn agrees(path: &Path, text: &[u8]) {
    if is_update() {
        std::fs::write(path, text).unwrap();
    }
    let is_same = std::fs::read(path).is_ok_and(|there| there == text);
    assert!(is_same, "{} is out of date: cargo xtask generate", path.display());
}

/// The chapters with their texts.
fn chapters(folder: &Path) -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(chapters(&path));
        } else if path.extension().is_some_and(|end| end == "md") {
            let text = std::fs::read_to_string(&path).unwrap();
            found.push((path, text));
        }
    }
    found.sort();
    found
}

/// The blocks of a language.
pub(crate) fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let parts = text.split("\n```").skip(1).step_by(2);
    let parts = parts.filter_map(|part| part.split_once('\n'));
    parts.filter(|(head, _)| *head == language).map(|(_, body)| body).collect()
}

/// A folder with the examples, in which commands of a page run.
#[cfg(unix)]
pub(crate) fn shelf() -> Folder {
    let folder = folder();
    std::fs::create_dir_all(folder.join("pictures")).unwrap();
    std::os::unix::fs::symlink(root().join("examples"), folder.join("examples")).unwrap();
    folder
}

/// Runs a block of commands, which warns of nothing but what the page shows, and what it prints.
#[cfg(unix)]
pub(crate) fn run(folder: &Path, block: &str, page: &str) -> String {
    let carom = Path::new(env!("CARGO_BIN_EXE_carom"));
    let path = std::env::var("PATH").unwrap_or_default();
    let path = format!("{}:{path}", carom.parent().unwrap().display());
    let mut shell = Command::new("sh");
    shell.args(["-e", "-c", block]).current_dir(folder).env("PATH", path);
    let output = shell.output().unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{block}: {stderr}");
    for warning in stderr.lines().filter_map(|line| line.strip_prefix("warning: ")) {
        // Up to its first number, which may differ in a digit elsewhere.
        let head = warning.split(|letter: char| letter.is_ascii_digit()).next().unwrap();
        assert!(
            page.contains(head),
            "the page does not show what this warns of: {block}: {warning}"
        );
    }
    String::from_utf8(output.stdout).unwrap()
}

#[test]
#[cfg(unix)]
fn the_commands_of_the_book_run_and_draw_its_pictures() {
    let folder = shelf();
    let mut count = 0;
    for (_, text) in chapters(&sources()) {
        for block in blocks(&text, "sh") {
            run(&folder, block, &text);
            count += block.lines().filter(|line| line.contains("carom ")).count();
        }
    }
    assert!(count >= 15, "{count}");
    let mut pictures: Vec<PathBuf> = std::fs::read_dir(folder.join("pictures"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    pictures.sort();
    for picture in &pictures {
        let bytes = std::fs::read(picture).unwrap();
        agrees(&sources().join("pictures").join(picture.file_name().unwrap()), &bytes);
    }
    let there = std::fs::read_dir(sources().join("pictures")).unwrap().count();
    assert_eq!(there, pictures.len(), "a picture that no command draws");
    let shown = chapters(&sources())
        .iter()
        .map(|(_, text)| text.matches("pictures/").count())
        .sum::<usize>();
    assert!(shown >= 2 * pictures.len(), "a picture that no chapter shows");
}

/// A page for a kind of case: what `carom new` writes, and a table for each table of the case.
fn reference(kind: CaseKind) -> String {
    let name = kind.name;
    let mut page =
        format!("# {name}\n\n{} The command is `carom {name} CASE.toml`.\n", kind.meaning);
    let _ = write!(page, "\n<!-- Made from the tables of fields by `cargo xtask generate`. -->\n");
    let _ = write!(page, "\n```toml\n{}```\n", stdout(&["new", name]));
    let mut tables: Vec<(String, Vec<Entry>)> = Vec::new();
    for entry in kind.entries() {
        let place = entry.path.rsplit_once('.').map_or("", |(table, _)| table).to_owned();
        match tables.iter_mut().find(|(table, _)| *table == place) {
            Some((_, entries)) => entries.push(entry),
            None => tables.push((place, vec![entry])),
        }
    }
    for (table, entries) in tables {
        let title = match table.as_str() {
            "" => "Tables".to_owned(),
            "*" => "In the place of a number".to_owned(),
            table => format!("`{table}`"),
        };
        let _ = write!(
            page,
            "\n## {title}\n\n| field | what | unit | allowed | without it | meaning |\n"
        );
        page += "|---|---|---|---|---|---|\n";
        for entry in entries {
            page += &line(&entry);
        }
    }
    page
}

fn line(entry: &Entry) -> String {
    let cell = |name: &str| {
        let column = Entry::COLUMNS.iter().find(|column| column.name() == name).unwrap();
        let cells =
            carom_table::cells(std::slice::from_ref(column), entry, |number| number.to_string());
        // What would end the cell, and what would be taken for emphasis.
        cells.concat().replace('|', "\\|").replace('*', "\\*").replace('<', "&lt;")
    };
    let name = entry.path.rsplit('.').next().unwrap();
    let without = match entry.field.need {
        Need::Must => "*must* be there".to_owned(),
        Need::Or(others) => format!("*or* {others}"),
        Need::Default(_) => format!("`{}`", entry.field.default_text().unwrap()),
        Need::May(absent) => absent.to_owned(),
    };
    let shapes = match cell("shapes") {
        shapes if shapes.is_empty() => shapes,
        shapes => format!(" (of {})", shapes.replace(' ', ", ")),
    };
    let [kind, unit, allowed, meaning] = ["kind", "unit", "allowed", "meaning"].map(cell);
    format!("| `{name}` | {kind} | {unit} | {allowed} | {without} | {meaning}{shapes} |\n")
}

#[test]
fn the_case_reference_is_what_the_tables_say() {
    for kind in CaseKind::ALL {
        let page = reference(kind);
        // Every field has a line.
        for entry in kind.entries() {
            let name = entry.path.rsplit('.').next().unwrap();
            assert!(page.contains(&format!("| `{name}` |")), "{}", entry.path);
        }
        assert!(!page.contains("; ,"), "{}: an empty unit", kind.name);
        agrees(&sources().join(format!("cases/{}.md", kind.name)), page.as_bytes());
    }
}

#[test]
fn blocks_are_told_by_their_language() {
    let text = "a\n```sh\nb\nc\n```\n\n```rust\nd\n```\n```sh\ne\n```\n";
    assert_eq!(blocks(text, "sh"), ["b\nc", "e"]);
}
