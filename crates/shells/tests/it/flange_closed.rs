//! Rings against closed forms.

use std::f64::consts::{FRAC_PI_2, PI};

use carom_shells::Wall;
use carom_shells::flange::{
    EdgeMotion, Flange, Ring, RingForce, RingStiffness, StiffnessKind, Tube, TubeEdge,
};
use carom_shells::fourier::Sector;

use crate::reference::{close, flange, list, number};

/// EI = 1; stretching by 1/EA counts little.
const EA: f64 = 1e7;

fn stiff(out_of_plane: f64, torsion: f64) -> RingStiffness {
    RingStiffness::new(EA, 1.0, out_of_plane, torsion).unwrap()
}

fn ring(radius: f64) -> Ring {
    Ring::new(radius, stiff(1.0, 1.0)).unwrap()
}

/// Opening (pi/4 - 2/pi) P R^3/EI + (pi/4) P R/EA, closing across (2/pi - 1/2) P R^3/EI -
/// P R/(2 EA), M = P R/pi under the load and P R (1/pi - 1/2) across.
#[test]
fn timoshenkos_pinched_ring() {
    let (radius, force) = (2.0, 3.0);
    let pinch = RingForce::pinch(force).unwrap();
    let solved = Flange::bare(ring(radius)).solve(&pinch, 64).unwrap();
    let unit = force * radius * radius * radius;
    let stretching = force * radius / EA / unit;
    let exact = 0.25 * PI - 2.0 / PI + 0.25 * PI * stretching;
    let truncated = 2.0 * solved.partial_sum(0.0).radial / unit - exact;
    assert!((-8e-7..-6e-7).contains(&truncated), "{truncated:e}");
    // The condition of the matrix is about EA.
    close("opening", 2.0 * solved.displacement(0.0).radial / unit, exact, 1e-9);
    let closing = -2.0 * solved.displacement(FRAC_PI_2).radial / unit;
    let exact = number(&flange()["free_ring"], "closing_across_over_PR3_EI") - 0.5 * stretching;
    close("closing", closing, exact, 1e-9);
    // Loads do not depend on EA.
    let section = RingStiffness::new(100.0, 1.0, 1.0, 1.0).unwrap();
    let solved = Flange::bare(Ring::new(radius, section).unwrap()).solve(&pinch, 64).unwrap();
    close("M at the load", solved.loads(0.0).in_plane / (force * radius), 1.0 / PI, 1e-12);
    let quarter = solved.loads(FRAC_PI_2).in_plane / (force * radius);
    close("M across", quarter, 1.0 / PI - 0.5, 1e-12);
    // Cut at a quarter: half of the force on each side.
    close("N across", solved.loads(FRAC_PI_2).stretching, 0.5 * force, 1e-12);
    assert!(solved.loads(0.0).stretching.abs() < 1e-12);
}

/// A section next to a force: its loads jump by the force, with and without a tube.
#[test]
fn loads_jump_by_the_forces() {
    let force = RingForce::at(0.4).unwrap().tangential(3.0).unwrap();
    let force = force.axial_at(2.0, 0.25).unwrap();
    let section = RingStiffness::new(50.0, 1.0, 0.7, 0.4).unwrap();
    let ring = Ring::new(1.0, section).unwrap();
    let tube = Tube::koiter_sanders(1.0, Wall::new(1.0, 0.3, 0.02).unwrap()).unwrap();
    let held = Flange::on_tube(ring.clone(), tube, TubeEdge::at_centroid()).unwrap();
    for flange in [Flange::bare(ring), held] {
        let solved = flange.solve(&[force], 32).unwrap();
        let [before, after] = [-1e-9, 1e-9].map(|beside| solved.loads(0.4 + beside));
        close("N", after.stretching - before.stretching, -3.0, 1e-6);
        close("T", after.torsion - before.torsion, 0.5, 1e-6);
        for (name, jump) in [
            ("M", after.in_plane - before.in_plane),
            ("M_o", after.out_of_plane - before.out_of_plane),
        ] {
            assert!(jump.abs() < 1e-7, "{name}: {jump}");
        }
        let middle = solved.loads(0.4);
        let off = middle.stretching - 0.5 * (before.stretching + after.stretching);
        assert!(off.abs() < 1e-8, "N: {off}");
        let off = middle.torsion - 0.5 * (before.torsion + after.torsion);
        assert!(off.abs() < 1e-8, "T: {off}");
    }
}

