//! The constant matrices of two materials and a coefficient of friction, for a contact of radius 1.
//!
//! Tractions Q (radial + i circumferential) of the harmonics k and -k give the displacements, with q = (Q_k,
//! Q_-k),
//!
//! ```text
//! U_k  = kappa W(k+1,k+1) Q_k  + (kappa-1) W(k+1,k-1) conj(Q_-k) - gamma^2 W(k+1,k) P
//! U_-k = kappa W(k-1,k-1) Q_-k + (kappa-1) W(k-1,k+1) conj(Q_k)  + gamma^2 W(k-1,k) conj(P)
//! P = W(k,k)^-1 [W(k,k+1) Q_k - W(k,k-1) conj(Q_-k)]/2
//! ```
//!
//! where gamma P is the pressure that tractions add so that the bodies do not overlap. Parts that are even
//! under reflection are real, odd ones imaginary: each harmonic has two real blocks.

use std::ops::Deref;
use std::sync::Arc;

use super::carry::Nodes;
use super::dense::{Rows, combined, inverse, product, zeros};
use super::influence::{Harmonic, Influence};
use super::kernel::spread_at;
use super::layout::Layout;
use super::recent;
use super::symmetry::{Symmetry, Whole};
use super::transform::{direction, parts_of};

/// A block acts on two components on N rings: `[component in][ring in][component out][ring out]`.
pub(super) type Block<const N: usize> = [[[[f64; N]; 2]; N]; 2];
/// The rows of a block for the rim: `[component out][component in][ring in]`.
pub(super) type RimBlock<const N: usize> = [[[f64; N]; 2]; 2];
/// Pressures of a harmonic by the tractions of a block: `[component in][ring in][ring out]`.
pub(super) type PressBlock<const N: usize> = [[[f64; N]; N]; 2];

/// Hertz's pressure at the centre of a contact of radius 1.
pub(super) const PEAK: f64 = 4.0 / std::f64::consts::PI;
/// Hertz's force on a contact of radius 1.
pub(super) const HERTZ: f64 = 8.0 / 3.0;
/// Above this friction the scale of tractions is set by the pressure, not by the friction limit.
const MOST_CARRIED: f64 = 3.0;
/// The largest gamma f at which the centre moves: beyond it the bodies part on one side, which no circle shows.
const MOST_LIFT: f64 = 1.0;

/// The matrices of a pair of materials.
#[derive(Debug)]
pub(super) struct Matrices<const N: usize, const H: usize, S: Symmetry<H>> {
    pub(super) layout: Layout<N>,
    pub(super) nodes: Nodes<N>,
    /// The radial displacement at the rim, as `Layout::spread`.
    pub(super) spread_at_rim: f64,
    /// Directions of the stored angles.
    pub(super) directions: [[f64; 2]; H],
    pub(super) waves: S::Waves,
    /// The preconditioner: the mean displacement of a ring by its own traction.
    pub(super) sigma: [f64; N],
    /// `(M + sigma)^-1` by blocks.
    pub(super) inverse: Vec<Block<N>>,
    /// `M^-1` by blocks: tractions in full adhesion.
    pub(super) sticking: Vec<Block<N>>,
    pub(super) rim: Vec<RimBlock<N>>,
    /// Pressures by tractions over gamma f; block b gives the harmonic of its first component, real if even.
    pub(super) press: Vec<PressBlock<N>>,
    /// The way of the centre over the radius and gamma f, along x by tractions of the even block of the harmonic 1 and
    /// along y by those of the odd one: `[component in][ring in]`.
    pub(super) way: [[[f64; N]; 2]; 2],
    /// Derivatives by the angle, of radial and of circumferential components: `[component][angle][angle in]`.
    pub(super) slopes: [[[f64; H]; H]; 2],
}

/// The matrices of two materials with a coefficient of friction.
#[derive(Debug, Clone)]
pub(super) struct Pair<const N: usize, const H: usize, S: Symmetry<H> = Whole> {
    matrices: Arc<Matrices<N, H, S>>,
    /// Gamma over f: radial displacement by pressure, in the unit of the shifts.
    pub(super) spread: f64,
    /// Gamma f: pressure by tractions that are divided by f.
    pub(super) lift: f64,
    /// The scale of tractions, divided by f: Hertz's peak pressure, or for large friction a few times the
    /// traction of a force equal to the normal one.
    pub(super) scale: f64,
    /// Whether friction is finite.
    pub(super) slips: bool,
    /// The normal force of a contact of radius 1 that never slips.
    pub(super) normal_without_slip: f64,
}

impl<const N: usize, const H: usize, S: Symmetry<H>> Deref for Pair<N, H, S> {
    type Target = Matrices<N, H, S>;

