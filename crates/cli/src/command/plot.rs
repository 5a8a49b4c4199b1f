//! Lines of many quantities over one: the pictures of histories.

use crate::error::CliError;
use carom_plot::{Axis, Panel, Series, render};

/// A quantity of a record.
pub(super) type Value<T> = fn(&T) -> f64;

/// Records in order, drawn against one of their quantities.
pub(super) struct Course<'a, T> {
    /// The records.
    pub(super) records: &'a [T],
    /// Label of the horizontal axis.
    pub(super) label: &'static str,
    /// What stands on it.
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
            panel.add(self.line(name, self.at, *value));
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
            panel.add(self.line(name, *along, *value));
        }
        panel
    }

    fn line(&self, name: &str, x: Value<T>, y: Value<T>) -> Series {
        Series::line(name, self.records.iter().map(|record| (x(record), y(record))))
    }
}

/// The panels under a title.
///
/// # Errors
/// If they cannot be drawn.
pub(super) fn drawn(title: &str, panels: &[Panel]) -> Result<String, CliError> {
    Ok(render(title, panels)?)
}
