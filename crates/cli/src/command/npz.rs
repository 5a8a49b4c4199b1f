//! Arrays in NumPy's format `.npz`: an uncompressed ZIP archive of `.npy` files.
//!
//! The available libraries would add compressors in C.

use carom_surface::{Npy, npy};
use std::collections::BTreeMap;
use std::io::{self, Cursor, Read as _, Write as _};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipArchive, ZipWriter};

/// An array with its shape; the last index varies fastest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Array {
    /// `<f8`.
    Numbers(Vec<usize>, Vec<f64>),
    /// `|u1`.
    Bytes(Vec<usize>, Vec<u8>),
}

impl Array {
    /// Its shape and values as bytes.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let (shape, values) = match self {
            Self::Numbers(shape, values) => {
                (shape, values.iter().flat_map(|value| value.to_le_bytes()).collect())
            }
            Self::Bytes(shape, values) => (shape, values.clone()),
        };
        let counts = shape.iter().flat_map(|count| (*count as u64).to_le_bytes());
        counts.chain(values).collect()
    }
}

/// Encodes the arrays as an archive.
///
/// # Errors
/// The error of the archive, for example for a name that is too long.
pub(crate) fn encode(arrays: &BTreeMap<String, Array>) -> io::Result<Vec<u8>> {
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, array) in arrays {
        let data = file(array);
        // 64-bit sizes if 32 bits are too few.
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(DateTime::DEFAULT)
            .large_file(u32::try_from(data.len()).is_err());
        archive.start_file(format!("{name}.npy"), options)?;
        archive.write_all(&data)?;
    }
    Ok(archive.finish()?.into_inner())
}

fn file(array: &Array) -> Vec<u8> {
    match array {
        Array::Numbers(shape, values) => {
            npy("<f8", shape, values.iter().flat_map(|value| value.to_le_bytes()))
        }
        Array::Bytes(shape, values) => npy("|u1", shape, values.iter().copied()),
    }
}

/// Reads an archive that [`encode`] wrote; `None` if it is damaged or another file.
pub(crate) fn decode(archive: &[u8]) -> Option<BTreeMap<String, Array>> {
    let mut archive = ZipArchive::new(Cursor::new(archive)).ok()?;
    let mut arrays = BTreeMap::new();
    for i in 0..archive.len() {
        let mut file = archive.by_index(i).ok()?;
        let name = file.name().ok()?.strip_suffix(".npy")?.to_owned();
        let mut data = Vec::new();
        file.read_to_end(&mut data).ok()?;
        arrays.insert(name, array(&data)?);
    }
    Some(arrays)
}

fn array(file: &[u8]) -> Option<Array> {
    let Npy { kind, shape, by_columns: false, values } = Npy::of(file)? else { return None };
    let count = shape.iter().try_fold(1_usize, |all, count| all.checked_mul(*count))?;
    match kind? {
        "|u1" if values.len() == count => Some(Array::Bytes(shape, values.to_vec())),
        "<f8" if Some(values.len()) == count.checked_mul(8) => {
            let numbers = values.as_chunks().0.iter().map(|bytes| f64::from_le_bytes(*bytes));
            Some(Array::Numbers(shape, numbers.collect()))
        }
        _ => None,
    }
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
        let archive = encode(&arrays()).unwrap();
        let read = decode(&archive).unwrap();
        for (name, array) in arrays() {
            assert_eq!(read[&name], array);
        }
        let Array::Numbers(_, values) = &read["pressure"] else { panic!("numbers") };
        assert!(values[1].is_sign_negative());
    }

    #[test]
    fn damage_is_seen() {
        let archive = encode(&arrays()).unwrap();
        for at in (0..archive.len() / 2).step_by(7) {
            let mut damaged = archive.clone();
            damaged[at] ^= 0x10;
            // A damaged name is no name of these arrays; arrays under known names are intact.
            let harmless = decode(&damaged).is_none_or(|read| {
                let is_whole =
                    |name: &str, array| read.get(name).is_none_or(|found| found == array);
                arrays().iter().all(|(name, array)| is_whole(name.as_str(), array))
            });
            assert!(harmless, "{at}");
            assert!(decode(&archive[..at]).is_none());
        }
    }
}
