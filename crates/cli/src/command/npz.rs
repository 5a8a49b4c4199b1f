//! Arrays in a file as NumPy writes them: `.npz`, a ZIP archive without compression of `.npy`.

use std::collections::BTreeMap;

/// Numbers with their shape, the last index running fastest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Array {
    /// `<f8`.
    Numbers(Vec<usize>, Vec<f64>),
    /// `|u1`.
    Bytes(Vec<usize>, Vec<u8>),
}

/// The archive of these arrays.
pub(crate) fn encode(arrays: &BTreeMap<String, Array>) -> Vec<u8> {
    let (mut archive, mut directory) = (Vec::new(), Vec::new());
    for (name, array) in arrays {
        let (name, data) = (format!("{name}.npy"), npy(array));
        let place = archive.len() as u32;
        let common = header(&name, &data);
        archive.extend(b"PK\x03\x04");
        archive.extend(&common);
        archive.extend(name.as_bytes());
        archive.extend(&data);
        directory.extend(b"PK\x01\x02\x14\x00");
        directory.extend(&common);
        directory.extend([0; 10]); // no comment, first disk, no attributes
        directory.extend(place.to_le_bytes());
        directory.extend(name.as_bytes());
    }
    let (count, start) = (arrays.len() as u16, archive.len() as u32);
    archive.extend(&directory);
    archive.extend(b"PK\x05\x06\x00\x00\x00\x00");
    archive.extend([count.to_le_bytes(), count.to_le_bytes()].concat());
    archive.extend((directory.len() as u32).to_le_bytes());
    archive.extend(start.to_le_bytes());
    archive.extend([0; 2]);
    archive
}

/// What a local header and the directory say alike: version 2.0, stored, dated 1980.
fn header(name: &str, data: &[u8]) -> Vec<u8> {
    let size = (data.len() as u32).to_le_bytes();
    let mut header = vec![0x14, 0, 0, 0, 0, 0, 0, 0, 0x21, 0];
    header.extend(crc(data).to_le_bytes());
    header.extend(size);
    header.extend(size);
    header.extend((name.len() as u16).to_le_bytes());
    header.extend([0; 2]);
    header
}

fn npy(array: &Array) -> Vec<u8> {
    let (kind, shape) = match array {
        Array::Numbers(shape, _) => ("<f8", shape),
        Array::Bytes(shape, _) => ("|u1", shape),
    };
    let shape: String = shape.iter().map(|count| format!("{count}, ")).collect();
    let mut head =
        format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({}), }}", shape.trim_end());
    head.push_str(&" ".repeat(63 - (10 + head.len()) % 64));
    head.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((head.len() as u16).to_le_bytes());
    bytes.extend(head.as_bytes());
    match array {
        Array::Numbers(_, values) => bytes.extend(values.iter().flat_map(|v| v.to_le_bytes())),
        Array::Bytes(_, values) => bytes.extend(values),
    }
    bytes
}

/// The arrays of an archive that [`encode`] wrote; none if it is no such archive or damaged.
pub(crate) fn decode(mut archive: &[u8]) -> Option<BTreeMap<String, Array>> {
    let mut arrays = BTreeMap::new();
    while let Some(rest) = archive.strip_prefix(b"PK\x03\x04") {
        let word = |at: usize| Some(u32::from_le_bytes(rest.get(at..at + 4)?.try_into().ok()?));
        let (sum, size) = (word(10)?, word(14)? as usize);
        let length = u16::from_le_bytes(rest.get(22..24)?.try_into().ok()?) as usize;
        let name = std::str::from_utf8(rest.get(26..26 + length)?).ok()?;
        let data = rest.get(26 + length..26 + length + size)?;
        if crc(data) != sum {
            return None;
        }
        arrays.insert(name.strip_suffix(".npy")?.to_owned(), read_npy(data)?);
        archive = &rest[26 + length + size..];
    }
    archive.starts_with(b"PK\x01\x02").then_some(arrays)
}

fn read_npy(data: &[u8]) -> Option<Array> {
    let rest = data.strip_prefix(b"\x93NUMPY\x01\x00")?;
    let length = u16::from_le_bytes(rest.get(..2)?.try_into().ok()?) as usize;
    let head = std::str::from_utf8(rest.get(2..2 + length)?).ok()?;
    let values = rest.get(2 + length..)?;
    let shape = head.split_once("'shape': (")?.1.split_once(')')?.0;
    let counts = shape.split(',').map(str::trim).filter(|count| !count.is_empty());
    let shape: Vec<usize> = counts.map(|count| count.parse().ok()).collect::<Option<_>>()?;
    let count = shape.iter().try_fold(1_usize, |all, count| all.checked_mul(*count))?;
    if head.contains("'|u1'") {
        return (values.len() == count).then(|| Array::Bytes(shape, values.to_vec()));
    }
    let numbers =
        values.chunks_exact(8).map(|bytes| Some(f64::from_le_bytes(bytes.try_into().ok()?)));
    let numbers = numbers.collect::<Option<Vec<f64>>>()?;
    (Some(values.len()) == count.checked_mul(8)).then_some(Array::Numbers(shape, numbers))
}

/// The checksum of ZIP.
fn crc(bytes: &[u8]) -> u32 {
    let table: [u32; 256] = std::array::from_fn(|i| {
        (0..8)
            .fold(i as u32, |value, _| (value >> 1) ^ if value & 1 == 1 { 0xedb8_8320 } else { 0 })
    });
    !bytes
        .iter()
        .fold(!0, |sum, byte| table[((sum ^ u32::from(*byte)) & 0xff) as usize] ^ (sum >> 8))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arrays() -> BTreeMap<String, Array> {
        let numbers = vec![1.5, -0.0, f64::MIN_POSITIVE / 3.0, f64::INFINITY, 1e300, 1.0 / 3.0];
        BTreeMap::from([
            ("pressure".to_owned(), Array::Numbers(vec![2, 3], numbers)),
            ("cells".to_owned(), Array::Bytes(vec![4], vec![0, 1, 2, 255])),
            ("none".to_owned(), Array::Numbers(vec![0], Vec::new())),
        ])
    }

    #[test]
    fn what_is_written_is_read_bit_for_bit() {
        let archive = encode(&arrays());
        let read = decode(&archive).unwrap();
        for (name, array) in arrays() {
            assert_eq!(read[&name], array);
        }
        let Array::Numbers(_, values) = &read["pressure"] else { panic!("numbers") };
        assert!(values[1].is_sign_negative());
    }

    #[test]
    fn damage_is_seen() {
        let archive = encode(&arrays());
        for at in (0..archive.len() / 2).step_by(7) {
            let mut damaged = archive.clone();
            damaged[at] ^= 0x10;
            // A damaged name is no name of ours; what stands under one of ours is whole.
            let harmless = decode(&damaged).is_none_or(|read| {
                let is_whole =
                    |name: &str, array| read.get(name).is_none_or(|found| found == array);
                arrays().iter().all(|(name, array)| is_whole(name.as_str(), array))
            });
            assert!(harmless, "{at}");
            assert!(decode(&archive[..at]).is_none());
        }
    }

    #[test]
    fn the_checksum_is_that_of_zip() {
        assert_eq!(crc(b"123456789"), 0xcbf4_3926);
    }
}
