//! How scenes, histories, studies and the stored table end: heights, order, axes, the greatest of all errors.

use carom_geometry::Surface;
use carom_halfspace::Material;
use carom_impact::restitution::check_dissimilar;
use carom_impact::scene::{Ball, Ending, Limits, Path, Scene, Wall};
use carom_impact::uncertain::{Distribution, Sampling};
use carom_impact::{
    AnalyticOrRings, Body, Collision, CollisionError, CollisionSolver, Motion, NormalRestitution,
};
use carom_laws::friction::Friction;

const RADIUS: f64 = 0.02;

fn rubber() -> Material {
    Material::from_young(20e6, 0.5).unwrap()
}

fn wall(normal: [f64; 3]) -> Wall {
    Wall::new([0.0; 3], normal, Material::RIGID, Friction::new(0.3).unwrap()).unwrap()
}

fn ball(radius: f64, position: [f64; 3], velocity: [f64; 3]) -> Ball {
    let body = Body::sphere(radius, rubber(), 0.04).unwrap().at(position).unwrap();
    Ball::new(body.moving(Motion::new(velocity, [0.0; 3]).unwrap())).unwrap()
}

/// Dropped from 1 m on a floor that leaves half of the velocity: it rises to a quarter each time.
fn dropped(radius: f64, rest: f64) -> Path {
    let floor = wall([0.0, 0.0, 1.0]).with_normal_restitution(NormalRestitution::new(0.5).unwrap());
    let scene = Scene::new([0.0, 0.0, -10.0]).unwrap().with(floor);
    let limits = Limits::new(100.0, 100).unwrap().at_rest_below(rest).unwrap();
    let path = scene.run(&ball(radius, [0.0, 0.0, 1.0 + radius], [0.0; 3]), limits).unwrap();
    assert_eq!(path.ending(), Ending::Rest { wall: 0 });
    path
}

#[test]
fn a_ball_rests_where_it_would_rise_less_than_the_limit() {
    // 1/4, 1/16, 1/64 m.
    for (rest, bounces) in [(0.26, 1), (0.24, 2), (0.1, 2), (0.063, 2), (0.062, 3), (0.03, 3)] {
        assert_eq!(dropped(RADIUS, rest).bounces().len(), bounces, "{rest}");
    }
    // Without a limit: less than a millionth of the radius.
    for radius in [RADIUS, 0.5] {
        let path = dropped(radius, 0.0);
        let height = |bounces: usize| 0.25_f64.powi(bounces as i32);
        let count = path.bounces().len();
        assert!(height(count) < 1e-6 * radius && height(count - 1) >= 1e-6 * radius, "{count}");
    }
}

#[test]
fn in_a_corner_the_wall_added_first_comes_first() {
    let (x, y) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    for [first, second] in [[x, y], [y, x]] {
        let scene = Scene::new([0.0; 3]).unwrap().with(wall(first)).with(wall(second));
        let start = ball(RADIUS, [1.0 + RADIUS, 1.0 + RADIUS, 0.0], [-1.0, -1.0, 0.0]);
        let path = scene.run(&start, Limits::new(5.0, 2).unwrap()).unwrap();
        let walls: Vec<usize> = path.bounces().iter().map(|bounce| bounce.wall).collect();
        assert_eq!(walls, [0, 1]);
        assert_eq!(path.bounces()[0].time, path.bounces()[1].time);
    }
}

/// The contact of an ellipsoid is longer along y, the smaller curvature, at each instant as at the greatest.
#[test]
fn the_semi_axes_of_a_history_are_those_of_the_contact() {
    let egg = Surface::ellipsoid([0.03, 0.01, 0.012]).unwrap();
    let inertia = egg.solid(0.03).unwrap();
    let egg =
        Body::new(egg, rubber(), inertia).moving(Motion::new([0.1, 0.05, -1.0], [0.0; 3]).unwrap());
    let collision =
        Collision::new(egg, Body::plane(Material::RIGID), Friction::new(0.3).unwrap()).unwrap();
    let history = collision.history(31).unwrap();
    let outcome = collision.solve().unwrap();
    let greatest = outcome.rebound().unwrap().maximal_contact;
    let ratio = greatest.semi_axis_a() / greatest.semi_axis_b();
    assert!(ratio < 0.5, "{ratio}");
    for point in &history[1..30] {
        let [a, b] = point.semi_axes;
        assert!((a / b / ratio - 1.0).abs() < 1e-12, "{a} {b}");
        // zeta = A a^2 K/(K - D): a^2 grows as the approach.
        let want = greatest.semi_axis_b().powi(2) * point.shift.z
            / outcome.rebound().unwrap().maximal_approach;
        assert!((b * b / want - 1.0).abs() < 1e-9, "{b}");
    }
}

fn unlike(friction: f64) -> Result<Collision, CollisionError> {
    let material = |young, poisson| Material::from_young(young, poisson);
    let ball = Body::sphere(2.5e-3, material(380e9, 0.23)?, 2.6e-4)?;
    let ball = ball.moving(Motion::new([0.4, 0.0, -2.0], [0.0; 3])?);
    Collision::new(ball, Body::plane(material(70e9, 0.22)?), Friction::new(friction)?)
}

/// The error of a study is the greatest of its samples', whichever comes last.
#[test]
fn the_error_of_a_study_is_that_of_its_worst_sample() {
    let error = |friction: f64| {
        let outcome = AnalyticOrRings.solve(&unlike(friction).unwrap()).unwrap();
        outcome.rebound().unwrap().error_estimate
    };
    let mut differs = 0;
    for seed in 1..6 {
        let friction = Distribution::uniform(0.02, 0.4).unwrap();
        let study = Sampling::new(8, seed).unwrap().run(&[friction], |f| unlike(f[0])).unwrap();
        let errors: Vec<f64> = study.inputs()[0].sorted().iter().map(|f| error(*f)).collect();
        let worst = errors.iter().copied().fold(0.0, f64::max);
        assert_eq!(study.error_estimate(), worst, "{seed}");
        differs += usize::from(errors.iter().filter(|error| **error < worst).count() > 4);
    }
    assert!(differs > 0);
}

/// The law that filled the table gives its entries again, lambda = 0 among them.
#[test]
fn entries_of_the_stored_table_are_found_again() {
    let largest = check_dissimilar(60, 14).unwrap();
    assert!(largest < 1e-6, "{largest}");
}
