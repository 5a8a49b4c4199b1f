//! `carom contact` beside what the program CONTACT prints.

use crate::common::{carom, example, folder, json, refusal};
use crate::contact_files::{spinning, veldep};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;

const PRINTED: &str = include_str!("../data/contact/printed.txt");
const CONFORMAL: &str = include_str!("../data/contact/conformal_rows.txt");
/// The example is solved by CONTACT to this part of FSTAT FN.
const EPS: f64 = 1e-6;

pub(crate) fn data(name: &str) -> String {
    let path = match name {
        "cattaneo" => example("contact_cattaneo.inp"),
        _ => format!("{}/tests/data/contact/{name}.inp", env!("CARGO_MANIFEST_DIR")),
    };
    std::fs::read_to_string(path).unwrap()
}

/// The rows of an input that lies in a file of this name.
pub(crate) fn solved(name: &str, text: &str) -> Value {
    let folder = folder();
    let path = folder.join(format!("{name}.inp"));
    std::fs::write(&path, text).unwrap();
    json(&["contact", path.to_str().unwrap()])
}

pub(crate) fn refused(text: &str) -> String {
    let folder = folder();
    let path = folder.join("wrong.inp");
    std::fs::write(&path, text).unwrap();
    refusal(&["contact", path.to_str().unwrap()])
}

/// Half a unit of the last digit of a printed number.
pub(crate) fn half_unit(printed: &str) -> f64 {
    let (mantissa, exponent) = printed.split_once('E').unwrap_or((printed, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, after)| after.len());
    0.5 * 10f64.powi(exponent.parse::<i32>().unwrap() - decimals as i32)
}

/// Compares all numbers that CONTACT prints of an input.
fn compare(name: &str, text: &str) {
    let results = solved(name, text);
    let section = PRINTED.split_once(&format!("[{name}]\n")).unwrap().1;
    let mut lines = section.lines().take_while(|line| !line.starts_with('['));
    let heads: Vec<&str> = lines.next().unwrap().split(' ').collect();
    let mut compared = 0;
    for line in lines {
        let printed: Vec<&str> = line.split(' ').collect();
        let rows = results["cases"].as_array().unwrap();
        let case: u64 = printed[0].parse().unwrap();
        let row = rows.iter().find(|row| row["case"] == case).unwrap();
        let limit = (row["FX"].as_f64().unwrap() / row["FX_REL"].as_f64().unwrap()).abs();
        for (head, printed) in heads.iter().zip(&printed).skip(1).filter(|(_, text)| **text != "-")
        {
            let (got, want) = (row[*head].as_f64().unwrap(), printed.parse::<f64>().unwrap());
            let noise =
                if matches!(*head, "FX" | "FY") && limit.is_finite() { EPS * limit } else { 1e-9 };
            let agrees = match want {
                0.0 => got.abs() <= noise,
                // Rounding of both.
                _ => {
                    (got - want).abs() <= half_unit(printed) * (1.0 + 1e-6)
                        || (*head == "FX" && want.abs() < 1e-8 && (got - want).abs() <= noise)
                }
            };
            assert!(
                agrees,
                "{name} case {}: {head} is {got}, CONTACT prints {printed}",
                row["case"]
            );
            compared += 1;
        }
    }
    assert!(compared > 10);
}

#[test]
fn single_examples_agree_in_all_printed_digits() {
    for name in ["cattaneo", "carter2d", "bentall", "subsurf"] {
        compare(name, &data(name));
    }
}

/// Cases of all kinds from the tests of CONTACT, and the extremes that it prints below the second and third.
#[test]
fn a_mixture_of_cases_agrees() {
    let rows: String = (20..=60).map(|part| format!(" .{part} .{part}\n")).collect();
    let text = data("testbank").replace("ROWS\n", &rows).replace("SLIP", &" 0 0".repeat(225));
    compare("testbank", &text);
    let all = &solved("testbank", &text)["below"];
    let printed = [
        [-0.565, 0.639, 0.696, 0.007, -0.960, -0.367, -0.367, -0.960],
        [-0.703, 1.133, 1.183, 0.012, -1.457, -0.757, -0.367, -0.985],
    ];
    for (place, printed) in printed.concat().into_iter().enumerate() {
        assert!((all[place]["value"].as_f64().unwrap() - printed).abs() <= 5e-4, "{}", all[place]);
    }
}

