//! Inertia of homogeneous bodies and thin shells.

use nalgebra::Vector3;

use super::{Kind, Surface, SurfaceError};
use crate::inertia::Inertia;

impl Surface {
    /// The inertia of a homogeneous solid of this shape.
    ///
    /// ```
    /// use carom_geometry::Surface;
    /// let egg = Surface::ellipsoid([3.0, 2.0, 1.5])?.solid(1.0)?;
    /// assert!((egg.moments()[0] - 1.25).abs() < 1e-15); // m (B^2 + C^2)/5
    /// # Ok::<(), carom_geometry::SurfaceError>(())
    /// ```
    ///
    /// # Errors
    /// [`SurfaceError::Range`] for a mass that is not positive, [`SurfaceError::NoInertia`] for a
    /// surface whose interior is not defined.
    pub fn solid(&self, mass: f64) -> Result<Inertia, SurfaceError> {
        self.inertia(mass, solid_second_moments(self.kind()))
    }

    /// The inertia of a thin shell of this shape: of uniform mass per area, but for an ellipsoid the
    /// homoeoid, whose thickness varies as that between two similar ellipsoids, with `m (B^2 + C^2)/3`.
    ///
    /// # Errors
    /// As [`Surface::solid`].
    pub fn shell(&self, mass: f64) -> Result<Inertia, SurfaceError> {
        self.inertia(mass, shell_second_moments(self.kind()))
    }

    fn inertia(&self, mass: f64, mean: Option<Vector3<f64>>) -> Result<Inertia, SurfaceError> {
        let mean = mean.ok_or(SurfaceError::NoInertia)?;
        let moments = [mean.y + mean.z, mean.z + mean.x, mean.x + mean.y];
        Ok(Inertia::new(mass, moments.map(|square| mass * square))?)
    }
}

/// Mean squares of a, b and c over the volume.
fn solid_second_moments(kind: &Kind) -> Option<Vector3<f64>> {
    match kind {
        Kind::Sphere { radius } => Some(Vector3::repeat(0.2 * radius * radius)),
        Kind::Ellipsoid { semi_axes } => Some(semi_axes.component_mul(semi_axes) * 0.2),
        Kind::Cylinder { radius: r, half_length: h } => Some(axial(0.25 * r * r, h * h / 3.0)),
        Kind::Capsule { radius: r, half_length: h } => {
            // Straight part 2h, both halves of a sphere 4r/3, in units of pi r^2.
            let (straight, ends) = (2.0 * h, 4.0 / 3.0 * r);
            let across = straight * 0.25 * r * r + ends * 0.2 * r * r;
            // Half ball: mean of u is 3r/8, mean of u^2 is r^2/5, u from its flat side.
            let along = straight * h * h / 3.0 + ends * (h * h + 0.75 * h * r + 0.2 * r * r);
            Some(axial(across, along) / (straight + ends))
        }
        Kind::Torus { major, minor } => {
            let (big, small) = (major * major, minor * minor);
            Some(axial(0.5 * big + 0.375 * small, 0.25 * small))
        }
        Kind::Box { half } => Some(half.component_mul(half) / 3.0),
        Kind::Plane | Kind::Implicit { .. } | Kind::Explicit { .. } | Kind::Given { .. } => None,
    }
}

/// Mean squares of a, b and c over the surface.
fn shell_second_moments(kind: &Kind) -> Option<Vector3<f64>> {
    match kind {
        Kind::Sphere { radius } => Some(Vector3::repeat(radius * radius / 3.0)),
        Kind::Ellipsoid { semi_axes } => Some(semi_axes.component_mul(semi_axes) / 3.0),
        Kind::Cylinder { radius: r, half_length: h } => {
            // Side 4 pi r h and both ends 2 pi r^2, in units of 2 pi r.
            let (side, ends) = (2.0 * h, *r);
            let across = side * 0.5 * r * r + ends * 0.25 * r * r;
            let along = side * h * h / 3.0 + ends * h * h;
            Some(axial(across, along) / (side + ends))
        }
        Kind::Capsule { radius: r, half_length: h } => {
            // Half sphere: mean of u is r/2, mean of u^2 is r^2/3.
            let (side, ends) = (2.0 * h, 2.0 * r);
            let across = side * 0.5 * r * r + ends * r * r / 3.0;
            let along = side * h * h / 3.0 + ends * (h * h + h * r + r * r / 3.0);
            Some(axial(across, along) / (side + ends))
        }
        Kind::Torus { major, minor } => {
            let (big, small) = (major * major, minor * minor);
            Some(axial(0.5 * big + 0.75 * small, 0.5 * small))
        }
        Kind::Box { half } => {
            let area = Vector3::new(half.y * half.z, half.z * half.x, half.x * half.y);
            // The two faces across an axis lie at its half-edge, the other four reach to it.
            let square = |i: usize| {
                let whole = area.sum();
                half[i] * half[i] * (area[i] + (whole - area[i]) / 3.0) / whole
            };
            Some(Vector3::new(square(0), square(1), square(2)))
        }
        Kind::Plane | Kind::Implicit { .. } | Kind::Explicit { .. } | Kind::Given { .. } => None,
    }
}

