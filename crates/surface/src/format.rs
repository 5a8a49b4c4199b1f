//! The kinds of files and the door to all of them.

use crate::bytes::latin;
use crate::error::SurfaceError;
use crate::topography::Topography;
use crate::{npy, picture, sdf, sur, text, x3p};

/// A kind of file that holds a height map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// x3p of ISO 25178-72, also as its amendment of 2020 writes it.
    X3p,
    /// sur of Digital Surf, plain or compressed.
    Sur,
    /// sdf of ISO 25178-71, text or binary, and its predecessor BCR.
    Sdf,
    /// An array of NumPy.
    Npy,
    /// A picture in greys.
    Png,
    /// Rows of numbers.
    Text,
    /// A list of points x, y, z.
    Points,
}

impl Format {
    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::X3p => "x3p",
            Self::Sur => "sur",
            Self::Sdf => "sdf",
            Self::Npy => "npy",
            Self::Png => "PNG",
            Self::Text => "text",
            Self::Points => "points x, y, z",
        }
    }

    /// The kind of a file by its first bytes.
    ///
    /// # Errors
    /// [`SurfaceError::Unsupported`] for a file of another program, with what can be done.
    pub fn of(bytes: &[u8]) -> Result<Self, SurfaceError> {
        let begins = |mark: &[u8]| bytes.starts_with(mark);
        if let Some((_, format)) = MARKS.iter().find(|(mark, _)| begins(mark)) {
            return Ok(*format);
        }
        if let Some((_, name)) = FOREIGN.iter().find(|(mark, _)| begins(mark)) {
            return Err(SurfaceError::unsupported(name, CONVERT));
        }
        let is_wide = begins(&[0xff, 0xfe]) || begins(&[0xfe, 0xff]);
        if bytes.iter().take(1024).any(|byte| *byte == 0) && !is_wide {
            return Err(SurfaceError::unsupported("binary", CONVERT));
        }
        Ok(Self::Text)
    }
}

/// The first bytes of each kind.
const MARKS: &[(&[u8], Format)] = &[
    (b"PK\x03\x04", Format::X3p),
    (b"PK\x05\x06", Format::X3p),
    (b"DIGITAL SURF", Format::Sur),
    (b"DSCOMPRESSED", Format::Sur),
    (b"aISO-", Format::Sdf),
    (b"bISO-", Format::Sdf),
    (b"aBCR-", Format::Sdf),
    (b"bBCR-", Format::Sdf),
    (b"\x93NUMPY", Format::Npy),
    (b"\x89PNG", Format::Png),
];

/// The first bytes of files that are often heights, but are not read here.
const FOREIGN: &[(&[u8], &str)] = &[
    (b"II*\0", "TIFF"),
    (b"MM\0*", "TIFF"),
    (b"\x89HDF", "HDF5"),
    (b"CDF", "NetCDF"),
    (b"GWYP", "Gwyddion"),
    (b"GWYO", "Gwyddion"),
    (b"AliconaImaging", "Alicona"),
    (b"\xff\xd8\xff", "JPEG"),
    (b"%PDF", "PDF"),
    (b"{", "JSON"),
    (b"<?xml", "XML"),
];

const CONVERT: &str = "is not read here: save the heights as x3p, sur, sdf, npy, a PNG in greys or a text; the Python \
                       packages SurfaceTopography and surfalize read most instruments";

/// What a file does not say itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// Metres of a unit of heights (of a list of points also of x and y), for files that do not state it.
    pub unit: Option<f64>,
    /// Height of white over black in a picture, in m.
    pub range: Option<f64>,
    /// Columns and rows that the map must have; none for any.
    pub size: Option<[usize; 2]>,
    /// Largest number of points.
    pub most_points: usize,
}

impl Default for Reading {
    fn default() -> Self {
        Self { unit: None, range: None, size: None, most_points: 1 << 29 }
    }
}

impl Reading {
    /// Checks a size before anything is allocated for it.
    pub(crate) fn check(&self, columns: usize, rows: usize) -> Result<usize, SurfaceError> {
        if let Some(wanted) = self.size.filter(|wanted| *wanted != [columns, rows]) {
            return Err(SurfaceError::OtherSize { found: [columns, rows], wanted });
        }
        self.check_count(columns, rows)
    }

    /// Checks a number of points that may still grow.
    pub(crate) fn check_count(&self, columns: usize, rows: usize) -> Result<usize, SurfaceError> {
        let points = columns.checked_mul(rows).filter(|points| *points <= self.most_points);
        let most = self.most_points;
        match points {
            Some(0) => Err(SurfaceError::Empty { hint: "" }),
            Some(points) => Ok(points),
            None => Err(SurfaceError::TooMany { columns, rows, most }),
        }
    }
}

/// A height map and what its file says about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The heights in m.
    pub topography: Topography,
    /// The kind of file.
    pub format: Format,
    /// Whether the file, or [`Reading::unit`], says what its heights are measured in; otherwise they are taken as metres.
    pub has_unit: bool,
    /// What a user should know about the file.
    pub notes: Vec<String>,
}

/// Reads a height map. The kind of file is known by its first bytes, not by its name.
///
/// | file | heights | first row | missing |
/// |---|---|---|---|
/// | x3p | m, times increment plus offset of z | least y | NaN, `valid.bin`, an empty `Datum` |
/// | sur | by its units; negated if the file says inverted | least y | least value - 2, if flagged |
/// | sdf | m; times `Zscale` | least y; of BCR greatest y | least value of the type, of BCR the greatest; `BAD` |
/// | npy | [`Reading::unit`] | least y | NaN |
/// | PNG | grey levels, or [`Reading::range`] for white | greatest y | none |
/// | text | [`Reading::unit`], or the unit in its head | least y; ESRI greatest y | `nan`, `bad`, `--`, an empty cell, `NODATA_value` |
///
/// # Errors
/// [`SurfaceError`], with line and column of a text, before anything is allocated for a size that is too large.
pub fn read(bytes: &[u8], reading: &Reading) -> Result<Measured, SurfaceError> {
    let format = Format::of(bytes)?;
    let states_unit = matches!(format, Format::X3p | Format::Sur | Format::Sdf);
    if states_unit && reading.unit.is_some() {
        return Err(SurfaceError::Option {
            option: "unit",
            reason: "is not for x3p, sur and sdf, which state their unit; `scale` multiplies the heights",
        });
    }
    if format != Format::Png && reading.range.is_some() {
        return Err(SurfaceError::Option {
            option: "range",
            reason: "is for PNG alone: the height of white over black",
        });
    }
    match format {
        Format::X3p => x3p::read(bytes, reading),
        Format::Sur => sur::read(bytes, reading),
        Format::Sdf => sdf::read(bytes, reading),
        Format::Npy => npy::read(bytes, reading),
        Format::Png => picture::read(bytes, reading),
        Format::Text | Format::Points => text::read(&decoded(bytes), reading),
    }
}

/// A text in UTF-8, in UTF-16 with its mark, or else in ISO 8859-1.
pub(crate) fn decoded(bytes: &[u8]) -> String {
    let wide = |read: fn([u8; 2]) -> u16| {
        let units = bytes[2..].chunks_exact(2).map(|pair| read([pair[0], pair[1]]));
        char::decode_utf16(units)
            .map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect()
    };
    match bytes {
        [0xff, 0xfe, ..] => wide(u16::from_le_bytes),
        [0xfe, 0xff, ..] => wide(u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] => latin(rest),
        _ => latin(bytes),
    }
}
