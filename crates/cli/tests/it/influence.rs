//! Influence numbers from a file instead of half-spaces, in `carom solve` and `carom roll`.

use crate::common::{case, close, example, json, refusal};
use carom_halfspace::operator::{HalfSpaceOperator, SurfaceOperator};
use carom_halfspace::{Grid, Material, MaterialPair};
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;

const CELLS: [usize; 2] = [20, 16];
const WIDTHS: [f64; 2] = [1e-4, 1.25e-4];
const NAMES: [&str; 9] = ["xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"];

/// Dissimilar bodies, so that each of the nine numbers counts.
fn pair() -> MaterialPair {
    let one = Material::from_young(8e9, 0.1).unwrap();
    let two = Material::from_young(2e10, 0.4).unwrap();
    MaterialPair::new(one, two).unwrap()
}

fn number(columns: i32, rows: i32, place: usize) -> f64 {
    let grid = Grid::new(CELLS[0], CELLS[1], WIDTHS[0], WIDTHS[1]).unwrap();
    let operator = HalfSpaceOperator::new(pair(), grid).unwrap();
    operator.coefficients(columns, rows).rows[place / 3][place % 3]
}

/// The half-space as a table of offsets >= 0 in micrometres per pascal.
fn csv() -> String {
    let grid = Grid::new(CELLS[0], CELLS[1], WIDTHS[0], WIDTHS[1]).unwrap();
    let operator = HalfSpaceOperator::new(pair(), grid).unwrap();
    let mut text = format!("columns,rows,{}\n", NAMES.join(","));
    for rows in 0..CELLS[1] as i32 {
        for columns in 0..CELLS[0] as i32 {
            write!(text, "{columns},{rows}").unwrap();
            for value in operator.coefficients(columns, rows).rows.iter().flatten() {
                write!(text, ",{:.17e}", 1e6 * value).unwrap();
            }
            text.push('\n');
        }
    }
    text
}

/// The same as CONTACT writes it: millimetres, times the shear modulus, receiver minus source.
fn inflcf() -> String {
    let grid = Grid::new(CELLS[0], CELLS[1], WIDTHS[0], WIDTHS[1]).unwrap();
    let operator = HalfSpaceOperator::new(pair(), grid).unwrap();
    // The modulus of each of two equal bodies.
    let scale = 1e3 * 2.0 * pair().shear_modulus();
    let [nx, ny] = CELLS.map(|count| count as i32);
    let mut text = format!("1 2 % matrices\n0 312\n1 0\n{nx} {ny} 0.1 0.125\n");
    for iy in 1 - ny..ny {
        writeln!(text, "% offset {iy}").unwrap();
        for ix in 0..nx {
            let rows = operator.coefficients(-ix, -iy).rows;
            write!(text, "{ix} {}", 0.1 * f64::from(ix)).unwrap();
            for place in [8, 6, 7, 2, 0, 1, 5, 3, 4] {
                write!(text, " {:.17e}", scale * rows[place / 3][place % 3]).unwrap();
            }
            text.push('\n');
        }
    }
    text
}

