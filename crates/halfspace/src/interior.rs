//! Displacement and stress inside a body under a rectangle of constant traction.
//!
//! Love (1929) for the pressure, Kalker (1986) for tangential tractions. All quantities are
//! derivatives of the potentials of (4.4a) integrated over the rectangle: with r the distance to
//! the loaded point, V of 1/r, chi of ln(z + r) and L of z ln(z + r) - r, where L_zz = chi_z = V
//! and all three are harmonic. Far from the rectangle, where the closed forms cancel, the point
//! load is integrated by a Gauss rule accurate to rounding.

use std::f64::consts::PI;

use carom_special::RangeError;
use carom_special::quadrature::Node;

use crate::difference::Interval;
use crate::gauss;
use crate::point_load::Direction;
use crate::{Displacement, Force, Material, Point, Rectangle, Stress, Traction};

/// A rectangle of constant traction on the surface of one elastic half-space.
///
/// Points are relative to the centre of the rectangle. For body 2 of a pair z points into body 2
/// and the tangential tractions change sign.
///
/// ```
/// use carom_halfspace::{LoadedRectangle, Material, Point, Rectangle, Traction};
/// let body = Material::from_young(208e3, 0.3)?;
/// let square = LoadedRectangle::new(body, Rectangle::new(2.0, 2.0)?)?;
/// let load = Traction { normal: 1.0, ..Traction::default() };
/// // Just below the surface the normal stress equals the pressure, with sigma_xx = -(1 + 2 nu)/2.
/// let stress = square.stress(load, Point::default())?;
/// assert!((stress.zz + 1.0).abs() < 1e-15);
/// assert!((stress.xx + 0.8).abs() < 1e-15);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadedRectangle {
    shear_modulus: f64,
    poisson: f64,
    rectangle: Rectangle,
}

impl LoadedRectangle {
    /// The rectangle on a body of `material`.
    ///
    /// # Errors
    /// [`RangeError`] if the body is rigid: its stress is undefined.
    pub fn new(material: Material, rectangle: Rectangle) -> Result<Self, RangeError> {
        let shear_modulus = RangeError::positive("shear_modulus", material.shear_modulus())?;
        Ok(Self { shear_modulus, poisson: material.poisson(), rectangle })
    }

    /// The displacement at a point of the body, including its surface.
    ///
    /// # Errors
    /// [`RangeError`] for a point outside the half-space and for a load that is not finite.
    pub fn displacement(&self, load: Traction, at: Point) -> Result<Displacement, RangeError> {
        let load = load.checked()?;
        let [x, y, normal] = self.unit_displacements(at.checked()?);
        let sum = times(x, load.x) + times(y, load.y) + times(normal, load.normal);
        sum.finite_at("z", at.z)
    }

    /// The stress at a point of the body; on the surface the limit from inside.
    ///
    /// On the surface, at the edges of the rectangle, the stress due to the pressure jumps; there
    /// the mean of both sides is returned.
    ///
    /// # Errors
    /// [`RangeError`] for a point outside the half-space, for a load that is not finite, and for
    /// points at which the stress is infinite: on the surface at the edges under tangential load,
    /// and at the corners.
    pub fn stress(&self, load: Traction, at: Point) -> Result<Stress, RangeError> {
        let load = load.checked()?;
        let [x, y, normal] = self.unit_stresses(at.checked()?);
        let part = |stress: Stress, load: f64| {
            if load == 0.0 { Stress::default() } else { stress * load }
        };
        let sum = part(x, load.x) + part(y, load.y) + part(normal, load.normal);
        sum.finite_at("z", at.z)
    }

    /// The stresses due to unit tractions along x, along y, and to unit pressure.
    pub(crate) fn unit_stresses(&self, at: Point) -> [Stress; 3] {
        let mut sum = [Stress::default(); 3];
        let nu = self.poisson;
        pieces(self.rectangle, at, &mut |piece, z| match piece {
            Piece::Near(x, y) => {
                let derivatives = Derivatives::new(x, y, z);
                let one = derivatives.tangential_stress(nu);
                let two = Derivatives::new(y, x, z).tangential_stress(nu);
                let two = Stress { xx: two.yy, yy: two.xx, yz: two.zx, zx: two.yz, ..two };
                add(&mut sum, [one, two, derivatives.normal_stress(nu)], 1.0 / (2.0 * PI));
            }
            Piece::Node { x, y, weight } => {
                let (inverse, direction) = direction(x, y, z);
                let scale = weight * inverse * inverse / (2.0 * PI);
                add(&mut sum, direction.unit_stresses(nu), scale);
            }
        });
        sum
    }

