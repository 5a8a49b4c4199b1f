//! Walls of any shape through the C interface.

use std::mem::{MaybeUninit, zeroed};
use std::ptr::null_mut;

use carom_capi::*;

const GLASS: CaromMaterial =
    CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
const STEEL: CaromMaterial =
    CaromMaterial { young_modulus: 208e9, poisson: 0.3, yield_stress: 0.0 };

fn flat(law: u32) -> CaromGrains {
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let mut grains = zeroed();
        let to = &raw mut grains;
        let status = carom_grains_of(&GLASS, &STEEL, 0.3, law, 0.0, 1e-6, to, null_mut());
        assert_eq!(status, CaromStatus::Ok);
        grains
    }
}

fn curved(radius: f64, [x, y]: [f64; 2], law: u32) -> Result<CaromGrains, (CaromStatus, String)> {
    // SAFETY: plain numbers; all pointers are references.
    unsafe {
        let (mut grains, mut error) = (zeroed(), zeroed::<CaromError>());
        let status = carom_grains_on_curved_wall(
            &GLASS,
            &STEEL,
            radius,
            x,
            y,
            0.3,
            law,
            0.0,
            1e-6,
            &mut grains,
            &mut error,
        );
        let field = error.field.iter().take_while(|b| **b != 0).map(|b| *b as u8 as char);
        if status == CaromStatus::Ok { Ok(grains) } else { Err((status, field.collect())) }
    }
}

/// The constants of a pair of these gaps, scaled to a grain of radius 1.
fn pair(a: f64, b: f64) -> CaromPair {
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let mut pair = zeroed();
        let to = &raw mut pair;
        let status = carom_pair_of_curvatures(&GLASS, &STEEL, a, b, 0.3, 1, 0.0, to, null_mut());
        assert_eq!(status, CaromStatus::Ok);
        pair
    }
}

fn near(one: f64, two: f64) -> bool {
    (one - two).abs() < 1e-12 * two.abs()
}

/// A grain of radius R in a drum: the gap of Hertz has (1/R - 1/D)/2 along the circumference, 1/2R along the axis.
/// Stiffness grows as the root of the length.
#[test]
fn constants_of_a_drum_are_those_of_its_gap() {
    let (radius, drum): (f64, f64) = (0.02, 0.1);
    let grains = curved(radius, [-1.0 / drum, 0.0], 1).unwrap();
    let pair = pair(0.5 * (1.0 / radius - 1.0 / drum), 0.5 / radius);
    let by = radius.sqrt();
    assert!(near(by * grains.unit.c_x, pair.c_x) && near(by * grains.unit.c_y, pair.c_y));
    assert!(near(by * grains.unit.c_z, pair.c_z));
    assert!(near(radius * grains.unit.a_squared, pair.a_squared));
    assert!(near(radius * grains.unit.b_squared, pair.b_squared));
    assert!(near(radius * by * grains.unit.torsion_stiffness, pair.torsion_stiffness));
    assert!(pair.a_squared > pair.b_squared, "longer along the circumference");
}

/// A ball in a hollow of radius H is a ball of radius 1/(1/R - 1/H) on a plane.
#[test]
fn a_hollow_sphere_makes_a_larger_grain() {
    let (radius, hollow): (f64, f64) = (0.02, 0.05);
    for law in [CAROM_LAW_COULOMB, CAROM_LAW_RINGS] {
        let grains = curved(radius, [-1.0 / hollow; 2], law).unwrap();
        let by = (1.0 / (1.0 - radius / hollow)).sqrt();
        let plane = flat(law);
        assert!(near(grains.unit.c_z, by * plane.unit.c_z));
        assert!(near(grains.unit.c_x, by * plane.unit.c_x));
        assert_eq!(grains.share_1, plane.share_1);
        assert_eq!(grains.unit.gamma, plane.unit.gamma);
    }
    let plane = curved(radius, [0.0; 2], 1).unwrap();
    assert_eq!(plane, flat(1));
}

