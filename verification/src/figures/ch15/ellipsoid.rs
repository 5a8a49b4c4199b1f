//! Fig. 15.8: an upright ellipsoid that hits a plane.

use carom_geometry::Surface;
use carom_halfspace::Material;
use carom_impact::closed_form::phi;
use carom_impact::coupled::TurningLaw;
use carom_impact::restitution::of_groups;
use carom_impact::{Body, Collision, Motion};
use carom_laws::friction::Friction;
use carom_laws::stiffness::ContactStiffness;
use carom_special::AxisRatio;
use rayon::prelude::*;

use crate::spring_impact;
use crate::{
    Absolute, Arrow, Axis, Failure, Figure, FigureResult, Panel, Point, Relative, Series, linspace,
    logspace,
};

const MASS: f64 = 0.3;
const FRICTION: f64 = 0.2;
const APPROACH: f64 = 1.0;

/// An ellipsoid of semi-axes d (x), e (y) and c (z) on a rigid plane, sliding along x.
#[derive(Clone, Copy)]
struct Ellipsoid {
    d: f64,
    e: f64,
    c: f64,
}

impl Ellipsoid {
    /// With a circular contact: d = e = 20 mm.
    fn of_revolution(ratio: f64) -> Self {
        Self { d: 0.02, e: 0.02, c: 0.02 * ratio }
    }

    /// D_xx/D_zz by (15.6).
    fn mobility_ratio(self) -> f64 {
        let (c, d) = (self.c * self.c, self.d * self.d);
        1.0 + 5.0 * c / (c + d)
    }

    /// On a rigid plane with nu = 1/2: the only ratio that leaves the pair uncoupled (5.20).
    fn encounter(self, slip: f64) -> Result<Collision, Failure> {
        let rubber = Material::from_shear(1e6, 0.5)?;
        let surface = Surface::ellipsoid([self.d, self.e, self.c])?;
        let inertia = surface.solid(MASS)?;
        let body = Body::new(surface, rubber, inertia)
            .at([0.0, 0.0, self.c])?
            .moving(Motion::new([slip, 0.0, -APPROACH], [0.0; 3])?);
        let plane = Body::plane(Material::RIGID);
        Ok(Collision::touching(body, plane, Friction::new(FRICTION)?)?)
    }

    /// chi of a slip along x, with kappa of the contact ellipse.
    fn chi(self) -> Result<f64, Failure> {
        Ok(self.mobility_ratio() * self.stiffness_ratio()?)
    }

    /// c_x/c_z of the slip along the body's x axis.
    fn stiffness_ratio(self) -> Result<f64, Failure> {
        let encounter = self.encounter(0.0)?;
        let stiffness = encounter.hertz().stiffness();
        let along_x = encounter.frame().x().x.abs() > 0.5;
        Ok(if along_x { stiffness.c_x } else { stiffness.c_y } / stiffness.c_z)
    }
}

fn sketch() -> Panel {
    let (d, c) = (1.5, 1.0);
    let outline = linspace(0.0, 2.0 * std::f64::consts::PI, 181)
        .into_iter()
        .map(|angle| Point::new(d * libm::cos(angle), c + c * libm::sin(angle)));
    let arrow = |from: (f64, f64), to: (f64, f64)| Arrow { tail: from.into(), head: to.into() };
    let mut panel = Panel::new("x", "z").titled("Ellipsoid on a rigid plane").equal_aspect();
    panel.add(Series::line("ellipsoid", outline));
    panel.add(Series::line("plane", [(-2.2, 0.0), (2.2, 0.0)]));
    panel.add(Series::arrows(
        "semi-axes d, c",
        [arrow((0.0, c), (d, c)), arrow((0.0, c), (0.0, 2.0 * c))],
    ));
    panel.add(Series::arrows("R", [arrow((0.0, c), (0.0, 0.0))]));
    panel.add(Series::arrows("velocity", [arrow((0.4, 0.9 * c), (0.9, 0.4 * c))]));
    panel
}

