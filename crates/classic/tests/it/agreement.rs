//! All methods on the same meshes give the same solution.

use std::time::{Duration, Instant};

use carom_classic::jaeger::{DiscGaussSeidel, GaussSeidel, SlipStress};
use carom_classic::kalker::{Johnson, KOMBI, Kombi, Panagiotopoulos};
use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{ContactProblem, ContactState, Drive, Frictional, Gap, Method};

/// A history on a mesh.
struct Case<'a> {
    name: &'static str,
    cells: [usize; 2],
    poisson: [f64; 2],
    friction: f64,
    /// zeta, xi, eta, omega at the ends of the steps.
    history: &'a [[f64; 4]],
}

const SHIFTS: &[[f64; 4]] = &[
    [0.5, 0.0, 0.0, 0.0],
    [1.0, 0.05, 0.02, 0.0],
    [1.0, 0.2, 0.1, 0.0],
    [1.0, -0.1, 0.15, 0.0],
    [0.7, -0.3, 0.1, 0.0],
];
const TWISTS: &[[f64; 4]] =
    &[[1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.3], [1.0, 0.1, 0.0, 0.4], [0.9, 0.1, 0.0, -0.2]];
const SIMILAR: [f64; 2] = [0.3, 0.3];
/// gamma = 1/3 and -1/3.
const POSITIVE: [f64; 2] = [0.0, 0.5];
const NEGATIVE: [f64; 2] = [0.5, 0.0];

fn problem(case: &Case<'_>) -> ContactProblem {
    let [nx, ny] = case.cells;
    let grid = Grid::new(nx, ny, 2.3 / nx as f64, 2.5 / ny as f64).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * x * x + 0.4 * y * y).unwrap();
    let [one, two] = case.poisson.map(|nu| Material::from_shear(1.0, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    ContactProblem::of_half_spaces(gap, pair, Friction::new(case.friction).unwrap()).unwrap()
}

/// The states at the ends of all steps, and the time they took.
fn follow<M: Method>(
    problem: &ContactProblem,
    method: &M,
    history: &[[f64; 4]],
) -> Result<(Vec<ContactState>, Duration), M::Error> {
    let mut scratch = method.scratch(problem)?;
    let mut before = ContactState::apart(problem.grid());
    let start = Instant::now();
    let mut states = Vec::new();
    for [zeta, xi, eta, omega] in history.iter().copied() {
        let mut state = before.clone();
        let drive = Drive::by_shift(Shift { zeta, xi, eta, omega });
        method.step(problem, &before, &drive, &mut state, &mut scratch, &mut ())?;
        before.clone_from(&state);
        states.push(state);
    }
    Ok((states, start.elapsed()))
}

/// The largest difference of a traction or pressure, over the largest pressure.
fn difference(a: &[ContactState], b: &[ContactState]) -> f64 {
    let mut largest = 0.0_f64;
    for (a, b) in a.iter().zip(b) {
        let top = a.pressure.values().iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let fields = [
            (&a.pressure, &b.pressure),
            (&a.traction_x, &b.traction_x),
            (&a.traction_y, &b.traction_y),
        ];
        for (a, b) in fields {
            for (a, b) in a.values().iter().zip(b.values()) {
                assert!(a.is_finite() && b.is_finite());
                largest = largest.max((a - b).abs() / top);
            }
        }
    }
    largest
}

/// Histories on these grids, with alike and dissimilar bodies.
fn cases(grids: &[[usize; 2]]) -> Vec<Case<'static>> {
    let mut cases = Vec::new();
    for &cells in grids {
        for (name, history) in [("shift", SHIFTS), ("twist", TWISTS)] {
            for (poisson, friction) in
                [(SIMILAR, 0.3), (POSITIVE, 0.4), (NEGATIVE, 0.4), (POSITIVE, 1.0)]
            {
                cases.push(Case { name, cells, poisson, friction, history });
            }
        }
    }
    cases
}

/// The first steps of histories on finer grids.
fn finer() -> Vec<Case<'static>> {
    let of =
        |(name, poisson, cells, history)| Case { name, cells, poisson, friction: 0.3, history };
    [
        ("shift", SIMILAR, [24, 24], SHIFTS),
        ("shift", NEGATIVE, [18, 20], SHIFTS),
        ("twist", POSITIVE, [24, 24], &TWISTS[..2]),
    ]
    .map(of)
    .into()
}

/// Whether a method finds what another one found, to 1e-9 of the largest pressure; the time it took.
fn agrees<M: Method>(case: &Case<'_>, problem: &ContactProblem, method: &M, want: &[ContactState]) {
    let name = std::any::type_name::<M>().rsplit("::").next().unwrap_or_default();
    let Case { name: history, cells, poisson, friction, .. } = case;
    let place = format!("{name}: {history} {cells:?} nu {poisson:?} f {friction}");
    let (found, time) =
        follow(problem, method, case.history).unwrap_or_else(|error| panic!("{place}: {error}"));
    let difference = difference(want, &found);
    println!("{place}: {difference:.1e} in {time:.1?}");
    assert!(difference < 1e-9, "{place}: {difference:.1e}");
}

