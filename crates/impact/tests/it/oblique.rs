//! The exact oblique impact against independent reference values.

use carom_drawn::{Congruential, Draw as _};
use carom_impact::normal;
use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
use serde_json::Value;

use crate::data::{number, rows};

/// Phases of the table: events and remarks removed, names as carom's. A ring that closes where
/// the memory is all slip of the new sign leaves the whole contact sliding, which the table
/// calls slip up to its END.
fn table_regimes(row: &Value) -> Vec<String> {
    let mut names = Vec::new();
    for entry in row["regimes"].as_array().unwrap() {
        let name = entry.as_str().unwrap();
        if name.starts_with('E') || name.starts_with('(') {
            continue;
        }
        let name = match name {
            "adh" => "adhesion".to_owned(),
            _ => name.replace('1', ""),
        };
        if names.last() != Some(&name) {
            names.push(name);
        }
    }
    if row["regimes"].as_array().unwrap().last().unwrap() == "END+1" {
        names.pop();
        names.push("slide+".to_owned());
    }
    names
}

/// Own regimes; a last phase shorter than 1e-3 of the duration is dropped with its partner.
fn own_regimes(impact: &ObliqueImpact) -> (Vec<String>, bool) {
    let names = impact.regimes().map(|regime| regime.name().to_owned()).collect();
    let last = impact.phases().last().unwrap().start;
    (names, normal::DURATION - normal::time(last) < 1e-3 * normal::DURATION)
}

fn check_table(name: &str, tolerance: f64) {
    let mut worst: f64 = 0.0;
    for row in rows(name) {
        let (chi, psi) = (number(&row, "chi"), number(&row, "psi1"));
        let impact = ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap();
        let error = (impact.restitution() - number(&row, "Rx")).abs();
        worst = worst.max(error);
        // This row's own integration stops before separation (END at t = 2.94294 < T): its R_x is
        // off by 7.9e-10, more than its stated 5e-11; tightening ours changes it by 1e-13 only.
        let truncated = row["regimes"].as_array().unwrap().last().unwrap() == "END-1";
        let tolerance = if truncated { 1e-9 } else { tolerance };
        assert!(error < tolerance, "chi {chi} psi {psi}: error {error:e}");
        let (mut own, short) = own_regimes(&impact);
        let mut theirs = table_regimes(&row);
        if short && own.len() != theirs.len() {
            own.truncate(theirs.len());
            theirs.truncate(own.len());
        }
        if short && own != theirs {
            own.pop();
            theirs.pop();
        }
        assert_eq!(own, theirs, "chi {chi} psi {psi} {:?}", impact.phases());
    }
    println!("{name}: worst error {worst:e}");
}

#[test]
fn spheres_table() {
    check_table("Rx_table_spheres", 1e-10);
}

#[test]
fn generic_table() {
    check_table("Rx_table_generic", 6e-10);
}

#[test]
fn tiny_velocities_tend_to_the_adhesion_limit() {
    for row in &rows("Rx_adhesion_limit") {
        let chi = number(row, "chi");
        let impact = ObliqueImpact::new(Groups::new(chi, 1e-9).unwrap()).unwrap();
        let error = (impact.restitution() - number(row, "Rx")).abs();
        assert!(error < 1e-9, "chi {chi}: {error:e}");
        let impact = ObliqueImpact::new(Groups::new(chi, 1e-12).unwrap()).unwrap();
        let error = (impact.restitution() - number(row, "Rx")).abs();
        assert!(error < 1e-11, "chi {chi}: {error:e}");
    }
}

#[test]
fn histories() {
    for row in &rows("histories") {
        let groups = Groups::new(number(row, "chi"), number(row, "psi1")).unwrap();
        let points = row["points"].as_array().unwrap();
        let w: Vec<f64> = points.iter().map(|point| number(point, "w")).collect();
        let trace = ObliqueImpact::trace(groups, &w).unwrap();
        assert_eq!(trace.len(), w.len());
        for (own, point) in trace.iter().zip(points) {
            let check = |name: &str, own: f64, factor: f64| {
                let error = (own - factor * number(point, name)).abs();
                assert!(
                    error < 1e-9,
                    "{} w {} {name}: {error:e}",
                    row["label"],
                    number(point, "w")
                );
            };
            check("t", own.time, 1.0);
            check("zeta", own.compression, 1.0);
            check("e", groups.psi() * own.shift, 1.0);
            check("e_dot", groups.psi() * own.velocity, 1.0);
            check("Phi", groups.psi() * own.force, 1.5);
            check("Fx_over_fFz", own.friction_used, 1.0);
            check("s_stick", own.stick_depth, 1.0);
        }
    }
}

