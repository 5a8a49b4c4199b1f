//! Directions and attitudes for tests, the same in every run.

use carom_drawn::{Draw as _, Splitmix};
use carom_geometry::Attitude;
use nalgebra::Vector3;
use std::f64::consts::PI;

pub(crate) fn direction(numbers: &mut Splitmix) -> Vector3<f64> {
    let (z, angle) = (numbers.between(-1.0, 1.0), numbers.between(-PI, PI));
    let rim = (1.0 - z * z).sqrt();
    Vector3::new(rim * angle.cos(), rim * angle.sin(), z)
}

pub(crate) fn attitude(numbers: &mut Splitmix) -> Attitude {
    Attitude::about(direction(numbers).into(), numbers.between(0.0, PI)).unwrap()
}
