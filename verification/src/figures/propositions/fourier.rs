//! Proposition 6: the displacement by fast Fourier transforms; twice the period; many points.

use crate::{Absolute, Axis, Failure, Figure, FigureResult, Marker, Panel, Series, Table};
use carom_halfspace::operator::{
    Blocks, DisplacementField, HalfSpaceOperator, KernelOperator, SurfaceOperator, TabulatedKernel,
    Threads, TractionField, transform_length,
};
use carom_halfspace::{Coefficients, Grid, Material, MaterialPair};
use std::f64::consts::PI;

/// Cells along the diameter of the contact circle.
const MESHES: [usize; 6] = [9, 17, 33, 65, 129, 257];

/// Hertz's pressure p0 = 1 on the unit circle, and the displacement it causes there.
struct Hertz {
    grid: Grid,
    pressure: Vec<f64>,
}

/// G/(1 - nu) = 1: w = pi/8 (2 - rho^2).
fn exact(x: f64, y: f64) -> f64 {
    PI / 8.0 * (2.0 - x * x - y * y)
}

fn pair() -> Result<MaterialPair, carom_special::RangeError> {
    MaterialPair::new(Material::from_shear(0.7, 0.3)?, Material::RIGID)
}

impl Hertz {
    fn on(cells: usize) -> Result<Self, Failure> {
        let width = 2.0 / cells as f64;
        let grid = Grid::new(cells, cells, width, width)?;
        let height = |i| {
            let (x, y) = (grid.centred_x(i % cells), grid.centred_y(i / cells));
            (1.0 - x * x - y * y).max(0.0).sqrt()
        };
        Ok(Self { grid, pressure: (0..grid.cells()).map(height).collect() })
    }

    fn displacement(&self, operator: &dyn SurfaceOperator) -> Result<Vec<f64>, Failure> {
        let mut w = vec![0.0; self.grid.cells()];
        let load = TractionField::normal(&self.pressure);
        let wanted = DisplacementField::normal(&mut w);
        operator.apply(load, wanted, &mut operator.workspace())?;
        Ok(w)
    }

    /// The largest error inside the circle, relative to the centre's displacement.
    fn error(&self, operator: &dyn SurfaceOperator) -> Result<f64, Failure> {
        let cells = self.grid.nx();
        let error = |(i, w): (usize, f64)| {
            let (x, y) = (self.grid.centred_x(i % cells), self.grid.centred_y(i / cells));
            if x * x + y * y < 1.0 { (w - exact(x, y)).abs() / exact(0.0, 0.0) } else { 0.0 }
        };
        let w = self.displacement(operator)?;
        Ok(w.into_iter().enumerate().map(error).fold(0.0, f64::max))
    }

    /// The integrated coefficients (4.29).
    fn rectangles(&self) -> Result<HalfSpaceOperator, Failure> {
        let claims_that_hold =
            HalfSpaceOperator::with_blocks(pair()?, self.grid, Blocks::Normal, Threads::One);
        Ok(claims_that_hold?)
    }

    /// The function 1/r at the centres; the singular own cell counts as zero.
    fn samples(&self) -> Result<KernelOperator, Failure> {
        let grid = self.grid;
        let kernel = move |columns: i32, rows: i32| {
            let offset = grid.offset(columns, rows);
            let r = libm::hypot(offset.x, offset.y);
            let zz = if r == 0.0 { 0.0 } else { grid.cell_area() / (2.0 * PI * r) };
            Coefficients { rows: [[0.0; 3], [0.0; 3], [0.0, 0.0, zz]] }
        };
        Ok(KernelOperator::new(TabulatedKernel::from_function(grid, kernel)?, Threads::One)?)
    }

