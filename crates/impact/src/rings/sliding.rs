//! Impacts at so little friction that nothing sticks: slip follows the motion of rigid surfaces that spread.
//!
//! Where Gamma = gamma/f is large, elastic displacements by tractions are small against the slip that the
//! changing pressure causes, of the rate gamma zeta' h(rho) outwards (inwards while the bodies part),
//! `h = (2/pi) (1 - (1 - rho^2)^(1/2))/rho`. With the rates of shift and twist that is the direction of the
//! traction f p, and the mean over an angle is that of elliptic integrals.

use std::f64::consts::{FRAC_2_PI, PI};

use carom_special::AxisRatio;
use carom_special::elliptic::complete::{e, k};
use carom_special::quadrature::GaussLegendre;

use super::RingImpactError;
use super::motion::Passage;
use super::problem::Problem;
use crate::normal::{NormalImpact, compression};

/// gamma/f from which on rings are left.
const LEAST: f64 = 1000.0;
/// Steps of the velocity of approach, and points over the radius.
const STEPS: usize = 128;
const POINTS: usize = 24;
/// What displacements by tractions change in the tangential velocity over f v_z, times gamma/f over D_xx/D_zz:
/// 3 was the largest against rings at gamma/f from 25 to 250.
const ELASTIC: f64 = 4.0;
/// What steps and points leave.
const LEFT: f64 = 5e-4;

/// Means over the contact, weighted by the pressure.
struct Drag {
    /// Along the tangential velocity.
    along: f64,
    /// Of radius times the circumferential direction.
    about: f64,
    /// Of the rate of spread over gamma zeta' times its direction.
    outwards: f64,
}

/// An impact that slides, and how far off the tangential velocity may be over f v_z.
pub(super) struct Slide {
    pub(super) passage: Passage,
    pub(super) estimate: f64,
    /// Of the normal velocity, over v_z.
    pub(super) normal: f64,
}

/// The mean over the angle of the cosine between a velocity v and its sum with a velocity h of any direction:
/// `d/dv (1/(2 pi)) int |v + h| = [(v + h) E - (h - v) K]/(pi v)`, axis ratio |v - h|/(v + h).
fn mean_cosine(v: f64, h: f64) -> f64 {
    if v <= 0.0 {
        return 0.0;
    }
    let ratio = (v - h).abs() / (v + h);
    match AxisRatio::new(ratio) {
        // Vanishing: K is infinite, but not (h - v) K.
        Err(_) => FRAC_2_PI,
        Ok(ratio) => ((v + h) * e(ratio) - (h - v) * k(ratio)) / (PI * v),
    }
}

/// The weights and `(1 - rho^2)^(1/2)` of points over the radius.
struct Points(GaussLegendre);

impl Points {
    /// The drag at a tangential velocity, the rate of spread gamma zeta' and the circumferential velocity of the
    /// rim.
    fn drag(&self, velocity: f64, spread: f64, rim: f64) -> Drag {
        let mut drag = Drag { along: 0.0, about: 0.0, outwards: 0.0 };
        for node in self.0.on(0.0, 1.0) {
            let height: f64 = node.position;
            let rho = ((1.0 - height) * (1.0 + height)).sqrt();
            let unit = FRAC_2_PI * (1.0 - height) / rho;
            let outwards = spread * unit;
            let around = rim * rho;
            let other = outwards.hypot(around);
            let weight = 3.0 * node.weight * height * height;
            drag.along += weight * mean_cosine(velocity, other);
            if other > 0.0 {
                let mean = weight / other * mean_cosine(other, velocity);
                drag.about += mean * rho * around;
                drag.outwards += mean * unit * outwards;
            }
        }
        drag
    }
}

impl Problem {
    /// The impact if nothing sticks; none where elastic displacements matter.
    pub(super) fn slide(&self) -> Result<Option<Slide>, RingImpactError> {
        let (friction, gamma) = (self.friction.get(), self.constants.gamma.abs());
        if self.spread() < LEAST || gamma == 0.0 {
            return Ok(None);
        }
        let [along, across, about] = self.motion.mobility;
        let [speed, xi, eta, omega] = self.motion.before;
        let normal = NormalImpact::new(along, self.constants.c_z, speed)?;
        let points = Points(GaussLegendre::new(POINTS)?);
        let rim =
            |w: f64| self.constants.radius * (normal.maximal_approach() * compression(w)).sqrt();
        // What friction changes while the velocity of approach falls by one step.
        let change = |w: f64, [velocity, spin]: [f64; 2]| {
            let drag = points.drag(velocity.abs(), gamma * speed * w.abs(), rim(w) * spin.abs());
            let push = 2.0 * friction * speed / (along * STEPS as f64);
            let slowed = push * across * drag.along;
            let untwisted = push * about * rim(w) * drag.about;
            // What the spread takes of the square of the velocity of approach.
            let taken = 4.0 * friction * gamma * w.abs() * drag.outwards / STEPS as f64;
            [slowed.copysign(velocity), untwisted.copysign(spin), taken]
        };
        let mut now = [xi.hypot(eta), omega];
        let (before, mut left) = (now, 1.0);
        for step in 0..STEPS {
            let w = 1.0 - (2 * step + 1) as f64 / STEPS as f64;
            let first = change(w, now);
            let middle = [now[0] - 0.5 * first[0], now[1] - 0.5 * first[1]];
            let change = change(w, middle);
            now = [now[0] - change[0], now[1] - change[1]];
            left -= change[2];
        }
        let part = if before[0] > 0.0 { now[0] / before[0] } else { 0.0 };
        let passage = Passage {
            after: [-speed * left.max(0.0).sqrt(), part * xi, part * eta, now[1]],
            duration: normal.duration(),
            maximal_approach: normal.maximal_approach(),
            maximal_force: normal.maximal_force(),
            compressions: 1,
        };
        // Displacements matter where the way of slip turns with the spread.
        let reach = 2.0 * before[0] / (gamma * speed);
        let elastic = ELASTIC * across / (along * self.spread() * (1.0 + reach.powi(4)));
        Ok(Some(Slide { passage, estimate: elastic + LEFT, normal: friction * friction }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_cosine_is_that_over_all_directions() {
        let count = 100_000;
        for [v, h] in
            [[1.0, 0.3], [0.3, 1.0], [2.0, 2.0], [1.0, 1.0 + 1e-9], [1.0, 0.0], [1.0, 50.0]]
        {
            let cosine = |i: i32| {
                let (sine, cosine) = (2.0 * PI * (f64::from(i) + 0.5) / f64::from(count)).sin_cos();
                (v + h * cosine) / (v + h * cosine).hypot(h * sine)
            };
            let mean = (0..count).map(cosine).sum::<f64>() / f64::from(count);
            assert!((mean_cosine(v, h) - mean).abs() < 1e-8, "{v} {h}: {mean}");
        }
    }
}
