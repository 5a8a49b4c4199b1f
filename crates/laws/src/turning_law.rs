//! The choice of a friction law for tangential motions whose direction turns.

use std::fmt;
use std::str::FromStr;

use carom_special::WordError;

/// The friction law where the direction of the tangential motion turns. On straight paths both are exact.
///
/// The same words choose it in case files, in Python and in LAMMPS:
///
/// ```
/// use carom_laws::turning_law::TurningLaw;
/// let law: TurningLaw = "fixed-direction".parse()?;
/// assert_eq!((law, law.name()), (TurningLaw::FixedDirection, "fixed-direction"));
/// assert_eq!(TurningLaw::default().name(), "coulomb");
/// assert!("chapter 7".parse::<TurningLaw>().is_err());
/// # Ok::<(), carom_special::WordError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum TurningLaw {
    /// Coulomb's: every ring of the contact slips along its own traction ([`crate::coulomb`]).
    #[default]
    Coulomb,
    /// Every slip ring keeps the direction in which it formed, measured with c_x xi and c_y eta
    /// ([`crate::memory`]; chapter 7 of the thesis, of impacts (8.51)). Faster; where the shift turns, off
    /// by 5 % of the friction limit in the mean.
    FixedDirection,
}

impl TurningLaw {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Coulomb, Self::FixedDirection];
    const NAMES: [&'static str; 2] = [Self::Coulomb.name(), Self::FixedDirection.name()];

    /// Its word.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Coulomb => "coulomb",
            Self::FixedDirection => "fixed-direction",
        }
    }
}

impl fmt::Display for TurningLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for TurningLaw {
    type Err = WordError;

    /// # Errors
    /// [`WordError`] with the words that are allowed.
    fn from_str(word: &str) -> Result<Self, WordError> {
        let law = Self::ALL.into_iter().find(|law| law.name() == word);
        law.ok_or_else(|| WordError::new("law", word, &Self::NAMES))
    }
}
