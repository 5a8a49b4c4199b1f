//! Limits of the theory: contacts against Hertz, impacts against closed forms, and the sentences.

use std::collections::BTreeSet;
use std::f64::consts::PI;

use super::*;

const INF: f64 = f64::INFINITY;
const HARD: CaromMaterial = CaromMaterial { young_modulus: 70e9, poisson: 0.25, yield_stress: 0.0 };
const SOFT: CaromMaterial = CaromMaterial { young_modulus: 5e9, poisson: 0.4, yield_stress: 80e6 };
const BOTH: u32 = CAROM_WARNING_LARGE_CONTACT | CAROM_WARNING_LARGE_APPROACH;
/// The coefficient of (3.2) for nu = 1/4.
const WAVES: f64 = 1.111_532_436_869_86;

fn law(one: CaromMaterial, two: CaromMaterial, its: u32, relaxation: f64) -> Made {
    Made::new([one, two], 0.3, &CaromLawOptions { relaxation, ..options(its) }).unwrap()
}

fn impact(
    law: &Made,
    [r_1, r_2]: [f64; 2],
    [m_1, m_2]: [f64; 2],
    velocity: f64,
    step: f64,
) -> Result<CaromValidity, Told> {
    // SAFETY: all pointers are references.
    told(CaromValidity::default(), |to, error| unsafe {
        carom_law_impact_validity(law.0, r_1, r_2, m_1, m_2, velocity, step, to, error)
    })
}

fn mass(radius: f64, density: f64) -> f64 {
    density * 4.0 / 3.0 * PI * radius.powi(3)
}

fn is_close(one: f64, other: f64) -> bool {
    (one / other - 1.0).abs() < 1e-12
}

/// a^2 = R zeta with 1/R = 1/R_1 + 1/R_2.
#[test]
fn spheres_have_the_circle_of_hertz() {
    let law = law(GLASS, GLASS, CAROM_LAW_COULOMB, 0.0);
    let at = |zeta: f64| law.validity([1e-3, 3e-3], zeta).unwrap();
    let told = at(1e-6);
    assert!(is_close(told.semi_axis_over_radius, (0.75e-3 * 1e-6_f64).sqrt() / 1e-3));
    assert!(is_close(told.approach_over_radius, 1e-3));
    assert_eq!(told.warnings, 0);
    // a = 0.1 mm.
    let limit = 1e-4 * 1e-4 / 0.75e-3;
    assert_eq!(at(0.999 * limit).warnings, 0);
    assert_eq!(at(1.001 * limit).warnings, CAROM_WARNING_LARGE_CONTACT);
    assert_eq!(at(0.999e-4).warnings, CAROM_WARNING_LARGE_CONTACT);
    assert_eq!(at(1.001e-4).warnings, BOTH);
    assert_eq!(at(0.0), CaromValidity::default());
    let other = law.validity([3e-3, INF], 1e-6).unwrap();
    assert!(is_close(other.semi_axis_over_radius, (1e-6_f64 / 3e-3).sqrt()));
    // Whichever law; rings have the coupling that the others leave out.
    for its in LAWS {
        let told = self::law(HARD, SOFT, its, 0.0).validity([3e-3, 1e-3], 2e-4).unwrap();
        assert!(is_close(told.semi_axis_over_radius, (0.75e-3 * 2e-4_f64).sqrt() / 1e-3));
        assert!(is_close(told.approach_over_radius, 0.2));
        let leaves_out = its != CAROM_LAW_RINGS;
        assert_eq!(
            (told.coupling > 0.0, told.warnings & CAROM_WARNING_COUPLING),
            (leaves_out, u32::from(leaves_out))
        );
    }
}

/// An ellipse counts by its larger semi-axis, whichever it is.
#[test]
fn an_ellipse_counts_by_its_larger_semi_axis() {
    let flat = law(GLASS, GLASS, CAROM_LAW_COULOMB, 0.0);
    let ratio = |curvatures| {
        let law = flat.curved(1e-3, curvatures).unwrap();
        law.validity([1e-3, INF], 1e-7).unwrap().semi_axis_over_radius
    };
    let [along, across, round] = [[0.0, -900.0], [-900.0, 0.0], [0.0, 0.0]].map(ratio);
    assert!(is_close(along, across) && along > 1.5 * round, "{along} {across} {round}");
}

