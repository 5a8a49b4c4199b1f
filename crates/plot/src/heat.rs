//! Drawing a field: cells in colours, contour lines, and the bar that explains the colours.

use crate::error::PlotError;
use crate::field::{Field, contour};
use crate::panel::Axis;
use crate::span::Span;
use crate::svg::{Anchor, Frame, Pixel, Svg};

/// Blue, light blue, grey, light orange, brown: light in the middle, dark at both ends.
const COLOURS: [[f64; 3]; 5] = [
    [8.0, 81.0, 156.0],
    [107.0, 174.0, 214.0],
    [247.0, 247.0, 247.0],
    [253.0, 174.0, 107.0],
    [166.0, 54.0, 3.0],
];
/// Colours told apart on either side of the neutral one; neighbours of the same are drawn as one.
const SHADES: f64 = 48.0;
/// Overlap of neighbours, in pixels.
const SEAM: f64 = 0.7;
/// Width of the bar.
const BAR: f64 = 14.0;
/// Room for it beside the axes.
pub(crate) const ASIDE: f64 = 92.0;

/// The values of a field as an axis, from its colours to its contour lines.
pub(crate) struct Heat<'a> {
    field: &'a Field,
    span: Span,
    reach: f64,
}

impl<'a> Heat<'a> {
    pub(crate) fn new(field: &'a Field) -> Result<Self, PlotError> {
        let [low, high] = field.range();
        // A field of one value has a colour, too.
        let (low, high) = if low < high { (low, high) } else { (low - 0.5, high + 0.5) };
        let axis = Axis::linear(field.label.clone()).between(low, high);
        let span = Span::fit(&axis, std::iter::empty())?;
        let reach = (high - field.centre).abs().max((low - field.centre).abs());
        Ok(Self { field, span, reach })
    }

    /// The shade of a value, a whole number within +-SHADES.
    fn shade(&self, value: f64) -> i32 {
        libm::round((value - self.field.centre) / self.reach * SHADES) as i32
    }

    /// Cells, each from half-way to the node before to half-way to the node after, and contour
    /// lines at the ticks of the bar.
    pub(crate) fn draw(&self, svg: &mut Svg, clip: &str, x: &Span, y: &Span, frame: Frame) {
        let left = |at: f64| frame.x + frame.width * at;
        let top = |at: f64| frame.y + frame.height * (1.0 - at);
        let columns = edges(self.field.x(), x);
        let rows = edges(self.field.y(), y);
        svg.open(&format!("clip-path=\"url(#{clip})\" shape-rendering=\"crispEdges\""));
        for (row, heights) in rows.windows(2).enumerate() {
            let mut column = 0;
            while column < self.field.x().len() {
                let shade = self.shade(self.field.at(column, row));
                let first = column;
                while column < self.field.x().len()
                    && self.shade(self.field.at(column, row)) == shade
                {
                    column += 1;
                }
                let (x, y) = (left(columns[first]), top(heights[1]));
                // A little over the next cell, which is drawn later: no seams.
                let y = y - SEAM;
                let (width, height) = (left(columns[column]) - x + SEAM, top(heights[0]) - y);
                svg.rect(Frame { x, y, width, height }, &format!("fill=\"{}\"", colour(shade)));
            }
        }
        svg.close();
        svg.open(&format!("clip-path=\"url(#{clip})\" fill=\"none\" stroke=\"#222\""));
        for tick in self.span.ticks().0 {
            let pieces = contour(self.field, tick.at);
            let place = |(a, b): (f64, f64)| Pixel { x: left(x.place(a)), y: top(y.place(b)) };
            let bold = if tick.at == self.field.centre { 1.6 } else { 0.7 };
            let pieces = pieces.into_iter().map(|piece| piece.map(place));
            svg.pieces(pieces, &format!("stroke-width=\"{bold}\""));
        }
        svg.close();
    }

    /// The bar beside the axes, with its ticks.
    pub(crate) fn draw_bar(&self, svg: &mut Svg, frame: Frame) {
        let bar = Frame { x: frame.x + frame.width + 14.0, width: BAR, ..frame };
        let steps = 2.0 * SHADES;
        for i in 0..steps as usize {
            let part = i as f64 / steps;
            let shade = self.shade(self.span.value(part + 0.5 / steps));
            let height = bar.height / steps;
            let y = bar.y + bar.height * (1.0 - part) - height;
            let cell = Frame { y, height: height + 0.5, ..bar };
            svg.rect(cell, &format!("fill=\"{}\"", colour(shade)));
        }
        svg.rect(bar, "fill=\"none\" stroke=\"#444\"");
        let end = bar.x + bar.width;
        for tick in self.span.ticks().0 {
            let y = bar.y + bar.height * (1.0 - self.span.place(tick.at));
            svg.line(Pixel { x: end, y }, Pixel { x: end + 4.0, y }, "stroke=\"#444\"");
            svg.text(Pixel { x: end + 7.0, y: y + 4.5 }, Anchor::Start, &tick.label, "");
        }
        let at = Pixel { x: bar.x + 0.5 * BAR, y: bar.y - 10.0 };
        svg.text(at, Anchor::Middle, &self.field.label, "font-size=\"14\"");
    }
}

/// Where cells begin and end on an axis.
fn edges(nodes: &[f64], span: &Span) -> Vec<f64> {
    let places: Vec<f64> = nodes.iter().map(|node| span.place(*node)).collect();
    let last = places.len() - 1;
    let mut edges = vec![places[0]];
    edges.extend(places.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
    edges.push(places[last]);
    edges
}

fn colour(shade: i32) -> String {
    let at = 2.0 * (1.0 + f64::from(shade) / SHADES).clamp(0.0, 2.0);
    let from = (at as usize).min(COLOURS.len() - 2);
    let part = at - from as f64;
    let mix = |i: usize| {
        libm::round(COLOURS[from][i] + part * (COLOURS[from + 1][i] - COLOURS[from][i])) as u8
    };
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_run_from_blue_over_grey_to_brown() {
        assert_eq!(colour(-48), "#08519c");
        assert_eq!(colour(0), "#f7f7f7");
        assert_eq!(colour(48), "#a63603");
        assert_eq!((colour(-99), colour(99)), (colour(-48), colour(48)));
    }

    #[test]
    fn the_neutral_colour_stands_at_the_centre() {
        let values = vec![-1.0, 0.0, 0.25, 0.5];
        let field = Field::new("q", vec![0.0, 1.0], vec![0.0, 1.0], values).unwrap();
        let heat = Heat::new(&field).unwrap();
        assert_eq!((heat.shade(0.0), heat.shade(-1.0), heat.shade(0.5)), (0, -48, 24));
        let shifted = field.centred(0.5);
        assert_eq!(Heat::new(&shifted).unwrap().shade(0.5), 0);
    }
}
