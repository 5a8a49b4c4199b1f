//! Further reference values: duration of the normal impact, peaks and events of the oblique impact, energies of coupled
//! impacts.

use approx::assert_relative_eq;
use carom_geometry::{Attitude, Surface, angle_matrix};
use carom_halfspace::Material;
use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_impact::scene::{Ball, Limits, Scene, Wall};
use carom_impact::{Body, Collision, Motion, normal};
use carom_laws::friction::Friction;
use nalgebra::Vector3;

use crate::data::{matrix, number, numbers, public, rows, vector};

#[test]
fn duration_of_the_normal_impact() {
    let row = public("normal");
    assert_eq!(normal::DURATION, number(&row, "T_N"));
    assert_relative_eq!(normal::time(0.0), number(&row, "half_T_N"), max_relative = 1e-15);
    let sine = std::f64::consts::PI / normal::DURATION;
    assert_relative_eq!(sine, number(&row, "pi_over_T_N"), max_relative = 1e-15);
}

#[test]
fn peaks_of_the_restitution_of_spheres() {
    for row in rows("Rx_peaks") {
        let kappa = number(&row, "kappa");
        let at = |lambda: f64| {
            ObliqueImpact::new(Groups::new(3.5 / kappa, lambda / kappa).unwrap()).unwrap()
        };
        let (peak, height) = (number(&row, "lambda_peak"), number(&row, "Rx_max"));
        // As exact as the table of general groups.
        assert!((at(peak).restitution() - height).abs() < 5e-10);
        for step in [-1e-3, 1e-3] {
            assert!(at(peak + step).restitution() < height);
        }
        let first = |lambda: f64| at(lambda).phases()[0].regime.name();
        let stick = number(&row, "lambda_stick_start");
        assert_eq!((first(stick * 0.999), first(stick * 1.001)), ("adhesion", "slide+"));
        let gross = number(&row, "lambda_gross_slip");
        assert!(at(gross * 0.999).phases().len() > 1 && at(gross * 1.001).phases().len() == 1);
    }
}

#[test]
fn events_of_the_oblique_impact() {
    for row in rows("histories") {
        let groups = Groups::new(number(&row, "chi"), number(&row, "psi1")).unwrap();
        let impact = ObliqueImpact::new(groups).unwrap();
        assert!((impact.restitution() - number(&row, "Rx")).abs() < 1e-9);
        let mut theirs = Vec::new();
        for event in row["events"].as_array().unwrap() {
            let sign = if event[1].as_f64().unwrap() < 0.0 { "-" } else { "+" };
            let name = match event[0].as_str().unwrap() {
                "adh" => "adhesion".to_owned(),
                name if name.starts_with('E') => continue,
                name => format!("{name}{sign}"),
            };
            theirs.push((name, event[2].as_f64().unwrap(), event[3].as_f64().unwrap()));
        }
        assert_eq!(impact.phases().len(), theirs.len(), "{}", row["label"]);
        for (own, (name, time, w)) in impact.phases().iter().zip(&theirs) {
            assert_eq!(own.regime.name(), name);
            assert!((own.start - w).abs() < 1e-8, "{name} {} {w}", own.start);
            assert!((normal::time(own.start) - time).abs() < 1e-8, "{name} {time}");
        }
    }
}

#[test]
fn times_of_the_phases_in_the_tables() {
    let (mut compared, mut worst) = (0, 0.0_f64);
    for table in ["Rx_table_spheres", "Rx_table_generic"] {
        for row in rows(table).iter().filter(|row| row.get("t_events").is_some()) {
            let groups = Groups::new(number(row, "chi"), number(row, "psi1")).unwrap();
            let impact = ObliqueImpact::new(groups).unwrap();
            let names =
                row["regimes"].as_array().unwrap().iter().map(|name| name.as_str().unwrap());
            let theirs: Vec<f64> = names
                .zip(numbers(&row["t_events"]))
                .filter(|(name, _)| !name.starts_with('E'))
                .map(|(_, time)| time)
                .collect();
            if theirs.len() != impact.phases().len() {
                continue;
            }
            for (own, time) in impact.phases().iter().zip(theirs) {
                worst = worst.max((normal::time(own.start) - time).abs());
                compared += 1;
            }
        }
    }
    assert!(compared > 300 && worst < 1e-10, "{compared} {worst:e}");
}

#[test]
fn the_bounces_under_a_book() {
    // A ball of nu = 0.5 at 45 degrees between rigid planes: kappa = 1.5.
    let data = public("fig3.7");
    for (key, friction) in [("f_0_3_kappa_1_5_45deg", 0.3), ("frictionless", 0.0)] {
        let radius = 0.02;
        let rubber = Material::from_young(20e6, 0.5).unwrap();
        let wall = |height: f64, up: f64| {
            let friction = Friction::new(friction).unwrap();
            Wall::new([0.0, 0.0, height], [0.0, 0.0, up], Material::RIGID, friction).unwrap()
        };
        let scene = Scene::new([0.0; 3]).unwrap().with(wall(0.0, 1.0)).with(wall(0.3, -1.0));
        let thrown = Motion::new([1.0, 0.0, -1.0], [0.0; 3]).unwrap();
        let body = Body::sphere(radius, rubber, 0.05).unwrap().moving(thrown);
        let ball = Ball::new(body.at([0.0, 0.0, 0.1]).unwrap()).unwrap();
        let path = scene.run(&ball, Limits::new(10.0, 3).unwrap()).unwrap();
        let contacts = data[key].as_array().unwrap();
        assert_eq!(path.bounces().len(), contacts.len());
        for (bounce, row) in path.bounces().iter().zip(contacts) {
            assert!((bounce.after.velocity.x - number(row, "v")).abs() < 1e-9, "{key} {row}");
            let spin = bounce.after.spin.y * radius;
            assert!((spin - number(row, "R_omega")).abs() < 1e-9, "{key} {row} {spin}");
            assert_eq!(bounce.wall == 0, row["contact"] == "table");
        }
    }
}