    /// The displacements due to unit tractions along x, along y, and to unit pressure.
    fn unit_displacements(&self, at: Point) -> [Displacement; 3] {
        let mut sum = [Displacement::default(); 3];
        let nu = self.poisson;
        let length = unit_length(self.rectangle) / (4.0 * PI * self.shear_modulus);
        pieces(self.rectangle, at, &mut |piece, z| match piece {
            Piece::Near(x, y) => {
                let derivatives = Derivatives::new(x, y, z);
                let one = derivatives.tangential_displacement(nu);
                let two = Derivatives::new(y, x, z).tangential_displacement(nu);
                let two = Displacement { u: two.v, v: two.u, w: two.w };
                add(&mut sum, [one, two, derivatives.normal_displacement(nu)], length);
            }
            Piece::Node { x, y, weight } => {
                let (inverse, direction) = direction(x, y, z);
                let displacement = |force| direction.displacement(nu, force);
                add(&mut sum, UNIT_FORCES.map(displacement), weight * inverse * length);
            }
        });
        sum
    }
}

const UNIT_FORCES: [Force; 3] = [
    Force { x: 1.0, y: 0.0, z: 0.0 },
    Force { x: 0.0, y: 1.0, z: 0.0 },
    Force { x: 0.0, y: 0.0, z: 1.0 },
];

fn times(displacement: Displacement, load: f64) -> Displacement {
    if load == 0.0 { Displacement::default() } else { displacement * load }
}

fn add<T>(sum: &mut [T; 3], parts: [T; 3], scale: f64)
where
    T: Copy + std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>,
{
    for (sum, part) in sum.iter_mut().zip(parts) {
        *sum = *sum + part * scale;
    }
}

/// Inverse distance and direction from a loaded point to the receiver.
fn direction(x: f64, y: f64, z: f64) -> (f64, Direction) {
    let inverse = 1.0 / (x * x + y * y + z * z).sqrt();
    (inverse, Direction { a: x * inverse, b: y * inverse, c: z * inverse })
}

/// The unit of length of the pieces: a power of two near the larger width.
fn unit_length(rectangle: Rectangle) -> f64 {
    let largest = rectangle.width_x().max(rectangle.width_y());
    libm::ldexp(0.5, libm::frexp(largest).1.clamp(-1000, 1000))
}

/// A part of the rectangle; coordinates are receiver minus source in units of length.
enum Piece {
    /// Close enough for the closed form to be accurate.
    Near(Interval, Interval),
    /// A node of a Gauss rule over a part that is far enough away.
    Node { x: f64, y: f64, weight: f64 },
}

/// Distance in widths from which the rectangle acts as a point load, to rounding.
const POINT_LIKE: f64 = 1e9;

/// Calls `use_piece(piece, z)` for each piece of the rectangle, which is divided if it is slender
/// compared with its distance.
fn pieces(rectangle: Rectangle, at: Point, use_piece: &mut impl FnMut(Piece, f64)) {
    let unit = unit_length(rectangle);
    let half = |width: f64| (0.5 * width / unit).max(f64::MIN_POSITIVE);
    // Farther away squares would overflow; stress and displacement vanish there.
    let far = |value: f64| (value / unit).clamp(-1e100, 1e100);
    let x = Interval { centre: far(at.x), half: half(rectangle.width_x()) };
    let y = Interval { centre: far(at.y), half: half(rectangle.width_y()) };
    let z = far(at.z);
    if x.centre.abs().max(y.centre.abs()).max(z) > POINT_LIKE {
        let weight = 4.0 * x.half * y.half;
        use_piece(Piece::Node { x: x.centre, y: y.centre, weight }, z);
    } else {
        cut(x, y, z, use_piece);
    }
}

