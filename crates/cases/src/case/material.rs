//! The material of a body: `material`.

use super::error::CaseError;
use super::field::{Default, Field, Form, Usual};
use super::range::Range;
use super::section::Section;
use super::unit::Dimension;
use carom_halfspace::Material;
use carom_special::RangeError;

const MODULUS: super::unit::Measure = Range::Positive.of(Dimension::Pressure);
/// Young's modulus in a table `material`.
pub(super) const YOUNG: Field = Field::number("young_modulus", MODULUS, "Young's modulus E")
    .or("`shear_modulus`, or `rigid = true`")
    .such_as("208e9")
    .usually(Usual::MODULUS);
const SHEAR: Field = Field::number("shear_modulus", MODULUS, "shear modulus G")
    .or("`young_modulus`")
    .such_as("80e9")
    .usually(Usual::MODULUS);
/// Poisson's ratio in it.
pub(super) const POISSON: Field =
    Field::number("poisson", Range::Poisson.pure(), "Poisson's ratio")
        .or("`rigid = true`")
        .such_as("0.3");
const RIGID: Field =
    Field::new("rigid", Form::Switch, "whether the body is rigid; only one of the two may be")
        .default(Default::False);

const NO_YIELD: &str = "no warning where it yields";
const YIELD: Field = Field::number(
    "yield_stress",
    MODULUS,
    "yield stress Y in tension; all stays elastic, with a warning where the greatest pressure exceeds 1.6 Y",
)
.may(NO_YIELD)
.such_as("\"1.2 GPa\"")
.usually(Usual::STRENGTH);
const HARDNESS: Field = Field::number(
    "hardness",
    MODULUS,
    "hardness H as a pressure (Vickers, Brinell), instead of the yield stress: Y = H/2.8",
)
.may(NO_YIELD)
.such_as("\"7 GPa\"")
.usually(Usual::STRENGTH);

/// The field `material` of an elastic body without contact.
pub(super) const ELASTIC: Field = Field::new(
    "material",
    Form::Table(&[YOUNG, SHEAR, POISSON, RIGID]),
    "material: two elastic constants, or rigid",
)
.begun(&[(&YOUNG, ""), (&POISSON, "")]);
/// The field `material` of a body in contact.
pub(super) const MATERIAL: Field = Field::new(
    "material",
    Form::Table(&[YOUNG, SHEAR, POISSON, RIGID, YIELD, HARDNESS]),
    "material: two elastic constants, or rigid, and the yield stress if it is known",
)
.begun(&[(&YOUNG, ""), (&POISSON, "")]);

/// The field `material` of a body in an impact: a new case states the yield stress, so that it tells whether the body
/// yields.
pub(super) const YIELDING: Field = MATERIAL.begun(&[(&YOUNG, ""), (&POISSON, ""), (&YIELD, "2e9")]);

/// Reads the material of a body in contact.
pub(super) fn read(body: &Section<'_>) -> Result<Material, CaseError> {
    let table = body.section(&MATERIAL)?;
    let material = constants(&table)?;
    match table.given([&YIELD, &HARDNESS]).as_slice() {
        [] => Ok(material),
        [field] if field.name == YIELD.name => material.yielding_at(table.number(&YIELD)?),
        [_] => material.with_hardness(table.number(&HARDNESS)?),
        both => return Err(table.several(both, "give one of the two")),
    }
    .map_err(|error| table.refused(error))
}

/// Reads the material of an elastic body without contact.
pub(super) fn read_elastic(body: &Section<'_>) -> Result<Material, CaseError> {
    constants(&body.section(&ELASTIC)?)
}

fn constants(material: &Section<'_>) -> Result<Material, CaseError> {
    if material.switch(&RIGID)? {
        return match material.given([&YOUNG, &SHEAR, &POISSON]).first() {
            Some(field) => {
                Err(material.conflict(*field, &RIGID, "a rigid body has no elastic constants"))
            }
            None => Ok(Material::RIGID),
        };
    }
    let poisson = || match material.has(&POISSON) {
        true => material.number(&POISSON),
        false => Err(material.missing_as(&POISSON, Range::Poisson.allowed())),
    };
    let made = match material.given([&YOUNG, &SHEAR]).as_slice() {
        [] => return Err(material.missing(&YOUNG)),
        [field] if field.name == SHEAR.name => {
            Material::from_shear(material.number(&SHEAR)?, poisson()?)
        }
        [_] => Material::from_young(material.number(&YOUNG)?, poisson()?),
        both => return Err(material.several(both, "give one of the two")),
    };
    made.map_err(|RangeError { field, value, allowed }| {
        let field = if field == POISSON.name { &POISSON } else { &YOUNG };
        let field = if material.has(field) { field } else { &SHEAR };
        material.out_of_range(field, value, allowed)
    })
}
