//! Impacts whose contact is solved on a grid: any materials, dissimilar ones too (15.2).
//!
//! [`NumericalImpact`] follows a [`carom_impact::Collision`] with the contact of `carom-solver` in place of an
//! analytic law.
#![forbid(unsafe_code)]

mod law;
mod peak;
mod refine;
mod run;

pub use law::{CollisionLaw, CollisionLawError};

use carom_impact::coupled::{CoupledOutcome, ImpactMethod, LawFailure};
use carom_impact::{Collision, CollisionError, HistoryPoint, Instants, Outcome};
use carom_solver::NumericalLawError;
use carom_special::RangeError;
use nalgebra::Vector3;

use refine::Found;
use run::{Fineness, Problem};

/// Why an impact on the numerical contact failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NumericalImpactError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The collision itself cannot be computed.
    #[error(transparent)]
    Collision(#[from] CollisionError),
    /// A step of the contact could not be solved.
    #[error("{failure}: {}", .failure.source)]
    Law {
        /// Which step, and why.
        #[from]
        failure: LawFailure<NumericalLawError>,
    },
    /// The bodies do not part.
    #[error("the bodies do not separate within 64 times the steps of a free impact")]
    NoSeparation,
}

/// A collision whose contact is solved on a grid, where [`Collision::solve`] takes analytic laws:
/// the coupling of normal and tangential displacements of dissimilar bodies counts, for any shape of the contact
/// ellipse and any mobility.
///
/// Cells and steps are refined apart. With F the finest run (velocity after the impact), S what it changed
/// against half of the steps and C what a run changed against half of the cells, the result is
/// `F + S/3 + 0.27 C`, within the friction limit and the energy before, and the estimate of its error is
/// the greater of `0.6 |S|` and 0.18 of S of twice the step, with `0.48 |C|` and (9e-4 + 0.018 |gamma| f) f v_z. What is
/// larger is refined next, until the estimate meets the tolerance.
///
/// In 80 drawn impacts of balls on planes (|gamma| to 0.42, f from 0.05 to 0.6, tangential velocity from 0.1 to 5 f v_z)
/// the tangential velocity differed from that of the finest rings by 0.0015 f v_z in the median and 0.012 at most. The
/// estimates of both covered 76 of the differences; that of the grid was 4.7 times the difference in the median.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::{Body, Collision, Motion};
/// use carom_laws::friction::Friction;
/// use carom_numerical::NumericalImpact;
/// let ball = |nu| Body::sphere(0.0405, Material::from_shear(82e9, nu)?, 2.188);
/// let upper = ball(0.0)?.moving(Motion::new([-0.05, 0.0, -1.0], [0.0; 3])?);
/// let collision = Collision::new(upper, ball(0.5)?, Friction::new(0.1)?)?;
/// let outcome = NumericalImpact::new(&collision).with(12, 40)?.solve()?;
/// let rebound = outcome.rebound().ok_or("they meet")?;
/// // The contact point of similar bodies would move on; here it is thrown back (0.3117 by rings).
/// assert!((rebound.r_x.unwrap_or(0.0) - 0.3117).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct NumericalImpact<'a> {
    collision: &'a Collision,
    refinement: Refinement,
}

/// How fine an impact is solved.
#[derive(Debug, Clone, Copy)]
enum Refinement {
    /// As the collision asks.
    Asked,
    Within(f64),
    At(Fineness),
}

impl<'a> NumericalImpact<'a> {
    /// The default tolerance: 1e-2.
    pub const TOLERANCE: f64 = 1e-2;

    /// With the tolerance of the collision ([`Collision::within`]) or, if it has none, the default: the tangential
    /// velocity may be off by 1e-2 of f times the velocity of approach.
    #[must_use]
    pub const fn new(collision: &'a Collision) -> Self {
        Self { collision, refinement: Refinement::Asked }
    }

