//! The part of the influence of near cells that interpolation from a grid with twice the spacing misses.
//!
//! The influence between two points far apart is smooth in both. It is taken from the influence between the nodes of a
//! grid of twice the spacing, by quintic interpolation along both axes at both points; an even place is a node itself. For
//! points at most [`REACH`] apart the difference to the exact influence is added. It depends on the offset and on
//! whether the places of the receiver are odd.

/// Points at most so far apart along both axes have their exact influence.
pub(super) const REACH: usize = 8;
/// Numbers in a row of a stencil: those of all offsets, and zeros that fill vectors of eight.
pub(super) const ROW: usize = 2 * REACH + 8;
/// Nodes reach so far from an odd place.
pub(super) const NODES: usize = 5;

/// The nodes of interpolation at an odd place, by their offsets on the fine grid.
const ODD: [(i32, f32); 6] = [
    (-5, 0.01171875),
    (-3, -0.09765625),
    (-1, 0.5859375),
    (1, 0.5859375),
    (3, -0.09765625),
    (5, 0.01171875),
];
/// The weights of all nodes about a place of each kind, see [`kind`](super::level::Frame::kind), from the first one that an
/// odd place has; an even place is the fourth of them.
pub(super) static INTERPOLATED: [[[f32; 8]; 6]; 4] = {
    let even = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0];
    let mut odd = [0.0; 6];
    let mut at = 0;
    while at < 6 {
        odd[at] = ODD[at].1;
        at += 1;
    }
    [products(&even, &even), products(&odd, &even), products(&even, &odd), products(&odd, &odd)]
};

/// What a node has of the pressures about it, from an offset of minus [`NODES`] on: those that are interpolated from it.
pub(super) static GATHERED: [[f32; 16]; 2 * NODES + 1] = {
    let mut weights = [0.0; 2 * NODES + 1];
    weights[NODES] = 1.0;
    let mut at = 0;
    while at < 6 {
        weights[2 * at] = ODD[at].1;
        at += 1;
    }
    products(&weights, &weights)
};

/// The products of weights along x and y.
const fn products<const R: usize, const W: usize>(x: &[f32; R], y: &[f32; R]) -> [[f32; W]; R] {
    let mut all = [[0.0; W]; R];
    let mut row = 0;
    while row < R {
        let mut column = 0;
        while column < R {
            all[row][column] = x[column] * y[row];
            column += 1;
        }
        row += 1;
    }
    all
}

/// What is missing, by offset along y and x.
pub(super) type Stencil = [[f32; ROW]; 2 * REACH + 1];

/// The nodes of two points are at most so much farther apart than the points.
const FARTHER: usize = 2 * NODES;
const FARTHEST: usize = REACH + FARTHER;

/// The stencils of the four kinds of receivers, see [`kind`](super::level::Frame::kind), from a kernel that is even along
/// both axes.
pub(super) fn stencils(kernel: &impl Fn(i32, i32) -> f64) -> [Stencil; 4] {
    let mut known = [[0.0; FARTHEST + 1]; FARTHEST + 1];
    for (y, row) in known.iter_mut().enumerate() {
        for (x, value) in row.iter_mut().enumerate() {
            *value = kernel(x as i32, y as i32);
        }
    }
    let kernel = &|x: i32, y: i32| known[y.unsigned_abs() as usize][x.unsigned_abs() as usize];
    [[0, 0], [1, 0], [0, 1], [1, 1]].map(|odd| {
        let mut stencil = Stencil::default();
        for (row, values) in stencil.iter_mut().enumerate() {
            for (column, value) in values[..=2 * REACH].iter_mut().enumerate() {
                let offset = [column, row].map(|place| place as i32 - REACH as i32);
                let missing = kernel(offset[0], offset[1]) - interpolated(kernel, odd, offset);
                *value = missing as f32;
            }
        }
        stencil
    })
}

/// The influence at an offset by interpolation at both points.
fn interpolated(kernel: &impl Fn(i32, i32) -> f64, odd: [i32; 2], offset: [i32; 2]) -> f64 {
    let [along_x, along_y] = [0, 1].map(|axis| shares(odd[axis] == 1, offset[axis] % 2 != 0));
    let mut sum = 0.0;
    for (y, of_y) in &along_y {
        for (x, of_x) in &along_x {
            sum += of_x * of_y * kernel(offset[0] + x, offset[1] + y);
        }
    }
    sum
}

/// Offsets between nodes, less that between the points, with their weights along one axis.
fn shares(receiver_is_odd: bool, offset_is_odd: bool) -> Vec<(i32, f64)> {
    let odd = ODD.map(|(offset, weight)| (offset, f64::from(weight)));
    match (receiver_is_odd, offset_is_odd) {
        (false, false) => vec![(0, 1.0)],
        (_, true) => odd.to_vec(),
        (true, false) => odd.iter().flat_map(|(a, p)| odd.map(|(b, q)| (a - b, p * q))).collect(),
    }
}
