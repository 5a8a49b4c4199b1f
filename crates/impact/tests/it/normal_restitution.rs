//! Dissipation in the material: closed forms, energy, friction limit.

use approx::assert_relative_eq;
use carom_geometry::{Attitude, Surface};
use carom_halfspace::Material;
use carom_impact::closed_form::wave_loss;
use carom_impact::scene::{Ball, Ending, Limits, Scene, Wall};
use carom_impact::{
    Body, Collision, ImpactFriction, LossCause, Motion, NormalRestitution, Outcome, Rebound,
    RestitutionBySpeed,
};
use carom_laws::friction::Friction;
use carom_laws::static_friction::StaticFriction;
use carom_laws::validity::Limit;
use proptest::prelude::*;

const RADIUS: f64 = 0.02;
const MASS: f64 = 0.03;

fn rubber() -> Material {
    Material::from_young(20e6, 0.5).unwrap()
}

fn ball(velocity: [f64; 3], spin: [f64; 3]) -> Body {
    Body::sphere(RADIUS, rubber(), MASS).unwrap().moving(Motion::new(velocity, spin).unwrap())
}

fn on_floor(body: Body, friction: f64) -> Collision {
    Collision::new(body, Body::plane(Material::RIGID), Friction::new(friction).unwrap()).unwrap()
}

fn losing(collision: Collision, e: f64) -> Rebound {
    let restitution = NormalRestitution::new(e).unwrap();
    match collision.with_normal_restitution(restitution).solve().unwrap() {
        Outcome::Rebound(rebound) => *rebound,
        Outcome::NoImpact { .. } => unreachable!("they meet"),
    }
}

#[test]
fn a_ball_that_slides_throughout_has_the_closed_form() {
    let (f, e, vx, vz) = (0.1, 0.7, 3.0, -2.0);
    let rebound = losing(on_floor(ball([vx, 0.0, vz], [0.0; 3]), f), e);
    let [after, _] = rebound.motions;
    let impulse = MASS * (1.0 + e) * -vz;
    assert_relative_eq!(after.velocity.z, -e * vz, max_relative = 1e-14);
    assert_relative_eq!(after.velocity.x, vx - f * impulse / MASS, max_relative = 1e-14);
    let inertia = 0.4 * MASS * RADIUS * RADIUS;
    assert_relative_eq!(after.spin.y, f * impulse * RADIUS / inertia, max_relative = 1e-13);
    let slip = vx - after.velocity.x + RADIUS * after.spin.y;
    assert_relative_eq!(rebound.r_x.unwrap(), slip / vx - 1.0, max_relative = 1e-12);
}

#[test]
fn a_ball_that_slides_throughout_does_not_feel_static_friction() {
    let (e, vx, vz) = (0.7, 3.0, -2.0);
    let [f_s, f_k] = [0.2, 0.1].map(|f| Friction::new(f).unwrap());
    let both = ImpactFriction::from(StaticFriction::new(f_s, f_k).unwrap());
    let collision = on_floor(ball([vx, 0.0, vz], [0.0; 3]), 0.1).with_friction(both).unwrap();
    let rebound = losing(collision, e);
    let [after, _] = rebound.motions;
    let dv = f_k.get() * (1.0 + e) * -vz;
    assert!((after.velocity.x - (vx - dv)).abs() < 1e-3 * dv, "{}", after.velocity.x);
    let kinetic = losing(on_floor(ball([vx, 0.0, vz], [0.0; 3]), 0.1), e);
    let [heat, same] = [rebound, kinetic].map(|rebound| rebound.energy.dissipated);
    assert!((heat - same).abs() < 1e-3 * same, "{heat}, {same}");
}

/// The error of the step law that is taken away is that of the friction by which the ball slides.
#[test]
fn friction_never_pushes_a_ball_that_slides() {
    for (f_s, f_k, vx, vz) in
        [(0.3, 1e-6, 0.5, -0.5), (0.1, 0.0, 0.5, -1.0), (0.3, 1e-3, 2.0, -1.0)]
    {
        let [f_s, f_k] = [f_s, f_k].map(|f| Friction::new(f).unwrap());
        let both = ImpactFriction::from(StaticFriction::new(f_s, f_k).unwrap());
        let collision = on_floor(ball([vx, 0.0, vz], [0.0; 3]), 0.1).with_friction(both).unwrap();
        let rebound = losing(collision, 0.5);
        let lost = vx - rebound.motions[0].velocity.x;
        let wanted = f_k.get() * 1.5 * -vz;
        assert!((lost - wanted).abs() < 1e-3 * wanted + 1e-12, "{lost} {wanted}");
    }
}

