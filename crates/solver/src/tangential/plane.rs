//! Fields of two components.

use carom_halfspace::operator::Threads;

use crate::lanes::product;
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

/// The sum of products of both components.
pub(super) fn dot(threads: Threads, a: &Plane, b: &Plane) -> f64 {
    parts::sum(threads, (slices(a), slices(b)), &|(a, b)| product(a[0], b[0]) + product(a[1], b[1]))
}
