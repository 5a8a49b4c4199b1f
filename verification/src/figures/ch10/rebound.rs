//! Fig. 10.2: the spin after an impact against that before it, and its asymptotes.

use std::f64::consts::{PI, TAU};

use carom_halfspace::{Material, MaterialPair};
use carom_impact::torsional::{SpinCollision, Spinner, limits};
use carom_laws::curvature::{PrincipalRadii, RelativeCurvature};
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::torsion::law::TorsionLaw;

use crate::{
    Absolute, Axis, Failure, Figure, FigureResult, Panel, Relative, Series, linspace, logspace,
};

struct Sphere {
    name: &'static str,
    shear_modulus: f64,
    poisson: f64,
    density: f64,
    radius: f64,
    friction: f64,
    /// epsilon, small-spin ratio corrected and printed, d corrected and printed.
    expected: [f64; 5],
}

const SPHERES: [Sphere; 2] = [
    Sphere {
        name: "steel",
        shear_modulus: 82e9,
        poisson: 0.3,
        density: 7850.0,
        radius: 0.01,
        friction: 0.3,
        expected: [0.007_738_4, 0.988_345, 0.991_258, 3.3278, 4.6589],
    },
    Sphere {
        name: "rubber",
        shear_modulus: 1e6,
        poisson: 0.5,
        density: 1100.0,
        radius: 0.02,
        friction: 0.8,
        expected: [0.203_33, 0.709_168, 0.781_613, 26.911, 37.676],
    },
];

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("steel", "G = 82 GPa, ν = 0.3, ρ = 7850 kg/m³, R = 10 mm, f = 0.3");
    figure.assumed("rubber", "G = 1 MPa, ν = 0.5, ρ = 1100 kg/m³, R = 20 mm, f = 0.8");
    figure.assumed("both", "solid, against a rigid plane at 1 m/s");
    for sphere in &SPHERES {
        draw_sphere(&mut figure, sphere)?;
    }
    fast_spin(&mut figure, &SPHERES[0])?;
    figure
        .close(
            "impulse of the torque of a constant spin, Ω = 0.3",
            limits::first_order_loss(0.3)?,
            0.970_346_115,
            Absolute(1e-9),
        )
        .source("independent program");
    figure.deviation(
        "(10.40), (10.63): [1 - 5/2 δ(T - 2)] [1 - 5 δ(T - 2)]",
        "2 y_1² - 1, to first order 1 - 10 δ(T - 2)",
        "the mirrored velocity in (10.38) is not constant",
    );
    figure.deviation("(10.52), (10.64): 21", "15", "factor 7/2 used for 5/2");
    figure.deviation("at (10.64): complete adhesion", "complete sliding", "slip of the text");
    Ok(figure)
}

