//! The precision in which products are computed.

use carom_fourier::Transformed;

use super::pool;
use super::threads::Threads;
use super::workspace::{Space, Workspace};

/// The number type of transforms: `f64`, or `f32` where a relative error of 1e-6 does not matter, in half the time on
/// large grids. Fields are `f64` always.
pub(crate) trait Real: Transformed + Default {
    /// Columns transformed together: so many complex numbers fill two cache lines of each row.
    const BLOCK: usize;

    fn of(value: f64) -> Self;

    fn to(self) -> f64;

    /// The unit in which inputs are given to the transforms.
    fn unit(inputs: &[&[f64]], threads: Threads) -> f64;

    /// The unit of a spectrum with a greatest value.
    fn unit_of_spectrum(greatest: f64) -> f64;

    /// The buffers of this precision.
    fn space(workspace: &mut Workspace) -> &mut Space<Self>;
}

impl Real for f64 {
    const BLOCK: usize = 8;

    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn to(self) -> f64 {
        self
    }

    fn unit(_inputs: &[&[f64]], _threads: Threads) -> f64 {
        1.0
    }

    fn unit_of_spectrum(_greatest: f64) -> f64 {
        1.0
    }

    fn space(workspace: &mut Workspace) -> &mut Space<Self> {
        &mut workspace.double
    }
}

/// Fields whose greatest value is below this lose digits.
const LEAST_UNIT: f64 = 1e-290;

/// So many values are searched on one thread.
const SHARE: usize = 8192;

/// The greatest size of some values, without branches and several at once, in vector registers.
fn greatest(values: &[f64]) -> f64 {
    const AT_ONCE: usize = 8;
    let larger = |most: f64, value: f64| if value.abs() > most { value.abs() } else { most };
    let mut most = [0.0; AT_ONCE];
    let mut chunks = values.chunks_exact(AT_ONCE);
    for some in &mut chunks {
        most.iter_mut().zip(some).for_each(|(most, value)| *most = larger(*most, *value));
    }
    most.iter().chain(chunks.remainder()).copied().fold(0.0, larger)
}

impl Real for f32 {
    const BLOCK: usize = 16;

    #[inline(always)]
    fn of(value: f64) -> Self {
        value as Self
    }

    #[inline(always)]
    fn to(self) -> f64 {
        f64::from(self)
    }

    /// The greatest value, because `f32` has a small range.
    fn unit(inputs: &[&[f64]], threads: Threads) -> f64 {
        let of = |input: &&[f64]| match threads {
            Threads::One => greatest(input),
            Threads::Pool => pool::greatest(input, SHARE, greatest),
        };
        inputs.iter().map(of).fold(LEAST_UNIT, f64::max)
    }

    fn unit_of_spectrum(greatest: f64) -> f64 {
        greatest
    }

    fn space(workspace: &mut Workspace) -> &mut Space<Self> {
        &mut workspace.single
    }
}

#[cfg(test)]
mod tests {
    use super::super::Preconditioner;
    use super::super::torus::TorusInverse;
    use super::*;
    use crate::{Grid, Material, MaterialPair};

    /// In any of several fields, in any part of it, of either sign and however small.
    #[test]
    fn the_unit_is_the_greatest_value_wherever_it_is() {
        let on_both = |inputs: &[&[f64]]| {
            let one = f32::unit(inputs, Threads::One);
            assert_eq!(f32::unit(inputs, Threads::Pool), one);
            one
        };
        for count in [1, 7, 8, 21, SHARE, 3 * SHARE + 5] {
            let small: Vec<f64> = (0..count).map(|i| 1e-200 * (0.7 * i as f64).sin()).collect();
            for at in [0, count / 3, count / 2, 4 * count / 5, count - 1] {
                for greatest in [2e-200, -2e-200, -3.0] {
                    let mut field = small.clone();
                    field[at] = greatest;
                    assert_eq!(on_both(&[&field]), greatest.abs(), "{count} {at}");
                    assert_eq!(on_both(&[&small, &field]), greatest.abs(), "{count} {at}");
                }
            }
        }
        assert_eq!(on_both(&[&[0.0; 9]]), LEAST_UNIT);
    }

    /// Bodies 2^160 times as stiff, beyond the range of `f32`, have tractions 2^160 times as great.
    #[test]
    fn any_stiffness_is_in_the_range_of_single_precision() {
        let grid = Grid::new(12, 10, 0.1, 0.2).unwrap();
        let displacement: Vec<f64> = (0..grid.cells()).map(|i| (1.7 * i as f64).sin()).collect();
        let pressures = |stiffer: f64| {
            let body = Material::from_shear(1.5 * stiffer, 0.3).unwrap();
            let pair = MaterialPair::new(body, body).unwrap();
            let mut pressure = vec![0.0; grid.cells()];
            let inverse = TorusInverse::<f32>::new(&pair, grid, Threads::One);
            inverse.pressure(&displacement, &mut pressure, &mut Workspace::default());
            pressure
        };
        let usual = pressures(1.0);
        assert!(usual.iter().any(|pressure| *pressure > 0.0));
        for stiffer in [2.0_f64.powi(160), 2.0_f64.powi(-160)] {
            let scaled: Vec<f64> = usual.iter().map(|pressure| stiffer * pressure).collect();
            assert_eq!(pressures(stiffer), scaled);
        }
    }
}
