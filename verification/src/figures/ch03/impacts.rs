//! Fig. 3.6: the three types of impact, sketched and computed for two steel balls.

use carom_halfspace::Material;
use carom_impact::closed_form::{tangential_energy_loss, wave_loss};
use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
use carom_impact::torsional::{SpinCollision, Spinner, TorsionalImpact, TorsionalPhase};
use carom_impact::{Body, Collision, Motion, Rebound, normal};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLaw, Shift};
use carom_laws::torsion::law::TorsionLaw;
use carom_laws::validity::Limit;

use super::super::outline::ellipse;
use crate::spheres::kappa;
use crate::spring_impact;
use crate::{
    Absolute, Arrow, Axis, Failure, Figure, FigureResult, Panel, Point, Relative, Series, linspace,
};

const RADIUS: f64 = 0.01;
const MASS: f64 = 0.0329;
const YOUNG: f64 = 208e9;
const POISSON: f64 = 0.3;
const FRICTION: f64 = 0.15;
const APPROACH: f64 = 1.0; // m/s, of the centres
const SLIP: f64 = 0.15; // m/s at the contact point: lambda = 1
const SPIN: f64 = 100.0; // rad/s, relative, about the normal

fn steel() -> Result<Material, Failure> {
    Ok(Material::from_young(YOUNG, POISSON)?)
}

/// Two equal balls that meet with `APPROACH` and slip with `slip` at the contact point.
fn collision(slip: f64) -> Result<Collision, Failure> {
    let ball = |side: f64| -> Result<Body, Failure> {
        let motion = Motion::new([0.5 * side * slip, 0.0, 0.5 * side * APPROACH], [0.0; 3])?;
        Ok(Body::sphere(RADIUS, steel()?, MASS)?.moving(motion))
    };
    Ok(Collision::new(ball(-1.0)?, ball(1.0)?, Friction::new(FRICTION)?)?)
}

fn rebound(slip: f64) -> Result<Rebound, Failure> {
    let outcome = collision(slip)?.solve()?;
    Ok(outcome.rebound().ok_or("the balls approach each other")?.clone())
}

/// The same balls with opposite spins about the normal.
fn spinning(velocity: f64, spin: f64) -> Result<SpinCollision, Failure> {
    let ball = |side: f64| -> Result<Spinner, Failure> {
        Ok(Spinner::solid_sphere(MASS, RADIUS)?.spinning(0.5 * side * spin)?)
    };
    let hertz = *collision(0.0)?.hertz();
    let friction = Friction::new(FRICTION)?;
    Ok(SpinCollision::new(&hertz, friction, [ball(1.0)?, ball(-1.0)?], velocity)?)
}

fn arrow(from: (f64, f64), to: (f64, f64)) -> Arrow {
    Arrow { tail: from.into(), head: to.into() }
}

/// An arrow round the normal, seen from the side: an ellipse that ends in a head.
fn turn(height: f64, sense: f64) -> (Vec<Point>, Arrow) {
    let at =
        |angle: f64| Point::new(sense * 0.5 * libm::cos(angle), height + 0.16 * libm::sin(angle));
    let arc: Vec<Point> = linspace(-3.9, 0.5, 60).into_iter().map(at).collect();
    (arc, Arrow { tail: at(0.3), head: at(1.1) })
}

fn sketch(title: &str, arrows: Vec<Arrow>) -> Panel {
    let mut panel =
        Panel::new(Axis::linear("x/R").between(-2.0, 2.0), Axis::linear("z/R").between(-2.5, 2.5))
            .titled(title)
            .equal_aspect();
    panel.add(Series::line("body 1", ellipse([0.0, 1.0], [1.0; 2], 120)));
    panel.add(Series::line("body 2", ellipse([0.0, -1.0], [1.0; 2], 120)));
    panel.add(Series::dotted("tangential plane", [(-1.8, 0.0), (1.8, 0.0)]));
    panel.add(Series::arrows("velocities", arrows));
    panel
}

