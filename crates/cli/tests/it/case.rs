//! Bad case files: every error names the field, its value and what is allowed.

use carom_cases::case::{Case as _, CaseError, CaseFault, HistoryCase, ImpactFile};
use carom_laws::friction::Friction;
use carom_laws::turning_law::TurningLaw;

const CASE: &str = "\
[body_1]
shape = \"sphere\"
radius = 0.0025
material = { young_modulus = 380e9, poisson = 0.23 }
density = 4000.0
velocity = [1.0, 0.0, -3.9]
spin = [0.0, 10.0, 0.0]

[body_2]
shape = \"plane\"
material = { rigid = true }
mass = 2.5
velocity = [0.0, 0.0, 0.0]
spin = [0.0, 0.0, 0.0]

[contact]
friction = 0.092
";

/// The case with `old` replaced, which must be there.
fn changed(old: &str, new: &str) -> String {
    assert!(CASE.contains(old), "{old}");
    CASE.replacen(old, new, 1)
}

fn error(source: &str) -> String {
    ImpactFile::parse(source).unwrap_err().to_string()
}

#[test]
fn friction_by_the_slip_speed_is_read_and_its_errors_are_named() {
    let with = |table: &str| changed("friction = 0.092", &format!("friction = {table}"));
    let file = with("{ a = 0.05, b = 0.1, c = [1, \"0.5 ms/m\"] }");
    let file = ImpactFile::parse(&file).unwrap();
    // Spin 10 rad/s about y moves the contact point 2.5 mm below the centre by -25 mm/s.
    let slip: f64 = 1.0 - 0.025;
    let (input, values) = file.sweep().unwrap();
    assert_eq!((input.field, input.unit, values), ("contact.friction.c", "s/m", &[1.0, 5e-4][..]));
    for c in values {
        let f = file.case(&[*c]).unwrap().collision.friction().get();
        assert!((f - (0.05 + 0.1 * (-c * slip).exp())).abs() < 1e-15, "{c}: {f}");
    }
    for (table, said) in [
        ("{ a = 0.05, b = 0.1 }", "`contact.friction.c` is missing"),
        ("{ a = -1, b = 0.1, c = 1 }", "`contact.friction.a` = -1 is out of range: must be finite"),
        (
            "{ a = 0.05, b = -0.1, c = 1 }",
            "`contact.friction.b` = -0.1 is out of range: must be finite, with a + b",
        ),
        (
            "{ a = 0.05, b = 0.1, c = -1 }",
            "`contact.friction.c` = -1 is out of range: must be finite",
        ),
        ("{ a = 0.05, b = 0.1, c = 1, d = 2 }", "unknown field `contact.friction.d`"),
        ("{ a = 0.05, b = 0.1, c = \"1 m/s\" }", "plain in s/m"),
        ("{ k = 1 }", "unknown field `contact.friction.k`"),
        // No slip is one value of friction; nothing lies equally spaced between it and another one.
        (
            "{ start = 0, stop = inf, count = 3 }",
            "friction.stop` = inf is out of range: must be finite",
        ),
        ("{ start = inf, stop = 1, count = 3 }", "`contact.friction.start` = inf is out of range"),
    ] {
        let error = error(&with(table));
        assert!(error.contains(said), "{table}: {error}");
    }
}

