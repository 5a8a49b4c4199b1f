//! KOMBI: pressures and tractions of dissimilar bodies in one linear system.

use super::charts::{KOMBI, KombiStep};
use super::scratch::{KalkerScratch, Parameters};
use super::sets::{ROUNDING, Sets};
use crate::chart::{self, Machine};
use crate::direct::dense::Unknown;
use crate::direct::{DirectError, End};
use carom_solver::{CellState, ContactProblem, ContactState, Convergence, Drive, Method, Observer};

/// Largest rotation of a direction in one Newton step, in radians. Where the pressure is nearly
/// zero, the linearised law could rotate it arbitrarily.
const LARGEST_ROTATION: f64 = 0.5;

/// The directions of slip are approximate in this many rounds at most.
const APPROXIMATE_ROUNDS: usize = 12;

struct Work<'a, 'b> {
    sets: &'b mut Sets<'a>,
    parameters: Parameters,
    moved: f64,
    /// Whether the directions of slip are found exactly: no area changed any more at approximate ones.
    exact: bool,
}

impl Work<'_, '_> {
    /// f |p|: an element in tension keeps its direction until it is removed.
    fn limit(&self, cell: usize) -> f64 {
        self.sets.demand.limit(cell, self.sets.outcome.traction[2][cell].abs())
    }

    fn solve(&mut self) -> Result<f64, DirectError> {
        self.sets.displace();
        let touching: Vec<usize> = self.sets.outcome.touching().collect();
        let mut unknowns: Vec<Unknown> = Vec::with_capacity(3 * touching.len());
        let mut slipping = Vec::new();
        for cell in touching {
            let limit = self.limit(cell);
            let pressure = self.sets.pressure(cell);
            if !self.sets.slips(cell) {
                unknowns.push(pressure);
                unknowns.extend(self.sets.stick(cell));
                continue;
            }
            let [n_x, n_y] = self.sets.outcome.direction(cell);
            let friction = self.sets.demand.friction[cell];
            // Coulomb's law for the increment: the traction grows with the pressure.
            unknowns.push(Unknown { direction: [friction * n_x, friction * n_y, 1.0], ..pressure });
            if limit > 0.0 {
                slipping.push((unknowns.len(), cell, limit));
                unknowns.push(self.sets.turn(cell, limit));
            }
        }
        let before: Vec<[f64; 2]> =
            slipping.iter().map(|&(_, cell, _)| self.sets.outcome.direction(cell)).collect();
        let amounts = self.sets.solve(&unknowns)?;
        let mut largest = 0.0_f64;
        for ((unknown, cell, limit), [x, y]) in slipping.into_iter().zip(before) {
            let turn = amounts[unknown] / limit;
            largest = largest.max(turn.abs());
            let (sin, cos) = turn.clamp(-LARGEST_ROTATION, LARGEST_ROTATION).sin_cos();
            let limit = self.limit(cell);
            self.sets.outcome.pull(cell, limit, [x * cos - y * sin, y * cos + x * sin]);
        }
        Ok(largest)
    }
}

impl Work<'_, '_> {
    /// Removes cells in tension. If one sticks, it might be in compression once it slips: it is
    /// made to slip first, and leaves the contact only if it is still in tension.
    fn shrink(&mut self) -> f64 {
        let touching: Vec<usize> = self.sets.outcome.touching().collect();
        let mut count = 0.0;
        for cell in touching {
            let pulls = self.sets.outcome.traction[2][cell] <= 0.0;
            let limit = self.limit(cell);
            let [x, y] = self.sets.outcome.tangent(cell);
            if pulls && (self.sets.slips(cell) || limit.is_infinite() || limit == 0.0) {
                self.sets.outcome.release(cell);
            } else if !self.sets.slips(cell) && (pulls || x.hypot(y) > limit * (1.0 + ROUNDING)) {
                let direction = self.sets.outcome.direction(cell);
                self.sets.outcome.pull(cell, limit, direction);
                self.sets.outcome.cells[cell] = CellState::Slip;
            } else {
                continue;
            }
            count += 1.0;
        }
        count
    }
}

