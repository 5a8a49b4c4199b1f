//! Static friction above kinetic friction where the shift turns, against a bed of independent bristles.

use approx::assert_relative_eq;
use carom_drawn::{Congruential, Draw as _};
use carom_laws::accounted::Accounted;
use carom_laws::coulomb::{Tolerance, packed_numbers};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Dissipative, Energies, Shift};
use carom_laws::memory::{Fixed, MemoryRegime};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::turning_law::TurningLaw::{self, Coulomb, FixedDirection};
use proptest::prelude::*;

type Law = ShiftLaw<[f64; 2]>;

const F_S: f64 = 0.5;
const F_K: f64 = 0.3;
const C_X: f64 = 0.9;
const C_Z: f64 = 1.1;

fn stiffness(c_y: f64) -> ContactStiffness {
    ContactStiffness::new(C_X, c_y, C_Z).unwrap()
}

fn friction(f_s: f64, f_k: f64) -> StaticFriction {
    StaticFriction::new(Friction::new(f_s).unwrap(), Friction::new(f_k).unwrap()).unwrap()
}

fn law(law: TurningLaw, (f_s, f_k): (f64, f64), c_y: f64) -> Law {
    let tolerance = Tolerance::new(1e-4).unwrap();
    ShiftLaw::with_static_friction(law, stiffness(c_y), friction(f_s, f_k), tolerance)
}

/// The law of shifts along a line.
fn on_a_line(turning: TurningLaw, (f_s, f_k): (f64, f64)) -> ShiftLaw<f64> {
    let friction = friction(f_s, f_k);
    ShiftLaw::with_static_friction(turning, stiffness(C_X), friction, Tolerance::default())
}

fn at(zeta: f64, xi: f64, eta: f64) -> Shift {
    Shift { zeta, xi, eta, ..Shift::default() }
}

fn between(from: Shift, to: Shift, t: f64) -> Shift {
    let mix = |from: f64, to: f64| from + t * (to - from);
    at(mix(from.zeta, to.zeta), mix(from.xi, to.xi), mix(from.eta, to.eta))
}

fn off(one: ContactLoad, two: ContactLoad) -> f64 {
    (one.f_x - two.f_x).hypot(one.f_y - two.f_y)
}

/// Corners of a path that turns: mostly in contact, with steps of some times the shift of sliding.
fn path(seed: u64, corners: usize, spread: f64) -> Vec<Shift> {
    let mut dice = Congruential(seed);
    let (mut xi, mut eta) = (0.0, 0.0);
    (0..corners)
        .map(|_| {
            xi += spread * (dice.part() - 0.5);
            eta += spread * (dice.part() - 0.5);
            at(1.2 * dice.part() - 0.05, xi, eta)
        })
        .collect()
}

/// Bristles at the places where a sphere meets a plane at the depth t^2. Each slips at its limit f_s
/// p, against its own traction; once all of them slip, each has the limit f_k p until one of them
/// sticks.
struct Bed {
    stretch: Vec<[f64; 2]>,
    shift: Shift,
    slides: bool,
    limits: [f64; 2],
}

impl Bed {
    const WIDTH: f64 = 1.1;

    fn new(bristles: usize, f_s: f64, f_k: f64) -> Self {
        let limits = [f_s, f_k].map(|f| f * C_Z / C_X);
        Self { stretch: vec![[0.0; 2]; bristles], shift: Shift::default(), slides: false, limits }
    }

    fn depth(&self, j: usize) -> f64 {
        let t = Self::WIDTH * (j as f64 + 0.5) / self.stretch.len() as f64;
        t * t
    }

    fn step(&mut self, to: Shift) {
        let (from, by) = (self.shift, [to.xi - self.shift.xi, to.eta - self.shift.eta]);
        self.shift = to;
        let [f_s, f_k] = self.limits;
        let mut trial = Vec::new();
        for j in 0..self.stretch.len() {
            let [old, new] = [from.zeta - self.depth(j), to.zeta - self.depth(j)];
            if new <= 0.0 {
                self.stretch[j] = [0.0; 2];
                continue;
            }
            let part = if old < 0.0 { new / (new - old) } else { 1.0 };
            let [x, y] = self.stretch[j];
            trial.push((j, new, [x + part * by[0], y + part * by[1]]));
        }
        let all = |f: f64| trial.iter().all(|(_, p, [x, y])| x.hypot(*y) > f * p);
        self.slides = !trial.is_empty() && (all(f_s) || (self.slides && all(f_k)));
        let f = if self.slides { f_k } else { f_s };
        for (j, p, [x, y]) in trial {
            let size = x.hypot(y);
            let by = if size > f * p { f * p / size } else { 1.0 };
            self.stretch[j] = [by * x, by * y];
        }
    }

