//! Further inputs of the program CONTACT: FASTSIM, friction that falls, and thirty files of its testbank one by one.

use crate::common::number;
use crate::contact_program::{data, half_unit, refused, solved};
use std::fmt::Write as _;

const FILES: &str = include_str!("../data/contact/files.txt");

/// Each of the files is solved, with the numbers that it states, or refused by digit and name.
#[test]
fn each_file_of_the_testbank_is_solved_or_refused() {
    let (head, rest) = FILES.split_once("\n[").unwrap();
    let wheel = head.split_once("WHEEL\n").unwrap().1;
    let mut count = 0;
    for section in rest.split("\n[") {
        let mut lines = section.lines();
        let name = lines.next().unwrap().strip_suffix(']').unwrap();
        let wanted = lines.next().unwrap();
        let text = lines.collect::<Vec<_>>().join("\n").replace("WHEEL", wheel);
        match wanted.split_once(' ').unwrap() {
            ("=", numbers) => {
                let found = solved(name, &text);
                let row = found["cases"].as_array().unwrap().last().unwrap();
                let words: Vec<&str> = numbers.split(' ').collect();
                for pair in words.chunks_exact(2) {
                    let off = (number(row, pair[0]) - pair[1].parse::<f64>().unwrap()).abs();
                    assert!(off <= half_unit(pair[1]), "{name}: {} is off {off}", pair[0]);
                }
            }
            (_, said) => {
                let error = refused(&text);
                assert!(error.contains(said), "{name}: {error}");
            }
        }
        count += 1;
    }
    assert!(count >= 30, "{count}");
}

/// A case of FASTSIM: pressures, creepages and cells of CONTACT's example.
pub(crate) fn spinning(bound: u8, step: &str, cells: u16) -> String {
    format!(
        "3\n 2{bound}3100\n 022320\n 0001341\n 80 200 5 1 1e-6\n 82000 0 -.000625 .000625\n .3 .3\n 0 {step} 30000\n \
         .28 .28 82000 82000\n 1 1 1\n -3\n {cells} {cells} 8 4 1.1\n"
    )
}

/// What CONTACT prints: FX or FY, MZ, FRIC_POWER, NADH. Its flexibilities are off by up to 0.2 %, those of Kalker's printed
/// table; with them the page rolling.fastsim of the verification agrees in all digits.
#[test]
fn fastsim_is_that_of_contact_but_for_kalkers_table() {
    let mut text = spinning(3, ".4", 44) + &spinning(2, ".4", 44) + &spinning(2, ".08", 220);
    let head = "80 200 5 1 1e-6\n 106700 .0004 0 0\n .33 .33";
    let body = "0 .5 10000\n .28 .28 82000 82000";
    let place = "-2\n 48 44 .0008 .5 1.1";
    write!(text, "3\n 233100\n 022320\n 0001341\n {head}\n {body}\n 1 1 1\n {place}\n").unwrap();
    text += "3\n 233100\n 100300\n 0100341\n 106700 .0036 0 0\n";
    let falling = ".1368 .2232 990 0 0\n .003 1";
    write!(
        text,
        "3\n 233100\n 422320\n 0100341\n 106700 .001 0 0\n {falling}\n {body}\n .54 .02 .62\n {place}\n"
    )
    .unwrap();
    text += "3\n 233100\n 100300\n 0100341\n 106700 .025 0 0\n0\n";
    let found = solved("fastsim", &text);
    let rows = found["cases"].as_array().unwrap();
    let printed = [
        ("FY", -1.500e4, -3.904e4, -506.1, 742.0, 1629.0, 1264.0),
        ("FY", -1.478e4, -4.828e4, -688.3, 622.0, 1223.0, 1264.0),
        ("FY", -1.463e4, -4.529e4, -730.9, 16632.0, 1223.0, 31428.0),
        ("FX", -9075.0, 0.0, -27.23, 1222.0, 853.8, 1376.0),
        ("FX", -3.491e4, 0.0, -1219.0, 196.0, 853.8, 1376.0),
        ("FX", -1.045e4, 0.0, -79.87, 1214.0, 853.8, 1376.0),
        ("FX", -3.243e4, 0.0, -7774.0, 442.0, 853.8, 1376.0),
    ];
    assert_eq!(rows.len(), printed.len());
    for (row, (force, size, torque, power, stick, highest, touching)) in rows.iter().zip(printed) {
        let near = |name: &str, wanted: f64, part: f64| {
            let off = (number(row, name) - wanted).abs();
            assert!(off <= part * wanted.abs(), "{name} of {row} is not {wanted}");
        };
        near(force, size, 2e-3);
        near("MZ", torque, 3e-3);
        near("FRIC_POWER", power, 5e-3);
        near("PMAX", highest, 5e-4);
        // Two cells of a row and its image change at once.
        assert!((number(row, "NADH") - stick).abs() <= 0.02 * touching, "{row}");
        assert_eq!(number(row, "NCON"), touching);
    }
}

