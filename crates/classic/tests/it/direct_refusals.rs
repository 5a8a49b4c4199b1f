//! The methods of chapters 11 and 12 return errors for problems that they cannot solve.

use std::sync::Arc;

use carom_classic::DirectError;
use carom_classic::jaeger::{DiscGaussSeidel, GaussSeidel, Most};
use carom_classic::kalker::{Johnson, KalkerScratch, Kombi, Panagiotopoulos};
use carom_classic::theory::{ContactArea, TheoryError};
use carom_halfspace::operator::{OperatorError, Plate, PlateOperator, PlateSymbol, Threads};
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellFriction, ContactProblem, ContactState, Drive, Driven, Gap, Method, Stop, SurfaceFriction,
};

fn problem(poisson: [f64; 2], friction: impl Into<SurfaceFriction>) -> ContactProblem {
    let grid = Grid::new(8, 8, 0.28, 0.28).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
    let [one, two] = poisson.map(|nu| Material::from_shear(1.0, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    ContactProblem::of_half_spaces(gap, pair, friction).unwrap()
}

fn f(friction: f64) -> Friction {
    Friction::new(friction).unwrap()
}

fn refusal<M: Method<Error = DirectError>>(
    method: &M,
    problem: &ContactProblem,
    drive: &Drive,
) -> DirectError {
    let apart = ContactState::apart(problem.grid());
    let mut to = apart.clone();
    let step = |mut scratch| method.step(problem, &apart, drive, &mut to, &mut scratch, &mut ());
    method.scratch(problem).and_then(step).unwrap_err()
}

#[test]
fn johnson_takes_similar_bodies_only_and_names_who_takes_others() {
    let problem = problem([0.0, 0.5], f(0.3));
    let error = refusal(&Johnson::default(), &problem, &Drive::default());
    assert_eq!(error, DirectError::Coupled { method: "Johnson" });
    assert!(error.to_string().contains("Panagiotopoulos, Kombi"), "{error}");
}

#[test]
fn loads_two_frictions_and_numbers_that_are_none_are_refused_by_all() {
    let one = problem([0.3, 0.3], f(0.3));
    // One cell, the last, has two.
    let mut cells = Field::uniform(one.grid(), CellFriction::from(f(0.3)));
    cells.values_mut()[63] = CellFriction::new(f(0.4), f(0.3)).unwrap();
    let two = problem([0.3, 0.3], SurfaceFriction::ByCell(cells));
    let pressed = Drive::by_shift(Shift { zeta: 1.0, ..Shift::default() });
    let load = Driven::Load(0.1);
    let loaded = [
        ("F_z", Drive { normal: load, ..pressed }),
        ("F_x", Drive { x: load, ..pressed }),
        ("F_y", Drive { y: load, ..pressed }),
        ("M_z", Drive { twist: load, ..pressed }),
    ];
    let broken = Drive { x: Driven::Shift(f64::NAN), ..pressed };
    fn all<M: Method<Error = DirectError>>(
        method: &M,
        [one, two]: [&ContactProblem; 2],
        [pressed, broken]: [&Drive; 2],
        loaded: &[(&'static str, Drive); 4],
    ) {
        for (load, drive) in loaded {
            assert_eq!(refusal(method, one, drive), DirectError::GivenLoad { load });
        }
        let error = refusal(method, two, pressed);
        assert_eq!(error, DirectError::TwoFrictions { rest: 0.4, motion: 0.3 });
        assert!(matches!(refusal(method, one, broken), DirectError::Range(e) if e.field == "xi"));
    }
    let (problems, drives) = ([&one, &two], [&pressed, &broken]);
    all(&GaussSeidel::default(), problems, drives, &loaded);
    all(&DiscGaussSeidel::default(), problems, drives, &loaded);
    all(&Johnson::default(), problems, drives, &loaded);
    all(&Panagiotopoulos::default(), problems, drives, &loaded);
    all(&Kombi::default(), problems, drives, &loaded);
}

#[test]
fn too_few_rounds_say_how_far_they_got() {
    let problem = problem([0.0, 0.5], f(0.3));
    let drive = Drive::by_shift(Shift { zeta: 1.0, xi: 0.1, ..Shift::default() });
    let most = Most { seidel: 2, contact: 1, slip: 1, stick: 1, program: 1 };
    for error in [
        refusal(&GaussSeidel::default().at_most(most), &problem, &drive),
        refusal(&DiscGaussSeidel::default().at_most(3), &problem, &drive),
        refusal(&Panagiotopoulos::default().at_most(40, 1), &problem, &drive),
        refusal(&Kombi::default().at_most(1), &problem, &drive),
    ] {
        let DirectError::NotConverged { reached, .. } = &error else { panic!("{error}") };
        assert!(reached.stop == Stop::Exhausted && reached.residuals.normal > 1e-10, "{error}");
    }
}

#[test]
fn parameters_have_ranges() {
    assert_eq!(GaussSeidel::default().over_relaxed(2.0).unwrap_err().field, "over-relaxation");
    for tolerance in [0.0, 1e-14, 0.1, f64::NAN] {
        assert_eq!(GaussSeidel::default().within(tolerance).unwrap_err().field, "tolerance");
        assert_eq!(Kombi::default().within(tolerance).unwrap_err().field, "tolerance");
        assert_eq!(DiscGaussSeidel::default().within(tolerance).unwrap_err().field, "tolerance");
        assert_eq!(Johnson::default().within(tolerance).unwrap_err().field, "tolerance");
        assert_eq!(Panagiotopoulos::default().within(tolerance).unwrap_err().field, "tolerance");
    }
}

#[test]
fn bodies_apart_need_no_iterations_and_no_friction_no_directions() {
    fn check<M: Method<Error = DirectError>>(method: &M) {
        let problem = problem([0.0, 0.5], f(0.0));
        let apart = ContactState::apart(problem.grid());
        let mut scratch = method.scratch(&problem).unwrap();
        let (mut state, mut step) = (apart.clone(), |zeta, to: &mut ContactState| {
            let drive = Drive::by_shift(Shift { zeta, xi: 0.1, ..Shift::default() });
            method.step(&problem, &apart, &drive, to, &mut scratch, &mut ()).unwrap()
        });
        assert_eq!(step(-1.0, &mut state).iterations, 0);
        step(1.0, &mut state);
        let load = state.load();
        assert!(load.f_z > 1.0 && load.f_x == 0.0 && load.f_y == 0.0);
    }
    check(&GaussSeidel::default());
    check(&DiscGaussSeidel::default());
    check(&Panagiotopoulos::default());
    check(&Kombi::default());
}

/// The influence on a plate is not a function of the offset: every method that tabulates it
/// refuses.
#[test]
fn plates_are_refused() {
    let plate = Plate::new(1.0, 1.0, 0.1).unwrap();
    let pane = Material::from_young(1.0, 0.3).unwrap();
    let pair = MaterialPair::new(Material::RIGID, pane).unwrap();
    let grid = plate.grid(8, 8).unwrap();
    let operator = PlateOperator::new(pair, plate, grid, PlateSymbol::Layer, Threads::One).unwrap();
    let area = ContactArea::new(&operator, &Field::uniform(grid, true));
    assert_eq!(area.err(), Some(TheoryError::Operator(OperatorError::NotInvariant)));
    let gap = Gap::sphere(grid, 1.0).unwrap();
    let problem = ContactProblem::new(gap, Arc::new(operator), Friction::new(0.3).unwrap());
    let problem = problem.unwrap();
    let refused = Some(DirectError::Operator(OperatorError::NotInvariant));
    assert_eq!(GaussSeidel::default().scratch(&problem).err(), refused);
    assert_eq!(DiscGaussSeidel::default().scratch(&problem).err(), refused);
    assert_eq!(Johnson::default().scratch(&problem).err(), refused);
    assert_eq!(Panagiotopoulos::default().scratch(&problem).err(), refused);
    assert_eq!(Kombi::default().scratch(&problem).err(), refused);
    assert_eq!(KalkerScratch::rolling(&problem, 0.5).err(), refused);
}
