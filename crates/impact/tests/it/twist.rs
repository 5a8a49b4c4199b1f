//! Friction acts on the spin about the normal by default, where it matters.

use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::Material;
use carom_impact::{
    AnalyticOrRings, Body, Collision, CollisionSolver, LogEntry, Motion, NeededLaw,
    NormalRestitution, Rebound, RingImpact, TorsionMode, Warning,
};
use carom_laws::friction::Friction;
use carom_laws::validity::Limit;

const PI: f64 = std::f64::consts::PI;
const SPEED: f64 = 2.0;

/// A ball on a plane of the same material; tangential velocity and that of spin at the edge of the greatest contact
/// over f v_z.
fn alike(poisson: f64, friction: f64, lambda: f64, twist: f64) -> Collision {
    unlike([poisson, poisson], friction, lambda, twist)
}

fn unlike(poisson: [f64; 2], friction: f64, lambda: f64, twist: f64) -> Collision {
    at_speed(SPEED, poisson, friction, lambda, twist)
}

fn at_speed(speed: f64, poisson: [f64; 2], friction: f64, lambda: f64, twist: f64) -> Collision {
    let [ball, plane] = poisson.map(|nu| Material::from_shear(80e9, nu).unwrap());
    let sphere = Body::sphere(0.01, ball, 0.03).unwrap();
    let friction_number = Friction::new(friction).unwrap();
    let with = |motion: Motion| {
        let ball = sphere.clone().moving(motion);
        Collision::new(ball, Body::plane(plane), friction_number).unwrap()
    };
    let slip = lambda * friction.min(1.0) * speed;
    let still = with(Motion::new([slip, 0.0, -speed], [0.0; 3]).unwrap());
    let radius = still.solve().unwrap().rebound().unwrap().maximal_contact.semi_axis_a();
    let spin = twist * friction.min(1.0) * speed / radius;
    with(Motion::new([slip, 0.0, -speed], [0.0, 0.0, spin]).unwrap())
}

fn auto(collision: &Collision) -> Rebound {
    AnalyticOrRings.solve(collision).unwrap().rebound().unwrap().clone()
}

fn needed(collision: &Collision) -> NeededLaw {
    collision.needed_law(Collision::NEGLIGIBLE_COUPLING)
}

/// The part of the spin about the normal that is left.
fn spin_left(collision: &Collision, rebound: &Rebound) -> f64 {
    rebound.motions[0].spin.z / collision.bodies()[0].motion().spin.z
}

#[test]
fn the_bounds_hold_for_drawn_impacts() {
    let mut draw = Congruential(3);
    let mut worst = [0.0_f64; 2];
    for _ in 0..60 {
        let (nu, friction) = (draw.between(0.0, 0.5), draw.between(0.05, 0.6));
        let (lambda, twist) =
            (10_f64.powf(draw.between(-1.3, 0.8)), 10_f64.powf(draw.between(-1.5, 0.8)));
        let collision = alike(nu, friction, lambda, twist);
        let bound = collision.twist_bound();
        let spun = RingImpact::new(&collision).solve().unwrap();
        let spun = spun.rebound().unwrap();
        let still = collision.solve().unwrap().rebound().unwrap().r_x.unwrap();
        let change = (spun.r_x.unwrap() - still).abs();
        // What the rings themselves miss.
        let missed = RingImpact::TOLERANCE / lambda;
        assert!(change < bound.restitution + missed, "{nu} {lambda} {twist}: {change}");
        let lost = 1.0 - spun.torsion.unwrap().spin_ratio;
        // The rings know sliding to 0.3 %.
        assert!(lost <= 1.005 * bound.spin, "{nu} {lambda} {twist}: {lost} {}", bound.spin);
        worst = [worst[0].max(change / bound.restitution), worst[1].max(lost / bound.spin)];
    }
    // Neither is far from what happens at worst.
    assert!(worst[0] > 0.5 && worst[1] > 0.8, "{worst:?}");
}

#[test]
fn the_law_changes_where_a_bound_meets_the_tolerance_and_the_result_by_less() {
    let tolerance = Collision::NEGLIGIBLE_COUPLING;
    for lambda in [0.3, 1.5, 4.0] {
        // So slow that the contact is small: friction takes 0.13 % of the spin, which is no reason for rings.
        let at = |twist: f64| at_speed(0.05, [0.3, 0.3], 0.2, lambda, twist);
        assert!(at(0.5).twist_bound().spin < 0.5 * tolerance);
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if needed(&at(middle)) == NeededLaw::Analytic { low = middle } else { high = middle }
        }
        let [below, above] = [low, high].map(|twist| auto(&at(twist)));
        assert_eq!([below.method.name(), above.method.name()], ["uncoupled", "rings"]);
        let change = (below.r_x.unwrap() - above.r_x.unwrap()).abs();
        assert!(change < tolerance, "{lambda}: {change}");
        let left = [(low, &below), (high, &above)].map(|(t, r)| spin_left(&at(t), r));
        assert!((left[0] - left[1]).abs() < tolerance, "{lambda}: {left:?}");
        // What is neglected stands in the estimate.
        assert!(below.error_estimate > 0.0 && below.error_estimate < 2.0 * tolerance);
    }
}

