//! The end of adhesion: the friction limit |u| = w at the edge, with u in units of zeta'_A.

use super::adhesion::Segment;
use super::position::Position;
use super::slip_integration::MIN_DIP;

/// The friction limit of adhesion for one impact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limit {
    chi: f64,
    psi: f64,
}

impl Limit {
    pub(super) const fn new(chi: f64, psi: f64) -> Self {
        Self { chi, psi }
    }

    /// The first w (decreasing) at which |u| reaches w, and the sign of u there.
    ///
    /// `resting` is the sign of the limit at which the adhesion begins, or 0.
    pub(super) fn reached(&self, segment: &Segment, resting: f64) -> Option<(f64, f64)> {
        const SAMPLES: usize = 24;
        let margin = |w: f64, sign: f64| w - sign * self.psi * segment.velocity_at(w);
        let mut leaving = resting;
        let mut before = segment.high;
        for i in 1..=SAMPLES {
            let w = segment.high * ((SAMPLES - i) as f64 / SAMPLES as f64);
            let slip = self.psi * segment.velocity_at(w);
            // Upper bound of a dip of the margin within the interval, by u'' of the order of chi u.
            let near = self.chi * (before - w) * (before - w) / (1.0 - w);
            for sign in [1.0, -1.0] {
                let value = w - sign * slip;
                if sign == leaving {
                    if value > 0.0 {
                        leaving = 0.0;
                    }
                } else if value < near && self.turns(segment, sign, [w, before]) {
                    if let Some(low) = self.dip(segment, sign, [w, before]) {
                        return Some((falling_root(|w| margin(w, sign), low, before), sign));
                    }
                } else if value < 0.0 || (value == 0.0 && w > 0.0) {
                    return Some((falling_root(|w| margin(w, sign), w, before), sign));
                }
            }
            before = w;
        }
        None
    }

    // Whether w - |u| has a minimum between two velocities.
    fn turns(&self, segment: &Segment, sign: f64, [low, high]: [f64; 2]) -> bool {
        !self.rises(segment, sign, low) && self.rises(segment, sign, high)
    }

    fn rises(&self, segment: &Segment, sign: f64, w: f64) -> bool {
        let position = Position::of_velocity(w);
        1.0 > sign * self.psi * segment.at(&position).gradient(&position)
    }

    // Where |u| exceeds w, by more than `MIN_DIP`, on both sides of such a minimum.
    fn dip(&self, segment: &Segment, sign: f64, [low, high]: [f64; 2]) -> Option<f64> {
        let graze = MIN_DIP * self.psi.min(1.0);
        let (mut low, mut high) = (low, high);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if middle - sign * self.psi * segment.velocity_at(middle) < -graze {
                return Some(middle);
            }
            if self.rises(segment, sign, middle) { high = middle } else { low = middle }
        }
        None
    }
}

// The largest root below `high` of a function positive there and not positive at `low`.
fn falling_root(f: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    let (mut low, mut high) = (low, high);
    let (mut f_low, mut f_high) = (f(low), f(high));
    let mut side = 0;
    for _ in 0..200 {
        if high - low <= f64::EPSILON * high.abs() {
            break;
        }
        // Illinois variant of regula falsi.
        let w = (low * f_high - high * f_low) / (f_high - f_low);
        let w = if w > low && w < high { w } else { 0.5 * (low + high) };
        let value = f(w);
        if value > 0.0 {
            (high, f_high) = (w, value);
            if side == 1 {
                f_low *= 0.5;
            }
            side = 1;
        } else {
            (low, f_low) = (w, value);
            if side == -1 {
                f_high *= 0.5;
            }
            side = -1;
            if value == 0.0 {
                break;
            }
        }
    }
    low
}
