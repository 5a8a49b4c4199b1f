//! CONTACT's example of dissimilar bodies that are pressed together in 35 steps.

use carom_halfspace::{Grid, Material, MaterialPair, Point};
use carom_laws::friction::Friction;
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method as _,
    StoredEnergy, Subsurface, dissipated,
};

use super::super::printed::{SOURCE, all_digits, off_cell, unit};
use crate::reference::rows;
use crate::{Absolute, Axis, Cell, Failure, Figure, FigureResult, Marker, Panel, Series, Table};

const CELLS: usize = 45;
const WIDTH: f64 = 0.2;
const CURVATURE: f64 = 0.004_116;
/// Where the middle of the cells is, along both axes, from the apex of the bodies.
const MIDDLE: f64 = 1e-4;
const FRICTION: f64 = 0.2986;
/// The depth of the line of stresses.
const DEPTH: f64 = 1e-6;
/// The example ends a step once tractions change by less than this part of their size.
const TOLERANCE: f64 = 5e-6;
/// Displacements and stresses below this are zero but for rounding, or of no matter.
const NOISE: f64 = 1e-8;

/// What the example prints of a step, in this order.
const NAMES: [&str; 4] = ["approach", "p_max", "elastic energy", "friction work"];

struct Step {
    force: f64,
    printed: [f64; 4],
    own: [f64; 4],
    state: ContactState,
}

/// Shear modulus and Poisson's ratio of body 1, and of body 2, which is as good as rigid.
fn bodies() -> Result<[Material; 2], Failure> {
    Ok([Material::from_shear(0.5, 0.0)?, Material::from_shear(1e5, 0.0)?])
}

fn problem() -> Result<ContactProblem, Failure> {
    let grid = Grid::new(CELLS, CELLS, WIDTH, WIDTH)?;
    let height = |x: f64, y: f64| CURVATURE * ((x + MIDDLE).powi(2) + (y + MIDDLE).powi(2));
    let [one, two] = bodies()?;
    let pair = MaterialPair::new(one, two)?;
    let gap = Gap::from_function(grid, height)?;
    Ok(ContactProblem::of_half_spaces(gap, pair, Friction::new(FRICTION)?)?)
}

fn follow() -> Result<Vec<Step>, Failure> {
    let (problem, method) = (problem()?, Frictional::default().within(1e-11)?);
    let mut scratch = method.scratch(&problem)?;
    let mut before = ContactState::apart(problem.grid());
    let mut steps = Vec::new();
    let table: Vec<[f64; 6]> = rows(include_str!("../../../data/solver/spence_steps.csv"))?;
    for [_, force, printed @ ..] in table {
        let drive = Drive { normal: Driven::Load(force), ..Drive::default() };
        let mut state = before.clone();
        method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ())?;
        let highest = state.pressure.values().iter().copied().fold(0.0, f64::max);
        let stored = StoredEnergy::of(&problem, &state)?.total();
        let heat: f64 = dissipated(&before, &state).values().iter().sum();
        // Energies are printed in J.
        let own = [state.shift.zeta, highest, 1e-3 * stored, 1e-3 * heat];
        before.clone_from(&state);
        steps.push(Step { force, printed, own, state });
    }
    Ok(steps)
}

impl Step {
    fn counts(&self) -> [f64; 2] {
        [CellState::Stick, CellState::Slip].map(|state| self.state.count(state) as f64)
    }

    /// The radius of the stick area over that of the contact.
    fn stick(&self) -> f64 {
        let [stick, slip] = self.counts();
        (stick / (stick + slip)).sqrt()
    }

    fn pairs(&self) -> [(f64, f64); 4] {
        [0, 1, 2, 3].map(|which| (self.own[which], self.printed[which]))
    }
}

fn table(steps: &[Step]) -> Table {
    let mut heads = vec!["step".to_owned(), "F_z".to_owned()];
    for name in NAMES {
        heads.extend([format!("{name} of CONTACT"), "of carom".to_owned(), "off".to_owned()]);
    }
    let mut table = Table::new("Number beside number; off in units of the 4th digit", heads);
    for (number, step) in (1_u32..).zip(steps) {
        let mut cells = vec![Cell::from(f64::from(number)), step.force.into()];
        for (own, printed) in step.pairs() {
            let off =
                if printed == 0.0 { Cell::Remark(String::new()) } else { off_cell(own, printed) };
            cells.extend([printed.into(), own.into(), off]);
        }
        table.row(cells);
    }
    table
}

/// What the example prints of body 1 just below the surface after the last step, in this order.
const BELOW: [&str; 6] = ["u", "w", "σ_xx", "σ_zx", "σ_yy", "σ_zz"];

/// A point there.
struct Line {
    x: f64,
    printed: [f64; 6],
    own: [f64; 6],
}

fn line(state: &ContactState) -> Result<Vec<Line>, Failure> {
    let below = Subsurface::of_body_1(state, bodies()?[0])?;
    let table: Vec<[f64; 7]> = rows(include_str!("../../../data/solver/spence_line.csv"))?;
    let compute = |[x, printed @ ..]: [f64; 7]| -> Result<Line, Failure> {
        let at = Point { x, y: 0.0, z: DEPTH };
        let (moved, stress) = (below.displacement(at)?, below.stress(at)?);
        let own = [moved.u, moved.w, stress.xx, stress.zx, stress.yy, stress.zz];
        Ok(Line { x, printed, own })
    };
    table.into_iter().map(compute).collect()
}

