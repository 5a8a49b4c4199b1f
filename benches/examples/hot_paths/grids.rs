//! Contacts on a grid: coefficients, products, inverses, solves, a step of rolling.

use std::sync::Arc;

use carom_halfspace::operator::{
    Blocks, CoefficientTable, DisplacementField, HalfSpaceOperator, SurfaceOperator as _, Threads,
    TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingDrive, SteadyContact, Way};
use carom_solver::{
    ContactProblem, ContactState, Drive, Driven, Frictional, Frictionless, Gap, Method, Shape,
};

use crate::{HotPath, Work};

pub(crate) const PATHS: &[HotPath] = &[
    ("coefficients_32", coefficients),
    ("product_normal_64", product_normal),
    ("product_all_64", product_all),
    ("inverse_normal_64", inverse_normal),
    ("inverse_tangential_64", inverse_tangential),
    ("hertz_64", hertz),
    ("cattaneo_64", cattaneo),
    ("shift_back_64", shift_back),
    ("rolling_24", rolling),
];

const CELLS: usize = 64;
const REPEATED: usize = 10;
/// Force of a contact of radius 1: R = 100, G = 80000, nu = 0.28.
const FORCE: f64 = 4.0 / 3.0 * 80_000.0 / 0.72 / 100.0;
/// Half of the shift at which it slides, f = 0.4.
const SHIFT: f64 = 0.5 * 3.0 * 0.4 * FORCE * 1.72 / (8.0 * 80_000.0);

fn dissimilar() -> MaterialPair {
    let steel = Material::from_young(208e3, 0.3).expect("a material");
    let glass = Material::from_young(70e3, 0.2).expect("a material");
    MaterialPair::new(steel, glass).expect("a pair")
}

fn square(cells: usize) -> Grid {
    Grid::new(cells, cells, 0.01, 0.01).expect("a grid")
}

fn operator(blocks: Blocks) -> HalfSpaceOperator {
    HalfSpaceOperator::with_blocks(dissimilar(), square(CELLS), blocks, Threads::One)
        .expect("fits into memory")
}

/// A field without symmetry.
fn field() -> Vec<f64> {
    (0..CELLS * CELLS).map(|cell| 1.0 + (0.1 * cell as f64).sin()).collect()
}

fn coefficients() -> Work {
    Box::new(|| {
        let table = CoefficientTable::new(dissimilar(), square(32));
        f64::from(u8::from(std::hint::black_box(table).is_ok()))
    })
}

fn product_normal() -> Work {
    let operator = operator(Blocks::Normal);
    let (mut workspace, load, mut w) = (operator.workspace(), field(), field());
    Box::new(move || {
        for _ in 0..REPEATED {
            let into = DisplacementField::normal(&mut w);
            operator.apply(TractionField::normal(&load), into, &mut workspace).expect("finite");
        }
        w.iter().sum()
    })
}

fn product_all() -> Work {
    let operator = operator(Blocks::All);
    let (mut workspace, load) = (operator.workspace(), field());
    let [mut u, mut v, mut w] = [(); 3].map(|()| field());
    Box::new(move || {
        for _ in 0..REPEATED {
            let into = DisplacementField::full(&mut u, &mut v, &mut w);
            let load = TractionField::full(&load, &load, &load);
            operator.apply(load, into, &mut workspace).expect("finite");
        }
        u.iter().chain(&v).chain(&w).sum()
    })
}

fn inverse_normal() -> Work {
    let operator = operator(Blocks::Normal);
    let inverse = operator.inverse().expect("a half-space has one");
    let (mut workspace, given, mut pressure) = (operator.workspace(), field(), field());
    Box::new(move || {
        for _ in 0..REPEATED {
            inverse.pressure(&given, &mut pressure, &mut workspace);
        }
        pressure.iter().sum()
    })
}

fn inverse_tangential() -> Work {
    let operator = operator(Blocks::All);
    let inverse = operator.inverse().expect("a half-space has one");
    let (mut workspace, given) = (operator.workspace(), field());
    let [mut x, mut y] = [(); 2].map(|()| field());
    Box::new(move || {
        for _ in 0..REPEATED {
            let into = [Some(&mut x[..]), Some(&mut y[..])];
            inverse.traction([Some(&given), Some(&given)], into, &mut workspace);
        }
        x.iter().chain(&y).sum()
    })
}

/// A ball of contact radius 1 in a window of 2.4.
fn ball(blocks: Blocks, friction: f64) -> ContactProblem {
    let width = 2.4 / CELLS as f64;
    let grid = Grid::new(CELLS, CELLS, width, width).expect("a grid");
    let body = Material::from_shear(80_000.0, 0.28).expect("in range");
    let pair = MaterialPair::new(body, body).expect("a pair");
    let gap = Gap::of_shape(grid, &Shape::Paraboloid { radii: [100.0; 2] }).expect("finite");
    let operator = HalfSpaceOperator::with_blocks(pair, grid, blocks, Threads::One);
    let operator = Arc::new(operator.expect("fits into memory"));
    let friction = Friction::new(friction).expect("positive");
    ContactProblem::new(gap, operator, friction).expect("of one grid")
}

fn pressed() -> Drive {
    Drive { normal: Driven::Load(FORCE), ..Drive::default() }
}

fn hertz() -> Work {
    let problem = ball(Blocks::Normal, 0.0);
    let method = Frictionless::default();
    let mut scratch = method.scratch(&problem).expect("fits");
    let apart = ContactState::apart(problem.grid());
    let mut state = apart.clone();
    Box::new(move || {
        method
            .step(&problem, &apart, &pressed(), &mut state, &mut scratch, &mut ())
            .expect("converges");
        state.shift.zeta
    })
}

/// Steps with friction, of which those after `uncounted` count.
fn shifted(uncounted: usize, shifts: &'static [f64]) -> Work {
    let problem = ball(Blocks::All, 0.4);
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem).expect("fits");
    let mut state = ContactState::apart(problem.grid());
    let mut step = move |&xi: &f64| {
        let (from, drive) = (state.clone(), Drive { x: Driven::Shift(xi), ..pressed() });
        method.step(&problem, &from, &drive, &mut state, &mut scratch, &mut ()).expect("converges");
        state.load().f_x
    };
    let (before, counted) = shifts.split_at(uncounted);
    for xi in before {
        step(xi);
    }
    Box::new(move || counted.iter().map(&mut step).sum())
}

fn cattaneo() -> Work {
    shifted(0, &[0.0, SHIFT])
}

fn shift_back() -> Work {
    shifted(2, &[0.0, SHIFT, 0.8 * SHIFT, 0.6 * SHIFT])
}

fn rolling() -> Work {
    let width = 2.0 / 24.0;
    let grid = Grid::new(28, 26, width, width).expect("a grid");
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).expect("finite");
    let body = Material::from_shear(1.0, 0.28).expect("in range");
    let pair = MaterialPair::new(body, body).expect("a pair");
    let friction = Friction::new(0.3).expect("positive");
    let problem = ContactProblem::of_half_spaces(gap, pair, friction).expect("fits into memory");
    let way = Way::new(width).expect("positive");
    let mut contact = SteadyContact::new(&problem, way).expect("fits");
    let creepage = Creepage { along: 0.15, across: 0.05, spin: 0.1 };
    let force = Driven::Load(8.0 / 3.0 / 0.72 / 2.0);
    Box::new(move || {
        let drive = RollingDrive::by_creepage(force, creepage);
        contact.roll(&drive, &mut ()).expect("converges").state.load().f_x
    })
}
