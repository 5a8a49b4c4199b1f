//! Symmetry of a motion: which angles are stored, and their harmonics.

use std::fmt::Debug;

use super::transform::{Field, direction, directions, parts, transform};

/// The angles of a turn that a contact stores; the others follow by symmetry.
///
/// H is the number of stored angles.
pub trait Symmetry<const H: usize>:
    Debug + Clone + Copy + PartialEq + Send + Sync + 'static
{
    /// Number of angles of the whole turn.
    const ANGLES: usize;
    /// Whether the contact is symmetric about the plane of motion.
    const MIRRORED: bool;
    /// Whether opposite points of the contact have the same tractions.
    const OPPOSITE: bool;
    /// Cosines and sines of the harmonics.
    type Waves: Debug + Clone + Send + Sync;

    /// Computes the cosines and sines.
    #[doc(hidden)]
    fn waves() -> Self::Waves;

    /// Transforms values at angles to harmonics, in place.
    #[doc(hidden)]
    fn to_harmonics<const N: usize>(waves: &Self::Waves, field: &mut Field<N, H>);

    /// Transforms harmonics to values at angles, in place.
    #[doc(hidden)]
    fn to_angles<const N: usize>(waves: &Self::Waves, field: &mut Field<N, H>);

    /// Number of matrix blocks that act on the harmonics.
    #[doc(hidden)]
    fn blocks() -> usize;

    /// The index of a block among those of the whole turn.
    #[doc(hidden)]
    fn whole_block(block: usize) -> usize;

    /// The places of the two components of a block among the harmonics.
    #[doc(hidden)]
    fn places(block: usize) -> [(usize, usize); 2];

    /// Number of angles of the turn that a stored angle represents.
    #[doc(hidden)]
    fn weight(angle: usize) -> f64;

    /// The stored angle with the values at the opposite point, and the signs of both components there.
    #[doc(hidden)]
    fn opposite(angle: usize) -> (usize, [f64; 2]);
}

/// All angles: any motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Whole;

/// Angles from 0 to half a turn: shift along x only, no twist.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plane;

/// Angles from 0 to a quarter of a turn: shift along x only, no twist, no coupling.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AlikePlane;

impl<const H: usize> Symmetry<H> for Whole {
    const ANGLES: usize = H;
    const MIRRORED: bool = false;
    const OPPOSITE: bool = false;
    type Waves = [[f64; 2]; H];

    fn waves() -> Self::Waves {
        directions()
    }

    #[inline(always)]
    fn to_harmonics<const N: usize>(waves: &Self::Waves, field: &mut Field<N, H>) {
        transform(field, waves, -1.0);
        let scale = 1.0 / H as f64;
        field.as_flattened_mut().as_flattened_mut().iter_mut().for_each(|x| *x *= scale);
    }

    #[inline(always)]
    fn to_angles<const N: usize>(waves: &Self::Waves, field: &mut Field<N, H>) {
        transform(field, waves, 1.0);
    }

    #[inline(always)]
    fn blocks() -> usize {
        H
    }

    #[inline(always)]
    fn whole_block(block: usize) -> usize {
        block
    }

    #[inline(always)]
    fn places(block: usize) -> [(usize, usize); 2] {
        parts::<H>(block)
    }

    #[inline(always)]
    fn weight(_: usize) -> f64 {
        1.0
    }

    #[inline(always)]
    fn opposite(angle: usize) -> (usize, [f64; 2]) {
        ((angle + H / 2) % H, [1.0; 2])
    }
}

/// Cosines for the radial and sines for the circumferential component, by harmonic and angle, times the
/// number of angles (or harmonics) that each represents.
#[derive(Debug, Clone, PartialEq)]
pub struct Waves<const H: usize> {
    cosine: [[f64; H]; H],
    sine: [[f64; H]; H],
}

impl<const H: usize> Waves<H> {
    /// For this many angles per turn; `weight` is that of an angle, `harmonic` the harmonic at a place.
    fn new(
        angles: usize,
        weight: impl Fn(usize) -> f64,
        harmonic: impl Fn(usize) -> usize,
    ) -> Self {
        let wave = |c: usize| {
            std::array::from_fn(|k| {
                std::array::from_fn(|j| weight(j) * direction(harmonic(k) * j, angles)[c])
            })
        };
        Self { cosine: wave(0), sine: wave(1) }
    }
}