/// The share of a spin that is left out is what friction would take of it alone: of slow spins that stick, and of fast
/// ones that slide.
#[test]
fn the_share_left_out_is_what_friction_takes() {
    let mut closest = [0.0_f64; 2];
    for k in -6..=6 {
        let collision = alike(0.3, 0.2, 0.0, 10_f64.powf(0.5 * f64::from(k)));
        let rebound = |collision: Collision| collision.solve().unwrap().rebound().unwrap().clone();
        let share =
            rebound(collision.clone().with_torsion_mode(TorsionMode::LeftOut)).validity.spin_share;
        let taken = 1.0 - rebound(collision.with_torsion()).torsion.unwrap().spin_ratio;
        assert!(taken > 0.0 && taken <= 1.005 * share, "{k}: {taken} {share}");
        let of = &mut closest[usize::from(k > 0)];
        *of = of.max(taken / share);
    }
    assert!(closest.iter().all(|part| *part > 0.98), "{closest:?}");
}

#[test]
fn a_spin_alone_is_exact() {
    let collision = alike(0.3, 0.2, 0.0, 0.5);
    assert_eq!(needed(&collision), NeededLaw::Analytic);
    let (ours, exact) = (auto(&collision), collision.clone().with_torsion().solve().unwrap());
    assert_eq!(Some(&ours), exact.rebound());
    assert!(spin_left(&collision, &ours) < 1.0);
    // Rings agree.
    let rings = RingImpact::new(&collision).solve().unwrap();
    let rings = spin_left(&collision, rings.rebound().unwrap());
    let loss = 1.0 - spin_left(&collision, &ours);
    assert!((1.0 - rings - loss).abs() < 0.03 * loss, "{rings} {loss}");
}

#[test]
fn a_spin_that_is_left_out_changes_nothing_and_is_told() {
    for poisson in [[0.3, 0.3], [0.0, 0.5]] {
        let spun = unlike(poisson, 0.2, 0.8, 0.7).with_torsion_mode(TorsionMode::LeftOut);
        let still = unlike(poisson, 0.2, 0.8, 0.0);
        let (spun, still) = (auto(&spun), auto(&still));
        assert_eq!((spun.r_x, spun.method), (still.r_x, still.method));
        assert_eq!(spun.impulse, still.impulse);
        assert!(spun.torsion.is_none());
        let told = |warning: &Warning| warning.ratio(Limit::Spin).is_some();
        assert!(spun.warnings.iter().any(told) && !still.warnings.iter().any(told));
        // By default it counts, and nothing is told.
        let counted = auto(&unlike(poisson, 0.2, 0.8, 0.7));
        assert!((counted.r_x.unwrap() - still.r_x.unwrap()).abs() > 0.05);
        assert!(counted.torsion.is_some() && !counted.warnings.iter().any(told));
    }
}

#[test]
fn a_small_tangential_velocity_beside_a_spin_has_a_limit() {
    let r_x = |lambda: f64| {
        let collision = unlike([0.0, 0.5], 0.2, lambda, 0.7);
        auto(&collision).r_x.unwrap()
    };
    let limit = r_x(1e-9);
    assert!((r_x(1e-5) - limit).abs() < 1e-4);
    assert!((r_x(0.019) - r_x(0.021)).abs() < 0.01, "{} {}", r_x(0.019), r_x(0.021));
    // The contact is axisymmetric in the limit: the velocity turns with the plane of coordinates.
    assert!(limit.abs() < 1.0);
}

#[test]
fn without_slip_shift_and_twist_are_apart() {
    let collision = alike(0.3, f64::INFINITY, 0.5, 0.3);
    let exact = collision.clone().with_torsion().solve().unwrap();
    let (ours, exact) = (auto(&collision), exact.rebound().unwrap().clone());
    assert_eq!((ours.r_x, ours.motions), (exact.r_x, exact.motions));
}

/// Slip and its sign apart: rings take the sign of the whole force, which follows that of the edge.
fn stages(rebound: &Rebound) -> Vec<(&'static str, f64)> {
    let stage = |entry: &LogEntry| {
        (entry.regime.name().trim_end_matches(['+', '-']), entry.time / rebound.duration)
    };
    let mut stages: Vec<_> = rebound.log.iter().map(stage).collect();
    stages.dedup_by_key(|(name, _)| *name);
    stages
}

#[test]
fn rings_log_the_regimes_of_the_exact_impact() {
    for (lambda, count) in [(0.4, 3), (1.5, 4), (3.0, 4), (8.0, 1)] {
        let collision = alike(0.3, 0.2, lambda, 0.0);
        let [rings, exact] = [
            RingImpact::new(&collision).within(1e-4).unwrap().solve(),
            Ok(collision.solve().unwrap()),
        ]
        .map(|outcome| stages(outcome.unwrap().rebound().unwrap()));
        assert_eq!(exact.len(), count);
        let mut later = rings.iter();
        for (name, time) in exact {
            let near = later.find(|(ring, _)| *ring == name).unwrap();
            assert!((near.1 - time).abs() < 0.05, "{lambda}: {name} {time} {near:?}");
        }
        // On the way from sliding to adhesion the last ring sticks a step later.
        assert!(rings.len() <= count + 1, "{rings:?}");
    }
}

