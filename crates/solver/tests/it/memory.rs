//! A step depends only on the state before it and on its drive.

use crate::delegating::Delegating;
use carom_halfspace::operator::HalfSpaceOperator;
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellFriction, ContactProblem, ContactState, Drive, Driven, Frictional, FrictionalScratch, Gap,
    Method as _, SurfaceFriction,
};
use std::sync::Arc;

fn problem(cells: usize, poisson: [f64; 2], friction: SurfaceFriction) -> ContactProblem {
    let width = 2.4 / cells as f64;
    let grid = Grid::new(cells, cells + 2, width, width).unwrap();
    let [one, two] = poisson.map(|nu| Material::from_shear(2.0, nu).unwrap());
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + 0.8 * y * y)).unwrap();
    let pair = MaterialPair::new(one, two).unwrap();
    ContactProblem::of_half_spaces(gap, pair, friction).unwrap()
}

fn drives() -> Vec<Drive> {
    let by =
        |zeta: f64, xi: f64, eta: f64, omega: f64| Drive::by_shift(Shift { zeta, xi, eta, omega });
    let pressed = by(1.0, 0.0, 0.0, 0.0);
    vec![
        pressed,
        by(1.0, 0.2, 0.1, 0.0),
        Drive { normal: Driven::Load(3.0), x: Driven::Load(0.3), ..pressed },
        by(0.5, -0.2, 0.0, 0.2),
        by(-1.0, 0.0, 0.3, 0.0),
        Drive { normal: Driven::Load(5.0), twist: Driven::Load(0.2), ..pressed },
        by(1.02, 0.05, 0.0, 0.0),
    ]
}

fn step(
    problem: &ContactProblem,
    from: &ContactState,
    drive: &Drive,
    scratch: &mut FrictionalScratch,
) -> Option<ContactState> {
    let mut to = ContactState::apart(problem.grid());
    let went = Frictional::default().step(problem, from, drive, &mut to, scratch, &mut ());
    went.ok().map(|_| to)
}

/// From every state to every drive, with a working memory that was used before and with a fresh
/// one: the same bits.
fn compare(problem: &ContactProblem) {
    let fresh = Frictional::default().scratch(problem).unwrap();
    let mut used = fresh.clone();
    let mut states = vec![ContactState::apart(problem.grid())];
    for drive in drives() {
        let from = states[states.len() - 1].clone();
        states.extend(step(problem, &from, &drive, &mut fresh.clone()));
    }
    for from in states.iter().rev() {
        for drive in drives() {
            let want = step(problem, from, &drive, &mut fresh.clone());
            assert_eq!(step(problem, from, &drive, &mut used), want, "{drive:?}");
        }
    }
}

#[test]
fn what_was_solved_before_leaves_no_bit_behind() {
    let friction = |f: f64| Friction::new(f).unwrap();
    let both = CellFriction::new(friction(0.5), friction(0.3)).unwrap();
    compare(&problem(36, [0.3, 0.3], friction(0.4).into()));
    compare(&problem(20, [0.0, 0.45], friction(0.4).into()));
    compare(&problem(20, [0.0, 0.3], both.into()));
    compare(&problem(16, [0.0, 0.45], friction(f64::INFINITY).into()));
    compare(&problem(16, [0.0, 0.45], friction(12.0).into()));
}

/// What a step is said to cost is what it asks of the operator, where that has no coarser grids, parts or rough products.
#[test]
fn the_products_of_a_step_are_those_asked_of_the_operator() {
    let given = [drives()[0], drives()[1], drives()[3]];
    for (poisson, friction) in
        [([0.3; 2], 0.0), ([0.3; 2], 0.4), ([0.0, 0.5], 0.4), ([0.0, 0.5], 12.0)]
    {
        let friction = Friction::new(friction).unwrap();
        let plain = problem(12, poisson, friction.into());
        let [one, two] = poisson.map(|nu| Material::from_shear(2.0, nu).unwrap());
        let pair = MaterialPair::new(one, two).unwrap();
        let own = HalfSpaceOperator::new(pair, plain.grid()).unwrap();
        let operator = Delegating::on_one_grid(own);
        let asked = Arc::clone(operator.asked());
        let problem =
            ContactProblem::new(plain.gap().clone(), Arc::new(operator), friction).unwrap();
        let method = Frictional::default();
        let mut scratch = method.scratch(&problem).unwrap();
        let mut from = ContactState::apart(problem.grid());
        for drive in given {
            let (before, mut to) = (asked.counts(), from.clone());
            let went = method.step(&problem, &from, &drive, &mut to, &mut scratch, &mut ());
            let (went, now) = (went.unwrap(), asked.counts());
            let spent = [0, 1, 2].map(|kind| now[kind] - before[kind]);
            let told = [went.products.normal, went.products.tangential, went.products.coupling];
            assert_eq!([told[0], told[2]], [spent[0], spent[2]], "{poisson:?} {friction:?}");
            // Products without tractions are counted, and not asked for.
            assert!((0.0..=4.0).contains(&(told[1] - spent[1])), "{told:?} {spent:?}");
            from = to;
        }
    }
}
