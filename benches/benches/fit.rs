//! Cost of a fit: a thousand rebounds with two measured values each, and three unknowns.

use std::hint::black_box;

use carom_cases::input::CaseFile;
use carom_fit::{Data, Options, fit};
use carom_impact::restitution::of_spheres;
use criterion::{Criterion, criterion_group, criterion_main};

const ROWS: usize = 1000;
const CASE: &str = "
    body_1 = { shape = \"sphere\", radius = 2.5e-3, material = { young_modulus = 380e9, poisson = 0.23 }, density = 4000 }
    body_2 = { shape = \"plane\", material = { young_modulus = 70e9, poisson = 0.25 }, fixed = true }
    approach = { speed = 3.9, angle = 45 }
    [contact]
    friction = { fit = [0.01, 0.5] }
    normal_over_tangential_stiffness = { fit = [0.8, 1.5] }
    normal_restitution = { fit = [0.5, 1] }";

/// Ratios for friction .1, kappa 1.1 and e = .9, scattered evenly by 5 % and 2 %.
fn data() -> Data {
    let part = |i: usize, step: f64| (i as f64 * step).fract();
    let angles: Vec<f64> = (0..ROWS).map(|i| 2.0 + 58.0 * part(i, 0.618_034)).collect();
    let ratio = |(i, angle): (usize, &f64)| {
        let r_x = of_spheres(1.1, angle.to_radians().tan() / 0.1).expect("in range");
        1.0 - 1.9 / 7.0 * (1.0 + r_x) + 0.1 * (part(i, 0.754_878) - 0.5)
    };
    let ratios = angles.iter().enumerate().map(ratio).collect();
    let normal = (0..ROWS).map(|i| 0.9 + 0.04 * (part(i, 0.569_840) - 0.5)).collect();
    let columns =
        [("angle", angles), ("body_1_tangential_ratio", ratios), ("normal_restitution", normal)];
    Data::new(columns.map(|(name, values)| (name.to_owned(), values)).into()).expect("a table")
}

fn rebounds(c: &mut Criterion) {
    let data = data();
    let given = [("body_1_tangential_ratio", 0.03), ("normal_restitution", 0.012)];
    let given = given.map(|(name, error)| (Some(name.to_owned()), vec![error]));
    let mut group = c.benchmark_group("fit of 1000 rebounds, three unknowns");
    group.sample_size(20);
    for loss in ["viscous", "yield"] {
        let case = CaseFile::from_text(format!("{CASE}\nloss = \"{loss}\""));
        for (name, errors) in [("errors given", &given[..]), ("errors estimated", &[])] {
            let options = Options { errors, ..Options::default() };
            group.bench_function(format!("{loss}, {name}"), |b| {
                b.iter(|| fit(black_box(&case), &data, &options).expect("a fit"));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, rebounds);
criterion_main!(benches);