/// Springs of one flexibility at a small creepage: the traction of a cell counts the cells from the leading edge on.
#[test]
fn springs_of_one_flexibility_stick_as_they_must() {
    let text = spinning(3, ".4", 44)
        .replace("022320", "022220")
        .replace("\n 1 1 1\n", "\n 5e-5 1 1 1\n")
        .replace("0 -.000625 .000625", "1e-7 0 0")
        + "0\n";
    let row = &solved("springs", &text)["cases"][0];
    // FASTSIM rolls by a cell whatever the solver and DQ.
    let other = text.replace("0001341", "0201341").replace("1e-6\n", "1e-6\n .9 .9 0 1\n");
    let other = other.replace("0 .4 30000", "0 1 30000");
    assert_eq!(solved("springs", &other)["cases"][0]["FX"], row["FX"]);
    let middle = |i: i32, width: f64| width * (f64::from(i) - 21.5);
    let inside = |x: f64, y: f64| (x / 8.0).powi(2) + (y / 4.0).powi(2) < 1.0;
    let rows = (0..44).map(|j| (0..44).filter(|i| inside(middle(*i, 0.4), middle(j, 0.2))).count());
    let cells: usize = rows.clone().sum();
    let steps: usize = rows.map(|cells| cells * (cells + 1) / 2).sum();
    assert_eq!(number(row, "NCON"), cells as f64);
    let slipping = number(row, "NSLIP");
    let wanted = -1e-7 * 0.4 / 5e-5 * 0.4 * 0.2 * steps as f64;
    let force = number(row, "FX");
    assert!(slipping == 0.0 && (force / wanted - 1.0).abs() < 1e-9, "{force} {wanted}");
}

/// The first case of veldep_fric.
pub(crate) fn veldep() -> String {
    let text = FILES.split_once("[veldep_fric]\n").unwrap().1.split_once('\n').unwrap().1;
    format!("{}\n0\n", text.split_once("\n3\n002100").unwrap().0)
}

/// The steady cases of veldep_fric: the branch that is reached from rest, in all printed digits.
#[test]
fn friction_that_falls_with_slip_agrees() {
    let found = solved("veldep", &veldep());
    let row = &found["cases"][0];
    for (name, printed) in [
        ("FX", "1.109E+05"),
        ("FX_REL", "0.5941"),
        ("FRIC_POWER", "-4849."),
        ("ELAST_EN", "27.20"),
        ("APPROACH", "8.879E-02"),
        ("PMAX", "495.3"),
        ("NCON", "81"),
        ("NADH", "45"),
        ("NSLIP", "36"),
    ] {
        let off = (number(row, name) - printed.parse::<f64>().unwrap()).abs();
        assert!(off <= half_unit(printed) * (1.0 + 1e-6), "{name} is {}", row[name]);
    }
}

/// What FASTSIM and falling friction need of other digits.
#[test]
fn springs_and_falling_friction_are_refused_beside_other_digits() {
    let springs = spinning(3, ".4", 44) + "0\n";
    let plain = data("carter2d");
    let falling = |law: &str, numbers: &str| {
        plain.replace(" 022020", &format!(" {law}22020")).replace(" .3 .3", numbers)
    };
    for (text, said) in [
        (
            springs.replace("233100", "232100"),
            "control digit M (MATER) is 3, must be 0 unless T = 3",
        ),
        (
            springs.replace("233100", "233110"),
            "control digit F (FORCE) is 1, must be 0 with M = 2 or 3",
        ),
        (
            springs.replace("022320", "022020").replace("\n 1 1 1\n", "\n"),
            "control digit B (BOUND) is 3, must be 0 with M = 0",
        ),
        (
            springs.replace("022320", "022329"),
            "control digit E (EXRHS) is 9, must be 0 with M = 2 or 3",
        ),
        (
            springs.replace(
                "\n -3\n 44 44 8 4 1.1",
                "\n 1\n 44 44 -8.8 -4.4 .4 .2\n 1 1\n .001 0 .002 0 0 0",
            ),
            "control digit B (BOUND) is 3, must be 0 unless IPOTCN is -3 to -1",
        ),
        (springs.replace("1 1 1\n", "1.5 1 1\n"), "K0_MF is 1.5, must be from 1e-10 to 1"),
        (
            springs.replace("\n0\n", "\n3\n 203100\n 100000\n 0100341\n 82000 0 0 0\n0\n"),
            "line 14: control digit C (INFLCF) is 0, must be 2 or 9 where M changes",
        ),
        (springs.replace("022320", "022220"), "line 11: BETAMF is -3, must be from 0 to 1e20"),
        (falling("2", " .2 .1 100 0 0\n 0 1"), "must be 4 with FEXP2 = 0"),
        (falling("4", " .2 .1 100 .1 100\n 0 1"), "must be 4 with FEXP2 = 0"),
        (
            falling("4", " .2 .1 100 0 0\n .001 1"),
            "line 8: MEMDST is 0.001, must be 0: carom's friction has no memory",
        ),
        (
            falling("4", " .2 -.3 100 0 0\n 0 1"),
            "FKIN is 0.2, must be such that friction is positive",
        ),
        (
            falling("4", " .2 .1 100 0 0\n 0 1")
                .replace("203100", "201100")
                .replace("0 .0401 30000\n", ""),
            "control digit T (TANG) is 1, must be 0 or 3 with L = 4",
        ),
    ] {
        let error = refused(&text);
        assert!(error.contains(said), "{error}\n{text}");
    }
}
