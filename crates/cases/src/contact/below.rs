//! Extreme stresses at points below the surface, as CONTACT prints them.

use super::case::ContactCase;
use super::potential::Potential;
use crate::Error;
use carom_halfspace::{Point, Stress};
use carom_solver::{ContactState, Subsurface};
use carom_special::RangeError;
use carom_table::Column;

/// The most products of points and cells in contact of a block.
const MOST_PRODUCTS: usize = 2_000_000_000;

/// An extreme of a stress in a block of points.
#[derive(Debug, Clone, PartialEq)]
pub struct Below {
    /// The number of the case.
    pub case: usize,
    /// The number of the block.
    pub block: usize,
    /// The name of the stress.
    pub name: &'static str,
    /// The extreme value, N/mm^2.
    pub value: f64,
    /// Where it is, mm.
    pub at: [f64; 3],
}

/// The columns.
pub const BELOW: &[Column<Below>] = &[
    Column::count("case", "", "its number in the file", |row| (row.case as u64).into()),
    Column::count("block", "", "of points", |row| (row.block as u64).into()),
    Column::text("stress", "", "its name in CONTACT", |row| row.name.into()),
    Column::new("value", "N/mm^2", "extreme value", |row| row.value.into()),
    Column::vector("at", "mm", "where it is", |row| row.at.into()),
];

/// How an extreme is chosen.
#[derive(Debug, Clone, Copy)]
enum Most {
    Greatest,
    Least,
    Absolute,
}

/// A stress, and how its extreme is chosen.
type Told = (&'static str, Most, fn(&Stress) -> f64);

const TOLD: [Told; 8] = [
    ("SIGHYD", Most::Absolute, |stress| stress.mean()),
    ("SIGVM", Most::Greatest, |stress| stress.von_mises()),
    ("SIGTR", Most::Greatest, |stress| 2.0 * stress.maximum_shear()),
    ("SIGMA1", Most::Greatest, |stress| stress.principal().maximum),
    ("SIGMA3", Most::Least, |stress| stress.principal().minimum),
    ("SIGXX", Most::Absolute, |stress| stress.xx),
    ("SIGYY", Most::Absolute, |stress| stress.yy),
    ("SIGZZ", Most::Absolute, |stress| stress.zz),
];

impl Most {
    fn of(self, value: f64) -> f64 {
        match self {
            Self::Greatest => value,
            Self::Least => -value,
            Self::Absolute => value.abs(),
        }
    }
}

/// The extreme stresses of each block of a case.
pub(super) fn extremes(
    case: &ContactCase,
    state: &ContactState,
    area: &Potential,
) -> Result<Vec<Below>, Error> {
    if case.blocks.is_empty() {
        return Ok(Vec::new());
    }
    let loaded = state.pressure.values().iter().filter(|pressure| **pressure > 0.0).count();
    let bodies = case.materials;
    let upper = Subsurface::of_body_1(state, bodies.body_1())?;
    let lower = Subsurface::of_body_2(state, bodies.body_2())?;
    let middle = area.middle();
    let mut all = Vec::new();
    for (number, block) in case.blocks.iter().enumerate() {
        let points = block.points(&case.area);
        let points = points.filter(|points| points.len() * loaded <= MOST_PRODUCTS);
        let points = points
            .ok_or_else(|| Error::input(format!("block {} has too many points", number + 1)))?;
        let stress = |at: &[f64; 3]| -> Result<Stress, RangeError> {
            let body = if at[2] < 0.0 { &lower } else { &upper };
            body.stress(Point { x: at[0] - middle[0], y: at[1] - middle[1], z: at[2] })
        };
        let stresses = points.iter().map(stress).collect::<Result<Vec<_>, _>>()?;
        all.extend(TOLD.iter().filter_map(|told| {
            let (name, most, of) = *told;
            // The first of several, as CONTACT takes it.
            let values = stresses.iter().map(of).enumerate();
            let (place, value) =
                values.fold(None, |best: Option<(usize, f64)>, (place, value)| match best {
                    Some((_, so_far)) if most.of(value) <= most.of(so_far) => best,
                    _ => Some((place, value)),
                })?;
            Some(Below { case: case.number, block: number + 1, name, value, at: points[place] })
        }));
    }
    Ok(all)
}
