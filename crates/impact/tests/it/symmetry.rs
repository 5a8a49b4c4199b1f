//! Couplings that vanish by symmetry stay exactly zero: normal incidence, extreme ratios of size and mass,
//! positions far from the origin, all entry points.

use crate::spheres::{chi_of_sphere, collided, conserves, friction, same};
use carom_geometry::{Attitude, Inertia, Surface};
use carom_halfspace::Material;
use carom_impact::closed_form::restitution_without_slip;
use carom_impact::coupled::{CoupledImpact, ImpactMethod};
use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_impact::restitution::{RestitutionTable, of_groups, restitution_map};
use carom_impact::scene::{Ball, Limits, Scene, Wall};
use carom_impact::{Body, Collision, Motion, Rebound};
use nalgebra::Vector3;

const ALUMINA_FRICTION: f64 = 0.092;
const DOWN: [f64; 3] = [0.0, 0.0, -1.0];

fn alumina() -> Material {
    Material::from_young(380e9, 0.23).unwrap()
}

fn steel() -> Material {
    Material::from_shear(80e9, 0.3).unwrap()
}

fn at_angle(degrees: f64) -> Motion {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Motion::new([3.9 * sin, 0.0, -3.9 * cos], [0.0; 3]).unwrap()
}

/// The alumina sphere of the example and what it has to hit.
fn alumina_sphere(motion: Motion) -> (Body, Body) {
    let (radius, mass) = (2.5e-3, 2.618e-4);
    let body = Body::sphere(radius, alumina(), mass).unwrap().moving(motion);
    let surface = Surface::sphere(radius).unwrap();
    let placed = Body::new(surface, alumina(), body.inertia())
        .at([0.0, 0.0, radius])
        .unwrap()
        .moving(motion);
    (body, placed)
}

fn alumina_rebounds(motion: Motion, f: f64) -> [Rebound; 2] {
    let (body, placed) = alumina_sphere(motion);
    let plane = Body::plane(Material::RIGID);
    let collision = Collision::new(body, plane, friction(f)).unwrap();
    let floor = Body::plane(Material::RIGID);
    [collided(&collision), collided(&Collision::touching(placed, floor, friction(f)).unwrap())]
}

#[test]
fn alumina_straight_down_has_the_limit_of_small_angles() {
    let chi = chi_of_sphere(0.23);
    let limit = restitution_without_slip(chi);
    assert!((limit + 0.2962).abs() < 5e-5, "{limit}");
    let kappa = 3.5 / chi;
    for degrees in [0.0, 1e-300, 1e-200, 1e-162, 1e-100, 1e-30, 1e-16, 1e-14, 1e-9, 1e-5, 0.01, 1.0]
    {
        let psi = f64::to_radians(degrees).tan() / ALUMINA_FRICTION / kappa;
        let expected = of_groups(chi, psi).unwrap();
        // Continuous: slip at the rim takes a share of the order of psi.
        assert!((expected - limit).abs() <= 2.0 * psi + 1e-12, "{degrees} {expected} {limit}");
        for rebound in alumina_rebounds(at_angle(degrees), ALUMINA_FRICTION) {
            let own = rebound.r_x.unwrap();
            assert!((own - expected).abs() < 1e-12, "{degrees} degrees: {own} {expected}");
            // What is left of a velocity of any size is this part of it.
            let (before, after) =
                (rebound.contact_velocity_before.x, rebound.contact_velocity_after.x);
            assert!((after + own * before).abs() <= 1e-14 * before.abs(), "{degrees}");
        }
    }
}

