//! Maps whose width, height and spacings differ: nothing but the names of the axes tells x from y.

use carom_drawn::{Draw as _, Xorshift};
use carom_surface::{Measures, Spectrum, Topography, spectrum, spikes};
use carom_table::Value;

/// A rough map that rises by 1 um along x and by 3 um along y; one point is missing, and one lies far off.
fn oblong(columns: usize, rows: usize, spike: f64) -> Topography {
    let mut draw = Xorshift(3);
    let part = |i: usize, count: usize| i as f64 / (count - 1) as f64;
    let height = |at: usize| {
        let plane = 1e-6 * part(at % columns, columns) + 3e-6 * part(at / columns, rows);
        plane + 1e-7 * draw.part().powi(2)
    };
    let mut heights: Vec<f64> = (0..columns * rows).map(height).collect();
    heights[3 * columns + 2] = f64::NAN;
    heights[5 * columns + 4] += spike;
    Topography::new(columns, heights).unwrap().spaced(Some([2e-6, 5e-6]))
}

/// The map in a mirror that exchanges x and y.
fn on_its_side(map: &Topography) -> Topography {
    let (columns, rows) = (map.columns(), map.rows());
    let heights = (0..columns * rows).map(|at| map.heights()[at % rows * columns + at / rows]);
    let spacing = map.spacing().map(|[dx, dy]| [dy, dx]);
    Topography::new(rows, heights.collect()).unwrap().spaced(spacing)
}

fn measured(map: &Topography) -> (Measures, Spectrum) {
    let spectrum = spectrum(map, true).unwrap();
    (Measures::of(map, Some(&spectrum), &spikes(map)), spectrum)
}

fn value(of: &Measures, name: &str) -> f64 {
    let column = Measures::COLUMNS.iter().find(|column| column.name() == name).unwrap();
    match column.value(of) {
        Value::Number(number) => number,
        Value::Count(count) => count as f64,
        _ => f64::NAN,
    }
}

#[track_caller]
fn same(one: f64, other: f64) {
    let is_same = (one - other).abs() <= 1e-9 * other.abs() || one.is_nan() && other.is_nan();
    assert!(is_same, "{one} {other}");
}

/// Of the longest map only the middle is transformed.
#[test]
fn a_map_on_its_side_exchanges_x_and_y() {
    for (columns, rows, spike) in [(37, 21, 0.0), (37, 21, 1e-4), (9, 2100, 0.0)] {
        let map = oblong(columns, rows, spike);
        let [(one, waves), (other, on_side)] = [measured(&map), measured(&on_its_side(&map))];
        for name in Measures::COLUMNS.iter().map(|column| column.name()) {
            let exchanged = match name {
                "columns" => "rows".to_owned(),
                "rows" => "columns".to_owned(),
                _ if name.ends_with("_x") => name.replace("_x", "_y"),
                _ => name.replace("_y", "_x"),
            };
            same(value(&other, &exchanged), value(&one, name));
        }
        assert_eq!(waves.density.len(), on_side.density.len());
        let all = waves.density.iter().zip(&on_side.density);
        all.for_each(|(one, other)| (0..2).for_each(|k| same(one[k], other[k])));
        let places = [&one, &other].map(|of| of.spike.map(|spike| [spike.row, spike.column]));
        assert_eq!(places, [[6, 5], [5, 6]].map(|place| (spike > 0.0).then_some(place)));
        let told = [&one, &other].map(|of| of.warnings(true).concat());
        let along = ["x", "y"].map(|axis| format!("along {axis} the step over the border"));
        assert_eq!(told[0].contains(&along[0]), told[1].contains(&along[1]));
        assert_eq!(told[0].contains(&along[1]), told[1].contains(&along[0]));
    }
}

/// What is left without the plane of best fit is orthogonal to 1, x and y; its moments are sums of powers.
#[test]
fn plane_and_moments_are_those_of_least_squares() {
    let map = oblong(37, 21, 0.0);
    let (found, _) = measured(&map);
    let known: Vec<[f64; 3]> = (0..37 * 21)
        .map(|at| [(at % 37) as f64 / 36.0, (at / 37) as f64 / 20.0, map.heights()[at]])
        .filter(|[_, _, height]| !height.is_nan())
        .collect();
    let mean = |of: &dyn Fn([f64; 3]) -> f64| {
        known.iter().map(|point| of(*point)).sum::<f64>() / known.len() as f64
    };
    let rise = ["rise_x", "rise_y"].map(|name| value(&found, name));
    let without = |[x, y, height]: [f64; 3]| height - rise[0] * x - rise[1] * y;
    let middle = mean(&without);
    let rest = |point: [f64; 3]| without(point) - middle;
    let rms = mean(&|point| rest(point).powi(2)).sqrt();
    for k in 0..2 {
        assert!(mean(&|point| rest(point) * point[k]).abs() < 1e-9 * rms);
    }
    same(value(&found, "rms_height_level"), rms);
    same(value(&found, "skewness"), mean(&|point| (rest(point) / rms).powi(3)));
    same(value(&found, "kurtosis"), mean(&|point| (rest(point) / rms).powi(4)));
    same(value(&found, "lowest"), known.iter().map(|point| point[2]).fold(1.0, f64::min));
    same(value(&found, "highest"), known.iter().map(|point| point[2]).fold(-1.0, f64::max));
}
