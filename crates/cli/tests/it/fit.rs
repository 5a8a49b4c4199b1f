//! `carom fit`: what it prints, draws and refuses.

use crate::common::{carom, close, example, fresh, json, refusal, stdout, stdout_at};

fn alumina<'a>(more: &[&'a str], files: &'a [String; 2]) -> Vec<&'a str> {
    [&["fit", &files[0], &files[1], "--sd", "0.014"], more].concat()
}

fn files() -> [String; 2] {
    [example("fit/alumina.toml"), example("fit/alumina.csv")]
}

#[test]
fn json_has_all_tables_and_csv_the_unknowns() {
    let files = files();
    let fit = json(&alumina(&[], &files));
    close(&fit["parameters"][0]["value"], 0.0927, 5e-5);
    close(&fit["quality"]["chi2_per_degree"], 0.70, 5e-3);
    close(&fit["correlations"][0]["correlation"], 0.26, 5e-3);
    assert_eq!(fit["points"].as_array().unwrap().len(), 10);
    assert_eq!(fit["statements"].as_array().unwrap().len(), 0);
    assert!(fit.get("predictions").is_none());
    let csv = stdout(&alumina(&["--format", "csv"], &files));
    assert!(
        csv.starts_with(
            "parameter,value,unit,sd,low,high,profile_low,profile_high,determined_by\n"
        )
    );
    assert_eq!(csv.lines().count(), 3);
    let points = stdout(&alumina(&["--points", "--format", "csv"], &files));
    assert!(
        points.starts_with("row,quantity,unit,measured,error,fitted,residual,leverage,weight\n")
    );
}

/// Forces over time of one impact, drawn with f = .14.
#[test]
fn forces_over_time_tell_friction_and_touch() {
    let files = [example("fit/hit.toml"), example("fit/hit.csv")];
    let fit = json(&["fit", &files[0], &files[1]]);
    close(&fit["parameters"][1]["value"], 0.14, 2e-3);
    close(&fit["parameters"][2]["value"], 21.3e-6, 3e-7);
}

#[test]
fn a_table_fits_the_page_and_tells_what_is_open() {
    let files = files();
    let flat = fresh("flat.csv");
    let text = std::fs::read_to_string(&files[1]).unwrap();
    let rows = text.lines().filter(|line| {
        let angle = line.split(',').next().and_then(|text| text.parse::<f64>().ok());
        angle.is_none_or(|angle| angle > 29.0)
    });
    std::fs::write(&flat, rows.collect::<Vec<_>>().join("\n")).unwrap();
    let told = stdout_at(100, &["fit", &files[0], flat.to_str().unwrap(), "--sd", "0.014"]);
    assert!(
        told.contains("These data do not determine normal_over_tangential_stiffness"),
        "{told}"
    );
    assert!(told.lines().all(|line| line.chars().count() <= 100), "{told}");
    // Beside other formats the sentences are warnings.
    let output =
        carom(&["fit", &files[0], flat.to_str().unwrap(), "--sd", "0.014", "--format", "csv"]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(stderr.contains("warning: These data do not determine"), "{stderr}");
}

#[test]
fn a_picture_is_drawn_with_band_and_residuals() {
    let (files, plot) = (files(), fresh("fit.svg"));
    stdout(&alumina(&["--plot", plot.to_str().unwrap()], &files));
    let picture = std::fs::read_to_string(&plot).unwrap();
    for words in ["body 1 tangential ratio", "95 %", "measured", "residual / standard error"] {
        assert!(picture.contains(words), "{words}");
    }
}

#[test]
fn wrong_inputs_are_told_with_their_file() {
    let [case, data] = files();
    let glass = example("fit/glass.csv");
    let refused = |arguments: &[&str], told: &str| {
        let stderr = refusal(arguments);
        assert!(stderr.contains(told), "{arguments:?}: {stderr}");
    };
    refused(&["fit", &case, &glass], "glass.csv: column `body_1.velocity.x` of the data");
    refused(&["fit", &case, &data, "--predict", &glass], "glass.csv: column `body_1.velocity.x`");
    refused(&["fit", &case, &data, "--sd", "0"], "\"0\" must be a number > 0");
    refused(
        &["fit", &case, &data, "--sd", "e=1"],
        "column `e` of the data: the data have no such column",
    );
    refused(
        &["fit", &example("steel_balls.toml"), &data],
        "column `angle` of the data: `approach.angle` is missing",
    );
    refused(&["impact", &case], "`contact.friction` is unknown; only `carom fit` computes");
    refused(
        &["hertz", &example("fit/hertz_indentation.toml")],
        "`body_2.material.young_modulus` is unknown",
    );
    let to_data = ["fit", &case, &data, "--plot", &data];
    refused(&to_data, "must end in .svg");
}
