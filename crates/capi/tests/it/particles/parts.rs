//! Torsion and resistance to rolling: what they add to a contact of any law.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::grains::{GrainRoll, Meeting, Rolling, RollingResistance};
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw as _, Shift};
use carom_laws::torsion::law::TorsionLaw;

use super::*;

const RADII: [f64; 2] = [0.5, 0.35];
const NORMAL: Vector = [0.36, 0.48, 0.8];
const ZETA: f64 = 1e-5;
const DT: f64 = 1e-3;

fn relative() -> f64 {
    1.0 / RADII.map(|radius| 1.0 / radius).iter().sum::<f64>()
}

/// A sphere that overlaps another one across the plane through the origin.
fn body(sign: f64, radius: f64, spin: Vector) -> CaromGrain {
    grain(NORMAL.map(|n| sign * n * (radius - 0.5 * ZETA)), [0.0; 3], spin, radius)
}

/// Two unequal spheres that spin to and fro about their normal: the torque is that of the law of a twist with the
/// constants of their curvatures, and what turning them costs is stored or heat.
#[test]
fn spin_about_the_normal_meets_the_law_of_a_twist() {
    let its = CaromLawOptions { torsion: 1, ..options(CAROM_LAW_FIXED_DIRECTION) };
    let law = Made::new([STEEL, GLASS], 0.4, &its).unwrap();
    let material = |body: CaromMaterial| Material::from_young(body.young_modulus, body.poisson);
    let pair = MaterialPair::new(material(STEEL).unwrap(), material(GLASS).unwrap()).unwrap();
    let half = 0.5 / relative();
    let hertz =
        Hertz::new(RelativeCurvature::from_coefficients(half, half).unwrap(), pair).unwrap();
    let mut alone = TorsionLaw::new(&hertz, Friction::new(0.4).unwrap()).unwrap();
    let mut touch = law.touch();
    let (mut omega, mut work, mut heats) = (0.0, 0.0, CaromHeats::default());
    let (mut before, mut largest) = (0.0, 0.0_f64);
    let at = |omega| Shift { zeta: ZETA, omega, ..Shift::default() };
    // The step in which they are found in contact.
    alone.advance(at(0.0)).unwrap();
    for step in 0..400 {
        let spin = 2e-3 * (0.02 * f64::from(step)).cos();
        let one = body(1.0, RADII[0], NORMAL.map(|n| 0.3 * n));
        let two = Second::Grain(body(-1.0, RADII[1], NORMAL.map(|n| (0.3 + spin) * n)));
        let load = touch.tried(&law, (&one, &two), DT, Some(&mut heats)).unwrap();
        omega += spin * DT;
        let torque = alone.advance(at(omega)).unwrap().m_z;
        largest = largest.max(torque.abs());
        for (torques, sign) in [(load.torque_1, 1.0), (load.torque_2, -1.0)] {
            let off = plus(torques, NORMAL, -sign * torque);
            // Friction is that of round-off.
            let size = 1e-9 * largest + 1e-12 * RADII[0] * dot(load.force, NORMAL);
            assert!(dot(off, off).sqrt() < size, "{load:?} {torque}");
        }
        work += 0.5 * (before + torque) * spin * DT;
        before = torque;
        // Looked at once more, and with a step without time: the same bits, wherever the bodies are put.
        let kept = touch.clone();
        assert_eq!(touch.load(&law, &one, &two).unwrap(), load);
        assert_eq!(touch.step(&law, &one, &two, 0.0).torque_1, load.torque_1);
        touch = kept;
    }
    let compression =
        Made::new([STEEL, GLASS], 0.4, &CaromLawOptions { torsion: 0, ..its }).unwrap();
    let mut plain = compression.touch();
    let (one, two) = (body(1.0, RADII[0], [0.0; 3]), Second::Grain(body(-1.0, RADII[1], [0.0; 3])));
    plain.step(&compression, &one, &two, DT);
    let stored = touch.energy(&law, RADII) - plain.energy(&compression, RADII);
    println!("work {work:e}, stored {stored:e}, heat {:e}", heats.friction);
    assert!(heats.friction > 0.1 * work);
    assert!((work - stored - heats.friction).abs() < 1e-3 * work);
    // All of it would slide at 3 pi/16 f F_z a.
    let gross =
        3.0 * std::f64::consts::PI / 16.0 * 0.4 * hertz.force(ZETA) * (relative() * ZETA).sqrt();
    assert!(largest < gross && largest > 0.08 * gross, "{largest} {gross}");
    // Apart, and all is forgotten: the next twist begins anew.
    let far = CaromGrain { place: NORMAL.map(|n| -2.0 * n), ..body(-1.0, RADII[1], [0.0; 3]) };
    assert_eq!(touch.step(&law, &one, &Second::Grain(far), DT), CaromGrainLoad::default());
    assert_eq!(touch.energy(&law, RADII), 0.0);
}

