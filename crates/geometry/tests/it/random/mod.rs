//! Numbers, directions and attitudes for tests, the same in every run.

use carom_geometry::Attitude;
use nalgebra::Vector3;
use std::f64::consts::PI;

/// Numbers from 0 to 1, the same in every run (splitmix64).
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    pub(crate) fn direction(&mut self) -> Vector3<f64> {
        let (z, angle) = (self.between(-1.0, 1.0), self.between(-PI, PI));
        let rim = (1.0 - z * z).sqrt();
        Vector3::new(rim * angle.cos(), rim * angle.sin(), z)
    }

    pub(crate) fn attitude(&mut self) -> Attitude {
        Attitude::about(self.direction().into(), self.between(0.0, PI)).unwrap()
    }
}
