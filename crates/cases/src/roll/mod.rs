//! A rolling contact on its grid: creep forces in the steady state, or step by step from rest.

mod row;

pub use row::{COLUMNS, CREEP, Creep, Row};

use crate::Error;
use crate::case::RollCase;
use carom_halfspace::Grid;
use carom_laws::friction::Friction;
use carom_laws::validity::Validity;
use carom_rolling::{
    CreepCoefficients, Creepage, Fastsim, RollingContact, RollingDrive, RollingError,
    SteadyContact, Way, creep_coefficients,
};
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Driven, Frictional, Gap, Method as _,
};
use std::path::Path;

/// Cells beyond the contact on each side, along and across: particles enter from the next cell.
const BORDER: [usize; 2] = [2, 1];
/// Strips and elements of FASTSIM.
const SPRINGS: [usize; 2] = [100, 100];

/// A rolling contact: its rows, and the contact after the last one.
#[derive(Debug, Clone)]
pub struct Rolled {
    /// A row for each creepage, or from rest for each cell rolled.
    pub rows: Vec<Row>,
    /// The last contact.
    pub state: ContactState,
    /// The creep coefficients, if they were wanted.
    pub creep: Option<Creep>,
}

/// What is computed beside the rows.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Wanted {
    /// Kalker's creep coefficients.
    pub coefficients: bool,
    /// The forces of FASTSIM, in the steady state; not from rest.
    pub springs: bool,
}

/// Computes a rolling contact.
///
/// # Errors
/// [`Error::Rolling`] if a row cannot be solved; [`Error::Law`], [`Error::Problem`] if a value is out of range.
pub fn rolled(path: &Path, case: &RollCase, wanted: Wanted) -> Result<Rolled, Error> {
    let creep = (wanted.coefficients || wanted.springs).then(|| creep(path, case)).transpose()?;
    let rolling = Rolling::new(path, case)?;
    let (rows, state) = match case.distance {
        Some(distance) => rolling.step_by_step(distance)?,
        None => rolling.steadily(creep.as_ref().filter(|_| wanted.springs))?,
    };
    Ok(Rolled { rows, state, creep: creep.filter(|_| wanted.coefficients) })
}

/// How far the contact is from the limits of the theory, with the smallest radius of the gap.
#[must_use]
pub fn validity(case: &RollCase) -> Validity {
    let curvature = case.hertz.curvature();
    let radius = 0.5 / curvature.a().max(curvature.b());
    Validity::of_hertz(&case.hertz, &case.loaded, radius)
}

/// Warnings about full sliding, and about effects that creep coefficients neglect.
#[must_use]
pub fn warnings(case: &RollCase, rows: &[Row], wanted: Wanted) -> Vec<String> {
    let sliding = rows.iter().filter(|row| row.slides).count();
    let mut warnings = Vec::new();
    if sliding > 0 {
        warnings.push(format!(
            "full sliding in {sliding} of {} rows: the creep force is saturated, and more creepage \
             does not increase it",
            rows.len()
        ));
    }
    if (wanted.coefficients || wanted.springs) && !case.hertz.materials().is_uncoupled() {
        let note = "creep coefficients and FASTSIM replace dissimilar bodies by two equal ones";
        warnings.push(note.to_owned());
    }
    warnings
}

/// A contact prepared for rolling.
struct Rolling<'a> {
    path: &'a Path,
    case: &'a RollCase,
    problem: ContactProblem,
}

impl<'a> Rolling<'a> {
    fn new(path: &'a Path, case: &'a RollCase) -> Result<Self, Error> {
        let range = |source| Error::Law { path: path.to_owned(), source };
        let ellipse = case.loaded.ellipse;
        let count = case.elements as f64;
        let [dx, dy] =
            [ellipse.semi_axis_a(), ellipse.semi_axis_b()].map(|half| 2.0 * half / count);
        let [nx, ny] = BORDER.map(|border| case.elements + 2 * border);
        let grid = Grid::new(nx, ny, dx, dy).map_err(range)?;
        let curvature = case.hertz.curvature();
        let (a, b) = (curvature.a(), curvature.b());
        let gap = Gap::from_function(grid, move |x, y| a * x * x + b * y * y).map_err(range)?;
        let friction = Friction::new(case.friction).map_err(range)?;
        let problem = ContactProblem::of_half_spaces(gap, case.hertz.materials(), friction)
            .map_err(|source| Error::Problem { path: path.to_owned(), source: source.into() })?;
        Ok(Self { path, case, problem })
    }

