//! Rough products: a solve that uses them reaches what a solve without them reaches.

use std::sync::Arc;

use crate::delegating::Delegating;
use carom_halfspace::operator::{Blocks, HalfSpaceOperator, SurfaceOperator, Threads};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method as _, Shape, violations,
};

const CELLS: usize = 96;
/// Force of a contact of radius 1.
const FORCE: f64 = 4.0 / 3.0 * 80_000.0 / 0.72 / 100.0;
/// Shift at which it slides.
const SLIDING: f64 = 3.0 * 0.4 * FORCE * 1.72 / (8.0 * 80_000.0);

fn problem(unit: f64, is_exact: bool) -> ContactProblem {
    let width = 2.4 * unit / CELLS as f64;
    let grid = Grid::new(CELLS, CELLS - 7, width, width).unwrap();
    let body = Material::from_shear(80_000.0, 0.28).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    let gap = Gap::of_shape(grid, &Shape::Paraboloid { radii: [100.0 * unit; 2] }).unwrap();
    let operator = HalfSpaceOperator::with_blocks(pair, grid, Blocks::All, Threads::One).unwrap();
    let operator: Arc<dyn SurfaceOperator> = match is_exact {
        true => Arc::new(Delegating::exact(operator)),
        false => Arc::new(operator),
    };
    ContactProblem::new(gap, operator, Friction::new(0.4).unwrap()).unwrap()
}

/// States after a press, shifts to and fro that turn, large and small, by shift and by force; products of all steps.
fn states(problem: &ContactProblem, unit: f64) -> (Vec<ContactState>, f64) {
    let method = Frictional::default();
    let mut scratch = method.scratch(problem).unwrap();
    let (mut states, mut products) = (vec![ContactState::apart(problem.grid())], 0.0);
    let force = FORCE * unit * unit;
    let shifts = [[0.0, 0.0], [0.5, 0.0], [0.501, 0.0], [0.3, 0.2], [-0.6, 0.1], [1.5, -1.0]];
    let shifted = shifts.map(|shift| shift.map(|part| Driven::Shift(part * SLIDING * unit)));
    let loaded = [[0.2, 0.0], [0.3, 0.3], [0.3, 0.9]]
        .map(|load| load.map(|part| Driven::Load(0.4 * force * part)));
    for [x, y] in shifted.into_iter().chain(loaded) {
        let drive = Drive { normal: Driven::Load(force), x, y, ..Drive::default() };
        let (from, mut state) = (states[states.len() - 1].clone(), states[0].clone());
        let reached = method.step(problem, &from, &drive, &mut state, &mut scratch, &mut ());
        products += reached.unwrap().products.tangential;
        states.push(state);
    }
    (states, products)
}

/// Both satisfy the friction law to the same tolerance, with the same loads, by hardly more products. In metres,
/// tractions in single precision would leave its range without units.
#[test]
fn rough_products_reach_what_exact_ones_reach() {
    for unit in [1.0, 1e-12] {
        let [rough, exact] = [false, true].map(|is_exact| problem(unit, is_exact));
        let ((with, spent), (without, needed)) = (states(&rough, unit), states(&exact, unit));
        assert!(spent > needed && spent < 1.2 * needed, "{spent} {needed}");
        let most = 0.4 * FORCE * unit * unit;
        for (step, (one, other)) in with.iter().zip(&without).enumerate().skip(1) {
            let left = violations(&exact, &with[step - 1], one).unwrap();
            assert!(left.normal < 2e-9 && left.tangential < 2e-9, "{step}: {left:?}");
            let (load, known) = (one.load(), other.load());
            for (got, want) in [(load.f_x, known.f_x), (load.f_y, known.f_y)] {
                assert!((got - want).abs() < 1e-8 * most, "{step}: {got} {want}");
            }
        }
    }
}

/// Pressures on so many cells are found with rough products, by force and by approach, to any tolerance: their errors
/// count, so that a product without them confirms what is told.
#[test]
fn pressures_on_a_large_grid_are_as_exact_as_told() {
    let (width, modulus) = (2.4 / 256.0, 80_000.0 / 0.72);
    let grid = Grid::new(256, 257, width, width).unwrap();
    let body = Material::from_shear(80_000.0, 0.28).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    // Waves that are pressed flat in most places, so that sets change.
    let gap = Gap::from_function(grid, |x, y| {
        (x * x + y * y) / 200.0 + 2e-4 * ((9.0 * x).cos() + (11.0 * y + x).sin())
    });
    let operator = HalfSpaceOperator::with_blocks(pair, grid, Blocks::All, Threads::One).unwrap();
    let exact: Arc<dyn SurfaceOperator> = Arc::new(Delegating::exact(operator.clone()));
    let [rough, exact] = [Arc::new(operator) as Arc<dyn SurfaceOperator>, exact].map(|operator| {
        ContactProblem::new(gap.clone().unwrap(), operator, Friction::NONE).unwrap()
    });
    let apart = ContactState::apart(grid);
    for (normal, tolerance) in [
        (Driven::Load(4.0 / 3.0 * modulus / 100.0), 1e-5),
        (Driven::Load(4.0 / 3.0 * modulus / 100.0), 1e-12),
        (Driven::Shift(0.01), 1e-8),
    ] {
        let method = Frictional::default().within(tolerance).unwrap();
        let drive = Drive { normal, ..Drive::default() };
        let solved = |problem: &ContactProblem| {
            let mut state = apart.clone();
            let mut scratch = method.scratch(problem).unwrap();
            let reached =
                method.step(problem, &apart, &drive, &mut state, &mut scratch, &mut ()).unwrap();
            (state, reached)
        };
        let ((one, reached), (other, needed)) = (solved(&rough), solved(&exact));
        let left = violations(&exact, &apart, &one).unwrap().normal;
        assert!(left <= reached.residuals.normal + 1e-14 && left <= tolerance, "{left:e}");
        assert!(reached.products.normal <= needed.products.normal + 1.5, "{reached:?} {needed:?}");
        let scale = other.pressure.values().iter().fold(0.0, |most: f64, p| most.max(*p));
        for (one, other) in one.pressure.values().iter().zip(other.pressure.values()) {
            assert!((one - other).abs() < 1e3 * tolerance * scale, "{one} {other}");
        }
    }
}