fn mobility(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::log("c/d"), "D_xx/D_zz").titled("Mobility (15.6), (15.7)");
    let ratios = logspace(0.05, 20.0, 121);
    let curve: Vec<f64> =
        ratios.iter().map(|&ratio| Ellipsoid::of_revolution(ratio).mobility_ratio()).collect();
    panel.add(Series::line("1 + 5c²/(c² + d²)", ratios.iter().copied().zip(curve)));
    panel.add(Series::markers("sphere", crate::Marker::Circle, [(1.0, 3.5)]));
    panel.add(Series::dashed("limits 1 and 6", [(0.05, 1.0), (20.0, 1.0)]).coloured(2));
    panel.add(Series::dashed("limits 1 and 6", [(0.05, 6.0), (20.0, 6.0)]).coloured(2));
    figure.panel(panel);

    let (mut inertia, mut ratio) = (Vec::new(), Vec::new());
    for c in [0.05, 0.3, 0.7, 1.0, 1.8, 6.0, 20.0] {
        for e in [0.2, 1.0, 3.0] {
            let body = Ellipsoid { d: 0.02, e: 0.02 * e, c: 0.02 * c };
            let encounter = body.encounter(0.0)?;
            let about_y = encounter.bodies()[0].inertia().moments()[1];
            inertia.push((about_y, MASS / 5.0 * (body.c * body.c + body.d * body.d)));
            let d = encounter.mobility().matrix();
            let axes = encounter.frame().axes();
            let along = axes.transpose() * nalgebra::Vector3::x();
            ratio.push((along.dot(&(d * along)) / d.m33, body.mobility_ratio()));
        }
    }
    figure.all_close("θ_yy of 21 ellipsoids", inertia, Relative(1e-14)).source("(15.5)");
    figure.all_close("D_xx/D_zz of 21 encounters", ratio, Relative(1e-12)).source("(15.6)");
    let mut ends = Vec::new();
    for (ratio, expected) in [(0.01, 1.000_499_950_005), (100.0, 5.999_500_049_995)] {
        let encounter = Ellipsoid::of_revolution(ratio).encounter(0.0)?;
        let d = encounter.mobility().matrix();
        ends.push((d.m11 / d.m33, expected));
    }
    figure
        .all_close(
            "D_xx/D_zz at c/d = 0.01 and 100, near the limits 1 and 6",
            ends,
            Relative(1e-11),
        )
        .source("(15.6), (15.7): 1 + 5/10001 and 6 - 5/10001");
    Ok(())
}

/// c_x/c_z and c_y/c_z of an ellipse.
fn stiffness_ratios(axes: f64, nu: f64) -> Result<[f64; 2], Failure> {
    let c = ContactStiffness::from_axis_ratio(1.0, AxisRatio::new(axes)?, nu)?;
    Ok([c.c_x, c.c_y])
}

fn stiffness(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::log("a/b"), "c_x/c_z, c_y/c_z")
        .titled("Stiffness (15.8): across the ellipse full, along it dashed");
    for (colour, nu) in [0.1, 0.3, 0.5].into_iter().enumerate() {
        let axes = logspace(1e-4, 1.0, 81);
        let ratios: Result<Vec<[f64; 2]>, Failure> =
            axes.iter().map(|&axes| stiffness_ratios(axes, nu)).collect();
        let ratios = ratios?;
        let along = |i: usize| axes.iter().copied().zip(ratios.iter().map(move |pair| pair[i]));
        panel.add(Series::line(format!("ν = {nu}"), along(0)).coloured(colour));
        panel.add(Series::dashed("", along(1)).coloured(colour));
    }
    figure.panel(panel);

    let mut all = Vec::new();
    for nu in linspace(0.0, 0.5, 26) {
        for axes in logspace(1e-12, 1.0, 61) {
            all.extend(stiffness_ratios(axes, nu)?);
        }
    }
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    let most = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    figure.at_least("c/c_z of 1586 ellipses along both axes", least, 0.5).source("(15.8)");
    figure.at_most("and at most 1", most, 1.0 + 1e-15).source("(15.8)");
    // Slender: delta = 1 - 1/K = 1 - 1/ln(4b/a).
    let slow = [1e-3, 1e-6, 1e-12, 1e-24];
    let pairs: Result<Vec<(f64, f64)>, Failure> = slow
        .iter()
        .map(|&axes| {
            let delta = 1.0 - 1.0 / libm::log(4.0 / axes);
            Ok((stiffness_ratios(axes, 0.5)?[1], 0.5 / (0.5 + 0.5 * delta)))
        })
        .collect();
    figure
        .all_close("c_y/c_z tends to 1/2 as 1/ln(4b/a), ν = 1/2", pairs?, Absolute(1e-6))
        .source("K = ln(4b/a), E = 1 of slender ellipses in (5.25)");
    let phis = [(phi(0.5), 61.0_f64.sqrt()), (phi(6.0), 721.0_f64.sqrt())];
    figure.all_close("ends of φ", phis, Absolute(1e-13)).source("(15.9)");
    Ok(())
}

