//! Glancing impacts of two balls, beside an integration with the centres moving.

use carom_halfspace::Material;
use carom_impact::{AnalyticOrRings, Body, Collision, CollisionSolver, Motion, NormalRestitution};
use carom_laws::friction::Friction;
use rayon::prelude::*;

use crate::{Absolute, Axis, Failure, Figure, FigureResult, Marker, Panel, Series, linspace};

/// Two equal balls.
#[derive(Clone, Copy)]
struct Pair {
    radius: f64,
    mass: f64,
    young: f64,
    poisson: f64,
}

/// Glass balls with the stiffness of steel, and of rubber; pool balls.
const STIFF: Pair = Pair { radius: 4.5e-3, mass: 9.542_587_684_e-4, young: 2e11, poisson: 0.3 };
const SOFT: Pair = Pair { young: 1e7, ..STIFF };
const POOL: Pair = Pair { radius: 28.575e-3, mass: 0.17, young: 5.84e9, poisson: 0.34 };

/// One ball at rest; the other comes with a speed at an angle from the line of centres.
#[derive(Clone, Copy)]
struct Meeting {
    pair: Pair,
    speed: f64,
    degrees: f64,
    friction: f64,
    restitution: f64,
}

impl Meeting {
    fn collision(&self) -> Result<Collision, Failure> {
        let Pair { radius, mass, young, poisson } = self.pair;
        let ball = Body::sphere(radius, Material::from_young(young, poisson)?, mass)?;
        let (sine, cosine) = self.degrees.to_radians().sin_cos();
        let motion = Motion::new([self.speed * sine, 0.0, -self.speed * cosine], [0.0; 3])?;
        let collision =
            Collision::new(ball.clone().moving(motion), ball, Friction::new(self.friction)?)?;
        Ok(collision.with_normal_restitution(NormalRestitution::new(self.restitution)?))
    }

    /// The velocity at which the balls approach.
    fn approaching(&self) -> f64 {
        self.speed * self.degrees.to_radians().cos()
    }

    /// The velocity at which they part along the first line of centres, over that at which they approach.
    fn parts(&self, collision: &Collision) -> Result<f64, Failure> {
        let outcome = AnalyticOrRings.solve(collision)?;
        let [one, two] = outcome.rebound().ok_or("they meet")?.motions;
        Ok((one.velocity.z - two.velocity.z) / self.approaching())
    }

    /// The same by an integration of the centres under Hertz's viscous force, and friction that slides throughout.
    fn integrated(&self) -> f64 {
        let Pair { radius, mass, young, poisson } = self.pair;
        let stiffness = 4.0 / 3.0 * 0.5 * young / (1.0 - poisson * poisson) * (0.5 * radius).sqrt();
        let (sine, cosine) = self.degrees.to_radians().sin_cos();
        let normal = Hertz::new(stiffness, 0.5 * mass, self.approaching(), self.restitution);
        // Place and velocity of ball 1 against ball 2, and the sum of both spins.
        let mut state = [0.0, 2.0 * radius, self.speed * sine, -self.speed * cosine, 0.0];
        let rate = |s: [f64; 5]| {
            let distance = s[0].hypot(s[1]);
            let (n, t) = ([s[0] / distance, s[1] / distance], [s[1] / distance, -s[0] / distance]);
            let approaching = -(s[2] * n[0] + s[3] * n[1]);
            let force = normal.force(2.0 * radius - distance, approaching);
            let slip = s[2] * t[0] + s[3] * t[1] - radius * s[4];
            let drag = -self.friction * force * slip.signum();
            let twice = 2.0 / mass;
            let change = |k: usize| twice * (force * n[k] + drag * t[k]);
            let spin = -2.0 * radius * drag / (0.4 * mass * radius * radius);
            [s[2], s[3], change(0), change(1), spin]
        };
        let dt = normal.time / STEPS;
        loop {
            state = runge_kutta(state, dt, rate);
            let distance = state[0].hypot(state[1]);
            let approaching = -(state[2] * state[0] + state[3] * state[1]) / distance;
            if normal.force(2.0 * radius - distance, approaching) <= 0.0 {
                return state[3] / self.approaching();
            }
        }
    }
}

/// Steps in a unit of time of an impact, of which a contact lasts about three.
const STEPS: f64 = 1000.0;

/// The force of Hertz's contact in a material of Kelvin and Voigt.
struct Hertz {
    stiffness: f64,
    relaxation: f64,
    /// A unit of time of the impact.
    time: f64,
}

impl Hertz {
    /// With the relaxation time that leaves this restitution of an impact along the normal.
    fn new(stiffness: f64, mass: f64, speed: f64, restitution: f64) -> Self {
        let time = (mass / stiffness).powf(0.4) * speed.powf(-0.2);
        let of = |share: f64| Self { stiffness, relaxation: share * time, time };
        let (mut low, mut high) = (0.0, 4.0);
        while restitution < 1.0 && high - low > 1e-9 {
            let middle = 0.5 * (low + high);
            if of(middle).along_the_normal(mass, speed) > restitution {
                low = middle;
            } else {
                high = middle;
            }
        }
        of(low)
    }

