//! The threads used by an operator.

/// The threads used for tables and products. The result is bit for bit the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Threads {
    /// On the calling thread.
    #[default]
    One,
    /// On all threads of the current rayon pool.
    Pool,
}

impl Threads {
    pub(crate) fn count(self) -> usize {
        match self {
            Self::One => 1,
            Self::Pool => rayon::current_num_threads(),
        }
    }
}
