//! Whether an accuracy is within reach of the greatest number of cells.
//!
//! Under the edge of a punch the pressure is unbounded, and errors fall at most in proportion to the width of a cell.
//! Two grids then tell that no allowed grid is fine enough, long before the finest one has been solved.

use super::fit::{Accuracy, FitError};

/// By how much an accuracy that is called possible exceeds the expected error on the finest grid: at an edge
/// errors times cells change in jumps, under a disc by up to 1.9 from 48 to 768 cells along a side.
const RESERVE: f64 = 2.0;

/// The greatest relative errors of a history on one grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Errors {
    /// Of all steps.
    pub(super) all: f64,
    /// Of the steps in which the pressure is greatest at an edge.
    pub(super) at_edges: f64,
}

impl Accuracy {
    /// Whether the next grid, or any grid that an edge would need, has too many cells. A first grid does not
    /// tell: it may be too coarse for the shape of the bodies.
    pub(super) fn is_out_of_reach(
        &self,
        [cells, next]: [usize; 2],
        is_first: bool,
        errors: Errors,
    ) -> bool {
        let too_many = |cells: f64| cells * cells > self.most as f64;
        let for_edges = cells as f64 * errors.at_edges / self.wanted;
        too_many(next as f64) || !is_first && too_many(for_edges)
    }

    /// The error that says so, with an accuracy that is within reach.
    pub(super) fn unreached<E>(&self, cells: usize, errors: Errors) -> FitError<E> {
        let finest = (self.most as f64).sqrt();
        let expected = RESERVE * errors.at_edges * cells as f64 / finest;
        // Without an edge only what has been reached is known.
        let has_edge = errors.at_edges >= errors.all;
        let possible = if has_edge { expected.min(errors.all) } else { errors.all };
        let (reached, wanted, most) = (errors.all, self.wanted, self.most);
        FitError::Unreached { wanted, reached, cells, most, possible }
    }
}

#[cfg(test)]
mod tests {
    use carom_halfspace::operator::OperatorError;
    use carom_halfspace::{Grid, Material, MaterialPair};
    use carom_laws::friction::Friction;
    use carom_laws::law::Shift;

    use super::*;
    use crate::accuracy::fit::{Reached, Run};
    use crate::{ContactProblem, Drive, Frictionless, Outline, Shape, Window};

    /// At most 1000 x 1000 cells, for an error of 1e-3.
    fn refuses(cells: usize, next: usize, is_first: bool, all: f64, at_edges: f64) -> bool {
        let accuracy = Accuracy::new(1e-3).unwrap().at_most(1_000_000);
        accuracy.is_out_of_reach([cells, next], is_first, Errors { all, at_edges })
    }

    /// An edge of error 6e-3 on 200 cells needs 1200; one of 4e-3 needs 800.
    #[test]
    fn an_edge_that_needs_too_many_cells_is_refused_on_the_second_grid() {
        assert!(refuses(200, 800, false, 6e-3, 6e-3));
        assert!(!refuses(200, 800, true, 6e-3, 6e-3));
        assert!(!refuses(200, 800, false, 4e-3, 4e-3));
        // Errors of other steps may fall in second order.
        assert!(!refuses(200, 800, false, 6e-3, 1e-3));
        assert!(refuses(200, 1001, true, 6e-3, 0.0));
        assert!(!refuses(200, 1000, true, 6e-3, 0.0));
    }

    /// Errors of a ball fall faster than in proportion to the width of a cell, those under a punch do not.
    #[test]
    fn errors_under_edges_are_those_of_bodies_with_edges() {
        let errors = |shape: &Shape| {
            let body = Material::from_shear(2.0, 0.0).unwrap();
            let pair = MaterialPair::new(body, body).unwrap();
            let make = |window: &Window| {
                let gap = window.gap(|x, y| shape.height(x, y)).map_err(OperatorError::from)?;
                ContactProblem::of_half_spaces(gap, pair, Friction::NONE)
            };
            let grid = Grid::new(48, 48, 0.03, 0.03).unwrap();
            let window = Window::about([0.0; 2], grid).unwrap();
            let mut run = Run::begin(Frictionless::default(), &make, window).unwrap();
            let pressed = Drive::by_shift(Shift { zeta: 0.1, ..Shift::default() });
            match run.follow(&[pressed]).unwrap() {
                Reached::End(errors) => errors,
                Reached::Border(_) | Reached::Nothing => panic!("no estimates"),
            }
        };
        let ball = errors(&Shape::Paraboloid { radii: [1.0, 1.0] });
        assert!(ball.all > 0.0 && ball.at_edges == 0.0, "{ball:?}");
        let punch = errors(&Shape::Punch(Outline::Disc { radius: 0.5 }));
        assert!(punch.all > 0.0 && punch.at_edges == punch.all, "{punch:?}");
    }

    /// On 1000 cells an edge has a fifth of the error on 200, and at most the error that is reached already.
    #[test]
    fn an_accuracy_within_reach_is_named() {
        let accuracy = Accuracy::new(1e-3).unwrap().at_most(1_000_000);
        let possible = |cells: usize, all: f64, at_edges: f64| match accuracy
            .unreached::<()>(cells, Errors { all, at_edges })
        {
            FitError::Unreached { possible, .. } => possible,
            other => panic!("{other:?}"),
        };
        assert!((possible(200, 0.01, 0.01) - 0.004).abs() < 1e-15);
        assert_eq!(possible(200, 0.01, 0.001), 0.01);
        assert_eq!(possible(800, 0.01, 0.01), 0.01);
    }
}
