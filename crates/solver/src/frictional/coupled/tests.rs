//! Newton's method on pressures and tractions together finds what the alternation finds, from the pressures
//! without friction.

use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;

use super::cells::{Cells, Changes};
use super::origin::Origin;
use super::system::System;
use super::*;
use crate::convergence::Products;
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

/// The task of a state, with its solver's values; `loads` of the tangential motions.
fn seen<T>(
    problem: &ContactProblem,
    loads: [Option<f64>; 3],
    look: impl FnOnce(&mut CoupledTask<'_>, &mut System, &mut Cells) -> T,
) -> T {
    let count = problem.grid().cells();
    let friction = vec![1.5; count];
    let mut state = stepped(problem, SHIFT);
    let along = Field::from_function(problem.grid(), |_, y| -SHIFT.xi - y * SHIFT.omega);
    let across = Field::from_function(problem.grid(), |x, _| -SHIFT.eta + x * SHIFT.omega);
    let mut task = CoupledTask {
        operator: problem.operator(),
        heights: problem.gap().heights().values(),
        friction: &friction,
        offset: [along.values(), across.values()],
        normal: Driven::Shift(SHIFT.zeta),
        approach: SHIFT.zeta,
        rigid: Rigid { loads, ..Rigid::default() },
        pressure: state.pressure.values_mut(),
        traction: [state.traction_x.values_mut(), state.traction_y.values_mut()],
        cells: state.cells.values_mut(),
    };
    let (mut system, mut cells) = (System::new(task.operator), Cells::new(task.operator));
    system.displace(&task, &mut Products::default()).unwrap();
    cells.begin(&mut task);
    look(&mut task, &mut system, &mut cells)
}

/// A step that is taken again begins with all values of the first time.
#[test]
fn a_step_that_is_taken_again_begins_where_it_began() {
    let values = |task: &CoupledTask<'_>, system: &System, cells: &Cells| {
        let traction = [0, 1].map(|axis| task.traction[axis].to_vec());
        let of_task = (task.pressure.to_vec(), traction, task.cells.to_vec(), task.approach);
        (of_task, task.rigid.moved, system.gap.clone(), system.slip.clone(), cells.rim.clone())
    };
    seen(&problem(|_, _| 1.5), [None; 3], |task, system, cells| {
        let before = values(task, system, cells);
        let mut origin = Origin::new(task.cells.len());
        origin.keep(task, system, cells);
        task.pressure.fill(7.0);
        system.gap.fill(7.0);
        for field in system.slip.iter_mut().chain(&mut cells.rim) {
            field.fill(7.0);
        }
        task.traction.iter_mut().for_each(|field| field.fill(7.0));
        task.cells.fill(CellState::Stick);
        (task.approach, task.rigid.moved) = (7.0, [7.0; 3]);
        origin.restore(task, system, cells);
        assert_eq!(values(task, system, cells), before);
    });
}

