//! What can be measured of an impact, beside the columns of its outcome.

use crate::FitError;
use carom_cases::case::Dimension;
use carom_impact::{Collision, HistoryPoint, Motion, Outcome, TabledCollision, TabledRebound};
use carom_table::{Column, Quantity as _, Value};
use nalgebra::Vector3;

/// The motions of an impact before and after it.
#[derive(Debug, Clone, Copy)]
pub struct Bounce {
    before: [Motion; 2],
    after: [Motion; 2],
    /// Velocity of body 2 against body 1 at the contact, in contact axes.
    contact: [Vector3<f64>; 2],
    /// From body 2 into body 1.
    normal: Vector3<f64>,
    r_x: Option<f64>,
}

impl Bounce {
    pub(crate) fn tabled(collision: &TabledCollision, rebound: &TabledRebound) -> Self {
        Self {
            before: collision.motions(),
            after: rebound.motions,
            contact: [collision.contact_velocity(), rebound.contact_velocity],
            normal: collision.collision().frame().z(),
            r_x: Some(rebound.r_x),
        }
    }

    /// None without an impact.
    pub(crate) fn of(collision: &Collision, outcome: &Outcome) -> Option<Self> {
        let rebound = outcome.rebound()?;
        Some(Self {
            before: collision.bodies().each_ref().map(|body| body.motion()),
            after: rebound.motions,
            contact: [
                collision.frame().to_contact(&rebound.contact_velocity_before),
                collision.frame().to_contact(&rebound.contact_velocity_after),
            ],
            normal: collision.frame().z(),
            r_x: rebound.r_x,
        })
    }

    /// The quantities of a bounce that data may give.
    pub const COLUMNS: &'static [Column<Self>] = &[
        Column::new("R_x", "", "tangential restitution", |bounce| {
            bounce.r_x.map_or(Value::Undefined, Value::Number)
        }),
        Column::new("normal_restitution", "", "normal velocity after over that before", |bounce| {
            (-bounce.contact[1].z / bounce.contact[0].z).into()
        }),
        Column::new(
            "body_1_tangential_ratio",
            "",
            "tangential velocity of the centre after over that before",
            |bounce| {
                let [before, after] = bounce.across(0);
                if before == 0.0 { Value::Undefined } else { (after / before).into() }
            },
        ),
        Column::new(
            "body_1_rebound_angle",
            "deg",
            "of the velocity of the centre from the normal, on the side to which it came",
            |bounce| {
                let [_, after] = bounce.across(0);
                let up = bounce.after[0].velocity.dot(&bounce.normal);
                libm::atan2(after, up).to_degrees().into()
            },
        ),
        Column::new(
            "contact_rebound_angle",
            "deg",
            "of the velocity of the contact point from the normal, on the side to which it slipped",
            |bounce| {
                let after = bounce.slip_after();
                libm::atan2(after, -bounce.contact[1].z).to_degrees().into()
            },
        ),
        Column::new(
            "slip_after",
            "m/s",
            "tangential velocity at the contact along that before",
            |bounce| bounce.slip_after().into(),
        ),
        Column::vector("body_1_velocity", "m/s", "of the centre of mass, afterwards", |bounce| {
            <[f64; 3]>::from(bounce.after[0].velocity).into()
        }),
        Column::vector("body_1_spin", "rad/s", "angular velocity, afterwards", |bounce| {
            <[f64; 3]>::from(bounce.after[0].spin).into()
        }),
        Column::vector("body_2_velocity", "m/s", "of the centre of mass, afterwards", |bounce| {
            <[f64; 3]>::from(bounce.after[1].velocity).into()
        }),
        Column::vector("body_2_spin", "rad/s", "angular velocity, afterwards", |bounce| {
            <[f64; 3]>::from(bounce.after[1].spin).into()
        }),
    ];

    /// The tangential velocity of a centre before and after, along that before.
    fn across(&self, body: usize) -> [f64; 2] {
        let part =
            |motion: &Motion| motion.velocity - self.normal * motion.velocity.dot(&self.normal);
        let before = part(&self.before[body]);
        let size = before.norm();
        match size {
            0.0 => [0.0, part(&self.after[body]).norm()],
            size => [size, part(&self.after[body]).dot(&before) / size],
        }
    }

    fn slip_after(&self) -> f64 {
        let [before, after] = self.contact.map(|velocity| velocity.xy());
        match before.norm() {
            0.0 => after.norm(),
            size => after.dot(&before) / size,
        }
    }
}

/// A number of a record, by a column and a component.
#[derive(Debug)]
pub(crate) struct Part<R: 'static> {
    column: &'static Column<R>,
    part: usize,
}

impl<R> Clone for Part<R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Part<R> {}

