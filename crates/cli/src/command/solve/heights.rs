//! Heights from a file: rows of numbers as CSV or NPY, or the greys of a PNG.

use super::npy;
use crate::case::HeightFile;
use crate::error::CliError;
use crate::input::CaseFile;
use crate::numbers::bare;
use carom_halfspace::Grid;
use carom_solver::{Gap, HeightMap};

/// The gap under the heights in the file that the case names, and all that was read.
///
/// # Errors
/// [`CliError::Input`] if the heights are ragged, of another size than the grid, or hold anything but
/// finite numbers.
pub(super) fn gap(
    case: &CaseFile,
    map: &HeightFile,
    grid: Grid,
) -> Result<(Gap, Vec<u8>), CliError> {
    let refused = |reason: String| CliError::Input { path: case.beside(&map.file), reason };
    let ending = map.file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let (rows, read) = match ending.to_ascii_lowercase().as_str() {
        "npy" => {
            let bytes = case.bytes(&map.file)?;
            (npy::rows(&bytes).map_err(refused)?, bytes)
        }
        "png" => {
            let bytes = case.bytes(&map.file)?;
            (greys(&bytes).map_err(refused)?, bytes)
        }
        _ => {
            let text = case.table(&map.file)?;
            (bare(&text).map_err(|error| refused(error.to_string()))?, text.into_bytes())
        }
    };
    Ok((under(rows, map, grid).map_err(refused)?, read))
}

fn under(mut rows: Vec<Vec<f64>>, map: &HeightFile, grid: Grid) -> Result<Gap, String> {
    for height in rows.iter_mut().flatten() {
        *height *= map.scale;
    }
    let heights = HeightMap::from_rows(&rows).map_err(|error| error.to_string())?;
    heights.gap_over(grid, map.radius).map_err(|error| error.to_string())
}

/// Rows of greys, from black 0 to white 255 or 65535; the last row of the picture is the first.
fn greys(bytes: &[u8]) -> Result<Vec<Vec<f64>>, String> {
    let broken = |error: png::DecodingError| format!("this is no PNG, or damaged: {error}");
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().map_err(broken)?;
    let size = reader.output_buffer_size().ok_or("this picture is too large")?;
    let mut buffer = vec![0; size];
    let info = reader.next_frame(&mut buffer).map_err(broken)?;
    if info.color_type != png::ColorType::Grayscale {
        return Err(format!("this picture is in {:?}: must be in greys", info.color_type));
    }
    let line = &buffer[..info.buffer_size()];
    let row = |line: &[u8]| match info.bit_depth {
        png::BitDepth::Sixteen => {
            let greys = line.chunks_exact(2).map(|two| u16::from_be_bytes([two[0], two[1]]));
            Ok(greys.map(f64::from).collect())
        }
        png::BitDepth::Eight => Ok(line.iter().map(|grey| f64::from(*grey)).collect()),
        depth => Err(format!("this picture has {} bits a grey: must be 8 or 16", depth as u8)),
    };
    line.chunks_exact(info.line_size).rev().map(row).collect()
}
