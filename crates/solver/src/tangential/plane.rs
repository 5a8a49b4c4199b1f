//! Fields of two components.

use carom_halfspace::operator::Threads;

use crate::parts;

/// Two components in each cell.
pub(super) type Plane = [Vec<f64>; 2];

/// The values of both components.
pub(super) fn slices(plane: &Plane) -> [&[f64]; 2] {
    plane.each_ref().map(Vec::as_slice)
}

/// The values of both components, to be changed.
pub(super) fn slices_mut(plane: &mut Plane) -> [&mut [f64]; 2] {
    plane.each_mut().map(Vec::as_mut_slice)
}

/// Sums are taken in this many lanes, which do not wait for each other.
pub(super) const LANES: usize = 4;

/// The sum of products of both components.
pub(super) fn dot(threads: Threads, a: &Plane, b: &Plane) -> f64 {
    parts::sum(threads, (slices(a), slices(b)), &|(a, b)| product(a[0], b[0]) + product(a[1], b[1]))
}

/// The sum of products of two fields of the same length.
fn product(a: &[f64], b: &[f64]) -> f64 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    let mut sums = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let rest = a_rest.iter().zip(b_rest).map(|(a, b)| a * b);
    sums.into_iter().chain(rest).sum()
}
