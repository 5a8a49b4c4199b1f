//! The potentials of a semi-ellipsoidal traction `sqrt(1 - x^2/a^2 - y^2/b^2)` in the half-space.
//!
//! With r the distance to the loaded points: V of 1/r, X of ln(z + r), L of z ln(z + r) - r, so
//! that `L_zz = X_z = V` and all are harmonic. V is that of a focaloid,
//!
//! ```text
//! V = (pi a b/2) int_lambda^inf [1 - x^2/(a^2+s) - y^2/(b^2+s) - z^2/s] ds/Delta .
//! ```
//!
//! X and L follow by integration over z with the order exchanged: where the ellipsoidal coordinate
//! is s, the depth is `sqrt(s w)`, `w = 1 - x^2/(a^2+s) - y^2/(b^2+s)`, and
//!
//! ```text
//! X_x = pi a b x int (sqrt(s w) - z) ds/((a^2+s) Delta)
//! L_x = -(pi a b/2) x int (sqrt(s w) - z)^2 ds/((a^2+s) Delta) .
//! ```
//!
//! The roots are those of the quadratic `Q = (a^2+s)(b^2+s) - x^2 (b^2+s) - y^2 (a^2+s)`: with
//! `t = s + sqrt(Q)` the second derivatives of X are elementary, of L they are z times those of X
//! and elliptic integrals. All forms below avoid cancellation for nearly circular ellipses.

use std::f64::consts::PI;

use carom_special::RangeError;

use super::confocal::{Confocal, Integrals};
use crate::ellipse::ContactEllipse;

/// Below `NEAR` b, with the smaller semi-axis b, a depth counts as 0. Beyond `FAR` a, with the
/// larger semi-axis a, the field is taken as its far-field limit.
const NEAR: f64 = 1e-120;
const FAR: f64 = 1e30;

/// Derivatives of the potentials for a unit traction at the centre of the ellipse.
#[derive(Debug, Clone, Copy)]
pub(super) struct Potentials {
    /// The depth of the point.
    pub(super) z: f64,
    pub(super) v: f64,
    pub(super) v_x: f64,
    pub(super) v_y: f64,
    pub(super) v_z: f64,
    /// z times the second derivatives of V.
    pub(super) z_v: Second,
    pub(super) x_x: f64,
    pub(super) x_y: f64,
    pub(super) x_xx: f64,
    pub(super) x_xy: f64,
    pub(super) x_yy: f64,
    /// z times the third derivatives of X.
    pub(super) z_x: Third,
    pub(super) l_xx: f64,
    pub(super) l_xy: f64,
    pub(super) l_yy: f64,
    pub(super) l: Third,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Second {
    pub(super) xx: f64,
    pub(super) xy: f64,
    pub(super) yy: f64,
    pub(super) zx: f64,
    pub(super) yz: f64,
    pub(super) zz: f64,
}

/// Third derivatives along the surface.
#[derive(Debug, Clone, Copy)]
pub(super) struct Third {
    pub(super) xxx: f64,
    pub(super) xxy: f64,
    pub(super) xyy: f64,
    pub(super) yyy: f64,
}

impl Potentials {
    pub(super) fn new(
        ellipse: &ContactEllipse,
        x: f64,
        y: f64,
        z: f64,
    ) -> Result<Self, RangeError> {
        let (a, b) = (ellipse.semi_axis_a(), ellipse.semi_axis_b());
        // At these distances the field has reached its limit, and squares would under- or overflow.
        let far = FAR * a.max(b);
        let [x, y, z] = [x, y, z].map(|value| value.clamp(-far, far));
        let z = if z < NEAR * a.min(b) { 0.0 } else { z };
        let place = Place::new(ellipse, x, y, z)?;
        let Place { i, u, v, h, z_c, .. } = place;
        let e = Elementary::new(a, b, x, y, u, v, place.zeta * h);
        let (v_x, v_y) = (-2.0 * x * i.a, -2.0 * y * i.b);
        let x_xx = 2.0 * (e.less_x - z * i.a);
        let x_xy = -2.0 * x * y * e.ab;
        let x_yy = 2.0 * (e.less_y - z * i.b);
        let z_v = place.second_of_v();
        let z_x = place.third_of_x(&e, &z_v);
        let (over_a, over_b) = (i.f - a * a * i.a, i.f - b * b * i.b);
        let (x2, y2, z2) = (x * x, y * y, z * z);
        let unit = Self {
            z,
            v: i.f - x2 * i.a - y2 * i.b - z * z_c,
            v_x,
            v_y,
            v_z: -2.0 * z_c,
            z_v,
            x_x: 2.0 * x * (e.first_x - z * i.a),
            x_y: 2.0 * y * (e.first_y - z * i.b),
            x_xx,
            x_xy,
            x_yy,
            z_x,
            l_xx: z * x_xx - (over_a - 3.0 * x2 * i.aa - y2 * i.ab - z2 * i.a),
            l_xy: z * x_xy + 2.0 * x * y * i.ab,
            l_yy: z * x_yy - (over_b - 3.0 * y2 * i.bb - x2 * i.ab - z2 * i.b),
            l: place.third_of_l(&z_x, v_x, v_y),
        };
        Ok(unit.times(0.5 * PI * a * b))
    }
}

/// A point with its ellipsoidal coordinate and derived quantities.
struct Place {
    x: f64,
    y: f64,
    z: f64,
    i: Integrals,
    zeta: f64,
    /// sqrt(lambda), `a^2 + lambda`, `b^2 + lambda` and the root of their product.
    root: f64,
    u: f64,
    v: f64,
    h: f64,
    /// z times `int ds/(s Delta)`.
    z_c: f64,
    /// The gradient of lambda is this times `2 lambda x/(a^2+l)`, and likewise for y, and `2 z`.
    per: f64,
}

impl Place {
    fn new(ellipse: &ContactEllipse, x: f64, y: f64, z: f64) -> Result<Self, RangeError> {
        let (a, b) = (ellipse.semi_axis_a(), ellipse.semi_axis_b());
        let Confocal { lambda, zeta } = Confocal::new(ellipse, x, y, z);
        let i = Integrals::new(ellipse, lambda)?;
        let (u, v) = (a * a + lambda, b * b + lambda);
        let h = (u * v).sqrt();
        let z_c = 2.0 * zeta / h - z * (i.a + i.b);
        // Zero on the edge only, where everything it multiplies vanishes.
        let spread = lambda * ((x / u) * (x / u) + (y / v) * (y / v)) + zeta * zeta;
        let per = if spread > 0.0 { 1.0 / spread } else { 0.0 };
        Ok(Self { x, y, z, i, zeta, root: lambda.sqrt(), u, v, h, z_c, per })
    }

