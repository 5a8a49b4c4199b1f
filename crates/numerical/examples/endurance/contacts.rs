//! Drawn contact problems on grids: conditions of contact and friction in every cell, and the mirrored problem.

use std::sync::Arc;

use carom_drawn::{Draw as _, Splitmix};
use carom_halfspace::operator::{HalfSpaceOperator, PeriodicOperator, SurfaceOperator, Threads};
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellFriction, CellState, ContactProblem, ContactState, Drive, Driven, Frictional,
    FrictionalScratch, Gap, Method as _, SelfAffine, SurfaceFriction, dissipated, violations,
};

use crate::Done;
use crate::draw::of_case;
use crate::worst::Worst;

/// Allowed violations of the conditions, along the normal and in the plane.
const VIOLATION: [f64; 2] = [1e-8, 1e-7];
/// By how much a traction may exceed its limit, over the greatest pressure.
const EXCESS: f64 = 1e-7;
/// Allowed difference of the mirrored answer, over the greatest pressure: both are solved to a tolerance.
const UNLIKE: f64 = 1e-5;
/// By how much a cell may cool, of the work.
const COOLED: f64 = 1e-9;

/// A problem with its steps.
struct Case {
    pair: MaterialPair,
    gap: Gap,
    friction: SurfaceFriction,
    periodic: bool,
    /// Which cells change to kinetic friction depends on the path of the solution.
    breaks: bool,
    steps: Vec<Shift>,
}

pub(crate) fn run(count: u64, seed: u64) -> Done {
    let mut worst = Worst::default();
    for seed in seed..seed + count {
        check(seed, &mut worst).map_err(|error| format!("--seed {seed} --count 1: {error}"))?;
    }
    Ok(worst)
}

fn check(seed: u64, worst: &mut Worst) -> Result<(), String> {
    let case = Case::drawn(&mut of_case(seed)).ok_or("a drawn number is out of range")?;
    let mirrored = case.mirrored().ok_or("a mirrored number is out of range")?;
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
            let off = difference(&here.state, &there.state);
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

/// The greatest difference of a state from the mirror image of another, over the greatest pressure.
fn difference(own: &ContactState, other: &ContactState) -> f64 {
    let top = own.pressure.values().iter().copied().fold(0.0, f64::max);
    let parts = [
        (&own.pressure, &other.pressure, 1.0),
        (&own.traction_x, &other.traction_x, 1.0),
        (&own.traction_y, &other.traction_y, -1.0),
    ];
    let of = |(own, other, sign): (&Field, &Field, f64)| {
        let other = flipped(other).unwrap_or_else(|| other.clone());
        let pairs = own.values().iter().zip(other.values());
        pairs.fold(0.0, |most: f64, (a, b)| most.max((a - sign * b).abs()))
    };
    parts.into_iter().map(of).fold(0.0, f64::max) / top.max(f64::MIN_POSITIVE)
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
        let (from, drive) = (self.state.clone(), case.drive(shift));
        let (to, scratch) = (&mut self.state, &mut self.scratch);
        let done = Frictional::default().step(&self.problem, &from, &drive, to, scratch, &mut ());
        done.map(|_| ()).map_err(|error| error.to_string())
    }
}

impl Case {
    fn drawn(draw: &mut Splitmix) -> Option<Self> {
        let periodic = draw.part() < 0.2;
        let [nx, ny] = [(); 2].map(|()| 2 * draw.between(8.0, 26.0) as usize);
        let (nx, ny) = if periodic { (nx, ny) } else { (nx + 1, ny) };
        let grid = Grid::new(nx, ny, 2.2 / nx as f64, 2.2 / ny as f64).ok()?;
        let pair = pair(draw)?;
        let gap = gap(draw, grid)?;
        let (friction, breaks) = friction(draw, grid)?;
        let size = draw.pick(&[0.01, 0.1, 0.4]);
        let count = 1 + draw.between(0.0, 5.0) as usize;
        let steps = (0..count).map(|_| shift(draw, size, periodic)).collect();
        Some(Self { pair, gap, friction, periodic, breaks, steps })
    }

    /// The same in a mirror: y and the twist change their signs.
    fn mirrored(&self) -> Option<Self> {
        let friction = match &self.friction {
            SurfaceFriction::ByCell(field) => SurfaceFriction::ByCell(flipped(field)?),
            uniform => uniform.clone(),
        };
        let turned = |shift: &Shift| Shift { eta: -shift.eta, omega: -shift.omega, ..*shift };
        let gap = Gap::new(flipped(self.gap.heights())?).ok()?;
        let steps = self.steps.iter().map(turned).collect();
        Some(Self { gap, friction, steps, ..*self })
    }

