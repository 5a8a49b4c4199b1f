//! Surface data files of ISO 25178-71, `.sdf`, text or binary, and of its predecessor BCR.

use crate::bytes::{Bytes, Number, latin};
use crate::error::SurfaceError;
use crate::format::{Format, Measured, Reading};
use crate::topography::Topography;

const NAME: &str = "sdf";

/// A version of the format.
#[derive(Clone, Copy, PartialEq)]
enum Version {
    Iso1,
    Iso2,
    Bcr,
}

/// The numbers in the head of a file.
#[derive(Debug, Default)]
struct Head {
    columns: usize,
    rows: usize,
    scales: [f64; 3],
    compression: u8,
    kind: u8,
    check: u8,
}

pub(crate) fn read(bytes: &[u8], reading: &Reading) -> Result<Measured, SurfaceError> {
    let version = match bytes.get(1..8) {
        Some(b"ISO-1.0") => Version::Iso1,
        Some(b"ISO-2.0") => Version::Iso2,
        Some(b"BCR-1.0") => Version::Bcr,
        _ => {
            let word = latin(bytes.get(..8).unwrap_or(bytes));
            let reason = format!("is of version {word:?}: must be ISO-1.0, ISO-2.0 or BCR-1.0");
            return Err(SurfaceError::unsupported(NAME, reason));
        }
    };
    let (head, heights) = match bytes[0] {
        b'b' => binary(bytes, version, reading)?,
        _ => written(&latin(&bytes[8..]), version, reading)?,
    };
    measured(&head, heights, version)
}

/// Head and numbers of a binary file.
fn binary(
    bytes: &[u8],
    version: Version,
    reading: &Reading,
) -> Result<(Head, Vec<f64>), SurfaceError> {
    let short = || SurfaceError::damaged(NAME, "it ends within its head");
    let all = Bytes(bytes);
    // Maker, two dates, counts, scales, three kinds.
    let counts = 8 + 10 + 12 + 12;
    let (columns, rows, begin) = match version {
        Version::Iso2 => (all.u32(counts), all.u32(counts + 4), counts + 8),
        _ => (all.u16(counts).map(u32::from), all.u16(counts + 2).map(u32::from), counts + 4),
    };
    let scale = |i: usize| all.f64(begin + 8 * i).ok_or_else(short);
    let word = |i: usize| bytes.get(begin + 32 + i).copied().ok_or_else(short);
    let head = Head {
        columns: columns.ok_or_else(short)? as usize,
        rows: rows.ok_or_else(short)? as usize,
        scales: [scale(0)?, scale(1)?, scale(2)?],
        compression: word(0)?,
        kind: word(1)?,
        check: word(2)?,
    };
    head.check()?;
    let points = reading.check(head.columns, head.rows)?;
    let number = number(head.kind)?;
    let data = begin + 35;
    let block = bytes.get(data..data + points * number.size()).ok_or_else(|| {
        SurfaceError::damaged(
            NAME,
            format!("it ends within its heights, of which there are {points}"),
        )
    })?;
    Ok((head, number.block(block, false)))
}

/// Head and numbers of a text. Its parts end with a `*` on a line of its own.
fn written(
    text: &str,
    version: Version,
    reading: &Reading,
) -> Result<(Head, Vec<f64>), SurfaceError> {
    let mut head = Head::default();
    let mut seen = 0_u32;
    let mut lines = text.lines().enumerate().skip(1);
    for (at, line) in lines.by_ref() {
        let line = uncommented(line, version);
        if line == "*" {
            break;
        }
        if !line.is_empty() {
            seen |= head.take(line, at + 1)?;
        }
    }
    if seen != ALL_FIELDS {
        let missing = FIELDS.iter().zip(0..).find(|(_, bit)| seen & (1 << bit) == 0);
        let name = missing.map_or("", |(name, _)| *name);
        return Err(SurfaceError::damaged(NAME, format!("`{name}` is missing in its head")));
    }
    head.check()?;
    let points = reading.check(head.columns, head.rows)?;
    let mut heights = Vec::new();
    for (at, line) in lines {
        let line = uncommented(line, version);
        if line == "*" {
            break;
        }
        for (place, found) in line.split_whitespace().enumerate() {
            // Some end the heights on their last line.
            if found == "*" && heights.len() == points {
                break;
            }
            if heights.len() == points {
                return Err(SurfaceError::damaged(
                    NAME,
                    format!("line {}: it has more than {points} heights", at + 1),
                ));
            }
            heights.push(height(found, at + 1, place + 1)?);
        }
    }
    if heights.len() != points {
        let reason = format!("it has {} heights: must have {points}", heights.len());
        return Err(SurfaceError::damaged(NAME, reason));
    }
    Ok((head, heights))
}

/// A line without the comment that BCR allows.
fn uncommented(line: &str, version: Version) -> &str {
    let kept = if version == Version::Bcr { line.split(';').next().unwrap_or("") } else { line };
    kept.trim()
}

fn height(found: &str, line: usize, column: usize) -> Result<f64, SurfaceError> {
    if ["bad", "nan"].iter().any(|word| found.eq_ignore_ascii_case(word)) {
        return Ok(f64::NAN);
    }
    let wrong =
        || SurfaceError::Value { line, column, found: crate::text::shortened(found), hint: "" };
    found.parse().ok().filter(|height: &f64| height.is_finite()).ok_or_else(wrong)
}

