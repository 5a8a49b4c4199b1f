//! The charts of the processes: their steps and questions.

use std::fmt;

use crate::chart::Block;

/// The steps and questions of [`JOHNSON`] and [`PANAGIOTOPOULOS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProcessStep {
    /// The normal problem at the last tangential tractions.
    Norm,
    /// The tangential problem at these pressures.
    Tang,
    /// Whether the pressures still close the gap.
    PressuresStand,
}

impl fmt::Display for ProcessStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Norm => "NORM",
            Self::Tang => "TANG",
            Self::PressuresStand => "the pressures stand",
        })
    }
}

/// The chart of Johnson's process.
pub const JOHNSON: &[Block<ProcessStep>] =
    &[Block::Do(ProcessStep::Norm), Block::Do(ProcessStep::Tang)];

/// The chart of Panagiotopoulos's process.
pub const PANAGIOTOPOULOS: &[Block<ProcessStep>] =
    &[Block::Until { body: JOHNSON, done: ProcessStep::PressuresStand }];

/// The steps and questions of [`KOMBI`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum KombiStep {
    /// Solves for pressures and tractions together.
    Solve,
    /// Whether the directions of slip have converged.
    DirectionsStand,
    /// Removes elements in tension from the contact area, and those with too large a traction from
    /// the stick area.
    Shrink,
    /// Whether none was removed.
    NoneToShrink,
    /// Adds elements that overlap to the contact area, and those that slip in the direction of
    /// their traction to the stick area.
    Grow,
    /// Whether none was added.
    NoneToGrow,
}

impl fmt::Display for KombiStep {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Solve => "solve for pressures and tractions together",
            Self::DirectionsStand => "the directions of slip stand",
            Self::Shrink => "take pᵢ < 0 out of K, |σₜᵢ| > f σₙᵢ out of A",
            Self::NoneToShrink => "there was none",
            Self::Grow => "take dᵢ < 0 into K, sᵢ along σₜᵢ into A",
            Self::NoneToGrow => "there was none",
        })
    }
}

/// The chart of KOMBI.
pub const KOMBI: &[Block<KombiStep>] = &[Block::Until {
    body: &[
        Block::Until {
            body: &[
                Block::Until {
                    body: &[Block::Do(KombiStep::Solve)],
                    done: KombiStep::DirectionsStand,
                },
                Block::Do(KombiStep::Shrink),
            ],
            done: KombiStep::NoneToShrink,
        },
        Block::Do(KombiStep::Grow),
    ],
    done: KombiStep::NoneToGrow,
}];
