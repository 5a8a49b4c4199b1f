//! Outlines on grids whose sides and cells differ along x and y.

use std::f64::consts::PI;

use carom_halfspace::{Field, Grid};
use carom_solver::contours;

#[test]
fn the_outline_of_an_ellipse_aside_of_the_middle_is_that_ellipse() {
    let (centre, semi_axes) = ([0.31, -0.52], [0.7, 1.1]);
    for (nx, ny, dx, dy) in [(90, 70, 0.03, 0.06), (70, 160, 0.04, 0.025)] {
        let grid = Grid::new(nx, ny, dx, dy).unwrap();
        let scaled = |x: f64, y: f64| {
            ((x - centre[0]) / semi_axes[0]).powi(2) + ((y - centre[1]) / semi_axes[1]).powi(2)
        };
        let field = Field::from_function(grid, |x, y| 1.0 - scaled(x, y));
        let lines = contours(&field, 0.0, -1.0);
        assert_eq!(lines.len(), 1);
        for [x, y] in &lines[0].points {
            assert!((scaled(*x, *y) - 1.0).abs() < 3e-3, "{x} {y}");
        }
        let area = PI * semi_axes[0] * semi_axes[1];
        assert!((lines[0].area() / area - 1.0).abs() < 3e-3);
        // The extents of the ellipse are reached along both axes.
        for axis in 0..2 {
            let along = lines[0].points.iter().map(|point| point[axis]);
            let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
                (low.min(at), high.max(at))
            });
            assert!((low - (centre[axis] - semi_axes[axis])).abs() < 0.01, "{axis} {low}");
            assert!((high - (centre[axis] + semi_axes[axis])).abs() < 0.01, "{axis} {high}");
        }
    }
}