/// The resistance adds the torque that the law below has under the same normal force, with any law of contact.
#[test]
fn rolling_adds_the_torque_of_its_spring_and_slider() {
    let resistance = RollingResistance::new(3e4, 20.0, 0.02).unwrap();
    for torsion in [0, 1] {
        for its in LAWS {
            let usual = CaromLawOptions { torsion, ..options(its) };
            let plain = Made::new([STEEL, GLASS], 0.3, &usual).unwrap();
            let law =
                Made::new([STEEL, GLASS], 0.3, &CaromLawOptions { rolling: ROLLING, ..usual })
                    .unwrap();
            let (mut touch, mut without, mut roll) =
                (law.touch(), plain.touch(), GrainRoll::default());
            let (mut heats, mut unrolled) = (CaromHeats::default(), CaromHeats::default());
            let mut largest = 0.0_f64;
            for step in 0..300 {
                let rate = 2.0 * (0.05 * f64::from(step)).sin();
                let one = body(1.0, RADII[0], [rate, 0.3, -rate]);
                let two = body(-1.0, RADII[1], [0.1, -rate, 0.2]);
                let meeting = Meeting::of_spheres(&one, &two, [0.5; 2]).unwrap();
                let two = Second::Grain(two);
                let load = touch.tried(&law, (&one, &two), DT, Some(&mut heats)).unwrap();
                let other = without.tried(&plain, (&one, &two), DT, Some(&mut unrolled)).unwrap();
                assert_eq!(load.force, other.force);
                let pressed = dot(load.force, meeting.normal);
                let (resistance, relative_radius) = (&resistance, relative());
                let mut rolling = Rolling { resistance, relative_radius, roll: &mut roll };
                let torque = rolling.advance(&meeting, DT, pressed, None).unwrap();
                for (k, torque) in torque.into_iter().enumerate() {
                    let [one, two] = [
                        load.torque_1[k] - other.torque_1[k],
                        load.torque_2[k] - other.torque_2[k],
                    ];
                    let size = load.torque_1[k].abs().max(load.torque_2[k].abs());
                    assert!(
                        (one - torque).abs() <= 1e-14 * size
                            && (two + torque).abs() <= 1e-14 * size
                    );
                    largest = largest.max(torque.abs() / (relative() * 0.02 * pressed));
                }
                let spring = touch.energy(&law, RADII) - without.energy(&plain, RADII);
                let expected = roll.stored_energy(resistance);
                assert!((spring - expected).abs() <= 1e-12 * touch.energy(&law, RADII));
                assert_eq!(touch.load(&law, &one, &two).unwrap(), load);
            }
            assert!(heats.rolling > 0.0 && unrolled.rolling == 0.0);
            assert_eq!([heats.friction, heats.damping], [unrolled.friction, unrolled.damping]);
            assert!(largest > 0.5 && largest < 1.0 + 1e-12, "it comes to its limit: {largest}");
        }
    }
}

#[test]
fn a_resistance_that_cannot_be_is_named() {
    for (rolling, field) in [
        (CaromRolling { stiffness: -1.0, ..ROLLING }, "rolling.stiffness"),
        (CaromRolling { damping: f64::NAN, ..ROLLING }, "rolling.damping"),
        (CaromRolling { friction: f64::INFINITY, ..ROLLING }, "rolling.friction"),
    ] {
        let told =
            Made::new([GLASS; 2], 0.3, &CaromLawOptions { rolling, ..options(0) }).err().unwrap();
        assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, field));
    }
    let told =
        Made::new([GLASS; 2], 0.3, &CaromLawOptions { torsion: 2, ..options(0) }).err().unwrap();
    assert_eq!((told.status, told.field.as_str()), (CaromStatus::OutOfRange, "torsion"));
    // Its numbers are checked where they are read, those of a twist too.
    let its = CaromLawOptions { torsion: 1, rolling: ROLLING, ..options(0) };
    let law = Made::new([GLASS; 2], 0.3, &its).unwrap();
    let mut touch = law.touch();
    let two = Second::Grain(body(-1.0, RADII[1], [0.0, 1.0, 0.3]));
    touch.step(&law, &body(1.0, RADII[0], [0.5; 3]), &two, DT);
    let numbers = touch.packed(&law);
    for (at, wrong) in [(82, f64::NAN), (165, f64::NAN), (168, 2.0), (171, f64::INFINITY)] {
        let mut bad = numbers.clone();
        bad[at] = wrong;
        assert_eq!(Touch::unpacked(&law, RADII, &bad).unwrap_err().status, CaromStatus::BadState);
    }
}
