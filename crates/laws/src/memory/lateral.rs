//! The tangential shift as a number (one direction) or a pair (two directions).

use std::fmt::Debug;

mod sealed {
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for [f64; 2] {}
}

/// A tangential shift: `f64` for one direction, `[f64; 2]` for two.
pub trait Lateral: sealed::Sealed + Copy + Debug + Default + PartialEq {
    /// Sum.
    #[must_use]
    fn plus(self, other: Self) -> Self;

    /// Difference.
    #[must_use]
    fn minus(self, other: Self) -> Self;

    /// Multiple.
    #[must_use]
    fn times(self, factor: f64) -> Self;

    /// Product component by component.
    #[must_use]
    fn by_component(self, other: Self) -> Self;

    /// Scalar product.
    #[must_use]
    fn dot(self, other: Self) -> f64;

    /// The components in an array; the first [`Lateral::DIMENSION`] are used.
    #[must_use]
    fn components(self) -> [f64; 2];

    /// From the components.
    #[must_use]
    fn from_components(components: [f64; 2]) -> Self;

    /// Number of directions.
    const DIMENSION: usize;

    /// Euclidean length.
    #[must_use]
    fn length(self) -> f64;

    /// Whether every component is finite.
    #[must_use]
    fn is_finite(self) -> bool;

    /// The distance from the tip at which the cone around the new point cuts a segment, if it is at
    /// most `length`.
    /// `d` is the distance (above the root of `LEAST_SQUARE`) of the new point from the segment's line at the new approach,
    /// `m` the segment's slope and `q = 1 - m.m`. The cut is measured from the tip, where no
    /// cancellation occurs.
    #[must_use]
    fn reach(d: Self, m: Self, q: f64, length: f64) -> Option<f64>;

    /// The slope of the new slip segment of length `r`: the direction of `d + m r`.
    #[must_use]
    fn slip_slope(d: Self, m: Self, r: f64) -> Self;

    /// The direction of the traction after sliding on a straight path, given by direction and
    /// length `path`, while the approach changes from `from` to `to`; `m` is the direction before.
    #[must_use]
    fn dragged(m: Self, path: Self, from: f64, to: f64) -> Self;

    /// The fraction of the straight step at which sliding begins: the last parameter in [0, 1] with
    /// `|x + t dx - base| <= zeta + t dz`.
    #[must_use]
    fn sliding_onset(offset: Self, dx: Self, zeta: f64, dz: f64) -> f64;
}

impl Lateral for f64 {
    const DIMENSION: usize = 1;

    #[inline]
    fn plus(self, other: Self) -> Self {
        self + other
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        self - other
    }

    #[inline]
    fn times(self, factor: f64) -> Self {
        self * factor
    }

    #[inline]
    fn by_component(self, other: Self) -> Self {
        self * other
    }

    #[inline]
    fn dot(self, other: Self) -> f64 {
        self * other
    }

    fn components(self) -> [f64; 2] {
        [self, 0.0]
    }

    fn from_components(components: [f64; 2]) -> Self {
        components[0]
    }

    #[inline]
    fn length(self) -> f64 {
        self.abs()
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.is_finite()
    }

    #[inline]
    fn reach(d: Self, m: Self, _q: f64, length: f64) -> Option<f64> {
        // d.d/(|d| - m d) = |d|/(1 - m sign(d))
        let closing = 1.0 - m * 1.0_f64.copysign(d);
        (d.abs() < closing * length).then(|| d.abs() / closing)
    }

    #[inline]
    fn slip_slope(d: Self, m: Self, r: f64) -> Self {
        1.0_f64.copysign(d + m * r)
    }

    #[inline]
    fn dragged(m: Self, path: Self, from: f64, _to: f64) -> Self {
        if from > 0.0 || path == 0.0 { m } else { 1.0_f64.copysign(path) }
    }

    fn sliding_onset(offset: Self, dx: Self, zeta: f64, dz: f64) -> f64 {
        // sign (offset + t dx) = zeta + t dz
        let sign = 1.0_f64.copysign(offset + dx);
        let rate = sign * dx - dz;
        if rate > 0.0 { ((zeta - sign * offset) / rate).clamp(0.0, 1.0) } else { 0.0 }
    }
}

impl Lateral for [f64; 2] {
    const DIMENSION: usize = 2;

    #[inline]
    fn plus(self, other: Self) -> Self {
        [self[0] + other[0], self[1] + other[1]]
    }

    #[inline]
    fn minus(self, other: Self) -> Self {
        [self[0] - other[0], self[1] - other[1]]
    }

    #[inline]
    fn times(self, factor: f64) -> Self {
        [self[0] * factor, self[1] * factor]
    }

    #[inline]
    fn by_component(self, other: Self) -> Self {
        [self[0] * other[0], self[1] * other[1]]
    }

    #[inline]
    fn dot(self, other: Self) -> f64 {
        self[0] * other[0] + self[1] * other[1]
    }

    fn components(self) -> [f64; 2] {
        self
    }

    fn from_components(components: [f64; 2]) -> Self {
        components
    }

    #[inline]
    fn length(self) -> f64 {
        self.dot(self).sqrt()
    }

    #[inline]
    fn is_finite(self) -> bool {
        self[0].is_finite() && self[1].is_finite()
    }

    #[inline]
    fn reach(d: Self, m: Self, q: f64, length: f64) -> Option<f64> {
        // The root r >= 0 of |d + m r| = r.
        let (along, square) = (m.dot(d), d.dot(d));
        let (numerator, denominator) = if q == 0.0 {
            (square, -2.0 * along)
        } else {
            let root = (along * along + q * square).sqrt();
            if along <= 0.0 { (square, root - along) } else { (along + root, q) }
        };
        (numerator < denominator * length).then(|| numerator / denominator)
    }

