//! The case file of `carom shell`.

mod bellows;
mod flange;

pub use bellows::BellowsCase;
pub use flange::FlangeCase;

use super::error::CaseError;
use super::field::{Field, Schema};
use super::material::{self, ELASTIC, POISSON, YOUNG};
use super::reader::Case;
use super::section::{Section, parse};
use bellows::BELLOWS;
use carom_shells::Wall;
use carom_special::RangeError;
use flange::FLANGE;

/// All fields.
const FIELDS: &[Field] = &[BELLOWS, FLANGE];

/// A thin ring or shell of revolution.
#[derive(Debug, Clone, PartialEq)]
pub enum ShellCase {
    /// An expansion bellows under pressure and axial load.
    Bellows(BellowsCase),
    /// A flange under forces around it, alone or at the end of a tube.
    Flange(FlangeCase),
}

impl Case<'_> for ShellCase {
    const SCHEMA: Schema = Schema::new(
        "shell",
        "A bellows under pressure and axial load, or a flange under forces around it.",
        FIELDS,
    );

    fn read(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        match (case.has(&BELLOWS), case.has(&FLANGE)) {
            (true, true) => Err(case.conflict(&FLANGE, &BELLOWS, "a case has one of them")),
            (true, false) => BellowsCase::read(&case).map(Self::Bellows),
            (false, true) => FlangeCase::read(&case).map(Self::Flange),
            (false, false) => Err(case.missing(&BELLOWS)),
        }
    }
}

/// Young's modulus and Poisson's ratio of an elastic material.
fn elastic(owner: &Section<'_>) -> Result<[f64; 2], CaseError> {
    let material = material::read_elastic(owner)?;
    if material.is_rigid() {
        return Err(owner.out_of_range(&ELASTIC, f64::INFINITY, "elastic"));
    }
    let allowed = "from 0 to 0.5";
    if material.poisson() < 0.0 {
        return Err(owner.out_of_range([&ELASTIC, &POISSON], material.poisson(), allowed));
    }
    Ok([material.young_modulus(), material.poisson()])
}

/// A wall of this material; `thickness` is the field of `owner` that gives its thickness.
fn wall(owner: &Section<'_>, material: [f64; 2], thickness: &Field) -> Result<Wall, CaseError> {
    let value = owner.number(thickness)?;
    let refused = |error: RangeError| match error.field {
        "thickness" => owner.refused(error),
        _ => owner.out_of_range([&ELASTIC, &YOUNG], material[0], error.allowed),
    };
    Wall::new(material[0], material[1], value).map_err(refused)
}
