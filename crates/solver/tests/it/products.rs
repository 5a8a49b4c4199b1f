//! The number of products of a solution: limits on small grids, and a table of all sizes on
//! request.
//!
//! The error of 1e-6 is the true error: root mean square relative to the converged solution on the
//! same grid. Products on coarse grids and boxes count in proportion to their cells; counts are the
//! same on every machine.

use std::time::Instant;

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellState, ContactProblem, ContactState, Convergence, Drive, Driven, Frictional, Frictionless,
    Gap, Method as _, SelfAffine,
};

/// The counts of one problem: to an error of 1e-6, and to the full tolerance of the method.
struct Counts {
    name: String,
    close: f64,
    full: f64,
    seconds: f64,
}

impl Counts {
    fn check(&self, close: f64, full: f64) {
        println!(
            "{:40} {:7.1} of {close} {:7.1} of {full}   {:.4} s",
            self.name, self.close, self.full, self.seconds
        );
        assert!(self.close <= close && self.full <= full, "{}", self.name);
    }
}

fn error(got: &[f64], want: &[f64]) -> f64 {
    let square: f64 = got.iter().zip(want).map(|(a, b)| (a - b) * (a - b)).sum();
    (square / want.iter().map(|b| b * b).sum::<f64>()).sqrt()
}

/// The least count whose solution has an error of at most 1e-6, over tolerances from coarse to
/// fine.
fn least(want: &[f64], solve: impl Fn(f64) -> (Vec<f64>, f64)) -> f64 {
    for quarter in 8..44 {
        let (got, count) = solve(10.0_f64.powf(-0.25 * f64::from(quarter)));
        if error(&got, want) <= 1e-6 {
            return count;
        }
    }
    f64::INFINITY
}

