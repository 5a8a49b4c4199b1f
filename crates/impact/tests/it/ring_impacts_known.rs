//! Impacts by rings, and the choice of them: what momentum, symmetry and limits demand.

use carom_geometry::Inertia;
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, NeededLaw, NormalRestitution, Rebound, RingImpact};
use carom_laws::friction::Friction;
use carom_laws::validity::Limit;
use nalgebra::Vector3;

const TOLERANCE: f64 = Collision::NEGLIGIBLE_COUPLING;

fn material(young: f64, poisson: f64) -> Material {
    Material::from_young(young, poisson).unwrap()
}

fn alumina() -> Material {
    material(380e9, 0.23)
}

fn glass() -> Material {
    material(70e9, 0.22)
}

fn rebound(collision: &Collision) -> Rebound {
    RingImpact::new(collision).solve().unwrap().rebound().unwrap().clone()
}

/// The twist takes of both spheres the same angular momentum, and what it leaves of their relative spin is the ratio.
#[test]
fn both_spinning_spheres_share_what_the_twist_takes() {
    let sphere = |radius: f64, mass: f64, material, velocity, spin| {
        let motion = Motion::new(velocity, [0.0, 0.0, spin]).unwrap();
        Body::sphere(radius, material, mass).unwrap().moving(motion)
    };
    let (moment_1, moment_2) = (0.4 * 3e-4 * 6.25e-6, 0.4 * 8e-4 * 1.6e-5);
    for [spin_1, spin_2] in [[300.0, -200.0], [0.0, 500.0], [-400.0, 0.0]] {
        let one = sphere(2.5e-3, 3e-4, alumina(), [0.1, 0.05, -1.0], spin_1);
        let two = sphere(4e-3, 8e-4, glass(), [0.0, 0.0, 0.5], spin_2);
        let collision = Collision::new(one, two, Friction::new(0.1).unwrap()).unwrap();
        let rebound = rebound(&collision);
        let [after_1, after_2] = rebound.motions.map(|motion| motion.spin.z);
        let (torsion, taken) = (rebound.torsion.unwrap(), [after_1 - spin_1, after_2 - spin_2]);
        let left = (after_1 - after_2) / (spin_1 - spin_2);
        assert!((left / torsion.spin_ratio - 1.0).abs() < 1e-12, "{left} {torsion:?}");
        assert!(torsion.spin_ratio < 0.999, "{torsion:?}");
        let momentum = [moment_1 * taken[0], moment_2 * taken[1]];
        assert!((momentum[0] + momentum[1]).abs() < 1e-10 * momentum[0].abs(), "{momentum:?}");
        let energy = rebound.energy;
        let off = (energy.before - energy.after - energy.dissipated) / energy.before;
        assert!(off.abs() < 1e-9, "{off:e}");
    }
}

/// A ball of alumina on glass at 1 m/s, its tangential velocity over f v_z and its spin.
fn ball([along, across]: [f64; 2], spin: f64) -> Collision {
    let friction = 0.1;
    let velocity = [friction * along, friction * across, -1.0];
    let ball = Body::sphere(2.5e-3, alumina(), 2.6e-4).unwrap();
    let ball = ball.moving(Motion::new(velocity, [0.0, 0.0, spin]).unwrap());
    Collision::new(ball, Body::plane(glass()), Friction::new(friction).unwrap()).unwrap()
}

/// What is axisymmetric turns with the tangential velocity, at any size of it: below lambda = 0.02 it is scaled.
#[test]
fn an_impact_turns_with_its_tangential_velocity() {
    for size in [0.003, 0.5] {
        let after = |x: f64, y: f64| {
            let collision = ball([size * x, size * y], 600.0);
            let impact = RingImpact::new(&collision).within(5e-3).unwrap().solve().unwrap();
            let after = impact.rebound().unwrap().contact_velocity_after;
            Vector3::new(after.x, after.y, after.z) / size
        };
        let along = after(1.0, 0.0);
        assert!(along.y.abs() > 1e-3 * along.x.abs(), "pushed sideways: {along}");
        for (cosine, sine) in [(0.0, 1.0), (-1.0, 0.0), (0.6, -0.8)] {
            let (got, want) = (
                after(cosine, sine),
                [cosine * along.x - sine * along.y, sine * along.x + cosine * along.y],
            );
            let off = (got.x - want[0]).hypot(got.y - want[1]) / along.xy().norm();
            // Eight or sixteen angles know an eighth of a turn exactly, others to their accuracy.
            let room = if size < 0.02 || cosine * sine == 0.0 { 1e-9 } else { 0.03 };
            assert!(off < room, "{size} {cosine} {sine}: {off:e}");
        }
    }
}

