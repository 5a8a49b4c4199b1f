//! R_x of dissimilar spheres by table and by rings, against finer rings and a grid.

use carom_drawn::{Congruential, Draw as _};
use carom_impact::restitution::{
    DissimilarGroups, DissimilarMethod, DissimilarTable, of_dissimilar, of_groups, of_spheres,
};
use carom_impact::{Body, Collision, Motion, RingImpact};
use carom_laws::friction::Friction;

fn groups([kappa, gamma, f, lambda, ratio]: [f64; 5]) -> DissimilarGroups {
    DissimilarGroups::new(kappa, gamma, Friction::new(f).unwrap(), lambda, ratio).unwrap()
}

/// kappa, gamma, f, lambda, and the tangential velocity after over f v_z: solid spheres, a grid of 64 cells in 256
/// steps, itself off by some .002. Drawn materials with |gamma| f from 0.2 to 1.1.
const STRONG: [[f64; 5]; 16] = [
    [1.11366, -0.24845, 1.1124, 0.9761, 0.1148],
    [1.27471, 0.18682, 1.7451, 0.5538, 0.0129],
    [1.06628, 0.31713, 0.8181, 1.4195, 0.0349],
    [1.01739, -0.24963, 1.6253, 0.8370, 0.2397],
    [1.06637, -0.34453, 0.6945, 2.5155, -0.7609],
    [1.02182, -0.46580, 0.7092, 0.4144, 0.1195],
    [1.07354, -0.38014, 1.4532, 0.2772, 0.0817],
    [1.03867, -0.39160, 2.8466, 1.7282, 0.2342],
    [1.19211, -0.22988, 1.6500, 2.5097, -0.9515],
    [1.07342, 0.33339, 1.2302, 4.7011, -1.5443],
    [1.11663, 0.31285, 2.7446, 0.6713, 0.1435],
    [1.15051, 0.31036, 1.1731, 3.2493, -1.3212],
    [1.07623, -0.24142, 1.7781, 3.7898, -1.4215],
    [1.05523, 0.41881, 0.9791, 0.5890, 0.1478],
    [1.21741, -0.18091, 2.3787, 1.5912, -0.2747],
    [1.12787, -0.12271, 1.7206, 2.2458, -0.7076],
];

#[test]
fn estimates_say_what_rings_leave_out_at_strong_friction() {
    for [kappa, gamma, f, lambda, after] in STRONG {
        let found = of_dissimilar(&groups([kappa, gamma, f, lambda, 3.5]), 1e-2).unwrap();
        let (off, estimate) = ((found.r_x + after / lambda).abs(), found.error_estimate);
        assert!(off <= estimate, "gamma {gamma}, f {f}, lambda {lambda}: {off} {estimate}");
    }
}

/// As [`STRONG`], |gamma| f below 0.1 and lambda above 0.2.
const WEAK: [[f64; 5]; 27] = [
    [1.06331, -0.40841, 0.12475, 0.3841, -0.0791],
    [1.05972, -0.25390, 0.07399, 0.6768, -0.1579],
    [1.03252, -0.46490, 0.10006, 0.2804, -0.0954],
    [1.24423, 0.22659, 0.15083, 4.9344, -1.6366],
    [1.29263, 0.07929, 0.11575, 2.5716, -1.2369],
    [1.05331, 0.29914, 0.06001, 0.4845, -0.1925],
    [1.25130, 0.17280, 0.03406, 0.5766, -0.3107],
    [1.13414, -0.05728, 0.15904, 0.2826, 0.0722],
    [1.08595, -0.39466, 0.19778, 0.3269, -0.0025],
    [1.08697, -0.33510, 0.09341, 0.7435, -0.2082],
    [1.22737, -0.06033, 0.29257, 2.2057, -0.8620],
    [1.11451, -0.25208, 0.14791, 0.2534, 0.0109],
    [1.35758, -0.09475, 0.23477, 1.0293, -0.2075],
    [1.02245, 0.46670, 0.14508, 0.2160, -0.0341],
    [1.15409, 0.21592, 0.44657, 0.9358, 0.0514],
    [1.03847, 0.36691, 0.17169, 1.5233, -0.2263],
    [1.05051, 0.40736, 0.03855, 3.2518, -1.2179],
    [1.26864, -0.22579, 0.07343, 0.8022, -0.3040],
    [1.09978, -0.05025, 0.52346, 3.0778, -1.2522],
    [1.02881, -0.44776, 0.14013, 0.5065, -0.0823],
    [1.10255, -0.33860, 0.09325, 0.6334, -0.1873],
    [1.08892, -0.31938, 0.06648, 3.3868, -1.5304],
    [1.10617, 0.23881, 0.04705, 2.5720, -1.2389],
    [1.28904, -0.13960, 0.22885, 0.8283, -0.0758],
    [1.11648, 0.36562, 0.16031, 1.1773, -0.2295],
    [1.11693, 0.09027, 0.06704, 0.2411, 0.0335],
    [1.12544, -0.19639, 0.07165, 0.5301, -0.0991],
];

