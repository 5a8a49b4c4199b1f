//! Limits of friction, coupling and steps; invalid input.

use super::common::{alike, hertz, law, law_of, path, shift};
use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, ContactLoad, Dissipative};
use carom_laws::rings::{RingConstants, RingLaw, Tolerance};

fn is_finite(load: &ContactLoad) -> bool {
    [load.f_x, load.f_y, load.f_z, load.m_z].iter().all(|x| x.is_finite())
}

#[test]
fn loads_are_finite_and_within_the_friction_limit_at_all_limits() {
    for kappa in [0.75, 1.0, 1.5] {
        for gamma in [-0.5, -1e-12, 0.0, 0.5, 0.75] {
            for friction in [0.0, 1e-30, 1e-3, 0.3, 2.0, 1e6, 1e30, f64::INFINITY] {
                if gamma > 0.5 && friction > 2.0 {
                    continue; // refused, as the test below shows
                }
                let mut law = law_of::<6, 8>([kappa, gamma, friction], 1e-2);
                let size = if friction == 0.0 { 1.0 } else { friction.min(1.0) };
                let mut path = path(2, 4, 6, [0.5 * size, 0.5 * size]);
                path.push(shift([1e-300, 1e3, 0.0, 0.0]));
                path.push(shift([1e-9, 1e3, 1e-3, 0.0]));
                path.push(shift([1.0, -1e6, 1e-3, 1e6]));
                path.push(shift([-1.0, 0.0, 0.0, 0.0]));
                path.push(shift([1e6, 0.0, 0.0, 0.0]));
                for at in path {
                    let heat = law.dissipation(at);
                    let load = law.advance(at).unwrap();
                    let name = format!("{kappa} {gamma} {friction} {at:?}: {load:?}, heat {heat}");
                    assert!(is_finite(&load) && heat.is_finite() && heat >= 0.0, "{name}");
                    assert!(law.stored_energy().is_finite(), "{name}");
                    let force = load.f_x.hypot(load.f_y);
                    assert!(
                        force <= friction * load.f_z * (1.0 + 1e-9) || load.f_z == force,
                        "{name}"
                    );
                    assert!(
                        load.f_z >= 0.0 && (at.zeta > 0.0 || load == ContactLoad::default()),
                        "{name}"
                    );
                }
            }
        }
    }
}

/// Between them tractions grew by 1.6 % a step: to 1e136 in 20 000 steps at gamma = 3/4 without slip.
#[test]
fn tractions_stay_bounded_where_a_contact_recedes_and_grows_again() {
    for (gamma, friction) in [(0.5, f64::INFINITY), (-0.5, f64::INFINITY), (0.5, 10.0), (0.75, 2.0)]
    {
        let mut law = law_of::<6, 8>([1.5 - f64::abs(gamma), gamma, friction], 1e-2);
        let mut random = Congruential(11);
        let mut greatest = [0.0_f64; 2];
        for k in 0..1000 {
            let approach = 1e-3_f64.powf(random.part());
            law.advance(shift([approach, 0.05 * random.signed(), 0.0, 0.0])).unwrap();
            let all = (0..6).flat_map(|ring| (0..8).map(move |angle| (ring, angle)));
            let tractions = all.map(|(ring, angle)| law.traction(ring, angle).unwrap());
            let most = tractions.map(|[along, around]| along.hypot(around)).fold(0.0, f64::max);
            greatest[k / 500] = greatest[k / 500].max(most);
        }
        assert!(greatest[1] < 2.0 * greatest[0], "{gamma} {friction}: {greatest:?}");
    }
}

#[test]
fn coupling_that_lets_tractions_grow_without_bound_is_refused() {
    let with = |gamma: f64, friction: Friction| {
        let of = RingConstants { c_z: 4.0, radius: 1.0, kappa: 0.75, gamma };
        RingLaw::<6, 8>::from_constants(of, friction, Tolerance::FINE)
    };
    let [two, more] = [2.0, 2.1].map(|f| Friction::new(f).unwrap());
    for gamma in [0.51, -0.51, 0.75] {
        assert!(with(gamma, two).is_ok());
        for friction in [more, Friction::INFINITE] {
            let refused = with(gamma, friction).unwrap_err();
            assert_eq!((refused.field, refused.value), ("gamma", gamma));
        }
    }
    for gamma in [0.5, -0.5] {
        assert!(with(gamma, Friction::INFINITE).is_ok());
    }
}

#[test]
fn without_friction_only_hertzs_force_is_left() {
    let hertz = hertz([2.0, 2.0], [0.0, 0.5]);
    let mut law = law::<6, 8>(&hertz, 0.0, 1e-2);
    let load = law.advance(shift([0.7, 0.3, 0.2, 0.1])).unwrap();
    assert_eq!([load.f_x, load.f_y, load.m_z], [0.0; 3]);
    assert!((load.f_z / hertz.force(0.7) - 1.0).abs() < 1e-14);
}

