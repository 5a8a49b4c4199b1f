//! Creep forces of an elliptical contact of like bodies at any creepage and spin, from a table.

pub mod nodes;
mod table;

use super::CreepCoefficients;
use crate::bounds::{constant, in_contact};
use carom_special::RangeError;
use carom_table::Column;
use table::{Mixed, Prepared, Stored};

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
    shape: Shape,
    /// sqrt(ab).
    size: f64,
}

/// Contacts of one axis ratio and one material, for many forces: a force takes a quarter of the time of [`CreepContact`]'s, to
/// the same bits, and the table of the shape some five hundred times as long once.
///
/// ```
/// use carom_laws::creep::force::{CreepContact, CreepShape};
/// let shape = CreepShape::new(4.0 / 3.0, 82e9, 0.28)?;
/// let one = CreepContact::new([6.8e-3, 5.1e-3], 82e9, 0.28)?.force(0.3, 80e3, [1e-3, 2e-3, 0.1])?;
/// let size = (6.8e-3_f64 * 5.1e-3).sqrt();
/// assert_eq!(shape.force(size, 0.3, 80e3, [1e-3, 2e-3, 0.1])?, one);
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct CreepShape {
    shape: Shape,
    table: Prepared,
}

/// What a contact of any size has.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Shape {
    /// a/b.
    ratio: f64,
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
    /// How far each force may be off the continuum, the torque over sqrt(ab): by the table and the clip. It is
    /// an estimate: of 92 drawn contacts whose creepage was mostly spin two were off by more, one by twice as much.
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
    /// [`RangeError`] unless a/b is from 0.1 to 10, Poisson's ratio from 0 to 0.5, and lengths and shear modulus from 1e-60
    /// to 1e60. Other contacts, and dissimilar bodies, are for the solver.
    pub fn new(semi_axes: [f64; 2], shear_modulus: f64, poisson: f64) -> Result<Self, RangeError> {
        let [a, b] = semi_axes;
        constant("semi_axis_a", a)?;
        constant("semi_axis_b", b)?;
        Self::of_size(libm::sqrt(a * b), a / b, shear_modulus, poisson)
    }

    /// A contact of a size sqrt(ab) and an axis ratio a/b.
    ///
    /// # Errors
    /// As [`CreepContact::new`].
    pub fn of_size(
        size: f64,
        axis_ratio: f64,
        shear_modulus: f64,
        poisson: f64,
    ) -> Result<Self, RangeError> {
        let size = constant("size", size)?;
        Ok(Self { shape: Shape::new(axis_ratio, shear_modulus, poisson)?, size })
    }

    /// Kalker's coefficients of the contact.
    #[must_use]
    pub const fn coefficients(&self) -> CreepCoefficients {
        self.shape.coefficients
    }

    /// Forces at a creepage along x, across, and spin (1/m) of body 2 against body 1, under friction and a normal force.
    ///
    /// The table holds the forces over f F_z (M_z over f F_z sqrt(ab)) over the scaled creepages
    /// of [`nodes::scales`], of fresh solutions on three grids, extrapolated to the continuum. It ends at Kalker's coefficients for small creepages and in rigid sliding for
    /// large ones. Forces are clipped to the friction limit and to work that heats; the clip counts in the error.
    ///
    /// # Errors
    /// [`RangeError`] unless friction and force are from 1e-60 to 1e60, and creepages at most 1e60 in magnitude.
    pub fn force(
        &self,
        friction: f64,
        force: f64,
        creepage: [f64; 3],
    ) -> Result<CreepForce, RangeError> {
        self.shape.force(&self.shape.stored(), self.size, limit(friction, force)?, creepage)
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
        let limit = limit(friction, force)?;
        // A ten-thousandth of the size at which the contact begins to slide.
        let unit = self.shape.scaled(self.size, limit, [1.0; 3]).map(|scale| STEP / scale);
        let stored = self.shape.stored();
        let mut rows = [[0.0; 3]; 3];
        for column in 0..3 {
            let at = |by: f64| {
                let mut moved = creepage;
                moved[column] += by * unit[column];
                self.shape.force(&stored, self.size, limit, moved)
            };
            let (less, more) = (at(-1.0)?, at(1.0)?);
            let parts = [more.f_x - less.f_x, more.f_y - less.f_y, more.m_z - less.m_z];
            (0..3).for_each(|row| rows[row][column] = parts[row] / (2.0 * unit[column]));
        }
        Ok(rows)
    }
}

