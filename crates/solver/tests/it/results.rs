//! Quantities derived from states: energies, violations, subsurface stresses.

use carom_halfspace::{Grid, Material, MaterialPair, Point};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    ContactProblem, ContactState, Drive, Frictional, Gap, Method as _, StoredEnergy, Subsurface,
    dissipated, violations,
};
use serde_json::Value;

fn follow(problem: &ContactProblem, path: &[Shift]) -> Vec<ContactState> {
    let method = Frictional::default();
    let mut scratch = method.scratch(problem).unwrap();
    let mut states = vec![ContactState::apart(problem.grid())];
    for to in path {
        let before = states[states.len() - 1].clone();
        let mut state = before.clone();
        let drive = Drive::by_shift(*to);
        method.step(problem, &before, &drive, &mut state, &mut scratch, &mut ()).unwrap();
        states.push(state);
    }
    states
}

fn problem(poisson: [f64; 2], cells: usize) -> ContactProblem {
    let [one, two] = poisson.map(|nu| Material::from_shear(1.0, nu).unwrap());
    let width = 2.4 / cells as f64;
    let gap = Gap::from_function(Grid::new(cells, cells, width, width).unwrap(), |x, y| {
        0.5 * (x * x + y * y)
    });
    let pair = MaterialPair::new(one, two).unwrap();
    ContactProblem::of_half_spaces(gap.unwrap(), pair, Friction::new(0.4).unwrap()).unwrap()
}

/// Pressed, then shifted forwards, backwards and forwards: Mindlin's loop.
fn path(steps: usize) -> Vec<Shift> {
    let at = |zeta: f64, xi: f64| Shift { zeta, xi, ..Shift::default() };
    let leg =
        |from: f64, to: f64| (1..=steps).map(move |i| from + (to - from) * i as f64 / steps as f64);
    let mut path: Vec<Shift> = leg(0.0, 1.0).map(|zeta| at(zeta, 0.0)).collect();
    for (from, to) in [(0.0, 0.3), (0.3, -0.3), (-0.3, 0.3)] {
        path.extend(leg(from, to).map(|xi| at(1.0, xi)));
    }
    path
}

#[test]
fn work_is_stored_or_turns_into_heat() {
    for poisson in [[0.0, 0.0], [0.0, 0.5]] {
        let balance = |steps: usize| {
            let problem = problem(poisson, 32);
            let states = follow(&problem, &path(steps));
            let (mut work, mut heat) = (0.0, 0.0);
            for pair in states.windows(2) {
                let (a, b) = (pair[0].load(), pair[1].load());
                let (from, to) = (pair[0].shift, pair[1].shift);
                work += 0.5 * ((a.f_z + b.f_z) * (to.zeta - from.zeta));
                work += 0.5 * ((a.f_x + b.f_x) * (to.xi - from.xi));
                let cells = dissipated(&pair[0], &pair[1]);
                assert!(cells.values().iter().all(|heat| *heat > -1e-9), "{poisson:?}");
                heat += cells.values().iter().sum::<f64>();
            }
            let stored = StoredEnergy::of(&problem, &states[states.len() - 1]).unwrap().total();
            (work - stored - heat).abs() / heat
        };
        let (coarse, fine) = (balance(5), balance(20));
        assert!(fine < 0.03 && fine < 0.35 * coarse, "{poisson:?}: {coarse} {fine}");
    }
}

#[test]
fn the_heat_of_a_loop_is_mindlins() {
    let problem = problem([0.0, 0.0], 48);
    let states = follow(&problem, &path(20));
    let loop_heat: f64 = states[40..]
        .windows(2)
        .map(|pair| dissipated(&pair[0], &pair[1]).values().iter().sum::<f64>())
        .sum();
    // F = f F_z (1 - (1 - s/(f zeta))^(3/2)) on the first leg, Masing's rule after that: a closed
    // loop of amplitude s dissipates 8 int_0^s F - 4 s F(s).
    let (f_z, x) = (4.0 / 3.0, 0.3 / 0.4_f64);
    let limit = 0.4 * f_z;
    let force = limit * (1.0 - (1.0 - x).powf(1.5));
    let area = limit * 0.4 * (x + 0.4 * ((1.0 - x).powf(2.5) - 1.0));
    let exact = 8.0 * area - 4.0 * 0.3 * force;
    assert!((loop_heat / exact - 1.0).abs() < 0.05, "{loop_heat} {exact}");
}

