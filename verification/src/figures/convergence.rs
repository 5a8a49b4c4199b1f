//! Rates of convergence, measured and predicted: not in the thesis, but about its chapter 13.

use crate::catalogue::Entry;
use crate::{Cell, Failure, Figure, FigureResult, Panel, Relative, Series, Table, linspace};
use carom_classic::jaeger::{GaussSeidel, Most, ProgramStep, SlipStress};
use carom_classic::kalker::{Panagiotopoulos, ProcessStep};
use carom_classic::theory::{Bounds, ContactArea};
use carom_halfspace::operator::HalfSpaceOperator;
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{ContactProblem, ContactState, Drive, Gap, Method as _};

/// The page.
pub(super) const ENTRIES: &[Entry] =
    &[Entry::check("convergence", "Rates, measured and predicted").slowly_by(draw)];

/// A shift beyond which the whole contact slides along x.
const FAR: f64 = 1e6;
/// Friction for the sweeps; a larger one for the alternations, which otherwise end before their rate can be
/// measured.
const FRICTION: f64 = 0.8;
const STRONG: f64 = 2.0;

/// A flat punch, tilted so that it has no symmetry.
struct Punch {
    problem: ContactProblem,
    area: ContactArea,
    pair: MaterialPair,
}

fn punch([nx, ny]: [usize; 2], poisson: [f64; 2], friction: f64) -> Result<Punch, Failure> {
    let grid = Grid::new(nx, ny, 2.0 / nx as f64, 2.0 / nx as f64)?;
    // Square cells approximate a circle, other regions are filled.
    let inside = move |x: f64, y: f64| nx != ny || x.hypot(y) < 1.0;
    let height = |x, y| if inside(x, y) { 0.1 * x + 0.07 * y } else { f64::INFINITY };
    let gap = Gap::from_function(grid, height)?;
    let body = |poisson| Material::from_shear(1.0, poisson);
    let pair = MaterialPair::new(body(poisson[0])?, body(poisson[1])?)?;
    let operator = HalfSpaceOperator::new(pair, grid)?;
    let area = ContactArea::new(&operator, &Field::from_function(grid, inside))?;
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(friction)?)?;
    Ok(Punch { problem, area, pair })
}

/// The final ratio of successive values, over an even number of the last ones above rounding.
fn rate(amounts: &[f64]) -> f64 {
    let usable = amounts.iter().take_while(|amount| **amount > 1e-12).count();
    let last = usable.saturating_sub(1);
    let span = 2 * (usable / 5).max(1);
    if span > last {
        f64::NAN
    } else {
        (amounts[last] / amounts[last - span]).powf(1.0 / span as f64)
    }
}

fn sweeps(punch: &Punch, path: &[[f64; 2]], slip_stress: SlipStress) -> Result<f64, Failure> {
    let most = Most { seidel: 20_000, ..Most::default() };
    let method = GaussSeidel::default().within(1e-11)?.at_most(most).with_slip_stress(slip_stress);
    let mut scratch = method.scratch(&punch.problem)?;
    let mut state = ContactState::apart(punch.problem.grid());
    for [zeta, xi] in path.iter().copied() {
        let before = state.clone();
        let drive = Drive::by_shift(Shift { zeta, xi, ..Shift::default() });
        method.step(&punch.problem, &before, &drive, &mut state, &mut scratch, &mut ())?;
    }
    let first =
        scratch.trace().entries().iter().take_while(|entry| {
            matches!(entry.step, ProgramStep::Sweep | ProgramStep::StressesStand)
        });
    let sweeps = first.filter(|entry| entry.step == ProgramStep::Sweep);
    Ok(rate(&sweeps.map(|entry| entry.amount).collect::<Vec<_>>()))
}

fn passes(punch: &Punch, xi: f64) -> Result<f64, Failure> {
    let method = Panagiotopoulos::default().within(1e-13)?;
    let mut scratch = method.scratch(&punch.problem)?;
    let apart = ContactState::apart(punch.problem.grid());
    let drive = Drive::by_shift(Shift { zeta: 1.0, xi, ..Shift::default() });
    let mut state = apart.clone();
    // Alternations are iterated down to rounding, where they may not end within the tolerance.
    let _ = method.step(&punch.problem, &apart, &drive, &mut state, &mut scratch, &mut ());
    let entries = scratch.traces().process.entries().iter();
    let norms = entries.filter(|entry| entry.step == ProcessStep::Norm).skip(1);
    Ok(rate(&norms.map(|entry| entry.amount).collect::<Vec<_>>()))
}

