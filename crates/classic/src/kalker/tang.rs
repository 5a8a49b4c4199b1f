//! TANG, fig. 11.3: the areas of stick and slip at given pressures.

use std::fmt;

use super::sets::Sets;
use crate::chart::{Block, Machine};
use crate::direct::DirectError;
use crate::direct::dense::Unknown;

/// The steps and questions of [`TANG`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TangStep {
    /// Solves for the tractions: no slip in the stick area, the linearised friction law in the slip
    /// area.
    Solve,
    /// Whether the directions of slip have converged.
    DirectionsStand,
    /// Removes elements with too large a traction from the stick area.
    LetSlip,
    /// Decides by whether an element was removed.
    NoneTooLarge,
    /// Adds elements that slip in the direction of their traction to the stick area.
    LetStick,
    /// Decides by whether an element was added.
    NoneAlong,
}

impl fmt::Display for TangStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Solve => "solve: sᵢ = 0 in A; linearised law of friction in the slip area",
            Self::DirectionsStand => "the directions of slip stand",
            Self::LetSlip => "|σₜᵢ| > f σₙᵢ: take i out of A",
            Self::NoneTooLarge => "none had |σₜᵢ| > f σₙᵢ",
            Self::LetStick => "sᵢ along σₜᵢ: take i into A",
            Self::NoneAlong => "no sᵢ was along σₜᵢ",
        })
    }
}

/// The chart of TANG: like NORM with the stick area A for K, and with a third loop for the
/// nonlinear equations.
pub const TANG: &[Block<TangStep>] = &[Block::Until {
    body: &[
        Block::Until {
            body: &[
                Block::Until {
                    body: &[Block::Do(TangStep::Solve)],
                    done: TangStep::DirectionsStand,
                },
                Block::Do(TangStep::LetSlip),
            ],
            done: TangStep::NoneTooLarge,
        },
        Block::Do(TangStep::LetStick),
    ],
    done: TangStep::NoneAlong,
}];

/// The TANG process during one step.
pub(super) struct Tang<'a, 'b> {
    pub(super) sets: &'b mut Sets<'a>,
    pub(super) rounds: usize,
    pub(super) tolerance: f64,
    /// Number of cells that the last step moved, or the largest rotation of a direction.
    pub(super) moved: f64,
}

impl Tang<'_, '_> {
    /// One Newton step on the present sets; returns the largest rotation of a direction.
    fn solve(&mut self) -> Result<f64, DirectError> {
        let limits = self.sets.limits();
        let mut unknowns: Vec<Unknown> = Vec::with_capacity(2 * limits.len());
        let mut slipping = Vec::new();
        for &(cell, limit) in limits.iter().filter(|(_, limit)| *limit > 0.0) {
            if self.sets.slips(cell) {
                slipping.push((unknowns.len(), cell, limit));
                unknowns.push(self.sets.turn(cell, limit));
            } else {
                unknowns.extend(self.sets.stick(cell));
            }
        }
        let amounts = self.sets.solve(&unknowns)?;
        let mut turned = 0.0_f64;
        for (unknown, cell, limit) in slipping {
            turned = turned.max((amounts[unknown] / limit).abs());
            let direction = self.sets.outcome.direction(cell);
            self.sets.outcome.pull(cell, limit, direction);
        }
        self.sets.displace();
        Ok(turned)
    }
}

impl Machine for Tang<'_, '_> {
    type Step = TangStep;
    type Error = DirectError;

    fn perform(&mut self, step: TangStep) -> Result<f64, DirectError> {
        self.moved = match step {
            TangStep::Solve => self.solve()?,
            TangStep::LetSlip => self.sets.let_slip(),
            TangStep::LetStick => self.sets.let_stick(),
            TangStep::DirectionsStand | TangStep::NoneTooLarge | TangStep::NoneAlong => 0.0,
        };
        // Tractions reduced to the limit change the displacements.
        if step == TangStep::LetSlip && self.moved > 0.0 {
            self.sets.displace();
        }
        Ok(self.moved)
    }

    fn is_done(&mut self, question: TangStep, round: usize) -> Result<bool, DirectError> {
        let enough = if question == TangStep::DirectionsStand { self.tolerance } else { 0.0 };
        Ok(self.moved <= enough || round >= self.rounds)
    }
}
