//! Entries of the stored table of creep coefficients: finer meshes than those of
//! [`creep_coefficients`](super::creep_coefficients), and what their errors look like.

use nalgebra::{DMatrix, DVector};

use super::{RollingError, creep_coefficients_on};

/// Approximate number of elements of the finest mesh of a contact that is not long.
const ELEMENTS: f64 = 2500.0;
/// Least number of strips of the finest mesh, and of a mesh with more than so many elements per
/// strip and strip.
const STRIPS: [f64; 2] = [14.0, 12.0];
const LONG: f64 = 25.0;
/// Most elements per strip and strip.
const LONGEST: f64 = 33.0;
/// Approximate numbers of strips of the meshes relative to the finest.
const PARTS: [f64; 6] = [0.45, 0.55, 0.65, 0.78, 0.88, 1.0];

/// An entry of the table from which `CreepCoefficients::by_table` interpolates: C11, C22, the mean
/// of C23 and C32, and C33.
///
/// From four to six meshes of one shape it fits c + c1 h + c2 h^2 + c3 h^2 log h, with the width h
/// of their strips: the logarithm describes what meshes leave, better than a third power.
///
/// # Errors
/// As [`creep_coefficients`](super::creep_coefficients).
pub fn creep_table_entry(ratio: f64, poisson: f64) -> Result<[f64; 4], RollingError> {
    super::check_ratio(ratio)?;
    let meshes = meshes(ratio);
    let mut rows = Vec::with_capacity(meshes.len());
    for mesh in &meshes {
        let c = creep_coefficients_on(*mesh, ratio, poisson)?;
        rows.push([c.c11, c.c22, 0.5 * (c.c23 + c.c32), c.c33]);
    }
    let errors = |row: usize, term: usize| {
        let h = 1.0 / meshes[row][0] as f64;
        [1.0, h, h * h, h * h * libm::log(h)][term]
    };
    let fit = DMatrix::from_fn(meshes.len(), 4, errors).svd(true, true);
    let limit = |which: usize| -> Result<f64, RollingError> {
        let values = DVector::from_iterator(rows.len(), rows.iter().map(|row| row[which]));
        let singular = RollingError::Singular { unknowns: 4 };
        Ok(fit.solve(&values, 0.0).map_err(|_| singular)?[0])
    };
    Ok([limit(0)?, limit(1)?, limit(2)?, limit(3)?])
}

/// Meshes with elements of one shape, without repetitions. In a long contact elements are half as
/// long as wide, or the torque due to spin, a small difference there, would jump from mesh to mesh.
fn meshes(ratio: f64) -> Vec<[usize; 2]> {
    let per_strip = if ratio > 1.0 { (2.0 * ratio).ceil().min(LONGEST) } else { 1.0 };
    let least = STRIPS[usize::from(per_strip > LONG)];
    let finest = (ELEMENTS / per_strip).sqrt().max(least);
    let even = |strips: f64| 2.0 * (0.5 * strips).round();
    let strips = PARTS.map(|part| even(part * even(finest)));
    let mut meshes: Vec<[usize; 2]> =
        strips.map(|strips| [strips as usize, (per_strip * strips) as usize]).into();
    meshes.dedup();
    meshes
}
