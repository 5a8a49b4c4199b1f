//! The stored table of creep forces is what the solver gives.

use carom_drawn::{Draw as _, Xorshift};
use carom_laws::creep::force::{CreepContact, nodes};
use carom_rolling::ContinuumForces;

/// By the table at scaled creepages: forces over f F_z, M_z over f F_z sqrt(ab), and the bound.
fn by_table(ratio: f64, poisson: f64, scaled: [f64; 3]) -> ([f64; 3], f64) {
    let contact = CreepContact::new([ratio.sqrt(), 1.0 / ratio.sqrt()], 1.0, poisson).unwrap();
    let scales = nodes::scales(&contact.coefficients(), ratio);
    let creepage = [0, 1, 2].map(|part| scaled[part] / scales[part]);
    let found = contact.force(1.0, 1.0, creepage).unwrap();
    ([found.f_x, found.f_y, found.m_z], found.error)
}

fn off(one: [f64; 3], other: [f64; 3]) -> f64 {
    (0..3).map(|part| (one[part] - other[part]).abs()).fold(0.0, f64::max)
}

/// The grids and the order of the solves are those of the table; it keeps seven digits.
#[test]
fn nodes_are_those_that_the_solver_gives() {
    for [ratio, poisson, theta, psi, size] in
        [[0, 3, 3, 8, 9], [5, 1, 6, 2, 12], [6, 0, 0, 0, 5], [9, 2, 10, 14, 16], [12, 1, 4, 7, 20]]
    {
        let (ratio, poisson) = (nodes::ratio(ratio), nodes::poisson(poisson));
        let r = nodes::size(size);
        let scaled = nodes::direction(ratio, [theta, psi]).map(|part| r * part);
        let mut contact = ContinuumForces::new(ratio, poisson, [24, 27, 48]).unwrap();
        let solved = contact.forces(scaled).unwrap();
        let (stored, _) = by_table(ratio, poisson, scaled);
        assert!(off(solved, stored) < 1e-4, "{ratio} {poisson} {scaled:?}: {stored:?} {solved:?}");
    }
}

/// Drawn anywhere: other axis ratios, Poisson's ratios, directions and sizes, on finer grids.
#[test]
fn between_nodes_the_table_is_within_its_bound() {
    let mut draw = Xorshift(20_261_201);
    let mut outside = Vec::new();
    let mut sum = 0.0;
    for _ in 0..DRAWN {
        let (ratio, poisson) = (10_f64.powf(draw.signed()), 0.5 * draw.part());
        let (s, z, turn) = (0.98 * draw.part(), draw.signed(), std::f64::consts::TAU * draw.part());
        let (r, flat) = (3.0 * s / (1.0 - s), (1.0 - z * z).sqrt());
        let scaled = [r * flat * turn.cos(), r * flat * turn.sin(), r * z];
        let mut contact = ContinuumForces::new(ratio, poisson, [32, 36, 64]).unwrap();
        let solved = contact.forces(scaled).unwrap();
        let (stored, bound) = by_table(ratio, poisson, scaled);
        let off = off(solved, stored);
        assert!(off < 0.01, "{ratio} {poisson} {scaled:?}: {stored:?} {solved:?}");
        sum += off;
        if off > bound {
            outside.push((ratio, poisson, scaled, off, bound));
        }
    }
    assert!(sum / f64::from(DRAWN) < 1e-3, "{}", sum / f64::from(DRAWN));
    assert!(outside.len() <= 1, "{outside:?}");
}

const DRAWN: i32 = 40;
