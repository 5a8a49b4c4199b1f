//! Contact with Coulomb's friction: normal and tangential problem in turn.

mod alternation;
mod anderson;
mod boxed;
mod cone;
mod coupled;
mod displacements;
mod limits;
mod pass;
mod sliding;

use std::sync::Arc;

use carom_halfspace::operator::{OperatorError, SurfaceOperator};
use carom_laws::law::Shift;
use carom_special::RangeError;

use crate::convergence::{Convergence, Observer, Products, Stop};
use crate::drive::{Drive, Driven};
use crate::frictional::anderson::Mixing;
use crate::frictional::coupled::Coupled;
use crate::frictional::limits::FrictionLimits;
use crate::method::Method;
use crate::nested;
use crate::normal::NormalGrids;
use crate::problem::{ContactProblem, PeriodError};
use crate::state::ContactState;
use crate::tangential::{LimitSurface, Rigid, TangentialScratch};
use boxed::{Boxed, InBox};
use pass::Pass;

/// Contact with Coulomb's friction, one step at a time: pressures at the last tractions, tractions
/// at these pressures, and so on (Panagiotopoulos) until the pressures stand; one pass where the
/// materials are not coupled. Pressures come from preconditioned conjugate gradients on an active
/// set, tractions from Newton's method on sets of sticking and slipping cells; both start from
/// coarser grids where nothing better is known.
///
/// Each of the four motions is driven by its shift or by its load. A load that friction cannot hold is an
/// error ([`FrictionalError::Slides`], [`FrictionalError::Turns`]). Loads of dissimilar bodies just below that
/// limit are found by the motions that lead to them: there all cells slip, and the shift grows as the
/// inverse root of what is missing to the limit.
///
/// A step costs what its contact covers, not what the window does: on many cells it is solved on a box
/// about the contact, found anew in each step on coarse cells, and on the whole window where bodies
/// would overlap outside the box.
///
/// Where static friction is above the kinetic one, a cell sticks up to `f_s p`; once it slips its
/// limit is `f_k p`, within the step at once and in later steps for as long as it slips. A step
/// without slip heals it. Cells break in turn until none is at its static limit: what each of them
/// lets go loads its neighbours. No length comes with this law, so that tractions at the tip of the
/// slipping area are singular without bound and the static friction matters less on each finer grid.
/// In Cattaneo's problem with `f_s = 1.5 f_k` the tangential force exceeds that of kinetic friction
/// alone by 0.21, 0.13, 0.056, 0.028 % of the normal force on 16, 32, 64, 128 cells a side: in
/// proportion to their width. What depends on the difference belongs to its grid.
///
/// Infinite friction is infinite where the materials are not coupled. Where they are, it is the limit of
/// Coulomb's law, with 1e9 for the coefficient. No cell is then in the state [`CellState::Slip`](crate::CellState::Slip). Cells
/// at the edge that would need tension to stick are dragged along: the surfaces touch there at a pressure
/// of 1e-9 of the traction, which opposes their displacement. [`ContactState::slip_since`] tells
/// it, and [`crate::dissipated`] its work.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction, law::Shift};
/// use carom_solver::{CellState, ContactProblem, ContactState, Drive, Frictional, Gap, Method};
/// let grid = Grid::new(48, 48, 0.05, 0.05)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.0)?;
/// let pair = MaterialPair::new(body, body)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.4)?)?;
/// let method = Frictional::default();
/// let mut scratch = method.scratch(&problem)?;
/// let mut pressed = ContactState::apart(grid);
/// let mut shifted = pressed.clone();
/// let to = |xi| Drive::by_shift(Shift { zeta: 1.0, xi, ..Shift::default() });
/// method.step(&problem, &pressed.clone(), &to(0.0), &mut pressed, &mut scratch, &mut ())?;
/// // Cattaneo: at xi = f zeta/2 and nu = 0 the stick area has half the depth, F_x/(f F_z) = 1 - 2^(-3/2).
/// method.step(&problem, &pressed, &to(0.2), &mut shifted, &mut scratch, &mut ())?;
/// let load = shifted.load();
/// assert!((load.f_x / (0.4 * load.f_z) - (1.0 - 0.5_f64.powf(1.5))).abs() < 3e-3);
/// assert!(shifted.count(CellState::Slip) > 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frictional {
    tolerance: f64,
    iterations: usize,
    passes: usize,
}

/// Why a step with friction failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FrictionalError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The operator failed.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// No load on a period leads to a given shift.
    #[error(transparent)]
    Period(#[from] PeriodError),
    /// A tangential force is given that friction cannot hold: the bodies slide.
    #[error(
        "the tangential force {force} is not below what friction can hold, {limit}: the bodies slide"
    )]
    Slides {
        /// The force.
        force: f64,
        /// The friction limit, the sum of f p, as far as it is known: to 1e-12 of itself.
        limit: f64,
    },
    /// A torque is given, alone or beside a force, that friction cannot hold: the bodies turn on each other.
    #[error(
        "friction holds loads below {part} times the torque {torque} and the tangential force {force}: \
         the bodies slide"
    )]
    Turns {
        /// The torque.
        torque: f64,
        /// The tangential force.
        force: f64,
        /// What friction can hold over what is given; at most 1.
        part: f64,
    },
    /// Iterations ended before the tolerance was reached.
    #[error(
        "the {what} are not found within {tolerance:.1e}: {:.1e} (normal), {:.1e} (tangential) after \
         {} iterations ({:?})",
        .reached.residuals.normal, .reached.residuals.tangential, .reached.iterations, .reached.stop
    )]
    NotConverged {
        /// Pressures, tractions, or both together.
        what: &'static str,
        /// The tolerance.
        tolerance: f64,
        /// How far it got.
        reached: Convergence,
    },
}