#[test]
fn static_friction_is_read_and_its_errors_are_named() {
    let with = |lines: &str| changed("friction = 0.092", lines);
    let case = with("friction = 0.092\nstatic_friction = [0.1, 0.2]");
    let file = ImpactFile::parse(&case).unwrap();
    let (input, values) = file.sweep().unwrap();
    assert_eq!(input.field, "contact.static_friction");
    for f in values {
        let collision = file.case(&[*f]).unwrap().collision;
        let friction = collision.static_friction().unwrap();
        assert_eq!((friction.threshold().get(), collision.friction().get()), (*f, 0.092));
    }
    let equal = with("friction = 0.092\nstatic_friction = 0.092");
    let equal = ImpactFile::parse(&equal).unwrap();
    assert_eq!(equal.nominal().collision.static_friction(), None);
    for (lines, said) in [
        (
            "friction = 0.2\nstatic_friction = 0.1",
            "`contact.static_friction` = 0.1 is out of range: must be finite and",
        ),
        (
            "friction = 0.2\nstatic_friction = inf",
            "`contact.static_friction` = inf is out of range: must be finite and >= 0",
        ),
        ("friction = 0.2\nstatic_friction = -1", "`contact.static_friction` = -1 is out of range"),
        (
            "friction = { a = 0.1, b = 0.1, c = 1 }\nstatic_friction = 0.4",
            "one coefficient at rest",
        ),
        ("friction = 0.2\nstatic_friction = 0.3\nlaw = \"rings\"", "this law has one coefficient"),
        (
            "friction = 0.2\nstatic_friction = 0.3\nlaw = \"numerical\"",
            "this law has one coefficient",
        ),
        ("friction = 0.2\nstatic_friction = 0.3\ntorsion = true", "torsion has one coefficient"),
    ] {
        let error = error(&with(lines));
        assert!(error.contains(said), "{lines}: {error}");
    }
}

#[test]
fn a_good_case_is_read() {
    let file = ImpactFile::parse(CASE).unwrap();
    let case = file.nominal();
    let [one, two] = case.collision.bodies();
    assert_eq!(one.placed().surface().radius(), Some(0.0025));
    let volume = 4.0 / 3.0 * std::f64::consts::PI * 0.0025f64.powi(3);
    assert!((one.inertia().mass() / (4000.0 * volume) - 1.0).abs() < 1e-14);
    assert_eq!(<[f64; 3]>::from(one.motion().velocity), [1.0, 0.0, -3.9]);
    assert_eq!(<[f64; 3]>::from(one.motion().spin), [0.0, 10.0, 0.0]);
    assert!(two.material().is_rigid());
    assert_eq!(two.inertia().mass(), 2.5);
    assert_eq!(case.contact.friction, Friction::new(0.092).unwrap().into());
    assert_eq!(case.angle, None);
    assert!(file.sweep().is_none() && file.uncertainty().is_none());
}

#[test]
fn limits_are_valid() {
    for (old, new) in [
        ("friction = 0.092", "friction = 0"),
        ("friction = 0.092", "friction = inf"),
        ("mass = 2.5", "mass = inf"),
        ("poisson = 0.23", "poisson = 0.5"),
        ("poisson = 0.23", "poisson = -0.5"),
        ("velocity = [1.0, 0.0, -3.9]", "velocity = [1, 0, 3.9]"),
        ("young_modulus", "shear_modulus"),
        ("density = 4000.0", "mass = 1e-3"),
        ("mass = 2.5\nvelocity = [0.0, 0.0, 0.0]\nspin = [0.0, 0.0, 0.0]", "fixed = true"),
    ] {
        let text = changed(old, new);
        assert!(ImpactFile::parse(&text).is_ok(), "{new}");
    }
}

#[test]
fn every_missing_field_is_named() {
    for (line, field) in [
        ("shape = \"sphere\"", "body_1.shape"),
        ("radius = 0.0025", "body_1.radius"),
        ("material = { young_modulus = 380e9, poisson = 0.23 }", "body_1.material"),
        ("young_modulus = 380e9, ", "body_1.material.young_modulus"),
        (", poisson = 0.23", "body_1.material.poisson"),
        ("density = 4000.0", "body_1.mass"),
        ("shape = \"plane\"", "body_2.shape"),
        ("material = { rigid = true }", "body_2.material"),
        ("mass = 2.5", "body_2.mass"),
        ("friction = 0.092", "contact.friction"),
        ("[contact]\nfriction = 0.092", "contact"),
    ] {
        let message = error(&changed(line, ""));
        let said = format!("`{field}` is missing: must be ");
        assert!(message.contains(&said), "{message}");
        // In a table of the file, with its line.
        assert_eq!(message.starts_with("line "), field.contains('.'), "{message}");
    }
}

