//! R_x of dissimilar spheres and planes by the numbers that govern it, refined until it is known.

use carom_laws::friction::Friction;

use super::RingImpactError;
use super::problem::Problem;
use super::refine::PROBE;

/// lambda over 1 + gamma/f from which on all slides along the shift, and 1 + R_x goes as 1/lambda.
const FAST: f64 = 1e4;

/// Dissimilar spheres or planes that meet with friction and a tangential velocity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct GroupImpact {
    pub(crate) kappa: f64,
    pub(crate) gamma: f64,
    pub(crate) friction: Friction,
    pub(crate) lambda: f64,
    /// D_xx/D_zz.
    pub(crate) ratio: f64,
}

impl GroupImpact {
    fn problem(&self, lambda: f64) -> Problem {
        Problem::of_groups([self.kappa, self.gamma], self.friction, lambda, self.ratio)
    }
}

/// R_x and its estimated error, refined until that of the velocity over f v_z is below the tolerance.
pub(crate) fn by_groups(impact: &GroupImpact, tolerance: f64) -> Result<[f64; 2], RingImpactError> {
    let spread = impact.gamma.abs() / impact.friction.get();
    let lambda = impact.lambda.min(FAST * (1.0 + spread));
    let problem = impact.problem(lambda).letting_go_at_the_rim()?;
    let (found, limit) = problem.followed([tolerance, f64::INFINITY])?;
    if let Some(limit) = limit {
        return Ok(limit);
    }
    let before = problem.motion.before[1];
    let restitution = -found.passage.after[1] / before;
    let part = lambda / impact.lambda;
    let estimate = found.estimate * problem.scale() / before;
    Ok([(1.0 + restitution) * part - 1.0, estimate * part])
}

/// What all rings leave out of R_x.
pub(crate) fn left_out(impact: &GroupImpact) -> f64 {
    let problem = impact.problem(impact.lambda.max(PROBE));
    problem.left_out() * problem.scale() / problem.motion.before[1]
}
