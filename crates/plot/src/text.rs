//! Texts: size and style, subscripts and exponents, and the outlines of letters.

use crate::error::PlotError;
use std::fmt::Write as _;
use std::sync::LazyLock;
use ttf_parser::{Face, GlyphId, OutlineBuilder};

/// Size of subscripts and exponents relative to that of the text.
const SMALL_SIZE: f64 = 0.75;
/// Size of DejaVu Sans, over the size of the text, at which it is as wide as common browser fonts.
const RELATIVE_FONT_SIZE: f64 = 0.92;
/// How far subscripts are lowered, in sizes of the subscript.
const LOWERED_BY: f64 = 0.28;
/// How far exponents are raised, in sizes of the exponent.
const RAISED_BY: f64 = 0.48;

/// The style of a text.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Type {
    /// Size of the font, in pixels.
    pub(crate) size: f64,
    /// Whether it is bold.
    pub(crate) bold: bool,
    /// The angle to which it rises, in degrees.
    pub(crate) rise: f64,
}

impl Type {
    /// Style of the numbers on the axes.
    pub(crate) const TICK: Self = Self { size: 14.0, bold: false, rise: 0.0 };
    /// Style of labels and titles of panels.
    pub(crate) const LABEL: Self = Self { size: 14.5, ..Self::TICK };
    /// Style of the label of the vertical axis.
    pub(crate) const UPWARDS: Self = Self { rise: 90.0, ..Self::LABEL };
    /// Style of the title above all panels.
    pub(crate) const TITLE: Self = Self { size: 15.0, bold: true, ..Self::TICK };
    /// Style of the legend.
    pub(crate) const LEGEND: Self = Self { size: 13.5, ..Self::TICK };
}

/// Where a part of a text stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Level {
    /// On the line.
    Line,
    /// Below it, as a subscript.
    Lowered,
    /// Above it, as an exponent.
    Raised,
}

impl Level {
    /// Size relative to that of the text.
    const fn size(self) -> f64 {
        if matches!(self, Self::Line) { 1.0 } else { SMALL_SIZE }
    }

    /// Distance below the line, in sizes of the part.
    pub(crate) const fn drop(self) -> f64 {
        match self {
            Self::Line => 0.0,
            Self::Lowered => LOWERED_BY,
            Self::Raised => -RAISED_BY,
        }
    }

    /// The way back to the line, in sizes of the text.
    pub(crate) fn back(self) -> f64 {
        -self.drop() * self.size()
    }
}

/// The parts of a text. In `F_x` and `F_max` the word after the low line is a subscript. In `ζ^1.5`
/// and `N^(1/4)` the number, word or bracket after the circumflex is an exponent.
pub(crate) fn parts(text: &str) -> Vec<(&str, Level)> {
    let mut parts = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find(['_', '^']) {
        parts.push((&rest[..at], Level::Line));
        let after = &rest[at + 1..];
        let (part, level, length) = match &rest[at..=at] {
            "_" => (word(after), Level::Lowered, word(after).len()),
            _ => {
                let (part, length) = exponent(after);
                (part, Level::Raised, length)
            }
        };
        parts.push((part, level));
        rest = &after[length..];
    }
    parts.push((rest, Level::Line));
    parts.retain(|(part, _)| !part.is_empty());
    parts
}

/// The word at the start of a text.
fn word(text: &str) -> &str {
    &text[..text.find(|c: char| !c.is_alphanumeric()).unwrap_or(text.len())]
}

/// The exponent at the start of a text, without its brackets, and the length with them.
fn exponent(text: &str) -> (&str, usize) {
    if let Some((inner, _)) = text.strip_prefix('(').and_then(|inner| inner.split_once(')')) {
        return (inner, inner.len() + 2);
    }
    let is_part = |c: char| c.is_alphanumeric() || matches!(c, '.' | '-' | '−' | '*');
    let part = &text[..text.find(|c| !is_part(c)).unwrap_or(text.len())];
    let part = part.trim_end_matches('.');
    (part, part.len())
}

/// Width of a text with this font size, that of the embedded font; others may be a little wider.
pub(crate) fn text_width(text: &str, font_size: f64) -> f64 {
    static FONT: LazyLock<Option<Font>> = LazyLock::new(|| Font::new().ok());
    let look = Type { size: font_size, ..Type::TICK };
    let width = FONT.as_ref().map(|font| font.outlines(text, look).1);
    // Without the font, a letter in the mean.
    width.unwrap_or_else(|| 0.56 * font_size * text.chars().count() as f64)
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
        for (part, level) in parts(text) {
            let size = level.size() * look.size;
            pen.unit = RELATIVE_FONT_SIZE * size / f64::from(face.units_per_em());
            pen.baseline = level.drop() * size;
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
        use Level::{Line, Lowered};
        assert_eq!(parts("F_x / N"), [("F", Line), ("x", Lowered), (" / N", Line)]);
        assert_eq!(parts("ζ_max"), [("ζ", Line), ("max", Lowered)]);
        assert_eq!(parts("plain"), [("plain", Line)]);
    }

    #[test]
    fn what_follows_a_circumflex_is_an_exponent() {
        use Level::{Line, Lowered, Raised};
        assert_eq!(parts("(ab)^1.5 C"), [("(ab)", Line), ("1.5", Raised), (" C", Line)]);
        assert_eq!(parts("N^(1/4)"), [("N", Line), ("1/4", Raised)]);
        assert_eq!(parts("x^2."), [("x", Line), ("2", Raised), (".", Line)]);
        assert_eq!(parts("a_1^*"), [("a", Line), ("1", Lowered), ("*", Raised)]);
        assert!(Raised.drop() < 0.0 && Raised.back() > 0.0 && Line.back() == 0.0);
    }

    #[test]
    fn an_exponent_stands_above_the_line_and_a_subscript_below() {
        let font = Font::new().unwrap();
        let lowest = |text: &str| {
            let (path, _) = font.outlines(text, Type::LABEL);
            let numbers = path.split([' ', 'M', 'L', 'Q', 'C', 'Z']).filter(|n| !n.is_empty());
            let y = numbers.skip(1).step_by(2).map(|y| y.parse::<f64>().unwrap());
            y.fold(f64::NEG_INFINITY, f64::max)
        };
        assert!(lowest("^x") < -4.0 && lowest("_x") > 2.0 && lowest("x").abs() < 0.3);
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
