//! Tests of `carom-capi` through its public interface: one executable with a module for each subject.

mod header;
