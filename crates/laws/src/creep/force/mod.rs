//! Creep forces of an elliptical contact of like bodies at any creepage and spin, from a table.

pub mod nodes;
mod table;

use super::CreepCoefficients;
use carom_special::RangeError;
use carom_table::Column;

/// An elliptical contact of two bodies of like materials that roll along x.
///
/// ```
/// use carom_laws::creep::force::CreepContact;
/// // A wheel on a rail, 80 kN.
/// let contact = CreepContact::new([6.8e-3, 5.1e-3], 82e9, 0.28)?;
/// let found = contact.force(0.3, 80e3, [1e-3, 0.0, 0.0])?;
/// // Less than the linear force, and than the friction limit.
/// let linear = contact.coefficients().c11 * 82e9 * 6.8e-3 * 5.1e-3 * 1e-3;
/// assert!(found.f_x > 0.5 * linear && found.f_x < linear && found.f_x < 0.3 * 80e3);
/// assert!(found.f_y.abs() <= found.error && found.error < 0.05 * 0.3 * 80e3);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepContact {
    semi_axes: [f64; 2],
    shear_modulus: f64,
    poisson: f64,
    coefficients: CreepCoefficients,
}

/// Forces on body 1 of steady rolling, which creeps against body 2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepForce {
    /// Force along the direction of rolling.
    pub f_x: f64,
    /// Force across it.
    pub f_y: f64,
    /// Torque about the normal.
    pub m_z: f64,
    /// How far each force may be off the continuum, the torque over sqrt(ab): by the table and the clip.
    pub error: f64,
}

impl CreepForce {
    /// The columns of results.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("F_x", "N", "force on body 1 along the direction of rolling", |f| f.f_x.into()),
        Column::new("F_y", "N", "the same across it", |f| f.f_y.into()),
        Column::new("M_z", "N m", "torque on body 1", |f| f.m_z.into()),
        Column::new(
            "error",
            "N",
            "how far each force may be off; M_z by sqrt(ab) times as much",
            |f| f.error.into(),
        ),
    ];
}

impl CreepContact {
    /// A contact with the semi-axes a along the direction of rolling and b across it, and the elastic constants of both
    /// bodies.
    ///
    /// # Errors
    /// [`RangeError`] unless a/b is from 0.1 to 10, the shear modulus positive and Poisson's ratio from 0 to 0.5. Other
    /// contacts, and dissimilar bodies, are for the solver.
    pub fn new(semi_axes: [f64; 2], shear_modulus: f64, poisson: f64) -> Result<Self, RangeError> {
        let [a, b] = semi_axes;
        RangeError::positive("semi_axis_a", a)?;
        RangeError::positive("semi_axis_b", b)?;
        let ratio = a / b;
        let holds = (0.1..=10.0).contains(&ratio);
        RangeError::check(
            "axis_ratio",
            ratio,
            holds,
            "a/b from 0.1 to 10; the solver takes others",
        )?;
        RangeError::positive("shear_modulus", shear_modulus)?;
        let holds = (0.0..=0.5).contains(&poisson);
        RangeError::check("poisson", poisson, holds, "from 0 to 0.5; the solver takes others")?;
        let coefficients = CreepCoefficients::by_table(ratio, poisson)?;
        Ok(Self { semi_axes, shear_modulus, poisson, coefficients })
    }

    /// Kalker's coefficients of the contact.
    #[must_use]
    pub const fn coefficients(&self) -> CreepCoefficients {
        self.coefficients
    }

    /// Forces at a creepage along x, across, and spin (1/m) of body 2 against body 1, under friction and a normal force.
    ///
    /// The table holds the forces over f F_z (M_z over f F_z sqrt(ab)) over the scaled creepages
    /// of [`nodes::scales`], of fresh solutions on three grids, extrapolated to the continuum. It ends at Kalker's coefficients for small creepages and in rigid sliding for
    /// large ones. Forces are clipped to the friction limit and to work that heats; the clip counts in the error.
    ///
    /// # Errors
    /// [`RangeError`] unless friction and force are positive and finite, and the creepages finite.
    pub fn force(
        &self,
        friction: f64,
        force: f64,
        creepage: [f64; 3],
    ) -> Result<CreepForce, RangeError> {
        let limit = Self::limit(friction, force, creepage)?;
        let scaled = self.scaled(limit, creepage);
        let size = libm::sqrt(self.semi_axes[0] * self.semi_axes[1]);
        let [along, across, spin] = creepage;
        let greatest =
            along.abs().max(across.abs()).max((size * spin).abs()).max(f64::MIN_POSITIVE);
        let rates = [along, across, size * spin].map(|rate| rate / greatest);
        let own = table::at(self.semi_axes[0] / self.semi_axes[1], self.poisson, scaled, rates);
        let [f_x, f_y, m_z] = own.forces;
        Ok(CreepForce {
            f_x: limit * f_x,
            f_y: limit * f_y,
            m_z: limit * size * m_z,
            error: limit * own.error,
        })
    }

    /// The derivatives of F_x, F_y and M_z (rows) by creepage, creepage_across and spin (columns), by central differences of the
    /// table.
    ///
    /// # Errors
    /// As [`CreepContact::force`].
    pub fn derivatives(
        &self,
        friction: f64,
        force: f64,
        creepage: [f64; 3],
    ) -> Result<[[f64; 3]; 3], RangeError> {
        let limit = Self::limit(friction, force, creepage)?;
        // A ten-thousandth of the size at which the contact begins to slide.
        let unit = self.scaled(limit, [1.0; 3]).map(|scale| STEP / scale);
        let mut rows = [[0.0; 3]; 3];
        for column in 0..3 {
            let at = |by: f64| {
                let mut moved = creepage;
                moved[column] += by * unit[column];
                self.force(friction, force, moved)
            };
            let (less, more) = (at(-1.0)?, at(1.0)?);
            let parts = [more.f_x - less.f_x, more.f_y - less.f_y, more.m_z - less.m_z];
            (0..3).for_each(|row| rows[row][column] = parts[row] / (2.0 * unit[column]));
        }
        Ok(rows)
    }

    fn limit(friction: f64, force: f64, creepage: [f64; 3]) -> Result<f64, RangeError> {
        let friction = RangeError::positive("friction", friction)?;
        let force = RangeError::positive("force", force)?;
        let [along, across, spin] = creepage;
        RangeError::finite("creepage", along)?;
        RangeError::finite("creepage_across", across)?;
        RangeError::finite("spin", spin)?;
        Ok(friction * force)
    }

    /// x, y and phi.
    fn scaled(&self, limit: f64, creepage: [f64; 3]) -> [f64; 3] {
        let area = self.semi_axes[0] * self.semi_axes[1];
        let stiffness = self.shear_modulus * area / limit;
        let ratio = self.semi_axes[0] / self.semi_axes[1];
        let [k_x, k_y, k_phi] = nodes::scales(&self.coefficients, ratio);
        let [along, across, spin] = creepage;
        [
            k_x * stiffness * along,
            k_y * stiffness * across,
            k_phi * stiffness * libm::sqrt(area) * spin,
        ]
    }
}

/// Step of the derivatives in scaled creepage.
const STEP: f64 = 1e-4;
