//! The fields of `[contact]` that all impacts share: friction, law, torsion, loss.

use super::error::CaseError;
use super::field::{Default, Field, Form, Usual, Word};
use super::range::Range;
use super::section::Section;
use super::unit::Dimension;
use carom_impact::coupled::TurningLaw;
use carom_impact::{ImpactFriction, LossCause, NormalRestitution, RestitutionBySpeed, TorsionMode};
use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_laws::static_friction::StaticFriction;
use carom_numerical::CollisionLaw;

pub(super) const COULOMB: &str = TurningLaw::Coulomb.name();
const FIXED_DIRECTION: &str = TurningLaw::FixedDirection.name();
const RINGS: Word = (COULOMB, "exact return mapping at each depth of the contact");
const ONE_DIRECTION: Word =
    (FIXED_DIRECTION, "one direction of traction in a slip annulus, as in chapter 7");
/// The laws of a history of shifts, for paths that turn.
pub(super) const LAWS_OF_SHIFTS: &[Word] = &[RINGS, ONE_DIRECTION];

pub(super) const FRICTION: Field =
    Field::number("friction", Range::Friction.pure(), "coefficient of friction f; inf: no slip")
        .such_as("0.2")
        .usually(Usual::FRICTION);
pub(super) const A: Field =
    Field::number("a", Range::NonNegative.pure(), "coefficient of friction at high slip speeds")
        .such_as("0.1");
pub(super) const B: Field = Field::number(
    "b",
    Range::Finite.pure(),
    "how much friction at rest exceeds that at high slip speeds; a + b >= 0",
)
.such_as("0.2");
pub(super) const C: Field = Field::number(
    "c",
    Range::NonNegative.of(Dimension::PerSpeed),
    "how fast friction changes with the slip speed",
)
.such_as("2");
/// The table in place of the number `friction`.
pub(super) const FRICTION_BY_SPEED: Field = Field::new(
    "friction",
    Form::Table(&[A, B, C]),
    "friction by the slip speed v, f = a + b exp(-c v), instead of a number; v is the tangential speed of the contact \
     point at the first touch, and f is constant during the impact",
)
.may("`friction` is a number");
pub(super) const STATIC_FRICTION: Field = Field::number(
    "static_friction",
    Range::FiniteFriction.pure(),
    "coefficient of static friction f_s, at least `friction`: the contact sticks or slips in part up to f_s F_z, and slides \
     as a whole with `friction`; by the laws coulomb and fixed-direction, which auto then chooses",
)
.may("that of `friction`")
.such_as("0.3");
/// Static friction of a history of shifts, whose laws all have it.
pub(super) const SHIFT_STATIC_FRICTION: Field = Field::number(
    STATIC_FRICTION.name,
    Range::FiniteFriction.pure(),
    "coefficient of static friction f_s, at least `friction`: the contact sticks or slips in part up to f_s F_z, and slides \
     as a whole with `friction`; for steps without a twist",
)
.may("that of `friction`")
.such_as("0.3");
pub(super) const STIFFNESS_RATIO: Field = Field::number(
    "normal_over_tangential_stiffness",
    Range::Positive.pure(),
    "ratio kappa of the stiffness of the contact along the normal and across it, c_z/c_x, where it was measured; by the laws \
     coulomb and fixed-direction, which auto then chooses",
)
.may("that of the materials, (15.1)")
.such_as("1.2");
pub(super) const LAW: Field = Field::new(
    "law",
    Form::Word(&[
        (
            CollisionLaw::Auto.name(),
            "the cheapest law that accounts for the coupling of dissimilar materials",
        ),
        RINGS,
        ONE_DIRECTION,
        (
            CollisionLaw::Rings.name(),
            "concentric rings, with coupling and spin, for spheres and planes",
        ),
        (CollisionLaw::Numerical.name(), "the contact on a grid, with coupling"),
    ]),
    "the contact law; coulomb and fixed-direction neglect the coupling of dissimilar materials",
)
.default(Default::Word(CollisionLaw::Auto.name()));
/// The law of a scene. A ball on planes has circular contacts, so that the law of rings replaces the grid.
pub(super) const LAW_OF_SCENE: Field = Field::new(
    "law",
    Form::Word(&[
        (
            CollisionLaw::Auto.name(),
            "the cheapest law that accounts for the coupling of dissimilar materials",
        ),
        (COULOMB, "the exact impact, which neglects the coupling of dissimilar materials"),
        (CollisionLaw::Rings.name(), "concentric rings, with coupling and spin"),
    ]),
    "the contact law of all bounces",
)
.default(Default::Word(CollisionLaw::Auto.name()));
pub(super) const TORSION: Field =
    Field::new("torsion", Form::Switch, "whether friction acts on the spin about the normal")
        .may("where that matters: for spheres and planes with the laws auto and rings")
        .such_as("true");
