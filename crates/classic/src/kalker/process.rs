//! The processes of Johnson and of Panagiotopoulos: NORM and TANG one after the other.

use carom_special::RangeError;

use super::charts::{JOHNSON, PANAGIOTOPOULOS, ProcessStep};
use super::norm::{NORM, Norm};
use super::scratch::{KalkerScratch, Parameters};
use super::tang::{TANG, Tang};
use crate::chart::{self, Block, Machine, Trace};
use crate::direct::{DirectError, End};
use carom_solver::{ContactProblem, ContactState, Convergence, Drive, Method, Observer, Stop};

struct Process<'a> {
    scratch: &'a mut KalkerScratch,
    parameters: Parameters,
    passes: usize,
    observer: &'a mut dyn Observer,
    solved: usize,
    reached: Option<Convergence>,
}

impl Process<'_> {
    /// Solves the normal problem. Returns the largest change of a pressure relative to the largest
    /// pressure.
    fn norm(&mut self) -> Result<f64, DirectError> {
        let before = self.scratch.outcome.traction[2].clone();
        let (mut sets, traces) = self.scratch.work()?;
        let mut machine = Norm { sets: &mut sets, rounds: self.parameters.rounds, moved: 0.0 };
        let mut trace = Trace::default();
        chart::run(&mut machine, NORM, &mut trace)?;
        self.solved += sets.solved;
        traces.norm.push(trace);
        let now = &self.scratch.outcome.traction[2];
        let change = now.iter().zip(&before).map(|(now, before)| (now - before).abs());
        Ok(change.fold(0.0, f64::max) / now.iter().copied().fold(f64::MIN_POSITIVE, f64::max))
    }

    /// Solves the tangential problem, starting from complete adhesion. Returns the number of linear
    /// systems.
    fn tang(&mut self) -> Result<f64, DirectError> {
        let Parameters { rounds, turn: tolerance, .. } = self.parameters;
        let (mut sets, traces) = self.scratch.work()?;
        sets.let_all_stick();
        sets.let_the_smooth_slip();
        sets.displace();
        let mut machine = Tang { sets: &mut sets, rounds, tolerance, moved: 0.0 };
        let mut trace = Trace::default();
        chart::run(&mut machine, TANG, &mut trace)?;
        let solved = sets.solved;
        self.solved += solved;
        traces.tang.push(trace);
        Ok(solved as f64)
    }
}

impl Machine for Process<'_> {
    type Step = ProcessStep;
    type Error = DirectError;

    fn perform(&mut self, step: ProcessStep) -> Result<f64, DirectError> {
        match step {
            ProcessStep::Norm => self.norm(),
            ProcessStep::Tang => self.tang(),
            ProcessStep::PressuresStand => Ok(0.0),
        }
    }

    fn is_done(&mut self, _: ProcessStep, round: usize) -> Result<bool, DirectError> {
        let reached = self.scratch.reached(self.solved, self.observer)?;
        self.reached = Some(reached);
        let stands = reached.residuals.normal <= self.parameters.tolerance;
        Ok(stands || reached.stop == Stop::Observer || round >= self.passes)
    }
}

/// Johnson's process: NORM, then TANG. It is exact if the materials are not coupled; a coupled
/// problem is an error. The matrices are dense, with two unknowns in an element that sticks and one
/// in one that slips. Shifts must be prescribed.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction, law::Shift};
/// use carom_classic::kalker::Johnson;
/// use carom_solver::{ContactProblem, ContactState, Drive, Gap, Method};
/// let grid = Grid::new(16, 16, 0.14, 0.14)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.0)?;
/// let problem =
///     ContactProblem::of_half_spaces(gap, MaterialPair::new(body, body)?, Friction::new(0.4)?)?;
/// let method = Johnson::default();
/// let mut scratch = method.scratch(&problem)?;
/// let apart = ContactState::apart(grid);
/// let mut state = apart.clone();
/// // Cattaneo at half the shift of full slip.
/// let drive = Drive::by_shift(Shift { zeta: 1.0, xi: 0.2, ..Shift::default() });
/// method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
/// let load = state.load();
/// assert!((load.f_x / (0.4 * load.f_z) - (1.0 - 0.5_f64.powf(1.5))).abs() < 2e-2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Johnson {
    parameters: Parameters,
}

