//! What users are told of cases with errors.

use super::section::survey::survey;
use super::{CaseFault, CaseKind};

#[test]
fn a_case_that_is_right_has_no_errors() {
    for kind in CaseKind::ALL {
        assert_eq!(survey(&kind, &kind.template()), [], "{kind:?}");
    }
}

const TYPED: &str = "\
[body_1]
shape = \"spere\"
material = { E = 2e11, poisson = 0.3 }
mass = \"3 kilo\"
velocity = [0.5, 0]

[body_2]
shape = \"plane\"
fixed = 1

[contact]
frition = 0.2
";

#[test]
fn every_error_of_a_case_is_told_with_its_place() {
    let error = CaseKind::Impact.check(TYPED).unwrap_err();
    insta::assert_snapshot!(error.shown_in(TYPED), @r#"
    7 errors
    line 2: `body_1.shape` = "spere" is not allowed: must be "sphere", "ellipsoid", "cylinder", "capsule", "torus", "box", "plane", "half-space" or "given"; did you mean "sphere"?
      2 | shape = "spere"
        | ^^^^^
    line 3: unknown field `body_1.material.E`, did you mean `young_modulus`? `body_1.material` takes `young_modulus`, `shear_modulus`, `poisson`, `rigid`, `yield_stress`, `hardness`
      3 | material = { E = 2e11, poisson = 0.3 }
        |              ^
    line 4: `body_1.mass` = "3 kilo" is not allowed: must be a number, > 0 (inf is allowed), plain in kg or as a text with a unit of kg, t, g, mg, ug
      4 | mass = "3 kilo"
        | ^^^^
    line 5: `body_1.velocity` = [0.5, 0] is not allowed: must be three numbers [x, y, z]
      5 | velocity = [0.5, 0]
        | ^^^^^^^^
    line 9: `body_2.fixed` = 1 is not allowed: must be true or false
      9 | fixed = 1
        | ^^^^^
    line 12: unknown field `contact.frition`, did you mean `friction`? `contact` takes `friction`, `static_friction`, `normal_over_tangential_stiffness`, `law`, `torsion`, `normal_restitution`, `loss`, `wave_loss`, `relaxation`, `point`, `point_1`, `point_2`, `search`
      12 | frition = 0.2
         | ^^^^^^^
    line 7: `body_2.material` is missing: must be a table, headed [body_2.material]; material: two elastic constants, or rigid, and the yield stress if it is known
      7 | [body_2]
        |  ^^^^^^
    "#);
}

#[test]
fn what_is_meant_is_told() {
    use CaseKind::{History, Impact, Roll, Solve};
    for (kind, old, new, said) in [
        (Impact, "radius", "diameter", "did you mean `radius`, half of it?"),
        (Impact, "\"sphere\"", "\"ball\"", "; did you mean \"sphere\"?"),
        (Impact, "radius = 0.01", "radius = \"0,01 m\"", "write a point: 0.01 m"),
        (Impact, "[0.25, 0, -0.5]", "[0,25, 0, -0,5]", "; decimals have a point"),
        (Impact, "density", "poisson = 0.3\ndensity", "mean `material = { poisson = .. }`?"),
        (Impact, "density", "mu = 0.3\ndensity", "did you mean `contact.friction`?"),
        (Impact, "= 0.2", "= { mean = 0.2, sd = 0.1 }", "mean `normal = { mean = .., sd = .. }`?"),
        (Impact, "= 0.2", "= { mean = 0.2 }", "did you mean `normal = { mean = .., sd = .. }`?"),
        (
            Impact,
            "= 0.2",
            "= { low = 0.1, high = 0.3 }",
            "mean `uniform = { low = .., high = .. }`?",
        ),
        (
            Impact,
            "= 0.2",
            "= { high = 0.1, mode = 0.2, low = 0.1 }",
            "did you mean `triangular = { low = .., mode = .., high = .. }`?",
        ),
        (Impact, "radius = 0.01", "radius = \"3 in\"", "; 1 in is 0.0254 m: write 0.0762"),
        (Impact, "= 0.2", "= { uniform = [0.1, 0.2] }", "a table { low = .., high = .. }"),
        (
            Impact,
            "= 0.2",
            "= { start = 0, stop = 1, step = 0.1 }",
            "`count`, the number of values?",
        ),
        (Impact, "= 0.2", "= 0.2\nfriction_static = 0.3", "did you mean `static_friction`?"),
        (Impact, "= 0.2", "= \"f.csv\"", "; no file is read here, the values stand in the case"),
        (
            History,
            "[[1e-6, 0, 0], [1e-6, 2e-7, 0], [1e-6, 0, 0]]",
            "\"f.csv\"",
            "named by `history.file`",
        ),
        (Roll, "[0.0005, 0.001, 0.002, 0.004]", "\"0.1 %\"", "; 0.1 % is 0.001"),
        (
            Solve,
            "size = [2.6e-4, 2.6e-4]",
            "size = [260, 260]",
            "`gap.shape` = \"sphere\" is not allowed: must be such that a cell",
        ),
        (
            Solve,
            "cells = [40, 40]",
            "cells.x = 40",
            "= { x = .. } is not allowed: must be two whole",
        ),
    ] {
        let source = kind.short_template().replacen(old, new, 1);
        let error = kind.check(&source).unwrap_err().to_string();
        assert!(error.contains(said), "{new}: {error}");
    }
}

#[test]
fn an_empty_case_is_of_no_other_kind() {
    for kind in CaseKind::ALL {
        let error = kind.check("# nothing yet\n").unwrap_err();
        assert!(!matches!(error.fault, CaseFault::OtherKind { .. }), "{kind:?}: {error}");
    }
}

#[test]
fn a_case_of_another_kind_is_recognised() {
    let case = CaseKind::Impact.template();
    for kind in CaseKind::ALL.into_iter().filter(|kind| *kind != CaseKind::Impact) {
        let error = kind.check(&case).unwrap_err();
        assert_eq!(error.fault, CaseFault::OtherKind { kind: kind.name, likely: "impact" });
    }
}

#[test]
fn numbers_of_other_languages_are_told() {
    let said = |line: &str| {
        let source = format!("[contact]\n{line}\n");
        CaseKind::Impact.check(&source).unwrap_err().shown_in(&source)
    };
    let comma = said("friction = 0,3");
    assert!(
        comma.contains("line 2: ")
            && comma.contains("; 0,3 has a decimal comma, write a point: 0.3"),
        "{comma}"
    );
    assert!(comma.ends_with("\n  2 | friction = 0,3\n    |             ^"), "{comma}");
    let minus = said("friction = \u{2212}0.3");
    assert!(minus.contains("is a hyphen, -"), "{minus}");
    let twice = said("friction = 0.1\nfriction = 0.2");
    assert!(
        twice.contains("`friction` is given a second time; leave one of the two out\n"),
        "{twice}"
    );
    assert!(twice.ends_with("\n  3 | friction = 0.2\n    | ^"), "{twice}");
    for (written, meant) in [
        ("velocity = [1 2 3]", "; the items of a list are separated by commas"),
        ("points = [[1, 2], [3; 4]]", "; the items of a list are separated by commas"),
        ("velocity = (1, 2, 3)", "; a list has brackets, [1, 2, 3]"),
        ("radius = .01", "; write 0.01"),
        ("radius = 1.", "; write 1.0"),
        ("radius = 1/100", "; a case does not calculate"),
        ("friction = 0.1:0.3:5", "; a sweep is { start = .., stop = .., count = .. }"),
        ("radius = \u{201c}1 mm\u{201d}", "; write straight quotation marks, \"1 mm\""),
        ("fixed = True", "; write true"),
    ] {
        assert!(said(written).contains(meant), "{}", said(written));
    }
    let bare = said("radius = 10 mm");
    assert!(bare.contains("; write \"10 mm\""), "{bare}");
    let word = said("law = coulomb # the default");
    assert!(word.contains("; write \"coulomb\""), "{word}");
}

#[test]
fn files_of_other_kinds_are_told() {
    for text in ["{ \"a\": 1 }", "<a b=\"1\"/>", "# mine\na:\n  b: 1", "x,y\n1,2\n", " 3 MODULE"] {
        let error = CaseKind::Hertz.check(text).unwrap_err().to_string();
        let advice = "; a case is written in TOML, `carom new hertz` prints one";
        assert!(error.ends_with(advice), "{text}: {error}");
    }
}

#[test]
fn new_cases_are_usual() {
    for kind in CaseKind::ALL {
        assert_eq!(kind.unusual(&kind.template()), [""; 0], "{kind:?}");
    }
}

#[test]
fn numbers_in_other_units_are_told_with_their_place() {
    let case = "[body_1]\nshape = \"sphere\"\nradius = 10\ndensity = 7.85\n\
                material = { young_modulus = 208, poisson = 0.3 }\n\
                [contact]\nfriction = 20\n[approach]\nspeed = 1\nangle = 0.785\n";
    let told = CaseKind::Impact.unusual(case);
    let fields: Vec<&str> =
        told.iter().map(|line| line.split('`').nth(1).unwrap_or_default()).collect();
    let expected = [
        "body_1.radius",
        "body_1.density",
        "body_1.material.young_modulus",
        "contact.friction",
        "approach.angle",
    ];
    let mut sorted = fields.clone();
    sorted.sort_unstable();
    let mut wanted = expected.to_vec();
    wanted.sort_unstable();
    assert_eq!(sorted, wanted);
    assert!(told.iter().any(|line| line.starts_with("line 4: `body_1.density` = 7.85 is unusual")));
}

#[test]
fn units_ranges_zero_and_no_slip_are_taken_as_meant() {
    let with = |line: &str| CaseKind::Impact.unusual(&format!("[approach]\n{line}\n"));
    for meant in [
        "angle = \"0.785 rad\"",
        "angle = 0",
        "angle = [0.5, 1, 2, 5]",
        "angle = { start = 0, stop = 85, count = 18 }",
    ] {
        assert!(with(meant).is_empty(), "{meant}");
    }
    assert_eq!(with("angle = { start = 0, stop = 1.5, count = 9 }").len(), 1);
    let friction = |f: &str| CaseKind::Impact.unusual(&format!("[contact]\nfriction = {f}\n"));
    assert!(friction("inf").is_empty() && friction("0").is_empty());
    assert_eq!(friction("[0.1, 0.2, 30]").len(), 0);
    assert_eq!(friction("30").len(), 1);
}
