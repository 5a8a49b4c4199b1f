//! Steady rolling as a method of the solver.

use carom_halfspace::Grid;
use carom_laws::law::Shift;
use carom_solver::{ContactProblem, ContactState, Convergence, Drive, MeshOrder, Method, Observer};
use carom_special::RangeError;

use super::{RollingDrive, RollingError, RollingFriction, SteadyContact, Way};

/// Steady rolling as a [`Method`], so that errors of the mesh are estimated on nested grids
/// ([`carom_solver::NestedHistory`]) and a grid is chosen for an accuracy
/// ([`carom_solver::Accuracy`]).
///
/// In its drives and states xi, eta and omega are creepages: motion per distance rolled. A state
/// does not depend on the one before it, which is only where the solution starts.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::friction::Friction;
/// use carom_rolling::{RollingDrive, SteadyMethod};
/// use carom_solver::{ContactProblem, Driven, Gap, NestedHistory};
/// let body = Material::from_shear(1.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let friction = Friction::new(0.3)?;
/// let make = |grid| {
///     let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
///     ContactProblem::of_half_spaces(gap, pair, friction)
/// };
/// let grid = Grid::new(32, 32, 0.1, 0.1)?;
/// let mut history = NestedHistory::new(SteadyMethod::default(), grid, make)?;
/// let braked = RollingDrive {
///     normal: Driven::Load(2.0),
///     along: Driven::Load(-0.3),
///     across: Driven::Shift(0.0),
///     spin: Driven::Shift(0.0),
/// };
/// history.step(&braked.into(), &mut ())?;
/// let creepage = history.estimates().unwrap().xi;
/// assert!(creepage.value < 0.0 && creepage.error < 0.2 * creepage.value.abs());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SteadyMethod {
    direction: f64,
    spin_at: f64,
    /// None for the width of a cell.
    step: Option<f64>,
    /// None for the solver's own.
    tolerance: Option<f64>,
    /// None for the friction of the problem.
    friction: Option<RollingFriction>,
}

impl SteadyMethod {
    /// The same in the direction chi, an angle from +x towards +y.
    ///
    /// # Errors
    /// [`RangeError`] unless the angle is finite.
    pub fn towards(self, direction: f64) -> Result<Self, RangeError> {
        RangeError::finite("rolling direction", direction)?;
        Ok(Self { direction, ..self })
    }

    /// The same with the rigid shift of a spin taken at x + q d, as [`Way::with_spin_at`].
    ///
    /// # Errors
    /// [`RangeError`] unless the part q is from -1 to 1.
    pub fn with_spin_at(self, part: f64) -> Result<Self, RangeError> {
        let spin_at = Way::new(1.0)?.with_spin_at(part)?.spin_at();
        Ok(Self { spin_at, ..self })
    }

    /// The same in steps of this length on every grid, instead of the width of its cells in the
    /// direction of rolling.
    ///
    /// # Errors
    /// [`RangeError`] unless the length is positive and finite.
    pub fn in_steps_of(self, length: f64) -> Result<Self, RangeError> {
        Ok(Self { step: Some(Way::new(length)?.length()), ..self })
    }

    /// The same with this tolerance of each solution, as [`SteadyContact::within`].
    ///
    /// # Errors
    /// [`RangeError`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        carom_solver::Frictional::default().within(tolerance)?;
        Ok(Self { tolerance: Some(tolerance), ..self })
    }

    /// The same with friction by the slip speed, as [`SteadyContact::with_friction_by_slip`].
    #[must_use]
    pub fn with_friction_by_slip(self, friction: RollingFriction) -> Self {
        Self { friction: Some(friction), ..self }
    }

    /// Friction by the slip speed; none for that of the problem.
    #[must_use]
    pub const fn friction(&self) -> Option<RollingFriction> {
        self.friction
    }

    /// The direction chi of rolling.
    #[must_use]
    pub const fn direction(&self) -> f64 {
        self.direction
    }

    /// The tolerance of each solution; none for the solver's own.
    #[must_use]
    pub const fn tolerance(&self) -> Option<f64> {
        self.tolerance
    }

    /// The way of a step on a grid: the given length, or sqrt((dx cos chi)^2 + (dy sin chi)^2).
    ///
    /// # Errors
    /// [`RangeError`] if the length is too small for a number.
    pub fn way(&self, grid: Grid) -> Result<Way, RangeError> {
        let (sin, cos) = libm::sincos(self.direction);
        let length = self.step.unwrap_or_else(|| libm::hypot(grid.dx() * cos, grid.dy() * sin));
        Way::new(length)?.towards(self.direction)?.with_spin_at(self.spin_at)
    }
}

impl From<RollingDrive> for Drive {
    /// The drive of a [`SteadyMethod`].
    fn from(drive: RollingDrive) -> Self {
        let RollingDrive { normal, along, across, spin } = drive;
        Self { normal, x: along, y: across, twist: spin }
    }
}

impl Method for SteadyMethod {
    type Error = RollingError;
    type Scratch = SteadyContact;

    fn mesh_order(&self) -> MeshOrder {
        MeshOrder::First
    }

    fn scratch(&self, problem: &ContactProblem) -> Result<SteadyContact, RollingError> {
        let contact = SteadyContact::new(problem, self.way(problem.grid())?)?;
        let contact = match self.friction {
            Some(friction) => contact.with_friction_by_slip(friction),
            None => contact,
        };
        match self.tolerance {
            Some(tolerance) => contact.within(tolerance),
            None => Ok(contact),
        }
    }

    fn step(
        &self,
        _: &ContactProblem,
        _: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut SteadyContact,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, RollingError> {
        let Drive { normal, x, y, twist } = *drive;
        let drive = RollingDrive { normal, along: x, across: y, spin: twist };
        let rolled = scratch.roll(&drive, observer)?;
        to.clone_from(&rolled.state);
        let creepage = rolled.creepage;
        to.shift = Shift {
            zeta: rolled.state.shift.zeta,
            xi: creepage.along,
            eta: creepage.across,
            omega: creepage.spin,
        };
        Ok(rolled.convergence)
    }
}
