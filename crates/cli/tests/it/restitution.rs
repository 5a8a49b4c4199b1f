//! `carom restitution` as a user meets it.

use crate::common::{carom, close, fresh, json, stdout};

#[test]
fn restitution_gives_an_array_of_objects() {
    let rows = json(&["restitution", "--kappa", "1.5,1", "--lambda", "3:8:2"]);
    let rows = rows.as_array().unwrap();
    assert_eq!(rows.len(), 4);
    close(&rows[0]["kappa"], 1.5, 0.0);
    close(&rows[0]["lambda"], 3.0, 0.0);
    close(&rows[0]["R_x"], 0.595052, 5e-7);
    assert_eq!(rows[0]["regimes"].as_array().unwrap()[0], "slide+");
    // Sliding throughout: R_x = -1 + 7/lambda.
    close(&rows[3]["R_x"], -0.125, 1e-15);
    assert_eq!(rows[3]["regimes"], serde_json::json!(["slide+"]));
}

#[test]
fn restitution_as_csv_has_full_precision() {
    let text = stdout(&["restitution", "--kappa", "1", "--lambda", "9", "--format", "csv"]);
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("kappa,lambda,R_x,regimes"));
    let row: Vec<&str> = lines.next().unwrap().split(',').collect();
    assert!((row[2].parse::<f64>().unwrap() + 2.0 / 9.0).abs() < 1e-15);
}

#[test]
fn frictionless_spheres_slide_unhindered() {
    let rows = json(&["restitution", "--kappa", "1.2", "--lambda", "inf"]);
    close(&rows[0]["R_x"], -1.0, 0.0);
    assert_eq!(rows[0]["lambda"], "inf");
}

#[test]
fn bad_options_name_the_option_and_what_is_allowed() {
    for (arguments, expected) in [
        (["--kappa", "a", "--lambda", "1"], "'--kappa <VALUES>': `a` is not a number"),
        (["--kappa", "1", "--lambda", "0:1"], "'--lambda <VALUES>': `0:1` has 1 colons"),
        (["--kappa", "nan", "--lambda", "1"], "--kappa = NaN is out of range: must be"),
        (["--kappa", "2", "--lambda", "1"], "--kappa = 2 is out of range: must be"),
        (["--kappa", "1", "--lambda", "-1"], "--lambda = -1 is out of range: must be"),
    ] {
        let plot = fresh("bad-option.svg");
        let arguments = [&["restitution", "--plot", plot.to_str().unwrap()][..], &arguments];
        let output = carom(&arguments.concat());
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{stderr}");
        assert!(stderr.contains(expected), "{stderr}");
        assert!(output.stdout.is_empty() && !plot.exists());
    }
}

#[test]
fn restitution_by_groups_of_any_bodies() {
    // Sliding throughout: R_x = -1 + 2 chi/psi; spheres are chi = 7/(2 kappa), psi = lambda/kappa.
    let rows = json(&["restitution", "--chi", "2,3", "--psi", "8"]);
    assert_eq!(rows[0]["R_x"], -0.5);
    assert_eq!((&rows[1]["chi"], &rows[1]["psi"]), (&3.0.into(), &8.0.into()));
    let spheres = json(&["restitution", "--kappa", "1.25", "--lambda", "2"]);
    let groups = json(&["restitution", "--chi", "2.8", "--psi", "1.6"]);
    assert_eq!(spheres[0]["regimes"], groups[0]["regimes"]);
    assert_eq!(spheres[0]["R_x"], groups[0]["R_x"]);
}

#[test]
fn two_ranges_are_drawn_as_a_map() {
    for (names, title) in [
        (["--kappa", "--lambda"], "Tangential restitution of spheres"),
        (["--chi", "--psi"], "Tangential restitution"),
    ] {
        let map = fresh(&format!("map{}.svg", names[0]));
        let path = map.to_str().unwrap();
        let text = stdout(&[
            "restitution",
            names[0],
            "1:1.5:41",
            names[1],
            "0.1:9:61",
            "--map",
            path,
            "--format",
            "csv",
        ]);
        assert_eq!(text.lines().count(), 1 + 41 * 61);
        let svg = std::fs::read_to_string(&map).unwrap();
        assert!(svg.contains("href=\"data:image/png;base64,") && svg.len() < 100_000);
        assert!(svg.contains(title) && svg.contains("R<tspan") && !svg.contains("NaN"));
        // The line of R_x = 0 is there, and bold.
        assert!(svg.contains("stroke-width=\"1.6\" stroke-linejoin=\"round\" d=\"M"));
    }
}

#[test]
fn maps_need_ranges_and_tangents_a_velocity() {
    for (arguments, expected) in [
        (&["--kappa", "1", "--lambda", "1:2:3"][..], "--map takes two or more finite, increasing"),
        (
            &["--kappa", "1:1.5:3", "--lambda", "1,inf"],
            "--map takes two or more finite, increasing",
        ),
        (
            &["--kappa", "1.5:1:3", "--lambda", "1:2:3"],
            "--map takes two or more finite, increasing",
        ),
        (&["--chi", "1:2:3", "--psi", "1:2:3", "--plot", "b.svg"], "cannot be used with"),
        (&["--chi", "1:2:3", "--psi", "1:2:3", "--tensor", "tangent"], "--velocity-ratio <VALUE>"),
        (
            &["--chi", "1:2:3", "--psi", "1:2:3", "--tensor", "tangent", "--velocity-ratio", "nan"],
            "--velocity-ratio = NaN is out of range: must be finite and >= 0",
        ),
        (
            &["--chi", "1:2:3", "--psi", "1:2:3", "--tensor", "mean"],
            "possible values: secant, tangent",
        ),
    ] {
        let map = fresh("bad-map.svg");
        let output =
            carom(&[&["restitution", "--map", map.to_str().unwrap()][..], arguments].concat());
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{stderr}");
        assert!(stderr.contains(expected), "{stderr}");
        assert!(output.stdout.is_empty() && !map.exists());
    }
}

#[test]
fn tensors_are_given_by_name() {
    // Sliding throughout, R_x = -1 + 2 chi/psi: v_xE = v_x - 2 (chi/psi) v_x, and psi v_z/v_x is
    // constant, so dv_xE/dv_x = 1 and dv_xE/dv_z = -2 (chi/psi) v_x/v_z.
    let sliding = ["restitution", "--chi", "2", "--psi", "8", "--velocity-ratio", "0.25"];
    let tangent = json(&[&sliding[..], &["--tensor", "tangent"]].concat());
    assert_eq!(tangent[0]["tensor"]["name"], "tangent");
    let rows = &tangent[0]["tensor"]["rows"];
    close(&rows[0][0], -1.0, 1e-15);
    close(&rows[0][2], 0.5 * 0.25, 1e-15);
    close(&rows[1][1], -0.5, 1e-15);
    close(&rows[2][0], 0.0, 0.0);
    let secant = json(&[&sliding[..], &["--tensor", "secant"]].concat());
    close(&secant[0]["tensor"]["rows"][0][0], -0.5, 0.0);
    close(&secant[0]["tensor"]["rows"][0][2], 0.0, 0.0);
    let csv = stdout(&[&sliding[..], &["--tensor", "secant", "--format", "csv"]].concat());
    assert!(csv.starts_with("chi,psi,R_x,regimes,tensor,R_xx,R_xy,R_xz,R_yx"));
    assert!(csv.ends_with("secant,-0.5,0,0,0,-0.5,0,0,0,1\n"), "{csv}");
}