#[test]
fn without_friction_the_material_takes_what_the_definition_says() {
    for e in [0.0, 0.3, 0.95] {
        let rebound = losing(on_floor(ball([1.0, 0.0, -2.0], [0.0; 3]), 0.0), e);
        assert_relative_eq!(rebound.energy.lost, 0.5 * MASS * 4.0 * (1.0 - e * e), epsilon = 1e-16);
        assert_eq!(rebound.energy.dissipated, 0.0);
        assert!((rebound.motions[0].velocity.z - 2.0 * e).abs() < 1e-15);
    }
}

#[test]
fn nothing_lost_is_the_elastic_impact_to_the_bit() {
    let collision = on_floor(ball([1.0, 0.4, -2.0], [3.0, 0.0, 40.0]), 0.3).with_torsion();
    let elastic = collision.solve().unwrap();
    assert_eq!(*elastic.rebound().unwrap(), losing(collision, 1.0));
}

#[test]
fn waves_take_the_share_of_the_closed_form() {
    let (density, poisson, young, speed) = (7850.0, 0.3, 208e9, 5.0);
    let steel = Material::from_young(young, poisson).unwrap();
    let mass = density * 4.0 / 3.0 * std::f64::consts::PI * RADIUS.powi(3);
    let body = Body::sphere(RADIUS, steel, mass)
        .unwrap()
        .moving(Motion::new([0.0, 0.0, -speed], [0.0; 3]).unwrap());
    let collision = Collision::new(body, Body::plane(steel), Friction::new(0.2).unwrap()).unwrap();
    let share = wave_loss(poisson, speed, f64::sqrt(young / density)).unwrap();
    let is_warned = |outcome: &Outcome| {
        let warnings = &outcome.rebound().unwrap().warnings;
        warnings.iter().any(|warning| warning.ratio(Limit::Waves).is_some())
    };
    assert!(is_warned(&collision.solve().unwrap()));
    let damped = collision.with_normal_restitution(NormalRestitution::by_waves()).solve().unwrap();
    assert!(!is_warned(&damped));
    let speed_after = damped.motions()[0].velocity.z;
    assert_relative_eq!(speed_after, speed * (1.0 - share).sqrt(), max_relative = 1e-12);
}

#[test]
fn a_coefficient_out_of_range_is_refused() {
    for e in [-0.1, 1.01, f64::NAN, f64::INFINITY] {
        let error = NormalRestitution::new(e).unwrap_err();
        assert_eq!((error.field, error.allowed), ("normal_restitution", "from 0 to 1"));
    }
}

#[test]
fn a_ball_comes_to_rest_in_the_time_of_the_geometric_series() {
    let (e, height, gravity) = (0.8_f64, 1.0, 9.81);
    let floor = Wall::new([0.0; 3], [0.0, 0.0, 1.0], Material::RIGID, Friction::new(0.3).unwrap())
        .unwrap()
        .with_normal_restitution(NormalRestitution::new(e).unwrap());
    let scene = Scene::new([0.0, 0.0, -gravity]).unwrap().with(floor);
    let body = ball([0.0; 3], [0.0; 3]).at([0.0, 0.0, RADIUS + height]).unwrap();
    let limits = Limits::new(100.0, 1000).unwrap();
    let path = scene.run(&Ball::new(body).unwrap(), limits).unwrap();
    assert_eq!(path.ending(), Ending::Rest { wall: 0 });
    for pair in path.bounces().windows(2) {
        let fallen = pair[1].before.velocity.z / pair[0].before.velocity.z;
        assert_relative_eq!(fallen, e, max_relative = 1e-6);
    }
    let fall = (2.0 * height / gravity).sqrt();
    let series = fall * (1.0 + e) / (1.0 - e);
    // What is left when it rises less than a millionth of its radius.
    let left = 2.0 * (2.0 * 1e-6 * RADIUS / gravity).sqrt() / (1.0 - e);
    assert!(path.last().time < series && path.last().time > series - 2.0 * left);
}

/// A ball, or an egg that is tilted, on a floor.
fn drawn([velocity, spin]: [[f64; 3]; 2], (f, tilt, is_sphere): (f64, f64, bool)) -> Collision {
    if is_sphere {
        return on_floor(ball(velocity, spin), f).with_torsion();
    }
    let egg = Surface::ellipsoid([0.03, 0.02, 0.015]).unwrap();
    let inertia = egg.solid(0.296).unwrap();
    let egg = Body::new(egg, rubber(), inertia);
    let egg = egg.turned(Attitude::about([0.0, 1.0, 0.0], tilt).unwrap());
    on_floor(egg.moving(Motion::new(velocity, spin).unwrap()), f).accepting_unsettled()
}

