//! Checks that the index of equations, `verification/equations.toml`, and the list of mutants,
//! `xtask/mutants.toml`, fit the code, that lock files outside the workspace fit its crates, that the scripts in `findings/`
//! have their form, and that the descriptions of the packages are complete.
//!
//! Each item in the index must exist, and a test, an example or a page must reach it. If its
//! comments quote equations, one of them must be an equation that the index assigns to it.

mod calls;
mod findings;
mod index;
mod items;
mod locks;
mod names;
mod quoted;

use crate::files::files_below;
use crate::root::root;
use crate::{book, mutants, release};
use anyhow::{Context as _, bail};
use calls::Reached;
use index::Index;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// A number in the thesis: chapter and number within the chapter.
type Number = (u32, u32);

/// Prints all faults; fails if there are any.
pub(crate) fn run() -> anyhow::Result<()> {
    let root = root();
    let index = Index::read(&root.join("verification/equations.toml"))?;
    let mut faults = index.gaps();
    let reached = Reached::read(&root)?;
    for (item, lines) in index.by_item() {
        let names = lines.iter().map(|line| line.name.as_str()).collect::<Vec<_>>().join(", ");
        match items::quotes(&root, item)? {
            Err(fault) => faults.push(format!("({names}): {fault}")),
            Ok(quotes) => {
                let fits = |number: &Number| lines.iter().any(|line| line.has(*number));
                if !quotes.is_empty() && !quotes.iter().any(fits) {
                    let quotes =
                        quotes.iter().map(|(chapter, place)| format!("({chapter}.{place})"));
                    let quotes = quotes.collect::<Vec<_>>().join(", ");
                    faults.push(format!("({names}): the comments of `{item}` quote {quotes} only"));
                }
                let name = item.split_once("::").map_or(item, |(_, name)| name);
                if !reached.has(name) {
                    faults.push(format!("({names}): no test, example or page reaches `{item}`"));
                }
            }
        }
    }
    faults.extend(findings::faults(&root)?);
    faults.extend(names::faults(&root)?);
    let figures = figures(&root)?;
    faults.extend(index.figure_gaps(&figures));
    for path in rust_files(&root, &["src"])? {
        let folder = path.with_extension("");
        if root.join(&folder).is_dir() {
            let (path, folder) = (path.display(), folder.display());
            faults.push(format!("{path}: a module with parts is written {folder}/mod.rs"));
        }
        let text = read(&root.join(&path))?;
        for quote in quoted::in_comments(&text) {
            let is_known = match quote.kind {
                quoted::Kind::Equation => index.has(quote.number),
                quoted::Kind::Figure => figures.contains(&quote.number),
            };
            if !is_known {
                let (path, line) = (path.display(), quote.line);
                faults.push(format!("{path}:{line}: the thesis has no {}", quote.text));
            }
        }
    }
    for path in book::chapters(&root)? {
        for quote in quoted::in_prose(&read(&path)?) {
            if !index.has(quote.number) {
                let (path, line) = (path.display(), quote.line);
                faults.push(format!("{path}:{line}: the thesis has no {}", quote.text));
            }
        }
    }
    faults.extend(locks::faults(&root)?);
    if faults.is_empty() {
        println!("{} equations and {} figures: in order", index.count(), figures.len());
        release::whole()?;
        book::check(&root)?;
        return mutants::check(&root);
    }
    bail!(
        "{} faults in the index of equations, lock files and findings:\n  {}",
        faults.len(),
        faults.join("\n  ")
    )
}

fn read(path: &Path) -> anyhow::Result<String> {
    std::fs::read_to_string(path).with_context(|| format!("cannot read {}", path.display()))
}

/// The Rust files in these folders of all crates and of the verification, below `root`.
fn rust_files(root: &Path, folders: &[&str]) -> anyhow::Result<Vec<PathBuf>> {
    let (mut packages, mut files) = (vec![root.join("verification")], Vec::new());
    for entry in std::fs::read_dir(root.join("crates"))? {
        packages.push(entry?.path());
    }
    for package in packages {
        for folder in folders.iter().map(|name| package.join(name)).filter(|path| path.is_dir()) {
            files.extend(files_below(&folder, "rs")?);
        }
    }
    files.iter().map(|path| Ok(path.strip_prefix(root)?.to_owned())).collect()
}

/// The figures in the catalogue.
fn figures(root: &Path) -> anyhow::Result<BTreeSet<Number>> {
    let mut figures = BTreeSet::new();
    for path in rust_files(root, &["src"])? {
        if !path.starts_with("verification/src/figures") {
            continue;
        }
        let text = read(&root.join(&path))?;
        let names = text.split("Entry::figure(\"").skip(1);
        let names = names.filter_map(|rest| rest.split('"').next());
        figures.extend(names.filter_map(quoted::number));
    }
    Ok(figures)
}
