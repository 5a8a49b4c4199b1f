//! Which name a mistyped one was meant to be, and where it stands.

use std::cmp::Reverse;

/// Letters of a bad value that its message shows.
const MOST_SHOWN: usize = 200;

/// The valid name most like `name`, of several that which begins like it longest; none if none is
/// like it at all.
pub(in crate::case) fn nearest(name: &str, valid: &[&'static str]) -> Option<&'static str> {
    let same = |candidate: &str| {
        name.bytes().zip(candidate.bytes()).take_while(|(one, other)| one == other).count()
    };
    let score = |candidate: &str| (distance(name, candidate), Reverse(same(candidate)));
    let candidate = valid.iter().copied().min_by_key(|candidate| score(candidate))?;
    (distance(name, candidate) <= 1 + candidate.len() / 3).then_some(candidate)
}

/// At most so much of a value that the message stays readable.
pub(super) fn shortened(value: &str) -> String {
    match value.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{}...", &value[..end]),
        None => value.to_owned(),
    }
}

/// The line, from 1, of the byte at `offset`.
pub(super) fn line_at(source: &str, offset: usize) -> usize {
    1 + source.bytes().take(offset).filter(|byte| *byte == b'\n').count()
}

/// How many letters must be put in, taken out or changed (Levenshtein).
fn distance(one: &str, other: &str) -> usize {
    let other: Vec<char> = other.chars().collect();
    let mut row: Vec<usize> = (0..=other.len()).collect();
    for (i, letter) in one.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, candidate) in other.iter().enumerate() {
            let changed = diagonal + usize::from(letter != *candidate);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[other.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_name_is_found() {
        let valid = ["radius", "density", "material", "mass"];
        assert_eq!(nearest("radus", &valid), Some("radius"));
        assert_eq!(nearest("Density", &valid), Some("density"));
        assert_eq!(nearest("temperature", &valid), None);
        assert_eq!(nearest("F_zx", &["F_x", "F_y", "F_z"]), Some("F_z"));
        assert_eq!(distance("kitten", "sitting"), 3);
    }

    #[test]
    fn lines_count_from_one() {
        assert_eq!(line_at("a\nb\nc", 0), 1);
        assert_eq!(line_at("a\nb\nc", 4), 3);
    }
}