/// Few harmonics with the closed tails against many without.
#[test]
fn tails_of_all_forces_replace_many_harmonics() {
    let section = RingStiffness::new(50.0, 1.0, 0.7, 0.4).unwrap();
    let ring = Ring::new(1.5, section).unwrap();
    let force = |component: usize| {
        let force = RingForce::at(0.3).unwrap();
        match component {
            0 => force.radial(1.0),
            1 => force.tangential(1.0),
            2 => force.axial(1.0),
            _ => RingForce::at(0.3).and_then(|at| at.axial_at(1.0, 0.7)),
        }
        .unwrap()
    };
    for component in 0..4 {
        let flange = Flange::bare(ring.clone());
        let [few, many] = [12, 256].map(|order| flange.solve(&[force(component)], order).unwrap());
        for angle in [0.5, 1.7, 3.3, 5.9] {
            let (quick, slow) = (few.displacement(angle), many.displacement(angle));
            for (name, quick, slow, error) in [
                ("w", quick.radial, slow.radial, 2e-5),
                ("u", quick.axial, slow.axial, 1e-5),
                ("beta", quick.rotation, slow.rotation, 3e-4),
            ] {
                let message = format!("{name} of {component} at {angle}: {quick} {slow}");
                assert!((quick - slow).abs() < error, "{message}");
            }
            // A bare ring: statics alone.
            let (quick, slow) = (few.loads(angle), many.partial_loads(angle));
            for (name, quick, slow) in [
                ("N", quick.stretching, slow.stretching),
                ("M", quick.in_plane, slow.in_plane),
                ("M_o", quick.out_of_plane, slow.out_of_plane),
                ("T", quick.torsion, slow.torsion),
            ] {
                let message = format!("{name} of {component} at {angle}: {quick} {slow}");
                assert!((quick - slow).abs() < 1.2e-2, "{message}");
            }
            let (quick, exact) = (few.loads(angle), many.loads(angle));
            let (turn, bend) =
                (quick.torsion - exact.torsion, quick.out_of_plane - exact.out_of_plane);
            assert!(turn.abs() < 1e-10 && bend.abs() < 1e-10, "{component}: {turn:e} {bend:e}");
        }
    }
}

#[test]
fn displacement_converges_as_the_third_power() {
    let exact = 0.25 * PI - 2.0 / PI + 0.25 * PI / EA;
    let error = |n: usize| {
        let solved = Flange::bare(ring(1.0)).solve(&RingForce::pinch(1.0).unwrap(), n).unwrap();
        (2.0 * solved.partial_sum(0.0).radial - exact).abs()
    };
    let rate = (error(16) / error(64)).ln() / 4.0_f64.ln();
    assert!((rate - 3.0).abs() < 0.1, "{rate}");
}

/// Out of the plane, a ring under axial load q_n cos n phi: u_n = q_n R^4/(n^2-1)^2
/// (1/EJ + 1/(n^2 GJ)). A point force has q_n R = P/(2 pi) for each complex harmonic.
#[test]
fn fluegges_ring_out_of_plane() {
    let (radius, out_of_plane, torsion) = (1.5_f64, 0.7, 0.4);
    let ring = Ring::new(radius, stiff(out_of_plane, torsion)).unwrap();
    let force = RingForce::at(0.0).unwrap().axial(1.0).unwrap();
    let solved = Flange::bare(ring).solve(&[force], 20).unwrap();
    for n in 2..=20_i32 {
        let square = f64::from(n * n);
        let load = 1.0 / (2.0 * PI * radius);
        let expected = load * radius.powi(4) / (square - 1.0).powi(2)
            * (1.0 / out_of_plane + 1.0 / (square * torsion));
        let found = solved.coefficient(EdgeMotion::Axial, i64::from(n));
        close("u_n", found.re, expected, 1e-12);
        assert!(found.im.abs() < 1e-13 * expected);
    }
}

