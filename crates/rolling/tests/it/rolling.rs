//! Rolling by steps and steady rolling, creep coefficients, Carter, FASTSIM.

use std::f64::consts::PI;
use std::sync::Arc;

use carom_drawn::{Congruential, Draw as _};
use carom_halfspace::operator::{KernelOperator, TabulatedKernel, Threads};
use carom_halfspace::{Coefficients, Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{
    CreepCoefficients, Creepage, Fastsim, RollingContact, RollingDrive, RollingError,
    SteadyContact, SteadyMethod, TransientMethod, Way, creep_coefficients, creep_coefficients_on,
    roll_steadily,
};
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictionless, Gap, Method as _,
};

const FRICTION: f64 = 0.3;

fn sphere(n: usize, poisson: [f64; 2]) -> ContactProblem {
    let width = 2.4 / n as f64;
    let grid = Grid::new(n + 2, n, width, width).unwrap();
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
    let [one, two] = poisson.map(|nu| Material::from_shear(1.0, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    ContactProblem::of_half_spaces(gap, pair, Friction::new(FRICTION).unwrap()).unwrap()
}

fn roll_on(problem: &ContactProblem, way: Way, creepage: Creepage, steps: usize) -> ContactState {
    let mut contact = RollingContact::new(problem, way).unwrap().within(1e-11).unwrap();
    let mut state = ContactState::apart(problem.grid());
    let drive = RollingDrive::by_creepage(Driven::Shift(1.0), creepage);
    for _ in 0..steps {
        let before = state.clone();
        contact.step(&drive, &before, &mut state, &mut ()).unwrap();
    }
    state
}

#[test]
fn rolling_on_tends_to_steady_rolling() {
    for poisson in [[0.3, 0.3], [0.0, 0.5]] {
        let problem = sphere(12, poisson);
        for (columns, steps) in [(1.0, 160), (2.0, 80), (0.5, 320), (1.3, 120)] {
            for creepage in [
                Creepage { along: 0.06, across: 0.02, spin: 0.0 },
                Creepage { along: -0.03, across: 0.0, spin: 0.1 },
                Creepage { along: 0.5, across: 0.0, spin: 0.0 },
            ] {
                let distance = columns * problem.grid().dx();
                let steady =
                    roll_steadily(&problem, Driven::Shift(1.0), distance, creepage).unwrap();
                let way = Way::new(distance).unwrap();
                let state = roll_on(&problem, way, creepage, steps);
                let (a, b) = (state.load(), steady.state.load());
                let scale = FRICTION * b.f_z;
                let worst = [a.f_x - b.f_x, a.f_y - b.f_y, a.m_z - b.m_z, a.f_z - b.f_z]
                    .map(|difference| (difference / scale).abs())
                    .into_iter()
                    .fold(0.0, f64::max);
                println!(
                    "{poisson:?} {columns} {creepage:?}: {worst:.1e}, F_x {:.4} F_y {:.4}",
                    b.f_x / scale,
                    b.f_y / scale
                );
                assert!(worst < 1e-9, "{poisson:?} {columns} {creepage:?}: {worst:.1e}");
                assert_eq!(steady.slides, state.count(CellState::Stick) == 0);
            }
        }
    }
}

#[test]
fn a_step_as_a_method_is_solved_to_its_tolerance_and_creeps_as_given() {
    let problem = sphere(12, [0.0, 0.5]);
    let method = SteadyMethod::default().in_steps_of(problem.grid().dx()).unwrap();
    let method = TransientMethod::new(method.within(1e-12).unwrap());
    let creepage = Creepage { along: 0.06, across: 0.02, spin: 0.1 };
    let drive = RollingDrive::by_creepage(Driven::Shift(1.0), creepage).into();
    let (mut scratch, mut state) =
        (method.scratch(&problem).unwrap(), ContactState::apart(problem.grid()));
    for _ in 0..4 {
        let before = state.clone();
        let went = method.step(&problem, &before, &drive, &mut state, &mut scratch, &mut ());
        assert!(went.unwrap().residuals.worst() <= 1e-12);
        let found = [state.shift.xi, state.shift.eta, state.shift.omega];
        for (found, given) in found.into_iter().zip([0.06, 0.02, 0.1]) {
            assert!((found - given).abs() < 1e-14, "{found} {given}");
        }
    }
}

#[test]
fn creep_coefficients_of_a_circle_without_poissons_ratio_are_closed_forms() {
    let c = creep_coefficients(1.0, 0.0).unwrap();
    let exact = 32.0 / (3.0 * PI);
    assert!((c.c11 / exact - 1.0).abs() < 3e-5 && (c.c22 / exact - 1.0).abs() < 3e-5);
    assert!((c.c23 / (4.0 / 3.0) - 1.0).abs() < 3e-5 && (c.c32 / (4.0 / 3.0) - 1.0).abs() < 3e-5);
}

#[test]
fn creep_coefficients_agree_with_an_independent_calculation() {
    // a/b, nu; C11, C22, C23, C33
    let table = [
        ([0.2, 0.25], [3.3754, 2.6328, 0.6028, 4.2942]),
        ([0.5, 0.5], [4.8682, 3.1445, 1.0725, 2.2281]),
        ([1.0, 0.25], [4.1131, 3.6686, 1.4663, 1.1842]),
        ([2.0, 0.25], [5.1005, 4.9093, 2.6245, 0.8195]),
        ([5.0, 0.5], [8.8380, 9.8707, 7.9040, 0.3420]),
    ];
    for ([ratio, poisson], want) in table {
        let CreepCoefficients { c11, c22, c23, c32, c33 } =
            creep_coefficients(ratio, poisson).unwrap();
        let got = [c11, c22, 0.5 * (c23 + c32), c33];
        let off: Vec<String> =
            got.iter().zip(want).map(|(g, w)| format!("{:.2e}", g / w - 1.0)).collect();
        println!("{ratio} {poisson}: {got:?} {off:?}");
        // Reciprocal in the continuum, not on a mesh.
        assert!((c23 / c32 - 1.0).abs() < 1e-4, "a/b {ratio} nu {poisson}: {c23} {c32}");
        for (i, (got, want)) in got.into_iter().zip(want).enumerate() {
            let allowed = if i == 3 { 5e-3 } else { 2e-3 };
            assert!((got / want - 1.0).abs() < allowed, "a/b {ratio} nu {poisson}: {got} {want}");
        }
    }
}

/// An element in the middle of a strip has no image in it.
#[test]
fn odd_numbers_of_elements_lie_between_even_ones() {
    for ratio in [0.5, 2.0] {
        let on = |along| {
            let c = creep_coefficients_on([8, along], ratio, 0.3).unwrap();
            [c.c11, c.c22, c.c23, c.c32, c.c33]
        };
        for odd in [3, 9] {
            let [below, at, above] = [on(odd - 1), on(odd), on(odd + 1)];
            for ((below, at), above) in below.into_iter().zip(at).zip(above) {
                assert!((at - below) * (above - at) > 0.0, "{ratio} {odd}: {below} {at} {above}");
            }
        }
    }
}

/// Rolling cylinders: one row of elements of a plane half-space, by its logarithmic kernel.
fn cylinders(n: usize) -> ContactProblem {
    let width = 2.2 / n as f64;
    let grid = Grid::new(n, 1, width, 1.0).unwrap();
    // Two bodies of G = 1 and nu = 0.3; the unit of the logarithm is far away.
    let stiffness = 2.0 * (1.0 - 0.3) / PI;
    let integral = |x: f64| if x == 0.0 { 0.0 } else { x * (x.abs().ln() - 1.0) };
    let kernel = TabulatedKernel::from_function(grid, |columns, _| {
        let x = f64::from(columns) * width;
        let log = integral(x + 0.5 * width) - integral(x - 0.5 * width);
        let value = stiffness * (100.0_f64.ln() * width - log);
        Coefficients { rows: [[value, 0.0, 0.0], [0.0, value, 0.0], [0.0, 0.0, value]] }
    })
    .unwrap();
    let operator = Arc::new(KernelOperator::new(kernel, Threads::One).unwrap());
    let gap = Gap::from_function(grid, |x, _| 0.5 * x * x).unwrap();
    ContactProblem::new(gap, operator, Friction::new(FRICTION).unwrap()).unwrap()
}

#[test]
fn cylinders_roll_as_carter_says() {
    let mut errors = Vec::new();
    for n in [44, 88, 176] {
        let problem = cylinders(n);
        // Semi-width 1 at radius 1: P = pi a^2/(2 (1 - nu) R) for G = 1 each ... by the pressure p0 a pi/2.
        let smooth = ContactProblem::new(
            problem.gap().clone(),
            Arc::new(Plane(problem.clone())),
            Friction::NONE,
        )
        .unwrap();
        let method = Frictionless::default();
        let mut scratch = method.scratch(&smooth).unwrap();
        let apart = ContactState::apart(problem.grid());
        let mut state = apart.clone();
        let force = PI / (4.0 * (1.0 - 0.3));
        let drive = Drive { normal: Driven::Load(force), ..Drive::default() };
        method.step(&smooth, &apart, &drive, &mut state, &mut scratch, &mut ()).unwrap();
        let approach = state.shift.zeta;
        let half_width = 0.5 * problem.grid().dx() * (n - state.count(CellState::Exterior)) as f64;
        for part in [0.2, 0.5, 0.8] {
            let creepage = Creepage { along: FRICTION * part, ..Creepage::default() };
            let rolled =
                roll_steadily(&problem, Driven::Shift(approach), problem.grid().dx(), creepage)
                    .unwrap();
            let load = rolled.state.load();
            let want = 1.0 - (1.0 - part) * (1.0 - part);
            let got = load.f_x / (FRICTION * load.f_z);
            println!(
                "{n} {part}: {got:.5} {want:.5}, a = {half_width:.3}, F_z {:.4}",
                load.f_z / force
            );
            errors.push((got - want).abs());
        }
        let beyond = Creepage { along: 1.2 * FRICTION, ..Creepage::default() };
        assert!(
            roll_steadily(&problem, Driven::Shift(approach), problem.grid().dx(), beyond)
                .unwrap()
                .slides
        );
    }
    // First order in the width of an element.
    for part in 0..3 {
        assert!(errors[6 + part] < 0.6 * errors[part] && errors[6 + part] < 0.02, "{errors:?}");
    }
}

/// The operator of another problem.
struct Plane(ContactProblem);

impl carom_halfspace::operator::SurfaceOperator for Plane {
    fn grid(&self) -> Grid {
        self.0.grid()
    }
    fn is_coupled(&self) -> bool {
        false
    }
    fn coefficients(&self, columns: i32, rows: i32) -> Coefficients {
        self.0.operator().coefficients(columns, rows)
    }
    fn workspace(&self) -> carom_halfspace::operator::Workspace {
        self.0.operator().workspace()
    }
    fn apply(
        &self,
        tractions: carom_halfspace::operator::TractionField<'_>,
        displacements: carom_halfspace::operator::DisplacementField<'_>,
        workspace: &mut carom_halfspace::operator::Workspace,
    ) -> Result<(), carom_halfspace::operator::OperatorError> {
        self.0.operator().apply(tractions, displacements, workspace)
    }
}

#[test]
fn springs_come_near_in_the_middle_and_agree_at_both_ends() {
    let problem = sphere(20, [0.25, 0.25]);
    let coefficients = creep_coefficients_on([16, 16], 1.0, 0.25).unwrap();
    let dx = problem.grid().dx();
    for part in [0.01, 0.3, 0.7, 3.0] {
        let creepage = Creepage { along: 0.2 * part, ..Creepage::default() };
        let steady = roll_steadily(&problem, Driven::Shift(1.0), dx, creepage).unwrap();
        let load = steady.state.load();
        let limit = FRICTION * load.f_z;
        let fastsim = Fastsim {
            semi_axes: [1.0, 1.0],
            shear_modulus: 1.0,
            coefficients,
            force: load.f_z,
            friction: FRICTION,
            mesh: [50, 50],
        };
        let springs = fastsim.forces(creepage).unwrap().f_x;
        println!("{part}: {:.4} {:.4}", load.f_x / limit, springs / limit);
        assert!((load.f_x - springs).abs() < 0.1 * limit);
        assert!(load.f_x <= limit * (1.0 + 1e-9) && springs <= limit * (1.0 + 1e-9));
    }
}

#[test]
fn springs_start_with_the_creep_coefficients() {
    for semi_axes in [[1.0, 1.0], [0.4, 1.5], [3.0, 0.7]] {
        let ([a, b], friction) = (semi_axes, f64::from(1_u32 << 30));
        let coefficients = CreepCoefficients { c11: 4.0, c22: 3.0, c23: 1.5, c32: 1.5, c33: 1.2 };
        let (shear_modulus, force, mesh) = (2.0, 1.0, [200, 200]);
        let springs = Fastsim { semi_axes, shear_modulus, coefficients, force, friction, mesh };
        let forces =
            |along, across, spin| springs.forces(Creepage { along, across, spin }).unwrap();
        let unit = shear_modulus * a * b;
        let pairs = [
            (forces(0.1, 0.0, 0.0).f_x, 0.1 * unit * 4.0),
            (forces(0.0, 0.1, 0.0).f_y, 0.1 * unit * 3.0),
            (forces(0.0, 0.0, 0.1).f_y, -0.1 * unit * (a * b).sqrt() * 1.5),
        ];
        for (got, want) in pairs {
            assert!((got / want - 1.0).abs() < 1e-4, "{semi_axes:?}: {got} {want}");
        }
    }
}

#[test]
fn rolling_that_makes_no_sense_is_named() {
    let problem = sphere(8, [0.3, 0.3]);
    let creepage = Creepage { along: 0.01, ..Creepage::default() };
    for distance in [0.0, -0.1, f64::NAN, f64::INFINITY, 1e3] {
        let error = roll_steadily(&problem, Driven::Shift(1.0), distance, creepage).unwrap_err();
        assert!(matches!(error, RollingError::Range(e) if e.field == "rolling distance"));
    }
    // It may be longer than the grid is the other way.
    for (cells, direction, fits) in [
        ([16, 4], 0.0, true),
        ([16, 4], 0.5 * PI, false),
        ([4, 16], 0.5 * PI, true),
        ([4, 16], 0.0, false),
    ] {
        let grid = Grid::new(cells[0], cells[1], 0.2, 0.2).unwrap();
        let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).unwrap();
        let body = Material::from_shear(1.0, 0.3).unwrap();
        let (pair, friction) =
            (MaterialPair::new(body, body).unwrap(), Friction::new(FRICTION).unwrap());
        let oblong = ContactProblem::of_half_spaces(gap, pair, friction).unwrap();
        let way = Way::new(10.0 * grid.dx()).unwrap().towards(direction).unwrap();
        assert_eq!(RollingContact::new(&oblong, way).is_ok(), fits, "{cells:?} {direction}");
    }
    let broken = Creepage { spin: f64::NAN, ..creepage };
    let error = roll_steadily(&problem, Driven::Shift(1.0), 0.1, broken).unwrap_err();
    assert!(matches!(error, RollingError::Range(e) if e.field == "spin"));
    // With M_z given, the creepage across the way is known at the middle alone; that along it everywhere.
    let drive = |along, across| RollingDrive {
        normal: Driven::Shift(1.0),
        along,
        across,
        spin: Driven::Load(0.0),
    };
    let (free, held) = (Driven::Load(0.0), Driven::Shift(0.0));
    for (direction, known, unknown) in [
        (0.0, drive(held, free), drive(free, held)),
        (0.5 * PI, drive(free, held), drive(held, free)),
    ] {
        let way = Way::new(problem.grid().dx()).unwrap().towards(direction).unwrap();
        let way = way.with_spin_at(0.5).unwrap();
        let mut contact = SteadyContact::new(&problem, way).unwrap();
        assert!(contact.roll(&known, &mut ()).is_ok(), "{direction}");
        let error = contact.roll(&unknown, &mut ()).unwrap_err();
        assert!(matches!(error, RollingError::Range(e) if e.field == "spin offset"), "{error}");
    }
    // The displacements beyond the grid are known for a half-space, not for a table.
    let far = 4.0 * problem.grid().dx();
    assert!(roll_steadily(&problem, Driven::Shift(1.0), far, creepage).is_ok());
    let table = cylinders(44);
    let far = 4.0 * table.grid().dx();
    let force = Driven::Load(PI / (4.0 * (1.0 - 0.3)));
    let error = roll_steadily(&table, force, far, creepage).unwrap_err();
    assert!(matches!(error, RollingError::NoRoomAhead { needed: 4, .. }), "{error}");
    // As many cells as are free, but for rounding, are enough.
    let wide = cylinders(24);
    let dx = wide.grid().dx();
    let last = roll_steadily(&wide, force, dx, creepage).unwrap().state.extent().unwrap()[0][1];
    let room = wide.grid().nx() - 1 - last;
    let step = |cells: f64| roll_steadily(&wide, force, cells * dx, creepage);
    assert!(step(room as f64 * (1.0 + 1e-12)).is_ok(), "{room}");
    let error = step(room as f64 + 0.01).unwrap_err();
    let told = RollingError::NoRoomAhead { free: room, needed: room + 1 };
    assert_eq!(error, told);
    for (field, error) in [
        ("a/b", creep_coefficients(0.01, 0.3).unwrap_err()),
        ("a/b", creep_coefficients(f64::NAN, 0.3).unwrap_err()),
        ("poisson", creep_coefficients(1.0, 0.6).unwrap_err()),
        ("strips", creep_coefficients_on([7, 8], 1.0, 0.3).unwrap_err()),
        ("elements of a strip", creep_coefficients_on([100, 100], 1.0, 0.3).unwrap_err()),
    ] {
        assert!(matches!(&error, RollingError::Range(e) if e.field == field), "{field}: {error}");
    }
}

#[test]
fn a_normal_force_is_met_with_and_without_coupling() {
    for poisson in [[0.3, 0.3], [0.0, 0.5], [0.5, 0.0]] {
        let problem = sphere(12, poisson);
        let dx = problem.grid().dx();
        let creepage = Creepage { along: 0.06, across: 0.02, spin: 0.05 };
        let want = roll_steadily(&problem, Driven::Shift(0.9), dx, creepage).unwrap().state;
        let force = want.load().f_z;
        let got = roll_steadily(&problem, Driven::Load(force), dx, creepage).unwrap().state;
        assert!((got.shift.zeta - 0.9).abs() < 1e-8, "{poisson:?}: {}", got.shift.zeta);
        assert!((got.load().f_x - want.load().f_x).abs() < 1e-8 * force);
        for force in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let error = roll_steadily(&problem, Driven::Load(force), dx, creepage).unwrap_err();
            assert!(matches!(error, RollingError::Range(e) if e.field == "F_z"));
        }
    }
}

