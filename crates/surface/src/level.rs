//! Levelling: a mean, a plane or a paraboloid is subtracted from the heights.

use crate::topography::Topography;

/// What is subtracted from the heights, by least squares over the points that are measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// The mean height.
    Mean,
    /// The plane a + b x + c y.
    Plane,
    /// The paraboloid a + b x + c y + d x^2 + e x y + f y^2.
    Quadratic,
}

impl Level {
    /// All, with the words of case files.
    pub const WORDS: [(Self, &'static str); 3] =
        [(Self::Mean, "mean"), (Self::Plane, "plane"), (Self::Quadratic, "quadratic")];

    const fn terms(self) -> usize {
        match self {
            Self::Mean => 1,
            Self::Plane => 3,
            Self::Quadratic => 6,
        }
    }
}

impl std::str::FromStr for Level {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        let found = Self::WORDS.into_iter().find(|(_, name)| *name == word);
        found.map(|(level, _)| level).ok_or_else(|| "must be mean, plane or quadratic".to_owned())
    }
}

/// Largest number of terms.
const TERMS: usize = 6;

/// A fitted surface: coefficients of 1, u, v, u^2, u v, v^2 with u and v from -1 to 1 over the map.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fit {
    coefficients: [f64; TERMS],
}

/// The terms at a place of a map.
fn terms([u, v]: [f64; 2]) -> [f64; TERMS] {
    [1.0, u, v, u * u, u * v, v * v]
}

/// u and v of a place: from -1 to 1 between the first and the last point.
fn place(map: &Topography, index: usize) -> [f64; 2] {
    let along = |i: usize, count: usize| match count {
        1 => 0.0,
        _ => 2.0 * i as f64 / (count - 1) as f64 - 1.0,
    };
    [along(index % map.columns(), map.columns()), along(index / map.columns(), map.rows())]
}

impl Fit {
    /// The fit of a map by least squares. Terms that the points do not determine are zero.
    pub(crate) fn of(map: &Topography, level: Level) -> Self {
        let count = level.terms();
        let mut normal = [[0.0; TERMS + 1]; TERMS];
        for (index, height) in map.heights().iter().enumerate().filter(|(_, h)| !h.is_nan()) {
            let terms = terms(place(map, index));
            for i in 0..count {
                (0..count).for_each(|j| normal[i][j] += terms[i] * terms[j]);
                normal[i][TERMS] += terms[i] * height;
            }
        }
        Self { coefficients: solved(normal, count) }
    }

    /// The height of the fit at a place.
    pub(crate) fn at(&self, map: &Topography, index: usize) -> f64 {
        let terms = terms(place(map, index));
        terms.iter().zip(self.coefficients).map(|(term, coefficient)| term * coefficient).sum()
    }

    /// Rise from the first to the last column and row, per point.
    pub(crate) fn rise(&self, map: &Topography) -> [f64; 2] {
        let each =
            |rise: f64, count: usize| if count > 1 { 2.0 * rise / (count - 1) as f64 } else { 0.0 };
        [each(self.coefficients[1], map.columns()), each(self.coefficients[2], map.rows())]
    }
}

/// Gauss's elimination of a symmetric positive system; a term without a pivot is zero.
fn solved(mut rows: [[f64; TERMS + 1]; TERMS], count: usize) -> [f64; TERMS] {
    let scale: [f64; TERMS] = std::array::from_fn(|i| rows[i][i]);
    let mut is_kept = [false; TERMS];
    for i in 0..count {
        let pivot = rows[i][i];
        if pivot <= LEAST_PIVOT * scale[i] || pivot == 0.0 {
            continue;
        }
        is_kept[i] = true;
        let head = rows[i];
        for (j, row) in rows.iter_mut().enumerate().take(count) {
            if j != i {
                let factor = row[i] / pivot;
                row.iter_mut().zip(head).for_each(|(value, other)| *value -= factor * other);
            }
        }
    }
    std::array::from_fn(|i| if i < count && is_kept[i] { rows[i][TERMS] / rows[i][i] } else { 0.0 })
}

/// Pivot over its diagonal below which a term is not determined.
const LEAST_PIVOT: f64 = 1e-12;

impl Topography {
    /// The same less a fit by least squares over the points that are measured.
    ///
    /// ```
    /// use carom_surface::{Level, Topography};
    /// let tilted = Topography::new(3, vec![0.0, 1.0, 2.0, 10.0, 11.0, 12.0])?;
    /// assert!(tilted.levelled(Level::Plane).heights().iter().all(|height| height.abs() < 1e-14));
    /// # Ok::<(), carom_surface::SurfaceError>(())
    /// ```
    #[must_use]
    pub fn levelled(&self, level: Level) -> Self {
        let fit = Fit::of(self, level);
        let heights = self.heights().iter().enumerate();
        let heights = heights.map(|(index, height)| height - fit.at(self, index)).collect();
        Self::of_parts(self.columns(), heights, self.spacing())
    }
}
