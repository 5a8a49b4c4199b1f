//! An impact on ever finer grids and steps, each refined apart.
//!
//! With F a run, S what the second half of its steps changed and C what the second half of its cells changed, the
//! result is `F + S/3 + 0.27 C` (Richardson for an error of second order in the step; half of what an error of
//! order 3/2 in the cell leaves), and the estimate of its error the greater of `0.6 |S|` and `0.18 |S'|`, with `0.48 |C|`
//! and a floor. S' is S of twice the step: two runs may agree by chance, where the step in which sliding ends matters.

use nalgebra::Vector3;

use crate::NumericalImpactError;
use crate::run::{Fineness, Problem, Run};

/// What is added of the change by steps, and what of it counts for the error.
const STEPS: Share = Share { added: 1.0 / 3.0, left: 0.6 };
/// What counts of the change by steps before that.
const STEPS_BEFORE: f64 = 0.18;
/// The same of the change by cells.
const CELLS: Share = Share { added: 0.27, left: 0.48 };
/// What may be left where both changes are small: in the tangential velocity over f v_z, in the normal one over v_z.
const FLOOR: [f64; 2] = [9e-4, 1.8e-4];
/// The same of the tangential velocity, over |gamma| f: cells that come into contact meet spreading surfaces.
const FLOOR_BY_STRENGTH: f64 = 0.018;
/// The first and the finest grids and steps.
const FIRST: Fineness = Fineness { cells: 16, steps: 64 };
const FINEST: Fineness = Fineness { cells: 64, steps: 512 };
/// The same where gamma f exceeds [`PARTING`]: there the bodies part on one side, and pressures and tractions are hard to find
/// together. Above gamma f = 4 each step factors dense matrices of all slipping cells, so that a run on 64 cells takes hours.
const FINEST_PARTING: Fineness = Fineness { cells: 32, steps: 256 };
const PARTING: f64 = 1.0;
/// Cells times steps of a run at the most: those of the finest run of an impact that lasts twice as long as a free one.
const MOST_WORK: usize = 2 * FINEST.steps * FINEST.cells * FINEST.cells;
/// The fewest cells of a coarse grid.
const FEWEST: usize = 4;

struct Share {
    added: f64,
    left: f64,
}

/// A refined impact: the finest run, the limit of all, and how far it may be off.
pub(crate) struct Found {
    pub(crate) finest: Run,
    pub(crate) impulse: Vector3<f64>,
    pub(crate) velocity: Vector3<f64>,
    /// In the tangential velocity over f v_z (over v_z where f > 1).
    pub(crate) tangential: f64,
    /// In the normal velocity over v_z.
    pub(crate) normal: f64,
}

/// The finest run and what changed the impulse last.
struct Refined {
    fineness: Fineness,
    finest: Run,
    by_steps: Vector3<f64>,
    by_steps_before: Vector3<f64>,
    by_cells: Vector3<f64>,
}

