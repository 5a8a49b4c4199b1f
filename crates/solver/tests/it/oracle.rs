//! The check of solved states itself: what breaks one of the conditions is told with its size.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    CellFriction, CellState, ContactProblem, ContactState, Drive, Driven, Frictional, Gap,
    Method as _, Residuals, violations,
};

struct Solved {
    problem: ContactProblem,
    before: ContactState,
    after: ContactState,
}

impl Solved {
    /// A contact on oblong cells that slips in part, along both axes.
    fn new() -> Self {
        let grid = Grid::new(20, 16, 0.04, 0.06).unwrap();
        let body = Material::from_shear(1.0, 0.3).unwrap();
        let pair = MaterialPair::new(body, body).unwrap();
        let gap = Gap::from_function(grid, |x, y| 0.5 * x * x + 0.7 * y * y).unwrap();
        let [rest, motion] = [0.4, 0.3].map(|f| Friction::new(f).unwrap());
        let friction = CellFriction::new(rest, motion).unwrap();
        let problem = ContactProblem::of_half_spaces(gap, pair, friction).unwrap();
        let method = Frictional::default().within(1e-10).unwrap();
        let mut scratch = method.scratch(&problem).unwrap();
        let pressed = Drive { normal: Driven::Shift(0.05), ..Drive::default() };
        let shifted = Drive { x: Driven::Shift(0.01), y: Driven::Shift(-0.006), ..pressed };
        let (mut before, mut after) = (ContactState::apart(grid), ContactState::apart(grid));
        method.step(&problem, &after, &pressed, &mut before, &mut scratch, &mut ()).unwrap();
        method.step(&problem, &before, &shifted, &mut after, &mut scratch, &mut ()).unwrap();
        Self { problem, before, after }
    }

    fn residuals(&self, after: &ContactState) -> Residuals {
        violations(&self.problem, &self.before, after).unwrap()
    }

    /// Cells in this state whose traction is well below the limit of friction at rest.
    fn cells(&self, state: CellState) -> Vec<usize> {
        let all = self.after.cells.values().iter().enumerate();
        all.filter(|(_, cell)| **cell == state).map(|(i, _)| i).collect()
    }
}

/// The largest limit of friction at rest or in motion, by which tangential violations are divided.
fn scale(solved: &Solved) -> f64 {
    let pressures = solved.after.pressure.values();
    let limit = |i: &usize| {
        let slips = solved.after.cells.values()[*i] == CellState::Slip;
        pressures[*i] * if slips { 0.3 } else { 0.4 }
    };
    (0..pressures.len()).map(|i| limit(&i)).fold(0.0, f64::max)
}

#[test]
fn a_solved_state_violates_nothing() {
    let solved = Solved::new();
    assert!(
        !solved.cells(CellState::Stick).is_empty() && !solved.cells(CellState::Slip).is_empty()
    );
    let left = solved.residuals(&solved.after);
    assert!(left.normal < 1e-8 && left.tangential < 1e-7, "{left:?}");
}

#[test]
fn a_gap_or_an_overlap_within_the_contact_is_told_with_its_part_of_the_depth() {
    let solved = Solved::new();
    for change in [1e-4, -1e-4] {
        let mut after = solved.after.clone();
        after.shift.zeta += change;
        let normal = solved.residuals(&after).normal;
        assert!((normal / (1e-4 / 0.05) - 1.0).abs() < 0.02, "{change}: {normal}");
    }
}

#[test]
fn a_pulling_pressure_is_told_by_the_depth_to_which_it_would_press() {
    let solved = Solved::new();
    let outside = solved.cells(CellState::Exterior)[0];
    let mut after = solved.after.clone();
    after.pressure.values_mut()[outside] = -1e-3;
    let own = solved.problem.operator().coefficients(0, 0).rows[2][2];
    let normal = solved.residuals(&after).normal;
    assert!(normal >= 0.99 * own * 1e-3 / 0.05, "{normal}");
}

#[test]
fn slip_of_a_sticking_cell_along_either_axis_is_told() {
    let solved = Solved::new();
    let own = solved.problem.operator().coefficients(0, 0).rows;
    let soft = 0.5 * (own[0][0] + own[1][1]);
    for axis in [0, 1] {
        let mut after = solved.after.clone();
        // So little that the limit of friction does not matter.
        let slip = 1e-3 * soft * scale(&solved);
        if axis == 0 {
            after.shift.xi += slip
        } else {
            after.shift.eta += slip
        }
        let tangential = solved.residuals(&after).tangential;
        assert!((tangential / 1e-3 - 1.0).abs() < 0.05, "{axis}: {tangential}");
    }
}

#[test]
fn a_slipping_cell_that_holds_friction_at_rest_is_told() {
    let solved = Solved::new();
    let slipping = solved.cells(CellState::Slip)[0];
    let mut after = solved.after.clone();
    let pressure = after.pressure.values()[slipping];
    for field in [&mut after.traction_x, &mut after.traction_y] {
        field.values_mut()[slipping] *= 0.4 / 0.3;
    }
    let tangential = solved.residuals(&after).tangential;
    assert!(tangential >= 0.99 * (0.4 - 0.3) * pressure / scale(&solved), "{tangential}");
}
