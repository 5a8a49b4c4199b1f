//! The axes of a panel: frame, ticks, names, labels, and positions of points between them.

use crate::error::PlotError;
use crate::panel::{Aspect, Panel};
use crate::series::{Point, Series};
use crate::span::{Span, Tick, with_power};
use crate::svg::{Anchor, Frame, Pixel, Svg};
use crate::text::{Type, text_width};

const WIDTH: f64 = 440.0;
const HEIGHT: f64 = 310.0;
/// Least width and height of a map, whose frame has its shape.
const LEAST: f64 = 150.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 22.0;
/// Space above the axes, for the title.
pub(crate) const TOP: f64 = 34.0;
const BOTTOM: f64 = 56.0;
/// From the foot of the axes to the baseline of the ticks and of the label.
const TICK_DROP: f64 = 19.0;
const LABEL_DROP: f64 = 40.0;
/// The rise of names that are too long to stand side by side, in degrees.
const NAME_RISE: f64 = 45.0;

/// The axes of a panel, fitted to its data.
pub(crate) struct Axes<'a> {
    panel: &'a Panel,
    x: Span,
    y: Span,
    /// Width and height of the frame.
    size: [f64; 2],
}

impl<'a> Axes<'a> {
    pub(crate) fn of(panel: &'a Panel) -> Result<Self, PlotError> {
        let points = || panel.series.iter().flat_map(Series::all_points);
        let (x, y) = match &panel.field {
            Some(field) => {
                let over = |axis, nodes| Span::over(axis, nodes, field.ends(nodes));
                (over(&panel.x, field.x())?, over(&panel.y, field.y())?)
            }
            None => (
                Span::fit(&panel.x, points().map(|point| point.x))?,
                Span::fit(&panel.y, points().map(|point| point.y))?,
            ),
        };
        let size = match (panel.aspect, &panel.field) {
            (Aspect::Equal, Some(_)) => shaped(&x, &y),
            _ => [WIDTH, HEIGHT],
        };
        let (x, y) = match panel.aspect {
            Aspect::Free => (x, y),
            Aspect::Equal => equalised(x, y, size),
        };
        Ok(Self { panel, x, y, size })
    }

    /// The frame of the axes in a picture with this corner.
    pub(crate) const fn frame_at(&self, corner: Pixel) -> Frame {
        let [width, height] = self.size;
        Frame { x: corner.x + LEFT, y: corner.y + TOP, width, height }
    }

    /// The spans of both axes.
    pub(crate) const fn spans(&self) -> [&Span; 2] {
        [&self.x, &self.y]
    }

    /// Width with ticks and labels.
    pub(crate) const fn width(&self) -> f64 {
        LEFT + self.size[0] + RIGHT
    }

    /// Height with title, ticks and labels.
    pub(crate) fn height(&self) -> f64 {
        // Turned names need no line for a label that is empty.
        let is_bare = self.depth_of_names() > 0.0 && self.panel.x.label.is_empty();
        let label = if is_bare { LABEL_DROP - TICK_DROP } else { 0.0 };
        TOP + self.size[1] + BOTTOM + self.depth_of_names() - label
    }

    pub(crate) fn place(&self, point: Point, frame: Frame) -> Pixel {
        Pixel {
            x: frame.x + frame.width * self.x.place(point.x),
            y: frame.y + frame.height * (1.0 - self.y.place(point.y)),
        }
    }

    /// Space for names below the axis that are turned.
    fn depth_of_names(&self) -> f64 {
        let length = |name: &str| text_width(name, Type::TICK.size);
        match self.rise_of_names() {
            0.0 => 0.0,
            rise => {
                let longest = self.x.longest_name().map_or(0.0, length);
                libm::sin(rise.to_radians()) * longest
            }
        }
    }

