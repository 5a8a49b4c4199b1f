//! Static friction above kinetic friction where the shift turns, against a bed of independent bristles.

use approx::assert_relative_eq;
use carom_drawn::{Congruential, Draw as _};
use carom_laws::accounted::Accounted;
use carom_laws::coulomb::Tolerance;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, ContactLoad, Dissipative, Energies, Shift};
use carom_laws::memory::MemoryRegime;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::turning_law::TurningLaw::{self, Coulomb, FixedDirection};
use carom_laws::viscous::{Viscosity, ViscousLaw};

type Law = ShiftLaw<[f64; 2]>;

pub(crate) const F_S: f64 = 0.5;
pub(crate) const F_K: f64 = 0.3;
pub(crate) const C_X: f64 = 0.9;
const C_Z: f64 = 1.1;

pub(crate) fn stiffness(c_y: f64) -> ContactStiffness {
    ContactStiffness::new(C_X, c_y, C_Z).unwrap()
}

pub(crate) fn friction(f_s: f64, f_k: f64) -> StaticFriction {
    StaticFriction::new(Friction::new(f_s).unwrap(), Friction::new(f_k).unwrap()).unwrap()
}

pub(crate) fn law(law: TurningLaw, (f_s, f_k): (f64, f64), c_y: f64) -> Law {
    let tolerance = Tolerance::new(1e-4).unwrap();
    ShiftLaw::with_static_friction(law, stiffness(c_y), friction(f_s, f_k), tolerance)
}

pub(crate) fn at(zeta: f64, xi: f64, eta: f64) -> Shift {
    Shift { zeta, xi, eta, ..Shift::default() }
}

pub(crate) fn between(from: Shift, to: Shift, t: f64) -> Shift {
    let mix = |from: f64, to: f64| from + t * (to - from);
    at(mix(from.zeta, to.zeta), mix(from.xi, to.xi), mix(from.eta, to.eta))
}

pub(crate) fn off(one: ContactLoad, two: ContactLoad) -> f64 {
    (one.f_x - two.f_x).hypot(one.f_y - two.f_y)
}

/// Corners of a path that turns: mostly in contact, with steps of some times the shift of sliding.
pub(crate) fn path(seed: u64, corners: usize, spread: f64) -> Vec<Shift> {
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

/// While it is pressed deeper, a contact slides on if the shift grows by more than kappa f_k times the approach: so it tells,
/// and so it does in a short step.
#[test]
fn it_tells_whether_it_would_slide_on() {
    for turning in [Coulomb, FixedDirection] {
        let mut law = law(turning, (F_S, F_K), 0.8);
        assert_eq!(law.slides_on(at(1.0, 1.0, 0.0)), None);
        law.advance(at(0.5, 0.0, 0.0)).unwrap();
        law.advance(at(0.5, 3.0, 0.0)).unwrap();
        for part in [0.5, 0.9, 1.1, 1.6, 2.0] {
            let rates = at(1.0, part * F_K * C_Z / C_X, 0.0);
            assert_eq!(law.slides_on(rates), Some(part > 1.0), "{part}");
            let mut next = law.clone();
            next.advance(at(0.5 + 1e-3, 3.0 + 1e-3 * rates.xi, 0.0)).unwrap();
            assert_eq!(next.regime() == MemoryRegime::Sliding, part > 1.0, "{part}");
        }
    }
}

/// The limit falls a little faster than the traction: the contact slides on, in one step as in a thousand, in each of which
/// the difference is below the tolerance of the curve.
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

/// In a viscous material a contact that holds by more than kinetic friction follows its effective path: it does not slide.
#[test]
fn a_viscous_contact_holds_up_to_static_friction() {
    for turning in TurningLaw::ALL {
        let mut elastic = law(turning, (F_S, F_K), 1.0);
        let viscosity = Viscosity::new(0.1).unwrap();
        let mut viscous = ViscousLaw::new(elastic.clone(), viscosity, F_K, stiffness(1.0));
        for (xi, rate) in [(0.0, 0.0), (0.25, 0.5), (0.32, 0.3)] {
            let effective = elastic.advance(at(1.0, xi + 0.1 * rate, 0.0)).unwrap();
            let load = viscous.advance_at(at(1.0, xi, 0.0), at(0.0, rate, 0.0), 1.0).unwrap();
            assert!(off(load, effective) < 1e-12, "{turning:?} {xi}: {load:?} {effective:?}");
            assert!(xi == 0.0 || load.f_x > 1.05 * F_K * load.f_z, "{load:?}");
        }
    }
}
