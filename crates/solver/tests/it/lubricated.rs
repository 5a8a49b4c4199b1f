//! Dissimilar bodies with a lubricated patch under pressure, at great friction elsewhere.

use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method as _,
};

use crate::friction_law::violations;

/// A body of nu = 0 on a rigid one, gamma = 0.5; without friction within 0.4 of (0.2, 0), in units of the
/// contact radius times `unit`.
fn problem(friction: f64, unit: f64) -> ContactProblem {
    let grid = Grid::new(24, 20, 0.1 * unit, 0.12 * unit).unwrap();
    let pair = MaterialPair::new(Material::from_shear(3.0, 0.0).unwrap(), Material::RIGID).unwrap();
    let gap = Gap::from_function(grid, |x, y| (0.5 * x * x + 0.6 * y * y) / unit).unwrap();
    let cells = grid.centres().map(|(x, y)| {
        let lubricated = (x - 0.2 * unit).hypot(y) < 0.4 * unit;
        Friction::new(if lubricated { 0.0 } else { friction }).unwrap().into()
    });
    let friction = Field::new(grid, cells.collect()).unwrap();
    ContactProblem::of_half_spaces(gap, pair, friction).unwrap()
}

#[test]
fn a_lubricated_patch_carries_pressures_alone() {
    for (friction, unit) in [(20.0, 1.0), (200.0, 1.0), (f64::INFINITY, 1.0), (20.0, 1e-6)] {
        let problem = problem(friction, unit);
        let method = Frictional::default();
        let mut scratch = method.scratch(&problem).unwrap();
        let mut state = ContactState::apart(problem.grid());
        for [zeta, xi, eta, omega] in
            [[0.5, 0.0, 0.0, 0.0], [0.5, 0.1, -0.05, 0.05], [0.4, 0.0, 0.1, 0.0]]
        {
            let (zeta, xi, eta) = (zeta * unit, xi * unit, eta * unit);
            let (before, drive) = (state.clone(), Drive::by_shift(Shift { zeta, xi, eta, omega }));
            method
                .step(&problem, &before, &drive, &mut state, &mut scratch, &mut ())
                .unwrap_or_else(|error| panic!("f = {friction}, unit {unit}: {error}"));
            let left = violations(&problem, &before, &state);
            assert!(left[0] < 1e-8 && left[1] < 1e-7, "f = {friction}, unit {unit}: {left:?}");
            let mut pressed = 0;
            for (i, cell) in state.cells.values().iter().enumerate() {
                if problem.friction().at(i).motion() == Friction::NONE {
                    let [x, y] = [&state.traction_x, &state.traction_y].map(|t| t.values()[i]);
                    assert!(x == 0.0 && y == 0.0 && *cell != CellState::Stick, "{x} {y} {cell:?}");
                    pressed += usize::from(*cell == CellState::Slip);
                }
            }
            assert!(pressed > 20, "{pressed} cells of the patch carry pressure");
        }
    }
}

/// The patch is not the end of the contact: the rest holds the given loads.
#[test]
fn loads_on_a_lubricated_contact_lead_to_the_shifts_that_make_them() {
    for friction in [20.0, f64::INFINITY] {
        let problem = problem(friction, 1.0);
        let method = Frictional::default();
        let mut scratch = method.scratch(&problem).unwrap();
        let apart = ContactState::apart(problem.grid());
        let (mut by_shift, mut by_load) = (apart.clone(), apart.clone());
        let shift = Shift { zeta: 0.5, xi: 0.1, eta: -0.05, omega: 0.05 };
        let drive = Drive::by_shift(shift);
        method.step(&problem, &apart, &drive, &mut by_shift, &mut scratch, &mut ()).unwrap();
        let load = by_shift.load();
        let drive = Drive {
            normal: Driven::Load(load.f_z),
            x: Driven::Load(load.f_x),
            twist: Driven::Load(load.m_z),
            ..drive
        };
        method.step(&problem, &apart, &drive, &mut by_load, &mut scratch, &mut ()).unwrap();
        let (got, f_z) = (by_load.load(), load.f_z);
        for (got, given) in [(got.f_z, load.f_z), (got.f_x, load.f_x), (got.m_z, load.m_z)] {
            assert!((got - given).abs() < 1e-7 * f_z, "{got} {given}");
        }
        let got = by_load.shift;
        for (got, own) in [(got.zeta, shift.zeta), (got.xi, shift.xi), (got.omega, shift.omega)] {
            assert!((got - own).abs() < 1e-6, "f = {friction}: {got} {own}");
        }
    }
}
