//! What the tests of particle codes record or accept for oblique impacts, beside the exact impact.

use carom_halfspace::Material;
use carom_impact::closed_form::restitution_without_slip;
use carom_impact::oblique::{Groups, ObliqueImpact, Regime};
use carom_impact::restitution::of_groups;
use carom_impact::{Body, Collision, Motion, normal};
use carom_laws::damping::HertzDamping;
use carom_laws::friction::Friction;
use carom_laws::grains::{Grain, GrainContact, GrainLoad, Meeting, Wall};
use carom_laws::shift_law::ShiftLaw;
use carom_laws::stiffness::ContactStiffness;

use super::dem::{self, Ball, Contact, Substance};
use super::viscous::viscous;
use crate::spheres::{chi, kappa};
use crate::spring_impact;
use crate::{
    Absolute, Axis, Cell, Failure, Figure, FigureResult, Marker, Panel, Relative, Series, Table,
    linspace,
};

// LAMMPS, unittest/granular/tests/dem04-mindlin-sticking-3d-si.yaml of 4 July 2026.
const ALUMINIUM: Substance = Substance { young: 70e9, poisson: 0.33, density: 2700.0 };
const RADIUS: f64 = 0.0025;
const FRICTION: f64 = 0.092;
/// m/s: along the wall and towards it.
const BEFORE: [f64; 2] = [0.5, 2.9876];
const RESTITUTION: f64 = 0.98;
/// v_x in m/s and the spin in rad/s that it records.
const RECORDED: After =
    After { tangential: 0.344_378_902_445_220_57, spin: 155.621_097_554_779_54 };

// DIRT's `bench_oblique_impact`: Poisson's ratio, and the tangential restitution that its text expects at small angles.
const DIRT_POISSON: f64 = 0.23;
const PLATEAU: f64 = -1.0;

// MOOSE's DEM module, validation of the oblique impact: moduli of the pair, speed, angle from which it checks.
const MOOSE_MODULI: [f64; 2] = [63e9, 13.5e9];
const MOOSE_SPEED: f64 = 3.85;
const MOOSE_BOUND: f64 = 32.5;

/// Tolerance of R_x of viscous balls.
const CLOSE: f64 = 1e-4;
/// The contact lies on the undeformed ball, as in the theory: half the approach (0.3 % of R) nearer, R_x is 0.008 higher.
const UNCOMPRESSED: f64 = 0.0;
const STEPS_OF_GRAINS: f64 = 4000.0;

/// The ball after the impact.
#[derive(Clone, Copy)]
struct After {
    tangential: f64,
    spin: f64,
}

impl After {
    /// That of a ball whose contact point returns with this restitution: the impulse changes the velocity by 2/7 of
    /// the change of the contact point.
    fn of_restitution(r_x: f64) -> Self {
        let change = 2.0 / 7.0 * (1.0 + r_x) * BEFORE[0];
        Self { tangential: BEFORE[0] - change, spin: 2.5 * change / RADIUS }
    }

    fn restitution(self) -> f64 {
        (RADIUS * self.spin - self.tangential) / BEFORE[0]
    }
}

fn lambda() -> f64 {
    BEFORE[0] / (FRICTION * BEFORE[1])
}

fn groups() -> Result<Groups, Failure> {
    Ok(Groups::of_spheres(kappa(ALUMINIUM.poisson), lambda())?)
}

/// The collision of the test, e = 1, by its bodies.
fn exact() -> Result<After, Failure> {
    let material = Material::from_young(ALUMINIUM.young, ALUMINIUM.poisson)?;
    let [tangential, normal] = BEFORE;
    let ball = Body::sphere(RADIUS, material, Ball::solid(RADIUS, ALUMINIUM).mass)?
        .moving(Motion::new([tangential, 0.0, -normal], [0.0; 3])?);
    let outcome = Collision::new(ball, Body::plane(material), Friction::new(FRICTION)?)?.solve()?;
    let [ball, _] = outcome.motions();
    Ok(After { tangential: ball.velocity.x, spin: ball.spin.y })
}

/// A particle code of springs with sliders, e = 1.
fn by_springs() -> After {
    let [tangential, normal] = BEFORE;
    let ball = Ball::solid(RADIUS, ALUMINIUM).moving([tangential, -normal], 0.0);
    let contact = Contact::alike(ALUMINIUM, FRICTION);
    let [ball, _] = dem::collide([ball, Ball::PLANE], contact).balls;
    After { tangential: ball.velocity[0], spin: ball.spin }
}