#[test]
fn vanishing_coupling_is_none() {
    let path = path(3, 5, 8, [0.4, 0.3]);
    let mut loads = [0.0, 1e-9, -1e-9].map(|gamma| {
        let mut law = law_of::<6, 8>([1.2, gamma, 0.3], 1e-6);
        path.iter().map(|at| law.advance(*at).unwrap()).collect::<Vec<_>>()
    });
    let none = std::mem::take(&mut loads[0]);
    for (a, b) in none.iter().zip(&loads[1]).chain(none.iter().zip(&loads[2])) {
        assert!((a.f_x - b.f_x).hypot(a.f_y - b.f_y) + (a.m_z - b.m_z).abs() < 1e-5);
    }
}

#[test]
fn contact_lost_is_forgotten_and_touch_is_met_on_the_way() {
    let fresh = law::<6, 8>(&hertz([2.0, 2.0], [0.0, 0.5]), 0.3, 1e-3);
    let mut law = fresh.clone();
    law.advance(shift([1.0, 0.2, 0.1, 0.3])).unwrap();
    assert_eq!(law.advance(shift([-0.5, 0.4, 0.0, 0.0])).unwrap(), ContactLoad::default());
    // From -0.5 to 1: two thirds of the way in contact.
    let load = law.advance(shift([1.0, 0.1, 0.3, 0.0])).unwrap();
    let mut again = fresh;
    again.advance(shift([0.0, 0.3, 0.1, 0.0])).unwrap();
    let want = again.advance(shift([1.0, 0.1, 0.3, 0.0])).unwrap();
    let off = (load.f_x - want.f_x).hypot(load.f_y - want.f_y);
    assert!(off < 1e-12 && load.f_z > 0.0, "{off:e}");
}

#[test]
fn what_recedes_is_forgotten() {
    let mut law = law::<8, 8>(&alike(0.0), 0.3, 1e-4);
    law.advance(shift([1.0, 0.0, 0.0, 0.0])).unwrap();
    law.advance(shift([1.0, 0.15, 0.0, 0.0])).unwrap();
    // Pulled back to a tenth, pressed again: what came anew has no shift, the rest 0.15 and its slip.
    for k in 1..=30 {
        law.advance(shift([1.0 - 0.03 * f64::from(k), 0.15, 0.0, 0.0])).unwrap();
    }
    let small = law.load();
    for k in 1..=30 {
        law.advance(shift([0.1 + 0.03 * f64::from(k), 0.15, 0.0, 0.0])).unwrap();
    }
    // In the exact memory Phi stays as it is in adhesion without shift.
    assert!((law.load().f_x / small.f_x - 1.0).abs() < 0.02, "{} {}", law.load().f_x, small.f_x);
}

#[test]
fn a_step_to_where_it_is_changes_nothing() {
    let mut law = law::<6, 8>(&hertz([2.0, 2.0], [0.0, 0.5]), 0.3, 1e-2);
    let load = law.advance(shift([1.0, 0.2, 0.1, 0.3])).unwrap();
    assert_eq!(law.advance(law.shift()).unwrap(), load);
    assert_eq!(law.dissipation(law.shift()), 0.0);
}

#[test]
fn bad_input_is_named_and_leaves_the_law_as_it_was() {
    let mut law = law::<6, 8>(&alike(0.3), 0.3, 1e-2);
    let load = law.advance(shift([1.0, 0.1, 0.0, 0.0])).unwrap();
    for (at, field) in [
        ([f64::NAN, 0.0, 0.0, 0.0], "zeta"),
        ([1.0, f64::INFINITY, 0.0, 0.0], "xi"),
        ([1.0, 1e60, 0.0, 0.0], "shift over friction"),
        ([1.0, 0.0, 0.0, 1e60], "twist over friction"),
    ] {
        assert_eq!(law.advance(shift(at)).unwrap_err().field, field);
        assert_eq!(law.load(), load);
        assert_eq!(law.dissipation(shift(at)), 0.0);
    }
    let steel = Material::from_young(208e9, 0.3).unwrap();
    let gap = RelativeCurvature::from_coefficients(1.0, 0.5).unwrap();
    let ellipse = Hertz::new(gap, MaterialPair::new(steel, steel).unwrap()).unwrap();
    let friction = Friction::new(0.3).unwrap();
    let wrong = RingLaw::<6, 8>::new(&ellipse, friction, Tolerance::FINE).unwrap_err();
    assert_eq!(wrong.field, "curvature ratio");
    let good = RingConstants { c_z: 4.0, radius: 1.0, kappa: 1.2, gamma: 0.1 };
    for (bad, field) in [
        (RingConstants { c_z: 0.0, ..good }, "c_z"),
        (RingConstants { radius: f64::NAN, ..good }, "radius"),
        (RingConstants { kappa: 1.6, ..good }, "kappa"),
        (RingConstants { gamma: -0.8, ..good }, "gamma"),
    ] {
        let wrong = RingLaw::<6, 8>::from_constants(bad, friction, Tolerance::FINE).unwrap_err();
        assert_eq!(wrong.field, field);
    }
    assert_eq!(Tolerance::new(0.2).unwrap_err().field, "tolerance");
}
