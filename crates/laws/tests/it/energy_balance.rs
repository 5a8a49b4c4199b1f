//! Work equals stored plus dissipated energy, step by step, for every law.
//!
//! The heat is computed from the tractions and the slip, the work from the loads by quadrature, so
//! that neither is defined by the other. `CAROM_BALANCE_STEPS` sets a larger number of steps.

use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Dissipative, Shift};
use carom_laws::memory::{AdhesionMemory, Fixed, Growing, Lateral, Memory, VertexStack};
use carom_laws::profile::{Hertzian, NormalProfile, PowerLaw, RoundedFlat};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;

use crate::common::balance::{Energetic, Place, Wanderer, between, step};

/// Of the largest term of a step.
const TOLERANCE: f64 = 1e-12;
/// The same in two directions, where the heat is a quadrature, and of either of them.
const IN_PLANE: [f64; 2] = [1e-11, 1e-10];

fn steps() -> usize {
    match std::env::var("CAROM_BALANCE_STEPS") {
        Ok(steps) => steps.parse().unwrap(),
        Err(_) if cfg!(debug_assertions) => 2_000,
        Err(_) => 5_000,
    }
}

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Energetic for Memory<V, S, P> {
    fn dimension(&self) -> usize {
        V::DIMENSION
    }

    fn place(&self) -> Place {
        (self.zeta(), self.shift().components())
    }

    fn go(&mut self, (zeta, x): Place) -> [f64; 2] {
        self.advance(zeta, V::from_components(x)).unwrap().components()
    }

    fn force(&self, to: Place) -> [f64; 2] {
        self.clone().go(to)
    }

    fn stored(&self) -> [f64; 2] {
        self.stored_energy().components()
    }

    fn heat(&self, (zeta, x): Place) -> [f64; 2] {
        self.dissipation(zeta, V::from_components(x)).components()
    }

    fn limit(&self, zeta: f64) -> f64 {
        self.profile().force(zeta)
    }

    fn vertices(&self) -> Vec<(f64, [f64; 2], [f64; 2])> {
        self.segments().map(|s| (s.from, s.anchor.components(), s.slope.components())).collect()
    }

    fn merges(&self) -> u32 {
        self.merges()
    }
}

/// A memory without slip, with the depths at which it began to grow.
#[derive(Clone)]
struct Stuck<V: Lateral, S: VertexStack<V>, P> {
    memory: AdhesionMemory<V, S, P>,
    profile: P,
    depths: Vec<f64>,
}

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Stuck<V, S, P> {
    fn new(profile: P) -> Self {
        Self { memory: AdhesionMemory::with_profile(profile), profile, depths: Vec::new() }
    }
}

impl<V: Lateral, S: VertexStack<V>, P: NormalProfile> Energetic for Stuck<V, S, P> {
    fn dimension(&self) -> usize {
        V::DIMENSION
    }

    fn place(&self) -> Place {
        (self.memory.zeta(), self.memory.shift().components())
    }

    fn go(&mut self, (zeta, x): Place) -> [f64; 2] {
        let from = self.memory.zeta();
        self.depths.retain(|depth| *depth < zeta);
        if zeta > from {
            self.depths.push(from.max(0.0));
        }
        self.memory.advance(zeta, V::from_components(x)).unwrap().components()
    }

    fn force(&self, to: Place) -> [f64; 2] {
        self.clone().go(to)
    }

    fn stored(&self) -> [f64; 2] {
        self.memory.stored_energy().components()
    }

    fn heat(&self, (zeta, x): Place) -> [f64; 2] {
        self.memory.dissipation(zeta, V::from_components(x)).components()
    }

    fn limit(&self, zeta: f64) -> f64 {
        self.profile.stiffness(zeta) * 3.0
    }

    fn vertices(&self) -> Vec<(f64, [f64; 2], [f64; 2])> {
        let at = |&depth: &f64| (depth, [0.3 * depth, 0.1], [0.5, -0.5]);
        self.depths.iter().map(at).collect()
    }

    fn merges(&self) -> u32 {
        self.memory.merges()
    }

    /// Growth by little and shift by much make anchors so steep that the places between, rounded,
    /// do not lie on them.
    fn least_growth(&self) -> f64 {
        1e-3
    }
}