impl Machine for Work<'_, '_> {
    type Step = KombiStep;
    type Error = DirectError;

    fn perform(&mut self, step: KombiStep) -> Result<f64, DirectError> {
        self.moved = match step {
            KombiStep::Solve => self.solve()?,
            KombiStep::Shrink => self.shrink(),
            KombiStep::Grow => {
                self.sets.displace();
                let stuck = self.sets.let_stick();
                let added = self.sets.add_overlap();
                self.sets.let_the_smooth_slip();
                stuck + added
            }
            KombiStep::DirectionsStand | KombiStep::NoneToShrink | KombiStep::NoneToGrow => 0.0,
        };
        Ok(self.moved)
    }

    fn is_done(&mut self, question: KombiStep, round: usize) -> Result<bool, DirectError> {
        if round >= self.parameters.rounds {
            return Ok(true);
        }
        let turn = self.parameters.turn;
        Ok(match question {
            // While the areas change for the first time, one linear system for each is enough.
            KombiStep::DirectionsStand => !self.exact || self.moved <= turn,
            KombiStep::NoneToGrow => {
                let stands = self.exact && self.moved == 0.0;
                self.exact |= self.moved == 0.0 || round >= APPROXIMATE_ROUNDS;
                stands
            }
            _ => self.moved == 0.0,
        })
    }
}

/// The KOMBI process: NORM and TANG in one linear system, so that dissimilar materials need no
/// alternation. There are three unknowns in an element that sticks and two in one that slips. While the areas
/// change, one linear system is solved for each; the directions of slip are found exactly at the end.
/// Shifts must be prescribed.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction, law::Shift};
/// use carom_classic::kalker::Kombi;
/// use carom_solver::{ContactProblem, ContactState, Drive, Gap, Method};
/// let grid = Grid::new(10, 10, 0.22, 0.22)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let (one, two) = (Material::from_shear(1.0, 0.0)?, Material::from_shear(1.0, 0.5)?);
/// let problem = ContactProblem::of_half_spaces(gap, MaterialPair::new(one, two)?, Friction::new(0.4)?)?;
/// let method = Kombi::default();
/// let mut scratch = method.scratch(&problem)?;
/// let apart = ContactState::apart(grid);
/// let mut state = apart.clone();
/// let drive = Drive::by_shift(Shift { zeta: 1.0, xi: 0.2, ..Shift::default() });
/// let convergence = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
/// assert!(convergence.residuals.normal < 1e-10 && state.load().f_x > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Kombi {
    parameters: Parameters,
}

impl Kombi {
    /// Sets the tolerance: violations of the normal conditions relative to the greatest
    /// displacement, and of the friction law relative to the greatest friction limit.
    ///
    /// # Errors
    /// [`carom_special::RangeError`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, carom_special::RangeError> {
        Ok(Self { parameters: self.parameters.within(tolerance)? })
    }

    /// Limits the passes of each loop.
    #[must_use]
    pub const fn at_most(self, rounds: usize) -> Self {
        Self { parameters: Parameters { rounds, ..self.parameters } }
    }
}

impl Method for Kombi {
    type Error = DirectError;
    type Scratch = KalkerScratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<KalkerScratch, DirectError> {
        KalkerScratch::new(problem)
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut KalkerScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, DirectError> {
        let parameters = self.parameters;
        if let Some(convergence) = scratch.begin(problem, from, drive, to)? {
            return Ok(convergence);
        }
        let (mut sets, traces) = scratch.work()?;
        sets.press(parameters.rounds)?;
        sets.let_the_smooth_slip();
        let mut machine = Work { sets: &mut sets, parameters, moved: 0.0, exact: false };
        chart::run(&mut machine, KOMBI, &mut traces.kombi)?;
        let solved = sets.solved;
        let reached = scratch.reached(solved, observer)?;
        scratch.end(End { tolerance: parameters.tolerance, reached, from, drive }, to)
    }
}
