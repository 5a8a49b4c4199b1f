//! Stress and displacement under a rectangle: quadrature, equilibrium, surface, Hertz.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use carom_halfspace::{
    Displacement, Force, LoadedRectangle, Material, MaterialPair, Offset, Point, PointLoad,
    Rectangle, RectangleInfluence, Stress, Traction,
};
use proptest::prelude::*;

fn listed(s: Stress) -> [f64; 6] {
    [s.xx, s.yy, s.zz, s.xy, s.yz, s.zx]
}

/// Nodes and weights of the 8-point Gauss rule on (-1, 1).
const RULE: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_361_98),
    (0.525_532_409_916_328_99, 0.313_706_645_877_887_29),
    (0.796_666_477_413_626_74, 0.222_381_034_453_374_47),
    (0.960_289_856_497_536_23, 0.101_228_536_290_376_26),
];

/// Point loads integrated over the rectangle, 8 x 8 Gauss points in cells of width 0.15 at most.
fn quadrature(
    body: Material,
    cell: Rectangle,
    load: Traction,
    at: Point,
) -> (Displacement, Stress) {
    let force = Force { x: load.x, y: load.y, z: load.normal };
    let load = PointLoad::new(body, force).unwrap();
    let mut sum = (Displacement::default(), Stress::default());
    let nodes = |width: f64| -> Vec<(f64, f64)> {
        let parts = (width / 0.15).ceil() as usize;
        let h = width / parts as f64;
        (0..parts)
            .flat_map(|part| {
                let centre = (part as f64 + 0.5) * h - 0.5 * width;
                RULE.iter().flat_map(move |&(t, w)| {
                    [(centre + 0.5 * h * t, 0.5 * h * w), (centre - 0.5 * h * t, 0.5 * h * w)]
                })
            })
            .collect()
    };
    for (y, wy) in nodes(cell.width_y()) {
        for (x, wx) in nodes(cell.width_x()) {
            let from = Point { x: at.x - x, y: at.y - y, z: at.z };
            sum.0 = sum.0 + load.displacement(from).unwrap() * (wx * wy);
            sum.1 = sum.1 + load.stress(from).unwrap() * (wx * wy);
        }
    }
    sum
}

fn assert_same(found: (Displacement, Stress), expected: (Displacement, Stress), tolerance: f64) {
    let (d, e) = (found.0, expected.0);
    let scale = e.u.abs().max(e.v.abs()).max(e.w.abs());
    for (a, b) in [(d.u, e.u), (d.v, e.v), (d.w, e.w)] {
        assert_abs_diff_eq!(a, b, epsilon = tolerance * scale);
    }
    let scale = listed(expected.1).iter().fold(0.0f64, |m, s| m.max(s.abs()));
    for (a, b) in listed(found.1).iter().zip(listed(expected.1)) {
        assert_abs_diff_eq!(*a, b, epsilon = tolerance * scale);
    }
}

fn case() -> impl Strategy<Value = (Material, Rectangle, Traction, Point)> {
    let unit = -1.0..1.0f64;
    (
        -0.5..0.5f64,
        -1.0..1.0f64,
        prop::array::uniform3(unit.clone()),
        prop::array::uniform3(unit),
        0.2..12.0f64,
    )
        .prop_map(|(nu, log_ratio, t, p, reach)| {
            let cell = Rectangle::new(1.0, 10f64.powf(log_ratio)).unwrap();
            let load = Traction { x: t[0], y: t[1], normal: t[2] };
            let z = 0.3 + reach * p[2].abs();
            let at = Point { x: reach * p[0], y: reach * p[1], z };
            (Material::from_shear(1.7, nu).unwrap(), cell, load, at)
        })
}

const STENCIL: [(f64, f64); 4] =
    [(1.0, 4.0 / 5.0), (2.0, -1.0 / 5.0), (3.0, 4.0 / 105.0), (4.0, -1.0 / 280.0)];

/// Central differences of eighth order of `f` along the three axes.
fn gradient<const N: usize>(f: impl Fn(Point) -> [f64; N], at: Point, h: f64) -> [[f64; N]; 3] {
    [0, 1, 2].map(|axis| {
        let moved = |k: f64| {
            let mut p = [at.x, at.y, at.z];
            p[axis] += k * h;
            f(Point { x: p[0], y: p[1], z: p[2] })
        };
        let mut sum = [0.0; N];
        for (k, weight) in STENCIL {
            let (plus, minus) = (moved(k), moved(-k));
            for (s, (p, m)) in sum.iter_mut().zip(plus.iter().zip(minus)) {
                *s += weight * (p - m) / h;
            }
        }
        sum
    })
}

