//! Drawing a field: coloured cells, contour lines, and beside it the colour bar or the legend of
//! its kinds.

use crate::contour::contours;
use crate::draw::thinned;
use crate::error::PlotError;
use crate::field::Field;
use crate::panel::Axis;
use crate::plot::between;
use crate::raster::indexed_png;
use crate::span::{Span, with_power};
use crate::svg::{Anchor, Frame, Pixel, Svg};
use crate::text::{Type, text_width};
use std::cmp::Reverse;

/// Blue, light blue, grey, light orange, brown: light in the middle, dark at both ends.
const COLOURS: [[f64; 3]; 5] = [
    [8.0, 81.0, 156.0],
    [107.0, 174.0, 214.0],
    [247.0, 247.0, 247.0],
    [253.0, 174.0, 107.0],
    [166.0, 54.0, 3.0],
];
/// Colours on either side of the neutral one; neighbouring cells of the same colour are drawn as
/// one.
const SHADES: f64 = 48.0;
/// Pixels of the image for each unit of the picture.
const DENSITY: f64 = 2.0;
/// Largest number of pixels of the image along one side.
const MAX_PIXELS: usize = 4096;
/// Width of the bar.
const BAR_WIDTH: f64 = 14.0;
/// Space for the bar beside the axes.
pub(crate) const BAR_SPACE: f64 = 106.0;
/// Height of a kind in the legend.
const KIND_HEIGHT: f64 = 22.0;
/// Distance of bar and legend from the axes.
const GAP: f64 = 14.0;
/// Clear where there is no kind, then a colour for each: colour-blind readers distinguish the first
/// two by brightness too.
const KINDS: [[u8; 3]; 6] = [
    [255, 255, 255],
    [58, 139, 196],
    [245, 190, 82],
    [92, 186, 157],
    [219, 161, 193],
    [150, 150, 150],
];

/// The values of a field as an axis, for its colours and contour lines.
pub(crate) struct Heat<'a> {
    field: &'a Field,
    span: Span,
    reach: f64,
}

impl<'a> Heat<'a> {
    pub(crate) fn new(field: &'a Field) -> Result<Self, PlotError> {
        let [low, high] = field.range();
        // A constant field also has a colour.
        let (low, high) = if low < high { (low, high) } else { (low - 0.5, high + 0.5) };
        let axis = Axis::linear(field.label.clone()).between(low, high);
        let span = Span::fit(&axis, std::iter::empty())?;
        let reach = high.abs().max(low.abs());
        Ok(Self { field, span, reach })
    }

    /// Space beside the axes for the bar or the legend of the kinds.
    pub(crate) fn aside(&self) -> f64 {
        if self.field.kinds().is_empty() {
            return BAR_SPACE;
        }
        let widths = self.field.present().map(|(_, name)| text_width(name, Type::LEGEND.size));
        widths.reduce(f64::max).map_or(0.0, |width| width + GAP + BAR_WIDTH + 14.0)
    }

    /// The place of a legend beside the axes: below the kinds, or beyond the bar.
    pub(crate) fn clear_of_aside(&self, legend: Frame) -> Frame {
        match self.field.kinds().is_empty() {
            true => Frame { x: legend.x + BAR_SPACE, ..legend },
            false => {
                Frame { y: legend.y + KIND_HEIGHT * self.field.present().count() as f64, ..legend }
            }
        }
    }

    /// The colours of the image.
    fn palette(&self) -> Vec<[u8; 3]> {
        match self.field.kinds().len() {
            0 => (-(SHADES as i32)..=SHADES as i32).map(rgb).collect(),
            count => (0..=count).map(kind_colour).collect(),
        }
    }

    /// The place of the colour of a value in the palette.
    fn place_in_palette(&self, value: f64) -> u8 {
        match self.field.kinds().is_empty() {
            true => (self.shade(value) + SHADES as i32) as u8,
            false => value as u8,
        }
    }

    /// The colour index of a value, a whole number within +-SHADES.
    fn shade(&self, value: f64) -> i32 {
        libm::round(value / self.reach * SHADES) as i32
    }

