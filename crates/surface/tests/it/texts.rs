//! Texts with any separator, decimal commas, heads, comments and lists of points.

use carom_surface::{Format, Measured, Reading, SurfaceError, read};

const NAN: f64 = f64::NAN;
const WANTED: [f64; 6] = [1.5, -2.25, NAN, 4.0, 5.125, 6.0];

fn map(text: &str) -> Measured {
    read(text.as_bytes(), &Reading::default()).unwrap_or_else(|error| panic!("{text:?}: {error}"))
}

#[track_caller]
fn assert_heights(measured: &Measured, wanted: [f64; 6]) {
    let found = &measured.topography;
    assert_eq!((found.columns(), found.rows()), (3, 2));
    for (one, other) in found.heights().iter().zip(wanted) {
        let is_same = (one - other).abs() <= 1e-12 * other.abs() || one.is_nan() && other.is_nan();
        assert!(is_same, "{:?} {wanted:?}", found.heights());
    }
}

#[test]
fn any_separator_and_decimal_commas() {
    for text in [
        "1.5,-2.25,nan\n4,5.125,6\n",
        "1.5,-2.25,\n4,5.125,6\n,",
        "1.5, -2.25, NaN\r\n4, 5.125, 6\r\n",
        "1.5;-2.25;\n4;5.125;6",
        "1,5;-2,25;--\n4;5,125;6\n",
        "1.5\t-2.25\tBAD\n4\t5.125\t6\n",
        "1,5\t-2,25\tnan\t\n4\t5,125\t6\t\n",
        "1.5 -2.25 ***\n\n4   5.125 6\n",
        "  1,5 -2,25 nan\n 4 5,125 6\n",
        "4 nan nan\r4 5 6\r"
            .replace("4 nan nan", "1.5 -2.25 masked")
            .replace("4 5 6", "4 5.125 6")
            .as_str(),
    ] {
        let text = text.strip_suffix("\n,").unwrap_or(text);
        assert_heights(&map(text), WANTED);
    }
    // A separator at the end of some rows only is before a missing point.
    assert_heights(&map("1.5;-2.25;\n4;5.125;6"), WANTED);
    assert_heights(&map("1.5;-2.25;6\n4;5.125;"), [1.5, -2.25, 6.0, 4.0, 5.125, NAN]);
    // Whole numbers in the first row do not hide that commas are decimal.
    assert_heights(&map("1;2;3\n4;5,5;6\n"), [1.0, 2.0, 3.0, 4.0, 5.5, 6.0]);
}

#[test]
fn heads_and_comments_are_no_heights() {
    let rows = "1.5\t-2.25\tnan\n4\t5.125\t6\n";
    for head in [
        "# a comment\n% another\n",
        "Instrument: none\nDate 2026-11-29\n\n",
        "height in um;\n",
        "Sample\t3\tsteel\n",
        "3 2\n",
        "2 3\n",
        "\"a\",\"b\",\"c\"\n",
        "row 1 2\n",
    ] {
        assert_heights(&map(&format!("{head}{rows}")), WANTED);
    }
    assert_heights(&map("1.5 -2.25 nan\n# between\n4 5.125 6\n"), WANTED);
}

/// The first row of a map may have no point that was measured.
#[test]
fn a_first_row_without_a_height_is_a_row() {
    for text in [
        "nan nan nan\n4 5.125 6\n",
        "nan,nan,nan\n4,5.125,6\n",
        "--\t--\t--\n4\t5,125\t6\n",
        ";;\n4;5,125;6\n",
    ] {
        assert_heights(&map(text), [NAN, NAN, NAN, 4.0, 5.125, 6.0]);
    }
}

