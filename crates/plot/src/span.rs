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
    /// Whether the values are whole numbers, such as steps, so that ticks are too.
    is_whole: bool,
    names: Vec<String>,
    period: Option<f64>,
    /// Whether the unit takes a prefix.
    takes_prefix: bool,
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
        let is_whole = high - low >= 2.0
            && values.clone().next().is_some()
            && values.clone().all(|value| value.fract() == 0.0);
        if axis.scale == Scale::Log
            && let Some(value) = values.chain([low]).find(|value| *value <= 0.0)
        {
            return Err(PlotError::NotPositive { label: axis.label.clone(), value });
        }
        if !(low.is_finite() && high.is_finite() && low < high) {
            return Err(PlotError::Limits { label: axis.label.clone(), low, high });
        }
        let (names, period) = (axis.names.clone(), axis.period);
        let takes_prefix = prefixed(&axis.label).is_some();
        Ok(Self { scale: axis.scale, low, high, is_whole, names, period, takes_prefix })
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

    /// The span of an axis over the nodes of a field, up to its `ends` if the axis has no limits.
    pub(crate) fn over(axis: &Axis, nodes: &[f64], ends: Limits) -> Result<Self, PlotError> {
        let axis = Axis { limits: axis.limits.or(Some(ends)), ..axis.clone() };
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
        Self { low: centre - half, high: centre + half, ..self.clone() }
    }

    /// Ticks, and the power of ten by which their labels are divided.
    pub(crate) fn ticks(&self) -> (Vec<Tick>, i32) {
        let power = self.power();
        match self.scale {
            Scale::Linear if !self.names.is_empty() => (self.named_ticks(), 0),
            Scale::Linear => (self.linear_ticks(power), power),
            Scale::Bare => (Vec::new(), 0),
            Scale::Log => match self.log_ticks() {
                ticks if ticks.len() < 2 => (self.linear_ticks(power), power),
                ticks => (ticks, 0),
            },
        }
    }

    /// The power of ten to take out of labels; a multiple of three.
    pub(crate) fn power(&self) -> i32 {
        let largest = self.low.abs().max(self.high.abs());
        let power = common_power(largest);
        // 10 mm rather than 0.010 m.
        if power == 0 && self.takes_prefix && largest < 0.1 { -3 } else { power }
    }

    /// Ticks with this power of ten taken out of their labels, if the axis is linear.
    pub(crate) fn ticks_with(&self, power: i32) -> (Vec<Tick>, i32) {
        match self.scale {
            Scale::Linear if self.names.is_empty() => (self.linear_ticks(power), power),
            _ => self.ticks(),
        }
    }

    /// The longest name below the axis; `None` if it has numbers.
    pub(crate) fn longest_name(&self) -> Option<&str> {
        self.names.iter().max_by_key(|name| name.chars().count()).map(String::as_str)
    }

    fn named_ticks(&self) -> Vec<Tick> {
        let ticks = self.names.iter().enumerate();
        let ticks = ticks.map(|(i, name)| Tick { at: i as f64 + 1.0, label: name.clone() });
        ticks.filter(|tick| self.holds(tick.at)).collect()
    }

    fn scaled(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Linear | Scale::Bare => value,
            Scale::Log => libm::log10(value),
        }
    }

    fn linear_ticks(&self, power: i32) -> Vec<Tick> {
        let length = self.high - self.low;
        let step = nice_step(length / 7.0);
        let step = match self.period {
            // Quarters, as far as there are three of them.
            Some(period) if length > 0.75 * period => 0.25 * period,
            _ if self.is_whole && step < 1.0 => 1.0,
            _ if self.is_whole && step == 2.5 => 5.0,
            _ => step,
        };
        let first = libm::ceil(self.low / step - 1e-9) as i64;
        let last = libm::floor(self.high / step + 1e-9) as i64;
        let unit = libm::pow(10.0, f64::from(power));
        let decimals = (-libm::floor(libm::log10(step / unit) + 1e-9)).max(0.0) as usize;
        let decimals = decimals + usize::from(needs_one_more(step / unit, decimals));
        let tick = |i: i64| {
            let at = i as f64 * step;
            Tick { at, label: minus(format!("{:.decimals$}", at / unit + 0.0)) }
        };
        (first..=last).map(tick).collect()
    }

    fn log_ticks(&self) -> Vec<Tick> {
        let (low, high) = (self.scaled(self.low), self.scaled(self.high));
        let (first, last) = (libm::floor(low) as i32, libm::ceil(high) as i32);
        let stride = ((last - first) / 8).max(1) as usize;
        let multiples: &[f64] = if high - low < 2.2 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let value = |(power, multiple): (i32, f64)| multiple * libm::pow(10.0, f64::from(power));
        let places: Vec<(i32, f64)> = (first..=last)
            .step_by(stride)
            .flat_map(|power| multiples.iter().map(move |m| (power, *m)))
            .filter(|place| self.holds(value(*place)))
            .collect();
        // All labels of an axis have one style.
        let is_plain = places.iter().all(|(power, _)| (-3..=3).contains(power));
        let label = if is_plain { plain_label } else { power_label };
        let tick = |place: &(i32, f64)| Tick { at: value(*place), label: label(*place) };
        places.iter().map(tick).collect()
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

/// `0.002`
fn plain_label((power, multiple): (i32, f64)) -> String {
    let decimals = (-power).max(0) as usize;
    format!("{:.decimals$}", multiple * libm::pow(10.0, f64::from(power)))
}

/// `2·10⁻³`
fn power_label((power, multiple): (i32, f64)) -> String {
    if multiple == 1.0 {
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

/// Units that take a prefix, with the power to which the prefix counts.
const PREFIXED: [(&str, i32); 11] = [
    ("m", 1),
    ("N", 1),
    ("Pa", 1),
    ("J", 1),
    ("W", 1),
    ("s", 1),
    ("rad", 1),
    ("N m", 1),
    ("m/s", 1),
    ("N/m", 1),
    ("m²", 2),
];
const PREFIXES: [(i32, &str); 8] =
    [(-12, "p"), (-9, "n"), (-6, "µ"), (-3, "m"), (3, "k"), (6, "M"), (9, "G"), (12, "T")];

/// Name, unit and power of the unit of a label whose unit takes a prefix.
fn prefixed(label: &str) -> Option<(&str, &str, i32)> {
    let (name, unit) = label.rsplit_once(" / ")?;
    let (_, exponent) = PREFIXED.iter().find(|(own, _)| *own == unit)?;
    Some((name, unit, *exponent))
}

/// A label with the power of ten that was taken out of the numbers beside it: `x / m` becomes `x / µm`
/// where the unit takes a prefix.
pub(crate) fn with_power(label: &str, power: i32) -> String {
    if power == 0 {
        return label.to_owned();
    }
    let prefixed = prefixed(label).and_then(|(name, unit, exponent)| {
        let wanted = |(own, _): &&(i32, &str)| own * exponent == power;
        let (_, prefix) = PREFIXES.iter().find(wanted)?;
        // Longer and slower, not bigger: lengths and times grow by powers of ten only.
        let is_odd = power > 3 && ["m", "s", "rad", "m/s"].contains(&unit);
        (!is_odd).then(|| format!("{name} / {prefix}{unit}"))
    });
    prefixed.unwrap_or_else(|| format!("{label}  (× {})", power_of_ten(power)))
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
    fn units_that_take_a_prefix_have_whole_numbers() {
        let (ticks, power) = labels(&Axis::linear("x / m").between(0.0, 0.01));
        assert_eq!((ticks.join(" ").as_str(), power), ("0 2 4 6 8 10", -3));
        assert_eq!(with_power("x / m", power), "x / mm");
        let (ticks, power) = labels(&Axis::linear("x / m").between(0.0, 0.5));
        assert_eq!((ticks.join(" ").as_str(), power), ("0.0 0.1 0.2 0.3 0.4 0.5", 0));
        // A number without a unit stays as it is.
        assert_eq!(labels(&Axis::linear("R_x").between(0.0, 0.01)).1, 0);
    }

    #[test]
    fn logarithmic_ticks_are_decades() {
        let (ticks, _) = labels(&Axis::log("").between(1e-5, 10.0));
        assert_eq!(ticks.join(" "), "10⁻⁵ 10⁻⁴ 10⁻³ 10⁻² 10⁻¹ 10⁰ 10¹");
        let (ticks, _) = labels(&Axis::log("").between(2e-4, 2e-3));
        assert_eq!(ticks.join(" "), "2·10⁻⁴ 5·10⁻⁴ 10⁻³ 2·10⁻³");
        let (ticks, _) = labels(&Axis::log("").between(0.1, 10.0));
        assert_eq!(ticks.join(" "), "0.1 0.2 0.5 1 2 5 10");
    }

    #[test]
    fn ticks_of_whole_numbers_are_whole() {
        let ticks = |values: &[f64]| {
            let span = Span::fit(&Axis::linear("step"), values.iter().copied()).unwrap();
            let (ticks, _) = span.ticks();
            ticks.into_iter().map(|tick| tick.label).collect::<Vec<_>>().join(" ")
        };
        assert_eq!(ticks(&[1.0, 2.0, 3.0]), "1 2 3");
        assert_eq!(ticks(&[0.0, 10.0]), "0 2 4 6 8 10");
        assert_eq!(ticks(&[1.0, 2.5, 3.0]), "1.0 1.5 2.0 2.5 3.0");
        assert_eq!(ticks(&[0.0, 16.0, 17.0]), "0 5 10 15");
    }

    #[test]
    fn angles_have_ticks_at_quarters() {
        let axis = Axis::linear("").repeating(360.0);
        let ticks = |low, high| labels(&axis.clone().between(low, high)).0.join(" ");
        assert_eq!(ticks(-181.0, 179.0), "−180 −90 0 90");
        assert_eq!(ticks(0.0, 360.0), "0 90 180 270 360");
        assert_eq!(ticks(0.0, 100.0), "0 20 40 60 80 100");
    }

    #[test]
    fn names_stand_at_whole_numbers() {
        let (ticks, power) = labels(&Axis::named("", ["steel", "glass", "rubber"]));
        assert_eq!((ticks.join(" ").as_str(), power), ("steel glass rubber", 0));
        let span = Span::fit(&Axis::named("", ["a", "b"]), std::iter::empty()).unwrap();
        assert_eq!([1.0, 2.0].map(|at| span.place(at)), [0.25, 0.75]);
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
