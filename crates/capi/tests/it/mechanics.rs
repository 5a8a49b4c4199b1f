//! Every number of an impact and of a pair, compared with mechanics and Hertz's closed forms.

use std::mem::zeroed;
use std::ptr::null_mut;

use crate::particles::{GLASS, STEEL, Vector, collided, cross, dot, plus, told};
use carom_capi::*;

fn close(a: Vector, b: Vector, size: f64) {
    let off = plus(a, b, -1.0);
    assert!(dot(off, off).sqrt() < 1e-11 * size, "{a:?} {b:?}");
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-11 * a.abs().max(b.abs()), "{a} {b}");
}

fn sphere(radius: f64, mass: f64, material: CaromMaterial) -> CaromBody {
    CaromBody {
        shape: CAROM_SHAPE_SPHERE,
        hollow: 0,
        sizes: [radius, 0.0, 0.0],
        mass,
        moments: [0.0; 3],
        material,
        centre: [0.0; 3],
        attitude: [0.0; 4],
        velocity: [0.0; 3],
        spin: [0.0; 3],
    }
}

fn collide(one: &CaromBody, two: &CaromBody, friction: f64) -> CaromRebound {
    collided([one, two], friction, None, None).unwrap()
}

/// Two spheres that meet anywhere, turning, and the direction of their centres.
fn pair(material: CaromMaterial) -> ([CaromBody; 2], Vector) {
    let one = CaromBody {
        centre: [0.3, -0.1, 0.2],
        velocity: [0.2, 0.9, -2.0],
        spin: [40.0, -15.0, 20.0],
        ..sphere(0.01, 0.03, STEEL)
    };
    let direction = [0.36, 0.48, 0.8];
    let two = CaromBody {
        centre: plus(one.centre, direction, -0.03),
        velocity: [-0.4, 0.1, 0.7],
        spin: [-10.0, 25.0, 5.0],
        ..sphere(0.02, 0.08, material)
    };
    ([one, two], direction)
}

/// The angular momentum of a body about its centre, by its moments about axes turned by a quaternion.
fn angular(attitude: [f64; 4], moments: Vector, spin: Vector) -> Vector {
    let [w, i, j, k] = attitude;
    let axes = [
        [w * w + i * i - j * j - k * k, 2.0 * (i * j + w * k), 2.0 * (i * k - w * j)],
        [2.0 * (i * j - w * k), w * w - i * i + j * j - k * k, 2.0 * (j * k + w * i)],
        [2.0 * (i * k + w * j), 2.0 * (j * k - w * i), w * w - i * i - j * j + k * k],
    ];
    axes.iter()
        .zip(moments)
        .fold([0.0; 3], |sum, (axis, moment)| plus(sum, *axis, moment * dot(*axis, spin)))
}

/// Velocities and spins afterwards.
fn motions(rebound: &CaromRebound) -> [(Vector, Vector); 2] {
    [(rebound.body_1_velocity, rebound.body_1_spin), (rebound.body_2_velocity, rebound.body_2_spin)]
}

/// Momentum, angular momentum, energy and velocities of the contact: what an impact of any bodies obeys.
fn obeys(bodies: [&CaromBody; 2], moments: [Vector; 2], rebound: &CaromRebound) {
    let attitude = |body: &CaromBody| match body.attitude == [0.0; 4] {
        true => [1.0, 0.0, 0.0, 0.0],
        false => body.attitude,
    };
    let mut energies = [0.0; 2];
    let mut points = [[0.0; 3]; 2];
    let mut torques = 0.0;
    let speed = dot(bodies[0].velocity, bodies[0].velocity).sqrt();
    let after = motions(rebound);
    for (k, body) in bodies.into_iter().enumerate() {
        let sign = [1.0, -1.0][k];
        let arm = plus(rebound.point, body.centre, -1.0);
        let change = plus(after[k].0, body.velocity, -1.0).map(|v| body.mass * v);
        close(change, rebound.impulse.map(|p| sign * p), body.mass * speed);
        let angular = |spin| angular(attitude(body), moments[k], spin);
        let change = plus(angular(after[k].1), angular(body.spin), -1.0);
        let size = body.mass * speed * dot(arm, arm).sqrt();
        // Friction on the spin about the normal adds a torque along it, opposite ones to the bodies.
        let beyond = plus(change, cross(arm, rebound.impulse), -sign);
        let torque = dot(beyond, rebound.normal);
        close(beyond, rebound.normal.map(|n| torque * n), 10.0 * size);
        torques += torque;
        let of = [(body.velocity, body.spin), (after[k].0, after[k].1)];
        for (i, (velocity, spin)) in of.into_iter().enumerate() {
            energies[i] +=
                0.5 * body.mass * dot(velocity, velocity) + 0.5 * dot(spin, angular(spin));
            points[i] = plus(points[i], plus(velocity, cross(spin, arm), 1.0), -sign);
        }
    }
    let arm = plus(rebound.point, bodies[0].centre, -1.0);
    assert!(torques.abs() < 1e-10 * bodies[0].mass * speed * dot(arm, arm).sqrt(), "{torques}");
    near(rebound.energy_before, energies[0]);
    near(rebound.energy_after, energies[1]);
    near(rebound.energy_dissipated + rebound.energy_lost, energies[0] - energies[1]);
    assert!(rebound.energy_dissipated > 1e-3 * energies[0], "{rebound:?}");
    close(rebound.contact_velocity_before, points[0], 10.0 * speed);
    close(rebound.contact_velocity_after, points[1], 10.0 * speed);
    near(dot(rebound.normal, rebound.normal), 1.0);
    let along = |v: Vector| plus(v, rebound.normal, -dot(v, rebound.normal));
    let [before, after] = points.map(along);
    assert_eq!(rebound.has_R_x, 1);
    near(rebound.R_x, -dot(after, before) / dot(before, before));
}