#[test]
fn a_dropped_ball_has_the_same_restitution_at_every_bounce_and_never_turns() {
    let rubber = Material::from_young(20e6, 0.5).unwrap();
    let limit = restitution_without_slip(chi_of_sphere(0.5));
    for normal in [[0.0, 0.0, 1.0], [0.3, -0.5, 0.8], [1e-9, 0.0, 1.0]] {
        let up = Vector3::from(normal).normalize();
        let wall = Wall::new([0.0; 3], normal, Material::RIGID, friction(0.3)).unwrap();
        let scene = Scene::new((-10.0 * up).into()).unwrap().with(wall);
        let ball = Body::sphere(0.022, rubber, 0.0446).unwrap();
        let ball = Ball::new(ball.at((1.022 * up).into()).unwrap()).unwrap();
        let path = scene.run(&ball, Limits::new(60.0, 20).unwrap()).unwrap();
        assert_eq!(path.bounces().len(), 20);
        for bounce in path.bounces() {
            let own = bounce.rebound.r_x.unwrap();
            assert!((own - limit).abs() < 1e-12, "{normal:?} {own} {limit}");
            assert!(bounce.after.spin.norm() < 1e-12, "{}", bounce.after.spin);
        }
    }
}

#[test]
fn where_nothing_slips_every_way_gives_the_limit() {
    let chi = chi_of_sphere(0.23);
    let limit = restitution_without_slip(chi);
    let turn = 3.9 / 2.5e-3;
    let motion = |v: [f64; 3], w: [f64; 3]| Motion::new(v, w).unwrap();
    let still = [
        motion([0.0, 0.0, -3.9], [0.0; 3]),
        motion([0.0, 0.0, -3.9], [0.0, 0.0, 1e4]),
        // Rolling: v + w x R vanishes.
        motion([0.5 * 3.9, 0.0, -3.9], [0.0, 0.5 * turn, 0.0]),
    ];
    for motion in still {
        for (f, expected) in [(0.0, -1.0), (1e-9, limit), (0.1, limit), (f64::INFINITY, limit)] {
            for rebound in alumina_rebounds(motion, f) {
                let slip = rebound.contact_velocity_before.xy().norm();
                assert_eq!(slip, 0.0, "{motion:?}");
                let own = rebound.r_x.unwrap();
                assert!((own - expected).abs() < 1e-12, "{motion:?} f = {f}: {own}");
                assert_eq!(rebound.energy.dissipated, 0.0);
                assert_eq!(rebound.impulse.xy().norm(), 0.0);
            }
        }
    }
    let oblique = ObliqueImpact::new(Groups::new(chi, 0.0).unwrap()).unwrap().restitution();
    let table = RestitutionTable::shared().restitution(Groups::new(chi, 0.0).unwrap()).unwrap();
    let map = restitution_map(&[chi], &[0.0], |_| ()).unwrap()[0][0];
    assert_eq!((oblique, map), (limit, limit));
    assert!((table - limit).abs() < 1e-8);
}

/// An ellipsoid on a plane, its axis c along the normal but for `tilt`.
fn ellipsoid(axes: [f64; 3], tilt: f64, velocity: [f64; 3], f: f64) -> Collision {
    let surface = Surface::ellipsoid(axes).unwrap();
    let inertia = surface.solid(0.3).unwrap();
    let attitude = Attitude::about([0.3, 1.0, 0.0], tilt).unwrap();
    let down = attitude.to_body(&-Vector3::z());
    let scaled = Vector3::from(axes).component_mul(&down);
    let height = scaled.norm();
    let foot = attitude.to_space(&Vector3::from(axes).component_mul(&scaled)) / height;
    let body = Body::new(surface, steel(), inertia)
        .turned(attitude)
        .at((-foot).into())
        .unwrap()
        .moving(Motion::new(velocity, [0.0; 3]).unwrap());
    Collision::at(body, Body::plane(steel()), [0.0; 3], friction(f)).unwrap()
}

/// However an ellipsoid grazes, the impulse of friction is at most f times the normal one, to the last digits.
#[test]
fn what_grazes_stays_within_friction() {
    for exponent in 2..13 {
        for (tilt, f) in [(0.0, 0.02), (0.0, 0.5), (0.4, 0.02), (0.4, 0.3)] {
            let approach = libm::pow(10.0, -f64::from(exponent));
            let encounter = ellipsoid([0.03, 0.02, 0.015], tilt, [1.0, 0.3, -approach], f);
            let impulse = encounter.frame().to_contact(&collided(&encounter).impulse);
            let share = impulse.xy().norm() / (f * impulse.z);
            assert!((0.9..=1.0 + 1e-15).contains(&share), "{approach:e} {tilt} {f}: {share}");
        }
    }
}

