//! A step that is ended from outside, and one that is tried.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use carom_halfspace::operator::OperatorError;
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    ContactProblem, Drive, Driven, Frictional, FrictionalError, Gap, NestedHistory, Stop,
};
use carom_special::interrupt::{Ask, under};

fn history(cells: usize) -> NestedHistory<Frictional> {
    let width = 0.5 / cells as f64;
    let make = |grid: Grid| {
        let gap = Gap::sphere(grid, 1.0).map_err(OperatorError::from)?;
        let body = |shear, poisson| Material::from_shear(shear, poisson).unwrap();
        let pair = MaterialPair::new(body(1.0, 0.2), body(5.0, 0.3)).unwrap();
        ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3).unwrap())
    };
    let grid = Grid::new(cells, cells, width, width).unwrap();
    NestedHistory::new(Frictional::default(), grid, make).unwrap()
}

fn drive(zeta: f64, x: f64) -> Drive {
    Drive { normal: Driven::Shift(zeta), x: Driven::Shift(x), ..Drive::default() }
}

/// Says yes from the given question on.
fn from_question(first: usize) -> (Ask, Arc<AtomicUsize>) {
    let asked = Arc::new(AtomicUsize::new(0));
    let count = Arc::clone(&asked);
    (Arc::new(move || count.fetch_add(1, Ordering::Relaxed) + 1 >= first), asked)
}

#[test]
fn wherever_a_step_is_ended_the_next_one_is_as_without_it() {
    // The larger grid is solved on the threads of the pool.
    for (cells, stride) in [(32, 1), (160, 7)] {
        let mut expected = history(cells);
        expected.step(&drive(0.02, 0.0), &mut ()).unwrap();
        expected.step(&drive(0.02, 0.004), &mut ()).unwrap();
        let mut ended = history(cells);
        ended.step(&drive(0.02, 0.0), &mut ()).unwrap();
        let before = ended.state().clone();
        let (never, asked) = from_question(usize::MAX);
        under(Some(never), || ended.trial(&drive(0.02, 0.004), &mut ()).map(drop)).unwrap();
        let questions = asked.load(Ordering::Relaxed);
        assert!(questions > 5, "{questions}");
        for first in (1..=questions).step_by(stride) {
            let (ask, _) = from_question(first);
            let trial = under(Some(ask), || ended.trial(&drive(0.02, 0.004), &mut ()));
            if let Err(error) = &trial {
                let FrictionalError::NotConverged { reached, .. } = error else {
                    panic!("{error}")
                };
                assert_eq!(reached.stop, Stop::Observer);
            }
            assert_eq!(*ended.state(), before);
        }
        ended.step(&drive(0.02, 0.004), &mut ()).unwrap();
        assert_eq!(ended.state(), expected.state());
        assert_eq!(ended.coarse_states(), expected.coarse_states());
        assert_eq!(ended.estimates(), expected.estimates());
    }
}

#[test]
fn a_trial_has_the_errors_that_the_history_has_once_it_is_taken() {
    let mut history = history(32);
    let trial = history.trial(&drive(0.02, 0.001), &mut ()).unwrap();
    let (state, estimates) = (trial.state().clone(), trial.estimates());
    assert!(history.estimates() != estimates && estimates.is_some());
    history.take(trial);
    assert_eq!((history.state(), history.estimates()), (&state, estimates));
}
