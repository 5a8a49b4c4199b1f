//! CONTACT's examples of a wheel that slides across and spins, of polymer cylinders, and of friction that falls.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_rolling::{Creepage, RollingDrive, RollingFriction, SteadyContact, SteadyRolling, Way};
use carom_solver::{ContactProblem, Driven, Gap};

use super::super::printed::{Compared, SOURCE, all_digits, beside};
use super::printed::{counts, highest, number, own_counts, places, rows};
use crate::{Absolute, Failure, Figure, FigureResult, Panel, Series};

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

/// A cylinder on a plane whose friction is halved, beyond a limit, every 100 mm/s of slip.
fn falling() -> Result<SteadyRolling, Failure> {
    let grid = Grid::new(92, 1, 0.1, 200.0)?;
    let problem = problem(grid, [82_000.0, 0.28], |x, _| (x - 0.05).powi(2) / 920.0)?;
    let law = SlipSpeedFriction::new(0.18, 0.12, std::f64::consts::LN_2 / 100.0)?;
    let contact = SteadyContact::new(&problem, Way::new(0.1)?)?;
    let mut contact = contact.with_friction_by_slip(RollingFriction::new(law, 45_000.0)?);
    let creepage = Creepage { along: 0.000_999_9, ..Creepage::default() };
    Ok(contact.roll(&RollingDrive::by_creepage(Driven::Load(622_216.0), creepage), &mut ())?)
}

/// Traction and friction limit at rest, over the highest limit, of a contact about a middle.
fn curves(rolled: &SteadyRolling, title: &str, (limited, sign): (&str, f64), middle: f64) -> Panel {
    let state = &rolled.state;
    let (grid, limit) = (state.pressure.grid(), highest(rolled));
    let mut panel = Panel::new("x in mm", "t_x/(f p_max)").titled(title);
    let along = |value: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
        (0..grid.nx()).map(|cell| (grid.centred_x(cell) - middle, value(cell))).collect()
    };
    let pressure = state.pressure.values();
    let traction = state.traction_x.values();
    panel.add(Series::dotted(limited, along(&|cell| sign * pressure[cell] / limit)).coloured(2));
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
    figure.stated(
        "falling friction",
        "a cylinder of radius 460 mm, F_z = 622 kN on 200 mm, ξ = −0.0009999, 92 × 1 cells of 0.1 mm; \
         f = 0.18 + 0.12/2^(v/100 mm/s) at 45 m/s",
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
    let panel = Panel::new("x in mm", "y in mm").titled("the wheel");
    figure.panel(places(&wheel.state, panel));
    for row in rows("visc_cylindr")? {
        let modulus = number(&row, "G")?;
        let rolled = cylinders(modulus)?;
        let title = format!("cylinders, G = {modulus} N/mm²");
        for (name, own) in [("creepage", -rolled.creepage.along), ("p_max", highest(&rolled))] {
            let printed = number(&row, name)?;
            compared.push(Compared { name: format!("{title}: {name}"), printed, own });
        }
        figure.panel(curves(&rolled, &title, ("− f p", -1.0), 0.08));
    }
    let (rolled, row) = (falling()?, &rows("veldep_fric")?[0]);
    for (name, own) in [("F_x", rolled.state.load().f_x), ("p_max", highest(&rolled))] {
        compared.push(Compared {
            name: format!("falling friction: {name}"),
            printed: number(row, name)?,
            own,
        });
    }
    let cells = own_counts(&rolled).into_iter().zip(counts(row)?);
    figure
        .all_close("falling friction: cells that stick and slip", cells, Absolute(0.0))
        .source(SOURCE);
    figure.panel(curves(&rolled, "falling friction", ("f p at rest", 1.0), 0.05));
    figure.table(beside(&compared));
    let pairs = compared.iter().map(|one| (one.own, one.printed));
    all_digits(&mut figure, "all numbers", pairs).source(SOURCE);
    Ok(figure)
}
