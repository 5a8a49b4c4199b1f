//! One contact, set-up and solution timed separately: `one_contact CASE CELLS TOLERANCE` prints a line of
//! JSON. `peers/rounds.py` runs it beside other programs.
//!
//! hertz_force, hertz_approach: a paraboloid of R = 100 on an equal one, a = 1, in a window of 2.4.
//! cattaneo: the same with f = 0.4, nu = 0, by force, then shifted to half of the stick radius;
//! cattaneo_nu: nu = 0.28. history: an ellipse of 40 x 10 cells between dissimilar bodies, pressed and
//! shifted in 39 increments, with the friction instead of the number of cells. loop: a sphere pressed by a
//! force and shifted to and fro in 19 further steps, nu = 0.28; loop_finely: the first tenth of it.
//! rough: the surface that `peers/rough.py` has written to the folder CAROM_ROUGH, pressed by a force; pressures are
//! written beside it. certified, certified_periodic: the same, with the certificate instead of the pressures.
//! product: the least time of one product of all pressures, of both tangential tractions, and of the inverses.
//! CAROM_THREADS=2 uses two threads.

use std::fs::File;
use std::io::{BufReader, BufWriter, Read as _, Write as _};
use std::sync::Arc;
use std::time::Instant;

use carom_halfspace::operator::{
    Blocks, DisplacementField, HalfSpaceOperator, OperatorError, PeriodicOperator, SurfaceOperator,
    Threads, TractionField,
};
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellState, ContactProblem, ContactState, Convergence, Drive, Driven, Frictional, Frictionless,
    Gap, Method, Products, Shape, StepSummary,
};

const RADIUS: f64 = 100.0;
const SHEAR: f64 = 80_000.0;
const FRICTION: f64 = 0.4;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [case, number, tolerance] = &arguments[..] else {
        return Err("give a case, a number of cells (or a friction) and a tolerance".into());
    };
    let tolerance: f64 = tolerance.parse()?;
    let threads = std::env::var("CAROM_THREADS").map_or(Ok(1), |number| number.parse())?;
    rayon::ThreadPoolBuilder::new().num_threads(threads).build_global()?;
    match case.as_str() {
        "hertz_force" | "hertz_approach" => {
            hertz(case == "hertz_force", number.parse()?, tolerance)
        }
        "cattaneo" => cattaneo(0.0, number.parse()?, tolerance),
        "cattaneo_nu" => cattaneo(0.28, number.parse()?, tolerance),
        "history" => history(number.parse()?, tolerance),
        "loop" => shift_to_and_fro(number.parse()?, 19, tolerance),
        "rough" => rough(number.parse()?, tolerance),
        "certified" => certified(number.parse()?, tolerance, &half_space),
        "certified_periodic" => certified(number.parse()?, tolerance, &periodic),
        "product" => product(number.parse()?),
        "loop_finely" => shift_to_and_fro(number.parse()?, 190, tolerance),
        _ => Err(format!("no case {case}").into()),
    }
}

/// Force and approach of Hertz for a = 1.
fn exact(poisson: f64) -> [f64; 2] {
    [4.0 / 3.0 * SHEAR / (1.0 - poisson) / RADIUS, 1.0 / RADIUS]
}

fn ball(
    cells: usize,
    poisson: f64,
    friction: f64,
    blocks: Blocks,
) -> Result<ContactProblem, Failure> {
    let grid = Grid::new(cells, cells, 2.4 / cells as f64, 2.4 / cells as f64)?;
    let body = Material::from_shear(SHEAR, poisson)?;
    let pair = MaterialPair::new(body, body)?;
    let gap = Gap::of_shape(grid, &Shape::Paraboloid { radii: [RADIUS; 2] })?;
    let operator = HalfSpaceOperator::with_blocks(pair, grid, blocks, threads())?;
    Ok(ContactProblem::new(gap, Arc::new(operator), Friction::new(friction)?)?)
}

fn hertz(by_force: bool, cells: usize, tolerance: f64) -> Result<(), Failure> {
    let [force, approach] = exact(0.3);
    let begin = Instant::now();
    let problem = ball(cells, 0.3, 0.0, Blocks::Normal)?;
    let method = Frictionless::default().within(tolerance)?;
    let mut scratch = method.scratch(&problem)?;
    let set_up = begin.elapsed().as_secs_f64();
    let normal = if by_force { Driven::Load(force) } else { Driven::Shift(approach) };
    let drive = Drive { normal, ..Drive::default() };
    let (apart, begin) = (ContactState::apart(problem.grid()), Instant::now());
    let mut state = apart.clone();
    let went = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
    let solve = begin.elapsed().as_secs_f64();
    let error =
        if by_force { state.shift.zeta / approach - 1.0 } else { state.load().f_z / force - 1.0 };
    tell([set_up, solve], went.products, error);
    Ok(())
}

/// What makes the operator of a rough surface.
type Make<'a> = &'a dyn Fn(MaterialPair, Grid) -> Result<Arc<dyn SurfaceOperator>, OperatorError>;

fn threads() -> Threads {
    if rayon::current_num_threads() > 1 { Threads::Pool } else { Threads::One }
}

