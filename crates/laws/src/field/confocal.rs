//! Integrals over the confocal ellipsoids outside a point.
//!
//! With `lambda` the ellipsoidal coordinate of the point, the largest root of
//! `x^2/(a^2+l) + y^2/(b^2+l) + z^2/l = 1`, and `Delta = sqrt((a^2+s)(b^2+s)s)`.

use carom_special::RangeError;
use carom_special::elliptic::{Amplitude, incomplete};
use carom_special::quadrature::FixedRule;

use crate::ellipse::ContactEllipse;

/// Above this axis ratio, outside the larger axis, the differences would cancel and a Gauss rule is
/// exact to rounding.
const NEARLY_CIRCULAR: f64 = 0.7;

static RULE: FixedRule<24> = FixedRule::fixed();

/// Elliptic integrals from lambda to infinity.
#[derive(Debug, Clone, Copy)]
pub(super) struct Integrals {
    /// `int ds/Delta`.
    pub(super) f: f64,
    /// `int ds/((a^2+s) Delta)`.
    pub(super) a: f64,
    /// `int ds/((b^2+s) Delta)`.
    pub(super) b: f64,
    /// `int s ds/((a^2+s)^2 Delta)`.
    pub(super) aa: f64,
    /// `int s ds/((b^2+s)^2 Delta)`.
    pub(super) bb: f64,
    /// `int s ds/((a^2+s)(b^2+s) Delta)`.
    pub(super) ab: f64,
}

impl Integrals {
    pub(super) fn new(ellipse: &ContactEllipse, lambda: f64) -> Result<Self, RangeError> {
        let (a, b) = (ellipse.semi_axis_a(), ellipse.semi_axis_b());
        if a > b {
            let Self { f, a, b, aa, bb, ab } = Self::ordered(&ellipse.exchanged(), lambda)?;
            return Ok(Self { f, a: b, b: a, aa: bb, bb: aa, ab });
        }
        Self::ordered(ellipse, lambda)
    }

    /// For a <= b.
    fn ordered(ellipse: &ContactEllipse, lambda: f64) -> Result<Self, RangeError> {
        let (a, b, ratio) = (ellipse.semi_axis_a(), ellipse.semi_axis_b(), ellipse.axis_ratio());
        let root = lambda.sqrt();
        let (at_a, at_b) = (Amplitude::from_legs(a, root)?, Amplitude::from_legs(b, root)?);
        let f = 2.0 / b * incomplete::f(ratio, at_b);
        let by_a = 2.0 / (a * a * a) * incomplete::d(ratio.inverse(), at_a);
        let by_b = 2.0 / (b * b * b) * incomplete::d(ratio, at_b);
        let mut all = Self { f, a: by_a, b: by_b, aa: 0.0, bb: 0.0, ab: 0.0 };
        if ratio.get() >= NEARLY_CIRCULAR || root >= b {
            all.by_quadrature(b, ratio.get(), libm::atan2(b, root));
        } else {
            all.by_differences(a, b, lambda);
        }
        Ok(all)
    }

    /// With the substitution `s = b^2 cot^2 t` all integrands are smooth in t.
    fn by_quadrature(&mut self, b: f64, ratio: f64, end: f64) {
        let [mut aa, mut bb, mut ab] = [0.0; 3];
        for node in RULE.nodes() {
            let (sine, cosine) = libm::sincos(0.5 * end * (1.0 + node.position));
            let square = cosine * cosine + (ratio * sine) * (ratio * sine);
            let weight = node.weight * (sine * cosine) * (sine * cosine) / square.sqrt();
            bb += weight;
            ab += weight / square;
            aa += weight / (square * square);
        }
        let scale = end / (b * b * b);
        (self.aa, self.bb, self.ab) = (scale * aa, scale * bb, scale * ab);
    }

    /// By partial fractions, and the derivatives of `s (b^2+s)/((a^2+s) Delta)` and of
    /// `s^2/((b^2+s) Delta)`.
    fn by_differences(&mut self, a: f64, b: f64, lambda: f64) {
        let difference = (b - a) * (b + a);
        let (u, v) = (a * a + lambda, b * b + lambda);
        let delta_over_root = (u * v).sqrt();
        let root = lambda.sqrt();
        self.ab = (b * b * self.b - a * a * self.a) / difference;
        let end = root * v / (u * delta_over_root);
        let over_a = self.f - a * a * self.a;
        self.aa = (self.f - 2.0 * over_a + difference * self.a + 2.0 * end) / (3.0 * difference);
        let end = root * lambda / (v * delta_over_root);
        let over_b = self.f - b * b * self.b;
        self.bb = (over_b - a * a * self.ab - 2.0 * end) / (3.0 * b * b);
    }
}

/// A point of the body, with its ellipsoidal coordinate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Confocal {
    pub(super) lambda: f64,
    /// `z/sqrt(lambda)`; its limit on the surface inside the ellipse.
    pub(super) zeta: f64,
}

impl Confocal {
    pub(super) fn new(ellipse: &ContactEllipse, x: f64, y: f64, z: f64) -> Self {
        if z == 0.0 {
            let lambda = surface_coordinate(ellipse, x, y);
            let rest = if lambda > 0.0 { 0.0 } else { 1.0 - ellipse.radius_squared(x, y) };
            return Self { lambda, zeta: rest.max(0.0).sqrt() };
        }
        let lambda = coordinate(ellipse, x, y, z);
        Self { lambda, zeta: z / lambda.sqrt() }
    }
}

