//! How a step starts from coarser grids.

use std::sync::Arc;

use carom_halfspace::operator::{HalfSpaceOperator, SurfaceOperator, Threads};
use carom_halfspace::{Grid, Material, MaterialPair};

use super::law::most_violation;
use super::*;

/// Of cells that are no squares.
fn operator(nx: usize, ny: usize) -> HalfSpaceOperator {
    let body = Material::from_shear(1.0, 0.3).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    HalfSpaceOperator::new(pair, Grid::new(nx, ny, 0.02, 0.03).unwrap()).unwrap()
}

/// More cells than three parts have.
const MANY: usize = 30_000;

#[test]
fn one_cell_of_many_decides_whether_tractions_are_within_their_discs_and_whether_any_are_left() {
    let limits = vec![2.0; MANY];
    for threads in [Threads::One, Threads::Pool] {
        for cell in [0, 9000, MANY - 1] {
            for [x, y] in [[1.5_f64, 0.0], [0.0, -1.5], [-3.0, 0.0], [0.0, 3.0], [1.8, 2.4]] {
                let mut traction = [vec![0.0; MANY], vec![0.0; MANY]];
                (traction[0][cell], traction[1][cell]) = (x, y);
                let [along, across] = &mut traction;
                let is_kept = x.hypot(y) <= 2.0;
                assert_eq!(project(threads, &limits, [along, across]), (is_kept, true));
                let size = traction[0][cell].hypot(traction[1][cell]);
                assert!((size - x.hypot(y).min(2.0)).abs() < 1e-15);
            }
        }
        let mut traction = [vec![0.0; MANY], vec![0.0; MANY]];
        let [along, across] = &mut traction;
        assert_eq!(project(threads, &limits, [along, across]), (true, false));
    }
}

/// The left half of the coarse cells slips, the others stick with tractions that increase along y, up to
/// their limits; the cells at the left border are apart.
#[test]
fn fine_cells_take_the_change_of_their_coarse_ones() {
    let fine = operator(200, 100);
    let coarse: Arc<dyn SurfaceOperator> = fine.coarser().unwrap().unwrap().into();
    let (grid, below) = (fine.grid(), coarse.grid());
    let rise = |y: f64| 0.9 * y;
    let mut level = Level::new(&coarse);
    level.limits.fill(1.0);
    level.begun = [vec![0.3; below.cells()], vec![-0.1; below.cells()]];
    for (cell, (x, y)) in below.centres().enumerate() {
        level.traction[0][cell] = 0.3 + if x < 0.0 { 0.6 } else { 0.2 };
        level.traction[1][cell] = -0.1 + rise(y);
        level.cells[cell] = if x < 0.0 { CellState::Slip } else { CellState::Stick };
    }
    let left = grid.centred_x(0);
    let limits: Vec<f64> = grid.centres().map(|(x, _)| if x == left { 0.0 } else { 2.0 }).collect();
    for threads in [Threads::One, Threads::Pool] {
        let mut traction = [vec![0.5; grid.cells()], vec![0.1; grid.cells()]];
        let mut cells = vec![CellState::Exterior; grid.cells()];
        let [along, across] = &mut traction;
        level.pass_on((grid, threads), &limits, [along, across], &mut cells);
        for (cell, (x, y)) in grid.centres().enumerate() {
            let at = [traction[0][cell], traction[1][cell]];
            if x == left {
                assert_eq!((at, cells[cell]), ([0.0; 2], CellState::Exterior));
            } else if x < 0.0 {
                // With its full traction.
                assert_eq!(cells[cell], CellState::Slip, "{x} {y}");
                assert!((at[0].hypot(at[1]) - 2.0).abs() < 1e-12);
            } else {
                assert_eq!(cells[cell], CellState::Stick, "{x} {y}");
                // Beside the border between both, and at that of the grid, the change is interpolated.
                if x > 0.05 && y.abs() < 1.4 {
                    let want = project_to_disc([0.5 + 2.0 * 0.2, 0.1 + 2.0 * rise(y)], 2.0);
                    let off = (at[0] - want[0]).hypot(at[1] - want[1]);
                    assert!(off < 1e-12, "{x} {y}: {at:?} {want:?}");
                }
            }
        }
    }
}

