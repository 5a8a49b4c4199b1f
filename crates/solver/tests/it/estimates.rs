//! Estimated and true discretisation errors of contacts with known solutions.

use std::f64::consts::PI;

use crate::known_solutions::Known;
use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    ContactProblem, ContactState, Drive, Driven, Estimated, Frictional, Gap, GridWarning,
    NestedHistory, Outline, Side,
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

/// Errors over their estimates, in order.
fn check(mut ratios: Vec<f64>, worst: f64) {
    ratios.sort_by(f64::total_cmp);
    let count = ratios.len();
    let beyond = ratios.iter().filter(|ratio| **ratio > 1.0).count();
    assert!(
        20 * beyond <= count && ratios[count - 1] <= worst,
        "{beyond} of {count}: {:?}",
        &ratios[count - 12..]
    );
    // And no estimate is a bound that says nothing.
    assert!(ratios[count / 2] > 0.1, "{ratios:?}");
}

/// On grids that meet its outline anyhow: F_z = pi E* a zeta/K, and with all cells sticking, of an incompressible body,
/// F_x = 16/3 G a xi and M_z = 16/3 G a^3 omega of a circle of radius a.
#[test]
fn errors_of_punches_are_covered() {
    let mut random = Congruential(0x0f1a_7b3d).after(8);
    let soft = MaterialPair::new(Material::from_shear(1.0, 0.5).unwrap(), Material::RIGID).unwrap();
    let mut ratios = Vec::new();
    let mut add = |got: Estimated, want: f64| ratios.push((got.value - want).abs() / got.error);
    for i in 0..60 {
        let cells = random.between(16.0, 64.0) as usize;
        let width = random.between(2.2, 4.0) / cells as f64;
        let half_y = if i % 2 == 0 { 1.0 } else { random.between(0.3, 1.0) };
        let outline = Outline::Ellipse { half_x: 1.0, half_y };
        let friction = if i % 2 == 0 { Friction::INFINITE } else { Friction::NONE };
        let make = |grid: Grid| {
            ContactProblem::of_half_spaces(Gap::punch(grid, &outline).unwrap(), soft, friction)
        };
        let grid = Grid::new(cells, cells, width, width).unwrap();
        let mut history = NestedHistory::new(Frictional::default(), grid, make).unwrap();
        let shift = Shift { zeta: 0.1, xi: 0.01, omega: 0.01, ..Shift::default() };
        history.step(&Drive::by_shift(shift), &mut ()).unwrap();
        let Some(got) = history.estimates() else { continue };
        let k = complete_k(half_y);
        add(got.f_z, PI * 4.0 * 0.1 / k);
        if i % 2 == 0 {
            add(got.f_x, 16.0 / 3.0 * 0.01);
            add(got.m_z, 16.0 / 3.0 * 0.01);
        }
    }
    check(ratios, 1.5);
}

/// K of the axis ratio b/a: pi over twice the arithmetic-geometric mean of 1 and b/a.
fn complete_k(ratio: f64) -> f64 {
    let (mut one, mut other) = (1.0_f64, ratio);
    for _ in 0..8 {
        (one, other) = (0.5 * (one + other), (one * other).sqrt());
    }
    PI / (2.0 * one)
}

/// Waves in one direction, whose borders run along rows of cells: Westergaard's pressure p* sin^2 psi at the approach
/// D sin^2 psi (1 - ln sin^2 psi), with p* = pi E* D/wave.
#[test]
fn errors_of_contacts_with_straight_borders_are_covered() {
    let mut random = Congruential(0x2c6e_11f5).after(8);
    let soft = MaterialPair::new(Material::from_shear(1.0, 0.5).unwrap(), Material::RIGID).unwrap();
    let mut ratios = Vec::new();
    for i in 0..120 {
        let cells = [24, 32, 40, 48, 64, 96][random.below(6)];
        let (phase, share) = (random.part(), random.between(0.03, 0.9));
        let depth = 5e-3;
        let [along, across] = if i % 2 == 0 { [cells, 8] } else { [8, cells] };
        let make = |grid: Grid| {
            let wave = |at: f64| depth * (1.0 - libm::cos(2.0 * PI * (at - phase)));
            let gap =
                Gap::from_function(grid, |x, y| wave(if i % 2 == 0 { x } else { y })).unwrap();
            ContactProblem::of_periods_by_need(gap, soft, Friction::NONE)
        };
        let grid = Grid::new(along, across, 1.0 / cells as f64, 1.0 / cells as f64).unwrap();
        let mut history = NestedHistory::new(Frictional::default(), grid, make).unwrap();
        let (zeta, force) = (
            depth * share * (1.0 - libm::log(share)),
            share * PI * 4.0 * depth * 8.0 / cells as f64,
        );
        let drive = match i % 4 < 2 {
            true => Drive::by_shift(Shift { zeta, ..Shift::default() }),
            false => Drive { normal: Driven::Load(force), ..Drive::default() },
        };
        history.step(&drive, &mut ()).unwrap();
        let got = history.estimates().unwrap();
        let (got, want) = if i % 4 < 2 { (got.f_z, force) } else { (got.zeta, zeta) };
        ratios.push((got.value - want).abs() / got.error);
    }
    check(ratios, 3.0);
}