/// The ellipsoidal coordinate at a positive depth.
fn coordinate(ellipse: &ContactEllipse, x: f64, y: f64, z: f64) -> f64 {
    let [a2, b2] = [ellipse.semi_axis_a(), ellipse.semi_axis_b()].map(|axis| axis * axis);
    let (x2, y2, z2) = (x * x, y * y, z * z);
    // Lower bounds of the root: the largest root of circles, and those with x or y alone.
    let mut lambda =
        two_terms(x2 + y2, a2.max(b2), z2).max(two_terms(x2, a2, z2)).max(two_terms(y2, b2, z2));
    lambda = lambda.max(next_to_the_surface(ellipse, x, y, z2));
    // The sum is decreasing and convex: Newton steps from below stay below the root.
    for _ in 0..100 {
        let (u, v) = (a2 + lambda, b2 + lambda);
        let excess = x2 / u + y2 / v + z2 / lambda - 1.0;
        let slope = x2 / (u * u) + y2 / (v * v) + z2 / (lambda * lambda);
        let step = excess / slope;
        lambda += step;
        if step <= 2e-16 * lambda {
            break;
        }
    }
    lambda
}

/// A lower bound of the positive root, from expanding `x^2/(a^2+l)` and `y^2/(b^2+l)` to first
/// order in l. It is close to the root at the smallest depths, also near the edge, where Newton's
/// method would not converge in a reasonable number of steps.
fn next_to_the_surface(ellipse: &ContactEllipse, x: f64, y: f64, z2: f64) -> f64 {
    let (a, b) = (ellipse.semi_axis_a(), ellipse.semi_axis_b());
    let inside = 1.0 - ellipse.radius_squared(x, y);
    let slope = x / a * (x / a) / (a * a) + y / b * (y / b) / (b * b);
    let root = libm::hypot(inside, 2.0 * (slope * z2).sqrt());
    if inside > 0.0 { 2.0 * z2 / (inside + root) } else { 0.5 * (root - inside) / slope }
}

/// The positive root of `r2/(a2 + l) + z2/l = 1`.
fn two_terms(r2: f64, a2: f64, z2: f64) -> f64 {
    let middle = 0.5 * (r2 + z2 - a2);
    let root = libm::hypot(middle, (a2 * z2).sqrt());
    if middle >= 0.0 { middle + root } else { a2 * z2 / (root - middle) }
}

/// The positive root of `x^2/(a^2+l) + y^2/(b^2+l) = 1`; zero inside the ellipse.
pub(super) fn surface_coordinate(ellipse: &ContactEllipse, x: f64, y: f64) -> f64 {
    if ellipse.contains(x, y) {
        return 0.0;
    }
    let [a2, b2] = [ellipse.semi_axis_a(), ellipse.semi_axis_b()].map(|axis| axis * axis);
    let (x2, y2) = (x * x, y * y);
    // l^2 + (a^2 + b^2 - x^2 - y^2) l - (x^2 b^2 + y^2 a^2 - a^2 b^2) = 0
    let middle = 0.5 * (x2 + y2 - a2 - b2);
    let product = a2 * b2 * (ellipse.radius_squared(x, y) - 1.0);
    let root = (middle * middle + product).sqrt();
    (if middle >= 0.0 { middle + root } else { product / (root - middle) }).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use carom_special::quadrature::{Abscissa, Tolerance, tanh_sinh};

    #[test]
    fn integrals_are_those_of_their_definitions() {
        for (a, b) in [(1.0, 1.0), (0.71, 1.0), (0.69, 1.0), (0.05, 1.0), (3.0, 1.0), (1.0, 0.9)] {
            let ellipse = ContactEllipse::new(a, b).unwrap();
            for lambda in [0.0, 1e-6, 0.3, 0.9, 1.1, 40.0] {
                let got = Integrals::new(&ellipse, lambda).unwrap();
                // By r = sqrt(s) = sqrt(lambda) + (1 - t)/t; all is multiplied by t^2.
                let by = |m: i32, n: i32, p: i32| {
                    let value = |t: Abscissa| {
                        let t = t.position;
                        let s = (lambda.sqrt() * t + 1.0 - t).powi(2);
                        let (u, v) = ((a * t).powi(2) + s, (b * t).powi(2) + s);
                        2.0 * s.powi(p) * t.powi(2 * (m + n - p))
                            / ((u * v).sqrt() * u.powi(m) * v.powi(n))
                    };
                    let relative = Tolerance::relative(1e-13).unwrap();
                    tanh_sinh(0.0, 1.0, relative, value).unwrap().value
                };
                let close =
                    |got: f64, want: f64| assert_relative_eq!(got, want, max_relative = 3e-13);
                close(got.f, by(0, 0, 0));
                close(got.a, by(1, 0, 0));
                close(got.b, by(0, 1, 0));
                close(got.aa, by(2, 0, 1));
                close(got.bb, by(0, 2, 1));
                close(got.ab, by(1, 1, 1));
            }
        }
    }
}