    /// The cells as one image, each extending halfway to the neighbouring nodes, and contour lines
    /// at the ticks of the bar.
    pub(crate) fn draw(
        &self,
        svg: &mut Svg,
        clip: &str,
        [x, y]: [&Span; 2],
        frame: Frame,
    ) -> Result<(), PlotError> {
        let left = |at: f64| frame.x + frame.width * at;
        let top = |at: f64| frame.y + frame.height * (1.0 - at);
        let edges = |nodes: &[f64], span| edges(nodes, self.field.cell_ends(nodes), span);
        let (columns, rows) = (edges(self.field.x(), x), edges(self.field.y(), y));
        let ends = |edges: &[f64]| [edges[0], edges[edges.len() - 1]];
        let ([west, east], [south, north]) = (ends(&columns), ends(&rows));
        let place = Frame {
            x: left(west),
            y: top(north),
            width: left(east) - left(west),
            height: top(south) - top(north),
        };
        svg.open(&format!("clip-path=\"url(#{clip})\""));
        svg.image(place, &self.image(&columns, &rows, frame)?);
        svg.close();
        if !self.field.kinds().is_empty() {
            return Ok(());
        }
        let ticks = self.span.ticks().0;
        let levels: Vec<_> = ticks.iter().map(|tick| contours(self.field, tick.at)).collect();
        // Of a rough surface they would be a thicket.
        if levels.iter().map(Vec::len).sum::<usize>() > MOST_LINES {
            return Ok(());
        }
        svg.open(&format!("clip-path=\"url(#{clip})\" fill=\"none\" stroke=\"#222\""));
        let mut numbers: Vec<(Pixel, String)> = Vec::new();
        for (tick, lines) in ticks.into_iter().zip(levels) {
            let place = |(a, b): &(f64, f64)| Pixel { x: left(x.place(*a)), y: top(y.place(*b)) };
            let lines: Vec<Vec<Pixel>> = lines
                .iter()
                .map(|line| thinned(&line.iter().map(place).collect::<Vec<_>>()))
                .collect();
            let taken = |at: Pixel| numbers.iter().any(|(other, _)| is_near(at, *other));
            if let Some(at) = number_place(&lines, frame, taken) {
                numbers.push((at, tick.label.clone()));
            }
            let bold = if tick.at == 0.0 { 1.6 } else { 0.7 };
            svg.lines(
                lines.into_iter(),
                &format!("stroke-width=\"{bold}\" stroke-linejoin=\"round\""),
            );
        }
        svg.close();
        draw_numbers(svg, &numbers);
        Ok(())
    }

    /// The coloured cells: as many pixels as a dense screen shows, or one for each node if there
    /// are more.
    fn image(&self, columns: &[f64], rows: &[f64], frame: Frame) -> Result<Vec<u8>, PlotError> {
        let pixels = |edges: &[f64], length: f64| {
            let nodes = edges.len() - 1;
            cells(edges, nodes.max((DENSITY * length) as usize).min(MAX_PIXELS))
        };
        let across = pixels(columns, frame.width);
        let mut shades = Vec::new();
        for row in pixels(rows, frame.height).into_iter().rev() {
            let at = |column: &usize| self.place_in_palette(self.field.at(*column, row));
            shades.extend(across.iter().map(at));
        }
        let is_none_clear = !self.field.kinds().is_empty();
        indexed_png(across.len(), &shades, &self.palette(), is_none_clear)
    }

    /// Beside the axes: the bar, or the legend of the kinds.
    pub(crate) fn draw_aside(&self, svg: &mut Svg, frame: Frame) {
        let bar = Frame { x: frame.x + frame.width + GAP, width: BAR_WIDTH, ..frame };
        match self.field.kinds().is_empty() {
            true => self.draw_bar(svg, bar),
            false => self.draw_kinds(svg, bar),
        }
    }

