//! The gap on a grid and for a shape that are different along x and y.

use approx::assert_relative_eq;
use carom_geometry::{ContactPoint, Placed, Surface};
use carom_halfspace::{Field, Grid};
use carom_laws::curvature::RelativeCurvature;
use carom_solver::{Gap, HeightMap, Outline, SelfAffine, Shape};

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

fn grid(n: usize, width: f64) -> Grid {
    Grid::new(n, n, width, width).unwrap()
}

fn touching(one: Surface, height: f64, two: Surface, depth: f64) -> Gap {
    let one = Placed::new(one).at([0.0, 0.0, height]).unwrap();
    let two = Placed::new(two).at([0.0, 0.0, depth]).unwrap();
    let touch = ContactPoint::find(&one, &two).unwrap();
    Gap::between(grid(21, 0.05), [&one, &two], &touch).unwrap()
}

#[test]
fn surfaces_in_space_make_the_gaps_of_their_formulas() {
    let sphere = touching(Surface::sphere(1.5).unwrap(), 1.5, Surface::plane(), 0.0);
    let want = Gap::sphere(sphere.grid(), 1.5).unwrap();
    for (got, want) in sphere.heights().values().iter().zip(want.heights().values()) {
        assert_relative_eq!(*got, *want, epsilon = 1e-14);
    }
    // Two ellipsoids tip to tip: c (1 - sqrt(1 - x^2/a^2 - y^2/b^2)) each.
    let egg = |axes| Surface::ellipsoid(axes).unwrap();
    let (one, two) = ([1.0, 2.0, 1.5], [3.0, 1.2, 0.8]);
    let gap = touching(egg(one), 1.5, egg(two), -0.8);
    let height = |[a, b, c]: [f64; 3], x: f64, y: f64| {
        c * (1.0 - (1.0 - (x / a).powi(2) - (y / b).powi(2)).sqrt())
    };
    // The contact rotates the axes: compare at the same distances along the principal axes.
    let centre = *gap.heights().get(10, 10).unwrap();
    assert!(centre.abs() < 1e-12, "{centre}");
    for (i, at) in [(15, 0.25), (20, 0.5)] {
        let along = *gap.heights().get(i, 10).unwrap();
        let across = *gap.heights().get(10, i).unwrap();
        let (x, y) = (
            height(one, at, 0.0) + height(two, at, 0.0),
            height(one, 0.0, at) + height(two, 0.0, at),
        );
        let (greater, smaller) = if x > y { (x, y) } else { (y, x) };
        assert_relative_eq!(along, greater, epsilon = 1e-11);
        assert_relative_eq!(across, smaller, epsilon = 1e-11);
    }
    // A small ball does not cover the grid.
    let ball = touching(Surface::sphere(0.3).unwrap(), 0.3, Surface::plane(), 0.0);
    assert!(ball.heights().get(0, 10).unwrap().is_infinite());
}

#[test]
fn punches_have_the_area_of_their_outline() {
    let grid = grid(200, 0.02);
    let area = |outline: &Outline| {
        let gap = Gap::punch(grid, outline).unwrap();
        gap.heights().values().iter().filter(|z| **z == 0.0).count() as f64 * grid.cell_area()
    };
    let corners = [[-1.0, -1.0], [1.5, -0.5], [0.0, 1.2]];
    let dart = vec![[-1.0, -1.0], [1.0, 0.0], [-1.0, 1.0], [-0.2, 0.0]];
    let cases = [
        (Outline::Disc { radius: 1.1 }, std::f64::consts::PI * 1.21),
        (Outline::Ellipse { half_x: 1.5, half_y: 0.5 }, std::f64::consts::PI * 0.75),
        (Outline::Rectangle { half_x: 1.2, half_y: 0.4 }, 1.92),
        (Outline::Triangle(corners), 2.5),
        (Outline::Polygon(dart.clone()), 1.2),
        (Outline::Polygon(dart.into_iter().rev().collect()), 1.2),
    ];
    for (outline, want) in cases {
        let got = area(&outline);
        assert!((got - want).abs() < 0.02 * want, "{outline:?}: {got} {want}");
    }
    for bad in [
        Outline::Disc { radius: -1.0 },
        Outline::Disc { radius: 1e-3 },
        Outline::Polygon(vec![[0.0, 0.0], [1.0, 1.0]]),
        Outline::Polygon(vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]),
        Outline::Triangle([[0.0, 0.0], [f64::NAN, 1.0], [2.0, 0.0]]),
    ] {
        assert!(Gap::punch(grid, &bad).is_err(), "{bad:?}");
    }
}