impl<R> Part<R> {
    /// The number of this name, if one of the columns has it.
    pub(crate) fn find(columns: &'static [Column<R>], name: &str) -> Option<Self> {
        columns.iter().find_map(|column| {
            let parts = column.parts();
            if parts.is_empty() {
                return (column.name() == name).then_some(Self { column, part: 0 });
            }
            let rest = name.strip_prefix(column.name())?.strip_prefix('_')?;
            let part = parts.iter().position(|part| *part == rest)?;
            Some(Self { column, part })
        })
    }

    pub(crate) fn unit(&self) -> &'static str {
        self.column.unit()
    }

    pub(crate) fn meaning(&self) -> &'static str {
        self.column.meaning()
    }

    /// The number; none if the record does not have it.
    pub(crate) fn of(&self, record: &R) -> Option<f64> {
        match self.column.value(record) {
            Value::Number(number) => Some(number),
            Value::Count(count) => Some(count as f64),
            Value::Vector(parts) => Some(parts[self.part]),
            _ => None,
        }
    }
}

/// A measured quantity of an impact.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Observable {
    /// Of the motions.
    Bounce(Part<Bounce>),
    /// Of the whole outcome.
    Outcome(Part<Outcome>),
    /// Of an instant.
    Instant(Part<HistoryPoint>),
}

impl Observable {
    pub(crate) fn find(name: &str) -> Option<Self> {
        let of_motions = Part::find(Bounce::COLUMNS, name).map(Self::Bounce);
        let of_outcome = || Part::find(Outcome::COLUMNS, name).map(Self::Outcome);
        // The time is an input.
        let of_instant = || {
            Part::find(HistoryPoint::COLUMNS, name).filter(|_| name != "time").map(Self::Instant)
        };
        of_motions.or_else(of_outcome).or_else(of_instant)
    }

    /// The names of all of them.
    pub(crate) fn names() -> Vec<String> {
        let [mut all, others] =
            [carom_table::heads(Bounce::COLUMNS), carom_table::heads(Outcome::COLUMNS)];
        all.extend(others.into_iter().filter(|name| Part::find(Bounce::COLUMNS, name).is_none()));
        let of_instants = carom_table::heads(HistoryPoint::COLUMNS);
        all.extend(of_instants.into_iter().filter(|name| name != "time"));
        all
    }

    /// Whether it is of an instant.
    pub(crate) fn is_of_instant(&self) -> bool {
        matches!(self, Self::Instant(_))
    }

    /// The number of these records; NaN if they do not have it.
    pub(crate) fn of(
        &self,
        bounce: Option<&Bounce>,
        outcome: Option<&Outcome>,
        instant: Option<&HistoryPoint>,
    ) -> f64 {
        let found = match self {
            Self::Bounce(part) => bounce.and_then(|record| part.of(record)),
            Self::Outcome(part) => outcome.and_then(|record| part.of(record)),
            Self::Instant(part) => instant.and_then(|record| part.of(record)),
        };
        found.unwrap_or(f64::NAN)
    }

    pub(crate) fn unit(&self) -> &'static str {
        match self {
            Self::Bounce(part) => part.unit(),
            Self::Outcome(part) => part.unit(),
            Self::Instant(part) => part.unit(),
        }
    }

    pub(crate) fn meaning(&self) -> &'static str {
        match self {
            Self::Bounce(part) => part.meaning(),
            Self::Outcome(part) => part.meaning(),
            Self::Instant(part) => part.meaning(),
        }
    }
}

/// A number in the unit of a quantity.
///
/// # Errors
/// If the unit is not one of that quantity.
pub(crate) fn converted(
    values: &[f64],
    [given, own]: [&str; 2],
    column: &str,
) -> Result<Vec<f64>, FitError> {
    const ALL: [Dimension; 9] = [
        Dimension::Length,
        Dimension::Speed,
        Dimension::Spin,
        Dimension::Force,
        Dimension::Pressure,
        Dimension::Time,
        Dimension::Degrees,
        Dimension::Radians,
        Dimension::Mass,
    ];
    if given.is_empty() || given == own {
        return Ok(values.to_vec());
    }
    let dimension = ALL.into_iter().find(|dimension| dimension.unit() == own);
    in_dimension(values, given, dimension.unwrap_or(Dimension::None), column)
}

/// A number in the base unit of a dimension.
///
/// # Errors
/// If the unit is not one of it.
pub(crate) fn in_dimension(
    values: &[f64],
    given: &str,
    dimension: Dimension,
    column: &str,
) -> Result<Vec<f64>, FitError> {
    if given.is_empty() || given == dimension.unit() {
        return Ok(values.to_vec());
    }
    let read = |value: &f64| match value.is_nan() {
        true => Some(f64::NAN),
        false => dimension.read(&format!("{value} {given}")),
    };
    let read: Option<Vec<f64>> = values.iter().map(read).collect();
    read.ok_or_else(|| {
        let reason = match dimension.unit() {
            "" => format!("its unit `{given}` is none of a pure number"),
            unit => format!("its unit `{given}` is none of it; it is in {unit}"),
        };
        FitError::column(column, reason)
    })
}