impl Problem<'_> {
    /// Refines what seems to be off most until the estimates of the tangential velocity over f v_z and of the normal one
    /// over v_z are as allowed, or nothing finer is left.
    pub(crate) fn settled(&self, allowed: [f64; 2]) -> Result<Found, NumericalImpactError> {
        let (mut refined, finest) = (self.begun(FIRST)?, self.finest());
        loop {
            let found = self.judged(&refined);
            if found.tangential <= allowed[0] && found.normal <= allowed[1] {
                return Ok(self.found(refined, found));
            }
            let Fineness { cells, steps } = refined.fineness;
            let work = refined.finest.samples.len() * cells * cells;
            let finer_steps = steps < finest.steps && 2 * work <= MOST_WORK;
            let finer_cells = cells < finest.cells && 4 * work <= MOST_WORK;
            let steps_are_off = worse(self.by_steps(&refined), self.by_cells(&refined));
            refined = match (finer_steps, finer_cells) {
                (false, false) => return Ok(self.found(refined, found)),
                (true, _) if steps_are_off || !finer_cells => self.with_more_steps(refined)?,
                _ => self.with_more_cells(refined)?,
            };
        }
    }

    /// The finest cells and steps that a default refinement takes.
    fn finest(&self) -> Fineness {
        if self.parting() > PARTING { FINEST_PARTING } else { FINEST }
    }

    /// With these cells and steps, and half of each for the estimate.
    pub(crate) fn at(&self, fineness: Fineness) -> Result<Found, NumericalImpactError> {
        let refined = self.begun(fineness)?;
        let found = self.judged(&refined);
        Ok(self.found(refined, found))
    }

    fn begun(&self, fineness: Fineness) -> Result<Refined, NumericalImpactError> {
        let Fineness { cells, steps } = fineness;
        let (half, fewer) = (steps / 2, (cells / 2).max(FEWEST));
        let coarsest = self.run(Fineness { cells: fewer, steps: steps / 4 })?;
        let coarse = self.run(Fineness { cells: fewer, steps: half })?;
        let middle = self.run(Fineness { cells, steps: half })?;
        let finest = self.run(fineness)?;
        let by_steps = finest.impulse - middle.impulse;
        let by_steps_before = coarse.impulse - coarsest.impulse;
        let by_cells = middle.impulse - coarse.impulse;
        Ok(Refined { fineness, finest, by_steps, by_steps_before, by_cells })
    }

    fn with_more_steps(&self, last: Refined) -> Result<Refined, NumericalImpactError> {
        let Fineness { cells, steps } = last.fineness;
        let fineness = Fineness { cells, steps: 2 * steps };
        let finest = self.run(fineness)?;
        let by_steps = finest.impulse - last.finest.impulse;
        Ok(Refined { fineness, finest, by_steps, by_steps_before: last.by_steps, ..last })
    }

    fn with_more_cells(&self, last: Refined) -> Result<Refined, NumericalImpactError> {
        let Fineness { cells, steps } = last.fineness;
        let fineness = Fineness { cells: 2 * cells, steps };
        let finest = self.run(fineness)?;
        let by_cells = finest.impulse - last.finest.impulse;
        Ok(Refined { fineness, finest, by_cells, ..last })
    }

    /// Changes of the tangential velocity over f v_z and of the normal one over v_z, by a change of the impulse.
    fn velocities(&self, impulse: &Vector3<f64>) -> [f64; 2] {
        let speed = self.impact.velocity().z;
        let change = self.mobility() * impulse;
        [libm::hypot(change.x, change.y) / (self.scale() * speed), change.z.abs() / speed]
    }

    /// The parts of the estimate, in the tangential velocity over f v_z and in the normal one over v_z.
    fn by_steps(&self, refined: &Refined) -> [f64; 2] {
        let now = self.velocities(&refined.by_steps);
        let before = self.velocities(&refined.by_steps_before);
        std::array::from_fn(|i| (STEPS.left * now[i]).max(STEPS_BEFORE * before[i]))
    }

    fn by_cells(&self, refined: &Refined) -> [f64; 2] {
        self.velocities(&refined.by_cells).map(|change| CELLS.left * change)
    }

    fn judged(&self, refined: &Refined) -> Judged {
        let Refined { finest, by_steps, by_cells, .. } = refined;
        let limit = finest.impulse + by_steps * STEPS.added + by_cells * CELLS.added;
        let impulse = self.impact.restricted(&limit);
        let moved = self.velocities(&(limit - impulse));
        let (steps, cells) = (self.by_steps(refined), self.by_cells(refined));
        let floor = [FLOOR[0] + FLOOR_BY_STRENGTH * self.strength(), FLOOR[1]];
        let [tangential, normal] =
            std::array::from_fn(|i| moved[i].max(steps[i] + cells[i] + floor[i]));
        Judged { impulse, tangential, normal }
    }

    fn found(&self, refined: Refined, judged: Judged) -> Found {
        let Judged { impulse, tangential, normal } = judged;
        let velocity = self.impact.velocity() - self.mobility() * impulse;
        Found { finest: refined.finest, impulse, velocity, tangential, normal }
    }
}

/// The limit of the runs and how far its velocities may be off.
struct Judged {
    impulse: Vector3<f64>,
    tangential: f64,
    normal: f64,
}

/// Whether one error is greater than another.
fn worse(one: [f64; 2], other: [f64; 2]) -> bool {
    one[0].max(one[1]) >= other[0].max(other[1])
}
