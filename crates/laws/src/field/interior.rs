//! Displacements and stresses inside a body under a semi-ellipsoidal traction on an ellipse.

use std::f64::consts::PI;

use carom_halfspace::{Displacement, Material, Point, Stress, Traction};
use carom_special::RangeError;

use super::potentials::{Potentials, Third};
use crate::ellipse::ContactEllipse;

/// A body under semi-ellipsoidal tractions on an ellipse, proportional to `sqrt(1 - x^2/a^2 -
/// y^2/b^2)`: Hertz's pressure, and the tangential traction of complete sliding.
///
/// All results are in closed form, in elliptic integrals of the ellipsoidal coordinate and
/// elementary functions. Either semi-axis may be the larger one. For body 2 of a pair z points into
/// body 2 and the tangential traction changes sign.
///
/// ```
/// use carom_halfspace::{Material, Point, Traction};
/// use carom_laws::ellipse::ContactEllipse;
/// use carom_laws::field::EllipsoidalLoad;
/// let steel = Material::from_young(208e3, 0.3)?;
/// let load = EllipsoidalLoad::new(ContactEllipse::new(1.0, 2.5)?, steel)?;
/// let pressure = Traction { normal: 1.0, ..Traction::default() };
/// let stress = load.stress(pressure, Point { x: 0.0, y: 0.0, z: 0.665 })?;
/// assert!((stress.maximum_shear() - 0.325).abs() < 1e-3); // of the greatest pressure
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipsoidalLoad {
    ellipse: ContactEllipse,
    shear_modulus: f64,
    poisson: f64,
}

impl EllipsoidalLoad {
    /// The loaded ellipse on a body of this material.
    ///
    /// # Errors
    /// [`RangeError`] for a rigid body, whose stresses are undetermined.
    pub fn new(ellipse: ContactEllipse, body: Material) -> Result<Self, RangeError> {
        let shear_modulus = RangeError::positive("shear_modulus", body.shear_modulus())?;
        Ok(Self { ellipse, shear_modulus, poisson: body.poisson() })
    }

    /// The stress at a point of the body. `peak` is the traction at the centre of the ellipse; on
    /// the surface the limit from inside is returned.
    ///
    /// # Errors
    /// [`RangeError`] for a point outside the half-space, and for arguments that are not finite.
    pub fn stress(&self, peak: Traction, at: Point) -> Result<Stress, RangeError> {
        let p = self.potentials(peak, at)?;
        let nu = self.poisson;
        let one = tangential_stress(&p, nu);
        let two = tangential_stress(&p.exchanged(), nu);
        let two = Stress { xx: two.yy, yy: two.xx, yz: two.zx, zx: two.yz, ..two };
        let sum = one * peak.x + two * peak.y + normal_stress(&p, nu) * peak.normal;
        let all = [sum.xx, sum.yy, sum.zz, sum.xy, sum.yz, sum.zx];
        RangeError::finite("stress", all.iter().sum())?;
        Ok(sum)
    }

    /// The displacement at a point of the body, including its surface.
    ///
    /// # Errors
    /// As [`Self::stress`].
    pub fn displacement(&self, peak: Traction, at: Point) -> Result<Displacement, RangeError> {
        let p = self.potentials(peak, at)?;
        let nu = self.poisson;
        let one = tangential_displacement(&p, nu);
        let two = tangential_displacement(&p.exchanged(), nu);
        let two = Displacement { u: two.v, v: two.u, w: two.w };
        let sum = one * peak.x + two * peak.y + normal_displacement(&p, nu) * peak.normal;
        let sum = sum * (1.0 / (4.0 * PI * self.shear_modulus));
        RangeError::finite("displacement", sum.u + sum.v + sum.w)?;
        Ok(sum)
    }

    fn potentials(&self, peak: Traction, at: Point) -> Result<Potentials, RangeError> {
        RangeError::finite("x", at.x)?;
        RangeError::finite("y", at.y)?;
        RangeError::non_negative("z", at.z)?;
        RangeError::finite("traction x", peak.x)?;
        RangeError::finite("traction y", peak.y)?;
        RangeError::finite("pressure", peak.normal)?;
        Potentials::new(&self.ellipse, at.x, at.y, at.z)
    }
}