#[test]
fn rings_with_stepped_stiffness() {
    let all = flange();
    for case in list(&all, "variable_ring_exact") {
        let (half, factor) = (number(case, "half"), number(case, "factor"));
        let sectors = [0.0, PI].map(|middle| Sector::new(middle, half, factor).unwrap());
        let ring = ring(1.0).with_sectors(StiffnessKind::InPlane, &sectors).unwrap();
        let solve = |n: usize| {
            let solved =
                Flange::bare(ring.clone()).solve(&RingForce::pinch(1.0).unwrap(), n).unwrap();
            let opening = 2.0 * solved.displacement(0.0).radial;
            [
                opening / number(case, "opening") - 1.0,
                solved.loads(0.0).in_plane / number(case, "M_load") - 1.0,
            ]
        };
        let [opening, moment] = solve(32);
        assert!(opening.abs() < 1e-3 && moment.abs() < 1e-3, "{opening:e} {moment:e}");
        let [opening, moment] = solve(128);
        assert!(opening.abs() < 3e-5 && moment.abs() < 1e-5, "{opening:e} {moment:e}");
    }
}

/// A couple that turns the section of one harmonic: EJ beta/R + ... of a uniform twist, R m = EJ
/// beta/R for n = 0.
#[test]
fn uniform_turning_of_the_section() {
    let count = 40;
    let couple = |i: i32| {
        let angle = 2.0 * PI * f64::from(i) / f64::from(count);
        RingForce::at(angle).unwrap().axial_at(1.0, -2.0).unwrap()
    };
    let forces: Vec<_> = (0..count).map(couple).collect();
    let solved = Flange::bare(ring(3.0)).solve(&forces, 8).unwrap();
    // Couple per length m = 40*2/(2 pi R); beta = m R^2/EJ.
    let expected = 80.0 * 3.0 / (2.0 * PI);
    close("beta", solved.partial_sum(1.0).rotation, expected, 1e-12);
    assert!(solved.partial_sum(1.0).axial.abs() < 1e-12);
}

#[test]
fn torsion_of_rectangles() {
    // Timoshenko and Goodier, table of k_1.
    for (ratio, expected) in [(1.0, 0.1406), (1.2, 0.166), (1.5, 0.196), (2.0, 0.229), (5.0, 0.291)]
    {
        let section = RingStiffness::rectangle(2.0, 0.0, ratio, 1.0).unwrap();
        let turned = RingStiffness::rectangle(2.0, 0.0, 1.0, ratio).unwrap();
        assert!((section.torsion() / ratio - expected).abs() < 6e-4);
        assert_eq!(section.torsion(), turned.torsion());
        assert_eq!(section.in_plane(), turned.out_of_plane());
    }
}

/// The ring bends more where its stiffness falls, but it does not tear there.
#[test]
fn displacement_is_continuous_where_stiffness_jumps() {
    for kind in [StiffnessKind::InPlane, StiffnessKind::Stretching] {
        let section = RingStiffness::new(2.0, 0.01, 0.01, 0.01).unwrap();
        let soft = Sector::new(0.7, 0.4, 0.2).unwrap();
        let ring = Ring::new(1.0, section).unwrap().with_sectors(kind, &[soft]).unwrap();
        let solved = Flange::bare(ring).solve(&RingForce::pinch(1.0).unwrap(), 12).unwrap();
        for border in [0.3, 1.1] {
            let [before, after] =
                [-1e-12, 1e-12].map(|beside| solved.displacement(border + beside).radial);
            assert!(
                (after - before).abs() < 1e-9 * before.abs(),
                "{kind:?} {border}: {before} {after}"
            );
        }
    }
}