/// A case of an input: the module number, then its lines.
fn add(text: &mut String, lines: &[&str]) {
    writeln!(text, "3\n {}", lines.join("\n ")).unwrap();
}

#[test]
fn a_conformal_contact_with_slip_from_cell_to_cell_agrees() {
    let mut text = String::new();
    let head = ["203000", "022020", "0001341", "80 200 5 1 1e-8"];
    let rest = [".3 .3", "0 .4 30000", ".28 .28 82000 82000"];
    let grid = ["1", "51 39 -10.2 -7.8 .4 .4"];
    let [parabola, cells] = [".09089 -.004 -.0098995 -.0015372", "0 -.004 -.0098995 -.0015372"]
        .map(|drive| [&head[..], &[drive], &rest, &grid].concat());
    add(&mut text, &[&parabola[..], &["1 1", ".00076859 0 .00098039 0 0 0"]].concat());
    let rows: Vec<Vec<f64>> = CONFORMAL
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| line.split(' ').map(|word| word.parse().unwrap()).collect())
        .collect();
    let x = |i: usize| f64::from(i as u32) * 0.4 - 10.0;
    let curvature = 0.5_f64.sqrt() / (2.0 * 460.0);
    let heights: Vec<String> = rows
        .iter()
        .map(|row| (0..51).map(|i| format!("{:.8} ", row[0] + curvature * x(i).powi(2))).collect())
        .collect();
    let heights: Vec<&str> = heights.iter().map(String::as_str).collect();
    add(&mut text, &[&cells[..], &["9 1"], &heights].concat());
    let slips: Vec<String> = rows
        .iter()
        .flat_map(|row| {
            (0..51).map(|i| {
                let across = row[2] + (row[3] - row[2]) * f64::from(i) / 50.0;
                format!("{:.8} {across:.8}", row[1])
            })
        })
        .collect();
    let slips: Vec<&str> = slips.iter().map(String::as_str).collect();
    let last = ["203000", "002009", "0001341", "80 200 5 1 1e-8", "0 0 0 0"];
    add(&mut text, &[&last[..], &rest, &slips].concat());
    compare("conformal", &(text + "0\n"));
}

#[test]
fn a_creep_curve_agrees() {
    let mut text = String::new();
    add(
        &mut text,
        &[
            "203100",
            "022020",
            "0000341",
            "80 200 5 1 1e-6",
            "106700 1d-5 0 0",
            ".33 .33",
            "0 .5 10000",
            ".28 .28 82000 82000",
            "-2",
            "48 44 .0008 .5 1.1",
        ],
    );
    for step in 1..10 {
        let drive = format!("106700 {:.4} 0 0", 4e-4 * f64::from(step));
        add(&mut text, &["203100", "100000", "0100341", &drive]);
    }
    compare("tractcurv", &(text + "0\n"));
}

#[test]
fn compression_in_stages_agrees() {
    let mut text = String::new();
    let solvers = "200 30 30 10 1e-6";
    for stage in 1..=35 {
        let force = match stage {
            30 => 0.296_296,
            33 => 0.394_370,
            _ => (f64::from(stage) / 45.0).powi(3),
        };
        let drive = format!("{force:.6} 0 0 0");
        if stage == 1 {
            add(
                &mut text,
                &[
                    "201103",
                    "022020",
                    "0001341",
                    solvers,
                    &drive,
                    ".2986 .2986",
                    "0 0 .5 100000",
                    "1",
                    "45 45 -4.4999 -4.4999 .2 .2",
                    "1 1",
                    ".004116 0 .004116 0 0 0",
                    "1 0",
                    "2",
                    "1 1 45",
                    "23 1 23",
                    "1 1e-6 1e-6",
                    "0",
                ],
            );
        } else {
            add(&mut text, &["001101", "100000", "0011111", solvers, &drive]);
        }
    }
    compare("spence35", &(text + "0\n"));
}