    fn failed(&self, row: usize, source: impl Into<RollingError>) -> Error {
        Error::Rolling { path: self.path.to_owned(), row, source: Box::new(source.into()) }
    }

    fn row(&self, state: &ContactState, convergence: Convergence, creepage: Creepage) -> Row {
        Row::of(state, convergence, [self.case.speed, self.case.friction], creepage)
    }

    /// A row for each creepage, and the state of the last one.
    fn steadily(&self, creep: Option<&Creep>) -> Result<(Vec<Row>, ContactState), Error> {
        let mut last = ContactState::apart(self.problem.grid());
        let mut rows = Vec::new();
        let force = Driven::Load(self.case.loaded.force);
        let mut contact = Way::new(self.problem.grid().dx())
            .map_err(RollingError::from)
            .and_then(|way| SteadyContact::new(&self.problem, way))
            .map_err(|source| self.failed(1, source))?;
        for (i, creepage) in self.case.creepages.iter().copied().enumerate() {
            let rolled = contact
                .roll(&RollingDrive::by_creepage(force, creepage), &mut ())
                .map_err(|source| self.failed(i + 1, source))?;
            let mut row = self.row(&rolled.state, rolled.convergence, creepage);
            if let Some(creep) = creep {
                row.springs = Some(self.springs(creep.coefficients, creepage)?);
            }
            rows.push(row);
            last = rolled.state;
        }
        Ok((rows, last))
    }

    fn springs(
        &self,
        coefficients: CreepCoefficients,
        creepage: Creepage,
    ) -> Result<[f64; 2], Error> {
        let loaded = &self.case.loaded;
        let fastsim = Fastsim {
            semi_axes: [loaded.ellipse.semi_axis_a(), loaded.ellipse.semi_axis_b()],
            shear_modulus: 2.0 * self.case.hertz.materials().shear_modulus(),
            coefficients,
            force: loaded.force,
            friction: self.case.friction,
            mesh: SPRINGS,
        };
        let forces = fastsim.forces(creepage);
        let forces = forces.map_err(|source| Error::Law { path: self.path.to_owned(), source })?;
        Ok([forces.f_x, forces.f_y])
    }

    /// A row for each cell rolled, the first one at rest, and the state at the end.
    fn step_by_step(&self, distance: f64) -> Result<(Vec<Row>, ContactState), Error> {
        let method = Frictional::default();
        let mut scratch = method.scratch(&self.problem).map_err(|source| self.failed(1, source))?;
        let apart = ContactState::apart(self.problem.grid());
        let mut state = apart.clone();
        let normal = Driven::Load(self.case.loaded.force);
        let pressed = Drive { normal, ..Drive::default() };
        let convergence = method
            .step(&self.problem, &apart, &pressed, &mut state, &mut scratch, &mut ())
            .map_err(|source| self.failed(1, source))?;
        let creepage = self.case.creepages.first().copied().unwrap_or_default();
        let step = self.problem.grid().dx();
        let at = |row: Row, steps: usize| Row { distance: Some(steps as f64 * step), ..row };
        let mut rows = vec![at(self.row(&state, convergence, creepage), 0)];
        let mut contact = Way::new(step)
            .map_err(RollingError::from)
            .and_then(|way| RollingContact::new(&self.problem, way))
            .map_err(|source| self.failed(1, source))?;
        let drive = RollingDrive::by_creepage(normal, creepage);
        // A whole number of cells, up to round-off.
        for number in 1..=(distance / step * (1.0 - 1e-9)).ceil() as usize {
            let before = state.clone();
            let convergence = contact
                .step(&drive, &before, &mut state, &mut ())
                .map_err(|source| self.failed(number + 1, source))?;
            rows.push(at(self.row(&state, convergence, creepage), number));
        }
        Ok((rows, state))
    }
}

/// The creep coefficients of the contact, with its bodies replaced by two equal ones.
fn creep(path: &Path, case: &RollCase) -> Result<Creep, Error> {
    let (ellipse, materials) = (case.loaded.ellipse, case.hertz.materials());
    let ratio = ellipse.semi_axis_a() / ellipse.semi_axis_b();
    let poisson = materials.poisson();
    let coefficients = creep_coefficients(ratio, poisson).map_err(|source| match source {
        RollingError::Range(source) => Error::Law { path: path.to_owned(), source },
        source => Error::Rolling { path: path.to_owned(), row: 1, source: Box::new(source) },
    })?;
    Ok(Creep { coefficients, ratio, shear_modulus: 2.0 * materials.shear_modulus(), poisson })
}
