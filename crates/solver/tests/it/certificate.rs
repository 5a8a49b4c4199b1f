//! No solve is called a success that is none: pressures of drawn problems are judged by products that share no code with
//! the solver.

use carom_drawn::{Draw as _, Xorshift};
use carom_halfspace::operator::{PeriodicOperator, Threads};
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method as _, StepSummary,
    gap_left,
};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// A drawn contact: cells, E*, gap, whether it is periodic, and the drive.
struct Drawn {
    grid: Grid,
    modulus: f64,
    gap: Vec<f64>,
    is_periodic: bool,
    drive: Driven,
}

impl Drawn {
    fn new(random: &mut Xorshift) -> Self {
        let [nx, ny] = [(); 2].map(|()| 6 + 2 * random.below(6));
        let [dx, dy] = [(); 2].map(|()| 0.5 + random.part());
        let grid = Grid::new(nx, ny, dx, dy).unwrap();
        let (sx, sy) = (nx as f64 * dx, ny as f64 * dy);
        let is_periodic = random.part() < 0.5;
        let waves: Vec<[f64; 4]> = (0..6)
            .map(|_| {
                let whole = |random: &mut Xorshift| (3.0 * random.part()).floor() + 1.0;
                [0.05 * random.part(), TAU * random.part(), whole(random), whole(random)]
            })
            .collect();
        let bend = if is_periodic { 0.0 } else { 0.2 * random.part() };
        let height = |x: f64, y: f64| {
            let sum: f64 = waves
                .iter()
                .map(|[a, phase, i, j]| a * (TAU * (i * x / sx + j * y / sy) + phase).cos())
                .sum();
            bend * (x * x / (sx * sx) + y * y / (sy * sy)) * 4.0 + sum
        };
        let mut gap: Vec<f64> = grid.centres().map(|(x, y)| height(x, y)).collect();
        let least = gap.iter().copied().fold(f64::INFINITY, f64::min);
        gap.iter_mut().for_each(|gap| *gap -= least);
        let drive = match random.part() < 0.5 {
            true => Driven::Load(0.5 * random.part() * sx * sy * 0.05),
            false => Driven::Shift(0.02 + 0.15 * random.part()),
        };
        Self { grid, modulus: 1.0 / (1.0 - 0.25), gap, is_periodic, drive }
    }

    fn problem(&self) -> ContactProblem {
        let pair =
            MaterialPair::new(Material::from_young(1.0, 0.5).unwrap(), Material::RIGID).unwrap();
        let gap = Gap::new(Field::new(self.grid, self.gap.clone()).unwrap()).unwrap();
        match self.is_periodic {
            false => ContactProblem::of_half_spaces(gap, pair, Friction::NONE).unwrap(),
            true => {
                let operator = PeriodicOperator::new(pair, self.grid, Threads::One).unwrap();
                ContactProblem::new(gap, Arc::new(operator), Friction::NONE).unwrap()
            }
        }
    }

    /// The same in a unit of length this many times as small.
    fn larger(&self, by: f64) -> Self {
        let (dx, dy) = (by * self.grid.dx(), by * self.grid.dy());
        let grid = Grid::new(self.grid.nx(), self.grid.ny(), dx, dy).unwrap();
        let gap = self.gap.iter().map(|gap| by * gap).collect();
        Self { grid, gap, ..*self }
    }

    /// The displacements by this pressure.
    fn displacements(&self, pressure: &[f64]) -> Vec<f64> {
        if self.is_periodic { self.by_waves(pressure) } else { self.by_rectangles(pressure) }
    }

    /// The sum of the integrals of 1/(pi E* r) over rectangles, each by its primitive at four corners,
    /// x asinh(y/|x|) + y asinh(x/|y|).
    fn by_rectangles(&self, pressure: &[f64]) -> Vec<f64> {
        let (dx, dy) = (self.grid.dx(), self.grid.dy());
        let part = |a: f64, b: f64| if a == 0.0 { 0.0 } else { a * (b / a.abs()).asinh() };
        let corner = |x: f64, y: f64| part(x, y) + part(y, x);
        let places: Vec<(f64, f64)> = self.grid.centres().collect();
        let influence = |x: f64, y: f64| {
            let [x0, x1, y0, y1] = [x - 0.5 * dx, x + 0.5 * dx, y - 0.5 * dy, y + 0.5 * dy];
            (corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0))
                / (PI * self.modulus)
        };
        let at = |(x, y): &(f64, f64)| {
            let parts = places.iter().zip(pressure);
            parts.map(|((sx, sy), p)| p * influence(x - sx, y - sy)).sum()
        };
        places.iter().map(at).collect()
    }

    /// The sum of waves: a pressure cos(q x) displaces by 2/(E* q) cos(q x).
    fn by_waves(&self, pressure: &[f64]) -> Vec<f64> {
        let (nx, ny) = (self.grid.nx(), self.grid.ny());
        let (sx, sy) = (nx as f64 * self.grid.dx(), ny as f64 * self.grid.dy());
        let signed = |k: usize, n: usize| if 2 * k <= n { k as f64 } else { k as f64 - n as f64 };
        let mut w = vec![0.0; nx * ny];
        for (k, l) in (0..ny).flat_map(|l| (0..nx).map(move |k| (k, l))).skip(1) {
            let q = f64::hypot(TAU * signed(k, nx) / sx, TAU * signed(l, ny) / sy);
            let phase = |place: usize| {
                TAU * ((k * (place % nx)) as f64 / nx as f64
                    + (l * (place / nx)) as f64 / ny as f64)
            };
            let (mut re, mut im) = (0.0, 0.0);
            for (place, p) in pressure.iter().enumerate() {
                re += p * phase(place).cos();
                im += p * phase(place).sin();
            }
            let factor = 2.0 / (self.modulus * q * (nx * ny) as f64);
            for (place, w) in w.iter_mut().enumerate() {
                *w += factor * (re * phase(place).cos() + im * phase(place).sin());
            }
        }
        w
    }
}