pub(super) const NORMAL_RESTITUTION: Field = Field::number(
    "normal_restitution",
    Range::Part.pure(),
    "normal velocity after the impact over that before, where normal and tangential motion are uncoupled; below 1 the \
     material dissipates energy",
)
.default(Default::Number(1.0));
const SPEED: Field = Field::new(
    "speed",
    Form::List(Range::NonNegativeSpeed.of(Dimension::Speed)),
    "speeds of approach along the normal, growing; two or more",
)
.such_as("[0.1, 1, 10]");
const RESTITUTION: Field = Field::new(
    "restitution",
    Form::List(Range::Part.pure()),
    "the normal restitution at each of them; straight between them, and constant before the first and after the last",
)
.such_as("[0.95, 0.9, 0.7]");
/// The table in place of the number `normal_restitution`.
pub(super) const RESTITUTION_BY_SPEED: Field = Field::new(
    NORMAL_RESTITUTION.name,
    Form::Table(&[SPEED, RESTITUTION]),
    "normal restitution by the speed at which the bodies meet along the normal, instead of a number",
)
.may("`normal_restitution` is a number");
const fn word(loss: LossCause) -> (&'static str, &'static str) {
    (loss.name(), loss.meaning())
}

pub(super) const LOSS: Field = Field::new(
    "loss",
    Form::Word(&[
        word(LossCause::Viscous),
        word(LossCause::Maxwell),
        word(LossCause::StandardSolid),
        word(LossCause::ConstantLossTangent),
        word(LossCause::Yield),
    ]),
    "the cause of a loss by `normal_restitution` e",
)
.default(Default::Word(LossCause::Viscous.name()));
/// Of the many impacts of a scene, in which bodies may spin about the normal.
pub(super) const LOSS_OF_WALL: Field = Field::new(
    "loss",
    Form::Word(&[word(LossCause::Viscous), word(LossCause::Yield)]),
    "the cause of a loss by `normal_restitution` e",
)
.default(Default::Word(LossCause::Viscous.name()));
pub(super) const WAVE_LOSS: Field = Field::new(
    "wave_loss",
    Form::Switch,
    "whether the energy that elastic waves carry away is lost",
)
.default(Default::False);

pub(super) const RELAXATION: Field = Field::number(
    "relaxation",
    Range::NonNegative.of(Dimension::Time),
    "relaxation time of a viscous material, of both bodies together: the normal restitution then falls as the speed grows",
)
.default(Default::Number(0.0));

/// Reads the coefficient of normal restitution of an impact or a wall.
pub(super) fn normal_restitution(section: &Section<'_>) -> Result<NormalRestitution, CaseError> {
    if section.has(&RELAXATION) {
        for other in [&NORMAL_RESTITUTION, &WAVE_LOSS, &LOSS] {
            if section.has(other) {
                let reason = "the relaxation of the materials determines the loss";
                return Err(section.conflict(other, &RELAXATION, reason));
            }
        }
        let relaxation = section.number(&RELAXATION)?;
        return NormalRestitution::viscoelastic(relaxation).map_err(|error| section.refused(error));
    }
    if !section.switch(&WAVE_LOSS)? {
        if section.has(&LOSS) && !section.has(&NORMAL_RESTITUTION) {
            return Err(section.missing(&NORMAL_RESTITUTION));
        }
        let cause = section.word(&LOSS)?.parse().unwrap_or_default();
        if section.means(&RESTITUTION_BY_SPEED) {
            let table = section.section(&RESTITUTION_BY_SPEED)?;
            let by_speed =
                RestitutionBySpeed::new(&table.list(&SPEED)?, &table.list(&RESTITUTION)?)
                    .map_err(|error| table.refused(error))?;
            return NormalRestitution::by_speed(cause, by_speed)
                .map_err(|error| section.refused(error));
        }
        return NormalRestitution::by(cause, section.number(&NORMAL_RESTITUTION)?)
            .map_err(|error| section.refused(error));
    }
    for other in [&NORMAL_RESTITUTION, &LOSS] {
        if section.has(other) {
            let reason = "the loss by waves determines it";
            return Err(section.conflict(other, &WAVE_LOSS, reason));
        }
    }
    Ok(NormalRestitution::by_waves())
}

