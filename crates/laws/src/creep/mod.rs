//! Kalker's creep coefficients: the forces of a rolling contact at vanishing creepage, from a table.

pub mod force;
mod interpolation;
pub mod nodes;
mod stored;

use std::sync::LazyLock;

use carom_special::RangeError;
use carom_table::Column;

use interpolation::Interpolation;

/// Creep coefficients: forces for vanishing creepage of two equal bodies of shear modulus G each,
/// on a contact with semi-axes a along the direction of rolling and b across it.
///
/// With c = sqrt(ab), creepages xi, eta and phi (spin, per length) of body 2 against body 1, and
/// forces on body 1:
///
/// F_x = G c^2 C11 xi, F_y = G c^2 C22 eta - G c^3 C23 phi, M_z = G c^3 C32 eta + G c^4 C33 phi.
///
/// All are positive, and C32 = C23 by reciprocity. Kalker counts spin the other way round and
/// forces against creepage: his C11, C22, C23, C33 are these numbers, his C32 is -C23.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepCoefficients {
    /// Longitudinal force due to longitudinal creepage.
    pub c11: f64,
    /// Lateral force due to lateral creepage.
    pub c22: f64,
    /// Lateral force due to spin.
    pub c23: f64,
    /// Torque due to lateral creepage; equal to C23 in the continuum.
    pub c32: f64,
    /// Torque due to spin.
    pub c33: f64,
}

/// Made at the first use.
static TABLE: LazyLock<Interpolation> = LazyLock::new(|| Interpolation::new(&stored::VALUES));

impl CreepCoefficients {
    /// The columns of results.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("C11", "", "F_x = G a b C11 creepage", |c| c.c11.into()),
        Column::new("C22", "", "F_y = G a b C22 creepage_across", |c| c.c22.into()),
        Column::new("C23", "", "F_y = -G (ab)^1.5 C23 spin", |c| c.c23.into()),
        Column::new("C32", "", "M_z = G (ab)^1.5 C32 creepage_across, equal to C23", |c| {
            c.c32.into()
        }),
        Column::new("C33", "", "M_z = G (ab)^2 C33 spin", |c| c.c33.into()),
    ];

    /// The coefficients of a contact by the stored table, in less than a microsecond.
    ///
    /// `axis_ratio` is a/b, from 0.05 to 20; `poisson` that of both bodies, from 0 to 0.5. For
    /// dissimilar bodies take the combined values of `MaterialPair`: `poisson`, and twice
    /// `shear_modulus` for G; their coupling of pressure and shift is then left out.
    ///
    /// The entries are extrapolated from meshes, with an error of some 0.03 %, for a/b above 5 0.1 %
    /// (C33 0.1 %, above 3 0.3 %, above 10 up to 1 %); a circle at nu = 0 has its closed forms within
    /// 2e-5. Between entries the table differs from meshes by at most 2e-5 (C33 1e-4) for a/b below
    /// 1, and 3e-4 (C33 1e-3) above. Kalker's table in three digits is met within 1.5 %.
    ///
    /// Rolling has a direction: an exchange of a and b is another problem, and no coefficient at
    /// b/a follows from those at a/b. At nu = 0 a traction displaces surfaces along itself only, so
    /// that C11 = C22. For a/b -> 0 strips roll like cylinders, C11 = pi^2/(4 (1 - nu)), C22 =
    /// pi^2/4, C33 = pi^2/(16 (1 - nu)) b/a; for a/b -> infinity C11 and C22 grow as a/b over its
    /// logarithm.
    ///
    /// ```
    /// use carom_laws::creep::CreepCoefficients;
    /// let circle = CreepCoefficients::by_table(1.0, 0.0)?;
    /// assert!((circle.c11 / (32.0 / (3.0 * std::f64::consts::PI)) - 1.0).abs() < 1e-4);
    /// assert!((circle.c23 / (4.0 / 3.0) - 1.0).abs() < 1e-4);
    /// // The linear force of a wheel at a creepage of 0.01 %.
    /// let (g, a, b) = (80e9, 6.8e-3, 5.1e-3);
    /// let force = g * a * b * CreepCoefficients::by_table(a / b, 0.25)?.c11 * 1e-4;
    /// assert!((force - 1.24e3).abs() < 10.0);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] for `axis_ratio` or `poisson` out of these ranges.
    pub fn by_table(axis_ratio: f64, poisson: f64) -> Result<Self, RangeError> {
        let fits = (nodes::AXIS_RATIOS[0]..=nodes::AXIS_RATIOS[1]).contains(&axis_ratio);
        RangeError::check("axis_ratio", axis_ratio, fits, "from 0.05 to 20")?;
        let fits = (nodes::POISSONS[0]..=nodes::POISSONS[1]).contains(&poisson);
        RangeError::check("poisson", poisson, fits, "from 0 to 0.5")?;
        let [c11, c22, c23, c33] = TABLE.at(axis_ratio, poisson);
        Ok(Self { c11, c22, c23, c32: c23, c33 })
    }
}
