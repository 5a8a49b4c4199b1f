//! CONTACT's example of Bentall and Johnson's: cylinders of dissimilar materials, rolling by force.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingDrive, SteadyContact, SteadyRolling, Way};
use carom_solver::{CellState, ContactProblem, Driven, Gap};

use super::printed::{Numbers, all_agree, beside, counts, highest, number, own_counts, rows};
use crate::{Cell, Failure, Figure, FigureResult, Marker, Panel, Series};

/// Shear modulus and Poisson's ratio of bodies 1 and 2.
const BODIES: [[f64; 2]; 2] = [[23_000.0, 0.31], [82_000.0, 0.28]];
const CELLS: usize = 216;
const WIDTH: f64 = 0.001;
const LENGTH: f64 = 1000.0;
const FORCE: f64 = 16_201.9;
/// Of the five results. In the first the pressures of the example do not feel the tractions, which
/// at this friction matters below the printed digits.
const FRICTIONS: [f64; 5] = [1e-4, 10.0, 0.05, 0.05, 0.05];
/// The same in words.
const TITLES: [&str; 5] = [
    "f = 0.0001, F_x = 0",
    "f = 10, F_x = 0",
    "f = 0.05, F_x = 0",
    "f = 0.05, F_x = 0.75 f F_z",
    "f = 0.05, F_x = −0.75 f F_z",
];

struct Row {
    /// Creepage, in the signs of the example, and highest pressure.
    numbers: Numbers,
    friction: f64,
    rolled: SteadyRolling,
}

fn roll(friction: f64, along: f64) -> Result<SteadyRolling, Failure> {
    let grid = Grid::new(CELLS, 1, WIDTH, LENGTH)?;
    let [one, two] = BODIES.map(|[modulus, poisson]| Material::from_shear(modulus, poisson));
    let pair = MaterialPair::new(one?, two?)?;
    let gap = Gap::from_function(grid, |x, _| 0.02 * x * x)?;
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(friction)?)?;
    let way = Way::new(WIDTH)?.towards(std::f64::consts::PI)?;
    let drive = RollingDrive {
        along: Driven::Load(along),
        ..RollingDrive::by_creepage(Driven::Load(FORCE), Creepage::default())
    };
    Ok(SteadyContact::new(&problem, way)?.roll(&drive, &mut ())?)
}

fn compute() -> Result<Vec<Row>, Failure> {
    let printed = rows("bentall")?;
    let compute = |(row, friction): (&serde_json::Value, f64)| -> Result<Row, Failure> {
        let rolled = roll(friction, number(row, "F_x")?)?;
        let numbers = Numbers {
            printed: [number(row, "creepage")?, number(row, "p_max")?],
            // Here creepages are of body 2 against body 1.
            own: [-rolled.creepage.along, highest(&rolled)],
            printed_cells: counts(row)?,
            own_cells: own_counts(&rolled),
        };
        Ok(Row { numbers, friction, rolled })
    };
    printed.iter().zip(FRICTIONS).map(compute).collect()
}

/// The points of a value in the cells that stick and in those that slip.
fn points(row: &Row, value: impl Fn(usize) -> f64) -> [Vec<(f64, f64)>; 2] {
    let (grid, cells) = (row.rolled.state.pressure.grid(), row.rolled.state.cells.values());
    [CellState::Stick, CellState::Slip].map(|state| {
        let of_state = (0..cells.len()).filter(|cell| cells[*cell] == state);
        of_state.map(|cell| (grid.centred_x(cell), value(cell))).collect()
    })
}

/// Tractions over the highest friction limit, against x; cells that stick and that slip apart.
fn panel(row: &Row, title: &str) -> Panel {
    let state = &row.rolled.state;
    let (pressure, traction) = (state.pressure.values(), state.traction_x.values());
    let highest = row.numbers.own[1];
    let mut panel = Panel::new("x in mm", "t_x/(f p_max)").titled(title);
    for (label, sign) in [("± f p", 1.0), ("", -1.0)] {
        let mut limit = points(row, |cell| sign * pressure[cell] / highest).concat();
        limit.sort_by(|one, other| one.0.total_cmp(&other.0));
        panel.add(Series::dotted(label, limit).coloured(2));
    }
    let [stick, slip] = points(row, |cell| traction[cell] / (row.friction * highest));
    panel.add(Series::markers("slips", Marker::Dot, slip).sized(0.6).coloured(1));
    panel.add(Series::markers("sticks", Marker::Dot, stick).sized(0.7).coloured(0));
    // The contact moves along -x.
    panel.add(Series::note("← leading edge", (-0.107, 0.88)).coloured(3));
    panel
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("bodies", "G = 23 000 and 82 000 N/mm², ν = 0.31 and 0.28; gap 0.02 x²");
    figure.stated("F_z", "16 201.9 N on a length of 1000 mm");
    figure.stated("cells", "216 × 1 of 0.001 × 1000 mm; steps of one cell, along −x");
    figure.stated("sign of ξ", "as printed: body 1 against body 2");
    let rows = compute()?;
    for (row, title) in rows.iter().zip(TITLES) {
        figure.panel(panel(row, title));
    }
    let numbers: Vec<_> = rows.iter().map(|row| &row.numbers).collect();
    let heads = ["", "ξ of CONTACT", "p_max of CONTACT, N/mm²"];
    figure.table(beside(heads, TITLES.map(Cell::from).into_iter().zip(numbers.iter().copied())));
    all_agree(&mut figure, ["ξ", "p_max"], &numbers);
    Ok(figure)
}
