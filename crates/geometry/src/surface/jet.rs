//! Functions of position with their first and second derivatives.

use nalgebra::{Matrix3, Vector3};
use std::fmt;
use std::sync::Arc;

/// Value, gradient and Hessian of f(a, b, c).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Jet {
    /// f.
    pub(super) value: f64,
    /// Its first derivatives.
    pub(super) gradient: Vector3<f64>,
    /// Its second derivatives.
    pub(super) hessian: Matrix3<f64>,
}

/// An explicit surface c(a, b): value and derivatives, the five numbers of (8.14)-(8.16).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Height {
    /// c.
    pub c: f64,
    /// dc/da.
    pub c_a: f64,
    /// dc/db.
    pub c_b: f64,
    /// The second derivative with respect to a.
    pub c_aa: f64,
    /// The second derivative with respect to b.
    pub c_bb: f64,
    /// The mixed second derivative.
    pub c_ab: f64,
}

impl Height {
    /// As a function of three coordinates that does not depend on c.
    pub(super) fn jet(&self) -> Jet {
        let Self { c, c_a, c_b, c_aa, c_bb, c_ab } = *self;
        Jet {
            value: c,
            gradient: Vector3::new(c_a, c_b, 0.0),
            hessian: Matrix3::new(c_aa, c_ab, 0.0, c_ab, c_bb, 0.0, 0.0, 0.0, 0.0),
        }
    }
}

type Shared<J> = Arc<dyn Fn(&Vector3<f64>) -> J + Send + Sync>;

/// A function of position owned by a surface.
#[derive(Clone)]
pub(crate) struct Field<J>(Shared<J>);

impl<J> Field<J> {
    pub(super) fn new(function: impl Fn(&Vector3<f64>) -> J + Send + Sync + 'static) -> Self {
        Self(Arc::new(function))
    }

    pub(super) fn at(&self, point: &Vector3<f64>) -> J {
        (self.0)(point)
    }
}

impl<J> fmt::Debug for Field<J> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Field")
    }
}

/// The function of an implicit or explicit surface: with its derivatives, or without, to be
/// differentiated numerically.
#[derive(Debug, Clone)]
pub(crate) enum Source {
    Exact(Field<Jet>),
    Bare { function: Field<f64>, size: f64 },
}

impl Source {
    pub(super) fn value(&self, at: &Vector3<f64>) -> f64 {
        match self {
            Self::Exact(jet) => jet.at(at).value,
            Self::Bare { function, .. } => function.at(at),
        }
    }

    pub(super) fn slope(&self, at: &Vector3<f64>) -> (f64, Vector3<f64>) {
        match self {
            Self::Exact(jet) => {
                let jet = jet.at(at);
                (jet.value, jet.gradient)
            }
            Self::Bare { function, size } => {
                (function.at(at), gradient(&|p| function.at(p), at, STEP * size))
            }
        }
    }

    pub(super) fn jet(&self, at: &Vector3<f64>) -> Jet {
        match self {
            Self::Exact(jet) => jet.at(at),
            Self::Bare { function, size } => differences(&|p| function.at(p), at, *size),
        }
    }
}

/// Step of the differences relative to the size of the body: eps^(1/6) balances their error h^4
/// against the rounding eps/h^2 of the second derivatives.
const STEP: f64 = 2.5e-3;

// Weights of the five-point differences, error h^4.
const FIRST: [(f64, f64); 4] =
    [(-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0)];
const SECOND: [(f64, f64); 4] =
    [(-2.0, -1.0 / 12.0), (-1.0, 4.0 / 3.0), (1.0, 4.0 / 3.0), (2.0, -1.0 / 12.0)];

/// Derivatives of f by five-point differences; relative error about 1e-10.
fn differences(f: &dyn Fn(&Vector3<f64>) -> f64, at: &Vector3<f64>, size: f64) -> Jet {
    let h = STEP * size;
    let value = f(at);
    let mut hessian = Matrix3::zeros();
    for i in 0..3 {
        let one = Vector3::ith(i, h);
        let sum = SECOND.iter().map(|(n, w)| w * f(&(at + one * *n))).sum::<f64>();
        hessian[(i, i)] = (sum - 2.5 * value) / (h * h);
        for j in 0..i {
            let two = Vector3::ith(j, h);
            let mut mixed = 0.0;
            for (n, w) in FIRST {
                for (m, v) in FIRST {
                    mixed += w * v * f(&(at + one * n + two * m));
                }
            }
            hessian[(i, j)] = mixed / (h * h);
            hessian[(j, i)] = hessian[(i, j)];
        }
    }
    Jet { value, gradient: gradient(f, at, h), hessian }
}

fn gradient(f: &dyn Fn(&Vector3<f64>) -> f64, at: &Vector3<f64>, h: f64) -> Vector3<f64> {
    Vector3::from_fn(|i, _| {
        let one = Vector3::ith(i, h);
        FIRST.iter().map(|(n, w)| w * f(&(at + one * *n))).sum::<f64>() / h
    })
}
