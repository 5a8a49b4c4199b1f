//! Where the table of creep coefficients has its entries: Chebyshev's points in the logarithm of
//! the axis ratio and in Poisson's ratio, ends included.

use std::f64::consts::PI;

/// The least and the greatest axis ratio a/b, inverse to each other.
pub const AXIS_RATIOS: [f64; 2] = [0.05, 20.0];
/// The least and the greatest Poisson's ratio.
pub const POISSONS: [f64; 2] = [0.0, 0.5];
/// Number of axis ratios.
pub const ROWS: usize = 25;
/// Number of Poisson's ratios.
pub const COLUMNS: usize = 7;

/// The axis ratios of the table.
///
/// ```
/// let ratios = carom_laws::creep::nodes::axis_ratios();
/// assert_eq!((ratios[0], ratios[12], ratios[24]), (0.05, 1.0, 20.0));
/// ```
#[must_use]
pub fn axis_ratios() -> [f64; ROWS] {
    let [least, most] = AXIS_RATIOS;
    points().map(|place| match place {
        -1.0 => least,
        1.0 => most,
        place => libm::pow(most, place),
    })
}

/// The Poisson's ratios of the table.
///
/// ```
/// let ratios = carom_laws::creep::nodes::poissons();
/// assert_eq!((ratios[0], ratios[3], ratios[6]), (0.0, 0.25, 0.5));
/// ```
#[must_use]
pub fn poissons() -> [f64; COLUMNS] {
    let [least, most] = POISSONS;
    points().map(|place| least + 0.5 * (most - least) * (1.0 + place))
}

/// The place of an axis ratio between -1 and 1.
pub(super) fn of_axis_ratio(ratio: f64) -> f64 {
    libm::log(ratio) / libm::log(AXIS_RATIOS[1])
}

/// The place of a Poisson's ratio between -1 and 1.
pub(super) fn of_poisson(poisson: f64) -> f64 {
    let [least, most] = POISSONS;
    2.0 * (poisson - least) / (most - least) - 1.0
}

/// Chebyshev's points from -1 to 1, symmetric to the last digit.
pub(super) fn points<const N: usize>() -> [f64; N] {
    let last = N - 1;
    // The sine of an angle from the middle.
    std::array::from_fn(|i| {
        let from_middle = 2.0 * i as f64 - last as f64;
        libm::sin(0.5 * PI * from_middle / last as f64)
    })
}
