//! Pixel images: small images inside a plot, and a whole plot as PNG.

use crate::error::PlotError;

/// Pixels for each unit of the plot: sharp on dense screens and in print.
const SCALE: f32 = 2.0;

/// An image of few colours as PNG: one byte per pixel, rows from the top, each an index into
/// `palette`, whose first colour may be transparent.
pub(crate) fn indexed_png(
    width: usize,
    pixels: &[u8],
    palette: &[[u8; 3]],
    is_first_clear: bool,
) -> Result<Vec<u8>, PlotError> {
    let size = |length: usize| u32::try_from(length).map_err(raster);
    let mut bytes = Vec::new();
    let height = size(pixels.len() / width.max(1))?;
    let mut encoder = png::Encoder::new(&mut bytes, size(width)?, height);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(palette.as_flattened().to_vec());
    if is_first_clear {
        encoder.set_trns(vec![0]);
    }
    let mut writer = encoder.write_header().map_err(raster)?;
    writer.write_image_data(pixels).map_err(raster)?;
    writer.finish().map_err(raster)?;
    Ok(bytes)
}

/// A drawing as PNG; `svg` must not have texts.
pub(crate) fn png_of(svg: &str) -> Result<Vec<u8>, PlotError> {
    use resvg::{tiny_skia, usvg};
    let tree = usvg::Tree::from_str(svg, &usvg::Options::default()).map_err(raster)?;
    let pixels = |length: f32| (SCALE * length).ceil() as u32;
    let size = tree.size();
    let mut pixmap = tiny_skia::Pixmap::new(pixels(size.width()), pixels(size.height()))
        .ok_or_else(|| PlotError::Raster("the picture is too large".to_owned()))?;
    resvg::render(&tree, tiny_skia::Transform::from_scale(SCALE, SCALE), &mut pixmap.as_mut());
    pixmap.encode_png().map_err(raster)
}

/// The error of a picture that cannot be made.
pub(crate) fn raster(error: impl std::fmt::Display) -> PlotError {
    PlotError::Raster(error.to_string())
}

/// Bytes in base 64, as used in data addresses (RFC 4648).
///
/// ```
/// assert_eq!(carom_plot::base64(b"fo"), "Zm8=");
/// ```
#[must_use]
pub fn base64(bytes: &[u8]) -> String {
    const SIGNS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let part = |i: usize| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = part(0) << 16 | part(1) << 8 | part(2);
        for i in 0..4 {
            let sign = SIGNS[(bits >> (18 - 6 * i) & 63) as usize];
            text.push(if i > chunk.len() { '=' } else { char::from(sign) });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_of_the_standard_s_examples() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }

    #[test]
    fn an_image_keeps_its_pixels() {
        let palette = [[255, 0, 0], [0, 0, 255]];
        let png = indexed_png(3, &[0, 1, 0, 1, 1, 0], &palette, false).unwrap();
        let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        let expected = [0, 1, 0, 1, 1, 0].map(|i| palette[i]);
        assert_eq!(pixels, expected.as_flattened());
    }
}
