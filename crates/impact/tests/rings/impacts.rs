//! Everyday pairs, sphere on plane.

use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, RingImpact};
use carom_laws::friction::Friction;
use std::time::Instant;

fn material(name: &str) -> Material {
    let (e, nu) = match name {
        "alumina" => (380e9, 0.23),
        "glass" => (71e9, 0.22),
        "steel" => (208e9, 0.3),
        "silica" => (72e9, 0.17),
        "aluminium" => (70e9, 0.33),
        _ => unreachable!(),
    };
    Material::from_young(e, nu).unwrap()
}

fn collision(sphere: &str, plane: &str, friction: f64, angle: f64) -> Collision {
    let angle = angle.to_radians();
    let radius = 0.0025;
    let ball =
        Body::sphere(radius, material(sphere), 3900.0 * 4.19 * radius * radius * radius).unwrap();
    let ball = ball.moving(Motion::new([-angle.sin(), 0.0, -angle.cos()], [0.0; 3]).unwrap());
    Collision::new(ball, Body::plane(material(plane)), Friction::new(friction).unwrap()).unwrap()
}

#[test]
fn everyday_pairs() {
    for (sphere, plane, f, want) in [
        ("alumina", "glass", 0.092, [0.196, 0.292, 0.4385]),
        ("steel", "glass", 0.15, [-0.0665, 0.072, 0.2655]),
        ("glass", "steel", 0.1, [0.100, 0.238, 0.417]),
        ("silica", "steel", 0.08, [0.214, 0.320, 0.455]),
        ("steel", "aluminium", 0.3, [-0.164, -0.095, 0.023]),
    ] {
        for (angle, want) in [2.5, 7.5, 15.0].into_iter().zip(want) {
            let collision = collision(sphere, plane, f, angle);
            let gamma = collision.hertz().materials().gamma();
            let exact =
                collision.solve().unwrap().rebound().unwrap().tangential_restitution.unwrap();
            let mut line = format!(
                "{sphere}-{plane} gamma {gamma:.3} {angle}: exact {exact:.4} grid {want:.4} "
            );
            for tolerance in [1.0, 3e-3, 1e-9] {
                let begin = Instant::now();
                let outcome =
                    RingImpact::new(&collision).within(tolerance).unwrap().solve().unwrap();
                let rebound = outcome.rebound().unwrap();
                let v = rebound.velocity_before;
                let estimate = rebound.error_estimate * v.norm() / v.x.abs();
                line += &format!(
                    "| {:.4} +- {:.4} in {:.0} us ",
                    rebound.tangential_restitution.unwrap(),
                    estimate,
                    begin.elapsed().as_secs_f64() * 1e6
                );
            }
            println!("{line}");
        }
    }
}