fn sketches(figure: &mut Figure) {
    let towards = [arrow((0.0, 2.0), (0.0, 1.3)), arrow((0.0, -2.0), (0.0, -1.3))];
    figure.panel(sketch("Normal", towards.to_vec()));
    let mut oblique = towards.to_vec();
    oblique.extend([arrow((0.7, 1.0), (-0.3, 1.0)), arrow((-0.7, -1.0), (0.3, -1.0))]);
    figure.panel(sketch("Tangential", oblique));
    let (upper, upper_head) = turn(0.75, 1.0);
    let (lower, lower_head) = turn(-0.75, -1.0);
    let mut spin = towards.to_vec();
    spin.extend([upper_head, lower_head]);
    let mut panel = sketch("Torsional", spin);
    panel.add(Series::line("spin", upper).coloured(3));
    panel.add(Series::line("spin", lower).coloured(3));
    figure.panel(panel);
}

/// F_z, F_x and M_z during the three impacts, over their largest possible values.
fn loads(figure: &mut Figure) -> Result<(), Failure> {
    let oblique = collision(SLIP)?.history(401)?;
    let peak = rebound(SLIP)?;
    let clock = peak.duration;
    let mut panel = Panel::new("t/T", "load over its limit").titled("Loads of the three");
    let over = |scale: f64, value: f64| value / (scale * peak.maximal_force);
    panel.add(Series::line(
        "F_z / max F_z",
        oblique.iter().map(|p| (p.time / clock, over(1.0, p.force.z))),
    ));
    panel.add(Series::line(
        "F_x / (f max F_z), tangential",
        oblique.iter().map(|p| (p.time / clock, over(FRICTION, p.force.x))),
    ));
    let twist = spinning(APPROACH, SPIN)?;
    let groups = twist.groups()?.ok_or("friction is not zero")?;
    let times = linspace(0.0, normal::DURATION, 401);
    let velocities: Vec<f64> = times.iter().map(|&t| normal::state_at(t).velocity).collect();
    // The torque is M_z (3 pi/32)/(M_sliding Omega) at the greatest sliding torque.
    let scale = groups.omega() * 32.0 / (3.0 * std::f64::consts::PI);
    let trace = TorsionalImpact::trace(groups, &velocities)?;
    panel.add(Series::line(
        "M_z / max of sliding, torsional",
        trace.iter().map(|p| (p.time / normal::DURATION, scale * p.torque)),
    ));
    figure.panel(panel);

    let shares = trace.iter().map(|p| (scale * p.torque).abs() - p.radius.powi(4));
    let excess = shares.fold(f64::NEG_INFINITY, f64::max);
    figure
        .at_most("M_z never exceeds that of sliding, (a/a_max)⁴ of its maximum", excess, 1e-9)
        .source("Coulomb: 3π/16 f F_z a");
    let starts = trace.iter().map(|p| f64::from(u8::from(p.phase != TorsionalPhase::Adhesion)));
    let first: Vec<f64> = starts.collect();
    let changes = first.windows(2).filter(|pair| pair[0] != pair[1]).count();
    figure
        .holds(
            "the torsional impact too begins in adhesion and goes on in slip",
            first[0] == 0.0 && first[399] == 1.0 && changes == 1,
            changes as f64,
        )
        .source("text above the figure");
    Ok(())
}

