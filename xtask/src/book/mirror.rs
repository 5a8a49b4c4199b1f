//! Code on a page that stands in a file of the repository as well: a block below the line `<!-- from FILE:ANCHOR -->`
//! has the lines of that file between `ANCHOR: name` and `ANCHOR_END: name`, or the whole file without an anchor.

use std::path::Path;

/// The page with its copies as the files say, or what is wrong with one of them.
pub(super) fn renewed(root: &Path, text: &str) -> Result<String, String> {
    let mut page = String::with_capacity(text.len());
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        page += line;
        page.push('\n');
        let Some(named) =
            line.strip_prefix("<!-- from ").and_then(|rest| rest.strip_suffix(" -->"))
        else {
            continue;
        };
        let fence = lines.next().filter(|next| next.starts_with("```"));
        let fence = fence.ok_or_else(|| format!("{named}: no block of code follows"))?;
        lines.by_ref().find(|line| *line == "```").ok_or_else(|| format!("{named}: no end"))?;
        page += &format!("{fence}\n{}```\n", part(root, named)?);
    }
    Ok(page)
}

/// The lines of `FILE:ANCHOR`.
fn part(root: &Path, named: &str) -> Result<String, String> {
    let (file, anchor) = named.split_once(':').unwrap_or((named, ""));
    let source = std::fs::read_to_string(root.join(file))
        .map_err(|_| format!("{named}: nothing is there"))?;
    let is_mark = |line: &str, mark: &str| {
        line.split_once(mark)
            .is_some_and(|(_, rest)| rest.split_whitespace().next() == Some(anchor))
    };
    let (mut is_in, mut found) = (anchor.is_empty(), String::new());
    for line in source.lines() {
        if line.contains("ANCHOR: ") || line.contains("ANCHOR_END: ") {
            is_in |= is_mark(line, "ANCHOR: ");
            is_in &= !is_mark(line, "ANCHOR_END: ");
        } else if is_in {
            found += line;
            found.push('\n');
        }
    }
    if found.is_empty() { Err(format!("{named}: no such anchor")) } else { Ok(found) }
}

/// What a reader of the page as it stands does not see or sees too much: directives of mdBook and, in Rust, lines that
/// rustdoc hides.
pub(super) fn hidden(text: &str) -> Vec<String> {
    let (mut language, mut faults) = (None, Vec::new());
    for (i, line) in text.lines().enumerate() {
        if let Some(named) = line.trim_start().strip_prefix("```") {
            language = language.is_none().then_some(named);
        }
        let is_hidden = line == "#" || line.starts_with("# ");
        if line.contains("{{#")
            || is_hidden && language.is_some_and(|word| word.starts_with("rust"))
        {
            faults.push(format!("line {}: a reader of the source sees `{line}`", i + 1));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::root::root;

    const PAGE: &str = "a\n<!-- from crates/capi/examples/impact.c:impact -->\n```c\nold\n```\nb\n";

    #[test]
    fn a_copy_is_renewed() {
        let page = renewed(&root(), PAGE).unwrap();
        assert!(page.starts_with("a\n<!-- from ") && page.ends_with("}\n```\nb\n"), "{page}");
        assert!(page.contains("carom_collide(") && !page.contains("old"), "{page}");
        assert!(!page.contains("ANCHOR"), "{page}");
        assert_eq!(renewed(&root(), &page).unwrap(), page);
    }

    #[test]
    fn what_cannot_be_copied_is_named() {
        for (old, new, fault) in [
            ("impact.c:", "none.c:", "nothing is there"),
            (":impact", ":imp", "no such anchor"),
            ("\n```c", "\n\n```c", "no block of code follows"),
            ("old\n```", "old", "no end"),
        ] {
            let error = renewed(&root(), &PAGE.replacen(old, new, 1)).unwrap_err();
            assert!(error.contains(fault), "{error}");
        }
    }

    #[test]
    fn directives_and_hidden_lines_are_found() {
        let page = "# Head\n```sh\n# said\n```\n```rust\n# use a;\nlet x = 1;\n#\n#[test]\n```\n{{#include a}}\n";
        let faults = hidden(page);
        assert_eq!(faults.len(), 3, "{faults:?}");
        assert!(
            faults[0].starts_with("line 6:") && faults[2].starts_with("line 11:"),
            "{faults:?}"
        );
    }
}
