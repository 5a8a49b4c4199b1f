//! Rigid shifts and twist whose loads are prescribed.

use carom_halfspace::Grid;
use carom_halfspace::operator::Threads;
use nalgebra::{Matrix3, Vector3};

use super::plane::{Plane, slices};
use crate::lanes::LANES;
use crate::parts;

/// Shift along x, shift along y, twist: which of them have a prescribed load, and their values.
///
/// Their displacements are (1, 0), (0, 1) and (y, -x) (12.2). Their loads are the sums of the
/// tractions times these displacements.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Rigid {
    /// Loads divided by the area of a cell; `None` where the shift is prescribed.
    pub(crate) loads: [Option<f64>; 3],
    /// Shift in this step where the load is prescribed; zero otherwise.
    pub(crate) moved: [f64; 3],
}

impl Rigid {
    /// Whether any load is prescribed.
    pub(super) fn is_loaded(&self) -> bool {
        self.loads.iter().any(Option::is_some)
    }

    /// The same loads on cells of another area.
    pub(super) fn on_cells(&self, times_larger: f64) -> Self {
        Self { loads: self.loads.map(|load| load.map(|load| load / times_larger)), ..*self }
    }

    /// Loads of tractions minus the prescribed ones; zero where no load is prescribed.
    pub(super) fn excess(
        &self,
        threads: Threads,
        centres: &Plane,
        traction: [&[f64]; 2],
    ) -> Vector3<f64> {
        if !self.is_loaded() {
            return Vector3::zeros();
        }
        let sums = sums(threads, centres, traction);
        Vector3::from_fn(|k, _| self.loads[k].map_or(0.0, |load| sums[k] - load))
    }
}

/// Displacement of a rigid motion (12.2).
pub(crate) fn displacement(motion: &Vector3<f64>, x: f64, y: f64) -> [f64; 2] {
    [motion[0] + y * motion[2], motion[1] - x * motion[2]]
}

/// Half the diagonal of a grid, the arm that turns torques into forces.
pub(crate) fn half_diagonal(grid: Grid) -> f64 {
    0.5 * (grid.nx() as f64 * grid.dx()).hypot(grid.ny() as f64 * grid.dy())
}

/// Sums of a field times the displacements of the three motions.
pub(super) fn sums(threads: Threads, centres: &Plane, field: [&[f64]; 2]) -> Vector3<f64> {
    let add = |one: Vector3<f64>, other: Vector3<f64>| one + other;
    parts::fold(threads, (slices(centres), field), &sums_of_part, &add)
}

fn sums_of_part((centres, field): ([&[f64]; 2], [&[f64]; 2])) -> Vector3<f64> {
    let [(x, x_rest), (y, y_rest)] = centres.map(<[f64]>::as_chunks::<LANES>);
    let [(along, along_rest), (across, across_rest)] = field.map(<[f64]>::as_chunks::<LANES>);
    let mut lanes = [[0.0; LANES]; 3];
    for ((x, y), (along, across)) in x.iter().zip(y).zip(along.iter().zip(across)) {
        for lane in 0..LANES {
            lanes[0][lane] += along[lane];
            lanes[1][lane] += across[lane];
            lanes[2][lane] += y[lane] * along[lane] - x[lane] * across[lane];
        }
    }
    let mut sums = Vector3::from(lanes.map(|lane| lane.into_iter().sum()));
    let rest = x_rest.iter().zip(y_rest).zip(along_rest.iter().zip(across_rest));
    for ((x, y), (along, across)) in rest {
        sums += Vector3::new(*along, *across, y * along - x * across);
    }
    sums
}

/// Corrections, one for each prescribed load: the preconditioner applied to the rigid
/// displacements. A correction orthogonal to their residuals does not change the loads.
#[derive(Clone, Default)]
pub(super) struct Deflation {
    pub(super) corrections: [Plane; 3],
    /// Maps loads to coefficients of the corrections.
    inverse: Matrix3<f64>,
}

impl Deflation {
    /// Sets up the deflation. `corrections` holds those of the prescribed loads; `admitted` gives
    /// the components of the displacements that the cells admit.
    pub(super) fn prepare(&mut self, rigid: &Rigid, admitted: impl Fn(usize) -> [Vector3<f64>; 2]) {
        let mut gram = Matrix3::identity();
        for k in (0..3).filter(|&k| rigid.loads[k].is_some()) {
            let [along, across] = &self.corrections[k];
            let mut column = Vector3::zeros();
            for (i, (x, y)) in along.iter().zip(across).enumerate() {
                if *x != 0.0 || *y != 0.0 {
                    let [u, v] = admitted(i);
                    column += u * *x + v * *y;
                }
            }
            for l in (0..3).filter(|&l| rigid.loads[l].is_some()) {
                gram[(l, k)] = column[l];
            }
        }
        // If no cell can move, there is nothing to correct.
        self.inverse = (0.5 * (gram + gram.transpose())).try_inverse().unwrap_or_default();
    }

    /// The coefficients of the corrections that have these loads.
    pub(super) fn parts(&self, loads: &Vector3<f64>) -> Vector3<f64> {
        self.inverse * loads
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tangential::plane::dot;

    /// Fewer cells than lanes, numbers that are no multiple of them, and more than one part.
    const COUNTS: [usize; 6] = [0, 1, 3, 6, 9, 20_003];

    fn field(count: usize, rate: f64) -> Plane {
        [1.0, -0.7]
            .map(|rate_2| (0..count).map(|i| 1.1 + (rate * rate_2 * i as f64).sin()).collect())
    }

    #[test]
    fn loads_are_the_sums_over_all_cells() {
        for count in COUNTS {
            let (centres, field) = (field(count, 0.37), field(count, 1.9));
            let [mut x, mut y, mut torque] = [0.0; 3];
            for i in 0..count {
                x += field[0][i];
                y += field[1][i];
                torque += centres[1][i] * field[0][i] - centres[0][i] * field[1][i];
            }
            let got = sums(Threads::One, &centres, slices(&field));
            let wrong = (got - Vector3::new(x, y, torque)).amax();
            assert!(wrong <= 1e-13 * count as f64, "{count}: {got}");
            let work: f64 = (0..2)
                .flat_map(|axis| centres[axis].iter().zip(&field[axis]))
                .map(|(a, b)| a * b)
                .sum();
            assert!((dot(Threads::One, &centres, &field) - work).abs() <= 1e-13 * count as f64);
        }
    }

    #[test]
    fn loads_have_the_same_bits_on_several_threads() {
        let (centres, field) = (field(20_003, 0.37), field(20_003, 1.9));
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        let on = |threads| {
            pool.install(|| {
                (sums(threads, &centres, slices(&field)), dot(threads, &centres, &field))
            })
        };
        assert_eq!(on(Threads::One), on(Threads::Pool));
    }

    #[test]
    fn forces_and_a_torque_do_the_work_of_their_motion() {
        let (centres, field) = (field(9, 0.37), field(9, 1.9));
        let motion = Vector3::new(0.3, -0.2, 0.7);
        let moved = |axis: usize| {
            let all = centres[0].iter().zip(&centres[1]);
            all.map(|(x, y)| displacement(&motion, *x, *y)[axis]).collect::<Vec<_>>()
        };
        let work = dot(Threads::One, &[moved(0), moved(1)], &field);
        let by_loads = motion.dot(&sums(Threads::One, &centres, slices(&field)));
        assert!((work - by_loads).abs() < 1e-13, "{work} {by_loads}");
    }
}
