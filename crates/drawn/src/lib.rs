//! Numbers for tests, drawn from a seed and the same in every run.
//!
//! Thresholds of tests are tuned to the numbers they draw: none of the three sequences may change.
//!
//! ```
//! use carom_drawn::{Draw as _, Splitmix};
//! let mut draw = Splitmix(7);
//! let friction = draw.between(0.1, 0.5);
//! assert!((0.1..0.5).contains(&friction));
//! assert_eq!(friction, Splitmix(7).between(0.1, 0.5));
//! ```
#![forbid(unsafe_code)]

/// A sequence of numbers.
pub trait Draw {
    /// The next 64 bits.
    fn bits(&mut self) -> u64;

    /// From 0 to below 1, of the upper 53 bits.
    fn part(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// From -1 to below 1.
    fn signed(&mut self) -> f64 {
        2.0 * self.part() - 1.0
    }

    /// Between two numbers.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.part()
    }

    /// Between two positive numbers, evenly by the logarithm.
    fn log_between(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.part())
    }

    /// Either -1 or 1.
    fn sign(&mut self) -> f64 {
        if self.part() < 0.5 { -1.0 } else { 1.0 }
    }

    /// A whole number below `count`.
    fn below(&mut self, count: usize) -> usize {
        (self.part() * count as f64) as usize
    }

    /// One of these.
    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// The sequence without its first numbers.
    #[must_use]
    fn after(mut self, count: usize) -> Self
    where
        Self: Sized,
    {
        for _ in 0..count {
            self.bits();
        }
        self
    }
}

/// Knuth's linear congruential generator. Its lower bits have short periods.
#[derive(Debug, Clone)]
pub struct Congruential(
    /// The seed.
    pub u64,
);

impl Draw for Congruential {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        self.0
    }
}

/// Marsaglia's xorshift by 13, 7 and 17, from a seed other than 0.
#[derive(Debug, Clone)]
pub struct Xorshift(
    /// The seed.
    pub u64,
);

impl Draw for Xorshift {
    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
}

/// Steele's splitmix64, whose sequences of neighbouring seeds are unlike.
#[derive(Debug, Clone)]
pub struct Splitmix(
    /// The seed.
    pub u64,
);

impl Draw for Splitmix {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bits that a test names, one after the other.
    struct Given(Vec<u64>);

    impl Draw for Given {
        fn bits(&mut self) -> u64 {
            self.0.remove(0)
        }
    }

    fn first<const N: usize>(mut draw: impl Draw) -> [u64; N] {
        std::array::from_fn(|_| draw.bits())
    }

    /// As published with the generator, for the seed 1234567.
    #[test]
    fn splitmix_has_its_published_numbers() {
        let published = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        assert_eq!(first(Splitmix(1_234_567)), published);
    }

    /// The seed of Marsaglia's paper and its first number; then shifts as products and quotients.
    #[test]
    fn xorshift_is_that_of_products_in_128_bits() {
        let mut x = 88_172_645_463_325_252_u128;
        assert_eq!(first(Xorshift(x as u64)), [8_748_534_153_485_358_512_u64]);
        for found in first::<100>(Xorshift(x as u64)) {
            x ^= x * (1 << 13) % (1 << 64);
            x ^= x / (1 << 7);
            x ^= x * (1 << 17) % (1 << 64);
            assert_eq!(u128::from(found), x);
        }
    }

    #[test]
    fn the_congruential_one_is_the_product_in_128_bits() {
        let mut x = 5_u128;
        for found in first::<100>(Congruential(5)) {
            x = (6_364_136_223_846_793_005 * x + 1_442_695_040_888_963_407) % (1 << 64);
            assert_eq!(u128::from(found), x);
        }
    }

    #[test]
    fn the_least_and_the_greatest_bits_stay_in_the_ranges() {
        let ends = || Given(vec![0, u64::MAX]);
        let both = |of: fn(&mut Given) -> f64| {
            let mut draw = ends();
            [of(&mut draw), of(&mut draw)]
        };
        let below_1 = 1.0 - 0.5 * f64::EPSILON;
        assert_eq!(both(Draw::part), [0.0, below_1]);
        assert_eq!(both(Draw::signed), [-1.0, 1.0 - f64::EPSILON]);
        assert_eq!(both(Draw::sign), [-1.0, 1.0]);
        assert_eq!(both(|draw| draw.between(3.0, 5.0)), [3.0, 3.0 + 2.0 * below_1]);
        let [low, high] = both(|draw| draw.log_between(1e-3, 10.0));
        assert!(low == 1e-3 && (high / 10.0 - 1.0).abs() < 1e-14, "{low} {high}");
        let mut draw = ends();
        assert_eq!([draw.below(7), draw.below(7)], [0, 6]);
        let mut draw = ends();
        assert_eq!([draw.pick(b"abc"), draw.pick(b"abc")], *b"ac");
    }

    /// Both ways to write a number from -1 to 1 have the same bits.
    #[test]
    fn signed_is_rounded_once() {
        for bits in first::<1000>(Splitmix(1)) {
            let other = (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0;
            assert_eq!(Given(vec![bits]).signed().to_bits(), other.to_bits());
        }
    }

    #[test]
    fn first_numbers_can_be_left_out() {
        let [_, _, third] = first(Congruential(3));
        assert_eq!(first(Congruential(3).after(2)), [third]);
    }
}
