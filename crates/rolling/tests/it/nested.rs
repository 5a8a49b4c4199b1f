//! Steady rolling as a method: its estimated errors against finer grids, its way on a grid.

use std::f64::consts::FRAC_PI_2;

use carom_halfspace::operator::OperatorError;
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingDrive, SteadyContact, SteadyMethod};
use carom_solver::{ContactProblem, Driven, Estimated, Gap, NestedHistory, ProblemError};

fn problem(pair: MaterialPair, ratio: f64, grid: Grid) -> Result<ContactProblem, ProblemError> {
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + ratio * y * y));
    let friction = Friction::new(0.3).map_err(OperatorError::from)?;
    ContactProblem::of_half_spaces(gap.map_err(OperatorError::from)?, pair, friction)
}

/// A grid over the contact of force 2 with this many cells.
fn grid(cells: usize) -> Grid {
    Grid::new(cells, cells, 3.4 / cells as f64, 3.4 / cells as f64).unwrap()
}

/// Ten contacts, alike and unlike, by creepages and forces, in several directions.
#[test]
fn estimated_errors_cover_those_against_a_finer_grid() {
    let material = |shear, poisson| Material::from_shear(shear, poisson).unwrap();
    let (steel, soft) = (material(1.0, 0.3), material(0.4, 0.15));
    let (mut over, mut count, mut widest) = (0, 0, 0.0_f64);
    for case in 0..10 {
        let part = f64::from(case) / 10.0;
        let pair = MaterialPair::new(steel, if case % 2 == 0 { steel } else { soft }).unwrap();
        // A direction off the axes takes most of the time.
        let direction = if case == 5 { 0.7 } else { f64::from(case / 2) * FRAC_PI_2 };
        let method = SteadyMethod::default().towards(direction).unwrap();
        let creepage = Creepage {
            along: 0.05 + 0.15 * part,
            across: 0.1 * (part - 0.4),
            spin: 0.2 * (0.5 - part),
        };
        let mut drive = RollingDrive::by_creepage(Driven::Load(2.0), creepage);
        if case % 3 == 0 {
            drive.along = Driven::Load(0.2 + 0.2 * part);
        }
        let make = |grid| problem(pair, 1.0 + part, grid);
        let mut coarse = NestedHistory::new(method, grid(32), make).unwrap();
        coarse.step(&drive.into(), &mut ()).unwrap();
        let fine_grid = grid(96);
        let mut fine = SteadyContact::new(
            &problem(pair, 1.0 + part, fine_grid).unwrap(),
            method.way(fine_grid).unwrap(),
        )
        .unwrap();
        let fine = fine.roll(&drive, &mut ()).unwrap();
        let (bars, load) = (coarse.estimates().unwrap(), fine.state.load());
        let limit = 0.6;
        let mut check = |name: &str, bar: Estimated, exact: f64, scale: f64| {
            let off = (bar.value - exact).abs();
            if off < 1e-4 * scale {
                return;
            }
            count += 1;
            over += usize::from(off > bar.error);
            widest = widest.max(bar.error / scale);
            if off > bar.error {
                eprintln!("{case} {name}: {off:e} {:e} {scale}", bar.error);
            }
            assert!(off < 4.0 * bar.error, "{case} {name}: {off:e} {:e}", bar.error);
        };
        check("F_x", bars.f_x, load.f_x, limit);
        check("F_y", bars.f_y, load.f_y, limit);
        check("M_z", bars.m_z, load.m_z, limit);
        check("zeta", bars.zeta, fine.state.shift.zeta, 1.0);
        if case % 3 == 0 {
            check("creepage", bars.xi, fine.creepage.along, 0.1);
        }
    }
    assert!(count > 25 && over <= count / 5, "{over} of {count}");
    assert!(widest < 0.2, "{widest}");
}

#[test]
fn a_step_is_as_long_as_a_cell_in_the_direction_of_rolling() {
    let grid = Grid::new(8, 8, 0.3, 0.4).unwrap();
    let of =
        |direction: f64| SteadyMethod::default().towards(direction).unwrap().way(grid).unwrap();
    for (direction, length) in
        [(0.0, 0.3), (0.5, 0.4), (1.0, 0.3), (1.5, 0.4), (0.25, 0.125_f64.sqrt())]
    {
        let way = of(direction * std::f64::consts::PI);
        assert!((way.length() - length).abs() < 1e-15, "{direction}");
    }
    let given = SteadyMethod::default().in_steps_of(0.05).unwrap().with_spin_at(0.5).unwrap();
    let way = given.way(grid).unwrap();
    assert_eq!((way.length(), way.spin_at()), (0.05, 0.5));
    assert_eq!(given.in_steps_of(0.0).unwrap_err().field, "rolling distance");
    assert_eq!(given.within(1.0).unwrap_err().field, "tolerance");
    assert_eq!(given.towards(f64::INFINITY).unwrap_err().field, "rolling direction");
}
