//! The heat of twist steps: compared with closed forms and with many small steps on the same path,
//! and 0 without slip.
//!
//! `CAROM_HEAT_STEPS` sets a larger number of random steps, each made at once and in a thousand
//! parts.

use std::f64::consts::PI;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use carom_drawn::{Draw as _, Splitmix};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::accounted::Accounted;
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::grains::{GrainTwist, Heats, Meeting};
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Dissipative as _, Energies as _, Shift};
use carom_laws::torsion::adhesion::AdhesiveTorsion;
use carom_laws::torsion::history::{TwistHistory, sliding_limit};
use carom_laws::torsion::law::TorsionLaw;
use carom_laws::torsion::lubkin::Lubkin;
use carom_special::quadrature::GaussLegendre;

/// The error that [`TwistHistory::dissipation`] states, over the torque of sliding times the step.
const STATED: f64 = 1e-9;

/// A contact pressed to the radius 1 and twisted to `twist`.
fn pressed_and_twisted(twist: f64) -> TwistHistory {
    let mut history = TwistHistory::new();
    history.advance(1.0, 0.0).unwrap();
    history.advance(1.0, twist).unwrap();
    history
}

/// The torque of sliding times the step, and the rounding of its twists over that.
fn scale(history: &TwistHistory, to: (f64, f64)) -> (f64, f64) {
    let limit = sliding_limit(history.radius().max(to.0));
    let step = (to.0 - history.radius()).abs() + (to.1 - history.twist()).abs();
    let largest = history.twist().abs().max(to.1.abs()) + history.radius().max(to.0);
    (limit * step, 8.0 * f64::EPSILON * largest / step)
}

/// A step in so many parts; the sum of their heats.
fn in_parts(history: &mut TwistHistory, to: (f64, f64), parts: u32) -> f64 {
    let (radius, twist) = (history.radius(), history.twist());
    (1..=parts)
        .map(|i| {
            let part = f64::from(i) / f64::from(parts);
            let next = (radius + part * (to.0 - radius), twist + part * (to.1 - twist));
            let next = if i == parts { to } else { next };
            let heat = history.dissipation(next.0, next.1);
            history.advance(next.0, next.1).unwrap();
            heat
        })
        .sum()
}

/// The heats by twist and by growth of a contact that slides through:
/// `(6/pi) int_0^1 s^2 (K - E) ds = 3 pi/32` and `(12/pi^2) int_0^1 s^2 (K - E) K ds`.
const BY_TWIST: f64 = 3.0 * PI / 32.0;
const BY_GROWTH: f64 = 0.396_944_474_156_869_1;

#[test]
fn growth_after_a_long_slide_dissipates_what_sliding_friction_takes() {
    // The stick area is below 1e-6 throughout: the friction does the work of the torque of sliding,
    // less what the growing contact stores.
    for (slide, radius, twist) in [
        (100.0, 1.4, 130.0),
        (100.0, 1.2, 120.0),
        (100.0, 1.4, 120.0),
        (100.0, 1.4, 200.0),
        (1000.0, 1.05, 1002.0),
        (1000.0, 2.0, 1900.0),
    ] {
        let history = pressed_and_twisted(slide);
        let heat = history.dissipation(radius, twist);
        let mean = (f64::powi(radius, 5) - 1.0) / 5.0;
        let want = mean * (BY_TWIST * (twist - slide) / (radius - 1.0) - BY_GROWTH);
        let (scale, rounding) = scale(&history, (radius, twist));
        let error = (heat - want).abs() / scale;
        assert!(error < 1e-12 + rounding, "{slide} to {radius}, {twist}: {heat} for {want}");
    }
}

/// A step of a random size and kind of a contact that has never receded: the same load, growth and adhesion,
/// growth and slip.
fn next(random: &mut Splitmix, history: &TwistHistory, turned: &mut Vec<f64>) -> (f64, f64) {
    let (al, bh) = (history.radius(), history.twist());
    let turn = al * 10_f64.powf(random.between(-4.0, 1.0)) * random.between(-1.0, 1.0);
    let long = al * 10_f64.powf(random.between(0.5, 3.0)) * random.between(-1.0, 1.0).signum();
    let more = al * random.between(0.05, 1.0);
    turned.push(bh);
    match random.below(9) {
        0 | 1 => (al, bh + turn),
        2 => (al, bh + long),
        // Back to a place of before: a loop is closed.
        3 | 4 => (al, turned[random.below(turned.len())]),
        5 => (al + more, bh + random.between(-1.0, 1.0) * more),
        6 => (al + more, bh + random.between(1.0, 3.0) * more.copysign(turn)),
        7 => (al + more, bh + 0.3 * long),
        _ => (al + 1e-3 * turn.abs(), bh + turn),
    }
}

