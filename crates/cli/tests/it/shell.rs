//! `carom shell`: bellows and flanges.

use crate::common::{carom, case, close, example, json, refusal, stdout};
use serde_json::Value;
use std::f64::consts::PI;

/// A straight tube of E = 1, R = 10, t = 0.1, each length 3, five of them.
fn tube(load: &str) -> String {
    format!(
        "[bellows]\nshape = \"sine\"\nmean_radius = 10\namplitude = 0\npitch = 3\nthickness = 0.1\n\
         corrugations = 5\nharmonics = 8\nmaterial = {{ young_modulus = 1, poisson = 0.3 }}\n\
         [bellows.load]\n{load}\n"
    )
}

fn solved(name: &str, text: &str) -> Value {
    json(&["shell", &case(name, text)])
}

/// Delta = F L/(2 pi R E t); under pressure with closed ends it lengthens by p R (1/2 - nu) L/(E t) and
/// widens by p R^2 (1 - nu/2)/(E t).
#[test]
fn a_straight_tube_stretches_as_a_rod_and_widens_as_a_boiler() {
    let rate = 2.0 * PI * 10.0 * 0.1 / 15.0;
    let found = solved("rod.toml", &tube("force = [1e-4, -2e-4]"));
    close(&found["spring_rate"], rate, 1e-12 * rate);
    close(&found["length"], 15.0, 1e-12);
    for (row, force) in [(0, 1e-4), (1, -2e-4)] {
        // Large rotation theory: to the second order in the strain.
        close(&found["loads"][row]["dilatation"], force / rate, 1e-4 * (force / rate).abs());
        close(&found["loads"][row]["force"], force, 1e-15);
        close(&found["loads"][row]["maximal_meridional_stress"], force.abs() / (2.0 * PI), 1e-8);
    }
    let pressure = 1e-6;
    let found = solved("boiler.toml", &tube(&format!("pressure = {pressure}\nforce = 0")));
    let widening = pressure * 100.0 * 0.85 / 0.1;
    for place in found["places"].as_array().unwrap() {
        close(&place["radial_displacement"], widening, 1e-3 * widening);
        close(&place["hoop_membrane"], pressure * 100.0, 1e-3 * pressure * 100.0);
        close(&place["meridional_membrane"], pressure * 50.0, 1e-3 * pressure * 50.0);
    }
    let longer = 15.0 * pressure * 100.0 * (0.5 - 0.3);
    close(&found["loads"][0]["dilatation"], longer, 1e-3 * longer);
}

/// Lorenz and Timoshenko: 2 pi E t^2/sqrt(3 (1 - nu^2)).
#[test]
fn a_limit_point_is_named_and_the_loads_after_it_are_followed() {
    let text = "[bellows]\nshape = \"sine\"\nmean_radius = 10\namplitude = 1e-4\npitch = 3.44\n\
                thickness = 0.1\nharmonics = 16\nmaterial = { young_modulus = 1, poisson = 0.3 }\n\
                [bellows.load]\nforce = [-0.02, -0.08, 0.01]\n";
    let path = case("limit.toml", text);
    let found = json(&["shell", &path]);
    let classical = -2.0 * PI * 0.01 / (3.0_f64 * 0.91).sqrt();
    close(&found["loads"][1]["force"], classical, 0.015 * classical.abs());
    assert_eq!(found["loads"][1]["end"], "limit of the force");
    assert_eq!(found["loads"][2]["end"], "reached");
    close(&found["loads"][2]["force"], 0.01, 1e-12);
    let output = carom(&["shell", &path]);
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(
        said.contains("a limit point comes before the load") && said.contains("(1 of 3 loads)")
    );
}

/// The same bellows as six, and as one in millimetres and newtons.
#[test]
fn corrugations_in_a_row_and_other_units() {
    let six = std::fs::read_to_string(example("shell_bellows.toml")).unwrap();
    let one = six.replace("corrugations = 6", "corrugations = 1").replace("12 mm", "2 mm");
    let (six, one) = (solved("six.toml", &six), solved("one.toml", &one));
    for (a, b) in six["loads"].as_array().unwrap().iter().zip(one["loads"].as_array().unwrap()) {
        let number = |value: &Value| value.as_f64().unwrap();
        close(&a["force"], number(&b["force"]), 1e-9 * number(&b["force"]).abs());
        for name in ["dilatation", "stored_energy", "volume"] {
            close(&a[name], 6.0 * number(&b[name]), 1e-9 * number(&a[name]).abs());
        }
        close(&a["spring_rate"], number(&b["spring_rate"]) / 6.0, 1e-9 * number(&a["spring_rate"]));
    }
}

/// A stress made of those along the meridian and around it.
type Kind = fn(f64, f64) -> f64;