    fn force(&self, approach: f64, rate: f64) -> f64 {
        if approach <= 0.0 {
            return 0.0;
        }
        let a = self.relaxation;
        if rate > 0.0 {
            return self.stiffness * (approach.powf(1.5) + 1.5 * a * approach.sqrt() * rate);
        }
        self.stiffness * (approach + a * rate).max(0.0).powf(1.5)
    }

    fn along_the_normal(&self, mass: f64, speed: f64) -> f64 {
        let mut state = [0.0, speed];
        loop {
            let rate = |s: [f64; 2]| [s[1], -self.force(s[0], s[1]) / mass];
            state = runge_kutta(state, self.time / STEPS, rate);
            if self.force(state[0], state[1]) <= 0.0 {
                return -state[1] / speed;
            }
        }
    }
}

/// A step of Runge and Kutta.
fn runge_kutta<const N: usize>(
    state: [f64; N],
    dt: f64,
    rate: impl Fn([f64; N]) -> [f64; N],
) -> [f64; N] {
    let on = |by: [f64; N], dt: f64| std::array::from_fn(|i| state[i] + dt * by[i]);
    let one = rate(state);
    let two = rate(on(one, 0.5 * dt));
    let three = rate(on(two, 0.5 * dt));
    let four = rate(on(three, dt));
    on(std::array::from_fn(|i| (one[i] + 2.0 * (two[i] + three[i]) + four[i]) / 6.0), dt)
}

/// What is drawn: restitution and friction.
const KINDS: [[f64; 2]; 3] = [[1.0, 0.0], [0.7, 0.0], [0.4, 0.1]];

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("balls", "pool balls, 57.15 mm and 170 g, E = 5.84 GPa, one at rest, 3 m/s");
    figure.assumed("integration", "Runge and Kutta, the force along the present line of centres");
    let mut panel = Panel::new(
        Axis::linear("angle from the line of centres (degrees)"),
        Axis::linear("parting over approach, first axis"),
    );
    let (mut off, mut points) = (0.0_f64, Vec::new());
    for [restitution, friction] in KINDS {
        let at = |degrees: f64| Meeting { pair: POOL, speed: 3.0, degrees, friction, restitution };
        let curve: Result<Vec<(f64, f64)>, Failure> = linspace(60.0, 89.0, 59)
            .into_par_iter()
            .map(|degrees| Ok((degrees, at(degrees).parts(&at(degrees).collision()?)?)))
            .collect();
        panel.add(Series::line(format!("e = {restitution}, f = {friction}"), curve?));
        let known: Vec<[f64; 2]> = linspace(60.0, 88.0, 15)
            .into_par_iter()
            .map(|degrees| [degrees, at(degrees).integrated()])
            .collect();
        for [degrees, known] in &known {
            let meeting = at(*degrees);
            let found = meeting.parts(&meeting.collision()?)?;
            off = off.max((found - known).abs() * meeting.approaching() / meeting.speed);
        }
        points.extend(known);
    }
    panel.add(Series::markers("integrated", Marker::Circle, points));
    let kept: Result<Vec<(f64, f64)>, Failure> = linspace(60.0, 89.0, 30)
        .into_iter()
        .map(|degrees| {
            let [restitution, friction] = KINDS[0];
            let meeting = Meeting { pair: POOL, speed: 3.0, degrees, friction, restitution };
            Ok((degrees, meeting.parts(&meeting.collision()?.keeping_axes())?))
        })
        .collect();
    panel.add(Series::dashed("axes kept, e = 1", kept?));
    figure.panel(panel);
    figure
        .close("largest difference from the integration, over the speed", off, 0.0, Absolute(1e-3))
        .source("Runge and Kutta's method on the motion of the centres");
    let rows = [
        (STIFF, 5.0, 88.0, 0.1094),
        (SOFT, 0.5, 75.0, 0.0944),
        (SOFT, 0.5, 85.0, 0.0037),
        (POOL, 3.0, 80.0, 0.4540),
        (POOL, 3.0, 85.0, 0.1849),
        (POOL, 3.0, 88.0, 0.0213),
    ];
    let known: Result<Vec<(f64, f64)>, Failure> = rows
        .into_iter()
        .map(|(pair, speed, degrees, known)| {
            let meeting = Meeting { pair, speed, degrees, friction: 0.0, restitution: 1.0 };
            let part = meeting.approaching() / speed;
            Ok((part * meeting.parts(&meeting.collision()?)?, known / speed))
        })
        .collect();
    figure
        .all_close("six pairs without friction", known?, Absolute(4e-4))
        .source("another integration of both centres, relative tolerance 1e-11");
    Ok(figure)
}