    /// The integrated coefficients repeated with the period of the grid itself: no padding.
    fn single_period(&self) -> Result<KernelOperator, Failure> {
        let operator = self.rectangles()?;
        let period = self.grid.nx() as i32;
        let wrap = |n: i32| (n + period / 2).rem_euclid(period) - period / 2;
        let kernel = |n, m| operator.coefficients(wrap(n), wrap(m));
        let kernel = TabulatedKernel::from_function(self.grid, kernel)?;
        Ok(KernelOperator::new(kernel, Threads::One)?)
    }
}

/// (4.13) term by term at a few cells, against the transforms: largest relative difference.
fn direct_difference(hertz: &Hertz) -> Result<f64, Failure> {
    let operator = hertz.rectangles()?;
    let w = hertz.displacement(&operator)?;
    let cells = hertz.grid.nx();
    let mut worst = 0.0f64;
    for receiver in (0..w.len()).step_by(97) {
        let (k, j) = ((receiver % cells) as i32, (receiver / cells) as i32);
        let terms = hertz.pressure.iter().enumerate().map(|(source, p)| {
            let (n, m) = ((source % cells) as i32, (source / cells) as i32);
            operator.coefficients(n - k, m - j).rows[2][2] * p
        });
        worst = worst.max((terms.sum::<f64>() - w[receiver]).abs());
    }
    Ok(worst / exact(0.0, 0.0))
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("period", "twice the region in each direction");
    figure.assumed("load", "Hertz's pressure on a circle, (1 - ν)/G = 1, p₀ = a = 1");
    let [mut integrated, mut sampled, mut periodic] = [const { Vec::new() }; 3];
    for cells in MESHES {
        let hertz = Hertz::on(cells)?;
        integrated.push((cells as f64, hertz.error(&hertz.rectangles()?)?));
        sampled.push((cells as f64, hertz.error(&hertz.samples()?)?));
        if cells <= 129 {
            periodic.push((cells as f64, hertz.error(&hertz.single_period()?)?));
        }
    }
    claims(&mut figure, &integrated, &sampled, &periodic)?;
    let mut panel = Panel::new(Axis::log("cells along 2a"), Axis::log("largest error of w / w(0)"));
    let curves = [
        ("integrated coefficients (4.29)", Marker::Circle, integrated),
        ("1/r at the centres", Marker::Square, sampled),
        ("(4.29), period not doubled", Marker::Triangle, periodic),
    ];
    for (colour, (name, marker, points)) in curves.into_iter().enumerate() {
        panel.add(Series::line(name, points.clone()).coloured(colour));
        panel.add(Series::markers("", marker, points).coloured(colour));
    }
    figure.panel(panel);
    waves(&mut figure)?;
    counts(&mut figure);
    figure.deviation(
        "a large number of points is necessary, as 1/r is hard to model by Fourier series",
        "with the coefficients (4.29) the transform is exact to rounding at any number of points",
        "the kernel is integrated before it is transformed; only the mesh's own error is left",
    );
    Ok(figure)
}

fn claims(
    figure: &mut Figure,
    integrated: &[(f64, f64)],
    sampled: &[(f64, f64)],
    periodic: &[(f64, f64)],
) -> Result<(), Failure> {
    let difference = direct_difference(&Hertz::on(33)?)?;
    figure
        .at_most("with twice the period the product is that of (4.13)", difference, 1e-14)
        .source("direct sum");
    let errors = |points: &[(f64, f64)]| points.iter().map(|p| p.1).collect::<Vec<_>>();
    figure
        .decreasing("convergence is certain: (4.29)", errors(integrated))
        .source("Hertz's displacement");
    figure.decreasing("and for samples of 1/r", errors(sampled)).source("Hertz's displacement");
    let last = |points: &[(f64, f64)]| points.last().map_or(f64::NAN, |p| p.1);
    let first = |points: &[(f64, f64)]| points.first().map_or(f64::NAN, |p| p.1);
    figure
        .at_least(
            "samples of 1/r need many points: error over that of (4.29), 257 cells",
            last(sampled) / last(integrated),
            10.0,
        )
        .source("the singular own cell");
    let span = libm::log(MESHES[5] as f64 / MESHES[0] as f64);
    let order = |points: &[(f64, f64)]| libm::log(first(points) / last(points)) / span;
    figure
        .close("order of samples of 1/r", order(sampled), 1.0, Absolute(0.1))
        .source("the own cell's share falls as its width");
    figure
        .at_least("order of (4.29)", order(integrated), 1.3)
        .source("square-root edge of the pressure");
    figure
        .at_least("without twice the period the error stays", last(periodic), 0.1)
        .source("images of the load");
    Ok(())
}