    fn deref(&self) -> &Self::Target {
        &self.matrices
    }
}

/// The real block of a harmonic: four matrices, one for each component in and out.
struct Blocks([[Rows; 2]; 2]);

impl<const N: usize, const H: usize, S: Symmetry<H>> Pair<N, H, S> {
    /// The pair with stiffness ratio kappa, coupling gamma and friction f > 0; for infinite f tractions are
    /// not divided.
    pub(super) fn new(kappa: f64, gamma: f64, friction: f64) -> Self {
        let slips = friction.is_finite();
        let (spread, lift) =
            if slips { (gamma / friction, gamma * friction) } else { (gamma, gamma) };
        let scale = PEAK * (MOST_CARRIED / friction).min(1.0);
        let moves = slips && lift > 0.0 && lift <= MOST_LIFT;
        let matrices = Matrices::shared(kappa, gamma, moves);
        let mut pair = Self { matrices, spread, lift, scale, slips, normal_without_slip: HERTZ };
        if !slips && lift != 0.0 {
            pair.normal_without_slip = pair.pressed_without_slip();
        }
        pair
    }
}

impl<const N: usize, const H: usize, S: Symmetry<H>> Matrices<N, H, S> {
    fn new(kappa: f64, gamma: f64, moves: bool) -> Self {
        let influence = Influence::<N>::shared(S::ANGLES);
        let [rings, rim] = [&influence.rings, &influence.rim].map(|of| match moves {
            true => influence.centre.of_moving(of),
            false => of.clone(),
        });
        let blocks = |of: &[Harmonic]| -> Vec<Blocks> {
            (0..S::blocks()).map(|block| kept::<H, S>(of, kappa, gamma, block)).collect()
        };
        let whole = blocks(&rings);
        let sigma = own(&rings, S::ANGLES, [kappa, gamma]);
        Self {
            nodes: Nodes::new(&influence.layout.radius),
            layout: influence.layout.clone(),
            spread_at_rim: spread_at(influence.rim_radius),
            directions: std::array::from_fn(|j| direction(j, S::ANGLES)),
            waves: S::waves(),
            inverse: whole.iter().map(|block| inverted(block, &sigma)).collect(),
            sticking: whole.iter().map(|block| inverted(block, &[0.0; N])).collect(),
            sigma,
            rim: blocks(&rim).iter().map(rim_block).collect(),
            press: (0..S::blocks()).map(|b| press_block::<N, H, S>(&rings, b)).collect(),
            way: [0, 1].map(|odd| match moves {
                true => way_block::<N, H, S>(&influence, odd),
                false => [[0.0; N]; 2],
            }),
            slopes: slopes::<H, S>(),
        }
    }

    /// The matrices of a pair, about a centre that moves or stays; the most recent ones are cached.
    fn shared(kappa: f64, gamma: f64, moves: bool) -> Arc<Self> {
        // The sign of gamma is free.
        let sign = if moves { 1.0 } else { -1.0 };
        let key = [kappa, sign * gamma.abs()].map(f64::to_bits);
        recent::shared(key, || Self::new(kappa, gamma, moves))
    }
}

/// The harmonic of a block, and 1 for a block that is even under reflection, -1 for an odd one.
const fn harmonic(angles: usize, block: usize) -> (usize, f64) {
    (parts_of(angles, block)[0].0, if block.is_multiple_of(2) { 1.0 } else { -1.0 })
}

/// A stored block. With symmetry about the plane of motion it acts on the mean and half the difference of the
/// harmonics k and -k.
fn kept<const H: usize, S: Symmetry<H>>(
    of: &[Harmonic],
    kappa: f64,
    gamma: f64,
    block: usize,
) -> Blocks {
    let whole = S::whole_block(block);
    let blocks = matrix(of, S::ANGLES, [kappa, gamma], whole);
    if !S::MIRRORED || whole < 2 {
        return blocks;
    }
    let [[a, b], [c, d]] = &blocks.0;
    let turned = |signs: [f64; 4]| {
        let [p, q, r, s] = signs.map(|sign| 0.5 * sign);
        combined(1.0, &combined(p, a, q, b), 1.0, &combined(r, c, s, d))
    };
    Blocks([
        [turned([1.0, 1.0, 1.0, 1.0]), turned([1.0, -1.0, 1.0, -1.0])],
        [turned([1.0, 1.0, -1.0, -1.0]), turned([1.0, -1.0, -1.0, 1.0])],
    ])
}

