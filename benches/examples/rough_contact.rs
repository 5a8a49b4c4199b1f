//! Rough surfaces pressed on a plane, by the present method and by that of Polonsky and Keer (Wear 231,
//! 1999): products with the influence until the pressure is within 1e-6 of the solution on the same
//! grid, root mean square. `rough_contact 128 256 512`.
//!
//! Heights are self-affine, H = 0.8, from half of the side to eight cells; pressed by a force, and to the
//! approach of that force. The constrained conjugate gradients of 1999 take two products an iteration as
//! published: one for the gap, one for the length of the step.

use std::time::Instant;

use carom_halfspace::operator::{
    DisplacementField, OperatorError, SurfaceOperator, TractionField, Workspace,
};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictionless, Gap, Method as _,
    Products, SelfAffine,
};

type Failure = Box<dyn std::error::Error>;

/// The error at which the pressure counts as found.
const CLOSE: f64 = 1e-6;
const MOST: usize = 2000;

fn main() -> Result<(), Failure> {
    println!(
        "contact, drive              carom N    P   seconds   1999: iterations  N   seconds   N over N"
    );
    for size in std::env::args().skip(1) {
        for force in [0.02, 0.07, 0.17] {
            rough(size.parse()?, force)?;
        }
    }
    Ok(())
}

fn rough(n: usize, force: f64) -> Result<(), Failure> {
    let problem = problem(n)?;
    let (pressed, _) = solve(&problem, Driven::Load(force), 1e-12)?;
    let touching = pressed.count(CellState::Slip) as f64 / problem.grid().cells() as f64;
    for (name, driven) in
        [("force", Driven::Load(force)), ("approach", Driven::Shift(pressed.shift.zeta))]
    {
        let (best, _) = solve(&problem, driven, 1e-12)?;
        let best = best.pressure.values();
        let (products, seconds) = ours(&problem, driven, best)?;
        let begin = Instant::now();
        let iterations = Constrained::new(&problem, driven).until_close(best)?;
        let theirs = begin.elapsed().as_secs_f64();
        let spent = 2 * iterations;
        println!(
            "{n:4}  {:4.1} %  {name:9} {:10.1} {:5.1} {seconds:8.4} {iterations:14} {spent:6} {theirs:8.4} {:8.1}",
            100.0 * touching,
            products.normal,
            products.preconditioner,
            spent as f64 / products.normal,
        );
    }
    Ok(())
}

fn problem(n: usize) -> Result<ContactProblem, Failure> {
    let grid = Grid::new(n, n, 1.0 / n as f64, 1.0 / n as f64)?;
    let shortest = 8.0 / n as f64;
    let surface = SelfAffine { hurst: 0.8, rms: 0.01, longest: 0.5, shortest, seed: 3 };
    let body = Material::from_shear(2.0, 0.3)?;
    let pair = MaterialPair::new(body, body)?;
    let gap: Gap = surface.gap(grid)?;
    Ok(ContactProblem::of_half_spaces(gap, pair, Friction::NONE)?)
}

fn solve(
    problem: &ContactProblem,
    normal: Driven,
    tolerance: f64,
) -> Result<(ContactState, Products), Failure> {
    let method = Frictionless::default().within(tolerance)?;
    let mut scratch = method.scratch(problem)?;
    let apart = ContactState::apart(problem.grid());
    let (mut state, drive) = (apart.clone(), Drive { normal, ..Drive::default() });
    let went = method.step(problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
    Ok((state, went.products))
}

/// The products and the seconds of the coarsest tolerance that is close enough.
fn ours(
    problem: &ContactProblem,
    driven: Driven,
    best: &[f64],
) -> Result<(Products, f64), Failure> {
    for quarter in 8..44 {
        let begin = Instant::now();
        let (state, products) = solve(problem, driven, 10.0_f64.powf(-0.25 * f64::from(quarter)))?;
        if error(state.pressure.values(), best) <= CLOSE {
            return Ok((products, begin.elapsed().as_secs_f64()));
        }
    }
    Err("no tolerance is close enough".into())
}

fn error(got: &[f64], want: &[f64]) -> f64 {
    let square: f64 = got.iter().zip(want).map(|(a, b)| (a - b) * (a - b)).sum();
    (square / want.iter().map(|b| b * b).sum::<f64>()).sqrt()
}

/// Conjugate gradients on the cells in contact, with tension removed after each step.
struct Constrained<'a> {
    operator: &'a dyn SurfaceOperator,
    workspace: Workspace,
    heights: &'a [f64],
    driven: Driven,
    pressure: Vec<f64>,
    gap: Vec<f64>,
    direction: Vec<f64>,
    image: Vec<f64>,
}

