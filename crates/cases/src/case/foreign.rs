//! Units that cases do not read: those of inch and pound, and older ones. Messages tell what they are in the base unit.

use super::unit::Dimension;

const INCH: f64 = 0.0254;
const FOOT: f64 = 0.3048;
const POUND: f64 = 0.453_592_37;
const GRAVITY: f64 = 9.806_65;
/// The force of a pound, and of a kilogram.
const LBF: f64 = POUND * GRAVITY;
const PSI: f64 = LBF / (INCH * INCH);
const HOUR: f64 = 3600.0;
/// Digits of a converted number after the first.
const DIGITS: usize = 9;

impl Dimension {
    /// Other units and their value in the base unit.
    const fn foreign(self) -> &'static [(&'static str, f64)] {
        match self {
            Self::Length => &[
                ("in", INCH),
                ("inch", INCH),
                ("inches", INCH),
                ("\"", INCH),
                ("ft", FOOT),
                ("foot", FOOT),
                ("feet", FOOT),
                ("mil", 1e-3 * INCH),
                ("thou", 1e-3 * INCH),
                ("yd", 3.0 * FOOT),
            ],
            Self::Mass => &[
                ("lb", POUND),
                ("lbs", POUND),
                ("lbm", POUND),
                ("oz", POUND / 16.0),
                ("slug", LBF / FOOT),
            ],
            Self::Density => &[
                ("lb/in3", POUND / (INCH * INCH * INCH)),
                ("lb/ft3", POUND / (FOOT * FOOT * FOOT)),
            ],
            Self::Pressure => &[
                ("psi", PSI),
                ("ksi", 1e3 * PSI),
                ("Msi", 1e6 * PSI),
                ("atm", 101_325.0),
                ("kgf/mm2", 1e6 * GRAVITY),
                ("kgf/cm2", 1e4 * GRAVITY),
            ],
            Self::Force => &[
                ("lbf", LBF),
                ("lb", LBF),
                ("lbs", LBF),
                ("kip", 1e3 * LBF),
                ("kgf", GRAVITY),
                ("dyn", 1e-5),
            ],
            Self::Torque => &[
                ("lbf in", LBF * INCH),
                ("in lbf", LBF * INCH),
                ("lbf ft", LBF * FOOT),
                ("ft lbf", LBF * FOOT),
                ("kgf m", GRAVITY),
            ],
            Self::Rigidity => &[("lbf in2", LBF * INCH * INCH), ("lbf ft2", LBF * FOOT * FOOT)],
            Self::Speed => &[
                ("in/s", INCH),
                ("ips", INCH),
                ("ft/s", FOOT),
                ("fps", FOOT),
                ("mph", 5280.0 * FOOT / HOUR),
                ("kn", 1852.0 / HOUR),
            ],
            Self::Acceleration => &[("in/s2", INCH), ("ft/s2", FOOT), ("g", GRAVITY)],
            Self::Time => &[("h", HOUR)],
            Self::Inertia => &[("lb in2", POUND * INCH * INCH), ("lb ft2", POUND * FOOT * FOOT)],
            Self::None
            | Self::PerSpeed
            | Self::Spin
            | Self::Degrees
            | Self::Radians
            | Self::PerLength => &[],
        }
    }

    /// What a number with another unit is in the base unit, and what to write; empty for an unknown one.
    pub(super) fn converted(self, number: &str, unit: &str) -> String {
        let is_it = |(name, _): &&(&str, f64)| name.eq_ignore_ascii_case(unit);
        match (number.parse::<f64>(), self.foreign().iter().find(is_it)) {
            (Ok(number), Some((name, factor))) if number.is_finite() => {
                let [one, all] = [*factor, number * factor].map(rounded);
                format!("; 1 {name} is {one} {}: write {all}", self.unit())
            }
            _ => String::new(),
        }
    }
}

