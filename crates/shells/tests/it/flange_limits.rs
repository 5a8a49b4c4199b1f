//! Limits, invariants and refusals of flanges.

use carom_shells::Wall;
use carom_shells::flange::{
    EdgeMotion, Flange, FlangeError, Ring, RingForce, RingStiffness, StiffnessKind, Tube, TubeEdge,
};
use carom_shells::fourier::Sector;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

use crate::reference::close;

fn wall(thickness: f64) -> Wall {
    Wall::new(1.0, 0.3, thickness).unwrap()
}

fn ring() -> Ring {
    Ring::new(1.0, RingStiffness::rectangle(1.0, 0.3, 0.08, 0.1).unwrap()).unwrap()
}

fn opening(flange: &Flange) -> f64 {
    flange.solve(&RingForce::pinch(1.0).unwrap(), 32).unwrap().twice_energy()
}

#[test]
fn thin_tube_leaves_the_ring_free() {
    let tube = Tube::half_momentless(1.0, wall(1e-6)).unwrap();
    let held = Flange::on_tube(ring(), tube, TubeEdge::at_centroid()).unwrap();
    close("opening", opening(&held), opening(&Flange::bare(ring())), 1e-8);
    let whole = Tube::koiter_sanders(1.0, wall(1e-6)).unwrap();
    let whole = Flange::on_tube(ring(), whole, TubeEdge::at_centroid()).unwrap();
    close("opening", opening(&whole), opening(&held), 1e-8);
}

/// Published comparison of the theories: opening by pinching agrees for thin walls, prying does
/// not.
#[test]
fn theories_agree_for_pinching_and_not_for_prying() {
    let expected = [
        (0.005, 3e-5, -0.021),
        (0.01, 3.6e-4, -0.061),
        (0.02, 2.9e-3, -0.127),
        (0.05, 1.8e-2, -0.204),
    ];
    for (thickness, pinch, pry) in expected {
        let tubes = [
            Tube::half_momentless(1.0, wall(thickness)).unwrap(),
            Tube::koiter_sanders(1.0, wall(thickness)).unwrap(),
        ];
        let section = RingStiffness::new(
            0.008,
            0.08 * 1e-3 / 12.0,
            0.1 * 0.000_512 / 12.0,
            0.1957 * 0.1 * 0.000_512 / 2.6,
        );
        let ring = Ring::new(1.0, section.unwrap()).unwrap();
        let [main, whole] =
            tubes.map(|tube| Flange::on_tube(ring.clone(), tube, TubeEdge::at_centroid()).unwrap());
        let solve = |flange: &Flange, forces: [RingForce; 2]| flange.solve(&forces, 64).unwrap();
        let ratio = |forces: [RingForce; 2]| {
            solve(&main, forces).twice_energy() / solve(&whole, forces).twice_energy() - 1.0
        };
        let (found_pinch, found_pry) =
            (ratio(RingForce::pinch(1.0).unwrap()), ratio(RingForce::pry(1.0).unwrap()));
        assert!((found_pinch / pinch - 1.0).abs() < 0.1, "{found_pinch} {pinch}");
        assert!((found_pry / pry - 1.0).abs() < 0.05, "{found_pry} {pry}");
        let pried = solve(&main, RingForce::pry(1.0).unwrap()).shallowness().unwrap();
        let pinched = solve(&main, RingForce::pinch(1.0).unwrap()).shallowness().unwrap();
        println!("t = {thickness}: pinch {pinched:?}, pry {pried:?}");
        assert!(pried.mean > 2.0 * pinched.mean);
        // An oval above all, then the other even harmonics, whose energy falls fast.
        assert_eq!((pinched.harmonic, pinched.of_greatest), (2, 4.0 * thickness));
        let mean = pinched.mean / thickness;
        assert!(mean > 4.0 && mean < 5.0, "{mean}");
        let wide = Tube::half_momentless(1.1, wall(thickness)).unwrap();
        let wide = Flange::on_tube(ring.clone(), wide, TubeEdge::at_centroid()).unwrap();
        let wide = solve(&wide, RingForce::pinch(1.0).unwrap()).shallowness().unwrap();
        assert_eq!(wide.of_greatest, 4.0 * (thickness / 1.1), "the radius is that of the tube");
    }
}

