//! Thin rings and shells of revolution: a bellows under its loads, a flange under its forces.

mod bellows;
mod flange;

pub use bellows::{BellowsRow, FollowedBellows, LoadEnd, RESPONSE_COLUMNS, Response, WALL_COLUMNS};
pub use flange::{FlangeSummary, RingPlace, SolvedFlange};

use crate::Error;
use crate::case::ShellCase;
use crate::input::CaseFile;

/// The result of a case.
#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "there is one for each case")]
pub enum Solved {
    /// A bellows under each of its loads.
    Bellows(FollowedBellows),
    /// A flange under its forces.
    Flange(SolvedFlange),
}

impl Solved {
    /// Reasons to distrust the result, as sentences.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        match self {
            Self::Bellows(bellows) => bellows.warnings(),
            Self::Flange(flange) => flange.warnings(),
        }
    }
}

/// Computes a bellows or a flange.
///
/// # Errors
/// If the case has an error, or its equations cannot be solved.
pub fn solved(file: &CaseFile) -> Result<Solved, Error> {
    let case = file.parse::<ShellCase>()?;
    file.follow(|| match &case {
        ShellCase::Bellows(case) => bellows::followed(case).map(Solved::Bellows),
        ShellCase::Flange(case) => Ok(Solved::Flange(flange::solved(case)?)),
    })
}
