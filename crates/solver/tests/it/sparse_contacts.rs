//! Contacts of few cells on large grids: solved among these cells, they are those of a solution on all cells.

use std::ops::ControlFlow;
use std::sync::Arc;

use crate::delegating::Delegating;
use carom_drawn::{Draw as _, Xorshift};
use carom_halfspace::operator::{
    Blocks, DisplacementField, HalfSpaceOperator, PeriodicOperator, SurfaceOperator, Threads,
    TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Driven, Frictionless, Gap, Method as _,
    NormalError, Progress, SelfAffine, Stop,
};

/// A drawn rough surface, with a slope or a bend if it is not periodic.
fn gap(random: &mut Xorshift, periodic: bool) -> Gap {
    let [nx, ny] = [(); 2].map(|()| 256 + 16 * random.below(5));
    let width = 1.0 / nx as f64;
    let grid = Grid::new(nx, ny, width, width * (0.8 + 0.4 * random.part())).unwrap();
    let shortest = (4.0 + 12.0 * random.part()) * 1.3 * width;
    let seed = (1e6 * random.part()) as u64;
    let surface = SelfAffine { hurst: 0.8, rms: 0.01, longest: 0.4, shortest, seed };
    let rough = surface.gap(grid).unwrap();
    if periodic {
        return rough;
    }
    let [slope, bend] = [0.02 * (random.part() - 0.5), 0.05 * random.part()];
    let heights = rough.heights().values().iter().zip(grid.centres());
    let values = heights.map(|(z, (x, y))| z + slope * x + bend * (x * x + y * y)).collect();
    Gap::new(carom_halfspace::Field::new(grid, values).unwrap()).unwrap()
}

/// The operator, or one with no influence among few cells.
fn given(own: impl SurfaceOperator + 'static, among_few: bool) -> Arc<dyn SurfaceOperator> {
    if among_few { Arc::new(own) } else { Arc::new(Delegating::exact(own)) }
}

fn problem(gap: &Gap, periodic: bool, among_few: bool, threads: Threads) -> ContactProblem {
    let body = Material::from_shear(1.0, 0.5).unwrap();
    let pair = MaterialPair::new(body, Material::RIGID).unwrap();
    let operator = if periodic {
        given(PeriodicOperator::new(pair, gap.grid(), threads).unwrap(), among_few)
    } else {
        let blocks = Blocks::Normal;
        let own = HalfSpaceOperator::with_blocks(pair, gap.grid(), blocks, threads).unwrap();
        given(own, among_few)
    };
    ContactProblem::new(gap.clone(), operator, Friction::NONE).unwrap()
}

