//! Rolling: a curve of 21 creepages on 40 x 40 elements, one creepage on finer grids, and a
//! transient of 56 steps by a given force on 34 x 33 elements.
//!
//! A sphere on a sphere, nu = 0.28, f = 0.3, creepages from zero to 1.5 times that of full sliding
//! with spin. `cargo bench -p carom-benches --bench rolling` measures them; the growth with the
//! number of cells follows from the second group.

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_rolling::{Creepage, RollingContact, RollingDrive, SteadyContact, Way};
use carom_solver::{ContactProblem, ContactState, Driven, Gap};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// The normal force of a contact of radius 1 for G = 1 and nu = 0.28.
const FORCE: f64 = 8.0 / 3.0 / (1.0 - 0.28) / 2.0;
const FRICTION: f64 = 0.3;

/// A circle of radius 1 with so many elements along and across.
fn sphere([along, across]: [usize; 2]) -> ContactProblem {
    let [dx, dy] = [along, across].map(|count| 2.0 / count as f64);
    let grid = Grid::new(along + 4, across + 2, dx, dy).expect("positive");
    let gap = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y)).expect("finite");
    let body = Material::from_shear(1.0, 0.28).expect("in range");
    let pair = MaterialPair::new(body, body).expect("elastic");
    let friction = Friction::new(FRICTION).expect("positive");
    ContactProblem::of_half_spaces(gap, pair, friction).expect("fits into memory")
}

fn way(problem: &ContactProblem) -> Way {
    Way::new(problem.grid().dx()).expect("positive")
}

fn roll(contact: &mut SteadyContact, creepage: Creepage) -> f64 {
    let drive = RollingDrive::by_creepage(Driven::Load(FORCE), creepage);
    contact.roll(&drive, &mut ()).expect("converges").state.load().f_x
}

fn curve() -> f64 {
    let problem = sphere([40, 40]);
    let mut contact = SteadyContact::new(&problem, way(&problem)).expect("fits");
    let along = (0..=20).map(|number| 0.03 * f64::from(number));
    along.map(|along| roll(&mut contact, Creepage { along, across: 0.0, spin: 0.1 })).sum()
}

fn one(elements: usize) -> f64 {
    let problem = sphere([elements, elements]);
    let mut contact = SteadyContact::new(&problem, way(&problem)).expect("fits");
    roll(&mut contact, Creepage { along: 0.15, across: 0.05, spin: 0.1 })
}

fn transient() -> f64 {
    let problem = sphere([34, 33]);
    let mut contact = RollingContact::new(&problem, way(&problem)).expect("fits");
    let free = RollingDrive::by_creepage(Driven::Load(FORCE), Creepage::default());
    let mut state = ContactState::apart(problem.grid());
    for number in 1..=56 {
        let part = 0.7 * f64::from(number.min(28)) / 28.0;
        let drive = RollingDrive { along: Driven::Load(part * FRICTION * FORCE), ..free };
        let before = state.clone();
        contact.step(&drive, &before, &mut state, &mut ()).expect("converges");
    }
    state.shift.xi
}

fn rolling(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("rolling");
    group.sample_size(10);
    group.bench_function("curve of 21 creepages, 40 x 40", |bench| bench.iter(curve));
    group.bench_function("transient of 56 steps by force, 34 x 33", |bench| bench.iter(transient));
    for elements in [50, 100, 200, 400] {
        group.bench_with_input(
            BenchmarkId::new("one creepage", elements),
            &elements,
            |bench, n| {
                bench.iter(|| one(*n));
            },
        );
    }
    group.finish();
}

criterion_group!(benches, rolling);
criterion_main!(benches);