fn pressed(
    problem: &ContactProblem,
    normal: Driven,
    tolerance: f64,
) -> (ContactState, Convergence) {
    let method = Frictionless::default().within(tolerance).unwrap();
    let mut scratch = method.scratch(problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let (mut state, drive) = (apart.clone(), Drive { normal, ..Drive::default() });
    let went = method.step(problem, &apart, &drive, &mut state, &mut scratch, &mut ()).unwrap();
    (state, went)
}

fn normal(name: &str, problem: impl Fn() -> ContactProblem, driven: Driven) -> Counts {
    let begin = Instant::now();
    let (_, full) = pressed(&problem(), driven, 1e-10);
    let seconds = begin.elapsed().as_secs_f64();
    let problem = problem();
    let (best, _) = pressed(&problem, driven, 1e-12);
    let close = least(best.pressure.values(), |tolerance| {
        let (state, went) = pressed(&problem, driven, tolerance);
        (state.pressure.values().to_vec(), went.products.normal)
    });
    let name = format!("{name} {}", problem.grid().nx());
    Counts { name, close, full: full.products.normal, seconds }
}

fn similar(poisson: f64) -> MaterialPair {
    let body = Material::from_shear(2.0, poisson).unwrap();
    MaterialPair::new(body, body).unwrap()
}

fn square(n: usize, side: f64) -> Grid {
    Grid::new(n, n, side / n as f64, side / n as f64).unwrap()
}

fn sphere(n: usize, poisson: f64, friction: f64) -> ContactProblem {
    let gap = Gap::from_function(square(n, 2.4), |x, y| 0.5 * (x * x + y * y)).unwrap();
    let friction = Friction::new(friction).unwrap();
    ContactProblem::of_half_spaces(gap, similar(poisson), friction).unwrap()
}

fn hertz(n: usize) {
    // a = 1: F_z = (4/3) G/(1 - nu) for combined moduli.
    let force = 8.0 / 3.0 * similar(0.3).shear_modulus() / 0.7;
    normal("Hertz by force", || sphere(n, 0.3, 0.0), Driven::Load(force)).check(12.0, 17.0);
    normal("Hertz by approach", || sphere(n, 0.3, 0.0), Driven::Shift(1.0)).check(15.0, 22.0);
}

fn flat_punch(n: usize, close: f64) {
    let problem = || {
        let punch = |x: f64, y: f64| if x.hypot(y) <= 1.0 { 0.0 } else { f64::INFINITY };
        let gap = Gap::from_function(square(n, 2.4), punch).unwrap();
        ContactProblem::of_half_spaces(gap, similar(0.3), Friction::NONE).unwrap()
    };
    // The inverse on the torus, in single precision, takes one or two more than one in double precision.
    normal("flat punch by force", problem, Driven::Load(1.0)).check(close, 17.0);
    normal("flat punch by approach", problem, Driven::Shift(1.0)).check(close, 17.0);
}

/// A rough surface in partial contact: pressed to a force, and to the approach of that force.
fn rough(n: usize, force: f64, part: [f64; 2]) {
    let problem = || {
        let (grid, shortest) = (square(n, 1.0), 8.0 / n as f64);
        let surface = SelfAffine { hurst: 0.8, rms: 0.01, longest: 0.5, shortest, seed: 3 };
        ContactProblem::of_half_spaces(surface.gap(grid).unwrap(), similar(0.3), Friction::NONE)
            .unwrap()
    };
    let (state, _) = pressed(&problem(), Driven::Load(force), 1e-10);
    let touching = state.count(CellState::Slip) as f64 / (n * n) as f64;
    assert!(touching > part[0] && touching < part[1], "{touching}");
    let name = format!("rough, {:.0} %, by force", 100.0 * touching);
    normal(&name, problem, Driven::Load(force)).check(50.0, 70.0);
    let name = format!("rough, {:.0} %, by approach", 100.0 * touching);
    normal(&name, problem, Driven::Shift(state.shift.zeta)).check(50.0, 70.0);
}

/// Cattaneo's problem: the pressure is known, a shift leaves a stick area of half the radius.
fn cattaneo(n: usize, poisson: f64, close: f64, full: f64) {
    let problem = sphere(n, poisson, 0.4);
    let kappa = (2.0 - poisson) / (2.0 - 2.0 * poisson);
    let solve = |from: &ContactState, xi: f64, tolerance: f64| {
        let method = Frictional::default().within(tolerance).unwrap();
        let mut scratch = method.scratch(&problem).unwrap();
        let mut to = from.clone();
        let drive = Drive::by_shift(Shift { zeta: 1.0, xi, ..Shift::default() });
        let begin = Instant::now();
        let went = method.step(&problem, from, &drive, &mut to, &mut scratch, &mut ()).unwrap();
        let seconds = begin.elapsed().as_secs_f64();
        let both = [to.traction_x.values(), to.traction_y.values()].concat();
        (to, both, went.products, seconds)
    };
    let (from, ..) = solve(&ContactState::apart(problem.grid()), 0.0, 1e-12);
    let xi = 0.4 * kappa * 0.75;
    let (_, best, ..) = solve(&from, xi, 1e-12);
    let (_, _, products, seconds) = solve(&from, xi, 1e-9);
    assert!(products.normal <= 1.0, "the pressure stands: {products:?}");
    let close_count = least(&best, |tolerance| {
        let (_, got, products, _) = solve(&from, xi, tolerance);
        (got, products.tangential)
    });
    let name = format!("Cattaneo nu = {poisson} {n}");
    Counts { name, close: close_count, full: products.tangential, seconds }.check(close, full);
}

/// Twenty increments: along x, oblique, and back.
fn history(n: usize, poisson: f64) {
    let problem = sphere(n, poisson, 0.4);
    for (tolerance, mean, most_wanted) in [(1e-6, 17.0, 20.0), (1e-9, 21.5, 24.0)] {
        let method = Frictional::default().within(tolerance).unwrap();
        let mut scratch = method.scratch(&problem).unwrap();
        let mut state = ContactState::apart(problem.grid());
        let (mut sum, mut most) = (0.0, 0.0_f64);
        let mut shift = Shift { zeta: 1.0, ..Shift::default() };
        let drive = Drive::by_shift(shift);
        method.step(&problem, &state.clone(), &drive, &mut state, &mut scratch, &mut ()).unwrap();
        let begin = Instant::now();
        for step in 0..20 {
            let [dx, dy] = match step {
                0..5 => [0.05, 0.0],
                5..10 => [0.03, 0.04],
                _ => [-0.05, -0.01],
            };
            (shift.xi, shift.eta) = (shift.xi + dx, shift.eta + dy);
            let (from, drive) = (state.clone(), Drive::by_shift(shift));
            let went =
                method.step(&problem, &from, &drive, &mut state, &mut scratch, &mut ()).unwrap();
            sum += went.products.tangential / 20.0;
            most = most.max(went.products.tangential);
        }
        let name = format!("history nu = {poisson} to {tolerance:.0e} (mean, most) {n}");
        let seconds = begin.elapsed().as_secs_f64() / 20.0;
        Counts { name, close: sum, full: most, seconds }.check(mean, most_wanted);
    }
}

#[test]
fn small_grids_stay_within_their_budgets() {
    hertz(128);
    flat_punch(128, 10.0);
    rough(128, 0.04, [0.05, 0.3]);
    cattaneo(128, 0.0, 12.0, 15.0);
    cattaneo(128, 0.28, 12.0, 19.0);
    history(128, 0.28);
}

#[test]
#[ignore = "minutes: the whole table"]
fn all_sizes_stay_within_their_budgets() {
    for n in [256, 512, 1024] {
        hertz(n);
        flat_punch(n, 12.0);
    }
    for n in [256, 512] {
        rough(n, 0.02, [0.03, 0.07]);
        rough(n, 0.06, [0.08, 0.15]);
        rough(n, 0.12, [0.18, 0.3]);
    }
    cattaneo(256, 0.0, 14.0, 18.0);
    cattaneo(512, 0.0, 14.0, 20.0);
    cattaneo(256, 0.28, 15.0, 20.0);
    cattaneo(512, 0.28, 16.0, 25.0);
    history(256, 0.0);
    history(256, 0.28);
}
