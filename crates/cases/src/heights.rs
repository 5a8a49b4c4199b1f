//! Maps from files: the heights of a surface, factors of friction.

use crate::Error;
use crate::case::{Border, GridCase, HeightFile, Missing};
use crate::input::CaseFile;
use carom_halfspace::{Field, Grid, room};
use carom_solver::{Gap, HeightMap};
use carom_surface::{Format, Measured, Measures, Reading, SurfaceError, Topography, read, spikes};
use std::path::Path;

/// Bytes of memory for each point of a map: its heights, and what is made of them.
const BYTES: u128 = 32;

/// The factors in a file, one for each cell, and its content.
///
/// # Errors
/// [`ErrorKind::Input`](crate::ErrorKind::Input) as [`gap`], or if a factor is negative.
pub(crate) fn factors(case: &CaseFile, file: &Path, grid: Grid) -> Result<(Field, Vec<u8>), Error> {
    let refused = |reason: String| Error::input(reason).of_file(&case.beside(file));
    let reading = Reading { size: Some([grid.nx(), grid.ny()]), ..Reading::default() };
    let (measured, read) = measured(case, file, reading)?;
    let map = measured.topography;
    if let Some(place) = map.heights().iter().position(|factor| *factor < 0.0 || factor.is_nan()) {
        let (row, column) = (place / map.columns() + 1, place % map.columns() + 1);
        let factor = map.heights()[place];
        let told = format!(
            "the factor of friction in row {row}, column {column} is {factor}: must be finite and >= 0"
        );
        return Err(refused(told));
    }
    let field = Field::new(grid, map.into_heights()).map_err(|error| refused(error.to_string()))?;
    Ok((field, read))
}

/// Heights of a file over a grid.
pub(crate) struct Heights {
    /// The gap under them.
    pub(crate) gap: Gap,
    /// The content of the file.
    pub(crate) read: Vec<u8>,
    /// What is told about the map.
    pub(crate) warnings: Vec<String>,
}

/// The gap of the heights in the file that the case names.
///
/// # Errors
/// [`ErrorKind::Input`](crate::ErrorKind::Input) if the file is no map, points are missing and the case does not say
/// what stands for them, the size differs from that of the grid, or a height is too large.
pub(crate) fn gap(case: &CaseFile, map: &HeightFile, grid: GridCase) -> Result<Heights, Error> {
    let refused = |reason: String| Error::input(reason).of_file(&case.beside(&map.file));
    let reading = Reading { size: grid.cells().filter(|_| map.crop.is_none()), ..map.reading };
    let (measured, read) = measured(case, &map.file, reading)?;
    let prepared = Prepared::of(measured, map).map_err(|error| refused(error.to_string()))?;
    let Prepared { topography: level, notes: mut warnings, .. } = prepared;
    let points = [level.columns(), level.rows()];
    let cells = grid.of_points(points, level.spacing()).map_err(refused)?;
    let body = covered(&level, map.missing).map_err(refused)?;
    let body = body.spaced(Some([cells.dx(), cells.dy()]));
    let measures = Measures::of(&body, None, &spikes(&body));
    warnings.extend(measures.warnings(grid.border() == Border::Periodic));
    let heights = HeightMap::new(body.columns(), body.into_heights());
    let gap = heights.and_then(|heights| heights.gap_over(cells, map.radius));
    let gap = gap.map_err(|error| refused(error.to_string()))?;
    let gap = match map.missing {
        Some(Missing::NoContact) => without(gap, &level)?,
        _ => gap,
    };
    Ok(Heights { gap, read, warnings })
}

/// A map as the fields of a case make it: cut, scaled and levelled, its missing points still missing.
#[derive(Debug, Clone, PartialEq)]
pub struct Prepared {
    /// The heights in m.
    pub topography: Topography,
    /// The kind of file.
    pub format: Format,
    /// Whether the file or the case says what the heights are measured in.
    pub has_unit: bool,
    /// What a user should know about the file.
    pub notes: Vec<String>,
}

impl Prepared {
    /// Cuts, scales and levels a map.
    ///
    /// # Errors
    /// [`SurfaceError`] if the part does not lie in the map, or a height becomes infinite.
    pub fn of(measured: Measured, map: &HeightFile) -> Result<Self, SurfaceError> {
        let has_unit = measured.has_unit || map.scale != 1.0;
        let Measured { topography, format, notes, .. } = measured;
        let part = match map.crop {
            Some(crop) => topography.cropped(crop)?,
            None => topography,
        };
        let scaled = if map.scale == 1.0 { part } else { part.scaled(map.scale)? };
        let topography = match map.level {
            Some(level) => scaled.levelled(level),
            None => scaled,
        };
        Ok(Self { topography, format, has_unit, notes })
    }
}

/// The map with a height at each point.
fn covered(map: &Topography, missing: Option<Missing>) -> Result<Topography, String> {
    match (map.first_missing(), missing) {
        (None, _) => Ok(map.clone()),
        (Some(_), Some(_)) => Ok(map.filled()),
        (Some([row, column]), None) => Err(format!(
            "points of the height map are missing ({}), the first in row {row}, column {column}: give \
             `missing` = \"fill\" or \"no contact\"",
            map.missing()
        )),
    }
}

/// The gap with no body where a point of the map is missing; it is zero at the highest point that is left.
fn without(gap: Gap, map: &Topography) -> Result<Gap, Error> {
    let gaps = gap.heights().values().iter().zip(map.heights());
    let open = gaps.map(|(gap, height)| if height.is_nan() { f64::INFINITY } else { *gap });
    let mut open: Vec<f64> = open.collect();
    let lowest = open.iter().copied().fold(f64::INFINITY, f64::min);
    open.iter_mut().for_each(|gap| *gap -= lowest);
    Ok(Gap::new(Field::new(gap.grid(), open)?)?)
}

/// The map in a file, and the content of the file.
fn measured(case: &CaseFile, file: &Path, reading: Reading) -> Result<(Measured, Vec<u8>), Error> {
    let bytes = case.map(file)?;
    let path = case.beside(file);
    let measured =
        read_named(&path, &bytes, reading).map_err(|told| Error::input(told).of_file(&path))?;
    Ok((measured, bytes))
}

/// The map in the content of a file.
///
/// # Errors
/// What is wrong, in words; also that the content is not of the kind that the name of the file says.
pub fn read_named(path: &Path, bytes: &[u8], reading: Reading) -> Result<Measured, String> {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    let named = [Format::X3p, Format::Sur, Format::Sdf, Format::Npy, Format::Png]
        .into_iter()
        .find(|format| format.name().eq_ignore_ascii_case(ending));
    read(bytes, &within_memory(reading)).map_err(|error| match named {
        Some(named) if Format::of(bytes) == Ok(Format::Text) => {
            format!(
                "this is not a {} file, or it is damaged; read as a text, {error}",
                named.name()
            )
        }
        _ => error.to_string(),
    })
}

/// The same with at most as many points as fit into the memory.
#[must_use]
pub fn within_memory(reading: Reading) -> Reading {
    let room = usize::try_from(room::available() / BYTES).unwrap_or(usize::MAX);
    Reading { most_points: reading.most_points.min(room), ..reading }
}
