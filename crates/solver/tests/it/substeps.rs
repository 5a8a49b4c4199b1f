//! Steps that are halved until their loads settle, against many equal ones.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    ContactProblem, ContactState, Drive, Frictional, FrictionalError, Gap, Method as _,
    SubstepError, Substepped,
};

fn problem(friction: f64) -> ContactProblem {
    let grid = Grid::new(28, 28, 0.08, 0.08).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
    let soft = Material::from_shear(1.0, 0.2).unwrap();
    let pair = MaterialPair::new(soft, Material::RIGID).unwrap();
    ContactProblem::of_half_spaces(gap, pair, Friction::new(friction).unwrap()).unwrap()
}

/// Pressing and pulling at once depends on the way: one step is far from the truth.
#[test]
fn halved_steps_reach_the_loads_of_many() {
    let problem = problem(0.5);
    let method = Frictional::default().within(1e-7).unwrap();
    let mut scratch = method.scratch(&problem).unwrap();
    let start = Shift { zeta: 0.2, ..Shift::default() };
    let end = Shift { zeta: 1.0, xi: 0.15, eta: -0.05, omega: 0.05 };
    let mut first = ContactState::apart(problem.grid());
    let drive = Drive::by_shift(start);
    method.step(&problem, &first.clone(), &drive, &mut first, &mut scratch, &mut ()).unwrap();
    let mut many = |count: u32| {
        let mut state = first.clone();
        for step in 1..=count {
            let part = f64::from(step) / f64::from(count);
            let at = |a: f64, b: f64| a + part * (b - a);
            let drive = Drive::by_shift(Shift {
                zeta: at(start.zeta, end.zeta),
                xi: at(start.xi, end.xi),
                eta: at(start.eta, end.eta),
                omega: at(start.omega, end.omega),
            });
            method
                .step(&problem, &state.clone(), &drive, &mut state, &mut scratch, &mut ())
                .unwrap();
        }
        state.load()
    };
    let (one, all) = (many(1), many(256));
    let divided = Substepped::new(method, 2e-3).unwrap();
    let mut state = first.clone();
    let mut scratch = divided.scratch(&problem).unwrap();
    let drive = Drive::by_shift(end);
    divided.step(&problem, &first, &drive, &mut state, &mut scratch, &mut ()).unwrap();
    let load = state.load();
    println!("one {one:?}\nall {all:?}\ngot {load:?}");
    assert!((one.m_z - all.m_z).abs() > 5e-3 * all.f_z);
    assert!((load.m_z - all.m_z).abs() < 1e-3 * all.f_z);
    assert!((load.f_x - all.f_x).abs() < 1e-3 * all.f_z);
    assert!((load.f_z - all.f_z).abs() < 1e-3 * all.f_z);
}

#[test]
fn what_cannot_be_divided_says_so() {
    let problem = problem(0.5);
    let apart = ContactState::apart(problem.grid());
    let run = |method: Substepped<Frictional>, drive: Drive| {
        let (mut to, mut scratch) = (apart.clone(), method.scratch(&problem).unwrap());
        method.step(&problem, &apart, &drive, &mut to, &mut scratch, &mut ())
    };
    let drive = Drive::by_shift(Shift { zeta: 1.0, xi: 0.3, ..Shift::default() });
    let method = Frictional::default();
    let error = run(Substepped::new(method, 1e-9).unwrap().at_most(2), drive).unwrap_err();
    assert!(matches!(error, SubstepError::Unsettled { halvings: 2, .. }), "{error}");
    let error = run(Substepped::new(method.at_most(1, 9), 1.0).unwrap().at_most(3), drive);
    let error = error.unwrap_err();
    assert!(matches!(error, SubstepError::Step(FrictionalError::NotConverged { .. })), "{error}");
    assert_eq!(Substepped::new(method, f64::NAN).unwrap_err().field, "tolerance");
    assert!(run(Substepped::new(method, f64::INFINITY).unwrap(), drive).is_ok());
}
