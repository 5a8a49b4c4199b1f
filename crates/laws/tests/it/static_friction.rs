//! Static friction above kinetic friction, against a bed of independent springs with sliders.

use approx::assert_relative_eq;
use carom_drawn::{Congruential, Draw as _};
use carom_laws::accounted::Accounted;
use carom_laws::coulomb::Tolerance;
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Dissipative, Energies, Shift};
use carom_laws::memory::MemoryRegime;
use carom_laws::shift_law::ShiftLaw;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::turning_law::TurningLaw;

const F_S: f64 = 0.5;
const F_K: f64 = 0.3;

fn stiffness() -> ContactStiffness {
    ContactStiffness::new(0.9, 0.7, 1.1).unwrap()
}

fn friction(f_s: f64, f_k: f64) -> StaticFriction {
    StaticFriction::new(Friction::new(f_s).unwrap(), Friction::new(f_k).unwrap()).unwrap()
}

fn law(f_s: f64, f_k: f64) -> ShiftLaw<f64> {
    let (law, tolerance) = (TurningLaw::FixedDirection, Tolerance::default());
    ShiftLaw::with_static_friction(law, stiffness(), friction(f_s, f_k), tolerance)
}

fn constant(f: f64) -> ShiftLaw<f64> {
    ShiftLaw::new(stiffness(), Friction::new(f).unwrap())
}

fn at(zeta: f64, xi: f64) -> Shift {
    Shift { zeta, xi, ..Shift::default() }
}

fn between(from: Shift, to: Shift, t: f64) -> Shift {
    at(from.zeta + t * (to.zeta - from.zeta), from.xi + t * (to.xi - from.xi))
}

/// Corners of a path: mostly in contact, with steps of some times the shift of sliding.
fn path(seed: u64, corners: usize, spread: f64) -> Vec<Shift> {
    let mut dice = Congruential(seed);
    let mut xi = 0.0;
    (0..corners)
        .map(|_| {
            xi += spread * (dice.part() - 0.5);
            at(1.2 * dice.part() - 0.05, xi)
        })
        .collect()
}

/// Springs at the places where a sphere meets a plane at the depth t^2. Each slips at its limit
/// f_s p; once all of them slip, each has the limit f_k p until the slip stops.
struct Bed {
    stretch: Vec<f64>,
    shift: Shift,
    slides: f64,
    limits: [f64; 2],
}

impl Bed {
    const WIDTH: f64 = 1.1;

    fn new(springs: usize, f_s: f64, f_k: f64) -> Self {
        let c = stiffness();
        let limits = [f_s, f_k].map(|f| f * c.c_z / c.c_x);
        Self { stretch: vec![0.0; springs], shift: Shift::default(), slides: 0.0, limits }
    }

    fn depth(&self, j: usize) -> f64 {
        let t = Self::WIDTH * (j as f64 + 0.5) / self.stretch.len() as f64;
        t * t
    }

    fn step(&mut self, to: Shift) {
        let (from, dx) = (self.shift, to.xi - self.shift.xi);
        self.shift = to;
        let [f_s, f_k] = self.limits;
        let mut trial = Vec::new();
        for j in 0..self.stretch.len() {
            let [old, new] = [from.zeta - self.depth(j), to.zeta - self.depth(j)];
            if new <= 0.0 {
                self.stretch[j] = 0.0;
                continue;
            }
            let part = if old < 0.0 { new / (new - old) } else { 1.0 };
            trial.push((j, new, self.stretch[j] + part * dx));
        }
        let all = |sign: f64, f: f64| trial.iter().all(|(_, p, u)| sign * u > f * p);
        if trial.is_empty() || !(self.slides != 0.0 && all(self.slides, f_k)) {
            self.slides = 0.0;
        }
        if self.slides == 0.0 && !trial.is_empty() {
            self.slides = [1.0, -1.0].into_iter().find(|sign| all(*sign, f_s)).unwrap_or(0.0);
        }
        for (j, p, u) in trial {
            let limit = f_s * p;
            self.stretch[j] =
                if self.slides == 0.0 { u.clamp(-limit, limit) } else { self.slides * f_k * p };
        }
    }

