//! The regions in which R_x is smooth, each mapped to a square.

use crate::normal::fifth_root;
use crate::oblique::{Groups, ObliqueImpact, Regime};

/// Coefficients in each direction.
pub(super) const ORDER: usize = 8;
/// The range of chi in the table.
pub(super) const CHI: [f64; 2] = [0.5, 6.5];

/// Where R_x is analytic, weak kinks apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Region {
    /// chi < 1, psi < 1: sticks at first, never reverses.
    StickLow,
    /// chi >= 1, psi < 1: sticks at first; ends in sliding backwards.
    StickBack,
    /// The same; ends in sliding forwards.
    StickForth,
    /// 1 <= psi < chi: slides, sticks, slips; ends in sliding backwards.
    SlideBack,
    /// The same; ends in sliding forwards.
    SlideForth,
    /// The same, with psi too large to end in sliding forwards.
    SlideFar,
    /// chi <= psi < 2 chi - 1: slides, slips.
    SlideSlip,
}

impl Region {
    pub(super) const ALL: [Self; 7] = [
        Self::StickLow,
        Self::StickBack,
        Self::StickForth,
        Self::SlideBack,
        Self::SlideForth,
        Self::SlideFar,
        Self::SlideSlip,
    ];
}

/// A curve chi(t), 0 <= t <= 1, as a polynomial.
#[derive(Debug, Clone, Copy)]
pub(super) struct Curve(pub(super) [f64; ORDER]);

impl Curve {
    // Through the values at the Chebyshev points.
    pub(super) fn through(value: impl Fn(f64) -> f64) -> Self {
        let mut chebyshev_sums = [0.0; ORDER];
        for point in chebyshev_points() {
            let value = value(0.5 * (1.0 + point)) / ORDER as f64;
            for (k, (sum, weight)) in chebyshev_sums.iter_mut().zip(chebyshev(point)).enumerate() {
                *sum += if k == 0 { value } else { 2.0 * weight * value };
            }
        }
        Self(chebyshev_sums)
    }

    #[inline]
    pub(super) fn at(&self, t: f64) -> f64 {
        let by_t = chebyshev(2.0 * t - 1.0);
        let products: [f64; ORDER] = std::array::from_fn(|k| self.0[k] * by_t[k]);
        let [a, b, c, d, e, f, g, h] = products;
        ((a + b) + (c + d)) + ((e + f) + (g + h))
    }
}

/// The regions with the curve between impacts that end in sliding backwards and forwards. Where the
/// final sliding has no length the force is of the order of zeta^(3/2), so that R_x has a kink of
/// order 5/2 there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Atlas {
    /// chi of the curve by psi in [0, 1].
    pub(super) stick: Curve,
    /// chi of the curve by (psi - 1)/(chi - 1) in units of `far`.
    pub(super) slide: Curve,
    /// (psi - 1)/(chi - 1) at which it leaves the table.
    pub(super) far: f64,
}

impl Atlas {
    pub(super) fn new() -> Self {
        let forth = |chi: f64, psi: f64| {
            Groups::new(chi, psi)
                .ok()
                .and_then(|groups| ObliqueImpact::new(groups).ok())
                .is_some_and(|impact| impact.regimes().last() == Some(Regime::SlideForward))
        };
        let [low, high] = [2.0, CHI[1]];
        let on_slide = |chi: f64, share: f64| 1.0 + share * (chi - 1.0);
        // The share falls from a backward to a forward end.
        let far = boundary(1.0, 1e-6, |share| forth(high, on_slide(high, share)));
        let stick = Curve::through(|psi| boundary(low, high, |chi| forth(chi, psi)));
        let slide =
            Curve::through(|t| boundary(low, high, |chi| forth(chi, on_slide(chi, far * t))));
        Self { stick, slide, far }
    }

    // The region of a point and the position in it, both from 0 to 1. R_x is a power series in
    // (psi - 1)^(1/5) next to psi = 1: the first sliding excites the irregular solution
    // (1 - w)^(2/5) of the adhesion.
    #[inline]
    pub(super) fn locate(&self, chi: f64, psi: f64) -> (Region, f64, f64) {
        let whole = |low: f64, high: f64| (chi - low) * (1.0 / (high - low));
        if psi < 1.0 {
            if chi < 1.0 {
                return (Region::StickLow, whole(CHI[0], 1.0), psi);
            }
            let curve = self.stick.at(psi);
            return if chi < curve {
                (Region::StickBack, (chi - 1.0) / (curve - 1.0), psi)
            } else {
                (Region::StickForth, (chi - curve) / (CHI[1] - curve), psi)
            };
        }
        let share = (psi - 1.0) / (chi - 1.0);
        if psi >= chi {
            return (Region::SlideSlip, whole(1.0, CHI[1]), share - 1.0);
        }
        if share >= self.far {
            let y = (share - self.far) / (1.0 - self.far);
            return (Region::SlideFar, whole(1.0, CHI[1]), y);
        }
        let t = share / self.far;
        let curve = self.slide.at(t);
        if chi < curve {
            (Region::SlideBack, (chi - 1.0) / (curve - 1.0), fifth_root(t))
        } else {
            (Region::SlideForth, (chi - curve) / (CHI[1] - curve), fifth_root(t))
        }
    }

    pub(super) fn place(&self, region: Region, x: f64, y: f64) -> [f64; 2] {
        let between = |low: f64, high: f64| low + (high - low) * x;
        let slide = |chi: f64, share: f64| [chi, 1.0 + share * (chi - 1.0)];
        let fifth = y * y * (y * y) * y;
        match region {
            Region::StickLow => [between(CHI[0], 1.0), y],
            Region::StickBack => [between(1.0, self.stick.at(y)), y],
            Region::StickForth => [between(self.stick.at(y), CHI[1]), y],
            Region::SlideBack => slide(between(1.0, self.slide.at(fifth)), self.far * fifth),
            Region::SlideForth => slide(between(self.slide.at(fifth), CHI[1]), self.far * fifth),
            Region::SlideFar => slide(between(1.0, CHI[1]), self.far + (1.0 - self.far) * y),
            Region::SlideSlip => slide(between(1.0, CHI[1]), 1.0 + y),
        }
    }
}

// Where a condition that is false at `from` and true at `to` changes: bisection. The kink is so
// weak that six digits are plenty.
fn boundary(from: f64, to: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut out, mut inside) = (from, to);
    for _ in 0..24 {
        let middle = 0.5 * (out + inside);
        if holds(middle) { inside = middle } else { out = middle }
    }
    0.5 * (out + inside)
}

pub(super) fn chebyshev_points() -> [f64; ORDER] {
    std::array::from_fn(|i| libm::cos((i as f64 + 0.5) * std::f64::consts::PI / ORDER as f64))
}

// T_0 .. T_7, by products rather than the recurrence: a shorter chain.
#[inline]
pub(super) fn chebyshev(x: f64) -> [f64; ORDER] {
    let t2 = 2.0 * x * x - 1.0;
    let t3 = x * (2.0 * t2 - 1.0);
    let t4 = 2.0 * t2 * t2 - 1.0;
    let t5 = 2.0 * t2 * t3 - x;
    let t6 = 2.0 * t3 * t3 - 1.0;
    let t7 = 2.0 * t3 * t4 - x;
    [1.0, x, t2, t3, t4, t5, t6, t7]
}
