//! The look of lines and areas, the size of markers and the shape of arrows.

use crate::series::Stroke;
use crate::svg::Pixel;

/// Half the size of a marker, in pixels.
pub(crate) const MARKER: f64 = 3.6;

pub(crate) fn line_look(stroke: Stroke, colour: &str) -> String {
    let dashes = match stroke {
        Stroke::Solid => "",
        Stroke::Dashed => " stroke-dasharray=\"8 5\"",
        Stroke::Dotted => " stroke-dasharray=\"1.5 4\" stroke-linecap=\"round\"",
    };
    format!(
        "fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.8\" stroke-linejoin=\"round\"{dashes}"
    )
}

pub(crate) fn area_look(colour: &str) -> String {
    format!("fill=\"{colour}\" fill-opacity=\"0.18\" stroke=\"{colour}\"")
}

pub(crate) fn arrow(tail: Pixel, head: Pixel) -> Vec<Vec<Pixel>> {
    let (dx, dy) = (head.x - tail.x, head.y - tail.y);
    let length = libm::hypot(dx, dy);
    if length < 1.0 {
        return vec![vec![tail, head]];
    }
    let barb = (0.35 * length).min(6.0) / length;
    let end = |side: f64| Pixel {
        x: head.x - barb * (dx - side * dy),
        y: head.y - barb * (dy + side * dx),
    };
    vec![vec![tail, head], vec![end(0.5), head, end(-0.5)]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arrow_ends_in_its_head() {
        let (tail, head) = (Pixel { x: 0.0, y: 0.0 }, Pixel { x: 10.0, y: 0.0 });
        let strokes = arrow(tail, head);
        assert_eq!(strokes[0], [tail, head]);
        assert_eq!(strokes[1][1], head);
        assert!((strokes[1][0].x - strokes[1][2].x).abs() < 1e-12);
        assert!((strokes[1][0].y + strokes[1][2].y).abs() < 1e-12);
        assert_eq!(arrow(tail, Pixel { x: 0.5, y: 0.0 }).len(), 1, "a point has no barbs");
    }
}
