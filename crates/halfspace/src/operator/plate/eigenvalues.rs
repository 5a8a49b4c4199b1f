//! The eigenvalues of a plate: sums over the waves that look alike at the cell centres.
//!
//! `Lambda_mn = s_m s_n sum_M sum_N sigma_M sigma_N C(k_MN)/(M N)`, with `s_m = (2 nx/pi) sin(m
//! pi/(2 nx))`. M runs over `2 nx q + m` and `2 nx (q + 1) - m`, each with the sign `(-1)^q`, and N
//! likewise. Each of these sums alternates with smooth terms, so that the first terms with the
//! weights of Cohen, Villegas and Zagier give it: `n` terms have an error of `5.8^-n` of the first.

use std::f64::consts::PI;

use super::shape::Plate;
use super::symbol::Symbol;
use crate::Grid;
use crate::operator::{Threads, pool};

/// Terms of an alternating sum: an error of 2e-14 of its first term.
const TERMS: usize = 18;
/// Relative error of the sum along y within the sum along x.
const ERROR: f64 = 2e-14;
/// The error falls by this factor with each term.
const RATE: f64 = 5.828;

/// The weights of the first `count` terms of an alternating sum, with their signs.
fn weights(count: usize) -> Vec<f64> {
    let mut power = 1.0;
    for _ in 0..count {
        power *= 3.0 + 8.0_f64.sqrt();
    }
    let d = 0.5 * (power + 1.0 / power);
    let (mut b, mut c) = (-1.0, -d);
    let n = count as f64;
    (0..count)
        .map(|q| {
            let q = q as f64;
            c = b - c;
            b *= (q + n) * (q - n) / ((q + 0.5) * (q + 1.0));
            c / d
        })
        .collect()
}

/// Waves of one axis that look like wave `number` at the centres of `count` cells: their numbers,
/// as pairs of the two alternating sums.
fn alike(number: usize, count: usize, term: usize) -> [f64; 2] {
    let period = 2 * count;
    [(period * term + number) as f64, (period * (term + 1) - number) as f64]
}

/// The mean of wave `number` over a cell, times its number.
fn mean(number: usize, count: usize) -> f64 {
    let period = 2.0 * count as f64;
    period / PI * libm::sin(number as f64 * PI / period)
}

/// One term of the sums along y, for all waves 1..=ny.
struct AlongY {
    /// k_y^2.
    square: Vec<f64>,
    least: f64,
    /// s_n/N.
    share: Vec<f64>,
}

impl AlongY {
    fn new(term: usize, family: usize, ny: usize, side: f64) -> Self {
        let number = |n: usize| alike(n, ny, term)[family];
        let wave = |n: usize| PI * number(n) / side;
        let square: Vec<f64> = (1..=ny).map(|n| wave(n) * wave(n)).collect();
        let least = square.iter().copied().fold(f64::INFINITY, f64::min);
        let share = (1..=ny).map(|n| mean(n, ny) / number(n)).collect();
        Self { square, least, share }
    }

    /// Adds `weight` times this term.
    fn add(&self, symbol: &Symbol, x_square: f64, weight: f64, sums: &mut [f64]) {
        let terms = sums.iter_mut().zip(self.square.iter().zip(&self.share));
        if let Some(factor) = symbol.far(x_square + self.least) {
            let factor = weight * factor;
            for (sum, (square, share)) in terms {
                *sum += factor * share / (x_square + square).sqrt();
            }
        } else {
            for (sum, (square, share)) in terms {
                *sum += weight * share * symbol.at(x_square + square);
            }
        }
    }
}

