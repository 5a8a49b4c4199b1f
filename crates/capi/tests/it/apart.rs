//! Bodies that are apart exert no force, at any entry point for two bodies, with any law and damping.

use std::mem::zeroed;
use std::ptr::null_mut;

use carom_capi::*;

use super::grains::{error, text};
use super::hostile::Random;

const GLASS: CaromMaterial =
    CaromMaterial { young_modulus: 70e9, poisson: 0.22, yield_stress: 0.0 };
const STEEL: CaromMaterial =
    CaromMaterial { young_modulus: 210e9, poisson: 0.3, yield_stress: 0.0 };
const ROLLING: CaromRolling = CaromRolling { stiffness: 3e4, damping: 20.0, friction: 0.02 };
/// Of the contacts that have ended before.
const OVERLAP: f64 = 1e-6;

/// Constants of steel against glass, damped by a relaxation, a restitution, or not.
fn constants(law: u32, damping: usize) -> CaromGrains {
    // SAFETY: plain numbers; all pointers are references or null.
    unsafe {
        let mut grains = zeroed();
        let relaxation = if damping != 1 { 0.0 } else { 1e-6 };
        let to = &raw mut grains;
        let status = carom_grains_of(&STEEL, &GLASS, 0.3, law, 0.0, relaxation, to, null_mut());
        assert_eq!(status, CaromStatus::Ok);
        if damping == 2 {
            assert_eq!(carom_grains_restitution(to, 0.7, null_mut()), CaromStatus::Ok);
        }
        grains
    }
}

/// All that remembers a contact.
#[derive(Clone, Copy)]
struct Memories {
    touch: CaromTouch,
    rings: CaromRingTouch,
    twist: CaromTwist,
    roll: CaromRoll,
}

impl Memories {
    fn new() -> Self {
        // SAFETY: zero bytes stand for bodies that are apart.
        unsafe { zeroed() }
    }

    fn are_new(&self) -> bool {
        self.touch.mark == 0
            && self.rings.mark == 0
            && self.twist.numbers.iter().all(|number| *number == 0.0)
            && self.roll == CaromRoll::default()
    }
}

/// Body 1 above body 2, which is a grain or a wall below.
#[derive(Clone, Copy)]
struct Pair {
    one: CaromGrain,
    two: CaromGrain,
    surface: CaromSurface,
    dt: f64,
}

impl Pair {
    /// Two bodies with a gap, or an overlap if it is negative, of any motion.
    fn drawn(random: &mut Random, gap: f64) -> Self {
        let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
        let mut vector = |size: f64| [0; 3].map(|_: i32| between(-size, size));
        let normal = loop {
            let v = vector(1.0);
            let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
            if length > 0.1 {
                break v.map(|c| c / length);
            }
        };
        let [velocity_1, velocity_2] = [vector(10.0), vector(10.0)];
        let [spin_1, spin_2] = [vector(300.0), vector(300.0)];
        let radii = [between(1e-4, 1e-2), between(1e-4, 1e-2)];
        let dt = 10_f64.powf(between(-9.0, -4.0));
        let grain = |distance: f64, velocity, spin, radius| CaromGrain {
            place: normal.map(|c| c * distance),
            velocity,
            spin,
            radius,
            mass: 1e-5,
        };
        let [above, below] = [radii[0] + gap, -radii[1]];
        let surface = CaromSurface {
            place: [0.0; 3],
            normal,
            velocity: velocity_2,
            spin: spin_2,
            axis: [0.0; 3],
        };
        Self {
            one: grain(above, velocity_1, spin_1, radii[0]),
            two: grain(below, velocity_2, spin_2, radii[1]),
            surface,
            dt,
        }
    }
}

/// What all entry points exert in one step of this pair, in their order, and the heats that they book.
fn exerted(
    ([grains, ringed], rings): ([&CaromGrains; 2], *mut CaromRings),
    pair: &Pair,
    memories: &mut [Memories; 3],
    is_accounted: bool,
) -> (Vec<CaromGrainLoad>, [f64; 3]) {
    let Pair { one, two, surface, dt } = pair;
    let wall =
        CaromWall { place: surface.place, normal: surface.normal, velocity: surface.velocity };
    let (mut heats, mut heat, mut loads) = (CaromHeats::default(), 0.0, Vec::new());
    let [by_grains, by_wall, by_surface] = memories;
    let sums = if is_accounted { &raw mut heats } else { null_mut() };
    let mut why = error();
    let none = &raw mut why;
    let mut call = |made: &mut dyn FnMut(*mut CaromGrainLoad) -> CaromStatus| {
        let mut load = CaromGrainLoad::default();
        let status = made(&raw mut load);
        // SAFETY: written by the call before.
        assert_eq!(status, CaromStatus::Ok, "{}", text(unsafe { &*none }));
        loads.push(load);
    };
    macro_rules! calls {
        ($at:ident, $other:expr, $touch:ident, $rings:ident, $twist:ident) => {
            // SAFETY: all pointers are references or null, and the rings are those of the constants.
            call(&mut |to| unsafe { $touch(grains, &raw mut $at.touch, one, $other, *dt, to, sums, none) });
            call(&mut |to| unsafe {
                $rings(ringed, rings, &raw mut $at.rings, one, $other, *dt, to, sums, none)
            });
            call(&mut |to| unsafe { $twist(grains, &raw mut $at.twist, one, $other, *dt, to, sums, none) });
        };
    }
    use {
        carom_ring_touch_grains as ring_grains, carom_ring_touch_surface as ring_surface,
        carom_ring_touch_wall as ring_wall, carom_touch_grains as touch_grains,
        carom_touch_surface as touch_surface, carom_touch_twist_grains as twist_grains,
        carom_touch_twist_surface as twist_surface, carom_touch_twist_wall as twist_wall,
        carom_touch_wall as touch_wall,
    };
    calls!(by_grains, two, touch_grains, ring_grains, twist_grains);
    calls!(by_wall, &wall, touch_wall, ring_wall, twist_wall);
    calls!(by_surface, surface, touch_surface, ring_surface, twist_surface);
    let to_heat = if is_accounted { &raw mut heat } else { null_mut() };
    let roll = &raw mut by_grains.roll;
    // SAFETY: as above.
    call(&mut |to| unsafe {
        carom_touch_roll_grains(grains, &ROLLING, roll, one, two, *dt, to, to_heat, none)
    });
    let roll = &raw mut by_surface.roll;
    call(&mut |to| unsafe {
        carom_touch_roll_surface(grains, &ROLLING, roll, one, surface, *dt, to, to_heat, none)
    });
    (loads, [heats.friction, heats.damping, heat])
}

