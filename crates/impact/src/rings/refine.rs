//! Refines rings and steps until the error estimate of an impact is below its tolerance.

use nalgebra::Vector3;

use super::levels::{Floor, LEVELS, Level, SPINNING, UNLIKE};
use super::motion::{Passage, Rates};
use super::problem::{Exact, Problem};
use super::sliding::Slide;
use super::spinning::Extrapolated;
use super::{RingImpact, RingImpactError};
use crate::coupled::{Sample, Stage, left_by_loss};
use crate::normal::DURATION;

/// The tangential velocity over f v_z at which the limit for vanishing ones is computed.
pub(super) const PROBE: f64 = 0.02;
/// Lambda at which the discretisation error reaches half of its size.
const SMALL: f64 = 0.1;
/// Lambda at which the error by too few angles reaches half of its size.
const SLIDING: f64 = 2.0;
/// Lambda over D_xx/D_zz at which the error by too few angles has decreased to half.
const SLIDE_ALONG: f64 = 3.0;
/// gamma/f beyond which that error does not grow.
const MANY: f64 = 30.0;
/// Coefficient of (gamma f)^2 in the error of the law of rings itself.
const LEFT_OUT: f64 = 0.15;
/// Coefficient of kappa - 1 in the error of the solution for similar bodies, whose friction has the direction of the
/// tangential velocity everywhere. On a grid of 80 cells it was .0017 f v_z off at kappa = 1.44.
const BY_DIRECTION: f64 = 4e-3;
/// Friction beyond which what sticks from the first touch on errs as with this one.
const GREAT: f64 = 1.2;
/// The energy that rounding may add, over that before.
const ROUND_OFF: f64 = 1e-12;
/// Friction above which hardly anything slips.
const STRONGEST: f64 = 5.0;
/// gamma/f at which half of the error for similar bodies is subtracted.
const HALF: f64 = 1.0;
/// gamma f (gamma for f > 1) at which half of it is subtracted.
const HALF_STRENGTH: f64 = 0.2;
/// The part of the tolerance that unlike bodies may use up before they take more rings: about half of them then do.
const USED: f64 = 0.67;
/// The usual error of the law of rings over the bound [`LEFT_OUT`].
const USUAL: f64 = 0.25;

/// Rates after the impact and their estimated error, over f v_z.
pub(super) struct Found {
    pub(super) passage: Passage,
    /// The heat of friction of a material that loses energy.
    pub(super) friction_heat: f64,
    pub(super) estimate: f64,
    /// Estimated error of the normal velocity, over v_z.
    pub(super) normal: f64,
    /// Estimated error of the spin about the normal, over that before.
    pub(super) spin: f64,
    /// The resolution.
    pub(super) level: Level,
    /// The computed instants.
    pub(super) samples: Vec<Sample>,
}

impl Problem {
    /// Refines until the estimates of the tangential velocity over f v_z and of the normal one over v_z are
    /// as allowed.
    pub(super) fn found(&self, allowed: [f64; 2]) -> Result<Found, RingImpactError> {
        match (self.slide()?, self.motion.before[3] == 0.0) {
            (Some(slide), _) => Ok(self.slid(slide)),
            (None, true) if self.constants.gamma == 0.0 => {
                self.refined(&LEVELS, allowed, Compared::default())
            }
            (None, true) => self.refined(&UNLIKE, allowed, Compared::default()),
            (None, false) => self.refined(&SPINNING, allowed, Extrapolated::default()),
        }
    }

    /// A sliding impact in its material: each part of the impulse is in proportion to that along the normal.
    fn slid(&self, slide: Slide) -> Found {
        let Slide { mut passage, estimate, normal } = slide;
        let [speed, xi, eta, _] = self.motion.before;
        let part = 0.5 * (1.0 + self.normal());
        if part < 1.0 {
            for (after, before) in passage.after.iter_mut().zip(self.motion.before) {
                *after = before + part * (*after - before);
            }
        }
        let [along, ..] = self.motion.mobility;
        let taken = (1.0 - self.normal() * self.normal()) * speed * speed / along;
        let lost = self.energy(&self.motion.before) - self.energy(&passage.after);
        let friction_heat = 0.5 * (lost - taken).max(0.0);
        let touch = Sample {
            time: 0.0,
            shift: Vector3::zeros(),
            velocity: Vector3::new(xi, eta, speed),
            force: Vector3::zeros(),
            stage: Stage::Slide,
        };
        let (level, samples) = (LEVELS[1], vec![touch]);
        Found { passage, friction_heat, estimate, normal, spin: estimate, level, samples }
    }