    fn force(&self) -> [f64; 2] {
        let unit = C_X * Self::WIDTH / self.stretch.len() as f64;
        [0, 1].map(|k| unit * self.stretch.iter().map(|stretch| stretch[k]).sum::<f64>())
    }

    fn follow(&mut self, to: Shift, steps: usize) {
        let from = self.shift;
        (1..=steps).for_each(|i| self.step(between(from, to, i as f64 / steps as f64)));
    }
}

#[test]
fn it_is_a_bed_of_bristles_that_slide_together() {
    let (mut slid, mut stopped, mut worst) = (0, 0, 0.0_f64);
    for seed in 0..10 {
        let (mut law, mut bed) = (law(Coulomb, (F_S, F_K), C_X), Bed::new(400, F_S, F_K));
        for to in path(seed, 25, 1.4) {
            let was = bed.slides;
            bed.follow(to, 1000);
            let load = law.advance(to).unwrap();
            let slides = law.regime() == MemoryRegime::Sliding;
            assert_eq!(slides, bed.slides, "{seed} {to:?}");
            slid += usize::from(slides);
            stopped += usize::from(was && !slides && to.zeta > 0.0);
            let [x, y] = bed.force();
            worst = worst.max((load.f_x - x).hypot(load.f_y - y));
        }
    }
    println!("slid {slid}, stopped {stopped}, worst {worst:e}");
    assert!(slid > 50 && stopped > 20, "{slid} {stopped}");
    assert!(worst < 2e-3, "{worst:e}");
}

/// After two turns the centre reaches its limit at .45 of the last corner, another annulus at .58: the force drops there,
/// in one step as in a thousand.
#[test]
fn the_force_drops_where_the_last_annulus_slips_not_the_centre() {
    let unit = F_S * C_Z / C_X;
    let corner = |zeta: f64, [x, y]: [f64; 2]| at(zeta, unit * x, unit * y);
    let before = [
        corner(1.0, [0.0, 0.0]),
        corner(1.187_097_423_8, [0.932_962_579_4, -0.723_338_050_5]),
        corner(0.969_402_584_0, [-0.845_212_970_4, -0.340_643_674_9]),
    ];
    let last = corner(0.623_253_582_9, [-0.360_827_201_7, -0.732_014_030_2]);
    for (part, slides) in [(0.5, false), (0.56, false), (0.59, true), (0.7, true)] {
        let to = between(before[2], last, part);
        let (mut once, mut often) =
            (law(Coulomb, (F_S, 0.6 * F_S), C_X), law(Coulomb, (F_S, 0.6 * F_S), C_X));
        for corner in before {
            once.advance(corner).unwrap();
            often.advance(corner).unwrap();
        }
        once.advance(to).unwrap();
        for i in 1..=1000 {
            often.advance(between(before[2], to, f64::from(i) / 1000.0)).unwrap();
        }
        assert_eq!(once.regime() == MemoryRegime::Sliding, slides, "{part}");
        assert_eq!(often.regime() == MemoryRegime::Sliding, slides, "{part}");
        let off = off(once.load(), often.load()) / once.load().f_z;
        println!("{part}: {off:e}");
        assert!(off < 3e-5, "{part}: {off:e}");
    }
}

