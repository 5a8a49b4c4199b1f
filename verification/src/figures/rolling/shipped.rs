//! CONTACT's examples of a wheel that slides across and spins, and of polymer cylinders.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingDrive, SteadyContact, SteadyRolling, Way};
use carom_solver::{CellState, ContactProblem, Driven, Gap};

use super::super::printed::{Compared, SOURCE, all_digits, beside};
use super::printed::{highest, number, rows};
use crate::{Failure, Figure, FigureResult, Marker, Panel, Series};

const FRICTION: f64 = 0.3;

fn problem(
    grid: Grid,
    [modulus, poisson]: [f64; 2],
    height: impl Fn(f64, f64) -> f64,
) -> Result<ContactProblem, Failure> {
    let body = Material::from_shear(modulus, poisson)?;
    let gap = Gap::from_function(grid, height)?;
    let friction = Friction::new(FRICTION)?;
    Ok(ContactProblem::of_half_spaces(gap, MaterialPair::new(body, body)?, friction)?)
}

/// The wheel. Here the spin has the sign of that of body 1, creepages and torque the opposite ones.
fn wheel() -> Result<SteadyRolling, Failure> {
    let grid = Grid::new(51, 39, 0.4, 0.4)?;
    let gap = |x: f64, y: f64| 0.000_768_59 * x * x + 0.000_980_39 * y * y;
    let problem = problem(grid, [82_000.0, 0.28], gap)?;
    let way = Way::new(0.4)?.with_spin_at(1.0 / 6.0)?;
    let creepage = Creepage { along: 0.004, across: 0.009_899_5, spin: -0.001_537_2 };
    let drive = RollingDrive::by_creepage(Driven::Shift(0.090_89), creepage);
    Ok(SteadyContact::new(&problem, way)?.roll(&drive, &mut ())?)
}

/// Cylinders of this shear modulus, driven at 0.6 of the friction limit.
fn cylinders(modulus: f64) -> Result<SteadyRolling, Failure> {
    let grid = Grid::new(99, 1, 0.16, 1000.0)?;
    // The middle of the contact lies between two cells.
    let problem = problem(grid, [modulus, 0.4], |x, _| 0.01 * (x - 0.08).powi(2))?;
    let drive = RollingDrive {
        along: Driven::Load(-0.6 * FRICTION * 6e5),
        ..RollingDrive::by_creepage(Driven::Load(6e5), Creepage::default())
    };
    Ok(SteadyContact::new(&problem, Way::new(0.16)?)?.roll(&drive, &mut ())?)
}

/// The cells of the wheel that stick and that slip.
fn places(rolled: &SteadyRolling) -> Panel {
    let (grid, cells) = (rolled.state.pressure.grid(), rolled.state.cells.values());
    let mut panel = Panel::new("x in mm", "y in mm").titled("the wheel");
    let states = [("slips", CellState::Slip, 1), ("sticks", CellState::Stick, 0)];
    for (label, state, colour) in states {
        let of_state = grid.centres().zip(cells).filter(|(_, cell)| **cell == state);
        let points: Vec<(f64, f64)> = of_state.map(|(place, _)| place).collect();
        panel.add(Series::markers(label, Marker::Dot, points).sized(0.6).coloured(colour));
    }
    panel
}

/// Traction and friction limit of the cylinders, over the highest limit.
fn curves(rolled: &SteadyRolling, title: &str) -> Panel {
    let state = &rolled.state;
    let (grid, limit) = (state.pressure.grid(), highest(rolled));
    let mut panel = Panel::new("x in mm", "t_x/(f p_max)").titled(title);
    let along = |value: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
        (0..grid.nx()).map(|cell| (grid.centred_x(cell) - 0.08, value(cell))).collect()
    };
    let pressure = state.pressure.values();
    let traction = state.traction_x.values();
    panel.add(Series::dotted("− f p", along(&|cell| -pressure[cell] / limit)).coloured(2));
    panel.add(Series::line("t_x", along(&|cell| traction[cell] / (FRICTION * limit))).coloured(0));
    panel
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated(
        "wheel",
        "G = 82 000 N/mm², ν = 0.28, f = 0.3, 51 × 39 cells of 0.4 mm, approach 0.09089 mm",
    );
    figure.stated(
        "its creepages",
        "ξ = −0.004, η = −0.0098995, φ = −0.0015372/mm, a sixth of a step ahead",
    );
    figure.stated(
        "cylinders",
        "ν = 0.4, f = 0.3, F_z = 600 kN on 1000 mm, F_x = −0.6 f F_z, 99 × 1 cells of 0.16 mm",
    );
    figure.stated("signs", "as printed: body 1 against body 2");
    let (wheel, row) = (wheel()?, &rows("conformal")?[0]);
    let load = wheel.state.load();
    let own =
        [("F_x", load.f_x), ("F_y", load.f_y), ("M_z", -load.m_z), ("p_max", highest(&wheel))];
    let mut compared = Vec::new();
    for (name, own) in own {
        compared.push(Compared {
            name: format!("wheel: {name}"),
            printed: number(row, name)?,
            own,
        });
    }
    figure.panel(places(&wheel));
    for row in rows("visc_cylindr")? {
        let modulus = number(&row, "G")?;
        let rolled = cylinders(modulus)?;
        let title = format!("cylinders, G = {modulus} N/mm²");
        for (name, own) in [("creepage", -rolled.creepage.along), ("p_max", highest(&rolled))] {
            let printed = number(&row, name)?;
            compared.push(Compared { name: format!("{title}: {name}"), printed, own });
        }
        figure.panel(curves(&rolled, &title));
    }
    figure.table(beside(&compared));
    let pairs = compared.iter().map(|one| (one.own, one.printed));
    all_digits(&mut figure, "all numbers", pairs).source(SOURCE);
    Ok(figure)
}