proptest! {
    #[test]
    fn equals_the_quadrature_of_point_loads((body, cell, load, at) in case()) {
        let loaded = LoadedRectangle::new(body, cell).unwrap();
        let found = (loaded.displacement(load, at).unwrap(), loaded.stress(load, at).unwrap());
        assert_same(found, quadrature(body, cell, load, at), 2e-13);
    }

    #[test]
    fn is_in_equilibrium_and_obeys_hooke((body, cell, load, at) in case()) {
        let loaded = LoadedRectangle::new(body, cell).unwrap();
        let stress = |p| listed(loaded.stress(load, p).unwrap());
        let displacement = |p| {
            let d = loaded.displacement(load, p).unwrap();
            [d.u, d.v, d.w]
        };
        let h = 0.02 * at.z;
        let [x, y, z] = gradient(stress, at, h);
        for residual in [x[0] + y[3] + z[5], x[3] + y[1] + z[4], x[5] + y[4] + z[2]] {
            assert_abs_diff_eq!(residual, 0.0, epsilon = 1e-9);
        }
        let [x, y, z] = gradient(displacement, at, h);
        let (g, nu) = (body.shear_modulus(), body.poisson());
        let s = loaded.stress(load, at).unwrap();
        let dilatation = (1.0 - 2.0 * nu) / (2.0 * (1.0 + nu) * g) * 3.0 * s.mean();
        let checks = [
            (x[0] + y[1] + z[2], dilatation),
            (2.0 * g * (x[0] - z[2]), s.xx - s.zz),
            (2.0 * g * (y[1] - z[2]), s.yy - s.zz),
            (g * (y[0] + x[1]), s.xy),
            (g * (z[1] + y[2]), s.yz),
            (g * (z[0] + x[2]), s.zx),
        ];
        for (found, expected) in checks {
            assert_abs_diff_eq!(found, expected, epsilon = 1e-10);
        }
    }

    #[test]
    fn surface_displacement_is_that_of_the_coefficients((body, cell, load, at) in case()) {
        let pair = MaterialPair::new(body, Material::RIGID).unwrap();
        let offset = Offset { x: -at.x, y: -at.y };
        let expected = RectangleInfluence::new(pair, cell).coefficients(offset).unwrap();
        let expected = expected.displacement(load);
        let loaded = LoadedRectangle::new(body, cell).unwrap();
        let found = loaded.displacement(load, Point::on_surface(at.x, at.y)).unwrap();
        let scale = expected.u.abs() + expected.v.abs() + expected.w.abs();
        assert_abs_diff_eq!(found.u, expected.u, epsilon = 2e-14 * scale);
        assert_abs_diff_eq!(found.v, expected.v, epsilon = 2e-14 * scale);
        assert_abs_diff_eq!(found.w, expected.w, epsilon = 2e-14 * scale);
    }

    #[test]
    fn surface_carries_the_traction_inside_and_none_outside((body, cell, load, at) in case()) {
        let loaded = LoadedRectangle::new(body, cell).unwrap();
        let (x, y) = (at.x, at.y);
        prop_assume!((2.0 * x.abs() - cell.width_x()).abs() > 1e-3);
        prop_assume!((2.0 * y.abs() - cell.width_y()).abs() > 1e-3);
        let inside = 2.0 * x.abs() < cell.width_x() && 2.0 * y.abs() < cell.width_y();
        let expected = if inside { load } else { Traction::default() };
        let on = loaded.stress(load, Point::on_surface(x, y)).unwrap();
        assert_abs_diff_eq!(on.zz, -expected.normal, epsilon = 1e-15);
        assert_abs_diff_eq!(on.zx, -expected.x, epsilon = 1e-15);
        assert_abs_diff_eq!(on.yz, -expected.y, epsilon = 1e-15);
        // Continuous from below in all components.
        let below = loaded.stress(load, Point { x, y, z: 1e-13 }).unwrap();
        for (a, b) in listed(on).iter().zip(listed(below)) {
            assert_abs_diff_eq!(*a, b, epsilon = 1e-8);
        }
    }
}

#[test]
fn slender_rectangles_keep_their_digits() {
    // 1000 : 1, compared with the sum of 1000 squares.
    let body = Material::from_shear(1.0, 0.3).unwrap();
    let load = Traction { x: 0.4, y: -0.8, normal: 1.0 };
    let long = LoadedRectangle::new(body, Rectangle::new(1000.0, 1.0).unwrap()).unwrap();
    let unit = LoadedRectangle::new(body, Rectangle::new(1.0, 1.0).unwrap()).unwrap();
    for (x, y, z) in [(0.3, 0.2, 0.4), (499.0, 3.0, 0.0), (12.0, 40.0, 7.0), (200.0, 0.0, 90.0)] {
        let (mut d, mut s) = (Displacement::default(), Stress::default());
        for i in 0..1000 {
            let at = Point { x: x - (f64::from(i) - 499.5), y, z };
            d = d + unit.displacement(load, at).unwrap();
            s = s + unit.stress(load, at).unwrap();
        }
        let at = Point { x, y, z };
        let found = (long.displacement(load, at).unwrap(), long.stress(load, at).unwrap());
        assert_same(found, (d, s), 1e-13);
    }
}