/// The limit falls a little faster than the traction: the contact slides on, in one step as in a thousand, in each of which
/// the difference is below the tolerance of the curve.
/// What is left of a step behind a drop may be as short as the round-off of the shift. Its own direction decided by chance
/// whether the contact slid on.
#[test]
fn whether_a_contact_slides_on_does_not_hang_on_round_off() {
    const FAR: f64 = 1e3;
    let mut seen = [0; 2];
    for seed in 0..60 {
        let mut law = law(Coulomb, (F_S, F_K), 0.8);
        for to in path(seed, 30, 1.5) {
            let (from, to) = (law.shift(), Shift { xi: to.xi + FAR, ..to });
            if law.jumps(to) {
                let (mut before, mut after) = (0.0, 1.0);
                for _ in 0..50 {
                    let middle = 0.5 * (before + after);
                    let jumps = law.jumps(between(from, to, middle));
                    *(if jumps { &mut after } else { &mut before }) = middle;
                }
                // None where round-off keeps the step before the drop.
                let slides = |beyond: f64| {
                    let at = between(from, to, after + beyond * (1.0 - after));
                    let mut law = law.clone();
                    law.jumps(at).then(|| {
                        law.advance(at).unwrap();
                        law.regime() == MemoryRegime::Sliding
                    })
                };
                let slid = slides(1e-6).unwrap();
                for bits in 30..44 {
                    let near = slides(2.0_f64.powi(-bits)).unwrap_or(slid);
                    assert_eq!(near, slid, "{seed}: {from:?} {to:?} {after} {bits}");
                }
                seen[usize::from(slid)] += 1;
            }
            law.advance(to).unwrap();
        }
    }
    assert!(seen[0] >= 3 && seen[1] > 500, "{seen:?}");
}

#[test]
fn slow_slip_in_small_steps_is_no_stick() {
    let path = [
        at(0.0, 0.0, -0.850_405_224_2),
        at(0.887_135_112_8, -0.989_001_591_6, 0.471_129_267_7),
        at(0.831_642_514_0, -0.897_935_131_2, 0.517_262_190_9),
    ];
    let (mut once, mut often) = (law(Coulomb, (F_S, F_K), C_X), law(Coulomb, (F_S, F_K), C_X));
    for to in path {
        let from = once.shift();
        once.advance(to).unwrap();
        (1..=1000).for_each(|i| {
            often.advance(between(from, to, f64::from(i) / 1e3)).unwrap();
        });
    }
    assert_eq!([once.regime(), often.regime()], [MemoryRegime::Sliding; 2]);
    let off = off(once.load(), often.load());
    assert!(off < 1e-4, "{off:e}");
}

#[test]
fn along_a_line_it_is_the_law_of_a_line() {
    for turning in [Coulomb, FixedDirection] {
        for (f_s, f_k) in [(F_S, F_K), (0.4, 0.0), (0.4, 0.39), (1e3, 1e-20)] {
            let mut worst = 0.0_f64;
            for seed in 0..30 {
                let (sin, cos) = (0.3 * seed as f64).sin_cos();
                let mut turns = Accounted::new(law(turning, (f_s, f_k), C_X));
                let mut line = Accounted::new(on_a_line(turning, (f_s, f_k)));
                for Shift { zeta, xi, .. } in path(seed, 60, 3.2 * f_s) {
                    let to = at(zeta, cos * xi, sin * xi);
                    assert_eq!(turns.jumps(to), line.jumps(at(zeta, xi, 0.0)), "{seed} {to:?}");
                    let (got, want) =
                        (turns.advance(to).unwrap(), line.advance(at(zeta, xi, 0.0)).unwrap());
                    worst =
                        worst.max((got.f_x - cos * want.f_x).hypot(got.f_y - sin * want.f_x) / f_s);
                    assert_eq!(
                        turns.law().regime() == MemoryRegime::Sliding,
                        line.law().regime() == MemoryRegime::Sliding
                    );
                    assert_relative_eq!(
                        turns.stored_energy(),
                        line.stored_energy(),
                        max_relative = 1e-10,
                        epsilon = 1e-14
                    );
                    assert_relative_eq!(
                        turns.dissipated(),
                        line.dissipated(),
                        max_relative = 1e-9,
                        epsilon = 1e-12
                    );
                }
            }
            println!("{turning} {f_s} {f_k}: {worst:e}");
            assert!(worst < 1e-11, "{turning} {f_s} {f_k}: {worst:e}");
        }
    }
}

#[test]
fn one_step_along_a_line_is_a_thousand() {
    for seed in 0..20 {
        let [mut whole, mut parts] =
            [(); 2].map(|()| Accounted::new(on_a_line(FixedDirection, (F_S, F_K))));
        for to in path(seed, 40, 1.6) {
            let (from, to) = (whole.shift(), Shift { eta: 0.0, ..to });
            let one = whole.advance(to).unwrap();
            for i in 1..=1000 {
                parts.advance(between(from, to, f64::from(i) / 1000.0)).unwrap();
            }
            assert!(off(one, parts.load()) < 1e-11, "{seed} {to:?}: {one:?} {:?}", parts.load());
            let heats = [whole.dissipated(), parts.dissipated()];
            assert_relative_eq!(heats[0], heats[1], max_relative = 1e-8, epsilon = 1e-10);
        }
        assert!(whole.dissipated() > 0.0);
    }
}

