//! Fields of two components.

/// Two components in each cell.
pub(super) type Plane = [Vec<f64>; 2];

pub(super) fn dot(a: &Plane, b: &Plane) -> f64 {
    let along = |axis: usize| a[axis].iter().zip(&b[axis]).map(|(a, b)| a * b).sum::<f64>();
    along(0) + along(1)
}
