//! Round-off in a row to read: what symmetry makes zero is computed as some 1e-17 of the other
//! components, and is printed as zero. Comma-separated values and JSON keep it.

use carom_table::{Cell, Quantity as _, Value};

/// Parts of the largest component below which a component is round-off.
const SMALLEST_PART: f64 = 1e-11;

/// The vector, with zero for components that are round-off beside the largest.
#[must_use]
pub(crate) fn without_round_off(value: [f64; 3]) -> [f64; 3] {
    let largest = value.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
    value.map(|part| if part.abs() < SMALLEST_PART * largest { 0.0 } else { part })
}

/// Sets components to zero that are round-off beside the others of their vector in this row:
/// columns whose names differ in a last x, y or z, the two shifts xi and eta, and the torque M_z beside
/// the force times the length of the contact.
pub(crate) fn clear_round_off(row: &mut [Cell]) {
    let cleared: Vec<(usize, Value)> =
        (0..row.len()).filter_map(|place| Some((place, cleared(row, place)?))).collect();
    for (place, value) in cleared {
        row[place].set_value(value);
    }
}

/// The value that replaces that of a cell; `None` to keep it.
fn cleared(row: &[Cell], place: usize) -> Option<Value> {
    let cell = &row[place];
    match cell.value() {
        Value::Vector(parts) => Some(Value::Vector(without_round_off(*parts))),
        Value::Number(value) if value.abs() < SMALLEST_PART * scale(row, cell) => {
            Some(Value::Number(0.0))
        }
        _ => None,
    }
}

/// The size to which a number in this cell is compared; zero for none.
fn scale(row: &[Cell], cell: &Cell) -> f64 {
    if cell.name() == "M_z" {
        return largest(row, |other| stem(other) == "F")
            * largest(row, |other| other == "contact_area").sqrt();
    }
    let is_part = matches!(cell.name(), "xi" | "eta") || stem(cell.name()) != cell.name();
    let same = |other: &str| stem(other) == stem(cell.name());
    if is_part { largest(row, same) } else { 0.0 }
}

/// The name without a last x, y or z; one name for both shifts.
fn stem(name: &str) -> &str {
    match name {
        "xi" | "eta" => "shift",
        _ => ["_x", "_y", "_z"].iter().find_map(|axis| name.strip_suffix(axis)).unwrap_or(name),
    }
}

/// The largest size among the numbers with such names.
fn largest(row: &[Cell], is_such: impl Fn(&str) -> bool) -> f64 {
    let size = |cell: &Cell| match cell.value() {
        Value::Number(value) => value.abs(),
        _ => 0.0,
    };
    row.iter().filter(|cell| is_such(cell.name())).map(size).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(cells: &[(&'static str, f64)]) -> Vec<f64> {
        let mut row: Vec<Cell> =
            cells.iter().map(|&(name, value)| Cell::new(name, "", "", value)).collect();
        clear_round_off(&mut row);
        let number = |cell: &Cell| match cell.value() {
            Value::Number(value) => *value,
            _ => f64::NAN,
        };
        row.iter().map(number).collect()
    }

    #[test]
    fn a_vector_and_its_mirror_image_lose_the_same_parts() {
        for sign in [1.0, -1.0] {
            let vector = [sign * -2.0, sign * 1e-17, 3e-11];
            assert_eq!(without_round_off(vector), [sign * -2.0, 0.0, 3e-11]);
        }
    }

    #[test]
    fn a_component_is_compared_with_those_of_its_own_vector() {
        let cells =
            [("F_x", 1e-9), ("F_y", -1e-11), ("F_z", 15.0), ("spin_y", 1e-13), ("R_x", 1e-14)];
        assert_eq!(read(&cells), [1e-9, 0.0, 15.0, 1e-13, 1e-14]);
        assert_eq!(read(&[("xi", 1e-7), ("eta", 1e-20), ("zeta", 1e-21)]), [1e-7, 0.0, 1e-21]);
    }

    #[test]
    fn a_torque_is_compared_with_the_force_times_the_length_of_the_contact() {
        let cells = |torque| [("F_z", 15.0), ("M_z", torque), ("contact_area", 1e-8)];
        assert_eq!(read(&cells(1e-14))[1], 0.0);
        assert_eq!(read(&cells(1e-13))[1], 1e-13);
        assert_eq!(read(&[("F_z", 15.0), ("M_z", 1e-20)])[1], 1e-20);
    }
}
