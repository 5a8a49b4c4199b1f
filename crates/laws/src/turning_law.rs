//! The choice of a friction law for tangential shifts whose direction changes.

use std::fmt;
use std::str::FromStr;

use carom_special::WordError;

/// The friction law for tangential shifts whose direction changes. On straight paths both are exact.
///
/// Both take the annuli of the contact as independent, which an elastic half-space does not grant on paths that turn. On
/// smooth paths of like bodies whose direction turned all the time the force of `coulomb` was off by .002 to .05 of f F_z
/// in the mean of a path, and by .21 at worst; that of `fixed-direction` by .01 to .22 and .57; that of
/// [rings](crate::rings) of 6 x 8 by .003 to .02 and .04 (two sets of drawn paths, a grid of 52 x 52 cells). This error is apart
/// from the tolerance of `coulomb`, which does not lower it: where it matters, take rings or a grid.
///
/// Case files, Python and LAMMPS use the same words for it:
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
    /// Coulomb's law: every annulus of the contact slips in the direction of its own traction
    /// ([`crate::coulomb`]).
    #[default]
    Coulomb,
    /// Every slip annulus keeps the direction in which it formed, in terms of c_x xi and c_y eta
    /// ([`crate::memory`]; chapter 7 of the thesis, for impacts (8.51)). It is faster, and the least accurate where
    /// the direction changes.
    FixedDirection,
}

impl TurningLaw {
    /// All friction laws.
    pub const ALL: [Self; 2] = [Self::Coulomb, Self::FixedDirection];
    const NAMES: [&'static str; 2] = [Self::Coulomb.name(), Self::FixedDirection.name()];

    /// The word for it.
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
    /// [`WordError`], which lists the allowed words.
    fn from_str(word: &str) -> Result<Self, WordError> {
        let law = Self::ALL.into_iter().find(|law| law.name() == word);
        law.ok_or_else(|| WordError::new("law", word, &Self::NAMES))
    }
}
