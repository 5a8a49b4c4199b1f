//! One ring that slips while the shift goes straight.

/// A straight step in normalised shifts, `X = C x/(f c_z)`, from one approach to another.
#[derive(Debug, Clone, Copy)]
pub(super) struct SlipStep {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) by: [f64; 2],
    /// c_x and c_y.
    pub(super) stiffness: [f64; 2],
}

impl SlipStep {
    /// The stretch X - W at the end of the ring of a depth below both approaches, which is at its
    /// limit there, from that at the beginning.
    pub(super) fn drag(&self, stretch: [f64; 2], depth: f64) -> [f64; 2] {
        let (start, bound) = (self.from - depth, self.to - depth);
        if bound <= 0.0 {
            return [0.0; 2];
        }
        if start <= 0.0 {
            return self.touched(bound);
        }
        let growth = self.to - self.from;
        let onset = onset(stretch, self.by, start, growth);
        let at = [stretch[0] + onset * self.by[0], stretch[1] + onset * self.by[1]];
        let norm = (at[0] * at[0] + at[1] * at[1]).sqrt();
        if norm <= 0.0 {
            return self.touched(bound);
        }
        let length = (1.0 - onset) * inverse_mean(start + onset * growth, bound);
        let [cos, sin] = self.turn([at[0] / norm, at[1] / norm], length);
        [bound * cos, bound * sin]
    }

    /// The direction that tractions turn to where the limit is small.
    pub(super) fn steady(&self) -> [f64; 2] {
        let [x, y] = [self.by[0] / self.stiffness[0], self.by[1] / self.stiffness[1]];
        let norm = libm::hypot(x, y);
        [x / norm, y / norm]
    }

    // From no traction on a straight path the direction is constant (8.58): the slip l along e, with
    // X - l C e = L e, so that e ~ (L + l C)^-1 X.
    fn touched(&self, bound: f64) -> [f64; 2] {
        let [x, y] = self.by;
        let [c_x, c_y] = self.stiffness;
        let mut slip = 0.0;
        // 1/|e| is concave and growing in l: Newton's iteration rises to the root.
        for _ in 0..40 {
            let (d_x, d_y) = (bound + c_x * slip, bound + c_y * slip);
            let (e_x, e_y) = (x / d_x, y / d_y);
            let square = e_x * e_x + e_y * e_y;
            let rate = e_x * e_x * c_x / d_x + e_y * e_y * c_y / d_y;
            let change = (square.sqrt() - 1.0) * square / rate;
            slip += change;
            if change.abs() * c_x.max(c_y) <= 1e-15 * (slip * c_x.min(c_y) + bound) {
                break;
            }
        }
        let (e_x, e_y) = (x / (bound + c_x * slip), y / (bound + c_y * slip));
        let norm = libm::hypot(e_x, e_y);
        [bound * e_x / norm, bound * e_y / norm]
    }

    // The traction turns towards the direction of steady sliding (8.58):
    // dtheta/dq = G(theta) = (c_x e_x X'_y - c_y e_y X'_x + (c_y - c_x) e_x e_y L')/(e.C e), dq = ds/L.
    // Exponential steps of second order neither ring nor overshoot at the rim, where L is small.
    fn turn(&self, mut e: [f64; 2], length: f64) -> [f64; 2] {
        const LARGEST: f64 = 0.15;
        const MAX_TURNS: usize = 200;
        let [c_x, c_y] = self.stiffness;
        let [x, y] = self.by;
        let growth = self.to - self.from;
        let mut left = length;
        for _ in 0..MAX_TURNS {
            let [cos, sin] = e;
            let skew = c_y - c_x;
            let along = c_x * cos * cos + c_y * sin * sin;
            let rate = (c_x * cos * y - c_y * sin * x + skew * cos * sin * growth) / along;
            let slope = (skew * (cos * cos - sin * sin) * growth
                - (c_y * cos * x + c_x * sin * y)
                - 2.0 * rate * skew * cos * sin)
                / along;
            let mut part = if slope * left > 1.0 { 1.0 / slope } else { left };
            let mut angle = rate * part * growth_mean(slope * part);
            if angle.abs() > LARGEST {
                part = part.min(LARGEST / rate.abs());
                angle = rate * part * growth_mean(slope * part);
            }
            e = rotated(e, angle.clamp(-2.0 * LARGEST, 2.0 * LARGEST));
            left -= part;
            if left <= 0.0 {
                break;
            }
        }
        e
    }
}

// The part of the step after which |u + s by| = start + s growth.
fn onset([x, y]: [f64; 2], [p, q]: [f64; 2], start: f64, growth: f64) -> f64 {
    let room = start * start - x * x - y * y;
    if room <= 1e-14 * start * start {
        return 0.0;
    }
    // a s^2 + 2 b s - room = 0, its first root; at the end a + 2 b > room.
    let a = p * p + q * q - growth * growth;
    let b = x * p + y * q - start * growth;
    let root = (b * b + a * room).max(0.0).sqrt();
    let s = if b >= 0.0 { room / (b + root) } else { (root - b) / a };
    s.clamp(0.0, 1.0)
}

// Mean of 1/L for L linear from `low` to `high`.
fn inverse_mean(low: f64, high: f64) -> f64 {
    let (sum, difference) = (high + low, high - low);
    let u = difference / sum;
    if u.abs() > 0.1 {
        return libm::log(high / low) / difference;
    }
    let square = u * u;
    let series = 1.0 / 5.0 + square * (1.0 / 7.0 + square / 9.0);
    2.0 / sum * (1.0 + square * (1.0 / 3.0 + square * series))
}

// (exp(x) - 1)/x.
fn growth_mean(x: f64) -> f64 {
    if x.abs() > 0.05 {
        return libm::expm1(x) / x;
    }
    1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0 + x / 720.0))))
}

// By an angle of at most 0.3, through the tangent of its half.
fn rotated([cos, sin]: [f64; 2], angle: f64) -> [f64; 2] {
    let h = 0.5 * angle;
    let square = h * h;
    let t = h * (1.0 + square * (1.0 / 3.0 + square * (2.0 / 15.0 + square * 17.0 / 315.0)));
    let scale = 1.0 / (1.0 + t * t);
    let (c, s) = ((1.0 - t * t) * scale, 2.0 * t * scale);
    [c * cos - s * sin, s * cos + c * sin]
}
