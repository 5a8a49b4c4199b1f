//! Volumes of the surfaces.

use std::f64::consts::PI;

use super::{Kind, Surface};

impl Surface {
    /// The volume inside the surface; `None` if the interior is not defined.
    ///
    /// ```
    /// use carom_geometry::Surface;
    /// let ball = Surface::sphere(2.0)?;
    /// let egg = Surface::ellipsoid([1.0, 2.0, 4.0])?;
    /// assert_eq!(ball.volume(), egg.volume());
    /// assert_eq!(Surface::plane().volume(), None);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    #[must_use]
    pub fn volume(&self) -> Option<f64> {
        match self.kind() {
            Kind::Sphere { radius } => Some(4.0 / 3.0 * PI * radius * radius * radius),
            Kind::Ellipsoid { semi_axes } => Some(4.0 / 3.0 * PI * semi_axes.product()),
            Kind::Cylinder { radius, half_length } => {
                Some(2.0 * PI * radius * radius * half_length)
            }
            Kind::Capsule { radius, half_length } => {
                Some(PI * radius * radius * (2.0 * half_length + 4.0 / 3.0 * radius))
            }
            // Pappus: the area of the tube's circle times the path of its centre.
            Kind::Torus { major, minor } => Some(2.0 * PI * PI * major * minor * minor),
            Kind::Box { half } => Some(8.0 * half.product()),
            Kind::Plane | Kind::Implicit { .. } | Kind::Explicit { .. } | Kind::Given { .. } => {
                None
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use nalgebra::Vector3;

    // Cones over a grid of directions from the centre.
    fn by_rays(inside: impl Fn(&Vector3<f64>) -> bool) -> f64 {
        let n = 240;
        let mut sum = 0.0;
        for i in 0..n {
            let z = -1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(n);
            for j in 0..n {
                let angle = 2.0 * PI * (f64::from(j) + 0.5) / f64::from(n);
                let flat = (1.0 - z * z).sqrt();
                let ray = Vector3::new(flat * libm::cos(angle), flat * libm::sin(angle), z);
                let (mut low, mut high) = (0.0, 10.0);
                for _ in 0..40 {
                    let middle = 0.5 * (low + high);
                    let part = if inside(&(ray * middle)) { &mut low } else { &mut high };
                    *part = middle;
                }
                sum += low * low * low;
            }
        }
        4.0 * PI / 3.0 * sum / (f64::from(n) * f64::from(n))
    }

    #[test]
    fn volumes_match_rays_from_the_centre() {
        let check = |surface: Surface, inside: &dyn Fn(&Vector3<f64>) -> bool| {
            let counted = by_rays(inside);
            assert_relative_eq!(surface.volume().unwrap(), counted, max_relative = 1e-3);
        };
        check(Surface::sphere(1.3).unwrap(), &|p| p.norm() < 1.3);
        check(Surface::ellipsoid([3.0, 2.0, 1.5]).unwrap(), &|p| {
            (p.x / 3.0).powi(2) + (p.y / 2.0).powi(2) + (p.z / 1.5).powi(2) < 1.0
        });
        let rod = |p: &Vector3<f64>| libm::hypot(p.x, p.y) < 0.7 && p.z.abs() < 1.5;
        check(Surface::cylinder(0.7, 3.0).unwrap(), &rod);
        let round =
            |p: &Vector3<f64>| Vector3::new(p.x, p.y, (p.z.abs() - 1.5).max(0.0)).norm() < 0.7;
        check(Surface::capsule(0.7, 3.0).unwrap(), &round);
        let brick = |p: &Vector3<f64>| p.x.abs() < 0.5 && p.y.abs() < 1.0 && p.z.abs() < 0.3;
        check(Surface::cuboid([1.0, 2.0, 0.6]).unwrap(), &brick);
    }

    #[test]
    fn a_torus_is_an_annulus_turned() {
        // Slices across the axis are rings 4 pi R sqrt(r^2 - c^2).
        let (major, minor, n) = (2.0, 0.7, 20_000);
        let mut sum = 0.0;
        for i in 0..n {
            let c = minor * (-1.0 + 2.0 * (f64::from(i) + 0.5) / f64::from(n));
            sum += 4.0 * PI * major * (minor * minor - c * c).sqrt() * 2.0 * minor / f64::from(n);
        }
        let torus = Surface::torus(major, minor).unwrap().volume().unwrap();
        assert_relative_eq!(torus, sum, max_relative = 1e-6);
    }
}
