//! Limits of the theory for grains: contacts against the pair of their radii, impacts against closed forms, and
//! the sentences.

use std::f64::consts::PI;
use std::ffi::{CStr, c_char};
use std::mem::zeroed;
use std::ptr::{null, null_mut};

use carom_capi::*;

const INF: f64 = f64::INFINITY;
const GLASS: CaromMaterial =
    CaromMaterial { young_modulus: 70e9, poisson: 0.25, yield_stress: 0.0 };
const SOFT: CaromMaterial = CaromMaterial { young_modulus: 5e9, poisson: 0.4, yield_stress: 80e6 };
/// The coefficient of (3.2) for nu = 1/4.
const WAVES: f64 = 1.111_532_436_869_86;

fn told<T>(call: impl FnOnce(*mut T, *mut CaromError) -> CaromStatus) -> Result<T, String> {
    // SAFETY: plain numbers, for which zeros are valid.
    let (mut made, mut error): (T, CaromError) = unsafe { (zeroed(), zeroed()) };
    match call(&raw mut made, &raw mut error) {
        CaromStatus::Ok => Ok(made),
        _ => {
            // SAFETY: ends with a zero.
            let text = unsafe { CStr::from_ptr(error.text.as_ptr()) };
            Err(text.to_string_lossy().into_owned())
        }
    }
}

fn grains(one: &CaromMaterial, two: &CaromMaterial, law: u32, relaxation: f64) -> CaromGrains {
    // SAFETY: all pointers are references.
    let made = told(|to, error| unsafe {
        carom_grains_of(one, two, 0.3, law, 0.0, relaxation, to, error)
    });
    made.unwrap()
}

fn contact(grains: &CaromGrains, [one, two]: [f64; 2], zeta: f64) -> Result<CaromValidity, String> {
    // SAFETY: all pointers are references.
    told(|to, error| unsafe { carom_grains_validity(grains, one, two, zeta, to, error) })
}

fn impact(
    grains: &CaromGrains,
    [r_1, r_2]: [f64; 2],
    [m_1, m_2]: [f64; 2],
    velocity: f64,
    step: f64,
) -> Result<CaromValidity, String> {
    // SAFETY: all pointers are references.
    told(|to, error| unsafe {
        carom_grains_impact_validity(grains, r_1, r_2, m_1, m_2, velocity, step, to, error)
    })
}

fn mass(radius: f64, density: f64) -> f64 {
    density * 4.0 / 3.0 * PI * radius.powi(3)
}

fn is_close(one: f64, other: f64) -> bool {
    (one / other - 1.0).abs() < 1e-12
}

#[test]
fn a_contact_of_grains_is_that_of_the_pair_of_their_radii() {
    for (law, [r_1, r_2], zeta) in [
        (CAROM_LAW_COULOMB, [1e-3, 3e-3], 2e-6),
        (CAROM_LAW_FIXED_DIRECTION, [3e-3, 1e-3], 2e-4),
        (CAROM_LAW_COULOMB, [2e-3, INF], 1e-5),
    ] {
        // SAFETY: all pointers are references.
        let pair = told(|to, error| unsafe {
            carom_pair_of_spheres(&GLASS, &SOFT, r_1, r_2, 0.3, law, 0.0, to, error)
        });
        let (pair, smallest) = (pair.unwrap(), f64::min(r_1, r_2));
        // SAFETY: all pointers are references.
        let expected: CaromValidity =
            told(|to, error| unsafe { carom_pair_validity(&pair, zeta, smallest, to, error) })
                .unwrap();
        let of_grains = contact(&grains(&GLASS, &SOFT, law, 0.0), [r_1, r_2], zeta).unwrap();
        let ratios = |told: &CaromValidity| {
            [
                told.semi_axis_over_radius,
                told.approach_over_radius,
                told.pressure_over_yield,
                told.coupling,
            ]
        };
        for (one, other) in ratios(&of_grains).into_iter().zip(ratios(&expected)) {
            assert!(one > 0.0 && is_close(one, other), "{of_grains:?} {expected:?}");
        }
        assert_eq!(of_grains.warnings, expected.warnings);
        assert_eq!(of_grains.warnings & CAROM_WARNING_COUPLING, CAROM_WARNING_COUPLING);
    }
    // What the law has is not left out.
    let rings = grains(&GLASS, &SOFT, CAROM_LAW_RINGS, 0.0);
    assert_eq!(contact(&rings, [1e-3, 3e-3], 2e-6).unwrap().coupling, 0.0);
}

