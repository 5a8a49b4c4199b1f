//! Fields and numbers of an impact that are rejected, with line, value and range.

use crate::common::pebble::{changed, refused};
use std::path::Path;

#[test]
fn bad_fields_are_refused_with_line_value_and_range() {
    for (old, new, expected) in [
        (
            "semi_axes = [0.03, 0.02, 0.015]",
            "semi_axes = [0.03, -0.02, 0.015]",
            "line 3: `body_1.semi_axes.y` = -0.02 is out of range: must be finite and > 0",
        ),
        (
            "semi_axes = [0.03, 0.02, 0.015]",
            "",
            "`body_1.semi_axes` is missing: must be three numbers",
        ),
        (
            "semi_axes",
            "radius",
            "line 3: unknown field `body_1.radius`; `body_1` of shape \"ellipsoid\" takes `shape`",
        ),
        (
            "quaternion = [1, 0, 0, 0]",
            "quaternion = [1, 0, 0.1, 0]",
            "line 7: `body_1.quaternion` = 1.00498756211",
        ),
        (
            "quaternion = [1, 0, 0, 0]",
            "quaternion = [1, 0, nan, 0]",
            "line 7: `body_1.quaternion.j` = NaN is out of range: must be finite",
        ),
        (
            "quaternion = [1, 0, 0, 0]",
            "angles = [1, inf, 0]",
            "line 7: `body_1.angles.beta` = inf is out of range: must be finite",
        ),
        (
            "quaternion",
            "angles = [0, 0, 0]\nquaternion",
            "line 7: `body_1.angles` excludes `body_1.quaternion`: give one of them",
        ),
        ("quaternion", "normal = [0, 0, 1]\nquaternion", "line 7: unknown field `body_1.normal`"),
        (
            "[1.2e-5, 2.2e-5, 2.6e-5]",
            "[1.2e-5, 2.2e-5, 3.6e-5]",
            "line 6: `body_1.inertia` = 0.000036 is out of range: must be <= the sum of the other two",
        ),
        (
            "[1.2e-5, 2.2e-5, 2.6e-5]",
            "[1.2e-5, -2.2e-5, 2.6e-5]",
            "line 6: `body_1.inertia.y` = -0.000022 is out of range: must be > 0",
        ),
        (
            "[1.2e-5, 2.2e-5, 2.6e-5]",
            "\"hollow\"",
            "line 6: `body_1.inertia` = \"hollow\" is not allowed: must be \"solid\", \"shell\" or three moments",
        ),
        (
            "mass = 0.1",
            "mass = inf",
            "line 15: `body_2.fixed` = inf is out of range: must be a finite mass",
        ),
        (
            "mass = 0.1\ninertia = [1.2e-5, 2.2e-5, 2.6e-5]",
            "density = 2500\ninertia = \"shell\"",
            "line 5: `body_1.density` excludes `body_1.inertia`: a thin shell",
        ),
        (
            "[0, 0, 0.015]",
            "[0, nan, 0.015]",
            "line 8: `body_1.position.y` = NaN is out of range: must be finite",
        ),
        (
            "[contact]",
            "[approach]\nspeed = 1\nangle = 3\n[contact]",
            "line 9: `body_1.velocity` excludes `approach`",
        ),
        ("[0.6, 0.4, -2]", "[0.6, 0.4, inf]", "line 9: `body_1.velocity.z` = inf is out of range"),
        (
            "fixed = true",
            "fixed = true\ninertia = [1, 1, 1]",
            "line 16: `body_2.inertia` excludes `body_2.fixed`",
        ),
        (
            "fixed = true",
            "density = 1\nvelocity = [0, 0, 0]\nspin = [0, 0, 0]",
            "line 15: `body_2.density` excludes `body_2.shape`: it has no volume",
        ),
        (
            "fixed = true",
            "fixed = true\nnormal = [0, 0, 0]",
            "line 16: `body_2.normal` = 0 is out of range: must be a vector of finite length > 0",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\nlaw = \"elastic\"",
            "line 19: `contact.law` = \"elastic\" is not allowed: must be \"auto\", \"coulomb\", \"fixed-direction\", \"rings\" or \"numerical\"",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\ntorsion = 1",
            "line 19: `contact.torsion` = 1 is not allowed: must be true or false",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\nsearch = \"near\"",
            "line 19: `contact.search` = \"near\" is not allowed: must be \"touch\"",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\npoint = [0, 0, 0]\nsearch = \"touch\"",
            "line 20: `contact.search` excludes `contact.point`",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\nnormal_restitution = 0.9\nwave_loss = true",
            "line 19: `contact.normal_restitution` excludes `contact.wave_loss`: the loss by",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\npoint_1 = [0, 0, -0.015]",
            "line 8: `body_1.position` excludes `contact.point_1`",
        ),
        (
            "friction = 0.2",
            "friction = 0.2\n[uncertainty]\nsamples = 10\nseed = 1",
            "line 19: `uncertainty` excludes `contact.friction`: no field is uncertain",
        ),
        (
            "shape = \"plane\"",
            "shape = \"torus\"\nradius = 1\ntube_radius = 1",
            "line 15: `body_2.tube_radius` = 1 is out of range: must be < `radius`",
        ),
    ] {
        let message = refused("bad-field", &changed(old, new));
        let is_told = message.starts_with("error: CASE: ") && message.contains(expected);
        assert!(is_told, "{new}: {message}");
    }
}

#[test]
fn numbers_too_large_together_are_refused() {
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/rubber_on_table.toml");
    let text = std::fs::read_to_string(example).unwrap();
    let message = refused("stiff", &text.replace("20e6", "1e300"));
    assert!(message.contains("c_x = 2.6") && message.contains("from 1e-60 to 1e60"), "{message}");
    let huge = text.replace("density = 1000 ", "density = 1e250 ");
    let message = refused("huge", &huge.replace("speed = 1.414213562373095 ", "speed = 1e99 "));
    assert!(message.contains("impulse") && message.contains("must be finite"), "{message}");
}
