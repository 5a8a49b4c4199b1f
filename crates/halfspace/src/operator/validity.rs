//! Where the theory behind an operator ends.

/// Where the theory behind an operator ends. The default has no bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Validity {
    /// Whether pressure on the outermost cells has a meaning. It has none where the body is held
    /// along the border of the grid.
    pub contact_at_border: bool,
    /// The greatest normal displacement for which displacements are proportional to loads.
    pub displacement: f64,
}

impl Default for Validity {
    fn default() -> Self {
        Self { contact_at_border: true, displacement: f64::INFINITY }
    }
}