#[test]
fn the_last_instant_is_in_the_last_regime() {
    // Three instants only, as of the rubber ball that ends in sliding: the last but one is still
    // in partial slip.
    for i in 1..40 {
        for j in 1..40 {
            let (chi, psi) = (0.2 * f64::from(i), 0.15 * f64::from(j));
            let groups = Groups::new(chi, psi).unwrap();
            let last = ObliqueImpact::new(groups).unwrap().phases().last().unwrap().regime;
            let trace = ObliqueImpact::trace(groups, &[1.0, 0.0, -1.0]).unwrap();
            assert_eq!(trace[2].regime, last, "chi = {chi}, psi = {psi}");
        }
    }
}

#[test]
fn a_short_stop_of_the_slip_is_not_overlooked() {
    // The slip velocity dips below zero for a moment only: R_x from integrations with a
    // tolerance of 1e-14 and steps too short to miss it.
    for (chi, psi) in [(5.4, 1.94), (5.4, 1.95), (5.4, 1.97)] {
        let impact = ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap();
        let names: Vec<_> = impact.regimes().map(|regime| regime.name()).collect();
        assert_eq!(names, ["slide+", "adhesion", "slip-", "slip+", "slip-", "slide+"], "{psi}");
    }
}

#[test]
fn narrow_rings_near_the_neutral_impact() {
    // chi = 1 is reversible: 1 - R_x is of second order in chi - 1 there and psi has no say.
    for (chi, psi) in [(1.003071113, 0.3327691), (1.0182472949653802, 0.00450514232668449)] {
        let impact = ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap();
        let adhesion = carom_impact::closed_form::restitution_without_slip(chi);
        let loss = 1.0 - impact.restitution();
        assert!(loss > 0.0 && loss < 2.0 * (1.0 - adhesion), "{loss:e}");
    }
}

#[test]
fn edges_of_the_regimes_are_continuous() {
    let restitution = |chi: f64, psi: f64| {
        ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap().restitution()
    };
    for chi in [0.1, 0.5, 0.7, 0.99, 1.0, 1.01, 2.0, 5.05, 60.0] {
        let at = restitution(chi, 1.0);
        for k in 4..=16 {
            let gap = 10.0_f64.powi(-k);
            for psi in [1.0 - gap, 1.0 + gap] {
                let difference = (restitution(chi, psi) - at).abs();
                assert!(difference <= 30.0 * chi * gap + 3e-10, "{chi} {psi} {difference:e}");
            }
        }
    }
    assert_eq!(restitution(0.5, 1.0), 0.0);
    for chi in [1.0 + 1e-9, 1.0 - 1e-9, 1.0 + 1e-10, 1.0 + 1e-8, 1.0 - 3e-7] {
        for psi in [0.01, 0.5, 0.9] {
            assert!((restitution(chi, psi) - 1.0).abs() < 1e-11, "{chi} {psi}");
        }
    }
}

#[test]
fn sliding_that_just_stops_is_continuous() {
    // psi = chi: the sliding stops at maximal compression; below, a short adhesion follows.
    for chi in [1.2, 2.0786, 3.5, 6.4] {
        let restitution =
            |psi: f64| ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap().restitution();
        for gap in [1e-6, 1e-8, 1e-10] {
            let jump = (restitution(chi - gap) - restitution(chi + gap)).abs();
            assert!(jump < 3.0 * chi * gap + 1e-10, "{chi} {gap:e}: {jump:e}");
        }
    }
}

#[test]
fn sliding_that_stops_next_to_maximal_compression_goes_on_smoothly() {
    // psi = chi (1 - d) stops at w = d chi/(chi - 1): adhesion of no length there must not stall.
    for chi in [1.5, 2.064_786_061_935_79, 4.647_591_197_748_39, 5.852_583_762_063_53] {
        let at = |psi: f64| ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap();
        let exact = at(chi).restitution();
        for exponent in 4..16 {
            let below = at(chi * (1.0 - 10_f64.powi(-exponent)));
            let difference = (below.restitution() - exact).abs();
            assert!(difference < 10_f64.powi(-exponent) + 1e-10, "chi {chi}, 1e-{exponent}");
            assert!(below.phases().len() < 12);
        }
    }
}

