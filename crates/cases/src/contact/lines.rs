//! The lines of an input of CONTACT and the numbers in them.
//!
//! Blank lines and what follows a % are skipped. Commas and = count as blanks. A group of numbers may go over several lines, and
//! the next group begins on a new line; what stands behind the last number of a group is a label.

use super::fault::Fault;

/// A number of a file with its name and place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Given {
    pub(super) name: &'static str,
    pub(super) value: f64,
    pub(super) line: usize,
}

impl Given {
    /// An error about this number.
    pub(super) fn must(&self, allowed: impl Into<String>) -> Fault {
        Fault::new(self.line, self.name, self.value, allowed)
    }

    /// The number, if `holds`.
    pub(super) fn checked(&self, holds: impl Fn(f64) -> bool, allowed: &str) -> Result<f64, Fault> {
        if holds(self.value) { Ok(self.value) } else { Err(self.must(allowed)) }
    }

    pub(super) fn positive(&self) -> Result<f64, Fault> {
        self.checked(|value| value > 0.0, "> 0")
    }

    /// A whole number in a range.
    pub(super) fn whole(&self, [least, most]: [i32; 2]) -> Result<i32, Fault> {
        let fits = |value: f64| {
            value.fract() == 0.0 && value >= f64::from(least) && value <= f64::from(most)
        };
        let allowed = format!("a whole number from {least} to {most}");
        self.checked(fits, &allowed).map(|value| value as i32)
    }

    /// A count of at least 1.
    pub(super) fn count(&self, most: i32) -> Result<usize, Fault> {
        self.whole([1, most]).map(|count| count as usize)
    }
}

/// How a number may be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Number,
    /// In radians, or in degrees with a d behind it.
    Angle,
}

/// The lines of a file, from the first that is not yet read.
pub(super) struct Lines<'a> {
    rest: std::iter::Enumerate<std::str::Lines<'a>>,
    /// The last line that was read, from 1.
    last: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        Self { rest: text.strip_prefix('\u{feff}').unwrap_or(text).lines().enumerate(), last: 0 }
    }

    /// The last line that was read, from 1.
    pub(super) const fn last(&self) -> usize {
        self.last
    }

    /// The words of the next line that has any; none at the end of the file.
    fn next(&mut self) -> Option<Vec<&'a str>> {
        for (index, line) in self.rest.by_ref() {
            self.last = index + 1;
            let words = words(line);
            if !words.is_empty() {
                return Some(words);
            }
        }
        None
    }

    /// The same, where `name` is expected.
    pub(super) fn expect(&mut self, name: &str) -> Result<Vec<&'a str>, Fault> {
        self.next().ok_or_else(|| {
            let line = self.last + 1;
            Fault::new(line, name, "missing: the file ends here,", "given")
        })
    }

    /// The numbers of these names.
    pub(super) fn numbers<const N: usize>(
        &mut self,
        names: [&'static str; N],
    ) -> Result<[Given; N], Fault> {
        Ok(self.with_more(names, &[])?.0)
    }

    /// The same, and those of these further names that are on the same line.
    pub(super) fn with_more<const N: usize>(
        &mut self,
        names: [&'static str; N],
        more: &'static [&'static str],
    ) -> Result<([Given; N], Vec<Given>), Fault> {
        let mut all = self.group(N, |place| (names[place], Form::Number), more)?;
        let rest = all.split_off(N);
        Ok((std::array::from_fn(|place| all[place]), rest))
    }

    /// An angle, two numbers, and those of `more` that are on the same line.
    pub(super) fn angle_first(
        &mut self,
        names: [&'static str; 3],
        more: &'static [&'static str],
    ) -> Result<Vec<Given>, Fault> {
        let form = |place| if place == 0 { Form::Angle } else { Form::Number };
        self.group(3, |place| (names[place], form(place)), more)
    }

    /// This many numbers of one name.
    pub(super) fn list(&mut self, name: &'static str, count: usize) -> Result<Vec<f64>, Fault> {
        let all = self.group(count, |_| (name, Form::Number), &[])?;
        Ok(all.iter().map(|given| given.value).collect())
    }

    fn group(
        &mut self,
        count: usize,
        expected: impl Fn(usize) -> (&'static str, Form),
        more: &'static [&'static str],
    ) -> Result<Vec<Given>, Fault> {
        let mut all = Vec::new();
        while all.len() < count {
            let words = self.expect(expected(all.len()).0)?;
            let line = self.last;
            let mut words = words.into_iter();
            while all.len() < count {
                let Some(word) = words.next() else { break };
                let (name, form) = expected(all.len());
                let value = number(word, form)
                    .ok_or_else(|| Fault::new(line, name, format!("\"{word}\""), "a number"))?;
                all.push(Given { name, value, line });
            }
            if all.len() == count {
                self.labels(words, more, &mut all)?;
            }
        }
        Ok(all)
    }

    /// What follows the last number of a group: further numbers that may be missing, then labels.
    fn labels(
        &self,
        mut words: impl Iterator<Item = &'a str>,
        more: &'static [&'static str],
        all: &mut Vec<Given>,
    ) -> Result<(), Fault> {
        let (line, mut names) = (self.last, more.iter());
        let Some(value) = words.by_ref().next().and_then(|word| number(word, Form::Number)) else {
            return Ok(());
        };
        let Some(name) = names.next() else {
            let allowed = "followed by no further number on its line: CONTACT would ignore it";
            let before = all.last().map_or("this", |given| given.name);
            return Err(Fault::new(line, before, format!("followed by {value},"), allowed));
        };
        all.push(Given { name, value, line });
        let mut rest = names.zip(words);
        let further = std::iter::from_fn(|| {
            let (name, word) = rest.next()?;
            Some(Given { name, value: number(word, Form::Number)?, line })
        });
        all.extend(further);
        Ok(())
    }
}

