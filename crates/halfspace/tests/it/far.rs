//! At large distances a loaded rectangle acts as a point load.

use approx::assert_relative_eq;
use carom_halfspace::{
    Force, LoadedRectangle, Material, MaterialPair, Offset, Point, PointInfluence, PointLoad,
    Rectangle, RectangleInfluence, Traction,
};

const WIDTHS: [f64; 2] = [0.3, 0.8];

#[test]
fn far_below_and_beside_a_rectangle_acts_as_a_point_load() {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let rectangle = Rectangle::new(WIDTHS[0], WIDTHS[1]).unwrap();
    let loaded = LoadedRectangle::new(body, rectangle).unwrap();
    let area = WIDTHS[0] * WIDTHS[1];
    let load = Traction { x: 0.4, y: -0.2, normal: 1.5 };
    let force = Force { x: 0.4 * area, y: -0.2 * area, z: 1.5 * area };
    let point = PointLoad::new(body, force).unwrap();
    for far in [1e5, 1e7, 1e11] {
        let at = Point { x: 0.5 * far, y: -far, z: 0.7 * far };
        let (one, two) = (loaded.displacement(load, at).unwrap(), point.displacement(at).unwrap());
        assert_relative_eq!(one.u, two.u, max_relative = 1e-9);
        assert_relative_eq!(one.w, two.w, max_relative = 1e-9);
        let (one, two) = (loaded.stress(load, at).unwrap(), point.stress(at).unwrap());
        assert_relative_eq!(one.zz, two.zz, max_relative = 1e-9);
        assert_relative_eq!(one.xy, two.xy, max_relative = 1e-8);
    }
}

#[test]
fn far_coefficients_are_those_of_the_load_in_a_point() {
    let soft = Material::from_shear(2.0, 0.3).unwrap();
    let pair = MaterialPair::new(soft, Material::from_shear(5.0, 0.1).unwrap()).unwrap();
    let rectangle = Rectangle::new(WIDTHS[0], WIDTHS[1]).unwrap();
    let area = WIDTHS[0] * WIDTHS[1];
    for far in [1e6, 1e11] {
        let offset = Offset { x: 0.6 * far, y: -far };
        let one = RectangleInfluence::new(pair, rectangle).coefficients(offset).unwrap();
        let two = PointInfluence::new(pair).coefficients(offset).unwrap();
        for (one, two) in one.rows.iter().flatten().zip(two.rows.iter().flatten()) {
            assert_relative_eq!(*one, area * two, max_relative = 1e-10);
        }
    }
}

/// The error of a point load in the middle falls as the square of width over distance, that of Gauss's four
/// as its fourth power.
#[test]
fn a_thousand_widths_away_a_rectangle_is_more_than_a_point() {
    let body = Material::from_shear(2.0, 0.3).unwrap();
    let rectangle = Rectangle::new(WIDTHS[0], WIDTHS[1]).unwrap();
    let loaded = LoadedRectangle::new(body, rectangle).unwrap();
    let load = Traction { x: 0.4, y: -0.2, normal: 1.5 };
    let quarter = 0.25 * WIDTHS[0] * WIDTHS[1];
    let force = Force { x: 0.4 * quarter, y: -0.2 * quarter, z: 1.5 * quarter };
    let point = PointLoad::new(body, force).unwrap();
    let node = 0.5 / f64::sqrt(3.0);
    for far in [5e2, 2e3, 1e4] {
        let at = Point { x: 0.5 * far, y: -far, z: 0.7 * far };
        let nodes = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]].map(|[i, j]| Point {
            x: at.x + i * node * WIDTHS[0],
            y: at.y + j * node * WIDTHS[1],
            z: at.z,
        });
        let (stress, moved) = (loaded.stress(load, at).unwrap(), loaded.displacement(load, at));
        let sum = |of: &dyn Fn(Point) -> f64| nodes.map(of).iter().sum::<f64>();
        let zz = sum(&|at| point.stress(at).unwrap().zz);
        let xy = sum(&|at| point.stress(at).unwrap().xy);
        let w = sum(&|at| point.displacement(at).unwrap().w);
        assert_relative_eq!(stress.zz, zz, max_relative = 1e-11);
        assert_relative_eq!(stress.xy, xy, max_relative = 1e-11);
        assert_relative_eq!(moved.unwrap().w, w, max_relative = 1e-11);
    }
}
