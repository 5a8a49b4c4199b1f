//! Steady rolling: the tractions that the surfaces flow through.

use std::sync::Arc;

use carom_halfspace::Field;
use carom_halfspace::operator::{DisplacementField, RolledOperator, TractionField};
use carom_laws::law::Shift;
use carom_special::RangeError;

use super::{
    Creepage, RollingDrive, RollingError, RollingFriction, Way, check_friction, check_room,
};
use carom_solver::{
    CellState, ContactProblem, ContactState, Convergence, Drive, Driven, Frictional,
    FrictionalScratch, Method as _, Observer,
};

/// Steady rolling.
#[derive(Debug, Clone)]
pub struct SteadyRolling {
    /// Tractions, displacements and areas, which are constant in time; the shift is that of one
    /// step.
    pub state: ContactState,
    /// The creepages, given or found.
    pub creepage: Creepage,
    /// Friction heat per distance rolled: the work of the loads on the creepage, less that of the
    /// tractions on what the pressures displace, which bodies of unlike materials have.
    pub heat: f64,
    /// The convergence of the solution.
    pub convergence: Convergence,
    /// Whether the creepage is above saturation: the whole contact slides, and more creepage does
    /// not increase the force.
    pub slides: bool,
}

/// A contact prepared for steady rolling on one way, for curves of many creepages or forces.
///
/// In the steady state the displacements are constant in the moving axes, so that the slip of a
/// step is `u(x) - u(x + d) - d (xi + y phi, eta - x phi)` with the same tractions in both terms:
/// one step with the influence of a [`RolledOperator`]. It is the limit of [`super::RollingContact`]
/// on the same way. Each solution starts from the last one.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::friction::Friction;
/// use carom_rolling::{Creepage, RollingDrive, SteadyContact, Way};
/// use carom_solver::{ContactProblem, Driven, Gap};
/// let grid = Grid::new(14, 12, 0.2, 0.2)?;
/// let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
/// let body = Material::from_shear(1.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3)?)?;
/// let mut contact = SteadyContact::new(&problem, Way::new(grid.dx())?)?;
/// let free = RollingDrive::by_creepage(Driven::Load(2.0), Creepage::default());
/// let driven = contact.roll(&RollingDrive { along: Driven::Load(0.3), ..free }, &mut ())?;
/// assert!((driven.state.load().f_x - 0.3).abs() < 1e-8);
/// let again = contact.roll(&RollingDrive::by_creepage(Driven::Load(2.0), driven.creepage), &mut ())?;
/// assert!((again.state.load().f_x - 0.3).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct SteadyContact {
    problem: ContactProblem,
    /// The same with the change of displacement in a step for the displacement.
    rolled: ContactProblem,
    way: Way,
    method: Frictional,
    scratch: FrictionalScratch,
    last: ContactState,
    heat: f64,
    /// Creepages along and across of each cell, beyond those of a drive.
    local: Option<[Field; 2]>,
    by_slip: Option<RollingFriction>,
}

impl SteadyContact {
    /// Prepares a contact for rolling on a way.
    ///
    /// # Errors
    /// [`RollingError`] for a way beyond the grid, an operator that is not translation-invariant,
    /// static friction above kinetic friction, and too little memory.
    pub fn new(problem: &ContactProblem, way: Way) -> Result<Self, RollingError> {
        check_friction(problem)?;
        way.check_on(problem.grid())?;
        let body = Arc::clone(problem.shared_operator());
        let threads = body.threads();
        let operator = RolledOperator::new(body, way.ahead(), threads)?;
        let friction = problem.friction().clone();
        let rolled = ContactProblem::new(problem.gap().clone(), Arc::new(operator), friction)?;
        let method = Frictional::default();
        let scratch = method.scratch(&rolled)?;
        let (problem, last) = (problem.clone(), ContactState::apart(problem.grid()));
        Ok(Self {
            problem,
            rolled,
            way,
            method,
            scratch,
            last,
            heat: 0.0,
            local: None,
            by_slip: None,
        })
    }

