//! The theory of convergence of chapter 13: iteration matrices of the methods of chapters 11 and 12
//! for any contact area, and their spectra.
//!
//! The area is that of a flat punch: all its elements are in contact. Either all stick (13.2) or
//! all slip along x (13.1), (13.3).

use carom_dense::{Factors, Mat};
use carom_halfspace::operator::{OperatorError, SurfaceOperator};
use carom_halfspace::{Field, MaterialPair};
use carom_special::RangeError;

use crate::direct::Influence;
use crate::jaeger::SlipStress;

/// Greatest number of elements of an area; the largest matrix has three times as many rows.
const MOST_ELEMENTS: usize = 1000;

/// Why a spectrum could not be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TheoryError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The operator has no table of coefficients.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// The eigenvalues of a matrix did not converge, or the matrix was singular.
    #[error("the eigenvalues of a matrix with {rows} rows did not converge")]
    NoEigenvalues {
        /// The number of its rows.
        rows: usize,
    },
}

/// The eigenvalues of an iteration matrix.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Real and imaginary parts.
    pub eigenvalues: Vec<[f64; 2]>,
}

impl Spectrum {
    /// The spectral radius: the asymptotic factor by which the error falls in each iteration.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.eigenvalues.iter().map(|[re, im]| re.hypot(*im)).fold(0.0, f64::max)
    }
}

/// The iteration matrices of a contact area.
///
/// ```
/// use carom_halfspace::{Field, Grid, Material, MaterialPair};
/// use carom_halfspace::operator::HalfSpaceOperator;
/// use carom_classic::theory::ContactArea;
/// let (one, two) = (Material::RIGID, Material::from_shear(1.0, 0.0)?);
/// let pair = MaterialPair::new(one, two)?; // gamma = -1/2
/// let grid = Grid::new(10, 1, 1.0, 1.0)?;
/// let area = ContactArea::new(&HalfSpaceOperator::new(pair, grid)?, &Field::uniform(grid, true))?;
/// let radius = area.sliding_pass(0.5)?.radius();
/// assert!(radius > 0.1 && radius < 0.25); // f |gamma|
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct ContactArea {
    influence: Influence,
    cells: Vec<usize>,
}

impl ContactArea {
    /// The area of the elements for which `touches` is true.
    ///
    /// # Errors
    /// [`TheoryError::Range`] for no or more than 1000 elements, or if `touches` is on another
    /// grid.
    pub fn new(operator: &dyn SurfaceOperator, touches: &Field<bool>) -> Result<Self, TheoryError> {
        let (cells, same) = (touches.values().len() as f64, touches.grid() == operator.grid());
        RangeError::check("contact area", cells, same, "on the grid of the operator")?;
        let cells: Vec<usize> =
            (0..touches.values().len()).filter(|&i| touches.values()[i]).collect();
        let holds = (1..=MOST_ELEMENTS).contains(&cells.len());
        RangeError::check("elements", cells.len() as f64, holds, "from 1 to 1000")?;
        Ok(Self { influence: Influence::new(operator)?, cells })
    }

    /// The number of elements.
    #[must_use]
    pub fn elements(&self) -> usize {
        self.cells.len()
    }

    /// A block of A (12.15): displacements `of` due to tractions `by`.
    fn part(&self, of: usize, by: usize) -> Mat<f64> {
        let count = self.cells.len();
        Mat::from_fn(count, count, |i, k| {
            self.influence.coefficient(of, by, self.cells[i], self.cells[k])
        })
    }

    /// Several blocks, side by side and one above the other.
    fn parts(&self, of: &[usize], by: &[usize]) -> Mat<f64> {
        let count = self.cells.len();
        Mat::from_fn(of.len() * count, by.len() * count, |i, k| {
            let (to, from) = (self.cells[i % count], self.cells[k % count]);
            self.influence.coefficient(of[i / count], by[k / count], to, from)
        })
    }

    /// T (13.12): sweeps of (12.17) if all elements slip along x with this coefficient of friction;
    /// negative for slip in the opposite direction.
    ///
    /// # Errors
    /// [`TheoryError`] if the friction coefficient is not finite or eigenvalues do not converge.
    pub fn sliding_sweep(
        &self,
        friction: f64,
        slip_stress: SlipStress,
    ) -> Result<Spectrum, TheoryError> {
        RangeError::finite("friction", friction)?;
        let (a33, a31) = (self.part(2, 2), self.part(2, 0));
        let count = self.cells.len();
        let sum = Mat::from_fn(count, count, |i, k| a33[(i, k)] + friction * a31[(i, k)]);
        // The part computed in this sweep, and the part taken from the last one.
        let (new, old) = match slip_stress {
            SlipStress::AfterSweep => {
                let new = Mat::from_fn(count, count, |i, k| if k <= i { a33[(i, k)] } else { 0.0 });
                let old = Mat::from_fn(count, count, |i, k| new[(i, k)] - sum[(i, k)]);
                (new, old)
            }
            SlipStress::AtOnce => lower_and_rest(&sum),
        };
        eigenvalues(&Factors::new(&new).solve_columns(&old))
    }

    /// Sweeps of (12.17) if all elements stick: Gauss-Seidel for the whole of A.
    ///
    /// # Errors
    /// [`TheoryError::NoEigenvalues`].
    pub fn adhesion_sweep(&self) -> Result<Spectrum, TheoryError> {
        let (new, old) = lower_and_rest(&self.parts(&[0, 1, 2], &[0, 1, 2]));
        eigenvalues(&Factors::new(&new).solve_columns(&old))
    }

