//! Rolling as a sequence of steps.

use super::{Creepage, RollingError, Way, check_room};
use carom_solver::Method as _;
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Driven, Frictional, FrictionalScratch,
    Observer,
};

/// A step of rolling: its distance, its creepage, and the approach or normal force.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction};
/// use carom_rolling::{Creepage, Roll};
/// use carom_solver::{ContactProblem, ContactState, Driven, Frictional, Gap, Method};
/// let grid = Grid::new(16, 16, 0.15, 0.15)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3)?)?;
/// let method = Frictional::default();
/// let mut scratch = method.scratch(&problem)?;
/// let creepage = Creepage { along: 0.05, ..Creepage::default() };
/// let roll = Roll { distance: grid.dx(), creepage, normal: Driven::Shift(1.0) };
/// let mut state = ContactState::apart(grid);
/// let mut last = 0.0;
/// for _ in 0..10 {
///     let before = state.clone();
///     roll.step(&method, &problem, &before, &mut state, &mut scratch, &mut ())?;
///     assert!(state.load().f_x > last); // it builds up over the length of the contact
///     last = state.load().f_x;
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roll {
    /// The distance that the contact moves along +x.
    pub distance: f64,
    /// The creepage during the step.
    pub creepage: Creepage,
    /// Approach or normal force at the end of the step.
    pub normal: Driven,
}

impl Roll {
    /// Solves one step of rolling from one state to the next.
    ///
    /// # Errors
    /// [`RollingError`] for an operator that is not translation-invariant, a distance that is not positive, a contact too close to the leading
    /// border, and if the method fails.
    pub fn step(
        &self,
        method: &Frictional,
        problem: &ContactProblem,
        from: &ContactState,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, RollingError> {
        problem.operator().check_invariant()?;
        self.creepage.check()?;
        let way = Way::new(self.distance)?;
        way.check_on(problem.grid())?;
        let before = ahead(from, self.distance / problem.grid().dx());
        let Creepage { along, across, spin } = self.creepage;
        let drive = Drive {
            normal: self.normal,
            x: Driven::Shift(from.shift.xi + along * self.distance),
            y: Driven::Shift(from.shift.eta + across * self.distance),
            twist: Driven::Shift(from.shift.omega + spin * self.distance),
        };
        let convergence = method.step(problem, &before, &drive, to, scratch, observer)?;
        check_room(problem, to, &way)?;
        Ok(convergence)
    }
}

/// The state with the displacements that particles bring from `shift` columns ahead.
fn ahead(from: &ContactState, shift: f64) -> ContactState {
    let nx = from.pressure.grid().nx();
    let (whole, part) = (shift.floor() as usize, shift - shift.floor());
    let mut before = from.clone();
    for field in [&mut before.displacement_x, &mut before.displacement_y] {
        for row in field.values_mut().chunks_exact_mut(nx) {
            for i in 0..nx {
                let at = |column: usize| row[column.min(nx - 1)];
                row[i] = (1.0 - part) * at(i + whole) + part * at(i + whole + 1);
            }
        }
    }
    before
}