    fn force(&self) -> f64 {
        let sum: f64 = self.stretch.iter().sum();
        stiffness().c_x * sum * Self::WIDTH / self.stretch.len() as f64
    }

    fn follow(&mut self, to: Shift, steps: usize) {
        let from = self.shift;
        (1..=steps).for_each(|i| self.step(between(from, to, i as f64 / steps as f64)));
    }
}

#[test]
fn it_is_a_bed_of_springs_that_slide_together() {
    let (mut slid, mut stopped, mut worst) = (0, 0, 0.0_f64);
    for seed in 0..10 {
        let (mut law, mut bed) = (law(F_S, F_K), Bed::new(1000, F_S, F_K));
        for to in path(seed, 30, 1.6) {
            let was = bed.slides;
            bed.follow(to, 400);
            let load = law.advance(to).unwrap();
            assert_eq!(law.regime() == MemoryRegime::Sliding, bed.slides != 0.0, "{seed} {to:?}");
            slid += usize::from(bed.slides != 0.0);
            stopped += usize::from(was != 0.0 && bed.slides == 0.0 && to.zeta > 0.0);
            worst = worst.max((load.f_x - bed.force()).abs());
        }
    }
    assert!(slid > 50 && stopped > 20, "{slid} {stopped}");
    assert!(worst < 2e-3, "{worst:e}");
}

#[test]
fn one_step_is_a_thousand() {
    for seed in 0..20 {
        let (mut whole, mut parts) = (Accounted::new(law(F_S, F_K)), Accounted::new(law(F_S, F_K)));
        for to in path(seed, 40, 1.6) {
            let from = whole.shift();
            let one = whole.advance(to).unwrap();
            (1..=1000).for_each(|i| {
                parts.advance(between(from, to, f64::from(i) / 1000.0)).unwrap();
            });
            let many = parts.load();
            assert!((one.f_x - many.f_x).abs() < 1e-11, "{seed} {to:?}: {one:?} {many:?}");
            assert_relative_eq!(
                whole.dissipated(),
                parts.dissipated(),
                max_relative = 1e-8,
                epsilon = 1e-10
            );
        }
        assert!(whole.dissipated() > 0.0);
    }
}

#[test]
fn work_is_stored_or_lost() {
    for (f_s, f_k) in [(0.5, 0.3), (0.4, 0.0), (0.4, 0.39)] {
        let mut law = Accounted::new(law(f_s, f_k));
        let (mut work, mut scale) = (0.0, 0.0_f64);
        for to in path(3, 40, 1.6) {
            let from = law.shift();
            for i in 1..=4000 {
                let (s, p) = (law.shift(), law.load());
                let next = between(from, to, f64::from(i) / 4000.0);
                let q = law.advance(next).unwrap();
                work += 0.5
                    * ((p.f_x + q.f_x) * (next.xi - s.xi) + (p.f_z + q.f_z) * (next.zeta - s.zeta));
            }
            scale = scale.max(work.abs());
            let balance = law.stored_energy() + law.dissipated();
            assert!((work - balance).abs() < 3e-4 * scale, "{f_s} {f_k} {to:?}: {work} {balance}");
        }
    }
}

/// At constant approach the drop of the force gives off 2/5 (f_s^2 - f_k^2) (c_z/c_x) F_z zeta.
#[test]
fn the_drop_has_its_heat() {
    let (mut law, c, zeta) = (law(F_S, F_K), stiffness(), 0.8);
    let f_z = law.advance(at(zeta, 0.0)).unwrap().f_z;
    let onset = F_S * c.c_z / c.c_x * zeta;
    let [before, after] =
        [1.0 - 1e-9, 1.0 + 1e-9].map(|part| law.dissipation(at(zeta, part * onset)));
    let drop = 0.4 * (F_S * F_S - F_K * F_K) * (c.c_z / c.c_x) * f_z * zeta;
    assert_relative_eq!(after - before, drop, max_relative = 1e-7);
    let held = law.advance(at(zeta, (1.0 - 1e-9) * onset)).unwrap();
    assert!(held.f_x > (1.0 - 1e-8) * F_S * f_z && !law.jumps(at(zeta, 0.0)));
    assert!(law.jumps(at(zeta, 1.1 * onset)));
    let slid = law.advance(at(zeta, 1.1 * onset)).unwrap();
    assert_relative_eq!(slid.f_x, F_K * f_z, max_relative = 1e-14);
    assert!(!law.jumps(at(zeta, 2.0 * onset)) && law.jumps(at(zeta, -2.0 * onset)));
    // A rest that is no step does not stop it; a step back does.
    law.advance(law.shift()).unwrap();
    assert_relative_eq!(law.advance(at(zeta, 1.2 * onset)).unwrap().f_x, slid.f_x);
    law.advance(at(zeta, 1.19 * onset)).unwrap();
    assert!(law.advance(at(zeta, 1.3 * onset)).unwrap().f_x > F_K * f_z);
}

