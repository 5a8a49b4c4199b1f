//! The restitution table and map against the exact impact.

use carom_drawn::{Congruential, Draw as _, Xorshift};
use carom_halfspace::Material;
use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
use carom_impact::restitution::{RestitutionTable, restitution_map, with_normal_restitution};
use carom_impact::{Body, Collision, Motion, NormalRestitution};
use carom_laws::friction::Friction;

fn worst(points: usize, range: [f64; 2]) -> (f64, f64) {
    let table = RestitutionTable::shared();
    let mut sequence = Congruential(7);
    let (mut worst, mut covered) = (0.0_f64, 0.0);
    for _ in 0..points {
        let chi = sequence.between(range[0], range[1]);
        let psi = 1.02 * (2.0 * chi - 1.0_f64).max(1.0) * sequence.part();
        let groups = Groups::new(chi, psi).unwrap();
        if !table.covers(groups) {
            continue;
        }
        covered += 1.0 / points as f64;
        let exact = ObliqueImpact::new(groups).unwrap().restitution();
        let error = (table.restitution(groups).unwrap() - exact).abs();
        if error > worst {
            println!("chi {chi} psi {psi}: {error:e}");
            worst = error;
        }
    }
    (worst, covered)
}

#[test]
fn table_is_within_1e_8() {
    assert!(RestitutionTable::shared().size() < 1_000_000);
    for (range, least) in [
        ([0.5, 1.0], 0.999),
        ([1.0, 2.3], 1.0),
        ([2.3, 4.7], 1.0),
        ([4.7, 5.2], 0.999),
        ([5.2, 5.5], 0.98),
        ([5.5, 6.5], 0.99),
    ] {
        let (worst, covered) = worst(8_000, range);
        println!("chi {range:?}: worst {worst:e}, {covered:.5} of the points from the table");
        assert!(worst < 1e-8, "chi {range:?}: {worst:e}");
        assert!(covered > least - 1e-9, "chi {range:?}: {covered}");
    }
}

