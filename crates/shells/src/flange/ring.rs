//! A circular ring whose stiffness may vary around.

use carom_dense::{Mat, c64};
use carom_special::RangeError;

use super::section::{RingStiffness, StiffnessKind};
use crate::dense::{self, Singular};
use crate::fourier::{PiecewiseConstant, Sector, toeplitz};

/// A circular ring: radius of its centroid line, four stiffnesses, each of which may have sectors
/// (bolt holes, ribs) where it is multiplied by a factor.
///
/// ```
/// use carom_shells::flange::{Ring, RingStiffness, StiffnessKind};
/// use carom_shells::fourier::Sector;
/// let section = RingStiffness::rectangle(1.0, 0.3, 0.08, 0.1)?;
/// let hole = Sector::new(0.0, 0.06, 0.5)?;
/// let ring = Ring::new(1.0, section)?.with_sectors(StiffnessKind::InPlane, &[hole])?;
/// assert_eq!(ring.stiffness_at(StiffnessKind::InPlane, 0.0), 0.5 * section.in_plane());
/// # Ok::<(), carom_special::RangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Ring {
    radius: f64,
    stiffness: [PiecewiseConstant; 4],
}

impl Ring {
    /// A uniform ring of radius `radius` > 0.
    ///
    /// # Errors
    /// [`RangeError`] for the radius, or if sqrt(EI/EA), about a third of the height of the
    /// section, is more than a fifth of it: then the ring is not slender.
    pub fn new(radius: f64, section: RingStiffness) -> Result<Self, RangeError> {
        let radius = RangeError::positive("radius", radius)?;
        for (field, bending) in
            [("in_plane", section.in_plane()), ("out_of_plane", section.out_of_plane())]
        {
            let gyration = (bending / section.stretching()).sqrt();
            let allowed = "such that sqrt(bending/stretching) <= radius/5, a slender ring";
            RangeError::check(field, bending, gyration <= 0.2 * radius, allowed)?;
        }
        let [a, b, c, d] =
            StiffnessKind::ALL.map(|kind| PiecewiseConstant::uniform(section.of(kind)));
        Ok(Self { radius, stiffness: [a?, b?, c?, d?] })
    }

    /// The ring with one of its stiffnesses multiplied by a factor in each of these sectors.
    ///
    /// # Errors
    /// [`RangeError`] if sectors overlap.
    pub fn with_sectors(
        mut self,
        kind: StiffnessKind,
        sectors: &[Sector],
    ) -> Result<Self, RangeError> {
        let own = &mut self.stiffness[kind as usize];
        *own = PiecewiseConstant::new(own.base(), sectors)?;
        Ok(self)
    }

    /// Radius of the centroid line.
    #[must_use]
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    /// The stiffness of a kind at an angle.
    #[must_use]
    pub fn stiffness_at(&self, kind: StiffnessKind, angle: f64) -> f64 {
        self.stiffness[kind as usize].at(angle)
    }

    /// Whether no stiffness varies.
    #[must_use]
    pub fn is_uniform(&self) -> bool {
        self.stiffness.iter().all(PiecewiseConstant::is_uniform)
    }

    /// The strain of a kind in harmonic k, times R, per unit of (w/R, v/R, u/R, beta).
    pub(super) fn strain_row(kind: StiffnessKind, k: i64) -> [c64; 4] {
        let k = k as f64;
        let [zero, one] = [c64::new(0.0, 0.0), c64::new(1.0, 0.0)];
        let (turned, square) = (c64::new(0.0, k), c64::new(k * k, 0.0));
        match kind {
            StiffnessKind::Stretching => [one, turned, zero, zero],
            StiffnessKind::InPlane => [square, turned, zero, zero],
            StiffnessKind::OutOfPlane => [zero, zero, square, one],
            StiffnessKind::Torsion => [zero, zero, turned, turned],
        }
    }

    /// The stiffness of a kind as an operator on series, relative to what makes all four alike: EA
    /// R^2 for stretching, EI and so on for the rest (strains times R are then pure numbers).
    pub(super) fn operator(
        &self,
        kind: StiffnessKind,
        order: usize,
    ) -> Result<RingOperator, Singular> {
        let stiffness = &self.stiffness[kind as usize];
        let unit = match kind {
            StiffnessKind::Stretching => self.radius * self.radius,
            _ => 1.0,
        };
        if stiffness.is_uniform() {
            return Ok(RingOperator::Number(unit * stiffness.base()));
        }
        let mut matrix = dense::inverse(&toeplitz(&stiffness.reciprocal_series(2 * order), order))?;
        for column in 0..matrix.ncols() {
            for row in 0..matrix.nrows() {
                matrix[(row, column)] *= unit;
            }
        }
        Ok(RingOperator::Matrix(matrix))
    }
}

/// A stiffness as an operator on series: a number if it is uniform.
#[derive(Debug, Clone)]
pub(super) enum RingOperator {
    Number(f64),
    Matrix(Mat<c64>),
}

impl RingOperator {
    /// The entry of row and column, counted from 0.
    pub(super) fn entry(&self, row: usize, column: usize) -> c64 {
        match self {
            Self::Number(value) => c64::new(if row == column { *value } else { 0.0 }, 0.0),
            Self::Matrix(matrix) => matrix[(row, column)],
        }
    }
}
