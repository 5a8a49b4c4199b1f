//! Stresses and displacements in a body under a semi-ellipsoidal load, compared with point loads
//! and rectangles summed over the ellipse, equilibrium, elasticity and the surface traction.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use carom_drawn::{Draw as _, Splitmix};
use carom_halfspace::{
    Displacement, Force, LoadedRectangle, Material, MaterialPair, Point, PointLoad, Rectangle,
    Stress, Traction,
};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::field::{
    EllipsoidalLoad, circular_shear, ellipsoidal_shear, memory_stress, partial_slip_stress,
};
use carom_laws::memory::VectorMemory;
use carom_special::quadrature::GaussLegendre;

use crate::common::load::{LOADS, body, components, load, same};

/// Point loads over the ellipse at `(a sin s cos t, b sin s sin t)`.
fn summed(
    (a, b): (f64, f64),
    nu: f64,
    peak: Traction,
    at: Point,
    count: usize,
) -> (Stress, Displacement) {
    let rule = GaussLegendre::new(count).unwrap();
    let (mut stress, mut moved) = (Stress::default(), Displacement::default());
    for node in rule.on(0.0, PI / 2.0) {
        let (sine, cosine) = node.position.sin_cos();
        for j in 0..2 * count {
            let t = PI * (j as f64 + 0.5) / count as f64;
            let weight = node.weight * PI / count as f64 * a * b * sine * cosine * cosine;
            let force = Force { x: weight * peak.x, y: weight * peak.y, z: weight * peak.normal };
            let from = Point { x: at.x - a * sine * t.cos(), y: at.y - b * sine * t.sin(), ..at };
            let point = PointLoad::new(body(nu), force).unwrap();
            stress = stress + point.stress(from).unwrap();
            moved = moved + point.displacement(from).unwrap();
        }
    }
    (stress, moved)
}

#[test]
fn point_loads_add_up_to_the_closed_form() {
    for (a, b) in [(1.0, 1.0), (1.0, 2.0), (3.0, 1.0), (0.6, 0.62), (0.2, 1.0)] {
        for at in [
            Point { x: 0.0, y: 0.0, z: 0.7 },
            Point { x: 0.3, y: -0.4, z: 0.5 },
            Point { x: 0.0, y: 0.9, z: 1.5 },
            Point { x: -1.4, y: 0.8, z: 0.4 },
            Point { x: 2.0, y: 5.0, z: 3.0 },
        ] {
            for (peak, nu) in LOADS.into_iter().flat_map(|peak| [(peak, 0.3), (peak, 0.0)]) {
                let (stress, moved) = summed((a, b), nu, peak, at, 120);
                let one = load(a, b, nu);
                let got = one.stress(peak, at).unwrap();
                same("stress", components(got), components(stress), 2e-12);
                let got = one.displacement(peak, at).unwrap();
                let want = [moved.u, moved.v, moved.w];
                same("displacement", [got.u, got.v, got.w], want, 2e-12);
            }
        }
    }
}

#[test]
fn rectangles_below_the_surface_come_close() {
    // 80 x 80 rectangles of the traction at their middles, at small depths.
    let (a, b, n) = (1.0, 2.0, 80);
    let (dx, dy) = (2.0 * a / f64::from(n), 2.0 * b / f64::from(n));
    let rectangle = Rectangle::new(dx, dy).unwrap();
    let one = LoadedRectangle::new(body(0.3), rectangle).unwrap();
    for at in [
        Point { x: 0.2, y: 0.5, z: 0.1 },
        Point { x: 0.9, y: 0.6, z: 0.2 },
        Point { x: 0.5, y: 1.9, z: 0.1 },
    ] {
        for peak in LOADS {
            let mut sum = Stress::default();
            for i in 0..n {
                for j in 0..n {
                    let x = -a + (f64::from(i) + 0.5) * dx;
                    let y = -b + (f64::from(j) + 0.5) * dy;
                    let rest = 1.0 - (x / a).powi(2) - (y / b).powi(2);
                    if rest > 0.0 {
                        let from = Point { x: at.x - x, y: at.y - y, z: at.z };
                        sum = sum + one.stress(peak, from).unwrap() * rest.sqrt();
                    }
                }
            }
            let got = load(a, b, 0.3).stress(peak, at).unwrap();
            same("stress", components(got), components(sum), 2e-3);
        }
    }
}