/// Spread evenly by its logarithm.
fn spread(random: &mut Congruential, low: f64, high: f64) -> f64 {
    low * libm::exp(random.part() * libm::log(high / low))
}

/// An impact of two materials of Poisson's ratios from 0 to 1/2.
fn drawn(random: &mut Congruential) -> [f64; 5] {
    loop {
        let (one, two) = (0.5 * random.part(), 0.5 * random.part());
        let softer = spread(random, 0.05, 20.0);
        let sum = |of: fn(f64) -> f64| softer * of(one) + of(two);
        let gamma = 0.5 * (softer * (1.0 - 2.0 * one) - (1.0 - 2.0 * two)) / sum(|nu| 1.0 - nu);
        let nu = sum(|nu| nu) / (softer + 1.0);
        let kappa = (1.0 - 0.5 * nu) / (1.0 - nu);
        let (f, lambda) = (spread(random, 0.03, 0.9), spread(random, 0.05, 5.0));
        let ratio = 2.5 + 3.5 * random.part();
        if gamma.abs() > 0.05 * f {
            return [kappa, gamma, f, lambda, ratio];
        }
    }
}

#[test]
fn the_table_is_what_the_grid_finds() {
    let (mut sum, mut worst) = (0.0, 0.0_f64);
    for [kappa, gamma, f, lambda, after] in WEAK {
        let groups = groups([kappa, gamma, f, lambda, 3.5]);
        let off = (DissimilarTable::shared().stored(&groups).unwrap().r_x + after / lambda).abs();
        sum += off;
        worst = worst.max(off);
    }
    let mean = sum / WEAK.len() as f64;
    assert!(mean <= 2e-3 && worst <= 8e-3, "{mean} {worst}");
}

#[test]
fn without_coupling_the_answer_is_that_of_alike_bodies_bit_for_bit() {
    for lambda in [0.0, 0.5, 3.0, 20.0] {
        for f in [1e-3, 0.3, 7.0] {
            for kappa in [1.0, 1.7 / 1.4, 1.5] {
                let exact = of_spheres(kappa, lambda).unwrap();
                let groups = groups([kappa, 0.0, f, lambda, 3.5]);
                let found = DissimilarTable::shared().restitution(&groups).unwrap();
                assert_eq!((found.r_x, found.error_estimate), (exact, 0.0));
                assert_eq!(found.method, DissimilarMethod::Uncoupled);
                assert_eq!(of_dissimilar(&groups, 1e-2).unwrap(), found);
            }
        }
        let found = of_dissimilar(&groups([1.2, 0.0, 0.3, lambda, 3.0]), 1e-2).unwrap();
        assert_eq!(found.r_x, of_groups(3.0 / 1.2, lambda / 1.2).unwrap());
    }
}

#[test]
fn little_coupling_changes_little() {
    let mut random = Congruential(5);
    for _ in 0..300 {
        let (kappa, f) = (1.0 + 0.49 * random.part(), spread(&mut random, 0.01, 1.0));
        let (lambda, ratio) = (8.0 * random.part(), 1.0 + 5.0 * random.part());
        let found = DissimilarTable::shared().stored(&groups([kappa, 1e-6 * f, f, lambda, ratio]));
        let alike = of_groups(ratio / kappa, lambda / kappa).unwrap();
        // Entries have seven digits.
        let off = (found.unwrap().r_x - alike).abs();
        assert!(off < 3e-5, "{kappa} {f} {lambda} {ratio}: {off}");
    }
}

