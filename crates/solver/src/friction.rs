//! The friction of a surface: uniform or cell by cell.

use carom_halfspace::{Field, Grid};
use carom_laws::friction::Friction;
use carom_special::RangeError;

/// The coefficient used for infinite friction if pressures and tractions are coupled. With infinite
/// friction a cell at the edge may have no admissible state: if it sticks its own traction would
/// pull the surfaces apart, if it separates they would overlap. In the limit of an infinite
/// coefficient such a cell is dragged along: it keeps a finite traction at a pressure that vanishes
/// as traction over coefficient.
pub(crate) const COEFFICIENT_FOR_INFINITE: f64 = 1e9;

/// The coefficient, or [`COEFFICIENT_FOR_INFINITE`] for infinite friction.
pub(crate) const fn finite_coefficient(friction: f64) -> f64 {
    friction.min(COEFFICIENT_FOR_INFINITE)
}

/// Coulomb friction of a cell: it sticks up to `rest` times its pressure (static friction) and
/// slips at `motion` times its pressure (kinetic friction).
///
/// ```
/// use carom_laws::friction::Friction;
/// use carom_solver::CellFriction;
/// let (rest, motion) = (Friction::new(0.4)?, Friction::new(0.3)?);
/// assert_eq!(CellFriction::new(rest, motion)?.motion(), motion);
/// assert_eq!(CellFriction::new(motion, rest).unwrap_err().field, "static friction");
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CellFriction {
    rest: Friction,
    motion: Friction,
}

impl CellFriction {
    /// From a static and a kinetic coefficient.
    ///
    /// # Errors
    /// [`RangeError`] if the static coefficient is below the kinetic one: then no state would
    /// satisfy the law.
    pub fn new(rest: Friction, motion: Friction) -> Result<Self, RangeError> {
        let holds = rest >= motion;
        RangeError::check("static friction", rest.get(), holds, "at least the kinetic friction")?;
        Ok(Self { rest, motion })
    }

    /// The static coefficient: the cell sticks up to it.
    #[must_use]
    pub const fn rest(self) -> Friction {
        self.rest
    }

    /// The kinetic coefficient: the cell slips at it.
    #[must_use]
    pub const fn motion(self) -> Friction {
        self.motion
    }
}

impl From<Friction> for CellFriction {
    fn from(friction: Friction) -> Self {
        Self { rest: friction, motion: friction }
    }
}

/// The friction of all cells of a grid.
#[derive(Debug, Clone, PartialEq)]
pub enum SurfaceFriction {
    /// The same in every cell.
    Uniform(CellFriction),
    /// Cell by cell.
    ByCell(Field<CellFriction>),
}

impl SurfaceFriction {
    /// The friction of a cell; an index beyond the grid gives that of the last cell.
    #[must_use]
    pub fn at(&self, cell: usize) -> CellFriction {
        match self {
            Self::Uniform(friction) => *friction,
            Self::ByCell(field) => {
                let values = field.values();
                values[cell.min(values.len() - 1)]
            }
        }
    }

    /// Whether all cells are frictionless.
    #[must_use]
    pub fn is_none(&self) -> bool {
        let none = |friction: &CellFriction| friction.rest == Friction::NONE;
        match self {
            Self::Uniform(friction) => none(friction),
            Self::ByCell(field) => field.values().iter().all(none),
        }
    }

    /// Whether any cell has infinite kinetic friction.
    pub(crate) fn is_infinite_somewhere(&self) -> bool {
        let infinite = |friction: &CellFriction| friction.motion.get().is_infinite();
        match self {
            Self::Uniform(friction) => infinite(friction),
            Self::ByCell(field) => field.values().iter().any(infinite),
        }
    }

    /// Its grid; `None` if the friction is uniform.
    #[must_use]
    pub fn grid(&self) -> Option<Grid> {
        match self {
            Self::Uniform(_) => None,
            Self::ByCell(field) => Some(field.grid()),
        }
    }
}

impl From<Friction> for SurfaceFriction {
    fn from(friction: Friction) -> Self {
        Self::Uniform(friction.into())
    }
}

impl From<CellFriction> for SurfaceFriction {
    fn from(friction: CellFriction) -> Self {
        Self::Uniform(friction)
    }
}

impl From<Field<CellFriction>> for SurfaceFriction {
    fn from(field: Field<CellFriction>) -> Self {
        Self::ByCell(field)
    }
}
