//! The picture of a height map.

use crate::error::CliError;
use crate::output::Picture;
use carom_plot::{Axis, Field, Marker, Panel, Series};
use carom_surface::{Spectrum, Spike, Topography};

/// Largest number of cells of the drawn map along an axis.
const MOST: usize = 200;
/// Largest number of spikes that are marked.
const MOST_SPIKES: usize = 50;
/// Number of bars of the distribution.
const BARS: usize = 60;
/// Part of the heights at each end that the colours and the distribution leave out if there are spikes.
const TAIL: f64 = 0.001;

/// The heights, what is wrong with them, their distribution and their spectrum.
pub(super) fn draw(
    map: &Topography,
    spectrum: Option<&Spectrum>,
    spikes: &[Spike],
) -> Result<Picture, CliError> {
    let cells = Cells::of(map);
    let mut panels = vec![cells.heights(spikes)?];
    if map.missing() > 0 || !spikes.is_empty() {
        panels.push(cells.faults(spikes)?);
    }
    panels.push(distribution(map, cells.shown));
    panels.extend(spectrum.filter(|spectrum| spectrum.density.len() > 1).map(power));
    Ok(Picture::new("Height map", panels))
}

/// The map in blocks small enough to be drawn.
struct Cells<'a> {
    map: &'a Topography,
    stride: usize,
    size: [usize; 2],
    spacing: [f64; 2],
    /// Least and greatest height that the colours show.
    shown: [f64; 2],
}

impl<'a> Cells<'a> {
    fn of(map: &'a Topography) -> Self {
        let stride = map.columns().max(map.rows()).div_ceil(MOST);
        let size = [map.columns().div_ceil(stride), map.rows().div_ceil(stride)];
        let spacing = map.spacing().unwrap_or([1.0; 2]);
        Self { map, stride, size, spacing, shown: shown(map) }
    }

    fn labels(&self) -> [&'static str; 2] {
        match self.map.spacing() {
            Some(_) => ["x / m", "y / m"],
            None => ["column", "row"],
        }
    }

    fn panel(&self, title: &str) -> Panel {
        let [x, y] = self.labels();
        Panel::new(Axis::linear(x), Axis::linear(y)).titled(title).equal_aspect()
    }

    /// The middles of the blocks along an axis.
    fn middles(&self, axis: usize) -> Vec<f64> {
        let count = [self.map.columns(), self.map.rows()][axis];
        let middle = |block: usize| {
            let (from, to) = (block * self.stride, ((block + 1) * self.stride).min(count));
            self.spacing[axis] * 0.5 * (from + to) as f64
        };
        (0..self.size[axis]).map(middle).collect()
    }

    /// A value of each block, from its heights.
    fn blocks<T>(&self, value: impl Fn(Vec<f64>) -> T) -> Vec<T> {
        let (columns, rows) = (self.map.columns(), self.map.rows());
        let block = |at: usize| {
            let (i, j) = (at % self.size[0] * self.stride, at / self.size[0] * self.stride);
            let lines = j..(j + self.stride).min(rows);
            let points = lines.flat_map(|row| {
                (i..(i + self.stride).min(columns)).map(move |column| row * columns + column)
            });
            value(points.map(|place| self.map.heights()[place]).collect())
        };
        (0..self.size[0] * self.size[1]).map(block).collect()
    }

    fn is_drawn(&self) -> bool {
        self.size.iter().all(|count| *count > 1)
    }

    fn heights(&self, spikes: &[Spike]) -> Result<Panel, CliError> {
        if !self.is_drawn() {
            return Ok(self.profile());
        }
        let [low, high] = self.shown;
        let middle = 0.5 * (low + high);
        let mean = |heights: Vec<f64>| {
            let (sum, count) = heights
                .into_iter()
                .filter(|height| !height.is_nan())
                .fold((0.0, 0.0), |(sum, count), height| {
                    (sum + height.clamp(low, high), count + 1.0)
                });
            if count > 0.0 { sum / count - middle } else { 0.0 }
        };
        let values = self.blocks(mean);
        let field = Field::new("h / m", self.middles(0), self.middles(1), values)?;
        let mut panel = self.panel("heights, about their middle").over(field);
        mark(&mut panel, self.places(spikes));
        Ok(panel)
    }

