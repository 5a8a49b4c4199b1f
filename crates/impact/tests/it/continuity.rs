//! Where the method changes nothing jumps: unlike materials and spins that fade, and losses that fade.

use carom_geometry::{Attitude, Surface};
use carom_halfspace::Material;
use carom_impact::{
    AnalyticOrRings, Body, Collision, CollisionSolver, Motion, NormalRestitution, Rebound,
};
use carom_laws::friction::Friction;

const MASS: f64 = 2600.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-9;
const FRICTION: f64 = 0.3;

fn losing(collision: Collision, e: f64) -> Collision {
    collision.with_normal_restitution(NormalRestitution::new(e).unwrap())
}

fn solved(collision: &Collision) -> Rebound {
    AnalyticOrRings.solve(collision).unwrap().rebound().unwrap().clone()
}

/// A ball of 1 mm on a floor whose Poisson's ratio is so much larger; lambda, and the spin about the normal.
fn ball(unlike: f64, lambda: f64, spin: f64) -> Collision {
    let [one, two] = [0.2, 0.2 + unlike].map(|nu| Material::from_shear(4e9, nu).unwrap());
    let motion = Motion::new([FRICTION * lambda, 0.0, -1.0], [0.0, 0.0, spin]).unwrap();
    let ball = Body::sphere(1e-3, one, MASS).unwrap().moving(motion);
    Collision::new(ball, Body::plane(two), Friction::new(FRICTION).unwrap()).unwrap()
}

