//! The scalar results of a step: each column has its own field, storage and restoring, and the
//! torque about the origin.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::{ContactLoad, Shift};
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Estimated, Estimates, Frictional, Gap,
    Method as _, Products, Residuals, StepSummary,
};
use carom_table::Value;

/// Values from 1 on, errors from 101 on: all are different.
fn step() -> StepSummary {
    let with = |value: f64| Estimated { value, error: 0.0 };
    let mut all = Estimates {
        f_x: with(6.0),
        f_y: with(7.0),
        f_z: with(8.0),
        m_z: with(9.0),
        zeta: with(2.0),
        xi: with(3.0),
        eta: with(4.0),
        omega: with(5.0),
        peak: with(10.0),
        contact_area: with(11.0),
        stick_area: with(12.0),
    };
    let errors: [&mut Estimated; 11] = [
        &mut all.zeta,
        &mut all.xi,
        &mut all.eta,
        &mut all.omega,
        &mut all.f_x,
        &mut all.f_y,
        &mut all.f_z,
        &mut all.m_z,
        &mut all.peak,
        &mut all.contact_area,
        &mut all.stick_area,
    ];
    for (i, one) in errors.into_iter().enumerate() {
        one.error = 101.0 + i as f64;
    }
    StepSummary {
        step: 1,
        shift: Shift { zeta: 2.0, xi: 3.0, eta: 4.0, omega: 5.0 },
        load: ContactLoad { f_x: 6.0, f_y: 7.0, f_z: 8.0, m_z: 9.0 },
        greatest_pressure: 10.0,
        contact_area: 11.0,
        stick_area: 12.0,
        stored_energy: 13.0,
        dissipated: 14.0,
        contact_share: 15.0,
        mean_gap: 16.0,
        patches: 17,
        pressure_over_slope: 18.0,
        energy_gap: 19.0,
        energy_gap_by_approach: Some(20.0),
        residuals: Residuals { normal: 21.0, tangential: 22.0 },
        products: Products { normal: 23.0, tangential: 24.0, ..Products::default() },
        estimates: Some(all),
    }
}

#[test]
fn columns_and_kept_numbers_show_each_field_in_its_place() {
    let step = step();
    let heads = [
        ("step", ""),
        ("zeta", "m"),
        ("xi", "m"),
        ("eta", "m"),
        ("omega", "rad"),
        ("F_x", "N"),
        ("F_y", "N"),
        ("F_z", "N"),
        ("M_z", "N m"),
        ("peak_pressure", "Pa"),
        ("contact_area", "m2"),
        ("stick_area", "m2"),
        ("stored_energy", "J"),
        ("dissipated", "J"),
        ("contact_share", ""),
        ("mean_gap", "m"),
        ("patches", ""),
        ("pressure_over_slope", ""),
        ("energy_gap", "J"),
        ("energy_gap_by_approach", "J"),
        ("residual_normal", ""),
        ("residual_tangential", ""),
        ("products_normal", ""),
        ("products_tangential", ""),
    ];
    let columns = StepSummary::columns();
    assert_eq!(columns.len(), StepSummary::NUMBERS);
    let numbers = step.numbers();
    for (i, column) in columns.iter().enumerate() {
        let (expected, head) = match heads.get(i) {
            Some((name, unit)) => ((i + 1) as f64, ((*name).to_owned(), *unit)),
            // Errors of the shifts, the loads, the pressure and the areas.
            None => {
                let (name, unit) = heads[1 + i - heads.len()];
                ((101 + i - heads.len()) as f64, (format!("{name}_error"), unit))
            }
        };
        assert_eq!((column.name().to_owned(), column.unit()), head);
        let value = match column.value(&step) {
            Value::Number(number) => number,
            Value::Count(count) => count as f64,
            other => panic!("{other:?}"),
        };
        assert_eq!((value, numbers[i]), (expected, expected), "{head:?}");
    }
    assert_eq!(StepSummary::from_numbers(&numbers), step);
    let bare = StepSummary { estimates: None, energy_gap_by_approach: None, ..step };
    assert_eq!(StepSummary::from_numbers(&bare.numbers()), bare);
    assert_eq!(columns[25].value(&bare), Value::Undefined);
}

/// A force at the point (x, y) has the torque y F_x - x F_y about the origin; its error is
/// unchanged.
#[test]
fn the_torque_counts_about_the_origin() {
    let moved = step().with_middle_at([0.5, 0.25]);
    assert_eq!(moved.load.m_z, 9.0 + 0.25 * 6.0 - 0.5 * 7.0);
    let expected = ContactLoad { m_z: moved.load.m_z, ..step().load };
    assert_eq!((moved.load, moved.shift), (expected, step().shift));
    let torque = moved.estimates.unwrap().m_z;
    assert_eq!((torque.value, torque.error), (moved.load.m_z, 108.0));
}

