//! Tables of reference values in `verification/data`, for tests of every floor.

/// The rows of a table of so many columns.
pub(crate) fn rows<const N: usize>(file: &str) -> Vec<[f64; N]> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../verification/data/");
    let text = std::fs::read_to_string([folder, file].concat()).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let numbers =
        |line: &str| -> Vec<f64> { line.split(',').map(|n| n.parse().unwrap()).collect() };
    lines.map(|line| numbers(line).try_into().unwrap()).collect()
}