#[test]
fn long_tube_is_semi_infinite_and_short_one_a_cantilever() {
    let semi = Tube::half_momentless(1.0, wall(0.02)).unwrap();
    let long = Tube::half_momentless_clamped(1.0, wall(0.02), 500.0).unwrap();
    let entry = |tube: &Tube, k: i64, on: EdgeMotion, by: EdgeMotion| {
        tube.edge_stiffness(k).unwrap().entry(on, by)
    };
    for k in [2, 3, 7] {
        let value = |tube: &Tube| entry(tube, k, EdgeMotion::Tangential, EdgeMotion::Axial);
        assert!((value(&semi) - value(&long)).norm() < 1e-14 * value(&semi).norm());
    }
    // n = 1: a beam of E I = pi E t R^3, force 12 E I/L^3 for the deflection w = cos phi (w_1 = 1/2,
    // v follows), twice that energy over both k.
    let length = 40.0;
    let short = Tube::half_momentless_clamped(1.0, wall(0.02), length).unwrap();
    let force = entry(&short, 1, EdgeMotion::Tangential, EdgeMotion::Tangential)
        - entry(&semi, 1, EdgeMotion::Tangential, EdgeMotion::Tangential);
    close("cantilever", force.re, 2.0 * 12.0 * PI * 0.02 / length.powi(3), 1e-8);
}

/// The beam on a foundation, clamped at its end, as mu L passes from the series to the functions.
/// A clamped tube under a uniform torque M turns by M L/(2 pi R^3 t G), under an axial force F stretches by
/// F L/(2 pi R t E).
#[test]
fn a_clamped_tube_twists_and_stretches_as_a_thin_one() {
    let (radius, length, modulus, nu, thickness) = (0.3, 2.0, 7.0, 0.25, 0.01);
    let wall = Wall::new(modulus, nu, thickness).unwrap();
    let tube = Tube::half_momentless_clamped(radius, wall, length).unwrap();
    let edge = tube.edge_stiffness(0).unwrap();
    let of = |motion| edge.entry(motion, motion).re;
    // The tangential motion of the edge is the angle times R, its load the torque over R.
    let torsion = of(EdgeMotion::Tangential) * radius * radius;
    let shear_modulus = modulus / (2.0 * (1.0 + nu));
    let thin = TAU * radius * thickness / length;
    approx::assert_relative_eq!(
        torsion,
        thin * radius * radius * shear_modulus,
        max_relative = 1e-12
    );
    approx::assert_relative_eq!(of(EdgeMotion::Axial), thin * modulus, max_relative = 1e-12);
}

#[test]
fn clamped_ends_join_smoothly() {
    let tube = |length: f64| Tube::half_momentless_clamped(1.0, wall(0.02), length).unwrap();
    let length = 1.0 / tube(1.0).main_decay(2);
    let entry = |length: f64| {
        let edge = tube(length).edge_stiffness(2).unwrap();
        edge.entry(EdgeMotion::Tangential, EdgeMotion::Tangential).re
    };
    let [before, at, after] = [1.0 - 1e-6, 1.0 - 1e-12, 1.0 + 1e-6].map(|f| entry(f * length));
    close("middle", at, 0.5 * (before + after), 1e-9);
}

#[test]
fn thickening_tube_stiffens() {
    let theories: [fn(f64, Wall) -> _; 2] = [Tube::half_momentless, Tube::koiter_sanders];
    for theory in theories {
        let mut last = opening(&Flange::bare(ring()));
        for thickness in [1e-4, 1e-3, 1e-2, 0.05, 0.2] {
            let tube = theory(1.0, wall(thickness)).unwrap();
            let next = opening(&Flange::on_tube(ring(), tube, TubeEdge::at_centroid()).unwrap());
            assert!(next < last);
            last = next;
        }
    }
}

