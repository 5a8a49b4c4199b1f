//! Frictionless contact compared with closed forms and with its own conditions.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use carom_halfspace::operator::{
    Blocks, DisplacementField, HalfSpaceOperator, Threads, TractionField,
};
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::ContactLoad;
use carom_solver::{
    CellState, ContactProblem, ContactState, Convergence, Drive, Driven, Frictional,
    FrictionalError, Frictionless, Gap, Method, NormalError, Progress, Stop,
};
use proptest::prelude::*;

fn pair() -> MaterialPair {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    MaterialPair::new(body, body).unwrap()
}

fn problem(gap: Gap) -> ContactProblem {
    ContactProblem::of_half_spaces(gap, pair(), Friction::NONE).unwrap()
}

fn pressed(normal: Driven) -> Drive {
    Drive { normal, ..Drive::default() }
}

fn solve(problem: &ContactProblem, normal: Driven) -> (ContactState, Convergence) {
    let method = Frictionless::default();
    let mut scratch = method.scratch(problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let mut state = apart.clone();
    let convergence =
        method.step(problem, &apart, &pressed(normal), &mut state, &mut scratch, &mut ()).unwrap();
    (state, convergence)
}

/// The greatest violation of the contact conditions, from a product of the test itself.
fn violation(problem: &ContactProblem, state: &ContactState) -> f64 {
    let operator = problem.operator();
    let mut w = vec![0.0; problem.grid().cells()];
    let load = TractionField::normal(state.pressure.values());
    operator.apply(load, DisplacementField::normal(&mut w), &mut operator.workspace()).unwrap();
    let heights = problem.gap().heights().values();
    let gaps = w.iter().zip(heights).map(|(w, z)| w + z - state.shift.zeta);
    let wrong = gaps.zip(state.pressure.values()).map(|(gap, p)| {
        assert!(*p >= 0.0);
        if *p > 0.0 { gap.abs() } else { (-gap).max(0.0) }
    });
    let greatest = wrong.fold(0.0, f64::max);
    greatest / w.iter().copied().fold(0.0, f64::max)
}

#[test]
fn hertz_by_approach_and_by_force() {
    for (a, b) in [(0.5, 0.5), (0.9, 0.3)] {
        let curvature = RelativeCurvature::from_coefficients(a, b).unwrap();
        let hertz = Hertz::new(curvature, pair()).unwrap();
        let ellipse = hertz.ellipse(1.0).unwrap();
        let exact = 2.0 / 3.0 * hertz.stiffness().c_z;
        let peak = 1.5 * exact / (PI * ellipse.semi_axis_a() * ellipse.semi_axis_b());
        for n in [64, 128, 256] {
            let width = |semi_axis: f64| 2.4 * semi_axis / n as f64;
            let grid = Grid::new(n, n, width(ellipse.semi_axis_a()), width(ellipse.semi_axis_b()))
                .unwrap();
            let problem = problem(Gap::of_curvature(grid, &curvature));
            let bound = 0.6 / (n * n) as f64;
            let (state, by_approach) = solve(&problem, Driven::Shift(1.0));
            let error = state.load().f_z / exact - 1.0;
            assert!(error > 0.0 && error < bound, "{n}: {error:e}");
            // The centres of the four central cells lie half a cell from the centre.
            let top = state.pressure.get(n / 2, n / 2).unwrap() / peak;
            assert!((top - 1.0).abs() < 3.0 / (n * n) as f64, "{n}: {top}");
            assert!(violation(&problem, &state) < 2e-10);
            let (state, by_force) = solve(&problem, Driven::Load(exact));
            assert!((state.load().f_z / exact - 1.0).abs() < 1e-13);
            let error = state.shift.zeta - 1.0;
            assert!(error < 0.0 && -error < bound, "{n}: {error:e}");
            assert!(violation(&problem, &state) < 2e-10);
            println!("{a} {n}: {:?}\n{:?}", by_approach.products, by_force.products);
            assert!(by_approach.products.normal <= 28.0 && by_force.products.normal <= 23.0);
        }
    }
}

#[test]
fn a_flat_round_punch() {
    // F = 2 G a zeta/(1 - nu) for a combined modulus; border cells make the square slightly
    // smaller.
    let error = |n: usize| {
        let width = 2.2 / n as f64;
        let grid = Grid::new(n, n, width, width).unwrap();
        let punch = |x: f64, y: f64| if x.hypot(y) <= 1.0 { 0.0 } else { f64::INFINITY };
        let problem = problem(Gap::from_function(grid, punch).unwrap());
        let (state, convergence) = solve(&problem, Driven::Shift(0.01));
        println!("{n} {:?}", convergence.products);
        assert!(convergence.products.normal <= 20.0);
        assert_eq!(state.count(CellState::Slip), problem_cells(&problem));
        assert!(violation(&problem, &state) < 2e-10);
        let stiffness = 4.0 * pair().shear_modulus() / (1.0 - pair().poisson());
        // The cells that represent the disc have an area of their own.
        let area = state.count(CellState::Slip) as f64 * grid.cell_area();
        state.load().f_z / (stiffness * (area / PI).sqrt() * 0.01) - 1.0
    };
    let (coarse, fine) = (error(64), error(128));
    assert!(coarse.abs() < 0.02 && fine.abs() < 0.01, "{coarse} {fine}");
}

fn problem_cells(problem: &ContactProblem) -> usize {
    problem.gap().heights().values().iter().filter(|z| z.is_finite()).count()
}

#[test]
fn a_body_apart_has_no_load() {
    let grid = Grid::new(20, 20, 0.1, 0.1).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 + x * x + y * y).unwrap();
    let problem = problem(gap);
    let lowest = problem.gap().heights().values().iter().copied().fold(f64::INFINITY, f64::min);
    assert!((lowest - 0.505).abs() < 1e-15);
    for approach in [-1.0, 0.0, lowest] {
        let (state, _) = solve(&problem, Driven::Shift(approach));
        assert_eq!((state.load(), state.shift.zeta), (ContactLoad::default(), approach));
    }
    let (state, _) = solve(&problem, Driven::Load(0.0));
    assert!((state.shift.zeta - lowest).abs() < 1e-15);
    // One cell of four is in contact first, then all.
    let (state, _) = solve(&problem, Driven::Shift(lowest * (1.0 + 1e-12)));
    assert!(state.load().f_z > 0.0 && state.count(CellState::Slip) >= 1);
}

