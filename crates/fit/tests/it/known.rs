//! Fits with known results: exact data, closed forms, scattered and wrong values.

use crate::common::{BOTH, alumina, close, fitted, of};
use carom_fit::{Data, Knowledge, Loss, Options, fit};
use carom_impact::restitution::of_spheres;

/// Ratios at these angles for friction .1 and kappa 1.2.
fn exact(angles: &[f64]) -> Vec<f64> {
    let ratio = |angle: &f64| {
        let lambda = angle.to_radians().tan() / 0.1;
        1.0 - 2.0 / 7.0 * (1.0 + of_spheres(1.2, lambda).unwrap())
    };
    angles.iter().map(ratio).collect()
}

fn data(angles: &[f64], ratios: Vec<f64>) -> Data {
    let columns =
        [("angle".to_owned(), angles.to_vec()), ("body_1_tangential_ratio".to_owned(), ratios)];
    Data::new(columns.to_vec()).unwrap()
}

const ANGLES: [f64; 8] = [3.0, 7.0, 12.0, 16.0, 22.0, 28.0, 40.0, 60.0];

#[test]
fn exact_data_give_back_their_numbers() {
    let fit = fitted(&alumina(BOTH), &data(&ANGLES, exact(&ANGLES)), Some(0.01)).unwrap();
    close(of(&fit, "friction").value, 0.1, 1e-7);
    close(of(&fit, "stiffness").value, 1.2, 1e-6);
    assert!(fit.points.iter().all(|point| point.residual().abs() < 1e-5));
    let leverage: f64 = fit.points.iter().map(|point| point.leverage).sum();
    close(leverage, 2.0, 1e-9);
    assert!(fit.warnings[0].contains("smaller than given"), "{:?}", fit.warnings);
}

#[test]
fn friction_of_sliding_impacts_is_a_weighted_mean() {
    // r = 1 - 2 f/tan(angle): linear in f, so that everything is known in closed form.
    let angles = [50.0, 60.0, 70.0, 80.0_f64];
    let by: Vec<f64> = angles.iter().map(|angle| -2.0 / angle.to_radians().tan()).collect();
    let noise = [0.003, -0.002, 0.001, 0.004];
    let ratios: Vec<f64> =
        by.iter().zip(noise).map(|(slope, noise)| 1.0 + 0.1 * slope + noise).collect();
    let squares: f64 = by.iter().map(|slope| slope * slope).sum();
    let best: f64 =
        by.iter().zip(&ratios).map(|(slope, ratio)| slope * (ratio - 1.0)).sum::<f64>() / squares;
    let rest: f64 =
        by.iter().zip(&ratios).map(|(slope, ratio)| (ratio - 1.0 - best * slope).powi(2)).sum();
    let case = alumina("friction = { fit = [0.01, 1] }\nlaw = \"coulomb\"");
    let estimated = fitted(&case, &data(&angles, ratios.clone()), None).unwrap();
    let one = of(&estimated, "friction");
    close(one.value, best, 1e-9);
    let sd = (rest / 3.0 / squares).sqrt();
    close(one.deviation.unwrap(), sd, 1e-6 * sd);
    // Student's t of three degrees of freedom.
    close(one.interval.unwrap()[1] - best, 3.182_446_305 * sd, 1e-6 * sd);
    // The sum is a parabola: the profile is the same interval.
    close(one.profile.unwrap()[0], one.interval.unwrap()[0], 3e-3 * sd);
    let given = fitted(&case, &data(&angles, ratios), Some(0.003)).unwrap();
    let one = of(&given, "friction");
    let sd = 0.003 / squares.sqrt();
    close(one.interval.unwrap()[1] - best, 1.959_963_985 * sd, 1e-6 * sd);
    close(given.quality.chi_squared, rest / 9e-6, 1e-6 * rest / 9e-6);
}