/// The next place of a contact that was twisted once and recedes while the twist rests, goes on, or turns back
/// more slowly than its edge moves.
fn lifted(random: &mut Splitmix, history: &TwistHistory, sense: f64) -> (f64, f64) {
    let (al, bh) = (history.radius(), history.twist());
    let less = al * random.between(0.001, 0.4);
    let back = if bh.abs() > 2.0 * al { 0.9 } else { -0.5 };
    let rate = [0.0, back, -1.0, -10_f64.powf(random.between(-1.0, 2.0))][random.below(4)];
    (al - less, bh - sense * rate * less)
}

/// A contact from touch, pressed and twisted at once.
fn touched(random: &mut Splitmix) -> TwistHistory {
    let mut history = TwistHistory::new();
    let radius = 0.3 + random.part();
    let rate = [0.0, 0.7, 1.5, 40.0][random.below(4)];
    let one = history.dissipation(radius, rate * radius);
    let many = in_parts(&mut history, (radius, rate * radius), 100);
    let tolerance = STATED * sliding_limit(radius) * (1.0 + rate) * radius;
    assert!((one - many).abs() < tolerance, "{rate}: {one:e} {many:e}");
    assert!(rate > 1.0 || (one == 0.0 && many == 0.0));
    history
}

#[test]
fn the_heat_of_one_step_is_that_of_a_thousand_on_random_ways() {
    let count = match std::env::var("CAROM_HEAT_STEPS") {
        Ok(steps) => steps.parse().unwrap(),
        Err(_) => 400,
    };
    let mut random = Splitmix(24);
    let (mut history, mut turned, mut lifts) = (TwistHistory::new(), Vec::new(), None);
    let mut worst = 0.0_f64;
    for step in 0..count {
        if step % 8 == 0 {
            lifts = (random.below(3) == 0).then(|| random.between(-1.0, 1.0).signum());
            turned.clear();
            history = match lifts {
                Some(sense) => pressed_and_twisted(sense * 10_f64.powf(random.between(-2.0, 3.0))),
                None => touched(&mut random),
            };
        }
        let to = match lifts {
            Some(sense) => lifted(&mut random, &history, sense),
            None => next(&mut random, &history, &mut turned),
        };
        let (before, (scale, rounding)) = (history.clone(), scale(&history, to));
        let one = history.dissipation(to.0, to.1);
        let many = in_parts(&mut history, to, 1000);
        assert!(one >= 0.0 && many >= 0.0, "{one:e}: {before:?} to {to:?}");
        if scale == 0.0 {
            assert_eq!((one, many), (0.0, 0.0));
            continue;
        }
        let error = ((one - many).abs() / scale - rounding).max(0.0);
        worst = worst.max(error);
        assert!(error < STATED, "{error:e}: {one:e} for {many:e}, {before:?} to {to:?}");
        // The thousand steps round a thousand twists.
        history = before;
        history.advance(to.0, to.1).unwrap();
    }
    println!("worst {worst:e} of {count}");
    assert_eq!(history.ring_steps(), 0);
}

