//! Fields of a semi-ellipsoidal load compared with known solutions: the circle, the line, the point
//! force, the greatest shear stress of handbooks.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use carom_halfspace::{Displacement, Force, Point, PointLoad};
use carom_laws::field::{EllipsoidalLoad, circular_stress};

use crate::common::load::{LOADS, body, components, load, same};

#[test]
fn the_circle_is_that_of_huber() {
    let steel = body(0.3);
    for b in [1.0, 1.0 + 1e-12, 1.0 - 1e-7] {
        for (r, z) in [(0.0, 0.3), (0.4, 0.2), (0.9, 0.0), (0.99, 1e-6), (1.3, 0.0), (1.5, 2.0)] {
            for angle in [0.0_f64, 0.6, 2.0] {
                let (sine, cosine) = angle.sin_cos();
                let want = circular_stress(1.0, 1.0, &steel, r, z).unwrap();
                let at = Point { x: r * cosine, y: r * sine, z };
                let got = load(1.0, b, 0.3).stress(LOADS[2], at).unwrap();
                let turned = [
                    want.radial * cosine * cosine + want.hoop * sine * sine,
                    want.radial * sine * sine + want.hoop * cosine * cosine,
                    want.axial,
                    (want.radial - want.hoop) * sine * cosine,
                    want.shear * sine,
                    want.shear * cosine,
                ];
                let tolerance = 2e-13 + 30.0 * (b - 1.0_f64).abs();
                same("stress", components(got), turned, tolerance);
            }
        }
    }
}

/// The greatest shear on the axis and its depth.
fn greatest_shear_on_axis(one: &EllipsoidalLoad) -> (f64, f64) {
    let at = |z: f64| one.stress(LOADS[2], Point { x: 0.0, y: 0.0, z }).unwrap().maximum_shear();
    let (mut low, mut high) = (0.1, 1.5);
    while high - low > 1e-9 {
        let third = (high - low) / 3.0;
        if at(low + third) < at(high - third) { low += third } else { high -= third }
    }
    (at(low), low)
}

#[test]
fn greatest_shear_is_that_of_the_handbooks() {
    let (shear, depth) = greatest_shear_on_axis(&load(1.0, 1.0, 0.3));
    assert_relative_eq!(shear, 0.310_0, epsilon = 5e-5);
    assert_relative_eq!(depth, 0.480_9, epsilon = 5e-5);
    // The tabled values of three decimals for nu = 0.3.
    for (ratio, shear) in [(0.2, 0.322), (0.4, 0.325), (0.6, 0.323), (0.8, 0.317)] {
        let (got, _) = greatest_shear_on_axis(&load(1.0, 1.0 / ratio, 0.3));
        assert_relative_eq!(got, shear, epsilon = 1e-3);
    }
    // The line contact: 0.3003 p_0 at 0.7861 a, tau = p_0 (z/a)(1 - z/sqrt(a^2 + z^2)).
    let (shear, depth) = greatest_shear_on_axis(&load(1.0, 1e6, 0.3));
    assert_relative_eq!(shear, 0.300_283, epsilon = 1e-6);
    assert_relative_eq!(depth, 0.786_151, epsilon = 1e-5);
    // Along a long ellipse the fields are those of the line, to the order of a/b.
    let (m, z) = ((1.0_f64 + 0.25).sqrt(), 0.5);
    let stress = load(1.0, 1e6, 0.3).stress(LOADS[2], Point { x: 0.0, y: 0.0, z }).unwrap();
    assert_relative_eq!(stress.zz, -1.0 / m, max_relative = 1e-10);
    assert_relative_eq!(stress.xx, -(1.0 + 2.0 * z * z) / m + 2.0 * z, max_relative = 3e-6);
    assert_relative_eq!(stress.yy, 0.3 * (stress.xx + stress.zz), max_relative = 3e-6);
}

#[test]
fn a_long_ellipse_is_a_line_contact() {
    // McEwen's closed forms, of the width 1: pressure and traction across the line.
    let one = load(1.0, 1e6, 0.3);
    for (x, z) in [(0.0_f64, 0.2_f64), (0.5, 0.3), (-0.9, 0.05), (1.3, 0.4), (-2.0, 1.5)] {
        let (difference, product) = (1.0 - x * x + z * z, 2.0 * x * z);
        let root = difference.hypot(product);
        let m = (0.5 * (root + difference)).sqrt();
        let n = (0.5 * (root - difference)).sqrt() * x.signum();
        let share = (z * z + n * n) / (m * m + n * n);
        let (xx, zz) = (-m * (1.0 + share) + 2.0 * z, -m * (1.0 - share));
        let zx = -n * (m * m - z * z) / (m * m + n * n);
        let at = Point { x, y: 0.0, z };
        let got = one.stress(LOADS[2], at).unwrap();
        let want = [xx, 0.3 * (xx + zz), zz, 0.0, 0.0, zx];
        same("pressure", components(got), want, 2e-6);
        let along = n * (2.0 - (z * z - m * m) / (m * m + n * n)) - 2.0 * x;
        let got = one.stress(LOADS[0], at).unwrap();
        same("shear", components(got), [along, 0.3 * (along + zx), zx, 0.0, 0.0, xx], 2e-6);
        // Along the line: yx and yz are those of antiplane shear, n - x and z - m.
        let got = one.stress(LOADS[1], at).unwrap();
        same("antiplane", [got.xy, got.yz], [n - x, z - m], 2e-6);
    }
}

#[test]
fn far_away_the_load_is_a_point_force() {
    let far = 1e5;
    for (a, b) in [(1.0, 1.0), (2.0, 0.3), (1e-3, 1.0)] {
        let one = load(a, b, 0.3);
        let force = 2.0 / 3.0 * PI * a * b;
        for (x, y, z) in [(0.6, 0.0, 0.8), (0.48, -0.6, 0.64), (0.0, 0.0, 1.0), (0.8, 0.6, 1e-6)] {
            let at = Point { x: far * x, y: far * y, z: far * z };
            for peak in LOADS {
                let point = PointLoad::new(
                    body(0.3),
                    Force { x: force * peak.x, y: force * peak.y, z: force * peak.normal },
                )
                .unwrap();
                let scale = force / (far * far);
                let got = components(one.stress(peak, at).unwrap()).map(|s| s / scale);
                let want = components(point.stress(at).unwrap()).map(|s| s / scale);
                same("stress", got, want, 1e-8);
                let (got, want) =
                    (one.displacement(peak, at).unwrap(), point.displacement(at).unwrap());
                let scale = force / far;
                let all = |d: Displacement| [d.u, d.v, d.w].map(|d| d / scale);
                same("displacement", all(got), all(want), 1e-8);
            }
        }
    }
}
