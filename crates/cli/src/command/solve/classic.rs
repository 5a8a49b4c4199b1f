//! The methods of 1992 and before at work on a case.

use crate::case::{SolveCase, SolveMethod};
use carom_solver::jaeger::{DiscGaussSeidel, GaussSeidel};
use carom_solver::kalker::{Johnson, Kombi, Panagiotopoulos};
use carom_solver::{ContactProblem, ContactState, Convergence, DirectError, Drive, Method};

/// A method with its working memory.
#[derive(Clone)]
pub(super) struct At<M: Method> {
    method: M,
    scratch: M::Scratch,
}

/// One of the older methods.
pub(super) enum Classic {
    /// The program of chapter 12.
    GaussSeidel(At<GaussSeidel>),
    /// Gauss and Seidel's with exact friction in each cell.
    Discs(At<DiscGaussSeidel>),
    /// Johnson's process.
    Johnson(At<Johnson>),
    /// Panagiotopoulos's process.
    Panagiotopoulos(At<Panagiotopoulos>),
    /// KOMBI.
    Kombi(At<Kombi>),
}

impl<M: Method> At<M> {
    fn new(method: M, problem: &ContactProblem) -> Result<Self, M::Error> {
        Ok(Self { scratch: method.scratch(problem)?, method })
    }

    /// With memory as it was made, so that a resumed run gives the same bits.
    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
    ) -> Result<Convergence, M::Error> {
        self.method.step(problem, from, drive, to, &mut self.scratch.clone(), &mut ())
    }
}

impl Classic {
    /// The method of a case; none if it is that of today.
    ///
    /// # Errors
    /// [`DirectError`] if the method does not apply to the problem.
    pub(super) fn of(
        case: &SolveCase,
        problem: &ContactProblem,
    ) -> Result<Option<Self>, DirectError> {
        macro_rules! made {
            ($variant:ident, $method:expr) => {{
                let method = match case.tolerance {
                    Some(tolerance) => $method.within(tolerance)?,
                    None => $method,
                };
                Self::$variant(At::new(method, problem)?)
            }};
        }
        Ok(Some(match case.method {
            SolveMethod::Newton => return Ok(None),
            SolveMethod::GaussSeidel => made!(GaussSeidel, GaussSeidel::default()),
            SolveMethod::Discs => made!(Discs, DiscGaussSeidel::default()),
            SolveMethod::Johnson => made!(Johnson, Johnson::default()),
            SolveMethod::Panagiotopoulos => made!(Panagiotopoulos, Panagiotopoulos::default()),
            SolveMethod::Kombi => made!(Kombi, Kombi::default()),
        }))
    }

    /// One step.
    ///
    /// # Errors
    /// Those of the method.
    pub(super) fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
    ) -> Result<Convergence, DirectError> {
        match self {
            Self::GaussSeidel(at) => at.step(problem, from, drive, to),
            Self::Discs(at) => at.step(problem, from, drive, to),
            Self::Johnson(at) => at.step(problem, from, drive, to),
            Self::Panagiotopoulos(at) => at.step(problem, from, drive, to),
            Self::Kombi(at) => at.step(problem, from, drive, to),
        }
    }
}
