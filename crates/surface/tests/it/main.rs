//! The integration tests of `carom-surface`: one executable with a module for each subject.

mod files;
mod kinds;
mod measured;
mod oblong;
mod prepared;
mod texts;
mod wrong;
