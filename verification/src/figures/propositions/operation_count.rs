//! Proposition 8: N log N products against elimination, both counted.

use crate::{
    Absolute, Axis, Cell, Failure, Figure, FigureResult, Panel, Relative, Series, Table, logspace,
};
use carom_halfspace::operator::{
    Blocks, DisplacementField, HalfSpaceOperator, KernelOperator, SurfaceOperator, TabulatedKernel,
    Threads, TractionField, transform_length,
};
use carom_halfspace::{Grid, Material, MaterialPair, Rectangle, RectangleInfluence};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Residual over the right side at which the iteration has converged.
const CONVERGED: f64 = 1e-10;

/// N^3 over N log10 N.
fn factor(points: f64) -> f64 {
    points.powi(2) / libm::log10(points)
}

fn pair() -> Result<MaterialPair, carom_special::RangeError> {
    // (1 - nu)/(2 pi G) = 1: displacements are potentials of the pressure.
    let nu = 0.3;
    let body = Material::from_shear((1.0 - nu) / (2.0 * std::f64::consts::PI), nu)?;
    MaterialPair::new(body, Material::RIGID)
}

/// The unit square in `cells` by `cells`.
fn grid(cells: usize) -> Result<Grid, carom_special::RangeError> {
    Grid::new(cells, cells, 1.0 / cells as f64, 1.0 / cells as f64)
}

/// The pressure under a rigid square that has moved by 1, by conjugate gradients.
struct Punch {
    pressure: Vec<f64>,
    force: f64,
    /// Products with the operator.
    products: usize,
}

impl Punch {
    fn press(cells: usize) -> Result<Self, Failure> {
        Self::press_to(cells, CONVERGED)
    }

    /// To a residual, over the displacement.
    fn press_to(cells: usize, residual: f64) -> Result<Self, Failure> {
        let enough = residual * residual;
        let grid = grid(cells)?;
        let operator = HalfSpaceOperator::with_blocks(pair()?, grid, Blocks::Normal, Threads::One)?;
        let mut workspace = operator.workspace();
        let count = grid.cells();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let (mut pressure, mut residual) = (vec![0.0; count], vec![1.0; count]);
        let (mut direction, mut image) = (residual.clone(), vec![0.0; count]);
        let (mut square, mut products) = (dot(&residual, &residual), 0);
        while square > enough * count as f64 {
            let load = TractionField::normal(&direction);
            operator.apply(load, DisplacementField::normal(&mut image), &mut workspace)?;
            products += 1;
            let step = square / dot(&direction, &image);
            for i in 0..count {
                pressure[i] += step * direction[i];
                residual[i] -= step * image[i];
            }
            let next = dot(&residual, &residual);
            for (d, r) in direction.iter_mut().zip(&residual) {
                *d = r + next / square * *d;
            }
            square = next;
            if products > 1000 {
                return Err("conjugate gradients do not converge".into());
            }
        }
        let force = pressure.iter().sum::<f64>() * grid.cell_area();
        Ok(Self { pressure, force, products })
    }
}

/// The same by elimination of the full matrix: pressures and multiplications.
fn eliminated(cells: usize) -> Result<(Vec<f64>, usize), Failure> {
    let width = 1.0 / cells as f64;
    let cell = RectangleInfluence::new(pair()?, Rectangle::new(width, width)?);
    let count = cells * cells;
    let mut rows = Vec::with_capacity(count);
    for i in 0..count {
        let mut row = Vec::with_capacity(count + 1);
        for j in 0..count {
            let along = (j % cells) as f64 - (i % cells) as f64;
            let across = (j / cells) as f64 - (i / cells) as f64;
            let offset = carom_halfspace::Offset { x: along * width, y: across * width };
            row.push(cell.coefficients(offset)?.rows[2][2]);
        }
        row.push(1.0);
        rows.push(row);
    }
    let mut multiplications = 0;
    for i in 0..count {
        let (above, below) = rows.split_at_mut(i + 1);
        let pivot = &above[i];
        for row in below {
            let share = row[i] / pivot[i];
            for j in i + 1..=count {
                row[j] -= share * pivot[j];
            }
            multiplications += count - i + 1;
        }
    }
    let mut pressure = vec![0.0; count];
    for i in (0..count).rev() {
        let sum: f64 = (i + 1..count).map(|j| rows[i][j] * pressure[j]).sum();
        pressure[i] = (rows[i][count] - sum) / rows[i][i];
        multiplications += count - i;
    }
    Ok((pressure, multiplications))
}

/// Coefficients that a fast product asks for, once.
fn coefficients_used(cells: usize) -> Result<usize, Failure> {
    let grid = grid(cells)?;
    let cell = RectangleInfluence::new(pair()?, Rectangle::new(grid.dx(), grid.dy())?);
    let used = AtomicUsize::new(0);
    let kernel = |n: i32, m: i32| {
        used.fetch_add(1, Ordering::Relaxed);
        cell.coefficients(grid.offset(n, m)).unwrap_or_default()
    };
    KernelOperator::new(TabulatedKernel::from_function(grid, kernel)?, Threads::One)?;
    Ok(used.into_inner())
}

