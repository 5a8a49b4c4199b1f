//! Plans of fast Fourier transforms, real and complex, in double and single precision.
//!
//! The libraries `rustfft` and `realfft` are generic, so that each crate that plans a transform compiles them anew, in a
//! quarter of a minute for each precision. The plans here are not generic: only this crate compiles the libraries.
//!
//! ```
//! use carom_fourier::{Complex64, Transformed as _};
//! let mut values = [1.0, 2.0, 3.0, 4.0].map(|x| Complex64::new(x, 0.0));
//! f64::complex_plan(4).forward.process(&mut values);
//! assert_eq!(values[0], Complex64::new(10.0, 0.0));
//! assert_eq!(values[1], Complex64::new(-2.0, 2.0));
//! ```
#![forbid(unsafe_code)]

pub use realfft::{ComplexToReal, FftNum, RealToComplex};
pub use rustfft::Fft;
pub use rustfft::num_complex::{Complex, Complex64};

use realfft::RealFftPlanner;
use rustfft::FftPlanner;
use std::sync::Arc;

/// Both transforms of complex numbers.
#[derive(Clone)]
pub struct ComplexPlan<T> {
    /// Sum of x_j exp(-2 pi i j k / n).
    pub forward: Arc<dyn Fft<T>>,
    /// Sum of x_k exp(2 pi i j k / n), n times the inverse.
    pub inverse: Arc<dyn Fft<T>>,
}

/// The transforms of n real numbers to n/2 + 1 complex ones and back.
#[derive(Clone)]
pub struct RealPlan<T> {
    /// Sum of x_j exp(-2 pi i j k / n) for k up to n/2.
    pub forward: Arc<dyn RealToComplex<T>>,
    /// n times the inverse.
    pub inverse: Arc<dyn ComplexToReal<T>>,
}

/// A number type that has plans: `f64` or `f32`.
pub trait Transformed: FftNum {
    /// The plan of complex transforms of a length.
    fn complex_plan(length: usize) -> ComplexPlan<Self>;

    /// The plan of real transforms of a length.
    fn real_plan(length: usize) -> RealPlan<Self>;
}

impl Transformed for f64 {
    fn complex_plan(length: usize) -> ComplexPlan<Self> {
        complex(length)
    }

    fn real_plan(length: usize) -> RealPlan<Self> {
        real(length)
    }
}

impl Transformed for f32 {
    fn complex_plan(length: usize) -> ComplexPlan<Self> {
        complex(length)
    }

    fn real_plan(length: usize) -> RealPlan<Self> {
        real(length)
    }
}

fn complex<T: FftNum>(length: usize) -> ComplexPlan<T> {
    let mut planner = FftPlanner::new();
    ComplexPlan {
        forward: planner.plan_fft_forward(length),
        inverse: planner.plan_fft_inverse(length),
    }
}

fn real<T: FftNum>(length: usize) -> RealPlan<T> {
    let mut planner = RealFftPlanner::new();
    RealPlan {
        forward: planner.plan_fft_forward(length),
        inverse: planner.plan_fft_inverse(length),
    }
}