    #[inline]
    fn slip_slope(d: Self, m: Self, r: f64) -> Self {
        let arm = d.plus(m.times(r));
        let length = arm.length();
        if length > 0.0 { arm.times(1.0 / length) } else { m }
    }

    fn dragged(m: Self, path: Self, from: f64, to: f64) -> Self {
        let length = path.length();
        if length == 0.0 {
            return m;
        }
        let ahead = path.times(1.0 / length);
        let cos = m.dot(ahead);
        let sin = ahead[0] * m[1] - ahead[1] * m[0];
        if from <= 0.0 {
            return ahead;
        }
        if sin == 0.0 {
            return m;
        }
        // tan(phi/2), from the form without cancellation; the tractrix reduces it (8.56).
        let left = left_after(length / from, (to - from) / from);
        if cos <= 0.0 && sin.abs() < LEAST_SINE {
            return turned([sin, (1.0 - cos) * left], ahead);
        }
        let half = if cos > 0.0 { sin / (1.0 + cos) } else { (1.0 - cos) / sin };
        let half = half * left;
        let scale = 1.0 / (1.0 + half * half);
        let (cos, sin) = ((1.0 - half) * (1.0 + half) * scale, 2.0 * half * scale);
        [ahead[0] * cos - ahead[1] * sin, ahead[1] * cos + ahead[0] * sin]
    }

    fn sliding_onset(offset: Self, dx: Self, zeta: f64, dz: f64) -> f64 {
        cone_exit(offset, dx, zeta, dz)
    }
}

/// Below this sine of an angle near pi, the square of the tangent of its half is too large for a number.
const LEAST_SINE: f64 = 1e-150;

/// The direction at an angle from another one, by two numbers whose ratio, second to first, is the tangent of its half.
#[cold]
fn turned([near, far]: [f64; 2], ahead: [f64; 2]) -> [f64; 2] {
    let length = libm::hypot(near, far);
    let (near, far) = (near / length, far / length);
    let (cos, sin) = ((near - far) * (near + far), 2.0 * near * far);
    [ahead[0] * cos - ahead[1] * sin, ahead[1] * cos + ahead[0] * sin]
}

/// `exp(-pull ln(1 + growth)/growth)`; by series for small steps, truncated below rounding.
fn left_after(pull: f64, growth: f64) -> f64 {
    if growth == f64::INFINITY {
        return 0.0; // what slides as it grows is pulled by more than it grows: below exp(-709)
    }
    let mean = match growth.abs() <= 1e-4 {
        true => 1.0 - growth * (1.0 / 2.0 - growth * (1.0 / 3.0 - growth * (1.0 / 4.0))),
        false => libm::log1p(growth) / growth,
    };
    let p = pull * mean;
    match p <= 1e-3 {
        true => 1.0 - p * (1.0 - p * (1.0 / 2.0 - p * (1.0 / 6.0 - p * (1.0 / 24.0)))),
        false => libm::exp(-p),
    }
}

/// The parameter t >= 0 at which `|offset + t dx|` exceeds `depth + t dz`, for a point inside the
/// cone at t = 0; at most 1.
pub(crate) fn cone_exit<V: Lateral>(offset: V, dx: V, depth: f64, dz: f64) -> f64 {
    // (dx.dx - dz^2) t^2 + 2 (offset.dx - depth dz) t + (offset.offset - depth^2) = 0, in units in
    // which no fourth power underflows.
    let largest = [offset.components(), dx.components(), [depth, dz]]
        .iter()
        .flatten()
        .fold(0.0_f64, |largest, value| largest.max(value.abs()));
    if largest == 0.0 {
        return 1.0;
    }
    let unit = 1.0 / largest.max(f64::MIN_POSITIVE);
    let (offset, dx, depth, dz) = (offset.times(unit), dx.times(unit), depth * unit, dz * unit);
    let (square, excess) = (offset.length(), dx.length());
    let curve = (excess - dz) * (excess + dz);
    let slope = offset.dot(dx) - depth * dz;
    let inside = ((square - depth) * (square + depth)).min(0.0);
    // Along the cone the roots are dominated by rounding, but no path stays inside beyond the tip.
    let tip = if dz < 0.0 { (depth / -dz).max(0.0) } else { 1.0 };
    outgrown(curve, slope, inside).min(tip)
}

/// The parameter t >= 0 from which `curve t^2 + 2 slope t + inside`, not positive at t = 0, is
/// positive; at most 1.
pub(crate) fn outgrown(curve: f64, slope: f64, inside: f64) -> f64 {
    // Negative by rounding only: if the path is steeper than the cone and passes through its tip,
    // both roots coincide.
    let root = (slope * slope - curve * inside).max(0.0).sqrt();
    let exit = if slope > 0.0 {
        -inside / (slope + root)
    } else if curve > 0.0 {
        (root - slope) / curve
    } else {
        1.0
    };
    exit.clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::left_after;

    #[test]
    fn series_of_small_steps_are_what_they_stand_for() {
        let parts = [0.0, 1e-12, 3e-5, 0.999e-4, 1.001e-4, 0.03, 2.0];
        for growth in parts.into_iter().flat_map(|part| [part, -0.4 * part]) {
            for pull in [0.0, 1e-9, 4e-4, 0.999e-3, 1.001e-3, 0.3, 7.0] {
                let mean = if growth == 0.0 { 1.0 } else { libm::log1p(growth) / growth };
                let want = libm::exp(-pull * mean);
                let got = left_after(pull, growth);
                assert!((got / want - 1.0).abs() < 4e-16 * (1.0 + pull), "{pull} {growth}: {got}");
            }
        }
    }
}
