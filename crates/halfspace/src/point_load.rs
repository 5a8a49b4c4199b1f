//! The point load on the surface of a half-space: Boussinesq and Cerruti.
//!
//! With the direction cosines (a, b, c) of the vector from the load to the point, every
//! displacement is a bounded function of the direction over r, every stress one over r^2.

use std::f64::consts::PI;

use carom_special::RangeError;

use crate::{Displacement, Force, Material, Point, Stress};

/// A force at the origin of the surface of one elastic half-space.
///
/// ```
/// use carom_halfspace::{Force, Material, Point, PointLoad};
/// let body = Material::from_shear(1.0, 0.5)?;
/// let load = PointLoad::new(body, Force { z: 4.0 * std::f64::consts::PI, ..Force::default() })?;
/// // Incompressible: the surface sinks by F_z (1 - nu)/(2 pi G r) without tangential displacement.
/// let surface = load.displacement(Point::on_surface(2.0, 0.0))?;
/// assert!((surface.w - 0.5).abs() < 1e-15);
/// assert_eq!(surface.u, 0.0);
/// assert!(load.displacement(Point::default()).is_err());
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointLoad {
    shear_modulus: f64,
    poisson: f64,
    force: Force,
}

impl PointLoad {
    /// The load `force` on a body of `material`.
    ///
    /// # Errors
    /// [`RangeError`] if the body is rigid (its stress is undefined) or the force not finite.
    pub fn new(material: Material, force: Force) -> Result<Self, RangeError> {
        let shear_modulus = RangeError::positive("shear_modulus", material.shear_modulus())?;
        Ok(Self { shear_modulus, poisson: material.poisson(), force: force.checked()? })
    }

    /// The displacement (4.1), with its three misprints corrected; on z = 0 it is (4.5).
    ///
    /// # Errors
    /// [`RangeError`] outside the half-space and at the load itself, where it is singular.
    pub fn displacement(&self, at: Point) -> Result<Displacement, RangeError> {
        let (r, direction) = Direction::towards(at)?;
        let scale = 1.0 / (4.0 * PI * self.shear_modulus * r);
        (direction.displacement(self.poisson, self.force) * scale).finite_at("r", r)
    }

    /// The stress (4.2), (4.3), of F_y by exchange of x and y.
    ///
    /// # Errors
    /// [`RangeError`] outside the half-space and at the load itself, where it is singular.
    pub fn stress(&self, at: Point) -> Result<Stress, RangeError> {
        let (r, direction) = Direction::towards(at)?;
        let stress = direction.stress(self.poisson, self.force);
        (stress * (1.0 / (2.0 * PI * r)) * (1.0 / r)).finite_at("r", r)
    }
}

/// A unit vector from the load into the body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Direction {
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) c: f64,
}

impl Direction {
    /// Distance and direction of `at`, safe from overflow and underflow.
    fn towards(at: Point) -> Result<(f64, Self), RangeError> {
        let Point { x, y, z } = at.checked()?;
        let largest = x.abs().max(y.abs()).max(z);
        let singular = "> 0: a point load is singular where it acts";
        RangeError::check("r", largest, largest > 0.0, singular)?;
        let (x, y, z) = (x / largest, y / largest, z / largest);
        let r = (x * x + y * y + z * z).sqrt();
        Ok((largest * r, Self { a: x / r, b: y / r, c: z / r }))
    }

    /// 4 pi G r times the displacement (4.1), corrected.
    pub(crate) fn displacement(self, poisson: f64, force: Force) -> Displacement {
        let Self { a, b, c } = self;
        let (nu, q) = (poisson, 1.0 / (1.0 + c));
        let t = a * force.x + b * force.y;
        // The factor of F_x (F_y), and the factor of the radial direction a (b).
        let along = (2.0 * (1.0 - nu) + c) * q;
        let radial = t * q * q * (2.0 * nu + c * (2.0 + c)) + force.z * (c - (1.0 - 2.0 * nu) * q);
        Displacement {
            u: along * force.x + a * radial,
            v: along * force.y + b * radial,
            w: force.z * (2.0 * (1.0 - nu) + c * c) + t * ((1.0 - 2.0 * nu) * q + c),
        }
    }

    /// 2 pi r^2 times the stresses by unit forces along x, y and z.
    pub(crate) fn unit_stresses(self, poisson: f64) -> [Stress; 3] {
        let Self { a, b, c } = self;
        let (shrink, q) = (1.0 - 2.0 * poisson, 1.0 / (1.0 + c));
        let inner = shrink * q * q;
        let tangential = inner * q * (3.0 + c) - 3.0;
        let normal = inner * (2.0 + c) - 3.0 * c;
        let even = -shrink * q * (1.0 - c - c * c);
        let (aa, bb, cc, ab) = (a * a, b * b, c * c, a * b);
        let x = Stress {
            xx: a * (tangential * aa + shrink - 3.0 * inner),
            yy: a * (tangential * bb + shrink - inner),
            zz: -3.0 * a * cc,
            xy: b * (tangential * aa - inner),
            yz: -3.0 * ab * c,
            zx: -3.0 * aa * c,
        };
        let y = Stress {
            xx: b * (tangential * aa + shrink - inner),
            yy: b * (tangential * bb + shrink - 3.0 * inner),
            zz: -3.0 * b * cc,
            xy: a * (tangential * bb - inner),
            yz: -3.0 * bb * c,
            zx: -3.0 * ab * c,
        };
        let z = Stress {
            xx: normal * aa + even,
            yy: normal * bb + even,
            zz: -3.0 * c * cc,
            xy: normal * ab,
            yz: -3.0 * b * cc,
            zx: -3.0 * a * cc,
        };
        [x, y, z]
    }

    /// 2 pi r^2 times the stress (4.2), (4.3).
    pub(crate) fn stress(self, poisson: f64, force: Force) -> Stress {
        let Self { a, b, c } = self;
        let (shrink, q) = (1.0 - 2.0 * poisson, 1.0 / (1.0 + c));
        let t = a * force.x + b * force.y;
        // sigma = -3 (n . F) n n  +  (1 - 2 nu) (terms that vanish on planes z = const)
        let core = -3.0 * (t + c * force.z);
        let inner = shrink * q * q;
        let cubic = inner * q * (3.0 + c); // (3r + z)/(r + z)^3
        let radial = t * cubic + force.z * inner * (2.0 + c);
        let even = -force.z * shrink * q * (1.0 - c - c * c);
        Stress {
            xx: (core + radial) * a * a + even + t * shrink
                - inner * (3.0 * a * force.x + b * force.y),
            yy: (core + radial) * b * b + even + t * shrink
                - inner * (a * force.x + 3.0 * b * force.y),
            zz: core * c * c,
            xy: (core + radial) * a * b - inner * (b * force.x + a * force.y),
            yz: core * b * c,
            zx: core * a * c,
        }
    }
}
