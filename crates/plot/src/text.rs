//! Texts: size and style, subscripts, and the outlines of letters.

use crate::error::PlotError;
use std::fmt::Write as _;
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Size of subscripts relative to that of the text.
const LOWERED_SIZE: f64 = 0.75;
/// Size of DejaVu Sans, over the size of the text, at which it is as wide as common browser fonts.
const RELATIVE_FONT_SIZE: f64 = 0.92;
/// How far subscripts are lowered, in sizes of the subscript.
const LOWERED_BY: f64 = 0.28;

/// The style of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Type {
    /// Size of the font, in pixels.
    pub(crate) size: f64,
    /// Whether it is bold.
    pub(crate) bold: bool,
    /// Whether it runs upwards.
    pub(crate) upwards: bool,
}

impl Type {
    /// Style of the numbers on the axes.
    pub(crate) const TICK: Self = Self { size: 13.0, bold: false, upwards: false };
    /// Style of labels and titles of panels.
    pub(crate) const LABEL: Self = Self { size: 14.0, ..Self::TICK };
    /// Style of the label of the vertical axis.
    pub(crate) const UPWARDS: Self = Self { upwards: true, ..Self::LABEL };
    /// Style of the title above all panels.
    pub(crate) const TITLE: Self = Self { size: 15.0, bold: true, ..Self::TICK };
    /// Style of the legend.
    pub(crate) const LEGEND: Self = Self { size: 12.5, ..Self::TICK };
}

/// The parts of a text, and whether each is a subscript: in `F_x` and `F_max` the word after the
/// underscore is, up to the next character that is not a letter.
pub(crate) fn parts(text: &str) -> Vec<(&str, bool)> {
    let mut pieces = text.split('_');
    let mut parts = vec![(pieces.next().unwrap_or_default(), false)];
    for piece in pieces {
        let end = piece.find(|c: char| !c.is_alphanumeric()).unwrap_or(piece.len());
        let (lowered, rest) = piece.split_at(end);
        parts.extend([(lowered, true), (rest, false)]);
    }
    parts.retain(|(part, _)| !part.is_empty());
    parts
}

/// Approximate width of a text with this font size.
pub(crate) fn text_width(text: &str, font_size: f64) -> f64 {
    0.56 * font_size * text.chars().count() as f64
}

/// The embedded font: DejaVu Sans, under the licence of Bitstream Vera.
pub(crate) struct Font {
    regular: Face<'static>,
    bold: Face<'static>,
}

impl Font {
    pub(crate) fn new() -> Result<Self, PlotError> {
        let face =
            |bytes| Face::parse(bytes, 0).map_err(|error| PlotError::Raster(error.to_string()));
        Ok(Self { regular: face(dejavu::sans::regular())?, bold: face(dejavu::sans::bold())? })
    }

    /// The outlines of a text as path data, with its baseline from the origin to the right, and its
    /// width.
    pub(crate) fn outlines(&self, text: &str, look: Type) -> (String, f64) {
        let face = if look.bold { &self.bold } else { &self.regular };
        let mut pen = Pen::default();
        for (part, is_lowered) in parts(text) {
            let size = if is_lowered { LOWERED_SIZE * look.size } else { look.size };
            pen.unit = RELATIVE_FONT_SIZE * size / f64::from(face.units_per_em());
            pen.baseline = if is_lowered { LOWERED_BY * size } else { 0.0 };
            for letter in part.chars() {
                let glyph = face.glyph_index(letter).unwrap_or(GlyphId(0));
                // A space has no outline.
                let _ = face.outline_glyph(glyph, &mut pen);
                pen.right += pen.unit * f64::from(face.glyph_hor_advance(glyph).unwrap_or(0));
            }
        }
        (pen.path, pen.right)
    }
}

/// Writes outlines, whose y axis points upwards, as path data with y downwards.
#[derive(Default)]
struct Pen {
    path: String,
    unit: f64,
    right: f64,
    baseline: f64,
}

impl Pen {
    fn push(&mut self, letter: char, points: &[(f32, f32)]) {
        self.path.push(letter);
        for (x, y) in points {
            let x = self.right + self.unit * f64::from(*x);
            let y = self.baseline - self.unit * f64::from(*y);
            let _ = write!(self.path, "{x:.2} {y:.2} ");
        }
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.push('M', &[(x, y)]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.push('L', &[(x, y)]);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.push('Q', &[(x1, y1), (x, y)]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.push('C', &[(x1, y1), (x2, y2), (x, y)]);
    }

    fn close(&mut self) {
        self.path.push('Z');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_after_a_low_line_are_subscripts() {
        assert_eq!(parts("F_x / N"), [("F", false), ("x", true), (" / N", false)]);
        assert_eq!(parts("ζ_max"), [("ζ", false), ("max", true)]);
        assert_eq!(parts("plain"), [("plain", false)]);
    }

    #[test]
    fn every_sign_that_plots_use_has_an_outline() {
        let signs = "aZ09.,:;()[]/|=<>+-*&²³°·×−√⁰¹⁴⁵⁹⁻₀₁₂αβγδεζηθκλμνξπρσφχψωΩΔΠΣ∞≤≥±∂∫→…′″";
        let font = Font::new().unwrap();
        for face in [&font.regular, &font.bold] {
            for sign in signs.chars() {
                assert!(face.glyph_index(sign).is_some(), "{sign}");
            }
        }
        let (path, width) = font.outlines("R_x", Type::LABEL);
        assert!(path.starts_with('M') && path.ends_with('Z') && (12.0..20.0).contains(&width));
    }
}