#[test]
fn a_grain_that_does_not_fit_is_refused() {
    let told = |radius, curvatures, law| curved(radius, curvatures, law).unwrap_err();
    let range = |field: &str| (CaromStatus::OutOfRange, field.to_owned());
    assert_eq!(told(0.02, [-50.0, 0.0], 1), range("curvature_x"));
    assert_eq!(told(0.02, [0.0, -51.0], 1), range("curvature_y"));
    assert_eq!(told(0.02, [f64::NAN, 0.0], 1), range("curvature_x"));
    assert_eq!(told(0.0, [0.0, 0.0], 1), range("radius"));
    assert_eq!(told(0.02, [-3.0, 0.0], CAROM_LAW_RINGS), range("curvature_y"));
}

fn touch() -> CaromTouch {
    CaromTouch { mark: 0, words: [MaybeUninit::new(0); CAROM_TOUCH_WORDS] }
}

/// A grain that moves down onto a wall and along it.
fn grain(k: u32, dt: f64) -> CaromGrain {
    let velocity = [0.02, 0.01, -0.05];
    let time = f64::from(k) * dt;
    let place = [0.02 * time, 0.01 * time, 0.02 - 0.05 * time];
    CaromGrain { place, velocity, spin: [0.3, -0.2, 0.9], radius: 0.02, mass: 1.0 }
}

const DT: f64 = 1e-6;

fn surface(velocity: [f64; 3], spin: [f64; 3], axis: [f64; 3]) -> CaromSurface {
    CaromSurface { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity, spin, axis }
}

fn loads(grains: &CaromGrains, wall: impl Fn(&CaromGrain) -> CaromSurface) -> Vec<CaromGrainLoad> {
    let mut touch = touch();
    let step = |k| {
        let (one, mut load) = (grain(k, DT), CaromGrainLoad::default());
        let wall = wall(&one);
        // SAFETY: all pointers are references or null.
        let status = unsafe {
            carom_touch_surface(
                grains,
                &mut touch,
                &one,
                &wall,
                DT,
                &mut load,
                null_mut(),
                null_mut(),
            )
        };
        assert_eq!(status, CaromStatus::Ok);
        load
    };
    (1..200).map(step).collect()
}

/// A wall that neither turns nor curves is `carom_wall`, bit for bit.
#[test]
fn a_flat_wall_at_rest_is_a_surface() {
    let grains = flat(CAROM_LAW_COULOMB);
    let velocity = [0.01, 0.0, 0.0];
    let wall = CaromWall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity };
    let mut touch = touch();
    for (k, load) in loads(&grains, |_| surface(velocity, [0.0; 3], [0.0; 3])).iter().enumerate() {
        let mut other = CaromGrainLoad::default();
        // SAFETY: all pointers are references or null.
        let status = unsafe {
            carom_touch_wall(
                &grains,
                &mut touch,
                &grain(k as u32 + 1, DT),
                &wall,
                DT,
                &mut other,
                null_mut(),
                null_mut(),
            )
        };
        assert_eq!((status, &other), (CaromStatus::Ok, load));
    }
}

