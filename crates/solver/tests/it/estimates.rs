//! Estimated and true discretisation errors of contacts with known solutions.

use std::f64::consts::PI;

use crate::known_solutions::Known;
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    ContactProblem, ContactState, Drive, Estimated, Frictional, Gap, GridWarning, NestedHistory,
    Side,
};

/// Twenty positions of the contact relative to the cells, evenly distributed.
fn offsets() -> impl Iterator<Item = [f64; 2]> {
    (1..=20).map(|i| {
        [0.754_877_666, 0.569_840_291].map(|step: f64| (step * f64::from(i)).fract() - 0.5)
    })
}

/// Ratios of estimated to true errors, for loads and peak pressure.
fn ratios(known: Known, cells: usize) -> Vec<(&'static str, f64, f64)> {
    let mut all = Vec::new();
    for offset in offsets() {
        // The position is fixed in space: on coarser cells it is a smaller fraction of a cell.
        let make = |grid: Grid| {
            let part = grid.nx() as f64 / cells as f64;
            known.problem(grid.nx(), offset.map(|at| part * at))
        };
        let problem = known.problem(cells, offset).unwrap();
        let mut history = NestedHistory::new(Frictional::default(), problem.grid(), make).unwrap();
        for drive in known.drives(cells).unwrap() {
            history.step(&drive, &mut ()).unwrap();
        }
        let (got, want) = (history.estimates().unwrap(), known.expected(cells).unwrap());
        let mut add = |name, got: Estimated, want: f64| {
            let error = (got.value - want).abs() / want.abs();
            all.push((name, got.error / want.abs() / error, error));
        };
        match known {
            Known::Hertz | Known::FlatPunch => add("F_z", got.f_z, want.load.f_z),
            Known::CattaneoMindlin => add("F_x", got.f_x, want.load.f_x),
            Known::Lubkin | Known::MindlinTorsion => add("M_z", got.m_z, want.load.m_z),
            Known::Westergaard => {}
        }
        if let Some(peak) = want.peak {
            add("peak", got.peak, peak);
        }
        if let Some(area) = want.stick_area.filter(|_| known != Known::MindlinTorsion) {
            assert!(
                (got.stick_area.value - area).abs() < got.stick_area.error,
                "{known:?} {got:?}"
            );
        }
    }
    all
}

#[test]
fn estimates_are_near_the_true_errors() {
    let (mut near, mut far_below, mut count) = (0, 0, 0);
    for known in Known::ALL {
        let all = ratios(known, 96);
        for name in ["F_z", "F_x", "M_z", "peak"] {
            let own = all.iter().filter(|(own, ..)| *own == name);
            let mut own: Vec<(f64, f64)> = own.map(|(_, ratio, error)| (*ratio, *error)).collect();
            if own.is_empty() {
                continue;
            }
            own.sort_by(|a, b| a.0.total_cmp(&b.0));
            let worst = own.iter().map(|(_, error)| *error).fold(0.0, f64::max);
            // An extreme between cells is less certain than a load: its bar may be wider, up to 2e-3 of it.
            let is_near = |(ratio, error): &(f64, f64)| {
                let narrow = name == "peak" && ratio * error < 2e-3;
                *ratio >= 0.25 && (*ratio <= 4.0 || narrow)
            };
            let good = own.iter().filter(|one| is_near(one)).count();
            println!(
                "{known:?} {name}: estimate over error {:.2} {:.2} {:.2}, near: {good} of {}, worst error {worst:.1e}",
                own[0].0,
                own[own.len() / 2].0,
                own[own.len() - 1].0,
                own.len()
            );
            near += good;
            far_below += own.iter().filter(|(ratio, _)| *ratio < 0.2).count();
            count += own.len();
        }
    }
    println!("{near} of {count} near, {far_below} below a fifth");
    assert!(10 * near >= 9 * count && far_below == 0);
}

