//! Bodies that are apart exert no force, with any law and damping.

use super::*;
use crate::hostile::Random;

/// Of the contacts that have ended before.
const OVERLAP: f64 = 1e-6;

/// Laws of steel against glass: each with torsion and rolling, damped by a relaxation, a restitution, or not.
fn laws() -> Vec<Made> {
    let mut all = Vec::new();
    for law in LAWS {
        for [relaxation, restitution] in [[0.0, 0.0], [1e-6, 0.0], [0.0, 0.7]] {
            let plain = CaromLawOptions { relaxation, restitution, ..options(law) };
            for its in [plain, CaromLawOptions { torsion: 1, rolling: ROLLING, ..plain }] {
                all.push(Made::new([STEEL, GLASS], 0.3, &its).unwrap());
            }
        }
    }
    all
}

/// Body 1 above a grain and a wall, with a gap, or an overlap if it is negative, in any motion; and a time step.
fn drawn(random: &mut Random, gap: f64) -> (CaromGrain, [Second; 2], f64) {
    let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
    let mut vector = |size: f64| [0; 3].map(|_: i32| between(-size, size));
    let normal = loop {
        let v = vector(1.0);
        let length = dot(v, v).sqrt();
        if length > 0.1 {
            break v.map(|c| c / length);
        }
    };
    let [velocity_1, velocity, spin_1, spin] = [10.0, 10.0, 300.0, 300.0].map(&mut vector);
    let radii = [between(1e-4, 1e-2), between(1e-4, 1e-2)];
    let dt = 10_f64.powf(between(-9.0, -4.0));
    let at = |distance: f64| normal.map(|c| c * distance);
    let light = |grain| CaromGrain { mass: 1e-5, ..grain };
    let one = light(grain(at(radii[0] + gap), velocity_1, spin_1, radii[0]));
    let two = light(grain(at(-radii[1]), velocity, spin, radii[1]));
    let on = CaromSurface { place: [0.0; 3], normal, velocity, spin, axis: [0.0; 3] };
    (one, [Second::Grain(two), Second::Wall(on)], dt)
}

/// Ten thousand pairs with gaps from a millionth of a radius to a kilometre, half of them after a contact that has
/// ended: no force, no torque, no heat; bodies that have not touched leave no trace.
#[test]
fn bodies_apart_exert_no_force() {
    let (mut random, laws) = (Random::Seed(59), laws());
    let (none, mut pressed, mut parted) = (CaromGrainLoad::default(), 0, 0);
    for draw in 0..10_000 {
        let law = &laws[draw % laws.len()];
        let gap = 1e-9 * 10_f64.powf(12.0 * random.unit());
        let (is_accounted, has_touched) = (random.below(2) == 0, random.below(2) == 0);
        let mut touches = [law.touch(), law.touch()];
        let step = |touches: &mut [Touch; 2],
                    (one, seconds, dt): (CaromGrain, [Second; 2], f64)| {
            let mut heats = CaromHeats::default();
            let loads = [0, 1].map(|i| {
                let sums = is_accounted.then_some(&mut heats);
                touches[i].tried(law, (&one, &seconds[i]), dt, sums).unwrap()
            });
            (loads, heats)
        };
        if has_touched {
            let (one, seconds, _) = drawn(&mut random, -OVERLAP);
            let (loads, _) = step(&mut touches, (one, seconds, 1e-7));
            // Damped bodies that recede fast bear nothing, and so have no friction, before they part.
            pressed += usize::from(loads.iter().all(|load| load.force != [0.0; 3]));
            // The step in which they part may set energy free.
            let (loads, _) = step(&mut touches, drawn(&mut random, gap));
            assert_eq!(loads, [none; 2], "{draw}");
            parted += 1;
        }
        for _ in 0..2 {
            let (one, seconds, dt) = drawn(&mut random, gap);
            let (loads, heats) = step(&mut touches, (one, seconds, dt));
            assert_eq!(loads, [none; 2], "{draw}, gap {gap:e}");
            assert!(has_touched || heats == CaromHeats::default(), "{draw} {heats:?}");
            assert!(has_touched || touches.iter().all(Touch::is_new), "{draw}");
            for (touch, second) in touches.iter().zip(&seconds) {
                assert_eq!(touch.load(law, &one, second), Ok(none), "{draw}");
                let energy = touch.energy(law, [one.radius, second.radius()]);
                assert_eq!(energy, 0.0, "{draw}");
            }
        }
    }
    assert!(pressed > 3000 && parted > 4000, "{pressed} of {parted} were pressed");
}
