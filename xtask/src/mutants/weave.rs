//! A copy of the workspace that contains all mutants, each behind its switch.

use super::list::Mutant;
use super::place::{self, Place, Source};
use anyhow::{Context as _, bail};
use std::collections::BTreeSet;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The folders of the crates with mutants; each gets its own switch.
pub(super) const CRATES: [&str; 13] = [
    "crates/special",
    "crates/geometry",
    "crates/shells",
    "crates/halfspace",
    "crates/laws",
    "crates/solver",
    "crates/classic",
    "crates/rolling",
    "crates/impact",
    "crates/plot",
    "crates/capi",
    "crates/cases",
    "crates/cli",
];

const SWITCH: &str = include_str!("woven/switch.rs");
const PAGES: &str = include_str!("woven/pages.rs");
const PAGES_MANIFEST: &str = include_str!("woven/pages.toml");

/// Updates the copy at `tree` from the workspace at `root` and inserts the mutants. Unchanged files
/// are not written, so that cargo does not rebuild them.
pub(super) fn weave(root: &Path, tree: &Path, mutants: &[Mutant]) -> anyhow::Result<()> {
    let sources = sources(root)?;
    let places = places(mutants, &sources)?;
    let mut copy = Mirror { root, tree, written: BTreeSet::new() };
    for (index, source) in sources.iter().enumerate() {
        copy.write(&source.path, &woven(source, index, mutants, &places))?;
    }
    let count = format!("const COUNT: usize = {};", mutants.len() + 1);
    let switch = SWITCH.replace("const COUNT: usize = 2;", &count);
    for folder in CRATES {
        copy.write(&Path::new(folder).join("src/mutant.rs"), &switch)?;
    }
    let pages = Path::new("crates/mutant-pages");
    copy.write(&pages.join("Cargo.toml"), PAGES_MANIFEST)?;
    copy.write(&pages.join("pages.rs"), PAGES)?;
    copy.write(&pages.join("src/lib.rs"), "")?;
    let manifest = std::fs::read_to_string(root.join("Cargo.toml"))?;
    copy.write(Path::new("Cargo.toml"), &with_other_version(&manifest)?)?;
    copy.rest(Path::new(""))?;
    copy.prune(Path::new(""))
}

/// The manifest with another version. Both workspaces are built into one folder, and with the same
/// version cargo would confuse their results.
fn with_other_version(manifest: &str) -> anyhow::Result<String> {
    let mut lines: Vec<String> = manifest.lines().map(str::to_owned).collect();
    let version = lines.iter_mut().find(|line| line.starts_with("version = \""));
    let version = version.context("the workspace has no version")?;
    *version = format!("{}+mutants\"", version.trim_end().trim_end_matches('"'));
    Ok(lines.join("\n") + "\n")
}

/// Checks that the sources contain every place of the list.
pub(super) fn check(root: &Path, mutants: &[Mutant]) -> anyhow::Result<()> {
    places(mutants, &sources(root)?).map(|_| ())
}

fn sources(root: &Path) -> anyhow::Result<Vec<Source>> {
    let mut sources = Vec::new();
    for folder in CRATES {
        sources.extend(place::sources(root, folder)?);
    }
    Ok(sources)
}

fn places(mutants: &[Mutant], sources: &[Source]) -> anyhow::Result<Vec<Place>> {
    let mut errors = Vec::new();
    let mut places = Vec::new();
    for mutant in mutants {
        match place::find(mutant, sources) {
            Ok(place) => places.push(place),
            Err(error) => errors.push(format!("{}: {error:#}", mutant.key())),
        }
    }
    if !errors.is_empty() {
        bail!("places of the list that are not found:\n  {}", errors.join("\n  "));
    }
    Ok(places)
}

/// The source with its mutants, numbered from 1.
fn woven(source: &Source, index: usize, mutants: &[Mutant], places: &[Place]) -> String {
    let here = places.iter().zip(mutants).enumerate();
    let mut edits: Vec<Edit<'_>> = here
        .filter(|(_, (place, _))| place.source == index)
        .map(|(i, (place, mutant))| Edit {
            range: place.range.clone(),
            number: i + 1,
            replace: &mutant.replace,
        })
        .collect();
    edits.sort_by_key(|edit| (edit.range.start, usize::MAX - edit.range.end, edit.number));
    let text = rewrite(&source.text, 0..source.text.len(), &edits, "crate::mutant");
    if source.path.ends_with("src/lib.rs") {
        return format!("#![allow(warnings)]\n{text}\nmod mutant;\n");
    }
    text
}

