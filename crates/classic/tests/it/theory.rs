//! Predicted rates of convergence compared with those observed.

use carom_classic::jaeger::{GaussSeidel, Most, ProgramStep, SlipStress};
use carom_classic::kalker::{Panagiotopoulos, ProcessStep};
use carom_classic::theory::{Bounds, ContactArea, TheoryError};
use carom_halfspace::operator::HalfSpaceOperator;
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{ContactProblem, ContactState, Drive, Gap, Method as _};

/// A flat punch of this outline.
struct Punch {
    problem: ContactProblem,
    area: ContactArea,
    pair: MaterialPair,
}

fn punch([nx, ny]: [usize; 2], round: bool, poisson: [f64; 2], friction: f64) -> Punch {
    let grid = Grid::new(nx, ny, 2.0 / nx as f64, 2.0 / nx as f64).unwrap();
    let inside = move |x: f64, y: f64| !round || x.hypot(y) < 1.0;
    // Tilted, so that what is left has no symmetry by which it would miss an eigenvector.
    let height = |x, y| if inside(x, y) { 0.1 * x + 0.07 * y } else { f64::INFINITY };
    let gap = Gap::from_function(grid, height).unwrap();
    let [one, two] = poisson.map(|nu| Material::from_shear(1.0, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    let operator = HalfSpaceOperator::new(pair, grid).unwrap();
    let area = ContactArea::new(&operator, &Field::from_function(grid, inside)).unwrap();
    let friction = Friction::new(friction).unwrap();
    Punch { problem: ContactProblem::of_half_spaces(gap, pair, friction).unwrap(), area, pair }
}

/// The factor by which amounts fall in the end, over an even number of the last ones above rounding.
fn rate(amounts: &[f64]) -> f64 {
    let usable = amounts.iter().take_while(|amount| **amount > 1e-12).count();
    let last = usable - 1;
    let first = last - 2 * (usable / 5).max(1);
    (amounts[last] / amounts[first]).powf(1.0 / (last - first) as f64)
}

fn sweeps(problem: &ContactProblem, slides: bool, slip_stress: SlipStress) -> Vec<f64> {
    let most = Most { seidel: 20_000, ..Most::default() };
    let method =
        GaussSeidel::default().within(1e-11).unwrap().at_most(most).with_slip_stress(slip_stress);
    let mut scratch = method.scratch(problem).unwrap();
    let mut state = ContactState::apart(problem.grid());
    // It slides from the second step on; the last one presses harder, so that pressures change.
    let path: &[[f64; 2]] =
        if slides { &[[1.0, 0.0], [1.0, 4.0], [1.5, FAR]] } else { &[[1.0, 0.0]] };
    for [zeta, xi] in path.iter().copied() {
        let before = state.clone();
        let drive = Drive::by_shift(Shift { zeta, xi, ..Shift::default() });
        // It may not end within the tolerance: the sweeps are what is asked for.
        let _ = method.step(problem, &before, &drive, &mut state, &mut scratch, &mut ());
    }
    let entries = scratch.trace().entries();
    let runs = entries
        .split(|entry| !matches!(entry.step, ProgramStep::Sweep | ProgramStep::StressesStand));
    let sweep = |run: &[carom_classic::Entry<ProgramStep>]| -> Vec<f64> {
        let sweeps = run.iter().filter(|entry| entry.step == ProgramStep::Sweep);
        sweeps.map(|entry| entry.amount).collect()
    };
    let runs: Vec<Vec<f64>> = runs.map(sweep).filter(|run| run.len() > 8).collect();
    runs[0].clone()
}

fn passes(problem: &ContactProblem, xi: f64) -> Vec<f64> {
    let method = Panagiotopoulos::default().within(1e-13).unwrap();
    let mut scratch = method.scratch(problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let drive = Drive::by_shift(Shift { zeta: 1.0, xi, ..Shift::default() });
    let mut state = apart.clone();
    let _ = method.step(problem, &apart, &drive, &mut state, &mut scratch, &mut ());
    let entries = scratch.traces().process.entries();
    let norms = entries.iter().filter(|entry| entry.step == ProcessStep::Norm);
    norms.skip(1).map(|entry| entry.amount).collect()
}

const FAR: f64 = 1e6;
/// f |gamma| = 2/3: more than friction has, so that errors fall slowly enough to be measured.
const STRONG: f64 = 2.0;

#[test]
fn sweeps_fall_as_their_spectral_radius_says() {
    for (cells, round) in [([12, 4], false), ([14, 14], true)] {
        for poisson in [[0.0, 0.5], [0.5, 0.0], [0.3, 0.3]] {
            let Punch { problem, area, .. } = punch(cells, round, poisson, f64::INFINITY);
            let (want, got) = (
                area.adhesion_sweep().unwrap().radius(),
                rate(&sweeps(&problem, false, SlipStress::AfterSweep)),
            );
            println!("adhesion {cells:?} {poisson:?}: {got:.4} {want:.4}");
            assert!((got / want - 1.0).abs() < 0.05);
            let Punch { problem, area, .. } = punch(cells, round, poisson, 0.8);
            for slip_stress in [SlipStress::AfterSweep, SlipStress::AtOnce] {
                let want = area.sliding_sweep(0.8, slip_stress).unwrap().radius();
                let got = rate(&sweeps(&problem, true, slip_stress));
                println!("sliding {slip_stress:?} {cells:?} {poisson:?}: {got:.4} {want:.4}");
                assert!((got / want - 1.0).abs() < 0.05);
            }
        }
    }
}

#[test]
fn passes_fall_as_their_spectral_radius_says() {
    for (cells, round) in [([8, 8], true), ([12, 12], true)] {
        for poisson in [[0.0, 0.5], [0.5, 0.0]] {
            let Punch { problem, area, pair } = punch(cells, round, poisson, f64::INFINITY);
            let bounds = Bounds::of(&pair);
            let (want, got) =
                (area.adhesion_pass().unwrap().radius(), rate(&passes(&problem, 0.0)));
            println!(
                "adhesion {cells:?} {poisson:?}: {got:.4} {want:.4} {:.4}",
                bounds.adhesion_pass()
            );
            assert!((got / want - 1.0).abs() < 0.05 && want < bounds.adhesion_pass());
            let Punch { problem, area, .. } = punch(cells, round, poisson, STRONG);
            let (want, got) =
                (area.sliding_pass(STRONG).unwrap().radius(), rate(&passes(&problem, FAR)));
            println!(
                "sliding {cells:?} {poisson:?}: {got:.4} {want:.4} {:.4}",
                bounds.sliding_pass(STRONG)
            );
            assert!((got / want - 1.0).abs() < 0.05 && want < bounds.sliding_pass(STRONG));
            assert!(want < bounds.sliding_pass_printed(STRONG));
        }
    }
}

#[test]
fn the_limit_of_13_22_fails_both_ways() {
    // One line converges far beyond f gamma = 1 and for negative values; a circle stops before 1.
    let radius = |cells, round, product: f64| {
        let Punch { area, pair, .. } = punch(cells, round, [0.0, 0.5], 1.0);
        area.sliding_sweep(product / pair.gamma(), SlipStress::AfterSweep).unwrap().radius()
    };
    assert!(radius([10, 1], false, 2.31) < 1.0 && radius([10, 1], false, 2.33) > 1.0);
    assert!(radius([10, 1], false, -1.30) < 1.0 && radius([10, 1], false, -1.32) > 1.0);
    assert!(radius([20, 20], true, 0.70) < 1.0 && radius([20, 20], true, 0.73) > 1.0);
    assert!(radius([20, 20], true, -0.60) < 1.0 && radius([20, 20], true, -0.63) > 1.0);
    // So the printed limit refuses sweeps of a line that converge, and lets those of a circle that do not.
    let Punch { pair, .. } = punch([10, 1], false, [0.0, 0.5], 1.0);
    let printed = |product: f64| Bounds::of(&pair).sweeps_converge(product / pair.gamma());
    assert!(!printed(2.31) && !printed(-1.30) && !printed(-0.60));
    assert!(printed(0.73) && printed(0.99) && !printed(1.01) && !printed(0.0));
}

#[test]
fn blocks_of_a_line_fall_as_passes_along_it() {
    // Without displacements across, (13.25) of three blocks is M1 (13.32) of two.
    for cells in [[10, 1], [25, 1]] {
        for poisson in [[0.0, 0.5], [0.5, 0.0], [0.1, 0.4]] {
            let Punch { area, pair, .. } = punch(cells, false, poisson, 1.0);
            let blocks = area.adhesion_blocks().unwrap().radius();
            let passes = area.adhesion_pass_along_x().unwrap().radius();
            assert!((blocks - passes).abs() < 1e-12, "{poisson:?}: {blocks} {passes}");
            assert!(blocks < Bounds::of(&pair).adhesion_pass());
        }
    }
    // In an area tractions along y join in: slower than along x alone.
    let Punch { area, .. } = punch([10, 10], true, [0.0, 0.5], 1.0);
    let blocks = area.adhesion_blocks().unwrap().radius();
    assert!(blocks > area.adhesion_pass_along_x().unwrap().radius() && blocks < 1.0, "{blocks}");
}

#[test]
fn areas_without_elements_and_wrong_frictions_are_named() {
    let grid = Grid::new(4, 4, 1.0, 1.0).unwrap();
    let body = Material::from_shear(1.0, 0.3).unwrap();
    let operator = HalfSpaceOperator::new(MaterialPair::new(body, body).unwrap(), grid).unwrap();
    let none = ContactArea::new(&operator, &Field::uniform(grid, false)).unwrap_err();
    assert!(matches!(none, TheoryError::Range(error) if error.field == "elements"));
    let area = ContactArea::new(&operator, &Field::uniform(grid, true)).unwrap();
    let error = area.sliding_pass(f64::NAN).unwrap_err();
    assert!(matches!(error, TheoryError::Range(error) if error.field == "friction"));
    assert_eq!(area.sliding_pass(1.0).unwrap().radius(), 0.0);
}
