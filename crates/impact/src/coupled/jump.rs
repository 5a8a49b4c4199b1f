//! The place in a step at which the force jumps.

/// The least part of a step that is a step of its own, so that its path has a direction beyond
/// round-off.
pub(super) const LEAST_PART: f64 = 1.0 / (1_u64 << BISECTIONS) as f64;
const BISECTIONS: u32 = 40;

/// The lengths of a step that ends before a jump of the force, and of one that ends after it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jump {
    pub(super) before: f64,
    pub(super) after: f64,
}

impl Jump {
    /// Bisects a step of this length, within which the force jumps.
    pub(super) fn find(length: f64, jumps: impl Fn(f64) -> bool) -> Self {
        let mut jump = Self { before: 0.0, after: length };
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (jump.before + jump.after);
            let end = if jumps(middle) { &mut jump.after } else { &mut jump.before };
            *end = middle;
        }
        jump
    }
}
