//! Fig. 8.2: the two bodies at the beginning of contact and during the impact.

use carom_halfspace::Material;
use carom_impact::{Attitude, Encounter, Lever, Motion, PlacedBody, Rebound, Surface};
use carom_laws::friction::Friction;
use nalgebra::{Matrix3, Vector3};

use crate::{Arrow, Axis, Claim, Figure, FigureResult, Panel, Point, Series, Tolerance, linspace};

const UPPER: [f64; 3] = [0.03, 0.02, 0.015];
const LOWER: [f64; 3] = [0.04, 0.025, 0.02];

/// The point of the ellipsoid with this outward normal, in its own axes.
fn support(axes: [f64; 3], normal: &Vector3<f64>) -> Vector3<f64> {
    let scaled = Vector3::from(axes).component_mul(normal);
    Vector3::from(axes).component_mul(&scaled) / scaled.norm()
}

fn body(
    axes: [f64; 3],
    angles: [f64; 3],
    outward: Vector3<f64>,
    motion: Motion,
) -> Result<PlacedBody, Box<dyn std::error::Error + Send + Sync>> {
    let steel = Material::from_shear(80e9, 0.3)?;
    let surface = Surface::ellipsoid(axes)?;
    let volume = 4.0 / 3.0 * std::f64::consts::PI * axes[0] * axes[1] * axes[2];
    let inertia = surface.solid(7850.0 * volume)?;
    let attitude = Attitude::from_angles(angles[0], angles[1], angles[2])?;
    let point = attitude.to_space(&support(axes, &attitude.to_body(&outward)));
    Ok(PlacedBody::new(surface, steel, inertia)
        .turned(attitude)
        .at((-point).into())?
        .moving(motion))
}

/// Outline of a body in the parallel projection along y, by its supports.
fn outline(body: &PlacedBody, axes: [f64; 3], shift: &Vector3<f64>) -> Vec<Point> {
    linspace(0.0, 2.0 * std::f64::consts::PI, 181)
        .into_iter()
        .map(|angle| {
            let (sin, cos) = libm::sincos(angle);
            let normal = body.attitude().to_body(&Vector3::new(cos, 0.0, sin));
            let point = body.centre() + shift + body.attitude().to_space(&support(axes, &normal));
            Point::new(1e3 * point.x, 1e3 * point.z)
        })
        .collect()
}

fn momenta(encounter: &Encounter, motions: &[Motion; 2]) -> (Vector3<f64>, Vector3<f64>) {
    let mut sums = (Vector3::zeros(), Vector3::zeros());
    for (body, motion) in encounter.bodies().iter().zip(motions) {
        let turned = body.attitude();
        let tensor = turned.matrix()
            * Matrix3::from_diagonal(&Vector3::from(body.inertia().moments()))
            * turned.matrix().transpose();
        let linear = body.inertia().mass() * motion.velocity;
        sums.0 += linear;
        sums.1 += tensor * motion.spin + (body.centre() - encounter.point()).cross(&linear);
    }
    sums
}

/// Velocity of the contact point of body 2 against body 1 (8.27).
fn relative(levers: &[Lever; 2], motions: &[Motion; 2]) -> Vector3<f64> {
    let of = |i: usize| levers[i].point_velocity(&motions[i].velocity, &motions[i].spin);
    of(1) - of(0)
}