#[test]
fn what_cannot_be_solved_says_so() {
    let grid = Grid::new(40, 40, 0.06, 0.06).unwrap();
    let curvature = RelativeCurvature::from_coefficients(0.5, 0.5).unwrap();
    let gap = Gap::of_curvature(grid, &curvature);
    let rough = ContactProblem::of_half_spaces(gap.clone(), pair(), Friction::new(0.3).unwrap());
    let method = Frictionless::default();
    assert!(matches!(method.scratch(&rough.unwrap()), Err(NormalError::Friction)));
    let problem = problem(gap);
    let mut scratch = method.scratch(&problem).unwrap();
    let apart = ContactState::apart(grid);
    let mut to = apart.clone();
    let mut run = |method: Frictionless, drive: Drive| {
        method.step(&problem, &apart, &drive, &mut to, &mut scratch, &mut ()).unwrap_err()
    };
    let text = run(method, pressed(Driven::Shift(f64::NAN))).to_string();
    assert!(text.contains("zeta = NaN"), "{text}");
    let text =
        run(method, Drive { x: Driven::Load(1.0), ..pressed(Driven::Load(1.0)) }).to_string();
    assert_eq!(text, "F_x = 1 is out of range: must be 0 without friction");
    let error = run(method.at_most(2), pressed(Driven::Shift(1.0)));
    let NormalError::NotConverged { reached, .. } = &error else { panic!("{error}") };
    assert_eq!((reached.stop, reached.iterations), (Stop::Exhausted, 2));
    assert!(error.to_string().contains("after 2 iterations"), "{error}");
    let other = ContactState::apart(Grid::new(40, 41, 0.06, 0.06).unwrap());
    let drive = pressed(Driven::Shift(1.0));
    let error = method.step(&problem, &other, &drive, &mut to, &mut scratch, &mut ());
    assert!(error.unwrap_err().to_string().starts_with("pressure = 1640"));
    // An observer follows the residual and may end the iteration.
    let mut seen = Vec::new();
    let mut observer = |progress: &Progress| {
        seen.push(progress.residuals.normal);
        if seen.len() < 4 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let error = method.step(&problem, &apart, &drive, &mut to, &mut scratch, &mut observer);
    assert!(matches!(
        error,
        Err(NormalError::NotConverged { reached: Convergence { stop: Stop::Observer, .. }, .. })
    ));
    assert!(seen.len() == 4 && seen[3] < seen[0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// Random bumps: contact conditions, force and approach as inverse functions of each other,
    /// scaling.
    #[test]
    fn random_surfaces_touch_without_overlap(
        size in (8..70_usize, 8..70_usize),
        widths in (0.02..0.5_f64, 0.02..0.5_f64),
        bumps in prop::collection::vec((-1.0..1.0_f64, -1.0..1.0_f64, 0.0..1.0_f64), 1..20),
        depth in 1e-3..2.0_f64,
        scale in -12.0..12.0_f64,
    ) {
        let grid = Grid::new(size.0, size.1, widths.0, widths.1).unwrap();
        let (lx, ly) = (0.5 * widths.0 * size.0 as f64, 0.5 * widths.1 * size.1 as f64);
        let height = |x: f64, y: f64| {
            bumps.iter().map(|(bx, by, z)| {
                let (x, y) = (x - bx * lx, y - by * ly);
                z + 2.0 * (x * x + y * y)
            }).fold(f64::INFINITY, f64::min)
        };
        let problem = problem(Gap::from_function(grid, height).unwrap());
        let lowest = problem.gap().heights().values().iter().copied().fold(f64::INFINITY, f64::min);
        let (state, _) = solve(&problem, Driven::Shift(lowest + depth));
        prop_assert!(violation(&problem, &state) < 2e-10);
        let force = state.load().f_z;
        let (again, _) = solve(&problem, Driven::Load(force));
        prop_assert!((again.shift.zeta - lowest - depth).abs() < 1e-8 * depth);
        // Heights and approach in another unit.
        let unit = 10.0_f64.powf(scale);
        let heights = problem.gap().heights().map(|z| unit * (z - lowest));
        let scaled = self::problem(Gap::new(heights).unwrap());
        let (large, _) = solve(&scaled, Driven::Shift(unit * depth));
        prop_assert!((large.load().f_z / (unit * force) - 1.0).abs() < 1e-8);
    }
}

#[test]
fn a_field_of_another_grid_is_no_gap_of_this_operator() {
    let grid = Grid::new(4, 6, 1.0, 1.0).unwrap();
    let turned = Grid::new(6, 4, 1.0, 1.0).unwrap();
    let flat = problem(Gap::new(Field::uniform(grid, 0.0)).unwrap());
    assert_eq!(flat.grid(), grid);
    assert!(ContactState::apart(turned).check_grid(grid).is_err());
}

#[test]
fn a_contact_of_one_cell_is_found_however_high_the_others_stand() {
    // Heights up to 1e8 above a contact that is pressed in by 1e-8.
    for (width, force) in [(2e4, 1e-12), (2e4, 1.0), (200.0, 1e-6)] {
        for cells in [49, 48, 64] {
            let grid = Grid::new(cells, cells, width / cells as f64, width / cells as f64).unwrap();
            let gap = Gap::from_function(grid, |x, y| 0.5 * ((x - 0.3) * (x - 0.3) + y * y));
            let problem = problem(gap.unwrap());
            let (state, _) = solve(&problem, Driven::Load(force));
            assert!((state.load().f_z / force - 1.0).abs() < 1e-12);
            assert!(violation(&problem, &state) < 1e-9);
        }
    }
}

/// Without friction and coupling the method for friction solves for pressures alone, on the window and
/// on a box around a small contact; an operator for pressures alone is enough.
#[test]
fn the_method_for_friction_solves_what_has_none() {
    for (cells, force) in [(40, 1.0), (128, 1e-3), (128, 1.0)] {
        let grid = Grid::new(cells, cells, 3.0 / cells as f64, 3.0 / cells as f64).unwrap();
        let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + 0.7 * y * y)).unwrap();
        let operator = HalfSpaceOperator::with_blocks(pair(), grid, Blocks::Normal, Threads::One);
        let operator = std::sync::Arc::new(operator.unwrap());
        let problem = ContactProblem::new(gap, operator, Friction::NONE).unwrap();
        let method = Frictional::default().within(1e-12).unwrap();
        let mut scratch = method.scratch(&problem).unwrap();
        let mut state = ContactState::apart(grid);
        for part in [1.0, 1.05, 0.4] {
            let drive =
                Drive { x: Driven::Shift(0.3 * part), ..pressed(Driven::Load(force * part)) };
            let from = state.clone();
            method.step(&problem, &from, &drive, &mut state, &mut scratch, &mut ()).unwrap();
            let (want, _) = solve(&problem, drive.normal);
            let greatest = want.pressure.values().iter().copied().fold(0.0, f64::max);
            let both = state.pressure.values().iter().zip(want.pressure.values());
            let off = both.map(|(got, want)| (got - want).abs()).fold(0.0, f64::max);
            assert!(off < 1e-8 * greatest, "{cells} {force} {part}: {off:e} of {greatest:e}");
            assert!((state.shift.zeta / want.shift.zeta - 1.0).abs() < 1e-10);
            assert_eq!((state.shift.xi, &state.cells), (0.3 * part, &want.cells));
            assert!(state.displacement_x.values().iter().all(|u| *u == 0.0));
        }
        let (from, kept) = (state.clone(), state.clone());
        let pulled = Drive { y: Driven::Load(-0.1), ..pressed(Driven::Load(force)) };
        let refused = method.step(&problem, &from, &pulled, &mut state, &mut scratch, &mut ());
        let slides = FrictionalError::Slides { force: 0.1, limit: 0.0 };
        assert_eq!(refused.unwrap_err().to_string(), slides.to_string());
        assert_eq!(state, kept);
    }
}
