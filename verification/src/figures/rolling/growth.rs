//! How many products one steady creepage takes as the elements become smaller.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingDrive, SteadyContact, Way};
use carom_solver::{ContactProblem, Driven, Gap, Products};

use crate::{Axis, Failure, Figure, FigureResult, Marker, Panel, Series, Table, logspace};

/// Elements across the diameter of the contact.
const SIDES: [usize; 5] = [25, 50, 100, 200, 400];
const POISSON: f64 = 0.28;
const FRICTION: f64 = 0.3;
const CREEPAGE: Creepage = Creepage { along: 0.15, across: 0.05, spin: 0.1 };

/// The products for one creepage, from nothing, to the usual tolerance.
fn products(side: usize) -> Result<Products, Failure> {
    let width = 2.0 / side as f64;
    let grid = Grid::new(side + 4, side + 2, width, width)?;
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
    let body = Material::from_shear(1.0, POISSON)?;
    let pair = MaterialPair::new(body, body)?;
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(FRICTION)?)?;
    // Radius of the contact 1, by Hertz.
    let force = Driven::Load(4.0 / (3.0 * (1.0 - POISSON)));
    let mut contact = SteadyContact::new(&problem, Way::new(width)?)?;
    let rolled = contact.roll(&RollingDrive::by_creepage(force, CREEPAGE), &mut ())?;
    Ok(rolled.convergence.products)
}

/// Offset and slope of the line of least squares through points.
fn line(points: &[(f64, f64)]) -> [f64; 2] {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let rise: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    let run: f64 = points.iter().map(|point| (point.0 - x).powi(2)).sum();
    [y - rise / run * x, rise / run]
}

/// The power of the cells with which the count grows without a preconditioner: conjugate gradients
/// take the square root of the condition number, which for influence coefficients grows with the
/// elements a side, the square root of the cells.
const UNAIDED: f64 = 0.25;

fn table(counted: &[Products]) -> Table {
    let heads = ["elements a side", "normal influence", "tangential influence", "preconditioner"];
    let mut table = Table::new("Products", heads).shown_to(3);
    for (side, products) in SIDES.into_iter().zip(counted) {
        let Products { normal, tangential, preconditioner, .. } = *products;
        table.row([side as f64, normal, tangential, preconditioner]);
    }
    table
}

fn panel(points: &[(f64, f64)], [offset, doubling]: [f64; 2]) -> Panel {
    let sides = logspace(SIDES[0] as f64, SIDES[SIDES.len() - 1] as f64, 41);
    let first = points[0].1;
    let law = sides.iter().map(|side| (*side, offset + doubling * side.log2()));
    let root = sides.iter().map(|side| (*side, first * (side / sides[0]).sqrt()));
    let mut panel = Panel::new(Axis::log("elements a side"), Axis::log("products"));
    panel.add(Series::markers("counted", Marker::Dot, points.to_vec()));
    panel.add(Series::line(format!("{offset:.0} + {doubling:.0} log₂(elements a side)"), law));
    panel.add(Series::dotted("root of the elements a side", root));
    panel
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.snapshot_digits(2);
    figure.assumed("contact", "sphere, equal bodies, ν = 0.28, f = 0.3, normal force given");
    figure.assumed("creepage", "0.15 along, 0.05 across, spin 0.1; solved from nothing");
    figure.assumed(
        "counted",
        "in products on the whole grid; one on coarser grids counts as its part",
    );
    let counted: Result<Vec<_>, _> = SIDES.map(products).into_iter().collect();
    let counted = counted?;
    let all = |products: &Products| products.normal + products.tangential + products.coupling;
    let points: Vec<(f64, f64)> =
        SIDES.into_iter().map(|side| side as f64).zip(counted.iter().map(all)).collect();
    let logs: Vec<_> = points.iter().map(|(side, count)| (side.log2(), *count)).collect();
    let powers: Vec<_> = points.iter().map(|(side, count)| (2.0 * side.ln(), count.ln())).collect();
    let (law, [_, exponent]) = (line(&logs), line(&powers));
    figure.panel(panel(&points, law));
    figure.table(table(&counted));
    figure
        .at_most("products grow with this power of the cells", exponent, 0.5 * UNAIDED)
        .source("half of 1/4, the power of conjugate gradients without a preconditioner");
    let worst = logs.iter().map(|(x, count)| (count / (law[0] + law[1] * x) - 1.0).abs());
    figure
        .at_most("off a law linear in log N, part of the count", worst.fold(0.0, f64::max), 0.1)
        .source("a preconditioner that is as good on any grid leaves at most logarithms");
    Ok(figure)
}
