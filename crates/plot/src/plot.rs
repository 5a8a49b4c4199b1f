//! One panel as it is drawn: axes, series, legend.

use crate::axes::Axes;
use crate::draw;
use crate::error::PlotError;
use crate::heat::Heat;
use crate::legend::Legend;
use crate::movement;
use crate::panel::{Axis, Panel};
use crate::series::{Point, Series, Stroke, Style};
use crate::svg::{Anchor, Frame, Pixel, Svg};
use crate::text::Type;

/// Lines closer than this everywhere are one to the eye, in pixels.
const SAME: f64 = 0.7;

/// A panel with its axes fitted to the data.
pub(crate) struct Plot<'a> {
    panel: &'a Panel,
    styles: Vec<Style>,
    legend: Legend<'a>,
    heat: Option<Heat<'a>>,
    axes: Axes<'a>,
    /// Where the legend stands if there is no space between the axes.
    outside: Outside,
}

/// A place outside the axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outside {
    /// To the right, where pictures stand side by side.
    Beside,
    /// Below, where a picture must be narrow.
    Below,
}

/// Leaves out of each legend what an earlier panel with the same axes explains.
pub(crate) fn share_legends(plots: &mut [Plot<'_>]) {
    for i in 1..plots.len() {
        let (earlier, later) = plots.split_at_mut(i);
        let own = later[0].panel;
        let has_same_axes = |plot: &&Plot<'_>| {
            (&plot.panel.x.label, &plot.panel.y.label) == (&own.x.label, &own.y.label)
        };
        for plot in earlier.iter().filter(has_same_axes) {
            later[0].legend.leave_out(&plot.legend);
        }
    }
}

impl<'a> Plot<'a> {
    pub(crate) fn new(panel: &'a Panel) -> Result<Self, PlotError> {
        check_finite(panel)?;
        let axes = Axes::of(panel)?;
        let heat = panel.field.as_ref().map(Heat::new).transpose()?;
        let legend = Legend::default();
        let styles = panel.series.iter().map(|series| series.style).collect();
        let mut plot = Self { panel, styles, legend, heat, axes, outside: Outside::Beside };
        plot.tell_apart();
        plot.legend = Legend::of(panel, &plot.styles);
        Ok(plot)
    }

    /// The same with its legend there if there is no space between the axes.
    pub(crate) fn with_legend(self, outside: Outside) -> Self {
        Self { outside, ..self }
    }

    /// A solid line that hides an earlier one is dashed, so that both are seen.
    fn tell_apart(&mut self) {
        let frame = self.axes.frame_at(Pixel { x: 0.0, y: 0.0 });
        let solid = |series: &&Series| {
            series.style == Style::Line(Stroke::Solid) && series.motion.is_none()
        };
        for i in 1..self.panel.series.len() {
            let own = &self.panel.series[i];
            let hides = |other: &Series| {
                let near = |(a, b): (&Point, &Point)| {
                    let (a, b) = (self.axes.place(*a, frame), self.axes.place(*b, frame));
                    (a.x - b.x).abs() < SAME && (a.y - b.y).abs() < SAME
                };
                let is_other = other.colour.unwrap_or(usize::MAX) != own.colour.unwrap_or(i);
                is_other
                    && !own.label.is_empty()
                    && own.points.len() == other.points.len()
                    && own.points.iter().zip(&other.points).all(near)
            };
            if solid(&own) && self.panel.series[..i].iter().filter(solid).any(hides) {
                self.styles[i] = Style::Line(Stroke::Dashed);
            }
        }
    }

    /// Width with the colour bar or legend beside the axes.
    pub(crate) fn width(&self) -> f64 {
        self.axes.width() + self.aside().unwrap_or(0.0)
    }

    /// Height with title, ticks, labels and a legend below.
    pub(crate) fn height(&self) -> f64 {
        let frame = self.axes.frame_at(Pixel { x: 0.0, y: 0.0 });
        let below = self.place_of_legend(frame).filter(|_| self.outside == Outside::Below);
        let end = below.map_or(0.0, |place| place.y + place.height + 8.0);
        self.axes.height().max(end)
    }

    /// The frame of the legend: between the axes if there is space, otherwise outside.
    fn place_of_legend(&self, frame: Frame) -> Option<Frame> {
        self.legend.free_corner(frame, &self.inked(frame)).or_else(|| match self.outside {
            Outside::Below => self.legend.below(frame, self.axes.height()),
            Outside::Beside => {
                let place = self.legend.beside(frame)?;
                Some(self.heat.as_ref().map_or(place, |heat| heat.clear_of_aside(place)))
            }
        })
    }