#[test]
fn a_head_of_gwyddion_states_size_and_unit() {
    let text = "# Channel: Topography\n# Width: 6.0 \u{b5}m\n# Height: 6.0 um\n# Value units: nm\n1.5\t-2.25\tnan\n4\t5.125\t6\n";
    let latin: Vec<u8> = text.chars().map(|letter| letter as u8).collect();
    for bytes in [text.as_bytes().to_vec(), latin] {
        let measured = read(&bytes, &Reading::default()).unwrap();
        assert_heights(&measured, WANTED.map(|height| 1e-9 * height));
        let [x, y] = measured.topography.spacing().unwrap();
        assert!((x - 2e-6).abs() < 1e-18 && (y - 3e-6).abs() < 1e-18 && measured.has_unit);
    }
}

#[test]
fn a_head_names_any_unit_of_length() {
    for (units, metres) in [
        (&["m", "metre", "meters"][..], 1.0),
        (&["km"], 1e3),
        (&["cm"], 1e-2),
        (&["mm", "millimeter"], 1e-3),
        (&["um", "\u{b5}m", "\u{3bc}m", "micron"], 1e-6),
        (&["nm", "nanometre"], 1e-9),
        (&["A", "\u{c5}", "angstrom"], 1e-10),
        (&["pm"], 1e-12),
    ] {
        for unit in units {
            let text = format!("# Value units: {unit}\n1.5\t-2.25\tnan\n4\t5.125\t6\n");
            assert_heights(&map(&text), WANTED.map(|height| metres * height));
        }
    }
}

/// The first row of a grid of ESRI is the northernmost.
#[test]
fn a_grid_of_esri_begins_with_the_greatest_y() {
    let text = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 0.5\nNODATA_value -9999\n4 5.125 6\n1.5 -2.25 -9999\n";
    let unit = Reading { unit: Some(1e-6), ..Reading::default() };
    let measured = read(text.as_bytes(), &unit).unwrap();
    assert_heights(&measured, WANTED.map(|height| 1e-6 * height));
    assert_eq!(measured.topography.spacing(), Some([0.5e-6; 2]));
    let bare = map(text);
    assert!(bare.topography.spacing().is_none() && bare.notes[0].contains("cellsize of 0.5"));
    for (name, other) in [("ncols 3", "ncols 4"), ("nrows 2", "nrows 5")] {
        let cut = text.replace(name, other);
        let told = read(cut.as_bytes(), &unit).unwrap_err().to_string();
        assert!(told.contains(&format!("{} is {}", &other[..5], &other[6..])), "{told}");
    }
}

#[test]
fn a_list_of_points_in_any_order_is_a_map() {
    let text = "x [mm]\ty [mm]\tz [um]\n0.02\t0\t3\n0\t0.03\t4\n0\t0\t1.5\n0.01\t0\t-2.25\n0.01\t0.03\t5.125\n";
    let measured = map(text);
    assert_heights(&measured, [1.5e-6, -2.25e-6, 3e-6, 4e-6, 5.125e-6, NAN]);
    let [x, y] = measured.topography.spacing().unwrap();
    assert!((x - 1e-5).abs() < 1e-16 && (y - 3e-5).abs() < 1e-16);
    assert!(measured.has_unit && measured.format == Format::Points);
    // Without units of its own, one holds for all three columns.
    let unit = Reading { unit: Some(1e-6), ..Reading::default() };
    let measured = read(b"0,0,1\n1,0,2\n2,0,3\n0,1,4\n1,1,5\n2,1,6\n", &unit).unwrap();
    assert_heights(&measured, [1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 6e-6]);
    assert_eq!(measured.topography.spacing(), Some([1e-6, 1e-6]));
    let twice = b"0,0,1\n1,0,2\n0,1,3\n1,1,4\n1,0,5\n";
    let error = read(twice, &unit).unwrap_err().to_string();
    assert!(error.starts_with("line 5: ") && error.contains("line 2"), "{error}");
}