/// The contact rolls over the cells, or the cells stay while the undeformed distance moves on.
#[test]
fn the_onset_of_rolling_agrees_in_both_kinds_of_coordinates() {
    const SOLVERS: &str = "100 100 30 1 1e-7";
    const FORCED: &str = ".4705 -.657 0 0";
    let first = |text: &mut String, columns: usize| {
        let cells = format!("{columns} 33 -4.125 -4.125 .25 .25");
        add(
            text,
            &[
                "201110",
                "022020",
                "0001341",
                SOLVERS,
                FORCED,
                ".4013 .4013",
                ".28 .28 1 1",
                "1",
                &cells,
                "1 1",
                ".002963 0 .002963 0 0 0",
            ],
        );
    };
    let surface = |step: i32| {
        let (a, way) = (0.002_963, 0.25 * f64::from(step));
        format!("{a} 0 {a} {:.7} 0 {:.7}", -2.0 * a * way, a * way * way)
    };
    let mut text = String::new();
    first(&mut text, 34);
    add(&mut text, &["002110", "102000", "0011341", SOLVERS, FORCED, "0 .25 1000", ".28 .28 1 1"]);
    for _ in 3..=57 {
        add(&mut text, &["002110", "100000", "0010141", SOLVERS, FORCED]);
    }
    first(&mut text, 90);
    for step in 1..=56 {
        let pressed = [".07258 -.657 0 0", "1 1", &surface(step)];
        add(&mut text, &[&["001010", "100020", "0010141", SOLVERS], &pressed[..]].concat());
    }
    first(&mut text, 34);
    for step in 1..=56 {
        let cells = format!("34 33 {:.3} -4.125 .25 .25", 0.25 * f64::from(step) - 4.125);
        let drive = [".07258 -.657 0 0", "1", &cells, "1 1", &surface(step)];
        add(&mut text, &[&["001010", "121020", "0010141", SOLVERS], &drive[..]].concat());
    }
    text += "0\n";
    compare("catt_to_cart", &text);
    // Cells that move along give what fixed cells give.
    let rows = solved("onset", &text);
    for case in [58, 70, 113] {
        for name in ["FN", "CKSI", "FRIC_POWER", "NADH"] {
            let of = |case: usize| rows["cases"][case][name].as_f64().unwrap();
            assert!((of(case) / of(case + 57) - 1.0).abs() < 1e-6, "{case} {name}");
        }
    }
}

/// Extremes that CONTACT prints of the second case of its example, block by block.
#[test]
fn stresses_below_a_loaded_square_agree() {
    let all = &solved("subsurf", &data("subsurf"))["below"];
    let blocks = [
        [-0.853, 1.744, 2.010, 0.115, -1.895, -0.780, -0.780, -1.000],
        [-1.337, 2.179, 2.494, 1.424, -2.649, -2.044, -0.966, -1.058],
    ];
    for (place, printed) in blocks.concat().into_iter().enumerate() {
        let row = &all[16 + place];
        assert_eq!(row["case"], 2);
        assert!((row["value"].as_f64().unwrap() - printed).abs() <= 5e-4, "{row}");
    }
    assert_eq!(all[31]["stress"], "SIGZZ");
    assert_eq!(all[31]["at"], serde_json::json!([0.4, 0.0, 0.1]));
}