#[test]
fn stresses_are_in_equilibrium_and_follow_from_displacements() {
    let h = 1e-4;
    for (a, b) in [(1.0, 1.001), (1.0, 2.5), (0.1, 1.0), (4.0, 1.0)] {
        for (x, y, z) in [(0.3, 0.2, 0.3), (0.05, 0.8, 0.2), (1.2, -0.7, 0.4), (0.0, 0.0, 1.0)] {
            for peak in LOADS {
                let one = load(a, b, 0.3);
                let at = |i: usize, by: f64| {
                    let mut p = [x, y, z];
                    p[i] += by;
                    Point { x: p[0], y: p[1], z: p[2] }
                };
                // Differences of the fourth order.
                let stress: [[f64; 6]; 3] = std::array::from_fn(|i| {
                    let s = |n: f64| components(one.stress(peak, at(i, n * h)).unwrap());
                    let (p, m, pp, mm) = (s(1.0), s(-1.0), s(2.0), s(-2.0));
                    std::array::from_fn(|k| (8.0 * (p[k] - m[k]) - pp[k] + mm[k]) / (12.0 * h))
                });
                let [dx, dy, dz] = stress;
                let balance = [dx[0] + dy[3] + dz[5], dx[3] + dy[1] + dz[4], dx[5] + dy[4] + dz[2]];
                same("balance", balance, [0.0; 3], 1e-9);
                let moved: [[f64; 3]; 3] = std::array::from_fn(|i| {
                    let s = |n: f64| {
                        let d = one.displacement(peak, at(i, n * h)).unwrap();
                        [d.u, d.v, d.w]
                    };
                    let (p, m, pp, mm) = (s(1.0), s(-1.0), s(2.0), s(-2.0));
                    std::array::from_fn(|k| (8.0 * (p[k] - m[k]) - pp[k] + mm[k]) / (12.0 * h))
                });
                let [dx, dy, dz] = moved;
                let trace = (dx[0] + dy[1] + dz[2]) * 0.3 / 0.4;
                let law = [
                    2.0 * (dx[0] + trace),
                    2.0 * (dy[1] + trace),
                    2.0 * (dz[2] + trace),
                    dx[1] + dy[0],
                    dy[2] + dz[1],
                    dx[2] + dz[0],
                ];
                let got = components(one.stress(peak, at(0, 0.0)).unwrap());
                same("elasticity", got, law, 1e-9);
            }
        }
    }
}

#[test]
fn the_surface_carries_the_traction_and_nothing_outside() {
    for (a, b) in [(1.0, 1.0), (1.0, 2.0), (2.0, 0.3), (1e-3, 1.0)] {
        let one = load(a, b, 0.25);
        for (u, v) in [(0.0, 0.0), (0.5, 0.3), (0.0, 0.99), (0.6, 0.8), (1.0, 0.0), (1.2, 0.4)] {
            let traction = (1.0_f64 - u * u - v * v).max(0.0).sqrt();
            let at = Point::on_surface(u * a, v * b);
            for peak in LOADS {
                let stress = one.stress(peak, at).unwrap();
                let got = [-stress.zx, -stress.yz, -stress.zz];
                let want = [peak.x, peak.y, peak.normal].map(|share| share * traction);
                // 0.6^2 + 0.8^2 is 1 but for round-off, of which this is the root.
                same("traction", got, want, 4e-8);
                if traction != 0.0 {
                    same("traction", got, want, 1e-14);
                }
            }
        }
    }
    // Just below, the same.
    let one = load(1.0, 2.0, 0.3);
    for (x, y) in [(0.3, 0.4), (0.0, 1.9), (1.3, 0.2)] {
        for peak in LOADS {
            let below = one.stress(peak, Point { x, y, z: 1e-9 }).unwrap();
            let above = one.stress(peak, Point::on_surface(x, y)).unwrap();
            same("limit", components(below), components(above), 2e-8);
        }
    }
}