#[test]
fn the_sense_of_gamma_makes_no_difference_and_out_of_range_rings_answer() {
    let table = DissimilarTable::shared();
    let at = |gamma: f64, lambda: f64| groups([1.15, gamma, 0.1, lambda, 3.5]);
    assert_eq!(table.restitution(&at(0.2, 1.0)), table.restitution(&at(-0.2, 1.0)));
    assert_eq!(table.restitution(&at(0.2, 1.0)).unwrap().method, DissimilarMethod::Table);
    for outside in [
        at(0.2, 9.0),
        groups([0.9, 0.2, 0.1, 1.0, 3.5]),
        groups([1.1, 0.2, 0.01, 1.0, 3.5]),
        groups([1.1, 0.2, 1.1, 1.0, 3.5]),
        groups([1.1, 0.2, 0.1, 1.0, 6.5]),
    ] {
        assert_eq!(table.stored(&outside), None);
        let rings = of_dissimilar(&outside, 1e-2).unwrap();
        assert_eq!(rings.method, DissimilarMethod::Rings);
        assert_eq!(table.restitution(&outside).unwrap(), rings);
    }
}

/// Those of the table, of 100 impacts that it has, and of rings, of these and of those beside it.
#[test]
fn estimates_cover_the_finest_rings_in_95_of_100_drawn_impacts() {
    let mut random = Congruential(31);
    // Covered, and counted.
    let (mut by_table, mut by_rings) = ([0, 0], [0, 0]);
    let mut off_at_weak_coupling = Vec::new();
    while by_table[1] < 100 {
        let [kappa, gamma, f, lambda, ratio] = drawn(&mut random);
        // Every tenth touches without tangential velocity.
        let lambda = if by_table[1] % 10 == 0 { 0.0 } else { lambda };
        let groups = groups([kappa, gamma, f, lambda, ratio]);
        let finest = of_dissimilar(&groups, 1e-9).unwrap().r_x;
        let stored = DissimilarTable::shared().stored(&groups);
        if let Some(found) = stored.filter(|_| gamma.abs() * f <= 0.1 && lambda >= 0.2) {
            off_at_weak_coupling.push((found.r_x - finest).abs());
        }
        let rings = (&mut by_rings, Some(of_dissimilar(&groups, 1e-2).unwrap()));
        for ([covered, count], found) in [(&mut by_table, stored), rings] {
            let Some(found) = found else { continue };
            *covered += i32::from((found.r_x - finest).abs() <= found.error_estimate);
            *count += 1;
        }
    }
    assert!(
        by_table[0] >= 95 && 100 * by_rings[0] >= 95 * by_rings[1],
        "{by_table:?} {by_rings:?}"
    );
    let count = off_at_weak_coupling.len();
    let mean = off_at_weak_coupling.iter().sum::<f64>() / count as f64;
    let worst = off_at_weak_coupling.into_iter().fold(0.0, f64::max);
    assert!(count >= 30 && mean <= 2e-3 && worst <= 1e-2, "{count}: {mean} {worst}");
}

/// R_x of a ball of these materials against a plane, by [`RingImpact`], and the groups of that impact.
fn collided(random: &mut Congruential) -> (f64, DissimilarGroups) {
    use carom_halfspace::{Material, MaterialPair};
    let mut material =
        || Material::from_shear(spread(random, 1e9, 1e11), 0.5 * random.part()).unwrap();
    let (ball, plane) = (material(), material());
    let pair = MaterialPair::new(ball, plane).unwrap();
    let (f, lambda) = (spread(random, 0.05, 0.6), spread(random, 0.2, 7.5));
    let ball = Body::sphere(0.02, ball, 0.3).unwrap();
    let ball = ball.moving(Motion::new([1.5 * f * lambda, 0.0, -1.5], [0.0; 3]).unwrap());
    let friction = Friction::new(f).unwrap();
    let collision = Collision::new(ball, Body::plane(plane), friction).unwrap();
    let outcome = RingImpact::new(&collision).within(1e-3).unwrap().solve().unwrap();
    let groups = DissimilarGroups::of_spheres(pair.kappa(), pair.gamma(), friction, lambda);
    (outcome.rebound().unwrap().r_x.unwrap(), groups.unwrap())
}

#[test]
fn the_answer_is_that_of_collisions_of_balls() {
    let (mut random, mut by_table, mut sum) = (Congruential(77), 0, 0.0);
    for _ in 0..20 {
        let (rings, groups) = collided(&mut random);
        let found = DissimilarTable::shared().restitution(&groups).unwrap();
        by_table += i32::from(found.method == DissimilarMethod::Table);
        let off = (found.r_x - rings).abs();
        sum += off;
        assert!(off <= 1e-2, "{groups:?}: {off}");
    }
    assert!(by_table >= 15 && sum / 20.0 <= 2e-3, "{by_table} {}", sum / 20.0);
}