    /// The angle of the names below the axis: level if there is space, upright if turned ones would
    /// begin left of the picture.
    fn rise_of_names(&self) -> f64 {
        let length = |name: &str| text_width(name, Type::TICK.size);
        let Some(longest) = self.x.longest_name().map(length) else { return 0.0 };
        let (ticks, _) = self.x.ticks();
        if longest < 0.95 * self.size[0] * (self.x.place(2.0) - self.x.place(1.0)) {
            return 0.0;
        }
        let starts = ticks.iter().map(|tick| {
            let reach = libm::cos(NAME_RISE.to_radians()) * length(&tick.label);
            LEFT + self.size[0] * self.x.place(tick.at) - reach
        });
        if starts.fold(f64::INFINITY, f64::min) > 4.0 { NAME_RISE } else { 90.0 }
    }

    /// Ticks of both axes with the powers taken out of their numbers; maps have one for both.
    fn ticks(&self) -> [(Vec<Tick>, i32); 2] {
        match self.panel.aspect {
            Aspect::Free => [self.x.ticks(), self.y.ticks()],
            Aspect::Equal => {
                let power = self.x.power().max(self.y.power());
                [self.x.ticks_with(power), self.y.ticks_with(power)]
            }
        }
    }

    pub(crate) fn draw(&self, svg: &mut Svg, frame: Frame) {
        let [(x_ticks, x_power), (y_ticks, y_power)] = self.ticks();
        let rise = self.rise_of_names();
        for tick in &x_ticks {
            self.draw_x_tick(svg, frame, tick, rise);
        }
        for tick in &y_ticks {
            self.draw_y_tick(svg, frame, tick);
        }
        svg.rect(frame, "fill=\"none\" stroke=\"#444\"");
        let foot = frame.y + frame.height;
        let x_label =
            Pixel { x: frame.x + 0.5 * frame.width, y: foot + LABEL_DROP + self.depth_of_names() };
        svg.text(x_label, Anchor::Middle, &with_power(&self.panel.x.label, x_power), Type::LABEL);
        let y_label = Pixel { x: frame.x - 56.0, y: frame.y + 0.5 * frame.height };
        svg.text(y_label, Anchor::Middle, &with_power(&self.panel.y.label, y_power), Type::UPWARDS);
    }

    fn draw_x_tick(&self, svg: &mut Svg, frame: Frame, tick: &Tick, rise: f64) {
        let x = frame.x + frame.width * self.x.place(tick.at);
        let foot = frame.y + frame.height;
        svg.line(Pixel { x, y: frame.y }, Pixel { x, y: foot }, "stroke=\"#e4e4e4\"");
        svg.line(Pixel { x, y: foot }, Pixel { x, y: foot + 5.0 }, "stroke=\"#444\"");
        if rise == 0.0 {
            let at = Pixel { x, y: foot + TICK_DROP };
            svg.text(at, Anchor::Middle, &tick.label, Type::TICK);
        } else {
            let at = Pixel { x: x + 4.0, y: foot + 15.0 };
            svg.text(at, Anchor::End, &tick.label, Type { rise, ..Type::TICK });
        }
    }

    fn draw_y_tick(&self, svg: &mut Svg, frame: Frame, tick: &Tick) {
        let y = frame.y + frame.height * (1.0 - self.y.place(tick.at));
        let end = frame.x + frame.width;
        svg.line(Pixel { x: frame.x, y }, Pixel { x: end, y }, "stroke=\"#e4e4e4\"");
        svg.line(Pixel { x: frame.x - 5.0, y }, Pixel { x: frame.x, y }, "stroke=\"#444\"");
        svg.text(Pixel { x: frame.x - 9.0, y: y + 4.5 }, Anchor::End, &tick.label, Type::TICK);
    }
}

/// Width and height of the frame that a map fills, as large as the frame of other panels allows.
fn shaped(x: &Span, y: &Span) -> [f64; 2] {
    let scale = (WIDTH / x.length()).min(HEIGHT / y.length());
    [x, y].map(|span| (scale * span.length()).max(LEAST))
}