    /// The heights of a single row or column.
    fn profile(&self) -> Panel {
        let axis = usize::from(self.size[0] == 1);
        let points = self.map.heights().iter().enumerate().filter(|(_, height)| !height.is_nan());
        let points = points.map(|(at, height)| (self.spacing[axis] * (at as f64 + 0.5), *height));
        let mut panel = Panel::new(Axis::linear(self.labels()[axis]), Axis::linear("h / m"));
        panel.add(Series::line("", points.collect::<Vec<_>>()));
        panel.titled("heights")
    }

    fn places(&self, spikes: &[Spike]) -> Vec<(f64, f64)> {
        let at = |place: usize, axis: usize| self.spacing[axis] * (place as f64 - 0.5);
        spikes
            .iter()
            .take(MOST_SPIKES)
            .map(|spike| (at(spike.column, 0), at(spike.row, 1)))
            .collect()
    }

    fn faults(&self, spikes: &[Spike]) -> Result<Panel, CliError> {
        let kinds =
            self.blocks(|heights| heights.iter().any(|height| height.is_nan()).then_some(0));
        if !self.is_drawn() || kinds.iter().all(Option::is_none) {
            let mut panel = self.panel("points far off all their neighbours");
            let [x, y] =
                self.map.size().unwrap_or([self.map.columns() as f64, self.map.rows() as f64]);
            panel.add(Series::line("", [(0.0, 0.0), (x, 0.0), (x, y), (0.0, y), (0.0, 0.0)]));
            mark(&mut panel, self.places(spikes));
            return Ok(panel);
        }
        let field = Field::of_kinds(["missing"], self.middles(0), self.middles(1), kinds)?;
        let mut panel = self.panel("points without a height").over(field);
        mark(&mut panel, self.places(spikes));
        Ok(panel)
    }
}

fn mark(panel: &mut Panel, places: Vec<(f64, f64)>) {
    if !places.is_empty() {
        panel.add(Series::markers("far off", Marker::Square, places).coloured(3));
    }
}

/// The range of heights without the outermost ones.
fn shown(map: &Topography) -> [f64; 2] {
    let mut known: Vec<f64> =
        map.heights().iter().copied().filter(|height| !height.is_nan()).collect();
    known.sort_unstable_by(f64::total_cmp);
    let cut = libm::ceil(TAIL * known.len() as f64) as usize;
    let cut = cut.min((known.len() - 1) / 2);
    [known[cut], known[known.len() - 1 - cut]]
}

/// The distribution of the heights.
fn distribution(map: &Topography, [low, high]: [f64; 2]) -> Panel {
    let width = ((high - low) / BARS as f64).max(f64::MIN_POSITIVE);
    let mut counts = [0.0; BARS];
    let known = map.heights().iter().filter(|height| **height >= low && **height <= high);
    for height in known {
        let bar = libm::floor((height - low) / width) as usize;
        counts[bar.min(BARS - 1)] += 1.0;
    }
    let all: f64 = counts.iter().sum();
    let steps = counts.iter().enumerate().flat_map(|(bar, count)| {
        let density = count / all;
        [(low + bar as f64 * width, density), (low + (bar + 1) as f64 * width, density)]
    });
    let mut panel = Panel::new(Axis::linear("h / m"), Axis::linear("part of the points"));
    panel.add(Series::line("", steps.collect::<Vec<_>>()));
    panel.titled("distribution of the heights")
}

/// The spectrum, and the line of Hurst's exponent.
fn power(spectrum: &Spectrum) -> Panel {
    let mut panel = Panel::new(Axis::log("wave number / (1/m)"), Axis::log("power density / m⁴"));
    let points = spectrum.density.iter().filter(|[_, density]| *density > 0.0);
    panel.add(Series::line("", points.map(|[q, density]| (*q, *density)).collect::<Vec<_>>()));
    let title = match spectrum.hurst {
        Some(hurst) => format!("spectrum, Hurst's exponent {hurst:.2}"),
        None => "spectrum".to_owned(),
    };
    panel.titled(title)
}
