//! `carom history --tractions`: integrated over the contact they give the loads.

use crate::common::{case, json, number};
use serde_json::Value;
use std::f64::consts::PI;

/// The integral over the ellipse of what depends on the elliptical radius alone: 2 pi a b int t r dr.
fn over_contact(step: &Value, name: &str) -> f64 {
    let rows = step["tractions"].as_array().unwrap();
    let points: Vec<[f64; 2]> = rows
        .iter()
        .map(|row| [number(row, "radius"), number(row, "radius") * number(row, name)])
        .collect();
    let sum: f64 = points.windows(2).map(|p| 0.5 * (p[1][0] - p[0][0]) * (p[0][1] + p[1][1])).sum();
    2.0 * PI * number(step, "semi_axis_a") * number(step, "semi_axis_b") * sum
}

#[test]
fn tractions_add_up_to_the_forces_and_their_limit_to_friction() {
    let text = r#"
[body_1]
radii = [0.03, 0.012]
material = { shear_modulus = 1e6, poisson = 0.5 }
[body_2]
radii = inf
material = { rigid = true }
[contact]
angle = 0
friction = 0.4
[history]
steps = [
    [1.0e-4, 0.0, 0.0],
    [1.0e-4, 2.0e-5, 1.0e-5],
    [1.3e-4, 4.0e-5, 3.0e-5],
    [1.1e-4, 1.0e-5, 4.0e-5],
    [1.1e-4, 2.0e-4, 1.0e-4],
]
"#;
    let file = case("history_tractions.toml", text);
    let steps = json(&["history", &file, "--tractions", "2001"]);
    for step in steps.as_array().unwrap() {
        let limit = 0.4 * number(step, "F_z");
        for (name, force) in
            [("t_x", number(step, "F_x")), ("t_y", number(step, "F_y")), ("limit", limit)]
        {
            let sum = over_contact(step, name);
            assert!((sum - force).abs() < 2e-3 * limit, "{name}: {sum} {force}");
        }
        // Seen along x and y the contact shrinks alike: the stick ellipse has the same axis ratio.
        let [a, b] = ["semi_axis_a", "semi_axis_b"].map(|axis| number(step, axis));
        let [stick_a, stick_b] =
            ["stick_semi_axis_a", "stick_semi_axis_b"].map(|axis| number(step, axis));
        assert!((stick_a * b - stick_b * a).abs() < 1e-12 * a * b && stick_b <= b);
    }
    let last = &steps[4];
    // Between the axes of an ellipse the law is within 1e-3 of friction.
    let share = number(last, "F_x").hypot(number(last, "F_y")) / (0.4 * number(last, "F_z"));
    assert!((share - 1.0).abs() < 1e-3, "{share}");
    assert_eq!(number(last, "stick_semi_axis_b"), 0.0);
}
