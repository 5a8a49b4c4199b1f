//! The parameters of the Gauss-Seidel program of the thesis.

use carom_special::RangeError;

use crate::direct::check_tolerance;

/// The greatest number of passes of each loop, the control parameters of the thesis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Most {
    /// MaxSeidel: sweeps.
    pub seidel: usize,
    /// MaxContact: corrections of the contact area.
    pub contact: usize,
    /// Corrections of the directions of slip.
    pub slip: usize,
    /// MaxStick: corrections of the stick area.
    pub stick: usize,
    /// Passes of the whole program.
    pub program: usize,
}

impl Default for Most {
    fn default() -> Self {
        Self { seidel: 30, contact: 8, slip: 3, stick: 8, program: 400 }
    }
}

/// When the stresses in the slip area are adapted to their pressures, the second line of (12.17).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SlipStress {
    /// At the end of each sweep, (13.11).
    #[default]
    AfterSweep,
    /// As soon as a pressure is computed.
    AtOnce,
}

/// The program of chapter 12 of the thesis: a modified Gauss-Seidel iteration (12.17) inside loops
/// for the contact area, the directions of slip and the stick area. It uses coefficients instead of
/// a matrix: memory grows with the number of elements, time with its square. Shifts must be
/// prescribed.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction, law::Shift};
/// use carom_classic::jaeger::{GaussSeidel, ProgramStep};
/// use carom_solver::{ContactProblem, ContactState, Drive, Gap, Method};
/// let grid = Grid::new(16, 16, 0.14, 0.14)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.0)?;
/// let problem =
///     ContactProblem::of_half_spaces(gap, MaterialPair::new(body, body)?, Friction::new(0.4)?)?;
/// let method = GaussSeidel::default().over_relaxed(1.5)?;
/// let mut scratch = method.scratch(&problem)?;
/// let apart = ContactState::apart(grid);
/// let mut state = apart.clone();
/// let drive = Drive::by_shift(Shift { zeta: 1.0, xi: 0.2, ..Shift::default() });
/// let convergence = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
/// assert_eq!(scratch.trace().count(ProgramStep::Sweep), convergence.iterations);
/// // Cattaneo at half the shift of full slip.
/// let load = state.load();
/// assert!((load.f_x / (0.4 * load.f_z) - (1.0 - 0.5_f64.powf(1.5))).abs() < 2e-2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GaussSeidel {
    tolerance: f64,
    relaxation: f64,
    columns: usize,
    most: Most,
    slip_stress: SlipStress,
}

impl Default for GaussSeidel {
    /// Tolerance 1e-10, no over-relaxation, 80 columns in a slip matrix.
    fn default() -> Self {
        let slip_stress = SlipStress::default();
        Self { tolerance: 1e-10, relaxation: 1.0, columns: 80, most: Most::default(), slip_stress }
    }
}

impl GaussSeidel {
    /// Sets the tolerance: violations of the normal conditions relative to the greatest
    /// displacement, and of the friction law relative to the greatest friction limit.
    ///
    /// # Errors
    /// [`RangeError`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        check_tolerance(tolerance)?;
        Ok(Self { tolerance, ..self })
    }

    /// Sets the over-relaxation factor; 1 is plain Gauss-Seidel.
    ///
    /// # Errors
    /// [`RangeError`] unless it is between 0 and 2; at these limits sweeps do not converge.
    pub fn over_relaxed(self, factor: f64) -> Result<Self, RangeError> {
        let holds = factor > 0.0 && factor < 2.0;
        RangeError::check("over-relaxation", factor, holds, "between 0 and 2, both excluded")?;
        Ok(Self { relaxation: factor, ..self })
    }

    /// Limits the passes of each loop.
    #[must_use]
    pub const fn at_most(self, most: Most) -> Self {
        Self { most, ..self }
    }

    /// Limits the columns of slip matrices (SMColMax); a row of elements is never divided.
    #[must_use]
    pub const fn in_blocks_of(self, columns: usize) -> Self {
        Self { columns, ..self }
    }

    /// Sets when the stresses in the slip area are adapted to their pressures.
    #[must_use]
    pub const fn with_slip_stress(self, slip_stress: SlipStress) -> Self {
        Self { slip_stress, ..self }
    }

    pub(super) const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    pub(super) const fn relaxation(&self) -> f64 {
        self.relaxation
    }

    pub(super) const fn columns(&self) -> usize {
        self.columns
    }

    pub(super) const fn most(&self) -> Most {
        self.most
    }

    pub(super) const fn slip_stress(&self) -> SlipStress {
        self.slip_stress
    }
}