fn claims(figure: &mut Figure, encounter: &Encounter, rebound: &Rebound) {
    let before = encounter.bodies().each_ref().map(PlacedBody::motion);
    let (p, l) = momenta(encounter, &before);
    let (q, m) = momenta(encounter, &rebound.motions);
    figure.claim(Claim::at_most("momentum kept", (p - q).norm() / p.norm(), 1e-13));
    figure.claim(Claim::at_most("angular momentum kept", (l - m).norm() / l.norm(), 1e-12));
    let levers = encounter.levers();
    let after = relative(levers, &rebound.motions);
    figure.claim(Claim::at_most(
        "the bodies after the impulse part with v_E at the contact point",
        (after - rebound.velocity_after).norm(),
        1e-13,
    ));
    let d = encounter.mobility().matrix();
    let change = encounter.frame().to_contact(&(rebound.velocity_before - after));
    let impulse = encounter.frame().to_contact(&rebound.impulse);
    figure.claim(
        Claim::at_most("v_A - v_E = D J", (d * impulse - change).norm() / change.norm(), 1e-13)
            .source("(8.29), motion of both bodies under J and -J"),
    );
    let energy = rebound.energy;
    let lost = energy.before - energy.after;
    figure.claim(Claim::close(
        "loss of kinetic energy is the friction work",
        lost / energy.before,
        energy.dissipated / energy.before,
        Tolerance::Absolute(1e-13),
    ));
    figure.claim(Claim::at_least("energy is lost", lost / energy.before, 1e-3));
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("bodies", "steel ellipsoids of 30, 20, 15 mm and 40, 25, 20 mm, f = 0.2");
    let up = Vector3::z();
    let upper =
        body(UPPER, [0.2, -0.5, 0.3], -up, Motion::new([-0.8, 0.2, -2.0], [9.0, 5.0, 0.0])?)?;
    let lower = body(LOWER, [-0.1, 0.4, 0.9], up, Motion::new([0.2, 0.0, 0.5], [0.0, -7.0, 4.0])?)?;
    let encounter = Encounter::find(upper, lower, Friction::new(0.2)?)?;
    let outcome = encounter.solve()?;
    let rebound = outcome.rebound().ok_or("the bodies approach each other")?;
    let history = encounter.history()?;
    let deepest =
        history.iter().fold(history[0], |a, b| if b.shift.z > a.shift.z { *b } else { a });

    // Deformation enlarged so that it shows.
    let shift = encounter.frame().to_space(&deepest.shift) * 40.0;
    let panels = [("first touch", Vector3::zeros()), ("at the greatest approach, 40 times", shift)];
    for (title, shift) in panels {
        let mut panel =
            Panel::new(Axis::linear("x / mm"), Axis::linear("z / mm")).titled(title).equal_aspect();
        let [one, two] = encounter.bodies();
        panel.add(Series::line("body 1", outline(one, UPPER, &Vector3::zeros())));
        panel.add(Series::line("body 2", outline(two, LOWER, &shift)));
        let at = |v: Vector3<f64>| Point::new(1e3 * v.x, 1e3 * v.z);
        let arm = |body: &PlacedBody, shift: Vector3<f64>| Arrow {
            tail: at(body.centre() + shift),
            head: at(encounter.point() + shift),
        };
        panel.add(Series::arrows("R₁, R₂", [arm(one, Vector3::zeros()), arm(two, shift)]));
        figure.panel(panel);
    }
    let z = encounter.frame().z();
    figure.claim(Claim::at_most("the search finds the touch", encounter.point().norm(), 1e-12));
    figure.claim(Claim::at_most("e_z is the common normal into body 1", (z - up).norm(), 1e-9));
    let arms = encounter.levers().each_ref().map(Lever::arm);
    figure.claim(Claim::at_most("R₁z < 0", arms[0].dot(&z), 0.0));
    figure.claim(Claim::at_least("R₂z > 0", arms[1].dot(&z), 0.0));
    let gap = encounter.frame().relative_curvature();
    figure.claim(Claim::decreasing("A > B > 0", [gap.a(), gap.b(), 0.0]));
    figure.claim(
        Claim::at_most("A x² + B y² is the gap, error at 0.1 mm", gap_error(&encounter), 1e-3)
            .source("distance between the ellipsoids along the normal"),
    );
    claims(&mut figure, &encounter, rebound);
    figure.deviation(
        "D and E of (8.43) with the inertia tensors missing",
        "D = Σ Gᵀ θ⁻¹ G + 1/m, E = Fᵀ G",
        "misprint; verified by an impulse on two bodies",
    );
    Ok(figure)
}

/// Relative error of the quadratic gap against the ellipsoids' own, in eight directions.
fn gap_error(encounter: &Encounter) -> f64 {
    const DISTANCE: f64 = 1e-4;
    let frame = encounter.frame();
    let gap = frame.relative_curvature();
    // Height of a body's surface over the tangent plane, by Newton's method along the normal.
    let height = |body: &PlacedBody, axes: [f64; 3], foot: &Vector3<f64>| {
        let weights = Vector3::from(axes).map(|a| 1.0 / (a * a));
        let n = body.attitude().to_body(&frame.z());
        let start = body.attitude().to_body(&(foot - body.centre()));
        let mut z = 0.0;
        for _ in 0..20 {
            let p = start + n * z;
            let weighted = p.component_mul(&weights);
            z -= 0.5 * (p.dot(&weighted) - 1.0) / n.dot(&weighted);
        }
        z
    };
    let [one, two] = encounter.bodies();
    let mut worst: f64 = 0.0;
    for i in 0..8 {
        let (sin, cos) = libm::sincos(0.4 * f64::from(i));
        let (x, y) = (DISTANCE * cos, DISTANCE * sin);
        let mut mean = 0.0;
        // Opposite points: the cubic terms cancel.
        for side in [1.0, -1.0] {
            let foot = encounter.point() + (frame.x() * x + frame.y() * y) * side;
            mean += 0.5 * (height(one, UPPER, &foot) - height(two, LOWER, &foot));
        }
        worst = worst.max((mean / gap.gap(x, y) - 1.0).abs());
    }
    worst
}
