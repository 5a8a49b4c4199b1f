//! Prescribed torques between dissimilar bodies, and their contribution to the errors of a history.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    ContactProblem, ContactState, Drive, Driven, Estimated, Estimates, Frictional, Gap,
    Method as _, violations,
};

/// A body of nu = 0 on a rigid one: normal and tangential displacements are coupled, and with large
/// friction pressures and tractions must be solved together.
fn problem(friction: f64) -> ContactProblem {
    let grid = Grid::new(20, 24, 0.12, 0.1).unwrap();
    let pair = MaterialPair::new(Material::from_shear(1.0, 0.0).unwrap(), Material::RIGID).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * ((x - 0.1).powi(2) + 1.2 * y * y)).unwrap();
    ContactProblem::of_half_spaces(gap, pair, Friction::new(friction).unwrap()).unwrap()
}

/// The integrals of the tractions: F_x, F_y, F_z and the torque of (y t_x - x t_y), cell by cell.
fn sums(state: &ContactState) -> [f64; 4] {
    let grid = state.pressure.grid();
    let mut sums = [0.0; 4];
    for (i, (x, y)) in grid.centres().enumerate() {
        let [p, t_x, t_y] = [&state.pressure, &state.traction_x, &state.traction_y]
            .map(|field| grid.cell_area() * field.values()[i]);
        for (sum, part) in sums.iter_mut().zip([t_x, t_y, p, y * t_x - x * t_y]) {
            *sum += part;
        }
    }
    sums
}

/// A twist gives a torque; the torque gives the same twist and the same tractions.
#[test]
fn a_given_torque_turns_dissimilar_bodies_as_far_as_the_twist_that_makes_it() {
    for friction in [0.4, 10.0] {
        let problem = problem(friction);
        let method = Frictional::default();
        let mut scratch = method.scratch(&problem).unwrap();
        let mut by_shift = ContactState::apart(problem.grid());
        let mut by_torque = by_shift.clone();
        for [zeta, xi, eta, omega] in [
            [0.5, 0.0, 0.0, 0.0],
            [0.5, 0.02, -0.03, 0.08],
            [0.45, 0.05, 0.01, 0.15],
            [0.5, 0.05, 0.01, -0.1],
        ] {
            let own = Drive {
                normal: Driven::Shift(zeta),
                x: Driven::Shift(xi),
                y: Driven::Shift(eta),
                twist: Driven::Shift(omega),
            };
            let before = by_shift.clone();
            method.step(&problem, &before, &own, &mut by_shift, &mut scratch, &mut ()).unwrap();
            let [f_x, f_y, f_z, m_z] = sums(&by_shift);
            let load = by_shift.load();
            for (told, sum) in [(load.f_x, f_x), (load.f_y, f_y), (load.f_z, f_z), (load.m_z, m_z)]
            {
                assert!((told - sum).abs() < 1e-12 * f_z, "{told} {sum}");
            }
            assert!(omega == 0.0 || m_z * omega > 0.0 && m_z.abs() > 0.01 * f_z);
            for y in [Driven::Shift(eta), Driven::Load(f_y)] {
                let given = Drive { y, twist: Driven::Load(m_z), ..own };
                let (before, mut after) = (by_torque.clone(), by_torque.clone());
                method
                    .step(&problem, &before, &given, &mut after, &mut scratch, &mut ())
                    .unwrap_or_else(|error| panic!("f = {friction}, {given:?}: {error}"));
                assert!((after.shift.omega - omega).abs() < 1e-6, "{:?}", after.shift);
                assert!((after.shift.eta - eta).abs() < 1e-6, "{:?}", after.shift);
                assert!((sums(&after)[3] - m_z).abs() < 1e-7 * f_z);
                let peak = by_shift.peak_pressure();
                for (one, other) in [
                    (&by_shift.pressure, &after.pressure),
                    (&by_shift.traction_x, &after.traction_x),
                    (&by_shift.traction_y, &after.traction_y),
                ] {
                    for (one, other) in one.values().iter().zip(other.values()) {
                        assert!((one - other).abs() < 1e-4 * peak * friction.max(1.0));
                    }
                }
            }
            // Both continue from the same state.
            by_torque = by_shift.clone();
        }
    }
}

