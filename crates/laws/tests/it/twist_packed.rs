//! The memory of a twist stored as plain numbers.

use carom_drawn::{Draw as _, Splitmix};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Dissipative as _, Shift};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::torsion::history::{TwistHistory, packed_numbers, sliding_limit};
use carom_laws::torsion::law::{self, ShiftTwistLaw, TorsionLaw};
use carom_special::AxisRatio;
use carom_special::elliptic::complete;

/// Steps of radius and twist: presses, turns, recedes, parts and touches again.
fn path(random: &mut Splitmix, steps: usize) -> Vec<[f64; 2]> {
    let (mut radius, mut twist) = (1.0, 0.0);
    let mut path = vec![[radius, twist]];
    for _ in 0..steps {
        if random.part() < 0.6 {
            radius *= 0.8 + 0.4 * random.part();
        }
        twist += 1.5 * (2.0 * random.part() - 1.0) * radius;
        if random.part() < 0.03 {
            path.push([0.0, twist]);
            radius = random.part();
        }
        path.push([radius, twist]);
    }
    path
}

#[test]
fn a_history_that_was_kept_goes_on_to_the_same_bits() {
    let mut random = Splitmix(7);
    let mut numbers = vec![0.0; packed_numbers(2000)];
    let mut rings = 0;
    for _ in 0..15 {
        let mut one = TwistHistory::new();
        let mut other = TwistHistory::with_ring_width(0.1).unwrap();
        for [radius, twist] in path(&mut random, 40) {
            one.advance(radius, twist).unwrap();
            assert_eq!(one.pack(&mut numbers).unwrap(), 0.0);
            assert_eq!(one.pieces(), numbers[1] as usize);
            other.unpack(&numbers).unwrap();
            assert_eq!(one, other);
        }
        rings += one.ring_steps();
    }
    assert!(rings > 5, "{rings}");
}

/// What little room costs: each state is kept in so many pieces after every step.
#[test]
fn a_history_in_little_room_stays_close() {
    for (pieces, mean, largest) in
        [(4, 0.015, 0.6), (8, 1e-3, 0.06), (16, 1.5e-4, 0.012), (32, 2e-5, 2e-3)]
    {
        let mut random = Splitmix(11);
        let mut numbers = vec![0.0; packed_numbers(pieces)];
        let (mut sum, mut count, mut worst): (f64, f64, f64) = (0.0, 0.0, 0.0);
        for _ in 0..25 {
            let (mut exact, mut kept) = (TwistHistory::new(), TwistHistory::new());
            for [radius, twist] in path(&mut random, 40) {
                let torque = exact.advance(radius, twist).unwrap();
                let own = kept.advance(radius, twist).unwrap();
                assert!(own.abs() <= sliding_limit(radius));
                if radius > 0.0 {
                    let off = (own - torque).abs() / sliding_limit(radius);
                    (sum, count, worst) = (sum + off, count + 1.0, worst.max(off));
                }
                kept.pack(&mut numbers).unwrap();
                kept.unpack(&numbers).unwrap();
                assert_eq!(kept.torque(), own);
            }
        }
        println!("{pieces} pieces: mean {:.1e}, largest {worst:.1e}", sum / count);
        assert!(sum / count <= mean && worst <= largest, "{pieces} {:e} {worst:e}", sum / count);
    }
}

fn hertz() -> Hertz {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let gap = RelativeCurvature::from_coefficients(0.5, 0.8).unwrap();
    Hertz::new(gap, MaterialPair::new(body, body).unwrap()).unwrap()
}

#[test]
fn laws_go_on_from_their_numbers() {
    for friction in [0.0, 0.3, f64::INFINITY] {
        let friction = Friction::new(friction).unwrap();
        let fresh = TorsionLaw::new(&hertz(), friction).unwrap();
        let both = ShiftTwistLaw::new(&hertz(), friction).unwrap();
        let (mut law, mut pair) = (fresh.clone(), both.clone());
        let mut numbers = [0.0; law::packed_numbers(40)];
        let mut of_shift = [0.0; 400];
        for (zeta, xi, omega) in [
            (-0.1, 0.0, 0.3),
            (0.01, 0.0, 0.4),
            (0.012, 1e-3, 0.0),
            (0.009, -2e-3, 0.5),
            (0.0, 0.0, 0.1),
        ] {
            let shift = Shift { zeta, xi, eta: 0.5 * xi, omega };
            let load = law.advance(shift).unwrap();
            assert_eq!(law.pack(&mut numbers).unwrap(), 0.0);
            let mut again = fresh.clone();
            again.unpack(&numbers).unwrap();
            assert_eq!((again.load(), again.shift()), (load, shift));
            assert_eq!(again.stored_energy(), law.stored_energy());
            pair.advance(shift).unwrap();
            pair.tangential().pack(&mut of_shift).unwrap();
            let mut shifted = ShiftLaw::<[f64; 2]>::new(hertz().stiffness(), friction);
            shifted.unpack(&of_shift).unwrap();
            let joined = ShiftTwistLaw::of(shifted, again).unwrap();
            assert!((joined.load().f_x - pair.load().f_x).abs() <= 1e-13 * load.f_z);
            assert_eq!(joined.load().m_z, pair.load().m_z);
            assert_eq!(joined.shift().omega, omega);
        }
    }
}