    /// Runs levels from coarse to fine until one is fine enough. With the default tolerance the finest are left out.
    fn refined(
        &self,
        levels: &[Level],
        [allowed, normal]: [f64; 2],
        mut correction: impl Correction,
    ) -> Result<Found, RingImpactError> {
        let (exact, left_out) = (self.exact()?, self.left_out());
        let mut best = None;
        let takes_finest = allowed < RingImpact::TOLERANCE;
        let enough = self.enough(allowed);
        for level in levels.iter().filter(|level| level.is_usual || takes_finest) {
            let mut samples = Vec::new();
            let passage = level.observed(self, &mut |sample| samples.push(sample))?;
            let Some(run) = correction.of(self, level, passage, &exact)? else { continue };
            let [tangential, along, spin] = run.left;
            let estimate = tangential + self.floor(level);
            let is_enough = estimate <= enough && along <= normal;
            let mut passage = run.passage;
            // The bodies part, however little is left of the normal velocity.
            passage.after[0] = passage.after[0].min(0.0);
            passage.after = self.without_gain(&passage.after);
            let friction_heat = self.friction_heat_beside_loss(&passage.after, &exact);
            best = Some(Found {
                passage,
                friction_heat,
                estimate: estimate
                    + left_out
                    + self.of_straight_friction()
                    + self.left_by_loss()
                    + run.by_law,
                normal: along,
                spin: spin + level.floor.of_spin,
                level: *level,
                samples,
            });
            if is_enough {
                break;
            }
        }
        best.ok_or(RingImpactError::NoSeparation)
    }

    /// The impact; R_x and its estimated error where it is the limit for vanishing tangential velocities.
    ///
    /// A small tangential velocity after the impact is proportional to that before, so that impacts below
    /// [`PROBE`] are scaled from the one at `PROBE`.
    pub(super) fn followed(
        &self,
        allowed: [f64; 2],
    ) -> Result<(Found, Option<[f64; 2]>), RingImpactError> {
        let [speed, xi, eta, omega] = self.motion.before;
        let (size, probe) = (xi.hypot(eta), PROBE * self.scale() * speed);
        if size >= probe {
            return Ok((self.found(allowed)?, None));
        }
        let (limit, probed) = self.limit(probe, allowed)?;
        let [speed_after, _, across, omega_after] = probed.passage.after;
        // Spin and coupling together cause a velocity perpendicular to the tangential velocity before.
        let side = if omega == 0.0 { 0.0 } else { across / probe };
        let mut found = probed;
        found.passage.after =
            [speed_after, -limit * xi - side * eta, -limit * eta + side * xi, omega_after];
        found.passage.after = self.without_gain(&found.passage.after);
        let estimate = found.estimate / PROBE;
        found.estimate *= size / probe;
        Ok((found, Some([limit, estimate])))
    }

    /// R_x for small tangential velocities: that of similar bodies plus the effect of coupling, which is
    /// computed at `size` along x. A velocity of spin at the edge above `size` smooths the kink of similar
    /// bodies at small velocities.
    fn limit(&self, size: f64, allowed: [f64; 2]) -> Result<(f64, Found), RingImpactError> {
        let mut probe = *self;
        (probe.motion.before[1], probe.motion.before[2]) = (size, 0.0);
        let found = probe.found(allowed)?;
        let edge = self.constants.radius * found.passage.maximal_approach.sqrt();
        let part = 1.0 / (1.0 + (edge * self.motion.before[3] / size).powi(2));
        let kink = self.exact_restitution()? - probe.exact_restitution()?;
        let limit = -found.passage.after[1] / size + part * kink;
        Ok((limit.clamp(-1.0, 1.0), found))
    }

    /// The estimate at which no finer rings are taken: they do not reduce the errors of the laws themselves.
    fn enough(&self, allowed: f64) -> f64 {
        let left_out = self.left_out();
        let is_unlike = self.constants.gamma != 0.0 && self.motion.before[3] == 0.0;
        if is_unlike { (USED * allowed).max(USUAL * left_out) } else { allowed.max(left_out) }
    }

    /// The fraction of the error for similar bodies that is subtracted: all of it where slip is due to the
    /// shift, less where it is due to coupling or where tractions lift the surface,
    /// `1/(1 + (gamma/f)^2)/(1 + (5 gamma f)^2)`.
    pub(super) fn taken_off(&self) -> f64 {
        let ratio = self.spread() / HALF;
        let lift = self.constants.gamma * self.scale() / HALF_STRENGTH;
        if ratio.is_finite() { 1.0 / (1.0 + ratio * ratio) / (1.0 + lift * lift) } else { 0.0 }
    }

