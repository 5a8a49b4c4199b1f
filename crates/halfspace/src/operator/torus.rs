//! The inverse influence on a torus of the grid's size, a preconditioner for iterations.

use std::f64::consts::PI;
use std::ops::RangeInclusive;
use std::sync::{Arc, OnceLock};

use super::length::Sizes;
use super::plan::Plan;
use super::precision::Real;
use super::product::{self, Matrix, Term, Terms};
use super::spectrum::{Parity, Spectrum};
use super::{Preconditioner, Threads, Workspace};
use crate::{Grid, MaterialPair, Offset};

/// Tractions from displacements for a half-space that is periodic with the sides of the grid. It is
/// not a solution, but close to one away from the borders, at a third of the cost of a product.
///
/// For tractions that vary as `cos(k x)`, displacement over traction is `(1 - nu)/G/|k|` in the
/// normal and `[1 - nu k k^T/k^2]/G/|k|` in the tangential directions (4.1)-(4.3). Averaged over
/// cells and sampled at their centres, waves whose numbers differ by a period of the grid add up.
/// The mean traction, which has no finite displacement in a half-space, is treated as a wave twice
/// as long as the torus. Normal and tangential blocks are inverted separately.
///
/// Clones are cheap; each block is computed when first needed.
#[derive(Clone)]
pub(crate) struct TorusInverse<T: Real = f64> {
    plan: Plan<T>,
    blocks: Arc<TorusBlocks<T>>,
}

/// The symbols of the inverse.
struct TorusBlocks<T> {
    pair: MaterialPair,
    grid: Grid,
    normal: OnceLock<Symbols<T, 1>>,
    /// xx, xy, yy.
    tangential: OnceLock<Symbols<T, 3>>,
}

/// Symbols of the inverse over a unit.
struct Symbols<T, const N: usize> {
    spectra: [Spectrum<T>; N],
    unit: f64,
}

impl<T: Real, const N: usize> Symbols<T, N> {
    fn new(symbols: &[Spectrum; N]) -> Self {
        let greatest = symbols.iter().map(Spectrum::greatest).fold(0.0, f64::max);
        let unit = T::unit_of_spectrum(greatest);
        Self { spectra: symbols.each_ref().map(|symbol| symbol.over(unit)), unit }
    }
}

/// Aliased waves that are summed: this many periods of the grid on each side.
const ALIASES: RangeInclusive<i32> = -2..=2;

/// Sums over aliased waves in one column of the torus: of 1/|k|, and of k_x^2, k_x k_y, k_y^2 over
/// |k|^3.
struct Waves {
    all: Vec<f64>,
    xx: Vec<f64>,
    xy: Vec<f64>,
    yy: Vec<f64>,
}

impl<T: Real> TorusInverse<T> {
    pub(crate) fn new(pair: &MaterialPair, grid: Grid, threads: Threads) -> Self {
        let plan = Plan::on(Sizes::of_torus(grid), threads);
        let (normal, tangential) = (OnceLock::new(), OnceLock::new());
        Self { plan, blocks: Arc::new(TorusBlocks { pair: *pair, grid, normal, tangential }) }
    }
}

impl<T: Real> Preconditioner for TorusInverse<T> {
    fn pressure(&self, displacement: &[f64], pressure: &mut [f64], workspace: &mut Workspace) {
        let Symbols { spectra: [normal], unit } = self.blocks.normal(&self.plan.sizes);
        let mut blocks = [[None; 3]; 3];
        blocks[0][0] = Some(term(normal));
        let terms = Terms { blocks: &blocks, unit: *unit };
        self.plan.product(&[displacement], &terms, &mut [pressure], workspace);
    }

    fn traction(
        &self,
        displacement: [Option<&[f64]>; 2],
        traction: [Option<&mut [f64]>; 2],
        workspace: &mut Workspace,
    ) {
        let blocks = self.blocks.tangential(&self.plan.sizes);
        self.tangential(blocks, displacement, traction, workspace);
    }

    fn rolled(&self, ahead: Offset, part: f64) -> Option<Arc<dyn Preconditioner>> {
        let (sizes, grid) = (self.plan.sizes, self.blocks.grid);
        let cells = [ahead.x / grid.dx(), ahead.y / grid.dy()];
        let sums = |symbol: Spectrum| symbol.summed_ahead(&sizes, cells, part);
        let blocks = Symbols::new(&self.blocks.tangential_symbols(&sizes).map(sums));
        Some(Arc::new(RolledInverse { torus: self.clone(), blocks: Arc::new(blocks) }))
    }
}

/// The inverse for a step of rolling: the changes of displacement are added up from the leading end
/// of the grid, and the sums inverted on the torus.
struct RolledInverse<T: Real> {
    torus: TorusInverse<T>,
    /// xx, xy, yy.
    blocks: Arc<Symbols<T, 3>>,
}

impl<T: Real> Preconditioner for RolledInverse<T> {
    fn pressure(&self, displacement: &[f64], pressure: &mut [f64], workspace: &mut Workspace) {
        self.torus.pressure(displacement, pressure, workspace);
    }