fn line_table(line: &[Line]) -> Table {
    let mut heads = vec!["x".to_owned()];
    for name in BELOW {
        heads.extend([format!("{name} of CONTACT"), "of carom".to_owned(), "off".to_owned()]);
    }
    let title = "Just below the surface, step 35; off in units of the 4th digit";
    let mut table = Table::new(title, heads);
    for point in line {
        let mut cells = vec![Cell::from(point.x)];
        for (own, printed) in point.own.into_iter().zip(point.printed) {
            let shown = if own.abs() < NOISE {
                Cell::Remark(format!("{own:.3e}"))
            } else {
                Cell::from(own)
            };
            cells.extend([printed.into(), shown, off_cell(own, printed)]);
        }
        table.row(cells);
    }
    table
}

fn map(step: &Step) -> Result<Panel, Failure> {
    let cells = &step.state.cells;
    let kinds = cells.values().iter().map(|cell| match cell {
        CellState::Stick => Some(0),
        CellState::Slip => Some(1),
        CellState::Exterior => None,
    });
    let along = |count: usize| (0..count).map(|i| cells.grid().centred_x(i)).collect::<Vec<_>>();
    let axes = [along(CELLS), along(CELLS)];
    let [x, y] = axes;
    let field = carom_plot::Field::of_kinds(["stick", "slip"], x, y, kinds.collect())?;
    Ok(Panel::new("x", "y").titled("After step 35").equal_aspect().over(field))
}

fn panels(steps: &[Step], line: &[Line]) -> Result<[Panel; 4], Failure> {
    let against_force = |value: &dyn Fn(&Step) -> f64| -> Vec<(f64, f64)> {
        steps.iter().map(|step| (step.force, value(step))).collect()
    };
    let mut approach = Panel::new(Axis::log("F_z"), Axis::log("ζ, p_max")).titled("35 steps");
    for (which, name) in ["ζ", "p_max"].into_iter().enumerate() {
        approach.add(Series::line(name, against_force(&|step| step.own[which])));
        let points = against_force(&|step| step.printed[which]);
        let label = if which == 0 { "CONTACT" } else { "" };
        approach.add(Series::markers(label, Marker::Circle, points).coloured(3));
    }
    let along = |value: &dyn Fn(&Line) -> f64| -> Vec<(f64, f64)> {
        line.iter().map(|point| (point.x, value(point))).collect()
    };
    let mut below = Panel::new("x", "stress").titled("Just below the surface, step 35");
    for (which, name) in [(2, "σ_xx"), (3, "σ_zx"), (4, "σ_yy"), (5, "σ_zz")] {
        below.add(Series::line(name, along(&|point| point.own[which])));
    }
    for which in 2..6 {
        let label = if which == 2 { "CONTACT" } else { "" };
        let points = along(&|point| point.printed[which]);
        below.add(Series::markers(label, Marker::Dot, points).sized(0.6).coloured(4));
    }
    let mut stick = Panel::new("step", "c/a").titled("Radius of the stick area");
    let ratios = (1_u32..).zip(steps).map(|(number, step)| (f64::from(number), step.stick()));
    stick.add(Series::line("by its cells", ratios));
    Ok([approach, map(&steps[steps.len() - 1])?, stick, below])
}

pub(super) fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.stated("bodies", "G = 0.5 and 100 000, ν = 0; f = 0.2986");
    figure.stated("gap", "0.004116 (x² + y²), the middle of the cells at x = y = 0.0001");
    figure.stated("cells", "45 × 45 of 0.2");
    figure.stated("tolerance of CONTACT", "5e-6 of the tractions");
    figure.stated("F_z", "(k/45)³ in step k = 1 to 35, to six decimals");
    let steps = follow()?;
    let last = &steps[steps.len() - 1];
    let line = line(&last.state)?;
    for panel in panels(&steps, &line)? {
        figure.panel(panel);
    }
    figure.table(table(&steps));
    for (which, name) in NAMES.into_iter().enumerate() {
        // In the first step nothing slips.
        let pairs = steps.iter().map(|step| step.pairs()[which]).filter(|pair| pair.1 != 0.0);
        all_digits(&mut figure, name, pairs).source(SOURCE);
    }
    let cells: Vec<[f64; 3]> = rows(include_str!("../../../data/solver/spence_cells.csv"))?;
    let cells = cells.into_iter().flat_map(|[step, stick, slip]| {
        let own = steps[step as usize - 1].counts();
        [(own[0], stick), (own[1], slip)]
    });
    figure
        .all_close("cells that stick and slip, steps 6, 18, 35", cells, Absolute(0.0))
        .source(SOURCE);
    figure.table(line_table(&line));
    let [approach, highest, ..] = last.own;
    for (which, name) in BELOW.into_iter().enumerate() {
        let scale = if which < 2 { approach } else { highest };
        let beyond = line.iter().map(|point| {
            let (own, printed) = (point.own[which], point.printed[which]);
            (own - printed).abs() - 0.5 * unit(printed)
        });
        let worst = beyond.reduce(f64::max).unwrap_or(f64::NAN).max(0.0);
        let statement = format!(
            "just below the surface: {name}: worst beyond half a unit of the fourth digit, over the \
             tolerance of the example"
        );
        figure.at_most(statement, worst / (TOLERANCE * scale), 1.0).source(SOURCE);
    }
    Ok(figure)
}
