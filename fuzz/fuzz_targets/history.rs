//! A path of any shifts for each law: forces within the Coulomb limit, no NaN, packed states that come back to the
//! bit, and failed steps that leave the state as it was.
#![no_main]

mod followed;

use carom_fuzz::Bytes;
use carom_laws::coulomb::Tolerance;
use carom_laws::friction::Friction;
use carom_laws::memory::Fixed;
use carom_laws::rings::{self, RingConstants, RingLaw};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::static_friction::StaticFriction;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::law::{ShiftTwistLaw, TorsionConstants, TorsionLaw};
use carom_laws::turning_law::TurningLaw;
use followed::{Limits, follow};
use libfuzzer_sys::fuzz_target;

/// Relative error of the forces of rings, by their tolerance.
const OF_RINGS: f64 = 1e-2;

/// A law in the plane, its memory of fixed size.
type Particle = ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>;

fuzz_target!(|bytes: &[u8]| {
    let mut bytes = Bytes::new(bytes);
    // Numbers that no law accepts end it.
    let _ = path(&mut bytes);
});

fn path(bytes: &mut Bytes<'_>) -> Option<()> {
    let law = bytes.pick(10);
    let (friction, stiffness) = (friction(bytes)?, stiffness(bytes)?);
    let tolerance = Tolerance::new([0.1, 1e-2, 1e-3, 1e-4][bytes.pick(4)]).ok()?;
    let limits = Limits::of(friction, stiffness.c_z);
    let turning = TurningLaw::ALL[law % 2];
    match law {
        0 | 1 => follow(
            ShiftLaw::<[f64; 2]>::chosen(turning, stiffness, friction, tolerance),
            bytes,
            limits,
        ),
        2 | 3 => {
            let friction = with_threshold(friction, bytes)?;
            let limits = Limits::of(friction.threshold(), stiffness.c_z);
            let law =
                ShiftLaw::<[f64; 2]>::with_static_friction(turning, stiffness, friction, tolerance);
            follow(law, bytes, limits);
        }
        4 => follow(ShiftLaw::<f64>::new(stiffness, friction), bytes, limits),
        5 => {
            let friction = with_threshold(friction, bytes)?;
            let limits = Limits::of(friction.threshold(), stiffness.c_z);
            let law =
                ShiftLaw::<f64>::with_static_friction(turning, stiffness, friction, tolerance);
            follow(law, bytes, limits);
        }
        6 => follow(Particle::new(stiffness, friction), bytes, limits),
        7 | 8 => {
            let (torsion, arm) = torsion(friction, stiffness.c_z, bytes)?;
            let limits = Limits { arm, ..limits };
            if law == 7 {
                follow(torsion, bytes, limits);
            } else {
                let shift = ShiftLaw::chosen(TurningLaw::Coulomb, stiffness, friction, tolerance);
                follow(ShiftTwistLaw::of(shift, torsion).ok()?, bytes, limits);
            }
        }
        _ => {
            let (law, normal) = ring_law(friction, stiffness.c_z, bytes)?;
            follow(law, bytes, Limits { normal, ..limits });
        }
    }
    Some(())
}

fn friction(bytes: &mut Bytes<'_>) -> Option<Friction> {
    let coefficient = match bytes.pick(8) {
        0 => 0.0,
        1 => f64::INFINITY,
        2 => bytes.number(1.0),
        usual => 0.1 * usual as f64,
    };
    Friction::new(coefficient).ok()
}

fn with_threshold(kinetic: Friction, bytes: &mut Bytes<'_>) -> Option<StaticFriction> {
    let more = f64::from(bytes.byte()) / 64.0;
    StaticFriction::new(Friction::new(kinetic.get() * (1.0 + more)).ok()?, kinetic).ok()
}

fn stiffness(bytes: &mut Bytes<'_>) -> Option<ContactStiffness> {
    let [c_x, c_y, c_z] = match bytes.pick(4) {
        0 | 1 => [1.0, 1.0, 1.2],
        2 => [0.8, 1.1, 1.2],
        _ => std::array::from_fn(|_| bytes.number(1.0)),
    };
    ContactStiffness::new(c_x, c_y, c_z).ok()
}

/// The law of twist with its arm.
fn torsion(friction: Friction, c_z: f64, bytes: &mut Bytes<'_>) -> Option<(TorsionLaw, f64)> {
    let [stiffness, arm] = match bytes.pick(4) {
        0..=2 => [1.3, 0.6],
        _ => std::array::from_fn(|_| bytes.number(1.0)),
    };
    let law =
        TorsionLaw::from_constants(TorsionConstants { c_z, stiffness, arm }, friction).ok()?;
    Some((law, arm))
}

/// The law of rings, and the least and the greatest normal force, over that of Hertz.
fn ring_law(friction: Friction, c_z: f64, bytes: &mut Bytes<'_>) -> Option<(RingLaw, [f64; 2])> {
    // Few materials, whose matrices are kept.
    let kappa = [1.0, 1.2, 1.5][bytes.pick(3)];
    let gamma: f64 = [0.0, 0.1, -0.1, 0.3][bytes.pick(4)];
    let constants = RingConstants { c_z, radius: 1.0, kappa, gamma };
    let law = RingLaw::from_constants(constants, friction, rings::Tolerance::PARTICLES).ok()?;
    Some((law, normal_forces(friction, gamma.abs())))
}

/// By reciprocity a radial traction adds at most `2 gamma/pi` times itself to the normal force: the radial displacement of
/// a rigid punch of unit approach is `(2 gamma/pi) (a - sqrt(a^2 - r^2))/r`. All tractions together are at most f F_z.
/// Much friction may part a part of the contact, whose tension is left out: then there is no upper bound. Without slip
/// the contact is at most as stiff as punches that stick.
fn normal_forces(friction: Friction, gamma: f64) -> [f64; 2] {
    let Some(f) = friction.coefficient() else {
        return [1.0, if gamma > 0.0 { gamma.atanh() / gamma } else { 1.0 }];
    };
    if gamma == 0.0 || f == 0.0 {
        return [1.0; 2];
    }
    let share = std::f64::consts::FRAC_2_PI * f * gamma;
    let most = if f > 1.0 { f64::INFINITY } else { (1.0 + OF_RINGS) / (1.0 - share) };
    [(1.0 - OF_RINGS) / (1.0 + share), most]
}
