//! The gap on a grid that is not square, with a shape that is not round.

use approx::assert_relative_eq;
use carom_halfspace::Grid;
use carom_laws::curvature::RelativeCurvature;
use carom_solver::Gap;

#[test]
fn columns_lie_along_x_and_rows_along_y() {
    let grid = Grid::new(5, 3, 0.1, 0.4).unwrap();
    let gap = Gap::of_curvature(grid, &RelativeCurvature::from_coefficients(3.0, 0.5).unwrap());
    for (ix, x) in [-0.2, -0.1, 0.0, 0.1, 0.2].into_iter().enumerate() {
        for (iy, y) in [-0.4, 0.0, 0.4].into_iter().enumerate() {
            let expected = 3.0 * x * x + 0.5 * y * y;
            assert_relative_eq!(*gap.heights().get(ix, iy).unwrap(), expected, epsilon = 1e-15);
        }
    }
    let tilted = Gap::from_function(grid, |x, y| 10.0 * x + y).unwrap();
    assert_relative_eq!(*tilted.heights().get(4, 0).unwrap(), 2.0 - 0.4, epsilon = 1e-15);
}
