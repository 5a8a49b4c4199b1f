//! Large grids: memory use, and the same bits on any number of threads.

use std::sync::Arc;

use carom_halfspace::operator::{Blocks, HalfSpaceOperator, Threads};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    ContactProblem, ContactState, Drive, Driven, Frictional, Frictionless, Gap, Method as _,
};
use rayon::prelude::*;

fn problem(n: usize, blocks: Blocks, threads: Threads, other: Material, f: f64) -> ContactProblem {
    let grid = Grid::new(n, n, 2.4 / n as f64, 2.4 / n as f64).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
    let pair = MaterialPair::new(Material::from_shear(2.0, 0.2).unwrap(), other).unwrap();
    let operator = HalfSpaceOperator::with_blocks(pair, grid, blocks, threads).unwrap();
    ContactProblem::new(gap, Arc::new(operator), Friction::new(f).unwrap()).unwrap()
}

/// The greatest memory use of this process, in megabytes; `None` if the system does not report it.
fn most_memory() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|line| line.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<f64>().ok()? / 1024.0)
}

fn hertz(n: usize) -> f64 {
    let same = Material::from_shear(2.0, 0.2).unwrap();
    let problem = problem(n, Blocks::Normal, Threads::One, same, 0.0);
    let method = Frictionless::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let (mut state, normal) = (apart.clone(), Driven::Shift(1.0));
    let drive = Drive { normal, ..Drive::default() };
    method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ()).unwrap();
    state.load().f_z / (8.0 / 3.0 / 0.8) - 1.0
}

#[test]
#[ignore = "memory is that of the process: run alone"]
fn a_million_cells_fit() {
    let error = hertz(1024);
    println!("1024: {error:.1e}, {:?} MB", most_memory());
    assert!(error.abs() < 1e-6);
}

#[test]
#[ignore = "minutes: four million cells, and memory is that of the process: run alone"]
fn four_million_cells_fit() {
    let error = hertz(2048);
    println!("2048: {error:.1e}, {:?} MB", most_memory());
    assert!(error.abs() < 3e-7);
}

#[test]
#[ignore = "memory is that of the process: run alone"]
fn a_million_coupled_cells_fit() {
    let problem = problem(1024, Blocks::All, Threads::One, Material::RIGID, 0.3);
    let method = Frictional::default().within(1e-4).unwrap();
    let mut scratch = method.scratch(&problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let mut state = apart.clone();
    let drive = Drive::by_shift(Shift { zeta: 1.0, xi: 0.2, ..Shift::default() });
    let went = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ()).unwrap();
    println!("1024 coupled: {:?} {:?} MB", went.products, most_memory());
}

fn pool(count: usize) -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap()
}

/// A first step, and one back that starts from its tractions.
fn to_and_fro(threads: Threads, other: Material, cells: usize, zeta: f64) -> [ContactState; 2] {
    let problem = problem(cells, Blocks::All, threads, other, 0.4);
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let mut state = apart.clone();
    let shift = Shift { zeta, xi: 0.2 * zeta, eta: 0.05 * zeta, omega: 0.1 * zeta };
    let drive = Drive::by_shift(shift);
    method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ()).unwrap();
    let back = Drive {
        normal: Driven::Load(0.99 * state.load().f_z),
        ..Drive::by_shift(Shift { xi: 0.1 * zeta, ..shift })
    };
    let from = state.clone();
    method.step(&problem, &from, &back, &mut state, &mut scratch, &mut ()).unwrap();
    [from, state]
}

/// One thread and several give the same bits, on the window and on a box around a small contact.
#[test]
fn threads_do_not_change_a_bit() {
    let same = Material::from_shear(2.0, 0.2).unwrap();
    // More cells in contact than one part has, and fewer.
    for (other, cells, zeta) in
        [(Material::RIGID, 72, 1.0), (Material::RIGID, 128, 0.05), (same, 200, 1.0)]
    {
        let one = to_and_fro(Threads::One, other, cells, zeta);
        assert!(one.iter().all(|state| state.load().f_z > 0.0));
        for count in [1, 2, 3] {
            let several = pool(count).install(|| to_and_fro(Threads::Pool, other, cells, zeta));
            assert_eq!(several, one);
        }
    }
}

/// Solutions that share a pool do not wait for each other for ever.
#[test]
fn solutions_beside_each_other_have_the_same_bits() {
    let of = |threads: Threads, zeta: f64| to_and_fro(threads, Material::RIGID, 96, zeta);
    let zetas = [0.6, 0.8, 1.0];
    let alone = zetas.map(|zeta| of(Threads::One, zeta));
    for count in [2, 4] {
        let beside: Vec<_> = pool(count)
            .install(|| zetas.into_par_iter().map(|zeta| of(Threads::Pool, zeta)).collect());
        assert_eq!(beside, alone);
    }
}
