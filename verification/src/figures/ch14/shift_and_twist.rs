//! Figs. 14.25 to 14.29, 14.31, 14.32: an ellipse shifted and twisted at the same time.

use super::super::mesh::{APPROACH, Mesh, Step, Touching, steps};
use super::angle_axis;
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series};
use carom_classic::rigid_slip::spin_about;
use carom_laws::law::Shift;

const INDEPENDENT: &str = "an independent half-space program";
const AXES: [f64; 2] = [10.0, 1.0];
const LAST: Shift = Shift { zeta: APPROACH, xi: 0.2, eta: 0.2, omega: 0.0 };

/// Along which axis the bodies are shifted.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    X,
    Y,
}

impl Way {
    fn history(self) -> Vec<Shift> {
        let rest = Shift { zeta: APPROACH, ..Shift::default() };
        let twist = 2.0_f64.to_radians();
        let end = match self {
            Self::X => Shift { eta: 0.0, omega: twist, ..LAST },
            Self::Y => Shift { xi: 0.0, omega: twist, ..LAST },
        };
        let mut path = vec![rest];
        path.extend(steps(rest, end, 10));
        path
    }

    const fn name(self) -> &'static str {
        match self {
            Self::X => "ξ",
            Self::Y => "η",
        }
    }
}

fn mesh() -> Mesh {
    Mesh::of(AXES, [60, 30])
}

fn start(way: Way) -> Result<(Figure, Vec<Step>), Failure> {
    let mut figure = Figure::new();
    figure.stated("a, b, ζ, ν", "10, 1, 0.1, 0");
    figure.stated("increments", format!("Δ{} = 0.02, Δβ = 0.2°, 10 times", way.name()));
    figure.assumed("f", "1");
    figure.assumed("elements", "60 × 30 (40 × 20 in the thesis)");
    Ok((figure, mesh().follow(&way.history())?))
}

/// The direction of a rigid motion of body 2 at a place (12.2), in degrees.
fn rigid_angle(shift: &Shift, x: f64, y: f64) -> f64 {
    (shift.eta - x * shift.omega).atan2(shift.xi + y * shift.omega).to_degrees()
}