#[test]
fn a_prior_counts_as_one_more_measurement() {
    let angles = [50.0, 60.0, 70.0, 80.0_f64];
    let squares: f64 = angles.iter().map(|angle| (2.0 / angle.to_radians().tan()).powi(2)).sum();
    let case = alumina("friction = { prior = { mean = 0.12, sd = 0.004 } }\nlaw = \"coulomb\"");
    let fit = fitted(&case, &data(&angles, exact(&angles)), Some(0.01)).unwrap();
    let (of_data, of_prior) = (squares / 1e-4, 1.0 / 0.004_f64.powi(2));
    let one = of(&fit, "friction");
    close(one.value, (of_data * 0.1 + of_prior * 0.12) / (of_data + of_prior), 1e-8);
    close(one.deviation.unwrap(), (of_data + of_prior).sqrt().recip(), 1e-8);
    assert_eq!(fit.quality.freedom, 4);
}

#[test]
fn a_prior_determines_what_data_do_not() {
    let angles = [50.0, 60.0, 70.0];
    let case = alumina(
        "friction = { fit = [0.01, 1] }\nnormal_over_tangential_stiffness = { prior = { mean = 1.1, sd = 0.05 } }",
    );
    let fit = fitted(&case, &data(&angles, exact(&angles)), Some(0.01)).unwrap();
    let kappa = of(&fit, "stiffness");
    assert_eq!(kappa.knowledge, Knowledge::Prior);
    close(kappa.value, 1.1, 1e-9);
    close(kappa.deviation.unwrap(), 0.05, 1e-9);
    assert!(fit.statements.join(" ").contains("its interval is that of its prior"));
}

/// What a prior tells more of than the data do is its own; what the data narrow is theirs.
#[test]
fn an_interval_belongs_to_what_tells_more() {
    let angles = [50.0, 60.0, 70.0];
    let case = |sd: f64| {
        let friction = format!("friction = {{ prior = {{ mean = 0.1, sd = {sd} }} }}");
        alumina(&(friction + "\nlaw = \"coulomb\""))
    };
    let found = |sd| fitted(&case(sd), &data(&angles, exact(&angles)), Some(0.01)).unwrap();
    let (narrow, wide) = (found(1e-3), found(0.1));
    assert_eq!(of(&narrow, "friction").knowledge, Knowledge::Prior);
    assert!(narrow.statements.join(" ").contains("The prior of friction tells more"));
    assert_eq!(of(&wide, "friction").knowledge, Knowledge::Data);
    assert!(wide.statements.is_empty(), "{:?}", wide.statements);
}

/// The best value is found far below an upper bound, at which all impacts grip alike.
#[test]
fn a_wide_bound_does_not_hide_the_best_value() {
    for high in [1.0, 5.0, 10.0, 100.0, 1e4] {
        let case = alumina(&format!("friction = {{ fit = [0, {high}] }}\nlaw = \"coulomb\""));
        let angles = [30.0, 45.0, 60.0, 75.0];
        let fit = fitted(&case, &data(&angles, exact(&angles)), Some(0.01)).unwrap();
        let one = of(&fit, "friction");
        assert_eq!(one.knowledge, Knowledge::Data, "{high}");
        assert!((one.value - 0.1).abs() < 0.01, "{high}: {}", one.value);
    }
}

#[test]
fn a_wrong_value_counts_little_with_a_robust_loss() {
    let mut ratios = exact(&ANGLES);
    let noise = [1.0, -1.0, 0.5, -0.7, 0.3, 1.0, -0.2, -0.8].map(|part| 0.004 * part);
    ratios.iter_mut().zip(noise).for_each(|(ratio, noise)| *ratio += noise);
    ratios[4] += 0.2;
    let data = data(&ANGLES, ratios);
    let errors = [(None, vec![0.004])];
    let run = |loss| {
        let options = Options { errors: &errors, loss, ..Options::default() };
        fit(&alumina(BOTH), &data, &options).unwrap()
    };
    let fits = [Loss::Squares, Loss::Huber].map(run);
    // 0.2 is 50 standard errors.
    let told = fits[1].warnings.concat();
    assert!(told.contains("1 of 8 measured values are more than 4 standard errors"), "{told}");
    let [squares, huber] = fits.each_ref().map(|fit| of(fit, "friction").value);
    assert!((huber - 0.1).abs() < 0.25 * (squares - 0.1).abs(), "{huber} {squares}");
    // The slope of 2 c^2 (sqrt(1 + r^2/c^2) - 1) over that of r^2.
    let weight = |residual: f64| 1.0 / (1.0 + (residual / 1.345).powi(2)).sqrt();
    for (one, other) in fits[0].points.iter().zip(&fits[1].points) {
        close(one.weight, 1.0, 0.0);
        close(other.weight, weight((other.measured - other.fitted) / 0.004), 1e-12);
    }
}

