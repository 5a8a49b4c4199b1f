//! A panel: axes and what is drawn between them.

use crate::field::Field;
use crate::series::Series;

/// One pair of axes with its series.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Shown above the axes; empty for none.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Whether one unit has the same length on both axes.
    pub aspect: Aspect,
    /// A field below the series, with a colour bar beside the axes.
    pub field: Option<Field>,
    /// The series, later ones on top.
    pub series: Vec<Series>,
}

impl Panel {
    /// Empty axes; a text is the label of a linear axis.
    #[must_use]
    pub fn new(x: impl Into<Axis>, y: impl Into<Axis>) -> Self {
        Self {
            title: String::new(),
            x: x.into(),
            y: y.into(),
            aspect: Aspect::Free,
            field: None,
            series: Vec::new(),
        }
    }

    /// Sets the title.
    #[must_use]
    pub fn titled(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// Sets the same unit length on both axes, as for a map or sketch.
    #[must_use]
    pub const fn equal_aspect(mut self) -> Self {
        self.aspect = Aspect::Equal;
        self
    }

    /// Adds a field below the series.
    #[must_use]
    pub fn over(mut self, field: Field) -> Self {
        self.field = Some(field);
        self
    }

    /// Adds a series.
    pub fn add(&mut self, series: Series) {
        self.series.push(series);
    }
}

/// Ratio of the unit lengths of the two axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Aspect {
    /// As given by the shape of the panel.
    #[default]
    Free,
    /// One to one.
    Equal,
}

/// An axis: label, scale and, if set, its limits.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Quantity and unit.
    pub label: String,
    /// Linear or logarithmic.
    pub scale: Scale,
    /// Limits; taken from the data if not set.
    pub limits: Option<Limits>,
    /// Names below the values 1, 2, 3, ... instead of numbers; empty for numbers.
    pub names: Vec<String>,
    /// Length after which the values repeat, such as 360 degrees; `None` if they do not.
    pub period: Option<f64>,
}

impl Axis {
    /// A linear axis.
    #[must_use]
    pub fn linear(label: impl Into<String>) -> Self {
        Self::new(label, Scale::Linear)
    }

    /// A logarithmic axis.
    #[must_use]
    pub fn log(label: impl Into<String>) -> Self {
        Self::new(label, Scale::Log)
    }

    /// An axis of things without order, such as materials: the first stands at 1, the next at 2.
    /// Their names are below it, turned if they are long.
    ///
    /// ```
    /// use carom_plot::{Axis, Marker, Panel, Series, render};
    /// let mut panel = Panel::new(Axis::named("", ["steel", "glass"]), "E / GPa");
    /// panel.add(Series::markers("", Marker::Dot, [(1.0, 208.0), (2.0, 70.0)]));
    /// assert!(render("", &[panel])?.contains(">glass<"));
    /// # Ok::<(), carom_plot::PlotError>(())
    /// ```
    #[must_use]
    pub fn named<S: Into<String>>(
        label: impl Into<String>,
        names: impl IntoIterator<Item = S>,
    ) -> Self {
        let names: Vec<String> = names.into_iter().map(Into::into).collect();
        let limits = Some(Limits { low: 0.5, high: names.len() as f64 + 0.5 });
        Self { names, limits, ..Self::new(label, Scale::Linear) }
    }

    /// An axis without numbers, for a sketch.
    #[must_use]
    pub fn bare(label: impl Into<String>) -> Self {
        Self::new(label, Scale::Bare)
    }

    fn new(label: impl Into<String>, scale: Scale) -> Self {
        Self { label: label.into(), scale, limits: None, names: Vec::new(), period: None }
    }

    /// Sets the length after which values repeat. Lines are not drawn across a jump of more than
    /// half of it.
    ///
    /// ```
    /// use carom_plot::{Axis, Panel, Series, render};
    /// let mut panel = Panel::new("t", Axis::linear("angle / degrees").repeating(360.0));
    /// panel.add(Series::line("", [(0.0, 170.0), (1.0, 179.0), (2.0, -172.0), (3.0, -160.0)]));
    /// assert_eq!(render("", &[panel])?.matches("<polyline").count(), 2);
    /// # Ok::<(), carom_plot::PlotError>(())
    /// ```
    #[must_use]
    pub const fn repeating(mut self, period: f64) -> Self {
        self.period = Some(period);
        self
    }

    /// Sets fixed limits.
    #[must_use]
    pub const fn between(mut self, low: f64, high: f64) -> Self {
        self.limits = Some(Limits { low, high });
        self
    }
}

impl<L: Into<String>> From<L> for Axis {
    fn from(label: L) -> Self {
        Self::linear(label)
    }
}

/// Scale of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps.
    Linear,
    /// Equal ratios.
    Log,
    /// Equal steps without ticks.
    Bare,
}

/// Ends of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
}
