//! Collisions of spheres and planes: reference values, conservation laws, limits, bad input.

use carom_geometry::{FrameError, Inertia, SearchError};
use carom_halfspace::Material;
use carom_impact::closed_form::restitution_without_slip;
use carom_impact::{Body, Collision, CollisionError, Motion, Outcome, Rebound};
use carom_laws::friction::Friction;
use carom_laws::validity::Limit;
use nalgebra::Vector3;
use serde_json::Value;

use crate::data::rows;

fn vector(row: &Value, key: &str) -> [f64; 3] {
    std::array::from_fn(|i| row[key][i].as_f64().unwrap())
}

fn steel() -> Material {
    Material::from_shear(80e9, 0.3).unwrap()
}

fn solve(one: Body, two: Body, friction: f64) -> Rebound {
    let collision = Collision::new(one, two, Friction::new(friction).unwrap()).unwrap();
    collision.solve().unwrap().rebound().unwrap().clone()
}

#[test]
fn full_cases_of_two_spheres() {
    for row in &rows("two_spheres_full") {
        let number = |key: &str| row[key].as_f64().unwrap();
        let material = Material::from_shear(number("G"), number("nu")).unwrap();
        let body = |i: usize| {
            let key = |name: &str| format!("{name}{i}");
            Body::sphere(number(&key("R")), material, number(&key("m")))
                .unwrap()
                .moving(Motion::new(vector(row, &key("v")), vector(row, &key("w"))).unwrap())
        };
        let rebound = solve(body(1), body(2), number("f"));
        assert!((rebound.r_x.unwrap() - number("Rx")).abs() < 1e-10);
        for (i, motion) in rebound.motions.iter().enumerate() {
            let v = Vector3::from(vector(row, &format!("v{}_end", i + 1)));
            let w = Vector3::from(vector(row, &format!("w{}_end", i + 1)));
            assert!((motion.velocity - v).norm() < 1e-10, "{motion:?}");
            assert!((motion.spin - w).norm() < 1e-8, "{motion:?}");
        }
        let close = |own: f64, key: &str| {
            assert!((own / number(key) - 1.0).abs() < 1e-12, "{key}: {own}");
        };
        close(rebound.maximal_approach, "zeta_max");
        close(rebound.duration, "T");
        close(rebound.maximal_force, "F_max");
        close(rebound.maximal_contact.semi_axis_b(), "a_max");
        // Hertz: p_0 = 2 E* a/(pi R), E* = G/(1 - nu) of alike materials.
        let radius = 1.0 / (1.0 / number("R1") + 1.0 / number("R2"));
        let modulus = number("G") / (1.0 - number("nu"));
        let pressure = 2.0 * modulus * number("a_max") / (std::f64::consts::PI * radius);
        assert!((rebound.peak_pressure / pressure - 1.0).abs() < 1e-12);
    }
}

#[test]
fn alumina_on_a_rigid_plane_follows_published_exact_values() {
    // Sphere R = 2.5 mm, 3.9 m/s: v_x'/v_x of the centre and spin (rad/s) by an independent program.
    let cases = [
        (5.0, 0.74157, 87.84),
        (10.0, 0.63995, 243.84),
        (20.0, 0.59362, 542.06),
        (30.0, 0.68130, 621.46),
        (40.0, 0.78072, 549.71),
        (60.0, 0.89377, 358.80),
        (80.0, 0.96756, 124.61),
    ];
    let alumina = Material::from_young(380e9, 0.23).unwrap();
    let mass = 4000.0 * 4.0 / 3.0 * std::f64::consts::PI * 2.5e-3_f64.powi(3);
    for (angle, ratio, spin) in cases {
        let (sin, cos) = f64::to_radians(angle).sin_cos();
        let motion = Motion::new([3.9 * sin, 0.0, -3.9 * cos], [0.0; 3]).unwrap();
        let ball = Body::sphere(2.5e-3, alumina, mass).unwrap().moving(motion);
        let rebound = solve(ball, Body::plane(Material::RIGID), 0.092);
        let after = rebound.motions[0];
        assert!((after.velocity.x / (3.9 * sin) - ratio).abs() < 6e-6, "{angle}");
        assert!((after.spin.norm() - spin).abs() < 6e-3, "{angle} {}", after.spin.norm());
        assert!(rebound.warnings[0].ratio(Limit::Coupling).is_some());
    }
}

