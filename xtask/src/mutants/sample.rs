//! A sample of the list, the same for the same seed.

use crate::cargo;

/// Draws `count` of the numbers, keeping their order.
pub(super) fn draw(mut numbers: Vec<usize>, count: usize, seed: u64) -> Vec<usize> {
    let mut state = seed;
    while numbers.len() > count {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let drawn = mixed(state) % numbers.len() as u64;
        numbers.remove(drawn as usize);
    }
    numbers
}

/// The splitmix64 generator.
fn mixed(state: u64) -> u64 {
    let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A seed that changes with the commit; 0 without a history.
pub(crate) fn seed_of_commit() -> u64 {
    let commit = cargo::git(&["rev-parse", "HEAD"]);
    commit.ok().and_then(|commit| u64::from_str_radix(commit.get(..8)?, 16).ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_depends_on_the_seed_alone() {
        let all: Vec<usize> = (1..=100).collect();
        let one = draw(all.clone(), 20, 3);
        assert_eq!(one.len(), 20);
        assert!(one.is_sorted());
        assert_eq!(one, draw(all.clone(), 20, 3));
        assert_ne!(one, draw(all.clone(), 20, 4));
        assert_eq!(draw(all.clone(), 200, 3), all);
    }
}
