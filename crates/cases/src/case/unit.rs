//! Units. A quantity is a plain number in its base unit, or a text with one of the other units, such as `"380
//! GPa"`.

use super::range::Range;

/// What a number measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// Nothing: a pure number.
    None,
    /// A length.
    Length,
    /// A mass.
    Mass,
    /// A mass in a volume.
    Density,
    /// A modulus of elasticity.
    Pressure,
    /// A force.
    Force,
    /// A torque.
    Torque,
    /// A stiffness against bending or torsion: force times area.
    Rigidity,
    /// A velocity.
    Speed,
    /// The inverse of a velocity.
    PerSpeed,
    /// An angular velocity.
    Spin,
    /// An acceleration.
    Acceleration,
    /// A time.
    Time,
    /// A moment of inertia.
    Inertia,
    /// An angle, in degrees if given as a plain number.
    Degrees,
    /// An angle, in radians if given as a plain number.
    Radians,
    /// An angle per length, in radians if given as a plain number.
    PerLength,
}

/// Conversion of a unit to the base unit.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Scale {
    /// A power of ten: exact, since it shifts the decimal exponent of the text.
    Ten(i32),
    /// A factor.
    Times(f64),
}
use Scale::{Ten, Times};

/// Longest number with a unit, in characters.
const MOST_LETTERS: usize = 100;
const DEGREE: f64 = std::f64::consts::PI / 180.0;
const TURN: f64 = std::f64::consts::TAU;

impl Dimension {
    /// All units, the base unit first. Micro may also be written `u` and `µ`, powers also as superscripts.
    const fn units(self) -> &'static [(&'static str, Scale)] {
        match self {
            Self::None => &[],
            Self::Length => &[
                ("m", Ten(0)),
                ("km", Ten(3)),
                ("cm", Ten(-2)),
                ("mm", Ten(-3)),
                ("um", Ten(-6)),
                ("nm", Ten(-9)),
            ],
            Self::Mass => {
                &[("kg", Ten(0)), ("t", Ten(3)), ("g", Ten(-3)), ("mg", Ten(-6)), ("ug", Ten(-9))]
            }
            Self::Density => &[
                ("kg/m3", Ten(0)),
                ("g/cm3", Ten(3)),
                ("kg/dm3", Ten(3)),
                ("t/m3", Ten(3)),
                ("g/m3", Ten(-3)),
            ],
            Self::Pressure => &[
                ("Pa", Ten(0)),
                ("kPa", Ten(3)),
                ("MPa", Ten(6)),
                ("GPa", Ten(9)),
                ("TPa", Ten(12)),
                ("bar", Ten(5)),
                ("N/m2", Ten(0)),
                ("N/mm2", Ten(6)),
                ("kN/mm2", Ten(9)),
            ],
            Self::Force => &[
                ("N", Ten(0)),
                ("kN", Ten(3)),
                ("MN", Ten(6)),
                ("mN", Ten(-3)),
                ("uN", Ten(-6)),
                ("nN", Ten(-9)),
            ],
            Self::Torque => {
                &[("N m", Ten(0)), ("kN m", Ten(3)), ("N mm", Ten(-3)), ("mN m", Ten(-3))]
            }
            Self::Rigidity => {
                &[("N m2", Ten(0)), ("kN m2", Ten(3)), ("MN m2", Ten(6)), ("N mm2", Ten(-6))]
            }
            Self::Speed => &[
                ("m/s", Ten(0)),
                ("km/s", Ten(3)),
                ("cm/s", Ten(-2)),
                ("mm/s", Ten(-3)),
                ("um/s", Ten(-6)),
                ("km/h", Times(1.0 / 3.6)),
            ],
            Self::PerSpeed => &[("s/m", Ten(0)), ("ms/m", Ten(-3)), ("s/mm", Ten(3))],
            Self::Spin => &[
                ("rad/s", Ten(0)),
                ("deg/s", Times(DEGREE)),
                ("rpm", Times(TURN / 60.0)),
                ("1/min", Times(TURN / 60.0)),
                ("rev/s", Times(TURN)),
            ],
            Self::Acceleration => &[("m/s2", Ten(0)), ("cm/s2", Ten(-2)), ("mm/s2", Ten(-3))],
            Self::Time => &[
                ("s", Ten(0)),
                ("ms", Ten(-3)),
                ("us", Ten(-6)),
                ("ns", Ten(-9)),
                ("min", Times(60.0)),
            ],
            Self::Inertia => &[
                ("kg m2", Ten(0)),
                ("kg cm2", Ten(-4)),
                ("kg mm2", Ten(-6)),
                ("g cm2", Ten(-7)),
                ("g mm2", Ten(-9)),
            ],
            Self::Degrees => {
                &[("deg", Ten(0)), ("rad", Times(1.0 / DEGREE)), ("rev", Times(360.0))]
            }
            Self::PerLength => &[
                ("rad/m", Ten(0)),
                ("1/m", Ten(0)),
                ("rad/mm", Ten(3)),
                ("1/mm", Ten(3)),
                ("deg/m", Times(DEGREE)),
            ],
            Self::Radians => {
                &[("rad", Ten(0)), ("mrad", Ten(-3)), ("deg", Times(DEGREE)), ("rev", Times(TURN))]
            }
        }
    }

    /// The base unit; empty for a pure number.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self.units() {
            [(name, _), ..] => name,
            [] => "",
        }
    }

    /// The names of all units, the base unit first.
    pub(super) fn unit_names(self) -> impl Iterator<Item = &'static str> {
        self.units().iter().map(|(name, _)| *name)
    }

    /// The number in the base unit; none if the text is not a number with a unit of this dimension.
    #[must_use]
    pub fn read(self, text: &str) -> Option<f64> {
        if let "inf" | "+inf" | "-inf" = text.trim() {
            return text.trim().parse().ok();
        }
        let (number, unit) = split(text)?;
        let (_, scale) = self.units().iter().find(|(name, _)| *name == unit)?;
        scale.apply(number)
    }

    /// What is allowed for a number in `range`, in words.
    #[must_use]
    pub fn allowed(self, range: Range) -> String {
        let range = range.allowed();
        let units: Vec<&str> = self.unit_names().collect();
        match units.as_slice() {
            [] => format!("a number, {range}"),
            [plain, ..] => format!(
                "a number, {range}, plain in {plain} or as a text with a unit of {}",
                units.join(", ")
            ),
        }
    }
}

