//! Rigid shifts and twist of which the load is given.

use nalgebra::{Matrix3, Vector3};

use super::active_set::Plane;

/// Shift along x, shift along y, twist: which of them have a given load, and how far they go.
///
/// Their displacements are (1, 0), (0, 1) and (y, -x) (12.2), their loads the sums of the tractions
/// times these.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Rigid {
    /// Loads over the area of a cell; none where the shift is given.
    pub(crate) loads: [Option<f64>; 3],
    /// How far what has a given load goes in this step; zero for the others.
    pub(crate) moved: [f64; 3],
}

impl Rigid {
    /// Whether any load is given.
    pub(super) fn is_loaded(&self) -> bool {
        self.loads.iter().any(Option::is_some)
    }

    /// The same loads on cells of another area.
    pub(super) fn on_cells(&self, times_larger: f64) -> Self {
        Self { loads: self.loads.map(|load| load.map(|load| load / times_larger)), ..*self }
    }

    /// How far tractions are from the given loads; zero where there is none.
    pub(super) fn excess(&self, centres: &Plane, traction: [&[f64]; 2]) -> Vector3<f64> {
        if !self.is_loaded() {
            return Vector3::zeros();
        }
        let sums = sums(centres, traction);
        Vector3::from_fn(|k, _| self.loads[k].map_or(0.0, |load| sums[k] - load))
    }
}

/// Displacement of a rigid motion.
pub(super) fn displacement(motion: &Vector3<f64>, x: f64, y: f64) -> [f64; 2] {
    [motion[0] + y * motion[2], motion[1] - x * motion[2]]
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

/// Corrections, one for each given load, that a preconditioner makes of the rigid displacements: to
/// stay orthogonal to their residuals is to have no load.
#[derive(Clone, Default)]
pub(super) struct Deflation {
    pub(super) corrections: [Plane; 3],
    /// From loads to parts of the corrections.
    inverse: Matrix3<f64>,
}

impl Deflation {
    /// `corrections` holds those of the given loads; `admitted` the displacements themselves as far
    /// as the cells admit them.
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
        // Where nothing can move there is nothing to correct.
        self.inverse = (0.5 * (gram + gram.transpose())).try_inverse().unwrap_or_default();
    }

    /// The parts of the corrections that have these loads.
    pub(super) fn parts(&self, loads: &Vector3<f64>) -> Vector3<f64> {
        self.inverse * loads
    }
}
