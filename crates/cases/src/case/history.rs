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
use super::varied::{Input, UNKNOWN, Varied};
use carom_laws::coulomb::Tolerance;
use carom_laws::hertz::Hertz;
use carom_laws::law::Shift;
use carom_laws::static_friction::StaticFriction;
use carom_laws::turning_law::TurningLaw;
use carom_special::RangeError;
use std::path::PathBuf;
use toml::de::DeTable;

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
const WAYS: &str = "one of `steps`, `file`, `zeta`";
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
.or(WAYS)
.such_as("[[1e-6, 0, 0], [1e-6, 2e-7, 0], [1e-6, 0, 0]]");
const FILE: Field = Field::new(
    "file",
    Form::Text("the name of a CSV file with the columns zeta, xi, eta and optionally omega"),
    "CSV file of the steps, in plain units; its path is relative to the case file",
)
.or(WAYS)
.such_as("\"steps.csv\"");
const ZETA: Field = Field::number(
    "zeta",
    LENGTH,
    "approach in one step, which each row of data replaces in `carom fit`",
)
.or(WAYS)
.such_as("0");
const XI: Field = beside("xi", LENGTH, "shift along the larger relative curvature beside `zeta`");
const ETA: Field = beside("eta", LENGTH, "the same across it");
const OMEGA: Field = beside("omega", Range::Finite.of(Dimension::Radians), "twist beside `zeta`");
const TOUCH: Field = beside(
    "touch",
    LENGTH,
    "reading of `zeta` at which the bodies first touch: the approach counts from there",
);
const HISTORY: Field = Field::new(
    "history",
    Form::Table(&[STEPS, FILE, ZETA, XI, ETA, OMEGA, TOUCH]),
    "the history of shifts",
)
.begun(&[(&STEPS, "")]);

const fn beside(name: &'static str, measure: Measure, meaning: &'static str) -> Field {
    Field::number(name, measure, meaning).default(Default::Number(0.0)).such_as("0")
}

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
    /// The reading of zeta at which the bodies first touch, m: a single step counts from there.
    pub touch: f64,
    /// The numbers that data shall determine.
    pub unknowns: Vec<Input>,
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
    )
    .varying(UNKNOWN);

    fn read(source: &str) -> Result<Self, CaseError> {
        let table = parse(source)?;
        let varied = Varied::new(FIELDS, Vec::new()).unknown();
        let case = read(source, table.get_ref(), &varied)?;
        Ok(Self { unknowns: varied.found(), ..case })
    }
}

/// Reads a case with values for its unknowns.
pub(super) fn read(
    source: &str,
    table: &DeTable<'_>,
    varied: &Varied,
) -> Result<HistoryCase, CaseError> {
    let case = &Section::root(source, table, FIELDS)?.varying(varied);
    let contact = case.section(&CONTACT)?;
    let (law, tolerance) = law(&contact)?;
    let Pair { hertz, smallest_radius } = pair::read(case, Some(&contact))?;
    let friction = static_friction(&contact, &SHIFT_STATIC_FRICTION)?;
    let history = case.section(&HISTORY)?;
    let touch = history.number(&TOUCH)?;
    let (steps, unknowns) = (steps(&history, touch)?, Vec::new());
    let case =
        HistoryCase { hertz, smallest_radius, friction, law, tolerance, steps, touch, unknowns };
    if let Steps::Inline(shifts) = &case.steps {
        let field = if history.has(&ZETA) { &OMEGA } else { &STEPS };
        let at_fault = |error: RangeError| history.out_of_range(field, error.value, error.allowed);
        case.check_twist(shifts).map_err(at_fault)?;
    }
    Ok(case)
}

fn steps(history: &Section<'_>, touch: f64) -> Result<Steps, CaseError> {
    let given = history.given([&STEPS, &FILE, &ZETA]);
    let beside = history.given([&XI, &ETA, &OMEGA, &TOUCH]);
    match (given.as_slice(), beside.as_slice()) {
        ([field], _) if field.name == ZETA.name => {
            let [zeta, xi] = [history.number(&ZETA)? - touch, history.number(&XI)?];
            let [eta, omega] = [history.number(&ETA)?, history.number(&OMEGA)?];
            Ok(Steps::Inline(vec![shift([zeta, xi, eta, omega])]))
        }
        ([field], [other, ..]) => Err(history.conflict(*other, *field, "it stands beside `zeta`")),
        ([field], []) if field.name == STEPS.name => {
            Ok(Steps::Inline(history.rows(&STEPS)?.into_iter().map(shift).collect()))
        }
        ([] | [_], _) => Ok(Steps::File(history.text(&FILE)?.into())),
        (several, _) => Err(history.several(several, "give one of them")),
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
