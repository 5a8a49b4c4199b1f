//! An ellipsoid that hits a plane, and the results of the command for it.

use super::{case, fresh, refusal, stdout};

pub(crate) const CASE: &str = r#"[body_1]
shape = "ellipsoid"
semi_axes = [0.03, 0.02, 0.015]
material = { young_modulus = 70e9, poisson = 0.22 }
mass = 0.1
inertia = [1.2e-5, 2.2e-5, 2.6e-5]
quaternion = [1, 0, 0, 0]
position = [0, 0, 0.015]
velocity = [0.6, 0.4, -2]
spin = [0, 0, 20]

[body_2]
shape = "plane"
material = { young_modulus = 70e9, poisson = 0.22 }
fixed = true

[contact]
friction = 0.2
"#;

/// The same body by its curvatures alone: r = A^2/C, B^2/C at the end of axis c.
pub(crate) const GIVEN: &str = "shape = \"given\"\nradii = [0.06, 0.02666666666666667]\n\
                     point = [0, 0, -0.015]\nnormal = [0, 0, -1]\ndirection = [1, 0, 0]";

pub(crate) fn solved(name: &str, text: &str) -> serde_json::Value {
    let file = case(&format!("{name}.toml"), text);
    serde_json::from_str(&stdout(&["impact", &file, "--format", "json"])).unwrap()
}

/// What the command says of a bad case; it must end with code 2 and give nothing else.
pub(crate) fn refused(name: &str, text: &str) -> String {
    let file = case(&format!("{name}.toml"), text);
    let plot = fresh(&format!("{name}.svg"));
    let stderr = refusal(&["impact", &file, "--plot", plot.to_str().unwrap()]);
    assert!(!plot.exists(), "{stderr}");
    stderr.replace(&file, "CASE")
}

pub(crate) fn changed(old: &str, new: &str) -> String {
    assert!(CASE.contains(old), "{old}");
    CASE.replacen(old, new, 1)
}

pub(crate) fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|part| part.as_f64().unwrap()).collect()
}

pub(crate) fn all_close(one: &[f64], other: &[f64], tolerance: f64) {
    assert_eq!(one.len(), other.len());
    let off = one.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= tolerance, "{one:?} {other:?}");
}
