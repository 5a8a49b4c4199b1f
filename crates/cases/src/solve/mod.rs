//! A contact with friction on a grid, step by step.

mod bodies;
mod classic;
mod follow;
mod influence;
mod warnings;

pub use bodies::Bodies;
pub use classic::{Chosen, ChosenError, Working};
pub use follow::{Followed, Found, Run, Saved, border};
pub(crate) use influence::influence_of_contact;
pub use warnings::few_cells;

use crate::Error;
use crate::case::SolveCase;
use crate::input::CaseFile;
use carom_solver::Accuracy;

/// Reads a case and solves it. If `accuracy` is given, it replaces the grid of the case.
///
/// # Errors
/// If the case has an error, a file that it names cannot be read, or a step cannot be solved.
pub fn solved(file: &CaseFile, accuracy: Option<f64>) -> Result<(SolveCase, Followed), Error> {
    if let Some(accuracy) = accuracy {
        Accuracy::new(accuracy)?;
    }
    let case = file.parse_by(|source| SolveCase::parse_to(source, accuracy))?;
    let followed = file.follow(|| {
        let bodies = Bodies::of(file, &case)?;
        let run = Run::new(&case, &bodies)?;
        run.follow(Found::default(), |_, _, _| Ok(()))
    })?;
    Ok((case, followed))
}
