//! Each column of the results: its place, its name, its unit, and its field.

use carom_halfspace::Material;
use carom_impact::scene::{Ball, Bounce, Limits, PathPoint, Scene, Wall};
use carom_impact::{
    Body, Collision, HistoryPoint, LogEntry, Motion, Outcome, Rebound, Torsion, Warning,
};
use carom_laws::friction::Friction;
use carom_laws::validity::{Excess, Limit};
use carom_table::{Column, Value};
use nalgebra::Vector3;

/// The columns of a record one by one. No two of the numbers are the same, so that none stands for another.
fn are<R>(columns: &[Column<R>], record: &R, expected: &[(&str, &str, Value)]) {
    assert_eq!(columns.len(), expected.len());
    let mut numbers: Vec<f64> = Vec::new();
    for (column, (name, unit, value)) in columns.iter().zip(expected) {
        assert_eq!((column.name(), column.unit()), (*name, *unit));
        assert_eq!(column.value(record), *value, "{name}");
        match value {
            Value::Number(number) => numbers.push(*number),
            Value::Vector(parts) => numbers.extend(parts),
            _ => {}
        }
    }
    for (i, number) in numbers.iter().enumerate() {
        assert!(!numbers[..i].contains(number), "{number} stands twice");
    }
}

fn vector(v: Vector3<f64>) -> Value {
    Value::Vector(v.into())
}

/// An ellipsoid with spin on a ball: no two numbers are alike.
fn collision() -> Collision {
    let [one, two] =
        [(70e9, 0.22), (208e9, 0.3)].map(|(e, nu)| Material::from_young(e, nu).unwrap());
    let shape = carom_geometry::Surface::ellipsoid([0.03, 0.02, 0.015]).unwrap();
    let inertia = shape.solid(0.1).unwrap();
    let motion = Motion::new([0.6, 0.4, -2.0], [6.0, -11.0, 20.0]).unwrap();
    let pebble = Body::new(shape, one, inertia).moving(motion);
    let ball = Body::sphere(0.05, two, 0.4)
        .unwrap()
        .at([0.4, 0.5, 0.7])
        .unwrap()
        .moving(Motion::new([-0.2, 0.1, 0.3], [3.0, 1.0, -4.0]).unwrap());
    Collision::along(pebble, ball, [0.3, 0.5, 0.8], Friction::new(0.2).unwrap()).unwrap()
}

