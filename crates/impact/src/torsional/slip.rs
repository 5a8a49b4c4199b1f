//! The torque in partial slip: the stored adhesive motion inside the stick radius, Lubkin's
//! solution outside it (10.25).

use std::f64::consts::FRAC_2_PI;

use carom_laws::torsion::lubkin::Lubkin;
use carom_special::AxisRatio;
use carom_special::elliptic::complete;

use super::adhesion::Adhesion;

/// Largest ln(a/a*): beyond it the torque of the stick area is below round-off.
const MAX_LOG_DEPTH: f64 = 40.0;

/// Relative accuracy of the depth; the error of the torque is its square.
const DEPTH_ACCURACY: f64 = 1e-7;

/// Response of the contact to a twist.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Answer {
    /// Torque mu/Omega.
    pub(super) torque: f64,
    /// The stick radius c; 0 once the whole contact slips.
    pub(super) stick: f64,
}

/// The contact after the onset of slip.
#[derive(Debug, Clone)]
pub(super) struct SlippingContact<'a> {
    omega: f64,
    history: &'a Adhesion,
    sign: f64,
    /// The last solutions: normal velocity and depth.
    known: [(f64, f64); 3],
}

impl<'a> SlippingContact<'a> {
    pub(super) fn new(omega: f64, history: &'a Adhesion) -> Self {
        Self { omega, history, sign: history.slip_sign(), known: [(f64::NAN, 0.0); 3] }
    }

    /// The sign of the slip.
    pub(super) fn sign(&self) -> f64 {
        self.sign
    }

    /// Torque and stick radius at the contact radius `al`, normal velocity `w` and twist `x`.
    ///
    /// Solves `s Omega (x - x_st(c)) = (2/pi) al (K - E)` for c. The torque is stationary in c
    /// there, up to c^3 times the residual, which is added: half the digits of c suffice.
    pub(super) fn answer(&mut self, al: f64, w: f64, x: f64) -> Answer {
        if al <= 0.0 {
            return Answer { torque: 0.0, stick: 0.0 };
        }
        let outermost = (al / self.history.onset()).max(1.0);
        let (mut low, mut high) = (libm::log(outermost), MAX_LOG_DEPTH);
        if self.excess(al, w, x, high).value > 0.0 {
            let torque = self.sign * 0.5 * SLIDING * al.powi(4) / self.omega;
            return Answer { torque, stick: 0.0 };
        }
        let mut depth = self.guess(w).clamp(low, high);
        loop {
            let point = self.excess(al, w, x, depth);
            // The excess decreases with the depth.
            if point.value > 0.0 {
                low = depth;
            } else {
                high = depth;
            }
            let newton = depth + point.value / point.slope;
            let next = if newton >= low && newton <= high { newton } else { 0.5 * (low + high) };
            let moved = (next - depth).abs();
            if moved <= DEPTH_ACCURACY * depth || high - low <= 1e-15 {
                self.known = [self.known[1], self.known[2], (w, depth)];
                return self.torque_at(al, &point);
            }
            depth = next;
        }
    }

    // Extrapolates the last solutions by a parabola.
    fn guess(&self, w: f64) -> f64 {
        let [(w0, d0), (w1, d1), (w2, d2)] = self.known;
        let (first, second) = ((d1 - d0) / (w1 - w0), (d2 - d1) / (w2 - w1));
        let curve = (second - first) / (w2 - w0);
        let guess = d2 + (w - w2) * (second + curve * (w - w1));
        if guess.is_finite() { guess } else { d2 }
    }

    fn excess(&self, al: f64, w: f64, x: f64, depth: f64) -> Excess {
        let ratio = libm::exp(-depth);
        let parameter = -libm::expm1(-2.0 * depth);
        // The axis ratio is in (0, 1] and therefore valid.
        let axes = AxisRatio::new(ratio).unwrap_or(AxisRatio::CIRCLE);
        let stick = (ratio * al).min(self.history.onset());
        // w when the edge passed c, without cancellation near maximum compression:
        // w_c^2 = w^2 + al^5 (1 - (c/al)^5).
        let then = (w * w - (1.0 - w * w) * libm::expm1(-5.0 * depth)).sqrt();
        let stored = self.history.at(stick, then);
        let sliding = FRAC_2_PI * al * parameter * complete::d(axes); // (5.39)
        let value = self.sign * self.omega * (x - stored.twist) - sliding;
        let density = self.sign * self.history.density(stick, then, &stored);
        let slope = FRAC_2_PI * al * complete::e(axes) - stick * density;
        Excess { ratio, stick, stored_torque: stored.torque, value, slope }
    }

    fn torque_at(&self, al: f64, point: &Excess) -> Answer {
        let c = point.stick;
        let ring = Lubkin::at_stick_radius(point.ratio).map_or(0.0, |lubkin| lubkin.torque());
        let slipping = 0.5 * al.powi(4) * ring + c * c * c * point.value;
        Answer { torque: point.stored_torque + self.sign * slipping / self.omega, stick: c }
    }
}

const SLIDING: f64 = carom_laws::torsion::lubkin::SLIDING_TORQUE;

/// `s Omega (x - x_st(c)) - B(c; al)` and minus its slope in the depth ln(al/c).
struct Excess {
    ratio: f64,
    stick: f64,
    stored_torque: f64,
    value: f64,
    slope: f64,
}
