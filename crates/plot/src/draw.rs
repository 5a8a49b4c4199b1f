//! Drawing one series.

use crate::series::{Marker, Point, Series, Stroke, Style};
use crate::svg::{Anchor, Frame, Pixel, Svg};
use crate::text::Type;

/// Okabe and Ito's colours, in an order that keeps neighbours apart; black last.
const PALETTE: [&str; 7] =
    ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#333333"];

/// Half the size of a marker, in pixels.
const MARKER: f64 = 3.6;

/// Points on a line that are closer than this to the last one drawn are left out.
const CLOSE: f64 = 0.25;

/// The colour of a series that is the `index`-th of its panel.
pub(crate) fn colour(series: &Series, index: usize) -> &'static str {
    PALETTE[series.colour.unwrap_or(index) % PALETTE.len()]
}

/// Draws the series whose points stand at `pixels`; what lies outside `frame` is cut.
pub(crate) fn series(
    svg: &mut Svg,
    series: &Series,
    colour: &str,
    clip: &str,
    frame: Frame,
    place: impl Fn(Point) -> Pixel,
) {
    let pixels: Vec<Pixel> = series.points.iter().map(|point| place(*point)).collect();
    match series.style {
        Style::Markers(shape) => {
            for pixel in pixels.into_iter().filter(|pixel| frame.holds(*pixel)) {
                marker(svg, shape, pixel, colour);
            }
        }
        Style::Line(stroke) => {
            svg.open(&format!("clip-path=\"url(#{clip})\""));
            line(svg, stroke, thinned(&pixels).into_iter(), colour);
            svg.close();
        }
        Style::Area => {
            svg.open(&format!("clip-path=\"url(#{clip})\""));
            let look = format!("fill=\"{colour}\" fill-opacity=\"0.18\" stroke=\"{colour}\"");
            svg.path("polygon", pixels.into_iter(), &look);
            svg.close();
        }
        Style::Arrows => {
            svg.open(&format!("clip-path=\"url(#{clip})\" stroke=\"{colour}\""));
            for arrow in pixels.chunks_exact(2) {
                self::arrow(svg, arrow[0], arrow[1]);
            }
            svg.close();
        }
        Style::Note => {
            svg.open(&format!("fill=\"{colour}\""));
            for pixel in pixels.into_iter().filter(|pixel| frame.holds(*pixel)) {
                // Above the point, and towards the middle of the frame.
                let is_right = pixel.x > frame.x + 0.8 * frame.width;
                let (anchor, aside) =
                    if is_right { (Anchor::End, -4.0) } else { (Anchor::Start, 4.0) };
                let at = Pixel { x: pixel.x + aside, y: pixel.y - 5.0 };
                svg.text(at, anchor, &series.label, Type::TICK);
            }
            svg.close();
        }
    }
}

/// Draws a short piece of the series for the legend, in the middle of `frame`.
pub(crate) fn sample(svg: &mut Svg, series: &Series, colour: &str, frame: Frame) {
    let y = frame.y + 0.5 * frame.height;
    let left = Pixel { x: frame.x, y };
    let right = Pixel { x: frame.x + frame.width, y };
    let middle = Pixel { x: frame.x + 0.5 * frame.width, y };
    match series.style {
        Style::Markers(shape) => marker(svg, shape, middle, colour),
        Style::Line(stroke) => line(svg, stroke, [left, right].into_iter(), colour),
        Style::Area => svg.rect(
            Frame { y: y - 5.0, height: 10.0, ..frame },
            &format!("fill=\"{colour}\" fill-opacity=\"0.18\" stroke=\"{colour}\""),
        ),
        Style::Arrows => {
            svg.open(&format!("stroke=\"{colour}\""));
            arrow(svg, left, right);
            svg.close();
        }
        Style::Note => {}
    }
}

fn line(svg: &mut Svg, stroke: Stroke, pixels: impl Iterator<Item = Pixel>, colour: &str) {
    let dashes = match stroke {
        Stroke::Solid => "",
        Stroke::Dashed => " stroke-dasharray=\"8 5\"",
        Stroke::Dotted => " stroke-dasharray=\"1.5 4\" stroke-linecap=\"round\"",
    };
    let look = format!(
        "fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.8\" stroke-linejoin=\"round\"{dashes}"
    );
    svg.path("polyline", pixels, &look);
}

/// Without the points that nobody could tell from the one before.
pub(crate) fn thinned(pixels: &[Pixel]) -> Vec<Pixel> {
    let mut last: Option<Pixel> = None;
    let kept = pixels.iter().enumerate().filter_map(|(i, pixel)| {
        let is_close = last.is_some_and(|last| {
            (pixel.x - last.x).abs() < CLOSE && (pixel.y - last.y).abs() < CLOSE
        });
        if is_close && i + 1 < pixels.len() {
            return None;
        }
        last = Some(*pixel);
        last
    });
    kept.collect()
}

fn marker(svg: &mut Svg, shape: Marker, at: Pixel, colour: &str) {
    let filled = format!("fill=\"{colour}\"");
    let open = format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.4\"");
    match shape {
        Marker::Dot => svg.circle(at, 0.8 * MARKER, &filled),
        Marker::Circle => svg.circle(at, MARKER, &open),
        Marker::Square => {
            let (x, y, size) = (at.x - 0.9 * MARKER, at.y - 0.9 * MARKER, 1.8 * MARKER);
            svg.rect(Frame { x, y, width: size, height: size }, &open);
        }
        Marker::Triangle => {
            let corners = [(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)];
            let corners = corners.map(|(x, y)| shifted(at, x, y)).into_iter();
            svg.path("polygon", corners, &filled);
        }
        Marker::Cross => strokes(svg, at, &[(0.9, 0.9), (0.9, -0.9)], &open),
        Marker::Star => {
            strokes(svg, at, &[(1.1, 0.0), (0.0, 1.1), (0.75, 0.75), (0.75, -0.75)], &open);
        }
    }
}

/// Strokes through `at`, each given by one of its ends.
fn strokes(svg: &mut Svg, at: Pixel, ends: &[(f64, f64)], look: &str) {
    for (x, y) in ends {
        svg.line(shifted(at, -x, -y), shifted(at, *x, *y), look);
    }
}

/// `at`, moved by marker sizes.
fn shifted(at: Pixel, x: f64, y: f64) -> Pixel {
    Pixel { x: at.x + x * MARKER, y: at.y + y * MARKER }
}

fn arrow(svg: &mut Svg, tail: Pixel, head: Pixel) {
    svg.line(tail, head, "stroke-width=\"1.3\"");
    let (dx, dy) = (head.x - tail.x, head.y - tail.y);
    let length = libm::hypot(dx, dy);
    if length < 1.0 {
        return;
    }
    let barb = (0.35 * length).min(6.0) / length;
    for side in [0.5, -0.5] {
        let end =
            Pixel { x: head.x - barb * (dx - side * dy), y: head.y - barb * (dy + side * dx) };
        svg.line(head, end, "stroke-width=\"1.3\"");
    }
}