    /// The derivatives of lambda with respect to x and y.
    fn gradient(&self) -> [f64; 2] {
        let scale = 2.0 * self.per * (self.root * self.root);
        [scale * (self.x / self.u), scale * (self.y / self.v)]
    }

    /// z times the second derivatives of V.
    fn second_of_v(&self) -> Second {
        let Self { x, y, z, i, zeta, u, v, h, .. } = self;
        // z over Delta times the gradient of lambda.
        let [along_x, along_y] = self.gradient().map(|slope| slope * zeta / h);
        let along_z = 2.0 * self.per * (zeta * zeta) * self.root / h;
        let xx = -2.0 * (z * i.a - x * along_x / u);
        let yy = -2.0 * (z * i.b - y * along_y / v);
        Second {
            xx,
            yy,
            zz: -xx - yy,
            xy: 2.0 * x * along_y / u,
            zx: 2.0 * x * along_z / u,
            yz: 2.0 * y * along_z / v,
        }
    }

    /// z times the third derivatives of X.
    fn third_of_x(&self, e: &Elementary, z_v: &Second) -> Third {
        let Self { x, y, z, u, v, .. } = *self;
        // z times the gradient of t = lambda + sqrt(Q), where z/sqrt(Q) = sqrt(lambda)/h.
        let half_slope = 0.5 * (u + v - x * x - y * y);
        let [lambda_x, lambda_y] = self.gradient();
        let per = self.root / self.h;
        let z_t_x = z * lambda_x + per * (half_slope * lambda_x - x * v);
        let z_t_y = z * lambda_y + per * (half_slope * lambda_y - y * u);
        let last = 2.0 / (u * v * e.width);
        let xxy = -2.0 * y * (z * e.slope_x - x * z_t_x * last);
        let xyy = -2.0 * x * (z * e.slope_y - y * z_t_y * last);
        Third { xxx: -xyy - z_v.zx, xxy, xyy, yyy: -xxy - z_v.yz }
    }

