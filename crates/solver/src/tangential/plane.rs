//! Fields of two components.

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

pub(super) fn dot(a: &Plane, b: &Plane) -> f64 {
    let along = |axis: usize| a[axis].iter().zip(&b[axis]).map(|(a, b)| a * b).sum::<f64>();
    along(0) + along(1)
}