/// The ball and a wall by the contact of carom's grains, stepped as a particle code does; after it, and its normal
/// restitution.
fn by_grains(restitution: f64) -> Result<(After, f64), Failure> {
    let [tangential, normal] = BEFORE;
    let mass = Ball::solid(RADIUS, ALUMINIUM).mass;
    let shear = ALUMINIUM.young / (2.0 * (1.0 + ALUMINIUM.poisson));
    // c_z = 2 E* sqrt(R) and c_x = c_z/kappa, of a ball on its own material.
    let c_z = 2.0 * RADIUS.sqrt() * shear / (1.0 - ALUMINIUM.poisson);
    let c_x = c_z / kappa(ALUMINIUM.poisson);
    let law = ShiftLaw::new(ContactStiffness::new(c_x, c_x, c_z)?, Friction::new(FRICTION)?);
    let damping = HertzDamping::of_restitution(restitution)?;
    let mut contact: GrainContact<ShiftLaw<[f64; 2]>> =
        GrainContact::new(law, 0.0)?.with_restitution(damping)?;
    let deepest = libm::pow(15.0 * mass * normal * normal / (8.0 * c_z), 0.4);
    let dt = normal::DURATION * deepest / normal / STEPS_OF_GRAINS;
    let wall = Wall { place: [0.0; 3], normal: [0.0, 0.0, 1.0], velocity: [0.0; 3] };
    let mut ball = Grain {
        place: [0.0, 0.0, RADIUS],
        velocity: [tangential, 0.0, -normal],
        spin: [0.0; 3],
        radius: RADIUS,
        mass,
    };
    let mut load = GrainLoad::default();
    for step in 0.. {
        kick(&mut ball, &load, 0.5 * dt);
        for k in 0..3 {
            ball.place[k] += dt * ball.velocity[k];
        }
        if ball.place[2] >= RADIUS && step > 3 {
            break;
        }
        load = contact.advance(&Meeting::on_wall(&ball, &wall, UNCOMPRESSED), dt)?;
        kick(&mut ball, &load, 0.5 * dt);
    }
    let after = After { tangential: ball.velocity[0], spin: ball.spin[1] };
    Ok((after, ball.velocity[2] / normal))
}

fn kick(ball: &mut Grain, load: &GrainLoad, dt: f64) {
    let inertia = 0.4 * ball.mass * ball.radius * ball.radius;
    for k in 0..3 {
        ball.velocity[k] += dt * load.force[k] / ball.mass;
        ball.spin[k] += dt * load.torques[0][k] / inertia;
    }
}

/// R_x against lambda or psi_1, exact and by the spring.
fn curves(panel: &mut Panel, kappa: f64, places: &[f64], by_lambda: bool) -> Result<(), Failure> {
    let chi = 3.5 / kappa;
    let psi = |x: f64| if by_lambda { x / kappa } else { x };
    let exact: Result<Vec<(f64, f64)>, Failure> =
        places.iter().map(|&x| Ok((x, of_groups(chi, psi(x))?))).collect();
    let spring = places.iter().map(|&x| (x, spring_impact::of_whole_spring(chi, psi(x))));
    panel.add(Series::line("exact, e = 1", exact?));
    panel.add(Series::dashed("a spring that slips as a whole, e = 1", spring.collect::<Vec<_>>()));
    Ok(())
}

// ---- LAMMPS ------------------------------------------------------------------------------------