/// Back and forth at a constant approach: the work of the force equals stored energy plus heat
/// since the start.
#[test]
fn work_since_the_start_is_stored_or_heat() {
    let grid = Grid::new(24, 20, 0.12, 0.14).unwrap();
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let pair = MaterialPair::new(body, body).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
    let friction = Friction::new(0.3).unwrap();
    let problem = ContactProblem::of_half_spaces(gap, pair, friction).unwrap();
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).unwrap();
    let mut state = ContactState::apart(grid);
    let mut last = StepSummary::default();
    let (mut work, mut pressed) = (0.0, 0.0);
    for number in 0..=60 {
        let part = f64::from(number) / 20.0;
        // To 0.2, back to 0 and on to -0.2.
        let xi = 0.2 * if part < 1.0 { part } else { 2.0 - part };
        let drive = Drive::by_shift(Shift { zeta: 1.0, xi, ..Shift::default() });
        let before = state.clone();
        let went =
            method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ()).unwrap();
        let step = last.next(&problem, [&before, &state], &went).unwrap();
        if number == 0 {
            pressed = step.stored_energy;
            // Hertz: F is as zeta^(3/2).
            assert!((pressed / (0.4 * step.load.f_z) - 1.0).abs() < 0.02, "{step:?}");
        } else {
            work += 0.5 * (last.load.f_x + step.load.f_x) * (xi - last.shift.xi);
        }
        assert!(step.dissipated >= last.dissipated && step.step == number as usize + 1);
        let [stick, slip] = [CellState::Stick, CellState::Slip]
            .map(|cell| state.count(cell) as f64 / grid.cells() as f64);
        let window = grid.cells() as f64 * grid.cell_area();
        for (found, share) in [
            (step.stick_area / window, stick),
            (step.contact_area / window, stick + slip),
            (step.contact_share, stick + slip),
        ] {
            assert!((found - share).abs() < 1e-14, "{step:?}");
        }
        last = step;
    }
    let stored = last.stored_energy - pressed;
    assert!(last.dissipated > 0.05 * work && stored > 0.0, "{last:?}");
    assert!((work - stored - last.dissipated).abs() < 0.01 * work, "{work} {stored} {last:?}");
}

/// The differences of x^2/(2 R) between n cells of side d are d/R times -(n - 2)/2 to (n - 2)/2 cells, whose mean square is
/// n (n - 2)/12.
#[test]
fn pressure_over_slope_has_both_slopes_and_the_whole_window() {
    let (nx, ny, dx, dy) = (24_usize, 20_usize, 0.12, 0.14);
    let grid = Grid::new(nx, ny, dx, dy).unwrap();
    let bodies = [(2.0, 0.3), (5.0, 0.2)].map(|(g, nu)| Material::from_shear(g, nu).unwrap());
    let pair = MaterialPair::new(bodies[0], bodies[1]).unwrap();
    let (radius_x, radius_y) = (1.0, 2.0);
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x / radius_x + y * y / radius_y)).unwrap();
    let problem = ContactProblem::of_half_spaces(gap, pair, Friction::new(0.3).unwrap()).unwrap();
    let method = Frictional::default();
    let (apart, mut state) = (ContactState::apart(grid), ContactState::apart(grid));
    let drive = Drive::by_shift(Shift { zeta: 0.3, ..Shift::default() });
    let mut scratch = method.scratch(&problem).unwrap();
    let went = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ()).unwrap();
    let step = StepSummary::default().next(&problem, [&apart, &state], &went).unwrap();

    let square =
        |n: usize, d: f64, radius: f64| d * d / (radius * radius) * (n * (n - 2)) as f64 / 12.0;
    let slope = (square(nx, dx, radius_x) + square(ny, dy, radius_y)).sqrt();
    // 1/E* = (1 - nu_1)/(2 G_1) + (1 - nu_2)/(2 G_2).
    let modulus = 1.0 / (0.7 / 4.0 + 0.8 / 10.0);
    let window = nx as f64 * dx * ny as f64 * dy;
    let wanted = step.load.f_z / window / (modulus * slope);
    assert!(step.load.f_z > 0.0);
    assert!((step.pressure_over_slope / wanted - 1.0).abs() < 1e-12, "{step:?} {wanted}");
    // Tractions of dissimilar bodies press, too: the energy has no bound by the pressure alone.
    assert_eq!(step.energy_gap_by_approach, None);
}