#[test]
fn a_limit_that_depends_on_the_direction_is_none() {
    let restitution = |encounter: &Collision| collided(encounter).r_x;
    let thin = [0.03, 0.02, 0.015];
    assert_eq!(restitution(&ellipsoid(thin, 0.0, DOWN, 0.3)), None);
    assert_eq!(restitution(&ellipsoid(thin, 0.0, DOWN, 0.0)), Some(-1.0));
    // The normal force turns a body whose centre is not above the contact.
    assert_eq!(restitution(&ellipsoid(thin, 0.4, DOWN, 0.3)), None);
    assert_eq!(restitution(&ellipsoid(thin, 0.4, DOWN, 0.0)), None);
    // Round about the normal: chi = 1 + m c^2/theta, over kappa.
    let (rim, c) = (0.03, 0.015);
    let turning = 1.0 + 5.0 * c * c / (rim * rim + c * c);
    let limit = restitution_without_slip(turning * chi_of_sphere(0.3) / 3.5);
    let own = restitution(&ellipsoid([rim, rim, c], 0.0, DOWN, 0.3)).unwrap();
    assert!((own - limit).abs() < 1e-12, "{own} {limit}");
}

#[test]
fn the_direction_of_the_slip_counts_however_small_it_is() {
    for velocity in [[1.0, 0.0], [0.0, 1.0]] {
        let left = |size: f64| {
            let [x, y] = velocity.map(|v| v * size);
            let rebound = collided(&ellipsoid([0.03, 0.02, 0.015], 0.0, [x, y, -1.0], 0.3));
            (rebound.contact_velocity_after.xy() / size, rebound.r_x)
        };
        let (expected, restitution) = left(1e-12);
        assert!(restitution.is_some());
        for size in [1e-300, 1e-200, 1e-163, 1e-100, 1e-18] {
            // It reads as rounding, so R_x has no direction; the velocities have.
            let (own, none) = left(size);
            assert!((own - expected).norm() < 1e-11 && none.is_none(), "{velocity:?} {size:e}");
        }
    }
}

#[test]
fn a_small_ball_on_a_large_one_is_uncoupled() {
    let (small, large) = (8.25e-3, 37.5);
    let ball = Surface::sphere(small).unwrap();
    let inertia = ball.solid(0.0185).unwrap();
    let normal = Vector3::new(0.36, -0.48, 0.8);
    let motion = Motion::new([0.5, 0.2, -2.0], [3.0, -20.0, 7.0]).unwrap();
    let body = Body::sphere(small, steel(), 0.0185).unwrap().moving(motion);
    let hit = Surface::sphere(large).unwrap();
    // Held fast, and as heavy as steel is.
    for inertia_2 in [Inertia::FIXED, hit.solid(1.7e9).unwrap()] {
        let body_2 = Body::sphere(large, steel(), 1.0).unwrap().with_inertia(inertia_2);
        let along =
            |normal| Collision::along(body.clone(), body_2.clone(), normal, friction(0.3)).unwrap();
        for place in [[0.0; 3], [1e3, -2e3, 5e2], [1e6, 1e6, -1e6]] {
            let place = Vector3::from(place);
            let one = Body::new(ball.clone(), steel(), inertia)
                .at((place + normal * small).into())
                .unwrap()
                .moving(motion);
            let two = Body::new(hit.clone(), steel(), inertia_2)
                .at((place - normal * large).into())
                .unwrap();
            let encounter = Collision::touching(one, two, friction(0.3)).unwrap();
            let d = encounter.mobility().matrix();
            assert_eq!((d.m12, d.m13, d.m23, d.m11), (0.0, 0.0, 0.0, d.m22));
            // Told nothing of the shapes.
            let (stiffness, velocity) = (encounter.hertz().stiffness(), encounter.velocity());
            let impact =
                CoupledImpact::new(*encounter.mobility(), stiffness, friction(0.3), velocity);
            let method = impact.unwrap().method();
            assert!(matches!(method, ImpactMethod::Uncoupled { .. }), "{method:?}");
            same(&encounter, along).unwrap();
        }
    }
}

