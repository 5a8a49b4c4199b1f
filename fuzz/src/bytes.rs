//! Choices and numbers from the bytes of the fuzzer.

/// The bytes that are left. After the last one all are zero.
pub struct Bytes<'a>(&'a [u8]);

/// Numbers at which formulas change or end.
const SPECIAL: [f64; 12] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    f64::MIN_POSITIVE,
    5e-324,
    1e60,
    -1e60,
    1.0,
    -1.0,
    f64::MAX,
];

impl<'a> Bytes<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// All that are left.
    pub fn rest(&self) -> &'a [u8] {
        self.0
    }

    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    /// A whole number below `count`, which is at most 256.
    pub fn pick(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count
    }

    /// A number of any bits.
    pub fn raw(&mut self) -> f64 {
        f64::from_le_bytes(std::array::from_fn(|_| self.byte()))
    }

    /// A number: most often of at most twice this size, now and then of another or of any bits.
    pub fn number(&mut self, size: f64) -> f64 {
        match self.byte() {
            0..=191 => {
                let fraction = i16::from_le_bytes([self.byte(), self.byte()]);
                size * f64::from(fraction) / 16384.0
            }
            192..=207 => 0.0,
            208..=231 => {
                let (power, sign) = (self.byte() as i8, self.byte());
                let number = size * 10_f64.powf(f64::from(power) / 8.0);
                if sign % 2 == 0 { number } else { -number }
            }
            232..=243 => SPECIAL[self.pick(SPECIAL.len())],
            _ => self.raw(),
        }
    }
}
