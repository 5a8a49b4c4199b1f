//! One run of an impact on a grid.

use carom_impact::Collision;
use carom_impact::coupled::{CoupledImpact, Point, Sample, Stage, Trajectory};
use carom_impact::normal::NormalImpact;
use carom_laws::viscous::ViscousLaw;
use carom_solver::{CellState, NumericalLaw};
use nalgebra::{Matrix3, Vector3};

use crate::NumericalImpactError;
use crate::peak::Peak;

/// To which the solver takes each step: from 1e-7 to 1e-4 velocities change by 1e-4 f v_z, from 1e-3 on by more.
const TOLERANCE: f64 = 1e-5;

/// Steps of an impact on a grid, over those of a free one: the first run takes a second for so many.
const PATIENCE: usize = 64;

/// A number of cells across the contact of the greatest approach, and one of steps in a free impact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Fineness {
    pub(crate) cells: usize,
    pub(crate) steps: usize,
}

/// An impact in contact axes.
pub(crate) struct Problem<'a> {
    collision: &'a Collision,
    pub(crate) impact: CoupledImpact,
    normal: NormalImpact,
}

/// What a run found.
pub(crate) struct Run {
    pub(crate) impulse: Vector3<f64>,
    pub(crate) duration: f64,
    pub(crate) peak: Peak,
    pub(crate) compressions: u32,
    pub(crate) samples: Vec<Sample>,
}

impl<'a> Problem<'a> {
    /// None if the bodies do not meet.
    pub(crate) fn new(collision: &'a Collision) -> Result<Option<Self>, NumericalImpactError> {
        let Some(impact) = collision.impact()? else { return Ok(None) };
        collision.refuse_static_friction("equal to kinetic friction with the numerical law")?;
        collision.refuse_stiffness_ratio()?;
        let (mobility, c_z) = (collision.mobility().matrix(), collision.hertz().stiffness().c_z);
        let normal = NormalImpact::new(mobility.m33, c_z, impact.velocity().z)?;
        Ok(Some(Self { collision, impact, normal }))
    }

    /// The impulse to a velocity after, within the limits of friction and energy.
    pub(crate) fn restricted(&self, after: &Vector3<f64>) -> Vector3<f64> {
        let impulse = self.collision.mobility().impulse(&self.impact.velocity(), after);
        self.impact.restricted(&impulse)
    }

    pub(crate) fn mobility(&self) -> &Matrix3<f64> {
        self.collision.mobility().matrix()
    }

    /// f, or 1 where that is no measure of velocities.
    pub(crate) fn scale(&self) -> f64 {
        match self.collision.friction().get() {
            f if f > 0.0 && f < 1.0 => f,
            _ => 1.0,
        }
    }

    /// |gamma| f (|gamma| where f > 1).
    pub(crate) fn strength(&self) -> f64 {
        self.collision.hertz().materials().gamma().abs() * self.scale()
    }

    /// |gamma| f, however great f is.
    pub(crate) fn parting(&self) -> f64 {
        self.collision.hertz().materials().gamma().abs() * self.collision.friction().get()
    }

    /// A run. Steps of an impact that resembles a free one are placed in time: their errors are then smooth.
    pub(crate) fn run(&self, fineness: Fineness) -> Result<Run, NumericalImpactError> {
        let (hertz, velocity) = (*self.collision.hertz(), self.impact.velocity());
        let (friction, peak) = (self.collision.friction(), self.impact.deepest());
        let law = NumericalLaw::new(hertz, friction, peak, fineness.cells)?;
        let law = law.within(TOLERANCE)?.with_slip_ahead();
        let trajectory = Trajectory {
            mobility: *self.mobility(),
            velocity,
            stiffness: hertz.stiffness(),
            steps: fineness.steps,
            expected: self.impact.is_mild().then(|| self.normal.duration()),
        };
        let mut samples = Vec::new();
        let end = match self.impact.material_viscosity().map_err(NumericalImpactError::from)? {
            None => {
                let mut law = law;
                let observe = |point: &Point, law: &NumericalLaw| samples.push(sample(point, law));
                trajectory.follow_at_most(PATIENCE, &mut law, observe)?
            }
            Some(viscosity) => {
                let mut law = ViscousLaw::new(law, viscosity, friction.get(), hertz.stiffness());
                let observe = |point: &Point, law: &ViscousLaw<NumericalLaw>| {
                    samples.push(sample(point, law.elastic()));
                };
                trajectory.follow_at_most(PATIENCE, &mut law, observe)?
            }
        };
        let end = end.ok_or(NumericalImpactError::NoSeparation)?;
        let turns =
            samples.windows(2).filter(|pair| pair[0].velocity.z <= 0.0 && pair[1].velocity.z > 0.0);
        Ok(Run {
            impulse: end.impulse,
            duration: end.time,
            peak: Peak::of(&samples),
            compressions: 1 + turns.count() as u32,
            samples,
        })
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
