//! Single steps of grains: the first and the last.

use carom_halfspace::{Material, MaterialPair};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::friction::Friction;
use carom_laws::grains::{
    Grain, GrainContact, GrainLoad, GrainTwist, Heats, Meeting, Surface, Touching, Wall,
    advance_together,
};
use carom_laws::hertz::Hertz;
use carom_laws::law::ContactLaw as _;
use carom_laws::memory::Fixed;
use carom_laws::rings::{RingConstants, RingLaw, Tolerance};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;
use carom_laws::torsion::law::TorsionLaw;

const FRICTION: f64 = 0.4;
const C_Z: f64 = 2.3;
const RADIUS: f64 = 1.0;

fn contact(
    friction: f64,
    relaxation: f64,
) -> GrainContact<ShiftLaw<[f64; 2], Fixed<[f64; 2], 12>>> {
    let stiffness = ContactStiffness::new(1.9, 1.9, C_Z).unwrap();
    let law = ShiftLaw::new(stiffness, Friction::new(friction).unwrap());
    GrainContact::new(law, relaxation).unwrap()
}

/// A grain so deep in a wall at z = 0, with the velocity of both.
fn on_wall(zeta: f64, grain: [f64; 3], spin: [f64; 3], wall: [f64; 3]) -> Meeting {
    let place = [0.0, 0.0, RADIUS - zeta];
    let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: wall };
    Meeting::on_wall(&Grain { place, velocity: grain, spin, radius: RADIUS, mass: 1.0 }, &wall, 0.5)
}

/// In sliding the friction at an approach is (2/3) f c_z zeta^(3/2). A step that ends shortly before the
/// bodies part has its mean over half a step before and half a step beyond, by trapezoids between those three places.
/// The last step in contact also has what is left of that mean for the step in which they part, which has none.
#[test]
fn friction_of_parting_grains_is_the_mean_over_a_step() {
    let (dt, parting, along) = (0.01, 0.7, 3.0);
    let mut contact = contact(FRICTION, 0.0);
    let sliding = |zeta: f64| {
        let zeta = zeta.max(0.0);
        2.0 / 3.0 * FRICTION * C_Z * zeta * zeta.sqrt()
    };
    let mut means = 0;
    // Sliding from the first touch on: pressed, then receding at a constant speed.
    let mut zeta = -0.004;
    let mut speed = 2.0;
    for step in 0..60 {
        if step == 12 {
            speed = -parting;
        }
        zeta += speed * dt;
        if zeta < -0.9 * parting * dt {
            break;
        }
        let meeting = on_wall(zeta, [0.0, 0.0, -speed], [0.0; 3], [along, 0.0, 0.0]);
        let load = contact.advance(&meeting, dt).unwrap();
        let now = sliding(zeta);
        let half = 0.5 * speed * dt;
        let left = if zeta + speed * dt > 0.0 { 0.25 } else { 0.5 };
        let mean = 0.5 * now + 0.25 * sliding(zeta - half) + left * sliding(zeta + half);
        let mean = if zeta > 0.0 { mean } else { 0.0 };
        let is_mean = (load.force[0] - mean).abs() < 1e-13;
        assert!(is_mean || (load.force[0] - now).abs() < 1e-13, "{step}: {load:?}, {now} {mean}");
        assert!(load.force[1].abs() < 1e-13);
        if zeta < parting * dt && speed < 0.0 {
            let differs = zeta < 0.0 || (now - mean).abs() > 1e-6;
            assert!(is_mean && differs, "{step}: {} {mean}", load.force[0]);
            means += 1;
        }
    }
    assert!(means >= 2, "{means}");
}