/// The solution, and the smallest number of cells of an iteration on a large grid.
fn solved(
    problem: &ContactProblem,
    normal: Driven,
    tolerance: f64,
) -> (ContactState, Convergence, usize) {
    let method = Frictionless::default().within(tolerance).unwrap();
    let mut scratch = method.scratch(problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let (mut state, mut fewest) = (apart.clone(), usize::MAX);
    let drive = Drive { normal, ..Drive::default() };
    let mut see = |progress: &Progress| {
        fewest = fewest.min(progress.cells);
        ControlFlow::Continue(())
    };
    let reached = method.step(problem, &apart, &drive, &mut state, &mut scratch, &mut see);
    let reached = reached.unwrap();
    (state, reached, fewest)
}

/// The conditions of contact by a fresh product with all cells, over the greatest displacement.
fn violation(problem: &ContactProblem, state: &ContactState) -> f64 {
    let (operator, pressure) = (problem.operator(), state.pressure.values());
    let mut w = vec![0.0; pressure.len()];
    let found = DisplacementField::normal(&mut w);
    operator.apply(TractionField::normal(pressure), found, &mut operator.workspace()).unwrap();
    let heights = problem.gap().heights().values();
    let (mut worst, mut scale) = (0.0_f64, 0.0_f64);
    for ((p, w), z) in pressure.iter().zip(&w).zip(heights) {
        assert!(*p >= 0.0);
        let gap = w + z - state.shift.zeta;
        worst = worst.max(if *p > 0.0 { gap.abs() } else { (-gap).max(0.0) });
        scale = if *p > 0.0 { scale.max(w.abs()) } else { scale };
    }
    worst / scale
}

fn check(seed: u64, tolerance: f64) {
    let mut random = Xorshift(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    let (periodic, by_force) = (random.part() < 0.5, random.part() < 0.5);
    let gap = gap(&mut random, periodic);
    let few = problem(&gap, periodic, true, Threads::One);
    let all = problem(&gap, periodic, false, Threads::One);
    let force = Driven::Load(1e-3 + 2e-3 * random.part());
    let (pressed, ..) = solved(&all, force, 1e-10);
    let drive = if by_force { force } else { Driven::Shift(pressed.shift.zeta) };
    let (state, reached, cells) = solved(&few, drive, tolerance);
    let case = format!("seed {seed}, periodic {periodic}, {drive:?}, {cells} cells");
    assert!(6 * cells <= gap.grid().cells(), "{case}");
    let violated = violation(&few, &state);
    assert!(violated <= 1.5 * tolerance, "{case}: {violated:e}");
    assert!(reached.residuals.normal <= tolerance, "{case}: {reached:?}");
    if let Driven::Load(force) = drive {
        assert!((state.load().f_z / force - 1.0).abs() < 1e-12, "{case}");
    }
    let [got, want] = [&state, &pressed].map(|state| state.pressure.values());
    let mean = want.iter().sum::<f64>() / want.iter().filter(|p| **p > 0.0).count() as f64;
    for (got, want) in got.iter().zip(want) {
        let is_alike = (got - want).abs() < 1e3 * tolerance * mean;
        assert!(is_alike, "{case}: {got} {want}, mean {mean}");
    }
}

#[test]
fn drawn_contacts_of_few_cells_are_those_of_all_cells() {
    (0..12).for_each(|seed| check(seed, 1e-7));
}

#[test]
#[ignore = "minutes: 500 drawn contacts"]
fn many_drawn_contacts_of_few_cells_are_those_of_all_cells() {
    (100..600).for_each(|seed| check(seed, [1e-5, 1e-7, 1e-9][seed as usize % 3]));
}

/// Patches of hundreds of cells: their inverse is that of all grids, and takes no more iterations than patches of a few.
#[test]
fn a_contact_of_many_cells_is_that_of_all_cells() {
    for periodic in [false, true] {
        let grid = Grid::new(768, 640, 1.0 / 768.0, 1.0 / 768.0).unwrap();
        let surface = SelfAffine { hurst: 0.8, rms: 0.01, longest: 0.5, shortest: 0.1, seed: 3 };
        let gap = surface.gap(grid).unwrap();
        let [few, all] =
            [true, false].map(|among_few| problem(&gap, periodic, among_few, Threads::One));
        let force = Driven::Load(4e-2);
        let (want, ..) = solved(&all, force, 1e-10);
        for drive in [force, Driven::Shift(want.shift.zeta)] {
            let (state, reached, cells) = solved(&few, drive, 1e-7);
            assert!(cells > 1 << 15 && 6 * cells < grid.cells(), "{cells}");
            // A wrong gap, or cells about the contact that are left out, cost two products more.
            assert!(reached.products.normal < 9.0, "{drive:?}: {reached:?}");
            assert!(violation(&few, &state) <= 1.5e-7 && reached.iterations < 60, "{reached:?}");
            let [got, want] = [&state, &want].map(|state| state.pressure.values());
            let most = want.iter().copied().fold(0.0, f64::max);
            assert!(got.iter().zip(want).all(|(got, want)| (got - want).abs() < 1e-4 * most));
        }
    }
}

/// A cell touches or does not, whatever the threads do.
#[test]
fn contacts_of_few_cells_have_the_same_bits_on_any_number_of_threads() {
    let gap = gap(&mut Xorshift(77), false);
    let on = |threads| solved(&problem(&gap, false, true, threads), Driven::Load(4e-3), 1e-6).0;
    let one = on(Threads::One);
    for threads in [1, 2, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        assert!(pool.install(|| on(Threads::Pool)) == one);
    }
}

/// An observer that ends a correction ends the step.
#[test]
fn corrections_among_few_cells_end_when_they_are_told() {
    let gap = gap(&mut Xorshift(77), false);
    let problem = problem(&gap, false, true, Threads::One);
    let method = Frictionless::default();
    let (mut seen, apart) = (0, ContactState::apart(gap.grid()));
    let mut see = |progress: &Progress| {
        seen += 1;
        assert!(6 * progress.cells < gap.grid().cells());
        if seen == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let drive = Drive { normal: Driven::Load(4e-3), ..Drive::default() };
    let mut scratch = method.scratch(&problem).unwrap();
    let told = method.step(&problem, &apart, &drive, &mut apart.clone(), &mut scratch, &mut see);
    assert!(matches!(
        told,
        Err(NormalError::NotConverged { reached: Convergence { stop: Stop::Observer, .. }, .. })
    ));
    assert_eq!(seen, 3);
}
