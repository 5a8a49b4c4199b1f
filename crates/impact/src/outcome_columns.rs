//! The outcome of an impact as one table of columns.

use std::marker::PhantomData;

use carom_laws::validity::Validity;
use carom_table::{Column, Value};

use crate::motion::Motion;
use crate::outcome::{Outcome, Rebound};
use crate::uncertain::Quantity;

/// The state of two bodies after a collision, or without one.
pub(crate) trait Ended {
    /// The motions afterwards, of body 1 and body 2.
    fn motions(&self) -> [Motion; 2];
    /// The rebound, if there was an impact.
    fn rebound(&self) -> Option<&Rebound>;
}

impl Ended for Outcome {
    fn motions(&self) -> [Motion; 2] {
        self.motions()
    }

    fn rebound(&self) -> Option<&Rebound> {
        self.rebound()
    }
}

impl Ended for Rebound {
    fn motions(&self) -> [Motion; 2] {
        self.motions
    }

    fn rebound(&self) -> Option<&Rebound> {
        Some(self)
    }
}

impl Outcome {
    /// The columns of an outcome. The Python record and the C struct use the same names.
    pub const COLUMNS: &'static [Column<Self>] = Columns::<Self>::COLUMNS;
}

impl Rebound {
    /// The columns of [`Outcome::COLUMNS`].
    pub const COLUMNS: &'static [Column<Self>] = Columns::<Self>::COLUMNS;
}

/// The columns of an outcome.
pub(crate) struct Columns<E>(PhantomData<E>);

impl<E: Ended + 'static> Columns<E> {
    /// Columns that exist only after an impact have no value without one.
    pub(crate) const COLUMNS: &'static [Column<E>] = &[
        Column::text("outcome", "", "rebound, or no_impact", |ended| {
            if ended.rebound().is_some() { "rebound" } else { "no_impact" }.into()
        }),
        Column::new("R_x", "", "tangential restitution", |ended| {
            of(ended, |rebound| rebound.r_x.map_or(Value::Undefined, Value::Number))
        }),
        Column::vector("body_1_velocity", "m/s", "of the centre of mass, afterwards", |ended| {
            <[f64; 3]>::from(ended.motions()[0].velocity).into()
        }),
        Column::vector("body_1_spin", "rad/s", "angular velocity, afterwards", |ended| {
            <[f64; 3]>::from(ended.motions()[0].spin).into()
        }),
        Column::vector("body_2_velocity", "m/s", "of the centre of mass, afterwards", |ended| {
            <[f64; 3]>::from(ended.motions()[1].velocity).into()
        }),
        Column::vector("body_2_spin", "rad/s", "angular velocity, afterwards", |ended| {
            <[f64; 3]>::from(ended.motions()[1].spin).into()
        }),
        Column::new("body_1_speed", "m/s", "of the centre of mass, afterwards", |ended| {
            quantity(ended, Quantity::Speed(0))
        }),
        Column::new(
            "body_1_angle",
            "deg",
            "rebound angle: of that velocity from the normal away from body 2",
            |ended| quantity(ended, Quantity::Angle(0)),
        ),
        Column::new("body_2_speed", "m/s", "of the centre of mass, afterwards", |ended| {
            quantity(ended, Quantity::Speed(1))
        }),
        Column::new(
            "body_2_angle",
            "deg",
            "of that velocity from the normal away from body 1",
            |ended| quantity(ended, Quantity::Angle(1)),
        ),
        Column::vector("impulse", "N s", "on body 1", |ended| {
            of(ended, |rebound| <[f64; 3]>::from(rebound.impulse))
        }),
        Column::vector("contact_velocity_before", "m/s", "of body 2 against body 1", |ended| {
            of(ended, |rebound| <[f64; 3]>::from(rebound.contact_velocity_before))
        }),
        Column::vector("contact_velocity_after", "m/s", "of body 2 against body 1", |ended| {
            of(ended, |rebound| <[f64; 3]>::from(rebound.contact_velocity_after))
        }),
        Column::new("duration", "s", "from first contact to separation", |e| of(e, |r| r.duration)),
        Column::new("maximal_force", "N", "normal", |e| of(e, |r| r.maximal_force)),
        Column::new("maximal_approach", "m", "of distant points", |ended| {
            of(ended, |rebound| rebound.maximal_approach)
        }),
        Column::new("maximal_semi_axis_a", "m", "semi-axis of the contact along x", |ended| {
            of(ended, |rebound| rebound.maximal_contact.semi_axis_a())
        }),
        Column::new("maximal_semi_axis_b", "m", "semi-axis of the contact along y", |ended| {
            of(ended, |rebound| rebound.maximal_contact.semi_axis_b())
        }),
        Column::new("peak_pressure", "Pa", "in its middle at the greatest force", |ended| {
            of(ended, |rebound| rebound.peak_pressure)
        }),
        Column::new(Validity::OVER_YIELD.name(), "", Validity::OVER_YIELD_MEANS, |ended| {
            of(ended, |rebound| Validity::OVER_YIELD.value(&rebound.validity))
        }),
        Column::new("energy_before", "J", "kinetic, without fixed bodies", |ended| {
            of(ended, |rebound| rebound.energy.before)
        }),
        Column::new("energy_after", "J", "kinetic, without fixed bodies", |ended| {
            of(ended, |rebound| rebound.energy.after)
        }),
        Column::new("energy_dissipated", "J", "by friction", |ended| {
            of(ended, |rebound| rebound.energy.dissipated)
        }),
        Column::new("energy_lost", "J", "in the material of the bodies", |ended| {
            of(ended, |rebound| rebound.energy.lost)
        }),
        Column::text(
            "regimes",
            "",
            "in order; sign: traction on body 1 along the first slip",
            |ended| {
                let name = |rebound: &Rebound| -> Vec<_> {
                    rebound.log.iter().map(|entry| entry.regime.name()).collect()
                };
                of(ended, name)
            },
        ),
        Column::new(
            "friction",
            "",
            "coefficient that was used; none if the bodies do not slip",
            |ended| of(ended, |rebound| rebound.friction.coefficient()),
        ),
        Column::text("method", "", "solution method", |e| of(e, |r| r.method.name())),
        Column::count("compressions", "", "number of compression phases", |ended| {
            of(ended, |rebound| u64::from(rebound.compressions))
        }),
        Column::new("error_estimate", "", "of the contact velocity, over that before", |ended| {
            of(ended, |rebound| rebound.error_estimate)
        }),
        Column::new("model_uncertainty", "", "of R_x, by the unknown cause of a loss", |ended| {
            of(ended, |rebound| rebound.model_uncertainty)
        }),
        Column::text("warnings", "", "limits of validity that the impact exceeds", |ended| {
            of(ended, |rebound| -> Vec<String> {
                rebound.warnings.iter().map(ToString::to_string).collect()
            })
        }),
    ];
}

/// A quantity of which studies compute statistics; absent without an impact.
fn quantity(ended: &impl Ended, quantity: Quantity) -> Value {
    let of_rebound = |rebound: &Rebound| match quantity {
        // A body at rest has no direction.
        Quantity::Angle(body) if rebound.motions[body].velocity.norm() == 0.0 => Value::Absent,
        _ => quantity.of(rebound).map_or(Value::Undefined, Value::Number),
    };
    ended.rebound().map_or(Value::Absent, of_rebound)
}

fn of<T: Into<Value>>(ended: &impl Ended, value: impl FnOnce(&Rebound) -> T) -> Value {
    ended.rebound().map_or(Value::Absent, |rebound| value(rebound).into())
}
