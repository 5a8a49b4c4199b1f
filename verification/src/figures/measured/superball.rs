//! Cross's Superball on granite: large strains, and where the theory of half-spaces ends.

use super::models::{bars, elastic};
use crate::reference::rows;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series, linspace};

const KAPPA: f64 = 1.5;
const FRICTION: f64 = 0.45;
const NORMAL: f64 = 0.88;

/// -(slip after)/(slip before) at this angle from the surface.
fn restitution(friction: f64, degrees: f64) -> Result<f64, Failure> {
    elastic(KAPPA, 1.0 / (friction * libm::tan(degrees.to_radians())), NORMAL)
}

/// Tangential velocity after over before: 2/7 of the change of slip.
fn share(friction: f64, degrees: f64) -> Result<f64, Failure> {
    Ok(1.0 - 2.0 / 7.0 * (1.0 + restitution(friction, degrees)?))
}

type Curve = fn(f64, f64) -> Result<f64, Failure>;

fn panel(title: &str, axis: &str, curve: Curve, points: &[[f64; 3]]) -> Result<Panel, Failure> {
    let mut panel = Panel::new("incidence from the surface / degrees", axis).titled(title);
    let angles = linspace(5.0, 88.0, 167);
    for (name, friction, colour) in
        [("f = 0.45", FRICTION, 0), ("f = 0.37", 0.37, 5), ("f = 0.53", 0.53, 4)]
    {
        let values: Result<Vec<(f64, f64)>, Failure> =
            angles.iter().map(|angle| Ok((*angle, curve(friction, *angle)?))).collect();
        let series =
            if colour == 0 { Series::line(name, values?) } else { Series::dashed(name, values?) };
        panel.add(series.coloured(colour));
    }
    let ends = points.iter().map(|[x, y, error]| [*x, y - error, y + error]);
    bars(ends).into_iter().for_each(|bar| panel.add(bar));
    let dots = points.iter().map(|[x, y, _]| (*x, *y));
    panel.add(Series::markers("measured", Marker::Dot, dots).coloured(6));
    Ok(panel)
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("ball", "solid rubber, 46 mm, on polished granite, 4 to 6.5 m/s");
    figure.stated("friction", "0.45 ± 0.08");
    figure.stated("measured", "Cross 2014, Experimental Mechanics 54, 1523");
    figure.assumed("ν", "0.5, so κ = 3/2");
    figure.assumed("e", "0.88: the friction impulse is (1 + e)/2 of the elastic one");
    let rows: Vec<[f64; 6]> = rows(include_str!("../../../data/measured/superball.csv"))?;
    let slips: Vec<_> = rows.iter().map(|r| [r[0], r[3], 0.03]).collect();
    figure.panel(panel("Slip after over slip before", "e_x", restitution, &slips)?);
    let shares: Vec<_> = rows.iter().map(|r| [r[0], r[1], 0.01]).collect();
    figure.panel(panel("Velocity along the surface", "v_x' / v_x", share, &shares)?);
    let (mut pairs, mut grip, mut steep) = (Vec::new(), Vec::new(), Vec::new());
    for [angle, ratio, _, slip, slip_reference, ratio_reference] in rows {
        let (found, along) = (restitution(FRICTION, angle)?, share(FRICTION, angle)?);
        pairs.extend([(found, slip_reference), (along, ratio_reference)]);
        if angle > 35.0 && angle < 50.0 {
            grip.push((along, ratio));
        } else if angle > 70.0 {
            steep.push(slip / found);
        }
    }
    figure
        .all_close("e_x and v_x'/v_x of the same ball", pairs, Absolute(4e-3))
        .source("independent program, by reduced dimensionality");
    figure
        .all_close("v_x'/v_x from 35° to 50°, where it grips", grip, Absolute(0.07))
        .source("Cross 2014; friction known to a fifth");
    let least = steep.into_iter().fold(f64::INFINITY, f64::min);
    figure
        .at_least("above 70° the ball comes back so many times as much", least, 2.0)
        .source("Cross 2014: beyond the theory, the whole ball shears");
    Ok(figure)
}