/// The loads without a step.
fn standing(
    ([grains, ringed], rings): ([&CaromGrains; 2], *mut CaromRings),
    pair: &Pair,
    memories: &Memories,
) -> [CaromGrainLoad; 2] {
    let mut loads = [CaromGrainLoad::default(); 2];
    let [by_touch, by_rings] = &mut loads;
    let (one, two, none) = (&pair.one, &pair.two, null_mut());
    // SAFETY: as in `exerted`.
    unsafe {
        let touch = &raw const memories.touch;
        let status = carom_touch_grains_load(grains, touch, one, two, by_touch, none);
        assert_eq!(status, CaromStatus::Ok);
        let touch = &raw const memories.rings;
        let status = carom_ring_touch_grains_load(ringed, rings, touch, one, two, by_rings, none);
        assert_eq!(status, CaromStatus::Ok);
    }
    loads
}

/// Ten thousand pairs with gaps from a millionth of a radius to a kilometre, half of them after a contact that has
/// ended: no force, no torque, no heat; bodies that have not touched leave no trace.
#[test]
fn bodies_apart_exert_no_force() {
    let mut random = Random::Seed(59);
    let laws = [CAROM_LAW_FIXED_DIRECTION, CAROM_LAW_COULOMB, CAROM_LAW_RINGS];
    let made = laws.map(|law| [0, 1, 2].map(|damping| constants(law, damping)));
    let mut rings = null_mut();
    // SAFETY: all pointers are references or null.
    let status = unsafe { carom_rings_of(&raw const made[2][0].unit, &raw mut rings, null_mut()) };
    assert_eq!(status, CaromStatus::Ok);
    let (mut pressed, mut parted) = (0, 0);
    for draw in 0..10_000 {
        let (law, damping) = (random.below(2), random.below(3));
        let constants = ([&made[law][damping], &made[2][damping]], rings);
        let gap = 1e-9 * 10_f64.powf(12.0 * random.unit());
        let is_accounted = random.below(2) == 0;
        let mut memories = [Memories::new(); 3];
        let has_touched = random.below(2) == 0;
        if has_touched {
            let pair = Pair { dt: 1e-7, ..Pair::drawn(&mut random, -OVERLAP) };
            let (loads, _) = exerted(constants, &pair, &mut memories, is_accounted);
            let is_pressed = loads.iter().filter(|load| load.force != [0.0; 3]).count() == 6;
            // Damped bodies that recede fast bear nothing, and so have no friction, before they part.
            assert!(is_pressed || damping > 0, "{draw} {loads:?}");
            pressed += usize::from(is_pressed);
            // The step in which they part may set energy free.
            let pair = Pair::drawn(&mut random, gap);
            let (loads, _) = exerted(constants, &pair, &mut memories, is_accounted);
            assert!(
                loads.iter().all(|load| *load == CaromGrainLoad::default()),
                "{draw} {loads:?}"
            );
            parted += 1;
        }
        for _ in 0..2 {
            let pair = Pair::drawn(&mut random, gap);
            let (loads, heats) = exerted(constants, &pair, &mut memories, is_accounted);
            for (call, load) in loads.iter().enumerate() {
                assert_eq!(*load, CaromGrainLoad::default(), "{draw}, entry {call}, gap {gap:e}");
            }
            assert!(has_touched || heats == [0.0; 3], "{draw} {heats:?}");
            assert!(has_touched || memories.iter().all(Memories::are_new), "{draw}");
            let standing = standing(constants, &pair, &memories[0]);
            assert_eq!(standing, [CaromGrainLoad::default(); 2], "{draw}");
        }
    }
    assert!(pressed > 3000 && parted > 4000, "{pressed} of {parted} were pressed");
    // SAFETY: made by `carom_rings_of`.
    unsafe { carom_rings_free(rings) };
}