fn restitution(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel =
        Panel::new("λ = |ξ'|/(f ζ')", "R_x").titled("Restitution, ν = 1/2, circular contact");
    let lambdas = linspace(0.0, 12.0, 181);
    for ratio in [0.2, 0.5, 1.0, 2.0, 5.0] {
        let body = Ellipsoid::of_revolution(ratio);
        let (chi, kappa) = (body.chi()?, 1.0 / body.stiffness_ratio()?);
        let curve: Result<Vec<f64>, _> =
            lambdas.par_iter().map(|lambda| of_groups(chi, lambda / kappa)).collect();
        let label = format!("c/d = {ratio}, χ = {chi:.3}");
        panel.add(Series::line(label, lambdas.iter().copied().zip(curve?)));
    }
    figure.panel(panel);

    let shapes = [(0.02, 0.01, 0.012), (0.02, 0.02, 0.06), (0.01, 0.03, 0.02), (0.03, 0.004, 0.02)];
    let (mut stepped, mut sphere, mut sliding) = (Vec::new(), Vec::new(), Vec::new());
    for (d, e, c) in shapes {
        let body = Ellipsoid { d, e, c };
        let (chi, stiffness) = (body.chi()?, body.stiffness_ratio()?);
        let solved = |lambda: f64| -> Result<f64, Failure> {
            let outcome = body.encounter(lambda * FRICTION * APPROACH)?.solve()?;
            Ok(outcome.rebound().and_then(|r| r.r_x).ok_or("the body falls")?)
        };
        for psi in [0.4, 1.5, 3.0] {
            stepped.push((solved(psi / stiffness)?, spring_impact::restitution(chi, psi)));
        }
        let lambda = 2.0 * body.mobility_ratio() + 1.0;
        sliding.push((solved(lambda)?, 2.0 * body.mobility_ratio() / lambda - 1.0));
    }
    for lambda in [0.5, 2.0, 5.0] {
        let ball = Ellipsoid::of_revolution(1.0).encounter(lambda * FRICTION * APPROACH)?;
        let outcome = ball.solve()?;
        let r = outcome.rebound().and_then(|r| r.r_x).ok_or("the ball falls")?;
        sphere.push((r, carom_impact::restitution::of_spheres(1.5, lambda)?));
    }
    energy_claim(figure)?;
    figure
        .all_close("R_x of four ellipsoids, three slips each", stepped, Absolute(1e-5))
        .source("springs with sliders, stepped in time, with χ of (15.6)");
    figure
        .all_close(
            "complete sliding of the four: R_x = -1 + 2 (D_xx/D_zz)/λ",
            sliding,
            Absolute(1e-12),
        )
        .source("(9.33)");
    figure
        .all_close("d = e = c is the sphere of fig. 15.2", sphere, Absolute(1e-12))
        .source("the walk for spheres");
    Ok(())
}

