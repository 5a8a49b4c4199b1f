//! Friction by the slip speed, beside a plane solution by another method.

use carom_halfspace::operator::{KernelOperator, TabulatedKernel, Threads};
use carom_halfspace::{Coefficients, Field, Grid};
use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_rolling::{Creepage, RollingDrive, RollingError, RollingFriction, SteadyContact, Way};
use carom_solver::{CellState, ContactProblem, Driven, Gap, Observer, Progress};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::sync::Arc;

const POISSON: f64 = 0.25;
const REST: f64 = 0.4;

/// f = 0.2 + 0.2 exp(-c v).
fn law(c: f64) -> SlipSpeedFriction {
    SlipSpeedFriction::new(0.2, 0.2, c).unwrap()
}

/// f = 0.4 - 0.2 exp(-c v).
fn growing(c: f64) -> SlipSpeedFriction {
    SlipSpeedFriction::new(0.4, -0.2, c).unwrap()
}

/// Rolling cylinders of radius 1 that touch over a width of 2, G = 1 of each body, so many cells across.
fn cylinders(elements: usize) -> ContactProblem {
    let width = 2.2 / elements as f64;
    let grid = Grid::new(elements, 1, width, 1.0).unwrap();
    let stiffness = 2.0 * (1.0 - POISSON) / PI;
    let integral = |x: f64| if x == 0.0 { 0.0 } else { x * (x.abs().ln() - 1.0) };
    let kernel = TabulatedKernel::from_function(grid, |columns, _| {
        let x = f64::from(columns) * width;
        let log = integral(x + 0.5 * width) - integral(x - 0.5 * width);
        let value = stiffness * (100.0_f64.ln() * width - log);
        Coefficients { rows: [[value, 0.0, 0.0], [0.0, value, 0.0], [0.0, 0.0, value]] }
    });
    let operator = Arc::new(KernelOperator::new(kernel.unwrap(), Threads::One).unwrap());
    let gap = Gap::from_function(grid, |x, _| 0.5 * x * x).unwrap();
    ContactProblem::new(gap, operator, Friction::new(REST).unwrap()).unwrap()
}

fn force() -> f64 {
    0.25 * PI / (1.0 - POISSON)
}

fn drive(along: f64) -> RollingDrive {
    let creepage = Creepage { along, ..Creepage::default() };
    RollingDrive::by_creepage(Driven::Load(force()), creepage)
}

fn contact(problem: &ContactProblem, law: SlipSpeedFriction) -> SteadyContact {
    let way = Way::new(problem.grid().dx()).unwrap();
    let friction = RollingFriction::new(law, 1.0).unwrap();
    SteadyContact::new(problem, way).unwrap().with_friction_by_slip(friction)
}

/// F_x/F_z on one grid.
fn on_grid(elements: usize, law: SlipSpeedFriction, along: f64) -> f64 {
    let rolled = contact(&cylinders(elements), law).roll(&drive(along), &mut ()).unwrap();
    rolled.state.load().f_x / force()
}

/// A creepage and F_x/F_z at it, by tractions that are linear between nodes of a cosine. The number of elements that
/// stick, at the leading edge, is given and the creepage found, by Newton's method on the slip of all of them: rolling
/// cylinders alone, whose Cauchy integrals are closed forms. No grid, no potential, no search for the slip.
fn plane(nodes: usize, sticking: usize, law: SlipSpeedFriction) -> (f64, f64) {
    let [a, b, c] = law.coefficients();
    let peak = 0.5 / (1.0 - POISSON);
    let x: Vec<f64> = (0..=nodes).map(|j| -(PI * j as f64 / nodes as f64).cos()).collect();
    let pressure: Vec<f64> = x.iter().map(|x| peak * (1.0 - x * x).max(0.0).sqrt()).collect();
    // Slip in the middle of each element by a traction of 1 at each inner node.
    let stiffness = 2.0 * (1.0 - POISSON) / PI;
    let slip = DMatrix::from_fn(nodes, nodes - 1, |element, node| {
        let middle = 0.5 * (x[element] + x[element + 1]);
        let part = |j: usize, from: f64| {
            let (left, right) = (x[j] - middle, x[j + 1] - middle);
            1.0 + (middle - from) * (right / left).abs().ln() / (x[j + 1] - x[j])
        };
        stiffness * (part(node, x[node]) - part(node + 1, x[node + 2]))
    });
    let at_node = |k: usize, w: &dyn Fn(usize) -> f64| 0.5 * (w(k) + w(k + 1));
    let slipping = nodes - sticking;
    let mut unknown = DVector::from_fn(nodes, |k, _| match k + 1 < nodes {
        true => (a + b) * pressure[k + 1],
        false => 0.2,
    });
    for _ in 0..50 {
        let w = (&slip * unknown.rows(0, nodes - 1)).add_scalar(unknown[nodes - 1]);
        let own = |k: usize| at_node(k, &|element| w[element]).max(0.0);
        let fall = |k: usize| b * (-c * own(k)).exp();
        let steep = |k: usize| if own(k) > 0.0 { c * fall(k) * pressure[k + 1] } else { 0.0 };
        let rows = DMatrix::from_fn(nodes, nodes, |row, k| match (row < slipping, k + 1 < nodes) {
            (true, true) => {
                let by = steep(row) * at_node(row, &|element| slip[(element, k)]);
                by + f64::from(u8::from(row == k))
            }
            (true, false) => steep(row),
            (false, true) => slip[(row, k)],
            (false, false) => 1.0,
        });
        let left = DVector::from_fn(nodes, |row, _| match row < slipping {
            true => unknown[row] - (a + fall(row)) * pressure[row + 1],
            false => w[row],
        });
        let step = rows.lu().solve(&left).unwrap();
        unknown -= &step;
        if step.amax() < 1e-13 {
            break;
        }
    }
    let sum: f64 = (1..nodes).map(|k| unknown[k - 1] * 0.5 * (x[k + 1] - x[k - 1])).sum();
    (unknown[nodes - 1], sum / force())
}

