//! Where the slip annulus of a growing contact begins to move outwards.

use super::history::TwistHistory;
use super::segment::Segment;
use super::sliding::Sloped;
use super::steady::SteadyAnnulus;

/// Newton's method ends with a step of this fraction of the radius; the deficit left is of the order of its square.
const ACCURACY: f64 = 1e-9;
/// Greatest number of steps, of which only bisections may be many.
const ITERATIONS: usize = 100;

impl TwistHistory {
    /// The contact radius, up to `radius`, at which the inner radius of the annulus begins to move
    /// outwards.
    pub(super) fn turns_outward(&self, radius: f64, rate: f64, annulus: SteadyAnnulus) -> f64 {
        let ratio = annulus.ratio;
        if ratio == 0.0 || self.radius == 0.0 {
            return if ratio == 0.0 { radius } else { self.radius };
        }
        let deficit = Deficit::new(self, rate, annulus);
        let lowest = ratio * self.radius;
        let mut upper = ratio * radius.min(self.radius / ratio);
        let top = upper;
        for segment in self.segments.iter().rev().filter(|segment| segment.from < top) {
            if upper == top && deficit.at(segment, top).value < 0.0 {
                return radius;
            }
            let lower = segment.from.max(lowest);
            if deficit.at(segment, lower).value < 0.0 {
                let edge = deficit.vanishes(segment, [lower, upper]);
                return (edge / ratio).clamp(self.radius, radius);
            }
            if lower == lowest {
                break;
            }
            upper = lower;
        }
        self.radius
    }
}

/// The deficit of the twist while everything outside `s = k' al` slides, with the steady ratio k', as a function of s:
/// `sign (bh - T(s)) - B(s; al)`. Since bh increases by r dal and B by `(2/pi) (K - E) dal`, the difference of both
/// increases by `(2/pi) E dal`, in proportion to s, as if a contact had the density that the annulus leaves.
struct Deficit {
    sign: f64,
    /// The value for s = 0 without the twist T of the discs inside.
    offset: f64,
    /// `(2/pi) E/k'`.
    slope: f64,
}

impl Deficit {
    fn new(before: &TwistHistory, rate: f64, annulus: SteadyAnnulus) -> Self {
        let sign = 1.0_f64.copysign(rate);
        let offset = sign * before.twist - rate.abs() * before.radius;
        Self { sign, offset, slope: annulus.density() }
    }

    fn at(&self, segment: &Segment, s: f64) -> Sloped {
        let Sloped { value, slope } = segment.twist_and_density(s);
        Sloped {
            value: self.offset + self.slope * s - self.sign * value,
            slope: self.slope - self.sign * slope,
        }
    }

    /// The root between two radii of a segment, at the lower of which the deficit is negative.
    fn vanishes(&self, segment: &Segment, [mut lower, mut upper]: [f64; 2]) -> f64 {
        let mut s = upper;
        for _ in 0..ITERATIONS {
            let Sloped { value, slope } = self.at(segment, s);
            if value < 0.0 {
                lower = s;
            } else {
                upper = s;
            }
            let next = s - value / slope;
            if (next - s).abs() <= ACCURACY * s {
                return next.clamp(lower, upper);
            }
            s = if next > lower && next < upper { next } else { 0.5 * (lower + upper) };
        }
        s
    }
}

#[cfg(test)]
mod tests {
    use carom_special::roots::bisect;

    use super::*;
    use crate::torsion::sliding::sliding_twist;

    /// Contacts that slid to and fro while they grew and receded.
    fn histories() -> Vec<TwistHistory> {
        let paths: [&[(f64, f64)]; 5] = [
            &[(1.0, 0.0), (1.0, 0.4)],
            &[(1.0, 0.3), (1.0, 0.9), (0.8, 0.8), (1.0, 0.85)],
            &[(1.0, 0.0), (1.0, 0.7), (1.0, 0.1), (1.2, 0.1), (1.2, 0.9)],
            &[(0.5, 0.8), (1.0, 2.0), (1.0, 1.2), (0.9, 1.15)],
            &[(1.0, 0.0), (1.0, 0.8), (1.0, -0.2), (1.1, -0.2), (1.1, 0.1)],
        ];
        let advanced = |path: &&[(f64, f64)]| {
            let mut history = TwistHistory::new();
            for &(radius, twist) in *path {
                history.advance(radius, twist).expect("in range");
            }
            history
        };
        paths.iter().map(advanced).collect()
    }

    #[test]
    fn annuli_turn_where_the_deficit_of_the_twist_vanishes() {
        let mut inside = 0;
        for history in histories() {
            for rate in [1.0001, 1.01, 1.1, 1.5, 3.0].into_iter().flat_map(|r: f64| [r, -r]) {
                let annulus = SteadyAnnulus::new(rate.abs());
                let (start, end) = (history.radius(), 1.7 * history.radius());
                // The deficit itself, with the sliding twist of each radius.
                let excess = |al: f64| {
                    let (s, twist) = (annulus.ratio * al, history.twist + rate * (al - start));
                    rate.signum() * (twist - history.twist_below(s)) - sliding_twist(s, al)
                };
                let got = history.turns_outward(end, rate, annulus);
                let largest = end.min(start / annulus.ratio);
                if excess(largest) < 0.0 {
                    assert_eq!(got, end);
                    continue;
                }
                let [lower, upper] = bisect([start, largest], 50, |al| excess(al) < 0.0);
                // Where the deficit is flat its sign is that of rounding.
                let same = (got - upper).abs() <= 1e-12 || excess(got).abs() <= 5e-15;
                assert!(same, "{rate}: {got} {lower} {upper}, {:e}", excess(got));
                inside += usize::from(got > start && got < end);
            }
        }
        assert!(inside > 10, "{inside}");
    }
}