impl Dimension {
    /// What may be meant by a text that is not read: a decimal comma, a plain number, a unit in other letters, a
    /// percentage, or a unit that is not of SI.
    pub(super) fn meant(self, text: &str) -> String {
        if text.len() > MOST_LETTERS {
            return String::new();
        }
        if let Some(decimal) = pointed(text) {
            return format!("; {text} has a decimal comma, write a point: {decimal}");
        }
        if text.trim().parse::<f64>().is_ok() {
            return format!("; write {} without quotation marks", text.trim());
        }
        let Some((number, unit)) = split(text) else { return String::new() };
        if let ("%", Self::None, Ok(percent)) = (unit.as_str(), self, number.parse::<f64>()) {
            return format!("; {number} % is {}", percent / 100.0);
        }
        let mut alike = self.unit_names().filter(|name| name.eq_ignore_ascii_case(&unit));
        match (alike.next(), alike.next()) {
            (Some(name), None) => format!("; did you mean \"{number} {name}\"?"),
            _ => self.converted(number, &unit),
        }
    }
}

impl Scale {
    fn apply(self, number: &str) -> Option<f64> {
        let value: f64 = number.parse().ok()?;
        match self {
            Times(factor) => Some(value * factor),
            Ten(_) if !value.is_finite() => Some(value),
            Ten(power) => {
                let (digits, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
                let exponent = exponent.parse::<i32>().ok()?.checked_add(power)?;
                format!("{digits}e{exponent}").parse().ok()
            }
        }
    }
}

/// The text with points in place of decimal commas; none if it has none.
pub(super) fn pointed(text: &str) -> Option<String> {
    let is_digit = |letter: Option<&char>| letter.is_some_and(char::is_ascii_digit);
    let letters: Vec<char> = text.chars().collect();
    let is_decimal = |at: usize| {
        letters[at] == ',' && is_digit(letters[..at].last()) && is_digit(letters.get(at + 1))
    };
    let point = |at: usize| if is_decimal(at) { '.' } else { letters[at] };
    let decimal: String = (0..letters.len()).map(point).collect();
    (decimal != text).then_some(decimal)
}

/// Splits a text into its number and its unit, in the spelling of the table.
fn split(text: &str) -> Option<(&str, String)> {
    let text = text.trim();
    if text.len() > MOST_LETTERS {
        return None;
    }
    let mut ends = text.char_indices().map(|(at, _)| at).chain([text.len()]);
    // The longest number: the e in 1e3 m belongs to it.
    let end = ends.rfind(|end| text[..*end].trim_end().parse::<f64>().is_ok())?;
    let unit = text[end..].trim().replace(['µ', 'μ'], "u").replace('°', "deg");
    let unit = unit.replace('²', "2").replace('³', "3").replace('^', "").replace(['·', '*'], " ");
    Some((text[..end].trim_end(), unit))
}

/// The range and the dimension of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Measure {
    /// The range, in the base unit.
    pub range: Range,
    /// The dimension.
    pub dimension: Dimension,
}