    /// What is drawn, in words.
    pub(crate) fn spoken(&self) -> String {
        let Panel { title, x, y, .. } = self.panel;
        let axes = match (x.label.as_str(), y.label.as_str()) {
            ("", "") => String::new(),
            ("", y) => y.to_owned(),
            (x, "") => format!("over {x}"),
            (x, y) => format!("{y} over {x}"),
        };
        let field = self.panel.field.iter().map(|field| field.label.clone());
        let names = field.chain(self.legend.labels().map(str::to_owned)).collect::<Vec<_>>();
        let parts = [title.clone(), axes, names.join(", ")];
        let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
        parts.join(": ").replace(['_', '^'], " ")
    }

    /// Space needed for a colour bar or legend beside the axes.
    fn aside(&self) -> Option<f64> {
        let frame = self.axes.frame_at(Pixel { x: 0.0, y: 0.0 });
        let end = self.place_of_legend(frame).map(|place| place.x + place.width);
        let legend = end.map(|end| end - frame.x - frame.width).filter(|beyond| *beyond > 0.0);
        let bar = self.heat.as_ref().map(Heat::aside);
        bar.into_iter().chain(legend).reduce(f64::max)
    }

    pub(crate) fn draw(&self, svg: &mut Svg, corner: Pixel, clip: &str) -> Result<(), PlotError> {
        let frame = self.axes.frame_at(corner);
        svg.clip(clip, frame);
        self.axes.draw(svg, frame);
        if let Some(heat) = &self.heat {
            heat.draw(svg, clip, self.axes.spans(), frame)?;
            heat.draw_aside(svg, frame);
            svg.rect(frame, "fill=\"none\" stroke=\"#444\"");
        }
        for (i, series) in self.panel.series.iter().enumerate() {
            let colour = draw::colour(series, i);
            let place = |point| self.axes.place(point, frame);
            for piece in self.pieces(series) {
                let ink = draw::Ink { style: self.styles[i], colour, clip, frame };
                draw::series(svg, series, piece, ink, place);
            }
        }
        let title = Pixel { x: frame.x + 0.5 * frame.width, y: frame.y - 10.0 };
        svg.text(title, Anchor::Middle, &self.panel.title, Type::LABEL);
        if let Some(place) = self.place_of_legend(frame) {
            self.legend.draw(svg, place);
        }
        Ok(())
    }

    /// The points of a series, a line cut where it jumps by more than half a period.
    fn pieces<'s>(&self, series: &'s Series) -> Vec<&'s [Point]> {
        let Panel { x, y, .. } = self.panel;
        let is_line = matches!(series.style, Style::Line(_)) && series.motion.is_none();
        if !is_line || (x.period.is_none() && y.period.is_none()) {
            return vec![&series.points];
        }
        let jumps = |axis: &Axis, way: f64| axis.period.is_some_and(|p| way.abs() > 0.5 * p);
        let joined = |a: &Point, b: &Point| !jumps(x, b.x - a.x) && !jumps(y, b.y - a.y);
        series.points.chunk_by(joined).collect()
    }

    /// Occupied pixels: markers, and points every few pixels along lines.
    fn inked(&self, frame: Frame) -> Vec<Pixel> {
        let mut inked = Vec::new();
        for series in &self.panel.series {
            for piece in self.pieces(series) {
                let pixels: Vec<Pixel> = piece.iter().map(|p| self.axes.place(*p, frame)).collect();
                if !matches!(series.style, Style::Markers(_) | Style::Note) {
                    inked.extend(pixels.windows(2).flat_map(|ends| between(ends[0], ends[1])));
                }
                inked.extend(pixels);
            }
        }
        inked
    }
}

fn check_finite(panel: &Panel) -> Result<(), PlotError> {
    for series in &panel.series {
        let bad = |point: &Point| !(point.x.is_finite() && point.y.is_finite());
        if let Some(index) = series.points.iter().position(bad) {
            let Point { x, y } = series.points[index];
            return Err(PlotError::NotFinite { label: series.label.clone(), index, x, y });
        }
        movement::check(series)?;
    }
    Ok(())
}

