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
}

impl Axis {
    /// A linear axis.
    #[must_use]
    pub fn linear(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Linear, limits: None }
    }

    /// A logarithmic axis.
    #[must_use]
    pub fn log(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Log, limits: None }
    }

    /// An axis without numbers, for a sketch.
    #[must_use]
    pub fn bare(label: impl Into<String>) -> Self {
        Self { label: label.into(), scale: Scale::Bare, limits: None }
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