/// If tractions are a solution, a step makes the slip of its rigid motion, on all grids.
#[test]
fn the_slip_at_the_beginning_of_a_step_is_its_rigid_motion() {
    let fine = operator(72, 64);
    let coarse = nested::coarser_operators(&fine).unwrap();
    let mut scratch = TangentialScratch::new(&fine, &coarse);
    let (grid, [dx, dy, turn]) = (fine.grid(), [0.3, -0.2, 0.7]);
    let limits = vec![1.0; grid.cells()];
    let plane = |[a, b, c]: [f64; 3]| grid.centres().map(move |(x, y)| a + b * x + c * y);
    let given: Plane = [plane([0.2, 0.1, -0.3]).collect(), plane([-0.1, 0.2, 0.1]).collect()];
    // Minus the displacements due to the tractions, minus the motion (12.2).
    let mut offset: Plane = [plane([-dx, 0.0, -turn]).collect(), plane([-dy, turn, 0.0]).collect()];
    let against = given.each_ref().map(|values| values.iter().map(|t| -t).collect::<Vec<_>>());
    let mut space = (Plane::default(), Workspace::default());
    add_displacement(&fine, slices(&against), &mut offset, (&mut space.0, &mut space.1)).unwrap();
    for moved in [Some([dx, dy, turn]), None] {
        let mut traction = given.clone();
        let [along, across] = &mut traction;
        let mut cells = vec![CellState::Stick; grid.cells()];
        let mut task = TangentialTask {
            operator: &fine,
            limits: &limits,
            offset: [&offset[0], &offset[1]],
            rigid: Rigid::default(),
            pressure: 1.0,
            traction: [along, across],
            cells: &mut cells,
        };
        let mut spent = Products::default();
        assert!(scratch.begin_coarse(&mut task, moved, &mut spent).unwrap());
        let near = |got: f64, want: f64| (got - want).abs() < 1e-12;
        for (cell, (x, y)) in grid.centres().enumerate() {
            assert!(near(scratch.slip[0][cell], -(dx + y * turn)), "{moved:?}: {x} {y}");
            assert!(near(scratch.slip[1][cell], -(dy - x * turn)), "{moved:?}: {x} {y}");
        }
        let level = &scratch.coarse[0];
        for (cell, (x, y)) in level.grid.centres().enumerate() {
            assert!(near(level.slip[0][cell], -(dx + y * turn)), "{moved:?}: {x} {y}");
            assert!(near(level.slip[1][cell], -(dy - x * turn)), "{moved:?}: {x} {y}");
            assert!(near(level.begun[0][cell], 0.2 + 0.1 * x - 0.3 * y), "{x} {y}");
            assert!(near(level.begun[1][cell], -0.1 + 0.2 * x + 0.1 * y), "{x} {y}");
        }
    }
}

/// What counts as lost has the unit of tractions; cells that never slip and cells apart do not count.
#[test]
fn the_greatest_violation_is_in_the_unit_of_the_limits() {
    let limits = [0.3, 0.0, f64::INFINITY, 0.4];
    let most = most_violation(&limits);
    assert!((most_violation(&limits.map(|limit| 1e6 * limit)) / most - 1e6).abs() < 1e-6);
    assert_eq!(most_violation(&[0.3, 0.4]), most);
    // Tractions twice as great as all bounds return.
    assert!(most > 0.5);
    for none in [0.0, f64::INFINITY] {
        assert_eq!(most_violation(&[none; 3]), f64::INFINITY);
    }
}

/// One correction of many that is no number, along either axis, is enough.
#[test]
fn a_correction_without_a_value_runs_away() {
    let mut set = ActiveSet::new(&operator(8, 8));
    set.direction = [vec![1.0; MANY], vec![-1.0; MANY]];
    assert!(!set.runs_away());
    for axis in 0..2 {
        for cell in [0, 9000, MANY - 1] {
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let before = std::mem::replace(&mut set.direction[axis][cell], value);
                assert!(set.runs_away(), "{axis} {cell} {value}");
                set.direction[axis][cell] = before;
            }
        }
    }
}
