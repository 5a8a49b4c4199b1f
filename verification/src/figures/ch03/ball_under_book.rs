//! Fig. 3.7: a rubber ball thrown under a book held over a table.

use carom_impact::restitution::of_spheres;

use crate::{Axis, Claim, Figure, FigureResult, Panel, Series, Tolerance};

const FRICTION: f64 = 0.3;
const KAPPA: f64 = 1.5;

/// Horizontal velocity and rim velocity R omega of the ball, in units of the vertical velocity.
#[derive(Clone, Copy)]
struct Ball {
    velocity: f64,
    rim: f64,
}

impl Ball {
    /// After a bounce below (`side` = 1) or above (-1) with R_x of the sliding velocity there.
    fn bounce(self, side: f64, restitution: impl Fn(f64) -> f64) -> Self {
        // Contact velocity s = v - side R omega; s' = -R_x s by an impulse at the rim.
        let slip = self.velocity - side * self.rim;
        let change = -(1.0 + restitution(slip.abs())) * slip;
        Self {
            velocity: self.velocity + 2.0 / 7.0 * change,
            rim: self.rim - side * 5.0 / 7.0 * change,
        }
    }
}

/// The ball before each flight: table, book, table, after starting at 45 degrees without spin.
fn flights(restitution: impl Fn(f64) -> f64) -> [Ball; 4] {
    let start = Ball { velocity: 1.0, rim: 0.0 };
    let first = start.bounce(1.0, &restitution);
    let second = first.bounce(-1.0, &restitution);
    [start, first, second, second.bounce(1.0, &restitution)]
}

fn path(flights: &[Ball; 4]) -> Vec<(f64, f64)> {
    let mut x = 0.0;
    let mut points = vec![(x, 1.0)];
    for (i, ball) in flights.iter().enumerate() {
        x += ball.velocity;
        points.push((x, if i % 2 == 0 { 0.0 } else { 1.0 }));
    }
    points
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("R_x", "0.6 (λ about 3, κ about 3/2, f about 0.3, 45°)");
    figure.derived("κ", "3/2 exactly at ν = 1/2");
    figure.assumed("gravity", "none over a distance of one gap");
    let exact = flights(|slip| of_spheres(KAPPA, slip / FRICTION).unwrap_or(f64::NAN));
    let constant = flights(|_| 0.6);
    let smooth = flights(|_| -1.0);
    let plastic = flights(|_| 0.0);
    let mut panel = Panel::new(Axis::linear("x / gap"), Axis::linear("height / gap"))
        .titled("Path between table and book");
    for (label, flights) in [
        ("carom, κ = 3/2, f = 0.3", &exact),
        ("R_x = 0.6 throughout", &constant),
        ("R_x = 0", &plastic),
        ("R_x = -1 (no friction)", &smooth),
    ] {
        panel.add(Series::line(label, path(flights)));
    }
    figure.panel(panel);

    let velocities = |flights: &[Ball; 4]| [1, 2, 3].map(|i| flights[i].velocity);
    let close = |name: &str, measured: [f64; 3], expected: [f64; 3], tolerance: f64| {
        Claim::all_close(name, measured.into_iter().zip(expected), Tolerance::Absolute(tolerance))
            .source("independent kinematics")
    };
    figure.claim(close(
        "velocities after each bounce, R_x = 0.6",
        velocities(&constant),
        [0.542_857_142_9, -0.227_755_102, -0.481_889_213],
        1e-8,
    ));
    figure.claim(close(
        "velocities with the exact R_x(λ)",
        velocities(&exact),
        [0.548_29, -0.051_71, -0.174_42],
        1e-5,
    ));
    figure.claim(Claim::close(
        "R_x(κ = 3/2, λ = 3)",
        of_spheres(KAPPA, 3.0)?,
        0.595_052,
        Tolerance::Absolute(1e-6),
    ));
    figure.claim(Claim::at_most("the ball comes back from the book", exact[2].velocity, 0.0));
    let forward = smooth.iter().chain(&plastic).map(|b| b.velocity).fold(f64::INFINITY, f64::min);
    figure.claim(Claim::at_least("without friction, or plastic, it does not", forward, 0.1));
    let energy = |ball: &Ball| ball.velocity * ball.velocity + 0.4 * ball.rim * ball.rim;
    figure.claim(Claim::decreasing("energy falls at each bounce", exact.iter().map(energy)));
    figure.deviation("fig. 15.1 in the text", "fig. 15.2", "slip of the text");
    Ok(figure)
}