    /// The same with this tolerance: violations of the normal conditions relative to the greatest
    /// displacement, and of the friction law relative to the greatest friction limit.
    ///
    /// # Errors
    /// [`RollingError::Range`] unless it is in the range 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RollingError> {
        Ok(Self { method: self.method.within(tolerance)?, ..self })
    }

    /// The same with friction by the slip speed of each cell instead of that of the problem.
    #[must_use]
    pub fn with_friction_by_slip(self, friction: RollingFriction) -> Self {
        Self { by_slip: Some(friction), ..self }
    }

    /// The same with creepages along and across that vary over the surface, in addition to those of
    /// a drive. Where a contact is not flat, as that of a flange root and a gauge corner, each part
    /// of it slips at its own radius and spins about its own normal.
    ///
    /// ```
    /// use carom_halfspace::{Field, Grid, Material, MaterialPair};
    /// use carom_laws::friction::Friction;
    /// use carom_rolling::{Creepage, RollingDrive, SteadyContact, Way};
    /// use carom_solver::{ContactProblem, Driven, Gap};
    /// let grid = Grid::new(14, 12, 0.2, 0.2)?;
    /// let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
    /// let body = Material::from_shear(1.0, 0.3)?;
    /// let pair = MaterialPair::new(body, body)?;
    /// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3)?)?;
    /// let contact = SteadyContact::new(&problem, Way::new(grid.dx())?)?;
    /// let drive = |spin| {
    ///     let creepage = Creepage { spin, ..Creepage::default() };
    ///     RollingDrive::by_creepage(Driven::Load(2.0), creepage)
    /// };
    /// // Spin, given cell by cell.
    /// let [along, across] = [|_, y| 0.1 * y, |x, _| -0.1 * x];
    /// let [along, across] = [Field::from_function(grid, along), Field::from_function(grid, across)];
    /// let varied = contact.clone().with_local_creepage(along, across)?.roll(&drive(0.0), &mut ())?;
    /// let spun = contact.clone().roll(&drive(0.1), &mut ())?;
    /// assert!((varied.state.load().f_y - spun.state.load().f_y).abs() < 1e-8);
    /// assert!((varied.heat / spun.heat - 1.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RollingError::Range`] unless both fields are on the grid of the problem and finite.
    pub fn with_local_creepage(self, along: Field, across: Field) -> Result<Self, RollingError> {
        for (name, field) in [("creepage", &along), ("creepage_across", &across)] {
            let (own, grid) = (field.grid(), self.problem.grid());
            let allowed = "on the grid of the problem";
            RangeError::check(name, own.cells() as f64, own == grid, allowed)?;
            field
                .values()
                .iter()
                .try_for_each(|value| RangeError::finite(name, *value).map(drop))?;
        }
        let mut contact = Self { local: Some([along, across]), ..self };
        contact.bring();
        Ok(contact)
    }

    /// Solves for steady rolling, starting from the last solution.
    ///
    /// # Errors
    /// [`RollingError`] for values out of range, forces that friction cannot hold, a contact too
    /// close to the leading border, and if the solution does not converge.
    pub fn roll(
        &mut self,
        drive: &RollingDrive,
        observer: &mut dyn Observer,
    ) -> Result<SteadyRolling, RollingError> {
        drive.check_about(&self.way)?;
        let mut state = ContactState::apart(self.problem.grid());
        let drive = drive.step(&self.way, Shift::default());
        let convergence = match self.by_slip {
            None => self.solve(&drive, &mut state, observer)?,
            Some(friction) => self.settle(friction, &drive, &mut state, observer)?,
        };
        check_room(&self.problem, &state, &self.way)?;
        self.heat = self.heat_of(&state)?;
        self.remember(&state);
        let creepage = self.way.creepage(state.shift);
        self.displace(&mut state)?;
        let slides = state.count(CellState::Stick) == 0 && state.count(CellState::Slip) > 0;
        Ok(SteadyRolling { state, creepage, heat: self.heat, convergence, slides })
    }

    fn solve(
        &mut self,
        drive: &Drive,
        state: &mut ContactState,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, RollingError> {
        let Self { method, rolled, last, scratch, .. } = self;
        Ok(method.step(rolled, last, drive, state, scratch, observer)?)
    }

    /// Solves until the friction of each cell is that of its slip.
    fn settle(
        &mut self,
        friction: RollingFriction,
        drive: &Drive,
        state: &mut ContactState,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, RollingError> {
        let mut settling = friction.at_rest(&self.way, self.problem.grid())?;
        loop {
            self.rolled = self.rolled.clone().with_friction(settling.friction())?;
            let went = self.solve(drive, state, observer)?;
            if let Some(all) = settling.follow(state, &self.last, went)? {
                return Ok(all);
            }
            self.remember(state);
        }
    }

    /// Friction heat of the last solution per distance rolled; 0 before the first.
    #[must_use]
    pub const fn heat(&self) -> f64 {
        self.heat
    }

    /// The slip of a particle is the rigid shift less the change of displacement. The part of that
    /// change by the tractions themselves does no work in the steady state, where each particle takes
    /// out what it has brought in; on a grid it would be an error of first order.
    fn heat_of(&self, state: &ContactState) -> Result<f64, RollingError> {
        let grid = state.pressure.grid();
        let [mut along, mut across] = [Field::uniform(grid, 0.0), Field::uniform(grid, 0.0)];
        let operator = self.rolled.operator();
        operator.apply(
            TractionField::normal(state.pressure.values()),
            DisplacementField::tangential(along.values_mut(), across.values_mut()),
            &mut operator.workspace(),
        )?;
        let (load, shift) = (state.load(), state.shift);
        let rigid = load.f_x * shift.xi + load.f_y * shift.eta + load.m_z * shift.omega;
        let work = |traction: &Field, change: &Field| -> f64 {
            traction.values().iter().zip(change.values()).map(|(t, u)| t * u).sum()
        };
        let elastic = work(&state.traction_x, &along) + work(&state.traction_y, &across);
        let local = self.local.as_ref().map_or(0.0, |[along, across]| {
            work(&state.traction_x, along) + work(&state.traction_y, across)
        });
        let area = grid.cell_area();
        Ok((rigid - area * elastic) / self.way.length() + area * local)
    }

    /// Keeps a solution as the start of the next one.
    fn remember(&mut self, state: &ContactState) {
        self.last.clone_from(state);
        self.bring();
        let zeta = state.shift.zeta;
        self.last.shift = Shift { zeta, ..Shift::default() };
    }

    /// What the particles bring is part of the influence, so that nothing is displaced before a step
    /// but by what a cell creeps beyond the drive.
    fn bring(&mut self) {
        let before = [&mut self.last.displacement_x, &mut self.last.displacement_y];
        for (axis, before) in before.into_iter().enumerate() {
            match &self.local {
                None => before.values_mut().fill(0.0),
                Some(local) => {
                    let steps = local[axis].values().iter().map(|own| self.way.length() * own);
                    before.values_mut().iter_mut().zip(steps).for_each(|(to, step)| *to = step);
                }
            }
        }
    }

    /// Writes the displacements of the bodies.
    fn displace(&self, state: &mut ContactState) -> Result<(), RollingError> {
        let load = TractionField::full(
            state.traction_x.values(),
            state.traction_y.values(),
            state.pressure.values(),
        );
        let out = DisplacementField::tangential(
            state.displacement_x.values_mut(),
            state.displacement_y.values_mut(),
        );
        let operator = self.problem.operator();
        Ok(operator.apply(load, out, &mut operator.workspace())?)
    }
}

/// Solves for steady rolling at an approach or under a normal force, at given creepages, in steps
/// of this distance along +x. For many creepages of one contact use [`SteadyContact`].
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::friction::Friction;
/// use carom_rolling::{Creepage, roll_steadily};
/// use carom_solver::{ContactProblem, Driven, Gap};
/// let grid = Grid::new(14, 12, 0.2, 0.2)?;
/// let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
/// let body = Material::from_shear(1.0, 0.3)?;
/// let pair = MaterialPair::new(body, body)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3)?)?;
/// let at = |along| {
///     let creepage = Creepage { along, ..Creepage::default() };
///     roll_steadily(&problem, Driven::Load(2.0), grid.dx(), creepage)
/// };
/// let (some, all) = (at(0.05)?, at(1.0)?);
/// assert!(!some.slides && all.slides);
/// assert!((all.state.load().f_x / (0.3 * 2.0) - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`SteadyContact::new`] and [`SteadyContact::roll`].
pub fn roll_steadily(
    problem: &ContactProblem,
    normal: Driven,
    distance: f64,
    creepage: Creepage,
) -> Result<SteadyRolling, RollingError> {
    let mut contact = SteadyContact::new(problem, Way::new(distance)?)?;
    contact.roll(&RollingDrive::by_creepage(normal, creepage), &mut ())
}