    /// With another tolerance of the tangential velocity over f v_z (over v_z where f > 1), and of the normal velocity over
    /// v_z. Where 64 cells and 512 steps (32 and 256 where |gamma| f exceeds 1) do not meet it, the outcome says so by its
    /// error estimate.
    ///
    /// # Errors
    /// [`RangeError`] unless it is finite and positive.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        RangeError::positive("tolerance", tolerance)?;
        Ok(Self { refinement: Refinement::Within(tolerance), ..self })
    }

    /// With given numbers of cells across the contact of the greatest approach and of steps in a free impact,
    /// whatever the estimate; it takes two runs with half of the steps, one of them with half of the cells, and a short one.
    ///
    /// # Errors
    /// [`RangeError`] unless there are 8 to 512 cells and 16 to 10^5 steps.
    pub fn with(self, cells: usize, steps: usize) -> Result<Self, RangeError> {
        let holds = (8..=512).contains(&cells);
        RangeError::check("cells", cells as f64, holds, "from 8 to 512")?;
        let holds = (16..=100_000).contains(&steps);
        RangeError::check("steps", steps as f64, holds, "from 16 to 100000")?;
        Ok(Self { refinement: Refinement::At(Fineness { cells, steps }), ..self })
    }

    /// Follows the impact to separation. The spin about the normal is left alone.
    ///
    /// # Errors
    /// [`NumericalImpactError::Range`] for infinite friction; [`NumericalImpactError::Law`] where a step cannot be
    /// solved.
    pub fn solve(&self) -> Result<Outcome, NumericalImpactError> {
        let Some(problem) = Problem::new(self.collision)? else {
            return Ok(self.collision.missed());
        };
        let found = self.found(&problem)?;
        let before = problem.impact.velocity();
        let tangential = found.tangential * problem.scale();
        let by_law = problem.impact.error_of_places().map_err(CollisionError::from)?;
        let turned = self.collision.hertz().materials().gamma() / self.collision.friction().get();
        let off = problem.impact.left_by_loss(turned.abs());
        let mut velocity = found.velocity - by_law.velocity;
        velocity.z = velocity.z.min(0.0);
        let corrected = by_law.velocity != Vector3::zeros();
        let impulse = if corrected { problem.restricted(&velocity) } else { found.impulse };
        let velocity = if corrected { before - problem.mobility() * impulse } else { velocity };
        let material_heat = problem.impact.material_heat(&by_law, &impulse, &velocity);
        let outcome = CoupledOutcome {
            velocity,
            impulse,
            material_heat,
            duration: found.finest.duration,
            maximal_approach: found.finest.peak.approach,
            maximal_force: found.finest.peak.force,
            compressions: found.finest.compressions,
            method: ImpactMethod::Numerical,
            error_estimate: (tangential.hypot(found.normal) * before.z + off) / before.norm(),
            warning: None,
        };
        let rebound = self.collision.rebound_of(outcome, Vec::new())?;
        Ok(Outcome::Rebound(Box::new(rebound)))
    }

    /// The impact at so many instants equally spaced in time, or at given times, straight between those of the finest run; empty without an
    /// impact. At separation its velocity differs from that of [`NumericalImpact::solve`] by what the runs are
    /// extrapolated.
    ///
    /// # Errors
    /// As [`NumericalImpact::solve`]; [`RangeError`] as [`Instants::check`].
    pub fn history<'b>(
        &self,
        instants: impl Into<Instants<'b>>,
    ) -> Result<Vec<HistoryPoint>, NumericalImpactError> {
        let instants = instants.into();
        instants.check()?;
        let Some(problem) = Problem::new(self.collision)? else { return Ok(Vec::new()) };
        let samples = self.found(&problem)?.finest.samples;
        Ok(self.collision.sampled(&samples, instants, &problem.impact.velocity())?)
    }

    fn found(&self, problem: &Problem<'_>) -> Result<Found, NumericalImpactError> {
        match self.refinement {
            Refinement::Asked => problem.settled(match self.collision.allowed_error() {
                Some(error) => [error / problem.scale(), error],
                None => [Self::TOLERANCE; 2],
            }),
            Refinement::Within(tolerance) => problem.settled([tolerance; 2]),
            Refinement::At(fineness) => problem.at(fineness),
        }
    }
}
