//! Values of an option: one, a list, or `start:stop:count`.

use carom_special::linspace;
use std::str::FromStr;

/// Largest number of values of a sweep.
const MAX_VALUES: usize = 1_000_000;

/// One or more values, in the order given.
///
/// ```
/// use carom_cli::range::Values;
/// assert_eq!("1.5".parse::<Values>()?.0, [1.5]);
/// assert_eq!("1,2,4".parse::<Values>()?.0, [1.0, 2.0, 4.0]);
/// assert_eq!("0:1:3".parse::<Values>()?.0, [0.0, 0.5, 1.0]);
/// # Ok::<(), carom_cli::range::ValuesError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Values(pub Vec<f64>);

/// Why a text is not a list of values.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{reason}; allowed are one value (1.2), a list (1,1.2,1.5) or start:stop:count (0:10:101)")]
pub struct ValuesError {
    reason: String,
}

impl FromStr for Values {
    type Err = ValuesError;

    fn from_str(text: &str) -> Result<Self, ValuesError> {
        let parts: Vec<&str> = text.split(':').collect();
        match parts.as_slice() {
            [list] => list.split(',').map(number).collect::<Result<_, _>>().map(Self),
            [start, stop, count] => {
                Ok(Self(linspace(finite(start)?, finite(stop)?, whole(count)?)))
            }
            _ => Err(error(format!("`{text}` has {} colons", parts.len() - 1))),
        }
    }
}

fn number(text: &str) -> Result<f64, ValuesError> {
    text.trim().parse().map_err(|_| error(format!("`{text}` is not a number")))
}

fn finite(text: &str) -> Result<f64, ValuesError> {
    match number(text)? {
        value if value.is_finite() => Ok(value),
        _ => Err(error(format!("`{text}` is not finite and cannot be the end of a range"))),
    }
}

fn whole(text: &str) -> Result<usize, ValuesError> {
    match text.trim().parse() {
        Ok(count) if (2..=MAX_VALUES).contains(&count) => Ok(count),
        _ => Err(error(format!("count `{text}` is not a whole number from 2 to {MAX_VALUES}"))),
    }
}

const fn error(reason: String) -> ValuesError {
    ValuesError { reason }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_of_a_range_are_exact() {
        let values = "0.1:7:12".parse::<Values>().unwrap().0;
        assert_eq!((values[0], values[11], values.len()), (0.1, 7.0, 12));
        assert_eq!("3:1:3".parse::<Values>().unwrap().0, [3.0, 2.0, 1.0]);
    }

    #[test]
    fn errors_say_what_is_allowed() {
        for (text, reason) in [
            ("", "`` is not a number"),
            ("1,,2", "`` is not a number"),
            ("a", "`a` is not a number"),
            ("1:2", "`1:2` has 1 colons"),
            ("0:inf:3", "`inf` is not finite"),
            ("0:1:1", "count `1` is not a whole number from 2 to 1000000"),
            ("0:1:2.5", "count `2.5` is not a whole number"),
            ("0:1:-3", "count `-3` is not a whole number"),
            ("0:1:99999999999", "count `99999999999` is not a whole number"),
        ] {
            let error = text.parse::<Values>().unwrap_err().to_string();
            assert!(error.starts_with(reason), "{text}: {error}");
            assert!(error.ends_with("or start:stop:count (0:10:101)"), "{text}: {error}");
        }
    }
}