    fn draw_kinds(&self, svg: &mut Svg, bar: Frame) {
        for (i, (kind, name)) in self.field.present().enumerate() {
            let y = bar.y + KIND_HEIGHT * i as f64;
            let [red, green, blue] = kind_colour(kind);
            let look = format!("fill=\"#{red:02x}{green:02x}{blue:02x}\" stroke=\"#444\"");
            svg.rect(Frame { y, height: BAR_WIDTH, ..bar }, &look);
            let at = Pixel { x: bar.x + BAR_WIDTH + 7.0, y: y + 0.5 * BAR_WIDTH + 4.5 };
            svg.text(at, Anchor::Start, name, Type::LEGEND);
        }
    }

    /// The bar with its ticks, and its label on the other side of them.
    fn draw_bar(&self, svg: &mut Svg, bar: Frame) {
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
        let (ticks, power) = self.span.ticks();
        for tick in ticks {
            let y = bar.y + bar.height * (1.0 - self.span.place(tick.at));
            svg.line(Pixel { x: end, y }, Pixel { x: end + 4.0, y }, "stroke=\"#444\"");
            svg.text(Pixel { x: end + 7.0, y: y + 4.5 }, Anchor::Start, &tick.label, Type::TICK);
        }
        let at = Pixel { x: bar.x + BAR_SPACE - GAP - 6.0, y: bar.y + 0.5 * bar.height };
        svg.text(at, Anchor::Middle, &with_power(&self.field.label, power), Type::UPWARDS);
    }
}

/// Largest number of contour lines: more hide the colours.
const MOST_LINES: usize = 60;
/// Least distance between two numbers on contour lines, along and across them.
const APART: [f64; 2] = [44.0, 18.0];
/// Shortest contour line that has a number.
const SHORTEST: f64 = 90.0;

fn is_near(one: Pixel, other: Pixel) -> bool {
    (one.x - other.x).abs() < APART[0] && (one.y - other.y).abs() < APART[1]
}

/// A number of quarters of a pixel. Lengths and places that differ by less count as equal, so that round-off does not
/// choose between mirror images. The borders between the numbers are off simple fractions of a pixel, where nodes stand.
fn quarters(pixels: f64) -> i64 {
    (4.0 * pixels + std::f64::consts::FRAC_1_PI).floor() as i64
}

/// The left end and the top of a line.
fn corner(line: &[Pixel]) -> [i64; 2] {
    [|at: &Pixel| at.x, |at: &Pixel| at.y]
        .map(|of| quarters(line.iter().map(of).fold(f64::INFINITY, f64::min)))
}

/// A place for the number of contour lines of one level: on the longest one, as far left as it goes on
/// free ground inside the frame; of equal ones the leftmost, then the topmost.
fn number_place(
    lines: &[Vec<Pixel>],
    frame: Frame,
    is_taken: impl Fn(Pixel) -> bool,
) -> Option<Pixel> {
    let length = |line: &[Pixel]| -> f64 {
        line.windows(2).map(|pair| libm::hypot(pair[1].x - pair[0].x, pair[1].y - pair[0].y)).sum()
    };
    let long = lines.iter().map(|line| (length(line), line));
    let (_, line) = long
        .filter(|(length, _)| *length > SHORTEST)
        .max_by_key(|(length, line)| (quarters(*length), Reverse(corner(line))))?;
    let inner = frame.grown(-0.5 * APART[0]);
    let sides = line.windows(2).flat_map(|ends| between(ends[0], ends[1]));
    let all = line.iter().copied().chain(sides);
    let free = all.filter(|at| inner.holds(*at) && !is_taken(*at));
    free.min_by_key(|at| [quarters(at.x), quarters(at.y)])
}

/// Numbers on contour lines, each on a light ground.
fn draw_numbers(svg: &mut Svg, numbers: &[(Pixel, String)]) {
    for (at, label) in numbers {
        let width = text_width(label, Type::TICK.size) + 4.0;
        let ground = Frame { x: at.x - 0.5 * width, y: at.y - 7.0, width, height: 14.0 };
        svg.rect(ground, "fill=\"#fff\" fill-opacity=\"0.8\" rx=\"2\"");
        svg.text(Pixel { x: at.x, y: at.y + 4.5 }, Anchor::Middle, label, Type::TICK);
    }
}

