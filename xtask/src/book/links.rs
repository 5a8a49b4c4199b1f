//! Links of Markdown.

use std::path::Path;

/// `[words](target)` or `![words](target)`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Link {
    /// From 1.
    pub(super) line: usize,
    pub(super) target: String,
}

/// The links of a text, except those in code.
pub(super) fn of(text: &str) -> Vec<Link> {
    let mut links = Vec::new();
    for (line, prose) in prose(text) {
        for rest in prose.split("](").skip(1) {
            if let Some((target, _)) = rest.split_once(')') {
                links.push(Link { line, target: target.to_owned() });
            }
        }
    }
    links
}

/// Lines outside code blocks, without the text between backticks.
fn prose(text: &str) -> Vec<(usize, String)> {
    let mut is_code = false;
    let mut lines = Vec::new();
    for (i, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        } else if !is_code {
            let parts = line.split('`').step_by(2);
            lines.push((i + 1, parts.collect::<Vec<_>>().join("`")));
        }
    }
    lines
}

/// The fault of a link on the page at `path`, if there is one. Links to other hosts are not
/// checked. Links of the book must stay `below` its sources.
pub(super) fn fault(path: &Path, link: &Link, below: Option<&Path>) -> Option<String> {
    if ["http://", "https://", "mailto:"].iter().any(|start| link.target.starts_with(start)) {
        return None;
    }
    let fault_of =
        |what: &str| Some(format!("{}:{}: {}: {what}", path.display(), link.line, link.target));
    let (file, anchor) = link.target.split_once('#').unwrap_or((&link.target, ""));
    let target = match file {
        "" => path.to_owned(),
        file => path.parent().unwrap_or(Path::new("")).join(file),
    };
    let Ok(target) = target.canonicalize() else { return fault_of("nothing is there") };
    let is_inside =
        |below: &Path| below.canonicalize().is_ok_and(|below| target.starts_with(below));
    if below.is_some_and(|below| !is_inside(below)) {
        return fault_of("leads out of the book");
    }
    if anchor.is_empty() {
        return None;
    }
    let text = std::fs::read_to_string(&target).unwrap_or_default();
    if anchors(&text).iter().any(|there| there == anchor) {
        None
    } else {
        fault_of("no such heading")
    }
}

/// The anchors of the headings of a text.
fn anchors(text: &str) -> Vec<String> {
    let mut is_code = false;
    let mut anchors = Vec::new();
    for line in text.lines() {
        is_code ^= line.trim_start().starts_with("```");
        let heading = line.trim_start_matches('#');
        if !is_code && heading.len() < line.len() && heading.starts_with(' ') {
            let letters = heading.trim().chars().filter_map(|c| match c {
                ' ' => Some('-'),
                c if c.is_alphanumeric() || c == '_' || c == '-' => Some(c.to_ascii_lowercase()),
                _ => None,
            });
            anchors.push(letters.collect());
        }
    }
    anchors
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_are_found_outside_of_code() {
        let text = "[a](b.md) and ![c](d/e.svg)\n```rust\nlet x = [f](g);\n```\n`[h](i)` [j](#k)\n";
        let found = of(text);
        let found: Vec<_> = found.iter().map(|link| (link.line, link.target.as_str())).collect();
        assert_eq!(found, [(1, "b.md"), (1, "d/e.svg"), (5, "#k")]);
    }

    #[test]
    fn headings_make_anchors() {
        let text = "# In C, C++ and Fortran\n## `a_b` (5.1)\n```\n# no heading\n```\n#none\n";
        assert_eq!(anchors(text), ["in-c-c-and-fortran", "a_b-51"]);
    }

    #[test]
    fn what_is_not_there_is_told() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let page = root.join("docs/book/src/introduction.md");
        let fault = |target: &str, below: bool| {
            let below = below.then(|| root.join("docs/book/src"));
            fault(&page, &Link { line: 1, target: target.to_owned() }, below.as_deref())
        };
        for good in ["others.md", "theory/impact.md#impact", "#what-carom-is", "https://a.b/c"] {
            assert_eq!(fault(good, true), None, "{good}");
        }
        assert!(fault("nothing.md", true).unwrap().contains("nothing is there"));
        assert!(fault("others.md#nothing", true).unwrap().contains("no such heading"));
        assert!(fault("../../../README.md", true).unwrap().contains("leads out of the book"));
        assert_eq!(fault("../../../README.md", false), None);
    }
}