/// p = (2/pi) E* sqrt(zeta/R), E* = E/(2 (1 - nu^2)).
#[test]
fn a_contact_yields_at_1_6_times_its_yield_stress() {
    let soft = CaromMaterial { yield_stress: 1e9, ..GLASS };
    let modulus = 70e9 / (2.0 * (1.0 - 0.22 * 0.22));
    let pressure = |zeta: f64| 2.0 / PI * modulus * (zeta / 0.75e-3).sqrt();
    let at = |two, zeta: f64| {
        law(GLASS, two, CAROM_LAW_COULOMB, 0.0).validity([1e-3, 3e-3], zeta).unwrap()
    };
    let zeta = 1e-6;
    assert!(is_close(at(soft, zeta).pressure_over_yield, pressure(zeta) / 1.6e9));
    let limit = zeta * (1.6e9 / pressure(zeta)).powi(2);
    assert_eq!(at(soft, 0.999 * limit).warnings, 0);
    assert_eq!(at(soft, 1.001 * limit).warnings, CAROM_WARNING_YIELDS);
    assert_eq!(at(GLASS, zeta).pressure_over_yield, 0.0);
}

/// Hertz: zeta_max^5 = (15 m v^2/(16 E* sqrt(R)))^2, and a^2 = R zeta.
#[test]
fn an_impact_has_its_largest_contact_its_waves_and_its_steps() {
    let (radius, density, velocity, step) = (1e-3_f64, 2500.0, 3.0, 1e-7);
    let floor = law(HARD, HARD, CAROM_LAW_COULOMB, 0.0);
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
    let damped = law(HARD, HARD, CAROM_LAW_COULOMB, 1e-9);
    let its = CaromLawOptions { restitution: 0.9, ..options(CAROM_LAW_COULOMB) };
    let rebounding = Made::new([HARD; 2], 0.3, &its).unwrap();
    let warned = [&floor, &damped, &rebounding].map(|law| {
        let told = impact(law, [radius, INF], [ball, INF], 30.0 * velocity, step).unwrap();
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

/// Hertz: T = 2.94 zeta_max/v with zeta_max^5 = (15 m v^2/(16 E* sqrt(R)))^2, of a grain on a wall and of two grains.
#[test]
fn an_impact_lasts_as_hertz_says() {
    let law = law(GLASS, GLASS, CAROM_LAW_COULOMB, 0.0);
    let modulus = 70e9 / (2.0 * (1.0 - 0.22 * 0.22));
    let hertz = |radius: f64, mass: f64, velocity: f64| {
        let deep = 15.0 * mass * velocity * velocity / (16.0 * modulus * radius.sqrt());
        2.943_275_1 * deep.powf(0.4) / velocity
    };
    for (radii, masses, velocity, expected) in [
        ([1e-3, INF], [1e-5, INF], 0.3, hertz(1e-3, 1e-5, 0.3)),
        ([1e-3, 3e-3], [1e-5, 3e-5], 2.0, hertz(0.75e-3, 0.75e-5, 2.0)),
    ] {
        let told = law.impact_time(radii, masses, velocity).unwrap();
        assert!((told / expected - 1.0).abs() < 1e-6, "{told} {expected}");
    }
    for (masses, velocity, at_fault) in [
        ([INF; 2], 1.0, "mass_2"),
        ([0.0, 1e-5], 1.0, "mass_1"),
        ([1e-5, 0.0], 1.0, "mass_2"),
        ([1e-5; 2], 0.0, "velocity"),
    ] {
        let told = law.impact_time([1e-3; 2], masses, velocity).unwrap_err();
        assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, at_fault));
    }
}

#[test]
fn each_grain_radiates_into_its_own_material() {
    // Soft and light against hard and heavy: whoever is named first.
    let radii = [2e-3, 1e-3];
    let masses = [mass(2e-3, 1000.0), mass(1e-3, 8000.0)];
    let swapped = [[radii[1], radii[0]], [masses[1], masses[0]]];
    let share = |one, two, radii, masses| {
        let both = law(one, two, CAROM_LAW_COULOMB, 0.0);
        impact(&both, radii, masses, 5.0, 0.0).unwrap().wave_share
    };
    let one = share(SOFT, HARD, radii, masses);
    assert!(is_close(share(HARD, SOFT, swapped[0], swapped[1]), one));
    // The soft one radiates more: as it does with a hard partner that radiates nothing.
    let rigid = CaromMaterial { young_modulus: INF, ..HARD };
    let one_alone = share(SOFT, rigid, [2e-3, INF], [masses[0], INF]);
    assert!(one_alone > 0.0);
    let hard = share(HARD, SOFT, radii, masses);
    assert!((hard / one - 1.0).abs() > 0.1, "{hard} {one}");
}

#[test]
fn damping_stands_for_all_losses_and_its_contacts_are_looked_at_as_they_are() {
    let damped = law(HARD, SOFT, CAROM_LAW_COULOMB, 1e-7);
    let masses = [mass(1e-3, 2500.0); 2];
    let free =
        impact(&law(HARD, SOFT, CAROM_LAW_COULOMB, 0.0), [1e-3; 2], masses, 30.0, 1e-7).unwrap();
    let told = impact(&damped, [1e-3; 2], masses, 30.0, 1e-7).unwrap();
    assert!(free.wave_share > 0.01 && free.pressure_over_yield > 1.0);
    assert_eq!((told.wave_share, told.pressure_over_yield), (0.0, 0.0));
    assert_eq!((told.approach_over_radius, told.semi_axis_over_radius), (0.0, 0.0));
    assert_eq!(told.step_over_duration, free.step_over_duration);
    let [deep, free] =
        [&damped, &law(HARD, SOFT, CAROM_LAW_COULOMB, 0.0)].map(|of| of.validity([1e-3; 2], 1e-5));
    assert_eq!(deep, free);
}

#[test]
fn many_contacts_are_as_bad_as_the_worst_in_each_ratio() {
    let [hard, soft] = [HARD, SOFT].map(|two| law(HARD, two, CAROM_LAW_COULOMB, 0.0));
    let grain =
        |height: f64, radius| grain([0.6 * height, 0.0, 0.8 * height], [0.0; 3], [0.0; 3], radius);
    let met = |law: &Made, radii: [f64; 2], zeta: f64| CaromEncounter {
        law: law.0,
        touch: null_mut(),
        wall: null(),
        one: grain(3e-3, radii[0]),
        two: grain(3e-3 + radii[0] + radii[1] - zeta, radii[1]),
        load: CaromGrainLoad::default(),
    };
    let (small, large) = ([1e-3, 3e-3], [4e-3, 2e-3]);
    let all = [met(&hard, small, 1e-5), met(&soft, large, 2e-6), met(&soft, large, -1e-6)];
    let worst = |all: &[CaromEncounter]| {
        // SAFETY: all pointers are references, and touches are not read.
        told(CaromValidity::default(), |to, error| unsafe {
            carom_encounters_validity(all.as_ptr(), all.len(), to, error)
        })
    };
    let [one, two] = [(&hard, small, 1e-5), (&soft, large, 2e-6)]
        .map(|(of, radii, zeta)| of.validity(radii, zeta).unwrap());
    let told = worst(&all).unwrap();
    assert!(is_close(told.approach_over_radius, one.approach_over_radius));
    assert!((told.semi_axis_over_radius / one.semi_axis_over_radius - 1.0).abs() < 1e-9);
    assert!((told.pressure_over_yield / two.pressure_over_yield - 1.0).abs() < 1e-9);
    assert_eq!(told.coupling, two.coupling);
    let back = [2, 1, 0].map(|i| all[i]);
    assert_eq!(worst(&back).unwrap(), told);
    assert_eq!(worst(&all[2..]).unwrap(), CaromValidity::default());
    assert_eq!(worst(&[]).unwrap(), CaromValidity::default());
    let wrong = [all[0], CaromEncounter { law: null(), ..all[0] }];
    let told = worst(&wrong).unwrap_err();
    assert_eq!((told.text.as_str(), told.index), ("law is a null pointer", 1));
    // On a wall a grain has its own radius.
    let Second::Wall(on) = wall([0.0; 3], [0.0; 3], [0.0; 3]) else { unreachable!() };
    let one = self::grain([5.0, 3.0, 1e-3 - 2e-6], [0.0; 3], [0.0; 3], 1e-3);
    let on_wall = [CaromEncounter { wall: &on, one, ..all[0] }];
    let [told, expected] = [worst(&on_wall).unwrap(), hard.validity([1e-3, INF], 2e-6).unwrap()];
    assert!((told.semi_axis_over_radius / expected.semi_axis_over_radius - 1.0).abs() < 1e-9);
}

fn sentence(validity: &CaromValidity, warning: u32, size: usize) -> Result<String, Told> {
    let mut text = [0x7a; 256];
    // SAFETY: all pointers are references, and the text has more than `size` bytes.
    told((), |(), error| unsafe {
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
    assert_eq!(sentence(&validity, 3, 200).unwrap_err().text, wrong);
    assert!(sentence(&validity, CAROM_WARNING_NOT_SETTLED, 200).is_err());
    assert_eq!(
        sentence(&validity, 2, 0).unwrap_err().text,
        "size = 0 is out of range: must be >= 1"
    );
}

#[test]
fn wrong_numbers_are_named() {
    let floor = law(GLASS, GLASS, CAROM_LAW_COULOMB, 0.0);
    let wrong = [
        (floor.validity([1e-3, 1e-3], -1.0), "zeta"),
        (floor.validity([1e-3, 1e-3], f64::NAN), "zeta"),
        (floor.validity([1e-3, 1e-3], INF), "zeta"),
        (floor.validity([0.0, 1e-3], 1e-6), "radius_1"),
        (floor.validity([1e-3, -1e-3], 1e-6), "radius_2"),
        (impact(&floor, [1e-3; 2], [1e-5; 2], 1.0, -1e-9), "step"),
        (impact(&floor, [1e-3; 2], [0.0, 1e-5], 1.0, 0.0), "mass_1"),
        (impact(&floor, [1e-3; 2], [1e-5; 2], 0.0, 0.0), "velocity"),
    ];
    for (told, field) in wrong {
        let Told { status, field: named, text, .. } = told.unwrap_err();
        assert_eq!((status, named.as_str()), (CaromStatus::OutOfRange, field));
        assert!(text.contains("is out of range"), "{text}");
    }
}

/// A rubber ball that falls on a rigid floor.
fn fall(velocity: f64) -> CaromRebound {
    let rubber = CaromMaterial { young_modulus: 1e6, poisson: 0.5, yield_stress: 0.0 };
    // SAFETY: zeros are a solid sphere at rest.
    let [mut ball, mut floor]: [CaromBody; 2] = unsafe { zeroed() };
    (ball.shape, ball.sizes[0], ball.mass, ball.material) =
        (CAROM_SHAPE_SPHERE, 0.02, 0.03, rubber);
    ball.velocity[2] = -velocity;
    (floor.shape, floor.material.young_modulus) = (CAROM_SHAPE_PLANE, f64::INFINITY);
    collided([&ball, &floor], 0.3, Some(&[0.0, 0.0, 1.0]), None).unwrap()
}

#[test]
fn an_impact_warns_where_its_contact_does() {
    let (mut met, law) = (BTreeSet::new(), law(GLASS, GLASS, CAROM_LAW_COULOMB, 0.0));
    for velocity in [0.001, 0.1, 1.0, 3.0, 10.0] {
        let rebound = fall(velocity);
        let deep = law.validity([0.02, INF], rebound.maximal_approach).unwrap();
        assert_eq!(rebound.warnings & BOTH, deep.warnings, "{velocity} m/s");
        assert!(
            (rebound.maximal_semi_axis_b / 0.02 / deep.semi_axis_over_radius - 1.0).abs() < 1e-9
        );
        met.insert(deep.warnings);
    }
    assert_eq!(met, BTreeSet::from([0, CAROM_WARNING_LARGE_CONTACT, BOTH]));
}

#[test]
fn each_warning_has_its_words() {
    // SAFETY: static texts that end with a zero.
    let text = |bits| unsafe { CStr::from_ptr(carom_warning_text(bits)) }.to_str().unwrap();
    let texts: BTreeSet<_> = (0..11).map(|i| text(1 << i)).collect();
    let none = text(0);
    assert_eq!(texts.len(), 11);
    assert!(!texts.contains(none));
    assert_eq!([text(3), text(2048), text(u32::MAX)], [none; 3]);
}