#[test]
fn what_never_reaches_the_threshold_has_static_friction_alone() {
    let (mut law, mut plain) = (law(F_S, F_K), constant(F_S));
    let mut dice = Congruential(5);
    // Shifts less than the cone allows from any anchor of before.
    for _ in 0..200 {
        let zeta = 0.7 + 0.5 * dice.part();
        let to = at(zeta, 0.5 * F_S * 1.1 / 0.9 * 0.7 * dice.signed());
        let (one, two) = (law.advance(to).unwrap(), plain.advance(to).unwrap());
        assert_eq!(one, two);
        assert_eq!(law.stored_energy().to_bits(), plain.stored_energy().to_bits());
    }
}

#[test]
fn what_slides_from_the_first_touch_has_kinetic_friction_alone() {
    let (mut law, mut plain) = (Accounted::new(law(F_S, F_K)), Accounted::new(constant(F_K)));
    for (zeta, xi) in [(0.3, 0.4), (1.0, 1.5), (0.6, 1.6), (0.9, 2.2), (0.2, 2.3), (-0.1, 3.0)] {
        let (one, two) = (law.advance(at(zeta, xi)).unwrap(), plain.advance(at(zeta, xi)).unwrap());
        assert_relative_eq!(one.f_x, two.f_x, max_relative = 1e-14);
        assert_relative_eq!(law.stored_energy(), plain.stored_energy(), max_relative = 1e-14);
        assert_relative_eq!(law.dissipated(), plain.dissipated(), max_relative = 1e-12);
    }
}

#[test]
fn equal_coefficients_give_the_law_of_one_to_the_bit() {
    for f in [0.0, 0.3, f64::INFINITY] {
        let (mut law, mut plain) = (law(f, f), constant(f));
        for to in path(8, 60, 1.6) {
            assert_eq!(law.dissipation(to).to_bits(), plain.dissipation(to).to_bits());
            assert!(!law.jumps(to));
            assert_eq!(law.advance(to).unwrap(), plain.advance(to).unwrap());
        }
    }
}

#[test]
fn the_mirror_image_is_the_mirror_image() {
    let [mut one, mut two] = [law(F_S, F_K), law(F_S, F_K)];
    for to in path(11, 200, 1.6) {
        let [a, b] = [one.advance(to).unwrap(), two.advance(at(to.zeta, -to.xi)).unwrap()];
        assert_eq!((a.f_x, a.f_z), (-b.f_x, b.f_z));
    }
}

#[test]
fn the_touch_sticks_between_the_cones_and_slides_beyond() {
    let c = stiffness();
    let shift = |f: f64| f * c.c_z / c.c_x;
    let mut stuck = law(F_S, F_K);
    let load = stuck.advance(at(1.0, shift(0.4))).unwrap();
    assert_relative_eq!(load.f_x, 0.4 * load.f_z, max_relative = 1e-14);
    let mut slides = law(F_S, F_K);
    let load = slides.advance(at(1.0, shift(0.6))).unwrap();
    assert_relative_eq!(load.f_x, F_K * load.f_z, max_relative = 1e-14);
}

#[test]
fn a_failed_step_leaves_the_state() {
    let mut law = law(F_S, F_K);
    law.advance(at(1.0, 0.1)).unwrap();
    let before = law.clone();
    let across = Shift { eta: 0.1, ..at(1.0, 0.1) };
    assert_eq!(law.advance(across).unwrap_err().field, "eta");
    assert_eq!(law.advance(at(f64::NAN, 0.1)).unwrap_err().field, "zeta");
    assert!(!law.jumps(across) && law == before);
}
