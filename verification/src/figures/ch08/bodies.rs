//! Fig. 8.2: the two bodies at the beginning of contact and during the impact.

use carom_geometry::{Attitude, Surface};
use carom_halfspace::Material;
use carom_impact::coupled::{Sample, TurningLaw};
use carom_impact::{Body, Collision, Lever, Motion, Rebound};
use carom_laws::friction::Friction;
use nalgebra::{Matrix3, Vector3};

use crate::{Absolute, Arrow, Failure, Figure, FigureResult, Panel, Point, Series, linspace};

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
) -> Result<Body, Failure> {
    let steel = Material::from_shear(80e9, 0.3)?;
    let surface = Surface::ellipsoid(axes)?;
    let volume = 4.0 / 3.0 * std::f64::consts::PI * axes[0] * axes[1] * axes[2];
    let inertia = surface.solid(7850.0 * volume)?;
    let attitude = Attitude::from_angles(angles[0], angles[1], angles[2])?;
    let point = attitude.to_space(&support(axes, &attitude.to_body(&outward)));
    Ok(Body::new(surface, steel, inertia).turned(attitude).at((-point).into())?.moving(motion))
}

/// Outline of a body in the parallel projection along y, by its support function.
fn outline(body: &Body, axes: [f64; 3], shift: &Vector3<f64>) -> Vec<Point> {
    linspace(0.0, 2.0 * std::f64::consts::PI, 181)
        .into_iter()
        .map(|angle| {
            let (sin, cos) = libm::sincos(angle);
            let normal = body.placed().attitude().to_body(&Vector3::new(cos, 0.0, sin));
            let point = body.placed().centre()
                + shift
                + body.placed().attitude().to_space(&support(axes, &normal));
            Point::new(1e3 * point.x, 1e3 * point.z)
        })
        .collect()
}

fn momenta(encounter: &Collision, motions: &[Motion; 2]) -> (Vector3<f64>, Vector3<f64>) {
    let mut sums = (Vector3::zeros(), Vector3::zeros());
    for (body, motion) in encounter.bodies().iter().zip(motions) {
        let turned = body.placed().attitude();
        let tensor = turned.matrix()
            * Matrix3::from_diagonal(&Vector3::from(body.inertia().moments()))
            * turned.matrix().transpose();
        let linear = body.inertia().mass() * motion.velocity;
        sums.0 += linear;
        sums.1 +=
            tensor * motion.spin + (body.placed().centre() - encounter.point()).cross(&linear);
    }
    sums
}

/// Velocity of the contact point of body 2 against body 1 (8.27).
fn relative(levers: &[Lever; 2], motions: &[Motion; 2]) -> Vector3<f64> {
    let of = |i: usize| levers[i].point_velocity(&motions[i].velocity, &motions[i].spin);
    of(1) - of(0)
}

/// Every instant that was computed.
fn history(encounter: &Collision) -> Result<Vec<Sample>, Failure> {
    let impact = encounter.impact()?.ok_or("they approach each other")?;
    Ok(impact.history(TurningLaw::default())?)
}

/// Kinetic energy of both bodies.
fn kinetic(encounter: &Collision, motions: &[Motion; 2]) -> f64 {
    encounter.bodies().iter().zip(motions).fold(0.0, |sum, (body, motion)| {
        let turned = body.placed().attitude();
        let spin = turned.to_body(&motion.spin);
        let turning = Vector3::from(body.inertia().moments()).dot(&spin.component_mul(&spin));
        sum + 0.5 * (body.inertia().mass() * motion.velocity.norm_squared() + turning)
    })
}