/// The borders of the cells along an axis.
fn edges(nodes: &[f64], [first, last]: [f64; 2], span: &Span) -> Vec<f64> {
    let places: Vec<f64> = nodes.iter().map(|node| span.place(*node)).collect();
    let mut edges = vec![span.place(first)];
    edges.extend(places.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])));
    edges.push(span.place(last));
    edges
}

/// The colour of the kind of this number; 0 is none.
fn kind_colour(number: usize) -> [u8; 3] {
    match number {
        0 => KINDS[0],
        number => KINDS[1 + (number - 1) % (KINDS.len() - 1)],
    }
}

/// For each of `count` pixels of equal width between the first and the last border, the cell that
/// contains its centre.
fn cells(edges: &[f64], count: usize) -> Vec<usize> {
    let (first, last) = (edges[0], edges[edges.len() - 1]);
    let mut cell = 0;
    (0..count)
        .map(|pixel| {
            let at = first + (last - first) * ((pixel as f64 + 0.5) / count as f64);
            while cell + 2 < edges.len() && edges[cell + 1] <= at {
                cell += 1;
            }
            cell
        })
        .collect()
}

fn rgb(shade: i32) -> [u8; 3] {
    let at = 2.0 * (1.0 + f64::from(shade) / SHADES).clamp(0.0, 2.0);
    let from = (at as usize).min(COLOURS.len() - 2);
    let part = at - from as f64;
    [0, 1, 2].map(|i| {
        libm::round(COLOURS[from][i] + part * (COLOURS[from + 1][i] - COLOURS[from][i])) as u8
    })
}