/// A number without the digits that a conversion leaves.
fn rounded(number: f64) -> String {
    let rounded: f64 = format!("{number:.DIGITS$e}").parse().unwrap_or(number);
    let text = format!("{rounded:?}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_inch_and_pound_are_told_in_the_base_unit() {
        for (dimension, text, told) in [
            (Dimension::Length, "3 in", "; 1 in is 0.0254 m: write 0.0762"),
            (Dimension::Length, "3\"", "; 1 \" is 0.0254 m: write 0.0762"),
            (Dimension::Length, "2 mil", "; 1 mil is 2.54e-5 m: write 5.08e-5"),
            (Dimension::Pressure, "30e3 ksi", "; 1 ksi is 6894757.293 Pa: write 206842718800"),
            (Dimension::Pressure, "30 KSI", "; 1 ksi is 6894757.293 Pa: write 206842718.8"),
            (
                Dimension::Density,
                "0.284 lb/in^3",
                "; 1 lb/in3 is 27679.90471 kg/m3: write 7861.092938",
            ),
            (Dimension::Mass, "1 lb", "; 1 lb is 0.45359237 kg: write 0.45359237"),
            (Dimension::Force, "1 lb", "; 1 lb is 4.448221615 N: write 4.448221615"),
            (Dimension::Torque, "10 lbf·ft", "; 1 lbf ft is 1.355817948 N m: write 13.55817948"),
            (Dimension::Speed, "60 mph", "; 1 mph is 0.44704 m/s: write 26.8224"),
            (Dimension::Acceleration, "1 g", "; 1 g is 9.80665 m/s2: write 9.80665"),
            (Dimension::Length, "3 psi", ""),
            (Dimension::None, "3 in", ""),
        ] {
            assert_eq!(dimension.meant(text), told, "{text}");
        }
    }

    /// Appendix B of NIST Special Publication 811, to its seven digits; other words for a unit follow it.
    const PUBLISHED: [(Dimension, &str, f64); 33] = [
        (Dimension::Length, "in|inch|inches|\"", 2.54e-2),
        (Dimension::Length, "ft|foot|feet", 3.048e-1),
        (Dimension::Length, "mil|thou", 2.54e-5),
        (Dimension::Length, "yd", 9.144e-1),
        (Dimension::Mass, "lb|lbs|lbm", 4.535_924e-1),
        (Dimension::Mass, "oz", 2.834_952e-2),
        (Dimension::Mass, "slug", 14.593_90),
        (Dimension::Density, "lb/in3", 2.767_990e4),
        (Dimension::Density, "lb/ft3", 16.018_46),
        (Dimension::Pressure, "psi", 6.894_757e3),
        (Dimension::Pressure, "ksi", 6.894_757e6),
        (Dimension::Pressure, "Msi", 6.894_757e9),
        (Dimension::Pressure, "atm", 1.013_25e5),
        (Dimension::Pressure, "kgf/mm2", 9.806_65e6),
        (Dimension::Pressure, "kgf/cm2", 9.806_65e4),
        (Dimension::Force, "lbf|lb|lbs", 4.448_222),
        (Dimension::Force, "kip", 4.448_222e3),
        (Dimension::Force, "kgf", 9.806_65),
        (Dimension::Force, "dyn", 1e-5),
        (Dimension::Torque, "lbf in|in lbf", 1.129_848e-1),
        (Dimension::Torque, "lbf ft|ft lbf", 1.355_818),
        (Dimension::Torque, "kgf m", 9.806_65),
        (Dimension::Rigidity, "lbf in2", 2.869_815e-3),
        (Dimension::Rigidity, "lbf ft2", 4.132_533e-1),
        (Dimension::Speed, "in/s|ips", 2.54e-2),
        (Dimension::Speed, "ft/s|fps", 3.048e-1),
        (Dimension::Speed, "mph", 4.4704e-1),
        (Dimension::Speed, "kn", 5.144_444e-1),
        (Dimension::Acceleration, "in/s2", 2.54e-2),
        (Dimension::Acceleration, "ft/s2", 3.048e-1),
        (Dimension::Inertia, "lb in2", 2.926_397e-4),
        (Dimension::Inertia, "lb ft2", 4.214_011e-2),
        (Dimension::Time, "h", 3600.0),
    ];

    #[test]
    fn each_unit_has_its_published_value() {
        for (dimension, names, published) in PUBLISHED {
            for name in names.split('|') {
                let own = dimension.foreign().iter().find(|(own, _)| *own == name);
                let value = own.map_or(f64::NAN, |(_, value)| *value);
                assert!((value / published - 1.0).abs() < 3e-7, "{name}: {value}");
            }
        }
    }

    #[test]
    fn no_unit_is_both_read_and_refused() {
        for dimension in [
            Dimension::Length,
            Dimension::Mass,
            Dimension::Density,
            Dimension::Pressure,
            Dimension::Force,
            Dimension::Torque,
            Dimension::Rigidity,
            Dimension::Speed,
            Dimension::Acceleration,
            Dimension::Time,
            Dimension::Inertia,
        ] {
            assert!(!dimension.foreign().is_empty(), "{dimension:?}");
            for (name, _) in dimension.foreign() {
                assert!(dimension.read(&format!("1 {name}")).is_none(), "{name}");
            }
        }
    }
}
