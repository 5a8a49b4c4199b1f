//! The method of a case: that of today, or those of 1992 and before.

use crate::case::SolveMethod;
use carom_solver::jaeger::{DiscGaussSeidel, GaussSeidel};
use carom_solver::kalker::{Johnson, Kombi, Panagiotopoulos};
use carom_solver::{
    ContactProblem, ContactState, Convergence, DirectError, Drive, Frictional, FrictionalError,
    FrictionalScratch, Method, Observer,
};

/// A method with its working memory.
#[derive(Clone)]
struct At<M: Method> {
    method: M,
    scratch: M::Scratch,
}

/// One of the older methods.
#[derive(Clone)]
enum Classic {
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
    /// The method with its memory; none if it is that of today.
    fn of(
        method: SolveMethod,
        tolerance: Option<f64>,
        problem: &ContactProblem,
    ) -> Result<Option<Self>, DirectError> {
        macro_rules! made {
            ($variant:ident, $method:expr) => {{
                let method = match tolerance {
                    Some(tolerance) => $method.within(tolerance)?,
                    None => $method,
                };
                Self::$variant(At::new(method, problem)?)
            }};
        }
        Ok(Some(match method {
            SolveMethod::Newton => return Ok(None),
            SolveMethod::GaussSeidel => made!(GaussSeidel, GaussSeidel::default()),
            SolveMethod::Discs => made!(Discs, DiscGaussSeidel::default()),
            SolveMethod::Johnson => made!(Johnson, Johnson::default()),
            SolveMethod::Panagiotopoulos => made!(Panagiotopoulos, Panagiotopoulos::default()),
            SolveMethod::Kombi => made!(Kombi, Kombi::default()),
        }))
    }

    fn step(
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

/// The method that a case asks for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chosen {
    /// That of today.
    pub(super) today: Frictional,
    pub(super) method: SolveMethod,
    pub(super) tolerance: Option<f64>,
}

/// Why it failed.
#[derive(Debug, thiserror::Error)]
pub(super) enum ChosenError {
    #[error(transparent)]
    Today(#[from] FrictionalError),
    #[error(transparent)]
    Classic(#[from] DirectError),
}

/// Its memory.
#[derive(Clone)]
pub(super) struct Working(Kind);

#[derive(Clone)]
enum Kind {
    Today(Box<FrictionalScratch>),
    Classic(Box<Classic>),
}

impl Method for Chosen {
    type Error = ChosenError;
    type Scratch = Working;

    fn scratch(&self, problem: &ContactProblem) -> Result<Working, ChosenError> {
        Ok(Working(match Classic::of(self.method, self.tolerance, problem)? {
            Some(classic) => Kind::Classic(Box::new(classic)),
            None => Kind::Today(Box::new(self.today.scratch(problem)?)),
        }))
    }

    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
        scratch: &mut Working,
        observer: &mut dyn Observer,
    ) -> Result<Convergence, ChosenError> {
        Ok(match &mut scratch.0 {
            Kind::Today(own) => self.today.step(problem, from, drive, to, own, observer)?,
            Kind::Classic(classic) => classic.step(problem, from, drive, to)?,
        })
    }
}