/// The greatest stresses are those of both faces; under this pressure and elongation the inner face has them.
#[test]
fn greatest_stresses_are_those_of_the_face_that_has_them() {
    let text = std::fs::read_to_string(example("shell_bellows.toml")).unwrap();
    let head = text.split("dilatation").next().unwrap();
    let load = "pressure = \"8 bar\"\ndilatation = \"12 mm\"\n";
    let found = solved("faces.toml", &format!("{head}{load}"));
    let face = |side: f64, of: Kind| {
        let at = |place: &Value| {
            let stress = |name: &str| {
                let of = |part: &str| place[format!("{name}_{part}")].as_f64().unwrap();
                of("membrane") + side * of("bending")
            };
            of(stress("meridional"), stress("hoop"))
        };
        found["places"].as_array().unwrap().iter().map(at).fold(0.0, f64::max)
    };
    let kinds: [(&str, Kind); 3] = [
        ("meridional", |along, _| along.abs()),
        ("hoop", |_, hoop| hoop.abs()),
        ("equivalent", |s, t| (s * s - s * t + t * t).sqrt()),
    ];
    for (name, of) in kinds {
        let (outer, inner) = (face(1.0, of), face(-1.0, of));
        let told = &found["loads"][0][format!("maximal_{name}_stress")];
        close(told, outer.max(inner), 1e-9 * outer);
        if name == "meridional" {
            assert!(inner > 1.02 * outer, "{inner} {outer}");
        }
    }
}

/// A thin ring of stiffness EI = 1 and radius 2 under two forces P = 3 outward (Timoshenko).
#[test]
fn a_bare_ring_opens_as_timoshenkos() {
    let text = "[flange]\nradius = 2\n\
                stiffness = { stretching = 1e7, in_plane = 1, out_of_plane = 1, torsion = 1 }\n\
                places = 8\n\
                [[flange.force]]\nradial = 3\n[[flange.force]]\nangle = 180\nradial = 3\n";
    let path = case("ring.toml", text);
    let found = json(&["shell", &path]);
    let unit = 3.0 * 8.0;
    close(&found["stored_energy"], 0.5 * 3.0 * unit * (0.25 * PI - 2.0 / PI), 1e-4);
    let places = found["places"].as_array().unwrap();
    assert_eq!(places.len(), 8);
    close(&places[1]["angle"], 45.0, 1e-12);
    close(&places[0]["radial"], 0.5 * unit * (0.25 * PI - 2.0 / PI), 1e-4);
    close(&places[2]["radial"], -0.5 * unit * (2.0 / PI - 0.5), 1e-4);
    close(&places[0]["in_plane"], 6.0 / PI, 1e-8);
    close(&places[2]["in_plane"], 6.0 * (1.0 / PI - 0.5), 1e-8);
    close(&places[2]["stretching"], 1.5, 1e-8);
    let csv = stdout(&["shell", &path, "--places", "--format", "csv"]);
    assert_eq!(
        csv.lines().next(),
        Some("angle,radial,tangential,axial,rotation,stretching,in_plane,out_of_plane,torsion")
    );
    assert_eq!(csv.lines().count(), 9);
}

#[test]
fn bolt_holes_and_a_thin_wall_are_read_where_they_are() {
    let pinched = std::fs::read_to_string(example("shell_flange_pinched.toml")).unwrap();
    let energy = |text: &str| solved("flange.toml", text)["stored_energy"].as_f64().unwrap();
    let whole = energy(&pinched.replace("factor = 0.5", "factor = 1"));
    // Holes soften, each of the four stiffnesses on its own less than all together.
    let holed = energy(&pinched);
    let bending = energy(&pinched.replace("factor = 0.5", "factor = 0.5\nof = \"in_plane\""));
    assert!(whole < bending && bending < holed && holed < 1.2 * whole, "{whole} {bending} {holed}");
    let alone = pinched.split("[flange.tube]").next().unwrap().to_owned()
        + "[[flange.force]]\nangle = 0\nradial = \"10 kN\"\n[[flange.force]]\nangle = 180\n\
           radial = \"10 kN\"\n";
    assert!(energy(&alone) > 1.05 * holed);
    // The force of a clamp beside the centroid line turns the section.
    let pried = std::fs::read_to_string(example("shell_flange_pried.toml")).unwrap();
    let turn = |text: &str| solved("pried.toml", text)["places"][0]["rotation"].as_f64().unwrap();
    let straight = turn(&pried.replace("arm = \"5 mm\"", "arm = 0"));
    assert!(turn(&pried) > straight, "{straight}");
}

/// Outward and inward, a pried flange has six different greatest values.
#[test]
fn greatest_values_of_a_flange_are_those_of_its_places() {
    let pried = std::fs::read_to_string(example("shell_flange_pried.toml")).unwrap();
    let found = solved("greatest.toml", &pried);
    let places = found["places"].as_array().unwrap();
    for name in ["radial", "axial", "rotation", "in_plane", "out_of_plane", "torsion"] {
        let values = places.iter().map(|place| place[name].as_f64().unwrap().abs());
        let greatest = values.fold(0.0, f64::max);
        assert!(greatest > 0.0);
        assert_eq!(found[format!("maximal_{name}")], greatest, "{name}");
    }
}

