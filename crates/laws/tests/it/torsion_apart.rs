//! Twisted contacts near complete sliding that recede while the twist reverses, and the energies of
//! all.
//!
//! Reference torques are those of an independent half-space solver, as in `torsion_rings.rs`: fixed
//! rings of one width, 0.06 to 0.015 of the radius, extrapolated.

use carom_drawn::{Draw as _, Splitmix};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::torsion::history::{TwistHistory, sliding_limit};
use carom_laws::torsion::law::{TorsionConstants, TorsionLaw};

/// Torques over that of sliding at the corners of a path of radius and twist, each leg in steps.
fn shares(path: &[(f64, f64)], steps: u32) -> Vec<f64> {
    let mut history = TwistHistory::new();
    let leg = |&(radius, twist): &(f64, f64)| {
        let (from, turn) = (history.radius(), history.twist());
        for i in 1..=steps {
            let t = f64::from(i) / f64::from(steps);
            let (al, bh) = (from + t * (radius - from), turn + t * (twist - turn));
            let (al, bh) = if i == steps { (radius, twist) } else { (al, bh) };
            let torque = history.advance(al, bh).unwrap();
            assert!(torque.abs() <= sliding_limit(al) * (1.0 + 1e-12), "{path:?} {al}: {torque}");
            let energy = history.stored_energy();
            assert!(energy.is_finite(), "{path:?} {steps} {history:?}");
        }
        history.torque() / sliding_limit(radius)
    };
    path.iter().map(leg).collect()
}

#[test]
fn twisting_back_after_sliding_agrees_with_rings() {
    for (path, want) in [
        (vec![(1.0, 0.0), (1.0, 10.0), (0.5, 9.47), (0.2, 9.056)], 0.6508),
        (vec![(1.0, 0.0), (1.0, 3.0), (0.5, 2.47), (0.2, 2.056)], 0.6508),
        (vec![(1.0, 0.0), (1.0, 2.241_962), (0.165_299, 0.983_042)], 0.0888),
        (vec![(1.0, 0.0), (1.0, 10.0), (0.860_708, 9.831_966)], 0.9756),
        (vec![(1.0, 0.0), (1.0, 57.968), (0.270_98, 57.0974), (0.086_101_6, 56.438_53)], -0.9934),
    ] {
        for steps in [1, 13, 100] {
            let got = *shares(&path, steps).last().unwrap();
            assert!((got - want).abs() < 1e-3, "{path:?} in {steps}: {got} {want}");
        }
    }
}

#[test]
fn twisting_back_just_above_the_threshold_stays_near_sliding() {
    for steps in [1, 10, 100] {
        let got = shares(&[(1.0, 0.0), (1.0, 40.0), (0.74, 39.7114)], steps)[2];
        assert!((got - 0.9998).abs() < 1e-3, "{steps}: {got}");
    }
}

#[test]
fn one_step_just_above_the_threshold_is_as_good_as_many() {
    let mut random = Splitmix(101);
    for _ in 0..16 {
        let twist = 10_f64.powf(random.between(-0.3, 2.0));
        let (rate, end) = (random.between(1.05, 1.15), random.between(0.1, 0.95));
        let path = [(1.0, 0.0), (1.0, twist), (end, twist - rate * (1.0 - end))];
        let [one, few, many] = [1, 30, 300].map(|steps| shares(&path, steps)[2]);
        assert!((one - many).abs() < 1e-3 && (few - many).abs() < 1e-3, "{path:?} {one} {many}");
    }
}

/// A path of steps of every kind: growing, receding, there and back, with ties and closed loops.
fn random_path(random: &mut Splitmix, deepest: f64) -> Vec<(f64, f64)> {
    let (mut al, mut bh): (f64, f64) = (1.0, 0.0);
    let mut path = vec![(al, bh)];
    let size = 10_f64.powf(random.between(-0.5, 3.0));
    for _ in 0..5 {
        let (last, turn) = (al, bh);
        match random.below(5) {
            0 => bh += size * random.between(-1.0, 1.0),
            1 => al *= 1.0 + random.part(),
            2 => bh = path[path.len() / 2].1,
            _ => al = (al * 10_f64.powf(-random.part() * random.part() * 6.0)).max(deepest),
        }
        if al != last {
            let rates = [0.0, 0.5, 1.0, 1.05, 1.2, 1.5, 2.0, 3.0, 8.0];
            let rate = rates[random.below(rates.len())];
            bh = turn - rate * (al - last).abs() * 1.0_f64.copysign(turn);
        }
        path.push((al, bh));
    }
    path
}

