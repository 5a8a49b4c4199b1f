//! Impacts of spheres by rings, with and without a spin about the normal, against an integration of the contact on a grid.

use carom_halfspace::{Material, MaterialPair};
use carom_impact::{Body, Collision, Motion, NormalRestitution, RingImpact};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw as _, Shift};
use carom_laws::rings::{RingLaw, Tolerance};
use carom_numerical::NumericalImpact;
use carom_solver::NumericalLaw;
use std::f64::consts::TAU;

/// The rate of the torsional motion of a ball by a torque, in units of its mass and radius.
const ABOUT: f64 = 2.5;

/// The default tolerance.
const USUAL: f64 = RingImpact::TOLERANCE;

/// A ball of radius and mass 1 that meets a plane with velocity 1.
struct Drawn {
    materials: [Material; 2],
    friction: f64,
    /// The tangential velocity over f v_z, and the velocity of the spin at the rim of the largest contact.
    slips: [f64; 2],
    /// a/R of the largest contact.
    large: f64,
    direction: f64,
}

/// Evenly spread numbers from 0 to 1.
fn spread(place: usize) -> f64 {
    (place as f64 * 0.618_033_988_749_894_9).fract()
}

fn between(low: f64, high: f64, part: f64) -> f64 {
    low * (high / low).powf(part)
}

impl Drawn {
    fn new(impact: usize) -> Self {
        let draw = |number: usize| spread(11 * impact + number + 5);
        let is_like = impact.is_multiple_of(2);
        let ratio = if is_like { 1.0 } else { between(0.02, 50.0, draw(0)) };
        let nu = [draw(1), if is_like { draw(1) } else { draw(2) }].map(|part| 0.5 * part);
        let large = 0.02 + 0.04 * draw(3);
        let of = |unit: f64| {
            let material = |g: f64, nu: f64| Material::from_shear(g, nu).unwrap();
            [material(unit, nu[0]), material(ratio * unit, nu[1])]
        };
        // Hertz's impact: (a/R)^5 = 15/16 m v^2/(E* R^3).
        let [one, two] = of(1.0);
        let unit = MaterialPair::new(one, two).unwrap().contact_modulus();
        let sign = if draw(4) < 0.5 { -1.0 } else { 1.0 };
        Self {
            materials: of(15.0 / 16.0 / large.powi(5) / unit),
            friction: between(0.05, 0.6, draw(5)),
            slips: [between(0.1, 8.0, draw(6)), sign * between(0.2, 5.0, draw(7))],
            large,
            direction: TAU * draw(8),
        }
    }

    fn spin(&self) -> f64 {
        self.slips[1] * self.friction / self.large
    }

    /// With all motions turned about the normal.
    fn collision(&self, turn: f64) -> Collision {
        let (sin, cos) = (self.direction + turn).sin_cos();
        let slip = self.slips[0] * self.friction;
        let motion = Motion::new([slip * cos, slip * sin, -1.0], [0.0, 0.0, self.spin()]).unwrap();
        let ball = Body::sphere(1.0, self.materials[0], 1.0).unwrap().moving(motion);
        let plane = Body::plane(self.materials[1]);
        Collision::new(ball, plane, Friction::new(self.friction).unwrap()).unwrap()
    }

    /// The tangential velocity after the impact over f v_z, in the axes of the contact, by leapfrog steps.
    fn on_grid(&self, cells: usize, steps: usize) -> [f64; 2] {
        let collision = self.collision(0.0);
        let law =
            NumericalLaw::new(*collision.hertz(), collision.friction(), self.large.powi(2), cells);
        let mut law = law.unwrap().within(1e-5).unwrap().with_slip_ahead();
        let d = collision.mobility().matrix();
        let mobility = [d.m33, d.m11, d.m22, ABOUT];
        let before = collision.impact().unwrap().unwrap().velocity();
        let h = 2.943 * self.large.powi(2) / steps as f64;
        let omega = self.spin() * collision.frame().z().z.signum();
        let (mut at, mut rates) = ([0.0; 4], [before.z, before.x, before.y, omega]);
        let mut load = [0.0; 4];
        let pushed = |rates: &[f64; 4], load: &[f64; 4], time: f64| -> [f64; 4] {
            std::array::from_fn(|i| rates[i] - mobility[i] * load[i] * time)
        };
        loop {
            let middle = pushed(&rates, &load, 0.5 * h);
            let next: [f64; 4] = std::array::from_fn(|i| at[i] + h * middle[i]);
            if next[0] <= 0.0 {
                // The force falls with the power 3/2 of the rest of the time.
                let after = pushed(&rates, &load, 0.4 * h * at[0] / (at[0] - next[0]));
                return [after[1], after[2]].map(|rate| rate / self.friction);
            }
            let [zeta, xi, eta, omega] = next;
            let now = law.advance(Shift { zeta, xi, eta, omega }).unwrap();
            load = [now.f_z, now.f_x, now.f_y, now.m_z];
            (at, rates) = (next, pushed(&middle, &load, 0.5 * h));
        }
    }