#[test]
fn what_carom_does_not_do_is_refused_by_digit_and_name() {
    let text = data("carter2d");
    for (from, to, said) in [
        (
            " 203100",
            " 213100",
            "line 2: control digit B (BOUND) is 1 (thin sheet), which carom does not do, must be one of 0",
        ),
        (
            " 203100",
            " 203190",
            "line 2: control digit F (FORCE) is 9, must be one of 0 (creepages CKSI and CETA",
        ),
        (
            " 022020",
            " 622020",
            "line 3: control digit L (FRCLAW) is 6 (friction by the surface temperature",
        ),
        (
            " 022020",
            " 022420",
            "line 3: control digit M (MATER) is 4 (elastic bodies with an elastic-plastic",
        ),
        (
            " 022020",
            " 022120",
            "control digit M (MATER) is 1 (viscoelastic bodies with relaxation)",
        ),
        (
            " 022020",
            " 002020",
            "line 2: control digit D (DISCNS) is 0, must be 2 in the first case",
        ),
        (
            " 022020",
            " 0220x0",
            "line 3: control digits VLDCMZE is 0220x0, must be one digit for each letter",
        ),
        (
            " 0001541",
            " 3001541",
            "line 4: control digit H (HEAT) is 3 (temperature), which carom does not do",
        ),
        (
            "3\n 2",
            "1\n 2",
            "line 1: MODULE is 1 (wheel on rail), which carom does not do, must be 3",
        ),
        (" 35780", " -1", "line 6: FN is -1, must be > 0"),
        (".28 .28 8", ".28 .7 8", "line 9: POISS2 is 0.7, must be from 0 to 0.5"),
        (" 3\n 55", " 7\n 55", "line 10: IPOTCN is 7, must be a whole number from -6 to 4"),
        (" .04 200", " 0 200", "line 11: DX is 0, must be > 0"),
        (" 55 1 ", " 5500 100 ", "line 11: MY is 100, must be such that MX MY is at most 524288"),
        (" 1 1\n", " 1 4\n", "line 12: IPLAN is 4, must be 1, 2 or 3"),
        (".3 .3", ".3 .2", "line 7: FKIN is 0.2, must be FSTAT = 0.3: CONTACT has one coefficient"),
        (".3 .3", ".3 % .3", "line 8: FKIN is followed by 0.0401,"),
        (" 0 0 0\n0", " 0 0\n0\n", "line 16: MODULE is missing: the file ends here"),
        (" 35780 -", " 35780 ! ", "line 6: CKSI is \"!\", must be a number"),
    ] {
        let wrong = text.replacen(from, to, 1);
        assert_ne!(wrong, text, "{from}");
        let error = refused(&wrong);
        assert!(error.contains(said), "{error}");
    }
    assert!(refused("").contains("line 1: MODULE is missing"));
    let output = carom(&["contact", "no.inp"]);
    assert!(String::from_utf8(output.stderr).unwrap().contains("an input of CONTACT is expected"));
    assert!(refused("3\n").contains("line 2: the line of control digits is missing"));
}

