//! A height map: heights on a regular grid, with the points that are missing.

use crate::error::SurfaceError;

/// Heights of a surface on a regular grid in metres, row by row, x and y ascending; NaN where a point is missing.
///
/// Each point stands for a cell of the grid: a map of n points with the spacing d is n d long.
///
/// ```
/// use carom_surface::{Crop, Topography};
/// let map = Topography::new(3, vec![1.0, 2.0, 3.0, 4.0, f64::NAN, 6.0])?.spaced(Some([1e-6, 2e-6]));
/// assert_eq!((map.columns(), map.rows(), map.missing()), (3, 2, 1));
/// assert_eq!(map.size(), Some([3e-6, 4e-6]));
/// assert_eq!(map.cropped(Crop([1, 0, 3, 1]))?.heights(), [2.0, 3.0]);
/// # Ok::<(), carom_surface::SurfaceError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Topography {
    columns: usize,
    heights: Vec<f64>,
    spacing: Option<[f64; 2]>,
}

/// A part of a map in points: left, lower, right, upper, counted from 0; right and upper are the first beyond it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Crop(pub [usize; 4]);

impl Topography {
    /// A map of rows with `columns` heights each; its spacing is unknown.
    ///
    /// # Errors
    /// [`SurfaceError::NotFinite`] for an infinite height, [`SurfaceError::Empty`] without a height,
    /// [`SurfaceError::Damaged`] if the last row is not whole.
    pub fn new(columns: usize, heights: Vec<f64>) -> Result<Self, SurfaceError> {
        if heights.iter().all(|height| height.is_nan()) {
            return Err(SurfaceError::Empty { hint: "" });
        }
        if columns == 0 || !heights.len().is_multiple_of(columns) {
            return Err(SurfaceError::damaged("height map", "its last row is not whole"));
        }
        if let Some(place) = heights.iter().position(|height| height.is_infinite()) {
            let (row, column) = (place / columns + 1, place % columns + 1);
            return Err(SurfaceError::NotFinite { row, column, value: heights[place] });
        }
        Ok(Self { columns, heights, spacing: None })
    }

    /// A map of parts that are known to be valid.
    pub(crate) const fn of_parts(
        columns: usize,
        heights: Vec<f64>,
        spacing: Option<[f64; 2]>,
    ) -> Self {
        Self { columns, heights, spacing }
    }

    /// The same with this spacing of its points along x and y in m.
    #[must_use]
    pub fn spaced(self, spacing: Option<[f64; 2]>) -> Self {
        Self { spacing, ..self }
    }

    /// Number of columns, along x.
    #[must_use]
    pub const fn columns(&self) -> usize {
        self.columns
    }

