//! A twisted contact that has slid to its centre continues like any other.

use approx::assert_relative_eq;
use carom_laws::torsion::history::{TwistHistory, sliding_limit};

/// A contact of radius 1 that has slid through.
fn slid() -> TwistHistory {
    let mut history = TwistHistory::new();
    history.advance(1.0, 0.0).unwrap();
    let torque = history.advance(1.0, 1e4).unwrap();
    assert_relative_eq!(torque, sliding_limit(1.0), max_relative = 1e-12);
    history
}

#[test]
fn it_slides_on() {
    let mut history = slid();
    for twist in [1e4 + 1.0, 2e4, 3e5] {
        let torque = history.advance(1.0, twist).unwrap();
        assert_relative_eq!(torque, sliding_limit(1.0), max_relative = 1e-12);
    }
}

#[test]
fn it_turns_back_by_masings_rule() {
    // M = M_sliding - 2 L(back/2) as on any other way back at constant load.
    for back in [0.01, 0.5, 3.0, 20.0] {
        let mut first = TwistHistory::new();
        first.advance(1.0, 0.0).unwrap();
        let half = first.advance(1.0, 0.5 * back).unwrap();
        let torque = slid().advance(1.0, 1e4 - back).unwrap();
        assert_relative_eq!(torque, sliding_limit(1.0) - 2.0 * half, epsilon = 1e-11);
    }
}

#[test]
fn it_lets_go_step_by_step() {
    let mut history = slid();
    for radius in [0.99, 0.7, 0.2, 1e-3] {
        let torque = history.advance(radius, 1e4).unwrap();
        assert!(torque.abs() <= sliding_limit(radius) * (1.0 + 1e-12), "{radius} {torque}");
    }
    assert_eq!(history.advance(0.0, 1e4).unwrap(), 0.0);
    // And takes hold again.
    let mut grown = slid();
    grown.advance(1.2, 1e4).unwrap();
    assert!(grown.advance(1.2, 1e4 + 0.1).unwrap() <= sliding_limit(1.2));
}
