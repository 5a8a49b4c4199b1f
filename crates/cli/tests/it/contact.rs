//! `carom hertz` and `carom history` as a user meets them.

use crate::common::{carom, case, close, fresh, json, refusal, stdout};

const SPHERE: &str = "\
[body_1]
radii = 0.01
material = { shear_modulus = 80e9, poisson = 0.25 }

[body_2]
radii = [inf, inf]
material = { shear_modulus = 80e9, poisson = 0.25 }

[contact]
angle = 0
";

#[test]
fn hertz_gives_the_circle_of_a_sphere() {
    let text = SPHERE.to_owned() + "[load]\nforce = { start = 1, stop = 100, count = 3 }\n";
    let report = json(&["hertz", &case("sphere.toml", &text)]);
    close(&report["axis_ratio"], 1.0, 1e-15);
    for load in report["loads"].as_array().unwrap() {
        let number = |name: &str| load[name].as_f64().unwrap();
        // a^3 = 3 F R (1 - nu)/(8 G) with the combined G = 40 GPa, a^2 = R zeta.
        let (force, a) = (number("force"), number("semi_axis_a"));
        let cube = 3.0 * force * 0.01 * 0.75 / (8.0 * 40e9);
        assert!((a.powi(3) / cube - 1.0).abs() < 1e-13);
        assert!((a * a / (0.01 * number("approach")) - 1.0).abs() < 1e-13);
        let peak = 1.5 * force / (std::f64::consts::PI * a * a);
        assert!((number("peak_pressure") / peak - 1.0).abs() < 1e-13);
    }
}

fn history(name: &str, friction: &str, steps: &str) -> String {
    let contact = format!("angle = 0\nfriction = {friction}\n[history]\n{steps}\n");
    case(name, &SPHERE.replace("angle = 0\n", &contact))
}

#[test]
fn a_history_slides_at_the_friction_limit_and_remembers() {
    let steps = "steps = [[1e-6, 0, 0], [1e-6, 1e-5, 0], [1e-6, 9.9e-6, 0], [-1e-6, 0, 0]]";
    let case = history("slide.toml", "0.3", steps);
    let rows = json(&["history", &case, "--tractions", "11"]);
    let number = |row: usize, name: &str| rows[row][name].as_f64().unwrap();
    assert_eq!(rows[1]["regime"], "sliding");
    assert!((number(1, "F_x") / (0.3 * number(1, "F_z")) - 1.0).abs() < 1e-14);
    assert!(number(2, "F_x") < number(1, "F_x") && number(2, "stick_semi_axis_a") > 0.0);
    assert_eq!(rows[3]["regime"], "separated");
    assert_eq!(number(3, "F_x"), 0.0);
    // In gross sliding the traction is f times the pressure.
    let a = number(1, "semi_axis_a");
    let peak = 1.5 * number(1, "F_z") / (std::f64::consts::PI * a * a);
    let centre = rows[1]["tractions"][0]["t_x"].as_f64().unwrap();
    assert!((centre / (0.3 * peak) - 1.0).abs() < 1e-13);
}

#[test]
fn under_static_friction_the_force_drops_where_a_history_slides() {
    let steps = "steps = [[1e-6, 0, 0], [1e-6, 2.6e-7, 0], [1e-6, 2e-6, 0], [1e-6, 1.9e-6, 0]]";
    let told = |name: &str, friction: &str| {
        let case = history(name, &format!("{friction}\nlaw = \"fixed-direction\""), steps);
        json(&["history", &case, "--tractions", "11"])
    };
    let (dropping, strong, weak) = (
        told("dropping.toml", "0.2\nstatic_friction = 0.3"),
        told("strong.toml", "0.3"),
        told("weak.toml", "0.2"),
    );
    // Before it slides it is a contact with the larger coefficient, above the smaller one; afterwards one with the smaller.
    assert_eq!(dropping[1], strong[1]);
    let share = |row: usize| {
        dropping[row]["F_x"].as_f64().unwrap() / dropping[row]["F_z"].as_f64().unwrap()
    };
    assert!(share(1) > 0.25 && share(1) < 0.3, "{}", share(1));
    assert!((share(2) - 0.2).abs() < 1e-15);
    let same = |one: &serde_json::Value, two: &serde_json::Value| {
        let two = two.as_f64().unwrap();
        close(one, two, 1e-14 * two.abs());
    };
    assert_eq!(dropping[2]["regime"], "sliding");
    for (given, wanted) in [("t_x", "t_x"), ("limit", "limit"), ("t_x", "limit")] {
        let [mine, its] = [&dropping, &weak].map(|rows| rows[2]["tractions"].as_array().unwrap());
        mine.iter().zip(its).for_each(|(mine, its)| same(&mine[given], &its[wanted]));
    }
    // On the way back it sticks, and its limit is that of static friction again.
    assert!(dropping[3]["stick_semi_axis_a"].as_f64().unwrap() > 0.0);
    let limit = |rows: &serde_json::Value| rows[3]["tractions"][0]["limit"].clone();
    same(&limit(&dropping), &limit(&strong));
}

