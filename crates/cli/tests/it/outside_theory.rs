//! How far a result lies outside the theory: by the smallest radius of curvature, of a slender body too.

use carom_cases::case::CaseKind;

use crate::common::{carom, case, example, json, refusal, stdout};

/// Plain numbers that are probably in another unit are told in one line each; the case runs.
#[test]
fn unusual_numbers_are_told() {
    let text = std::fs::read_to_string(example("alumina_on_plane.toml")).unwrap();
    let with = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        let output =
            carom(&["impact", &case("unusual.toml", &text.replace(from, to)), "--format", "csv"]);
        assert!(output.status.success());
        String::from_utf8(output.stderr).unwrap().split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let told = with("friction = 0.092", "friction = 9.2");
    assert!(
        told.contains("`contact.friction` = 9.2 is unusual: most pairs have 0.05 to 1.5"),
        "{told}"
    );
    assert!(!with("friction = 0.092", "friction = 0.93").contains("unusual"));
}

/// A warning is an exit code with `--strict`; results and warning are written all the same.
#[test]
fn strict_turns_warnings_into_an_exit_code() {
    let text = std::fs::read_to_string(example("alumina_on_plane.toml")).unwrap();
    let unusual = case("strict_unusual.toml", &text.replace("friction = 0.092", "friction = 9.2"));
    let plain = example("hertz_roller.toml");
    for (arguments, code) in
        [(["impact", &unusual, "--format", "csv"], 3), (["hertz", &plain, "--format", "csv"], 0)]
    {
        let without = carom(&arguments);
        let strict = carom(&[&["--strict"], &arguments[..]].concat());
        assert_eq!((without.status.code(), strict.status.code()), (Some(0), Some(code)));
        assert_eq!((without.stdout, without.stderr), (strict.stdout, strict.stderr));
    }
    let wrong = carom(&["--strict", "impact", "no_such_file.toml"]);
    assert_eq!(wrong.status.code(), Some(1));
}

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
        let text = reason.as_str()?.strip_prefix("the approach exceeds")?;
        text.split_once("it is ")?.1.split(' ').next().unwrap().parse::<f64>().ok()
    });
    let told = told.unwrap_or_else(|| panic!("{reasons:?}"));
    assert!((told / share - 1.0).abs() < 6e-3, "{told} is not {share}");
}

/// A ball in a hollow of nearly its radius: the gap is flat, and the contact as large as the ball.
#[test]
fn a_contact_as_large_as_the_ball_is_told_though_its_approach_is_small() {
    const BODIES: &str = "\
[body_1]
radii = 0.005
material = { young_modulus = 2e11, poisson = 0.3 }
[body_2]
radii = -0.005001
material = { young_modulus = 2e11, poisson = 0.3 }
";
    let told = |kind: &str, rest: &str| {
        let file = case(&format!("hollow-{kind}.toml"), &format!("{BODIES}{rest}"));
        String::from_utf8(carom(&[kind, &file]).stderr).unwrap()
    };
    let loads = told("hertz", "[load]\nforce = [1e-4, 500]\n");
    let expected = "warning: large contact: a/R exceeds 0.1, beyond Hertz's theory: it is 0.881 (1 of 2 loads \
                    concerned, the worst at 500 N)\n";
    assert_eq!(loads, expected);
    // The smaller ball may be either body.
    let exchanged =
        BODIES.replace("0.005\n", "X").replace("-0.005001", "0.005").replace('X', "0.1\n");
    let file = case("hollow-exchanged.toml", &format!("{exchanged}[load]\nsemi_axis_a = 0.001\n"));
    let small = String::from_utf8(carom(&["hertz", &file]).stderr).unwrap();
    assert_eq!(
        small,
        "warning: large contact: a/R exceeds 0.1, beyond Hertz's theory: it is 0.2\n"
    );
    let contact = "[contact]\nfriction = 0.3\n";
    // a/R at the approach .775 um.
    let steps = told("history", &format!("{contact}[history]\nsteps = [[7.75e-7, 0, 0]]\n"));
    let large = |value: &str| {
        format!("warning: large contact: a/R exceeds 0.1, beyond Hertz's theory: it is {value}\n")
    };
    assert!(steps.starts_with(&large("0.88")), "{steps}");
    let load = "[load]\nforce = 500\nforce_x = 0\nforce_y = 0\n";
    let points = "[points]\ninside = \"body 1\"\nx = 0\ny = 0\ndepth = 1e-3\n";
    let stress = told("stress", &format!("{contact}{load}{points}"));
    assert!(stress.starts_with(&large("0.881")), "{stress}");
}

