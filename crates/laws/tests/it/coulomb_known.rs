//! Coulomb's law in two directions compared with closed forms.

use carom_laws::coulomb::{CoulombMemory, Tolerance};
use carom_laws::memory::MemoryRegime;

/// On a circle of radius R a ring of limit r < R follows on a circle of radius sqrt(R^2 - r^2), its
/// stretch a tangent to it; a stiffer one stays in the middle.
#[test]
fn steady_circle_is_made_of_tractrices_of_a_circle() {
    for radius in [0.2, 0.5, 0.9] {
        for (turn, tolerance) in [(37, 1e-4), (200, 1e-4), (1000, 1e-3)] {
            let tolerance = Tolerance::new(tolerance).unwrap();
            let mut law = CoulombMemory::<[f64; 2]>::new(tolerance);
            law.advance(1.0, [0.0; 2]).unwrap();
            let (mut x, mut force) = ([0.0; 2], [0.0; 2]);
            for step in 0..=20 * turn {
                let angle = std::f64::consts::TAU * f64::from(step) / f64::from(turn);
                x = [radius * angle.cos(), radius * angle.sin()];
                force = law.advance(1.0, x).unwrap();
            }
            let n = 200_000;
            let edge = (1.0_f64 - radius).sqrt();
            let mut want = [1.5 * radius * edge, 0.0];
            for i in 0..n {
                let t = edge + (1.0 - edge) * (f64::from(i) + 0.5) / f64::from(n);
                let r = 1.0 - t * t;
                let weight = 1.5 * (1.0 - edge) / f64::from(n);
                want[0] += weight * r * r / radius;
                want[1] += weight * r * (1.0 - r * r / (radius * radius)).max(0.0).sqrt();
            }
            let got = [
                (force[0] * x[0] + force[1] * x[1]) / radius,
                (force[1] * x[0] - force[0] * x[1]) / radius,
            ];
            let error = (got[0] - want[0]).hypot(got[1] - want[1]);
            // The chords of the circle lag behind by the square of their angle.
            let lag = 10.0 / f64::from(turn * turn);
            assert!(error < tolerance.get() + lag + 1e-3, "{radius} {turn}: {got:?} {want:?}");
        }
    }
}

/// Slid far and then straight on across: all rings are behind the tip in the end.
#[test]
fn gross_sliding_turns_all_traction_into_its_own_direction() {
    let mut law = CoulombMemory::<[f64; 2]>::new(Tolerance::PARTICLES);
    for (zeta, x) in [(1.0, [0.0; 2]), (1.0, [3.0, 0.0]), (0.7, [3.0, 60.0])] {
        law.advance(zeta, x).unwrap();
    }
    let limit = 0.7_f64.powf(1.5);
    assert!(law.force()[0].abs() < 1e-14 && (law.force()[1] - limit).abs() < 1e-14);
    assert_eq!((law.stick_depth(), law.stick_fraction()), (0.0, 0.0));
}

/// However far a step slides, and whatever round-off the shift has there: all traction is along the step.
#[test]
fn a_slide_of_any_length_ends_at_the_limit_along_itself() {
    for power in [3, 6, 7, 9, 12, 14, 15, 16, 17, 20, 38, 60] {
        let length = 10_f64.powi(power);
        for zeta in [1e-3, 0.5, 1.0, 1.5] {
            let mut touching = CoulombMemory::<[f64; 2]>::new(Tolerance::FINE);
            for shift in [[0.0; 2], [0.3, 0.1], [0.1, 0.4]] {
                touching.advance(1.0, shift).unwrap();
            }
            let mut apart = touching.clone();
            apart.advance(-1.0, [0.1, 0.4]).unwrap();
            for mut law in [touching, apart] {
                let force = law.advance(zeta, [0.1 + 0.6 * length, 0.4 - 0.8 * length]).unwrap();
                let limit = zeta.powf(1.5);
                let off = (force[0] - 0.6 * limit).hypot(force[1] + 0.8 * limit);
                assert!(off < 1e-9 * limit, "1e{power} {zeta}: {force:?}");
                assert_eq!(law.regime(), MemoryRegime::Sliding, "1e{power} {zeta}");
            }
        }
    }
}