#[test]
fn every_point_of_the_body_has_a_stress() {
    let mut random = Splitmix(11);
    for _ in 0..20_000 {
        let mut size = || 10_f64.powf(random.between(-7.0, 5.0));
        let (a, b, x, y, z) = (size(), size(), size(), size(), size());
        let one = load(a, b, 0.3);
        let peak = Traction { x: 1.0, y: 1.0, normal: 1.0 };
        for at in [
            Point { x, y, z },
            Point { x: 0.0, y, z },
            Point { x, y: 0.0, z },
            Point::on_surface(a, 0.0),
            Point::on_surface(0.0, b),
            Point::on_surface(x, y),
            Point { x: 0.0, y: b, z: 1e-3 * z },
        ] {
            let Ok(stress) = one.stress(peak, at) else { panic!("{a:e} {b:e} {at:?}") };
            let greatest = components(stress).iter().fold(0.0_f64, |m, s| m.max(s.abs()));
            assert!(greatest < 20.0, "{a:e} {b:e} {at:?}: {stress:?}");
            one.displacement(peak, at).unwrap();
        }
    }
}

/// However near the surface it is that, and however far away nothing is left.
#[test]
fn the_nearest_and_the_farthest_points_have_a_stress() {
    let peak = Traction { x: 0.3, y: -0.2, normal: 1.0 };
    for (a, b) in [(1.0, 1.0), (1.0, 2.5), (1e-3, 1.0), (1e6, 1.0), (1e-9, 1e-8)] {
        let one = load(a, b, 0.3);
        for (x, y) in [(0.0, 0.0), (0.3, 0.4), (1.0, 0.0), (0.0, 1.0), (1.7, 0.2)] {
            let at = |z: f64| Point { x: x * a, y: y * b, z };
            let surface = one.stress(peak, at(0.0)).unwrap();
            for z in [5e-324, 1e-308, 1e-200, 1e-170, 1e-140, 1e-125] {
                let near = one.stress(peak, at(z)).unwrap();
                same("stress", components(near), components(surface), 1e-12);
                one.displacement(peak, at(z)).unwrap();
            }
        }
        for far in [1e70, 1e160, 1e200, 1e308] {
            for at in [[far, 0.0, 0.0], [0.0, -far, 0.0], [0.0, 0.0, far], [far, far, far]] {
                let at = Point { x: at[0], y: at[1], z: at[2] };
                let stress = components(one.stress(peak, at).unwrap());
                assert!(stress.iter().all(|s| s.abs() < 1e-50), "{a} {b} {at:?} {stress:?}");
                let moved = one.displacement(peak, at).unwrap();
                assert!(moved.w.abs() < 1e-25 * a.max(b), "{moved:?}");
            }
        }
    }
}

#[test]
fn partial_slip_takes_the_stick_area_off() {
    let ellipse = ContactEllipse::new(1.0, 1.7).unwrap();
    let peak = Traction { x: 0.2, y: -0.1, normal: 1.0 };
    for (u, v) in [(0.0, 0.0), (0.3, 0.2), (0.5, 0.6)] {
        let stress =
            partial_slip_stress(ellipse, body(0.3), peak, 0.6, Point::on_surface(u, 1.7 * v))
                .unwrap();
        let rest = |c: f64| (c * c - u * u - v * v).max(0.0_f64).sqrt();
        let traction = rest(1.0) - rest(0.6);
        same("traction", [-stress.zx, -stress.yz], [0.2 * traction, -0.1 * traction], 1e-14);
    }
    let at = Point { x: 0.1, y: 0.2, z: 0.3 };
    let whole = partial_slip_stress(ellipse, body(0.3), peak, 0.0, at).unwrap();
    let sliding = EllipsoidalLoad::new(ellipse, body(0.3)).unwrap().stress(peak, at).unwrap();
    assert_eq!(whole, sliding);
    let wrong = partial_slip_stress(ellipse, body(0.3), peak, 1.5, at).unwrap_err();
    assert_eq!(wrong.field, "stick_radius");
    assert_eq!(EllipsoidalLoad::new(ellipse, Material::RIGID).unwrap_err().field, "shear_modulus");
    let one = EllipsoidalLoad::new(ellipse, body(0.3)).unwrap();
    let above = Point { x: 0.0, y: 0.0, z: -1.0 };
    assert_eq!(one.stress(peak, above).unwrap_err().field, "z");
    let endless = Traction { normal: f64::INFINITY, ..peak };
    assert_eq!(one.stress(endless, at).unwrap_err().field, "pressure");
}