/// Of unlike materials under friction, and told once for all steps, since it is the same in each.
#[test]
fn a_history_tells_of_the_coupling_that_it_leaves_out() {
    let told = |poisson: &str, friction: &str| {
        let text = format!(
            "[body_1]\nradii = 0.01\nmaterial = {{ young_modulus = 2e11, poisson = 0.3 }}\n\
             [body_2]\nradii = inf\nmaterial = {{ young_modulus = 2e11, poisson = {poisson} }}\n\
             [contact]\nfriction = {friction}\n[history]\nsteps = [[1e-7, 0, 0], [2e-7, 1e-8, 0]]\n"
        );
        let name = format!("coupled-{poisson}-{}.toml", friction.len());
        String::from_utf8(carom(&["history", &case(&name, &text)]).stderr).unwrap()
    };
    // (15.2): half of ((1 - 2 nu)/G against (1 - 2 nu)/G) over the sum of (1 - nu)/G, G = E/(2 (1 + nu)).
    let gamma: f64 = 0.5 * (1.0 - 0.4 * 1.3) / (1.0 + 0.7 * 1.3);
    let over = (gamma / 0.2).powi(2);
    let bound = over / (4.0 + over) + gamma * gamma;
    let expected = format!(
        "warning: dissimilar materials: the coupling of normal and tangential displacements is neglected: R_x \
         of an impact changes by up to {bound:.3}\n"
    );
    assert_eq!(told("0", "0.2"), expected);
    // Once it slides, kinetic friction counts.
    assert_eq!(told("0", "0.2\nstatic_friction = 0.4\nlaw = \"fixed-direction\""), expected);
    assert_eq!([told("0.3", "0.2"), told("0", "0")], ["", ""]);
}

/// Of an ellipse the longer semi-axis is compared with the bodies, wherever the load is given.
#[test]
fn a_long_ellipse_is_judged_by_its_length() {
    const BODIES: &str = "\
[body_1]
radii = [0.01, 0.8]
material = { young_modulus = 2e11, poisson = 0.3 }
[body_2]
radii = inf
material = { young_modulus = 2e11, poisson = 0.3 }
";
    let step = "[contact]\nfriction = 0.3\n[history]\nsteps = [[2e-6, 0, 0]]\n";
    let file = case("long-ellipse.toml", &format!("{BODIES}{step}"));
    let row = json(&["history", &file])[0].clone();
    let [a, b] = ["semi_axis_a", "semi_axis_b"].map(|name| row[name].as_f64().unwrap());
    assert!(a < 0.1 * 0.01 && b > 0.1 * 0.01, "{a} {b}");
    let expected = format!("a/R exceeds 0.1, beyond Hertz's theory: it is {:.3}", b / 0.01);
    let told = String::from_utf8(carom(&["history", &file]).stderr).unwrap();
    assert!(told.contains(&expected), "{told} {expected}");
}

/// The first case of each kind, of a steel that yields at a touch, or as fast as a bullet.
#[test]
fn every_kind_of_case_tells_where_it_leaves_the_theory() {
    for kind in CaseKind::ALL.map(|kind| kind.name) {
        let new = stdout(&["new", kind]);
        let lines = new.lines().filter(|line| !line.starts_with("yield_stress"));
        let text = lines.collect::<Vec<_>>().join("\n");
        let text = text
            .replace("young_modulus = 208e9", "hardness = 1e5\nyoung_modulus = 208e9")
            .replace("velocity = [0.25, 0, -0.5]", "velocity = [0.25, 0, -200]");
        let output = carom(&[kind, &case(&format!("outside-{kind}.toml"), &text)]);
        let told = [output.stdout, output.stderr].concat();
        let told = String::from_utf8(told).unwrap();
        // No contact: its warnings are on folds and strains.
        let is_told = told.contains("yields: ") || told.contains("OUTSIDE THE THEORY");
        assert_eq!(is_told, kind != CaseKind::Shell.name, "{kind}: {told}");
    }
}