/// Impulse, spin, heat and extremes of an encounter, with R_x by the springs.
fn energy_claim(figure: &mut Figure) -> Result<(), Failure> {
    let body = Ellipsoid { d: 0.03, e: 0.015, c: 0.02 };
    let (ratio, psi) = (body.mobility_ratio(), 1.5);
    let slip = psi / body.stiffness_ratio()? * FRICTION * APPROACH;
    let outcome = body.encounter(slip)?.solve()?;
    let rebound = outcome.rebound().ok_or("the body falls")?;
    let restitution = spring_impact::restitution(body.chi()?, psi);
    let push = (1.0 + restitution) * slip * MASS / ratio;
    let heat = 0.5 * MASS / ratio * (1.0 - restitution * restitution) * slip * slip;
    let theta = MASS / 5.0 * (body.c * body.c + body.d * body.d);
    let (energy, motion) = (rebound.energy, rebound.motions[0]);
    let before = 0.5 * MASS * (slip * slip + APPROACH * APPROACH);
    // F_max ζ_max is 5/4 of m v², and T = 2.943275 ζ_max/v.
    let product = rebound.maximal_force * rebound.maximal_approach;
    let clock = rebound.duration * APPROACH / rebound.maximal_approach;
    figure
        .all_close(
            "impulse, velocity, spin and heat of an ellipsoid, over those expected",
            [
                (rebound.impulse.x / -push, 1.0),
                (rebound.impulse.z / (2.0 * MASS * APPROACH), 1.0),
                ((slip - motion.velocity.x) * MASS / push, 1.0),
                (motion.spin.y * theta / (push * body.c), 1.0),
                (energy.dissipated / heat, 1.0),
                ((energy.before - energy.after) / heat, 1.0),
                (energy.before / before, 1.0),
            ],
            Absolute(2e-5),
        )
        .source("momenta with (15.5), (15.6), R_x of springs with sliders, stepped in time");
    figure
        .all_close(
            "F_max ζ_max over m v², T v/ζ_max",
            [(product / (MASS * APPROACH * APPROACH), 1.25), (clock, 2.943_275_184_324_705)],
            Relative(1e-12),
        )
        .source("energy (2/5) F ζ = m v²/2; T_N of (9.8)");
    let impact = body.encounter(slip)?.impact()?.ok_or("they approach each other")?;
    let course = impact.history(TurningLaw::default())?;
    let (mut tangential, mut normal) = (0.0, 0.0);
    for pair in course.windows(2) {
        let impulse = 0.5 * (pair[0].force + pair[1].force) * (pair[1].time - pair[0].time);
        tangential += impulse.x + impulse.y;
        normal += impulse.z;
    }
    figure
        .all_close(
            "impulses of the course, over those expected",
            [(f64::abs(tangential) / push, 1.0), (normal / (2.0 * MASS * APPROACH), 1.0)],
            Absolute(2e-3),
        )
        .source("∫F dt of 200 instants; one axis of the contact lies along the slip");
    // With a twist as well: the heat equals the energy lost by the bodies.
    let rubber = Material::from_shear(1e6, 0.5)?;
    let surface = Surface::sphere(0.02)?;
    let inertia = surface.solid(MASS)?;
    let spun = Body::new(surface, rubber, inertia)
        .at([0.0, 0.0, 0.02])?
        .moving(Motion::new([0.0, 0.0, -APPROACH], [0.0, 0.0, 100.0])?);
    let plane = Body::plane(Material::RIGID);
    let spun =
        Collision::touching(spun, plane, Friction::new(FRICTION)?)?.with_torsion().solve()?;
    let spun = spun.rebound().ok_or("the ball falls")?;
    let theta = 0.4 * MASS * 0.02 * 0.02;
    let left = spun.motions[0].spin.z;
    figure
        .close(
            "a ball that spins about the normal: heat over the spin's energy",
            spun.energy.dissipated / (0.5 * theta * 1e4),
            1.0 - left * left / 1e4,
            Absolute(1e-9),
        )
        .source("θ (ω² - ω'²)/2 of the spin it keeps");
    let ball = Ellipsoid::of_revolution(1.0);
    let round = ball.encounter(0.1)?.solve()?;
    let round = round.rebound().ok_or("the ball falls")?;
    // Hertz's formulas: E* = 2 G/(1 - ν) of rubber on a rigid plane.
    let modulus = 2.0 * 1e6 / 0.5;
    let root = ball.d.sqrt();
    let deepest = libm::pow(15.0 * MASS * APPROACH * APPROACH / (16.0 * modulus * root), 0.4);
    figure
        .all_close(
            "ζ_max, F_max and a_max of the sphere",
            [
                (round.maximal_approach, deepest),
                (round.maximal_force, 4.0 / 3.0 * modulus * root * deepest * deepest.sqrt()),
                (round.maximal_contact.semi_axis_b(), (ball.d * deepest).sqrt()),
            ],
            Relative(1e-12),
        )
        .source("Hertz's formulas with E* and R");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("body", "solid ellipsoid, semi-axes d along x and c along z, on a rigid plane");
    figure.stated("lever", "R along z: a = b = 0");
    figure.assumed("third semi-axis e along y", "e = d in the curves: a circular contact");
    figure.assumed("ν", "1/2: with a rigid plane the only uncoupled pair (ε = 0)");
    figure.panel(sketch());
    mobility(&mut figure)?;
    stiffness(&mut figure)?;
    restitution(&mut figure)?;
    figure.deviation("D_xx/D_zz in (9.44), φ of fig. 9.1", "(9.46), fig. 9.2", "slips of the text");
    figure.deviation("a, b of R defined in (6.6)", "(8.25)", "slip of the text");
    figure.deviation(
        "c_x/c_z reaches its minimum 0.5 for infinitely small ellipses",
        "only as 1/ln(4b/a): 0.545 at a/b = 1e-2, 0.504 at 1e-24, ν = 1/2",
        "δ of (5.25a) tends to 1 logarithmically",
    );
    figure.deviation(
        "in the case of partial slip the impact must be calculated numerically",
        "exact for a slip along an axis of an upright ellipsoid with ε = 0",
        "the motion keeps its direction and does not couple: χ and ψ govern it; other Poisson's \
         ratios on a rigid plane couple (γ > 0) and wait for the numerical solution of chapter 12",
    );
    Ok(figure)
}
