//! Every unit of case files, compared with its base unit.

use carom_cases::case::Dimension;
use std::f64::consts::PI;

/// The units of each dimension, the plain one first, and how much of the plain one each is.
const UNITS: [(Dimension, &[(&str, f64)]); 17] = [
    (Dimension::None, &[]),
    (
        Dimension::Length,
        &[("m", 1.0), ("km", 1e3), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9)],
    ),
    (Dimension::Mass, &[("kg", 1.0), ("t", 1e3), ("g", 1e-3), ("mg", 1e-6), ("ug", 1e-9)]),
    (
        Dimension::Density,
        &[("kg/m3", 1.0), ("g/cm3", 1e3), ("kg/dm3", 1e3), ("t/m3", 1e3), ("g/m3", 1e-3)],
    ),
    (
        Dimension::Pressure,
        &[
            ("Pa", 1.0),
            ("kPa", 1e3),
            ("MPa", 1e6),
            ("GPa", 1e9),
            ("TPa", 1e12),
            ("bar", 1e5),
            ("N/m2", 1.0),
            ("N/mm2", 1e6),
            ("kN/mm2", 1e9),
        ],
    ),
    (
        Dimension::Force,
        &[("N", 1.0), ("kN", 1e3), ("MN", 1e6), ("mN", 1e-3), ("uN", 1e-6), ("nN", 1e-9)],
    ),
    (Dimension::Torque, &[("N m", 1.0), ("kN m", 1e3), ("N mm", 1e-3), ("mN m", 1e-3)]),
    (Dimension::Rigidity, &[("N m2", 1.0), ("kN m2", 1e3), ("MN m2", 1e6), ("N mm2", 1e-6)]),
    (Dimension::PerSpeed, &[("s/m", 1.0), ("ms/m", 1e-3), ("s/mm", 1e3)]),
    (
        Dimension::Speed,
        &[
            ("m/s", 1.0),
            ("km/s", 1e3),
            ("cm/s", 1e-2),
            ("mm/s", 1e-3),
            ("um/s", 1e-6),
            ("km/h", 1e3 / 3600.0),
        ],
    ),
    (
        Dimension::Spin,
        &[
            ("rad/s", 1.0),
            ("deg/s", PI / 180.0),
            ("rpm", 2.0 * PI / 60.0),
            ("1/min", 2.0 * PI / 60.0),
            ("rev/s", 2.0 * PI),
        ],
    ),
    (Dimension::Acceleration, &[("m/s2", 1.0), ("cm/s2", 1e-2), ("mm/s2", 1e-3)]),
    (Dimension::Time, &[("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9), ("min", 60.0)]),
    (
        Dimension::Inertia,
        &[("kg m2", 1.0), ("kg cm2", 1e-4), ("kg mm2", 1e-6), ("g cm2", 1e-7), ("g mm2", 1e-9)],
    ),
    (Dimension::Degrees, &[("deg", 1.0), ("rad", 180.0 / PI), ("rev", 360.0)]),
    (Dimension::Radians, &[("rad", 1.0), ("mrad", 1e-3), ("deg", PI / 180.0), ("rev", 2.0 * PI)]),
    (
        Dimension::PerLength,
        &[("rad/m", 1.0), ("1/m", 1.0), ("rad/mm", 1e3), ("1/mm", 1e3), ("deg/m", PI / 180.0)],
    ),
];

#[test]
fn each_unit_stands_for_what_it_says() {
    for (dimension, units) in UNITS {
        let plain = units.first().map_or("", |(name, _)| name);
        assert_eq!(dimension.unit(), plain);
        for (name, factor) in units {
            let read = dimension.read(&format!("-2.5e1 {name}"));
            let read = read.unwrap_or_else(|| panic!("{dimension:?} has no {name}"));
            let expected = -25.0 * factor;
            assert!((read - expected).abs() <= 4e-16 * expected.abs(), "{name}: {read} {expected}");
        }
        // The list is whole: what is allowed names no other unit.
        let allowed = dimension.allowed(carom_cases::case::Range::Finite);
        let named =
            allowed.split_once("with a unit of ").map_or(0, |(_, units)| units.split(", ").count());
        assert_eq!(named, units.len(), "{allowed}");
    }
}

#[test]
fn a_unit_of_another_dimension_is_none() {
    for (dimension, _) in UNITS {
        for (other, units) in UNITS {
            let angles = [Dimension::Degrees, Dimension::Radians];
            let both_angles = angles.contains(&dimension) && angles.contains(&other);
            if dimension != other && !both_angles {
                for (name, _) in units {
                    assert_eq!(dimension.read(&format!("1 {name}")), None, "{dimension:?} {name}");
                }
            }
        }
    }
}
