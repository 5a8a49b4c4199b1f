//! Cost of the half-space and of plates: tables, products by size and threads, interior stress.
//!
//! Sizes are cells along one axis of a square grid; the transforms are twice as long.

use std::hint::black_box;
use std::time::Duration;

use carom_halfspace::operator::{
    Blocks, CoefficientTable, DisplacementField, HalfSpaceOperator, InteriorStress, Plate,
    PlateOperator, PlateSymbol, SurfaceOperator, Threads, TractionField,
};
use carom_halfspace::{
    Grid, LoadedRectangle, Material, MaterialPair, Offset, Point, Rectangle, RectangleInfluence,
    Traction,
};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use rayon::ThreadPool;

fn dissimilar() -> MaterialPair {
    let steel = Material::from_young(208e3, 0.3).expect("a material");
    let glass = Material::from_young(70e3, 0.2).expect("a material");
    MaterialPair::new(steel, glass).expect("a pair")
}

fn square(cells: usize) -> Grid {
    Grid::new(cells, cells, 0.01, 0.01).expect("a grid")
}

fn coefficients(c: &mut Criterion) {
    let mut group = c.benchmark_group("coefficient");
    for (name, width_x) in [("square", 1.0), ("slender 1000:1", 1000.0)] {
        let cell = Rectangle::new(width_x, 1.0).expect("a cell");
        let influence = RectangleInfluence::new(dissimilar(), cell);
        for rows in [0.0, 1.0, 10.0, 1000.0] {
            let offset = Offset { x: 0.0, y: rows };
            group.bench_function(BenchmarkId::new(name, rows), |b| {
                b.iter(|| influence.coefficients(black_box(offset)));
            });
        }
    }
    group.finish();
}

fn tables(c: &mut Criterion) {
    let mut group = c.benchmark_group("table of six coefficients");
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    for cells in [256, 512, 1024, 2048] {
        let grid = square(cells);
        group.throughput(Throughput::Elements(grid.cells() as u64));
        group.bench_function(BenchmarkId::from_parameter(cells), |b| {
            b.iter(|| CoefficientTable::new(dissimilar(), grid));
        });
    }
    group.finish();
}

fn products(c: &mut Criterion) {
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let kind = if threads == 1 { Threads::One } else { Threads::Pool };
        let mut group = c.benchmark_group(format!("product, threads {threads}"));
        group.sample_size(10).measurement_time(Duration::from_secs(2));
        for cells in [64, 128, 256, 512, 1024, 2048] {
            let grid = square(cells);
            group.throughput(Throughput::Elements(grid.cells() as u64));
            product_normal(&mut group, grid, kind, &pool);
        }
        for cells in [64, 256, 1024] {
            let grid = square(cells);
            group.throughput(Throughput::Elements(grid.cells() as u64));
            product_coupled(&mut group, grid, kind, &pool);
        }
        group.finish();
    }
}

type Group<'a> = criterion::BenchmarkGroup<'a, criterion::measurement::WallTime>;

fn product_normal(group: &mut Group<'_>, grid: Grid, threads: Threads, pool: &ThreadPool) {
    let operator = HalfSpaceOperator::with_blocks(dissimilar(), grid, Blocks::Normal, threads)
        .expect("an operator");
    let mut workspace = operator.workspace();
    let pressure = vec![1.0; grid.cells()];
    let mut w = vec![0.0; grid.cells()];
    group.bench_function(BenchmarkId::new("normal", grid.nx()), |b| {
        b.iter(|| {
            let tractions = TractionField::normal(black_box(&pressure));
            let displacements = DisplacementField::normal(&mut w);
            pool.install(|| operator.apply(tractions, displacements, &mut workspace))
        });
    });
}

fn product_coupled(group: &mut Group<'_>, grid: Grid, threads: Threads, pool: &ThreadPool) {
    let operator = HalfSpaceOperator::with_blocks(dissimilar(), grid, Blocks::All, threads)
        .expect("an operator");
    let mut workspace = operator.workspace();
    let load = vec![1.0; grid.cells()];
    let [mut u, mut v, mut w] = [0; 3].map(|_| vec![0.0; grid.cells()]);
    group.bench_function(BenchmarkId::new("coupled", grid.nx()), |b| {
        b.iter(|| {
            let tractions = TractionField::full(black_box(&load), &load, &load);
            let displacements = DisplacementField::full(&mut u, &mut v, &mut w);
            pool.install(|| operator.apply(tractions, displacements, &mut workspace))
        });
    });
}

/// A product of a plate beside one of the half-space, and the set-up of plates of three thicknesses.
fn plates(c: &mut Criterion) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    let mut group = c.benchmark_group("plate");
    group.sample_size(10).measurement_time(Duration::from_secs(2));
    for cells in [128, 256, 512] {
        let plate = |thickness: f64| Plate::new(1.0, 1.0, thickness).expect("a plate");
        let grid = plate(0.1).grid(cells, cells).expect("a grid");
        let of = |thickness: f64| {
            let (pair, kind) = (dissimilar(), PlateSymbol::Layer);
            PlateOperator::new(pair, plate(thickness), grid, kind, Threads::One).expect("a plate")
        };
        for thickness in [0.1, 1e-2, 1e-4] {
            let name = format!("set-up, h/a = {thickness}");
            group.bench_function(BenchmarkId::new(name, cells), |b| {
                b.iter(|| of(black_box(thickness)));
            });
        }
        let operator = of(0.1);
        let (mut workspace, pressure) = (operator.workspace(), vec![1.0; grid.cells()]);
        let mut w = vec![0.0; grid.cells()];
        group.bench_function(BenchmarkId::new("product", cells), |b| {
            b.iter(|| {
                let tractions = TractionField::normal(black_box(&pressure));
                operator.apply(tractions, DisplacementField::normal(&mut w), &mut workspace)
            });
        });
        product_normal(&mut group, grid, Threads::One, &pool);
    }
    group.finish();
}

fn interior(c: &mut Criterion) {
    let body = Material::from_young(208e3, 0.3).expect("a material");
    let mut group = c.benchmark_group("interior stress");
    let cell = LoadedRectangle::new(body, Rectangle::new(1.0, 1.0).expect("a cell"));
    let cell = cell.expect("an elastic body");
    let load = Traction { x: 0.3, y: 0.1, normal: 1.0 };
    for depth in [0.1, 5.0, 500.0] {
        let at = Point { x: 0.3, y: 0.2, z: depth };
        group.bench_function(BenchmarkId::new("one cell, depth", depth), |b| {
            b.iter(|| cell.stress(black_box(load), black_box(at)));
        });
    }
    group.sample_size(10).measurement_time(Duration::from_secs(3));
    for cells in [64, 128, 256, 512] {
        let grid = square(cells);
        let field = InteriorStress::new(body, grid, Threads::One).expect("a field");
        let load = vec![1.0; grid.cells()];
        group.throughput(Throughput::Elements(grid.cells() as u64));
        group.bench_function(BenchmarkId::new("field by three tractions", cells), |b| {
            b.iter(|| field.at_depth(0.02, TractionField::full(black_box(&load), &load, &load)));
        });
        group.bench_function(BenchmarkId::new("field by pressure", cells), |b| {
            b.iter(|| field.at_depth(0.02, TractionField::normal(black_box(&load))));
        });
    }
    group.finish();
}

criterion_group!(benches, coefficients, tables, products, plates, interior);
criterion_main!(benches);