/// The bounds of the smaller coefficients, from which the solution begins, hold less than these torques: they
/// are raised. Before, no torque of more than half of the limit was found.
#[test]
fn torques_up_to_near_their_limit_are_found_at_great_friction() {
    for friction in [10.0, 30.0] {
        let problem = problem(friction);
        let (method, apart) = (Frictional::default(), ContactState::apart(problem.grid()));
        let mut scratch = method.scratch(&problem).unwrap();
        let (mut pressed, mut turned) = (apart.clone(), apart.clone());
        let drive = Drive { normal: Driven::Shift(0.5), ..Drive::default() };
        method.step(&problem, &apart, &drive, &mut pressed, &mut scratch, &mut ()).unwrap();
        // All cells slip.
        let slides = Drive { twist: Driven::Shift(50.0), ..drive };
        method.step(&problem, &pressed, &slides, &mut turned, &mut scratch, &mut ()).unwrap();
        let (limit, f_z) = (sums(&turned)[3], sums(&pressed)[2]);
        let mut last = 0.0;
        for part in [0.3, 0.6, 0.75, 0.89] {
            let given = part * limit;
            for normal in [Driven::Load(f_z), Driven::Shift(0.5)] {
                let drive = Drive { normal, twist: Driven::Load(given), ..drive };
                let mut to = apart.clone();
                method
                    .step(&problem, &pressed, &drive, &mut to, &mut scratch, &mut ())
                    .unwrap_or_else(|error| panic!("f = {friction}, {part}, {normal:?}: {error}"));
                let left = violations(&problem, &pressed, &to).unwrap();
                assert!(left.normal < 1e-8 && left.tangential < 1e-7, "{part}: {left:?}");
                assert!((sums(&to)[3] - given).abs() < 1e-7 * limit, "{part}: {}", sums(&to)[3]);
                if normal == Driven::Shift(0.5) {
                    assert!(to.shift.omega > last, "{part}: {} {last}", to.shift.omega);
                    last = to.shift.omega;
                }
            }
        }
    }
}

/// A mutable reference to one of the estimated values.
type Part = fn(&mut Estimates) -> &mut Estimated;

/// The worst error of a history is the greatest of eight, each relative to the greatest value of
/// its kind.
#[test]
fn each_load_and_shift_counts_for_the_worst_error() {
    let exact = |value| Estimated { value, error: 0.0 };
    let area = 4.0 * std::f64::consts::PI; // a radius of 2
    let all = Estimates {
        f_x: exact(3.0),
        f_y: exact(-4.0),
        f_z: exact(20.0),
        m_z: exact(-8.0),
        zeta: exact(0.5),
        xi: exact(0.06),
        eta: exact(0.08),
        omega: exact(0.25),
        peak: exact(7.0),
        contact_area: exact(area),
        stick_area: exact(1.0),
    };
    assert_eq!(Estimates::worst(&[all]), 0.0);
    let of: [(Part, f64); 8] = [
        (|all| &mut all.f_x, 5.0),
        (|all| &mut all.f_y, 5.0),
        (|all| &mut all.f_z, 20.0),
        (|all| &mut all.m_z, 8.0),
        (|all| &mut all.zeta, 0.5),
        (|all| &mut all.xi, 0.1),
        (|all| &mut all.eta, 0.1),
        (|all| &mut all.omega, 0.25),
    ];
    for (field, scale) in of {
        let mut one = all;
        field(&mut one).error = 1e-3;
        for history in [[all, one], [one, all]] {
            let worst = Estimates::worst(&history);
            assert!((worst - 1e-3 / scale).abs() < 1e-15, "{worst} of {scale}");
        }
    }
    // Without tangential loads and shifts: a hundredth of the normal ones, with the radius as arm.
    let none = Estimates {
        f_x: exact(0.0),
        f_y: exact(0.0),
        m_z: exact(0.0),
        xi: exact(0.0),
        eta: exact(0.0),
        omega: exact(0.0),
        ..all
    };
    for (field, scale) in of.into_iter().zip([0.2, 0.2, 20.0, 0.4, 0.5, 5e-3, 5e-3, 2.5e-3]) {
        let (mut one, field) = (none, field.0);
        field(&mut one).error = 1e-3;
        let worst = Estimates::worst(&[one]);
        assert!((worst * scale - 1e-3).abs() < 1e-12, "{worst} of {scale}");
    }
}
