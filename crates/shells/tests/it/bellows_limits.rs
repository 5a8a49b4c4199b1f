//! Paths and limit points, meridians, units, refusals.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use carom_shells::Wall;
use carom_shells::bellows::{
    Axial, Bellows, BellowsError, BellowsLoad, LimitKind, LoadPath, Meridian, PathEnd, WallPoint,
};
use proptest::prelude::*;

use crate::reference::close;

fn wall(thickness: f64) -> Wall {
    Wall::new(1.0, 0.3, thickness).unwrap()
}

fn load(pressure: f64, axial: Axial) -> BellowsLoad {
    BellowsLoad::new(pressure, axial).unwrap()
}

fn corrugated(harmonics: usize) -> Bellows {
    Bellows::new(Meridian::sine(10.0, 1.0, 3.0).unwrap(), wall(0.1), harmonics).unwrap()
}

#[test]
fn paths_end_where_a_direct_solution_does() {
    let bellows = corrugated(32);
    for (pressure, from, to) in [
        (0.0, Axial::Dilatation(0.0), Axial::Dilatation(0.6)),
        (2e-4, Axial::Force(0.0), Axial::Force(-0.06)),
    ] {
        let start = bellows.solve(load(pressure, from)).unwrap();
        let path = bellows.follow(&start, load(pressure, to), 7).unwrap();
        assert_eq!(path.end, PathEnd::Reached);
        assert!(path.states.len() >= 8);
        let direct = bellows.solve(load(pressure, to)).unwrap();
        let last = path.states.last().unwrap();
        close("force", last.force(), direct.force(), 1e-10);
        close("dilatation", last.dilatation(), direct.dilatation(), 1e-10);
        // The stiffness is the slope of the path.
        let step = 1e-4;
        let near = |sign: f64| {
            let growth = Axial::Dilatation(direct.dilatation() + sign * step);
            bellows.solve(load(pressure, growth)).unwrap().force()
        };
        close("stiffness", direct.stiffness(), (near(1.0) - near(-1.0)) / (2.0 * step), 1e-6);
    }
}

/// A nearly straight tube of the critical wave length buckles near the classical load
/// 2 pi E t^2/sqrt(3(1 - nu^2)); waves lower the limit.
#[test]
fn limit_of_a_compressed_tube() {
    let classical = TAU * 0.01 / (3.0_f64 * 0.91).sqrt();
    let limit = |amplitude: f64| {
        let meridian = Meridian::sine(10.0, amplitude, 3.44).unwrap();
        let bellows = Bellows::new(meridian, wall(0.1), 16).unwrap();
        let rest = bellows.solve(load(0.0, Axial::Force(0.0))).unwrap();
        let LoadPath { states, end } =
            bellows.follow(&rest, load(0.0, Axial::Force(-0.08)), 20).unwrap();
        let PathEnd::LimitPoint { kind, state } = end else { panic!("no limit point") };
        assert_eq!(kind, LimitKind::Force);
        let first = states[0].stiffness();
        assert!(state.stiffness().abs() < 1e-9 * first);
        assert!(states.iter().all(|before| before.force() >= state.force()));
        // A little further, under given dilatation, the force is smaller.
        let beyond = load(0.0, Axial::Dilatation(1.05 * state.dilatation()));
        let beyond = bellows.follow(&state, beyond, 4).unwrap();
        assert_eq!(beyond.end, PathEnd::Reached);
        let after = beyond.states.last().unwrap();
        assert!(after.force() > state.force() && after.stiffness() < 0.0);
        -state.force() / classical
    };
    let [straight, shallow, deeper] = [1e-4, 1e-3, 1e-2].map(limit);
    assert!(straight > 0.985 && straight < 1.0, "{straight}");
    assert!(deeper < shallow && shallow < straight, "{deeper} {shallow} {straight}");
}

#[test]
fn deformed_folds_tell_their_distance() {
    let fold = Meridian::u_shaped(10.0, 0.5, 1.0).unwrap();
    close("gap", fold.least_gap(), 1.0, 1e-12);
    let bellows = Bellows::new(fold, wall(0.05), 32).unwrap();
    let gap =
        |growth: f64| bellows.solve(load(0.0, Axial::Dilatation(growth))).unwrap().least_gap();
    assert!((gap(0.0) - 1.0).abs() < 1e-12);
    assert!(gap(-0.5) < gap(-0.2) && gap(-0.2) < 1.0);
    let torus = Bellows::new(Meridian::torus(10.0, 1.0).unwrap(), wall(0.05), 24).unwrap();
    let open = torus.solve(load(0.0, Axial::Dilatation(0.3))).unwrap();
    close("gape", open.least_gap(), 0.3, 1e-9);
}

