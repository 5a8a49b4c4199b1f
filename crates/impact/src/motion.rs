//! The motion of a body.

use carom_special::RangeError;
use carom_table::Column;
use nalgebra::Vector3;

/// Largest component of a velocity or spin; beyond it energies overflow.
const MAX_COMPONENT: f64 = 1e100;

/// Velocity of the centre of mass and spin, in space axes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Motion {
    /// Velocity of the centre of mass.
    pub velocity: Vector3<f64>,
    /// Angular velocity, radians per time.
    pub spin: Vector3<f64>,
}

impl Motion {
    /// Columns of velocity and spin.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::vector("velocity", "m/s", "of the centre of mass", |motion| {
            <[f64; 3]>::from(motion.velocity).into()
        }),
        Column::vector("spin", "rad/s", "angular velocity", |motion| {
            <[f64; 3]>::from(motion.spin).into()
        }),
    ];

    /// A motion with this velocity of the centre of mass and this spin (radians per time).
    ///
    /// # Errors
    /// [`RangeError`] that names the first component outside +-1e100.
    pub fn new(velocity: [f64; 3], spin: [f64; 3]) -> Result<Self, RangeError> {
        let check = |field, value: f64| {
            RangeError::check(field, value, value.abs() <= MAX_COMPONENT, "within +-1e100")
        };
        for value in velocity {
            check("velocity", value)?;
        }
        for value in spin {
            check("spin", value)?;
        }
        Ok(Self { velocity: velocity.into(), spin: spin.into() })
    }
}