#[test]
fn equal_coefficients_give_the_law_of_one_to_the_bit() {
    for turning in [Coulomb, FixedDirection] {
        for f in [0.0, 0.3, f64::INFINITY] {
            let mut one = law(turning, (f, f), 0.7);
            let tolerance = Tolerance::new(1e-4).unwrap();
            let mut plain =
                Law::chosen(turning, stiffness(0.7), Friction::new(f).unwrap(), tolerance);
            for to in path(8, 60, 1.4) {
                assert_eq!(one.dissipation(to).to_bits(), plain.dissipation(to).to_bits());
                assert!(!one.jumps(to));
                assert_eq!(one.advance(to).unwrap(), plain.advance(to).unwrap());
                assert_eq!(one.stored_energy().to_bits(), plain.stored_energy().to_bits());
            }
        }
    }
}

#[test]
fn what_never_reaches_the_threshold_has_static_friction_alone() {
    for turning in [Coulomb, FixedDirection] {
        let tolerance = Tolerance::new(1e-4).unwrap();
        let mut plain =
            Law::chosen(turning, stiffness(C_X), Friction::new(F_S).unwrap(), tolerance);
        let (mut law, mut dice) = (law(turning, (F_S, F_K), C_X), Congruential(5));
        // Shifts less than the cone allows from any anchor of before.
        let reach = 0.35 * F_S * C_Z / C_X * 0.7;
        for _ in 0..200 {
            let [xi, eta] = [0, 1].map(|_| reach * dice.signed());
            let to = at(0.7 + 0.5 * dice.part(), xi, eta);
            assert_eq!(law.advance(to).unwrap(), plain.advance(to).unwrap());
            assert_eq!(law.stored_energy().to_bits(), plain.stored_energy().to_bits());
        }
    }
}

#[test]
fn what_slides_from_the_first_touch_has_kinetic_friction_alone() {
    for turning in [Coulomb, FixedDirection] {
        let tolerance = Tolerance::new(1e-4).unwrap();
        let plain = Law::chosen(turning, stiffness(0.7), Friction::new(F_K).unwrap(), tolerance);
        let (mut law, mut plain) =
            (Accounted::new(law(turning, (F_S, F_K), 0.7)), Accounted::new(plain));
        // It turns by less than a right angle, at which slip does not stop.
        for (zeta, xi, eta) in [
            (0.3, 0.6, 0.1),
            (1.0, 2.2, 0.4),
            (0.6, 2.5, 0.9),
            (0.9, 2.8, 1.9),
            (0.2, 2.9, 2.3),
            (-0.1, 3.0, 3.0),
        ] {
            let to = at(zeta, xi, eta);
            let (one, two) = (law.advance(to).unwrap(), plain.advance(to).unwrap());
            assert!(off(one, two) < 1e-5, "{turning} {to:?}: {one:?} {two:?}");
            assert_relative_eq!(law.stored_energy(), plain.stored_energy(), max_relative = 1e-4);
            assert_relative_eq!(law.dissipated(), plain.dissipated(), max_relative = 1e-4);
            let (own, other) = (law.law().tangent(), plain.law().tangent());
            for (own, other) in own.iter().flatten().zip(other.iter().flatten()) {
                assert!((own - other).abs() < 1e-4, "{turning} {to:?}: {own} {other}");
            }
            // Tractions count over the greatest limit, f_s p_max and f_k p_max.
            for q in [0.0, 0.5, 0.99] {
                let [own, other] = [&law, &plain].map(|law| law.law().traction(q).unwrap());
                let off = |k: usize| (F_S * own[k] - F_K * other[k]).abs();
                assert!(off(0).max(off(1)) < 1e-4, "{turning} {to:?} {q}: {own:?} {other:?}");
            }
        }
    }
}

