//! Fig. 4.1: the mesh of the contact area, and the memory for its coefficients.

use std::f64::consts::PI;

use crate::{
    Absolute, Arrow, Axis, Cell, Failure, Figure, FigureResult, Panel, Relative, Series, Table,
};
use carom_halfspace::operator::CoefficientTable;
use carom_halfspace::{
    Coefficients, Grid, Material, MaterialPair, Offset, Rectangle, RectangleInfluence,
};
use carom_special::quadrature::GaussLegendre;

const ROWS: usize = 4;
const COLUMNS: usize = 9;
/// 2Δx and 2Δy.
const WIDTHS: [f64; 2] = [1.0, 0.5];
/// Source and receiver of the sketch: column, row.
const SOURCE: [usize; 2] = [2, 1];
const RECEIVER: [usize; 2] = [6, 3];

/// G and ν of both bodies.
const BODIES: [[f64; 2]; 2] = [[1.0, 0.3], [2.0, 0.2]];

fn pair() -> Result<MaterialPair, carom_special::RangeError> {
    let [one, two] = BODIES.map(|[shear, nu]| Material::from_shear(shear, nu));
    MaterialPair::new(one?, two?)
}

fn outline([column, row]: [usize; 2]) -> Vec<(f64, f64)> {
    let (x, y) = (column as f64, row as f64);
    [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
        .map(|(right, up)| ((x + right) * WIDTHS[0], (y + up) * WIDTHS[1]))
        .to_vec()
}

fn centre([column, row]: [usize; 2]) -> (f64, f64) {
    ((column as f64 + 0.5) * WIDTHS[0], (row as f64 + 0.5) * WIDTHS[1])
}

fn mesh() -> Panel {
    let mut panel = Panel::new(
        Axis::linear("x").between(-1.2, COLUMNS as f64 + 0.4),
        Axis::linear("y").between(-0.6, 2.6),
    )
    .titled("Rows j in y, columns k in x")
    .equal_aspect();
    for column in 0..=COLUMNS {
        let x = column as f64 * WIDTHS[0];
        panel.add(Series::line("", [(x, 0.0), (x, ROWS as f64 * WIDTHS[1])]).coloured(6));
    }
    for row in 0..=ROWS {
        let y = row as f64 * WIDTHS[1];
        panel.add(Series::line("", [(0.0, y), (COLUMNS as f64 * WIDTHS[0], y)]).coloured(6));
    }
    panel.add(Series::area("corner cell (0, 0)", outline([0, 0])).coloured(4));
    panel.add(Series::area("loaded cell (n, m)", outline(SOURCE)).coloured(1));
    panel.add(Series::area("displaced cell (k, j)", outline(RECEIVER)).coloured(0));
    let arrow = |tail: (f64, f64), head: (f64, f64)| Arrow { tail: tail.into(), head: head.into() };
    let offset = [arrow(centre(SOURCE), centre(RECEIVER))];
    panel.add(Series::arrows("offset of the coefficient", offset).coloured(2));
    // The size of a cell, as double arrows along two of its sides.
    let (left, below) = (-0.2, -0.15);
    panel.add(
        Series::arrows(
            "",
            [
                arrow((0.0, below), (WIDTHS[0], below)),
                arrow((WIDTHS[0], below), (0.0, below)),
                arrow((left, 0.0), (left, WIDTHS[1])),
                arrow((left, WIDTHS[1]), (left, 0.0)),
            ],
        )
        .coloured(3),
    );
    panel.add(Series::note("2Δx", (0.25, below - 0.38)).coloured(3));
    panel.add(Series::note("2Δy", (left - 0.85, 0.1)).coloured(3));
    panel
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("rows and columns", "4 by 9, cells of 2Δx by 2Δy, (0, 0) in the corner");
    figure.assumed("materials", "G₁ = 1, ν₁ = 0.3, G₂ = 2, ν₂ = 0.2; 2Δx = 1, 2Δy = 0.5");
    figure.panel(mesh());
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

/// Displacements of body 2 against body 1 at the origin under unit forces (columns) at (x, y):
/// the kernels (4.4) to (4.6), to be integrated over a cell.
fn kernel(x: f64, y: f64) -> [[f64; 3]; 3] {
    let [[g_1, nu_1], [g_2, nu_2]] = BODIES;
    let (flexible, lateral) = (1.0 / g_1 + 1.0 / g_2, nu_1 / g_1 + nu_2 / g_2);
    // The coupling (1 - 2 ν)/(2 G) of the two bodies has opposite signs.
    let spread = 0.5 * ((1.0 - 2.0 * nu_1) / g_1 - (1.0 - 2.0 * nu_2) / g_2);
    let square = x * x + y * y;
    let r = square.sqrt();
    let direct = |along: f64| (flexible - lateral + lateral * along * along / square) / r;
    let cross = lateral * x * y / (square * r);
    let [by_x, by_y] = [spread * x / square, spread * y / square];
    [[direct(x), cross, by_x], [cross, direct(y), by_y], [-by_x, -by_y, (flexible - lateral) / r]]
        .map(|row| row.map(|value| value / (2.0 * PI)))
}

/// The kernels over the cell at this offset, by Gauss's rule.
fn quadrature(rule: &GaussLegendre, x: f64, y: f64) -> [[f64; 3]; 3] {
    let mut sum = [[0.0; 3]; 3];
    for along in rule.on(x - 0.5 * WIDTHS[0], x + 0.5 * WIDTHS[0]) {
        for across in rule.on(y - 0.5 * WIDTHS[1], y + 0.5 * WIDTHS[1]) {
            let weight = along.weight * across.weight;
            let values = kernel(along.position, across.position);
            for (sum, value) in sum.iter_mut().flatten().zip(values.iter().flatten()) {
                *sum += weight * value;
            }
        }
    }
    sum
}

fn coefficient_claims(figure: &mut Figure) -> Result<(), Failure> {
    let [dx, dy] = WIDTHS;
    let table = CoefficientTable::new(pair()?, Grid::new(COLUMNS, ROWS, dx, dy)?)?;
    let rule = GaussLegendre::new(48)?;
    let (nx, ny) = (COLUMNS as i32, ROWS as i32);
    let (mut stored, mut reciprocal) = (Vec::new(), Vec::new());
    for n in 1 - nx..nx {
        for m in (1 - ny..ny).filter(|m| (n, *m) != (0, 0)) {
            let expected = quadrature(&rule, f64::from(n) * dx, f64::from(m) * dy);
            let (here, back) = (table.coefficients(n, m), table.coefficients(-n, -m));
            let largest = expected[2][2];
            for (i, row) in expected.iter().enumerate() {
                for (l, value) in row.iter().enumerate() {
                    stored.push((here.rows[i][l] / largest, value / largest));
                    reciprocal.push((back.rows[l][i] / largest, value / largest));
                }
            }
        }
    }
    figure
        .all_close("nine coefficients at 118 offsets of either sign", stored, Absolute(1e-12))
        .source("kernels (4.4) to (4.6) written out, Gauss's rule over each cell");
    figure
        .all_close(
            "A[i,j,k; l,m,n] = A[l,m,n; i,j,k]: back and exchanged",
            reciprocal,
            Absolute(1e-12),
        )
        .source("text below (4.23), by the same quadrature");
    own_cell_claim(figure, &table);
    let quarter = RectangleInfluence::new(pair()?, Rectangle::new(0.5 * dx, 0.5 * dy)?);
    let offset = Offset { x: 2.0, y: -1.0 };
    let mut sum = [[0.0; 3]; 3];
    for (x, y) in [(-0.25, -0.125), (0.25, -0.125), (-0.25, 0.125), (0.25, 0.125)] {
        let part = quarter.coefficients(Offset { x: offset.x + x, y: offset.y + y })?;
        for (sum, part) in sum.iter_mut().flatten().zip(part.rows.iter().flatten()) {
            *sum += part;
        }
    }
    let whole = quadrature(&rule, offset.x, offset.y);
    let pairs = sum.into_iter().flatten().zip(whole.into_iter().flatten());
    figure
        .all_close("four quarters act as the whole cell", pairs, Absolute(1e-13))
        .source("additivity, the whole by quadrature");
    let integrals = Rectangle::new(dx, dy)?.integrals(offset)?;
    let direct: f64 = rule
        .on(offset.x - 0.5 * dx, offset.x + 0.5 * dx)
        .flat_map(|along| {
            let across = rule.on(offset.y - 0.5 * dy, offset.y + 0.5 * dy);
            across.map(move |across| {
                along.weight * across.weight / libm::hypot(along.position, across.position)
            })
        })
        .sum();
    figure
        .all_close(
            "∫dS/r, itself and as the sum of the integrals of the second derivatives of r",
            [(integrals.inverse_distance, direct), (integrals.xx + integrals.yy, direct)],
            Relative(1e-13),
        )
        .source("(4.29); Gauss's rule over the cell");
    Ok(())
}

/// Under its own cell, where 1/r is singular: ∫dS/r and its parts by wedges about the centre.
fn own_cell_claim(figure: &mut Figure, table: &CoefficientTable) {
    let [x, y] = WIDTHS.map(|width| 0.5 * width);
    // Of ∫y²/r³ dS: sides x = const; of ∫x²/r³ dS: sides y = const.
    let wedge = |side: f64, other: f64| 4.0 * side * libm::asinh(other / side);
    let (over_x, over_y) = (wedge(y, x), wedge(x, y));
    let [[g_1, nu_1], [g_2, nu_2]] = BODIES;
    let (flexible, lateral) = (1.0 / g_1 + 1.0 / g_2, nu_1 / g_1 + nu_2 / g_2);
    let normal = (flexible - lateral) * (over_x + over_y);
    let expected =
        [normal + lateral * over_x, normal + lateral * over_y, normal].map(|v| v / (2.0 * PI));
    let own = table.coefficients(0, 0).rows;
    figure
        .all_close(
            "the cell under its own load",
            (0..3).map(|i| (own[i][i], expected[i])),
            Relative(1e-14),
        )
        .source("(4.4) to (4.6) in polar coordinates: ∫x²/r³ dS = 4 Δy arsinh(Δx/Δy)");
}

/// Number of values of different magnitude, zero excluded, among the nine coefficients.
fn distinct(coefficients: &Coefficients) -> usize {
    let mut sizes: Vec<f64> =
        coefficients.rows.iter().flatten().map(|a| a.abs()).filter(|a| *a > 1e-12).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
    sizes.len()
}

/// The counts in the text after (4.23) beside those of this library.
fn memory_claims(figure: &mut Figure) -> Result<(), Failure> {
    let grid = Grid::new(20, 20, 1.0, 1.0)?;
    let cells = grid.cells() as f64;
    let body = Material::from_shear(1.0, 0.3)?;
    let similar = MaterialPair::new(body, body)?;
    let six = CoefficientTable::new(pair()?, grid)?.size_in_bytes() as f64;
    let four = CoefficientTable::new(similar, grid)?.size_in_bytes() as f64;
    let mut table = Table::new("Bytes for 20 by 20 cells", ["what is stored", "bytes"]);
    for (what, bytes) in [
        ("nine coefficients of one cell, (4.23)", 9.0 * cells * 8.0),
        ("the whole matrix", 9.0 * cells * cells * 8.0),
        ("six independent coefficients", six),
        ("four for similar bodies", four),
    ] {
        table.row([Cell::from(what), Cell::from(bytes)]);
    }
    figure.table(table);
    figure
        .all_close(
            "bytes of the library's table: 6/9 and 4/9 of the text's 28.8 kB",
            [(six, 19_200.0), (four, 12_800.0)],
            Absolute(0.0),
        )
        .source("text after (4.23): 28.8 kB for nine doubles of 400 cells");
    let cell = Rectangle::new(1.0, 1.0)?;
    let at = Offset { x: 3.0, y: 2.0 };
    let mut counts = Vec::new();
    for (materials, count) in [(pair()?, 6.0), (similar, 4.0)] {
        let found = RectangleInfluence::new(materials, cell).coefficients(at)?;
        counts.push((distinct(&found) as f64, count));
    }
    figure
        .all_close(
            "independent entries of the nine: six, or four for similar bodies",
            counts,
            Absolute(0.0),
        )
        .source("symmetry of (4.23); no coupling for ε = 0");
    Ok(())
}
