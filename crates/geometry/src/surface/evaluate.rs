//! Normal and curvatures of each kind of surface at a point.

use nalgebra::{Matrix3, Vector3};

use super::jet::Jet;
use super::local::LocalSurface;
use super::{BodySide, Kind, Surface, SurfaceError};

/// Greatest distance of a point from the surface, relative to the size of the body.
const ON_SURFACE: f64 = 1e-6;

impl Surface {
    /// Normal, principal curvatures and directions at a point of the surface.
    ///
    /// # Errors
    /// [`SurfaceError::OffSurface`] if the point is farther than 1e-6 of the size from the surface,
    /// [`SurfaceError::Edge`] or [`SurfaceError::Seam`] where there is no tangent plane or no
    /// curvature, [`SurfaceError::Singular`] where the gradient vanishes.
    pub fn local(&self, point: &Vector3<f64>) -> Result<LocalSurface, SurfaceError> {
        let near = |distance: f64| {
            // A plane has no size: the distance of the point from the origin is used.
            let size = if self.size() > 0.0 { self.size() } else { point.norm() };
            let allowed = ON_SURFACE * size;
            if distance.abs() <= allowed {
                Ok(())
            } else {
                Err(SurfaceError::OffSurface { point: (*point).into(), distance, allowed })
            }
        };
        match self.kind() {
            Kind::Sphere { radius } => {
                near(point.norm() - radius)?;
                Ok(LocalSurface::umbilic(*point, point.normalize(), 1.0 / radius))
            }
            Kind::Ellipsoid { semi_axes } => {
                let jet = ellipsoid(semi_axes, point);
                near(jet.value / jet.gradient.norm())?;
                of_jet(point, &jet)
            }
            Kind::Plane => {
                near(point.z)?;
                Ok(LocalSurface::umbilic(*point, Vector3::z(), 0.0))
            }
            Kind::Cylinder { radius, half_length } => {
                let rim = libm::hypot(point.x, point.y);
                let (side, end) = (rim - radius, point.z.abs() - half_length);
                let edge = ON_SURFACE * self.size();
                if side.abs() <= edge && end.abs() <= edge {
                    return Err(SurfaceError::Edge { part: "the edge of a cylinder" });
                }
                near(side.max(end))?;
                if end.abs() <= edge {
                    let normal = Vector3::new(0.0, 0.0, point.z.signum());
                    return Ok(LocalSurface::umbilic(*point, normal, 0.0));
                }
                Ok(straight_side(point, *radius))
            }
            Kind::Capsule { radius, half_length } => {
                let along = point.z.clamp(-half_length, *half_length);
                let outward = point - Vector3::new(0.0, 0.0, along);
                near(outward.norm() - radius)?;
                let beyond = point.z.abs() - half_length;
                if beyond.abs() <= ON_SURFACE * self.size() {
                    return Err(SurfaceError::Seam {
                        part: "the seam of side and end of a capsule",
                    });
                }
                if beyond > 0.0 {
                    return Ok(LocalSurface::umbilic(*point, outward.normalize(), 1.0 / radius));
                }
                Ok(straight_side(point, *radius))
            }
            Kind::Torus { major, minor } => {
                let rim = libm::hypot(point.x, point.y);
                near(libm::hypot(rim - major, point.z) - minor)?;
                Ok(torus(point, rim, *major, *minor))
            }
            Kind::Box { half } => {
                let off = point.abs() - half;
                near(off.max())?;
                face(point, &off, ON_SURFACE * self.size())
            }
            Kind::Implicit { function, .. } => {
                let jet = function.jet(point);
                near(jet.value / jet.gradient.norm().max(f64::MIN_POSITIVE))?;
                of_jet(point, &jet)
            }
            Kind::Explicit { function, side, .. } => {
                let jet = of_height(&function.jet(point), *side, point.z);
                near(jet.value / jet.gradient.norm())?;
                of_jet(point, &jet)
            }
            Kind::Given { local } => {
                near((point - local.point()).norm())?;
                Ok(*local)
            }
        }
    }
}

fn of_jet(point: &Vector3<f64>, jet: &Jet) -> Result<LocalSurface, SurfaceError> {
    let steepness = jet.gradient.norm();
    let finite = steepness.is_finite() && jet.hessian.iter().all(|h| h.is_finite());
    if steepness == 0.0 || !finite {
        return Err(SurfaceError::Singular { point: (*point).into() });
    }
    let normal = jet.gradient / steepness;
    Ok(LocalSurface::from_tensor(*point, normal, &(jet.hessian / steepness)))
}

/// f = ((a/A)^2 + (b/B)^2 + (c/C)^2 - 1)/2.
pub(super) fn ellipsoid(semi_axes: &Vector3<f64>, point: &Vector3<f64>) -> Jet {
    let weights = semi_axes.map(|s| 1.0 / (s * s));
    let gradient = point.component_mul(&weights);
    let value = 0.5 * (point.dot(&gradient) - 1.0);
    Jet { value, gradient, hessian: Matrix3::from_diagonal(&weights) }
}

// (8.13): f = c(a, b) - c where the body lies above.
fn of_height(height: &Jet, side: BodySide, c: f64) -> Jet {
    let sign = side.sign();
    let (slope, bend) = (height.gradient, height.hessian);
    let (c_aa, c_ab, c_bb) = (bend.m11, bend.m12, bend.m22);
    Jet {
        value: sign * (height.value - c),
        gradient: sign * Vector3::new(slope.x, slope.y, -1.0),
        hessian: sign * Matrix3::new(c_aa, c_ab, 0.0, c_ab, c_bb, 0.0, 0.0, 0.0, 0.0),
    }
}

fn straight_side(point: &Vector3<f64>, radius: f64) -> LocalSurface {
    let normal = Vector3::new(point.x, point.y, 0.0).normalize();
    let around = Vector3::z().cross(&normal);
    LocalSurface::new(*point, normal, [1.0 / radius, 0.0], around)
}

fn torus(point: &Vector3<f64>, rim: f64, major: f64, minor: f64) -> LocalSurface {
    let outward = Vector3::new(point.x, point.y, 0.0) / rim;
    let normal = (outward * (rim - major) + Vector3::new(0.0, 0.0, point.z)).normalize();
    let around = Vector3::z().cross(&outward);
    // Around the tube 1/r, around the axis cos(phi)/(R + r cos(phi)).
    let cos = normal.dot(&outward);
    let curvatures = [1.0 / minor, cos / (major + minor * cos)];
    LocalSurface::new(*point, normal, curvatures, around.cross(&normal))
}

fn face(point: &Vector3<f64>, off: &Vector3<f64>, edge: f64) -> Result<LocalSurface, SurfaceError> {
    match off.iter().filter(|d| d.abs() <= edge).count() {
        2 => Err(SurfaceError::Edge { part: "the edge of a box" }),
        3 => Err(SurfaceError::Edge { part: "the corner of a box" }),
        _ => {
            let axis = off.imax();
            let normal = Vector3::ith(axis, point[axis].signum());
            Ok(LocalSurface::umbilic(*point, normal, 0.0))
        }
    }
}