/// A grain that is pressed, pulled and parted, and the same turned about the normal by a right angle: the axes of the
/// contact stay, so that what was along one of them is along the other.
#[test]
fn a_scene_turned_about_the_normal_has_its_loads_turned() {
    let turned = |[x, y, z]: [f64; 3]| [-y, x, z];
    let constants = RingConstants { c_z: C_Z, radius: RADIUS, kappa: 1.2, gamma: 0.25 };
    let friction = Friction::new(FRICTION).unwrap();
    let law = RingLaw::<6, 8>::from_constants(constants, friction, Tolerance::PARTICLES).unwrap();
    let ring = GrainContact::new(law, 0.1).unwrap();
    let [mut sticks, mut slips] =
        [f64::INFINITY, FRICTION].map(|f| [(); 2].map(|()| contact(f, 0.1)));
    let mut by_rings = [ring.clone(), ring];
    let (dt, mut zeta, mut friction) = (0.01, 0.0, 0.0_f64);
    for step in 0..40 {
        let speed = if step < 12 { 0.2 } else { -0.1 };
        zeta += speed * dt;
        let (along, spin) = ([0.01, -0.004, -speed], [0.005, 0.002, 0.0]);
        let meeting = |turn: bool| {
            let [along, spin] = [along, spin].map(|v| if turn { turned(v) } else { v });
            on_wall(zeta, along, spin, [0.0; 3])
        };
        let meetings = [false, true].map(meeting);
        let mut loads = vec![];
        for contacts in [&mut sticks, &mut slips] {
            loads.push([0, 1].map(|i| contacts[i].advance(&meetings[i], dt).unwrap()));
        }
        loads.push([0, 1].map(|i| by_rings[i].advance(&meetings[i], dt).unwrap()));
        for [load, other] in loads {
            let pairs = [(load.force, other.force), (load.torques[0], other.torques[0])];
            for (own, other) in pairs {
                let off = [0, 1, 2].map(|k| (turned(own)[k] - other[k]).abs());
                assert!(off.iter().all(|off| *off < 1e-13), "{step}: {own:?} {other:?}");
            }
            friction = friction.max(load.force[0].hypot(load.force[1]));
        }
    }
    assert!(zeta < 0.0 && friction > 1e-5, "{friction}");
}

/// The slip speed is that of the two surfaces across the normal: none for gears and for a rolling grain, however fast
/// they approach, twice that of each surface where both turn alike.
#[test]
fn slip_is_between_the_surfaces() {
    let rate = 0.3;
    let one = Grain {
        place: [0.0, 0.0, 1.9 * RADIUS],
        velocity: [0.0, 0.0, -7.0],
        spin: [0.0, rate, 0.0],
        radius: RADIUS,
        mass: 1.0,
    };
    let two = Grain { place: [0.0; 3], velocity: [0.0; 3], ..one };
    let gear = Grain { spin: [0.0, -rate, 0.0], ..two };
    let slip = |two: &Grain| Meeting::of_spheres(&one, two, [0.5; 2]).unwrap().slip_speed();
    assert!(slip(&gear) < 1e-13);
    // The contact lies half of the approach below both surfaces.
    assert!((slip(&two) - 2.0 * 0.95 * RADIUS * rate).abs() < 1e-13);
    // Below the centre of a grain with the spin w_y the surface moves by -w_y r along x.
    let (zeta, arm) = (0.1, RADIUS - 0.5 * 0.1);
    for (velocity, expected) in
        [(arm * rate, 0.0), (0.0, arm * rate), (-arm * rate, 2.0 * arm * rate)]
    {
        let meeting = on_wall(zeta, [velocity, 0.0, -7.0], [0.0, rate, 0.0], [0.0; 3]);
        assert!((meeting.slip_speed() - expected).abs() < 1e-13, "{velocity}");
    }
}

/// As the approach grows the arms of spins shorten, and slip changes by the spins times their shares of it.
#[test]
fn arms_shorten_as_the_approach_grows() {
    let (spin, share) = ([0.3, -0.7, 0.2], 0.35);
    let grain = |zeta: f64| Grain {
        place: [0.0, 0.0, RADIUS - zeta],
        velocity: [0.1, 0.2, 0.0],
        spin,
        radius: RADIUS,
        mass: 1.0,
    };
    let (place, normal, velocity) = ([0.0; 3], [0.0, 0.0, 1.0], [0.0; 3]);
    let below = Grain { place: [0.0, 0.0, -0.6], radius: 0.6, spin: [0.4, 0.1, 0.9], ..grain(0.0) };
    let wall = Wall { place, normal, velocity };
    let surface = Surface { place, normal, velocity, spin: [0.4, 0.1, 0.9], axis: [0.0; 3] };
    let meetings = |zeta: f64| {
        let one = grain(zeta);
        [
            Meeting::of_spheres(&one, &below, [share, 1.0 - share]).unwrap(),
            Meeting::on_wall(&one, &wall, share),
            Meeting::on_surface(&one, &surface, share),
        ]
    };
    // A wall turns the axes as a grain does that turns like it.
    let [other, _, wall_turns] = meetings(0.1);
    assert_eq!((wall_turns.turning(), wall_turns.twisting()), (other.turning(), other.twisting()));
    let sum =
        |m: &Meeting, by: [f64; 2]| [0, 1].map(|k| m.spins[0][k] * by[0] + m.spins[1][k] * by[1]);
    // Slip is v + r x n: along x and y.
    let slip = |m: &Meeting| {
        let [r_x, r_y] = sum(m, m.arms);
        [m.velocity[0] + r_y, m.velocity[1] - r_x]
    };
    let [shallow, deep] = [0.05, 0.15].map(meetings);
    for (before, after) in shallow.iter().zip(&deep) {
        let [[x, y], [to_x, to_y]] = [before, after].map(slip);
        let [by_x, by_y] = sum(after, after.shares);
        let growth = after.zeta - before.zeta;
        assert!((growth - 0.1).abs() < 1e-15 && (by_x * by_y).abs() > 1e-3);
        assert!((to_x - x + growth * by_y).abs() < 1e-15, "{before:?}");
        assert!((to_y - y - growth * by_x).abs() < 1e-15, "{before:?}");
    }
}

