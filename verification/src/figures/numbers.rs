//! Reference values from comma-separated text.

/// The rows below the line of names.
///
/// # Errors
/// If a value is not a number.
pub(super) fn rows(text: &str) -> Result<Vec<Vec<f64>>, Box<dyn std::error::Error + Send + Sync>> {
    let mut reader = crate::reference::reader(text);
    let mut rows = Vec::new();
    for record in reader.records() {
        rows.push(record?.iter().map(str::parse).collect::<Result<_, _>>()?);
    }
    Ok(rows)
}
