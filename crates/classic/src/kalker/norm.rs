//! NORM, fig. 11.2: the contact area at given tangential tractions.

use std::fmt;

use super::sets::Sets;
use crate::chart::{Block, Machine};
use crate::direct::DirectError;

/// The steps and questions of [`NORM`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NormStep {
    /// Solves for the pressures that close the gap in the contact area.
    Solve,
    /// Removes elements in tension from the contact area.
    DropTension,
    /// Whether none was removed.
    NoTension,
    /// Computes the distances of the deformed surfaces.
    Distance,
    /// Adds elements that overlap to the contact area.
    AddOverlap,
    /// Whether none was added.
    NoOverlap,
}

impl fmt::Display for NormStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Solve => "solve dᵢ = 0 in K for the pressures pᵢ",
            Self::DropTension => "pᵢ < 0: take i out of K",
            Self::NoTension => "none had pᵢ < 0",
            Self::Distance => "deformed distances dᵢ outside K",
            Self::AddOverlap => "dᵢ < 0: take i into K",
            Self::NoOverlap => "none had dᵢ < 0",
        })
    }
}

/// The chart of NORM: the contact area K first shrinks until no element is in tension, then grows.
pub const NORM: &[Block<NormStep>] = &[Block::Until {
    body: &[
        Block::Until {
            body: &[Block::Do(NormStep::Solve), Block::Do(NormStep::DropTension)],
            done: NormStep::NoTension,
        },
        Block::Do(NormStep::Distance),
        Block::Do(NormStep::AddOverlap),
    ],
    done: NormStep::NoOverlap,
}];

/// The NORM process during one step.
pub(super) struct Norm<'a, 'b> {
    pub(super) sets: &'b mut Sets<'a>,
    pub(super) rounds: usize,
    /// Number of cells that the last step moved.
    pub(super) moved: f64,
}

impl Machine for Norm<'_, '_> {
    type Step = NormStep;
    type Error = DirectError;

    fn perform(&mut self, step: NormStep) -> Result<f64, DirectError> {
        let done = match step {
            NormStep::Solve => {
                self.sets.displace();
                let unknowns: Vec<_> =
                    self.sets.outcome.touching().map(|cell| self.sets.pressure(cell)).collect();
                self.sets.solve(&unknowns)?;
                return Ok(unknowns.len() as f64);
            }
            NormStep::DropTension => self.sets.drop_tension(),
            NormStep::Distance => {
                self.sets.displace();
                return Ok(0.0);
            }
            NormStep::AddOverlap => self.sets.add_overlap(),
            NormStep::NoTension | NormStep::NoOverlap => 0.0,
        };
        self.moved = done;
        Ok(done)
    }

    fn is_done(&mut self, _: NormStep, round: usize) -> Result<bool, DirectError> {
        Ok(self.moved == 0.0 || round >= self.rounds)
    }
}