fn lammps(figure: &mut Figure) -> Result<(), Failure> {
    let (exact, springs) = (exact()?, by_springs());
    let lossy =
        After::of_restitution(viscous(kappa(ALUMINIUM.poisson), lambda(), RESTITUTION, CLOSE)?);
    let ((stepped, kept), (damped, lost)) = (by_grains(1.0)?, by_grains(RESTITUTION)?);
    let rows = [
        ("LAMMPS's record, mindlin, e = 0.98", RECORDED),
        ("exact, e = 1", exact),
        ("springs with sliders, e = 1", springs),
        ("contact of grains in 4000 steps, e = 1", stepped),
        ("exact, viscous, e = 0.98", lossy),
        ("contact of grains, damped, e = 0.98", damped),
    ];
    let mut table =
        Table::new("dem04-mindlin-sticking", ["", "v_x / (m/s)", "spin / (rad/s)", "R_x"]);
    for (name, after) in rows {
        let numbers = [after.tangential, after.spin, after.restitution()];
        table.row([Cell::from(name), numbers[0].into(), numbers[1].into(), numbers[2].into()]);
    }
    figure.table(table);
    let mut panel = Panel::new(Axis::linear("λ = v_t/(f v_n)"), Axis::linear("R_x"))
        .titled("LAMMPS's test of sticking, ν = 0.33");
    curves(&mut panel, kappa(ALUMINIUM.poisson), &linspace(0.02, 9.0, 180), true)?;
    let at = |after: After| [(lambda(), after.restitution())];
    panel.add(Series::markers("recorded", Marker::Circle, at(RECORDED)));
    panel.add(Series::markers("carom, damped, e = 0.98", Marker::Dot, at(damped)));
    figure.panel(panel);

    figure
        .close(
            "the record is one impulse along the wall",
            RECORDED.tangential,
            BEFORE[0] - 0.4 * RADIUS * RECORDED.spin,
            Absolute(1e-12),
        )
        .source("momentum: m Δv_x = -(2/5) m R ω");
    figure
        .all_close(
            "v_x and spin, e = 1",
            [(exact.tangential, springs.tangential), (RADIUS * exact.spin, RADIUS * springs.spin)],
            Absolute(1e-6),
        )
        .source("particle code of springs with sliders, stepped in time");
    figure
        .close(
            "R_x, e = 1, by the contact of grains",
            stepped.restitution(),
            springs.restitution(),
            Absolute(1e-4),
        )
        .source("particle code of springs with sliders, stepped in time");
    figure
        .close("R_x, e = 1, at λ = 1.819", exact.restitution(), 0.311, Absolute(5e-4))
        .source("independent program of springs, three decimals");
    figure
        .all_close(
            "normal restitution of the grains, e = 1 and 0.98",
            [(kept, 1.0), (lost, RESTITUTION)],
            Absolute(2e-5),
        )
        .source("the e that was asked for");
    let shift = |after: After| (after.restitution() - exact.restitution()).abs();
    figure
        .at_most("two percent lost change R_x by", shift(lossy).max(shift(damped)), 0.02)
        .source("rows of springs by other programs: 0.027 at e = 0.95, λ = 2, κ = 1.2");
    figure
        .close(
            "R_x, e = 0.98, by the contact of grains",
            damped.restitution(),
            lossy.restitution(),
            Absolute(0.008),
        )
        .source("the viscous impact; the step law of grains is off by 0.011 at e = 0.95");
    let below = damped.restitution().min(lossy.restitution()) - RECORDED.restitution();
    figure
        .at_least("the recorded R_x is lower than both, by", below, 0.2)
        .source("v_x and ω_y that the test records");
    figure
        .at_least(
            "the recorded spin is lower than both, by a part of",
            1.0 - RECORDED.spin / damped.spin.min(lossy.spin),
            0.15,
        )
        .source("ω_y that the test records");
    let spring = spring_impact::of_whole_spring(groups()?.chi(), groups()?.psi());
    figure
        .close(
            "it is that of a spring that slips as a whole",
            RECORDED.restitution(),
            spring,
            Absolute(0.05),
        )
        .source("such a spring with e = 1, stepped in time");
    Ok(())
}

// ---- DIRT --------------------------------------------------------------------------------------

fn dirt(figure: &mut Figure) -> Result<(), Failure> {
    let mut panel = Panel::new(Axis::linear("ψ₁ = λ/κ"), Axis::linear("R_x").between(-1.05, 0.6))
        .titled("DIRT's oblique impacts, ν = 0.23");
    curves(&mut panel, kappa(DIRT_POISSON), &linspace(0.02, 6.0, 150), false)?;
    let plateau = [(0.0, PLATEAU), (0.5, PLATEAU)];
    panel.add(Series::dotted("plateau of its text at small ψ₁", plateau));
    figure.panel(panel);
    let ratios = [DIRT_POISSON, 0.3];
    let limits: Vec<f64> = ratios.iter().map(|&nu| restitution_without_slip(chi(nu))).collect();
    let stepped = ratios.iter().map(|&nu| spring_impact::restitution(chi(nu), 1e-3));
    figure
        .all_close(
            "limit of small angles, ν = 0.23 and 0.3",
            limits.iter().copied().zip(stepped),
            Absolute(1e-3),
        )
        .source("springs with sliders at ψ₁ = 0.001, stepped in time");
    figure
        .close("that of ν = 0.3", limits[1], -0.232, Absolute(5e-4))
        .source("independent program of springs, three decimals");
    figure
        .at_least("above the plateau of the text by", limits[0].min(limits[1]) - PLATEAU, 0.7)
        .source("README of the benchmark: β ≈ -1 at low ψ₁");
    let angles = [0.1, 0.3, 0.6, 0.95, 1.4, 2.2, 3.3, 4.6];
    let pairs: Result<Vec<(f64, f64)>, Failure> = angles
        .into_iter()
        .map(|psi| {
            let chi = chi(DIRT_POISSON);
            Ok((of_groups(chi, psi)?, spring_impact::restitution(chi, psi)))
        })
        .collect();
    figure
        .all_close("R_x at eight angles, ν = 0.23", pairs?, Absolute(2e-5))
        .source("springs with sliders, stepped in time");
    Ok(())
}

// ---- MOOSE -------------------------------------------------------------------------------------

/// lambda at an angle of incidence in degrees.
fn at_angle(degrees: f64) -> f64 {
    libm::tan(degrees.to_radians()) / FRICTION
}

