//! Friction that depends on the slip speed at the first touch.

use std::f64::consts::{E, PI};

use carom_geometry::{Attitude, Surface};
use carom_halfspace::Material;
use carom_impact::scene::{Ball, Limits, Scene, Wall};
use carom_impact::{Body, Collision, ImpactFriction, Motion, NormalRestitution, Rebound};
use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use proptest::prelude::*;

const RADIUS: f64 = 0.01;

fn steel() -> Material {
    Material::from_young(208e9, 0.3).unwrap()
}

fn law() -> SlipSpeedFriction {
    SlipSpeedFriction::new(0.05, 0.1, 0.25).unwrap()
}

fn ball(velocity: [f64; 3], spin: [f64; 3]) -> Body {
    let motion = Motion::new(velocity, spin).unwrap();
    Body::sphere(RADIUS, steel(), 0.033).unwrap().moving(motion)
}

fn rebound(ball: Body, friction: impl Into<ImpactFriction>, restitution: f64) -> Rebound {
    let collision = Collision::new(ball, Body::plane(steel()), friction).unwrap();
    let restitution = NormalRestitution::new(restitution).unwrap();
    let outcome = collision.with_normal_restitution(restitution).solve().unwrap();
    outcome.rebound().unwrap().clone()
}

/// Sliding throughout, Newton's law alone: the impulse is (1 + e) m v_z, friction f times it against the slip, on a
/// solid sphere of moment 2/5 m R^2.
#[test]
fn a_ball_that_slides_throughout_is_braked_by_the_friction_of_its_slip_speed() {
    for (v_x, v_z, spin, e) in
        [(3.0, 0.2, 0.0, 1.0), (8.0, 0.5, 150.0, 0.8), (-5.0, 0.3, 20.0, 0.9)]
    {
        // Spin about y moves the lowest point of the ball by -R spin.
        let slip: f64 = v_x - RADIUS * spin;
        let f = (0.05 + 0.1 * (-0.25 * slip.abs()).exp()) * slip.signum();
        let found = rebound(ball([v_x, 0.0, -v_z], [0.0, spin, 0.0]), law(), e);
        let [after, _] = found.motions;
        let push = f * (1.0 + e) * v_z;
        assert!((after.velocity.x - (v_x - push)).abs() < 1e-13, "{after:?}");
        assert!((after.spin.y - (spin + 2.5 * push / RADIUS)).abs() < 1e-10, "{after:?}");
        assert!((after.velocity.z - e * v_z).abs() < 1e-13, "{after:?}");
        assert!((found.friction.get() - f.abs()).abs() < 1e-15);
    }
}

/// A ball rolls without slip: its friction is a + b.
#[test]
fn without_slip_friction_is_that_at_rest() {
    let found = rebound(ball([1.0, 0.0, -1.0], [0.0, 1.0 / RADIUS, 0.0]), law(), 1.0);
    assert!((found.friction.get() - 0.15).abs() < 1e-15);
    let found = rebound(ball([4.0, 0.0, -1.0], [0.0; 3]), law(), 1.0);
    assert!((found.friction.get() - (0.05 + 0.1 / E)).abs() < 1e-15);
}

/// An impact with the coefficient that the law gives is the same impact, also of other shapes than spheres.
#[test]
fn the_impact_is_that_of_a_constant_coefficient() {
    let egg = Surface::ellipsoid([0.03, 0.02, 0.015]).unwrap();
    let inertia = egg.solid(0.3).unwrap();
    let turned = Attitude::about([0.0, 1.0, 0.0], PI / 7.0).unwrap();
    let motion = Motion::new([1.5, -0.7, -1.0], [3.0, 20.0, 1.0]).unwrap();
    let egg = Body::new(egg, steel(), inertia).turned(turned).moving(motion);
    let with = |friction: ImpactFriction| {
        Collision::new(egg.clone(), Body::plane(steel()), friction).unwrap()
    };
    let by_speed = with(law().into());
    let slip = by_speed.velocity().xy().norm();
    let constant = with(law().at(slip).unwrap().into());
    assert_eq!(by_speed.friction(), constant.friction());
    assert_eq!(by_speed.solve().unwrap(), constant.solve().unwrap());
}

/// Each bounce of a scene has the coefficient of its own slip speed.
#[test]
fn every_bounce_of_a_scene_evaluates_its_friction() {
    let floor = Wall::new([0.0; 3], [0.0, 0.0, 1.0], steel(), law()).unwrap();
    let scene = Scene::new([0.0, 0.0, -10.0]).unwrap().with(floor);
    let body = ball([3.0, 1.0, 0.0], [0.0, 5.0, 0.0]).at([0.0, 0.0, 0.06]).unwrap();
    let path = scene.run(&Ball::new(body).unwrap(), Limits::new(3.0, 6).unwrap()).unwrap();
    assert_eq!(path.bounces().len(), 6);
    let mut last = 0.0;
    for bounce in path.bounces() {
        let (v, w) = (bounce.before.velocity, bounce.before.spin);
        let slip = libm::hypot(v.x - RADIUS * w.y, v.y + RADIUS * w.x);
        let f = bounce.rebound.friction.get();
        assert!((f - (0.05 + 0.1 * (-0.25 * slip).exp())).abs() < 1e-12, "{f} at {slip}");
        assert!(f >= last, "the slip decreases");
        last = f;
    }
    assert!(last > 1.2 * path.bounces()[0].rebound.friction.get());
}

#[test]
fn a_constant_coefficient_has_the_same_bits_as_before() {
    let constant = SlipSpeedFriction::new(0.15, 0.0, 3.0).unwrap();
    let body = ball([1.3, 0.2, -1.0], [7.0, 11.0, 0.0]);
    let plain = rebound(body.clone(), Friction::new(0.15).unwrap(), 0.9);
    assert_eq!(rebound(body, constant, 0.9), plain);
}

proptest! {
    /// The mirror image of a collision in the plane y = 0 has the same friction and the mirror image of its outcome.
    #[test]
    fn mirror_images_remain_mirror_images(
        v in prop::array::uniform3(-3.0..3.0f64), w in prop::array::uniform3(-90.0..90.0f64),
    ) {
        let v = [v[0], v[1], -0.1 - v[2].abs()];
        let one = rebound(ball(v, w), law(), 1.0);
        let two = rebound(ball([v[0], -v[1], v[2]], [-w[0], w[1], -w[2]]), law(), 1.0);
        prop_assert_eq!(one.friction, two.friction);
        let [a, b] = [one.motions[0], two.motions[0]];
        prop_assert!((a.velocity.x - b.velocity.x).abs() < 1e-12);
        prop_assert!((a.velocity.y + b.velocity.y).abs() < 1e-12);
        prop_assert!((a.spin.x + b.spin.x).abs() < 1e-9);
    }
}
