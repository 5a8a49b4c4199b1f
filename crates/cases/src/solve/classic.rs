//! The method of a case: that of today, or those of 1992 and before.

use crate::case::SolveMethod;
use carom_classic::DirectError;
use carom_classic::jaeger::{DiscGaussSeidel, GaussSeidel};
use carom_classic::kalker::{Johnson, Kombi, Panagiotopoulos};
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Frictional, FrictionalError,
    FrictionalScratch, Method, Observer,
};
use std::sync::Arc;

/// A method with its working memory.
struct At<M: Method> {
    method: M,
    scratch: M::Scratch,
}

/// One of the older methods with what it needs.
trait Classic: Send + Sync {
    /// A step with memory as it was made, so that a resumed run gives the same bits.
    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
    ) -> Result<Convergence, DirectError>;
}

impl<M> Classic for At<M>
where
    M: Method<Error = DirectError> + Send + Sync + 'static,
    M::Scratch: Clone + Send + Sync,
{
    fn step(
        &self,
        problem: &ContactProblem,
        from: &ContactState,
        drive: &Drive,
        to: &mut ContactState,
    ) -> Result<Convergence, DirectError> {
        self.method.step(problem, from, drive, to, &mut self.scratch.clone(), &mut ())
    }
}

/// The method with its memory; none if it is that of today.
fn classic(
    method: SolveMethod,
    tolerance: Option<f64>,
    problem: &ContactProblem,
) -> Result<Option<Arc<dyn Classic>>, DirectError> {
    macro_rules! made {
        ($method:expr) => {{
            let method = match tolerance {
                Some(tolerance) => $method.within(tolerance)?,
                None => $method,
            };
            Arc::new(At { scratch: method.scratch(problem)?, method })
        }};
    }
    Ok(Some(match method {
        SolveMethod::Newton => return Ok(None),
        SolveMethod::GaussSeidel => made!(GaussSeidel::default()),
        SolveMethod::Discs => made!(DiscGaussSeidel::default()),
        SolveMethod::Johnson => made!(Johnson::default()),
        SolveMethod::Panagiotopoulos => made!(Panagiotopoulos::default()),
        SolveMethod::Kombi => made!(Kombi::default()),
    }))
}

/// The method that a case asks for.
#[derive(Debug, Clone, Copy)]
pub struct Chosen {
    /// That of today.
    pub(super) today: Frictional,
    pub(super) method: SolveMethod,
    pub(super) tolerance: Option<f64>,
}

/// Why it failed.
#[derive(Debug, thiserror::Error)]
pub enum ChosenError {
    /// The method of today.
    #[error(transparent)]
    Today(#[from] FrictionalError),
    /// An older one.
    #[error(transparent)]
    Classic(#[from] DirectError),
}

/// Its memory.
#[derive(Clone)]
#[allow(missing_debug_implementations)] // memory of any method
pub struct Working(Kind);

#[derive(Clone)]
enum Kind {
    Today(Box<FrictionalScratch>),
    Classic(Arc<dyn Classic>),
}

impl Method for Chosen {
    type Error = ChosenError;
    type Scratch = Working;

    fn scratch(&self, problem: &ContactProblem) -> Result<Working, ChosenError> {
        Ok(Working(match classic(self.method, self.tolerance, problem)? {
            Some(classic) => Kind::Classic(classic),
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