/// One contact, stated in several ways.
#[test]
fn other_words_for_a_contact_do_not_change_it() {
    let case = |digits: &str, drive: &str, rolling: &str, area: &str| {
        let head = "3\n 203100\n 022020\n 0000241\n 200 100 30 1 1e-9\n";
        let head = head.replace("203100", digits);
        format!("{head} {drive}\n .3 .3\n {rolling} .25 .3 8e4 7e4\n {area}\n0\n")
    };
    let shape = "1 1\n .01 0 .02 0 0 0";
    let area = |first: &str| format!("{first}\n {shape}");
    let cells = |height: fn(f64, f64) -> f64| {
        let middle = |i: i32| 0.05 * f64::from(i);
        let all = (-8..=8).flat_map(|y| (-12..=12).map(move |x| height(middle(x), middle(y))));
        all.fold(String::new(), |text, height| format!("{text} {height:e}\n"))
    };
    let rows: String =
        (-9..=9).map(|y| format!(" {}\n", 0.02 * (0.05 * f64::from(y)).powi(2))).collect();
    let (drive, rolling) = ("200 -.001 .0005 .0002", "180d .05 1000\n");
    let plain = case("203100", drive, rolling, &area("1\n 25 17 -.625 -.425 .05 .05"));
    let plain = &solved("plain", &plain)["cases"][0];
    let places = "1\n 25 17 -.625 -.425 .05 .05";
    let by_circles = format!("{places}\n 2 1\n 19 0 50 -.45 .05\n{rows}");
    let by_cells = format!("{places}\n 9 1\n{}", cells(|x, y| 0.01 * x * x + 0.02 * y * y));
    let by_plan = format!("{places}\n 1 2\n .01 0 .02 0 0 0\n 1 0 1 0 0 -.35");
    let in_radians = format!("{} .05 1000\n", std::f64::consts::PI);
    let pressed = format!("{} -.001 .0005 .0002", plain["APPROACH"]);
    let with_forces = format!("200 {} {} .0002", plain["FX_REL"], plain["FY_REL"]);
    for (digits, drive, rolling, area) in [
        ("203100", drive, rolling, &area("2\n 25 17 -.625 -.425 .625 .425")),
        ("203100", drive, rolling, &area("3\n 25 17 -.6 -.4 .05 .05")),
        ("203100", drive, rolling, &area("4\n 25 17 -.6 -.4 .6 .4")),
        ("203100", drive, rolling, &by_circles),
        ("203100", drive, rolling, &by_cells),
        ("203100", drive, rolling, &by_plan),
        ("203100", drive, in_radians.as_str(), &area(places)),
        ("203000", pressed.as_str(), rolling, &area(places)),
        ("203120", with_forces.as_str(), rolling, &area(places)),
    ] {
        let text = case(digits, drive, rolling, area);
        let other = &solved("other", &text)["cases"][0];
        for name in ["FN", "FX", "FY", "MZ", "CKSI", "CETA", "APPROACH", "PMAX", "NCON", "NADH"] {
            let [a, b] = [plain, other].map(|row| row[name].as_f64().unwrap());
            assert!((a - b).abs() <= 1e-6 * a.abs(), "{name} is {a} and {b} of\n{text}");
        }
    }
    // All terms, waves and a plan of two rectangles, beside the same cell by cell.
    let quadratic =
        |x: f64, y: f64| 0.01 * x * x + 0.002 * x * y + 0.02 * y * y + 0.003 * x - 0.004 * y + 0.01;
    let waves = |x: f64, y: f64| {
        0.003 * (5.0 * (x - 0.1)).sin() - 0.002 * (7.0 * (x + 0.05)).sin()
            + x * x / 80.0
            + y * y / 40.0
    };
    let parts = |x: f64, y: f64| {
        let is_in = (x <= -0.08 && y >= -0.22) || (x >= 0.08 && y <= 0.22);
        if is_in { 0.01 * x * x + 0.02 * y * y } else { 1e3 }
    };
    for (words, height) in [
        ("1 1\n .01 .002 .02 .003 -.004 .01", quadratic as fn(f64, f64) -> f64),
        ("3 1\n .003 5 .1 .002 7 -.05 80 40", waves),
        ("1 3\n .01 0 .02 0 0 0\n -9 -.08 -.22 9\n .08 9 -9 .22", parts),
    ] {
        let [one, two] = [words.to_owned(), format!("9 1\n{}", cells(height))].map(|shape| {
            solved("shape", &case("203100", drive, rolling, &format!("{places}\n {shape}")))
        });
        for name in ["FN", "FX", "FY", "MZ", "APPROACH", "PMAX", "NCON", "NADH"] {
            let [a, b] = [&one, &two].map(|all| all["cases"][0][name].as_f64().unwrap());
            assert!((a - b).abs() <= 1e-6 * a.abs(), "{name} is {a} and {b} of {words}");
        }
    }
    // Radii, and the semi-axes of a circle of which CONTACT prints them.
    let hertz = |way: &str| {
        let text =
            case("200100", "82000 0 0 0", "", way).replace(".25 .3 8e4 7e4", ".28 .28 8.2e4 8.2e4");
        solved("hertz", &text)["cases"][0]["APPROACH"].as_f64().unwrap()
    };
    for way in ["-1\n 40 40 .004219 .004219 1.1", "-2\n 40 40 .004219 1 1.1", "-3\n 40 40 4 4 1.1"]
    {
        assert!((hertz(way) - 0.1350).abs() < 1e-4, "{way}: {}", hertz(way));
    }
}

#[test]
fn influence_numbers_of_half_spaces_are_those_of_half_spaces() {
    let file = example("roll_inflcf.txt");
    let [plain, other] = [("2", String::new()), ("9", format!("\n '{file}'"))].map(|(c, name)| {
        let head = format!("3\n 203100\n 02{c}020\n 0000041\n 200 100 30 1 1e-6");
        let text = format!(
            "{head}\n 1e4 -.001 0 0\n .3 .3\n 0 1 30000{name}\n .28 .28 80468.75 80468.75\n \
             1\n 24 16 -12 -8 1 1\n 1 1\n .001 0 .001 0 0 0\n0\n"
        );
        solved("influence", &text)["cases"][0].clone()
    });
    for name in ["FX", "APPROACH", "PMAX", "ELAST_EN", "FRIC_POWER", "NADH"] {
        let [a, b] = [&plain, &other].map(|row| row[name].as_f64().unwrap());
        // The file has seven digits.
        assert!((a - b).abs() < 1e-6 * a.abs(), "{name} is {a} and {b}");
    }
}

