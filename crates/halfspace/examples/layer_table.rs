//! Writes the influence numbers of a rubber layer that lies on a smooth rigid base, `examples/solve_layer.csv`:
//! the pressure on one cell and the normal displacement of another.
//!
//! The half-space of the same material is known in closed form. Waves of pressure cos(k x) displace the layer of
//! thickness h by L(k h) times as much, L(x) = (cosh 2x - 1)/(sinh 2x + 2x), which differs from 1 for waves longer
//! than the layer is thick; the difference is an integral over Bessel's function J_0.

use carom_halfspace::operator::{HalfSpaceOperator, SurfaceOperator};
use carom_halfspace::{Grid, Material, MaterialPair};
use carom_special::quadrature::GaussLegendre;
use std::error::Error;
use std::f64::consts::PI;

/// m.
const THICKNESS: f64 = 2e-3;
/// Pa.
const SHEAR_MODULUS: f64 = 1e6;
const POISSON: f64 = 0.45;
/// Cells along each axis, and the side of the grid, m.
const CELLS: usize = 32;
const SIDE: f64 = 16e-3;

fn main() -> Result<(), Box<dyn Error>> {
    let rubber = Material::from_shear(SHEAR_MODULUS, POISSON)?;
    let width = SIDE / CELLS as f64;
    let grid = Grid::new(CELLS, CELLS, width, width)?;
    let half_space = HalfSpaceOperator::new(MaterialPair::new(rubber, Material::RIGID)?, grid)?;
    let layer = Layer::new()?;
    let mut text = String::from("columns,rows,zz\n");
    for rows in 0..CELLS as i32 {
        for columns in 0..CELLS as i32 {
            let own = half_space.coefficients(columns, rows).rows[2][2];
            let [x, y] = [columns, rows].map(|offset| f64::from(offset) * width);
            let less = layer.less_than_half_space([x, y], width);
            text.push_str(&format!("{columns},{rows},{:.9e}\n", own - less));
        }
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/solve_layer.csv");
    Ok(std::fs::write(path, text)?)
}

/// What is integrated: the difference of a layer from the half-space.
struct Layer {
    /// k h, and weight times 1 - L(k h).
    waves: Vec<[f64; 2]>,
    cell: GaussLegendre,
}

impl Layer {
    fn new() -> Result<Self, Box<dyn Error>> {
        let (rule, mut waves) = (GaussLegendre::new(16)?, Vec::new());
        // 1 - L falls as 4x exp(-2x).
        for panel in 0..40 {
            let start = 0.5 * f64::from(panel);
            for node in rule.on(start, start + 0.5) {
                let x: f64 = node.position;
                let part = 2.0 * x.sinh().powi(2) / ((2.0 * x).sinh() + 2.0 * x);
                waves.push([x, node.weight * (1.0 - part)]);
            }
        }
        Ok(Self { waves, cell: GaussLegendre::new(3)? })
    }

    /// How much less a cell of the layer is displaced than one of the half-space by a unit pressure on a cell of
    /// this width at this offset, m/Pa.
    fn less_than_half_space(&self, [x, y]: [f64; 2], width: f64) -> f64 {
        let half = 0.5 * width;
        self.cell.integrate(x - half, x + half, |x| {
            self.cell.integrate(y - half, y + half, |y| self.of_point(x.hypot(y)))
        })
    }

    /// The same for a unit force at the distance `r`, m/N: (1 - nu)/(2 pi G h) times the integral over k h of
    /// (1 - L) J_0(k r).
    fn of_point(&self, r: f64) -> f64 {
        let scale = (1.0 - POISSON) / (2.0 * PI * SHEAR_MODULUS * THICKNESS);
        let sum: f64 = self.waves.iter().map(|[x, part]| part * libm::j0(x * r / THICKNESS)).sum();
        scale * sum
    }
}