    fn traction(
        &self,
        displacement: [Option<&[f64]>; 2],
        traction: [Option<&mut [f64]>; 2],
        workspace: &mut Workspace,
    ) {
        self.torus.tangential(&self.blocks, displacement, traction, workspace);
    }
}

impl<T: Real> TorusInverse<T> {
    /// The product with the blocks xx, xy, yy.
    fn tangential(
        &self,
        blocks: &Symbols<T, 3>,
        displacement: [Option<&[f64]>; 2],
        traction: [Option<&mut [f64]>; 2],
        workspace: &mut Workspace,
    ) {
        let [xx, xy, yy] = blocks.spectra.each_ref().map(|spectrum| Some(term(spectrum)));
        // For a Poisson's ratio of zero the two directions do not couple.
        let xy = xy.filter(|_| self.blocks.pair.poisson() != 0.0);
        let (mut inputs, mut outputs): ([&[f64]; 2], [&mut [f64]; 2]) = Default::default();
        let (mut given, mut wanted) = (0, 0);
        let mut used: Matrix<'_, T> = [[None; 3]; 3];
        let mut columns = [0; 2];
        for (axis, values) in displacement.into_iter().enumerate() {
            let Some(values) = values else { continue };
            (inputs[given], columns[given]) = (values, axis);
            given += 1;
        }
        for (row, field) in [[xx, xy], [xy, yy]].into_iter().zip(traction) {
            let Some(field) = field else { continue };
            for (term, column) in used[wanted].iter_mut().zip(&columns[..given]) {
                *term = row[*column];
            }
            outputs[wanted] = field;
            wanted += 1;
        }
        let terms = Terms { blocks: &used, unit: blocks.unit };
        product::reduced(&self.plan, &inputs[..given], &terms, &mut outputs[..wanted], workspace);
    }
}

impl<T: Real> TorusBlocks<T> {
    fn normal(&self, sizes: &Sizes) -> &Symbols<T, 1> {
        self.normal.get_or_init(|| {
            let compliance = (1.0 - self.pair.poisson()) / self.pair.shear_modulus();
            let scale = 1.0 / (compliance * sizes.px as f64 * sizes.py as f64);
            let mut values = Vec::with_capacity(sizes.columns() * (sizes.py / 2 + 1));
            symbols(sizes, self.grid, Waves::add_lengths, |waves| {
                values.extend(waves.all.iter().map(|all| scale / all));
            });
            Symbols::new(&[spectrum(values, sizes)])
        })
    }

    fn tangential(&self, sizes: &Sizes) -> &Symbols<T, 3> {
        self.tangential.get_or_init(|| Symbols::new(&self.tangential_symbols(sizes)))
    }

    fn tangential_symbols(&self, sizes: &Sizes) -> [Spectrum; 3] {
        let (nu, compliance) = (self.pair.poisson(), 1.0 / self.pair.shear_modulus());
        let scale = 1.0 / (sizes.px as f64 * sizes.py as f64);
        let length = sizes.columns() * (sizes.py / 2 + 1);
        let [mut xx, mut xy, mut yy] = [(); 3].map(|()| Vec::with_capacity(length));
        symbols(sizes, self.grid, Waves::add_directions, |waves| {
            for (i, all) in waves.all.iter().enumerate() {
                let [a, b, c] = [
                    compliance * (all - nu * waves.xx[i]),
                    -compliance * nu * waves.xy[i],
                    compliance * (all - nu * waves.yy[i]),
                ];
                let over = scale / (a * c - b * b);
                xx.push(c * over);
                xy.push(-b * over);
                yy.push(a * over);
            }
        });
        let odd = match spectrum(xy, sizes) {
            Spectrum::Symmetric { values, half, imaginary, .. } => {
                Spectrum::Symmetric { values, half, imaginary, row_parity: Parity::Odd }
            }
            other => other,
        };
        [spectrum(xx, sizes), odd, spectrum(yy, sizes)]
    }
}

/// A symbol that is real and even.
const fn spectrum(values: Vec<f64>, sizes: &Sizes) -> Spectrum {
    let half = sizes.py / 2 + 1;
    Spectrum::Symmetric { values, half, imaginary: false, row_parity: Parity::Even }
}

fn term<T: Real>(spectrum: &Spectrum<T>) -> Term<'_, T> {
    Term { spectrum, sign: T::one() }
}

