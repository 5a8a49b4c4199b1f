//! Arrays of NumPy, `.npy`.

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
    let (head, values) = parts(bytes).ok_or_else(broken)?;
    let unfit = |reason| SurfaceError::unsupported(NAME, reason);
    let descr = quoted(head, "descr")
        .ok_or_else(|| unfit("has fields: must be plain numbers".to_owned()))?;
    let (order, kind) = descr.split_at_checked(1).ok_or_else(broken)?;
    let number = number(kind)
        .ok_or_else(|| unfit(format!("has numbers of kind {kind}: must be f4, f8 or integers")))?;
    let shape = shape(head).ok_or_else(broken)?;
    let [rows, columns] = shape[..] else {
        return Err(unfit(format!("has {} axes: must have two, y and x", shape.len())));
    };
    let points = reading.check(columns, rows)?;
    if points.checked_mul(number.size()) != Some(values.len()) {
        return Err(broken());
    }
    let mut heights = number.block(values, order == ">");
    if head.contains("'fortran_order': True") {
        let by_columns = heights;
        let at = |place: usize| by_columns[place / columns + rows * (place % columns)];
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

fn shape(head: &str) -> Option<Vec<usize>> {
    let (_, rest) = head.split_once("'shape': (")?;
    let counts =
        rest.split_once(')')?.0.split(',').map(str::trim).filter(|count| !count.is_empty());
    counts.map(|count| count.parse().ok()).collect()
}

/// The header, and the data after it.
fn parts(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let rest = bytes.strip_prefix(b"\x93NUMPY")?;
    let (length, start): (usize, usize) = match rest.first()? {
        1 => (usize::from(u16::from_le_bytes(rest.get(2..4)?.try_into().ok()?)), 4),
        2 | 3 => (u32::from_le_bytes(rest.get(2..6)?.try_into().ok()?) as usize, 6),
        _ => return None,
    };
    let head = std::str::from_utf8(rest.get(start..start.checked_add(length)?)?).ok()?;
    Some((head, rest.get(start + length..)?))
}

fn quoted<'a>(head: &'a str, name: &str) -> Option<&'a str> {
    let rest = head.split_once(&format!("'{name}': '"))?.1;
    rest.split_once('\'').map(|(value, _)| value)
}

/// Rows of numbers as a file of NumPy, doubles in the order of `values`, row by row.
///
/// ```
/// use carom_surface::{Reading, npy, read};
/// let file = npy(2, &[1.0, 2.0, 3.0, f64::NAN]);
/// let map = read(&file, &Reading::default())?.topography;
/// assert_eq!((map.columns(), map.rows(), map.heights()[2]), (2, 2, 3.0));
/// # Ok::<(), carom_surface::SurfaceError>(())
/// ```
#[must_use]
pub fn npy(columns: usize, values: &[f64]) -> Vec<u8> {
    let rows = values.len() / columns.max(1);
    let head =
        format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
    // The data begin at a multiple of 64 bytes; 10 stand before the head and a line feed ends it.
    let length = (head.len() + 11).next_multiple_of(64) - 10;
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((length as u16).to_le_bytes());
    bytes.extend(format!("{head:width$}\n", width = length - 1).as_bytes());
    values.iter().for_each(|value| bytes.extend(value.to_le_bytes()));
    bytes
}
