//! Integrals of the surface influence functions over a rectangle (4.29), at any offset.
//!
//! Three regions are treated differently. Near the cell the closed form is used, with the
//! differences along its edges taken analytically. Where one coordinate is several half-widths
//! away, the closed form along the other axis is combined with a Gauss rule across it. Where both
//! are, a tensor Gauss rule is used, of the lowest order that is accurate to rounding. The plain
//! closed form would lose eight digits at a distance of 2000 cells.

use carom_special::RangeError;
use carom_special::quadrature::Node;

use crate::difference::Interval;
use crate::gauss;

/// The vector from the receiving point to the centre of the loaded rectangle, x' - x.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Offset {
    /// Source minus receiver along x.
    pub x: f64,
    /// Source minus receiver along y.
    pub y: f64,
}

/// A loaded rectangle with sides along x and y.
///
/// ```
/// use carom_halfspace::{Offset, Rectangle};
/// let square = Rectangle::new(2.0, 2.0)?;
/// // Table 13.1, k = 0: the integral of 1/r over a square of half side 1.
/// let own = square.integrals(Offset::default())?;
/// assert!((own.inverse_distance - 8.0 * 1f64.asinh()).abs() < 1e-14);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    width_x: f64,
    width_y: f64,
    /// Half-widths in units of `scale`, a power of two near the larger of them.
    half_x: f64,
    half_y: f64,
    scale: f64,
}

/// The integrals of (4.29) over a rectangle, in units of length.
///
/// r is the distance of the receiving point, X = x' - x and Y = y' - y point from it to the
/// source: `xx` even in both, `xy` odd in both, `log_x` odd in X, `log_y` odd in Y (4.23).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RectangleIntegrals {
    /// Integral of 1/r, the sum of `xx` and `yy`.
    pub inverse_distance: f64,
    /// Integral of d2r/dx2 = Y^2/r^3.
    pub xx: f64,
    /// Integral of d2r/dy2 = X^2/r^3.
    pub yy: f64,
    /// Integral of d2r/dxdy = -X Y/r^3.
    pub xy: f64,
    /// Minus the integral of d(ln r)/dx: of X/r^2.
    pub log_x: f64,
    /// Minus the integral of d(ln r)/dy: of Y/r^2.
    pub log_y: f64,
}

/// Offset relative to the larger width from which the cell acts as a point load, to rounding.
const POINT_LIKE: f64 = 1e9;

impl Rectangle {
    /// A rectangle of full widths `width_x` by `width_y`.
    ///
    /// # Errors
    /// [`RangeError`] unless both widths are finite and positive.
    pub fn new(width_x: f64, width_y: f64) -> Result<Self, RangeError> {
        RangeError::positive("width_x", width_x)?;
        RangeError::positive("width_y", width_y)?;
        let exponent = libm::frexp(width_x.max(width_y)).1.clamp(-1000, 1000);
        let scale = libm::ldexp(0.5, exponent);
        let half = |width: f64| (0.5 * width / scale).max(f64::MIN_POSITIVE);
        Ok(Self { width_x, width_y, half_x: half(width_x), half_y: half(width_y), scale })
    }

    /// Full width along x.
    #[must_use]
    pub const fn width_x(&self) -> f64 {
        self.width_x
    }

    /// Full width along y.
    #[must_use]
    pub const fn width_y(&self) -> f64 {
        self.width_y
    }

    /// The area.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.width_x * self.width_y
    }

    /// The integrals (4.29), which are those of (4.24), (4.26) and (11.3), for a receiving point at
    /// `-offset` from the rectangle's centre.
    ///
    /// The error is about 1e-15 of [`RectangleIntegrals::inverse_distance`] for any aspect ratio
    /// and any offset, including points on the edge and at the corners.
    ///
    /// # Errors
    /// [`RangeError`] unless the offset is finite.
    pub fn integrals(&self, offset: Offset) -> Result<RectangleIntegrals, RangeError> {
        RangeError::finite("offset x", offset.x)?;
        RangeError::finite("offset y", offset.y)?;
        Ok(self.trusted_integrals(offset))
    }

    /// [`Rectangle::integrals`] of an offset known to be finite.
    pub(crate) fn trusted_integrals(&self, offset: Offset) -> RectangleIntegrals {
        let positive = self.in_first_quadrant(offset.x.abs(), offset.y.abs());
        let (sign_x, sign_y) = (sign(offset.x), sign(offset.y));
        RectangleIntegrals {
            xy: sign_x * sign_y * positive.xy,
            log_x: sign_x * positive.log_x,
            log_y: sign_y * positive.log_y,
            ..positive
        }
    }

    fn in_first_quadrant(&self, x: f64, y: f64) -> RectangleIntegrals {
        if x.max(y) > POINT_LIKE * self.width_x.max(self.width_y) {
            return self.as_point(x, y);
        }
        let (ix, iy) = self.intervals(x, y);
        let value = if let Some([rule_x, rule_y]) = self.far_rules(x, y) {
            tensor(ix, rule_x, iy, rule_y)
        } else if iy.centre >= gauss::NEAREST * iy.half {
            strip(ix, iy, gauss::rule(iy.centre / iy.half))
        } else if ix.centre >= gauss::NEAREST * ix.half {
            strip(iy, ix, gauss::rule(ix.centre / ix.half)).transposed()
        } else {
            closed_form(ix, iy)
        };
        value.scaled(self.scale)
    }

    /// The sides of the rectangle as seen from the receiving point, over `scale`.
    fn intervals(&self, x: f64, y: f64) -> (Interval, Interval) {
        let (x, y) = (x / self.scale, y / self.scale);
        (Interval { centre: x, half: self.half_x }, Interval { centre: y, half: self.half_y })
    }

    /// Gauss rules along both sides, where the point is far enough for them.
    fn far_rules(&self, x: f64, y: f64) -> Option<[&'static [Node]; 2]> {
        let (Interval { centre: x, half: hx }, Interval { centre: y, half: hy }) =
            self.intervals(x, y);
        // Distance to the nearest singularity of each rule, in half-widths.
        let gap_x = (x - hx).max(0.0);
        let gap_y = (y - hy).max(0.0);
        let along_x = (x * x + gap_y * gap_y).sqrt() / hx;
        let along_y = (y * y + gap_x * gap_x).sqrt() / hy;
        let far = along_x >= gauss::NEAREST && along_y >= gauss::NEAREST;
        far.then(|| [along_x, along_y].map(gauss::rule))
    }

    /// The integrands at the centre times the area.
    fn as_point(&self, x: f64, y: f64) -> RectangleIntegrals {
        let r = libm::hypot(x, y);
        let (a, b) = (x / r, y / r);
        let value = self.width_x / r * self.width_y;
        RectangleIntegrals {
            inverse_distance: value,
            xx: value * b * b,
            yy: value * a * a,
            xy: -value * a * b,
            log_x: value * a,
            log_y: value * b,
        }
    }
}

