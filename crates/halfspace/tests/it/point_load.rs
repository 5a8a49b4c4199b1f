//! Point loads against 70-digit values, Navier's equations, Hooke's law and reciprocity.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use carom_halfspace::{Displacement, Force, Material, Point, PointLoad, Stress};
use proptest::prelude::*;
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
}

#[test]
fn reference_values() {
    let data: Value = serde_json::from_str(include_str!("../data/point_load.json")).unwrap();
    let cases = data["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 12);
    for case in cases {
        let inp = |name: &str| number(&case["inp"][name]);
        let body = Material::from_shear(inp("G"), inp("nu")).unwrap();
        let force = Force { x: inp("Fx"), y: inp("Fy"), z: inp("Fz") };
        let load = PointLoad::new(body, force).unwrap();
        let at = Point { x: inp("x"), y: inp("y"), z: inp("z") };
        let d = load.displacement(at).unwrap();
        let s = load.stress(at).unwrap();
        check([d.u, d.v, d.w], &case["out"]["u"], 3e-15);
        let tensor = [s.xx, s.yy, s.zz, s.xy, s.yz, s.zx];
        check(tensor, &case["out"]["stress_xx_yy_zz_xy_yz_zx"], 1e-14);
    }
}

/// Each component to `tolerance` of the largest.
fn check<const N: usize>(got: [f64; N], expected: &Value, tolerance: f64) {
    let expected: Vec<f64> = expected.as_array().unwrap().iter().map(number).collect();
    let largest = expected.iter().fold(0.0f64, |m, e| m.max(e.abs()));
    for (g, e) in got.iter().zip(&expected) {
        assert_abs_diff_eq!(*g, *e, epsilon = tolerance * largest);
    }
}

#[test]
fn surface_limit_is_the_limit_from_inside() {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let load = PointLoad::new(body, Force { x: 0.3, y: -0.7, z: 1.1 }).unwrap();
    let on = load.displacement(Point::on_surface(0.4, -0.9)).unwrap();
    let below = load.displacement(Point { x: 0.4, y: -0.9, z: 1e-16 }).unwrap();
    assert_relative_eq!(on.u, below.u, max_relative = 1e-14);
    assert_relative_eq!(on.v, below.v, max_relative = 1e-14);
    assert_relative_eq!(on.w, below.w, max_relative = 1e-14);
}

#[test]
fn bad_points_and_loads_are_named() {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let load = PointLoad::new(body, Force { x: 0.3, y: -0.7, z: 1.1 }).unwrap();
    assert_eq!(load.displacement(Point::default()).unwrap_err().field, "r");
    assert_eq!(load.stress(Point::default()).unwrap_err().field, "r");
    let above = Point { x: 1.0, y: 0.0, z: -1.0 };
    assert_eq!(load.stress(above).unwrap_err().field, "z");
    let nan = Point { x: f64::NAN, y: 0.0, z: 1.0 };
    assert_eq!(load.displacement(nan).unwrap_err().field, "x");
    let force = Force { y: f64::INFINITY, ..Force::default() };
    assert_eq!(PointLoad::new(body, force).unwrap_err().field, "F_y");
    assert!(PointLoad::new(Material::RIGID, Force::default()).is_err());
    // So near the load that the stress overflows: an error, never an infinity.
    assert!(load.stress(Point { x: 1e-200, y: 0.0, z: 0.0 }).is_err());
    assert!(load.displacement(Point { x: 1e-200, y: 0.0, z: 0.0 }).is_ok());
}

const STENCIL: [(f64, f64); 4] =
    [(1.0, 4.0 / 5.0), (2.0, -1.0 / 5.0), (3.0, 4.0 / 105.0), (4.0, -1.0 / 280.0)];

/// Central difference of eighth order along `axis`.
fn derivative(f: impl Fn(Point) -> f64, at: Point, axis: usize, h: f64) -> f64 {
    let moved = |k: f64| {
        let mut p = [at.x, at.y, at.z];
        p[axis] += k * h;
        f(Point { x: p[0], y: p[1], z: p[2] })
    };
    STENCIL.iter().map(|&(k, weight)| weight * (moved(k) - moved(-k))).sum::<f64>() / h
}

fn case() -> impl Strategy<Value = (Material, Force, Point)> {
    let unit = -1.0..1.0f64;
    (-0.9..0.5f64, prop::array::uniform3(unit.clone()), prop::array::uniform3(unit)).prop_map(
        |(nu, f, p)| {
            let force = Force { x: f[0], y: f[1], z: f[2] };
            let at = Point { x: p[0], y: p[1], z: 0.5 + p[2].abs() };
            (Material::from_shear(1.3, nu).unwrap(), force, at)
        },
    )
}

proptest! {
    #[test]
    fn stress_is_in_equilibrium((body, force, at) in case()) {
        let load = PointLoad::new(body, force).unwrap();
        let part = |pick: fn(Stress) -> f64| move |p| pick(load.stress(p).unwrap());
        let h = 0.005;
        let x = derivative(part(|s| s.xx), at, 0, h) + derivative(part(|s| s.xy), at, 1, h)
            + derivative(part(|s| s.zx), at, 2, h);
        let y = derivative(part(|s| s.xy), at, 0, h) + derivative(part(|s| s.yy), at, 1, h)
            + derivative(part(|s| s.yz), at, 2, h);
        let z = derivative(part(|s| s.zx), at, 0, h) + derivative(part(|s| s.yz), at, 1, h)
            + derivative(part(|s| s.zz), at, 2, h);
        for residual in [x, y, z] {
            assert_abs_diff_eq!(residual, 0.0, epsilon = 1e-11);
        }
    }

    #[test]
    fn stress_is_hooke_of_the_displacement((body, force, at) in case()) {
        // Equilibrium of these stresses then is Navier's equation of the displacement.
        let load = PointLoad::new(body, force).unwrap();
        let part = |pick: fn(Displacement) -> f64| move |p| pick(load.displacement(p).unwrap());
        let d = |pick: fn(Displacement) -> f64, axis| derivative(part(pick), at, axis, 0.005);
        let (g, nu) = (body.shear_modulus(), body.poisson());
        let [ux, uy, uz] = [0, 1, 2].map(|axis| d(|d| d.u, axis));
        let [vx, vy, vz] = [0, 1, 2].map(|axis| d(|d| d.v, axis));
        let [wx, wy, wz] = [0, 1, 2].map(|axis| d(|d| d.w, axis));
        let s = load.stress(at).unwrap();
        let dilatation = (1.0 - 2.0 * nu) / (2.0 * (1.0 + nu) * g) * (s.xx + s.yy + s.zz);
        assert_abs_diff_eq!(ux + vy + wz, dilatation, epsilon = 1e-11);
        assert_abs_diff_eq!(2.0 * g * (ux - wz), s.xx - s.zz, epsilon = 1e-11);
        assert_abs_diff_eq!(2.0 * g * (vy - wz), s.yy - s.zz, epsilon = 1e-11);
        assert_abs_diff_eq!(g * (uy + vx), s.xy, epsilon = 1e-11);
        assert_abs_diff_eq!(g * (vz + wy), s.yz, epsilon = 1e-11);
        assert_abs_diff_eq!(g * (uz + wx), s.zx, epsilon = 1e-11);
    }

    #[test]
    fn surface_is_free_of_traction((body, force, at) in case()) {
        let load = PointLoad::new(body, force).unwrap();
        prop_assume!(at.x.abs() + at.y.abs() > 1e-3);
        let s = load.stress(Point::on_surface(at.x, at.y)).unwrap();
        prop_assert_eq!((s.zz.abs(), s.zx.abs(), s.yz.abs()), (0.0, 0.0, 0.0));
    }

    #[test]
    fn surface_displacements_are_reciprocal((body, one, at) in case(), two in case()) {
        // Work of force one on the displacement of two equals the converse.
        prop_assume!(at.x.abs() + at.y.abs() > 1e-3);
        let two = two.1;
        let from = |force, x, y| {
            PointLoad::new(body, force).unwrap().displacement(Point::on_surface(x, y)).unwrap()
        };
        let work = |f: Force, d: Displacement| f.x * d.u + f.y * d.v + f.z * d.w;
        let scale = 1.0 / (at.x.hypot(at.y) * body.shear_modulus());
        assert_abs_diff_eq!(
            work(two, from(one, at.x, at.y)),
            work(one, from(two, -at.x, -at.y)),
            epsilon = 1e-14 * scale
        );
    }

    #[test]
    fn plane_at_depth_carries_the_force((body, force, _) in case()) {
        // The stress vector on the plane z = const is -3 (n.F) n c/(2 pi r^2): integrate over it.
        let load = PointLoad::new(body, force).unwrap();
        let (rings, spokes) = (400, 16);
        let mut total = [0.0; 3];
        for i in 0..rings {
            // tan of the midpoint angle; dA = rho drho dphi.
            let angle = (i as f64 + 0.5) / rings as f64 * std::f64::consts::FRAC_PI_2;
            let rho = angle.tan();
            let weight = rho / angle.cos().powi(2) * std::f64::consts::FRAC_PI_2 / rings as f64
                * std::f64::consts::TAU / spokes as f64;
            for k in 0..spokes {
                let phi = k as f64 / spokes as f64 * std::f64::consts::TAU;
                let s = load.stress(Point { x: rho * phi.cos(), y: rho * phi.sin(), z: 1.0 });
                let s = s.unwrap();
                for (sum, part) in total.iter_mut().zip([s.zx, s.yz, s.zz]) {
                    *sum -= weight * part;
                }
            }
        }
        for (sum, f) in total.iter().zip([force.x, force.y, force.z]) {
            assert_abs_diff_eq!(*sum, f, epsilon = 2e-5);
        }
    }
}