/// Pixels on the line from one to the other.
pub(crate) fn between(from: Pixel, to: Pixel) -> impl Iterator<Item = Pixel> {
    let steps = (libm::hypot(to.x - from.x, to.y - from.y) / 8.0).min(200.0) as usize;
    (1..=steps).map(move |i| {
        let part = i as f64 / (steps + 1) as f64;
        Pixel { x: from.x + part * (to.x - from.x), y: from.y + part * (to.y - from.y) }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Field;

    fn panel() -> Panel {
        Panel::new(Axis::linear("x"), Axis::linear("y"))
    }

    #[test]
    fn the_legend_avoids_the_curves() {
        let mut rising = panel();
        rising.add(Series::line("rising", [(0.0, 0.0), (1.0, 1.0)]));
        let plot = Plot::new(&rising).unwrap();
        assert_eq!(plot.aside(), None);
        let mut dense = panel();
        for i in 0..12 {
            let slope = f64::from(i) / 11.0;
            dense.add(Series::line(
                format!("slope {slope:.2}"),
                carom_special::linspace(-1.0, 1.0, 9).into_iter().map(|x| (x, slope * x + slope)),
            ));
        }
        assert!(Plot::new(&dense).unwrap().aside().is_some());
    }

    /// Beside the axes, clear of the bar or of the kinds.
    #[test]
    fn a_line_over_a_field_keeps_its_name() {
        let nodes = vec![0.0, 1.0];
        let bar = Field::new("p", nodes.clone(), nodes.clone(), vec![0.0, 1.0, 2.0, 3.0]).unwrap();
        let kinds = vec![Some(0), Some(1), None, Some(1)];
        let kinds = Field::of_kinds(["stick", "slip"], nodes.clone(), nodes, kinds).unwrap();
        for (field, is_bar) in [(bar, true), (kinds, false)] {
            let mut dense = panel().over(field);
            for i in 0..48 {
                let height = f64::from(i) / 24.0 - 0.5;
                let line = [(-0.5, height), (1.5, height)];
                dense.add(Series::line(if i == 0 { "leading edge" } else { "" }, line));
            }
            let plot = Plot::new(&dense).unwrap();
            let frame = plot.axes.frame_at(Pixel { x: 0.0, y: 0.0 });
            let place = plot.place_of_legend(frame).unwrap();
            let aside = plot.heat.as_ref().unwrap().aside();
            let end = frame.x + frame.width;
            assert!(place.x > end && (place.x >= end + aside || place.y >= frame.y + 44.0));
            assert_eq!(place.x >= end + aside, is_bar);
            assert!(plot.aside().unwrap() >= place.x + place.width - end);
        }
    }

    #[test]
    fn a_line_that_hides_another_is_dashed() {
        let mut twins = panel();
        let way = [(0.0, 0.0), (1.0, 1.0), (2.0, 1.0)];
        twins.add(Series::line("F_x", way));
        twins.add(Series::line("F_y", way.map(|(x, y)| (x, y + 1e-13))));
        twins.add(Series::line("F_z", way.map(|(x, y)| (x, y + 0.1))));
        let dashed = |panel: &Panel| {
            let plot = Plot::new(panel).unwrap();
            plot.styles.iter().map(|s| *s == Style::Line(Stroke::Dashed)).collect::<Vec<_>>()
        };
        assert_eq!(dashed(&twins), [false, true, false]);
        // Of one colour nothing is gained, and what has no name needs none.
        let mut one = panel();
        one.add(Series::line("", way).coloured(2));
        one.add(Series::line("again", way).coloured(2));
        one.add(Series::line("", way).coloured(3));
        assert_eq!(dashed(&one), [false; 3]);
    }

    #[test]
    fn panels_of_the_same_axes_share_a_legend() {
        let of = |y: &str, labels: &[&str]| {
            let mut panel = Panel::new(Axis::linear("x"), Axis::linear(y));
            for label in labels {
                panel.add(Series::line(*label, [(0.0, 0.0), (1.0, label.len() as f64)]));
            }
            panel
        };
        let panels = [
            of("y", &["a", "bb"]),
            of("y", &["a", "bb"]),
            of("z", &["a", "bb"]),
            of("y", &["a", "bb", "ccc"]),
        ];
        let mut plots: Vec<_> = panels.iter().map(|panel| Plot::new(panel).unwrap()).collect();
        share_legends(&mut plots);
        let labels: Vec<_> =
            plots.iter().map(|plot| plot.legend.labels().collect::<Vec<_>>().join(" ")).collect();
        assert_eq!(labels, ["a bb", "", "a bb", "ccc"]);
    }

    #[test]
    fn a_phase_is_not_joined_across_its_period() {
        let angle = Axis::linear("angle").repeating(360.0);
        let panel = Panel::new(Axis::linear("x"), angle);
        let way = [(0.0, 350.0), (1.0, 10.0), (2.0, 190.0), (3.0, 9.9)];
        let plot = {
            let mut panel = panel.clone();
            panel.add(Series::line("", way));
            panel
        };
        let plot = Plot::new(&plot).unwrap();
        let lengths: Vec<usize> =
            plot.pieces(&plot.panel.series[0]).iter().map(|piece| piece.len()).collect();
        assert_eq!(lengths, [1, 2, 1]);
    }
}
