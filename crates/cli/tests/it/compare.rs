//! `carom compare` as a user meets it.

use crate::common::{case, json, refusal};

const CASE: &str = r#"
[body_1]
material = { shear_modulus = "80 GPa", poisson = 0.0 }
[body_2]
material = { shear_modulus = "80 GPa", poisson = POISSON }
[gap]
shape = "sphere"
radius = "10 mm"
[grid]
cells = [14, 14]
size = ["0.16 mm", "0.16 mm"]
[contact]
friction = 0.3
tolerance = 1e-11
[[step]]
F_z = 4.0
[[step]]
xi = "0.08 um"
count = 3
[[step]]
xi = "-0.05 um"
count = 2
"#;

#[test]
fn all_methods_that_apply_agree_and_the_others_say_why_not() {
    for (poisson, refused) in [("0.0", None), ("0.5", Some("Johnson"))] {
        let name = format!("compare_{poisson}.toml");
        let rows = json(&["compare", &case(&name, &CASE.replace("POISSON", poisson))]);
        let rows = rows.as_array().unwrap();
        assert_eq!(rows.len(), 6);
        for row in rows {
            if row["method"].as_str() == refused {
                assert!(row["note"].as_str().unwrap().contains("similar material"), "{row}");
                continue;
            }
            assert!(row["difference"].as_f64().unwrap() < 1e-7, "{row}");
            assert!(row["iterations"].as_u64().unwrap() > 4, "{row}");
            // Only the solver of today counts products with blocks of the influence, and needs at least one
            // along the normal and one along the surface in each of the six steps.
            let products = row["products"].as_f64();
            match row["method"].as_str().unwrap() {
                "frictional" => assert!(products.unwrap() > 12.0, "{row}"),
                _ => assert!(products.is_none_or(|products| products > 0.0), "{row}"),
            }
        }
    }
}

#[test]
fn a_case_that_does_not_fit_is_refused() {
    let text = CASE.replace("POISSON", "0.0").replace("F_z = 4.0", "F_z = 20000.0");
    refusal(&["compare", &case("compare_border.toml", &text)]);
}

#[test]
fn a_case_names_its_method_and_what_does_not_apply_names_what_does() {
    let shifts = CASE.replace("F_z = 4.0", "zeta = \"0.35 um\"");
    let last = |method: &str| {
        let text = shifts
            .replace("POISSON", "0.0")
            .replace("friction = 0.3", &format!("friction = 0.3\nmethod = \"{method}\""));
        json(&["solve", &case(&format!("method_{method}.toml"), &text)])[5]["F_x"].as_f64().unwrap()
    };
    let newton = last("newton");
    for method in ["gauss_seidel", "discs", "johnson", "panagiotopoulos", "kombi"] {
        let other = last(method);
        assert!((other / newton - 1.0).abs() < 1e-7, "{method}: {other} {newton}");
    }
    let refused = |name: &str, text: String, parts: &[&str]| {
        let said = refusal(&["solve", &case(name, &text)]);
        assert!(parts.iter().all(|part| said.contains(part)), "{said} lacks one of {parts:?}");
    };
    let johnson = "friction = 0.3\nmethod = \"johnson\"";
    let unlike = shifts.replace("POISSON", "0.5").replace("friction = 0.3", johnson);
    refused("method_unlike.toml", unlike, &["Johnson", "Panagiotopoulos", "\"newton\""]);
    let loaded = CASE.replace("POISSON", "0.0").replace("friction = 0.3", johnson);
    refused("method_loaded.toml", loaded, &["F_z is prescribed", "\"newton\""]);
    let wrong = shifts
        .replace("POISSON", "0.0")
        .replace("friction = 0.3", "friction = 0.3\nmethod = \"tang\"");
    refused("method_wrong.toml", wrong, &["contact.method", "\"tang\"", "kombi"]);
}