#[test]
fn limits_of_friction() {
    let motion = Motion::new([1.0, 0.0, -1.0], [0.0; 3]).unwrap();
    let ball = Body::sphere(0.01, steel(), 0.03).unwrap().moving(motion);
    let plane = Body::plane(steel());
    let none = solve(ball.clone(), plane.clone(), 0.0);
    assert_eq!(none.r_x.unwrap(), -1.0);
    assert_eq!(none.motions[0].velocity, Vector3::new(1.0, 0.0, 1.0));
    let infinite = solve(ball.clone(), plane.clone(), f64::INFINITY);
    let chi = 3.5 / (1.7 / 1.4);
    assert!((infinite.r_x.unwrap() - restitution_without_slip(chi)).abs() < 1e-14);
    let large = solve(ball, plane, 1e9);
    assert!((large.r_x.unwrap() - infinite.r_x.unwrap()).abs() < 1e-8);
    let lost = infinite.energy.before - infinite.energy.after;
    assert!(lost > 0.0 && (lost - infinite.energy.dissipated).abs() < 1e-14 * lost.max(1.0));
}

#[test]
fn heavy_rigid_grazing_and_separating_bodies() {
    let motion = Motion::new([1.0, 0.0, -1e-9], [0.0; 3]).unwrap();
    let ball = Body::sphere(0.01, steel(), 0.03).unwrap().moving(motion);
    let grazing = solve(ball.clone(), Body::plane(steel()), 0.3);
    assert!(grazing.r_x.unwrap() < -0.999_999);
    let heavy = Body::sphere(0.01, steel(), f64::INFINITY).unwrap();
    let rigid = Body::sphere(0.02, Material::RIGID, 1.0).unwrap().moving(motion);
    assert!(solve(rigid, heavy, 0.3).duration > 0.0);
    let away = ball.moving(Motion::new([1.0, 0.0, 0.0], [0.0; 3]).unwrap());
    let collision = Collision::new(away.clone(), Body::plane(steel()), Friction::NONE).unwrap();
    let outcome = collision.solve().unwrap();
    assert!(matches!(outcome, Outcome::NoImpact { motions } if motions[0] == away.motion()));
    assert!(collision.history(10).unwrap().is_empty());
}

#[test]
fn impossible_pairs_are_typed() {
    let ball = Body::sphere(0.01, steel(), 0.03).unwrap();
    let rigid_ball = Body::sphere(0.01, Material::RIGID, 0.03).unwrap();
    let rigid = Collision::new(rigid_ball, Body::plane(Material::RIGID), Friction::NONE);
    assert!(matches!(rigid, Err(CollisionError::Range(e)) if e.field == "shear_modulus"));
    let held = ball.with_inertia(Inertia::FIXED);
    let fast = Collision::new(held, Body::plane(steel()), Friction::NONE);
    assert_eq!(fast.unwrap_err(), CollisionError::BothHeldFast);
    let planes = Collision::new(
        Body::plane(steel()).with_inertia(Inertia::solid_sphere(1.0, 1.0).unwrap()),
        Body::plane(steel()),
        Friction::NONE,
    );
    assert!(matches!(
        planes,
        Err(CollisionError::Search(SearchError::Frame(FrameError::Curvature(_))))
    ));
    assert_eq!(Body::sphere(-1.0, steel(), 1.0).unwrap_err().field, "radius");
    assert_eq!(Body::sphere(1.0, steel(), f64::NAN).unwrap_err().field, "mass");
    assert_eq!(Inertia::new(1.0, [1.0, 1.0, 3.0]).unwrap_err().field, "moment of inertia");
    assert_eq!(Motion::new([0.0, f64::NAN, 0.0], [0.0; 3]).unwrap_err().field, "velocity");
}