#[test]
fn shear_displaces_the_surface_outside_too() {
    let materials = MaterialPair::new(body(0.3), Material::RIGID).unwrap();
    for (a, b) in [(1.0, 2.0), (1.5, 0.4), (0.02, 1.0), (1.0, 1.0)] {
        let ellipse = ContactEllipse::new(a, b).unwrap();
        let at = |x: f64, y: f64| ellipsoidal_shear(&ellipse, 1.0, &materials, x, y).unwrap();
        for (u, v) in [(1.0_f64, 0.0_f64), (0.0, 1.0), (0.6, 0.8), (-0.8, 0.6)] {
            let (inside, outside) = (
                at(u * a * (1.0 - 1e-12), v * b * (1.0 - 1e-12)),
                at(u * a * (1.0 + 1e-12), v * b * (1.0 + 1e-12)),
            );
            same("edge", outside, inside, 1e-10);
        }
        for (x, y) in [(2.1, 0.0), (0.0, 2.3), (-1.7, 1.5), (4.0, -3.0)] {
            let moved = summed((a, b), 0.3, LOADS[0], Point::on_surface(x, y), 120).1;
            same("outside", at(x, y), [moved.u, moved.v], 2e-12);
            let one = load(a, b, 0.3);
            let got = one.displacement(LOADS[0], Point::on_surface(x, y)).unwrap();
            same("outside", [got.u, got.v], at(x, y), 1e-14);
        }
        // And inside, where the formulas are those of the thesis.
        let one = load(a, b, 0.3);
        for (u, v) in [(0.0, 0.0), (0.3, 0.5), (0.0, 0.9), (-0.7, 0.1)] {
            let got = one.displacement(LOADS[0], Point::on_surface(u * a, v * b)).unwrap();
            same("inside", [got.u, got.v], at(u * a, v * b), 1e-13);
        }
        // Cerruti: u = F (1 - nu + nu cos^2)/(2 pi G r), v = F nu sin cos/(2 pi G r).
        let far = 1e5 * (a + b);
        let point = 2.0 / 3.0 * PI * a * b / (2.0 * PI * far);
        let want = [point * (0.7 + 0.3 * 0.36), point * 0.3 * 0.48];
        let got = at(0.6 * far, 0.8 * far);
        for i in 0..2 {
            assert_relative_eq!(got[i], want[i], max_relative = 1e-9);
        }
    }
    for (x, y) in [(1.4, 0.2), (0.0, 3.0)] {
        let circle = ContactEllipse::circle(1.0).unwrap();
        let got = ellipsoidal_shear(&circle, 1.0, &materials, x, y).unwrap();
        same("circle", got, circular_shear(1.0, 1.0, &materials, x, y), 1e-14);
    }
    // In a harder body less, inside and outside, in proportion.
    let body = Material::from_shear(5.0, materials.poisson()).unwrap();
    let hard = MaterialPair::new(body, body).unwrap();
    let by = materials.shear_modulus() / hard.shear_modulus();
    for (x, y) in [(0.3, 0.5), (1.4, 0.2)] {
        let soft = circular_shear(1.0, 1.0, &materials, x, y).map(|u| by * u);
        same("hard", circular_shear(1.0, 1.0, &hard, x, y), soft, 1e-14);
    }
}

#[test]
fn a_first_shift_is_partial_slip() {
    let (ellipse, body) = (ContactEllipse::new(0.8, 1.5).unwrap(), body(0.3));
    let mut memory = VectorMemory::new();
    memory.advance(1.0, [0.0, 0.0]).unwrap();
    memory.advance(1.0, [0.3, 0.0]).unwrap();
    let peak = Traction { x: 0.4, y: 0.0, normal: 1.5 };
    for (x, y, z) in [(0.1, 0.2, 0.3), (0.7, -0.5, 0.05), (1.5, 1.0, 0.0)] {
        let at = Point { x, y, z };
        let got = memory_stress(&memory, ellipse, body, 1.5, 0.4, at).unwrap();
        // zeta*/zeta = 1 - X.
        let want = partial_slip_stress(ellipse, body, peak, 0.7_f64.sqrt(), at).unwrap();
        same("stress", components(got), components(want), 1e-13);
    }
}