    /// T (13.25): the block iteration, one component after the other, if all elements stick.
    ///
    /// # Errors
    /// [`TheoryError::NoEigenvalues`].
    pub fn adhesion_blocks(&self) -> Result<Spectrum, TheoryError> {
        let all = self.parts(&[0, 1, 2], &[0, 1, 2]);
        let count = self.cells.len();
        let rows = 3 * count;
        let new = |i: usize, k: usize| k / count <= i / count;
        let left = Mat::from_fn(rows, rows, |i, k| if new(i, k) { all[(i, k)] } else { 0.0 });
        let right = Mat::from_fn(rows, rows, |i, k| if new(i, k) { 0.0 } else { -all[(i, k)] });
        eigenvalues(&Factors::new(&left).solve_columns(&right))
    }

    /// M1 (13.32): pressures and tractions along x alternately, if all elements stick.
    ///
    /// # Errors
    /// [`TheoryError::NoEigenvalues`].
    pub fn adhesion_pass_along_x(&self) -> Result<Spectrum, TheoryError> {
        self.adhesion(&[0])
    }

    /// M1 (13.32) with tractions along x and y: passes of Panagiotopoulos's process if all elements
    /// stick.
    ///
    /// # Errors
    /// [`TheoryError::NoEigenvalues`].
    pub fn adhesion_pass(&self) -> Result<Spectrum, TheoryError> {
        self.adhesion(&[0, 1])
    }

    fn adhesion(&self, tangential: &[usize]) -> Result<Spectrum, TheoryError> {
        let by_pressure = self.parts(tangential, &[2]);
        let held = Factors::new(&self.parts(tangential, tangential)).solve_columns(&by_pressure);
        let back = self.parts(&[2], tangential) * held;
        eigenvalues(&Factors::new(&self.part(2, 2)).solve_columns(&back))
    }

    /// M2 (13.34): passes of Panagiotopoulos's process if all elements slip along x.
    ///
    /// # Errors
    /// [`TheoryError`] if the friction coefficient is not finite or eigenvalues do not converge.
    pub fn sliding_pass(&self, friction: f64) -> Result<Spectrum, TheoryError> {
        RangeError::finite("friction", friction)?;
        let solved = Factors::new(&self.part(2, 2)).solve_columns(&self.part(2, 0));
        let mut spectrum = eigenvalues(&solved)?;
        for [re, im] in &mut spectrum.eigenvalues {
            (*re, *im) = (-friction * *re, -friction * *im);
        }
        Ok(spectrum)
    }
}

/// The lower triangle with its diagonal, and the rest with opposite sign.
fn lower_and_rest(matrix: &Mat<f64>) -> (Mat<f64>, Mat<f64>) {
    let rows = matrix.nrows();
    let lower = Mat::from_fn(rows, rows, |i, k| if k <= i { matrix[(i, k)] } else { 0.0 });
    let rest = Mat::from_fn(rows, rows, |i, k| if k > i { -matrix[(i, k)] } else { 0.0 });
    (lower, rest)
}

fn eigenvalues(matrix: &Mat<f64>) -> Result<Spectrum, TheoryError> {
    let none = || TheoryError::NoEigenvalues { rows: matrix.nrows() };
    let values = carom_dense::eigenvalues(matrix).ok_or_else(none)?;
    Ok(Spectrum { eigenvalues: values.into_iter().map(|value| [value.re, value.im]).collect() })
}

/// The bounds of chapter 13 for a pair of materials, and bounds valid for any contact area.
///
/// On the half-space A33 and A11 along the slip have the symbol c/|k|, A31 has i gamma c k_x/k^2:
/// these are upper bounds on the spectral radius for any contact area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    gamma: f64,
    epsilon_1: f64,
}

impl Bounds {
    /// The bounds for a pair of materials.
    #[must_use]
    pub fn of(pair: &MaterialPair) -> Self {
        // (13.40) with (4.7)
        Self { gamma: pair.gamma(), epsilon_1: 1.0 / (1.0 - pair.poisson()) }
    }

    /// epsilon_1 (13.40): the ratio of A11 to A33 for a single line of elements.
    #[must_use]
    pub const fn epsilon_1(&self) -> f64 {
        self.epsilon_1
    }

    /// Whether (13.22) implies that sweeps converge, 0 < f gamma < 1. It was proved for one line of
    /// elements and the simple coefficients of (13.17); it is too weak for an area and too strict
    /// for a line.
    #[must_use]
    pub fn sweeps_converge(&self, friction: f64) -> bool {
        let product = friction * self.gamma;
        product > 0.0 && product < 1.0
    }

    /// (13.43) with lambda_1 = 1: the spectral radius of M2 is at most f times the square root of
    /// epsilon_1.
    #[must_use]
    pub fn sliding_pass_printed(&self, friction: f64) -> f64 {
        friction.abs() * self.epsilon_1.sqrt()
    }

    /// The spectral radius of M2 is at most f |gamma|.
    #[must_use]
    pub fn sliding_pass(&self, friction: f64) -> f64 {
        (friction * self.gamma).abs()
    }

    /// The spectral radius of M1 is at most gamma^2, also with tractions along both axes.
    #[must_use]
    pub fn adhesion_pass(&self) -> f64 {
        self.gamma * self.gamma
    }
}
