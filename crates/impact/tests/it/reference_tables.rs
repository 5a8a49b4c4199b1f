//! The tables in `reference/`: drawn rows computed anew, and limits by closed forms.

use carom_drawn::{Congruential, Draw as _};
use carom_impact::closed_form::{AdhesiveCompression, restitution_without_slip};
use carom_impact::normal;
use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
use carom_impact::restitution::{DissimilarGroups, DissimilarTable, of_dissimilar};
use carom_laws::friction::Friction;
use carom_special::hypergeometric::UnitArgument;
use carom_special::roots::bisect;

/// The inertia of a sphere over m R^2, and its table.
const TABLES: [(f64, &str); 2] = [
    (0.4, include_str!("../../../../reference/oblique_impact_solid.csv")),
    (2.0 / 3.0, include_str!("../../../../reference/oblique_impact_hollow.csv")),
];
const DISSIMILAR: &str = include_str!("../../../../reference/oblique_impact_dissimilar.csv");

/// The numbers of a table, whose columns must be these.
fn rows<const N: usize>(text: &str, columns: [&str; N]) -> Vec<[f64; N]> {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    assert_eq!(lines.next(), Some(columns.join(",").as_str()));
    let row = |line: &str| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        cells.try_into().unwrap()
    };
    lines.map(row).collect()
}

fn alike(text: &str) -> Vec<[f64; 8]> {
    let columns =
        ["kappa", "lambda", "R_x", "spin", "force_max", "time_max", "force_min", "time_min"];
    rows(text, columns)
}

/// Numbers below `count`, drawn.
fn drawn(count: usize, seed: u64) -> impl Iterator<Item = usize> {
    let mut draw = Congruential(seed);
    std::iter::repeat_with(move || (draw.bits() >> 33) as usize % count)
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64, row: &[f64]) {
    assert!((found - expected).abs() <= tolerance, "{found} for {expected} in {row:?}");
}

#[test]
fn drawn_rows_are_what_the_library_computes() {
    for (inertia, text) in TABLES {
        let rows = alike(text);
        assert!(rows.len() > 2000);
        for index in drawn(rows.len(), 5).take(25) {
            let row = rows[index];
            let [kappa, lambda, r_x, _, force_max, time_max, force_min, time_min] = row;
            let groups = Groups::new((1.0 + 1.0 / inertia) / kappa, lambda / kappa).unwrap();
            close(ObliqueImpact::new(groups).unwrap().restitution(), r_x, 1e-9, &row);
            let [most, least] = ObliqueImpact::force_extremes(groups).unwrap();
            close(most.force / kappa, force_max, 1e-9, &row);
            close(least.force / kappa, force_min, 1e-9, &row);
            close(most.time / normal::DURATION, time_max, 1e-9, &row);
            close(least.time / normal::DURATION, time_min, 1e-9, &row);
        }
    }
}

/// The tangential momentum that the contact point loses is that which the sphere gains in spin.
#[test]
fn spin_is_that_of_the_impulse() {
    for (inertia, text) in TABLES {
        for row in alike(text) {
            let [_, _, r_x, spin, ..] = row;
            // m (v_t - v') = m R omega times inertia, and v' - R omega = -R_x v_t.
            let centre = 1.0 - inertia * spin;
            close(centre - spin, -r_x, 4e-10, &row);
            // Kinetic energy does not grow.
            assert!(centre * centre + inertia * spin * spin <= 1.0 + 1e-9, "{row:?}");
        }
    }
}

/// Coulomb's law alone: the impulse is 2 f m v_n, the force f F_n.
#[test]
fn rows_that_slide_throughout_follow_coulomb() {
    for (inertia, text) in TABLES {
        let mut count = 0;
        for row in alike(text) {
            let [kappa, lambda, r_x, spin, force_max, time_max, force_min, time_min] = row;
            let ratio = 1.0 + 1.0 / inertia;
            if lambda < 2.0 * ratio - kappa - 1e-9 {
                assert!(force_min < 0.0 && time_min < 1.0, "{row:?}");
                continue;
            }
            count += 1;
            close(spin, 2.0 / (inertia * lambda), 1e-10, &row);
            close(r_x, 2.0 * ratio / lambda - 1.0, 1e-10, &row);
            close(force_max, 1.0 / lambda, 1e-10, &row);
            assert_eq!([time_max, force_min, time_min], [0.5, 0.0, 1.0], "{row:?}");
        }
        assert!(count > 300, "{count}");
    }
}

