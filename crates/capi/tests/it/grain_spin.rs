//! Spin of grains about their normal, through the C interface.

use std::mem::zeroed;
use std::ptr::null_mut;

use carom_capi::*;

use super::grains::{RADII, dot, made, plus};

/// Two unequal spheres that spin to and fro about their normal: the torque is that of the law of a twist with
/// the constants of their curvatures, and what turning them costs is stored or heat.
#[test]
fn spin_about_the_normal_meets_the_law_of_a_twist() {
    let grains = made([0.3, 0.2], 0.4, CAROM_LAW_FIXED_DIRECTION, 0.0).unwrap();
    let bodies =
        [0.3, 0.2].map(|poisson| CaromMaterial { young_modulus: 70e9, poisson, yield_stress: 0.0 });
    let [one, two] = &bodies;
    let normal = [0.36, 0.48, 0.8];
    let (zeta, dt) = (1e-5, 1e-3);
    let body = |sign: f64, radius: f64, spin: f64| CaromGrain {
        place: normal.map(|n| sign * n * (radius - 0.5 * zeta)),
        velocity: [0.0; 3],
        spin: normal.map(|n| spin * n),
        radius,
        mass: 1.0,
    };
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let (mut pair, zero) = (zeroed(), zeroed::<CaromTwist>());
        let to = &raw mut pair;
        let status = carom_pair_of_spheres(
            one,
            two,
            RADII[0],
            RADII[1],
            0.4,
            CAROM_LAW_FIXED_DIRECTION,
            0.0,
            to,
            null_mut(),
        );
        assert_eq!(status, CaromStatus::Ok);
        let (mut twist, mut alone) = (zero, zero);
        let (mut omega, mut work, mut heats) = (0.0, 0.0, CaromHeats::default());
        let (mut before, mut largest) = (0.0, 0.0_f64);
        for step in 0..400 {
            let spin = 2e-3 * f64::from(step).mul_add(0.02, 0.0).cos();
            let (grain, other) = (body(1.0, RADII[0], 0.3), body(-1.0, RADII[1], 0.3 + spin));
            let mut load = CaromGrainLoad::default();
            let status = carom_touch_twist_grains(
                &grains,
                &mut twist,
                &grain,
                &other,
                dt,
                &mut load,
                &mut heats,
                null_mut(),
            );
            assert_eq!(status, CaromStatus::Ok);
            let mut torque = 0.0;
            if step == 0 {
                // The step in which they are found in contact.
                carom_twist_advance(&pair, &mut alone, zeta, 0.0, null_mut(), null_mut());
            }
            omega += spin * dt;
            carom_twist_advance(&pair, &mut alone, zeta, omega, &mut torque, null_mut());
            largest = largest.max(torque.abs());
            assert_eq!(load.force, [0.0; 3]);
            assert_eq!(load.torque_1, load.torque_2.map(|torque| -torque));
            let off = plus(load.torque_1, normal, -torque);
            assert!(dot(off, off).sqrt() < 1e-9 * largest);
            work += 0.5 * (before + torque) * spin * dt;
            before = torque;
            // Looked at once more without time: the same bits, wherever the bodies are put.
            let nearer = CaromGrain { place: plus(grain.place, normal, -0.1 * zeta), ..grain };
            let kept = twist;
            for grain in [grain, nearer] {
                let mut again = CaromGrainLoad::default();
                carom_touch_twist_grains(
                    &grains,
                    &mut twist,
                    &grain,
                    &other,
                    0.0,
                    &mut again,
                    null_mut(),
                    null_mut(),
                );
                assert_eq!((again, twist), (load, kept));
            }
        }
        let mut stored = 0.0;
        let status =
            carom_touch_twist_energy(&grains, &twist, RADII[0], RADII[1], &mut stored, null_mut());
        assert_eq!(status, CaromStatus::Ok);
        println!("work {work:e}, stored {stored:e}, heat {:e}", heats.friction);
        assert!(heats.friction > 0.1 * work);
        assert!((work - stored - heats.friction).abs() < 1e-3 * work);
        // Apart, and all is forgotten.
        let far = CaromGrain { place: normal.map(|n| -2.0 * n), ..body(-1.0, RADII[1], 0.0) };
        let mut load = CaromGrainLoad::default();
        let grain = body(1.0, RADII[0], 0.3);
        carom_touch_twist_grains(
            &grains,
            &mut twist,
            &grain,
            &far,
            dt,
            &mut load,
            null_mut(),
            null_mut(),
        );
        assert_eq!((load, twist), (CaromGrainLoad::default(), zero));
    }
}
