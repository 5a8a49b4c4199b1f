//! Cases followed to their ends without the command, for front ends beside the shell: their results are
//! rows of the same columns that the command prints.

pub use super::history::{
    Step as HistoryStep, all_columns as history_columns, followed as history,
};
pub use super::impact::{Followed as Impacts, followed as impact};
pub use super::solve::{Solved, solved as solve};
