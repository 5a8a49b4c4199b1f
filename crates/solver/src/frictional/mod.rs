//! Contact with Coulomb friction: normal and tangential problems solved in turn.

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

/// Contact with Coulomb friction, one step of a load history at a time. Pressures are solved at the
/// last tractions, tractions at these pressures, and so on until both converge (Panagiotopoulos);
/// one pass suffices if the materials are not coupled. Pressures are found by preconditioned
/// conjugate gradients on an active set, tractions by Newton's method on the sets of sticking and
/// slipping cells. Both start from coarser grids if no better start is known.
///
/// Each of the four motions is prescribed as a shift or as a load. A load that friction cannot hold
/// is an error ([`FrictionalError::Slides`], [`FrictionalError::Turns`]). For dissimilar materials,
/// loads just below that limit are found by iterating on the shifts: all cells slip there, and the
/// shift grows with the inverse square root of the distance to the limit.
///
/// The cost of a step depends on the size of the contact, not of the window: on large grids it is
/// solved on a box around the contact. The box is chosen anew in each step by a solve on coarse
/// cells. If the bodies would overlap outside the box, the step is solved on the whole window.
///
/// Where static friction exceeds kinetic friction, a cell sticks up to `f_s p`. Once it slips its
/// bound is `f_k p`, at once within the step and in later steps for as long as it slips. After a
/// step without slip it is static again. Cells change to kinetic friction until none exceeds its
/// static bound, because each change loads its neighbours. This law has no length scale: the
/// traction at the tip of the slip area is unbounded, and static friction matters less on each
/// finer grid. In Cattaneo's problem with `f_s = 1.5 f_k` the tangential force exceeds that of
/// kinetic friction alone by 0.21, 0.13, 0.056, 0.028 % of the normal force on 16, 32, 64, 128
/// cells along a side: in proportion to the cell width. Results that depend on the difference
/// therefore depend on the grid.
///
/// Infinite friction is exact if the materials are not coupled. If they are, it is the limit of
/// Coulomb's law, computed with the coefficient 1e9. No cell is then in the state
/// [`CellState::Slip`](crate::CellState::Slip). Cells at the edge that would need tension to stick
/// are dragged along: the surfaces touch there at a pressure of 1e-9 of the traction, which opposes
/// their displacement. [`ContactState::slip_since`] gives this displacement, and
/// [`crate::dissipated`] its work.
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
    /// No load on a periodic surface gives the prescribed shift.
    #[error(transparent)]
    Period(#[from] PeriodError),
    /// The prescribed tangential force exceeds what friction can hold: the bodies slide.
    #[error(
        "the tangential force {force} is not below the friction limit {limit}: the bodies slide"
    )]
    Slides {
        /// The tangential force.
        force: f64,
        /// The greatest force that friction can hold, the sum of f p over the cells; relative error
        /// 1e-12.
        limit: f64,
    },
    /// The prescribed torque, alone or with a force, exceeds what friction can hold: the bodies
    /// rotate on each other.
    #[error(
        "friction can hold less than {part} times the torque {torque} and the tangential force {force}: \
         the bodies slide"
    )]
    Turns {
        /// The torque.
        torque: f64,
        /// The tangential force.
        force: f64,
        /// The fraction of the prescribed loads that friction can hold; at most 1.
        part: f64,
    },
    /// The iterations ended before the tolerance was reached.
    #[error(
        "the {what} did not converge to {tolerance:.1e}: {:.1e} (normal), {:.1e} (tangential) after \
         {} iterations ({:?})",
        .reached.residuals.normal, .reached.residuals.tangential, .reached.iterations, .reached.stop
    )]
    NotConverged {
        /// The unknowns that did not converge: pressures, tractions, or both together.
        what: &'static str,
        /// The tolerance.
        tolerance: f64,
        /// The convergence up to then.
        reached: Convergence,
    },
}

impl Default for Frictional {
    /// Tolerance 1e-9, relative to the greatest displacement and to the greatest friction limit.
    fn default() -> Self {
        Self { tolerance: 1e-9, iterations: 1000, passes: 300 }
    }
}

impl Frictional {
    /// Sets the tolerance: violations of the normal conditions relative to the greatest
    /// displacement, and of the friction law relative to the greatest friction limit.
    ///
    /// # Errors
    /// [`RangeError`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        let holds = (1e-13..=0.01).contains(&tolerance);
        RangeError::check("tolerance", tolerance, holds, "from 1e-13 to 0.01")?;
        Ok(Self { tolerance, ..self })
    }

    /// Limits the iterations of each problem on each grid, and the passes of the alternation.
    ///
    /// # Errors
    /// [`RangeError`] unless both are at least 1.
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
    /// Tangential displacement due to pressure; this and the next two fields are empty without
    /// coupling.
    by_pressure: [Vec<f64>; 2],
    offset: [Vec<f64>; 2],
    /// Normal displacement due to tangential tractions, in this pass and in the last one.
    by_traction: Vec<f64>,
    last: Vec<f64>,
    mixing: Mixing,
    /// Cells at kinetic friction: they have slipped since they last stuck.
    kinetic: Vec<bool>,
    /// The solver for pressures and tractions together, built when first needed.
    coupled: Option<Box<Coupled>>,
    /// The loads that friction can hold under the pressures of this pass.
    surface: LimitSurface,
    /// The last box that was used, and the normal displacements of all cells.
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
            kinetic: vec![false; problem.grid().cells()],
            coupled: None,
            surface: LimitSurface::default(),
            boxed: None,
            sunk: Vec::new(),
        })
    }

    /// A step with contact, solved on all cells.
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
        let (cost, rigid) = (Products::default(), Rigid { loads, ..Rigid::default() });
        let (together, slides) = (false, None);
        let mut pass =
            Pass { method: self, problem, from, drive, rigid, observer, cost, together, slides };
        pass.solve_with_static_friction(to, scratch)
    }
}

/// Separated bodies cannot hold a tangential load.
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
