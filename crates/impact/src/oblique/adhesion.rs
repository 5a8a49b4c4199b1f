//! Complete adhesion in closed form (section 9.2).
//!
//! With the normal velocity w as clock the tangential velocity u of an adhering contact obeys
//! Gegenbauer's equation `(1 - w^2) u'' - (6/5) w u' + (6/5) chi u = 0`, equivalent to (9.14) by
//! S = 1 - w^2. The traction is `Phi = zeta^(3/2) u' / chi`. Local power series carry it.

/// Terms a series may have; a third of the radius of convergence needs about 35.
const MAX_TERMS: usize = 80;

/// Share of the distance to the singular point w = 1 that one series covers.
const REACH: f64 = 0.4;

/// Tangential velocity and its derivative by w at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tangential {
    pub(super) velocity: f64,
    pub(super) gradient: f64,
}

/// The solution on `low <= w <= high` as a power series in t = x/(a + b x), x = w - center.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    center: f64,
    pub(super) low: f64,
    pub(super) high: f64,
    /// The numbers a and b of the argument.
    map: [f64; 2],
    blocks: usize,
    velocity: Rows,
    gradient: Rows,
}

/// Coefficients, eight a row.
type Rows = [[f64; 8]; MAX_TERMS / 8];

impl Segment {
    /// Adhesion from first touch (w = 1) with velocity 1: regular there, so one series serves.
    pub(super) fn from_touch(chi: f64) -> Self {
        // t = (w + 1 - c)/(w + 1 + c), c = sqrt 2, puts the singular points w = -1 and infinity
        // at t = -1 and 1 and the interval at |t| <= 0.172: half the terms of a series in w.
        const C: f64 = std::f64::consts::SQRT_2;
        const REACH: f64 = 0.171_572_875_253_809_9;
        let center = C - 1.0;
        let now = regular_at_touch(chi, center);
        // d/dt = 2 c d/dw at t = 0
        let series = Series::new(now.velocity, 2.0 * C * now.gradient, REACH, |k, a| {
            next_from_touch(chi, k, a)
        });
        Self::of(&series, center, [0.0, 1.0], [2.0 * C, 1.0])
    }

    /// Adhesion that begins at `w` in (0, 1) with the state `now`; covers part of the way to 0.
    pub(super) fn from_state(chi: f64, w: f64, now: Tangential) -> Self {
        let low = (w - REACH * (1.0 - w)).max(0.0);
        let inverse = 1.0 / ((1.0 - w) * (1.0 + w));
        let series = Series::new(now.velocity, now.gradient, w - low, |k, c| {
            let n = k as f64;
            // (1 - w^2)(k+1)(k+2) c_{k+2} = w (k+1)(2k + 6/5) c_{k+1} + (k (k - 1 + 6/5) - 6/5 chi) c_k
            let next =
                w * (n + 1.0) * (2.0 * n + 1.2) * c[k + 1] + (n * (n + 0.2) - 1.2 * chi) * c[k];
            next * inverse / ((n + 1.0) * (n + 2.0))
        });
        Self::of(&series, w, [low, w], [1.0, 0.0])
    }

    fn of(series: &Series, center: f64, [low, high]: [f64; 2], map: [f64; 2]) -> Self {
        let mut velocity = [[0.0; 8]; MAX_TERMS / 8];
        let mut gradient = velocity;
        for k in 0..series.terms.min(MAX_TERMS - 1) {
            velocity[k / 8][k % 8] = series.c[k];
            gradient[k / 8][k % 8] = (k as f64 + 1.0) * series.c[k + 1];
        }
        let blocks = series.terms.div_ceil(8);
        Self { center, low, high, map, blocks, velocity, gradient }
    }

    /// Velocity and gradient at `w`.
    #[inline]
    pub(super) fn at(&self, w: f64) -> Tangential {
        let x = w - self.center;
        let [a, b] = self.map;
        let inverse = 1.0 / (a + b * x);
        let t = x * inverse;
        let velocity = sum(&self.velocity[..self.blocks], t);
        let gradient = sum(&self.gradient[..self.blocks], t);
        // dt/dw = a/(a + b x)^2
        Tangential { velocity, gradient: gradient * (a * inverse * inverse) }
    }

    /// The second derivative by w, from the differential equation.
    pub(super) fn curvature(&self, chi: f64, w: f64) -> f64 {
        let now = self.at(w);
        (1.2 * w * now.gradient - 1.2 * chi * now.velocity) / ((1.0 - w) * (1.0 + w))
    }
}

// Eight interleaved series in t^8: a short chain of dependent operations.
#[inline]
fn sum(rows: &[[f64; 8]], t: f64) -> f64 {
    let squared = t * t;
    let fourth = squared * squared;
    let eighth = fourth * fourth;
    let mut s = [0.0; 8];
    for row in rows.iter().rev() {
        for lane in 0..8 {
            s[lane] = s[lane] * eighth + row[lane];
        }
    }
    let low = (s[0] + s[1] * t) + (s[2] + s[3] * t) * squared;
    let high = (s[4] + s[5] * t) + (s[6] + s[7] * t) * squared;
    low + high * fourth
}

