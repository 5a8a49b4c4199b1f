//! Drawn contact problems on grids: conditions of contact and friction in every cell, and the mirrored problem.

use carom_halfspace::Field;
use carom_laws::law::Shift;
use carom_solver::{
    CellState, ContactProblem, ContactState, Frictional, FrictionalScratch, Gap, Method as _,
    SurfaceFriction, dissipated, violations,
};

use crate::Done;
use crate::draw::of_case;
use crate::drawn::{Case, difference, step};
use crate::worst::Worst;

/// Allowed violations of the conditions, along the normal and in the plane.
const VIOLATION: [f64; 2] = [1e-8, 1e-7];
/// By how much a traction may exceed its limit, over the greatest pressure.
const EXCESS: f64 = 1e-7;
/// Allowed difference of the mirrored answer, over the greatest pressure: both are solved to a tolerance.
const UNLIKE: f64 = 1e-5;
/// By how much a cell may cool, of the work.
const COOLED: f64 = 1e-9;

pub(crate) fn run(count: u64, seed: u64) -> Done {
    let mut worst = Worst::default();
    for seed in seed..seed + count {
        check(seed, &mut worst).map_err(|error| format!("--seed {seed} --count 1: {error}"))?;
    }
    Ok(worst)
}

fn check(seed: u64, worst: &mut Worst) -> Result<(), String> {
    let case = Case::drawn(&mut of_case(seed)).ok_or("a drawn number is out of range")?;
    let mirrored = mirrored(&case).ok_or("a mirrored number is out of range")?;
    let (mut here, mut there) = (Solved::new(&case)?, Solved::new(&mirrored)?);
    for (own, other) in case.steps.iter().zip(&mirrored.steps) {
        let before = here.state.clone();
        here.step(&case, *own)?;
        let touching = here.state.count(CellState::Stick) + here.state.count(CellState::Slip);
        if touching > 0 {
            conditions(&here.problem, &before, &here.state, worst)?;
        }
        if !case.breaks {
            there.step(&mirrored, *other)?;
            let off = difference(&here.state, &image(&there.state).ok_or("no mirror image")?);
            worst.check("mirrored_off", off, UNLIKE)?;
        }
    }
    Ok(())
}

/// What holds in every cell after a step.
fn conditions(
    problem: &ContactProblem,
    before: &ContactState,
    after: &ContactState,
    worst: &mut Worst,
) -> Result<(), String> {
    let left = violations(problem, before, after).map_err(|error| error.to_string())?;
    worst.check("violation_normal", left.normal, VIOLATION[0])?;
    worst.check("violation_tangential", left.tangential, VIOLATION[1])?;
    let pressures = after.pressure.values();
    let top = pressures.iter().copied().fold(0.0, f64::max);
    let least = pressures.iter().copied().fold(f64::INFINITY, f64::min);
    worst.check("negative_pressure", -least, 0.0)?;
    let tractions = after.traction_x.values().iter().zip(after.traction_y.values());
    for (i, (p, (x, y))) in pressures.iter().zip(tractions).enumerate() {
        let f = problem.friction().at(i).rest().get();
        worst.check("traction_above_limit", (x.hypot(*y) - f * p) / top, EXCESS)?;
    }
    let heat = dissipated(before, after);
    let least = heat.values().iter().copied().fold(0.0, f64::min);
    let scale = after.load().f_z.abs() * after.shift.zeta.abs();
    worst.check("cooled", -least / scale.max(f64::MIN_POSITIVE), COOLED)
}

/// Pressures and tractions in the mirror: y changes its sign.
fn image(state: &ContactState) -> Option<ContactState> {
    let mut image = state.clone();
    image.pressure = flipped(&state.pressure)?;
    image.traction_x = flipped(&state.traction_x)?;
    image.traction_y = flipped(&state.traction_y)?;
    image.traction_y.values_mut().iter_mut().for_each(|traction| *traction = -*traction);
    Some(image)
}

/// A field with its rows in the other order.
fn flipped<T: Copy>(field: &Field<T>) -> Option<Field<T>> {
    let grid = field.grid();
    let rows = field.values().chunks_exact(grid.nx());
    Field::new(grid, rows.rev().flatten().copied().collect()).ok()
}

/// A problem, what its solution needs, and its present state.
struct Solved {
    problem: ContactProblem,
    scratch: FrictionalScratch,
    state: ContactState,
}

impl Solved {
    fn new(case: &Case) -> Result<Self, String> {
        let problem = case.problem().ok_or("no problem of these numbers")?;
        let scratch = Frictional::default().scratch(&problem).map_err(|error| error.to_string())?;
        let state = ContactState::apart(problem.grid());
        Ok(Self { problem, scratch, state })
    }

    fn step(&mut self, case: &Case, shift: Shift) -> Result<(), String> {
        let done = step(&self.problem, &mut self.scratch, &self.state, &case.drive(shift));
        self.state = done.map_err(|error| error.to_string())?;
        Ok(())
    }
}

/// The same in a mirror: y and the twist change their signs.
fn mirrored(case: &Case) -> Option<Case> {
    let friction = match &case.friction {
        SurfaceFriction::ByCell(field) => SurfaceFriction::ByCell(flipped(field)?),
        uniform => uniform.clone(),
    };
    let turned = |shift: &Shift| Shift { eta: -shift.eta, omega: -shift.omega, ..*shift };
    let gap = Gap::new(flipped(case.gap.heights())?).ok()?;
    let steps = case.steps.iter().map(turned).collect();
    Some(Case { gap, friction, steps, ..*case })
}
