//! Rolling cases shipped with CONTACT, with the numbers that it prints.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingDrive, SteadyContact, SteadyRolling, Way};
use carom_solver::{CellState, ContactProblem, Driven, Gap};
use serde_json::Value;

fn cases() -> Value {
    serde_json::from_str(include_str!("../data/contact.json")).unwrap()
}

/// Whether a number agrees with a printed one of four digits within half a unit of the last.
fn agrees(got: f64, printed: f64) -> bool {
    let unit =
        if printed == 0.0 { 0.0 } else { 10_f64.powi(printed.abs().log10().floor() as i32 - 3) };
    (got - printed).abs() <= 0.5 * unit * (1.0 + 1e-9)
}

fn number(row: &Value, name: &str) -> f64 {
    row[name].as_f64().unwrap()
}

/// The numbers of cells that stick and slip.
fn counts(rolled: &SteadyRolling) -> [usize; 2] {
    [CellState::Stick, CellState::Slip].map(|state| rolled.state.count(state))
}

fn printed_counts(row: &Value) -> [usize; 2] {
    ["stick", "slip"].map(|name| row[name].as_u64().unwrap() as usize)
}

/// An ellipse under 30 longitudinal creepages.
#[test]
fn a_traction_curve() {
    let [a, b] = [6.303_597_245_518, 12.607_194_491_036];
    let [a1, b1] = [0.0008, 2.814_173_138_273e-4];
    let grid = Grid::new(48, 44, 2.2 * a / 48.0, 2.2 * b / 44.0).unwrap();
    let gap = Gap::from_function(grid, |x, y| a1 * x * x + b1 * y * y).unwrap();
    let body = Material::from_shear(82000.0, 0.28).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.33).unwrap()).unwrap();
    let mut contact = SteadyContact::new(&problem, Way::new(grid.dx()).unwrap()).unwrap();
    let force = 106_700.0;
    for row in cases()["tractcurv"]["results"].as_array().unwrap() {
        let along = -number(row, "xi");
        let creepage = Creepage { along, ..Creepage::default() };
        let drive = RollingDrive::by_creepage(Driven::Load(force), creepage);
        let rolled = contact.roll(&drive, &mut ()).unwrap();
        let f_x = rolled.state.load().f_x;
        assert!(agrees(f_x, number(row, "F_x")), "{row}: {f_x}");
        assert!(agrees(f_x / (0.33 * force), number(row, "Fx_over_f_Fz")), "{row}: {f_x}");
        assert_eq!(counts(&rolled), printed_counts(row), "{row}");
    }
}

/// Cylinders of dissimilar materials that roll along -x, by given forces. The first result is that
/// of pressures that do not feel the tractions; at f = 1e-4 they hardly do.
#[test]
fn cylinders_of_dissimilar_materials() {
    let grid = Grid::new(216, 1, 0.001, 1000.0).unwrap();
    let [one, two] =
        [[23000.0, 0.31], [82000.0, 0.28]].map(|[g, nu]| Material::from_shear(g, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    let way = Way::new(0.001).unwrap().towards(std::f64::consts::PI).unwrap();
    let all = cases();
    let results = all["bentall"]["results"].as_array().unwrap();
    for (row, friction) in results.iter().zip([1e-4, 10.0, 0.05, 0.05, 0.05]) {
        let gap = Gap::from_function(grid, |x, _| 0.02 * x * x).unwrap();
        let friction = Friction::new(friction).unwrap();
        let problem = ContactProblem::of_half_spaces(gap, pair, friction).unwrap();
        let mut contact = SteadyContact::new(&problem, way).unwrap();
        let drive = RollingDrive {
            along: Driven::Load(number(row, "F_x")),
            ..RollingDrive::by_creepage(Driven::Load(16201.9), Creepage::default())
        };
        let rolled = contact.roll(&drive, &mut ()).unwrap();
        let highest = rolled.state.pressure.values().iter().copied().fold(0.0, f64::max);
        let creepage = -rolled.creepage.along;
        assert!(agrees(creepage, number(row, "creepage")), "{row}: {creepage}");
        assert!(agrees(highest, number(row, "p_max")), "{row}: {highest}");
        assert_eq!(counts(&rolled), printed_counts(row), "{row}");
    }
}

/// A wheel in a groove of the rail by its parabola ("conformal", case 1): creepages along and across, and spin, taken at a
/// sixth of the step, in N and mm. Here the spin has the sign of that of body 1, and the torque the opposite one.
#[test]
fn a_wheel_that_slides_across_and_spins() {
    let grid = Grid::new(51, 39, 0.4, 0.4).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.000_768_59 * x * x + 0.000_980_39 * y * y).unwrap();
    let body = Material::from_shear(82_000.0, 0.28).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3).unwrap()).unwrap();
    let way = Way::new(0.4).unwrap().with_spin_at(1.0 / 6.0).unwrap();
    let mut contact = SteadyContact::new(&problem, way).unwrap();
    let creepage = Creepage { along: 0.004, across: 0.009_899_5, spin: -0.001_537_2 };
    let drive = RollingDrive::by_creepage(Driven::Shift(0.090_89), creepage);
    let rolled = contact.roll(&drive, &mut ()).unwrap();
    let load = rolled.state.load();
    let highest = rolled.state.pressure.values().iter().copied().fold(0.0, f64::max);
    let row = &cases()["conformal"]["results"][0];
    for (got, name) in
        [(load.f_x, "F_x"), (load.f_y, "F_y"), (-load.m_z, "M_z"), (highest, "p_max")]
    {
        assert!(agrees(got, number(row, name)), "{name} {got}");
    }
}

/// Polymer cylinders driven at 0.6 of the friction limit, two moduli ("visc_cylindr", cases 5 and 6).
#[test]
fn polymer_cylinders_by_force() {
    // The middle of the contact lies between two cells.
    let grid = Grid::new(99, 1, 0.16, 1000.0).unwrap();
    for row in cases()["visc_cylindr"]["results"].as_array().unwrap() {
        let modulus = number(row, "G");
        let gap = Gap::from_function(grid, |x, _| 0.01 * (x - 0.08).powi(2)).unwrap();
        let body = Material::from_shear(modulus, 0.4).unwrap();
        let pair = MaterialPair::new(body, body).unwrap();
        let friction = Friction::new(0.3).unwrap();
        let problem = ContactProblem::of_half_spaces(gap, pair, friction).unwrap();
        let mut contact = SteadyContact::new(&problem, Way::new(0.16).unwrap()).unwrap();
        let drive = RollingDrive {
            along: Driven::Load(-0.6 * 0.3 * 6e5),
            ..RollingDrive::by_creepage(Driven::Load(6e5), Creepage::default())
        };
        let rolled = contact.roll(&drive, &mut ()).unwrap();
        let highest = rolled.state.pressure.values().iter().copied().fold(0.0, f64::max);
        for (got, name) in [(-rolled.creepage.along, "creepage"), (highest, "p_max")] {
            assert!(agrees(got, number(row, name)), "{row}: {name} {got}");
        }
    }
}
