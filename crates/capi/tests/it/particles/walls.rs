//! Grains on walls of any shape, at rest, moving and turning.

use super::*;

const DT: f64 = 1e-6;
const RADIUS: f64 = 0.02;
const STILL: Vector = [0.0; 3];

fn flat(law: u32) -> Made {
    let its = CaromLawOptions { relaxation: 1e-6, ..options(law) };
    Made::new([GLASS, STEEL], 0.3, &its).unwrap()
}

/// A grain of this radius on a wall, pressed without a step.
fn pressed(law: &Made, radius: f64, zeta: f64) -> f64 {
    let one = grain([0.0, 0.0, radius - zeta], STILL, STILL, radius);
    law.touch().load(law, &one, &wall(STILL, STILL, STILL)).unwrap().force[2]
}

fn pair(a: f64, b: f64) -> CaromPair {
    // SAFETY: all zero is a pair that nothing accepts; all pointers are references.
    told(unsafe { zeroed() }, |pair, error| unsafe {
        carom_pair_of_curvatures(&GLASS, &STEEL, a, b, 0.3, 1, 0.0, pair, error)
    })
    .unwrap()
}

fn near(one: f64, two: f64) -> bool {
    (one - two).abs() < 1e-12 * two.abs()
}

/// A grain of radius R in a drum: the gap of Hertz has (1/R - 1/D)/2 along the circumference, 1/2R along the axis.
#[test]
fn constants_of_a_drum_are_those_of_its_gap() {
    let (drum, zeta, slip): (f64, f64, f64) = (0.1, 1e-6, 1e-12);
    let its = options(CAROM_LAW_FIXED_DIRECTION);
    let law = Made::new([GLASS, STEEL], 0.3, &its).unwrap();
    let law = law.curved(RADIUS, [-1.0 / drum, 0.0]).unwrap();
    let pair = pair(0.5 * (1.0 / RADIUS - 1.0 / drum), 0.5 / RADIUS);
    let force = 2.0 / 3.0 * pair.c_z * zeta.powf(1.5);
    // Of a height that rounds the approach to 1e-12.
    assert!(
        (pressed(&law, RADIUS, zeta) / force - 1.0).abs() < 1e-9,
        "{} {force}",
        pressed(&law, RADIUS, zeta)
    );
    let ratio = law.validity([RADIUS, f64::INFINITY], zeta).unwrap().semi_axis_over_radius;
    assert!(near(ratio, (pair.a_squared * zeta).sqrt() / RADIUS), "{ratio} {pair:?}");
    assert!(pair.a_squared > pair.b_squared, "longer along the circumference");
    // In full adhesion dF = c sqrt(zeta) d(shift), along both axes of the wall.
    for (k, stiffness) in [(0, pair.c_x), (1, pair.c_y)] {
        let (mut touch, mut velocity) = (law.touch(), STILL);
        let on = wall(STILL, STILL, [1.0, 0.0, 0.0]);
        let mut place = [0.0, 0.0, RADIUS - zeta];
        touch.step(&law, &grain(place, STILL, STILL, RADIUS), &on, 0.0);
        place[k] += slip;
        velocity[k] = slip / DT;
        touch.step(&law, &grain(place, velocity, STILL, RADIUS), &on, DT);
        // The lead of a velocity goes in two steps.
        touch.step(&law, &grain(place, STILL, STILL, RADIUS), &on, DT);
        let load = touch.step(&law, &grain(place, STILL, STILL, RADIUS), &on, DT);
        let expected = -stiffness * zeta.sqrt() * slip;
        assert!((load.force[k] / expected - 1.0).abs() < 1e-3, "{k}: {load:?} {expected}");
    }
}

/// A ball in a hollow of radius H is a ball of radius 1/(1/R - 1/H) on a plane.
#[test]
fn a_hollow_sphere_makes_a_larger_grain() {
    let (hollow, zeta): (f64, f64) = (0.05, 1e-6);
    for law in LAWS {
        let plane = flat(law);
        let curved = plane.curved(RADIUS, [-1.0 / hollow; 2]).unwrap();
        let by = (1.0 / (1.0 - RADIUS / hollow)).sqrt();
        assert!(near(pressed(&curved, RADIUS, zeta), by * pressed(&plane, RADIUS, zeta)), "{law}");
        // The flat one may go first, and a plane is a wall without curvature.
        let same = plane.curved(RADIUS, [0.0; 2]).unwrap();
        drop(plane);
        assert_eq!(loads(&same, |_| moving(STILL)), loads(&flat(law), |_| moving(STILL)));
    }
}

