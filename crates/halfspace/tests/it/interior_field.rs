//! The stress field of a grid, compared with the sum over cells and with Hertz's pressure.

use carom_halfspace::operator::{InteriorStress, OperatorError, Threads, TractionField};
use carom_halfspace::{Grid, LoadedRectangle, Material, Point, Stress, Traction};

fn listed(s: Stress) -> [f64; 6] {
    [s.xx, s.yy, s.zz, s.xy, s.yz, s.zx]
}

fn wave(count: usize, k: f64) -> Vec<f64> {
    (0..count).map(|i| (k * i as f64).sin() + 0.3).collect()
}

#[test]
fn field_is_the_sum_over_the_cells() {
    let grid = Grid::new(9, 14, 0.5, 0.2).unwrap();
    let body = Material::from_shear(1.0, 0.27).unwrap();
    let (x, y, p) = (wave(126, 1.1), wave(126, 2.3), wave(126, 0.7));
    let cell = LoadedRectangle::new(body, grid.cell()).unwrap();
    for threads in [Threads::One, Threads::Pool] {
        let interior = InteriorStress::new(body, grid, threads).unwrap();
        let fields = interior.at_depths(&[0.0, 0.07, 1.0], TractionField::full(&x, &y, &p));
        for field in fields.unwrap() {
            for receiver in [0, 40, 66, 125] {
                let mut expected = Stress::default();
                for source in 0..126 {
                    let load = Traction { x: x[source], y: y[source], normal: p[source] };
                    let step =
                        |axis: fn(usize) -> usize| axis(receiver) as f64 - axis(source) as f64;
                    let at = Point {
                        x: 0.5 * step(|i| i % 9),
                        y: 0.2 * step(|i| i / 9),
                        z: field.depth,
                    };
                    expected = expected + cell.stress(load, at).unwrap();
                }
                let found = field.stress(receiver);
                for (f, e) in listed(found).iter().zip(listed(expected)) {
                    assert!((f - e).abs() < 1e-13, "{receiver} at {}: {f} {e}", field.depth);
                }
            }
        }
    }
}

#[test]
fn one_traction_alone_needs_no_other() {
    let grid = Grid::new(6, 5, 1.0, 1.0).unwrap();
    let body = Material::from_shear(1.0, 0.27).unwrap();
    let interior = InteriorStress::new(body, grid, Threads::One).unwrap();
    let (y, zero) = (wave(30, 2.3), vec![0.0; 30]);
    let alone = TractionField { y: Some(&y), ..Default::default() };
    let alone = interior.at_depth(0.4, alone).unwrap();
    let full = interior.at_depth(0.4, TractionField::full(&zero, &y, &zero)).unwrap();
    for (a, b) in alone.iter().zip(full.iter()) {
        for (a, b) in listed(a).iter().zip(listed(b)) {
            assert!((a - b).abs() < 1e-14);
        }
    }
    assert!(interior.at_depth(0.4, TractionField::default()).unwrap().xx.iter().all(|s| *s == 0.0));
}

#[test]
fn bad_depths_and_fields_are_named() {
    let grid = Grid::new(2, 2, 1.0, 1.0).unwrap();
    let body = Material::from_shear(1.0, 0.27).unwrap();
    let interior = InteriorStress::new(body, grid, Threads::One).unwrap();
    let p = [1.0; 4];
    for depth in [-1.0, f64::NAN, f64::INFINITY] {
        let error = interior.at_depth(depth, TractionField::normal(&p)).unwrap_err();
        assert!(matches!(error, OperatorError::Range(range) if range.field == "depth"));
    }
    assert!(interior.at_depth(1.0, TractionField::normal(&p[..3])).is_err());
    assert!(interior.at_depths(&[1.0], TractionField::normal(&p[..3])).is_err());
    assert!(InteriorStress::new(Material::RIGID, grid, Threads::One).is_err());
    let huge = Grid::new(1 << 28, 1 << 28, 1.0, 1.0).unwrap();
    let error = InteriorStress::new(body, huge, Threads::One).unwrap_err();
    assert!(matches!(error, OperatorError::TooLarge { .. }));
}

#[test]
fn hertz_pressure_on_a_grid_has_its_greatest_shear_below_the_surface() {
    // Circle of radius 1, nu = 0.3: maximum shear 0.3100 p0 at depth 0.4809 a.
    let n = 129;
    let h = 2.2 / f64::from(n);
    let grid = Grid::new(n as usize, n as usize, h, h).unwrap();
    let pressure: Vec<f64> = (0..grid.cells())
        .map(|i| {
            let (x, y) = (grid.centred_x(i % n as usize), grid.centred_y(i / n as usize));
            (1.0 - x * x - y * y).max(0.0).sqrt()
        })
        .collect();
    let body = Material::from_shear(1.0, 0.3).unwrap();
    let interior = InteriorStress::new(body, grid, Threads::One).unwrap();
    let depths = [0.4, 0.4809, 0.56];
    let fields = interior.at_depths(&depths, TractionField::normal(&pressure)).unwrap();
    let greatest: Vec<f64> = fields
        .iter()
        .map(|field| field.iter().map(|s| s.maximum_shear()).fold(0.0, f64::max))
        .collect();
    assert!((greatest[1] - 0.3100).abs() < 2e-4, "{}", greatest[1]);
    assert!(greatest[1] > greatest[0] && greatest[1] > greatest[2]);
}

#[test]
fn hertz_ellipse_on_a_grid_has_the_axis_stress_of_the_closed_form() {
    // sigma_zz on the axis: -1/sqrt((1 + z^2/a^2)(1 + z^2/b^2)) p0.
    let (a, b, n) = (0.5, 1.5, 161usize);
    let grid = Grid::new(n, n, 2.0 * a / n as f64, 2.0 * b / n as f64).unwrap();
    let pressure: Vec<f64> = (0..grid.cells())
        .map(|i| {
            let (s, t) = (grid.centred_x(i % n) / a, grid.centred_y(i / n) / b);
            (1.0 - s * s - t * t).max(0.0).sqrt()
        })
        .collect();
    let body = Material::from_shear(1.0, 0.3).unwrap();
    let interior = InteriorStress::new(body, grid, Threads::One).unwrap();
    for z in [0.1, 0.4, 2.0] {
        let field = interior.at_depth(z, TractionField::normal(&pressure)).unwrap();
        let found = field.stress(grid.cells() / 2).zz;
        let expected = -1.0 / ((1.0 + z * z / (a * a)) * (1.0 + z * z / (b * b))).sqrt();
        assert!((found - expected).abs() < 2e-4, "{z}: {found} {expected}");
    }
}
