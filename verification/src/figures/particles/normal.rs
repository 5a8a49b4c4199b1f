//! Tests 1 and 2: two balls, and a ball on a rigid plane, along the normal and without damping.

use carom_halfspace::Material;
use carom_impact::{Body, Collision, Motion, Rebound};
use carom_laws::friction::Friction;

use super::dem::{self, Ball, Contact, Substance};
use crate::reference::rows;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Relative, Series, Table};

struct Case {
    name: &'static str,
    substance: Substance,
    radius: f64,
    friction: f64,
    /// Of each ball.
    velocity: f64,
    on_plane: bool,
}

const GLASS: Case = Case {
    name: "1 glass",
    substance: Substance { young: 48e9, poisson: 0.2, density: 2800.0 },
    radius: 0.01,
    friction: 0.35,
    velocity: 10.0,
    on_plane: false,
};
const LIMESTONE: Case = Case {
    name: "1 limestone",
    substance: Substance { young: 20e9, poisson: 0.25, density: 2500.0 },
    ..GLASS
};
const ALUMINIUM: Case = Case {
    name: "2 aluminium",
    substance: Substance { young: 70e9, poisson: 0.3, density: 2699.0 },
    radius: 0.1,
    friction: 0.0,
    velocity: 0.2,
    on_plane: true,
};
const MAGNESIUM: Case = Case {
    name: "2 magnesium",
    substance: Substance { young: 40e9, poisson: 0.35, density: 1800.0 },
    ..ALUMINIUM
};

impl Case {
    fn collision(&self) -> Result<Collision, Failure> {
        let material = Material::from_young(self.substance.young, self.substance.poisson)?;
        let mass = Ball::solid(self.radius, self.substance).mass;
        let ball = |velocity: f64| -> Result<Body, Failure> {
            let motion = Motion::new([0.0, 0.0, velocity], [0.0; 3])?;
            Ok(Body::sphere(self.radius, material, mass)?.moving(motion))
        };
        let other = if self.on_plane { Body::plane(Material::RIGID) } else { ball(self.velocity)? };
        Ok(Collision::new(ball(-self.velocity)?, other, Friction::new(self.friction)?)?)
    }

    fn rebound(&self) -> Result<Rebound, Failure> {
        let outcome = self.collision()?.solve()?;
        Ok(outcome.rebound().ok_or("they approach each other")?.clone())
    }

    fn balls(&self) -> [Ball; 2] {
        let ball = Ball::solid(self.radius, self.substance);
        let other =
            if self.on_plane { Ball::PLANE } else { ball.moving([0.0, self.velocity], 0.0) };
        [ball.moving([0.0, -self.velocity], 0.0), other]
    }

    fn contact(&self) -> Contact {
        if self.on_plane {
            Contact::on_rigid(self.substance, self.friction)
        } else {
            Contact::alike(self.substance, self.friction)
        }
    }
}

fn extremes(rebound: &Rebound) -> [f64; 3] {
    [rebound.maximal_approach, rebound.maximal_force, rebound.duration]
}

struct Published {
    approach: Vec<[f64; 2]>,
    time: Vec<[f64; 2]>,
}

fn panels(figure: &mut Figure, case: &Case, published: &Published) -> Result<(), Failure> {
    let history = case.collision()?.history(201)?;
    let label = "published points";
    let mut panel = Panel::new("approach / μm", "force / kN").titled(format!("Test {}", case.name));
    let curve = history.iter().map(|p| (1e6 * p.shift.z, 1e-3 * p.force.z));
    panel.add(Series::line("carom", curve));
    panel.add(Series::markers(label, Marker::Circle, &published.approach));
    figure.panel(panel);
    let mut panel = Panel::new("time / μs", "force / kN").titled(format!("Test {}", case.name));
    let curve = history.iter().map(|p| (1e6 * p.time, 1e-3 * p.force.z));
    panel.add(Series::line("carom", curve));
    panel.add(Series::markers(label, Marker::Circle, &published.time));
    figure.panel(panel);
    Ok(())
}