/// The sums over all waves of the torus, column by column.
fn symbols(
    sizes: &Sizes,
    grid: Grid,
    add: impl Fn(&mut Waves, (f64, f64), (&[f64], &[f64])),
    mut take: impl FnMut(&Waves),
) {
    let (px, py) = (sizes.px, sizes.py);
    let (lx, ly) = (px as f64 * grid.dx(), py as f64 * grid.dy());
    let zero = || vec![0.0; py / 2 + 1];
    let mut waves = Waves { all: zero(), xx: zero(), xy: zero(), yy: zero() };
    let along_y: Vec<[Vec<f64>; 2]> = ALIASES
        .map(|alias| {
            let (y, mean) = (0..=py / 2).map(|row| wave(row, alias, py, grid.dy())).unzip();
            [y, mean]
        })
        .collect();
    for column in 0..sizes.columns() {
        waves.clear();
        for alias in ALIASES {
            let x = wave(column, alias, px, grid.dx());
            for [y, mean] in &along_y {
                add(&mut waves, x, (y, mean));
            }
        }
        // The shortest wave has no sign.
        if 2 * column == px {
            waves.xy.fill(0.0);
        }
        if py.is_multiple_of(2) {
            waves.xy[py / 2] = 0.0;
        }
        if column == 0 {
            // The mean has no direction: half along each axis.
            let all = lx.max(ly) / PI;
            (waves.all[0], waves.xx[0], waves.xy[0], waves.yy[0]) =
                (all, 0.5 * all, 0.0, 0.5 * all);
        }
        take(&waves);
    }
}

/// The wave number along one axis, shifted by `alias` periods of the grid, and its mean over a
/// cell.
fn wave(index: usize, alias: i32, count: usize, width: f64) -> (f64, f64) {
    let turns = index as f64 / count as f64 + f64::from(alias);
    (2.0 * PI * turns / width, sinc(PI * turns))
}

impl Waves {
    fn clear(&mut self) {
        for values in [&mut self.all, &mut self.xx, &mut self.xy, &mut self.yy] {
            values.fill(0.0);
        }
    }

    /// Adds 1/|k| only.
    fn add_lengths(&mut self, (x, mean_x): (f64, f64), (y, mean_y): (&[f64], &[f64])) {
        for ((y, mean_y), all) in y.iter().zip(mean_y).zip(&mut self.all) {
            *all += mean_x * mean_y / (x * x + y * y).sqrt();
        }
    }

    fn add_directions(&mut self, (x, mean_x): (f64, f64), (y, mean_y): (&[f64], &[f64])) {
        let sums = self.all.iter_mut().zip(&mut self.xx).zip(self.xy.iter_mut().zip(&mut self.yy));
        for ((y, mean_y), ((all, xx), (xy, yy))) in y.iter().zip(mean_y).zip(sums) {
            let square = x * x + y * y;
            let part = mean_x * mean_y / square.sqrt();
            let over = part / square;
            *all += part;
            *xx += over * x * x;
            *xy += over * x * y;
            *yy += over * y * y;
        }
    }
}

fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-8 { 1.0 } else { libm::sin(x) / x }
}

impl<T: Real> std::fmt::Debug for TorusInverse<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let size = (self.plan.sizes.px, self.plan.sizes.py);
        f.debug_struct("TorusInverse").field("size", &size).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;
    use crate::operator::{DisplacementField, HalfSpaceOperator, SurfaceOperator, TractionField};

    /// The inverse recovers a load well inside the grid, except for waves longer than the torus.
    #[test]
    fn undoes_a_product_away_from_the_borders() {
        let body = Material::from_shear(2.0, 0.3).unwrap();
        let pair = MaterialPair::new(body, body).unwrap();
        let grid = Grid::new(96, 80, 0.1, 0.15).unwrap();
        let operator = HalfSpaceOperator::new(pair, grid).unwrap();
        let inverse = operator.inverse().unwrap();
        let bump = |x: f64, y: f64| {
            let r = (x * x + y * y).sqrt();
            if r < 1.5 { x * (1.0 - r / 1.5).powi(2) } else { 0.0 }
        };
        let load: Vec<f64> = grid.centres().map(|(x, y)| bump(x, y)).collect();
        let load_y: Vec<f64> = grid.centres().map(|(x, y)| -0.7 * bump(y, x)).collect();
        let zero = || vec![0.0; grid.cells()];
        let (mut u, mut v, mut w) = (zero(), zero(), zero());
        let tractions = TractionField::full(&load, &load_y, &load);
        let mut workspace = operator.workspace();
        let displacements = DisplacementField::full(&mut u, &mut v, &mut w);
        operator.apply(tractions, displacements, &mut workspace).unwrap();
        let (mut x, mut y, mut z) = (zero(), zero(), zero());
        inverse.pressure(&w, &mut z, &mut workspace);
        inverse.traction([Some(&u), Some(&v)], [Some(&mut x), Some(&mut y)], &mut workspace);
        let error = |got: &[f64], want: &[f64]| {
            let within = grid.centres().zip(got.iter().zip(want));
            let near = within.filter(|((x, y), _)| x.abs() < 2.0 && y.abs() < 2.0);
            near.map(|(_, (got, want))| (got - want).abs()).fold(0.0, f64::max)
        };
        let largest = load.iter().copied().fold(0.0, f64::max);
        for (got, want) in [(&z, &load), (&x, &load), (&y, &load_y)] {
            assert!(error(got, want) < 0.02 * largest, "{}", error(got, want) / largest);
        }
    }
}