fn half_space(pair: MaterialPair, grid: Grid) -> Result<Arc<dyn SurfaceOperator>, OperatorError> {
    Ok(Arc::new(HalfSpaceOperator::with_blocks(pair, grid, Blocks::Normal, threads())?))
}

fn periodic(pair: MaterialPair, grid: Grid) -> Result<Arc<dyn SurfaceOperator>, OperatorError> {
    Ok(Arc::new(PeriodicOperator::with_blocks(pair, grid, Blocks::Normal, threads())?))
}

/// A rough surface that was pressed, before and after, with the times of set-up and solution.
struct Rough {
    problem: ContactProblem,
    states: [ContactState; 2],
    went: Convergence,
    times: [f64; 2],
}

impl Rough {
    fn new(cells: usize, tolerance: f64, make: Make<'_>) -> Result<Self, Failure> {
        let (side, modulus) = (2.4, SHEAR / 0.7);
        let grid = Grid::new(cells, cells, side / cells as f64, side / cells as f64)?;
        let path = format!("{}/rough{cells}.f64", std::env::var("CAROM_ROUGH")?);
        let (mut file, mut bytes) = (BufReader::new(File::open(path)?), [0; 8]);
        let mut heights = Vec::with_capacity(grid.cells());
        for _ in 0..grid.cells() {
            file.read_exact(&mut bytes)?;
            heights.push(f64::from_le_bytes(bytes));
        }
        let begin = Instant::now();
        let body = Material::from_shear(SHEAR, 0.3)?;
        let operator = make(MaterialPair::new(body, body)?, grid)?;
        let gap = Gap::new(Field::new(grid, heights)?)?;
        let problem = ContactProblem::new(gap, operator, Friction::NONE)?;
        let method = Frictionless::default().within(tolerance)?;
        let mut scratch = method.scratch(&problem)?;
        let (set_up, begin) = (begin.elapsed().as_secs_f64(), Instant::now());
        let normal = Driven::Load(1e-3 * modulus * side * side);
        let drive = Drive { normal, ..Drive::default() };
        let (apart, mut state) = (ContactState::apart(grid), ContactState::apart(grid));
        let went = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
        let times = [set_up, begin.elapsed().as_secs_f64()];
        Ok(Self { problem, states: [apart, state], went, times })
    }
}

fn rough(cells: usize, tolerance: f64) -> Result<(), Failure> {
    let Rough { states: [_, state], went, times, .. } = Rough::new(cells, tolerance, &half_space)?;
    let path = format!("{}/carom{cells}.f64", std::env::var("CAROM_ROUGH")?);
    let mut file = BufWriter::new(File::create(path)?);
    for pressure in state.pressure.values() {
        file.write_all(&pressure.to_le_bytes())?;
    }
    file.flush()?;
    tell(times, went.products, went.residuals.normal);
    Ok(())
}

fn certified(cells: usize, tolerance: f64, make: Make<'_>) -> Result<(), Failure> {
    let Rough { problem, states: [apart, state], went, times } =
        Rough::new(cells, tolerance, make)?;
    let step = StepSummary::default().next(&problem, [&apart, &state], &went)?;
    println!(
        "{{\"force\": {:e}, \"contact\": {:e}, \"patches\": {}, \"energy_gap_over_energy\": {:e}}}",
        step.load.f_z,
        step.contact_share,
        step.patches,
        step.energy_gap / step.stored_energy
    );
    tell(times, went.products, went.residuals.normal);
    Ok(())
}

fn cattaneo(poisson: f64, cells: usize, tolerance: f64) -> Result<(), Failure> {
    let [force, _] = exact(poisson);
    let begin = Instant::now();
    let problem = ball(cells, poisson, FRICTION, Blocks::All)?;
    let method = Frictional::default().within(tolerance)?;
    let mut scratch = method.scratch(&problem)?;
    let set_up = begin.elapsed().as_secs_f64();
    let xi = 0.75 * 3.0 * FRICTION * force * (2.0 - poisson) / (8.0 * SHEAR);
    let apart = ContactState::apart(problem.grid());
    let (mut pressed, mut shifted) = (apart.clone(), apart.clone());
    let press = Drive { normal: Driven::Load(force), ..Drive::default() };
    let begin = Instant::now();
    let one = method.step(&problem, &apart, &press, &mut pressed, &mut scratch, &mut ())?;
    let first = begin.elapsed().as_secs_f64();
    let shift = Drive { x: Driven::Shift(xi), ..press };
    let two = method.step(&problem, &pressed, &shift, &mut shifted, &mut scratch, &mut ())?;
    let solve = begin.elapsed().as_secs_f64();
    let error = shifted.load().f_x / (0.875 * FRICTION * force) - 1.0;
    eprintln!("normal {first:.4} s, tangential {:.4} s", solve - first);
    tell([set_up, solve], one.products.plus(two.products), error);
    Ok(())
}