    /// The same by rings, in the axes of the motions, and the estimate of its error.
    fn by_rings(&self, turn: f64, tolerance: f64) -> ([f64; 2], f64) {
        let collision = self.collision(turn);
        let outcome = RingImpact::new(&collision).within(tolerance).unwrap().solve().unwrap();
        let rebound = outcome.rebound().unwrap();
        let after = rebound.contact_velocity_after / self.friction;
        let (sin, cos) = turn.sin_cos();
        let before = 1.0_f64.hypot(self.slips[0] * self.friction);
        let turned = [cos * after.x + sin * after.y, cos * after.y - sin * after.x];
        (turned, rebound.error_estimate * before / self.friction)
    }
}

fn off(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The errors of some impacts over f v_z beyond that of the grid, and the estimates, at each tolerance.
fn errors<const N: usize>(
    impacts: impl Iterator<Item = Drawn>,
    tolerances: [f64; N],
) -> Vec<[[f64; 2]; N]> {
    let of = |drawn: Drawn| {
        let frame = *drawn.collision(0.0).frame();
        let [coarse, fine] = [64, 128].map(|steps| drawn.on_grid(36, steps));
        let fewer = drawn.on_grid(26, 64);
        let limit: [f64; 2] = std::array::from_fn(|i| fine[i] + (fine[i] - coarse[i]) / 3.0);
        let own = off(fine, coarse) / 3.0 + off(fewer, coarse);
        tolerances.map(|tolerance| {
            let (after, estimate) = drawn.by_rings(0.0, tolerance);
            let along = |axis: nalgebra::Vector3<f64>| axis.x * after[0] + axis.y * after[1];
            [(off([along(frame.x()), along(frame.y())], limit) - own).max(0.0), estimate]
        })
    };
    impacts.map(of).collect()
}

fn assert_covered(errors: &[[f64; 2]], mean: f64) {
    let count = errors.len();
    let ratio = |[error, estimate]: &[f64; 2]| error / estimate;
    assert!(errors.iter().all(|pair| ratio(pair) < 2.0), "{errors:?}");
    let wide = errors.iter().filter(|pair| ratio(pair) > 1.0).count();
    assert!(wide <= errors.len().div_ceil(20), "{errors:?}");
    let sum: f64 = errors.iter().map(|[error, _]| error).sum();
    assert!(sum < mean * count as f64, "{errors:?}");
}

#[test]
fn spinning_impacts_by_rings_are_those_on_a_grid_within_their_estimates() {
    assert_covered(errors((0..8).map(Drawn::new), [USUAL]).as_flattened(), 4e-3);
}

#[test]
#[ignore = "takes ten minutes"]
fn three_hundred_spinning_impacts_are_those_on_a_grid_within_their_estimates() {
    assert_covered(errors((8..308).map(Drawn::new), [USUAL]).as_flattened(), 4e-3);
}

/// The drawn ones with odd numbers are of unlike bodies.
#[test]
fn unlike_impacts_without_spin_are_those_on_a_grid_within_their_estimates() {
    let still = |impact: usize| {
        let drawn = Drawn::new(2 * impact + 1);
        Drawn { slips: [drawn.slips[0], 0.0], ..drawn }
    };
    let errors = errors((0..8).map(still), [USUAL, 1e-3]);
    assert_covered(&errors.iter().map(|[usual, _]| *usual).collect::<Vec<_>>(), 3e-3);
    // More rings are not farther off.
    assert_covered(&errors.iter().map(|[_, finer]| *finer).collect::<Vec<_>>(), 2e-3);
}

/// The solution for similar bodies takes friction along the velocity everywhere: nu says how far it is off.
#[test]
fn similar_bodies_by_rings_leave_as_on_a_grid_within_their_estimates() {
    let still = |impact: usize| {
        let drawn = Drawn::new(2 * impact);
        let material = Material::from_shear(drawn.materials[0].shear_modulus(), 0.45).unwrap();
        Drawn { materials: [material; 2], slips: [0.6 + 0.4 * impact as f64, 0.0], ..drawn }
    };
    assert_covered(errors((0..4).map(still), [1e-3]).as_flattened(), 2e-3);
}

/// Where all slides, tractions lift one side of the contact off and press the other: the normal force changes in the third
/// order of gamma f, not by the tension that is cut from the pressures.
#[test]
fn unlike_bodies_that_slide_press_as_on_a_grid() {
    let unlike = Drawn {
        materials: [(1.0, 0.25), (7.34, 0.085)].map(|(g, nu)| Material::from_shear(g, nu).unwrap()),
        friction: 0.47,
        slips: [1.0, 0.0],
        large: 0.025,
        direction: 0.0,
    };
    let collision = unlike.collision(0.0);
    let (hertz, friction, deepest) =
        (*collision.hertz(), collision.friction(), unlike.large.powi(2));
    let gamma = hertz.materials().gamma();
    assert!((gamma.abs() - 0.222).abs() < 2e-3, "{gamma}");
    let mut rings = RingLaw::<12, 8>::new(&hertz, friction, Tolerance::FINE).unwrap();
    let mut grid = NumericalLaw::new(hertz, friction, deepest, 48).unwrap();
    for step in 1..=16 {
        let zeta = deepest * (f64::from(step) / 16.0).powi(2);
        let to = Shift { zeta, xi: 20.0 * friction.get() * zeta, eta: 0.0, omega: 0.0 };
        let [one, other] = [rings.advance(to).unwrap(), grid.advance(to).unwrap()];
        if step == 16 {
            let hertz = 2.0 / 3.0 * hertz.stiffness().c_z * zeta.powf(1.5);
            let off = (one.f_z - other.f_z) / hertz;
            assert!(off.abs() < 1.2e-3, "{off}");
            assert!((one.f_x / (friction.get() * one.f_z) - 1.0).abs() < 1e-3, "{one:?}");
        }
    }
}

/// Unlike balls whose material loses energy leave by rings as on a grid. Where slip also runs outwards the load does not tell
/// the step law whether all slides; rings and cells do.
#[test]
fn unlike_bodies_that_lose_energy_leave_by_rings_as_on_a_grid() {
    for (unlike, lambda, e) in [(0.1, 3.0, 0.6), (0.1, 3.0, 0.4), (0.25, 1.2, 0.6)] {
        let [one, two] = [0.2, 0.2 + unlike].map(|nu| Material::from_shear(4e9, nu).unwrap());
        let motion = Motion::new([0.3 * lambda, 0.0, -1.0], [0.0; 3]).unwrap();
        let ball = Body::sphere(1e-3, one, 1e-5).unwrap().moving(motion);
        let friction = Friction::new(0.3).unwrap();
        let collision = Collision::new(ball, Body::plane(two), friction).unwrap();
        let loss = NormalRestitution::new(e).unwrap();
        let collision = collision.with_normal_restitution(loss);
        let rings = RingImpact::new(&collision).solve().unwrap();
        let grid = NumericalImpact::new(&collision).with(20, 96).unwrap().solve().unwrap();
        let [rings, grid] = [rings, grid].map(|outcome| outcome.rebound().unwrap().clone());
        let apart = (rings.contact_velocity_after - grid.contact_velocity_after).norm();
        let before = rings.contact_velocity_before.norm();
        let estimate = rings.error_estimate + grid.error_estimate;
        assert!(apart < (estimate * before).min(8e-3), "{unlike} {lambda} {e}: {apart} {estimate}");
        let heat = (rings.energy.dissipated - grid.energy.dissipated).abs();
        let lost = rings.energy.before - rings.energy.after;
        assert!(heat < 0.01 * lost, "{unlike} {lambda} {e}: {rings:?} {grid:?}");
    }
}

#[test]
fn the_axes_of_the_contact_do_not_matter_to_a_spinning_impact() {
    for impact in 0..30 {
        let drawn = Drawn::new(impact);
        let (first, estimate) = drawn.by_rings(0.0, USUAL);
        for turn in [0.196, 0.393, 1.1, 2.9] {
            let (turned, _) = drawn.by_rings(turn, USUAL);
            assert!(
                off(first, turned) < 1e-6 + 1e-2 * estimate,
                "{impact} {turn}: {first:?} {turned:?}"
            );
        }
    }
}