/// A power series and how many of its terms count.
struct Series {
    c: [f64; MAX_TERMS],
    terms: usize,
}

impl Series {
    // From the first two coefficients and the rule for the one after k + 1, for |t| <= reach.
    fn new(
        first: f64,
        second: f64,
        reach: f64,
        next: impl Fn(usize, &[f64; MAX_TERMS]) -> f64,
    ) -> Self {
        let mut c = [0.0; MAX_TERMS];
        (c[0], c[1]) = (first, second);
        let (mut power, mut largest) = (reach, c[0].abs().max(c[1].abs() * reach));
        let inverse_reach = 1.0 / reach;
        for k in 0..MAX_TERMS - 2 {
            c[k + 2] = next(k, &c);
            power *= reach;
            let size = (k as f64 + 2.0) * (c[k + 2].abs() + c[k + 1].abs() * inverse_reach) * power;
            largest = largest.max(c[k + 2].abs() * power);
            if size < 1e-17 * largest {
                return Self { c, terms: k + 3 };
            }
        }
        Self { c, terms: MAX_TERMS }
    }
}

// The recurrence of Gegenbauer's equation in t = (w + 1 - c)/(w + 1 + c), c = sqrt 2:
// (1 + t)(1 - t)^2 P U'' - (1 - t) [2 (1 + t) P + (12/5) Q] U' + (24/5) c chi U = 0,
// P = 2 - c - (2 + c) t, Q = c - 1 + (c + 1) t.
fn next_from_touch(chi: f64, k: usize, a: &[f64; MAX_TERMS]) -> f64 {
    const C: f64 = std::f64::consts::SQRT_2;
    const P: [f64; 2] = [2.0 - C, -2.0 - C];
    const Q: [f64; 2] = [C - 1.0, C + 1.0];
    const SECOND: [f64; 5] = [P[0], P[1] - P[0], -P[1] - P[0], P[0] - P[1], P[1]];
    const FIRST: [f64; 4] = [
        -2.0 * P[0] - 2.4 * Q[0],
        -2.0 * P[1] - 2.4 * (Q[1] - Q[0]),
        2.0 * P[0] + 2.4 * Q[1],
        2.0 * P[1],
    ];
    let n = k as f64;
    let mut sum = 4.8 * C * chi * a[k];
    for j in 0..=k.min(3) {
        let m = n - j as f64;
        sum += FIRST[j] * (m + 1.0) * a[k + 1 - j];
    }
    for j in 1..=(k + 1).min(4) {
        let m = n - j as f64;
        sum += SECOND[j] * (m + 2.0) * (m + 1.0) * a[k + 2 - j];
    }
    -sum / (SECOND[0] * (n + 2.0) * (n + 1.0))
}

// u = F(-n, n + 1/5; 3/5; z), z = (1 - w)/2, n (n + 1/5) = 6 chi/5: the regular solution with u(1) = 1.
fn regular_at_touch(chi: f64, w: f64) -> Tangential {
    let z = 0.5 * (1.0 - w);
    let (mut term, mut velocity, mut slope, mut k) = (1.0, 1.0, 0.0, 0.0);
    loop {
        let ratio = (k * (k + 0.2) - 1.2 * chi) / ((k + 0.6) * (k + 1.0));
        slope += (k + 1.0) * ratio * term;
        term *= ratio * z;
        velocity += term;
        k += 1.0;
        let settled = k * k > 2.4 * chi && (k + 1.0) * term.abs() < 1e-18;
        if settled {
            return Tangential { velocity, gradient: -0.5 * slope };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chi_one_is_a_straight_line() {
        // n = 1: u = w.
        let segment = Segment::from_touch(1.0);
        for i in 0..=10 {
            let w = 0.1 * f64::from(i);
            assert!((segment.at(w).velocity - w).abs() < 4e-16);
            assert!((segment.at(w).gradient - 1.0).abs() < 4e-15);
        }
    }

    #[test]
    fn restarted_series_continue_the_solution() {
        for chi in [0.5, 3.5, 6.5, 60.0] {
            let whole = Segment::from_touch(chi);
            let part = Segment::from_state(chi, 0.9, whole.at(0.9));
            let scale = whole.at(part.low).gradient.abs().max(1.0);
            let (a, b) = (whole.at(part.low), part.at(part.low));
            assert!((a.velocity - b.velocity).abs() < 1e-13 * scale, "{chi}");
            assert!((a.gradient - b.gradient).abs() < 1e-12 * scale, "{chi}");
        }
    }

    #[test]
    fn gegenbauer_equation_holds() {
        let (chi, h) = (2.9, 1e-4);
        let segment = Segment::from_touch(chi);
        for w in [0.1, 0.5, 0.9] {
            let difference = (segment.at(w + h).gradient - segment.at(w - h).gradient) / (2.0 * h);
            assert!((difference - segment.curvature(chi, w)).abs() < 1e-6);
        }
    }
}