impl CreepShape {
    /// Contacts of an axis ratio a/b, with a along the direction of rolling, and the elastic constants of both bodies.
    ///
    /// # Errors
    /// As [`CreepContact::new`].
    pub fn new(axis_ratio: f64, shear_modulus: f64, poisson: f64) -> Result<Self, RangeError> {
        let shape = Shape::new(axis_ratio, shear_modulus, poisson)?;
        Ok(Self { shape, table: Prepared::new(&shape.stored()) })
    }

    /// As [`CreepContact::force`], of the contact of a size sqrt(ab).
    ///
    /// # Errors
    /// [`RangeError`] unless size, friction and force are from 1e-60 to 1e60, and creepages at most 1e60 in magnitude.
    pub fn force(
        &self,
        size: f64,
        friction: f64,
        force: f64,
        creepage: [f64; 3],
    ) -> Result<CreepForce, RangeError> {
        let size = constant("size", size)?;
        self.shape.force(&self.table, size, limit(friction, force)?, creepage)
    }
}

/// The friction limit f F_z.
fn limit(friction: f64, force: f64) -> Result<f64, RangeError> {
    Ok(constant("friction", friction)? * constant("force", force)?)
}

impl Shape {
    fn new(ratio: f64, shear_modulus: f64, poisson: f64) -> Result<Self, RangeError> {
        let holds = (0.1..=10.0).contains(&ratio);
        RangeError::check(
            "axis_ratio",
            ratio,
            holds,
            "a/b from 0.1 to 10; the solver takes others",
        )?;
        constant("shear_modulus", shear_modulus)?;
        let holds = (0.0..=0.5).contains(&poisson);
        RangeError::check("poisson", poisson, holds, "from 0 to 0.5; the solver takes others")?;
        let coefficients = CreepCoefficients::by_table(ratio, poisson)?;
        Ok(Self { ratio, shear_modulus, poisson, coefficients })
    }

    fn stored(&self) -> Stored {
        Stored::new(self.ratio, self.poisson)
    }

    fn force(
        &self,
        table: &impl Mixed,
        size: f64,
        limit: f64,
        creepage: [f64; 3],
    ) -> Result<CreepForce, RangeError> {
        let [along, across, spin] = creepage;
        in_contact("creepage", along)?;
        in_contact("creepage_across", across)?;
        in_contact("spin", spin)?;
        let scaled = self.scaled(size, limit, creepage);
        let greatest =
            along.abs().max(across.abs()).max((size * spin).abs()).max(f64::MIN_POSITIVE);
        let rates = [along, across, size * spin].map(|rate| rate / greatest);
        let own = table::at(table, self.ratio, scaled, rates);
        let [f_x, f_y, m_z] = own.forces;
        Ok(CreepForce {
            f_x: limit * f_x,
            f_y: limit * f_y,
            m_z: limit * size * m_z,
            error: limit * own.error,
        })
    }

    /// x, y and phi.
    fn scaled(&self, size: f64, limit: f64, creepage: [f64; 3]) -> [f64; 3] {
        let stiffness = self.shear_modulus * size * size / limit;
        let [k_x, k_y, k_phi] = nodes::scales(&self.coefficients, self.ratio);
        let [along, across, spin] = creepage;
        [k_x * stiffness * along, k_y * stiffness * across, k_phi * stiffness * (size * spin)]
    }
}

/// Step of the derivatives in scaled creepage.
const STEP: f64 = 1e-4;