    fn problem(&self) -> Option<ContactProblem> {
        let grid = self.gap.grid();
        let operator: Arc<dyn SurfaceOperator> = match self.periodic {
            true => Arc::new(PeriodicOperator::new(self.pair, grid, Threads::One).ok()?),
            false => Arc::new(HalfSpaceOperator::new(self.pair, grid).ok()?),
        };
        ContactProblem::new(self.gap.clone(), operator, self.friction.clone()).ok()
    }

    /// On a period the approach is measured from the mean plane, and no force makes it exceed all heights: the normal
    /// motion is driven by a force.
    fn drive(&self, shift: Shift) -> Drive {
        let drive = Drive::by_shift(shift);
        let force = Driven::Load(shift.zeta.max(0.0));
        if self.periodic { Drive { normal: force, ..drive } } else { drive }
    }
}

fn pair(draw: &mut Splitmix) -> Option<MaterialPair> {
    let poisson = [(); 2].map(|()| draw.between(-0.3, 0.5));
    let shear = [(); 2].map(|()| draw.pick(&[1.0, 1.0, 5.0, 100.0]));
    let body = |i: usize| Material::from_shear(shear[i], poisson[i]);
    let one = body(0).ok()?;
    let two = match draw.pick(&[0, 1, 2]) {
        0 => one,
        1 => Material::RIGID,
        _ => body(1).ok()?,
    };
    MaterialPair::new(one, two).ok()
}

fn gap(draw: &mut Splitmix, grid: Grid) -> Option<Gap> {
    let [a, b] = [(); 2].map(|()| draw.between(0.2, 2.0));
    let [x0, y0] = [(); 2].map(|()| draw.between(-0.3, 0.3));
    let from = |height: &dyn Fn(f64, f64) -> f64| {
        Gap::from_function(grid, |x, y| height(x - x0, y - y0)).ok()
    };
    match draw.pick(&[0, 1, 2, 3, 4, 5]) {
        0 => from(&|x, y| a * x * x + b * y * y),
        1 => from(&|x, y| a * x.hypot(y)),
        2 => from(&|x, y| if x.abs().max(y.abs()) < 0.5 { 0.0 } else { f64::INFINITY }),
        3 => from(&|x, y| (1.0 - libm::cos(3.0 * x) * libm::cos(2.0 * y)) * 0.2 + 0.1 * a * x * x),
        4 => from(&|x, y| {
            let [one, two] = [x - 0.4, x + 0.5];
            (a * one * one + y * y).min(b * two * two + 2.0 * y * y + 0.1)
        }),
        _ => {
            let shortest = 4.0 * grid.dx().max(grid.dy());
            let seed = draw.bits() >> 40;
            SelfAffine { hurst: 0.8, rms: 0.1, longest: 2.0, shortest, seed }.gap(grid).ok()
        }
    }
}

/// Friction, and whether static friction exceeds kinetic friction.
fn friction(draw: &mut Splitmix, grid: Grid) -> Option<(SurfaceFriction, bool)> {
    let f = |value: f64| Friction::new(value).ok();
    let kinetic = draw.pick(&[0.05, 0.2, 0.5, 1.0]);
    match draw.pick(&[0, 1, 2, 3]) {
        0 => {
            let cell = |_| {
                let one = f(draw.pick(&[0.0, 0.1, 0.3, 0.8]))?;
                CellFriction::new(one, one).ok()
            };
            let cells = (0..grid.cells()).map(cell).collect::<Option<_>>()?;
            Some((Field::new(grid, cells).ok()?.into(), false))
        }
        1 => Some((CellFriction::new(f(1.4 * kinetic)?, f(kinetic)?).ok()?.into(), true)),
        _ => Some((f(kinetic)?.into(), false)),
    }
}

fn shift(draw: &mut Splitmix, size: f64, periodic: bool) -> Shift {
    let mut tangential = || draw.pick(&[0.0, 1.0, 1.0]) * draw.between(-size, size);
    let [xi, eta, omega] = [tangential(), tangential(), tangential()];
    let omega = if periodic { 0.0 } else { omega };
    let drawn = draw.between(0.1, 0.6);
    let zeta = draw.pick(&[drawn, 0.3, -0.1, 0.5]);
    Shift { zeta, xi, eta, omega }
}
