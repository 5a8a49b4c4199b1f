//! The operator of the rectangular plate against independent series.

use std::f64::consts::PI;

use carom_halfspace::operator::{
    DisplacementField, OperatorError, Plate, PlateOperator, PlateSymbol, SurfaceOperator, Threads,
    TractionField,
};
use carom_halfspace::{Grid, Material, MaterialPair};
use serde_json::Value;

/// Rigid on E/(1 - nu^2) = `plane_modulus`.
fn under_rigid(plane_modulus: f64) -> MaterialPair {
    let plate = Material::from_young(0.91 * plane_modulus, 0.3).unwrap();
    MaterialPair::new(Material::RIGID, plate).unwrap()
}

fn operator(plate: Plate, cells: [usize; 2], kind: PlateSymbol, modulus: f64) -> PlateOperator {
    let grid = plate.grid(cells[0], cells[1]).unwrap();
    PlateOperator::new(under_rigid(modulus), plate, grid, kind, Threads::One).unwrap()
}

fn product(operator: &PlateOperator, pressure: &[f64]) -> Vec<f64> {
    let mut w = vec![f64::NAN; pressure.len()];
    let displacement = DisplacementField::normal(&mut w);
    let load = TractionField::normal(pressure);
    operator.apply(load, displacement, &mut operator.workspace()).unwrap();
    w
}

fn unit(grid: Grid, column: usize, row: usize) -> Vec<f64> {
    let mut unit = vec![0.0; grid.cells()];
    unit[grid.index(column, row)] = 1.0;
    unit
}

fn data() -> Value {
    serde_json::from_str(include_str!("../data/plate.json")).unwrap()
}

#[test]
fn eigenvalues_are_those_of_an_independent_program() {
    let data = data();
    let values = data["eigenvalues"].as_array().unwrap();
    assert_eq!(values.len(), 10);
    for case in values {
        let number = |name: &str| case[name].as_f64().unwrap();
        let count = |name: &str| case[name].as_u64().unwrap() as usize;
        let (kind, thickness) = match case["symbol"].as_str().unwrap() {
            "kirchhoff" => (PlateSymbol::Kirchhoff, number("h")),
            "layer" => (PlateSymbol::Layer, number("h")),
            // So thick that even the longest wave sees a half-space.
            _ => (PlateSymbol::Layer, 100.0),
        };
        let plate = Plate::new(number("a"), number("b"), thickness).unwrap();
        let operator = operator(plate, [count("nx"), count("ny")], kind, 1.0);
        let found = operator.eigenvalue(count("m"), count("n")).unwrap();
        let error = (found / number("value") - 1.0).abs();
        assert!(error < 2e-13, "{case}: {found}");
        assert_eq!(operator.eigenvalue(0, 1), None);
        assert_eq!(operator.eigenvalue(1, count("ny") + 1), None);
    }
}

/// Navier's double series and Levy's single one give the same influence.
#[test]
fn coefficients_are_those_of_navier_and_of_levy() {
    let plate = Plate::new(1.0, 0.8, 0.1).unwrap();
    // D = 1.
    let operator = operator(plate, [20, 16], PlateSymbol::Kirchhoff, 12e3);
    let largest = 2.195e-5;
    let data = data();
    for case in data["coefficients"].as_array().unwrap() {
        let place = |name: &str| [0, 1].map(|i| case[name][i].as_u64().unwrap() as usize);
        let ([ix, iy], [jx, jy]) = (place("receiver"), place("source"));
        let found = product(&operator, &unit(operator.grid(), jx, jy));
        let found = found[operator.grid().index(ix, iy)];
        let (navier, levy) = (case["value"].as_f64().unwrap(), case["by_levy"].as_f64().unwrap());
        assert!((found - navier).abs() < 1e-12 * largest, "{case}: {found}");
        assert!((found - levy).abs() < 1e-12 * largest, "{case}: {found}");
    }
}