/// An expression and its replacement.
struct Edit<'a> {
    range: Range<usize>,
    number: usize,
    replace: &'a str,
}

/// The text of `range` with its edits, in order of position, outer before inner.
fn rewrite(text: &str, range: Range<usize>, edits: &[Edit<'_>], switch: &str) -> String {
    let mut out = String::new();
    let mut at = range.start;
    let mut rest = edits;
    while let Some(first) = rest.first() {
        let outer = &first.range;
        let inside = rest.iter().take_while(|edit| edit.range.end <= outer.end).count();
        let same = rest[..inside].iter().take_while(|edit| edit.range == *outer).count();
        out += &text[at..outer.start];
        out.push('(');
        for edit in &rest[..same] {
            out += &format!("if {switch}::is_on({}) {{ {} }} else ", edit.number, edit.replace);
        }
        let inner = rewrite(text, outer.clone(), &rest[same..inside], switch);
        out += &format!("{{ {inner} }})");
        at = outer.end;
        rest = &rest[inside..];
    }
    out + &text[at..range.end]
}

/// The copy of the workspace.
struct Mirror<'a> {
    root: &'a Path,
    tree: &'a Path,
    written: BTreeSet<PathBuf>,
}

impl Mirror<'_> {
    fn write(&mut self, path: &Path, text: &str) -> anyhow::Result<()> {
        self.write_bytes(path, text.as_bytes())
    }

    /// Writes a file of the copy, unless it exists with the same content.
    fn write_bytes(&mut self, path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
        let target = self.tree.join(path);
        self.written.insert(path.to_owned());
        if std::fs::read(&target).is_ok_and(|old| old == bytes) {
            return Ok(());
        }
        if let Some(folder) = target.parent() {
            std::fs::create_dir_all(folder)?;
        }
        std::fs::write(&target, bytes).with_context(|| format!("cannot write {}", target.display()))
    }

    /// Copies the files not yet written, without build results and history.
    fn rest(&mut self, folder: &Path) -> anyhow::Result<()> {
        for entry in std::fs::read_dir(self.root.join(folder))? {
            let entry = entry?;
            let path = folder.join(entry.file_name());
            let name = entry.file_name();
            if entry.file_type()?.is_dir() {
                if name != "target" && name != ".git" {
                    self.rest(&path)?;
                }
            } else if name != ".git" && !self.written.contains(&path) {
                let bytes = std::fs::read(entry.path())
                    .with_context(|| format!("cannot read {}", entry.path().display()))?;
                self.write_bytes(&path, &bytes)?;
            }
        }
        Ok(())
    }

    /// Removes the files of the copy that the workspace no longer has.
    fn prune(&self, folder: &Path) -> anyhow::Result<()> {
        for entry in std::fs::read_dir(self.tree.join(folder))? {
            let entry = entry?;
            let path = folder.join(entry.file_name());
            if entry.file_type()?.is_dir() {
                self.prune(&path)?;
            } else if !self.written.contains(&path) {
                std::fs::remove_file(entry.path())?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_copy_has_a_version_of_its_own() {
        let manifest =
            "[workspace.package]\nversion = \"0.1.0\"\n[d]\nx = { version = \"0.1.0\" }\n";
        let expected = manifest.replacen("0.1.0", "0.1.0+mutants", 1);
        assert_eq!(with_other_version(manifest).unwrap(), expected);
        assert!(with_other_version("[workspace]\n").is_err());
    }

    #[test]
    fn edits_nest_and_share_a_place() {
        let text = "a * (b + 1)";
        let edit = |range, number, replace| Edit { range, number, replace };
        let edits = [edit(0..11, 3, "c"), edit(0..11, 4, "d"), edit(9..10, 1, "2")];
        assert_eq!(
            rewrite(text, 0..text.len(), &edits, "m"),
            "(if m::is_on(3) { c } else if m::is_on(4) { d } else \
             { a * (b + (if m::is_on(1) { 2 } else { 1 })) })"
        );
    }
}