#[test]
fn two_spheres_obey_mechanics_and_hertz() {
    let ([one, two], direction) = pair(STEEL);
    let moments = [[0.4 * 0.03 * 1e-4; 3], [0.4 * 0.08 * 4e-4; 3]];
    let exact = CaromCollideOptions { law: CAROM_IMPACT_COULOMB, ..CaromCollideOptions::default() };
    let rebound = collided([&one, &two], 0.2, None, Some(exact)).unwrap();
    assert_eq!((rebound.collides, rebound.compressions), (1, 1));
    close(rebound.normal, direction, 1.0);
    close(rebound.point, plus(one.centre, direction, -0.01), 1.0);
    obeys([&one, &two], moments, &rebound);
    let [before, after] = [rebound.contact_velocity_before, rebound.contact_velocity_after];
    near(dot(before, direction), -dot(after, direction));
    // Hertz: F = (4/3) E* sqrt(R) zeta^1.5, the energy (2/5) F zeta, the time 2.943 zeta/v, a^2 = R zeta.
    let modulus = 0.5 / ((1.0 - 0.09) / 208e9);
    let radius: f64 = 0.01 * 0.02 / 0.03;
    let speed = dot(rebound.contact_velocity_before, direction);
    let mass = 0.03 * 0.08 / 0.11;
    let zeta = (15.0 / 16.0 * mass * speed * speed / (modulus * radius.sqrt())).powf(0.4);
    near(rebound.maximal_approach, zeta);
    near(rebound.maximal_force, 4.0 / 3.0 * modulus * radius.sqrt() * zeta.powf(1.5));
    let duration = 2.943_275_121_313_367 * zeta / speed;
    assert!((rebound.duration / duration - 1.0).abs() < 1e-5, "{} {duration}", rebound.duration);
    for axis in [rebound.maximal_semi_axis_a, rebound.maximal_semi_axis_b] {
        near(axis, (radius * zeta).sqrt());
    }
    assert_eq!(rebound.energy_lost, 0.0);
    // What the spin about the normal, which this law leaves alone, does to the shift is not known.
    assert!(rebound.error_estimate > 0.0 && rebound.error_estimate < 0.1);
    assert_eq!(rebound.warnings & CAROM_WARNING_COUPLING, 0);
    assert_eq!(rebound.warnings & CAROM_WARNING_SPIN_LEFT_ALONE, CAROM_WARNING_SPIN_LEFT_ALONE);
    // The exchanged bodies do the same to each other, seen the other way.
    let other = collided([&two, &one], 0.2, None, Some(exact)).unwrap();
    for k in 0..2 {
        close(motions(&other)[k].0, motions(&rebound)[1 - k].0, 1.0);
        close(motions(&other)[k].1, motions(&rebound)[1 - k].1, 100.0);
    }
    close(other.impulse, rebound.impulse.map(|p| -p), 0.1);
    close(other.normal, direction.map(|n| -n), 1.0);
}

