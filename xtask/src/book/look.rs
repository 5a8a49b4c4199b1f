//! Looks at the pages of the book in a browser: narrow with a light theme, wide with a dark one.

use crate::browse::{answer, browser};
use anyhow::{Context as _, ensure};
use std::path::Path;

const LOOK: &str = include_str!("look.js");
/// Widths of a phone and of a desktop screen, in pixels, and themes. What is cut depends on the width alone, what is pale
/// on the theme alone: not every pair is looked at.
const VIEWS: [(u32, &str); 2] = [(400, "light"), (1400, "navy")];
/// The pages are files, and each is given time to settle.
const FILES: [&str; 2] = ["--allow-file-access-from-files", "--virtual-time-budget=20000"];

/// Looks at these pages of the built book; `false` without a browser.
///
/// # Errors
/// With the faults that were found.
pub(super) fn run(book: &Path, pages: &[String]) -> anyhow::Result<bool> {
    let Some(browser) = browser() else { return Ok(false) };
    let outer = book.join("look.html");
    let mut faults = Vec::new();
    for (width, theme) in VIEWS {
        let asked = serde_json::json!({ "pages": pages, "width": width, "theme": theme });
        let page = format!(
            "<!DOCTYPE html><body><pre id=\"seen\" hidden></pre>\
             <script>const asked = {asked};\n{LOOK}</script></body>"
        );
        std::fs::write(&outer, page)?;
        let seen =
            answer(&browser, &outer, width, &FILES).with_context(|| format!("{width}-{theme}"));
        std::fs::remove_file(&outer)?;
        let seen = seen?;
        println!("{width}-{theme}: {} pages, {} drawings", seen["pages"], seen["drawings"]);
        let of_this = seen["faults"].as_array().map_or(&[][..], Vec::as_slice);
        faults.extend(of_this.iter().map(|fault| format!("{width}-{theme}: {fault}")));
    }
    ensure!(faults.is_empty(), "{} faults in the book:\n  {}", faults.len(), faults.join("\n  "));
    Ok(true)
}
