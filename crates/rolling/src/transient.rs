//! Rolling as a sequence of steps.

use std::sync::Arc;

use carom_halfspace::operator::{
    DisplacementField, RolledOperator, SurfaceOperator as _, TractionField, Workspace,
};

use super::{RollingDrive, RollingError, Way, check_friction, check_room};
use carom_solver::Method as _;
use carom_solver::{
    ContactProblem, ContactState, Convergence, Frictional, FrictionalScratch, Observer,
};

/// A contact prepared for rolling step by step.
///
/// In a step of length d the particle now at x comes from x + d and brings its displacement along:
/// the slip of the step is `u(x) - u_old(x + d) - d (xi + y phi, eta - x phi)`. The displacement
/// u_old(x + d) is that of the old tractions, exact at any distance and in any direction.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction};
/// use carom_rolling::{Creepage, RollingContact, RollingDrive, Way};
/// use carom_solver::{ContactProblem, ContactState, Driven, Gap};
/// let grid = Grid::new(16, 16, 0.15, 0.15)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3)?)?;
/// let mut contact = RollingContact::new(&problem, Way::new(grid.dx())?)?;
/// let creepage = Creepage { along: 0.05, ..Creepage::default() };
/// let drive = RollingDrive::by_creepage(Driven::Shift(1.0), creepage);
/// let mut state = ContactState::apart(grid);
/// let mut last = 0.0;
/// for _ in 0..10 {
///     let before = state.clone();
///     contact.step(&drive, &before, &mut state, &mut ())?;
///     assert!(state.load().f_x > last); // it builds up over the length of the contact
///     last = state.load().f_x;
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct RollingContact {
    problem: ContactProblem,
    rolled: RolledOperator,
    way: Way,
    method: Frictional,
    scratch: FrictionalScratch,
    before: ContactState,
    workspace: Workspace,
}

impl RollingContact {
    /// Prepares a contact for rolling in steps of this way.
    ///
    /// # Errors
    /// [`RollingError`] for a way beyond the grid, an operator that is not translation-invariant,
    /// static friction above kinetic friction, and too little memory.
    pub fn new(problem: &ContactProblem, way: Way) -> Result<Self, RollingError> {
        check_friction(problem)?;
        way.check_on(problem.grid())?;
        let body = Arc::clone(problem.shared_operator());
        let threads = body.threads();
        let rolled = RolledOperator::new(body, way.ahead(), threads)?;
        let (method, workspace) = (Frictional::default(), rolled.workspace());
        let (scratch, before) = (method.scratch(problem)?, ContactState::apart(problem.grid()));
        let problem = problem.clone();
        Ok(Self { problem, rolled, way, method, scratch, before, workspace })
    }

    /// The same with this tolerance: violations of the normal conditions relative to the greatest
    /// displacement, and of the friction law relative to the greatest friction limit.
    ///
    /// # Errors
    /// [`RollingError::Range`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RollingError> {
        Ok(Self { method: self.method.within(tolerance)?, ..self })
    }

    /// Solves one step of rolling from one state to the next.
    ///
    /// # Errors
    /// [`RollingError`] for values out of range, forces that friction cannot hold, a contact too
    /// close to the leading border, and if the method fails.
    pub fn step(
        &mut self,
        drive: &RollingDrive,
        from: &ContactState,
        to: &mut ContactState,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, RollingError> {
        drive.check_about(&self.way)?;
        from.check_grid(self.problem.grid())?;
        self.look_ahead(from)?;
        let drive = drive.step(&self.way, from.shift);
        let Self { method, problem, before, scratch, .. } = self;
        let convergence = method.step(problem, before, &drive, to, scratch, observer)?;
        check_room(&self.problem, to, &self.way)?;
        Ok(convergence)
    }

    /// Sets `before` to a state with the displacements that its particles bring from ahead.
    fn look_ahead(&mut self, from: &ContactState) -> Result<(), RollingError> {
        let before = &mut self.before;
        before.clone_from(from);
        let load = TractionField::full(
            from.traction_x.values(),
            from.traction_y.values(),
            from.pressure.values(),
        );
        let change = DisplacementField::tangential(
            before.displacement_x.values_mut(),
            before.displacement_y.values_mut(),
        );
        self.rolled.apply(load, change, &mut self.workspace)?;
        let fields = [
            (&mut before.displacement_x, &from.displacement_x),
            (&mut before.displacement_y, &from.displacement_y),
        ];
        for (before, own) in fields {
            for (before, own) in before.values_mut().iter_mut().zip(own.values()) {
                *before = own - *before;
            }
        }
        Ok(())
    }
}
