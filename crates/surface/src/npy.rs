//! Arrays of NumPy, `.npy`. For the one line of a head the crate npyz would add 12 packages, one of them assembler.

use crate::bytes::Number;
use crate::error::SurfaceError;
use crate::format::{Format, Measured, Reading};
use crate::topography::Topography;

const NAME: &str = "npy";

fn broken() -> SurfaceError {
    SurfaceError::damaged(NAME, "its head and its length do not fit together")
}

/// An array with two axes, of floating-point or whole numbers, in either byte order and either order of the axes; its
/// first axis is y.
pub(crate) fn read(bytes: &[u8], reading: &Reading) -> Result<Measured, SurfaceError> {
    let Npy { kind, shape, by_columns, values } = Npy::of(bytes).ok_or_else(broken)?;
    let unfit = |reason| SurfaceError::unsupported(NAME, reason);
    let descr = kind.ok_or_else(|| unfit("has fields: must be plain numbers".to_owned()))?;
    let (order, kind) = descr.split_at_checked(1).ok_or_else(broken)?;
    let number = number(kind)
        .ok_or_else(|| unfit(format!("has numbers of kind {kind}: must be f4, f8 or integers")))?;
    let [rows, columns] = shape[..] else {
        return Err(unfit(format!("has {} axes: must have two, y and x", shape.len())));
    };
    let points = reading.check(columns, rows)?;
    if points.checked_mul(number.size()) != Some(values.len()) {
        return Err(broken());
    }
    let mut heights = number.block(values, order == ">");
    if by_columns {
        let turned = heights;
        let at = |place: usize| turned[place / columns + rows * (place % columns)];
        heights = (0..points).map(at).collect();
    }
    let unit = reading.unit.unwrap_or(1.0);
    Ok(Measured {
        topography: Topography::new(columns, heights)?.scaled(unit)?,
        format: Format::Npy,
        has_unit: reading.unit.is_some(),
        notes: Vec::new(),
    })
}

fn number(kind: &str) -> Option<Number> {
    Some(match kind {
        "f8" => Number::F64,
        "f4" => Number::F32,
        "i8" => Number::I64,
        "u8" => Number::U64,
        "i4" => Number::I32,
        "u4" => Number::U32,
        "i2" => Number::I16,
        "u2" => Number::U16,
        "i1" => Number::I8,
        "u1" => Number::U8,
        _ => return None,
    })
}

/// An array in a file of NumPy.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Npy<'a> {
    /// Byte order and kind of its numbers, such as `<f8`; none if they are fields.
    pub kind: Option<&'a str>,
    /// Its length along each axis.
    pub shape: Vec<usize>,
    /// Whether the first index varies fastest, not the last.
    pub by_columns: bool,
    /// Its numbers.
    pub values: &'a [u8],
}

impl<'a> Npy<'a> {
    /// The parts of a file; none if it is damaged or another file.
    #[must_use]
    pub fn of(bytes: &'a [u8]) -> Option<Self> {
        let rest = bytes.strip_prefix(b"\x93NUMPY")?;
        let (length, start): (usize, usize) = match rest.first()? {
            1 => (usize::from(u16::from_le_bytes(rest.get(2..4)?.try_into().ok()?)), 4),
            2 | 3 => (u32::from_le_bytes(rest.get(2..6)?.try_into().ok()?) as usize, 6),
            _ => return None,
        };
        let head = std::str::from_utf8(rest.get(start..start.checked_add(length)?)?).ok()?;
        let between = |from, to| Some(head.split_once(from)?.1.split_once(to)?.0);
        let counts = between("'shape': (", ")")?.split(',').map(str::trim);
        let counts = counts.filter(|count| !count.is_empty()).map(|count| count.parse().ok());
        Some(Self {
            kind: between("'descr': '", "'"),
            shape: counts.collect::<Option<_>>()?,
            by_columns: head.contains("'fortran_order': True"),
            values: rest.get(start + length..)?,
        })
    }
}

/// An array as a file of NumPy, whose last index varies fastest.
///
/// ```
/// use carom_surface::{Reading, npy, read};
/// let values = [1.0, 2.0, 3.0, f64::NAN];
/// let file = npy("<f8", &[2, 2], values.iter().flat_map(|value| value.to_le_bytes()));
/// let map = read(&file, &Reading::default())?.topography;
/// assert_eq!((map.columns(), map.rows(), map.heights()[2]), (2, 2, 3.0));
/// # Ok::<(), carom_surface::SurfaceError>(())
/// ```
#[must_use]
pub fn npy(kind: &str, shape: &[usize], values: impl Iterator<Item = u8>) -> Vec<u8> {
    let counts: String = shape.iter().map(|count| format!("{count}, ")).collect();
    let shape = counts.trim_end();
    let head = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({shape}), }}");
    // The data begin at a multiple of 64 bytes; 10 stand before the head and a line feed ends it.
    let length = (head.len() + 11).next_multiple_of(64) - 10;
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(format!("{head:width$}\n", width = length - 1).as_bytes());
    bytes.extend(values);
    bytes
}
