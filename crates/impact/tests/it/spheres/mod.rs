//! One impact of spheres in contact axes, compared with the collision of the bodies.

use carom_impact::coupled::{CoupledImpact, TurningLaw};
use carom_impact::{Collision, Rebound};
use carom_laws::friction::Friction;
use nalgebra::Vector3;
use proptest::prelude::*;

pub(crate) fn friction(f: f64) -> Friction {
    Friction::new(f).unwrap()
}

pub(crate) fn collided(collision: &Collision) -> Rebound {
    collision.solve().unwrap().rebound().unwrap().clone()
}

/// chi of a solid sphere: 7/(2 kappa), kappa = (2 - nu)/(2 (1 - nu)).
pub(crate) fn chi_of_sphere(poisson: f64) -> f64 {
    7.0 * (1.0 - poisson) / (2.0 - poisson)
}

/// What rounding leaves open of R_x. The slip is a difference of velocities, known to a rounding of
/// these; R_x changes with the logarithm of psi by about the lesser of psi and 1/psi, and each of two
/// solutions is good to twice its tolerance of 5e-12, wherever such a slip puts it.
pub(crate) fn unknown(encounter: &Collision, rebound: &Rebound) -> f64 {
    let frame = encounter.frame();
    let before = frame.to_contact(&rebound.contact_velocity_before);
    let speed: f64 = encounter
        .bodies()
        .iter()
        .map(|body| {
            let arm = body.placed().surface().radius().unwrap_or(0.0);
            body.motion().velocity.norm() + body.motion().spin.norm() * arm
        })
        .sum();
    let (slip, rounding, friction) =
        (before.xy().norm(), 1e-15 * speed, encounter.friction().get());
    if friction == 0.0 {
        return 1e-11;
    }
    let psi = slip.max(rounding) / before.z / friction;
    if slip <= rounding {
        // It may be anything below: one frame has it zero, another not.
        return 1e-11 + 4.0 * psi.min(1.0);
    }
    2e-11 + 4.0 * rounding / slip * psi.min(1.0 / psi)
}

/// Bodies in their places against the same put along the normal, and against their matrices.
pub(crate) fn same(
    encounter: &Collision,
    along: impl Fn([f64; 3]) -> Collision,
) -> Result<(), TestCaseError> {
    // Matrices know of no centres that turn.
    let own = collided(&encounter.clone().keeping_axes());
    let other = collided(&along(encounter.frame().z().into()).keeping_axes());
    // Told nothing of the shapes.
    let (mobility, stiffness) = (*encounter.mobility(), encounter.hertz().stiffness());
    let impact =
        CoupledImpact::new(mobility, stiffness, encounter.friction(), encounter.velocity());
    let by_matrices = impact.unwrap().solve(TurningLaw::Coulomb).unwrap().velocity;
    let off = encounter.frame().to_space(&by_matrices) - own.contact_velocity_after;
    let slip = own.contact_velocity_before
        - encounter.frame().z() * own.contact_velocity_before.dot(&encounter.frame().z());
    let allowed =
        1e-12 * own.contact_velocity_before.norm() + unknown(encounter, &own) * slip.norm();
    prop_assert!(off.norm() <= allowed, "{:e}", off.norm());
    let (r, s) = (own.r_x.unwrap(), other.r_x.unwrap());
    prop_assert!((r - s).abs() <= 1e-12 + unknown(encounter, &own), "R_x {r} {s}");
    prop_assert!(r.abs() <= 1.0 + 1e-14, "R_x {r}");
    for (own, other) in [
        (own.duration, other.duration),
        (own.maximal_force, other.maximal_force),
        (own.maximal_approach, other.maximal_approach),
        (own.maximal_contact.semi_axis_b(), other.maximal_contact.semi_axis_a()),
        (own.energy.before, other.energy.before),
        (own.energy.after, other.energy.after),
    ] {
        prop_assert!((own / other - 1.0).abs() < 1e-12, "{own:e} {other:e}");
    }
    let heat = (own.energy.dissipated - other.energy.dissipated).abs() / own.energy.before;
    prop_assert!(heat < 1e-12, "{heat:e}");
    for rebound in [&own, &other] {
        conserves(encounter, rebound)?;
    }
    Ok(())
}

pub(crate) fn conserves(encounter: &Collision, rebound: &Rebound) -> Result<(), TestCaseError> {
    let energy = rebound.energy;
    prop_assert!(energy.dissipated >= 0.0, "{:e}", energy.dissipated);
    prop_assert!(energy.after <= energy.before * (1.0 + 1e-13), "gain {energy:?}");
    let balance = (energy.before - energy.after - energy.dissipated) / energy.before;
    prop_assert!(balance.abs() <= 1e-13, "{balance:e}");
    let (mut sum, mut scale) = (Vector3::zeros(), 0.0);
    for (body, after) in encounter.bodies().iter().zip(&rebound.motions) {
        let mass = body.inertia().mass();
        if mass.is_finite() {
            sum += mass * (after.velocity - body.motion().velocity);
            scale += mass * (after.velocity.norm() + body.motion().velocity.norm());
        } else {
            // What holds body 2 takes up what body 1 was given.
            sum -= rebound.impulse;
        }
    }
    prop_assert!(sum.norm() <= 1e-13 * scale, "momentum {:e}", sum.norm() / scale);
    Ok(())
}
