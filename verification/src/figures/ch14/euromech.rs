//! Figs. 14.17 to 14.21: pressed, shifted along x, along y, and back on the same path.

use super::super::mesh::{APPROACH, Mesh, Step, Touching, steps};
use super::angle_axis;
use super::dissimilar::{law_angle, misfit};
use crate::{Absolute, Failure, Figure, FigureResult, Marker, Panel, Series};
use carom_laws::law::Shift;

const INDEPENDENT: &str = "an independent half-space program";
const AXES: [f64; 2] = [4.0, 1.0];
/// The last step of the history.
const LAST: usize = 30;
/// A growth of the stick area, over the contact area, that is more than a few elements.
const RESOLVED: f64 = 0.02;

fn mesh(friction: f64) -> Mesh {
    Mesh { poisson: [0.1, 0.3], friction, ..Mesh::of(AXES, [64, 16]) }
}

fn inputs(figure: &mut Figure) {
    figure.stated("ν₁, ν₂, a/b", "0.1, 0.3, 4");
    figure.stated("f", "1 (caption), 0.1 (text): both");
    figure.assumed("Δζ, Δξ, Δη", "0.01, 0.01 f, 0.01 f; steps 10, 5, 5, 5, 5");
    figure.assumed("elements", "64 × 16 (40 × 10 in the thesis)");
}

/// The thesis shows ten steps more than it describes.
fn end_of_path(figure: &mut Figure) {
    figure.deviation(
        "40 steps",
        "30 steps",
        "the thesis does not say what happens in steps 31 to 40: its text ends with step 30",
    );
}

fn history(friction: f64) -> Vec<Shift> {
    let way = 0.5 * APPROACH * friction;
    let at = |zeta, xi, eta| Shift { zeta, xi, eta, ..Shift::default() };
    let corners = [
        (at(0.0, 0.0, 0.0), at(APPROACH, 0.0, 0.0), 10),
        (at(APPROACH, 0.0, 0.0), at(APPROACH, way, 0.0), 5),
        (at(APPROACH, way, 0.0), at(APPROACH, way, way), 5),
        (at(APPROACH, way, way), at(APPROACH, 0.0, way), 5),
        (at(APPROACH, 0.0, way), at(APPROACH, 0.0, 0.0), 5),
    ];
    corners.into_iter().flat_map(|(from, to, count)| steps(from, to, count)).collect()
}

pub(super) fn path() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    end_of_path(&mut figure);
    let path = history(1.0);
    let mut panel = Panel::new("step", "ζ, ξ, η in mm");
    let by_step = |value: fn(&Shift) -> f64| -> Vec<(f64, f64)> {
        path.iter().enumerate().map(|(i, shift)| ((i + 1) as f64, value(shift))).collect()
    };
    panel.add(Series::line("ζ", by_step(|shift| shift.zeta)));
    panel.add(Series::line("ξ", by_step(|shift| shift.xi)));
    panel.add(Series::line("η", by_step(|shift| shift.eta)));
    figure.panel(panel);
    // Forces of the history; the last step does not restore them.
    let run = mesh(1.0).follow(&path)?;
    let force = |value: fn(&Step) -> f64| -> Vec<(f64, f64)> {
        run.iter().enumerate().map(|(i, step)| ((i + 1) as f64, value(step))).collect()
    };
    let mut forces = Panel::new("step", "F_x, F_y over f F_z");
    forces.add(Series::line("F_x", force(|step| step.load.f_x / step.load.f_z)));
    forces.add(Series::line("F_y", force(|step| step.load.f_y / step.load.f_z)));
    figure.panel(forces);
    let hertz = mesh(1.0).hertz()?.force(APPROACH);
    figure
        .close("F_z over Hertz's after step 10", run[9].load.f_z / hertz, 1.0034, Absolute(0.0005))
        .source(INDEPENDENT);
    figure
        .close("F_x after step 15", run[14].load.f_x, 17_387.3, Absolute(60.0))
        .source(INDEPENDENT);
    figure
        .at_least("back where it began a force is left", run[29].load.f_x.abs() / hertz, 0.01)
        .source("friction remembers");
    Ok(figure)
}

