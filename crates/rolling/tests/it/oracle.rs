//! The same tractions by other ways: by the direct methods of 1992, by forces for creepages, mirrored,
//! reversed, and in other units.

use std::f64::consts::PI;

use carom_classic::kalker::{KalkerScratch, Panagiotopoulos};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_rolling::{Creepage, RollingDrive, RollingError, SteadyContact, SteadyRolling, Way};
use carom_solver::{
    CellFriction, ContactProblem, ContactState, Drive, Driven, FrictionalError, Gap, Method as _,
};

const FRICTION: f64 = 0.3;

/// An ellipsoid with these lengths and moduli as units.
fn ellipsoid(poisson: [f64; 2], [length, modulus]: [f64; 2]) -> ContactProblem {
    let grid = Grid::new(15, 12, 0.17 * length, 0.2 * length).unwrap();
    let gap = Gap::from_function(grid, |x, y| (0.5 * x * x + 0.4 * y * y) / length).unwrap();
    let [one, two] = poisson.map(|nu| Material::from_shear(modulus, nu).unwrap());
    let pair = MaterialPair::new(one, two).unwrap();
    ContactProblem::of_half_spaces(gap, pair, Friction::new(FRICTION).unwrap()).unwrap()
}

fn roll(problem: &ContactProblem, way: Way, drive: &RollingDrive) -> SteadyRolling {
    let mut contact = SteadyContact::new(problem, way).unwrap().within(1e-11).unwrap();
    contact.roll(drive, &mut ()).unwrap()
}

const CREEPAGES: [[f64; 3]; 6] = [
    [0.01, 0.0, 0.0],
    [0.08, 0.03, -0.05],
    [0.0, 0.0, 0.2],
    [-0.15, 0.1, 0.1],
    [0.6, 0.1, 0.0],
    [0.02, -0.03, 1.5],
];

fn creepage([along, across, spin]: [f64; 3]) -> Creepage {
    Creepage { along, across, spin }
}

#[test]
fn tractions_are_those_of_the_direct_methods() {
    for poisson in [[0.3, 0.3], [0.0, 0.45]] {
        let problem = ellipsoid(poisson, [1.0; 2]);
        let grid = problem.grid();
        for columns in [1.0, 2.0] {
            let way = Way::new(columns * grid.dx()).unwrap();
            for [along, across, spin] in CREEPAGES {
                let drive =
                    RollingDrive::by_creepage(Driven::Shift(0.8), creepage([along, across, spin]));
                let rolled = roll(&problem, way, &drive);
                let apart = ContactState::apart(grid);
                let mut direct = apart.clone();
                let length = way.length();
                let drive = Drive::by_shift(Shift {
                    zeta: 0.8,
                    xi: along * length,
                    eta: across * length,
                    omega: spin * length,
                });
                let method = Panagiotopoulos::default().within(1e-11).unwrap();
                let mut scratch = KalkerScratch::rolling(&problem, columns).unwrap();
                method.step(&problem, &apart, &drive, &mut direct, &mut scratch, &mut ()).unwrap();
                let most = direct.pressure.values().iter().copied().fold(0.0, f64::max);
                let pairs = [
                    (&rolled.state.pressure, &direct.pressure, most),
                    (&rolled.state.traction_x, &direct.traction_x, FRICTION * most),
                    (&rolled.state.traction_y, &direct.traction_y, FRICTION * most),
                ];
                for (got, want, scale) in pairs {
                    for (got, want) in got.values().iter().zip(want.values()) {
                        assert!((got - want).abs() < 1e-8 * scale, "{along} {across} {spin}");
                    }
                }
                assert_eq!(rolled.state.cells, direct.cells, "{along} {across} {spin}");
            }
        }
    }
}

#[test]
fn forces_lead_to_their_creepages() {
    for poisson in [[0.3, 0.3], [0.0, 0.45]] {
        let problem = ellipsoid(poisson, [1.0; 2]);
        let dx = problem.grid().dx();
        for (angle, spin_at) in [(0.0, 0.0), (0.7, 0.0), (PI, 1.0 / 6.0)] {
            let way = Way::new(dx).unwrap().towards(angle).unwrap();
            let way = way.with_spin_at(spin_at).unwrap();
            for parts in CREEPAGES.into_iter().take(4) {
                let given = creepage(parts);
                let normal = Driven::Load(1.5);
                let want = roll(&problem, way, &RollingDrive::by_creepage(normal, given));
                let load = want.state.load();
                let free = RollingDrive::by_creepage(normal, given);
                let along = RollingDrive { along: Driven::Load(load.f_x), ..free };
                let both = RollingDrive { across: Driven::Load(load.f_y), ..along };
                let all = RollingDrive { spin: Driven::Load(load.m_z), ..both };
                for drive in [along, both, all] {
                    let got = roll(&problem, way, &drive);
                    let own = got.state.load();
                    let off = [own.f_x - load.f_x, own.f_y - load.f_y, own.m_z - load.m_z];
                    let scale = FRICTION * load.f_z;
                    assert!(off.iter().all(|off| off.abs() < 1e-8 * scale), "{drive:?}: {off:?}");
                    let found = got.creepage;
                    let off = [
                        found.along - given.along,
                        found.across - given.across,
                        found.spin - given.spin,
                    ];
                    assert!(off.iter().all(|off| off.abs() < 1e-8), "{drive:?}: {off:?}");
                }
            }
        }
    }
}