/// Beside a spin that moves the edge much faster, a slow shift meets a contact that slides already: R_x has the same
/// limit from either side of lambda = 0.02 and does not move down to none.
#[test]
fn beside_a_fast_spin_slow_shifts_have_one_restitution() {
    let r_x = |size: f64| rebound(&ball([size, 0.0], 6000.0)).r_x.unwrap();
    let [none, small, beyond] = [1e-9, 0.019, 0.021].map(r_x);
    assert!((small - beyond).abs() < 2e-3, "{small} {beyond}");
    assert!((none - small).abs() < 2e-3, "{none} {small}");
}

/// Two balls that turn against each other like gears have no tangential motion where they touch but for rounding.
#[test]
fn spins_that_cancel_at_the_contact_need_no_rings() {
    let gear = |radius: f64, turning: f64, z: f64| {
        let motion =
            Motion::new([0.0, 0.0, z], [1.0 / 3.0 * turning / radius, turning / radius, 50.0 * z]);
        Body::sphere(radius, alumina(), 2e-4).unwrap().moving(motion.unwrap())
    };
    let mut rounded = 0;
    for count in 0..40 {
        // Surfaces at 1 km/s: what rounding leaves is far above that of the velocities of the centres.
        let turning = 1e3 + f64::from(count) / 7.0;
        let (one, two) = (gear(2.7e-3, turning, -1.0), gear(3.1e-3, -turning, 1.0));
        let collision = Collision::new(one, two, Friction::new(0.2).unwrap()).unwrap();
        assert!(collision.twist_bound().restitution > TOLERANCE);
        assert_eq!(collision.needed_law(TOLERANCE), NeededLaw::Analytic);
        rounded += usize::from(collision.velocity().xy().norm() > 0.0);
    }
    assert!(rounded > 0, "nothing to round");
}

/// The bounds were measured for D_xx/D_zz from 2.5 to 5: beyond, rings follow however small they are.
#[test]
fn outside_the_measured_ratios_rings_are_used() {
    let with = |moment: f64| {
        let (mass, radius) = (2.6e-4, 2.5e-3);
        let inertia = Inertia::new(mass, [moment * mass * radius * radius; 3]).unwrap();
        let ball = Body::sphere(radius, material(70e9, 0.2205), mass).unwrap();
        let ball =
            ball.with_inertia(inertia).moving(Motion::new([0.1, 0.0, -1.0], [0.0; 3]).unwrap());
        Collision::new(ball, Body::plane(glass()), Friction::new(0.3).unwrap()).unwrap()
    };
    // D_xx/D_zz = 1 + 1/moment.
    for (moment, law) in [
        (0.4, NeededLaw::Analytic),
        (0.6, NeededLaw::Analytic),
        (0.1, NeededLaw::Rings),
        (0.9, NeededLaw::Rings),
    ] {
        let collision = with(moment);
        assert!(collision.coupling_bound() > 0.0 && collision.coupling_bound() < 0.1 * TOLERANCE);
        assert_eq!(collision.needed_law(TOLERANCE), law, "{moment}");
    }
}

/// A slow spin changes R_x little, but friction may take much of it: then rings are needed for the spin.
#[test]
fn a_slow_spin_that_friction_takes_asks_for_rings() {
    let rubber = material(5e6, 0.49);
    let spin = 0.05;
    let ball = Body::sphere(0.02, rubber, 0.04).unwrap();
    let ball = ball.moving(Motion::new([0.3, 0.0, -1.0], [0.0, 0.0, spin]).unwrap());
    let collision = Collision::new(ball, Body::plane(rubber), Friction::new(0.8).unwrap()).unwrap();
    let bound = collision.twist_bound();
    assert!(bound.restitution < TOLERANCE && bound.spin > TOLERANCE, "{bound:?}");
    assert_eq!(collision.needed_law(TOLERANCE), NeededLaw::Rings);
    let lost = 1.0 - rebound(&collision).motions[0].spin.z / spin;
    assert!(lost > TOLERANCE && lost < 1.01 * bound.spin, "{lost}");
}

