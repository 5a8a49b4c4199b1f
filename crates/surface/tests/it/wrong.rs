//! Files that are no maps, or damaged: each is refused with its reason, before anything is allocated for what it claims.

use crate::files::{Sur, Xml, archive, doubles, sdf};
use carom_drawn::{Draw as _, Xorshift};
use carom_surface::{Reading, SurfaceError, read};

#[track_caller]
fn refused(bytes: &[u8], part: &str) {
    match read(bytes, &Reading::default()) {
        Ok(_) => panic!("read, though {part}"),
        Err(error) => assert!(error.to_string().contains(part), "{part:?} is not in: {error}"),
    }
}

#[test]
fn files_of_other_programs_are_named() {
    for (begin, name) in [
        (&b"II*\0rest"[..], "TIFF"),
        (b"MM\0*rest", "TIFF"),
        (b"\x89HDF\r\n", "HDF5"),
        (b"CDF\x01", "NetCDF"),
        (b"GWYPdata", "Gwyddion"),
        (b"AliconaImaging\0", "Alicona"),
        (b"\xff\xd8\xff\xe0", "JPEG"),
        (b"%PDF-1.4", "PDF"),
        (b"{\"a\": 1}", "JSON"),
        (b"<?xml version", "XML"),
        (b"\0\x01\x02 something", "binary file is not read"),
    ] {
        refused(begin, name);
        refused(begin, "SurfaceTopography");
    }
}

#[test]
fn texts_without_heights_are_refused() {
    refused(b"", "it is empty");
    refused(b"\n \n\t\n", "it is empty");
    refused(b"# only a comment\n", "no line has numbers alone");
    refused(b"nan nan\nnan nan\n", "no line has numbers alone");
    refused(b"name,place\nball,floor\n", "line 1, column 1: `name`");
    refused(b"1,2\n3,4,5\n", "line 2 has 3 values, line 1 has 2");
    refused(b"7 2\n1 2 3\n4 5 6\n", "line 2 has 3 values, line 1 has 2");
    refused(b"1 2\n3 1e999\n", "line 2, column 2");
    refused(b"1 2\n3 4 # five\n", "line 2");
}

#[test]
fn damaged_x3p_is_refused() {
    let heights = doubles(&[1e-6; 6]);
    let xml = Xml::default();
    let whole = xml.file(&heights);
    for end in [4, 30, whole.len() / 2, whole.len() - 1] {
        refused(&whole[..end], "x3p file is damaged");
    }
    refused(&archive(&[("a.txt", b"1")]), "has no main.xml");
    refused(&archive(&[("a.npy", b"1")]), "save one array as .npy");
    refused(&archive(&[("main.xml", b"<a>")]), "main.xml");
    refused(&archive(&[("main.xml", b"<a/>")]), "Record1/FeatureType is missing");
    refused(&archive(&[("main.xml", xml.text().as_bytes())]), "bindata/data.bin is not in it");
    refused(&xml.file(&heights[1..]), "has 47 bytes: must have 48");
    refused(&xml.file(&[&heights[..], &[0]].concat()), "longer than the 48 bytes");
    for (from, to, part) in [
        ("SUR", "PRF", "holds PRF"),
        ("<CX><AxisType>I", "<CX><AxisType>A", "must be I, equal steps"),
        ("<SizeZ>1", "<SizeZ>2", "has 2 layers"),
        ("<SizeX>3", "<SizeX>three", "`three` is not a whole number"),
        ("<SizeX>3", "<SizeX>-3", "`-3` is not a whole number"),
        ("<SizeX>3", "<SizeX>0", "there is no height"),
        ("<SizeX>3", "<SizeX>4000000000", "points: at most"),
        ("2e-6", "0", "must be > 0"),
        ("2e-6", "two", "`two` is not a number"),
        ("3e-6", "inf", "`inf` is not a number"),
        ("<DataType>D</DataType></CZ>", "<DataType>Q</DataType></CZ>", "must be I, L, F or D"),
        ("D</DataType></CZ>", "D</DataType><Increment>0</Increment></CZ>", "must not be 0"),
        ("DataLink", "DataLnk", "neither DataLink nor DataList"),
    ] {
        let text = xml.text().replace(from, to);
        assert_ne!(text, xml.text(), "{from}");
        refused(&archive(&[("main.xml", text.as_bytes()), ("bindata/data.bin", &heights)]), part);
    }
    let list = Xml { data: "<DataList><Datum>1</Datum></DataList>".to_owned(), ..Xml::default() };
    refused(&archive(&[("main.xml", list.text().as_bytes())]), "lists 1 heights: must list 6");
    let list = Xml {
        data: format!("<DataList>{}</DataList>", "<Datum>x</Datum>".repeat(6)),
        ..Xml::default()
    };
    refused(&archive(&[("main.xml", list.text().as_bytes())]), "Datum 1 is `x`");
}