impl<'a> Constrained<'a> {
    /// From the mean pressure of the force, or of as much as flattens a tenth of the heights.
    fn new(problem: &'a ContactProblem, driven: Driven) -> Self {
        let (operator, heights) = (problem.operator(), problem.gap().heights().values());
        let zero = vec![0.0; heights.len()];
        let area = problem.grid().cell_area() * heights.len() as f64;
        let mean = match driven {
            Driven::Load(force) => force / area,
            Driven::Shift(approach) => approach / area.sqrt(),
        };
        Self {
            operator,
            workspace: operator.workspace(),
            heights,
            driven,
            pressure: vec![mean; zero.len()],
            gap: zero.clone(),
            direction: zero.clone(),
            image: zero,
        }
    }

    /// The iterations until the pressure is close to the best one.
    fn until_close(mut self, best: &[f64]) -> Result<usize, Failure> {
        let (mut last, mut follows) = (1.0, false);
        for iteration in 1..=MOST {
            (last, follows) = self.iterate(last, follows)?;
            if error(&self.pressure, best) <= CLOSE {
                return Ok(iteration);
            }
        }
        Err("the method of 1999 does not get there".into())
    }

    fn iterate(&mut self, last: f64, follows: bool) -> Result<(f64, bool), OperatorError> {
        let by_force = matches!(self.driven, Driven::Load(_));
        self.apply(true)?;
        let approach = match self.driven {
            Driven::Shift(approach) => approach,
            Driven::Load(_) => 0.0,
        };
        for (gap, height) in self.gap.iter_mut().zip(self.heights) {
            *gap += height - approach;
        }
        if by_force {
            let mean = mean(&self.gap, &self.pressure);
            self.gap.iter_mut().for_each(|gap| *gap -= mean);
        }
        let touching = |(_, p): &(&f64, &f64)| **p > 0.0;
        let power: f64 =
            self.gap.iter().zip(&self.pressure).filter(touching).map(|(g, _)| g * g).sum();
        let share = if follows { power / last } else { 0.0 };
        for (i, direction) in self.direction.iter_mut().enumerate() {
            *direction =
                if self.pressure[i] > 0.0 { self.gap[i] + share * *direction } else { 0.0 };
        }
        self.apply(false)?;
        if by_force {
            let mean = mean(&self.image, &self.pressure);
            self.image.iter_mut().for_each(|image| *image -= mean);
        }
        let (mut down, mut bend) = (0.0, 0.0);
        for (i, _) in self.pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
            down += self.gap[i] * self.direction[i];
            bend += self.image[i] * self.direction[i];
        }
        let length = if bend > 0.0 { down / bend } else { 0.0 };
        let mut overlaps = false;
        for (i, pressure) in self.pressure.iter_mut().enumerate() {
            *pressure = (*pressure - length * self.direction[i]).max(0.0);
            if *pressure == 0.0 && self.gap[i] < 0.0 {
                overlaps = true;
                *pressure = -length * self.gap[i];
            }
        }
        if let Driven::Load(force) = self.driven {
            let sum = self.operator.grid().cell_area() * self.pressure.iter().sum::<f64>();
            self.pressure.iter_mut().for_each(|pressure| *pressure *= force / sum);
        }
        Ok((power, !overlaps))
    }

    /// The displacement by the pressure into `gap`, or by the direction into `image`.
    fn apply(&mut self, pressure: bool) -> Result<(), OperatorError> {
        let (load, result) = if pressure {
            (&self.pressure, &mut self.gap)
        } else {
            (&self.direction, &mut self.image)
        };
        let displacement = DisplacementField::normal(result);
        self.operator.apply(TractionField::normal(load), displacement, &mut self.workspace)
    }
}

/// The mean over the cells in contact.
fn mean(values: &[f64], pressure: &[f64]) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for (value, _) in values.iter().zip(pressure).filter(|(_, p)| **p > 0.0) {
        sum += value;
        count += 1.0;
    }
    sum / count
}