/// A step of no duration, such as a look at the loads, changes nothing, also while grains accelerate.
#[test]
fn a_step_of_no_duration_changes_nothing() {
    let dt = 0.01;
    let mut contact = contact(FRICTION, 0.0);
    let at = |step: u32| {
        let speed = 0.3 * f64::from(step * step) * dt;
        on_wall(0.05, [speed, -0.4 * speed, 0.0], [0.0; 3], [0.0; 3])
    };
    for step in 0..12 {
        let load = contact.advance(&at(step), dt).unwrap();
        let kept = contact;
        assert_eq!(contact.advance(&at(step), 0.0).unwrap(), load, "{step}");
        assert_eq!(contact.law().shift(), kept.law().shift(), "{step}");
    }
    assert!(contact.law().shift().xi.abs() > 0.01);
}

/// No direction of the normal is special, not even those of the axes: a scene whose axes are exchanged cyclically
/// has loads with exchanged axes.
#[test]
fn normals_along_all_axes_have_the_same_loads() {
    let moved = |by: usize, v: [f64; 3]| [0, 1, 2].map(|k: usize| v[(k + 3 - by) % 3]);
    let loads = |by: usize| {
        let mut contact = contact(FRICTION, 0.0);
        let wall = Wall { place: [0.0; 3], normal: moved(by, [0.0, 0.0, 1.0]), velocity: [0.0; 3] };
        let steps = (1..6).map(|step| {
            let place = moved(by, [0.0, 0.0, RADIUS - 0.01 * f64::from(step)]);
            let (velocity, spin) = (moved(by, [0.3, -0.7, -1.0]), moved(by, [0.2, 0.5, 0.1]));
            let grain = Grain { place, velocity, spin, radius: RADIUS, mass: 1.0 };
            contact.advance(&Meeting::on_wall(&grain, &wall, 0.5), 0.01).unwrap()
        });
        steps.collect::<Vec<_>>()
    };
    for by in [1, 2] {
        for (own, other) in loads(0).iter().zip(loads(by)) {
            for (own, other) in [(own.force, other.force), (own.torques[0], other.torques[0])] {
                let off = [0, 1, 2].map(|k| (moved(by, own)[k] - other[k]).abs());
                assert!(off.iter().all(|off| *off < 1e-15), "{by}: {own:?} {other:?}");
                assert!(own[0].abs() > 1e-4 && own[1].abs() > 1e-4);
            }
        }
    }
}

/// Two grains that turn about each other like one body do not approach: a dashpot heats nothing, however large a step
/// turns them.
#[test]
fn grains_that_turn_as_one_body_heat_no_dashpot() {
    let (dt, turn, distance) = (0.01, 0.05, 1.9 * RADIUS);
    let mut contact = contact(FRICTION, 0.3);
    let mut heats = Heats::default();
    let place = |step: f64| [distance * (turn * step).cos(), distance * (turn * step).sin(), 0.0];
    for step in 0..20 {
        let now = place(f64::from(step));
        let before = place(f64::from(step) - 1.0);
        let velocity = [0, 1, 2].map(|k| (now[k] - before[k]) / dt);
        let spin = [0.0, 0.0, turn / dt];
        let one = Grain { place: now, velocity, spin, radius: RADIUS, mass: 1.0 };
        let two = Grain { place: [0.0; 3], velocity: [0.0; 3], ..one };
        let meeting = Meeting::of_spheres(&one, &two, [0.5; 2]).unwrap();
        let before = heats.damping;
        contact.advance_accounted(&meeting, dt, &mut heats).unwrap();
        // Of the first step no earlier normal is known.
        if step > 2 {
            assert!((heats.damping - before).abs() < 1e-15, "{step}: {}", heats.damping - before);
        }
    }
}

