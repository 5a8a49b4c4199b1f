//! How much tangential tractions displace a surface along the normal.

use carom_halfspace::operator::SurfaceOperator;

/// The normal displacement beside a cell due to its tangential traction, over that due to its pressure: the
/// greater of those along x and along y. On square cells of a half-space it is close to gamma (15.1).
pub(super) fn coupling(operator: &dyn SurfaceOperator) -> f64 {
    let beside = |[columns, rows]: [i32; 2], axis: usize| {
        let normal = operator.coefficients(columns, rows).rows[2];
        if normal[2] == 0.0 { 0.0 } else { (normal[axis] / normal[2]).abs() }
    };
    beside([1, 0], 0).max(beside([0, 1], 1))
}
