//! R_x of dissimilar spheres and planes by the numbers that govern it, for tables.

use carom_laws::friction::Friction;

use super::RingImpactError;
use super::levels::FILLING;
use super::problem::Problem;
use super::refine::PROBE;

/// R_x by rings of one fineness for several couplings of the same kappa, lambda and D_xx/D_zz: alike bodies are
/// followed once.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Filling {
    kappa: f64,
    lambda: f64,
    ratio: f64,
    /// R_x of alike bodies at `lambda`.
    exact: f64,
    /// What rings miss of it, at the velocity that is followed.
    missed: f64,
    /// R_x of alike bodies at the velocity that is followed.
    followed: f64,
}

impl Filling {
    /// `ratio` is D_xx/D_zz. Below lambda = 0.02, R_x is that of alike bodies and what coupling adds at 0.02.
    pub(crate) fn new(kappa: f64, lambda: f64, ratio: f64) -> Result<Self, RingImpactError> {
        // Any friction does: that of alike bodies is only a scale.
        let friction = Friction::new(1.0)?;
        let of = |lambda: f64| Problem::of_groups([kappa, 0.0], friction, lambda, ratio);
        let at = of(lambda.max(PROBE));
        let by_rings = -FILLING.passage(&at)?.after[1] / at.motion.before[1];
        let followed = at.exact_restitution()?;
        let exact = of(lambda).exact_restitution()?;
        Ok(Self { kappa, lambda, ratio, exact, followed, missed: followed - by_rings })
    }

    /// R_x of alike bodies.
    pub(crate) const fn exact(&self) -> f64 {
        self.exact
    }

    /// R_x at gamma and friction.
    pub(crate) fn restitution(
        &self,
        gamma: f64,
        friction: Friction,
    ) -> Result<f64, RingImpactError> {
        let lambda = self.lambda.max(PROBE);
        let problem = Problem::of_groups([self.kappa, gamma], friction, lambda, self.ratio);
        let after = FILLING.passage(&problem)?.after[1];
        let restitution = -after / problem.motion.before[1] + problem.taken_off() * self.missed;
        Ok(restitution + self.exact - self.followed)
    }
}
