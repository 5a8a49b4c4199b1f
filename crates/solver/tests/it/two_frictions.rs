//! Static friction above kinetic friction: the law cell by cell, its memory, and its effect on
//! finer grids.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellFriction, CellState, ContactProblem, ContactState, Drive, Driven, Frictional,
    FrictionalError, Gap, Method as _,
};

const KINETIC: f64 = 0.3;

fn problem(n: usize, rest: f64, rigid: bool) -> ContactProblem {
    let grid = Grid::new(n, n, 2.3 / n as f64, 2.3 / n as f64).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
    let body = Material::from_shear(2.0, 0.0).unwrap();
    let other = if rigid { Material::RIGID } else { body };
    let pair = MaterialPair::new(body, other).unwrap();
    let friction = |f: f64| Friction::new(f).unwrap();
    let friction = CellFriction::new(friction(rest), friction(KINETIC)).unwrap();
    ContactProblem::of_half_spaces(gap, pair, friction).unwrap()
}

fn follow(problem: &ContactProblem, shifts: &[f64]) -> Vec<ContactState> {
    let method = Frictional::default();
    let mut scratch = method.scratch(problem).unwrap();
    let mut state = ContactState::apart(problem.grid());
    let step = |xi: &f64| {
        let (from, drive) =
            (state.clone(), Drive::by_shift(Shift { zeta: 1.0, xi: *xi, ..Shift::default() }));
        let went = method.step(problem, &from, &drive, &mut state, &mut scratch, &mut ());
        went.unwrap_or_else(|error| panic!("{xi}: {error}"));
        state.clone()
    };
    shifts.iter().map(step).collect()
}

#[test]
fn without_kinetic_friction_static_friction_still_holds() {
    let rest = Friction::new(0.45).unwrap();
    let friction = CellFriction::new(rest, Friction::NONE).unwrap();
    let problem = problem(20, 0.45, false).with_friction(friction).unwrap();
    let state = &follow(&problem, &[0.0, 0.01])[1];
    assert!(state.count(CellState::Stick) > 0 && state.load().f_x > 0.0, "{:?}", state.load());
}

#[test]
fn cells_stick_up_to_static_and_slip_at_kinetic_friction() {
    for rigid in [false, true] {
        let problem = problem(40, 0.45, rigid);
        let states = follow(&problem, &[0.0, 0.05, 0.15, 0.1, -0.1]);
        let mut between = 0;
        for pair in states.windows(2) {
            let (before, state) = (&pair[0], &pair[1]);
            for (i, cell) in state.cells.values().iter().enumerate() {
                let p = state.pressure.values()[i];
                let [x, y] = [state.traction_x.values()[i], state.traction_y.values()[i]];
                let t = x.hypot(y);
                let broken = before.cells.values()[i] == CellState::Slip;
                match cell {
                    CellState::Exterior => assert_eq!(t, 0.0),
                    CellState::Slip => {
                        assert!((t - KINETIC * p).abs() < 1e-12, "{t} {p}");
                        let rigid = state.shift.xi - before.shift.xi;
                        let u = state.displacement_x.values()[i] - rigid;
                        let s = u - before.displacement_x.values()[i];
                        assert!(s * x <= 1e-9, "slip opposes the traction");
                    }
                    CellState::Stick if broken => assert!(t <= KINETIC * p * (1.0 + 1e-12)),
                    CellState::Stick => {
                        assert!(t <= 0.45 * p * (1.0 + 1e-12));
                        between += usize::from(t > KINETIC * p);
                    }
                }
            }
        }
        assert!(between > 10, "some cells hold more than kinetic friction");
    }
}

/// A slipping cell has kinetic friction in the next step; after a step without slip it has static
/// friction again.
#[test]
fn a_step_at_rest_heals() {
    let problem = problem(40, 0.45, false);
    let on = follow(&problem, &[0.0, 0.15, 0.152])[2].load().f_x;
    let rested = follow(&problem, &[0.0, 0.15, 0.1499, 0.152])[3].load().f_x;
    assert!(rested > 1.001 * on, "{rested} {on}");
}

/// A load that static friction could hold and kinetic friction cannot: the bodies slide.
#[test]
fn once_broken_the_bodies_slide() {
    let problem = problem(32, 0.36, false);
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let apart = ContactState::apart(problem.grid());
    let pull = |part: f64| Drive {
        normal: Driven::Load(1.0),
        x: Driven::Load(part * KINETIC),
        ..Drive::default()
    };
    let mut to = apart.clone();
    assert!(method.step(&problem, &apart, &pull(0.9), &mut to, &mut scratch, &mut ()).is_ok());
    let error = method.step(&problem, &apart, &pull(1.15), &mut to, &mut scratch, &mut ());
    assert!(matches!(error, Err(FrictionalError::Slides { .. })), "{error:?}");
}

/// The excess of the tangential force over that of kinetic friction alone falls with the cell
/// width.
#[test]
fn static_friction_matters_less_on_finer_grids() {
    let excess = |n: usize| {
        let force = |rest: f64| follow(&problem(n, rest, false), &[0.0, 0.15])[1].load();
        let (both, kinetic, fixed) = (force(0.45), force(KINETIC), force(1e6));
        assert!(both.f_x >= kinetic.f_x && both.f_x < fixed.f_x);
        let excess = (both.f_x - kinetic.f_x) / kinetic.f_z;
        println!("{n}: {excess:.5} of {:.5}", (fixed.f_x - kinetic.f_x) / kinetic.f_z);
        excess
    };
    let excesses = [16, 32, 64, 128].map(excess);
    assert!(excesses[3] > 0.0 && excesses[3] < 0.25 * excesses[0], "{excesses:?}");
}
