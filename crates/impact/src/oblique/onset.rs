//! The onset of slip after adhesion, as a power series.
//!
//! At the onset the stick area shrinks back along its own history, as its mirror image. With
//! `x = w* - w0` the motion is at `w = w0 - x` to first order. There the slip velocity `q = u - s w`
//! and its earlier value `L = u* - s w*` both vanish. An integration would divide zero by zero; a
//! series does not. It solves, with rho = (zeta/z*)^(3/2),
//!
//! `dw/dw* = rho L/q`, `q^2 = L^2 + E`, `dE/dw* = -2 s (chi - 1) (1 - rho) L`
//!
//! for the small quantities w + w*, rho - 1 and E/L^2, all of the order of psi if psi is small.

use super::adhesion::Tangential;
use super::position::{Difference, Position};

/// Number of terms of the series.
const TERMS: usize = 16;
/// Relative size of the last terms at the end of the range of the series.
const RELATIVE_LAST_TERM: f64 = 1e-15;
/// Largest share of the distance to first contact that a series covers.
const MAX_SHARE_TO_CONTACT: f64 = 0.25;

type Series = [f64; TERMS + 1];

/// The two positions and the first integral at one x.
#[derive(Debug, Clone, Copy)]
pub(super) struct Opened {
    /// Position of the edge of the stick area.
    pub(super) stick: Position,
    /// tau + tau*.
    pub(super) gap: f64,
    /// q^2 - L^2.
    pub(super) excess: f64,
}

/// The series in x.
#[derive(Debug, Clone, Copy)]
pub(super) struct Opening {
    w0: f64,
    /// Largest x at which the series is exact.
    pub(super) reach: f64,
    terms: Terms,
}

impl Opening {
    pub(super) fn at(&self, x: f64) -> Opened {
        let stick = Position::of_velocity(self.w0 + x);
        let excess = x * x * horner(&self.terms.e, x);
        Opened { stick, gap: gap(&stick, horner(&self.terms.v, x)), excess }
    }

    /// The normal velocity at x.
    pub(super) fn velocity(&self, x: f64) -> f64 {
        horner(&self.terms.v, x) - (self.w0 + x)
    }
}

/// Slip of sign `sign` that begins at `onset` with the state `now`, in units of `psi`, on a memory
/// that extends out to the position `touch`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Onset {
    pub(super) chi: f64,
    pub(super) psi: f64,
    pub(super) sign: f64,
    pub(super) position: Position,
    pub(super) now: Tangential,
    pub(super) touch: f64,
}

impl Onset {
    /// The slip over the range of the series.
    pub(super) fn open(&self) -> Opening {
        let terms = self.terms();
        let w0 = self.position.w;
        let reach =
            terms.reach().min(MAX_SHARE_TO_CONTACT * (1.0 - w0)).min(0.5 * (self.touch - w0));
        Opening { w0, reach, terms }
    }

    // L/x
    fn lag(&self) -> Series {
        let w0 = self.position.w;
        let inverse = 1.0 / ((1.0 - w0) * (1.0 + w0));
        // u* about w0 by Gegenbauer's equation.
        let mut u = [0.0; TERMS + 2];
        (u[0], u[1]) = (self.now.velocity, self.now.gradient(&self.position));
        for k in 0..TERMS {
            let n = k as f64;
            let next = w0 * (n + 1.0) * (2.0 * n + 1.2) * u[k + 1]
                + (n * (n + 0.2) - 1.2 * self.chi) * u[k];
            u[k + 2] = next * inverse / ((n + 1.0) * (n + 2.0));
        }
        let mut lag = [0.0; TERMS + 1];
        for k in 0..=TERMS {
            lag[k] = self.psi * u[k + 1];
        }
        lag[0] -= self.sign;
        lag
    }

