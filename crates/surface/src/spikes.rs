//! Points that lie far off all their neighbours: a fault of the instrument, or a hole that a program filled.

use crate::topography::Topography;

/// A point that lies far off its neighbours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spike {
    /// Its row, from 1.
    pub row: usize,
    /// Its column, from 1.
    pub column: usize,
    /// Its height in m.
    pub height: f64,
    /// The median height of its neighbours in m.
    pub around: f64,
}

impl Spike {
    /// How far it lies off.
    #[must_use]
    pub fn off(&self) -> f64 {
        (self.height - self.around).abs()
    }
}

/// Distance from the neighbours over its typical size (1.48 times the median of those above zero) from which a point is a
/// spike.
const FAR: f64 = 50.0;
/// Part of the points above which they are texture, not spikes.
const MOST: f64 = 0.01;

/// The points that lie more than 50 typical distances off the median of their up to eight neighbours, the farthest first;
/// none if more than one in a hundred does.
///
/// ```
/// use carom_surface::{Topography, spikes};
/// let heights = (0..100).map(|i| if i == 37 { 1.0 } else { 1e-7 * f64::from(i % 7) });
/// let found = spikes(&Topography::new(10, heights.collect())?);
/// assert_eq!((found.len(), found[0].row, found[0].column), (1, 4, 8));
/// # Ok::<(), carom_surface::SurfaceError>(())
/// ```
#[must_use]
pub fn spikes(map: &Topography) -> Vec<Spike> {
    let distances: Vec<(usize, f64)> = (0..map.heights().len())
        .filter_map(|place| Some((place, map.heights()[place] - around(map, place)?)))
        .filter(|(_, distance)| !distance.is_nan())
        .collect();
    // Points that are level with their neighbours say nothing on a typical distance.
    let sizes = distances.iter().map(|(_, distance)| distance.abs());
    let mut sizes: Vec<f64> = sizes.filter(|size| *size > 0.0).collect();
    if sizes.is_empty() {
        return Vec::new();
    }
    let middle = sizes.len() / 2;
    let (_, median, _) = sizes.select_nth_unstable_by(middle, f64::total_cmp);
    let typical = 1.4826 * *median;
    let far = distances.into_iter().filter(|(_, distance)| distance.abs() > FAR * typical);
    let spike = |(place, distance): (usize, f64)| {
        let height = map.heights()[place];
        let (row, column) = (place / map.columns() + 1, place % map.columns() + 1);
        Spike { row, column, height, around: height - distance }
    };
    let mut found: Vec<Spike> = far.map(spike).collect();
    if found.len() as f64 > f64::max(1.0, MOST * map.heights().len() as f64) {
        return Vec::new();
    }
    found.sort_by(|a, b| b.off().total_cmp(&a.off()));
    found
}

/// Median height of the up to eight neighbours that are measured; none if fewer than three are.
fn around(map: &Topography, place: usize) -> Option<f64> {
    let (columns, rows) = (map.columns(), map.rows());
    let (column, row) = (place % columns, place / columns);
    let mut heights = [0.0; 8];
    let mut count = 0;
    for j in row.saturating_sub(1)..=(row + 1).min(rows - 1) {
        for i in column.saturating_sub(1)..=(column + 1).min(columns - 1) {
            let height = map.heights()[j * columns + i];
            if (i, j) != (column, row) && !height.is_nan() {
                heights[count] = height;
                count += 1;
            }
        }
    }
    let known = heights.get_mut(..count).filter(|known| known.len() >= 3)?;
    known.sort_unstable_by(f64::total_cmp);
    // Of an even number the lower of the middle two: one spike among the neighbours does not move it.
    Some(known[(known.len() - 1) / 2])
}