#[test]
fn prying_by_the_half_momentless_theory_is_warned_of() {
    let pried = std::fs::read_to_string(example("shell_flange_pried.toml")).unwrap();
    let said = |text: &str| {
        let output = carom(&["shell", &case("pried.toml", text), "--format", "csv"]);
        assert!(output.status.success());
        String::from_utf8(output.stderr).unwrap()
    };
    assert_eq!(said(&pried), "");
    let half = said(&pried.replace("koiter-sanders", "half-momentless"));
    assert!(
        half.contains("`flange.tube.theory` = \"koiter-sanders\" is the whole shell"),
        "{half}"
    );
}

#[test]
fn what_is_wrong_is_named_with_its_value_and_range() {
    let bellows = std::fs::read_to_string(example("shell_bellows.toml")).unwrap();
    let flange = std::fs::read_to_string(example("shell_flange_pinched.toml")).unwrap();
    let edit = |text: &str, from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    };
    for (text, told) in [
        (
            edit(&bellows, "arc = \"3 mm\"", "arc = \"0.3 mm\""),
            "`bellows.thickness` = 0.0005 is out of range: must be at most the least radius of \
             curvature of the meridian",
        ),
        (
            edit(&bellows, "arc = \"3 mm\"", "arc = \"55 mm\""),
            "`bellows.arc` = 0.055 is out of range: must be such that the height",
        ),
        (
            edit(&bellows, "shape = \"u-shaped\"", "shape = \"folded\"\nturn = 150"),
            "`bellows.straight` = 0.008 is out of range: must be so short that the meridian does not \
             cut itself",
        ),
        (
            edit(&bellows, "0.5 mm", "20 mm"),
            "`bellows.thickness` = 0.02 is out of range: must be from 1e-7 to 0.2 of the least radius",
        ),
        (edit(&bellows, "u-shaped", "ushaped"), "did you mean \"u-shaped\"?"),
        (edit(&bellows, "poisson = 0.3", "poisson = -0.3"), "must be from 0 to 0.5"),
        (
            edit(&bellows, "{ young_modulus = \"195 GPa\", poisson = 0.3 }", "{ rigid = true }"),
            "elastic",
        ),
        (edit(&bellows, "dilatation =", "force = 1\ndilatation ="), "give one of the two"),
        (
            edit(&bellows, "dilatation =", "pressure = [1, 2]\ndilatation ="),
            "`bellows.load.pressure` excludes `bellows.load.dilatation`: both must have the same number",
        ),
        (
            edit(&flange, "half_width = 3.4", "half_width = 50"),
            "`flange.sector[1].angle` = 67.5 is out of range: must be so that no two sectors of a \
             stiffness overlap",
        ),
        (
            edit(&flange, "outward = \"15 mm\"", "outward = \"120 mm\""),
            "`flange.section.outward` = 0.12 is out of range: must be at most 0.69 times the radius",
        ),
        (
            edit(&flange, "thickness = \"3 mm\"", "thickness = \"3 mm\"\nradius = \"100 mm\""),
            "`flange.tube.radius` = 0.1 is out of range",
        ),
        (
            edit(&flange, "thickness = \"3 mm\"", "thickness = \"40 mm\""),
            "`flange.tube.thickness` = 0.04 is out of range: must be from 1e-6 to 0.2 of the radius",
        ),
        (
            edit(&flange, "thickness = \"3 mm\"", "thickness = \"3 mm\"\nlength = \"20 mm\""),
            "`flange.tube.length` = 0.02 is out of range",
        ),
        (
            edit(&flange, "[flange]", "[bellows]\nshape = \"torus\"\n[flange]"),
            "`flange` excludes `bellows`: a case has one of them",
        ),
        (flange.replace("radial = \"10 kN\"", ""), "`flange.force[0].radial` is missing"),
    ] {
        let said = refusal(&["shell", &case("wrong.toml", &text)]);
        let unfolded = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(unfolded.contains(told), "{told}\n{said}");
    }
}

/// Steel folds that are stretched step by step until the equivalent stress passes .02 E.
#[test]
fn large_strains_are_told_from_two_percent_of_youngs_modulus_on() {
    let text = std::fs::read_to_string(example("shell_bellows.toml")).unwrap();
    let range = "{ start = \"-12 mm\", stop = \"12 mm\", count = 9 }";
    assert!(text.contains(range));
    let mut told_of = [0, 0];
    for millimetres in 40..50 {
        let case = case("strained.toml", &text.replace(range, &format!("\"{millimetres} mm\"")));
        let output = carom(&["shell", &case, "--format", "json"]);
        let row: Value = serde_json::from_slice(&output.stdout).unwrap();
        let row = &row["loads"][0];
        let is_large = row["maximal_equivalent_stress"].as_f64().unwrap() > 0.02 * 195e9;
        let told = String::from_utf8_lossy(&output.stderr).contains("2 % of Young's modulus");
        assert_eq!(told, is_large, "{millimetres} mm: {row}");
        told_of[usize::from(told)] += 1;
    }
    assert!(told_of[0] > 0 && told_of[1] > 0, "{told_of:?}");
}
