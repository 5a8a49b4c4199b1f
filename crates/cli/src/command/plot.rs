//! Line plots of several quantities over one, for histories.

use carom_plot::{Axis, Marker, Panel, Series, Style};

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
        let mut panel = Panel::new(Axis::linear(self.label), Axis::linear(label)).titled(title);
        for (name, value) in quantities {
            self.draw(&mut panel, name, self.at, *value);
        }
        panel
    }

    /// A panel with paths of one quantity over another.
    pub(super) fn paths(
        &self,
        title: &str,
        [x, y]: [&str; 2],
        paths: &[(&'static str, Value<T>, Value<T>)],
    ) -> Panel {
        let mut panel = Panel::new(Axis::linear(x), Axis::linear(y)).titled(title);
        for (name, along, value) in paths {
            self.draw(&mut panel, name, *along, *value);
        }
        panel
    }

    fn draw(&self, panel: &mut Panel, name: &str, x: Value<T>, y: Value<T>) {
        let points = |records: &[T]| -> Vec<(f64, f64)> {
            records.iter().map(|record| (x(record), y(record))).collect()
        };
        let marks = if self.marked.len() <= MOST_MARKS { points(self.marked) } else { Vec::new() };
        add_curve(panel, name, points(self.records), marks);
    }
}

/// Adds a curve with marks, in the next colour.
pub(super) fn add_curve(
    panel: &mut Panel,
    name: &str,
    line: Vec<(f64, f64)>,
    marks: Vec<(f64, f64)>,
) {
    let colour =
        panel.series.iter().filter(|series| matches!(series.style, Style::Line(_))).count();
    panel.add(Series::line(name, line).coloured(colour));
    if !marks.is_empty() {
        panel.add(Series::markers("", Marker::Dot, marks).coloured(colour));
    }
}
