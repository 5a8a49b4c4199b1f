//! Rolling, as ratios of times of one run: a curve of 21 creepages on 40 x 40 elements, one creepage
//! on finer grids, and a transient of 56 steps by a given force on 34 x 33 elements; beside them a
//! product with the influence and the inverse on the same grids, and Kalker's method by elimination.
//!
//! A sphere on a sphere, nu = 0.28, f = 0.3. Each round runs every job once, so that other load on
//! the machine strikes all of them; of each the least time counts.
//! `cargo bench -p carom-benches --bench rolling -- 5` runs five rounds.

use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use carom_classic::kalker::{KalkerScratch, Panagiotopoulos};
use carom_halfspace::operator::{
    DisplacementField, RolledOperator, SurfaceOperator as _, Threads, TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_rolling::{Creepage, RollingContact, RollingDrive, SteadyContact, Way};
use carom_solver::{ContactProblem, ContactState, Drive, Driven, Gap, Method as _, Products};

/// The normal force of a contact of radius 1 for G = 1 and nu = 0.28.
const FORCE: f64 = 8.0 / 3.0 / (1.0 - 0.28) / 2.0;
const FRICTION: f64 = 0.3;
const CREEPAGE: Creepage = Creepage { along: 0.15, across: 0.05, spin: 0.1 };
/// Elements across the contact of one creepage.
const SIDES: [usize; 4] = [50, 100, 200, 400];
/// The same for the method by elimination, whose matrices have twice as many rows as the contact
/// has elements.
const ELIMINATED: usize = 24;
/// Cells of all products of a measurement, about.
const MEASURED: usize = 1_000_000;

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

fn roll(contact: &mut SteadyContact, creepage: Creepage) -> Products {
    let drive = RollingDrive::by_creepage(Driven::Load(FORCE), creepage);
    contact.roll(&drive, &mut ()).expect("converges").convergence.products
}

fn curve() -> Products {
    let problem = sphere([40, 40]);
    let mut contact = SteadyContact::new(&problem, way(&problem)).expect("fits");
    let along = (0..=20).map(|number| 0.03 * f64::from(number));
    let creepages = along.map(|along| Creepage { along, across: 0.0, spin: 0.1 });
    creepages.fold(Products::default(), |sum, creepage| sum.plus(roll(&mut contact, creepage)))
}

fn one(elements: usize) -> Products {
    let problem = sphere([elements, elements]);
    let mut contact = SteadyContact::new(&problem, way(&problem)).expect("fits");
    roll(&mut contact, CREEPAGE)
}

fn transient() -> Products {
    let problem = sphere([34, 33]);
    let mut contact = RollingContact::new(&problem, way(&problem)).expect("fits");
    let free = RollingDrive::by_creepage(Driven::Load(FORCE), Creepage::default());
    let mut state = ContactState::apart(problem.grid());
    let mut products = Products::default();
    for number in 1..=56 {
        let part = 0.7 * f64::from(number.min(28)) / 28.0;
        let drive = RollingDrive { along: Driven::Load(part * FRICTION * FORCE), ..free };
        let before = state.clone();
        let went = contact.step(&drive, &before, &mut state, &mut ()).expect("converges");
        products = products.plus(went.products);
    }
    products
}

/// One creepage by elimination of the influence of all elements in contact.
fn eliminated() -> Products {
    let problem = sphere([ELIMINATED, ELIMINATED]);
    let apart = ContactState::apart(problem.grid());
    let (mut state, length) = (apart.clone(), problem.grid().dx());
    let mut scratch = KalkerScratch::rolling(&problem, 1.0).expect("fits");
    let shift = Shift {
        zeta: 1.0,
        xi: length * CREEPAGE.along,
        eta: length * CREEPAGE.across,
        omega: length * CREEPAGE.spin,
    };
    let method = Panagiotopoulos::default();
    method
        .step(&problem, &apart, &Drive::by_shift(shift), &mut state, &mut scratch, &mut ())
        .expect("converges")
        .products
}

/// A job and the least time that it took.
struct Job {
    name: String,
    run: Box<dyn FnMut() -> Products>,
    /// Times the work is done in one run.
    repeated: usize,
    products: Products,
    seconds: f64,
}

impl Job {
    fn new(name: impl Into<String>, run: impl FnMut() -> Products + 'static) -> Self {
        let (products, seconds) = (Products::default(), f64::INFINITY);
        Self { name: name.into(), run: Box::new(run), repeated: 1, products, seconds }
    }

    /// Tangential products and inverses of a step of rolling, in turn.
    fn product(elements: [usize; 2]) -> Self {
        let problem = sphere(elements);
        let body = Arc::clone(problem.shared_operator());
        let rolled = RolledOperator::new(body, way(&problem).ahead(), Threads::One).expect("fits");
        let (mut workspace, inverse) = (rolled.workspace(), rolled.inverse().expect("has one"));
        let cells = problem.grid().cells();
        let load: Vec<f64> = (0..cells).map(|cell| (0.1 * cell as f64).sin()).collect();
        let [mut u, mut v, mut x, mut y] = [(); 4].map(|()| vec![0.0; cells]);
        let repeated = (MEASURED / cells).max(1);
        let run = move || {
            for _ in 0..repeated {
                let tractions = TractionField::tangential(&load, &load);
                let out = DisplacementField::tangential(&mut u, &mut v);
                rolled.apply(tractions, out, &mut workspace).expect("finite");
                inverse.traction(
                    [Some(&u), Some(&v)],
                    [Some(&mut x), Some(&mut y)],
                    &mut workspace,
                );
                black_box((&x, &y));
            }
            Products { tangential: 1.0, preconditioner: 1.0, ..Products::default() }
        };
        let [along, across] = elements;
        let name = format!("product and inverse, {along} x {across}");
        Self { repeated, ..Self::new(name, run) }
    }

    fn measure(&mut self) {
        let begin = Instant::now();
        self.products = (self.run)();
        let seconds = begin.elapsed().as_secs_f64() / self.repeated as f64;
        self.seconds = self.seconds.min(seconds);
    }
}

/// Prints a job: its time over that of a product with its inverse on the same grid, and over that
/// of another job.
fn report(job: &Job, product: &Job, than: Option<&Job>) {
    let Products { tangential, .. } = job.products;
    let [times, over] =
        [Some(product), than].map(|other| other.map(|other| job.seconds / other.seconds));
    let growth = over.map_or(String::new(), |over| format!("{over:.2}"));
    println!(
        "{:38} {:>10.2} ms {tangential:>9.0} {:>15.0} {growth:>12}",
        job.name,
        1e3 * job.seconds,
        times.unwrap_or_default(),
    );
}

fn main() {
    let rounds = std::env::args().find_map(|argument| argument.parse().ok()).unwrap_or(3);
    let mut products: Vec<Job> = [[40, 40], [34, 33], [ELIMINATED; 2]]
        .into_iter()
        .chain(SIDES.map(|side| [side, side]))
        .map(Job::product)
        .collect();
    let mut jobs = vec![
        Job::new("curve of 21 creepages, 40 x 40", curve),
        Job::new("transient of 56 steps by force, 34 x 33", transient),
        Job::new("one creepage, 24 x 24, by elimination", eliminated),
        Job::new("one creepage, 24 x 24", || one(ELIMINATED)),
    ];
    for side in SIDES {
        jobs.push(Job::new(format!("one creepage, {side} x {side}"), move || one(side)));
    }
    for _ in 0..rounds {
        products.iter_mut().chain(&mut jobs).for_each(Job::measure);
    }
    println!(
        "{:38} {:>13} {:>9} {:>15} {:>12}",
        "job", "least time", "products", "over a product", "over the last"
    );
    for (place, product) in products.iter().enumerate() {
        let before = place.checked_sub(1).filter(|_| place > 3).map(|before| &products[before]);
        report(product, product, before);
    }
    let places = [0, 1, 2, 2].into_iter().chain(3..products.len());
    for (place, (job, product)) in jobs.iter().zip(places).enumerate() {
        let before = place.checked_sub(1).filter(|_| place == 3 || place > 4);
        report(job, &products[product], before.map(|before| &jobs[before]));
    }
}
