//! A vertex on the line of anchors, and the criterion for leaving it out.

use super::super::ring::SlipStep;

/// A vertex may be left out if the area between the anchors over the radius and a straight line is
/// at most this.
///
/// The area times f c_z is the change of the force; the width of a slip annulus does not matter.
#[derive(Debug, Clone, Copy)]
pub(super) struct Resolution {
    pub(super) area: f64,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Vertex {
    pub(super) depth: f64,
    pub(super) radius: f64,
    pub(super) anchor: [f64; 2],
}

impl Vertex {
    pub(super) fn new(depth: f64, anchor: [f64; 2]) -> Self {
        Self { depth, radius: depth.sqrt(), anchor }
    }

    pub(super) fn between(&self, other: &Self, depth: f64) -> Self {
        let part = (depth - self.depth) / (other.depth - self.depth);
        Self::new(depth, [0, 1].map(|k| self.anchor[k] + part * (other.anchor[k] - self.anchor[k])))
    }

    /// The integral of the anchors over the radius from this vertex to another.
    pub(super) fn integral(&self, other: &Self) -> [f64; 2] {
        let sum = other.radius + self.radius;
        let unit = if sum > 0.0 { (other.radius - self.radius) / (3.0 * sum) } else { 0.0 };
        let here = unit * (2.0 * other.radius + self.radius);
        let there = unit * (other.radius + 2.0 * self.radius);
        [0, 1].map(|k| here * self.anchor[k] + there * other.anchor[k])
    }

    pub(super) fn stretch(&self, at: [f64; 2]) -> [f64; 2] {
        [at[0] - self.anchor[0], at[1] - self.anchor[1]]
    }
}

impl Resolution {
    /// This fraction of the resolution.
    pub(super) const fn finer(&self, part: f64) -> Self {
        Self { area: part * self.area }
    }

    /// Whether b may be left out between a and c.
    pub(super) fn spares(&self, a: &Vertex, b: &Vertex, c: &Vertex) -> bool {
        if c.depth <= a.depth {
            return true;
        }
        let line = a.between(c, b.depth);
        let off = [line.anchor[0] - b.anchor[0], line.anchor[1] - b.anchor[1]];
        0.5 * length(off) * (c.radius - a.radius) <= self.area
    }

    /// Whether the tractions of two annuli at their limits rotated so differently that the annuli
    /// between them are not on the straight line.
    pub(super) fn bends(&self, a: &Slipped, b: &Slipped) -> bool {
        let [x, y] = [a.direction[0] - b.direction[0], a.direction[1] - b.direction[1]];
        // Where the limit vanishes the direction of the traction is arbitrary.
        let turn = if b.limit > 0.0 { x * x + y * y } else { 1.0 };
        let limit = 0.5 * (a.limit + b.limit);
        limit * turn * (b.after.radius - a.after.radius) > 16.0 * self.area
    }
}

/// An annulus at its limit after a step, and the direction of its traction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slipped {
    pub(super) after: Vertex,
    pub(super) limit: f64,
    pub(super) direction: [f64; 2],
}

impl Slipped {
    /// An annulus dragged by the step from the shift `from` to the shift `to`.
    pub(super) fn dragged(vertex: &Vertex, step: &SlipStep, from: [f64; 2], to: [f64; 2]) -> Self {
        let stretch = step.drag(vertex.stretch(from), vertex.depth);
        let after = Vertex { anchor: [to[0] - stretch[0], to[1] - stretch[1]], ..*vertex };
        Self::at(after, step, to)
    }

    /// An annulus that reaches its limit at the end of the step.
    pub(super) fn at(after: Vertex, step: &SlipStep, to: [f64; 2]) -> Self {
        let limit = (step.to - after.depth).max(0.0);
        let norm = length(after.stretch(to));
        let direction = if norm > 0.0 { after.stretch(to).map(|u| u / norm) } else { [0.0; 2] };
        Self { after, limit, direction }
    }
}

/// The depth at which the limit is reached, between an annulus that sticks and one beyond its
/// limit.
///
/// Computed from the slipping annulus, to avoid cancellation where the slipping part is thin.
pub(super) fn front(inside: &Vertex, outside: &Vertex, zeta: f64, to: [f64; 2]) -> Option<Vertex> {
    let (u, w) = (inside.stretch(to), outside.stretch(to));
    let rise = [u[0] - w[0], u[1] - w[1]];
    let length = outside.depth - inside.depth;
    let limit = zeta - outside.depth;
    // |w + t rise|^2 = (limit + t length)^2, the first t above zero.
    let curve = rise[0] * rise[0] + rise[1] * rise[1] - length * length;
    let slope = w[0] * rise[0] + w[1] * rise[1] - limit * length;
    let norm = self::length(w);
    let excess = (norm - limit).max(0.0) * (norm + limit);
    let root = (slope * slope - curve * excess).max(0.0).sqrt();
    let part = if slope <= 0.0 { excess / (root - slope) } else { (slope + root) / -curve };
    // If almost nothing slips, the depth is that of the sticking annulus.
    if part.is_nan() || part >= 1.0 - 1e-9 {
        return None;
    }
    let depth = outside.depth - part * length;
    // However thin the slipping part is, the rest of the line stays unchanged.
    let depth = match depth == outside.depth {
        true if length > 0.0 => depth.next_down(),
        true => depth.next_up(),
        false => depth,
    };
    let apart = depth != inside.depth && depth != outside.depth;
    apart.then(|| Vertex::new(depth, [0, 1].map(|k| to[k] - (w[k] + part * rise[k]))))
}

pub(super) fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}
