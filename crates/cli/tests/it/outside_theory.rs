//! How far a result lies outside the theory: by the smallest radius of curvature, of a slender body too.

use crate::common::{case, json};

/// An ellipsoid that falls on its flat side, its contact 3 times as long as wide.
#[test]
fn the_approach_to_a_slender_body_is_judged_by_its_smallest_radius() {
    let text = "[body_1]\nshape = \"ellipsoid\"\nsemi_axes = [0.03, 0.01, 0.012]\n\
                position = [0, 0, 0.012]\nmaterial = { young_modulus = 2e6, poisson = 0.4 }\n\
                mass = 0.03\nvelocity = [0, 0, -3]\nspin = [0, 0, 0]\n\
                [body_2]\nshape = \"plane\"\nmaterial = { rigid = true }\nfixed = true\n\
                [contact]\nfriction = 0.3\n";
    let found = json(&["impact", &case("slender_outside.toml", text)]);
    let approach = found["maximal_approach"].as_f64().unwrap();
    // b^2/c across, a^2/c along the body.
    let smallest = 0.01 * 0.01 / 0.012;
    let share = approach / smallest;
    assert!(share > 0.1, "{share}");
    let reasons = found["outside_theory"].as_array().unwrap();
    let told = reasons.iter().find_map(|reason| {
        let text = reason.as_str().unwrap().strip_prefix("the approach is ")?;
        text.split(' ').next().unwrap().parse::<f64>().ok()
    });
    let told = told.unwrap_or_else(|| panic!("{reasons:?}"));
    assert!((told / share - 1.0).abs() < 6e-3, "{told} is not {share}");
}
