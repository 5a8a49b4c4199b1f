//! Reference values from independent programs, kept as CSV under `data/`.

type Failure = Box<dyn std::error::Error + Send + Sync>;

/// The rows of a CSV with one line of heads, as numbers.
pub(crate) fn rows<const N: usize>(csv: &str) -> Result<Vec<[f64; N]>, Failure> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let parse = |record: csv::StringRecord| -> Result<[f64; N], Failure> {
        let mut row = [0.0; N];
        for (value, field) in row.iter_mut().zip(&record) {
            *value = field.parse()?;
        }
        Ok(row)
    };
    reader.records().map(|record| parse(record?)).collect()
}