/// The eigenvalues, for each m = 1..=nx those of n = 1..=ny.
pub(super) fn eigenvalues(plate: Plate, grid: Grid, symbol: &Symbol, threads: Threads) -> Vec<f64> {
    let (nx, ny) = (grid.nx(), grid.ny());
    let along_y: Vec<[AlongY; 2]> = (0..TERMS)
        .map(|term| [0, 1].map(|family| AlongY::new(term, family, ny, plate.b())))
        .collect();
    let all: Vec<Vec<f64>> = (0..=TERMS).map(weights).collect();
    let shortest = PI * ny as f64 / plate.b();
    let column = |m: usize, sums: &mut [f64]| {
        let first = PI * m as f64 / plate.a();
        let own = symbol.at(first * first + shortest * shortest);
        for (term, weight) in all[TERMS].iter().enumerate() {
            for number in alike(m, nx, term) {
                let weight = weight * mean(m, nx) / number;
                let wave = PI * number / plate.a();
                // A sum that counts little needs fewer digits. Its share is greatest at the
                // shortest wave along y.
                let share = symbol.at(wave * wave + shortest * shortest) / own;
                let digits = (share * weight.abs() / ERROR).max(RATE).ln() / RATE.ln();
                let count = (digits.ceil() as usize).min(TERMS);
                for (terms, inner) in along_y.iter().zip(&all[count]) {
                    for term in terms {
                        term.add(symbol, wave * wave, weight * inner, sums);
                    }
                }
            }
        }
    };
    // Those of a square are symmetric.
    let is_square = nx == ny && plate.a() == plate.b();
    let wanted = |m: usize| if is_square { m } else { ny };
    let mut values = vec![0.0; nx * ny];
    let fill = |(i, sums): (usize, &mut [f64])| column(i + 1, &mut sums[..wanted(i + 1)]);
    match threads {
        Threads::One => values.chunks_exact_mut(ny).enumerate().for_each(fill),
        Threads::Pool => pool::each_row(&mut values, ny, fill),
    }
    if is_square {
        mirror(&mut values, nx);
    }
    values
}

/// Copies the lower triangle of a square matrix to the upper one.
fn mirror(values: &mut [f64], count: usize) {
    for m in 0..count {
        for n in m + 1..count {
            values[m * count + n] = values[n * count + m];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::shape::Constants;
    use super::super::symbol::PlateSymbol;
    use super::*;

    /// All terms of both sums, with as many digits everywhere.
    fn in_full(plate: Plate, grid: Grid, symbol: &Symbol, [m, n]: [usize; 2]) -> f64 {
        let weights = weights(TERMS);
        let along = |number: usize, count: usize, side: f64| {
            let terms = weights.iter().enumerate().flat_map(move |(term, weight)| {
                alike(number, count, term).map(|wave| (wave, *weight))
            });
            terms
                .map(move |(wave, weight)| {
                    let k = PI * wave / side;
                    (k * k, weight * mean(number, count) / wave)
                })
                .collect::<Vec<_>>()
        };
        let (x, y) = (along(m, grid.nx(), plate.a()), along(n, grid.ny(), plate.b()));
        let over_y = |x: f64| y.iter().map(|(y, weight)| weight * symbol.at(x + y)).sum::<f64>();
        x.iter().map(|(x, weight)| weight * over_y(*x)).sum()
    }

    #[test]
    fn sums_that_count_little_lose_no_digit_with_fewer_terms() {
        for thickness in [0.1, 1e-3, 1e-4] {
            let plate = Plate::new(1.0, 0.8, thickness).unwrap();
            let grid = plate.grid(60, 44).unwrap();
            let constants = Constants { thickness, surface: 2.0, punch: 0.3, shear_modulus: 0.35 };
            for kind in PlateSymbol::ALL {
                let symbol = Symbol::new(kind, constants);
                let values = eigenvalues(plate, grid, &symbol, Threads::One);
                for [m, n] in [[1, 1], [1, 44], [60, 1], [7, 43], [59, 43], [60, 44], [30, 12]] {
                    let found = values[(m - 1) * grid.ny() + n - 1];
                    let full = in_full(plate, grid, &symbol, [m, n]);
                    let error = (found / full - 1.0).abs();
                    assert!(error < 2e-13, "{kind:?} {thickness} {m} {n}: {error}");
                }
            }
        }
    }

    #[test]
    fn weights_sum_an_alternating_series() {
        for count in [8, TERMS] {
            let sum: f64 =
                weights(count).iter().enumerate().map(|(q, w)| w / (q as f64 + 1.0)).sum();
            let error = (sum - 2.0_f64.ln()).abs();
            assert!(error < RATE.powi(-(count as i32)).max(2e-16), "{count}: {error}");
        }
    }
}
