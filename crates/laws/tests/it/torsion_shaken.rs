//! Twisted contacts that are shaken: radius and twist go to and fro, so that slip annuli of both signs lie
//! inside each other, as in a bed of grains.
//!
//! What decides without rings that a step has a single slip annulus is checked here against the friction law
//! itself: tractions by quadrature, and torques by an independent half-space solver with rings of equal
//! width.

use carom_drawn::{Draw as _, Splitmix};
use carom_laws::torsion::history::{TwistHistory, sliding_limit};

use crate::torsion_rings::Rings;

/// A path of radius and twist to and fro around a mean, of several frequencies.
struct Shaken {
    radius: [f64; 4],
    twist: [f64; 4],
    size: f64,
}

impl Shaken {
    fn new(random: &mut Splitmix, size: f64) -> Self {
        let mut four = || [0; 4].map(|_| random.between(0.2, 1.0));
        Self { radius: four(), twist: four(), size }
    }

    /// Radius and twist at a time. The twist takes part with up to some times the size.
    fn at(&self, time: f64) -> (f64, f64) {
        let wave = |[a, b, c, d]: [f64; 4]| {
            0.6 * a * (time * (1.0 + b)).sin() + 0.4 * c * (time * (2.0 + 3.0 * d) + 5.0 * a).cos()
        };
        let lift = 1.0 - self.size + self.size * wave(self.radius);
        (lift, 2.5 * self.size * wave(self.twist) + 0.5 * self.size)
    }
}

/// `int_rho^al b/sqrt(s^2 - rho^2) ds`, by the midpoint rule in arcosh(s/rho).
fn traction(history: &TwistHistory, rho: f64) -> f64 {
    let top = (history.radius() / rho).acosh();
    let panels = 3000;
    let width = top / f64::from(panels);
    let density = |i: u32| history.density(rho * ((f64::from(i) + 0.5) * width).cosh());
    (0..panels).map(density).sum::<f64>() * width
}

/// The greatest traction over its limit, where the contact sticks.
fn greatest_share(history: &TwistHistory) -> f64 {
    let al = history.radius();
    (1..60)
        .map(|i| (1.0 - (1.0 - f64::from(i) / 60.0).powi(3)) * history.stick_radius())
        .map(|rho| traction(history, rho).abs() / (((al - rho) * (al + rho)).sqrt() / rho))
        .fold(0.0, f64::max)
}

#[test]
fn tractions_of_shaken_contacts_stay_within_friction() {
    let mut random = Splitmix(5);
    let (mut steps, mut rings, mut worst) = (0, 0, 0.0_f64);
    for size in [3e-3, 0.02, 0.1].into_iter().cycle().take(24) {
        let path = Shaken::new(&mut random, size);
        let mut history = TwistHistory::new();
        history.advance(path.at(0.0).0, 0.0).unwrap();
        for i in 1..=120 {
            let (radius, twist) = path.at(0.15 * f64::from(i));
            let before = history.ring_steps();
            history.advance(radius, twist).unwrap();
            steps += 1;
            if history.ring_steps() > before {
                rings += 1;
                break;
            }
            if i % 5 == 0 {
                worst = worst.max(greatest_share(&history));
            }
        }
    }
    assert!(worst > 0.9 && worst < 1.0 + 2e-3, "{worst}");
    assert!(steps > 2000 && rings < 12, "{steps} {rings}");
}

#[test]
fn torques_of_shaken_contacts_agree_with_an_independent_solver() {
    let rings = Rings::new(160);
    let mut random = Splitmix(23);
    for _ in 0..6 {
        let size = random.between(0.1, 0.25);
        let path = Shaken::new(&mut random, size);
        let mut history = TwistHistory::new();
        let mut solver = rings.at_rest();
        history.advance(path.at(0.0).0, 0.0).unwrap();
        solver.advance(path.at(0.0).0, 0.0);
        let mut worst = 0.0_f64;
        for i in 0..=150 {
            let (radius, twist) = path.at(0.08 * f64::from(i));
            let want = solver.advance(radius, twist);
            let got = history.advance(radius, twist).unwrap();
            worst = worst.max((got - want).abs() / sliding_limit(radius));
        }
        assert!(worst < 5e-3, "{worst}");
    }
}
