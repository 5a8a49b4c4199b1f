//! `carom restitution` as a user meets it.

use crate::common::{case, close, fresh, json, refusal, stdout};

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

/// Kelvin-Voigt bodies, by springs of an independent program; sliding throughout in closed form.
#[test]
fn a_loss_along_the_normal_counts() {
    let lossy = ["restitution", "--kappa", "1.2", "--lambda", "2,6", "--normal-restitution"];
    let rows = json(&[&lossy[..], &["0.5"]].concat());
    close(&rows[0]["R_x"], 0.15564, 2e-5);
    close(&rows[1]["R_x"], -0.125, 1e-14);
    close(&rows[1]["normal_restitution"], 0.5, 0.0);
    let rows = json(&[
        "restitution",
        "--chi",
        "2.9166666666666665",
        "--psi",
        "1.6666666666666667",
        "--normal-restitution",
        "0.5",
    ]);
    close(&rows[0]["R_x"], 0.15564, 2e-5);
    let [elastic, without] = [&["1"][..], &[]].map(|last| {
        let arguments = if last.is_empty() { &lossy[..5] } else { &lossy[..] };
        json(&[arguments, last].concat())[0]["R_x"].clone()
    });
    assert_eq!(elastic, without);
    for (last, expected) in [
        (&["1.5"][..], "--normal-restitution = 1.5 is out of range: must be from 0 to 1"),
        (&["0.5", "--gamma", "0.1", "--friction", "0.3"], "cannot be used with"),
    ] {
        let stderr = refusal(&[&lossy[..], last].concat());
        assert!(stderr.contains(expected), "{stderr}");
    }
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
        let stderr = refusal(&arguments.concat());
        assert!(stderr.contains(expected), "{stderr}");
        assert!(!plot.exists());
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
        let stderr =
            refusal(&[&["restitution", "--map", map.to_str().unwrap()][..], arguments].concat());
        assert!(stderr.contains(expected), "{stderr}");
        assert!(!map.exists());
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

/// R_x of a ball of Poisson's ratio 0.22 that meets a rigid plane with f = 0.1, by `carom impact`.
fn collided(lambda: f64) -> f64 {
    let angle = libm::atan(0.1 * lambda).to_degrees();
    let text = format!(
        "body_1 = {{ shape = 'sphere', radius = 0.01, density = 2500, spin = [0, 0, 0], \
         material = {{ young_modulus = 70e9, poisson = 0.22 }} }}\n\
         body_2 = {{ shape = 'plane', fixed = true, material = {{ rigid = true }} }}\n\
         contact = {{ friction = 0.1, law = 'rings' }}\n\
         approach = {{ speed = 1, angle = {angle} }}\n"
    );
    let outcome = json(&["impact", &case("dissimilar.toml", &text)]);
    assert_eq!(outcome["method"], "rings", "{outcome}");
    outcome["R_x"].as_f64().unwrap()
}

#[test]
fn dissimilar_spheres_are_answered_by_table_or_rings() {
    // kappa and gamma of nu = 0.22 against what is rigid.
    let (kappa, gamma) = ((0.89 / 0.78_f64).to_string(), (-0.28 / 0.78_f64).to_string());
    let of = ["restitution", "--kappa", &kappa, "--gamma", &gamma, "--friction", "0.1"];
    let rows = json(&[&of[..], &["--lambda", "2,9,inf"]].concat());
    for (row, method, r_x, within) in [
        (0, "table", collided(2.0), 3e-3),
        (1, "rings", collided(9.0), 1e-9),
        (2, "frictionless", -1.0, 0.0),
    ] {
        assert_eq!(rows[row]["method"], method);
        close(&rows[row]["R_x"], r_x, within);
        let estimate = rows[row]["error_estimate"].as_f64().unwrap();
        assert!(estimate < 0.02 && (estimate == 0.0) == (method == "frictionless"), "{estimate}");
        close(&rows[row]["gamma"], -0.28 / 0.78, 0.0);
        close(&rows[row]["friction"], 0.1, 0.0);
        assert!(rows[row].get("regimes").is_none());
    }
    let csv = stdout(&[&of[..], &["--lambda", "2", "--format", "csv"]].concat());
    assert!(csv.starts_with("kappa,gamma,friction,lambda,R_x,method,error_estimate\n"), "{csv}");
    assert!(csv.contains(",0.1,2,") && csv.contains(",table,"), "{csv}");
}

#[test]
fn spheres_of_gamma_0_are_alike_spheres() {
    let of = ["restitution", "--kappa", "1.2", "--lambda", "0:9:19"];
    let alike = json(&of);
    let zero = json(&[&of[..], &["--gamma", "0", "--friction", "0.3"]].concat());
    for (alike, zero) in alike.as_array().unwrap().iter().zip(zero.as_array().unwrap()) {
        assert_eq!(alike["R_x"], zero["R_x"]);
        assert_eq!(zero["method"], "uncoupled");
    }
    let hollow = ["--gamma", "0", "--friction", "0.3", "--mobility-ratio", "2.5"];
    let hollow = json(&[&of[..], &hollow].concat());
    // Sliding throughout: R_x = -1 + 5/lambda.
    close(&hollow[18]["R_x"], -1.0 + 5.0 / 9.0, 1e-15);
}

#[test]
fn dissimilar_spheres_are_drawn() {
    let dissimilar = ["restitution", "--gamma", "0.1", "--friction", "0.05", "--format", "none"];
    for (option, kappa) in [("--plot", "1,1.2"), ("--map", "1:1.4:11")] {
        let picture = fresh(&format!("dissimilar{option}.svg"));
        let spans = ["--kappa", kappa, "--lambda", "0.1:7:12", option, picture.to_str().unwrap()];
        assert_eq!(stdout(&[&dissimilar[..], &spans].concat()), "");
        let svg = std::fs::read_to_string(&picture).unwrap();
        assert!(svg.contains("Dissimilar spheres, γ = 0.1, f = 0.05") && !svg.contains("NaN"));
    }
}

#[test]
fn bad_numbers_of_dissimilar_spheres_name_their_option() {
    for (arguments, expected) in [
        (
            &["--gamma", "0.4", "--friction", "0.1"][..],
            "--gamma = 0.4 is out of range: must be |gamma| <= 3/2 - kappa",
        ),
        (&["--gamma", "nan", "--friction", "0.1"], "--gamma = NaN is out of range"),
        (&["--gamma", "0.1", "--friction", "-1"], "--friction = -1 is out of range"),
        (
            &["--gamma", "0.1", "--friction", "inf"],
            "--lambda = 1 is out of range: must be 0 where friction is infinite",
        ),
        (
            &["--gamma", "0.1", "--friction", "0.1", "--mobility-ratio", "0"],
            "--mobility-ratio = 0 is out of range",
        ),
        (&["--gamma", "0.1"], "--friction <VALUE>"),
        (&["--friction", "0.1"], "--gamma <VALUE>"),
        (&["--mobility-ratio", "2.5"], "--gamma <VALUE>"),
        (&["--gamma", "0.1", "--friction", "0.1", "--tensor", "secant"], "cannot be used with"),
    ] {
        let spheres = ["restitution", "--kappa", "1.2", "--lambda", "1"];
        let stderr = refusal(&[&spheres[..], arguments].concat());
        assert!(stderr.contains(expected), "{stderr}");
    }
}

/// The limit for vanishing tangential velocities comes from an impact at lambda = .02: its estimate is the one beside it.
#[test]
fn the_estimate_of_the_limit_goes_on_that_of_small_tangential_velocities() {
    for [kappa, gamma, friction] in [["1.2", "0.25", "0.01"], ["1.2", "0.1", "0.05"]] {
        let arguments = ["restitution", "--kappa", kappa, "--gamma", gamma, "--friction", friction];
        let rows = json(&[&arguments[..], &["--lambda", "0,0.02,0.03"]].concat());
        let of = |name: &str| -> Vec<f64> {
            rows.as_array().unwrap().iter().map(|row| row[name].as_f64().unwrap()).collect()
        };
        let (restitution, estimates) = (of("R_x"), of("error_estimate"));
        assert!((0.5..2.0).contains(&(estimates[0] / estimates[1])), "{estimates:?}");
        assert!((restitution[0] - restitution[1]).abs() < estimates[0] + estimates[1]);
        assert!((0.7..1.6).contains(&(estimates[1] / estimates[2])), "{estimates:?}");
    }
}
