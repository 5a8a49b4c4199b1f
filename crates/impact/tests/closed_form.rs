//! The closed forms of section 9.2 against reference values and the exact impact.

use carom_impact::closed_form::{AdhesiveCompression, compression_time};
use carom_impact::normal::compression;
use carom_impact::oblique::{Groups, ObliqueImpact};
use carom_special::hypergeometric::UnitArgument;
use serde_json::Value;

fn rows(start: &str) -> Vec<Value> {
    let data: Value = serde_json::from_str(include_str!("data/impact.json")).unwrap();
    let public = data["public"].as_object().unwrap();
    let (_, rows) = public.iter().find(|(key, _)| key.starts_with(start)).unwrap();
    rows.as_array().unwrap().clone()
}

fn number(row: &Value, key: &str) -> f64 {
    row[key].as_str().unwrap().parse().unwrap()
}

#[test]
fn time_of_s() {
    for row in rows("t_of_S") {
        let s = UnitArgument::new(number(&row, "S")).unwrap();
        let error = (compression_time(s).unwrap() - number(&row, "t_N")).abs();
        assert!(error < 4e-15, "{row} {error:e}");
    }
}

#[test]
fn adhesive_velocity_and_shift() {
    for row in rows("hypergeometric") {
        let motion = AdhesiveCompression::new(number(&row, "chi")).unwrap();
        let s = UnitArgument::new(number(&row, "S")).unwrap();
        let velocity = number(&row, "F((1-phi)/20,(1+phi)/20;3/5;S)");
        assert!((motion.velocity(s).unwrap() - velocity).abs() < 3e-13, "{row}");
        let shift = number(&row, "3F2(2/5,(11-phi)/20,(11+phi)/20;7/5,3/5;S)");
        let expected = s.value().powf(0.4) * shift;
        assert!((motion.shift(s).unwrap() - expected).abs() < 1e-13, "{row}");
    }
}

#[test]
fn series_about_maximal_compression() {
    for chi in [0.7, 1.0, 2.9, 3.5, 6.5] {
        let motion = AdhesiveCompression::new(chi).unwrap();
        for s in [0.5, 0.6, 0.9, 0.999, 1.0] {
            let s = UnitArgument::new(s).unwrap();
            let exact = motion.shift(s).unwrap();
            let error = |terms| (motion.shift_by_series(s, terms).unwrap() - exact).abs();
            assert!(error(25) < 1e-9, "{chi} {s:?} {:e}", error(25));
            assert!(error(45) < 2e-13, "{chi} {s:?} {:e}", error(45));
        }
    }
}

#[test]
fn the_exact_impact_starts_with_it() {
    let (chi, w) = (3.5, [0.9, 0.6, 0.4]);
    let trace = ObliqueImpact::trace(Groups::new(chi, 0.3).unwrap(), &w).unwrap();
    let motion = AdhesiveCompression::new(chi).unwrap();
    for (point, w) in trace.iter().zip(w) {
        let s = UnitArgument::new(compression(w).powf(2.5)).unwrap();
        assert!((point.velocity - motion.velocity(s).unwrap()).abs() < 1e-12);
        assert!((point.shift - motion.shift(s).unwrap()).abs() < 1e-12);
    }
}
