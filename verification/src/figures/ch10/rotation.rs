//! Fig. 10.1: the rotation, and the mirror image of its adhesive part.

use carom_impact::normal::{DURATION, state_at};
use carom_impact::torsional::{TorsionalGroups, TorsionalImpact, TorsionalPoint, limits};
use carom_laws::torsion::history::TwistHistory;

use crate::{Absolute, Claim, Failure, Figure, FigureResult, Panel, Series};

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("ε, Ω", "0.5, 0.1: strong torsion, so that the rebound shows");
    let course = course(0.5, 0.1)?;
    let mut panel = Panel::new("time, normalised (9.4)", "rotation, normalised");
    let points: Vec<(f64, f64)> = course.iter().map(|p| (p.time, p.twist)).collect();
    panel.add(Series::line("β", points));
    let compression = |p: &&TorsionalPoint| p.normal_velocity >= 0.0;
    let mirrored: Vec<(f64, f64)> =
        course.iter().filter(compression).map(|p| (DURATION - p.time, p.twist)).collect();
    panel.add(Series::dashed("mirror image of the compression", mirrored));
    figure.panel(panel);
    let mut panel = Panel::new("time, normalised (9.4)", "radius, by its maximum");
    let radius: Vec<(f64, f64)> = course.iter().map(|p| (p.time, p.radius)).collect();
    panel.add(Series::line("contact radius", radius));
    let stick: Vec<(f64, f64)> = course.iter().map(|p| (p.time, p.stick_radius)).collect();
    panel.add(Series::dashed("stick radius", stick));
    figure.panel(panel);

    let stepped = stepped(0.5, 0.1, 20_000)?;
    let most = |value: fn(&TorsionalPoint) -> f64| course.iter().map(value).fold(0.0, f64::max);
    let found = [
        (most(|p| p.twist), stepped.twist),
        (most(|p| p.torque), stepped.torque),
        (course.last().map_or(f64::NAN, |p| p.twist), stepped.last),
    ];
    figure
        .all_close("greatest rotation and torque, rotation at the end", found, Absolute(1e-4))
        .source("β″ = -ε M stepped in time with the memory of a twisted contact");
    let end = course.last().map_or(f64::NAN, |p| p.spin);
    figure
        .close("spin at the end", end, 0.404_980_700_744, Absolute(2e-11))
        .source("independent program");
    let whole = TorsionalImpact::new(TorsionalGroups::new(0.5, 0.1)?)?;
    figure
        .close(
            "energy lost over that of the spin",
            whole.energy_loss(),
            1.0 - 0.404_980_700_744 * 0.404_980_700_744,
            Absolute(4e-11),
        )
        .source("1 less the square of the spin at the end, independent program");
    let falling = course.iter().filter(|p| p.time > 1.5).map(|p| p.stick_radius);
    figure.decreasing("stick radius in restitution", falling).source("section 10.2");
    figure.claim(reversal()?);
    figure.deviation(
        "(10.7): slip where the torques' increments meet, 3π/16",
        "1/2 in place of 3π/16: slip begins at the rim by the local traction",
        "17.8 % late; agrees with a solution by rings",
    );
    figure.deviation(
        "after (10.24): the impact starts with partial slip",
        "it starts with adhesion; slip begins at the end of compression",
        "as the text after (10.7) says itself",
    );
    Ok(figure)
}

fn course(epsilon: f64, omega: f64) -> Result<Vec<TorsionalPoint>, Failure> {
    let angle = |i: u32| std::f64::consts::PI * f64::from(i) / 300.0;
    let velocities: Vec<f64> = (0..=300).map(|i| libm::cos(angle(i))).collect();
    Ok(TorsionalImpact::trace(TorsionalGroups::new(epsilon, omega)?, &velocities)?)
}

/// Without slip, the difference of the rotation and its mirror image is 2 y_1 times the odd solution.
fn reversal() -> Result<Claim, Failure> {
    let course = course(0.5, 0.0)?;
    let end = course.last().map_or(f64::NAN, |p| p.spin);
    let y_1 = course[150].spin;
    let limit = limits::no_slip(0.5)?;
    let pairs = [(end, limit), (2.0 * y_1 * y_1 - 1.0, limit)];
    Ok(Claim::all_close("small spin: 2 y_1² - 1", pairs, Absolute(2e-6))
        .source("Wronskian of the two halves"))
}

/// Extremes of an impact integrated in time.
struct Stepped {
    twist: f64,
    torque: f64,
    last: f64,
}

/// The same impact by leapfrog: `beta'' = -epsilon mu(a, Omega beta)/Omega`.
fn stepped(epsilon: f64, omega: f64, steps: usize) -> Result<Stepped, Failure> {
    let mut contact = TwistHistory::new();
    let (mut twist, mut spin) = (0.0, 1.0);
    let mut found = Stepped { twist: 0.0, torque: 0.0, last: 0.0 };
    let dt = DURATION / steps as f64;
    for step in 0..steps {
        twist += 0.5 * dt * spin;
        let radius = state_at((step as f64 + 0.5) * dt).compression.sqrt();
        let torque = contact.advance(radius, omega * twist)? / omega;
        spin -= dt * epsilon * torque;
        twist += 0.5 * dt * spin;
        found = Stepped {
            twist: found.twist.max(twist),
            torque: found.torque.max(torque),
            last: twist,
        };
    }
    Ok(found)
}
