//! Writes the influence numbers of a steel wheel on a rail in the format of the program CONTACT,
//! `examples/roll_inflcf.txt`: of half-spaces, to be replaced by those of the real bodies.
//!
//! Lengths are in millimetres, the numbers are displacements of both bodies times the shear modulus of one over tractions,
//! offsets are receiver minus source: those >= 0 along x for each one along y, in the order n, x, y.

use carom_halfspace::operator::{HalfSpaceOperator, SurfaceOperator};
use carom_halfspace::{Grid, Material, MaterialPair};
use std::error::Error;
use std::fmt::Write as _;

/// Cells and their width, mm.
const CELLS: [i32; 2] = [24, 16];
const WIDTH: f64 = 1.0;

fn main() -> Result<(), Box<dyn Error>> {
    let steel = Material::from_young(206e3, 0.28)?;
    let pair = MaterialPair::new(steel, steel)?;
    let [mx, my] = CELLS;
    let grid = Grid::new(mx as usize, my as usize, WIDTH, WIDTH)?;
    let operator = HalfSpaceOperator::new(pair, grid)?;
    let mut text = format!(
        "% influence of one cell of {WIDTH} mm on another: half-spaces of steel\n\
         1 2      % number of matrices, convex body\n\
         0 312    % nine numbers a line, in the order n, x, y\n\
         1 0      % symmetric in x, not in y\n\
         {mx} {my} {WIDTH} {WIDTH}  % cells and their widths\n"
    );
    for iy in 1 - my..my {
        // CONTACT skips two lines before each offset.
        writeln!(
            text,
            "% offset {iy} along y\n% ix, x, n-, x- and y-displacement by p_n, p_x, p_y"
        )?;
        for ix in 0..mx {
            let rows = operator.coefficients(-ix, -iy).rows;
            write!(text, "{ix} {}", f64::from(ix) * WIDTH)?;
            for (of, by) in [2, 0, 1].into_iter().flat_map(|of| [2, 0, 1].map(|by| (of, by))) {
                write!(text, " {:.6e}", 2.0 * pair.shear_modulus() * rows[of][by])?;
            }
            text.push('\n');
        }
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/roll_inflcf.txt");
    Ok(std::fs::write(path, text)?)
}
