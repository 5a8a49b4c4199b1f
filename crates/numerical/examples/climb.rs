//! Looks for the impact whose error by rings is the largest part of its estimate: `climb SEED MINUTES [lossy]`; `climb [lossy]`
//! with the 16 numbers of one (parts of ranges) judges it on finer grids.
//!
//! From the worst of twelve drawn impacts it climbs by small changes, and begins anew. The referee is a grid of 28 cells;
//! what 20 cells and half of the steps change is granted to it.

use std::f64::consts::TAU;
use std::time::Instant;

use carom_drawn::{Draw as _, Splitmix};
use carom_geometry::Inertia;
use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, NormalRestitution, RingImpact};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw as _, ContactLoad, Shift};
use carom_numerical::NumericalImpact;
use carom_solver::NumericalLaw;
use nalgebra::Vector3;

type Failure = Box<dyn std::error::Error>;
type Numbers = [f64; 16];

fn between(low: f64, high: f64, part: f64) -> f64 {
    low * (high / low).powf(part)
}

/// Zero in the middle of the range, else from `low` to `high`, of either sign.
fn signed(low: f64, high: f64, part: f64) -> f64 {
    let size = (2.0 * (part - 0.5).abs() - 0.3) / 0.7;
    if size < 0.0 { 0.0 } else { between(low, high, size).copysign(part - 0.5) }
}

/// An impact of a ball of radius, mass and velocity 1 on another one or on a plane.
fn collision(of: &Numbers, lossy: bool) -> Result<Collision, Failure> {
    let friction = between(0.02, 2.0, of[0]);
    let (slip, large) = (friction * between(0.1, 8.0, of[1]), 0.005 + 0.055 * of[2]);
    let ratio = if of[3] < 0.2 { 1.0 } else { between(0.01, 100.0, of[4]) };
    let nu = [0.5 * of[5], if of[3] < 0.2 { 0.5 * of[5] } else { 0.5 * of[6] }];
    let (sine, cosine) = (TAU * of[7]).sin_cos();
    let about = if lossy { 0.0 } else { signed(0.1, 6.0, of[8]) * friction / large };
    let along = Vector3::new(signed(0.1, 2.0, of[9]), signed(0.1, 2.0, of[10]), 0.0) * slip;
    let centre = Vector3::new(slip * cosine, slip * sine, -1.0) + along.cross(&Vector3::z());
    let motion = Motion::new(centre.into(), [along.x, along.y, about])?;
    let ball = |radius: f64, material, mass: f64, part: f64| -> Result<_, Failure> {
        let inertia = Inertia::new(mass, [between(0.2, 0.66, part) * mass * radius * radius; 3])?;
        Ok(Body::sphere(radius, material, mass)?.with_inertia(inertia))
    };
    let made = |unit: f64| -> Result<Collision, Failure> {
        let one = Material::from_shear(unit, nu[0])?;
        let two = Material::from_shear(ratio * unit, nu[1])?;
        let upper = ball(1.0, one, 1.0, of[11])?.at([0.0, 0.0, 1.0])?.moving(motion);
        let radius = between(0.3, 10.0, of[13]);
        let lower = match of[12] < 0.5 {
            true => Body::plane(two),
            false => ball(radius, two, between(0.1, 30.0, of[14]), 0.5)?.at([0.0, 0.0, -radius])?,
        };
        let made = Collision::new(upper, lower, Friction::new(friction)?)?.keeping_axes();
        let loss = NormalRestitution::new(between(0.2, 1.0, of[15]))?;
        Ok(if lossy { made.with_normal_restitution(loss) } else { made })
    };
    // The radius of the contact falls with the modulus to the power 1/5.
    let first = made(1e9)?;
    let deepest = first.impact()?.ok_or("they part")?.deepest();
    made(1e9 * (first.hertz().ellipse(deepest)?.semi_axis_a() / large).powi(5))
}

