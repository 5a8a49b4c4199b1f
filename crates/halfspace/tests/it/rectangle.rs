//! Rectangle coefficients against 70- and 80-digit values, additivity, parity and limits.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use carom_halfspace::{
    Coefficients, Displacement, Force, Material, MaterialPair, Offset, Point, PointInfluence,
    PointLoad, Rectangle, RectangleInfluence, RectangleIntegrals, Traction,
};
use proptest::prelude::*;
use serde_json::Value;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
}

fn material(shear_modulus: f64, poisson: f64) -> Material {
    if shear_modulus.is_infinite() {
        Material::RIGID
    } else {
        Material::from_shear(shear_modulus, poisson).unwrap()
    }
}

#[test]
fn nine_coefficients_of_two_bodies() {
    let data: Value =
        serde_json::from_str(include_str!("../data/rectangle_influence.json")).unwrap();
    let cases = data["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 63);
    let mut worst = 0.0f64;
    for case in cases {
        let inp = |name: &str| number(&case["inp"][name]);
        let pair =
            MaterialPair::new(material(inp("G1"), inp("nu1")), material(inp("G2"), inp("nu2")));
        let cell = Rectangle::new(2.0 * inp("dx"), 2.0 * inp("dy")).unwrap();
        let offset = Offset { x: 2.0 * inp("dx") * inp("n"), y: 2.0 * inp("dy") * inp("m") };
        let got = RectangleInfluence::new(pair.unwrap(), cell).coefficients(offset).unwrap();
        let mut expected = Coefficients::default();
        for (i, row) in expected.rows.iter_mut().enumerate() {
            for (l, value) in row.iter_mut().enumerate() {
                *value = number(&case["out"]["A"][i][l]);
            }
        }
        for (g, e) in got.rows.iter().flatten().zip(expected.rows.iter().flatten()) {
            worst = worst.max((g - e).abs() / expected.largest());
        }
    }
    assert!(worst < 2e-15, "worst error {worst:e} of the largest of the nine");
}

fn listed(i: RectangleIntegrals) -> [f64; 6] {
    [i.inverse_distance, i.xx, i.yy, i.xy, i.log_x, i.log_y]
}

#[test]
fn integrals_of_any_shape_at_any_offset() {
    let data: Value =
        serde_json::from_str(include_str!("../data/rectangle_integrals.json")).unwrap();
    let cases = data["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 296);
    let (mut worst, mut at) = (0.0f64, Vec::new());
    for case in cases {
        let values: Vec<f64> = case.as_array().unwrap().iter().map(number).collect();
        let cell = Rectangle::new(values[0], values[1]).unwrap();
        let got = cell.integrals(Offset { x: values[2], y: values[3] }).unwrap();
        for (g, e) in listed(got).iter().zip(&values[4..]) {
            let error = (g - e).abs() / values[4];
            if error > worst {
                (worst, at) = (error, values.clone());
            }
        }
    }
    assert!(worst < 2e-15, "worst error {worst:e} of the integral of 1/r at {at:?}");
}

#[test]
fn self_cell_of_a_square_is_the_textbook_value() {
    let own = Rectangle::new(1.0, 1.0).unwrap().integrals(Offset::default()).unwrap();
    assert_relative_eq!(own.inverse_distance, 4.0 * (1.0 + 2f64.sqrt()).ln(), max_relative = 4e-16);
    assert_eq!((own.xy, own.log_x, own.log_y), (0.0, 0.0, 0.0));
}

#[test]
fn corner_and_edge_points_are_finite_limits() {
    let cell = Rectangle::new(2.0, 2.0).unwrap();
    let corner = cell.integrals(Offset { x: 1.0, y: 1.0 }).unwrap();
    let quarter = Rectangle::new(4.0, 4.0).unwrap().integrals(Offset::default()).unwrap();
    assert_relative_eq!(
        corner.inverse_distance,
        quarter.inverse_distance / 4.0,
        max_relative = 1e-15
    );
    // (4.28), x1 = 1.3, y1 = .8, is minus the integral of X/r^2 over a cell with a corner at 0.
    let thesis = Rectangle::new(1.3, 0.8).unwrap().integrals(Offset { x: 0.65, y: 0.4 }).unwrap();
    assert_relative_eq!(thesis.log_x, 1.2340136253695224, max_relative = 1e-15);
    let edge = cell.integrals(Offset { x: 1.0, y: 0.0 }).unwrap();
    assert!(listed(edge).iter().all(|value| value.is_finite()));
}

#[test]
fn bad_cells_and_offsets_are_named() {
    assert_eq!(Rectangle::new(0.0, 1.0).unwrap_err().field, "width_x");
    assert_eq!(Rectangle::new(1.0, -1.0).unwrap_err().field, "width_y");
    assert_eq!(Rectangle::new(1.0, f64::NAN).unwrap_err().field, "width_y");
    let cell = Rectangle::new(1.0, 1.0).unwrap();
    assert_eq!(cell.integrals(Offset { x: f64::NAN, y: 0.0 }).unwrap_err().field, "offset x");
}

#[test]
fn extreme_sizes_neither_overflow_nor_vanish() {
    for size in [1e-300, 1e-150, 1e150, 1e300] {
        let cell = Rectangle::new(size, 2.0 * size).unwrap();
        let unit = Rectangle::new(1.0, 2.0).unwrap();
        for offset in [0.0, 1.0, 7.0, 3e7] {
            let big = cell.integrals(Offset { x: offset * size, y: offset * size }).unwrap();
            let one = unit.integrals(Offset { x: offset, y: offset }).unwrap();
            assert_relative_eq!(
                big.inverse_distance / size,
                one.inverse_distance,
                max_relative = 1e-14
            );
        }
    }
    let far = Rectangle::new(1e-300, 1e-300).unwrap().integrals(Offset { x: 1e300, y: 1e300 });
    assert!(listed(far.unwrap()).iter().all(|value| value.is_finite()));
}

#[test]
fn point_influence_is_the_load_on_both_bodies() {
    // u = u1 - u2 of (4.6): body 2 carries the opposite tangential force, z into it.
    let (one, two) = (material(1.3, 0.2), material(0.7, 0.45));
    let pair = MaterialPair::new(one, two).unwrap();
    let (x, y) = (0.8, -0.3);
    let force = Force { x: 0.4, y: -1.1, z: 0.6 };
    let found = PointInfluence::new(pair).coefficients(Offset { x: -x, y: -y }).unwrap();
    let found = found.displacement(Traction { x: force.x, y: force.y, normal: force.z });
    let at = Point::on_surface(x, y);
    let on_one = PointLoad::new(one, force).unwrap().displacement(at).unwrap();
    let opposite = Force { x: -force.x, y: -force.y, z: force.z };
    let on_two = PointLoad::new(two, opposite).unwrap().displacement(at).unwrap();
    let expected =
        Displacement { u: on_one.u - on_two.u, v: on_one.v - on_two.v, w: on_one.w + on_two.w };
    assert_abs_diff_eq!(found.u, expected.u, epsilon = 1e-15);
    assert_abs_diff_eq!(found.v, expected.v, epsilon = 1e-15);
    assert_abs_diff_eq!(found.w, expected.w, epsilon = 1e-15);
    // A small rectangle acts as a point.
    let cell = RectangleInfluence::new(pair, Rectangle::new(1e-9, 1e-9).unwrap());
    let cell = cell.coefficients(Offset { x: -x, y: -y }).unwrap();
    let point = PointInfluence::new(pair).coefficients(Offset { x: -x, y: -y }).unwrap();
    for (c, p) in cell.rows.iter().flatten().zip(point.rows.iter().flatten()) {
        assert_abs_diff_eq!(c / 1e-18, *p, epsilon = 1e-15);
    }
    let here = PointInfluence::new(pair).coefficients(Offset::default());
    assert_eq!(here.unwrap_err().field, "r");
}

proptest! {
    #[test]
    fn parts_add_up_to_the_whole(
        log_ratio in -3.5..3.5f64, x in -6.0..6.0f64, y in -6.0..6.0f64, cut in 0.05..0.95f64,
    ) {
        // The cell cut along x at `cut`; offsets in widths of the cell.
        let (wx, wy) = (1.0, 10f64.powf(log_ratio));
        let offset = Offset { x, y: y * wy };
        let whole = Rectangle::new(wx, wy).unwrap().integrals(offset).unwrap();
        let part = |width: f64, centre: f64| {
            let moved = Offset { x: x + centre, y: offset.y };
            listed(Rectangle::new(width, wy).unwrap().integrals(moved).unwrap())
        };
        let left = part(cut * wx, 0.5 * (cut - 1.0));
        let right = part((1.0 - cut) * wx, 0.5 * cut);
        for ((l, r), w) in left.iter().zip(right).zip(listed(whole)) {
            assert_abs_diff_eq!(l + r, w, epsilon = 2e-14 * whole.inverse_distance);
        }
    }

    #[test]
    fn parity_is_exact(x in -9.0..9.0f64, y in -9.0..9.0f64, wy in 0.01..100.0f64) {
        let cell = Rectangle::new(1.0, wy).unwrap();
        let at = |x: f64, y: f64| cell.integrals(Offset { x, y }).unwrap();
        let (here, left) = (at(x, y), at(-x, y));
        prop_assert_eq!(left, RectangleIntegrals { xy: -here.xy, log_x: -here.log_x, ..here });
        let below = at(x, -y);
        prop_assert_eq!(below, RectangleIntegrals { xy: -here.xy, log_y: -here.log_y, ..here });
    }

    #[test]
    fn exchange_of_the_axes(x in -9.0..9.0f64, y in -9.0..9.0f64, wy in 0.01..100.0f64) {
        let one = Rectangle::new(1.0, wy).unwrap().integrals(Offset { x, y }).unwrap();
        let other = Rectangle::new(wy, 1.0).unwrap().integrals(Offset { x: y, y: x }).unwrap();
        let scale = one.inverse_distance;
        assert_abs_diff_eq!(one.xx, other.yy, epsilon = 2e-15 * scale);
        assert_abs_diff_eq!(one.xy, other.xy, epsilon = 2e-15 * scale);
        assert_abs_diff_eq!(one.log_x, other.log_y, epsilon = 2e-15 * scale);
    }
}
