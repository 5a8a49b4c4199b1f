//! Kalker's creep coefficients: steady rolling at vanishing creepage, where all sticks.

use carom_halfspace::{Material, MaterialPair, Offset, Rectangle, RectangleInfluence};
use carom_special::RangeError;
use faer::Mat;
use faer::linalg::solvers::Solve as _;

use super::RollingError;
use crate::direct::DirectError;

/// Strips of the meshes from which is extrapolated.
const MESHES: [usize; 3] = [14, 20, 28];
/// Strips longer than this along the direction of rolling, a/b, have twice as many elements.
const LONG: f64 = 3.0;

/// Forces at vanishing creepage, for two equal bodies of shear modulus G each and a contact with the
/// semi-axes a along the direction of rolling and b across it:
/// F_x = G a b C11 xi, F_y = G a b (C22 eta - sqrt(ab) C23 phi),
/// M_z = G (ab)^(3/2) (C32 eta + sqrt(ab) C33 phi) with C32 = C23, in this crate's signs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepCoefficients {
    /// Force along by creepage along.
    pub c11: f64,
    /// Force across by creepage across.
    pub c22: f64,
    /// Force across by spin.
    pub c23: f64,
    /// Torque by creepage across; C23 in the continuum.
    pub c32: f64,
    /// Torque by spin.
    pub c33: f64,
}

impl CreepCoefficients {
    fn combine(all: &[Self], weights: &[f64]) -> Self {
        let sum = |of: fn(&Self) -> f64| all.iter().zip(weights).map(|(c, w)| w * of(c)).sum();
        Self {
            c11: sum(|c| c.c11),
            c22: sum(|c| c.c22),
            c23: sum(|c| c.c23),
            c32: sum(|c| c.c32),
            c33: sum(|c| c.c33),
        }
    }
}

/// The coefficients of the continuum, extrapolated from three meshes by the first and second power of
/// their widths.
///
/// # Errors
/// [`RollingError::Range`] for a ratio a/b outside 0.05 to 20 or a Poisson's ratio out of range.
pub fn creep_coefficients(ratio: f64, poisson: f64) -> Result<CreepCoefficients, RollingError> {
    let all: Result<Vec<_>, _> =
        MESHES.iter().map(|&count| creep_coefficients_on(count, ratio, poisson)).collect();
    let widths = MESHES.map(|count| 1.0 / count as f64);
    // Lagrange's weights at width 0.
    let weight = |i: usize| -> f64 {
        let others = (0..widths.len()).filter(|&k| k != i);
        others.map(|k| widths[k] / (widths[k] - widths[i])).product()
    };
    let weights: Vec<f64> = (0..widths.len()).map(weight).collect();
    Ok(CreepCoefficients::combine(&all?, &weights))
}

/// An element of a strip.
struct Element {
    x: f64,
    y: f64,
    width: f64,
    influence: RectangleInfluence,
}

/// The coefficients on a mesh of `count` strips along the direction of rolling, each of `count`
/// elements between the edges of the ellipse (twice as many where a > 3 b). A particle comes from one element ahead, the first one
/// from outside, where there is no traction.
///
/// # Errors
/// As [`creep_coefficients`], and for fewer than 2 or more than 48 strips.
pub fn creep_coefficients_on(
    count: usize,
    ratio: f64,
    poisson: f64,
) -> Result<CreepCoefficients, RollingError> {
    RangeError::check("strips", count as f64, (2..=48).contains(&count), "from 2 to 48")?;
    RangeError::check("a/b", ratio, (0.05..=20.0).contains(&ratio), "from 0.05 to 20")?;
    // a b = 1, G = 1
    let (a, b) = (ratio.sqrt(), 1.0 / ratio.sqrt());
    let body = Material::from_shear(1.0, poisson)?;
    let pair = MaterialPair::new(body, body)?;
    let along = if ratio > LONG { 2 * count } else { count };
    let elements = strips([count, along], [a, b], pair)?;
    let tractions = adhere(&elements)?;
    let height = 2.0 * b / count as f64;
    let load = |motion: usize, weigh: &dyn Fn(&Element) -> [f64; 2]| -> f64 {
        let parts = elements.iter().enumerate().map(|(i, element)| {
            let [x, y] = weigh(element);
            let t = [tractions[(2 * i, motion)], tractions[(2 * i + 1, motion)]];
            element.width * height * (x * t[0] + y * t[1])
        });
        parts.sum()
    };
    let (pull, push) = (|_: &Element| [1.0, 0.0], |_: &Element| [0.0, 1.0]);
    let torque = |element: &Element| [element.y, -element.x];
    Ok(CreepCoefficients {
        c11: load(0, &pull),
        c22: load(1, &push),
        c23: -load(2, &push),
        c32: load(1, &torque),
        c33: load(2, &torque),
    })
}

fn strips(
    [count, along]: [usize; 2],
    [a, b]: [f64; 2],
    pair: MaterialPair,
) -> Result<Vec<Element>, RangeError> {
    let height = 2.0 * b / count as f64;
    let mut elements = Vec::with_capacity(count * along);
    for row in 0..count {
        let y = (row as f64 + 0.5) * height - b;
        let half = a * (1.0 - (y / b) * (y / b)).sqrt();
        let width = 2.0 * half / along as f64;
        let influence = RectangleInfluence::new(pair, Rectangle::new(width, height)?);
        for column in 0..along {
            let x = (column as f64 + 0.5) * width - half;
            elements.push(Element { x, y, width, influence });
        }
    }
    Ok(elements)
}

/// Tractions, two to an element, for unit creepage along, across, and unit spin.
fn adhere(elements: &[Element]) -> Result<Mat<f64>, RollingError> {
    let unknowns = 2 * elements.len();
    let mut matrix = Mat::<f64>::zeros(unknowns, unknowns);
    for (i, to) in elements.iter().enumerate() {
        for (k, from) in elements.iter().enumerate() {
            let offset = |x: f64| Offset { x: from.x - x, y: from.y - to.y };
            let here = from.influence.coefficients(offset(to.x))?.rows;
            let ahead = from.influence.coefficients(offset(to.x + to.width))?.rows;
            for of in 0..2 {
                for by in 0..2 {
                    matrix[(2 * i + of, 2 * k + by)] = (here[of][by] - ahead[of][by]) / to.width;
                }
            }
        }
    }
    let right = Mat::from_fn(unknowns, 3, |row, motion| {
        let element = &elements[row / 2];
        // Half way from where the particle comes.
        let (x, y) = (element.x + 0.5 * element.width, element.y);
        [[1.0, 0.0], [0.0, 1.0], [y, -x]][motion][row % 2]
    });
    let tractions = matrix.partial_piv_lu().solve(&right);
    let finite = (0..3).all(|k| tractions.col(k).iter().all(|value| value.is_finite()));
    if finite { Ok(tractions) } else { Err(DirectError::Singular { unknowns }.into()) }
}
