//! A traction that meets its limit and turns along it while the shift goes straight.

/// The direction e of a traction at its limit after the slip of a straight step: it turns towards that of
/// steady sliding (8.58), with the springs' pull `by` and the limit's `growth` over the step,
/// `dtheta/dq = (c_x e_x by_y - c_y e_y by_x + (c_y - c_x) e_x e_y growth)/(e.C e)`, dq = ds/L up to
/// `length`. Exponential steps of second order neither ring nor overshoot at the rim, where L is small.
pub(super) fn turned(
    mut e: [f64; 2],
    length: f64,
    stiffness: [f64; 2],
    by: [f64; 2],
    growth: f64,
) -> [f64; 2] {
    const LARGEST: f64 = 0.15;
    const MAX_TURNS: usize = 200;
    let [c_x, c_y] = stiffness;
    let [x, y] = by;
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

/// The part of the step after which a traction meets its limit: |u + s by| = start + s growth.
pub(super) fn onset([x, y]: [f64; 2], [p, q]: [f64; 2], start: f64, growth: f64) -> f64 {
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

/// Mean of 1/L for L linear from `low` to `high`.
pub(super) fn inverse_mean(low: f64, high: f64) -> f64 {
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
