//! Published measurements: values of an independent fit of the same points (reduced dimensionality, least squares of scipy).

use crate::common::{BOTH, alumina, close, fitted, of};
use carom_cases::input::CaseFile;
use carom_fit::{Data, Knowledge};

/// Kharaz, Gorham and Salman 2001: angle and tangential velocity of the centre after over that before.
const ALUMINA: &str = include_str!("../../../../examples/fit/alumina.csv");

fn rows_above(least: f64) -> String {
    let is_kept = |line: &&str| {
        let angle = line.split(',').next().and_then(|text| text.parse::<f64>().ok());
        angle.is_none_or(|angle| angle > least)
    };
    ALUMINA.lines().filter(is_kept).collect::<Vec<_>>().join("\n")
}

#[test]
fn alumina_on_glass_has_the_values_of_an_independent_fit() {
    let data = Data::from_csv(ALUMINA).unwrap();
    let fit = fitted(&alumina(BOTH), &data, Some(0.014)).unwrap();
    let (friction, kappa) = (of(&fit, "friction"), of(&fit, "stiffness"));
    close(friction.value, 0.0927, 5e-5);
    close(kappa.value, 1.110, 5e-4);
    close(friction.deviation.unwrap(), 0.0029, 5e-5);
    close(kappa.deviation.unwrap(), 0.026, 5e-4);
    close(fit.quality.chi_squared_per_degree().unwrap(), 0.70, 5e-3);
    assert!(fit.statements.is_empty() && fit.warnings.is_empty(), "{fit:?}");
}

/// However wide a prior is, the best value is found; on the way impossible stiffness ratios may be tried.
#[test]
fn wide_priors_do_not_move_the_values() {
    let data = Data::from_csv(ALUMINA).unwrap();
    let kappa = "normal_over_tangential_stiffness = { fit = [0.8, 1.5] }";
    for sd in [1.0, 3.0, 30.0, 1e3, 1e5] {
        let case =
            alumina(&format!("friction = {{ prior = {{ mean = 0.1, sd = {sd} }} }}\n{kappa}"));
        let fit = fitted(&case, &data, Some(0.014)).unwrap();
        assert!(
            (of(&fit, "friction").value - 0.0927).abs() < 1e-4,
            "{sd}: {:?} {:?}",
            fit.parameters,
            fit.quality
        );
    }
    for sd in [0.2, 0.5, 1.0] {
        let case = alumina(&format!(
            "friction = {{ fit = [0.01, 1] }}\nnormal_over_tangential_stiffness = {{ prior = {{ mean = 1.1, sd = {sd} }} }}"
        ));
        let fit = fitted(&case, &data, Some(0.014)).unwrap();
        close(of(&fit, "stiffness").value, 1.110, 2e-3);
    }
    for sd in [1e-20, 1e6, 1e300] {
        let case = alumina(&format!("friction = {{ prior = {{ mean = 0.1, sd = {sd} }} }}"));
        let told = fitted(&case, &data, Some(0.014)).unwrap_err().to_string();
        assert!(told.contains("from 1e-12 to 1e6 times the size of the mean"), "{told}");
    }
}

#[test]
fn the_steep_half_of_the_data_says_nothing_of_stiffness() {
    let data = Data::from_csv(&rows_above(29.0)).unwrap();
    let fit = fitted(&alumina(BOTH), &data, Some(0.014)).unwrap();
    let kappa = of(&fit, "stiffness");
    assert_eq!(kappa.knowledge, Knowledge::Nothing);
    assert_eq!((kappa.deviation, kappa.interval, kappa.profile), (None, None, None));
    assert_eq!(of(&fit, "friction").knowledge, Knowledge::Data);
    let told = fit.statements.join(" ");
    assert!(told.contains("do not determine normal_over_tangential_stiffness"), "{told}");
    assert!(told.contains("slide throughout"), "{told}");
    assert!(fit.correlations.is_empty());
}

/// Two spheres of glass, with these lines in `[contact]`.
fn glass(contact: &str) -> CaseFile {
    let sphere = "shape = \"sphere\"
         radius = 1.59e-3
         material = { young_modulus = 71e9, poisson = 0.22 }
         density = 2500";
    CaseFile::from_text(format!(
        "[body_1]\n{sphere}\nvelocity = [1, 0, -1]\n[body_2]\n{sphere}\n[contact]\n{contact}"
    ))
}

