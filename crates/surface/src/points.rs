//! Lists of points x, y, z that lie on a regular grid.

use crate::error::SurfaceError;
use crate::topography::Topography;

/// Part of a step by which a point may lie off its place in the grid.
const OFF: f64 = 0.05;
/// A step is so many times greater than the gaps between points of one place.
const JUMP: f64 = 5.0;
/// Points of the grid for each point of the list, at most: more are scattered points.
const SPARSE: usize = 8;
/// One in so many points may have the place of another in a list that is refused for it.
const TWICE: usize = 100;

/// The places along one axis: the least, the step, the number.
struct Steps {
    first: f64,
    step: f64,
    count: usize,
}

impl Steps {
    /// Steps of values in any order; none if they are not multiples of one step.
    fn of(values: impl Iterator<Item = f64>) -> Option<Self> {
        let mut sorted: Vec<f64> = values.collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let (first, last) = (*sorted.first()?, *sorted.last()?);
        if last == first {
            return Some(Self { first, step: 1.0, count: 1 });
        }
        let gaps: Vec<f64> = sorted.windows(2).map(|pair| pair[1] - pair[0]).collect();
        // Values closer than a millionth of the range are one place, written with few digits.
        let near = 1e-6 * (last - first);
        Self::of_places(&sorted, &gaps, near)
            .or_else(|| Self::of_places(&sorted, &gaps, scatter(&gaps, near)?))
    }

    /// Steps of sorted values, if those whose gaps are at most `near` are one place.
    fn of_places(sorted: &[f64], gaps: &[f64], near: f64) -> Option<Self> {
        let mut places = vec![(0.0, 0_usize)];
        for (at, value) in sorted.iter().enumerate() {
            if at > 0 && gaps[at - 1] > near {
                places.push((0.0, 0));
            }
            let (sum, count) = places.last_mut()?;
            (*sum, *count) = (*sum + value, *count + 1);
        }
        let places: Vec<f64> = places.iter().map(|(sum, count)| sum / *count as f64).collect();
        let (first, last) = (*places.first()?, *places.last()?);
        let smallest =
            places.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        // The smallest gap carries the round-off of two places, the whole length far less.
        let count = libm::round((last - first) / smallest) + 1.0;
        let step = (last - first) / (count - 1.0);
        let is_even = sorted.iter().all(|value| {
            let place = (value - first) / step;
            (place - libm::round(place)).abs() <= OFF
        });
        (is_even && count <= sorted.len() as f64).then_some(Self {
            first,
            step,
            count: count as usize,
        })
    }

    fn place(&self, value: f64) -> usize {
        libm::round((value - self.first) / self.step) as usize
    }
}

/// The scatter of places that were measured: below it are at least half of the gaps, above it none that is not [`JUMP`] times
/// greater.
fn scatter(gaps: &[f64], near: f64) -> Option<f64> {
    let mut sorted: Vec<f64> = gaps.iter().map(|gap| gap.max(near)).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let pairs = sorted.windows(2).skip((sorted.len() / 2).saturating_sub(1));
    let (below, above) =
        pairs.map(|pair| (pair[0], pair[1])).max_by(|a, b| (a.1 / a.0).total_cmp(&(b.1 / b.0)))?;
    (above > JUMP * below).then(|| (below * above).sqrt())
}

/// The map of points `[x, y, z]`, if x and y lie on a grid; `most` is the largest number of its points.
///
/// # Errors
/// [`SurfaceError::Points`] if two points have one place; `line` gives the line of a point.
pub(crate) fn map(
    points: &[[f64; 3]],
    most: usize,
    line: impl Fn(usize) -> usize,
) -> Option<Result<Topography, SurfaceError>> {
    let [x, y] = [0, 1].map(|axis| Steps::of(points.iter().map(move |point| point[axis])));
    let (x, y) = (x?, y?);
    let all = x.count.checked_mul(y.count)?;
    if x.count < 2 || y.count < 2 || all > points.len().saturating_mul(SPARSE) {
        return None;
    }
    if all > most {
        return Some(Err(SurfaceError::TooMany { columns: x.count, rows: y.count, most }));
    }
    let mut heights = vec![f64::NAN; all];
    let mut owner = vec![usize::MAX; all];
    let mut twice = Vec::new();
    for (number, [px, py, height]) in points.iter().enumerate() {
        let place = x.place(*px) + x.count * y.place(*py);
        if owner[place] == usize::MAX {
            owner[place] = number;
            heights[place] = *height;
        } else {
            twice.push([number, owner[place]]);
        }
    }
    if let Some([second, first]) = twice.first() {
        // Many are no places at all, but heights of few digits.
        let is_list = twice.len() <= usize::max(1, points.len() / TWICE);
        let reason = format!("this point has the place of the one in line {}", line(*first));
        return is_list.then(|| Err(SurfaceError::Points { line: line(*second), reason }));
    }
    Some(Topography::new(x.count, heights).map(|map| map.spaced(Some([x.step, y.step]))))
}
