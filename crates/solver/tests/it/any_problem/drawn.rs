//! Drawn contact problems of any shape, material and friction, with their steps.

use std::sync::Arc;

use carom_drawn::Draw;
use carom_halfspace::operator::{HalfSpaceOperator, PeriodicOperator, SurfaceOperator, Threads};
use carom_halfspace::{Field, Grid, Material, MaterialPair};
use carom_laws::friction::Friction;
use carom_laws::law::Shift;
use carom_solver::{
    CellFriction, ContactProblem, ContactState, Drive, Driven, Frictional, FrictionalError,
    FrictionalScratch, Gap, Method as _, SelfAffine, SurfaceFriction,
};

/// A problem with its steps.
pub(crate) struct Case {
    pub(crate) pair: MaterialPair,
    pub(crate) gap: Gap,
    pub(crate) friction: SurfaceFriction,
    pub(crate) periodic: bool,
    /// Static friction exceeds kinetic friction: which cells change to kinetic friction depends on
    /// the path of the load.
    pub(crate) breaks: bool,
    pub(crate) steps: Vec<Shift>,
}

impl Case {
    /// None if a drawn number is out of range.
    pub(crate) fn drawn(draw: &mut impl Draw) -> Option<Self> {
        let periodic = draw.part() < 0.2;
        let [nx, ny] = [(); 2].map(|()| 2 * draw.between(8.0, 26.0) as usize);
        let (nx, ny) = if periodic { (nx, ny) } else { (nx + 1, ny) };
        let grid = Grid::new(nx, ny, 2.2 / nx as f64, 2.2 / ny as f64).ok()?;
        let pair = pair(draw)?;
        let gap = gap(draw, grid)?;
        let (friction, breaks) = friction(draw, grid)?;
        let size = draw.pick(&[0.01, 0.1, 0.4]);
        let count = 1 + draw.between(0.0, 5.0) as usize;
        let steps = (0..count).map(|_| shift(draw, size, periodic)).collect();
        Some(Self { pair, gap, friction, periodic, breaks, steps })
    }

    pub(crate) fn problem(&self) -> Option<ContactProblem> {
        let grid = self.gap.grid();
        self.solved_by(match self.periodic {
            true => Arc::new(PeriodicOperator::new(self.pair, grid, Threads::One).ok()?),
            false => Arc::new(HalfSpaceOperator::new(self.pair, grid).ok()?),
        })
    }

    pub(crate) fn solved_by(&self, operator: Arc<dyn SurfaceOperator>) -> Option<ContactProblem> {
        ContactProblem::new(self.gap.clone(), operator, self.friction.clone()).ok()
    }

    /// On a period the approach is measured from the mean plane, and no force makes it exceed all
    /// heights: the normal motion is driven by a force.
    pub(crate) fn drive(&self, shift: Shift) -> Drive {
        let drive = Drive::by_shift(shift);
        let force = Driven::Load(shift.zeta.max(0.0));
        if self.periodic { Drive { normal: force, ..drive } } else { drive }
    }
}

fn pair(draw: &mut impl Draw) -> Option<MaterialPair> {
    let poisson = [(); 2].map(|()| draw.between(-0.3, 0.5));
    let shear = [(); 2].map(|()| draw.pick(&[1.0, 1.0, 5.0, 100.0]));
    let body = |i: usize| Material::from_shear(shear[i], poisson[i]);
    let one = body(0).ok()?;
    let two = match draw.pick(&[0, 1, 2]) {
        0 => one,
        1 => Material::RIGID,
        _ => body(1).ok()?,
    };
    MaterialPair::new(one, two).ok()
}

fn gap(draw: &mut impl Draw, grid: Grid) -> Option<Gap> {
    let [a, b] = [(); 2].map(|()| draw.between(0.2, 2.0));
    let [x0, y0] = [(); 2].map(|()| draw.between(-0.3, 0.3));
    let seed = (1e6 * draw.part()) as u64;
    let from = |height: &dyn Fn(f64, f64) -> f64| {
        Gap::from_function(grid, |x, y| height(x - x0, y - y0)).ok()
    };
    match draw.pick(&[0, 1, 2, 3, 4, 5]) {
        0 => from(&|x, y| a * x * x + b * y * y),
        1 => from(&|x, y| a * x.hypot(y)),
        2 => from(&|x, y| if x.abs().max(y.abs()) < 0.5 { 0.0 } else { f64::INFINITY }),
        3 => from(&|x, y| (1.0 - libm::cos(3.0 * x) * libm::cos(2.0 * y)) * 0.2 + 0.1 * a * x * x),
        4 => from(&|x, y| {
            let [one, two] = [x - 0.4, x + 0.5];
            (a * one * one + y * y).min(b * two * two + 2.0 * y * y + 0.1)
        }),
        _ => {
            let shortest = 4.0 * grid.dx().max(grid.dy());
            SelfAffine { hurst: 0.8, rms: 0.1, longest: 2.0, shortest, seed }.gap(grid).ok()
        }
    }
}

/// Friction, and whether static friction exceeds kinetic friction.
fn friction(draw: &mut impl Draw, grid: Grid) -> Option<(SurfaceFriction, bool)> {
    let f = |value: f64| Friction::new(value).ok();
    let kinetic = draw.pick(&[0.05, 0.2, 0.5, 1.0]);
    match draw.pick(&[0, 1, 2, 3]) {
        0 => {
            let cell = |_| {
                let one = f(draw.pick(&[0.0, 0.1, 0.3, 0.8]))?;
                CellFriction::new(one, one).ok()
            };
            let cells = (0..grid.cells()).map(cell).collect::<Option<_>>()?;
            Some((Field::new(grid, cells).ok()?.into(), false))
        }
        1 => Some((CellFriction::new(f(1.4 * kinetic)?, f(kinetic)?).ok()?.into(), true)),
        _ => Some((f(kinetic)?.into(), false)),
    }
}

fn shift(draw: &mut impl Draw, size: f64, periodic: bool) -> Shift {
    let mut tangential = || draw.pick(&[0.0, 1.0, 1.0]) * draw.between(-size, size);
    let [xi, eta, omega] = [tangential(), tangential(), tangential()];
    let omega = if periodic { 0.0 } else { omega };
    let drawn = draw.between(0.1, 0.6);
    let zeta = draw.pick(&[drawn, 0.3, -0.1, 0.5]);
    Shift { zeta, xi, eta, omega }
}

pub(crate) fn step(
    problem: &ContactProblem,
    scratch: &mut FrictionalScratch,
    before: &ContactState,
    drive: &Drive,
) -> Result<ContactState, FrictionalError> {
    let mut to = before.clone();
    Frictional::default().step(problem, before, drive, &mut to, scratch, &mut ())?;
    Ok(to)
}

/// The greatest difference of pressures and tractions, relative to the greatest pressure.
pub(crate) fn difference(one: &ContactState, other: &ContactState) -> f64 {
    let top = one.pressure.values().iter().copied().fold(0.0, f64::max);
    let pairs = [
        (&one.pressure, &other.pressure),
        (&one.traction_x, &other.traction_x),
        (&one.traction_y, &other.traction_y),
    ];
    let of = |(one, other): (&Field, &Field)| {
        let pairs = one.values().iter().zip(other.values());
        pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
    };
    pairs.into_iter().map(of).fold(0.0, f64::max) / top.max(f64::MIN_POSITIVE)
}
