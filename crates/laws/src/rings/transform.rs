//! Harmonics about the normal of a field on rings and angles.

use std::f64::consts::PI;

/// Two components (radial and circumferential, or real and imaginary) on N rings at M angles.
pub(super) type Field<const N: usize, const M: usize> = [[[f64; N]; 2]; M];

/// Cosine and sine of angle j of `parts` equal parts of a turn.
pub(super) fn direction(j: usize, parts: usize) -> [f64; 2] {
    let j = j % parts;
    // Multiples of an eighth of a turn are exact.
    let eighths = 8 * j;
    let root = std::f64::consts::FRAC_1_SQRT_2;
    if eighths.is_multiple_of(parts) {
        let exact = [
            [1.0, 0.0],
            [root, root],
            [0.0, 1.0],
            [-root, root],
            [-1.0, 0.0],
            [-root, -root],
            [0.0, -1.0],
            [root, -root],
        ];
        return exact[eighths / parts];
    }
    let angle = 2.0 * PI * j as f64 / parts as f64;
    [libm::cos(angle), libm::sin(angle)]
}

/// Cosines and sines of the M angles.
pub(super) fn directions<const M: usize>() -> [[f64; 2]; M] {
    std::array::from_fn(|j| direction(j, M))
}

/// The discrete Fourier transform over the angles, in place, times a factor; `SIGN` is -1 forward, 1 back.
#[inline(always)]
pub(super) fn transform<const N: usize, const M: usize>(
    field: &mut Field<N, M>,
    directions: &[[f64; 2]; M],
    sign: f64,
) {
    const { assert!(M.is_power_of_two() && M >= 8, "angles by powers of two") }
    let bits = M.trailing_zeros();
    for j in 0..M {
        let other = j.reverse_bits() >> (usize::BITS - bits);
        if other > j {
            field.swap(j, other);
        }
    }
    let mut half = 1;
    while half < M {
        let stride = M / (2 * half);
        let mut start = 0;
        while start < M {
            for k in 0..half {
                let [c, s] = directions[k * stride];
                butterfly(field, start + k, half, [c, sign * s]);
            }
            start += 2 * half;
        }
        half *= 2;
    }
}

#[inline(always)]
fn butterfly<const N: usize, const M: usize>(
    field: &mut Field<N, M>,
    at: usize,
    half: usize,
    [c, s]: [f64; 2],
) {
    let ([re, im], [re_2, im_2]) = (field[at], field[at + half]);
    for i in 0..N {
        let turned_re = c * re_2[i] - s * im_2[i];
        let turned_im = c * im_2[i] + s * re_2[i];
        field[at][0][i] = re[i] + turned_re;
        field[at][1][i] = im[i] + turned_im;
        field[at + half][0][i] = re[i] - turned_re;
        field[at + half][1][i] = im[i] - turned_im;
    }
}

/// The places of the two components of block b: harmonic and component.
///
/// Block 0 has both components of the mean, block 1 those of the shortest wave. Each harmonic k with -k has
/// two further blocks: first the even one (real parts), then the odd one.
#[inline(always)]
pub(super) const fn parts<const M: usize>(block: usize) -> [(usize, usize); 2] {
    parts_of(M, block)
}

/// The same for a given number of angles.
#[inline(always)]
pub(super) const fn parts_of(angles: usize, block: usize) -> [(usize, usize); 2] {
    match block {
        0 => [(0, 0), (0, 1)],
        1 => [(angles / 2, 0), (angles / 2, 1)],
        _ => [(block / 2, block % 2), (angles - block / 2, block % 2)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_drawn::{Congruential, Draw as _};

    fn check<const M: usize>() {
        let directions = directions::<M>();
        let mut draw = Congruential(1);
        let mut random = || draw.part() - 0.5;
        let field: Field<3, M> = std::array::from_fn(|_| [[random(); 3], [random(); 3]]);
        let mut hat = field;
        transform(&mut hat, &directions, -1.0);
        for k in 0..M {
            let mut want = [0.0; 2];
            for (j, [re, im]) in field.iter().enumerate() {
                let [c, s] = directions[(j * k) % M];
                want[0] += c * re[0] + s * im[0];
                want[1] += c * im[0] - s * re[0];
            }
            assert!(
                (hat[k][0][0] - want[0]).abs() < 1e-13 && (hat[k][1][2] - want[1]).abs() < 1e-13
            );
        }
        transform(&mut hat, &directions, 1.0);
        for (got, want) in hat.iter().zip(&field) {
            assert!((got[0][1] / M as f64 - want[0][1]).abs() < 1e-14);
        }
    }

    #[test]
    fn harmonics_are_the_sums_they_stand_for() {
        check::<8>();
        check::<16>();
    }

    #[test]
    fn every_part_has_one_place() {
        let mut seen = [[0; 2]; 16];
        for block in 0..16 {
            for (k, c) in parts::<16>(block) {
                seen[k][c] += 1;
            }
        }
        assert_eq!(seen, [[1; 2]; 16]);
    }
}