fn draw_sphere(figure: &mut Figure, sphere: &Sphere) -> Result<(), Failure> {
    let name = sphere.name;
    let at_rest = sphere.collision(0.0)?;
    let epsilon = at_rest.groups()?.map_or(f64::NAN, |groups| groups.epsilon());
    let delta = at_rest.normal().maximal_approach() / sphere.radius;
    let [low, low_printed] = [limits::no_slip(epsilon)?, limits::no_slip_as_printed(epsilon)];
    let d = sphere.friction / sphere.radius * delta.sqrt() * limits::SLIDING_LOSS;
    let shift = d / (1.0 - low); // the asymptotes meet here
    let mut points = Vec::new();
    let mut above = f64::INFINITY;
    for before in linspace(0.0, 2.5 * shift, 101) {
        let after = sphere.collision(before)?.solve()?.spins[0];
        points.push((before, after));
        above = above.min(after - (low * before).max(before - d));
    }
    let mut panel = Panel::new("β'(0), rad/s", "β'(T), rad/s").titled(name);
    panel.add(Series::line("computed", points.clone()));
    panel.add(Series::dashed("(10.63) corrected", vec![(0.0, 0.0), (shift, shift - d)]));
    panel.add(Series::dashed("(10.64) corrected", vec![(d, 0.0), (2.5 * shift, 2.5 * shift - d)]));
    figure.panel(panel);
    let mut panel = Panel::new("β'(0), rad/s", "lost spin β'(0) - β'(T), rad/s")
        .titled(format!("{name}: loss"));
    let lost = |(x, y): (f64, f64)| (x, x - y);
    panel.add(Series::line("computed", points.iter().copied().map(lost).collect::<Vec<_>>()));
    let ends = |slope: f64, most: f64| vec![(0.0, 0.0), (most / slope, most)];
    panel.add(Series::dashed("(10.63) corrected", ends(1.0 - low, d)));
    panel.add(Series::dashed("(10.64) corrected", vec![(0.0, d), (2.5 * shift, d)]));
    panel.add(Series::dotted("(10.63) printed", ends(1.0 - low_printed, 1.4 * d)));
    panel.add(Series::dotted("(10.64) printed", vec![(0.0, 1.4 * d), (2.5 * shift, 1.4 * d)]));
    figure.panel(panel);

    let measured = [epsilon, low, low_printed, d, 1.4 * d];
    figure
        .all_close(
            format!("{name}: ε, small-spin ratio (corrected, printed), d (corrected, printed)"),
            measured.into_iter().zip(sphere.expected),
            Relative(4e-5),
        )
        .source("independent program");
    let spin = 3.0 * shift;
    let omega = sphere.collision(spin)?.groups()?.map_or(f64::NAN, |groups| groups.omega());
    figure
        .all_close(
            format!("{name}: asymptotes in the groups ε, Ω: sliding and no slip"),
            [
                (limits::sliding(epsilon, omega), 1.0 - sphere.expected[3] / spin),
                (limits::no_slip_first_order(epsilon), sphere.first_order()),
            ],
            Absolute(2e-5),
        )
        .source("d by an independent program; 2 (1 - (5/2) δ (1 - ν) (T - 2))² - 1");
    figure
        .at_least(format!("{name}: spin above both asymptotes"), above, -1e-9 * d)
        .source("the text at fig. 10.2");
    let fast = 1e4 * shift;
    let outcome = sphere.collision(fast)?.solve()?;
    let lost = fast - outcome.spins[0];
    figure
        .close(format!("{name}: spin lost in sliding"), lost, d, Relative(1e-8))
        .source("(10.64), corrected");
    let inertia = 0.4 * sphere.mass() * sphere.radius * sphere.radius;
    let taken = 0.5 * inertia * (fast * fast - (fast - d) * (fast - d));
    figure
        .all_close(
            format!("{name}: energy and impulse of the torque in sliding, over those of d"),
            [(outcome.energy_loss / taken, 1.0), (outcome.torque_impulse / (-inertia * d), 1.0)],
            Absolute(1e-7),
        )
        .source("(2/5) m R² and the spin lost in (10.64), corrected");
    Ok(())
}