#[test]
fn converged_states_violate_nothing() {
    for poisson in [[0.0, 0.0], [0.1, 0.45]] {
        let problem = problem(poisson, 24);
        let mut path = path(3);
        path.push(Shift { zeta: 0.7, xi: 0.1, eta: 0.2, omega: -0.1 });
        let states = follow(&problem, &path);
        for pair in states.windows(2) {
            let left = violations(&problem, &pair[0], &pair[1]).unwrap();
            assert!(left.normal < 2e-9 && left.tangential < 2e-9, "{left:?}");
        }
        // The violations of a wrong state are found.
        let mut wrong = states[3].clone();
        wrong.traction_x.values_mut()[24 * 12 + 12] += 0.01;
        wrong.pressure.values_mut()[24 * 12 + 12] *= 1.01;
        let left = violations(&problem, &states[2], &wrong).unwrap();
        assert!(left.normal > 1e-4 && left.tangential > 1e-3, "{left:?}");
    }
}

#[test]
fn stresses_below_are_those_of_an_independent_program() {
    let all: Value = serde_json::from_str(include_str!("../data/same_grid.json")).unwrap();
    let case = &all["cases"]["c1"]["inputs"];
    let number = |value: &Value, key: &str| value[key].as_f64().unwrap();
    let grid = &case["grid"];
    let count = |key: &str| grid[key].as_u64().unwrap() as usize;
    let grid =
        Grid::new(count("columns"), count("rows"), number(grid, "dx"), number(grid, "dy")).unwrap();
    let body = |key: &str| {
        Material::from_shear(number(&case[key], "G"), number(&case[key], "nu")).unwrap()
    };
    let bodies = [body("body1"), body("body2")];
    let pair = MaterialPair::new(bodies[0], bodies[1]).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.005 * (x * x + y * y)).unwrap();
    let friction = Friction::new(number(case, "friction")).unwrap();
    let problem = ContactProblem::of_half_spaces(gap, pair, friction).unwrap();
    let mut shift = Shift::default();
    let steps = all["cases"]["c1"]["steps"].as_array().unwrap();
    let path: Vec<Shift> = steps[..2]
        .iter()
        .map(|step| {
            shift.zeta = number(step, "approach_given");
            shift.xi += number(step, "dxi");
            shift.eta += number(step, "deta");
            shift
        })
        .collect();
    let states = follow(&problem, &path);
    let below = [
        ("points_body1", Subsurface::of_body_1(&states[2], bodies[0]).unwrap()),
        ("points_body2", Subsurface::of_body_2(&states[2], bodies[1]).unwrap()),
    ];
    for (key, body) in below {
        for point in all["cases"]["c9"][key].as_array().unwrap() {
            let at = Point { x: number(point, "x"), y: number(point, "y"), z: number(point, "z") };
            let stress = body.stress(at).unwrap();
            let moved = body.displacement(at).unwrap();
            assert_eq!(body.along_normal(at.x, at.y, [at.z.abs()]).unwrap(), [stress]);
            // Six digits are given, of stresses up to 700 and of displacements in common axes.
            let pairs = [
                (stress.xx, "sxx"),
                (stress.yy, "syy"),
                (stress.zz, "szz"),
                (stress.xy, "sxy"),
                (stress.yz, "syz"),
                (stress.zx, "sxz"),
                (stress.mean(), "mean_stress"),
                (stress.von_mises(), "von_mises"),
            ];
            for (found, name) in pairs {
                assert!((found - number(point, name)).abs() < 7e-4, "{key} {name} {found} {point}");
            }
            for (found, name) in [(moved.u, "ux"), (moved.v, "uy"), (moved.w, "uz")] {
                assert!((found - number(point, name)).abs() < 1e-7, "{key} {name} {found} {point}");
            }
        }
    }
}
