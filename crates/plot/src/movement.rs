//! Animated series: each shape with the list of its positions, played by the browser.

use crate::error::PlotError;
use crate::look::{MARKER, area_look, arrow, line_look};
use crate::series::{Marker, Motion, Point, Series, Style};
use crate::svg::{Anchor, Pixel, Svg};
use crate::text::Type;

/// Checks that a series can be animated as requested.
pub(crate) fn check(series: &Series) -> Result<(), PlotError> {
    let Some(Motion { seconds, frames }) = &series.motion else { return Ok(()) };
    let invalid = |reason| Err(PlotError::Motion { label: series.label.clone(), reason });
    let count = series.points.len();
    match () {
        () if !(seconds.is_finite() && *seconds > 0.0) => invalid("its duration is not positive"),
        () if frames.is_empty() => invalid("it has no frames"),
        () if frames.iter().any(|frame| frame.len() != count) => {
            invalid("a frame has not as many points as the series")
        }
        () if frames.iter().flatten().any(|at| !(at.x.is_finite() && at.y.is_finite())) => {
            invalid("a frame has a point that is not finite")
        }
        () if matches!(series.style, Style::Markers(marker) if marker != Marker::Dot || count != 1) => {
            invalid("of markers only a single dot moves")
        }
        () => Ok(()),
    }
}

/// Draws an animated series that passed [`check`].
pub(crate) fn draw(
    svg: &mut Svg,
    series: &Series,
    motion: &Motion,
    colour: &str,
    place: impl Fn(Point) -> Pixel,
) {
    let frames: Vec<Vec<Pixel>> =
        motion.frames.iter().map(|frame| frame.iter().map(|at| place(*at)).collect()).collect();
    let still: Vec<Pixel> = series.points.iter().map(|at| place(*at)).collect();
    match series.style {
        Style::Line(stroke) => {
            svg.moving_path(
                "polyline",
                &still,
                &frames,
                motion.seconds,
                &line_look(stroke, colour),
            );
        }
        Style::Area => {
            svg.moving_path("polygon", &still, &frames, motion.seconds, &area_look(colour));
        }
        Style::Arrows => {
            let look = format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"2.2\"");
            for i in (0..still.len() / 2).map(|i| 2 * i) {
                let one = |frame: &Vec<Pixel>| one_stroke(frame[i], frame[i + 1]);
                let strokes: Vec<_> = frames.iter().map(one).collect();
                svg.moving_path("polyline", &one(&still), &strokes, motion.seconds, &look);
            }
        }
        Style::Markers(_) => svg.moving_circle(
            still[0],
            &frames.iter().map(|frame| frame[0]).collect::<Vec<_>>(),
            1.4 * MARKER,
            motion.seconds,
            &format!("fill=\"{colour}\""),
        ),
        Style::Note => {
            let to = |frame: &Vec<Pixel>| frame.first().copied();
            let path: Vec<Pixel> = frames.iter().filter_map(to).collect();
            svg.jumping(&path, motion.seconds);
            let look = Type { bold: true, ..Type::TICK };
            svg.text(Pixel { x: 0.0, y: 0.0 }, Anchor::Start, &series.label, look);
            svg.close();
        }
    }
}

/// An arrow drawn as one line.
fn one_stroke(tail: Pixel, head: Pixel) -> Vec<Pixel> {
    match arrow(tail, head).as_slice() {
        [_, barbs] => vec![tail, head, barbs[0], head, barbs[2]],
        _ => vec![tail, head, head, head, head],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panel::Panel;
    use crate::render::{render, render_png};

    fn alone(series: Series) -> Panel {
        let mut panel = Panel::new("x", "y");
        panel.add(series);
        panel
    }

    fn dot(frames: &[(f64, f64)]) -> Series {
        let frames = frames.iter().map(|at| vec![Point::from(*at)]);
        Series::markers("dot", Marker::Dot, [(0.0, 0.0)]).moving(2.0, frames)
    }

    #[test]
    fn the_axes_hold_every_frame() {
        let svg = render("", &[alone(dot(&[(0.0, 0.0), (1000.0, 5.0)]))]).unwrap();
        assert!(svg.contains(">1000<"));
    }

    #[test]
    fn every_style_moves_and_stands_still_in_pixels() {
        let ends = [Point::new(0.0, 0.0), Point::new(1.0, 1.0)];
        let moved = [Point::new(0.5, 0.0), Point::new(1.0, 2.0)];
        let styles = [
            Series::line("line", ends),
            Series::area("area", ends),
            Series::arrows("arrow", [crate::Arrow { tail: ends[0], head: ends[1] }]),
        ];
        let mut panel = alone(dot(&[(0.0, 0.0), (1.0, 1.0)]));
        for series in styles {
            panel.add(series.moving(2.0, [ends.to_vec(), moved.to_vec()]));
        }
        panel.add(Series::note("here", ends[0]).moving(2.0, [vec![ends[0]], vec![ends[1]]]));
        let svg = render("", &[panel.clone()]).unwrap();
        assert_eq!(svg.matches("<animate ").count(), 5, "a dot has two coordinates");
        assert_eq!(svg.matches("<animateTransform ").count(), 1);
        assert_eq!(svg.matches("<g ").count(), svg.matches("</g>").count());
        assert!(render_png("", &[panel]).is_ok());
    }

    #[test]
    fn what_cannot_move_is_refused() {
        let bad = [
            dot(&[]),
            dot(&[(0.0, f64::NAN)]),
            Series::markers("", Marker::Star, [(0.0, 0.0)])
                .moving(1.0, [vec![Point::new(0.0, 0.0)]]),
            Series::line("", [(0.0, 0.0), (1.0, 1.0)]).moving(1.0, [vec![Point::new(0.0, 0.0)]]),
            Series::note("", (0.0, 0.0)).moving(0.0, [vec![Point::new(0.0, 0.0)]]),
        ];
        for series in bad {
            let invalid = render("", &[alone(series)]);
            assert!(matches!(invalid, Err(PlotError::Motion { .. })), "{invalid:?}");
        }
    }
}
