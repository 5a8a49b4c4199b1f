//! Analytic continuation of 2F1 towards 1 by Taylor steps of its differential equation.
//!
//! `x (1 - x) F'' + (c - (a + b + 1) x) F' - a b F = 0` (DLMF 15.10.1) gives the Taylor
//! coefficients of F about any point from F and F' there. From 1/2 on each step halves the distance
//! to 1, so that the series converges like 2^-n. The method is regular for integer `c - a - b`,
//! where the connection formula fails.

use super::series::Sum;

/// Number of Taylor terms: 2^-60 times the growth of the coefficients is below rounding.
pub(super) const TERMS: usize = 72;

/// F and (1 - x) F' at a point, given by its distance y from 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct State {
    /// The magnitude of the terms summed for F at 1/2.
    pub(super) size: f64,
    pub(super) y: f64,
    pub(super) value: f64,
    pub(super) slope: f64,
}

/// The parameters, with `excess = c - a - b`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Equation {
    pub(super) a: f64,
    pub(super) b: f64,
    pub(super) excess: f64,
}

/// The Taylor coefficients of F in `tau = (x - x_0)/y_0` about a point.
pub(super) struct Expansion {
    pub(super) y: f64,
    size: f64,
    pub(super) coefficients: [f64; TERMS],
}

impl Equation {
    /// The Taylor coefficients about the point of a state.
    pub(super) fn expand(&self, state: State) -> Expansion {
        let Self { a, b, excess } = *self;
        let State { y, value, slope, size } = state;
        let mut g = [0.0; TERMS];
        (g[0], g[1]) = (value, slope);
        let drift = excess - 1.0 + (a + b + 1.0) * y;
        let bend = 2.0 * y - 1.0;
        for k in 0..TERMS - 2 {
            let n = k as f64;
            let rise = (n + 1.0) * (bend * n + drift) * g[k + 1];
            let fall = (n + a) * (n + b) * y * g[k];
            g[k + 2] = (fall - rise) / ((1.0 - y) * (n + 1.0) * (n + 2.0));
        }
        Expansion { y, size, coefficients: g }
    }

    /// The state at the distance `y` from 1, starting from 1/2; `visit` is called for each step
    /// with its end.
    pub(super) fn carry(
        &self,
        from: State,
        y: f64,
        mut visit: impl FnMut(&Expansion, f64),
    ) -> State {
        let mut state = from;
        while state.y > y {
            let expansion = self.expand(state);
            let next = (0.5 * state.y).max(y);
            visit(&expansion, next);
            state = expansion.at(next);
        }
        state
    }
}

impl Expansion {
    /// The state at the distance `y` from 1.
    pub(super) fn at(&self, y: f64) -> State {
        let tau = (self.y - y) / self.y;
        let (mut value, mut slope) = (0.0, 0.0);
        for (k, g) in self.coefficients.iter().enumerate().rev() {
            if k > 0 {
                slope = slope * tau + k as f64 * g;
            }
            value = value * tau + g;
        }
        State { y, value, slope: slope * y / self.y, size: self.size }
    }
}

/// The state at 1/2 from the sums of F and F'.
pub(super) fn start(value: Sum, derivative: Sum) -> State {
    State { size: value.size, y: 0.5, value: value.value, slope: 0.5 * derivative.value }
}
