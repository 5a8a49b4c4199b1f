//! Test 5: a ball hits a rigid plane with one normal velocity and many slips.

use carom_halfspace::Material;
use carom_impact::restitution::of_spheres;
use carom_impact::{Body, Collision, Motion};
use carom_laws::friction::Friction;
use rayon::prelude::*;

use super::dem::{self, Ball, Contact, Substance};
use crate::reference::rows;
use crate::{
    Absolute, Axis, Cell, Failure, Figure, FigureResult, Marker, Panel, Series, Table, linspace,
};

const STEEL: Substance = Substance { young: 208e9, poisson: 0.3, density: 7850.0 };
const POLYETHYLENE: Substance = Substance { young: 1e9, poisson: 0.4, density: 1400.0 };
const RADIUS: f64 = 1e-5;
const APPROACH: f64 = 5.0;
const FRICTION: f64 = 0.3;

/// After the impact, over f V_n: slip of the contact point and rim velocity R omega.
#[derive(Clone, Copy)]
struct After {
    rebound: f64,
    rim: f64,
}

/// The exact walk in the groups kappa and lambda = V_t/(f V_n).
fn exact(poisson: f64, slip: f64) -> Result<After, Failure> {
    let restitution = of_spheres(crate::spheres::kappa(poisson), slip)?;
    // The rim takes 5/7 of the change of slip.
    Ok(After { rebound: -restitution * slip, rim: -5.0 / 7.0 * (1.0 + restitution) * slip })
}

fn with_dimensions(substance: Substance, slip: f64) -> Result<After, Failure> {
    let unit = FRICTION * APPROACH;
    let material = Material::from_young(substance.young, substance.poisson)?;
    let ball = Body::sphere(RADIUS, material, Ball::solid(RADIUS, substance).mass)?
        .moving(Motion::new([unit * slip, 0.0, -APPROACH], [0.0; 3])?);
    let plane = Body::plane(Material::RIGID);
    let outcome = Collision::new(ball, plane, Friction::new(FRICTION)?)?.solve()?;
    let [ball, _] = outcome.motions();
    let rim = RADIUS * ball.spin.y / unit;
    // Against the rolling sense, as the figure has it.
    Ok(After { rebound: ball.velocity.x / unit - rim, rim: -rim })
}

fn stepped(substance: Substance, slip: f64) -> After {
    let unit = FRICTION * APPROACH;
    let ball = Ball::solid(RADIUS, substance).moving([unit * slip, -APPROACH], 0.0);
    let contact = Contact::on_rigid(substance, FRICTION);
    let [ball, _] = dem::collide([ball, Ball::PLANE], contact).balls;
    let rim = RADIUS * ball.spin / unit;
    After { rebound: ball.velocity[0] / unit - rim, rim: -rim }
}

struct Published {
    fem_rebound: Vec<[f64; 2]>,
    fem_rim: Vec<[f64; 2]>,
    steel: Vec<[f64; 2]>,
    polyethylene: Vec<[f64; 2]>,
}

impl Published {
    fn read() -> Result<Self, Failure> {
        Ok(Self {
            fem_rebound: rows(include_str!("../../../data/particles/shear_fem_rebound.csv"))?,
            fem_rim: rows(include_str!("../../../data/particles/shear_fem_spin.csv"))?,
            steel: rows(include_str!("../../../data/particles/shear_steel_spin.csv"))?,
            polyethylene: rows(include_str!(
                "../../../data/particles/shear_polyethylene_spin.csv"
            ))?,
        })
    }
}

fn panels(figure: &mut Figure, published: &Published) -> Result<(), Failure> {
    let slips = linspace(0.0, 14.0, 281);
    let curve = |poisson: f64| -> Result<Vec<After>, Failure> {
        slips.par_iter().map(|&slip| exact(poisson, slip)).collect()
    };
    let (steel, polyethylene) = (curve(STEEL.poisson)?, curve(POLYETHYLENE.poisson)?);
    let line = |states: &[After], value: fn(&After) -> f64| -> Vec<(f64, f64)> {
        slips.iter().copied().zip(states.iter().map(value)).collect()
    };
    let slip = || Axis::linear("V_t/(f V_n)").between(0.0, 14.0);
    let labels = ["carom, steel (ν = 0.3)", "carom, polyethylene (ν = 0.4)"];
    let mut panel = Panel::new(slip(), "contact point after, V_st'/(f V_n')")
        .titled("Rebound of the contact point");
    panel.add(Series::line(labels[0], line(&steel, |a| a.rebound)));
    panel.add(Series::line(labels[1], line(&polyethylene, |a| a.rebound)));
    panel.add(Series::markers("finite elements", Marker::Dot, &published.fem_rebound));
    figure.panel(panel);
    let mut panel = Panel::new(slip(), "rim after, R ω'/(f V_n)").titled("Spin");
    panel.add(Series::line(labels[0], line(&steel, |a| a.rim)));
    panel.add(Series::line(labels[1], line(&polyethylene, |a| a.rim)));
    let within = |points: &[[f64; 2]]| -> Vec<[f64; 2]> {
        points.iter().copied().filter(|[x, _]| *x < 14.0).collect()
    };
    panel.add(Series::markers("finite elements", Marker::Dot, within(&published.fem_rim)));
    panel.add(Series::markers("particle code, steel", Marker::Circle, within(&published.steel)));
    let code = within(&published.polyethylene);
    panel.add(Series::markers("particle code, polyethylene", Marker::Square, code));
    figure.panel(panel);
    Ok(())
}

