//! What a height map is: its size, heights, slope, curvature, tilt, missing points.

use crate::level::{Fit, Level};
use crate::spectrum::Spectrum;
use crate::spikes::Spike;
use crate::topography::Topography;
use carom_table::{Column, Value};

/// Numbers that describe a height map, over the points that are measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Measures {
    /// Number of columns and rows.
    pub points: [usize; 2],
    /// Spacing of the points along x and y in m; none if the file does not state it.
    pub spacing: Option<[f64; 2]>,
    /// Number of missing points.
    pub missing: usize,
    /// Row and column of the first missing point, from 1.
    pub first_missing: Option<[usize; 2]>,
    /// The farthest spike.
    pub spike: Option<Spike>,
    /// Number of spikes.
    pub spikes: usize,
    /// Mean height in m.
    pub mean: f64,
    /// Least and greatest height in m.
    pub range: [f64; 2],
    /// Root-mean-square height about the mean in m.
    pub rms_height: f64,
    /// Root-mean-square height about the plane of best fit in m.
    pub rms_height_level: f64,
    /// Third moment of the heights about the plane over the third power of their root mean square.
    pub skewness: f64,
    /// Fourth moment over the fourth power; 3 for a Gaussian surface.
    pub kurtosis: f64,
    /// Rise of the plane of best fit from corner to corner along x and y in m.
    pub rise: [f64; 2],
    /// Root mean square of the gradient, by differences of neighbours.
    pub rms_slope: Option<f64>,
    /// Root mean square of half of the Laplacian in 1/m, by second differences.
    pub rms_curvature: Option<f64>,
    /// Root mean square of the steps over the border, if the map repeated itself, over that of the steps between
    /// neighbours, along x and y.
    pub border_step: [f64; 2],
    /// Hurst's exponent; none if the spectrum is no power of the wave number.
    pub hurst: Option<f64>,
    /// Its standard deviation, by the number of waves in the spectrum and their scatter about the power.
    pub hurst_deviation: Option<f64>,
}

/// Sum of squares and their number.
#[derive(Debug, Clone, Copy, Default)]
struct Squares {
    sum: f64,
    count: f64,
}

impl Squares {
    fn add(&mut self, value: f64) {
        if !value.is_nan() {
            self.sum += value * value;
            self.count += 1.0;
        }
    }

    fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut all = Self::default();
        values.for_each(|value| all.add(value));
        all
    }

    /// Mean square; zero without values.
    fn mean(self) -> f64 {
        if self.count > 0.0 { self.sum / self.count } else { 0.0 }
    }

    fn root(self) -> f64 {
        libm::sqrt(self.mean())
    }
}