/// Pressures are pushing, carry the force or have the approach, no surfaces overlap, and those in contact touch, all to
/// the tolerance; `energy_gap` is what the other product gives.
#[test]
fn no_drawn_contact_is_a_wrong_success() {
    let mut random = Xorshift(20_261_129);
    let (mut periodic, mut worst) = (0, 0.0_f64);
    for _ in 0..500 {
        let drawn = Drawn::new(&mut random);
        periodic += u32::from(drawn.is_periodic);
        let problem = drawn.problem();
        let method = Frictional::default().within(1e-9).unwrap();
        let apart = ContactState::apart(drawn.grid);
        let (mut state, mut scratch) = (apart.clone(), method.scratch(&problem).unwrap());
        let drive = Drive { normal: drawn.drive, ..Drive::default() };
        let went = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ());
        // By approach a periodic surface may be pressed to full contact, which has no force of its own.
        let Ok(went) = went else {
            assert!(drawn.is_periodic && matches!(drawn.drive, Driven::Shift(_)));
            continue;
        };
        let pressure = state.pressure.values();
        let w = drawn.displacements(pressure);
        let gaps: Vec<f64> =
            w.iter().zip(&drawn.gap).map(|(w, gap)| w + gap - state.shift.zeta).collect();
        let scale = drawn.gap.iter().copied().fold(0.0, f64::max);
        let area = drawn.grid.cell_area();
        for (gap, p) in gaps.iter().zip(pressure) {
            assert!(*p >= 0.0);
            let off = if *p > 0.0 { gap.abs() } else { -gap };
            worst = worst.max(off / scale);
        }
        match drawn.drive {
            Driven::Load(force) => {
                let sum: f64 = area * pressure.iter().sum::<f64>();
                assert!((sum - force).abs() < 1e-9 * force, "{sum} {force}");
            }
            Driven::Shift(zeta) => assert!((state.shift.zeta - zeta).abs() < 1e-14),
        }
        let step = StepSummary::default().next(&problem, [&apart, &state], &went).unwrap();
        let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        let bound: f64 =
            area * pressure.iter().zip(&gaps).map(|(p, gap)| p * (gap - least)).sum::<f64>();
        let energy = 0.5 * area * pressure.iter().zip(&w).map(|(p, w)| p * w).sum::<f64>();
        assert!(
            (step.energy_gap - bound).abs() < 1e-11 * energy.max(1e-300),
            "{} {bound}",
            step.energy_gap
        );
        assert!((step.stored_energy - energy).abs() < 1e-11 * energy);
        let mean = gaps.iter().sum::<f64>() / gaps.len() as f64;
        assert!((step.mean_gap - mean).abs() < 1e-11 * scale);
        let fresh = gap_left(&problem, &state).unwrap();
        let close = |(one, other): (&f64, &f64)| (one - other).abs() < 1e-11 * scale;
        assert!(fresh.values().iter().zip(&gaps).all(close));
        let modulus = problem.operator().contact_modulus().unwrap();
        assert!((modulus / drawn.modulus - 1.0).abs() < 1e-12, "{modulus}");
    }
    assert!(periodic > 200 && worst < 1e-8, "{periodic} {worst:e}");
}

/// What a rough solution by approach has above the energy of a fine one, by the other product, is below its bound, which is
/// of the first order in what is left of the conditions, and an energy in any unit of length.
#[test]
fn the_energy_by_approach_is_bounded() {
    let mut random = Xorshift(20_261_130);
    let mut count = 0;
    while count < 100 {
        let drawn = Drawn::new(&mut random);
        let zeta = 0.02 + 0.15 * random.part();
        if drawn.is_periodic {
            continue;
        }
        count += 1;
        let solved = |drawn: &Drawn, zeta: f64, tolerance: f64| {
            let problem = drawn.problem();
            let drive = Drive { normal: Driven::Shift(zeta), ..Drive::default() };
            let method = Frictional::default().within(tolerance).unwrap();
            let apart = ContactState::apart(drawn.grid);
            let (mut state, mut scratch) = (apart.clone(), method.scratch(&problem).unwrap());
            let went =
                method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ()).unwrap();
            let step = StepSummary::default().next(&problem, [&apart, &state], &went).unwrap();
            let pressure = state.pressure.values();
            let w = drawn.displacements(pressure);
            let works = pressure.iter().zip(&w).zip(&drawn.gap);
            let sum: f64 = works.map(|((p, w), gap)| p * (0.5 * w + gap - zeta)).sum();
            (drawn.grid.cell_area() * sum, step.energy_gap_by_approach.unwrap())
        };
        let (least, fine) = solved(&drawn, zeta, 1e-12);
        let [one, other] =
            [1.0, 1024.0].map(|by| solved(&drawn.larger(by), by * zeta, 1e-3).1 / by.powi(3));
        assert!((other - one).abs() <= 1e-6 * one, "an energy: {one:e} {other:e}");
        for tolerance in [1e-2, 1e-3, 1e-5] {
            let (energy, bound) = solved(&drawn, zeta, tolerance);
            let above = energy - least;
            assert!(above <= bound + 1e-12 * least.abs(), "{tolerance}: {above:e} {bound:e}");
            assert!(bound <= 20.0 * tolerance * least.abs() && fine <= 1e-10 * least.abs());
        }
    }
}