#[test]
fn line_ends_exponents_and_comments_do_not_count() {
    let plain = solved("carter2d", &data("carter2d"));
    let other = data("carter2d")
        .replace(" 35780", "\t3.578D+4,")
        .replace(".0401", "\n % a line\n .0401")
        .replace('\n', "\r\n");
    let other = solved("carter2d", &other);
    assert_eq!(plain["cases"][0]["FX"], other["cases"][0]["FX"]);
}

/// Changed at one place each, files are solved or refused, and no message lacks its line.
#[test]
fn changed_files_are_solved_or_refused() {
    let mut seed = 2_463_534_242_u32;
    let mut next = |below: usize| {
        seed ^= seed << 13;
        seed ^= seed >> 17;
        seed ^= seed << 5;
        seed as usize % below
    };
    let mut texts = ["cattaneo", "carter2d", "subsurf"].map(data).to_vec();
    texts.extend([spinning(3, ".4", 44) + "0\n", veldep()]);
    let (mut solved, mut refused) = (0, 0);
    for round in 0..300 {
        let mut words: Vec<String> =
            texts[round % texts.len()].split_inclusive([' ', '\n']).map(str::to_owned).collect();
        let place = next(words.len());
        match next(6) {
            0 => drop(words.remove(place)),
            1 => words.truncate(place),
            2 => words.insert(place, "7 ".to_owned()),
            3 => words[place] = format!("-{}", words[place]),
            4 => words[place] = words[place].replace(['0', '1'], "9"),
            _ => words[place] = words[place].replace('.', "d"),
        }
        let folder = folder();
        let path = folder.join("changed.inp");
        std::fs::write(&path, words.concat()).unwrap();
        let path: &Path = &path;
        let output = carom(&["contact", path.to_str().unwrap(), "--format", "csv"]);
        let said = String::from_utf8(output.stderr).unwrap();
        match output.status.code() {
            Some(0) => solved += 1,
            Some(2) => {
                refused += 1;
                assert!(output.stdout.is_empty());
                assert!(said.contains(": line ") || said.contains("case "), "{said}");
            }
            other => panic!("{other:?}: {said}\n{}", words.concat()),
        }
    }
    assert!(solved > 50 && refused > 100, "{solved} {refused}");
}

/// Carom's own case of a case of CONTACT has its numbers, with carom's signs and units.
#[test]
fn a_case_becomes_a_case_of_carom() {
    let folder = folder();
    let text = data("cattaneo").replace(
        "19 19 -1.26667 -1.26667 .13333 .13333",
        "19 19 -1.2666 -1.2666 .133326315789474 .133326315789474",
    );
    let input = folder.join("cattaneo.inp");
    std::fs::write(&input, &text).unwrap();
    let input = input.to_str().unwrap();
    let output = carom(&["contact", input, "--to-toml", "2"]);
    let case = folder.join("case.toml");
    std::fs::write(&case, output.stdout).unwrap();
    let own = json(&["solve", case.to_str().unwrap()]);
    let row = &json(&["contact", input])["cases"][1];
    let last = own
        .as_array()
        .and_then(|rows| rows.last())
        .unwrap_or_else(|| own["steps"].as_array().unwrap().last().unwrap());
    let number = |value: &Value| value.as_f64().unwrap();
    assert!((number(&last["F_x"]) / number(&row["FX"]) - 1.0).abs() < 1e-9);
    assert!((-1e3 * number(&last["xi"]) / number(&row["CKSI"]) - 1.0).abs() < 1e-5);
    let output = carom(&["contact", input, "--to-toml", "3"]);
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("the file has no case 3 to solve: it has 2"), "{said}");
}

/// Moduli in Pa are taken as N/mm2, and told.
#[test]
fn moduli_that_are_probably_in_pascal_are_told() {
    let text = data("cattaneo").replacen(".42 .42 200 200", ".42 .42 2e8 200", 1);
    let folder = folder();
    let path = folder.join("pascal.inp");
    std::fs::write(&path, text).unwrap();
    let told = String::from_utf8(carom(&["contact", path.to_str().unwrap()]).stderr).unwrap();
    assert!(
        told.contains("GG1 = 200000000 is unusual: it is in N/mm2, and steel has 82000"),
        "{told}"
    );
    let usual = example("contact_cattaneo.inp");
    assert!(!String::from_utf8(carom(&["contact", &usual]).stderr).unwrap().contains("unusual"));
}