#[test]
fn all_methods_find_the_same() {
    all_agree(&cases(&[[8, 8]]));
}

#[test]
#[ignore = "takes half a minute"]
fn all_methods_find_the_same_on_finer_grids() {
    all_agree(&cases(&[[12, 10]]));
    all_agree(&finer());
}

fn all_agree(cases: &[Case<'_>]) {
    for case in cases {
        let problem = problem(case);
        let today = Frictional::default().within(1e-12).unwrap();
        let (want, time) = follow(&problem, &today, case.history).unwrap();
        println!("today in {time:.1?}");
        let gauss_seidel = GaussSeidel::default().within(1e-11).unwrap();
        agrees(case, &problem, &gauss_seidel, &want);
        if problem.grid().cells() < 200 {
            agrees(case, &problem, &gauss_seidel.over_relaxed(1.4).unwrap(), &want);
            agrees(case, &problem, &gauss_seidel.with_slip_stress(SlipStress::AtOnce), &want);
            agrees(case, &problem, &gauss_seidel.in_blocks_of(10), &want);
        }
        agrees(case, &problem, &DiscGaussSeidel::default(), &want);
        agrees(case, &problem, &Panagiotopoulos::default().within(1e-11).unwrap(), &want);
        if !problem.operator().is_coupled() {
            agrees(case, &problem, &Johnson::default(), &want);
        }
        if problem.grid().cells() < 200 {
            agrees(case, &problem, &Kombi::default(), &want);
        }
    }
}

/// Steps in any direction, with repeats, reversals and parting, each drawn.
fn drawn(chance: &mut Congruential) -> Vec<[f64; 4]> {
    let mut at = [0.8, 0.0, 0.0, 0.0];
    let mut history = vec![at];
    for _ in 0..5 {
        let size = chance.pick(&[0.0, 1e-6, 0.05, 0.3]);
        match chance.pick(&[0, 1, 2, 3]) {
            0 => at[0] = chance.pick(&[0.3, 0.8, 1.0, 1.1, -0.1]),
            1 => at = history[chance.below(history.len())],
            2 => at = [at[0], at[1] + size, at[2] - size, at[3]],
            _ => {
                at = at.map(|value| value + size * (chance.part() - 0.5));
                at[0] = at[0].clamp(0.2, 1.1);
            }
        }
        history.push(at);
    }
    history
}

fn random_histories(seed: u64, count: usize) {
    let mut chance = Congruential(seed);
    for number in 0..count {
        let poisson = chance.pick(&[SIMILAR, POSITIVE, NEGATIVE, [0.2, 0.35]]);
        let friction = chance.pick(&[0.05, 0.3, 0.7]);
        let cells = chance.pick(&[[8, 8], [9, 7], [6, 11]]);
        let history = drawn(&mut chance);
        let case = Case { name: "drawn", cells, poisson, friction, history: &history };
        println!("{seed} {number}: {history:?}");
        let problem = problem(&case);
        let today = Frictional::default().within(1e-12).unwrap();
        let (want, _) = follow(&problem, &today, case.history).unwrap();
        agrees(&case, &problem, &GaussSeidel::default().within(1e-11).unwrap(), &want);
        agrees(&case, &problem, &DiscGaussSeidel::default(), &want);
        agrees(&case, &problem, &Panagiotopoulos::default().within(1e-11).unwrap(), &want);
        agrees(&case, &problem, &Kombi::default(), &want);
        if !problem.operator().is_coupled() {
            agrees(&case, &problem, &Johnson::default(), &want);
        }
    }
}

#[test]
fn all_methods_find_the_same_in_drawn_histories() {
    random_histories(1, 40);
}

/// One linear system for each area that is tried: with exact directions for each there were 45, 100 and 15
/// systems, the first ones for all cells that overlap.
#[test]
fn kombi_solves_few_linear_systems() {
    let grid = Grid::new(24, 24, 2.6 / 24.0, 2.6 / 24.0).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
    let [one, two] = [0.0, 0.5].map(|nu| Material::from_shear(1.0, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.2).unwrap()).unwrap();
    let method = Kombi::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let mut state = ContactState::apart(grid);
    for (xi, most) in [(0.0, 16), (0.05, 14), (0.1, 10)] {
        let before = state.clone();
        let drive = Drive::by_shift(Shift { zeta: 1.0, xi, ..Shift::default() });
        let reached =
            method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ()).unwrap();
        assert!(reached.iterations <= most, "xi = {xi}: {} systems", reached.iterations);
        assert!(scratch.traces().kombi.follows(KOMBI));
    }
}
