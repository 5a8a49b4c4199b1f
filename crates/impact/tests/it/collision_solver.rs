//! Scenes and studies choose the contact law of each impact; results for similar bodies do not change by it.

use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::Material;
use carom_impact::scene::{Ball, Limits, Path, Scene, Wall};
use carom_impact::uncertain::{Distribution, Quantity, Sampling, Study};
use carom_impact::{
    AnalyticOrRings, Body, Collision, CollisionError, CollisionSolver, Motion, NeededLaw, Outcome,
    RingImpact, Warning,
};
use carom_laws::friction::Friction;
use carom_laws::validity::Limit;
use carom_special::RangeError;

const FRICTION: f64 = 0.092;

/// The analytic law, whichever the materials.
struct Analytic;

impl CollisionSolver for Analytic {
    type Error = CollisionError;

    fn solve(&self, collision: &Collision) -> Result<Outcome, CollisionError> {
        collision.solve()
    }

    fn out_of_range(error: &CollisionError) -> Option<RangeError> {
        AnalyticOrRings::out_of_range(error)
    }
}

fn alumina() -> Material {
    Material::from_young(380e9, 0.23).unwrap()
}

fn glass() -> Material {
    Material::from_young(70e9, 0.22).unwrap()
}

fn ball(velocity: [f64; 3]) -> Body {
    let ball = Body::sphere(2.5e-3, alumina(), 2.6e-4).unwrap();
    ball.moving(Motion::new(velocity, [3.0, -20.0, 0.0]).unwrap())
}

fn bounces<S: CollisionSolver<Error: std::fmt::Debug>>(solver: S, floor: Material) -> Path {
    let friction = Friction::new(FRICTION).unwrap();
    let floor = Wall::new([0.0; 3], [0.0, 0.0, 1.0], floor, friction).unwrap();
    let scene = Scene::new([0.0, 0.0, -9.81]).unwrap().with(floor);
    let ball = Ball::new(ball([0.05, 0.0, 0.0]).at([0.0, 0.0, 0.1]).unwrap()).unwrap();
    scene.run_by(solver, &ball, Limits::new(10.0, 3).unwrap()).unwrap()
}

fn neglects(warnings: &[Warning]) -> bool {
    warnings.iter().any(|warning| warning.ratio(Limit::Coupling).is_some())
}

#[test]
fn scenes_of_like_bodies_keep_their_bits() {
    assert_eq!(bounces(AnalyticOrRings, alumina()), bounces(Analytic, alumina()));
}

#[test]
fn bounces_of_unlike_bodies_count_coupling() {
    let [rings, analytic] = [bounces(AnalyticOrRings, glass()), bounces(Analytic, glass())];
    let first = &rings.bounces()[0];
    let friction = Friction::new(FRICTION).unwrap();
    let collision =
        Collision::new(ball(first.before.velocity.into()), Body::plane(glass()), friction);
    let alone = RingImpact::new(&collision.unwrap()).solve().unwrap();
    assert_eq!(first.rebound.motions, alone.motions());
    for (ours, theirs) in rings.bounces().iter().zip(analytic.bounces()) {
        assert_eq!(ours.rebound.method.name(), "rings");
        assert!(ours.rebound.error_estimate > 0.0 && !neglects(&ours.rebound.warnings));
        assert!(neglects(&theirs.rebound.warnings));
    }
    // Coupling throws it back, unlike the analytic law.
    let r_x = |path: &Path| path.bounces()[0].rebound.r_x.unwrap();
    assert!(r_x(&rings) - r_x(&analytic) > 0.2, "{} {}", r_x(&rings), r_x(&analytic));
}

fn study<S: CollisionSolver<Error: Send + std::fmt::Debug> + Sync>(
    solver: &S,
    plate: Material,
    samples: usize,
) -> Study {
    let friction = Distribution::normal(FRICTION, 0.01).unwrap();
    Sampling::new(samples, 7)
        .unwrap()
        .run_by(solver, &[friction], |values| {
            Collision::new(ball([0.1, 0.0, -2.0]), Body::plane(plate), Friction::new(values[0])?)
        })
        .unwrap()
}

#[test]
fn studies_of_like_bodies_keep_their_bits() {
    let [auto, exact] = [study(&AnalyticOrRings, alumina(), 300), study(&Analytic, alumina(), 300)];
    assert_eq!(auto, exact);
    assert_eq!((auto.methods(), auto.coupling_neglected()), (&[("uncoupled", 300)][..], 0));
}

#[test]
fn studies_of_unlike_bodies_count_coupling_and_say_so() {
    let [auto, exact] = [study(&AnalyticOrRings, glass(), 16), study(&Analytic, glass(), 16)];
    assert_eq!((auto.methods(), auto.coupling_neglected()), (&[("rings", 16)][..], 0));
    assert_eq!((exact.methods(), exact.coupling_neglected()), (&[("uncoupled", 16)][..], 16));
    assert!(auto.error_estimate() > 0.0);
    let mean = |study: &Study| study.summary(Quantity::Restitution).unwrap().mean();
    assert!(mean(&auto) - mean(&exact) > 0.3, "{} {}", mean(&auto), mean(&exact));
}

#[test]
fn threads_do_not_change_a_study_by_rings() {
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| study(&AnalyticOrRings, glass(), 8))
    };
    assert_eq!(on(1), on(3));
}

/// Thin shells lie at the border of what was measured: round-off does not choose their law.
#[test]
fn thin_shells_of_any_size_have_one_law() {
    let [ball, plane] = [70e9, 72e9].map(|young| Material::from_young(young, 0.3).unwrap());
    let mut draw = Congruential(17);
    for _ in 0..100 {
        let [radius, mass] = [0; 2].map(|_| 10_f64.powf(draw.between(-3.0, 0.0)));
        let shell = Body::spherical_shell(radius, ball, mass).unwrap();
        let shell = shell.moving(Motion::new([0.5, 0.0, -1.0], [0.0; 3]).unwrap());
        let friction = Friction::new(0.3).unwrap();
        let collision = Collision::new(shell, Body::plane(plane), friction).unwrap();
        assert_eq!(collision.default_law(), NeededLaw::Analytic, "{radius} {mass}");
    }
}