/// Two equal spheres have the pulse of one of half the radius and mass on a plane. Its density is four times theirs,
/// and what a pulse radiates grows as the root of the density: half the share, of the body that radiates more.
#[test]
fn the_share_of_waves_is_that_of_one_body() {
    let share = |collision: &Collision| {
        let outcome = collision.solve().unwrap();
        let mut told = outcome.rebound().unwrap().warnings.iter();
        told.find_map(|warning| warning.ratio(Limit::Waves)).unwrap()
    };
    let rubber = material(5e6, 0.4);
    let sphere = |radius: f64, mass: f64, z: f64| {
        let motion = Motion::new([0.0, 0.0, z], [0.0; 3]).unwrap();
        Body::sphere(radius, rubber, mass).unwrap().moving(motion)
    };
    let friction = Friction::new(0.3).unwrap();
    let (radius, mass) = (0.02, 0.04);
    let pair = Collision::new(sphere(radius, mass, -2.0), sphere(radius, mass, 0.0), friction);
    let half =
        Collision::new(sphere(0.5 * radius, 0.5 * mass, -2.0), Body::plane(rubber), friction);
    let [pair, half] = [pair, half].map(|collision| share(&collision.unwrap()));
    assert!((pair / (0.5 * half) - 1.0).abs() < 1e-12, "{pair} {half}");
}

/// The sign of a regime is that of the traction along the slip before the impact, also of a ball that comes back.
#[test]
fn regimes_have_the_sign_of_the_exact_impact() {
    let friction = 0.1;
    for lambda in [3.0, 4.0, 5.0] {
        let velocity = [0.6 * friction * lambda, -0.8 * friction * lambda, -1.0];
        let ball = Body::sphere(2.5e-3, alumina(), 2.6e-4).unwrap();
        let ball = ball.moving(Motion::new(velocity, [0.0; 3]).unwrap());
        let collision =
            Collision::new(ball, Body::plane(alumina()), Friction::new(friction).unwrap()).unwrap();
        let exact = collision.solve().unwrap().rebound().unwrap().clone();
        assert!(exact.r_x.unwrap() > 0.05, "it comes back");
        let first = |rebound: &Rebound| {
            let names = rebound.log.iter().map(|entry| entry.regime.name());
            names.filter_map(|name| name.chars().last()).find(|sign| ['+', '-'].contains(sign))
        };
        assert_eq!(first(&rebound(&collision)), first(&exact), "{lambda}");
        assert!(first(&exact).is_some());
    }
}

/// At so little friction that nothing sticks, a fast spin alone has the torque of sliding.
#[test]
fn a_fast_spin_that_slides_has_the_torque_of_sliding() {
    let ball = Body::sphere(2.5e-3, alumina(), 2.6e-4).unwrap();
    // At the edge of the contact some hundred times as fast as the surfaces spread.
    let ball = ball.moving(Motion::new([0.0, 0.0, -1.0], [0.0, 0.0, 1e6]).unwrap());
    let collision =
        Collision::new(ball, Body::plane(glass()), Friction::new(1e-5).unwrap()).unwrap();
    let sliding = collision.clone().with_torsion().solve().unwrap();
    let [rings, sliding] = [rebound(&collision), sliding.rebound().unwrap().clone()]
        .map(|rebound| rebound.torsion.unwrap().torque_impulse);
    assert!((rings / sliding - 1.0).abs() < 2e-3, "{rings} {sliding}");
}

/// Straight down, only the normal velocity can be off: the estimate says by how much.
#[test]
fn the_estimate_of_a_normal_impact_is_of_the_normal_velocity() {
    for friction in [0.05, 0.1, 0.3] {
        let ball = Body::sphere(2.5e-3, alumina(), 2.6e-4).unwrap();
        let ball = ball.moving(Motion::new([0.0, 0.0, -1.0], [0.0; 3]).unwrap());
        let collision =
            Collision::new(ball, Body::plane(glass()), Friction::new(friction).unwrap()).unwrap();
        let [coarse, fine] = [1.0, 1e-5].map(|tolerance| {
            let impact = RingImpact::new(&collision).within(tolerance).unwrap();
            impact.solve().unwrap().rebound().unwrap().clone()
        });
        let change = (coarse.contact_velocity_after - fine.contact_velocity_after).norm();
        assert!(change > 0.0 && change < 3.0 * coarse.error_estimate, "{friction}: {change}");
    }
}

/// Of like bodies without tangential motion what is left of the spin is known: the estimate covers what rings miss.
#[test]
fn the_estimate_of_the_spin_covers_what_rings_miss() {
    let rubber = Material::from_shear(1e6, 0.5).unwrap();
    for spin in [2.0, 20.0, 60.0, 100.0, 200.0, 400.0] {
        let ball = Body::sphere(0.02, rubber, 0.0369).unwrap();
        let ball = ball.moving(Motion::new([0.0, 0.0, -1.0], [0.0, 0.0, spin]).unwrap());
        let collision =
            Collision::new(ball, Body::plane(rubber), Friction::new(0.5).unwrap()).unwrap();
        let exact = collision.clone().with_torsion().solve().unwrap();
        let exact = exact.rebound().unwrap().torsion.unwrap().spin_ratio;
        for tolerance in [1.0, 1e-3] {
            let impact = RingImpact::new(&collision).within(tolerance).unwrap();
            let torsion = impact.solve().unwrap().rebound().unwrap().torsion.unwrap();
            let off = (torsion.spin_ratio - exact).abs();
            assert!(off < torsion.error_estimate, "{spin} {tolerance}: {off} {torsion:?} {exact}");
            assert!(torsion.error_estimate < 0.02 && off < 0.01 * (1.0 - exact), "{spin}: {off}");
        }
    }
}