fn claims(figure: &mut Figure, encounter: &Collision, rebound: &Rebound) {
    let before = encounter.bodies().each_ref().map(Body::motion);
    let (p, l) = momenta(encounter, &before);
    let (q, m) = momenta(encounter, &rebound.motions);
    figure
        .at_most("momentum kept", (p - q).norm() / p.norm(), 1e-13)
        .source("equal and opposite forces");
    figure
        .at_most("angular momentum kept", (l - m).norm() / l.norm(), 1e-12)
        .source("equal and opposite forces through one point");
    let given =
        encounter.bodies()[0].inertia().mass() * (rebound.motions[0].velocity - before[0].velocity);
    figure
        .at_most(
            "the impulse is what body 1 gained",
            (rebound.impulse - given).norm() / given.norm(),
            1e-13,
        )
        .source("momentum");
    let levers = encounter.levers();
    let after = relative(levers, &rebound.motions);
    figure
        .at_most(
            "the bodies after the impulse part with v_E at the contact point",
            (after - rebound.contact_velocity_after).norm(),
            1e-13,
        )
        .source("(8.27)");
    let d = encounter.mobility().matrix();
    let change = encounter.frame().to_contact(&(rebound.contact_velocity_before - after));
    let impulse = encounter.frame().to_contact(&rebound.impulse);
    figure
        .at_most("v_A - v_E = D J", (d * impulse - change).norm() / change.norm(), 1e-13)
        .source("(8.29), motion of both bodies under J and -J");
    let [first, last] = [kinetic(encounter, &before), kinetic(encounter, &rebound.motions)];
    let energy = rebound.energy;
    figure
        .all_close(
            "kinetic energy before, after, and friction work, over that before",
            [
                (energy.before / first, 1.0),
                (energy.after / first, last / first),
                (energy.dissipated / first, 1.0 - last / first),
            ],
            Absolute(1e-13),
        )
        .source("m v²/2 and θ ω²/2 of both bodies");
    // Pressed together to zero relative velocity at the contact point, the bodies would lose v D^-1 v/2.
    let approach = encounter.frame().to_contact(&rebound.contact_velocity_before);
    let most =
        d.try_inverse().map_or(f64::NAN, |inverse| 0.5 * approach.dot(&(inverse * approach)));
    figure
        .close(
            "energy of the relative motion, over that before",
            encounter.mobility().energy(&approach) / first,
            most / first,
            Absolute(1e-14),
        )
        .source("v D⁻¹ v/2");
}

