//! The stored forces, and cubic interpolation between them.

use super::nodes::{self, COUNTS, MIRRORED, STORED, TURNED};
use std::sync::LazyLock;

const VALUES: usize = 3 * STORED[0] * STORED[1] * STORED[2] * STORED[3] * STORED[4];
static BYTES: &[u8; 4 * VALUES] = include_bytes!("stored.bin");

/// Made at the first use.
static TABLE: LazyLock<Vec<f32>> = LazyLock::new(|| {
    let number = |bytes: &[u8]| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
    BYTES.chunks_exact(4).map(number).collect()
});

/// Forces over the friction limit, M_z also over sqrt(ab), and how far they may be off.
pub(super) struct Found {
    pub(super) forces: [f64; 3],
    pub(super) error: f64,
}

/// Four neighbouring coefficients and their weights.
#[derive(Clone, Copy)]
struct Stencil {
    first: isize,
    weights: [f64; 4],
}

impl Stencil {
    /// Of the cubic B-spline about a place among nodes; `first` is the coefficient of the node before the cell's.
    fn of_spline(place: f64, cells: usize) -> Self {
        let cell = libm::floor(place).clamp(0.0, cells as f64 - 1.0);
        let t = place - cell;
        let o = 1.0 - t;
        let inner = |t: f64| (t * t * (3.0 * t - 6.0) + 4.0) / 6.0;
        let weights = [o * o * o / 6.0, inner(t), inner(o), t * t * t / 6.0];
        Self { first: cell as isize - 1, weights }
    }

    /// Of the cubic polynomial through four nodes.
    fn of_four(place: f64) -> Self {
        let [a, b, c, d] = [place, place - 1.0, place - 2.0, place - 3.0];
        let weights = [-b * c * d / 6.0, a * c * d / 2.0, -a * b * d / 2.0, a * b * c / 6.0];
        Self { first: 0, weights }
    }
}

/// The forces at an axis ratio, a Poisson's ratio and scaled creepages of any signs; `rates` are the creepages on which they
/// work, in any unit.
pub(super) fn at(ratio: f64, poisson: f64, scaled: [f64; 3], rates: [f64; 3]) -> Found {
    // Beyond 1e6 the contact slides as a rigid one; infinities do not reach the table.
    let most = scaled.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
    if most == 0.0 {
        return Found { forces: [0.0; 3], error: 0.0 };
    }
    let scaled = if most > LARGEST { scaled.map(|part| part * (LARGEST / most)) } else { scaled };
    let ([x, y, phi], signs) = folded(scaled);
    let weight = nodes::weight(libm::hypot(libm::hypot(x, y), phi));
    let [theta, psi, size] = nodes::places(ratio, [x, y, phi]);
    let sum = summed(ratio, poisson, [theta, psi, size]);
    let raw = [0, 1, 2].map(|part| signs[part] * weight * sum[part]);
    let forces = clipped(raw, rates);
    let clip = raw.iter().zip(forces).map(|(raw, own)| (raw - own).abs()).fold(0.0, f64::max);
    Found { forces, error: bound(weight) + clip }
}

/// The sum over the 4 x 16 x 4 x 4 coefficients about a place.
fn summed(ratio: f64, poisson: f64, [theta, psi, size]: [f64; 3]) -> [f64; 3] {
    let outer = Stencil::of_spline(nodes::place_of_ratio(ratio), COUNTS[0] - 1);
    let theta = Stencil::of_spline(theta, COUNTS[1] - 1);
    let psi = Stencil::of_spline(psi, COUNTS[2] - 1);
    let size = Stencil::of_spline(size, COUNTS[3] - 1);
    let poisson = Stencil::of_four(nodes::place_of_poisson(poisson));
    let mut inner = [0.0; 16];
    for (at, weight) in inner.iter_mut().enumerate() {
        *weight = size.weights[at / 4] * poisson.weights[at % 4];
    }
    // A spline along sizes or axis ratios has one coefficient before its first node.
    let along = 3 * STORED[4] * (size.first + 1) as usize;
    let mut sum = [0.0; 3];
    for at in 0..16 {
        let (k, l) = (at / 4, at % 4);
        let ([row, column], signs) =
            nodes::reflected(theta.first + k as isize, psi.first + l as isize);
        let mut line = [0.0; 3];
        for (i, part_of) in outer.weights.iter().enumerate() {
            let contact = (outer.first + 1) as usize + i;
            let direction = (contact * STORED[1] + row) * STORED[2] + column;
            let first = direction * 3 * STORED[3] * STORED[4] + along;
            let values = &TABLE[first..first + 48];
            let mut own = [0.0; 3];
            for (weight, values) in inner.iter().zip(values.chunks_exact(3)) {
                (0..3).for_each(|part| own[part] += weight * f64::from(values[part]));
            }
            (0..3).for_each(|part| line[part] += part_of * own[part]);
        }
        let weight = theta.weights[k] * psi.weights[l];
        (0..3).for_each(|part| sum[part] += weight * signs[part] * line[part]);
    }
    sum
}

/// A scaled creepage from which all is rigid sliding.
const LARGEST: f64 = 1e6;
/// How far the interpolated forces may be off fresh solutions, but for less than one in a hundred: fitted on 500 drawn contacts
/// and judged by others.
fn bound(weight: f64) -> f64 {
    0.0045 * weight / (weight + 0.15)
}

/// The creepage in the quarter of the table, and the signs of its forces.
fn folded([mut x, mut y, mut phi]: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let mut signs = [1.0; 3];
    if phi < 0.0 {
        (y, phi) = (-y, -phi);
        (0..3).for_each(|i| signs[i] *= MIRRORED[i]);
    }
    if x < 0.0 {
        x = -x;
        (0..3).for_each(|i| signs[i] *= TURNED[i]);
    }
    ([x, y, phi], signs)
}

/// Forces within the friction limit, and whose work heats.
fn clipped([mut f_x, mut f_y, mut m_z]: [f64; 3], [x, y, phi]: [f64; 3]) -> [f64; 3] {
    let pulled = libm::hypot(f_x, f_y);
    if pulled > 1.0 {
        (f_x, f_y) = (f_x / pulled, f_y / pulled);
    }
    let power = f_x * x + f_y * y + m_z * phi;
    if power < 0.0 {
        let part = power / (x * x + y * y + phi * phi);
        (f_x, f_y, m_z) = (f_x - part * x, f_y - part * y, m_z - part * phi);
    }
    [f_x, f_y, m_z]
}
