//! x3p of ISO 25178-72: a zip archive with `main.xml` and blocks of numbers.

use crate::bytes::{Number, latin};
use crate::error::SurfaceError;
use crate::format::{Format, Measured, Reading};
use crate::topography::Topography;
use roxmltree::{Document, Node};
use std::io::{Cursor, Read, Write as _};
use zip::result::ZipError;
use zip::write::SimpleFileOptions;
use zip::{DateTime, ZipArchive, ZipWriter};

const NAME: &str = "x3p";
/// Largest `main.xml`, in bytes: heights may stand in it as text.
const MOST_XML: u64 = 256 << 20;
/// The words of `Revision`, of 2017 and of the amendment of 2020.
const REVISIONS: [&str; 2] = ["ISO5436 - 2000", "ISO25178-72:2017/DAM1"];

type Archive<'a> = ZipArchive<Cursor<&'a [u8]>>;

fn damaged(reason: impl Into<String>) -> SurfaceError {
    SurfaceError::damaged(NAME, reason)
}

fn unfit(reason: impl Into<String>) -> SurfaceError {
    SurfaceError::unsupported(NAME, reason)
}

pub(crate) fn read(bytes: &[u8], reading: &Reading) -> Result<Measured, SurfaceError> {
    let mut archive =
        ZipArchive::new(Cursor::new(bytes)).map_err(|error| damaged(format!("{error}")))?;
    if archive.index_for_name("main.xml").is_none() {
        return Err(no_main(&archive));
    }
    let xml = latin(&entry(&mut archive, "main.xml", MOST_XML)?);
    let document = Document::parse(&xml).map_err(|error| damaged(format!("main.xml: {error}")))?;
    let head = Head::of(document.root_element())?;
    let points = reading.check(head.columns, head.rows)?;
    let mut notes = head.notes();
    let mut heights = match &head.data {
        Data::Block(name) => {
            let length = (points * head.number.size()) as u64;
            let block = entry(&mut archive, name, length)?;
            if block.len() as u64 != length {
                let found = block.len();
                return Err(damaged(format!("{name} has {found} bytes: must have {length}")));
            }
            notes.extend(head.check_sum(&block));
            head.number.block(&block, false)
        }
        Data::List(list) if list.len() == points => list.clone(),
        Data::List(list) => {
            return Err(damaged(format!("it lists {} heights: must list {points}", list.len())));
        }
    };
    heights.iter_mut().for_each(|height| *height = *height * head.increment + head.offset);
    // Some writers mark missing points by infinity.
    heights.iter_mut().filter(|height| height.is_infinite()).for_each(|height| *height = f64::NAN);
    if let Some(name) = &head.valid {
        let bits = entry(&mut archive, name, points.div_ceil(8) as u64)?;
        if bits.len() < points.div_ceil(8) {
            return Err(damaged(format!("{name} has too few bytes for {points} points")));
        }
        let is_valid = |place: usize| bits[place / 8] >> (place % 8) & 1 == 1;
        let missing = heights.iter_mut().enumerate().filter(|(place, _)| !is_valid(*place));
        missing.for_each(|(_, height)| *height = f64::NAN);
    }
    Ok(Measured {
        topography: Topography::new(head.columns, heights)?.spaced(Some(head.steps)),
        format: Format::X3p,
        has_unit: true,
        notes,
    })
}

fn no_main(archive: &Archive<'_>) -> SurfaceError {
    let is_numpy = archive.file_names().flatten().any(|name| name.ends_with(".npy"));
    match is_numpy {
        true => SurfaceError::unsupported("npz", "holds arrays of NumPy: save one array as .npy"),
        false => SurfaceError::unsupported("zip", "has no main.xml: is not x3p"),
    }
}

/// The content of an entry of at most `most` bytes; one byte more is refused before it is kept.
fn entry(archive: &mut Archive<'_>, name: &str, most: u64) -> Result<Vec<u8>, SurfaceError> {
    let name = name.trim_start_matches("./");
    let missing = |error: ZipError| match error {
        ZipError::FileNotFound => damaged(format!("{name} is not in it")),
        error => damaged(format!("{name}: {error}")),
    };
    let file = archive.by_name(name).map_err(missing)?;
    let too_long = || damaged(format!("{name} is longer than the {most} bytes that it must have"));
    if file.size() > most {
        return Err(too_long());
    }
    let mut bytes = Vec::new();
    let read = file.take(most + 1).read_to_end(&mut bytes);
    read.map_err(|error| damaged(format!("{name}: {error}")))?;
    if bytes.len() as u64 > most { Err(too_long()) } else { Ok(bytes) }
}

