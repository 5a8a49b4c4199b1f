//! Independent sliders, advanced by small straight steps: a reference for Coulomb's law that can be refined
//! at will. It shares no code with the laws.

/// Rings of equal stiffness, their touch at the squares of equally spaced roots.
pub(crate) struct Rings {
    zeta: f64,
    x: [f64; 2],
    spacing: f64,
    anchors: Vec<[f64; 2]>,
}

impl Rings {
    pub(crate) fn new(count: usize, deepest: f64) -> Self {
        let spacing = deepest.sqrt() / count as f64;
        Self { zeta: 0.0, x: [0.0; 2], spacing, anchors: vec![[0.0; 2]; count] }
    }

    fn root(&self, ring: usize) -> f64 {
        (ring as f64 + 0.5) * self.spacing
    }

    /// A straight step, exactly.
    pub(crate) fn advance(&mut self, zeta: f64, x: [f64; 2]) -> [f64; 2] {
        self.each(zeta, x, exact)
    }

    /// A step of implicit Euler: the anchor is projected onto the limit at the end.
    pub(crate) fn project(&mut self, zeta: f64, x: [f64; 2]) -> [f64; 2] {
        self.each(zeta, x, |anchor, _, _, to, limit| {
            let arm = [to[0] - anchor[0], to[1] - anchor[1]];
            let part = limit / arm[0].hypot(arm[1]);
            [to[0] - arm[0] * part, to[1] - arm[1] * part]
        })
    }

    fn each(
        &mut self,
        zeta: f64,
        x: [f64; 2],
        drag: impl Fn([f64; 2], [f64; 2], f64, [f64; 2], f64) -> [f64; 2],
    ) -> [f64; 2] {
        for ring in 0..self.anchors.len() {
            let root = self.root(ring);
            let depth = root * root;
            if depth >= zeta {
                break;
            }
            let (mut from, mut limit) = (self.x, self.zeta - depth);
            if limit <= 0.0 {
                let part = (depth - self.zeta) / (zeta - self.zeta);
                from = [0, 1].map(|k| self.x[k] + part * (x[k] - self.x[k]));
                (self.anchors[ring], limit) = (from, 0.0);
            }
            let anchor = self.anchors[ring];
            if (x[0] - anchor[0]).hypot(x[1] - anchor[1]) > zeta - depth {
                self.anchors[ring] = drag(anchor, from, limit, x, zeta - depth);
            }
        }
        (self.zeta, self.x) = (zeta, x);
        self.force()
    }

    pub(crate) fn force(&self) -> [f64; 2] {
        let edge = self.zeta.max(0.0).sqrt();
        let mut sum = [0.0; 2];
        for (ring, anchor) in self.anchors.iter().enumerate() {
            let root = self.root(ring);
            if root >= edge {
                break;
            }
            let width = (edge - root + 0.5 * self.spacing).min(self.spacing);
            for k in 0..2 {
                sum[k] += 1.5 * width * (self.x[k] - anchor[k]);
            }
        }
        sum
    }
}

/// The anchor of a ring that slips at the end of a straight step: along the step until the limit,
/// which is linear in time, is met, then on a tractrix, in the vector form of its solution.
pub(crate) fn exact(
    anchor: [f64; 2],
    from: [f64; 2],
    start: f64,
    to: [f64; 2],
    end: f64,
) -> [f64; 2] {
    let step = [to[0] - from[0], to[1] - from[1]];
    let at = |t: f64| [0, 1].map(|k| from[k] + t * step[k] - anchor[k]);
    // |x - w| - limit is convex and positive at the end: Newton's method falls to its last root.
    let mut t = 1.0;
    for _ in 0..50 {
        let arm = at(t);
        let length = arm[0].hypot(arm[1]);
        let value = length - start - t * (end - start);
        let rate = (arm[0] * step[0] + arm[1] * step[1]) / length - (end - start);
        if value <= 1e-17 || rate <= 0.0 || t <= 0.0 || length == 0.0 {
            break;
        }
        t = (t - value / rate).max(0.0);
    }
    let way = (1.0 - t) * step[0].hypot(step[1]);
    let arm = at(t);
    let length = arm[0].hypot(arm[1]);
    let size = step[0].hypot(step[1]);
    if size == 0.0 {
        return [0, 1].map(|k| to[k] - arm[k] * (end / length));
    }
    let ahead = step.map(|v| v / size);
    let met = start + t * (end - start);
    if met <= 0.0 || length == 0.0 {
        return [0, 1].map(|k| to[k] - ahead[k] * end);
    }
    let m = arm.map(|v| v / length);
    let cos = m[0] * ahead[0] + m[1] * ahead[1];
    let change = end - met;
    let rate = if change.abs() < 1e-9 * met {
        way / met * (1.0 - 0.5 * change / met)
    } else {
        way * (end / met).ln() / change
    };
    let shrunk = (-rate).exp();
    let square = shrunk * shrunk;
    // The halves 1 + cos and 1 - cos, each from the side that keeps its digits.
    let sum = [0, 1].map(|k| m[k] + ahead[k]);
    let difference = [0, 1].map(|k| m[k] - ahead[k]);
    let near = 0.5 * (sum[0] * sum[0] + sum[1] * sum[1]);
    let far = 0.5 * (difference[0] * difference[0] + difference[1] * difference[1]);
    let both = near + far * square;
    if both == 0.0 {
        return [0, 1].map(|k| to[k] - m[k] * end);
    }
    let forward = (near - far * square) / both;
    let aside = 2.0 * shrunk / both;
    [0, 1].map(|k| to[k] - end * (forward * ahead[k] + aside * (m[k] - cos * ahead[k])))
}

/// The force over its limit at the end of a path, of that many rings.
pub(crate) fn force_at_end(path: &[(f64, [f64; 2])], count: usize) -> [f64; 2] {
    let (zeta, x) = path[path.len() - 1];
    let spacing = zeta.sqrt() / count as f64;
    let mut sum = [0.0; 2];
    for ring in 0..count {
        let root = (ring as f64 + 0.5) * spacing;
        let anchor = anchor_at_end(path, root * root);
        for k in 0..2 {
            sum[k] += 1.5 * spacing * (x[k] - anchor[k]);
        }
    }
    sum.map(|force| force / (zeta * zeta.sqrt()))
}

/// The anchor of the ring of a depth at the end of a path in contact.
fn anchor_at_end(path: &[(f64, [f64; 2])], depth: f64) -> [f64; 2] {
    let (mut zeta, mut x) = (0.0, [0.0; 2]);
    let mut anchor = [0.0; 2];
    for &(to, end) in path {
        if depth < to {
            let (mut from, mut limit) = (x, zeta - depth);
            if limit <= 0.0 {
                let part = (depth - zeta) / (to - zeta);
                from = [0, 1].map(|k| x[k] + part * (end[k] - x[k]));
                (anchor, limit) = (from, 0.0);
            }
            if (end[0] - anchor[0]).hypot(end[1] - anchor[1]) > to - depth {
                anchor = exact(anchor, from, limit, end, to - depth);
            }
        }
        (zeta, x) = (to, end);
    }
    anchor
}