fn cut(x: Interval, y: Interval, z: f64, use_piece: &mut impl FnMut(Piece, f64)) {
    let gap = |side: Interval| (side.centre.abs() - side.half).max(0.0);
    let (gap_x, gap_y) = (gap(x), gap(y));
    // Distance of the nearest singularity from the centre of each rule, in half-widths.
    let along_x = (x.centre * x.centre + gap_y * gap_y + z * z).sqrt() / x.half;
    let along_y = (y.centre * y.centre + gap_x * gap_x + z * z).sqrt() / y.half;
    match (along_x >= gauss::NEAREST, along_y >= gauss::NEAREST) {
        (true, true) => nodes(x, gauss::rule(along_x), y, gauss::rule(along_y), z, use_piece),
        (true, false) => halves(y).into_iter().for_each(|part| cut(x, part, z, use_piece)),
        (false, true) => halves(x).into_iter().for_each(|part| cut(part, y, z, use_piece)),
        (false, false) => use_piece(Piece::Near(x, y), z),
    }
}

fn halves(side: Interval) -> [Interval; 2] {
    let half = 0.5 * side.half;
    [side.centre - half, side.centre + half].map(|centre| Interval { centre, half })
}

fn nodes(
    x: Interval,
    rule_x: &[Node],
    y: Interval,
    rule_y: &[Node],
    z: f64,
    use_piece: &mut impl FnMut(Piece, f64),
) {
    for ny in rule_y {
        for nx in rule_x {
            let weight = nx.weight * ny.weight * x.half * y.half;
            let (x, y) = (x.centre + x.half * nx.position, y.centre + y.half * ny.position);
            use_piece(Piece::Node { x, y, weight }, z);
        }
    }
}

/// Derivatives of the potentials integrated over the rectangle; subscripts as in `v_xz`.
struct Derivatives {
    z: f64,
    v: f64,
    v_x: f64,
    v_y: f64,
    v_z: f64,
    /// z times the second derivatives of V; these products are bounded where the derivatives are
    /// not.
    zv_xx: f64,
    zv_yy: f64,
    zv_xy: f64,
    zv_xz: f64,
    zv_yz: f64,
    chi_x: f64,
    chi_y: f64,
    chi_xx: f64,
    chi_yy: f64,
    chi_xy: f64,
    /// z times the third derivatives of chi.
    zchi_xxy: f64,
    zchi_xyy: f64,
    l_xx: f64,
    l_xy: f64,
    l_xxy: f64,
    l_xyy: f64,
}

impl Derivatives {
    fn new(x: Interval, y: Interval, z: f64) -> Self {
        let corner = |f: &dyn Fn(f64, f64, f64) -> f64| {
            let at = |a: f64, b: f64| f(a, b, (a * a + b * b + z * z).sqrt());
            let upper = at(x.upper(), y.upper()) - at(x.lower(), y.upper());
            upper - (at(x.upper(), y.lower()) - at(x.lower(), y.lower()))
        };
        // Differences between the ends of x (y) of functions integrated along y (x).
        let over_x = |f: &dyn Fn(f64) -> f64| f(x.upper()) - f(x.lower());
        let over_y = |f: &dyn Fn(f64) -> f64| f(y.upper()) - f(y.lower());
        let distance = |a: f64| (a * a + z * z).sqrt();

        let v_x = over_x(&|a| y.inverse_distance(distance(a)));
        let v_y = over_y(&|b| x.inverse_distance(distance(b)));
        let a_v_x = over_x(&|a| zero_or(a, || y.inverse_distance(distance(a))));
        let b_v_y = over_y(&|b| zero_or(b, || x.inverse_distance(distance(b))));
        let chi_xx = corner(&|a, b, r| view(a, b, a * a + z * z + z * r));
        let chi_yy = corner(&|a, b, r| view(a, b, b * b + z * z + z * r));
        let chi_xy = corner(&|_, _, r| libm::log(z + r));
        let a_chi_xx = corner(&|a, b, r| a * view(a, b, a * a + z * z + z * r));
        let b_chi_yy = corner(&|a, b, r| b * view(a, b, b * b + z * z + z * r));
        let b_log = corner(&|_, b, r| zero_or(b, || libm::log(z + r)));
        let a_log = corner(&|a, _, r| zero_or(a, || libm::log(z + r)));
        let l_xx = z * chi_xx - a_v_x;
        // z times a derivative; zero on the surface.
        let times_z = |f: &dyn Fn() -> f64| if z == 0.0 { 0.0 } else { z * f() };
        Self {
            z,
            v: a_v_x + b_v_y - z * (chi_xx + chi_yy),
            v_x,
            v_y,
            v_z: -corner(&|a, b, r| view(a, b, z * r)),
            zv_xx: -times_z(&|| over_x(&|a| a / (a * a + z * z) * y.inverse_cube(distance(a)))),
            zv_yy: -times_z(&|| over_y(&|b| b / (b * b + z * z) * x.inverse_cube(distance(b)))),
            zv_xy: times_z(&|| corner(&|_, _, r| 1.0 / r)),
            zv_xz: -times_z(&|| over_x(&|a| z / (a * a + z * z) * y.inverse_cube(distance(a)))),
            zv_yz: -times_z(&|| over_y(&|b| z / (b * b + z * z) * x.inverse_cube(distance(b)))),
            chi_x: b_log + times_z(&|| v_x) + a_chi_xx,
            chi_y: a_log + times_z(&|| v_y) + b_chi_yy,
            chi_xx,
            chi_yy,
            chi_xy,
            zchi_xxy: times_z(&|| corner(&|a, _, r| a / (r * (r + z)))),
            zchi_xyy: times_z(&|| corner(&|_, b, r| b / (r * (r + z)))),
            l_xx,
            l_xy: times_z(&|| chi_xy) - corner(&|_, _, r| r),
            l_xxy: -corner(&|a, _, r| zero_or(a, || 1.0 / (r + z))),
            l_xyy: -corner(&|_, b, r| zero_or(b, || 1.0 / (r + z))),
        }
    }