/// Where the force drops, the springs lose 1 - (f_k/f_s)^2 of their energy of shift, in the direction
/// that each has after the path has turned.
#[test]
fn the_drop_has_its_heat() {
    for turning in [Coulomb, FixedDirection] {
        let (mut law, zeta) = (law(turning, (F_S, F_K), C_X), 0.8);
        let f_z = law.advance(at(zeta, 0.0, 0.0)).unwrap().f_z;
        let onset = F_S * C_Z / C_X * zeta;
        law.advance(at(zeta, 0.7 * onset, 0.0)).unwrap();
        let up = |part: f64| at(zeta, 0.7 * onset, part * onset);
        let high = (1.0_f64 - 0.49).sqrt();
        let [before, after] = [1.0 - 1e-9, 1.0 + 1e-9].map(|part| law.dissipation(up(part * high)));
        // At the threshold every bristle has the stretch f_s p, and with it half f_s^2 (c_z/c_x) p du.
        let stored = 0.4 * F_S * F_S * (C_Z / C_X) * f_z * zeta;
        let drop = (1.0 - (F_K / F_S) * (F_K / F_S)) * stored;
        assert_relative_eq!(after - before, drop, max_relative = 2e-4);
        assert!(!law.jumps(up(0.999 * high)) && law.jumps(up(1.001 * high)));
        // Also for who asks the account of it.
        let accounted = Accounted::new(law.clone());
        assert!(!accounted.jumps(up(0.999 * high)) && accounted.jumps(up(1.001 * high)));
        let held = law.advance(up((1.0 - 1e-6) * high)).unwrap();
        assert!(held.f_x.hypot(held.f_y) > 0.7 * F_S * f_z);
        let slid = law.advance(up(1.001 * high)).unwrap();
        assert_eq!(law.regime(), MemoryRegime::Sliding);
        assert_eq!(law.stick_depth(), 0.0);
        assert!(slid.f_x.hypot(slid.f_y) < (F_K + 1e-9) * f_z);
        // Both tractions have the directions of before.
        let turned = (held.f_x * slid.f_y - held.f_y * slid.f_x) / (F_S * F_K * f_z * f_z);
        assert!(turned.abs() < 3e-3, "{turned}");
        // A rest that is no step does not stop it; a step back does.
        law.advance(law.shift()).unwrap();
        let on = law.advance(up(1.2 * high)).unwrap();
        assert!(on.f_x.hypot(on.f_y) < (F_K + 1e-9) * f_z);
        law.advance(up(1.15 * high)).unwrap();
        assert_ne!(law.regime(), MemoryRegime::Sliding);
        let again = law.advance(up(1.2 * high + 0.3 * onset)).unwrap();
        assert!(again.f_x.hypot(again.f_y) > 1.1 * F_K * f_z);
    }
}

/// Sliding far in one step, while the bodies approach, heats as much as in steps so short that tractions notice each.
#[test]
fn a_long_slide_heats_as_in_many_steps() {
    for turning in [Coulomb, FixedDirection] {
        let [mut whole, mut parts] =
            [(); 2].map(|()| Accounted::new(law(turning, (F_S, F_K), C_X)));
        let [from, to] = [at(0.5, 2.0, 1.0), at(1.0, 102.0, 41.0)];
        for law in [&mut whole, &mut parts] {
            law.advance(at(0.5, 0.0, 0.0)).unwrap();
            law.advance(from).unwrap();
        }
        whole.advance(to).unwrap();
        for i in 1..=20 {
            parts.advance(between(from, to, f64::from(i) / 20.0)).unwrap();
        }
        assert_relative_eq!(whole.dissipated(), parts.dissipated(), max_relative = 1e-9);
    }
}

/// Turned by a right angle or less, what slides slides on; by more, it sticks.
#[test]
fn a_turn_back_stops_the_slip_and_a_turn_aside_does_not() {
    for turning in [Coulomb, FixedDirection] {
        for (degrees, slides) in
            [(30.0_f64, true), (89.0, true), (90.0, true), (91.0, false), (180.0, false)]
        {
            let mut law = law(turning, (F_S, F_K), C_X);
            law.advance(at(1.0, 0.0, 0.0)).unwrap();
            law.advance(at(1.0, 3.0, 0.0)).unwrap();
            let (sin, cos) = degrees.to_radians().sin_cos();
            law.advance(at(1.0, 3.0 + 0.1 * cos, 0.1 * sin)).unwrap();
            assert_eq!(law.regime() == MemoryRegime::Sliding, slides, "{turning} {degrees}");
        }
    }
}