#[test]
fn a_motion_that_is_not_given_is_zero_but_one_body_moves() {
    let motion = |source: &str, body: usize| {
        let motion = ImpactFile::parse(source).unwrap().nominal().collision.bodies()[body].motion();
        (<[f64; 3]>::from(motion.velocity), <[f64; 3]>::from(motion.spin))
    };
    let rest = CASE.replace("velocity = [0.0, 0.0, 0.0]\nspin = [0.0, 0.0, 0.0]\n", "");
    assert_eq!(motion(&rest, 1), ([0.0; 3], [0.0; 3]));
    assert_eq!(motion(&rest, 0), ([1.0, 0.0, -3.9], [0.0, 10.0, 0.0]));
    let spinless = changed("spin = [0.0, 10.0, 0.0]", "");
    assert_eq!(motion(&spinless, 0), ([1.0, 0.0, -3.9], [0.0; 3]));
    let still = rest.replace("velocity = [1.0, 0.0, -3.9]\n", "");
    let message = ImpactFile::parse(&still).unwrap_err().to_string();
    let expected =
        "`body_1.velocity` is missing: must be three numbers [x, y, z] (or `[approach]`)";
    assert!(message.contains(expected), "{message}");
}

#[test]
fn every_bad_value_is_named_with_its_range() {
    for (field, old, bad, allowed) in [
        ("body_1.radius", "0.0025", &["nan", "inf", "-1.0", "0"][..], "finite and > 0"),
        ("body_1.material.young_modulus", "380e9", &["nan", "inf", "-1", "0"], "finite and > 0"),
        ("body_1.material.poisson", "0.23", &["nan", "inf", "-1", "0.51"], "in (-1, 0.5]"),
        ("body_1.density", "4000.0", &["nan", "inf", "-1", "0"], "finite and > 0"),
        ("body_1.velocity.z", "-3.9", &["nan", "inf", "-inf"], "finite, within +-1e100"),
        ("body_1.spin.y", "10.0", &["nan", "inf", "-inf"], "finite, within +-1e100"),
        ("body_2.mass", "2.5", &["nan", "-1", "0", "-inf"], "> 0 (inf is allowed)"),
        (
            "contact.friction",
            "0.092",
            &["nan", "-1", "-inf"],
            ">= 0 (0, 1e-30 to 1e30, or inf: no slip)",
        ),
    ] {
        for value in bad {
            let message = error(&changed(old, value));
            let number: f64 = value.parse().unwrap();
            let expected = format!("`{field}` = {number} is out of range: must be {allowed}");
            assert!(message.starts_with("line ") && message.ends_with(&expected), "{message}");
        }
    }
    // A mass too small and one too large for a number.
    for density in ["1e-320", "1e308"] {
        let large = changed("4000.0", density).replace("0.0025", "1e10");
        let small = changed("4000.0", density).replace("0.0025", "1e-10");
        let message = error(if density == "1e308" { &large } else { &small });
        let end = "is out of range: must be such that the mass is finite and > 0";
        assert!(message.contains("`body_1.density` = ") && message.ends_with(end), "{message}");
    }
    let message = error(&changed("0.092", "1e-40"));
    assert!(message.starts_with("line 17: `contact.friction` = 1e-40 is"), "{message}");
}

