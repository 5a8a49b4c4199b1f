//! The equations and figures quoted in comments.

use super::Number;

/// Kind of a quotation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// `(7.48)`
    Equation,
    /// `fig. 7.12`
    Figure,
}

/// One quotation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Quote {
    pub(super) kind: Kind,
    pub(super) number: Number,
    /// The line, from 1.
    pub(super) line: usize,
    /// As written.
    pub(super) text: String,
}

/// `7.65a` as (7, 65), if it can be a number of the thesis: chapter 3 to 15, without leading zero.
pub(super) fn number(text: &str) -> Option<Number> {
    let (chapter, rest) = text.split_once('.')?;
    let place = rest.strip_suffix(|c: char| ('a'..='h').contains(&c)).unwrap_or(rest);
    let digits = |text: &str| -> Option<u32> {
        let is_plain = text.bytes().all(|byte| byte.is_ascii_digit()) && !text.starts_with('0');
        text.parse().ok().filter(|_| is_plain && text.len() <= 2)
    };
    let (chapter, place) = (digits(chapter)?, digits(place)?);
    (3..=15).contains(&chapter).then_some((chapter, place))
}

/// The quotations in the comments of a source.
pub(super) fn in_comments(source: &str) -> Vec<Quote> {
    let mut quotes = Vec::new();
    let mut is_code = false; // of an example in the documentation
    for (i, line) in source.lines().enumerate() {
        let Some((_, comment)) = line.split_once("//") else { continue };
        if comment.trim_start_matches(['/', '!', ' ']).starts_with("```") {
            is_code = !is_code;
        }
        if is_code {
            continue;
        }
        let line = i + 1;
        quotes.extend(equations(comment, line));
        for word in ["fig. ", "figs. ", "Fig. ", "Figs. ", "figure ", "figures "] {
            for rest in comment.split(word).skip(1) {
                let end = rest.find(|c: char| !(c.is_ascii_digit() || c == '.'));
                let name = rest[..end.unwrap_or(rest.len())].trim_end_matches('.');
                if let Some(number) = number(name) {
                    quotes.push(Quote {
                        kind: Kind::Figure,
                        number,
                        line,
                        text: format!("figure {name}"),
                    });
                }
            }
        }
    }
    quotes
}

/// The equations quoted in a text.
pub(super) fn in_prose(text: &str) -> Vec<Quote> {
    let line = |(i, line): (usize, &str)| equations(line, i + 1).collect::<Vec<_>>();
    text.lines().enumerate().flat_map(line).collect()
}

fn equations(text: &str, line: usize) -> impl Iterator<Item = Quote> {
    text.split('(').skip(1).filter_map(move |rest| {
        let (inner, _) = rest.split_once(')')?;
        let number = number(inner)?;
        Some(Quote { kind: Kind::Equation, number, line, text: format!("({inner})") })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_the_thesis_and_others() {
        assert_eq!(number("7.65a"), Some((7, 65)));
        assert_eq!(number("15.9"), Some((15, 9)));
        for other in ["7", "0.5", "2.5", "16.1", "3.05", "3.141", "7.x", "", "7.65ab"] {
            assert_eq!(number(other), None, "{other}");
        }
    }

    #[test]
    fn prose_quotes_equations() {
        let quotes = in_prose("By (7.48)\n$$ a = b \\qquad (99.1) \\quad (5.14) $$ f(0.5)\n");
        let found: Vec<_> = quotes.iter().map(|quote| (quote.number, quote.line)).collect();
        assert_eq!(found, [((7, 48), 1), ((5, 14), 2)]);
    }

    #[test]
    fn comments_quote_and_code_does_not() {
        let source = "/// By (7.48), as fig. 7.12. shows; f(0.5) is not one.\n\
                      let x = f(7.49); // (7.50b), corrected\n\
                      /// ```\n/// law(7.51);\n/// ```\n";
        let quotes = in_comments(source);
        let found: Vec<_> = quotes.iter().map(|q| (q.kind, q.number, q.line)).collect();
        let expected = [
            (Kind::Equation, (7, 48), 1),
            (Kind::Figure, (7, 12), 1),
            (Kind::Equation, (7, 50), 2),
        ];
        assert_eq!(found, expected);
    }
}