/// Of the independent fit friction counts e, and the ratio of stiffness does not.
#[test]
fn glass_on_glass_has_the_values_of_an_independent_fit() {
    // Foerster, Louge, Chang and Allia 1994: single impacts of two spheres, with their own normal and tangential velocities.
    let data = Data::from_csv(include_str!("../../../../examples/fit/glass.csv")).unwrap();
    let elastic = fitted(&glass(BOTH), &data, Some(0.06)).unwrap();
    close(of(&elastic, "stiffness").value, 1.26, 5e-3);
    let lossy = format!("{BOTH}\nnormal_restitution = 0.97\nloss = \"yield\"");
    let lossy = fitted(&glass(&lossy), &data, Some(0.06)).unwrap();
    close(of(&lossy, "friction").value, 0.094, 5e-4);
}

/// Data that determine the ratio of stiffness if e is known do so if e has a narrow prior, and say what they need.
#[test]
fn an_unknown_without_a_prior_is_not_determined_by_it() {
    let data = Data::from_csv(include_str!("../../../../examples/fit/glass.csv")).unwrap();
    let found = |restitution: &str| {
        let contact = format!("{BOTH}\nnormal_restitution = {restitution}\nloss = \"yield\"");
        fitted(&glass(&contact), &data, Some(0.06)).unwrap()
    };
    let known = found("0.97");
    let with_prior = found("{ prior = { mean = 0.97, sd = 0.01 } }");
    let [one, two] = [&known, &with_prior].map(|fit| of(fit, "stiffness"));
    assert_eq!([one.knowledge, two.knowledge], [Knowledge::Data; 2]);
    close(two.value, one.value, 0.01);
    close(two.deviation.unwrap(), one.deviation.unwrap(), 0.01);
    assert_eq!(of(&with_prior, "restitution").knowledge, Knowledge::Prior);
    let told = with_prior.statements.join(" ");
    assert!(told.contains("stiffness only with the prior of normal_restitution."), "{told}");
    assert!(told.contains("stiffness reaches its upper bound"), "{told}");
}

#[test]
fn spins_of_alumina_have_the_values_of_an_independent_fit() {
    let text = include_str!("../../../../examples/fit/alumina_spin.csv");
    let data = Data::from_csv(text).unwrap();
    let elastic = fitted(&alumina(BOTH), &data, None).unwrap();
    close(of(&elastic, "stiffness").value, 1.195, 5e-4);
    let lossy = format!("{BOTH}\nnormal_restitution = 0.98\nloss = \"yield\"");
    let lossy = fitted(&alumina(&lossy), &data, None).unwrap();
    close(of(&lossy, "friction").value, 0.0948, 5e-5);
}

/// Whether coupling counts depends on friction: the law must be the one of the best values, however wide the bounds are.
#[test]
fn the_law_does_not_depend_on_the_width_of_bounds() {
    let data = Data::from_csv(ALUMINA).unwrap();
    let with = |bounds: &str| {
        let case = alumina(&format!("friction = {{ fit = {bounds} }}"));
        fitted(&case, &data, Some(0.014)).unwrap().quality.chi_squared_per_degree().unwrap()
    };
    let narrow = with("[0.05, 0.2]");
    close(narrow, 14.1, 0.1);
    close(with("[0, 10]"), narrow, 0.05);
}

/// Four standard deviations of its prior away: the values of the data are the likelier ones, far apart from those that a first
/// error as large as their spread leads to.
#[test]
fn a_prior_does_not_hide_the_values_of_data_without_an_error() {
    let data = Data::from_csv(ALUMINA).unwrap();
    let kappa = "normal_over_tangential_stiffness = { fit = [0.8, 1.5] }";
    let case = alumina(&format!("friction = {{ prior = {{ mean = 0.5, sd = 0.1 }} }}\n{kappa}"));
    let fit = fitted(&case, &data, None).unwrap();
    close(of(&fit, "friction").value, 0.0930, 3e-4);
    close(of(&fit, "stiffness").value, 1.110, 5e-3);
    assert!(fit.warnings[0].contains("friction is 4.07"), "{:?}", fit.warnings);
}
