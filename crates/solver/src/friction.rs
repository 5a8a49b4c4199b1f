//! The friction between two surfaces, the same everywhere or cell by cell.

use carom_halfspace::{Field, Grid};
use carom_laws::friction::Friction;
use carom_special::RangeError;

/// The coefficient that stands for infinite friction where pressures and tractions are coupled. At the
/// edge a cell may be neither stuck, for its own traction would pull the surfaces apart, nor separated, for
/// without it they would overlap. In the limit of infinite friction such a cell is dragged along: it keeps
/// a traction at a pressure that vanishes as the traction over the coefficient.
pub(crate) const FIRM: f64 = 1e9;

/// A coefficient, of infinite friction a finite one.
pub(crate) const fn firm(friction: f64) -> f64 {
    friction.min(FIRM)
}

/// Coulomb's friction in a cell: it sticks up to `rest` times its pressure and slips at `motion`
/// times it.
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
    /// A coefficient at rest and one in motion.
    ///
    /// # Errors
    /// [`RangeError`] if that at rest is the smaller one: no state would satisfy the law.
    pub fn new(rest: Friction, motion: Friction) -> Result<Self, RangeError> {
        let holds = rest >= motion;
        RangeError::check("static friction", rest.get(), holds, "at least the kinetic friction")?;
        Ok(Self { rest, motion })
    }

    /// The coefficient up to which a cell sticks.
    #[must_use]
    pub const fn rest(self) -> Friction {
        self.rest
    }

    /// The coefficient at which it slips.
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
    /// The friction of the cell of this index; that of the last one beyond the grid.
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

    /// Whether no cell has any.
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

    /// Its grid, if it has one.
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
