//! Dissimilar bodies at great friction: a problem turned by a right angle has the turned solution,
//! at the same cost.

use std::sync::Arc;

use carom_halfspace::operator::{HalfSpaceOperator, PeriodicOperator, SurfaceOperator, Threads};
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method as _, violations,
};

const LENGTH: f64 = 2.4;

fn height(x: f64, y: f64) -> f64 {
    let wave = |at: f64| 1.0 - (2.0 * std::f64::consts::PI * at / LENGTH).cos();
    0.05 * wave(x) + 0.07 * wave(y - 0.1)
}

/// A body of nu = 0 on a rigid one; with `turns`, the same seen from axes turned by a right angle.
fn problem(counts: [usize; 2], periodic: bool, friction: f64, turns: bool) -> ContactProblem {
    let sides = counts.map(|count| if count < 3 { 0.2 } else { LENGTH / count as f64 });
    let ([nx, ny], [dx, dy]) = (counts, sides);
    let grid = if turns { Grid::new(ny, nx, dy, dx) } else { Grid::new(nx, ny, dx, dy) }.unwrap();
    let own = |x: f64, y: f64| if turns { height(y, -x) } else { height(x, y) };
    let gap = Gap::from_function(grid, own).unwrap();
    let pair = MaterialPair::new(Material::from_shear(1.0, 0.0).unwrap(), Material::RIGID).unwrap();
    let operator: Arc<dyn SurfaceOperator> = if periodic {
        Arc::new(PeriodicOperator::new(pair, grid, Threads::One).unwrap())
    } else {
        Arc::new(HalfSpaceOperator::new(pair, grid).unwrap())
    };
    ContactProblem::new(gap, operator, Friction::new(friction).unwrap()).unwrap()
}

/// The states after each step, given by the normal force per area of the grid, both shifts and the twist, and
/// the products with the influence that they take.
fn states(problem: &ContactProblem, steps: &[[f64; 4]], turns: bool) -> (Vec<ContactState>, f64) {
    let (grid, method) = (problem.grid(), Frictional::default());
    let area = grid.cells() as f64 * grid.cell_area();
    let mut scratch = method.scratch(problem).unwrap();
    let (mut states, mut spent) = (vec![ContactState::apart(grid)], 0.0);
    for &[pressure, xi, eta, omega] in steps {
        let [x, y] = if turns { [-eta, xi] } else { [xi, eta] }.map(Driven::Shift);
        let normal = Driven::Load(pressure * area);
        let drive = Drive { normal, x, y, twist: Driven::Shift(omega) };
        let from = &states[states.len() - 1];
        let mut to = from.clone();
        let went = method.step(problem, from, &drive, &mut to, &mut scratch, &mut ());
        let went = went.unwrap_or_else(|error| panic!("{grid:?}, turned: {turns}: {error}"));
        spent += went.products.coupling;
        let left = violations(problem, from, &to).unwrap();
        assert!(left.normal < 1e-8 && left.tangential < 1e-7, "{grid:?}: {left:?}");
        states.push(to);
    }
    (states, spent)
}

/// The same field seen from the first axes.
fn turned_back(field: &Field, sign: f64) -> Vec<f64> {
    let grid = field.grid();
    let (nx, ny) = (grid.ny(), grid.nx());
    let places = (0..nx * ny).map(|i| grid.index(ny - 1 - i / nx, i % nx));
    places.map(|at| sign * field.values()[at]).collect()
}

#[test]
fn a_turned_problem_has_the_turned_solution_at_great_friction() {
    let shifts = [[0.01, 0.0, 0.0, 0.0], [0.01, 0.01, 0.02, 0.0], [0.015, -0.01, 0.01, 0.0]];
    let twists = shifts.map(|[pressure, xi, eta, _]| [pressure, xi, eta, 0.02]);
    for (counts, periodic, steps) in [
        ([24, 20], false, twists),
        ([2, 24], false, shifts),
        ([1, 24], false, shifts),
        ([24, 12], true, shifts),
        ([2, 24], true, shifts),
    ] {
        for friction in [20.0, 200.0, f64::INFINITY] {
            let [(one, cost), (other, turned)] = [false, true]
                .map(|turns| states(&problem(counts, periodic, friction, turns), &steps, turns));
            let at = format!("{counts:?}, periodic: {periodic}, f = {friction}");
            println!("{at}: {cost} {turned} products");
            assert!((cost / turned).ln().abs() < 0.1, "{at}: {cost} {turned} products");
            for (step, (one, other)) in one.iter().zip(&other).enumerate().skip(1) {
                let peak = one.peak_pressure();
                for (field, back) in [
                    (&one.pressure, turned_back(&other.pressure, 1.0)),
                    (&one.traction_x, turned_back(&other.traction_y, 1.0)),
                    (&one.traction_y, turned_back(&other.traction_x, -1.0)),
                ] {
                    for (own, back) in field.values().iter().zip(back) {
                        assert!(
                            (own - back).abs() < 1e-5 * peak,
                            "{at}, step {step}: {own} {back}"
                        );
                    }
                }
            }
        }
    }
}
