//! Coulomb's law while it slips: what it reports, and its tangent.

use carom_laws::coulomb::{CoulombMemory, Tolerance};
use carom_laws::memory::MemoryRegime as Regime;

fn law(tolerance: f64) -> CoulombMemory<[f64; 2]> {
    CoulombMemory::new(Tolerance::new(tolerance).unwrap())
}

/// At constant approach the slip annulus grows inwards as long as the shift goes on, and begins anew at the edge
/// where the shift turns back.
#[test]
fn only_a_shift_that_turns_back_is_a_reversal() {
    for angle in [0.0_f64, 0.7, 2.0, 4.4] {
        let mut law = law(1e-3);
        law.advance(1.0, [0.0; 2]).unwrap();
        let mut to = |x: f64| {
            law.advance(1.0, [x * angle.cos(), x * angle.sin()]).unwrap();
            law.regime()
        };
        for x in [0.1, 0.2, 0.25, 0.5] {
            assert_eq!(to(x), Regime::Slip, "{x}");
        }
        assert_eq!(to(0.4), Regime::Reversal);
        for x in [0.3, 0.0] {
            assert_eq!(to(x), Regime::Slip, "{x}");
        }
        assert_eq!(to(0.1), Regime::Reversal);
        assert_eq!(to(0.11), Regime::Slip);
        assert_eq!(to(5.0), Regime::Sliding);
    }
}

/// Cattaneo and Mindlin: `Phi = zeta^(3/2) - (zeta - X)^(3/2)` along the shift, and across it the secant of
/// the slip annulus, whose tractions turn as a whole.
#[test]
fn the_tangent_of_slip_along_a_line_is_that_of_cattaneo_and_mindlin() {
    for (zeta, shift, angle) in [(1.0, 0.3, 0.4), (0.7, 0.5, 2.3), (2.5, 0.1, -1.2)] {
        let mut law = law(1e-6);
        let (s, c) = f64::sin_cos(angle);
        law.advance(zeta, [0.0; 2]).unwrap();
        for part in [0.5, 1.0] {
            law.advance(zeta, [part * shift * c, part * shift * s]).unwrap();
        }
        let tangent = law.tangent();
        let stick = 1.5 * f64::sqrt(zeta - shift);
        let slip = 1.5 * zeta.sqrt() - stick;
        let approach = [slip * c, slip * s];
        for (i, wanted) in approach.into_iter().enumerate() {
            let got = tangent.by_approach[i];
            assert!((got - wanted).abs() < 1e-9, "{zeta} {shift}: {got} {wanted}");
            let along = tangent.by_shift[i][0] * c + tangent.by_shift[i][1] * s;
            assert!((along - stick * [c, s][i]).abs() < 1e-9, "{along} {stick}");
            let across = tangent.by_shift[i][1] * c - tangent.by_shift[i][0] * s;
            assert!((across - 1.5 * zeta.sqrt() * [-s, c][i]).abs() < 1e-9, "{across}");
        }
    }
}

/// Along a path that turns, and where all sticks, too: finite differences of the force as the step goes on, extrapolated to no
/// difference at all.
#[test]
fn the_tangent_of_turning_slip_is_the_limit_of_differences() {
    let mut steps = 0;
    for (growth, turn) in [(0.0, 0.2), (0.03, 0.35), (-0.02, 0.5), (0.05, 0.1), (0.2, 0.3)] {
        let mut law = law(1e-6);
        law.advance(1.0, [0.0; 2]).unwrap();
        let (mut zeta, mut x, mut angle) = (1.0, [0.0; 2], 0.3_f64);
        for _ in 0..8 {
            angle += turn;
            let dx = [0.12 * angle.cos(), 0.12 * angle.sin()];
            let dz = growth;
            zeta += dz;
            x = [x[0] + dx[0], x[1] + dx[1]];
            law.advance(zeta, x).unwrap();
            if !matches!(law.regime(), Regime::Slip | Regime::Adhesion) {
                continue;
            }
            let start = law.force();
            let rate = |h: f64| {
                let mut on = law.clone();
                let next = on.advance(zeta + h * dz, [x[0] + h * dx[0], x[1] + h * dx[1]]).unwrap();
                [0, 1].map(|i| (next[i] - start[i]) / h)
            };
            let (one, half) = (rate(4e-3), rate(2e-3));
            let tangent = law.tangent();
            let got = [0, 1].map(|i| {
                let row = tangent.by_shift[i];
                row[0] * dx[0] + row[1] * dx[1] + tangent.by_approach[i] * dz
            });
            let off = [0, 1].map(|i| (got[i] - (2.0 * half[i] - one[i])).abs());
            let within = 2e-3 * 0.18;
            assert!(off[0] < within && off[1] < within, "{growth} {turn}: {got:?} {off:?}");
            steps += 1;
        }
    }
    assert!(steps > 20, "{steps}");
}

/// Receding without a shift the force does no work: what is no longer stored is heat.
#[test]
fn receding_without_a_shift_turns_stored_energy_into_heat() {
    for (tolerance, turns) in [(1e-3, 0), (1e-6, 6)] {
        let mut law = law(tolerance);
        law.advance(1.0, [0.0; 2]).unwrap();
        let mut x = [0.4, 0.1];
        law.advance(1.0, x).unwrap();
        for i in 0..turns {
            let angle = 0.5 * f64::from(i);
            x = [x[0] + 0.1 * angle.cos(), x[1] + 0.1 * angle.sin()];
            law.advance(1.0, x).unwrap();
        }
        let mut zeta = 1.0;
        for part in [0.95, 0.8, 0.5, 0.9] {
            zeta *= part;
            let sum = |v: [f64; 2]| v[0] + v[1];
            let (before, heat) = (sum(law.stored_energy()), sum(law.dissipation(zeta, x)));
            law.advance(zeta, x).unwrap();
            let lost = before - sum(law.stored_energy());
            assert!(heat > 1e-4 && (heat - lost).abs() < 1e-5 * before, "{zeta}: {heat} {lost}");
        }
    }
}
