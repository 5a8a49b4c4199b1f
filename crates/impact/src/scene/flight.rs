//! Free flight: the centre moves on a parabola.

use nalgebra::Vector3;

/// Components of a vector along a normal below this fraction of it are round-off.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The component of a vector along a normal; zero if it is within round-off.
pub(super) fn along(vector: &Vector3<f64>, normal: &Vector3<f64>) -> f64 {
    let part = vector.dot(normal);
    if part.abs() <= ROUNDING * vector.amax() { 0.0 } else { part }
}

/// Motion of a centre from its start under constant acceleration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Flight {
    pub(super) position: Vector3<f64>,
    pub(super) velocity: Vector3<f64>,
    pub(super) gravity: Vector3<f64>,
}

impl Flight {
    pub(super) fn position_after(&self, time: f64) -> Vector3<f64> {
        self.position + time * (self.velocity + 0.5 * time * self.gravity)
    }

    pub(super) fn velocity_after(&self, time: f64) -> Vector3<f64> {
        self.velocity + time * self.gravity
    }

    /// The time at which the gap `gap` along `normal` closes: the root of gap + v_n t + g_n t^2/2 with
    /// negative slope. None if it never closes.
    pub(super) fn closing(&self, gap: f64, normal: &Vector3<f64>) -> Option<f64> {
        let (v, g) = (along(&self.velocity, normal), along(&self.gravity, normal));
        if gap == 0.0 && v < 0.0 {
            return Some(0.0);
        }
        let discriminant = v * v - 2.0 * g * gap;
        if discriminant <= 0.0 {
            return None;
        }
        let speed = discriminant.sqrt();
        // The root with negative slope is -(v + speed)/g; in the form without cancellation.
        let time = match (v > 0.0, g == 0.0) {
            (true, true) => return None,
            (true, false) => -(v + speed) / g,
            (false, _) => 2.0 * gap / (speed - v),
        };
        (time >= 0.0 && time.is_finite()).then_some(time)
    }

    /// |c(t) - origin|^2 - radius^2 as a polynomial in t, of the components perpendicular to `axis` if given.
    pub(super) fn distance_polynomial(
        &self,
        origin: &Vector3<f64>,
        axis: Option<&Vector3<f64>>,
        radius: f64,
    ) -> [f64; 5] {
        let across = |vector: Vector3<f64>| match axis {
            Some(axis) => vector - vector.dot(axis) * axis,
            None => vector,
        };
        let w = across(self.position - origin);
        let (v, h) = (across(self.velocity), across(0.5 * self.gravity));
        let distance = w.norm();
        [
            (distance - radius) * (distance + radius),
            2.0 * w.dot(&v),
            v.norm_squared() + 2.0 * w.dot(&h),
            2.0 * v.dot(&h),
            h.norm_squared(),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flight(velocity: f64, gravity: f64) -> Flight {
        let (position, z) = (Vector3::zeros(), Vector3::z());
        Flight { position, velocity: velocity * z, gravity: gravity * z }
    }

    #[test]
    fn gaps_close_when_they_should() {
        let closing =
            |gap, velocity, gravity| flight(velocity, gravity).closing(gap, &Vector3::z());
        assert_eq!(closing(5.0, 0.0, -10.0), Some(1.0));
        assert_eq!(closing(2.0, -4.0, 0.0), Some(0.5));
        assert_eq!(closing(0.0, 5.0, -10.0), Some(1.0));
        assert_eq!(closing(0.0, -1.0, -10.0), Some(0.0));
        // Thrown at a ceiling: too slow, or fast enough.
        assert_eq!(closing(1.0, -1.0, 10.0), None);
        // It comes to rest at the ceiling, and does not press.
        assert_eq!(closing(2.0, -4.0, 4.0), None);
        assert_eq!(closing(0.5, -3.5, 12.0), Some(1.0 / 4.0));
        assert_eq!(closing(1.0, 1.0, 0.0), None);
        assert_eq!(closing(0.0, 0.0, -10.0), None);
        // Any speed is enough.
        assert_eq!(closing(0.0, -1e-200, -10.0), Some(0.0));
    }
}
