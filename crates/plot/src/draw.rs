//! Drawing one series.

use crate::look::{MARKER, area_look, arrow, line_look};
use crate::movement;
use crate::series::{Marker, Point, Series, Stroke, Style};
use crate::svg::{Anchor, Frame, Pixel, Svg};
use crate::text::Type;
use std::collections::HashSet;

/// Okabe and Ito's palette, ordered such that neighbours are easy to distinguish; black last.
const PALETTE: [&str; 7] =
    ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#333333"];

/// From this number on, markers are drawn as one path, which needs a few bytes each.
const MARKERS_FOR_ONE_PATH: usize = 40;

/// Points of a line closer than this to the last one drawn are omitted, in pixels.
const LEAST_DISTANCE: f64 = 0.25;

/// The colour of a series that is the `index`-th of its panel.
pub(crate) fn colour(series: &Series, index: usize) -> &'static str {
    PALETTE[series.colour.unwrap_or(index) % PALETTE.len()]
}

/// How a series is drawn, and where.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ink<'a> {
    pub(crate) style: Style,
    pub(crate) colour: &'a str,
    /// The name of the clip path of the axes.
    pub(crate) clip: &'a str,
    /// The frame of the axes.
    pub(crate) frame: Frame,
}

/// Draws these points of a series.
pub(crate) fn series(
    svg: &mut Svg,
    series: &Series,
    points: &[Point],
    ink: Ink<'_>,
    place: impl Fn(Point) -> Pixel,
) {
    let Ink { style, colour, clip, frame } = ink;
    if let Some(motion) = &series.motion {
        svg.open(&format!("clip-path=\"url(#{clip})\""));
        movement::draw(svg, series, motion, colour, place);
        svg.close();
        return;
    }
    let pixels: Vec<Pixel> = points.iter().map(|point| place(*point)).collect();
    match style {
        Style::Markers(shape) => {
            let inside: Vec<_> = pixels.into_iter().filter(|pixel| frame.holds(*pixel)).collect();
            markers(svg, shape, &inside, colour);
        }
        Style::Line(stroke) => {
            svg.open(&format!("clip-path=\"url(#{clip})\""));
            line(svg, stroke, thinned(&pixels).into_iter(), colour);
            svg.close();
        }
        Style::Area => {
            svg.open(&format!("clip-path=\"url(#{clip})\""));
            svg.path("polygon", pixels.into_iter(), &area_look(colour));
            svg.close();
        }
        Style::Arrows => {
            svg.open(&format!("clip-path=\"url(#{clip})\" stroke=\"{colour}\""));
            arrows(svg, &pixels);
            svg.close();
        }
        Style::Note => {
            svg.open(&format!("fill=\"{colour}\""));
            for pixel in pixels.into_iter().filter(|pixel| frame.holds(*pixel)) {
                // Above the point, towards the middle of the frame.
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
pub(crate) fn sample(svg: &mut Svg, style: Style, colour: &str, frame: Frame) {
    let y = frame.y + 0.5 * frame.height;
    let left = Pixel { x: frame.x, y };
    let right = Pixel { x: frame.x + frame.width, y };
    let middle = Pixel { x: frame.x + 0.5 * frame.width, y };
    match style {
        Style::Markers(shape) => marker(svg, shape, middle, colour),
        Style::Line(stroke) => line(svg, stroke, [left, right].into_iter(), colour),
        Style::Area => svg.rect(Frame { y: y - 5.0, height: 10.0, ..frame }, &area_look(colour)),
        Style::Arrows => {
            svg.open(&format!("stroke=\"{colour}\""));
            arrows(svg, &[left, right]);
            svg.close();
        }
        Style::Note => {}
    }
}

fn line(svg: &mut Svg, stroke: Stroke, pixels: impl Iterator<Item = Pixel>, colour: &str) {
    svg.path("polyline", pixels, &line_look(stroke, colour));
}

/// Omits points that cannot be distinguished from the one before.
pub(crate) fn thinned(pixels: &[Pixel]) -> Vec<Pixel> {
    let mut last: Option<Pixel> = None;
    let kept = pixels.iter().enumerate().filter_map(|(i, pixel)| {
        let is_close = last.is_some_and(|last| {
            (pixel.x - last.x).abs() < LEAST_DISTANCE && (pixel.y - last.y).abs() < LEAST_DISTANCE
        });
        if is_close && i + 1 < pixels.len() {
            return None;
        }
        last = Some(*pixel);
        last
    });
    kept.collect()
}

fn markers(svg: &mut Svg, shape: Marker, pixels: &[Pixel], colour: &str) {
    if pixels.len() <= MARKERS_FOR_ONE_PATH {
        pixels.iter().for_each(|pixel| marker(svg, shape, *pixel, colour));
    } else {
        svg.repeated(&without_overlaps(pixels), outline(shape), &look(shape, colour));
    }
}

/// Omits points within half a pixel of an earlier one.
fn without_overlaps(pixels: &[Pixel]) -> Vec<Pixel> {
    let cell = |pixel: &Pixel| [pixel.x, pixel.y].map(|value| (2.0 * value).round() as i64);
    let mut taken = HashSet::new();
    pixels.iter().filter(|pixel| taken.insert(cell(pixel))).copied().collect()
}

/// The shape as relative moves of a path from its centre.
const fn outline(shape: Marker) -> &'static str {
    match shape {
        Marker::Dot => "h0",
        Marker::Circle => "m-3.6,0a3.6,3.6 0 1 0 7.2,0a3.6,3.6 0 1 0-7.2,0",
        Marker::Square => "m-3.2-3.2h6.4v6.4h-6.4z",
        Marker::Triangle => "m0-4.3 4,7.2h-8z",
        Marker::Cross => "m-3.2-3.2 6.4,6.4m-6.4,0 6.4-6.4",
        Marker::Star => "m-4,0h8m-4-4v8m-2.7-6.7 5.4,5.4m-5.4,0 5.4-5.4",
    }
}

fn look(shape: Marker, colour: &str) -> String {
    match shape {
        Marker::Dot => format!(
            "fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\" stroke-linecap=\"round\"",
            1.6 * MARKER
        ),
        Marker::Triangle => format!("fill=\"{colour}\""),
        _ => format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.4\""),
    }
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

/// Lines through `at`, each given by one of its ends.
fn strokes(svg: &mut Svg, at: Pixel, ends: &[(f64, f64)], look: &str) {
    for (x, y) in ends {
        svg.line(shifted(at, -x, -y), shifted(at, *x, *y), look);
    }
}

/// `at`, moved by marker sizes.
fn shifted(at: Pixel, x: f64, y: f64) -> Pixel {
    Pixel { x: at.x + x * MARKER, y: at.y + y * MARKER }
}

/// Arrows, given by tail and head alternately.
fn arrows(svg: &mut Svg, ends: &[Pixel]) {
    let strokes = ends.chunks_exact(2).flat_map(|ends| arrow(ends[0], ends[1]));
    svg.lines(strokes, "stroke-width=\"1.3\" fill=\"none\"");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_markers_are_one_path() {
        let row = |count: i32| -> Vec<Pixel> {
            (0..count).map(|i| Pixel { x: 10.0 * f64::from(i), y: 1.25 }).collect()
        };
        let drawn = |pixels: &[Pixel]| {
            let mut svg = Svg::default();
            markers(&mut svg, Marker::Dot, pixels, "#000");
            svg.finish(1.0, 1.0, "")
        };
        let few = drawn(&row(40));
        assert_eq!((few.matches("<circle").count(), few.matches("<path").count()), (40, 0));
        let many = drawn(&row(41));
        assert_eq!((many.matches("<circle").count(), many.matches("<path").count()), (0, 1));
        assert_eq!(many.matches("h0").count(), 41);
        let twice = drawn(&[row(41), row(41)].concat());
        assert_eq!(twice.matches("h0").count(), 41, "what covers another is left out");
    }
}
