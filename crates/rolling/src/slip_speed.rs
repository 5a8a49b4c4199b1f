//! Friction that falls with the slip speed, cell by cell, while a contact rolls.

use carom_halfspace::{Field, Grid};
use carom_laws::friction::Friction;
use carom_laws::slip_speed::SlipSpeedFriction;
use carom_solver::{CellFriction, CellState, ContactState, Convergence, SurfaceFriction};
use carom_special::RangeError;

use crate::{RollingError, Way};

/// The friction no longer changes if it does so by less than this share of the greatest friction limit.
const CHANGE: f64 = 1e-7;
/// Solves before friction must have settled.
const PASSES: usize = 400;

/// Friction f = a + b exp(-c v) by the slip speed v of each cell of a contact that rolls at a speed.
///
/// Where friction falls fast with the slip speed, a contact has several steady states: more slip, less friction, more
/// slip. The one found is that of the greatest friction, which a contact reaches from rest: the solves begin with
/// the friction at rest, a + b, in all cells; each next one has the friction of the slip before it, which only grows. There is
/// no memory: a cell that sticks again has its friction at rest at once. That is why steps from rest are not offered: in
/// them cells would stick and slip in turn, the faster the smaller they are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingFriction {
    law: SlipSpeedFriction,
    speed: f64,
}

impl RollingFriction {
    /// A law of friction at a speed of rolling, as length over time.
    ///
    /// # Errors
    /// [`RangeError`] unless the speed is positive and finite.
    pub fn new(law: SlipSpeedFriction, speed: f64) -> Result<Self, RangeError> {
        Ok(Self { law, speed: RangeError::positive("speed", speed)? })
    }

    /// Friction at rest in all cells, before the first solve.
    pub(crate) fn at_rest(self, way: &Way, grid: Grid) -> Result<Settling, RangeError> {
        let rest: CellFriction = self.law.at(0.0)?.into();
        let speed = self.speed / way.length();
        Ok(Settling {
            law: self.law,
            speed,
            field: Field::uniform(grid, rest),
            part: if self.law.coefficients()[1] < 0.0 { 0.5 } else { 1.0 },
            change: f64::INFINITY,
            passes: 0,
            went: None,
        })
    }
}

/// The friction of the cells on its way to that of their slip.
pub(crate) struct Settling {
    law: SlipSpeedFriction,
    /// Slip speed over slip of a step.
    speed: f64,
    field: Field<CellFriction>,
    /// The share of a change that is taken over. Friction that grows with speed would go up and down: it takes half, and half
    /// of that where the changes do not fall.
    part: f64,
    change: f64,
    passes: usize,
    went: Option<Convergence>,
}

impl Settling {
    pub(crate) fn friction(&self) -> SurfaceFriction {
        SurfaceFriction::ByCell(self.field.clone())
    }

    /// Takes over the friction of the slip of a solved step; the cost of all solves once that is what it was solved with.
    pub(crate) fn follow(
        &mut self,
        state: &ContactState,
        before: &ContactState,
        went: Convergence,
    ) -> Result<Option<Convergence>, RollingError> {
        self.passes += 1;
        let all = self.went.map_or(went, |all| Convergence {
            iterations: all.iterations + went.iterations,
            products: all.products.plus(went.products),
            ..went
        });
        self.went = Some(all);
        let change = self.change(state, before)?;
        if change <= CHANGE {
            return Ok(Some(all));
        }
        if self.part < 1.0 && change >= self.change {
            self.part *= 0.5;
        }
        self.change = change;
        match self.passes < PASSES {
            true => Ok(None),
            false => Err(RollingError::SlipSpeed { passes: self.passes, change }),
        }
    }

    /// Sets the friction of each cell; the greatest change, in parts of the greatest friction limit.
    fn change(&mut self, state: &ContactState, before: &ContactState) -> Result<f64, RangeError> {
        let slip = state.slip_since(before);
        let (mut change, mut limit) = (0.0_f64, f64::MIN_POSITIVE);
        for (cell, friction) in self.field.values_mut().iter_mut().enumerate() {
            let slips = state.cells.values()[cell] == CellState::Slip;
            let [x, y] = [&slip[0], &slip[1]].map(|slip| slip.values()[cell]);
            let speed = if slips { self.speed * libm::hypot(x, y) } else { 0.0 };
            let (old, new) = (friction.motion().get(), self.law.at(speed)?.get());
            let pressure = state.pressure.values()[cell];
            change = change.max((new - old).abs() * pressure);
            limit = limit.max(new * pressure);
            let next = old + self.part * (new - old);
            *friction = Friction::new(next)?.into();
        }
        Ok(change / limit)
    }
}
