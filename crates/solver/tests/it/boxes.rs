//! Steps on a box around the contact have the solution of the whole window.

use std::sync::Arc;

use crate::delegating::Delegating;
use carom_halfspace::operator::{HalfSpaceOperator, SurfaceOperator};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictional, FrictionalError,
    FrictionalScratch, Gap, Method as _, violations,
};

/// The same problem with and without boxes, on a window of 4 x 3.2.
fn both(poisson: [f64; 2], height: impl Fn(f64, f64) -> f64) -> [ContactProblem; 2] {
    let grid = Grid::new(160, 128, 0.025, 0.025).unwrap();
    let [one, two] = poisson.map(|nu| Material::from_shear(2.0, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    let gap = Gap::from_function(grid, height).unwrap();
    let operator = || HalfSpaceOperator::new(pair, grid).unwrap();
    let new = |operator: Arc<dyn SurfaceOperator>| {
        ContactProblem::new(gap.clone(), operator, Friction::new(0.3).unwrap()).unwrap()
    };
    [new(Arc::new(operator())), new(Arc::new(Delegating::whole(operator())))]
}

fn step(
    problem: &ContactProblem,
    scratch: &mut FrictionalScratch,
    from: &ContactState,
    drive: &Drive,
) -> Result<(ContactState, f64), FrictionalError> {
    let mut to = ContactState::apart(problem.grid());
    let went = Frictional::default().step(problem, from, drive, &mut to, scratch, &mut ())?;
    Ok((to, went.products.normal + went.products.tangential))
}

/// The greatest differences of tractions relative to the greatest pressure, and of displacements
/// relative to the greatest displacement.
fn apart(a: &ContactState, b: &ContactState) -> [f64; 2] {
    let most =
        |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0_f64, f64::max);
    let zero = vec![0.0; a.pressure.values().len()];
    let top = most(a.pressure.values(), &zero).max(f64::MIN_POSITIVE);
    let far = most(a.displacement_x.values(), &zero).max(most(a.displacement_y.values(), &zero));
    let fields = |a: &ContactState| {
        [&a.pressure, &a.traction_x, &a.traction_y, &a.displacement_x, &a.displacement_y]
            .map(|field| field.values().to_vec())
    };
    let (a, b) = (fields(a), fields(b));
    let off = |range: std::ops::Range<usize>| range.map(|i| most(&a[i], &b[i])).fold(0.0, f64::max);
    [off(0..3) / top, off(3..5) / far.max(f64::MIN_POSITIVE)]
}

fn by(zeta: f64, xi: f64, eta: f64, omega: f64) -> Drive {
    Drive::by_shift(Shift { zeta, xi, eta, omega })
}

/// Follows the drives on both problems. Returns the ratio of the numbers of products.
fn follow(problems: &[ContactProblem; 2], drives: &[Drive], most: f64) -> f64 {
    let method = Frictional::default();
    let mut scratches = problems.each_ref().map(|problem| method.scratch(problem).unwrap());
    let mut state = ContactState::apart(problems[0].grid());
    let mut products = [0.0; 2];
    for (number, drive) in drives.iter().enumerate() {
        let [boxed, whole] = [0, 1].map(|i| {
            let (to, count) = step(&problems[i], &mut scratches[i], &state, drive).unwrap();
            products[i] += count;
            to
        });
        let off = apart(&whole, &boxed);
        assert!(off[0] < most && off[1] < most, "step {number}: {off:?}");
        assert_eq!(boxed.count(CellState::Exterior), whole.count(CellState::Exterior));
        let left = violations(&problems[0], &state, &boxed).unwrap();
        assert!(left.normal < 1e-8 && left.tangential < 1e-7, "step {number}: {left:?}");
        let [a, b] = [boxed.load(), whole.load()];
        assert!((a.m_z - b.m_z).abs() <= 1e-6 * (b.f_z + b.m_z.abs()), "{a:?} {b:?}");
        state = boxed;
    }
    products[1] / products[0]
}

fn press_and_pull() -> Vec<Drive> {
    vec![
        by(0.05, 0.0, 0.0, 0.0),
        by(0.05, 0.005, 0.002, 0.0),
        by(0.1, 0.01, 0.0, 0.0),
        Drive { normal: Driven::Load(0.4), x: Driven::Load(0.05), ..Drive::default() },
        by(0.02, 0.0, 0.004, 0.0),
        by(-0.1, 0.0, 0.0, 0.0),
        by(0.07, 0.003, 0.0, 0.0),
    ]
}

/// A contact away from the centre that grows, shrinks, separates and returns.
#[test]
fn a_small_contact_is_that_of_the_whole_window() {
    for poisson in [[0.3, 0.3], [0.0, 0.0], [0.1, 0.4]] {
        let ball = |x: f64, y: f64| 0.5 * ((x - 0.9).powi(2) + 1.4 * (y + 0.6).powi(2));
        let gain = follow(&both(poisson, ball), &press_and_pull(), 1e-6);
        println!("{poisson:?}: {gain:.1} times fewer products");
        assert!(gain > 3.0, "{poisson:?}: {gain}");
    }
}

/// A twist is taken about the centre of the window, wherever the contact lies.
#[test]
fn a_twist_keeps_its_middle() {
    let ball = |x: f64, y: f64| 0.5 * ((x - 0.2).powi(2) + (y + 0.1).powi(2));
    let twisted = Drive { twist: Driven::Load(0.004), ..by(0.1, 0.0, 0.0, 0.0) };
    let drives =
        [by(0.1, 0.0, 0.0, 0.0), by(0.1, 0.0, 0.0, 0.02), twisted, by(0.1, 0.01, 0.0, 0.0)];
    follow(&both([0.3, 0.3], ball), &drives, 1e-6);
    follow(&both([0.1, 0.4], ball), &drives[..2], 1e-6);
}

/// A contact that moves from one hill to a distant one as the load grows.
#[test]
fn a_second_contact_far_away_is_found() {
    let hills = |x: f64, y: f64| {
        let hill = |x0: f64, k: f64| k * ((x - x0).powi(2) + y * y);
        hill(-1.4, 4.0).min(0.03 + hill(1.3, 0.5))
    };
    let drives = [0.005, 0.02, 0.04, 0.1, 0.01].map(|zeta| by(zeta, 0.1 * zeta, 0.0, 0.0));
    follow(&both([0.3, 0.3], hills), &drives, 1e-6);
}

/// A spike narrower than the coarse cells of the pilot solve: the bodies overlap outside the box,
/// and all cells are solved.
#[test]
fn a_spike_that_coarse_cells_miss_is_found() {
    let is_spike = |x: f64, y: f64| (x + 1.5).abs().max((y - 1.0).abs()) < 0.013;
    let spiked = |x: f64, y: f64| {
        if is_spike(x, y) { 0.01 } else { 0.5 * ((x - 1.0).powi(2) + y * y) }
    };
    let problems = both([0.3, 0.3], spiked);
    let method = Frictional::default();
    let [one, other] = problems.each_ref().map(|problem| {
        let mut scratch = method.scratch(problem).unwrap();
        let start = ContactState::apart(problem.grid());
        step(problem, &mut scratch, &start, &by(0.05, 0.0, 0.0, 0.0)).unwrap().0
    });
    assert!(apart(&other, &one)[0] < 1e-6);
    let grid = problems[0].grid();
    let pressed = (0..grid.cells())
        .filter(|cell| is_spike(grid.centred_x(cell % grid.nx()), grid.centred_y(cell / grid.nx())))
        .filter(|cell| one.pressure.values()[*cell] > 0.0);
    assert!(pressed.count() > 0, "the spike carries");
}

/// A history restored in the middle continues bit for bit.
#[test]
fn a_history_taken_up_again_has_the_same_bits() {
    let ball = |x: f64, y: f64| 0.5 * ((x - 0.5).powi(2) + (y + 0.6).powi(2));
    let [problem, _] = both([0.1, 0.4], ball);
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let mut states = vec![ContactState::apart(problem.grid())];
    for drive in press_and_pull() {
        let next = step(&problem, &mut scratch, &states[states.len() - 1], &drive).unwrap().0;
        states.push(next);
    }
    for (pair, drive) in states.windows(2).zip(press_and_pull()) {
        let mut fresh = method.scratch(&problem).unwrap();
        assert_eq!(step(&problem, &mut fresh, &pair[0], &drive).unwrap().0, pair[1]);
    }
}
