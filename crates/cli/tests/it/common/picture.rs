//! Reads a picture: panels with their axes, and the curves in the units of the ticks.

use std::collections::BTreeMap;

/// An axis: its label, and two of its ticks as pixel and value.
#[derive(Debug, Default)]
pub(crate) struct Scale {
    pub(crate) label: String,
    ticks: Vec<[f64; 2]>,
}

impl Scale {
    /// The pixel of a value.
    pub(crate) fn pixel(&self, value: f64) -> f64 {
        let ([p, a], [q, b]) = (self.ticks[0], self.ticks[self.ticks.len() - 1]);
        p + (q - p) * (value - a) / (b - a)
    }
}

impl Scale {
    /// The value at a pixel.
    pub(crate) fn value(&self, pixel: f64) -> f64 {
        let ([p, a], [q, b]) = (self.ticks[0], self.ticks[self.ticks.len() - 1]);
        a + (b - a) * (pixel - p) / (q - p)
    }
}

/// What is drawn in one panel. Curves and marks are known by their colour.
#[derive(Debug, Default)]
pub(crate) struct Panel {
    pub(crate) title: String,
    pub(crate) x: Scale,
    pub(crate) y: Scale,
    pub(crate) lines: Vec<(String, Vec<[f64; 2]>)>,
    pub(crate) areas: Vec<(String, Vec<[f64; 2]>)>,
    pub(crate) marks: Vec<(String, [f64; 2])>,
    /// Tails of arrows.
    pub(crate) arrows: Vec<[f64; 2]>,
    /// Colours by the words of the legend.
    pub(crate) legend: BTreeMap<String, String>,
}

fn attribute<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    line.split_once(&format!(" {name}=\""))?.1.split('"').next()
}

fn number(line: &str, name: &str) -> f64 {
    attribute(line, name).and_then(|text| text.parse().ok()).unwrap_or(f64::NAN)
}

/// The words of a text; what is lowered stands after `_`.
fn words(line: &str) -> String {
    let (mut words, mut inside) = (String::new(), false);
    for letter in line.replace("<tspan dy=\"0.28em\"", "_<tspan").chars() {
        match letter {
            '<' => inside = true,
            '>' => inside = false,
            _ if !inside => words.push(letter),
            _ => {}
        }
    }
    words.replace("&#8203;", "").trim().to_owned()
}

fn points(line: &str) -> Vec<[f64; 2]> {
    let pair = |pair: &str| {
        let (x, y) = pair.split_once(',').unwrap();
        [x.parse().unwrap(), y.parse().unwrap()]
    };
    attribute(line, "points").unwrap().split_whitespace().map(pair).collect()
}

/// The number of a tick; ten raised to a power is written with raised digits.
fn tick(text: &str) -> f64 {
    let text = text.replace('−', "-");
    match text.split_once("10⁻").map(|(_, n)| (-1, n)).or_else(|| {
        let raised = text.strip_prefix("10").filter(|rest| rest.starts_with(is_raised))?;
        Some((1, raised))
    }) {
        Some((sign, raised)) => 10.0_f64.powi(sign * raised_number(raised)),
        None => text.parse().unwrap(),
    }
}

fn is_raised(letter: char) -> bool {
    RAISED.contains(&letter)
}

const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

fn raised_number(text: &str) -> i32 {
    let digit = |letter| RAISED.iter().position(|raised| *raised == letter).unwrap() as i32;
    text.chars().fold(0, |sum, letter| 10 * sum + digit(letter))
}

/// All panels of a picture, in order.
pub(crate) fn panels(svg: &str) -> Vec<Panel> {
    svg.split("<clipPath ").skip(1).map(panel).collect()
}