#[test]
fn a_loop_dissipates_its_area() {
    // Masing's rule: from A to -A and back, 8 int_0^A M dbeta - 4 A M(A), with Lubkin's first loading.
    // mu is half of M/(f F_z a) and bh 8/3 of its twist.
    let rule = GaussLegendre::new(120).unwrap();
    for twist in [0.01, 0.1, 0.5, 3.0] {
        let torque = |twist: f64| Lubkin::at_twist(twist).unwrap().torque();
        // The torque is steep at rest and flat after: the square keeps nodes there.
        let sum = rule.integrate(0.0, 1.0, |x| 2.0 * x * twist * torque(twist * x * x));
        let area = 8.0 * sum - 4.0 * twist * torque(twist);
        let turn = 8.0 / 3.0 * twist;
        let history = pressed_and_twisted(turn);
        let mut back = history.clone();
        back.advance(1.0, -turn).unwrap();
        let first = history.dissipation(1.0, -turn);
        let second = back.dissipation(1.0, turn);
        let tolerance = 1e-11 * turn;
        assert_abs_diff_eq!(first, 0.5 * area * 4.0 / 3.0, epsilon = tolerance);
        assert_abs_diff_eq!(second, first, epsilon = tolerance);
        // In the first twist the rings slip half as far.
        let from_rest = pressed_and_twisted(0.0).dissipation(1.0, turn);
        assert_abs_diff_eq!(from_rest, 0.5 * first, epsilon = tolerance);
    }
}

#[test]
fn a_separation_releases_what_is_stored() {
    for twist in [0.3, 2.0, 50.0] {
        let history = pressed_and_twisted(twist);
        let stored = history.stored_energy();
        assert_relative_eq!(history.dissipation(0.0, twist), stored, max_relative = 1e-14);
        // Turned on by little the work is little.
        let on = history.dissipation(0.0, twist + 1e-6);
        assert_abs_diff_eq!(on, stored, epsilon = 2e-3 * stored + 1e-6);
    }
}

/// The law of a rubber foot on a hard floor, of 20 mm radius.
fn foot(friction: f64) -> (Hertz, TorsionLaw) {
    let rubber = Material::from_shear(1e6, 0.5).unwrap();
    let gap = RelativeCurvature::from_coefficients(25.0, 25.0).unwrap();
    let hertz = Hertz::new(gap, MaterialPair::new(rubber, Material::RIGID).unwrap()).unwrap();
    let law = TorsionLaw::new(&hertz, Friction::new(friction).unwrap()).unwrap();
    (hertz, law)
}

fn at(zeta: f64, omega: f64) -> Shift {
    Shift { zeta, omega, ..Shift::default() }
}

/// A step in so many parts on the law's own way, straight in the root of the approach.
fn parts_of(law: &mut TorsionLaw, to: Shift, parts: u32) -> f64 {
    let (from, mut heat) = (law.shift(), 0.0);
    let ends = [from.zeta, to.zeta].map(f64::sqrt);
    for i in 1..=parts {
        let part = f64::from(i) / f64::from(parts);
        let root = ends[0] + part * (ends[1] - ends[0]);
        let next = at(root * root, from.omega + part * (to.omega - from.omega));
        let next = if i == parts { to } else { next };
        heat += law.dissipation(next);
        law.advance(next).unwrap();
    }
    heat
}

#[test]
fn one_step_from_touch_that_does_not_slip_makes_no_heat_at_any_friction() {
    // The first step of a foot that is pressed down and twisted at once.
    let (zeta, omega) = (1e-4, 0.02);
    for friction in [0.5, 1e3, 1e30, f64::INFINITY] {
        let (hertz, law) = foot(friction);
        let mut law = Accounted::new(law);
        law.advance(Shift::default()).unwrap();
        let torque = law.advance(at(zeta, omega)).unwrap().m_z;
        assert_eq!(law.dissipated(), 0.0, "{friction}");
        let ellipse = hertz.ellipse(zeta).unwrap();
        let stiffness = AdhesiveTorsion::new(ellipse, hertz.materials()).stiffness();
        // int K dOmega with K ~ a^3 and Omega ~ a.
        assert_relative_eq!(torque, 0.25 * stiffness * omega, max_relative = 1e-12);
    }
}

