//! A step of rolling as a method of the solver.

use carom_laws::law::Shift;
use carom_solver::{ContactProblem, ContactState, Convergence, Drive, MeshOrder, Method, Observer};

use super::{RollingContact, RollingDrive, RollingError, SteadyMethod};

/// A step of rolling as a [`Method`], so that errors of the mesh are estimated on nested grids.
///
/// In its drives and states xi, eta and omega are creepages, motion per distance rolled, as in those of a
/// [`SteadyMethod`].
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::friction::Friction;
/// use carom_rolling::{RollingDrive, SteadyMethod, TransientMethod};
/// use carom_solver::{ContactProblem, Driven, Gap, NestedHistory};
/// let body = Material::from_shear(1.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let make = |grid| {
///     let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
///     ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3).unwrap())
/// };
/// let grid = Grid::new(32, 32, 0.1, 0.1)?;
/// let method = TransientMethod::new(SteadyMethod::default().in_steps_of(0.1)?);
/// let mut history = NestedHistory::new(method, grid, make)?;
/// let braked = RollingDrive {
///     normal: Driven::Load(2.0),
///     along: Driven::Load(-0.3),
///     across: Driven::Shift(0.0),
///     spin: Driven::Shift(0.0),
/// };
/// history.step(&braked.into(), &mut ())?;
/// let first = history.state().shift.xi;
/// history.step(&braked.into(), &mut ())?;
/// assert!(first < history.state().shift.xi && history.state().shift.xi < 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TransientMethod {
    rolling: SteadyMethod,
}

impl TransientMethod {
    /// Steps in this direction, of this length and to this tolerance.
    #[must_use]
    pub const fn new(rolling: SteadyMethod) -> Self {
        Self { rolling }
    }
}

impl Method for TransientMethod {
    type Error = RollingError;
    type Scratch = RollingContact;

    fn mesh_order(&self) -> MeshOrder {
        MeshOrder::First
    }

    fn scratch(&self, problem: &ContactProblem) -> Result<RollingContact, RollingError> {
        let contact = RollingContact::new(problem, self.rolling.way(problem.grid())?)?;
        match self.rolling.tolerance() {
            Some(tolerance) => contact.within(tolerance),
            None => Ok(contact),
        }
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut RollingContact,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, RollingError> {
        let Drive { normal, x, y, twist } = *drive;
        let drive = RollingDrive { normal, along: x, across: y, spin: twist };
        // Shifts begin at 0 in each step.
        let mut before = from.clone();
        before.shift = Shift { zeta: from.shift.zeta, ..Shift::default() };
        let convergence = scratch.step(&drive, &before, to, observer)?;
        let creepage = self.rolling.way(problem.grid())?.creepage(to.shift);
        to.shift = Shift {
            zeta: to.shift.zeta,
            xi: creepage.along,
            eta: creepage.across,
            omega: creepage.spin,
        };
        Ok(convergence)
    }
}