/// Wave number times width of the load's envelope.
const WAVES: f64 = 10.0;

/// w at the middle of p = cos(x) exp(-r^2/(2 s^2)), s = `WAVES`: the mean of 1/|k| over the
/// load's spectrum, a normal distribution about k = 1, by powers of the Laplacian.
fn wave_exact() -> f64 {
    let half_variance = 0.5 / (WAVES * WAVES);
    let (mut term, mut sum) = (1.0, 1.0);
    for k in 1..6 {
        let odd = 2.0 * f64::from(k) - 1.0;
        term *= odd * odd * half_variance / f64::from(k);
        sum += term;
    }
    sum
}

/// The relative error there with `cells` cells in a wavelength.
fn wave_error(cells: usize) -> Result<f64, Failure> {
    let width = 2.0 * PI / cells as f64;
    let count = 2 * (6.0 * WAVES / width).ceil() as usize + 1;
    let grid = Grid::new(count, count, width, width)?;
    let height = |i: usize| {
        let (x, y) = (grid.centred_x(i % count), grid.centred_y(i / count));
        libm::cos(x) * libm::exp(-0.5 * (x * x + y * y) / (WAVES * WAVES))
    };
    let load = Hertz { grid, pressure: (0..grid.cells()).map(height).collect() };
    let w = load.displacement(&load.rectangles()?)?;
    Ok((w[grid.cells() / 2] / wave_exact() - 1.0).abs())
}

/// How well a single Fourier mode is carried.
fn waves(figure: &mut Figure) -> Result<(), Failure> {
    let mut points = Vec::new();
    for cells in [2, 4, 8, 16, 32] {
        points.push((cells as f64, wave_error(cells)?));
    }
    // From 4 to 8, 8 to 16 and 16 to 32 cells; the next term is of order 3.
    let orders = points[1..].windows(2).map(|pair| libm::log2(pair[0].1 / pair[1].1));
    let orders: Vec<f64> = orders.collect();
    let source = "symbol 1/|k| of the half-space, envelope by its moments";
    figure
        .close("a Fourier mode converges with order 2", orders[2], 2.0, Absolute(0.15))
        .source(source);
    figure.increasing("and nears it as the mesh is refined", orders).source(source);
    figure.at_most("16 cells in a wavelength carry it to 1 %", points[3].1, 0.01).source(source);
    let axes = (Axis::log("cells in a wavelength"), Axis::log("error of w"));
    let mut panel = Panel::new(axes.0, axes.1).titled("One Fourier mode");
    panel.add(Series::line("(4.29)", points));
    figure.panel(panel);
    Ok(())
}

/// Multiplications of a product beside those of the direct sum.
fn counts(figure: &mut Figure) {
    let mut table =
        Table::new("Multiplications of a product", ["N", "8N log₂(4N)", "N²", "padded points"]);
    let mut padded = Vec::new();
    for cells in [16usize, 64, 256, 1024] {
        let n = (cells * cells) as f64;
        let points = transform_length(cells).pow(2) as f64;
        table.row([n, 8.0 * n * libm::log2(4.0 * n), n * n, points]);
        padded.push((points, 4.0 * n));
    }
    figure.table(table);
    figure
        .all_close("the transforms have 4N points", padded, Absolute(0.0))
        .source("period doubled in two directions, powers of two");
}