/// A uniform load on all cells is one on the plate, and Navier's series for it is
/// `16 q/(pi^6 D) sum 1/(m n (m^2/a^2 + n^2/b^2)^2)` with sines, over odd m and n.
#[test]
fn uniform_load_bends_as_navier_and_timoshenko_say() {
    let (a, b) = (1.0, 1.7);
    let plate = Plate::new(a, b, 1e-3).unwrap();
    // D = 1.
    let operator = operator(plate, [15, 11], PlateSymbol::Kirchhoff, 12e9);
    let grid = operator.grid();
    let w = product(&operator, &vec![1.0; grid.cells()]);
    for (column, row) in [(7, 5), (0, 0), (3, 9)] {
        let place = [(column, 15, a), (row, 11, b)];
        let [x, y] = place.map(|(i, n, side)| (i as f64 + 0.5) * side / f64::from(n));
        let mut sum = 0.0;
        for m in (1..1500).step_by(2).map(f64::from) {
            for n in (1..1500).step_by(2).map(f64::from) {
                let square = (m / a).powi(2) + (n / b).powi(2);
                let wave = (m * PI * x / a).sin() * (n * PI * y / b).sin();
                sum += wave / (m * n * square * square);
            }
        }
        let want = 16.0 / PI.powi(6) * sum;
        let found = w[grid.index(column, row)];
        assert!((found - want).abs() < 1e-10 * w[grid.index(7, 5)], "{found} {want}");
    }
    let square = Plate::new(2.0, 2.0, 1e-3).unwrap();
    let known = middle_by_levy();
    assert!((known - 0.00406235266).abs() < 1e-11);
    for n in [1, 5, 25] {
        let operator = self::operator(square, [n; 2], PlateSymbol::Kirchhoff, 12e9);
        let w = product(&operator, &vec![1.0; n * n]);
        // w = alpha q a^4/D.
        assert!((w[n * n / 2] / 16.0 / known - 1.0).abs() < 1e-12, "{n}: {}", w[n * n / 2]);
    }
}

/// The middle of a square plate under uniform load, by Levy's series: a beam, and what the edges
/// along it hold back.
fn middle_by_levy() -> f64 {
    let wave = |m: f64| {
        let half = 0.5 * PI * m;
        4.0 * PI.powi(-5) / m.powi(5) * (half * half.tanh() + 2.0) / (2.0 * half.cosh())
    };
    let sign = |i: i32| if i % 2 == 0 { 1.0 } else { -1.0 };
    5.0 / 384.0 - (0..20).map(|i| sign(i) * wave(f64::from(2 * i + 1))).sum::<f64>()
}

/// A force on the middle cell, by Navier's series with the mean of each wave over the cell.
fn middle_by_navier(n: usize) -> f64 {
    let mean = |m: f64| {
        let turn = 0.5 * PI * m / n as f64;
        turn.sin() / turn
    };
    let odd = || (1..1201).step_by(2).map(f64::from);
    let along = |m: f64| odd().map(|n| mean(n) / (m * m + n * n).powi(2)).sum::<f64>();
    4.0 / PI.powi(4) * odd().map(|m| mean(m) * along(m)).sum::<f64>()
}

/// The deflection under a force tends to 0.0116008 P a^2/D with smaller cells.
#[test]
fn force_in_the_middle_bends_as_timoshenko_says() {
    let plate = Plate::new(1.0, 1.0, 1e-3).unwrap();
    let known = data()["point_load_centre"].as_f64().unwrap();
    for n in [25, 51] {
        let operator = operator(plate, [n; 2], PlateSymbol::Kirchhoff, 12e9);
        let own = operator.coefficients(0, 0).rows[2][2] * (n * n) as f64;
        assert!((own / middle_by_navier(n) - 1.0).abs() < 1e-9, "{own}");
        assert!((own / known - 1.0).abs() < 3.0 / (n * n) as f64 * (n as f64).ln());
    }
}