    /// The third derivatives of L.
    fn third_of_l(&self, z_x: &Third, v_x: f64, v_y: f64) -> Third {
        let Self { x, y, u, v, h, .. } = *self;
        let [end_x, end_y] = self.gradient().map(|slope| self.root * slope / (u * v * h));
        let xxy = 2.0 * y * (self.i.ab - x * end_x) + z_x.xxy;
        let xyy = 2.0 * x * (self.i.ab - y * end_y) + z_x.xyy;
        Third { xxx: -xyy - v_x, xxy, xyy, yyy: -xxy - v_y }
    }
}

impl Potentials {
    fn times(self, c: f64) -> Self {
        let Self {
            v,
            v_x,
            v_y,
            v_z,
            z_v,
            x_x,
            x_y,
            x_xx,
            x_xy,
            x_yy,
            z_x,
            l_xx,
            l_xy,
            l_yy,
            l,
            ..
        } = self;
        let third =
            |t: Third| Third { xxx: c * t.xxx, xxy: c * t.xxy, xyy: c * t.xyy, yyy: c * t.yyy };
        Self {
            z: self.z,
            v: c * v,
            v_x: c * v_x,
            v_y: c * v_y,
            v_z: c * v_z,
            z_v: Second {
                xx: c * z_v.xx,
                xy: c * z_v.xy,
                yy: c * z_v.yy,
                zx: c * z_v.zx,
                yz: c * z_v.yz,
                zz: c * z_v.zz,
            },
            x_x: c * x_x,
            x_y: c * x_y,
            x_xx: c * x_xx,
            x_xy: c * x_xy,
            x_yy: c * x_yy,
            z_x: third(z_x),
            l_xx: c * l_xx,
            l_xy: c * l_xy,
            l_yy: c * l_yy,
            l: third(l),
        }
    }
}

/// The elementary integrals from lambda to infinity.
struct Elementary {
    /// `int sqrt(Q) ds/((a^2+s)^2 (b^2+s))`, and with a and b exchanged.
    first_x: f64,
    first_y: f64,
    /// `int ds/((a^2+s)(b^2+s) sqrt(Q))`.
    ab: f64,
    /// The first integral minus `x^2 int ds/((a^2+s)^2 sqrt(Q))`, and likewise.
    less_x: f64,
    less_y: f64,
    /// -1/(2 y) times the derivative of X_xy with respect to x, and -1/(2 x) times that with
    /// respect to y, at constant t.
    slope_x: f64,
    slope_y: f64,
    /// `2 t + a^2 + b^2 - x^2 - y^2`.
    width: f64,
}

impl Elementary {
    fn new(a: f64, b: f64, x: f64, y: f64, u: f64, v: f64, root: f64) -> Self {
        let difference = (b - a) * (b + a);
        let (x2, y2) = (x * x, y * y);
        let (p, r) = (u + root, v + root);
        // (a^2+s) width = p^2 + x^2 d and (b^2+s) width = r^2 - y^2 d: the sum is taken.
        let width = if difference >= 0.0 {
            (p * p + x2 * difference) / u
        } else {
            (r * r - y2 * difference) / v
        };
        // int ds/((a^2+s) sqrt(Q)) = (2/p) arc(x^2 d/p^2), and with b (2/r) arc(-y^2 d/r^2).
        let one = arc_rest(difference * x2 / (p * p), u * width / (p * p));
        let two = arc_rest(-difference * y2 / (r * r), v * width / (r * r));
        let (p3, r3) = (p * p * p, r * r * r);
        let ab = 2.0 / (p * r) + 2.0 * x2 / p3 * one + 2.0 * y2 / r3 * two;
        // In this form they would be differences divided by b^2 - a^2.
        let mixed = 2.0 * (x2 * x2 / p3 * one - y2 * y2 / r3 * two);
        let less_x = 2.0 * root * (1.0 - x2 / p) / (u * r) + mixed;
        let less_y = 2.0 * root * (1.0 - y2 / r) / (v * p) - mixed;
        let over_a = 2.0 / p * (1.0 + difference * x2 / (p * p) * one);
        let over_b = 2.0 / r * (1.0 - difference * y2 / (r * r) * two);
        Self {
            first_x: 0.5 * (less_x + over_a - y2 * ab),
            first_y: 0.5 * (less_y + over_b - x2 * ab),
            less_x,
            less_y,
            ab,
            slope_x: ab - 2.0 * x2 / p3 * (p * p / (u * width) + one),
            slope_y: ab - 2.0 * y2 / r3 * (r * r / (v * width) + two),
            width,
        }
    }
}

/// `(arctan(q)/q - 1)/q^2` as a function of `q^2` > -1 and of `1 + q^2`.
fn arc_rest(square: f64, one_more: f64) -> f64 {
    if square.abs() < 0.2 {
        let mut sum = 0.0;
        for n in (0..24).rev() {
            sum = 1.0 / f64::from(2 * n + 3) - square * sum;
        }
        return -sum;
    }
    let q = square.abs().sqrt();
    // artanh(q) = ln((1 + q)/sqrt(1 - q^2)).
    let arc = if square > 0.0 { libm::atan(q) } else { libm::log((1.0 + q) / one_more.sqrt()) };
    (arc / q - 1.0) / square
}
