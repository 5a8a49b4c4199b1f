//! Rows of numbers from a NumPy file, `.npy`.

/// Reads one number of a given type.
type Read = fn(&[u8], bool) -> f64;

macro_rules! number {
    ($kind:ty) => {
        |bytes, little| {
            let mut own = [0; size_of::<$kind>()];
            own.copy_from_slice(bytes);
            let value =
                if little { <$kind>::from_le_bytes(own) } else { <$kind>::from_be_bytes(own) };
            value as f64
        }
    };
}

/// The rows of an array with two axes, of floating-point or whole numbers, in either byte order and either
/// order of the axes. `check` receives the numbers of columns and rows in the header before anything is
/// allocated for them.
///
/// # Errors
/// A description of what is wrong; the error of `check`.
pub(super) fn rows(
    bytes: &[u8],
    check: impl Fn([usize; 2]) -> Result<(), String>,
) -> Result<Vec<Vec<f64>>, String> {
    let broken = || "this is not a .npy file, or it is damaged".to_owned();
    let (head, values) = parts(bytes).ok_or_else(broken)?;
    let descr = quoted(head, "descr").ok_or("this array has fields: must be plain numbers")?;
    let (order, kind) = descr.split_at_checked(1).ok_or_else(broken)?;
    let (size, read): (usize, Read) = match kind {
        "f8" => (8, number!(f64)),
        "f4" => (4, number!(f32)),
        "i8" => (8, number!(i64)),
        "u8" => (8, number!(u64)),
        "i4" => (4, number!(i32)),
        "u4" => (4, number!(u32)),
        "i2" => (2, number!(i16)),
        "u2" => (2, number!(u16)),
        "i1" => (1, number!(i8)),
        "u1" => (1, number!(u8)),
        other => {
            return Err(format!(
                "this array has numbers of kind {other}: must be f4, f8 or integers"
            ));
        }
    };
    let shape = head.split_once("'shape': (").and_then(|(_, rest)| rest.split_once(')'));
    let counts = shape.ok_or_else(broken)?.0.split(',').map(str::trim).filter(|n| !n.is_empty());
    let shape: Vec<usize> =
        counts.map(|n| n.parse().ok()).collect::<Option<_>>().ok_or_else(broken)?;
    let [rows, columns] = shape[..] else {
        return Err(format!("this array has {} axes: must have two", shape.len()));
    };
    check([columns, rows])?;
    let wanted = rows.checked_mul(columns).and_then(|count| count.checked_mul(size));
    if wanted != Some(values.len()) {
        return Err(broken());
    }
    let is_little = order != ">";
    let by_columns = head.contains("'fortran_order': True");
    let at = |row: usize, column: usize| {
        let place = if by_columns { row + rows * column } else { column + columns * row };
        read(&values[size * place..size * (place + 1)], is_little)
    };
    Ok((0..rows).map(|row| (0..columns).map(|column| at(row, column)).collect()).collect())
}

/// The header, and the data after it.
fn parts(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let rest = bytes.strip_prefix(b"\x93NUMPY")?;
    let (length, start) = match rest.first()? {
        1 => (usize::from(u16::from_le_bytes(rest.get(2..4)?.try_into().ok()?)), 4),
        2 | 3 => (u32::from_le_bytes(rest.get(2..6)?.try_into().ok()?) as usize, 6),
        _ => return None,
    };
    let head = std::str::from_utf8(rest.get(start..start + length)?).ok()?;
    Some((head, rest.get(start + length..)?))
}

fn quoted<'a>(head: &'a str, name: &str) -> Option<&'a str> {
    let rest = head.split_once(&format!("'{name}': '"))?.1;
    rest.split_once('\'').map(|(value, _)| value)
}

#[cfg(test)]
mod tests {

    fn file(descr: &str, order: &str, shape: &str, values: &[u8]) -> Vec<u8> {
        let head =
            format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}\n");
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((head.len() as u16).to_le_bytes());
        bytes.extend(head.as_bytes());
        bytes.extend(values);
        bytes
    }

    fn rows(bytes: &[u8]) -> Result<Vec<Vec<f64>>, String> {
        super::rows(bytes, |_| Ok(()))
    }

    #[test]
    fn numbers_of_all_kinds_and_orders_are_read() {
        let want = vec![vec![1.0, 2.0, 3.0], vec![4.0, 5.0, 6.0]];
        let by_rows = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0_f64];
        let by_columns = [1.0, 4.0, 2.0, 5.0, 3.0, 6.0_f64];
        let bytes = |of: &dyn Fn(f64) -> Vec<u8>, values: [f64; 6]| -> Vec<u8> {
            values.into_iter().flat_map(of).collect()
        };
        let f8 = bytes(&|v| v.to_le_bytes().to_vec(), by_rows);
        assert_eq!(rows(&file("<f8", "False", "(2, 3)", &f8)).unwrap(), want);
        let f8 = bytes(&|v| v.to_be_bytes().to_vec(), by_columns);
        assert_eq!(rows(&file(">f8", "True", "(2, 3)", &f8)).unwrap(), want);
        let f4 = bytes(&|v| (v as f32).to_le_bytes().to_vec(), by_rows);
        assert_eq!(rows(&file("<f4", "False", "(2, 3)", &f4)).unwrap(), want);
        let u2 = bytes(&|v| (v as u16).to_be_bytes().to_vec(), by_rows);
        assert_eq!(rows(&file(">u2", "False", "(2, 3)", &u2)).unwrap(), want);
        let u1 = bytes(&|v| vec![v as u8], by_rows);
        assert_eq!(rows(&file("|u1", "False", "(2, 3)", &u1)).unwrap(), want);
    }

    #[test]
    fn what_is_no_map_is_refused() {
        let ones = [1_u8; 6];
        for (bytes, part) in [
            (b"PK\x03\x04".to_vec(), "not a .npy file"),
            (file("|u1", "False", "(6,)", &ones), "1 axes"),
            (file("|u1", "False", "(2, 4)", &ones), "damaged"),
            (file("<c8", "False", "(2, 3)", &ones), "kind c8"),
            (file("<U3", "False", "(2, 3)", &ones), "kind U3"),
            (file("|u1", "False", "(18446744073709551615, 3)", &ones), "damaged"),
        ] {
            let said = rows(&bytes).unwrap_err();
            assert!(said.contains(part), "{said}");
        }
        let whole = file("|u1", "False", "(2, 3)", &ones);
        for end in 0..whole.len() {
            assert!(rows(&whole[..end]).is_err(), "{end}");
        }
    }
}