fn colour(shade: i32) -> String {
    let [red, green, blue] = rgb(shade);
    format!("#{red:02x}{green:02x}{blue:02x}")
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
    fn pixels_lie_in_the_cell_around_their_node() {
        let edges = [0.0, 0.125, 0.5, 1.0];
        assert_eq!(cells(&edges, 8), [0, 1, 1, 1, 2, 2, 2, 2]);
        assert_eq!(cells(&edges, 1), [2]);
    }

    #[test]
    fn the_image_has_the_first_row_of_the_field_below() {
        let nodes = vec![0.0, 1.0];
        let field = Field::new("q", nodes.clone(), nodes, vec![-1.0, -0.5, 0.5, 1.0]).unwrap();
        let frame = Frame { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        let edges = [0.0, 0.5, 1.0];
        let png = Heat::new(&field).unwrap().image(&edges, &edges, frame).unwrap();
        let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        let expected = [24, 48, -48, -24].map(rgb);
        assert_eq!(pixels, expected.as_flattened());
    }

    #[test]
    fn each_kind_has_its_colour_and_none_is_clear() {
        let nodes = vec![0.0, 1.0];
        let kinds = vec![Some(1), None, Some(0), Some(0)];
        let field = Field::of_kinds(["stick", "slip"], nodes.clone(), nodes, kinds).unwrap();
        let frame = Frame { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        let edges = [0.0, 0.5, 1.0];
        let png = Heat::new(&field).unwrap().image(&edges, &edges, frame).unwrap();
        let mut decoder = png::Decoder::new(std::io::Cursor::new(png));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        // The first row lies below.
        let alphas: Vec<u8> = pixels.iter().skip(3).step_by(4).copied().collect();
        assert_eq!(alphas, [255, 255, 255, 0]);
        let colours: Vec<&[u8]> = pixels.chunks(4).map(|pixel| &pixel[..3]).collect();
        assert_eq!(colours[..3], [KINDS[1], KINDS[1], KINDS[2]]);
        assert_eq!((kind_colour(1), kind_colour(6)), (KINDS[1], KINDS[1]));
    }

    #[test]
    fn a_kind_without_cells_is_not_in_the_legend() {
        let nodes = vec![0.0, 1.0];
        let slips = vec![Some(1); 4];
        let field = Field::of_kinds(["stick", "slip"], nodes.clone(), nodes, slips).unwrap();
        assert_eq!(field.present().collect::<Vec<_>>(), [(2, "slip")]);
        assert_eq!(field.label, "slip");
        let mut svg = Svg::default();
        let frame = Frame { x: 0.0, y: 0.0, width: 1.0, height: 1.0 };
        Heat::new(&field).unwrap().draw_aside(&mut svg, frame);
        let text = svg.finish(1.0, 1.0, "");
        let [red, green, blue] = kind_colour(2);
        assert!(
            text.contains(&format!("#{red:02x}{green:02x}{blue:02x}")) && !text.contains("stick")
        );
    }

    #[test]
    fn the_neutral_colour_stands_at_zero() {
        let values = vec![-1.0, 0.0, 0.25, 0.5];
        let field = Field::new("q", vec![0.0, 1.0], vec![0.0, 1.0], values).unwrap();
        let heat = Heat::new(&field).unwrap();
        assert_eq!((heat.shade(0.0), heat.shade(-1.0), heat.shade(0.5)), (0, -48, 24));
    }

    /// Of two mirrored arcs the left one has the number, and of its two ends the upper one, whatever the round-off.
    #[test]
    fn round_off_does_not_choose_between_mirror_images() {
        let frame = Frame { x: 0.0, y: 0.0, width: 400.0, height: 400.0 };
        let arc = |sign: f64, off: f64| -> Vec<Pixel> {
            let at = |y: f64| (y * y / 200.0 - 120.0) * sign * (1.0 + off * (y + 7.0));
            (-100..=100)
                .map(|y| Pixel { x: 200.0 + at(y.into()), y: 200.0 + f64::from(y) })
                .collect()
        };
        let bent =
            |off: f64| arc(1.0, off).into_iter().map(|at| Pixel { x: 400.0 - at.x, y: at.y });
        for [one, other] in [[0.0, 0.0], [1e-13, -1e-13], [-1e-13, 1e-13]] {
            let lines = [arc(1.0, one), arc(-1.0, other)];
            for lines in [lines.to_vec(), lines.into_iter().rev().collect()] {
                let at = number_place(&lines, frame, |_| false).unwrap();
                assert!(
                    (at.x - 80.0).abs() < 0.5 && (at.y - 200.0).abs() < 8.0,
                    "{} {}",
                    at.x,
                    at.y
                );
            }
            let ends = [bent(one).collect::<Vec<_>>()];
            let at = number_place(&ends, frame, |_| false).unwrap();
            assert!(at.y < 120.0, "{} {}", at.x, at.y);
        }
    }

    #[test]
    fn a_number_stands_on_its_line_inside_the_frame() {
        let frame = Frame { x: 0.0, y: 0.0, width: 300.0, height: 300.0 };
        let circle = |radius: f64| -> Vec<Pixel> {
            (0..=60)
                .map(|i| std::f64::consts::TAU * f64::from(i) / 60.0)
                .map(|t| Pixel { x: 150.0 + radius * t.cos(), y: 150.0 + radius * t.sin() })
                .collect()
        };
        // On the longest line, at its left end.
        let lines = [circle(30.0), circle(100.0)];
        let at = number_place(&lines, frame, |_| false).unwrap();
        assert!((at.x - 50.0).abs() < 1e-9 && (at.y - 150.0).abs() < 1e-9, "{at:?}");
        // Where that is taken, further along the same line.
        let next = number_place(&lines, frame, |other| is_near(other, at)).unwrap();
        assert!((libm::hypot(next.x - 150.0, next.y - 150.0) - 100.0).abs() < 1e-9);
        assert!(!is_near(next, at));
        // A short line has none, nor has one that leaves no room in the frame.
        assert_eq!(number_place(&[circle(10.0)], frame, |_| false), None);
        assert_eq!(number_place(&lines, frame, |_| true), None);
    }
}