/// Multiplications of a fast product: three transforms of 2^k points take (k/2) 2^k complex ones,
/// and so many more in between, four real ones each.
fn product(cells: usize) -> f64 {
    let points = (transform_length(cells) as f64).powi(2);
    4.0 * (2.0 * 0.5 * points * libm::log2(points) + points)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("N", "1000 points in the contact area");
    figure.assumed("problem", "rigid square on a half-space, N cells, residual 1e-10");
    let sizes = logspace(10.0, 1e6, 51);
    let mut panel = Panel::new(Axis::log("N"), Axis::log("multiplications"));
    type Count = fn(f64) -> f64;
    let counts: [(&str, Count); 3] = [
        ("elimination, N³", |n| n.powi(3)),
        ("direct product, N²", |n| n * n),
        ("fast product, N log₁₀ N", |n| n * libm::log10(n)),
    ];
    for (name, count) in counts {
        panel.add(Series::line(name, sizes.iter().map(|&n| (n, count(n))).collect::<Vec<_>>()));
    }
    let (mut solved, mut elimination) = (Vec::new(), Vec::new());
    for cells in [4, 8, 16, 32, 64] {
        let n = (cells * cells) as f64;
        let products = Punch::press(cells)?.products as f64;
        solved.push((n, products * product(cells)));
        if cells <= 16 {
            elimination.push((n, eliminated(cells)?.1 as f64));
        }
    }
    let marker = crate::Marker::Circle;
    panel.add(Series::markers("elimination, counted", marker, elimination).coloured(0));
    panel.add(
        Series::markers("all products of a solution", crate::Marker::Square, solved).coloured(2),
    );
    figure.panel(panel);
    figure.deviation(
        "N²/(N log N) is 333 000 for N = 1000",
        format!("N³/(N log₁₀ N) = N²/log₁₀ N = {:.0}", factor(1000.0)),
        "N²/(N log N) is 333",
    );
    punch_claims(&mut figure)?;
    count_claims(&mut figure)?;
    Ok(figure)
}

fn punch_claims(figure: &mut Figure) -> Result<(), Failure> {
    // Pressures at the edge err by ten times the residual.
    let (punch, (dense, _)) = (Punch::press_to(12, 1e-12)?, eliminated(12)?);
    let largest = dense.iter().copied().fold(0.0, f64::max);
    figure
        .all_close(
            "pressures under the square by fast products and by elimination, over the largest",
            punch.pressure.iter().zip(&dense).map(|(p, q)| (p / largest, q / largest)),
            Absolute(1e-9),
        )
        .source("elimination of the matrix of (4.29), 144 cells");
    // The capacity of a square plate of side 1, over 4 pi epsilon_0.
    let capacity = 0.366_787_4;
    let forces = [Punch::press(16)?.force, Punch::press(64)?.force];
    figure
        .close(
            "force at w = 1, 64 by 64 cells, extrapolated with 16 by 16",
            forces[1] + (forces[1] - forces[0]) / 3.0,
            capacity,
            Relative(1e-3),
        )
        .source("capacity of a square plate, 0.3667874 of its side; error linear in the width");
    Ok(())
}

fn count_claims(figure: &mut Figure) -> Result<(), Failure> {
    let mut table = Table::new(
        "Counted for a rigid square",
        ["N", "products to 1e-10", "multiplications of one", "coefficients", "elimination"],
    );
    let (mut products, mut coefficients) = (Vec::new(), Vec::new());
    for cells in [8, 16, 32, 64] {
        let n = (cells * cells) as f64;
        let punch = Punch::press(cells)?;
        let used = coefficients_used(cells)? as f64;
        let counted = if cells <= 16 {
            Cell::from(eliminated(cells)?.1 as f64)
        } else {
            Cell::from("not done")
        };
        table.row([
            Cell::from(n),
            Cell::from(punch.products as f64),
            Cell::from(product(cells)),
            Cell::from(used),
            counted,
        ]);
        products.push((n, punch.products as f64));
        coefficients.push(used / n);
    }
    figure.table(table);
    let most = coefficients.iter().copied().fold(0.0, f64::max);
    figure
        .at_most("coefficients that a fast product takes for each of its N cells", most, 4.0)
        .source("each offset once: (2n - 1)² of n² cells; a matrix takes N");
    // Condition of an integral operator of order -1: the number of cells along a side.
    let last = &products[products.len() - 2..];
    figure
        .at_most(
            "products of a solution grow, from 32² to 64² cells, by",
            last[1].1 / last[0].1,
            1.6,
        )
        .source("conjugate gradients: as the root of the condition, N^(1/4), which is 1.41");
    let (n, count) = products[products.len() - 1];
    let gain = n * n * n / 3.0 / (count * product(64));
    figure
        .at_least("elimination of 64² unknowns over a solution by fast products", gain, 300.0)
        .source("proposition 8: the gain is of order N²/log N; both counted");
    Ok(())
}
