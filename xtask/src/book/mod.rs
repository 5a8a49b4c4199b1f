//! The book in `docs/book`: checks its links and builds its pages.

mod links;
mod look;
mod mirror;

use crate::browse;
use crate::cargo;
use crate::files::files_below;
use crate::generate::Mode;
use crate::outcome::{Outcome, Part};
use crate::root::root;
use crate::tools::MDBOOK;
use anyhow::ensure;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

const SOURCES: &str = "docs/book/src";
/// The variable with the program that mdBook calls for the formulas, in place of the one in `book.toml`, for which
/// cargo would compile the dependencies again with fewer features.
const FORMULAS: &str = "MDBOOK_PREPROCESSOR__FORMULAS__COMMAND";

/// Checks the book, builds its pages in target/book/ by mdBook, which it installs if it is missing, and looks at them in a
/// browser.
pub(crate) fn run() -> anyhow::Result<Outcome> {
    check(&root())?;
    let mut mdbook = match MDBOOK.brought() {
        Ok(mdbook) => mdbook,
        Err(error) => {
            let reason = format!("{error:#}; {}", MDBOOK.advice());
            return Ok(Outcome::skipped(Part::BookPages, reason));
        }
    };
    mdbook.arg("build").env(FORMULAS, cargo::built("--bin", "carom-formulas")?);
    let status = mdbook.current_dir(root().join("docs/book")).status()?;
    ensure!(status.success(), "`mdbook build` failed ({status})");
    let page = std::fs::read_to_string(root().join("target/book/theory/impact.html"))?;
    ensure!(page.contains("<math"), "target/book/theory/impact.html contains no formula");
    let is_index = |name: &std::ffi::OsStr| name.to_string_lossy().starts_with("searchindex");
    let mut files = std::fs::read_dir(root().join("target/book"))?;
    let has_search = files.any(|file| file.is_ok_and(|file| is_index(&file.file_name())));
    ensure!(has_search, "target/book has no index for the search: mdbook without `search`?");
    let place = root().join("target/book/index.html");
    println!("the book, with search: open {}", place.display());
    let sources = root().join(SOURCES).canonicalize()?;
    let mut pages = Vec::new();
    for chapter in files_below(&sources, "md")?.iter().filter(|path| !path.ends_with("SUMMARY.md"))
    {
        let page = chapter.strip_prefix(&sources)?.with_extension("html");
        pages.push(page.to_string_lossy().into_owned());
    }
    if look::run(&root().join("target/book").canonicalize()?, &pages)? {
        Ok(Outcome::Passed)
    } else {
        Ok(Outcome::skipped(Part::Browser, browse::none()))
    }
}

/// Checks that all chapters are in the table of contents, and that all links of the book and of
/// other Markdown pages have a target, and that a reader sees the pages as they stand.
pub(crate) fn check(root: &Path) -> anyhow::Result<()> {
    let sources = root.join(SOURCES);
    let chapters = chapters(root)?;
    let mut faults = Vec::new();
    let summary = sources.join("SUMMARY.md");
    let contents: BTreeSet<PathBuf> = links::of(&std::fs::read_to_string(&summary)?)
        .into_iter()
        .map(|link| sources.join(link.target))
        .collect();
    for chapter in chapters.iter().filter(|chapter| **chapter != summary) {
        if !contents.contains(chapter) {
            faults.push(format!("{}: not in SUMMARY.md", chapter.display()));
        }
    }
    let mut count = 0;
    for path in chapters.iter().cloned().chain(beside(root)?) {
        let text = std::fs::read_to_string(&path)?;
        let found = links::of(&text);
        count += found.len();
        let below = chapters.contains(&path).then_some(sources.as_path());
        faults.extend(found.iter().filter_map(|link| links::fault(&path, link, below)));
        let told = |fault: String| format!("{}: {fault}", path.display());
        faults.extend(mirror::hidden(&text).into_iter().map(told));
        match mirror::renewed(root, &text) {
            Ok(page) if page == text => {}
            Ok(_) => faults.push(told("a copy is not current: cargo xtask generate".to_owned())),
            Err(fault) => faults.push(told(fault)),
        }
    }
    ensure!(faults.is_empty(), "{} faults in the book:\n  {}", faults.len(), faults.join("\n  "));
    println!("{} chapters, {count} links: in order", chapters.len());
    Ok(())
}

/// The chapters, including the table of contents.
pub(crate) fn chapters(root: &Path) -> anyhow::Result<Vec<PathBuf>> {
    files_below(&root.join(SOURCES), "md")
}

/// Writes the copies of sources on all pages, or compares them.
pub(crate) fn copies(mode: Mode) -> anyhow::Result<Outcome> {
    let root = root();
    if mode == Mode::Write {
        for path in chapters(&root)?.into_iter().chain(beside(&root)?) {
            let text = std::fs::read_to_string(&path)?;
            let page = mirror::renewed(&root, &text).map_err(anyhow::Error::msg)?;
            if page != text {
                std::fs::write(&path, page)?;
            }
        }
    }
    check(&root).map(|()| Outcome::Passed)
}

/// Markdown pages outside the book, but for those in folders that are built or hidden.
fn beside(root: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let mut pages = Vec::new();
    for entry in std::fs::read_dir(root)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && !name.starts_with('.') && name != "target" {
            pages.extend(files_below(&path, "md")?);
        } else if path.extension().is_some_and(|end| end == "md") {
            pages.push(path);
        }
    }
    let is_page = |path: &PathBuf| {
        !path.starts_with(root.join(SOURCES)) && !path.ends_with("report/texts.md")
    };
    pages.retain(is_page);
    pages.sort();
    Ok(pages)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_book_is_in_order() {
        check(&root()).unwrap();
    }
}
