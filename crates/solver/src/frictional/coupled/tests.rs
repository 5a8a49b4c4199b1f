//! Newton's method on pressures and tractions together finds what the alternation finds, from the pressures
//! without friction.

use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;

use super::*;
use crate::drive::{Drive, Driven};
use crate::friction::SurfaceFriction;
use crate::frictional::Frictional;
use crate::method::Method as _;
use crate::problem::ContactProblem;
use crate::state::{CellState, ContactState};
use crate::tangential::Rigid;

/// A body of nu = 0 on a rigid one: gamma = 0.5.
fn problem(friction: fn(f64, f64) -> f64) -> ContactProblem {
    let grid = Grid::new(16, 14, 0.15, 0.16).unwrap();
    let pair = MaterialPair::new(Material::from_shear(1.0, 0.0).unwrap(), Material::RIGID).unwrap();
    let gap = crate::gap::Gap::from_function(grid, |x, y| 0.5 * x * x + 0.6 * y * y).unwrap();
    let cells = Field::from_function(grid, friction);
    let cells = cells.values().iter().map(|f| Friction::new(*f).unwrap().into()).collect();
    let friction = SurfaceFriction::ByCell(Field::new(grid, cells).unwrap());
    ContactProblem::of_half_spaces(gap, pair, friction).unwrap()
}

fn stepped(problem: &ContactProblem, shift: Shift) -> ContactState {
    let (method, apart) = (Frictional::default(), ContactState::apart(problem.grid()));
    let (mut scratch, mut to) = (method.scratch(problem).unwrap(), apart.clone());
    let drive = Drive::by_shift(shift);
    method.step(problem, &apart, &drive, &mut to, &mut scratch, &mut ()).unwrap();
    assert!(scratch.coupled.is_none(), "the alternation alone");
    to
}

/// Solves for pressures and tractions together; the first motions of approach, two shifts and twist are
/// prescribed by the loads of the solution where `loaded`.
fn together(
    problem: &ContactProblem,
    known: &ContactState,
    loaded: [bool; 4],
) -> (ContactState, Convergence) {
    let pressed = Shift { zeta: known.shift.zeta, ..Shift::default() };
    let start = stepped(&problem.clone().without_friction(), pressed);
    together_from(start, problem, known, loaded)
}

/// The same from any pressures and tractions.
fn together_from(
    mut to: ContactState,
    problem: &ContactProblem,
    known: &ContactState,
    loaded: [bool; 4],
) -> (ContactState, Convergence) {
    let (grid, shift, load) = (problem.grid(), known.shift, known.load());
    let area = grid.cell_area();
    let given = |k: usize, value: f64| if loaded[k] { 0.0 } else { value };
    let [xi, eta, omega] = [given(1, shift.xi), given(2, shift.eta), given(3, shift.omega)];
    let along = Field::from_function(grid, |_, y| -xi - y * omega);
    let across = Field::from_function(grid, |x, _| -eta + x * omega);
    let friction: Vec<f64> =
        (0..grid.cells()).map(|i| problem.friction().at(i).motion().get()).collect();
    let of = |k: usize, load: f64| loaded[k].then_some(load / area);
    let loads = [of(1, load.f_x), of(2, load.f_y), of(3, load.m_z)];
    let normal = if loaded[0] { Driven::Load(load.f_z) } else { Driven::Shift(shift.zeta) };
    let mut task = CoupledTask {
        operator: problem.operator(),
        heights: problem.gap().heights().values(),
        friction: &friction,
        offset: [along.values(), across.values()],
        normal,
        approach: if loaded[0] { 0.9 * shift.zeta } else { shift.zeta },
        rigid: Rigid { loads, ..Rigid::default() },
        pressure: to.pressure.values_mut(),
        traction: [to.traction_x.values_mut(), to.traction_y.values_mut()],
        cells: to.cells.values_mut(),
    };
    let mut solver = Coupled::new(problem.operator());
    let reached = solver.solve(&mut task, Steps::Damped, (1e-10, 300), &mut ()).unwrap();
    let [dx, dy, turn] = task.rigid.moved;
    to.shift = Shift { zeta: task.approach, xi: xi + dx, eta: eta + dy, omega: omega + turn };
    (to, reached)
}

fn agree(one: &ContactState, other: &ContactState) {
    let peak = one.peak_pressure();
    for (one, other) in [
        (&one.pressure, &other.pressure),
        (&one.traction_x, &other.traction_x),
        (&one.traction_y, &other.traction_y),
    ] {
        for (i, (one, other)) in one.values().iter().zip(other.values()).enumerate() {
            assert!((one - other).abs() < 1e-6 * peak, "cell {i}: {one} {other}");
        }
    }
    let (one, other) = (one.shift, other.shift);
    for (one, other) in
        [(one.zeta, other.zeta), (one.xi, other.xi), (one.eta, other.eta), (one.omega, other.omega)]
    {
        assert!((one - other).abs() < 1e-7, "{one} {other}");
    }
}

const SHIFT: Shift = Shift { zeta: 0.5, xi: 0.06, eta: -0.03, omega: 0.05 };

/// The tangential solver counts the cells of the patch as separated: they lost their pressures in the first
/// step and got a traction that is no number in the second.
#[test]
fn a_lubricated_patch_keeps_its_pressures() {
    let problem = problem(|x, y| if (x - 0.2).hypot(y) < 0.35 { 0.0 } else { 1.5 });
    let known = stepped(&problem, SHIFT);
    let (found, reached) = together(&problem, &known, [false; 4]);
    assert_eq!(reached.stop, Stop::Converged, "{reached:?}");
    agree(&known, &found);
    let patch = problem.grid().centres().zip(found.cells.values());
    let mut patch = patch.filter(|((x, y), _)| (x - 0.2).hypot(*y) < 0.35);
    assert!(patch.all(|(_, cell)| *cell == CellState::Slip));
}

/// Nothing pulls at the cells of bodies that are only pressed: those that come into contact under damping had
/// a traction that is no number.
#[test]
fn bodies_without_pressures_are_pressed_by_damped_steps() {
    let problem = problem(|_, _| 1.5);
    let known = stepped(&problem, Shift { zeta: 0.5, ..Shift::default() });
    let apart = ContactState::apart(problem.grid());
    let (found, reached) = together_from(apart, &problem, &known, [false; 4]);
    assert_eq!(reached.stop, Stop::Converged, "{reached:?}");
    agree(&known, &found);
}

#[test]
fn friction_that_varies_from_cell_to_cell_counts() {
    let problem = problem(|x, y| 1.0 + 0.8 * (3.0 * x + y).sin());
    let known = stepped(&problem, SHIFT);
    let (found, reached) = together(&problem, &known, [false; 4]);
    assert_eq!(reached.stop, Stop::Converged, "{reached:?}");
    agree(&known, &found);
}

#[test]
fn loads_lead_to_the_shifts_that_make_them() {
    let problem = problem(|_, _| 1.5);
    let known = stepped(&problem, SHIFT);
    for number in 1..16 {
        let loaded = [0, 1, 2, 3].map(|k| number >> k & 1 == 1);
        let (found, reached) = together(&problem, &known, loaded);
        assert_eq!(reached.stop, Stop::Converged, "{loaded:?}: {reached:?}");
        agree(&known, &found);
    }
}
