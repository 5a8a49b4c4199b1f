//! The integration tests of `carom-plot`: one executable with a module for each subject.

mod fields;
mod places;
