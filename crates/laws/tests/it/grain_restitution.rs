//! Grains rebound with the restitution that was given.

use carom_laws::damping::HertzDamping;
use carom_laws::friction::Friction;
use carom_laws::grains::{
    Grain, GrainContact, GrainLoad, Heats, Meeting, Touching, Wall, advance_together,
};
use carom_laws::memory::Fixed;
use carom_laws::rings::{RingConstants, RingLaw, Tolerance};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;

type Contact = GrainContact<ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>>;

const C_Z: f64 = 3.0;
const MASSES: [f64; 2] = [0.7, 1.9];

fn contact(restitution: f64, friction: f64) -> Contact {
    let stiffness = ContactStiffness::new(2.5, 2.5, C_Z).unwrap();
    let law = ShiftLaw::new(stiffness, Friction::new(friction).unwrap());
    let damping = HertzDamping::of_restitution(restitution).unwrap();
    GrainContact::new(law, 0.0).unwrap().with_restitution(damping).unwrap()
}

/// Two spheres that approach along z with the speed `speed`, the second below; slip and spin as given.
fn meeting_grains(speed: f64, slip: f64, spin: f64) -> [Grain; 2] {
    let [one, two] = MASSES;
    let below = Grain {
        place: [0.0; 3],
        velocity: [0.0, 0.0, speed * one / (one + two)],
        spin: [0.0, spin, 0.3 * spin],
        radius: 1.0,
        mass: two,
    };
    let above = Grain {
        place: [0.0, 0.0, 2.0],
        velocity: [slip, 0.0, -speed * two / (one + two)],
        mass: one,
        ..below
    };
    [above, below]
}

/// The duration of an elastic impact: 2.9432 (m^2/(K^2 v))^(1/5).
fn duration(speed: f64) -> f64 {
    let mass = 1.0 / (1.0 / MASSES[0] + 1.0 / MASSES[1]);
    2.943_275 * ((mass / (2.0 / 3.0 * C_Z)).powi(2) / speed).powf(0.2)
}

fn kinetic(grains: &[Grain; 2]) -> f64 {
    let square = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>();
    grains.iter().map(|g| 0.5 * g.mass * (square(g.velocity) + 0.4 * square(g.spin))).sum()
}

/// Velocity Verlet until the grains part; `load` makes a step of the contact.
fn rebound(grains: &mut [Grain; 2], dt: f64, mut load: impl FnMut(&[Grain; 2], f64) -> GrainLoad) {
    let mut exerted = GrainLoad::default();
    let kick = |grains: &mut [Grain; 2], load: &GrainLoad| {
        for (i, sign) in [(0, 1.0), (1, -1.0)] {
            let grain = &mut grains[i];
            for k in 0..3 {
                grain.velocity[k] += sign * load.force[k] * 0.5 * dt / grain.mass;
                grain.spin[k] += load.torques[i][k] * 0.5 * dt / (0.4 * grain.mass);
            }
        }
    };
    for step in 0..100_000 {
        kick(grains, &exerted);
        for grain in grains.iter_mut() {
            for k in 0..3 {
                grain.place[k] += grain.velocity[k] * dt;
            }
        }
        let way: f64 = (0..3).map(|k| (grains[0].place[k] - grains[1].place[k]).powi(2)).sum();
        if way.sqrt() >= 2.0 && step > 3 {
            load(grains, dt);
            return;
        }
        exerted = load(grains, dt);
        kick(grains, &exerted);
    }
    panic!("they stay in contact");
}

/// Part of a step by which the first contact lies before the end of the first step in contact: any.
fn started(mut grains: [Grain; 2], dt: f64, part: f64) -> [Grain; 2] {
    let closing = grains[1].velocity[2] - grains[0].velocity[2];
    grains[0].place[2] += part * dt * closing;
    grains
}

fn closing(grains: &[Grain; 2]) -> f64 {
    let way = [0, 1, 2].map(|k| grains[0].place[k] - grains[1].place[k]);
    let length = way.iter().map(|c| c * c).sum::<f64>().sqrt();
    (0..3).map(|k| (grains[1].velocity[k] - grains[0].velocity[k]) * way[k] / length).sum()
}

