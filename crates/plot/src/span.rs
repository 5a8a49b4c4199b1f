//! The span of an axis: positions of values on it, and its ticks.

use crate::error::PlotError;
use crate::panel::{Axis, Limits, Scale};

/// Fraction of the span left free beyond the data on either side.
const MARGIN: f64 = 0.04;

/// An axis with its limits fixed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Span {
    scale: Scale,
    low: f64,
    high: f64,
}

/// A labelled position on an axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    /// Value on the axis.
    pub(crate) at: f64,
    /// Its label.
    pub(crate) label: String,
}

impl Span {
    /// The span that `axis` prescribes, or one that contains all `values`.
    pub(crate) fn fit(
        axis: &Axis,
        values: impl Iterator<Item = f64> + Clone,
    ) -> Result<Self, PlotError> {
        let limits = match axis.limits {
            Some(limits) => limits,
            None => fitted(axis.scale, values.clone()).ok_or(PlotError::Empty)?,
        };
        let Limits { low, high } = limits;
        if axis.scale == Scale::Log
            && let Some(value) = values.chain([low]).find(|value| *value <= 0.0)
        {
            return Err(PlotError::NotPositive { label: axis.label.clone(), value });
        }
        if !(low.is_finite() && high.is_finite() && low < high) {
            return Err(PlotError::Limits { label: axis.label.clone(), low, high });
        }
        Ok(Self { scale: axis.scale, low, high })
    }

    /// The position of `value`: 0 at the lower end, 1 at the upper.
    pub(crate) fn place(&self, value: f64) -> f64 {
        let (low, high) = (self.scaled(self.low), self.scaled(self.high));
        (self.scaled(value) - low) / (high - low)
    }

    /// The value at the position `part` of a linear axis.
    pub(crate) fn value(&self, part: f64) -> f64 {
        self.low + part * (self.high - self.low)
    }

    /// The span from the first to the last node of a grid, if the axis has no limits.
    pub(crate) fn over(axis: &Axis, nodes: &[f64]) -> Result<Self, PlotError> {
        let limits = match nodes {
            [low, .., high] => Some(Limits { low: *low, high: *high }),
            _ => None,
        };
        let axis = Axis { limits: axis.limits.or(limits), ..axis.clone() };
        Self::fit(&axis, nodes.iter().copied())
    }

    /// Whether `value` lies between the ends, up to round-off.
    pub(crate) fn holds(&self, value: f64) -> bool {
        (-1e-9..=1.0 + 1e-9).contains(&self.place(value))
    }

    /// Length in the units of the scale.
    pub(crate) fn length(&self) -> f64 {
        self.scaled(self.high) - self.scaled(self.low)
    }

    /// The same centre with `factor` times the length; linear scales only.
    pub(crate) fn stretched(&self, factor: f64) -> Self {
        if self.scale == Scale::Log {
            return self.clone();
        }
        let (centre, half) = (0.5 * (self.low + self.high), 0.5 * (self.high - self.low) * factor);
        Self { scale: self.scale, low: centre - half, high: centre + half }
    }

    /// Ticks, and the power of ten by which their labels are divided.
    pub(crate) fn ticks(&self) -> (Vec<Tick>, i32) {
        match self.scale {
            Scale::Linear => self.linear_ticks(),
            Scale::Bare => (Vec::new(), 0),
            Scale::Log => {
                let ticks = self.log_ticks();
                if ticks.len() < 2 { self.linear_ticks() } else { (ticks, 0) }
            }
        }
    }

    fn scaled(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear | Scale::Bare => value,
            Scale::Log => libm::log10(value),
        }
    }

    fn linear_ticks(&self) -> (Vec<Tick>, i32) {
        let step = nice_step((self.high - self.low) / 7.0);
        let first = libm::ceil(self.low / step - 1e-9) as i64;
        let last = libm::floor(self.high / step + 1e-9) as i64;
        let largest = self.low.abs().max(self.high.abs());
        let power = common_power(largest);
        let unit = libm::pow(10.0, f64::from(power));
        let decimals = (-libm::floor(libm::log10(step / unit) + 1e-9)).max(0.0) as usize;
        let decimals = decimals + usize::from(needs_one_more(step / unit, decimals));
        let ticks = (first..=last)
            .map(|i| {
                let at = i as f64 * step;
                Tick { at, label: minus(format!("{:.decimals$}", at / unit + 0.0)) }
            })
            .collect();
        (ticks, power)
    }

    fn log_ticks(&self) -> Vec<Tick> {
        let (low, high) = (self.scaled(self.low), self.scaled(self.high));
        let (first, last) = (libm::floor(low) as i32, libm::ceil(high) as i32);
        let stride = ((last - first) / 8).max(1) as usize;
        let multiples: &[f64] = if high - low < 2.2 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        (first..=last)
            .step_by(stride)
            .flat_map(|power| multiples.iter().map(move |m| (power, *m)))
            .map(|(power, multiple)| Tick {
                at: multiple * libm::pow(10.0, f64::from(power)),
                label: log_label(power, multiple),
            })
            .filter(|tick| self.holds(tick.at))
            .collect()
    }
}

