//! Layer 4, numerical contact: Cattaneo's problem on a grid.
//!
//! A ball is pressed on a plate and then loaded tangentially. The contact slips in an annulus and sticks
//! inside, in a disc of radius a (1 - F/fP)^(1/3).

use carom::halfspace::{Grid, Material, MaterialPair};
use carom::prelude::Friction;
use carom::solver::{
    CellState, ContactProblem, ContactState, Drive, Driven, Frictional, Gap, Method,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let cells = 96;
    let grid = Grid::new(cells, cells, 2.4 / cells as f64, 2.4 / cells as f64)?;
    let ball = Gap::from_function(grid, |x, y| 0.5 * (x * x + y * y))?;
    // Similar bodies with Poisson's ratio 0, for which Cattaneo's assumptions are exact.
    let cork = Material::from_shear(1.0, 0.0)?;
    let pair = MaterialPair::new(cork, cork)?;
    let (friction, pressed) = (0.3, 4.0 / 3.0);
    let problem = ContactProblem::of_half_spaces(ball, pair, Friction::new(friction)?)?;
    let method = Frictional::default();
    let mut scratch = method.scratch(&problem)?;
    let apart = ContactState::apart(grid);
    let mut state = apart.clone();
    println!("{:>6} {:>14} {:>14} {:>10}", "F/fP", "stick radius", "closed form", "products");
    for part in [0.2, 0.4, 0.6, 0.8] {
        let pull = Driven::Load(part * friction * pressed);
        let drive = Drive { normal: Driven::Load(pressed), x: pull, ..Drive::default() };
        let went = method.step(&problem, &apart, &drive, &mut state, &mut scratch, &mut ())?;
        let radius = |count: usize| (count as f64 * grid.cell_area() / std::f64::consts::PI).sqrt();
        let stick = radius(state.count(CellState::Stick));
        let contact = radius(state.count(CellState::Stick) + state.count(CellState::Slip));
        let expected = contact * f64::cbrt(1.0 - part);
        println!("{part:>6} {stick:>14.4} {expected:>14.4} {:>10}", went.products.tangential);
        assert!((stick - expected).abs() < 0.5 * grid.dx());
    }
    Ok(())
}
