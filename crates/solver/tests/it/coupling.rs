//! Strong coupling of pressures and tractions: friction times gamma of half and beyond.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{ContactProblem, ContactState, Drive, Frictional, Gap, Method as _};

fn problem(n: usize, poisson: f64, friction: f64) -> ContactProblem {
    let grid = Grid::new(n, n, 2.3 / n as f64, 2.3 / n as f64).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
    let soft = Material::from_shear(1.0, poisson).unwrap();
    let pair = MaterialPair::new(soft, Material::RIGID).unwrap();
    ContactProblem::of_half_spaces(gap, pair, Friction::new(friction).unwrap()).unwrap()
}

const HISTORY: [[f64; 4]; 5] = [
    [1.0, 0.0, 0.0, 0.0],
    [1.0, 0.2, 0.0, 0.0],
    [0.9, 0.4, 0.2, 0.1],
    [1.0, 0.1, -0.1, -0.2],
    [0.7, -0.5, 0.0, 0.0],
];

/// Passes of each step, from the number of coupling products: two per pass and one at the start.
/// After 35 passes Newton's method takes over; each of its products counts like a pass but costs a
/// tenth.
fn passes(poisson: f64, friction: f64) -> Vec<f64> {
    let problem = problem(48, poisson, friction);
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let mut state = ContactState::apart(problem.grid());
    let steps = HISTORY.map(|[zeta, xi, eta, omega]| {
        let (from, drive) = (state.clone(), Drive::by_shift(Shift { zeta, xi, eta, omega }));
        let went = method.step(&problem, &from, &drive, &mut state, &mut scratch, &mut ());
        let went = went.unwrap_or_else(|error| panic!("nu = {poisson}, f = {friction}: {error}"));
        assert!(went.residuals.normal <= 1e-9 && went.residuals.tangential <= 1e-9);
        (went.products.coupling - 1.0) / 2.0
    });
    steps.to_vec()
}

#[test]
fn passes_settle_whatever_friction_times_gamma_is() {
    for poisson in [0.0, -0.8_f64] {
        let gamma = (1.0 - 2.0 * poisson) / (2.0 - 2.0 * poisson);
        for (product, most) in [(0.1, 14.0), (0.5, 25.0), (1.0, 35.0), (2.0, 110.0)] {
            let passes = passes(poisson, product / gamma);
            println!("gamma {gamma:.3} f gamma {product}: {passes:?}");
            assert!(passes.iter().all(|passes| *passes <= most), "{passes:?}");
        }
    }
}
