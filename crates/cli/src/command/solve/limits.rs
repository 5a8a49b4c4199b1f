//! Force over approach of a body on a plate, with its limits: Hertz, and bending alone.

use carom_cases::case::{GapCase, PlateCase, SolveCase};
use carom_laws::curvature::RelativeCurvature;
use carom_laws::hertz::Hertz;
use carom_plot::{Axis, Marker, Panel, Series};
use carom_solver::{Shape, StepSummary};
use carom_special::logspace;

/// Points of a limit.
const POINTS: usize = 61;

/// The panel, if body 2 is a plate, the gap has curvatures, and there are two loads at least.
pub(super) fn limits(case: &SolveCase, steps: &[StepSummary]) -> Option<Panel> {
    let PlateCase { plate, .. } = case.plate?;
    let hertz = Hertz::new(curvature(&case.gap)?, case.materials).ok()?;
    let points: Vec<(f64, f64)> = steps
        .iter()
        .map(|step| (step.shift.zeta, step.load.f_z))
        .filter(|(zeta, force)| *zeta > 0.0 && *force > 0.0)
        .collect();
    let forces = points.iter().map(|(_, force)| *force);
    let (low, high) = (forces.clone().fold(f64::INFINITY, f64::min), forces.fold(0.0, f64::max));
    if low >= high {
        return None;
    }
    let compliance = plate.middle_compliance(case.materials.body_2());
    let forces = logspace(low, high, POINTS);
    let of = |approach: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        forces.iter().map(|force| (approach(*force), *force)).collect()
    };
    let mut panel =
        Panel::new(Axis::log("ζ / m"), Axis::log("F_z / N")).titled("between Hertz and bending");
    panel.add(Series::dotted("Hertz, half-space", of(&|force| hertz.approach(force))).coloured(6));
    panel.add(Series::dashed("bending, point load", of(&|force| compliance * force)).coloured(1));
    panel.add(Series::line("carom", points.clone()).coloured(0));
    panel.add(Series::markers("", Marker::Dot, points).coloured(0));
    Some(panel)
}

/// The relative curvature of a smooth gap.
fn curvature(gap: &GapCase) -> Option<RelativeCurvature> {
    let GapCase::Formula(shape) = gap else { return None };
    let radii = match shape {
        Shape::Paraboloid { radii } => *radii,
        Shape::Sphere { radius } => [*radius; 2],
        _ => return None,
    };
    RelativeCurvature::from_coefficients(0.5 / radii[0], 0.5 / radii[1]).ok()
}
