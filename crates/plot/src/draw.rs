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

/// The same colours for letters, dark enough to be read on white.
const LETTERS: [&str; 7] =
    ["#0072B2", "#B34700", "#007A59", "#A8487A", "#8A5F00", "#1F76A6", "#333333"];

/// From this number on, markers are drawn as one path, which needs a few bytes each.
const MARKERS_FOR_ONE_PATH: usize = 40;

/// Points of a line closer than this to the last one drawn are omitted, in pixels.
const LEAST_DISTANCE: f64 = 0.25;

/// The colour of a series that is the `index`-th of its panel.
pub(crate) fn colour(series: &Series, index: usize) -> &'static str {
    PALETTE[series.colour.unwrap_or(index) % PALETTE.len()]
}

/// The colour of letters that belong to what is drawn in this colour.
fn of_letters(colour: &str) -> &str {
    let index = PALETTE.iter().position(|known| *known == colour);
    index.map_or(colour, |index| LETTERS[index])
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
            markers(svg, shape, series.size * MARKER, &inside, colour);
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
            svg.open(&format!("fill=\"{}\"", of_letters(colour)));
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
pub(crate) fn sample(svg: &mut Svg, style: Style, size: f64, colour: &str, frame: Frame) {
    let y = frame.y + 0.5 * frame.height;
    let left = Pixel { x: frame.x, y };
    let right = Pixel { x: frame.x + frame.width, y };
    let middle = Pixel { x: frame.x + 0.5 * frame.width, y };
    match style {
        Style::Markers(shape) => marker(svg, shape, size * MARKER, middle, colour),
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

/// Markers of half the size `m`.
fn markers(svg: &mut Svg, shape: Marker, m: f64, pixels: &[Pixel], colour: &str) {
    if pixels.len() <= MARKERS_FOR_ONE_PATH {
        pixels.iter().for_each(|pixel| marker(svg, shape, m, *pixel, colour));
    } else {
        svg.repeated(&without_overlaps(pixels), &outline(shape, m), &look(shape, m, colour));
    }
}

/// Omits points within half a pixel of an earlier one.
fn without_overlaps(pixels: &[Pixel]) -> Vec<Pixel> {
    let cell = |pixel: &Pixel| [pixel.x, pixel.y].map(|value| (2.0 * value).round() as i64);
    let mut taken = HashSet::new();
    pixels.iter().filter(|pixel| taken.insert(cell(pixel))).copied().collect()
}

/// The shape as relative moves of a path from its centre; `m` is half the size of a marker.
fn outline(shape: Marker, m: f64) -> String {
    let stroke = |(x, y): (f64, f64)| {
        let [x, y] = [x * m, y * m];
        format!("m{:.1},{:.1} {:.1},{:.1}m{:.1},{:.1}", -x, -y, 2.0 * x, 2.0 * y, -x, -y)
    };
    match shape {
        Marker::Dot => "h0".to_owned(),
        Marker::Circle => {
            let d = 2.0 * m;
            format!("m-{m:.1},0a{m:.1},{m:.1} 0 1 0 {d:.1},0a{m:.1},{m:.1} 0 1 0-{d:.1},0")
        }
        Marker::Square => {
            let (half, side) = (0.9 * m, 1.8 * m);
            format!("m-{half:.1}-{half:.1}h{side:.1}v{side:.1}h-{side:.1}z")
        }
        Marker::Triangle => {
            format!("m0-{:.1} {:.1},{:.1}h-{:.1}z", 1.2 * m, 1.1 * m, 2.0 * m, 2.2 * m)
        }
        Marker::Cross => CROSS.map(stroke).concat(),
        Marker::Star => STAR.map(stroke).concat(),
    }
}

/// The ends of the strokes of a cross and of a star, in halves of its size.
const CROSS: [(f64, f64); 2] = [(0.9, 0.9), (0.9, -0.9)];
const STAR: [(f64, f64); 4] = [(1.1, 0.0), (0.0, 1.1), (0.75, 0.75), (0.75, -0.75)];

fn look(shape: Marker, m: f64, colour: &str) -> String {
    match shape {
        Marker::Dot => format!(
            "fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\" stroke-linecap=\"round\"",
            1.6 * m
        ),
        Marker::Triangle => format!("fill=\"{colour}\""),
        _ => format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.4\""),
    }
}

fn marker(svg: &mut Svg, shape: Marker, m: f64, at: Pixel, colour: &str) {
    let filled = format!("fill=\"{colour}\"");
    let open = format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.4\"");
    let shifted = |x: f64, y: f64| Pixel { x: at.x + x * m, y: at.y + y * m };
    let mut strokes = |ends: &[(f64, f64)]| {
        for (x, y) in ends {
            svg.line(shifted(-x, -y), shifted(*x, *y), &open);
        }
    };
    match shape {
        Marker::Dot => svg.circle(at, 0.8 * m, &filled),
        Marker::Circle => svg.circle(at, m, &open),
        Marker::Square => {
            let (x, y, size) = (at.x - 0.9 * m, at.y - 0.9 * m, 1.8 * m);
            svg.rect(Frame { x, y, width: size, height: size }, &open);
        }
        Marker::Triangle => {
            let corners = [(0.0, -1.2), (1.1, 0.8), (-1.1, 0.8)].map(|(x, y)| shifted(x, y));
            svg.path("polygon", corners.into_iter(), &filled);
        }
        Marker::Cross => strokes(&CROSS),
        Marker::Star => strokes(&STAR),
    }
}

/// Arrows, given by tail and head alternately.
fn arrows(svg: &mut Svg, ends: &[Pixel]) {
    let strokes = ends.chunks_exact(2).flat_map(|ends| arrow(ends[0], ends[1]));
    svg.lines(strokes, "stroke-width=\"1.3\" fill=\"none\"");
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance, as the guidelines for accessible pages (WCAG 2) define it.
    fn luminance(hex: &str) -> f64 {
        let part = |i: usize| f64::from(u8::from_str_radix(&hex[i..i + 2], 16).unwrap()) / 255.0;
        let linear = [1, 3, 5].map(part).map(|c| match c <= 0.040_45 {
            true => c / 12.92,
            false => libm::pow((c + 0.055) / 1.055, 2.4),
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    }

    #[test]
    fn letters_stand_out_from_white() {
        for colour in PALETTE {
            let contrast = 1.05 / (luminance(of_letters(colour)) + 0.05);
            assert!(contrast >= 4.5, "{colour}: {contrast:.2}");
        }
        assert_eq!(of_letters("#123456"), "#123456");
    }

    #[test]
    fn many_markers_are_one_path() {
        let row = |count: i32| -> Vec<Pixel> {
            (0..count).map(|i| Pixel { x: 10.0 * f64::from(i), y: 1.25 }).collect()
        };
        let drawn = |pixels: &[Pixel]| {
            let mut svg = Svg::default();
            markers(&mut svg, Marker::Dot, MARKER, pixels, "#000");
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
