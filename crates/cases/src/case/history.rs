//! The case file of `carom history`.

use super::contact::{
    COULOMB, FRICTION, LAWS_OF_SHIFTS, SHIFT_STATIC_FRICTION, static_friction, turning_law,
};
use super::error::CaseError;
use super::field::{Default, Field, Form, Rows, Schema};
use super::pair::{self, ANGLE, BODY_1, BODY_2, Pair};
use super::range::Range;
use super::reader::Case;
use super::section::{Section, parse};
use super::unit::{Dimension, Measure};
use carom_laws::coulomb::Tolerance;
use carom_laws::hertz::Hertz;
use carom_laws::law::Shift;
use carom_laws::static_friction::StaticFriction;
use carom_laws::turning_law::TurningLaw;
use carom_special::RangeError;
use std::path::PathBuf;

const LAW: Field = Field::new(
    "law",
    Form::Word(LAWS_OF_SHIFTS),
    "law of friction where the direction of the shift turns",
)
.default(Default::Word(COULOMB));
const TOLERANCE: Field = Field::number(
    "tolerance",
    Range::LawTolerance.pure(),
    "tolerance of the law \"coulomb\", relative to the largest shift",
)
.default(Default::Number(1e-3));
const CONTACT: Field = Field::new(
    "contact",
    Form::Table(&[ANGLE, FRICTION, SHIFT_STATIC_FRICTION, LAW, TOLERANCE]),
    "orientation of the bodies, and friction",
);
const LENGTH: Measure = Range::Finite.of(Dimension::Length);
const STEPS: Field = Field::new(
    "steps",
    Form::Rows(Rows {
        parts: &["zeta", "xi", "eta", "omega"],
        measures: &[LENGTH, LENGTH, LENGTH, Range::Finite.of(Dimension::Radians)],
        optional: 1,
        least: 1,
        words: "a list of rows [zeta, xi, eta] or [zeta, xi, eta, omega]",
    }),
    "shifts of body 2 against body 1 after each step, xi along the larger relative curvature and eta across it, and the twist",
)
.or("`file`")
.such_as("[[1e-6, 0, 0], [1e-6, 2e-7, 0], [1e-6, 0, 0]]");
const FILE: Field = Field::new(
    "file",
    Form::Text("the name of a CSV file with the columns zeta, xi, eta and optionally omega"),
    "CSV file of the steps, in plain units; its path is relative to the case file",
)
.or("`steps`")
.such_as("\"steps.csv\"");
const HISTORY: Field = Field::new("history", Form::Table(&[STEPS, FILE]), "the history of shifts")
    .begun(&[(&STEPS, "")]);

/// All fields.
const FIELDS: &[Field] = &[BODY_1, BODY_2, CONTACT, HISTORY];

/// A contact and its history of shifts.
#[derive(Debug, Clone, PartialEq)]
pub struct HistoryCase {
    /// The contact.
    pub hertz: Hertz,
    /// The smallest radius of curvature of both bodies, m; infinite for planes.
    pub smallest_radius: f64,
    /// Coefficients of friction, equal but with static friction; infinite for no slip.
    pub friction: StaticFriction,
    /// The law of friction where the direction of the shift turns.
    pub law: TurningLaw,
    /// Tolerance of the law `coulomb`.
    pub tolerance: Tolerance,
    /// The shifts.
    pub steps: Steps,
}

/// The source of the shifts.
#[derive(Debug, Clone, PartialEq)]
pub enum Steps {
    /// In the case file.
    Inline(Vec<Shift>),
    /// In a CSV file, relative to the case file.
    File(PathBuf),
}

impl Case<'_> for HistoryCase {
    const SCHEMA: Schema = Schema::new(
        "history",
        "A contact that is pressed, shifted and twisted, step by step.",
        FIELDS,
    );

    fn read(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let case = Section::root(source, table.get_ref(), FIELDS)?;
        let contact = case.section(&CONTACT)?;
        let (law, tolerance) = law(&contact)?;
        let Pair { hertz, smallest_radius } = pair::read(&case, Some(&contact))?;
        let friction = static_friction(&contact, &SHIFT_STATIC_FRICTION)?;
        let history = case.section(&HISTORY)?;
        let given = history.given([&STEPS, &FILE]);
        let steps = match given.as_slice() {
            [field] if field.name == STEPS.name => {
                Steps::Inline(history.rows(&STEPS)?.into_iter().map(shift).collect())
            }
            [] | [_] => Steps::File(history.text(&FILE)?.into()),
            both => return Err(history.several(both, "give one of them")),
        };
        let case = Self { hertz, smallest_radius, friction, law, tolerance, steps };
        if let Steps::Inline(shifts) = &case.steps {
            let at_fault =
                |error: RangeError| history.out_of_range(&STEPS, error.value, error.allowed);
            case.check_twist(shifts).map_err(at_fault)?;
        }
        Ok(case)
    }
}

impl HistoryCase {
    /// Checks that no step has a twist if static friction exceeds kinetic friction: torsion has one coefficient.
    ///
    /// # Errors
    /// [`RangeError`] of the first twist.
    pub fn check_twist(&self, shifts: &[Shift]) -> Result<(), RangeError> {
        let allowed = "0 as `omega` of all steps with `contact.static_friction`: torsion has one coefficient of friction";
        let twisted = shifts.iter().find(|shift| shift.omega != 0.0);
        match twisted.filter(|_| self.friction.drops()) {
            Some(shift) => Err(RangeError::new("omega", shift.omega, allowed)),
            None => Ok(()),
        }
    }
}

fn law(contact: &Section<'_>) -> Result<(TurningLaw, Tolerance), CaseError> {
    let law = turning_law(contact.word(&LAW)?);
    if law == TurningLaw::FixedDirection && contact.has(&TOLERANCE) {
        return Err(contact.conflict(
            &TOLERANCE,
            &LAW,
            "the law \"fixed-direction\" has no tolerance",
        ));
    }
    let tolerance = Tolerance::new(contact.number(&TOLERANCE)?)
        .map_err(|error| contact.out_of_range(&TOLERANCE, error.value, error.allowed))?;
    Ok((law, tolerance))
}

/// The shift of a row zeta, xi, eta, omega.
fn shift([zeta, xi, eta, omega]: [f64; 4]) -> Shift {
    Shift { zeta, xi, eta, omega }
}
