//! A Monte Carlo study of impacts.

use carom_laws::validity::Limit;
use carom_special::{RangeError, Readable};
#[cfg(feature = "threads")]
use rayon::prelude::*;

use super::distribution::Distribution;
use super::draw::uniform;
use super::quantity::Quantity;
use super::summary::Summary;
use crate::collision::{AnalyticOrRings, Collision, CollisionError, CollisionSolver};
use crate::outcome::{Outcome, Rebound};

/// Largest number of samples of a study.
const MOST_SAMPLES: usize = 1_000_000;

/// Why a study has no result; `E` is the error of its [`CollisionSolver`].
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum UncertainError<E = CollisionError> {
    /// A parameter of the study is out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// An impact cannot be computed for a reason other than a drawn value out of range.
    #[error("sample {sample}: {source}")]
    Collision {
        /// The sample, from 0.
        sample: usize,
        /// The reason.
        source: E,
    },
    /// No sample is left: all are out of range, or have no impact.
    #[error("none of {samples} samples makes an impact: {out_of_range} are out of range{}", first.map_or_else(String::new, |e| format!(", the first with {} = {} (must be {})", e.field, Readable(e.value), e.allowed)))]
    NothingLeft {
        /// Number of samples.
        samples: usize,
        /// Number of samples out of range.
        out_of_range: usize,
        /// The error of the first of those.
        first: Option<RangeError>,
    },
}

/// Number of samples, and seed of the random numbers.
///
/// ```
/// use carom_halfspace::Material;
/// use carom_impact::uncertain::{Distribution, Quantity, Sampling};
/// use carom_impact::{Body, Collision, Motion};
/// use carom_laws::friction::Friction;
/// let alumina = Material::from_young(380e9, 0.23)?;
/// let plane = Body::plane(Material::RIGID);
/// let ball = Body::sphere(0.0025, alumina, 2.6e-4)?
///     .moving(Motion::new([2.0, 0.0, -3.0], [0.0; 3])?);
/// let friction = Distribution::normal(0.09, 0.01)?;
/// let study = Sampling::new(1000, 1)?.run(&[friction], |values| {
///     Collision::new(ball.clone(), plane.clone(), Friction::new(values[0])?)
/// })?;
/// let restitution = study.summary(Quantity::Restitution).ok_or("spheres have one")?;
/// assert!(restitution.deviation() > 0.0);
/// assert_eq!(restitution.count(), 1000);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sampling {
    samples: usize,
    seed: u64,
}

impl Sampling {
    /// A sampling that gives the same samples for the same seed on any machine and number of threads.
    ///
    /// # Errors
    /// [`RangeError`] unless there are 2 to 1000000 samples.
    pub fn new(samples: usize, seed: u64) -> Result<Self, RangeError> {
        let holds = (2..=MOST_SAMPLES).contains(&samples);
        RangeError::check("samples", samples as f64, holds, "a whole number from 2 to 1000000")?;
        Ok(Self { samples, seed })
    }

    /// Draws the inputs, makes the collision from them with `build`, and computes it with
    /// [`AnalyticOrRings`], in parallel. For dissimilar spheres a sample by rings takes a millisecond or
    /// more; an exact one takes some microseconds.
    ///
    /// A [`RangeError`] of `build` means that the values drawn are not physically possible: the sample is
    /// counted under the field that the error names.
    ///
    /// # Errors
    /// [`UncertainError::Collision`] for any other error, of the first sample that has one;
    /// [`UncertainError::NothingLeft`] if no sample has an impact.
    pub fn run(
        &self,
        inputs: &[Distribution],
        build: impl Fn(&[f64]) -> Result<Collision, CollisionError> + Sync,
    ) -> Result<Study, UncertainError> {
        self.run_by(&AnalyticOrRings, inputs, build)
    }

    /// As [`Sampling::run`], with another solver of collisions.
    ///
    /// # Errors
    /// As [`Sampling::run`].
    pub fn run_by<S: CollisionSolver<Error: Send> + Sync>(
        &self,
        solver: &S,
        inputs: &[Distribution],
        build: impl Fn(&[f64]) -> Result<Collision, CollisionError> + Sync,
    ) -> Result<Study, UncertainError<S::Error>> {
        #[cfg(feature = "threads")]
        let samples = (0..self.samples).into_par_iter();
        #[cfg(not(feature = "threads"))]
        let samples = 0..self.samples;
        let fates: Vec<Fate<S::Error>> = samples
            .map(|sample| {
                let mut values = vec![0.0; inputs.len()];
                self.draw(inputs, sample, &mut values);
                fate(solver, build(&values))
            })
            .collect();
        Study::from_fates(fates, inputs, self)
    }

    fn draw(&self, inputs: &[Distribution], sample: usize, values: &mut [f64]) {
        for (index, (value, input)) in values.iter_mut().zip(inputs).enumerate() {
            *value = input.inverse(uniform(self.seed, sample as u64, index as u64));
        }
    }
}

/// The result of a sample.
enum Fate<E> {
    Rebound(Box<Sampled>),
    NoImpact,
    OutOfRange(RangeError),
    Failed(E),
}

/// The part of a rebound that is kept.
struct Sampled {
    numbers: [Option<f64>; Quantity::ALL.len()],
    method: &'static str,
    error_estimate: f64,
    neglects_coupling: bool,
}

impl Sampled {
    fn of(rebound: &Rebound) -> Self {
        Self {
            numbers: Quantity::ALL.map(|quantity| quantity.of(rebound)),
            method: rebound.method.name(),
            error_estimate: rebound.error_estimate,
            neglects_coupling: rebound.validity.excess(Limit::Coupling).is_some(),
        }
    }
}

