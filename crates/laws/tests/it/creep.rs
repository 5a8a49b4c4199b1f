//! Creep coefficients by the table: against what is printed, closed forms, strips and an independent
//! calculation; smoothness; bad input.

use std::f64::consts::PI;

use carom_laws::creep::CreepCoefficients;
use carom_laws::creep::nodes::{axis_ratios, poissons};

use crate::tabled::rows;

fn at(axis_ratio: f64, poisson: f64) -> [f64; 4] {
    let c = CreepCoefficients::by_table(axis_ratio, poisson).unwrap();
    assert_eq!(c.c32, c.c23);
    [c.c11, c.c22, c.c23, c.c33]
}

/// Rows a/b, nu, four printed and four calculated coefficients.
fn kalker() -> Vec<[f64; 10]> {
    rows("rolling/kalker_coefficients.csv")
}

/// Kalker 1990, table E.3, in three digits; C33 was printed from memory.
#[test]
fn the_table_is_kalkers_in_his_digits() {
    let rows = kalker();
    assert_eq!(rows.len(), 57);
    for [ratio, poisson, printed @ .., _, _, _, _] in rows {
        for (which, (got, want)) in at(ratio, poisson).into_iter().zip(printed).enumerate() {
            let off = (got / want - 1.0).abs();
            assert!(off < 0.015, "C{which} at {ratio} {poisson}: {got} {want}");
        }
    }
}

/// Boundary elements in strips of another program, with the accuracy that its file states.
#[test]
fn the_table_is_that_of_an_independent_calculation() {
    for [ratio, poisson, _, _, _, _, calculated @ ..] in kalker() {
        let allowed = match ratio {
            0.1 => [1e-3, 1e-3, 5e-3, 3e-3],
            // A thousandth of the calculation, and one of the table.
            10.0 => [2e-3, 2e-3, 2e-3, 2e-2],
            0.2..2.6 => [3e-4, 3e-4, 5e-4, 1e-3],
            _ => [3e-4, 3e-4, 5e-4, 3e-3],
        };
        for (which, (got, want)) in at(ratio, poisson).into_iter().zip(calculated).enumerate() {
            let off = (got / want - 1.0).abs();
            assert!(off < allowed[which], "C{which} at {ratio} {poisson}: {got} {want} {off:.1e}");
        }
    }
}

/// Full adhesion of a circle without Poisson's ratio, in closed form.
#[test]
fn a_circle_without_poissons_ratio_has_its_closed_forms() {
    let [c11, c22, c23, _] = at(1.0, 0.0);
    let (straight, turned) = (32.0 / (3.0 * PI), 4.0 / 3.0);
    for (got, want) in [(c11, straight), (c22, straight), (c23, turned)] {
        assert!((got / want - 1.0).abs() < 2e-5, "{got} {want}");
    }
}

/// Without Poisson's ratio a traction displaces the surface along itself only.
#[test]
fn without_poissons_ratio_both_directions_are_alike() {
    for i in 0..=60 {
        let [c11, c22, ..] = at(0.05 * 400.0_f64.powf(f64::from(i) / 60.0).min(400.0), 0.0);
        assert!((c11 / c22 - 1.0).abs() < 1e-12);
    }
}

/// A contact that is short along the track consists of strips that roll like cylinders. Carter's
/// force for vanishing creepage is pi G l/(2 (1 - nu)) xi per width, with the half length l of a
/// strip; across, where a strip is sheared out of its plane, 1 takes the place of 1 - nu. Summed
/// over the ellipse: C11 = pi^2/(4 (1 - nu)), C22 = pi^2/4, and by the lever of spin, C33 =
/// pi^2/(16 (1 - nu)) b/a.
#[test]
fn short_contacts_tend_to_strips() {
    for poisson in [0.0, 0.2, 0.35] {
        let off = |ratio: f64| -> [f64; 3] {
            let [c11, c22, _, c33] = at(ratio, poisson);
            let plane = PI * PI / (4.0 * (1.0 - poisson));
            let want = [plane, PI * PI / 4.0, plane / (4.0 * ratio)];
            [c11 / want[0] - 1.0, c22 / want[1] - 1.0, c33 / want[2] - 1.0]
        };
        for (near, far) in off(0.05).into_iter().zip(off(0.15)) {
            println!("{poisson} {near:.4} {far:.4}");
            assert!(near.abs() < 0.02 && far.abs() < 0.1, "{poisson}: {near} {far}");
            assert!(near.abs() < 0.5 * far.abs() || far.abs() < 4e-3, "{poisson}: {near} {far}");
        }
    }
}

