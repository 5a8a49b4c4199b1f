//! Contact with Coulomb's friction: normal and tangential problem in turn.

use carom_halfspace::operator::{DisplacementField, OperatorError, TractionField, Workspace};
use carom_laws::law::Shift;
use carom_special::RangeError;

use crate::anderson::Mixing;
use crate::convergence::{Convergence, Observer, Products, Residuals, Stop};
use crate::coupled::{Coupled, CoupledTask};
use crate::drive::{Drive, Driven};
use crate::limits::FrictionLimits;
use crate::method::Method;
use crate::normal::{NormalGrids, Target};
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};
use crate::tangential::{Rigid, TangentialScratch, TangentialTask};

/// Up to this relative change of approach or force, pressures start from the last ones.
const SMALL_STEP: f64 = 0.1;

/// Passes that may go by before the least change is halved.
const PATIENCE: usize = 40;
/// Up to this over gamma friction is taken as it is.
const STRONG: f64 = 4.0;
/// Rounds of a cone that opens; how many lie between trials of Newton's method, unless limits are
/// off by less than this part of the greatest traction.
const ROUNDS: usize = 100;
const ROUNDS_A_TRIAL: usize = 4;
const CLOSE: f64 = 0.05;
/// Passes that change the displacements by more than this part of the last change are mixed.
const SLOW: f64 = 0.25;

/// Contact with Coulomb's friction, one step at a time: pressures at the last tractions, tractions
/// at these pressures, and so on (Panagiotopoulos) until the pressures stand; one pass where the
/// materials are not coupled. Pressures come from preconditioned conjugate gradients on an active
/// set, tractions from Newton's method on sets of sticking and slipping cells; both start from
/// coarser grids where nothing better is known.
///
/// Each of the four motions is driven by its shift or by its load.
///
/// Where static friction is above the kinetic one, a cell sticks up to `f_s p`; once it slips its
/// limit is `f_k p`, within the step at once and in later steps for as long as it slips. A step
/// without slip heals it. Cells break in turn until none is at its static limit: what each of them
/// lets go loads its neighbours. No length comes with this law, so that tractions at the tip of the
/// slipping area are singular without bound and the static friction matters less on each finer grid.
/// In Cattaneo's problem with `f_s = 1.5 f_k` the tangential force exceeds that of kinetic friction
/// alone by 0.21, 0.13, 0.056, 0.028 % of the normal force on 16, 32, 64, 128 cells a side: in
/// proportion to their width. What depends on the difference belongs to its grid.
///
/// ```
/// use carom_halfspace::{Grid, Material, MaterialPair};
/// use carom_laws::{curvature::RelativeCurvature, friction::Friction, law::Shift};
/// use carom_solver::{CellState, ContactProblem, ContactState, Drive, Frictional, Gap, Method};
/// let grid = Grid::new(48, 48, 0.05, 0.05)?;
/// let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(0.5, 0.5)?);
/// let body = Material::from_shear(1.0, 0.0)?;
/// let pair = MaterialPair::new(body, body)?;
/// let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.4)?)?;
/// let method = Frictional::default();
/// let mut scratch = method.scratch(&problem)?;
/// let mut pressed = ContactState::apart(grid);
/// let mut shifted = pressed.clone();
/// let to = |xi| Drive::by_shift(Shift { zeta: 1.0, xi, ..Shift::default() });
/// method.step(&problem, &pressed.clone(), &to(0.0), &mut pressed, &mut scratch, &mut ())?;
/// // Cattaneo: at xi = f zeta/2 and nu = 0 the stick area has half the depth, F_x/(f F_z) = 1 - 2^(-3/2).
/// method.step(&problem, &pressed, &to(0.2), &mut shifted, &mut scratch, &mut ())?;
/// let load = shifted.load();
/// assert!((load.f_x / (0.4 * load.f_z) - (1.0 - 0.5_f64.powf(1.5))).abs() < 3e-3);
/// assert!(shifted.count(CellState::Slip) > 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frictional {
    tolerance: f64,
    iterations: usize,
    passes: usize,
}

