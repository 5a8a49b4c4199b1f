//! The inverse influence on a torus of the grid's own size, which preconditions iterations.

use std::f64::consts::PI;

use super::length::Sizes;
use super::plan::Plan;
use super::product::Term;
use super::spectrum::{Parity, Spectrum};
use super::{Threads, Workspace};
use crate::{Grid, MaterialPair};

/// Pressures by normal displacements as if the half-space repeated itself with the period of the
/// grid: no solution, but close to one away from the borders, at a third of the cost of a product.
///
/// The displacement of the pressure `cos(k x)` is `(1 - nu)/G/|k|` times it (4.1); averaged over
/// cells and seen at their centres, waves whose numbers differ by a period of the grid add up. The
/// mean, which has no displacement of its own in a half-space, counts as a wave twice as long as the
/// torus.
#[derive(Clone)]
pub struct TorusInverse {
    plan: Plan,
    normal: Spectrum,
}

/// Waves that add up: as many periods of the grid to each side.
const ALIASES: i32 = 2;

impl TorusInverse {
    pub(crate) fn new(pair: &MaterialPair, grid: Grid, threads: Threads) -> Self {
        let plan = Plan::on(Sizes::of_torus(grid), threads);
        let compliance = (1.0 - pair.poisson()) / pair.shear_modulus();
        let normal = inverse_spectrum(&plan.sizes, grid, compliance);
        Self { plan, normal }
    }

    /// Pressures that would displace the surface so; fields in the order of the grid.
    ///
    /// # Panics
    /// If a field has not as many values as the grid cells.
    pub fn pressure(&self, displacement: &[f64], pressure: &mut [f64], workspace: &mut Workspace) {
        let term = Term { spectrum: &self.normal, sign: 1.0 };
        let mut terms = [[None; 3]; 3];
        terms[0][0] = Some(term);
        self.plan.product(&[displacement], &terms, &mut [pressure], workspace);
    }
}

fn inverse_spectrum(sizes: &Sizes, grid: Grid, compliance: f64) -> Spectrum {
    let (dx, dy) = (grid.dx(), grid.dy());
    let scale = 1.0 / (sizes.px as f64 * sizes.py as f64);
    let half = sizes.py / 2 + 1;
    let mut values = Vec::with_capacity(sizes.columns() * half);
    for column in 0..sizes.columns() {
        let k_x = 2.0 * PI * column as f64 / (sizes.px as f64 * dx);
        for row in 0..half {
            let k_y = 2.0 * PI * row as f64 / (sizes.py as f64 * dy);
            let symbol = if column == 0 && row == 0 {
                let longest = dx * sizes.px as f64;
                longest.max(dy * sizes.py as f64) / PI
            } else {
                aliased([k_x, k_y], [dx, dy])
            };
            values.push(scale / (compliance * symbol));
        }
    }
    Spectrum::Symmetric { values, half, imaginary: false, row_parity: Parity::Even }
}

/// `sum sinc(k_x dx/2) sinc(k_y dy/2)/|k|` over waves that look alike at the centres of the cells.
fn aliased([k_x, k_y]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
    let mut sum = 0.0;
    for i in -ALIASES..=ALIASES {
        let x = k_x + 2.0 * PI * f64::from(i) / dx;
        let mean_x = sinc(0.5 * x * dx);
        for j in -ALIASES..=ALIASES {
            let y = k_y + 2.0 * PI * f64::from(j) / dy;
            sum += mean_x * sinc(0.5 * y * dy) / libm::hypot(x, y);
        }
    }
    sum
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