/// Adds a multiple of the values on the rings.
#[inline(always)]
fn add<const N: usize>(to: &mut [f64; N], factor: f64, from: &[f64; N]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to += factor * from;
    }
}

impl Plane {
    /// Cosine and sine series over half a turn, by sums and differences of angles symmetric about a quarter
    /// turn.
    #[inline(always)]
    fn series<const N: usize, const H: usize>(
        waves: &Waves<H>,
        field: &mut Field<N, H>,
        scale: f64,
    ) {
        const { assert!(H >= 5 && H % 4 == 1, "a multiple of eight angles a turn") }
        let quarter = (H - 1) / 2;
        let mut folded = *field;
        for j in 0..quarter {
            let other = H - 1 - j;
            for c in 0..2 {
                for i in 0..N {
                    let [a, b] = [field[j][c][i], field[other][c][i]];
                    (folded[j][c][i], folded[other][c][i]) = (a + b, a - b);
                }
            }
        }
        for (k, out) in field.iter_mut().enumerate() {
            let mut lines = [[0.0; N]; 2];
            let is_odd = k % 2 == 1;
            for j in 0..quarter {
                let [sum, difference] = [j, H - 1 - j];
                let [of_cosine, of_sine] =
                    if is_odd { [difference, sum] } else { [sum, difference] };
                add(&mut lines[0], waves.cosine[k][j], &folded[of_cosine][0]);
                add(&mut lines[1], waves.sine[k][j], &folded[of_sine][1]);
            }
            match is_odd {
                true => add(&mut lines[1], waves.sine[k][quarter], &folded[quarter][1]),
                false => add(&mut lines[0], waves.cosine[k][quarter], &folded[quarter][0]),
            }
            *out = lines.map(|line| line.map(|x| scale * x));
        }
    }
}

impl<const H: usize> Symmetry<H> for Plane {
    const ANGLES: usize = 2 * (H - 1);
    const MIRRORED: bool = true;
    const OPPOSITE: bool = false;
    type Waves = Waves<H>;

    fn waves() -> Self::Waves {
        let angles = <Self as Symmetry<H>>::ANGLES;
        Waves::new(angles, <Self as Symmetry<H>>::weight, |k| k)
    }

    #[inline(always)]
    fn to_harmonics<const N: usize>(waves: &Self::Waves, field: &mut Field<N, H>) {
        Self::series(waves, field, 1.0 / <Self as Symmetry<H>>::ANGLES as f64);
    }

    #[inline(always)]
    fn to_angles<const N: usize>(waves: &Self::Waves, field: &mut Field<N, H>) {
        Self::series(waves, field, 1.0);
    }

    #[inline(always)]
    fn blocks() -> usize {
        H
    }

    /// The block that is even under reflection.
    #[inline(always)]
    fn whole_block(block: usize) -> usize {
        match block {
            0 => 0,
            _ if block == H - 1 => 1,
            _ => 2 * block,
        }
    }

    #[inline(always)]
    fn places(block: usize) -> [(usize, usize); 2] {
        [(block, 0), (block, 1)]
    }

    #[inline(always)]
    fn weight(angle: usize) -> f64 {
        if angle == 0 || angle == H - 1 { 1.0 } else { 2.0 }
    }

    #[inline(always)]
    fn opposite(angle: usize) -> (usize, [f64; 2]) {
        (H - 1 - angle, [1.0, -1.0])
    }
}

impl<const H: usize> Symmetry<H> for AlikePlane {
    const ANGLES: usize = 4 * (H - 1);
    const MIRRORED: bool = true;
    const OPPOSITE: bool = true;
    type Waves = [Waves<H>; 2];

    fn waves() -> Self::Waves {
        // Transforms to odd harmonics, and from them to angles.
        let (angles, odd) = (<Self as Symmetry<H>>::ANGLES, |k: usize| 2 * k + 1);
        let to = Waves::new(angles, |j| <Self as Symmetry<H>>::weight(j) / angles as f64, odd);
        let from = Waves::new(angles, |_| 2.0, odd);
        [to, from]
    }

    #[inline(always)]
    fn to_harmonics<const N: usize>([to, _]: &Self::Waves, field: &mut Field<N, H>) {
        let mut lines = [[[0.0; N]; 2]; H];
        for (k, line) in lines.iter_mut().take(H - 1).enumerate() {
            for (j, from) in field.iter().enumerate() {
                add(&mut line[0], to.cosine[k][j], &from[0]);
                add(&mut line[1], to.sine[k][j], &from[1]);
            }
        }
        *field = lines;
    }