/// Why a step with friction failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FrictionalError {
    /// A value out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The operator failed.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// A tangential force is given that friction cannot hold: the bodies slide.
    #[error(
        "the tangential force {force} is not below what friction can hold, {limit}: the bodies slide"
    )]
    Slides {
        /// The force.
        force: f64,
        /// The friction limit, the sum of f p.
        limit: f64,
    },
    /// Iterations ended before the tolerance was reached.
    #[error(
        "the {what} are not found within {tolerance:.1e}: {:.1e} (normal), {:.1e} (tangential) after \
         {} iterations ({:?})",
        .reached.residuals.normal, .reached.residuals.tangential, .reached.iterations, .reached.stop
    )]
    NotConverged {
        /// Pressures, tractions, or both together.
        what: &'static str,
        /// The tolerance.
        tolerance: f64,
        /// How far it got.
        reached: Convergence,
    },
}

impl Default for Frictional {
    /// To 1e-9 of the greatest displacement and of the greatest friction limit.
    fn default() -> Self {
        Self { tolerance: 1e-9, iterations: 1000, passes: 300 }
    }
}

impl Frictional {
    /// To another tolerance: violations of the normal conditions over the greatest displacement, and
    /// of the friction law over the greatest friction limit.
    ///
    /// # Errors
    /// [`RangeError`] unless it lies in 1e-13 to 0.01.
    pub fn within(self, tolerance: f64) -> Result<Self, RangeError> {
        let holds = (1e-13..=0.01).contains(&tolerance);
        RangeError::check("tolerance", tolerance, holds, "from 1e-13 to 0.01")?;
        Ok(Self { tolerance, ..self })
    }

    /// With at most as many iterations of each problem on each grid, and as many passes.
    #[must_use]
    pub const fn at_most(self, iterations: usize, passes: usize) -> Self {
        Self { iterations, passes, ..self }
    }
}

/// The working memory of [`Frictional`].
#[derive(Clone)]
pub struct FrictionalScratch {
    normal: NormalGrids,
    tangential: TangentialScratch,
    workspace: Workspace,
    limits: FrictionLimits,
    /// The tangential displacement by pressure.
    by_pressure: [Vec<f64>; 2],
    offset: [Vec<f64>; 2],
    /// The normal displacement by tangential tractions, of this pass and the last one.
    by_traction: Vec<f64>,
    last: Vec<f64>,
    mixing: Mixing,
    /// Cells that have slipped since they last stuck.
    broken: Vec<bool>,
    /// Pressures and tractions together, built when it is first needed.
    coupled: Option<Box<Coupled>>,
}

impl Method for Frictional {
    type Error = FrictionalError;
    type Scratch = FrictionalScratch;

    fn scratch(&self, problem: &ContactProblem) -> Result<FrictionalScratch, FrictionalError> {
        let operator = problem.operator();
        let zero = vec![0.0; problem.grid().cells()];
        Ok(FrictionalScratch {
            normal: NormalGrids::new(operator, problem.gap().heights().values())?,
            tangential: TangentialScratch::new(operator)?,
            workspace: operator.workspace(),
            limits: FrictionLimits::new(zero.len()),
            by_pressure: [zero.clone(), zero.clone()],
            offset: [zero.clone(), zero.clone()],
            by_traction: zero.clone(),
            last: zero,
            mixing: Mixing::default(),
            broken: vec![false; problem.grid().cells()],
            coupled: None,
        })
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, FrictionalError> {
        drive.check()?;
        from.check_grid(problem.grid())?;
        if let Some(zeta) = problem.apart(drive.normal) {
            if let Some(force) = tangential_load(drive) {
                return Err(FrictionalError::Slides { force, limit: 0.0 });
            }
            *to = ContactState::apart(problem.grid());
            to.shift = Shift { zeta, ..drive.shift_after(from.shift) };
            let (products, residuals) = Default::default();
            return Ok(Convergence { iterations: 0, products, residuals, stop: Stop::Converged });
        }
        let area = problem.grid().cell_area();
        let load = |driven| match driven {
            Driven::Shift(_) => None,
            Driven::Load(load) => Some(load / area),
        };
        let loads = [load(drive.x), load(drive.y), load(drive.twist)];
        let (spent, rigid) = (Products::default(), Rigid { loads, ..Rigid::default() });
        let together = false;
        let mut pass =
            Pass { method: self, problem, from, drive, rigid, observer, spent, together };
        pass.until_no_cell_breaks(to, scratch)
    }
}

/// The greatest given load along the surface, if any is not zero.
fn tangential_load(drive: &Drive) -> Option<f64> {
    let loads = [drive.x, drive.y, drive.twist].into_iter().filter_map(|driven| match driven {
        Driven::Load(load) if load != 0.0 => Some(load.abs()),
        _ => None,
    });
    loads.reduce(f64::max)
}

/// What to go back to: rigid shifts, state, normal displacement by tractions.
type Kept = (Rigid, ContactState, Vec<f64>);

/// One step of a history.
struct Pass<'a> {
    method: &'a Frictional,
    problem: &'a ContactProblem,
    from: &'a ContactState,
    drive: &'a Drive,
    rigid: Rigid,
    observer: &'a mut dyn Observer,
    spent: Products,
    /// Whether pressures and tractions were found together.
    together: bool,
}

