//! Errors of an operator and its fields.

use carom_special::RangeError;

/// Why an operator could not be built, or a product not be computed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OperatorError {
    /// A length, modulus or count out of range.
    #[error(transparent)]
    Range(#[from] RangeError),
    /// The operator would not fit into memory; nothing was allocated.
    #[error("the grid needs {needed} bytes, {available} are available")]
    TooLarge {
        /// Bytes that the operator and one workspace need.
        needed: u128,
        /// Bytes that may be used.
        available: u128,
    },
    /// The number of values of a field differs from the number of cells.
    #[error("{field} has {found} values, the grid has {expected} cells")]
    Length {
        /// The field.
        field: &'static str,
        /// Number of values in the field.
        found: usize,
        /// Number of cells.
        expected: usize,
    },
    /// A traction is infinite or not a number.
    #[error("{field} is {value} in cell {index}: must be finite")]
    NotFinite {
        /// The field.
        field: &'static str,
        /// Index of the first such cell.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// The operator was built without a block that the product needs.
    #[error("the operator was built without the influence of {by} on {of}")]
    Missing {
        /// The displacement that was requested.
        of: &'static str,
        /// The traction that was given.
        by: &'static str,
    },
    /// A method needs influences that depend on the offset of two cells alone.
    #[error(
        "the influence of a cell depends on its place, as on a plate: this method needs an operator that is \
         translation-invariant"
    )]
    NotInvariant,
    /// A line of a table of coefficients cannot be read.
    #[error("line {line} of the table: {reason}")]
    Table {
        /// Line number, from 1.
        line: usize,
        /// What is wrong with it.
        reason: String,
    },
    /// A table of coefficients has no entry for an offset that the grid needs.
    #[error("the table has no entry for {columns} columns and {rows} rows")]
    Absent {
        /// Columns from receiver to source.
        columns: i32,
        /// Rows from receiver to source.
        rows: i32,
    },
    /// A kernel returned a coefficient that is not finite.
    #[error("the kernel is not finite at {columns} columns and {rows} rows")]
    Kernel {
        /// Columns from receiver to source.
        columns: i32,
        /// Rows from receiver to source.
        rows: i32,
    },
    /// A block of a table of coefficients has the wrong name, size or values.
    #[error("block \"{name}\": {reason}")]
    Block {
        /// Its name.
        name: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A table of offsets >= 0 has a coefficient that contradicts its own mirror image.
    #[error(
        "{of} is {value} at {columns} columns and {rows} rows: must be 0, since it is odd there in a table of \
         offsets >= 0, which is for bodies symmetric about both axes"
    )]
    Odd {
        /// The coefficient.
        of: &'static str,
        /// Its value.
        value: f64,
        /// Columns from receiver to source.
        columns: i32,
        /// Rows from receiver to source.
        rows: i32,
    },
    /// A table of coefficients contradicts Betti's theorem.
    #[error(
        "{of} is {value:.6e} at {columns} columns and {rows} rows, and {by} is {converse:.6e} at the opposite offset: \
         must be equal, since the displacement of one cell by another equals the converse (Betti)"
    )]
    NotReciprocal {
        /// The coefficient: displacement, then traction.
        of: &'static str,
        /// Its value.
        value: f64,
        /// The coefficient with displacement and traction exchanged.
        by: &'static str,
        /// Its value at the opposite offset.
        converse: f64,
        /// Columns from receiver to source.
        columns: i32,
        /// Rows from receiver to source.
        rows: i32,
    },
    /// A cell is not displaced along its own traction.
    #[error("{of} of a cell under its own traction is {value}: must be > 0")]
    Zero {
        /// The displacement.
        of: &'static str,
        /// Its value.
        value: f64,
    },
    /// Tractions exist that do negative work on the displacements that they cause.
    #[error(
        "the influence matrix of the {cells} cells is not positive definite: tractions do {work:.3e} of the work \
         that they do on a half-space, must be > 0"
    )]
    Indefinite {
        /// Work of such tractions over that on a half-space with the same displacements of a loaded cell.
        work: f64,
        /// Number of cells.
        cells: usize,
    },
}
