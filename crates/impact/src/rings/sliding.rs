//! Impacts with so little friction that nothing sticks: slip follows from the motion of rigid surfaces with
//! the radial displacement by pressure.
//!
//! Where gamma/f is large, elastic displacements by tractions are small compared with the slip that the
//! changing pressure causes. Its rate is gamma zeta' h(rho), outwards (inwards in restitution), `h = (2/pi)
//! (1 - (1 - rho^2)^(1/2))/rho`. Together with the rates of shift and twist it gives the direction of the
//! traction f p; the mean over the angle is given by elliptic integrals.

use std::f64::consts::{FRAC_2_PI, PI};

use carom_special::AxisRatio;
use carom_special::elliptic::complete::{e, k};
use carom_special::quadrature::GaussLegendre;

use super::RingImpactError;
use super::motion::Passage;
use super::problem::Problem;
use crate::normal::{NormalImpact, compression};

/// gamma/f from which this solution replaces the rings.
const LEAST: f64 = 1000.0;
/// Number of steps of the normal velocity, and of points over the radius.
const STEPS: usize = 128;
const POINTS: usize = 24;
/// Effect of displacements by tractions on the tangential velocity over f v_z, times gamma/f over D_xx/D_zz:
/// the largest found was 3, against rings with gamma/f from 25 to 250.
const ELASTIC: f64 = 4.0;
/// Error of steps and points.
const LEFT: f64 = 5e-4;

/// Means over the contact, weighted by the pressure, of the direction of slip.
struct Drag {
    /// Component along the tangential velocity.
    along: f64,
    /// Radius times the circumferential component.
    about: f64,
    /// Component along the radial displacement, weighted by its rate over gamma zeta'.
    outwards: f64,
}

/// A sliding impact, and its estimated error of the tangential velocity over f v_z.
pub(super) struct Slide {
    pub(super) passage: Passage,
    pub(super) estimate: f64,
    /// Error of the normal velocity, over v_z.
    pub(super) normal: f64,
}

/// The mean, over the direction of a velocity h, of the cosine between a velocity v and v + h: `d/dv (1/(2
/// pi)) int |v + h| = [(v + h) E - (h - v) K]/(pi v)`, axis ratio |v - h|/(v + h).
fn mean_cosine(v: f64, h: f64) -> f64 {
    if v <= 0.0 {
        return 0.0;
    }
    let ratio = (v - h).abs() / (v + h);
    match AxisRatio::new(ratio) {
        // For an axis ratio of zero K is infinite, but (h - v) K vanishes.
        Err(_) => FRAC_2_PI,
        Ok(ratio) => ((v + h) * e(ratio) - (h - v) * k(ratio)) / (PI * v),
    }
}

/// The weights and `(1 - rho^2)^(1/2)` of points over the radius.
struct Points(GaussLegendre);

impl Points {
    /// The friction means at a tangential velocity, a rate gamma zeta' of radial displacement and a
    /// circumferential velocity of the rim.
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
    /// The impact if nothing sticks; None where elastic displacements matter.
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
        // The change by friction while the normal velocity decreases by one step.
        let change = |w: f64, [velocity, spin]: [f64; 2]| {
            let drag = points.drag(velocity.abs(), gamma * speed * w.abs(), rim(w) * spin.abs());
            let push = 2.0 * friction * speed / (along * STEPS as f64);
            let slowed = push * across * drag.along;
            let untwisted = push * about * rim(w) * drag.about;
            // The work of the radial displacement, as a change of the square of the normal velocity.
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
            by_direction: 0.0,
        };
        // Displacements matter where the direction of slip turns with the radial displacement.
        let reach = 2.0 * before[0] / (gamma * speed);
        let elastic = ELASTIC * across / (along * self.spread() * (1.0 + reach.powi(4)));
        Ok(Some(Slide { passage, estimate: elastic + LEFT, normal: friction * friction }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rings::levels::LEVELS;
    use carom_laws::friction::Friction;

    /// Where this solution begins rings are still possible; displacements that it leaves out exceed its own error.
    #[test]
    fn where_it_begins_it_differs_from_rings_within_its_estimate() {
        let mut largest: f64 = 0.0;
        for (lambda, gamma) in [(100.0, 0.3), (600.0, 0.4)] {
            let friction = Friction::new(gamma / (1.001 * LEAST)).unwrap();
            let problem = Problem::of_groups([1.2, gamma], friction, lambda, 3.5);
            let slide = problem.slide().unwrap().unwrap();
            let rings = LEVELS[LEVELS.len() - 1].passage(&problem).unwrap();
            let off = (rings.after[1] - slide.passage.after[1]).abs() / friction.get();
            assert!(off < slide.estimate, "{lambda}: {off} {}", slide.estimate);
            largest = largest.max(off);
        }
        assert!(largest > LEFT, "{largest}");
    }

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