/// The fields that a file must have.
const FIELDS: [&str; 6] = ["NumPoints", "NumProfiles", "Xscale", "Yscale", "Zscale", "DataType"];
const ALL_FIELDS: u32 = (1 << FIELDS.len()) - 1;

impl Head {
    /// Takes a line `name = value`; returns the bit of its field.
    fn take(&mut self, line: &str, at: usize) -> Result<u32, SurfaceError> {
        let wrong = |what: &str| SurfaceError::damaged(NAME, format!("line {at}: {what}"));
        let (name, value) = line.split_once('=').ok_or_else(|| wrong("must be `name = value`"))?;
        let (name, value) = (name.trim(), value.trim());
        let number =
            || value.parse::<f64>().map_err(|_| wrong(&format!("`{name}` is not a number")));
        let count = || {
            value.parse::<usize>().map_err(|_| wrong(&format!("`{name}` is not a whole number")))
        };
        let code = |words: &[(&str, u8)]| {
            let named = words.iter().find(|(word, _)| word.eq_ignore_ascii_case(value));
            let code = named.map(|(_, code)| *code).or_else(|| value.parse().ok());
            code.ok_or_else(|| wrong(&format!("`{name}` = {value:?} is not known")))
        };
        match name.to_ascii_lowercase().as_str() {
            "numpoints" => self.columns = count()?,
            "numprofiles" => self.rows = count()?,
            "xscale" => self.scales[0] = number()?,
            "yscale" => self.scales[1] = number()?,
            "zscale" => self.scales[2] = number()?,
            "datatype" => self.kind = code(KINDS)?,
            "compression" => self.compression = code(NONE)?,
            "checktype" => self.check = code(NONE)?,
            _ => {}
        }
        let place = FIELDS.iter().position(|field| field.eq_ignore_ascii_case(name));
        Ok(place.map_or(0, |place| 1 << place))
    }

    fn check(&self) -> Result<(), SurfaceError> {
        let unfit = |what: &str| Err(SurfaceError::unsupported(NAME, what.to_owned()));
        if self.compression != 0 {
            return unfit("is compressed: save it without compression");
        }
        if self.check != 0 {
            return unfit("has check sums between its heights: save it without them");
        }
        let [x, y, z] = self.scales;
        if ![x, y, z].iter().all(|scale| scale.is_finite() && *scale > 0.0) {
            let reason = format!("Xscale, Yscale, Zscale = {x}, {y}, {z}: must be finite and > 0");
            return Err(SurfaceError::damaged(NAME, reason));
        }
        Ok(())
    }
}

const KINDS: &[(&str, u8)] = &[
    ("UCHAR", 0),
    ("UINTEGER", 1),
    ("ULONGINT", 2),
    ("FLOAT", 3),
    ("CHAR", 4),
    ("INTEGER", 5),
    ("LONGINT", 6),
    ("DOUBLE", 7),
];
const NONE: &[(&str, u8)] = &[("NULL", 0), ("NONE", 0)];

fn number(kind: u8) -> Result<Number, SurfaceError> {
    Ok(match kind {
        0 => Number::U8,
        1 => Number::U16,
        2 => Number::U32,
        3 => Number::F32,
        4 => Number::I8,
        5 => Number::I16,
        6 => Number::I32,
        7 => Number::F64,
        _ => return Err(SurfaceError::damaged(NAME, format!("DataType = {kind}: must be 0 to 7"))),
    })
}

/// Whether a number stands for a missing point. ISO takes the least number of a type (of unsigned ones, which it does not
/// have, the greatest, as other readers do), BCR the greatest.
fn is_missing(value: f64, kind: u8, version: Version) -> bool {
    let is_bcr = version == Version::Bcr;
    match kind {
        0 => value == f64::from(u8::MAX),
        1 => value == f64::from(u16::MAX),
        2 => value == f64::from(u32::MAX),
        3 if is_bcr => value >= 3.4e38,
        7 if is_bcr => value >= 1.7e308,
        // Texts have them with fewer digits.
        3 => value <= -3.4e38,
        7 => value <= -1.7e308,
        4 => value == f64::from(if is_bcr { i8::MAX } else { i8::MIN }),
        5 => value == f64::from(if is_bcr { i16::MAX } else { i16::MIN }),
        _ => value == f64::from(if is_bcr { i32::MAX } else { i32::MIN }),
    }
}

fn measured(
    head: &Head,
    mut heights: Vec<f64>,
    version: Version,
) -> Result<Measured, SurfaceError> {
    let [x, y, z] = head.scales;
    number(head.kind)?;
    for height in &mut heights {
        *height = if is_missing(*height, head.kind, version) { f64::NAN } else { *height * z };
    }
    if version == Version::Bcr {
        heights = heights.chunks_exact(head.columns).rev().flatten().copied().collect();
    }
    Ok(Measured {
        topography: Topography::new(head.columns, heights)?.spaced(Some([x, y])),
        format: Format::Sdf,
        has_unit: true,
        notes: Vec::new(),
    })
}