fn fitted(scale: Scale, values: impl Iterator<Item = f64>) -> Option<Limits> {
    let (low, high) = values
        .map(|value| (value, value))
        .reduce(|(low, high), (value, _)| (low.min(value), high.max(value)))?;
    if scale == Scale::Log {
        let ratio = if low == high { 10.0 } else { libm::pow(high / low, MARGIN) };
        return Some(Limits { low: low / ratio, high: high * ratio });
    }
    let size = low.abs().max(high.abs());
    let length = high - low;
    // Values that differ only by rounding are drawn as one.
    let margin = match length > 1e-9 * size {
        true => MARGIN * length,
        false if size > 0.0 => 0.5 * size,
        false => 1.0,
    };
    Some(Limits { low: low - margin, high: high + margin })
}

/// The next of 1, 2, 2.5, 5 times a power of ten.
fn nice_step(step: f64) -> f64 {
    let power = libm::pow(10.0, libm::floor(libm::log10(step)));
    let nice = [1.0, 2.0, 2.5, 5.0].into_iter().find(|nice| *nice * power >= step * 0.999);
    nice.unwrap_or(10.0) * power
}

fn needs_one_more(step: f64, decimals: usize) -> bool {
    let shifted = step * libm::pow(10.0, decimals as f64);
    (shifted - libm::round(shifted)).abs() > 1e-6
}

/// The power of ten to take out of labels up to `largest`; a multiple of three.
fn common_power(largest: f64) -> i32 {
    let power = libm::floor(libm::log10(largest)) as i32;
    if (-2..4).contains(&power) { 0 } else { power.div_euclid(3) * 3 }
}

fn log_label(power: i32, multiple: f64) -> String {
    if (-3..=3).contains(&power) {
        let decimals = (-power).max(0) as usize;
        format!("{:.decimals$}", multiple * libm::pow(10.0, f64::from(power)))
    } else if multiple == 1.0 {
        power_of_ten(power)
    } else {
        format!("{multiple}·{}", power_of_ten(power))
    }
}

/// `10ⁿ` with a raised exponent.
pub(crate) fn power_of_ten(power: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let exponent: String = power
        .to_string()
        .chars()
        .map(|c| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]))
        .collect();
    format!("10{exponent}")
}

/// Replaces the hyphen by a minus sign.
fn minus(label: String) -> String {
    label.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> (Vec<String>, i32) {
        let (ticks, power) = Span::fit(axis, std::iter::empty()).unwrap().ticks();
        (ticks.into_iter().map(|tick| tick.label).collect(), power)
    }

    #[test]
    fn linear_ticks_are_round() {
        let (ticks, power) = labels(&Axis::linear("").between(0.0, 1.0));
        assert_eq!((ticks.join(" ").as_str(), power), ("0.0 0.2 0.4 0.6 0.8 1.0", 0));
        let (ticks, _) = labels(&Axis::linear("").between(-0.06, 0.09));
        assert_eq!(ticks.join(" "), "−0.050 −0.025 0.000 0.025 0.050 0.075");
        let (ticks, power) = labels(&Axis::linear("").between(0.0, 3e-6));
        assert_eq!((ticks.join(" ").as_str(), power), ("0.0 0.5 1.0 1.5 2.0 2.5 3.0", -6));
    }

    #[test]
    fn logarithmic_ticks_are_decades() {
        let (ticks, _) = labels(&Axis::log("").between(1e-5, 10.0));
        assert_eq!(ticks.join(" "), "10⁻⁵ 10⁻⁴ 0.001 0.01 0.1 1 10");
        let (ticks, _) = labels(&Axis::log("").between(0.1, 10.0));
        assert_eq!(ticks.join(" "), "0.1 0.2 0.5 1 2 5 10");
    }

    #[test]
    fn the_span_holds_its_values() {
        let axis = Axis::linear("");
        for values in [[1.0, 2.0], [5.0, 5.0], [0.0, 0.0], [-1e-300, 1e-300], [1.0, 1.0 + 1e-15]] {
            let span = Span::fit(&axis, values.into_iter()).unwrap();
            assert!(values.into_iter().all(|value| span.holds(value)), "{values:?}");
        }
    }

    #[test]
    fn bad_limits_are_named() {
        let empty = std::iter::empty::<f64>;
        assert!(matches!(
            Span::fit(&Axis::linear("x").between(1.0, 1.0), empty()),
            Err(PlotError::Limits { .. })
        ));
        assert!(matches!(
            Span::fit(&Axis::log("x"), [1.0, 0.0].into_iter()),
            Err(PlotError::NotPositive { value: 0.0, .. })
        ));
        assert_eq!(Span::fit(&Axis::linear("x"), empty()), Err(PlotError::Empty));
    }
}