#[test]
fn operator_is_symmetric_and_its_inverse_exact() {
    let plate = Plate::new(1.0, 0.7, 0.05).unwrap();
    for kind in [PlateSymbol::Layer, PlateSymbol::Sum, PlateSymbol::Kirchhoff, PlateSymbol::Mindlin]
    {
        for cells in [[12, 10], [9, 7], [1, 4]] {
            let operator = operator(plate, cells, kind, 3.0);
            let grid = operator.grid();
            let (one, other) = ((0, 0), (cells[0] - 1, cells[1] / 2));
            let there = product(&operator, &unit(grid, one.0, one.1));
            let back = product(&operator, &unit(grid, other.0, other.1));
            let [there, back] = [there[grid.index(other.0, other.1)], back[0]];
            let scale = operator.coefficients(0, 0).rows[2][2];
            assert!((there - back).abs() < 1e-14 * scale, "{there} {back}");
            let load: Vec<f64> = (0..grid.cells()).map(|i| (i as f64).sin()).collect();
            let w = product(&operator, &load);
            let mut found = vec![0.0; load.len()];
            operator.inverse().unwrap().pressure(&w, &mut found, &mut operator.workspace());
            for (found, load) in found.iter().zip(&load) {
                assert!((found - load).abs() < 1e-9, "{kind:?} {cells:?}: {found} {load}");
            }
        }
    }
}

/// Mindlin's plate is Kirchhoff's with the deflection by shear added: under a force, more than half
/// of the influence of a thick plate.
#[test]
fn theories_agree_for_thin_plates_and_differ_for_thick_ones() {
    let middle = |thickness: f64, kind| {
        let plate = Plate::new(1.0, 1.0, thickness).unwrap();
        operator(plate, [8, 8], kind, 1.0).coefficients(0, 0).rows[2][2]
    };
    let kirchhoff = |thickness| middle(thickness, PlateSymbol::Kirchhoff);
    for kind in [PlateSymbol::Layer, PlateSymbol::Sum, PlateSymbol::Mindlin] {
        assert!((middle(1e-4, kind) / kirchhoff(1e-4) - 1.0).abs() < 1e-4);
        assert!(middle(0.5, kind) > 1.5 * kirchhoff(0.5));
    }
}

/// An elastic punch adds the half-space of its own material, wave by wave.
#[test]
fn elastic_punch_adds_its_half_space() {
    let plate = Plate::new(1.0, 1.0, 0.1).unwrap();
    let grid = plate.grid(8, 8).unwrap();
    let punch = Material::from_young(2.73, 0.3).unwrap();
    let pane = Material::from_young(0.91, 0.3).unwrap();
    let value = |plate: Plate, pair| {
        let made = PlateOperator::new(pair, plate, grid, PlateSymbol::Layer, Threads::One);
        made.unwrap().eigenvalue(3, 5).unwrap()
    };
    let both = value(plate, MaterialPair::new(punch, pane).unwrap());
    let alone = value(plate, under_rigid(1.0));
    let thick = Plate::new(1.0, 1.0, 50.0).unwrap();
    let half_space = value(thick, under_rigid(3.0));
    assert!((both / (alone + half_space) - 1.0).abs() < 1e-13);
}

#[test]
fn threads_and_shared_workspaces_change_no_bit() {
    let plate = Plate::new(1.0, 0.5, 0.02).unwrap();
    let grid = plate.grid(45, 30).unwrap();
    let load: Vec<f64> = (0..grid.cells()).map(|i| (i as f64).cos()).collect();
    let run = |threads, pool: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(pool).build().unwrap();
        pool.install(|| {
            let made =
                PlateOperator::new(under_rigid(1.0), plate, grid, PlateSymbol::Layer, threads);
            product(&made.unwrap(), &load)
        })
    };
    let one = run(Threads::One, 1);
    for pool in [1, 2, 3, 7] {
        assert_eq!(run(Threads::Pool, pool), one);
    }
    // A workspace may serve operators of other grids in between.
    let operator = operator(plate, [45, 30], PlateSymbol::Layer, 1.0);
    let other = self::operator(plate, [7, 9], PlateSymbol::Layer, 1.0);
    let mut workspace = other.workspace();
    let (mut small, mut w) = (vec![0.0; 63], vec![0.0; grid.cells()]);
    for _ in 0..2 {
        let ones = vec![1.0; 63];
        let displacement = DisplacementField::normal(&mut small);
        other.apply(TractionField::normal(&ones), displacement, &mut workspace).unwrap();
        let displacement = DisplacementField::normal(&mut w);
        operator.apply(TractionField::normal(&load), displacement, &mut workspace).unwrap();
        assert_eq!(w, one);
    }
}