/// Root of the mean square distance of points from the exact curve.
fn distance(points: &[[f64; 2]], poisson: f64, value: fn(After) -> f64) -> Result<f64, Failure> {
    let squares: Result<Vec<f64>, Failure> = points
        .iter()
        .map(|&[x, y]| exact(poisson, x).map(|after| (value(after) - y) * (value(after) - y)))
        .collect();
    let squares = squares?;
    Ok((squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
}

fn distances(figure: &mut Figure, published: &Published) -> Result<(), Failure> {
    let mut table = Table::new(
        "Root mean square distance of the published points from carom",
        ["points", "quantity", "distance"],
    );
    let (steel, polyethylene) = (STEEL.poisson, POLYETHYLENE.poisson);
    let of = |points: &[[f64; 2]], poisson: f64| distance(points, poisson, |after| after.rim);
    let fem = distance(&published.fem_rebound, steel, |after| after.rebound)?;
    let rim = of(&published.fem_rim, steel)?;
    let codes = [of(&published.steel, steel)?, of(&published.polyethylene, polyethylene)?];
    let lines = [
        ("finite elements", "V_st'/(f V_n')", fem),
        ("finite elements", "R ω'/(f V_n)", rim),
        ("particle code, steel", "R ω'/(f V_n)", codes[0]),
        ("particle code, polyethylene", "R ω'/(f V_n)", codes[1]),
    ];
    for (points, quantity, distance) in lines {
        table.row([Cell::from(points), quantity.into(), distance.into()]);
    }
    figure.table(table);
    figure
        .at_most("rms distance of the finite elements' spin from carom's, steel", rim, 0.06)
        .source("Chung and Ooi 2011, read off the figures");
    // From here on all slides: 5 of spin, and V_t/(f V_n) - 7 of rebound.
    let sliding = |points: &[[f64; 2]], poisson: f64, value: fn(After) -> f64| {
        let far = points.iter().filter(|[x, _]| (6.5..14.0).contains(x));
        let pairs = far.map(|&[x, y]| Ok((value(exact(poisson, x)?), y)));
        pairs.collect::<Result<Vec<(f64, f64)>, Failure>>()
    };
    let mut pairs = sliding(&published.steel, steel, |after| after.rim)?;
    pairs.extend(sliding(&published.polyethylene, polyethylene, |after| after.rim)?);
    pairs.extend(sliding(&published.fem_rim, steel, |after| after.rim)?);
    pairs.extend(sliding(&published.fem_rebound, steel, |after| after.rebound)?);
    figure
        .all_close("all published points in complete sliding, over f V_n", pairs, Absolute(0.15))
        .source("Chung and Ooi 2011, read off the figures");
    Ok(())
}

fn exact_claims(figure: &mut Figure) -> Result<(), Failure> {
    let (mut dimensions, mut steps, mut sliding) = (Vec::new(), Vec::new(), Vec::new());
    for substance in [STEEL, POLYETHYLENE] {
        for slip in [0.2, 0.9, 1.6, 3.1, 4.4, 5.2, 8.0] {
            let expected = exact(substance.poisson, slip)?;
            let after = with_dimensions(substance, slip)?;
            dimensions.extend([(after.rebound, expected.rebound), (after.rim, expected.rim)]);
            let step = stepped(substance, slip);
            steps.extend([(after.rebound, step.rebound), (after.rim, step.rim)]);
        }
        for slip in [6.0, 9.0, 14.0] {
            let after = with_dimensions(substance, slip)?;
            sliding.extend([(after.rebound, slip - 7.0), (after.rim, -5.0)]);
        }
    }
    figure
        .all_close(
            "bodies with dimensions, two materials at seven slips",
            dimensions,
            Absolute(1e-11),
        )
        .source("groups κ and λ, momentum of a solid sphere");
    figure
        .all_close("the same once more", steps, Absolute(1e-5))
        .source("particle code of springs, stepped in time");
    figure
        .all_close("complete sliding: V_t/(f V_n) - 7 and -5", sliding, Absolute(1e-12))
        .source("impulse 2 f m V_n");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    super::name_source(&mut figure);
    figure.stated("ball", "R = 10 μm on a rigid plane, V_n = 5 m/s, f = 0.3, e = 1");
    figure.stated("steel", "208 GPa, 0.3, 7850 kg/m³");
    figure.stated("polyethylene", "1 GPa, 0.4, 1400 kg/m³");
    figure.assumed("ν of the finite elements", "0.3");
    let published = Published::read()?;
    panels(&mut figure, &published)?;
    exact_claims(&mut figure)?;
    distances(&mut figure, &published)?;
    figure.deviation(
        "the published particle code turns the ball faster up to V_t/(f V_n) = 5",
        "0.5 (rms) less: carom and the finite elements are 0.04 apart",
        "the code's tangential spring has no partial slip",
    );
    figure.deviation(
        "a rigid plane",
        "coupling of normal and tangential displacements neglected (ν < 1/2)",
        "as particle codes do; shown without a tolerance",
    );
    Ok(figure)
}
