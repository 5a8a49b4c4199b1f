//! Stresses below the contact after the last step.

use crate::error::CliError;
use carom_cases::Error;
use carom_cases::case::SolveCase;
use carom_halfspace::{Material, Stress};
use carom_solver::{ContactState, StepSummary, Subsurface};
use carom_special::RangeError;
use carom_special::linspace;
use carom_table::Column;

/// Largest depth, over the radius of a circular contact of the same area or half the shorter side of the contact: the
/// greatest shear of a line contact lies .78 of its half width deep.
const RADII: f64 = 3.0;

/// The stress in a body at a depth, in the common axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Below {
    body: u64,
    depth: f64,
    stress: Stress,
}

/// Its columns.
pub(super) const COLUMNS: &[Column<Below>] = &[
    Column::count("body", "", "1 or 2", |below| below.body.into()),
    Column::new("depth", "m", "below the point of maximum pressure", |below| below.depth.into()),
    Column::new("s_xx", "Pa", "stress, tension positive", |below| below.stress.xx.into()),
    Column::new("s_yy", "Pa", "", |below| below.stress.yy.into()),
    Column::new("s_zz", "Pa", "", |below| below.stress.zz.into()),
    Column::new("s_xy", "Pa", "", |below| below.stress.xy.into()),
    Column::new("s_yz", "Pa", "", |below| below.stress.yz.into()),
    Column::new("s_zx", "Pa", "", |below| below.stress.zx.into()),
    Column::new("von_mises", "Pa", "equivalent stress", |below| below.stress.von_mises().into()),
];

/// Half of the shorter side of the rectangle about the contact, of sides with more than one cell.
fn shorter(state: &ContactState) -> Option<f64> {
    let (grid, extent) = (state.pressure.grid(), state.extent()?);
    let sides = [(grid.nx(), grid.dx(), extent[0]), (grid.ny(), grid.dy(), extent[1])];
    let halves = sides
        .into_iter()
        .filter(|(count, ..)| *count > 1)
        .map(|(_, width, [first, last])| 0.5 * width * (last - first + 1) as f64);
    halves.min_by(f64::total_cmp)
}

/// The stresses along the normal through the cell of maximum pressure, at `count` depths in each
/// elastic body; empty if the bodies are separated.
pub(super) fn along_normal(
    case: &SolveCase,
    state: &ContactState,
    last: &StepSummary,
    count: usize,
) -> Result<Vec<Below>, CliError> {
    let values = state.pressure.values().iter().copied().zip(state.pressure.grid().centres());
    let greatest = values.max_by(|one, other| one.0.total_cmp(&other.0));
    let Some((_, (x, y))) = greatest.filter(|(pressure, _)| *pressure > 0.0) else {
        return Ok(Vec::new());
    };
    let round = (last.contact_area / std::f64::consts::PI).sqrt();
    let reach = RADII * shorter(state).map_or(round, |half| half.min(round));
    let depths = linspace(0.0, reach, count);
    type Make = fn(&ContactState, Material) -> Result<Subsurface, RangeError>;
    let bodies: [(u64, Material, Make); 2] = [
        (1, case.materials.body_1(), Subsurface::of_body_1),
        (2, case.materials.body_2(), Subsurface::of_body_2),
    ];
    let mut rows = Vec::new();
    for (body, material, make) in bodies.into_iter().filter(|(_, body, _)| !body.is_rigid()) {
        let below = make(state, material).map_err(Error::from)?;
        let stresses = below.along_normal(x, y, depths.iter().copied()).map_err(Error::from)?;
        let pairs = depths.iter().zip(stresses);
        rows.extend(pairs.map(|(depth, stress)| Below { body, depth: *depth, stress }));
    }
    Ok(rows)
}
