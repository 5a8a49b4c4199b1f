//! CONTACT's example of a conformal contact: a gap given by heights, creepages that vary over it.

use std::f64::consts::FRAC_PI_4;
use std::sync::Arc;

use carom_halfspace::operator::{
    DisplacementField, RolledOperator, SurfaceOperator as _, Threads, TractionField,
};
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingDrive, SteadyContact, SteadyRolling, Way};
use carom_solver::{ContactProblem, Driven, Gap, StoredEnergy};

use super::super::printed::{Compared, SOURCE, all_digits, beside, off};
use super::printed::highest;
use crate::reference::rows;
use crate::{Absolute, Arrow, Failure, Figure, FigureResult, Panel, Point, Series};

const CELLS: [usize; 2] = [51, 39];
const WIDTH: f64 = 0.4;
/// The heights are those at this approach.
const APPROACH: f64 = 0.090_89;
const FRICTION: f64 = 0.3;
/// Velocity of rolling, in m/s.
const VELOCITY: f64 = 30.0;
/// Radius of the wheel, which rolls about an axis at 45 degrees to the middle of the contact.
const RADIUS: f64 = 460.0;
/// Of so many cells in a line one has an arrow.
const THINNED: usize = 3;
/// Length of the arrow of the friction limit at the highest pressure.
const ARROW: f64 = 1.6;

/// The numbers that the example prints for a case.
const NAMES: [&str; 7] = ["F_z", "F_x", "F_y", "M_z", "p_max", "elastic energy", "friction power"];

/// What the tables of the example say of a row of cells.
struct Row {
    /// At x = 0, less the approach.
    height: f64,
    /// Rigid slip along, and across in the first and last cell.
    slip: [f64; 3],
    /// Cells in contact.
    cells: f64,
}

fn table() -> Result<Vec<Row>, Failure> {
    let rows: Vec<[f64; 6]> = rows(include_str!("../../../data/rolling/conformal_rows.csv"))?;
    let row = |[_, height, along, first, last, cells]: [f64; 6]| Row {
        height,
        slip: [along, first, last],
        cells,
    };
    Ok(rows.into_iter().map(row).collect())
}

fn grid() -> Result<Grid, Failure> {
    Ok(Grid::new(CELLS[0], CELLS[1], WIDTH, WIDTH)?)
}

/// A value in each cell, from its row and its x.
fn field(table: &[Row], value: impl Fn(&Row, f64) -> f64) -> Result<Field, Failure> {
    let grid = grid()?;
    let row = |cell: usize| &table[cell / grid.nx()];
    let values = grid.centres().enumerate().map(|(cell, (x, _))| value(row(cell), x));
    Ok(Field::new(grid, values.collect())?)
}

fn problem(table: &[Row]) -> Result<ContactProblem, Failure> {
    let curvature = FRAC_PI_4.cos() / (2.0 * RADIUS);
    let heights = field(table, |row, x| row.height + curvature * x * x + APPROACH)?;
    let steel = Material::from_shear(82_000.0, 0.28)?;
    let pair = MaterialPair::new(steel, steel)?;
    Ok(ContactProblem::of_half_spaces(Gap::new(heights)?, pair, Friction::new(FRICTION)?)?)
}

/// One of the cases.
struct Case {
    title: &'static str,
    problem: ContactProblem,
    way: Way,
    /// Creepages that vary, along and across; here they are of body 2 against body 1.
    local: [Field; 2],
    drive: RollingDrive,
}

/// The part of a step ahead at which the example takes the shift of a spin.
const SPIN_AT: f64 = 1.0 / 6.0;

/// Case 2: creepages are the same everywhere, the shift of a spin taken at this part of a step.
fn constant(table: &[Row], spin_at: f64) -> Result<Case, Failure> {
    let creepage = Creepage { along: 0.004, across: 0.009_899_5, spin: -0.001_537_2 };
    Ok(Case {
        title: "the same creepages everywhere",
        problem: problem(table)?,
        way: Way::new(WIDTH)?.with_spin_at(spin_at)?,
        local: [Field::uniform(grid()?, 0.0), Field::uniform(grid()?, 0.0)],
        drive: RollingDrive::by_creepage(Driven::Shift(APPROACH), creepage),
    })
}

/// Case 4: each row slips at its own radius and spins about its own normal.
fn varying(table: &[Row]) -> Result<Case, Failure> {
    let end = 0.5 * (CELLS[0] - 1) as f64 * WIDTH;
    let across = |row: &Row, x: f64| {
        let [_, first, last] = row.slip;
        -f64::midpoint(first, last) - (last - first) * x / (2.0 * end)
    };
    Ok(Case {
        title: "creepages that vary",
        problem: problem(table)?,
        way: Way::new(WIDTH)?,
        local: [field(table, |row, _| -row.slip[0])?, field(table, across)?],
        drive: RollingDrive::by_creepage(Driven::Shift(APPROACH), Creepage::default()),
    })
}

impl Case {
    fn roll(&self) -> Result<SteadyRolling, Failure> {
        let contact = SteadyContact::new(&self.problem, self.way)?;
        let [along, across] = self.local.clone();
        let mut contact = contact.with_local_creepage(along, across)?;
        Ok(contact.roll(&self.drive, &mut ())?)
    }