#[test]
fn a_growing_friction_tends_to_infinite_friction() {
    // Pressed and twisted together, twisted, lifted, pressed again and separated.
    let path = [(1e-4, 0.02), (1e-4, 0.05), (4e-5, 0.04), (9e-5, 0.06), (2e-5, 0.06), (-1e-5, 0.0)];
    let ends = |friction: f64| {
        let mut law = Accounted::new(foot(friction).1);
        let told = |(zeta, omega)| {
            let torque = law.advance(at(zeta, omega)).unwrap().m_z;
            [torque, law.law().twist_energy(), law.dissipated()]
        };
        path.map(told)
    };
    let stuck = ends(f64::INFINITY);
    assert!(stuck[2][2] > 0.0 && stuck[5][2] > stuck[4][2]);
    let largest = |column: usize| stuck.iter().map(|row| row[column].abs()).fold(0.0, f64::max);
    let scales = [0, 1, 2].map(largest);
    let mut holds = true;
    for (friction, accuracy) in [(1e3, 1e-3), (1e6, 1e-5), (1e9, 1e-4), (1e13, 1e-9), (1e30, 1e-9)]
    {
        let mut worst = 0.0_f64;
        for (got, want) in ends(friction).into_iter().zip(stuck) {
            for ((got, want), scale) in got.into_iter().zip(want).zip(scales) {
                worst = worst.max((got - want).abs() / scale);
            }
        }
        println!("{friction:e}: {worst:e}");
        holds &= worst < accuracy;
    }
    assert!(holds);
}

#[test]
fn a_step_of_press_and_twist_makes_the_heat_of_a_thousand() {
    for friction in [0.05, 0.5, 1e3] {
        let mut law = foot(friction).1;
        law.advance(at(5e-5, 0.0)).unwrap();
        for to in [at(1e-4, 0.02), at(1e-4, -0.4), at(2e-4, 3.0), at(1e-4, 3.1)] {
            let one = law.dissipation(to);
            let before = law.load().m_z.abs();
            let many = parts_of(&mut law, to, 1000);
            let limit = before.max(law.load().m_z.abs());
            let step = limit * (to.omega.abs() + 0.4);
            assert!((one - many).abs() <= STATED * step, "{friction}: {one:e} for {many:e}");
        }
    }
}

#[test]
fn work_is_stored_or_dissipated_until_the_bodies_are_apart() {
    // Books of the twist alone, the work by the trapezium rule on the law's own way.
    for friction in [0.1, 0.5, f64::INFINITY] {
        let mut law = Accounted::new(foot(friction).1);
        let mut work = 0.0;
        for to in [at(1e-4, 0.0), at(1e-4, 0.3), at(2e-4, 0.5), at(1.5e-4, -0.1), at(1e-6, -0.1)] {
            let (from, n) = (law.shift(), 4000);
            for i in 1..=n {
                let part = f64::from(i) / f64::from(n);
                let root = from.zeta.sqrt() + part * (to.zeta.sqrt() - from.zeta.sqrt());
                let (m_z, omega) = (law.load().m_z, law.shift().omega);
                let next = at(root * root, from.omega + part * (to.omega - from.omega));
                let load = law.advance(next).unwrap();
                work += 0.5 * (m_z + load.m_z) * (next.omega - omega);
            }
        }
        law.advance(at(-1e-4, -0.1)).unwrap();
        assert_eq!(law.law().twist_energy(), 0.0);
        assert_relative_eq!(law.dissipated(), work, max_relative = 1e-5);
    }
}

#[test]
fn the_heat_of_two_grains_that_twist_is_that_of_their_law() {
    let mut twist = GrainTwist::new(foot(0.5).1);
    let meeting = |zeta: f64, velocity: f64, spin: f64| Meeting {
        normal: [0.0, 0.0, 1.0],
        zeta,
        arms: [0.02, 0.0],
        velocity: [0.0, 0.0, velocity],
        shares: [0.5; 2],
        spins: [[0.0; 3], [0.0, 0.0, spin]],
        masses: [1.0, f64::INFINITY],
        axis: None,
    };
    // They touch in the middle of the first step and twist in adhesion; they separate in the last.
    let steps = [(1e-4, 0.2, 4.0), (1e-4, 0.0, 300.0), (8e-5, -0.02, -100.0), (-1e-5, -0.09, 20.0)];
    for (i, (zeta, velocity, spin)) in steps.into_iter().enumerate() {
        let mut before = twist.law().clone();
        if i == 0 {
            before.advance(at(-1e-4, 0.0)).unwrap();
        }
        let mut heats = Heats::default();
        twist.advance_accounted(&meeting(zeta, velocity, spin), 1e-3, &mut heats).unwrap();
        assert_eq!(heats.friction, before.dissipation(twist.law().shift()));
        assert_eq!(heats.friction > 0.0, i > 0);
        assert_eq!(heats.damping, 0.0);
    }
    assert_eq!(twist.law().twist_energy(), 0.0);
}