#[test]
fn every_valid_pair_has_an_answer() {
    // A fixed sequence over chi in [0.01, 100] and psi in [1e-6, 1e3], both logarithmic.
    let mut draw = Congruential(3);
    for _ in 0..20_000 {
        let chi = 10_f64.powf(4.0 * draw.part() - 2.0);
        let psi = 10_f64.powf(9.0 * draw.part() - 6.0);
        let impact = ObliqueImpact::new(Groups::new(chi, psi).unwrap());
        let impact = impact.unwrap_or_else(|error| panic!("{chi} {psi}: {error}"));
        assert!((-1.0..=1.0).contains(&impact.restitution()) && impact.phases().len() < 60);
    }
}

#[test]
fn slip_that_stops_for_a_moment_goes_on() {
    // The slip velocity barely reaches zero, and the ring that opens the other way closes at once.
    for (chi, psi) in [
        (31.162_329_298_404_63, 0.644_889_234_030_151_4),
        (70.827_723_771_473_46, 2.262_252_058_250_899_4),
        (40.360_224_403_222_95, 0.921_922_141_875_331_4),
        (21.640_426_597_998_314, 1.117_049_003_165_314_2),
        (70.631_918_010_375_57, 1.255_246_957_197_960_3),
    ] {
        let at = |psi: f64| ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap();
        let difference = (at(psi).restitution() - at(psi * (1.0 + 1e-9)).restitution()).abs();
        assert!(difference < 1e-7, "{chi} {psi}: {difference:e}");
    }
}

/// Slip velocities that graze zero: the impact ends and R_x is the same on both sides.
#[test]
fn slip_may_graze_a_stop() {
    let grazing = [
        (5.492287375475746, 1.7421308915311837),
        (6.074931965601561, 1.1099899626562617),
        (6.735197503039612, 0.7984916638568047),
        (16.08307237146168, 0.7566196459125016),
        (20.357010623535025, 4.852766782611508),
        // Adhesion that reaches the limit for a moment.
        (9.283219576041436, 0.5894371222376293),
        (21.670624888163065, 0.25810875844536196),
        (24.005786025735397, 0.4063453035286852),
    ];
    for (chi, psi) in grazing {
        let ratio = |psi| ObliqueImpact::new(Groups::new(chi, psi).unwrap()).unwrap().restitution();
        let middle = ratio(psi);
        for share in [1e-13, 1e-11, 1e-9] {
            for side in [-share, share] {
                let change = ratio(psi * (1.0 + side)) - middle;
                assert!(change.abs() < 1e-10 + 10.0 * share, "{chi} {psi}: {side:e} {change:e}");
            }
        }
    }
}

/// Ever less slip has a limit, in which all of the contact sticks.
#[test]
fn an_impact_without_slip_is_the_limit_of_little_slip() {
    let w: Vec<f64> = (0..40).map(|i| 1.0 - f64::from(i) / 20.0).collect();
    for chi in [1.5, 3.0, 4.2] {
        let trace = |psi| ObliqueImpact::trace(Groups::new(chi, psi).unwrap(), &w).unwrap();
        for (none, little) in trace(0.0).iter().zip(trace(1e-9)) {
            assert!((none.shift - little.shift).abs() < 1e-7, "{chi}: {none:?} {little:?}");
            assert!((none.force - little.force).abs() < 1e-7, "{chi}: {none:?} {little:?}");
            assert_eq!((none.regime, none.friction_used), (Regime::Adhesion, 0.0));
        }
    }
}

/// A neutral impact that sticks releases as it loaded.
#[test]
fn a_neutral_impact_runs_backwards() {
    let w: Vec<f64> = (1..40).map(|i| 1.0 - f64::from(i) / 20.0).collect();
    for (chi, psi) in [(1.0, 0.5), (1.0, 0.0), (8.0, 0.1)] {
        let points = ObliqueImpact::trace(Groups::new(chi, psi).unwrap(), &w).unwrap();
        for (one, other) in points.iter().zip(points.iter().rev()) {
            let off =
                [one.shift - other.shift, one.force - other.force, one.velocity + other.velocity];
            assert!(off.iter().all(|off| off.abs() < 1e-12), "{chi} {psi}: {one:?} {other:?}");
        }
    }
}
