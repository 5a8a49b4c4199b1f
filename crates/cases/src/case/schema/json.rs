//! JSON as text: maps keep their order, so that a schema lists fields as the tables do.

use std::fmt::Write as _;

/// A value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Json {
    /// True or false.
    Bool(bool),
    /// A finite number.
    Number(f64),
    /// A text.
    Text(String),
    /// A list.
    List(Vec<Json>),
    /// Names with values, in this order.
    Map(Vec<(String, Json)>),
}

macro_rules! values {
    ($($kind:ty => $variant:ident,)*) => {
        $(impl From<$kind> for Json {
            fn from(value: $kind) -> Self {
                Self::$variant(value.into())
            }
        })*
    };
}

values! {
    bool => Bool,
    f64 => Number,
    &str => Text,
    String => Text,
    Vec<Json> => List,
}

impl From<usize> for Json {
    fn from(value: usize) -> Self {
        Self::Number(value as f64)
    }
}

/// Texts as a list.
pub(super) fn texts<T: AsRef<str>>(texts: impl IntoIterator<Item = T>) -> Json {
    Json::List(texts.into_iter().map(|text| text.as_ref().into()).collect())
}

/// A map.
pub(super) fn map<const N: usize>(entries: [(&str, Json); N]) -> Json {
    Json::Map(entries.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
}

impl Json {
    /// The same map with one more entry; other values stay as they are.
    pub(super) fn with(mut self, name: &str, value: impl Into<Self>) -> Self {
        if let Self::Map(entries) = &mut self {
            entries.push((name.to_owned(), value.into()));
        }
        self
    }

    /// The same map with one more entry, unless its list or map is empty.
    pub(super) fn with_any(self, name: &str, value: Self) -> Self {
        match &value {
            Self::List(items) if items.is_empty() => self,
            Self::Map(entries) if entries.is_empty() => self,
            _ => self.with(name, value),
        }
    }

    /// The text, with a line for each entry that does not fit into one.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        self.write(&mut text, 0);
        text.push('\n');
        text
    }

    fn write(&self, text: &mut String, depth: usize) {
        match self {
            Self::Bool(value) => text.push_str(if *value { "true" } else { "false" }),
            Self::Number(value) => text.push_str(&number(*value)),
            Self::Text(value) => quote(text, value),
            Self::List(items) => {
                let is_short =
                    items.iter().all(|item| !matches!(item, Self::List(_) | Self::Map(_)));
                block(text, depth, ['[', ']'], is_short, items, |text, item, depth| {
                    item.write(text, depth);
                });
            }
            Self::Map(entries) => {
                block(
                    text,
                    depth,
                    ['{', '}'],
                    entries.is_empty(),
                    entries,
                    |text, entry, depth| {
                        quote(text, &entry.0);
                        text.push_str(": ");
                        entry.1.write(text, depth);
                    },
                );
            }
        }
    }
}

/// Items between brackets, in one line if they are `short`.
fn block<T>(
    text: &mut String,
    depth: usize,
    [open, close]: [char; 2],
    is_short: bool,
    items: &[T],
    write: impl Fn(&mut String, &T, usize),
) {
    let end = |text: &mut String, depth: usize| {
        if !is_short {
            text.push('\n');
            text.push_str(&" ".repeat(2 * depth));
        }
    };
    text.push(open);
    for (i, item) in items.iter().enumerate() {
        if i > 0 {
            text.push_str(if is_short { ", " } else { "," });
        }
        end(text, depth + 1);
        write(text, item, depth + 1);
    }
    end(text, depth);
    text.push(close);
}

/// A number with all digits; very large and very small ones with an exponent.
fn number(value: f64) -> String {
    match value.abs() {
        size if size != 0.0 && !(1e-4..1e16).contains(&size) => format!("{value:e}"),
        _ => value.to_string(),
    }
}

fn quote(text: &mut String, value: &str) {
    text.push('"');
    for letter in value.chars() {
        match letter {
            '"' | '\\' => {
                text.push('\\');
                text.push(letter);
            }
            '\n' => text.push_str("\\n"),
            control if control < ' ' => {
                let _ = write!(text, "\\u{:04x}", u32::from(control));
            }
            plain => text.push(plain),
        }
    }
    text.push('"');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_quoted_and_numbers_keep_their_digits() {
        let value = map([
            ("a", texts(["x", "\"\\\n\u{1}"])),
            ("b", vec![0.1.into(), 1e100.into(), f64::MAX.into(), 4096.0.into()].into()),
            ("c", map([])),
        ])
        .with("d", true);
        let text = "{\n  \"a\": [\"x\", \"\\\"\\\\\\n\\u0001\"],\n  \"b\": [0.1, 1e100, \
                    1.7976931348623157e308, 4096],\n  \"c\": {},\n  \"d\": true\n}\n";
        assert_eq!(value.text(), text);
    }
}
