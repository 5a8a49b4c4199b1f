//! The jobs of 1992 by the methods of 1992 and by the present one, on one thread.
//!
//! The history of fig. 14.17: 40 x 10 elements, dissimilar bodies, 39 increments of compression, shifts
//! along x and y and back, and decompression. The flat punch of fig. 14.35: 1000 elements, dissimilar
//! bodies, pressed in five steps and released in four. Both from separated bodies to the last step, each
//! step to 1e-8. The README has the times of 1992.

use carom_classic::jaeger::{DiscGaussSeidel, GaussSeidel, Most};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_laws::law::Shift;
use carom_solver::{ContactProblem, ContactState, Drive, Frictional, Gap, Method, Outline};
use criterion::{Criterion, criterion_group, criterion_main};

/// The approach at the deepest point, mm.
const APPROACH: f64 = 0.1;
/// Tolerance of all steps.
const TOLERANCE: f64 = 1e-8;

struct Job {
    problem: ContactProblem,
    path: Vec<Shift>,
}

fn pair(poisson: [f64; 2]) -> MaterialPair {
    let [one, two] = poisson.map(|nu| Material::from_shear(82_000.0, nu).expect("in range"));
    MaterialPair::new(one, two).expect("elastic")
}

/// Number of equal steps from the previous shift to this one.
fn go(path: &mut Vec<Shift>, [zeta, xi, eta]: [f64; 3], count: usize) {
    let from = path.last().copied().unwrap_or_default();
    for number in 1..=count {
        let part = number as f64 / count as f64;
        let mix = |from: f64, to: f64| from + part * (to - from);
        path.push(Shift {
            zeta: mix(from.zeta, zeta),
            xi: mix(from.xi, xi),
            eta: mix(from.eta, eta),
            omega: 0.0,
        });
    }
}

/// Fig. 14.17.
fn history(friction: f64) -> Job {
    let grid = Grid::new(40, 10, 0.2, 0.2).expect("positive");
    let (pair, ellipse) = (pair([0.1, 0.3]), ContactEllipse::new(4.0, 1.0).expect("positive"));
    let hertz = Hertz::from_ellipse(ellipse, APPROACH, pair).expect("in range");
    let gap = Gap::of_curvature(grid, &hertz.curvature());
    let friction = Friction::new(friction).expect("positive");
    let way = 0.5 * APPROACH * friction.get();
    let mut path = Vec::new();
    go(&mut path, [APPROACH, 0.0, 0.0], 10);
    for [xi, eta] in [[way, 0.0], [way, way], [0.0, way], [0.0, 0.0]] {
        go(&mut path, [APPROACH, xi, eta], 5);
    }
    go(&mut path, [0.1 * APPROACH, 0.0, 0.0], 9);
    let problem = ContactProblem::of_half_spaces(gap, pair, friction).expect("one grid");
    Job { problem, path }
}

/// Fig. 14.35.
fn punch() -> Job {
    let grid = Grid::new(64, 20, 2.0 / 64.0, 0.6 / 20.0).expect("positive");
    let gap =
        Gap::punch(grid, &Outline::Ellipse { half_x: 1.0, half_y: 0.3 }).expect("covers cells");
    let mut path = Vec::new();
    go(&mut path, [APPROACH, 0.0, 0.0], 5);
    go(&mut path, [0.2 * APPROACH, 0.0, 0.0], 4);
    let friction = Friction::new(0.1).expect("positive");
    let problem =
        ContactProblem::of_half_spaces(gap, pair([0.0, 0.5]), friction).expect("one grid");
    Job { problem, path }
}

fn follow<M: Method>(job: &Job, method: &M) -> ContactState {
    let mut scratch = method.scratch(&job.problem).expect("applies");
    let mut before = ContactState::apart(job.problem.grid());
    let mut state = before.clone();
    for shift in &job.path {
        let drive = Drive::by_shift(*shift);
        method
            .step(&job.problem, &before, &drive, &mut state, &mut scratch, &mut ())
            .expect("converges");
        before.clone_from(&state);
    }
    state
}

fn bench(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("methods of 1992");
    group.sample_size(10);
    let today = Frictional::default().within(TOLERANCE).expect("in range");
    let program = GaussSeidel::default().within(TOLERANCE).expect("in range");
    let discs = DiscGaussSeidel::default().within(TOLERANCE).expect("in range");
    for friction in [0.1, 1.0] {
        let (job, name) = (history(friction), format!("39 increments, f = {friction}"));
        group.bench_function(format!("{name}: program of 1992"), |b| {
            b.iter(|| follow(&job, &program))
        });
        group.bench_function(format!("{name}: discs"), |b| b.iter(|| follow(&job, &discs)));
        group.bench_function(format!("{name}: today"), |b| b.iter(|| follow(&job, &today)));
    }
    // The parameters of section 14.6.
    let most = Most { seidel: 30, stick: 1, ..Most::default() };
    let (job, name) = (punch(), "punch of 1000 points");
    let program = program.at_most(most);
    group.bench_function(format!("{name}: program of 1992"), |b| b.iter(|| follow(&job, &program)));
    group.bench_function(format!("{name}: today"), |b| b.iter(|| follow(&job, &today)));
    group.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