/// The sign of an offset; 0 at 0, where an odd integral vanishes exactly.
fn sign(offset: f64) -> f64 {
    if offset == 0.0 { 0.0 } else { 1f64.copysign(offset) }
}

impl RectangleIntegrals {
    /// The same with x and y exchanged.
    fn transposed(self) -> Self {
        Self { xx: self.yy, yy: self.xx, log_x: self.log_y, log_y: self.log_x, ..self }
    }

    fn scaled(self, factor: f64) -> Self {
        Self {
            inverse_distance: self.inverse_distance * factor,
            xx: self.xx * factor,
            yy: self.yy * factor,
            xy: self.xy * factor,
            log_x: self.log_x * factor,
            log_y: self.log_y * factor,
        }
    }
}

fn tensor(x: Interval, rule_x: &[Node], y: Interval, rule_y: &[Node]) -> RectangleIntegrals {
    let mut sum = RectangleIntegrals::default();
    for ny in rule_y {
        let py = y.centre + y.half * ny.position;
        for nx in rule_x {
            let px = x.centre + x.half * nx.position;
            let inverse_square = 1.0 / (px * px + py * py);
            let weight = nx.weight * ny.weight;
            let inverse = weight * inverse_square.sqrt();
            let cube = inverse * inverse_square;
            let square = weight * inverse_square;
            sum.inverse_distance += inverse;
            sum.xx += cube * py * py;
            sum.yy += cube * px * px;
            sum.xy -= cube * px * py;
            sum.log_x += square * px;
            sum.log_y += square * py;
        }
    }
    sum.scaled(x.half * y.half)
}

/// Closed form along x, Gauss rule across, for a cell that is far in y.
fn strip(x: Interval, y: Interval, rule: &[Node]) -> RectangleIntegrals {
    let mut sum = RectangleIntegrals::default();
    for node in rule {
        let c = y.centre + y.half * node.position;
        let inverse = x.inverse_distance(c);
        let cube = x.inverse_cube(c);
        sum.inverse_distance += node.weight * inverse;
        sum.xx += node.weight * cube;
        sum.yy += node.weight * (inverse - cube);
        sum.xy -= node.weight * c * x.first_moment_cube(c);
        sum.log_x += node.weight * x.log_distance(c);
        sum.log_y += node.weight * x.angle(c);
    }
    sum.scaled(y.half)
}

/// (4.29), each difference along an edge by [`Interval`].
fn closed_form(x: Interval, y: Interval) -> RectangleIntegrals {
    let (a1, a2, b1, b2) = (x.upper(), x.lower(), y.upper(), y.lower());
    let xx = edge(a1, y) - edge(a2, y);
    let yy = edge(b1, x) - edge(b2, x);
    RectangleIntegrals {
        inverse_distance: xx + yy,
        xx,
        yy,
        xy: mixed(x, y),
        log_x: log_edge(b1, x) - log_edge(b2, x) + angle_edge(a1, y) - angle_edge(a2, y),
        log_y: log_edge(a1, y) - log_edge(a2, y) + angle_edge(b1, x) - angle_edge(b2, x),
    }
}

/// c times the integral of 1/r along an edge at distance c; 0 for c = 0, its limit.
fn edge(c: f64, along: Interval) -> f64 {
    if c == 0.0 { 0.0 } else { c * along.inverse_distance(c.abs()) }
}

fn log_edge(c: f64, along: Interval) -> f64 {
    if c == 0.0 { 0.0 } else { c * along.log_distance(c) }
}

fn angle_edge(c: f64, along: Interval) -> f64 {
    c.abs() * along.angle(c.abs())
}

/// The double difference of r over the corners, rationalised twice.
fn mixed(x: Interval, y: Interval) -> f64 {
    let r = |a: f64, b: f64| (a * a + b * b).sqrt();
    let (a1, a2, b1, b2) = (x.upper(), x.lower(), y.upper(), y.lower());
    let (r11, r12, r21, r22) = (r(a1, b1), r(a1, b2), r(a2, b1), r(a2, b2));
    let spread = 1.0 / (r11 + r21) + 1.0 / (r12 + r22);
    -16.0 * x.centre * y.centre * x.half * y.half * spread / ((r11 + r12) * (r21 + r22))
}