/// The same as an uncompressed NPZ of all offsets.
fn npz() -> Vec<u8> {
    let grid = Grid::new(CELLS[0], CELLS[1], WIDTHS[0], WIDTHS[1]).unwrap();
    let operator = HalfSpaceOperator::new(pair(), grid).unwrap();
    let [nx, ny] = CELLS.map(|count| count as i32);
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let stored =
        zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    for (place, name) in NAMES.iter().enumerate() {
        archive.start_file(format!("{name}.npy"), stored).unwrap();
        let mut values = Vec::new();
        for rows in 1 - ny..ny {
            for columns in 1 - nx..nx {
                let value = operator.coefficients(columns, rows).rows[place / 3][place % 3];
                values.extend((1e6 * value).to_le_bytes());
            }
        }
        let shape = [ny, nx].map(|count| 2 * count as usize - 1);
        let bytes = carom_surface::npy("<f8", &shape, values.into_iter());
        std::io::Write::write_all(&mut archive, &bytes).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

fn text(bodies: &str, more: &str) -> String {
    format!(
        "[body_1]\nmaterial = {{ young_modulus = 8e9, poisson = 0.1 }}\n\
         [body_2]\nmaterial = {{ young_modulus = 2e10, poisson = 0.4 }}\n{bodies}\n\
         [gap]\nshape = \"paraboloid\"\nradii = [0.05, 0.04]\n\
         [grid]\ncells = [20, 16]\nsize = [2e-3, 2e-3]\n{more}\n"
    )
}

const SOLVE: &str = "[contact]\nfriction = 0.3\n\
                     [[step]]\nzeta = 8e-6\n[[step]]\nxi = 1e-6\neta = -5e-7\nomega = 1e-3\ncount = 2";
const ROLL: &str = "[contact]\nfriction = 0.3\n\
                    [rolling]\nspeed = 1\nzeta = 8e-6\ncreepage = [2e-4, 1e-3]\nspin = 0.4";

/// Writes the file beside the case that names it.
fn run(command: &str, bodies: &str, more: &str, name: &str, content: &[u8]) -> Value {
    let path = case(&format!("{command}_{name}.toml"), &text(bodies, more));
    std::fs::write(Path::new(&path).with_file_name(name), content).unwrap();
    json(&[command, &path])
}

fn influence(name: &str, scale: &str) -> String {
    format!("[bodies]\ninfluence = {{ file = \"{name}\"{scale} }}")
}

#[test]
fn half_spaces_from_a_file_are_half_spaces() {
    for (command, more, wanted, tolerance) in [
        ("solve", SOLVE, ["F_x", "F_y", "F_z", "M_z"], 1e-7),
        ("roll", ROLL, ["F_x", "F_y", "F_z", "M_z"], 1e-6),
    ] {
        let own = run(command, "", more, "none.txt", b"");
        for (name, scale, content) in [
            ("table.csv", ", scale = 1e-6", csv().into_bytes()),
            ("table.npz", ", scale = 1e-6", npz()),
            ("inflcf.txt", "", inflcf().into_bytes()),
        ] {
            let found = run(command, &influence(name, scale), more, name, &content);
            let rows = own.as_array().unwrap();
            assert_eq!(rows.len(), found.as_array().unwrap().len());
            for (row, same) in rows.iter().zip(found.as_array().unwrap()) {
                for field in wanted {
                    let value = row[field].as_f64().unwrap();
                    // At the trailing edge of rolling, what moves in from beyond the table is unknown.
                    let size =
                        row["F_z"].as_f64().unwrap() * if field == "M_z" { 1e-4 } else { 1.0 };
                    close(&same[field], value, tolerance * size);
                }
            }
        }
    }
}

fn refused(bodies: &str, more: &str, name: &str, content: &[u8]) -> String {
    let path = case(&format!("refused_{name}.toml"), &text(bodies, more));
    std::fs::write(Path::new(&path).with_file_name(name), content).unwrap();
    refusal(&["solve", &path])
}

#[test]
fn numbers_that_are_not_those_of_elastic_bodies_are_refused_by_name() {
    let normal = |columns: i32| number(columns, 0, 8);
    assert!(normal(1) < normal(0));
    let file = csv();
    let entry = |columns: i32, place: usize| {
        let start = format!("{columns},0,");
        let line = file.lines().find(|line| line.starts_with(&start)).unwrap();
        (line.to_owned(), line.split(',').nth(2 + place).unwrap().to_owned())
    };
    let changed = |columns: i32, place: usize, factor: f64| {
        let (line, word) = entry(columns, place);
        let value = factor * word.parse::<f64>().unwrap();
        let parts = line.split(',').enumerate();
        let other: Vec<String> = parts
            .map(|(i, part)| if i == 2 + place { format!("{value:e}") } else { part.to_owned() })
            .collect();
        file.replacen(&line, &other.join(","), 1)
    };
    let named = influence("bad.csv", ", scale = 1e-6");
    for (content, part) in [
        (changed(3, 2, -1.0), "since the displacement of one cell by another equals the converse"),
        (changed(0, 8, 0.1), "is not positive definite"),
        (changed(0, 0, -1.0), "displacement u of a cell under its own traction is -"),
        (file.replacen("zz", "qq", 1), "unknown column \"qq\""),
        (file.lines().take(30).collect::<Vec<_>>().join("\n"), "no entry for 9 columns and 1 rows"),
    ] {
        let said = refused(&named, SOLVE, "bad.csv", content.as_bytes());
        assert!(said.contains(part) && said.contains("bad.csv"), "{said}");
    }
    let said = refused(&influence("bad.npz", ""), SOLVE, "bad.npz", b"PK\x03\x04 no archive");
    assert!(said.contains("not an .npz file of `numpy.savez`"), "{said}");
    let said = refused(&influence("bad.inf", ""), SOLVE, "bad.inf", b"2 1\n0 312\n");
    assert!(said.contains("line 1 of the table: 2 matrices"), "{said}");
    let only_zz = "columns,rows,zz\n0,0,1\n";
    let said = refused(&influence("zz.csv", ""), SOLVE, "zz.csv", only_zz.as_bytes());
    assert!(said.contains("no entry for 1 columns and 0 rows"), "{said}");
}

#[test]
fn influence_numbers_exclude_what_has_none() {
    let told = |bodies: &str, from: &str, to: &str| {
        let path = case("excluded.toml", &text(bodies, SOLVE).replacen(from, to, 1));
        refusal(&["solve", &path])
    };
    let named = influence("table.csv", "");
    let grid = "cells = [20, 16]\nsize = [2e-3, 2e-3]";
    let said = told(&named, grid, "accuracy = 1e-2");
    assert!(said.contains("`grid.accuracy` excludes `bodies.influence`"), "{said}");
    let said = told(&named, grid, &format!("{grid}\nperiodic = true"));
    assert!(said.contains("`grid.periodic` excludes `bodies.influence`"), "{said}");
    let both = "[bodies]\ninfluence = { file = \"a.csv\" }\nplate = { a = 2e-3, b = 2e-3, thickness = 1e-3 }";
    let said = told(both, "friction = 0.3", "friction = 0");
    assert!(said.contains("`bodies.influence` excludes `bodies.plate`"), "{said}");
    let said = told("[bodies]\ninfluence = { file = \"a.csv\", scale = -1 }", "", "");
    assert!(said.contains("`bodies.influence.scale`") && said.contains("> 0"), "{said}");
}

/// The layer is softer than its half-space at no depth and stiffer than springs alone at none: the load lies between
/// both, and approaches the springs as the contact grows.
#[test]
fn a_thin_layer_tends_to_springs() {
    let rows = json(&["solve", &example("solve_layer.toml")]);
    let (shear, poisson, thickness, radius) = (1e6, 0.45, 2e-3, 0.05_f64);
    let mut before = f64::INFINITY;
    for row in rows.as_array().unwrap() {
        let (depth, force) = (row["zeta"].as_f64().unwrap(), row["F_z"].as_f64().unwrap());
        let springs = 2.0 * shear / ((1.0 - poisson) * thickness);
        let springs = std::f64::consts::PI * springs * radius * depth * depth;
        let stiffness = 2.0 * shear / (1.0 - poisson);
        let hertz = 4.0 / 3.0 * stiffness * radius.sqrt() * depth.powf(1.5);
        assert!(force > hertz && force < 1.5 * springs, "{depth}: {hertz} {force} {springs}");
        let ratio = force / springs;
        assert!(ratio < before);
        before = ratio;
    }
    assert!(before < 1.2, "{before}");
}