#[test]
fn packed_numbers_go_on() {
    for turning in [Coulomb, FixedDirection] {
        type Stored = ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>;
        let (tolerance, f) = (Tolerance::PARTICLES, friction(F_S, F_K));
        let fresh = Stored::with_static_friction(turning, stiffness(0.7), f, tolerance);
        let (mut one, mut slid) = (fresh, 0);
        for to in path(21, 400, 1.4) {
            let mut numbers = [0.0; packed_numbers(12)];
            one.pack(&mut numbers).unwrap();
            let mut two = fresh;
            two.unpack(&numbers).unwrap();
            assert_eq!(one.regime(), two.regime());
            assert!(off(one.load(), two.load()) < 1e-12);
            slid += usize::from(one.regime() == MemoryRegime::Sliding);
            one.advance(to).unwrap();
            two.advance(to).unwrap();
            assert!(off(one.load(), two.load()) < 1e-9, "{turning} {to:?}");
        }
        assert!(slid > 30, "{slid}");
        assert_eq!(one.friction(), f.threshold());
    }
}

#[test]
fn a_failed_step_leaves_the_state() {
    let mut law = law(Coulomb, (F_S, F_K), C_X);
    law.advance(at(1.0, 0.1, 0.2)).unwrap();
    let before = law.clone();
    assert_eq!(law.advance(at(f64::NAN, 0.1, 0.0)).unwrap_err().field, "zeta");
    assert_eq!(law.advance(at(1.0, 0.1, f64::INFINITY)).unwrap_err().field, "eta");
    assert!(!law.jumps(at(1.0, f64::NAN, 0.0)) && law == before);
    assert_eq!(law.dissipation(at(1.0, f64::NAN, 0.0)), 0.0);
    let mut line = on_a_line(FixedDirection, (F_S, F_K));
    line.advance(at(1.0, 0.1, 0.0)).unwrap();
    let (before, across) = (line.clone(), at(1.0, 0.1, 0.1));
    assert_eq!(line.advance(across).unwrap_err().field, "eta");
    assert!(!line.jumps(across) && line == before);
}

/// Shifts and approaches of any size give numbers.
/// Where a shift has no digits for a stretch, a slide back kept the traction of the way there, and its stored state was
/// refused.
#[test]
fn a_slide_back_from_afar_turns_the_traction() {
    let (approach, room) = (0.12, packed_numbers(100));
    for turning in [FixedDirection, Coulomb] {
        for far in [1e3, 1e12, 1e15, 1e16, 1e17, 1e20, 7e38] {
            let mut law = law(turning, (F_S, F_K), C_X);
            law.advance(at(approach, -0.11, 0.0)).unwrap();
            for (to, sign) in [(far, 1.0), (0.0, -1.0), (far, 1.0), (-far, -1.0), (-0.5 * far, 1.0)]
            {
                let load = law.advance(at(approach, -0.11, to)).unwrap();
                assert_relative_eq!(load.f_y, sign * F_K * load.f_z, max_relative = 1e-6);
                assert!(load.f_x.abs() < 1e-2 * load.f_z, "{far:e} {to:e}: {load:?}");
                let mut numbers = vec![0.0; room];
                law.pack(&mut numbers).unwrap();
                law.unpack(&numbers).unwrap();
            }
        }
    }
}

#[test]
fn extremes_give_numbers() {
    for turning in [Coulomb, FixedDirection] {
        for (f_s, f_k) in [(F_S, F_K), (0.4, 0.0), (1e30, 1e-30)] {
            let mut law = Accounted::new(law(turning, (f_s, f_k), C_X));
            for size in [1e-300, 1e-30, 1.0, 1e20] {
                for to in path(4, 20, 2.0) {
                    let load = law
                        .advance(at(size * to.zeta, size * to.xi, 1e-3 * size * to.eta))
                        .unwrap();
                    assert!(
                        load.f_x.is_finite() && load.f_y.is_finite(),
                        "{turning} {f_s} {size} {load:?}"
                    );
                    assert!(law.dissipated().is_finite() && law.stored_energy().is_finite());
                    assert!(law.law().tangent().iter().flatten().all(|rate| rate.is_finite()));
                }
            }
        }
    }
}