#[test]
fn a_contact_at_the_border_or_of_few_cells_is_in_doubt() {
    let pressed = |cells: usize, offset: [f64; 2]| {
        let known = Known::Hertz;
        let make = |grid: Grid| known.problem(grid.nx(), offset);
        let grid = known.problem(cells, offset).unwrap().grid();
        let mut history = NestedHistory::new(Frictional::default(), grid, make).unwrap();
        history.step(&known.drives(cells).unwrap()[0], &mut ()).unwrap();
        history.state().warnings()
    };
    assert_eq!(pressed(48, [0.0, 0.0]), []);
    assert_eq!(pressed(48, [8.0, 0.0]), [GridWarning::Border { side: Side::Right }]);
    assert_eq!(pressed(48, [0.0, -8.0]), [GridWarning::Border { side: Side::Bottom }]);
    assert!(matches!(pressed(10, [0.0, 0.0])[..], [GridWarning::FewCells { across: 8 }]));
}

/// On a single row of cells a contact is as wide as it is long.
#[test]
fn a_contact_on_one_row_of_cells_is_not_of_few_cells() {
    for [nx, ny] in [[64, 1], [1, 64]] {
        let mut state = ContactState::apart(Grid::new(nx, ny, 1.0, 30.0).unwrap());
        state.pressure.values_mut()[20..44].fill(1.0);
        let is_narrow = |warning: &GridWarning| matches!(warning, GridWarning::FewCells { .. });
        assert!(!state.warnings().iter().any(is_narrow));
    }
}

/// On whichever of the three grids: the history stays as it is.
#[test]
fn a_state_of_another_grid_is_not_restored() {
    let make = |grid: Grid| Known::Hertz.problem(grid.nx(), [0.0; 2]);
    let grids = [48, 24, 12].map(|n| Known::Hertz.problem(n, [0.0; 2]).unwrap().grid());
    let mut history = NestedHistory::new(Frictional::default(), grids[0], make).unwrap();
    history.step(&Known::Hertz.drives(48).unwrap()[0], &mut ()).unwrap();
    let before = (history.state().clone(), history.coarse_states().map(Option::<&_>::cloned));
    for wrong in 0..3 {
        let mut own = grids;
        own[wrong] = grids[(wrong + 1) % 3];
        let [fine, coarse, coarsest] = own.map(ContactState::apart);
        assert!(history.restore(fine, [Some(coarse), Some(coarsest)]).is_err());
        let after = (history.state().clone(), history.coarse_states().map(Option::<&_>::cloned));
        assert_eq!(after, before);
    }
}

/// Few or no cells stick, without a contour: the area is not known exactly.
#[test]
fn a_stick_area_without_an_outline_has_an_error() {
    for xi in [0.05, 0.15, 0.18, 0.192, 0.197, 0.1999, 0.25, 1.0] {
        let make = |grid: Grid| {
            let body = Material::from_shear(1.0, 0.0).unwrap();
            let pair = MaterialPair::new(body, body).unwrap();
            let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
            ContactProblem::of_half_spaces(gap, pair, Friction::new(0.2).unwrap())
        };
        let grid = Grid::new(28, 28, 0.1, 0.1).unwrap();
        let mut history = NestedHistory::new(Frictional::default(), grid, make).unwrap();
        let to = |xi: f64| Drive::by_shift(Shift { zeta: 1.0, xi, ..Shift::default() });
        history.step(&to(0.0), &mut ()).unwrap();
        history.step(&to(xi), &mut ()).unwrap();
        let got = history.estimates().unwrap().stick_area;
        // Cattaneo: the stick radius squared is 1 - xi/(f zeta).
        let area = PI * (1.0 - xi / 0.2).max(0.0);
        println!("{xi}: {got:?}, {area}");
        assert!(got.error >= 4.0 * 0.01 && (got.value - area).abs() < got.error, "{xi}: {got:?}");
    }
}

/// Values that approach their limit as the square of the cell width have a third of the last difference left.
#[test]
fn smooth_values_are_extrapolated() {
    let limit = 2.0;
    let at = |width: f64| limit + 0.1 * width * width;
    let found = Estimated::of([at(1.0), at(2.0), at(4.0)]);
    assert_eq!(found.value, at(1.0));
    assert!((found.error - 0.1).abs() < 1e-12, "{found:?}");
    // In first order all of it is left, and a quarter is added.
    let at = |width: f64| limit + 0.1 * width;
    let found = Estimated::of_first_order([at(1.0), at(2.0), at(4.0)]);
    assert!((found.error - 0.125).abs() < 1e-12, "{found:?}");
}