#[test]
fn static_friction_excludes_a_twist_and_a_smaller_coefficient() {
    let twisted = "steps = [[1e-6, 0, 0], [1e-6, 0, 0, 1e-3]]";
    let friction = "0.2\nstatic_friction = 0.3";
    let inline = history("twisted.toml", friction, twisted);
    let message = "`history.steps` = 0.001 is out of range: must be 0 as `omega` of all steps with `contact.static_friction`";
    for command in ["history", "check"] {
        assert!(refusal(&[command, &inline]).contains(message));
    }
    case("twisted.csv", "zeta,xi,eta,omega\n1e-6,0,0,0\n1e-6,0,0,1e-3\n");
    let file = history("twisted_file.toml", friction, "file = \"twisted.csv\"");
    for command in ["history", "check"] {
        let told = refusal(&[command, &file]);
        assert!(told.contains("twisted.csv: omega = 0.001 is out of range: must be 0"), "{told}");
    }
    let smaller = history("smaller.toml", "0.2\nstatic_friction = 0.1", twisted);
    let told = refusal(&["history", &smaller]);
    assert!(told.contains("`contact.static_friction` = 0.1 is out of range"), "{told}");
}

#[test]
fn steps_inline_and_in_a_file_are_the_same() {
    let inline = history("inline.toml", "0.3", "steps = [[1e-6, 0, 0], [2e-6, 1e-7, 3e-7, 1e-3]]");
    case("steps.csv", "eta,xi,zeta,omega\n0,0,1e-6,0\n3e-7,1e-7,2e-6,1e-3\n");
    let file = history("file.toml", "0.3", "file = \"steps.csv\"");
    assert_eq!(json(&["history", &inline]), json(&["history", &file]));
}

#[test]
fn bad_contacts_end_with_code_2() {
    for (command, text, expected) in [
        ("hertz", SPHERE.to_owned(), "`load` is missing"),
        (
            "hertz",
            SPHERE.to_owned() + "[load]\nforce = -1\n",
            "`load.force` = -1 is out of range: must be finite and > 0",
        ),
        (
            "hertz",
            SPHERE.to_owned() + "[load]\nforce = 1\napproach = 1e-6\n",
            "`load.approach` excludes `load.force`",
        ),
        (
            "hertz",
            SPHERE.replace("0.01", "0") + "[load]\nforce = 1\n",
            "`body_1.radii` = 0 is out of range: must be nonzero",
        ),
        (
            "hertz",
            SPHERE.replace("0.01", "[0.01, inf]") + "[load]\nforce = 1\n",
            "line 2: `body_1.radii`, `body_2.radii`: the surfaces touch along a line",
        ),
        (
            "history",
            SPHERE.to_owned() + "friction = 0.3\n[history]\nsteps = [[1, nan, 0]]\n",
            "`history.steps[0]` = NaN is out of range: must be finite",
        ),
        (
            "history",
            SPHERE.to_owned() + "friction = 0.3\n[history]\nsteps = [[1, 0]]\n",
            "`history.steps[0]` = [1, 0] is not allowed: must be a list of rows [zeta, xi, eta] or",
        ),
        (
            "history",
            SPHERE.to_owned() + "friction = 0.3\n[history]\nsteps = [[1, 0, 0], [1, 0, 0, inf]]\n",
            "line 13: `history.steps[1]` = inf is out of range: must be finite",
        ),
        (
            "history",
            SPHERE.to_owned() + "friction = 0.3\n[history]\nsteps = [[1, 0, 0, 0, 0]]\n",
            "`history.steps[0]` = [1, 0, 0, 0, 0] is not allowed: must be a list of rows",
        ),
        ("history", SPHERE.to_owned() + "friction = 0.3\n[history]\n", "`history.file` is missing"),
    ] {
        let case = case("bad-contact.toml", &text);
        let plot = fresh("bad-contact.svg");
        let stderr = refusal(&[command, &case, "--plot", plot.to_str().unwrap()]);
        assert!(stderr.contains(expected), "{stderr}");
        assert!(!plot.exists());
    }
}

/// Torque of the traction around the normal over the contact, by the trapezoidal rule.
fn torque_of_tractions(step: &serde_json::Value) -> f64 {
    let a = step["semi_axis_a"].as_f64().unwrap();
    let tractions = step["tractions"].as_array().unwrap();
    let length = a / (tractions.len() - 1) as f64;
    let part = |traction: &serde_json::Value| {
        let rho = a * traction["radius"].as_f64().unwrap();
        2.0 * std::f64::consts::PI * rho * rho * traction["t_twist"].as_f64().unwrap() * length
    };
    tractions.iter().map(part).sum()
}