/// Without slip: R_x by (9.46), the largest force where the velocity by (9.16) is zero.
#[test]
fn rows_without_slip_follow_the_closed_forms() {
    for (inertia, text) in TABLES {
        for row in alike(text).into_iter().filter(|row| row[1] == 0.0) {
            let [kappa, _, r_x, _, force_max, time_max, ..] = row;
            let chi = (1.0 + 1.0 / inertia) / kappa;
            close(restitution_without_slip(chi), r_x, 1e-10, &row);
            let motion = AdhesiveCompression::new(chi).unwrap();
            let velocity = |s: f64| motion.velocity(UnitArgument::new(s).unwrap()).unwrap();
            let [s, _] = bisect([0.0, 1.0], 60, |s| velocity(s) > 0.0);
            close(normal::time((1.0 - s).sqrt()) / normal::DURATION, time_max, 1e-9, &row);
            // The impulse up to there, by Newton's law: F_x/F_z times v_n/v_t = -du/dw of the unit
            // impulse, 1/(chi kappa), with w = sqrt(1 - S).
            let step = 1e-4;
            let slope = (velocity(s - 2.0 * step) - 8.0 * velocity(s - step)
                + 8.0 * velocity(s + step)
                - velocity(s + 2.0 * step))
                / (12.0 * step);
            let by_normal = -2.0 * (1.0 - s).sqrt() * slope / (chi * kappa);
            close(by_normal * libm::pow(s, 0.6), force_max, 1e-8, &row);
        }
    }
}

/// Up to lambda = kappa the contact sticks until after the largest force: it is that without slip.
#[test]
fn slip_that_comes_late_leaves_the_largest_force() {
    for (_, text) in TABLES {
        let rows = alike(text);
        for row in &rows {
            let [kappa, lambda, .., force_max, _, _, _] = *row;
            if lambda > 0.0 && lambda < 0.9 * kappa {
                let limit = rows.iter().find(|row| row[0] == kappa && row[1] == 0.0).unwrap();
                assert_eq!(force_max, limit[4], "{row:?}");
            }
        }
    }
}

#[test]
fn unlike_materials_are_within_their_error_of_finer_rings() {
    let rows = rows(DISSIMILAR, ["kappa", "gamma", "f", "lambda", "R_x", "error_estimate"]);
    assert!(rows.len() > 2000);
    for (i, index) in drawn(rows.len(), 3).take(40).enumerate() {
        let row = rows[index];
        let [kappa, gamma, f, lambda, r_x, error] = row;
        let friction = Friction::new(f).unwrap();
        let groups = DissimilarGroups::of_spheres(kappa, gamma, friction, lambda).unwrap();
        let found = DissimilarTable::shared().stored(&groups).unwrap();
        close(found.r_x, r_x, 6e-6, &row);
        close(found.error_estimate, error, 6e-5, &row);
        if i < 3 {
            close(of_dissimilar(&groups, 1e-3).unwrap().r_x, r_x, error + 1e-3, &row);
        }
        // Sliding throughout, coupling has no say.
        if lambda >= 7.5 {
            close(r_x, 7.0 / lambda - 1.0, error, &row);
        }
    }
}

