//! Chooses the cell width for a required accuracy where the window is given, as on a plate.

use carom_halfspace::Grid;

use super::fit::{Accuracy, FIRST_CELLS, Fit, FitError, Reached, Run, finer};
use super::reach::Errors;
use super::window::Window;
use crate::drive::Drive;
use crate::method::Method;
use crate::problem::{ContactProblem, ProblemError};

/// Nested grids need numbers of cells that are divisible by this.
const NESTED: usize = 8;

impl Accuracy {
    /// Follows the drives on cells that cover these sides about the origin, neither more nor less,
    /// as a plate needs it. Only the number of cells is chosen.
    ///
    /// # Errors
    /// [`FitError`]; [`FitError::Endless`] if the contact reaches a border.
    pub fn fit_cells<M: Method + Clone>(
        &self,
        method: M,
        make: impl Fn(&Window) -> Result<ContactProblem, ProblemError>,
        sides: [f64; 2],
        drives: &[Drive],
    ) -> Result<Fit<M>, FitError<M::Error>> {
        for drive in drives {
            drive.check()?;
        }
        let (mut cells, mut before): (usize, Option<[f64; 2]>) = (FIRST_CELLS, None);
        loop {
            let window = Window::about([0.0; 2], covering(sides, cells)?)?;
            let mut run = Run::begin(method.clone(), &make, window)?;
            let (errors, next) = match run.follow(drives) {
                Ok(Reached::Border(side)) => return Err(FitError::Endless { side }),
                Ok(Reached::End(Errors { all: error, .. })) if error <= self.wanted => {
                    let (history, estimates) = (run.history, run.estimates);
                    return Ok(Fit { window, history, estimates, error });
                }
                Ok(Reached::End(errors)) => (errors, finer(cells, errors.all, before, self.wanted)),
                Ok(Reached::Nothing) => (Errors { all: f64::INFINITY, at_edges: 0.0 }, 2 * cells),
                Err(error) => return Err(FitError::Method(error)),
            };
            if self.is_out_of_reach([cells, next], before.is_none(), errors) {
                return Err(self.unreached(cells, errors));
            }
            before = errors.all.is_finite().then_some([cells as f64, errors.all]);
            cells = next;
        }
    }
}

/// A grid with this number of cells along the longer side, and cells as square as nested grids allow.
fn covering([a, b]: [f64; 2], cells: usize) -> Result<Grid, carom_special::RangeError> {
    let longer = a.max(b);
    let count = |side: f64| {
        let nested = (cells as f64 * (side / longer) / NESTED as f64).round() as usize;
        NESTED * nested.max(1)
    };
    let (nx, ny) = (count(a), count(b));
    Grid::new(nx, ny, a / nx as f64, b / ny as f64)
}
