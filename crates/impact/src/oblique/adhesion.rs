//! Complete adhesion in closed form (section 9.2).
//!
//! With the normal velocity w as independent variable, the tangential velocity u in adhesion obeys
//! Gegenbauer's equation `(1 - w^2) u'' - (6/5) w u' + (6/5) chi u = 0`. It is equivalent to (9.14)
//! by S = 1 - w^2. The traction is `Phi = zeta^(3/2) u' / chi`. The solutions are computed by power
//! series.

use super::position::Position;

/// Largest number of terms of a series: solid bodies need 24, chi = 100 three times as many.
const MAX_TERMS: usize = 80;

/// Centre and argument of the series: t = (w + 1 - c)/(w + 1 + c) with c = sqrt 2. The singular
/// points w = -1 and infinity are then at t = -1 and 1, and the compression, 0 <= w <= 1, at |t| <=
/// 0.172.
const C: f64 = std::f64::consts::SQRT_2;
const CENTER: f64 = C - 1.0;
const T_MAX: f64 = 0.171_572_875_253_809_9;

/// Tangential velocity u and its flux zeta^(3/2) du/dw = chi Phi at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tangential {
    pub(super) velocity: f64,
    pub(super) flux: f64,
}

impl Tangential {
    pub(super) fn gradient(&self, position: &Position) -> f64 {
        self.flux / position.cube()
    }
}

/// An adhesive motion during compression.
///
/// The general solution is R(w) + zeta J(w). J obeys the same equation with 14/5 in place of 6/5
/// and (6/5) chi - 4/5 in place of (6/5) chi. Both are regular at first contact. J vanishes if the
/// contact sticks from first contact on.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    /// The normal velocity at which it begins.
    pub(super) high: f64,
    regular: Table,
    irregular: Option<Table>,
}

impl Segment {
    /// Adhesion from first contact (w = 1) with velocity 1.
    pub(super) fn from_touch(chi: f64) -> Self {
        Self { high: 1.0, regular: Table::new(Equation::regular(chi)), irregular: None }
    }

    /// Adhesion that begins during compression, at `position` with the state `now`.
    pub(super) fn from_state(chi: f64, position: &Position, now: Tangential) -> Self {
        let mut regular = Table::new(Equation::regular(chi));
        let mut irregular = Table::new(Equation::irregular(chi));
        // The Wronskian (flux of R times zeta J less flux of zeta J times R) is -4/5, its value at
        // first contact.
        let one = regular.at(position.w).regular(position);
        let other = irregular.at(position.w).irregular(position);
        regular.scale(-1.25 * (now.velocity * other.flux - now.flux * other.velocity));
        irregular.scale(-1.25 * (one.velocity * now.flux - one.flux * now.velocity));
        Self { high: position.w, regular, irregular: Some(irregular) }
    }

    /// Velocity at `position`.
    #[inline(always)]
    pub(super) fn velocity(&self, position: &Position) -> f64 {
        let t = argument(position.w).0;
        let regular = self.regular.value(t);
        match &self.irregular {
            None => regular,
            Some(table) => regular + position.radius * position.radius * table.value(t),
        }
    }

    /// Velocity at the normal velocity `w`.
    pub(super) fn velocity_at(&self, w: f64) -> f64 {
        match &self.irregular {
            None => self.regular.value(argument(w).0),
            Some(_) => self.velocity(&Position::of_velocity(w)),
        }
    }

    /// Velocity at `position`, to 13 digits.
    #[inline(always)]
    pub(super) fn nearly_velocity(&self, position: &Position) -> f64 {
        let t = argument(position.w).0;
        let regular = self.regular.nearly_value(t);
        match &self.irregular {
            None => regular,
            Some(table) => regular + position.radius * position.radius * table.nearly_value(t),
        }
    }

    /// Velocity and flux at `position`, to 13 digits.
    #[inline(always)]
    pub(super) fn nearly_at(&self, position: &Position) -> Tangential {
        let mut now = self.regular.nearly_at(position.w).regular(position);
        if let Some(table) = &self.irregular {
            let more = table.nearly_at(position.w).irregular(position);
            now.velocity += more.velocity;
            now.flux += more.flux;
        }
        now
    }

    /// Velocity and flux at `position`.
    pub(super) fn at(&self, position: &Position) -> Tangential {
        let mut now = self.regular.at(position.w).regular(position);
        if let Some(table) = &self.irregular {
            let more = table.at(position.w).irregular(position);
            now.velocity += more.velocity;
            now.flux += more.flux;
        }
        now
    }
}

// The argument t at w and dt/dw.
#[inline]
fn argument(w: f64) -> (f64, f64) {
    let inverse = 1.0 / (w + (1.0 + C));
    ((w - CENTER) * inverse, 2.0 * C * inverse * inverse)
}