impl Pass<'_> {
    /// Cells that begin to slip at static friction go on at kinetic friction, which may make others
    /// slip.
    fn until_no_cell_breaks(
        &mut self,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        to.clone_from(self.from);
        for (broken, cell) in scratch.broken.iter_mut().zip(self.from.cells.values()) {
            *broken = *cell == CellState::Slip;
        }
        scratch.by_traction.fill(0.0);
        if self.problem.operator().is_coupled() {
            self.displace_by_traction(to, scratch)?;
        }
        let mut went = self.settle(true, to, scratch)?;
        while self.break_cells(to, scratch) {
            let more = self.settle(false, to, scratch)?;
            went = Convergence { iterations: went.iterations + more.iterations, ..more };
        }
        self.finish(to, scratch);
        Ok(went)
    }

    /// Whether any cell slips that did not before, where that lessens its friction.
    fn break_cells(&self, to: &ContactState, scratch: &mut FrictionalScratch) -> bool {
        let mut any = false;
        for (i, (broken, cell)) in scratch.broken.iter_mut().zip(to.cells.values()).enumerate() {
            let friction = self.problem.friction().at(i);
            let breaks = !*broken && *cell == CellState::Slip;
            any |= breaks && friction.rest() > friction.motion();
            *broken |= breaks;
        }
        any
    }

    fn until_the_pressures_stand(
        &mut self,
        fresh: bool,
        tolerance: f64,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        let coupled = self.problem.operator().is_coupled();
        let mut inner = if coupled { 1e-3_f64.max(0.3 * tolerance) } else { tolerance };
        let (mut iterations, mut last_change, mut mixes) = (0, f64::INFINITY, false);
        let mut least = (0, f64::INFINITY);
        scratch.mixing.clear();
        for pass in 1..=self.method.passes {
            let first = fresh && pass == 1;
            let normal_part = self.press(inner, first, to, scratch)?;
            let tangential_part = self.rub(inner, first, to, scratch)?;
            iterations += normal_part.iterations + tangential_part.iterations;
            let change = if coupled { self.change(to, scratch)? } else { 0.0 };
            let residuals = Residuals {
                normal: normal_part.residuals.normal.max(change),
                tangential: tangential_part.residuals.tangential,
            };
            if change <= tolerance && inner <= tolerance {
                let (products, stop) = (self.spent, Stop::Converged);
                return Ok(Convergence { iterations, products, residuals, stop });
            }
            if change < 0.5 * least.1 {
                least = (pass, change);
            }
            let stalls = !change.is_finite() || pass > least.0 + PATIENCE;
            if stalls || pass == self.method.passes {
                let stop = if stalls { Stop::Stalled } else { Stop::Exhausted };
                let products = self.spent;
                let reached = Convergence { iterations, products, residuals, stop };
                let what = "pressures and tractions together";
                return Err(FrictionalError::NotConverged { what, tolerance, reached });
            }
            mixes |= pass > 1 && change > SLOW * last_change;
            last_change = change;
            if mixes {
                scratch.mixing.mix(&scratch.last, &mut scratch.by_traction);
            }
            inner = (0.1 * change).clamp(0.3 * tolerance, 1e-3_f64.max(0.3 * tolerance));
        }
        Err(RangeError::new("passes", 0.0, "at least 1").into())
    }

    /// Pressures and tractions in equilibrium.
    fn settle(
        &mut self,
        fresh: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        for (i, (own, slides)) in
            scratch.limits.friction.iter_mut().zip(&scratch.broken).enumerate()
        {
            let friction = self.problem.friction().at(i);
            *own = if *slides { friction.motion() } else { friction.rest() }.get();
        }
        scratch.limits.sharpen();
        self.together = false;
        let tolerance = self.method.tolerance;
        if !self.problem.operator().is_coupled() {
            return self.until_the_pressures_stand(fresh, tolerance, to, scratch);
        }
        let (greatest, strong) = (scratch.limits.greatest_friction(), STRONG / self.gamma());
        if greatest <= strong {
            let start = self.keep(to, scratch);
            match self.until_the_pressures_stand(fresh, tolerance, to, scratch) {
                Err(FrictionalError::NotConverged { .. }) => self.go_back(start, to, scratch),
                done => return done,
            }
        }
        self.open_the_cone(strong.min(0.5 * greatest), fresh, to, scratch)
    }

    /// The coupling of pressures and tractions over the compliance.
    fn gamma(&self) -> f64 {
        let [x, _, z] = self.problem.operator().coefficients(1, 0).rows[2];
        if x == 0.0 { 0.0 } else { (x / z).abs() }
    }

    fn keep(&self, to: &ContactState, scratch: &FrictionalScratch) -> Kept {
        (self.rigid, to.clone(), scratch.by_traction.clone())
    }

    fn go_back(&mut self, kept: Kept, to: &mut ContactState, scratch: &mut FrictionalScratch) {
        (self.rigid, *to, scratch.by_traction) = kept;
    }

    /// Rounds with a blunter cone, no greater a coefficient than `most`, beside cohesion that follows;
    /// now and then Newton's method is tried from there.
    fn open_the_cone(
        &mut self,
        mut most: f64,
        fresh: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        let (least, mut change) = (0.05 * most, 1.0_f64);
        let (what, tolerance) = ("pressures and tractions together", self.method.tolerance);
        scratch.limits.blunt(most);
        let mut round = 0;
        loop {
            let kept = self.keep(to, scratch);
            let inner = (1e-2 * change).clamp(1e-5, 1e-3).max(tolerance);
            let reached =
                match self.until_the_pressures_stand(fresh && round == 0, inner, to, scratch) {
                    Err(FrictionalError::NotConverged { .. }) if most > least => {
                        self.go_back(kept, to, scratch);
                        most *= 0.5;
                        scratch.limits.blunt(most);
                        continue;
                    }
                    done => done?,
                };
            round += 1;
            change = scratch.limits.open(to);
            if change < CLOSE || round % ROUNDS_A_TRIAL == 0 {
                let kept = self.keep(to, scratch);
                if let Some(reached) = self.solve_together(to, scratch)? {
                    self.together = true;
                    return Ok(Convergence { products: self.spent, ..reached });
                }
                self.go_back(kept, to, scratch);
            }
            if round == ROUNDS || change.is_nan() {
                let (products, stop) = (self.spent, Stop::Exhausted);
                let reached = Convergence { products, stop, ..reached };
                return Err(FrictionalError::NotConverged { what, tolerance, reached });
            }
        }
    }

    /// Pressures and tractions by one system, from what they are; none if that does not converge,
    /// and they are as they were.
    fn solve_together(
        &mut self,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Option<Convergence>, FrictionalError> {
        let (operator, start) = (self.problem.operator(), to.clone());
        for values in &mut scratch.by_pressure {
            values.fill(0.0);
        }
        self.offsets(scratch);
        let solver = scratch.coupled.get_or_insert_with(|| Box::new(Coupled::new(operator)));
        let [x, y] = &scratch.offset;
        let mut task = CoupledTask {
            operator,
            heights: self.problem.gap().heights().values(),
            friction: &scratch.limits.friction,
            offset: [x, y],
            normal: self.drive.normal,
            approach: to.shift.zeta,
            rigid: self.rigid,
            pressure: to.pressure.values_mut(),
            traction: [to.traction_x.values_mut(), to.traction_y.values_mut()],
            cells: to.cells.values_mut(),
        };
        let (tolerance, most) = (self.method.tolerance, self.method.iterations);
        let reached = solver.solve(&mut task, tolerance, most, self.observer)?;
        self.spent = self.spent.plus(reached.products);
        if reached.stop == Stop::Converged {
            (to.shift.zeta, self.rigid) = (task.approach, task.rigid);
            return Ok(Some(reached));
        }
        *to = start;
        Ok(None)
    }

    /// Whether the last pressures are a better start than coarse grids.
    fn is_small_step(&self) -> bool {
        let (last, next) = match self.drive.normal {
            Driven::Shift(approach) => (self.from.shift.zeta, approach),
            Driven::Load(force) => (self.from.load().f_z, force),
        };
        (next - last).abs() <= SMALL_STEP * last.abs()
            && self.from.pressure.values().iter().any(|pressure| *pressure > 0.0)
    }

    fn press(
        &mut self,
        tolerance: f64,
        first: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        let (operator, driven) = (self.problem.operator(), self.drive.normal);
        let heights = self.problem.gap().heights().values();
        for ((own, height), w) in
            scratch.normal.heights_mut().iter_mut().zip(heights).zip(&scratch.by_traction)
        {
            *own = height + w;
        }
        let target = Target { tolerance, iterations: self.method.iterations };
        if first && self.is_small_step() {
            scratch.normal.start_from(self.from.pressure.values());
        } else if first {
            self.spent = self.spent.plus(scratch.normal.start(operator, driven, target)?);
        }
        let (approach, reached) = scratch.normal.solve(operator, driven, target, self.observer)?;
        self.spent = self.spent.plus(reached.products);
        to.shift.zeta = approach;
        to.pressure.values_mut().copy_from_slice(scratch.normal.pressure());
        converged("pressures", tolerance, reached)
    }

    fn rub(
        &mut self,
        tolerance: f64,
        first: bool,
        to: &mut ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<Convergence, FrictionalError> {
        let operator = self.problem.operator();
        if operator.is_coupled() {
            let [u, v] = &mut scratch.by_pressure;
            let load = TractionField::normal(to.pressure.values());
            operator.apply(load, DisplacementField::tangential(u, v), &mut scratch.workspace)?;
            self.spent.coupling += 1.0;
        }
        let own = operator.coefficients(0, 0).rows[2][2];
        scratch.limits.follow(&to.pressure, scratch.normal.gap(), own);
        self.refuse_sliding(scratch)?;
        self.offsets(scratch);
        let [x, y] = &scratch.offset;
        let mut task = TangentialTask {
            operator,
            limits: &scratch.limits.values,
            offset: [x, y],
            rigid: self.rigid,
            traction: [to.traction_x.values_mut(), to.traction_y.values_mut()],
            cells: to.cells.values_mut(),
        };
        let iterations = self.method.iterations;
        let fresh = task.traction.iter().all(|values| values.iter().all(|t| *t == 0.0));
        if first && fresh {
            let started = scratch.tangential.start(&mut task, tolerance, iterations)?;
            self.spent = self.spent.plus(started);
        }
        let reached = scratch.tangential.solve(&mut task, tolerance, iterations, self.observer)?;
        self.spent = self.spent.plus(reached.products);
        self.rigid = task.rigid;
        converged("tractions", tolerance, reached)
    }

    /// A given force that friction cannot hold has no equilibrium.
    fn refuse_sliding(&self, scratch: &FrictionalScratch) -> Result<(), FrictionalError> {
        let [x, y, _] = self.rigid.loads.map(Option::unwrap_or_default);
        let (force, limit) = (x.hypot(y), scratch.limits.values.iter().sum::<f64>());
        if force > 0.0 && force >= limit {
            let area = self.problem.grid().cell_area();
            return Err(FrictionalError::Slides { force: area * force, limit: area * limit });
        }
        Ok(())
    }

    /// c: displacements by the pressure, less the last ones and the rigid shift of the step.
    fn offsets(&self, scratch: &mut FrictionalScratch) {
        let [dx, dy, turn] = self.moved();
        let before = [self.from.displacement_x.values(), self.from.displacement_y.values()];
        for (i, (x, y)) in self.problem.grid().centres().enumerate() {
            let rigid = [dx + y * turn, dy - x * turn]; // (12.2)
            for axis in 0..2 {
                scratch.offset[axis][i] =
                    scratch.by_pressure[axis][i] - before[axis][i] - rigid[axis];
            }
        }
    }

    /// The given rigid shifts and twist of the step; zero where the load is given.
    fn moved(&self) -> [f64; 3] {
        let (now, before) = (self.drive.shift_after(self.from.shift), self.from.shift);
        [now.xi - before.xi, now.eta - before.eta, now.omega - before.omega]
    }

    /// How much the tangential tractions changed the normal displacement since the pressures were
    /// found, over the approach.
    fn change(
        &mut self,
        to: &ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<f64, FrictionalError> {
        std::mem::swap(&mut scratch.by_traction, &mut scratch.last);
        self.displace_by_traction(to, scratch)?;
        let heights = self.problem.gap().heights().values();
        let (mut moved, mut scale) = (0.0_f64, 0.0_f64);
        for (i, pressure) in to.pressure.values().iter().enumerate().filter(|(_, p)| **p > 0.0) {
            let change = (scratch.by_traction[i] - scratch.last[i]).abs();
            if change.is_nan() || pressure.is_nan() {
                return Ok(f64::NAN);
            }
            moved = moved.max(change);
            scale = scale.max((to.shift.zeta - heights[i]).abs());
        }
        Ok(if scale > 0.0 { moved / scale } else { moved })
    }

    fn displace_by_traction(
        &mut self,
        to: &ContactState,
        scratch: &mut FrictionalScratch,
    ) -> Result<(), FrictionalError> {
        let load = TractionField::tangential(to.traction_x.values(), to.traction_y.values());
        let displacement = DisplacementField::normal(&mut scratch.by_traction);
        self.problem.operator().apply(load, displacement, &mut scratch.workspace)?;
        self.spent.coupling += 1.0;
        Ok(())
    }

    /// Shifts, and displacements of all cells: the slip, the last ones and the rigid shift of the
    /// step. Cells that touch without friction slip.
    fn finish(&self, to: &mut ContactState, scratch: &FrictionalScratch) {
        let given = self.drive.shift_after(self.from.shift);
        let [dx, dy, turn] = self.rigid.moved;
        to.shift = Shift {
            zeta: to.shift.zeta,
            xi: given.xi + dx,
            eta: given.eta + dy,
            omega: given.omega + turn,
        };
        let slip = match &scratch.coupled {
            Some(coupled) if self.together => coupled.slip(),
            _ => scratch.tangential.slip(),
        };
        let [all_x, all_y, all_turn] = self.moved();
        let [dx, dy, turn] = [all_x + dx, all_y + dy, all_turn + turn];
        let before = [self.from.displacement_x.values(), self.from.displacement_y.values()];
        let (u, v) = (to.displacement_x.values_mut(), to.displacement_y.values_mut());
        for (i, (x, y)) in self.problem.grid().centres().enumerate() {
            u[i] = slip[0][i] + before[0][i] + dx + y * turn; // (12.2)
            v[i] = slip[1][i] + before[1][i] + dy - x * turn;
        }
        for ((cell, pressure), friction) in
            to.cells.values_mut().iter_mut().zip(to.pressure.values()).zip(&scratch.limits.friction)
        {
            if *pressure > 0.0 && *friction == 0.0 {
                *cell = CellState::Slip;
            }
        }
    }
}

fn converged(
    what: &'static str,
    tolerance: f64,
    reached: Convergence,
) -> Result<Convergence, FrictionalError> {
    if reached.stop == Stop::Converged {
        Ok(reached)
    } else {
        Err(FrictionalError::NotConverged { what, tolerance, reached })
    }
}