/// A contact that is long along the track is a line of traction q, which displaces itself by
/// q L/(2 pi G) in each body, with the logarithm L of its slenderness. So q grows from the leading
/// edge as pi G xi (a - x)/L, and C11 = 2 pi (a/b)/L with L = Lambda - 2 nu, C22 the same with L =
/// (1 - nu) Lambda + 2 nu, Lambda = log(16 a^2/b^2). Kalker's next terms are (3 - log 4)/L and
/// (1 - nu) (3 - log 4)/L of it; in his C23 there is none.
#[test]
fn long_contacts_tend_to_a_line() {
    for poisson in [0.0, 0.1, 0.25, 0.4, 0.5] {
        let next = |ratio: f64| -> [f64; 3] {
            let lambda = (16.0 * ratio * ratio).ln();
            let [along, across] =
                [lambda - 2.0 * poisson, (1.0 - poisson) * lambda + 2.0 * poisson];
            let turned = (1.0 - poisson) * lambda - 2.0 + 4.0 * poisson;
            let [c11, c22, c23, _] = at(ratio, poisson);
            let line = 2.0 * PI * ratio;
            let term = 3.0 - 4.0_f64.ln();
            [
                (c11 * along / line - 1.0) * along / term,
                (c22 * across / line - 1.0) * across / ((1.0 - poisson) * term),
                c23 * turned * 3.0 / (line * ratio.sqrt()),
            ]
        };
        let ([along, across, turned], [farther_along, farther_across, farther]) =
            (next(8.0), next(20.0));
        println!("{poisson}: {:?} {:?}", next(8.0), next(20.0));
        for (near, far) in [(along, farther_along), (across, farther_across)] {
            assert!(far < near && (1.0..1.3).contains(&far), "{poisson}: {near} {far}");
        }
        assert!((turned - 1.0).abs() < 0.015 && (farther - 1.0).abs() < 4e-3, "{turned} {farther}");
    }
}

/// Entries come back, and there is no step beside them.
#[test]
fn the_interpolation_goes_through_its_entries() {
    for ratio in axis_ratios() {
        for poisson in poissons() {
            let entry = at(ratio, poisson);
            let digits = |value: f64| (value * 1e7 - (value * 1e7).round()).abs();
            // As many digits as are stored, up to the rounding of logarithm and exponential.
            assert!(entry.iter().all(|&c| digits(c) < 1e-5), "{ratio} {poisson}: {entry:?}");
            let beside = at((ratio * (1.0 + 1e-13)).min(20.0), (poisson + 1e-14).min(0.5));
            for (one, other) in entry.into_iter().zip(beside) {
                assert!((one / other - 1.0).abs() < 1e-11, "{ratio} {poisson}: {one} {other}");
            }
        }
    }
}

/// Between entries too, each coefficient grows or falls as between them.
#[test]
fn coefficients_grow_with_the_axis_ratio_and_torque_falls() {
    for poisson in [0.0, 0.1, 0.25, 0.4, 0.5] {
        let mut before = at(0.05, poisson);
        for i in 1..=400 {
            let ratio = (0.05 * 400.0_f64.powf(f64::from(i) / 400.0)).min(20.0);
            let now = at(ratio, poisson);
            assert!(now[1] > before[1] && now[2] > before[2], "{ratio} {poisson}: {now:?}");
            assert!(now[3] < before[3], "{ratio} {poisson}: {now:?}");
            // At 1/2 the longitudinal coefficient has a flat minimum at short contacts.
            assert!(now[0] > before[0] || ratio < 0.35, "{ratio} {poisson}: {now:?}");
            before = now;
        }
    }
}

#[test]
fn what_the_table_does_not_have_is_named() {
    for (ratio, poisson, field, value) in [
        (0.0499, 0.3, "axis_ratio", 0.0499),
        (20.001, 0.3, "axis_ratio", 20.001),
        (-1.0, 0.3, "axis_ratio", -1.0),
        (f64::INFINITY, 0.3, "axis_ratio", f64::INFINITY),
        (1.0, -1e-9, "poisson", -1e-9),
        (1.0, 0.500001, "poisson", 0.500001),
    ] {
        let error = CreepCoefficients::by_table(ratio, poisson).unwrap_err();
        assert_eq!((error.field, error.value), (field, value));
    }
    assert!(CreepCoefficients::by_table(f64::NAN, 0.3).unwrap_err().value.is_nan());
    assert!(CreepCoefficients::by_table(1.0, f64::NAN).unwrap_err().value.is_nan());
    for (ratio, poisson) in [(0.05, 0.0), (20.0, 0.5), (0.05, 0.5), (20.0, -0.0)] {
        assert!(at(ratio, poisson).iter().all(|c| c.is_finite() && *c > 0.0));
    }
}