fn fate<S: CollisionSolver>(
    solver: &S,
    collision: Result<Collision, CollisionError>,
) -> Fate<S::Error> {
    let followed = collision.map_err(S::Error::from).and_then(|collision| solver.solve(&collision));
    match followed {
        Ok(Outcome::Rebound(rebound)) => Fate::Rebound(Box::new(Sampled::of(&rebound))),
        Ok(Outcome::NoImpact { .. }) => Fate::NoImpact,
        Err(error) => match S::out_of_range(&error) {
            Some(error) => Fate::OutOfRange(error),
            None => Fate::Failed(error),
        },
    }
}

/// Samples with a given field out of range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutOfRange {
    /// The error of the first of them.
    pub first: RangeError,
    /// Number of samples with this field out of range.
    pub count: usize,
}

/// The results of all samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    samples: usize,
    no_impact: usize,
    out_of_range: Vec<OutOfRange>,
    methods: Vec<(&'static str, usize)>,
    error_estimate: f64,
    coupling_neglected: usize,
    inputs: Vec<Summary>,
    summaries: Vec<Option<Summary>>,
}

impl Study {
    // In the order of the samples, whichever thread computed them.
    fn from_fates<E>(
        fates: Vec<Fate<E>>,
        inputs: &[Distribution],
        sampling: &Sampling,
    ) -> Result<Self, UncertainError<E>> {
        let samples = fates.len();
        let (mut no_impact, mut out_of_range) = (0, Vec::<OutOfRange>::new());
        let (mut methods, mut error_estimate) = (Vec::<(&'static str, usize)>::new(), 0.0_f64);
        let mut coupling_neglected = 0;
        let mut columns = vec![Vec::with_capacity(samples); Quantity::ALL.len()];
        for (sample, fate) in fates.into_iter().enumerate() {
            match fate {
                Fate::Failed(source) => return Err(UncertainError::Collision { sample, source }),
                Fate::NoImpact => no_impact += 1,
                Fate::OutOfRange(first) => {
                    match out_of_range.iter_mut().find(|seen| seen.first.field == first.field) {
                        Some(seen) => seen.count += 1,
                        None => out_of_range.push(OutOfRange { first, count: 1 }),
                    }
                }
                Fate::Rebound(sampled) => {
                    columns.iter_mut().zip(sampled.numbers).for_each(|(c, n)| c.extend(n));
                    match methods.iter_mut().find(|(name, _)| *name == sampled.method) {
                        Some((_, count)) => *count += 1,
                        None => methods.push((sampled.method, 1)),
                    }
                    error_estimate = error_estimate.max(sampled.error_estimate);
                    coupling_neglected += usize::from(sampled.neglects_coupling);
                }
            }
        }
        let nothing_left = || UncertainError::NothingLeft {
            samples,
            out_of_range: out_of_range.iter().map(|seen| seen.count).sum(),
            first: out_of_range.first().map(|seen| seen.first),
        };
        let summaries: Vec<Option<Summary>> = columns.into_iter().map(Summary::new).collect();
        if summaries.iter().all(Option::is_none) {
            return Err(nothing_left());
        }
        let drawn = |index: usize| {
            let at = |sample| uniform(sampling.seed, sample as u64, index as u64);
            (0..samples).map(|sample| inputs[index].inverse(at(sample))).collect()
        };
        let drawn: Option<Vec<Summary>> =
            (0..inputs.len()).map(|index| Summary::new(drawn(index))).collect();
        let inputs = drawn.ok_or_else(nothing_left)?;
        Ok(Self {
            samples,
            no_impact,
            out_of_range,
            methods,
            error_estimate,
            coupling_neglected,
            inputs,
            summaries,
        })
    }

    /// Number of samples.
    #[must_use]
    pub const fn samples(&self) -> usize {
        self.samples
    }

    /// Number of samples without an impact.
    #[must_use]
    pub const fn no_impact(&self) -> usize {
        self.no_impact
    }

    /// Samples out of range, by field, in the order in which the fields first occur.
    #[must_use]
    pub fn out_of_range(&self) -> &[OutOfRange] {
        &self.out_of_range
    }

    /// The methods with which the samples were computed ([`crate::coupled::ImpactMethod::name`]), in the
    /// order in which they first occur, with the number of samples of each.
    #[must_use]
    pub fn methods(&self) -> &[(&'static str, usize)] {
        &self.methods
    }

    /// The largest [`Rebound::error_estimate`] of all samples.
    #[must_use]
    pub const fn error_estimate(&self) -> f64 {
        self.error_estimate
    }

    /// Number of samples in which the coupling of dissimilar materials was neglected ([`Limit::Coupling`]).
    #[must_use]
    pub const fn coupling_neglected(&self) -> usize {
        self.coupling_neglected
    }

    /// The drawn inputs of all samples, in order.
    #[must_use]
    pub fn inputs(&self) -> &[Summary] {
        &self.inputs
    }

    /// The values of a quantity of the rebounds that have it; None if no rebound has it. Samples out of range
    /// or without impact do not count.
    #[must_use]
    pub fn summary(&self, quantity: Quantity) -> Option<&Summary> {
        // Quantity::ALL holds every quantity; an index above that of the last body or axis stands for the
        // last.
        let index = Quantity::ALL.iter().position(|q| q.name() == quantity.name()).unwrap_or(0);
        self.summaries[index].as_ref()
    }
}
