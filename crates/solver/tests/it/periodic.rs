//! Periodic contacts: Westergaard's wavy surface, and friction on it.

use std::f64::consts::PI;
use std::sync::Arc;

use carom_halfspace::operator::{PeriodicOperator, Threads};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictional, FrictionalError,
    Frictionless, Gap, Method as _, NormalError, PeriodError, StepSummary, violations,
};

const AMPLITUDE: f64 = 0.02;

fn wavy(n: usize, poisson: f64, friction: f64) -> ContactProblem {
    let grid = Grid::new(n, 8, 1.0 / n as f64, 1.0 / n as f64).unwrap();
    let body = Material::from_shear(2.0, poisson).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    let gap = Gap::wavy(grid, [AMPLITUDE, 0.0], [1.0, 1.0]).unwrap();
    let operator = PeriodicOperator::new(pair, grid, Threads::One).unwrap();
    ContactProblem::new(gap, Arc::new(operator), Friction::new(friction).unwrap()).unwrap()
}

fn pressed(problem: &ContactProblem, normal: Driven) -> ContactState {
    let method = Frictionless::default();
    let mut scratch = method.scratch(problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let (mut state, drive) = (apart.clone(), Drive { normal, ..Drive::default() });
    method.step(problem, &apart, &drive, &mut state, &mut scratch, &mut ()).unwrap();
    state
}

/// Westergaard: the mean pressure `p* sin^2(pi a/L)` makes stripes of half-width a with
/// `p = 2 p*cos(pi x/L) sqrt(sin^2(pi a/L) - sin^2(pi x/L))`, where `p* = pi E* A/L`.
#[test]
fn westergaards_stripes_have_their_width_and_pressure() {
    let full = PI * (2.0 * 1.0 / 0.7) * AMPLITUDE; // E* = 2 G/(1 - nu), combined
    for share in [0.2, 0.5, 0.8] {
        let error = |n: usize| {
            let problem = wavy(n, 0.3, 0.0);
            let area = n as f64 * 8.0 * problem.grid().cell_area();
            let state = pressed(&problem, Driven::Load(share * full * area));
            let mut square = 0.0;
            for ((x, _), got) in problem.grid().centres().zip(state.pressure.values()) {
                let left = share - (PI * x).sin().powi(2);
                let want = 2.0 * full * (PI * x).cos() * left.max(0.0).sqrt();
                square += (got - want) * (got - want) / (n as f64 * 8.0);
            }
            let width = state.count(CellState::Slip) as f64 / (8.0 * n as f64);
            let exact = 2.0 / PI * f64::asin(share.sqrt());
            assert!((width - exact).abs() <= 2.0 / n as f64, "{n} {share}: {width} {exact}");
            square.sqrt() / full
        };
        let errors = [32, 64, 128, 256].map(error);
        println!("{share}: {errors:?}");
        assert!(errors[3] < 2e-3 && errors[3] < 0.3 * errors[0], "{errors:?}");
    }
}

/// The approach is measured from the mean plane: force and approach are inverse functions of each
/// other. At the mean of the gap the whole period is in contact, for any larger load.
#[test]
fn the_approach_counts_from_the_mean_plane() {
    let problem = wavy(64, 0.3, 0.0);
    let area = 64.0 * 8.0 * problem.grid().cell_area();
    let full = PI * (2.0 * 1.0 / 0.7) * AMPLITUDE * area;
    let half = pressed(&problem, Driven::Load(0.5 * full));
    let back = pressed(&problem, Driven::Shift(half.shift.zeta));
    assert!((back.load().f_z / half.load().f_z - 1.0).abs() < 1e-7);
    for times in [1.1, 3.0] {
        let state = pressed(&problem, Driven::Load(times * full));
        assert!((state.shift.zeta - AMPLITUDE).abs() < 1e-9 * AMPLITUDE);
        assert_eq!(state.count(CellState::Slip), 64 * 8);
    }
}

/// Westergaard beyond full contact, waves along x and y together: the mean pressure and a wave of
/// `pi E* A/L` for each, exact on any grid.
#[test]
fn full_contact_has_the_pressure_of_its_waves() {
    let grid = Grid::new(24, 18, 1.0 / 24.0, 1.0 / 18.0).unwrap();
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    let gap = Gap::wavy(grid, [AMPLITUDE, 0.5 * AMPLITUDE], [1.0, 0.5]).unwrap();
    let operator = PeriodicOperator::new(pair, grid, Threads::One).unwrap();
    let problem = ContactProblem::new(gap, Arc::new(operator), Friction::NONE).unwrap();
    let modulus = PI * 2.0 / 0.7 * AMPLITUDE;
    let waves = [modulus, 0.5 * modulus / 0.5];
    for mean in [waves[0] + waves[1] + 1e-3, 3.0 * modulus, 1e4 * modulus] {
        let state = pressed(&problem, Driven::Load(mean));
        assert_eq!(state.count(CellState::Slip), grid.cells());
        for ((x, y), got) in grid.centres().zip(state.pressure.values()) {
            let [along, across] = [(2.0 * PI * x).cos(), (4.0 * PI * y).cos()];
            let want = mean + waves[0] * along + waves[1] * across;
            assert!((got - want).abs() < 1e-9 * mean, "{mean}: {got} {want}");
        }
    }
}

/// An approach above the mean of the gap is impossible; at the mean, and just below it, almost all
/// cells are in contact.
#[test]
fn an_approach_above_the_mean_of_a_period_is_refused_with_its_reason() {
    let problem = wavy(32, 0.3, 0.2);
    let mean = AMPLITUDE;
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let mut last = 0.0;
    for below in [1e-2, 1e-4, 1e-8, 0.0] {
        let drive = Drive { normal: Driven::Shift((1.0 - below) * mean), ..Drive::default() };
        let mut to = apart.clone();
        method.step(&problem, &apart, &drive, &mut to, &mut scratch, &mut ()).unwrap();
        assert!(to.load().f_z > last);
        last = to.load().f_z;
    }
    for part in [1.001, 1.5, 100.0] {
        let drive = Drive { normal: Driven::Shift(part * mean), ..Drive::default() };
        let mut to = apart.clone();
        let error = method.step(&problem, &apart, &drive, &mut to, &mut scratch, &mut ());
        let error = error.unwrap_err();
        assert!(
            matches!(error, FrictionalError::Period(PeriodError::AllTouches { .. })),
            "{error}"
        );
        let smooth = wavy(32, 0.3, 0.0);
        let method = Frictionless::default();
        let mut scratch = method.scratch(&smooth).unwrap();
        let error = method.step(&smooth, &apart, &drive, &mut to, &mut scratch, &mut ());
        let reason = error.unwrap_err();
        assert!(matches!(reason, NormalError::Period(PeriodError::AllTouches { .. })), "{reason}");
        assert!(reason.to_string().contains("above the mean of the gap"));
    }
}

/// If the whole period is in contact, uniform tractions cause no displacement: a shift makes some
/// cells slip, a large one all of them; with infinite friction it is an error.
#[test]
fn a_period_in_full_contact_is_shifted_by_slip_alone() {
    let load = |problem: &ContactProblem| {
        let full = PI * (2.0 / 0.7) * AMPLITUDE;
        Driven::Load(1.5 * full * problem.grid().cell_area() * problem.grid().cells() as f64)
    };
    let solve = |problem: &ContactProblem, x: Driven| {
        let method = Frictional::default();
        let mut scratch = method.scratch(problem)?;
        let apart = ContactState::apart(problem.grid());
        let drive = Drive { normal: load(problem), x, ..Drive::default() };
        let mut to = apart.clone();
        let went = method.step(problem, &apart, &drive, &mut to, &mut scratch, &mut ())?;
        assert!(went.products.tangential < 60.0, "{:?}", went.products);
        assert_eq!(to.count(CellState::Exterior), 0);
        assert!(violations(problem, &apart, &to).unwrap().tangential < 1e-8);
        Ok::<_, FrictionalError>(to)
    };
    for poisson in [0.0, 0.3] {
        let problem = wavy(32, poisson, 0.3);
        // A small force is carried without shift as long as nothing slips.
        let pulled = solve(&problem, Driven::Load(0.005)).unwrap();
        assert!(pulled.shift.xi.abs() < 1e-9 * AMPLITUDE);
        let little = solve(&problem, Driven::Shift(0.1 * AMPLITUDE)).unwrap();
        assert!(little.count(CellState::Stick) > 0 && little.count(CellState::Slip) > 0);
        let all = solve(&problem, Driven::Shift(2.0 * AMPLITUDE)).unwrap();
        assert_eq!(all.count(CellState::Stick), 0);
        assert!((all.load().f_x / (0.3 * all.load().f_z) - 1.0).abs() < 1e-9);
        let firm = wavy(32, poisson, f64::INFINITY);
        let error = solve(&firm, Driven::Shift(0.1 * AMPLITUDE)).unwrap_err();
        let reason = PeriodError::AllSticks { axis: "x", shift: 0.1 * AMPLITUDE };
        assert_eq!(error, FrictionalError::Period(reason));
        assert!(solve(&firm, Driven::Load(0.01)).is_ok());
    }
}

/// Near the mean of the gap pressures and tractions of dissimilar bodies are solved together. On
/// the way no cell may be left in contact; that is not a solution.
#[test]
fn unlike_bodies_next_to_full_contact_touch() {
    let grid = Grid::new(32, 8, 1.0 / 32.0, 1.0 / 8.0).unwrap();
    let pair = MaterialPair::new(Material::from_shear(2.0, 0.0).unwrap(), Material::RIGID).unwrap();
    let method = Frictional::default();
    let apart = ContactState::apart(grid);
    for (friction, below) in [(0.3, 1e-8), (0.3, 1e-5), (1.0, 1e-8), (1.0, 1e-3)] {
        let gap = Gap::wavy(grid, [AMPLITUDE, 0.0], [1.0, 1.0]).unwrap();
        let operator = Arc::new(PeriodicOperator::new(pair, grid, Threads::One).unwrap());
        let problem = ContactProblem::new(gap, operator, Friction::new(friction).unwrap()).unwrap();
        let mut scratch = method.scratch(&problem).unwrap();
        let drive = Drive { normal: Driven::Shift((1.0 - below) * AMPLITUDE), ..Drive::default() };
        let mut to = apart.clone();
        method.step(&problem, &apart, &drive, &mut to, &mut scratch, &mut ()).unwrap();
        let left = violations(&problem, &apart, &to).unwrap();
        assert!(left.normal < 1e-8 && left.tangential < 1e-8, "{friction} {below}: {left:?}");
    }
}

/// For nu = 0 both compliances are equal, and tractions are f times the difference between the
/// pressure and that at a lower approach, cell by cell.
#[test]
fn a_shift_leaves_the_pressure_of_a_lower_approach() {
    let (problem, f) = (wavy(128, 0.0, 0.3), 0.3);
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let zeta = 0.7 * AMPLITUDE;
    let mut pressed_state = ContactState::apart(problem.grid());
    let drive =
        |xi: f64| Drive { normal: Driven::Shift(zeta), x: Driven::Shift(xi), ..Drive::default() };
    let apart = pressed_state.clone();
    method.step(&problem, &apart, &drive(0.0), &mut pressed_state, &mut scratch, &mut ()).unwrap();
    let mut shifted = pressed_state.clone();
    let xi = f * 0.3 * AMPLITUDE;
    method.step(&problem, &pressed_state, &drive(xi), &mut shifted, &mut scratch, &mut ()).unwrap();
    let lower = pressed(&wavy(128, 0.0, 0.0), Driven::Shift(zeta - xi / f));
    let top = shifted.pressure.values().iter().copied().fold(0.0, f64::max);
    let both = shifted.pressure.values().iter().zip(lower.pressure.values());
    for ((p, low), t) in both.zip(shifted.traction_x.values()) {
        assert!((t - f * (p - low)).abs() < 1e-7 * f * top, "{t} {p} {low}");
    }
}

/// Many patches under a given tangential force, some cells at almost no pressure: few products, and
/// the same solution as for the shift that the force causes, on a period and on half-spaces.
#[test]
fn a_wavy_surface_is_pulled_by_a_force() {
    let grid = Grid::new(60, 60, 0.05, 0.05).unwrap();
    let soft = Material::from_shear(1.0, 0.5).unwrap();
    let pair = MaterialPair::new(soft, Material::RIGID).unwrap();
    let gap = Gap::wavy(grid, [0.01, 0.01], [1.0, 1.0]).unwrap();
    let f = Friction::new(0.5).unwrap();
    let half_spaces = ContactProblem::of_half_spaces(gap.clone(), pair, f).unwrap();
    let period = Arc::new(PeriodicOperator::new(pair, grid, Threads::One).unwrap());
    for problem in [half_spaces, ContactProblem::new(gap, period, f).unwrap()] {
        let method = Frictional::default();
        let mut scratch = method.scratch(&problem).unwrap();
        let mut solve = |from: &ContactState, x: Driven| {
            let mut to = from.clone();
            let drive = Drive { normal: Driven::Load(0.3), x, ..Drive::default() };
            let went = method.step(&problem, from, &drive, &mut to, &mut scratch, &mut ());
            let products = went.unwrap().products.tangential;
            assert!(products < 45.0, "{x:?}: {products}");
            to
        };
        let pressed = solve(&ContactState::apart(grid), Driven::Load(0.0));
        for part in [0.05, 0.5, 0.9] {
            let pulled = solve(&pressed, Driven::Load(part * 0.15));
            assert!((pulled.load().f_x / (part * 0.15) - 1.0).abs() < 1e-9);
            let shifted = solve(&pressed, Driven::Shift(pulled.shift.xi));
            assert!((shifted.load().f_x / pulled.load().f_x - 1.0).abs() < 1e-6);
            assert_eq!(shifted.count(CellState::Stick), pulled.count(CellState::Stick));
        }
    }
}

/// A summit at the corner of the window is one patch of a period, and four without.
#[test]
fn a_patch_goes_on_across_the_border_of_a_period() {
    let grid = Grid::new(12, 10, 0.1, 0.1).unwrap();
    let body = Material::from_shear(1.0, 0.3).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    let gap = Gap::from_function(grid, |x, y| {
        let wave = |at: f64, side: f64| 1.0 + (2.0 * PI * at / side).cos();
        0.1 * (wave(x, 1.2) + wave(y, 1.0))
    })
    .unwrap();
    let patches = |problem: ContactProblem| {
        let method = Frictional::default();
        let (apart, mut scratch) = (ContactState::apart(grid), method.scratch(&problem).unwrap());
        let drive = Drive { normal: Driven::Shift(0.03), ..Drive::default() };
        let mut state = apart.clone();
        let went = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ());
        let step = StepSummary::default().next(&problem, [&apart, &state], &went.unwrap());
        step.unwrap().patches
    };
    let by_need = ContactProblem::of_periods_by_need(gap.clone(), pair, Friction::NONE).unwrap();
    let apart = ContactProblem::of_half_spaces_by_need(gap, pair, Friction::NONE).unwrap();
    assert_eq!([patches(by_need), patches(apart)], [1, 4]);
}
