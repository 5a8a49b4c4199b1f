//! Creep forces of drawn elliptical contacts, by the table, by FASTSIM on 10 x 10 elements and by the solver: how far
//! off the continuum, and time of a force as a ratio to that of FASTSIM in the same run.
//!
//! Like bodies, a/b from 0.1 to 10, nu from 0 to 0.5, creepages of any direction and size. Each round runs every way
//! once; of each the least time counts. `cargo bench -p carom-benches --bench creep_force -- 5` runs five rounds.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::creep::force::{CreepContact, nodes};
use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::hertz::Hertz;
use carom_rolling::{ContinuumForces, Creepage, Fastsim, RollingDrive, SteadyContact, Way};
use carom_solver::{ContactProblem, Driven, Gap};

const FRICTION: f64 = 0.3;
const FORCE: f64 = 1e-3;
const CONTACTS: usize = 40;

/// A contact of shear modulus 1 and ab = 1 with a creepage.
struct Case {
    semi_axes: [f64; 2],
    pair: MaterialPair,
    table: CreepContact,
    creepage: Creepage,
    /// Over f F_z, of the continuum.
    truth: [f64; 2],
}

impl Case {
    fn drawn(mut next: impl FnMut() -> f64) -> Self {
        let (ratio, poisson) = (10_f64.powf(2.0 * next() - 1.0), 0.5 * next());
        let (s, z, turn) = (0.98 * next(), 2.0 * next() - 1.0, TAU * next());
        let (r, flat) = (3.0 * s / (1.0 - s), (1.0 - z * z).sqrt());
        let scaled = [r * flat * turn.cos(), r * flat * turn.sin(), r * z];
        let mut continuum = ContinuumForces::new(ratio, poisson, [48, 54, 96]).expect("in range");
        let [f_x, f_y, _] = continuum.forces(scaled).expect("converges");
        let semi_axes = [ratio.sqrt(), 1.0 / ratio.sqrt()];
        let table = CreepContact::new(semi_axes, 1.0, poisson).expect("in range");
        let scales = nodes::scales(&table.coefficients(), ratio);
        let [along, across, spin] =
            [0, 1, 2].map(|part| FRICTION * FORCE * scaled[part] / scales[part]);
        let body = Material::from_shear(1.0, poisson).expect("in range");
        let pair = MaterialPair::new(body, body).expect("elastic");
        let creepage = Creepage { along, across, spin };
        Self { semi_axes, pair, table, creepage, truth: [f_x, f_y] }
    }

    fn by_table(&self) -> [f64; 2] {
        let Creepage { along, across, spin } = self.creepage;
        let found = self.table.force(FRICTION, FORCE, [along, across, spin]).expect("in range");
        [found.f_x, found.f_y]
    }

    fn by_springs(&self) -> [f64; 2] {
        let fastsim = Fastsim {
            semi_axes: self.semi_axes,
            shear_modulus: 1.0,
            coefficients: self.table.coefficients(),
            force: FORCE,
            friction: FRICTION,
            mesh: [10, 10],
        };
        let found = fastsim.forces(self.creepage).expect("in range");
        [found.f_x, found.f_y]
    }

    fn solved(&self, mesh: usize) -> [f64; 2] {
        let [a, b] = self.semi_axes;
        let ellipse = ContactEllipse::new(a, b).expect("positive");
        let hertz = Hertz::from_ellipse_and_force(ellipse, FORCE, self.pair).expect("an ellipse");
        let [dx, dy] = [a, b].map(|axis| 2.0 * axis / mesh as f64);
        let grid = Grid::new(mesh + 3, mesh + 3, dx, dy).expect("positive");
        let gap = Gap::from_function(grid, |x, y| hertz.curvature().gap(x, y)).expect("finite");
        let friction = Friction::new(FRICTION).expect("positive");
        let problem = ContactProblem::of_half_spaces(gap, self.pair, friction).expect("fits");
        let way = Way::new(dx).expect("positive");
        let mut contact = SteadyContact::new(&problem, way).expect("fits");
        let drive = RollingDrive::by_creepage(Driven::Load(FORCE), self.creepage);
        let load = contact.roll(&drive, &mut ()).expect("converges").state.load();
        [load.f_x, load.f_y]
    }

    fn off(&self, [f_x, f_y]: [f64; 2]) -> f64 {
        let limit = FRICTION * FORCE;
        (f_x / limit - self.truth[0]).hypot(f_y / limit - self.truth[1])
    }
}

/// A way to a force, the least time of one, and how far it is off.
struct Job {
    name: &'static str,
    run: fn(&Case) -> [f64; 2],
    repeated: usize,
    seconds: f64,
}

impl Job {
    fn new(name: &'static str, repeated: usize, run: fn(&Case) -> [f64; 2]) -> Self {
        Self { name, run, repeated, seconds: f64::INFINITY }
    }

    fn measure(&mut self, cases: &[Case]) {
        let begin = Instant::now();
        for _ in 0..self.repeated {
            cases.iter().for_each(|case| _ = black_box((self.run)(black_box(case))));
        }
        let seconds = begin.elapsed().as_secs_f64() / (self.repeated * cases.len()) as f64;
        self.seconds = self.seconds.min(seconds);
    }
}

fn main() {
    let rounds = std::env::args().find_map(|argument| argument.parse().ok()).unwrap_or(3);
    let mut state = 20_261_202_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let cases: Vec<Case> = (0..CONTACTS).map(|_| Case::drawn(&mut next)).collect();
    let mut jobs = [
        Job::new("FASTSIM, 10 x 10", 20, Case::by_springs),
        Job::new("table", 100, Case::by_table),
        Job::new("solver, 11 x 11", 1, |case| case.solved(11)),
        Job::new("solver, 24 x 24", 1, |case| case.solved(24)),
    ];
    for _ in 0..rounds {
        jobs.iter_mut().for_each(|job| job.measure(&cases));
    }
    println!(
        "{:20} {:>10} {:>14} {:>16} {:>10}",
        "way", "a force", "over FASTSIM", "off f F_z, mean", "worst"
    );
    let springs = jobs[0].seconds;
    for job in &jobs {
        let off: Vec<f64> = cases.iter().map(|case| case.off((job.run)(case))).collect();
        println!(
            "{:20} {:>7.2} us {:>14.2} {:>16.5} {:>10.4}",
            job.name,
            1e6 * job.seconds,
            job.seconds / springs,
            off.iter().sum::<f64>() / off.len() as f64,
            off.iter().copied().fold(0.0, f64::max),
        );
    }
}