/// The velocity after the impact in contact axes, by leapfrog steps on a grid.
fn on_grid(of: &Collision, [cells, steps]: [usize; 2]) -> Result<Vector3<f64>, Failure> {
    let impact = of.impact()?.ok_or("they part")?;
    let law = NumericalLaw::new(*of.hertz(), of.friction(), impact.deepest(), cells)?;
    let mut law = law.within(1e-5)?.with_slip_ahead();
    let (d, z, before) = (of.mobility().matrix(), of.frame().z(), impact.velocity());
    let about = of.levers().iter().map(|lever| z.dot(&(lever.inverse_tensor() * z))).sum();
    let mobility = [d.m33, d.m11, d.m22, about];
    let spins = of.bodies().each_ref().map(|body| body.motion().spin.dot(&z));
    let h = 2.943_276 * impact.deepest() / before.z / steps as f64;
    let mut rates = [before.z, before.x, before.y, spins[0] - spins[1]];
    let (mut at, mut load) = ([0.0; 4], [0.0; 4]);
    let pushed = |rates: &[f64; 4], load: &[f64; 4], time: f64| -> [f64; 4] {
        std::array::from_fn(|i| rates[i] - mobility[i] * load[i] * time)
    };
    loop {
        let middle = pushed(&rates, &load, 0.5 * h);
        let next: [f64; 4] = std::array::from_fn(|i| at[i] + h * middle[i]);
        if next[0] <= 0.0 {
            let after = pushed(&rates, &load, 0.4 * h * at[0] / (at[0] - next[0]));
            return Ok(Vector3::new(after[1], after[2], after[0]));
        }
        let [zeta, xi, eta, omega] = next;
        let ContactLoad { f_x, f_y, f_z, m_z } = law.advance(Shift { zeta, xi, eta, omega })?;
        load = [f_z, f_x, f_y, m_z];
        (at, rates) = (next, pushed(&middle, &load, 0.5 * h));
    }
}

/// Error beyond what is granted to the referee, estimate, and what is granted, over f v_z (v_z for f above 1).
fn judged(of: &Numbers, lossy: bool, cells: usize) -> Result<[f64; 3], Failure> {
    let (of, steps) = (collision(of, lossy)?, 24 * cells.div_ceil(14));
    let run = |at: [usize; 2]| -> Result<Vector3<f64>, Failure> {
        if !lossy {
            return on_grid(&of, at);
        }
        let outcome = NumericalImpact::new(&of).with(at[0], at[1])?.solve()?;
        let after = outcome.rebound().ok_or("they part")?.contact_velocity_after;
        Ok(of.frame().to_contact(&after))
    };
    let [fine, coarse] = [run([cells, 2 * steps])?, run([cells, steps])?];
    let (by_cells, by_steps) = (coarse - run([cells * 5 / 7, steps])?, (fine - coarse) / 3.0);
    let (after, granted) = (fine + by_steps + 0.27 * by_cells, by_steps.norm() + by_cells.norm());
    let outcome = RingImpact::new(&of).solve()?;
    let rebound = outcome.rebound().ok_or("they part")?;
    let error = (of.frame().to_contact(&rebound.contact_velocity_after) - after).norm();
    let estimate = rebound.error_estimate * rebound.contact_velocity_before.norm();
    let scale = of.friction().get().min(1.0) * of.velocity().z;
    Ok([(error - granted).max(0.0), estimate, granted].map(|velocity| velocity / scale))
}

fn climb(seed: u64, minutes: f64, ratio: impl Fn(&Numbers) -> f64) {
    let (mut draw, start) = (Splitmix(seed), Instant::now());
    while start.elapsed().as_secs_f64() < 60.0 * minutes {
        let (mut best, mut at, mut by) = (-1.0, [0.5; 16], 0.15);
        for trial in 0..60 {
            let to: Numbers = std::array::from_fn(|i| match trial < 12 {
                true => draw.part(),
                false if draw.part() > 0.4 => at[i],
                false => (at[i] + by * (draw.signed() + draw.signed())).clamp(0.0, 1.0),
            });
            let found = ratio(&to);
            by = if trial < 12 { 0.15 } else { by * if found > best { 1.3 } else { 0.95 } };
            (best, at) = if found > best { (found, to) } else { (best, at) };
        }
        println!("{best:.3} {at:.4?}");
    }
}

fn main() -> Result<(), Failure> {
    let lossy = std::env::args().any(|word| word == "lossy");
    let numbers: Vec<f64> = std::env::args().filter_map(|word| word.parse().ok()).collect();
    if let Ok(of) = Numbers::try_from(numbers.clone()) {
        for cells in [28, 48, 64, 80] {
            println!("{cells} {:.6?}", judged(&of, lossy, cells)?);
        }
        return Ok(());
    }
    let [seed, minutes] = numbers[..] else { return Err("SEED MINUTES [lossy]".into()) };
    let ratio = |[error, estimate, _]: [f64; 3]| error / estimate;
    climb(seed as u64, minutes, |of| judged(of, lossy, 28).map_or(0.0, ratio));
    Ok(())
}
