//! Derivatives of R_x against central differences of the exact impact.

use carom_drawn::{Congruential, Draw as _};
use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
use carom_impact::restitution::Sensitivity;

fn regimes(impact: &ObliqueImpact) -> Vec<Regime> {
    impact.phases().iter().map(|phase| phase.regime).collect()
}

/// R_x, and whether the regimes are these.
fn at(chi: f64, psi: f64, own: &[Regime]) -> (f64, bool) {
    let impact = ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap();
    (impact.restitution(), regimes(&impact) == own)
}

/// The central difference of fourth order along an input, and whether no regime changes within `near` of it.
fn central(chi: f64, psi: f64, along: [f64; 2], own: &[Regime]) -> (f64, bool) {
    let size = along[0] * chi + along[1] * psi;
    let reach = [1.0, chi, 2.0 * chi - 1.0].into_iter().map(|change| (psi - change).abs());
    let step = (1e-5 * size).min(2e-3 * reach.fold(f64::MAX, f64::min));
    let of = |part: f64| at(chi + along[0] * part * step, psi + along[1] * part * step, own);
    let near = 1e-4 * size / step;
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(&of);
    let is_away = [of(-near), a, b, c, d, of(near)].iter().all(|(_, same)| *same);
    ((8.0 * (c.0 - b.0) - (d.0 - a.0)) / (12.0 * step), is_away)
}

/// The tangential velocity after over that before, by the relative changes of the tangential velocity, of friction or the normal
/// velocity, and of the ratio of stiffness.
fn row(groups: Groups, restitution: f64, [by_chi, by_psi]: [f64; 2]) -> [f64; 3] {
    let (of_chi, of_psi) = (groups.chi() * by_chi, groups.psi() * by_psi);
    [restitution + of_psi, of_psi, of_chi + of_psi]
}

#[test]
fn derivatives_are_those_of_ten_thousand_drawn_impacts() {
    let mut draw = Congruential(1);
    let mut left_out = 0;
    for _ in 0..10_000 {
        let groups = Groups::of_spheres(0.8 + 0.7 * draw.part(), 8.0 * draw.part()).unwrap();
        let (chi, psi) = (groups.chi(), groups.psi());
        let own = regimes(&ObliqueImpact::new(groups).unwrap());
        let found = Sensitivity::of(groups).unwrap();
        let (by_chi, one) = central(chi, psi, [1.0, 0.0], &own);
        let (by_psi, two) = central(chi, psi, [0.0, 1.0], &own);
        if !(one && two) {
            left_out += 1;
            continue;
        }
        assert!(!found.is_at_change, "{groups:?}");
        let own = row(groups, found.restitution, [found.by_chi, found.by_psi]);
        let expected = row(groups, found.restitution, [by_chi, by_psi]);
        let largest = expected.into_iter().map(f64::abs).fold(0.0, f64::max);
        for (own, expected) in own.into_iter().zip(expected) {
            assert!((own - expected).abs() <= 1e-7 * largest, "{groups:?}: {own} {expected}");
        }
    }
    // Within 1e-4 of a change of the regimes.
    assert!(left_out <= 50, "{left_out}");
}

#[test]
fn at_a_change_one_side_is_told() {
    // Where sliding throughout begins, psi = 2 chi - 1, it is still sliding.
    let sliding = Sensitivity::of(Groups::new(3.0, 5.0).unwrap()).unwrap();
    assert_eq!([sliding.by_chi, sliding.by_psi], [2.0 / 5.0, -6.0 / 25.0]);
    assert!(!sliding.is_at_change);
    // Sliding at first begins at psi = 1: the derivative of the side without it is that from below.
    let groups = |psi: f64| Groups::new(3.0, psi).unwrap();
    let [at, below] = [1.0, 1.0 - 1e-3].map(|psi| Sensitivity::of(groups(psi)).unwrap());
    assert!(at.is_at_change && !below.is_at_change);
    assert!((at.by_psi - below.by_psi).abs() < 0.05 * below.by_psi.abs(), "{at:?} {below:?}");
}

#[test]
fn without_friction_and_without_slip_the_limits_are_met() {
    let none = Sensitivity::of(Groups::new(3.0, f64::INFINITY).unwrap()).unwrap();
    assert_eq!([none.restitution, none.by_chi, none.by_psi], [-1.0, 0.0, 0.0]);
    let stuck = Sensitivity::of(Groups::new(3.0, 0.0).unwrap()).unwrap();
    let closed = |chi: f64| carom_impact::closed_form::restitution_without_slip(chi);
    let by_chi = (closed(3.0 + 1e-5) - closed(3.0 - 1e-5)) / 2e-5;
    assert!((stuck.by_chi - by_chi).abs() < 1e-7, "{stuck:?} {by_chi}");
    assert!(stuck.by_psi.is_finite());
}