/// Random creepages of all sizes, both signs and any mixture.
fn creepages(seed: u64, count: usize) -> Vec<Creepage> {
    let mut draw = Congruential(seed);
    let mut any = || {
        let size = 10.0_f64.powf(-12.0 + 16.0 * draw.part());
        let part = draw.part();
        if part < 0.2 { 0.0 } else { size * if part < 0.6 { -1.0 } else { 1.0 } }
    };
    (0..count).map(|_| Creepage { along: any(), across: any(), spin: any() }).collect()
}

#[test]
fn mirrored_and_reversed_creepages_mirror_and_reverse_the_forces() {
    for poisson in [[0.3, 0.3], [0.0, 0.5]] {
        let problem = sphere(10, poisson);
        let dx = problem.grid().dx();
        let load = |creepage| {
            roll_steadily(&problem, Driven::Shift(1.0), dx, creepage)
                .unwrap_or_else(|error| panic!("{poisson:?} {creepage:?}: {error}"))
                .state
                .load()
        };
        for creepage in creepages(7, 60) {
            let Creepage { along, across, spin } = creepage;
            let own = load(creepage);
            let limit = FRICTION * own.f_z;
            let mirrored = load(Creepage { along, across: -across, spin: -spin });
            let off = [
                own.f_x - mirrored.f_x,
                own.f_y + mirrored.f_y,
                own.m_z + mirrored.m_z,
                own.f_z - mirrored.f_z,
            ];
            assert!(off.iter().all(|off| off.abs() < 1e-8 * limit), "{creepage:?}: {off:?}");
            assert!(own.f_x.hypot(own.f_y) <= limit * (1.0 + 1e-9), "{creepage:?}");
            if !problem.operator().is_coupled() {
                let reversed = load(Creepage { along: -along, across: -across, spin: -spin });
                let off = [own.f_x + reversed.f_x, own.f_y + reversed.f_y, own.m_z + reversed.m_z];
                assert!(off.iter().all(|off| off.abs() < 1e-8 * limit), "{creepage:?}: {off:?}");
                // Friction takes, never gives.
                let power = own.f_x * along + own.f_y * across + own.m_z * spin;
                assert!(power >= -1e-12 * limit, "{creepage:?}: {power}");
            }
        }
    }
}