#[test]
fn columns_of_a_rebound_show_its_fields() {
    let collision = collision();
    let Outcome::Rebound(mut rebound) = collision.solve().unwrap() else { panic!("a rebound") };
    // Of elastic bodies; a number of its own shows where it stands.
    rebound.energy.lost = 0.123;
    rebound.r_x = Some(0.456);
    rebound.model_uncertainty = 0.0789;
    rebound.validity.pressure_over_yield = 0.654;
    let r: &mut Rebound = &mut rebound;
    let regimes: Vec<&'static str> = r.log.iter().map(|entry| entry.regime.name()).collect();
    r.warnings = vec![
        Warning::PointSampled,
        Warning::Exceeds(Excess { limit: Limit::LargeContact, value: 0.25 }),
    ];
    r.compressions = 7;
    let outcome = Outcome::Rebound(Box::new(r.clone()));
    // Body 1 lies on the side to which the normal points.
    let normal = Vector3::new(0.3, 0.5, 0.8).normalize();
    let angle = |velocity: Vector3<f64>, away: Vector3<f64>| {
        velocity.cross(&away).norm().atan2(velocity.dot(&away)).to_degrees()
    };
    let [one, two] = r.motions.map(|motion| motion.velocity);
    let near = |index: usize, value: f64| {
        let Value::Number(found) = Rebound::COLUMNS[index].value(r) else { panic!("a number") };
        assert!((found - value).abs() < 1e-12 * value, "{found} {value}");
        Value::Number(found)
    };
    let expected = [
        ("outcome", "", "rebound".into()),
        ("R_x", "", Value::Number(0.456)),
        ("body_1_velocity", "m/s", vector(r.motions[0].velocity)),
        ("body_1_spin", "rad/s", vector(r.motions[0].spin)),
        ("body_2_velocity", "m/s", vector(r.motions[1].velocity)),
        ("body_2_spin", "rad/s", vector(r.motions[1].spin)),
        ("body_1_speed", "m/s", near(6, one.norm())),
        ("body_1_angle", "deg", near(7, angle(one, normal))),
        ("body_2_speed", "m/s", near(8, two.norm())),
        ("body_2_angle", "deg", near(9, angle(two, -normal))),
        ("impulse", "N s", vector(r.impulse)),
        ("contact_velocity_before", "m/s", vector(r.contact_velocity_before)),
        ("contact_velocity_after", "m/s", vector(r.contact_velocity_after)),
        ("duration", "s", Value::Number(r.duration)),
        ("maximal_force", "N", Value::Number(r.maximal_force)),
        ("maximal_approach", "m", Value::Number(r.maximal_approach)),
        ("maximal_semi_axis_a", "m", Value::Number(r.maximal_contact.semi_axis_a())),
        ("maximal_semi_axis_b", "m", Value::Number(r.maximal_contact.semi_axis_b())),
        ("peak_pressure", "Pa", Value::Number(r.peak_pressure)),
        ("pressure_over_yield", "", Value::Number(0.654)),
        ("energy_before", "J", Value::Number(r.energy.before)),
        ("energy_after", "J", Value::Number(r.energy.after)),
        ("energy_dissipated", "J", Value::Number(r.energy.dissipated)),
        ("energy_lost", "J", Value::Number(0.123)),
        ("regimes", "", Value::Words(regimes)),
        ("friction", "", r.friction.coefficient().into()),
        ("method", "", "spatial".into()),
        ("compressions", "", Value::Count(7)),
        ("error_estimate", "", Value::Number(r.error_estimate)),
        ("model_uncertainty", "", Value::Number(0.0789)),
        ("warnings", "", Value::Texts(r.warnings.iter().map(ToString::to_string).collect())),
    ];
    are(Rebound::COLUMNS, r, &expected);
    are(Outcome::COLUMNS, &outcome, &expected);
    r.r_x = None;
    assert_eq!(Rebound::COLUMNS[1].value(r), Value::Undefined);
    // Without a yield stress, and at rest.
    r.validity.pressure_over_yield = 0.0;
    r.motions[1].velocity = Vector3::zeros();
    assert_eq!(Rebound::COLUMNS[19].value(r), Value::Absent);
    assert_eq!(Rebound::COLUMNS[9].value(r), Value::Absent);
    let [motion, _] = rebound.motions;
    are(
        Motion::COLUMNS,
        &motion,
        &[("velocity", "m/s", vector(motion.velocity)), ("spin", "rad/s", vector(motion.spin))],
    );
    let c = &collision;
    let frame = c.frame();
    are(
        Collision::COLUMNS,
        c,
        &[
            ("point", "m", vector(c.point())),
            ("x_axis", "", vector(frame.x())),
            ("y_axis", "", vector(frame.y())),
            ("z_axis", "", vector(frame.z())),
            ("curvature_a", "1/m", Value::Number(c.hertz().curvature().a())),
            ("curvature_b", "1/m", Value::Number(c.hertz().curvature().b())),
            ("axis_ratio", "", Value::Number(c.hertz().axis_ratio().get())),
            ("centre_1", "m", vector(c.bodies()[0].placed().centre())),
            ("centre_2", "m", vector(c.bodies()[1].placed().centre())),
        ],
    );
}

#[test]
fn bodies_that_do_not_meet_have_their_motions_alone() {
    let moving = |z| Motion::new([0.1, 0.2, z], [1.0, 2.0, 3.0]).unwrap();
    let steel = Material::from_young(208e9, 0.3).unwrap();
    let ball = |z| Body::sphere(0.01, steel, 0.03).unwrap().moving(moving(z));
    let outcome = Collision::new(ball(1.0), ball(-0.5), Friction::new(0.2).unwrap()).unwrap();
    let outcome = outcome.solve().unwrap();
    for column in Outcome::COLUMNS {
        let expected = match column.name() {
            "outcome" => "no_impact".into(),
            "body_1_velocity" => vector(moving(1.0).velocity),
            "body_2_velocity" => vector(moving(-0.5).velocity),
            "body_1_spin" | "body_2_spin" => vector(moving(1.0).spin),
            _ => Value::Absent,
        };
        assert_eq!(column.value(&outcome), expected, "{}", column.name());
    }
}