#[test]
fn limits_are_finite() {
    let table = DissimilarTable::shared();
    for f in [0.0, 1e-30, 1e-12, 1e-3, 1.0, 30.0] {
        for lambda in [0.0, 1e-9, 0.01, 1e6, 1e308, f64::INFINITY] {
            for [kappa, gamma] in [[1.0, 0.5], [1.0, -0.5], [1.5, 0.0], [1.499, 9e-4], [1.2, 1e-12]]
            {
                let groups = groups([kappa, gamma, f, lambda, 3.5]);
                let found = table.restitution(&groups).unwrap();
                assert!((-1.0..=1.0).contains(&found.r_x), "{f} {lambda} {gamma}: {found:?}");
                assert!((0.0..=2.0).contains(&found.error_estimate), "{f} {lambda}: {found:?}");
                if f == 0.0 || lambda.is_infinite() {
                    assert_eq!((found.r_x, found.method), (-1.0, DissimilarMethod::Frictionless));
                }
            }
        }
    }
}

#[test]
fn fast_impacts_slide_along_the_shift() {
    // R_x = -1 + 2 D_xx/(D_zz lambda).
    for lambda in [1e3, 1e5, 1e9] {
        let found = of_dissimilar(&groups([1.0, 0.5, 0.1, lambda, 3.5]), 1e-2).unwrap();
        let off = ((1.0 + found.r_x) * lambda - 7.0).abs();
        assert!(off < 5e-3 && found.error_estimate * lambda < 1e-2, "{lambda}: {off} {found:?}");
    }
}

#[test]
fn bodies_that_never_slip_are_the_limit_of_strong_friction() {
    let at = |friction| DissimilarGroups::of_spheres(1.1, 0.3, friction, 0.0).unwrap();
    let table = DissimilarTable::shared();
    let never = table.restitution(&at(Friction::INFINITE)).unwrap();
    let strong = table.restitution(&at(Friction::new(1e6).unwrap())).unwrap();
    assert_eq!(never.method, DissimilarMethod::Rings);
    assert!((never.r_x - strong.r_x).abs() < 1e-5, "{never:?} {strong:?}");
    // Coupling that vanishes.
    let little = DissimilarGroups::of_spheres(1.1, 1e-9, Friction::INFINITE, 0.0).unwrap();
    let alike = of_spheres(1.1, 0.0).unwrap();
    assert!((table.restitution(&little).unwrap().r_x - alike).abs() < 1e-6);
}

#[test]
fn what_no_materials_have_is_refused() {
    let friction = Friction::new(0.1).unwrap();
    let refused = |kappa, gamma, lambda, ratio, field: &str| {
        let error = DissimilarGroups::new(kappa, gamma, friction, lambda, ratio).unwrap_err();
        assert_eq!(error.field, field);
    };
    refused(1.6, 0.0, 1.0, 3.5, "kappa");
    refused(1.2, 0.4, 1.0, 3.5, "gamma");
    refused(1.2, f64::NAN, 1.0, 3.5, "gamma");
    refused(1.2, 0.1, -1.0, 3.5, "lambda");
    refused(1.2, 0.1, f64::NAN, 3.5, "lambda");
    refused(1.2, 0.1, 1.0, 0.0, "mobility_ratio");
    refused(1.2, 0.1, 1.0, 76.0, "mobility_ratio");
    refused(1.2, 0.1, 1.0, f64::NAN, "mobility_ratio");
    let error = DissimilarGroups::of_spheres(1.2, 0.1, Friction::INFINITE, 1.0).unwrap_err();
    assert_eq!(error.field, "lambda");
    assert!(error.to_string().contains("0 where friction is infinite"), "{error}");
}

/// Below lambda = 0.02 R_x is its limit for vanishing slips: its estimate has no step there.
#[test]
fn the_estimate_of_a_small_slip_goes_on_from_that_of_a_larger_one() {
    let estimate = |lambda: f64| {
        of_dissimilar(&groups([1.15, 0.2, 0.1, lambda, 3.5]), 1e-2).unwrap().error_estimate
    };
    let [below, above] = [0.0199, 0.0201].map(estimate);
    assert!((above / below - 1.0).abs() < 0.05, "{below} {above}");
}
