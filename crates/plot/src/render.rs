//! Layout: panels side by side, axes with ticks, series, legends.

use crate::draw;
use crate::error::PlotError;
use crate::heat::{BAR_SPACE, Heat};
use crate::legend::Legend;
use crate::movement;
use crate::panel::{Aspect, Axis, Panel};
use crate::raster::png_of;
use crate::series::{Point, Series, Style};
use crate::span::{Span, Tick, power_of_ten};
use crate::svg::{Anchor, Frame, Pixel, Svg};
use crate::text::Type;

const WIDTH: f64 = 440.0;
const HEIGHT: f64 = 310.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 22.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 56.0;
const HEADING: f64 = 30.0;

/// Draws the panels as one SVG document, under `title` if it is not empty.
///
/// # Errors
/// [`PlotError`] if there is nothing to draw, a point is not finite, a value on a logarithmic axis
/// is not positive, or limits are not increasing.
pub fn render(title: &str, panels: &[Panel]) -> Result<String, PlotError> {
    laid_out(Svg::default(), title, panels)
}

/// The same as PNG, two pixels for each unit of the SVG; texts are in DejaVu Sans, which comes with
/// this crate.
///
/// # Errors
/// As [`render`], and [`PlotError::Raster`] if the picture is too large for memory.
pub fn render_png(title: &str, panels: &[Panel]) -> Result<Vec<u8>, PlotError> {
    png_of(&laid_out(Svg::with_outlines()?, title, panels)?)
}

fn laid_out(mut svg: Svg, title: &str, panels: &[Panel]) -> Result<String, PlotError> {
    let plots = panels.iter().map(Plot::new).collect::<Result<Vec<_>, _>>()?;
    let columns = match plots.len() {
        0 => return Err(PlotError::Empty),
        1 => 1,
        2..=4 => 2,
        _ => 3,
    };
    let widths: Vec<f64> =
        (0..columns).map(|column| column_width(&plots, column, columns)).collect();
    let cell_height = TOP + HEIGHT + BOTTOM;
    let heading = if title.is_empty() { 0.0 } else { HEADING };
    for (i, plot) in plots.iter().enumerate() {
        let (row, column) = (i / columns, i % columns);
        let corner =
            Pixel { x: widths[..column].iter().sum(), y: heading + row as f64 * cell_height };
        plot.draw(&mut svg, corner, &clip_name(title, i))?;
    }
    let width: f64 = widths.iter().sum();
    let height = heading + plots.len().div_ceil(columns) as f64 * cell_height;
    let middle = Pixel { x: 0.5 * width, y: 22.0 };
    svg.text(middle, Anchor::Middle, title, Type::TITLE);
    Ok(svg.finish(width, height))
}

/// Width of a column: its axes, and the widest legend beside them.
fn column_width(plots: &[Plot<'_>], column: usize, columns: usize) -> f64 {
    let asides = plots.iter().skip(column).step_by(columns).filter_map(Plot::aside);
    LEFT + WIDTH + RIGHT + asides.fold(0.0, f64::max)
}

/// A name for a clip path that is unique when several plots are on one HTML page.
fn clip_name(title: &str, index: usize) -> String {
    let sum =
        title.bytes().fold(0u32, |sum, byte| sum.wrapping_mul(31).wrapping_add(u32::from(byte)));
    format!("clip-{sum:x}-{index}")
}

/// A panel with its axes fitted to the data.
struct Plot<'a> {
    panel: &'a Panel,
    legend: Legend<'a>,
    heat: Option<Heat<'a>>,
    x: Span,
    y: Span,
}

impl<'a> Plot<'a> {
    fn new(panel: &'a Panel) -> Result<Self, PlotError> {
        check_finite(panel)?;
        let points = || panel.series.iter().flat_map(Series::all_points);
        let (x, y) = match &panel.field {
            Some(field) => (Span::over(&panel.x, field.x())?, Span::over(&panel.y, field.y())?),
            None => (
                Span::fit(&panel.x, points().map(|point| point.x))?,
                Span::fit(&panel.y, points().map(|point| point.y))?,
            ),
        };
        let (x, y) = match panel.aspect {
            Aspect::Free => (x, y),
            Aspect::Equal => equalised(x, y),
        };
        let heat = panel.field.as_ref().map(Heat::new).transpose()?;
        Ok(Self { panel, legend: Legend::of(panel), heat, x, y })
    }

    /// Space needed for a colour bar or legend beside the axes.
    fn aside(&self) -> Option<f64> {
        if self.heat.is_some() {
            return Some(BAR_SPACE);
        }
        let frame = frame_at(Pixel { x: 0.0, y: 0.0 });
        match self.legend.free_corner(frame, &self.inked(frame)) {
            Some(_) => None,
            None => self.legend.width().map(|width| width + 12.0),
        }
    }