impl Default for Frictional {
    /// To 1e-9 of the greatest displacement and of the greatest friction limit.
    fn default() -> Self {
        Self { tolerance: 1e-9, iterations: 1000, passes: 300 }
    }
}

impl Frictional {
    /// To another tolerance: violations of the normal conditions over the greatest displacement, and
    /// of the friction law over the greatest friction limit.
    ///
    /// # Errors
    /// [`RangeError`] unless it lies in 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        let holds = (1e-13..=0.01).contains(&tolerance);
        RangeError::check("tolerance", tolerance, holds, "from 1e-13 to 0.01")?;
        Ok(Self { tolerance, ..self })
    }

    /// With at most so many iterations of each problem on each grid, and so many passes.
    ///
    /// # Errors
    /// [`RangeError`] unless there is at least one of each.
    pub fn at_most(self, iterations: usize, passes: usize) -> Result<Self, RangeError> {
        RangeError::check("iterations", iterations as f64, iterations > 0, "at least 1")?;
        RangeError::check("passes", passes as f64, passes > 0, "at least 1")?;
        Ok(Self { iterations, passes, ..self })
    }
}

/// The working memory of [`Frictional`].
#[derive(Clone)]
pub struct FrictionalScratch {
    normal: NormalGrids,
    tangential: TangentialScratch,
    limits: FrictionLimits,
    /// The tangential displacement by pressure; empty, as the two below the next, where neither acts
    /// on the other.
    by_pressure: [Vec<f64>; 2],
    offset: [Vec<f64>; 2],
    /// The normal displacement by tangential tractions, of this pass and the last one.
    by_traction: Vec<f64>,
    last: Vec<f64>,
    mixing: Mixing,
    /// Cells that have slipped since they last stuck.
    broken: Vec<bool>,
    /// Pressures and tractions together, built when it is first needed.
    coupled: Option<Box<Coupled>>,
    /// What friction can hold under the pressures of this pass.
    surface: LimitSurface,
    /// The box of the last step that had one, and the normal displacements of all cells.
    boxed: Option<Box<Boxed>>,
    sunk: Vec<f64>,
}

impl Method for Frictional {
    type Error = FrictionalError;
    type Scratch = FrictionalScratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<FrictionalScratch, FrictionalError> {
        self.scratch_with(problem, &nested::coarser_operators(problem.operator())?)
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, FrictionalError> {
        drive.check()?;
        from.check_grid(problem.grid())?;
        if let Some(zeta) = problem.apart(drive.normal) {
            refuse_tangential_loads(drive)?;
            *to = ContactState::apart(problem.grid());
            to.shift = Shift { zeta, ..drive.shift_after(from.shift) };
            let (products, residuals) = Default::default();
            return Ok(Convergence { iterations: 0, products, residuals, stop: Stop::Converged });
        }
        problem.check_approach(drive.normal)?;
        match self.step_in_a_box(problem, from, drive, to, scratch, observer)? {
            InBox::Solved(convergence) => Ok(convergence),
            InBox::NotWorthIt | InBox::Escaped => {
                self.step_on_all(problem, from, drive, to, scratch, observer)
            }
        }
    }
}

impl Frictional {
    fn scratch_with(
        &self,
        problem: &ContactProblem,
        coarser: &[Arc<dyn SurfaceOperator>],
    ) -> Result<FrictionalScratch, FrictionalError> {
        let operator = problem.operator();
        let zero = || vec![0.0; problem.grid().cells()];
        let heights = problem.gap().heights().values();
        let coupling = || if operator.is_coupled() { zero() } else { Vec::new() };
        Ok(FrictionalScratch {
            normal: NormalGrids::new(operator, heights, || Ok(coarser.to_vec()))?,
            tangential: TangentialScratch::new(operator, coarser),
            limits: FrictionLimits::new(problem.grid().cells()),
            by_pressure: [coupling(), coupling()],
            offset: [zero(), zero()],
            by_traction: coupling(),
            last: coupling(),
            mixing: Mixing::default(),
            broken: vec![false; problem.grid().cells()],
            coupled: None,
            surface: LimitSurface::default(),
            boxed: None,
            sunk: Vec::new(),
        })
    }

    /// A step that touches, on all cells.
    fn step_on_all(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, FrictionalError> {
        let area = problem.grid().cell_area();
        let load = |driven| match driven {
            Driven::Shift(_) => None,
            Driven::Load(load) => Some(load / area),
        };
        let loads = [load(drive.x), load(drive.y), load(drive.twist)];
        let (spent, rigid) = (Products::default(), Rigid { loads, ..Rigid::default() });
        let (together, slides) = (false, None);
        let mut pass =
            Pass { method: self, problem, from, drive, rigid, observer, spent, together, slides };
        pass.until_no_cell_breaks(to, scratch)
    }
}

/// Separated bodies hold no load along the surface.
fn refuse_tangential_loads(drive: &Drive) -> Result<(), FrictionalError> {
    let [x, y, torque] = [drive.x, drive.y, drive.twist].map(|driven| match driven {
        Driven::Load(load) => load,
        Driven::Shift(_) => 0.0,
    });
    let force = x.hypot(y);
    if torque != 0.0 {
        return Err(FrictionalError::Turns { torque, force, part: 0.0 });
    }
    if force != 0.0 {
        return Err(FrictionalError::Slides { force, limit: 0.0 });
    }
    Ok(())
}

fn converged(
    what: &'static str,
    tolerance: f64,
    reached: Convergence,
) -> Result<Convergence, FrictionalError> {
    if reached.stop == Stop::Converged {
        Ok(reached)
    } else {
        Err(FrictionalError::NotConverged { what, tolerance, reached })
    }
}