#[test]
fn series_of_a_u_shaped_meridian_converge_as_the_third_power() {
    let rate = |harmonics: usize| {
        let fold = Meridian::u_shaped(10.0, 0.5, 1.0).unwrap();
        Bellows::new(fold, wall(0.05), harmonics).unwrap().linear_response().unwrap().spring_rate
    };
    let exact = rate(192);
    // The sign of the error changes; its bound goes with the third power.
    for n in [8, 12, 24, 32, 48, 64, 96] {
        let error = (rate(n) / exact - 1.0).abs();
        assert!(error < 0.4 / (n as f64).powi(3), "{n}: {error:e}");
    }
}

/// The four stresses of the linear response in these units and in units of 1: per dilatation in modulus over length,
/// per pressure without units.
fn stresses(length: f64, modulus: f64) -> Vec<(&'static str, f64, f64)> {
    let response = |l: f64, e: f64| {
        let wall = Wall::new(e, 0.3, 0.1 * l).unwrap();
        let meridian = Meridian::sine(10.0 * l, l, 3.0 * l).unwrap();
        Bellows::new(meridian, wall, 16).unwrap().linear_response().unwrap()
    };
    let (one, other) = (response(1.0, 1.0), response(length, modulus));
    let of = |place: &WallPoint| {
        [
            ("meridional membrane", place.meridional_membrane),
            ("meridional bending", place.meridional_bending),
            ("hoop membrane", place.hoop_membrane),
            ("hoop bending", place.hoop_bending),
        ]
    };
    let mut all = Vec::new();
    for (one, other, unit) in [
        (&one.per_dilatation, &other.per_dilatation, modulus / length),
        (&one.per_pressure, &other.per_pressure, 1.0),
    ] {
        // Not at the root or crest, where some vanish.
        let pairs = of(&one[3]).into_iter().zip(of(&other[3]));
        all.extend(pairs.map(|((name, one), (_, other))| (name, unit * one, other)));
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    /// r' = g cos phi, z' = g sin phi, symmetric about crest and root, periodic.
    #[test]
    fn meridians_are_curves(
        kind in 0..4, a in 0.3..0.6_f64, b in 0.1..0.8_f64, turn in 1.0..1.75_f64,
        xi in -7.0..7.0_f64,
    ) {
        let meridian = match kind {
            0 => Meridian::sine(10.0, a, 2.0 * b + 0.5),
            1 => Meridian::u_shaped(10.0, a, b),
            2 => Meridian::folded(10.0, a, b, turn),
            _ => Meridian::torus(10.0, a),
        }.unwrap();
        let step = 1e-6;
        let (at, plus, minus) = (meridian.at(xi), meridian.at(xi + step), meridian.at(xi - step));
        // Not across the slit of a torus or a jump of curvature.
        let is_near_slit = (xi.abs() / PI - (xi.abs() / PI).round()).abs() < 1e-5;
        prop_assume!(!is_near_slit);
        let rate = |one: f64, other: f64| (one - other) / (2.0 * step);
        prop_assert!((rate(plus.radius, minus.radius) - at.speed * at.angle.cos()).abs() < 1e-5);
        prop_assert!((rate(plus.height, minus.height) - at.speed * at.angle.sin()).abs() < 1e-5);
        let image = meridian.at(TAU - xi);
        prop_assert!((image.radius - at.radius).abs() < 1e-12);
        prop_assert!((image.height + at.height - meridian.pitch()).abs() < 1e-12);
        let next = meridian.at(xi + TAU);
        prop_assert!((next.height - at.height - meridian.pitch()).abs() < 1e-12);
    }

    /// Lengths in other units, moduli in others.
    #[test]
    fn units_do_not_matter(length in 1e-4..1e4_f64, modulus in 1e-3..1e12_f64) {
        let solve = |l: f64, e: f64| {
            let wall = Wall::new(e, 0.3, 0.1 * l).unwrap();
            let bellows = Bellows::new(Meridian::sine(10.0 * l, l, 3.0 * l).unwrap(), wall, 16).unwrap();
            bellows.solve(load(2e-4 * e, Axial::Dilatation(0.3 * l))).unwrap()
        };
        let (one, other) = (solve(1.0, 1.0), solve(length, modulus));
        let square = modulus * length * length;
        prop_assert!((other.force() / (one.force() * square) - 1.0).abs() < 1e-9);
        prop_assert!((other.stored_energy() / (one.stored_energy() * square * length) - 1.0).abs() < 1e-9);
        for (name, one, other) in stresses(length, modulus) {
            prop_assert!((other / one - 1.0).abs() < 1e-9, "{name}: {one} {other}");
        }
        prop_assert!((other.profile()[0].hoop_bending / (one.profile()[0].hoop_bending * modulus) - 1.0).abs() < 1e-9);
    }

    /// Any sound bellows has a positive spring rate and an area between those of root and crest, less what Poisson's ratio
    /// takes: hoop stresses of p R/t at most shorten the wall by nu p R/(E t), against which the ends pull. In low folds of a
    /// wide tube that is more than the areas differ.
    #[test]
    fn responses_are_positive(
        radius in 2.0..50.0_f64, a in 0.1..0.5_f64, straight in 0.0..1.0_f64,
        thickness in 0.01..0.08_f64, poisson in 0.0..0.5_f64,
    ) {
        let fold = Meridian::u_shaped(radius, a, straight).unwrap();
        let wall = Wall::new(1.0, poisson, thickness).unwrap();
        let response = Bellows::new(fold, wall, 16).unwrap().linear_response().unwrap();
        prop_assert!(response.spring_rate > 0.0);
        let area = |angle: f64| PI * fold.at(angle).radius.powi(2);
        let length = 2.0 * PI * a + 2.0 * straight;
        let pull = response.spring_rate * poisson * radius * length / thickness;
        prop_assert!(response.effective_area > area(PI) - pull, "{} {} {pull}", response.effective_area, area(PI));
        prop_assert!(response.effective_area < area(0.0));
    }
}

#[test]
fn bad_bellows_are_refused() {
    let field = |result: Result<Meridian, carom_special::RangeError>| result.unwrap_err().field;
    assert_eq!(field(Meridian::sine(10.0, 9.5, 3.0)), "amplitude");
    assert_eq!(field(Meridian::sine(10.0, -1.0, 3.0)), "amplitude");
    assert_eq!(field(Meridian::sine(10.0, 1.0, f64::NAN)), "pitch");
    assert_eq!(field(Meridian::u_shaped(1.0, 0.5, 1.0)), "height");
    assert_eq!(field(Meridian::u_shaped(10.0, 0.5, -1.0)), "straight");
    assert_eq!(field(Meridian::torus(1.0, 0.95)), "arc");
    assert_eq!(field(Meridian::folded(10.0, 0.5, 1.0, 3.1)), "turn");
    // Arcs that turn beyond the radial direction: long cones meet.
    assert!(Meridian::folded(10.0, 0.5, 0.3, 2.0).is_ok());
    let error = Meridian::folded(10.0, 0.5, 3.0, 2.0).unwrap_err();
    assert_eq!((error.field, error.value), ("straight", 3.0));
    assert!(error.allowed.contains("cut itself"));

    let meridian = Meridian::sine(10.0, 1.0, 3.0).unwrap();
    let bellows = |thickness: f64, n: usize| Bellows::new(meridian, wall(thickness), n);
    let field = |result: Result<Bellows, carom_special::RangeError>| result.unwrap_err().field;
    assert_eq!(field(bellows(0.1, 3)), "harmonics");
    assert_eq!(field(bellows(0.1, 257)), "harmonics");
    assert_eq!(field(bellows(3.0, 32)), "thickness");
    assert_eq!(field(bellows(1e-8, 32)), "thickness");
    // Thicker than the crest is round (0.228).
    assert_eq!(field(bellows(0.23, 32)), "thickness");
    // Folds that touch before any load.
    let narrow = Meridian::u_shaped(10.0, 0.5, 1.0).unwrap();
    assert!(Bellows::new(narrow, wall(0.4), 8).is_ok());
    let tight = Meridian::folded(10.0, 0.5, 1.35, 1.9).unwrap();
    assert!(tight.least_gap() < 0.1);
    assert_eq!(field(Bellows::new(tight, wall(0.1), 8)), "thickness");

    assert_eq!(BellowsLoad::new(f64::NAN, Axial::Force(0.0)).unwrap_err().field, "pressure");
    let endless = Axial::Dilatation(f64::INFINITY);
    assert_eq!(BellowsLoad::new(0.0, endless).unwrap_err().field, "dilatation");
    let bellows = corrugated(16);
    let rest = bellows.solve(load(0.0, Axial::Force(0.0))).unwrap();
    let refused = |start: &_, load, steps: usize, of: &Bellows| match of.follow(start, load, steps)
    {
        Err(BellowsError::Range(error)) => error.field,
        other => panic!("{other:?}"),
    };
    let small = load(0.0, Axial::Force(1e-4));
    assert_eq!(refused(&rest, small, 0, &bellows), "steps");
    assert_eq!(refused(&rest, load(1e-5, Axial::Force(1e-4)), 3, &bellows), "pressure");
    assert_eq!(refused(&rest, small, 3, &corrugated(20)), "harmonics of the start");
    assert_eq!(FRAC_PI_2, bellows.meridian().at(0.0).angle);
}

/// A load far beyond any state of equilibrium is an error with numbers, not a panic.
#[test]
fn loads_out_of_reach_are_named() {
    let bellows = corrugated(16);
    for axial in [Axial::Force(1e9), Axial::Dilatation(-1e3), Axial::Force(-1e3)] {
        match bellows.solve(load(0.0, axial)) {
            Ok(state) => {
                assert!(state.convergence().residual < 1e-6 * (1.0 + state.force().abs() * 100.0));
            }
            Err(BellowsError::NotConverged(failure)) => {
                assert!((0.0..1.0).contains(&failure.fraction));
            }
            Err(other) => panic!("{other}"),
        }
    }
    assert!(bellows.solve(load(0.0, Axial::Force(1e300))).is_err());
}
