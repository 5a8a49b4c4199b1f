//! Heights from a file: rows of numbers as CSV or NPY, or a greyscale PNG.

use super::npy;
use crate::Error;
use crate::case::HeightFile;
use crate::input::CaseFile;
use crate::numbers::{bare, delimiter};
use carom_halfspace::{Field, Grid};
use carom_solver::{Gap, HeightMap, HeightMapError};
use std::path::Path;

/// The factors in a file, one for each cell, and its content.
///
/// # Errors
/// [`ErrorKind::Input`](crate::ErrorKind::Input) as [`gap`], or if a factor is negative.
pub(super) fn factors(case: &CaseFile, file: &Path, grid: Grid) -> Result<(Field, Vec<u8>), Error> {
    let refused = |reason: String| Error::input(reason).of_file(&case.beside(file));
    let (rows, read) = numbers(case, file, grid)?;
    for (i, row) in rows.iter().enumerate() {
        if let Some(j) = row.iter().position(|factor| !(*factor >= 0.0 && factor.is_finite())) {
            let (row, column, factor) = (i + 1, j + 1, row[j]);
            let told = format!(
                "the factor of friction in row {row}, column {column} is {factor}: must be finite and >= 0"
            );
            return Err(refused(told));
        }
    }
    let field = Field::new(grid, rows.concat()).map_err(|error| refused(error.to_string()))?;
    Ok((field, read))
}

/// The gap of the heights in the file that the case names, and the content of the file.
///
/// # Errors
/// [`ErrorKind::Input`](crate::ErrorKind::Input) if the rows differ in length, the size differs from that of the grid, or a height is too
/// large or not finite.
pub(super) fn gap(case: &CaseFile, map: &HeightFile, grid: Grid) -> Result<(Gap, Vec<u8>), Error> {
    let (rows, read) = numbers(case, &map.file, grid)?;
    let refused = |reason: String| Error::input(reason).of_file(&case.beside(&map.file));
    Ok((under(rows, map, grid).map_err(refused)?, read))
}

/// The rows of numbers in a file, one number for each cell, and its content.
fn numbers(case: &CaseFile, file: &Path, grid: Grid) -> Result<(Vec<Vec<f64>>, Vec<u8>), Error> {
    let refused = |reason: String| Error::input(reason).of_file(&case.beside(file));
    let check = |size| HeightMap::check_size(size, grid).map_err(|error| error.to_string());
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    Ok(match ending.to_ascii_lowercase().as_str() {
        "npy" => {
            let bytes = case.bytes(file)?;
            (npy::rows(&bytes, check).map_err(refused)?, bytes)
        }
        "png" => {
            let bytes = case.bytes(file)?;
            (greys(&bytes, check).map_err(refused)?, bytes)
        }
        _ => {
            let text = case.table(file)?;
            (lines(&text, check).map_err(refused)?, text.into_bytes())
        }
    })
}

fn under(mut rows: Vec<Vec<f64>>, map: &HeightFile, grid: Grid) -> Result<Gap, String> {
    for (i, row) in rows.iter_mut().enumerate() {
        for (j, height) in row.iter_mut().enumerate() {
            let given = *height;
            *height *= map.scale;
            if given.is_finite() && !height.is_finite() {
                let (row, column, scale) = (i + 1, j + 1, map.scale);
                return Err(format!(
                    "the height in row {row}, column {column} is {given:e} times the scale {scale:e}: \
                     must be finite"
                ));
            }
        }
    }
    let heights = HeightMap::from_rows(&rows).map_err(|error| error.to_string())?;
    heights.gap_over(grid, map.radius).map_err(|error| error.to_string())
}

/// Rows of comma-separated values. All lines are counted before the first number is read.
fn lines(
    text: &str,
    check: impl Fn([usize; 2]) -> Result<(), String>,
) -> Result<Vec<Vec<f64>>, String> {
    let wrong = |error: HeightMapError| error.to_string();
    let [columns, rows] = size(text).map_err(wrong)?;
    check([columns, rows])?;
    bare(text).map_err(|error| error.to_string())
}

/// Number of columns and rows of comma-separated values. Numbers contain neither line breaks nor quoted
/// delimiters.
fn size(text: &str) -> Result<[usize; 2], HeightMapError> {
    let delimiter = delimiter(text);
    let count = |line: &str| 1 + line.bytes().filter(|byte| *byte == delimiter).count();
    let lines = text.split(['\n', '\r']).filter(|line| !line.is_empty());
    let mut size = [0, 0];
    for (found, row) in lines.map(count).zip(1..) {
        if row > 1 && found != size[0] {
            return Err(HeightMapError::Ragged { row, found, expected: size[0] });
        }
        size = [found, row];
    }
    if size[1] == 0 { Err(HeightMapError::Empty) } else { Ok(size) }
}

/// Rows of grey values, from 0 (black) to 255 or 65535 (white); the last row of the picture is the first row
/// of the grid. `check` receives the size in the header before anything is allocated for it.
fn greys(
    bytes: &[u8],
    check: impl Fn([usize; 2]) -> Result<(), String>,
) -> Result<Vec<Vec<f64>>, String> {
    let broken =
        |error: png::DecodingError| format!("this is not a PNG file, or it is damaged: {error}");
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    let head = decoder.read_header_info().map_err(broken)?;
    let (colour, depth) = (head.color_type, head.bit_depth);
    if colour != png::ColorType::Grayscale {
        return Err(format!("this picture is in {colour:?}: must be greyscale"));
    }
    let grey: fn(&[u8]) -> f64 = match depth {
        png::BitDepth::Sixteen => |two| u16::from_be_bytes([two[0], two[1]]).into(),
        png::BitDepth::Eight => |one| one[0].into(),
        depth => {
            return Err(format!(
                "this picture has {} bits per pixel: must be 8 or 16",
                depth as u8
            ));
        }
    };
    check([head.width as usize, head.height as usize])?;
    let mut reader = decoder.read_info().map_err(broken)?;
    let size = reader.output_buffer_size().ok_or("this picture is too large")?;
    let mut buffer = vec![0; size];
    let info = reader.next_frame(&mut buffer).map_err(broken)?;
    let row = |line: &[u8]| line.chunks_exact(depth as usize / 8).map(grey).collect();
    Ok(buffer[..info.buffer_size()].chunks_exact(info.line_size).rev().map(row).collect())
}