/// Ratios at one angle that lie symmetrically about their mean: half of the residuals are smaller than 2 parts, and half
/// of normal deviates are smaller than .6745 standard deviations.
#[test]
fn a_robust_fit_estimates_the_error_from_the_middle_of_the_residuals() {
    let part = 1e-3;
    let ratios = [-3.0, 3.0, -1.0, 1.0].map(|off| exact(&[60.0])[0] + part * off);
    let case = alumina("friction = { fit = [0.01, 1] }\nlaw = \"coulomb\"");
    let options = Options { loss: Loss::Huber, ..Options::default() };
    let fit = fit(&case, &data(&[60.0; 4], ratios.to_vec()), &options).unwrap();
    close(of(&fit, "friction").value, 0.1, 1e-6);
    fit.points.iter().for_each(|point| close(point.error, 2.0 * part / 0.674_490, 1e-6));
}

#[test]
fn a_best_value_at_a_bound_is_told() {
    let case = alumina(
        "friction = { fit = [0.11, 1] }\nlaw = \"coulomb\"\nnormal_over_tangential_stiffness = 1.2",
    );
    let fit = fitted(&case, &data(&ANGLES, exact(&ANGLES)), Some(0.02)).unwrap();
    let one = of(&fit, "friction");
    assert_eq!((one.knowledge, one.value), (Knowledge::AtBound, 0.11));
    assert_eq!(one.interval, None);
    assert_eq!(one.profile.unwrap()[0], 0.11);
    assert!(fit.statements[0].contains("is its bound, 0.11"), "{:?}", fit.statements);
}

#[test]
fn an_interval_that_reaches_a_bound_tells_which() {
    let angles = [50.0, 60.0, 70.0, 80.0];
    for (bounds, side) in [("[0.095, 1]", "lower"), ("[0.01, 0.105]", "upper")] {
        let case = alumina(&format!("friction = {{ fit = {bounds} }}\nlaw = \"coulomb\""));
        let fit = fitted(&case, &data(&angles, exact(&angles)), Some(0.01)).unwrap();
        let told = fit.statements.concat();
        assert!(told.contains(&format!("friction reaches its {side} bound")), "{told}");
    }
}

#[test]
fn without_degrees_of_freedom_there_are_no_intervals() {
    let angles = [5.0, 40.0];
    for error in [None, Some(0.01)] {
        let fit = fitted(&alumina(BOTH), &data(&angles, exact(&angles)), error).unwrap();
        assert_eq!((fit.quality.freedom, fit.quality.chi_squared_per_degree()), (0, None));
        assert!(fit.parameters.iter().all(|one| one.interval.is_none() && one.profile.is_none()));
        assert!(fit.statements.join(" ").contains("no degrees of freedom"));
    }
}

#[test]
fn predictions_have_bands_that_follow_the_unknown() {
    let angles = [50.0, 60.0, 70.0, 80.0];
    let ahead = Data::new(vec![("angle".to_owned(), vec![45.0, 65.0])]).unwrap();
    let errors = [(None, vec![0.01])];
    let options = Options { errors: &errors, predict: Some(&ahead), ..Options::default() };
    let case = alumina("friction = { fit = [0.01, 1] }\nlaw = \"coulomb\"");
    let fit = fit(&case, &data(&angles, exact(&angles)), &options).unwrap();
    for (one, angle) in fit.predictions.iter().zip([45.0_f64, 65.0]) {
        let slope = 2.0 / angle.to_radians().tan();
        close(one.value, 1.0 - 0.1 * slope, 1e-8);
        let half = slope * 1.959_963_985 * of(&fit, "friction").deviation.unwrap();
        close(one.interval.unwrap()[1] - one.value, half, 1e-6 * half);
    }
}

