//! Line plots of several quantities over one, for histories.

use carom_plot::{Axis, Marker, Panel, Point, Series, Style};

/// A quantity of a record.
pub(super) type Value<T> = fn(&T) -> f64;

/// Largest number of marked points; more would hide the lines.
pub(super) const MOST_MARKS: usize = 100;

/// Records in order, plotted over one of their quantities.
pub(super) struct Course<'a, T> {
    /// The records, close enough together for smooth lines.
    pub(super) records: &'a [T],
    /// The records given by the user, which are marked.
    pub(super) marked: &'a [T],
    /// Label of the horizontal axis.
    pub(super) label: &'a str,
    /// The quantity on the horizontal axis.
    pub(super) at: Value<T>,
}

impl<T> Course<'_, T> {
    /// A panel with a line for each named quantity.
    pub(super) fn panel(
        &self,
        title: &str,
        label: &str,
        quantities: &[(&'static str, Value<T>)],
    ) -> Panel {
        let paths: Vec<_> =
            quantities.iter().map(|(name, value)| (*name, self.at, *value)).collect();
        self.paths(title, [self.label, label], &paths)
    }

    /// A panel with paths of one quantity over another. Paths that are zero beside the others are left
    /// out and named in the title, and paths that stay at one place; one that lies on an earlier one is
    /// dashed, so that both are seen.
    pub(super) fn paths(
        &self,
        title: &str,
        [x, y]: [&str; 2],
        paths: &[(&'static str, Value<T>, Value<T>)],
    ) -> Panel {
        let greatest = |value: Value<T>| {
            let all = self.records.iter().chain(self.marked);
            all.map(|record| value(record).abs()).fold(0.0, f64::max)
        };
        let most = paths.iter().map(|(.., value)| greatest(*value)).fold(0.0, f64::max);
        let is_there =
            |path: &&(&str, Value<T>, Value<T>)| most == 0.0 || greatest(path.2) > VANISHES * most;
        let absent = paths.iter().filter(|path| !is_there(path)).map(|(name, ..)| *name);
        let mut panel = Panel::new(Axis::linear(x), Axis::linear(y)).titled(without(title, absent));
        let widest = |of: &dyn Fn(usize) -> Value<T>| {
            (0..paths.len()).map(|i| self.spread(of(i))).fold(0.0, f64::max)
        };
        let (wide, high) = (widest(&|i| paths[i].1), widest(&|i| paths[i].2));
        let is_point =
            |along, value| self.spread(along) < POINT * wide && self.spread(value) < POINT * high;
        for (name, along, value) in paths.iter().filter(is_there) {
            if !is_point(*along, *value) {
                self.draw(&mut panel, name, *along, *value);
            }
        }
        panel
    }

    /// The difference of the greatest and the smallest value.
    fn spread(&self, value: Value<T>) -> f64 {
        let values = || self.records.iter().chain(self.marked).map(value);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    }

    fn draw(&self, panel: &mut Panel, name: &str, x: Value<T>, y: Value<T>) {
        let points = |records: &[T]| -> Vec<(f64, f64)> {
            records.iter().map(|record| (x(record), y(record))).collect()
        };
        let marks = if self.marked.len() <= MOST_MARKS { points(self.marked) } else { Vec::new() };
        add_curve(panel, name, points(self.records), marks);
    }
}

/// The title of a panel without these quantities, which are zero.
pub(super) fn without<'a>(title: &str, absent: impl Iterator<Item = &'a str>) -> String {
    let quantity = |name: &'a str| name.split(" against ").next().unwrap_or(name);
    let zeros: String = absent.map(|name| format!(", {} = 0", quantity(name))).collect();
    format!("{title}{zeros}").trim_start_matches(", ").to_owned()
}

/// A quantity below this part of the greatest one beside it is zero but for what the solution is solved to.
pub(super) const VANISHES: f64 = 1e-6;
/// A path within this part of the others, both along and across, is a point.
const POINT: f64 = 0.01;
/// Lines closer than this part of their greatest value lie on each other.
const ALIKE: f64 = 1e-3;

/// Whether two lines cannot be told apart.
fn are_alike(one: &[Point], other: &[(f64, f64)]) -> bool {
    let size = one.iter().map(|point| point.y.abs()).fold(0.0, f64::max);
    one.len() == other.len()
        && one.iter().zip(other).all(|(a, b)| a.x == b.0 && (a.y - b.1).abs() <= ALIKE * size)
}

/// Adds a curve with marks, in the next colour; dashed if it lies on an earlier one.
pub(super) fn add_curve(
    panel: &mut Panel,
    name: &str,
    line: Vec<(f64, f64)>,
    marks: Vec<(f64, f64)>,
) {
    let mut lines = panel.series.iter().filter(|series| matches!(series.style, Style::Line(_)));
    let colour = lines.clone().count();
    let is_hidden = lines.any(|series| are_alike(&series.points, &line));
    let series = if is_hidden { Series::dashed(name, line) } else { Series::line(name, line) };
    panel.add(series.coloured(colour));
    if !marks.is_empty() {
        panel.add(Series::markers("", Marker::Dot, marks).coloured(colour));
    }
}
