//! The names of the laws that a contact with memory may follow.

use std::fmt;
use std::str::FromStr;

use carom_special::WordError;

use crate::turning_law::TurningLaw;

/// The law of a contact of two bodies: of shifts alone, or [rings](crate::rings), in which shift, twist and the coupling
/// of dissimilar materials act together.
///
/// C, LAMMPS and Python use the same words for it:
///
/// ```
/// use carom_laws::law_name::LawName;
/// use carom_laws::turning_law::TurningLaw;
/// assert_eq!("rings".parse::<LawName>()?, LawName::Rings);
/// assert_eq!("coulomb".parse::<LawName>()?, LawName::Shift(TurningLaw::Coulomb));
/// assert_eq!(LawName::ALL.map(LawName::name), ["coulomb", "fixed-direction", "rings"]);
/// assert!("ring".parse::<LawName>().is_err());
/// # Ok::<(), carom_special::WordError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LawName {
    /// A law of shifts: [`crate::shift_law::ShiftLaw`].
    Shift(TurningLaw),
    /// Concentric rings: [`crate::rings::RingLaw`].
    Rings,
}

impl LawName {
    /// All laws.
    pub const ALL: [Self; 3] =
        [Self::Shift(TurningLaw::Coulomb), Self::Shift(TurningLaw::FixedDirection), Self::Rings];
    const NAMES: [&'static str; 3] =
        [Self::ALL[0].name(), Self::ALL[1].name(), Self::ALL[2].name()];

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Shift(law) => law.name(),
            Self::Rings => "rings",
        }
    }
}

impl Default for LawName {
    fn default() -> Self {
        Self::Shift(TurningLaw::default())
    }
}

impl fmt::Display for LawName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for LawName {
    type Err = WordError;

    /// # Errors
    /// [`WordError`], which lists the allowed words.
    fn from_str(word: &str) -> Result<Self, WordError> {
        let law = Self::ALL.into_iter().find(|law| law.name() == word);
        law.ok_or_else(|| WordError::new("law", word, &Self::NAMES))
    }
}