#[test]
fn one_step_is_as_good_as_many() {
    let mut random = Splitmix(77);
    let mut worst = 0.0_f64;
    for _ in 0..60 {
        let path = random_path(&mut random, 1e-6);
        let (one, many) = (shares(&path, 1), shares(&path, 60));
        for (one, many) in one.iter().zip(&many) {
            worst = worst.max((one - many).abs());
            assert!((one - many).abs() < 1e-3, "{path:?}: {one} {many}");
        }
    }
    assert!(worst > 0.0);
}

/// What work, stored energy and heat of a path leave over, over the work and heat of sliding.
fn energy_gap(path: &[(f64, f64)], steps: u32) -> (f64, u32) {
    // Gauss on each step, three points: loads are smooth but where loops close.
    let third = 0.6_f64.sqrt();
    let nodes =
        [(0.5 - 0.5 * third, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.5 + 0.5 * third, 5.0 / 18.0)];
    let mut history = TwistHistory::new();
    let (mut work, mut heat, mut most) = (0.0, 0.0, 0.0);
    for &(radius, twist) in path {
        let (from, turn) = (history.radius(), history.twist());
        for i in 0..steps {
            let at = |t: f64| {
                let part = (f64::from(i) + t) / f64::from(steps);
                (from + part * (radius - from), turn + part * (twist - turn))
            };
            let (al, bh) = at(1.0);
            heat += history.dissipation(al, bh);
            let way = bh - history.twist();
            for (node, weight) in nodes {
                let mut probe = history.clone();
                let (al, bh) = at(node);
                work += weight * way * probe.advance(al, bh).unwrap();
            }
            history.advance(al, bh).unwrap();
            most += way.abs() * sliding_limit(al.max(from));
        }
    }
    let gap: f64 = work - heat - history.stored_energy();
    (gap.abs() / most.max(sliding_limit(1.0)), history.ring_steps())
}

#[test]
fn work_is_stored_or_dissipated() {
    // Exact ways: constant load, growth in adhesion and slip, and letting go.
    let path = [(1.0, 0.4), (1.0, 1.1), (1.3, 1.3), (1.5, 1.9), (1.5, 1.0)];
    let (gap, rings) = energy_gap(&path, 40);
    assert!(gap < 1e-6 && rings == 0, "{gap:e} {rings}");
    let (gap, rings) = energy_gap(&[(0.5, 0.3), (1.0, 1.3), (2.0, 4.0), (0.5, 4.2)], 40);
    assert!(gap < 1e-9 && rings == 0, "{gap:e} {rings}");
    // With rings, to their width.
    for path in [
        [(1.0, 0.0), (1.0, 0.6), (0.8, 0.36)],
        [(1.0, 0.0), (1.0, 3.0), (0.5, 2.3)],
        [(1.0, 0.0), (1.0, 40.0), (0.3, 39.0)],
    ] {
        let (gap, rings) = energy_gap(&path, 20);
        assert!(gap < 1e-3 && rings > 0, "{path:?}: {gap:e}");
    }
}

/// No part of a contact sticks that is none, however the bodies were pressed and twisted before.
#[test]
fn separated_bodies_have_no_stick_radius() {
    let pair = MaterialPair::new(Material::from_shear(1.0, 0.3).unwrap(), Material::RIGID).unwrap();
    let gap = RelativeCurvature::from_coefficients(0.5, 0.5).unwrap();
    let hertz = Hertz::new(gap, pair).unwrap();
    for friction in [0.0, 0.4, f64::INFINITY] {
        let mut law = TorsionLaw::new(&hertz, Friction::new(friction).unwrap()).unwrap();
        assert_eq!(law.stick_radius(), 0.0);
        law.advance(Shift { zeta: 1.0, omega: 0.2, ..Shift::default() }).unwrap();
        assert_eq!(law.stick_radius() > 0.0, friction > 0.0);
        for zeta in [0.0, -0.3] {
            let mut apart = law.clone();
            apart.advance(Shift { zeta, omega: 0.1, ..Shift::default() }).unwrap();
            assert_eq!(apart.stick_radius(), 0.0, "f = {friction}, zeta = {zeta}");
        }
    }
}

