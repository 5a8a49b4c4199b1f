//! The error for an unknown word, with the allowed words and the most similar one.

use std::cmp::Reverse;

/// A word that is not one of the allowed words.
///
/// ```
/// use carom_special::WordError;
/// let error = WordError::new("law", "coulom", &["coulomb", "fixed-direction"]);
/// assert_eq!(
///     error.to_string(),
///     "law = \"coulom\" is out of range: must be \"coulomb\" or \"fixed-direction\", did you mean \"coulomb\"?"
/// );
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "{field} = {word:?} is out of range: must be {}{}",
    quoted(allowed),
    self.meant().map_or_else(String::new, |name| format!(", did you mean {name:?}?"))
)]
pub struct WordError {
    /// Name of the field or argument.
    pub field: &'static str,
    /// The word that was given.
    pub word: String,
    /// The words that are allowed.
    pub allowed: &'static [&'static str],
}

impl WordError {
    /// An error for `field`, which must be one of the words `allowed`.
    #[must_use]
    pub fn new(field: &'static str, word: &str, allowed: &'static [&'static str]) -> Self {
        Self { field, word: word.to_owned(), allowed }
    }

    /// The allowed word that was probably intended, if one is similar.
    #[must_use]
    pub fn meant(&self) -> Option<&'static str> {
        nearest(&self.word, self.allowed)
    }
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("{word:?}")).collect::<Vec<_>>().join(" or ")
}

/// The valid name of the same words in another order, or that most similar to `name`; among equally similar ones that
/// with the longest common beginning. `None` if no name is similar.
#[must_use]
pub fn nearest<'a>(name: &str, valid: &[&'a str]) -> Option<&'a str> {
    let same = |candidate: &str| {
        name.bytes().zip(candidate.bytes()).take_while(|(one, other)| one == other).count()
    };
    let score = |candidate: &str| (distance(name, candidate), Reverse(same(candidate)));
    let reordered = valid.iter().copied().find(|candidate| words(candidate) == words(name));
    if reordered.is_some() {
        return reordered;
    }
    let candidate = valid.iter().copied().min_by_key(|candidate| score(candidate))?;
    (distance(name, candidate) <= 1 + candidate.len() / 3).then_some(candidate)
}

/// The words of a name, in the order of the alphabet.
fn words(name: &str) -> Vec<&str> {
    let mut words: Vec<&str> = name.split(['_', '-', ' ']).collect();
    words.sort_unstable();
    words
}

/// The Levenshtein distance: the least number of letters to insert, delete or change.
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
        let reordered = ["friction", "static_friction"];
        assert_eq!(nearest("friction_static", &reordered), Some("static_friction"));
        assert_eq!(nearest("F_zx", &["F_x", "F_y", "F_z"]), Some("F_z"));
        assert_eq!(distance("kitten", "sitting"), 3);
    }

    #[test]
    fn one_wrong_letter_of_a_short_name_is_found() {
        assert_eq!(nearest("mu", &["nu", "density"]), Some("nu"));
        assert_eq!(nearest("xy", &["nu", "density"]), None);
    }
}