#[test]
fn numbers_that_are_no_state_are_refused() {
    let mut history = TwistHistory::new();
    let mut numbers = [0.0; packed_numbers(4)];
    history.unpack(&numbers).unwrap();
    assert_eq!(history, TwistHistory::new());
    for step in [[1.0, 0.0], [1.0, 0.4], [0.9, 0.2]] {
        history.advance(step[0], step[1]).unwrap();
    }
    assert_eq!(history.pack(&mut [0.0; packed_numbers(4) - 1]).unwrap_err().field, "numbers");
    history.pack(&mut numbers).unwrap();
    let before = history.clone();
    // The outermost piece slid at a radius of at least 0.9, where the contact ends.
    let outermost = 7 + 6 * (history.pieces() - 1);
    assert!(numbers[outermost] < 0.89 && numbers[outermost + 1] >= 0.9);
    for (place, value, field) in [
        (outermost + 1, 0.89, "slip radius"),
        (0, 2e4, "mark"),
        (0, 50_007.0, "mark"),
        (0, f64::NAN, "mark"),
        (1, 5.0, "pieces"),
        (1, 0.5, "pieces"),
        (1, f64::NAN, "pieces"),
        (2, 0.0, "radius"),
        (2, f64::INFINITY, "radius"),
        (5, 2.0, "stick radius"),
        (5, 0.0, "stick radius"),
        (6, -1.0, "ring steps"),
        (7, 1.5, "piece"),
        (7, 0.1, "piece"),
        (13, 0.0, "piece"),
        (8, 1.0, "slip radius"),
        (8, -1.0, "slip radius"),
    ] {
        let mut wrong = numbers;
        wrong[place] = value;
        let error = history.unpack(&wrong).unwrap_err();
        assert_eq!((error.field, &history), (field, &before), "{place} {value}");
    }
    assert_eq!(history.unpack(&numbers[..6]).unwrap_err().field, "numbers");
}

/// Rings of every width are kept, the narrowest and the widest too.
#[test]
fn the_width_of_rings_is_kept() {
    for width in [1.0 / 256.0, 1.0 / 64.0, 1.0 / 4.0] {
        let mut history = TwistHistory::with_ring_width(width).unwrap();
        history.advance(1.0, 0.4).unwrap();
        let (mut numbers, mut read) = ([0.0; packed_numbers(4)], TwistHistory::new());
        history.pack(&mut numbers).unwrap();
        read.unpack(&numbers).unwrap();
        assert_eq!(read, history, "{width}");
    }
}

#[test]
fn a_step_that_fails_before_the_touch_leaves_the_twist_as_it_was() {
    let mut law = TorsionLaw::new(&hertz(), Friction::new(0.3).unwrap()).unwrap();
    law.advance(Shift { zeta: -0.1, omega: 0.2, ..Shift::default() }).unwrap();
    let before = law.clone();
    let far = Shift { zeta: 1e130, omega: 0.3, ..Shift::default() };
    assert_eq!(law.advance(far).unwrap_err().field, "zeta");
    assert_eq!(law, before);
}

/// A piece says at which contact radius sliding covers its density: `|b(s)| <= (2/pi) E(k)/k'`, k' = s over
/// that radius; beyond it, 1 is within friction at any radius. What was joined for want of room says so too, or a later step would take it for within friction.
#[test]
fn a_joined_piece_stays_within_the_friction_it_asks_for() {
    let mut random = Splitmix(23);
    let mut numbers = vec![0.0; packed_numbers(4)];
    let mut kept = TwistHistory::new();
    let (mut joined, mut pieces) = (0, 0);
    for _ in 0..40 {
        let mut history = TwistHistory::new();
        for [radius, twist] in path(&mut random, 25) {
            history.advance(radius, twist).unwrap();
            joined += usize::from(history.pack(&mut numbers).unwrap() > 0.0);
            kept.unpack(&numbers).unwrap();
            let count = numbers[1] as usize;
            for i in 0..count {
                let [from, demand] = [numbers[7 + 6 * i], numbers[12 + 6 * i]];
                let to = if i + 1 < count { numbers[13 + 6 * i] } else { radius };
                for part in [1e-3, 0.3, 0.6, 0.999] {
                    let s = from + part * (to - from);
                    let ratio = AxisRatio::new(s / demand.max(s)).unwrap();
                    let sliding = std::f64::consts::FRAC_2_PI * complete::e(ratio) / ratio.get();
                    let density = kept.density(s).abs();
                    assert!(
                        density <= sliding * (1.0 + 1e-9),
                        "{s} of {radius}: {density} {sliding}"
                    );
                    pieces += 1;
                }
            }
        }
    }
    assert!(joined > 100 && pieces > 1000, "{joined} {pieces}");
}

#[test]
fn what_is_packed_after_long_slides_is_taken_back() {
    // Steps of all sizes in runs of twenty: contacts that slide until their stick radius is the least
    // number there is, and that turn back, grow and recede from there.
    let mut random = Splitmix(7);
    let mut numbers = vec![0.0; packed_numbers(16)];
    let mut slid = 0;
    for _ in 0..50 {
        let mut history = TwistHistory::new();
        let size = 10_f64.powf(-5.0 * random.part());
        let step = 10_f64.powf(-4.0 * random.part());
        let (mut radius, mut twist, mut rates) = (size, 0.0, [0.0; 2]);
        for k in 0..400 {
            if k % 20 == 0 {
                let turn = 10_f64.powf(2.0 * random.part() - 1.5) * (2.0 * random.part() - 1.0);
                rates = [step * (2.0 * random.part() - 0.9), step * turn];
            }
            radius = (radius * (1.0 + rates[0])).clamp(0.01 * size, 50.0 * size);
            twist += size * rates[1];
            history.advance(radius, twist).unwrap();
            history.pack(&mut numbers).unwrap();
            let mut taken = history.clone();
            taken.unpack(&numbers).unwrap();
            assert!(taken.torque().abs() <= sliding_limit(radius));
            slid += usize::from(numbers[5] < 1e-300);
            if random.part() < 0.5 {
                history = taken;
            }
        }
    }
    assert!(slid > 150, "{slid}");
}