    fn draw(&self, svg: &mut Svg, corner: Pixel, clip: &str) -> Result<(), PlotError> {
        let frame = frame_at(corner);
        svg.clip(clip, frame);
        self.draw_axes(svg, frame);
        if let Some(heat) = &self.heat {
            heat.draw(svg, clip, &self.x, &self.y, frame)?;
            heat.draw_bar(svg, frame);
            svg.rect(frame, "fill=\"none\" stroke=\"#444\"");
        }
        for (i, series) in self.panel.series.iter().enumerate() {
            let colour = draw::colour(series, i);
            draw::series(svg, series, colour, clip, frame, |point| self.place(point, frame));
        }
        let title = Pixel { x: frame.x + 0.5 * frame.width, y: frame.y - 10.0 };
        svg.text(title, Anchor::Middle, &self.panel.title, Type::LABEL);
        let free = self.legend.free_corner(frame, &self.inked(frame));
        // The space beside the axes is used by the colour bar.
        let aside = if self.heat.is_some() { None } else { self.legend.beside(frame) };
        if let Some(place) = free.or(aside) {
            self.legend.draw(svg, place);
        }
        Ok(())
    }

    fn place(&self, point: Point, frame: Frame) -> Pixel {
        Pixel {
            x: frame.x + frame.width * self.x.place(point.x),
            y: frame.y + frame.height * (1.0 - self.y.place(point.y)),
        }
    }

    /// Occupied pixels: markers, and points every few pixels along lines.
    fn inked(&self, frame: Frame) -> Vec<Pixel> {
        let mut inked = Vec::new();
        for series in &self.panel.series {
            let pixels: Vec<Pixel> = series.points.iter().map(|p| self.place(*p, frame)).collect();
            if !matches!(series.style, Style::Markers(_) | Style::Note) {
                inked.extend(pixels.windows(2).flat_map(|ends| between(ends[0], ends[1])));
            }
            inked.extend(pixels);
        }
        inked
    }

    fn draw_axes(&self, svg: &mut Svg, frame: Frame) {
        let (x_ticks, x_power) = self.x.ticks();
        let (y_ticks, y_power) = self.y.ticks();
        for tick in &x_ticks {
            self.draw_x_tick(svg, frame, tick);
        }
        for tick in &y_ticks {
            self.draw_y_tick(svg, frame, tick);
        }
        svg.rect(frame, "fill=\"none\" stroke=\"#444\"");
        let x_label = Pixel { x: frame.x + 0.5 * frame.width, y: frame.y + frame.height + 40.0 };
        svg.text(x_label, Anchor::Middle, &axis_label(&self.panel.x, x_power), Type::LABEL);
        let y_label = Pixel { x: frame.x - 56.0, y: frame.y + 0.5 * frame.height };
        svg.text(y_label, Anchor::Middle, &axis_label(&self.panel.y, y_power), Type::UPWARDS);
    }

    fn draw_x_tick(&self, svg: &mut Svg, frame: Frame, tick: &Tick) {
        let x = frame.x + frame.width * self.x.place(tick.at);
        let foot = frame.y + frame.height;
        svg.line(Pixel { x, y: frame.y }, Pixel { x, y: foot }, "stroke=\"#e4e4e4\"");
        svg.line(Pixel { x, y: foot }, Pixel { x, y: foot + 5.0 }, "stroke=\"#444\"");
        svg.text(Pixel { x, y: foot + 19.0 }, Anchor::Middle, &tick.label, Type::TICK);
    }

    fn draw_y_tick(&self, svg: &mut Svg, frame: Frame, tick: &Tick) {
        let y = frame.y + frame.height * (1.0 - self.y.place(tick.at));
        let end = frame.x + frame.width;
        svg.line(Pixel { x: frame.x, y }, Pixel { x: end, y }, "stroke=\"#e4e4e4\"");
        svg.line(Pixel { x: frame.x - 5.0, y }, Pixel { x: frame.x, y }, "stroke=\"#444\"");
        svg.text(Pixel { x: frame.x - 9.0, y: y + 4.5 }, Anchor::End, &tick.label, Type::TICK);
    }
}