/// Where the heights are.
enum Data {
    Block(String),
    List(Vec<f64>),
}

/// What `main.xml` says.
struct Head {
    revision: String,
    columns: usize,
    rows: usize,
    steps: [f64; 2],
    number: Number,
    increment: f64,
    offset: f64,
    data: Data,
    check_sum: Option<String>,
    valid: Option<String>,
}

/// The first child with this name, whatever its namespace.
fn child<'a>(node: Node<'a, 'a>, name: &str) -> Option<Node<'a, 'a>> {
    node.children().find(|child| child.tag_name().name() == name)
}

/// The text at a path of names.
fn found<'a>(node: Node<'a, 'a>, path: &str) -> Option<&'a str> {
    let end = path.split('/').try_fold(node, child)?;
    Some(end.text().unwrap_or("").trim())
}

fn needed<'a>(node: Node<'a, 'a>, path: &str) -> Result<&'a str, SurfaceError> {
    found(node, path).ok_or_else(|| damaged(format!("{path} is missing in main.xml")))
}

fn number(node: Node<'_, '_>, path: &str, default: f64) -> Result<f64, SurfaceError> {
    let text = match found(node, path) {
        None | Some("") => return Ok(default),
        Some(text) => text,
    };
    let number = text.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| damaged(format!("{path} = `{text}` is not a number")))
}

fn count(node: Node<'_, '_>, path: &str) -> Result<usize, SurfaceError> {
    let text = needed(node, path)?;
    text.parse().map_err(|_| damaged(format!("{path} = `{text}` is not a whole number")))
}

impl Head {
    fn of(root: Node<'_, '_>) -> Result<Self, SurfaceError> {
        let kind = needed(root, "Record1/FeatureType")?;
        if kind != "SUR" {
            return Err(unfit(format!("holds {kind}: must be SUR, a surface on a grid")));
        }
        for axis in ["Record1/Axes/CX/AxisType", "Record1/Axes/CY/AxisType"] {
            let word = needed(root, axis)?;
            if word != "I" {
                return Err(unfit(format!("has {axis} = {word}: must be I, equal steps")));
            }
        }
        let layers = count(root, "Record3/MatrixDimension/SizeZ")?;
        if layers != 1 {
            return Err(unfit(format!("has {layers} layers: must have one")));
        }
        let step = |path: &str| match number(root, path, f64::NAN)? {
            step if step > 0.0 => Ok(step),
            step => Err(damaged(format!("{path} = {step}: must be > 0"))),
        };
        Ok(Self {
            revision: found(root, "Record1/Revision").unwrap_or("").to_owned(),
            columns: count(root, "Record3/MatrixDimension/SizeX")?,
            rows: count(root, "Record3/MatrixDimension/SizeY")?,
            steps: [step("Record1/Axes/CX/Increment")?, step("Record1/Axes/CY/Increment")?],
            number: Self::number(needed(root, "Record1/Axes/CZ/DataType")?)?,
            increment: match number(root, "Record1/Axes/CZ/Increment", 1.0)? {
                0.0 => return Err(damaged("Record1/Axes/CZ/Increment = 0: must not be 0")),
                increment => increment,
            },
            offset: number(root, "Record1/Axes/CZ/Offset", 0.0)?,
            data: Self::data(root)?,
            check_sum: found(root, "Record3/DataLink/MD5ChecksumPointData").map(str::to_owned),
            valid: found(root, "Record3/DataLink/ValidPointsLink")
                .filter(|name| !name.is_empty())
                .map(str::to_owned),
        })
    }

    fn number(word: &str) -> Result<Number, SurfaceError> {
        Ok(match word {
            "I" => Number::I16,
            "L" => Number::I32,
            "F" => Number::F32,
            "D" => Number::F64,
            _ => return Err(damaged(format!("CZ/DataType = `{word}`: must be I, L, F or D"))),
        })
    }

