//! The sine transform of one row or column, by a real Fourier transform of the same length.
//!
//! With the signs of every second value changed, the waves `sin(m pi (i + 1/2)/n)`, m = 1..=n, are
//! cosines of number n - m, and these follow from a Fourier transform of the even values followed by
//! the odd ones in reverse.

use std::f64::consts::PI;

use carom_fourier::{Complex64, RealPlan, Transformed as _};

/// Sine transforms of one length.
#[derive(Clone)]
pub(super) struct Sines {
    length: usize,
    plan: RealPlan<f64>,
    /// exp(-i pi k/(2 n)).
    turns: Vec<Complex64>,
}

/// Working memory of transforms, for one thread.
#[derive(Debug, Clone, Default)]
pub(in crate::operator) struct SineBuffers {
    values: Vec<f64>,
    spectrum: Vec<Complex64>,
    scratch: Vec<Complex64>,
}

impl Sines {
    pub(super) fn new(length: usize) -> Self {
        let turns = (0..=length / 2).map(|k| {
            let (sin, cos) = libm::sincos(-PI * k as f64 / (2 * length) as f64);
            Complex64::new(cos, sin)
        });
        Self { length, plan: f64::real_plan(length), turns: turns.collect() }
    }

    /// Makes the buffers of the length that the transforms require.
    pub(super) fn prepare(&self, buffers: &mut SineBuffers) {
        buffers.values.resize(self.length, 0.0);
        buffers.spectrum.resize(self.turns.len(), Complex64::ZERO);
        let scratch = self.plan.forward.get_scratch_len().max(self.plan.inverse.get_scratch_len());
        if buffers.scratch.len() < scratch {
            buffers.scratch.resize(scratch, Complex64::ZERO);
        }
    }

    /// Replaces values by the sums of value times sine, not scaled.
    pub(super) fn transform(&self, values: &mut [f64], buffers: &mut SineBuffers) {
        self.prepare(buffers);
        let (n, SineBuffers { values: sorted, spectrum, scratch }) = (self.length, buffers);
        for (i, pair) in values.chunks(2).enumerate() {
            sorted[i] = pair[0];
            if let Some(odd) = pair.get(1) {
                sorted[n - 1 - i] = -odd;
            }
        }
        let done = self.plan.forward.process_with_scratch(sorted, spectrum, scratch);
        debug_assert!(done.is_ok(), "buffers are made for this length");
        for (k, (turn, wave)) in self.turns.iter().zip(spectrum.iter()).enumerate() {
            let turned = turn * wave;
            if k > 0 {
                values[k - 1] = -turned.im;
            }
            values[n - 1 - k] = turned.re;
        }
    }

    /// Undoes [`Sines::transform`], times the length.
    pub(super) fn undo(&self, values: &mut [f64], buffers: &mut SineBuffers) {
        self.prepare(buffers);
        let (n, SineBuffers { values: sorted, spectrum, scratch }) = (self.length, buffers);
        for (k, (turn, wave)) in self.turns.iter().zip(spectrum.iter_mut()).enumerate() {
            let odd = if k > 0 { values[k - 1] } else { 0.0 };
            *wave = turn.conj() * Complex64::new(values[n - 1 - k], -odd);
        }
        // These two are real but for rounding.
        spectrum[0].im = 0.0;
        if n.is_multiple_of(2) {
            spectrum[n / 2].im = 0.0;
        }
        let done = self.plan.inverse.process_with_scratch(spectrum, sorted, scratch);
        debug_assert!(done.is_ok(), "buffers are made for this length");
        for (i, pair) in values.chunks_mut(2).enumerate() {
            pair[0] = sorted[i];
            if let Some(odd) = pair.get_mut(1) {
                *odd = -sorted[n - 1 - i];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transforms_are_the_sums_of_sines() {
        for n in [1, 2, 3, 4, 5, 8, 13, 30] {
            let sines = Sines::new(n);
            let given: Vec<f64> = (0..n).map(|i| (1.3 * i as f64 + 0.4).sin()).collect();
            let (mut values, mut buffers) = (given.clone(), SineBuffers::default());
            sines.transform(&mut values, &mut buffers);
            for (m, value) in values.iter().enumerate() {
                let wave =
                    |i: usize| ((m + 1) as f64 * PI * (i as f64 + 0.5) / n as f64).sin() * given[i];
                let sum: f64 = (0..n).map(wave).sum();
                assert!((value - sum).abs() < 1e-13, "{n} {m}: {value} {sum}");
            }
            sines.undo(&mut values, &mut buffers);
            for (value, given) in values.iter().zip(&given) {
                assert!((value / n as f64 - given).abs() < 1e-15, "{n}");
            }
        }
    }
}