#[test]
fn history_starts_and_ends_with_the_outcome() {
    let motion = Motion::new([0.7, 0.2, -2.0], [0.0, 50.0, 3.0]).unwrap();
    let ball = Body::sphere(0.01, steel(), 0.03).unwrap().moving(motion);
    for friction in [0.0, 0.05, 0.15, 1.0, f64::INFINITY] {
        let friction = Friction::new(friction).unwrap();
        let collision = Collision::new(ball.clone(), Body::plane(steel()), friction).unwrap();
        let outcome = collision.solve().unwrap();
        let rebound = outcome.rebound().unwrap();
        let history = collision.history(101).unwrap();
        assert_eq!(history.len(), 101);
        let (first, middle, last) = (history[0], history[50], history[100]);
        assert_eq!((first.shift.z, first.time), (0.0, 0.0));
        assert!((last.time / rebound.duration - 1.0).abs() < 1e-14);
        assert!((middle.force.z / rebound.maximal_force - 1.0).abs() < 1e-14);
        assert!((middle.semi_axes[0] / rebound.maximal_contact.semi_axis_b() - 1.0).abs() < 1e-14);
        let start = first.velocity.xy();
        let ratio = -last.velocity.xy().dot(&start) / start.norm_squared();
        assert!(
            (ratio - rebound.r_x.unwrap()).abs() < 1e-11,
            "{friction:?} {ratio} {}",
            rebound.r_x.unwrap()
        );
        // Newton: the impulse is the integral of the force (trapezoidal rule, smooth at both ends).
        let step = rebound.duration / 100.0;
        let impulse: Vector3<f64> = history.iter().map(|p| p.force * step).sum();
        let off = (impulse - rebound.impulse).xy().norm();
        assert!(off < 2e-3 * rebound.impulse.xy().norm().max(1e-12), "{friction:?}");
    }
}

/// Next to as heavy as numbers go: impulse and energy are none any more, and no NaN is told.
#[test]
fn what_overflows_is_refused() {
    let steel = Material::from_young(208e9, 0.3).unwrap();
    let solve = |mass: f64, speed: f64| {
        let ball = Body::sphere(0.02, steel, mass).unwrap();
        let ball = ball.moving(Motion::new([0.3 * speed, 0.0, -speed], [0.0; 3]).unwrap());
        let friction = Friction::new(0.3).unwrap();
        Collision::new(ball, Body::plane(steel), friction).unwrap().solve()
    };
    for (mass, speed, field) in [(f64::MAX, 1.0, "impulse"), (1e200, 1e60, "kinetic energy")] {
        match solve(mass, speed) {
            Err(CollisionError::Range(error)) => assert_eq!(error.field, field),
            other => panic!("{mass:e}: {other:?}"),
        }
    }
    assert!(solve(1e200, 1.0).is_ok());
}

/// The validity compares the long semi-axis with the same radius as the approach, and its speed by the spin with f v_z.
#[test]
fn an_oblong_contact_is_as_large_as_it_is_long() {
    let shape = carom_geometry::Surface::ellipsoid([0.03, 0.02, 0.015]).unwrap();
    let inertia = shape.solid(0.3).unwrap();
    let body = Body::new(shape, steel(), inertia);
    let rebound = solve(
        body.moving(Motion::new([0.1, 0.0, -1.0], [0.0, 0.0, 300.0]).unwrap()),
        Body::plane(steel()),
        0.3,
    );
    let contact = rebound.maximal_contact;
    let [short, long] = [contact.semi_axis_a(), contact.semi_axis_b()];
    let by_approach = rebound.validity.approach_over_radius / rebound.maximal_approach;
    let by_contact = rebound.validity.semi_axis_over_radius / short.max(long);
    assert!(long > 1.2 * short && (by_contact / by_approach - 1.0).abs() < 1e-12);
    let twist = 300.0 * long / 0.3;
    let by_spin = rebound.validity.spin_on_shift / (2.0 * twist / (1.0 + twist));
    assert!((by_spin - 1.0).abs() < 1e-12, "{by_spin}");
}