/// Sliding impacts say nothing of the stiffness ratio: a degree of freedom is left for it, and what it moves has no band.
#[test]
fn predictions_that_need_what_is_not_determined_have_no_band() {
    let angles = [60.0, 67.0, 73.0, 80.0];
    let ahead = Data::new(vec![("angle".to_owned(), vec![20.0, 65.0])]).unwrap();
    let errors = [(None, vec![0.01])];
    let options = Options { errors: &errors, predict: Some(&ahead), ..Options::default() };
    let fit = fit(&alumina(BOTH), &data(&angles, exact(&angles)), &options).unwrap();
    let has_band: Vec<bool> = fit.predictions.iter().map(|one| one.interval.is_some()).collect();
    assert_eq!((has_band, fit.quality.freedom), (vec![false, true], 3));
}

#[test]
fn data_that_contradict_a_prior_are_weighed_against_it() {
    // Twenty standard deviations of the prior away.
    let angles = [50.0, 60.0, 70.0, 80.0_f64];
    let squares: f64 = angles.iter().map(|angle| (2.0 / angle.to_radians().tan()).powi(2)).sum();
    let case = alumina("friction = { prior = { mean = 0.12, sd = 0.001 } }\nlaw = \"coulomb\"");
    let fit = fitted(&case, &data(&angles, exact(&angles)), Some(5e-4)).unwrap();
    let (of_data, of_prior) = (squares / 2.5e-7, 1e6);
    let one = of(&fit, "friction");
    close(one.value, (of_data * 0.1 + of_prior * 0.12) / (of_data + of_prior), 1e-8);
    assert_eq!(one.knowledge, Knowledge::Data);
    close(one.deviation.unwrap(), (of_data + of_prior).sqrt().recip(), 1e-8);
}

#[test]
fn values_without_scatter_have_no_interval() {
    let columns = [("angle".to_owned(), vec![60.0; 3]), ("R_x".to_owned(), vec![0.2; 3])];
    let same = Data::new(columns.to_vec()).unwrap();
    let case = alumina("friction = { fit = [0.01, 1] }\nlaw = \"coulomb\"");
    let fit = fitted(&case, &same, None).unwrap();
    let one = of(&fit, "friction");
    assert_eq!((one.deviation, one.interval, one.profile), (None, None, None));
    assert!(
        fit.statements.join(" ").contains("The values of R_x do not scatter about the fit"),
        "{fit:?}"
    );
    let given = fitted(&case, &same, Some(0.01)).unwrap();
    assert!(of(&given, "friction").interval.is_some() && given.statements.is_empty(), "{given:?}");
}

#[test]
fn friction_is_found_between_bounds_of_any_width() {
    let data = data(&ANGLES, exact(&ANGLES));
    for bounds in ["[0, 0.2]", "[0, 100]", "[0.01, 1e30]", "[1e-4, 1e6]"] {
        let case = alumina(&BOTH.replace("[0.01, 1]", bounds));
        let fit = fitted(&case, &data, Some(0.01)).unwrap();
        close(of(&fit, "friction").value, 0.1, 1e-6);
        assert_eq!(of(&fit, "friction").knowledge, Knowledge::Data, "{bounds}");
    }
}

#[test]
fn each_row_may_have_its_own_error() {
    let all = data(&ANGLES, exact(&ANGLES));
    let case = alumina(BOTH);
    let with = |errors: Vec<f64>| {
        let errors = [(None, errors)];
        fit(&case, &all, &Options { errors: &errors, ..Options::default() })
    };
    let (one, each) = (with(vec![0.01]).unwrap(), with(vec![0.01; ANGLES.len()]).unwrap());
    assert_eq!(of(&one, "friction").deviation, of(&each, "friction").deviation);
    let mut errors = vec![0.01; ANGLES.len()];
    errors[2] = 0.02;
    assert!(of(&with(errors).unwrap(), "friction").deviation > of(&one, "friction").deviation);
    let told = with(vec![0.01; 3]).unwrap_err().to_string();
    assert!(told.contains("3 standard errors are given for 8 rows"), "{told}");
}

