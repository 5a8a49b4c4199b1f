//! Text as HTML: reserved characters, subscripts, exponents, formulas, and links from equation numbers.

use super::equations;
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// Text with the reserved characters of HTML escaped.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Text as HTML: `F_x` gets its subscript, `N^(1/4)` its exponent, `$\sqrt{a}$` becomes a formula, and the number of an
/// equation, `(7.48)`, links to its line in the index.
pub(crate) fn prose(text: &str) -> String {
    let mut html = String::new();
    for (i, part) in text.split('$').enumerate() {
        if i % 2 == 1 {
            html += &formula(part);
        } else {
            words(&mut html, part);
        }
    }
    html
}

/// A formula in LaTeX's notation, as MathML.
pub(crate) fn formula(latex: &str) -> String {
    mathml(latex, DisplayMode::Inline)
}

/// The same as a displayed formula.
pub(crate) fn formula_of_its_own(latex: &str) -> String {
    mathml(latex, DisplayMode::Block)
}

fn mathml(latex: &str, display_mode: DisplayMode) -> String {
    let storage = Storage::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let mut markup = String::new();
    match push_mathml(&mut markup, Parser::new(latex, &storage), config) {
        // The one character that is not escaped in the markup.
        Ok(()) => markup.replace("<mo><</mo>", "<mo>&lt;</mo>"),
        Err(error) => format!("<code class=\"fail\">{}</code>", escape(&error.to_string())),
    }
}

fn words(html: &mut String, text: &str) {
    let mut rest = text;
    let mut before = ' ';
    while let Some(first) = rest.chars().next() {
        let (markup, length) = subscript(before, rest)
            .or_else(|| exponent(before, rest))
            .or_else(|| reference(rest))
            .unwrap_or_else(|| (escape(&rest[..first.len_utf8()]), first.len_utf8()));
        *html += &markup;
        before = rest[..length].chars().next_back().unwrap_or(' ');
        rest = &rest[length..];
    }
}

/// `F_x` at the start of `text`, if it is a word of its own: its markup and its length.
fn subscript(before: char, text: &str) -> Option<(String, usize)> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let (letter, below) = text.split_once('_')?;
    let mut letters = letter.chars();
    let single = letters.next().filter(|c| c.is_alphabetic() && letters.next().is_none())?;
    let length = below.find(|c: char| !is_part(c)).unwrap_or(below.len());
    let below = &below[..length];
    let is_index = (1..=4).contains(&below.chars().count()) && !below.contains('_');
    let stands_alone = !is_part(before) || before == 'Δ';
    (is_index && stands_alone)
        .then(|| (format!("{single}<sub>{below}</sub>"), letter.len() + 1 + length))
}

/// `^1.5` or `^(1/4)` at the start of `text`, behind what it raises: its markup and its length.
fn exponent(before: char, text: &str) -> Option<(String, usize)> {
    let raised = text.strip_prefix('^').filter(|_| !before.is_whitespace())?;
    let (exponent, length) = match raised.strip_prefix('(') {
        Some(inner) => {
            let end = inner.find(')')?;
            (&inner[..end], end + 2)
        }
        None => {
            let is_part = |c: char| c.is_alphanumeric() || matches!(c, '.' | '-' | '−');
            let end = raised.find(|c| !is_part(c)).unwrap_or(raised.len());
            let exponent = raised[..end].trim_end_matches('.');
            (exponent, exponent.len())
        }
    };
    (!exponent.is_empty()).then(|| (format!("<sup>{}</sup>", escape(exponent)), length + 1))
}

/// An equation number at the start of `text`: its markup and its length.
fn reference(text: &str) -> Option<(String, usize)> {
    let inner = text.strip_prefix('(')?;
    let number = &inner[..inner.find(')').filter(|end| *end <= 7)?];
    let line = equations::line_of(number)?;
    Some((format!("<a href=\"#eq-{line}\">({number})</a>"), number.len() + 2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_letters_get_subscripts_and_names_do_not() {
        assert_eq!(prose("-F_x/c_max < 1"), "-F<sub>x</sub>/c<sub>max</sub> &lt; 1");
        for same in ["with_normal", "a_b_c", "x_", "snake_c", "f_something"] {
            assert_eq!(prose(same), same);
        }
        assert_eq!(prose("v_t'/v_t"), "v<sub>t</sub>'/v<sub>t</sub>");
    }

    #[test]
    fn exponents_are_raised() {
        assert_eq!(prose("R^(4/3)/1000"), "R<sup>4/3</sup>/1000");
        assert_eq!(prose("(1 - X)^1.5 and x^2."), "(1 - X)<sup>1.5</sup> and x<sup>2</sup>.");
        assert_eq!(prose("a ^ b, ∫_ρ^a"), "a ^ b, ∫_ρ<sup>a</sup>");
    }

    #[test]
    fn formulas_are_set() {
        let html = prose(r"the radius $a=\sqrt{R\zeta}$ grows");
        assert!(html.starts_with("the radius <math") && html.ends_with("</math> grows"), "{html}");
        assert!(html.contains("<msqrt>") && html.contains('ζ'), "{html}");
        assert!(formula("a<b").contains("<mo>&lt;</mo>") && !formula("a<b").contains("<<"));
        assert!(
            formula(r"\frac{1").contains("class=\"fail\"")
                || formula(r"\frac{1").contains("merror")
        );
    }

    #[test]
    fn numbers_of_equations_are_links() {
        let html = prose("by (7.54), not (99.1) or (0.5)");
        assert_eq!(html, "by <a href=\"#eq-7.54\">(7.54)</a>, not (99.1) or (0.5)");
    }
}