fn panel(text: &str) -> Panel {
    let frame = text.lines().next().unwrap();
    let frame = ["x", "y", "width", "height"].map(|name| number(frame, name));
    let mut panel = Panel::default();
    let (mut grouped, mut sample) = (false, None);
    for line in text.lines().skip(1) {
        let stroke = || attribute(line, "stroke").unwrap_or_default().to_owned();
        let fill = || attribute(line, "fill").unwrap_or_default().to_owned();
        if line.starts_with("<g ") {
            grouped = true;
        } else if line.starts_with("</g>") {
            grouped = false;
        } else if line.starts_with("<text ") {
            let (x, y) = (number(line, "x"), number(line, "y"));
            let words = words(line);
            let is_beside = x > frame[0] + frame[2] + 1.0;
            if is_beside && sample.is_none() {
                // The ticks of a bar of colours.
            } else if (y - frame[1] - frame[3] - 19.0).abs() < 0.1 {
                panel.x.ticks.push([x, tick(&words)]);
            } else if (x - frame[0] + 9.0).abs() < 0.1 {
                panel.y.ticks.push([y - 4.5, tick(&words)]);
            } else if (y - frame[1] - frame[3] - 40.0).abs() < 0.1 {
                panel.x.label = words;
            } else if line.contains("rotate(-90") {
                panel.y.label = words;
            } else if (y - frame[1] + 10.0).abs() < 0.1 {
                panel.title = words;
            } else if let Some(colour) = sample.take() {
                panel.legend.insert(words, colour);
            }
        } else if line.starts_with("<polyline ") {
            match grouped {
                true => panel.lines.push((stroke(), points(line))),
                false => sample = Some(stroke()),
            }
        } else if line.starts_with("<polygon ") {
            panel.areas.push((fill(), points(line)));
        } else if line.starts_with("<path ") && !line.contains(" transform=") {
            // An arrow, or one shape at many places.
            let data = line.split_once(" d=\"M").map_or("", |(_, data)| data);
            for place in data.split('M') {
                let end = place.find(|c: char| !(c.is_ascii_digit() || ".,".contains(c)));
                let number = |text: &str| text.parse::<f64>().unwrap();
                if let Some((x, y)) = place[..end.unwrap_or(0)].split_once(',') {
                    let at = [number(x), number(y)];
                    match grouped {
                        true => panel.arrows.push(at),
                        false => panel.marks.push((stroke(), at)),
                    }
                }
            }
        } else if line.starts_with("<circle ") {
            let at = [number(line, "cx"), number(line, "cy")];
            panel.marks.push((fill(), at));
            sample = sample.or_else(|| Some(fill()));
        }
    }
    for axis in [&mut panel.x, &mut panel.y] {
        if let Some((label, unit)) = without_prefix(&axis.label) {
            axis.ticks.iter_mut().for_each(|tick| tick[1] *= unit);
            axis.label = label;
        }
        // "force / N  (× 10⁶)": ticks are in thousands or millions.
        if let Some((label, power)) = axis.label.clone().split_once("  (× ") {
            let unit = tick(power.trim_end_matches(')'));
            axis.ticks.iter_mut().for_each(|tick| tick[1] *= unit);
            axis.label = label.to_owned();
        }
    }
    panel
}

/// "force / kN" as "force / N" and a thousand.
fn without_prefix(label: &str) -> Option<(String, f64)> {
    let (name, unit) = label.rsplit_once(" / ")?;
    let bare = ["m²", "m/s", "N/m", "N m", "rad", "Pa", "N", "J", "W", "s", "m"];
    let bare = bare.into_iter().find(|bare| unit.len() > bare.len() && unit.ends_with(bare))?;
    let power = match unit.strip_suffix(bare)? {
        "p" => -12,
        "n" => -9,
        "µ" => -6,
        "m" => -3,
        "k" => 3,
        "M" => 6,
        "G" => 9,
        "T" => 12,
        _ => return None,
    };
    let power = if bare == "m²" { 2 * power } else { power };
    Some((format!("{name} / {bare}"), 10.0_f64.powi(power)))
}

impl Panel {
    /// The lines with a name in the legend; without a legend, those of the first colour.
    pub(crate) fn curves(&self, name: &str) -> Vec<&[[f64; 2]]> {
        let colour = match name {
            "" => &self.lines[0].0,
            _ => self.legend.get(name).unwrap_or_else(|| panic!("{name} of {:?}", self.legend)),
        };
        let of = self.lines.iter().filter(|(own, _)| own == colour);
        of.map(|(_, points)| points.as_slice()).collect()
    }

    /// How far, in pixels, a point in the units of the axes lies from the curves of a name.
    pub(crate) fn distance(&self, name: &str, [x, y]: [f64; 2]) -> f64 {
        let at = [self.x.pixel(x), self.y.pixel(y)];
        let curves = self.curves(name);
        let sides = curves.iter().flat_map(|points| points.windows(2));
        sides.map(|ends| from_side(at, ends[0], ends[1])).fold(f64::INFINITY, f64::min)
    }
}

/// From a point to the straight line between two others.
fn from_side([x, y]: [f64; 2], [x_0, y_0]: [f64; 2], [x_1, y_1]: [f64; 2]) -> f64 {
    let (u, v) = (x_1 - x_0, y_1 - y_0);
    let square = u * u + v * v;
    let part = if square > 0.0 { ((x - x_0) * u + (y - y_0) * v) / square } else { 0.0 };
    let part = part.clamp(0.0, 1.0);
    (x - x_0 - part * u).hypot(y - y_0 - part * v)
}
