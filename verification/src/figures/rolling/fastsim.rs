//! CONTACT's examples of FASTSIM: springs instead of elastic bodies, on the cells of a grid.

use std::f64::consts::PI;

use carom_halfspace::Grid;
use carom_laws::creep::CreepCoefficients;
use carom_rolling::{Creepage, Springs, Way};
use carom_solver::{CellState, ContactState};

use super::super::printed::{Compared, SOURCE, all_digits, beside};
use crate::reference::rows;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series, linspace};

const MODULUS: f64 = 82_000.0;
const POISSON: f64 = 0.28;

/// What the cases of an example share.
struct Contact {
    semi_axes: [f64; 2],
    cells: [usize; 2],
    force: f64,
    /// Half an ellipsoid, or a paraboloid.
    power: f64,
    speed: f64,
    friction: fn(f64) -> f64,
    /// At rest.
    rest: f64,
    coefficients: CreepCoefficients,
    /// What is left of the stiffness at first, at large creepages, and how fast it falls (Spiryagin and others, 2013).
    softening: [f64; 3],
}

/// A case as it is printed.
struct Case {
    number: f64,
    /// Of body 1 against body 2.
    creepage: [f64; 3],
    /// `F_x`, `F_y`, `M_z`, power, cells that stick and slip.
    printed: [f64; 6],
}

/// Kalker's table as it is printed; as CONTACT does, between its axis ratios below 1 linear in these, and between its Poisson's
/// ratios by the inverse coefficients.
fn printed_coefficients(ratio: f64) -> Result<CreepCoefficients, Failure> {
    let all: Vec<[f64; 10]> = rows(include_str!("../../../data/rolling/kalker_coefficients.csv"))?;
    let of = |column: usize| -> Result<f64, Failure> {
        let at = |nu: f64| {
            let of_nu = all.iter().filter(|row| row[1] == nu);
            let points: Vec<[f64; 2]> = of_nu.map(|row| [row[0], row[column]]).collect();
            let cell = points.windows(2).find(|cell| cell[0][0] <= ratio && ratio <= cell[1][0]);
            let part = |left: f64, right: f64| (ratio - left) / (right - left);
            let between = |cell: &[[f64; 2]]| {
                cell[0][1] + part(cell[0][0], cell[1][0]) * (cell[1][1] - cell[0][1])
            };
            cell.map(|cell| 1.0 / between(cell)).ok_or("beyond the table")
        };
        let (nu, [none, middle, most]) = (POISSON, [at(0.0)?, at(0.25)?, at(0.5)?]);
        let inverse = 8.0 * (nu - 0.25) * (nu - 0.5) * none - 16.0 * nu * (nu - 0.5) * middle
            + 8.0 * nu * (nu - 0.25) * most;
        Ok(1.0 / inverse)
    };
    let c23 = of(4)?;
    Ok(CreepCoefficients { c11: of(2)?, c22: of(3)?, c23, c32: c23, c33: f64::NAN })
}

impl Contact {
    /// The example fastsim, on a grid.
    fn spinning(side: usize, power: f64) -> Result<Self, Failure> {
        Ok(Self {
            semi_axes: [8.0, 4.0],
            cells: [side; 2],
            force: 82_000.0,
            power,
            speed: 30.0,
            friction: |_| 0.3,
            rest: 0.3,
            coefficients: printed_coefficients(2.0)?,
            softening: [1.0, 1.0, 0.0],
        })
    }

    /// The example tractcurv.
    fn pulling(friction: fn(f64) -> f64, softening: [f64; 3]) -> Result<Self, Failure> {
        Ok(Self {
            semi_axes: [6.303_597_245_518, 12.607_194_491_036],
            cells: [48, 44],
            force: 106_700.0,
            power: 1.0,
            speed: 10.0,
            friction,
            rest: friction(0.0),
            coefficients: printed_coefficients(0.5)?,
            softening,
        })
    }

    fn of(case: &Case) -> Result<Self, Failure> {
        match case.number {
            2.0 => Self::spinning(44, 1.0),
            3.0 => Self::spinning(44, 0.5),
            4.0 => Self::spinning(220, 0.5),
            below if below < 91.0 => Self::pulling(constant, [1.0, 1.0, 0.0]),
            _ => Self::pulling(falling, [0.54, 0.02, 0.62]),
        }
    }

    /// Three flexibilities, which become one as the creepages grow.
    fn springs(&self, creepage: [f64; 3]) -> Result<[f64; 3], Failure> {
        let ([a, b], c) = (self.semi_axes, &self.coefficients);
        let own = Springs::of_ellipse([a, b], MODULUS, c)?.flexibilities();
        let size = (a * b).sqrt();
        let unit = self.rest * self.force / (MODULUS * a * b);
        let length = |[x, y, z]: [f64; 3]| (x * x + y * y + z * z).sqrt();
        let units = [unit / c.c11, unit / c.c22, unit / (size * c.c23)];
        let weight = (length(creepage) / length(units) / 3.0).min(1.0);
        let [x, y, spin] = creepage;
        let motions = [x, y, spin * 3.0 * PI * a / 32.0].map(|motion| motion * motion);
        let stiff: f64 = motions.iter().zip(own).map(|(motion, own)| motion / own).sum();
        let one = motions.iter().sum::<f64>() / stiff;
        Ok(own.map(|own| (1.0 - weight) * own + weight * one))
    }