/// Steps by many orders of magnitude were divided in proportion to the radius and took seconds. What the smaller contact
/// remembers does not count.
#[test]
fn a_step_to_or_from_a_tiny_contact_is_one_by_the_last_of_its_orders() {
    let mut back = TwistHistory::new();
    for (radius, twist) in [(1.0, 0.0), (1.0, 3.0), (1.0, -0.5), (0.9, 0.4)] {
        back.advance(radius, twist).unwrap();
    }
    let twist_at = |radius: f64| 0.4 + 1.3 * (0.9 - radius);
    let heat_to = |radii: &[f64]| -> f64 {
        let mut history = back.clone();
        let heat = |radius: &f64| {
            let heat = history.dissipation(*radius, twist_at(*radius));
            history.advance(*radius, twist_at(*radius)).unwrap();
            assert!(history.torque().abs() <= sliding_limit(*radius));
            heat
        };
        radii.iter().map(heat).sum()
    };
    // What a contact of 2e-3 has left is of the order of its fifth power.
    let (near, on) = (heat_to(&[2e-3]), heat_to(&[2e-3, 1e-60]));
    assert!(near > 0.01 && (on / near - 1.0).abs() < 1e-8, "{on} {near}");
    // The heat of rings is right to 1e-3 in steps of any length.
    let far = heat_to(&[1e-60]);
    let radii: Vec<f64> = (1..=400).map(|k| 0.9 - 0.898 * f64::from(k) / 400.0).collect();
    let by_steps = heat_to(&radii);
    assert!((far / by_steps - 1.0).abs() < 1e-3, "{far} {by_steps}");
    // And back: the path from the tiny contact is that from first contact.
    let mut tiny = back.clone();
    for k in 1..=30 {
        let radius = 0.9 * 0.1_f64.powi(k);
        tiny.advance(radius, twist_at(radius)).unwrap();
    }
    let mut fresh = TwistHistory::new();
    fresh.advance(0.0, tiny.twist()).unwrap();
    for history in [&mut tiny, &mut fresh] {
        history.advance(1.0, 4.0).unwrap();
    }
    assert!((tiny.torque() - fresh.torque()).abs() < 1e-11, "{tiny:?} {fresh:?}");
}

/// After a twist of 1e25 the rest of it is rounding, and so was the torque of a contact that recedes: it exceeded that of
/// sliding. The fuzzer found it.
#[test]
fn the_torque_after_a_vast_twist_is_at_most_that_of_sliding() {
    let constants = TorsionConstants { c_z: 1.2, stiffness: 1.3, arm: 0.6 };
    let mut law = TorsionLaw::from_constants(constants, Friction::new(0.3).unwrap()).unwrap();
    let vast = 2.325_765_513_201_874e25;
    for (zeta, omega) in [
        (1.0, 0.0),
        (0.0, 0.0),
        (0.007_720_947_265_625, 0.0),
        (0.246_002_197_265_625, 0.0),
        (1.890_625, 0.0),
        (1.890_625, vast),
        (0.002_319_335_937_5, vast),
        (0.957_031_25, vast),
    ] {
        let load = law.advance(Shift { zeta, omega, ..Shift::default() }).unwrap();
        let limit = 0.3 * load.f_z * 0.6 * zeta.sqrt();
        assert!(load.m_z.abs() <= limit * (1.0 + 1e-12), "{zeta}: {} {limit}", load.m_z);
    }
}

/// A first contact that turns a thousand radii slides as a whole, and its torque has the sign of the turning. It took
/// the sign of the twist, and had no densities if that became zero; the next step panicked.
#[test]
fn a_first_contact_that_turns_far_slides_the_way_it_turns() {
    let torque = |from: f64, to: f64| {
        let mut history = TwistHistory::new();
        history.advance(0.0, from).unwrap();
        let torque = history.advance(1e-3, to).unwrap();
        history.advance(0.9e-3, to + 1e-5).unwrap();
        history.advance(1.1e-3, to - 1e-5).unwrap();
        torque
    };
    let forth = torque(0.0, 1.0);
    assert!(forth > 0.0);
    for (from, to) in [(1.0, 0.0), (2.0, 1.0), (-1.0, -2.0)] {
        assert!((torque(from, to) + forth).abs() <= 1e-12 * forth, "{from} {to}");
        assert!((torque(-from, -to) - forth).abs() <= 1e-12 * forth, "{from} {to}");
    }
}
