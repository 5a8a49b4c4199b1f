//! Work equals stored plus dissipated energy on random paths of a twisted contact whose steps are
//! in closed form: growth, constant load and simple receding.
//!
//! The heat is computed from traction times slip, the work from the torque by Gauss quadrature with
//! bisection down to the kinks. `CAROM_BALANCE_STEPS` sets a larger number of steps.

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::torsion::history::{TwistHistory, sliding_limit};

/// Of the largest term of a step, or of the torque of sliding times the step.
const STATED: f64 = 1e-9;
/// Parts into which the work is divided at least, and where these pass a thin ring of a step before unseen.
const PARTS: [u32; 2] = [40, 20_000];

/// Gauss's nodes on (0, 1) and weights, six points, one half.
const GAUSS: [(f64, f64); 3] = [
    (0.033_765_242_898_423_99, 0.085_662_246_189_585_17),
    (0.169_395_306_766_867_74, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_55, 0.233_956_967_286_345_52),
];

/// The mean torque on a part of the straight way to a place.
fn mean(history: &TwistHistory, to: (f64, f64), [low, high]: [f64; 2]) -> f64 {
    let (from, turn) = (history.radius(), history.twist());
    let at = |t: f64| {
        let place = (from + t * (to.0 - from), turn + t * (to.1 - turn));
        history.clone().advance(place.0, place.1).unwrap()
    };
    let part = high - low;
    let both = |node: f64| at(low + node * part) + at(high - node * part);
    GAUSS.iter().map(|(node, weight)| weight * part * both(*node)).sum()
}

fn halved(
    history: &TwistHistory,
    to: (f64, f64),
    [low, high]: [f64; 2],
    whole: f64,
    accuracy: f64,
    left: u32,
) -> f64 {
    let middle = 0.5 * (low + high);
    let halves = [[low, middle], [middle, high]];
    let parts = halves.map(|half| mean(history, to, half));
    let sum = parts[0] + parts[1];
    if (sum - whole).abs() <= accuracy || left == 0 {
        return sum;
    }
    (0..2).map(|i| halved(history, to, halves[i], parts[i], accuracy, left - 1)).sum()
}

fn work(history: &TwistHistory, to: (f64, f64), parts: u32) -> f64 {
    let limit = sliding_limit(history.radius().max(to.0));
    let part = |ends: &[f64]| {
        let ends = [ends[0], ends[1]];
        halved(history, to, ends, mean(history, to, ends), 1e-13 * limit, 30)
    };
    // Thin rings of steps before lie at the rim.
    let rest = (1..=parts).map(|i| f64::from(i) / f64::from(parts));
    let mut ends: Vec<f64> = [0.0, 2e-6, 2e-4, 4e-3].into_iter().chain(rest).collect();
    ends.sort_by(f64::total_cmp);
    ends.windows(2).map(part).sum::<f64>() * (to.1 - history.twist())
}

/// The next place of a contact that has never receded; or, as the last but few, of one that
/// recedes while its twist goes on.
fn next(random: &mut Splitmix, history: &TwistHistory, recedes: f64) -> (f64, f64) {
    let (al, bh) = (history.radius(), history.twist());
    if recedes != 0.0 {
        let less = 0.4 * al * random.part();
        // Back at less than the speed of the edge, or on.
        let back = if bh.abs() > 2.0 * al { 0.9 } else { -0.5 };
        let rate = [0.0, back, -1.0, -4.0 * random.part()][random.below(4)];
        return (al - less, bh - recedes * rate * less);
    }
    let size = al * 10_f64.powf(random.between(-3.0, 1.0));
    let turn = size * random.between(-1.0, 1.0);
    let more = al * random.part() * random.part();
    match random.below(4) {
        0 | 1 => (al, bh + turn),
        2 => (al + more, bh + random.between(-1.0, 1.0) * more),
        _ => (al + more, bh + random.between(1.0, 3.0) * more.copysign(turn)),
    }
}

/// A contact that has just been touched and pressed, and the sense in which it recedes, if it does:
/// that in which it was twisted.
fn fresh(random: &mut Splitmix) -> (TwistHistory, f64) {
    let mut history = TwistHistory::new();
    history.advance(0.5 + random.part(), 0.0).unwrap();
    let recedes = f64::from(random.below(3) as u32) - 1.0;
    if recedes != 0.0 {
        let twist = recedes * 10_f64.powf(random.between(-2.0, 1.0));
        history.advance(history.radius(), twist).unwrap();
    }
    (history, recedes)
}

#[test]
fn work_is_stored_or_dissipated_in_closed_forms() {
    let count = match std::env::var("CAROM_BALANCE_STEPS") {
        Ok(steps) => steps.parse().unwrap(),
        Err(_) => 3_000,
    };
    let mut random = Splitmix(47);
    let (mut history, mut recedes) = fresh(&mut random);
    let mut worst = 0.0_f64;
    for step in 0..count {
        if step % 10 == 0 {
            (history, recedes) = fresh(&mut random);
        }
        let to = next(&mut random, &history, recedes);
        let heat = history.dissipation(to.0, to.1);
        let (before, limit) = (history.stored_energy(), sliding_limit(history.radius().max(to.0)));
        let way = (to.0 - history.radius()).abs() + (to.1 - history.twist()).abs();
        let from = history.clone();
        history.advance(to.0, to.1).unwrap();
        let gained = history.stored_energy() - before;
        let error = |parts: u32| {
            let work = work(&from, to, parts);
            (work - heat - gained).abs() / work.abs().max(before).max(limit * way)
        };
        let mut least = error(PARTS[0]);
        if least > STATED {
            least = error(PARTS[1]);
        }
        worst = worst.max(least);
        assert!(heat >= 0.0 && least < STATED, "{least:e} {heat:e} {from:?} to {to:?}");
    }
    assert_eq!(history.ring_steps(), 0);
    println!("worst {worst:e} of {count}");
}