/// The words of a line before its comment. A text in single quotes is one word.
fn words(line: &str) -> Vec<&str> {
    let mut quoted = false;
    let mut parts = line.split(|letter| {
        quoted ^= letter == '\'';
        letter == '%' && !quoted
    });
    let plain = parts.next().unwrap_or_default();
    let mut quoted = false;
    plain
        .split(|letter: char| {
            quoted ^= letter == '\'';
            !quoted && (letter.is_whitespace() || letter == ',' || letter == '=')
        })
        .filter(|word| !word.is_empty())
        .collect()
}

/// The value of a number as Fortran writes it; none for anything else.
fn number(word: &str, form: Form) -> Option<f64> {
    let (word, unit) = match (form, word.as_bytes().last()) {
        (Form::Angle, Some(b'd' | b'D')) => (&word[..word.len() - 1], 1.0_f64.to_radians()),
        (Form::Angle, Some(b'r' | b'R')) => (&word[..word.len() - 1], 1.0),
        _ => (word, 1.0),
    };
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let unsigned = |text: &str| text.strip_prefix(['+', '-']).unwrap_or(text).to_owned();
    let (mantissa, exponent) = match word.find(['e', 'E', 'd', 'D']) {
        Some(place) => (&word[..place], &word[place + 1..]),
        // Fortran reads .1-07 as .1e-07.
        None => match word.rfind(['+', '-']).filter(|&place| place > 0) {
            Some(place) => word.split_at(place),
            None => (word, "0"),
        },
    };
    let plain = unsigned(mantissa).replacen('.', "", 1);
    if !digits(&plain) || !digits(&unsigned(exponent)) {
        return None;
    }
    let value: f64 = format!("{mantissa}e{exponent}").parse().ok()?;
    (value.is_finite()).then_some(value * unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_fortran() {
        let plain = |word| number(word, Form::Number);
        for (word, value) in [
            ("1.0d-3", 1e-3),
            (".5", 0.5),
            ("-5.", -5.0),
            ("+2E+2", 200.0),
            ("7", 7.0),
            (".1-07", 1e-8),
        ] {
            assert_eq!(plain(word), Some(value), "{word}");
        }
        for word in ["", ".", "e5", "1e", "1d+", "nan", "inf", "1.2.3", "--1", "0x1", "1e999", "é"]
        {
            assert_eq!(plain(word), None, "{word}");
        }
        assert_eq!(number("180.0d", Form::Angle), Some(std::f64::consts::PI));
        assert_eq!(number("2r", Form::Angle), Some(2.0));
        assert_eq!(number("2", Form::Angle), Some(2.0));
    }

    #[test]
    fn a_group_goes_over_lines_and_ends_in_labels() {
        let text =
            "% nothing\r\n\r\n 1, 2 % no 9\r\n 3 MX,MY\r\n 4 5 6.5 Q\r\n 'a % b.txt'\tFILE\r\n";
        let mut lines = Lines::new(text);
        let group = lines.numbers(["A", "B", "C"]).unwrap();
        assert_eq!(group.map(|given| (given.value, given.line)), [(1.0, 3), (2.0, 3), (3.0, 4)]);
        let ([a], more) = lines.with_more(["A"], &["B", "C", "D"]).unwrap();
        assert_eq!((a.value, more.iter().map(|b| b.value).collect()), (4.0, vec![5.0, 6.5]));
        assert_eq!(lines.expect("FILE").unwrap(), ["'a % b.txt'", "FILE"]);
        let error = lines.expect("DX").unwrap_err();
        assert_eq!(error.to_string(), "line 7: DX is missing: the file ends here, must be given");
        let error = Lines::new("1 2 3").numbers(["A", "B"]).unwrap_err();
        assert!(error.to_string().starts_with("line 1: B is followed by 3, must be"), "{error}");
        let error = Lines::new("1 x").numbers(["A", "B"]).unwrap_err();
        assert_eq!(error.to_string(), "line 1: B is \"x\", must be a number");
    }
}
