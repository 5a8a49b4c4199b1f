//! The stored forces, and cubic interpolation between them.

use super::nodes::{self, COUNTS, MIRRORED, STORED, TURNED};

const VALUES: usize = 3 * STORED[0] * STORED[1] * STORED[2] * STORED[3] * STORED[4];
static BYTES: &[u8; 2 * VALUES] = include_bytes!("stored.bin");

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

/// Where coefficients that hold for one axis ratio and one Poisson's ratio come from.
pub(super) trait Mixed {
    /// Those of a direction, for four neighbouring sizes from one on.
    fn mixed(&self, direction: [usize; 2], first: usize) -> [[f64; 3]; 4];
}

/// The stored table, of which each read mixes four axis ratios and four Poisson's ratios.
pub(super) struct Stored {
    ratio: Stencil,
    poisson: Stencil,
}

impl Stored {
    pub(super) fn new(ratio: f64, poisson: f64) -> Self {
        Self {
            ratio: Stencil::of_spline(nodes::place_of_ratio(ratio), COUNTS[0] - 1),
            poisson: Stencil::of_four(nodes::place_of_poisson(poisson)),
        }
    }
}

impl Mixed for Stored {
    fn mixed(&self, [row, column]: [usize; 2], first: usize) -> [[f64; 3]; 4] {
        let mut sum = [[0.0; 3]; 4];
        for (i, part_of) in self.ratio.weights.iter().enumerate() {
            let contact = (self.ratio.first + 1) as usize + i;
            let direction = (contact * STORED[1] + row) * STORED[2] + column;
            let begin = 6 * STORED[4] * (direction * STORED[3] + first);
            let bytes = &BYTES[begin..begin + 24 * STORED[4]];
            for (own, bytes) in sum.iter_mut().zip(bytes.chunks_exact(6 * STORED[4])) {
                for (weight, bytes) in self.poisson.weights.iter().zip(bytes.chunks_exact(6)) {
                    let (weight, value) = (part_of * weight, |part: usize| {
                        nodes::coefficient([bytes[2 * part], bytes[2 * part + 1]])
                    });
                    (0..3).for_each(|part| own[part] += weight * value(part));
                }
            }
        }
        sum
    }
}

/// The table at one axis ratio and one Poisson's ratio, mixed once; the bits are those of [`Stored`].
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Prepared {
    values: Vec<[f64; 3]>,
}

impl Prepared {
    pub(super) fn new(stored: &Stored) -> Self {
        let mut values = Vec::with_capacity(STORED[1] * STORED[2] * STORED[3]);
        for direction in 0..STORED[1] * STORED[2] {
            let direction = [direction / STORED[2], direction % STORED[2]];
            values.extend((0..STORED[3]).map(|size| {
                let first = size.min(STORED[3] - 4);
                stored.mixed(direction, first)[size - first]
            }));
        }
        Self { values }
    }
}

impl Mixed for Prepared {
    fn mixed(&self, [row, column]: [usize; 2], first: usize) -> [[f64; 3]; 4] {
        let begin = (row * STORED[2] + column) * STORED[3] + first;
        let values = &self.values[begin..begin + 4];
        [values[0], values[1], values[2], values[3]]
    }
}

/// The forces at an axis ratio and scaled creepages of any signs; `rates` are the creepages on which they work, in any unit.
pub(super) fn at(table: &impl Mixed, ratio: f64, scaled: [f64; 3], rates: [f64; 3]) -> Found {
    // Beyond 1e6 the contact slides as a rigid one.
    let scaled = scaled.map(|part| part.clamp(-f64::MAX, f64::MAX));
    let most = scaled.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
    if most == 0.0 {
        return Found { forces: [0.0; 3], error: 0.0 };
    }
    let scaled = if most > LARGEST { scaled.map(|part| part * (LARGEST / most)) } else { scaled };
    let ([x, y, phi], signs) = folded(scaled);
    let size = libm::hypot(libm::hypot(x, y), phi);
    let weight = nodes::weight(size);
    let sum = summed(table, nodes::places(ratio, [x, y, phi]));
    let raw = [0, 1, 2].map(|part| signs[part] * weight * sum[part]);
    let forces = clipped(raw, rates);
    let clip = raw.iter().zip(forces).map(|(raw, own)| (raw - own).abs()).fold(0.0, f64::max);
    Found { forces, error: bound(weight, ratio, phi / size) + clip }
}

/// The sum over the 4 x 4 x 4 coefficients about a place.
fn summed(table: &impl Mixed, [theta, psi, size]: [f64; 3]) -> [f64; 3] {
    let theta = Stencil::of_spline(theta, COUNTS[1] - 1);
    let psi = Stencil::of_spline(psi, COUNTS[2] - 1);
    let size = Stencil::of_spline(size, COUNTS[3] - 1);
    let mut sum = [0.0; 3];
    for at in 0..16 {
        let (k, l) = (at / 4, at % 4);
        let (direction, signs) = nodes::reflected(theta.first + k as isize, psi.first + l as isize);
        // A spline along sizes or axis ratios has one coefficient before its first node.
        let values = table.mixed(direction, (size.first + 1) as usize);
        let mut line = [0.0; 3];
        for (weight, values) in size.weights.iter().zip(values) {
            (0..3).for_each(|part| line[part] += weight * values[part]);
        }
        let weight = theta.weights[k] * psi.weights[l];
        (0..3).for_each(|part| sum[part] += weight * signs[part] * line[part]);
    }
    sum
}

/// A scaled creepage from which all is rigid sliding.
const LARGEST: f64 = 1e6;
/// How far the interpolated forces may be off fresh solutions, but for one or two in a hundred: fitted on 870 drawn contacts
/// and judged by others. In slender contacts forces vary fast from node to node where most of the creepage is spin.
fn bound(weight: f64, ratio: f64, spin: f64) -> f64 {
    let slender = 1.0 - 2.0 / (ratio + 1.0 / ratio);
    0.0045 * weight / (weight + 0.15) * (1.0 + 3.0 * slender * spin * spin)
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
