//! What is drawn from a seed.

use carom_drawn::{Draw as _, Splitmix};

/// The numbers of a case.
pub(crate) fn of_case(seed: u64) -> Splitmix {
    Splitmix(seed.wrapping_mul(0xd6e8_feb8_6659_fd93))
}

/// A power of ten between two exponents.
pub(crate) fn power(draw: &mut Splitmix, low: f64, high: f64) -> f64 {
    libm::pow(10.0, draw.between(low, high))
}