#[test]
fn random_rolling_on_tends_to_steady_rolling() {
    let problem = sphere(10, [0.3, 0.3]);
    let distance = problem.grid().dx();
    for creepage in creepages(3, 12) {
        // Larger ones slide at once.
        let creepage = Creepage {
            along: creepage.along.clamp(-0.5, 0.5),
            across: creepage.across.clamp(-0.5, 0.5),
            spin: creepage.spin.clamp(-2.0, 2.0),
        };
        let steady = roll_steadily(&problem, Driven::Shift(1.0), distance, creepage).unwrap();
        let way = Way::new(distance).unwrap();
        let (a, b) = (roll_on(&problem, way, creepage, 140).load(), steady.state.load());
        let off = (a.f_x - b.f_x).hypot(a.f_y - b.f_y) / (FRICTION * b.f_z);
        assert!(off < 1e-8, "{creepage:?}: {off:.1e}");
    }
}

/// Both halves slide far, against each other: there is no force, and the heat of both.
#[test]
fn where_creepages_vary_each_part_slides_its_own_way() {
    let problem = sphere(16, [0.3, 0.3]);
    let grid = problem.grid();
    let along = Field::from_function(grid, |_, y: f64| 10.0 * y.signum());
    let contact = SteadyContact::new(&problem, Way::new(grid.dx()).unwrap()).unwrap();
    let across = Field::uniform(grid, 0.0);
    let mut contact = contact.with_local_creepage(along, across).unwrap();
    let drive = RollingDrive::by_creepage(Driven::Shift(1.0), Creepage::default());
    for _ in 0..2 {
        let rolled = contact.roll(&drive, &mut ()).unwrap();
        let load = rolled.state.load();
        assert!(rolled.slides && load.f_x.abs() < 1e-9 * load.f_z, "{load:?}");
        assert!(load.m_z > 0.0);
        let heat = rolled.heat / (10.0 * FRICTION * load.f_z);
        assert!((heat - 1.0).abs() < 1e-3, "{heat}");
    }
}

