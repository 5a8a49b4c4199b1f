//! The minima of the distance between a curve swept by a ball and another body.
//!
//! Spheres, capsules, tori and the side of a cylinder are swept by a ball; an edge is swept by a
//! ball of radius zero.

use carom_special::roots::bisect;
use nalgebra::Vector3;
use std::f64::consts::PI;

use super::target::Target;
use super::touch::{Nearest, Touch};
use crate::placed::Placed;

/// Slopes of the distance along the curve below this count as zero: parallel lines.
const ZERO_SLOPE: f64 = 1e-12;

/// Sample points along a curve that may have many minima.
const SAMPLES: i32 = 96;

/// The same along an edge. A contact there is an error, so that less accuracy is needed.
const SAMPLES_OF_EDGE: i32 = 20;

/// A curve, in the axes of its body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Curve {
    /// A straight line of twice the half-length along a unit vector.
    Straight { middle: Vector3<f64>, along: Vector3<f64>, half_length: f64 },
    /// A circle about axis c.
    Round { height: f64, radius: f64 },
}

impl Curve {
    pub(super) fn axis(half_length: f64) -> Self {
        Self::Straight { middle: Vector3::zeros(), along: Vector3::z(), half_length }
    }

    // Point and unit tangent.
    fn at(&self, t: f64) -> (Vector3<f64>, Vector3<f64>) {
        match self {
            Self::Straight { middle, along, .. } => (middle + along * t, *along),
            Self::Round { height, radius } => {
                let (sin, cos) = libm::sincos(t);
                let point = Vector3::new(radius * cos, radius * sin, *height);
                (point, Vector3::new(-sin, cos, 0.0))
            }
        }
    }
}

/// A curve of a body, and the radius of the ball that sweeps it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rail<'a> {
    pub(super) body: &'a Placed,
    pub(super) curve: Curve,
    pub(super) radius: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Trend {
    Falling,
    Level,
    Rising,
}

impl Rail<'_> {
    /// A point is simpler than a line, a line simpler than a circle.
    pub(super) fn is_simpler_than(&self, other: &Self) -> bool {
        let rank = |rail: &Self| match rail.curve {
            Curve::Straight { half_length: 0.0, .. } => 0,
            Curve::Straight { .. } => 1,
            Curve::Round { .. } => 2,
        };
        rank(self) < rank(other)
    }

    /// All minima of the distance along the curve, including those at the ends of a line.
    pub(super) fn scan(&self, other: &Target<'_>) -> Vec<Touch> {
        match self.curve {
            Curve::Straight { half_length: 0.0, .. } => {
                self.touch(0.0, other).into_iter().collect()
            }
            Curve::Straight { half_length, .. } => {
                let pieces = if other.is_convex() { 1 } else { self.samples() };
                self.minima((-half_length, half_length), pieces, other)
            }
            Curve::Round { .. } => {
                let begin = self.descent_on_circle(other);
                self.minima((begin, begin + 2.0 * PI), self.samples(), other)
            }
        }
    }

    fn samples(&self) -> i32 {
        if self.radius == 0.0 { SAMPLES_OF_EDGE } else { SAMPLES }
    }

    fn trend(&self, t: f64, other: &Target<'_>) -> Option<Trend> {
        let (point, tangent) = self.curve.at(t);
        let closest = other.closest(&self.body.space_point(&point))?;
        let slope = closest.normal.dot(&self.body.attitude().to_space(&tangent));
        Some(match slope {
            _ if slope < -ZERO_SLOPE => Trend::Falling,
            _ if slope > ZERO_SLOPE => Trend::Rising,
            _ => Trend::Level,
        })
    }

    fn touch(&self, t: f64, other: &Target<'_>) -> Option<Touch> {
        let core = self.body.space_point(&self.curve.at(t).0);
        let closest = other.closest(&core)?;
        let points = [core - closest.normal * self.radius, closest.point];
        let near = Nearest { points, gap: closest.distance - self.radius };
        let within = match self.curve {
            Curve::Straight { half_length, .. } => t.abs() < half_length,
            Curve::Round { .. } => true,
        };
        Some(Touch { near, within })
    }

    // A position where the distance decreases, so that no minimum lies at the ends of the scan.
    fn descent_on_circle(&self, other: &Target<'_>) -> f64 {
        let samples = self.samples();
        let place = |i: i32| f64::from(i) * 2.0 * PI / f64::from(samples);
        let falling = |t: &f64| self.trend(*t, other) == Some(Trend::Falling);
        (0..samples).map(place).find(falling).unwrap_or(0.0)
    }

    // Positions where the distance changes from decreasing to increasing. If it is constant in
    // between, the middle of that interval is taken. Beyond the ends of a line the distance
    // increases.
    fn minima(&self, (begin, end): (f64, f64), pieces: i32, other: &Target<'_>) -> Vec<Touch> {
        let step = (end - begin) / f64::from(pieces);
        let mut found = Vec::new();
        // The last position where it decreased, and the position where it stopped decreasing.
        let (mut fell, mut low) = (Some(begin), Some(begin));
        let mut last = begin;
        for i in 0..=pieces {
            let t = if i == pieces { end } else { begin + step * f64::from(i) };
            match self.trend(t, other) {
                Some(Trend::Falling) => (fell, low) = (Some(t), None),
                Some(trend) => {
                    if let (Some(from), None) = (fell, low) {
                        low = Some(self.change(from, t, other, |t| t == Trend::Falling));
                    }
                    if let (Trend::Rising, Some(bottom)) = (trend, low) {
                        let from = last.max(bottom);
                        let top = self.leave_level(from, t, other);
                        found.extend(self.touch(0.5 * (bottom + top), other));
                        (fell, low) = (None, None);
                    }
                }
                None => (fell, low) = (None, None),
            }
            last = t;
        }
        // The scan of a closed curve starts where the distance decreases; what remains is a curve
        // of constant distance.
        let open = matches!(self.curve, Curve::Straight { .. });
        if let Some(from) = if open { low.or(fell) } else { low } {
            found.extend(self.touch(0.5 * (from + end), other));
        }
        found
    }

    // The position where the distance begins to increase: nearby, unless it is constant.
    fn leave_level(&self, from: f64, to: f64, other: &Target<'_>) -> f64 {
        let mut stride = self.finest();
        let mut left = from;
        while left + stride < to && self.trend(left + stride, other) != Some(Trend::Rising) {
            left += stride;
            stride *= 4.0;
        }
        self.change(left, to.min(left + stride), other, |t| t != Trend::Rising)
    }

    fn finest(&self) -> f64 {
        let reach = match self.curve {
            Curve::Straight { half_length, .. } => half_length,
            Curve::Round { .. } => PI,
        };
        1e-16 * reach
    }

    // The position where the sign of the slope changes, to [`Self::finest`].
    fn change(&self, from: f64, to: f64, other: &Target<'_>, holds: impl Fn(Trend) -> bool) -> f64 {
        let halvings = libm::ceil(libm::log2((to - from) / self.finest())).max(0.0);
        let [low, high] =
            bisect([from, to], halvings as usize, |t| self.trend(t, other).is_some_and(&holds));
        0.5 * (low + high)
    }
}