/// A roller pressed to half of its radius, and a surface pressed as a fifth of E*.
#[test]
fn a_gap_as_steep_as_a_large_contact_is_told() {
    const BODIES: &str = "\
[body_1]
material = { young_modulus = 1e9, poisson = 0.5 }
[body_2]
material = { rigid = true }
[contact]
friction = 0.3
[grid]
size = [0.012, 0.012]
cells = [48, 48]
[gap]
shape = \"paraboloid\"
radii = [0.03, 0.03]
";
    let told = |kind: &str, rest: &str| {
        let file = case(&format!("steep-{kind}.toml"), &format!("{BODIES}{rest}"));
        String::from_utf8(carom(&[kind, &file]).stderr).unwrap()
    };
    // a/R = sqrt(zeta/R); E* = 1.33 GPa.
    for (steps, rolling, large) in [("2.9e-4", "1400", false), ("3.2e-4", "1800", true)] {
        let solve = told("solve", &format!("[[step]]\nzeta = {steps}\n"));
        let roll =
            told("roll", &format!("[rolling]\nspeed = 1\nF_z = {rolling}\ncreepage = 1e-3\n"));
        for text in [solve, roll] {
            assert_eq!(text.contains("exceeds .064 E*"), large, "{text}");
        }
    }
}

/// What of the facade's prelude loads a contact, and what of it tells how far that is from the limits of the theory.
const FACADE: [(&str, &str); 31] = [
    ("Attitude", ""),
    ("Inertia", ""),
    ("Surface", ""),
    ("Force", ""),
    ("Grid", ""),
    ("Material", ""),
    ("MaterialPair", ""),
    ("Point", ""),
    ("PointLoad", ""),
    ("Groups", ""),
    ("ObliqueImpact", ""),
    ("Regime", ""),
    ("Body", ""),
    ("Collision", "Rebound::warnings"),
    ("Motion", ""),
    ("Outcome", "Rebound::warnings"),
    ("Rebound", "Rebound::warnings"),
    ("Accounted", "Validity::of_hertz"),
    ("PrincipalRadii", ""),
    ("RelativeCurvature", ""),
    ("ContactEllipse", ""),
    ("Friction", ""),
    ("Hertz", "Validity::of_hertz"),
    ("ContactLaw", "Validity::of_hertz"),
    ("ContactLoad", ""),
    ("Energies", ""),
    ("Shift", ""),
    ("ShiftLaw", "Validity::of_hertz"),
    ("ContactStiffness", ""),
    ("Frictional", "PressureLimits::validity"),
    ("Method", "PressureLimits::validity"),
];
/// Functions, states and errors beside them.
const BESIDE: [&str; 9] = [
    "CellState",
    "ContactProblem",
    "ContactState",
    "Drive",
    "Driven",
    "Gap",
    "complete",
    "AxisRatio",
    "RangeError",
];

/// A new name of the prelude is asked here whether it loads a contact; that what tells exists, the compiler says.
#[test]
fn every_name_of_the_facade_is_known_to_load_a_contact_or_not() {
    use carom::laws::validity::{PressureLimits, Validity};
    let _ = (Validity::of_hertz, PressureLimits::validity, |rebound: &carom::impact::Rebound| {
        rebound.warnings.len()
    });
    let source = include_str!("../../../carom/src/lib.rs");
    let prelude = source.split("pub mod prelude {").nth(1).unwrap();
    let names = prelude.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
    let is_name = |name: &&str| name.starts_with(char::is_uppercase) || *name == "complete";
    let mut found: Vec<&str> = names.filter(is_name).collect();
    let mut known: Vec<&str> = FACADE.iter().map(|(name, _)| *name).chain(BESIDE).collect();
    found.sort_unstable();
    known.sort_unstable();
    assert_eq!(found, known);
}

/// A window so small that its numbers vanish is bad input, not a fault of a file.
#[test]
fn numbers_too_extreme_to_compute_with_are_bad_input() {
    let text = std::fs::read_to_string(example("solve_hertz.toml")).unwrap();
    let text = text.replace("[\"5 mm\", \"5 mm\"]", "[1e-154, 1e-154]");
    let text = text.replace("F_z = \"4 N\"", "zeta = 1e-5");
    refusal(&["solve", &case("extreme.toml", &text)]);
}
