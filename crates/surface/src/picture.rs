//! Pictures in greys, `.png`.

use crate::bytes::Number;
use crate::error::SurfaceError;
use crate::format::{Format, Measured, Reading};
use crate::topography::Topography;

const NAME: &str = "PNG";

/// Grey values: 0 is black, 255 or 65535 white, or black 0 and white [`Reading::range`]. The last row of the picture is
/// the first of the map.
pub(crate) fn read(bytes: &[u8], reading: &Reading) -> Result<Measured, SurfaceError> {
    let broken = |error: png::DecodingError| SurfaceError::damaged(NAME, error.to_string());
    let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    let head = decoder.read_header_info().map_err(broken)?;
    let (colour, depth) = (head.color_type, head.bit_depth as u8);
    if colour != png::ColorType::Grayscale {
        return Err(SurfaceError::unsupported(
            NAME,
            format!("is in {colour:?}: must be greyscale"),
        ));
    }
    let (number, white) = match depth {
        8 => (Number::U8, 255.0),
        16 => (Number::U16, 65535.0),
        _ => {
            let reason = format!("has {depth} bits per pixel: must have 8 or 16");
            return Err(SurfaceError::unsupported(NAME, reason));
        }
    };
    let columns = head.width as usize;
    let points = reading.check(columns, head.height as usize)?;
    let mut reader = decoder.read_info().map_err(broken)?;
    let mut buffer = vec![0; points * number.size()];
    let info = reader.next_frame(&mut buffer).map_err(broken)?;
    let lines = buffer[..info.buffer_size()].chunks_exact(info.line_size).rev();
    let greys: Vec<f64> = lines.flat_map(|line| number.block(line, true)).collect();
    let (unit, mut notes) = (reading.range.map(|range| range / white).or(reading.unit), Vec::new());
    if unit.is_none() {
        notes.push(format!(
            "a PNG states no heights: one grey level of {white} is taken as 1 m; give `range`, the height of white"
        ));
    }
    Ok(Measured {
        topography: Topography::new(columns, greys)?.scaled(unit.unwrap_or(1.0))?,
        format: Format::Png,
        has_unit: unit.is_some(),
        notes,
    })
}
