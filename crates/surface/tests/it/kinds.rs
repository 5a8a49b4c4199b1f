//! Each kind of file gives the values, order, units and missing points that were written into it.

use crate::files::{Sur, WHOLE, Xml, archive, doubles, sdf};
use carom_surface::{Format, Measured, Reading, SurfaceError, npy, read, x3p};

const NAN: f64 = f64::NAN;

fn map(bytes: &[u8]) -> Measured {
    read(bytes, &Reading::default()).unwrap()
}

/// Compares heights in m, and the steps 2 and 3 um.
#[track_caller]
fn assert_map(measured: &Measured, format: Format, wanted: [f64; 6]) {
    let found = &measured.topography;
    assert_eq!((found.columns(), found.rows(), measured.format), (3, 2, format));
    for (one, other) in found.heights().iter().zip(wanted) {
        let is_same = (one - other).abs() <= 1e-15 * other.abs() || one.is_nan() && other.is_nan();
        assert!(is_same, "{:?} {wanted:?}", found.heights());
    }
    if let Some([x, y]) = found.spacing() {
        assert!((x - 2e-6).abs() < 1e-13 && (y - 3e-6).abs() < 1e-13, "{x} {y}");
    }
}

#[test]
fn x3p_of_both_revisions_has_doubles_and_missing_points() {
    let heights = [1e-6, 2e-6, NAN, 4e-6, -5e-6, 6e-6];
    for revision in ["ISO5436 - 2000", "ISO25178-72:2017/DAM1"] {
        let file = Xml { revision, ..Xml::default() }.file(&doubles(&heights));
        let measured = map(&file);
        assert_map(&measured, Format::X3p, heights);
        assert!(measured.topography.spacing().is_some() && measured.has_unit);
        assert_eq!(measured.notes, [""; 0]);
    }
    let infinite = [1e-6, 2e-6, f64::INFINITY, 4e-6, -5e-6, f64::NEG_INFINITY];
    let file = Xml::default().file(&doubles(&infinite));
    assert_map(&map(&file), Format::X3p, [1e-6, 2e-6, NAN, 4e-6, -5e-6, NAN]);
    let file = Xml { revision: "ISO 9", ..Xml::default() }.file(&doubles(&heights));
    assert!(map(&file).notes[0].contains("revision `ISO 9`"));
}

/// Whole numbers are signed; an increment and an offset make heights of them, and bits say which are valid, the first
/// point in the lowest bit.
#[test]
fn x3p_of_whole_numbers_has_increment_offset_and_valid_points() {
    let z = "<DataType>I</DataType><Increment>1e-9</Increment><Offset>5e-9</Offset>";
    let data = "<DataLink><PointDataLink>./bindata/data.bin</PointDataLink>\
                <ValidPointsLink>bindata/valid.bin</ValidPointsLink></DataLink>";
    let xml = Xml { z, data: data.to_owned(), ..Xml::default() };
    let block: Vec<u8> = WHOLE.iter().flat_map(|height| (*height as i16).to_le_bytes()).collect();
    let entries = [
        ("main.xml", xml.text().into_bytes()),
        ("bindata/data.bin", block),
        ("bindata/valid.bin", vec![0b10_1110]),
    ];
    let file = archive(&entries.each_ref().map(|(name, bytes)| (*name, &bytes[..])));
    assert_map(&map(&file), Format::X3p, [NAN, -5e-9, 5e-9, 1.2e-8, NAN, 5.5e-8]);
    // An empty link names no file: all points are valid.
    let data = xml.data.replace("bindata/valid.bin", "");
    let whole = Xml { data, ..xml }.file(&entries[1].1);
    assert_map(&map(&whole), Format::X3p, [-2.5e-8, -5e-9, 5e-9, 1.2e-8, 2.5e-8, 5.5e-8]);
    let z = "<DataType>L</DataType><Increment>2e-9</Increment>";
    let block: Vec<u8> = WHOLE.iter().flat_map(|height| height.to_le_bytes()).collect();
    let file = Xml { z, ..Xml::default() }.file(&block);
    assert_map(&map(&file), Format::X3p, [-6e-8, -2e-8, 0.0, 1.4e-8, 4e-8, 1e-7]);
}