/// Value and derivative by w of R or J.
struct Sum {
    value: f64,
    slope: f64,
}

impl Sum {
    fn regular(&self, position: &Position) -> Tangential {
        Tangential { velocity: self.value, flux: position.cube() * self.slope }
    }

    // zeta J, with d zeta/dw = -(4/5) w zeta^(-3/2)
    fn irregular(&self, position: &Position) -> Tangential {
        let zeta = position.zeta();
        let flux = position.cube() * zeta * self.slope - 0.8 * position.w * self.value;
        Tangential { velocity: zeta * self.value, flux }
    }
}

/// Coefficients, eight a row.
type Rows = [[f64; 8]; MAX_TERMS / 8];

/// R or J as a power series in t, with its derivative.
#[derive(Debug, Clone)]
struct Table {
    blocks: usize,
    /// Number of blocks needed for 13 digits of the value.
    few: usize,
    value: Rows,
    slope: Rows,
}

impl Table {
    fn new(equation: Equation) -> Self {
        let [value, slope] = equation.regular_at_touch(CENTER);
        // d/dt = 2 c d/dw at t = 0
        let series = equation.series([value, 2.0 * C * slope]);
        let mut value = [[0.0; 8]; MAX_TERMS / 8];
        let mut slope = value;
        for k in 0..series.terms.min(MAX_TERMS - 1) {
            value[k / 8][k % 8] = series.c[k];
            slope[k / 8][k % 8] = (k as f64 + 1.0) * series.c[k + 1];
        }
        Self {
            blocks: series.terms.div_ceil(8),
            few: series.count(1e-13).div_ceil(8),
            value,
            slope,
        }
    }

    fn scale(&mut self, factor: f64) {
        for row in self.value.iter_mut().chain(&mut self.slope) {
            for coefficient in row {
                *coefficient *= factor;
            }
        }
    }

    #[inline]
    fn value(&self, t: f64) -> f64 {
        sum(&self.value[..self.blocks], t)
    }

    #[inline]
    fn nearly_value(&self, t: f64) -> f64 {
        sum(&self.value[..self.few], t)
    }

    #[inline(always)]
    fn nearly_at(&self, w: f64) -> Sum {
        let (t, rate) = argument(w);
        let slope = sum(&self.slope[..self.few], t) * rate;
        Sum { value: sum(&self.value[..self.few], t), slope }
    }

    fn at(&self, w: f64) -> Sum {
        let (t, rate) = argument(w);
        let slope = sum(&self.slope[..self.blocks], t) * rate;
        Sum { value: self.value(t), slope }
    }
}

// Eight interleaved series in t^8: shorter chains of dependent operations.
#[inline(always)]
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
    // From the first two coefficients and the recurrence for the one after n + 1 by the four before
    // it, for |t| <= reach.
    fn new(first: f64, second: f64, reach: f64, next: impl Fn(f64, [f64; 4]) -> f64) -> Self {
        let mut c = [0.0; MAX_TERMS];
        (c[0], c[1]) = (first, second);
        let mut newest = [second, first, 0.0, 0.0];
        let (mut power, mut largest) = (reach, first.abs().max(second.abs() * reach));
        let mut before = second.abs() * reach;
        for k in 0..MAX_TERMS - 2 {
            let n = k as f64;
            let coefficient = next(n, newest);
            c[k + 2] = coefficient;
            newest = [coefficient, newest[0], newest[1], newest[2]];
            power *= reach;
            let size = coefficient.abs() * power * reach;
            largest = largest.max(size);
            if (n + 2.0) * (size + before) < 1e-17 * largest {
                return Self { c, terms: k + 3 };
            }
            before = size;
        }
        Self { c, terms: MAX_TERMS }
    }

    // The number of terms that exceed this share of the largest.
    fn count(&self, share: f64) -> usize {
        let mut power = 1.0;
        let sizes = self.c.map(|coefficient| {
            let size = coefficient.abs() * power;
            power *= T_MAX;
            size
        });
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        let beyond = sizes[..self.terms].iter().rev().take_while(|&&size| size < share * largest);
        self.terms - beyond.count()
    }
}

/// (1 - w^2) v'' - c w v' + k v = 0
#[derive(Debug, Clone, Copy)]
struct Equation {
    c: f64,
    k: f64,
}

impl Equation {
    fn regular(chi: f64) -> Self {
        Self { c: 1.2, k: 1.2 * chi }
    }

    fn irregular(chi: f64) -> Self {
        Self { c: 2.8, k: 1.2 * chi - 0.8 }
    }