pub(super) fn stick_area() -> FigureResult {
    let mut figure = Figure::new();
    inputs(&mut figure);
    end_of_path(&mut figure);
    let mut panel = Panel::new("step", "part that sticks");
    let run = |friction: f64| -> Result<Vec<f64>, Failure> {
        Ok(mesh(friction).follow(&history(friction))?.iter().map(Step::stick).collect())
    };
    let (strong, weak) = (run(1.0)?, run(0.1)?);
    for (name, parts) in [("f = 1", &strong), ("f = 0.1", &weak)] {
        let points = parts.iter().enumerate().map(|(i, part)| ((i + 1) as f64, *part));
        panel.add(Series::line(name, points));
    }
    figure.panel(panel);
    let known: [(_, _, _, &[f64]); 2] = [
        ("f = 1", &strong, [0.359, 0.856, 0.582, 0.833], &[21.0, 26.0]),
        ("f = 0.1", &weak, [0.229, 0.806, 0.446, 0.832], &[16.0, 21.0, 26.0]),
    ];
    for (name, parts, values, turns) in known {
        let pairs = [20, 21, 25, 26].map(|step| parts[step - 1]).into_iter().zip(values);
        figure
            .all_close(
                format!("{name}: the parts before and after the turns of steps 21 and 26"),
                pairs,
                Absolute(0.025),
            )
            .source(INDEPENDENT);
        // The steps after pressing in which the stick area grows by more than the mesh resolves.
        let grows = |step: usize| parts[step - 1] > parts[step - 2] + RESOLVED;
        let steps: Vec<f64> = (12..=LAST).filter(|s| grows(*s)).map(|s| s as f64).collect();
        figure
            .close(
                format!("{name}: number of steps from 12 on in which the stick area grows"),
                steps.len() as f64,
                turns.len() as f64,
                Absolute(0.0),
            )
            .source(INDEPENDENT);
        figure
            .all_close(
                format!("{name}: these steps are {turns:?}, the first after a turn of the path"),
                steps.into_iter().zip(turns.iter().copied()),
                Absolute(0.0),
            )
            .source("points of instantaneous adhesion, chapter 7");
    }
    let pressed = strong[4..10].iter().copied().fold(f64::INFINITY, f64::min);
    figure
        .at_least("f = 1: pressed alone, nearly all sticks (steps 5 to 10)", pressed, 0.93)
        .source(INDEPENDENT);
    Ok(figure)
}

fn angles(numbers: &[usize], friction: f64) -> Result<(Figure, Vec<Step>), Failure> {
    let mut figure = Figure::new();
    inputs(&mut figure);
    let run = mesh(friction).follow(&history(friction))?;
    let mut panel = Panel::new("angle of (x/a, y/b) in degrees", angle_axis());
    let markers = [Marker::Cross, Marker::Square, Marker::Circle];
    for (number, marker) in numbers.iter().zip(markers) {
        let points = run[number - 1].touching().map(|cell: Touching| {
            (law_angle(&cell, AXES, 1.0).rem_euclid(360.0), cell.angle().rem_euclid(360.0))
        });
        panel.add(Series::markers(format!("step {number}"), marker, points));
    }
    let line = (0..=360).map(|degrees| {
        let angle = f64::from(degrees).to_radians();
        let law = (2.0 * angle.sin()).atan2(angle.cos()).to_degrees();
        // The sense of the traction on body 1 by the sign of gamma.
        (f64::from(degrees), law.rem_euclid(360.0))
    });
    panel.add(Series::line("(14.1)", line));
    figure.panel(panel);
    Ok((figure, run))
}

pub(super) fn pressing() -> FigureResult {
    let (mut figure, run) = angles(&[2, 3, 10], 0.1)?;
    let worst = [2, 3, 10].map(|n| misfit(&run[n - 1], AXES, 1.93)).into_iter().fold(0.0, f64::max);
    figure
        .at_most("while pressed the angle is (14.1)'s within degrees, root mean square", worst, 6.0)
        .source("the thesis, (14.1), in coordinates over the semi-axes");
    // All tractions point inwards or all outwards.
    let sign = |cell: &Touching| (cell.traction[0] * cell.x + cell.traction[1] * cell.y).signum();
    let sum: f64 = run[9].touching().map(|cell| sign(&cell)).sum();
    let count = run[9].touching().count() as f64;
    figure
        .close(
            "all tractions point the same way, in or out",
            sum.abs() / count,
            1.0,
            Absolute(0.01),
        )
        .source("symmetry of dissimilar bodies pressed together");
    Ok(figure)
}

pub(super) fn first_shift() -> FigureResult {
    let (mut figure, run) = angles(&[11, 15], 0.1)?;
    let mean = |number: usize| {
        let step = &run[number - 1];
        let f_z = step.load.f_z;
        (step.load.f_x / (0.1 * f_z), step.load.f_y / (0.1 * f_z))
    };
    figure
        .all_close("slip opposes the stress", run[14].cosines_to_slip(), Absolute(1e-6))
        .source("Coulomb's law");
    figure
        .increasing("the force along x grows", vec![mean(11).0, mean(13).0, mean(15).0])
        .source("the shift along x");
    figure.at_most("none along y", mean(15).1.abs(), 1e-8).source("symmetry");
    Ok(figure)
}

pub(super) fn way_back() -> FigureResult {
    let (mut figure, run) = angles(&[25], 0.1)?;
    let step = &run[24];
    let mut sizes = Panel::new("√(x²/a² + y²/b²)", "|t|/(f p)");
    let points = step.touching().map(|cell| {
        ((cell.x / AXES[0]).hypot(cell.y / AXES[1]), cell.size() / (0.1 * cell.pressure))
    });
    sizes.add(Series::markers("step 25", Marker::Dot, points.collect::<Vec<_>>()));
    figure.panel(sizes);
    figure.panel(step.stick_map("stick and slip in step 25")?);
    let stuck = step.touching().filter(|cell| cell.sticks);
    let within = stuck.map(|cell| cell.size() / (0.1 * cell.pressure)).fold(0.0, f64::max);
    figure
        .at_most("where it sticks the stress is within its limit", within, 1.0)
        .source("Coulomb's law");
    figure
        .close("part that sticks in step 25", step.stick(), 0.446, Absolute(0.025))
        .source(INDEPENDENT);
    Ok(figure)
}