/// A law on its way, in one direction or two.
fn wander(name: &str, law: &mut dyn Energetic, count: usize) {
    let mut wanderer = Wanderer::new(31);
    let (mut worst, mut least, mut merged, mut beyond) = ([0.0_f64; 2], 0.0_f64, 0, 0);
    for _ in 0..count {
        let mut to = wanderer.next(law);
        if law.dimension() == 1 {
            to.1[1] = 0.0;
        }
        let merges = law.merges();
        if (to.0 - law.place().0).abs() < law.least_growth() {
            to.0 = law.place().0;
        }
        let balance = step(law, to);
        if law.merges() != merges {
            merged += 1; // the state changed beside the step
            continue;
        }
        least = least.min(balance.heat / balance.largest.max(1e-300));
        let share = |error: f64| (error - 8.0 * balance.rounding) / balance.largest.max(1e-300);
        let errors = [share(balance.total), share(balance.error)];
        worst = [0, 1].map(|i| f64::max(worst[i], errors[i]));
        let tolerance = if law.dimension() == 1 { [TOLERANCE; 2] } else { IN_PLANE };
        let fits = (0..2).all(|i| errors[i] <= tolerance[i]);
        beyond += usize::from(errors[0] > TOLERANCE);
        assert!(fits, "{name}: {errors:?} {balance:?} on the way to {to:?}");
    }
    println!(
        "{name}: worst {worst:?}, least heat {least:e}, {merged} of {count} merged, {beyond} beyond"
    );
    assert!(beyond <= count / 10_000 + 1, "{name}: {beyond} of {count}");
    assert!(least > -1e-15 && merged < count / 10, "{name}: {least:e} {merged}");
}

#[test]
fn memories() {
    wander("one direction", &mut Memory::<f64>::new(), 3 * steps());
    wander("two directions", &mut Memory::<[f64; 2]>::new(), steps());
}

#[test]
fn memories_of_fixed_capacity() {
    wander("one direction", &mut Memory::<f64, Fixed<f64, 16>>::new(), steps());
    wander("two", &mut Memory::<[f64; 2], Fixed<[f64; 2], 16>>::new(), steps() / 4);
}

fn profile<P: NormalProfile>(name: &str, profile: P) {
    let mut one = Memory::<f64, Growing<f64>, P>::with_profile(profile);
    wander(name, &mut one, steps() / 2);
    let mut two = Memory::<[f64; 2], Growing<[f64; 2]>, P>::with_profile(profile);
    wander(name, &mut two, steps() / 8);
    wander(name, &mut Stuck::<f64, Growing<f64>, P>::new(profile), steps() / 4);
    let mut two = Stuck::<[f64; 2], Growing<[f64; 2]>, P>::new(profile);
    wander(name, &mut two, steps() / 4);
}

#[test]
fn other_profiles() {
    profile("cone", PowerLaw::CONE);
    profile("nearly flat", PowerLaw::of_shape(4.0).unwrap());
    profile("rounded flat", RoundedFlat::new(0.6).unwrap());
}

/// The law in its own units, which are chosen so that X is the shift; one sum for both directions.
#[derive(Clone)]
struct Shifted(ShiftLaw<[f64; 2]>);

impl Energetic for Shifted {
    fn dimension(&self) -> usize {
        2
    }

    fn place(&self) -> Place {
        (self.0.shift().zeta, [self.0.shift().xi, self.0.shift().eta])
    }

    fn go(&mut self, (zeta, [xi, eta]): Place) -> [f64; 2] {
        let load = self.0.advance(Shift { zeta, xi, eta, omega: 0.0 }).unwrap();
        [load.f_x, load.f_y]
    }

    fn force(&self, to: Place) -> [f64; 2] {
        self.clone().go(to)
    }

    fn stored(&self) -> [f64; 2] {
        let normal = 0.4 * self.0.load().f_z * self.0.shift().zeta.max(0.0);
        [self.0.stored_energy() - normal, 0.0]
    }

    fn heat(&self, (zeta, [xi, eta]): Place) -> [f64; 2] {
        [self.0.dissipation(Shift { zeta, xi, eta, omega: 0.0 }), 0.0]
    }

    fn limit(&self, zeta: f64) -> f64 {
        zeta * zeta.sqrt()
    }

    fn vertices(&self) -> Vec<(f64, [f64; 2], [f64; 2])> {
        self.0.memory().unwrap().vertices()
    }