    // The recurrence of the series in t:
    // (1 + t)(1 - t)^2 P U'' - (1 - t) [2 (1 + t) P + 2 c Q] U' + 4 sqrt(2) k U = 0,
    // P = 2 - sqrt 2 - (2 + sqrt 2) t, Q = sqrt 2 - 1 + (sqrt 2 + 1) t.
    fn series(self, start: [f64; 2]) -> Series {
        const P: [f64; 2] = [2.0 - C, -2.0 - C];
        const Q: [f64; 2] = [C - 1.0, C + 1.0];
        const SECOND: [f64; 5] = [P[0], P[1] - P[0], -P[1] - P[0], P[0] - P[1], P[1]];
        let twice = 2.0 * self.c;
        let first = [
            -2.0 * P[0] - twice * Q[0],
            -2.0 * P[1] - twice * (Q[1] - Q[0]),
            2.0 * P[0] + twice * Q[1],
            2.0 * P[1],
        ];
        let zeroth = 4.0 * C * self.k;
        Series::new(start[0], start[1], T_MAX, |n, [a, b, c, d]| {
            // The newest coefficient is a, of the power n + 1.
            let sum = (n + 1.0) * (first[0] + SECOND[1] * n) * a
                + (n * (first[1] + SECOND[2] * (n - 1.0)) + zeroth) * b
                + (n - 1.0) * (first[2] + SECOND[3] * (n - 2.0)) * c
                + (n - 2.0) * (first[3] + SECOND[4] * (n - 3.0)) * d;
            -sum / (SECOND[0] * (n + 2.0) * (n + 1.0))
        })
    }

    // Value and slope of F(..; c/2; z), z = (1 - w)/2: the regular solution, 1 at w = 1.
    fn regular_at_touch(self, w: f64) -> [f64; 2] {
        let z = 0.5 * (1.0 - w);
        let (mut term, mut value, mut slope, mut n) = (1.0, 1.0, 0.0, 0.0);
        loop {
            let ratio = (n * (n + self.c - 1.0) - self.k) / ((n + 0.5 * self.c) * (n + 1.0));
            slope += (n + 1.0) * ratio * term;
            term *= ratio * z;
            value += term;
            n += 1.0;
            let settled = n * n > 2.0 * self.k && (n + 1.0) * term.abs() < 1e-18;
            if settled {
                return [value, -0.5 * slope];
            }
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
        for i in 1..=10 {
            let position = Position::of_velocity(1.0 - 0.1 * f64::from(i));
            let now = segment.at(&position);
            assert!((now.velocity - position.w).abs() < 4e-16);
            assert!((now.gradient(&position) - 1.0).abs() < 4e-15);
        }
    }

    #[test]
    fn the_general_solution_starts_as_it_should_and_keeps_its_equation() {
        for chi in [0.3, 0.5, 3.5, 6.5, 60.0] {
            for w in [0.999_999, 0.9, 0.3] {
                let start = Position::of_velocity(w);
                let state = Tangential { velocity: 0.7, flux: -0.4 * start.cube() };
                let segment = Segment::from_state(chi, &start, state);
                let again = segment.at(&start);
                let tolerance = 2e-14 * chi.max(5.0);
                assert!((again.velocity - 0.7).abs() < tolerance, "{chi} {w}");
                assert!((again.flux - state.flux).abs() < tolerance, "{chi} {w}");
                // d flux/dw = -(6/5) chi u zeta^(-1): (1 - w^2)^(3/5) u' differentiated.
                let (w, h) = (0.6 * w, 1e-4);
                let at = |w: f64| {
                    let position = Position::of_velocity(w);
                    (segment.at(&position), position.zeta())
                };
                let [before, now, after] = [at(w - h), at(w), at(w + h)];
                let slope = (after.0.flux - before.0.flux) / (2.0 * h);
                let expected = -1.2 * chi * now.0.velocity / now.1;
                assert!((slope - expected).abs() < 1e-6 * chi * chi, "{chi}: {slope} {expected}");
                let slope = (after.0.velocity - before.0.velocity) / (2.0 * h);
                let expected = now.0.flux / now.1.powf(1.5);
                assert!((slope - expected).abs() < 1e-6 * chi * chi, "{chi}: {slope} {expected}");
                assert_eq!(segment.velocity(&start), again.velocity);
            }
        }
    }

    #[test]
    fn a_motion_continued_from_its_midst_is_the_same() {
        for chi in [0.5, 3.5, 6.5, 60.0] {
            let whole = Segment::from_touch(chi);
            let start = Position::of_velocity(0.8);
            let part = Segment::from_state(chi, &start, whole.at(&start));
            for w in [0.5, 0.0] {
                let position = Position::of_velocity(w);
                let (a, b) = (whole.at(&position), part.at(&position));
                assert!((a.velocity - b.velocity).abs() < 1e-13 * chi.max(1.0), "{chi}");
                assert!((a.flux - b.flux).abs() < 1e-13 * chi.max(1.0), "{chi}");
            }
        }
    }
}