fn normal_claims(figure: &mut Figure) -> Result<(), Failure> {
    let straight = rebound(0.0)?;
    let [one, two] = straight.motions;
    let kept = (one.velocity.z - 0.5 * APPROACH).abs().max((two.velocity.z + 0.5 * APPROACH).abs());
    figure
        .at_most("the normal impact is reversible: the balls exchange velocities", kept, 0.0)
        .source("text below the figure");
    // Hertz's formulas with E*, R* and m*.
    let (modulus, radius, mass) =
        (YOUNG / (2.0 * (1.0 - POISSON * POISSON)), 0.5 * RADIUS, 0.5 * MASS);
    let deepest =
        libm::pow(15.0 * mass * APPROACH * APPROACH / (16.0 * modulus * radius.sqrt()), 0.4);
    let force = 4.0 / 3.0 * modulus * radius.sqrt() * deepest * deepest.sqrt();
    figure
        .all_close(
            "greatest approach and force of the normal impact",
            [(straight.maximal_approach, deepest), (straight.maximal_force, force)],
            Relative(1e-13),
        )
        .source("Hertz's formulas with E*, R*, m*");
    let share = libm::tgamma(0.4) / libm::tgamma(0.9);
    let duration = 0.8 * std::f64::consts::PI.sqrt() * share * deepest / APPROACH;
    let pressed = (radius * deepest).sqrt();
    figure
        .all_close(
            "duration, greatest contact radius and impulse",
            [
                (straight.duration, duration),
                (straight.maximal_contact.semi_axis_b(), pressed),
                (straight.impulse.z, 2.0 * mass * APPROACH),
            ],
            Relative(1e-13),
        )
        .source("Hertz's formulas; (9.8); momentum");
    let before = 0.25 * MASS * APPROACH * APPROACH;
    figure
        .all_close(
            "kinetic energy before and after, heat, over that before",
            [
                (straight.energy.before / before, 1.0),
                (straight.energy.after / before, 1.0),
                (straight.energy.dissipated / before, 0.0),
                (collision(0.0)?.hertz().normal_energy(deepest) / before, 1.0),
            ],
            Absolute(1e-13),
        )
        .source("m v²/2 of both balls; all of it elastic at the greatest approach");
    // Lamb's integral with 20 digits at nu = 0.3.
    let coefficient = 1.131_809_722_782_67;
    let expected = |velocity: f64, density: f64| {
        coefficient * libm::pow(velocity / (YOUNG / density).sqrt(), 0.6)
    };
    let density = MASS / (4.0 / 3.0 * std::f64::consts::PI * RADIUS * RADIUS * RADIUS);
    let ball =
        Body::sphere(RADIUS, steel()?, MASS)?.moving(Motion::new([0.0, 0.0, -5.0], [0.0; 3])?);
    let thrown = Collision::new(ball, Body::plane(steel()?), Friction::new(FRICTION)?)?.solve()?;
    let warned = thrown.rebound().ok_or("the ball flies at the plane")?.warnings.iter();
    let warned = warned.filter_map(|warning| warning.ratio(Limit::Waves));
    figure.all_close(
            "share of the energy that waves carry away: 1 m/s, and a ball at 5 m/s on its own steel",
            [
                (wave_loss(POISSON, 1.0, (YOUNG / 7850.0).sqrt())?, expected(1.0, 7850.0)),
                (warned.sum::<f64>(), expected(5.0, density)),
            ],
            Relative(1e-12),
        ).source("(3.2) with the coefficient of Lamb's integral in 20 digits");
    Ok(())
}

fn tangential_claims(figure: &mut Figure) -> Result<(), Failure> {
    let oblique = rebound(SLIP)?;
    let kappa = kappa(POISSON);
    let stepped = spring_impact::restitution(3.5 / kappa, 1.0 / kappa);
    figure
        .close(
            "R_x of the tangential impact",
            oblique.r_x.ok_or("no R_x")?,
            stepped,
            Absolute(5e-6),
        )
        .source("springs with sliders, stepped in time");
    // The impulse changes the slip velocity by 7/2 of the change of the velocities: reduced mass m/2.
    let push = 0.5 * MASS * (1.0 + stepped) * SLIP * 2.0 / 7.0;
    let [one, two] = oblique.motions;
    let spin = 2.5 * push / (MASS * RADIUS);
    figure
        .all_close(
            "impulse along the surface and the spins it makes, over those of R_x = 0",
            [
                (oblique.impulse.x, push),
                (one.spin.y * MASS * RADIUS, -spin * MASS * RADIUS),
                (two.spin.y * MASS * RADIUS, -spin * MASS * RADIUS),
                (MASS * (one.velocity.x + 0.5 * SLIP), push),
                (MASS * (two.velocity.x - 0.5 * SLIP), -push),
            ]
            .map(|(found, wanted)| (found / (MASS * SLIP / 7.0), wanted / (MASS * SLIP / 7.0))),
            Absolute(2e-5),
        )
        .source("momenta of solid balls, R_x of the springs");
    history_claim(figure, &oblique, stepped)?;
    let taken = 0.5 * MASS / 7.0 * (1.0 - stepped * stepped) * SLIP * SLIP;
    let budget = oblique.energy;
    let restitution = oblique.r_x.ok_or("no R_x")?;
    let closed = tangential_energy_loss([MASS, MASS], restitution, SLIP)?;
    figure
        .all_close(
            "energy that friction takes, the loss of kinetic energy and (9.59), over m v²/14",
            [budget.dissipated, budget.before - budget.after, closed].map(|found| {
                (found / (0.5 * MASS / 7.0 * SLIP * SLIP), taken / (0.5 * MASS / 7.0 * SLIP * SLIP))
            }),
            Absolute(2e-5),
        )
        .source("(9.59) with R_x of the springs");
    let groups = Groups::of_spheres(kappa, 1.0)?;
    let walk = ObliqueImpact::new(groups)?;
    let times: Vec<(f64, f64)> = oblique
        .log
        .iter()
        .zip(walk.phases())
        .map(|(entry, phase)| {
            (entry.time / oblique.duration, normal::time(phase.start) / normal::DURATION)
        })
        .collect();
    let starts = spring_impact::course(3.5 / kappa, 1.0 / kappa);
    figure
        .holds(
            "adhesion, then partial slip, complete sliding against the first slip at the end",
            walk.phases().first().is_some_and(|phase| phase.regime == Regime::Adhesion)
                && walk.phases().last().is_some_and(|phase| phase.regime == Regime::SlideBackward)
                && starts.last_force < 0.0
                && times.len() == walk.phases().len(),
            starts.last_force,
        )
        .source("text below the figure; last force of the springs");
    figure
        .close(
            "slip begins where the shift no longer keeps up with the approach: t/T",
            times[1].0,
            starts.slips_at / normal::DURATION,
            Absolute(2e-3),
        )
        .source("first slider of the springs to give way");
    Ok(())
}

