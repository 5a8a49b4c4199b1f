//! Fig. 3.7: a rubber ball thrown under a book held over a table.

use carom_halfspace::Material;
use carom_impact::closed_form::{normal_energy_loss, tangential_energy_loss};
use carom_impact::restitution::of_spheres;
use carom_impact::{Body, Collision, Motion};
use carom_laws::friction::Friction;

use crate::{Absolute, Failure, Figure, FigureResult, Panel, Series};

const FRICTION: f64 = 0.3;
const KAPPA: f64 = 1.5;
/// Radius and mass of the ball, in metres and kilograms: they cancel.
const RADIUS: f64 = 0.02;
const MASS: f64 = 0.04;

/// Horizontal velocity and rim velocity R omega of the ball, in units of the vertical velocity.
#[derive(Clone, Copy)]
struct Ball {
    velocity: f64,
    rim: f64,
}

impl Ball {
    /// The ball after a bounce on the table (`side` = 1) or the book (-1), with R_x of the sliding velocity
    /// there.
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

/// The same by collisions of a ball with rigid planes, and the energy lost in each over the mass of the ball.
fn collisions(friction: f64) -> Result<([Ball; 4], [f64; 3]), Failure> {
    let rubber = Material::from_shear(1e6, 0.5)?;
    let mut motion = Motion::new([1.0, 0.0, -1.0], [0.0; 3])?;
    let mut flights = [Ball { velocity: 1.0, rim: 0.0 }; 4];
    let mut lost = [0.0; 3];
    for (i, side) in [1.0, -1.0, 1.0].into_iter().enumerate() {
        let ball = Body::sphere(RADIUS, rubber, MASS)?.moving(motion);
        let plane = Body::plane(Material::RIGID);
        let collision = Collision::along(ball, plane, [0.0, 0.0, side], Friction::new(friction)?)?;
        let outcome = collision.solve()?;
        let rebound = outcome.rebound().ok_or("the ball flies at the plane")?;
        motion = rebound.motions[0];
        let rim = RADIUS * motion.spin.y;
        flights[i + 1] = Ball { velocity: motion.velocity.x, rim };
        lost[i] = rebound.energy.dissipated / MASS;
    }
    Ok((flights, lost))
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
    let (exact, lost) = collisions(FRICTION)?;
    let (smooth, unlost) = collisions(0.0)?;
    let constant = flights(|_| 0.6);
    let plastic = flights(|_| 0.0);
    let mut panel = Panel::new("x / gap", "height / gap").titled("Path between table and book");
    for (label, flights) in [
        ("carom, κ = 3/2, f = 0.3", &exact),
        ("R_x = 0.6 throughout", &constant),
        ("R_x = 0", &plastic),
        ("R_x = -1 (no friction)", &smooth),
    ] {
        panel.add(Series::line(label, path(flights)));
    }
    figure.panel(panel);

    let states = |flights: &[Ball; 4]| -> Vec<f64> {
        flights[1..].iter().flat_map(|ball| [ball.velocity, ball.rim]).collect()
    };
    // The rim velocity changes by 5/2 of that of the centre: in the sense of rolling on the table, opposite
    // at the book.
    let velocities = [0.548_29, -0.051_71, -0.174_42];
    let rims = [1.129_275, -0.370_725, -0.063_95];
    let printed = velocities.into_iter().zip(rims).flat_map(|(velocity, rim)| [velocity, rim]);
    figure
        .all_close(
            "velocity and rim velocity after each bounce",
            states(&exact).into_iter().zip(printed),
            Absolute(5e-5),
        )
        .source("independent program, five decimals; momentum of a solid ball");
    let energy = |velocity: f64, rim: f64| 0.5 * velocity * velocity + 0.2 * rim * rim;
    let mut before = 0.5;
    let losses: Vec<(f64, f64)> = (0..3)
        .map(|i| {
            let after = energy(velocities[i], rims[i]);
            let pair = (lost[i], before - after);
            before = after;
            pair
        })
        .collect();
    figure
        .all_close("energy lost at each bounce", losses, Absolute(5e-5))
        .source("kinetic energies of the independent program's velocities");
    let first = tangential_energy_loss([MASS, f64::INFINITY], of_spheres(KAPPA, 10.0 / 3.0)?, 1.0)?;
    figure
        .close(
            "of the first by (9.59), over the mass",
            first / MASS,
            (1.0 - 0.580_998 * 0.580_998) / 7.0,
            Absolute(2e-7),
        )
        .source("(9.59) with R_x of an independent program");
    let normal = normal_energy_loss([MASS, f64::INFINITY], 0.6, 1.0)?;
    figure
        .close("(9.60) for R_z = 0.6, over the mass", normal / MASS, 0.32, Absolute(1e-15))
        .source("(1 - 0.36)/2");
    // A hollow ball has θ = (2/3) m R², so that D_xx/D_zz = 5/2.
    let rubber = Material::from_shear(1e6, 0.5)?;
    let hollow = Body::spherical_shell(RADIUS, rubber, MASS)?
        .moving(Motion::new([1.0, 0.0, -1.0], [0.0; 3])?);
    let outcome =
        Collision::new(hollow, Body::plane(Material::RIGID), Friction::new(0.1)?)?.solve()?;
    let [ball, _] = outcome.motions();
    figure
        .all_close(
            "a hollow ball that slides throughout, f = 0.1: velocity and rim velocity",
            [(ball.velocity.x, 0.8), (RADIUS * ball.spin.y, 0.3)],
            Absolute(1e-12),
        )
        .source("impulse 2 f m v_n; moment of inertia (2/3) m R²");
    let restitutions = [(3.0, 0.595_052), (10.0 / 3.0, 0.580_998), (2.8325, 0.597_008_7)];
    let restitutions: Result<Vec<(f64, f64)>, Failure> =
        restitutions.iter().map(|&(lambda, r)| Ok((of_spheres(KAPPA, lambda)?, r))).collect();
    figure
        .all_close(
            "R_x at λ = 3, at 45° (λ = 10/3), and at its peak",
            restitutions?,
            Absolute(1e-6),
        )
        .source("independent program; the text says 0.6");
    figure
        .at_most("the ball comes back from the book", exact[2].velocity, -0.05)
        .source("text: the ball comes back");
    let kept = smooth[1..].iter().map(|ball| (ball.velocity, 1.0));
    let kept = kept.chain(unlost.map(|lost| (lost, 0.0)));
    figure
        .all_close("without friction it flies on, with its energy", kept, Absolute(0.0))
        .source("text: R_x = -1 without friction");
    figure.deviation("fig. 15.1 in the text", "fig. 15.2", "slip of the text");
    Ok(figure)
}