/// Fifty steps in an elastic impact, four decades of speed, with friction and spin: e to 1e-3.
#[test]
fn the_restitution_given_is_the_one_got_at_any_speed() {
    for restitution in [0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.95, 1.0] {
        for speed in [1e-9, 1e-8, 1e-7, 1e-6, 1e-5] {
            for (friction, slip) in [(0.0, 0.0), (0.3, 0.5)] {
                for part in [0.0, 0.25, 0.5, 0.75] {
                    let dt = duration(speed) / 50.0;
                    let grains = meeting_grains(speed, slip * speed, slip * speed);
                    let mut grains = started(grains, dt, part);
                    let mut contact = contact(restitution, friction);
                    rebound(&mut grains, dt, |grains, dt| {
                        let meeting =
                            Meeting::of_spheres(&grains[0], &grains[1], [0.5; 2]).unwrap();
                        contact.advance(&meeting, dt).unwrap()
                    });
                    let got = -closing(&grains) / speed;
                    assert!(
                        (got - restitution).abs() < 1e-3,
                        "{restitution} {speed} {friction} {part}: {got}"
                    );
                }
            }
        }
    }
}

/// What the books of an impact miss, over its energy: the mean over all places in a step of first contact, and the
/// deviation from it.
fn missed(steps: f64, fresh: &dyn Fn() -> Contact, slip: f64) -> [f64; 2] {
    const PLACES: usize = 64;
    let speed = 1e-4;
    let dt = duration(speed) / steps;
    let off: Vec<f64> = (0..PLACES)
        .map(|n| {
            let grains = meeting_grains(speed, slip * speed, 0.5 * slip * speed);
            let mut grains = started(grains, dt, (n as f64 + 0.5) / PLACES as f64);
            let before = kinetic(&grains);
            let (mut contact, mut heats) = (fresh(), Heats::default());
            rebound(&mut grains, dt, |grains, dt| {
                let meeting = Meeting::of_spheres(&grains[0], &grains[1], [0.5; 2]).unwrap();
                contact.advance_accounted(&meeting, dt, &mut heats).unwrap()
            });
            (kinetic(&grains) + heats.damping + heats.friction) / before - 1.0
        })
        .collect();
    let mean = off.iter().sum::<f64>() / PLACES as f64;
    let square = off.iter().map(|off| (off - mean).powi(2)).sum::<f64>() / PLACES as f64;
    [mean, square.sqrt()]
}

/// Books by the mean of two forces times the speed of the step miss 4e-4 of each impact with 50 steps, always on the
/// same side. The force of a viscous material has a jump of its second derivative where the bodies turn back: its books
/// are of the third order there.
#[test]
fn the_heat_of_damping_is_of_the_fourth_order_in_the_mean() {
    let viscous = || {
        let stiffness = ContactStiffness::new(2.5, 2.5, C_Z).unwrap();
        let law = ShiftLaw::new(stiffness, Friction::new(0.0).unwrap());
        GrainContact::new(law, 0.03 * duration(1e-4)).unwrap()
    };
    let given = |restitution: f64| move || contact(restitution, 0.0);
    let fresh: [(&dyn Fn() -> Contact, f64, f64); 4] = [
        (&given(0.2), 5e-6, 0.1),
        (&given(0.5), 5e-6, 0.1),
        (&given(0.8), 5e-6, 0.1),
        (&viscous, 6e-7, 0.125),
    ];
    for (fresh, most, share) in fresh {
        let [coarse, fine] = [50.0, 100.0].map(|steps| missed(steps, fresh, 0.0));
        let told = format!("{coarse:?} {fine:?}");
        assert!(coarse[0].abs() < most && fine[0].abs() < share * coarse[0].abs(), "{told}");
        assert!(coarse[1] < 5e-5 && fine[1] < 1e-5, "{told}");
    }
}

/// The energy that is lost is booked: kinetic energy lost = friction heat + damping heat, to round-off of the steps.
#[test]
fn the_energy_lost_is_booked_as_damping() {
    for (restitution, friction) in [(0.3, 0.0), (0.3, 0.4), (0.9, 0.4)] {
        let speed = 1e-4;
        let mut grains = meeting_grains(speed, 0.4 * speed, 0.2 * speed);
        let (before, dt) = (kinetic(&grains), duration(speed) / 400.0);
        let (mut contact, mut heats) = (contact(restitution, friction), Heats::default());
        rebound(&mut grains, dt, |grains, dt| {
            let meeting = Meeting::of_spheres(&grains[0], &grains[1], [0.5; 2]).unwrap();
            contact.advance_accounted(&meeting, dt, &mut heats).unwrap()
        });
        let lost = before - kinetic(&grains);
        assert!(heats.damping > 0.0 && (friction == 0.0) == (heats.friction == 0.0));
        let booked = heats.damping + heats.friction;
        assert!((lost - booked).abs() < 2e-4 * before, "{restitution} {friction}: {lost} {booked}");
    }
}

