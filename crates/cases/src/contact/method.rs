//! The motions of CONTACT as one method, on one grid or on nested ones.

use super::case::Motion;
use super::falling::Falling;
use crate::solve::ChosenError;
use crate::{Error, ErrorKind};
use carom_halfspace::Field;
use carom_rolling::{RollingContact, RollingError, SteadyContact, SteadyMethod, TransientMethod};
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Frictional, FrictionalError,
    FrictionalScratch, MeshOrder, Method, Observer,
};
use carom_special::RangeError;

/// How a case is solved. Shifts of a state are those of the case alone; in rolling they are creepages.
#[derive(Debug, Clone)]
pub(super) enum Way {
    Shift(Frictional),
    Step(TransientMethod),
    /// With creepages that vary from cell to cell, if there are any.
    Steady(SteadyMethod, Option<[Field; 2]>),
}

impl Way {
    /// The way of a motion; `local` are the extra creepages of steady rolling, `falling` its friction by slip.
    pub(super) fn new(
        motion: Motion,
        local: Option<[Field; 2]>,
        falling: Option<Falling>,
    ) -> Result<Self, RangeError> {
        Ok(match motion {
            Motion::None | Motion::Shift => Self::Shift(Frictional::default()),
            Motion::Step(rolling) => Self::Step(TransientMethod::new(rolling.method(None)?)),
            Motion::Steady(rolling) => Self::Steady(rolling.method(falling)?, local),
        })
    }
}

/// Why a case could not be solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum WayError {
    #[error(transparent)]
    Shift(#[from] FrictionalError),
    #[error(transparent)]
    Rolling(#[from] RollingError),
}

impl From<WayError> for Error {
    fn from(error: WayError) -> Self {
        match error {
            WayError::Shift(source) => ErrorKind::Step(ChosenError::Main(source)).into(),
            WayError::Rolling(source) => source.into(),
        }
    }
}

/// Working memory of a way.
#[derive(Clone)]
pub(super) enum Memory {
    Shift(Box<FrictionalScratch>),
    Step(Box<RollingContact>),
    Steady(Box<SteadyContact>),
}

impl Method for Way {
    type Error = WayError;
    type Scratch = Memory;

    fn mesh_order(&self) -> MeshOrder {
        match self {
            Self::Shift(method) => method.mesh_order(),
            Self::Step(method) => method.mesh_order(),
            Self::Steady(method, _) => method.mesh_order(),
        }
    }

    fn scratch(&self, problem: &ContactProblem) -> Result<Memory, WayError> {
        Ok(match self {
            Self::Shift(method) => Memory::Shift(Box::new(method.scratch(problem)?)),
            Self::Step(method) => Memory::Step(Box::new(method.scratch(problem)?)),
            Self::Steady(method, local) => {
                let contact = method.scratch(problem)?;
                Memory::Steady(Box::new(match local.clone() {
                    Some([along, across]) => contact.with_local_creepage(along, across)?,
                    None => contact,
                }))
            }
        })
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut Memory,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, WayError> {
        Ok(match (self, scratch) {
            (Self::Shift(method), Memory::Shift(own)) => {
                method.step(problem, from, drive, to, own, observer)?
            }
            (Self::Step(method), Memory::Step(own)) => {
                method.step(problem, from, drive, to, own, observer)?
            }
            (Self::Steady(method, _), Memory::Steady(own)) => {
                method.step(problem, from, drive, to, own, observer)?
            }
            // Memory of another way: made anew.
            (_, scratch) => {
                *scratch = self.scratch(problem)?;
                return self.step(problem, from, drive, to, scratch, observer);
            }
        })
    }
}
