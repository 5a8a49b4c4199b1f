//! The tests of `carom-numerical` that see it as its users do: one executable, a module for each subject.

mod estimate;
mod impacts;
mod law;
mod numerical_law;
mod ring_histories;
mod rings;
mod systems_of_units;
#[path = "../../../impact/tests/it/units.rs"]
mod units;