/// The history that is drawn, compared with the outcome and the springs.
fn history_claim(figure: &mut Figure, outcome: &Rebound, stepped: f64) -> Result<(), Failure> {
    let history = collision(SLIP)?.history(4001)?;
    let (mut normal_sum, mut tangential) = (0.0, 0.0);
    for pair in history.windows(2) {
        let dt = pair[1].time - pair[0].time;
        normal_sum += 0.5 * dt * (pair[0].force.z + pair[1].force.z);
        tangential += 0.5 * dt * (pair[0].force.x + pair[1].force.x);
    }
    let push = 0.5 * MASS * (1.0 + stepped) * SLIP * 2.0 / 7.0;
    let kappa = kappa(POISSON);
    let course = spring_impact::course(3.5 / kappa, 1.0 / kappa);
    let last = history.last().ok_or("an impact has a course")?;
    // The springs measure shifts in f κ ζ_max.
    let unit = FRICTION * kappa * outcome.maximal_approach;
    let early = &history[200];
    let middle = &history[2000];
    let stuck = early.stick_radius.ok_or("spheres have one")?;
    figure.all_close(
            "the course: impulses, last shift, velocity, contact and stick radii, over those expected",
            [
                (normal_sum / (MASS * APPROACH), 1.0),
                (tangential / push, 1.0),
                (last.shift.x / unit, course.last),
                (last.velocity.x / SLIP, -stepped),
                (stuck / early.semi_axes[0], 1.0),
                (early.semi_axes[0] / (0.5 * RADIUS * early.shift.z).sqrt(), 1.0),
                (middle.semi_axes[0] / (0.5 * RADIUS * outcome.maximal_approach).sqrt(), 1.0),
            ],
            Absolute(1e-3),
        ).source("∫F dt, momentum; shift by the springs; a² = R ζ/2; all sticks at first");
    Ok(())
}

/// The spin ratio by Newton's equations, integrated in time with the law of torsion.
fn stepped_spin(velocity: f64, spin: f64, steps: usize) -> Result<f64, Failure> {
    let hertz = *collision(0.0)?.hertz();
    let mut law = TorsionLaw::new(&hertz, Friction::new(FRICTION)?)?;
    let (mass, inertia) = (0.5 * MASS, 0.2 * MASS * RADIUS * RADIUS);
    let dt = spinning(velocity, spin)?.normal().duration() / steps as f64;
    let (mut zeta, mut omega) = (0.0, 0.0);
    let (mut speed, mut rate) = (velocity, spin);
    for _ in 0..2 * steps {
        zeta += 0.5 * dt * speed;
        omega += 0.5 * dt * rate;
        let load = law.advance(Shift { zeta, omega, ..Shift::default() })?;
        speed -= dt * load.f_z / mass;
        rate -= dt * load.m_z / inertia;
        zeta += 0.5 * dt * speed;
        omega += 0.5 * dt * rate;
        if zeta <= 0.0 {
            return Ok(rate / spin);
        }
    }
    Err("the stepped impact does not end".into())
}

