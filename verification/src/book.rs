//! Formulas of the book in `docs/book`, converted to MathML.

use crate::report::markup::{escape, formula, formula_of_its_own};
use serde_json::Value;

/// A formula that cannot be converted.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("cannot convert the formula ${formula}$: {reason}")]
pub struct FormulaError {
    /// The formula in LaTeX.
    pub formula: String,
    /// The reason.
    pub reason: String,
}

/// Converts the formulas of Markdown, `$a$` and `$$a$$`, to MathML; code does not change.
///
/// ```
/// use carom_verification::book::set_formulas;
/// let set = set_formulas("the root $\\sqrt{a}$, and `$HOME`")?;
/// assert!(set.contains("<msqrt>") && set.contains("`$HOME`"));
/// # Ok::<(), carom_verification::book::FormulaError>(())
/// ```
///
/// # Errors
/// [`FormulaError`] for a formula that is not LaTeX or has no end.
pub fn set_formulas(markdown: &str) -> Result<String, FormulaError> {
    let mut set = String::new();
    let mut rest = markdown;
    while let Some(start) = rest.find(['$', '`']) {
        let (before, from) = rest.split_at(start);
        set += before;
        let sign = &from[..1];
        let count = from.len() - from.trim_start_matches(sign).len();
        let mark = &from[..count];
        let inner = &from[count..];
        let Some(end) = inner.find(mark) else {
            let formula = inner.chars().take(40).collect();
            return match sign {
                "$" => Err(FormulaError { formula, reason: format!("no {mark} at its end") }),
                _ => Ok(set + from),
            };
        };
        let content = &inner[..end];
        match mark {
            "$" => {
                let markup = quiet(&checked(content, formula(content))?);
                let after = &inner[end + count..];
                rest = after.trim_start_matches(CLOSING);
                append(&mut set, &markup, &after[..after.len() - rest.len()]);
                continue;
            }
            "$$" => {
                let markup = checked(content, formula_of_its_own(content))?;
                set += &format!("<div class=\"formula\">{}</div>", quiet(&markup));
            }
            _ => set += &from[..2 * count + end],
        }
        rest = &inner[end + count..];
    }
    Ok(set + rest)
}

/// Converts the formulas of all chapters of a book in mdBook's JSON: in each `content`, at any
/// depth.
///
/// # Errors
/// As [`set_formulas`].
pub fn set_in_chapters(book: &mut Value) -> Result<(), FormulaError> {
    match book {
        Value::Array(items) => items.iter_mut().try_for_each(set_in_chapters),
        Value::Object(fields) => {
            if let Some(Value::String(content)) = fields.get_mut("content") {
                *content = set_formulas(content)?;
            }
            fields.values_mut().try_for_each(set_in_chapters)
        }
        _ => Ok(()),
    }
}

/// Characters that must not begin a line.
const CLOSING: [char; 6] = [')', ',', '.', ';', ':', '?'];

/// Appends a formula in a line. Browsers would break the line between it and adjacent brackets and
/// commas.
fn append(set: &mut String, markup: &str, closing: &str) {
    let start = set.trim_end_matches('(').len();
    let opening = set.split_off(start);
    *set += &match opening.is_empty() && closing.is_empty() {
        true => markup.to_owned(),
        false => format!("<span class=\"word\">{opening}{markup}{closing}</span>"),
    };
}

fn checked(content: &str, markup: String) -> Result<String, FormulaError> {
    let failed = markup.contains("class=\"fail\"") || markup.contains("merror");
    match failed || content.trim().is_empty() {
        false => Ok(markup),
        true => Err(FormulaError { formula: content.to_owned(), reason: escape(&markup) }),
    }
}

/// The markup on one line, with characters escaped that Markdown would interpret.
fn quiet(markup: &str) -> String {
    markup.replace('\n', " ").replace('*', "&#42;").replace('_', "&#95;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::{Path, PathBuf};

    #[test]
    fn code_stays_and_formulas_are_set() {
        let set = set_formulas("a $x_1$ b\n\n$$ y^* = \\tfrac12 $$\n\n```sh\necho $HOME $$\n```\n")
            .unwrap();
        assert_eq!(set.matches("<math").count(), 2, "{set}");
        assert!(set.contains("echo $HOME $$") && set.contains("<div class=\"formula\">"));
        assert!(!set.split("</div>").next().unwrap().contains('*'), "{set}");
        assert_eq!(set_formulas("no formula").unwrap(), "no formula");
    }

    /// Otherwise a line may end with the opening bracket or begin with the comma.
    #[test]
    fn brackets_and_commas_stay_with_their_formula() {
        let set = set_formulas("on ($R_x = 1$), or $x$.\n- $y$ is").unwrap();
        assert_eq!(set.matches("<span class=\"word\">").count(), 2, "{set}");
        assert!(set.starts_with("on <span class=\"word\">(<math"), "{set}");
        assert!(set.contains("</math>),</span> or <span class=\"word\"><math"), "{set}");
        assert!(set.contains("</math>.</span>\n- <math") && set.ends_with("</math> is"), "{set}");
    }

    #[test]
    fn bad_formulas_are_named() {
        assert_eq!(set_formulas("a $x").unwrap_err().formula, "x");
        assert_eq!(set_formulas("a $\\nothing{x}$").unwrap_err().formula, "\\nothing{x}");
    }

    #[test]
    fn chapters_within_chapters_are_set() {
        let chapter = |content: &str, below: Value| serde_json::json!({ "Chapter": { "name": "a $b$", "content": content, "sub_items": below } });
        let below = chapter("$y$", Value::Array(Vec::new()));
        let top = chapter("$x$", serde_json::json!([below, "Separator"]));
        let mut book = serde_json::json!({ "items": [top, { "PartTitle": "$z$" }] });
        set_in_chapters(&mut book).unwrap();
        let text = book.to_string();
        assert_eq!(text.matches("<math").count(), 2, "{text}");
        assert!(text.contains("a $b$") && text.contains("$z$"));
        assert!(set_in_chapters(&mut chapter("$", Value::Null)).is_err());
    }

    fn chapters(folder: &Path) -> Vec<PathBuf> {
        let mut found = Vec::new();
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => found.extend(chapters(&path)),
                false => {
                    found.extend(path.extension().is_some_and(|end| end == "md").then_some(path))
                }
            }
        }
        found
    }

    #[test]
    fn every_formula_of_the_book_can_be_set() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/book/src");
        let mut count = 0;
        for path in chapters(&folder) {
            let set = set_formulas(&std::fs::read_to_string(&path).unwrap());
            let set = set.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            count += set.matches("<math").count();
        }
        assert!(count > 50, "{count}");
    }
}