    /// Number of rows, along y.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.heights.len() / self.columns
    }

    /// The heights, row by row.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The heights alone.
    #[must_use]
    pub fn into_heights(self) -> Vec<f64> {
        self.heights
    }

    /// Spacing of the points along x and y in m; none if the file does not state it.
    #[must_use]
    pub const fn spacing(&self) -> Option<[f64; 2]> {
        self.spacing
    }

    /// Lengths of the map along x and y in m: number of points times spacing.
    #[must_use]
    pub fn size(&self) -> Option<[f64; 2]> {
        let [dx, dy] = self.spacing?;
        Some([dx * self.columns as f64, dy * self.rows() as f64])
    }

    /// Number of missing points.
    #[must_use]
    pub fn missing(&self) -> usize {
        self.heights.iter().filter(|height| height.is_nan()).count()
    }

    /// Row and column of the first missing point, from 1.
    #[must_use]
    pub fn first_missing(&self) -> Option<[usize; 2]> {
        let place = self.heights.iter().position(|height| height.is_nan())?;
        Some([place / self.columns + 1, place % self.columns + 1])
    }

    /// The heights times a factor.
    ///
    /// # Errors
    /// [`SurfaceError::Scaled`] if a height becomes infinite.
    pub fn scaled(mut self, factor: f64) -> Result<Self, SurfaceError> {
        if let Some(place) = self.heights.iter().position(|height| (height * factor).is_infinite())
        {
            let (row, column) = (place / self.columns + 1, place % self.columns + 1);
            return Err(SurfaceError::Scaled { row, column, value: self.heights[place], factor });
        }
        self.heights.iter_mut().for_each(|height| *height *= factor);
        Ok(self)
    }

    /// A part of the map.
    ///
    /// # Errors
    /// [`SurfaceError::Crop`] if it does not lie in the map, [`SurfaceError::Empty`] if no point in it is measured.
    pub fn cropped(&self, crop: Crop) -> Result<Self, SurfaceError> {
        let [left, lower, right, upper] = crop.0;
        let (columns, rows) = (self.columns, self.rows());
        if left >= right || lower >= upper || right > columns || upper > rows {
            return Err(SurfaceError::Crop { crop: crop.0, columns, rows });
        }
        let rows = self.heights[lower * columns..upper * columns].chunks_exact(columns);
        let heights = rows.flat_map(|row| &row[left..right]).copied().collect();
        Ok(Self::new(right - left, heights)?.spaced(self.spacing))
    }

    /// The same with a height for each missing point: the mean of its neighbours, ring by ring from the border of the
    /// gap, then relaxed to a smooth patch.
    #[must_use]
    pub fn filled(&self) -> Self {
        let holes: Vec<usize> = places(&self.heights, |height| height.is_nan());
        if holes.is_empty() {
            return self.clone();
        }
        let mut heights = self.heights.clone();
        let mut open = holes.clone();
        while !open.is_empty() {
            let filled: Vec<(usize, f64)> = open
                .iter()
                .filter_map(|place| Some((*place, self.mean(&heights, *place)?)))
                .collect();
            filled.iter().for_each(|(place, mean)| heights[*place] = *mean);
            open.retain(|place| heights[*place].is_nan());
        }
        self.relax(&mut heights, &holes);
        Self { heights, ..self.clone() }
    }

    /// Moves each point of the holes to the mean of its neighbours, most sweeps for the largest holes.
    fn relax(&self, heights: &mut [f64], holes: &[usize]) {
        let known = self.heights.iter().filter(|height| !height.is_nan());
        let (low, high) = known.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| {
            (low.min(*height), high.max(*height))
        });
        for _ in 0..MOST_SWEEPS {
            let mut change = 0.0_f64;
            for place in holes {
                let mean = self.mean(heights, *place).unwrap_or(heights[*place]);
                change = change.max((mean - heights[*place]).abs());
                heights[*place] = mean;
            }
            if change <= RELAXED * (high - low) {
                return;
            }
        }
    }

    /// Mean height of the four neighbours that have one.
    fn mean(&self, heights: &[f64], place: usize) -> Option<f64> {
        let (mut sum, mut count) = (0.0, 0_u32);
        for neighbour in self.neighbours(place).into_iter().flatten() {
            if !heights[neighbour].is_nan() {
                sum += heights[neighbour];
                count += 1;
            }
        }
        (count > 0).then(|| sum / f64::from(count))
    }

    /// The places left, right, below and above.
    pub(crate) fn neighbours(&self, place: usize) -> [Option<usize>; 4] {
        let (columns, column) = (self.columns, place % self.columns);
        [
            (column > 0).then(|| place.wrapping_sub(1)),
            (column + 1 < columns).then_some(place + 1),
            place.checked_sub(columns),
            Some(place + columns).filter(|place| *place < self.heights.len()),
        ]
    }
}

/// Largest number of sweeps over the holes.
const MOST_SWEEPS: usize = 200;
/// Change of a sweep over the range of heights at which the holes are filled.
const RELAXED: f64 = 1e-5;

fn places(heights: &[f64], is_one: impl Fn(f64) -> bool) -> Vec<usize> {
    heights
        .iter()
        .enumerate()
        .filter(|(_, height)| is_one(**height))
        .map(|(place, _)| place)
        .collect()
}
