//! A place on the line of anchors, and what may be left out of the line.

use super::step::SlipStep;

/// What may be left out.
#[derive(Debug, Clone, Copy)]
pub(super) struct Resolution {
    /// How far apart two vertices may be, as radii, where directions differ by more than `spread`.
    pub(super) spacing: f64,
    pub(super) spread: f64,
    /// How far a vertex that is left out may be off the line, over the limit there.
    pub(super) tolerance: f64,
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

    /// The integral of the anchors over the radius up to another.
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
    /// Whether b may be left out between a and c, with the shift `at`.
    pub(super) fn spares(
        &self,
        a: &Vertex,
        b: &Vertex,
        c: &Vertex,
        zeta: f64,
        at: [f64; 2],
    ) -> bool {
        if c.depth <= a.depth {
            return true;
        }
        let line = a.between(c, b.depth);
        let off = [line.anchor[0] - b.anchor[0], line.anchor[1] - b.anchor[1]];
        length(off) <= self.tolerance * (zeta - a.depth)
            && (c.radius - a.radius <= self.spacing || {
                let (u, w) = (direction(a, zeta, at), direction(b, zeta, at));
                length([w[0] - u[0], w[1] - u[1]]) <= self.spread
            })
    }

    /// Whether the tractions between two vertices turn away from a line in a step.
    pub(super) fn spreads(
        &self,
        a: &Vertex,
        b: &Vertex,
        zeta: f64,
        at: [f64; 2],
        step: &SlipStep,
    ) -> bool {
        let (u, w) = (direction(a, zeta, at), direction(b, zeta, at));
        let v = step.steady();
        length([w[0] - u[0], w[1] - u[1]]) > self.spread
            || length([v[0] - u[0], v[1] - u[1]]) > self.spread
    }
}

// The traction over its limit.
fn direction(vertex: &Vertex, zeta: f64, at: [f64; 2]) -> [f64; 2] {
    let bound = zeta - vertex.depth;
    if bound > 0.0 { vertex.stretch(at).map(|u| u / bound) } else { [0.0; 2] }
}

pub(super) fn dragged(vertex: &Vertex, step: &SlipStep, from: [f64; 2], to: [f64; 2]) -> Vertex {
    let stretch = step.drag(vertex.stretch(from), vertex.depth);
    Vertex { anchor: [to[0] - stretch[0], to[1] - stretch[1]], ..*vertex }
}

/// Where between a ring that sticks and one beyond its limit the limit is met.
pub(super) fn front(inside: &Vertex, outside: &Vertex, zeta: f64, to: [f64; 2]) -> Option<Vertex> {
    let (u, w) = (inside.stretch(to), outside.stretch(to));
    let du = [w[0] - u[0], w[1] - u[1]];
    let bound = zeta - inside.depth;
    let dl = inside.depth - outside.depth;
    let a = du[0] * du[0] + du[1] * du[1] - dl * dl;
    let b = u[0] * du[0] + u[1] * du[1] - bound * dl;
    let norm = length(u);
    let c = (norm - bound).min(0.0) * (norm + bound);
    let root = (b * b - a * c).max(0.0).sqrt();
    let part = if b >= 0.0 { -c / (b + root) } else { (root - b) / a };
    if !(part > 1e-9 && part < 1.0 - 1e-9) {
        return None;
    }
    let depth = inside.depth + part * (outside.depth - inside.depth);
    Some(Vertex::new(depth, [0, 1].map(|k| to[k] - (u[k] + part * du[k]))))
}

pub(super) fn length([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}
