//! Sums over stencils, with the widest vectors of numbers that the processor has.

use pulp::{Arch, Simd, WithSimd};

/// Values in rows of a stride, and points.
pub(super) struct Sums<'a> {
    pub(super) points: &'a [u32],
    pub(super) values: &'a [f32],
    pub(super) stride: usize,
}

impl Sums<'_> {
    /// Adds to what is found for each point the sum over a stencil; `place` tells the stencil and where the value of its
    /// first number is stored.
    pub(super) fn add<'s, const R: usize, const W: usize>(
        self,
        place: impl Fn(usize) -> (&'s [[f32; W]; R], usize),
        found: &mut [f32],
    ) {
        Arch::new().dispatch(Added { sums: self, place, found });
    }
}

struct Added<'a, P> {
    sums: Sums<'a>,
    place: P,
    found: &'a mut [f32],
}

impl<'s, P, const R: usize, const W: usize> WithSimd for Added<'_, P>
where
    P: Fn(usize) -> (&'s [[f32; W]; R], usize),
{
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Sums { points, values, stride } = self.sums;
        for (at, found) in points.iter().zip(self.found) {
            let (stencil, first) = (self.place)(*at as usize);
            *found += sum(simd, stencil, &values[first..], stride);
        }
    }
}

/// The sum over a stencil. Its rows have up to three vectors of eight numbers.
#[inline(always)]
fn sum<S: Simd, const R: usize, const W: usize>(
    simd: S,
    stencil: &[[f32; W]; R],
    values: &[f32],
    stride: usize,
) -> f32 {
    let mut sums = [simd.splat_f32s(0.0); 24];
    for (row, values) in stencil.iter().zip(values.chunks(stride)) {
        let (factors, values) = (S::as_simd_f32s(row).0, S::as_simd_f32s(&values[..W]).0);
        for ((sum, factor), value) in sums.iter_mut().zip(factors).zip(values) {
            *sum = simd.mul_add_e_f32s(*factor, *value, *sum);
        }
    }
    let [first, rest @ ..] = sums;
    let rest = rest.iter().take(W / S::F32_LANES - 1);
    simd.reduce_sum_f32s(rest.fold(first, |sum, one| simd.add_f32s(sum, *one)))
}
