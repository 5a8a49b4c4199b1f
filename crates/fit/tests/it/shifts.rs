//! Forces of a contact that is pressed and shifted step by step: modulus, friction, and the point of contact.

use crate::common::{close, of};
use carom_cases::history;
use carom_cases::input::CaseFile;
use carom_fit::{Data, FitError, Options, fit};

const CASE: &str = "
    body_1 = { radii = 0.01, material = { young_modulus = { fit = [1e10, 1e12] }, poisson = 0.3 } }
    body_2 = { radii = inf, material = { rigid = true } }
    contact = { friction = { fit = [0.01, 1] } }
    history = { zeta = 0, xi = 0, touch = { fit = [-1e-6, 1e-6] } }";
const MODULUS: f64 = 70e9;
const FRICTION: f64 = 0.2;
const TOUCH: f64 = 2e-7;

/// Readings of zeta, xi, and the forces of Hertz, Cattaneo and Mindlin: F_x = f (F_z(zeta) - F_z(zeta - xi/(kappa f))).
fn loop_of_shifts() -> [Vec<f64>; 4] {
    let force = |zeta: f64| 4.0 / 3.0 * MODULUS / 0.91 * 0.1 * zeta.max(0.0).powf(1.5);
    let kappa = (1.0 - 0.15) / (1.0 - 0.3);
    let mut rows: [Vec<f64>; 4] = Default::default();
    let mut put = |row: [f64; 4]| rows.iter_mut().zip(row).for_each(|(own, value)| own.push(value));
    for i in 0..12 {
        let zeta = 1e-7 * f64::from(i);
        put([zeta + TOUCH - 2e-7, 0.0, 0.0, force(zeta - 2e-7)]);
    }
    // At the last approach; from -xi to xi the change is twice the first one with half the shift.
    let deepest = 9e-7;
    let pull = |xi: f64| FRICTION * (force(deepest) - force(deepest - xi / (kappa * FRICTION)));
    let ends = 1.2e-7;
    for i in 1..=6 {
        let xi = ends * f64::from(i) / 6.0;
        put([deepest + TOUCH, xi, pull(xi), force(deepest)]);
    }
    for i in 1..=6 {
        let xi = ends * (1.0 - f64::from(i) / 3.0);
        put([deepest + TOUCH, xi, pull(ends) - 2.0 * pull(0.5 * (ends - xi)), force(deepest)]);
    }
    rows
}

fn data(names: [&str; 4], rows: [Vec<f64>; 4]) -> Data {
    Data::new(names.into_iter().map(str::to_owned).zip(rows).collect()).unwrap()
}

#[test]
fn a_loop_of_shifts_tells_modulus_friction_and_touch() {
    let mut rows = loop_of_shifts();
    rows[1].iter_mut().for_each(|xi| *xi *= 1e6);
    let data = data(["zeta", "xi (um)", "F_x", "F_z"], rows);
    let errors = [(Some("F_x".to_owned()), vec![0.01]), (Some("F_z".to_owned()), vec![0.05])];
    let options = Options { errors: &errors, curve: 9, ..Options::default() };
    let found = fit(&CaseFile::from_text(CASE), &data, &options).unwrap();
    close(of(&found, "young_modulus").value, MODULUS, 1e-6 * MODULUS);
    close(of(&found, "friction").value, FRICTION, 1e-6);
    close(of(&found, "touch").value, TOUCH, 1e-12);
    assert!(found.points.iter().all(|point| point.residual().abs() < 1e-3));
    // A line along one input would be another history.
    assert!(found.curve.is_none());
}

/// The approach of 0.8 um is read as 1 um from the touch at 0.2 um, though only shifts are measured.
#[test]
fn a_given_approach_counts_from_the_touch() {
    let case = CASE
        .replace(
            "zeta = 0, xi = 0, touch = { fit = [-1e-6, 1e-6] }",
            "zeta = 1e-6, xi = 0, touch = 2e-7",
        )
        .replace("{ fit = [0.01, 1] }", "0.2");
    let force = 4.0 / 3.0 * MODULUS / 0.91 * 0.1 * 8e-7_f64.powf(1.5);
    let columns = [("xi", vec![0.0, 1e-8, 2e-8]), ("F_z", vec![force; 3])];
    let data = Data::new(columns.map(|(name, own)| (name.to_owned(), own)).to_vec()).unwrap();
    let found = fit(&CaseFile::from_text(case), &data, &Options::default()).unwrap();
    close(of(&found, "young_modulus").value, MODULUS, 1e-6 * MODULUS);
}

#[test]
fn wrong_histories_are_told() {
    let told = |case: &str, names: [&str; 4]| {
        let mut rows = loop_of_shifts();
        if names[1] == "contact.friction" {
            rows[1].fill(0.1);
        }
        let error = fit(&CaseFile::from_text(case), &data(names, rows), &Options::default());
        let error: FitError = error.unwrap_err();
        assert!(error.is_bad_input());
        error.to_string()
    };
    let names = ["zeta", "xi", "F_x", "F_z"];
    let steps =
        CASE.replace("zeta = 0, xi = 0, touch = { fit = [-1e-6, 1e-6] }", "steps = [[1e-6, 0, 0]]");
    assert!(told(&steps, names).contains("column `zeta` of the data: `history.zeta` is missing"));
    let friction = ["zeta", "contact.friction", "F_x", "F_z"];
    let known = CASE.replace("friction = { fit = [0.01, 1] }", "friction = 0.1");
    assert!(told(&known, friction).contains("all rows are steps of one history"));
    let none = ["humidity", "colour", "F_x", "F_z"];
    let found = told(CASE, none);
    assert!(found.contains("a history needs a column of its steps"), "{found}");
    let both = CASE.replace("xi = 0,", "xi = 0, steps = [[1e-6, 0, 0]],");
    assert!(told(&both, names).contains("give one of them"));
    let error = history::followed(&CaseFile::from_text(CASE)).unwrap_err().to_string();
    assert!(error.contains("body_1.material.young_modulus"), "{error}");
}