/// The motion of a rigid body, told cell by cell, has the forces and the heat of its three creepages.
#[test]
fn a_rigid_motion_may_be_told_by_cell() {
    let problem = sphere(12, [0.0, 0.5]);
    let (grid, still) = (problem.grid(), Creepage::default());
    for (along, across, spin) in
        [(0.05, 0.0, 0.0), (0.0, 0.05, 0.0), (0.0, 0.0, 0.2), (0.03, -0.04, 0.1)]
    {
        let contact = || {
            let contact = SteadyContact::new(&problem, Way::new(grid.dx()).unwrap()).unwrap();
            contact.within(1e-10).unwrap()
        };
        let by_cell = contact().with_local_creepage(
            Field::from_function(grid, |_, y| along + spin * y),
            Field::from_function(grid, |x, _| across - spin * x),
        );
        let [one, two] = [(contact(), Creepage { along, across, spin }), (by_cell.unwrap(), still)]
            .map(|(mut contact, creepage)| {
                let drive = RollingDrive::by_creepage(Driven::Shift(1.0), creepage);
                contact.roll(&drive, &mut ()).unwrap()
            });
        let (load, other) = (one.state.load(), two.state.load());
        let size = FRICTION * load.f_z;
        for off in [load.f_x - other.f_x, load.f_y - other.f_y, load.m_z - other.m_z] {
            assert!(off.abs() < 1e-7 * size, "{load:?} {other:?}");
        }
        assert!(
            one.heat > 0.0 && (one.heat - two.heat).abs() < 1e-6 * one.heat,
            "{} {}",
            one.heat,
            two.heat
        );
    }
}