/// On two grids, extrapolated.
fn extrapolated(law: SlipSpeedFriction, along: f64) -> f64 {
    2.0 * on_grid(400, law, along) - on_grid(200, law, along)
}

/// Constant friction is Carter's, by both.
#[test]
fn without_an_effect_of_speed_both_give_carters_force() {
    for sticking in [40, 100, 160] {
        let (along, found) = plane(200, sticking, law(0.0));
        let carter = REST * (1.0 - (1.0 - along / REST).powi(2));
        assert!((found - carter).abs() < 3e-5, "{along}: {found} {carter}");
        let solved = extrapolated(law(0.0), along);
        assert!((solved - carter).abs() < 1e-3, "{along}: {solved} {carter}");
    }
}

#[test]
fn falling_friction_is_that_of_the_plane_solution() {
    for (c, sticking) in [(2.0, 40), (2.0, 100), (2.0, 160), (5.0, 40), (5.0, 100), (5.0, 160)] {
        let (along, plane) = plane(200, sticking, law(c));
        let solved = extrapolated(law(c), along);
        assert!((solved - plane).abs() < 1.5e-3, "{c} {along}: {solved} {plane}");
        let constant = REST * (1.0 - (1.0 - along / REST).powi(2));
        assert!(plane < constant - 4e-4, "friction does not fall: {plane} {constant}");
    }
}

/// Even where friction grows so fast with the slip that it would go up and down.
#[test]
fn growing_friction_is_that_of_the_plane_solution() {
    for (c, sticking) in [(5.0, 100), (12.0, 100), (30.0, 100), (100.0, 160)] {
        let (along, plane) = plane(200, sticking, growing(c));
        let solved = on_grid(200, growing(c), along);
        assert!((solved - plane).abs() < 1e-3, "{c} {along}: {solved} {plane}");
    }
}

/// In every cell that slips the traction is f(v) p with the slip speed of the cell; where it sticks, at most f(0) p. Slip by
/// a product of its own, with the influence of the state.
#[test]
fn each_cell_has_the_friction_of_its_own_slip() {
    let problem = cylinders(80);
    let length = problem.grid().dx();
    let state = contact(&problem, law(5.0)).roll(&drive(0.2), &mut ()).unwrap().state;
    let [u, p, q] = [&state.displacement_x, &state.pressure, &state.traction_x].map(Field::values);
    let mut slipping = 0;
    // The displacement of the next cell is that at x + d.
    for cell in (0..79).filter(|&cell| p[cell] > 0.0 && p[cell + 1] > 0.0) {
        let speed = (u[cell] - u[cell + 1] - length * 0.2) / length;
        let friction = law(5.0).at(speed.abs()).unwrap().get();
        match state.cells.values()[cell] {
            CellState::Slip => {
                slipping += 1;
                assert!((q[cell] / p[cell] - friction).abs() < 1e-5, "{cell}: {speed} {friction}");
            }
            _ => assert!(speed.abs() < 1e-6 && q[cell] <= REST * p[cell] * (1.0 + 1e-6)),
        }
    }
    assert!(slipping > 20, "{slipping}");
}

/// Friction that falls so fast that slip feeds itself: the contact slides as a whole beyond some creepage.
#[test]
fn a_jump_ends_in_sliding_or_is_told() {
    let problem = cylinders(60);
    let mut last = 0.0;
    for along in [0.05, 0.1, 0.15, 0.2, 0.3, 0.4] {
        match contact(&problem, law(200.0)).roll(&drive(along), &mut ()) {
            Ok(rolled) => {
                let used = rolled.state.load().f_x / force();
                assert!((0.0..=REST).contains(&used));
                last = used;
            }
            Err(RollingError::SlipSpeed { change, .. }) => assert!(change > 0.0),
            Err(other) => panic!("{other}"),
        }
    }
    assert!((last - 0.2).abs() < 5e-3, "sliding fast has the friction of high speeds: {last}");
}

#[test]
fn a_speed_that_is_none_is_refused() {
    for speed in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(RollingFriction::new(law(1.0), speed).unwrap_err().field, "speed");
    }
}

/// Counts the iterations it sees.
struct Counted(usize);

impl Observer for Counted {
    fn see(&mut self, _: &Progress) -> ControlFlow<()> {
        self.0 += 1;
        ControlFlow::Continue(())
    }
}

#[test]
fn all_iterations_of_all_passes_are_told() {
    let mut seen = Counted(0);
    let rolled = contact(&cylinders(20), law(3.0)).roll(&drive(0.2), &mut seen).unwrap();
    assert_eq!(rolled.convergence.iterations, seen.0);
    // Each of them takes a product at least.
    assert!(rolled.convergence.products.tangential >= seen.0 as f64, "{rolled:?}");
}