#[test]
fn curvatures_along_the_unturned_axes() {
    // (8.16), corrected: curvatures and twist along x', y' of gamma = 0.
    for row in rows("ellipsoid_frames") {
        let axes: [f64; 3] = numbers(&row["semiaxes"]).try_into().unwrap();
        let number = |key: &str| number(&row, key);
        let point = Vector3::new(number("a"), number("b"), number("c"));
        let local = Surface::ellipsoid(axes).unwrap().local(&point).unwrap();
        let unturned = angle_matrix(number("alpha"), number("beta"), 0.0);
        let (x, y) = (unturned.column(0), unturned.column(1));
        let shape = local.shape_operator();
        assert!((x.dot(&(shape * x)) - number("kpx")).abs() < 1e-14);
        assert!((y.dot(&(shape * y)) - number("kpy")).abs() < 1e-14);
        assert!((x.dot(&(shape * y)) - number("kpxy")).abs() < 1e-14, "{row}");
    }
}

#[test]
fn energies_and_impulses_of_the_reference_ellipsoids() {
    let solutions = public("coupled_spring_solutions");
    for name in ["ellipsoid_planar_coupled", "ellipsoid_upright_2d_stick"] {
        let (case, info) = (&solutions[name], &solutions[name]["info"]);
        let axes: [f64; 3] = numbers(&info["semiaxes"]).try_into().unwrap();
        let egg = Surface::ellipsoid(axes).unwrap();
        let inertia = egg.solid(number(info, "mass")).unwrap();
        for (own, theta) in inertia.moments().iter().zip(numbers(&info["theta"])) {
            assert_relative_eq!(*own, theta, max_relative = 1e-14);
        }
        // Space along the contact axes of the case; body 2 at rest: v = -v_1.
        let pi = matrix(&info["Pi"]);
        let attitude = Attitude::from_matrix(pi).unwrap();
        let velocity = vector(&case["v0"]);
        let steel = Material::from_shear(80e9, 0.3).unwrap();
        let body = Body::new(egg, steel, inertia)
            .turned(attitude)
            .moving(Motion::new((-velocity).into(), [0.0; 3]).unwrap());
        let point = vector(&info["contact_point_body"]);
        let lifted = body.clone().at((-pi.tr_mul(&point)).into()).unwrap();
        let plane = Body::plane(steel);
        let friction = Friction::new(number(case, "f")).unwrap();
        let points = [point.into(), [0.0; 3]];
        let reference = &case["results"]["coulomb"];
        let encounter = Collision::at_own_points(body, plane.clone(), points, friction).unwrap();
        let there = Collision::at(lifted.clone(), plane.clone(), [0.0; 3], friction).unwrap();
        let found = Collision::touching(lifted, plane, friction).unwrap();
        for encounter in [&encounter, &there, &found] {
            assert!(encounter.point().norm() < 1e-12);
            let axes = encounter.frame().axes();
            let own = axes * encounter.mobility().matrix() * axes.transpose();
            let expected = matrix(&case["D"]);
            assert!((own - expected).amax() < 1e-13 * expected.amax(), "{own}");
            let stiffness = encounter.hertz().stiffness();
            let own = [stiffness.c_x, stiffness.c_y, stiffness.c_z];
            for (own, c) in own.iter().zip(numbers(&case["c"])) {
                assert_relative_eq!(*own, c, max_relative = 1e-11);
            }
            let outcome = encounter.solve().unwrap();
            let rebound = outcome.rebound().unwrap();
            let error = rebound.contact_velocity_after - vector(&reference["v_end"]);
            assert!(error.norm() < 1e-5 * velocity.norm(), "{name} {error}");
            assert!(rebound.log.len() > 1, "{:?}", rebound.log);
        }
        let stiffness = encounter.hertz().stiffness();
        for (own, key) in [(stiffness.c_x, "cx"), (stiffness.c_y, "cy"), (stiffness.c_z, "cz")] {
            assert_relative_eq!(own, number(info, key), max_relative = 1e-12);
        }
        let ratio = 1.0 / encounter.hertz().axis_ratio().get();
        assert_relative_eq!(ratio, number(info, "b_over_a"), max_relative = 1e-12);
        let gap = encounter.frame().relative_curvature();
        for (own, k) in [gap.a(), gap.b()].iter().zip(numbers(&info["k"])) {
            assert_relative_eq!(2.0 * own, k, max_relative = 1e-13);
        }
        let outcome = encounter.solve().unwrap();
        let rebound = outcome.rebound().unwrap();
        let before = encounter.mobility().energy(&velocity);
        assert_relative_eq!(before, number(reference, "E0"), max_relative = 1e-13);
        let after = before - rebound.energy.dissipated;
        assert_relative_eq!(after, number(reference, "E_end"), max_relative = 1e-5);
        let heat = number(reference, "dissipated_friction");
        assert_relative_eq!(rebound.energy.dissipated, heat, max_relative = 1e-4);
        let error = (rebound.impulse - vector(&reference["impulse"])).norm();
        assert!(error < 1e-5 * rebound.impulse.norm(), "{name} {error:e}");
    }
}
