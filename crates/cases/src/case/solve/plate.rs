//! The plate that body 2 may be: `bodies.plate`.

use super::influence::INFLUENCE;
use super::{Border, CUT, GRID, GridCase, PERIODIC, SIZE};
use crate::case::error::CaseError;
use crate::case::field::{Default, Field, Form};
use crate::case::range::Range;
use crate::case::section::Section;
use crate::case::unit::{Dimension, Measure};
use carom_halfspace::MaterialPair;
use carom_halfspace::operator::{Plate, PlateSymbol};

const LENGTH: Measure = Range::Positive.of(Dimension::Length);
const A: Field = Field::number("a", LENGTH, "side along x").such_as("0.3");
const B: Field = Field::number("b", LENGTH, "side along y").such_as("0.3");
const THICKNESS: Field =
    Field::number("thickness", LENGTH, "thickness, at least 1e-6 of the longer side")
        .such_as("4e-3");
const THEORY: Field = Field::new(
    "theory",
    Form::Word(&[
        (PlateSymbol::Layer.name(), "the elastic body itself, from bending to the half-space"),
        (PlateSymbol::Sum.name(), "Kirchhoff's plate and a half-space added"),
        (PlateSymbol::Kirchhoff.name(), "bending alone"),
        (PlateSymbol::Mindlin.name(), "bending and shear"),
    ]),
    "theory of the displacement",
)
.default(Default::Word(PlateSymbol::Layer.name()));
/// The field `plate` of a case.
pub(super) const PLATE: Field = Field::new(
    "plate",
    Form::Table(&[A, B, THICKNESS, THEORY]),
    "body 2 as a plate, simply supported at its edges, its middle at the origin; the grid covers \
     it, and there is no friction",
)
.may("body 2 is a half-space")
.such_as("{ a = 0.3, b = 0.3, thickness = 4e-3 }");
/// The field `bodies` of a case.
pub(super) const BODIES: Field =
    Field::new("bodies", Form::Table(&[PLATE, INFLUENCE]), "what the bodies are")
        .may("both are half-spaces");

/// A plate and its theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlateCase {
    /// Sides and thickness.
    pub plate: Plate,
    /// The theory of its displacement.
    pub theory: PlateSymbol,
}

/// Reads the plate, and checks material, grid and border against it.
pub(super) fn read(
    case: &Section<'_>,
    materials: MaterialPair,
    grid: GridCase,
) -> Result<Option<PlateCase>, CaseError> {
    if !case.has(&BODIES) {
        return Ok(None);
    }
    let bodies = case.section(&BODIES)?;
    if !bodies.has(&PLATE) {
        return Ok(None);
    }
    let given = bodies.section(&PLATE)?;
    let plate = Plate::new(given.number(&A)?, given.number(&B)?, given.number(&THICKNESS)?)
        .map_err(|error| given.refused(error))?;
    // The reader has rejected other words.
    let theory = given.word(&THEORY)?.parse().unwrap_or_default();
    let place = [&BODIES, &PLATE];
    if materials.body_2().is_rigid() {
        let reason = "a plate is elastic";
        return Err(case.conflict(place, [&super::BODY_2, &super::MATERIAL], reason));
    }
    if let GridCase::Cells { grid: cells, border } = grid {
        match border {
            Border::Free => {}
            Border::Periodic => {
                let reason = "a plate is held at its edges and has no period";
                return Err(case.conflict([&GRID, &PERIODIC], place, reason));
            }
            Border::Cut => {
                let reason = "a plate is held at its edges, and no contact may reach them";
                return Err(case.conflict([&GRID, &CUT], place, reason));
            }
        }
        plate.check_cover(cells).map_err(|error| {
            let allowed = format!(
                "the sides of the plate, [{}, {}]: the grid covers it, no more and no less",
                plate.a(),
                plate.b()
            );
            let sizes = case.section(&GRID).and_then(|grid| grid.vector::<2>(&SIZE));
            let along = usize::from(error.field == "ny dy");
            let value = sizes.map_or(error.value, |sizes| sizes[along]);
            case.out_of_range([&GRID, &SIZE], value, &allowed)
        })?;
    }
    Ok(Some(PlateCase { plate, theory }))
}