#[test]
fn a_grain_that_does_not_fit_is_refused() {
    let refused = |radius, curvatures, law| flat(law).curved(radius, curvatures).err().unwrap();
    for (radius, curvatures, law, field) in [
        (RADIUS, [-50.0, 0.0], 1, "curvature_x"),
        (RADIUS, [0.0, -51.0], 1, "curvature_y"),
        (RADIUS, [f64::NAN, 0.0], 1, "curvature_x"),
        (0.0, [0.0, 0.0], 1, "radius"),
        (RADIUS, [-3.0, 0.0], CAROM_LAW_RINGS, "curvature_y"),
    ] {
        let told = refused(radius, curvatures, law);
        assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, field));
    }
}

/// A grain that moves down onto a wall and along it.
fn coming(k: u32) -> CaromGrain {
    let velocity = [0.02, 0.01, -0.05];
    let time = f64::from(k) * DT;
    let place = [0.02 * time, 0.01 * time, RADIUS - 0.05 * time];
    grain(place, velocity, [0.3, -0.2, 0.9], RADIUS)
}

fn moving(velocity: Vector) -> Second {
    wall(velocity, STILL, STILL)
}

fn loads(law: &Made, on: impl Fn(&CaromGrain) -> Second) -> Vec<CaromGrainLoad> {
    let mut touch = law.touch();
    (1..200).map(|k| touch.step(law, &coming(k), &on(&coming(k)), DT)).collect()
}

/// Of any law, with torsion and rolling: forces are those of a sphere without end, which takes no torque here.
#[test]
fn a_wall_is_a_sphere_without_end() {
    let usual = |law| CaromLawOptions { relaxation: 1e-5, ..options(law) };
    let (rolling, torsion) = (CaromRolling { stiffness: 1e5, damping: 0.0, friction: 0.01 }, 1);
    let mut all: Vec<_> = LAWS.map(usual).into();
    all.push(CaromLawOptions { torsion, rolling, ..usual(CAROM_LAW_COULOMB) });
    for its in all {
        let law = Made::new([STEEL, GLASS], 0.15, &its).unwrap();
        let twists = its.law == CAROM_LAW_RINGS || its.torsion == 1;
        let (mut touch, mut other, velocity) = (law.touch(), law.touch(), [0.0, 5e-5, 0.0]);
        let place = [3.0, -2.0, 0.0];
        let Second::Wall(on) = moving(velocity) else { unreachable!() };
        let on = Second::Wall(CaromSurface { place, ..on });
        for t in (1..40).map(f64::from) {
            let place = [1e-4 * t, 0.0, 0.5 - 1e-4 * t];
            let one = grain(place, [1e-4, 0.0, -1e-4], [0.0, 1e-5, 2e-3], 0.5);
            let below = Second::Grain(grain([place[0], 0.0, -1e7], velocity, STILL, 1e7));
            let load = touch.step(&law, &one, &on, 1.0);
            let expected = other.step(&law, &one, &below, 1.0);
            for k in 0..3 {
                let off = (load.force[k] - expected.force[k]).abs();
                assert!(off < 1e-3 * expected.force[2], "{t} {load:?} {expected:?}");
            }
            assert!(load.force[0] < 0.0 && load.force[1] > 0.0 && load.torque_2 == STILL);
            if twists {
                assert!(load.torque_1[2] < 0.0);
                assert!((load.torque_1[2] / expected.torque_1[2] - 1.0).abs() < 0.02, "{its:?}");
            }
            assert_eq!(touch.load(&law, &one, &on).unwrap(), load);
        }
        let CaromReport { sticking, regime } = touch.report(&law);
        assert!(regime != CaromRegime::Separated && (0.0..=1.0).contains(&sticking));
        assert_eq!(law.touch().report(&law).regime, CaromRegime::Separated);
    }
}

/// Grain and wall that turn about the normal together have the forces that they have at rest, turned with them.
#[test]
fn what_turns_together_does_not_slip() {
    let (law, rate) = (flat(CAROM_LAW_COULOMB), 3000.0);
    let (mut touch, mut turning, mut off) = (law.touch(), law.touch(), 0.0_f64);
    let turned = |[x, y, z]: Vector, angle: f64| {
        let (s, c) = angle.sin_cos();
        [c * x - s * y, s * x + c * y, z]
    };
    for k in 1_u32..200 {
        let one = CaromGrain { spin: STILL, ..coming(k) };
        let expected = touch.step(&law, &one, &moving(STILL), DT);
        let (now, middle) = (rate * DT * f64::from(k), rate * DT * (f64::from(k) - 0.5));
        // The wall turns about the origin; seen from there the grain moves as in the case at rest.
        let place = turned(one.place, now);
        let at_middle = turned(plus(one.place, one.velocity, -0.5 * DT), middle);
        let whirl = [-rate * at_middle[1], rate * at_middle[0], 0.0];
        let velocity = plus(turned(one.velocity, middle), whirl, 1.0);
        let spin = [0.0, 0.0, rate];
        let Second::Wall(on) = wall(whirl, spin, STILL) else { unreachable!() };
        let on = Second::Wall(CaromSurface { place: [place[0], place[1], 0.0], ..on });
        let load = turning.step(&law, &grain(place, velocity, spin, RADIUS), &on, DT);
        let expected = turned(expected.force, now);
        if expected[2] > 0.0 {
            let differs = |i: usize| (load.force[i] - expected[i]).abs() / expected[2];
            off = (0..3).map(differs).fold(off, f64::max);
        }
    }
    println!("off by {off:e} of the normal force");
    assert!(off < 3e-4);
}