    /// The smallest error of a level, in the tangential velocity over f v_z, whatever the change from the
    /// coarser level.
    pub(super) fn floor(&self, level: &Level) -> f64 {
        let gamma = self.constants.gamma.abs();
        let Floor { always, by_gamma, by_strength, by_spread, .. } = level.floor;
        let lambda = self.lambda();
        let slides = if lambda.is_finite() { lambda / (lambda + SLIDING) } else { 1.0 };
        let turns = self.turns();
        // From gamma/f = 1000 the sliding solution is used.
        let spread = if gamma > 0.0 { self.spread() } else { 0.0 };
        let turned = by_gamma * gamma + by_strength * self.strength();
        let least = (always + turns * turned) * self.reached()
            + turns * by_spread * slides * spread.min(MANY);
        // Where f is no scale of velocities, errors grow with the friction that is used all the same.
        least * self.needed().clamp(1.0, self.friction.get().clamp(1.0, STRONGEST))
    }

    /// The friction that the tangential velocity takes at the first touch, that of the rim by the spin too.
    fn needed(&self) -> f64 {
        let [speed, xi, eta, _] = self.motion.before;
        xi.hypot(eta).hypot(self.rim()) / speed
    }

    /// The velocity at the edge of an elastic contact by the spin.
    fn rim(&self) -> f64 {
        let [speed, .., omega] = self.motion.before;
        let deepest = self.motion.duration * speed / DURATION;
        (self.constants.radius * deepest.sqrt() * omega).abs()
    }

    /// The tangential velocity over f v_z (over v_z where f > 1), infinite with spin about the normal.
    fn lambda(&self) -> f64 {
        let [speed, xi, eta, omega] = self.motion.before;
        if omega == 0.0 { xi.hypot(eta) / (self.scale() * speed) } else { f64::INFINITY }
    }

    /// The product |gamma| f.
    fn strength(&self) -> f64 {
        self.constants.gamma.abs() * self.friction.get().min(STRONGEST)
    }

    /// The fraction of the error that is reached at the tangential velocity before.
    fn reached(&self) -> f64 {
        let lambda = self.lambda();
        if lambda.is_finite() { lambda / (lambda + SMALL) } else { 1.0 }
    }

    /// 1 where tractions change direction or stick, decreasing to 0 where everything slides along the shift.
    fn turns(&self) -> f64 {
        let [along, across, _] = self.motion.mobility;
        let part = self.lambda() * along / (SLIDE_ALONG * across);
        if self.motion.before[3] == 0.0 { 1.0 / (1.0 + part.powi(8)) } else { 1.0 }
    }

    /// The error of the law of rings itself, which takes a circle for the contact area, in the tangential velocity
    /// over f v_z (over v_z for f > 1). Against a grid of 64 cells in 256 steps, 30 impacts with |gamma| f from 0.2 to 1.1
    /// and f to 2.9 had smaller errors; so did 126 others, about a fixed centre all but one, and 20 with |gamma| to .5 and f
    /// from .8 to 5.
    pub(super) fn left_out(&self) -> f64 {
        let (gamma, friction) = (self.constants.gamma.abs(), self.friction.get());
        if friction <= GREAT {
            return LEFT_OUT * (gamma * friction * friction.max(1.0)).powi(2) * self.reached();
        }
        // What sticks from the first touch on errs less.
        let needed = self.needed();
        let taken = needed.clamp(GREAT, friction.min(STRONGEST));
        (LEFT_OUT * (gamma * taken * taken).powi(2)).min(gamma * needed.max(GREAT)) * self.reached()
    }

    /// The error of the solution for similar bodies, in the same unit; with spin none is subtracted.
    fn of_straight_friction(&self) -> f64 {
        if self.motion.before[3] != 0.0 {
            return 0.0;
        }
        let beyond = (self.constants.kappa - 1.0).max(0.0);
        BY_DIRECTION * beyond * self.taken_off() * self.reached()
    }

    /// The error of the law of viscous materials, in the same unit: where slip turns, by coupling or by a spin.
    fn left_by_loss(&self) -> f64 {
        let spun = self.rim() / (self.scale() * self.motion.before[0]);
        self.loss.map_or(0.0, |loss| left_by_loss(loss, self.spread(), spun))
    }