impl Measures {
    /// The measures of a map; `spectrum` and `spikes` are those of the same map.
    #[must_use]
    pub fn of(map: &Topography, spectrum: Option<&Spectrum>, spikes: &[Spike]) -> Self {
        let heights = || map.heights().iter().copied().filter(|height| !height.is_nan());
        let range = heights().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], height| {
            [low.min(height), high.max(height)]
        });
        // Over one of the heights, so that rounding leaves no roughness to a map of equal heights.
        let base = heights().next().unwrap_or(0.0);
        let over: Vec<f64> = map.heights().iter().map(|height| height - base).collect();
        let known = over.iter().filter(|height| !height.is_nan());
        let mean = known.clone().sum::<f64>() / known.count() as f64;
        let map = &Topography::of_parts(map.columns(), over, map.spacing());
        let fit = Fit::of(map, Level::Plane);
        let [across, up] = fit.rise(map);
        let level = map.levelled(Level::Plane);
        let rms_height_level = Squares::of(level.heights().iter().copied()).root();
        let moment = |power: i32| {
            let known = level.heights().iter().filter(|height| !height.is_nan());
            let sum: f64 = known.map(|height| (height / rms_height_level).powi(power)).sum();
            sum / (map.heights().len() - map.missing()) as f64
        };
        let [slope, curvature] = [slope(map), curvature(map)];
        Self {
            points: [map.columns(), map.rows()],
            spacing: map.spacing(),
            missing: map.missing(),
            first_missing: map.first_missing(),
            spike: spikes.first().copied(),
            spikes: spikes.len(),
            mean: base + mean,
            range,
            rms_height: Squares::of(map.heights().iter().map(|height| height - mean)).root(),
            rms_height_level,
            skewness: moment(3),
            kurtosis: moment(4),
            rise: [across * (map.columns() - 1) as f64, up * (map.rows() - 1) as f64],
            rms_slope: slope,
            rms_curvature: curvature,
            border_step: border_step(map),
            hurst: spectrum.and_then(|spectrum| spectrum.hurst),
            hurst_deviation: spectrum.and_then(|spectrum| spectrum.hurst_deviation),
        }
    }

    /// Part of the points that is missing.
    #[must_use]
    pub fn missing_share(&self) -> f64 {
        self.missing as f64 / (self.points[0] * self.points[1]) as f64
    }

    /// Lengths of the map along x and y in m.
    #[must_use]
    pub fn size(&self) -> Option<[f64; 2]> {
        let [dx, dy] = self.spacing?;
        Some([dx * self.points[0] as f64, dy * self.points[1] as f64])
    }

    /// Rise of the plane of best fit over the whole map, over the root-mean-square height that is left without it.
    #[must_use]
    pub fn tilt_over_rms(&self) -> f64 {
        (self.rise[0].abs() + self.rise[1].abs()) / self.rms_height_level
    }

    /// The quantities as columns.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::count("columns", "", "number of points along x", |m| {
            Value::Count(m.points[0] as u64)
        }),
        Column::count("rows", "", "number of points along y", |m| Value::Count(m.points[1] as u64)),
        Column::new("size_x", "m", "length along x: points times spacing", |m| {
            number(m.size().map(|s| s[0]))
        }),
        Column::new("size_y", "m", "length along y", |m| number(m.size().map(|s| s[1]))),
        Column::new("spacing_x", "m", "distance of the points along x", |m| {
            number(m.spacing.map(|s| s[0]))
        }),
        Column::new("spacing_y", "m", "distance of the points along y", |m| {
            number(m.spacing.map(|s| s[1]))
        }),
        Column::count("missing", "", "points without a height", |m| Value::Count(m.missing as u64)),
        Column::new("missing_share", "", "part of all points that is missing", |m| {
            m.missing_share().into()
        }),
        Column::count("spikes", "", "points far off all their neighbours", |m| {
            Value::Count(m.spikes as u64)
        }),
        Column::new("mean", "m", "mean height", |m| m.mean.into()),
        Column::new("lowest", "m", "least height", |m| m.range[0].into()),
        Column::new("highest", "m", "greatest height", |m| m.range[1].into()),
        Column::new("rms_height", "m", "root-mean-square height about the mean", |m| {
            m.rms_height.into()
        }),
        Column::new("rms_height_level", "m", "the same about the plane of best fit", |m| {
            m.rms_height_level.into()
        }),
        Column::new("skewness", "", "third moment of the heights, 0 if symmetric", |m| {
            m.skewness.into()
        }),
        Column::new("kurtosis", "", "fourth moment of the heights, 3 if Gaussian", |m| {
            m.kurtosis.into()
        }),
        Column::new("rise_x", "m", "of the plane of best fit over the whole map along x", |m| {
            m.rise[0].into()
        }),
        Column::new("rise_y", "m", "of the plane of best fit along y", |m| m.rise[1].into()),
        Column::new(
            "tilt_over_rms",
            "",
            "rise over the height that is left without the plane",
            |m| m.tilt_over_rms().into(),
        ),
        Column::new("rms_slope", "", "root mean square of the gradient", |m| number(m.rms_slope)),
        Column::new("rms_curvature", "1/m", "root mean square of half of the Laplacian", |m| {
            number(m.rms_curvature)
        }),
        Column::new("border_step_x", "", "step over the border along x over the usual one", |m| {
            m.border_step[0].into()
        }),
        Column::new("border_step_y", "", "step over the border along y", |m| {
            m.border_step[1].into()
        }),
        Column::new("hurst", "", "Hurst's exponent from the slope of the spectrum", |m| {
            number(m.hurst)
        }),
        Column::new("hurst_deviation", "", "its standard deviation", |m| number(m.hurst_deviation)),
    ];
}

fn number(value: Option<f64>) -> Value {
    value.map_or(Value::Undefined, Value::Number)
}

/// Root mean square of the gradient by differences of neighbours.
fn slope(map: &Topography) -> Option<f64> {
    let [dx, dy] = map.spacing()?;
    let x = steps_x(map).map(|step| step / dx);
    let y = steps_y(map).map(|step| step / dy);
    Some(libm::sqrt(Squares::of(x).mean() + Squares::of(y).mean()))
}

fn steps_x(map: &Topography) -> impl Iterator<Item = f64> + '_ {
    map.heights()
        .chunks_exact(map.columns())
        .flat_map(|row| row.windows(2).map(|pair| pair[1] - pair[0]))
}

fn steps_y(map: &Topography) -> impl Iterator<Item = f64> + '_ {
    let upper = map.heights().iter().skip(map.columns());
    map.heights().iter().zip(upper).map(|(lower, upper)| upper - lower)
}

/// Root mean square of half of the Laplacian, at the points that have all four neighbours.
fn curvature(map: &Topography) -> Option<f64> {
    let [dx, dy] = map.spacing()?;
    let h = map.heights();
    let laplacian = |place: usize| -> Option<f64> {
        let [left, right, below, above] = map.neighbours(place);
        let twice = 2.0 * h[place];
        Some(
            (h[left?] + h[right?] - twice) / (dx * dx)
                + (h[below?] + h[above?] - twice) / (dy * dy),
        )
    };
    let all = Squares::of((0..h.len()).filter_map(laplacian).map(|sum| 0.5 * sum));
    (all.count > 0.0).then(|| all.root())
}

fn border_step(map: &Topography) -> [f64; 2] {
    let (columns, rows, h) = (map.columns(), map.rows(), map.heights());
    let over_x = (0..rows).map(|j| h[j * columns] - h[(j + 1) * columns - 1]);
    let over_y = (0..columns).map(|i| h[i] - h[(rows - 1) * columns + i]);
    let ratio = |over: Squares, usual: Squares| match usual.root() {
        0.0 => 0.0,
        usual => over.root() / usual,
    };
    [
        ratio(Squares::of(over_x), Squares::of(steps_x(map))),
        ratio(Squares::of(over_y), Squares::of(steps_y(map))),
    ]
}
