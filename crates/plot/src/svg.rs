//! Writing SVG: a few shapes, numbers with two decimals.

use std::fmt::Write as _;

/// A growing SVG document.
#[derive(Debug, Default)]
pub(crate) struct Svg {
    body: String,
}

/// Where a text hangs on its point.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Anchor {
    /// The point is at its start.
    Start,
    /// The point is in its middle.
    Middle,
    /// The point is at its end.
    End,
}

/// A place in pixels, y downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pixel {
    /// From the left.
    pub(crate) x: f64,
    /// From the top.
    pub(crate) y: f64,
}

/// An upright rectangle in pixels.
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
            "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" \
             {attributes}/>"
        );
    }

    /// A straight line.
    pub(crate) fn line(&mut self, from: Pixel, to: Pixel, attributes: &str) {
        let _ = writeln!(
            self.body,
            "<line x1=\"{:.2}\" y1=\"{:.2}\" x2=\"{:.2}\" y2=\"{:.2}\" {attributes}/>",
            from.x, from.y, to.x, to.y
        );
    }

    /// A circle.
    pub(crate) fn circle(&mut self, centre: Pixel, radius: f64, attributes: &str) {
        let _ = writeln!(
            self.body,
            "<circle cx=\"{:.2}\" cy=\"{:.2}\" r=\"{radius:.2}\" {attributes}/>",
            centre.x, centre.y
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
            let _ = write!(self.body, "{x:.2},{y:.2} ");
        }
        let _ = writeln!(self.body, "\" {attributes}/>");
    }

    /// Many straight pieces in one.
    pub(crate) fn pieces(&mut self, pieces: impl Iterator<Item = [Pixel; 2]>, attributes: &str) {
        let _ = write!(self.body, "<path {attributes} d=\"");
        for [from, to] in pieces {
            let _ = write!(self.body, "M{:.2},{:.2}L{:.2},{:.2}", from.x, from.y, to.x, to.y);
        }
        self.body.push_str("\"/>\n");
    }

    /// A text, its baseline at the point; `_x` and `_max` are set as subscripts.
    pub(crate) fn text(&mut self, at: Pixel, anchor: Anchor, text: &str, attributes: &str) {
        if text.is_empty() {
            return;
        }
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let _ = writeln!(
            self.body,
            "<text x=\"{:.2}\" y=\"{:.2}\" text-anchor=\"{anchor}\" {attributes}>{}</text>",
            at.x,
            at.y,
            with_subscripts(&escape(text))
        );
    }

    /// The document of this size, white below everything.
    pub(crate) fn finish(self, width: f64, height: f64) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"Helvetica, Arial, sans-serif\" \
             font-size=\"13\" fill=\"#222\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{}</svg>\n",
            self.body
        )
    }
}

/// Text with the characters that XML reserves written out.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// `F_x` and `F_max` with their subscripts lowered: a word up to the next sign.
fn with_subscripts(text: &str) -> String {
    let mut parts = text.split('_');
    let mut marked = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let end = part.find(|c: char| !c.is_alphanumeric()).unwrap_or(part.len());
        let (lowered, rest) = part.split_at(end);
        let _ = write!(
            marked,
            "<tspan dy=\"0.28em\" font-size=\"75%\">{lowered}</tspan>\
             <tspan dy=\"-0.21em\">&#8203;</tspan>{rest}"
        );
    }
    marked
}

/// About how wide a text of this font size is.
pub(crate) fn text_width(text: &str, font_size: f64) -> f64 {
    0.56 * font_size * text.chars().count() as f64
}