#[test]
fn dissimilar_spheres_obey_mechanics_with_coupling_and_spin() {
    let ([one, two], direction) = pair(GLASS);
    let moments = [[0.4 * 0.03 * 1e-4; 3], [0.4 * 0.08 * 4e-4; 3]];
    let rebound = collide(&one, &two, 0.2);
    obeys([&one, &two], moments, &rebound);
    assert_eq!(rebound.warnings & (CAROM_WARNING_COUPLING | CAROM_WARNING_SPIN_LEFT_ALONE), 0);
    assert!(rebound.error_estimate > 0.0 && rebound.error_estimate < 1e-2, "{rebound:?}");
    // Friction has taken a little of the relative spin about the normal: it acts on the slip first of all.
    let about = |one: Vector, two: Vector| dot(plus(one, two, -1.0), direction);
    let [before, after] =
        [about(one.spin, two.spin), about(rebound.body_1_spin, rebound.body_2_spin)];
    assert!(after / before < 0.9999 && after / before > 0.99, "{before} {after}");
    // Nearly along the normal coupling throws the bodies back.
    let near = |material| {
        let velocity = plus([0.1, 0.0, 0.0], direction, -2.0);
        let one = CaromBody { velocity, spin: [0.0; 3], ..one };
        let two = CaromBody { velocity: [0.0; 3], spin: [0.0; 3], material, ..two };
        collide(&one, &two, 0.1).R_x
    };
    assert!(near(GLASS) > near(STEEL) + 0.1, "{} {}", near(GLASS), near(STEEL));
}

#[test]
fn bodies_of_three_axes_obey_mechanics() {
    // Turned by 40 degrees about (1, 2, 2)/3.
    let (sine, cosine) = 20.0_f64.to_radians().sin_cos();
    let attitude = [cosine, sine / 3.0, 2.0 * sine / 3.0, 2.0 * sine / 3.0];
    let one = CaromBody {
        shape: CAROM_SHAPE_ELLIPSOID,
        sizes: [0.03, 0.02, 0.015],
        attitude,
        velocity: [0.6, 0.4, -2.0],
        spin: [6.0, -11.0, 20.0],
        ..sphere(0.0, 0.1, GLASS)
    };
    let two = CaromBody {
        velocity: [-0.2, 0.1, 0.3],
        spin: [3.0, 1.0, -4.0],
        ..sphere(0.05, 0.4, GLASS)
    };
    let solid = |a: f64, b: f64| 0.2 * 0.1 * (a * a + b * b);
    let own = [solid(0.02, 0.015), solid(0.03, 0.015), solid(0.03, 0.02)];
    let ball = [[0.4 * 0.4 * 0.0025; 3], [2.0 / 3.0 * 0.4 * 0.0025; 3]];
    let normal = [0.0, 0.6, 0.8];
    for (hollow, given) in [(0, [0.0; 3]), (1, [0.0; 3]), (0, [3e-5, 2e-5, 4e-5])] {
        let two = CaromBody { hollow, ..two };
        let one = CaromBody { moments: given, ..one };
        let moments = if given == [0.0; 3] { own } else { given };
        let rebound = collided([&one, &two], 0.25, Some(&normal), None).unwrap();
        close(rebound.normal, normal, 1.0);
        // Body 1 was put on body 2: its centre is that of its support along the normal.
        let axes = [0, 1, 2].map(|k| {
            let mut unit = [0.0; 3];
            unit[k] = 1.0;
            angular(attitude, unit, normal)
        });
        let semi = one.sizes;
        let square: f64 = (0..3).map(|k| semi[k] * semi[k] * dot(axes[k], axes[k])).sum();
        let below =
            (0..3).fold([0.0; 3], |sum, k| plus(sum, axes[k], -semi[k] * semi[k] / square.sqrt()));
        close(rebound.point, normal.map(|n| 0.05 * n), 1.0);
        let one = CaromBody { centre: plus(rebound.point, below, -1.0), ..one };
        obeys([&one, &two], [moments, ball[hollow as usize]], &rebound);
        assert!(
            rebound.maximal_semi_axis_a < rebound.maximal_semi_axis_b,
            "a lies along the larger curvature"
        );
        assert!(rebound.error_estimate > 0.0);
    }
}

/// Of equal bodies: `c_z = 2 E* sqrt(R)`, `c_x = c_z/kappa`, `a^2 = R zeta`.
#[test]
fn the_constants_of_a_pair_are_those_of_hertz_and_mindlin() {
    // SAFETY: all zero is a pair that nothing accepts; all pointers are references.
    let made = told(unsafe { zeroed() }, |pair, error| unsafe {
        let law = CAROM_LAW_FIXED_DIRECTION;
        carom_pair_of_spheres(&GLASS, &GLASS, 0.01, 0.03, 0.35, law, 1e-3, pair, error)
    });
    let pair: CaromPair = made.unwrap();
    let (nu, radius) = (0.22, 0.0075_f64);
    let modulus = 70e9 / (2.0 * (1.0 - nu * nu));
    near(pair.c_z, 2.0 * modulus * radius.sqrt());
    let kappa = (2.0 - nu) / (2.0 * (1.0 - nu));
    near(pair.c_x, pair.c_z / kappa);
    near(pair.c_y, pair.c_x);
    near(pair.a_squared, radius);
    near(pair.b_squared, radius);
    assert_eq!((pair.friction, pair.law, pair.tolerance), (0.35, CAROM_LAW_FIXED_DIRECTION, 1e-3));
}