/// Grain and wall that turn about the normal together have the forces that they have at rest, turned with them.
#[test]
fn what_turns_together_does_not_slip() {
    let (grains, rate) = (flat(CAROM_LAW_COULOMB), 3000.0);
    let still = {
        let mut touch = touch();
        let step = |k: u32| {
            let one = CaromGrain { spin: [0.0; 3], ..grain(k, DT) };
            let mut load = CaromGrainLoad::default();
            let wall = surface([0.0; 3], [0.0; 3], [0.0; 3]);
            // SAFETY: all pointers are references or null.
            unsafe {
                carom_touch_surface(
                    &grains,
                    &mut touch,
                    &one,
                    &wall,
                    DT,
                    &mut load,
                    null_mut(),
                    null_mut(),
                )
            };
            load
        };
        (1..200).map(step).collect::<Vec<_>>()
    };
    let turned = |[x, y, z]: [f64; 3], angle: f64| {
        let (s, c) = angle.sin_cos();
        [c * x - s * y, s * x + c * y, z]
    };
    let (mut touch, mut off) = (touch(), 0.0_f64);
    for (k, expected) in (1_u32..200).zip(&still) {
        let (now, middle) = (rate * DT * f64::from(k), rate * DT * (f64::from(k) - 0.5));
        let one = grain(k, DT);
        // The wall turns about the origin; seen from there the grain moves as in the case at rest.
        let half = one.place;
        let place = turned(half, now);
        let back: [f64; 3] = std::array::from_fn(|i| half[i] - 0.5 * DT * one.velocity[i]);
        let at_middle = turned(back, middle);
        let own = turned(one.velocity, middle);
        let whirl = [-rate * at_middle[1], rate * at_middle[0], 0.0];
        let velocity = std::array::from_fn(|i| own[i] + whirl[i]);
        let spin = [0.0, 0.0, rate];
        let one = CaromGrain { place, velocity, spin, radius: one.radius, mass: 1.0 };
        let wall =
            CaromSurface { place: [place[0], place[1], 0.0], ..surface(whirl, spin, [0.0; 3]) };
        let mut load = CaromGrainLoad::default();
        // SAFETY: all pointers are references or null.
        unsafe {
            carom_touch_surface(
                &grains,
                &mut touch,
                &one,
                &wall,
                DT,
                &mut load,
                null_mut(),
                null_mut(),
            )
        };
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
    let grains = curved(0.02, [-20.0, 0.0], CAROM_LAW_COULOMB).unwrap();
    let along = |axis: [f64; 3]| loads(&grains, |_| surface([0.0; 3], [0.0; 3], axis));
    let (x, y) = (along([1.0, 0.0, 0.0]), along([0.0, 1.0, 0.0]));
    assert!(x.iter().zip(&y).skip(100).all(|(x, y)| x.force != y.force), "the ellipse counts");
    let spun = loads(&grains, |_| surface([0.0; 3], [0.0, 0.0, 500.0], [1.0, 0.0, 0.0]));
    assert_eq!(x, spun);
}

#[test]
fn an_axis_that_is_none_is_refused() {
    let (grains, one) = (flat(CAROM_LAW_COULOMB), grain(10, DT));
    for axis in [[0.9, 0.0, 0.0], [0.0, 0.0, 1.0], [f64::NAN, 0.0, 0.0]] {
        let (mut touch, mut load) = (touch(), CaromGrainLoad::default());
        let wall = surface([0.0; 3], [0.0; 3], axis);
        // SAFETY: plain numbers; all pointers are references or null.
        unsafe {
            let mut error = zeroed::<CaromError>();
            let status = carom_touch_surface(
                &grains,
                &mut touch,
                &one,
                &wall,
                DT,
                &mut load,
                null_mut(),
                &mut error,
            );
            let field = error.field.iter().take_while(|b| **b != 0).map(|b| *b as u8 as char);
            assert_eq!(status, CaromStatus::OutOfRange);
            assert_eq!(field.collect::<String>(), "axis");
        }
    }
}

/// The contact lies below the surface of the wall by what the wall is compressed; there a wall that turns moves
/// otherwise than at its surface.
#[test]
fn a_wall_that_turns_moves_at_the_contact() {
    let (grains, rate) = (flat(CAROM_LAW_COULOMB), 400.0);
    let turning = loads(&grains, |_| surface([0.0; 3], [0.0, rate, 0.0], [0.0; 3]));
    let shifted = loads(&grains, |one| {
        // At the middle of the step, to which the velocities belong.
        let place = one.place[2] - 0.5 * DT * one.velocity[2];
        let below = (1.0 - grains.share_1) * (one.radius - place);
        surface([-rate * below, 0.0, 0.0], [0.0; 3], [0.0; 3])
    });
    for (one, other) in turning.iter().zip(&shifted) {
        let off = (0..3).map(|i| (one.force[i] - other.force[i]).abs()).fold(0.0, f64::max);
        assert!(off <= 1e-9 * other.force[2], "{one:?} {other:?}");
    }
    let still = loads(&grains, |_| surface([0.0; 3], [0.0; 3], [0.0; 3]));
    let (last, other) = (turning.last().unwrap(), still.last().unwrap());
    assert!((last.force[0] - other.force[0]).abs() > 1e-6 * other.force[2], "it counts");
}