/// What a head says that is no length is told, not passed over.
#[test]
fn heads_that_name_no_length_are_told() {
    for (head, said) in [
        ("# Width: -3 um", "Width: -3 um"),
        ("# Height: 0 um", "Height: 0 um"),
        ("# Value units: V", "Value units: V"),
        ("cellsize 0", "cellsize 0"),
        ("cellsize nan", "cellsize nan"),
    ] {
        let found = map(&format!("{head}\n1.5 -2.25 3\n4 5.125 6\n"));
        assert!(found.notes.len() == 1 && found.notes[0].contains(said), "{:?}", found.notes);
    }
    assert!(map("# Height map of a gear\n1.5 -2.25 3\n4 5.125 6\n").notes.is_empty());
}

#[test]
fn another_unit_than_that_of_the_head_counts_and_is_told() {
    let text = b"# Value units: um\n1.5 -2.25 3\n4 5.125 6\n";
    let nanometre = Reading { unit: Some(1e-9), ..Reading::default() };
    let found = read(text, &nanometre).unwrap();
    assert_heights(&found, [1.5e-9, -2.25e-9, 3e-9, 4e-9, 5.125e-9, 6e-9]);
    assert!(found.notes.len() == 1 && found.notes[0].contains("1e-6"), "{:?}", found.notes);
    let same = Reading { unit: Some(1e-6), ..Reading::default() };
    assert!(read(text, &same).unwrap().notes.is_empty());
}

/// The labels that programs for tables write are no heights; numbers that only look like them are.
#[test]
fn numbers_of_rows_and_columns_are_no_heights() {
    let found = map(",0,1,2\n0,1.5,-2.25,\n1,4,5.125,6\n");
    assert_heights(&found, WANTED);
    assert!(found.notes[0].contains("number the others"));
    let heights = [NAN, 0.0, 1.0, 2.0, 0.0, 1.5, -2.25, 3.0, 2.0, 4.0, 5.125, 6.0];
    let found = map(",0,1,2\n0,1.5,-2.25,3\n2,4,5.125,6\n");
    assert!(found.notes.is_empty() && found.topography.columns() == 4);
    let same = |(h, w): (&f64, f64)| *h == w || h.is_nan() && w.is_nan();
    assert!(found.topography.heights().iter().zip(heights).all(same));
}

/// The unit of a head holds for its column alone; a unit that is given holds for all three.
#[test]
fn each_column_of_a_list_has_its_unit() {
    let text = "x [mm]\ty [um]\tz [pm]\n0\t0\t1\n1\t0\t2\n2\t0\t3\n0\t2\t4\n1\t2\t5\n2\t2\t6\n";
    let numbers = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    let metre = Reading { unit: Some(1.0), ..Reading::default() };
    for (reading, steps, z) in [(Reading::default(), [1e-3, 2e-6], 1e-12), (metre, [1.0, 2.0], 1.0)]
    {
        let measured = read(text.as_bytes(), &reading).unwrap();
        assert_heights(&measured, numbers.map(|height| z * height));
        let found = measured.topography.spacing().unwrap();
        assert!((0..2).all(|i| (found[i] / steps[i] - 1.0).abs() < 1e-12), "{found:?} {steps:?}");
    }
}