/// With an axis the shift keeps its components along it, however grain and wall spin about the normal.
#[test]
fn an_ellipse_keeps_the_axes_of_its_wall() {
    let law = flat(CAROM_LAW_COULOMB).curved(RADIUS, [-20.0, 0.0]).unwrap();
    let along = |spin: f64, axis| loads(&law, |_| wall(STILL, [0.0, 0.0, spin], axis));
    let (x, y) = (along(0.0, [1.0, 0.0, 0.0]), along(0.0, [0.0, 1.0, 0.0]));
    assert!(x.iter().zip(&y).skip(100).all(|(x, y)| x.force != y.force), "the ellipse counts");
    assert_eq!(x, along(500.0, [1.0, 0.0, 0.0]));
}

/// The contact lies below the surface of the wall by what the wall is compressed; there a wall that turns moves
/// otherwise than at its surface.
#[test]
fn a_wall_that_turns_moves_at_the_contact() {
    let (law, rate) = (flat(CAROM_LAW_COULOMB), 400.0);
    let compliance = |body: CaromMaterial| (1.0 - body.poisson * body.poisson) / body.young_modulus;
    let share = compliance(STEEL) / (compliance(GLASS) + compliance(STEEL));
    let turning = loads(&law, |_| wall(STILL, [0.0, rate, 0.0], STILL));
    let shifted = loads(&law, |one| {
        // At the middle of the step, to which the velocities belong.
        let place = one.place[2] - 0.5 * DT * one.velocity[2];
        moving([-rate * share * (one.radius - place), 0.0, 0.0])
    });
    for (one, other) in turning.iter().zip(&shifted) {
        let off = (0..3).map(|i| (one.force[i] - other.force[i]).abs()).fold(0.0, f64::max);
        assert!(off <= 1e-9 * other.force[2], "{one:?} {other:?}");
    }
    let still = loads(&law, |_| moving(STILL));
    let (last, other) = (turning.last().unwrap(), still.last().unwrap());
    assert!((last.force[0] - other.force[0]).abs() > 1e-6 * other.force[2], "it counts");
}

/// Friction acts where the bodies touch: at its radius less its share of the approach from each centre, the
/// shares as the compliances (1 - nu^2)/E.
#[test]
fn friction_of_unlike_bodies_has_the_arm_of_each() {
    let law = Made::new([GLASS, STEEL], 0.3, &options(CAROM_LAW_COULOMB)).unwrap();
    let [soft, stiff] =
        [GLASS, STEEL].map(|body| (1.0 - body.poisson * body.poisson) / body.young_modulus);
    let shares = [soft / (soft + stiff), stiff / (soft + stiff)];
    let (radii, zeta): ([f64; 2], f64) = ([1e-3, 3e-3], 2e-5);
    let Second::Wall(on) = moving(STILL) else { unreachable!() };
    let on = CaromSurface { place: [0.0, 0.0, radii[1]], ..on };
    for second in [Second::Grain(grain(STILL, STILL, STILL, radii[1])), Second::Wall(on)] {
        let is_wall = matches!(second, Second::Wall(_));
        // Pressed in one step, then shifted.
        let (mut touch, height) = (law.touch(), radii[0] + radii[1] - zeta);
        let one = |x, velocity| grain([x, 0.0, height], velocity, STILL, radii[0]);
        touch.step(&law, &one(0.0, [0.0, 0.0, -1.0]), &second, 1e-4);
        let load = touch.step(&law, &one(-1e-6, [-1.0, 0.0, 0.0]), &second, 1e-6);
        let radius = if is_wall { radii[0] } else { radii[0] * radii[1] / (radii[0] + radii[1]) };
        let force = 4.0 / 3.0 / (soft + stiff) * radius.sqrt() * zeta.powf(1.5);
        assert!((dot(load.force, load.force).sqrt() / force - 1.0).abs() < 0.01);
        // Body 2 is shifted to the right against body 1; across the normal there is friction alone.
        let tilt = if is_wall { 0.0 } else { -1e-6 / height };
        let pull = load.force[0] - tilt * load.force[2];
        assert!(pull > 1e-3 * force, "{load:?}");
        let arm = radii[0] - shares[0] * zeta;
        assert!((load.torque_1[1] / (-arm * pull) - 1.0).abs() < 1e-5, "{load:?} {arm}");
        let arm = if is_wall { 0.0 } else { radii[1] - shares[1] * zeta };
        assert!((load.torque_2[1] + arm * pull).abs() <= 1e-5 * arm * pull, "{load:?} {arm}");
    }
}