fn corners() -> impl Strategy<Value = Vec<Shift>> {
    let corner = (-0.05..1.15_f64, -1.0..1.0_f64, -1.0..1.0_f64);
    prop::collection::vec(corner, 2..12)
        .prop_map(|corners| corners.into_iter().map(|(zeta, xi, eta)| at(zeta, xi, eta)).collect())
}

fn any_law() -> impl Strategy<Value = TurningLaw> {
    prop::sample::select(vec![Coulomb, FixedDirection])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// No force exceeds static friction, and what slides has kinetic friction, but for the turning of
    /// its tractions.
    #[test]
    fn the_force_keeps_its_limits(turning in any_law(), f_k in 0.0..0.5_f64, path in corners()) {
        let mut law = law(turning, (F_S, f_k), C_X);
        for to in path {
            let load = law.advance(to).unwrap();
            let size = load.f_x.hypot(load.f_y);
            let f = if law.regime() == MemoryRegime::Sliding { f_k } else { F_S };
            prop_assert!(size <= (f + 1e-9) * load.f_z, "{size} {load:?}");
        }
    }

    /// Axes that are turned turn the force and leave the energies.
    #[test]
    fn turned_axes_turn_the_force(turning in any_law(), angle in 0.0..6.3_f64, path in corners()) {
        let law = law(turning, (F_S, F_K), C_X);
        let (mut one, mut two, mut frame) =
            (Accounted::new(law.clone()), Accounted::new(law.clone()), law);
        let (sin, cos) = angle.sin_cos();
        let turn = |x: f64, y: f64| (cos * x + sin * y, cos * y - sin * x);
        for to in path {
            let (xi, eta) = turn(to.xi, to.eta);
            let (a, b) = (one.advance(to).unwrap(), two.advance(at(to.zeta, xi, eta)).unwrap());
            let (f_x, f_y) = turn(a.f_x, a.f_y);
            prop_assert!((f_x - b.f_x).hypot(f_y - b.f_y) < 1e-9, "{a:?} {b:?}");
            prop_assert!((one.stored_energy() - two.stored_energy()).abs() < 1e-9);
            prop_assert!((one.dissipated() - two.dissipated()).abs() < 1e-9);
            frame.advance(to).unwrap();
            frame.turn_frame(angle);
            prop_assert!(off(frame.load(), b) < 1e-9);
            frame.turn_frame(-angle);
        }
    }

    /// A straight step is a thousand of its parts.
    #[test]
    fn one_step_is_a_thousand(turning in any_law(), path in corners()) {
        let law = law(turning, (F_S, F_K), C_X);
        let (mut whole, mut parts) = (law.clone(), law);
        for to in path {
            let from = whole.shift();
            let one = whole.advance(to).unwrap();
            (1..=1000).for_each(|i| { parts.advance(between(from, to, f64::from(i) / 1e3)).unwrap(); });
            prop_assert!(off(one, parts.load()) < 2e-3, "{to:?}: {one:?} {:?}", parts.load());
        }
    }

    /// Work is stored or heat, in steps so short that the work of the force is known.
    #[test]
    fn work_is_stored_or_heat(turning in any_law(), f_k in 0.0..0.5_f64, path in corners()) {
        let mut law = Accounted::new(law(turning, (F_S, f_k), C_X));
        let (mut work, mut scale, mut unknown) = (0.0, 1e-2_f64, 0.0);
        for to in path {
            let from = law.shift();
            for i in 1..=200 {
                let (s, p) = (law.shift(), law.load());
                let next = between(from, to, f64::from(i) / 200.0);
                let (before, jumps) = (law.dissipated(), law.jumps(next));
                let q = law.advance(next).unwrap();
                prop_assert!(law.dissipated() >= before);
                // Where in the step the force drops, the trapezoid does not know.
                let way = (next.xi - s.xi).hypot(next.eta - s.eta);
                unknown += if jumps { 0.5 * off(p, q) * way } else { 0.0 };
                work += 0.5
                    * ((p.f_x + q.f_x) * (next.xi - s.xi)
                        + (p.f_y + q.f_y) * (next.eta - s.eta)
                        + (p.f_z + q.f_z) * (next.zeta - s.zeta));
            }
            scale = scale.max(work.abs());
            let balance = law.stored_energy() + law.dissipated();
            prop_assert!((work - balance).abs() < 1e-3 * scale + unknown, "{to:?}: {work} {balance}");
        }
    }
}