#[test]
fn edges_and_corners_are_limits_or_errors() {
    let body = Material::from_shear(1.0, 0.3).unwrap();
    let loaded = LoadedRectangle::new(body, Rectangle::new(2.0, 2.0).unwrap()).unwrap();
    let pressure = Traction { normal: 1.0, ..Traction::default() };
    let shear = Traction { x: 1.0, ..Traction::default() };
    let edge = Point::on_surface(1.0, 0.3);
    assert_relative_eq!(loaded.stress(pressure, edge).unwrap().zz, -0.5, max_relative = 1e-15);
    assert!(loaded.stress(shear, edge).is_err());
    let corner = Point::on_surface(1.0, 1.0);
    assert!(loaded.stress(pressure, corner).is_err());
    for load in [pressure, shear] {
        for at in [edge, corner] {
            let on = loaded.displacement(load, at).unwrap();
            let near = loaded.displacement(load, Point { z: 1e-14, ..at }).unwrap();
            assert_abs_diff_eq!(on.u, near.u, epsilon = 1e-12);
            assert_abs_diff_eq!(on.w, near.w, epsilon = 1e-12);
        }
    }
    assert!(loaded.stress(pressure, Point { z: -1.0, ..edge }).is_err());
    let nan = Traction { y: f64::NAN, ..Traction::default() };
    assert_eq!(loaded.stress(nan, Point::default()).unwrap_err().field, "traction y");
    assert!(LoadedRectangle::new(Material::RIGID, Rectangle::new(1.0, 1.0).unwrap()).is_err());
}

/// Stress on the axis of an ellipse under Hertz's pressure, p0 = 1, by polar quadrature.
fn hertz_axis(nu: f64, a: f64, b: f64, z: f64) -> Stress {
    let load = PointLoad::new(
        Material::from_shear(1.0, nu).unwrap(),
        Force { z: 1.0, ..Force::default() },
    )
    .unwrap();
    let (rings, spokes) = (40, 128);
    let mut sum = Stress::default();
    for ring in 0..rings {
        for (node, weight) in RULE.iter().flat_map(|&(t, w)| [(t, w), (-t, w)]) {
            // s = sin(theta) removes the root of the pressure at the rim.
            let step = std::f64::consts::FRAC_PI_2 / f64::from(rings);
            let theta = (f64::from(ring) + 0.5 + 0.5 * node) * step;
            let (s, c) = theta.sin_cos();
            let weight =
                0.5 * step * weight * c * c * s * a * b * std::f64::consts::TAU / f64::from(spokes);
            for spoke in 0..spokes {
                let phi = (f64::from(spoke) + 0.5) / f64::from(spokes) * std::f64::consts::TAU;
                let from = Point { x: -a * s * phi.cos(), y: -b * s * phi.sin(), z };
                sum = sum + load.stress(from).unwrap() * weight;
            }
        }
    }
    sum
}

#[test]
fn hertz_circle_on_the_axis() {
    let nu = 0.3;
    for z in [0.2, 0.4809, 1.0, 3.0] {
        let found = hertz_axis(nu, 1.0, 1.0, z);
        let zz = -1.0 / (1.0 + z * z);
        let radial = -(1.0 + nu) * (1.0 - z * (1.0 / z).atan()) + 0.5 / (1.0 + z * z);
        assert_abs_diff_eq!(found.zz, zz, epsilon = 1e-13);
        assert_abs_diff_eq!(found.xx, radial, epsilon = 1e-13);
        assert_abs_diff_eq!(found.yy, radial, epsilon = 1e-13);
        assert_abs_diff_eq!(found.von_mises(), (radial - zz).abs(), epsilon = 1e-13);
    }
    let shear = |z: f64| hertz_axis(nu, 1.0, 1.0, z).maximum_shear();
    assert_abs_diff_eq!(shear(0.4809), 0.3100, epsilon = 5e-5);
    assert!(shear(0.4809) > shear(0.4809 - 1e-3) && shear(0.4809) > shear(0.4809 + 1e-3));
}

#[test]
fn hertz_ellipse_on_the_axis() {
    for (a, b) in [(1.0, 2.0), (1.0, 5.0), (3.0, 1.0)] {
        for z in [0.3, 1.0, 4.0] {
            let found = hertz_axis(0.3, a, b, z);
            let zz = -1.0 / ((1.0 + z * z / (a * a)) * (1.0 + z * z / (b * b))).sqrt();
            assert_abs_diff_eq!(found.zz, zz, epsilon = 1e-11);
            assert_abs_diff_eq!(found.xy, 0.0, epsilon = 1e-13);
        }
    }
}