fn frame_at(corner: Pixel) -> Frame {
    Frame { x: corner.x + LEFT, y: corner.y + TOP, width: WIDTH, height: HEIGHT }
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

/// Spans with the same unit length on both axes, each containing at least its former range.
fn equalised(x: Span, y: Span) -> (Span, Span) {
    let (along_x, along_y) = (x.length() / WIDTH, y.length() / HEIGHT);
    if along_x > along_y {
        let y = y.stretched(along_x / along_y);
        (x, y)
    } else {
        (x.stretched(along_y / along_x), y)
    }
}

/// Pixels on the line from one to the other.
fn between(from: Pixel, to: Pixel) -> impl Iterator<Item = Pixel> {
    let steps = (libm::hypot(to.x - from.x, to.y - from.y) / 8.0).min(200.0) as usize;
    (1..=steps).map(move |i| {
        let part = i as f64 / (steps + 1) as f64;
        Pixel { x: from.x + part * (to.x - from.x), y: from.y + part * (to.y - from.y) }
    })
}

fn axis_label(axis: &Axis, power: i32) -> String {
    match power {
        0 => axis.label.clone(),
        _ => format!("{}  (× {})", axis.label, power_of_ten(power)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Field;
    use crate::series::{Arrow, Marker};

    fn panel() -> Panel {
        Panel::new(Axis::linear("x < y"), Axis::linear("y"))
    }

    #[test]
    fn every_style_is_drawn() {
        let mut panel = panel().titled("all").equal_aspect();
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
        panel.add(Series::line("R_x", square));
        panel.add(Series::dashed("dashed", square));
        panel.add(Series::area("area", square));
        let arrow = Arrow { tail: Point::new(0.0, 0.0), head: Point::new(1.0, 0.5) };
        panel.add(Series::arrows("arrows", [arrow]));
        let markers = [
            Marker::Dot,
            Marker::Circle,
            Marker::Square,
            Marker::Triangle,
            Marker::Cross,
            Marker::Star,
        ];
        for marker in markers {
            panel.add(Series::markers("marker", marker, square));
        }
        let svg = render("A & B", &[panel]).unwrap();
        assert!(svg.contains("A &amp; B") && svg.contains("x &lt; y"));
        assert!(svg.contains("R<tspan"), "subscript");
        assert_eq!(svg.matches("stroke-dasharray").count(), 2); // curve and legend
        assert_eq!(svg.matches("<g ").count(), svg.matches("</g>").count());
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn a_unit_is_as_long_on_both_axes() {
        let mut panel = panel().equal_aspect();
        panel.add(Series::line("", [(0.0, 0.0), (10.0, 1.0)]));
        let plot = Plot::new(&panel).unwrap();
        let frame = frame_at(Pixel { x: 0.0, y: 0.0 });
        let origin = plot.place(Point::new(0.0, 0.0), frame);
        let unit = plot.place(Point::new(1.0, 1.0), frame);
        assert!((unit.x - origin.x - (origin.y - unit.y)).abs() < 1e-9);
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

    #[test]
    fn a_field_is_drawn_with_its_bar_and_contours() {
        let linspace = carom_special::linspace;
        let nodes = linspace(0.0, 1.0, 5);
        let values = nodes.iter().flat_map(|y| nodes.iter().map(move |x| x - y)).collect();
        let field = Field::new("x - y", nodes.clone(), nodes.clone(), values).unwrap();
        let svg = render("", &[panel().over(field)]).unwrap();
        let large = linspace(0.0, 4e6, 25);
        let label = |values| {
            let field = Field::new("p / Pa", nodes.clone(), nodes.clone(), values).unwrap();
            render("", &[panel().over(field)]).unwrap().contains("× 10⁶")
        };
        assert!(label(large) && !label(linspace(0.0, 4.0, 25)), "the bar tells its unit");
        // The diagonal, where the value is zero, is the bold line.
        let bold = svg.lines().find(|line| line.contains("stroke-width=\"1.6\"")).unwrap();
        assert!(bold.contains('M') && !svg.contains("NaN"));
        assert!(svg.contains("#08519c") && svg.contains("#a63603"));
        let bare = render("", &[titled()]).unwrap();
        let width = |svg: &str| {
            let text = svg.split("width=\"").nth(1).unwrap().split('"').next().unwrap();
            text.parse::<f64>().unwrap()
        };
        assert_eq!(width(&svg) - width(&bare), BAR_SPACE);
    }

    #[test]
    fn a_sketch_has_names_and_no_numbers() {
        let mut sketch = Panel::new(Axis::bare("aside"), Axis::bare(""));
        sketch.add(Series::line("", [(0.0, 0.0), (1.0, 1.0)]));
        sketch.add(Series::note("e_x", (0.5, 0.5)));
        let svg = render("", &[sketch]).unwrap();
        assert!(svg.contains("e<tspan") && svg.contains(">aside<"));
        assert_eq!(svg.matches("<text").count(), 2, "no tick, no legend");
    }

    fn titled() -> Panel {
        let mut panel = panel();
        panel.add(Series::line("", [(0.0, 0.0), (1.0, 1.0)]));
        panel
    }

    #[test]
    fn bad_points_are_named() {
        let mut panel = panel();
        panel.add(Series::line("bad", [(0.0, 0.0), (1.0, f64::NAN)]));
        let error = render("", &[panel]).unwrap_err();
        assert_eq!(error.to_string(), "series `bad`: point 1 is (1, NaN), not finite");
        assert_eq!(render("", &[]), Err(PlotError::Empty));
    }
}
