//! Random histories of random contacts satisfy the conditions of contact and friction, evaluated
//! with products of the test itself.

use carom_halfspace::operator::{DisplacementField, TractionField};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLoad, Shift};
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Frictional, FrictionalError, Gap, Method as _,
};
use proptest::prelude::*;

/// The greatest violations: gaps relative to the approach, slips and friction relative to f p_max.
pub(crate) fn violations(
    problem: &ContactProblem,
    before: &ContactState,
    after: &ContactState,
) -> [f64; 2] {
    let operator = problem.operator();
    let cells = problem.grid().cells();
    let [mut u, mut v, mut w] = [(); 3].map(|()| vec![0.0; cells]);
    let load = TractionField::full(
        after.traction_x.values(),
        after.traction_y.values(),
        after.pressure.values(),
    );
    let displacements = DisplacementField::full(&mut u, &mut v, &mut w);
    operator.apply(load, displacements, &mut operator.workspace()).unwrap();
    let own = operator.coefficients(0, 0).rows[0][0];
    let [dx, dy, turn] = [
        after.shift.xi - before.shift.xi,
        after.shift.eta - before.shift.eta,
        after.shift.omega - before.shift.omega,
    ];
    let (mut normal, mut tangential, mut approach, mut top) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
    for (i, (x, y)) in problem.grid().centres().enumerate() {
        let height = problem.gap().heights().values()[i];
        let pressure = after.pressure.values()[i];
        let gap = w[i] + height - after.shift.zeta;
        assert!(pressure >= 0.0 && gap.is_finite());
        normal = normal.max(if pressure > 0.0 { gap.abs() } else { -gap });
        approach = approach.max(after.shift.zeta - height);
        // Infinite friction is approximated from below: at the edge a cell may slip at almost no
        // pressure.
        let f = problem.friction().at(i).motion().get().min(1e9);
        let limit = if pressure > 0.0 { f * pressure } else { 0.0 };
        top = top.max(if f < 1e9 { limit } else { 0.0 });
        let slip = [
            u[i] - before.displacement_x.values()[i] - dx - y * turn,
            v[i] - before.displacement_y.values()[i] - dy + x * turn,
        ];
        let t = [after.traction_x.values()[i], after.traction_y.values()[i]];
        let pulled = [t[0] - slip[0] / own, t[1] - slip[1] / own];
        let size = pulled[0].hypot(pulled[1]);
        let part = if size > limit { limit / size } else { 1.0 };
        tangential = tangential.max((t[0] - part * pulled[0]).hypot(t[1] - part * pulled[1]));
        assert!(t[0].hypot(t[1]) <= limit * (1.0 + 1e-12), "cell {i}");
        assert_eq!(after.cells.values()[i] == CellState::Exterior, pressure == 0.0);
        // The displacements are those that the next step needs.
        let scale = 1e-9 * own * (top + 1.0);
        let kept =
            [after.displacement_x.values()[i] - u[i], after.displacement_y.values()[i] - v[i]];
        assert!(kept[0].abs().max(kept[1].abs()) <= scale.max(1e-7 * approach.abs()), "{kept:?}");
    }
    let limit = if top > 0.0 { top } else { approach / own };
    [normal / approach, if limit > 0.0 { tangential / limit } else { tangential }]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, ..ProptestConfig::default() })]

    #[test]
    fn every_step_obeys_contact_and_friction(
        size in (4..26_usize, 4..26_usize),
        curvatures in (0.2..2.0_f64, 0.2..2.0_f64),
        poisson in (-0.4..0.5_f64, -0.4..0.5_f64),
        stiffer in -2.0..2.0_f64,
        friction in prop_oneof![Just(0.0), 0.01..0.5_f64, 0.5..4.0_f64, Just(f64::INFINITY)],
        steps in prop::collection::vec(
            (0.05..1.0_f64, -0.4..0.4_f64, -0.4..0.4_f64, -0.5..0.5_f64), 1..5),
    ) {
        let grid = Grid::new(size.0, size.1, 2.2 / size.0 as f64, 2.2 / size.1 as f64).unwrap();
        let body_1 = Material::from_shear(1.0, poisson.0).unwrap();
        let body_2 = Material::from_shear(10.0_f64.powf(stiffer), poisson.1).unwrap();
        let pair = MaterialPair::new(body_1, body_2).unwrap();
        let (a, b) = curvatures;
        let gap = Gap::from_function(grid, |x, y| a * x * x + b * y * y).unwrap();
        let f = Friction::new(friction).unwrap();
        let problem = ContactProblem::of_half_spaces(gap, pair, f).unwrap();
        let method = Frictional::default();
        let mut scratch = method.scratch(&problem).unwrap();
        let mut state = ContactState::apart(grid);
        for (zeta, xi, eta, omega) in steps {
            let before = state.clone();
            let drive = Drive::by_shift(Shift { zeta, xi, eta, omega });
            let went = method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ());
            if let Err(error) = &went {
                // Up to f |gamma| of ten every step is solved, above that all but one in some
                // hundred.
                let strong = friction * pair.gamma().abs() > 10.0;
                prop_assert!(strong, "{error}");
                prop_assert!(matches!(error, FrictionalError::NotConverged { .. }), "{}", error);
                break;
            }
            let passes = went.as_ref().map_or(0.0, |went| went.products.coupling / 2.0);
            prop_assert!(passes <= 30.0 || friction * pair.gamma().abs() > 0.5, "{passes} passes");
            if went.is_ok_and(|went| went.iterations == 0) {
                prop_assert_eq!(state.load(), ContactLoad::default());
                continue;
            }
            let [normal, tangential] = violations(&problem, &before, &state);
            prop_assert!(normal < 1e-8, "normal {normal:e}");
            prop_assert!(tangential < 1e-7, "tangential {tangential:e}");
        }
    }
}
