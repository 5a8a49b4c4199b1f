//! Driving motions by loads is the inverse of driving them by shifts.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictional, FrictionalError, Gap,
    Method as _,
};

fn problem(n: usize, friction: f64, poisson: [f64; 2]) -> ContactProblem {
    let width = 2.4 / n as f64;
    let grid = Grid::new(n, n + 2, width, width).unwrap();
    let [one, two] = poisson.map(|nu| Material::from_shear(2.0, nu).unwrap());
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
    let pair = MaterialPair::new(one, two).unwrap();
    ContactProblem::of_half_spaces(gap, pair, Friction::new(friction).unwrap()).unwrap()
}

const HISTORY: [[f64; 4]; 6] = [
    [1.0, 0.0, 0.0, 0.0],
    [1.0, 0.15, 0.05, 0.0],
    [0.9, 0.1, 0.1, 0.1],
    [1.0, -0.05, 0.1, 0.1],
    [0.8, -0.05, 0.0, -0.1],
    [1.1, 0.0, 0.0, 0.0],
];

fn driven(shift: bool, value: f64, load: f64) -> Driven {
    if shift { Driven::Shift(value) } else { Driven::Load(load) }
}

/// Follows the history by shifts, and again with some motions driven by the resulting loads.
fn compare(problem: &ContactProblem, by_shift: [bool; 4]) {
    let method = Frictional::default();
    let mut scratch = method.scratch(problem).unwrap();
    let mut one = ContactState::apart(problem.grid());
    let mut other = one.clone();
    for (step, [zeta, xi, eta, omega]) in HISTORY.into_iter().enumerate() {
        let before = one.clone();
        let drive = Drive::by_shift(Shift { zeta, xi, eta, omega });
        let want = method.step(problem, &before, &drive, &mut one, &mut scratch, &mut ()).unwrap();
        let load = one.load();
        let drive = Drive {
            normal: driven(by_shift[0], zeta, load.f_z),
            x: driven(by_shift[1], xi, load.f_x),
            y: driven(by_shift[2], eta, load.f_y),
            twist: driven(by_shift[3], omega, load.m_z),
        };
        let before = other.clone();
        let got = method
            .step(problem, &before, &drive, &mut other, &mut scratch, &mut ())
            .unwrap_or_else(|error| panic!("{by_shift:?} step {step}: {error}"));
        println!(
            "{by_shift:?} {step}: T {:.1} {:.1} N {:.1} {:.1}",
            want.products.tangential,
            got.products.tangential,
            want.products.normal,
            got.products.normal
        );
        let (a, b) = (one.shift, other.shift);
        for (a, b) in [(a.zeta, b.zeta), (a.xi, b.xi), (a.eta, b.eta), (a.omega, b.omega)] {
            assert!((a - b).abs() < 2e-7, "{by_shift:?} step {step}: {a} {b}");
        }
        let (a, b) = (one.load(), other.load());
        for (a, b) in [(a.f_x, b.f_x), (a.f_y, b.f_y), (a.f_z, b.f_z), (a.m_z, b.m_z)] {
            assert!((a - b).abs() < 1e-6 * load.f_z, "{by_shift:?} step {step}: {a} {b}");
        }
    }
}

#[test]
fn any_mix_of_shifts_and_loads_follows_the_same_history() {
    for poisson in [[0.3, 0.3], [0.0, 0.45]] {
        let problem = problem(32, 0.4, poisson);
        for mix in 0..16 {
            compare(&problem, [0, 1, 2, 3].map(|bit| mix & (1 << bit) == 0));
        }
    }
}

#[test]
fn a_force_beyond_friction_slides() {
    let problem = problem(32, 0.3, [0.3, 0.3]);
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let mut to = apart.clone();
    let mut pull = |part: f64| {
        let (normal, x) = (Driven::Load(1.0), Driven::Load(0.3 * part));
        let drive = Drive { normal, x, ..Drive::default() };
        let went = method.step(&problem, &apart, &drive, &mut to, &mut scratch, &mut ());
        (went, to.clone())
    };
    let mut last = 0.0;
    for part in [0.1, 0.5, 0.9, 0.99, 0.999] {
        let (went, state) = pull(part);
        went.unwrap();
        assert!((state.load().f_x - 0.3 * part).abs() < 1e-9);
        assert!(state.shift.xi > last && state.count(CellState::Stick) > 0);
        last = state.shift.xi;
    }
    for part in [1.0, 1.5] {
        let (went, _) = pull(part);
        let error = went.unwrap_err();
        assert!(matches!(error, FrictionalError::Slides { .. }), "{error}");
        assert!(error.to_string().ends_with("the friction limit 0.3: the bodies slide"), "{error}");
    }
    // A torque above the friction limit.
    let drive = Drive { normal: Driven::Load(1.0), twist: Driven::Load(1.0), ..Drive::default() };
    let went = method.step(&problem, &apart, &drive, &mut to, &mut scratch, &mut ());
    assert!(matches!(went, Err(FrictionalError::Turns { .. })), "{went:?}");
}

/// Separated bodies hold neither a force nor a torque; a step that asks for one changes nothing.
#[test]
fn separated_bodies_hold_no_load() {
    let problem = problem(16, 0.3, [0.3, 0.3]);
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let mut to = apart.clone();
    let (normal, nothing) = (Driven::Shift(-1.0), Driven::Load(0.0));
    let free = Drive { normal, x: nothing, y: nothing, twist: nothing };
    let torque = Drive { twist: Driven::Load(-0.2), ..free };
    let error = method.step(&problem, &apart, &torque, &mut to, &mut scratch, &mut ()).unwrap_err();
    let FrictionalError::Turns { torque: -0.2, force: 0.0, part: 0.0 } = error else {
        panic!("{error}")
    };
    let force = Drive { x: Driven::Load(0.3), y: Driven::Load(-0.4), ..free };
    let error = method.step(&problem, &apart, &force, &mut to, &mut scratch, &mut ()).unwrap_err();
    let FrictionalError::Slides { force: 0.5, limit: 0.0 } = error else { panic!("{error}") };
    assert_eq!(to, apart);
    method.step(&problem, &apart, &free, &mut to, &mut scratch, &mut ()).unwrap();
    assert_eq!(to.shift.zeta, -1.0);
}