/// Of data whose error is unknown, and a prior far from them: the value has the greatest posterior, of Student's form. Small
/// scatter leaves the value of the data, large scatter that of the prior.
#[test]
fn unknown_errors_are_weighed_against_a_prior() {
    let angles: Vec<f64> = (0..10).map(|i| 80.0 + 0.8 * f64::from(i)).collect();
    let by: Vec<f64> = angles.iter().map(|angle| -2.0 / angle.to_radians().tan()).collect();
    let noise = [1.0, -0.7, 0.4, -1.2, 0.9, -0.3, 0.8, -1.1, 0.6, -0.4];
    let case = alumina("friction = { prior = { mean = 0.5, sd = 0.06 } }\nlaw = \"coulomb\"");
    let mut near = Vec::new();
    for scatter in [0.005, 0.01, 0.03] {
        let ratio = |(slope, noise): (&f64, f64)| 1.0 + 0.093 * slope + scatter * noise;
        let ratios: Vec<f64> = by.iter().zip(noise).map(ratio).collect();
        let posterior = |friction: f64, freedom: f64| {
            let rest = by.iter().zip(&ratios).map(|(by, ratio)| ratio - 1.0 - friction * by);
            0.5 * freedom * rest.map(|rest| rest * rest).sum::<f64>().ln()
                + 0.5 * ((friction - 0.5) / 0.06).powi(2)
        };
        let tried = (1..8000).map(|i| 1e-4 * f64::from(i));
        let best = |freedom: f64| {
            let order =
                |a: &f64, b: &f64| posterior(*a, freedom).total_cmp(&posterior(*b, freedom));
            tried.clone().min_by(order).unwrap()
        };
        let fit = fitted(&case, &data(&angles, ratios.clone()), None).unwrap();
        let found = of(&fit, "friction").value;
        // As the data determine friction or the prior does, nine or ten values are left for the error.
        let [low, high] = [10.0, 9.0].map(best);
        assert!(0.99 * low < found && found < 1.01 * high, "{found}: {low} to {high}");
        near.push((found < 0.3, fit.warnings.iter().any(|told| told.contains("contradict"))));
    }
    assert_eq!(near, [(true, true), (false, false), (false, false)]);
}

/// What is determined together with another unknown only is not determined by the data.
#[test]
fn the_table_and_the_sentences_tell_the_same() {
    let columns = [("angle".to_owned(), vec![60.0; 6]), ("R_x".to_owned(), vec![0.2; 6])];
    let fit = fitted(&alumina(BOTH), &Data::new(columns.to_vec()).unwrap(), None).unwrap();
    assert!(
        fit.statements[0].contains("friction and normal_over_tangential_stiffness only together")
    );
    let known = [of(&fit, "friction").knowledge, of(&fit, "stiffness").knowledge];
    assert_eq!(known, [Knowledge::Nothing; 2]);
}

/// A standard error has the unit behind its name, and without one that of its column.
#[test]
fn standard_errors_follow_the_unit_of_their_column() {
    let slips = [1.1, 1.32, 1.57, 1.88];
    let table = |unit: &str, scale: f64, errors: Option<(&str, f64)>| {
        let slips = slips.iter().map(|slip| slip * scale).collect();
        let angles = ("angle".to_owned(), vec![30.0, 34.0, 39.0, 45.0]);
        let mut columns = vec![angles, (format!("slip_after{unit}"), slips)];
        columns.extend(errors.map(|(name, error)| (name.to_owned(), vec![error; 4])));
        Data::new(columns).unwrap()
    };
    let case = alumina("friction = { fit = [0.01, 1] }\nlaw = \"coulomb\"");
    let found = |data: &Data, given: Option<(Option<&str>, f64)>| {
        let given = given.map(|(name, error)| (name.map(str::to_owned), vec![error]));
        let errors: Vec<_> = given.into_iter().collect();
        let fit = fit(&case, data, &Options { errors: &errors, ..Options::default() }).unwrap();
        of(&fit, "friction").deviation.unwrap()
    };
    let expected = found(&table("", 1.0, None), Some((None, 0.03)));
    let milli = table(" (mm/s)", 1e3, None);
    for given in [
        (None, 30.0),
        (Some("slip_after"), 30.0),
        (Some("slip_after (mm/s)"), 30.0),
        (Some("slip_after / m/s"), 0.03),
    ] {
        close(found(&milli, Some(given)), expected, 1e-12);
    }
    for column in [("slip_after_sd", 30.0), ("slip_after_sd (m/s)", 0.03)] {
        close(found(&table(" (mm/s)", 1e3, Some(column)), None), expected, 1e-12);
    }
}