#[test]
fn a_twist_turns_back_with_memory_and_slides_at_the_limit() {
    let steps = "steps = [[1e-6, 0, 0], [1e-6, 0, 0, 2e-3], [1e-6, 0, 0, -1e-3], \
                 [0.8e-6, 0, 0, -1e-3], [0.8e-6, 1e-8, 0, 1], [-1e-6, 0, 0, 1]]";
    let case = history("twist.toml", "0.3", steps);
    let rows = json(&["history", &case, "--tractions", "2001"]);
    let number = |row: usize, name: &str| rows[row][name].as_f64().unwrap();
    assert_eq!(number(0, "M_z"), 0.0);
    assert!(number(1, "M_z") > 0.0 && number(2, "M_z") < 0.0);
    for row in 1..5 {
        let (own, by_tractions) = (number(row, "M_z"), torque_of_tractions(&rows[row]));
        let limit = 3.0 * std::f64::consts::PI / 16.0
            * (0.3 * number(row, "F_z") * number(row, "semi_axis_a"));
        assert!((own - by_tractions).abs() < 1e-4 * limit, "{row}: {own} {by_tractions}");
        assert!(own.abs() <= limit * (1.0 + 1e-12));
        // Coulomb's bound at every radius.
        for traction in rows[row]["tractions"].as_array().unwrap() {
            let of = |name: &str| traction[name].as_f64().unwrap();
            let most = of("limit") + 1e-5 * rows[row]["tractions"][0]["limit"].as_f64().unwrap();
            assert!(of("t_twist").abs() <= most, "{traction}");
        }
    }
    let stick = number(1, "twist_stick_semi_axis_a") / number(1, "semi_axis_a");
    assert!(stick > 0.1 && stick < 0.99 && rows[1]["twist_regime"] == "slip");
    assert_eq!(rows[0]["twist_regime"], "adhesion");
    let slid =
        3.0 * std::f64::consts::PI / 16.0 * 0.3 * number(4, "F_z") * number(4, "semi_axis_a");
    assert!((number(4, "M_z") / slid - 1.0).abs() < 1e-12);
    assert_eq!(rows[4]["twist_regime"], "sliding");
    assert_eq!((&rows[5]["twist_regime"], number(5, "M_z")), (&"separated".into(), 0.0));
    let text = stdout(&["history", &case]);
    assert!(text.contains("twist_stick_semi_axis_b"));
    // Without a twist there is no torsion in the output.
    let plain = history("plain.toml", "0.3", "steps = [[1e-6, 0, 0, 0]]");
    assert!(!stdout(&["history", &plain]).contains("M_z"));
}

#[test]
fn twists_of_ellipses_and_with_shifts_carry_warnings() {
    let steps = "steps = [[1e-6, 0, 0], [1e-6, 2e-7, 1e-7, 2e-3]]";
    let file = history("both.toml", "0.3", steps);
    let text = std::fs::read_to_string(&file).unwrap();
    let stderr = |file: &str| {
        let output = carom(&["history", file, "--tractions", "5"]);
        assert!(output.status.success());
        String::from_utf8(output.stderr).unwrap()
    };
    assert!(stderr(&file).contains("shift and twist are computed independently"));
    // The mirror image turns the other way.
    let mirrored = case("mirrored.toml", &text.replace("1e-7, 2e-3", "-1e-7, -2e-3"));
    assert_eq!(stderr(&mirrored).replace("mirrored", "both"), stderr(&file));
    let ellipse = case("ellipse.toml", &text.replacen("radii = 0.01", "radii = [0.01, 0.03]", 1));
    assert!(stderr(&ellipse).contains("the contact is not circular"));
    let rows = json(&["history", &ellipse, "--tractions", "5"]);
    assert!(rows[1]["M_z"].as_f64().unwrap() > 0.0);
    assert!(rows[1]["tractions"][2].get("t_twist").is_none());
    // The stick area has the shape of the contact.
    let part = |axis: &str| {
        let [stick, whole] = [format!("twist_stick_{axis}"), axis.to_owned()];
        rows[1][stick].as_f64().unwrap() / rows[1][whole].as_f64().unwrap()
    };
    let [a, b] = ["semi_axis_a", "semi_axis_b"].map(part);
    assert!(a > 0.0 && a < 1.0 && (a - b).abs() < 1e-14, "{a} {b}");
    // Infinite friction sticks, none lets go.
    for (friction, regime) in [("inf", "adhesion"), ("0", "sliding")] {
        let case = history("limit.toml", friction, steps);
        let rows = json(&["history", &case]);
        assert_eq!(rows[1]["twist_regime"], regime);
        assert_eq!(rows[1]["M_z"].as_f64().unwrap() > 0.0, friction == "inf");
    }
}