#[test]
fn creepages_that_vary_are_finite_and_on_the_grid() {
    let problem = sphere(8, [0.3, 0.3]);
    let grid = problem.grid();
    let contact = SteadyContact::new(&problem, Way::new(grid.dx()).unwrap()).unwrap();
    let fine = || Field::uniform(grid, 0.01);
    let other = Field::uniform(Grid::new(3, 3, 0.1, 0.1).unwrap(), 0.01);
    for (along, across, name) in
        [(other, fine(), "creepage"), (fine(), Field::uniform(grid, f64::NAN), "creepage_across")]
    {
        let error = contact.clone().with_local_creepage(along, across).err().unwrap();
        assert!(matches!(error, RollingError::Range(range) if range.field == name), "{name}");
    }
}

/// Bodies apart neither stick nor slide; pressed together with much creepage they slide.
#[test]
fn bodies_apart_do_not_slide() {
    let problem = sphere(12, [0.3, 0.3]);
    let creepage = Creepage { along: 0.5, across: 0.2, spin: 0.1 };
    let rolled = |approach: f64| {
        roll_steadily(&problem, Driven::Shift(approach), problem.grid().dx(), creepage).unwrap()
    };
    let apart = rolled(-0.1);
    assert!(!apart.slides && apart.state.load().f_z == 0.0 && apart.state.load().f_x == 0.0);
    assert!(rolled(1.0).slides);
}
