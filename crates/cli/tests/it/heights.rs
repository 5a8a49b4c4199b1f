//! Invalid files of heights: their sizes are compared with the grid before anything is read.

use crate::common::{carom, case, close, fresh, json, limited, refusal};
use std::io::Write as _;

/// A case of 3 x 2 cells under the heights in this file.
fn under(file: &str, more: &str) -> String {
    format!(
        "[body_1]\nmaterial = {{ rigid = true }}\n[body_2]\nmaterial = {{ shear_modulus = 1e9, \
         poisson = 0.3 }}\n[gap]\nshape = \"heights\"\nfile = \"{file}\"\n{more}[grid]\n\
         cells = [3, 2]\nsize = [3, 2]\ncut = true\n[contact]\nfriction = 0\n[[step]]\nzeta = 0.1\n"
    )
}

/// What the command says of these heights: an error that names the file, with code 2.
fn refused(file: &str, bytes: &[u8], more: &str) -> String {
    let path = fresh(file);
    std::fs::write(&path, bytes).unwrap();
    // Nothing of the stated size is allocated or decoded.
    let case = case(&format!("{file}.toml"), &under(file, more));
    let output = limited("ulimit -t 5; ulimit -v 4000000", &["solve", &case]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{file}: {said}");
    assert!(said.contains(file) && !said.contains("step "), "{said}");
    said
}

fn npy(shape: [usize; 2], values: &[f64]) -> Vec<u8> {
    carom_surface::npy("<f8", &shape, values.iter().flat_map(|value| value.to_le_bytes()))
}

/// A picture in greys of 8 bits, with the first `lines` of its lines only.
fn png(width: u32, height: u32, lines: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_filter(png::Filter::NoFilter);
    let mut writer = encoder.write_header().unwrap();
    let mut stream = writer.stream_writer().unwrap();
    let line = vec![0; width as usize];
    (0..lines).for_each(|_| stream.write_all(&line).unwrap());
    // Without its end if lines are missing.
    let _ = stream.finish();
    drop(writer);
    bytes
}

#[test]
fn an_npy_head_with_no_columns_is_refused_before_rows_are_made() {
    for rows in [usize::MAX, 99_999_999_999, 0] {
        let said = refused(&format!("heights_none_{rows}.npy"), &npy([rows, 0], &[]), "");
        assert!(said.contains(&format!("has 0 x {rows} values, the grid 3 x 2 cells")), "{said}");
    }
}

#[test]
fn an_npy_head_of_another_size_than_the_grid_is_refused() {
    let said = refused("heights_other.npy", &npy([3, 2], &[0.0; 6]), "");
    assert!(said.contains("has 2 x 3 values, the grid 3 x 2 cells"), "{said}");
    let said = refused("heights_short.npy", &npy([2, 3], &[0.0; 5]), "");
    assert!(said.contains("damaged"), "{said}");
}

#[test]
fn a_png_head_of_40_gigabytes_is_refused_before_its_greys_are_made() {
    let said = refused("heights_head.png", &png(200_000, 200_000, 0), "");
    assert!(said.contains("has 200000 x 200000 values, the grid 3 x 2 cells"), "{said}");
}

#[test]
fn a_png_that_unpacks_to_gigabytes_is_refused_before_it_is_unpacked() {
    let bomb = png(40_000, 40_000, 2_000);
    assert!(bomb.len() < 1 << 21, "{}", bomb.len());
    let said = refused("heights_bomb.png", &bomb, "");
    assert!(said.contains("has 40000 x 40000 values, the grid 3 x 2 cells"), "{said}");
}

#[test]
fn a_csv_file_of_more_rows_or_columns_than_cells_is_counted_before_it_is_read() {
    let many = "1\n".repeat(4_000_000);
    let said = refused("heights_long.csv", many.as_bytes(), "");
    assert!(said.contains("has 1 x 4000000 values, the grid 3 x 2 cells"), "{said}");
    let wide = "1,".repeat(3_999_999) + "1\n";
    let said = refused("heights_wide.csv", wide.as_bytes(), "");
    assert!(said.contains("has 4000000 x 1 values, the grid 3 x 2 cells"), "{said}");
}

#[test]
fn heights_that_overflow_are_blamed_on_their_row_of_the_file() {
    let great = "1,2,3\n1,1e308,2\n";
    let said = refused("heights_great.csv", great.as_bytes(), "");
    assert!(said.contains("1e308 in row 2, column 2: must be at most 1e100 times"), "{said}");
    let said = refused("heights_great.npy", &npy([2, 3], &[0.0, 0.0, 0.0, -1e308, 1e308, 0.0]), "");
    assert!(said.contains("-1e308 in row 2, column 1: must be at most 1e100 times"), "{said}");
    let said = refused("heights_scaled.csv", great.as_bytes(), "scale = 100\n");
    assert!(
        said.contains("row 2, column 2 is 1e308 times the scale 1e2: must be finite"),
        "{said}"
    );
    let said = refused("heights_infinite.csv", b"1,2,3\n1,1e309,2\n", "");
    assert!(said.contains("line 2, column 2: `1e309` is not a finite number"), "{said}");
    let said = refused("heights_nan.npy", &npy([2, 3], &[0.0, 0.0, f64::NAN, 0.0, 0.0, 0.0]), "");
    assert!(said.contains("missing (1), the first in row 1, column 3: give `missing`"), "{said}");
}

#[test]
fn heights_of_the_greatest_size_allowed_are_solved() {
    case("heights_largest.csv", "0,0,0\n0,3e100,-3e100\n");
    let output =
        carom(&["solve", &case("heights_largest.toml", &under("heights_largest.csv", ""))]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn a_factor_of_friction_that_is_no_factor_is_told_with_its_place() {
    std::fs::write(fresh("factors.csv"), "1,1,1\n1,1,-0.5\n").unwrap();
    std::fs::write(fresh("flat.csv"), "0,0,0\n0,0,0\n").unwrap();
    let map = "friction = 0.3\nfriction_map = \"factors.csv\"\n";
    let case = case("factors.toml", &under("flat.csv", "").replace("friction = 0\n", map));
    let said = refusal(&["solve", &case]);
    assert!(said.contains("in row 2, column 3 is -0.5"), "{said}");
}

#[test]
fn a_tilted_map_is_told_where_it_is_solved() {
    std::fs::write(fresh("tilted.csv"), "0,1e-3,2e-3\n0,1.0001e-3,2e-3\n").unwrap();
    let output = carom(&["solve", &case("tilted.toml", &under("tilted.csv", ""))]);
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && told.contains("the map is tilted"), "{told}");
}

/// Under the six cells of a flat map, of 1 m² each, one is missing.
#[test]
fn a_missing_height_is_filled_or_has_no_contact() {
    std::fs::write(fresh("hole.csv"), "0,0,0\n0,nan,0\n").unwrap();
    for (word, area) in [("fill", 6.0), ("no contact", 5.0)] {
        let text = under("hole.csv", &format!("missing = \"{word}\"\n"));
        close(&json(&["solve", &case("hole.toml", &text)])[0]["contact_area"], area, 0.0);
    }
}
