//! In another system of units the same impact on a grid has the same numbers, each in its own unit.

use carom_numerical::NumericalImpact;

use crate::units::{SI, SMALL, are_the_same, collision};

/// The duration is that of the history, too.
#[test]
fn an_impact_on_a_grid_is_the_same_in_other_units() {
    let solve = |units| {
        let collision = collision(units, true, 0.4);
        let impact = NumericalImpact::new(&collision).with(12, 32).unwrap();
        let rebound = impact.solve().unwrap().rebound().unwrap().clone();
        let course = impact.history(5).unwrap();
        assert_eq!(course[4].time, rebound.duration);
        assert!(rebound.error_estimate > 1e-6 && rebound.error_estimate < 0.1);
        assert_eq!(rebound.compressions, 1);
        rebound
    };
    are_the_same(&solve(SI), &solve(SMALL), 1e-4);
}
