//! Comparison with load histories of an independent program (another method, same discretisation):
//! loads, stick areas and tractions.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellState, ContactProblem, ContactState, Convergence, Drive, Frictional, Gap, Method as _,
};
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The states and the convergence after each step.
struct History {
    states: Vec<ContactState>,
    went: Vec<Convergence>,
}

fn gap(case: &Value, grid: Grid) -> Gap {
    let spec = &case["spec"];
    let (a, b) = (number(&spec["a"]), number(&spec["b"]));
    if spec["shape"] == "flat_ellipse" {
        let inside = |x: f64, y: f64| (x / a).powi(2) + (y / b).powi(2) < 1.0;
        let height = |x, y| if inside(x, y) { 0.0 } else { f64::INFINITY };
        return Gap::from_function(grid, height).unwrap();
    }
    let (big_a, big_b) = (number(&case["hertz"]["A"]), number(&case["hertz"]["B"]));
    Gap::from_function(grid, |x, y| big_a * x * x + big_b * y * y).unwrap()
}

fn problem(case: &Value, finest: usize) -> ContactProblem {
    let spec = &case["spec"];
    let (a, b) = (number(&spec["a"]), number(&spec["b"]));
    let grids = case["grids"].as_array().unwrap();
    let size = grids[grids.len() - 1 - finest].as_array().unwrap();
    let (nx, ny) = (size[0].as_u64().unwrap(), size[1].as_u64().unwrap());
    let grid =
        Grid::new(nx as usize, ny as usize, 2.0 * a / nx as f64, 2.0 * b / ny as f64).unwrap();
    let body = |i: u32| {
        let value = |name: &str| number(&spec[format!("{name}{i}")]);
        Material::from_shear(value("G"), value("nu")).unwrap()
    };
    let pair = MaterialPair::new(body(1), body(2)).unwrap();
    let friction = Friction::new(number(&spec["f"])).unwrap();
    ContactProblem::of_half_spaces(gap(case, grid), pair, friction).unwrap()
}

fn follow(case: &Value, finest: usize) -> History {
    let problem = problem(case, finest);
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let mut state = ContactState::apart(problem.grid());
    let (mut states, mut went) = (Vec::new(), Vec::new());
    for row in case["spec"]["history"].as_array().unwrap() {
        let [zeta, xi, eta, omega] = [0, 1, 2, 3].map(|i| number(&row[i]));
        let drive = Drive::by_shift(Shift { zeta, xi, eta, omega });
        let before = state.clone();
        let step = method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ());
        went.push(step.unwrap_or_else(|error| panic!("step {}: {error}", went.len() + 1)));
        states.push(state.clone());
    }
    History { states, went }
}

/// On the grid of the reference only its convergence error of 1e-7 to 1e-8 remains.
#[test]
fn loads_stick_areas_and_tractions_agree() {
    let all: Value = serde_json::from_str(include_str!("../data/histories.json")).unwrap();
    let cases = all["cases"].as_object().unwrap();
    assert_eq!(cases.len(), 17);
    for (name, case) in cases {
        let history = follow(case, 0);
        for want in case["steps"].as_array().unwrap() {
            let at = want["step"].as_u64().unwrap() as usize - 1;
            let (state, load) = (&history.states[at], history.states[at].load());
            let loads = [(load.f_x, "Fx"), (load.f_y, "Fy"), (load.f_z, "Fz"), (-load.m_z, "Mz")];
            for (got, key) in loads {
                let error = (got - number(&want[key])).abs();
                // A hundredth of the discretisation error.
                let bar = 0.01 * number(&want[format!("{key}_err")]);
                assert!(error <= bar, "{name} {} {key}: {got} {} +- {bar}", at + 1, want[key]);
            }
            let (stick, slip) = (state.count(CellState::Stick), state.count(CellState::Slip));
            let part = stick as f64 / (stick + slip) as f64;
            let error = (part - number(&want["stick"])).abs();
            // Some cells at the border of the stick area are within the tolerance of the reference.
            let bar = (1.0 / (stick + slip) as f64).max(0.1 * number(&want["stick_err"]));
            assert!(error <= bar, "{name} {}: {part} {}", at + 1, want["stick"]);
        }
        let tangential: f64 = history.went.iter().map(|went| went.products.tangential).sum();
        let mean = tangential / history.went.len() as f64;
        println!("{name}: {mean:.1} tangential products a step");
        assert!(mean < 80.0, "{name}: {mean}");
    }
}