/// In the first step the approach grows from touch while the grain turns: the torque is that of a twist laid
/// down as the contact grows, `(16/3) G int a^3 dOmega`. It is 2/5 of that of the whole twist at the whole radius
/// if the approach grows evenly, and 1/4 if the radius does.
#[test]
fn the_first_step_of_a_twist_begins_at_touch() {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let curvature = RelativeCurvature::from_coefficients(0.5, 0.5).unwrap();
    let hertz = Hertz::new(curvature, MaterialPair::new(body, body).unwrap()).unwrap();
    let (zeta, spin, dt) = (1e-3, 0.02, 0.1);
    // a^2 = R zeta with R = 1/(2 A) = 1; two equal bodies: G = G1/2 = 1, and M = (16/3) G a^3 Omega.
    let whole = 16.0 / 3.0 * f64::powf(zeta, 1.5) * spin * dt;
    for friction in [1e6, f64::INFINITY] {
        // The bodies touch after this part of the step.
        for part in [0.0, 0.5] {
            let law = TorsionLaw::new(&hertz, Friction::new(friction).unwrap()).unwrap();
            let mut twist = GrainTwist::new(law);
            let speed = zeta / (1.0 - part) / dt;
            let meeting = on_wall(zeta, [0.0, 0.0, -speed], [0.0, 0.0, -spin], [0.0; 3]);
            let torque = twist.advance(&meeting, dt).unwrap()[2];
            let share = torque / whole / (1.0 - part);
            assert!((0.249..=0.401).contains(&share), "f = {friction}, {part}: {share}");
        }
        // In many steps the first is a small part of all.
        let law = TorsionLaw::new(&hertz, Friction::new(friction).unwrap()).unwrap();
        let mut twist = GrainTwist::new(law);
        let mut torque = 0.0;
        for step in 1..=200 {
            let now = zeta * f64::from(step) / 200.0;
            let meeting = on_wall(now, [0.0, 0.0, -zeta / dt], [0.0, 0.0, -spin], [0.0; 3]);
            torque = twist.advance(&meeting, dt / 200.0).unwrap()[2];
        }
        assert!((torque / whole - 0.4).abs() < 1e-3, "{}", torque / whole);
    }
}

/// Damping at speeds beyond all range, and a radius or a share that are none, gave loads that are no numbers.
#[test]
fn a_step_whose_load_would_leave_the_numbers_is_refused() {
    let mut damped = contact(FRICTION, 1e-3);
    damped.advance(&on_wall(0.01, [0.0; 3], [0.0; 3], [0.0; 3]), 1e-3).unwrap();
    let before = damped;
    let fast = on_wall(0.01, [0.0, 0.0, -1e300], [0.0; 3], [0.0; 3]);
    let mut long = on_wall(0.01, [0.0; 3], [0.0; 3], [0.0; 3]);
    long.arms[0] = 1e250;
    let mut none = long;
    none.arms[1] = f64::NAN;
    // An arm that is no number makes the shift none, which is checked first.
    for (meeting, field) in [(fast, "damping force"), (long, "arm"), (none, "xi")] {
        // Without a duration nothing moves, but forces act.
        assert_eq!(damped.advance(&meeting, 0.0).unwrap_err().field, field);
        assert_eq!(damped, before);
        let mut load = GrainLoad { force: [7.0; 3], ..GrainLoad::default() };
        let kept = load;
        assert!(damped.advance_into(&meeting, 0.0, &mut load).is_err());
        assert_eq!((damped, load), (before, kept));
        let mut heats = Heats::default();
        let refused = damped.advance_accounted(&meeting, 0.0, &mut heats);
        assert!(refused.is_err());
        assert_eq!((damped, heats), (before, Heats::default()));
        let mut fresh = contact(FRICTION, 1e-3);
        let new = fresh;
        assert_eq!(fresh.advance(&meeting, 0.0).unwrap_err().field, field);
        assert_eq!(fresh, new);
    }
}

#[test]
fn of_contacts_advanced_together_none_is_changed_if_one_is_refused() {
    let below =
        Grain { place: [0.0; 3], velocity: [0.0; 3], spin: [0.0; 3], radius: RADIUS, mass: 1.0 };
    let above = Grain { place: [0.0, 0.0, 1.99], ..below };
    let fast = Grain { velocity: [0.0, 0.0, -1e300], ..above };
    let mut four = [(contact(FRICTION, 1e-3), GrainLoad::default()); 4];
    let mut step = |third: &Grain| {
        let mut i = 0;
        let mut pairs = four.each_mut().map(|(contact, load)| {
            i += 1;
            let one = if i == 3 { third } else { &above };
            Touching { contact, bodies: [one, &below], shares: [0.5; 2], rolling: None, load }
        });
        let done = advance_together(&mut pairs, 0.0, |_| {});
        (done, four)
    };
    let (begun, before) = step(&above);
    begun.unwrap();
    let (refused, after) = step(&fast);
    assert_eq!(refused.unwrap_err().field, "damping force");
    assert_eq!(after, before);
}