    #[inline(always)]
    fn to_angles<const N: usize>([_, from]: &Self::Waves, field: &mut Field<N, H>) {
        let mut lines = [[[0.0; N]; 2]; H];
        for (k, harmonic) in field.iter().take(H - 1).enumerate() {
            for (j, line) in lines.iter_mut().enumerate() {
                add(&mut line[0], from.cosine[k][j], &harmonic[0]);
                add(&mut line[1], from.sine[k][j], &harmonic[1]);
            }
        }
        *field = lines;
    }

    #[inline(always)]
    fn blocks() -> usize {
        H - 1
    }

    #[inline(always)]
    fn whole_block(block: usize) -> usize {
        2 * (2 * block + 1)
    }

    #[inline(always)]
    fn places(block: usize) -> [(usize, usize); 2] {
        [(block, 0), (block, 1)]
    }

    #[inline(always)]
    fn weight(angle: usize) -> f64 {
        if angle == 0 || angle == H - 1 { 2.0 } else { 4.0 }
    }

    /// Tractions are equal in space, hence opposite in polar axes.
    #[inline(always)]
    fn opposite(angle: usize) -> (usize, [f64; 2]) {
        (angle, [-1.0; 2])
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// A field with the symmetry on the whole turn, and its stored part.
    fn fields<const M: usize, const H: usize, S: Symmetry<H>>() -> [Vec<[[f64; 3]; 2]>; 2] {
        let odd = |k: usize| if S::OPPOSITE { 2 * k + 1 } else { k };
        let at = |j: usize| {
            let angle = 2.0 * PI * j as f64 / M as f64;
            let wave = |k: usize| odd(k) as f64 * angle;
            let sum = |of: &dyn Fn(usize) -> f64| (0..3).map(of).sum::<f64>();
            let radial = |i: usize| sum(&|k| (0.3 + (i * k) as f64) * libm::cos(wave(k)));
            let around = |i: usize| sum(&|k| (0.7 - (i + k) as f64) * libm::sin(wave(k)));
            [std::array::from_fn(radial), std::array::from_fn(around)]
        };
        [(0..M).map(at).collect(), (0..H).map(at).collect()]
    }

    fn check<const M: usize, const H: usize, S: Symmetry<H>>() {
        assert_eq!(M, S::ANGLES);
        let [whole, kept] = fields::<M, H, S>();
        let mut hat: Field<3, M> = std::array::from_fn(|j| whole[j]);
        Whole::to_harmonics(&<Whole as Symmetry<M>>::waves(), &mut hat);
        let before: Field<3, H> = std::array::from_fn(|j| kept[j]);
        let (waves, mut half) = (S::waves(), before);
        S::to_harmonics(&waves, &mut half);
        for block in 0..S::blocks() {
            let [(k, up), (mirror, down)] = parts::<M>(S::whole_block(block));
            let [one, two] = S::places(block);
            for i in 0..3 {
                // Mean and half the difference of the harmonics k and -k; the mean itself has no partner.
                let [a, b] =
                    [hat[k][up][i], if k == mirror { hat[k][up][i] } else { hat[mirror][down][i] }];
                let want = [0.5 * (a + b), 0.5 * (a - b)];
                let got = [half[one.0][one.1][i], half[two.0][two.1][i]];
                assert!((got[0] - want[0]).abs() < 1e-13 && (got[1] - want[1]).abs() < 1e-13);
            }
        }
        S::to_angles(&waves, &mut half);
        for (got, want) in half.as_flattened().iter().zip(before.as_flattened()) {
            assert!((0..3).all(|i| (got[i] - want[i]).abs() < 1e-13));
        }
        for (j, value) in before.iter().enumerate() {
            let (other, signs) = S::opposite(j);
            for c in 0..2 {
                let want = whole[(j + M / 2) % M][c][1];
                assert!((signs[c] * before[other][c][1] - want).abs() < 1e-13, "{value:?}");
            }
        }
        assert_eq!((0..H).map(S::weight).sum::<f64>(), M as f64);
    }

    #[test]
    fn kept_angles_have_the_harmonics_of_the_whole_turn() {
        check::<8, 5, Plane>();
        check::<16, 9, Plane>();
        check::<8, 3, AlikePlane>();
        check::<16, 5, AlikePlane>();
    }
}
