//! Forces over approach: the modulus and the point of contact.

use crate::common::{close, of};
use carom_cases::input::CaseFile;
use carom_fit::{Data, FitError, Options, fit};

const CASE: &str =
    "body_1 = { radii = 0.005, material = { young_modulus = { fit = [1e5, 1e8] }, poisson = 0.5 } }
body_2 = { radii = inf, material = { rigid = true } }
load = { approach = 1e-4, touch = { fit = [-1e-3, 1e-3] } }";

/// Forces by F = (4/3) E/(1 - nu^2) sqrt(R) delta^(3/2), and readings from before the first touch at .2 mm.
fn pressed(modulus: f64) -> Data {
    let readings: Vec<f64> = (0..12).map(|i| 1e-4 * f64::from(i)).collect();
    let force = |reading: &f64| {
        let approach: f64 = (reading - 2e-4).max(0.0);
        4.0 / 3.0 * modulus / 0.75 * 0.005_f64.sqrt() * approach.powf(1.5)
    };
    let forces = readings.iter().map(force).collect();
    Data::new(vec![("approach".to_owned(), readings), ("force".to_owned(), forces)]).unwrap()
}

#[test]
fn the_modulus_and_the_point_of_contact_come_back() {
    let case = CaseFile::from_text(CASE);
    let errors = [(None, vec![1e-3])];
    let options = Options { errors: &errors, curve: 5, ..Options::default() };
    let found = fit(&case, &pressed(2e6), &options).unwrap();
    close(of(&found, "young_modulus").value, 2e6, 1.0);
    close(of(&found, "touch").value, 2e-4, 1e-9);
    // The readings before the touch have no force.
    assert_eq!(found.points[0].fitted, 0.0);
    let curve = found.curve.unwrap();
    assert_eq!((curve.lines[0].2[0].value, curve.along.len()), (0.0, 5));
}

#[test]
fn readings_far_from_the_touch_hold_little_on_modulus_and_touch_alone() {
    let all = pressed(2e6);
    let [readings, forces] = [0, 1].map(|i| all.columns()[i].values[9..].to_vec());
    // Normal equations of the derivatives F by ln E and -3/2 F/delta by the touch.
    let mut sums = [0.0; 3];
    for (reading, force) in readings.iter().zip(&forces) {
        let by_touch = -1.5 * force / (reading - 2e-4);
        sums = [sums[0] + force * force, sums[1] + force * by_touch, sums[2] + by_touch * by_touch];
    }
    let columns = vec![("approach".to_owned(), readings), ("force".to_owned(), forces)];
    let errors = [(None, vec![1e-3])];
    let options = Options { errors: &errors, ..Options::default() };
    let found = fit(&CaseFile::from_text(CASE), &Data::new(columns).unwrap(), &options).unwrap();
    let expected = -sums[1] / (sums[0] * sums[2]).sqrt();
    close(found.correlations[0].value, expected, 1e-4);
    let told = found.warnings.join(" ");
    assert!(told.contains("correlation 0.99") && told.contains("little on each alone"), "{told}");
}

#[test]
fn units_of_columns_are_converted() {
    let data = pressed(2e6);
    let milli = data.columns()[0].values.iter().map(|reading| 1e3 * reading).collect();
    let forces = data.columns()[1].values.clone();
    let data =
        Data::new(vec![("approach (mm)".to_owned(), milli), ("force / N".to_owned(), forces)]);
    let found = fit(&CaseFile::from_text(CASE), &data.unwrap(), &Options::default()).unwrap();
    close(of(&found, "young_modulus").value, 2e6, 10.0);
}

#[test]
fn a_contact_needs_its_load_and_finite_errors() {
    let data = Data::new(vec![("force".to_owned(), vec![1.0, 2.0, 3.0])]).unwrap();
    let error = fit(&CaseFile::from_text(CASE), &data, &Options::default()).unwrap_err();
    assert!(
        matches!(&error, FitError::Table(reason) if reason.contains("`load.approach`")),
        "{error}"
    );
    let errors = [(None, vec![f64::INFINITY])];
    let endless = Options { errors: &errors, ..Options::default() };
    let error = fit(&CaseFile::from_text(CASE), &pressed(2e6), &endless).unwrap_err().to_string();
    assert!(error.contains("inf must be a standard error, finite and > 0"), "{error}");
    // A touch is a reading of the approach: a force does not count from it.
    let forced = CaseFile::from_text(CASE.replace("approach = 1e-4", "force = 1"));
    let error = fit(&forced, &pressed(2e6), &Options::default()).unwrap_err().to_string();
    assert!(error.contains("`load.touch`") && error.contains("reading of the approach"), "{error}");
}