/// A measured rate, its prediction and the bound on it, if there is one.
struct Rate {
    method: &'static str,
    area: String,
    gamma: f64,
    measured: f64,
    predicted: f64,
    bound: Option<f64>,
}

const STICKS: &[[f64; 2]] = &[[1.0, 0.0]];
/// It slides from the second step on; the last step presses harder, so that pressures change.
const SLIDES: &[[f64; 2]] = &[[1.0, 0.0], [1.0, 4.0], [1.5, FAR]];

/// γ = 1/3, −1/3 and 0.
const MATERIALS: [[f64; 2]; 3] = [[0.0, 0.5], [0.5, 0.0], [0.3, 0.3]];

fn rates() -> Result<Vec<Rate>, Failure> {
    let mut rates = Vec::new();
    for poisson in MATERIALS {
        // For cells in a line the error decreases so fast that too few sweeps are left to measure.
        for cells in [[12, 4], [20, 3], [14, 14], [18, 18]] {
            rates.extend(rates_of_sweeps(cells, poisson)?);
        }
        // Similar bodies need one alternation.
        if poisson[0] != poisson[1] {
            for cells in [[8, 8], [12, 12], [16, 16]] {
                rates.extend(rates_of_passes(cells, poisson)?);
            }
        }
    }
    Ok(rates)
}

fn named(cells: [usize; 2], elements: usize) -> String {
    let area = match cells {
        [nx, ny] if nx == ny => "circle",
        _ => "rectangle",
    };
    format!("{area}, {elements}")
}

fn rates_of_sweeps(cells: [usize; 2], poisson: [f64; 2]) -> Result<Vec<Rate>, Failure> {
    let claims_that_hold = punch(cells, poisson, f64::INFINITY)?;
    let slid = punch(cells, poisson, FRICTION)?;
    let rate = |method, measured, predicted| {
        let (area, gamma) =
            (named(cells, claims_that_hold.area.elements()), claims_that_hold.pair.gamma());
        Rate { method, area, gamma, measured, predicted, bound: None }
    };
    let (after, at_once) = (SlipStress::AfterSweep, SlipStress::AtOnce);
    let sticking = claims_that_hold.area.adhesion_sweep()?.radius();
    let mut rates = vec![rate("sweep, stick", sweeps(&claims_that_hold, STICKS, after)?, sticking)];
    for (method, follows) in [("sweep, slip", after), ("sweep, slip at once", at_once)] {
        let predicted = slid.area.sliding_sweep(FRICTION, follows)?.radius();
        rates.push(rate(method, sweeps(&slid, SLIDES, follows)?, predicted));
    }
    Ok(rates)
}

fn rates_of_passes(cells: [usize; 2], poisson: [f64; 2]) -> Result<Vec<Rate>, Failure> {
    let claims_that_hold = punch(cells, poisson, f64::INFINITY)?;
    let slid = punch(cells, poisson, STRONG)?;
    let bounds = Bounds::of(&claims_that_hold.pair);
    let rate = |method, measured, predicted, bound| {
        let (area, gamma) =
            (named(cells, claims_that_hold.area.elements()), claims_that_hold.pair.gamma());
        Rate { method, area, gamma, measured, predicted, bound: Some(bound) }
    };
    let (stick, slip) = (claims_that_hold.area.adhesion_pass()?, slid.area.sliding_pass(STRONG)?);
    Ok(vec![
        rate(
            "pass, stick",
            passes(&claims_that_hold, 0.0)?,
            stick.radius(),
            bounds.adhesion_pass(),
        ),
        rate("pass, slip", passes(&slid, FAR)?, slip.radius(), bounds.sliding_pass(STRONG)),
    ])
}

/// Spectral radius of a sweep in full slip against f gamma.
fn limits(panel: &mut Panel, cells: [usize; 2], label: &str) -> Result<Vec<(f64, f64)>, Failure> {
    let Punch { area, pair, .. } = punch(cells, [0.0, 0.5], 1.0)?;
    let curve: Result<Vec<_>, Failure> = linspace(-1.5, 2.5, 41)
        .into_iter()
        .map(|product| {
            let spectrum = area.sliding_sweep(product / pair.gamma(), SlipStress::AfterSweep)?;
            Ok((product, spectrum.radius()))
        })
        .collect();
    let curve = curve?;
    panel.add(Series::line(label, curve.clone()));
    Ok(curve)
}