/// Force at the published instants and approaches, over the greatest force.
fn published_claim(figure: &mut Figure, case: &Case, published: &Published) -> Result<(), Failure> {
    let collision = case.collision()?;
    let peak = 1e-3 * case.rebound()?.maximal_force;
    let by_approach = published
        .approach
        .iter()
        .map(|[x, force]| (1e-3 * collision.hertz().force(1e-6 * x) / peak, force / peak));
    let unit = 1e6 * case.rebound()?.duration / carom_impact::normal::DURATION;
    let by_time = published.time.iter().map(|[time, force]| {
        let zeta = carom_impact::normal::state_at(time / unit).compression;
        (zeta * zeta.sqrt(), force / peak)
    });
    let pairs: Vec<(f64, f64)> = by_approach.chain(by_time).collect();
    figure
        .all_close(
            format!("published forces of test {}, over the greatest", case.name),
            pairs,
            Absolute(0.02),
        )
        .source("Chung and Ooi 2011, read off the figures");
    Ok(())
}

fn table(figure: &mut Figure) -> Result<(), Failure> {
    let mut table = Table::new(
        "Greatest approach and force, duration",
        ["test", "approach / μm", "force / kN", "duration / μs"],
    );
    let (mut closed, mut stepped) = (Vec::new(), Vec::new());
    for case in [&GLASS, &LIMESTONE, &ALUMINIUM, &MAGNESIUM] {
        let values = extremes(&case.rebound()?);
        let [approach, force, duration] = values;
        table.row([
            crate::Cell::from(case.name),
            (1e6 * approach).into(),
            (1e-3 * force).into(),
            (1e6 * duration).into(),
        ]);
        let (balls, contact) = (case.balls(), case.contact());
        closed.extend(values.into_iter().zip(dem::extremes(&balls, contact)));
        let course = dem::collide(balls, contact);
        let expected = [course.greatest_approach, course.greatest_force, course.duration];
        stepped.extend(values.into_iter().zip(expected));
    }
    figure.table(table);
    figure
        .all_close("the twelve extremes", closed, Relative(1e-13))
        .source("Hertz's formulas with E*, R*, m*");
    figure
        .all_close("the twelve extremes once more", stepped, Relative(1e-5))
        .source("particle code of springs, stepped in time");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    super::name_source(&mut figure);
    figure
        .stated("test 1", "two balls, R = 10 mm, ±10 m/s, f = 0.35: glass 48 GPa, 0.2, 2800 kg/m³");
    figure.stated("test 1, limestone", "20 GPa, 0.25, 2500 kg/m³");
    figure.stated(
        "test 2",
        "ball on a rigid plane, R = 100 mm, 0.2 m/s: aluminium 70 GPa, 0.3, 2699 kg/m³",
    );
    figure.stated("test 2, magnesium", "40 GPa, 0.35, 1800 kg/m³");
    let glass = Published {
        approach: rows(include_str!("../../../data/particles/glass_approach.csv"))?,
        time: rows(include_str!("../../../data/particles/glass_time.csv"))?,
    };
    let aluminium = Published {
        approach: rows(include_str!("../../../data/particles/aluminium_approach.csv"))?,
        time: rows(include_str!("../../../data/particles/aluminium_time.csv"))?,
    };
    for (case, published) in [(&GLASS, &glass), (&ALUMINIUM, &aluminium)] {
        panels(&mut figure, case, published)?;
        published_claim(&mut figure, case, published)?;
    }
    table(&mut figure)?;
    let printed = [274.113e-6, 10.6969e3, 40.3395e-6, 49.7172e-6, 11.3699e3, 731.657e-6];
    let values = [extremes(&GLASS.rebound()?), extremes(&ALUMINIUM.rebound()?)].concat();
    figure
        .all_close("glass and aluminium", values.into_iter().zip(printed), Relative(5e-6))
        .source("independent program, six digits");
    figure.deviation(
        "the impact of test 1 is elastic and Hertzian",
        "waves would take 4.5 % of the energy, and a/R = 0.117 exceeds 0.1",
        "at 20 m/s the quasistatic half-space is left; the test compares codes, not experiments",
    );
    Ok(figure)
}