#[test]
fn names_and_values_of_the_wrong_kind_are_named() {
    insta::assert_snapshot!(error(&changed("radius", "radus")), @r#"line 3: unknown field `body_1.radus`, did you mean `radius`? `body_1` of shape "sphere" takes `shape`, `radius`, `material`, `density`, `mass`, `fixed`, `inertia`, `position`, `quaternion`, `angles`, `velocity`, `spin`"#);
    insta::assert_snapshot!(error(&changed("0.0025", "\"big\"")), @r#"line 3: `body_1.radius` = "big" is not allowed: must be a number, finite and > 0, plain in m or as a text with a unit of m, km, cm, mm, um, nm"#);
    insta::assert_snapshot!(error(&changed("[1.0, 0.0, -3.9]", "[1.0, -3.9]")), @"line 6: `body_1.velocity` = [1.0, -3.9] is not allowed: must be three numbers [x, y, z]");
    insta::assert_snapshot!(error(&changed("\"sphere\"", "\"cube\"")), @r#"line 2: `body_1.shape` = "cube" is not allowed: must be "sphere", "ellipsoid", "cylinder", "capsule", "torus", "box", "plane", "half-space" or "given""#);
    insta::assert_snapshot!(error(&changed("rigid = true", "rigid = 1")), @"line 11: `body_2.material.rigid` = 1 is not allowed: must be true or false");
    insta::assert_snapshot!(error("contact = 3"), @r"
    3 errors
    line 1: `contact` = 3 is not allowed: must be a table, headed [contact]
    `body_1` is missing: must be a table, headed [body_1]; the body on the side to which z points
    `body_2` is missing: must be a table, headed [body_2]; the other body
    ");
}

#[test]
fn conflicts_name_both_fields() {
    insta::assert_snapshot!(error(&changed("density = 4000.0", "density = 4000.0\nmass = 1.0")), @"line 5: `body_1.density` excludes `body_1.mass`: give one of them");
    insta::assert_snapshot!(error(&changed("mass = 2.5", "fixed = true")), @"line 13: `body_2.velocity` excludes `body_2.fixed`: a fixed body is at rest; a moving one of infinite mass has `mass = inf`");
    insta::assert_snapshot!(error(&changed("rigid = true", "rigid = true, poisson = 0.3")), @"line 11: `body_2.material.poisson` excludes `body_2.material.rigid`: a rigid body has no elastic constants");
    insta::assert_snapshot!(error(&changed("young_modulus = 380e9, poisson = 0.23", "rigid = true")), @"line 11: `body_2.material` = inf is out of range: must be finite for at least one of the two bodies: both are rigid, give one `young_modulus` and `poisson`");
    let heavy = changed("density = 4000.0", "mass = inf").replace("mass = 2.5", "mass = inf");
    insta::assert_snapshot!(error(&heavy), @"line 12: `body_2.mass` = inf is out of range: must be a finite mass for at least one of the two bodies");
    let planes = changed("shape = \"sphere\"\nradius = 0.0025", "shape = \"plane\"")
        .replace("density = 4000.0", "mass = 1.0");
    insta::assert_snapshot!(error(&planes), @"line 9: `body_2.shape` excludes `body_1.shape`: two planes do not touch at a point");
}

#[test]
fn what_is_not_toml_is_shown_with_its_line() {
    let source = changed("radius = 0.0025", "radius 0.0025");
    assert!(matches!(
        ImpactFile::parse(&source),
        Err(CaseError { line: 3, fault: CaseFault::Syntax { .. }, .. })
    ));
}

/// The case with an approach instead of a velocity.
fn approach(fields: &str) -> String {
    changed("velocity = [1.0, 0.0, -3.9]\n", "") + "\n[approach]\n" + fields
}

#[test]
fn an_approach_gives_one_angle_or_a_sweep() {
    let angles = |fields: &str| {
        let text = approach(fields);
        ImpactFile::parse(&text).unwrap().sweep().map(|(_, values)| values.to_vec())
    };
    assert_eq!(angles("speed = 3.9\nangle = 45"), None);
    assert_eq!(angles("speed = 3.9\nangle = [5, 85.0]"), Some(vec![5.0, 85.0]));
    assert_eq!(
        angles("speed = 3.9\nangle = { start = 0, stop = 90, count = 4 }"),
        Some(vec![0.0, 30.0, 60.0, 90.0])
    );
    for (angle, velocity) in [("0", [0.0, 0.0, -2.0]), ("90", [2.0, 0.0, 0.0])] {
        let text = approach(&format!("speed = 2\nangle = {angle}"));
        let file = ImpactFile::parse(&text).unwrap();
        let motion = file.nominal().collision.bodies()[0].motion();
        assert_eq!(<[f64; 3]>::from(motion.velocity), velocity);
        assert_eq!(file.nominal().angle, angle.parse().ok());
    }
}

#[test]
fn any_number_may_be_swept_but_only_one() {
    for (old, swept, field) in [
        ("radius = 0.0025", "radius = { start = 0.001, stop = 0.003, count = 3 }", "body_1.radius"),
        ("density = 4000.0", "density = [3000, \"4 g/cm3\"]", "body_1.density"),
        ("[1.0, 0.0, -3.9]", "[1.0, 0.0, [-3.9, -1]]", "body_1.velocity.z"),
        ("poisson = 0.23", "poisson = [0.2, 0.3]", "body_1.material.poisson"),
        ("friction = 0.092", "friction = [0, 0.1, inf]", "contact.friction"),
    ] {
        let text = changed(old, swept);
        let file = ImpactFile::parse(&text).unwrap();
        let (input, values) = file.sweep().unwrap();
        assert_eq!(input.field, field);
        assert!(values.len() > 1);
        let drawn = |value: f64| file.case(&[value]).unwrap().collision;
        assert!(drawn(values[1]).solve().is_ok(), "{field}");
    }
    let two = changed("radius = 0.0025", "radius = [0.1, 0.2]")
        .replace("friction = 0.092", "friction = [0.1, 0.2]");
    assert!(error(&two).contains("sweep over one field at a time"), "{}", error(&two));
    let bad = changed("friction = 0.092", "friction = [0.1, -1]");
    assert!(error(&bad).starts_with("line 17: `contact.friction` = -1 is out of range"));
}

#[test]
fn a_bad_approach_is_named() {
    for (fields, expected) in [
        ("speed = -1\nangle = 5", "`approach.speed` = -1 is out of range: must be finite and >= 0"),
        ("angle = 5", "`approach.speed` is missing: must be finite and >= 0"),
        ("speed = 1", "`approach.angle` is missing: must be in [0, 90]"),
        ("speed = 1\nangle = 91", "`approach.angle` = 91 is out of range: must be in [0, 90]"),
        ("speed = 1\nangle = []", "must be a list with at least one number"),
        ("speed = 1\nangle = [1, nan]", "`approach.angle` = NaN is out of range"),
        ("speed = 1\nangle = { start = 0, stop = 9 }", "`approach.angle.count` is missing"),
        ("speed = 1\nangle = { start = 0, stop = 9, count = 1.5 }", "a whole number from 2"),
        ("speed = 1\nangles = 5", "did you mean `angle`?"),
    ] {
        let message = error(&approach(fields));
        assert!(message.contains(expected), "{message}");
    }
    let both = CASE.to_owned() + "\n[approach]\nspeed = 1\nangle = 5";
    assert!(error(&both).contains("[approach] gives the velocity of body 1"));
}

#[test]
fn histories_choose_the_law_where_the_direction_turns() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/history_loop.toml");
    let source = std::fs::read_to_string(path).unwrap();
    let law = |fields: &str| {
        let contact = format!("friction = 0.3\n{fields}");
        HistoryCase::parse(&source.replacen("friction = 0.3", &contact, 1))
            .map(|case| (case.law, case.tolerance.get()))
    };
    let coulomb = |tolerance: &str| match law(tolerance) {
        Ok((TurningLaw::Coulomb, tolerance)) => tolerance,
        other => panic!("{other:?}"),
    };
    assert_eq!(coulomb(""), 1e-3);
    assert_eq!(coulomb("law = \"coulomb\"\ntolerance = 1e-5"), 1e-5);
    assert_eq!(law("law = \"fixed-direction\"").unwrap().0, TurningLaw::FixedDirection);
    for bad in ["0", "0.2", "-1e-3", "nan"] {
        let error = law(&format!("tolerance = {bad}")).unwrap_err().to_string();
        assert!(error.contains("contact.tolerance"), "{error}");
    }
    let both = law("law = \"fixed-direction\"\ntolerance = 1e-3").unwrap_err().to_string();
    assert!(both.contains("contact.tolerance") && both.contains("contact.law"), "{both}");
    let other = law("law = \"amontons\"").unwrap_err().to_string();
    assert!(other.contains("fixed-direction"), "{other}");
}