/// A material that loses energy takes (1 - e^2)/2 m v^2 of the normal motion whatever the ball's slip and spin, and friction
/// f (1 + e) m v times the slip where all slides.
#[test]
fn friction_and_material_each_take_their_part_of_the_energy() {
    let (mass, speed, e) = (2.6e-4, 1.0, 0.5);
    for (friction, slip, spin) in
        [(1e-4, 1.0, 0.0), (1e-5, 3.0, 0.0), (0.1, 0.0, 1200.0), (0.02, 0.0, 6000.0)]
    {
        let motion = Motion::new([slip, 0.0, -speed], [0.0, 0.0, spin]).unwrap();
        let ball = Body::sphere(2.5e-3, alumina(), mass).unwrap().moving(motion);
        let friction_law = Friction::new(friction).unwrap();
        let collision = Collision::new(ball, Body::plane(glass()), friction_law).unwrap();
        let loss = NormalRestitution::new(e).unwrap();
        let energy = rebound(&collision.with_normal_restitution(loss)).energy;
        let lost = 0.5 * (1.0 - e * e) * mass * speed * speed;
        assert!((energy.lost / lost - 1.0).abs() < 5e-3, "{friction}: {energy:?} {lost}");
        if spin == 0.0 {
            let heat = friction * (1.0 + e) * mass * speed * slip;
            assert!((energy.dissipated / heat - 1.0).abs() < 1e-3, "{friction}: {energy:?} {heat}");
        }
    }
}

/// Below lambda = 0.02 the impact is scaled, and its estimate with it: this has no step there.
#[test]
fn the_estimate_of_a_small_slip_goes_on_from_that_of_a_larger_one() {
    let estimate = |size: f64| rebound(&ball([size, 0.0], 0.0)).error_estimate;
    let [below, above] = [0.0199, 0.0201].map(estimate);
    assert!((above / below - 1.0).abs() < 0.05, "{below} {above}");
}

/// Torsion of a ball that also slides is computed as if it did not: its estimate covers what rings, which know both, find.
#[test]
fn the_torsion_of_a_sliding_ball_is_off_by_less_than_its_estimate() {
    for (slip, spin) in [(0.3, 3000.0), (0.05, 1000.0), (0.01, 300.0), (1.0, 6000.0)] {
        let motion = Motion::new([slip, 0.0, -1.0], [0.0, 0.0, spin]).unwrap();
        let ball = Body::sphere(2.5e-3, glass(), 2.6e-4).unwrap().moving(motion);
        let friction = Friction::new(0.1).unwrap();
        let collision = Collision::new(ball, Body::plane(glass()), friction).unwrap();
        let alone = collision.clone().with_torsion().solve().unwrap();
        let alone = alone.rebound().unwrap().torsion.unwrap();
        let rings = rebound(&collision).torsion.unwrap().spin_ratio;
        let off = (alone.spin_ratio - rings).abs();
        assert!(off < alone.error_estimate, "{slip} {spin}: {off} {alone:?} {rings}");
    }
}

/// Where hardly anything slips, |gamma| f above 1, the analytic law is nearer to the truth than rings.
#[test]
fn with_friction_too_strong_for_rings_the_analytic_law_is_used() {
    for (strength, law) in [(0.99, NeededLaw::Rings), (1.01, NeededLaw::Analytic)] {
        let [one, two] = ball([1.0, 0.0], 0.0).bodies().clone();
        // 2 gamma = (A_1 - A_2)/(C_1 + C_2) with A = (1 - 2 nu)/G and C = (1 - nu)/G.
        let [(g_1, nu_1), (g_2, nu_2)] = [(380e9 / 2.46, 0.23), (70e9 / 2.44, 0.22)];
        let gamma: f64 = 0.5 * ((1.0 - 2.0 * nu_1) / g_1 - (1.0 - 2.0 * nu_2) / g_2)
            / ((1.0 - nu_1) / g_1 + (1.0 - nu_2) / g_2);
        let friction = Friction::new(strength / gamma.abs()).unwrap();
        let collision = Collision::new(one, two, friction).unwrap();
        assert_eq!(collision.needed_law(TOLERANCE), law);
    }
}
