//! Adaptive bisection with the 21-point Gauss-Kronrod pair.

use super::{Integral, QuadratureError, Tolerance, check_bounds, finite};

/// Greatest number of subintervals.
const MOST_PIECES: usize = 400;
/// After so many halvings that leave the value but not the error, and, beyond [`FIRST_HALVINGS`], so many that increase
/// the error, it is round-off.
const MOST_IDLE_HALVINGS: u32 = 6;
const MOST_WORSE_HALVINGS: u32 = 20;
const FIRST_HALVINGS: usize = 10;
/// A halving leaves the value if it changes by less, relative; and the error if more than this part remains.
const SAME_VALUE: f64 = 1e-5;
const SAME_ERROR: f64 = 0.99;

/// Kronrod nodes in (0, 1), descending, with the Kronrod weight and the weight of the embedded
/// 10-point Gauss rule (0 where it has no node). Source: QUADPACK, recomputed to 20 digits.
const PAIRS: [[f64; 3]; 10] = [
    [0.995_657_163_025_808_08, 0.011_694_638_867_371_874_278, 0.0],
    [0.973_906_528_517_171_72, 0.032_558_162_307_964_727_479, 0.066_671_344_308_688_137_594],
    [0.930_157_491_355_708_226, 0.054_755_896_574_351_996_031, 0.0],
    [0.865_063_366_688_984_511, 0.075_039_674_810_919_952_767, 0.149_451_349_150_580_593_15],
    [0.780_817_726_586_416_897, 0.093_125_454_583_697_605_535, 0.0],
    [0.679_409_568_299_024_406, 0.109_387_158_802_297_641_9, 0.219_086_362_515_982_044],
    [0.562_757_134_668_604_683, 0.123_491_976_262_065_851_08, 0.0],
    [0.433_395_394_129_247_191, 0.134_709_217_311_473_325_93, 0.269_266_719_309_996_355_09],
    [0.294_392_862_701_460_198, 0.142_775_938_577_060_080_8, 0.0],
    [0.148_874_338_981_631_211, 0.147_739_104_901_338_491_37, 0.295_524_224_714_752_870_17],
];

/// The Kronrod weight of the central node.
const MIDDLE: f64 = 0.149_445_554_002_916_905_66;

/// The integral of `function` from `lower` to `upper`. The subinterval with the largest estimated
/// error is halved until the sum of the estimates meets the tolerance.
///
/// The estimate is QUADPACK's, from the difference of the 21-point Kronrod and the 10-point Gauss
/// rule; it never falls below the rounding error of the sums, about 1e-14 of the integral of |f|.
/// Halving ends when it does not reduce the error any more: the integrand then has round-off above
/// the tolerance. Nothing is allocated on the heap.
///
/// Source: R. Piessens and others, QUADPACK (1983), algorithm QAG.
///
/// # Errors
/// [`QuadratureError`] if a bound or the integrand is not finite, or if the tolerance is not met
/// with 400 subintervals, or cannot be because of round-off. It then has the value and its error.
///
/// ```
/// use carom_special::quadrature::{Tolerance, adaptive};
/// let peak = adaptive(-1.0, 1.0, Tolerance::relative(1e-12)?, |x| 1e-3 / (x * x + 1e-6))?;
/// assert!((peak.value / (2.0 * 1e3_f64.atan()) - 1.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn adaptive(
    lower: f64,
    upper: f64,
    tolerance: Tolerance,
    mut function: impl FnMut(f64) -> f64,
) -> Result<Integral, QuadratureError> {
    check_bounds(lower, upper)?;
    let whole = Piece::over(lower, upper, &mut function)?;
    let integral = total(&[whole]);
    if tolerance.allows(integral) {
        return Ok(integral);
    }
    let mut pieces = [Piece::default(); MOST_PIECES];
    pieces[0] = whole;
    let (mut count, mut halvings) = (1, Halvings::default());
    loop {
        let integral = total(&pieces[..count]);
        if tolerance.allows(integral) {
            return Ok(integral);
        }
        let worst = largest_error(&pieces[..count]);
        let whole = pieces[worst];
        let Piece { lower, upper, .. } = whole;
        let middle = 0.5 * (lower + upper);
        if count == MOST_PIECES || middle == lower || middle == upper || halvings.are_idle() {
            return Err(QuadratureError::NotConverged { integral });
        }
        pieces[worst] = Piece::over(lower, middle, &mut function)?;
        pieces[count] = Piece::over(middle, upper, &mut function)?;
        halvings.add(whole, [pieces[worst], pieces[count]], count);
        count += 1;
    }
}

/// How many halvings did not reduce the error: QUADPACK's test of round-off.
#[derive(Default)]
struct Halvings {
    idle: u32,
    worse: u32,
}

impl Halvings {
    /// Counts a halving, after `before` others and the first rule.
    fn add(&mut self, whole: Piece, halves: [Piece; 2], before: usize) {
        if halves.iter().any(|half| !half.is_resolved) {
            return;
        }
        let value: f64 = halves.iter().map(|half| half.value).sum();
        let error: f64 = halves.iter().map(|half| half.error).sum();
        let leaves_value = (whole.value - value).abs() <= SAME_VALUE * value.abs();
        self.idle += u32::from(leaves_value && error >= SAME_ERROR * whole.error);
        self.worse += u32::from(before >= FIRST_HALVINGS && error > whole.error);
    }

