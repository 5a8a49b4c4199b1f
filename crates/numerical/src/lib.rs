//! Impacts whose contact is solved on a grid: any materials, dissimilar ones too (15.2).
//!
//! [`NumericalImpact`] follows a [`carom_impact::Collision`] with the contact of `carom-solver` in place of an
//! analytic law.
#![forbid(unsafe_code)]

mod law;

pub use law::{CollisionLaw, CollisionLawError};

use carom_impact::coupled::{
    CoupledImpact, CoupledOutcome, ImpactMethod, LawFailure, Point, Sample, Stage, Trajectory,
};
use carom_impact::normal::NormalImpact;
use carom_impact::{Collision, CollisionError, HistoryPoint, Outcome};
use carom_solver::{CellState, NumericalLaw, NumericalLawError};
use carom_special::RangeError;

/// To which the solver takes each step.
const TOLERANCE: f64 = 1e-7;
/// Cells across the contact of the finer of two runs, and its steps in a free impact.
const CELLS: usize = 32;
const STEPS: usize = 128;

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
    #[error("the bodies do not separate within 2^14 times the steps of a free impact")]
    NoSeparation,
}

/// A collision whose contact is solved on a grid, where [`Collision::solve`] takes analytic laws:
/// the coupling of normal and tangential displacements of dissimilar bodies counts.
///
/// Two runs are made, one with half the cells and steps; how far they differ is the error estimate.
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
/// // Alike they would slide back a little; unlike they are thrown back (0.312 on finer grids).
/// assert!((rebound.r_x.unwrap_or(0.0) - 0.312).abs() < 0.02);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct NumericalImpact<'a> {
    collision: &'a Collision,
    cells: usize,
    steps: usize,
}

/// One run.
struct Run {
    end: Point,
    peak: f64,
    force: f64,
    compressions: u32,
    samples: Vec<Sample>,
}

impl<'a> NumericalImpact<'a> {
    /// With 32 cells across the contact of the greatest approach and about 128 steps.
    #[must_use]
    pub const fn new(collision: &'a Collision) -> Self {
        Self { collision, cells: CELLS, steps: STEPS }
    }

    /// With other numbers of cells and steps.
    ///
    /// # Errors
    /// [`RangeError`] unless there are 8 to 512 cells and 16 to 10^5 steps.
    pub fn with(self, cells: usize, steps: usize) -> Result<Self, RangeError> {
        let holds = (8..=512).contains(&cells);
        RangeError::check("cells", cells as f64, holds, "from 8 to 512")?;
        let holds = (16..=100_000).contains(&steps);
        RangeError::check("steps", steps as f64, holds, "from 16 to 100000")?;
        Ok(Self { cells, steps, ..self })
    }

    /// Follows the impact to separation. The spin about the normal is left alone.
    ///
    /// # Errors
    /// [`NumericalImpactError::Law`] for infinite friction and where a step cannot be solved.
    pub fn solve(&self) -> Result<Outcome, NumericalImpactError> {
        let Some(impact) = self.collision.impact()? else { return Ok(self.collision.missed()) };
        let coarse = self.run(&impact, self.cells / 2, self.steps / 2)?;
        let fine = self.run(&impact, self.cells, self.steps)?;
        let before = impact.velocity();
        let change = (fine.end.velocity - coarse.end.velocity).norm();
        let outcome = CoupledOutcome {
            velocity: fine.end.velocity,
            impulse: fine.end.impulse,
            duration: fine.end.time,
            maximal_approach: fine.peak,
            maximal_force: fine.force,
            compressions: fine.compressions,
            method: ImpactMethod::Numerical,
            error_estimate: change / before.norm(),
            warning: None,
        };
        let rebound = self.collision.rebound_of(outcome, Vec::new())?;
        Ok(Outcome::Rebound(Box::new(rebound)))
    }

    /// The impact at `count` instants equally spaced in time, straight between those that were
    /// computed; empty without an impact.
    ///
    /// # Errors
    /// As [`NumericalImpact::solve`]; [`RangeError`] for fewer than two instants.
    pub fn history(&self, count: usize) -> Result<Vec<HistoryPoint>, NumericalImpactError> {
        let Some(impact) = self.collision.impact()? else { return Ok(Vec::new()) };
        let samples = self.run(&impact, self.cells, self.steps)?.samples;
        Ok(self.collision.sampled(&samples, count, &impact.velocity())?)
    }

    fn run(
        &self,
        impact: &CoupledImpact,
        cells: usize,
        steps: usize,
    ) -> Result<Run, NumericalImpactError> {
        let (hertz, velocity) = (*self.collision.hertz(), impact.velocity());
        let mobility = *self.collision.mobility().matrix();
        let stiffness = hertz.stiffness();
        let normal = NormalImpact::new(mobility.m33, stiffness.c_z, velocity.z)?;
        let peak = normal.maximal_approach();
        let law = NumericalLaw::new(hertz, self.collision.friction(), peak, cells)?;
        let mut law = law.within(TOLERANCE)?;
        let trajectory = Trajectory { mobility, velocity, stiffness, steps, expected: None };
        let mut samples: Vec<Sample> = Vec::new();
        let end = trajectory.follow(&mut law, |point, law| samples.push(sample(point, law)))?;
        let end = end.ok_or(NumericalImpactError::NoSeparation)?;
        let greatest = |of: fn(&Sample) -> f64| samples.iter().map(of).fold(0.0, f64::max);
        let (peak, force) = (greatest(|at| at.shift.z), greatest(|at| at.force.z));
        let turns =
            samples.windows(2).filter(|pair| pair[0].velocity.z <= 0.0 && pair[1].velocity.z > 0.0);
        let compressions = 1 + turns.count() as u32;
        Ok(Run { end, peak, force, compressions, samples })
    }
}

fn sample(point: &Point, law: &NumericalLaw) -> Sample {
    let Point { time, shift, velocity, force, .. } = *point;
    Sample { time, shift, velocity, force, stage: stage(law) }
}

/// What slipped in the last step.
fn stage(law: &NumericalLaw) -> Stage {
    match (law.count(CellState::Stick), law.count(CellState::Slip)) {
        (_, 0) => Stage::Adhesion,
        (0, _) => Stage::Slide,
        _ => Stage::Slip,
    }
}