/// How far the stress turns from rigid slip where it slips, in degrees, in ascending order.
fn turns(step: &Step, shift: &Shift) -> Vec<f64> {
    let turn = |cell: Touching| {
        let turn = cell.angle() - rigid_angle(shift, cell.x, cell.y);
        (turn - 360.0 * (turn / 360.0).round()).abs()
    };
    let mut turns: Vec<f64> = step.touching().filter(|cell| !cell.sticks).map(turn).collect();
    turns.sort_by(f64::total_cmp);
    turns
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Angles along three rows of elements, with rigid slip as lines; sizes over p_0.
fn panels(figure: &mut Figure, step: &Step, shift: &Shift, title: &str) -> Result<(), Failure> {
    let peak = mesh().hertz()?.at_approach(APPROACH)?.pressure(0.0, 0.0);
    let mut angles = Panel::new("x", angle_axis()).titled(title);
    let mut sizes = Panel::new("x", "|t|/(f p₀)").titled(title);
    let rows = [-0.5, 1.0 / 30.0, 0.5];
    for (colour, row) in rows.into_iter().enumerate() {
        let cells: Vec<Touching> =
            step.touching().filter(|cell| (cell.y - row).abs() < 0.02).collect();
        let name = format!("y = {row:.2}");
        let rigid = cells.iter().map(|cell| (cell.x, rigid_angle(shift, cell.x, cell.y)));
        angles.add(Series::line(format!("rigid slip, {name}"), rigid).coloured(colour));
        let own = cells.iter().map(|cell| (cell.x, cell.angle()));
        let label = format!("numerical, {name}");
        angles.add(Series::markers(label, Marker::Circle, own).coloured(colour));
        let size = cells.iter().map(|cell| (cell.x, cell.size() / peak));
        sizes.add(Series::markers(name, Marker::Circle, size).coloured(colour));
    }
    figure.panel(angles);
    figure.panel(sizes);
    Ok(())
}

pub(super) fn along_x_first() -> FigureResult {
    let (mut figure, run) = start(Way::X)?;
    let shift = Way::X.history()[1];
    panels(&mut figure, &run[1], &shift, "step 2")?;
    let turns = turns(&run[1], &shift);
    figure
        .close("mean turn from rigid slip in degrees", mean(&turns), 8.0, Absolute(1.0))
        .source(INDEPENDENT);
    figure.close("greatest turn", turns[turns.len() - 1], 28.0, Absolute(2.0)).source(INDEPENDENT);
    let most = turns[turns.len() * 95 / 100];
    figure.close("95 % turn less than", most, 24.0, Absolute(2.0)).source(INDEPENDENT);
    figure.deviation("Δζ = 0.02", "Δξ = 0.02", "the text above fig. 14.25 against its captions");
    Ok(figure)
}

pub(super) fn along_x_last() -> FigureResult {
    let (mut figure, run) = start(Way::X)?;
    let shift = Way::X.history()[10];
    panels(&mut figure, &run[10], &shift, "step 11")?;
    let turns = turns(&run[10], &shift);
    figure
        .close("mean turn from rigid slip in degrees", mean(&turns), 0.8, Absolute(0.2))
        .source(INDEPENDENT);
    figure
        .at_most("greatest turn", turns[turns.len() - 1], 2.0)
        .source("an independent half-space program: 1.6");
    let ellipse = mesh().ellipse()?;
    // The pole of (12.2): x' = eta/Omega, y' = -xi/Omega.
    let rigid = spin_about(&ellipse, 0.0, -shift.xi / shift.omega)?;
    let load = run[10].load;
    figure
        .close(
            "force over (14.3)",
            load.f_x.abs() / load.f_z,
            rigid.force_x.hypot(rigid.force_y),
            Absolute(0.01),
        )
        .source("rigid slip (14.3)");
    Ok(figure)
}

fn contours(figure: &mut Figure, run: &[Step], known: &[f64]) {
    let mut panel = Panel::new("x", "y");
    for (i, step) in run.iter().enumerate().skip(1).take(7).filter(|(_, step)| step.stick() > 0.0) {
        panel.add(Series::line(format!("step {}", i + 1), step.stick_outline()));
    }
    figure.panel(panel);
    let pairs = known.iter().enumerate().map(|(i, part)| (run[i + 1].stick(), *part));
    figure
        .all_close("parts that stick, from step 2 on", pairs, Absolute(1.5e-3))
        .source(INDEPENDENT);
}

pub(super) fn contours_along_x() -> FigureResult {
    let (mut figure, run) = start(Way::X)?;
    contours(&mut figure, &run, &[0.666, 0.418, 0.220, 0.077, 0.0]);
    let centres = [2, 3, 4, 5].map(|n| run[n - 1].stick_centre());
    let aside = centres.iter().map(|c| c[0].abs()).fold(0.0, f64::max);
    figure.at_most("it moves along y only", aside, 1e-9).source("symmetry");
    figure
        .decreasing("towards the pole at y' = -ξ/β", centres.map(|c| c[1]))
        .source("the pole of slip (12.2)");
    Ok(figure)
}

pub(super) fn along_y() -> FigureResult {
    let (mut figure, run) = start(Way::Y)?;
    let path = Way::Y.history();
    panels(&mut figure, &run[1], &path[1], "step 2")?;
    panels(&mut figure, &run[10], &path[10], "step 11")?;
    let turns = turns(&run[1], &path[1]);
    figure
        .close("step 2: mean turn from rigid slip in degrees", mean(&turns), 8.6, Absolute(1.0))
        .source(INDEPENDENT);
    figure
        .close("step 2: 95 % turn less than", turns[turns.len() * 95 / 100], 37.0, Absolute(3.0))
        .source(INDEPENDENT);
    Ok(figure)
}

pub(super) fn contours_along_y() -> FigureResult {
    let (mut figure, run) = start(Way::Y)?;
    let known = [0.695, 0.481, 0.326, 0.226, 0.157, 0.107, 0.075, 0.054, 0.040, 0.029];
    contours(&mut figure, &run, &known);
    let centres: Vec<[f64; 2]> = run[1..].iter().map(Step::stick_centre).collect();
    let aside = centres.iter().map(|c| c[1].abs()).fold(0.0, f64::max);
    figure.at_most("it moves along x only", aside, 1e-9).source("symmetry");
    let ends = [(centres[0][0], 1.16), (centres[9][0], 4.96)];
    figure.all_close("its middle in steps 2 and 11", ends, Absolute(0.1)).source(INDEPENDENT);
    Ok(figure)
}

/// Force and moment over f F_z and f F_z sqrt(ab).
fn loads(way: Way) -> Result<Vec<[f64; 3]>, Failure> {
    let run = mesh().follow(&way.history())?;
    let root = f64::sqrt(AXES[0] * AXES[1]);
    Ok(run
        .iter()
        .map(|step| {
            let load = step.load;
            [load.f_x / load.f_z, load.f_y / load.f_z, load.m_z / (load.f_z * root)]
        })
        .collect())
}

pub(super) fn torques() -> FigureResult {
    let (mut figure, _) = start(Way::X)?;
    figure.stated("increments of the other", "Δη = 0.02, Δβ = 0.2°");
    let mut panel = Panel::new("step", "M_z/(f F_z √(ab))");
    // The greatest moment and the step it comes in, that of step 11, and (14.3)'s.
    let known = [(Way::X, 0.862, 5.0, 0.772, 0.758), (Way::Y, 0.776, 4.0, 0.676, 0.559)];
    for (way, top, top_step, end, rigid) in known {
        let moments: Vec<f64> = loads(way)?.iter().map(|load| load[2].abs()).collect();
        let points = moments.iter().enumerate().map(|(i, m)| ((i + 1) as f64, *m));
        panel.add(Series::line(format!("with {}", way.name()), points));
        panel.add(Series::dashed(format!("(14.3), {}", way.name()), [(1.0, rigid), (11.0, rigid)]));
        let (at, most) = moments
            .iter()
            .enumerate()
            .max_by(|a, b| a.1.total_cmp(b.1))
            .map_or((0.0, 0.0), |(i, m)| ((i + 1) as f64, *m));
        let pairs = [(most, top), (moments[10], end)];
        figure
            .all_close(
                format!("with {}: the greatest moment, and the last", way.name()),
                pairs,
                Absolute(0.003),
            )
            .source(INDEPENDENT);
        figure
            .close(
                format!("with {}: the step of the greatest", way.name()),
                at,
                top_step,
                Absolute(0.0),
            )
            .source(INDEPENDENT);
        let last = way.history()[10];
        let pole = [last.eta / last.omega, -last.xi / last.omega];
        let sliding = spin_about(&mesh().ellipse()?, pole[0], pole[1])?.torque.abs();
        figure
            .close(format!("(14.3) with {}", way.name()), sliding, rigid, Absolute(1e-3))
            .source("an independent evaluation of (14.3)");
    }
    figure.panel(panel);
    Ok(figure)
}

pub(super) fn forces() -> FigureResult {
    let (mut figure, _) = start(Way::X)?;
    figure.stated("increments of the other", "Δη = 0.02, Δβ = 0.2°");
    let mut panel = Panel::new("step", "F/(f F_z)");
    let (x, y) = (loads(Way::X)?, loads(Way::Y)?);
    for (name, values, axis) in [("F_x, with ξ", &x, 0), ("F_y, with η", &y, 1)] {
        let points = values.iter().enumerate().map(|(i, load)| ((i + 1) as f64, load[axis].abs()));
        panel.add(Series::line(name, points));
    }
    figure.panel(panel);
    let across = x.iter().map(|l| l[1].abs()).chain(y.iter().map(|l| l[0].abs()));
    figure
        .at_most("no force across the shift", across.fold(0.0, f64::max), 1e-8)
        .source("symmetry");
    figure.close("F_x in step 11", x[10][0].abs(), 0.8207, Absolute(0.002)).source(INDEPENDENT);
    let grows: Vec<f64> = x.iter().map(|load| load[0].abs()).collect();
    figure
        .increasing("the force grows while the moment passes its greatest", grows)
        .source("section 14.4");
    let bound = x.iter().chain(&y).map(|l| l[0].hypot(l[1])).fold(0.0, f64::max);
    figure.at_most("never beyond f F_z", bound, 1.0).source("Coulomb's law");
    Ok(figure)
}