/// Claims that the forces add up to the impulse and their work along the slip to the heat, and that without
/// friction the impulse is along the normal.
fn course_claims(
    figure: &mut Figure,
    encounter: &Collision,
    rebound: &Rebound,
    smooth: &Collision,
) -> Result<(), Failure> {
    let history = history(encounter)?;
    let (mut impulse, mut work) = (Vector3::zeros(), 0.0);
    for pair in history.windows(2) {
        let mean = 0.5 * (pair[0].force + pair[1].force);
        impulse += mean * (pair[1].time - pair[0].time);
        work += mean.dot(&(pair[1].shift - pair[0].shift));
    }
    let expected = encounter.frame().to_contact(&rebound.impulse);
    let size = expected.norm();
    let mut pairs: Vec<(f64, f64)> =
        (0..3).map(|i| (impulse[i] / size, expected[i] / size)).collect();
    let before = encounter.bodies().each_ref().map(Body::motion);
    let lost = kinetic(encounter, &before) - kinetic(encounter, &rebound.motions);
    pairs.push((work / lost, 1.0));
    let peak = history.iter().map(|p| p.force.z).fold(0.0, f64::max);
    pairs.push((rebound.maximal_force / peak, 1.0));
    let last = history.last().map_or(f64::NAN, |p| p.time);
    pairs.push((rebound.duration / last, 1.0));
    figure.all_close(
            "impulse and work of the forces drawn, their peak and duration, over those of the impact",
            pairs,
            Absolute(2e-3),
        ).source("∫F dt and ∫F·dx by the trapezoidal rule");
    let outcome = smooth.solve()?;
    let free = outcome.rebound().ok_or("the bodies approach each other")?;
    let approach = smooth.frame().to_contact(&free.contact_velocity_before).z;
    let along = 2.0 * approach / smooth.mobility().matrix().m33;
    let impulse = smooth.frame().to_contact(&free.impulse);
    figure
        .all_close(
            "without friction: impulse over 2 v_z/D_zz along the normal, and heat",
            [
                (impulse.x / along, 0.0),
                (impulse.y / along, 0.0),
                (impulse.z / along, 1.0),
                (free.energy.dissipated / free.energy.before, 0.0),
                (1.0 - free.energy.after / free.energy.before, 0.0),
            ],
            Absolute(1e-12),
        )
        .source("an elastic impact reverses v_z (9.1)");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("bodies", "steel ellipsoids of 30, 20, 15 mm and 40, 25, 20 mm, f = 0.2");
    let up = Vector3::z();
    let upper =
        body(UPPER, [0.2, -0.5, 0.3], -up, Motion::new([-0.8, 0.2, -2.0], [9.0, 5.0, 0.0])?)?;
    let lower = body(LOWER, [-0.1, 0.4, 0.9], up, Motion::new([0.2, 0.0, 0.5], [0.0, -7.0, 4.0])?)?;
    let smooth = Collision::touching(upper.clone(), lower.clone(), Friction::new(0.0)?)?;
    let encounter = Collision::touching(upper, lower, Friction::new(0.2)?)?;
    let outcome = encounter.solve()?;
    let rebound = outcome.rebound().ok_or("the bodies approach each other")?;
    let history = history(&encounter)?;
    let deepest =
        history.iter().fold(history[0], |a, b| if b.shift.z > a.shift.z { *b } else { a });

    // The deformation is enlarged to be visible.
    let shift = encounter.frame().to_space(&deepest.shift) * 40.0;
    let panels = [("first touch", Vector3::zeros()), ("at the greatest approach, 40 times", shift)];
    for (title, shift) in panels {
        let mut panel = Panel::new("x / mm", "z / mm").titled(title).equal_aspect();
        let [one, two] = encounter.bodies();
        panel.add(Series::line("body 1", outline(one, UPPER, &Vector3::zeros())));
        panel.add(Series::line("body 2", outline(two, LOWER, &shift)));
        let at = |v: Vector3<f64>| Point::new(1e3 * v.x, 1e3 * v.z);
        let arm = |body: &Body, shift: Vector3<f64>| Arrow {
            tail: at(body.placed().centre() + shift),
            head: at(encounter.point() + shift),
        };
        panel.add(Series::arrows("R₁, R₂", [arm(one, Vector3::zeros()), arm(two, shift)]));
        figure.panel(panel);
    }
    let z = encounter.frame().z();
    figure
        .at_most("the search finds the touch", encounter.point().norm(), 1e-12)
        .source("both bodies were placed with it in the origin");
    figure
        .at_most("e_z is the common normal into body 1", (z - up).norm(), 1e-9)
        .source("both bodies were placed with it upright");
    // From the support points of the two ellipsoids, rotated back.
    let arms = encounter.levers().each_ref().map(Lever::arm);
    let mut pairs = Vec::new();
    for (i, (axes, normal)) in [(UPPER, -up), (LOWER, up)].into_iter().enumerate() {
        let attitude = encounter.bodies()[i].placed().attitude();
        let inside = attitude.to_body(&normal);
        let height = Vector3::from(axes).component_mul(&inside).norm();
        pairs.push((arms[i].dot(&z), [-height, height][i]));
    }
    figure.all_close("R₁z < 0, R₂z > 0", pairs, Absolute(1e-12)).source(
        "distance of a tangent plane from the middle of an ellipsoid, |(a n_x, b n_y, c n_z)|",
    );
    let gap = encounter.frame().relative_curvature();
    figure.decreasing("A > B > 0", [gap.a(), gap.b(), 0.0]).source("(5.2)");
    figure
        .at_most("A x² + B y² is the gap, error at 0.1 mm", gap_error(&encounter), 1e-3)
        .source("distance between the ellipsoids along the normal");
    claims(&mut figure, &encounter, rebound);
    course_claims(&mut figure, &encounter, rebound, &smooth)?;
    figure.deviation(
        "D and E of (8.43) with the inertia tensors missing",
        "D = Σ Gᵀ θ⁻¹ G + 1/m, E = Fᵀ G",
        "misprint; verified by an impulse on two bodies",
    );
    Ok(figure)
}

/// Relative error of the quadratic gap against the ellipsoids' own, in eight directions.
fn gap_error(encounter: &Collision) -> f64 {
    const DISTANCE: f64 = 1e-4;
    let frame = encounter.frame();
    let gap = frame.relative_curvature();
    // Height of a body's surface over the tangent plane, by Newton's method along the normal.
    let height = |body: &Body, axes: [f64; 3], foot: &Vector3<f64>| {
        let weights = Vector3::from(axes).map(|a| 1.0 / (a * a));
        let n = body.placed().attitude().to_body(&frame.z());
        let start = body.placed().attitude().to_body(&(foot - body.placed().centre()));
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