#[test]
fn the_axes_of_an_elliptic_pair_are_not_exchanged() {
    let of = |a: f64, b: f64| {
        // SAFETY: all zero is a pair that nothing accepts; all pointers are references.
        let made = told(unsafe { zeroed() }, |pair, error| unsafe {
            carom_pair_of_curvatures(&GLASS, &STEEL, a, b, 0.3, CAROM_LAW_COULOMB, 0.0, pair, error)
        });
        let pair: CaromPair = made.unwrap();
        pair
    };
    let (round, slender) = (of(50.0, 50.0), of(50.0, 5.0));
    // A lies along x: there the contact is short. Along its length it is the stiffer the more nu counts:
    // a long contact gives way less to a force along it.
    assert!(slender.a_squared < slender.b_squared && slender.c_x != slender.c_y);
    near(round.c_x, round.c_y);
    // Hertz: a^2 A/zeta and b^2 B/zeta are functions of the ratio a/b alone, of which b > a is the greater.
    assert!(slender.b_squared > 3.0 * round.b_squared && slender.a_squared < 2.0 * round.a_squared);
}

/// Many pairs at once, each with its own numbers wherever they lie; in sliding R_x = -1 + 7/lambda.
#[test]
fn many_restitutions_are_each_of_their_own_pair() {
    let pairs: [[f64; 2]; 4] = [[1.0, 20.0], [1.2, 70.0], [1.4, 35.0], [0.9, 140.0]];
    let stride = size_of::<[f64; 2]>();
    for method in [CAROM_BY_TABLE, CAROM_EXACT] {
        let mut places = [[f64::NAN; 3]; 4];
        // SAFETY: the strides are those of the arrays.
        let status = unsafe {
            let (kappa, lambda) = (&raw const pairs[0][0], &raw const pairs[0][1]);
            let first = &raw mut places[0][1];
            let each = size_of::<[f64; 3]>();
            let error = null_mut();
            carom_restitution_many(
                4, kappa, stride, lambda, stride, 1.0, method, first, each, error,
            )
        };
        assert_eq!(status, CaromStatus::Ok);
        for (place, [_, lambda]) in places.iter().zip(pairs) {
            assert!((place[1] - (-1.0 + 7.0 / lambda)).abs() < 1e-8, "{place:?}");
            assert!(place[0].is_nan() && place[2].is_nan());
        }
        // Where rings slip, kappa counts too: each answer is that of its pair alone.
        let (kappas, lambdas) = ([1.0, 1.2, 1.4], [2.0, 1.0, 3.0]);
        let mut many = [0.0; 3];
        // SAFETY: as above.
        unsafe {
            let (k, l, to) = (kappas.as_ptr(), lambdas.as_ptr(), many.as_mut_ptr());
            carom_restitution_many(3, k, 8, l, 8, 0.8, method, to, 8, null_mut());
        }
        for ((kappa, lambda), own) in kappas.into_iter().zip(lambdas).zip(many) {
            let mut one = 0.0;
            // SAFETY: all pointers are references.
            unsafe { carom_restitution(kappa, lambda, 0.8, method, &mut one, null_mut()) };
            assert_eq!(one, own);
        }
        assert!(many[0] != many[1] && many[1] != many[2]);
    }
}

/// The first pair without an answer is named by its place; those before it are written.
#[test]
fn an_error_of_many_restitutions_names_its_pair() {
    let (kappas, lambdas) = ([1.0, 1.2, 3.0, 1.4], [20.0, 35.0, 2.0, 70.0]);
    for method in [CAROM_BY_TABLE, CAROM_EXACT] {
        let mut many = [7.0; 4];
        // SAFETY: plain numbers.
        let mut error: CaromError = unsafe { zeroed() };
        // SAFETY: the strides are those of the arrays.
        let status = unsafe {
            let (k, l, to) = (kappas.as_ptr(), lambdas.as_ptr(), many.as_mut_ptr());
            carom_restitution_many(4, k, 8, l, 8, 1.0, method, to, 8, &mut error)
        };
        assert_eq!((status, error.index, error.value), (CaromStatus::OutOfRange, 2, 3.0));
        near(many[0], -1.0 + 7.0 / 20.0);
        near(many[1], -1.0 + 7.0 / 35.0);
        assert_eq!(many[2..], [7.0; 2]);
    }
}