/// The displacement of a ring by its own traction, averaged over all blocks of the whole turn.
fn own<const N: usize>(of: &[Harmonic], angles: usize, pair: [f64; 2]) -> [f64; N] {
    let mut sigma = [0.0; N];
    for block in 0..angles {
        let Blocks([[one, _], [_, two]]) = matrix(of, angles, pair, block);
        for (i, sigma) in sigma.iter_mut().enumerate() {
            *sigma += one[i][i] + two[i][i];
        }
    }
    sigma.map(|sum| sum / (2 * angles) as f64)
}

fn matrix(of: &[Harmonic], angles: usize, [kappa, gamma]: [f64; 2], block: usize) -> Blocks {
    let (k, sign) = harmonic(angles, block);
    let at = &of[k];
    let none = || {
        let [rows, columns] = [at.own[0].len(), at.own[0][0].len()];
        zeros(rows, columns)
    };
    let square = gamma * gamma;
    let through = |spread: &Rows, lift: &Rows| product(spread, &product(&at.normal_inverse, lift));
    if block == 0 {
        let pressed = through(&at.spread[0], &at.lift[0]);
        let radial = combined(1.0, &at.own[0], -square, &pressed);
        let around = combined(2.0 * kappa - 1.0, &at.own[1], 0.0, &pressed);
        return Blocks([[radial, none()], [none(), around]]);
    }
    if block == 1 {
        let own = combined(0.5 * kappa, &at.own[0], 0.5 * kappa, &at.own[1]);
        let other = combined(0.5 * (kappa - 1.0), &at.other[0], 0.5 * (kappa - 1.0), &at.other[1]);
        let spread = combined(0.5, &at.spread[0], -0.5, &at.spread[1]);
        let lift = combined(0.5, &at.lift[0], -0.5, &at.lift[1]);
        let radial = combined(1.0, &own, 1.0, &other);
        let radial = combined(1.0, &radial, -square, &through(&spread, &lift));
        let around = combined(1.0, &own, -1.0, &other);
        return Blocks([[radial, none()], [none(), around]]);
    }
    let part = |own: &Rows, factor: f64, spread: &Rows, lift: &Rows, press: f64| {
        combined(factor, own, -0.5 * square * press, &through(spread, lift))
    };
    let [up, down] = [0, 1];
    Blocks([
        [
            part(&at.own[up], kappa, &at.spread[up], &at.lift[up], 1.0),
            part(&at.other[up], sign * (kappa - 1.0), &at.spread[up], &at.lift[down], -sign),
        ],
        [
            part(&at.other[down], sign * (kappa - 1.0), &at.spread[down], &at.lift[up], -sign),
            part(&at.own[down], kappa, &at.spread[down], &at.lift[down], 1.0),
        ],
    ])
}

fn inverted<const N: usize>(block: &Blocks, sigma: &[f64; N]) -> Block<N> {
    let mut whole = zeros(2 * N, 2 * N);
    for (i, row) in whole.iter_mut().enumerate() {
        for (j, value) in row.iter_mut().enumerate() {
            *value = block.0[i / N][j / N][i % N][j % N];
        }
        row[i] += sigma[i % N];
    }
    let inverse = inverse(&whole);
    let mut out = [[[[0.0; N]; 2]; N]; 2];
    for (i, row) in inverse.iter().enumerate() {
        for (j, value) in row.iter().enumerate() {
            out[j / N][j % N][i / N][i % N] = *value;
        }
    }
    out
}

fn rim_block<const N: usize>(block: &Blocks) -> RimBlock<N> {
    std::array::from_fn(|out| {
        std::array::from_fn(|part| std::array::from_fn(|ring| block.0[out][part][0][ring]))
    })
}

/// The block of the harmonic 1 that is even (0) or odd (1) under reflection.
pub(super) const fn block_of_way<const H: usize, S: Symmetry<H>>(odd: usize) -> usize {
    if S::MIRRORED { 1 } else { 2 + odd }
}

/// The way of the centre by the tractions of a block; with symmetry there is none across.
fn way_block<const N: usize, const H: usize, S: Symmetry<H>>(
    of: &Influence<N>,
    odd: usize,
) -> [[f64; N]; 2] {
    if S::OPPOSITE || (S::MIRRORED && odd == 1) {
        return [[0.0; N]; 2];
    }
    let (way, [up, down]) = (&of.centre.way, &of.rings[1].lift);
    let by = |lift: &Rows, factor: f64| -> [f64; N] {
        std::array::from_fn(|j| {
            factor * way.iter().zip(lift).map(|(w, row)| w * row[j]).sum::<f64>()
        })
    };
    // The pressure is 2 P cos(theta), or -2 P sin(theta) of the odd block.
    match (S::MIRRORED, odd) {
        (true, _) => {
            let [up, down] = [by(up, 1.0), by(down, 1.0)];
            [1.0, -1.0].map(|sign| std::array::from_fn(|i| up[i] - sign * down[i]))
        }
        (false, 0) => [by(up, 1.0), by(down, -1.0)],
        (false, _) => [by(up, -1.0), by(down, -1.0)],
    }
}

