//! Cases and data of several tests.

use carom_cases::input::CaseFile;
use carom_fit::{Data, Determined, Fit, FitError, Options};

/// A ball of alumina on thick glass, with these lines in `[contact]`.
pub(crate) fn alumina(contact: &str) -> CaseFile {
    ball("2.5e-3", contact)
}

/// The same with another radius.
pub(crate) fn ball(radius: &str, contact: &str) -> CaseFile {
    CaseFile::from_text(format!(
        "[body_1]
         shape = \"sphere\"
         radius = {radius}
         material = {{ young_modulus = 380e9, poisson = 0.23 }}
         density = 4000
         [body_2]
         shape = \"plane\"
         material = {{ young_modulus = 70e9, poisson = 0.25 }}
         fixed = true
         [approach]
         speed = 3.9
         angle = 45
         [contact]
         {contact}"
    ))
}

/// Friction and the ratio of stiffness are unknown.
pub(crate) const BOTH: &str =
    "friction = { fit = [0.01, 1] }\nnormal_over_tangential_stiffness = { fit = [0.8, 1.5] }";

/// The fit with one standard error of all values, if one is given.
pub(crate) fn fitted(case: &CaseFile, data: &Data, error: Option<f64>) -> Result<Fit, FitError> {
    let errors: Vec<_> = error.map(|error| (None, vec![error])).into_iter().collect();
    carom_fit::fit(case, data, &Options { errors: &errors, ..Options::default() })
}

/// The unknown of this name.
pub(crate) fn of<'a>(fit: &'a Fit, name: &str) -> &'a Determined {
    fit.parameters.iter().find(|one| one.parameter.ends_with(name)).unwrap()
}

pub(crate) fn close(value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance,
        "{value}, expected {expected} within {tolerance}"
    );
}
