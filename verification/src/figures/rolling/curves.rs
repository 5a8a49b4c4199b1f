//! Creep forces of a sphere, with and without spin, and those of FASTSIM beside them.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::{
    Absolute, Axis, Failure, Figure, FigureResult, Marker, Panel, Relative, Series, linspace,
};
use carom_halfspace::operator::{KernelOperator, TabulatedKernel, Threads};
use carom_halfspace::{Coefficients, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{
    CreepCoefficients, Creepage, Fastsim, RollingContact, RollingDrive, SteadyRolling, Way,
    creep_coefficients, roll_steadily,
};
use carom_solver::{ContactProblem, ContactState, Driven, Gap};

const FRICTION: f64 = 0.3;
const POISSON: f64 = 0.25;
/// Elements across the diameter of the contact.
const ELEMENTS: usize = 20;
/// Creepage times G a b C11/(f F_z), or the same across; spin times G (ab)^1.5 C23/(f F_z).
const PARTS: [f64; 9] = [0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.5];

/// A sphere of radius 1 and a contact of radius 1: lengths in its units, G = 1 of each body.
fn problem(elements: usize) -> Result<ContactProblem, Failure> {
    let width = 2.2 / elements as f64;
    let grid = Grid::new(elements + 2, elements, width, width)?;
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
    let body = Material::from_shear(1.0, POISSON)?;
    let pair = MaterialPair::new(body, body)?;
    Ok(ContactProblem::of_half_spaces(gap, pair, Friction::new(FRICTION)?)?)
}

fn roll(problem: &ContactProblem, creepage: Creepage) -> Result<SteadyRolling, Failure> {
    Ok(roll_steadily(problem, Driven::Shift(1.0), problem.grid().dx(), creepage)?)
}

/// Forces over f F_z of the solver and of FASTSIM.
struct Curve {
    solver: Vec<[f64; 2]>,
    springs: Vec<[f64; 2]>,
    slides: bool,
}

fn curve(
    problem: &ContactProblem,
    coefficients: CreepCoefficients,
    creepages: impl IntoIterator<Item = Creepage>,
) -> Result<Curve, Failure> {
    let mut curve = Curve { solver: Vec::new(), springs: Vec::new(), slides: false };
    for creepage in creepages {
        let SteadyRolling { state, slides, .. } = roll(problem, creepage)?;
        let load = state.load();
        let limit = FRICTION * load.f_z;
        let fastsim = Fastsim {
            semi_axes: [1.0, 1.0],
            shear_modulus: 1.0,
            coefficients,
            force: load.f_z,
            friction: FRICTION,
            mesh: [60, 60],
        };
        let springs = fastsim.forces(creepage)?;
        curve.solver.push([load.f_x / limit, load.f_y / limit]);
        curve.springs.push([springs.f_x / limit, springs.f_y / limit]);
        curve.slides = slides;
    }
    Ok(curve)
}

fn draw_curve(
    panel: &mut Panel,
    label: &str,
    at: &[f64],
    curve: &Curve,
    [axis, colour]: [usize; 2],
) {
    let of = |values: &[[f64; 2]]| -> Vec<(f64, f64)> {
        at.iter().copied().zip(values.iter().map(|forces| forces[axis])).collect()
    };
    panel.add(Series::line(label, of(&curve.solver)).coloured(colour));
    panel.add(Series::dashed(format!("{label}, FASTSIM"), of(&curve.springs)).coloured(colour));
}

/// The largest difference between the forces of FASTSIM and of the solver.
fn springs_off(curves: &[&Curve]) -> f64 {
    let pairs = curves.iter().flat_map(|curve| curve.solver.iter().zip(&curve.springs));
    let off = pairs.map(|(solver, springs)| (solver[0] - springs[0]).hypot(solver[1] - springs[1]));
    off.fold(0.0, f64::max)
}

/// A small creepage or spin, as a fraction of that of complete sliding without partial slip.
const LITTLE: f64 = 0.005;

/// The forces at a small creepage, extrapolated from two meshes of first order.
fn start(creepage: Creepage) -> Result<[f64; 2], Failure> {
    let on = |elements: usize| -> Result<[f64; 2], Failure> {
        let load = roll(&problem(elements)?, creepage)?.state.load();
        Ok([load.f_x, load.f_y])
    };
    let (fine, coarse) = (on(ELEMENTS)?, on(ELEMENTS / 2)?);
    Ok([0, 1].map(|axis| 2.0 * fine[axis] - coarse[axis]))
}

/// The difference between rolling from rest after a long distance and steady rolling, over f F_z.
fn left_of_the_start(creepage: Creepage) -> Result<f64, Failure> {
    let problem = problem(10)?;
    let way = Way::new(problem.grid().dx())?;
    let mut contact = RollingContact::new(&problem, way)?.within(1e-11)?;
    let mut state = ContactState::apart(problem.grid());
    let drive = RollingDrive::by_creepage(Driven::Shift(1.0), creepage);
    for _ in 0..120 {
        let before = state.clone();
        contact.step(&drive, &before, &mut state, &mut ())?;
    }
    let (now, steady) = (state.load(), roll(&problem, creepage)?.state.load());
    let off = (now.f_x - steady.f_x).hypot(now.f_y - steady.f_y);
    Ok(off / (FRICTION * steady.f_z))
}

/// The force of rolling cylinders over f F_z at parts of the creepage of full sliding, with so many
/// elements across.
fn cylinders(elements: usize, parts: &[f64]) -> Result<Vec<f64>, Failure> {
    let width = 2.2 / elements as f64;
    let grid = Grid::new(elements, 1, width, 1.0)?;
    // The plane half-space: a logarithm, its zero far away; equal bodies of G = 1.
    let stiffness = 2.0 * (1.0 - POISSON) / PI;
    let integral = |x: f64| if x == 0.0 { 0.0 } else { x * (x.abs().ln() - 1.0) };
    let kernel = TabulatedKernel::from_function(grid, |columns, _| {
        let x = f64::from(columns) * width;
        let log = integral(x + 0.5 * width) - integral(x - 0.5 * width);
        let value = stiffness * (100.0_f64.ln() * width - log);
        Coefficients { rows: [[value, 0.0, 0.0], [0.0, value, 0.0], [0.0, 0.0, value]] }
    })?;
    let operator = Arc::new(KernelOperator::new(kernel, Threads::One)?);
    let gap = Gap::from_function(grid, |x, _| 0.5 * x * x)?;
    let problem = ContactProblem::new(gap, operator, Friction::new(FRICTION)?)?;
    // Semi-width and radius 1.
    let force = Driven::Load(0.25 * PI / (1.0 - POISSON));
    let at = |part: &f64| -> Result<f64, Failure> {
        let creepage = Creepage { along: FRICTION * part, ..Creepage::default() };
        let load = roll_steadily(&problem, force, width, creepage)?.state.load();
        Ok(load.f_x / (FRICTION * load.f_z))
    };
    parts.iter().map(at).collect()
}

/// Carter's force at a part of the creepage of full sliding.
fn carter(part: f64) -> f64 {
    1.0 - (1.0 - part).max(0.0).powi(2)
}

fn draw_cylinders(figure: &mut Figure) -> Result<(), Failure> {
    let parts = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.2];
    let [coarse, fine] = [cylinders(50, &parts)?, cylinders(200, &parts)?];
    let mut panel = Panel::new("ξ/ξ of full sliding", "F_x/(f F_z)").titled("Cylinders");
    panel.add(Series::line("Carter", linspace(0.0, 1.2, 61).into_iter().map(|x| (x, carter(x)))));
    for (label, marker, forces) in
        [("50 elements", Marker::Square, &coarse), ("200 elements", Marker::Circle, &fine)]
    {
        let points = parts.into_iter().zip(forces.iter().copied());
        panel.add(Series::markers(label, marker, points));
    }
    figure.panel(panel);
    let off = |forces: &[f64]| {
        let pairs = parts.iter().zip(forces);
        pairs.map(|(part, force)| (force - carter(*part)).abs()).fold(0.0, f64::max)
    };
    figure
        .at_most("cylinders: off Carter's force, 200 elements", off(&fine), 0.015)
        .source("Carter 1926: F_x = f F_z (1 − (1 − ξ/ξ_full)²)");
    figure
        .at_most("over that of 50 elements", off(&fine) / off(&coarse), 0.4)
        .source("first order in the width of an element: 1/4, but for the edges of the contact");
    Ok(())
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.assumed("contact", "sphere, equal bodies, ν = 0.25, f = 0.3, 20 elements across");
    let problem = problem(ELEMENTS)?;
    let coefficients = creep_coefficients(1.0, POISSON)?;
    // Hertz with G = 1 of each body: F_z = (8/3) G/(2 (1 - nu)) a^3/R.
    let force = 4.0 / (3.0 * (1.0 - POISSON));
    let unit = FRICTION * force;
    let along = |part: f64| part * unit / coefficients.c11;
    let across = |part: f64| part * unit / coefficients.c22;
    let spin = |part: f64| part * unit / coefficients.c23;
    let both = [PARTS.map(|part| -part), PARTS].concat();
    let mut both: Vec<f64> = both.into_iter().filter(|part| part.abs() < 2.5).collect();
    both.sort_by(f64::total_cmp);
    both.dedup();
    let turned =
        |part: f64, turn: f64| Creepage { along: 0.0, across: across(part), spin: spin(turn) };
    let pure = PARTS.map(|part| Creepage { along: along(part), ..Creepage::default() });
    let spun = PARTS.map(|part| Creepage { along: along(part), across: 0.0, spin: spin(1.0) });
    let spins = PARTS.map(|part| Creepage { spin: spin(part), ..Creepage::default() });
    let solve = |creepages: &[Creepage]| curve(&problem, coefficients, creepages.iter().copied());
    let [pure, spun, spins] = [solve(&pure)?, solve(&spun)?, solve(&spins)?];
    let turning = |turn: f64| -> Result<Curve, Failure> {
        solve(&both.iter().map(|part| turned(*part, turn)).collect::<Vec<_>>())
    };
    let [straight, turning, back] = [turning(0.0)?, turning(1.0)?, turning(-1.0)?];

    let x = Axis::linear("ξ G ab C₁₁/(f F_z)");
    let mut panel = Panel::new(x, "F_x/(f F_z)").titled("Creepage along");
    draw_curve(&mut panel, "no spin", &PARTS, &pure, [0, 0]);
    draw_curve(&mut panel, "spin 1", &PARTS, &spun, [0, 1]);
    figure.panel(panel);
    let x = Axis::linear("η G ab C₂₂/(f F_z)");
    let mut panel = Panel::new(x, "F_y/(f F_z)").titled("Creepage across");
    draw_curve(&mut panel, "no spin", &both, &straight, [1, 0]);
    draw_curve(&mut panel, "spin 1", &both, &turning, [1, 1]);
    draw_curve(&mut panel, "spin −1", &both, &back, [1, 2]);
    figure.panel(panel);
    let x = Axis::linear("φ G (ab)^1.5 C₂₃/(f F_z)");
    let mut panel = Panel::new(x, "F_y/(f F_z)").titled("Spin alone");
    draw_curve(&mut panel, "spin", &PARTS, &spins, [1, 2]);
    figure.panel(panel);

    draw_cylinders(&mut figure)?;

    let little = LITTLE * unit;
    let starts = [
        start(Creepage { along: along(LITTLE), ..Creepage::default() })?[0] / little,
        start(Creepage { across: across(LITTLE), ..Creepage::default() })?[1] / little,
        start(Creepage { spin: spin(LITTLE), ..Creepage::default() })?[1] / -little,
    ];
    figure
        .all_close("the curves start with C₁₁, C₂₂, −C₂₃", starts.map(|s| (s, 1.0)), Relative(0.03))
        .source("creep coefficients; extrapolated from 10 and 20 elements");
    let end = pure.solver[PARTS.len() - 1][0];
    figure.close("and end at full sliding", end, 1.0, Absolute(2e-3)).source("Coulomb's law");
    figure.holds("of which the solver says so", pure.slides, end).source("no element sticks");
    let forces = pure.solver.iter().map(|forces| forces[0]);
    figure.increasing("force grows with creepage", forces).source("one direction");
    let less = pure.solver.iter().zip(&spun.solver).skip(1);
    let less = less.map(|(pure, spun)| pure[0] - spun[0]).fold(f64::INFINITY, f64::min);
    figure.at_least("spin takes force away", less, 1e-4).source("friction is spent on the spin");
    let sizes = spins.solver.iter().map(|forces| -forces[1]).collect::<Vec<_>>();
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    figure
        .at_least("the force by spin has a maximum", largest - sizes[PARTS.len() - 1], 0.02)
        .source("large spin turns the slip about the middle, where forces cancel");
    let mirrored = turning.solver.iter().zip(back.solver.iter().rev());
    let mirrored = mirrored.flat_map(|(one, other)| [(one[0], other[0]), (one[1], -other[1])]);
    figure
        .all_close("the other spin mirrors the forces across", mirrored, Absolute(1e-8))
        .source("symmetry about the track");
    figure
        .at_most("FASTSIM is off by, over f F_z: along, no spin", springs_off(&[&pure]), 0.06)
        .source("the simplified theory is said to be good to about a tenth");
    figure.at_most("across, no spin", springs_off(&[&straight]), 0.06).source("the same");
    figure
        .at_most("along and across with spin", springs_off(&[&spun, &turning, &back]), 0.12)
        .source("the same");
    figure
        .at_most("by spin alone", springs_off(&[&spins]), 0.12)
        .source("the springs take too much force from spin");
    let more = spins.solver.iter().zip(&spins.springs).skip(1);
    let more = more.map(|(solver, springs)| solver[1] - springs[1]).fold(f64::INFINITY, f64::min);
    figure
        .at_least("springs take more force from spin than there is, by", more, 0.0)
        .source("the parabolic limit of friction, which falls more slowly towards the edge");
    let creepage = Creepage { along: along(0.8), across: along(0.3), spin: spin(0.5) };
    figure
        .at_most(
            "rolling on ends in steady rolling, over f F_z",
            left_of_the_start(creepage)?,
            1e-6,
        )
        .source("two methods: steps of the solver, and the steady equations at once");
    Ok(figure)
}
