//! The minimum of a function over a surface, from a given start.

use nalgebra::{Matrix3, Vector3};

use super::local::LocalSurface;
use super::{Kind, Surface, evaluate};
use crate::direction::perpendicular;

const MAX_STEPS: usize = 100;

/// Longest step relative to the size of the body.
const LONGEST_STEP: f64 = 0.3;

/// Least decrease of a step, relative to the expected one.
const SUFFICIENT_DECREASE: f64 = 1e-4;

/// A function of position in the body's axes: value, gradient and Hessian.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Objective {
    pub(crate) value: f64,
    pub(crate) gradient: Vector3<f64>,
    pub(crate) hessian: Matrix3<f64>,
    /// Rounding error of the value.
    pub(crate) noise: f64,
}

/// The position of the minimum, and the remaining gradient along the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Least {
    pub(crate) local: LocalSurface,
    pub(crate) value: f64,
    pub(crate) rest: f64,
}

// The function along the surface, at one of its points.
struct Here {
    local: LocalSurface,
    value: f64,
    noise: f64,
    slope: Vector3<f64>,
    descent: Vector3<f64>,
    // Unit direction along which the function decreases to both sides.
    fall: Option<Vector3<f64>>,
}

impl Surface {
    /// Newton's method along a smooth surface from the surface point next to `start`; a gradient
    /// below `gentle` counts as zero. It ends at a minimum, never at a saddle point.
    pub(crate) fn least(
        &self,
        start: &Vector3<f64>,
        gentle: f64,
        objective: impl Fn(&Vector3<f64>) -> Option<Objective>,
    ) -> Option<Least> {
        let look = |near: &Vector3<f64>| {
            let point = self.descend(near)?;
            let local = self.local(&point).ok()?;
            Some(Here::new(local, &objective(&point)?))
        };
        let mut here = look(start)?;
        for _ in 0..MAX_STEPS {
            let rest = here.slope.norm();
            let step = match here.fall {
                Some(fall) if rest <= gentle => fall * (0.1 * self.size()),
                _ if rest <= gentle => break,
                _ => here.descent,
            };
            let step = step * (LONGEST_STEP * self.size() / step.norm()).min(1.0);
            let Some(next) = here.follow(&step, look) else { break };
            here = next;
        }
        Some(Least { local: here.local, value: here.value, rest: here.slope.norm() })
    }

    /// Newton's iteration for f = 0 along the gradient.
    pub(super) fn descend(&self, from: &Vector3<f64>) -> Option<Vector3<f64>> {
        let mut point = *from;
        let mut last = f64::INFINITY;
        for _ in 0..MAX_STEPS {
            let (value, gradient) = self.value_and_gradient(&point)?;
            let step = gradient * (value / gradient.norm_squared());
            let length = step.norm();
            if !length.is_finite() {
                return None;
            }
            point -= step * (0.5 * self.size() / length.max(f64::MIN_POSITIVE)).min(1.0);
            // Rounding may keep the last digits changing.
            let still = length <= 1e-12 * self.size() && length >= 0.5 * last;
            if length <= 1e-15 * self.size() || still {
                return Some(point);
            }
            last = length;
        }
        None
    }

    fn value_and_gradient(&self, point: &Vector3<f64>) -> Option<(f64, Vector3<f64>)> {
        match self.kind() {
            Kind::Implicit { function, .. } => Some(function.slope(point)),
            Kind::Explicit { function, side, .. } => {
                let (c, slope) = function.slope(point);
                let gradient = Vector3::new(slope.x, slope.y, -1.0);
                Some((side.sign() * (c - point.z), gradient * side.sign()))
            }
            Kind::Ellipsoid { semi_axes } => {
                let jet = evaluate::ellipsoid(semi_axes, point);
                Some((jet.value, jet.gradient))
            }
            _ => None,
        }
    }
}

impl Here {
    // Along a surface with outward normal n the second derivative has the additional term -(n .
    // gradient) S.
    fn new(local: LocalSurface, objective: &Objective) -> Self {
        let normal = local.normal();
        let outward = normal.dot(&objective.gradient);
        let slope = objective.gradient - normal * outward;
        let bend = objective.hessian - local.shape_operator() * outward;
        let one = perpendicular(&normal);
        let two = normal.cross(&one);
        let (p, q) = (one.dot(&(bend * one)), two.dot(&(bend * two)));
        let r = one.dot(&(bend * two));
        let (half, mean) = (libm::hypot(0.5 * (p - q), r), 0.5 * (p + q));
        let (sin, cos) = libm::sincos(0.5 * libm::atan2(2.0 * r, p - q));
        let (large, small) = (mean + half, mean - half);
        let axes = [one * cos + two * sin, two * cos - one * sin];
        // A negative curvature with its sign reversed still gives a descent direction; a very small
        // one must not give a long step.
        let floor = 1e-10 * large.abs().max(small.abs()).max(f64::MIN_POSITIVE);
        let part =
            |axis: Vector3<f64>, bend: f64| axis * (-axis.dot(&slope) / bend.abs().max(floor));
        let descent = part(axes[0], large) + part(axes[1], small);
        let fall = (small < -1e3 * floor).then_some(axes[1]);
        let Objective { value, noise, .. } = *objective;
        Self { local, value, noise, slope, descent, fall }
    }

    fn follow(
        &self,
        step: &Vector3<f64>,
        look: impl Fn(&Vector3<f64>) -> Option<Self>,
    ) -> Option<Self> {
        let rest = self.slope.norm();
        let drop = self.slope.dot(step).abs();
        let mut share = 1.0;
        while share > 1e-8 {
            if let Some(next) = look(&(self.local.point() + step * share)) {
                // At rounding level only the gradient still shows progress.
                let level = next.value <= self.value + self.noise;
                let better = next.value < self.value - SUFFICIENT_DECREASE * share * drop;
                if better || (level && next.slope.norm() < 0.5 * rest) {
                    return Some(next);
                }
            }
            if self.fall.is_none() && drop <= self.noise {
                return None;
            }
            share *= 0.4;
        }
        None
    }
}