    fn data(root: Node<'_, '_>) -> Result<Data, SurfaceError> {
        if let Some(name) = found(root, "Record3/DataLink/PointDataLink") {
            return Ok(Data::Block(name.to_owned()));
        }
        let list = child(root, "Record3").and_then(|record| child(record, "DataList"));
        let list = list.ok_or_else(|| damaged("Record3 has neither DataLink nor DataList"))?;
        let datum = list.children().filter(|node| node.tag_name().name() == "Datum");
        let height = |(place, node): (usize, Node<'_, '_>)| {
            let text = node.text().unwrap_or("").trim();
            // x, y and z of a point stand in one datum, separated by semicolons.
            let last = text.rsplit(';').next().unwrap_or("").trim();
            match last {
                "" => Ok(f64::NAN),
                last => last.parse().map_err(|_| {
                    damaged(format!("Datum {} is `{}`", place + 1, crate::text::shortened(text)))
                }),
            }
        };
        Ok(Data::List(datum.enumerate().map(height).collect::<Result<_, _>>()?))
    }

    fn notes(&self) -> Vec<String> {
        let is_known = REVISIONS.contains(&self.revision.as_str());
        let told = || {
            format!("the file is of revision `{}`; it was read as {}", self.revision, REVISIONS[1])
        };
        if is_known { Vec::new() } else { vec![told()] }
    }

    /// A note if the sum of the file is not that of its heights.
    fn check_sum(&self, block: &[u8]) -> Option<String> {
        let stated = self.check_sum.as_ref()?;
        let is_same = format!("{:x}", md5::compute(block)).eq_ignore_ascii_case(stated);
        (!is_same).then(|| "the check sum of the heights is not the one in main.xml".to_owned())
    }
}

/// Values on a grid as x3p, doubles, row by row; NaN where a point is missing. `comment` says what they are: the format
/// itself knows lengths in m alone.
///
/// ```
/// use carom_surface::{Reading, read, x3p};
/// let file = x3p(2, &[1e-6, 2e-6, f64::NAN, 4e-6], [1e-6, 2e-6], "heights")?;
/// let map = read(&file, &Reading::default())?.topography;
/// assert_eq!((map.missing(), map.spacing(), map.heights()[3]), (1, Some([1e-6, 2e-6]), 4e-6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`std::io::Error`] if the archive cannot be made.
pub fn x3p(
    columns: usize,
    values: &[f64],
    spacing: [f64; 2],
    comment: &str,
) -> Result<Vec<u8>, std::io::Error> {
    let block: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    let rows = values.len() / columns.max(1);
    let sum = format!("{:X}", md5::compute(&block));
    let xml = main_xml([columns, rows], spacing, &sum, comment);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let check = format!("{:x} *main.xml\n", md5::compute(&xml));
    for (name, bytes) in [
        ("main.xml", xml.as_bytes()),
        ("bindata/data.bin", &block),
        ("md5checksum.hex", check.as_bytes()),
    ] {
        archive
            .start_file(name, SimpleFileOptions::default().last_modified_time(DateTime::DEFAULT))?;
        archive.write_all(bytes)?;
    }
    Ok(archive.finish()?.into_inner())
}

fn main_xml(size: [usize; 2], spacing: [f64; 2], sum: &str, comment: &str) -> String {
    let [columns, rows] = size;
    let axis = |name: &str, kind: &str, step: f64| {
        format!(
            "<{name}><AxisType>{kind}</AxisType><DataType>D</DataType><Increment>{step:e}</Increment>\
             <Offset>0</Offset></{name}>"
        )
    };
    let axes = axis("CX", "I", spacing[0]) + &axis("CY", "I", spacing[1]) + &axis("CZ", "A", 1.0);
    let comment = comment.replace('&', "&amp;").replace('<', "&lt;");
    let instrument = "<Manufacturer>carom</Manufacturer><Model>carom</Model><Serial>none</Serial><Version>none</Version>";
    // No clock: the same values give the same file.
    let date = "1970-01-01T00:00:00Z";
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n\
         <p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n\
         <Record1><Revision>{}</Revision><FeatureType>SUR</FeatureType><Axes>{axes}</Axes></Record1>\n\
         <Record2><Date>{date}</Date><Instrument>{instrument}</Instrument>\
         <CalibrationDate>{date}</CalibrationDate>\
         <ProbingSystem><Type>Software</Type><Identification>none</Identification></ProbingSystem>\
         <Comment>{comment}</Comment></Record2>\n\
         <Record3><MatrixDimension><SizeX>{columns}</SizeX><SizeY>{rows}</SizeY><SizeZ>1</SizeZ></MatrixDimension>\
         <DataLink><PointDataLink>bindata/data.bin</PointDataLink>\
         <MD5ChecksumPointData>{sum}</MD5ChecksumPointData></DataLink></Record3>\n\
         <Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4>\n\
         </p:ISO5436_2>\n",
        REVISIONS[0]
    )
}