#[test]
fn a_small_ball_on_a_curved_wall_is_uncoupled() {
    let ball = Surface::sphere(8.25e-3).unwrap();
    let inertia = ball.solid(0.0185).unwrap();
    let walls = [
        Surface::cylinder(37.5, 90.0).unwrap(),
        Surface::torus(90.0, 37.5).unwrap(),
        Surface::ellipsoid([37.5, 60.0, 45.0]).unwrap(),
    ];
    for (wall, start) in walls.into_iter().zip([90.0, 140.0, 90.0]) {
        let wall = Body::new(wall, steel(), Inertia::FIXED);
        let motion = Motion::new([-2.0, 0.1, 0.0], [0.0, 4.0, 9.0]).unwrap();
        let place = [start, 0.7, 0.4];
        let one = Body::new(ball.clone(), steel(), inertia).at(place).unwrap().moving(motion);
        let encounter = Collision::meeting(one, wall, friction(0.3)).unwrap();
        let d = encounter.mobility().matrix();
        assert_eq!((d.m12, d.m13, d.m23, d.m11), (0.0, 0.0, 0.0, d.m22));
        let rebound = collided(&encounter);
        assert!(rebound.energy.after <= rebound.energy.before * (1.0 + 1e-15));
        assert!(rebound.r_x.unwrap().abs() <= 1.0);
    }
}

#[test]
fn upright_bodies_in_any_attitude_are_uncoupled() {
    // The end of an axis, turned as a whole: couplings that are roundings only.
    let axes = [0.03, 0.02, 0.015];
    let mut worst: f64 = 0.0;
    for i in 0..200 {
        let angle = 0.37 * f64::from(i);
        let turn = Attitude::about([angle.sin(), angle.cos(), (2.0 * angle).sin()], angle).unwrap();
        let up = turn.to_space(&Vector3::z());
        let place = Vector3::new(1e4, -3e4, 2e4);
        let surface = Surface::ellipsoid(axes).unwrap();
        let body = Body::new(surface.clone(), steel(), surface.solid(0.3).unwrap())
            .turned(turn)
            .at((place + up * axes[2]).into())
            .unwrap()
            .moving(Motion::new((-up).into(), [0.0; 3]).unwrap());
        let large = Surface::sphere(30.0).unwrap();
        let ground =
            Body::new(large, steel(), Inertia::FIXED).at((place - up * 30.0).into()).unwrap();
        let encounter = Collision::touching(body, ground, friction(0.3)).unwrap();
        let d = encounter.mobility().matrix();
        worst = worst.max(d.m13.abs().max(d.m23.abs()) / d.m33);
    }
    println!("coupling of upright ellipsoids 4e4 from the origin: {worst:e}");
    // The direction of the normal is known to a rounding of the place over the large radius.
    assert!(worst <= 1e-9, "{worst:e}");
}

