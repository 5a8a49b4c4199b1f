//! Contact without friction.

use carom_halfspace::operator::{
    DisplacementField, OperatorError, SurfaceOperator, TractionField, Workspace,
};
use carom_laws::law::Shift;
use carom_special::RangeError;

use crate::accuracy::{GridWarning, Side};
use crate::convergence::{Convergence, Observer, Stop};
use crate::drive::{Drive, Driven};
use crate::method::Method;
use crate::nested;
use crate::normal::{NormalGrids, Target};
use crate::parts;
use crate::problem::{ContactProblem, PeriodError};
use crate::state::ContactState;

/// Contact without friction, by preconditioned conjugate gradients on an active set. The solution
/// starts from coarser grids if operator and gap allow it.
///
/// The approach or the normal force is prescribed; tangential shifts have no effect.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction};
/// use carom_solver::{ContactProblem, ContactState, Drive, Driven, Frictionless, Gap, Method};
/// let grid = Grid::new(48, 48, 0.05, 0.05)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.5)?;
/// let pair = MaterialPair::new(body, Material::RIGID)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::NONE)?;
/// let method = Frictionless::default();
/// let mut scratch = method.scratch(&problem)?;
/// let apart = ContactState::apart(grid);
/// let mut state = apart.clone();
/// let drive = Drive { normal: Driven::Shift(1.0), ..Drive::default() };
/// method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
/// // Hertz: a sphere of radius 1, a = 1, F_z = (4/3) (2 G) a^3/R.
/// assert!((state.load().f_z / (16.0 / 3.0) - 1.0).abs() < 2e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frictionless {
    tolerance: f64,
    /// The limit of the caller; without one the operator decides.
    iterations: Option<usize>,
}

/// Greatest number of iterations on each grid, unless the caller sets one.
const ITERATIONS: usize = 1000;
/// The same for a plate. Where it is thin, the contact is a ring of cells, and bending hardly
/// varies from cell to cell: the equations are nearly singular there.
const ITERATIONS_OF_PLATE: usize = 40_000;

/// Why a frictionless step failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NormalError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The operator failed.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// No load on a periodic surface gives the prescribed approach.
    #[error(transparent)]
    Period(#[from] PeriodError),
    /// The contact reaches a border along which the body is held, such as the edge of a plate.
    #[error(
        "the contact reaches the {side} border, where the body is held and pressure has no meaning"
    )]
    HeldBorder {
        /// The border that it reaches.
        side: Side,
    },
    /// The problem has friction, which this method does not treat.
    #[error("the surfaces have friction, which this method does not support")]
    Friction,
    /// The iterations ended before the tolerance was reached.
    #[error(
        "the pressure did not converge to {:.1e}: {:.1e} after {} iterations ({})",
        .tolerance, .reached.residuals.normal, .reached.iterations, .reached.stop
    )]
    NotConverged {
        /// The tolerance.
        tolerance: f64,
        /// The convergence up to then.
        reached: Convergence,
    },
}

impl Default for Frictionless {
    /// Tolerance 1e-10, relative to the greatest displacement.
    fn default() -> Self {
        Self { tolerance: 1e-10, iterations: None }
    }
}

impl Frictionless {
    /// Sets the tolerance: the greatest gap in the contact, or overlap outside, relative to the
    /// greatest displacement.
    ///
    /// # Errors
    /// [`RangeError`] unless it is in the range 1e-14 to 0.1.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        let holds = (1e-14..=0.1).contains(&tolerance);
        RangeError::check("tolerance", tolerance, holds, "from 1e-14 to 0.1")?;
        Ok(Self { tolerance, ..self })
    }

    /// Limits the iterations on each grid. The default is 1000, for a plate 40 000.
    #[must_use]
    pub const fn at_most(self, iterations: usize) -> Self {
        Self { iterations: Some(iterations), ..self }
    }

    fn target(self, operator: &dyn SurfaceOperator) -> Target {
        let own = if operator.is_invariant() { ITERATIONS } else { ITERATIONS_OF_PLATE };
        Target { tolerance: self.tolerance, iterations: self.iterations.unwrap_or(own) }
    }
}

/// The working memory of [`Frictionless`] on all grids.
#[derive(Clone)]
pub struct NormalScratch {
    grids: NormalGrids,
    workspace: Workspace,
}

impl Method for Frictionless {
    type Error = NormalError;
    type Scratch = NormalScratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<NormalScratch, NormalError> {
        if !problem.friction().is_none() {
            return Err(NormalError::Friction);
        }
        let operator = problem.operator();
        let heights = problem.gap().shared_heights();
        let grids = NormalGrids::new(operator, heights, || nested::coarser_operators(operator))?;
        Ok(NormalScratch { grids, workspace: operator.workspace() })
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut NormalScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, NormalError> {
        drive.check()?;
        from.check_grid(problem.grid())?;
        let loads = [("F_x", drive.x), ("F_y", drive.y), ("M_z", drive.twist)];
        for (name, driven) in loads {
            if let Driven::Load(load) = driven {
                RangeError::check(name, load, load == 0.0, "0 without friction")?;
            }
        }
        let convergence =
            parts::within((problem.operator().threads(), problem.grid().cells()), || {
                self.pressures(problem, drive.normal, scratch, observer, to)
            })?;
        let zeta = to.shift.zeta;
        to.shift = Shift { zeta, ..drive.shift_after(from.shift) };
        Ok(convergence)
    }
}

impl Frictionless {
    fn pressures(
        &self,
        problem: &ContactProblem,
        driven: Driven,
        scratch: &mut NormalScratch,
        observer: &mut dyn Observer,
        to: &mut ContactState,
    ) -> Result<Convergence, NormalError> {
        *to = ContactState::apart(problem.grid());
        if let Some(approach) = problem.apart(driven) {
            to.shift.zeta = approach;
            let (products, residuals) = Default::default();
            return Ok(Convergence { iterations: 0, products, residuals, stop: Stop::Converged });
        }
        problem.check_approach(driven)?;
        let (operator, grids) = (problem.operator(), &mut scratch.grids);
        let target = self.target(operator);
        let started = grids.start(operator, driven, target)?;
        let (approach, reached) = grids.solve(operator, driven, target, observer)?;
        let mut products = started.plus(reached.products);
        if reached.stop != Stop::Converged {
            let reached = Convergence { products, ..reached };
            return Err(NormalError::NotConverged { tolerance: target.tolerance, reached });
        }
        to.shift.zeta = approach;
        grids.give(to)?;
        if !operator.validity().contact_at_border
            && let Some(side) = GridWarning::border(to.extent(), to.pressure.grid()).next()
        {
            return Err(NormalError::HeldBorder { side });
        }
        if operator.is_coupled() {
            let displacements = DisplacementField::tangential(
                to.displacement_x.values_mut(),
                to.displacement_y.values_mut(),
            );
            operator.apply(
                TractionField::normal(to.pressure.values()),
                displacements,
                &mut scratch.workspace,
            )?;
            products.coupling += 1.0;
        }
        Ok(Convergence { products, ..reached })
    }
}
