//! Loads of the tests of fields.

use carom_halfspace::{Material, Stress, Traction};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::field::EllipsoidalLoad;

pub(crate) const LOADS: [Traction; 3] = [
    Traction { x: 1.0, y: 0.0, normal: 0.0 },
    Traction { x: 0.0, y: 1.0, normal: 0.0 },
    Traction { x: 0.0, y: 0.0, normal: 1.0 },
];

pub(crate) fn body(nu: f64) -> Material {
    Material::from_shear(1.0, nu).unwrap()
}

pub(crate) fn load(a: f64, b: f64, nu: f64) -> EllipsoidalLoad {
    EllipsoidalLoad::new(ContactEllipse::new(a, b).unwrap(), body(nu)).unwrap()
}

pub(crate) fn components(stress: Stress) -> [f64; 6] {
    [stress.xx, stress.yy, stress.zz, stress.xy, stress.yz, stress.zx]
}

#[track_caller]
pub(crate) fn same<const N: usize>(what: &str, got: [f64; N], want: [f64; N], tolerance: f64) {
    for (i, (got, want)) in got.iter().zip(want).enumerate() {
        assert!((got - want).abs() <= tolerance, "{what} [{i}]: {got:e} for {want:e}");
    }
}