/// "Very large angular velocities of several thousand rotations per second": how far the loss of the
/// steel sphere lies below d of (10.64) up to 10 000 of them.
fn fast_spin(figure: &mut Figure, sphere: &Sphere) -> Result<(), Failure> {
    let d = {
        let delta = sphere.collision(0.0)?.normal().maximal_approach() / sphere.radius;
        sphere.friction / sphere.radius * delta.sqrt() * limits::SLIDING_LOSS
    };
    let lost = |turns: f64| -> Result<f64, Failure> {
        let spin = TAU * turns;
        Ok((spin - sphere.collision(spin)?.solve()?.spins[0]) / d)
    };
    let mut curve = Vec::new();
    for turns in logspace(1.0, 1e4, 81) {
        curve.push((turns, lost(turns)?));
    }
    let mut panel = Panel::new(
        Axis::log("spin before / (rotations per second)"),
        "lost spin over d of (10.64)",
    )
    .titled(format!("{}: when complete sliding is reached", sphere.name));
    panel.add(Series::line("computed", curve));
    panel.add(Series::dashed("(10.64) corrected", [(1.0, 1.0), (1e4, 1.0)]));
    let band = [(1e3, 0.0), (5e3, 0.0), (5e3, 1.05), (1e3, 1.05)];
    panel.add(Series::area("several thousand rotations per second", band));
    figure.panel(panel);

    let mut shares = Vec::new();
    for (turns, steps) in [(20.0, 4000), (162.0, 4000), (1000.0, 8000), (5000.0, 16_000)] {
        shares.push((lost(turns)?, sphere.stepped_loss(TAU * turns, steps)? / d));
    }
    figure
        .all_close(
            "steel: loss over d at 20, 162, 1000 and 5000 rotations per second",
            shares,
            Absolute(1e-3),
        )
        .source("Newton's equations stepped in time with Lubkin's law; d of (10.64), corrected");
    // Where one per cent is left.
    let (mut low, mut high) = (1.0, 1e5);
    for _ in 0..50 {
        let middle = f64::sqrt(low * high);
        if lost(middle)? < 0.99 { low = middle } else { high = middle }
    }
    let turns = f64::sqrt(low * high);
    figure.derived("rotations per second at 99 % of d, steel", format!("{turns:.0}"));
    let there = sphere.stepped_loss(TAU * turns, 8000)? / d;
    figure
        .close("99 % of d there", there, 0.99, Absolute(1e-3))
        .source("Newton's equations stepped in time with Lubkin's law");
    figure
        .at_most("loss at several thousand, 1000 to 5000, short of d by", 1.0 - lost(1e3)?, 0.01)
        .source("text: (10.64) is valid for several thousand rotations per second");
    figure
        .at_least("and at 100 rotations per second by", 1.0 - lost(100.0)?, 0.05)
        .source("text: only for very large angular velocities");
    Ok(())
}

impl Sphere {
    /// The spin that the ball loses, by Newton's equations stepped in time with the law of a twist.
    fn stepped_loss(&self, spin: f64, steps: usize) -> Result<f64, Failure> {
        let mut law = TorsionLaw::new(&self.hertz()?, Friction::new(self.friction)?)?;
        let mass = self.mass();
        let inertia = 0.4 * mass * self.radius * self.radius;
        let dt = self.collision(spin)?.normal().duration() / steps as f64;
        let (mut zeta, mut twist, mut speed, mut rate) = (0.0, 0.0, 1.0, spin);
        for _ in 0..2 * steps {
            zeta += 0.5 * dt * speed;
            twist += 0.5 * dt * rate;
            let load = law.advance(Shift { zeta, omega: twist, ..Shift::default() })?;
            speed -= dt * load.f_z / mass;
            rate -= dt * load.m_z / inertia;
            zeta += 0.5 * dt * speed;
            twist += 0.5 * dt * rate;
            if zeta <= 0.0 {
                return Ok(spin - rate);
            }
        }
        Err("the ball does not rebound".into())
    }

    /// (10.63), corrected, with δ = ζ_max/R of Hertz's formulas at 1 m/s.
    fn first_order(&self) -> f64 {
        let modulus = 2.0 * self.shear_modulus / (1.0 - self.poisson);
        let root = self.radius.sqrt();
        let deepest = libm::pow(15.0 * self.mass() / (16.0 * modulus * root), 0.4);
        let duration = 2.943_275_184_324_705;
        let y_1 = 1.0 - 2.5 * deepest / self.radius * (1.0 - self.poisson) * (duration - 2.0);
        2.0 * y_1 * y_1 - 1.0
    }

    fn mass(&self) -> f64 {
        4.0 / 3.0 * PI * self.radius.powi(3) * self.density
    }

    fn hertz(&self) -> Result<Hertz, Failure> {
        let material = Material::from_shear(self.shear_modulus, self.poisson)?;
        let sphere = PrincipalRadii::sphere(self.radius)?;
        let gap = RelativeCurvature::new(sphere, PrincipalRadii::PLANE, 0.0)?;
        Ok(Hertz::new(gap, MaterialPair::new(material, Material::RIGID)?)?)
    }

    fn collision(&self, spin: f64) -> Result<SpinCollision, Failure> {
        let ball = Spinner::solid_sphere(self.mass(), self.radius)?.spinning(spin)?;
        let friction = Friction::new(self.friction)?;
        Ok(SpinCollision::new(&self.hertz()?, friction, [ball, Spinner::held_fast()], 1.0)?)
    }
}