    /// What is left of the stiffness at a creepage along, by an ellipse as large as the cells in contact and with their
    /// proportions.
    fn stiffness(&self, state: &ContactState, along: f64, friction: f64) -> Result<f64, Failure> {
        let grid = state.pressure.grid();
        let touching: Vec<(f64, f64)> = grid
            .centres()
            .zip(state.pressure.values())
            .filter(|(_, pressure)| **pressure > 0.0)
            .map(|(place, _)| place)
            .collect();
        let ends = touching.iter().fold([0.0_f64; 2], |[x, y], at| [x.max(at.0), y.max(at.1)]);
        let ratio = (ends[0] + 0.5 * grid.dx()) / (ends[1] + 0.5 * grid.dy());
        let area = touching.len() as f64 * grid.cell_area();
        let [first, last, rate] = self.softening;
        if rate == 0.0 {
            return Ok(first);
        }
        let c11 = printed_coefficients(ratio)?.c11;
        let slope = 0.25 * MODULUS * area * first * c11 * along / (friction * self.force);
        Ok(first * (last + (1.0 - last) / (1.0 + rate * slope)))
    }

    /// As printed: forces, torque, power in W, and counts.
    fn roll(&self, creepage: [f64; 3]) -> Result<[f64; 6], Failure> {
        let ([a, b], [nx, ny]) = (self.semi_axes, self.cells);
        let grid = Grid::new(nx, ny, 2.2 * a / nx as f64, 2.2 * b / ny as f64)?;
        let highest = (1.0 + self.power) * self.force / (PI * a * b);
        let mut state = ContactState::apart(grid);
        for (own, (x, y)) in state.pressure.values_mut().iter_mut().zip(grid.centres()) {
            let inside = 1.0 - (x / a).powi(2) - (y / b).powi(2);
            *own = highest * inside.max(0.0).powf(self.power);
        }
        let [along, across, spin] = creepage;
        let friction = (self.friction)(1e3 * self.speed * along.hypot(across));
        let stiffness = self.stiffness(&state, along, friction)?;
        let springs = Springs::new(self.springs(creepage)?.map(|own| own / stiffness))?;
        let way = Way::new(grid.dx())?.with_spin_at(1.0 / 6.0)?;
        // Here creepages are of body 2 against body 1.
        let rigid = Creepage { along: -along, across: -across, spin };
        let heat = springs.roll(&way, rigid, |_| friction, &mut state)?;
        let load = state.load();
        let [stick, slip] =
            [CellState::Stick, CellState::Slip].map(|cell| state.count(cell) as f64);
        Ok([load.f_x, load.f_y, -load.m_z, -self.speed * heat, stick, slip])
    }
}

fn constant(_: f64) -> f64 {
    0.33
}

/// By the slip velocity, mm/s.
fn falling(velocity: f64) -> f64 {
    0.1368 + 0.2232 * (-velocity / 990.0).exp2()
}

fn cases() -> Result<Vec<Case>, Failure> {
    let all: Vec<[f64; 10]> = rows(include_str!("../../../data/rolling/fastsim_printed.csv"))?;
    let case = |[number, x, y, spin, printed @ ..]: [f64; 10]| Case {
        number,
        creepage: [x, y, spin],
        printed,
    };
    Ok(all.into_iter().map(case).collect())
}

/// The traction curve of springs, with the printed cases.
fn curve(cases: &[Case]) -> Result<Panel, Failure> {
    let mut panel = Panel::new("ξ", "−F_x/(f F_z)").titled("Traction by springs");
    let contact = Contact::pulling(constant, [1.0, 1.0, 0.0])?;
    let part = |force: f64| -force / (constant(0.0) * contact.force);
    let mut own = Vec::new();
    for xi in linspace(1e-4, 0.005, 50) {
        let [f_x, ..] = contact.roll([xi, 0.0, 0.0])?;
        own.push((xi, part(f_x)));
    }
    panel.add(Series::line("carom", own));
    let of_curve = cases.iter().filter(|case| (62.0..91.0).contains(&case.number));
    let printed = of_curve.map(|case| (case.creepage[0], part(case.printed[0])));
    panel.add(Series::markers("CONTACT", Marker::Circle, printed));
    Ok(panel)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("bodies", "steel on steel: G = 82 000 N/mm², ν = 0.28");
    figure.stated("cases 2 to 4", "a = 8, b = 4 mm, F_z = 82 kN, f = 0.3, sliding across and spin");
    figure.stated("cases from 62", "the ellipse of the traction curve, F_z = 106.7 kN, f = 0.33");
    figure.stated("cases from 91", "f = 0.1368 + 0.2232/2^(v/990 mm/s), and softer springs");
    figure.stated("flexibilities", "by Kalker's table as printed, which CONTACT interpolates");
    let cases = cases()?;
    let (mut compared, mut counts) = (Vec::new(), Vec::new());
    for case in &cases {
        let own = Contact::of(case)?.roll(case.creepage)?;
        for (i, name) in ["F_x", "F_y", "M_z", "power"].into_iter().enumerate() {
            if case.printed[i] != 0.0 {
                let name = format!("case {}: {name}", case.number);
                compared.push(Compared { name, printed: case.printed[i], own: own[i] });
            }
        }
        counts.extend([4, 5].map(|i| (own[i], case.printed[i])));
    }
    figure.panel(curve(&cases)?);
    figure.table(beside(&compared));
    let pairs = compared.iter().map(|one| (one.own, one.printed));
    all_digits(&mut figure, "all numbers", pairs).source(SOURCE);
    figure.all_close("cells that stick and slip", counts, Absolute(0.0)).source(SOURCE);
    Ok(figure)
}