/// However little a spin slips, a contact that sticks takes the same part of it: great friction and infinite one.
#[test]
fn great_friction_takes_as_much_spin_as_infinite_friction() {
    let left = |friction: f64| {
        let collision = alike(0.3, friction, 0.5, 0.1);
        spin_left(&collision, &auto(&collision))
    };
    let infinite = left(f64::INFINITY);
    assert!(infinite < 0.995);
    for friction in [1e4, 1e5, 1e6, 1e30] {
        assert!((left(friction) - infinite).abs() < 1e-4, "{friction}: {}", left(friction));
    }
    // A slow spin at usual friction, too.
    let slow = |twist: f64| {
        let collision = alike(0.3, 0.2, 0.0, twist);
        spin_left(&collision, &auto(&collision))
    };
    assert!((slow(1e-7) - slow(1e-5)).abs() < 1e-6);
}

fn lossy(collision: Collision, e: f64) -> Collision {
    collision.with_normal_restitution(NormalRestitution::new(e).unwrap())
}

/// Without a tangential velocity a viscous loss changes the spin as with a slight one, where rings follow both motions; and
/// the bound holds.
#[test]
fn a_viscous_loss_changes_the_spin_evenly() {
    for (friction, twist) in [(0.1, 0.4), (0.5, 0.5), (1.0, 0.1), (1e6, 0.1)] {
        for e in [0.0, 0.02, 0.05, 0.1, 0.2, 0.5, 0.8, 0.999_999] {
            let [still, moving] =
                [0.0, 1e-6].map(|lambda| lossy(alike(0.3, friction, lambda, twist), e));
            let [alone, both] = [&still, &moving].map(auto);
            let left = [spin_left(&still, &alone), spin_left(&moving, &both)];
            let lost = 1.0 - left[1];
            // With little rebound rings are known to their estimate alone.
            let told = [&alone, &both].map(|of| of.torsion.unwrap().error_estimate);
            let allowed = if e < 0.2 { told[0] + told[1] } else { 2e-4 };
            assert!((left[0] - left[1]).abs() < allowed, "{friction} {e}: {left:?} {told:?}");
            let bound = still.twist_bound().spin;
            assert!(lost <= 1.005 * bound, "{friction} {e}: {lost} {bound}");
            let energy = alone.energy;
            let balance = energy.before - energy.after - energy.dissipated - energy.lost;
            assert!(balance.abs() < 1e-12 * energy.before, "{energy:?}");
        }
    }
}

/// Infinite friction takes as much of the spin of lossy bodies as great friction.
#[test]
fn infinite_friction_takes_as_much_spin_of_lossy_bodies_as_great_friction() {
    for e in [0.0, 0.1, 0.5] {
        let [great, infinite] = [1e5, f64::INFINITY].map(|friction| {
            let collision = lossy(alike(0.3, friction, 0.0, 0.1), e);
            spin_left(&collision, &auto(&collision))
        });
        assert!((great - infinite).abs() < 1e-4, "{e}: {great} {infinite}");
    }
}

/// The impulse of the sliding torque of a Kelvin-Voigt contact over f and that of an elastic one, and the restitution, in
/// units of m = K = v = R = 1. Hertz's pressure has the arm 3 pi a/16, that of a flat punch, which its growth adds, pi a/4.
fn sliding_torque(tau: f64) -> [f64; 2] {
    let (mut zeta, mut speed, mut torque, dt) = (0.0_f64, 1.0_f64, 0.0, 5e-4);
    loop {
        zeta += dt * speed;
        let (radius, pressed) = (zeta.sqrt(), zeta + tau * speed.min(0.0));
        if pressed <= 0.0 {
            return [torque, -speed];
        }
        let (hertz, added) = (pressed.powf(1.5), 1.5 * tau * radius * speed.max(0.0));
        torque += dt * (0.1875 * PI * hertz * pressed.sqrt() + 0.25 * PI * added * radius);
        speed -= dt * (hertz + added);
    }
}

/// Where all slides, friction takes as much of the spin as the impulse of the torque is.
#[test]
fn the_torque_of_a_sliding_contact_follows_the_pressure() {
    let lost = |e: f64| {
        let collision = lossy(alike(0.3, 0.02, 0.0, 30.0), e).with_torsion();
        1.0 - spin_left(&collision, collision.solve().unwrap().rebound().unwrap())
    };
    let [elastic, _] = sliding_torque(0.0);
    for tau in [0.05, 0.15, 0.5] {
        let [torque, e] = sliding_torque(tau);
        let (known, got) = (torque / elastic, lost(e) / lost(1.0));
        // Rings take the whole pressure for Hertz's.
        assert!((got / known - 1.0).abs() < 0.05 && got < 0.97, "{e}: {got} {known}");
    }
}
