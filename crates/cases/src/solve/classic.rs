//! The solution method of a case: the main one, the one without friction for a plate, or an older one of the
//! crate `classic`.

use crate::case::SolveMethod;
use carom_classic::DirectError;
use carom_classic::jaeger::{DiscGaussSeidel, GaussSeidel};
use carom_classic::kalker::{Johnson, Kombi, Panagiotopoulos};
use carom_solver::{
    ContactProblem, ContactState, Convergence, Drive, Frictional, FrictionalError,
    FrictionalScratch, Frictionless, Method, NormalError, NormalScratch, Observer,
};
use std::sync::Arc;

/// A method with its working memory.
struct At<M: Method> {
    method: M,
    scratch: M::Scratch,
}

/// An older method with its options.
trait Classic: Send + Sync {
    /// One step with fresh working memory, so that a resumed run gives the same bits.
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

/// The older method that a case requests; none for the main method.
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

/// The method that a case requests.
#[derive(Debug, Clone, Copy)]
pub struct Chosen {
    /// The main method.
    pub(super) main: Frictional,
    /// The method for a plate, which has no friction; none for half-spaces.
    pub(super) plate: Option<Frictionless>,
    pub(super) method: SolveMethod,
    pub(super) tolerance: Option<f64>,
}

impl Chosen {
    /// The main method, or the one of a plate.
    #[must_use]
    pub fn main(main: Frictional, plate: Option<Frictionless>) -> Self {
        Self { main, plate, method: SolveMethod::Newton, tolerance: None }
    }
}

/// Why a step failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ChosenError {
    /// The main method failed.
    #[error(transparent)]
    Main(#[from] FrictionalError),
    /// The method without friction failed.
    #[error(transparent)]
    Normal(#[from] NormalError),
    /// An older method failed.
    #[error(transparent)]
    Classic(#[from] DirectError),
}

/// Working memory of the method.
#[derive(Clone)]
#[allow(missing_debug_implementations)] // memory of any method
pub struct Working(Kind);

#[derive(Clone)]
enum Kind {
    Main(Box<FrictionalScratch>),
    Normal(Frictionless, Box<NormalScratch>),
    Classic(Arc<dyn Classic>),
}

impl Method for Chosen {
    type Error = ChosenError;
    type Scratch = Working;

    fn scratch(&self, problem: &ContactProblem) -> Result<Working, ChosenError> {
        if let Some(plate) = self.plate {
            return Ok(Working(Kind::Normal(plate, Box::new(plate.scratch(problem)?))));
        }
        Ok(Working(match classic(self.method, self.tolerance, problem)? {
            Some(classic) => Kind::Classic(classic),
            None => Kind::Main(Box::new(self.main.scratch(problem)?)),
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
            Kind::Main(own) => self.main.step(problem, from, drive, to, own, observer)?,
            Kind::Normal(method, own) => method.step(problem, from, drive, to, own, observer)?,
            Kind::Classic(classic) => classic.step(problem, from, drive, to)?,
        })
    }
}