#[test]
fn columns_of_a_course_show_its_fields() {
    let history = collision().history(9).unwrap();
    let p = HistoryPoint { stick_radius: Some(0.789), ..history[4] };
    are(
        HistoryPoint::COLUMNS,
        &p,
        &[
            ("time", "s", Value::Number(p.time)),
            ("xi", "m", Value::Number(p.shift.x)),
            ("eta", "m", Value::Number(p.shift.y)),
            ("zeta", "m", Value::Number(p.shift.z)),
            ("v", "m/s", vector(p.velocity)),
            ("F", "N", vector(p.force)),
            ("semi_axis_a", "m", Value::Number(p.semi_axes[0])),
            ("semi_axis_b", "m", Value::Number(p.semi_axes[1])),
            ("stick_radius", "m", Value::Number(0.789)),
            ("regime", "", p.regime.name().into()),
            ("normal", "", vector(p.normal)),
        ],
    );
    let torsion =
        Torsion { spin_ratio: 0.5, torque_impulse: 0.25, dissipated: 0.125, error_estimate: 1e-3 };
    are(
        Torsion::COLUMNS,
        &torsion,
        &[
            ("spin_ratio", "", Value::Number(0.5)),
            ("torque_impulse", "N m s", Value::Number(0.25)),
            ("energy_dissipated", "J", Value::Number(0.125)),
            ("error_estimate", "", Value::Number(1e-3)),
        ],
    );
    let heads: Vec<_> = LogEntry::COLUMNS.iter().map(|c| (c.name(), c.unit())).collect();
    assert_eq!(heads, [("time", "s"), ("event", ""), ("regime", "")]);
}

#[test]
fn columns_of_a_scene_show_its_fields() {
    let rubber = Material::from_young(20e6, 0.5).unwrap();
    let body = Body::sphere(0.02, rubber, 0.04).unwrap().at([0.1, 0.2, 0.5]).unwrap();
    let motion = Motion::new([0.7, -0.4, -1.0], [10.0, 20.0, -5.0]).unwrap();
    let ball = Ball::new(body.moving(motion)).unwrap();
    let normal = [0.1, 0.2, 0.97];
    let floor = Wall::new([0.0; 3], normal, Material::RIGID, Friction::new(0.3).unwrap()).unwrap();
    let scene = Scene::new([0.1, 0.0, -9.81]).unwrap().with(floor);
    let path = scene.run(&ball, Limits::new(10.0, 2).unwrap()).unwrap();
    let b = &path.bounces()[0];
    let heads: Vec<_> = Bounce::COLUMNS.iter().map(|c| (c.name(), c.unit())).collect();
    let values: Vec<Value> = Bounce::COLUMNS.iter().map(|c| c.value(b)).collect();
    assert_eq!(
        heads,
        [
            ("time", "s"),
            ("position", "m"),
            ("velocity_before", "m/s"),
            ("spin_before", "rad/s"),
            ("velocity", "m/s"),
            ("spin", "rad/s"),
        ]
    );
    assert_eq!(
        values,
        [
            Value::Number(b.time),
            vector(b.position),
            vector(b.before.velocity),
            vector(b.before.spin),
            vector(b.after.velocity),
            vector(b.after.spin),
        ]
    );
    let p = path.last();
    are(
        PathPoint::COLUMNS,
        &p,
        &[
            ("time", "s", Value::Number(p.time)),
            ("position", "m", vector(p.position)),
            ("velocity", "m/s", vector(p.motion.velocity)),
            ("spin", "rad/s", vector(p.motion.spin)),
        ],
    );
    // Between the bounces: a parabola of the acceleration given, the velocity its slope.
    let points = path.points(5).unwrap();
    for flight in points.chunks(5) {
        let (start, end) = (flight[0], flight[4]);
        for point in flight {
            let t = point.time - start.time;
            let g = Vector3::new(0.1, 0.0, -9.81);
            let velocity = start.motion.velocity + t * g;
            let way = t * start.motion.velocity + 0.5 * t * t * g;
            assert!((point.motion.velocity - velocity).norm() < 1e-12);
            assert!((point.position - start.position - way).norm() < 1e-12);
            assert_eq!(point.motion.spin, end.motion.spin);
        }
    }
    // The bounce: momentum, and the angular momentum about the place where they touch.
    let arm = -0.02 * b.normal;
    let impulse = 0.04 * (b.after.velocity - b.before.velocity);
    let turn = 0.4 * 0.04 * 4e-4 * (b.after.spin - b.before.spin);
    assert!((impulse - b.rebound.impulse).norm() < 1e-14);
    // With the torque about the normal on the spin that it has.
    let torque = b.rebound.torsion.unwrap().torque_impulse * b.normal;
    assert!(torque.norm() > 1e-8);
    assert!((turn - arm.cross(&impulse) - torque).norm() < 1e-14);
}
