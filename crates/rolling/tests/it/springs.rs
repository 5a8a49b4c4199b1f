//! Springs on the cells of a grid.

use carom_halfspace::{Field, Grid};
use carom_rolling::{CreepCoefficients, Creepage, Fastsim, Springs, Way};
use carom_solver::{CellState, ContactState};
use std::f64::consts::PI;

const SEMI_AXES: [f64; 2] = [1.5, 0.8];
const FRICTION: f64 = 0.3;

fn coefficients() -> CreepCoefficients {
    CreepCoefficients::by_table(SEMI_AXES[0] / SEMI_AXES[1], 0.28).unwrap()
}

/// An ellipse under a paraboloid of pressure, of the load 1.
fn pressed(cells: usize) -> ContactState {
    let [a, b] = SEMI_AXES;
    let [dx, dy] = SEMI_AXES.map(|axis| 2.1 * axis / cells as f64);
    let grid = Grid::new(cells, cells, dx, dy).unwrap();
    let highest = 2.0 / (PI * a * b);
    let pressure = |x: f64, y: f64| highest * (1.0 - (x / a).powi(2) - (y / b).powi(2)).max(0.0);
    let mut state = ContactState::apart(grid);
    state.pressure = Field::from_function(grid, pressure);
    state
}

fn roll(state: &mut ContactState, direction: f64, creepage: Creepage) -> f64 {
    let way = Way::new(state.pressure.grid().dx()).unwrap().towards(direction).unwrap();
    let springs = Springs::of_ellipse(SEMI_AXES, 1.0, &coefficients()).unwrap();
    let way = way.with_spin_at(0.5).unwrap();
    springs.roll(&way, creepage, |_| FRICTION, state).unwrap()
}

const CREEPAGES: [[f64; 3]; 4] =
    [[0.02, 0.0, 0.0], [0.03, -0.05, 0.0], [0.01, 0.02, 0.04], [0.2, -0.1, 0.3]];

/// On many cells they are FASTSIM on many strips.
#[test]
fn on_many_cells_springs_are_fastsim() {
    let mut state = pressed(400);
    for [along, across, spin] in CREEPAGES {
        let creepage = Creepage { along, across, spin };
        roll(&mut state, 0.0, creepage);
        let fastsim = Fastsim {
            semi_axes: SEMI_AXES,
            shear_modulus: 1.0,
            coefficients: coefficients(),
            force: 1.0,
            friction: FRICTION,
            mesh: [400, 400],
        };
        let (wanted, load) = (fastsim.forces(creepage).unwrap(), state.load());
        let off = (load.f_x - wanted.f_x).hypot(load.f_y - wanted.f_y);
        assert!(off < 2e-3 * FRICTION, "{creepage:?}: {load:?} {wanted:?}");
    }
}

/// One element is half its length from the leading edge: its traction is a/L times the creepage, up to that of friction.
#[test]
fn fastsim_takes_from_one_element_to_a_thousand() {
    let (shear_modulus, coefficients) = (1.0, coefficients());
    let with = |mesh| Fastsim {
        semi_axes: SEMI_AXES,
        shear_modulus,
        coefficients,
        force: 1.0,
        friction: FRICTION,
        mesh,
    };
    let [a, b] = SEMI_AXES;
    let area = 4.0 * a * b;
    let [along, across, _] =
        Springs::of_ellipse(SEMI_AXES, shear_modulus, &coefficients).unwrap().flexibilities();
    let small = Creepage { along: 1e-3, across: -2e-3, spin: 0.0 };
    let load = with([1, 1]).forces(small).unwrap();
    assert!((load.f_x / (area * a * 1e-3 / along) - 1.0).abs() < 1e-12, "{load:?}");
    assert!((load.f_y / (-area * a * 2e-3 / across) - 1.0).abs() < 1e-12, "{load:?}");
    let load = with([1, 1]).forces(Creepage { across: 9.0, ..Creepage::default() }).unwrap();
    // The limit in the middle over all of it is more than friction holds.
    assert!((load.f_y / FRICTION - 1.0).abs() < 1e-12, "{load:?}");
    for mesh in [[0, 1], [1, 0], [1001, 1], [1, 1001]] {
        assert_eq!(with(mesh).forces(small).unwrap_err().field, "mesh");
    }
    for (field, wrong) in [
        ("force", Fastsim { force: 0.0, ..with([1, 1]) }),
        ("friction", Fastsim { friction: f64::INFINITY, ..with([1, 1]) }),
        ("b", Fastsim { semi_axes: [1.0, 0.0], ..with([1, 1]) }),
        ("shear_modulus", Fastsim { shear_modulus: -1.0, ..with([1, 1]) }),
    ] {
        assert_eq!(wrong.forces(small).unwrap_err().field, field);
    }
    for (field, wrong) in [
        ("creepage", Creepage { along: 1e300, ..small }),
        ("creepage_across", Creepage { across: f64::NAN, ..small }),
        ("spin", Creepage { spin: -1e200, ..small }),
    ] {
        assert_eq!(with([2, 2]).forces(wrong).unwrap_err().field, field);
    }
}