/// The extremes are found as zeros of a rate; the force itself is nowhere beyond them.
#[test]
fn no_instant_has_a_larger_force() {
    let w: Vec<f64> = (0..=3000).map(|i| libm::cos(1e-3 * f64::from(i) * 1.047)).collect();
    for (inertia, text) in TABLES {
        let rows = alike(text);
        let without_slip = (0..rows.len()).filter(|&index| rows[index][1] == 0.0);
        for index in drawn(rows.len(), 9).take(40).chain(without_slip) {
            let row = rows[index];
            let [kappa, lambda, _, _, force_max, time_max, force_min, time_min] = row;
            let groups = Groups::new((1.0 + 1.0 / inertia) / kappa, lambda / kappa).unwrap();
            let trace = ObliqueImpact::trace(groups, &w).unwrap();
            for (extreme, time, sign) in [(force_max, time_max, 1.0), (force_min, time_min, -1.0)] {
                let size = |i: usize| sign * trace[i].force / kappa;
                let best = (0..w.len()).max_by(|&i, &j| size(i).total_cmp(&size(j))).unwrap();
                let excess = size(best) - sign * extreme;
                assert!(excess < 1e-9 && excess > -2e-6, "{excess:e} in {row:?}");
                let near = trace[best].time / normal::DURATION;
                assert!(extreme == 0.0 || (near - time).abs() < 1e-3, "{near} in {row:?}");
            }
        }
    }
}

/// The test cases for LAMMPS, by name.
const CASES: [(&str, &str); 4] = [
    ("sticking", include_str!("../../../../reference/lammps/dem04-exact-sticking-3d-si.yaml")),
    ("microslip", include_str!("../../../../reference/lammps/dem04-exact-microslip-3d-si.yaml")),
    ("returning", include_str!("../../../../reference/lammps/dem04-exact-returning-3d-si.yaml")),
    ("sliding", include_str!("../../../../reference/lammps/dem04-exact-sliding-3d-si.yaml")),
];

/// The number after a word at the beginning of a line.
fn variable(case: &str, name: &str) -> f64 {
    let lines = case.lines().map(str::trim_start);
    let mut values = lines.filter_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
    values.next().unwrap().trim().parse().unwrap()
}

/// The three numbers of the last line of a block, after segment and atom.
fn block(case: &str, name: &str) -> [f64; 3] {
    let (_, rest) = case.split_once(&format!("{name}: |2\n")).unwrap();
    let cells = rest.lines().next().unwrap().split_whitespace().skip(2);
    let cells: Vec<f64> = cells.map(|cell| cell.parse().unwrap()).collect();
    cells.try_into().unwrap()
}

#[test]
fn cases_for_lammps_expect_the_exact_rebound() {
    for (name, case) in CASES {
        let of = |variable_name: &str| variable(case, variable_name);
        let (radius, tangential, normal) = (of("radius"), of("vx_in"), of("vz_in"));
        assert_eq!([of("diam"), of("en")], [2.0 * radius, 1.0]);
        let kappa = (2.0 - of("poisson")) / (2.0 * (1.0 - of("poisson")));
        let lambda = tangential / (of("xmu") * normal);
        let impact = ObliqueImpact::new(Groups::of_spheres(kappa, lambda).unwrap()).unwrap();
        let change = (1.0 + impact.restitution()) * tangential / 3.5;
        let ([v_x, v_y, v_z], [w_x, w_y, w_z]) = (block(case, "run_vel"), block(case, "run_omega"));
        println!(
            "{name}: v_x {:.16e}, omega_y {:.16e}",
            tangential - change,
            2.5 * change / radius
        );
        close(v_x, tangential - change, 1e-10, &[lambda]);
        close(w_y * radius, 2.5 * change, 1e-10, &[lambda]);
        assert_eq!([v_y, v_z, w_x, w_z], [0.0, normal, 0.0, 0.0], "{name}");
        // What the names say.
        let regimes: Vec<_> = impact.regimes().collect();
        match name {
            "sticking" => assert_eq!(regimes[0], Regime::Adhesion),
            "microslip" => {
                assert!(regimes[0] == Regime::SlideForward && regimes.len() > 2, "{regimes:?}")
            }
            _ => assert_eq!(regimes, [Regime::SlideForward]),
        }
        assert_eq!(impact.restitution() > 0.0, ["microslip", "returning"].contains(&name));
    }
}
