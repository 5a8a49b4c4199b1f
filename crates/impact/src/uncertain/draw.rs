//! Counter-based random numbers: each depends only on seed, sample and input, so that the order in which
//! threads ask for them does not matter.

/// A number in (0, 1) for input `input` of sample `sample`: the top 53 bits of the hash, at the middle of
/// their interval, so that neither end occurs.
pub(super) fn uniform(seed: u64, sample: u64, input: u64) -> f64 {
    let hash = mix(mix(mix(seed).wrapping_add(sample)).wrapping_add(input));
    ((hash >> 12) as f64 + 0.5) / (1u64 << 52) as f64
}

/// The step and finaliser of SplitMix64 (Steele, Lea and Flood 2014).
const fn mix(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_number_of_the_published_generator() {
        // SplitMix64 started at 1234567.
        assert_eq!(mix(1_234_567), 6_457_827_717_110_365_317);
    }

    #[test]
    fn draws_are_uniform_and_inputs_independent() {
        let count = 100_000;
        let pairs: Vec<(f64, f64)> =
            (0..count).map(|i| (uniform(7, i, 0), uniform(7, i, 1))).collect();
        let mean = |f: fn(&(f64, f64)) -> f64| pairs.iter().map(f).sum::<f64>() / count as f64;
        // Five standard errors each.
        assert!((mean(|p| p.0) - 0.5).abs() < 5.0 * 0.2887 / 316.0);
        assert!((mean(|p| p.0 * p.0) - 1.0 / 3.0).abs() < 5.0 * 0.298 / 316.0);
        assert!((mean(|p| (p.0 - 0.5) * (p.1 - 0.5))).abs() < 5.0 * 0.0833 / 316.0);
        assert!(pairs.iter().all(|p| p.0 > 0.0 && p.0 < 1.0));
    }
}