fn history(friction: f64, tolerance: f64) -> Result<(), Failure> {
    let begin = Instant::now();
    let grid = Grid::new(40, 10, 0.2, 0.2)?;
    let pair = MaterialPair::new(Material::from_shear(SHEAR, 0.3)?, Material::RIGID)?;
    let gap = Gap::of_shape(grid, &Shape::Paraboloid { radii: [100.0, 12.0] })?;
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(friction)?)?;
    let method = Frictional::default().within(tolerance)?;
    let mut scratch = method.scratch(&problem)?;
    let set_up = begin.elapsed().as_secs_f64();
    let mut state = ContactState::apart(grid);
    let (mut shift, mut products) = (Shift::default(), Products::default());
    let begin = Instant::now();
    for step in 0..39 {
        match step {
            0..13 => shift.zeta += 0.05 / 13.0,
            13..26 => shift.xi += 0.1 * friction * 0.05,
            _ => shift.eta += 0.1 * friction * 0.05,
        }
        let (from, drive) = (state.clone(), Drive::by_shift(shift));
        let went = method.step(&problem, &from, &drive, &mut state, &mut scratch, &mut ())?;
        products = products.plus(went.products);
    }
    let solve = begin.elapsed().as_secs_f64();
    eprintln!("{} of {} cells stick", state.count(CellState::Stick), grid.cells());
    tell([set_up, solve], products, 0.0);
    Ok(())
}

/// Half of the sliding shift to and fro, at a constant force.
fn shift_to_and_fro(cells: usize, steps: i32, tolerance: f64) -> Result<(), Failure> {
    let poisson = 0.28;
    let [force, _] = exact(poisson);
    let begin = Instant::now();
    let problem = ball(cells, poisson, FRICTION, Blocks::All)?;
    let method = Frictional::default().within(tolerance)?;
    let mut scratch = method.scratch(&problem)?;
    let set_up = begin.elapsed().as_secs_f64();
    let sliding = 3.0 * FRICTION * force * (2.0 - poisson) / (8.0 * SHEAR);
    let mut state = ContactState::apart(problem.grid());
    let (mut products, begin) = (Products::default(), Instant::now());
    for step in 0..20 {
        let turn = std::f64::consts::TAU * f64::from(step) / f64::from(steps);
        let xi = 0.5 * sliding * turn.sin();
        let drive = Drive { normal: Driven::Load(force), x: Driven::Shift(xi), ..Drive::default() };
        let (from, begin) = (state.clone(), Instant::now());
        let went = method.step(&problem, &from, &drive, &mut state, &mut scratch, &mut ())?;
        products = products.plus(went.products);
        let Products { normal, tangential, preconditioner, .. } = went.products;
        let seconds = begin.elapsed().as_secs_f64();
        eprintln!(
            "step {step}: {seconds:.4} s, {normal:.1} normal, {tangential:.1} tangential, {preconditioner:.1}"
        );
    }
    let solve = begin.elapsed().as_secs_f64();
    tell([set_up, solve], products, state.load().f_x / (FRICTION * force));
    Ok(())
}

/// The least time of `work`, of many that take some tenths of a second together.
fn least(mut work: impl FnMut()) -> f64 {
    let begin = Instant::now();
    let mut least = f64::INFINITY;
    while begin.elapsed().as_secs_f64() < 0.3 {
        let begin = Instant::now();
        work();
        least = least.min(begin.elapsed().as_secs_f64());
    }
    least
}

/// Products without zeros, and the preconditioners.
fn product(cells: usize) -> Result<(), Failure> {
    let problem = ball(cells, 0.28, FRICTION, Blocks::All)?;
    let operator = problem.shared_operator();
    let mut workspace = operator.workspace();
    let inverse = operator.inverse().ok_or("no inverse")?;
    let load: Vec<f64> = (0..cells * cells).map(|cell| 1.5 + (cell as f64).sin()).collect();
    let [mut u, mut v] = [load.clone(), load.clone()];
    let normal = least(|| {
        let into = DisplacementField::normal(&mut u);
        operator.apply(TractionField::normal(&load), into, &mut workspace).expect("finite");
    });
    let tangential = least(|| {
        let into = DisplacementField::tangential(&mut u, &mut v);
        let load = TractionField::tangential(&load, &load);
        operator.apply(load, into, &mut workspace).expect("finite");
    });
    let pressure = least(|| inverse.pressure(&load, &mut u, &mut workspace));
    let traction = least(|| {
        let into = [Some(&mut u[..]), Some(&mut v[..])];
        inverse.traction([Some(&load), Some(&load)], into, &mut workspace);
    });
    println!(
        "{{\"normal\": {normal:e}, \"tangential\": {tangential:e}, \"inverse_normal\": {pressure:e}, \
         \"inverse_tangential\": {traction:e}}}"
    );
    Ok(())
}

fn tell([set_up, solve]: [f64; 2], products: Products, error: f64) {
    let Products { normal, tangential, coupling, preconditioner } = products;
    println!(
        "{{\"set_up\": {set_up:.5}, \"solve\": {solve:.5}, \"normal\": {normal:.1}, \"tangential\": \
         {tangential:.1}, \"coupling\": {coupling:.1}, \"preconditioner\": {preconditioner:.1}, \
         \"error\": {error:e}}}"
    );
}
