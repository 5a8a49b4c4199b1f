//! Sides and thickness of a plate, and what it is made of.

use carom_special::RangeError;

use crate::{Grid, MaterialPair};

/// The least thickness, as a part of the longer side.
const THINNEST: f64 = 1e-6;
/// Sides of grid and plate agree within this part of the side.
const ROUNDING: f64 = 1e-12;

/// A rectangular plate of constant thickness.
///
/// ```
/// use carom_halfspace::operator::Plate;
/// let pane = Plate::new(0.4, 0.3, 0.004)?;
/// assert_eq!(pane.thickness(), 0.004);
/// let error = Plate::new(0.4, 0.3, 1e-8).unwrap_err();
/// assert_eq!(error.field, "thickness");
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    a: f64,
    b: f64,
    thickness: f64,
}

impl Plate {
    /// A plate of side `a` along x and `b` along y, in any unit of length.
    ///
    /// # Errors
    /// [`RangeError`] unless all three are finite and positive, and the thickness is at least 1e-6
    /// of the longer side.
    pub fn new(a: f64, b: f64, thickness: f64) -> Result<Self, RangeError> {
        RangeError::positive("a", a)?;
        RangeError::positive("b", b)?;
        RangeError::positive("thickness", thickness)?;
        let allowed = "at least 1e-6 of the longer side";
        RangeError::check("thickness", thickness, thickness >= THINNEST * a.max(b), allowed)?;
        Ok(Self { a, b, thickness })
    }

    /// The side along x.
    #[must_use]
    pub const fn a(&self) -> f64 {
        self.a
    }

    /// The side along y.
    #[must_use]
    pub const fn b(&self) -> f64 {
        self.b
    }

    /// The thickness h.
    #[must_use]
    pub const fn thickness(&self) -> f64 {
        self.thickness
    }

    /// A grid whose cells cover the plate.
    ///
    /// # Errors
    /// [`RangeError`] as for [`Grid::new`].
    pub fn grid(&self, nx: usize, ny: usize) -> Result<Grid, RangeError> {
        let grid = Grid::new(nx, ny, self.a / nx as f64, self.b / ny as f64)?;
        self.check_cover(grid)?;
        Ok(grid)
    }

    /// Checks that the cells cover the plate, no more and no less.
    pub(super) fn check_cover(&self, grid: Grid) -> Result<(), RangeError> {
        let sides = [
            ("nx dx", grid.nx() as f64 * grid.dx(), self.a, "the side a of the plate"),
            ("ny dy", grid.ny() as f64 * grid.dy(), self.b, "the side b of the plate"),
        ];
        for (field, covered, side, allowed) in sides {
            let holds = (covered - side).abs() <= ROUNDING * side;
            RangeError::check(field, covered, holds, allowed)?;
        }
        Ok(())
    }
}

/// The elastic constants that the compliance of a plate needs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Constants {
    pub(super) thickness: f64,
    /// 2/E*, with E* = E/(1 - nu^2).
    pub(super) surface: f64,
    /// The same of the punch; zero if it is rigid.
    pub(super) punch: f64,
    /// The shear modulus.
    pub(super) shear_modulus: f64,
}

impl Constants {
    pub(super) fn new(pair: &MaterialPair, plate: Plate) -> Result<Self, RangeError> {
        let (punch, body) = (pair.body_1(), pair.body_2());
        let shear_modulus = body.shear_modulus();
        let allowed = "finite for the plate (it is rigid)";
        RangeError::check("shear_modulus", shear_modulus, !body.is_rigid(), allowed)?;
        let compliance =
            |material: crate::Material| (1.0 - material.poisson()) / material.shear_modulus();
        let (surface, punch) = (compliance(body), compliance(punch));
        Ok(Self { thickness: plate.thickness, surface, punch, shear_modulus })
    }
}
