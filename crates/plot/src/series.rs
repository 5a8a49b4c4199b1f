//! The contents of a panel: lines, markers, arrows and areas.

/// A labelled set of points and the style in which they are drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the legend, empty for none; the text of a note.
    pub label: String,
    /// How the points are drawn.
    pub style: Style,
    /// Index in the palette; by the order in the panel if not set.
    pub colour: Option<usize>,
    /// Size of its markers, relative to the usual one.
    pub size: f64,
    /// The points. Arrows take two each: tail, head.
    pub points: Vec<Point>,
    /// The frames of an animation, if the series moves.
    pub motion: Option<Motion>,
}

/// The positions of the points of a series in an animated picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Duration of one cycle, in seconds.
    pub seconds: f64,
    /// The points at equally spaced times, in each frame as many as the series has.
    pub frames: Vec<Vec<Point>>,
}

impl Series {
    /// A solid line.
    #[must_use]
    pub fn line<P: Into<Point>>(
        label: impl Into<String>,
        points: impl IntoIterator<Item = P>,
    ) -> Self {
        Self::new(label, Style::Line(Stroke::Solid), points)
    }

    /// A dashed line.
    #[must_use]
    pub fn dashed<P: Into<Point>>(
        label: impl Into<String>,
        points: impl IntoIterator<Item = P>,
    ) -> Self {
        Self::new(label, Style::Line(Stroke::Dashed), points)
    }

    /// A dotted line.
    #[must_use]
    pub fn dotted<P: Into<Point>>(
        label: impl Into<String>,
        points: impl IntoIterator<Item = P>,
    ) -> Self {
        Self::new(label, Style::Line(Stroke::Dotted), points)
    }

    /// Markers.
    #[must_use]
    pub fn markers<P: Into<Point>>(
        label: impl Into<String>,
        marker: Marker,
        points: impl IntoIterator<Item = P>,
    ) -> Self {
        Self::new(label, Style::Markers(marker), points)
    }

    /// Arrows, as for a vector field.
    #[must_use]
    pub fn arrows(label: impl Into<String>, arrows: impl IntoIterator<Item = Arrow>) -> Self {
        Self::new(label, Style::Arrows, arrows.into_iter().flat_map(|a| [a.tail, a.head]))
    }

    /// A translucent area inside a closed polygon.
    #[must_use]
    pub fn area<P: Into<Point>>(
        label: impl Into<String>,
        outline: impl IntoIterator<Item = P>,
    ) -> Self {
        Self::new(label, Style::Area, outline)
    }

    /// A text beside a point instead of an entry in the legend.
    #[must_use]
    pub fn note<P: Into<Point>>(words: impl Into<String>, at: P) -> Self {
        Self::new(words, Style::Note, [at])
    }

    fn new<P: Into<Point>>(
        label: impl Into<String>,
        style: Style,
        points: impl IntoIterator<Item = P>,
    ) -> Self {
        Self {
            label: label.into(),
            style,
            colour: None,
            size: 1.0,
            points: points.into_iter().map(Into::into).collect(),
            motion: None,
        }
    }

    /// Animates the series in an SVG: it runs through frames equally spaced in time, repeatedly. In
    /// static pictures the series keeps its points. Lines, areas, arrows and a single dot move
    /// linearly between frames; notes jump, and are hidden outside the axes.
    ///
    /// ```
    /// use carom_plot::{Marker, Panel, Point, Series, render};
    /// let way = (0..=8).map(|i| vec![Point::new(f64::from(i), f64::from(i * i))]);
    /// let mut panel = Panel::new("x", "y");
    /// panel.add(Series::markers("", Marker::Dot, [(0.0, 0.0)]).moving(2.0, way));
    /// assert!(render("", &[panel])?.contains("<animate "));
    /// # Ok::<(), carom_plot::PlotError>(())
    /// ```
    #[must_use]
    pub fn moving(mut self, seconds: f64, frames: impl IntoIterator<Item = Vec<Point>>) -> Self {
        self.motion = Some(Motion { seconds, frames: frames.into_iter().collect() });
        self
    }

    /// All points, including those of every frame.
    pub(crate) fn all_points(&self) -> impl Iterator<Item = &Point> + Clone {
        let frames = self.motion.iter().flat_map(|motion| motion.frames.iter().flatten());
        // Notes are hidden outside the axes.
        let frames = frames.filter(|_| self.style != Style::Note);
        self.points.iter().chain(frames)
    }

    /// Sets the size of the markers relative to the usual one, such as 1.5 for open markers around
    /// others at the same points.
    ///
    /// ```
    /// use carom_plot::{Marker, Panel, Series, render};
    /// let mut panel = Panel::new("x", "y");
    /// panel.add(Series::markers("inner", Marker::Dot, [(0.0, 0.0)]));
    /// panel.add(Series::markers("outer", Marker::Circle, [(0.0, 0.0)]).sized(2.0));
    /// assert!(render("", &[panel])?.contains("r=\"7.2\""));
    /// # Ok::<(), carom_plot::PlotError>(())
    /// ```
    #[must_use]
    pub const fn sized(mut self, size: f64) -> Self {
        self.size = size;
        self
    }

    /// Sets the colour by its index in the palette, for example to match markers with their line.
    #[must_use]
    pub const fn coloured(mut self, index: usize) -> Self {
        self.colour = Some(index);
        self
    }
}

/// A point in the coordinates of a panel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Along the horizontal axis.
    pub x: f64,
    /// Along the vertical axis.
    pub y: f64,
}

impl Point {
    /// The point (x, y).
    #[must_use]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }
}

impl From<(f64, f64)> for Point {
    fn from((x, y): (f64, f64)) -> Self {
        Self { x, y }
    }
}

impl From<[f64; 2]> for Point {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { x, y }
    }
}

impl From<&[f64; 2]> for Point {
    fn from(&[x, y]: &[f64; 2]) -> Self {
        Self { x, y }
    }
}

/// An arrow from `tail` to `head`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arrow {
    /// Where it starts.
    pub tail: Point,
    /// Where it points.
    pub head: Point,
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// Points joined by a line.
    Line(Stroke),
    /// One marker for each point.
    Markers(Marker),
    /// One arrow for each two points.
    Arrows,
    /// The interior of a polygon.
    Area,
    /// The label, written at each point.
    Note,
}

/// Pattern of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stroke {
    /// Full.
    Solid,
    /// Broken.
    Dashed,
    /// Dotted.
    Dotted,
}

/// Shape of a marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// Filled circle.
    Dot,
    /// Open circle.
    Circle,
    /// Open square.
    Square,
    /// Filled triangle.
    Triangle,
    /// Diagonal cross.
    Cross,
    /// Cross and plus.
    Star,
}