/// Where the method changes between two places, to a billionth: the step of the velocity there over that before, and the sum
/// of the estimates of both sides.
fn step([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> Collision) -> [f64; 2] {
    let law = |place: f64| of(place).default_law();
    let (below, above) = (law(low), law(high));
    assert_ne!(below, above);
    while high - low > 1e-9 * high {
        let middle = 0.5 * (low + high);
        if law(middle) == below { low = middle } else { high = middle }
    }
    let [one, two] = [low, high].map(|place| solved(&of(place)));
    assert_ne!(one.method.name(), two.method.name());
    apart(&one, &two)
}

fn apart(one: &Rebound, two: &Rebound) -> [f64; 2] {
    let step = (two.contact_velocity_after - one.contact_velocity_after).norm();
    let whole = one.contact_velocity_before.norm();
    [step / whole, one.error_estimate + two.error_estimate]
}

const RESTITUTIONS: [f64; 5] = [1.0, 0.95, 0.8, 0.6, 0.4];
const LAMBDAS: [f64; 6] = [0.1, 0.3, 0.8, 1.5, 3.0, 5.0];

/// The largest step over the estimates, of all restitutions and lambdas.
fn worst(of: impl Fn(f64, f64) -> [f64; 2]) -> f64 {
    let all = RESTITUTIONS.into_iter().flat_map(|e| LAMBDAS.map(|lambda| [e, lambda]));
    let over = |[e, lambda]: [f64; 2]| {
        let [step, estimate] = of(e, lambda);
        assert!(step < 2e-3, "{e} {lambda}: {step}");
        step / (estimate + 1e-7)
    };
    all.map(over).fold(0.0, f64::max)
}

/// Unlike materials that become alike.
#[test]
fn nothing_jumps_as_materials_become_alike() {
    let impact = |unlike: f64, e: f64, lambda: f64| losing(ball(unlike, lambda, 0.0), e);
    let at_change = worst(|e, lambda| step([1e-4, 0.29], |unlike| impact(unlike, e, lambda)));
    assert!(at_change < 1.0, "{at_change}");
    let at_end = worst(|e, lambda| {
        apart(&solved(&impact(0.0, e, lambda)), &solved(&impact(1e-7, e, lambda)))
    });
    assert!(at_end < 1.0, "{at_end}");
}

/// A spin about the normal that fades.
#[test]
fn nothing_jumps_as_spins_fade() {
    let impact = |spin: f64, e: f64, lambda: f64| losing(ball(0.0, lambda, spin), e);
    let at_change = worst(|e, lambda| step([1e-3, 1e4], |spin| impact(spin, e, lambda)));
    assert!(at_change < 1.0, "{at_change}");
    let at_end = worst(|e, lambda| {
        apart(&solved(&impact(0.0, e, lambda)), &solved(&impact(1e-3, e, lambda)))
    });
    assert!(at_end < 1.0, "{at_end}");
}

/// Below .02 f v_z velocities are scaled from that slip, also what spin and coupling of unlike balls add across it.
#[test]
fn nothing_jumps_as_slips_fade() {
    let [one, two] =
        [(70e9, 0.0), (700e9, 0.3)].map(|(e, nu)| Material::from_young(e, nu).unwrap());
    let velocities = [0.0199, 0.0201].map(|lambda| {
        let slip = FRICTION * lambda;
        let motion = Motion::new([0.8 * slip, 0.6 * slip, -1.0], [0.0, 0.0, -30.0]).unwrap();
        let ball = Body::sphere(0.01, one, 0.01).unwrap().moving(motion);
        let below = Body::sphere(0.02, two, 0.03).unwrap();
        let collision = Collision::new(ball, below, Friction::new(FRICTION).unwrap()).unwrap();
        let after = solved(&collision).contact_velocity_after;
        [after.x / slip, after.y / slip]
    });
    let [[x, y], [u, v]] = velocities;
    assert!((x - u).hypot(y - v) < 0.01, "{velocities:?}");
}

/// Like bodies that spin: what rings err in an elastic impact they err as much in one that loses next to nothing, and the
/// estimate of a great loss grows with the spin by at most .03 f v_z.
#[test]
fn losses_that_fade_and_spins_leave_the_error_of_rings() {
    let solved = |lambda: f64, spin: f64, e: f64| solved(&losing(ball(0.0, lambda, spin), e));
    for lambda in [0.3, 1.0] {
        for spin in [30.0, 300.0] {
            let [step, _] = apart(&solved(lambda, spin, 1.0), &solved(lambda, spin, 0.999_999));
            assert!(step < 5e-6, "{lambda} {spin}: {step}");
        }
        let [slow, fast] = [1.0, 1000.0].map(|spin| solved(lambda, spin, 0.1).error_estimate);
        assert!(fast < slow + 0.03 * FRICTION && slow < 0.02 * FRICTION, "{lambda}: {fast} {slow}");
    }
}

/// A tilted egg of 1 mm on a floor.
fn egg() -> Collision {
    let material = Material::from_shear(4e9, 0.2).unwrap();
    let shape = Surface::ellipsoid([1.3e-3, 1e-3, 0.8e-3]).unwrap();
    let inertia = shape.solid(MASS).unwrap();
    let egg = Body::new(shape, material, inertia)
        .turned(Attitude::about([0.3, 1.0, 0.2], 0.6).unwrap())
        .moving(Motion::new([0.4, 0.0, -0.6], [0.0; 3]).unwrap());
    Collision::new(egg, Body::plane(material), Friction::new(FRICTION).unwrap()).unwrap()
}

/// Two balls that glance off each other.
fn glancing() -> Collision {
    let material = Material::from_young(1e7, 0.3).unwrap();
    let ball = |velocity| {
        let motion = Motion::new(velocity, [0.0; 3]).unwrap();
        Body::sphere(4.5e-3, material, 9.5e-4).unwrap().moving(motion)
    };
    let friction = Friction::new(FRICTION).unwrap();
    Collision::new(ball([0.48, 0.0, -0.13]), ball([0.0; 3]), friction).unwrap()
}

/// By each method, what nearly nothing lost changes is a tenth of what ten times as much does, within the estimates.
#[test]
fn nothing_jumps_as_losses_fade() {
    let kinds = [
        ("uncoupled", ball(0.0, 1.2, 0.0)),
        ("rings", ball(0.25, 1.2, 0.0)),
        ("rings", ball(0.0, 1.2, 5e3)),
        ("spatial", egg()),
        ("uncoupled", glancing()),
    ];
    for (method, collision) in kinds {
        let [none, little, more] =
            [1.0, 0.999, 0.99].map(|e| solved(&losing(collision.clone(), e)));
        assert_eq!((none.method.name(), little.method.name()), (method, method));
        let change = |rebound: &Rebound| {
            let change = rebound.contact_velocity_after - none.contact_velocity_after;
            change / none.contact_velocity_before.norm()
        };
        let off = (change(&little) - 0.1 * change(&more)).norm();
        let estimate = none.error_estimate + little.error_estimate;
        assert!(off <= estimate.min(2e-3) + 2e-4, "{method}: {off} {estimate}");
    }
}