/// The stress in a body under an elliptical contact in partial slip (Cattaneo and Mindlin): Hertz's
/// pressure, and the traction of complete sliding minus that of the stick area, both
/// semi-ellipsoidal.
///
/// `peak` contains the greatest pressure and the tangential traction limit at the centre, f times
/// the pressure, in the direction of slip. `stick_radius` is a*/a, from 0 to 1.
///
/// ```
/// use carom_halfspace::{Material, Point, Traction};
/// use carom_laws::ellipse::ContactEllipse;
/// use carom_laws::field::partial_slip_stress;
/// let steel = Material::from_young(208e3, 0.3)?;
/// let ellipse = ContactEllipse::new(1.0, 2.0)?;
/// let peak = Traction { x: 0.3, y: 0.0, normal: 1.0 };
/// let stress = partial_slip_stress(ellipse, steel, peak, 0.5, Point::on_surface(0.0, 0.0))?;
/// assert!((stress.zx + 0.3 * 0.5).abs() < 1e-15); // at the centre f p (1 - a*/a)
/// # Ok::<(), carom_special::RangeError>(())
/// ```
///
/// # Errors
/// [`RangeError`] for a stick radius outside 0 to 1, and as [`EllipsoidalLoad::stress`].
pub fn partial_slip_stress(
    ellipse: ContactEllipse,
    body: Material,
    peak: Traction,
    stick_radius: f64,
    at: Point,
) -> Result<Stress, RangeError> {
    let holds = (0.0..=1.0).contains(&stick_radius);
    RangeError::check("stick_radius", stick_radius, holds, "from 0 to 1")?;
    let sliding = EllipsoidalLoad::new(ellipse, body)?.stress(peak, at)?;
    if stick_radius == 0.0 {
        return Ok(sliding);
    }
    let kept = Traction { x: -stick_radius * peak.x, y: -stick_radius * peak.y, normal: 0.0 };
    let stick = EllipsoidalLoad::new(ellipse.scaled(stick_radius)?, body)?.stress(kept, at)?;
    Ok(sliding + stick)
}

fn normal_stress(p: &Potentials, nu: f64) -> Stress {
    let sliding = 1.0 - 2.0 * nu;
    Stress {
        xx: 2.0 * nu * p.v_z - p.z_v.xx - sliding * p.x_xx,
        yy: 2.0 * nu * p.v_z - p.z_v.yy - sliding * p.x_yy,
        zz: p.v_z - p.z_v.zz,
        xy: -p.z_v.xy - sliding * p.x_xy,
        yz: -p.z_v.yz,
        zx: -p.z_v.zx,
    } * (0.5 / PI)
}

fn tangential_stress(p: &Potentials, nu: f64) -> Stress {
    Stress {
        xx: 2.0 * (1.0 + nu) * p.v_x + 2.0 * nu * p.l.xxx - p.z_x.xxx,
        yy: 2.0 * nu * (p.v_x + p.l.xyy) - p.z_x.xyy,
        zz: -p.z_v.zx,
        xy: p.v_y + 2.0 * nu * p.l.xxy - p.z_x.xxy,
        yz: -p.z_v.xy,
        zx: p.v_z - p.z_v.xx,
    } * (0.5 / PI)
}

fn normal_displacement(p: &Potentials, nu: f64) -> Displacement {
    let z = p.z;
    let sliding = 1.0 - 2.0 * nu;
    Displacement {
        u: -sliding * p.x_x - z * p.v_x,
        v: -sliding * p.x_y - z * p.v_y,
        w: 2.0 * (1.0 - nu) * p.v - z * p.v_z,
    }
}

fn tangential_displacement(p: &Potentials, nu: f64) -> Displacement {
    let z = p.z;
    Displacement {
        u: 2.0 * p.v + 2.0 * nu * p.l_xx - z * p.x_xx,
        v: 2.0 * nu * p.l_xy - z * p.x_xy,
        w: (1.0 - 2.0 * nu) * p.x_x - z * p.v_x,
    }
}

impl Potentials {
    /// The same with x and y exchanged.
    fn exchanged(&self) -> Self {
        let turned = |t: Third| Third { xxx: t.yyy, xxy: t.xyy, xyy: t.xxy, yyy: t.xxx };
        let mut p = *self;
        (p.v_x, p.v_y) = (self.v_y, self.v_x);
        (p.z_v.xx, p.z_v.yy) = (self.z_v.yy, self.z_v.xx);
        (p.z_v.zx, p.z_v.yz) = (self.z_v.yz, self.z_v.zx);
        (p.x_x, p.x_y) = (self.x_y, self.x_x);
        (p.x_xx, p.x_yy) = (self.x_yy, self.x_xx);
        (p.l_xx, p.l_yy) = (self.l_yy, self.l_xx);
        (p.z_x, p.l) = (turned(self.z_x), turned(self.l));
        p
    }
}