/// Entities that grow, and an archive whose entry is longer than the head of the map allows.
#[test]
fn x3p_that_grows_is_refused() {
    let grows = "<!DOCTYPE a [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;\">]><a>&b;</a>";
    refused(&archive(&[("main.xml", grows.as_bytes())]), "main.xml");
    let long = vec![0; 4 << 20];
    let file = Xml::default().file(&long);
    assert!(file.len() < 1 << 16);
    refused(&file, "longer than the 48 bytes");
}

#[test]
fn damaged_sur_is_refused() {
    let whole = Sur::new(32).file();
    refused(&whole[..500], "ends within its head");
    refused(&whole[..515], "ends within its head");
    refused(&whole[..whole.len() - 1], "ends within its heights, of which there are 6");
    let word = |place: usize, value: i16, part: &str| {
        let mut sur = Sur::new(32);
        sur.word(place, value);
        refused(&sur.file(), part);
    };
    word(12, 257, "byte order 257");
    word(14, 3, "holds 3 surfaces");
    word(18, 12, "content of kind 12");
    word(98, 24, "24 bits per point");
    let number = |place: usize, value: i32, part: &str| {
        let mut sur = Sur::new(32);
        sur.put(place, &value.to_le_bytes());
        refused(&sur.file(), part);
    };
    number(108, -3, "-3 x 2 points");
    number(108, 2_000_000_000, "points: at most");
    number(120, 0, "must be finite and > 0");
    let mut sur = Sur::new(32);
    sur.put(212, b"V\0");
    refused(&sur.file(), "must be lengths");
    let packed = Sur::new(32).compressed();
    for end in [524, 530, packed.len() - 3] {
        refused(&packed[..end], "not whole");
    }
}

#[test]
fn damaged_sdf_is_refused() {
    let whole = sdf("ISO-1.0", 7, &doubles(&[1.0; 6]));
    refused(&whole[..60], "ends within its head");
    refused(&whole[..whole.len() - 1], "ends within its heights, of which there are 6");
    refused(&sdf("ISO-3.0", 7, &[]), "version \"bISO-3.0\"");
    refused(&sdf("ISO-1.0", 8, &[0; 99]), "DataType = 8");
    let mut packed = whole.clone();
    packed[78] = 1;
    refused(&packed, "is compressed");
    packed[78] = 0;
    packed[80] = 1;
    refused(&packed, "check sums");
    let head = "aISO-1.0\nNumPoints = 2\nNumProfiles = 1\nXscale = 1e-6\nYscale = 1e-6\nZscale = 1e-6\nDataType = 7\n*\n";
    refused(format!("{head}1 2 3\n*\n").as_bytes(), "line 9: it has more than 2 heights");
    refused(format!("{head}1\n*\n").as_bytes(), "it has 1 heights: must have 2");
    refused(format!("{head}1 two\n*\n").as_bytes(), "line 9, column 2: `two`");
    refused(head.replace("Zscale = 1e-6\n", "").as_bytes(), "`Zscale` is missing");
    refused(head.replace("Zscale = 1e-6", "Zscale = 0").as_bytes(), "must be finite and > 0");
    refused(
        head.replace("NumPoints = 2", "NumPoints = 2.5").as_bytes(),
        "`NumPoints` is not a whole number",
    );
    refused(head.replace("DataType = 7", "DataType").as_bytes(), "must be `name = value`");
}

#[test]
fn a_unit_that_a_file_states_is_not_given_again() {
    let unit = Reading { unit: Some(1e-6), ..Reading::default() };
    let error = read(&Sur::new(16).file(), &unit).unwrap_err();
    assert!(matches!(error, SurfaceError::Option { option: "unit", .. }), "{error}");
}

#[test]
fn another_size_is_refused_before_the_heights_are_read() {
    let size = Reading { size: Some([2, 3]), ..Reading::default() };
    for bytes in [Sur::new(16).file(), sdf("ISO-1.0", 7, &[]), b"1 2 3\n4 5 6\n".to_vec()] {
        let error = read(&bytes, &size).unwrap_err();
        assert_eq!(error, SurfaceError::OtherSize { found: [3, 2], wanted: [2, 3] });
    }
}

/// A file cut or changed anywhere gives a map or an error, never a panic.
#[test]
fn changed_files_never_end_the_program() {
    let files = [
        Xml::default().file(&doubles(&[1e-6; 6])),
        Sur::new(32).file(),
        Sur::new(16).compressed(),
        sdf("ISO-2.0", 6, &[7; 24]),
        b"ncols 3\nnrows 2\ncellsize 1\n1 2 3\n4 5 6\n".to_vec(),
        b"x,y,z\n0,0,1\n0,1,2\n1,0,3\n1,1,4\n".to_vec(),
    ];
    let mut draw = Xorshift(88_172_645_463_325_252);
    let mut next = |below: usize| (draw.bits() % below as u64) as usize;
    for file in &files {
        for _ in 0..2000 {
            let mut changed = file.clone();
            for _ in 0..=next(3) {
                let place = next(changed.len());
                changed[place] = next(256) as u8;
            }
            changed.truncate(changed.len() - next(8).min(next(changed.len())));
            let _ = read(&changed, &Reading { most_points: 1 << 16, ..Reading::default() });
        }
    }
}
