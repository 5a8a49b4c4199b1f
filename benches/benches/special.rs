//! Every special function and numerical tool of layer 1.

use carom_special::AxisRatio;
use carom_special::elliptic::{Amplitude, complete, incomplete};
use carom_special::gamma::gamma;
use carom_special::hypergeometric::{Gauss, ThreeFTwo, UnitArgument, gauss};
use carom_special::quadrature::{GaussLegendre, Tolerance, adaptive, tanh_sinh};
use carom_special::roots::{Bracket, brent};
use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;

fn elliptic(criterion: &mut Criterion) {
    type Complete = fn(AxisRatio) -> f64;
    let functions: [(&str, Complete); 5] = [
        ("K", complete::k),
        ("E", complete::e),
        ("D", complete::d),
        ("B", complete::b),
        ("C", complete::c),
    ];
    let mut group = criterion.benchmark_group("complete");
    for (place, ratio) in [("slender", 0.1), ("round", 0.7)] {
        let ratio = AxisRatio::new(ratio).expect("positive");
        for (name, function) in functions {
            group.bench_function(format!("{name} {place}"), |b| {
                b.iter(|| function(black_box(ratio)));
            });
        }
    }
    group.finish();
    type Incomplete = fn(AxisRatio, Amplitude) -> f64;
    let functions: [(&str, Incomplete); 3] =
        [("F", incomplete::f), ("E", incomplete::e), ("D", incomplete::d)];
    let (ratio, amplitude) = (AxisRatio::new(0.3), Amplitude::from_cosine(0.4));
    let (ratio, amplitude) = (ratio.expect("positive"), amplitude.expect("cosine"));
    let mut group = criterion.benchmark_group("incomplete");
    for (name, function) in functions {
        group.bench_function(name, |b| {
            b.iter(|| function(black_box(ratio), black_box(amplitude)));
        });
    }
    group.finish();
}

fn hypergeometric(criterion: &mut Criterion) {
    let argument = |x| UnitArgument::new(x).expect("in the unit interval");
    let (a, b, c) = (-0.476, 0.576, 0.6);
    let mut group = criterion.benchmark_group("hypergeometric");
    let thesis = Gauss::new(a, b, c).expect("in range");
    let logarithmic = Gauss::new(0.5, 0.5, 1.0).expect("in range");
    for x in [0.3, 0.8] {
        group.bench_function(format!("2F1 at {x}"), |bench| {
            bench.iter(|| thesis.at(black_box(argument(x))));
        });
    }
    group.bench_function("2F1 at 0.8 with its gammas", |bench| {
        bench.iter(|| gauss(black_box(a), b, c, argument(0.8)));
    });
    group.bench_function("2F1 at 0.999, logarithmic", |bench| {
        bench.iter(|| logarithmic.at(black_box(argument(0.999))));
    });
    group.bench_function("3F2, both expansions", |bench| {
        bench.iter(|| ThreeFTwo::new(black_box(0.4), 0.024, 1.076, 0.6));
    });
    let three = ThreeFTwo::new(0.4, 0.024, 1.076, 0.6).expect("in range");
    for x in [0.3, 0.8] {
        group.bench_function(format!("3F2 at {x}"), |bench| {
            bench.iter(|| three.at(black_box(argument(x))));
        });
    }
    group.bench_function("gamma", |bench| bench.iter(|| gamma(black_box(2.4))));
    group.finish();
}

fn tools(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("tools");
    let bracket = Bracket::new(0.0, 2.0).expect("bracket");
    group.bench_function("Brent, cube root of 2", |b| {
        b.iter(|| brent(|x| x * x * x - black_box(2.0), bracket, 0.0));
    });
    group.bench_function("Gauss-Legendre, nodes of 20", |b| {
        b.iter(|| GaussLegendre::new(black_box(20)));
    });
    let function = |x: f64| 1.0 / (1.0 + x * x);
    let rule = GaussLegendre::new(20).expect("order");
    group.bench_function("Gauss-Legendre, 20 nodes", |b| {
        b.iter(|| rule.integrate(black_box(0.0), 1.0, function));
    });
    let tolerance = Tolerance::relative(1e-12).expect("positive");
    group.bench_function("Gauss-Kronrod, adaptive", |b| {
        b.iter(|| adaptive(black_box(0.0), 1.0, tolerance, function));
    });
    group.bench_function("tanh-sinh", |b| {
        b.iter(|| tanh_sinh(black_box(0.0), 1.0, tolerance, |at| function(at.position)));
    });
    group.finish();
}

criterion_group!(benches, elliptic, hypergeometric, tools);
criterion_main!(benches);