    /// 4 pi G times the displacement due to unit pressure, (4.4b).
    fn normal_displacement(&self, nu: f64) -> Displacement {
        let shrink = 1.0 - 2.0 * nu;
        let z_times = |value: f64| if self.z == 0.0 { 0.0 } else { self.z * value };
        Displacement {
            u: -shrink * self.chi_x - z_times(self.v_x),
            v: -shrink * self.chi_y - z_times(self.v_y),
            w: 2.0 * (1.0 - nu) * self.v - self.z * self.v_z,
        }
    }

    /// 4 pi G times the displacement due to unit traction along x, (4.4b) corrected.
    fn tangential_displacement(&self, nu: f64) -> Displacement {
        let z_times = |value: f64| if self.z == 0.0 { 0.0 } else { self.z * value };
        Displacement {
            u: 2.0 * (self.v + nu * self.l_xx) - self.z * self.chi_xx,
            v: 2.0 * nu * self.l_xy - z_times(self.chi_xy),
            w: (1.0 - 2.0 * nu) * self.chi_x - z_times(self.v_x),
        }
    }

    /// 2 pi times the stress due to unit pressure.
    fn normal_stress(&self, nu: f64) -> Stress {
        let shrink = 1.0 - 2.0 * nu;
        let coupled = |chi: f64| if shrink == 0.0 { 0.0 } else { shrink * chi };
        Stress {
            xx: 2.0 * nu * self.v_z - self.zv_xx - coupled(self.chi_xx),
            yy: 2.0 * nu * self.v_z - self.zv_yy - coupled(self.chi_yy),
            zz: self.v_z + self.zv_xx + self.zv_yy,
            xy: -self.zv_xy - coupled(self.chi_xy),
            yz: -self.zv_yz,
            zx: -self.zv_xz,
        }
    }

    /// 2 pi times the stress due to unit traction along x, from Hooke's law and (4.4b).
    fn tangential_stress(&self, nu: f64) -> Stress {
        // chi and L are harmonic: L_xxx = -L_xyy - V_x, chi_xxx = -chi_xyy - V_xz.
        Stress {
            xx: 2.0 * self.v_x - 2.0 * nu * self.l_xyy + self.zchi_xyy + self.zv_xz,
            yy: 2.0 * nu * (self.v_x + self.l_xyy) - self.zchi_xyy,
            zz: -self.zv_xz,
            xy: self.v_y + 2.0 * nu * self.l_xxy - self.zchi_xxy,
            yz: -self.zv_xy,
            zx: self.v_z - self.zv_xx,
        }
    }
}

/// The angle of tangent `a b / c`; at a corner on the surface the mean of its limits.
fn view(a: f64, b: f64, c: f64) -> f64 {
    libm::atan2(a * b, c)
}

/// `factor * value`, with the limit 0 where the factor vanishes.
fn zero_or(factor: f64, value: impl Fn() -> f64) -> f64 {
    if factor == 0.0 { 0.0 } else { factor * value() }
}
