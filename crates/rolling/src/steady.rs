//! Steady rolling, solved directly.

use carom_halfspace::operator::{DisplacementField, TractionField};
use carom_laws::law::Shift;
use carom_special::RangeError;

use super::{Creepage, RollingError, check_room, columns};
use carom_classic::kalker::{KalkerScratch, Panagiotopoulos};
use carom_solver::Method as _;
use carom_solver::{
    CellState, ContactProblem, ContactState, Convergence, Drive, Driven, Frictionless,
};

/// Relative accuracy of a prescribed normal force.
const FORCE_TOLERANCE: f64 = 1e-9;
/// Greatest number of approaches tried for a normal force.
const MOST_SECANTS: usize = 20;

/// Steady rolling.
#[derive(Debug, Clone)]
pub struct SteadyRolling {
    /// Tractions, displacements and areas, which are constant in time; the shift is that of one
    /// step.
    pub state: ContactState,
    /// The convergence of the solution.
    pub convergence: Convergence,
    /// Whether the creepage is above saturation: the whole contact slides, and more creepage does
    /// not increase the force.
    pub slides: bool,
}

/// Solves for steady rolling at an approach or under a normal force, in steps of this distance, by
/// NORM and TANG with the coefficients of u(x) - u(x + distance). It is the limit of
/// [`super::Roll`] with the same distance.
///
/// For a prescribed normal force the approach is found by a secant iteration, starting from the
/// approach without friction; for uncoupled materials that is the solution.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::friction::Friction;
/// use carom_rolling::{Creepage, roll_steadily};
/// use carom_solver::{ContactProblem, Driven, Gap};
/// let grid = Grid::new(14, 12, 0.2, 0.2)?;
/// let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
/// let body = Material::from_shear(1.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3)?)?;
/// let at = |along| {
///     let creepage = Creepage { along, ..Creepage::default() };
///     roll_steadily(&problem, Driven::Load(2.0), grid.dx(), creepage)
/// };
/// let (some, all) = (at(0.05)?, at(1.0)?);
/// assert!(!some.slides && all.slides);
/// assert!((all.state.load().f_x / (0.3 * 2.0) - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`RollingError`] for a distance or force that is not positive, a contact too close to the
/// leading border, and if the active sets do not converge or no approach gives the force.
pub fn roll_steadily(
    problem: &ContactProblem,
    normal: Driven,
    distance: f64,
    creepage: Creepage,
) -> Result<SteadyRolling, RollingError> {
    creepage.check()?;
    let shift = columns(problem, distance)?;
    let scratch = KalkerScratch::rolling(problem, shift)?;
    let mut rolling = Rolling { problem, distance, shift, creepage, scratch, iterations: 0 };
    match normal {
        Driven::Shift(approach) => rolling.at(approach),
        Driven::Load(force) => rolling.under(force),
    }
}

/// The search for steady rolling.
struct Rolling<'a> {
    problem: &'a ContactProblem,
    distance: f64,
    /// The distance in columns.
    shift: f64,
    creepage: Creepage,
    scratch: KalkerScratch,
    iterations: usize,
}

impl Rolling<'_> {
    fn at(&mut self, approach: f64) -> Result<SteadyRolling, RollingError> {
        let Self { problem, distance, creepage, .. } = *self;
        let apart = ContactState::apart(problem.grid());
        let mut state = apart.clone();
        let drive = Drive::by_shift(Shift {
            zeta: approach,
            xi: creepage.along * distance,
            eta: creepage.across * distance,
            omega: creepage.spin * distance,
        });
        let (method, scratch) = (Panagiotopoulos::default(), &mut self.scratch);
        let convergence = method.step(problem, &apart, &drive, &mut state, scratch, &mut ())?;
        check_room(&state, self.shift)?;
        self.iterations += convergence.iterations;
        let load = TractionField::full(
            state.traction_x.values(),
            state.traction_y.values(),
            state.pressure.values(),
        );
        let out = DisplacementField::tangential(
            state.displacement_x.values_mut(),
            state.displacement_y.values_mut(),
        );
        let operator = problem.operator();
        operator.apply(load, out, &mut operator.workspace())?;
        let slides = state.count(CellState::Stick) == 0 && state.count(CellState::Slip) > 0;
        let convergence = Convergence { iterations: self.iterations, ..convergence };
        Ok(SteadyRolling { state, convergence, slides })
    }

    fn under(&mut self, force: f64) -> Result<SteadyRolling, RollingError> {
        RangeError::positive("normal force", force)?;
        let mut approach = approach_without_friction(self.problem, force)?;
        let mut last: Option<[f64; 2]> = None;
        let mut reached = 0.0;
        for _ in 0..MOST_SECANTS {
            let rolling = self.at(approach)?;
            reached = rolling.state.load().f_z;
            let missing = force - reached;
            if missing.abs() <= FORCE_TOLERANCE * force {
                return Ok(rolling);
            }
            // Hertz's tangent as the first estimate.
            let tangent = match last {
                Some([before, then]) if before != approach => {
                    (reached - then) / (approach - before)
                }
                _ => 1.5 * reached / approach,
            };
            last = Some([approach, reached]);
            approach += missing / tangent;
        }
        Err(RollingError::NormalForce { force, reached })
    }
}

fn approach_without_friction(problem: &ContactProblem, force: f64) -> Result<f64, RollingError> {
    let smooth = problem.clone().without_friction();
    let method = Frictionless::default().within(1e-12)?;
    let apart = ContactState::apart(problem.grid());
    let mut state = apart.clone();
    let drive = Drive { normal: Driven::Load(force), ..Drive::default() };
    let mut scratch = method.scratch(&smooth)?;
    method.step(&smooth, &apart, &drive, &mut state, &mut scratch, &mut ())?;
    Ok(state.shift.zeta)
}
