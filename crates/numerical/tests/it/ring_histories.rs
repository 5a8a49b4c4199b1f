//! Random histories of shift, twist and approach against the contact on a grid.

use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, ContactLoad, Shift};
use carom_laws::rings::{RingConstants, RingLaw, Tolerance};
use carom_solver::NumericalLaw;

/// Steps of the grid in one of the path.
const PARTS: usize = 4;

fn hertz(moduli: [f64; 2], poisson: [f64; 2]) -> Hertz {
    let body = |i: usize| Material::from_shear(moduli[i], poisson[i]).unwrap();
    let pair = MaterialPair::new(body(0), body(1)).unwrap();
    Hertz::new(RelativeCurvature::from_coefficients(0.5, 0.5).unwrap(), pair).unwrap()
}

/// A broken line of five legs of 20 steps.
fn path(random: &mut Congruential, size: f64, twist: f64) -> Vec<Shift> {
    let mut at = [0.0; 4];
    let mut path = Vec::new();
    for _ in 0..5 {
        let approach = 0.2 + 0.8 * random.part();
        let [x, y, turn] = std::array::from_fn(|_| random.signed());
        let to = [approach, size * x, size * y, twist * size * turn];
        for k in 1..=20 {
            let part = f64::from(k) / 20.0;
            let [zeta, xi, eta, omega] = std::array::from_fn(|i| at[i] + part * (to[i] - at[i]));
            path.push(Shift { zeta, xi, eta, omega });
        }
        at = to;
    }
    path
}

/// The loads on a path, each step of it in parts.
fn follow<L: ContactLaw>(mut law: L, path: &[Shift], parts: usize) -> Vec<ContactLoad> {
    let mut from = Shift::default();
    let step = |to: &Shift| {
        for k in 1..=parts {
            let part = k as f64 / parts as f64;
            let mix = |a: f64, b: f64| a + part * (b - a);
            let shift = Shift {
                zeta: mix(from.zeta, to.zeta),
                xi: mix(from.xi, to.xi),
                eta: mix(from.eta, to.eta),
                omega: mix(from.omega, to.omega),
            };
            law.advance(shift).unwrap();
        }
        from = *to;
        law.load()
    };
    path.iter().map(step).collect()
}

/// Mean and greatest error of the force over f F_z, and of the torque over f F_z a.
#[derive(Debug, Default)]
struct Errors {
    force: [f64; 2],
    torque: [f64; 2],
    count: f64,
}

impl Errors {
    fn add(&mut self, friction: f64, path: &[Shift], got: &[ContactLoad], want: &[ContactLoad]) {
        for ((at, got), want) in path.iter().zip(got).zip(want) {
            // Few cells of the grid are in a small contact.
            if at.zeta < 0.1 {
                continue;
            }
            let limit = friction * want.f_z;
            let force = (got.f_x - want.f_x).hypot(got.f_y - want.f_y) / limit;
            let torque = (got.m_z - want.m_z).abs() / (limit * at.zeta.sqrt());
            for (sums, off) in [(&mut self.force, force), (&mut self.torque, torque)] {
                *sums = [sums[0] + off, sums[1].max(off)];
            }
            self.count += 1.0;
        }
    }

    fn means(&self) -> [f64; 2] {
        [self.force[0] / self.count, self.torque[0] / self.count]
    }
}

struct Against {
    large: Errors,
    small: Errors,
    other_sign: Errors,
    uncoupled: Errors,
}

/// The errors in large steps (those of the path) and small ones (8 for each), of 6 x 8 rings for particles.
fn against_the_grid(hertz: &Hertz, friction: f64, twist: f64, cells: usize) -> Against {
    let law = |part: f64| {
        let constants = RingConstants::of(hertz).unwrap();
        let constants = RingConstants { gamma: part * constants.gamma, ..constants };
        let friction = Friction::new(friction).unwrap();
        RingLaw::<6, 8>::from_constants(constants, friction, Tolerance::PARTICLES).unwrap()
    };
    let mut errors: [Errors; 4] = std::array::from_fn(|_| Errors::default());
    for seed in [3, 80] {
        let path = path(&mut Congruential(seed), 1.2 * friction, twist);
        let grid = NumericalLaw::new(*hertz, Friction::new(friction).unwrap(), 1.0, cells).unwrap();
        let want = follow(grid.within(1e-6).unwrap(), &path, PARTS);
        for (errors, (part, parts)) in
            errors.iter_mut().zip([(1.0, 1), (1.0, 8), (-1.0, 1), (0.0, 1)])
        {
            errors.add(friction, &path, &follow(law(part), &path, parts), &want);
        }
    }
    let [large, small, other_sign, uncoupled] = errors;
    Against { large, small, other_sign, uncoupled }
}

#[test]
fn random_histories_are_those_of_the_grid() {
    for (moduli, poisson, friction) in [
        ([1.0, 1.0], [0.3, 0.3], 0.3),
        ([1.0, 1.0], [0.0, 0.5], 0.3),
        ([1.0, 0.3], [0.3, 0.2], 0.15),
    ] {
        let hertz = hertz(moduli, poisson);
        for twist in [0.0, 1.0] {
            let against = against_the_grid(&hertz, friction, twist, 24);
            for errors in [&against.large, &against.small] {
                let [force, torque] = errors.means();
                assert!(force < 8e-3 && errors.force[1] < 0.03, "{errors:?}");
                assert!(torque < 5e-3 && errors.torque[1] < 0.02, "{errors:?}");
            }
            if hertz.materials().gamma() == 0.0 {
                continue;
            }
            // Coupling counts, and the sign of gamma as soon as the motion leaves a plane.
            assert!(against.uncoupled.means()[0] > 3.0 * against.large.means()[0]);
            assert!(against.other_sign.means()[1] > 2.5 * against.large.means()[1]);
            if twist > 0.0 {
                assert!(against.other_sign.means()[0] > 2.5 * against.large.means()[0]);
            }
        }
    }
}

/// Great friction moves the centre of a coupled contact; bodies turn about the place where they touch, and the torque is
/// that about the same place.
#[test]
fn a_twist_beside_a_moved_centre_is_that_of_the_grid() {
    let hertz = hertz([1.0, 10.0], [0.0, 0.3]);
    let friction = Friction::new(1.0).unwrap();
    let at = |t: f64| {
        let omega = 0.3 * (2.0 * t).sin();
        Shift { zeta: 0.2 + t, xi: 0.6 * t, eta: 0.4 * t * t, omega }
    };
    let path: Vec<Shift> = (1..=60).map(|step| at(f64::from(step) / 60.0)).collect();
    let (constants, tolerance) =
        (RingConstants::of(&hertz).unwrap(), Tolerance::new(1e-4).unwrap());
    let rings = RingLaw::<8, 16>::from_constants(constants, friction, tolerance).unwrap();
    let grid = NumericalLaw::new(hertz, friction, 1.3, 24).unwrap().within(1e-6).unwrap();
    let (got, want) = (follow(rings, &path, 1), follow(grid, &path, 1));
    let along_y = |at: usize| (got[at].f_y - want[at].f_y).abs() / want[at].f_z;
    // Turned to the wrong side of the centre: .02, .02 and .01.
    assert!([20, 40, 59].into_iter().map(along_y).all(|off| off < 2e-3));
    // Without the torque of the force about the centre: .002.
    assert!((got[59].m_z - want[59].m_z).abs() < 1e-3 * want[59].f_z);
}
