//! Rigid shifts and twist whose loads are prescribed.

use carom_halfspace::Grid;
use nalgebra::{Matrix3, Vector3};

use super::plane::Plane;

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
    pub(super) fn excess(&self, centres: &Plane, traction: [&[f64]; 2]) -> Vector3<f64> {
        if !self.is_loaded() {
            return Vector3::zeros();
        }
        let sums = sums(centres, traction);
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
pub(super) fn sums(centres: &Plane, field: [&[f64]; 2]) -> Vector3<f64> {
    let mut sums = Vector3::zeros();
    let cells = centres[0].iter().zip(&centres[1]).zip(field[0].iter().zip(field[1]));
    for ((x, y), (along, across)) in cells {
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