    fn are_idle(&self) -> bool {
        self.idle >= MOST_IDLE_HALVINGS || self.worse >= MOST_WORSE_HALVINGS
    }
}

#[derive(Clone, Copy, Default)]
struct Piece {
    lower: f64,
    upper: f64,
    value: f64,
    error: f64,
    /// Whether the estimate is below the spread of the integrand, which is its greatest value.
    is_resolved: bool,
}

impl Piece {
    fn over(
        lower: f64,
        upper: f64,
        function: &mut impl FnMut(f64) -> f64,
    ) -> Result<Self, QuadratureError> {
        let (middle, half) = (0.5 * (lower + upper), 0.5 * (upper - lower));
        let mut at = |x: f64| finite(function(x), x);
        let centre = at(middle)?;
        let (mut kronrod, mut gauss) = (MIDDLE * centre, 0.0);
        let mut size = MIDDLE * centre.abs();
        let mut values = [[0.0; 2]; PAIRS.len()];
        for (pair, value) in PAIRS.iter().zip(&mut values) {
            let [node, kronrod_weight, gauss_weight] = *pair;
            let [left, right] = [at(middle - half * node)?, at(middle + half * node)?];
            *value = [left, right];
            kronrod += kronrod_weight * (left + right);
            gauss += gauss_weight * (left + right);
            size += kronrod_weight * (left.abs() + right.abs());
        }
        let mean = 0.5 * kronrod;
        let mut spread = MIDDLE * (centre - mean).abs();
        for ([_, weight, _], [left, right]) in PAIRS.iter().zip(&values) {
            spread += weight * ((left - mean).abs() + (right - mean).abs());
        }
        let error = estimate(kronrod - gauss, spread, size);
        let is_resolved = error != spread;
        Ok(Self { lower, upper, value: kronrod * half, error: error * half.abs(), is_resolved })
    }
}

/// QUADPACK's estimate from the difference of both rules, for a half-width of 1.
fn estimate(difference: f64, spread: f64, size: f64) -> f64 {
    let difference = difference.abs();
    let mut error = difference;
    if spread > 0.0 && difference > 0.0 {
        let ratio = 200.0 * difference / spread;
        error = spread * (ratio * ratio.sqrt()).min(1.0);
    }
    error.max(50.0 * f64::EPSILON * size)
}

fn total(pieces: &[Piece]) -> Integral {
    let value = pieces.iter().map(|piece| piece.value).sum();
    let error = pieces.iter().map(|piece| piece.error).sum();
    let halvings = pieces.len() - 1;
    Integral { value, error, evaluations: (2 * halvings + 1) * (2 * PAIRS.len() + 1) }
}

fn largest_error(pieces: &[Piece]) -> usize {
    let mut worst = 0;
    for (i, piece) in pieces.iter().enumerate() {
        if piece.error > pieces[worst].error {
            worst = i;
        }
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tolerance(relative: f64) -> Tolerance {
        Tolerance::relative(relative).expect("tolerance")
    }

    #[test]
    fn smooth_kinked_and_singular() -> Result<(), QuadratureError> {
        let sine = adaptive(0.0, 10.0, tolerance(1e-12), libm::sin)?;
        assert!((sine.value - (1.0 - libm::cos(10.0))).abs() <= sine.error, "{sine:?}");
        let kink = adaptive(0.0, 1.0, tolerance(1e-10), |x| (x - 0.3).abs())?;
        assert!((kink.value - 0.29).abs() <= kink.error + 1e-16, "{kink:?}");
        let root = adaptive(0.0, 1.0, tolerance(1e-8), f64::sqrt)?;
        assert!((root.value - 2.0 / 3.0).abs() <= root.error, "{root:?}");
        let polynomial = adaptive(1.0, -1.0, tolerance(1e-13), |x| libm::pow(x, 18.0))?;
        assert!((polynomial.value + 2.0 / 19.0).abs() < 1e-16 && polynomial.evaluations == 21);
        Ok(())
    }

    #[test]
    fn tolerance_below_rounding_is_an_error_with_the_value() {
        match adaptive(0.0, 1.0, tolerance(1e-18), libm::exp) {
            Err(QuadratureError::NotConverged { integral }) => {
                assert!((integral.value - 1.718_281_828_459_045).abs() < 1e-14);
            }
            other => panic!("{other:?}"),
        }
        let pole = adaptive(-1.0, 1.0, tolerance(1e-9), |x| 1.0 / x);
        assert_eq!(pole, Err(QuadratureError::Undefined { position: 0.0 }));
    }

    /// It took all 400 subintervals.
    #[test]
    fn round_off_of_the_integrand_ends_the_halvings() {
        // 1e4 is lost again: an error of 1e-12 in each value, another for each argument.
        let noisy = |x: f64| (libm::exp(x) + 1e4) - 1e4;
        match adaptive(0.0, 1.0, tolerance(1e-14), noisy) {
            Err(QuadratureError::NotConverged { integral }) => {
                let error = (integral.value - (std::f64::consts::E - 1.0)).abs();
                assert!(error < 1e-11 && integral.error < 1e-9, "{integral:?}");
                assert!(integral.evaluations < 2000, "{integral:?}");
            }
            other => panic!("{other:?}"),
        }
    }
}