#[test]
fn x3p_may_list_its_heights_as_text() {
    let datum = ["1e-6", "", "3e-6", "0;0;4e-6", " 5e-6 ", ""];
    let list: String = datum.map(|text| format!("<Datum>{text}</Datum>")).concat();
    let xml = Xml { data: format!("<DataList>{list}</DataList>"), ..Xml::default() };
    let file = archive(&[("main.xml", xml.text().as_bytes())]);
    assert_map(&map(&file), Format::X3p, [1e-6, NAN, 3e-6, 4e-6, 5e-6, NAN]);
}

#[test]
fn a_written_x3p_is_read_again_and_its_check_sum_is_right() {
    let heights = [1e-6, NAN, 3e-6, 4e-6, -5e-6, 6e-6];
    let file = x3p(3, &heights, [2e-6, 3e-6], "a < b & c").unwrap();
    assert_eq!(file, x3p(3, &heights, [2e-6, 3e-6], "a < b & c").unwrap());
    let measured = map(&file);
    assert_map(&measured, Format::X3p, heights);
    assert_eq!(measured.notes, [""; 0]);
    let data = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>\
                <MD5ChecksumPointData>00112233445566778899AABBCCDDEEFF</MD5ChecksumPointData></DataLink>";
    let file = Xml { data: data.to_owned(), ..Xml::default() }.file(&doubles(&heights));
    assert!(map(&file).notes[0].contains("check sum"));
}

#[test]
fn sur_has_units_of_its_own_and_flags_missing_points() {
    let wanted = WHOLE.map(|height| f64::from(height) * 5e-10);
    for bits in [16, 32] {
        assert_map(&map(&Sur::new(bits).file()), Format::Sur, wanted);
    }
    // After the comment of 9 bytes, 2 of the maker's own.
    let mut sur = Sur::new(16);
    sur.word(336, 2);
    sur.rest.extend([0x77, 0x77]);
    assert_map(&map(&sur.file()), Format::Sur, wanted);
    // The least height is -30, so that -32 is a missing point, if the file says that there are some.
    let mut sur = Sur::new(32);
    sur.data[8..12].copy_from_slice(&(-32_i32).to_le_bytes());
    let mut holes = wanted;
    holes[2] = -1.6e-8;
    assert_map(&map(&sur.file()), Format::Sur, holes);
    sur.word(86, 1);
    holes[2] = NAN;
    assert_map(&map(&sur.file()), Format::Sur, holes);
    // 4 units of 1 nm above the zero.
    sur.put(474, &4_f32.to_le_bytes());
    assert_map(&map(&sur.file()), Format::Sur, holes.map(|height| height + 4e-9));
    assert_map(&map(&Sur::new(32).compressed()), Format::Sur, wanted);
}

#[test]
fn inverted_sur_is_turned_back() {
    let wanted = WHOLE.map(|height| f64::from(height) * -5e-10);
    let [a, b, c, d, e, f] = wanted;
    for (inverted, wanted) in [(1, wanted), (2, [c, b, a, f, e, d]), (3, [d, e, f, a, b, c])] {
        let mut sur = Sur::new(16);
        sur.word(290, inverted);
        let measured = map(&sur.file());
        assert_map(&measured, Format::Sur, wanted);
        assert!(measured.notes[0].contains("inverted"));
    }
}

