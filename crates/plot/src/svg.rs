//! Writing SVG: a few shapes, numbers with two decimals.

use crate::error::PlotError;
use crate::raster::base64;
use crate::text::{Font, Level, Type, parts};
use std::fmt::Write as _;

/// An SVG document under construction.
#[derive(Default)]
pub(crate) struct Svg {
    body: String,
    /// The font for drawing texts as outlines; `None` if the reader has fonts.
    font: Option<Font>,
}

/// The position of a text relative to its point.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Anchor {
    /// The text starts at the point.
    Start,
    /// The text is centred at the point.
    Middle,
    /// The text ends at the point.
    End,
}

/// A point in pixels, y downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pixel {
    /// From the left.
    pub(crate) x: f64,
    /// From the top.
    pub(crate) y: f64,
}

/// A rectangle in pixels with horizontal and vertical sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    /// Left edge.
    pub(crate) x: f64,
    /// Upper edge.
    pub(crate) y: f64,
    /// Width.
    pub(crate) width: f64,
    /// Height.
    pub(crate) height: f64,
}

impl Frame {
    /// The frame with a margin around it.
    pub(crate) fn grown(self, margin: f64) -> Self {
        Self {
            x: self.x - margin,
            y: self.y - margin,
            width: self.width + 2.0 * margin,
            height: self.height + 2.0 * margin,
        }
    }

    /// Whether the pixel lies inside.
    pub(crate) fn holds(&self, pixel: Pixel) -> bool {
        (self.x..=self.x + self.width).contains(&pixel.x)
            && (self.y..=self.y + self.height).contains(&pixel.y)
    }
}

impl Svg {
    /// A document whose texts are outlines, for a renderer without fonts.
    pub(crate) fn with_outlines() -> Result<Self, PlotError> {
        Ok(Self { body: String::new(), font: Some(Font::new()?) })
    }

    /// Opens a group with attributes.
    pub(crate) fn open(&mut self, attributes: &str) {
        let _ = writeln!(self.body, "<g {attributes}>");
    }

    /// Closes the last group.
    pub(crate) fn close(&mut self) {
        self.body.push_str("</g>\n");
    }

    /// A clip path for later groups.
    pub(crate) fn clip(&mut self, name: &str, frame: Frame) {
        let _ = write!(self.body, "<clipPath id=\"{name}\">");
        self.rect(frame, "");
        self.body.push_str("</clipPath>\n");
    }

    /// A rectangle.
    pub(crate) fn rect(&mut self, frame: Frame, attributes: &str) {
        let Frame { x, y, width, height } = frame;
        let _ = writeln!(
            self.body,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {attributes}/>",
            Short(x),
            Short(y),
            Short(width),
            Short(height)
        );
    }

    /// A straight line.
    pub(crate) fn line(&mut self, from: Pixel, to: Pixel, attributes: &str) {
        let _ = writeln!(
            self.body,
            "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" {attributes}/>",
            Short(from.x),
            Short(from.y),
            Short(to.x),
            Short(to.y)
        );
    }

    /// A circle.
    pub(crate) fn circle(&mut self, centre: Pixel, radius: f64, attributes: &str) {
        let _ = writeln!(
            self.body,
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {attributes}/>",
            Short(centre.x),
            Short(centre.y),
            Short(radius)
        );
    }

    /// A line through points, or with `polygon` the area they enclose.
    pub(crate) fn path(
        &mut self,
        element: &str,
        pixels: impl Iterator<Item = Pixel>,
        attributes: &str,
    ) {
        let _ = write!(self.body, "<{element} points=\"");
        for Pixel { x, y } in pixels {
            let _ = write!(self.body, "{},{} ", Short(x), Short(y));
        }
        let _ = writeln!(self.body, "\" {attributes}/>");
    }

    /// As [`Svg::path`], animated through frames repeatedly.
    pub(crate) fn moving_path(
        &mut self,
        element: &str,
        still: &[Pixel],
        frames: &[Vec<Pixel>],
        seconds: f64,
        attributes: &str,
    ) {
        let list = |pixels: &[Pixel]| {
            let places = pixels.iter().map(|at| format!("{},{}", Short(at.x), Short(at.y)));
            places.collect::<Vec<_>>().join(" ")
        };
        let values: Vec<String> = frames.iter().map(|frame| list(frame)).collect();
        let _ = writeln!(
            self.body,
            "<{element} points=\"{}\" {attributes}>{}</{element}>",
            list(still),
            animate("points", &values, seconds)
        );
    }

    /// A circle animated through frames repeatedly.
    pub(crate) fn moving_circle(
        &mut self,
        still: Pixel,
        frames: &[Pixel],
        radius: f64,
        seconds: f64,
        attributes: &str,
    ) {
        let along = |name: &str, part: fn(&Pixel) -> f64| {
            let values: Vec<String> = frames.iter().map(|at| Short(part(at)).to_string()).collect();
            animate(name, &values, seconds)
        };
        let _ = writeln!(
            self.body,
            "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {attributes}>{}{}</circle>",
            Short(still.x),
            Short(still.y),
            Short(radius),
            along("cx", |at| at.x),
            along("cy", |at| at.y)
        );
    }