/// A load that the tractions miss is told, along both axes alike.
#[test]
fn a_missing_load_leaves_a_residual() {
    let problem = problem(|_, _| 1.5);
    let area = problem.grid().cell_area();
    let load = stepped(&problem, SHIFT).load();
    let left = |missing: [f64; 3]| {
        let [x, y, turn] = [load.f_x, load.f_y, load.m_z].map(|load| load / area);
        let loads = [x + missing[0], y + missing[1], turn + missing[2]].map(Some);
        seen(&problem, loads, |task, system, cells| cells.residuals(task, system).tangential)
    };
    let [x, y, turn] = [left([0.1, 0.0, 0.0]), left([0.0, 0.1, 0.0]), left([0.0, 0.0, 0.1])];
    assert!(left([0.0; 3]) < 1e-3 * turn, "{turn}");
    assert!((x - y).abs() < 1e-9 * x, "{x} {y}");
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

/// Pressures below zero and tractions outside their cones, as the tolerance allows them.
#[test]
fn a_finished_solution_lies_in_its_cones() {
    let (problem, friction) = (problem(|_, _| 0.5), [0.5; 224]);
    let zero = [0.0; 224];
    let [mut pressure, mut x, mut y] = [zero; 3];
    pressure[..4].copy_from_slice(&[2.5, -1e-12, 1.0, 0.0]);
    x[..4].copy_from_slice(&[0.6, 1e-9, 0.6, 0.0]);
    y[..4].copy_from_slice(&[0.8, 0.0, 0.8, 1e-9]);
    let mut cells = [CellState::Slip; 224];
    let mut task = CoupledTask {
        operator: problem.operator(),
        heights: problem.gap().heights().values(),
        friction: &friction,
        offset: [&zero, &zero],
        normal: Driven::Shift(0.1),
        approach: 0.1,
        rigid: Rigid::default(),
        pressure: &mut pressure,
        traction: [&mut x, &mut y],
        cells: &mut cells,
    };
    Cells::new(problem.operator()).finish(&mut task);
    assert_eq!(pressure[..4], [2.5, 0.0, 1.0, 0.0]);
    assert_eq!((&x[..4], &y[..4]), (&[0.6, 0.0, 0.3, 0.0][..], &[0.8, 0.0, 0.4, 0.0][..]));
    let (slip, apart) = (CellState::Slip, CellState::Exterior);
    assert_eq!(cells[..5], [slip, apart, slip, apart, apart]);
}

/// A gap below zero, a traction outside its cone, slip along the traction and a pull along the ray are all
/// violations as displacements: where only half of the cells change, those with the greater ones do, of whatever kind.
#[test]
fn the_cells_that_are_farthest_from_their_conditions_change_first() {
    let (friction, [e_x, e_y]) = (1.5_f64, [0.6, -0.8]);
    let over = (1.0 + friction * friction).sqrt();
    let [cos, sin] = [1.0 / over, friction / over];
    // All orders of four sizes.
    let orders = (0..256).map(|n| [n & 3, n >> 2 & 3, n >> 4 & 3, n >> 6]);
    let orders: Vec<_> = orders.filter(|order| (0..4).all(|size| order.contains(&size))).collect();
    assert_eq!(orders.len(), 24);
    for order in orders {
        seen(&problem(|_, _| 1.5), [None; 3], |task, system, cells| {
            task.pressure.fill(0.0);
            task.cells.fill(CellState::Exterior);
            system.gap.fill(1.0);
            for axis in 0..2 {
                task.traction[axis].fill(0.0);
                system.slip[axis].fill(0.0);
            }
            let sizes = order.map(|size| 1e-3 * f64::from(size + 1));
            // As stresses that cause these displacements of their cells alone.
            let stresses = sizes.map(|size| size / cells.own[0]);
            let mut set = |cell: usize, state, pressure: f64, traction: f64| {
                task.cells[cell] = state;
                task.pressure[cell] = pressure;
                (task.traction[0][cell], task.traction[1][cell]) = (e_x * traction, e_y * traction);
                (cells.rim[0][cell], cells.rim[1][cell]) = (e_x, e_y);
            };
            set(3, CellState::Exterior, 0.0, 0.0);
            set(20, CellState::Stick, 1.0 - sin * stresses[1], friction + cos * stresses[1]);
            set(40, CellState::Slip, 1.0, friction);
            set(99, CellState::Slip, -cos * stresses[3], -sin * stresses[3]);
            system.gap[3] = -sizes[0];
            (system.slip[0][40], system.slip[1][40]) = (e_x * sizes[2], e_y * sizes[2]);
            let before = task.cells.to_vec();
            cells.choose(task, system, Changes::GreaterHalf);
            for (size, cell) in order.into_iter().zip([3, 20, 40, 99]) {
                assert_eq!(task.cells[cell] != before[cell], size >= 2, "{order:?}: {cell}");
            }
        });
    }
}