/// Reads the friction of an impact or a wall: a number, two with static friction, or a table for friction by the slip
/// speed.
pub(super) fn impact_friction(section: &Section<'_>) -> Result<ImpactFriction, CaseError> {
    if section.means(&FRICTION_BY_SPEED) {
        if section.has(&STATIC_FRICTION) {
            let reason = "friction by the slip speed has one coefficient at rest, a + b";
            return Err(section.conflict(&STATIC_FRICTION, &FRICTION_BY_SPEED, reason));
        }
        return friction_by_speed(section, &FRICTION_BY_SPEED).map(ImpactFriction::from);
    }
    let friction = static_friction(section, &STATIC_FRICTION)?;
    let is_one = !section.has(&STATIC_FRICTION);
    Ok(if is_one { friction.kinetic().into() } else { friction.into() })
}

/// Reads the table of friction by the slip speed.
pub(super) fn friction_by_speed(
    section: &Section<'_>,
    field: &'static Field,
) -> Result<SlipSpeedFriction, CaseError> {
    let table = section.section(field)?;
    let [a, b, c] = [table.number(&A)?, table.number(&B)?, table.number(&C)?];
    SlipSpeedFriction::new(a, b, c).map_err(|error| table.refused(error))
}

/// Reads a coefficient of friction, and that of static friction beside it, which is the same without its field.
pub(super) fn static_friction(
    section: &Section<'_>,
    threshold: &'static Field,
) -> Result<StaticFriction, CaseError> {
    let coefficient = |field: &'static Field| {
        Friction::new(section.number(field)?).map_err(|error| section.refused(error))
    };
    let kinetic = coefficient(&FRICTION)?;
    let own = if section.has(threshold) { coefficient(threshold)? } else { kinetic };
    StaticFriction::new(own, kinetic).map_err(|error| {
        let allowed = format!("{}, {}", error.allowed, section.stated(&FRICTION));
        section.out_of_range(threshold, error.value, &allowed)
    })
}

/// Rejects laws and torsion that have one coefficient of friction.
fn check_static_friction(
    contact: &Section<'_>,
    law: CollisionLaw,
    torsion: TorsionMode,
) -> Result<(), CaseError> {
    if matches!(law, CollisionLaw::Rings | CollisionLaw::Numerical) {
        let reason = "this law has one coefficient of friction";
        return Err(contact.conflict(&STATIC_FRICTION, &LAW, reason));
    }
    if torsion == TorsionMode::Included {
        let reason = "torsion has one coefficient of friction";
        return Err(contact.conflict(&STATIC_FRICTION, &TORSION, reason));
    }
    Ok(())
}

/// Whether friction acts on the spin about the normal.
pub(super) fn torsion_mode(section: &Section<'_>) -> Result<TorsionMode, CaseError> {
    let told = section.has(&TORSION).then(|| section.switch(&TORSION)).transpose()?;
    Ok(told.into())
}

/// The law with a given name, which the reader has checked.
pub(super) fn turning_law(word: &str) -> TurningLaw {
    word.parse().unwrap_or_default()
}

/// Friction, law and torsion of an impact.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// The friction, constant or by the slip speed.
    pub friction: ImpactFriction,
    /// The contact law.
    pub law: CollisionLaw,
    /// Whether friction acts on the spin about the normal.
    pub torsion: TorsionMode,
    /// The line of `torsion`, or 0 if it is not there.
    pub torsion_line: usize,
    /// The loss in the material.
    pub normal_restitution: NormalRestitution,
    /// Normal over tangential stiffness, if it is not that of the materials.
    pub stiffness_ratio: Option<f64>,
}

impl Contact {
    /// Reads the fields.
    pub(super) fn read(contact: &Section<'_>) -> Result<Self, CaseError> {
        let friction = impact_friction(contact)?;
        let word = contact.word(&LAW)?;
        let law: CollisionLaw = word.parse().unwrap_or_default();
        let is_numerical = law == CollisionLaw::Numerical;
        let (torsion, torsion_line) = (torsion_mode(contact)?, contact.line(&TORSION));
        if is_numerical && torsion == TorsionMode::Included {
            let reason = "the numerical law does not apply friction to the spin about the normal";
            return Err(contact.conflict(&TORSION, &LAW, reason));
        }
        if is_numerical && friction.is_infinite() {
            let allowed = "finite with law = \"numerical\"";
            return Err(contact.out_of_range(&FRICTION, f64::INFINITY, allowed));
        }
        if friction.static_friction().is_some() {
            check_static_friction(contact, law, torsion)?;
        }
        let normal_restitution = normal_restitution(contact)?;
        let stiffness_ratio = contact.maybe(&STIFFNESS_RATIO)?;
        if stiffness_ratio.is_some() && matches!(law, CollisionLaw::Rings | CollisionLaw::Numerical)
        {
            let reason = "this law has the stiffness of the materials";
            return Err(contact.conflict(&STIFFNESS_RATIO, &LAW, reason));
        }
        Ok(Self { friction, law, torsion, torsion_line, normal_restitution, stiffness_ratio })
    }
}