/// Spheres in four lanes, a law of rings, and a wall (of infinite mass) have the same restitution.
#[test]
fn lanes_rings_and_walls_rebound_alike() {
    let (restitution, speed) = (0.4, 1e-4);
    let dt = duration(speed) / 60.0;
    let mut alone = meeting_grains(speed, 0.3 * speed, 0.0);
    let mut single = contact(restitution, 0.3);
    rebound(&mut alone, dt, |grains, dt| {
        let meeting = Meeting::of_spheres(&grains[0], &grains[1], [0.5; 2]).unwrap();
        single.advance(&meeting, dt).unwrap()
    });
    let mut many = meeting_grains(speed, 0.3 * speed, 0.0);
    let mut four = [contact(restitution, 0.3); 4];
    rebound(&mut many, dt, |grains, dt| {
        let mut loads = [GrainLoad::default(); 4];
        let mut lent = loads.iter_mut();
        let mut pairs = four.each_mut().map(|contact| Touching {
            contact,
            bodies: [&grains[0], &grains[1]],
            shares: [0.5; 2],
            rolling: None,
            load: lent.next().unwrap(),
        });
        advance_together(&mut pairs, dt, |_| ()).unwrap();
        assert!(loads.iter().all(|load| *load == loads[0]));
        loads[0]
    });
    assert_eq!(alone, many);

    let constants = RingConstants { c_z: C_Z, radius: 0.7, kappa: 1.2, gamma: 0.25 };
    let friction = Friction::new(0.3).unwrap();
    let law = RingLaw::<6, 8>::from_constants(constants, friction, Tolerance::PARTICLES).unwrap();
    let damping = HertzDamping::of_restitution(restitution).unwrap();
    let mut contact = GrainContact::new(law, 0.0).unwrap().with_restitution(damping).unwrap();
    let mut grains = meeting_grains(speed, 0.0, 0.0);
    rebound(&mut grains, dt, |grains, dt| {
        let meeting = Meeting::of_spheres(&grains[0], &grains[1], [0.5; 2]).unwrap();
        contact.advance(&meeting, dt).unwrap()
    });
    let got = -closing(&grains) / speed;
    // Friction between the dissimilar materials takes a little more.
    assert!((got - restitution).abs() < 4e-4, "{got}");

    let wall = Wall { place: [0.0, 0.0, 1.0], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
    let mut grains = meeting_grains(speed, 0.0, 0.0);
    grains[0].velocity[2] = -speed;
    grains[1] = Grain { velocity: [0.0; 3], mass: f64::INFINITY, ..grains[1] };
    let mut contact = self::contact(restitution, 0.3);
    let dt = dt * (MASSES[0] * (1.0 / MASSES[0] + 1.0 / MASSES[1])).powf(0.4);
    rebound(&mut grains, dt, |grains, dt| {
        contact.advance(&Meeting::on_wall(&grains[0], &wall, 1.0), dt).unwrap()
    });
    let got = grains[0].velocity[2] / speed;
    assert!((got - restitution).abs() < 2e-4, "{got}");
}

#[test]
fn masses_are_checked_where_a_restitution_needs_them() {
    let [mut above, mut below] = meeting_grains(1.0, 0.0, 0.0);
    let told = |one: &Grain, two: &Grain| {
        Meeting::of_spheres(one, two, [0.5; 2])
            .unwrap()
            .check_masses()
            .map_err(|e| (e.field, e.value))
    };
    assert!(told(&above, &below).is_ok());
    below.mass = f64::INFINITY;
    assert!(told(&above, &below).is_ok());
    above.mass = 0.0;
    assert_eq!(told(&above, &below), Err(("mass", 0.0)));
    above.mass = f64::INFINITY;
    assert_eq!(told(&above, &below), Err(("mass", f64::INFINITY)));
}
