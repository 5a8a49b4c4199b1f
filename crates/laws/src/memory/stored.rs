//! Memories of vertices over the depth as plain numbers: the form that they share.

use std::array::from_fn;

use carom_special::RangeError;

use super::{Lateral, MemoryRegime};
use crate::bounds::in_memory;
use crate::stored::{Check, Reader, Writer, any};

/// The greatest number of vertices that the first number can represent.
const MOST: usize = 99;

const REGIMES: [MemoryRegime; 7] = [
    MemoryRegime::Separated,
    MemoryRegime::Adhesion,
    MemoryRegime::Release,
    MemoryRegime::Slip,
    MemoryRegime::Reversal,
    MemoryRegime::Overlay,
    MemoryRegime::Sliding,
];

impl MemoryRegime {
    /// Number of regimes.
    pub(crate) const COUNT: u8 = REGIMES.len() as u8;
}

/// What is stored before the vertices, after a mark.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Head<V> {
    pub(crate) regime: MemoryRegime,
    pub(crate) zeta: f64,
    pub(crate) shift: V,
    /// What only this memory has.
    pub(crate) own: [f64; 2],
}

/// The form of a memory whose vertices are a depth and K vectors.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Form<const K: usize> {
    /// The first number is `1e4 version + 100 regime + vertices`: 1 is that of [`crate::coulomb`], 2 that of
    /// [`super::Memory`], 3 that of a contact without friction, 4 that of one without slip, 5 that of a twist.
    pub(crate) version: f64,
    /// The range of what follows the shift.
    pub(crate) range: Check,
    /// Whether an annulus may be thinner than rounding, and the sign of its depth says more.
    pub(crate) is_thin: bool,
}

impl<const K: usize> Form<K> {
    /// Mark, approach, shift, and two more.
    const HEAD: usize = 6;
    const EACH: usize = 1 + 2 * K;
    const ALLOWED: &str = ">= 6, and 5 per vertex (9 without slip), of which at most 99";

    pub(crate) const fn numbers(vertices: usize) -> usize {
        Self::HEAD + Self::EACH * vertices
    }

    /// Writes a memory of these vertices; the rest of the numbers is zero.
    pub(crate) fn write<V: Lateral>(
        &self,
        numbers: &mut [f64],
        head: Head<V>,
        vertices: impl ExactSizeIterator<Item = (f64, [V; K])>,
    ) -> Result<(), RangeError> {
        let len = vertices.len();
        let room = if len <= MOST { Self::numbers(len) } else { usize::MAX };
        let mut writer = Writer::new(numbers, room, Self::ALLOWED)?;
        writer.write(&[1e4 * self.version + 100.0 * f64::from(head.regime as u8) + len as f64]);
        writer.write(&[head.zeta]);
        writer.write(&head.shift.components());
        writer.write(&head.own);
        for (depth, vectors) in vertices {
            writer.write(&[depth]);
            vectors.iter().for_each(|vector| writer.write(&vector.components()));
        }
        writer.rest().fill(0.0);
        Ok(())
    }

    /// Reads what was written, if its depths rise from 0 to the approach and there are at most `capacity` vertices:
    /// [`Form::vertices`] takes the rest. All zeros are two separated bodies.
    pub(crate) fn read<'a, V: Lateral>(
        &self,
        numbers: &'a [f64],
        capacity: usize,
    ) -> Result<(Head<V>, &'a [f64]), RangeError> {
        let mut reader = Reader::new(numbers, Self::ALLOWED);
        let [first] = reader.read("mark", any)?;
        let mark = if first == 0.0 { 1e4 * self.version } else { first };
        let rest = mark - 1e4 * self.version;
        let (regime, len) = ((rest / 100.0).floor(), rest.rem_euclid(100.0));
        let known = (0.0..f64::from(MemoryRegime::COUNT)).contains(&regime) && len == len.floor();
        RangeError::check("mark", mark, known, "that of a state of this law")?;
        let holds = len as usize <= capacity;
        RangeError::check("vertices", len, holds, "not above the room for them")?;
        let [zeta] = reader.read("approach", in_memory)?;
        let shift = V::from_components(reader.read("shift", in_memory)?);
        let own = reader.read("numbers", self.range)?;
        let vertices = reader.part(Self::EACH * len as usize)?;
        vertices.iter().try_for_each(|number| (self.range)("numbers", *number).map(|_| ()))?;
        let mut below = -1.0;
        for (depth, _) in Self::vertices::<V>(vertices) {
            let rises = match self.is_thin {
                _ if below < 0.0 => depth == 0.0,
                true => depth.abs() >= below && depth.abs() <= zeta,
                false => depth > below && depth < zeta,
            };
            RangeError::check("depth", depth, rises, "rising from 0 to the approach")?;
            below = depth.abs();
        }
        RangeError::check("approach", zeta, (zeta > 0.0) == (len > 0.0), "> 0 in contact")?;
        Ok((Head { regime: REGIMES[regime as usize], zeta, shift, own }, vertices))
    }

    /// Depth and vectors of the vertices that were read.
    pub(crate) fn vertices<V: Lateral>(
        stored: &[f64],
    ) -> impl DoubleEndedIterator<Item = (f64, [V; K])> + Clone {
        stored.chunks_exact(Self::EACH).map(|vertex| {
            let (depth, vectors) = vertex.split_first().unwrap_or((&0.0, &[]));
            let pairs = vectors.as_chunks().0;
            (*depth, from_fn(|k| V::from_components(pairs[k])))
        })
    }
}