    fn merges(&self) -> u32 {
        0
    }
}

#[test]
fn law_in_its_own_units() {
    let stiffness = ContactStiffness::new(0.3, 0.3, 1.0).unwrap();
    let mut law = Shifted(ShiftLaw::with_fixed_direction(stiffness, Friction::new(0.3).unwrap()));
    let mut wanderer = Wanderer::new(32);
    for _ in 0..steps() / 2 {
        let to = wanderer.next(&law);
        let to = if (to.0 - law.place().0).abs() < 1e-9 { (law.place().0, to.1) } else { to };
        let balance = step(&mut law, to);
        assert!(balance.heat >= 0.0, "{balance:?}");
        let allowed = IN_PLANE[0] * balance.largest + 8.0 * balance.rounding;
        assert!(balance.total <= allowed, "{balance:?} on the way to {to:?}");
    }
}

#[test]
fn memories_without_slip() {
    wander("one direction", &mut Stuck::<f64, Growing<f64>, _>::new(Hertzian), steps());
    let mut two = Stuck::<[f64; 2], Growing<[f64; 2]>, _>::new(Hertzian);
    wander("two directions", &mut two, steps());
    let mut fixed = Stuck::<[f64; 2], Fixed<[f64; 2], 16>, _>::new(Hertzian);
    wander("fixed capacity", &mut fixed, steps());
}

/// Heat of the last step in one step and in many, and the same from work and stored energy.
#[track_caller]
fn same_heat<V: Lateral>(path: &[(f64, f64)]) -> f64 {
    let mut memory = Memory::<V>::new();
    let (last, before) = path.split_last().unwrap();
    let place = |&(zeta, x): &(f64, f64)| (zeta, [x, 0.0]);
    for to in before {
        memory.go(place(to));
    }
    let (from, to) = (memory.place(), place(last));
    let whole: f64 = memory.heat(to).iter().sum();
    for parts in [7, 100] {
        let (mut law, mut sum) = (memory.clone(), 0.0);
        for i in 1..=parts {
            let at = between(from, to, f64::from(i) / f64::from(parts));
            sum += law.heat(at).iter().sum::<f64>();
            law.go(at);
        }
        assert!((whole - sum).abs() < 1e-13, "{whole} {sum} in {parts}");
    }
    let balance = step(&mut memory, to);
    assert!(balance.total < 1e-14, "{balance:?}");
    whole
}

#[test]
fn receding_along_the_line_of_a_slip_ring() {
    let path = [(1.0, 0.0), (1.0, 0.8), (1.05, 0.4), (0.6, 0.85)];
    let heat = same_heat::<f64>(&path);
    assert!((heat - 0.2048).abs() < 1e-4, "{heat}");
    assert!((same_heat::<[f64; 2]>(&path) - heat).abs() < 1e-13);
}

#[test]
fn receding_through_an_inner_reversal() {
    let path = [(1.0, 0.0), (1.2, -0.05), (0.4, 0.15)];
    let heat = same_heat::<f64>(&path);
    assert!((heat - 0.003_153_6).abs() < 1e-6, "{heat}");
    assert!((same_heat::<[f64; 2]>(&path) - heat).abs() < 1e-13);
}

#[test]
fn heat_scales_with_the_power_five_halves() {
    let path = [(1.0, 0.0), (1.0, 0.8), (1.05, 0.4), (0.6, 0.85), (0.9, -1.6), (0.3, 0.1)];
    let heats = |size: f64| {
        let mut memory = Memory::<[f64; 2]>::new();
        let mut line = Memory::<f64>::new();
        path.map(|(zeta, x)| {
            let to = (size * zeta, [size * x, 0.3 * size * zeta]);
            let heat = [memory.heat(to), line.heat(to)].map(|heat| heat[0] + heat[1]);
            memory.go(to);
            line.go(to);
            heat
        })
    };
    let unit = heats(1.0);
    for exponent in [-80, -60, -3, 3, 60, 80] {
        let size = 10_f64.powi(exponent);
        for (heat, unit) in heats(size).iter().flatten().zip(unit.iter().flatten()) {
            let want = unit * size * size * size.sqrt();
            assert!((heat - want).abs() <= 1e-12 * want, "{size:e}: {heat:e} {want:e}");
        }
    }
}
