//! CONTACT's example of a traction curve: an ellipse under thirty longitudinal creepages.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingDrive, SteadyContact, SteadyRolling, Way};
use carom_solver::{ContactProblem, Driven, Gap};

use super::printed::{Numbers, all_agree, beside, counts, number, own_counts, rows};
use crate::{Axis, Failure, Figure, FigureResult, Marker, Panel, Series, linspace};

/// Semi-axes and curvatures of Hertz's ellipse of the example, which prints four digits of them.
const SEMI_AXES: [f64; 2] = [6.303_597_245_518, 12.607_194_491_036];
const CURVATURES: [f64; 2] = [0.0008, 2.814_173_138_273e-4];
const CELLS: [usize; 2] = [48, 44];
const FORCE: f64 = 106_700.0;
const FRICTION: f64 = 0.33;

/// One creepage, in the signs of the example.
struct Row {
    xi: f64,
    /// F_x, F_x/(f F_z).
    numbers: Numbers,
}

fn contact() -> Result<SteadyContact, Failure> {
    let ([a, b], [nx, ny]) = (SEMI_AXES, CELLS);
    let grid = Grid::new(nx, ny, 2.2 * a / nx as f64, 2.2 * b / ny as f64)?;
    let [along, across] = CURVATURES;
    let gap = Gap::from_function(grid, |x, y| along * x * x + across * y * y)?;
    let body = Material::from_shear(82_000.0, 0.28)?;
    let pair = MaterialPair::new(body, body)?;
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(FRICTION)?)?;
    Ok(SteadyContact::new(&problem, Way::new(grid.dx())?)?)
}

/// Rolls by a creepage of the example; here creepages are of body 2 against body 1.
fn roll(contact: &mut SteadyContact, xi: f64) -> Result<SteadyRolling, Failure> {
    let creepage = Creepage { along: -xi, ..Creepage::default() };
    Ok(contact.roll(&RollingDrive::by_creepage(Driven::Load(FORCE), creepage), &mut ())?)
}

fn compute() -> Result<Vec<Row>, Failure> {
    let mut contact = contact()?;
    let mut computed = Vec::new();
    for row in rows("tractcurv")? {
        let xi = number(&row, "xi")?;
        let rolled = roll(&mut contact, xi)?;
        let f_x = rolled.state.load().f_x;
        let numbers = Numbers {
            printed: [number(&row, "F_x")?, number(&row, "Fx_over_f_Fz")?],
            own: [f_x, f_x / (FRICTION * FORCE)],
            printed_cells: counts(&row)?,
            own_cells: own_counts(&rolled),
        };
        computed.push(Row { xi, numbers });
    }
    Ok(computed)
}

/// The creepage up to which the curve is drawn in detail.
const DETAIL: f64 = 0.005;

/// Creepage, F_x/(f F_z) and cells that stick, closely spaced.
fn detail() -> Result<[Vec<(f64, f64)>; 2], Failure> {
    let mut contact = contact()?;
    let mut curves = [Vec::new(), Vec::new()];
    for xi in linspace(0.0, DETAIL, 26) {
        let rolled = roll(&mut contact, xi)?;
        curves[0].push((xi, -rolled.state.load().f_x / (FRICTION * FORCE)));
        curves[1].push((xi, own_counts(&rolled)[0]));
    }
    Ok(curves)
}

fn panels(rows: &[Row]) -> Result<[Panel; 3], Failure> {
    let points = |value: fn(&Row) -> f64| -> Vec<(f64, f64)> {
        rows.iter().map(|row| (row.xi, value(row))).collect()
    };
    let near = |points: Vec<(f64, f64)>| points.into_iter().filter(|point| point.0 < DETAIL);
    let (force, stick) = ("−F_x/(f F_z)", "cells that stick");
    let (printed, cells) =
        (points(|row| -row.numbers.printed[1]), points(|row| row.numbers.printed_cells[0]));
    let [own_force, own_stick] = detail()?;
    let mut one = Panel::new("ξ", force).titled("Traction up to sliding");
    one.add(Series::line("carom", own_force));
    one.add(Series::markers("CONTACT", Marker::Circle, near(printed.clone())));
    let mut two = Panel::new(Axis::log("ξ"), force).titled("All creepages");
    two.add(Series::line("carom", points(|row| -row.numbers.own[1])));
    two.add(Series::markers("CONTACT", Marker::Circle, printed));
    let mut three = Panel::new("ξ", stick).titled("Adhesion");
    three.add(Series::line("carom", own_stick));
    three.add(Series::markers("CONTACT", Marker::Circle, near(cells)));
    Ok([one, two, three])
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("bodies", "steel on steel: G = 82 000 N/mm², ν = 0.28; f = 0.33");
    figure.stated("F_z, gap", "106 700 N; 0.0008 x² + B y² with a/b = 0.5");
    figure.derived("a, b, B", "6.3036, 12.6072 mm, 2.81417e-4 / mm, by Hertz");
    figure.stated("cells", "48 × 44 on ±1.1 a, ±1.1 b; steps of one cell");
    figure.stated("sign of ξ, F_x", "as printed: body 1 against body 2; force on body 1");
    let rows = compute()?;
    for panel in panels(&rows)? {
        figure.panel(panel);
    }
    let heads = ["ξ", "F_x of CONTACT, N", "F_x/(f F_z) of CONTACT"];
    figure.table(beside(heads, rows.iter().map(|row| (row.xi.into(), &row.numbers))));
    let numbers: Vec<_> = rows.iter().map(|row| &row.numbers).collect();
    all_agree(&mut figure, ["F_x", "F_x/(f F_z)"], &numbers);
    Ok(figure)
}
