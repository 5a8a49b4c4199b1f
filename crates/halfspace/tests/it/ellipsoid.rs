//! The product on a grid compared with the displacement due to an ellipsoidal traction, for any
//! axis ratio.

use carom_halfspace::operator::{
    DisplacementField, HalfSpaceOperator, SurfaceOperator, TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};
use serde_json::Value;

/// Cells along half an axis; the reference points lie at centres of cells.
const HALF: usize = 60;

#[test]
fn grid_converges_to_the_ellipsoidal_traction() {
    let data: Value =
        serde_json::from_str(include_str!("../data/ellipsoid_traction.json")).unwrap();
    let cases = data["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 44);
    for case in cases {
        let inp = |name: &str| case["inp"][name].as_f64().unwrap();
        let out = |name: &str| case["out"][name].as_str().unwrap().parse::<f64>().unwrap();
        let (a, b) = (inp("a"), inp("b"));
        let body = Material::from_shear(inp("G"), inp("nu")).unwrap();
        let pair = MaterialPair::new(body, Material::RIGID).unwrap();
        let n = 2 * HALF + 1;
        let grid = Grid::new(n, n, a / HALF as f64, b / HALF as f64).unwrap();
        let operator = HalfSpaceOperator::new(pair, grid).unwrap();
        let traction: Vec<f64> = (0..grid.cells())
            .map(|i| {
                let (s, t) = (grid.centred_x(i % n) / a, grid.centred_y(i / n) / b);
                (1.0 - s * s - t * t).max(0.0).sqrt()
            })
            .collect();
        let [mut u, mut v] = [0; 2].map(|_| vec![0.0; grid.cells()]);
        let load = TractionField { x: Some(&traction), ..Default::default() };
        let wanted = DisplacementField::tangential(&mut u, &mut v);
        operator.apply(load, wanted, &mut operator.workspace()).unwrap();
        let column = (HALF as f64 * (1.0 + inp("x") / a)).round() as usize;
        let row = (HALF as f64 * (1.0 + inp("y") / b)).round() as usize;
        let at = grid.index(column, row);
        let scale = out("u").abs();
        assert!((u[at] - out("u")).abs() < 2e-3 * scale, "u = {} in {case}", u[at]);
        assert!((v[at] - out("v")).abs() < 2e-3 * scale, "v = {} in {case}", v[at]);
    }
}