/// ISO marks a missing point by the least number of a type, BCR by the greatest; the first row of BCR has the greatest y.
#[test]
fn sdf_of_all_versions_and_types() {
    macro_rules! bytes {
        ($kind:ty, $missing:expr) => {{
            let missing: $kind = $missing;
            let all = [1.0, 2.0, 0.0, 3.0, 4.0, 5.0_f64].map(|value| value as $kind);
            let mut all = all.map(<$kind>::to_le_bytes);
            all[2] = missing.to_le_bytes();
            all.concat()
        }};
    }
    let straight = [5e-10, 1e-9, NAN, 1.5e-9, 2e-9, 2.5e-9];
    let turned = [1.5e-9, 2e-9, 2.5e-9, 5e-10, 1e-9, NAN];
    for (kind, least, most) in [
        (3, bytes!(f32, f32::MIN), bytes!(f32, f32::MAX)),
        (4, bytes!(i8, i8::MIN), bytes!(i8, i8::MAX)),
        (5, bytes!(i16, i16::MIN), bytes!(i16, i16::MAX)),
        (6, bytes!(i32, i32::MIN), bytes!(i32, i32::MAX)),
        (7, bytes!(f64, f64::MIN), bytes!(f64, f64::MAX)),
    ] {
        for version in ["ISO-1.0", "ISO-2.0"] {
            assert_map(&map(&sdf(version, kind, &least)), Format::Sdf, straight);
        }
        assert_map(&map(&sdf("BCR-1.0", kind, &most)), Format::Sdf, turned);
    }
    for (kind, most) in
        [(0, bytes!(u8, 255)), (1, bytes!(u16, u16::MAX)), (2, bytes!(u32, u32::MAX))]
    {
        assert_map(&map(&sdf("BCR-1.0", kind, &most)), Format::Sdf, turned);
        assert_map(&map(&sdf("ISO-1.0", kind, &most)), Format::Sdf, straight);
    }
    assert_map(&map(&sdf("ISO-1.0", 7, &bytes!(f64, f64::NAN))), Format::Sdf, straight);
}

#[test]
fn sdf_as_text_has_words_and_comments_where_bcr_allows_them() {
    let head = "\r\nManufacID = maker\r\nNumPoints = 3\r\nNumProfiles = 2\r\nXscale = 2E-6\r\nYscale = 3e-6\r\n\
                Zscale = 5e-10\r\nCompression = 0\r\nDataType = 5\r\nCheckType = 0\r\n*\r\n1 2 BAD\r\n3 4\r\n5\r\n*\r\n";
    let straight = [5e-10, 1e-9, NAN, 1.5e-9, 2e-9, 2.5e-9];
    let turned = [1.5e-9, 2e-9, 2.5e-9, 5e-10, 1e-9, NAN];
    for version in ["ISO-1.0", "ISO-2.0"] {
        assert_map(&map(format!("a{version}{head}").as_bytes()), Format::Sdf, straight);
    }
    let bcr = head
        .replace("= 5\r", "= INTEGER ; 16 bits\r")
        .replace("Compression = 0", "Compression = NULL");
    assert_map(&map(format!("aBCR-1.0{bcr}").as_bytes()), Format::Sdf, turned);
    let least = format!("aISO-1.0{}", head.replace("BAD", "-32768"));
    assert_map(&map(least.as_bytes()), Format::Sdf, straight);
    for (kind, least) in [("FLOAT", "-3.4028235E+38"), ("DOUBLE", "-1.797693e308")] {
        let text = head.replace("= 5\r", &format!("= {kind}\r")).replace("BAD", least);
        assert_map(&map(format!("aISO-1.0{text}").as_bytes()), Format::Sdf, straight);
    }
    let ended = format!("aISO-1.0{}", head.replace("\r\n5\r\n*\r\n", "\r\n5 *\r\n"));
    assert_map(&map(ended.as_bytes()), Format::Sdf, straight);
}