/// Places with few digits differ in the last of them.
#[test]
fn places_a_millionth_of_the_range_apart_are_one() {
    let measured = map(".1 0 1\n.2 0 2\n.3 0 3\n.1 1 4\n.2 1 5\n.30000001 1 6\n");
    assert_heights(&measured, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
}

/// Measured places scatter by up to a twentieth of a step; beyond that the list lies on no grid, and its heading says that it
/// is a list.
#[test]
fn places_that_scatter_are_a_map_while_they_lie_on_a_grid() {
    let list = |scatter: f64| {
        let point = |at: usize| {
            let off = [0.618, 0.755].map(|by| scatter * (2.0 * (by * at as f64).fract() - 1.0));
            let [x, y] = [2.0 * (at % 7) as f64 + off[0], 3.0 * (at / 7) as f64 + off[1]];
            format!("{x} {y} {at}\n")
        };
        format!("x y z\n{}", (0..35).map(point).collect::<String>())
    };
    for scatter in [0.0, 1e-4, 0.05] {
        let found = map(&list(scatter)).topography;
        let [x, y] = found.spacing().unwrap();
        assert!((x - 2.0).abs() < scatter + 1e-12 && (y - 3.0).abs() < scatter + 1e-12);
        assert!(found.heights().iter().enumerate().all(|(at, height)| *height == at as f64));
    }
    let error = read(list(0.6).as_bytes(), &Reading::default()).unwrap_err().to_string();
    assert!(error.starts_with("line 2: ") && error.contains("no regular grid"), "{error}");
}

/// A list on a diagonal would be a map of which 19 of 20 points are missing.
#[test]
fn scattered_points_are_no_map() {
    let text: String = (0..20).map(|i| format!("{i} {i} {}\n", 7 * i % 5)).collect();
    let found = map(&text).topography;
    assert_eq!((found.columns(), found.rows(), found.missing()), (3, 20, 0));
}

/// Three columns that are no places are heights.
#[test]
fn three_columns_of_heights_are_no_points() {
    let measured = map("1 7 3\n4 5 9\n2 8 6\n7 7 1\n3 1 2\n");
    assert_eq!((measured.topography.columns(), measured.topography.rows()), (3, 5));
}

#[test]
fn utf_16_and_a_mark_of_utf_8_are_read() {
    let text = "1.5;-2.25;nan\n4;5.125;6\n";
    let wide = |order: fn(u16) -> [u8; 2], mark: [u8; 2]| -> Vec<u8> {
        mark.into_iter().chain(text.encode_utf16().flat_map(order)).collect()
    };
    for bytes in [
        wide(u16::to_le_bytes, [0xff, 0xfe]),
        wide(u16::to_be_bytes, [0xfe, 0xff]),
        [b"\xef\xbb\xbf", text.as_bytes()].concat(),
    ] {
        assert_heights(&read(&bytes, &Reading::default()).unwrap(), WANTED);
    }
}

#[test]
fn a_value_that_is_no_number_is_named_with_line_and_column() {
    for (text, line, column, found, hint) in [
        ("1,2,3\n4,x,6\n", 2, 2, "x", ""),
        ("# c\n\n1 2 3\n4 5 inf\n", 4, 3, "inf", "missing point"),
        ("1;2;3\n4;5.5.5;6\n", 2, 2, "5.5.5", ""),
        ("1\t2\t3\n1,234.5\t5\t6\n", 2, 1, "1,234.5", "thousands"),
        ("1 2 3\n4 5 6e\n", 2, 3, "6e", ""),
        ("a b\nc d\n", 1, 1, "a", ""),
        ("inf 2 3\n4 5 6\n7 8 9\n", 1, 1, "inf", "missing point"),
        ("1,234.5;2\n3;4\n", 1, 1, "1,234.5", "thousands"),
        ("1,234.5;2,000.1\n3;4\n", 1, 1, "1,234.5", "thousands"),
        ("1.234,5;2.000,1\n3,3;4,4\n5,1;6,2\n", 1, 1, "1.234,5", "thousands"),
        ("# c\n2 1D-6\n3 4\n", 2, 2, "1D-6", ""),
    ] {
        let error = read(text.as_bytes(), &Reading::default()).unwrap_err();
        let SurfaceError::Value { line: at, column: place, found: what, hint: told } = &error
        else {
            panic!("{text:?}: {error}");
        };
        assert_eq!((*at, *place, what.as_str()), (line, column, found), "{text:?}");
        assert!(told.contains(hint), "{told}");
    }
    let error = read(b"1,2,3\n4,5\n", &Reading::default()).unwrap_err();
    assert_eq!(error.to_string(), "line 2 has 2 values, line 1 has 3: every row must have as many");
    let long = format!("1,{}\n2,3\n4,{}\n", 5, "y".repeat(200));
    assert!(read(long.as_bytes(), &Reading::default()).unwrap_err().to_string().len() < 100);
}