/// Derivatives by the angle of a field with its shortest wave left out, as those of trigonometric interpolation.
fn slopes<const H: usize, S: Symmetry<H>>() -> [[[f64; H]; H]; 2] {
    let turn = S::ANGLES;
    let of = |at: usize, from: usize| {
        let between = (at + turn - from) % turn;
        let [cosine, sine] = direction(between, 2 * turn);
        match between {
            0 => 0.0,
            _ if between.is_multiple_of(2) => 0.5 * cosine / sine,
            _ => -0.5 * cosine / sine,
        }
    };
    let has_image = |from: usize| S::MIRRORED && from != 0 && from != H - 1;
    [1.0, -1.0].map(|sign| {
        std::array::from_fn(|at| {
            std::array::from_fn(|from| {
                let image = if has_image(from) { sign * of(at, turn - from) } else { 0.0 };
                of(at, from) + image
            })
        })
    })
}

fn press_block<const N: usize, const H: usize, S: Symmetry<H>>(
    of: &[Harmonic],
    block: usize,
) -> PressBlock<N> {
    let whole = S::whole_block(block);
    let (k, sign) = harmonic(S::ANGLES, whole);
    let at = &of[k];
    let by = |lift: &Rows| -> [[f64; N]; N] {
        let rows = product(&at.normal_inverse, lift);
        std::array::from_fn(|j| std::array::from_fn(|i| rows[i][j]))
    };
    let halves = |p: f64, q: f64| by(&combined(p, &at.lift[0], q, &at.lift[1]));
    match whole {
        0 => [by(&at.lift[0]), [[0.0; N]; N]],
        1 => [halves(0.5, -0.5), [[0.0; N]; N]],
        _ if S::MIRRORED => [halves(0.5, -0.5), halves(0.5, 0.5)],
        _ => [halves(0.5, 0.0), halves(0.0, -0.5 * sign)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The traction that gives a displacement of the first component of a block, and its load.
    fn stiffness<const N: usize>(
        kappa: f64,
        block: usize,
        part: usize,
        u: impl Fn(f64) -> f64,
    ) -> f64 {
        let pair = Pair::<N, 8>::new(kappa, 0.0, f64::INFINITY);
        let layout = &pair.layout;
        let mut load = 0.0;
        for j in 0..N {
            for i in 0..N {
                let q = pair.sticking[block][part][j][part][i] * u(layout.radius[j]);
                load += layout.area[i] * u(layout.radius[i]) * q;
            }
        }
        load
    }

    #[test]
    fn stiffness_in_shift_and_twist_is_that_of_mindlin_and_reissner() {
        // A rigid shift is the harmonic -1 in polar axes: F = 4/kappa; twist: M = (16/3) G/... with
        // (1-nu)/G = 1 and 1/(1-nu) = 2 kappa - 1.
        for kappa in [1.0, 7.0 / 6.0, 1.5] {
            let shift = stiffness::<8>(kappa, 2, 1, |_| 1.0);
            assert_relative_eq!(shift, 4.0 / kappa, max_relative = 2e-4);
            let twist = stiffness::<8>(kappa, 0, 1, |r| r);
            assert_relative_eq!(twist, 16.0 / 3.0 / (2.0 * kappa - 1.0), max_relative = 2e-4);
        }
    }

    #[test]
    fn blocks_are_symmetric_by_area_and_positive() {
        for (kappa, gamma) in [(1.0, 0.5), (1.5, 0.0), (1.125, -0.25), (0.8, 0.3)] {
            // About a fixed centre: displacements about one that moves are not at the same places.
            let pair = Pair::<6, 8>::new(kappa, gamma, f64::INFINITY);
            for (block, inverse) in pair.inverse.iter().enumerate() {
                for i in 0..12 {
                    assert!(inverse[i / 6][i % 6][i / 6][i % 6] > 0.0, "{block} {i}");
                    for j in 0..12 {
                        let one = inverse[j / 6][j % 6][i / 6][i % 6] * pair.layout.area[i % 6];
                        let two = inverse[i / 6][i % 6][j / 6][j % 6] * pair.layout.area[j % 6];
                        assert!(
                            (one - two).abs() < 1e-9 * pair.layout.area[5].max(one.abs()),
                            "{block}"
                        );
                    }
                }
            }
        }
    }
}