    fn terms(&self) -> Terms {
        let w0 = self.position.w;
        let inverse = 1.0 / ((1.0 - w0) * (1.0 + w0));
        let pull = -2.0 * self.sign * (self.chi - 1.0);
        let lag = self.lag();
        let squared: Series = std::array::from_fn(|n| product(&lag, &lag, n));
        let inverse_squared = 1.0 / squared[0];
        let mut v = [0.0; TERMS + 1]; // w + w*
        let mut d = v; // (1 - w^2)/(1 - w*^2) - 1
        let mut z = v; // rho - 1
        let mut e = v; // E/x^2
        let mut y = v; // E/L^2
        let mut h = v; // (1 + y)^(-1/2) - 1
        v[0] = 2.0 * w0;
        for n in 0..TERMS {
            // d (1 - w*^2) = v (2 w* - v), w* = w0 + x
            let mut rise = 2.0 * w0 * v[n] - product(&v, &v, n);
            let mut known = 0.0;
            if n >= 1 {
                rise += 2.0 * v[n - 1];
                known += 2.0 * w0 * d[n - 1];
            }
            if n >= 2 {
                known += d[n - 2];
            }
            d[n] = if n == 0 { 0.0 } else { (rise + known) * inverse };
            if n >= 1 {
                z[n] = power(0.6, &d, &z, n);
                e[n] = -pull * product(&z, &lag, n) / (n as f64 + 2.0);
                let mut sum = e[n];
                for j in 1..n {
                    sum -= squared[j] * y[n - j];
                }
                y[n] = sum * inverse_squared;
                h[n] = power(-0.5, &y, &h, n);
            }
            // w' = -(1 + z)(1 + h)
            v[n + 1] = -(z[n] + h[n] + product(&z, &h, n)) / (n as f64 + 1.0);
        }
        Terms { v, e }
    }
}

#[derive(Debug, Clone, Copy)]
struct Terms {
    v: Series,
    e: Series,
}

impl Terms {
    // The largest x at which the last terms are negligible: those of v against its increase, those
    // of e against e.
    fn reach(&self) -> f64 {
        let size = |series: &Series, k: usize| series[k].abs().max(f64::MIN_POSITIVE);
        let (v, e) = (size(&self.v, 2), size(&self.e, 1));
        let root = |last: f64, first: f64, power: usize| {
            libm::exp(libm::log(RELATIVE_LAST_TERM * first / last) / power as f64)
        };
        let by_v = root(size(&self.v, TERMS), v, TERMS - 2).min(root(
            size(&self.v, TERMS - 1),
            v,
            TERMS - 3,
        ));
        let by_e = root(size(&self.e, TERMS - 1), e, TERMS - 2).min(root(
            size(&self.e, TERMS - 2),
            e,
            TERMS - 3,
        ));
        by_v.min(by_e)
    }
}

// tau + tau* from w + w*.
fn gap(stick: &Position, sum: f64) -> f64 {
    let now = Position::of_velocity(sum - stick.w);
    if now.w > 0.0 {
        return now.tau + stick.tau;
    }
    // w + w* = (tau + tau*) omega + tau* (omega* - omega) with
    // omega - omega* = D (a - a*), a - a* = (1 + a)(1 + a*)(tau* - tau)(tau + tau*)/2
    let difference = Difference::new(&now, stick);
    let radii = 0.5 * (1.0 + now.radius) * (1.0 + stick.radius) * (stick.tau - now.tau);
    sum / (now.omega - stick.tau * difference.omega * radii)
}

// Term n of the product of two series.
fn product(a: &Series, b: &Series, n: usize) -> f64 {
    (0..=n).map(|j| a[j] * b[n - j]).sum()
}

// Term n >= 1 of (1 + a)^p - 1, of which b holds the terms below n; a_0 = 0:
// (1 + a) b' = p (1 + b) a'.
fn power(p: f64, a: &Series, b: &Series, n: usize) -> f64 {
    let mut sum = p * n as f64 * a[n];
    for j in 1..n {
        sum += (p * j as f64 - (n - j) as f64) * a[j] * b[n - j];
    }
    sum / n as f64
}

fn horner(a: &Series, x: f64) -> f64 {
    a.iter().rev().fold(0.0, |sum, term| sum * x + term)
}