#[test]
fn table_is_as_good_next_to_the_kinks() {
    let table = RestitutionTable::shared();
    let exact = |chi: f64, psi: f64| ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap();
    let forth = |chi: f64, psi: f64| exact(chi, psi).regimes().last() == Some(Regime::SlideForward);
    let mut sequence = Congruential(11);
    for _ in 0..200 {
        let chi = 1.01 + 5.49 * sequence.part();
        // Where the sense of the final sliding changes.
        let (mut low, mut high) = (1e-3, chi);
        for _ in 0..30 {
            let middle = 0.5 * (low + high);
            if forth(chi, middle) { low = middle } else { high = middle }
        }
        for kink in [low, 1.0, chi, 2.0 * chi - 1.0] {
            for exponent in 1..8 {
                let gap = 10_f64.powi(-exponent) * (0.5 + sequence.part());
                for psi in [kink - gap, kink + gap] {
                    let Ok(groups) = Groups::new(chi, psi) else { continue };
                    let error = table.restitution(groups).unwrap() - exact(chi, psi).restitution();
                    assert!(error.abs() < 1e-8, "chi {chi} psi {psi}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn table_follows_the_edges() {
    let table = RestitutionTable::shared();
    for chi in [0.5_f64, 0.8, 1.0, 1.000_001, 2.0, 3.5, 6.5] {
        for psi in [0.0, 1e-9, 1.0, chi, (2.0 * chi - 1.0).max(0.0), 100.0, f64::INFINITY] {
            let groups = Groups::new(chi, psi).unwrap();
            let exact = ObliqueImpact::new(groups).unwrap().restitution();
            let error = (table.restitution(groups).unwrap() - exact).abs();
            assert!(error < 1e-8, "chi {chi} psi {psi}: {error:e}");
        }
    }
    let outside = Groups::new(30.0, 3.0).unwrap();
    assert!(!table.covers(outside));
    assert_eq!(table.restitution(outside), Ok(ObliqueImpact::new(outside).unwrap().restitution()));
}

#[test]
fn map_is_the_exact_impact_with_progress() {
    let rows = std::sync::atomic::AtomicUsize::new(0);
    let chi = [0.6, 2.0, 3.5];
    let psi = [0.1, 1.2, 2.5, 7.0];
    let map = restitution_map(&chi, &psi, |_| {
        rows.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
    })
    .unwrap();
    assert_eq!(rows.into_inner(), 4);
    for (row, &psi) in map.iter().zip(&psi) {
        for (value, &chi) in row.iter().zip(&chi) {
            let exact = ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap();
            assert_eq!(*value, exact.restitution());
        }
    }
    assert!(restitution_map(&[-1.0], &[1.0], |_| ()).is_err());
}

/// Drawn solid spheres: against the impact itself.
#[test]
fn the_table_with_a_loss_is_as_near_as_it_says() {
    let table = RestitutionTable::shared();
    let mut draw = Xorshift(77);
    let (mut sum, mut worst, count) = (0.0, 0.0_f64, 400);
    for _ in 0..count {
        let (kappa, e) = (0.86 + 0.64 * draw.part(), 0.1 + 0.9 * draw.part());
        let border = 3.5 * (1.0 + e) - kappa * e;
        let groups = Groups::of_spheres(kappa, 1.05 * border * draw.part()).unwrap();
        let error = (table.restitution_with(groups, e).unwrap()
            - with_normal_restitution(groups, e).unwrap())
        .abs();
        sum += error;
        worst = worst.max(error);
    }
    assert!(worst < 3e-3, "{worst}");
    assert!(sum / f64::from(count) < 4e-5, "{}", sum / f64::from(count));
}

#[test]
fn the_table_with_a_loss_goes_over_into_the_elastic_one() {
    let table = RestitutionTable::shared();
    for (kappa, lambda) in [(0.9, 0.3), (1.2, 2.0), (1.5, 4.0), (1.2, 8.0)] {
        let groups = Groups::of_spheres(kappa, lambda).unwrap();
        let at = |e: f64| table.restitution_with(groups, e).unwrap();
        assert_eq!(at(1.0).to_bits(), table.restitution(groups).unwrap().to_bits());
        assert!((at(1.0 - 1e-9) - at(1.0)).abs() < 1e-7);
        // Below .1 the impact is integrated; at 0 it is a closed form.
        assert!((at(0.1 - 1e-9) - at(0.1)).abs() < 1e-3);
        assert!((at(0.0) - (3.5 / lambda - 1.0).min(0.0)).abs() < 1e-12);
    }
}

/// Two balls by the table of R_x leave as by the impact itself; what slides throughout uses all friction.
#[test]
fn tabled_rebounds_are_those_that_are_solved() {
    let mut draw = Xorshift(0x7ab1);
    for k in 0..40 {
        let material = Material::from_young(1e12, 0.3).unwrap();
        let ball = |radius: f64, density: f64, velocity: [f64; 3], spin: [f64; 3]| {
            let ball = Body::sphere(radius, material, density * radius.powi(3)).unwrap();
            ball.moving(Motion::new(velocity, spin).unwrap())
        };
        let mut part = || draw.part();
        let f = 0.05 + part();
        let slip = [3.0 * part() - 1.5, 3.0 * part() - 1.5];
        let one = ball(0.01, 8000.0, [slip[0], slip[1], -1.0 - part()], [9.0 * part(), 0.0, 0.0]);
        let two = ball(0.01 + 0.02 * part(), 3000.0, [0.0; 3], [0.0, 7.0 * part(), 0.0]);
        let e = if k % 2 == 0 { 1.0 } else { 0.4 + 0.6 * part() };
        let collision = Collision::new(one, two, Friction::new(f).unwrap()).unwrap();
        let own = collision.with_normal_restitution(NormalRestitution::new(e).unwrap());
        let tabled = own.tabled().unwrap();
        let kappa = tabled.stiffness_ratio();
        let found = tabled.rebound(f, kappa, tabled.normal_restitution()).unwrap();
        let outcome = own.solve().unwrap();
        let solved = outcome.rebound().unwrap();
        let after = own.frame().to_space(&found.contact_velocity);
        let off = (after - solved.contact_velocity_after).norm();
        assert!(off < 2e-3 && (found.r_x - solved.r_x.unwrap()).abs() < 5e-3, "{k}: {off}");
        for (one, other) in found.motions.iter().zip(&solved.motions) {
            let off = (one.velocity - other.velocity).norm();
            assert!(off + 0.01 * (one.spin - other.spin).norm() < 5e-3, "{k}: {one:?} {other:?}");
        }
        let impulse = own.frame().to_contact(&solved.impulse);
        let uses_all = impulse.xy().norm() > (1.0 - 1e-6) * f * impulse.z.abs();
        assert!(e < 1.0 || tabled.slides(f, kappa) == uses_all, "{k}");
    }
}
