//! Complete adhesion in closed form (section 9.2).
//!
//! With the normal velocity w as clock the tangential velocity u of an adhering contact obeys
//! Gegenbauer's equation `(1 - w^2) u'' - (6/5) w u' + (6/5) chi u = 0`, equivalent to (9.14) by
//! S = 1 - w^2. The traction is `Phi = zeta^(3/2) u' / chi`. Local power series carry it.

/// Terms a series may have; a third of the radius of convergence needs about 35.
const MAX_TERMS: usize = 80;

/// Share of the distance to the singular point w = 1 that one series covers.
const REACH: f64 = 0.4;

/// Tangential velocity and its derivative by w at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Tangential {
    pub(super) velocity: f64,
    pub(super) gradient: f64,
}

/// The solution on `low <= w <= high` as a power series about `center`.
#[derive(Debug, Clone)]
pub(super) struct Segment {
    center: f64,
    pub(super) low: f64,
    pub(super) high: f64,
    blocks: usize,
    velocity: [[f64; 4]; MAX_TERMS / 4],
    gradient: [[f64; 4]; MAX_TERMS / 4],
}

impl Segment {
    /// Adhesion from first touch (w = 1) with velocity 1: regular there, so one series serves.
    pub(super) fn from_touch(chi: f64) -> Self {
        let center = 0.5;
        Self::expand(chi, center, regular_at_touch(chi, center), 0.0, 1.0)
    }

    /// Adhesion that begins at `w` in (0, 1) with the state `now`; covers part of the way to 0.
    pub(super) fn from_state(chi: f64, w: f64, now: Tangential) -> Self {
        let low = (w - REACH * (1.0 - w)).max(0.0);
        Self::expand(chi, w, now, low, w)
    }

    fn expand(chi: f64, center: f64, now: Tangential, low: f64, high: f64) -> Self {
        let reach = (center - low).max(high - center);
        let mut c = [0.0; MAX_TERMS];
        (c[0], c[1]) = (now.velocity, now.gradient);
        let inverse = 1.0 / ((1.0 - center) * (1.0 + center));
        let (mut power, mut largest) = (reach, c[0].abs().max(c[1].abs() * reach));
        let mut terms = MAX_TERMS;
        for k in 0..MAX_TERMS - 2 {
            let n = k as f64;
            // (1 - c^2)(k+1)(k+2) c_{k+2} = c (k+1)(2k + 6/5) c_{k+1} + (k (k - 1 + 6/5) - 6/5 chi) c_k
            let next = center * (n + 1.0) * (2.0 * n + 1.2) * c[k + 1]
                + (n * (n + 0.2) - 1.2 * chi) * c[k];
            c[k + 2] = next * inverse / ((n + 1.0) * (n + 2.0));
            power *= reach;
            let size = (n + 2.0) * (c[k + 2].abs() + c[k + 1].abs() / reach) * power;
            largest = largest.max(c[k + 2].abs() * power);
            if size < 1e-17 * largest {
                terms = k + 3;
                break;
            }
        }
        let mut velocity = [[0.0; 4]; MAX_TERMS / 4];
        let mut gradient = velocity;
        for k in 0..terms.min(MAX_TERMS - 1) {
            velocity[k / 4][k % 4] = c[k];
            gradient[k / 4][k % 4] = (k as f64 + 1.0) * c[k + 1];
        }
        Self { center, low, high, blocks: terms.div_ceil(4), velocity, gradient }
    }

    /// Velocity and gradient at `w`.
    pub(super) fn at(&self, w: f64) -> Tangential {
        // Four interleaved series in x^4: a short chain of dependent operations.
        let x = w - self.center;
        let squared = x * x;
        let fourth = squared * squared;
        let (mut velocity, mut gradient) = ([0.0; 4], [0.0; 4]);
        for (c, g) in self.velocity[..self.blocks].iter().zip(&self.gradient[..self.blocks]).rev() {
            for lane in 0..4 {
                velocity[lane] = velocity[lane] * fourth + c[lane];
                gradient[lane] = gradient[lane] * fourth + g[lane];
            }
        }
        let join = |v: [f64; 4]| (v[0] + v[1] * x) + (v[2] + v[3] * x) * squared;
        Tangential { velocity: join(velocity), gradient: join(gradient) }
    }

    /// The second derivative by w, from the differential equation.
    pub(super) fn curvature(&self, chi: f64, w: f64) -> f64 {
        let now = self.at(w);
        (1.2 * w * now.gradient - 1.2 * chi * now.velocity) / ((1.0 - w) * (1.0 + w))
    }
}

// u = F(-n, n + 1/5; 3/5; z), z = (1 - w)/2, n (n + 1/5) = 6 chi/5: the regular solution with u(1) = 1.
fn regular_at_touch(chi: f64, w: f64) -> Tangential {
    let z = 0.5 * (1.0 - w);
    let (mut term, mut velocity, mut slope, mut k) = (1.0, 1.0, 0.0, 0.0);
    loop {
        let ratio = (k * (k + 0.2) - 1.2 * chi) / ((k + 0.6) * (k + 1.0));
        slope += (k + 1.0) * ratio * term;
        term *= ratio * z;
        velocity += term;
        k += 1.0;
        let settled = k * k > 2.4 * chi && (k + 1.0) * term.abs() < 1e-18;
        if settled {
            return Tangential { velocity, gradient: -0.5 * slope };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chi_one_is_a_straight_line() {
        // n = 1: u = w.
        let segment = Segment::from_touch(1.0);
        for i in 0..=10 {
            let w = 0.1 * f64::from(i);
            assert!((segment.at(w).velocity - w).abs() < 4e-16);
            assert!((segment.at(w).gradient - 1.0).abs() < 4e-15);
        }
    }

    #[test]
    fn restarted_series_continue_the_solution() {
        for chi in [0.5, 3.5, 6.5, 60.0] {
            let whole = Segment::from_touch(chi);
            let part = Segment::from_state(chi, 0.9, whole.at(0.9));
            let scale = whole.at(part.low).gradient.abs().max(1.0);
            let (a, b) = (whole.at(part.low), part.at(part.low));
            assert!((a.velocity - b.velocity).abs() < 1e-13 * scale, "{chi}");
            assert!((a.gradient - b.gradient).abs() < 1e-12 * scale, "{chi}");
        }
    }

    #[test]
    fn gegenbauer_equation_holds() {
        let (chi, h) = (2.9, 1e-4);
        let segment = Segment::from_touch(chi);
        for w in [0.1, 0.5, 0.9] {
            let difference = (segment.at(w + h).gradient - segment.at(w - h).gradient) / (2.0 * h);
            assert!((difference - segment.curvature(chi, w)).abs() < 1e-6);
        }
    }
}