/// The spin after, e = 1, rad/s.
fn spin(degrees: f64, r_x: f64) -> f64 {
    let tangential = MOOSE_SPEED * libm::sin(degrees.to_radians());
    2.5 / RADIUS * (2.0 / 7.0) * (1.0 + r_x) * tangential
}

/// The spin of sliding throughout, e = 1: impulse 2 f m v_n.
fn sliding_spin(degrees: f64) -> f64 {
    5.0 * FRICTION * MOOSE_SPEED * libm::cos(degrees.to_radians()) / RADIUS
}

fn moose(figure: &mut Figure) -> Result<(), Failure> {
    let ratio = MOOSE_MODULI[0] / (4.0 * MOOSE_MODULI[1]);
    let impact = |degrees: f64| -> Result<ObliqueImpact, Failure> {
        Ok(ObliqueImpact::new(Groups::of_spheres(ratio, at_angle(degrees))?)?)
    };
    let exact = |degrees: f64| Ok::<_, Failure>(spin(degrees, impact(degrees)?.restitution()));
    let bound = libm::atan(FRICTION * (7.0 - ratio)).to_degrees();
    let degrees = linspace(1.0, 60.0, 178);
    let mut panel =
        Panel::new(Axis::linear("angle of incidence / degrees"), Axis::linear("spin / (rad/s)"))
            .titled("MOOSE's oblique impacts, κ = 1.1667");
    let curve: Result<Vec<(f64, f64)>, Failure> =
        degrees.iter().map(|&angle| Ok((angle, exact(angle)?))).collect();
    panel.add(Series::line("exact, e = 1", curve?));
    let sliding = degrees.iter().filter(|&&angle| angle > 20.0);
    let sliding: Vec<_> = sliding.map(|&angle| (angle, sliding_spin(angle))).collect();
    panel.add(Series::dashed("sliding throughout, e = 1", sliding));
    for (name, angle) in
        [("checked from here on", MOOSE_BOUND), ("slides throughout from here on", bound)]
    {
        panel.add(Series::dotted(name, [(angle, 0.0), (angle, 700.0)]));
    }
    figure.panel(panel);

    figure
        .close(
            "its bound is that of rigid bodies, e = 0.98",
            libm::atan(3.5 * FRICTION * 1.98).to_degrees(),
            MOOSE_BOUND,
            Absolute(0.05),
        )
        .source("validation page of the module");
    figure
        .close("the contact slides throughout from this angle on", bound, 28.22, Absolute(5e-3))
        .source("λ = 7 - κ, by hand");
    let between = [bound + 0.01, 30.0, 32.4];
    let mut spins = Vec::new();
    let mut slides = true;
    for angle in between {
        spins.push((exact(angle)?, sliding_spin(angle)));
        slides &= impact(angle)?.regimes().eq([Regime::SlideForward]);
    }
    figure
        .all_close("spin between the two, by the formula of sliding", spins, Relative(1e-12))
        .source("impulse 2 f m v_n");
    figure
        .holds(
            "there the contact never sticks, though its point returns",
            slides && impact(30.0)?.restitution() > 0.0,
            impact(30.0)?.restitution(),
        )
        .source("w = (χ - ψ)/(χ - 1) is below -1");
    let springs = |angle: f64| spring_impact::restitution(3.5 / ratio, at_angle(angle) / ratio);
    let angles = [3.0, 8.0, 14.0, 20.0, 25.0, 27.0, 30.0];
    let pairs: Result<Vec<(f64, f64)>, Failure> = angles
        .iter()
        .map(|&angle| Ok((exact(angle)? / 600.0, spin(angle, springs(angle)) / 600.0)))
        .collect();
    figure
        .all_close("spin over 600/s at seven angles below its bound", pairs?, Absolute(2e-5))
        .source("springs with sliders, stepped in time");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("LAMMPS", "test dem04-mindlin-sticking-3d-si of 4 July 2026: R = 2.5 mm, 70 GPa, ν = 0.33, 2700 kg/m³, f = 0.092, v = (0.5, -2.9876) m/s, e = 0.98, on a wall");
    figure.stated("DIRT", "bench_oblique_impact: alumina, ν = 0.23, f = 0.092, e = 0.98");
    figure.stated(
        "MOOSE",
        "validation of its DEM module: E* = 63 GPa, G* = 13.5 GPa, f = 0.092, 3.85 m/s, e = 0.98",
    );
    figure.assumed("e = 0.98", "a viscous material: its exact impact, and the step law of grains");
    figure.assumed(
        "arm of the force",
        "R; LAMMPS takes R less half the approach, here 0.3 %, which raises R_x by 0.008",
    );
    lammps(&mut figure)?;
    dirt(&mut figure)?;
    moose(&mut figure)?;
    figure.snapshot_digits(5);
    Ok(figure)
}
