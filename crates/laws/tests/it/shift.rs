//! Cattaneo and Mindlin's law and its inverse compared with 25-digit reference values.

use carom_laws::ellipse::ContactEllipse;
use carom_laws::friction::Friction;
use carom_laws::shift::CattaneoMindlin;
use carom_laws::stiffness::ContactStiffness;
use carom_special::AxisRatio;
use serde_json::Value;

use crate::common::{cases, close, num};

fn law(inp: &Value) -> CattaneoMindlin {
    let ratio = AxisRatio::new(num(&inp["kc"])).unwrap();
    let stiffness = ContactStiffness::from_axis_ratio(num(&inp["cz"]), ratio, num(&inp["nu"]));
    CattaneoMindlin::new(stiffness.unwrap(), Friction::new(num(&inp["f"])).unwrap())
}

#[test]
fn force_from_shift() {
    for (inp, out) in cases("statics", "cm_displacement_to_force") {
        let state =
            law(&inp).at_shift(num(&inp["zeta"]), num(&inp["xi"]), num(&inp["eta"])).unwrap();
        for (name, got) in [
            ("Fx", state.force[0]),
            ("Fy", state.force[1]),
            ("Fz", state.normal_force),
            ("p", state.direction[0]),
            ("q", state.direction[1]),
        ] {
            close(name, got, num(&out[name]), 2e-15);
        }
        assert!((state.stick_depth() - num(&out["ratio"])).abs() < 1e-15);
        // (5.22): the area of stick is to that of contact as the approaches.
        assert!((state.stick_radius().powi(2) - num(&out["ratio"])).abs() < 2e-15);
        assert_eq!(state.is_sliding(), out["sliding"].as_bool().unwrap());
    }
}

#[test]
fn shift_from_force() {
    for (inp, out) in cases("statics", "cm_force_to_displacement") {
        let state = law(&inp).at_force(num(&inp["zeta"]), num(&inp["Fx"]), num(&inp["Fy"]));
        if out.is_null() {
            assert!(state.is_err());
            continue;
        }
        let state = state.unwrap();
        // At T = (1 - 1e-9) f F_z round-off in the quotient grows by (2/3)(1e-9)^(-1/3) = 667.
        let tolerance = if num(&out["ratio"]) < 1e-5 { 1e-13 } else { 4e-15 };
        close("xi", state.shift[0], num(&out["xi"]), tolerance);
        close("eta", state.shift[1], num(&out["eta"]), tolerance);
        assert!((state.stick_depth() - num(&out["ratio"])).abs() < tolerance);
    }
}

#[test]
fn the_whole_friction_is_the_end_of_the_shift() {
    let stiffness = ContactStiffness::new(1.0, 0.8, 1.2).unwrap();
    let law = CattaneoMindlin::new(stiffness, Friction::new(0.25).unwrap());
    let limit = 0.25 * law.at_shift(0.7, 0.0, 0.0).unwrap().normal_force;
    let state = law.at_force(0.7, 0.0, limit).unwrap();
    // f c_z zeta/c_y
    close("eta", state.shift[1], 0.25 * 1.2 * 0.7 / 0.8, 1e-15);
    assert!(state.is_sliding());
}

/// Sticking, slipping and sliding, the tractions over the ellipse add up to the force.
#[test]
fn tractions_carry_the_force() {
    let ellipse = ContactEllipse::new(0.3, 0.5).unwrap();
    let law = CattaneoMindlin::new(
        ContactStiffness::new(1.0, 0.8, 1.2).unwrap(),
        Friction::new(0.25).unwrap(),
    );
    for (xi, eta) in [(0.001, 0.0), (0.1, -0.15), (2.0, 1.0)] {
        let state = law.at_shift(0.7, xi, eta).unwrap();
        let rings = 20_000;
        let at = |k| {
            state.traction(&ellipse, 0.3 * ((f64::from(k) + 0.5) / f64::from(rings)).sqrt(), 0.0)
        };
        for (i, force) in state.force.into_iter().enumerate() {
            let sum = (0..rings).map(|k| at(k)[i]).sum::<f64>() * ellipse.area() / f64::from(rings);
            assert!((sum - force).abs() <= 1e-5 * force.abs(), "{xi}: {sum} {force}");
        }
    }
}