fn draw() -> FigureResult {
    let mut figure = Figure::new();
    figure.snapshot_digits(4);
    figure.assumed(
        "contact areas",
        "flat punches, slightly tilted; γ = ±1/3 (ν = 0 and 1/2) and 0 (ν = 0.3)",
    );
    figure.assumed("f", "0.8 in sweeps; 2 in passes, where slower ones can be measured");
    let rates = rates()?;
    let heads = ["method", "area, elements", "γ", "measured", "predicted", "bound"];
    let mut table = Table::new("Factor by which the error falls", heads);
    for rate in &rates {
        let bound = rate.bound.map_or(Cell::from(""), Cell::from);
        let words = [Cell::from(rate.method), Cell::from(rate.area.clone())];
        // Measured on the last differences above rounding.
        let measured = Cell::Remark(format!("{:.4}", rate.measured));
        let cells = [Cell::from(rate.gamma), measured, Cell::from(rate.predicted), bound];
        table.row(words.into_iter().chain(cells));
    }
    figure.table(table);
    let pairs = rates.iter().map(|rate| (rate.measured, rate.predicted));
    figure
        .all_close("measured rates", pairs, Relative(0.05))
        .source("spectral radii of T (13.12) and of Gauss-Seidel, M₁ (13.32), M₂ (13.34)");
    let used = rates.iter().filter_map(|rate| Some(rate.predicted / rate.bound?));
    figure
        .at_most("predicted passes over f|γ| (slip) and γ² (stick)", used.fold(0.0, f64::max), 1.0)
        .source("symbols of A₁₁, A₃₃ and A₃₁ on the half-space");

    let mut panel = Panel::new("f γ", "spectral radius of T (13.12)").titled("Sweeps in full slip");
    let line = limits(&mut panel, [20, 1], "a line of 20")?;
    let circle = limits(&mut panel, [20, 20], "a circle of 316")?;
    panel.add(Series::dotted("", [(-1.5, 1.0), (2.5, 1.0)]));
    figure.panel(panel);
    let widest = |curve: &[(f64, f64)]| {
        let holds = curve.iter().filter(|(_, radius)| *radius < 1.0).map(|(product, _)| *product);
        (holds.clone().fold(f64::INFINITY, f64::min), holds.fold(f64::NEG_INFINITY, f64::max))
    };
    figure
        .at_least("a line converges beyond f γ = 1", widest(&line).1, 2.0)
        .source("(13.22) gives 1, for coefficients as simple as (13.17)");
    figure
        .at_most("a circle does not reach f γ = 1", widest(&circle).1, 0.95)
        .source("(13.22) used for other areas, as the text does");
    let at_half = |curve: &[(f64, f64)]| {
        let near = |point: &&(f64, f64)| (point.0 - 0.5).abs() < 1e-9;
        curve.iter().find(near).map_or(f64::NAN, |point| point.1)
    };
    figure
        .at_least("f γ = 1/2: circle slower than line by", at_half(&circle) / at_half(&line), 1.5)
        .source("the text expects several lines to converge better");
    let within = widest(&circle);
    figure
        .holds(
            "all that friction has, |f γ| ≤ 1/2, converges",
            within.0 <= -0.5 && within.1 >= 0.5,
            within.0,
        )
        .source("f ≤ 1, |γ| ≤ 1/2");
    figure.deviation(
        "0 < f γ < 1 is sufficient, and more lines converge better",
        "a line: −1.27 to 2.28; a circle of 316 elements: −0.61 to 0.71",
        "(13.17) holds for one line of very small elements only",
    );
    figure.deviation(
        "empirical limit |f γ| of 5 to 10 for circles",
        "about 1 to 3 with slip stresses that follow at once, less else",
        "not reproduced",
    );
    figure.deviation(
        "(13.42) M₂ = −f √(ε₁ M₁)",
        "M₂² = −f² ε₁ M₁: imaginary eigenvalues ± i f √(ε₁ λ₁)",
        "M₁ is the negative square of a skew matrix",
    );
    Ok(figure)
}