/// Panagiotopoulos's process: NORM and TANG alternate until the pressures converge. It converges if
/// f |gamma| is well below one (13.43). The matrices are dense. Shifts must be prescribed.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction, law::Shift};
/// use carom_classic::kalker::{Panagiotopoulos, ProcessStep};
/// use carom_solver::{ContactProblem, ContactState, Drive, Gap, Method};
/// let grid = Grid::new(10, 10, 0.22, 0.22)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let (one, two) = (Material::from_shear(1.0, 0.0)?, Material::from_shear(1.0, 0.5)?);
/// let problem = ContactProblem::of_half_spaces(gap, MaterialPair::new(one, two)?, Friction::new(0.4)?)?;
/// let method = Panagiotopoulos::default();
/// let mut scratch = method.scratch(&problem)?;
/// let apart = ContactState::apart(grid);
/// let mut state = apart.clone();
/// let drive = Drive::by_shift(Shift { zeta: 1.0, xi: 0.2, ..Shift::default() });
/// method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
/// assert!(scratch.traces().process.count(ProcessStep::Norm) > 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Panagiotopoulos {
    parameters: Parameters,
    passes: usize,
}

impl Default for Panagiotopoulos {
    /// Tolerance 1e-10, at most 100 passes.
    fn default() -> Self {
        Self { parameters: Parameters::default(), passes: 100 }
    }
}

impl Johnson {
    /// Sets the tolerance: violations of the normal conditions relative to the greatest
    /// displacement, and of the friction law relative to the greatest friction limit.
    ///
    /// # Errors
    /// [`RangeError`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        Ok(Self { parameters: self.parameters.within(tolerance)? })
    }

    /// Limits the passes of each loop.
    #[must_use]
    pub const fn at_most(self, rounds: usize) -> Self {
        Self { parameters: Parameters { rounds, ..self.parameters } }
    }
}

impl Panagiotopoulos {
    /// Sets the tolerance: violations of the normal conditions relative to the greatest
    /// displacement, and of the friction law relative to the greatest friction limit.
    ///
    /// # Errors
    /// [`RangeError`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        Ok(Self { parameters: self.parameters.within(tolerance)?, ..self })
    }

    /// Limits the passes of each loop of NORM and TANG, and the passes of the process.
    #[must_use]
    pub const fn at_most(self, rounds: usize, passes: usize) -> Self {
        Self { parameters: Parameters { rounds, ..self.parameters }, passes }
    }
}

/// Executes the chart of a process.
struct Order<'a> {
    chart: &'static [Block<ProcessStep>],
    parameters: Parameters,
    passes: usize,
    problem: &'a ContactProblem,
    from: &'a ContactState,
    drive: &'a Drive,
}

impl Order<'_> {
    fn fulfil(
        &self,
        to: &mut ContactState,
        scratch: &mut KalkerScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, DirectError> {
        let Self { chart, parameters, passes, problem, from, drive } = *self;
        if let Some(convergence) = scratch.begin(problem, from, drive, to)? {
            return Ok(convergence);
        }
        let mut trace = Trace::default();
        let mut process =
            Process { scratch, parameters, passes, observer, solved: 0, reached: None };
        chart::run(&mut process, chart, &mut trace)?;
        let reached = match process.reached {
            Some(reached) => reached,
            None => process.scratch.reached(process.solved, process.observer)?,
        };
        scratch.traces.process = trace;
        scratch.end(End { tolerance: parameters.tolerance, reached, from, drive }, to)
    }
}

impl Method for Johnson {
    type Error = DirectError;
    type Scratch = KalkerScratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<KalkerScratch, DirectError> {
        if problem.operator().is_coupled() {
            return Err(DirectError::Coupled { method: "Johnson" });
        }
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
        let (chart, parameters) = (JOHNSON, self.parameters);
        Order { chart, parameters, passes: 1, problem, from, drive }.fulfil(to, scratch, observer)
    }
}

impl Method for Panagiotopoulos {
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
        let Self { parameters, passes } = *self;
        let order = Order { chart: PANAGIOTOPOULOS, parameters, passes, problem, from, drive };
        order.fulfil(to, scratch, observer)
    }
}
