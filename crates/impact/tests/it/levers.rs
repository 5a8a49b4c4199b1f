//! Mobilities compared with rigid-body mechanics, and the outcome after a search of the contact point.

use crate::random::{attitude, direction};
use carom_drawn::{Draw as _, Splitmix};
use carom_geometry::{Attitude, Inertia, Surface};
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Lever, Mobility, Motion, Outcome, Warning};
use carom_laws::friction::Friction;
use nalgebra::{Matrix3, Vector3};

fn steel() -> Material {
    Material::from_shear(80e9, 0.3).unwrap()
}

#[test]
fn levers_follow_newton_and_euler() {
    let mut numbers = Splitmix(6);
    for _ in 0..50 {
        let inertia =
            Inertia::new(numbers.between(0.1, 5.0), [(); 3].map(|()| numbers.between(1.0, 1.9)))
                .unwrap();
        let (attitude, arm) =
            (attitude(&mut numbers), direction(&mut numbers) * numbers.between(0.1, 3.0));
        let impulse = direction(&mut numbers) * numbers.between(0.1, 3.0);
        let lever = Lever::new(inertia, &attitude, arm).unwrap();
        let moments = Matrix3::from_diagonal(&Vector3::from(inertia.moments()));
        let tensor = attitude.matrix() * moments * attitude.matrix().transpose();
        let spin = tensor.lu().solve(&arm.cross(&impulse)).unwrap();
        // (8.36), (8.43): E J; (8.31): the velocity of the point.
        assert!((lever.turning() * impulse - spin).norm() < 1e-14 * (1.0 + spin.norm()));
        let velocity = impulse / inertia.mass() + spin.cross(&arm);
        assert!((lever.mobility() * impulse - velocity).norm() < 1e-13 * (1.0 + velocity.norm()));
        // (8.27): that of the point, from the motion of the body.
        let of_point = lever.point_velocity(&(impulse / inertia.mass()), &spin);
        assert!((lever.mobility() * impulse - of_point).norm() < 1e-13 * (1.0 + velocity.norm()));
    }
}

#[test]
fn a_body_on_a_pivot_turns_and_a_guided_one_does_not() {
    // Infinite mass with finite moments, and the other way round.
    let (far, free) = (f64::INFINITY, [0.5, 0.6, 0.7]);
    let arm = Vector3::new(0.0, 0.8, -0.5);
    let push = Vector3::new(0.3, -0.2, 1.0);
    let at = |inertia| Lever::new(inertia, &Attitude::ALIGNED, arm).unwrap();
    let pivot = at(Inertia::new(far, free).unwrap());
    let spin = arm.cross(&push).component_div(&Vector3::from(free));
    assert!((pivot.turning() * push - spin).norm() < 1e-15);
    assert!((pivot.mobility() * push - spin.cross(&arm)).norm() < 1e-15);
    // Nothing moves along the arm: alone it has no mobility, with a free body it has.
    let held = at(Inertia::FIXED);
    assert_eq!(held.mobility(), Matrix3::zeros());
    let axes = Matrix3::identity();
    assert_eq!(Mobility::new(&[held, held], &axes).unwrap_err().field, "determinant of mobility D");
    let guided = at(Inertia::new(2.0, [far; 3]).unwrap());
    assert_eq!(guided.mobility(), Matrix3::identity() * 0.5);
    assert_eq!(guided.turning(), Matrix3::zeros());
    assert!(Mobility::new(&[pivot, guided], &axes).is_ok());
    // A whole encounter: a pivoted ellipsoid hit off its centre by a ball.
    let egg = Surface::ellipsoid([1.0, 0.8, 0.6]).unwrap();
    let point = Vector3::new(0.5, 0.0, 0.6 * 0.75_f64.sqrt());
    let normal = egg.local(&point).unwrap().normal();
    let swing = Body::new(egg, steel(), Inertia::new(far, free).unwrap());
    let ball = Surface::sphere(0.3).unwrap();
    let inertia = ball.solid(0.1).unwrap();
    let ball = Body::new(ball, steel(), inertia)
        .at((point + normal * 0.3).into())
        .unwrap()
        .moving(Motion::new((-normal).into(), [0.0; 3]).unwrap());
    let encounter = Collision::touching(ball, swing, Friction::new(0.3).unwrap()).unwrap();
    let Outcome::Rebound(rebound) = encounter.solve().unwrap() else { panic!("no impact") };
    assert_eq!(rebound.motions[1].velocity, Vector3::zeros());

    let spin = point.cross(&-rebound.impulse).component_div(&Vector3::from(free));
    assert!((rebound.motions[1].spin - spin).norm() < 1e-13 * spin.norm());
    assert!(spin.norm() > 0.01);
    let kept = rebound.energy.after + rebound.energy.dissipated;
    assert!((kept / rebound.energy.before - 1.0).abs() < 1e-14);
}

#[test]
fn an_outcome_says_that_its_point_is_not_proven() {
    let falling = Motion::new([-1.0, 0.0, 0.0], [0.0; 3]).unwrap();
    let egg = || Surface::ellipsoid([0.8, 0.6, 0.4]).unwrap();
    let inertia = egg().solid(1.0).unwrap();
    let warned = |other: Surface, x: f64| {
        let egg = Body::new(egg(), steel(), inertia).at([x, 0.0, 0.0]).unwrap();
        let other = Body::new(other, steel(), Inertia::FIXED);
        let encounter = Collision::touching(egg.moving(falling), other, Friction::NONE).unwrap();
        encounter.solve().unwrap().rebound().unwrap().warnings.contains(&Warning::PointSampled)
    };
    assert!(warned(Surface::torus(2.0, 0.3).unwrap(), 3.1));
    assert!(!warned(Surface::sphere(2.3).unwrap(), 3.1));
}

/// Reciprocity makes D symmetric: to 1e-9 of its largest entry.
#[test]
fn a_mobility_is_symmetric_to_its_stated_tolerance() {
    let matrix = |skew: f64| {
        let mut matrix = Matrix3::from_diagonal(&Vector3::new(2.0, 3.0, 4.0));
        matrix.m13 = 0.5 + 4.0 * skew;
        matrix.m31 = 0.5;
        Mobility::from_matrix(matrix)
    };
    let own = matrix(0.9e-9).unwrap();
    assert_eq!(own.matrix().m13, own.matrix().m31);
    assert!(matrix(1.1e-9).is_err() && matrix(-1.1e-9).is_err());
}
