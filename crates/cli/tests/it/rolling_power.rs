//! `carom roll`: the columns beside the loads follow from them.

use crate::common::{case, json, number};

const CASE: &str = r#"
[body_1]
material = { shear_modulus = "80 GPa", poisson = 0.25 }
[body_2]
material = { shear_modulus = "80 GPa", poisson = 0.25 }
[contact]
semi_axes = ["3 mm", "5 mm"]
F_z = "40 kN"
friction = 0.3
[rolling]
speed = "4 m/s"
creepage = 0.0007
creepage_across = -0.0005
spin = "0.3 rad/m"
[grid]
elements = 10
"#;

/// The power of the loads on the creepage is heat: each load with the velocity of its own motion.
#[test]
fn power_share_and_springs_belong_to_the_loads() {
    let file = case("rolling_power.toml", CASE);
    let rows = json(&["roll", &file, "--fastsim"]);
    let row = &rows[0];
    let [f_x, f_y, f_z, m_z] = ["F_x", "F_y", "F_z", "M_z"].map(|name| number(row, name));
    let [along, across, spin] = [0.0007, -0.0005, 0.3];
    assert_eq!(
        (number(row, "creepage"), number(row, "creepage_across"), number(row, "spin")),
        (along, across, spin)
    );
    assert!((f_z / 40e3 - 1.0).abs() < 1e-6);
    let parts = [f_x * along, f_y * across, m_z * spin];
    assert!(parts.iter().all(|part| part.abs() > 1e-3), "{parts:?}");
    let power = 4.0 * parts.iter().sum::<f64>();
    assert!((number(row, "power") / power - 1.0).abs() < 1e-12);
    let used = f_x.hypot(f_y) / (0.3 * f_z);
    assert!((number(row, "used") / used - 1.0).abs() < 1e-12 && used < 1.0);
    // Springs come near, each to its own force.
    for (name, force) in [("F_x_springs", f_x), ("F_y_springs", f_y)] {
        assert!(
            (number(row, name) - force).abs() < 0.1 * 0.3 * f_z,
            "{name}: {} {force}",
            number(row, name)
        );
    }
    assert!((f_x - f_y).abs() > 0.3 * 0.3 * f_z, "{f_x} {f_y}");
}

/// From rest: the way by the speed is the time.
#[test]
fn the_time_of_rolling_is_the_way_over_the_speed() {
    let file = case("rolling_time.toml", &CASE.replace("[grid]", "distance = \"3 mm\"\n[grid]"));
    let rows = json(&["roll", &file]);
    let rows = rows.as_array().unwrap();
    assert!(rows.len() > 3);
    for row in rows {
        assert!((number(row, "time") - number(row, "distance") / 4.0).abs() < 1e-15);
    }
    assert!((number(&rows[rows.len() - 1], "distance") - 3e-3).abs() < 0.7e-3);
}
