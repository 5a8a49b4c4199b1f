//! Sides and thickness of a plate, and what it is made of.

use carom_special::RangeError;

use crate::{Grid, Material, MaterialPair};

/// The least thickness, as a part of the longer side.
const THINNEST: f64 = 1e-6;
/// Apery's constant, the sum of 1/m^3.
const APERY: f64 = 1.202_056_903_159_594_2;
/// Beyond this wave the sides do not matter.
const LAST_WAVE: u32 = 15;
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

    /// The displacement of the middle of the plate under a unit force there, by bending alone (Navier;
    /// Timoshenko and Woinowsky-Krieger): 0.01160 a^2/D for a square. Zero if the plate is rigid.
    ///
    /// ```
    /// use carom_halfspace::Material;
    /// use carom_halfspace::operator::Plate;
    /// let glass = Material::from_young(70e9, 0.22)?;
    /// let pane = Plate::new(0.3, 0.3, 0.004)?;
    /// let stiffness = 70e9 * 0.004_f64.powi(3) / (12.0 * (1.0 - 0.22 * 0.22));
    /// assert!((pane.middle_compliance(glass) * stiffness / 0.09 - 0.01160).abs() < 1e-5);
    /// # Ok::<(), carom_special::RangeError>(())
    /// ```
    #[must_use]
    pub fn middle_compliance(&self, material: Material) -> f64 {
        let (short, long) = (self.a.min(self.b), self.a.max(self.b));
        // Sum of 1/m^3 over odd m; the rest falls exponentially.
        let mut sum = 0.875 * APERY;
        for m in (1..LAST_WAVE).step_by(2).map(f64::from) {
            let width = 0.5 * m * std::f64::consts::PI * long / short;
            let tanh = libm::tanh(width);
            sum += (tanh - 1.0 - width * (1.0 - tanh * tanh)) / (m * m * m);
        }
        let per_stiffness = 6.0 * (1.0 - material.poisson())
            / material.shear_modulus()
            / libm::pow(self.thickness, 3.0);
        per_stiffness * short * short * sum / (2.0 * libm::pow(std::f64::consts::PI, 3.0))
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
    ///
    /// # Errors
    /// [`RangeError`] that holds the side that differs.
    pub fn check_cover(&self, grid: Grid) -> Result<(), RangeError> {
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
        let compliance = |material: Material| (1.0 - material.poisson()) / material.shear_modulus();
        let (surface, punch) = (compliance(body), compliance(punch));
        Ok(Self { thickness: plate.thickness, surface, punch, shear_modulus })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Timoshenko and Woinowsky-Krieger, table 23, to 3e-5; Navier's double series to its last terms.
    #[test]
    fn compliance_of_the_middle_is_published_and_that_of_navier() {
        let material = Material::from_young(12.0 * 0.91, 0.3).unwrap();
        for (longer, published) in [(1.0, 0.01160), (1.2, 0.01353), (1.6, 0.01570), (2.0, 0.01651)]
        {
            let odd = || (1..400).step_by(2).map(f64::from);
            let wave = |m: f64, n: f64| (m * m + n * n / (longer * longer)).powi(-2);
            let sum: f64 = odd().map(|m| odd().map(|n| wave(m, n)).sum::<f64>()).sum();
            let navier = 4.0 * sum / (std::f64::consts::PI.powi(4) * longer);
            for [a, b] in [[1.0, longer], [longer, 1.0]] {
                let found = Plate::new(a, b, 1.0).unwrap().middle_compliance(material);
                assert!((found - published).abs() < 3e-5, "{longer}: {found}");
                assert!((0.0..3e-7).contains(&(found - navier)), "{longer}: {found} {navier}");
            }
        }
        assert_eq!(Plate::new(1.0, 1.0, 0.1).unwrap().middle_compliance(Material::RIGID), 0.0);
    }
}