/// Backwards, with the creepage along and the spin reversed, everything is the mirror image; heat is positive, and tractions keep
/// to the friction limit.
#[test]
fn rolling_backwards_mirrors_and_slip_heats() {
    let (mut forth, mut back) = (pressed(50), pressed(50));
    for [along, across, spin] in CREEPAGES {
        let heat = roll(&mut forth, 0.0, Creepage { along, across, spin });
        let other = roll(&mut back, PI, Creepage { along: -along, across, spin: -spin });
        assert!((heat - other).abs() <= 1e-12 * heat && heat > 0.0);
        let (one, two) = (forth.load(), back.load());
        assert!((one.f_x + two.f_x).abs() < 1e-12 && (one.f_y - two.f_y).abs() < 1e-12);
        for cell in 0..2500 {
            let [x, y] = [&forth.traction_x, &forth.traction_y].map(|t| t.values()[cell]);
            let (limit, own) =
                (FRICTION * forth.pressure.values()[cell], forth.cells.values()[cell]);
            assert!(x.hypot(y) <= limit * (1.0 + 1e-12));
            assert_eq!(own == CellState::Exterior, limit == 0.0);
        }
    }
}

#[test]
fn other_ways_and_wrong_numbers_are_refused() {
    let mut state = pressed(10);
    let springs = Springs::alike(1.0).unwrap();
    let dx = state.pressure.grid().dx();
    // One is a cell along x, and some along y too.
    let slant = Way::new(dx * 2.0_f64.sqrt()).unwrap().towards(0.25 * PI);
    for way in [Way::new(2.0 * dx), Way::new(dx).unwrap().towards(1.0), slant] {
        let error = springs.roll(&way.unwrap(), Creepage::default(), |_| 0.3, &mut state);
        assert_eq!(error.unwrap_err().field, "rolling distance");
    }
    let way = Way::new(dx).unwrap();
    assert!(springs.roll(&way, Creepage::default(), |_| -0.1, &mut state).is_err());
    let wrong = Creepage { spin: f64::NAN, ..Creepage::default() };
    assert!(springs.roll(&way, wrong, |_| 0.3, &mut state).is_err());
    assert!(Springs::new([1.0, 0.0, 1.0]).is_err());
    assert!(Springs::of_ellipse([1.0, -1.0], 1.0, &coefficients()).is_err());
}

/// What the forces do by large creepages becomes heat; the springs keep little of it.
#[test]
fn heat_is_the_work_of_creepage_where_all_slips() {
    let mut state = pressed(50);
    for [along, across] in [[9.0, 0.0], [0.0, 9.0], [6.0, -8.0]] {
        let heat = roll(&mut state, 0.0, Creepage { along, across, spin: 0.0 });
        let load = state.load();
        let work = load.f_x * along + load.f_y * across;
        assert!((heat - work).abs() < 0.02 * work, "{heat} {work}");
    }
}
