//! Files of instruments, written here byte by byte from the descriptions of their formats.

use std::io::{Cursor, Write as _};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// Heights of 3 x 2 points, whole numbers from -30 to 50; none is missing.
pub(crate) const WHOLE: [i32; 6] = [-30, -10, 0, 7, 20, 50];

/// A zip archive.
pub(crate) fn archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries {
        archive.start_file(*name, SimpleFileOptions::default()).unwrap();
        archive.write_all(bytes).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

/// What a `main.xml` says, for 3 x 2 points with steps of 2 and 3 um.
pub(crate) struct Xml {
    pub(crate) revision: &'static str,
    pub(crate) z: &'static str,
    pub(crate) data: String,
}

impl Default for Xml {
    fn default() -> Self {
        let data =
            "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>".to_owned();
        Self { revision: "ISO5436 - 2000", z: "<DataType>D</DataType>", data }
    }
}

impl Xml {
    pub(crate) fn text(&self) -> String {
        let Self { revision, z, data } = self;
        let axis = |name: &str, step: &str| {
            format!(
                "<{name}><AxisType>I</AxisType><DataType>D</DataType><Increment>{step}</Increment><Offset>0</Offset>\
                 </{name}>"
            )
        };
        let axes = axis("CX", "2e-6") + &axis("CY", "3e-6");
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\
             <Record1><Revision>{revision}</Revision><FeatureType>SUR</FeatureType><Axes>{axes}<CZ>\
             <AxisType>A</AxisType>{z}</CZ></Axes></Record1><Record3><MatrixDimension><SizeX>3</SizeX><SizeY>2</SizeY>\
             <SizeZ>1</SizeZ></MatrixDimension>{data}</Record3></p:ISO5436_2>"
        )
    }

    /// The file with these bytes as heights.
    pub(crate) fn file(&self, block: &[u8]) -> Vec<u8> {
        archive(&[("main.xml", self.text().as_bytes()), ("bindata/data.bin", block)])
    }
}

/// Doubles as bytes.
pub(crate) fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

/// A file of Digital Surf with the heights [`WHOLE`] times 0.5 nm, steps of 2 and 3 um.
pub(crate) struct Sur {
    pub(crate) head: Vec<u8>,
    pub(crate) rest: Vec<u8>,
    pub(crate) data: Vec<u8>,
}

impl Sur {
    pub(crate) fn new(bits: i16) -> Self {
        let mut head = vec![0; 512];
        head[..12].copy_from_slice(b"DIGITAL SURF");
        let mut sur = Self { head, rest: b"a comment".to_vec(), data: Vec::new() };
        for (place, value) in [(14, 1), (16, 1), (18, 2), (86, 0), (98, bits), (334, 9)] {
            sur.word(place, value);
        }
        for (place, value) in [(100, -30), (104, 50), (108, 3), (112, 2), (116, 6)] {
            sur.put(place, &i32::to_le_bytes(value));
        }
        for (place, value) in [(120, 2.0), (124, 0.003), (128, 0.5)] {
            sur.put(place, &f32::to_le_bytes(value));
        }
        for (place, unit) in [(180, "\u{b5}m"), (196, "mm"), (212, "nm")] {
            let latin: Vec<u8> = unit.chars().map(|letter| letter as u8).collect();
            sur.put(place, &latin);
        }
        sur.data = match bits {
            16 => WHOLE.iter().flat_map(|height| (*height as i16).to_le_bytes()).collect(),
            _ => WHOLE.iter().flat_map(|height| height.to_le_bytes()).collect(),
        };
        sur
    }

    pub(crate) fn put(&mut self, place: usize, bytes: &[u8]) {
        self.head[place..place + bytes.len()].copy_from_slice(bytes);
    }

    pub(crate) fn word(&mut self, place: usize, value: i16) {
        self.put(place, &value.to_le_bytes());
    }

    pub(crate) fn file(&self) -> Vec<u8> {
        [&self.head[..], &self.rest, &self.data].concat()
    }

    /// The same, compressed in two streams.
    pub(crate) fn compressed(mut self) -> Vec<u8> {
        self.put(0, b"DSCOMPRESSED");
        let (first, second) = self.data.split_at(5);
        let packed = [first, second].map(|part| {
            let mut encoder =
                flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
            encoder.write_all(part).unwrap();
            (part.len(), encoder.finish().unwrap())
        });
        let mut data = 2_u32.to_le_bytes().to_vec();
        for (raw, stream) in &packed {
            data.extend((*raw as u32).to_le_bytes());
            data.extend((stream.len() as u32).to_le_bytes());
        }
        packed.iter().for_each(|(_, stream)| data.extend(stream));
        self.data = data;
        self.file()
    }
}

/// A binary sdf of 3 x 2 points of a kind, scale of z 0.5 nm.
pub(crate) fn sdf(version: &str, kind: u8, data: &[u8]) -> Vec<u8> {
    let mut bytes = format!("b{version}maker     010120260000010120260000").into_bytes();
    match version {
        "ISO-2.0" => [3_u32, 2].iter().for_each(|count| bytes.extend(count.to_le_bytes())),
        _ => [3_u16, 2].iter().for_each(|count| bytes.extend(count.to_le_bytes())),
    }
    bytes.extend(doubles(&[2e-6, 3e-6, 5e-10, -1.0]));
    bytes.extend([0, kind, 0]);
    bytes.extend(data);
    bytes
}