#[test]
fn npy_has_the_unit_that_is_given() {
    let values = [1.0, NAN, 3.0, 4.0, 5.0, 6.0];
    let file = npy("<f8", &[2, 3], values.iter().flat_map(|value| value.to_le_bytes()));
    // Its data begin at a multiple of 64 bytes, as NumPy maps them.
    assert!((file.len() - 48).is_multiple_of(64));
    let measured = map(&file);
    assert!(!measured.has_unit && measured.topography.spacing().is_none());
    let unit = Reading { unit: Some(1e-6), ..Reading::default() };
    let measured = read(&file, &unit).unwrap();
    assert_map(&measured, Format::Npy, [1e-6, NAN, 3e-6, 4e-6, 5e-6, 6e-6]);
    assert!(measured.has_unit);
}

#[test]
fn numbers_of_numpy_have_any_kind_and_order() {
    let array = |descr: &str, order: &str, values: &[u8]| {
        let head = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': (2, 3), }}\n");
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((head.len() as u16).to_le_bytes());
        bytes.extend(head.as_bytes());
        bytes.extend(values);
        bytes
    };
    let wanted = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
    let by_columns = [1.0, 4.0, 2.0, 5.0, 3.0, 6.0_f64];
    let f4: Vec<u8> = wanted.iter().flat_map(|value| (*value as f32).to_le_bytes()).collect();
    let f8: Vec<u8> = by_columns.iter().flat_map(|value| value.to_be_bytes()).collect();
    let u2: Vec<u8> = wanted.iter().flat_map(|value| (*value as u16).to_be_bytes()).collect();
    let i8: Vec<u8> = wanted.iter().flat_map(|value| (*value as i64).to_le_bytes()).collect();
    for file in [
        array("<f4", "False", &f4),
        array(">f8", "True", &f8),
        array(">u2", "False", &u2),
        array("<i8", "False", &i8),
        array("|u1", "False", &[1, 2, 3, 4, 5, 6]),
    ] {
        assert_map(&map(&file), Format::Npy, wanted);
        // Versions 2 and 3 give the length of the head in four bytes.
        for version in [2, 3] {
            let begin = [b"\x93NUMPY", &[version, 0, file[8], file[9], 0, 0][..]].concat();
            assert_map(&map(&[&begin, &file[10..]].concat()), Format::Npy, wanted);
        }
    }
}

/// The lowest line of a picture is the first row of the map.
#[test]
fn a_png_has_the_height_of_white() {
    let encode = |depth, bytes: &[u8]| {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, 3, 2);
        encoder.set_color(png::ColorType::Grayscale);
        encoder.set_depth(depth);
        encoder.write_header().unwrap().write_image_data(bytes).unwrap();
        file
    };
    let eight = encode(png::BitDepth::Eight, &[255, 0, 51, 102, 153, 204]);
    let white = Reading { range: Some(5e-6), ..Reading::default() };
    let measured = read(&eight, &white).unwrap();
    assert_map(&measured, Format::Png, [2e-6, 3e-6, 4e-6, 5e-6, 0.0, 1e-6]);
    assert!(measured.has_unit && measured.notes.is_empty());
    // 65535, 0, 51, 256, 2 and 4660, the greater byte first.
    let sixteen = [0xff, 0xff, 0, 0, 0, 0x33, 1, 0, 0, 2, 0x12, 0x34];
    let white = Reading { range: Some(65535e-6), ..white };
    let measured = read(&encode(png::BitDepth::Sixteen, &sixteen), &white).unwrap();
    assert_map(&measured, Format::Png, [256e-6, 2e-6, 4660e-6, 65535e-6, 0.0, 51e-6]);
    let levels = map(&eight);
    assert_map(&levels, Format::Png, [102.0, 153.0, 204.0, 255.0, 0.0, 51.0]);
    assert!(levels.notes[0].contains("range"), "{:?}", levels.notes);
    let error = read(&npy("<f8", &[1, 1], 1.0_f64.to_le_bytes().into_iter()), &white).unwrap_err();
    assert!(matches!(error, SurfaceError::Option { option: "range", .. }));
}
