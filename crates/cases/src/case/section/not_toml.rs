//! What to write instead of a text that is not TOML.

use crate::case::unit::pointed;
use toml::de::DeValue;

/// Longest line that a hint quotes.
const LONGEST: usize = 100;

/// The parser's message, and what may be meant by the line at which it stopped.
pub(super) fn told(
    kind: &str,
    source: &str,
    line: usize,
    column: usize,
    message: String,
) -> String {
    let wrong = source.lines().nth(line.saturating_sub(1)).unwrap_or("");
    let meant = if wrong.len() <= LONGEST { number_meant(wrong) } else { String::new() };
    twice(message, wrong, column) + &meant + &advice(kind, source)
}

/// What to write instead of a text that is not TOML but perhaps JSON, XML, YAML or a table.
fn advice(kind: &str, source: &str) -> String {
    let is_first = |line: &&str| !line.is_empty() && !line.starts_with('#');
    let first = source.lines().map(str::trim).find(is_first).unwrap_or("");
    let is_yaml =
        first == "---" || first.split_once(':').is_some_and(|(name, _)| !name.contains(['=', '"']));
    match first.starts_with(['{', '<']) || is_yaml || !source.contains('=') {
        true => format!("; a case is written in TOML, `carom new {kind}` prints one"),
        false => String::new(),
    }
}

/// The parser's message with the name of a field or table that stands in the file twice.
fn twice(message: String, line: &str, column: usize) -> String {
    let is_name = |letter: &char| letter.is_alphanumeric() || "_-.".contains(*letter);
    match message == "duplicate key" {
        true => {
            let name: String = line.chars().skip(column).take_while(is_name).collect();
            format!("`{name}` is given a second time; leave one of the two out")
        }
        false => message,
    }
}

/// Quotation marks of texts that were typeset.
const TYPESET: &[char] =
    &['\u{201c}', '\u{201d}', '\u{201e}', '\u{2018}', '\u{2019}', '\u{ab}', '\u{bb}'];

/// What may be meant by a line that is not TOML: numbers as other languages write them, or a text.
fn number_meant(line: &str) -> String {
    let line = line.split('#').next().unwrap_or("");
    let value = line.split_once('=').map_or("", |(_, value)| value).trim();
    let decimal = pointed(value).filter(|_| !value.contains(['[', '(', '{', '"']));
    let tuple = value.strip_prefix('(').and_then(|value| value.strip_suffix(')'));
    let is_switch = ["true", "false"].contains(&value.to_lowercase().as_str());
    let has_row = line.contains('[') && line.split([',', '[', ']']).any(is_row);
    match (value.parse::<f64>(), decimal, tuple) {
        (Ok(number), ..) if DeValue::parse(value).is_err() => format!("; write {number:?}"),
        (_, Some(decimal), _) => {
            format!("; {value} has a decimal comma, write a point: {decimal}")
        }
        (_, _, Some(items)) => format!("; a list has brackets, [{items}]"),
        _ if value.contains('\u{2212}') => "; the minus sign of a number is a hyphen, -".to_owned(),
        _ if value.contains(TYPESET) => {
            format!("; write straight quotation marks, {}", value.replace(TYPESET, "\""))
        }
        _ if has_row => "; the items of a list are separated by commas, as in [1, 2, 3]".to_owned(),
        _ if is_switch => format!("; write {}", value.to_lowercase()),
        _ if is_range(value) => {
            "; a sweep is { start = .., stop = .., count = .. }, count the number of values"
                .to_owned()
        }
        _ if is_bare_text(value) => format!("; write \"{value}\""),
        _ if value.contains(['/', '*', '+']) => {
            "; a case does not calculate, write the number".to_owned()
        }
        _ => String::new(),
    }
}

/// Whether numbers stand here side by side.
fn is_row(part: &str) -> bool {
    let words = part.split([' ', '\t', ';']).filter(|word| !word.is_empty());
    let mut numbers = words.map(|word| word.parse::<f64>().is_ok());
    numbers.next() == Some(true) && numbers.next() == Some(true)
}

/// Whether these are numbers with colons between them.
fn is_range(value: &str) -> bool {
    value.contains(':') && value.split(':').all(|part| part.trim().parse::<f64>().is_ok())
}

/// Whether these are words, or a number with a unit, without quotes.
fn is_bare_text(value: &str) -> bool {
    let is_plain = |letter: char| letter.is_alphanumeric() || " ._-+/^%".contains(letter);
    let is_word =
        |word: &str| word.starts_with(char::is_alphabetic) && word.parse::<f64>().is_err();
    value.chars().all(is_plain) && value.split_whitespace().any(is_word)
}