    /// Opens a group that jumps between positions; without animation it is hidden.
    pub(crate) fn jumping(&mut self, frames: &[Pixel], seconds: f64) {
        let places = frames.iter().map(|at| format!("{} {}", Short(at.x), Short(at.y)));
        let values = places.collect::<Vec<_>>().join(";");
        let _ = writeln!(
            self.body,
            "<g transform=\"translate(-9999 0)\"><animateTransform attributeName=\"transform\" \
             type=\"translate\" calcMode=\"discrete\" dur=\"{seconds}s\" \
             repeatCount=\"indefinite\" values=\"{values}\"/>"
        );
    }

    /// Many lines in one element.
    pub(crate) fn lines(&mut self, lines: impl Iterator<Item = Vec<Pixel>>, attributes: &str) {
        let _ = write!(self.body, "<path {attributes} d=\"");
        for line in lines {
            for (i, Pixel { x, y }) in line.into_iter().enumerate() {
                let _ = write!(self.body, "{}{x:.1},{y:.1}", if i == 0 { 'M' } else { 'L' });
            }
        }
        self.body.push_str("\"/>\n");
    }

    /// One shape at many positions, as relative moves of a path.
    pub(crate) fn repeated(&mut self, places: &[Pixel], shape: &str, attributes: &str) {
        let _ = write!(self.body, "<path {attributes} d=\"");
        for Pixel { x, y } in places {
            let _ = write!(self.body, "M{x:.1},{y:.1}{shape}");
        }
        self.body.push_str("\"/>\n");
    }

    /// An image that fills the frame.
    pub(crate) fn image(&mut self, frame: Frame, png: &[u8]) {
        let Frame { x, y, width, height } = frame;
        let _ = writeln!(
            self.body,
            "<image x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" \
             preserveAspectRatio=\"none\" href=\"data:image/png;base64,{}\"/>",
            base64(png)
        );
    }

    /// A text, its baseline at the point; `_x` and `_max` are set as subscripts, `^2` as exponent.
    pub(crate) fn text(&mut self, at: Pixel, anchor: Anchor, text: &str, look: Type) {
        if text.is_empty() {
            return;
        }
        match &self.font {
            Some(font) => {
                let (path, width) = font.outlines(text, look);
                self.outlined(at, anchor, &path, width, look);
            }
            None => self.written(at, anchor, text, look),
        }
    }

    fn outlined(&mut self, at: Pixel, anchor: Anchor, path: &str, width: f64, look: Type) {
        let shift = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -0.5 * width,
            Anchor::End => -width,
        };
        let turn = match look.rise {
            0.0 => String::new(),
            rise => format!(" rotate({})", -rise),
        };
        let _ = writeln!(
            self.body,
            "<path transform=\"translate({:.2} {:.2}){turn} translate({shift:.2} 0)\" d=\"{path}\"/>",
            at.x, at.y
        );
    }

    fn written(&mut self, at: Pixel, anchor: Anchor, text: &str, look: Type) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let Pixel { x, y } = at;
        let _ = write!(self.body, "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\"");
        if look.size != Type::TICK.size {
            let _ = write!(self.body, " font-size=\"{}\"", look.size);
        }
        if look.bold {
            self.body.push_str(" font-weight=\"bold\"");
        }
        if look.rise != 0.0 {
            let _ = write!(self.body, " transform=\"rotate({} {x:.2} {y:.2})\"", -look.rise);
        }
        self.body.push('>');
        for (part, level) in parts(text) {
            let part = escape(part);
            let _ = match level {
                Level::Line => write!(self.body, "{part}"),
                Level::Lowered | Level::Raised => write!(
                    self.body,
                    "<tspan dy=\"{}em\" font-size=\"75%\">{part}</tspan>\
                     <tspan dy=\"{}em\">&#8203;</tspan>",
                    Short(level.drop()),
                    Short(level.back())
                ),
            };
        }
        self.body.push_str("</text>\n");
    }

    /// The finished document of this size, on a white background, with a description for readers
    /// who do not see it.
    pub(crate) fn finish(self, width: f64, height: f64, spoken: &str) -> String {
        let (width, height) = (Short(width), Short(height));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\" \
             font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{}\" fill=\"#222\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{}</svg>\n",
            escape(spoken),
            Type::TICK.size,
            self.body
        )
    }
}

/// An attribute animated through values repeatedly.
fn animate(name: &str, values: &[String], seconds: f64) -> String {
    format!(
        "<animate attributeName=\"{name}\" dur=\"{seconds}s\" repeatCount=\"indefinite\" \
         values=\"{}\"/>",
        values.join(";")
    )
}

/// A number with two decimals, or fewer if they are zeros.
struct Short(f64);

impl std::fmt::Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let text = format!("{:.2}", self.0);
        f.write_str(text.trim_end_matches('0').trim_end_matches('.'))
    }
}

/// Text with the reserved characters of XML escaped.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_as_short_as_they_can_be() {
        let short = |value: f64| Short(value).to_string();
        let found = [100.0, 0.5, 12.345, -0.25, 10.10, 0.0].map(short);
        assert_eq!(found, ["100", "0.5", "12.35", "-0.25", "10.1", "0"]);
    }
}
