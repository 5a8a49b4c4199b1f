//! Flanges against the reference, at the given number of harmonics.

use carom_shells::Wall;
use carom_shells::flange::{
    EdgeMotion, Flange, FlangeSolution, Ring, RingForce, RingStiffness, StiffnessKind, Tube,
    TubeEdge,
};
use carom_shells::fourier::Sector;
use serde_json::Value;
use std::f64::consts::{FRAC_PI_2, TAU};

use crate::reference::{close, flange, list, number};

const MOTIONS: [EdgeMotion; 4] =
    [EdgeMotion::Radial, EdgeMotion::Tangential, EdgeMotion::Axial, EdgeMotion::Rotation];

fn section() -> RingStiffness {
    let (along, outward) = (0.08_f64, 0.1_f64);
    RingStiffness::new(
        along * outward,
        along * outward.powi(3) / 12.0,
        outward * along.powi(3) / 12.0,
        0.1957 * outward * along.powi(3) / 2.6,
    )
    .unwrap()
}

fn of_case(case: &Value) -> Flange {
    let mut ring = Ring::new(1.0, section()).unwrap();
    if let Some(holes) = case["holes"].as_array() {
        let sector = |hole: &Value| {
            let [middle, half, factor] = [0, 1, 2].map(|i| hole[i].as_f64().unwrap());
            Sector::new(middle, half, factor).unwrap()
        };
        let sectors: Vec<_> = holes.iter().map(sector).collect();
        ring = ring.with_sectors(StiffnessKind::InPlane, &sectors).unwrap();
    }
    let Some(thickness) = case["t"].as_f64() else { return Flange::bare(ring) };
    let wall = Wall::new(1.0, 0.3, thickness).unwrap();
    let tube = match (case["theory"].as_str().unwrap(), case["length"].as_f64()) {
        ("Koiter-Sanders", None) => Tube::koiter_sanders(1.0, wall),
        ("half-momentless", None) => Tube::half_momentless(1.0, wall),
        (_, Some(length)) => Tube::half_momentless_clamped(1.0, wall, length),
        (other, _) => panic!("theory {other}"),
    };
    let place = |key: &str| case[key].as_f64().unwrap_or(0.0);
    let edge = TubeEdge::new(place("e_x"), place("e_r")).unwrap();
    Flange::on_tube(ring, tube.unwrap(), edge).unwrap()
}

fn check_pinch(name: &str, solved: &FlangeSolution, expected: &Value) {
    let (load, quarter) = (solved.partial_sum(0.0).radial, solved.partial_sum(FRAC_PI_2).radial);
    let error = 1e-9;
    close(name, solved.twice_energy(), number(expected, "opening"), error);
    close(name, load, number(expected, "w_load"), error);
    close(name, quarter, number(expected, "w_quarter"), error);
    close(name, solved.loads(0.0).in_plane, number(expected, "M_load"), error);
    close(name, solved.loads(FRAC_PI_2).in_plane, number(expected, "M_quarter"), error);
}

fn check_pry(name: &str, solved: &FlangeSolution, expected: &Value) {
    let error = 1e-9;
    close(name, solved.partial_sum(0.0).axial, number(expected, "u_load"), error);
    close(name, solved.partial_sum(FRAC_PI_2).axial, number(expected, "u_quarter"), error);
    close(name, solved.partial_sum(0.0).rotation, number(expected, "beta_load"), error);
    close(name, solved.twice_energy(), number(expected, "twice_energy"), error);
}

fn check(kind: &str) {
    let all = flange();
    for case in list(&all, kind) {
        let harmonics = case["n"].as_u64().unwrap() as usize;
        let flange = of_case(case);
        let name = format!("t = {}, n = {harmonics}, {}", case["t"], case["theory"]);
        let pinched = flange.solve(&RingForce::pinch(1.0).unwrap(), harmonics).unwrap();
        check_pinch(&name, &pinched, &case["pinch"]);
        if case["pry"].is_object() {
            let pried = flange.solve(&RingForce::pry(1.0).unwrap(), harmonics).unwrap();
            check_pry(&name, &pried, &case["pry"]);
        }
    }
}

#[test]
fn half_momentless_flanges() {
    check("cases");
}

#[test]
fn flanges_on_the_whole_shell() {
    check("full_shell");
}

fn tube(value: &Value) -> Wall {
    Wall::new(1.0, 0.3, number(value, "t")).unwrap()
}

#[test]
fn edges_by_the_half_momentless_theory() {
    for case in list(&flange(), "tube_edge") {
        let edge = Tube::half_momentless(1.0, tube(case)).unwrap();
        let edge = edge.edge_stiffness(case["n"].as_i64().unwrap()).unwrap();
        for (i, on) in MOTIONS.into_iter().enumerate() {
            for (j, by) in MOTIONS.into_iter().enumerate() {
                // As for energies divided by 2 pi.
                let found = edge.entry(on, by) / TAU;
                let part = |key: &str| case[key][i][j].as_f64().unwrap() / TAU;
                let (re, im) = (part("stiffness_real"), part("stiffness_imag"));
                assert!((found.re - re).abs() < 1e-12 * 0.25 && (found.im - im).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn edges_by_the_whole_shell() {
    for case in list(&flange(), "full_shell_edge") {
        let n = case["n"].as_i64().unwrap();
        let edge = Tube::koiter_sanders(1.0, tube(case)).unwrap().edge_stiffness(n).unwrap();
        for (i, on) in MOTIONS.into_iter().enumerate() {
            for (j, by) in MOTIONS.into_iter().enumerate() {
                // Amplitudes of cosines and sines: v sin n phi is i v e^(i n phi).
                let mut found = edge.entry(on, by);
                let turn =
                    |motion: EdgeMotion| if motion == EdgeMotion::Tangential { 1 } else { 0 };
                found = match turn(by) - turn(on) {
                    1 => found * carom_shells::fourier::Complex::new(0.0, -1.0),
                    -1 => found * carom_shells::fourier::Complex::new(0.0, 1.0),
                    _ => found,
                };
                let expected = case["stiffness"][i][j].as_f64().unwrap();
                let size = case["stiffness"][i][i].as_f64().unwrap()
                    * case["stiffness"][j][j].as_f64().unwrap();
                let error = (found.re - expected).abs() / size.sqrt();
                assert!(error < 1e-12 && found.im.abs() < 1e-15, "{n} {i} {j}: {found} {expected}");
            }
        }
    }
}