/// Hertz: zeta_max^5 = (15 m v^2/(16 E* sqrt(R)))^2, and a^2 = R zeta.
#[test]
fn an_impact_has_its_largest_contact_its_waves_and_its_steps() {
    let (radius, density, velocity, step) = (1e-3_f64, 2500.0, 3.0, 1e-7);
    let floor = grains(&GLASS, &GLASS, CAROM_LAW_COULOMB, 0.0);
    let ball = mass(radius, density);
    let told = impact(&floor, [radius, INF], [ball, INF], velocity, step).unwrap();
    let modulus = 70e9 / (2.0 * (1.0 - 0.25 * 0.25));
    let deep = (15.0 * ball * velocity * velocity / (16.0 * modulus * radius.sqrt())).powf(0.4);
    assert!(is_close(told.approach_over_radius, deep / radius));
    assert!(is_close(told.semi_axis_over_radius, (deep / radius).sqrt()));
    let rod_speed = (70e9 / density).sqrt();
    assert!(is_close(told.wave_share, WAVES * (velocity / rod_speed).powf(0.6)));
    assert!((told.step_over_duration * 2.943_275_184 * deep / velocity / step - 1.0).abs() < 1e-9);
    // A loss that is given, by a time or by a restitution, holds that of the waves.
    let damped = grains(&GLASS, &GLASS, CAROM_LAW_COULOMB, 1e-9);
    let mut rebounding = floor;
    // SAFETY: a pointer to what lives on.
    let status = unsafe { carom_grains_restitution(&raw mut rebounding, 0.9, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    let warned = [floor, damped, rebounding].map(|grains| {
        let told = impact(&grains, [radius, INF], [ball, INF], 30.0 * velocity, step).unwrap();
        told.warnings & CAROM_WARNING_WAVE_LOSS
    });
    assert_eq!(warned, [CAROM_WARNING_WAVE_LOSS, 0, 0]);
    // Two equal balls are one of half the radius and mass, four times as dense, on a plane; what a pulse
    // radiates goes by the root of the density.
    let two = impact(&floor, [radius; 2], [ball; 2], velocity, step).unwrap();
    assert!(is_close(two.wave_share, 0.5 * WAVES * (2.0 * velocity / rod_speed).powf(0.6)));
    // By twenty steps in an impact.
    let duration = step / told.step_over_duration;
    let steps = |count: f64| {
        let told = impact(&floor, [radius, INF], [ball, INF], velocity, duration / count).unwrap();
        told.warnings & CAROM_WARNING_TIME_STEP
    };
    assert_eq!([steps(20.1), steps(19.9)], [0, CAROM_WARNING_TIME_STEP]);
}

#[test]
fn each_grain_radiates_into_its_own_material() {
    // Soft and light against hard and heavy: whoever is named first.
    let radii = [2e-3, 1e-3];
    let masses = [mass(2e-3, 1000.0), mass(1e-3, 8000.0)];
    let swapped = [[radii[1], radii[0]], [masses[1], masses[0]]];
    let share = |one, two, radii, masses| {
        let both = grains(one, two, CAROM_LAW_COULOMB, 0.0);
        impact(&both, radii, masses, 5.0, 0.0).unwrap().wave_share
    };
    let one = share(&SOFT, &GLASS, radii, masses);
    assert!(is_close(share(&GLASS, &SOFT, swapped[0], swapped[1]), one));
    // The soft one radiates more: as it does with a hard partner that radiates nothing.
    let rigid = CaromMaterial { young_modulus: INF, ..GLASS };
    let both = grains(&SOFT, &rigid, CAROM_LAW_COULOMB, 0.0);
    assert_eq!((both.radiation_2, both.radiation_1 > 0.0), (0.0, true));
    let hard = share(&GLASS, &SOFT, radii, masses);
    assert!((hard / one - 1.0).abs() > 0.1, "{hard} {one}");
}

#[test]
fn damping_stands_for_all_losses_and_its_contacts_are_looked_at_as_they_are() {
    let damped = grains(&GLASS, &SOFT, CAROM_LAW_COULOMB, 1e-7);
    let masses = [mass(1e-3, 2500.0); 2];
    let free =
        impact(&grains(&GLASS, &SOFT, CAROM_LAW_COULOMB, 0.0), [1e-3; 2], masses, 30.0, 1e-7)
            .unwrap();
    let told = impact(&damped, [1e-3; 2], masses, 30.0, 1e-7).unwrap();
    assert!(free.wave_share > 0.01 && free.pressure_over_yield > 1.0);
    assert_eq!((told.wave_share, told.pressure_over_yield), (0.0, 0.0));
    assert_eq!((told.approach_over_radius, told.semi_axis_over_radius), (0.0, 0.0));
    assert_eq!(told.step_over_duration, free.step_over_duration);
    let [deep, free] = [&damped, &grains(&GLASS, &SOFT, CAROM_LAW_COULOMB, 0.0)]
        .map(|of| contact(of, [1e-3; 2], 1e-5));
    assert_eq!(deep, free);
}

#[test]
fn many_contacts_are_as_bad_as_the_worst_in_each_ratio() {
    let [hard, soft] = [&GLASS, &SOFT].map(|two| grains(&GLASS, two, CAROM_LAW_COULOMB, 0.0));
    let grain = |height: f64, radius| CaromGrain {
        place: [0.6 * height, 0.0, 0.8 * height],
        velocity: [0.0; 3],
        spin: [0.0; 3],
        radius,
        mass: 1.0,
    };
    let met = |grains, radii: [f64; 2], zeta: f64| CaromEncounter {
        grains,
        touch: null_mut(),
        one: grain(3e-3, radii[0]),
        two: grain(3e-3 + radii[0] + radii[1] - zeta, radii[1]),
        load: CaromGrainLoad::default(),
    };
    let (small, large) = ([1e-3, 3e-3], [4e-3, 2e-3]);
    let all = [met(&hard, small, 1e-5), met(&soft, large, 2e-6), met(&soft, large, -1e-6)];
    let worst = |all: &[CaromEncounter]| {
        // SAFETY: all pointers are references, and touches are not read.
        told::<CaromValidity>(|to, error| unsafe {
            carom_encounters_validity(all.as_ptr(), all.len(), to, error)
        })
    };
    let [one, two] = [(&hard, small, 1e-5), (&soft, large, 2e-6)]
        .map(|(of, radii, zeta)| contact(of, radii, zeta).unwrap());
    let told = worst(&all).unwrap();
    assert!(is_close(told.approach_over_radius, one.approach_over_radius));
    assert!((told.semi_axis_over_radius / one.semi_axis_over_radius - 1.0).abs() < 1e-9);
    assert!((told.pressure_over_yield / two.pressure_over_yield - 1.0).abs() < 1e-9);
    assert_eq!(told.coupling, two.coupling);
    assert_eq!(worst(&all[2..]).unwrap(), CaromValidity::default());
    assert_eq!(worst(&[]).unwrap(), CaromValidity::default());
    let wrong = [all[0], CaromEncounter { grains: null(), ..all[0] }];
    assert_eq!(worst(&wrong).unwrap_err(), "grains is a null pointer");
}

fn sentence(validity: &CaromValidity, warning: u32, size: usize) -> Result<String, String> {
    let mut text = [0x7a; 256];
    // SAFETY: all pointers are references, and the text has more than `size` bytes.
    told::<[u8; 0]>(|_, error| unsafe {
        carom_validity_text(validity, warning, text.as_mut_ptr(), size, error)
    })?;
    assert!(text[size..].iter().all(|byte| *byte == 0x7a), "beyond the end");
    // SAFETY: ends with a zero.
    Ok(unsafe { CStr::from_ptr(text.as_ptr().cast::<c_char>()) }.to_str().unwrap().to_owned())
}

#[test]
fn what_is_exceeded_has_a_sentence_with_its_number() {
    let validity = CaromValidity {
        semi_axis_over_radius: 0.12,
        approach_over_radius: 0.015,
        pressure_over_yield: 1.25,
        wave_share: 0.034,
        coupling: 0.7,
        step_over_duration: 0.1,
        warnings: 0,
    };
    for (warning, number) in [
        (CAROM_WARNING_LARGE_CONTACT, "it is 0.12"),
        (CAROM_WARNING_YIELDS, "it is 1.25 times that"),
        (CAROM_WARNING_WAVE_LOSS, "about 3.4 %"),
        (CAROM_WARNING_COUPLING, "changes by up to 0.7"),
        (CAROM_WARNING_TIME_STEP, "the shortest lasts 10"),
    ] {
        let told = sentence(&validity, warning, 200).unwrap();
        // SAFETY: ends with a zero.
        let words = unsafe { CStr::from_ptr(carom_warning_text(warning)) }.to_str().unwrap();
        assert!(told.starts_with(words) && told.ends_with(number) && told.len() < 199, "{told}");
        assert_eq!(sentence(&validity, warning, 12).unwrap(), told[..11]);
    }
    assert_eq!(sentence(&validity, CAROM_WARNING_LARGE_APPROACH, 200).unwrap(), "");
    let wrong = "warning = 3 is not the CAROM_WARNING bit of a carom_validity";
    assert_eq!(sentence(&validity, 3, 200).unwrap_err(), wrong);
    assert!(sentence(&validity, CAROM_WARNING_NOT_SETTLED, 200).is_err());
    assert_eq!(sentence(&validity, 2, 0).unwrap_err(), "size = 0 is out of range: must be >= 1");
}

#[test]
fn wrong_numbers_are_named() {
    let floor = grains(&GLASS, &GLASS, CAROM_LAW_COULOMB, 0.0);
    let wrong = [
        (contact(&floor, [1e-3, 1e-3], -1.0), "zeta"),
        (contact(&floor, [0.0, 1e-3], 1e-6), "radius_1"),
        (contact(&floor, [1e-3, -1e-3], 1e-6), "radius_2"),
        (impact(&floor, [1e-3; 2], [1e-5; 2], 1.0, -1e-9), "step"),
        (impact(&floor, [1e-3; 2], [0.0, 1e-5], 1.0, 0.0), "mass_1"),
        (impact(&floor, [1e-3; 2], [1e-5; 2], 0.0, 0.0), "velocity"),
        (
            contact(
                &CaromGrains { unit: CaromPair { a_squared: 0.0, ..floor.unit }, ..floor },
                [1e-3; 2],
                1e-6,
            ),
            "a_squared",
        ),
    ];
    for (told, field) in wrong {
        let text = told.unwrap_err();
        assert!(text.starts_with(field) && text.contains("is out of range"), "{text}");
    }
}
