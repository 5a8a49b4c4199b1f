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