/// The balance of energies and the limit of friction; returns the speeds along the normal before and after.
fn booked(collision: &Collision, rebound: &Rebound, f: f64) -> [f64; 2] {
    let normal = collision.frame().z();
    let energy = rebound.energy;
    let balance = energy.before - energy.after - energy.dissipated - energy.lost;
    assert!(balance.abs() < 1e-11 * energy.before, "{balance:e} {energy:?}");
    assert!(energy.dissipated >= -1e-12 * energy.before && energy.lost >= 0.0, "{energy:?}");
    let pushed = rebound.impulse.dot(&normal);
    let rubbed = (rebound.impulse - pushed * normal).norm();
    assert!(rubbed <= f * pushed * (1.0 + 1e-9), "{rubbed} {pushed}");
    [rebound.contact_velocity_before, rebound.contact_velocity_after].map(|v| v.dot(&normal))
}

proptest! {
    #[test]
    fn energy_is_booked_and_the_friction_limit_holds(
        e in 0.0..1.0_f64,
        f in 0.0..1.5_f64,
        velocity in [-2.0..2.0_f64, -2.0..2.0, -3.0..-0.1],
        spin in [-60.0..60.0_f64, -60.0..60.0, -60.0..60.0],
        tilt in 0.0..1.2_f64,
        is_sphere in any::<bool>(),
    ) {
        let collision = drawn([velocity, spin], (f, tilt, is_sphere));
        let Outcome::Rebound(elastic) = collision.solve().unwrap() else { return Ok(()) };
        let by_yield = NormalRestitution::by_yield(e).unwrap();
        let yields = collision.clone().with_normal_restitution(by_yield).solve().unwrap();
        let yields = yields.rebound().unwrap();
        let [before, got] = booked(&collision, yields, f);
        prop_assert!(yields.energy.dissipated <= elastic.energy.dissipated * (1.0 + 1e-12) + 1e-300);
        // They part, however much friction took of the elastic rebound.
        let [_, want] = booked(&collision, &elastic, f);
        prop_assert!((got - e * want).abs() < 1e-12 * before.abs());
    }

    /// Of a viscous material e is the restitution where nothing couples; eggs part too.
    #[test]
    fn viscous_losses_are_booked_and_the_friction_limit_holds(
        e in 0.05..1.0_f64,
        f in 0.0..1.5_f64,
        velocity in [-2.0..2.0_f64, -2.0..2.0, -3.0..-0.1],
        spin in [-60.0..60.0_f64, -60.0..60.0, -60.0..60.0],
        tilt in 0.0..1.2_f64,
        is_sphere in any::<bool>(),
    ) {
        let collision = drawn([velocity, spin], (f, tilt, is_sphere));
        if collision.velocity().z <= 0.0 {
            return Ok(());
        }
        let rebound = losing(collision.clone(), e);
        let [before, after] = booked(&collision, &rebound, f);
        prop_assert!(before > 0.0 && after < 0.0, "{before} {after}");
        if is_sphere {
            prop_assert!((after + e * before).abs() < 1e-12 * before.abs());
        }
    }
}

/// An impact at a speed of the table is that of the number, below and above it that of its ends, in between of the straight
/// line; by any cause.
#[test]
fn a_restitution_by_speed_is_that_of_its_speed() {
    let table = RestitutionBySpeed::new(&[0.5, 2.0, 4.0], &[0.9, 0.6, 0.7]).unwrap();
    for cause in LossCause::ALL {
        let by_speed = NormalRestitution::by_speed(cause, table.clone()).unwrap();
        for (speed, e) in [(0.1, 0.9), (0.5, 0.9), (1.0, 0.8), (3.0, 0.65), (4.0, 0.7), (40.0, 0.7)]
        {
            let impact = on_floor(ball([0.2, 0.0, -speed], [0.0; 3]), 0.3);
            let solved = |loss: NormalRestitution| {
                impact.clone().with_normal_restitution(loss).solve().unwrap()
            };
            let number = NormalRestitution::by(cause, e).unwrap();
            let [one, other] = [solved(by_speed.clone()), solved(number)];
            let off = one.motions()[0].velocity - other.motions()[0].velocity;
            assert!(off.norm() < 1e-12 * speed, "{} {speed} {off}", cause.name());
            let uncertain = |outcome: &Outcome| outcome.rebound().unwrap().model_uncertainty;
            assert!((uncertain(&one) - uncertain(&other)).abs() < 1e-9);
        }
    }
}

