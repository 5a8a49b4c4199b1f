//! Kalker's creep coefficients: steady rolling with vanishing creepage and complete adhesion.

mod adhesion;
mod continuum;
mod entry;
mod strips;

use carom_halfspace::{Material, MaterialPair};
use carom_laws::creep::CreepCoefficients;
use carom_special::RangeError;

use super::RollingError;
use adhesion::{Adhesion, Motion};
pub use continuum::ContinuumForces;
pub use entry::creep_table_entry;
use strips::Strips;

/// Approximate number of elements of the finest mesh for the extrapolation.
const ELEMENTS: f64 = 1600.0;
/// Least number of strips of the finest mesh.
const STRIPS: f64 = 10.0;
/// Approximate number of strips of the meshes relative to the finest.
const PARTS: [f64; 4] = [0.35, 0.5, 0.7, 1.0];
/// Greatest number of elements; four matrices with half this number of rows are solved.
const MOST_ELEMENTS: usize = 5000;

/// The sum of coefficients times weights.
fn combine(all: &[CreepCoefficients], weights: &[f64]) -> CreepCoefficients {
    let sum =
        |of: fn(&CreepCoefficients) -> f64| all.iter().zip(weights).map(|(c, w)| w * of(c)).sum();
    CreepCoefficients {
        c11: sum(|c| c.c11),
        c22: sum(|c| c.c22),
        c23: sum(|c| c.c23),
        c32: sum(|c| c.c32),
        c33: sum(|c| c.c33),
    }
}

/// The coefficients of the continuum, extrapolated from four meshes in the first three powers of
/// their cell widths. For a/b from 0.2 to 5 they agree within 0.03 % (C33 0.12 %) with an
/// independent calculation, with the closed forms of a circle for a Poisson's ratio of zero, and
/// with reciprocity, C23 = C32; at a/b = 10 within 0.05 % (C33 2 %).
///
/// ```
/// use carom_rolling::creep_coefficients;
/// let circle = creep_coefficients(1.0, 0.0)?;
/// assert!((circle.c11 / (32.0 / (3.0 * std::f64::consts::PI)) - 1.0).abs() < 1e-4);
/// assert!((circle.c23 / (4.0 / 3.0) - 1.0).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`RollingError::Range`] for a ratio a/b outside 0.05 to 20 or a Poisson's ratio out of range.
pub fn creep_coefficients(ratio: f64, poisson: f64) -> Result<CreepCoefficients, RollingError> {
    check_ratio(ratio)?;
    let meshes = meshes(ratio);
    let all: Result<Vec<_>, _> =
        meshes.iter().map(|mesh| creep_coefficients_on(*mesh, ratio, poisson)).collect();
    let widths = meshes.map(|[strips, _]| 1.0 / strips as f64);
    // Lagrange's weights for width 0.
    let weight = |i: usize| -> f64 {
        let others = (0..widths.len()).filter(|&k| k != i);
        others.map(|k| widths[k] / (widths[k] - widths[i])).product()
    };
    let weights: Vec<f64> = (0..widths.len()).map(weight).collect();
    Ok(combine(&all?, &weights))
}

fn check_ratio(ratio: f64) -> Result<(), RangeError> {
    RangeError::check("a/b", ratio, (0.05..=20.0).contains(&ratio), "from 0.05 to 20").map(drop)
}

/// Meshes with elements of one shape. In a long contact elements are shorter than wide:
/// neighbouring strips have elements of different lengths, and coarse ones would make the error
/// jump from mesh to mesh.
fn meshes(ratio: f64) -> [[usize; 2]; PARTS.len()] {
    let per_strip = if ratio > 1.0 { (1.5 * ratio).ceil() } else { 1.0 };
    let finest = (ELEMENTS / per_strip).sqrt().max(STRIPS);
    let even = |strips: f64| 2.0 * (0.5 * strips).round();
    PARTS
        .map(|part| even(part * even(finest)))
        .map(|strips| [strips, per_strip * strips])
        .map(|mesh| mesh.map(|count| count as usize))
}

/// The coefficients on a mesh of strips along the direction of rolling; `mesh` is the number of
/// strips and the number of elements in each, between the edges of the ellipse. A particle comes
/// from the element ahead of it; for the first element it comes from outside, where there is no
/// traction.
///
/// # Errors
/// As [`creep_coefficients`]; also unless there is an even number of strips from 2 to 200 with 2 to
/// 400 elements each, 5000 in all.
pub fn creep_coefficients_on(
    mesh: [usize; 2],
    ratio: f64,
    poisson: f64,
) -> Result<CreepCoefficients, RollingError> {
    let [strips, along] = mesh;
    let fits = (2..=200).contains(&strips) && strips % 2 == 0;
    RangeError::check("strips", strips as f64, fits, "an even number from 2 to 200")?;
    let fits = (2..=400).contains(&along) && strips * along <= MOST_ELEMENTS;
    RangeError::check("elements of a strip", along as f64, fits, "from 2 to 400, 5000 in all")?;
    check_ratio(ratio)?;
    // a b = 1, G = 1
    let (a, b) = (ratio.sqrt(), 1.0 / ratio.sqrt());
    let body = Material::from_shear(1.0, poisson)?;
    let pair = MaterialPair::new(body, body)?;
    let adhesion = Adhesion::new(Strips::new(mesh, [a, b], pair)?)?;
    let pull = adhesion.along()?;
    let [push, turn] = adhesion.across_and_spin()?;
    Ok(CreepCoefficients {
        c11: adhesion.load(&pull, Motion::Along),
        c22: adhesion.load(&push, Motion::Across),
        c23: -adhesion.load(&turn, Motion::Across),
        c32: adhesion.load(&push, Motion::Spin),
        c33: adhesion.load(&turn, Motion::Spin),
    })
}
