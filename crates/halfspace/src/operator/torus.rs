//! The inverse influence on a torus of the grid's own size, which preconditions iterations.

use std::f64::consts::PI;

use super::length::Sizes;
use super::plan::Plan;
use super::product::Term;
use super::spectrum::{Parity, Spectrum};
use super::{Threads, Workspace};
use crate::{Grid, MaterialPair};

/// Tractions by displacements as if the half-space repeated itself with the period of the grid: no
/// solution, but close to one away from the borders, at a third of the cost of a product.
///
/// Displacements over tractions that go as `cos(k x)` are `(1 - nu)/G/|k|` along the normal and
/// `[1 - nu k k^T/k^2]/G/|k|` along the surface (4.1)-(4.3); averaged over cells and seen at their
/// centres, waves whose numbers differ by a period of the grid add up. The mean, which has no
/// displacement of its own in a half-space, counts as a wave twice as long as the torus. Normal and
/// tangential blocks are inverted each by itself.
#[derive(Clone)]
pub struct TorusInverse {
    plan: Plan,
    normal: Spectrum,
    /// xx, xy, yy.
    tangential: [Spectrum; 3],
}

/// Waves that add up: as many periods of the grid to each side.
const ALIASES: i32 = 2;

/// Sums over waves that look alike: of 1/|k|, and of k_x^2, k_x k_y, k_y^2 over |k|^3.
#[derive(Debug, Clone, Copy, Default)]
struct Waves {
    all: f64,
    xx: f64,
    xy: f64,
    yy: f64,
}

impl TorusInverse {
    pub(crate) fn new(pair: &MaterialPair, grid: Grid, threads: Threads) -> Self {
        let plan = Plan::on(Sizes::of_torus(grid), threads);
        let (nu, compliance) = (pair.poisson(), 1.0 / pair.shear_modulus());
        let scale = 1.0 / (plan.sizes.px as f64 * plan.sizes.py as f64);
        let half = plan.sizes.py / 2 + 1;
        let count = plan.sizes.columns() * half;
        let [mut zz, mut xx, mut xy, mut yy] = [(); 4].map(|()| Vec::with_capacity(count));
        for waves in symbols(&plan.sizes, grid) {
            zz.push(scale / (compliance * (1.0 - nu) * waves.all));
            let [a, b, c] = [
                compliance * (waves.all - nu * waves.xx),
                -compliance * nu * waves.xy,
                compliance * (waves.all - nu * waves.yy),
            ];
            let over = scale / (a * c - b * b);
            xx.push(c * over);
            xy.push(-b * over);
            yy.push(a * over);
        }
        let spectrum = |values: Vec<f64>, row_parity| Spectrum::Symmetric {
            values,
            half,
            imaginary: false,
            row_parity,
        };
        let tangential =
            [spectrum(xx, Parity::Even), spectrum(xy, Parity::Odd), spectrum(yy, Parity::Even)];
        Self { plan, normal: spectrum(zz, Parity::Even), tangential }
    }

    /// Pressures that would displace the surface so; fields in the order of the grid.
    ///
    /// # Panics
    /// If a field has not as many values as the grid cells.
    pub fn pressure(&self, displacement: &[f64], pressure: &mut [f64], workspace: &mut Workspace) {
        let mut terms = [[None; 3]; 3];
        terms[0][0] = Some(term(&self.normal));
        self.plan.product(&[displacement], &terms, &mut [pressure], workspace);
    }

    /// Tangential tractions that would displace the surface so, along x and y.
    ///
    /// # Panics
    /// As [`TorusInverse::pressure`].
    pub fn traction(
        &self,
        displacement: [&[f64]; 2],
        traction: [&mut [f64]; 2],
        workspace: &mut Workspace,
    ) {
        let [xx, xy, yy] = self.tangential.each_ref().map(|spectrum| Some(term(spectrum)));
        let terms = [[xx, xy, None], [xy, yy, None], [None; 3]];
        let mut outputs = traction;
        self.plan.product(&displacement, &terms, &mut outputs, workspace);
    }
}

const fn term(spectrum: &Spectrum) -> Term<'_> {
    Term { spectrum, sign: 1.0 }
}

/// The sums of all waves of the torus, column by column.
fn symbols(sizes: &Sizes, grid: Grid) -> impl Iterator<Item = Waves> {
    let (px, py) = (sizes.px, sizes.py);
    let (dx, dy) = (grid.dx(), grid.dy());
    let (lx, ly) = (px as f64 * dx, py as f64 * dy);
    let rows = py / 2 + 1;
    (0..sizes.columns()).flat_map(move |column| {
        (0..rows).map(move |row| {
            if column == 0 && row == 0 {
                // No direction: half along each axis.
                let all = lx.max(ly) / PI;
                return Waves { all, xx: 0.5 * all, xy: 0.0, yy: 0.5 * all };
            }
            let wave = [2.0 * PI * column as f64 / lx, 2.0 * PI * row as f64 / ly];
            let waves = Waves::alike(wave, [dx, dy]);
            // The shortest waves have no sign.
            let signless = 2 * column == px || 2 * row == py;
            Waves { xy: if signless { 0.0 } else { waves.xy }, ..waves }
        })
    })
}

impl Waves {
    fn alike([k_x, k_y]: [f64; 2], [dx, dy]: [f64; 2]) -> Self {
        let mut sum = Self::default();
        for i in -ALIASES..=ALIASES {
            let x = k_x + 2.0 * PI * f64::from(i) / dx;
            let mean_x = sinc(0.5 * x * dx);
            for j in -ALIASES..=ALIASES {
                let y = k_y + 2.0 * PI * f64::from(j) / dy;
                let square = x * x + y * y;
                let part = mean_x * sinc(0.5 * y * dy) / square.sqrt();
                sum.all += part;
                sum.xx += part * x * x / square;
                sum.xy += part * x * y / square;
                sum.yy += part * y * y / square;
            }
        }
        sum
    }
}

fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-8 { 1.0 } else { libm::sin(x) / x }
}

impl std::fmt::Debug for TorusInverse {
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

    /// A load that ends far inside the grid comes back but for what the torus lacks: waves longer
    /// than itself.
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
        inverse.traction([&u, &v], [&mut x, &mut y], &mut workspace);
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
