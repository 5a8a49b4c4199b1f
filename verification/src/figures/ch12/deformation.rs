//! Fig. 12.2: the same stress on elements 1 and 2, and the structure of the matrix.

use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series};
use carom_halfspace::operator::{HalfSpaceOperator, SurfaceOperator as _};
use carom_halfspace::{Grid, Material, MaterialPair};
use nalgebra::DMatrix;

const COLUMNS: usize = 8;
const ROWS: usize = 3;

fn operator() -> Result<HalfSpaceOperator, Failure> {
    let grid = Grid::new(COLUMNS, ROWS, 1.0, 1.0)?;
    let pair = MaterialPair::new(Material::from_shear(1.0, 0.0)?, Material::from_shear(1.0, 0.5)?)?;
    Ok(HalfSpaceOperator::new(pair, grid)?)
}

/// Displacement `of` of one element by a unit stress `by` on another.
fn entry(operator: &HalfSpaceOperator, [of, by]: [usize; 2], [at, from]: [usize; 2]) -> f64 {
    let columns = (from % COLUMNS) as i32 - (at % COLUMNS) as i32;
    let rows = (from / COLUMNS) as i32 - (at / COLUMNS) as i32;
    operator.coefficients(columns, rows).rows[of][by]
}

fn row(operator: &HalfSpaceOperator, loaded: usize) -> Vec<(f64, f64)> {
    (0..COLUMNS).map(|at| (at as f64, entry(operator, [0, 0], [at, loaded]))).collect()
}

/// Greatest deviation of a part from a structure, over its largest entry: with `[blocks, within]`,
/// +1 for symmetric, -1 for skew.
fn deviation(operator: &HalfSpaceOperator, part: [usize; 2], [blocks, within]: [f64; 2]) -> f64 {
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    let at = |column: usize, row: usize| column + COLUMNS * row;
    for j in 0..ROWS {
        for m in 0..ROWS {
            for k in 0..COLUMNS {
                for n in 0..COLUMNS {
                    let value = entry(operator, part, [at(k, j), at(n, m)]);
                    let across = entry(operator, part, [at(k, m), at(n, j)]);
                    let inside = entry(operator, part, [at(n, j), at(k, m)]);
                    largest = largest.max(value.abs());
                    worst = worst.max((across - blocks * value).abs());
                    worst = worst.max((inside - within * value).abs());
                }
            }
        }
    }
    worst / largest
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("mesh", "three rows of eight squares of side 1; G = 1, ν = 0 and 1/2");
    let operator = operator()?;
    let (first, second) = (row(&operator, 0), row(&operator, 1));
    let mut panel = Panel::new("element of the first row", "u")
        .titled("Deformation of the first row by unit stress");
    panel.add(Series::line("", first.clone()).coloured(0));
    panel.add(Series::markers("on element 1", Marker::Circle, first.clone()).coloured(0));
    panel.add(Series::line("", second.clone()).coloured(1));
    panel.add(Series::markers("on element 2", Marker::Square, second.clone()).coloured(1));
    figure.panel(panel);

    let shifted = first.iter().zip(&second[1..]).map(|((_, one), (_, two))| (*two, *one));
    figure
        .all_close("the second is the first, moved by one", shifted, Absolute(0.0))
        .source("(12.13): constant diagonals");
    figure
        .close("and symmetric about its element", second[0].1, second[2].1, Absolute(0.0))
        .source("(12.13): bⱼₖ stands on both sides of the diagonal");
    let count = 3 * COLUMNS * ROWS;
    let whole = DMatrix::from_fn(count, count, |i, l| {
        let cells = COLUMNS * ROWS;
        entry(&operator, [i / cells, l / cells], [i % cells, l % cells])
    });
    let skew = (&whole - whole.transpose()).amax() / whole.amax();
    figure.at_most("A is symmetric", skew, 1e-15).source("(12.15)");
    let least = whole.symmetric_eigenvalues().min() / whole.amax();
    figure.at_least("and positive definite", least, 1e-3).source("(12.18)");
    let structures = [
        ("A₁₁: symmetric blocks, symmetric arrangement", [0, 0], [1.0, 1.0], "(12.11), (12.13)"),
        ("A₁₂: skew blocks, skew arrangement", [0, 1], [-1.0, -1.0], "(12.14)"),
        ("A₁₃: skew blocks, symmetric arrangement", [0, 2], [1.0, -1.0], "(4.23)"),
        ("A₂₃: symmetric blocks, skew arrangement", [1, 2], [-1.0, 1.0], "(4.23)"),
    ];
    for (statement, part, signs, source) in structures {
        let worst = deviation(&operator, part, signs);
        figure.at_most(statement, worst, 1e-15).source(source);
    }
    let printed = deviation(&operator, [0, 2], [-1.0, 1.0]);
    figure
        .at_least("printed structure of A₁₃ does not hold", printed, 0.5)
        .source("text before (12.15)");
    figure.deviation(
        "A₁₃: symmetric blocks in skew arrangement, A₂₃: skew blocks in symmetric arrangement",
        "the other way round",
        "A₁₃ is odd in x, along the rows; the text before (12.15) exchanges the two",
    );
    Ok(figure)
}