fn any_flange(
    holes: &[(f64, f64)],
    thickness: f64,
    edge: TubeEdge,
    is_whole: bool,
    scale: [f64; 2],
) -> Flange {
    let [length, modulus] = scale;
    let count = holes.len() as f64;
    let sectors: Vec<_> = holes
        .iter()
        .enumerate()
        .map(|(i, &(half, factor))| Sector::new(TAU * i as f64 / count, half, factor).unwrap())
        .collect();
    let section = RingStiffness::rectangle(modulus, 0.3, 0.08 * length, 0.1 * length).unwrap();
    let mut ring = Ring::new(length, section).unwrap();
    for kind in StiffnessKind::ALL {
        ring = ring.with_sectors(kind, &sectors).unwrap();
    }
    let wall = Wall::new(modulus, 0.3, thickness * length).unwrap();
    let tube = if is_whole {
        Tube::koiter_sanders(length, wall)
    } else {
        Tube::half_momentless(length, wall)
    };
    let edge = TubeEdge::new(edge.along() * length, edge.outward() * length).unwrap();
    Flange::on_tube(ring, tube.unwrap(), edge).unwrap()
}

fn forces(angle: f64) -> [RingForce; 3] {
    let at = RingForce::at(angle).unwrap();
    [at.radial(1.0), at.tangential(1.0), at.axial(1.0)].map(Result::unwrap)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The displacement at one place due to a load at another is that with both exchanged, and a
    /// load does positive work.
    #[test]
    fn reciprocity_with_variable_stiffness(
        holes in proptest::collection::vec((0.02..0.3_f64, 0.2..5.0_f64), 1..6),
        thickness in 0.002..0.1_f64,
        along in -0.05..0.05_f64,
        outward in -0.05..0.05_f64,
        is_whole in any::<bool>(),
        places in (0.0..TAU, 0.0..TAU),
    ) {
        let edge = TubeEdge::new(along, outward).unwrap();
        let flange = any_flange(&holes, thickness, edge, is_whole, [1.0, 1.0]);
        let (one, other) = (forces(places.0), forces(places.1));
        let solve = |force: RingForce| flange.solve(&[force], 12).unwrap();
        let at = |force: RingForce, angle: f64| {
            let y = solve(force).partial_sum(angle);
            [y.radial, y.tangential, y.axial]
        };
        for (i, first) in one.into_iter().enumerate() {
            prop_assert!(solve(first).twice_energy() > 0.0);
            for (j, second) in other.into_iter().enumerate() {
                let (there, back) = (at(first, places.1)[j], at(second, places.0)[i]);
                let size = (solve(first).twice_energy() * solve(second).twice_energy()).sqrt();
                prop_assert!((there - back).abs() < 1e-10 * size, "{there} {back} {size}");
            }
        }
    }

    /// The edge of a tube never gives energy.
    #[test]
    fn edges_store_energy(
        thickness in 1e-6..0.2_f64, poisson in 0.0..0.5_f64, k in -200..200_i64,
        is_whole in any::<bool>(),
        motion in proptest::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64), 4),
    ) {
        let wall = Wall::new(1.0, poisson, thickness).unwrap();
        let tube = if is_whole { Tube::koiter_sanders(1.0, wall) } else { Tube::half_momentless(1.0, wall) };
        let edge = tube.unwrap().edge_stiffness(k).unwrap();
        let all = [EdgeMotion::Radial, EdgeMotion::Tangential, EdgeMotion::Axial, EdgeMotion::Rotation];
        let complex = |i: usize| carom_shells::fourier::Complex::new(motion[i].0, motion[i].1);
        let (mut energy, mut size) = (0.0, 0.0);
        for (i, &on) in all.iter().enumerate() {
            for (j, &by) in all.iter().enumerate() {
                let part = (complex(i).conj() * edge.entry(on, by) * complex(j)).re;
                prop_assert!((edge.entry(on, by) - edge.entry(by, on).conj()).norm() <= 1e-12 * edge.entry(on, by).norm());
                energy += part;
                size += part.abs();
            }
        }
        prop_assert!(energy > -1e-13 * size, "{energy:e} {size:e}");
    }

    /// SI or other units: lengths by 1000, moduli by 1e11.
    #[test]
    fn units_do_not_matter(thickness in 0.002..0.1_f64, is_whole in any::<bool>()) {
        let edge = TubeEdge::new(0.02, 0.01).unwrap();
        let [one, other] = [[1.0, 1.0], [1e-3, 2e11]].map(|scale| {
            any_flange(&[(0.1, 0.5), (0.2, 3.0)], thickness, edge, is_whole, scale)
        });
        let solve = |flange: &Flange| flange.solve(&RingForce::pinch(1.0).unwrap(), 16).unwrap();
        let (one, other) = (solve(&one), solve(&other));
        let ratio = one.twice_energy() / other.twice_energy() / (1e-3 * 2e11);
        prop_assert!((ratio - 1.0).abs() < 1e-10, "{ratio}");
        let ratio = one.truncation() / other.truncation();
        prop_assert!((ratio - 1.0).abs() < 1e-6, "{ratio}");
    }
}

