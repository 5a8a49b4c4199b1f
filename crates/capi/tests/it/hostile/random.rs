//! Where the hostile caller takes its choices from: a seed, or bytes that somebody chose.

/// A source of numbers.
pub(crate) enum Random {
    Seed(u64),
    /// All bytes, and how many were used. After the last one all are zero.
    Bytes(Vec<u8>, usize),
}

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        match self {
            Self::Seed(seed) => mixed(seed),
            Self::Bytes(..) => u64::from_le_bytes(self.bytes()),
        }
    }

    /// A whole number below `count`, which is at most 65536.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        match self {
            Self::Seed(seed) => (mixed(seed) % count as u64) as usize,
            Self::Bytes(..) => usize::from(u16::from_le_bytes(self.bytes())) % count,
        }
    }

    /// A number from 0 to below 1.
    pub(crate) fn unit(&mut self) -> f64 {
        match self {
            Self::Seed(seed) => (mixed(seed) >> 11) as f64 / (1_u64 << 53) as f64,
            Self::Bytes(..) => f64::from(u16::from_le_bytes(self.bytes())) / 65536.0,
        }
    }

    /// Whether all bytes were used; never of a seed.
    pub(crate) fn has_ended(&self) -> bool {
        matches!(self, Self::Bytes(bytes, used) if *used >= bytes.len())
    }

    fn bytes<const COUNT: usize>(&mut self) -> [u8; COUNT] {
        let Self::Bytes(bytes, used) = self else { return [0; COUNT] };
        let from = *used;
        *used += COUNT;
        std::array::from_fn(|i| bytes.get(from + i).copied().unwrap_or_default())
    }
}

fn mixed(seed: &mut u64) -> u64 {
    *seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *seed;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
