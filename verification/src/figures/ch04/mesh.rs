//! Fig. 4.1: the mesh of the contact area, and what it costs to store its coefficients.

use super::super::Failure;
use crate::{Axis, Cell, Claim, Figure, FigureResult, Panel, Series, Table, Tolerance};
use carom_halfspace::operator::CoefficientTable;
use carom_halfspace::{
    Coefficients, Grid, Material, MaterialPair, Offset, Rectangle, RectangleInfluence,
};

const ROWS: usize = 4;
const COLUMNS: usize = 9;

fn pair() -> Result<MaterialPair, carom_special::RangeError> {
    MaterialPair::new(Material::from_shear(1.0, 0.3)?, Material::from_shear(2.0, 0.2)?)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("rows and columns", "4 by 9, cells of 2Δx by 2Δy, (0, 0) in the corner");
    figure.assumed("materials", "G₁ = 1, ν₁ = 0.3, G₂ = 2, ν₂ = 0.2; 2Δx = 1, 2Δy = 0.5");
    let mut panel = Panel::new(Axis::linear("x"), Axis::linear("y")).equal_aspect();
    for column in 0..=COLUMNS {
        let x = column as f64;
        panel.add(Series::line("", [(x, 0.0), (x, 0.5 * ROWS as f64)]).coloured(0));
    }
    for row in 0..=ROWS {
        let y = 0.5 * row as f64;
        panel.add(Series::line("", [(0.0, y), (COLUMNS as f64, y)]).coloured(0));
    }
    figure.panel(panel);
    coefficient_claims(&mut figure)?;
    memory_claims(&mut figure)?;
    figure.deviation(
        "(4.20) y_m = y_0 - 2Δy m together with 2Δy = y_2 - y_1",
        "rows counted in +y",
        "the two relations contradict each other; the signs of (4.23) need one sense",
    );
    figure.deviation("(4.15), r with y_k", "y_j", "y carries the row index, see (4.14)");
    Ok(figure)
}

fn coefficient_claims(figure: &mut Figure) -> Result<(), Failure> {
    let table = CoefficientTable::new(pair()?, Grid::new(COLUMNS, ROWS, 1.0, 0.5)?)?;
    let cell = RectangleInfluence::new(pair()?, Rectangle::new(1.0, 0.5)?);
    let (nx, ny) = (COLUMNS as i32, ROWS as i32);
    let (mut asymmetry, mut parity) = (0.0f64, 0.0f64);
    for n in 1 - nx..nx {
        for m in 1 - ny..ny {
            let (a, back) = (table.coefficients(n, m), table.coefficients(-n, -m));
            let offset = Offset { x: f64::from(n), y: 0.5 * f64::from(m) };
            parity = parity.max(difference(&a, &cell.coefficients(offset)?));
            for i in 0..3 {
                for l in 0..3 {
                    asymmetry = asymmetry.max((a.rows[i][l] - back.rows[l][i]).abs());
                }
            }
        }
    }
    figure.claim(
        Claim::at_most("A[i,j,k; l,m,n] = A[l,m,n; i,j,k]", asymmetry, 0.0)
            .source("text below (4.23)"),
    );
    figure.claim(
        Claim::at_most("(4.23) from offsets >= 0 gives every sign of (4.14)", parity, 0.0)
            .source("(4.14) at the true offset"),
    );
    let quarter = RectangleInfluence::new(pair()?, Rectangle::new(0.5, 0.25)?);
    let offset = Offset { x: 2.0, y: -1.0 };
    let mut sum = Coefficients::default();
    for (x, y) in [(-0.25, -0.125), (0.25, -0.125), (-0.25, 0.125), (0.25, 0.125)] {
        let part = quarter.coefficients(Offset { x: offset.x + x, y: offset.y + y })?;
        for (s, p) in sum.rows.iter_mut().flatten().zip(part.rows.iter().flatten()) {
            *s += p;
        }
    }
    let error = difference(&sum, &cell.coefficients(offset)?);
    figure.claim(
        Claim::at_most("four quarters act as the whole cell", error, 1e-15).source("additivity"),
    );
    let integrals = Rectangle::new(1.0, 0.5)?.integrals(offset)?;
    figure.claim(
        Claim::close(
            "∫dS/r is the sum of the integrals of the second derivatives of r",
            integrals.xx + integrals.yy,
            integrals.inverse_distance,
            Tolerance::Relative(1e-15),
        )
        .source("(4.29)"),
    );
    Ok(())
}

fn difference(a: &Coefficients, b: &Coefficients) -> f64 {
    let pairs = a.rows.iter().flatten().zip(b.rows.iter().flatten());
    pairs.fold(0.0, |worst, (a, b)| worst.max((a - b).abs()))
}

/// The counts in the text after (4.23) beside those of this library.
fn memory_claims(figure: &mut Figure) -> Result<(), Failure> {
    let grid = Grid::new(20, 20, 1.0, 1.0)?;
    let cells = grid.cells() as f64;
    let similar =
        MaterialPair::new(Material::from_shear(1.0, 0.3)?, Material::from_shear(1.0, 0.3)?)?;
    let six = CoefficientTable::new(pair()?, grid)?.size_in_bytes() as f64;
    let four = CoefficientTable::new(similar, grid)?.size_in_bytes() as f64;
    let (row, whole) = (9.0 * cells * 8.0, 9.0 * cells * cells * 8.0);
    let mut table = Table::new("Bytes for 20 by 20 cells", ["what is stored", "bytes"]);
    for (what, bytes) in [
        ("nine coefficients of one cell, (4.23)", row),
        ("the whole matrix", whole),
        ("six independent coefficients", six),
        ("four for similar bodies", four),
    ] {
        table.row([Cell::from(what), Cell::from(bytes)]);
    }
    figure.table(table);
    let source = "text after (4.23)";
    for (what, bytes, stated) in
        [("28 kB for (4.23)", row, 28_800.0), ("11.5 MB for the whole matrix", whole, 11.52e6)]
    {
        figure.claim(Claim::close(what, bytes, stated, Tolerance::Absolute(0.0)).source(source));
    }
    figure.claim(
        Claim::close(
            "the matrix takes 400 times more",
            whole / row,
            400.0,
            Tolerance::Absolute(0.0),
        )
        .source(source),
    );
    let parts = [(six / row, 6.0 / 9.0), (four / row, 4.0 / 9.0)];
    figure.claim(
        Claim::all_close(
            "this library keeps six of nine, or four",
            parts,
            Tolerance::Absolute(1e-15),
        )
        .source("independent entries of (4.23)"),
    );
    Ok(())
}