    /// The rates after, slower if they have more energy than those before.
    fn without_gain(&self, after: &Rates) -> Rates {
        let (has, had) = (self.energy(after), self.energy(&self.motion.before));
        let part = if has > had * (1.0 + ROUND_OFF) { (had / has).sqrt() } else { 1.0 };
        after.map(|rate| part * rate)
    }

    /// The heat of friction if the material loses as much as in the impact of similar bodies: the rest of all that is lost.
    /// What friction does on the path of a viscous law is no measure, as that path begins with a jump.
    fn friction_heat_beside_loss(&self, after: &Rates, exact: &Exact) -> f64 {
        let lost = |after: &Rates| 0.5 * (self.energy(&self.motion.before) - self.energy(after));
        let mut alike = exact.rates;
        alike[3] = self.motion.before[3];
        let all = lost(after);
        (exact.friction_heat + all - lost(&alike)).clamp(0.0, all.max(0.0))
    }

    /// By how much the step law of a viscous material is corrected, over f v_z: as much may be left of its error.
    pub(super) fn taken_from_viscous_law(&self, alike: &Passage, exact: &Exact) -> f64 {
        if self.loss.is_none() {
            return 0.0;
        }
        let over = self.scale() * self.motion.before[0];
        let [_, x, y, _] = exact.rates;
        libm::hypot(x - alike.after[1], y - alike.after[2]) / over
    }
}

/// A run corrected by what is known of its errors.
pub(super) struct Corrected {
    pub(super) passage: Passage,
    /// What may be left of them: in the tangential velocity over f v_z, in the normal one over v_z, in the spin over
    /// that before.
    pub(super) left: [f64; 3],
    /// What is left of the error of the law of a viscous material, over f v_z.
    pub(super) by_law: f64,
}

/// How a run is corrected, after those of coarser levels.
pub(super) trait Correction {
    /// None for the first run, to which there is no other.
    fn of(
        &mut self,
        problem: &Problem,
        level: &Level,
        passage: Passage,
        exact: &Exact,
    ) -> Result<Option<Corrected>, RingImpactError>;
}

/// Without spin: by the same run of similar bodies, whose solution is known, and for unlike ones by what finer levels would
/// change. What they change is left.
#[derive(Default)]
struct Compared {
    /// Rates of the coarser level.
    last: Option<Rates>,
}

impl Correction for Compared {
    fn of(
        &mut self,
        problem: &Problem,
        level: &Level,
        mut passage: Passage,
        exact: &Exact,
    ) -> Result<Option<Corrected>, RingImpactError> {
        let (alike, part) = (level.passage(&problem.alike())?, problem.taken_off());
        for (i, part) in [1.0, part, part, 0.0].into_iter().enumerate() {
            passage.after[i] += part * (exact.rates[i] - alike.after[i]);
        }
        let Some(last) = self.last.replace(passage.after) else { return Ok(None) };
        let change: Rates = std::array::from_fn(|i| passage.after[i] - last[i]);
        if level.beyond > 0.0 {
            let beyond = [0.0, level.beyond * change[1], level.beyond * change[2], 0.0];
            passage.after = problem.possible(&passage.after, &beyond);
        }
        let left = change.map(|change| level.left * change.abs());
        let speed = problem.motion.before[0];
        let tangential = left[1].hypot(left[2]) / (problem.scale() * speed);
        let by_law = problem.taken_from_viscous_law(&alike, exact);
        Ok(Some(Corrected { passage, left: [tangential, left[0] / speed, 0.0], by_law }))
    }
}

#[cfg(test)]
mod tests {
    use carom_laws::friction::Friction;

    use super::*;
    use crate::viscoelastic::ViscousLoss;

    /// Like bodies of a viscous material, most of whose contact sticks: the law itself, before anything is taken off, is near
    /// the exact impact. Without the slip at which places will touch it is .026 f v_z off.
    #[test]
    fn viscous_bodies_that_stick_leave_as_known() {
        let friction = 0.1;
        for e in [0.2, 0.428, 0.7] {
            for lambda in [0.5, 1.0] {
                let law = Friction::new(friction).unwrap();
                let mut problem = Problem::of_groups([1.02, 0.0], law, lambda, 3.5);
                problem.loss = Some(ViscousLoss::of_restitution(e).unwrap());
                let after = UNLIKE[2].passage(&problem).unwrap().after[1];
                let off = (after - problem.exact().unwrap().rates[1]) / friction;
                assert!(off.abs() < 8e-3, "{e} {lambda}: {off}");
            }
        }
    }
}