fn torsional_claims(figure: &mut Figure) -> Result<(), Failure> {
    let outcome = spinning(APPROACH, SPIN)?.solve()?;
    figure
        .close(
            "spin after over spin before, torsional impact",
            outcome.spin_ratio,
            stepped_spin(APPROACH, SPIN, 2000)?,
            Absolute(1e-6),
        )
        .source("Newton's equations stepped in time with Lubkin's law");
    let (ratio, inertia) = (stepped_spin(APPROACH, SPIN, 2000)?, 0.4 * MASS * RADIUS * RADIUS);
    // The reduced moment of inertia is half of one ball's.
    let [impulse, loss] = [
        -0.5 * inertia * (1.0 - ratio) * SPIN,
        0.25 * inertia * (1.0 - ratio * ratio) * SPIN * SPIN,
    ];
    figure
        .all_close(
            "impulse of the torque, energy lost and spins, over those expected",
            [
                (outcome.torque_impulse / impulse, 1.0),
                (outcome.energy_loss / loss, 1.0),
                (outcome.spins[0] / (0.5 * ratio * SPIN), 1.0),
                (outcome.spins[1] / (-0.5 * ratio * SPIN), 1.0),
            ],
            Absolute(1e-3),
        )
        .source("momentum about the normal, with the spin ratio stepped in time");
    // The same for two bodies in space.
    let ball = |side: f64| -> Result<Body, Failure> {
        let motion =
            Motion::new([0.0, 0.0, -0.5 * side * APPROACH], [0.0, 0.0, 0.5 * side * SPIN])?;
        Ok(Body::sphere(RADIUS, steel()?, MASS)?.moving(motion))
    };
    let both = Collision::new(ball(1.0)?, ball(-1.0)?, Friction::new(FRICTION)?)?.with_torsion();
    let both = both.solve()?;
    let both = both.rebound().ok_or("the balls approach each other")?;
    figure
        .all_close(
            "the same impact of two bodies in space: spins and heat, over those expected",
            [
                (both.motions[0].spin.z / (0.5 * ratio * SPIN), 1.0),
                (both.motions[1].spin.z / (-0.5 * ratio * SPIN), 1.0),
                (both.energy.dissipated / loss, 1.0),
                ((both.energy.before - both.energy.after) / loss, 1.0),
            ],
            Absolute(1e-3),
        )
        .source("momentum about the normal, with the spin ratio stepped in time");
    // Omega, the spin over the velocity times the contact radius, is the same.
    let base = spinning(APPROACH, SPIN)?;
    let loss = |velocity: f64| -> Result<(f64, f64), Failure> {
        let radius = spinning(velocity, SPIN)?.contact_radius();
        let spin = SPIN * velocity * base.contact_radius() / (APPROACH * radius);
        let share = radius / RADIUS;
        Ok(((1.0 - spinning(velocity, spin)?.solve()?.spin_ratio) / (share * share), share))
    };
    let (slow, _) = loss(0.001 * APPROACH)?;
    let shares: Result<Vec<f64>, Failure> =
        [0.03, 0.3, 1.0].iter().map(|v| Ok(loss(v * APPROACH)?.0)).collect();
    figure
        .all_close(
            "the loss of spin goes with (a/R)², from 1 mm/s to 1 m/s",
            shares?.into_iter().map(|share| (share, slow)),
            Relative(0.02),
        )
        .source("text beside the figure");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("types", "normal, tangential, torsional");
    figure.assumed("bodies", "two steel balls: R = 10 mm, E = 208 GPa, ν = 0.3, 32.9 g, f = 0.15");
    figure.assumed("motion", "1 m/s along the normal; slip 0.15 m/s (λ = 1); spin 100 rad/s");
    sketches(&mut figure);
    loads(&mut figure)?;
    normal_claims(&mut figure)?;
    tangential_claims(&mut figure)?;
    torsional_claims(&mut figure)?;
    figure.deviation(
        "(a/R)² = ζ_MAX/R",
        "(a/R)² = ζ_MAX/(2R) for two equal balls, ζ their approach",
        "as printed for a ball on a plane, or with ζ the displacement of one of two balls",
    );
    Ok(figure)
}
