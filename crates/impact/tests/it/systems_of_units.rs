//! In another system of units the same impact has the same numbers, each in its own unit.

use crate::units::{SI, SMALL, are_the_same, collision};

#[test]
fn an_impact_is_the_same_in_other_units() {
    for (round, unlike) in [(true, 0.22), (true, 0.4), (false, 0.22)] {
        let solve = |units| {
            let outcome = collision(units, round, unlike).solve().unwrap();
            outcome.rebound().unwrap().clone()
        };
        are_the_same(&solve(SI), &solve(SMALL), if round { 1e-11 } else { 1e-6 });
    }
}