fn axial(across: f64, along: f64) -> Vector3<f64> {
    Vector3::new(across, across, along)
}

#[cfg(test)]
mod tests {
    use super::*;

    // Mean squares over the volume of f < 0 in the box of half-widths `half`, by counting cells.
    fn counted(half: [f64; 3], inside: impl Fn(f64, f64, f64) -> bool) -> Vector3<f64> {
        let n = 120;
        let at = |i: i32, h: f64| h * ((f64::from(i) + 0.5) / f64::from(n) * 2.0 - 1.0);
        let (mut sum, mut count) = (Vector3::zeros(), 0.0);
        for i in 0..n {
            for j in 0..n {
                for k in 0..n {
                    let p = Vector3::new(at(i, half[0]), at(j, half[1]), at(k, half[2]));
                    if inside(p.x, p.y, p.z) {
                        sum += p.component_mul(&p);
                        count += 1.0;
                    }
                }
            }
        }
        sum / count
    }

    #[test]
    fn solids_match_counted_cells() {
        let check = |surface: Surface, expected: Vector3<f64>| {
            let own = solid_second_moments(surface.kind()).unwrap();
            assert!((own - expected).amax() < 2e-3 * expected.amax(), "{own} {expected}");
        };
        let capsule = counted([1.0, 1.0, 2.5], |a, b, c| {
            let beyond = (c.abs() - 1.5).max(0.0);
            a * a + b * b + beyond * beyond < 1.0
        });
        check(Surface::capsule(1.0, 3.0).unwrap(), capsule);
        let torus = counted([2.7, 2.7, 0.7], |a, b, c| {
            let rim = a.hypot(b) - 2.0;
            rim * rim + c * c < 0.49
        });
        check(Surface::torus(2.0, 0.7).unwrap(), torus);
        let cylinder = counted([1.0, 1.0, 1.5], |a, b, _| a * a + b * b < 1.0);
        check(Surface::cylinder(1.0, 3.0).unwrap(), cylinder);
        let egg = counted([1.5, 1.0, 0.6], |a, b, c| {
            (a / 1.5).powi(2) + (b * b) + (c / 0.6).powi(2) < 1.0
        });
        check(Surface::ellipsoid([1.5, 1.0, 0.6]).unwrap(), egg);
        let brick = counted([1.0, 1.2, 0.7], |a, _, c| a.abs() < 0.8 && c.abs() < 0.5);
        check(Surface::cuboid([1.6, 2.4, 1.0]).unwrap(), brick);
    }

    #[test]
    fn shells_are_differences_of_solids() {
        // Second moment of a shell = d(volume * mean square)/d(offset) for uniform thickness.
        let check = |make: &dyn Fn(f64) -> (Surface, f64)| {
            let e = 1e-5;
            let total = |d: f64| {
                let (surface, volume) = make(d);
                (solid_second_moments(surface.kind()).unwrap() * volume, volume)
            };
            let ((outer, v_outer), (inner, v_inner)) = (total(e), total(-e));
            let expected = (outer - inner) / (v_outer - v_inner);
            let own = shell_second_moments(make(0.0).0.kind()).unwrap();
            assert!((own - expected).amax() < 1e-8 * expected.amax(), "{own} {expected}");
        };
        let pi = std::f64::consts::PI;
        check(&|d| (Surface::sphere(1.3 + d).unwrap(), (1.3_f64 + d).powi(3)));
        check(&|d| {
            let (r, l) = (0.7 + d, 3.0 + 2.0 * d);
            (Surface::cylinder(r, l).unwrap(), pi * r * r * l)
        });
        check(&|d| {
            let r = 0.7 + d;
            (Surface::capsule(r, 3.0).unwrap(), pi * r * r * (3.0 + 4.0 / 3.0 * r))
        });
        check(&|d| {
            let r = 0.7 + d;
            (Surface::torus(2.0, r).unwrap(), r * r)
        });
        // The homoeoid: between two similar ellipsoids.
        check(&|d| {
            let grow = 1.0 + d;
            (Surface::ellipsoid([1.5, 1.0, 0.6].map(|x| x * grow)).unwrap(), grow.powi(3))
        });
        check(&|d| {
            let edges = [1.0 + 2.0 * d, 2.0 + 2.0 * d, 0.6 + 2.0 * d];
            (Surface::cuboid(edges).unwrap(), edges.iter().product())
        });
    }

    #[test]
    fn a_plane_has_no_inertia_of_its_own() {
        assert_eq!(Surface::plane().solid(1.0), Err(SurfaceError::NoInertia));
    }
}
