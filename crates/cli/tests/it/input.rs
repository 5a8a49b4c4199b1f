//! Input of the command: units, misspelt cases, files that are not cases, and results that are not finite.

use crate::common::{carom, case, example, folder, json, refusal, stdout, without_progress};
use std::process::Output;

fn changed(name: &str, changes: &[(&str, &str)]) -> String {
    let mut text = std::fs::read_to_string(example(name)).unwrap();
    for (old, new) in changes {
        assert!(text.contains(old), "{old}");
        text = text.replace(old, new);
    }
    text
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn impact(name: &str, text: &str, more: &[&str]) -> Output {
    carom(&[&["impact", &case(name, text)][..], more].concat())
}

const PLAIN: &str = r#"[body_1]
shape = "ellipsoid"
semi_axes = [0.03, 0.02, 0.015]
material = { young_modulus = 70e9, poisson = 0.22 }
mass = 0.1
inertia = [1.2e-5, 2.2e-5, 2.6e-5]
angles = [0, 0, 30]
position = [0, 0, 0.015]
velocity = [0.5, 0.4, -2]
spin = [0, 0, 0]

[body_2]
shape = "plane"
material = { shear_modulus = 30e9, poisson = 0.22 }
fixed = true

[contact]
friction = 0.2
"#;

const WITH_UNITS: &str = r#"[body_1]
shape = "ellipsoid"
semi_axes = ["30 mm", "2 cm", 0.015]
material = { young_modulus = "70 GPa", poisson = 0.22 }
mass = "100 g"
inertia = ["120 g cm2", "22 kg mm²", 2.6e-5]
angles = [0, 0, "30 deg"]
position = ["0 m", 0, "15000 um"]
velocity = ["50 cm/s", 0.4, "-2 m/s"]
spin = [0, 0, "0 rpm"]

[body_2]
shape = "plane"
material = { shear_modulus = "30e3 MPa", poisson = 0.22 }
fixed = true

[contact]
friction = 0.2
"#;

#[test]
fn texts_with_units_give_the_same_bits_as_plain_numbers() {
    let plain = impact("plain-units.toml", PLAIN, &["--format", "json"]);
    let units = impact("with-units.toml", WITH_UNITS, &["--format", "json"]);
    assert!(plain.status.success(), "{}", text(&plain.stderr));
    assert_eq!(text(&plain.stdout), text(&units.stdout));
    // In every kind of case.
    let hertz = |changes: &[(&str, &str)]| {
        json(&[
            "hertz",
            &case("unit-hertz.toml", &changed("hertz_crossed_cylinders.toml", changes)),
        ])
    };
    let changes = [("[0.02, inf]", "[\"20 mm\", \"inf m\"]"), ("208e9", "\"208 kN/mm²\"")];
    assert_eq!(hertz(&changes), hertz(&[]));
    let force = [("[1, 10, 100, 1000]", "{ start = \"1 N\", stop = \"1 kN\", count = 3 }")];
    assert_eq!(hertz(&force)["loads"][2], hertz(&[])["loads"][3]);
    let history = |changes: &[(&str, &str)]| {
        json(&["history", &case("unit-history.toml", &changed("history_loop.toml", changes))])
    };
    let rows = [
        ("[1.0e-6, 1.0e-7, 0.0]", "[\"1 um\", \"100 nm\", \"0 m\"]"),
        ("angle = 0", "angle = \"0°\""),
    ];
    assert_eq!(history(&rows), history(&[]));
    let scene = |changes: &[(&str, &str)]| {
        json(&["scene", &case("unit-scene.toml", &changed("scene_superball.toml", changes))])
    };
    let ball = [
        ("time = 4", "time = \"4000 ms\""),
        ("-9.81]", "\"-9.81 m/s²\"]"),
        ("radius = 0.025", "radius = \"2.5 cm\""),
    ];
    assert_eq!(scene(&ball), scene(&[]));
    let glass = |changes: &[(&str, &str)]| {
        let text =
            changed("glass_scatter.toml", changes).replace("samples = 10000", "samples = 20");
        json(&["impact", &case("unit-glass.toml", &text)])
    };
    let spread = [
        ("mean = 1.5e-3, sd = 1e-5", "mean = \"1.5 mm\", sd = \"10 um\""),
        ("low = 25, ", "low = \"25 deg\", "),
    ];
    assert_eq!(glass(&spread), glass(&[]));
}

#[test]
fn wrong_units_name_the_allowed_ones() {
    for (old, new, expected) in [
        (
            "\"100 g\"",
            "\"100 mm\"",
            "line 5: `body_1.mass` = \"100 mm\" is not allowed: must be a number, > 0 (inf is allowed), plain in kg or as a text with a unit of kg, t, g, mg, ug",
        ),
        (
            "\"30 mm\"",
            "\"30\"",
            "line 3: `body_1.semi_axes.x` = \"30\" is not allowed: must be a number, finite and > 0, plain in m or",
        ),
        (
            "\"30 mm\"",
            "\"-30 mm\"",
            "line 3: `body_1.semi_axes.x` = \"-30 mm\" is not allowed: must be finite and > 0",
        ),
        ("\"70 GPa\"", "\"70 Gpa\"", "a unit of Pa, kPa, MPa, GPa, TPa, bar, N/m2, N/mm2, kN/mm2"),
        (
            "\"0 rpm\"",
            "\"0 Hz\"",
            "line 10: `body_1.spin.z` = \"0 Hz\" is not allowed: must be a number, finite, within +-1e100, plain in rad/s",
        ),
        (
            "friction = 0.2",
            "friction = \"20 %\"",
            "line 18: `contact.friction` = \"20 %\" is not allowed: must be a number, >= 0 (0, 1e-30 to 1e30, or inf: no slip)",
        ),
        (
            "poisson = 0.22 }\nmass",
            "poisson = \"0.22\" }\nmass",
            "line 4: `body_1.material.poisson` = \"0.22\" is not allowed: must be a number, in (-1, 0.5]",
        ),
        ("\"30 deg\"", "\"30 degrees\"", "plain in deg or as a text with a unit of deg, rad, rev"),
    ] {
        assert!(WITH_UNITS.contains(old), "{old}");
        let wrong = case("wrong-unit.toml", &WITH_UNITS.replacen(old, new, 1));
        let stderr = refusal(&["impact", &wrong]);
        assert!(stderr.contains(expected), "{stderr}");
    }
    let long = format!("\"{}\"", "1".repeat(900_000));
    let long = case("long-value.toml", &WITH_UNITS.replacen("\"100 g\"", &long, 1));
    let stderr = refusal(&["impact", &long]);
    assert!(stderr.len() < 1000, "{}", stderr.len());
}

#[test]
fn a_mistyped_shape_of_a_sweep_is_blamed_itself() {
    for (name, old) in [
        ("alumina_on_plane.toml", "\"sphere\""),
        ("alumina_on_plane.toml", "\"plane\""),
        ("glass_scatter.toml", "\"sphere\""),
        ("steel_balls.toml", "\"sphere\""),
        ("ellipsoid_on_plane.toml", "\"ellipsoid\""),
        ("ellipsoid_on_plane.toml", "\"plane\""),
    ] {
        let wrong = case("spere.toml", &changed(name, &[(old, "\"spere\"")]));
        let stderr = refusal(&["impact", &wrong]);
        assert!(
            stderr.contains(".shape` = \"spere\" is not allowed: must be \"sphere\", \"ell"),
            "{name}: {stderr}"
        );
        assert!(!stderr.contains("approach"), "{stderr}");
    }
}

#[test]
fn what_is_no_text_of_an_allowed_size_ends_with_code_2() {
    let folder = folder();
    let write = |name: &str, bytes: &[u8]| {
        let path = folder.join(name);
        std::fs::write(&path, bytes).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let history = std::fs::read_to_string(example("history_twist.toml")).unwrap();
    let table = |name: &str, bytes: &[u8]| {
        write(name, bytes);
        write(&format!("{name}.toml"), history.replace("history_twist.csv", name).as_bytes())
    };
    let mut files = vec![
        (
            "impact",
            write("binary.toml", &[0x7f, b'E', b'L', b'F', 0xff, 0]),
            "byte 5 is not UTF-8 text",
        ),
        ("hertz", write("latin.toml", b"# \xb5m"), "byte 3 is not UTF-8 text"),
        ("scene", write("nul.toml", b"a = 1\0"), "line 1"),
        ("impact", write("large.toml", &vec![b'#'; (1 << 20) + 1]), "a text file of at most 1 MiB"),
        (
            "history",
            table("binary.csv", b"zeta,xi,eta\n\xfe\xff"),
            "binary.csv: byte 13 is not UTF-8",
        ),
        (
            "history",
            table("large.csv", &vec![b'\n'; (64 << 20) + 1]),
            "a text file of at most 64 MiB",
        ),
        (
            "impact",
            write("deep.toml", format!("a={}", "[".repeat(100_000)).as_bytes()),
            "recursion",
        ),
    ];
    if cfg!(unix) {
        files.push(("impact", "/dev/zero".to_owned(), "this is a device"));
        files.push((
            "history",
            write("zero.toml", history.replace("history_twist.csv", "/dev/zero").as_bytes()),
            "/dev/zero: this is a device",
        ));
    }
    for (command, path, expected) in files {
        let stderr = refusal(&[command, &path]);
        assert!(stderr.contains(expected), "{path}: {stderr}");
    }
}

#[test]
fn bodies_that_part_are_told_first() {
    let text = std::fs::read_to_string(example("steel_balls.toml")).unwrap();
    let parting = text
        .lines()
        .map(|line| if line.starts_with("velocity") { "velocity = [0, 0, 0]" } else { line })
        .collect::<Vec<_>>()
        .join("\n");
    let told = stdout(&["impact", &case("parting.toml", &parting)]);
    assert!(told.starts_with("no impact: the bodies do not approach each other\n"), "{told}");
}

#[test]
fn a_sweep_warns_once_of_each_kind() {
    let output = carom(&["impact", &example("alumina_on_plane.toml")]);
    let stderr = without_progress(&text(&output.stderr));
    assert_eq!(stderr.matches("elastic waves").count(), 1, "{stderr}");
    assert!(
        stderr.contains(
            "more than 1 % of the normal energy: about 2.32 % (15 of 17 angles concerned, the worst at 5°)"
        ),
        "{stderr}"
    );
    assert_eq!(stderr.lines().count(), 1, "{stderr}");
    let scene = carom(&["scene", &example("scene_superball.toml")]);
    let lines = text(&scene.stderr);
    assert_eq!(lines.matches("large contact").count(), 1, "{lines}");
}

#[test]
fn a_contact_that_yields_says_so_in_every_command() {
    const YIELDS: &str = "yields: the greatest pressure exceeds 1.6 times the yield stress";
    let soft = |name: &str| {
        let few =
            changed(name, &[]).replacen("material = { ", "material = { yield_stress = 1e3, ", 1);
        case(&format!("soft-{name}"), &few)
    };
    for (command, name) in [
        ("hertz", "hertz_crossed_cylinders.toml"),
        ("history", "history_loop.toml"),
        ("stress", "stress_ball.toml"),
        ("roll", "roll_wheel_on_rail.toml"),
        ("solve", "solve_hertz.toml"),
    ] {
        assert!(!text(&carom(&[command, &example(name)]).stderr).contains(YIELDS), "{name}");
        let stderr = carom(&[command, &soft(name)]).stderr;
        assert_eq!(text(&stderr).matches(YIELDS).count(), 1, "{name}: {}", text(&stderr));
    }
    // Two equal balls of hard steel at 2 m/s flow.
    let with = |strength: &str| {
        changed(
            "steel_balls.toml",
            &[("poisson = 0.3 }", &format!("poisson = 0.3, {strength} }}"))],
        )
    };
    let hard = with("yield_stress = 2.5e9");
    let stderr = carom(&["impact", &case("soft-balls", &hard)]).stderr;
    assert!(text(&stderr).contains(YIELDS), "{}", text(&stderr));
    let ball =
        changed("scene_golf_ball.toml", &[]).replacen("poisson", "hardness = 1e6, poisson", 1);
    let stderr = carom(&["scene", &case("soft-golf", &ball)]).stderr;
    assert!(text(&stderr).contains(YIELDS), "{}", text(&stderr));
    // The pressure of Hertz, 3 F/(2 pi a b), is exactly at its limit.
    let row = &json(&["hertz", &example("hertz_wheel_on_rail.toml")])["loads"][0];
    let peak = row["peak_pressure"].as_f64().unwrap();
    for (factor, count) in [(1.000_001, 0), (0.999_999, 1)] {
        let stress = format!("poisson = 0.3, hardness = {}}}", factor * 2.8 * peak / 1.6);
        let rail = changed("hertz_wheel_on_rail.toml", &[]).replace("poisson = 0.3 }", &stress);
        let stderr = carom(&["hertz", &case("at-yield", &rail)]).stderr;
        assert_eq!(text(&stderr).matches(YIELDS).count(), count, "{}", text(&stderr));
    }
    let both = with("yield_stress = 2.5e9, hardness = 7e9");
    let stderr = carom(&["impact", &case("both-strengths", &both)]).stderr;
    assert!(text(&stderr).contains("give one of the two"), "{}", text(&stderr));
}

#[test]
fn a_slip_of_units_is_said_first_and_plainly() {
    let slip = |name: &str, old: &str, new: &str| {
        let few = changed(name, &[(old, new)]).replace("samples = 10000", "samples = 20");
        case(&format!("slip-{name}"), &few)
    };
    let first = |output: &[u8]| {
        without_progress(&text(output)).lines().next().unwrap_or_default().to_owned()
    };
    for (command, file) in [
        ("impact", slip("alumina_on_plane.toml", "380e9", "380")),
        ("impact", slip("rubber_on_table.toml", "20e6", "20")),
        ("impact", slip("ellipsoid_on_plane.toml", "70e9", "70")),
        ("impact", slip("glass_scatter.toml", "70e9", "70")),
        ("hertz", slip("hertz_crossed_cylinders.toml", "208e9", "208")),
        ("history", slip("history_loop.toml", "[1.0e-6,", "[1.0,")),
        ("scene", slip("scene_superball.toml", "10e6", "10")),
    ] {
        let table = carom(&[command, &file]);
        assert!(table.status.success(), "{}", text(&table.stderr));
        let line = first(&table.stdout);
        assert!(line.starts_with("OUTSIDE THE THEORY"), "{file}: {line}");
        assert!(
            line.contains("the approach exceeds a tenth of the radius")
                && line.contains("Is a unit wrong?"),
            "{line}"
        );
        let csv = carom(&[command, &file, "--format", "csv"]);
        assert!(first(&csv.stderr).starts_with("warning: OUTSIDE THE THEORY"), "{file}");
        assert!(!text(&csv.stdout).contains("OUTSIDE"));
        let records = carom(&[command, &file, "--format", "json"]);
        let record: serde_json::Value = serde_json::from_slice(&records.stdout).unwrap();
        let record = record.as_array().map_or(&record, |records| &records[0]);
        let record = ["loads", "bounces"]
            .into_iter()
            .find_map(|name| record.get(name)?.get(0))
            .unwrap_or(record);
        assert!(record["outside_theory"][0].as_str().unwrap().contains("approach"), "{record}");
    }
    // What is right says nothing.
    let good = json(&["impact", &example("steel_balls.toml")]);
    assert_eq!(good["outside_theory"], serde_json::json!([]));
    assert!(!stdout(&["impact", &example("steel_balls.toml")]).contains("OUTSIDE"));
    // Waves take more than a tenth of this ball's energy, but no unit is wrong.
    let rough = stdout(&["impact", &example("rubber_on_table.toml")]);
    let line = rough.lines().next().unwrap();
    assert!(
        line.starts_with("OUTSIDE THE THEORY: elastic waves would carry away more than 10 % of the normal energy: about 15.9 %"),
        "{line}"
    );
    assert!(line.ends_with("The results are approximate."), "{line}");
}

/// A stranger's three riddles: the case without its command, the bodies in the other order, a negative approach.
#[test]
fn answers_that_look_empty_say_what_to_change() {
    let said = |arguments: &[&str]| {
        let output = carom(arguments);
        String::from_utf8_lossy(&output.stdout).into_owned()
            + &String::from_utf8_lossy(&output.stderr)
    };
    let steel = example("rubber_on_table.toml");
    assert!(said(&[&steel]).contains("is a case: `carom check"));
    let steel = "material = { young_modulus = 208e9, poisson = 0.3 }";
    let swapped = format!(
        "[body_1]\nshape = \"plane\"\nfixed = true\n{steel}\n[body_2]\nshape = \"sphere\"\nradius = 0.01\n\
         density = 7850\nvelocity = [0.1, 0, -1]\n{steel}\n[contact]\nfriction = 0.2\n"
    );
    let swapped = case("swapped.toml", &swapped);
    let told = said(&["impact", &swapped]);
    assert!(told.contains("exchange the bodies"), "{told}");
    let told = said(&["impact", &swapped, "--format", "csv"]);
    assert!(told.contains("warning: no impact") && told.contains("exchange the bodies"), "{told}");
    let hertz = std::fs::read_to_string(example("solve_hertz.toml")).unwrap();
    let step = "\n[[step]]\nzeta = -1e-6\n";
    let apart = case("apart.toml", &(hertz[..hertz.find("[[step]]").unwrap()].to_owned() + step));
    let told = said(&["solve", &apart]);
    assert!(told.contains("no contact in any step"), "{told}");
}

#[test]
fn what_is_no_case_is_told_with_what_was_expected() {
    let folder = folder();
    let told = |name: &str, bytes: Option<&[u8]>| {
        let path = folder.join(name);
        bytes.into_iter().for_each(|bytes| std::fs::write(&path, bytes).unwrap());
        text(&carom(&["roll", path.to_str().unwrap()]).stderr)
    };
    let contact = told("rail.inp", Some(b" 3 MODULE\n"));
    assert!(
        contact.contains("`carom new roll` prints one; .inp is an input of CONTACT"),
        "{contact}"
    );
    let program = told("case.py", Some(b"import carom\nx = 1\n"));
    assert!(program.contains("; a case ends in .toml, not in .py"), "{program}");
    let wide = told("wide.toml", Some(b"\xff\xfe#\0"));
    assert!(
        wide.contains("but UTF-16, as PowerShell writes it; it must be a case in TOML"),
        "{wide}"
    );
    for absent in [told("absent.toml", None), text(&carom(&["roll", "."]).stderr)] {
        assert!(
            absent.contains("; a case in TOML is expected there: `carom new` prints"),
            "{absent}"
        );
    }
}

#[test]
fn an_argument_that_does_not_exist_is_told_with_the_way_out() {
    let to_a_file = "results go to standard output: write `--format csv > results.csv`";
    for (line, expected) in [
        ("impact c.toml -o x.csv", to_a_file),
        ("impact c.toml --output x.csv", to_a_file),
        ("impact c.toml x.csv", to_a_file),
        ("impact c.toml --csv", "write --format csv"),
        ("restitution --kappa 1.2 1.3 --lambda 1", "a list with commas and no blanks: 1,1.2"),
        ("impact c.toml --history 0.5", "--history <COUNT> takes a whole number"),
    ] {
        let stderr = refusal(&line.split(' ').collect::<Vec<_>>());
        assert!(stderr.contains(expected) && !stderr.contains("as a value"), "{line}: {stderr}");
    }
}
