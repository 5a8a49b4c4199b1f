//! `carom surface`: a map of known heights under each option.

use crate::common::{carom, case, close, example, fresh, json, refusal, stdout};
use carom_surface::{Reading, read};

/// Whole multiples of a row, about which neither a mean nor a plane fits better than 0.
const RIDGES: [f64; 4] = [1.0, -1.0, -1.0, 1.0];

/// 32 x 8 points of ridges of 1 along x on a slope of 0.25 a point.
fn ridges() -> Vec<Vec<f64>> {
    let row = |j: usize| (0..32).map(|i| RIDGES[j % 4] + 0.25 * f64::from(i)).collect();
    (0..8).map(row).collect()
}

fn file(name: &str, rows: &[Vec<f64>]) -> String {
    let line = |row: &Vec<f64>| row.iter().map(f64::to_string).collect::<Vec<_>>().join(",") + "\n";
    case(name, &rows.iter().map(line).collect::<String>())
}

fn warned(arguments: &[&str]) -> String {
    String::from_utf8(carom(arguments).stderr).unwrap()
}

#[test]
fn a_map_has_the_unit_and_the_size_that_are_given() {
    let map = file("ridges.csv", &ridges());
    let told = warned(&["surface", &map]);
    assert!(told.contains("does not state the unit") && told.contains("is tilted"), "{told}");
    assert!(!told.contains("repeat"), "{told}");
    assert!(warned(&["surface", &map, "--periodic"]).contains("does not repeat itself: along x"));
    for (more, told) in [
        (&[][..], "neither size nor unit is stated"),
        (&["--unit", "um"], "its size is not stated"),
        (&["--size", "1"], "the unit of its heights is not stated"),
        (&["--unit", "um", "--size", "1"], "size and unit are known"),
    ] {
        let head = stdout(&[&["surface", &map], more].concat());
        assert!(head.starts_with(&format!("text: 32 x 8 points, {told}")), "{head}");
    }
    for (option, value, metre) in [
        ("--unit", "m", 1.0),
        ("--unit", "mm", 1e-3),
        ("--unit", "um", 1e-6),
        ("--unit", "nm", 1e-9),
        ("--scale", "0.5 um", 5e-7),
    ] {
        let found = json(&["surface", &map, option, value, "--size", "64 um, 4 um"]);
        let wanted = [("rms_height_level", 1.0), ("rise_x", 7.75), ("highest", 8.75)];
        wanted.iter().for_each(|(name, height)| {
            close(&found[name], metre * height, 1e-9 * metre);
        });
        close(&found["spacing_x"], 2e-6, 1e-18);
        close(&found["spacing_y"], 5e-7, 1e-18);
        close(&found["kurtosis"], 1.0, 1e-9);
    }
    let square = json(&["surface", &map, "--size", "64 um"]);
    close(&square["spacing_x"], 2e-6, 1e-18);
    close(&square["spacing_y"], 2e-6, 1e-18);
    let grey = |range: &str| json(&["surface", &example("solve_grey.png"), "--range", range]);
    let [one, two] = ["10 um", "20 um"].map(|range| grey(range)["highest"].as_f64().unwrap());
    assert!(one > 0.0 && one <= 1.0000001e-5 && (two / one - 2.0).abs() < 1e-12, "{one} {two}");
}

#[test]
fn a_saved_map_is_cut_levelled_and_filled() {
    let mut rows = ridges();
    rows[3][7] = f64::NAN;
    let map = file("hole.csv", &rows);
    let told = warned(&["surface", &map]);
    assert!(told.contains("1 point is missing (0.39 %), the first in row 4, column 8"), "{told}");
    // The ridges but one.
    let known = json(&["surface", &map]);
    close(&known["kurtosis"], 1.0, 0.01);
    close(&known["mean"], (256.0 * 3.875 - 2.75) / 255.0, 1e-12);
    for ending in ["npy", "x3p"] {
        let saved = fresh(&format!("part.{ending}"));
        let part = ["--size", "64 um, 4 um", "--crop", "5,2,10,6", "--level", "plane"];
        let to = ["--unit", "um", "--missing", "fill", "--save", saved.to_str().unwrap()];
        stdout(&[&["surface", &map][..], &part, &to].concat());
        let found = read(&std::fs::read(&saved).unwrap(), &Reading::default()).unwrap().topography;
        assert_eq!((found.columns(), found.rows(), found.missing()), (5, 4, 0));
        let steps = found.spacing().map(|steps| steps.map(|step| (1e9 * step).round()));
        assert_eq!(steps, (ending == "x3p").then_some([2000.0, 500.0]));
        // The fit has one point less: 1/19 of a ridge and the slope of the rest.
        for (place, height) in found.heights().iter().enumerate() {
            let (i, j) = (place % 5, place / 5);
            let wanted = 1e-6 * RIDGES[(j + 2) % 4];
            assert!((i, j) == (2, 1) || (height - wanted).abs() < 0.12e-6, "{i} {j} {height}");
        }
    }
    for (option, value, told) in [
        ("--crop", "1,2,3", "--crop needs four numbers"),
        ("--crop", "0,0,33,8", "33"),
        ("--size", "1,2,3", "one or two lengths"),
        ("--size", "inf", "must be a length > 0"),
        ("--size", "0", "must be a length > 0"),
        ("--save", "map.csv", "must end in .npy or .x3p"),
        ("--range", "1 um", "is for PNG alone"),
    ] {
        let said = refusal(&["surface", &map, option, value]);
        assert!(said.contains(told), "{said}");
    }
}
