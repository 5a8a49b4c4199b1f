//! An observer ends a step between dissimilar bodies, wherever it is.

use std::ops::ControlFlow;

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    ContactProblem, Drive, Frictional, FrictionalError, Gap, NestedHistory, Progress, Stop,
};

fn history(friction: f64) -> NestedHistory<Frictional> {
    let pair = MaterialPair::new(Material::from_shear(1.0, 0.0).unwrap(), Material::RIGID).unwrap();
    let make = |grid: Grid| {
        let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
        ContactProblem::of_half_spaces(gap, pair, Friction::new(friction).unwrap())
    };
    NestedHistory::new(Frictional::default(), Grid::new(20, 20, 0.12, 0.12).unwrap(), make).unwrap()
}

/// A single `Break` at any iteration: of the normal solve, of the tangential solve, of Newton's method on
/// both, of the continuation in the coefficient of friction. The state stays as it was, and the next step is
/// the same, bit for bit.
#[test]
fn a_single_break_ends_the_step_and_leaves_the_state() {
    for friction in [0.4, 7.0, 40.0] {
        let to = |xi: f64| Drive::by_shift(Shift { zeta: 0.5, xi, ..Shift::default() });
        let [mut own, mut other] = [history(friction), history(friction)];
        let mut seen = 0_usize;
        let mut starts = 0;
        let mut count = |progress: &Progress| {
            seen += 1;
            starts += usize::from(progress.iteration == 0);
            ControlFlow::Continue(())
        };
        other.step(&to(0.0), &mut ()).unwrap();
        let reached = other.step(&to(0.1), &mut count).unwrap();
        assert_eq!(reached.iterations, seen - starts, "f = {friction}: iterations told and seen");
        own.step(&to(0.0), &mut ()).unwrap();
        let before = own.state().clone();
        let mut ended = 0;
        for last in (1..seen).step_by(1 + seen / 40) {
            let (mut number, mut after) = (0, 0);
            let mut breaks_once = |_: &Progress| {
                number += 1;
                after += usize::from(number > last);
                if number == last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let error = own.step(&to(0.1), &mut breaks_once).unwrap_err();
            let FrictionalError::NotConverged { reached, .. } = &error else { panic!("{error}") };
            assert_eq!(reached.stop, Stop::Observer, "f = {friction}, iteration {last} of {seen}");
            assert_eq!(after, 0, "f = {friction}: {after} iterations after {last} of {seen}");
            assert_eq!(*own.state(), before);
            ended += 1;
        }
        assert!(ended > 10, "{ended}");
        own.step(&to(0.1), &mut ()).unwrap();
        assert_eq!(own.state(), other.state(), "f = {friction}");
    }
}