/// A ball that falls on a floor rises at each bounce by the restitution of its speed.
#[test]
fn a_ball_rises_by_the_restitution_of_its_speed() {
    let table = RestitutionBySpeed::new(&[1.0, 3.0], &[0.9, 0.5]).unwrap();
    let loss = NormalRestitution::by_speed(LossCause::Viscous, table.clone()).unwrap();
    let floor = Wall::new([0.0; 3], [0.0, 0.0, 1.0], Material::RIGID, Friction::NONE).unwrap();
    let scene = Scene::new([0.0, 0.0, -9.81]).unwrap().with(floor.with_normal_restitution(loss));
    let falls = ball([0.0; 3], [0.0; 3]).at([0.0, 0.0, 0.5]).unwrap();
    let limits = Limits::new(10.0, 8).unwrap();
    let path = scene.run(&Ball::new(falls).unwrap(), limits).unwrap();
    let speeds: Vec<f64> = path.bounces().iter().map(|bounce| -bounce.before.velocity.z).collect();
    assert!(speeds.len() == 8 && speeds[0] > 2.5 && speeds[7] < 1.0, "{speeds:?}");
    for pair in speeds.windows(2) {
        assert!((pair[1] / (table.at(pair[0]) * pair[0]) - 1.0).abs() < 1e-9, "{pair:?}");
    }
}

#[test]
fn a_bad_restitution_by_speed_is_refused_by_name() {
    let field = |speeds: &[f64], e: &[f64]| RestitutionBySpeed::new(speeds, e).unwrap_err().field;
    assert_eq!(field(&[1.0], &[0.5]), "speed");
    assert_eq!(field(&[1.0, 1.0], &[0.5, 0.4]), "speed");
    assert_eq!(field(&[-1.0, 1.0], &[0.5, 0.4]), "speed");
    assert_eq!(field(&[1.0, f64::NAN], &[0.5, 0.4]), "speed");
    assert_eq!(field(&[1.0, 2.0], &[0.5]), "numbers of restitution");
    assert_eq!(field(&[1.0, 2.0], &[0.5, 1.0 + 1e-9]), "restitution");
    assert_eq!(field(&[1.0, 2.0], &[f64::NAN, 0.5]), "restitution");
    let table = RestitutionBySpeed::new(&[1.0, 2.0], &[0.5, 0.05]).unwrap();
    let refused = NormalRestitution::by_speed(LossCause::Maxwell, table);
    assert_eq!(refused.unwrap_err().field, "normal_restitution");
}

#[test]
fn a_relaxation_longer_than_the_impact_is_refused() {
    let material = Material::from_young(7e9, 0.3).unwrap();
    let ball = Body::sphere(0.01, material, 0.004).unwrap();
    let ball = ball.moving(Motion::new([0.0, 0.0, -1.0], [0.0; 3]).unwrap());
    let loss = NormalRestitution::viscoelastic(1.0).unwrap();
    let collision = Collision::new(ball, Body::plane(material), Friction::NONE).unwrap();
    let error = collision.with_normal_restitution(loss).solve().unwrap_err().to_string();
    assert!(error.contains("relaxation") && error.contains("at most 25 times"), "{error}");
    for wrong in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(NormalRestitution::viscoelastic(wrong).unwrap_err().field, "relaxation");
    }
    assert_eq!(NormalRestitution::viscoelastic(0.0).unwrap(), NormalRestitution::ELASTIC);
}

/// Bodies that do not rebound are the limit of those that hardly do, and friction takes no more than its impulse times the
/// slip before.
#[test]
fn oblong_bodies_that_do_not_rebound_are_the_limit_of_those_that_do() {
    let material = Material::from_young(70e9, 0.3).unwrap();
    let shape = Surface::ellipsoid([0.03, 0.02, 0.015]).unwrap();
    for (f, slip) in [(0.1, 3.0), (0.3, 0.15), (1e-3, 1.0)] {
        let motion = Motion::new([0.6 * slip, 0.8 * slip, -1.0], [0.0; 3]).unwrap();
        let egg = Body::new(shape.clone(), material, shape.solid(0.1).unwrap());
        let egg = egg.moving(motion);
        let friction = Friction::new(f).unwrap();
        let collision = Collision::new(egg, Body::plane(material), friction).unwrap();
        let after = |e: f64| losing(collision.clone(), e);
        let [last, before] = [0.01, 0.02].map(|e| after(e).contact_velocity_after);
        for e in [0.0, 1e-3, 4e-3] {
            let rebound = after(e);
            let limit = last + (last - before) * ((0.01 - e) / 0.01);
            let off = rebound.contact_velocity_after - limit;
            let estimate = rebound.error_estimate * rebound.contact_velocity_before.norm();
            assert!(off.x.hypot(off.y) < 0.01 * f + estimate, "{f} {e}: {off}");
            assert!((rebound.contact_velocity_after.z + e).abs() < 1e-12, "{f} {e}");
            let most = f * rebound.impulse.z.abs() * slip;
            assert!(rebound.energy.dissipated <= 1.001 * most, "{f} {e}: {most} {rebound:?}");
        }
    }
}