#[test]
fn uniform_by_blocks_is_uniform_as_a_whole() {
    let almost = Sector::new(1.0, 0.5, 1.0 + 1e-15).unwrap();
    let tube = Tube::koiter_sanders(1.0, wall(0.02)).unwrap();
    let flange =
        |ring: Ring| Flange::on_tube(ring, tube, TubeEdge::new(0.03, 0.0).unwrap()).unwrap();
    let whole = flange(ring().with_sectors(StiffnessKind::Torsion, &[almost]).unwrap());
    let [one, other] = [flange(ring()), whole]
        .map(|flange| flange.solve(&RingForce::pry(1.0).unwrap(), 24).unwrap());
    assert!(one.truncation() > 0.0 && one.truncation() < 1e-2);
    for angle in [0.0, 0.4, 2.0] {
        close("u", one.partial_sum(angle).axial, other.partial_sum(angle).axial, 1e-11);
    }
}

#[test]
fn bad_flanges_are_refused() {
    let field = |result: Result<Flange, carom_special::RangeError>| result.unwrap_err().field;
    assert_eq!(Tube::half_momentless(1.0, wall(0.3)).unwrap_err().field, "thickness");
    assert_eq!(Tube::koiter_sanders(1.0, wall(1e-7)).unwrap_err().field, "thickness");
    assert_eq!(Tube::koiter_sanders(-1.0, wall(0.1)).unwrap_err().field, "radius");
    assert_eq!(Tube::half_momentless_clamped(1.0, wall(0.01), 0.1).unwrap_err().field, "length");
    assert_eq!(
        Tube::half_momentless_clamped(1.0, wall(0.01), f64::NAN).unwrap_err().field,
        "length"
    );
    assert_eq!(Wall::new(1.0, 0.6, 1.0).unwrap_err().field, "poisson");
    assert_eq!(Wall::new(f64::INFINITY, 0.3, 1.0).unwrap_err().field, "young_modulus");
    assert_eq!(RingStiffness::new(1.0, 0.0, 1.0, 1.0).unwrap_err().field, "in_plane");
    assert_eq!(RingStiffness::rectangle(1.0, 0.3, 1.0, 1e4).unwrap_err().field, "along/outward");
    let stocky = RingStiffness::rectangle(1.0, 0.3, 0.1, 0.9).unwrap();
    assert_eq!(Ring::new(1.0, stocky).unwrap_err().field, "in_plane");
    let tube = Tube::half_momentless(1.0, wall(0.02)).unwrap();
    let wide = Tube::half_momentless(2.0, wall(0.02)).unwrap();
    assert_eq!(field(Flange::on_tube(ring(), wide, TubeEdge::at_centroid())), "radius of the tube");
    let far = TubeEdge::new(0.0, -0.5).unwrap();
    assert_eq!(field(Flange::on_tube(ring(), tube, far)), "outward");
    assert!(RingForce::at(f64::NAN).is_err() && RingForce::pinch(f64::INFINITY).is_err());
    for harmonics in [0, 3, 257] {
        let error = Flange::bare(ring()).solve(&RingForce::pinch(1.0).unwrap(), harmonics);
        assert!(matches!(error, Err(FlangeError::Range(error)) if error.field == "harmonics"));
    }
}