/// Spans with the same unit length on both axes, each containing at least its former range.
fn equalised(x: Span, y: Span, [width, height]: [f64; 2]) -> (Span, Span) {
    let (along_x, along_y) = (x.length() / width, y.length() / height);
    if along_x > along_y {
        let y = y.stretched(along_x / along_y);
        (x, y)
    } else {
        (x.stretched(along_y / along_x), y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Field;
    use crate::panel::Axis;

    fn panel() -> Panel {
        Panel::new(Axis::linear("x"), Axis::linear("y"))
    }

    #[test]
    fn a_unit_is_as_long_on_both_axes() {
        let mut panel = panel().equal_aspect();
        panel.add(Series::line("", [(0.0, 0.0), (10.0, 1.0)]));
        let axes = Axes::of(&panel).unwrap();
        let frame = axes.frame_at(Pixel { x: 0.0, y: 0.0 });
        let origin = axes.place(Point::new(0.0, 0.0), frame);
        let unit = axes.place(Point::new(1.0, 1.0), frame);
        assert!((unit.x - origin.x - (origin.y - unit.y)).abs() < 1e-9);
    }

    #[test]
    fn a_map_fills_its_frame() {
        let of = |x: Vec<f64>, y: Vec<f64>| {
            let values = vec![0.5; x.len() * y.len()];
            let field = Field::new("p", x, y, values).unwrap();
            let map = panel().equal_aspect().over(field);
            let axes = Axes::of(&map).unwrap();
            let [x, y] = axes.spans().map(Span::length);
            (axes.size, [x, y])
        };
        assert_eq!(of(vec![0.0, 3.0], vec![0.0, 3.0]), ([HEIGHT, HEIGHT], [3.0, 3.0]));
        assert_eq!(of(vec![0.0, 4.4], vec![0.0, 2.2]), ([WIDTH, 0.5 * WIDTH], [4.4, 2.2]));
        // A map that is much longer than wide keeps a readable frame.
        let (size, lengths) = of(vec![0.0, 44.0], vec![0.0, 1.0]);
        assert_eq!((size, lengths[0]), ([WIDTH, LEAST], 44.0));
        assert!((lengths[1] - 15.0).abs() < 1e-12);
    }

    #[test]
    fn long_names_are_turned_and_none_is_cut() {
        let of = |names: &[&str]| Panel::new(Axis::named("pair", names.iter().copied()), "y");
        let height = |panel: &mut Panel| {
            panel.add(Series::line("", [(1.0, 0.0), (2.0, 1.0)]));
            let axes = Axes::of(panel).unwrap();
            (axes.rise_of_names(), axes.height())
        };
        let (level, low) = height(&mut of(&["steel", "glass"]));
        assert_eq!((level, low), (0.0, TOP + HEIGHT + BOTTOM));
        let names = ["a", "b", "c", "d", "e", "cellulose acetate", "g", "h"];
        let (turned, high) = height(&mut of(&names));
        assert_eq!(turned, NAME_RISE);
        let length = text_width("cellulose acetate", Type::TICK.size);
        assert!((high - low - length * 0.5_f64.sqrt()).abs() < 1e-9);
        let mut bare = Panel::new(Axis::named("", names), "y");
        assert!((high - height(&mut bare).1 - (LABEL_DROP - TICK_DROP)).abs() < 1e-9);
        // Turned, the first name would begin left of the picture.
        let first = ["polymethyl methacrylate on itself", "b", "c", "d"];
        assert_eq!(height(&mut of(&first)).0, 90.0);
    }

    #[test]
    fn a_map_has_one_power_of_ten_on_both_axes() {
        let mut map = panel().equal_aspect();
        map.add(Series::line("", [(-0.02, -0.001), (0.02, 0.001)]));
        let axes = Axes::of(&map).unwrap();
        let [(_, along_x), (_, along_y)] = axes.ticks();
        assert_eq!((along_x, along_y), (0, 0));
        let [(_, along_x), (_, along_y)] =
            Axes::of(&Panel { aspect: Aspect::Free, ..map }).unwrap().ticks();
        assert_eq!((along_x, along_y), (0, -3));
    }
}