#[test]
fn a_sphere_that_turns_unevenly_leaves_its_plane() {
    let plane = Body::plane(steel());
    let motion = Motion::new([1.0, 0.5, -1.0], [0.0; 3]).unwrap();
    let ball = Body::sphere(0.01, steel(), 0.03).unwrap().moving(motion);
    let theta = 1e-6;
    let turned = |moments: [f64; 3]| {
        let uneven = ball.clone().with_inertia(Inertia::new(0.03, moments).unwrap());
        let collision = Collision::new(uneven, plane.clone(), friction(0.3)).unwrap();
        let rebound = collided(&collision);
        conserves(&collision, &rebound).unwrap();
        rebound
    };
    let uneven = turned([theta, 1.5 * theta, theta]);
    assert_eq!(uneven.method, ImpactMethod::Spatial { coupled: false });
    assert!(
        uneven.contact_velocity_after.xy().perp(&uneven.contact_velocity_before.xy()).abs() > 1e-3
    );
    // About the normal it may: the slip is not turned.
    let spinning = turned([theta, theta, 1.5 * theta]);
    assert!(matches!(spinning.method, ImpactMethod::Uncoupled { .. }));
    assert!(
        spinning.contact_velocity_after.xy().perp(&spinning.contact_velocity_before.xy()).abs()
            < 1e-15
    );
}

#[test]
fn bodies_far_from_the_origin_meet() {
    for place in [[0.0; 3], [1e6, -1e6, 1e6]] {
        let ball = |x: f64, v: f64| {
            let surface = Surface::sphere(0.01).unwrap();
            let inertia = surface.solid(0.03).unwrap();
            Body::new(surface, steel(), inertia)
                .at([place[0] + x, place[1], place[2]])
                .unwrap()
                .moving(Motion::new([v, 0.0, 0.0], [0.0; 3]).unwrap())
        };
        let encounter = Collision::meeting(ball(-1.0, 3.0), ball(0.5, 0.0), friction(0.2)).unwrap();
        let [one, two] = collided(&encounter).motions;
        assert!(one.velocity.norm() < 1e-7 && (two.velocity.x - 3.0).abs() < 1e-7);
        let gap = (encounter.bodies()[0].placed().centre()
            - encounter.bodies()[1].placed().centre())
        .norm()
            - 0.02;
        assert!(gap.abs() < 1e-15 + 4.0 * f64::EPSILON * place[0].abs(), "{gap:e}");
    }
    // From a long way off.
    let surface = Surface::sphere(0.01).unwrap();
    let inertia = surface.solid(0.03).unwrap();
    let far = Body::new(surface, steel(), inertia)
        .at([0.0, 0.0, 1e6])
        .unwrap()
        .moving(Motion::new([0.0, 0.0, -3.0], [0.0; 3]).unwrap());
    let landed = Collision::meeting(far, Body::plane(steel()), friction(0.2)).unwrap();
    assert!((landed.bodies()[0].placed().centre().z - 0.01).abs() < 1e-14);
}

/// Head-on, R_x is told where it is the same in all directions: not of a ball whose moments of inertia differ, however
/// their axes lie, along whatever normal, and whichever of the bodies moves.
#[test]
fn head_on_restitution_is_told_if_it_is_that_of_all_directions() {
    for normal in [[0.0, 0.0, 1.0], [0.3, -0.2, 1.0], [0.1, 0.7, -0.4], [-0.9, 0.2, 0.3]] {
        for (degrees, moving) in [(0.0, 0), (45.0, 0), (70.0, 0), (0.0, 1), (45.0, 1), (70.0, 1)] {
            for (moments, tells) in [([1.2e-6; 3], true), ([1.0e-6, 1.6e-6, 1.2e-6], false)] {
                let ball = || Body::sphere(0.01, steel(), 0.03).unwrap();
                let turned = Attitude::about([0.0, 0.0, 1.0], f64::to_radians(degrees)).unwrap();
                let other = ball().with_inertia(Inertia::new(0.03, moments).unwrap());
                let mut bodies = [ball(), other.turned(turned)];
                let velocity: Vector3<f64> =
                    [-0.7, 0.7][moving] * Vector3::from(normal).normalize();
                let motion = Motion::new(velocity.into(), [0.0; 3]).unwrap();
                bodies[moving] = bodies[moving].clone().moving(motion);
                let [one, two] = bodies;
                let met = collided(&Collision::along(one, two, normal, friction(0.3)).unwrap());
                assert_eq!(met.r_x.is_some(), tells, "{normal:?} {degrees} {moving}");
            }
        }
    }
}