#[test]
fn coarser_keeps_the_plate() {
    let plate = Plate::new(1.0, 0.5, 0.02).unwrap();
    let fine = operator(plate, [24, 20], PlateSymbol::Layer, 1.0);
    let coarse = fine.coarser().unwrap().unwrap();
    assert_eq!((coarse.grid().nx(), coarse.grid().ny()), (12, 10));
    assert!((coarse.grid().dx() * 12.0 - 1.0).abs() < 1e-15);
    assert!(operator(plate, [24, 15], PlateSymbol::Layer, 1.0).coarser().is_none());
    assert!(fine.on_fewer(4, 4).is_none() && !fine.is_invariant());
    assert_eq!(fine.check_invariant(), Err(OperatorError::NotInvariant));
    let validity = fine.validity();
    assert!(!validity.contact_at_border && validity.displacement == 0.01);
}

#[test]
fn plates_out_of_range_are_refused() {
    let field = |a, b, h| Plate::new(a, b, h).unwrap_err().field;
    assert_eq!(field(0.0, 1.0, 0.1), "a");
    assert_eq!(field(1.0, f64::NAN, 0.1), "b");
    assert_eq!(field(1.0, 1.0, f64::INFINITY), "thickness");
    assert_eq!(field(1.0, 2.0, 1.9e-6), "thickness");
    assert!(Plate::new(1.0, 2.0, 2.1e-6).is_ok());
    let plate = Plate::new(1.0, 0.5, 0.02).unwrap();
    let make = |grid, pair| PlateOperator::new(pair, plate, grid, PlateSymbol::Layer, Threads::One);
    let short = Grid::new(10, 10, 0.1, 0.04).unwrap();
    let text = make(short, under_rigid(1.0)).unwrap_err().to_string();
    assert!(text.contains("ny dy") && text.contains("side b"), "{text}");
    let rigid = MaterialPair::new(Material::from_shear(1.0, 0.3).unwrap(), Material::RIGID);
    let text = make(plate.grid(4, 4).unwrap(), rigid.unwrap()).unwrap_err().to_string();
    assert!(text.contains("shear_modulus"), "{text}");
    let huge = plate.grid(1 << 20, 1 << 20).unwrap();
    let error = make(huge, under_rigid(1.0)).unwrap_err();
    assert!(matches!(error, OperatorError::TooLarge { .. }));
}

#[test]
fn tangential_tractions_and_displacements_are_refused() {
    let plate = Plate::new(1.0, 0.5, 0.02).unwrap();
    let operator = operator(plate, [4, 3], PlateSymbol::Layer, 1.0);
    let mut workspace = operator.workspace();
    let (load, zero) = (vec![1.0; 12], vec![0.0; 12]);
    let [mut u, mut v, mut w] = [(); 3].map(|()| vec![7.0; 12]);
    let to_w = DisplacementField::normal(&mut w);
    let error = operator.apply(TractionField::full(&zero, &load, &load), to_w, &mut workspace);
    assert!(matches!(error, Err(OperatorError::Missing { by: "traction y", .. })));
    let all = DisplacementField::full(&mut u, &mut v, &mut w);
    let error = operator.apply(TractionField::normal(&load), all, &mut workspace);
    assert!(matches!(error, Err(OperatorError::Missing { of: "displacement u", .. })));
    assert_eq!(w, [7.0; 12]);
    let short = DisplacementField::normal(&mut w[..5]);
    let error = operator.apply(TractionField::normal(&load), short, &mut workspace);
    assert!(matches!(error, Err(OperatorError::Length { .. })));
    let to_w = DisplacementField::normal(&mut w);
    operator.apply(TractionField::tangential(&zero, &zero), to_w, &mut workspace).unwrap();
    assert_eq!(w, [0.0; 12]);
}
