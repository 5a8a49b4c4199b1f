//! The rotation of a traction at its limit while the shift follows a straight path.

/// The direction e of a traction at its limit after the slip of a straight step. By (8.56) it
/// rotates towards that of steady sliding (8.58), with the springs' pull `by` and the limit's
/// `growth` over the step, `dtheta/dq = (c_x e_x by_y - c_y e_y by_x + (c_y - c_x) e_x e_y
/// growth)/(e.C e)`, dq = ds/L up to `length`. Exponential integrators neither oscillate nor
/// overshoot at the edge, where L is small. One step of the contact may take an annulus through a
/// whole thin slip annulus; the integrators are therefore of order three or four, each with an
/// error of about `accurate`, in radians.
#[inline]
pub(super) fn turned(e: [f64; 2], length: f64, pull: &Pull, accurate: f64) -> [f64; 2] {
    const MAX_TURNS: usize = 4000;
    let (mut e, mut left) = (e, length);
    for _ in 0..MAX_TURNS {
        let (angle, part) = pull.turn(e, left, accurate);
        e = rotated(e, angle);
        left -= part;
        if left <= 0.0 {
            break;
        }
    }
    e
}

/// The terms that rotate a traction at its limit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pull {
    pub(super) stiffness: [f64; 2],
    pub(super) by: [f64; 2],
    pub(super) growth: f64,
}

impl Pull {
    // dtheta/dq and its derivative with respect to theta.
    fn rate(&self, [cos, sin]: [f64; 2]) -> (f64, f64) {
        let ([c_x, c_y], [x, y]) = (self.stiffness, self.by);
        let skew = c_y - c_x;
        let along = 1.0 / (c_x * cos * cos + c_y * sin * sin);
        let rate = (c_x * cos * y - c_y * sin * x + skew * cos * sin * self.growth) * along;
        let slope = (skew * (cos * cos - sin * sin) * self.growth
            - (c_y * cos * x + c_x * sin * y)
            - 2.0 * rate * skew * cos * sin)
            * along;
        (rate, slope)
    }

    // One step of at most this length: the angle, and the length covered. Exponential Rosenbrock
    // methods (Hochbruck and Ostermann 2010): exprb32 if its correction is small, otherwise
    // exprb43.
    #[inline]
    fn turn(&self, e: [f64; 2], left: f64, accurate: f64) -> (f64, f64) {
        const LARGEST: f64 = 0.3;
        // Farther from its limit a stiff step would be too coarse.
        const NEAR: f64 = 1e-3;
        let (rate, slope) = self.rate(e);
        let stiff = slope.abs() * left;
        let near = slope < 0.0 && rate.abs() < NEAR * slope.abs();
        let mut h = match slope > 0.0 {
            true if stiff > 1.0 => 1.0 / slope,
            false if stiff > 2.0 && !near => -2.0 / slope,
            _ => left,
        };
        loop {
            let whole = Means::of(slope * h);
            let first = h * whole.one * rate;
            if first.abs() > LARGEST {
                h *= (0.9 * LARGEST / first.abs()).max(0.1);
                continue;
            }
            let more = |angle: f64| h * (self.rate(rotated(e, angle)).0 - rate - slope * angle);
            let correction = 2.0 * whole.three * more(first);
            if correction.abs() <= accurate {
                return (first + correction, h);
            }
            let half = Means::of(0.5 * slope * h);
            let d_2 = more((0.5 * h * half.one * rate).clamp(-LARGEST, LARGEST));
            let d_3 = more((first + whole.one * d_2).clamp(-LARGEST, LARGEST));
            let correction = whole.four * (12.0 * d_3 - 48.0 * d_2);
            if correction.abs() > 10.0 * accurate {
                h *= 0.5;
                continue;
            }
            let angle = first + whole.three * (16.0 * d_2 - 2.0 * d_3) + correction;
            return (angle.clamp(-LARGEST, LARGEST), h);
        }
    }
}

/// phi_1, phi_3 and phi_4, `phi_k(z) = z phi_(k+1)(z) + 1/k!`, phi_0 = exp.
struct Means {
    one: f64,
    three: f64,
    four: f64,
}

impl Means {
    fn of(z: f64) -> Self {
        if z.abs() > 0.5 {
            let one = libm::expm1(z) / z;
            let three = ((one - 1.0) / z - 0.5) / z;
            return Self { one, three, four: (three - 1.0 / 6.0) / z };
        }
        // Sum of z^k/(k + 4)!.
        const TERMS: [f64; 8] = [
            1.0 / 24.0,
            1.0 / 120.0,
            1.0 / 720.0,
            1.0 / 5040.0,
            1.0 / 40320.0,
            1.0 / 362_880.0,
            1.0 / 3_628_800.0,
            1.0 / 39_916_800.0,
        ];
        let four = TERMS.iter().rev().fold(0.0, |sum, term| sum * z + term);
        let three = z * four + 1.0 / 6.0;
        Self { one: z * (z * three + 0.5) + 1.0, three, four }
    }
}

/// The fraction of the step after which a traction exceeds its limit, |u + s by| = start + s
/// growth, given that it does so at the end. A traction that starts at its limit may first fall
/// below it.
pub(super) fn onset([x, y]: [f64; 2], [p, q]: [f64; 2], start: f64, growth: f64) -> f64 {
    let room = (start * start - x * x - y * y).max(0.0);
    // a s^2 + 2 b s - room = 0, its first positive root; at the end a + 2 b > room.
    let a = p * p + q * q - growth * growth;
    let b = x * p + y * q - start * growth;
    let root = (b * b + a * room).max(0.0).sqrt();
    let s = match b >= 0.0 {
        true if b + root == 0.0 => 0.0,
        true => room / (b + root),
        false => (root - b) / a,
    };
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

// By an angle of at most 0.3, through the tangent of its half.
fn rotated([cos, sin]: [f64; 2], angle: f64) -> [f64; 2] {
    let h = 0.5 * angle;
    let square = h * h;
    let t = h * (1.0 + square * (1.0 / 3.0 + square * (2.0 / 15.0 + square * 17.0 / 315.0)));
    let scale = 1.0 / (1.0 + t * t);
    let (c, s) = ((1.0 - t * t) * scale, 2.0 * t * scale);
    [c * cos - s * sin, s * cos + c * sin]
}