#[test]
fn a_wrong_height_map_says_where() {
    let text = |rows: &[Vec<f64>]| HeightMap::from_rows(rows).unwrap_err().to_string();
    assert_eq!(text(&[]), "the height map is empty");
    assert_eq!(text(&[vec![]]), "the height map is empty");
    let ragged = [vec![1.0, 2.0], vec![1.0]];
    assert_eq!(text(&ragged), "row 2 of the height map has 1 values, the first 2");
    let holed = [vec![1.0, 2.0], vec![f64::NAN, 1.0]];
    assert_eq!(text(&holed), "the height map is NaN in row 2, column 1: must be finite");
    let map = HeightMap::from_rows(&[vec![1.0; 6], vec![2.0; 6]]).unwrap();
    let error = map.gap(Grid::new(4, 3, 1.0, 1.0).unwrap()).unwrap_err().to_string();
    assert_eq!(error, "the height map has 6 x 2 values, the grid 4 x 3 cells");
    let great = HeightMap::from_rows(&[vec![1.0, -1.0], vec![1e100, 1e308]]).unwrap();
    let error = great.gap(Grid::new(2, 2, 0.5, 0.5).unwrap()).unwrap_err().to_string();
    let limit = "must be at most 1e100 times the longer side of the grid";
    assert_eq!(error, format!("the height map is 1e308 in row 2, column 2: {limit}"));
}

#[test]
fn heights_may_stand_on_a_ball() {
    let grid = Grid::new(5, 3, 0.1, 0.4).unwrap();
    let flat = HeightMap::from_rows(&vec![vec![0.25; 5]; 3]).unwrap().gap_over(grid, 2.0).unwrap();
    // Zero heights leave the paraboloid, measured from its centre.
    for (gap, (x, y)) in flat.heights().values().iter().zip(grid.centres()) {
        assert_relative_eq!(*gap, 0.25 * (x * x + y * y), epsilon = 1e-15);
    }
}

#[test]
fn a_rough_surface_is_the_same_on_any_grid_and_has_its_spectrum() {
    let surface = SelfAffine { hurst: 0.7, rms: 0.2, longest: 8.0, shortest: 1.0, seed: 7 };
    let heights = |n: usize| surface.heights(grid(n, 16.0 / n as f64)).unwrap();
    let (coarse, fine) = (heights(64), heights(192));
    let rms = |field: &Field| {
        (field.values().iter().map(|z| z * z).sum::<f64>() / field.values().len() as f64).sqrt()
    };
    assert_relative_eq!(rms(&coarse), 0.2, epsilon = 1e-12);
    assert_relative_eq!(rms(&fine), 0.2, epsilon = 1e-12);
    // The central one of three by three cells has the position of the coarse cell.
    for (ix, iy) in [(0, 0), (5, 60), (33, 17)] {
        let (a, b) = (coarse.get(ix, iy).unwrap(), fine.get(3 * ix + 1, 3 * iy + 1).unwrap());
        assert_relative_eq!(*a, *b, epsilon = 1e-12);
    }
    assert_eq!(heights(64), coarse);
    assert_ne!(SelfAffine { seed: 8, ..surface }.heights(coarse.grid()).unwrap(), coarse);
    // Slopes weight waves by q^2: they decrease with H.
    let slope = |hurst: f64| {
        let z = SelfAffine { hurst, ..surface }.heights(grid(192, 16.0 / 192.0)).unwrap();
        let steps = z.values().windows(2).map(|pair| (pair[1] - pair[0]).powi(2));
        steps.sum::<f64>().sqrt()
    };
    assert!(slope(0.2) > 1.5 * slope(1.0));
    let wrong = |surface: SelfAffine| surface.gap(grid(64, 0.25)).unwrap_err().field;
    assert_eq!(wrong(SelfAffine { hurst: 1.2, ..surface }), "hurst");
    assert_eq!(wrong(SelfAffine { shortest: 0.3, ..surface }), "shortest");
    assert_eq!(wrong(SelfAffine { longest: 17.0, ..surface }), "longest");
    assert_eq!(wrong(SelfAffine { rms: f64::NAN, ..surface }), "rms");
}

#[test]
fn formulas_rise_as_they_say() {
    let grid = Grid::new(9, 7, 0.1, 0.2).unwrap();
    let at = |gap: Result<Gap, _>, ix, iy| *gap.unwrap().heights().get(ix, iy).unwrap();
    assert_relative_eq!(at(Gap::cone(grid, 0.5), 7, 5), 0.25, epsilon = 1e-15);
    assert_relative_eq!(at(Gap::wedge(grid, 0.5), 7, 5), 0.15, epsilon = 1e-15);
    assert_relative_eq!(at(Gap::cylinder(grid, 0.5), 7, 5), 0.1, epsilon = 1e-15);
    let wavy = Gap::wavy(grid, [0.1, 0.3], [0.6, 0.8]);
    assert_relative_eq!(at(wavy, 7, 5), 0.2 + 0.6, epsilon = 1e-15);
    assert_eq!(Gap::cone(grid, 0.0).unwrap_err().field, "slope");
    assert_eq!(Gap::wavy(grid, [0.1, 0.1], [1.0, 0.0]).unwrap_err().field, "wavelength");
}

/// A paraboloid of one radius is a cylinder near its axis, and one of two equal radii a ball; the larger radius
/// does not matter, and a unit of length neither.
#[test]
fn a_contact_is_looked_for_within_the_smaller_radius() {
    for unit in [1e-6, 1.0, 1e3] {
        let of = |x: f64, y: f64| Shape::Paraboloid { radii: [x * unit, y * unit] }.sides();
        let cylinder = Shape::Cylinder { radius: 0.3 * unit }.sides();
        for large in [0.3, 5.0, 1e9, f64::INFINITY] {
            assert_eq!(of(0.3, large), cylinder);
            assert_eq!(of(large, 0.3), cylinder);
        }
    }
}