    /// Friction heat per distance rolled as the sum of tractions times slips, as the example prints
    /// it: also with the work of the tractions on the change of what they displace themselves, which
    /// on a grid is not zero.
    fn heat_by_slips(&self, rolled: &SteadyRolling) -> Result<f64, Failure> {
        let state = &rolled.state;
        let [x, y] = [state.traction_x.values(), state.traction_y.values()];
        let body = Arc::clone(self.problem.shared_operator());
        let change = RolledOperator::new(body, self.way.ahead(), Threads::One)?;
        let [mut u, mut v] = [vec![0.0; x.len()], vec![0.0; x.len()]];
        change.apply(
            TractionField::tangential(x, y),
            DisplacementField::tangential(&mut u, &mut v),
            &mut change.workspace(),
        )?;
        let work: f64 = (0..x.len()).map(|cell| x[cell] * u[cell] + y[cell] * v[cell]).sum();
        Ok(rolled.heat - state.pressure.grid().cell_area() * work / self.way.length())
    }

    /// Energy in J, power in W.
    fn numbers(&self, rolled: &SteadyRolling) -> Result<[f64; 7], Failure> {
        let load = rolled.state.load();
        let energy = 1e-3 * StoredEnergy::of(&self.problem, &rolled.state)?.total();
        let power = VELOCITY * self.heat_by_slips(rolled)?;
        // The torque of the example turns the other way.
        Ok([load.f_z, load.f_x, load.f_y, -load.m_z, highest(rolled), energy, power])
    }
}

/// Pressures, and tractions as arrows.
fn panel(case: &Case, rolled: &SteadyRolling) -> Result<Panel, Failure> {
    let state = &rolled.state;
    let (grid, pressure) = (state.pressure.grid(), state.pressure.values());
    let x = (0..grid.nx()).map(|column| grid.centred_x(column)).collect();
    let y = (0..grid.ny()).map(|row| grid.centred_y(row)).collect();
    let map = carom_plot::Field::new("p in N/mm²", x, y, pressure.to_vec())?;
    let mut panel = Panel::new("x in mm", "y in mm").titled(case.title).equal_aspect().over(map);
    let scale = ARROW / (FRICTION * highest(rolled));
    let has_arrow = |cell: &usize| {
        let (column, row) = (cell % grid.nx(), cell / grid.nx());
        pressure[*cell] > 0.0 && column % THINNED == 1 && row % THINNED == 1
    };
    let places: Vec<(f64, f64)> = grid.centres().collect();
    let arrows = (0..grid.cells()).filter(has_arrow).map(|cell| {
        let (x, y) = places[cell];
        let [along, across] =
            [&state.traction_x, &state.traction_y].map(|t| scale * t.values()[cell]);
        Arrow { tail: Point::new(x, y), head: Point::new(x + along, y + across) }
    });
    panel.add(Series::arrows("traction", arrows));
    Ok(panel)
}

/// The cells in contact in each row, from the lowest.
fn cells_in_rows(rolled: &SteadyRolling) -> Vec<f64> {
    let rows = rolled.state.pressure.values().chunks(CELLS[0]);
    rows.map(|row| row.iter().filter(|p| **p > 0.0).count() as f64).collect()
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("bodies", "steel on steel: G = 82 000 N/mm², ν = 0.28; f = 0.3");
    figure.stated("gap", "heights of 51 × 39 cells of 0.4 mm; radii 10 and 10.2 mm across");
    figure.stated("approach", "0.09089 mm, in the heights");
    figure.stated(
        "creepages",
        "ξ = −0.004, η = −0.0098995, φ = −0.0015372/mm, a sixth of a step ahead; \
         or rigid slips cell by cell",
    );
    figure.stated("signs", "as printed: body 1 against body 2");
    let table = table()?;
    let printed: Vec<[f64; 8]> = rows(include_str!("../../../data/rolling/conformal_printed.csv"))?;
    let mut compared = Vec::new();
    for (case, printed) in [constant(&table, SPIN_AT)?, varying(&table)?].iter().zip(&printed) {
        let rolled = case.roll()?;
        figure.panel(panel(case, &rolled)?);
        let own = case.numbers(&rolled)?;
        for ((name, own), printed) in NAMES.into_iter().zip(own).zip(&printed[1..]) {
            compared.push(Compared {
                name: format!("{}: {name}", case.title),
                printed: *printed,
                own,
            });
        }
        let cells = cells_in_rows(&rolled).into_iter().zip(table.iter().map(|row| row.cells));
        let statement = format!("{}: cells in contact, row by row", case.title);
        figure.all_close(statement, cells, Absolute(0.0)).source(SOURCE);
        figure
            .holds(format!("{}: all of them slip", case.title), rolled.slides, 1.0)
            .source(SOURCE);
    }
    figure.table(beside(&compared));
    let pairs = compared.iter().map(|one| (one.own, one.printed));
    all_digits(&mut figure, "all numbers", pairs).source(SOURCE);
    for (spin_at, place) in [(0.0, "at the end of a step"), (0.5, "in its middle")] {
        let case = constant(&table, spin_at)?;
        let own = case.numbers(&case.roll()?)?;
        let worst = own.into_iter().zip(&printed[0][1..]).map(|(own, printed)| off(own, *printed));
        let statement = format!("with the spin {place}: worst difference, in the same units");
        figure.at_least(statement, worst.fold(0.0, f64::max), 2.0).source(SOURCE);
    }
    Ok(figure)
}