#[test]
fn forces_beyond_friction_and_two_frictions_are_refused() {
    let problem = ellipsoid([0.3, 0.3], [1.0; 2]);
    let way = Way::new(problem.grid().dx()).unwrap();
    let mut contact = SteadyContact::new(&problem, way).unwrap();
    let free = RollingDrive::by_creepage(Driven::Load(1.0), Creepage::default());
    for (x, y) in [(0.31, 0.0), (0.25, 0.2), (0.0, -0.301)] {
        let drive = RollingDrive { along: Driven::Load(x), across: Driven::Load(y), ..free };
        let error = contact.roll(&drive, &mut ()).unwrap_err();
        let slides = matches!(error, RollingError::Step(FrictionalError::Slides { .. }));
        assert!(slides, "{error}");
    }
    let below = RollingDrive { along: Driven::Load(0.2999), ..free };
    assert!(contact.roll(&below, &mut ()).is_ok());
    let [rest, motion] = [0.4, 0.3].map(|friction| Friction::new(friction).unwrap());
    let two = CellFriction::new(rest, motion).unwrap();
    let operator = problem.shared_operator().clone();
    let problem = ContactProblem::new(problem.gap().clone(), operator, two).unwrap();
    let error = SteadyContact::new(&problem, way).err().unwrap();
    assert!(matches!(error, RollingError::TwoFrictions { rest: 0.4, motion: 0.3 }), "{error}");
    let about = way.with_spin_at(0.5).unwrap();
    let turned = RollingDrive { spin: Driven::Load(0.01), ..free };
    let problem = ellipsoid([0.3, 0.3], [1.0; 2]);
    let error = SteadyContact::new(&problem, about).unwrap().roll(&turned, &mut ()).unwrap_err();
    assert!(matches!(error, RollingError::Range(e) if e.field == "spin offset"));
}

/// The contact turned by a quarter turn towards +y, with the direction of rolling and the creepages.
#[test]
fn quarter_turns_turn_the_forces() {
    for poisson in [[0.3, 0.3], [0.0, 0.45]] {
        let problem = ellipsoid(poisson, [1.0; 2]);
        let grid = problem.grid();
        let turned = Grid::new(grid.ny(), grid.nx(), grid.dy(), grid.dx()).unwrap();
        let gap = Gap::from_function(turned, |x, y| 0.5 * y * y + 0.4 * x * x).unwrap();
        let [one, two] = poisson.map(|nu| Material::from_shear(1.0, nu).unwrap());
        let pair = MaterialPair::new(one, two).unwrap();
        let friction = Friction::new(FRICTION).unwrap();
        let turned = ContactProblem::of_half_spaces(gap, pair, friction).unwrap();
        let way = Way::new(grid.dx()).unwrap().with_spin_at(1.0 / 6.0).unwrap();
        let up = way.towards(0.5 * PI).unwrap();
        for [along, across, spin] in CREEPAGES {
            let at = |problem, way, creepages| {
                let normal = Driven::Shift(0.8);
                let drive = RollingDrive::by_creepage(normal, creepage(creepages));
                roll(problem, way, &drive).state.load()
            };
            let load = at(&problem, way, [along, across, spin]);
            let other = at(&turned, up, [-across, along, spin]);
            let off = [other.f_x + load.f_y, other.f_y - load.f_x, other.m_z - load.m_z];
            let scale = FRICTION * load.f_z;
            assert!(off.iter().all(|off| off.abs() < 1e-8 * scale), "{along} {across}: {off:?}");
        }
    }
}

/// The contact turned by half a turn with the direction of rolling, and in other units.
#[test]
fn half_turns_and_units_change_nothing() {
    for poisson in [[0.3, 0.3], [0.0, 0.45]] {
        let problem = ellipsoid(poisson, [1.0; 2]);
        let way = Way::new(problem.grid().dx()).unwrap().with_spin_at(1.0 / 6.0).unwrap();
        let back = way.towards(PI).unwrap();
        // Powers of two change no digit.
        let units = [1024.0, 4096.0];
        let large = ellipsoid(poisson, units);
        let way_there = Way::new(large.grid().dx()).unwrap().with_spin_at(1.0 / 6.0).unwrap();
        for [along, across, spin] in CREEPAGES {
            let normal = Driven::Shift(0.8);
            let load = roll(
                &problem,
                way,
                &RollingDrive::by_creepage(normal, creepage([along, across, spin])),
            )
            .state
            .load();
            let turned = creepage([-along, -across, spin]);
            let other =
                roll(&problem, back, &RollingDrive::by_creepage(normal, turned)).state.load();
            let scale = FRICTION * load.f_z;
            let off = [load.f_x + other.f_x, load.f_y + other.f_y, load.m_z - other.m_z];
            assert!(off.iter().all(|off| off.abs() < 1e-8 * scale), "{along} {across}: {off:?}");
            let there = RollingDrive::by_creepage(
                Driven::Shift(0.8 * units[0]),
                creepage([along, across, spin / units[0]]),
            );
            let there = roll(&large, way_there, &there).state.load();
            let unit = units[0] * units[0] * units[1];
            let off = [there.f_x / unit - load.f_x, there.f_y / unit - load.f_y];
            assert!(off.iter().all(|off| off.abs() < 1e-12 * scale), "{along} {across}: {off:?}");
        }
    }
}