impl Range {
    /// The range of a quantity with a unit.
    #[must_use]
    pub const fn of(self, dimension: Dimension) -> Measure {
        Measure { range: self, dimension }
    }

    /// The range of a pure number.
    #[must_use]
    pub const fn pure(self) -> Measure {
        self.of(Dimension::None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_in_other_letters_and_a_percentage_are_understood() {
        assert_eq!(Dimension::Pressure.meant("208 Gpa"), "; did you mean \"208 GPa\"?");
        // Milli or mega?
        assert_eq!(Dimension::Force.meant("3 Mn"), "");
        assert_eq!(Dimension::None.meant("20 %"), "; 20 % is 0.2");
        assert_eq!(Dimension::Length.meant("20 %"), "");
        assert_eq!(Dimension::Length.meant("ten mm"), "");
        let comma = Dimension::Length.meant("2,5 mm");
        assert_eq!(comma, "; 2,5 mm has a decimal comma, write a point: 2.5 mm");
        assert_eq!(Dimension::Length.meant("0.3"), "; write 0.3 without quotation marks");
    }

    #[test]
    fn texts_with_units_are_the_numbers_they_stand_for() {
        for (dimension, text, value) in [
            (Dimension::Pressure, "380 GPa", 380e9),
            (Dimension::Pressure, "2.1e2GPa", 210e9),
            (Dimension::Pressure, "70 kN/mm²", 70e9),
            (Dimension::Length, "2.5 mm", 0.0025),
            (Dimension::Length, "0.3 mm", 0.0003),
            (Dimension::Length, " -7 µm ", -7e-6),
            (Dimension::Length, "7 μm", 7e-6),
            (Dimension::Length, "1e3m", 1e3),
            (Dimension::Length, "inf m", f64::INFINITY),
            (Dimension::Length, "-inf", f64::NEG_INFINITY),
            (Dimension::None, "inf", f64::INFINITY),
            (Dimension::Mass, "5 g", 0.005),
            (Dimension::Mass, "5e-1 t", 500.0),
            (Dimension::Density, "7.85 g/cm^3", 7850.0),
            (Dimension::Spin, "3000 rpm", 100.0 * std::f64::consts::PI),
            (Dimension::Spin, "180 deg/s", std::f64::consts::PI),
            (Dimension::Degrees, "30 deg", 30.0),
            (Dimension::Degrees, "30°", 30.0),
            (Dimension::Radians, "90 deg", std::f64::consts::FRAC_PI_2),
            (Dimension::Speed, "36 km/h", 10.0),
            (Dimension::PerSpeed, "2 s/mm", 2000.0),
            (Dimension::Inertia, "12 g·cm²", 12e-7),
            (Dimension::Acceleration, "9.81 m/s^2", 9.81),
            (Dimension::Torque, "3 N·mm", 0.003),
            (Dimension::Rigidity, "3e6 N·mm²", 3.0),
        ] {
            let read = dimension.read(text);
            let is_close = |read: f64| (read - value).abs() <= 4e-16 * value.abs();
            assert!(read.is_some_and(|read| read == value || is_close(read)), "{text}: {read:?}");
        }
        assert_eq!(Dimension::Length.read("0.3 mm"), Some(0.0003), "to the last digit");
    }

    #[test]
    fn wrong_units_and_no_numbers_are_none() {
        for (dimension, text) in [
            (Dimension::Length, "2.5 kg"),
            (Dimension::Length, "2.5"),
            (Dimension::Length, "2,5 mm"),
            (Dimension::Length, "mm"),
            (Dimension::Length, ""),
            (Dimension::Length, "2 MM"),
            (Dimension::Length, "2 m m"),
            (Dimension::Length, "1e m"),
            (Dimension::Pressure, "380 gpa"),
            (Dimension::None, "0.3"),
            (Dimension::None, "30 %"),
        ] {
            assert_eq!(dimension.read(text), None, "{text}");
        }
    }
}
