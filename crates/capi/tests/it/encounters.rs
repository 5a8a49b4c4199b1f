//! Many encounters of grains in one call of the C interface.

use std::ptr::null_mut;

use carom_capi::*;

use super::grains::{apart, error, made, step};

/// Many encounters in one call are those one by one, to the bit: new ones, ones that end, a rest that fills no
/// group. What cannot go on ends the call and is named, and those before it went on.
#[test]
fn encounters_go_through_one_call_as_one_by_one() {
    const PAIRS: usize = 11;
    let grains = [
        made([0.3, 0.2], 0.4, CAROM_LAW_FIXED_DIRECTION, 1e-7).unwrap(),
        made([0.1, 0.4], 0.2, CAROM_LAW_COULOMB, 0.0).unwrap(),
    ];
    let body = |radius: f64| CaromGrain {
        place: [0.0; 3],
        velocity: [0.0; 3],
        spin: [0.0; 3],
        radius,
        mass: 1.0,
    };
    let (mut alone, mut many) = (vec![apart(); PAIRS], vec![apart(); PAIRS]);
    let dt = 1e-6;
    let all = |encounters: &mut [CaromEncounter]| {
        let mut error = error();
        // SAFETY: pointers to what lives on, each touch once.
        let status = unsafe {
            carom_touch_many(encounters.as_mut_ptr(), PAIRS, dt, null_mut(), &raw mut error)
        };
        (status, error.index)
    };
    for now in 0..400 {
        let t = f64::from(now);
        let mut encounters: Vec<_> = many
            .iter_mut()
            .enumerate()
            .map(|(i, touch)| {
                let phase = 0.05 * t + i as f64;
                let place = [
                    1e-6 * (0.03 * t).sin(),
                    2e-6 * (0.02 * phase).cos(),
                    1.9 - 1e-5 + 3e-5 * phase.sin(),
                ];
                let velocity = [0.03 * phase.cos(), 0.02 * (0.02 * phase).sin(), 1.5 * phase.cos()];
                let one = CaromGrain {
                    place,
                    velocity,
                    spin: [3.0 * phase.sin(), 1.0, 2.0],
                    ..body(1.0)
                };
                let load = CaromGrainLoad::default();
                CaromEncounter {
                    grains: &raw const grains[i % 2],
                    touch,
                    one,
                    two: body(0.9),
                    load,
                }
            })
            .collect();
        assert_eq!(all(&mut encounters).0, CaromStatus::Ok);
        for ((i, met), touch) in encounters.iter().enumerate().zip(&mut alone) {
            let load = step(&grains[i % 2], touch, &[met.one, met.two], dt, None);
            assert_eq!(load, met.load, "step {now}, pair {i}");
        }
        if now == 200 {
            encounters[6].two.place = encounters[6].one.place;
            assert_eq!(all(&mut encounters), (CaromStatus::OutOfRange, 6));
            for ((i, met), touch) in encounters.iter().enumerate().zip(&mut alone).take(6) {
                step(&grains[i % 2], touch, &[met.one, met.two], dt, None);
            }
        }
    }
    // SAFETY: nothing is read.
    let status = unsafe { carom_touch_many(null_mut(), 1, dt, null_mut(), null_mut()) };
    assert_eq!(status, CaromStatus::NullPointer);
}
